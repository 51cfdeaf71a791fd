//! Feed, spindle and coolant: F, S and what follows from them (GSK990MC 4.2, 5).

use crate::Fallible;
use crate::dialect::{GCode, MFunction, Meaning};
use crate::interpreter::Interpreter;
use crate::modal::Group;
use crate::stages::units;
use ferrocut_geometry::{Axis, AxisSet, Turn};
use ferrocut_machine::Fault;
use ferrocut_program::Span;
use ferrocut_toolpath::{Op, Speed, SpindleState};

impl Interpreter {
    /// Whether F of the block is the speed of positioning: G00 stands in it, or its words are positioned to
    /// (Weihong 4.1).
    pub(crate) fn is_rapid_block(&self, axes: AxisSet) -> bool {
        let names_rapid = self.words.g.iter().any(|g| g.row.meaning == Meaning::Rapid);
        let moves = !axes.is_empty() && !self.words.stands_for_motion();
        self.in_force(Group::Motion, Meaning::Rapid) && self.cycle_kind().is_none() && (names_rapid || moves)
    }

    /// F: feed in force until the next one. Feed per minute is kept as programmed and held within the
    /// control's limits where it is used; feed per revolution beyond its range is an alarm (7.2.2).
    pub(crate) fn feed_word(&mut self) -> Fallible<()> {
        let Some(f) = self.words.get(b'F') else { return Ok(()) };
        let unit = units::length_mm(1.0, self.modal.is_inch());
        let feed = f * unit;
        self.technology.feed_unit = unit;
        if self.modal.is_feed_per_revolution() {
            if !(feed > 0.0 && feed <= self.rules.max_feed_per_revolution) {
                return Err(self.alarm_at(Fault::FeedOutOfRange, b'F'));
            }
            self.technology.feed_per_revolution = feed;
        } else {
            if feed <= 0.0 {
                return Err(self.alarm_at(Fault::FeedOutOfRange, b'F'));
            }
            self.technology.feed_per_minute_was_given = true;
            self.technology.feed_per_minute = feed;
        }
        Ok(())
    }

    /// F of positioning, in force until the next one.
    pub(crate) fn rapid_feed_word(&mut self) -> Fallible<()> {
        let Some(f) = self.words.get(b'F') else { return Ok(()) };
        let feed = units::length_mm(f, self.modal.is_inch());
        if feed <= 0.0 {
            return Err(self.alarm_at(Fault::FeedOutOfRange, b'F'));
        }
        self.technology.rapid_feed = Some(feed);
        Ok(())
    }

    /// S: kept as programmed, and told to a spindle that turns. A surface speed is kept apart: G96 without S
    /// takes the last one, and none is 0 (GSK990MC 6.3).
    pub(crate) fn speed_word(&mut self) -> Fallible<()> {
        let Some(s) = self.words.get(b'S') else { return Ok(()) };
        let orients = || self.words.m.iter().any(|code| code.row.function == MFunction::Orient);
        if self.rules.orients_to_speed_word && orients() {
            return Ok(());
        }
        if s > self.rules.max_speed_word {
            return Err(self.alarm_at(Fault::SpindleTooFast, b'S'));
        }
        match self.is_surface_speed() {
            true => self.technology.surface_speed = Some(units::length_mm(s, self.modal.is_inch())),
            false => {
                let speed = self.speed_of(s);
                if self.held_speed(speed) < speed {
                    let warning = self.alarm_at(Fault::SpindleTooFast, b'S');
                    let limit = self.rules.max_spindle_rpm;
                    self.tell(warning.with("speed", speed).with("limit", limit));
                }
                self.technology.speed = Some(speed);
            }
        }
        // With the sense that the block gives it is told there.
        let turns = |function: MFunction| {
            use MFunction::{Orient, SpindleClockwise, SpindleCounterClockwise, SpindleOff};
            matches!(function, SpindleClockwise | SpindleCounterClockwise | SpindleOff | Orient)
        };
        if !self.words.m.iter().any(|code| turns(code.row.function)) {
            self.tell_speed();
        }
        Ok(())
    }

    /// What S says: turns, or the number of a gear in its last two digits, whatever stands before them (GSK990MC 6.2).
    fn speed_of(&self, s: f64) -> f64 {
        if self.rules.speed_is_gear { s % 100.0 } else { s }
    }

