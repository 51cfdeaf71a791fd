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
//! and no slower than the speed FL while anything is left (P129), so that it ends. Both end on the commanded
//! point exactly: what is put out is the commanded position less a lag that becomes 0.
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
//! A straight line stays straight where its axes have the same constant, as those of cutting have.
//!
//! Movements of positioning, cutting and moving by hand run through filters of their own, and the lags are
//! added up: what is left of one is run out while the next begins, without a jump. Who wants the one finished
//! before the other waits for rest.

use super::Kind;
use super::average::Average;
use ferrocut_machine::Smoothing;

/// Movement in one period below which what is left of an exponential lag is run out at once, mm (degrees).
const LEAST_STEP: f64 = 1e-6;

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
        /// Least movement in a period while there is a lag, mm.
        least: f64,
    },
}

impl Smoother {
    /// The filters, one a kind of movement; `period` in s.
    pub fn new(smoothing: [Smoothing; Kind::COUNT], period: f64) -> Smoother {
        Smoother { filters: smoothing.map(|s| Filter::new(s, period)) }
    }

    /// Whether it changes anything.
    pub fn is_off(&self) -> bool {
        self.filters.iter().all(|f| matches!(f, Filter::Off))
    }

    /// Goes on by a period in which the command moves by `d`; how far the axis is behind at its end.
    #[inline]
    pub fn push(&mut self, d: f64, kind: Kind) -> f64 {
        let mut lag = 0.0;
        for (i, filter) in self.filters.iter_mut().enumerate() {
            lag += filter.push(if i == kind as usize { d } else { 0.0 });
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
    fn new(smoothing: Smoothing, period: f64) -> Filter {
        let periods = smoothing.time_ms() / 1000.0 / period;
        match smoothing {
            Smoothing::Linear { .. } => Average::new(periods).map_or(Filter::Off, Filter::Linear),
            Smoothing::Exponential { least, .. } if periods > 0.0 => Filter::Exponential {
                lag: 0.0,
                keep: (-periods.recip()).exp(),
                least: (least / 60.0 * period).max(LEAST_STEP),
            },
            _ => Filter::Off,
        }
    }

    #[inline]
    fn push(&mut self, d: f64) -> f64 {
        match self {
            Filter::Off => 0.0,
            Filter::Linear(average) => average.push(d),
            Filter::Exponential { lag, keep, least } => {
                let all = *lag + d;
                let left = all * *keep;
                let moved = all - left;
                *lag = if moved.abs() >= *least {
                    left
                } else if all.abs() <= *least {
                    0.0
                } else {
                    all - least.copysign(all)
                };
                *lag
            }
        }
    }
}
