//! One axis of the simulated machine: servo, screw with its encoder, switches.
//!
//! # The servo
//!
//! The position loop commands the speed `Kv·(c − x) + F·c'`, the speed loop follows it with the time constant `T`:
//!
//! ```text
//! x' = v        T·v' = Kv·(c − x) + F·c' − v
//! ```
//!
//! In a period the command goes straight from one setpoint to the next, `c' = u`. With the lag
//! `ε = (c − x) − (1 − F)·u/Kv` beside that of constant speed, and `w = u − v`, it is a linear system without input,
//!
//! ```text
//! ε' = w        w' = −(Kv·ε + w)/T
//! ```
//!
//! which is run exactly, by its matrix over a period. With `T = 0` it is `ε' = −Kv·ε`.

use ferrocut_machine::PlantAxis;

/// A matrix of two rows.
type Matrix = [[f64; 2]; 2];

/// An axis. Places are physical.
#[derive(Clone, Debug)]
pub(super) struct PlantedAxis {
    config: PlantAxis,
    /// What a period does to lag and speed.
    over_period: Matrix,
    period: f64,
    /// Where one of the markers is.
    marker: f64,
    home: [f64; 2],
    limits: [f64; 2],
    /// The physical place of what is called 0.
    offset: f64,
    command: f64,
    speed: f64,
    /// Where the axis is, and where it was a period ago.
    pub place: f64,
    pub before: f64,
    armed: bool,
    passed: Option<f64>,
    edge: Option<f64>,
    pub stuck: bool,
    pub no_marker: bool,
    pub home_stays: Option<bool>,
}

/// Where an axis is, and what is beside it.
pub(super) struct Where {
    /// Place of one of the markers.
    pub marker: f64,
    /// From and to where the home switch is reached.
    pub home: [f64; 2],
    /// Between them the travel switches are closed.
    pub limits: [f64; 2],
    /// Where the axis stands.
    pub at: f64,
    /// What this place is called.
    pub called: f64,
}

impl PlantedAxis {
    pub fn new(config: &PlantAxis, period: f64, place: &Where) -> PlantedAxis {
        PlantedAxis {
            over_period: over(config.gain, config.lag_ms / 1000.0, period),
            config: config.clone(),
            period,
            marker: place.marker,
            home: place.home,
            limits: place.limits,
            offset: place.at - place.called,
            command: place.at,
            speed: 0.0,
            place: place.at,
            before: place.at,
            armed: false,
            passed: None,
            edge: None,
            stuck: false,
            no_marker: false,
            home_stays: None,
        }
    }

    /// A period with the command on the way to `commanded`, by its name; where the encoder says that the axis is.
    #[inline]
    pub fn follow(&mut self, commanded: f64) -> f64 {
        let command = commanded + self.offset;
        let rate = (command - self.command) / self.period;
        let steady = (1.0 - self.config.feed_forward) * rate / self.config.gain;
        let lag = [self.command - self.place - steady, rate - self.speed];
        let [[a, b], [c, d]] = self.over_period;
        let (lag, behind) = (a * lag[0] + b * lag[1], c * lag[0] + d * lag[1]);
        self.command = command;
        self.before = self.place;
        if self.stuck {
            self.speed = 0.0;
        } else {
            self.place = command - steady - lag;
            self.speed = rate - behind;
        }
        self.feel();
        self.called(self.place)
    }

    /// Keeps the places of what was passed in this period.
    fn feel(&mut self) {
        let (from, to) = (self.before, self.place);
        if self.armed && !self.no_marker {
            let turn = |place: f64| ((place - self.marker) / self.config.pitch).floor();
            let (first, last) = (turn(from), turn(to));
            if first != last {
                let passed = if to > from { first + 1.0 } else { first };
                self.passed = Some(self.marker + passed * self.config.pitch);
                self.armed = false;
            }
        }
        if self.home_stays.is_none() {
            // The edge that was passed last.
            let passed = |edge: &f64| (from < *edge) != (to < *edge);
            let mut edges = self.home.into_iter().filter(passed);
            let edge = if to > from { edges.next_back() } else { edges.next() };
            self.edge = edge.or(self.edge);
        }
    }

