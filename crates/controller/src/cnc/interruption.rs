//! Axes moved by hand while a program is stopped on its way.
//!
//! **Manual intervention** (GSK990MC part 2, 4.1.4): with cycle start the axes go back to the point where they were
//! taken, as positioning does, and the program goes on from there. **Handwheel and step interruption** (6.2, 5.2):
//! the way that was moved stays; the program goes on beside its own path, with its own coordinates. Both are gone
//! with reset and with an alarm: then the coordinates are those of the place where the axes are.

use super::tapping::ThreadKind;
use super::{Cnc, State};
use crate::programmed::Way;
use ferrocut_geometry::{Axis, Position};
use ferrocut_machine::Alarm;

/// What becomes of a way by hand while a program is stopped.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Interruption {
    /// Nobody may move the axes.
    #[default]
    Refused,
    /// Manual intervention: the axes go back.
    Return,
    /// Handwheel or step interruption: the way stays.
    Shift,
}

/// Where the axes are beside the path of the program, mm and degrees.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Aside {
    kind: Interruption,
    /// Where the axes were when they were taken, and for what: a change of mode on the way changes nothing.
    taken: Option<(Position, Interruption)>,
    /// The way of manual intervention.
    away: Position,
    /// The way of handwheel interruption.
    pub shift: Position,
    returns: bool,
}

/// What is nearer to the point where the axes were taken is there, mm and degrees: less than any unit of a drive.
const BACK: f64 = 1e-6;

impl Cnc {
    /// Says what a way by hand is while a program is stopped on its way, as by feed hold.
    pub fn set_interruption(&mut self, kind: Interruption) {
        self.aside.kind = kind;
    }

    /// The way of handwheel interruption in force, mm and degrees.
    pub fn handwheel_shift(&self) -> Position {
        self.aside.shift
    }

    /// Whether the axes are on their way back from manual intervention.
    pub fn returns(&self) -> bool {
        self.aside.returns
    }

    /// Forgets the handwheel interruption of an axis (6.2.1), or of all: where the axis stands has the coordinates of
    /// that place again. Not while a program is under way or axes move; whether it did.
    pub fn clear_handwheel_shift(&mut self, axis: Option<Axis>) -> bool {
        if !self.is_idle() {
            return false;
        }
        let mut at = self.motion.position();
        for axis in Axis::ALL.into_iter().filter(|other| axis.is_none_or(|axis| axis == *other)) {
            at[axis] += self.aside.shift[axis];
            self.aside.shift[axis] = 0.0;
        }
        self.stand_at(at);
        true
    }

    /// A place of the program's path, where the axes are now.
    pub(super) fn beside(&self, place: Position) -> Position {
        place + self.aside.shift + self.aside.away
    }

    /// Whether a program is stopped on its way, and its axes may be moved by hand.
    pub(super) fn may_be_interrupted(&self) -> bool {
        self.aside.kind != Interruption::Refused
            && matches!(self.state, State::Held | State::BlockEnd | State::Stopped(_))
            && self.motion.is_still()
            && self.stroke.is_none()
            && !self.is_in(ThreadKind::InStep)
            && !self.is_retraced()
            && !self.aside.returns
            // What is moved for another end comes to rest first.
            && self.aside.taken.is_none_or(|(_, kind)| kind == self.aside.kind)
            && (self.servo.is_at_rest() || self.manual.is_active)
    }

    /// Whether the axes are beside the path, or on their way back to it.
    pub(super) fn is_aside(&self) -> bool {
        self.aside.returns || self.aside.taken.is_some() || self.aside.away != Position::ZERO
    }

    /// Notes that axes are moved by hand from here on.
    pub(super) fn interrupt(&mut self) {
        if self.aside.taken.is_none() {
            self.aside.taken = Some((self.beside(self.motion.position()), self.aside.kind));
        }
    }

