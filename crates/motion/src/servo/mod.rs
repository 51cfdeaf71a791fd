//! Between the setpoint of the path and the drives: every axis by itself, every servo period.
//!
//! In: the setpoints of [`Motion`](crate::Motion), and where the drives say that the axes are. Out: where the
//! axes shall be ([`Command::position`]), what the drives are told so that they are there
//! ([`Command::drive`]), and what is wrong.
//!
//! ```text
//! setpoint ─▶ smoothing ─▶ position ─▶ reversal ─▶ backlash ─┐
//!             acceleration     │         direction  pitch ────┴─(+)─▶ drive
//!             after            └────────────────────────────────┘
//!             interpolation
//! ```
//!
//! All memory is taken in [`Servo::new`]; [`Servo::tick`] allocates nothing, takes no lock and does not fail. With
//! nothing to do for an axis its command is the setpoint, bit by bit.
//!
//! Read `smoothing.rs` and `average.rs` for what acceleration after interpolation is, `backlash.rs`, `ramp.rs` and
//! `pitch.rs` for what is added, `supervision.rs` for what is watched.

pub(crate) mod average;
mod backlash;
mod pitch;
mod ramp;
mod reversal;
mod smoothing;
mod supervision;

pub use supervision::{ServoFault, ServoFaultKind};

use crate::limits::Limits;
use crate::stroke::RampLimits;
use backlash::TakeUp;
use ferrocut_geometry::{Axis, Position};
use ferrocut_machine::{AxisConfig, Machine, Smoothing};
use pitch::PitchTable;
use reversal::Direction;
use smoothing::{Ending, Left, Smoother};
use supervision::Watch;

/// What the axes move for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    /// Positioning.
    Rapid,
    /// Cutting.
    Cutting,
    /// Moving by hand: jog, step.
    Jog,
    /// Cutting in step with the spindle, which nothing may delay.
    Tapping,
    /// Following the handwheel.
    Wheel,
}

impl Kind {
    const COUNT: usize = 5;
}

/// What the drives are told in a period.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Command {
    /// Where the axes shall be: the setpoint after acceleration after interpolation, mm and degrees.
    pub position: Position,
    /// The same with backlash and pitch errors compensated.
    pub drive: Position,
    /// The first thing that is wrong.
    pub fault: Option<ServoFault>,
}

/// What lies between path and drives.
#[derive(Clone, Debug)]
pub struct Servo {
    loops: Box<[AxisLoop]>,
    command: Command,
    /// Periods that an axis may take to come into position.
    patience: u64,
    /// Periods since the command came to rest.
    resting: u64,
}

/// One axis.
#[derive(Clone, Debug)]
struct AxisLoop {
    axis: Axis,
    setpoint: f64,
    position: f64,
    smoother: Option<Smoother>,
    compensation: Option<Compensation>,
    watch: Watch,
    /// Whether the command moved in this period.
    moves: bool,
    /// What the axes moved for last.
    kind: Kind,
    /// Distance of the axis from its command, mm.
    distance: f64,
}

/// What is added to the command of an axis.
#[derive(Clone, Debug)]
struct Compensation {
    direction: Direction,
    backlash: Option<TakeUp>,
    pitch: Option<PitchTable>,
}

impl Servo {
    /// The axes of `machine`, at rest at `start`, moved last in the direction in which they were homed.
    pub fn new(machine: &Machine, start: Position) -> Servo {
        let period = machine.servo_period_ms / 1000.0;
        let limits = Limits::new(machine);
        let loops = machine.axes.iter().map(|axis| {
            let at = axis.name.index();
            // An axis that is not there twice has its limits at its place.
            let of = |values: &[f64]| values.get(at).copied().unwrap_or(f64::INFINITY);
            let limits = RampLimits {
                velocity: of(&limits.rapid),
                acceleration: of(&limits.acceleration),
                jerk: of(&limits.jerk),
            };
            AxisLoop::new(axis, machine.path.tolerance, &limits, period, start[axis.name])
        });
        let mut servo = Servo {
            loops: loops.collect(),
            command: Command { position: start, drive: start, fault: None },
            patience: (machine.servo.in_position_ms / machine.servo_period_ms).ceil() as u64,
            resting: 0,
        };
        servo.rename(start);
        servo
    }

