//! Messages of programs. One between two moves is told as the second begins, and the path runs on over it, as on LinuxCNC;
//! where no move is under way it is told at once.

use super::{Cnc, Event};
use ferrocut_toolpath::{Op, Step};
use std::collections::VecDeque;

/// Messages that wait for moves, most at once.
const MOST: usize = 64;

/// Messages that are not told yet, in the order of the moves that they wait for.
#[derive(Debug)]
pub(super) struct Messages(VecDeque<(u64, Box<str>)>);

impl Messages {
    pub fn new() -> Messages {
        Messages(VecDeque::with_capacity(MOST))
    }

    /// What waits is not told.
    pub fn forget(&mut self) {
        self.0.clear();
    }
}

impl Cnc {
    /// Keeps a message for the next move, where the path runs on into that; else the step comes back.
    pub(super) fn keep_message(&mut self, step: Step) -> Option<Step> {
        let runs_on = !self.given.is_empty() && !self.blocks.stops_behind_taken();
        match step.op {
            Op::Message(text) if runs_on && self.messages.0.len() < MOST => {
                self.messages.0.push_back((self.next_tag, text));
                None
            }
            _ => Some(step),
        }
    }

    /// The move with this mark is being run, or none with a lower one is left: what waited for it, or for one before it, is
    /// done.
    pub(super) fn comes_to_move(&mut self, running: u64) {
        self.change_outputs(running);
        self.tell_messages(running);
    }

    /// Tells the messages that waited for the move with this mark, or for one before it.
    pub(super) fn tell_messages(&mut self, running: u64) {
        while self.messages.0.front().is_some_and(|(tag, _)| *tag <= running) {
            let Some((_, text)) = self.messages.0.pop_front() else { return };
            self.events.push_back(Event::Message(text));
        }
    }
}