    /// The place where the axis is commanded to be is called `at`.
    pub fn rename(&mut self, at: f64) {
        self.offset = self.command - at;
    }

    /// The axis stands where its name says.
    pub fn stand_as_called(&mut self) {
        self.command -= self.offset;
        (self.place, self.before, self.speed, self.offset) = (self.command, self.command, 0.0, 0.0);
    }

    /// The name of a place, as the encoder counts it.
    pub fn called(&self, place: f64) -> f64 {
        let step = self.config.resolution;
        let counted = if step > 0.0 { (place / step).round() * step } else { place };
        counted - self.offset
    }

    pub fn arm(&mut self) {
        (self.armed, self.passed) = (true, None);
    }

    pub fn passed(&self) -> Option<f64> {
        self.passed.map(|place| self.called(place))
    }

    pub fn edge(&self) -> Option<f64> {
        self.edge.map(|place| self.called(place))
    }

    /// Whether the axis is on its home switch.
    pub fn is_home(&self) -> bool {
        let [from, to] = self.home;
        self.home_stays.unwrap_or((from..to).contains(&self.place))
    }

    /// Whether it is beyond its lower travel switch, and its upper one.
    pub fn is_beyond(&self) -> [bool; 2] {
        [self.place < self.limits[0], self.place > self.limits[1]]
    }
}

/// The matrix of `ε' = w`, `w' = −(Kv·ε + w)/T` over a time: its series over a small part of it, squared until the
/// time is over. Sums and products alone, so that it is the same on every machine.
pub(super) fn over(gain: f64, lag: f64, time: f64) -> Matrix {
    // A speed loop as fast as this is ideal.
    if lag < time * 1e-3 {
        let [[kept, _], _] = power([[-gain, 0.0], [0.0, 0.0]], time);
        return [[kept, 0.0], [-gain * kept, 0.0]];
    }
    power([[0.0, 1.0], [-gain / lag, -1.0 / lag]], time)
}

/// Halvings of the time: with them a matrix of 10⁶/s and a period of 10 ms is below 0.01.
const HALVINGS: i32 = 20;
/// Terms of the series: what is left out is below 10⁻²⁰.
const TERMS: u8 = 10;

fn power(matrix: Matrix, time: f64) -> Matrix {
    let part = time / f64::from(1u32 << HALVINGS);
    let small = matrix.map(|row| row.map(|value| value * part));
    // From the last term inwards, without the one: added to it early, what is small would be lost.
    let mut sum = [[0.0; 2]; 2];
    for n in (1..=TERMS).rev() {
        sum = times(&small, &plus_one(&sum)).map(|row| row.map(|value| value / f64::from(n)));
    }
    for _ in 0..HALVINGS {
        // (1 + s)² − 1 = s·(2 + s)
        let square = times(&sum, &sum);
        sum = [0, 1].map(|i| [0, 1].map(|j| 2.0 * sum[i][j] + square[i][j]));
    }
    plus_one(&sum)
}

fn plus_one(matrix: &Matrix) -> Matrix {
    let [[a, b], [c, d]] = *matrix;
    [[1.0 + a, b], [c, 1.0 + d]]
}

