//! The order of blocks: one after the other, through jumps, loops and subprograms, to the end.

use crate::Fallible;
use crate::barrier::Present;
use crate::custom::{Custom, Suspended};
use crate::interpreter::{Fingerprint, Interpreter};
use crate::search::Mark;
use ferrocut_machine::{Alarm, Fault};
use ferrocut_program::{
    Block, FileId, Page, Place, ProgramId, ProgramMemory, Span, Statement, Text, Value, Word,
};
use ferrocut_toolpath::{Dwell, Op, Step};
use rustc_hash::FxHashMap;
use std::io;
use std::sync::Arc;

/// A subprogram or macro being run.
#[derive(Clone, Debug)]
struct Call {
    /// First block of the program called.
    program: Place,
    /// Block after the call.
    back: Place,
    /// How often it is still to be run again.
    repeats: u32,
    /// Number of the caller's program.
    number: f64,
    /// The caller's local variables, where the call has its own (a macro call).
    locals: Option<Locals>,
    /// The block set aside, where the program stands for one of its codes.
    suspended: Option<Box<Suspended>>,
}

/// The local variables #1 and on of one level.
pub(crate) type Locals = Box<[Option<f64>]>;

/// Blocks run without a step before a program is taken for endless: seconds of work, and more than
/// any program that cuts needs between two moves.
const IDLE_BLOCKS: u64 = 50_000_000;

/// Passes of a main program that ends with M99, where the machine's state never repeats.
const MAX_PASSES: u64 = 10_000;

/// Blocks that further passes of such a program are looked through for its end: a second of work at most.
const MAX_LOOKED_THROUGH: u64 = 1_000_000;

/// Jumps back at a desk before a program is taken for endless: hours of a machine's work.
const MAX_JUMPS_BACK: u64 = 50_000_000;

/// The same behind a fault, where further findings are looked for: what would end a loop may be what is at fault.
const IDLE_BLOCKS_BEHIND_FAULT: u64 = 1_000_000;
const MAX_JUMPS_BACK_BEHIND_FAULT: u64 = 10_000;

/// Loops and conditions open at once.
const MAX_OPEN: usize = 10_000;

/// Jumps and loops remembered; beyond it they are searched again.
const MAX_REMEMBERED: usize = 65_536;

/// Where execution stands.
#[derive(Clone, Debug)]
pub(crate) struct Flow {
    /// The next block.
    place: Place,
    /// The page of `place`, taken out while one of its blocks is executed.
    page: Option<Arc<Page>>,
    calls: Vec<Call>,
    /// A block set aside that goes on now.
    resumed: Option<Box<Suspended>>,
    /// Whether a block other than its O word was run of the present program.
    entered: bool,
    /// Span of the block run last.
    last: Span,
    /// Line of the main program's block run last: within a subprogram that of its call.
    main_line: u32,
    /// A branch of a condition that was jumped to, since those before do not hold.
    branch: Option<Place>,
    /// The beginning of a loop that counts, come to from its end.
    again: Option<Place>,
    idle: u64,
    /// Blocks begun so far.
    begun: u64,
    /// Which part of the present block steps are of.
    section: u32,
    /// Where blocks are no longer begun.
    mark: Option<Mark>,
    passes: u64,
    /// A further pass of the main program comes to its end, or is looked through for it.
    ends_later: bool,
    /// It is only looked whether M99 P leads on.
    looks_ahead: bool,
    /// What M99 P of a block was come to with, where it leads further up.
    rounds: FxHashMap<Place, Fingerprint>,
    jumps_back: u64,
    /// How many there had been at the first fault behind which the program is looked through further.
    jumps_at_fault: Option<u64>,
    /// Where a jump from a block to a sequence number leads.
    targets: FxHashMap<(Place, u32), Place>,
    /// The loops of a program, by its first block.
    loops: FxHashMap<Place, Arc<Loops>>,
}

/// The loops of one program, found when the first of them is run.
#[derive(Debug, Default)]
struct Loops {
    /// From the block of DO to that of its END.
    ends: FxHashMap<Place, Place>,
    /// From the block of END to that of its DO.
    starts: FxHashMap<Place, Place>,
    /// From a branch of a condition to the next one: from `$IF` to `$ELSEIF`, `$ELSE` or `$ENDIF`.
    branches: FxHashMap<Place, Place>,
    /// From a branch to the end of its condition.
    joins: FxHashMap<Place, Place>,
}

