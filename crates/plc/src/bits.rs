//! Contacts and coils as micro-operations without a branch.
//!
//! A `match` over kinds of instructions costs a mispredicted jump at every few of them, which is most of the
//! time that a ladder takes. Here every basic instruction is the same arithmetic with other masks: it reads a
//! byte, makes a contact of it, joins it to ST0 and writes the byte back as a coil would; a contact's masks for
//! writing change nothing, a coil's for joining keep ST0.
//!
//! Results that wait lie in bytes of their own ([`WAITING`]), since where each of them is is known before the ladder
//! runs: RD.STK writes ST0 there like a coil, AND.STK and OR.STK read it like a contact.

use crate::address::{WAITING, ZERO};
use crate::check::STACK;
use crate::instruction::Basic;
use crate::memory::Memory;

/// One contact or coil.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub(crate) struct BitOp {
    /// Place of the byte.
    at: u16,
    /// The bit of it.
    mask: u8,
    /// 1 turns the contact or coil round.
    not: u8,
    /// 1 keeps ST0 where the contact is 0.
    keep: u8,
    /// 1 sets ST0 where the contact is 1.
    join: u8,
    /// Bits that a coil leaves as they are where its line is off.
    hold: u8,
    /// Bits that it sets where its line is on.
    set: u8,
}

impl BitOp {
    fn contact(at: u16, mask: u8, not: bool, [keep, join]: [u8; 2]) -> BitOp {
        BitOp { at, mask, not: u8::from(not), keep, join, hold: !0, set: 0 }
    }

    /// `clears` where the line is off, `sets` where it is on.
    fn coil(at: u16, mask: u8, not: bool, [clears, sets]: [bool; 2]) -> BitOp {
        let of = |is: bool| if is { mask } else { 0 };
        BitOp { at, mask, not: u8::from(not), keep: 1, join: 0, hold: !of(clears), set: of(sets) }
    }

    /// What an instruction comes to, where `depth` results are on the stack, and will be: ST0 that is to wait, and the
    /// instruction itself.
    pub(crate) fn of(basic: Basic, at: u16, bit: u8, depth: &mut usize) -> (Option<BitOp>, BitOp) {
        let mask = 1u8 << (bit & 7);
        let [read, and, or] = [[0, 1], [0, 0], [1, 1]];
        let own = match basic {
            Basic::Rd | Basic::RdNot => {
                *depth = 1;
                BitOp::contact(at, mask, basic == Basic::RdNot, read)
            }
            Basic::And | Basic::AndNot => BitOp::contact(at, mask, basic == Basic::AndNot, and),
            Basic::Or | Basic::OrNot => BitOp::contact(at, mask, basic == Basic::OrNot, or),
            Basic::RdStk | Basic::RdNotStk => {
                let waits = (*depth > 0).then(|| BitOp::coil(waiting(*depth), 1, false, [true, true]));
                *depth = STACK.min(*depth + 1);
                return (waits, BitOp::contact(at, mask, basic == Basic::RdNotStk, read));
            }
            Basic::AndStk | Basic::OrStk => {
                *depth = depth.saturating_sub(1).max(1);
                BitOp::contact(waiting(*depth), 1, false, if basic == Basic::AndStk { and } else { or })
            }
            Basic::Wrt => BitOp::coil(at, mask, false, [true, true]),
            Basic::WrtNot => BitOp::coil(at, mask, true, [true, true]),
            Basic::Set => BitOp::coil(at, mask, false, [false, true]),
            // What clears where a line is off, on a line that is turned round.
            Basic::Rst => BitOp::coil(at, mask, true, [true, false]),
        };
        (None, own)
    }

    /// What never conducts.
    pub(crate) fn off() -> BitOp {
        BitOp::contact(ZERO, 1, false, [0, 1])
    }

    /// Carries it out; gives ST0 behind it, 0 or 1.
    #[inline(always)]
    pub(crate) fn run(self, memory: &mut Memory, st0: u8) -> u8 {
        let at = usize::from(self.at);
        let byte = memory.bytes[at];
        let contact = u8::from(byte & self.mask != 0) ^ self.not;
        let st0 = (st0 & (contact | self.keep)) | (contact & self.join);
        let on = 0u8.wrapping_sub(st0 ^ self.not);
        let written = (byte & (self.hold | on)) | (self.set & on);
        memory.bytes[at] = byte ^ ((byte ^ written) & memory.free[at]);
        st0
    }

