//! Whether a list of instructions is a ladder: networks, levels, jumps, subprograms, numbers used once.
//!
//! A network is what stands between two lines to the left rail. Its conditions are kept on a stack, as in a
//! PMC: the result that is being made, and eight that wait.

use crate::fault::{Error, Fault, Span};
use crate::instruction::{Basic, Code, Instruction, Name, Output, Parameter, Row};
use crate::list::Ladder;
use rustc_hash::{FxHashMap, FxHashSet};
use std::ops::Range;

/// Results on the stack: ST0 and eight that wait.
pub const STACK: usize = 9;
/// Rows of a network.
pub const ROWS: u32 = 256;
/// SFT functions.
pub const SHIFTS: u32 = 256;
/// Subprograms that call one another.
pub const CALLS: usize = 8;

/// How large a ladder may be.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Limits {
    /// Steps in all: a basic instruction is one, a function one and one for each parameter.
    pub steps: u32,
    /// Steps of level 1.
    pub first_level: u32,
}

impl Default for Limits {
    /// As many steps as the largest PMC-SB7 holds (the GSK990MC holds 4,700); level 1 leaves half of a
    /// period of 5,000 steps to level 2.
    fn default() -> Limits {
        Limits { steps: 24_000, first_level: 2_500 }
    }
}

/// Which instructions belong to what.
#[derive(Clone, Debug, Default)]
pub struct Sections {
    /// Level 1, without END1.
    pub first: Range<usize>,
    /// Level 2, without END2.
    pub second: Range<usize>,
    /// Subprograms by their number, without SP and SPE.
    pub subprograms: Vec<(i64, Range<usize>)>,
}

/// Checks a ladder and divides it. The sections are of use only where `errors` stays empty.
pub fn check(ladder: &Ladder, limits: &Limits, errors: &mut Vec<Error>) -> Sections {
    let sections = levels(ladder, errors);
    networks(&ladder.instructions, errors);
    jumps(&ladder.instructions, &sections, errors);
    calls(&ladder.instructions, &sections, errors);
    numbers(&ladder.instructions, errors);
    let steps = |range: Range<usize>| -> u32 {
        ladder.instructions.get(range).unwrap_or_default().iter().map(Instruction::steps).sum()
    };
    if steps(0..ladder.instructions.len()) > limits.steps {
        errors.push(Error::about(Fault::TooLarge, ladder.end, limits.steps.to_string()));
    }
    if steps(sections.first.clone()) > limits.first_level {
        let end = ladder.instructions.get(sections.first.end).map_or(ladder.end, |i| i.span);
        errors.push(Error::about(Fault::FirstLevelTooLong, end, limits.first_level.to_string()));
    }
    sections
}

impl Instruction {
    /// Steps that it counts.
    pub fn steps(&self) -> u32 {
        match &self.code {
            Code::Basic(..) => 1,
            Code::Function(row, _, table) => row.steps() + u32::try_from(table.len()).unwrap_or(u32::MAX / 2),
        }
    }

    /// The function, where it is one.
    pub fn name(&self) -> Option<Name> {
        match &self.code {
            Code::Function(row, ..) => Some(row.name),
            Code::Basic(..) => None,
        }
    }

    /// Its first parameter, where that is a number.
    pub fn number(&self) -> Option<i64> {
        match &self.code {
            Code::Function(_, parameters, _) => match parameters.first() {
                Some(Parameter::Number(number)) => Some(*number),
                _ => None,
            },
            Code::Basic(..) => None,
        }
    }
}