/// What was opened and is not closed yet.
enum Open {
    /// A loop with a label.
    Labelled(u16),
    /// `$WHILE`.
    While,
    /// `$FOR`.
    For,
    /// `$IF`: its branches so far, and whether the last one was `$ELSE`.
    If(Vec<Place>, bool),
}

impl Flow {
    pub(crate) fn new() -> Flow {
        Flow {
            place: Place::default(),
            page: None,
            calls: Vec::new(),
            resumed: None,
            entered: false,
            last: Span::default(),
            main_line: 0,
            branch: None,
            again: None,
            idle: 0,
            begun: 0,
            section: 0,
            mark: None,
            passes: 0,
            ends_later: false,
            looks_ahead: false,
            rounds: FxHashMap::default(),
            jumps_back: 0,
            jumps_at_fault: None,
            targets: FxHashMap::default(),
            loops: FxHashMap::default(),
        }
    }

    /// The program is at fault here and is looked through further.
    pub(crate) fn goes_on_behind_fault(&mut self) {
        self.jumps_at_fault.get_or_insert(self.jumps_back);
    }

    pub(crate) fn jump(&mut self, to: Place) {
        if to <= self.place {
            self.jumps_back += 1;
        }
        self.place = to;
        self.page = None;
    }

    /// A program begun within: at this block.
    pub(crate) fn start_at(&mut self, place: Place) {
        *self = Flow { place, entered: true, ..Flow::new() };
    }

    /// Notes that a step was made: the program gets on.
    #[inline]
    pub(crate) fn got_on(&mut self) {
        self.idle = 0;
    }

    /// Notes a hole of a repeated cycle, which may move nothing.
    #[inline]
    pub(crate) fn count_hole(&mut self) {
        self.idle += 1;
    }

    /// Blocks begun so far, each pass counted. A block that waited for the machine is begun once.
    #[inline]
    pub(crate) fn begun(&self) -> u64 {
        self.begun
    }

    /// Span of the block run last.
    #[inline]
    pub(crate) fn last(&self) -> Span {
        self.last
    }

    /// Line of the main program's block run last, counted from 1; 0 before the first.
    #[inline]
    pub(crate) fn main_line(&self) -> u32 {
        self.main_line
    }

    /// Which part of the present block steps are of ([`Step::section`](ferrocut_toolpath::Step::section)).
    #[inline]
    pub(crate) fn section(&self) -> u32 {
        self.section
    }

    /// What follows is another part of the block: with single block the control stops before it too.
    pub(crate) fn begin_section(&mut self) {
        self.section += 1;
    }

    /// Where blocks are no longer begun.
    #[inline]
    pub(crate) fn mark(&self) -> Option<&Mark> {
        self.mark.as_ref()
    }

    /// Whether it is only looked whether M99 P leads on.
    pub(crate) fn looks_ahead(&self) -> bool {
        self.looks_ahead
    }

    pub(crate) fn set_mark(&mut self, mark: Option<Mark>) {
        self.mark = mark;
    }

    /// Whether the block that comes is marked, so that it is not begun.
    #[inline]
    fn stops_before(&mut self, at: Place) -> bool {
        let begun = self.begun;
        self.mark.as_mut().is_some_and(|mark| mark.stops_before(at, begun))
    }

    /// The subprograms and macros being run.
    pub(crate) fn depth_of_calls(&self) -> usize {
        self.calls.len()
    }

    /// Sets a block aside until the program just called returns.
    pub(crate) fn suspend(&mut self, block: Suspended) {
        if let Some(call) = self.calls.last_mut() {
            call.suspended = Some(Box::new(block));
        }
    }

    /// Whether the program that stands for a code is being run.
    pub(crate) fn runs_custom(&self, code: Custom) -> bool {
        self.calls.iter().any(|call| call.suspended.as_ref().is_some_and(|s| s.code() == code))
    }

    /// First block of the program being run.
    fn program(&self) -> Place {
        self.calls.last().map_or(Place::default(), |call| call.program)
    }

    /// The block to be run next.
    pub(crate) fn next_place(&self) -> Place {
        self.place
    }

    /// Begins a program in the middle of a text, of which `lines` were read.
    pub(crate) fn go_on_at(&mut self, place: Place, lines: u32) {
        self.place = place;
        self.last.line = lines;
    }

    /// Line of the block run last.
    pub(crate) fn last_line(&self) -> u32 {
        self.last.line
    }

    /// The block being executed.
    pub(crate) fn executing(&self) -> Place {
        Place { block: self.place.block.saturating_sub(1), ..self.place }
    }

    fn depth(&self, of_macros: bool) -> usize {
        self.calls.iter().filter(|call| call.locals.is_some() == of_macros).count()
    }

