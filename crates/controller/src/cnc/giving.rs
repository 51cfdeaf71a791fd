//! Steps on their way from the program to motion: moves as far as it looks ahead, all else one by one.

use super::tapping::ThreadKind;
use super::{Cnc, Event, Given, State, Waiting};
use crate::programmed::Programmed;
use crate::report::Activity;
use ferrocut_machine::{Alarm, Fault, Severity};
use ferrocut_motion::Move;
use ferrocut_program::Span;
use ferrocut_toolpath::{Feed, Op, PathMode, Port, Step};
use std::time::Instant;

impl Cnc {
    /// Takes steps from the interpreter while motion has room and nothing waits.
    pub(super) fn take_steps(&mut self) {
        if !self.give_later() {
            return;
        }
        let is_free = |cnc: &Cnc| cnc.waiting.is_none() && cnc.busy.is_none() && cnc.stroke.is_none();
        while is_free(self)
            && self.state == State::Running
            && self.motion.free() > 0
            && self.given.len() < self.given.capacity()
            && self.steps_left > 0
            && self.ahead_until.is_none_or(|until| Instant::now() < until)
        {
            if self.program_outputs.is_full() {
                // The moves that it waits for are with motion, which may wait for more of them.
                if self.motion.at_rest() {
                    self.motion.finish();
                }
                return;
            }
            self.steps_left -= 1;
            if let Some(step) = self.sent.next_jog() {
                self.give(step);
                continue;
            }
            if self.sent.is_jogging {
                return;
            }
            match self.next_step() {
                None => return,
                Some(Err(alarm)) if self.sent.refuses => self.sent.refused.push(*alarm),
                Some(Err(alarm)) if alarm.severity == Severity::Warning => {
                    self.events.push_back(Event::Warning(*alarm));
                }
                Some(Err(alarm)) => self.wait_for(Waiting::Alarm(alarm)),
                Some(Ok(step)) => self.take_step(step),
            }
        }
    }

    pub(super) fn wait_for(&mut self, what: Waiting) {
        self.blocks.waiting = Some(self.taken(self.span_of(&what)));
        self.waiting = Some(what);
        self.motion.finish();
    }

    pub(super) fn span_of(&self, waiting: &Waiting) -> Span {
        match waiting {
            Waiting::Step(step) => step.span,
            Waiting::Alarm(alarm) => alarm.span,
            Waiting::Skip => self.given.back().map_or(self.span, |given| given.span),
        }
    }

    pub(super) fn take_step(&mut self, mut step: Step) {
        self.shift_skip(&mut step);
        let mut refused = None;
        let events = &mut self.events;
        // A probe needs no spindle that turns.
        let probes = self.touches.is_some();
        self.supervisor.step(&step, |alarm| match alarm.severity {
            Severity::Warning if probes => {}
            Severity::Warning => events.push_back(Event::Warning(alarm)),
            Severity::Error if refused.is_none() => refused = Some(Box::new(alarm)),
            Severity::Error => {}
        });
        if let Some(alarm) = refused {
            return self.wait_for(Waiting::Alarm(alarm));
        }
        self.give(step);
    }

    /// A feed beyond a limit of the control: motion holds the speed behind the overrides. It has the limits as the program
    /// began; one that was changed since holds before the overrides, and so does any for a thread, which has none.
    fn hold_feed(&self, op: &mut Op) {
        let (feed, path) = match op {
            Op::Feed { feed, path, .. } | Op::Arc { feed, path, .. } => (feed, *path),
            Op::Skip { feed, .. } => (feed, PathMode::ExactStop),
            _ => return,
        };
        if let Feed::Held { at, .. } = *feed
            && (path == PathMode::Tapping || !self.feeds.contains(&at))
        {
            *feed = Feed::PerMinute(at);
        }
    }

