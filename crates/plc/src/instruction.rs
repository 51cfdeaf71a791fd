//! The instructions as data: what each is called, how many conditions it takes, what its parameters are.
//!
//! Numbers, conditions and parameters are those of the Fanuc 0i PMC-SB7; the GSK990MC counts 10 basic
//! instructions and 35 functions and leaves their forms to its manual of the PLC.

use crate::address::Address;
use crate::fault::Span;

/// What a parameter may be.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    /// A constant within bounds, both included.
    Number(i64, i64),
    /// As `Number`, and what stands for it where it is left out.
    OptionalNumber(i64, i64, i64),
    /// The number of a label or subprogram, with or without its letter.
    Target(char, i64),
    /// Four digits of 0 and 1.
    Mask,
    /// 1, 2 or 4 bytes.
    Width,
    /// A width, behind the number of bytes of the result in hundreds (`0021`).
    DecodeWidth,
    /// A width, behind 1000 where the operand that follows is an address.
    OperandWidth,
    /// 0 where the operand that follows is a constant, 1 where it is an address.
    OperandFormat,
    /// A byte or the first of several that the function reads.
    Read(Bytes),
    /// The same, written.
    Write(Bytes),
    /// A constant or an address, as the format before says.
    Operand(Bytes),
    /// A constant of the width given before.
    Constant,
    /// A BCD constant.
    Bcd,
}

/// How many bytes a parameter is the first of.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Bytes {
    /// So many.
    Fixed(u16),
    /// As many as the width given before.
    Width,
    /// As many as the decoding width says.
    Decoded,
    /// As many as the first number says.
    First,
    /// The table whose number of values of two bytes at most is the first number.
    FirstWords,
}

/// Whether a coil follows.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Output {
    /// None may: the function has no W1.
    Never,
    /// One may.
    May,
    /// One must: the function does nothing else.
    Must,
}

/// Which function.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[allow(missing_docs)]
pub enum Name {
    End1,
    End2,
    End,
    Tmr,
    Tmrb,
    Tmrc,
    Dec,
    Decb,
    Ctr,
    Ctrc,
    Rot,
    Rotb,
    Cod,
    Codb,
    Move,
    Movb,
    Movw,
    Movd,
    Movn,
    Com,
    Come,
    Jmp,
    Jmpe,
    Pari,
    Dcnv,
    Dcnvb,
    Comp,
    Compb,
    Coin,
    Sft,
    Dsch,
    Dschb,
    Xmov,
    Xmovb,
    Add,
    Addb,
    Sub,
    Subb,
    Mul,
    Mulb,
    Div,
    Divb,
    Nume,
    Numeb,
    Difu,
    Difd,
    Eor,
    And,
    Or,
    Not,
    Call,
    Callu,
    Jmpb,
    Lbl,
    Jmpc,
    Sp,
    Spe,
    Nop,
}

/// A function.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// Which.
    pub name: Name,
    /// Its number behind SUB.
    pub number: u16,
    /// What it is called.
    pub text: &'static str,
    /// What its conditions are called, in the order in which they are stacked; the last is ST0.
    pub conditions: &'static [&'static str],
    /// Its parameters.
    pub parameters: &'static [Kind],
    /// Whether a coil follows.
    pub output: Output,
}

macro_rules! rows {
    ($($name:ident $number:literal $text:literal [$($condition:literal)*] [$($parameter:expr),*] $output:ident;)+) => {
        /// Every function, by its number.
        pub const FUNCTIONS: &[Row] = &[$(Row {
            name: Name::$name,
            number: $number,
            text: $text,
            conditions: &[$($condition),*],
            parameters: &[$($parameter),*],
            output: Output::$output,
        },)+];
    };
}

use Bytes::{Decoded, First, FirstWords, Fixed};
use Kind::{
    Bcd, Constant, DecodeWidth, Mask, Number, Operand, OperandFormat, OperandWidth, OptionalNumber, Read,
    Target, Width, Write,
};

const WIDE: Bytes = Bytes::Width;
/// Two digits take a byte and four take two, which BYT chooses while the ladder runs.
const DIGITS: Bytes = Fixed(2);

/// Highest number of a label and of a subprogram.
pub const LABELS: i64 = 9999;
/// Highest number of a variable timer; each has a word of T.
pub const TIMERS: i64 = 250;
/// Highest number of a timer whose time stands in the ladder.
pub const FIXED_TIMERS: i64 = 500;
/// Highest number of a counter; each has two words of C.
pub const COUNTERS: i64 = 100;
/// Highest number of a DIFU or DIFD.
pub const EDGES: i64 = 1000;

