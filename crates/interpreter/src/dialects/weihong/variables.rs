//! Variables of Weihong: numbers, `#FC` and the named parameters (5).
//!
//! What has a name is kept by a number far above those that programs write.

use crate::dialect::Variable;

/// Number of the first variable of the control's present.
const FIRST_PRESENT: u32 = 1_000_000;

/// Number of the first named parameter, in the order of the control's list.
const FIRST_PARAMETER: u32 = 1_001_000;

/// Number of `#FC0`.
const FIRST_FC: u32 = 1_002_000;

/// Highest number that a program writes itself; the manual gives none.
const LAST_NUMBER: u32 = 99_999;

/// How many `#FC` there are.
const FC: u32 = 1000;

/// The number that `#FC` `n` is kept by.
pub const fn fc(n: u32) -> u32 {
    FIRST_FC + n
}

const fn parameter(place: u32) -> u32 {
    FIRST_PARAMETER + place
}

/// Variables of a name and a number.
pub const FAMILIES: &[(&str, u32, u32)] = &[("FC", FIRST_FC, FC)];

/// Variables with names. Those of parameters stand in the order of the list in
/// `machine/data/weihong/named-parameters.csv`; a test holds the two together.
pub const NAMES: &[(&str, u32)] = &[
    ("CURMACHPOS.X", FIRST_PRESENT),
    ("CURMACHPOS.Y", FIRST_PRESENT + 1),
    ("CURMACHPOS.Z", FIRST_PRESENT + 2),
    ("CURWORKPOS.X", FIRST_PRESENT + 3),
    ("CURWORKPOS.Y", FIRST_PRESENT + 4),
    ("CURWORKPOS.Z", FIRST_PRESENT + 5),
    ("INPORTMAP", FIRST_PRESENT + 6),
    ("OUTPORTMAP", FIRST_PRESENT + 7),
    ("SAFEHEIGHT", parameter(0)),
    ("ISYREVAXIS", parameter(1)),
    ("WPREVDIAM", parameter(2)),
    ("UNIT.YR", parameter(3)),
    ("AUTOSTOPSPINDLE", parameter(4)),
    ("SPINDLE_DELAY", parameter(5)),
    ("MOBICALI_THICKNESS", parameter(6)),
    ("FIXEDCALI_POS.X", parameter(7)),
    ("FIXEDCALI_POS.Y", parameter(8)),
    ("FIXEDCALI_POS.Z", parameter(9)),
    ("ENABLE_CTP", parameter(10)),
    ("CTP_POS.X", parameter(11)),
    ("CTP_POS.Y", parameter(12)),
    ("CTP_POS.Z", parameter(13)),
    ("BKREF_SW1.X", parameter(14)),
    ("BKREF_SW1.Y", parameter(15)),
    ("BKREF_SW1.Z", parameter(16)),
    ("BKREF_SW2.X", parameter(17)),
    ("BKREF_SW2.Y", parameter(18)),
    ("BKREF_SW2.Z", parameter(19)),
    ("BKREF_F1.X", parameter(20)),
    ("BKREF_F1.Y", parameter(21)),
    ("BKREF_F1.Z", parameter(22)),
    ("BKREF_F1_DIR.X", parameter(23)),
    ("BKREF_F1_DIR.Y", parameter(24)),
    ("BKREF_F1_DIR.Z", parameter(25)),
    ("BKREF_F2.X", parameter(26)),
    ("BKREF_F2.Y", parameter(27)),
    ("BKREF_F2.Z", parameter(28)),
    ("BKREF_F2_DIR.X", parameter(29)),
    ("BKREF_F2_DIR.Y", parameter(30)),
    ("BKREF_F2_DIR.Z", parameter(31)),
    ("BKREF_BACK.X", parameter(32)),
    ("BKREF_BACK.Y", parameter(33)),
    ("BKREF_BACK.Z", parameter(34)),
    ("CALIBRATION_SW", parameter(35)),
    ("SPINDLE_START_PORT", parameter(36)),
    ("COOLANT_START_PORT", parameter(37)),
    ("DD_BKREF_DELTA", parameter(38)),
    ("FIXEDCYCLE_BACK", parameter(39)),
    ("FIXEDCYCLE_OSS", parameter(40)),
    ("FIXEDCALI_REC", parameter(41)),
    ("IJK_INCREMENTAL", parameter(42)),
    ("DEFAULT_FEED", parameter(43)),
];

/// What a variable stands for.
pub fn variable(number: u32) -> Option<Variable> {
    Some(match number {
        0..=LAST_NUMBER => Variable::Plain,
        FIRST_PRESENT..FIRST_PARAMETER => match number - FIRST_PRESENT {
            axis @ 0..3 => Variable::MachinePosition(axis as u8),
            // Tool length included as in the words: 0 behind G92 Z0 (4.3).
            axis @ 3..6 => Variable::TipPosition(axis as u8 - 3),
            6 => Variable::Inputs,
            7 => Variable::Outputs,
            _ => return None,
        },
        FIRST_PARAMETER..FIRST_FC => Variable::Parameter((number - FIRST_PARAMETER) as u16),
        FIRST_FC.. if number < FIRST_FC + FC => Variable::Plain,
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use ferrocut_machine::{ParameterKey, ParameterTable};

    #[test]
    fn names_are_those_of_the_list_of_parameters() {
        let table = ParameterTable::of("weihong").unwrap();
        let mut places = 0;
        for (name, number) in NAMES {
            if let Some(Variable::Parameter(place)) = variable(*number) {
                assert_eq!(table.named_key(place), Some(&ParameterKey::Named((*name).into())));
                places += 1;
            }
        }
        assert_eq!(places, table.len());
    }

    #[test]
    fn the_present_is_read_by_name() {
        assert_eq!(variable(FIRST_PRESENT + 4), Some(Variable::TipPosition(1)));
        assert_eq!(variable(fc(999)), Some(Variable::Plain));
        assert_eq!([variable(fc(1000)), variable(100_000)], [None, None]);
    }
}
