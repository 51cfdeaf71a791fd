//! A program that is sent while it runs, and moves by hand in a straight line that come the same way (`$J=` of
//! Grbl).
//!
//! Motion begins once a path is known to its end, or far enough. What comes bit by bit has no such end, so that two
//! times decide for it: where nothing came for [`PATIENCE_S`] what is there is run to its end, and a path of a slow
//! sender does not wait longer than [`LONGEST_WAIT_S`] for more. A sender that is late so costs a stop on the path,
//! and never a move that is not at rest where the path ends.

use super::{Cnc, State};
use ferrocut_geometry::Position;
use ferrocut_interpreter::AtRest;
use ferrocut_machine::Alarm;
use ferrocut_program::{Refused, Span};
use ferrocut_toolpath::{Feed, Op, PathMode, Step};
use std::collections::VecDeque;

/// How long a path waits for more before it is run to its end, s: a few answers of a slow connection.
const PATIENCE_S: f64 = 0.05;

/// How long a path that is being sent waits before it begins, s.
const LONGEST_WAIT_S: f64 = 2.0;

/// Moves by hand that wait at most.
const MOST_JOGS: usize = 32;

/// What a program that is sent needs beside others.
#[derive(Debug, Default)]
pub(super) struct Sent {
    /// An alarm of a block is told, and the blocks behind it go on.
    pub refuses: bool,
    pub refused: Vec<Alarm>,
    /// The axes are moved by hand in lines.
    pub is_jogging: bool,
    jogs: VecDeque<Step>,
    /// The jog is to end at once.
    cancels: bool,
    /// End of the last jog taken.
    jog_end: Position,
    /// Since when nothing came, s.
    starved: f64,
    /// Since when a path waits to begin, s.
    waiting: f64,
    /// Speed asked of a spindle that was stopped in a hold, r/min, clockwise positive.
    stopped_spindle: Option<f64>,
}

impl Sent {
    pub fn next_jog(&mut self) -> Option<Step> {
        self.jogs.pop_front()
    }
}

impl Cnc {
    /// An alarm of a block is told by [`refused`](Self::refused), and the blocks behind it go on: whoever sends them
    /// decides. The interpreter needs its option `keep_going`.
    pub fn refuse_blocks(&mut self, refuses: bool) {
        self.sent.refuses = refuses;
    }

    /// Takes the alarms of blocks that were refused since the last call.
    pub fn refused(&mut self) -> Vec<Alarm> {
        std::mem::take(&mut self.sent.refused)
    }

    /// More of a program that is sent. Refused as a whole where there is no room until blocks are done.
    pub fn append(&mut self, text: &[u8]) -> Result<(), Refused> {
        // Text is kept for whoever shows the block that is run.
        self.interpreter.own().give_back(self.span);
        match self.interpreter.own().append(text) {
            // Blocks that give no step leave the machine where it is, at one far before them.
            Err(Refused::Full) if self.awaits_work() => {
                self.interpreter.own().give_back_read();
                self.interpreter.own().append(text)?;
            }
            taken => taken?,
        }
        self.sent.starved = 0.0;
        if matches!(self.state, State::Ended | State::Reset) && self.interpreter.is_open() {
            self.interpreter.own().go_on();
            self.state = State::Ready;
        }
        Ok(())
    }

    /// Nothing more of the program comes.
    pub fn end_text(&mut self) {
        self.interpreter.own().end_text();
    }

    /// Number of the last line of a program that is sent which was taken: its moves are given to motion, all else
    /// of it is done.
    pub fn lines_done(&self) -> u32 {
        let read = self.interpreter.lines_done();
        let read = self.held_line().map_or(read, |line| read.min(line.saturating_sub(1)));
        match self.waiting.is_some() || self.busy.is_some() || self.stroke.is_some() {
            // What waits is of the line read last, or of one before.
            true => read.min(self.waiting_line().saturating_sub(1)),
            // What was waited for has just ended: the line is done once what is behind it was asked for, so that
            // whoever hears of it finds the machine idle.
            false if self.stands() && !self.interpreter.is_starved() => read.saturating_sub(1),
            false => read,
        }
    }

    /// Line of what waits for motion to come to rest or is done beside it.
    fn waiting_line(&self) -> u32 {
        self.waiting.as_ref().map_or(self.span, |waiting| self.span_of(waiting)).line
    }

    /// Whether a program runs that has no move under way.
    fn stands(&self) -> bool {
        self.state == State::Running && self.motion.is_empty() && self.motion.at_rest()
    }

