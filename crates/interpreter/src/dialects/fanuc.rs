//! What the Fanuc-like languages have in common, as building blocks for the tables of their folders.
//!
//! A folder composes its table of codes of [`COMMON_G`] and rows of its own; the numbers that its manual
//! gives the modal groups are put in last. Where a language lacks a common code or means another thing
//! by it, the code does not belong here.

use crate::cycles::{CycleKind, HoleCycle, Peck, Retract};
use crate::dialect::{Address, GCode, MCode, MFunction, Meaning, g};
use crate::modal::Group;
use ferrocut_geometry::Plane;
use ferrocut_machine::Fault;
use ferrocut_program::lexer::MAX_LINE;
use ferrocut_program::{Binary, Function, Keyword, Syntax};

/// A row whose group gets its number in [`g_codes`].
pub const fn code(tenths: u16, meaning: Meaning, group: Group) -> GCode {
    g(tenths, meaning, group, 0)
}

/// A row of a canned cycle.
pub const fn cycle(tenths: u16, kind: CycleKind) -> GCode {
    code(tenths, Meaning::Cycle(kind), Group::Cycle)
}

const fn hole(tenths: u16, peck: Peck, dwell: bool, retract: Retract) -> GCode {
    cycle(tenths, CycleKind::Hole(HoleCycle { peck, dwell, retract }))
}

/// G80.
pub static CYCLE_OFF: GCode = g(800, Meaning::CycleOff, Group::Cycle, 9);

/// G49.
pub static LENGTH_OFF: GCode = g(490, Meaning::LengthOff, Group::Length, 8);

/// G60 where it is modal.
pub static ONE_WAY_MODAL: GCode = g(600, Meaning::OneWay, Group::Motion, 1);

/// The codes that all have, in rising order.
pub const COMMON_G: [GCode; 58] = [
    code(0, Meaning::Rapid, Group::Motion),
    code(10, Meaning::Linear, Group::Motion),
    code(20, Meaning::ArcClockwise, Group::Motion),
    code(30, Meaning::ArcCounterClockwise, Group::Motion),
    code(40, Meaning::Dwell, Group::NonModal),
    code(100, Meaning::DataSetting, Group::NonModal),
    code(110, Meaning::DataSettingOff, Group::NonModal),
    code(150, Meaning::PolarOff, Group::Polar),
    code(160, Meaning::PolarOn, Group::Polar),
    code(170, Meaning::Plane(Plane::Xy), Group::Plane),
    code(180, Meaning::Plane(Plane::Zx), Group::Plane),
    code(190, Meaning::Plane(Plane::Yz), Group::Plane),
    code(200, Meaning::Inch, Group::Units),
    code(210, Meaning::Metric, Group::Units),
    code(270, Meaning::ReferenceCheck, Group::NonModal),
    code(280, Meaning::ReferenceReturn, Group::NonModal),
    code(290, Meaning::ReturnFromReference, Group::NonModal),
    code(300, Meaning::FurtherReferenceReturn, Group::NonModal),
    code(310, Meaning::Skip, Group::NonModal),
    code(400, Meaning::CutterOff, Group::Cutter),
    code(410, Meaning::CutterLeft, Group::Cutter),
    code(420, Meaning::CutterRight, Group::Cutter),
    code(430, Meaning::LengthPlus, Group::Length),
    code(440, Meaning::LengthMinus, Group::Length),
    code(490, Meaning::LengthOff, Group::Length),
    code(530, Meaning::MachinePosition, Group::NonModal),
    code(540, Meaning::WorkOffset(1), Group::WorkOffset),
    code(550, Meaning::WorkOffset(2), Group::WorkOffset),
    code(560, Meaning::WorkOffset(3), Group::WorkOffset),
    code(570, Meaning::WorkOffset(4), Group::WorkOffset),
    code(580, Meaning::WorkOffset(5), Group::WorkOffset),
    code(590, Meaning::WorkOffset(6), Group::WorkOffset),
    code(610, Meaning::ExactStop, Group::PathControl),
    code(620, Meaning::CornerOverride, Group::PathControl),
    code(630, Meaning::TappingMode, Group::PathControl),
    code(640, Meaning::CuttingMode, Group::PathControl),
    code(680, Meaning::RotationOn, Group::Rotation),
    code(690, Meaning::RotationOff, Group::Rotation),
    hole(730, Peck::ChipBreak, false, Retract::Rapid),
    cycle(740, CycleKind::Tap { left: true }),
    cycle(760, CycleKind::FineBore),
    code(800, Meaning::CycleOff, Group::Cycle),
    hole(810, Peck::None, false, Retract::Rapid),
    hole(820, Peck::None, true, Retract::Rapid),
    hole(830, Peck::Clear, false, Retract::Rapid),
    cycle(840, CycleKind::Tap { left: false }),
    hole(850, Peck::None, false, Retract::Feed),
    hole(860, Peck::None, false, Retract::SpindleStopped),
    cycle(870, CycleKind::BackBore),
    hole(880, Peck::None, true, Retract::ByHand),
    hole(890, Peck::None, true, Retract::Feed),
    code(900, Meaning::Absolute, Group::Distance),
    code(910, Meaning::Incremental, Group::Distance),
    code(920, Meaning::SetPosition, Group::NonModal),
    code(940, Meaning::FeedPerMinute, Group::FeedMode),
    code(950, Meaning::FeedPerRevolution, Group::FeedMode),
    code(980, Meaning::ReturnInitial, Group::Return),
    code(990, Meaning::ReturnR, Group::Return),
];

