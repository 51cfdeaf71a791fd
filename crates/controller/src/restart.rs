//! Program restart: taking a program up in its midst (GSK990MC part 2, 10.1.9).
//!
//! The program is interpreted from its start to the block at which it goes on, without motion, as fast as blocks
//! can be read. So it may lie anywhere, in a subprogram, a loop, a cycle's mode, under a rotation or cutter
//! compensation: the interpreter that stands before it is the one that a full run would have there. (The manual's
//! control refuses all of these; what is asked of the operator otherwise is the same.)
//!
//! What is found is a [`Restart`], a value on its own: the search works on a copy, and nothing that the program
//! does on the way (variables, G10, messages, outputs) reaches the machine before the restart is accepted by
//! [`Cnc::restart`](crate::Cnc::restart). It tells what is not yet as the program has it, which functions are to be
//! carried out, and how the axes go to the start of the block, one after the other.
//!
//! What the search starts from:
//!
//! - [`Origin::Kept`]: the control's state when the program was started, which a [`Journal`] keeps, with what was
//!   changed by hand since then, under way or broken off (a worn tool's offset, a zero). What the first run wrote itself is not taken twice:
//!   a program that counts parts in #500 counts this one once. What the machine told the program then (where a skip
//!   signal came) is told again. This is the P type of the Fanuc 0i-M, for a broken tool.
//! - [`Origin::Present`]: the present state stands for it, where none was kept: after power-off, or for a program
//!   that was not run before. This is the Q type. A variable that the program counts up then counts twice;
//!   [`Restart::changes`] lists what the search changed.

mod holes;
pub mod told;

use crate::supervision::Supervisor;
use ferrocut_geometry::{Axis, Position};
use ferrocut_interpreter::program_state::ProgramState;
use ferrocut_interpreter::{AtRest, Dialect, Fallible, Interpreter, Until};
use ferrocut_machine::{Alarm, Fault, Machine, Memory, MemoryChange, Severity};
use ferrocut_program::{FileId, ProgramId, Span};
use ferrocut_toolpath::{Feed, Op, PathMode, Port, SpindleState, Step};
use std::collections::VecDeque;
use std::sync::atomic::{AtomicBool, Ordering};
use told::differences;
pub use told::{Compared, Difference, Setting};

/// Answers of the machine that are kept, 240 bytes each: far more than a part has places to measure.
const MOST_ANSWERS: usize = 10_000;

/// Changes by hand that are kept with their blocks.
const MOST_CHANGES: usize = 1000;

/// M codes and outputs that are kept in the order in which they came last.
const MOST_FUNCTIONS: usize = 100;

/// What the machine told the program at a barrier.
#[derive(Clone, Copy, Debug)]
struct Answer {
    /// The block that asked.
    block: u64,
    at_rest: AtRest,
}

/// The machine as a restart compares it with the program.
#[derive(Clone, Debug)]
pub struct Present {
    /// What is in force.
    pub state: ProgramState,
    /// Where the axes are commanded to be, mm and degrees.
    pub position: Position,
    /// By how much programs renamed the place where the axes stand, all in all.
    pub renamed: Position,
}

/// Where a run was broken off.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Interrupted {
    /// The number of the block that was being run, each pass of a block counted.
    pub block: u64,
    /// Its text.
    pub span: Span,
    /// Where the axes came to rest, mm and degrees.
    pub at: Position,
}

/// What a control keeps of a run so that it can be taken up again.
#[derive(Clone)]
pub struct Journal {
    /// As the program was started.
    start: Interpreter,
    /// By how much places had been renamed by then.
    renamed: Position,
    origin: Origin,
    answers: VecDeque<Answer>,
    /// What somebody changed by hand while it ran, and how many blocks were begun then.
    by_hand: VecDeque<(u64, MemoryChange)>,
    interrupted: Option<Interrupted>,
    /// Where the axes stood in a run of which nothing else was kept.
    stood: Option<Position>,
    /// The memory as the run left it.
    left: Option<Memory>,
}

