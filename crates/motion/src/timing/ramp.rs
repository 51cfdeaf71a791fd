//! From one speed to another in the shortest time: a ramp.
//!
//! Between two speeds at which the path is not accelerated, `v₀ < v₁`, with acceleration up to `A` and jerk up
//! to `J`, the shortest ramp builds the acceleration up with `J`, holds it if it reaches `A`, and takes it back
//! with `J`. It is symmetric in time, so it covers the mean speed times its duration (Δ = v₁ − v₀):
//!
//! ```text
//! T = Δ/A + A/J   if Δ ≥ A²/J          D = (v₀ + v₁)/2 · T
//!     2·√(Δ/J)    else
//! ```
//!
//! A ramp may also begin under way, with an acceleration `a₀` towards the higher speed (behind a rounded
//! corner, see [`crate::path::corner`]). Then it is the rest of the ramp that began at `v* = v₀ − a₀²/2J`, `a₀/J`
//! seconds earlier; `v*` may be negative, the formulas hold. Slowing down is the mirror image, so all here is
//! said for speeding up.

use crate::limits::Drive;
use crate::quick::{cube_root, larger, smaller};

/// A ramp down to a third of a speed takes up to 1.089 times the length of the ramp down to rest. Lines beside
/// corners are this much longer than stopping takes, so that any speed can be reached on them.
pub(crate) const STOP_ROOM: f64 = 1.1;

/// A state from which a ramp goes up (or, mirrored, at which it arrives coming down): speed and the
/// acceleration away from it, both ≥ 0.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub(crate) struct Foot {
    /// mm/s.
    pub v: f64,
    /// mm/s².
    pub a: f64,
}

impl Foot {
    pub fn still(v: f64) -> Foot {
        Foot { v, a: 0.0 }
    }

    /// Lowest speed at which the acceleration can be gone.
    pub fn top(&self, j: f64) -> f64 {
        self.v + self.a * self.a / (2.0 * j)
    }

    /// The way in which the acceleration is taken back and the path then stopped, mm.
    pub fn room(&self, drive: Drive) -> f64 {
        self.room_to(0.0, drive)
    }

    /// The same where it is only slowed down to `v`.
    pub fn room_to(&self, v: f64, drive: Drive) -> f64 {
        let top = self.top(drive.j);
        let rising = Drive { a: drive.a.max(self.a), ..drive };
        self.distance(top, rising).unwrap_or(f64::INFINITY) + distance(v.min(top), top, drive)
    }

    /// Where the ramp without a head start would have begun: speed, and the length and time from there.
    fn head(&self, j: f64) -> (f64, f64, f64) {
        let t = self.a / j;
        let v = self.v - 0.5 * self.a * t;
        (v, t * (v + j * t * t / 6.0), t)
    }

    /// The speed that a ramp reaches in the way `len`, where that is no less than the acceleration needs to be gone.
    ///
    /// With `x² = v − v*` and `s*` the way since `v*` it is `x³ + 2v*·x = √J·(len + s*)` without a steady part, else with
    /// `c = v − v*` `c²/A + c·(2v*/A + A/J) + 2v*·A/J = 2·(len + s*)`.
    pub fn reached(&self, len: f64, drive: Drive) -> f64 {
        let Drive { a, j } = drive;
        let (low, gone, _) = self.head(j);
        let way = len + gone;
        let right = j.sqrt() * way;
        // Newton from above: behind its largest root the cubic is convex and rises.
        let mut x = right.cbrt() + (-2.0 * low).max(0.0).sqrt();
        for _ in 0..20 {
            let step = (x * (x * x + 2.0 * low) - right) / (3.0 * x * x + 2.0 * low);
            x -= step;
            if !(step > 1e-9 * x) {
                break;
            }
        }
        if x * x * j <= a * a {
            return low + x * x;
        }
        let b = 2.0 * low / a + a / j;
        let c = 0.5 * a * ((b * b + 8.0 / a * (way - low * a / j)).max(0.0).sqrt() - b);
        low + c
    }

    /// Length of the way up to `v`, mm; `None` where it cannot be reached with this drive.
    #[inline]
    pub fn distance(&self, v: f64, drive: Drive) -> Option<f64> {
        if self.a == 0.0 {
            return Some(distance(self.v, v, drive));
        }
        if self.a > drive.a || v < self.top(drive.j) {
            return None;
        }
        let (v0, s0, _) = self.head(drive.j);
        Some((distance(v0, v, drive) - s0).max(0.0))
    }
}

/// Duration of the ramp, s.
#[inline]
pub(crate) fn duration(low: f64, high: f64, drive: Drive) -> f64 {
    let change = high - low;
    if change <= 0.0 {
        0.0
    } else if change * drive.j >= drive.a * drive.a {
        change / drive.a + drive.a / drive.j
    } else {
        2.0 * (change / drive.j).sqrt()
    }
}

/// Length of the ramp, mm.
#[inline]
pub(crate) fn distance(low: f64, high: f64, drive: Drive) -> f64 {
    0.5 * (low + high) * duration(low, high, drive)
}

