//! Waveforms: quantities of axes, spindle and signals at the servo period, for adjustment and for finding faults.
//!
//! Up to [`MOST_QUANTITIES`] quantities are sampled each period, or each few periods, into a ring that was made
//! before; a sample allocates nothing. The trigger divides the ring: samples before are kept as far as there is
//! room, a number of samples behind ends the capture. Without a trigger it ends when the ring is full.
//!
//! Velocity, acceleration and jerk are differences of the commanded positions, over one period each.

use crate::cnc::Tick;
use crate::diagnosis;
use ferrocut_geometry::{AXES, Axis, Position};
use ferrocut_machine::{Alarm, Fault};
use ferrocut_plc::{Address, Memory, Program};
use ferrocut_program::Span;
use std::io::{self, Write};

/// Quantities of a capture.
pub const MOST_QUANTITIES: usize = 16;
/// Values of a capture: quantities times samples. 64 MB.
pub const MOST_VALUES: usize = 1 << 23;

/// What is sampled.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Quantity {
    /// Commanded position of an axis, mm or degrees.
    Commanded(Axis),
    /// Where it is, mm or degrees.
    Actual(Axis),
    /// How far it is behind, mm or degrees.
    FollowingError(Axis),
    /// What the interpolator gave, before acceleration after interpolation, mm or degrees.
    Setpoint(Axis),
    /// What compensates backlash and pitch errors, mm or degrees.
    Compensation(Axis),
    /// What its drive is told: commanded position and compensation, mm or degrees.
    Drive(Axis),
    /// Where its encoder is, compensation included, mm or degrees.
    Encoder(Axis),
    /// What is left of the move being run, mm or degrees.
    ToGo(Axis),
    /// Its commanded velocity, mm/s or degrees/s.
    Velocity(Axis),
    /// Its commanded acceleration, mm/s² or degrees/s².
    Acceleration(Axis),
    /// Its commanded jerk, mm/s³ or degrees/s³.
    Jerk(Axis),
    /// Speed along the path, mm/s.
    PathVelocity,
    /// Speed of the spindle, r/min; clockwise positive.
    Spindle,
    /// A signal of the ladder and the bytes of its value, 0 for a bit: a bit 0 or 1, a value as a number.
    Signal(Address, u8),
}

impl Quantity {
    /// The quantity of a name: `commanded.X`, `actual.X`, `error.X`, `setpoint.X`, `compensation.X`, `drive.X`,
    /// `encoder.X`, `to_go.X`, `velocity.X`, `acceleration.X`, `jerk.X`, `velocity`, `spindle`, or a signal by name or
    /// address.
    pub fn parse(name: &str, ladder: Option<&Program>) -> Option<Quantity> {
        match name {
            "velocity" => return Some(Quantity::PathVelocity),
            "spindle" => return Some(Quantity::Spindle),
            _ => {}
        }
        if let Some((kind, axis)) = name.split_once('.')
            && let [letter] = axis.as_bytes()
            && let Some(axis) = Axis::from_letter(*letter)
        {
            return Some(match kind {
                "commanded" => Quantity::Commanded(axis),
                "actual" => Quantity::Actual(axis),
                "error" => Quantity::FollowingError(axis),
                "setpoint" => Quantity::Setpoint(axis),
                "compensation" => Quantity::Compensation(axis),
                "drive" => Quantity::Drive(axis),
                "encoder" => Quantity::Encoder(axis),
                "to_go" => Quantity::ToGo(axis),
                "velocity" => Quantity::Velocity(axis),
                "acceleration" => Quantity::Acceleration(axis),
                "jerk" => Quantity::Jerk(axis),
                _ => return None,
            });
        }
        if let Some(ladder) = ladder {
            let signal = diagnosis::find(name, ladder)?;
            return Some(Quantity::Signal(signal.address, signal.bytes));
        }
        let address = Address::parse(name).ok()?;
        Some(Quantity::Signal(address, u8::from(address.bit.is_none())))
    }
}

