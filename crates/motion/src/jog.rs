//! Axes moved by hand: continuous jog, steps, handwheel. Each axis for itself, within its velocity, acceleration and
//! jerk at every moment, and never beyond its software limits.
//!
//! In: commands, at any time. Out: one position a servo period ([`Jog::tick`]). Commands take effect at the
//! next period, from whatever state the axis is in.
//!
//! A command makes a course of at most seven phases (see `course.rs` for the mathematics): to rest at a place, or to
//! rest at once. Continuous jog is the way to the software limit at the wanted speed, or to infinity where there is
//! none, so that an axis brakes for its limit in time without anybody watching it.
//!
//! # Never beyond the limits
//!
//! Every course that is run ends at rest within the limits and stays within them. A new one is begun only if it does
//! too; otherwise the old one goes on, and the new one is tried again in the next period. That is so where an axis
//! brakes hard at a limit to turn round and the key is let go: with the jerk that leads to rest, braking would cease
//! at once, and the axis would come farther than it does by turning. Once it has turned, the new course is begun.
//!
//! # No drift
//!
//! Steps and the wheel count in whole hundredths of a micron from where the axis stood, so that a million of them
//! forth and back end where they began, bit by bit.

mod course;

use crate::Limits;
use course::{At, Bounds, Course};
use ferrocut_geometry::{AXES, Axis, Position};
use ferrocut_machine::Machine;

/// What becomes of counts that come faster than the axis may follow (GSK990MC 6.1.3, 56#0).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Surplus {
    /// The axis runs all of them, however late.
    Kept,
    /// They are lost: the axis stays no farther behind the wheel than it needs to brake.
    Dropped,
}

/// Software limits of an axis, mm or degrees: the lower and the upper.
pub type Travel = (f64, f64);

/// The axes, moved by hand.
#[derive(Clone, Debug)]
pub struct Jog {
    axes: [AxisJog; AXES],
    period: f64,
}

/// Units that increments are counted in, per mm or degree; also a tenth of the least inch increment of 0.0001 inch is
/// a whole number of them.
const UNITS: f64 = 1e5;

/// Counts of the handwheel that wait at most: ten turns.
const MOST_KEPT: f64 = 1000.0;

/// Farthest place that is counted to where there is no limit, in units: 10 km.
const MOST_UNITS: i64 = 1_000_000_000_000;

/// Distance from a whole unit that sums leave, mm.
const ON_UNIT: f64 = 1e-9;

/// How far rounding may lead a course over a limit, mm; what is put out is cut off there.
const OVER_LIMIT: f64 = 1e-10;

/// An axis without jerk limit reaches its acceleration in this time, s.
const AT_ONCE: f64 = 1e-6;

/// A place by whole units from an origin.
#[derive(Clone, Copy, PartialEq, Debug)]
struct Mark {
    origin: f64,
    units: i64,
}

impl Mark {
    /// The mark at `place`. Where that is a whole number of units they are counted from 0.
    fn new(place: f64) -> Mark {
        let units = (place * UNITS).round();
        match units.abs() <= MOST_UNITS as f64 && (units / UNITS - place).abs() <= ON_UNIT {
            true => Mark { origin: 0.0, units: units as i64 },
            false => Mark { origin: place, units: 0 },
        }
    }

    fn place(&self) -> f64 {
        self.origin + self.units as f64 / UNITS
    }

    /// As many units on, within the limits.
    fn on(self, units: i64, (least, most): Travel) -> Mark {
        let units = self.units.saturating_add(units).clamp(-MOST_UNITS, MOST_UNITS);
        let mark = Mark { units, ..self };
        let place = mark.place();
        if place > most {
            Mark::new(most)
        } else if place < least {
            Mark::new(least)
        } else {
            mark
        }
    }
}

/// What an axis shall do.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Wanted {
    Rest,
    /// Go on at this speed, with sign.
    Speed(f64),
    /// Come to rest there, no faster than this.
    Place(Mark, f64),
}

#[derive(Clone, Copy, Debug)]
struct AxisJog {
    /// Highest speed.
    velocity: f64,
    bounds: Bounds,
    travel: Travel,
    wanted: Wanted,
    /// Whether what is wanted has no course yet.
    is_new: bool,
    /// Counts were lost at a limit: whether at the upper one.
    lost_at: Option<bool>,
    course: Course,
    /// Where the course began.
    start: f64,
    /// Where it ends, if it leads to a place.
    goal: Option<f64>,
    /// Periods since.
    periods: u64,
    now: At,
}

