//! A ladder to flat code: runs of contacts and coils, each with what is done behind it.
//!
//! Level 2 reads X and F from their image, so a subprogram that both levels call is compiled for each.

use crate::address::{Address, ZERO};
use crate::bits::BitOp;
use crate::check::{Limits, Sections, check};
use crate::fault::{Error, Fault, Span};
use crate::functions::Function;
use crate::instruction::{Basic, Bytes, Code, Instruction, Kind, Name, Parameter};
use crate::list::{Ladder, Symbol, bytes_of, read, to_text};
use rustc_hash::FxHashMap;
use std::ops::Range;

/// Instructions after which a run of contacts and coils ends at the next network, so that level 2 can be
/// left there.
const RUN: u32 = 64;

/// No instruction.
pub(crate) const NOWHERE: u32 = u32::MAX;

/// What is done behind a run.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Then {
    /// The next segment.
    Next,
    /// A function, by its place among them.
    Do(u32),
    /// On at another segment where ST0 is so, or always.
    Jump { when: Option<bool>, to: u32 },
    /// The same, out of all subprograms.
    Leave { to: u32 },
    /// A subprogram.
    Call { when: Option<bool>, to: u32 },
    /// Back behind the call.
    Return,
    /// The end of the level.
    Finish,
}

/// A run of contacts and coils, and what is done behind it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Segment {
    pub first: u32,
    pub end: u32,
    pub then: Then,
    /// The instruction that `then` comes from.
    pub source: u32,
    /// Steps that it counts.
    pub steps: u32,
    /// Whether it begins with a network, so that level 2 may be left before it.
    pub is_network: bool,
    /// Results on the stack behind the run: the conditions of a function.
    pub depth: u8,
}

/// A ladder that can be run.
#[derive(Clone, Debug)]
pub struct Program {
    pub(crate) ops: Vec<BitOp>,
    /// For each of `ops` the instruction that it comes from.
    pub(crate) sources: Vec<u32>,
    pub(crate) segments: Vec<Segment>,
    pub(crate) functions: Vec<Function>,
    pub(crate) tables: Vec<i32>,
    /// Segments at which the levels begin.
    pub(crate) first_level: u32,
    pub(crate) second_level: u32,
    /// Powered flow of each instruction, written while it is watched.
    pub(crate) flow: Vec<u8>,
    instructions: Vec<Instruction>,
    symbols: Vec<Symbol>,
    /// Bytes of what functions take from an address or put there, where they are more than one.
    widths: FxHashMap<Address, u8>,
    /// What it was read from, with its remarks; empty where that was no text.
    text: String,
}

impl Program {
    /// Compiles ladder text; all faults where there are any, in the order of the text.
    pub fn from_text(text: &[u8], limits: &Limits) -> Result<Program, Vec<Error>> {
        let mut errors = Vec::new();
        let ladder = read(text, &mut errors);
        let program = Program::from_ladder(ladder, limits, errors)?;
        Ok(Program { text: String::from_utf8_lossy(text).into_owned(), ..program })
    }

    /// Compiles a ladder that was read with the faults `errors`.
    pub fn from_ladder(
        ladder: Ladder,
        limits: &Limits,
        mut errors: Vec<Error>,
    ) -> Result<Program, Vec<Error>> {
        if ladder.instructions.is_empty() {
            // No ladder: what else it lacks says nothing.
            if errors.is_empty() {
                errors.push(Error::new(Fault::FileFormat, Span { line: 1, ..Span::default() }));
            }
            return Err(errors);
        }
        if ladder.instructions.len() > limits.steps as usize {
            // What cannot be held is not looked at any closer.
            errors.push(Error::about(Fault::TooLarge, ladder.end, limits.steps.to_string()));
            return Err(errors);
        }
        let sections = check(&ladder, limits, &mut errors);
        let mut compiler = Compiler::new(&ladder);
        if errors.is_empty() {
            compiler.compile(&sections, &mut errors);
        }
        errors.sort_by_key(|error| (error.span.offset, error.fault.number()));
        errors.dedup();
        if !errors.is_empty() {
            return Err(errors);
        }
        let mut program = compiler.program;
        program.flow = vec![0; ladder.instructions.len()];
        program.widths = widths(&ladder.instructions);
        program.instructions = ladder.instructions;
        program.symbols = ladder.symbols;
        Ok(program)
    }

    /// The instructions, in the order of the text.
    pub fn instructions(&self) -> &[Instruction] {
        &self.instructions
    }

    /// The ladder as a list: the text that it was read from, with its remarks, where it was.
    pub fn text(&self) -> String {
        if !self.text.is_empty() {
            return self.text.clone();
        }
        let (symbols, instructions) = (self.symbols.clone(), self.instructions.clone());
        to_text(&Ladder { symbols, instructions, ..Ladder::default() })
    }