    /// The axes moved by hand stand at `at`. Whether a program waits for them.
    pub(super) fn stop_aside(&mut self, at: Position) -> bool {
        let Some((from, kind)) = self.aside.taken.take() else { return false };
        let way = at - from;
        if kind == Interruption::Shift {
            self.aside.shift = self.aside.shift + way;
            self.retrace.shift();
        } else {
            self.aside.away = self.aside.away + way;
        }
        // Who stopped on the way back has a rest before him, and stands where he is.
        if std::mem::take(&mut self.aside.returns) && self.aside.away.0.iter().all(|way| way.abs() < BACK) {
            self.aside.away = Position::ZERO;
            // 4.1.4: with single block the program waits at the point.
            if !self.blocks.is_single() {
                self.cycle_start();
            }
        }
        true
    }

    /// Why the axes may not be sent back to where they were taken: each goes there by itself, so that they may come
    /// anywhere between here and there, and an area that is forbidden lies there (GSK990MC part 2, 2.6).
    pub fn way_back_alarm(&self) -> Option<Box<Alarm>> {
        if self.aside.away == Position::ZERO {
            return None;
        }
        let at = self.beside(self.motion.position());
        let referenced = self.homing.referenced();
        let ways = Axis::ALL.map(|axis| if referenced.contains(axis) { -self.aside.away[axis] } else { 0.0 });
        let alarm = self.interpreter.stroke_between(at, at + Position(ways), self.frame().stroke_check)?;
        Some(Box::new(Alarm { span: self.span, ..*alarm }))
    }

    /// Why a program that is stopped may not go on as far beside its path as it was moved (GSK990MC part 2, 6.2): what it was
    /// given already passes a software limit there. What follows is judged as it is given.
    pub fn shift_alarm(&self) -> Option<Box<Alarm>> {
        let at = self.motion.position();
        let left = self.given.iter().enumerate().map(|(k, given)| match given.programmed.way {
            // The axes are in it.
            Way::Line(_, to) if k == 0 => (at.min(to), at.max(to), given.span),
            _ => (given.min, given.max, given.span),
        });
        let later = self.later().map(|given| (given.min, given.max, given.span));
        left.chain(later)
            .find_map(|(min, max, span)| self.supervisor.beside((min, max), self.aside.shift, span))
    }

    /// Sends the axes back to where they were taken; whether they were elsewhere. Without the permission of the interlock they
    /// stay, and so does the program.
    pub(super) fn return_to_path(&mut self) -> bool {
        if self.aside.away == Position::ZERO
            || !matches!(self.state, State::Held | State::BlockEnd | State::Stopped(_))
        {
            return false;
        }
        if !self.may_move() {
            return true;
        }
        let at = self.beside(self.motion.position());
        self.aside.taken = Some((at, Interruption::Return));
        self.aside.returns = true;
        self.manual.take(at);
        for axis in Axis::ALL {
            self.manual.go_at_rapid(axis, at[axis] - self.aside.away[axis]);
        }
        true
    }

    /// On the way back the axes come to rest, and cycle start goes on.
    pub(super) fn hold_return(&mut self) {
        if std::mem::take(&mut self.aside.returns) {
            self.manual.stop();
        }
    }

    /// Areas that are forbidden are judged where programs are read. One that runs beside its own path may come into one
    /// all the same: there the axes come to rest.
    pub(super) fn watch_strokes(&mut self, at: &Position) {
        if self.aside.shift == Position::ZERO || self.state != State::Running || self.failed.is_some() {
            return;
        }
        if let Some(alarm) = self.interpreter.stroke_between(*at, *at, self.frame().stroke_check) {
            self.come_to_rest();
            self.failed = Some(Box::new(Alarm { span: self.span, ..*alarm }));
        }
    }

    /// The program is given up, the axes being at rest: the coordinates are those of where they are.
    pub(super) fn absorb(&mut self) {
        let at = self.beside(self.motion.position());
        self.aside = Aside { kind: self.aside.kind, ..Aside::default() };
        if at != self.motion.position() {
            self.motion.rename(at);
            self.supervisor.moved_to(at);
        }
    }
}
