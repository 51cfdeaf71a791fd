//! Speed over time along one cell: at most three phases of constant acceleration.
//!
//! Speed up (or slow down) to a cruising speed, cruise, slow down to the speed at the end. With `w = v²`
//! a phase of acceleration `a` over the distance `d` changes `w` by `2·a·d`, so everything up to the
//! durations is linear in `w`. Each phase is evaluated from its own start state; nothing is summed up
//! from period to period.

use crate::limits::Bound;

/// Constant acceleration for a time.
#[derive(Clone, Copy, Debug, Default)]
struct Phase {
    duration: f64,
    s: f64,
    v: f64,
    a: f64,
}

/// How a cell, or what is left of it, is run through.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Profile {
    phases: [Phase; 3],
    count: usize,
    current: usize,
    time: f64,
    /// Where the last phase ends, and the speed squared there.
    end: (f64, f64),
    /// Whether it leads to the end of the cell.
    is_whole: bool,
}

impl Profile {
    /// From `s` at speed squared `w0` over the length `len` to `w1`, no faster than speed squared `cap`
    /// where that can be had. `w1` is within reach.
    pub fn ramps(s: f64, w0: f64, len: f64, cap: f64, w1: f64, bound: &Bound) -> Profile {
        let mut profile = Profile { end: (s + len, w1), is_whole: true, ..Profile::default() };
        if w0 > cap {
            // The override was lowered: brake at once.
            let cruise = cap.max(w1).min(w0);
            profile.fill(s, len, [w0, cruise, w1], [bound.acceleration(w0), bound.acceleration(cruise)]);
        } else {
            // The peak x at which (x − w0)/2a(x) + (x − w1)/2a(x) fills the length.
            let peak = (2.0 * len * bound.a0 + w0 + w1) / (2.0 + 2.0 * len * bound.fade);
            let cruise = peak.min(cap).max(w0).max(w1);
            let a = bound.acceleration(cruise);
            profile.fill(s, len, [w0, cruise, w1], [a, a]);
        }
        profile
    }

    /// From `s` at speed squared `w0` to rest as soon as possible, at the end of `len` at the latest if
    /// `w1 = 0`; where it takes longer, on with speed squared `w1` at the end.
    pub fn stop(s: f64, w0: f64, len: f64, w1: f64, bound: &Bound) -> Profile {
        let a = bound.acceleration(w0);
        let need = if w0 == 0.0 { 0.0 } else { w0 / (2.0 * a) };
        let is_whole = need >= len;
        let (len, w1) = if is_whole { (len, w1) } else { (need, 0.0) };
        let mut profile = Profile { end: (s + len, w1), is_whole, ..Profile::default() };
        profile.fill(s, len, [w0, w0, w1], [a, a]);
        profile
    }

    fn fill(&mut self, s: f64, len: f64, [w0, cruise, w1]: [f64; 3], [a0, a1]: [f64; 2]) {
        let [v0, vc, v1] = [w0, cruise, w1].map(f64::sqrt);
        let ramp =
            |change: f64, a: f64| if change == 0.0 { 0.0 } else { (change.abs() / (2.0 * a)).min(len) };
        let first = ramp(cruise - w0, a0);
        let last = ramp(cruise - w1, a1).min(len - first);
        self.push(s, first, v0, vc);
        self.push(s + first, len - first - last, vc, vc);
        self.push(s + len - last, last, vc, v1);
    }

    /// A phase over the distance `d` between two speeds.
    fn push(&mut self, s: f64, d: f64, v0: f64, v1: f64) {
        if d > 0.0 && v0 + v1 > 0.0 {
            let duration = 2.0 * d / (v0 + v1);
            self.phases[self.count] = Phase { duration, s, v: v0, a: (v1 - v0) / duration };
            self.count += 1;
        }
    }

    /// Goes on by `time`. What is left of it when the profile ends, else `None`.
    pub fn advance(&mut self, time: f64) -> Option<f64> {
        self.time += time;
        while self.current < self.count {
            let duration = self.phases[self.current].duration;
            if self.time < duration {
                return None;
            }
            self.time -= duration;
            self.current += 1;
        }
        let left = self.time;
        self.time = 0.0;
        Some(left)
    }

