//! The functional instructions while the ladder runs.
//!
//! Each is compiled to a value with its places and constants. It finds its conditions on the stack, ST0 the
//! last of them, and leaves W1 in ST0. Where a PMC says that W1 does not change, it is read back from the
//! coil that follows, so that a function keeps nothing of its own.

mod binary;
mod decimal;
mod logic;
mod rotation;
mod tables;
mod timing;

use crate::address::Address;
use crate::instruction::{Basic, Name, Parameter, Row};
use crate::list::width_of;
use crate::memory::{Memory, Width};

pub(crate) use timing::State;

/// A constant, or the place of a value.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Operand {
    /// The constant.
    Constant(i32),
    /// The place.
    At(u16),
}

/// A table in the signals, which ends with its area.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Table {
    at: u16,
    /// The place behind the area.
    end: u16,
}

impl Table {
    /// The place of a value; `None` beyond the area.
    fn place(self, index: u32, width: Width) -> Option<u16> {
        let bytes = u32::from(width.bytes());
        let at = u32::from(self.at).checked_add(index.checked_mul(bytes)?)?;
        (at + bytes <= u32::from(self.end)).then(|| u16::try_from(at).ok()).flatten()
    }
}

/// What W1 is where the function does not change it: the coil that follows.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Held {
    at: u16,
    bit: u8,
    not: bool,
}

impl Held {
    fn read(self, memory: &Memory) -> bool {
        ((memory.get(self.at) >> (self.bit & 7)) & 1 == 1) != self.not
    }
}

/// The four operations.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Operation {
    Add,
    Subtract,
    Multiply,
    Divide,
}

/// The operations on bits.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Bitwise {
    Eor,
    And,
    Or,
}

/// A function that is compiled.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Function {
    Timer { number: u16 },
    FixedTimer { number: u16, time_us: u64 },
    Counter { number: u16 },
    TimerAt { unit_ms: u32, time: u16, register: u16 },
    CounterAt { preset: u16, register: u16 },
    Edge { number: u16, rising: bool },
    Move { mask: u8, from: u16, to: u16 },
    MoveBytes { from: u16, to: u16, bytes: u16 },
    Parity { from: u16, held: Held },
    Compare { operand: Operand, with: u16, held: Held },
    Coincide { operand: Operand, with: u16, held: Held },
    CompareBinary { width: Width, operand: Operand, with: u16 },
    Arithmetic { operation: Operation, first: u16, second: Operand, to: u16, held: Held },
    ArithmeticBinary { operation: Operation, width: Width, first: u16, second: Operand, to: u16, held: Held },
    Define { value: u32, to: u16 },
    DefineBinary { width: Width, value: i32, to: u16 },
    Convert { from: u16, to: u16, held: Held },
    ConvertBinary { width: Width, from: u16, to: u16, held: Held },
    Rotate { positions: u32, current: u16, goal: u16, to: u16, held: Held },
    RotateBinary { width: Width, positions: u16, current: u16, goal: u16, to: u16, held: Held },
    Code { first: u32, values: u32, from: u16, to: u16, held: Held },
    CodeBinary { width: Width, first: u32, values: u32, from: u16, to: u16, held: Held },
    Decode { from: u16, digits: u16 },
    DecodeBinary { width: Width, from: u16, first: i32, bytes: u16, to: u16 },
    Shift { at: u16, held: Held },
    Search { values: u32, table: Table, key: u16, to: u16, held: Held },
    SearchBinary { width: Width, values: u16, table: Table, key: u16, to: u16, held: Held },
    Transfer { values: u32, table: Table, data: u16, index: u16, held: Held },
    TransferBinary { width: Width, values: u16, table: Table, data: u16, index: u16, held: Held },
    Bitwise { operation: Bitwise, width: Width, first: u16, second: Operand, to: u16 },
    Not { width: Width, from: u16, to: u16 },
    Nothing,
}

/// Parameters by their number; the compiler has checked that each is there and of its kind.
struct Given<'a> {
    parameters: &'a [Parameter],
    place: &'a dyn Fn(Address) -> u16,
}

