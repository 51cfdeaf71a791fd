//! Back along the path while a program is held, and forward again to where it was held.
//!
//! The axes go back through the moves that they have come through, within all limits, with overrides and feed hold, as
//! far as motion still knows them and no further than the last thing that was no move: a dwell, an M, S or T code, a
//! thread, a probe. Nothing of the program is done twice: with cycle start the axes go forward again, and the program goes
//! on where it was held.

use super::{Cnc, Given, State};
use crate::report::Activity;
use ferrocut_motion::Sample;
use std::collections::VecDeque;

/// Moves that were passed and can be told by their block.
const PASSED: usize = 4096;

/// What is known of going back.
#[derive(Debug)]
pub(super) struct Retrace {
    /// Moves that were passed, the last one at the end.
    passed: VecDeque<Given>,
    /// The axes are behind the place where the program was held.
    is_behind: bool,
    /// They go back, or went back last.
    is_back: bool,
    /// They go back now.
    goes: bool,
    /// Which way is asked for, back or not, once they stand.
    wanted: Option<bool>,
    /// How far the move under way was run where the program was held, mm or degrees.
    held_at: f64,
}

impl Retrace {
    pub fn new() -> Retrace {
        Retrace {
            passed: VecDeque::with_capacity(PASSED),
            is_behind: false,
            is_back: false,
            goes: false,
            wanted: None,
            held_at: 0.0,
        }
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
        (self.is_behind, self.is_back, self.goes, self.wanted) = (false, false, false, None);
    }

    /// Whether the axes go back.
    pub fn goes(&self) -> bool {
        self.goes
    }

    /// Whether the axes are behind the place where the program was held.
    pub fn is_behind(&self) -> bool {
        self.is_behind
    }
}

impl Cnc {
    /// The axes of a program that is held go back along its path, or forward again with cycle start; whether they will.
    /// Not out of a thread, nor beside the path.
    pub fn retrace(&mut self) -> bool {
        let may = self.state == State::Held
            && self.switches.may_move
            && self.stroke.is_none()
            && self.thread.is_none()
            && self.probing.is_none()
            && self.busy.is_none()
            && self.failed.is_none()
            && !self.homing.is_active()
            && !self.manual.is_active
            && !self.is_aside()
            && self.blocks.is_plain();
        if may && !self.retrace.goes {
            self.retrace.wanted = Some(true);
        }
        may
    }

    /// Whether the axes are behind the place where the program was held, or about to go there.
    pub fn is_retraced(&self) -> bool {
        self.retrace.is_behind || self.retrace.wanted.is_some()
    }

    /// Cycle start: the axes go forward again first; whether they have to.
    pub(super) fn goes_forward(&mut self) -> bool {
        if self.state != State::Held || !self.is_retraced() {
            return false;
        }
        self.stop_retrace();
        self.retrace.wanted = self.retrace.is_behind.then_some(false);
        self.retrace.is_behind
    }

    /// Feed hold: the axes stop where they are on the way back.
    pub(super) fn hold_retrace(&mut self) {
        if self.state == State::Held && self.is_retraced() {
            self.stop_retrace();
        }
    }

    fn stop_retrace(&mut self) {
        (self.retrace.goes, self.retrace.wanted) = (false, None);
        self.motion.hold();
    }

    /// Turns the way of the axes as soon as they stand.
    pub(super) fn turn(&mut self) {
        let Some(back) = self.retrace.wanted.filter(|_| self.state == State::Held && self.motion.is_still())
        else {
            return;
        };
        let Some(turned) = self.motion.retrace(back) else { return };
        self.retrace.wanted = None;
        if back && turned {
            if !self.retrace.is_behind {
                self.retrace.is_behind = true;
                self.retrace.held_at = self.given.front().map_or(0.0, |given| given.travelled);
            }
            (self.retrace.is_back, self.retrace.goes) = (true, true);
            self.motion.resume();
        } else if !back {
            self.retrace.is_back = false;
            self.state = State::Running;
            self.hold = false;
            self.hold_motion();
        }
    }

    /// Nothing before here is run back over.
    pub(super) fn forget_passed(&mut self) {
        self.retrace.forget();
        self.motion.forget_passed();
    }

    /// Follows the axes where they are behind the place where the program was held.
    pub(super) fn follow_retrace(&mut self, sample: &Sample) {
        let way = sample.velocity * self.period;
        let front = self.given.front_mut().filter(|given| given.tag <= sample.tag);
        let given = match front {
            Some(given) if given.tag == sample.tag => {
                given.travelled += if self.retrace.is_back { -way } else { way };
                if !self.retrace.is_back && given.travelled >= self.retrace.held_at {
                    self.retrace.is_behind = false;
                }
                Some(*given)
            }
            // Past it: rounding.
            Some(_) => {
                self.retrace.is_behind &= self.retrace.is_back;
                None
            }
            None => {
                let at = self.retrace.passed.binary_search_by_key(&sample.tag, |given| given.tag);
                at.ok().map(|at| self.retrace.passed[at])
            }
        };
        if let Some(given) = given {
            self.span = given.span;
            self.kind = given.kind();
        }
        if self.motion.is_empty() && self.motion.at_rest() {
            // At the end of what is known, or where the program was held between two moves.
            self.retrace.goes = false;
            self.retrace.is_behind &= self.retrace.is_back;
        }
        self.report.period(given.map_or(Activity::Rapid, |given| given.activity));
    }
}
