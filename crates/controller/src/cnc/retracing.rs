//! Back along the path while a program is held, and forward again to where it was held.
//!
//! The axes go back through the moves that they have come through, within all limits, with overrides and feed hold, as
//! far as motion still knows them and no further than the last thing that was no move: a dwell, an M, S or T code, a
//! thread, a probe. Nothing of the program is done twice: outputs that changed in step with motion are passed and stay as
//! they are.
//!
//! With cycle start the axes go forward again and come to rest shortly before the place where the program was held. From
//! there it goes on as from any hold: with the spindle waited for, with dry run and single block as they are now.

use super::{Cnc, Given, State, Tick};
use crate::report::Activity;
use ferrocut_geometry::Position;
use ferrocut_motion::Sample;
use std::collections::VecDeque;

/// Moves that were passed and can be told by their block.
const PASSED: usize = 4096;

/// What is known of going back.
#[derive(Debug, Default)]
pub(super) struct Retrace {
    /// Moves that were passed, the last one at the end.
    passed: VecDeque<Given>,
    way: Way,
    /// What is asked for once the axes stand.
    wanted: Option<Way>,
    /// How far the axes are behind the place where the program was held, along the path, mm or degrees.
    behind: f64,
    /// They are being stopped shortly before it.
    arrives: bool,
    /// The place.
    held_at: Position,
    /// The same, where the program was given up behind it.
    broken_off: Option<Position>,
    /// The axes are in a move before the first that the program still has.
    is_before: bool,
    /// The path that is behind was not run with the handwheel interruption that is in force.
    is_shifted: bool,
}

/// Which way the axes go.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
enum Way {
    /// The program's.
    #[default]
    Program,
    Back,
    /// They stand, behind the place.
    Stand,
    Forward,
}

impl Retrace {
    pub fn new() -> Retrace {
        Retrace { passed: VecDeque::with_capacity(PASSED), ..Retrace::default() }
    }

    /// Notes a move that was passed.
    pub fn passed(&mut self, given: Given) {
        if self.passed.len() == PASSED {
            self.passed.pop_front();
        }
        self.passed.push_back(given);
    }

    /// The program has nothing that the axes could go back through.
    pub fn forget(&mut self) {
        self.passed.clear();
        (self.way, self.wanted) = (Way::Program, None);
        (self.arrives, self.is_shifted, self.is_before) = (false, false, false);
    }

    /// The program is given up.
    pub fn give_up(&mut self) {
        if self.is_behind() {
            self.broken_off = Some(self.held_at);
        }
        self.forget();
    }

    /// Where it was held, if it was given up behind that place.
    pub fn take_broken_off(&mut self) -> Option<Position> {
        self.broken_off.take()
    }

    /// Whether the axes are in a move before the first that the program still has.
    pub fn is_before(&self) -> bool {
        self.is_before
    }

    /// What is behind was run beside this place.
    pub fn shift(&mut self) {
        self.is_shifted = true;
    }

    /// Whether the axes are behind the place where the program was held.
    pub fn is_behind(&self) -> bool {
        self.way != Way::Program
    }

    /// Whether the axes go back.
    pub fn goes_back(&self) -> bool {
        self.way == Way::Back
    }

    /// Whether motion is to be held for it.
    pub fn holds(&self) -> bool {
        self.arrives || self.way == Way::Stand
    }

    /// The move with this mark.
    fn find(&self, tag: u64) -> Option<&Given> {
        let at = self.passed.binary_search_by_key(&tag, |given| given.tag).ok()?;
        self.passed.get(at)
    }
}

impl Cnc {
    /// The axes of a program that is held go back along its path; whether they will. Not out of a thread, nor beside the
    /// path, nor where it was run with another handwheel interruption.
    pub fn retrace(&mut self) -> bool {
        let may = self.state == State::Held
            && self.may_move()
            && self.stroke.is_none()
            && self.thread.is_none()
            && self.probing.is_none()
            && self.touches.is_none()
            && self.busy.is_none()
            && self.failed.is_none()
            && !self.homing.is_active()
            && !self.manual.is_active
            && !self.is_aside()
            && !self.retrace.is_shifted
            && self.blocks.is_plain();
        if may && !self.retrace.goes_back() {
            self.retrace.wanted = Some(Way::Back);
        }
        may
    }

