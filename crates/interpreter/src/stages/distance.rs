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
    go_on(&mut to, words, axes, incremental, inch_axes);
    to
}

/// Moves `at` to the programmed end point of a block that starts there.
#[inline]
pub(crate) fn go_on(at: &mut Position, words: &Words, axes: AxisSet, incremental: bool, inch_axes: AxisSet) {
    for axis in axes.iter() {
        if let Some(value) = words.get(axis.letter() as u8) {
            let value = units::coordinate(axis, value, inch_axes);
            at[axis] = if incremental { at[axis] + value } else { value };
        }
    }
}