    /// Goes on by a period to a setpoint of the path. Movements from the one before count as `kind`.
    pub fn tick(&mut self, setpoint: &Position, kind: Kind) -> Command {
        self.command = Command { position: *setpoint, drive: *setpoint, fault: None };
        let mut left = Left::NONE;
        for axis in self.loops.iter() {
            if let Some(smoother) = &axis.smoother {
                left.add(smoother, setpoint[axis.axis] - axis.setpoint);
            }
        }
        let ending = left.ending(kind);
        for axis in &mut self.loops {
            axis.tick(kind, &ending, &mut self.command);
        }
        self.command
    }

    /// Takes where the drives say that the axes are; the first one too far from its command.
    pub fn supervise(&mut self, actual: &Position) -> Option<ServoFault> {
        let mut fault = None;
        let mut in_position = true;
        for axis in &mut self.loops {
            axis.distance = (self.command.drive[axis.axis] - actual[axis.axis]).abs();
            in_position &= axis.is_in_position();
            if !axis.watch.follows(axis.distance) && fault.is_none() {
                fault = Some(axis.fault(ServoFaultKind::FollowingError, axis.watch.following_error));
            }
        }
        let stands = self.loops.iter().all(|axis| !axis.moves && axis.is_settled());
        self.resting = if stands { self.resting.saturating_add(1) } else { 0 };
        if fault.is_none() && !in_position && self.resting > self.patience {
            let late = self.loops.iter().find(|axis| !axis.is_in_position());
            fault = late.map(|axis| axis.fault(ServoFaultKind::NotInPosition, axis.watch.width(axis.kind)));
        }
        fault
    }

    /// Whether the axes are where the last setpoint is: acceleration after interpolation has run out, backlash
    /// that is waited for is taken up, and every axis is in position.
    pub fn is_at_rest(&self) -> bool {
        self.loops.iter().all(|axis| axis.is_settled() && axis.is_in_position())
    }

    /// Whether no axis takes up backlash that its next move waits for.
    pub fn has_taken_up(&self) -> bool {
        let lets_go = |axis: &AxisLoop| axis.compensation.as_ref().is_none_or(Compensation::lets_go);
        self.loops.iter().all(lets_go)
    }

    /// The place of an axis in the machine file, counted from 0, which alarms are numbered by.
    pub fn number(&self, axis: Axis) -> usize {
        self.loops.iter().position(|l| l.axis == axis).unwrap_or(0)
    }

    /// Whether the software limits of an axis hold; from the start they do.
    pub fn set_travel(&mut self, axis: Axis, holds: bool) {
        for found in self.loops.iter_mut().filter(|l| l.axis == axis) {
            found.watch.set_travel(holds);
        }
    }

    /// What compensation adds to the command of every axis now.
    pub fn added(&self) -> Position {
        self.command.drive - self.command.position
    }

    /// The place where the axes stand is called `at` from here on.
    pub fn rename(&mut self, at: Position) {
        self.command = Command { position: at, drive: at, fault: None };
        for axis in &mut self.loops {
            axis.rename(&mut self.command);
        }
    }
}

impl AxisLoop {
    fn new(axis: &AxisConfig, tolerance: f64, limits: &RampLimits, period: f64, at: f64) -> AxisLoop {
        let [rapid, cutting, jog, wheel] = axis.smoothing().map(|(_, smoothing)| smoothing);
        let smoother =
            Smoother::new([rapid, cutting, jog, Smoothing::None, wheel], limits.acceleration, period);
        let watch = Watch::new(axis, tolerance);
        AxisLoop {
            axis: axis.name,
            setpoint: at,
            position: at,
            smoother: Some(smoother).filter(|smoother| !smoother.is_off()),
            compensation: Compensation::new(axis, limits, period, at),
            watch,
            moves: false,
            kind: Kind::Rapid,
            distance: 0.0,
        }
    }

