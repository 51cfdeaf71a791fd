//! Sharp corners between two lines, rounded in time.
//!
//! Slowing down for a corner ends with a ramp that takes the acceleration back to nothing at the vertex, and
//! leaving it begins with one that builds it up again. Inside the tolerance both can run at once: with `x` from 0
//! to 1 over the duration `T`, directions `d₁` and `d₂`, vertex `p`
//!
//! ```text
//! q(x) = p + r·( −d₁·(1−x)³ + d₂·x³ )
//! q̇    = v·( d₁·(1−x)² + d₂·x² )        v = 3r/T
//! q̈    = a·( −d₁·(1−x) + d₂·x )         a = 6r/T² = 2v/T
//! q⃛    = a·( d₁ + d₂ ) / T
//! ```
//!
//! It begins on the first line at the distance `r` with speed `v` and deceleration `a`, and ends on the second at
//! the same distance, with speed `v` and acceleration `a`: the path is never without acceleration, and what a
//! ramp down to rest would take is saved. The vertex is missed by `r/8·|d₂ − d₁|` in the middle, where the curve
//! is nearest to it. That is the tolerance `δ`; of speed and duration the acceleration and the jerk of the axes
//! decide:
//!
//! ```text
//! r = 8·δ/|d₂−d₁|      a ≤ A      a·|d₁+d₂|ᵢ ≤ Jᵢ·T      with T² = 6r/a
//! ```
//!
//! For a right angle this is the overlap of the two jerk ramps by `T = (48·δ/(√2·J))^⅓`; for a turn of nearly
//! 180° `|d₁+d₂|` vanishes and the corner is passed with the full acceleration.
//!
//! A corner run at the share `λ` of its pace has speed `λ·v` and acceleration `λ²·a`, its jerk is `λ³` of the whole.

use crate::limits::{Drive, Inverse, Rates, peak};
use crate::timing::ramp::{Foot, distance, duration};
use ferrocut_geometry::{AXES, Position};

/// A rounded corner.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Corner {
    vertex: Position,
    before: Position,
    after: Position,
    /// How far before and behind the vertex it begins and ends, mm.
    pub reach: f64,
    /// Duration at full pace, s.
    pub time: f64,
    /// State at both ends at full pace: speed and acceleration away from the corner.
    pub foot: Foot,
    /// Highest speed at its ends, mm/s, by the rules of corners.
    pub cap: f64,
}

/// Corners that would take longer are stops, s.
const LONGEST: f64 = 10.0;

/// Corners that would be shorter than this are stops, mm.
const LEAST_REACH: f64 = 1e-7;

impl Corner {
    /// The corner at `vertex` within `tolerance`, taking at most `room` of either line.
    pub fn new(
        vertex: Position,
        before: Position,
        after: Position,
        tolerance: f64,
        room: f64,
        inverse: &Inverse,
    ) -> Option<Corner> {
        let turn = norm(&(after - before).0);
        let reach = (8.0 * tolerance / turn).min(room);
        if !(reach > LEAST_REACH) {
            return None;
        }
        let drive = inverse.straight(&before.0).min(inverse.straight(&after.0));
        // a·S ≤ T and T² = 6r/a: a³ ≤ 6r/S².
        let s = peak(&(after + before).0, &inverse.jerk).max(1e-12);
        let a = drive.a.min((6.0 * reach / (s * s)).cbrt());
        let time = (6.0 * reach / a).sqrt();
        if !(a > 0.0 && time > 0.0 && time < LONGEST) {
            return None;
        }
        Some(Corner {
            vertex,
            before,
            after,
            reach,
            time,
            foot: Foot { v: 0.5 * a * time, a },
            cap: f64::INFINITY,
        })
    }

    /// The same, run no faster than `cap`, mm/s.
    pub fn capped(self, cap: f64) -> Corner {
        Corner { cap, ..self }
    }

    /// The point at the share `x` of the duration.
    pub fn at(&self, x: f64) -> Position {
        let (left, gone) = ((1.0 - x).powi(3) * self.reach, x.powi(3) * self.reach);
        Position(std::array::from_fn(|i| self.vertex.0[i] - self.before.0[i] * left + self.after.0[i] * gone))
    }

    /// Bounds of the derivatives of the two lines, for a corner that is stopped at.
    pub fn rates(&self) -> Rates {
        let most = |i: usize| self.before.0[i].abs().max(self.after.0[i].abs());
        Rates { first: std::array::from_fn(most), second: [0.0; AXES], third: [0.0; AXES] }
    }

    /// The point at length `s` on the two lines.
    pub fn square(&self, s: f64) -> Position {
        let off = s - self.reach;
        let direction = if off < 0.0 { self.before } else { self.after };
        self.vertex.zip(direction, |p, d| p + d * off)
    }

    /// Speed at the share `x`, at full pace.
    pub fn speed(&self, x: f64) -> f64 {
        let (left, gone) = ((1.0 - x) * (1.0 - x), x * x);
        let v: [f64; AXES] = std::array::from_fn(|i| self.before.0[i] * left + self.after.0[i] * gone);
        norm(&v) * self.foot.v
    }

    /// What the corner costs against running on with speed `feed` on lines with `drive`, s.
    pub fn loss(&self, feed: f64, drive: Drive) -> f64 {
        let pace = pace_below(self.foot, feed, drive.j);
        let foot = paced(self.foot, pace);
        let way = foot.distance(feed, drive).unwrap_or(0.0);
        let ramp = crate::timing::ramp::Phases::new(foot, feed, drive).total();
        self.time / pace - 2.0 * self.reach / feed + 2.0 * (ramp - way / feed)
    }
}

/// What slowing down from `feed` to `v` and back costs, s.
pub(crate) fn valley_loss(v: f64, feed: f64, drive: Drive) -> f64 {
    2.0 * (duration(v, feed, drive) - distance(v, feed, drive) / feed)
}

/// The state at the share `pace`.
pub(crate) fn paced(foot: Foot, pace: f64) -> Foot {
    Foot { v: foot.v * pace, a: foot.a * pace * pace }
}

/// Highest pace, up to 1, at which the acceleration can be gone before `speed` is passed.
pub(crate) fn pace_below(foot: Foot, speed: f64, j: f64) -> f64 {
    // pace·v + pace⁴·b ≤ speed, a rising convex function: Newton from above.
    let b = foot.a * foot.a / (2.0 * j);
    if foot.v + b <= speed {
        return 1.0;
    }
    let mut pace = 1.0_f64;
    for _ in 0..30 {
        let cube = pace * pace * pace;
        let step = (pace * foot.v + pace * cube * b - speed) / (foot.v + 4.0 * cube * b);
        pace -= step;
        if step < 1e-9 * pace {
            break;
        }
    }
    pace.max(1e-6) * (1.0 - 1e-9)
}

pub(crate) fn norm(v: &[f64]) -> f64 {
    v.iter().map(|c| c * c).sum::<f64>().sqrt()
}