    /// Whether the contact conducts, or the coil is on.
    pub(crate) fn is_on(self, memory: &Memory) -> bool {
        (memory.bytes[usize::from(self.at)] & self.mask != 0) != (self.not == 1)
    }
}

/// Where ST0 waits while `depth` results are on the stack.
fn waiting(depth: usize) -> u16 {
    // Below STACK.
    WAITING + (depth.clamp(1, STACK) - 1) as u16
}

/// The stack as the functions see it, where `depth` results are on it: ST0 is bit 0, ST1 bit 1 and so on.
pub(crate) fn conditions(memory: &Memory, st0: u8, depth: u8) -> u32 {
    (1..usize::from(depth)).rev().fold(u32::from(st0), |conditions, n| {
        let waits = u32::from(memory.get(waiting(n)) & 1);
        conditions | waits << (usize::from(depth) - n)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Address;

    /// A network of contacts a, b, c at X0.0 to X0.2 and a coil at R0.0.
    fn run(network: &[(Basic, &str)], x: u8, before: bool) -> bool {
        let mut memory = Memory::new();
        memory.set_byte(Address::parse("X0").unwrap(), x);
        let coil = Address::parse("R0.0").unwrap();
        memory.set_bit(coil, before);
        let (mut st0, mut depth) = (0, 0);
        for (basic, address) in network {
            let address = Address::parse(address).unwrap();
            let (waits, own) = BitOp::of(*basic, address.place(), address.bit.unwrap(), &mut depth);
            for op in waits.into_iter().chain([own]) {
                st0 = op.run(&mut memory, st0);
            }
        }
        assert_eq!(memory.byte(Address::parse("X0").unwrap()), x);
        memory.bit(coil)
    }

    #[test]
    fn every_basic_instruction_has_its_truth_table() {
        use Basic::*;
        type Truth = fn(bool, bool, bool, bool) -> bool;
        let (a, b, c, q) = ("X0.0", "X0.1", "X0.2", "R0.0");
        let table: &[(&[(Basic, &str)], Truth)] = &[
            (&[(Rd, a), (Wrt, q)], |a, _, _, _| a),
            (&[(RdNot, a), (Wrt, q)], |a, _, _, _| !a),
            (&[(Rd, a), (And, b), (Wrt, q)], |a, b, _, _| a && b),
            (&[(Rd, a), (AndNot, b), (Wrt, q)], |a, b, _, _| a && !b),
            (&[(Rd, a), (Or, b), (Wrt, q)], |a, b, _, _| a || b),
            (&[(Rd, a), (OrNot, b), (Wrt, q)], |a, b, _, _| a || !b),
            (&[(Rd, a), (RdStk, b), (Or, c), (AndStk, c), (Wrt, q)], |a, b, c, _| a && (b || c)),
            (&[(Rd, a), (RdStk, b), (And, c), (OrStk, c), (Wrt, q)], |a, b, c, _| a || (b && c)),
            (&[(Rd, a), (RdNotStk, b), (OrStk, c), (Wrt, q)], |a, b, _, _| a || !b),
            (&[(Rd, a), (RdStk, b), (RdStk, c), (AndStk, c), (OrStk, c), (Wrt, q)], |a, b, c, _| {
                a || (b && c)
            }),
            (&[(Rd, a), (WrtNot, q)], |a, _, _, _| !a),
            (&[(Rd, a), (Set, q)], |a, _, _, q| a || q),
            (&[(Rd, a), (Rst, q)], |a, _, _, q| !a && q),
            (&[(Rd, a), (Wrt, q), (AndNot, b), (Set, q)], |a, _, _, _| a),
        ];
        for (network, truth) in table {
            for bits in 0..16u8 {
                let on = |n: u8| bits >> n & 1 == 1;
                let is = run(network, bits & 7, on(3));
                assert_eq!(is, truth(on(0), on(1), on(2), on(3)), "{network:?} {bits:04b}");
            }
        }
    }
}
