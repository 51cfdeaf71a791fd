//! How fast a smoothed run will be about, before it is planned.
//!
//! What matters is where it is slow and how quickly it gets faster from there on; the speed there itself matters little.
//!
//! 1. **Limit** of every span: its third derivative by the jerk, its second by the acceleration, the feed.
//! 2. **Ramps** up to it from both sides: from rest at the jerk `J`, `s = J·t³/6`, so `v' = dv/ds = √(2J/v)`; and
//!    `v' ≤ A/v`.
//! 3. **Mean** over the way `√(v³/J)` on either side, in which the speed changes by as much as it is. Braking goes on
//!    into a turn and speeding up begins inside it, so the speed has its lowest in the middle of the turn, and not
//!    where the third derivative is largest, which is at its ends.

use crate::limits::Drive;
use crate::quick::{cube_root, larger, smaller};

/// Share of the jerk that is left to a ramp beside what a curve takes.
const RAMP_SHARE: f64 = 0.5;

/// Ramps begin with no less than this, mm/s.
const LEAST: f64 = 1.0;

/// Below this share of the speed aside from curves a span is slow.
const SLOW: f64 = 0.85;

/// A span of a run.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stretch {
    /// mm.
    pub len: f64,
    /// Highest speed aside from curves, then also by them, mm/s.
    pub top: f64,
    /// What the axes leave along it.
    pub drive: Drive,
    /// How far a wave is smoothed away at the speed 1, mm.
    pub away: f64,
    /// The speed found, mm/s.
    pub v: f64,
    /// Whether it is slower than aside from curves.
    pub is_slow: bool,
}

impl Stretch {
    /// One that holds nothing back.
    pub fn free(len: f64, top: f64) -> Stretch {
        let drive = Drive { a: f64::INFINITY, j: f64::INFINITY };
        Stretch { len, top, drive, away: 0.0, v: top, is_slow: false }
    }

    /// One on which the axes leave so much, and the path may be left by so much.
    pub fn new(len: f64, top: f64, drive: Drive, tolerance: f64) -> Stretch {
        Stretch { drive, away: reach(1.0, tolerance, drive.j), ..Stretch::free(len, top) }
    }

    /// `jerk` and `acceleration` are those of an axis at the speed 1, as shares of their bounds.
    pub fn limit(&mut self, jerk: f64, acceleration: f64) {
        self.v = self.top;
        let cube = self.v * self.v * self.v;
        if jerk * cube > 1.0 {
            self.v = cube_root(jerk).recip();
        }
        if acceleration * self.v * self.v > 1.0 {
            self.v = acceleration.sqrt().recip();
        }
    }

    /// The speed behind it, if it is `v` before it.
    fn behind(&self, v: f64) -> f64 {
        let inverse = v.recip();
        let by_jerk = (2.0 * RAMP_SHARE * self.drive.j * inverse).sqrt();
        v + self.len * smaller(by_jerk, self.drive.a * inverse)
    }

    /// Makes the next one no faster than it can be behind this one.
    fn hold_back(&self, next: &mut Stretch) {
        if next.v > self.v {
            next.v = smaller(next.v, self.behind(self.v));
        }
    }
}

/// How far a wave is smoothed away at the speed `v`: `v·(δ/J)^⅓`, mm.
pub(crate) fn reach(v: f64, tolerance: f64, jerk: f64) -> f64 {
    v * cube_root(tolerance / jerk)
}

/// The speeds of a run.
#[derive(Debug, Default)]
pub(crate) struct Pace {
    pub stretches: Vec<Stretch>,
    /// Those before knots were put in.
    old: Vec<Stretch>,
    /// Highest speeds at both ends, mm/s.
    pub ends: [f64; 2],
    /// How far from both ends nothing has to bend, mm: what does is no reason to be slow there.
    pub straight: [f64; 2],
    /// Length and `∫v·ds` up to every span.
    sums: Vec<[f64; 2]>,
    /// Speeds of the parts of spans.
    parts: Vec<f64>,
}

impl Pace {
    /// For so many spans.
    pub fn new(spans: usize) -> Pace {
        Pace {
            ends: [f64::INFINITY; 2],
            straight: [0.0; 2],
            stretches: Vec::with_capacity(spans),
            old: Vec::with_capacity(spans),
            sums: Vec::with_capacity(spans + 1),
            parts: Vec::with_capacity(spans),
        }
    }

    /// Whether a span is slow.
    pub fn is_slow(&self) -> bool {
        self.stretches.iter().any(|stretch| stretch.is_slow)
    }

    /// Begins with no spans; those there are now may be taken over.
    pub fn keep_stretches(&mut self) {
        std::mem::swap(&mut self.stretches, &mut self.old);
        self.stretches.clear();
    }