    /// The page and index of the next block; `None` past the end of the text.
    fn next(&mut self, programs: &mut ProgramMemory) -> io::Result<Option<(Arc<Page>, usize)>> {
        loop {
            let page = match self.page.take() {
                Some(page) => page,
                None => match programs.page(self.place.file, self.place.page)? {
                    Some(page) => page,
                    None => return Ok(None),
                },
            };
            let index = self.place.block as usize;
            if index < page.blocks.len() {
                return Ok(Some((page, index)));
            }
            self.place = Place { page: self.place.page + 1, block: 0, ..self.place };
        }
    }
}

/// Calls `see` with the blocks of a program from `from` on, to its end: the next O word, or the end
/// of the file. Stops where `see` returns something.
fn blocks_of_program<R>(
    programs: &mut ProgramMemory,
    program: Place,
    from: Place,
    mut see: impl FnMut(&Page, &Block, Place) -> Option<R>,
) -> io::Result<Option<R>> {
    let mut at = from;
    while let Some(page) = programs.page(at.file, at.page)? {
        for block in page.blocks.get(at.block as usize..).unwrap_or(&[]) {
            let is_number = page.words(block).first().is_some_and(|word| word.letter == b'O');
            if is_number && at != program {
                return Ok(None);
            }
            if let Some(found) = see(&page, block, at) {
                return Ok(Some(found));
            }
            at.block += 1;
        }
        at = Place { page: at.page + 1, block: 0, ..at };
    }
    Ok(None)
}

/// The sequence number of a block.
fn sequence_number(page: &Page, block: &Block) -> Option<f64> {
    let first = page.words(block).first().filter(|word| word.letter == b'N')?;
    match first.value() {
        Value::Number(number) => Some(number),
        Value::Expression(_) | Value::Text(_) => None,
    }
}

/// Whether N of a block is the number of a parameter: beside G10, and from G10 L50 or L51 to G11. `among` is whether the
/// blocks are among parameters.
fn is_data(page: &Page, block: &Block, among: &mut bool) -> bool {
    let has = |letter: u8, number: f64| {
        page.words(block).iter().any(|word| word.letter == letter && word.value() == Value::Number(number))
    };
    if *among {
        // M codes end it too (GSK990MC 4.2.7 note 8).
        *among = !has(b'G', 11.0) && !page.words(block).iter().any(|word| word.letter == b'M');
        return *among;
    }
    let sets = has(b'G', 10.0);
    *among = sets && (has(b'L', 50.0) || has(b'L', 51.0));
    sets
}

impl Loops {
    /// Pairs the beginnings and ends of a program's loops and conditions.
    fn find(programs: &mut ProgramMemory, program: Place) -> io::Result<Result<Loops, (Fault, Span)>> {
        let mut loops = Loops::default();
        let mut open: Vec<(Open, Place, Span)> = Vec::new();
        let fault = blocks_of_program(programs, program, program, |page, block, at| {
            let span = page.block_span(block);
            let mismatch = Some((Fault::LoopMismatch, span));
            if open.len() >= MAX_OPEN {
                return Some((Fault::InvalidLoop, span));
            }
            match page.statement(block)? {
                Statement::While { label, .. } => {
                    if !(1..=3).contains(label) {
                        return Some((Fault::InvalidLoop, span));
                    }
                    // A loop in a loop with its own label would cross it (GSK990MC 4.9.5).
                    if open.iter().any(|(o, _, _)| matches!(o, Open::Labelled(l) if l == label)) {
                        return mismatch;
                    }
                    open.push((Open::Labelled(*label), at, span));
                }
                Statement::WhileBlock { .. } => open.push((Open::While, at, span)),
                Statement::For { .. } => open.push((Open::For, at, span)),
                Statement::If { .. } => open.push((Open::If(vec![at], false), at, span)),
                Statement::ElseIf { .. } | Statement::Else => match open.last_mut() {
                    Some((Open::If(branches, has_else), _, _)) if !*has_else => {
                        if let Some(last) = branches.last() {
                            loops.branches.insert(*last, at);
                        }
                        *has_else = matches!(page.statement(block), Some(Statement::Else));
                        branches.push(at);
                    }
                    _ => return mismatch,
                },
                Statement::EndIf => match open.pop() {
                    Some((Open::If(branches, _), _, _)) => {
                        if let Some(last) = branches.last() {
                            loops.branches.insert(*last, at);
                        }
                        loops.joins.extend(branches.into_iter().map(|branch| (branch, at)));
                    }
                    _ => return mismatch,
                },
                end @ (Statement::EndWhile { .. } | Statement::EndWhileBlock | Statement::EndFor) => {
                    let Some((opened, start, _)) = open.pop() else { return mismatch };
                    let pairs = match (opened, end) {
                        (Open::Labelled(l), Statement::EndWhile { label }) => l == *label,
                        (Open::While, Statement::EndWhileBlock) | (Open::For, Statement::EndFor) => true,
                        _ => false,
                    };
                    if !pairs {
                        return mismatch;
                    }
                    loops.ends.insert(start, at);
                    loops.starts.insert(at, start);
                }
                _ => {}
            }
            None
        })?;
        Ok(match (fault, open.first()) {
            (Some(fault), _) => Err(fault),
            (None, Some((_, _, span))) => Err((Fault::LoopMismatch, *span)),
            (None, None) => Ok(loops),
        })
    }