impl Quantity {
    /// The axis that it is of.
    pub fn axis(self) -> Option<Axis> {
        match self {
            Quantity::Commanded(axis)
            | Quantity::Actual(axis)
            | Quantity::FollowingError(axis)
            | Quantity::Setpoint(axis)
            | Quantity::Compensation(axis)
            | Quantity::Drive(axis)
            | Quantity::Encoder(axis)
            | Quantity::ToGo(axis)
            | Quantity::Velocity(axis)
            | Quantity::Acceleration(axis)
            | Quantity::Jerk(axis) => Some(axis),
            Quantity::PathVelocity | Quantity::Spindle | Quantity::Signal(..) => None,
        }
    }
}

/// When a quantity sets off the end of a capture.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Trigger {
    /// Which quantity, by its place.
    pub quantity: usize,
    /// The value that it passes.
    pub level: f64,
    /// From below to the level or above; else from above to the level or below.
    pub rises: bool,
}

/// What is captured.
#[derive(Clone, PartialEq, Debug)]
pub struct CaptureSettings {
    /// The quantities with their names.
    pub quantities: Vec<(String, Quantity)>,
    /// Samples that are kept.
    pub samples: usize,
    /// Periods from one sample to the next, at least 1.
    pub every: u32,
    /// What sets off the end.
    pub trigger: Option<Trigger>,
    /// Samples behind the trigger.
    pub behind: usize,
}

/// Between the interpolator and the drives, mm and degrees.
#[derive(Clone, Copy, Debug, Default)]
pub struct Chain {
    /// What the interpolator gave, before acceleration after interpolation.
    pub setpoint: Position,
    /// What compensates backlash and pitch errors.
    pub compensation: Position,
    /// What is left of the move being run.
    pub to_go: Position,
}

/// What can be sampled of a period.
#[derive(Clone, Copy, Debug)]
pub struct Present<'a> {
    /// The axes.
    pub tick: &'a Tick,
    /// What is between interpolator and drives.
    pub chain: &'a Chain,
    /// Speed of the spindle, r/min.
    pub spindle_rpm: f64,
    /// The signals, where there is a ladder.
    pub signals: Option<&'a Memory>,
}

/// A capture being made.
#[derive(Clone, Debug)]
pub struct Capture {
    quantities: Vec<(String, Quantity)>,
    /// s.
    period: f64,
    every: u64,
    trigger: Option<Trigger>,
    behind: usize,
    /// Samples one behind the other: the period of each, and its values by quantity.
    ring: Box<[f64]>,
    room: usize,
    /// Where the next sample goes, and how many there are.
    next: usize,
    len: usize,
    periods: u64,
    /// The value of the trigger's quantity in the last period.
    before: Option<f64>,
    triggered_at: Option<u64>,
    /// Samples left until the end.
    left: Option<usize>,
    /// Commanded positions and their first and second differences of the last period.
    past: Option<Position>,
    velocity: [f64; AXES],
    acceleration: [f64; AXES],
    jerk: [f64; AXES],
}

impl Capture {
    /// A capture with all its room, at a period of `period` s.
    pub fn new(settings: &CaptureSettings, period: f64) -> Result<Capture, Box<Alarm>> {
        let refuse = |value: String| {
            Box::new(Alarm::core(Fault::CaptureSetting, Span::default()).with("value", value))
        };
        let count = settings.quantities.len();
        if count == 0 || count > MOST_QUANTITIES {
            return Err(refuse(format!("quantities: {count}")));
        }
        let room = settings.samples;
        match room.checked_mul(count + 1) {
            Some(values) if room > 0 && values <= MOST_VALUES => {}
            _ => return Err(refuse(format!("samples: {room}"))),
        }
        if let Some(trigger) = settings.trigger
            && (trigger.quantity >= count || !trigger.level.is_finite())
        {
            return Err(refuse("trigger".to_owned()));
        }
        Ok(Capture {
            quantities: settings.quantities.clone(),
            period,
            every: u64::from(settings.every.max(1)),
            trigger: settings.trigger,
            behind: settings.behind.min(room),
            ring: vec![0.0; room * (count + 1)].into(),
            room,
            next: 0,
            len: 0,
            periods: 0,
            before: None,
            triggered_at: None,
            left: settings.trigger.is_none().then_some(room),
            past: None,
            velocity: [0.0; AXES],
            acceleration: [0.0; AXES],
            jerk: [0.0; AXES],
        })
    }

