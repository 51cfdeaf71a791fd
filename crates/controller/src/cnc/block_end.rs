//! Stops at the end of a block: single block, a line to stop at, and whoever asks that the block under way is the
//! last one for now (a change of mode, GSK990MC part 2, 8.4).
//!
//! With single block on, motion is given one block at a time. Where a stop is asked for while motion looks ahead,
//! the path is braked so that it comes to rest shortly before the end of the block; the moves of the blocks behind
//! are taken back, and what is left of the block is run to its very end. A block too short to be stopped at is
//! passed, as any point of a path that cannot be braked before it, and the next one is the last.

use super::{Cnc, Given, State, Waiting};
use ferrocut_interpreter::Shown;
use ferrocut_machine::Alarm;
use ferrocut_program::{FileId, Span};
use ferrocut_toolpath::Step;
use std::collections::VecDeque;

/// A block, told from those before and behind it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Block {
    file: FileId,
    offset: u64,
    line: u32,
    /// Which of the blocks begun by the program it is: a loop may run the same one again and again.
    number: u64,
    /// Its part, which single block takes for a block ([`Step::section`]).
    section: u32,
    /// Its line in the main program: within a subprogram that of the call.
    pub main_line: u32,
}

impl Block {
    fn at(span: Span, number: u64) -> Block {
        Block { file: span.file, offset: span.offset, line: span.line, number, section: 0, main_line: 0 }
    }

    /// Whether both are of one block, in one pass.
    fn is_part_of(&self, other: Block) -> bool {
        Block { section: other.section, main_line: other.main_line, ..*self } == other
    }

    /// Which of the blocks begun it is, where that is known.
    pub fn number(&self) -> Option<u64> {
        (self.number != UNKNOWN).then_some(self.number)
    }

    /// Whether this is its text, in whichever pass.
    fn is_at(&self, span: Span) -> bool {
        (self.file, self.offset) == (span.file, span.offset)
    }
}

/// The number of a block that none is known of.
const UNKNOWN: u64 = u64::MAX;

/// How far a stop in the middle of what motion has come.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
enum Stage {
    /// Nothing is to be stopped.
    #[default]
    Off,
    /// The path is being braked.
    Braking,
    /// What is left of the block is run, and what is behind it waits in [`Blocks::later`].
    Finishing,
}

/// What is known of blocks.
#[derive(Debug)]
pub(super) struct Blocks {
    single: bool,
    /// The block under way is the last one for now.
    asked: bool,
    /// The program stops behind this line of this file.
    stop_line: Option<(FileId, u32)>,
    /// The block being run, and the one taken last from the interpreter or given last to motion.
    run: Option<Block>,
    taken: Option<Block>,
    /// The block of what waits for rest.
    pub waiting: Option<Block>,
    /// What was taken from the interpreter and belongs to a block that does not begin yet.
    next: Option<Result<Step, Box<Alarm>>>,
    /// Moves that were taken back from motion.
    later: VecDeque<Given>,
    stage: Stage,
    /// Everything that motion was given is to be given again, since its speeds have changed.
    renew: bool,
    /// Motion is being braked for a block behind which the program stops.
    meets_line: bool,
}

impl Blocks {
    pub fn new(room: usize) -> Blocks {
        Blocks {
            single: false,
            asked: false,
            stop_line: None,
            run: None,
            taken: None,
            waiting: None,
            next: None,
            later: VecDeque::with_capacity(room),
            stage: Stage::Off,
            renew: false,
            meets_line: false,
        }
    }

    /// Forgets what was to come. Single block and the line to stop at stay.
    pub fn forget(&mut self) {
        self.asked = false;
        self.next = None;
        self.later.clear();
        self.stage = Stage::Off;
        self.renew = false;
        self.waiting = None;
        self.begin();
    }

    /// The next block may begin, whatever was before it.
    pub fn begin(&mut self) {
        (self.run, self.taken) = (None, None);
    }

    /// Whether there is a block at all behind which the program stops.
    fn may_stop(&self) -> bool {
        self.single || self.asked || self.stop_line.is_some()
    }

    fn stops_behind(&self, block: Block) -> bool {
        let is_single = self.single && block.section != Step::PASSED;
        is_single || self.asked || self.stop_line == Some((block.file, block.line))
    }