    /// Gives a move to motion; any other step waits for it to come to rest, but for an output that changes with the next
    /// move, and a message.
    pub(super) fn give(&mut self, step: Step) {
        if self.keeps_output_for_next_move(&step) {
            return;
        }
        let Some(mut step) = self.keep_message(step) else { return };
        let is_thread = matches!(step.op, Op::Tap { .. });
        let stays = matches!(step.op, Op::Dwell(_) | Op::Output { with_next_move: true, .. });
        if self.is_in(ThreadKind::InStep) && !is_thread && !stays {
            // A program that leaves the thread by another move.
            self.leave_thread();
            if self.state == State::Resetting {
                return;
            }
        }
        if is_thread || step.op.target().is_none() {
            return self.wait_for(Waiting::Step(step));
        }
        if self.feed_stands_still(&step.op) {
            let alarm = Alarm::core(Fault::FeedNotReachable, step.span);
            return self.wait_for(Waiting::Alarm(Box::new(alarm)));
        }
        self.hold_feed(&mut step.op);
        let from = self.commanded;
        let tag = self.next_tag;
        let Some(to) = step.op.target().copied() else { return };
        self.tell_motion_of_spindle();
        let (asked, given) = (self.asked_rpm(), self.given_rpm());
        let Some(motion) = Move::from_step(&step.op, from, given, tag) else { return };
        let feed = match asked == given {
            true => motion.feed(),
            false => Move::from_step(&step.op, from, asked, tag).and_then(|motion| motion.feed()),
        };
        let Some(programmed) = Programmed::new(&step.op, from, feed, tag) else { return };
        let (min, max) = step.op.extent(from).unwrap_or((from, to));
        if let Some(alarm) = self.supervisor.beside((min, max), self.aside.shift, step.span) {
            return self.wait_for(Waiting::Alarm(alarm));
        }
        self.next_tag += 1;
        // A jog is no move of the program, and one that goes nowhere is never run.
        if self.sent.is_jogging || min == max {
            self.program_outputs.pass_over(tag);
        }
        self.commanded = to;
        let activity = if step.op.is_cutting() { Activity::Cutting } else { Activity::Rapid };
        // Degrees of a rotary axis are no distance.
        let is_linear = (0..3).any(|i| from.0[i] != to.0[i]) || step.op.arc(from).is_some();
        let length = if is_linear { step.op.length(from) } else { 0.0 };
        let stops = match &step.op {
            Op::Feed { path: PathMode::WithinBlock(_), .. }
            | Op::Arc { path: PathMode::WithinBlock(_), .. } => false,
            Op::Feed { path, .. } | Op::Arc { path, .. } => *path == PathMode::ExactStop || self.exact_stop,
            // Positioning always ends in position.
            _ => true,
        };
        let (span, block, path_length) = (step.span, self.taken(step.span), step.op.length(from));
        let given = Given {
            tag,
            number: step.block,
            span,
            activity,
            length,
            min,
            max,
            to,
            stops,
            programmed,
            block,
            motion,
            path_length,
            travelled: 0.0,
            frame: self.interpreter.frame_of(&step),
            left: 1.0,
            beside: 0.0,
        };
        // There is room: the callers asked.
        if self.motion.push(&self.paced(&given)) {
            self.given.push_back(given);
        }
        if let Op::Skip { away, ref input, .. } = step.op {
            let input = input.as_ref().and_then(Port::number);
            self.begin_probing(tag, from, away, input);
            if self.probing.is_some() {
                self.wait_for(Waiting::Skip);
            }
        }
    }

    /// Whether a feed per revolution waits for a spindle that does not turn.
    pub(super) fn feed_stands_still(&self, op: &Op) -> bool {
        let (Op::Feed { feed, .. } | Op::Arc { feed, .. } | Op::Skip { feed, .. }) = op else { return false };
        matches!(feed, Feed::PerRevolution(_)) && self.feed_rpm() == 0.0
    }

    /// Counts the moves before the one being run.
    pub(super) fn finish_moves(&mut self, running: u64) {
        while let Some(given) = self.given.front().copied().filter(|g| g.tag < running) {
            self.given.pop_front();
            self.retrace.passed(given);
            let (length, min, max) = match self.braked_way(given.tag) {
                Some((from, to)) => (from.distance(to), from.min(to), from.max(to)),
                None => (given.length, given.min, given.max),
            };
            self.report.finished(given.activity, length, min, max);
        }
    }
}