    /// Whether the axes stand and nothing that came is left to do.
    pub fn awaits_work(&self) -> bool {
        let waits = self.waiting.is_some() || self.busy.is_some() || self.stroke.is_some();
        match self.state {
            State::Running => {
                let jogs = self.sent.is_jogging || !self.sent.jogs.is_empty();
                self.stands() && !waits && !jogs && self.interpreter.is_starved()
            }
            State::Held | State::Resetting => false,
            _ => !self.manual.is_active,
        }
    }

    /// How many lines motion has room for.
    pub fn room(&self) -> usize {
        self.motion.room()
    }

    /// A move by hand in a straight line to a machine position, at a feed in mm/min whatever the override. Others
    /// may follow before it ends, and join it. Refused with the alarm of a limit that it passes.
    ///
    /// `Ok(false)`: not now, since a program has the axes or too many wait.
    pub fn jog_to(&mut self, to: Position, feed: f64) -> Result<bool, Box<Alarm>> {
        let is_free = self.state == State::Running && (self.sent.is_jogging || self.awaits_work());
        if !is_free || self.sent.cancels || self.sent.jogs.len() >= MOST_JOGS {
            return Ok(false);
        }
        let from = if self.sent.is_jogging { self.sent.jog_end } else { self.commanded };
        let op = Op::Feed { to, feed: Feed::PerMinute(feed), path: PathMode::FullFeed };
        let step = Step::new(op, Span::default(), 0);
        if let Some(alarm) = self.supervisor.refusal(from, &step) {
            return Err(alarm);
        }
        self.sent.is_jogging = true;
        self.sent.jog_end = to;
        self.sent.starved = 0.0;
        self.sent.jogs.push_back(step);
        Ok(true)
    }

    /// Whether the axes are moved by hand in lines.
    pub fn is_jogging(&self) -> bool {
        self.sent.is_jogging
    }

    /// Brings the axes of a jog to rest at once; what is left of it is forgotten.
    pub fn cancel_jog(&mut self) {
        if self.sent.is_jogging {
            self.sent.cancels = true;
            self.sent.jogs.clear();
            self.motion.abort();
        }
    }

    /// Whether what is left of a jog is forgotten as soon as the axes are at rest.
    pub(super) fn is_jog_cancelled(&self) -> bool {
        self.sent.cancels
    }

    /// Stops the spindle in a hold, or starts it as it was. The axes wait until it has its speed.
    pub fn stop_spindle(&mut self, stops: bool) {
        if stops {
            let asked = self.spindle.asked();
            self.sent.stopped_spindle.get_or_insert(asked);
            self.spindle.tell(0.0);
        } else if let Some(rpm) = self.sent.stopped_spindle.take() {
            let seconds = self.spindle.tell(rpm);
            // A dwell that is under way goes on behind it no longer than it would have.
            if self.busy.is_none() {
                self.keep_busy(super::Activity::Spindle, seconds);
            }
        }
    }

    /// Once a period: whether a path that waits for more begins, or is run to its end. Blocks of a program that are still
    /// read are waited for no longer than what a sender has not sent.
    pub(super) fn wait_for_more(&mut self) {
        if self.state != State::Running {
            return;
        }
        let is_open = self.sent.is_jogging || self.interpreter.is_open();
        let is_starved = self.sent.jogs.is_empty() && (self.sent.is_jogging || self.interpreter.is_starved());
        self.sent.starved = if is_open && is_starved { self.sent.starved + self.period } else { 0.0 };
        let waits = self.motion.at_rest() && !self.motion.is_empty() && (is_open || self.interpreter.waits());
        self.sent.waiting = if waits { self.sent.waiting + self.period } else { 0.0 };
        let longest = if is_open { LONGEST_WAIT_S } else { PATIENCE_S };
        if self.sent.starved >= PATIENCE_S || self.sent.waiting >= longest {
            self.motion.finish();
        }
    }

    /// The axes stand at the end of all that came: whether it is one where more may come. A jog ends here.
    pub(super) fn is_between_lines(&mut self) -> bool {
        if self.sent.is_jogging && self.sent.jogs.is_empty() {
            self.end_jog();
        }
        self.sent.is_jogging || self.interpreter.is_starved()
    }

    fn forget_jog(&mut self) {
        self.sent.jogs.clear();
        (self.sent.is_jogging, self.sent.cancels) = (false, false);
    }

    /// What was held, a jog or a spindle, does not come back.
    pub(super) fn forget_held(&mut self) {
        self.forget_jog();
        self.sent.stopped_spindle = None;
    }

    fn end_jog(&mut self) {
        self.forget_jog();
        let at = self.motion.position();
        self.given.clear();
        self.commanded = at;
        self.supervisor.moved_to(at);
        self.interpreter.own().came_to_rest(&AtRest::new(at, self.actual));
    }
}