/// What a search starts from.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Origin {
    /// The state at the program's start was kept.
    Kept,
    /// The present state stands for it.
    Present,
}

/// The place at which a program is to be taken up.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum At {
    /// The first block on a line or below it, before it is reached for the `pass`th time, counted from 1.
    Line {
        /// The file.
        file: FileId,
        /// Its line, counted from 1.
        line: u32,
        /// Which time.
        pass: u64,
    },
    /// The block that was interrupted, in the pass in which it was.
    Interrupted,
    /// The block with this number, each pass of a block counted, from 1.
    Number(u64),
}

impl Journal {
    /// The journal of a run that begins now. `renamed`: by how much places were renamed so far.
    pub fn begin(interpreter: &Interpreter, renamed: Position) -> Journal {
        Journal {
            start: interpreter.clone(),
            renamed,
            origin: Origin::Kept,
            // They come in the servo period.
            answers: VecDeque::with_capacity(MOST_ANSWERS),
            by_hand: VecDeque::new(),
            interrupted: None,
            stood: None,
            left: None,
        }
    }

    /// A journal of no run, which starts from the present state of `interpreter`.
    pub fn of_present(interpreter: &Interpreter, renamed: Position) -> Journal {
        Journal { origin: Origin::Present, ..Journal::begin(interpreter, renamed) }
    }

    /// The same of a run that was broken off with the axes at this machine position, in the block that is searched by
    /// its number.
    #[must_use]
    pub fn broken_at(self, stood: Option<Position>) -> Journal {
        Journal { stood, ..self }
    }

    /// Notes what the machine told the program.
    pub fn answer(&mut self, block: u64, at_rest: AtRest) {
        // A search that meets more finds them unknown.
        if self.answers.len() < MOST_ANSWERS {
            self.answers.push_back(Answer { block, at_rest });
        }
    }

    /// Notes a change that somebody made by hand while the run was under way, when so many blocks were begun.
    pub fn change(&mut self, block: u64, change: MemoryChange) {
        if self.by_hand.len() == MOST_CHANGES {
            // The oldest holds from the start on.
            let oldest = self.by_hand.pop_front();
            oldest.iter().for_each(|(_, change)| self.start.change_memory(change));
        }
        self.by_hand.push_back((block, change));
    }

    /// Notes where a run was broken off, and the memory that it left.
    pub fn interrupt(&mut self, at: Interrupted, left: Memory) {
        self.interrupted = Some(at);
        self.left = Some(left);
    }

    /// The file that has a program which those of the run can call, as this journal knows it from now on.
    pub fn file_of(&mut self, id: &ProgramId) -> Option<FileId> {
        self.start.file_of(id)
    }

    /// Where the run was broken off, if it was.
    pub fn interrupted(&self) -> Option<Interrupted> {
        self.interrupted
    }

    /// Finds the state of the program at a place. `present` is the control's memory, with what was changed in it by
    /// hand since the run was broken off.
    ///
    /// # Errors
    /// Every alarm that the program raises before it comes there, and those of a place that it does not come to.
    pub fn find(&self, at: At, present: &Memory) -> Fallible<Restart> {
        self.find_unless(at, present, &AtomicBool::new(false))
    }

