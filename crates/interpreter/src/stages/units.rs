//! Stage inch/metric: G20 and G21.

use ferrocut_geometry::{Axis, MM_PER_INCH};

/// A programmed length in mm.
#[inline]
pub fn length_mm(value: f64, inch: bool) -> f64 {
    if inch { value * MM_PER_INCH } else { value }
}

/// A programmed coordinate: mm for a linear axis, degrees (which have no inch) for a rotary one.
#[inline]
pub fn coordinate(axis: Axis, value: f64, inch: bool) -> f64 {
    if axis.is_linear() { length_mm(value, inch) } else { value }
}