/// A speed that a ramp from `foot` does not pass within `len`.
#[inline]
pub(crate) fn most_speed(foot: Foot, len: f64, drive: Drive) -> f64 {
    let by_acceleration = (foot.v * foot.v + 2.0 * drive.a * len).sqrt();
    if foot.a > 0.0 {
        return by_acceleration;
    }
    let steady = if foot.v > 0.0 { len / foot.v } else { f64::INFINITY };
    let t =
        if steady * steady * steady * drive.j <= 6.0 * len { steady } else { cube_root(6.0 * len / drive.j) };
    smaller(by_acceleration, foot.v + 0.5 * drive.j * t * t)
}

/// From this length on [`most_speed`] from `foot`, a still one, is no less than `v`.
pub(crate) fn way_up(foot: Foot, v: f64, drive: Drive) -> f64 {
    if v <= foot.v {
        return 0.0;
    }
    let t = (2.0 * (v - foot.v) / drive.j).sqrt();
    let by_acceleration = (v * v - foot.v * foot.v) / (2.0 * drive.a);
    larger(larger(by_acceleration, foot.v * t), drive.j * t * t * t / 6.0)
}

/// Phases of constant jerk of a ramp: durations of building up, holding and taking back.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub(crate) struct Phases {
    pub times: [f64; 3],
    pub j: f64,
}

impl Phases {
    /// The ramp from `foot` up to `v`.
    pub fn new(foot: Foot, v: f64, drive: Drive) -> Phases {
        let Drive { a, j } = drive;
        let (low, _, gone) = foot.head(j);
        let change = (v - low).max(0.0);
        if change * j >= a * a {
            Phases { times: [(a / j - gone).max(0.0), change / a - a / j, a / j], j }
        } else {
            let t = (change / j).sqrt();
            Phases { times: [(t - gone).max(0.0), 0.0, t], j }
        }
    }

    /// Duration, s.
    pub fn total(&self) -> f64 {
        self.times[0] + self.times[1] + self.times[2]
    }

    /// Way, speed and acceleration `t` seconds behind `foot`.
    pub fn at(&self, foot: Foot, t: f64) -> (f64, f64, f64) {
        let (mut s, mut v, mut a) = (0.0, foot.v, foot.a);
        let mut left = t;
        for (duration, j) in self.times.into_iter().zip([self.j, 0.0, -self.j]) {
            let t = left.min(duration);
            s += t * (v + t * (a / 2.0 + t * j / 6.0));
            v += t * (a + t * j / 2.0);
            a += t * j;
            left -= t;
            if left <= 0.0 {
                break;
            }
        }
        (s, v.max(0.0), a)
    }
}

/// Highest speed at which a ramp up from one state and a ramp down to another meet within `len`, between
/// `low` and `high`; `None` where even `low` does not fit.
pub(crate) fn summit(from: Foot, to: Foot, len: f64, low: f64, high: f64, drive: Drive) -> Option<f64> {
    let way = |v: f64| Some(from.distance(v, drive)? + to.distance(v, drive)?);
    if way(low)? > len {
        return None;
    }
    if way(high).is_some_and(|w| w <= len) {
        return Some(high);
    }
    let (mut low, mut high) = (low, high);
    for _ in 0..60 {
        let v = 0.5 * (low + high);
        if way(v).is_some_and(|w| w <= len) {
            low = v;
        } else {
            high = v;
        }
        if high - low <= 1e-9 * high {
            break;
        }
    }
    Some(low)
}

#[cfg(test)]
mod tests {
    use super::*;

    const DRIVE: Drive = Drive { a: 2000.0, j: 50_000.0 };

    #[test]
    fn a_ramp_takes_the_time_worked_out_by_hand() {
        // 0 to 100 mm/s: A²/J = 80; 100/2000 + 2000/50000 = 90 ms.
        assert!((duration(0.0, 100.0, DRIVE) - 0.09).abs() < 1e-12);
        assert!((distance(0.0, 100.0, DRIVE) - 4.5).abs() < 1e-12);
        // 0 to 20 mm/s: 2·√(20/50000) = 40 ms.
        assert!((duration(0.0, 20.0, DRIVE) - 0.04).abs() < 1e-12);
    }

    #[test]
    fn what_is_reached_in_a_way_takes_that_way() {
        for foot in
            [Foot::still(0.0), Foot::still(30.0), Foot { v: 18.0, a: 1500.0 }, Foot { v: 5.0, a: 1900.0 }]
        {
            for v in [60.0, 90.0, 200.0] {
                let way = foot.distance(v, DRIVE).unwrap();
                assert!((foot.reached(way, DRIVE) - v).abs() < 1e-6 * v, "{foot:?} {v}");
            }
        }
    }

    #[test]
    fn phases_end_where_the_formulas_say() {
        for foot in
            [Foot::still(0.0), Foot::still(30.0), Foot { v: 18.0, a: 1500.0 }, Foot { v: 5.0, a: 2000.0 }]
        {
            for v in [60.0, 90.0, 200.0] {
                let phases = Phases::new(foot, v, DRIVE);
                let (s, end, a) = phases.at(foot, phases.total());
                assert!((end - v).abs() < 1e-9 && a.abs() < 1e-7, "{foot:?} {v}: {end} {a}");
                assert!((s - foot.distance(v, DRIVE).unwrap()).abs() < 1e-9);
            }
        }
    }
}