impl Given<'_> {
    fn number(&self, n: usize) -> i64 {
        match self.parameters.get(n) {
            Some(Parameter::Number(number)) => *number,
            _ => 0,
        }
    }

    fn count(&self, n: usize) -> u32 {
        u32::try_from(self.number(n)).unwrap_or(0)
    }

    fn short(&self, n: usize) -> u16 {
        u16::try_from(self.number(n)).unwrap_or(0)
    }

    /// A constant of up to 32 bits, with a sign or as a pattern of bits.
    fn constant(&self, n: usize) -> i32 {
        let value = self.number(n);
        i32::try_from(value).unwrap_or_else(|_| u32::try_from(value).unwrap_or(0).cast_signed())
    }

    fn at(&self, n: usize) -> u16 {
        match self.parameters.get(n) {
            Some(Parameter::At(address)) => (self.place)(*address),
            _ => crate::address::ZERO,
        }
    }

    fn operand(&self, n: usize) -> Operand {
        match self.parameters.get(n) {
            Some(Parameter::At(address)) => Operand::At((self.place)(*address)),
            _ => Operand::Constant(self.constant(n)),
        }
    }

    fn table(&self, n: usize) -> Table {
        match self.parameters.get(n) {
            Some(Parameter::At(address)) => {
                let at = (self.place)(*address);
                Table { at, end: at.saturating_add(address.end() - address.place()) }
            }
            _ => Table { at: 0, end: 0 },
        }
    }
}