    /// The innermost loop that a block is in.
    fn around(&self, at: Place) -> Option<(Place, Place)> {
        let inside = |(start, end): &(&Place, &Place)| **start < at && at <= **end;
        let innermost = self.ends.iter().filter(inside).max_by_key(|(start, _)| **start)?;
        Some((*innermost.0, *innermost.1))
    }

    /// Whether a jump from `from` to `to` leads into a loop from outside.
    fn is_entered(&self, from: Place, to: Place) -> bool {
        let inside = |place: Place, start: Place, end: Place| start < place && place <= end;
        self.ends.iter().any(|(start, end)| inside(to, *start, *end) && !inside(from, *start, *end))
    }
}

/// Whether a block is a statement of the macro language (GSK990MC 4.9; in its other form G65 H).
fn is_macro_statement(page: &Page, block: &Block) -> bool {
    let has = |letter: u8| page.words(block).iter().any(|word| word.letter == letter);
    let is_g65 = |word: &Word| word.letter == b'G' && word.value() == Value::Number(65.0);
    page.statement(block).is_some() || has(b'H') && page.words(block).iter().any(is_g65)
}

/// Whether a block has a word beside its numbers.
fn has_command(page: &Page, block: &Block) -> bool {
    page.words(block).iter().any(|word| !matches!(word.letter, b'N' | b'O'))
}

/// What was before a block was run.
struct Before {
    /// The block behind it.
    behind: Place,
    /// Calls open.
    calls: usize,
    /// Steps that wait to be given out, and alarms.
    steps: usize,
    alarms: usize,
}

impl Interpreter {
    /// Where the program is run block by block, a block that made no step gets an end of its own (GSK990MC part 2, 7.6:
    /// the control stops behind each block). A macro statement is one as a parameter says (51#5). A block that only
    /// leads elsewhere (M98, M99, GOTO) has none, as on Fanuc. The line to stop at has one whatever it is (3.4.1),
    /// save in cutter compensation.
    fn end_single_block(&mut self, page: &Page, block: &Block, before: &Before) -> Fallible<()> {
        let is_described = self.described.is_collecting() || self.described.profiles.is_recording();
        let is_wrong = self.alarms_noted() > before.alarms;
        let goes_on = self.ended || self.has_holes_left() || is_described || is_wrong;
        if goes_on || self.is_skipped(block) || self.dialect.blocks.is_some() {
            return Ok(());
        }
        let leads_on = self.flow.place == before.behind && self.flow.calls.len() == before.calls;
        let made_step = self.output.waiting() != before.steps;
        let stops = match is_macro_statement(page, block) {
            _ if self.is_stopped_behind(page, block) => !made_step,
            true => self.rules.single_in_macros,
            // A guard that does not hold leaves its block out.
            false => !made_step && leads_on && page.guard(block).is_none() && has_command(page, block),
        };
        if stops { self.emit_single_stop() } else { Ok(()) }
    }

    /// Whether the run stops behind a block by its line.
    fn is_stopped_behind(&self, page: &Page, block: &Block) -> bool {
        self.options.stop_line.is_some_and(|line| {
            let span = page.block_span(block);
            line == (span.file, span.line)
        })
    }

    /// Whether single block does not stop behind a block though it makes steps: an output set by a statement.
    fn is_passed(&self, page: &Page, block: &Block) -> bool {
        !self.rules.single_in_macros && is_macro_statement(page, block)
    }

    /// A dwell of no time, behind which single block stops. Not in cutter compensation, whose corners would be cut
    /// otherwise for it: there a block without a move is done where the one before it stops (4.7.3).
    fn emit_single_stop(&mut self) -> Fallible<()> {
        if self.output.looks_ahead() || self.output.in_cutter_mode() {
            return Ok(());
        }
        if self.look_back.is_some() {
            self.note_in_force();
        }
        // Not by `emit`: a program that only reckons does not get on.
        let step = self.step(Op::Dwell(Dwell::Seconds(0.0)));
        self.output.push(step).map_err(|(fault, span)| self.alarm(fault, span))
    }