    /// Signals that the ladder names.
    pub fn symbols(&self) -> &[Symbol] {
        &self.symbols
    }

    /// Whether an instruction writes something in the byte of an address.
    pub fn writes(&self, at: Address) -> bool {
        let is_in = |to: &Address, bytes: u32| {
            let first = u32::from(to.byte);
            to.area == at.area && (first..first.saturating_add(bytes)).contains(&at.byte.into())
        };
        self.instructions.iter().any(|instruction| match &instruction.code {
            Code::Basic(basic, address) => basic.is_coil() && address.as_ref().is_some_and(|to| is_in(to, 1)),
            Code::Function(row, parameters, _) => {
                row.parameters.iter().zip(parameters).any(|pair| match pair {
                    (Kind::Write(bytes), Parameter::At(to)) => is_in(to, bytes_of(*bytes, row, parameters)),
                    _ => false,
                })
            }
        })
    }

    /// How many bytes what stands at an address has, as the widest function takes it or puts it there.
    pub fn bytes_at(&self, at: Address) -> u8 {
        self.widths.get(&at).copied().unwrap_or(1)
    }

    /// The signal of a name, or of an address as it is written.
    pub fn signal(&self, name: &str) -> Option<Address> {
        let named = self.symbols.iter().find(|symbol| symbol.name == name);
        named.map(|symbol| symbol.address).or_else(|| Address::parse(name).ok())
    }

    /// Steps of level 1.
    pub fn first_level_steps(&self) -> u32 {
        let is_end = |i: &&Instruction| i.name() == Some(Name::End1);
        self.instructions.iter().take_while(|i| !is_end(i)).map(Instruction::steps).sum()
    }

    /// Steps of the list: a basic instruction is one, a function one and one for each parameter.
    pub fn steps(&self) -> u32 {
        self.instructions.iter().map(Instruction::steps).sum()
    }
}

/// Bytes of the numbers that functions take from their addresses or put there.
fn widths(instructions: &[Instruction]) -> FxHashMap<Address, u8> {
    let mut widths = FxHashMap::default();
    for instruction in instructions {
        let Code::Function(row, parameters, _) = &instruction.code else { continue };
        for pair in row.parameters.iter().zip(parameters) {
            let (Kind::Read(bytes) | Kind::Write(bytes) | Kind::Operand(bytes), Parameter::At(at)) = pair
            else {
                continue;
            };
            if !matches!(bytes, Bytes::Fixed(_) | Bytes::Width) {
                continue;
            }
            if let Some(bytes) =
                [2, 4].into_iter().find(|n| u32::from(*n) == bytes_of(*bytes, row, parameters))
            {
                let widest = widths.entry(*at).or_insert(bytes);
                *widest = bytes.max(*widest);
            }
        }
    }
    widths
}

/// A jump whose place is not known yet: its segment, and the label.
struct Fixup {
    segment: usize,
    label: i64,
    home: bool,
}

struct Compiler<'a> {
    ladder: &'a Ladder,
    program: Program,
    /// First of `ops` of the segment that is being made, its steps, and whether it begins with a network.
    first: u32,
    steps: u32,
    is_network: bool,
    /// Results on the stack.
    depth: usize,
    is_second: bool,
    /// Where the values of each table begin; a subprogram that is compiled twice has them once.
    tables: FxHashMap<usize, (u32, u32)>,
}