/// Starts with the block's motion.
pub const fn with(code: u16, function: MFunction) -> MCode {
    MCode { code, function, after_motion: false, controls_program: false }
}

/// Runs after the block's motion, alone among such M codes.
pub const fn after(code: u16, function: MFunction) -> MCode {
    MCode { code, function, after_motion: true, controls_program: true }
}

/// The M codes that all have, in rising order.
pub const COMMON_M: [MCode; 13] = [
    after(0, MFunction::Stop),
    after(1, MFunction::OptionalStop),
    after(2, MFunction::End),
    with(3, MFunction::SpindleClockwise),
    with(4, MFunction::SpindleCounterClockwise),
    with(5, MFunction::SpindleOff),
    after(6, MFunction::ToolChange),
    with(8, MFunction::CoolantOn),
    with(9, MFunction::CoolantOff),
    with(19, MFunction::Orient),
    after(30, MFunction::End),
    after(98, MFunction::Call),
    after(99, MFunction::Return),
];

/// The common G codes and those of a language, in rising order, their groups numbered. `N` is the number of
/// both; a code of both would break the order, which a test of every language holds.
pub const fn g_codes<const OWN: usize, const N: usize>(
    own: [GCode; OWN],
    groups: &[(Group, u8)],
) -> [GCode; N] {
    assert!(COMMON_G.len() + OWN == N);
    let mut table = [COMMON_G[0]; N];
    let (mut common, mut at) = (0, 0);
    while at < N {
        let mut row = if common < COMMON_G.len()
            && (at == common + OWN || COMMON_G[common].tenths < own[at - common].tenths)
        {
            common += 1;
            COMMON_G[common - 1]
        } else {
            own[at - common]
        };
        let mut group = 0;
        while group < groups.len() {
            if groups[group].0 as u8 == row.group as u8 {
                row.group_number = groups[group].1;
            }
            group += 1;
        }
        table[at] = row;
        at += 1;
    }
    table
}

/// The same of the M codes.
pub const fn m_codes<const OWN: usize, const N: usize>(own: [MCode; OWN]) -> [MCode; N] {
    assert!(COMMON_M.len() + OWN == N);
    let mut table = [COMMON_M[0]; N];
    let (mut common, mut at) = (0, 0);
    while at < N {
        table[at] = if common < COMMON_M.len()
            && (at == common + OWN || COMMON_M[common].code < own[at - common].code)
        {
            common += 1;
            COMMON_M[common - 1]
        } else {
            own[at - common]
        };
        at += 1;
    }
    table
}

/// A number within ± `limit`.
pub const fn signed(letter: u8, limit: f64) -> Address {
    Address { letter, min: -limit, max: limit, whole: false, beyond: Fault::WordOutOfRange }
}

/// A whole number from 0 to `max`, beyond which there is an alarm of its own.
pub const fn count(letter: u8, max: f64, beyond: Fault) -> Address {
    Address { letter, min: 0.0, max, whole: true, beyond }
}

/// A number from 0 to `max`, beyond which there is an alarm of its own.
pub const fn positive(letter: u8, max: f64, beyond: Fault) -> Address {
    Address { letter, min: 0.0, max, whole: false, beyond }
}

