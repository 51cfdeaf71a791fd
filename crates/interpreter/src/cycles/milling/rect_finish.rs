//! Finishing a rectangular wall: a pocket with G35, G36, a boss with G37, G38, the first of each
//! counter-clockwise (GSK990MC 4.6.5, 4.6.6).

use super::fault::{CycleFault, Problem};
use super::plan::{Contour, Finish, Plan};
use super::rectangle::Rectangle;
use super::tangent::Tangent;
use super::words::{Side, above_zero, corner, exceeds, levels, not_zero, or_zero, point};
use crate::cycles::tool::Frame;
use ferrocut_geometry::Turn;

/// Words of G35 to G38, mm.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RectFinish {
    /// G35, G36 inside; G37, G38 outside.
    pub side: Side,
    /// X, Y: the start, beside the middle of the side in +X. So the middle of a pocket is at
    /// X + L − I/2, that of a boss at X − L − I/2.
    pub start: [f64; 2],
    /// R level.
    pub r: f64,
    /// Z: bottom.
    pub bottom: f64,
    /// I, J: sizes in X and Y; their signs are left aside.
    pub sizes: [Option<f64>; 2],
    /// L: distance of the start from the side in +X; outside, its sign is left aside.
    pub distance: Option<f64>,
    /// U: radius of the corners, its sign left aside; if absent or 0 the tool goes round them on a
    /// sharp corner, which outside leaves a sharp edge.
    pub corner: Option<f64>,
    /// The tool radius that D names; `None` for no D and D0.
    pub tool_radius: Option<f64>,
    /// The way round the wall.
    pub turn: Turn,
}

impl RectFinish {
    /// The plan, or what forbids it: 193, 194, 195, 185, 186, 187, 188, 189, looked for in this order.
    ///
    /// A start that lies in the pocket, but nearer to the opposite side than the tool radius, is 186 too,
    /// of which the manual names only L above I and L above J: the tool would cut that side.
    pub fn plan(&self) -> Result<Plan, CycleFault> {
        let [x, y] = point(self.start)?;
        let [r, bottom] = levels(self.r, self.bottom)?;
        let [i, j] = self.sizes;
        let i = not_zero(i, b'I', Problem::SizeMissing)?;
        let j = not_zero(j, b'J', Problem::SecondSizeMissing)?;
        let tool = above_zero(self.tool_radius, b'D', Problem::ToolMissing)?;
        let distance = or_zero(self.distance, b'L')?;
        let (offset, distance, largest) = match self.side {
            Side::Inside => {
                Problem::StepTooSmall.when(exceeds(tool, distance), b'L')?;
                Problem::StepTooLarge.when(exceeds(distance, i.min(j)), b'L')?;
                Problem::ToolTooLarge.when(exceeds(2.0 * tool, i.min(j)), b'D')?;
                Problem::StepTooLarge.when(exceeds(distance, i - tool), b'L')?;
                // Half circles wider than the way of the tool in Y would cut the long sides.
                (-tool, -distance, j / 2.0 - tool)
            }
            Side::Outside => {
                Problem::StepTooSmall.when(exceeds(tool, distance.abs()), b'L')?;
                (tool, distance.abs(), f64::INFINITY)
            }
        };
        let u = corner(self.corner, tool, [i, j])?;
        let corner = if u > 0.0 { u + offset } else { 0.0 };
        let contour = Rectangle { half: [i / 2.0 + offset, j / 2.0 + offset], corner: corner.max(0.0) };
        let tangent = Tangent { start: i / 2.0 + distance, wall: i / 2.0 + offset, largest };
        let frame = Frame::new([x - tangent.start, y], 0.0, self.turn);
        Ok(Plan::finish(frame, Finish { r, bottom, tangent, contour: Contour::Rectangle(contour) }))
    }
}