    /// Takes the values of a period. Allocates nothing.
    pub fn sample(&mut self, now: &Present) {
        if self.is_done() {
            return;
        }
        self.differ(&now.tick.position);
        let at = self.periods;
        self.periods += 1;
        let is_set_off = self.is_set_off(now);
        if at.is_multiple_of(self.every) || is_set_off {
            self.take(at, now);
            self.left = self.left.map(|left| left.saturating_sub(1));
        }
        if is_set_off && self.triggered_at.is_none() {
            self.triggered_at = Some(at);
            self.left = Some(self.behind);
        }
    }

    /// Puts a sample into the ring.
    fn take(&mut self, at: u64, now: &Present) {
        let first = self.next * self.width();
        for n in 0..self.width() {
            let value = match n.checked_sub(1).and_then(|n| self.quantities.get(n)) {
                Some((_, quantity)) => self.value(*quantity, now),
                None => at as f64,
            };
            if let Some(place) = self.ring.get_mut(first + n) {
                *place = value;
            }
        }
        self.next = (self.next + 1) % self.room;
        self.len = (self.len + 1).min(self.room);
    }

    /// Differences of the commanded positions. The axes stood still before the capture.
    fn differ(&mut self, position: &Position) {
        let past = self.past.replace(*position).unwrap_or(*position);
        let derivatives = self.velocity.iter_mut().zip(&mut self.acceleration).zip(&mut self.jerk);
        for (((v, a), j), (now, past)) in derivatives.zip(position.0.iter().zip(&past.0)) {
            let velocity = (now - past) / self.period;
            let acceleration = (velocity - *v) / self.period;
            *j = (acceleration - *a) / self.period;
            (*v, *a) = (velocity, acceleration);
        }
    }

    fn value(&self, quantity: Quantity, now: &Present) -> f64 {
        let of = |values: &[f64; AXES], axis: Axis| values.get(axis.index()).copied().unwrap_or_default();
        match quantity {
            Quantity::Commanded(axis) => now.tick.position[axis],
            Quantity::Actual(axis) => now.tick.actual[axis],
            Quantity::FollowingError(axis) => now.tick.position[axis] - now.tick.actual[axis],
            Quantity::Setpoint(axis) => now.chain.setpoint[axis],
            Quantity::Compensation(axis) => now.chain.compensation[axis],
            Quantity::Drive(axis) => now.tick.position[axis] + now.chain.compensation[axis],
            Quantity::Encoder(axis) => now.tick.actual[axis] + now.chain.compensation[axis],
            Quantity::ToGo(axis) => now.chain.to_go[axis],
            Quantity::Velocity(axis) => of(&self.velocity, axis),
            Quantity::Acceleration(axis) => of(&self.acceleration, axis),
            Quantity::Jerk(axis) => of(&self.jerk, axis),
            Quantity::PathVelocity => now.tick.velocity,
            Quantity::Spindle => now.spindle_rpm,
            Quantity::Signal(address, bytes) => {
                now.signals.map_or(0.0, |memory| f64::from(diagnosis::value(address, bytes, memory)))
            }
        }
    }

    fn is_set_off(&mut self, now: &Present) -> bool {
        let Some(trigger) = self.trigger else { return false };
        let Some((_, quantity)) = self.quantities.get(trigger.quantity) else { return false };
        let value = self.value(*quantity, now);
        let Some(before) = self.before.replace(value) else { return false };
        match trigger.rises {
            true => before < trigger.level && value >= trigger.level,
            false => before > trigger.level && value <= trigger.level,
        }
    }

