//! What is wrong with a parameter of a cycle.

use ferrocut_machine::Fault;

/// A parameter that a cycle cannot be made with.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct WrongParameter {
    /// The rule that it breaks.
    pub fault: Fault,
    /// Its name in the control's language; also `T` where the tool is to blame.
    pub word: &'static str,
    /// The part of the cycle that it stands in, where it has parts.
    pub part: Option<&'static str>,
    /// Its value, and the largest or smallest that it may have.
    pub values: Option<[f64; 2]>,
    /// Which contour of a profile, the first one 0.
    pub contour: Option<usize>,
}

impl WrongParameter {
    /// A parameter that breaks a rule.
    pub fn new(fault: Fault, word: &'static str) -> WrongParameter {
        WrongParameter { fault, word, part: None, values: None, contour: None }
    }

    /// The same with its value and its limit.
    pub fn beyond(fault: Fault, word: &'static str, value: f64, limit: f64) -> WrongParameter {
        WrongParameter { fault, word, part: None, values: Some([value, limit]), contour: None }
    }

    /// The same in a part of the cycle.
    pub fn of_part(self, part: &'static str) -> WrongParameter {
        WrongParameter { part: Some(part), ..self }
    }
}

/// An error where `wrong`.
pub fn refuse(wrong: bool, fault: Fault, word: &'static str) -> Result<(), WrongParameter> {
    if wrong { Err(WrongParameter::new(fault, word)) } else { Ok(()) }
}

/// A size that must be above 0.
pub fn positive(value: f64, word: &'static str) -> Result<f64, WrongParameter> {
    refuse(!(value > 0.0 && value.is_finite()), Fault::CycleParameter, word)?;
    Ok(value)
}
