//! Axes moved by hand while a program is stopped on its way.
//!
//! **Manual intervention** (GSK990MC part 2, 4.1.4): with cycle start the axes go back to the point where they were
//! taken, as positioning does, and the program goes on from there. **Handwheel and step interruption** (6.2, 5.2):
//! the way that was moved stays; the program goes on beside its own path, with its own coordinates. Both are gone
//! with reset and with an alarm: then the coordinates are those of the place where the axes are.

use super::tapping::ThreadKind;
use super::{Cnc, State};
use ferrocut_geometry::{Axis, Position};

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
    /// Where the axes were when they were taken.
    taken_at: Option<Position>,
    /// The way of manual intervention.
    away: Position,
    /// The way of handwheel interruption.
    pub shift: Position,
    returns: bool,
}

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
            && (self.servo.is_at_rest() || self.manual.is_active)
    }

    /// Whether the axes are beside the path, or on their way back to it.
    pub(super) fn is_aside(&self) -> bool {
        self.aside.returns || self.aside.taken_at.is_some() || self.aside.away != Position::ZERO
    }

    /// Notes that axes are moved by hand from here on.
    pub(super) fn interrupt(&mut self) {
        if self.aside.taken_at.is_none() {
            self.aside.taken_at = Some(self.beside(self.motion.position()));
        }
    }

    /// The axes moved by hand stand at `at`. Whether a program waits for them.
    pub(super) fn stop_aside(&mut self, at: Position) -> bool {
        let Some(from) = self.aside.taken_at.take() else { return false };
        let way = at - from;
        if self.aside.kind == Interruption::Shift && !self.aside.returns {
            self.aside.shift = self.aside.shift + way;
            self.retrace.shift();
        } else {
            self.aside.away = self.aside.away + way;
        }
        if std::mem::take(&mut self.aside.returns) {
            self.aside.away = Position::ZERO;
            // 4.1.4: with single block the program waits at the point.
            if !self.blocks.is_single() {
                self.cycle_start();
            }
        }
        true
    }

    /// Sends the axes back to where they were taken; whether they were elsewhere.
    pub(super) fn return_to_path(&mut self) -> bool {
        if self.aside.away == Position::ZERO
            || !matches!(self.state, State::Held | State::BlockEnd | State::Stopped(_))
        {
            return false;
        }
        let at = self.beside(self.motion.position());
        self.aside.taken_at = Some(at);
        self.aside.returns = true;
        self.manual.take(at);
        for axis in Axis::ALL {
            self.manual.go_by(axis, -self.aside.away[axis]);
        }
        true
    }

    /// Feed hold on the way back: the axes come to rest, and cycle start goes on.
    pub(super) fn hold_return(&mut self) {
        if std::mem::take(&mut self.aside.returns) {
            self.manual.stop();
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