    /// Runs one block.
    pub(crate) fn run_block(&mut self) -> Fallible<()> {
        self.flow.idle += 1;
        self.starved = false;
        if let Some(suspended) = self.flow.resumed.take() {
            return self.resume(*suspended);
        }
        if let Some(jumps) = self.flow.jumps_at_fault
            && (self.flow.idle > IDLE_BLOCKS_BEHIND_FAULT
                || self.flow.jumps_back > jumps + MAX_JUMPS_BACK_BEHIND_FAULT)
        {
            self.ended = true;
            return Ok(());
        }
        let endless = self.flow.jumps_back > MAX_JUMPS_BACK && !self.options.loops_forever;
        if self.flow.idle > IDLE_BLOCKS || endless {
            self.ended = true;
            return Err(self.alarm(Fault::EndlessProgram, self.flow.last));
        }
        let (page, index) = match self.flow.next(&mut self.programs) {
            Ok(Some(found)) => found,
            Ok(None) => return self.end_of_text(),
            // What follows was not sent yet.
            Err(error) if error.kind() == io::ErrorKind::WouldBlock => {
                self.flow.idle = 0;
                self.starved = true;
                return Ok(());
            }
            Err(error) => {
                self.ended = true;
                return Err(self.unreadable(error, self.flow.last));
            }
        };
        if self.described.is_collecting()
            && !page.blocks.get(index).is_some_and(|block| self.continues_described(&page, block))
        {
            // The cycle runs before the block that ends its description.
            self.flow.page = Some(page);
            return self.run_described();
        }
        let at = self.flow.place;
        if self.present != Present::Known {
            if self.flow.stops_before(at) {
                self.flow.page = Some(page);
                return Ok(());
            }
            self.flow.begun += 1;
        }
        let (entered, alarms) = (self.flow.entered, self.alarms_noted());
        self.flow.place.block += 1;
        self.flow.section = match page.blocks.get(index) {
            Some(block) if self.options.single_block && self.is_passed(&page, block) => Step::PASSED,
            _ => 0,
        };
        let (calls, steps) = (self.flow.calls.len(), self.output.waiting());
        let before = Before { behind: self.flow.place, calls, steps, alarms };
        let mut result = match page.blocks.get(index) {
            // Not before the block before has come to its end.
            _ if self.buffer_is_off && self.present != Present::Known => {
                self.present = Present::Asked;
                Ok(())
            }
            Some(block) => {
                self.flow.last = page.block_span(block);
                if self.calls() == 0 && at.file == FileId(0) {
                    self.flow.main_line = self.flow.last.line;
                }
                self.execute(&page, block, index)
            }
            None => Ok(()),
        };
        self.present = match self.present {
            Present::Asked => {
                // As if the block had not been looked at: it comes again behind the barrier.
                self.flow.place = at;
                self.flow.entered = entered;
                self.forget_alarms(alarms);
                result = self.emit_barrier_before();
                Present::Known
            }
            _ => {
                if let Some(block) = page.blocks.get(index)
                    && (self.options.single_block || self.is_stopped_behind(&page, block))
                    && result.is_ok()
                {
                    result = self.end_single_block(&page, block, &before);
                }
                Present::Unknown
            }
        };
        if (self.flow.place.file, self.flow.place.page) == (at.file, at.page) {
            self.flow.page = Some(page);
        }
        result
    }

    pub(crate) fn unreadable(&self, error: io::Error, span: Span) -> Box<Alarm> {
        // A jump, a loop or a search in a program of which only the next lines are there.
        if matches!(error.kind(), io::ErrorKind::WouldBlock | io::ErrorKind::NotSeekable) {
            return self.alarm(Fault::LinesNotKept, span);
        }
        Box::new(Alarm::core(Fault::FileUnreadable, span).with("reason", error.to_string()))
    }

