//! A short line between two sharp corners, and both of them, run as one: the end of a row of a raster.
//!
//! From a corner rounded in time ([`crate::path::corner`]) the path must be able to stop before the next one. On a short
//! line it can so only if the corners are slow. But a short line is run from rest to rest in no more than
//!
//! ```text
//! T = 4·(L/2J)^⅓        +J for T/4, −J for T/2, +J for T/4
//! ```
//!
//! whatever is before and behind it; and it may begin when the way before is still `r` from its end, and end when the way
//! behind is `r` from its start: what each goes is added, as at a corner. With `t₁ = (6r/J)^⅓` that takes `T − 2·t₁` in
//! all, against stopping at both vertices. With the lengths `r` at both vertices, directions `d₁`, `d₂`, `d₃` and `x` the
//! share of `T`,
//!
//! ```text
//! q = p − d₁·r·(1 − xT/t₁)₊³ + d₂·m(x) + d₃·r·(1 − (1−x)T/t₁)₊³
//! ```
//!
//! **Tolerance**: with `t ≤ t₁` since the start, `m ≤ J·t³/6`, so that the smaller of what is left before and what is gone
//! behind is at most `r/8`, and the path at most `r/8·|d₂ − d₁|` from the lines, as at a corner of that reach.
//!
//! **Limits**: the jerk is one of `J·(d₁ ± d₂)`, `±J·d₂`, `J·(d₃ ± d₂)`; the acceleration is linear between the times at
//! which it changes. The speed of the line in its middle is `J·T²/16`, that at both ends `J·t₁²/2`.

use crate::limits::Inverse;
use crate::path::corner::{norm, of_acceleration, of_jerk};
use crate::timing::ramp::Foot;
use ferrocut_geometry::Position;

/// The ways before and behind a line that is run as one with its corners are so many times as long.
pub(crate) const LONGER: f64 = 1.2;

/// The line between both vertices.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Link {
    /// Its direction.
    pub d: Position,
    /// mm.
    pub len: f64,
    /// The share of the duration in which the way before ends, and that behind begins.
    share: f64,
}

/// How a link is run.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Linked {
    pub link: Link,
    /// Duration, s.
    pub time: f64,
    /// State at both ends, away from it.
    pub foot: Foot,
    /// Highest speed of the line, mm/s.
    pub peak: f64,
}

impl Linked {
    /// The line of `len` in the direction `d` between two others in the directions `sides`, the corners with this reach.
    /// `None` if there is less room than the corners take.
    pub fn new(reach: f64, d: Position, len: f64, sides: [Position; 2], inverse: &Inverse) -> Option<Linked> {
        let both = sides.map(|side| [side + d, side - d]);
        let jerks = [d, both[0][0], both[0][1], both[1][0], both[1][1]];
        let j = jerks.iter().fold(1e-12, |most: f64, jerk| most.max(of_jerk(jerk, inverse))).recip();
        let (time, overlap) = durations(reach, len, j);
        // Where the acceleration of the line or of the other side changes.
        let quarter = 0.25 * time;
        let gone = |t: f64| if t < quarter { t } else { 2.0 * quarter - t };
        let acceleration = |side: &Position, t: f64| {
            let a = side.zip(d, |side, d| j * (gone(t) * d - (overlap - t).max(0.0) * side));
            of_acceleration(&a, inverse)
        };
        // Behind, what slows the line down is against its direction, and the way behind speeds up.
        let most =
            sides.iter().flat_map(|side| [0.0, quarter.min(overlap), quarter].map(|t| acceleration(side, t)));
        let most = most.fold(0.0, f64::max);
        // With less jerk all is slower, the acceleration by the square.
        let j = if most > 1.0 { j / (most * most.sqrt()) } else { j };
        let (time, overlap) = durations(reach, len, j);
        let foot = Foot { v: 0.5 * j * overlap * overlap, a: j * overlap };
        let is_possible = 2.0 * overlap <= time && foot.v.is_finite() && foot.v > 0.0 && j.is_finite();
        let link = Link { d, len, share: overlap / time };
        is_possible.then_some(Linked { link, time, foot, peak: j * time * time / 16.0 * norm(&d.0) })
    }
}

impl Link {
    /// Where the three are at the share `x` of the duration: how far before the first vertex, how far on the line, how far
    /// behind the second, the outer two as shares of the reach; and how fast, those as shares of the speed at the ends, the
    /// line in mm for the whole duration.
    pub fn at(&self, x: f64) -> [[f64; 2]; 3] {
        let side = |x: f64| {
            let left = (1.0 - x / self.share).max(0.0);
            [left * left * left, left * left]
        };
        // 4 times the share of a quarter, cubed, is half of the way.
        let rising = |x: f64| {
            let early = |x: f64| [16.0 / 3.0 * x * x * x, 16.0 * x * x];
            if x <= 0.25 {
                return early(x);
            }
            let y = 0.5 - x;
            let [_, top] = early(0.25);
            [0.5 - 2.0 * y + 16.0 / 3.0 * y * y * y, 2.0 * top - 16.0 * y * y]
        };
        let [gone, faster] = if x <= 0.5 { rising(x) } else { rising(1.0 - x) };
        let gone = if x <= 0.5 { gone } else { 1.0 - gone };
        [side(x), [gone * self.len, faster * self.len], side(1.0 - x)]
    }
}

/// How long the line takes, and how long the way to a vertex, s.
fn durations(reach: f64, len: f64, j: f64) -> (f64, f64) {
    (4.0 * (len / (2.0 * j)).cbrt(), (6.0 * reach / j).cbrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_goes_from_rest_to_rest_with_one_jerk_to_and_fro() {
        let link = Link { d: Position::xyz(1.0, 0.0, 0.0), len: 0.5, share: 0.3 };
        let way = |x: f64| link.at(x)[1];
        assert_eq!((way(0.0), way(1.0)[1]), ([0.0, 0.0], 0.0));
        assert!((way(0.5)[0] - 0.25).abs() < 1e-12 && (way(1.0)[0] - 0.5).abs() < 1e-12);
        let h = 1e-4;
        for k in 1..1000 {
            let x = f64::from(k) / 1000.0 + 3e-4;
            if [0.25, 0.5, 0.75, 1.0].iter().any(|place| (x - place).abs() < 2.0 * h) {
                continue;
            }
            let (before, here, behind) = (way(x - h), way(x), way(x + h));
            assert!(((behind[0] - before[0]) / (2.0 * h) - here[1]).abs() < 1e-6, "{x}");
            // The jerk of a way of 1 in the time 1 is 32.
            let jerk = (behind[1] - 2.0 * here[1] + before[1]) / (h * h);
            let expected = if (0.25..0.75).contains(&x) { -16.0 } else { 16.0 };
            assert!((jerk - expected).abs() < 1e-3, "{x}: {jerk}");
        }
        // The ways beside it.
        assert_eq!(link.at(0.0)[0], [1.0, 1.0]);
        assert_eq!((link.at(0.3)[0], link.at(0.7)[2]), ([0.0, 0.0], [0.0, 0.0]));
        assert!((link.at(1.0)[2][0] - 1.0).abs() < 1e-12);
    }
}