    /// Position along the cell and speed now.
    pub fn state(&self) -> (f64, f64) {
        if self.current >= self.count {
            return (self.end.0, self.end.1.sqrt());
        }
        let Phase { s, v, a, .. } = self.phases[self.current];
        let t = self.time;
        ((s + (v + 0.5 * a * t) * t).min(self.end.0), (v + a * t).max(0.0))
    }

    /// Whether it was run to the end of the cell.
    pub fn has_arrived(&self) -> bool {
        self.is_whole && self.current >= self.count
    }

    /// Speed squared at the end.
    pub fn end_w(&self) -> f64 {
        self.end.1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LINE: Bound = Bound { w_max: 1e4, feed: 100.0, a0: 2000.0, fade: 0.0 };
    const CURVE: Bound = Bound { w_max: 1e4, feed: 100.0, a0: 2000.0, fade: 0.19 };

    /// Steps through the profile and checks what it promises.
    fn check(mut profile: Profile, w0: f64, end: f64, w1: f64, bound: &Bound) -> f64 {
        let step = 1e-5;
        let mut time = 0.0;
        let (mut s, mut v) = profile.state();
        assert!((v * v - w0).abs() < 1e-9);
        while profile.advance(step).is_none() {
            let (s1, v1) = profile.state();
            assert!((s1 - s - (v + v1) / 2.0 * step).abs() < 1e-7, "at {s} {v}, then {s1} {v1}");
            let a = (v1 - v).abs() / step;
            assert!(a <= bound.acceleration(v.min(v1).powi(2)) * (1.0 + 1e-9) + 1e-9);
            (s, v) = (s1, v1);
            time += step;
        }
        let (s, v) = profile.state();
        assert!((s - end).abs() < 1e-12 && (v * v - w1).abs() < 1e-9);
        time
    }

    #[test]
    fn a_line_from_rest_to_rest_is_a_trapezoid() {
        let time = check(Profile::ramps(0.0, 0.0, 100.0, 1e4, 0.0, &LINE), 0.0, 100.0, 0.0, &LINE);
        assert!((time - 1.05).abs() < 1e-4);
        // Too short for the speed: a triangle.
        let time = check(Profile::ramps(0.0, 0.0, 1.0, 1e4, 0.0, &LINE), 0.0, 1.0, 0.0, &LINE);
        assert!((time - 2.0 * (1.0f64 / 2000.0).sqrt()).abs() < 1e-4);
    }

    #[test]
    fn whatever_is_within_reach_is_reached_within_the_bound() {
        for bound in [LINE, CURVE] {
            for w0 in [0.0, 100.0, 5000.0, 1e4] {
                for len in [0.001, 0.1, 3.0, 50.0] {
                    for cap in [1.0, 4000.0, 1e4] {
                        for part in [0.0, 0.3, 1.0] {
                            let (low, high) = (bound.brake(w0, len), bound.reach(w0, len).min(cap));
                            let w1 = (low + (high - low) * part).max(low);
                            check(Profile::ramps(2.0, w0, len, cap, w1, &bound), w0, 2.0 + len, w1, &bound);
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn a_stop_ends_where_braking_ends() {
        let mut profile = Profile::stop(0.0, 1e4, 10.0, 0.0, &LINE);
        assert!(profile.advance(0.0499).is_none());
        assert!(profile.advance(0.0002).is_some());
        assert!(
            (profile.state().0 - 2.5).abs() < 1e-12 && profile.state().1 == 0.0 && !profile.has_arrived()
        );
        // Longer than the cell: goes on behind it.
        let profile = Profile::stop(0.0, 1e4, 1.0, 6000.0, &LINE);
        check(profile, 1e4, 1.0, 6000.0, &LINE);
    }

    #[test]
    fn braking_undoes_reaching() {
        for len in [0.01, 1.0, 20.0] {
            for w in [0.0, 10.0, 3000.0] {
                assert!((CURVE.brake(CURVE.reach(w, len), len) - w).abs() < 1e-8);
            }
        }
    }
}
