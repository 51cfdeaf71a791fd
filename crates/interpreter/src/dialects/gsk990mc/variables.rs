//! Variables of the macro language (4.9.2).

use crate::dialect::Variable;
use ferrocut_machine::WorkOffset;

/// What a variable stands for.
pub fn variable(number: u32) -> Option<Variable> {
    let within = |first: u32| (number - first) as u16;
    // Five numbers a system, the fifth not described; axes 1 to 4.
    let axis = |first: u32| u8::try_from((number - first) % 5).ok().filter(|axis| *axis < 4);
    let group = |first: u32| (number - first) / 5;
    Some(match number {
        0 => Variable::Empty,
        1..=50 | 100..=199 | 500..=999 => Variable::Plain,
        1000..=1015 => Variable::Input(within(1000)),
        1032 => Variable::InputWord,
        1100..=1115 | 1132 => Variable::Output(within(1100)),
        1500..=1755 => Variable::ToolLength(within(1500)),
        1800..=2055 => Variable::LengthWear(within(1800)),
        2100..=2355 => Variable::ToolRadius(within(2100)),
        2400..=2655 => Variable::RadiusWear(within(2400)),
        3000 => Variable::Alarm,
        3500..=3755 => Variable::UserTable,
        // Table 4-9-2-2.
        4000..=4021 => Variable::ModalGroup(within(4000) as u8),
        4022..=4030 => Variable::ModalWord(*b"DHFMSTNOP".get(usize::from(within(4022)))?),
        // Table 4-9-2-3.
        5001..=5029 => match group(5001) {
            0 => Variable::BlockEnd(axis(5001)?),
            1 => Variable::MachinePosition(axis(5001)?),
            2 => Variable::WorkPosition(axis(5001)?),
            3 => Variable::SkipPosition(axis(5001)?),
            4 => Variable::LengthOffset(axis(5001)?),
            _ => Variable::ServoOffset(axis(5001)?),
        },
        // Table 4-9-2-4.
        5201..=5234 => match group(5201) {
            0 => Variable::WorkZero(WorkOffset::External, axis(5201)?),
            system => Variable::WorkZero(WorkOffset::Standard(system as u8), axis(5201)?),
        },
        7001..=7249 => Variable::WorkZero(WorkOffset::Additional(group(7001) as u16 + 1), axis(7001)?),
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_those_of_the_tables() {
        assert_eq!(variable(5206), Some(Variable::WorkZero(WorkOffset::Standard(1), 0)));
        assert_eq!(variable(5234), Some(Variable::WorkZero(WorkOffset::Standard(6), 3)));
        assert_eq!(variable(7246), Some(Variable::WorkZero(WorkOffset::Additional(50), 0)));
        assert_eq!(variable(5019), Some(Variable::SkipPosition(3)));
        assert_eq!(variable(5010), None);
        assert_eq!(variable(4030), Some(Variable::ModalWord(b'P')));
        assert_eq!(variable(200), None);
    }
}
