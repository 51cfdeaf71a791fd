//! Stage absolute/incremental: G90 and G91.

use crate::stages::units;
use crate::words::Words;
use ferrocut_geometry::{AxisSet, Position};

/// The programmed end point of a block that starts at `from`. Axes without a word stay.
#[inline]
pub(crate) fn end_point(
    words: &Words,
    axes: AxisSet,
    from: Position,
    incremental: bool,
    inch_axes: AxisSet,
) -> Position {
    let mut to = from;
    for axis in axes.iter() {
        if let Some(value) = words.get(axis.letter() as u8) {
            let value = units::coordinate(axis, value, inch_axes);
            to[axis] = if incremental { from[axis] + value } else { value };
        }
    }
    to
}