    /// Whether both are one block, or with single block one part of it.
    fn is_one(&self, one: Block, other: Block) -> bool {
        one.is_part_of(other) && (!self.single || one.section == other.section)
    }

    /// Whether a block may be taken, or given to motion, behind what was taken before.
    fn may_take(&self, block: Block) -> bool {
        self.taken.is_none_or(|taken| self.is_one(taken, block) || !self.stops_behind(taken))
    }

    /// Whether the program stops behind the block that was taken last.
    pub fn stops_behind_taken(&self) -> bool {
        self.taken.is_some_and(|taken| self.stops_behind(taken))
    }

    /// Whether the program stops before this block.
    fn stops_before(&self, block: Block) -> bool {
        self.run.is_some_and(|run| !self.is_one(run, block) && self.stops_behind(run))
    }

    /// Whether single block is on.
    pub fn is_single(&self) -> bool {
        self.single
    }

    /// Whether nothing was taken back from motion.
    pub fn is_plain(&self) -> bool {
        self.stage == Stage::Off && self.later.is_empty()
    }

    /// Whether motion is being braked for the end of a block.
    pub fn is_braking(&self) -> bool {
        self.stage == Stage::Braking
    }
}

impl Cnc {
    /// Forgets what was to come of the program, read ahead or not.
    pub(super) fn forget_blocks(&mut self) {
        self.blocks.forget();
        self.program_outputs.forget_waiting();
        self.messages.forget();
        self.interpreter.forget();
    }

    /// Single block: the program stops behind every block.
    pub fn set_single_block(&mut self, on: bool) {
        self.blocks.single = on;
        self.interpreter.set_single_block(on);
    }

    /// The block under way is the last one for now: the program stops at its end, as with single block.
    pub fn finish_block(&mut self) {
        if self.state == State::Running {
            self.blocks.asked = true;
        }
    }

    /// Takes [`finish_block`](Self::finish_block) back.
    pub fn do_not_finish_block(&mut self) {
        self.blocks.asked = false;
    }

    /// Whether the program is running to the end of a block to stop there, because that was asked for.
    pub fn finishes_block(&self) -> bool {
        self.blocks.asked && self.state == State::Running
    }

    /// The program stops once behind this line of a file, counted from 1 (GSK990MC part 2, 3.4.1, stop number).
    pub fn stop_behind(&mut self, line: Option<(FileId, u32)>) {
        self.blocks.stop_line = line;
        self.interpreter.set_stop_line(line);
    }

    /// The line behind which it is still to stop.
    pub fn stops_behind(&self) -> Option<(FileId, u32)> {
        self.blocks.stop_line
    }

    /// What motion has is given to it again, since speeds have changed.
    pub(super) fn renew_moves(&mut self) {
        self.blocks.renew = !self.given.is_empty();
    }

    /// The block of something from the interpreter.
    fn block_of(&self, next: &Result<Step, Box<Alarm>>) -> Block {
        match next {
            Ok(step) => {
                let block = Block::at(step.span, step.block);
                Block { section: step.section, main_line: step.main_line, ..block }
            }
            // It is of the block that was begun last, or of one that a stage which looks ahead holds back.
            Err(alarm) => {
                let frame = self.interpreter.frame();
                if frame.last.holds(alarm.span) {
                    return Block { main_line: frame.main_line, ..Block::at(frame.last, frame.begun) };
                }
                let same = self.blocks.taken.filter(|taken| taken.is_at(alarm.span));
                same.unwrap_or(Block::at(alarm.span, UNKNOWN))
            }
        }
    }

    /// The next thing from the interpreter, if its block may begin. With `None` nothing may be taken now.
    pub(super) fn next_step(&mut self) -> Option<Result<Step, Box<Alarm>>> {
        let next = match self.blocks.next.take() {
            Some(next) => Some(next),
            None => self.next_from_ladder(),
        };
        let Some(next) = next else {
            // What is sent bit by bit may go on in time, and what is read beside.
            if !self.interpreter.is_starved() && !self.interpreter.waits() {
                self.motion.finish();
            }
            return None;
        };
        let block = self.block_of(&next);
        if !self.blocks.may_take(block) {
            self.blocks.next = Some(next);
            self.motion.finish();
            return None;
        }
        self.blocks.taken = Some(block);
        Some(next)
    }