/// END1, END2, SP, SPE and END.
fn levels(ladder: &Ladder, errors: &mut Vec<Error>) -> Sections {
    let mut sections = Sections::default();
    let mut begin = 0;
    let (mut first, mut second, mut end) = (None, None, None);
    let mut open: Option<(i64, usize, Span)> = None;
    for (at, instruction) in ladder.instructions.iter().enumerate() {
        let span = instruction.span;
        if end.is_some() {
            errors.push(Error::new(Fault::OutsideLevels, span));
            break;
        }
        match instruction.name() {
            Some(Name::End1) if first.is_none() && second.is_none() => {
                first = Some(at);
                sections.first = 0..at;
                begin = at + 1;
            }
            Some(Name::End2) if first.is_some() && second.is_none() => {
                second = Some(at);
                sections.second = begin..at;
            }
            Some(Name::End) if second.is_some() => {
                if open.is_some() {
                    errors.push(Error::new(Fault::CallWrong, span));
                }
                end = Some(at);
            }
            Some(Name::End1 | Name::End2 | Name::End) => errors.push(Error::new(Fault::EndWrong, span)),
            Some(Name::Sp) => {
                let number = instruction.number().unwrap_or(0);
                let is_twice = sections.subprograms.iter().any(|(other, _)| *other == number);
                if second.is_none() || open.is_some() || is_twice {
                    errors.push(Error::new(Fault::CallWrong, span));
                }
                open = Some((number, at + 1, span));
            }
            Some(Name::Spe) => match open.take() {
                Some((number, from, _)) => sections.subprograms.push((number, from..at)),
                None => errors.push(Error::new(Fault::CallWrong, span)),
            },
            _ if second.is_some() && open.is_none() => {
                // One alarm for a run of instructions that nothing carries out.
                let is_first = at
                    .checked_sub(1)
                    .and_then(|b| ladder.instructions.get(b))
                    .is_some_and(|before| matches!(before.name(), Some(Name::End2 | Name::Spe)));
                if is_first {
                    errors.push(Error::new(Fault::OutsideLevels, span));
                }
            }
            _ => {}
        }
    }
    if let Some((_, _, span)) = open.filter(|_| end.is_none()) {
        errors.push(Error::new(Fault::CallWrong, span));
    }
    for missing in [(first, "END1"), (second, "END2")] {
        if let (None, name) = missing {
            errors.push(Error::about(Fault::EndWrong, ladder.end, name));
        }
    }
    // Where there are no subprograms, END2 is the end as well.
    if end.is_none() && second.is_some() && !sections.subprograms.is_empty() {
        errors.push(Error::about(Fault::EndWrong, ladder.end, "END"));
    }
    sections
}

/// The network that is being read.
#[derive(Default)]
struct Network {
    /// Results on the stack.
    depth: usize,
    /// Where it began.
    start: Span,
    rows: u32,
    /// Whether a coil or function took its result.
    has_output: bool,
    /// The function whose W1 is on the line, until a coil takes it.
    from: Option<(&'static Row, Span)>,
}

fn networks(instructions: &[Instruction], errors: &mut Vec<Error>) {
    let mut network = Network::default();
    for instruction in instructions {
        let span = instruction.span;
        match &instruction.code {
            Code::Basic(Basic::Rd | Basic::RdNot, _) => {
                network.end(errors);
                network = Network { depth: 1, start: span, rows: 1, ..Network::default() };
            }
            Code::Basic(basic, address) => network.basic(*basic, *address, span, errors),
            Code::Function(row, ..) => network.function(row, span, errors),
        }
    }
    network.end(errors);
}

impl Network {
    /// At the next line to the rail: everything must have led somewhere.
    fn end(&mut self, errors: &mut Vec<Error>) {
        if let Some((row, span)) = self.from
            && row.output == Output::Must
        {
            errors.push(Error::new(Fault::NoOutput, span));
        } else if self.depth > 1 || (self.depth == 1 && !self.has_output) {
            errors.push(Error::new(Fault::Incomplete, self.start));
        }
        *self = Network::default();
    }

    fn basic(&mut self, basic: Basic, address: Option<crate::Address>, span: Span, errors: &mut Vec<Error>) {
        match basic {
            Basic::AndStk | Basic::OrStk => {
                if self.depth < 2 {
                    errors.push(Error::new(Fault::VerticalLine, span));
                } else {
                    self.depth -= 1;
                }
                return;
            }
            _ if self.depth == 0 => {
                errors.push(Error::new(Fault::LineOpen, span));
                // Told once a network.
                *self = Network { depth: 1, start: span, rows: 1, ..Network::default() };
            }
            Basic::RdStk | Basic::RdNotStk => {
                self.rows += 1;
                if self.depth == STACK {
                    errors.push(Error::new(Fault::Unsupported, span));
                } else {
                    self.depth += 1;
                }
                self.has_output = false;
            }
            Basic::Or | Basic::OrNot => self.rows += 1,
            _ => {}
        }
        if basic.is_coil() {
            // A coil beside the first is a row of its own.
            self.rows += u32::from(self.has_output);
            if self.depth > 1 {
                errors.push(Error::new(Fault::Incomplete, span));
                self.depth = 1;
            }
            let is_no_w1 = self.from.is_some_and(|(row, _)| row.output == Output::Never);
            if is_no_w1 || address.is_some_and(|a| a.area.is_input() || a.is_system()) {
                errors.push(Error::new(Fault::IllegalOutput, span));
            }
            self.from = None;
            self.has_output = true;
        } else {
            if let Some((row, at)) = self.from.take()
                && row.output != Output::May
            {
                // Only a coil may follow a function.
                let fault = if row.output == Output::Must { Fault::NoOutput } else { Fault::IllegalOutput };
                errors.push(Error::new(fault, if row.output == Output::Must { at } else { span }));
            }
            self.has_output = false;
        }
        if self.rows == ROWS + 1 {
            errors.push(Error::about(Fault::TooManyRows, span, ROWS.to_string()));
            self.rows += 1;
        }
    }