    /// The text ended without an end of program.
    fn end_of_text(&mut self) -> Fallible<()> {
        if self.described.is_collecting() {
            return self.run_described();
        }
        if self.options.open_end && self.flow.calls.is_empty() {
            self.ended = true;
            return self.output.flush().map_err(|(fault, span)| self.alarm(fault, span));
        }
        // Where blocks have an order of their own, what is passed over counts as read.
        if self.dialect.blocks.is_some() {
            self.flow.last = self.programs.last_line(self.flow.place.file).unwrap_or(self.flow.last);
        }
        // A file of nothing but a mark has no block to point at.
        let last = self.flow.last;
        let alarm = self.alarm(Fault::NoProgramEnd, Span { line: last.line.max(1), ..last });
        // A checker goes on behind the call of a subprogram that does not end.
        if !(self.options.keep_going && self.go_back()) {
            self.ended = true;
        }
        Err(alarm)
    }

    /// An O word: where a program starts. Inside a program it means that the one before has no end.
    pub(crate) fn program_number(&mut self, number: f64, span: Span) -> Fallible<()> {
        if self.flow.entered {
            if !(self.options.keep_going && self.go_back()) {
                self.ended = true;
            }
            return Err(self.alarm(Fault::NoProgramEnd, span));
        }
        self.technology.program = number;
        // Table 3-1-3-1: O0 to O99999.
        if !(0.0..=99_999.0).contains(&number) {
            return Err(self.alarm(Fault::ProgramNumberTooLarge, span));
        }
        Ok(())
    }

    /// Whether a macro is being run.
    pub(crate) fn in_macro(&self) -> bool {
        self.flow.depth(true) > 0
    }

    /// Notes that a block of the program proper is run.
    #[inline]
    pub(crate) fn enter_program(&mut self) {
        self.flow.entered = true;
    }

    /// Whether the block is left out (GSK990MC: one `/` by the operator's switch, two always).
    #[inline]
    pub(crate) fn is_skipped(&self, block: &Block) -> bool {
        block.skip > 1 || block.skip == 1 && self.options.block_skip
    }

    /// Runs a program `times` times, then goes on behind the call. With `arguments` it is a macro
    /// call, which has local variables of its own.
    pub(crate) fn call(
        &mut self,
        program: &ProgramId,
        times: u32,
        arguments: Option<&[(u32, f64)]>,
        span: Span,
    ) -> Fallible<()> {
        if times == 0 {
            return Ok(());
        }
        let (limit, fault) = match arguments {
            Some(_) => (self.rules.max_macro_depth, Fault::MacrosTooDeep),
            None => (self.rules.max_call_depth, Fault::CallsTooDeep),
        };
        if self.flow.depth(arguments.is_some()) >= limit {
            return Err(self.alarm(fault, span));
        }
        let found = self.programs.find_program(program).map_err(|error| self.unreadable(error, span))?;
        let name = || match program {
            ProgramId::Number(n) => format!("O{n:04}"),
            ProgramId::Name(name) => name.to_string(),
        };
        let Some(start) = found else {
            return Err(Box::new(self.alarm(Fault::ProgramMissing, span).with("program", name())));
        };
        // No manual says which of them is called, and Fanuc takes no second one into its memory.
        let repeated =
            if self.tells() { self.programs.take_repeated(start.file, program) } else { Vec::new() };
        for other in repeated {
            if let Ok(Some(page)) = self.programs.page(other.file, other.page)
                && let Some(block) = page.blocks.get(other.block as usize)
            {
                let alarm = Alarm::core(Fault::ProgramRepeated, page.block_span(block));
                self.tell(alarm.with("program", name()));
            }
        }
        let locals = arguments.map(|arguments| self.enter_locals(arguments));
        let (back, number) = (self.flow.place, self.technology.program);
        let repeats = times - 1;
        self.flow.calls.push(Call { program: start, back, repeats, number, locals, suspended: None });
        self.flow.jump(start);
        self.flow.entered = false;
        Ok(())
    }

    /// Returns from the subprogram, or runs it again where the call asked for it. False in the main
    /// program.
    pub(crate) fn go_back(&mut self) -> bool {
        let Some(call) = self.flow.calls.last_mut() else { return false };
        if call.repeats > 0 {
            call.repeats -= 1;
            let start = call.program;
            self.flow.jump(start);
            self.flow.entered = false;
            return true;
        }
        if let Some(call) = self.flow.calls.pop() {
            self.flow.jump(call.back);
            self.flow.entered = true;
            self.technology.program = call.number;
            if let Some(locals) = call.locals {
                self.leave_locals(&locals);
            }
            self.flow.resumed = call.suspended;
        }
        true
    }

