//! Powered flow: what the page of the ladder lights up.

/// Behind the instruction the line is on.
const POWERED: u8 = 1;
/// The contact conducts, the coil was on, or the conditions of the function were.
const ON: u8 = 2;
/// It was carried out since watching began.
const REACHED: u8 = 4;

/// The flow at an instruction in the last scan that carried it out.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Flow {
    /// Whether it was ever carried out since watching began.
    pub is_reached: bool,
    /// Whether the contact conducts. Of a coil, whether it was on before; of a function, its ACT.
    pub is_on: bool,
    /// Whether the line behind it is on: ST0.
    pub is_powered: bool,
}

impl Flow {
    pub(crate) fn of(bits: u8) -> Flow {
        Flow { is_reached: bits & REACHED != 0, is_on: bits & ON != 0, is_powered: bits & POWERED != 0 }
    }
}

pub(crate) fn record(flow: &mut [u8], instruction: u32, is_powered: bool, is_on: bool) {
    if let Some(flow) = flow.get_mut(instruction as usize) {
        *flow = REACHED | if is_on { ON } else { 0 } | if is_powered { POWERED } else { 0 };
    }
}
