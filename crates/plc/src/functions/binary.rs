//! COMPB, ADDB SUBB MULB DIVB, NUMEB, DCNVB: values in binary with a sign, of 1, 2 or 4 bytes.
//!
//! What a result was like stands in R9000, the rest of a division in R9002.

use super::{Held, Line, Operand, Operation};
use crate::address::SYSTEM;
use crate::memory::{Memory, REST, Width, flags};

fn operand(memory: &Memory, operand: Operand, width: Width) -> i64 {
    let value = match operand {
        Operand::Constant(constant) => constant,
        Operand::At(at) => return i64::from(memory.read(at, width)),
    };
    // A constant may be given as a pattern of bits.
    match width {
        Width::One => i64::from((value & 0xFF) as u8 as i8),
        Width::Two => i64::from((value & 0xFFFF) as u16 as i16),
        Width::Four => i64::from(value),
    }
}

fn fits(value: i64, width: Width) -> bool {
    match width {
        Width::One => i8::try_from(value).is_ok(),
        Width::Two => i16::try_from(value).is_ok(),
        Width::Four => i32::try_from(value).is_ok(),
    }
}

fn tell(memory: &mut Memory, value: i64, overflow: bool) {
    let mut told = 0;
    if value == 0 {
        told |= flags::ZERO;
    }
    if value < 0 {
        told |= flags::SIGN;
    }
    if overflow {
        told |= flags::OVERFLOW;
    }
    memory.put(SYSTEM, told);
}

/// ACT ST0. R9000 tells how the value and the one that it is compared with stand.
pub(super) fn compare(memory: &mut Memory, width: Width, value: Operand, with: u16, line: Line) -> bool {
    if line.st(0) {
        let difference = operand(memory, value, width) - i64::from(memory.read(with, width));
        tell(memory, difference, !fits(difference, width));
    }
    line.st(0)
}

/// RST ST1, ACT ST0. W1: the result does not fit, or the divisor is 0. What does not fit loses its upper bits.
pub(super) fn arithmetic(
    memory: &mut Memory,
    operation: Operation,
    width: Width,
    (first, second, to): (u16, Operand, u16),
    held: Held,
    line: Line,
) -> bool {
    line.act(memory, held, |memory| {
        let (a, b) = (i64::from(memory.read(first, width)), operand(memory, second, width));
        let result = match operation {
            Operation::Add => a + b,
            Operation::Subtract => a - b,
            // Below 2^62.
            Operation::Multiply => a * b,
            Operation::Divide if b == 0 => {
                tell(memory, 1, true);
                return true;
            }
            Operation::Divide => {
                memory.write(REST, width, (a % b) as i32);
                a / b
            }
        };
        let overflow = !fits(result, width);
        memory.write(to, width, result as i32);
        tell(memory, result, overflow);
        overflow
    })
}

/// ACT ST0.
pub(super) fn define(memory: &mut Memory, width: Width, value: i32, to: u16, line: Line) -> bool {
    if line.st(0) {
        memory.write(to, width, value);
    }
    line.st(0)
}

/// SIN ST3 (on: the BCD value is negative), CNV ST2 (on: BCD to binary), RST ST1, ACT ST0. W1: what should be
/// BCD is none, or there is no room for the result. The sign of a BCD result stands in R9000.
pub(super) fn convert(memory: &mut Memory, width: Width, from: u16, to: u16, held: Held, line: Line) -> bool {
    line.act(memory, held, |memory| {
        let value = if line.st(2) {
            let Some(digits) = memory.read_bcd(from, width) else { return true };
            let value = if line.st(3) { -i64::from(digits) } else { i64::from(digits) };
            if !fits(value, width) {
                tell(memory, value, true);
                return true;
            }
            memory.write(to, width, value as i32);
            value
        } else {
            let value = i64::from(memory.read(from, width));
            let most = match width {
                Width::One => 99,
                Width::Two => 9_999,
                Width::Four => 99_999_999,
            };
            if value.abs() > most {
                tell(memory, value, true);
                return true;
            }
            memory.write_bcd(to, width, value.unsigned_abs() as u32);
            value
        };
        tell(memory, value, false);
        false
    })
}