rows! {
    End1 1 "END1" [] [] Never;
    End2 2 "END2" [] [] Never;
    Tmr 3 "TMR" ["ACT"] [Number(1, TIMERS)] Must;
    Dec 4 "DEC" ["ACT"] [Read(Fixed(1)), Number(0, 9911)] Must;
    Ctr 5 "CTR" ["CN0" "UPDOWN" "RST" "ACT"] [Number(1, COUNTERS)] May;
    Rot 6 "ROT" ["RN0" "BYT" "DIR" "POS" "INC" "ACT"]
        [Number(1, 9999), Read(DIGITS), Read(DIGITS), Write(DIGITS)] May;
    Cod 7 "COD" ["BYT" "RST" "ACT"] [Number(1, 100), Read(Fixed(1)), Write(DIGITS)] May;
    Move 8 "MOVE" ["ACT"] [Mask, Mask, Read(Fixed(1)), Write(Fixed(1))] Never;
    Com 9 "COM" ["ACT"] [OptionalNumber(0, 9999, 0)] Never;
    Jmp 10 "JMP" ["ACT"] [OptionalNumber(0, 9999, 0)] Never;
    Pari 11 "PARI" ["O.E" "RST" "ACT"] [Read(Fixed(1))] Must;
    Dcnv 14 "DCNV" ["BYT" "CNV" "RST" "ACT"] [Read(DIGITS), Write(DIGITS)] May;
    Comp 15 "COMP" ["BYT" "ACT"] [OperandFormat, Operand(DIGITS), Read(DIGITS)] Must;
    Coin 16 "COIN" ["BYT" "ACT"] [OperandFormat, Operand(DIGITS), Read(DIGITS)] Must;
    Dsch 17 "DSCH" ["BYT" "RST" "ACT"] [Number(1, 9999), Read(FirstWords), Read(DIGITS), Write(DIGITS)] May;
    Xmov 18 "XMOV" ["BYT" "RW" "RST" "ACT"] [Number(1, 9999), Write(FirstWords), Write(DIGITS), Read(DIGITS)] May;
    Add 19 "ADD" ["BYT" "RST" "ACT"] [OperandFormat, Read(DIGITS), Operand(DIGITS), Write(DIGITS)] May;
    Sub 20 "SUB 20" ["BYT" "RST" "ACT"] [OperandFormat, Read(DIGITS), Operand(DIGITS), Write(DIGITS)] May;
    Mul 21 "MUL" ["BYT" "RST" "ACT"] [OperandFormat, Read(DIGITS), Operand(DIGITS), Write(DIGITS)] May;
    Div 22 "DIV" ["BYT" "RST" "ACT"] [OperandFormat, Read(DIGITS), Operand(DIGITS), Write(DIGITS)] May;
    Nume 23 "NUME" ["BYT" "ACT"] [Bcd, Write(DIGITS)] Never;
    Tmrb 24 "TMRB" ["ACT"] [Number(1, FIXED_TIMERS), Number(0, 262_136)] Must;
    Decb 25 "DECB" ["ACT"] [DecodeWidth, Read(WIDE), Constant, Write(Decoded)] Never;
    Rotb 26 "ROTB" ["RN0" "DIR" "POS" "INC" "ACT"] [Width, Read(WIDE), Read(WIDE), Read(WIDE), Write(WIDE)] May;
    Codb 27 "CODB" ["RST" "ACT"] [Width, Number(1, 256), Read(Fixed(1)), Write(WIDE)] May;
    Come 29 "COME" [] [] Never;
    Jmpe 30 "JMPE" [] [] Never;
    Dcnvb 31 "DCNVB" ["SIN" "CNV" "RST" "ACT"] [Width, Read(WIDE), Write(WIDE)] May;
    Compb 32 "COMPB" ["ACT"] [OperandWidth, Operand(WIDE), Read(WIDE)] Never;
    Sft 33 "SFT" ["DIR" "CONT" "RST" "ACT"] [Write(Fixed(2))] May;
    Dschb 34 "DSCHB" ["RST" "ACT"] [Width, Read(WIDE), Read(WIDE), Read(WIDE), Write(WIDE)] May;
    Xmovb 35 "XMOVB" ["RW" "RST" "ACT"] [Width, Read(WIDE), Write(WIDE), Write(WIDE), Read(WIDE)] May;
    Addb 36 "ADDB" ["RST" "ACT"] [OperandWidth, Read(WIDE), Operand(WIDE), Write(WIDE)] May;
    Subb 37 "SUBB" ["RST" "ACT"] [OperandWidth, Read(WIDE), Operand(WIDE), Write(WIDE)] May;
    Mulb 38 "MULB" ["RST" "ACT"] [OperandWidth, Read(WIDE), Operand(WIDE), Write(WIDE)] May;
    Divb 39 "DIVB" ["RST" "ACT"] [OperandWidth, Read(WIDE), Operand(WIDE), Write(WIDE)] May;
    Numeb 40 "NUMEB" ["ACT"] [Width, Constant, Write(WIDE)] Never;
    Movb 43 "MOVB" ["ACT"] [Read(Fixed(1)), Write(Fixed(1))] Never;
    Movw 44 "MOVW" ["ACT"] [Read(Fixed(2)), Write(Fixed(2))] Never;
    Movn 45 "MOVN" ["ACT"] [Number(1, 9999), Read(First), Write(First)] Never;
    Movd 47 "MOVD" ["ACT"] [Read(Fixed(4)), Write(Fixed(4))] Never;
    Tmrc 54 "TMRC" ["ACT"] [Number(0, 4), Read(Fixed(2)), Write(Fixed(4))] Must;
    Ctrc 55 "CTRC" ["CN0" "UPDOWN" "RST" "ACT"] [Read(Fixed(2)), Write(Fixed(4))] May;
    Difu 57 "DIFU" ["ACT"] [Number(1, EDGES)] Must;
    Difd 58 "DIFD" ["ACT"] [Number(1, EDGES)] Must;
    Eor 59 "EOR" ["ACT"] [OperandWidth, Read(WIDE), Operand(WIDE), Write(WIDE)] Never;
    And 60 "AND" ["ACT"] [OperandWidth, Read(WIDE), Operand(WIDE), Write(WIDE)] Never;
    Or 61 "OR" ["ACT"] [OperandWidth, Read(WIDE), Operand(WIDE), Write(WIDE)] Never;
    Not 62 "NOT" ["ACT"] [Width, Read(WIDE), Write(WIDE)] Never;
    End 64 "END" [] [] Never;
    Call 65 "CALL" ["ACT"] [Target('P', LABELS)] Never;
    Callu 66 "CALLU" [] [Target('P', LABELS)] Never;
    Jmpb 68 "JMPB" ["ACT"] [Target('L', LABELS)] Never;
    Lbl 69 "LBL" [] [Target('L', LABELS)] Never;
    Nop 70 "NOP" [] [] Never;
    Sp 71 "SP" [] [Target('P', LABELS)] Never;
    Spe 72 "SPE" [] [] Never;
    Jmpc 73 "JMPC" ["ACT"] [Target('L', LABELS)] Never;
}

