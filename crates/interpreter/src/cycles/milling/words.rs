//! What several cycles ask of their words.

use super::fault::{CycleFault, Problem};
use ferrocut_geometry::SAME_POINT_MM;

/// Largest magnitude of any word, mm (GSK990MC table 3-1-3-1: eight digits).
const LARGEST: f64 = 99_999_999.0;

/// Words of the depths of a roughing cycle, mm; `None` where absent.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Roughing {
    /// L: step over.
    pub step: Option<f64>,
    /// W: first depth, from the R level.
    pub first_depth: Option<f64>,
    /// Q: depth of each further pass. With its sign: here, unlike in drilling, it must be above 0.
    pub depth: Option<f64>,
    /// V: where a rapid down ends above uncut material.
    pub gap: Option<f64>,
    /// Radius of the helix of the entry over the tool radius (parameter P269).
    pub helix_factor: f64,
}

/// Which side of a contour is finished.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Side {
    /// The wall of a pocket.
    Inside,
    /// The wall of an island.
    Outside,
}

impl Roughing {
    /// W, Q and V, which must all be above 0 (alarms 191, 192, 190).
    pub(crate) fn depths(&self) -> Result<[f64; 3], CycleFault> {
        let first = above_zero(self.first_depth, b'W', Problem::FirstDepthMissing)?;
        let depth = above_zero(self.depth, b'Q', Problem::DepthMissing)?;
        let gap = above_zero(self.gap, b'V', Problem::GapMissing)?;
        Ok([first, depth, gap])
    }

    /// Radius of the helix, mm. P269 is above 0 (4.6.1 note 2).
    pub(crate) fn helix(&self, tool_radius: f64) -> Result<f64, CycleFault> {
        let factor = self.helix_factor;
        if !(factor > 0.0 && factor <= LARGEST) {
            return Err(CycleFault { problem: Problem::OutOfRange, letter: None });
        }
        Ok(factor * tool_radius)
    }
}

/// Whether `a` is above `b` by more than the rounding of sums: J0.2 in a circle of I0.3 leaves room for
/// a tool of 0.1, although 0.3 − 0.2 < 0.1 in floating point.
pub(crate) fn exceeds(a: f64, b: f64) -> bool {
    a > b + SAME_POINT_MM
}

/// A word as it is, 0 where absent.
pub(crate) fn or_zero(word: Option<f64>, letter: u8) -> Result<f64, CycleFault> {
    in_range(word.unwrap_or(0.0), letter)
}

/// A word whose sign is left aside and that must not be 0.
pub(crate) fn not_zero(word: Option<f64>, letter: u8, problem: Problem) -> Result<f64, CycleFault> {
    above_zero(word.map(f64::abs), letter, problem)
}

/// A word that must be above 0.
pub(crate) fn above_zero(word: Option<f64>, letter: u8, problem: Problem) -> Result<f64, CycleFault> {
    let value = or_zero(word, letter)?;
    if value > 0.0 { Ok(value) } else { Err(problem.of(letter)) }
}

/// The corner radius U; its sign is left aside, 0 is a sharp corner. At least the tool radius (189, also
/// where 187 speaks of "radius above U": both name this case, and U is what to change), at most half of
/// either side (188).
pub(crate) fn corner(word: Option<f64>, tool_radius: f64, sizes: [f64; 2]) -> Result<f64, CycleFault> {
    let u = or_zero(word, b'U')?.abs();
    let [i, j] = sizes;
    Problem::CornerTooLarge.when(exceeds(2.0 * u, i.min(j)), b'U')?;
    Problem::CornerTooSmall.when(u > 0.0 && exceeds(tool_radius, u), b'U')?;
    Ok(u)
}

/// The R level and a bottom below it.
pub(crate) fn levels(r: f64, bottom: f64) -> Result<[f64; 2], CycleFault> {
    let levels = [in_range(r, b'R')?, in_range(bottom, b'Z')?];
    Problem::BottomNotBelowR.when(bottom >= r, b'Z')?;
    Ok(levels)
}

/// X and Y.
pub(crate) fn point([x, y]: [f64; 2]) -> Result<[f64; 2], CycleFault> {
    Ok([in_range(x, b'X')?, in_range(y, b'Y')?])
}

fn in_range(value: f64, letter: u8) -> Result<f64, CycleFault> {
    // Not-a-number is in no range.
    if value.abs() <= LARGEST { Ok(value) } else { Err(Problem::OutOfRange.of(letter)) }
}