    #[inline]
    fn tick(&mut self, kind: Kind, ending: &Ending, command: &mut Command) {
        let setpoint = command.position[self.axis];
        let mut position = setpoint;
        if let Some(smoother) = &mut self.smoother {
            position -= smoother.push(setpoint - self.setpoint, kind, ending);
            command.position[self.axis] = position;
            command.drive[self.axis] = position;
        }
        let d = position - self.position;
        self.setpoint = setpoint;
        self.position = position;
        self.moves = d != 0.0;
        if self.moves {
            self.kind = kind;
        }
        let mut wrong = self.watch.travel(d, position);
        if let Some(compensation) = &mut self.compensation {
            let (added, is_beside) = compensation.tick(d, position, kind);
            command.drive[self.axis] = position + added;
            if let (true, Some(limit)) = (is_beside, compensation.end()) {
                wrong = wrong.or(Some((ServoFaultKind::BesidePitchPoints, limit)));
            }
        }
        if let (Some((kind, limit)), None) = (wrong, command.fault) {
            command.fault = Some(ServoFault { axis: self.axis, kind, value: position, limit });
        }
    }

    fn is_settled(&self) -> bool {
        self.smoother.as_ref().is_none_or(Smoother::is_at_rest)
            && self.compensation.as_ref().is_none_or(Compensation::lets_go)
    }

    fn is_in_position(&self) -> bool {
        self.watch.is_in_position(self.distance, self.kind)
    }

    fn fault(&self, kind: ServoFaultKind, limit: f64) -> ServoFault {
        ServoFault { axis: self.axis, kind, value: self.distance, limit }
    }

    fn rename(&mut self, command: &mut Command) {
        let at = command.position[self.axis];
        self.setpoint = at;
        self.position = at;
        self.moves = false;
        if let Some(smoother) = &mut self.smoother {
            smoother.rest();
        }
        if let Some(compensation) = &mut self.compensation {
            command.drive[self.axis] = at + compensation.rename(at);
        }
    }
}

impl Compensation {
    fn new(axis: &AxisConfig, limits: &RampLimits, period: f64, at: f64) -> Option<Compensation> {
        let play = &axis.backlash;
        let is_positive = !play.homes_negative;
        let direction = Direction::new(at, is_positive, play.reversal_step, play.reversal_way);
        let backlash = TakeUp::new(play, limits, period);
        let errors = axis.pitch_errors.as_ref();
        let time = play.time_ms / 1000.0;
        let pitch = errors.and_then(|errors| PitchTable::new(errors, is_positive, time, limits, period));
        (backlash.is_some() || pitch.is_some()).then_some(Compensation { direction, backlash, pitch })
    }

    /// The axis moved by `d` to `at`: what is added, and whether the control has no pitch point there.
    #[inline]
    fn tick(&mut self, d: f64, at: f64, kind: Kind) -> (f64, bool) {
        let side = self.direction.follow(d, at);
        let backlash = self.backlash.as_mut().map_or(0.0, |b| b.tick(side, kind == Kind::Rapid));
        match &mut self.pitch {
            None => (backlash, false),
            Some(table) => (backlash + table.tick(at, side), table.is_beside(at)),
        }
    }

    /// Whether the next move may begin.
    fn lets_go(&self) -> bool {
        self.backlash.as_ref().is_none_or(TakeUp::lets_go)
    }

    /// The machine position of the last number of a pitch point.
    fn end(&self) -> Option<f64> {
        self.pitch.as_ref().map(PitchTable::end)
    }

    /// The place where the axis stands is called `at`: what is added there.
    fn rename(&mut self, at: f64) -> f64 {
        self.direction.rename(at);
        let backlash = self.backlash.as_ref().map_or(0.0, TakeUp::added);
        backlash + self.pitch.as_ref().map_or(0.0, |table| table.added(at))
    }
}
