//! COMP, COIN, ADD SUB MUL DIV, NUME, DCNV: values in BCD of two digits or, with BYT, four.
//!
//! A value that is no BCD takes part in nothing: the output stays and W1 tells of an error where it is one.

use super::{Held, Line, Operand, Operation};
use crate::memory::{Memory, Width};

fn operand(memory: &Memory, operand: Operand, digits: Width) -> Option<u32> {
    match operand {
        Operand::Constant(constant) => u32::try_from(constant).ok(),
        Operand::At(at) => memory.read_bcd(at, digits),
    }
}

fn limit(digits: Width) -> u32 {
    match digits {
        Width::One => 100,
        Width::Two => 10_000,
        Width::Four => 100_000_000,
    }
}

/// BYT ST1, ACT ST0. W1: the value is not above the one that it is compared with.
pub(super) fn compare(memory: &mut Memory, value: Operand, with: u16, held: Held, line: Line) -> bool {
    let digits = line.digits(1);
    match (operand(memory, value, digits), memory.read_bcd(with, digits)) {
        (Some(value), Some(with)) if line.st(0) => value <= with,
        _ => held.read(memory),
    }
}

/// BYT ST1, ACT ST0. W1: the values are the same.
pub(super) fn coincide(memory: &mut Memory, value: Operand, with: u16, held: Held, line: Line) -> bool {
    let digits = line.digits(1);
    match (operand(memory, value, digits), memory.read_bcd(with, digits)) {
        (Some(value), Some(with)) if line.st(0) => value == with,
        _ => held.read(memory),
    }
}

/// BYT ST2, RST ST1, ACT ST0. W1: the result has more digits than there is room for, is negative, or there is
/// none. What does not fit loses its upper digits; a negative difference stands as its complement to ten.
pub(super) fn arithmetic(
    memory: &mut Memory,
    operation: Operation,
    (first, second, to): (u16, Operand, u16),
    held: Held,
    line: Line,
) -> bool {
    line.act(memory, held, |memory| {
        let digits = line.digits(2);
        let limit = limit(digits);
        let (Some(a), Some(b)) = (memory.read_bcd(first, digits), operand(memory, second, digits)) else {
            return true;
        };
        let (result, is_wrong) = match operation {
            // Both are below 10,000.
            Operation::Add => (a + b, a + b >= limit),
            Operation::Subtract => ((a + limit).saturating_sub(b), b > a),
            Operation::Multiply => (a * b, a * b >= limit),
            Operation::Divide if b == 0 => return true,
            Operation::Divide => (a / b, false),
        };
        memory.write_bcd(to, digits, result % limit);
        is_wrong
    })
}

/// BYT ST1, ACT ST0.
pub(super) fn define(memory: &mut Memory, value: u32, to: u16, line: Line) -> bool {
    if line.st(0) {
        memory.write_bcd(to, line.digits(1), value);
    }
    line.st(0)
}

/// BYT ST3 (on: two bytes), CNV ST2 (on: BCD to binary), RST ST1, ACT ST0. W1: what should be BCD is none, or
/// the binary value has more digits than there is room for.
pub(super) fn convert(memory: &mut Memory, from: u16, to: u16, held: Held, line: Line) -> bool {
    line.act(memory, held, |memory| {
        let width = line.digits(3);
        if line.st(2) {
            let Some(value) = memory.read_bcd(from, width) else { return true };
            memory.write(to, width, value.cast_signed());
            return false;
        }
        let room = match width {
            Width::One => 0xFF,
            Width::Two | Width::Four => 0xFFFF,
        };
        let value = memory.read(from, width).cast_unsigned() & room;
        if value >= limit(width) {
            return true;
        }
        memory.write_bcd(to, width, value);
        false
    })
}
