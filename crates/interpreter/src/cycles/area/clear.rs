//! Covering an area with passes of equal width.

use super::outline::Outline;
use super::passes;
use crate::cycles::tool::{Take, Tool};
use ferrocut_geometry::SAME_POINT_MM;
use std::f64::consts::FRAC_1_SQRT_2;

/// The widest step at which rings of this outline leave nothing standing between them.
///
/// Along a side two passes may lie a diameter apart. At sharp corners they lie √2 further, and the diagonal
/// is cut only for `(s − r)·√2 ≤ r`, that is `s ≤ r(1 + 1/√2)`. Circles have no such corner.
pub fn widest_step(outline: &Outline, radius: f64) -> f64 {
    if outline.is_circle() { 2.0 * radius } else { radius * (1.0 + FRAC_1_SQRT_2) }
}

/// Takes the tool from the origin over everything within `outline`, its path along the wall last. The
/// frame's u lies along the longer side.
pub fn inside<T: Take>(
    tool: &mut Tool<'_, T>,
    outline: &Outline,
    step: f64,
    radius: f64,
) -> Result<(), T::Error> {
    let [a, b] = outline.half;
    let (count, width) = passes(b, step.min(widest_step(outline, radius)));
    let line = a - b;
    // Rings no further apart than the radius cover the middle themselves.
    if line > SAME_POINT_MM && (count == 0 || width > radius) {
        tool.feed([line, 0.0])?;
        tool.feed([-line, 0.0])?;
    }
    for ring in 1..=count {
        let path = outline.inset(width * f64::from(count - ring));
        tool.feed(path.start())?;
        path.contour(tool)?;
    }
    Ok(())
}

/// The same from a circle of radius `from`, which the tool has room in, outwards. From the middle the tool
/// runs into the first ring on a half circle.
pub fn ring<T: Take>(
    tool: &mut Tool<'_, T>,
    from: f64,
    to: f64,
    step: f64,
    radius: f64,
) -> Result<(), T::Error> {
    let (count, width) = passes(to - from, step.min(2.0 * radius));
    let z = tool.z();
    for ring in 1..=count {
        let out = to - width * f64::from(count - ring);
        match ring {
            1 => tool.half_circle([out, 0.0], [out / 2.0, 0.0], 1.0, z)?,
            _ => tool.feed([out, 0.0])?,
        }
        tool.turns([0.0; 2], 1.0, z)?;
    }
    Ok(())
}

/// Paths round an outline from outside in, for material that reaches `stock` beyond it: with square
/// corners, or round where the outline is a circle. `wall` is the distance of the last path.
///
/// All but the last lie so that each cuts a strip of equal width, none wider than `step`.
pub fn around(
    outline: &Outline,
    wall: f64,
    stock: f64,
    step: f64,
    radius: f64,
) -> impl Iterator<Item = Outline> + use<> {
    let outline = *outline;
    let (count, width) = passes(stock + radius - wall, step.min(widest_step(&outline, radius)));
    let side = wall + width * f64::from(count.saturating_sub(1));
    let corners = match outline.is_circle() || count == 0 {
        true => 0,
        false => passes(outline.sharp_at(side) - side, width).0,
    };
    (0..(count + corners).max(1)).rev().map(move |path| outline.outset(wall + width * f64::from(path), side))
}