    /// Line of what was taken from the interpreter and does not begin yet.
    pub(super) fn held_line(&self) -> Option<u32> {
        let later = self.blocks.later.front().map(|given| given.span.line);
        let of = |next: &Result<Step, Box<Alarm>>| match next {
            Ok(step) => step.span.line,
            Err(alarm) => alarm.span.line,
        };
        later.or(self.blocks.next.as_ref().map(of))
    }

    /// The last block behind the one under way that was read with a value in force, as `uses` says of what is. Where the block
    /// under way has it in force, of those that take it anew if they are to `take` it.
    pub fn read_with(&self, takes: bool, uses: impl Fn(&Shown) -> bool) -> Option<Span> {
        if !self.is_under_way() {
            return None;
        }
        let running = self.taking_up.at.0;
        let next = self.blocks.next.as_ref().and_then(|next| next.as_ref().ok());
        let next = next.filter(|step| step.op.target().is_some());
        let moves = self.given.iter().chain(&self.blocks.later);
        let read = moves.map(|given| (given.number, given.frame.shown, given.span));
        let read =
            read.chain(next.map(|step| (step.block, self.interpreter.frame_of(step).shown, step.span)));
        let (mut was, mut last) = (takes && uses(&self.shown), None);
        for (_, shown, span) in read.filter(|(number, ..)| *number > running) {
            let is = uses(&shown);
            was &= is;
            if is && !was {
                last = Some(span);
            }
        }
        last
    }

    /// The block behind the one being run for which the machine does something, as far as the program was read.
    pub fn next_span(&self) -> Option<Span> {
        if !self.is_under_way() {
            return None;
        }
        let (running, at) = (self.taking_up.at.0, (self.span.file, self.span.line));
        let given = self.given.iter().chain(&self.blocks.later).map(|given| (given.number, given.span));
        let of_alarm = |alarm: &Alarm| (running, alarm.span);
        let waiting = self.waiting.as_ref().map(|waiting| match waiting {
            Waiting::Step(step) => (step.block, step.span),
            Waiting::Alarm(alarm) => of_alarm(alarm),
            Waiting::Skip => (running, self.span_of(waiting)),
        });
        let taken = self.blocks.next.as_ref().map(|next| match next {
            Ok(step) => (step.block, step.span),
            Err(alarm) => of_alarm(alarm),
        });
        // In a loop the one behind it may be the same once more.
        let is_behind = |number: u64, span: Span| number != running || (span.file, span.line) != at;
        let mut behind = given.chain(waiting).chain(taken);
        behind.find(|(number, span)| is_behind(*number, *span) && span.line > 0).map(|(_, span)| span)
    }

    /// The block of what was taken last.
    pub(super) fn taken(&self, span: Span) -> Block {
        self.blocks.taken.unwrap_or(Block::at(span, 0))
    }

    /// Gives motion the moves that were taken back from it; whether all are given.
    pub(super) fn give_later(&mut self) -> bool {
        if self.blocks.later.is_empty() {
            return true;
        }
        while let Some(given) = self.blocks.later.front().copied() {
            if !self.blocks.may_take(given.block) {
                self.motion.finish();
                return false;
            }
            if self.motion.free() == 0 || !self.motion.push(&self.paced(&given)) {
                return false;
            }
            self.blocks.later.pop_front();
            self.blocks.taken = Some(given.block);
            self.given.push_back(given);
        }
        self.blocks.stage = Stage::Off;
        if self.waiting.is_some() {
            self.motion.finish();
        }
        true
    }

    /// Moves that motion gave back, and has not taken again.
    pub(super) fn later(&self) -> impl Iterator<Item = &Given> {
        self.blocks.later.iter()
    }

    /// Notes which block is being run.
    pub(super) fn runs(&mut self, block: Block) {
        self.blocks.run = Some(block);
    }

    /// Whether the program stops here, motion being at rest with nothing left.
    pub(super) fn is_at_block_end(&self) -> bool {
        self.block_behind().is_some_and(|block| self.blocks.stops_before(block))
    }

    /// The block of what comes next, motion being at rest with nothing left.
    fn block_behind(&self) -> Option<Block> {
        let waiting = self.blocks.waiting.filter(|_| self.waiting.is_some());
        let next = self.blocks.next.as_ref().map(|next| self.block_of(next));
        let later = self.blocks.later.front().map(|given| given.block);
        later.or(waiting).or(next)
    }