    /// The same, given up when `stop` says so: with the alarm of a place that was not reached.
    ///
    /// # Errors
    /// As [`find`](Self::find).
    pub fn find_unless(&self, at: At, present: &Memory, stop: &AtomicBool) -> Fallible<Restart> {
        let mut journal = self.clone();
        if let Some(left) = &self.left {
            let by_hand = left.changes_to(present);
            if !by_hand.is_empty() {
                let mut memory = journal.start.memory().clone();
                by_hand.iter().for_each(|change| memory.make_change(change));
                journal.start.set_memory(memory);
                journal.left = Some(present.clone());
                // The last word counts.
                journal.by_hand.retain(|(_, old)| !by_hand.iter().any(|new| new.is_of(old)));
            }
        }
        let mut interpreter = journal.start.clone();
        let (until, span) = self.until(at, &mut interpreter)?;
        let loops_forever = interpreter.loops_forever();
        let functions = match until {
            // Where the main program is repeated a pass may lie beyond those that differ. So the passes that a
            // program without repetition has are counted first.
            Until::Block { pass, .. } if loops_forever => {
                let mut once = interpreter.clone();
                once.set_loops_forever(false);
                match journal.search(&mut once, until, u64::MAX, stop) {
                    Err(alarm) if alarm.fault == Fault::RestartNotReached => {
                        let most = (once.blocks_begun() + 1).saturating_mul(pass.saturating_add(1));
                        match once.passes_of_mark() {
                            0 => Err(alarm),
                            _ => journal.search(&mut interpreter, until, most, stop),
                        }
                    }
                    found => {
                        interpreter = once;
                        interpreter.set_loops_forever(true);
                        found
                    }
                }
            }
            _ => journal.search(&mut interpreter, until, u64::MAX, stop),
        };
        let mut functions = functions.map_err(|mut alarm| {
            if alarm.fault == Fault::RestartNotReached {
                alarm.span = span;
            }
            alarm
        })?;
        // What was answered behind the place is asked anew.
        journal.answers.retain(|answer| answer.block <= interpreter.blocks_begun());
        for (block, _) in &mut journal.by_hand {
            *block = interpreter.blocks_begun().min(*block);
        }
        let pass = interpreter.passes_of_mark();
        let span = interpreter.next_block().unwrap_or(span);
        interpreter.set_mark(None);
        let position = interpreter.start_of_next_block()?;
        let in_force = interpreter.program_state();
        let block = interpreter.blocks_begun() + 1;
        let broken_at = match at {
            At::Interrupted => self.interrupted.map(|interrupted| interrupted.at),
            At::Number(_) => self.stood,
            At::Line { .. } => None,
        };
        let left = broken_at.and_then(|broken| holes::done_before(&interpreter, position, broken));
        interpreter.leave_begun_blocks_behind();
        // The block is begun, and what was done of it is not given out again.
        let (position, hole) = left.map_or((position, 1), |left| (left.position, left.hole));
        for step in (&mut interpreter).take(left.map_or(0, |left| left.steps)).flatten() {
            if step.op.target().is_some() {
                functions.begin_move();
            }
        }
        Ok(Restart {
            journal,
            interpreter,
            span,
            pass,
            block,
            hole,
            position,
            broken_at,
            in_force,
            functions,
        })
    }

    fn until(&self, at: At, interpreter: &mut Interpreter) -> Fallible<(Until, Span)> {
        match at {
            At::Interrupted => match self.interrupted {
                Some(Interrupted { block, span, .. }) => Ok((Until::Number(block), span)),
                None => Err(Box::new(Alarm::core(Fault::RestartNothing, Span::default()))),
            },
            At::Number(block) => Ok((Until::Number(block), Span::default())),
            At::Line { file, line, pass } => {
                let found = interpreter.block_of_line(file, line).map_err(|error| {
                    let alarm = Alarm::core(Fault::FileUnreadable, Span { file, line, ..Span::default() });
                    Box::new(alarm.with("reason", error.to_string()))
                })?;
                let Some((place, span)) = found else {
                    let alarm = Alarm::core(Fault::RestartBlockMissing, Span::default());
                    return Err(Box::new(alarm.with("line", f64::from(line))));
                };
                Ok((Until::Block { place, pass: pass.max(1) }, span))
            }
        }
    }

