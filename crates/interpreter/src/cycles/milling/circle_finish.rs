//! Finishing a round wall: a hole with G24, G25, a boss with G26, G32, the first of each
//! counter-clockwise (GSK990MC 4.6.2, 4.6.3).

use super::fault::{CycleFault, Problem};
use super::plan::{Contour, Finish, Plan};
use super::tangent::Tangent;
use super::words::{Side, above_zero, exceeds, levels, not_zero, or_zero, point};
use crate::cycles::tool::Frame;
use ferrocut_geometry::Turn;

/// Words of G24, G25, G26 and G32, mm.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CircleFinish {
    /// G24, G25 inside; G26, G32 outside.
    pub side: Side,
    /// X, Y: the middle of the circle.
    pub center: [f64; 2],
    /// R level.
    pub r: f64,
    /// Z: bottom.
    pub bottom: f64,
    /// I: radius of the wall; its sign is left aside.
    pub radius: Option<f64>,
    /// J: distance of the start from the middle (inside) or from the wall (outside), in +X; its sign is
    /// left aside.
    pub start: Option<f64>,
    /// The tool radius that D names; `None` for no D and D0.
    pub tool_radius: Option<f64>,
    /// The way round the wall.
    pub turn: Turn,
}

impl CircleFinish {
    /// The plan, or what forbids it: 193, 194, 195, 187, looked for in this order.
    ///
    /// J0 is the middle of a hole, which table 3-1-3-1 allows; beside a boss it would be in the wall and
    /// is alarm 194.
    pub fn plan(&self) -> Result<Plan, CycleFault> {
        let center = point(self.center)?;
        let [r, bottom] = levels(self.r, self.bottom)?;
        let radius = not_zero(self.radius, b'I', Problem::SizeMissing)?;
        let j = or_zero(self.start, b'J')?.abs();
        Problem::SecondSizeMissing
            .when(self.start.is_none() || (j == 0.0 && self.side == Side::Outside), b'J')?;
        let tool = above_zero(self.tool_radius, b'D', Problem::ToolMissing)?;
        let (start, wall) = match self.side {
            Side::Inside => (j, radius - tool),
            Side::Outside => (radius + j, radius + tool),
        };
        let beyond = match self.side {
            Side::Inside => exceeds(tool, radius - j),
            Side::Outside => exceeds(tool, j),
        };
        Problem::ToolTooLarge.when(beyond, b'D')?;
        let tangent = Tangent { start, wall, largest: f64::INFINITY };
        let frame = Frame::new(center, 0.0, self.turn);
        Ok(Plan::finish(frame, Finish { r, bottom, tangent, contour: Contour::Circle }))
    }
}