    /// M99 in the main program: its start again (GSK990MC 3.2.3). True where the program ends instead: at a desk, unless
    /// a further pass leads to an end of its own.
    pub(crate) fn start_again(&mut self, span: Span) -> Fallible<bool> {
        self.flow.passes += 1;
        if !self.options.loops_forever {
            // A block that is searched may be run in any pass whose state is another than those before.
            if !self.flow.ends_later && self.flow.mark().is_none() {
                if !self.ends_later(span) {
                    return Ok(true);
                }
                self.flow.ends_later = true;
            }
            let state = self.fingerprint();
            if self.pass_state.as_ref() == Some(&state) {
                return Ok(true);
            }
            if self.flow.passes > MAX_PASSES {
                self.ended = true;
                return Err(self.alarm(Fault::EndlessProgram, span));
            }
            self.pass_state = Some(state);
        }
        self.flow.jump(Place::default());
        self.flow.entered = false;
        Ok(false)
    }

    /// M99 P in the main program, which led from a block to one further up, as GOTO does. True where it would do so for ever:
    /// at a desk, where a pass is like the one before, or none of those that follow leads on or is at fault.
    pub(crate) fn goes_round(&mut self, from: Place) -> bool {
        if self.options.loops_forever {
            return false;
        }
        let state = self.fingerprint();
        match self.flow.rounds.insert(from, state.clone()) {
            Some(before) => before == state,
            None => !self.flow.ends_later && self.flow.mark().is_none() && !self.leads_on(),
        }
    }

    /// Whether the program comes to another end than that of M99 P which goes round, or to a fault.
    fn leads_on(&self) -> bool {
        let mut ahead = self.at_no_fault();
        ahead.flow.looks_ahead = true;
        ahead.comes_to_end().unwrap_or(true)
    }

    /// Whether one of the passes that follow comes to M02 or M30.
    fn ends_later(&self, span: Span) -> bool {
        let mut ahead = self.at_no_fault();
        matches!(ahead.start_again(span), Ok(false)) && ahead.comes_to_end().unwrap_or(false)
    }

    /// A copy that looks ahead up to the first fault.
    fn at_no_fault(&self) -> Interpreter {
        let mut ahead = self.looking_ahead();
        ahead.flow.ends_later = true;
        ahead.options.keep_going = false;
        ahead.alarms.clear();
        ahead
    }

    /// Whether it comes to an end of its own before long: by M99 it ends where a pass is like the one before. An error where it
    /// comes to a fault.
    fn comes_to_end(mut self) -> Fallible<bool> {
        let mut blocks = MAX_LOOKED_THROUGH;
        while let Some(step) = self.next_within(&mut blocks) {
            if let Op::End(code) = step?.op {
                return Ok(code != 99);
            }
        }
        Ok(false)
    }

    /// Goes on at the block with a sequence number: the next one from here down, else the first from
    /// the start of the program (GSK990MC 4.9.5).
    ///
    /// `missing` is raised where there is none.
    pub(crate) fn go_to(&mut self, number: f64, missing: Fault, span: Span) -> Fallible<()> {
        if !(0.0..=99_999.0).contains(&number) || number.fract() != 0.0 {
            return Err(self.alarm(missing, span));
        }
        self.keeps_lines(span)?;
        let from = self.flow.executing();
        let key = (from, number as u32);
        let target = match self.flow.targets.get(&key) {
            Some(target) => *target,
            None => {
                let target = self.find_sequence(number, from, missing, span)?;
                if self.flow.targets.len() < MAX_REMEMBERED {
                    self.flow.targets.insert(key, target);
                }
                target
            }
        };
        self.flow.jump(target);
        Ok(())
    }

    fn find_sequence(&mut self, number: f64, from: Place, missing: Fault, span: Span) -> Fallible<Place> {
        let program = self.flow.program();
        let data_has_number = self.rules.data_has_number;
        // No jump begins among data, where no statement may stand.
        let has_number = || {
            let mut data = false;
            move |page: &Page, block: &Block, at| {
                let is_data = data_has_number && is_data(page, block, &mut data);
                (!is_data && sequence_number(page, block) == Some(number)).then_some(at)
            }
        };
        let found = blocks_of_program(&mut self.programs, program, self.flow.place, has_number())
            .and_then(|below| match below {
                Some(place) => Ok(Some(place)),
                None => blocks_of_program(&mut self.programs, program, program, has_number()),
            })
            .map_err(|error| self.unreadable(error, span))?;
        let Some(target) = found else {
            let mut alarm = self.alarm(missing, span);
            alarm.arguments.push(("number", number.into()));
            return Err(alarm);
        };
        // A defect of a loop is raised where it is run.
        if let Ok(loops) = self.loops(span)
            && loops.is_entered(from, target)
        {
            return Err(self.alarm(Fault::JumpIntoLoop, span));
        }
        Ok(target)
    }

