//! Stage inch/metric: G20 and G21.

use ferrocut_geometry::{Axis, AxisSet, MM_PER_INCH};

/// A programmed length in mm.
#[inline]
pub fn length_mm(value: f64, inch: bool) -> f64 {
    if inch { value * MM_PER_INCH } else { value }
}

/// A programmed coordinate in mm, or in degrees, which have no inch. `inch_axes` are the axes whose words
/// are inches: the linear ones with G20, none with G21.
#[inline]
pub fn coordinate(axis: Axis, value: f64, inch_axes: AxisSet) -> f64 {
    length_mm(value, inch_axes.contains(axis))
}

/// A coordinate in mm or degrees as the program would write it.
pub fn in_words(axis: Axis, value: f64, inch_axes: AxisSet) -> f64 {
    if inch_axes.contains(axis) { value / MM_PER_INCH } else { value }
}

/// A length in mm as a program writes it.
#[inline]
pub fn from_mm(value: f64, inch: bool) -> f64 {
    if inch { value / MM_PER_INCH } else { value }
}