    /// Interprets to a block, or until `most` blocks were begun.
    fn search(
        &self,
        interpreter: &mut Interpreter,
        until: Until,
        most: u64,
        stop: &AtomicBool,
    ) -> Fallible<Functions> {
        let mut functions = Functions { renamed: self.renamed, ..Functions::default() };
        let mut at = Interpreter::position(interpreter);
        let mut answers = self.answers.iter().peekable();
        interpreter.set_mark_within(until, most);
        let (mut waited, mut stopped) = (false, None);
        let mut by_hand = self.by_hand.iter().peekable();
        while !stop.load(Ordering::Relaxed) {
            while let Some((_, change)) = by_hand.next_if(|(block, _)| *block <= interpreter.blocks_begun()) {
                interpreter.change_memory(change);
            }
            let Some(step) = interpreter.next() else { break };
            let step = step?;
            if step.op.moves_from(at) {
                functions.begin_move();
            }
            // What was asked in a block that is left out now, as by block skip, is not asked.
            while answers.next_if(|answer| answer.block < step.block).is_some() {}
            match &step.op {
                // Where the signal came, and then the barrier behind it.
                Op::Skip { to, .. } => {
                    at = *to;
                    if let Some(answer) =
                        answers.next_if(|a| a.block == step.block && a.at_rest.skip.is_some())
                    {
                        interpreter.came_to_rest(&answer.at_rest);
                        at = answer.at_rest.commanded;
                    }
                }
                Op::Barrier => match answers.next_if(|answer| {
                    answer.block == step.block && (!waited || answer.at_rest.input.is_some())
                }) {
                    Some(answer) => {
                        interpreter.came_to_rest(&answer.at_rest);
                        at = answer.at_rest.commanded;
                    }
                    // A change of tool asks for auxiliary lock, and which tool is in the spindle; behind a stop nothing is asked.
                    None if interpreter.asks_for_lock()
                        || interpreter.changes_tool()
                        || stopped == Some(step.block) => {}
                    None => functions.unknown += 1,
                },
                Op::Datum { at: name } => {
                    functions.renamed = functions.renamed + *name - at;
                    at = *name;
                }
                op => {
                    // What moves the magazine belongs to the change, which is made anew where it is needed.
                    if !interpreter.changes_tool() {
                        functions.note(op);
                    }
                    at = op.target().copied().unwrap_or(at);
                }
            }
            waited = matches!(step.op, Op::Wait { .. });
            stopped = matches!(step.op, Op::Stop(_)).then_some(step.block);
        }
        if interpreter.is_at_mark() {
            // What was changed behind the place is so all the same.
            by_hand.for_each(|(_, change)| interpreter.change_memory(change));
            return Ok(functions);
        }
        let passes = interpreter.passes_of_mark();
        let alarm = Alarm::core(Fault::RestartNotReached, Span::default());
        Err(Box::new(alarm.with("passes", passes as f64)))
    }
}

/// The M codes of the ladder and the outputs that a program leaves behind.
#[derive(Clone, PartialEq, Debug, Default)]
struct Functions {
    /// With the number that each handed over, in the order in which they came last.
    m_codes: VecDeque<(u32, Option<u32>)>,
    outputs: VecDeque<(Port, f64)>,
    /// Those that change with the next move.
    with_next_move: VecDeque<(Port, f64)>,
    /// By how much places were renamed, all in all.
    renamed: Position,
    /// Barriers at which nobody knows what the machine told.
    unknown: u64,
}

impl Functions {
    fn note(&mut self, op: &Op) {
        match op {
            Op::Machine(code) => put(&mut self.m_codes, *code, None),
            Op::MachineNumber { code, number } => put(&mut self.m_codes, *code, Some(*number)),
            Op::Output { port, value, with_next_move: false } => put(&mut self.outputs, port.clone(), *value),
            Op::Output { port, value, with_next_move: true } => {
                put(&mut self.with_next_move, port.clone(), *value);
            }
            _ => {}
        }
    }

    /// A move begins, and outputs change with it.
    fn begin_move(&mut self) {
        for (port, value) in self.with_next_move.drain(..) {
            put(&mut self.outputs, port, value);
        }
    }
}