    /// Takes nothing more.
    pub fn end(&mut self) {
        self.left = Some(0);
    }

    /// Samples that are there.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there is no sample yet.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// How many quantities each sample has.
    pub fn quantities(&self) -> usize {
        self.quantities.len()
    }

    /// Whether all samples are there.
    pub fn is_done(&self) -> bool {
        self.left == Some(0)
    }

    /// Time of the trigger since the capture began, s.
    pub fn triggered_s(&self) -> Option<f64> {
        self.triggered_at.map(|at| at as f64 * self.period)
    }

    /// The samples, oldest first: the time of each since the capture began, s, and its values in the order of the
    /// quantities.
    pub fn samples(&self) -> impl Iterator<Item = (f64, &[f64])> {
        let first = (self.next + self.room - self.len) % self.room;
        let width = self.width();
        (0..self.len).filter_map(move |n| {
            let at = (first + n) % self.room * width;
            let (period, values) = self.ring.get(at..at + width)?.split_first()?;
            Some((period * self.period, values))
        })
    }

    /// Values of a sample: its period, then those of the quantities.
    fn width(&self) -> usize {
        self.quantities.len() + 1
    }

    /// Writes `t` in s and the quantities by their names, one row a sample. The time is that since the trigger, or
    /// since the capture began where there is none.
    pub fn write_csv(&self, out: &mut impl Write) -> io::Result<()> {
        self.write_rows(out, 0, usize::MAX)
    }

