//! Names that programs give to variables and subprograms, each with a number of its own.
//!
//! One table is kept for all files of a program memory, so that what the lexer notes of a name is the number
//! that it is found by, and running a program compares no text.

use std::collections::HashMap;

/// Bytes of a name at most; longer than any line that people write.
pub const LONGEST_NAME: usize = 255;

/// Names at most: a program of names alone must not take the memory of the machine.
const MAX_NAMES: usize = 1 << 16;

/// From here on the numbers of variables are those of names.
pub const FIRST_NAMED: u32 = 1 << 31;

/// The names met so far.
#[derive(Clone, Debug, Default)]
pub struct Names {
    numbers: HashMap<Box<str>, u32>,
    texts: Vec<Box<str>>,
}

impl Names {
    /// The number of a name; `None` once there is no room for more.
    pub fn number(&mut self, name: &str) -> Option<u32> {
        if let Some(number) = self.numbers.get(name) {
            return Some(*number);
        }
        if self.texts.len() >= MAX_NAMES || name.len() > LONGEST_NAME {
            return None;
        }
        let number = self.texts.len() as u32;
        self.numbers.insert(name.into(), number);
        self.texts.push(name.into());
        Some(number)
    }

    /// The number of a name that was met before.
    pub fn known(&self, name: &str) -> Option<u32> {
        self.numbers.get(name).copied()
    }

    /// The name with a number.
    pub fn text(&self, number: u32) -> Option<&str> {
        self.texts.get(usize::try_from(number).ok()?).map(|text| &**text)
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.texts.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.texts.is_empty()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_keeps_its_number() {
        let mut names = Names::default();
        assert_eq!((names.number("a"), names.number("b"), names.number("a")), (Some(0), Some(1), Some(0)));
        assert_eq!((names.text(1), names.text(2)), (Some("b"), None));
        assert_eq!((names.known("b"), names.known("c")), (Some(1), None));
        assert_eq!(names.number(&"x".repeat(LONGEST_NAME + 1)), None);
    }

    #[test]
    fn names_cannot_fill_the_memory() {
        let mut names = Names::default();
        let taken = (0..MAX_NAMES + 10).filter(|n| names.number(&n.to_string()).is_some()).count();
        assert_eq!(taken, MAX_NAMES);
    }
}
