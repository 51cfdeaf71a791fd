//! Five levels, and what each may do (GSK990MC operation 3.4.5).
//!
//! | level | is | may change |
//! |---|---|---|
//! | 1 | maker of the control | everything |
//! | 2 | builder of the machine | everything, the ladder and what it keeps |
//! | 3 | commissioning | every parameter, pitch tables, what is locked by those below; deletes the histories |
//! | 4 | the shop | parameters that concern the work and not the machine |
//! | 5 | the operator, without a password | offsets, zeros, variables, programs, counters |
//!
//! Where the manual says no more than "part of the parameters" for level 4, it is those of the rooms in
//! [`SHOP_ROOMS`]. What a level may, all levels above may too.

use crate::items::{Change, Counter, Item, PlcArea};
use ferrocut_machine::{ParameterKey, ParameterTable};

/// A level of rights.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Hash)]
pub enum Level {
    /// 1: the maker of the control.
    Maker,
    /// 2: the builder of the machine.
    Builder,
    /// 3: commissioning.
    Commissioning,
    /// 4: the shop that uses it.
    Shop,
    /// 5: the operator; needs no password.
    Operator,
}

impl Level {
    /// Every level, the highest first.
    pub const ALL: [Level; 5] =
        [Level::Maker, Level::Builder, Level::Commissioning, Level::Shop, Level::Operator];

    /// Its number, 1 to 5.
    pub fn number(self) -> u8 {
        match self {
            Level::Maker => 1,
            Level::Builder => 2,
            Level::Commissioning => 3,
            Level::Shop => 4,
            Level::Operator => 5,
        }
    }

    /// The level of a number.
    pub fn of(number: i64) -> Option<Level> {
        Level::ALL.into_iter().find(|level| i64::from(level.number()) == number)
    }

    /// Whether it may what `other` may.
    pub fn covers(self, other: Level) -> bool {
        self <= other
    }
}

/// Parts of the control whose parameters concern the work: levels from 4 on may change them.
pub const SHOP_ROOMS: [&str; 4] = ["canned-cycles", "display", "macro", "program-edit"];

/// Parameters of these rooms that protect what a higher level has made: programs 80000 to 89999 and 90000 to
/// 99999 (27#0 NE8, 27#4 NE9).
const PROTECTING: [ParameterKey; 2] =
    [ParameterKey::Bit { number: 27, bit: 0 }, ParameterKey::Bit { number: 27, bit: 4 }];

/// The program switch, which guards what the shop has made (54#6 PRGS; operation 3.4.1, 10.2.5): its level is that of
/// locking a program.
pub const PROGRAM_SWITCH: ParameterKey = ParameterKey::Bit { number: 54, bit: 6 };

/// The lowest level that may change a parameter.
pub fn needed_for_parameter(table: &ParameterTable, key: &ParameterKey) -> Level {
    let is_of_the_work = |room: &str| SHOP_ROOMS.contains(&room) && !PROTECTING.contains(key);
    match table.get(key) {
        Some(row) if is_of_the_work(&row.applies_to) || *key == PROGRAM_SWITCH => Level::Shop,
        _ => Level::Commissioning,
    }
}

/// The lowest level that may make a change, as far as the change alone says.
pub fn needed(table: &ParameterTable, change: &Change) -> Level {
    match change {
        Change::Program { .. }
        | Change::DeleteProgram { .. }
        | Change::RenameProgram { .. }
        | Change::Offset { .. }
        | Change::WorkZero { .. }
        | Change::Variable { .. } => Level::Operator,
        Change::LockProgram { .. } => Level::Shop,
        Change::Counter {
            counter: Counter::PowerOnTime | Counter::AllParts | Counter::AllCuttingTime | Counter::Starts,
            ..
        } => Level::Builder,
        Change::Counter { .. } => Level::Operator,
        Change::Parameter { key, .. } => needed_for_parameter(table, key),
        Change::Pitch { .. } | Change::ReferencePoint { .. } | Change::MachineZero { .. } => {
            Level::Commissioning
        }
        // 3.7: histories are deleted from commissioning on.
        Change::ClearAlarms | Change::ClearLog => Level::Commissioning,
        // 3.4.5: ladders are transferred from level 2 on.
        Change::Plc { area: PlcArea::K | PlcArea::T | PlcArea::C | PlcArea::D, .. }
        | Change::Signal { .. }
        | Change::Ladder { .. }
        | Change::Force { .. } => Level::Builder,
        Change::Session(_) => Level::Operator,
        Change::Alarm(_) | Change::LastPosition(_) | Change::Interrupted(_) => Level::Maker,
    }
}

/// The lowest level that may restore an item from a backup: the level that may change all of it
/// (3.4.4, note 3). Programs need level 3, since many are overwritten at once.
pub fn needed_to_restore(item: Item) -> Level {
    match item {
        Item::Offsets | Item::WorkZeros | Item::Variables => Level::Operator,
        Item::Programs
        | Item::Parameters
        | Item::Pitch
        | Item::ReferencePoints
        | Item::Alarms
        | Item::Log => Level::Commissioning,
        Item::Plc | Item::Ladder | Item::Counters | Item::LastPosition | Item::Interrupted => Level::Builder,
    }
}

/// The lowest level that takes a backup away or brings one: the level that may restore all that shops restore. It
/// holds the work of the shop.
pub const CARRIES_BACKUPS: Level = Level::Commissioning;

/// The parameter bit, number and bit, that closes a program to persons of every level by the number that it is named by,
/// such as `O80001` (GSK990MC 27#0, 27#4).
pub fn closing_bit(program: &str) -> Option<(u16, u8)> {
    let digits = program.strip_prefix(['O', 'o']).unwrap_or(program);
    match digits.parse::<u32>().ok().filter(|_| digits.bytes().all(|b| b.is_ascii_digit()))? {
        80_000..=89_999 => Some((27, 0)),
        90_000..=99_999 => Some((27, 4)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table() -> &'static ParameterTable {
        ParameterTable::of("gsk990mc").unwrap()
    }

    #[test]
    fn levels_are_those_of_the_manual() {
        for level in Level::ALL {
            assert_eq!(Level::of(i64::from(level.number())), Some(level));
            assert!(Level::Maker.covers(level) && level.covers(Level::Operator));
        }
        assert!(!Level::Shop.covers(Level::Commissioning));
        assert_eq!((Level::of(0), Level::of(6)), (None, None));
    }

    #[test]
    fn every_part_of_the_work_has_parameters() {
        for room in SHOP_ROOMS {
            assert!(table().iter().any(|row| &*row.applies_to == room), "{room}");
        }
    }

    #[test]
    fn parameters_of_the_machine_need_commissioning() {
        for (name, level) in [
            // Where the tool goes between pecks, against the software limits and the rapid of an axis.
            ("P270", Level::Shop),
            ("NO54.6", Level::Shop),
            ("P66", Level::Commissioning),
            ("P88", Level::Commissioning),
            ("NO27.0", Level::Commissioning),
            ("NO27.4", Level::Commissioning),
            ("NO29.0", Level::Commissioning),
            ("NOBODY", Level::Commissioning),
        ] {
            assert_eq!(needed_for_parameter(table(), &name.parse().unwrap()), level, "{name}");
        }
    }
}