/// Notes an M code or an output as the one that came last.
fn put<K: PartialEq, V>(functions: &mut VecDeque<(K, V)>, key: K, value: V) {
    functions.retain(|(other, _)| *other != key);
    functions.push_back((key, value));
    if functions.len() > MOST_FUNCTIONS {
        functions.pop_front();
    }
}

/// The steps that set outputs.
fn outputs(of: &VecDeque<(Port, f64)>, with_next_move: bool) -> impl Iterator<Item = Op> {
    of.iter().map(move |(port, value)| Op::Output { port: port.clone(), value: *value, with_next_move })
}

/// How a restart is carried out.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct How {
    /// The control sends T, M and S itself; else the operator has done so by hand (10.1.9, 4).
    pub sends: bool,
    /// Each axis waits for cycle start.
    pub axis_by_axis: bool,
}

/// The program stop between two axes.
const STOP: u32 = 0;

/// A place of a program that was found, ready to go on from there.
#[derive(Clone)]
pub struct Restart {
    journal: Journal,
    interpreter: Interpreter,
    /// The block that comes next.
    pub span: Span,
    /// The how manieth time it is reached; 0 where it was found by its number.
    pub pass: u64,
    /// Its number, each pass of a block counted.
    pub block: u64,
    /// The hole of a canned cycle with which it begins, from 1.
    pub hole: u32,
    /// Where the axes stand when it begins, machine coordinates, compensation included, mm and degrees.
    pub position: Position,
    /// Where the axes stood when the block was broken off; none where another place was asked for.
    pub broken_at: Option<Position>,
    /// What is in force then.
    pub in_force: ProgramState,
    functions: Functions,
}

impl Restart {
    /// What the search started from.
    pub fn origin(&self) -> Origin {
        self.journal.origin
    }

    /// The interpreter that goes on.
    pub fn interpreter(&self) -> &Interpreter {
        &self.interpreter
    }

    /// The interpreter that goes on, and what is kept of the run.
    pub fn into_parts(self) -> (Interpreter, Journal) {
        (self.interpreter, Journal { interrupted: None, left: None, ..self.journal })
    }

    /// M codes of the ladder in the order in which they came last.
    pub fn m_codes(&self) -> impl Iterator<Item = Op> {
        let is_over = |code: u32| self.in_force.has_ended(self.interpreter.dialect(), code);
        let codes = self.functions.m_codes.iter().copied().filter(move |(code, _)| !is_over(*code));
        codes.map(|(code, number)| match number {
            Some(number) => Op::MachineNumber { code, number },
            None => Op::Machine(code),
        })
    }

    /// The warning that values are not known which the machine told the program before this place.
    pub fn warning(&self) -> Option<Alarm> {
        let Functions { unknown, .. } = self.functions;
        let alarm = || Alarm::core(Fault::RestartUnknown, self.span).with("count", unknown as f64);
        (unknown > 0).then(|| alarm().as_warning())
    }

    /// What the memory becomes that the control has now, once the restart is accepted.
    pub fn changes(&self, present: &Memory) -> Vec<MemoryChange> {
        present.changes_to(self.interpreter.memory())
    }

    /// What is not yet as the program has it. `present` is the machine's.
    pub fn differences(&self, present: &ProgramState) -> Vec<Difference> {
        differences(&self.in_force, present)
    }

    /// The functions that make tool, spindle and coolant as the program has them, and the M codes that it sent.
    pub fn functions(&self, present: &ProgramState) -> Vec<Op> {
        let program = &self.in_force;
        let mut all = Vec::new();
        let mut chosen = present.tool;
        if program.in_spindle != present.in_spindle {
            chosen = program.in_spindle;
            all.extend([Op::Select(chosen), Op::Change(chosen)]);
        }
        if program.tool != chosen {
            all.push(Op::Select(program.tool));
        }
        all.extend(self.m_codes());
        all.extend(outputs(&self.functions.outputs, false));
        // A change of tool stops the spindle.
        let changes = program.in_spindle != present.in_spindle;
        if program.spindle != present.spindle || changes && program.spindle != SpindleState::Off {
            all.push(Op::Spindle(program.spindle));
        }
        if program.coolant[0] != present.coolant[0] {
            all.push(Op::Coolant(program.coolant[0]));
        }
        all
    }