impl Function {
    /// Compiles a function. `place` says where an address is read from, which differs between the levels;
    /// `table` is where its values begin among those of the ladder, and `coil` the coil that follows.
    pub(crate) fn new(
        row: &Row,
        parameters: &[Parameter],
        (first, values): (u32, u32),
        place: &dyn Fn(Address) -> u16,
        coil: Option<(Basic, Address)>,
    ) -> Function {
        let p = Given { parameters, place };
        let width = Width::of(width_of(row, parameters));
        let held = match coil {
            Some((basic, coil)) => {
                let bit = coil.bit.unwrap_or(0);
                Held { at: coil.place(), bit, not: basic == Basic::WrtNot }
            }
            None => Held { at: crate::address::ZERO, bit: 0, not: false },
        };
        let decimal = |operation| Function::Arithmetic {
            operation,
            first: p.at(1),
            second: p.operand(2),
            to: p.at(3),
            held,
        };
        let binary = |operation| Function::ArithmeticBinary {
            operation,
            width,
            first: p.at(1),
            second: p.operand(2),
            to: p.at(3),
            held,
        };
        let bitwise = |operation| Function::Bitwise {
            operation,
            width,
            first: p.at(1),
            second: p.operand(2),
            to: p.at(3),
        };
        let copy = |bytes| Function::MoveBytes { from: p.at(0), to: p.at(1), bytes };
        match row.name {
            Name::Tmr => Function::Timer { number: p.short(0) },
            Name::Tmrb => Function::FixedTimer { number: p.short(0), time_us: u64::from(p.count(1)) * 1000 },
            Name::Ctr => Function::Counter { number: p.short(0) },
            Name::Tmrc => {
                Function::TimerAt { unit_ms: timing::unit_ms(p.count(0)), time: p.at(1), register: p.at(2) }
            }
            Name::Ctrc => Function::CounterAt { preset: p.at(0), register: p.at(1) },
            Name::Difu => Function::Edge { number: p.short(0), rising: true },
            Name::Difd => Function::Edge { number: p.short(0), rising: false },
            Name::Move => {
                let mask = (p.count(0) << 4 | p.count(1)) as u8;
                Function::Move { mask, from: p.at(2), to: p.at(3) }
            }
            Name::Movb => copy(1),
            Name::Movw => copy(2),
            Name::Movd => copy(4),
            Name::Movn => Function::MoveBytes { from: p.at(1), to: p.at(2), bytes: p.short(0) },
            Name::Pari => Function::Parity { from: p.at(0), held },
            Name::Comp => Function::Compare { operand: p.operand(1), with: p.at(2), held },
            Name::Coin => Function::Coincide { operand: p.operand(1), with: p.at(2), held },
            Name::Compb => Function::CompareBinary { width, operand: p.operand(1), with: p.at(2) },
            Name::Add => decimal(Operation::Add),
            Name::Sub => decimal(Operation::Subtract),
            Name::Mul => decimal(Operation::Multiply),
            Name::Div => decimal(Operation::Divide),
            Name::Addb => binary(Operation::Add),
            Name::Subb => binary(Operation::Subtract),
            Name::Mulb => binary(Operation::Multiply),
            Name::Divb => binary(Operation::Divide),
            Name::Nume => Function::Define { value: p.count(0), to: p.at(1) },
            Name::Numeb => Function::DefineBinary { width, value: p.constant(1), to: p.at(2) },
            Name::Dcnv => Function::Convert { from: p.at(0), to: p.at(1), held },
            Name::Dcnvb => Function::ConvertBinary { width, from: p.at(1), to: p.at(2), held },
            Name::Rot => {
                Function::Rotate { positions: p.count(0), current: p.at(1), goal: p.at(2), to: p.at(3), held }
            }
            Name::Rotb => Function::RotateBinary {
                width,
                positions: p.at(1),
                current: p.at(2),
                goal: p.at(3),
                to: p.at(4),
                held,
            },
            Name::Cod => Function::Code { first, values, from: p.at(1), to: p.at(2), held },
            Name::Codb => Function::CodeBinary { width, first, values, from: p.at(2), to: p.at(3), held },
            Name::Dec => Function::Decode { from: p.at(0), digits: p.short(1) },
            Name::Decb => {
                let bytes = (p.short(0) / 10 % 100).max(1);
                Function::DecodeBinary { width, from: p.at(1), first: p.constant(2), bytes, to: p.at(3) }
            }
            Name::Sft => Function::Shift { at: p.at(0), held },
            Name::Dsch => {
                Function::Search { values: p.count(0), table: p.table(1), key: p.at(2), to: p.at(3), held }
            }
            Name::Dschb => Function::SearchBinary {
                width,
                values: p.at(1),
                table: p.table(2),
                key: p.at(3),
                to: p.at(4),
                held,
            },
            Name::Xmov => Function::Transfer {
                values: p.count(0),
                table: p.table(1),
                data: p.at(2),
                index: p.at(3),
                held,
            },
            Name::Xmovb => Function::TransferBinary {
                width,
                values: p.at(1),
                table: p.table(2),
                data: p.at(3),
                index: p.at(4),
                held,
            },
            Name::Eor => bitwise(Bitwise::Eor),
            Name::And => bitwise(Bitwise::And),
            Name::Or => bitwise(Bitwise::Or),
            Name::Not => Function::Not { width, from: p.at(1), to: p.at(2) },
            // Carried out by the scan itself, or nothing at all.
            Name::End1
            | Name::End2
            | Name::End
            | Name::Com
            | Name::Come
            | Name::Jmp
            | Name::Jmpe
            | Name::Call
            | Name::Callu
            | Name::Jmpb
            | Name::Lbl
            | Name::Jmpc
            | Name::Sp
            | Name::Spe
            | Name::Nop => Function::Nothing,
        }
    }

