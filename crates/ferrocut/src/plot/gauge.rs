//! What is measured of a run: speed, velocity, acceleration and jerk, and the path error.
//!
//! All are differences over the servo period, of the positions that `run --samples` writes: means of the true
//! quantity, which never overstate it.

use super::path_error::PathError;
use super::series::Series;
use ferrocut_controller::{Cnc, Tick};
use ferrocut_geometry::{Axis, Position};
use ferrocut_machine::{AxisConfig, AxisKind, Machine};

/// The quantities of an axis, by the names of the report.
pub const QUANTITIES: [&str; 3] = ["velocity", "acceleration", "jerk"];

/// Periods of the window of jerk at most; the longest that a machine file can need is far below.
const LONGEST_WINDOW: usize = 1000;

/// A highest value and where it was.
#[derive(Clone, Copy, Default)]
pub struct Peak {
    /// The value, without sign.
    pub value: f64,
    /// When, s.
    pub time: f64,
    /// Line of the block that was run.
    pub line: u32,
    /// What is allowed there; 0 where nothing is limited.
    pub limit: f64,
}

impl Peak {
    fn take(&mut self, value: f64, time: f64, line: u32, limit: f64) {
        if value.abs() > self.value {
            *self = Peak { value: value.abs(), time, line, limit };
        }
    }

    /// Part of the limit; `None` where nothing is limited.
    pub fn share(&self) -> Option<f64> {
        (self.limit > 0.0).then(|| self.value / self.limit)
    }
}

/// An axis.
pub struct AxisGauge {
    /// Which.
    pub axis: Axis,
    /// Whether its positions are degrees.
    pub is_rotary: bool,
    /// Velocity while cutting, mm/min, acceleration, mm/s², jerk, mm/s³; 0 where nothing is limited.
    pub limits: [f64; 3],
    /// Velocity of positioning, mm/min.
    pub rapid: f64,
    /// Velocity, mm/min, acceleration and jerk.
    pub series: [Series; 3],
    /// Their highest.
    pub peaks: [Peak; 3],
    position: f64,
    /// mm/s.
    velocity: f64,
    /// Accelerations of the last window, the oldest where the next one goes.
    accelerations: Vec<f64>,
    next: usize,
}

/// Everything measured.
pub struct Gauge {
    /// The axes that are plotted.
    pub axes: Vec<AxisGauge>,
    /// Speed along the path, mm/min.
    pub speed: Series,
    /// What is programmed.
    pub feed: Series,
    /// Distance from the programmed path, mm.
    pub error: Series,
    /// What is allowed.
    pub tolerance: Series,
    /// The highest of the path error.
    pub error_peak: Peak,
    /// The highest speed along the path; its limit is the programmed feed.
    pub speed_peak: Peak,
    /// Servo period, s.
    pub period: f64,
    /// Accelerations of jerk lie this many periods apart.
    pub apart: usize,
    /// What is plotted, s.
    pub span: [f64; 2],
    path: PathError,
    before: Position,
    renamed: Position,
    machine_tolerance: f64,
    /// Periods since motion began.
    periods: u64,
    line: u32,
}

impl Gauge {
    /// Measures `axes` of `machine`, which stand at `start`, from and to these seconds.
    pub fn new(machine: &Machine, axes: &[Axis], start: Position, span: [f64; 2]) -> Gauge {
        let period = machine.servo_period_ms / 1000.0;
        let chosen = || machine.axes.iter().filter(|config| axes.contains(&config.name));
        let apart = chosen().map(|config| window(config, period)).max().unwrap_or(1);
        let gauge = |config: &AxisConfig| AxisGauge {
            axis: config.name,
            is_rotary: config.kind == AxisKind::Rotary,
            limits: [config.velocity, config.acceleration, config.jerk],
            rapid: config.rapid,
            series: [(); 3].map(|()| Series::new()),
            peaks: Default::default(),
            position: start[config.name],
            velocity: 0.0,
            accelerations: vec![0.0; apart],
            next: 0,
        };
        Gauge {
            axes: chosen().map(gauge).collect(),
            speed: Series::new(),
            feed: Series::new(),
            error: Series::new(),
            tolerance: Series::new(),
            error_peak: Peak::default(),
            speed_peak: Peak::default(),
            period,
            apart,
            span,
            path: PathError::new(lag(machine)),
            before: start,
            renamed: Position::default(),
            machine_tolerance: machine.path.tolerance,
            periods: 0,
            line: 0,
        }
    }

    /// Takes a period. `false`: what follows is not asked for.
    pub fn take(&mut self, cnc: &Cnc, tick: &Tick) -> bool {
        if self.periods == 0 && !tick.moving {
            return true;
        }
        if cnc.renamed() != self.renamed {
            self.renamed = cnc.renamed();
            self.path.forget();
        }
        self.path.follow(cnc);
        let error = self.path.at(tick.position);
        let now = self.path.now().filter(|_| tick.moving);
        let feed = now.and_then(|m| m.feed).map(|f| f * 60.0);
        let tolerance = now.and_then(|m| m.tolerance).unwrap_or(self.machine_tolerance);
        let is_rapid = now.is_some_and(|m| m.is_rapid);
        self.line = tick.span.line;
        self.period(tick.position - self.renamed, is_rapid, feed, error.map(|e| (e, tolerance)));
        self.time() < self.span[1]
    }

    /// The axes stay where they are: takes what a window still holds of their stop.
    pub fn finish(&mut self) {
        for _ in 0..self.apart + 2 {
            if self.periods > 0 && self.time() < self.span[1] {
                self.period(self.before, false, None, None);
            }
        }
    }