impl Jog {
    /// The axes of `machine` at rest at `start`, within its software limits. An axis that the machine lacks does
    /// not move.
    pub fn new(machine: &Machine, start: Position) -> Jog {
        let limits = Limits::new(machine);
        let axes = std::array::from_fn(|i| {
            let of = |values: &[f64; AXES]| values.get(i).copied().unwrap_or(f64::INFINITY);
            let config = machine.axes.iter().find(|axis| axis.name.index() == i);
            let acceleration = of(&limits.acceleration);
            let travel = config.map_or(NO_TRAVEL, |axis| (axis.min, axis.max));
            let velocity = if config.is_some() { of(&limits.rapid).max(of(&limits.velocity)) } else { 0.0 };
            AxisJog {
                velocity,
                bounds: Bounds { acceleration, jerk: of(&limits.jerk).min(acceleration / AT_ONCE) },
                travel,
                wanted: Wanted::Rest,
                is_new: false,
                lost_at: None,
                course: Course::REST,
                start: start.0.get(i).copied().unwrap_or(0.0),
                goal: None,
                periods: 0,
                now: At { s: start.0.get(i).copied().unwrap_or(0.0), v: 0.0, a: 0.0 },
            }
        });
        Jog { axes, period: machine.servo_period_ms / 1000.0 }
    }

    /// Software limits of an axis, or none, as before homing. Only an axis at rest takes them; whether it did.
    /// One that stands beyond moves back only.
    pub fn set_travel(&mut self, axis: Axis, travel: Option<Travel>) -> bool {
        self.axis(axis).is_some_and(|axis| {
            let takes = axis.is_at_rest();
            if takes {
                axis.travel = travel.unwrap_or(NO_TRAVEL);
            }
            takes
        })
    }

    /// Moves an axis on at `speed`, mm/s with sign, until another command; 0 stops it.
    pub fn run(&mut self, axis: Axis, speed: f64) {
        let Some(axis) = self.axis(axis) else { return };
        let speed = if speed.is_finite() { speed.clamp(-axis.velocity, axis.velocity) } else { 0.0 };
        axis.want(if speed == 0.0 { Wanted::Rest } else { Wanted::Speed(speed) });
    }

    /// Moves an axis to `place`, no faster than `speed`, mm/s, or as far as its limits let it.
    pub fn go(&mut self, axis: Axis, place: f64, speed: f64) {
        let Some(axis) = self.axis(axis) else { return };
        if place.is_finite() && speed > 0.0 {
            let (least, most) = axis.reach();
            axis.lost_at = None;
            axis.want(Wanted::Place(Mark::new(place.clamp(least, most)), speed.min(axis.velocity)));
        }
    }

    /// Moves an axis by `steps` increments (mm or degrees, a multiple of 0.00001) at no more than `speed`, mm/s.
    /// Steps add up; those beyond a limit are lost.
    pub fn step(&mut self, axis: Axis, steps: i64, increment: f64, speed: f64) {
        if let Some(axis) = self.axis(axis) {
            axis.count(steps, increment, speed);
        }
    }

    /// Moves an axis by counts of the handwheel, each an increment (mm or degrees, a multiple of 0.00001), at no more
    /// than `speed`, mm/s. Counts beyond a limit are lost, so that turning back moves at once.
    pub fn wheel(&mut self, axis: Axis, counts: i64, increment: f64, speed: f64, surplus: Surplus) {
        let period = self.period;
        let Some(axis) = self.axis(axis) else { return };
        let counts = match surplus {
            Surplus::Kept => axis.kept(counts, increment),
            Surplus::Dropped => axis.followed(counts, increment, speed, period),
        };
        axis.count(counts, increment, speed);
    }

    /// Stops all axes as soon as their jerk allows.
    pub fn stop(&mut self) {
        for axis in &mut self.axes {
            axis.want(Wanted::Rest);
        }
    }

    /// Goes on by a period; where the axes shall be at its end.
    pub fn tick(&mut self) -> Position {
        for axis in &mut self.axes {
            axis.tick(self.period);
        }
        self.position()
    }

    /// Where the axes are.
    pub fn position(&self) -> Position {
        Position(self.axes.map(|axis| axis.now.s))
    }

    /// Speed of every axis, mm/s.
    pub fn velocity(&self) -> Position {
        Position(self.axes.map(|axis| axis.now.v))
    }

    /// Whether all axes stand where they were told to.
    pub fn is_at_rest(&self) -> bool {
        self.axes.iter().all(AxisJog::is_at_rest)
    }

    /// Whether an axis stands where it was told to; one that the machine lacks always does.
    pub fn stands(&self, axis: Axis) -> bool {
        self.axes.get(axis.index()).is_none_or(AxisJog::is_at_rest)
    }

    /// The limit at which an axis stands although it was told to go on, by a speed, by steps or by counts: whether it is
    /// the upper one.
    pub fn is_cut_short(&self, axis: Axis) -> Option<bool> {
        self.axes.get(axis.index()).filter(|axis| axis.is_at_rest()).and_then(AxisJog::cut_at)
    }

    /// The axes stand at `at` from here on, whatever they did.
    pub fn rename(&mut self, at: Position) {
        for (axis, place) in self.axes.iter_mut().zip(at.0) {
            *axis = AxisJog {
                wanted: Wanted::Rest,
                is_new: false,
                lost_at: None,
                course: Course::REST,
                start: place,
                goal: None,
                periods: 0,
                now: At { s: place, v: 0.0, a: 0.0 },
                ..*axis
            };
        }
    }

    fn axis(&mut self, axis: Axis) -> Option<&mut AxisJog> {
        self.axes.get_mut(axis.index()).filter(|axis| axis.velocity > 0.0)
    }
}