    /// Whether the axes are behind the place where the program was held, or about to go there.
    pub fn is_retraced(&self) -> bool {
        self.retrace.is_behind() || self.retrace.wanted.is_some()
    }

    /// Whether the axes go back, or are about to.
    pub fn goes_back(&self) -> bool {
        self.retrace.goes_back() || self.retrace.wanted == Some(Way::Back)
    }

    /// Cycle start: the axes go forward again first; whether they have to.
    pub(super) fn goes_forward(&mut self) -> bool {
        if self.state != State::Held {
            return false;
        }
        self.stop_retrace();
        self.retrace.wanted = self.retrace.is_behind().then_some(Way::Forward);
        self.retrace.is_behind()
    }

    /// Feed hold: the axes stop where they are on the way.
    pub(super) fn stop_retrace(&mut self) {
        self.retrace.wanted = None;
        if self.retrace.is_behind() {
            (self.retrace.way, self.retrace.arrives) = (Way::Stand, false);
            self.hold_motion();
        }
    }

    /// Turns the way of the axes of a program that is held, as soon as they stand and may move.
    pub(super) fn turn(&mut self) {
        let Some(way) = self.retrace.wanted.filter(|_| self.motion.is_still() && self.may_move()) else {
            return;
        };
        let Some(turned) = self.motion.retrace(way == Way::Back) else { return };
        self.retrace.wanted = None;
        if !turned {
            return;
        }
        if !self.retrace.is_behind() {
            (self.retrace.behind, self.retrace.held_at) = (0.0, self.motion.position());
        }
        // It may have been held as it arrived.
        (self.retrace.way, self.retrace.arrives) = (way, false);
        if way == Way::Forward {
            self.state = State::Running;
            self.hold = false;
        }
        self.hold_motion();
    }

    /// A period on the way forward to the place where the program was held.
    pub(super) fn catch_up(&mut self) -> Tick {
        // Motion begins where it knows enough of what follows.
        self.take_steps();
        if self.state != State::Running {
            return self.slow_down();
        }
        if !self.retrace.arrives && self.retrace.behind <= self.stopping_distance() {
            self.retrace.arrives = true;
            self.hold_motion();
        }
        let has_run_out = self.motion.is_empty() && self.motion.at_rest();
        if has_run_out || self.retrace.arrives && self.motion.is_still() {
            (self.retrace.way, self.retrace.arrives) = (Way::Program, false);
            self.hold_motion();
            return self.at_rest();
        }
        if self.motion.at_rest() && self.cutting_waits() {
            self.report.period(Activity::Spindle);
            return self.at_rest();
        }
        if self.must_settle_now() {
            return self.settle();
        }
        self.move_on()
    }

    /// Nothing before here is run back over.
    pub(super) fn forget_passed(&mut self) {
        self.retrace.forget();
        self.motion.forget_passed();
    }

    /// Follows the axes where they are behind the place where the program was held. Whether they are.
    pub(super) fn follow_retrace(&mut self, sample: &Sample) -> bool {
        self.retrace.is_before = self.given.front().is_some_and(|given| sample.tag < given.tag);
        if !self.retrace.is_behind() && !self.retrace.is_before {
            return false;
        }
        let way = sample.velocity * self.period;
        let way = if self.retrace.goes_back() { way } else { -way };
        self.retrace.behind += way;
        let given = match self.given.front_mut() {
            Some(given) if given.tag == sample.tag => {
                given.travelled -= way;
                Some(*given)
            }
            _ => self.retrace.find(sample.tag).copied(),
        };
        if let Some(given) = given {
            (self.span, self.shown) = (given.span, given.frame.shown);
            self.main_line = given.block.main_line;
            self.kind = given.kind();
            if way != 0.0 {
                self.report.period(given.activity);
            }
        }
        if self.motion.is_at_back_end() {
            self.stop_retrace();
        }
        true
    }
}
