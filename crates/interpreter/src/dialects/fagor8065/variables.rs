//! Arithmetic parameters P0 and on, and the variables of the cycle in force (1.1.5).

use crate::dialect::Variable;

/// Number that P0 is kept by: 0 is always empty.
pub const FIRST_PARAMETER: u32 = 1;

/// P0 to P19999.
pub const PARAMETERS: u32 = 20_000;

/// Number of V.C.A.
const FIRST_OF_CYCLE: u32 = 100_000;

macro_rules! of_cycle {
    ($($name:literal $letter:literal,)+) => {
        &[$((concat!("V.C.", $name), FIRST_OF_CYCLE + $letter as u32 - b'A' as u32),)+]
    };
}

/// 1.1.5: one for each letter.
pub const VARIABLES: &[(&str, u32)] = of_cycle! {
    "A" b'A', "B" b'B', "C" b'C', "D" b'D', "E" b'E', "F" b'F', "G" b'G', "H" b'H', "I" b'I', "J" b'J',
    "K" b'K', "L" b'L', "M" b'M', "N" b'N', "O" b'O', "P" b'P', "Q" b'Q', "R" b'R', "S" b'S', "T" b'T',
    "U" b'U', "V" b'V', "W" b'W', "X" b'X', "Y" b'Y', "Z" b'Z',
};

/// What a variable stands for.
pub fn variable(number: u32) -> Option<Variable> {
    match number {
        FIRST_PARAMETER..=PARAMETERS => Some(Variable::Plain),
        FIRST_OF_CYCLE.. if number - FIRST_OF_CYCLE < 26 => {
            Some(Variable::CycleParameter(b'A' + (number - FIRST_OF_CYCLE) as u8))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::super::syntax::SYNTAX;
    use super::*;

    #[test]
    fn names_and_numbers_go_together() {
        assert_eq!(SYNTAX.variable(b"P0").and_then(variable), Some(Variable::Plain));
        assert_eq!(SYNTAX.variable(b"P19999").and_then(variable), Some(Variable::Plain));
        assert_eq!(SYNTAX.variable(b"P20000"), None);
        assert_eq!(SYNTAX.variable(b"v.c.z").and_then(variable), Some(Variable::CycleParameter(b'Z')));
        assert_eq!(SYNTAX.variable(b"V.C.AB"), None);
        assert_eq!(SYNTAX.variable_name(FIRST_PARAMETER + 7), "P7");
        assert_eq!(variable(0), None);
    }
}