fn times(left: &Matrix, right: &Matrix) -> Matrix {
    let [[a, b], [c, d]] = *left;
    let [[e, f], [g, h]] = *right;
    [[a * e + b * g, a * f + b * h], [c * e + d * g, c * f + d * h]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use ferrocut_geometry::Axis;

    const PLACE: Where =
        Where { marker: 0.0, home: [50.0, 60.0], limits: [-100.0, 100.0], at: 0.0, called: 0.0 };

    fn axis(change: impl Fn(&mut PlantAxis)) -> PlantedAxis {
        let mut config = PlantAxis { resolution: 0.0, ..PlantAxis::new(Axis::X) };
        change(&mut config);
        PlantedAxis::new(&config, 0.001, &PLACE)
    }

    #[test]
    fn the_lag_at_constant_speed_is_speed_by_gain() {
        // 100 mm/s at 50/s: 2 mm; of it 0.04 mm are left where 98 % of the speed is fed forward.
        for (feed_forward, lag_ms, lag) in
            [(0.0, 2.0, 2.0), (0.98, 2.0, 0.04), (0.98, 0.0, 0.04), (1.0, 5.0, 0.0)]
        {
            let mut axis = axis(|a| (a.feed_forward, a.lag_ms) = (feed_forward, lag_ms));
            let mut at = 0.0;
            for k in 1..=2000 {
                at = axis.follow(f64::from(k) * 0.1);
            }
            assert!((200.0 - at - lag).abs() < 1e-9, "{}", 200.0 - at);
            for _ in 0..2000 {
                at = axis.follow(200.0);
            }
            assert!((200.0 - at).abs() < 1e-9, "{at}");
        }
    }

    #[test]
    fn a_step_decays_as_the_closed_form_says() {
        // First order: e^(−50·0.1) of what is left of a step after its first period.
        let mut first = axis(|a| (a.feed_forward, a.lag_ms) = (0.0, 0.0));
        first.follow(1.0);
        let left = 1.0 - first.place;
        let at = (0..100).map(|_| first.follow(1.0)).last().unwrap();
        assert!(((1.0 - at) / left - (-5.0_f64).exp()).abs() < 1e-12);
        // Second order, released 1 mm away: Kv·T = 0.1, roots −r, −s of T·p² + p + Kv, (r·e^(−st) − s·e^(−rt))/(r − s).
        let (gain, lag) = (50.0, 0.002);
        let [[a, _], _] = over(gain, lag, 0.03);
        let root = (1.0_f64 - 4.0 * gain * lag).sqrt();
        let (r, s) = ((1.0 + root) / (2.0 * lag), (1.0 - root) / (2.0 * lag));
        let exact = (r * (-s * 0.03).exp() - s * (-r * 0.03).exp()) / (r - s);
        assert!((a - exact).abs() < 1e-13, "{a} {exact}");
    }

    #[test]
    fn markers_and_edges_are_kept_where_they_are() {
        let mut axis = axis(|_| {});
        let run = |axis: &mut PlantedAxis, from: f64, to: f64| {
            for k in 1..=1000 {
                axis.follow(from + (to - from) * f64::from(k) / 1000.0);
            }
            for _ in 0..500 {
                axis.follow(to);
            }
        };
        run(&mut axis, 0.0, 5.0);
        axis.arm();
        assert_eq!((axis.passed(), axis.edge(), axis.is_home()), (None, None, false));
        run(&mut axis, 5.0, 55.0);
        assert_eq!((axis.passed(), axis.edge(), axis.is_home()), (Some(10.0), Some(50.0), true));
        axis.rename(0.0);
        axis.arm();
        run(&mut axis, 0.0, -7.0);
        // Place 48 is called −7.
        assert_eq!((axis.passed(), axis.edge(), axis.is_home()), (Some(-5.0), Some(-5.0), false));
        assert_eq!(axis.is_beyond(), [false, false]);
        run(&mut axis, -7.0, 50.0);
        assert_eq!((axis.is_beyond(), axis.edge()), ([false, true], Some(5.0)));
    }

    #[test]
    fn an_encoder_counts_whole_steps() {
        let mut axis = axis(|a| a.resolution = 0.001);
        for k in 1..=997 {
            let at = axis.follow(f64::from(k) * 0.0123);
            assert!(
                (at * 1000.0 - (at * 1000.0).round()).abs() < 1e-6
                    && (at - axis.place).abs() <= 0.0005 + 1e-12
            );
        }
    }
}