    /// A program that is sent bit by bit leads on, and never to another line of it, whichever happen to be kept.
    fn keeps_lines(&self, span: Span) -> Fallible<()> {
        let file = self.flow.program().file;
        match self.programs.text(file).is_some_and(Text::is_sent) {
            true => Err(self.alarm(Fault::LinesNotKept, span)),
            false => Ok(()),
        }
    }

    /// The loops of the program being run.
    fn loops(&mut self, span: Span) -> Fallible<Arc<Loops>> {
        self.keeps_lines(span)?;
        let program = self.flow.program();
        if let Some(loops) = self.flow.loops.get(&program) {
            return Ok(loops.clone());
        }
        let found = Loops::find(&mut self.programs, program).map_err(|error| self.unreadable(error, span))?;
        let loops = Arc::new(found.map_err(|(fault, span)| self.alarm(fault, span))?);
        if self.flow.loops.len() >= MAX_REMEMBERED {
            self.flow.loops.clear();
        }
        self.flow.loops.insert(program, loops.clone());
        Ok(loops)
    }

    /// `WHILE … DO` whose condition does not hold: goes on behind its END. Every loop of the program
    /// is paired when the first is met.
    pub(crate) fn leave_or_enter_loop(&mut self, holds: bool, span: Span) -> Fallible<()> {
        let loops = self.loops(span)?;
        let Some(end) = loops.ends.get(&self.flow.executing()) else {
            return Err(self.alarm(Fault::LoopMismatch, span));
        };
        if !holds {
            self.flow.jump(Place { block: end.block + 1, ..*end });
        }
        Ok(())
    }

    /// `$IF` and branches: goes on behind it where it holds; else at the next branch, or the end.
    pub(crate) fn take_branch(&mut self, holds: bool, span: Span) -> Fallible<()> {
        let loops = self.loops(span)?;
        let Some(next) = loops.branches.get(&self.flow.executing()).copied() else {
            return Err(self.alarm(Fault::LoopMismatch, span));
        };
        if !holds {
            self.flow.branch = Some(next);
            self.flow.jump(next);
        }
        Ok(())
    }

    /// Whether the block being executed is a branch that was jumped to.
    pub(crate) fn is_branch(&mut self) -> bool {
        self.flow.branch.take() == Some(self.flow.executing())
    }

    /// Goes on behind the condition whose branch was run.
    pub(crate) fn leave_branches(&mut self, span: Span) -> Fallible<()> {
        let loops = self.loops(span)?;
        let Some(end) = loops.joins.get(&self.flow.executing()).copied() else {
            return Err(self.alarm(Fault::LoopMismatch, span));
        };
        self.flow.jump(Place { block: end.block + 1, ..end });
        Ok(())
    }

    /// Whether `$FOR` is come to from its end.
    pub(crate) fn is_next_pass(&mut self) -> bool {
        self.flow.again.take() == Some(self.flow.executing())
    }

    /// `$ENDFOR`: goes back to its `$FOR`, to count on.
    pub(crate) fn loop_again_counting(&mut self, span: Span) -> Fallible<()> {
        let loops = self.loops(span)?;
        let Some(start) = loops.starts.get(&self.flow.executing()).copied() else {
            return Err(self.alarm(Fault::LoopMismatch, span));
        };
        self.flow.again = Some(start);
        self.flow.jump(start);
        Ok(())
    }

    /// `$BREAK`: goes on behind the innermost loop.
    pub(crate) fn leave_loop(&mut self, span: Span) -> Fallible<()> {
        let loops = self.loops(span)?;
        match loops.around(self.flow.executing()) {
            Some((_, end)) => {
                self.flow.jump(Place { block: end.block + 1, ..end });
                Ok(())
            }
            None => Err(self.alarm(Fault::LoopMismatch, span)),
        }
    }

    /// `$CONTINUE`: goes on at the end of the innermost loop.
    pub(crate) fn next_pass(&mut self, span: Span) -> Fallible<()> {
        let loops = self.loops(span)?;
        match loops.around(self.flow.executing()) {
            Some((_, end)) => {
                self.flow.jump(end);
                Ok(())
            }
            None => Err(self.alarm(Fault::LoopMismatch, span)),
        }
    }

    /// `END`: goes back to its DO.
    pub(crate) fn loop_again(&mut self, span: Span) -> Fallible<()> {
        let loops = self.loops(span)?;
        let Some(start) = loops.starts.get(&self.flow.executing()) else {
            return Err(self.alarm(Fault::LoopMismatch, span));
        };
        self.flow.jump(*start);
        Ok(())
    }
}