    fn function(&mut self, row: &'static Row, span: Span, errors: &mut Vec<Error>) {
        let takes = row.conditions.len();
        if takes == 0 {
            // It stands between networks.
            if self.depth > 0 && !self.has_output {
                errors.push(Error::new(Fault::Superfluous, self.start));
                *self = Network::default();
            }
            return self.end(errors);
        }
        let has = if self.has_output { 0 } else { self.depth };
        match has.cmp(&takes) {
            std::cmp::Ordering::Less => errors.push(Error::about(
                Fault::NotConnected,
                span,
                row.conditions.get(has).copied().unwrap_or_default(),
            )),
            std::cmp::Ordering::Greater => errors.push(Error::new(Fault::Superfluous, self.start)),
            std::cmp::Ordering::Equal => {}
        }
        self.depth = 1;
        self.has_output = true;
        self.from = Some((row, span));
    }
}

/// JMP with JMPE, COM with COME, labels with JMPB and JMPC.
fn jumps(instructions: &[Instruction], sections: &Sections, errors: &mut Vec<Error>) {
    let subprograms = sections.subprograms.iter().map(|(_, range)| (range, true));
    let levels = [(&sections.first, false), (&sections.second, false)];
    for (range, is_subprogram) in levels.into_iter().chain(subprograms) {
        section(instructions, range, is_subprogram, errors);
    }
    // A label of either level is one that JMPC may mean.
    let mut labels = FxHashSet::default();
    for range in [&sections.first, &sections.second] {
        for instruction in instructions.get(range.clone()).unwrap_or_default() {
            if instruction.name() == Some(Name::Lbl) {
                labels.extend(instruction.number());
            }
        }
    }
    for instruction in instructions {
        let is_lost = instruction.number().is_none_or(|number| !labels.contains(&number));
        if instruction.name() == Some(Name::Jmpc) && is_lost {
            errors.push(Error::new(Fault::JumpWrong, instruction.span));
        }
    }
}

fn section(all: &[Instruction], range: &Range<usize>, is_subprogram: bool, errors: &mut Vec<Error>) {
    let mut labels = FxHashSet::default();
    let mut jump: Option<Span> = None;
    let mut com: Option<Span> = None;
    // Coils that a JMP or COM with a number still covers.
    let mut coils: Option<(Fault, i64, Span)> = None;
    let instructions = all.get(range.clone()).unwrap_or_default();
    for instruction in instructions {
        let span = instruction.span;
        let is_coil = matches!(&instruction.code, Code::Basic(basic, _) if basic.is_coil());
        if let Some((fault, left, _)) = &mut coils {
            let is_com = *fault == Fault::ComWrong;
            let is_jump = matches!(instruction.name(), Some(Name::Jmp | Name::Com | Name::Lbl));
            if is_jump || (is_com && instruction.name().is_some()) {
                errors.push(Error::new(*fault, span));
                coils = None;
            } else if is_coil {
                *left -= 1;
                if *left == 0 {
                    coils = None;
                }
            }
        }
        let number = instruction.number().unwrap_or(0);
        let wrong = match instruction.name() {
            // Appendix 2: 1003 where a function stands between COM and COME; a jump into their midst would pass the
            // condition.
            Some(name) if com.is_some() && !matches!(name, Name::Com | Name::Come) => Some(Fault::ComWrong),
            Some(Name::Jmp) if number > 0 => {
                coils = Some((Fault::JumpWrong, number, span));
                None
            }
            Some(Name::Com) if number > 0 => {
                coils = Some((Fault::ComWrong, number, span));
                None
            }
            // Appendix 2: 1015 where JMP is used again before the first has ended.
            Some(Name::Jmp) => jump.replace(span).map(|_| Fault::JumpWrong),
            Some(Name::Jmpe) => jump.take().is_none().then_some(Fault::JumpWrong),
            Some(Name::Com) => com.replace(span).map(|_| Fault::ComWrong),
            Some(Name::Come) => com.take().is_none().then_some(Fault::ComWrong),
            Some(Name::Lbl) => (!labels.insert(number)).then_some(Fault::JumpWrong),
            Some(Name::Jmpc) => (!is_subprogram).then_some(Fault::JumpWrong),
            _ => None,
        };
        errors.extend(wrong.map(|fault| Error::new(fault, span)));
    }
    if let Some(span) = jump {
        errors.push(Error::new(Fault::JumpWrong, span));
    }
    if let Some(span) = com {
        errors.push(Error::new(Fault::ComWrong, span));
    }
    if let Some((fault, _, span)) = coils {
        errors.push(Error::new(fault, span));
    }
    for instruction in instructions {
        if instruction.name() == Some(Name::Jmpb) && !labels.contains(&instruction.number().unwrap_or(0)) {
            errors.push(Error::new(Fault::JumpWrong, instruction.span));
        }
    }
}

/// CALL and CALLU: to subprograms that exist, that do not call themselves, and not too deep.
fn calls(instructions: &[Instruction], sections: &Sections, errors: &mut Vec<Error>) {
    let index: FxHashMap<i64, usize> =
        sections.subprograms.iter().enumerate().map(|(at, (number, _))| (*number, at)).collect();
    let called = |range: &Range<usize>| -> Vec<(usize, Span)> {
        let calls = instructions.get(range.clone()).unwrap_or_default().iter();
        calls
            .filter(|i| matches!(i.name(), Some(Name::Call | Name::Callu)))
            .filter_map(|i| Some((*index.get(&i.number()?)?, i.span)))
            .collect()
    };
    for instruction in instructions {
        let is_call = matches!(instruction.name(), Some(Name::Call | Name::Callu));
        if is_call && instruction.number().is_none_or(|number| !index.contains_key(&number)) {
            errors.push(Error::new(Fault::CallWrong, instruction.span));
        }
    }
    // How deep the calls below each subprogram go, found in rounds: one that is still growing after as many
    // rounds as may be nested calls itself, or too deep.
    let calls: Vec<Vec<(usize, Span)>> =
        sections.subprograms.iter().map(|(_, range)| called(range)).collect();
    let mut depth = vec![1usize; calls.len()];
    for _ in 0..=CALLS {
        let next: Vec<usize> = calls
            .iter()
            .map(|calls| 1 + calls.iter().filter_map(|(to, _)| depth.get(*to)).max().copied().unwrap_or(0))
            .collect();
        depth = next;
    }
    for range in [&sections.first, &sections.second] {
        for (to, span) in called(range) {
            if depth.get(to).is_some_and(|depth| *depth > CALLS) {
                errors.push(Error::about(Fault::CallWrong, span, CALLS.to_string()));
            }
        }
    }
}

/// Timers, counters, edges and outputs that are used twice; too many SFT.
fn numbers(instructions: &[Instruction], errors: &mut Vec<Error>) {
    let mut used = FxHashSet::default();
    let mut outputs = FxHashSet::default();
    let mut shifts = 0;
    for instruction in instructions {
        let span = instruction.span;
        if let Code::Basic(Basic::Wrt | Basic::WrtNot, Some(address)) = &instruction.code
            && !outputs.insert(*address)
        {
            errors.push(Error::about(Fault::OutputTwice, span, address.to_string()));
        }
        let Some(name) = instruction.name() else { continue };
        let (kind, fault) = match name {
            Name::Tmr => (Name::Tmr, Fault::TimerTwice),
            Name::Tmrb => (Name::Tmrb, Fault::TimerTwice),
            Name::Ctr => (Name::Ctr, Fault::CounterTwice),
            // They share their numbers.
            Name::Difu | Name::Difd => (Name::Difu, Fault::EdgeTwice),
            Name::Sft => {
                shifts += 1;
                if shifts == SHIFTS + 1 {
                    errors.push(Error::about(Fault::TooManyShifts, span, SHIFTS.to_string()));
                }
                continue;
            }
            _ => continue,
        };
        if let Some(number) = instruction.number()
            && !used.insert((kind, number))
        {
            errors.push(Error::about(fault, span, number.to_string()));
        }
    }
}