    /// A speed within the limit. Turns beyond it are held there (GSK990MC part 2, 7.10); a gear is no speed.
    pub(crate) fn held_speed(&self, speed: f64) -> f64 {
        if self.rules.speed_is_gear { speed } else { speed.min(self.rules.max_spindle_rpm) }
    }

    /// The highest S that a person may set, r/min (GSK990MC part 2, 3.1.2: P258).
    pub fn max_spindle_rpm(&self) -> f64 {
        self.rules.max_spindle_rpm
    }

    /// A person sets S between programs: it is in force as if a block had said it, and what the machine is told of it is
    /// the caller's affair. What the spindle is to do now, where a program left it turning.
    pub fn set_spindle_speed(&mut self, s: f64) -> Option<SpindleState> {
        match self.in_force(Group::SurfaceSpeed, Meaning::SurfaceSpeed) {
            true => self.technology.surface_speed = Some(units::length_mm(s, self.modal.is_inch())),
            false => self.technology.speed = Some(self.speed_of(s)),
        }
        let turn = self.technology.spindle.turn()?;
        self.technology.spindle = SpindleState::turning(turn, self.speed());
        Some(self.technology.spindle)
    }

    /// How the spindle turns as a program begins. An S starts none that stands, and turns none round.
    pub fn finds_spindle(&mut self, turn: Option<Turn>) {
        if self.technology.spindle.turn() != turn {
            let speed = self.speed();
            self.technology.spindle =
                turn.map_or(SpindleState::Off, |turn| SpindleState::turning(turn, speed));
        }
    }

    /// Tells a spindle that turns its speed.
    pub(crate) fn tell_speed(&mut self) {
        let speed = self.speed();
        if let Some(turn) = self.technology.spindle.turn() {
            self.spindle(SpindleState::turning(turn, speed));
        }
    }

    /// Whether S is a surface speed (G96).
    pub fn is_surface_speed(&self) -> bool {
        self.in_force(Group::SurfaceSpeed, Meaning::SurfaceSpeed)
    }

    /// The speed in force.
    pub(crate) fn speed(&self) -> Speed {
        if !self.is_surface_speed() {
            return Speed::Rpm(self.held_speed(self.technology.speed.unwrap_or(0.0)));
        }
        let axis = self.technology.surface_axis;
        let max = self.technology.surface_max_rpm.unwrap_or(self.rules.max_spindle_rpm);
        Speed::Surface {
            mm_per_min: self.technology.surface_speed.unwrap_or(0.0),
            min_rpm: self.rules.surface_min_rpm,
            max_rpm: Some(max.min(self.rules.max_spindle_rpm)),
            axis,
            // The centre is the zero of the work coordinate system (6.3, 3).
            center: self.location.work.shift[axis] + self.location.length.vector[axis],
        }
    }

    /// G96 and G97 (GSK990MC 6.3). Where surface speed is not fitted G96 changes nothing.
    pub(crate) fn surface_speed(&mut self, row: &'static GCode, span: Span) -> Fallible<()> {
        if !self.rules.surface_speed {
            return Ok(());
        }
        let was = self.speed();
        self.modal.set(row);
        if row.meaning == Meaning::SurfaceSpeed {
            if !self.p_is_taken(row.meaning)
                && let Some(number) = self.words.take(b'P')
            {
                let axis = self.rules.axis_order.get((number - 1.0).max(-1.0) as usize).copied();
                let is_carried = |axis: &Axis| self.rules.axes.contains(*axis);
                match axis.filter(is_carried).filter(|_| number >= 1.0 && number.fract() == 0.0) {
                    Some(axis) => self.technology.surface_axis = axis,
                    None => return Err(self.alarm(Fault::SurfaceSpeedAxis, span)),
                }
            }
            if !self.words.has(b'S') {
                self.tell_speed();
            }
            return Ok(());
        }
        // The turns of the moment go on where G97 gives no S.
        if let Speed::Surface { .. } = was {
            self.technology.speed = Some(was.rpm(&self.location.machine));
            if !self.words.has(b'S') {
                self.tell_speed();
            }
        }
        Ok(())
    }

    /// Tells the spindle, unless it is as told already.
    pub(crate) fn spindle(&mut self, state: SpindleState) {
        if self.options.every_code || self.technology.spindle != state {
            self.technology.spindle = state;
            self.emit(Op::Spindle(state));
        }
    }

    pub(crate) fn coolant(&mut self, on: bool) {
        if self.options.every_code || self.technology.coolant != on {
            self.technology.coolant = on;
            self.emit(Op::Coolant(on));
        }
    }
}
