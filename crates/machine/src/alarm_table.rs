//! Which alarms the manual of a control lists, and what kind each one is.

use crate::alarm::AlarmId;
use std::sync::OnceLock;

/// Where an alarm comes from, as far as the manual's list tells.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum AlarmClass {
    /// The part program.
    Program,
    /// A macro statement of the part program.
    Macro,
    /// Something done at the panel.
    Operation,
    /// The reference points.
    Homing,
    /// The program memory and its files.
    Storage,
    /// A feed drive.
    Servo,
    /// The spindle or its drive.
    Spindle,
    /// An axis beyond its limits.
    Overtravel,
    /// The ladder.
    Plc,
    /// The control itself.
    System,
}

impl AlarmClass {
    fn from_name(name: &str) -> Option<AlarmClass> {
        Some(match name {
            "program" => AlarmClass::Program,
            "macro" => AlarmClass::Macro,
            "operation" => AlarmClass::Operation,
            "homing" => AlarmClass::Homing,
            "storage" => AlarmClass::Storage,
            "servo" => AlarmClass::Servo,
            "spindle" => AlarmClass::Spindle,
            "overtravel" => AlarmClass::Overtravel,
            "plc" => AlarmClass::Plc,
            "system" => AlarmClass::System,
            _ => return None,
        })
    }
}

/// One alarm of a control's list.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct AlarmRow {
    /// The alarm; its text is in the catalogues.
    pub id: AlarmId,
    /// Where it comes from.
    pub class: AlarmClass,
}

static GSK990MC: OnceLock<Vec<AlarmRow>> = OnceLock::new();

/// Every alarm that the manual of the control lists, by number; empty where no list is known.
pub fn alarm_table(dialect: &str) -> &'static [AlarmRow] {
    match dialect {
        // GSK990MC appendix 2.
        "gsk990mc" => GSK990MC.get_or_init(|| rows("gsk990mc", include_str!("../data/gsk990mc/alarms.csv"))),
        _ => &[],
    }
}

/// Reads `no,class`. A row that cannot be read is left out; a test holds that there is none.
fn rows(dialect: &'static str, text: &str) -> Vec<AlarmRow> {
    let row = |line: &str| {
        let (number, class) = line.split_once(',')?;
        let id = AlarmId::Dialect(dialect, number.parse().ok()?);
        Some(AlarmRow { id, class: AlarmClass::from_name(class)? })
    };
    text.lines().skip(1).filter_map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_list_is_complete_and_in_order() {
        let table = alarm_table("gsk990mc");
        assert_eq!(table.len(), 313);
        let numbers: Vec<_> = table.iter().filter_map(|row| row.id.number()).collect();
        assert!(numbers.is_sorted_by(|a, b| a < b));
        assert_eq!((numbers.first(), numbers.last()), (Some(&0), Some(&1042)));
        assert!(alarm_table("weihong").is_empty());
    }
}