    /// The next span is the old span `k`.
    pub fn take_over(&mut self, k: usize) {
        self.stretches.extend(self.old.get(k));
    }

    pub fn begin_split(&mut self) {
        self.parts.clear();
    }

    /// Notes the speeds of the parts of span `k`.
    pub fn split(&mut self, k: usize, parts: usize) {
        let own = &self.stretches[k];
        for part in 0..parts {
            // From the middle of the span.
            let off = (part as f64 + 0.5) / parts as f64 - 0.5;
            let beside = if off < 0.0 { k.checked_sub(1) } else { Some(k + 1) };
            let beside = beside.and_then(|k| self.stretches.get(k)).unwrap_or(own);
            let share = off.abs() * own.len / (0.5 * (own.len + beside.len));
            self.parts.push(own.v + share * (beside.v - own.v));
        }
    }

    /// The spans are now the parts of those before.
    pub fn take_parts(&mut self) {
        for (stretch, v) in self.stretches.iter_mut().zip(&self.parts) {
            stretch.v = *v;
        }
    }

    /// How far a wave is smoothed away on span `k`, mm.
    pub fn reach(&self, k: usize) -> f64 {
        let stretch = &self.stretches[k];
        stretch.v * stretch.away
    }

    /// The same, were nothing slow.
    pub fn most_reach(&self, k: usize) -> f64 {
        let stretch = &self.stretches[k];
        stretch.top * stretch.away
    }

    /// Finds the speeds from the limits in `v` and those at both ends.
    pub fn find(&mut self) {
        let stretches = &mut self.stretches;
        let count = stretches.len();
        for (end, k) in [(0, 0), (1, count.saturating_sub(1))] {
            if let Some(stretch) = stretches.get_mut(k) {
                stretch.v = stretch.v.min(self.ends[end].max(LEAST));
            }
            for i in 1..count {
                let (before, next) = if end == 0 { (i - 1, i) } else { (count - i, count - 1 - i) };
                let before = stretches[before];
                before.hold_back(&mut stretches[next]);
            }
        }
        let (mut s, mut sum) = (0.0, 0.0);
        self.sums.clear();
        self.sums.push([s, sum]);
        for stretch in stretches.iter() {
            (s, sum) = (s + stretch.len, sum + stretch.len * stretch.v);
            self.sums.push([s, sum]);
        }
        let (mut low, mut high) = (0, 0);
        for k in 0..self.stretches.len() {
            let Stretch { v, drive, len, top, .. } = self.stretches[k];
            let way = larger((v * v * v / drive.j).sqrt(), 0.5 * len);
            let middle = self.sums[k][0] + 0.5 * len;
            let [a, b] = [self.sum_at(middle - way, &mut low), self.sum_at(middle + way, &mut high)];
            let mean = (b[1] - a[1]) / larger(1e-12, b[0] - a[0]);
            let stretch = &mut self.stretches[k];
            (stretch.v, stretch.is_slow) = (mean, mean < SLOW * top);
        }
    }

    /// Length and `∫v·ds` up to the length `s` or the end that is nearest to it; `at` is the span where it is looked for.
    fn sum_at(&self, s: f64, at: &mut usize) -> [f64; 2] {
        while *at > 0 && self.sums[*at][0] > s {
            *at -= 1;
        }
        while *at + 2 < self.sums.len() && self.sums[*at + 1][0] < s {
            *at += 1;
        }
        let ([s0, sum0], [s1, sum1]) = (self.sums[*at], self.sums[*at + 1]);
        let share = ((s - s0) / larger(1e-12, s1 - s0)).clamp(0.0, 1.0);
        [s0 + share * (s1 - s0), sum0 + share * (sum1 - sum0)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_slowest_in_the_middle_of_a_turn() {
        let drive = Drive { a: 3000.0, j: 60_000.0 };
        let mut pace = Pace::new(200);
        pace.ends = [f64::INFINITY; 2];
        for k in 0..200 {
            let mut stretch = Stretch { drive, ..Stretch::free(0.1, 150.0) };
            // A half circle of 0.8 mm that the jerk allows 15 mm/s in.
            if (96..104).contains(&k) {
                stretch.limit(15.0_f64.powi(-3), 0.0);
            }
            pace.stretches.push(stretch);
        }
        pace.find();
        let v: Vec<f64> = pace.stretches.iter().map(|stretch| stretch.v).collect();
        for k in 0..100 {
            assert!((v[k] - v[199 - k]).abs() < 1e-6, "{k}");
            assert!(k < 60 || v[k] > v[k + 1] - 1e-9, "{k}: {} {}", v[k], v[k + 1]);
        }
        assert!(v[99] < 16.0 && v[96] > v[99] + 1.0 && v[0] > 100.0, "{v:?}");
        assert!(pace.is_slow() && pace.stretches[99].is_slow);
    }
}
