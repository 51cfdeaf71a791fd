//! Roughing a round pocket: G22 counter-clockwise, G23 clockwise (GSK990MC 4.6.1).

use super::depths::Depths;
use super::fault::{CycleFault, Problem};
use super::plan::{Area, Plan, Rough};
use super::words::{Roughing, above_zero, exceeds, levels, or_zero, point};
use crate::cycles::tool::Frame;
use ferrocut_geometry::Turn;

/// Words of G22 and G23, mm.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RoundPocket {
    /// X, Y: the middle of the pocket.
    pub center: [f64; 2],
    /// R level.
    pub r: f64,
    /// Z: bottom.
    pub bottom: f64,
    /// I: radius of the pocket.
    pub radius: Option<f64>,
    /// L, W, Q, V and P269.
    pub roughing: Roughing,
    /// The tool radius that D names; `None` for no D and D0.
    pub tool_radius: Option<f64>,
    /// The way round.
    pub turn: Turn,
}

impl RoundPocket {
    /// The plan, or what forbids it: 193, 195, 191, 192, 190, 185, 186, 187, looked for in this order.
    pub fn plan(&self) -> Result<Plan, CycleFault> {
        let center = point(self.center)?;
        let [r, bottom] = levels(self.r, self.bottom)?;
        let radius = or_zero(self.radius, b'I')?;
        Problem::SizeMissing.when(radius == 0.0, b'I')?;
        let tool = above_zero(self.tool_radius, b'D', Problem::ToolMissing)?;
        let [first, depth, gap] = self.roughing.depths()?;
        let step = above_zero(self.roughing.step, b'L', Problem::StepTooSmall)?;
        Problem::StepTooLarge.when(exceeds(step, 2.0 * tool), b'L')?;
        // 187 (1) compares the tool's diameter with the radius of the pocket, and is taken at its word:
        // a pocket of less than two diameters is no work for this cycle.
        Problem::ToolTooLarge.when(exceeds(2.0 * tool, radius), b'D')?;
        let helix = self.roughing.helix(tool)?;
        Problem::ToolTooLarge.when(exceeds(helix + tool, radius), b'D')?;
        let depths = Depths { r, bottom, first, step: depth, gap };
        let area = Area::Circle(radius - tool);
        Plan::rough(
            Frame::new(center, 0.0, self.turn),
            Rough { depths, helix, tool_radius: tool, step, area },
        )
    }
}