impl<'a> Compiler<'a> {
    fn new(ladder: &'a Ladder) -> Compiler<'a> {
        let program = Program {
            ops: Vec::new(),
            sources: Vec::new(),
            segments: Vec::new(),
            functions: Vec::new(),
            tables: Vec::new(),
            first_level: 0,
            second_level: 0,
            flow: Vec::new(),
            instructions: Vec::new(),
            symbols: Vec::new(),
            widths: FxHashMap::default(),
            text: String::new(),
        };
        Compiler {
            ladder,
            program,
            first: 0,
            steps: 0,
            is_network: true,
            depth: 0,
            is_second: false,
            tables: FxHashMap::default(),
        }
    }

    fn compile(&mut self, sections: &Sections, errors: &mut Vec<Error>) {
        self.program.first_level = self.level(&sections.first, sections, errors);
        self.is_second = true;
        self.program.second_level = self.level(&sections.second, sections, errors);
    }

    fn here(&self) -> u32 {
        // As many as instructions at most, times four.
        self.program.segments.len() as u32
    }

    /// A level and the subprograms that it calls; where it begins.
    fn level(&mut self, range: &Range<usize>, sections: &Sections, errors: &mut Vec<Error>) -> u32 {
        let start = self.here();
        let mut calls: Vec<(usize, i64)> = Vec::new();
        let mut leaves: Vec<Fixup> = Vec::new();
        let labels = self.section(range, Then::Finish, &mut calls, &mut leaves);
        let mut places: FxHashMap<i64, u32> = FxHashMap::default();
        let mut done = 0;
        while let Some((_, number)) = calls.get(done).copied() {
            done += 1;
            if places.contains_key(&number) {
                continue;
            }
            let Some((_, range)) = sections.subprograms.iter().find(|(n, _)| *n == number) else { continue };
            places.insert(number, self.here());
            self.section(range, Then::Return, &mut calls, &mut leaves);
        }
        for (segment, number) in calls {
            self.fix(segment, places.get(&number).copied());
        }
        for leave in leaves {
            let to = labels.get(&leave.label).copied();
            if to.is_none() {
                // The label is one of the other level.
                let source = self.program.segments.get(leave.segment).map_or(NOWHERE, |s| s.source);
                let span = self.ladder.instructions.get(source as usize).map_or(self.ladder.end, |i| i.span);
                errors.push(Error::new(Fault::JumpWrong, span));
            }
            self.fix(leave.segment, to);
        }
        start
    }

    fn fix(&mut self, segment: usize, place: Option<u32>) {
        let then = self.program.segments.get_mut(segment).map(|segment| &mut segment.then);
        if let (Some(Then::Jump { to, .. } | Then::Call { to, .. } | Then::Leave { to }), Some(place)) =
            (then, place)
        {
            *to = place;
        }
    }

    /// Compiles a section; gives where its labels are.
    fn section(
        &mut self,
        range: &Range<usize>,
        end: Then,
        calls: &mut Vec<(usize, i64)>,
        leaves: &mut Vec<Fixup>,
    ) -> FxHashMap<i64, u32> {
        let ladder = self.ladder;
        let mut labels = FxHashMap::default();
        let mut jumps: Vec<Fixup> = Vec::new();
        let mut jump: Option<usize> = None;
        // A JMP that covers a number of coils: its segment, and coils left.
        let mut covered: Option<(usize, i64)> = None;
        // A COM: its segment, the first instruction that it covers, and coils left.
        let mut com: Option<(usize, usize, Option<i64>)> = None;
        let to = NOWHERE;
        self.is_network = true;
        for at in range.clone() {
            let Some(instruction) = ladder.instructions.get(at) else { break };
            let number = instruction.number().unwrap_or(0);
            self.steps += instruction.steps();
            match &instruction.code {
                Code::Basic(basic, address) => {
                    self.basic(*basic, *address, at);
                    if basic.is_coil() {
                        if let Some((segment, left)) = &mut covered {
                            *left -= 1;
                            if *left <= 0 {
                                let segment = *segment;
                                covered = None;
                                self.flush(Then::Next, NOWHERE);
                                self.fix(segment, Some(self.here()));
                            }
                        }
                        if let Some((segment, from, Some(left))) = &mut com {
                            *left -= 1;
                            if *left <= 0 {
                                let (segment, from) = (*segment, *from);
                                com = None;
                                self.unpowered(segment, from..at + 1);
                            }
                        }
                    }
                }
                Code::Function(row, parameters, table) => match row.name {
                    Name::Jmp => {
                        let segment = self.flush(Then::Jump { when: Some(true), to }, at as u32);
                        if number > 0 {
                            covered = Some((segment, number));
                        } else {
                            jump = Some(segment);
                        }
                    }
                    Name::Jmpe => {
                        self.flush(Then::Next, NOWHERE);
                        if let Some(segment) = jump.take() {
                            self.fix(segment, Some(self.here()));
                        }
                    }
                    Name::Com => {
                        let segment = self.flush(Then::Jump { when: Some(false), to }, at as u32);
                        com = Some((segment, at + 1, (number > 0).then_some(number)));
                    }
                    Name::Come => {
                        if let Some((segment, from, _)) = com.take() {
                            self.unpowered(segment, from..at);
                        }
                    }
                    Name::Lbl => {
                        self.flush(Then::Next, NOWHERE);
                        self.is_network = true;
                        labels.insert(number, self.here());
                    }
                    Name::Jmpb => {
                        let segment = self.flush(Then::Jump { when: Some(true), to }, at as u32);
                        jumps.push(Fixup { segment, label: number, home: false });
                    }
                    Name::Jmpc => {
                        // Past the jump where its line is off.
                        let over = self.flush(Then::Jump { when: Some(false), to }, at as u32);
                        let segment = self.flush(Then::Leave { to }, at as u32);
                        self.fix(over, Some(self.here()));
                        leaves.push(Fixup { segment, label: number, home: true });
                    }
                    Name::Call => {
                        let segment = self.flush(Then::Call { when: Some(true), to }, at as u32);
                        calls.push((segment, number));
                    }
                    Name::Callu => {
                        let segment = self.flush(Then::Call { when: None, to }, at as u32);
                        calls.push((segment, number));
                    }
                    Name::Nop | Name::End1 | Name::End2 | Name::End | Name::Sp | Name::Spe => {}
                    _ => {
                        let values = self.table(at, table);
                        let coil = match ladder.instructions.get(at + 1).map(|i| &i.code) {
                            Some(Code::Basic(basic @ (Basic::Wrt | Basic::WrtNot), Some(coil))) => {
                                Some((*basic, *coil))
                            }
                            _ => None,
                        };
                        let is_second = self.is_second;
                        let place = move |a: Address| if is_second { a.synchronised() } else { a.place() };
                        let function = Function::new(row, parameters, values, &place, coil);
                        if let Function::MoveBytes { bytes, .. } = function {
                            self.steps += u32::from(bytes) / 8;
                        }
                        let index = self.program.functions.len() as u32;
                        self.program.functions.push(function);
                        self.flush(Then::Do(index), at as u32);
                    }
                },
            }
        }
        self.flush(end, NOWHERE);
        for jump in jumps.iter().filter(|jump| !jump.home) {
            self.fix(jump.segment, labels.get(&jump.label).copied());
        }
        labels
    }

    fn basic(&mut self, basic: Basic, address: Option<Address>, source: usize) {
        let is_start = matches!(basic, Basic::Rd | Basic::RdNot);
        let count = (self.program.ops.len() as u32).saturating_sub(self.first);
        if is_start && count >= RUN {
            // The step of this instruction belongs to the next segment.
            self.steps -= 1;
            self.flush(Then::Next, NOWHERE);
            self.steps += 1;
        }
        if is_start && self.program.ops.len() as u32 == self.first {
            self.is_network = true;
        }
        let bit = address.and_then(|a| a.bit).unwrap_or(0);
        let place = match address {
            None => ZERO,
            Some(address) if self.is_second => address.synchronised(),
            Some(address) => address.place(),
        };
        let (waits, own) = BitOp::of(basic, place, bit, &mut self.depth);
        if let Some(waits) = waits {
            self.op(waits, NOWHERE);
        }
        self.op(own, source as u32);
    }

    fn op(&mut self, op: BitOp, source: u32) {
        self.program.ops.push(op);
        self.program.sources.push(source);
    }

    /// Ends the segment; its place.
    fn flush(&mut self, then: Then, source: u32) -> usize {
        let end = self.program.ops.len() as u32;
        let segment = Segment {
            first: self.first,
            end,
            then,
            source,
            steps: self.steps.max(1),
            is_network: self.is_network,
            // At most nine.
            depth: self.depth as u8,
        };
        self.program.segments.push(segment);
        if !matches!(then, Then::Next) {
            // A function leaves W1 alone.
            self.depth = 1;
        }
        (self.first, self.steps, self.is_network) = (end, 0, false);
        self.program.segments.len() - 1
    }

    /// The other way through a COM: its coils without power. Those of WRT.NOT come on, as in a PMC.
    fn unpowered(&mut self, com: usize, range: Range<usize>) {
        let over = self.flush(Then::Jump { when: None, to: NOWHERE }, NOWHERE);
        self.fix(com, Some(self.here()));
        for at in range {
            let Some(Code::Basic(basic, Some(address))) = self.ladder.instructions.get(at).map(|i| &i.code)
            else {
                continue;
            };
            if basic.is_coil() {
                let (_, coil) = BitOp::of(*basic, address.place(), address.bit.unwrap_or(0), &mut 1);
                self.op(BitOp::off(), at as u32);
                self.op(coil, at as u32);
                self.steps += 1;
            }
        }
        self.flush(Then::Next, NOWHERE);
        self.fix(over, Some(self.here()));
        self.is_network = true;
    }

    /// The values of the table of an instruction.
    fn table(&mut self, at: usize, values: &[i64]) -> (u32, u32) {
        let all = &mut self.program.tables;
        *self.tables.entry(at).or_insert_with(|| {
            let first = all.len() as u32;
            let value =
                |v: &i64| i32::try_from(*v).unwrap_or_else(|_| u32::try_from(*v).unwrap_or(0).cast_signed());
            all.extend(values.iter().map(value));
            (first, values.len() as u32)
        })
    }
}