/// No software limits.
const NO_TRAVEL: Travel = (f64::NEG_INFINITY, f64::INFINITY);

impl AxisJog {
    fn is_at_rest(&self) -> bool {
        !self.is_new && self.is_done()
    }

    fn is_done(&self) -> bool {
        self.course.time == 0.0
    }

    /// The limit behind which what is wanted leads.
    fn cut_at(&self) -> Option<bool> {
        match self.wanted {
            Wanted::Rest => None,
            Wanted::Speed(speed) => Some(speed > 0.0),
            Wanted::Place(..) => self.lost_at,
        }
    }

    fn want(&mut self, wanted: Wanted) {
        if wanted != self.wanted {
            self.wanted = wanted;
            self.is_new = true;
        }
    }

    /// The limits, widened to where the axis stands already.
    fn reach(&self) -> Travel {
        (self.travel.0.min(self.now.s), self.travel.1.max(self.now.s))
    }

    /// The place that counts are counted from.
    fn mark(&self) -> Mark {
        match self.wanted {
            Wanted::Place(mark, _) => mark,
            _ => Mark::new(course::rest(self.now, &self.bounds)),
        }
    }

    fn count(&mut self, counts: i64, increment: f64, speed: f64) {
        let units = (increment * UNITS).round();
        if counts == 0 || !(speed > 0.0) || !(units.abs() <= MOST_UNITS as f64) {
            return;
        }
        let (counts, (least, most)) = (counts.saturating_mul(units as i64), self.reach());
        let mark = self.mark().on(counts, (least, most));
        let asked = self.mark().on(counts, NO_TRAVEL).place();
        self.lost_at =
            (asked > most + ON_UNIT).then_some(true).or_else(|| (asked < least - ON_UNIT).then_some(false));
        self.want(Wanted::Place(mark, speed.min(self.velocity)));
    }

    /// How many of the counts are run, where all are: those that wait are [`MOST_KEPT`] at most.
    fn kept(&self, counts: i64, increment: f64) -> i64 {
        let waiting = (self.mark().place() - self.now.s) / increment;
        let room = |sign: f64| (MOST_KEPT - sign * waiting).clamp(0.0, MOST_KEPT) as i64;
        if waiting.is_finite() { counts.clamp(-room(-1.0), room(1.0)) } else { 0 }
    }

    /// How many of the counts the axis follows: it may be behind the wheel by the way that it brakes in, and what it
    /// runs in a period.
    fn followed(&self, counts: i64, increment: f64, speed: f64, period: f64) -> i64 {
        let speed = speed.min(self.velocity);
        let sign = if (counts < 0) == (increment < 0.0) { 1.0 } else { -1.0 };
        let behind = sign * (self.mark().place() - self.now.s);
        let most = Course::stop(speed, 0.0, &self.bounds).end + speed * period;
        if behind > most {
            return 0;
        }
        // One count more than fits, so that a coarse wheel moves a slow axis.
        let fits = ((most - behind) / increment.abs()).min(1e15) as i64;
        counts.clamp(fits.saturating_add(1).saturating_neg(), fits.saturating_add(1))
    }

    /// The course to what is wanted, from here, and the place that it leads to.
    fn plan(&self) -> (Course, Option<f64>) {
        let At { s, v, a } = self.now;
        let (least, most) = self.reach();
        let to = |place: f64, speed: f64| {
            let place = place.clamp(least, most);
            (Course::to(place - s, v, a, speed, &self.bounds), Some(place))
        };
        match self.wanted {
            Wanted::Rest => (Course::stop(v, a, &self.bounds), None),
            Wanted::Speed(speed) => to(if speed > 0.0 { most } else { least }, speed.abs()),
            Wanted::Place(mark, speed) => to(mark.place(), speed),
        }
    }

    /// Begins the course to what is wanted, if it stays within the limits.
    fn begin(&mut self) {
        let (course, goal) = self.plan();
        let (least, most) = course.extent();
        let reach = self.reach();
        if self.now.s + least < reach.0 - OVER_LIMIT || self.now.s + most > reach.1 + OVER_LIMIT {
            return;
        }
        (self.course, self.goal) = (course, goal);
        (self.start, self.periods) = (self.now.s, 0);
        self.is_new = false;
        if self.is_done() {
            // On its place but for rounding.
            self.now = At { s: goal.unwrap_or(self.now.s), v: 0.0, a: 0.0 };
        }
    }

    #[inline]
    fn tick(&mut self, period: f64) {
        if self.is_new {
            self.begin();
        }
        if self.is_done() {
            return;
        }
        self.periods += 1;
        let time = self.periods as f64 * period;
        let At { s, v, a } = self.course.at(time);
        let (least, most) = self.reach();
        self.now = At { s: (self.start + s).clamp(least, most), v, a };
        if time >= self.course.time {
            // A place is reached bit by bit, whatever the way there was.
            self.now.s = self.goal.unwrap_or(self.now.s);
            self.course = Course::REST;
        }
    }
}