    /// Carries it out on its conditions, ST0 as bit 0 and so on; gives ST0 behind it: W1, where it has one.
    pub(crate) fn run(self, memory: &mut Memory, state: &mut State, tables: &[i32], conditions: u32) -> bool {
        let line = Line(conditions);
        use Function as F;
        match self {
            F::Timer { number } => state.timer(memory, number, line.st(0)),
            F::FixedTimer { number, time_us } => state.fixed_timer(number, time_us, line.st(0)),
            F::Counter { number } => state.counter(memory, number, line),
            F::TimerAt { unit_ms, time, register } => {
                state.timer_at(memory, unit_ms, (time, register), line.st(0))
            }
            F::CounterAt { preset, register } => timing::counter_at(memory, preset, register, line),
            F::Edge { number, rising } => state.edge(number, rising, line.st(0)),
            F::Move { mask, from, to } => logic::masked_move(memory, mask, from, to, line),
            F::MoveBytes { from, to, bytes } => logic::copy(memory, from, to, bytes, line),
            F::Parity { from, held } => logic::parity(memory, from, held, line),
            F::Compare { operand, with, held } => decimal::compare(memory, operand, with, held, line),
            F::Coincide { operand, with, held } => decimal::coincide(memory, operand, with, held, line),
            F::CompareBinary { width, operand, with } => binary::compare(memory, width, operand, with, line),
            F::Arithmetic { operation, first, second, to, held } => {
                decimal::arithmetic(memory, operation, (first, second, to), held, line)
            }
            F::ArithmeticBinary { operation, width, first, second, to, held } => {
                binary::arithmetic(memory, operation, width, (first, second, to), held, line)
            }
            F::Define { value, to } => decimal::define(memory, value, to, line),
            F::DefineBinary { width, value, to } => binary::define(memory, width, value, to, line),
            F::Convert { from, to, held } => decimal::convert(memory, from, to, held, line),
            F::ConvertBinary { width, from, to, held } => {
                binary::convert(memory, width, from, to, held, line)
            }
            F::Rotate { positions, current, goal, to, held } => {
                rotation::decimal(memory, positions, (current, goal, to), held, line)
            }
            F::RotateBinary { width, positions, current, goal, to, held } => {
                rotation::binary(memory, width, positions, (current, goal, to), held, line)
            }
            F::Code { first, values, from, to, held } => {
                tables::code(memory, values_of(tables, first, values), from, to, held, line)
            }
            F::CodeBinary { width, first, values, from, to, held } => {
                tables::code_binary(memory, width, values_of(tables, first, values), (from, to), held, line)
            }
            F::Decode { from, digits } => tables::decode(memory, from, digits, line),
            F::DecodeBinary { width, from, first, bytes, to } => {
                tables::decode_binary(memory, width, from, first, (bytes, to), line)
            }
            F::Shift { at, held } => logic::shift(memory, at, held, line),
            F::Search { values, table, key, to, held } => {
                state.cost = state.cost.saturating_add(values / 4);
                tables::search(memory, values, table, (key, to), held, line)
            }
            F::SearchBinary { width, values, table, key, to, held } => {
                let values = u32::try_from(memory.read(values, width)).unwrap_or(0);
                state.cost = state.cost.saturating_add(values.min(10_000) / 4);
                tables::search_binary(memory, width, values, table, (key, to), held, line)
            }
            F::Transfer { values, table, data, index, held } => {
                tables::transfer(memory, values, table, (data, index), held, line)
            }
            F::TransferBinary { width, values, table, data, index, held } => {
                tables::transfer_binary(memory, width, values, table, (data, index), held, line)
            }
            F::Bitwise { operation, width, first, second, to } => {
                logic::bitwise(memory, operation, width, (first, second, to), line)
            }
            F::Not { width, from, to } => logic::not(memory, width, from, to, line),
            F::Nothing => line.st(0),
        }
    }
}

fn values_of(tables: &[i32], first: u32, values: u32) -> &[i32] {
    tables.get(first as usize..).and_then(|t| t.get(..values as usize)).unwrap_or_default()
}

/// The conditions of a function.
#[derive(Clone, Copy)]
pub(crate) struct Line(u32);

impl Line {
    /// The condition at a place of the stack.
    fn st(self, n: u32) -> bool {
        (self.0 >> n) & 1 == 1
    }

    /// Two digits or four, as BYT says.
    fn digits(self, n: u32) -> Width {
        if self.st(n) { Width::Two } else { Width::One }
    }

    /// W1 of a function with RST as ST1 and ACT as ST0: 0 while it is reset, unchanged while it does not
    /// act, else what `act` gives.
    fn act(self, memory: &mut Memory, held: Held, act: impl FnOnce(&mut Memory) -> bool) -> bool {
        match (self.st(1), self.st(0)) {
            (true, _) => false,
            (false, false) => held.read(memory),
            (false, true) => act(memory),
        }
    }
}