    /// Stopped at the end of a block: the line of the main program that comes next; none within a block.
    pub fn main_line_behind(&self) -> Option<u32> {
        let is_behind = self.state == State::BlockEnd && !self.is_within_block();
        let next = self.block_behind().filter(|next| is_behind && next.main_line > 0)?;
        Some(next.main_line)
    }

    /// Whether what comes next is of the block being run, motion being at rest with nothing left.
    fn is_within_block(&self) -> bool {
        let pair = self.block_behind().zip(self.blocks.run);
        pair.is_some_and(|(next, run)| next.is_part_of(run))
    }

    /// The program stops at the end of a block.
    pub(super) fn end_block(&mut self) {
        self.state = State::BlockEnd;
        self.blocks.asked = false;
        // Behind a part of the block, the line is still to be stopped at.
        if let Some(run) = self.blocks.run
            && self.blocks.stop_line == Some((run.file, run.line))
            && !self.is_within_block()
        {
            self.stop_behind(None);
        }
    }

    /// Looks after the end of the block being run, where motion has more than that.
    pub(super) fn watch_block_end(&mut self) {
        if self.gives_up_move() {
            // It is being braked, and what is left of it is not given again.
            if self.blocks.is_braking() {
                self.blocks.stage = Stage::Off;
                self.hold_motion();
            }
            self.blocks.renew = false;
            return;
        }
        match self.blocks.stage {
            // The move that would be taken back has not begun.
            Stage::Off if self.retrace.is_before() => {}
            Stage::Off => {
                let is_ended = self.ends_within(self.stopping_distance());
                if !self.given.is_empty() && (self.blocks.renew || is_ended) {
                    self.blocks.stage = Stage::Braking;
                    self.blocks.meets_line = is_ended;
                    self.hold_motion();
                }
            }
            Stage::Braking if self.motion.is_still() => {
                self.motion.abort();
                // Else it comes with the next period.
                if self.motion.is_empty() {
                    self.take_back();
                }
            }
            _ => {}
        }
    }

    /// Takes all moves back from motion, which has forgotten them at rest, and gives those that may be run now.
    fn take_back(&mut self) {
        let at = self.motion.position();
        if let Some(first) = self.given.front_mut() {
            first.left = first.programmed.left(at, first.travelled, first.path_length);
            first.beside = first.programmed.distance(at).unwrap_or(0.0);
        }
        while let Some(given) = self.given.pop_back() {
            self.blocks.later.push_front(given);
        }
        self.blocks.renew = false;
        self.blocks.stage = Stage::Finishing;
        self.blocks.taken = None;
        // A line that was named when it was all but run may be passed: then the program stops behind the block that it is at.
        let line = self.blocks.stop_line.filter(|_| std::mem::take(&mut self.blocks.meets_line));
        if let Some(line) = line
            && !self.blocks.later.iter().any(|given| (given.block.file, given.block.line) == line)
        {
            self.blocks.asked = true;
            self.stop_behind(None);
        }
        self.hold_motion();
        self.give_later();
    }

    /// Whether the move being run ends where it is braked: its probe has touched, or its jog is cancelled.
    fn gives_up_move(&self) -> bool {
        self.probing.is_some_and(|probing| probing.has_touched()) || self.is_jog_cancelled()
    }

    /// Whether a block behind which the program stops ends within a way, mm or degrees, and motion has more than that.
    fn ends_within(&self, way: f64) -> bool {
        if !self.blocks.may_stop() {
            return false;
        }
        let mut left = 0.0;
        for (given, next) in self.given.iter().zip(self.given.iter().skip(1)) {
            left += (given.path_length - given.travelled).max(0.0);
            if left > way {
                return false;
            }
            if !self.blocks.is_one(given.block, next.block) && self.blocks.stops_behind(given.block) {
                return true;
            }
        }
        false
    }

    /// Length in which the path surely comes to rest, mm or degrees.
    pub(super) fn stopping_distance(&self) -> f64 {
        let v = self.velocity;
        let [a, j] = self.braking;
        // From a constant speed: 2·√(v/j) s where the acceleration is not reached, else v/a + a/j; at half the
        // speed on average. A curve, and a path that speeds up, need more: twice as much, and two periods.
        let time = if v * j >= a * a { v / a + a / j } else { 2.0 * (v / j).sqrt() };
        // A hold takes over somewhat later.
        v * (time + ferrocut_motion::LEAD_S) + 2.0 * v * self.period
    }
}
