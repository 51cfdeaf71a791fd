//! Variables of the macro language, by the numbers of the Fanuc 0i-M.

use crate::dialect::Variable;
use ferrocut_machine::WorkOffset;

/// What a variable stands for.
pub fn variable(number: u32) -> Option<Variable> {
    let within = |first: u32| (number - first) as u16;
    // Twenty numbers a system; axes 1 to 4.
    let axis = |first: u32| u8::try_from((number - first) % 20).ok().filter(|axis| *axis < 4);
    let system = |first: u32| (number - first) / 20;
    Some(match number {
        0 => Variable::Empty,
        1..=33 | 100..=199 | 500..=999 => Variable::Plain,
        1000..=1015 => Variable::Input(within(1000)),
        1032 => Variable::InputWord,
        1100..=1115 | 1132 => Variable::Output(within(1100)),
        2001..=2024 => Variable::ToolLength(within(2000)),
        3000 => Variable::Alarm,
        4001..=4017 => Variable::ModalGroup(within(4000) as u8),
        4107 => Variable::ModalWord(b'D'),
        4109 => Variable::ModalWord(b'F'),
        4111 => Variable::ModalWord(b'H'),
        4113 => Variable::ModalWord(b'M'),
        4114 => Variable::ModalWord(b'N'),
        4115 => Variable::ModalWord(b'O'),
        4119 => Variable::ModalWord(b'S'),
        4120 => Variable::ModalWord(b'T'),
        5001..=5104 => match system(5001) {
            0 => Variable::BlockEnd(axis(5001)?),
            1 => Variable::MachinePosition(axis(5001)?),
            2 => Variable::WorkPosition(axis(5001)?),
            3 => Variable::SkipPosition(axis(5001)?),
            4 => Variable::LengthOffset(axis(5001)?),
            _ => Variable::ServoOffset(axis(5001)?),
        },
        5201..=5324 => match system(5201) {
            0 => Variable::WorkZero(WorkOffset::External, axis(5201)?),
            number => Variable::WorkZero(WorkOffset::Standard(number as u8), axis(5201)?),
        },
        7001..=7944 => Variable::WorkZero(WorkOffset::Additional(system(7001) as u16 + 1), axis(7001)?),
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_those_of_fanuc() {
        assert_eq!(variable(5221), Some(Variable::WorkZero(WorkOffset::Standard(1), 0)));
        assert_eq!(variable(5324), Some(Variable::WorkZero(WorkOffset::Standard(6), 3)));
        assert_eq!(variable(7944), Some(Variable::WorkZero(WorkOffset::Additional(48), 3)));
        assert_eq!(variable(5064), Some(Variable::SkipPosition(3)));
        assert_eq!(variable(2024), Some(Variable::ToolLength(24)));
        assert_eq!([34, 2025, 4018, 5005, 5205, 7945].map(variable), [None; 6]);
    }
}
