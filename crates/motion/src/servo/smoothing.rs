//! Acceleration after interpolation: each axis reaches a new speed by itself, whatever the path (GSK990MC 7.5,
//! bits 16#0, 16#2, 17#0, 17#2, 17#3).
//!
//! **Linear**, time constant `T`: the mean of the last `T` (see [`super::average`]). A change of speed takes `T`
//! at constant acceleration, whatever the change. **Exponential**: a delay of first order, in each period
//!
//! ```text
//! lag ← (lag + d)·exp(−period/T)
//! ```
//!
//! Once the command of its axes has ended, those of a path together, what is left of them is run no slower than the speed FL
//! (P129), so that it ends; as long as one of them is commanded on, a slow or a turning axis is none that ends. Both end on
//! the commanded point exactly: what is put out is the commanded position less a lag that becomes 0.
//!
//! What it does to the path, at the speed `v`, with the linear or the exponential time constant `T`:
//!
//! ```text
//!                               linear                     exponential
//! behind the command            v·T/2                      v·T
//! circle of radius r, inwards   r·(1 − sin u/u), u = vT/2r r·(1 − 1/√(1 + (vT/r)²))
//!                               ≈ v²T²/24r                 ≈ v²T²/2r
//! corner of 90° without stop    √2·v·T/8 = 0.18·v·T        0.51·v·T
//! ```
//!
//! A straight line stays straight where its axes have the same constant, as those of cutting have: what is left at FL is
//! left along it.
//!
//! Movements of positioning, cutting and moving by hand run through filters of their own, and the lags are
//! added up: what is left of one is run out while the next begins, without a jump. Who wants the one finished
//! before the other waits for rest.

use super::Kind;
use super::average::Average;
use ferrocut_machine::Smoothing;

/// Movement in one period below which what is left of an exponential lag is run out at once, mm (degrees).
const LEAST_STEP: f64 = 1e-6;

/// Movements of each axis by itself.
const BY_HAND: [usize; 2] = [Kind::Jog as usize, Kind::Wheel as usize];

/// The filters of one axis.
#[derive(Clone, Debug)]
pub(crate) struct Smoother {
    filters: [Filter; Kind::COUNT],
}

#[derive(Clone, Debug)]
enum Filter {
    Off,
    Linear(Average),
    Exponential {
        lag: f64,
        /// Part of the lag that a period leaves.
        keep: f64,
        /// Least movement in a period once the command has ended, mm.
        least: f64,
    },
}

/// The share of the lags that is run in this period at least, one a kind of movement: of axes whose command has ended.
pub(crate) type Ending = [f64; Kind::COUNT];

/// What is left of all axes, and how far they go in a period at least.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Left {
    squares: [f64; Kind::COUNT],
    least: [f64; Kind::COUNT],
    moves: bool,
}

impl Left {
    pub const NONE: Left =
        Left { squares: [0.0; Kind::COUNT], least: [f64::INFINITY; Kind::COUNT], moves: false };

    /// With an axis whose command moves by `d`.
    #[inline]
    pub fn add(&mut self, smoother: &Smoother, d: f64) {
        self.moves |= d != 0.0;
        for (i, filter) in smoother.filters.iter().enumerate() {
            if let Filter::Exponential { lag, least, .. } = filter
                && *lag != 0.0
            {
                self.squares[i] += lag * lag;
                self.least[i] = self.least[i].min(*least);
            }
        }
    }

    /// What comes of it where the axes move as `kind`.
    #[inline]
    pub fn ending(&self, kind: Kind) -> Ending {
        std::array::from_fn(|i| {
            let has_ended = self.squares[i] > 0.0 && !(self.moves && i == kind as usize);
            if has_ended { self.least[i] / self.squares[i].sqrt() } else { 0.0 }
        })
    }
}

impl Smoother {
    /// The filters, one a kind of movement, of an axis with this highest acceleration; `period` in s.
    pub fn new(smoothing: [Smoothing; Kind::COUNT], acceleration: f64, period: f64) -> Smoother {
        Smoother { filters: smoothing.map(|s| Filter::new(s, acceleration, period)) }
    }

    /// Whether it changes anything.
    pub fn is_off(&self) -> bool {
        self.filters.iter().all(|f| matches!(f, Filter::Off))
    }

    /// Goes on by a period in which the command moves by `d`; how far the axis is behind at its end. `ending` is that of the
    /// axes of the path; moved by hand each axis ends by itself.
    #[inline]
    pub fn push(&mut self, d: f64, kind: Kind, ending: &Ending) -> f64 {
        let mut lag = 0.0;
        for (i, filter) in self.filters.iter_mut().enumerate() {
            let d = if i == kind as usize { d } else { 0.0 };
            let share = match filter {
                Filter::Exponential { lag, least, .. } if BY_HAND.contains(&i) => match d == 0.0 {
                    true => *least / lag.abs(),
                    false => 0.0,
                },
                _ => ending[i],
            };
            lag += filter.push(d, share);
        }
        lag
    }

    /// Whether the axis is where it is commanded to be, and stays.
    pub fn is_at_rest(&self) -> bool {
        self.filters.iter().all(|filter| match filter {
            Filter::Off => true,
            Filter::Linear(average) => average.is_at_rest(),
            Filter::Exponential { lag, .. } => *lag == 0.0,
        })
    }

    /// The axis is where it is commanded to be, from here on.
    pub fn rest(&mut self) {
        for filter in &mut self.filters {
            match filter {
                Filter::Off => {}
                Filter::Linear(average) => average.rest(),
                Filter::Exponential { lag, .. } => *lag = 0.0,
            }
        }
    }
}

impl Filter {
    fn new(smoothing: Smoothing, acceleration: f64, period: f64) -> Filter {
        let periods = smoothing.time_ms() / 1000.0 / period;
        match smoothing {
            Smoothing::Linear { .. } => Average::new(periods).map_or(Filter::Off, Filter::Linear),
            Smoothing::Exponential { least, .. } if periods > 0.0 => Filter::Exponential {
                lag: 0.0,
                keep: (-periods.recip()).exp(),
                // From this speed the axis stops within a period.
                least: (least / 60.0 * period).min(acceleration * period * period).max(LEAST_STEP),
            },
            _ => Filter::Off,
        }
    }

    /// At least this share of the lag is run.
    #[inline]
    fn push(&mut self, d: f64, share: f64) -> f64 {
        match self {
            Filter::Off => 0.0,
            Filter::Linear(average) => average.push(d),
            Filter::Exponential { lag, keep, .. } => {
                *lag = (*lag + d) * keep.min((1.0 - share).max(0.0));
                *lag
            }
        }
    }
}