    /// The same for `most` rows from the row `from`; the line of the names stands before the first row.
    pub fn write_rows(&self, out: &mut impl Write, from: usize, most: usize) -> io::Result<()> {
        if from == 0 {
            write!(out, "t")?;
            for (name, _) in &self.quantities {
                write!(out, ",{name}")?;
            }
            writeln!(out)?;
        }
        let origin = self.triggered_s().unwrap_or_default();
        for (time, values) in self.samples().skip(from).take(most) {
            write!(out, "{:.6}", time - origin)?;
            for value in values {
                write!(out, ",{value}")?;
            }
            writeln!(out)?;
        }
        out.flush()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tick(x: f64) -> Tick {
        let mut position = Position::ZERO;
        position[Axis::X] = x;
        let mut actual = position;
        actual[Axis::X] -= 0.25;
        Tick { position, actual, velocity: 7.0, span: Span::default(), moving: true }
    }

    fn settings(names: &[&str]) -> CaptureSettings {
        let quantities = names.iter().map(|n| ((*n).to_owned(), Quantity::parse(n, None).unwrap())).collect();
        CaptureSettings { quantities, samples: 4, every: 1, trigger: None, behind: 0 }
    }

    fn run(capture: &mut Capture, xs: impl IntoIterator<Item = f64>) {
        for x in xs {
            let mut chain = Chain::default();
            (chain.setpoint[Axis::X], chain.compensation[Axis::X], chain.to_go[Axis::X]) = (x + 2.0, 0.5, -x);
            let present = Present { tick: &tick(x), chain: &chain, spindle_rpm: 100.0, signals: None };
            capture.sample(&present);
        }
    }

    #[test]
    fn quantities_are_sampled_each_period_until_the_ring_is_full() {
        let names =
            ["commanded.X", "actual.X", "error.X", "velocity.X", "acceleration.X", "jerk.X", "velocity"];
        let mut capture = Capture::new(&settings(&[&names[..], &["spindle"]].concat()), 0.5).unwrap();
        // From rest at 0: differences over half a second.
        run(&mut capture, [0.0, 1.0, 3.0, 3.0, 9.0]);
        assert!(capture.is_done());
        let mut text = Vec::new();
        capture.write_csv(&mut text).unwrap();
        let wanted = "t,commanded.X,actual.X,error.X,velocity.X,acceleration.X,jerk.X,velocity,spindle\n\
            0.000000,0,-0.25,0.25,0,0,0,7,100\n\
            0.500000,1,0.75,0.25,2,4,8,7,100\n\
            1.000000,3,2.75,0.25,4,4,0,7,100\n\
            1.500000,3,2.75,0.25,0,-8,-24,7,100\n";
        assert_eq!(String::from_utf8(text).unwrap(), wanted);
    }

    #[test]
    fn what_is_between_interpolator_and_drives_is_sampled_too() {
        let names = ["setpoint.X", "compensation.X", "drive.X", "encoder.X", "to_go.X"];
        let mut capture = Capture::new(&settings(&names), 0.001).unwrap();
        run(&mut capture, [3.0]);
        // 3 is commanded, 0.25 of it not reached, 0.5 compensates.
        assert_eq!(capture.samples().next().unwrap().1, [5.0, 0.5, 3.5, 3.25, -3.0]);
    }

    #[test]
    fn a_trigger_divides_the_ring() {
        let mut wanted = settings(&["commanded.X"]);
        wanted.trigger = Some(Trigger { quantity: 0, level: 5.0, rises: true });
        wanted.behind = 1;
        let mut capture = Capture::new(&wanted, 0.001).unwrap();
        run(&mut capture, [9.0, 1.0, 2.0, 3.0, 4.0]);
        assert!(!capture.is_done() && capture.triggered_s().is_none(), "9 did not rise to it");
        run(&mut capture, [6.0, 7.0, 8.0, 9.0]);
        let values: Vec<f64> = capture.samples().map(|(_, values)| values[0]).collect();
        assert_eq!((capture.is_done(), values), (true, vec![3.0, 4.0, 6.0, 7.0]));
        assert!((capture.triggered_s().unwrap() - 0.005).abs() < 1e-12);
        // Falling, with every second period; the sample of the trigger stands where it came.
        wanted.trigger = Some(Trigger { quantity: 0, level: 5.0, rises: false });
        wanted.every = 2;
        let mut capture = Capture::new(&wanted, 0.001).unwrap();
        run(&mut capture, [9.0, 8.0, 7.0, 4.0, 3.0, 2.0]);
        let mut text = Vec::new();
        capture.write_csv(&mut text).unwrap();
        let rows = "t,commanded.X\n-0.003000,9\n-0.001000,7\n0.000000,4\n0.001000,3\n";
        assert_eq!(String::from_utf8(text).unwrap(), rows);
    }

    #[test]
    fn what_cannot_be_captured_is_refused() {
        let good = settings(&["velocity"]);
        assert!(Capture::new(&good, 0.001).is_ok());
        let none = CaptureSettings { quantities: Vec::new(), ..good.clone() };
        let many = CaptureSettings { quantities: vec![good.quantities[0].clone(); 17], ..good.clone() };
        let long = CaptureSettings { samples: usize::MAX, ..good.clone() };
        let empty = CaptureSettings { samples: 0, ..good.clone() };
        let trigger = Some(Trigger { quantity: 1, level: 0.0, rises: true });
        let beside = CaptureSettings { trigger, ..good.clone() };
        for settings in [none, many, long, empty, beside] {
            let alarm = Capture::new(&settings, 0.001).unwrap_err();
            assert_eq!(alarm.fault, Fault::CaptureSetting);
        }
        for name in ["", "commanded", "commanded.Q", "speed.X", "X", "F9999"] {
            assert_eq!(Quantity::parse(name, None), None, "{name}");
        }
    }

    #[test]
    fn signals_are_sampled_too() {
        let mut memory = Memory::new();
        memory.set_byte(Address::parse("F10").unwrap(), 8);
        memory.set_bit(Address::parse("G4.3").unwrap(), true);
        let mut capture = Capture::new(&settings(&["F10", "G4.3", "G4.2"]), 0.001).unwrap();
        let (tick, chain) = (&tick(0.0), &Chain::default());
        capture.sample(&Present { tick, chain, spindle_rpm: 0.0, signals: Some(&memory) });
        assert_eq!(capture.samples().next().unwrap().1, [8.0, 1.0, 0.0]);
    }
}
