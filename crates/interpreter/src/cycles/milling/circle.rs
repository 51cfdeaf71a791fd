//! Clearing a circular area, and its contour.
//!
//! The area is cleared from the centre outward on a spiral of half circles, whose centres lie in turn
//! at −L/4 and +L/4 and whose radii grow by L/2:
//!
//! ```text
//! half circle m = 1, 2, …:  centre ∓L/4,  radius (m − ½)·L/2,  ends at ∓m·L/2
//! ```
//!
//! Each joins the next along a common tangent, and turns on the same side are concentric: they lie L
//! apart all the way round. Half circle m stays within m·L/2 of the middle, the last one is bent to
//! reach the radius exactly, and there it runs into the full circle without a corner. The first leaves the
//! middle in +v.

use super::count::steps;
use super::cutter::{Cutter, CycleMove};
use crate::cycles::tool::Take;
use ferrocut_geometry::SAME_POINT_MM;

/// Number of moves that [`clear`] takes.
pub fn moves(radius: f64, step: f64) -> f64 {
    steps(2.0 * radius, step) + 1.0
}

/// Takes the tool centre from the origin over every circle out to `radius`, stepping over by `step` a
/// turn. What lies within `radius` plus the tool radius is cut if `step` is no more than the diameter.
pub fn clear<S: Take<CycleMove>>(cutter: &mut Cutter<'_, S>, radius: f64, step: f64) -> Result<(), S::Error> {
    if radius <= SAME_POINT_MM {
        return Ok(());
    }
    let halves = steps(2.0 * radius, step) as u32;
    let mut from = 0.0;
    let mut side = -1.0;
    for m in 1..=halves {
        let reach = if m == halves { radius } else { f64::from(m) * step / 2.0 };
        let to = side * reach;
        cutter.half_circle([to, 0.0], [(from + to) / 2.0, 0.0], 1.0)?;
        (from, side) = (to, -side);
    }
    contour(cutter)
}

/// The full circle about the origin through the tool.
pub fn contour<S: Take<CycleMove>>(cutter: &mut Cutter<'_, S>) -> Result<(), S::Error> {
    let z = cutter.z();
    cutter.turn([0.0, 0.0], z)
}
