//! Splines of drawings, held to what a drawing may be.

use crate::curve::Curve;
use crate::limits::{Limits, Refused};

pub use ferrocut_geometry::spline::{MOST_DEGREE, Spline};

/// The spline seen from above: lines and arcs within `tolerance` of it.
pub fn curves(
    spline: &Spline,
    tolerance: f64,
    limits: &mut Limits,
    out: &mut Vec<Curve>,
) -> Result<(), Refused> {
    for p in spline.points() {
        limits.reach([p[0], p[1]])?;
    }
    spline.curves(tolerance, |already| limits.point(already), out)
}
