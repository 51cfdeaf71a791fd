//! What a pocket asks of the tool table.

use super::problem::{PocketFault, Problem, in_range, not_negative};

/// A milling tool.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Tool {
    /// Radius, mm.
    pub radius: f64,
    /// Radius of the rounded tip, mm: 0 for a flat tool, the radius for a ball.
    pub tip_radius: f64,
    /// Cutting length, mm; 0 where the table has none.
    pub cutting_length: f64,
    /// Greatest entry angle, degrees; 0 where the table has none.
    pub entry_angle: f64,
}

impl Tool {
    pub(crate) fn checked(&self) -> Result<Tool, PocketFault> {
        in_range(self.radius, "T")?;
        not_negative(self.tip_radius, "T")?;
        not_negative(self.cutting_length, "T")?;
        // Tools below a hundredth of a millimetre are slips of the pen, and paths are exact to 2 µm.
        Problem::ToolMissing.when(self.radius < 0.01 || self.tip_radius > self.radius + 1e-9, "T")?;
        Ok(*self)
    }
}
