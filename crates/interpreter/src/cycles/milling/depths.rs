//! Levels of a pocket cut in passes (GSK990MC 4.6.1).
//!
//! ```text
//! zₙ = max(R − W − n·Q, bottom),   n = 0, 1, …
//! ```
//!
//! The first depth is measured from the R level and so holds the way through the air above the part.
//! Levels are products and not sums, so that a thousand passes of 0.1 end where the drawing says.

use super::count::steps;
use ferrocut_geometry::SAME_POINT_MM;

/// The levels of the passes.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Depths {
    /// R level, mm.
    pub r: f64,
    /// Bottom, below `r`, mm.
    pub bottom: f64,
    /// First depth from the R level (W), above 0, mm.
    pub first: f64,
    /// Depth of each further pass (Q), above 0, mm.
    pub step: f64,
    /// Height above uncut material at which a rapid down ends (V), above 0, mm.
    pub gap: f64,
}

impl Depths {
    /// Number of passes, at least 1.
    pub fn passes(&self) -> f64 {
        let rest = self.r - self.first - self.bottom;
        // A rest that is nothing but rounding is no pass.
        if rest <= SAME_POINT_MM { 1.0 } else { 1.0 + steps(rest, self.step) }
    }

    /// Level of pass `n`, counted from 0. The last one is the bottom exactly.
    pub fn level(&self, n: u32) -> f64 {
        let n = f64::from(n);
        let z = self.r - self.first - n * self.step;
        if n + 1.0 >= self.passes() { self.bottom } else { z.max(self.bottom) }
    }

    /// Level where the rapid down before pass `n` ends: the gap above what pass `n − 1` left, and not
    /// above the R level, from which it comes.
    pub fn rapid_level(&self, n: u32) -> f64 {
        match n.checked_sub(1) {
            Some(before) => (self.level(before) + self.gap).min(self.r),
            None => self.r,
        }
    }
}
