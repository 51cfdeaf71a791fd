//! Contacts and coils as micro-operations without a branch.
//!
//! A `match` over kinds of instructions costs a mispredicted jump at every few of them, which is most of the
//! time that a ladder takes. Here every basic instruction is the same arithmetic with other masks: it reads a
//! byte, makes a contact of it, joins it to the stack and writes the byte back as a coil would; a contact's
//! masks for writing are 0, a coil's for joining keep the stack.

use crate::instruction::Basic;
use crate::memory::Memory;

/// One basic instruction. ST0 is bit 0 of the stack, ST1 bit 1 and so on.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub(crate) struct BitOp {
    /// Place of the byte.
    at: u16,
    /// The bit, 0 to 7.
    bit: u8,
    /// 1 turns the contact or coil round.
    not: u8,
    /// Bits 0 and 1: the stack is pushed by so many; 2 and 3: it is popped by so many; bit 4: the contact
    /// is ST0, not the byte; bit 5: ST0 is kept where the contact is 0; bit 6: ST0 is set by it.
    join: u8,
    /// Bits that a coil clears, whatever its state.
    clear: u8,
    /// Bits that it clears where its line is on.
    reset: u8,
    /// Bits that it sets where its line is on.
    set: u8,
}

const PUSH: u8 = 1;
const POP: u8 = 1 << 2;
const FROM_STACK: u8 = 1 << 4;
const KEEP: u8 = 1 << 5;
const JOIN: u8 = 1 << 6;

impl BitOp {
    pub(crate) fn new(basic: Basic, at: u16, bit: u8) -> BitOp {
        let bit = bit & 7;
        let mask = 1u8 << bit;
        let contact = |join: u8, not: u8| BitOp { at, bit, not, join, clear: 0, reset: 0, set: 0 };
        let coil = |not, clear, reset, set| BitOp { at, bit, not, join: KEEP, clear, reset, set };
        match basic {
            Basic::Rd => contact(JOIN, 0),
            Basic::RdNot => contact(JOIN, 1),
            Basic::And => contact(0, 0),
            Basic::AndNot => contact(0, 1),
            Basic::Or => contact(KEEP | JOIN, 0),
            Basic::OrNot => contact(KEEP | JOIN, 1),
            Basic::RdStk => contact(PUSH | JOIN, 0),
            Basic::RdNotStk => contact(PUSH | JOIN, 1),
            Basic::AndStk => contact(POP | FROM_STACK, 0),
            Basic::OrStk => contact(POP | FROM_STACK | KEEP | JOIN, 0),
            Basic::Wrt => coil(0, mask, 0, mask),
            Basic::WrtNot => coil(1, mask, 0, mask),
            Basic::Set => coil(0, 0, 0, mask),
            Basic::Rst => coil(0, 0, mask, 0),
        }
    }

    /// Carries it out; gives the stack behind it.
    #[inline(always)]
    pub(crate) fn run(self, memory: &mut Memory, stack: u32) -> u32 {
        let at = usize::from(self.at);
        let byte = memory.bytes[at];
        let join = u32::from(self.join);
        let read = ((u32::from(byte) >> (self.bit & 7)) ^ u32::from(self.not)) & 1;
        let from_stack = (join >> 4) & 1;
        let contact = read ^ ((read ^ stack) & from_stack);
        let moved = (stack << (join & 3)) >> ((join >> 2) & 3);
        let kept = !1 | contact | (join >> 5);
        let stack = (moved & kept) | (contact & (join >> 6));
        let line = ((stack as u8) ^ self.not) & 1;
        let on = 0u8.wrapping_sub(line);
        let written = (byte & !(self.clear | (self.reset & on))) | (self.set & on);
        memory.bytes[at] = byte ^ ((byte ^ written) & memory.free[at]);
        stack
    }

    /// Whether the contact conducts, or the coil is on.
    pub(crate) fn is_on(self, memory: &Memory) -> bool {
        (memory.bytes[usize::from(self.at)] >> (self.bit & 7)) & 1 != self.not
    }
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
        let mut stack = 0xFFFF_FFFE;
        for (basic, address) in network {
            let address = Address::parse(address).unwrap();
            stack = BitOp::new(*basic, address.place(), address.bit.unwrap()).run(&mut memory, stack);
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
