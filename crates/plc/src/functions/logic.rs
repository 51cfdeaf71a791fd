//! MOVE, MOVB MOVW MOVD MOVN, PARI, SFT, EOR AND OR NOT.

use super::{Bitwise, Held, Line, Operand};
use crate::memory::{Memory, Width};

pub(super) fn masked_move(memory: &mut Memory, mask: u8, from: u16, to: u16, line: Line) -> bool {
    if line.st(0) {
        memory.put(to, memory.get(from) & mask);
    }
    line.st(0)
}

/// Bytes from the lowest on; where the ranges overlap, as if all had been read first.
pub(super) fn copy(memory: &mut Memory, from: u16, to: u16, bytes: u16, line: Line) -> bool {
    let step = |memory: &mut Memory, n: u16| memory.put(to.wrapping_add(n), memory.get(from.wrapping_add(n)));
    match (line.st(0), to > from) {
        (false, _) => {}
        (true, true) => (0..bytes).rev().for_each(|n| step(memory, n)),
        (true, false) => (0..bytes).for_each(|n| step(memory, n)),
    }
    line.st(0)
}

/// O.E ST2, RST ST1, ACT ST0. W1: the number of ones is not even, or where O.E is on, not odd.
pub(super) fn parity(memory: &mut Memory, from: u16, held: Held, line: Line) -> bool {
    line.act(memory, held, |memory| {
        let is_odd = memory.get(from).count_ones() % 2 == 1;
        is_odd != line.st(2)
    })
}

/// DIR ST3 (on: to the right), CONT ST2 (bits that are on stay), RST ST1, ACT ST0. W1: the bit that fell out.
pub(super) fn shift(memory: &mut Memory, at: u16, held: Held, line: Line) -> bool {
    line.act(memory, held, |memory| {
        let word = (memory.read(at, Width::Two) & 0xFFFF) as u16;
        let (moved, out) = match line.st(3) {
            true => (word >> 1, word & 1),
            false => (word << 1, word >> 15),
        };
        let kept = if line.st(2) { word } else { 0 };
        memory.write(at, Width::Two, i32::from(moved | kept));
        out == 1
    })
}

pub(super) fn bitwise(
    memory: &mut Memory,
    operation: Bitwise,
    width: Width,
    (first, second, to): (u16, Operand, u16),
    line: Line,
) -> bool {
    if line.st(0) {
        let a = memory.read(first, width);
        let b = match second {
            Operand::Constant(constant) => constant,
            Operand::At(at) => memory.read(at, width),
        };
        let result = match operation {
            Bitwise::Eor => a ^ b,
            Bitwise::And => a & b,
            Bitwise::Or => a | b,
        };
        memory.write(to, width, result);
    }
    line.st(0)
}

pub(super) fn not(memory: &mut Memory, width: Width, from: u16, to: u16, line: Line) -> bool {
    if line.st(0) {
        memory.write(to, width, !memory.read(from, width));
    }
    line.st(0)
}
