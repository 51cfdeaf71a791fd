//! Entry into solid material on a helix.

use super::count::steps;
use super::cutter::{Cutter, CycleMove};
use crate::cycles::tool::Take;
use ferrocut_geometry::SAME_POINT_MM;

/// Turns of equal pitch, at most `pitch` each, that sink the tool by `depth`; at least 1.
pub fn turns(depth: f64, pitch: f64) -> f64 {
    steps(depth, pitch)
}

/// Sinks the tool to the level `bottom` on a helix about the origin.
///
/// The tool stands on its circle, on the −u side (GSK990MC 4.6.1 ⑴), and comes back to there: whole
/// turns only. On a circle of no radius it is a plunge.
pub fn entry<S: Take<CycleMove>>(
    cutter: &mut Cutter<'_, S>,
    radius: f64,
    bottom: f64,
    pitch: f64,
) -> Result<(), S::Error> {
    let depth = cutter.z() - bottom;
    if radius <= SAME_POINT_MM || depth <= SAME_POINT_MM {
        return cutter.feed_z(bottom);
    }
    let count = turns(depth, pitch) as u32;
    for left in (0..count).rev() {
        cutter.turn([0.0, 0.0], bottom + depth * f64::from(left) / f64::from(count))?;
    }
    Ok(())
}