    /// Seconds since motion began.
    pub fn time(&self) -> f64 {
        self.periods as f64 * self.period
    }

    fn period(&mut self, at: Position, is_rapid: bool, feed: Option<f64>, error: Option<(f64, f64)>) {
        self.periods += 1;
        let (time, line) = (self.time(), self.line);
        let shown = time >= self.span[0];
        let speed = self.before.distance(at) / self.period * 60.0;
        self.before = at;
        for axis in &mut self.axes {
            let values = axis.advance(at[axis.axis], self.period, self.apart);
            let [cutting, acceleration, jerk] = axis.limits;
            let limits = [if is_rapid { axis.rapid } else { cutting }, acceleration, jerk];
            if !shown {
                continue;
            }
            for (((series, peak), value), limit) in
                axis.series.iter_mut().zip(&mut axis.peaks).zip(values).zip(limits)
            {
                series.push(value);
                peak.take(value, time, line, limit);
            }
        }
        if !shown {
            return;
        }
        self.speed.push(speed);
        self.speed_peak.take(speed, time, line, feed.unwrap_or(0.0));
        self.feed.push(feed.unwrap_or(f64::NAN));
        self.error.push(error.map_or(f64::NAN, |(value, _)| value));
        self.tolerance.push(error.map_or(f64::NAN, |(_, tolerance)| tolerance));
        if let Some((value, tolerance)) = error {
            self.error_peak.take(value, time, line, tolerance);
        }
    }
}

impl AxisGauge {
    /// Velocity, mm/min, acceleration and jerk of the period that ends at `position`.
    fn advance(&mut self, position: f64, period: f64, apart: usize) -> [f64; 3] {
        let velocity = (position - self.position) / period;
        let acceleration = (velocity - self.velocity) / period;
        let mut jerk = 0.0;
        if let Some(oldest) = self.accelerations.get_mut(self.next) {
            jerk = (acceleration - *oldest) / (apart as f64 * period);
            *oldest = acceleration;
        }
        self.next = (self.next + 1) % apart.max(1);
        (self.position, self.velocity) = (position, velocity);
        [velocity * 60.0, acceleration, jerk]
    }
}

/// Periods that the axes may be behind the move being run: what is left of an exponential after ten times its
/// constant is 5e-5 of the change.
fn lag(machine: &Machine) -> usize {
    let times =
        machine.axes.iter().flat_map(|axis| axis.smoothing()).map(|(_, smoothing)| smoothing.time_ms());
    (times.fold(2.0, f64::max) * 10.0 / machine.servo_period_ms).ceil() as usize
}

/// How many periods two accelerations must lie apart so that rounding adds less than 1 % of the limit to jerk.
///
/// A position is wrong by up to `e`, a few units in the last place of the farthest one; a second difference by
/// `4·e/T²`, and the difference of two over `n` periods by `8·e/(n·T³)`.
fn window(axis: &AxisConfig, period: f64) -> usize {
    const PLACES: f64 = 8.0;
    const PART: f64 = 0.01;
    if axis.jerk <= 0.0 {
        return 1;
    }
    let e = PLACES * f64::EPSILON * axis.min.abs().max(axis.max.abs());
    let noise = 8.0 * e / period.powi(3);
    ((noise / (PART * axis.jerk)).ceil() as usize).clamp(1, LONGEST_WINDOW)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mill() -> (Machine, Gauge) {
        let machine = Machine::demo_mill();
        let gauge = Gauge::new(&machine, &[Axis::X], Position::default(), [0.0, f64::INFINITY]);
        (machine, gauge)
    }

    #[test]
    fn differences_are_those_worked_out_by_hand() {
        let (_, mut gauge) = mill();
        // x = 0, 0.001, 0.003, 0.006 mm at 1 ms: 1, 2, 3 mm/s, each 1000 mm/s² above the one before.
        for x in [0.001, 0.003, 0.006] {
            gauge.period(Position::xyz(x, 0.0, 0.0), false, Some(90.0), None);
        }
        let [velocity, acceleration, jerk] = &gauge.axes[0].peaks;
        assert!((velocity.value - 180.0).abs() < 1e-9 && (velocity.time - 0.003).abs() < 1e-12);
        assert!((velocity.share().unwrap() - 0.018).abs() < 1e-12, "of 10000 mm/min");
        assert!((acceleration.value - 1000.0).abs() < 1e-6);
        // From rest to 1000 mm/s² within a period.
        assert!((jerk.value - 1e6).abs() < 1e-3 && (jerk.time - 0.001).abs() < 1e-12);
        assert!((gauge.speed_peak.share().unwrap() - 2.0).abs() < 1e-9);
    }

    #[test]
    fn the_stop_at_the_end_is_measured() {
        let (_, mut gauge) = mill();
        gauge.period(Position::xyz(0.001, 0.0, 0.0), false, None, None);
        gauge.finish();
        // 1 mm/s in a period, 0 in the next: −1000 mm/s² behind +1000 mm/s².
        assert!((gauge.axes[0].peaks[2].value - 2e6).abs() < 1e-3);
    }

    #[test]
    fn the_window_is_as_short_as_rounding_allows() {
        let mut axis = mill().0.axes[0].clone();
        assert_eq!(window(&axis, 1e-3), 1);
        // e = 8·2.22e-16·500 = 8.88e-13; 8·e/1e-12 = 7.1; a hundredth of 100 is 1: eight periods.
        axis.jerk = 100.0;
        assert_eq!(window(&axis, 1e-4), 8);
    }
}