    /// How the axes go from `from` to where the block begins: one after the other in the order of the machine
    /// (GSK990MC P376), at its speed for this (P86), Z as it says (49#0).
    ///
    /// # Errors
    /// An order that does not name each axis once, and whatever a move on the way would be refused for: no axis
    /// moves then.
    pub fn approach(&self, from: Position, machine: &Machine) -> Fallible<Vec<Op>> {
        let dialect = self.interpreter.dialect();
        let mut machine = machine.clone();
        (dialect.machine_parameters)(&self.interpreter.memory().parameters, &mut machine);
        let Some(order) = machine.restart.order_of(&machine) else {
            return Err(Box::new(own_alarm(dialect, Fault::RestartOrder, self.span)));
        };
        let speed = machine.restart.speed;
        let mut supervisor = Supervisor::new(&machine, dialect, from).runs();
        let mut moves = Vec::new();
        let mut at = from;
        // An axis that the machine lacks comes last, to be refused.
        let lacking = Axis::ALL.into_iter().filter(|axis| machine.axis(*axis).is_none());
        for axis in order.into_iter().chain(lacking) {
            let mut to = at;
            to[axis] = self.position[axis];
            if to == at {
                continue;
            }
            let op = match axis == Axis::Z && machine.restart.cuts_z && speed > 0.0 {
                true => Op::Feed { to, feed: Feed::PerMinute(speed), path: PathMode::ExactStop },
                false => Op::Rapid {
                    to,
                    straight: true,
                    speed: (speed > 0.0).then_some(speed),
                    path: PathMode::ON_PATH,
                },
            };
            if let Some(alarm) = self.interpreter.stroke_alarm(at, &op) {
                return Err(Box::new(Alarm { span: self.span, ..*alarm }));
            }
            let mut refused = None;
            supervisor.step(&self.step(op.clone()), |alarm| {
                if alarm.severity == Severity::Error && refused.is_none() {
                    refused = Some(Box::new(alarm));
                }
            });
            if let Some(alarm) = refused {
                return Err(alarm);
            }
            moves.push(op);
            at = to;
        }
        Ok(moves)
    }

    /// All that is done before the program goes on: functions, then the axes.
    ///
    /// # Errors
    /// Those of [`approach`](Restart::approach).
    pub fn lead_in(&self, present: &Present, machine: &Machine, how: How) -> Fallible<VecDeque<Step>> {
        let mut steps = VecDeque::new();
        // Places have the names that the program gave them.
        let from = self.renamed(present);
        if from != present.position {
            steps.push_back(self.step(Op::Datum { at: from }));
        }
        if how.sends {
            steps.extend(self.functions(&present.state).into_iter().map(|op| self.step(op)));
        }
        for (k, op) in self.approach(from, machine)?.into_iter().enumerate() {
            if how.axis_by_axis && k > 0 {
                steps.push_back(self.step(Op::Stop(STOP)));
            }
            steps.push_back(self.step(op));
        }
        if how.axis_by_axis && !steps.is_empty() {
            steps.push_back(self.step(Op::Stop(STOP)));
        }
        // Nobody can have done these by hand: they change with the first move of the program.
        steps.extend(outputs(&self.functions.with_next_move, true).map(|op| self.step(op)));
        Ok(steps)
    }

    /// Where the axes stand, by the names that places have for the program from here on.
    pub fn renamed(&self, present: &Present) -> Position {
        present.position + self.functions.renamed - present.renamed
    }

    fn step(&self, op: Op) -> Step {
        Step::new(op, self.span, self.block)
    }
}

/// An alarm by the control's own number, where it has one.
pub(crate) fn own_alarm(dialect: &Dialect, fault: Fault, span: Span) -> Alarm {
    Alarm::new(dialect.alarm_id(fault), fault, span)
}