/// The row of a code in a table in rising order; that of [`CYCLE_OFF`] where there is none.
pub fn row(table: &'static [GCode], tenths: u16) -> &'static GCode {
    let found = table.binary_search_by_key(&tenths, |g| g.tenths).ok().and_then(|at| table.get(at));
    found.unwrap_or(&CYCLE_OFF)
}

/// The local variable that an address of G65 sets (Fanuc's first way of arguments). Where H makes G65 an operation
/// (GSK990MC 4.9.4), it comes here as no argument.
pub fn argument(letter: u8) -> Option<u32> {
    Some(match letter {
        b'A' => 1,
        b'B' => 2,
        b'C' => 3,
        b'I' => 4,
        b'J' => 5,
        b'K' => 6,
        b'D' => 7,
        b'E' => 8,
        b'F' => 9,
        b'H' => 11,
        b'M' => 13,
        b'Q'..=b'Z' => u32::from(letter - b'Q') + 17,
        _ => return None,
    })
}

/// How programs are written: Fanuc's custom macro B. A function may be called by its first two letters.
/// `AND` binds like `*`, `OR` and `XOR` like `+`; comparisons bind least.
pub const SYNTAX: Syntax = Syntax {
    paren_comments: true,
    paren_groups: false,
    keywords: &[
        ("IF", Keyword::If),
        ("THEN", Keyword::Then),
        ("GOTO", Keyword::Goto),
        ("WHILE", Keyword::While),
        ("DO", Keyword::Do),
        ("END", Keyword::End),
    ],
    functions: &[
        ("SIN", Function::Sin),
        ("SI", Function::Sin),
        ("COS", Function::Cos),
        ("CO", Function::Cos),
        ("TAN", Function::Tan),
        ("TA", Function::Tan),
        ("ASIN", Function::Asin),
        ("AS", Function::Asin),
        ("ACOS", Function::Acos),
        ("AC", Function::Acos),
        ("ATAN", Function::Atan),
        ("AT", Function::Atan),
        ("SQRT", Function::Sqrt),
        ("SQ", Function::Sqrt),
        ("ABS", Function::Abs),
        ("AB", Function::Abs),
        ("ROUND", Function::Round),
        ("RO", Function::Round),
        ("FIX", Function::Fix),
        ("FI", Function::Fix),
        ("FUP", Function::Fup),
        ("FU", Function::Fup),
        ("LN", Function::Ln),
        ("EXP", Function::Exp),
        ("EX", Function::Exp),
        ("BIN", Function::Bin),
        ("BI", Function::Bin),
        ("BCD", Function::Bcd),
        ("BC", Function::Bcd),
    ],
    operators: &[
        ("EQ", Binary::Equal, 1),
        ("NE", Binary::NotEqual, 1),
        ("GT", Binary::Greater, 1),
        ("GE", Binary::GreaterEqual, 1),
        ("LT", Binary::Less, 1),
        ("LE", Binary::LessEqual, 1),
        ("+", Binary::Add, 2),
        ("-", Binary::Subtract, 2),
        ("XOR", Binary::Xor, 2),
        ("OR", Binary::Or, 2),
        ("*", Binary::Multiply, 3),
        ("/", Binary::Divide, 3),
        ("AND", Binary::And, 3),
    ],
    max_line: MAX_LINE,
    // Fanuc's and GSK's (alarm 0118).
    max_brackets: 5,
    ..Syntax::WORDS
};

/// M codes that the control hands to the machine as they are (Fanuc), by their number.
pub static MACHINE_M: [MCode; 1000] = {
    let mut rows =
        [MCode { code: 0, function: MFunction::Machine, after_motion: false, controls_program: false }; 1000];
    let mut number = 0;
    while number < rows.len() {
        rows[number].code = number as u16;
        number += 1;
    }
    rows
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn common_rows_are_in_rising_order() {
        assert!(COMMON_G.windows(2).all(|w| w[0].tenths < w[1].tenths));
        assert!(COMMON_M.windows(2).all(|w| w[0].code < w[1].code));
    }

    #[test]
    fn own_rows_are_put_between_the_common_ones_and_groups_numbered() {
        const OWN: [GCode; 2] =
            [code(5, Meaning::ScalingOff, Group::Scaling), code(2000, Meaning::Dwell, Group::NonModal)];
        const TABLE: [GCode; COMMON_G.len() + 2] = g_codes(OWN, &[(Group::Motion, 1), (Group::Scaling, 7)]);
        let head: Vec<_> = TABLE.iter().take(3).map(|row| (row.tenths, row.group_number)).collect();
        assert_eq!(head, [(0, 1), (5, 7), (10, 1)]);
        assert_eq!(TABLE.last(), Some(&OWN[1]));
        assert!(TABLE.windows(2).all(|w| w[0].tenths < w[1].tenths));
        const CODES: [MCode; COMMON_M.len() + 1] = m_codes([with(7, MFunction::Machine)]);
        assert_eq!(CODES.iter().map(|m| m.code).take(9).collect::<Vec<_>>(), [0, 1, 2, 3, 4, 5, 6, 7, 8]);
        assert_eq!(CODES.len(), COMMON_M.len() + 1);
    }

    #[test]
    fn arguments_are_those_of_fanuc() {
        let numbers = [b'A', b'D', b'Q', b'Z', b'G', b'P', b'H'].map(argument);
        assert_eq!(numbers, [Some(1), Some(7), Some(17), Some(26), None, None, Some(11)]);
    }
}