impl Row {
    /// The function of a number behind SUB.
    pub fn by_number(number: u16) -> Option<&'static Row> {
        FUNCTIONS.iter().find(|row| row.number == number)
    }

    /// The function of a name.
    pub fn by_text(text: &str) -> Option<&'static Row> {
        FUNCTIONS.iter().find(|row| row.text.eq_ignore_ascii_case(text))
    }

    /// Steps that it counts: itself and each parameter, as the list of a PMC has them.
    pub fn steps(&self) -> u32 {
        1 + u32::try_from(self.parameters.len()).unwrap_or(0)
    }
}

/// A basic instruction.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[allow(missing_docs)]
pub enum Basic {
    Rd,
    RdNot,
    And,
    AndNot,
    Or,
    OrNot,
    RdStk,
    RdNotStk,
    AndStk,
    OrStk,
    Wrt,
    WrtNot,
    Set,
    Rst,
}

/// Basic instructions by their names.
pub const BASICS: &[(&str, Basic)] = &[
    ("RD", Basic::Rd),
    ("RD.NOT", Basic::RdNot),
    ("AND", Basic::And),
    ("AND.NOT", Basic::AndNot),
    ("OR", Basic::Or),
    ("OR.NOT", Basic::OrNot),
    ("RD.STK", Basic::RdStk),
    ("RD.NOT.STK", Basic::RdNotStk),
    ("AND.STK", Basic::AndStk),
    ("OR.STK", Basic::OrStk),
    ("WRT", Basic::Wrt),
    ("WRT.NOT", Basic::WrtNot),
    ("SET", Basic::Set),
    ("RST", Basic::Rst),
];

impl Basic {
    /// The instruction of a name.
    pub fn by_text(text: &str) -> Option<Basic> {
        BASICS.iter().find(|(name, _)| name.eq_ignore_ascii_case(text)).map(|(_, basic)| *basic)
    }

    /// Its name.
    pub fn text(self) -> &'static str {
        BASICS.iter().find(|(_, basic)| *basic == self).map_or("", |(name, _)| name)
    }

    /// Whether it writes a signal.
    pub fn is_coil(self) -> bool {
        matches!(self, Basic::Wrt | Basic::WrtNot | Basic::Set | Basic::Rst)
    }
}

/// A parameter of a function.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Parameter {
    /// A constant, number or format.
    Number(i64),
    /// An address.
    At(Address),
}

/// What an instruction does.
#[derive(Clone, Debug)]
pub enum Code {
    /// A basic instruction, and its bit where it has one.
    Basic(Basic, Option<Address>),
    /// A function with its parameters, and the values of its table.
    Function(&'static Row, Vec<Parameter>, Vec<i64>),
}

/// An instruction and where it stands.
#[derive(Clone, Debug)]
pub struct Instruction {
    /// What it does.
    pub code: Code,
    /// Its name in the text.
    pub span: Span,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn functions_rise_and_have_names_of_their_own() {
        for pair in FUNCTIONS.windows(2) {
            assert!(pair[0].number < pair[1].number, "{} {}", pair[0].text, pair[1].text);
        }
        for row in FUNCTIONS {
            assert_eq!(Row::by_text(row.text).unwrap().number, row.number);
            assert!(row.conditions.len() <= 9);
        }
    }
}
