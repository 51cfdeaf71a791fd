//! Roughing a rectangular pocket: G33 counter-clockwise, G34 clockwise (GSK990MC 4.6.4).

use super::depths::Depths;
use super::fault::{CycleFault, Problem};
use super::plan::{Area, Plan, Rough};
use super::rectangle::{Rectangle, widest_step};
use super::words::{Roughing, above_zero, corner, exceeds, levels, not_zero, or_zero, point};
use crate::cycles::tool::Frame;
use ferrocut_geometry::Turn;

/// Words of G33 and G34, mm.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RectPocket {
    /// X, Y: the middle of the pocket.
    pub center: [f64; 2],
    /// R level.
    pub r: f64,
    /// Z: bottom.
    pub bottom: f64,
    /// I, J: sizes in X and Y.
    pub sizes: [Option<f64>; 2],
    /// L, W, Q, V and P269. The sign of L is left aside (table 3-1-3-1), and where it is wider than
    /// [`widest_step`] the tool steps over by that instead.
    pub roughing: Roughing,
    /// U: radius of the corners; sharp ones, as far as a round tool can, if absent or 0.
    pub corner: Option<f64>,
    /// The tool radius that D names; `None` for no D and D0.
    pub tool_radius: Option<f64>,
    /// The way round.
    pub turn: Turn,
}

impl RectPocket {
    /// The plan, or what forbids it: 193, 194, 195, 191, 192, 190, 185, 186, 187, 188, 189, looked for
    /// in this order.
    pub fn plan(&self) -> Result<Plan, CycleFault> {
        let center = point(self.center)?;
        let [r, bottom] = levels(self.r, self.bottom)?;
        let [i, j] = self.sizes;
        let (i, j) = (or_zero(i, b'I')?, or_zero(j, b'J')?);
        Problem::SizeMissing.when(i == 0.0, b'I')?;
        Problem::SecondSizeMissing.when(j == 0.0, b'J')?;
        let tool = above_zero(self.tool_radius, b'D', Problem::ToolMissing)?;
        let [first, depth, gap] = self.roughing.depths()?;
        let step = not_zero(self.roughing.step, b'L', Problem::StepTooSmall)?;
        Problem::StepTooLarge.when(exceeds(step, 2.0 * tool), b'L')?;
        Problem::ToolTooLarge.when(exceeds(2.0 * tool, i.min(j)), b'D')?;
        // Table 3-1-3-1: I and J above 2·(P269·r + r).
        let helix = self.roughing.helix(tool)?;
        Problem::ToolTooLarge.when(exceeds(helix + tool, i.min(j) / 2.0), b'D')?;
        let corner = (corner(self.corner, tool, [i, j])? - tool).max(0.0);
        let depths = Depths { r, bottom, first, step: depth, gap };
        let step = step.min(widest_step(tool, corner));
        let area = Area::Rectangle(Rectangle { half: [i / 2.0 - tool, j / 2.0 - tool], corner });
        Plan::rough(
            Frame::new(center, 0.0, self.turn),
            Rough { depths, helix, tool_radius: tool, step, area },
        )
    }
}
