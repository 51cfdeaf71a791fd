//! One axis from any place, speed and acceleration to a speed or to rest at a place, in phases of constant jerk.
//!
//! # Change of speed
//!
//! With jerk `J` an acceleration `a` is brought to 0 in `|a|/J`; the speed is then `w = v + a·|a|/2J`. A wanted
//! speed `u ≥ w` is reached soonest with jerk `+J` up to an acceleration `p`, that held, and `−J` down to 0
//! (`u < w`: mirrored). The speeds of the phases add up to `u − v`:
//!
//! ```text
//! (p² − a²)/2J + p·hold + p²/2J = u − v       p = min(√(J·(u − v) + a²/2), A)
//! ```
//!
//! and `hold` is what is left over where `p` is the limit `A`. It is the time-optimal control of a double integrator
//! with bounded state (Pontryagin; Kröger, *On-Line Trajectory Generation in Robotic Systems*, 2010, ch. 4). With
//! `u = 0` it is the stop; the stopping distance `S(x)` of a state `x` is its way.
//!
//! # Rest at a place
//!
//! Where the stop from here ends short of the place `q`, the axis goes on towards the speed limit for a time `τ` and
//! stops then; where it ends beyond, the same backwards. `g(τ) = s(τ) + S(x(τ))` does not fall with `τ`: whoever
//! brakes later comes to rest no less far. So `g(τ) = q` has one solution, found between brackets, or is not reached
//! by the time of full speed; then the rest is run at full speed. Jerk is thus `+ 0 −  0 − 0 +`: from rest to rest
//! this is the optimal profile with seven phases (Biagiotti and Melchiorri, *Trajectory Planning for Automatic
//! Machines and Robots*, 3.4), from other states that of Berscheid and Kröger (*Jerk-limited Real-time Trajectory
//! Generation with Arbitrary Target States*, RSS 2021) with target at rest, without their profiles for a start
//! above the speed limit.
//!
//! # Limits
//!
//! Neither brings speed or acceleration over a limit that they did not already go to: where a course brakes
//! towards a limit with full jerk, `w` (above) is within it, stays so while the jerk has that sign, and every other
//! course begun there goes to the greater of `w` and its own wanted speed.

/// Limits, in units of the axis per s, s², s³.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Bounds {
    pub acceleration: f64,
    pub jerk: f64,
}

/// Place, speed and acceleration at a moment.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub(super) struct At {
    pub s: f64,
    pub v: f64,
    pub a: f64,
}

impl At {
    /// After a time with jerk `j`.
    #[inline]
    fn after(self, t: f64, j: f64) -> At {
        let At { s, v, a } = self;
        At { s: s + t * (v + t * (a / 2.0 + t * j / 6.0)), v: v + t * (a + t * j / 2.0), a: a + t * j }
    }
}

/// Distance, mm or degrees, below which two places are the same here: far below what a drive resolves, far above the
/// rounding of the sums behind it, and too little to be seen in the third difference of a 0.25 ms period.
pub(super) const NEAR: f64 = 1e-11;

/// Most evaluations in search of the moment to brake. Every second one halves the bracket.
const MOST_TRIALS: usize = 48;

/// Jerk and duration of the three phases of a change of speed.
type Change = [(f64, f64); 3];

/// The soonest change from a state to the speed `u` without acceleration.
#[inline]
fn change(from: At, u: f64, bounds: &Bounds) -> Change {
    let Bounds { acceleration, jerk: j } = *bounds;
    let level = from.v + from.a * from.a.abs() / (2.0 * j);
    let sign = if u >= level { 1.0 } else { -1.0 };
    let (a, dv) = (sign * from.a, sign * (u - from.v));
    let most = acceleration.max(a);
    let free = (j * dv + a * a / 2.0).max(0.0).sqrt().max(a);
    let (peak, hold) = match free <= most {
        true => (free, 0.0),
        false => (most, ((dv - (2.0 * most * most - a * a) / (2.0 * j)) / most).max(0.0)),
    };
    [(sign * j, (peak - a) / j), (0.0, hold), (-sign * j, peak / j)]
}

/// The state after `time` of a change.
#[inline]
fn run(mut at: At, change: &Change, time: f64) -> At {
    let mut left = time;
    for (j, duration) in change {
        at = at.after(left.min(*duration), *j);
        left -= duration;
        if left <= 0.0 {
            break;
        }
    }
    at
}

fn duration(change: &Change) -> f64 {
    change.iter().map(|(_, time)| time).sum()
}

/// Where the axis is at rest if it stops now.
pub(super) fn rest(from: At, bounds: &Bounds) -> f64 {
    run(from, &change(from, 0.0, bounds), f64::INFINITY).s
}

#[derive(Clone, Copy, Debug, Default)]
struct Phase {
    from: At,
    jerk: f64,
    time: f64,
}

/// A motion in phases from a state at place 0. Every phase is evaluated from its own start, and the end is what was
/// asked for: nothing is summed up.
#[derive(Clone, Copy, Debug)]
pub(super) struct Course {
    phases: [Phase; 7],
    count: usize,
    /// How long it takes, s; infinite where it does not end.
    pub time: f64,
    /// Where it ends; without meaning where it does not.
    pub end: f64,
}

impl Course {
    /// Stands still.
    pub const REST: Course = Course {
        phases: [Phase { from: At { s: 0.0, v: 0.0, a: 0.0 }, jerk: 0.0, time: 0.0 }; 7],
        count: 0,
        time: 0.0,
        end: 0.0,
    };

    /// To rest as soon as possible, from speed `v` and acceleration `a`.
    pub fn stop(v: f64, a: f64, bounds: &Bounds) -> Course {
        let mut course = Course::REST;
        let from = At { s: 0.0, v, a };
        course.end = course.push(from, &change(from, 0.0, bounds)).s;
        course
    }

    /// To rest at `way` from here, which may be infinite, from speed `v` and acceleration `a`, no faster than
    /// `speed` (which a start above is brought down to).
    pub fn to(way: f64, v: f64, a: f64, speed: f64, bounds: &Bounds) -> Course {
        let from = At { s: 0.0, v, a };
        let short = way - rest(from, bounds);
        if short.abs() <= NEAR || speed <= 0.0 {
            let stop = Course::stop(v, a, bounds);
            return if speed <= 0.0 { stop } else { Course { end: way, ..stop } };
        }
        let sign = short.signum();
        let go = change(from, sign * speed, bounds);
        // How far beyond the place the axis comes to rest that brakes at this moment.
        let beyond = |time: f64| {
            let at = run(from, &go, time);
            (sign * (rest(at, bounds) - way), at)
        };
        let total = duration(&go);
        let (miss, _) = beyond(total);
        let mut course = Course { end: way, ..Course::REST };
        if miss <= 0.0 {
            let at = course.push(from, &go);
            let at = course.push_phase(at, 0.0, -miss / speed);
            if course.time.is_finite() {
                course.push(at, &change(at, 0.0, bounds));
            }
            return course;
        }
        let time = search([0.0, total], [-short.abs(), miss], |time| beyond(time).0);
        let mut at = from;
        let mut left = time;
        for (jerk, duration) in go {
            at = course.push_phase(at, jerk, duration.min(left));
            left = (left - duration).max(0.0);
        }
        course.push(at, &change(at, 0.0, bounds));
        course
    }

    fn push(&mut self, from: At, change: &Change) -> At {
        change.iter().fold(from, |at, (jerk, time)| self.push_phase(at, *jerk, *time))
    }

    fn push_phase(&mut self, from: At, jerk: f64, time: f64) -> At {
        if time > 0.0
            && let Some(place) = self.phases.get_mut(self.count)
        {
            *place = Phase { from, jerk, time };
            self.count += 1;
            self.time += time;
        }
        if time > 0.0 && time.is_finite() { from.after(time, jerk) } else { from }
    }

    /// The state `time` after the begin; at and behind the end, rest there.
    #[inline]
    pub fn at(&self, time: f64) -> At {
        let mut left = time;
        for phase in self.phases.iter().take(self.count) {
            if left < phase.time {
                return phase.from.after(left.max(0.0), phase.jerk);
            }
            left -= phase.time;
        }
        At { s: self.end, v: 0.0, a: 0.0 }
    }

    /// Least and greatest place that it comes to.
    pub fn extent(&self) -> (f64, f64) {
        let mut extent = (0.0_f64, 0.0_f64);
        let mut take = |s: f64| extent = (extent.0.min(s), extent.1.max(s));
        if self.count > 0 {
            take(if self.time.is_finite() { self.end } else { f64::INFINITY.copysign(self.end) });
        }
        for Phase { from, jerk, time } in self.phases.iter().take(self.count) {
            take(from.s);
            // Where the speed is 0: v + a·t + j·t²/2 = 0, in the form that subtracts nothing alike.
            let root = from.a * from.a - 2.0 * jerk * from.v;
            if root < 0.0 {
                continue;
            }
            let q = -(from.a + root.sqrt().copysign(from.a));
            for t in [q / jerk, 2.0 * from.v / q] {
                if t > 0.0 && t < *time {
                    take(from.after(t, *jerk).s);
                }
            }
        }
        extent
    }
}

/// The argument at which a function that does not fall becomes 0, between two at which it is below and above:
/// false position (Illinois) and halving in turns.
fn search(bracket: [f64; 2], values: [f64; 2], f: impl Fn(f64) -> f64) -> f64 {
    let ([mut low, mut high], [mut below, mut above]) = (bracket, values);
    let mut last = 0;
    for trial in 0..MOST_TRIALS {
        let t = match trial % 2 {
            0 => low + (high - low) * (below / (below - above)),
            _ => low + (high - low) / 2.0,
        };
        if t <= low || t >= high {
            break;
        }
        let value = f(t);
        if value.abs() <= NEAR / 10.0 {
            return t;
        }
        if value < 0.0 {
            (low, below) = (t, value);
            if last == -1 {
                above /= 2.0;
            }
            last = -1;
        } else {
            (high, above) = (t, value);
            if last == 1 {
                below /= 2.0;
            }
            last = 1;
        }
    }
    // Rather short of the place than beyond.
    low
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOUNDS: Bounds = Bounds { acceleration: 50.0, jerk: 1000.0 };

    #[test]
    fn changes_of_speed_worked_out_by_hand() {
        // 10 mm/s: 10/50 + 50/1000 = 0.25 s, at 5 mm/s in the mean.
        let stop = Course::stop(10.0, 0.0, &BOUNDS);
        assert!((stop.time - 0.25).abs() < 1e-12 && (stop.end - 1.25).abs() < 1e-12, "{stop:?}");
        // 0.9 mm/s: 2·√(0.9/1000) = 0.06 s.
        let stop = Course::stop(-0.9, 0.0, &BOUNDS);
        assert!((stop.time - 0.06).abs() < 1e-12 && (stop.end + 0.027).abs() < 1e-12, "{stop:?}");
        // Standing, about to move: 20/1000 s to no acceleration at 0.2 mm/s, then 2·√(0.2/1000) less the shared
        // part; p = √(0 + 20²/2) = 14.14, so 0.034142 + 0.014142 s.
        let stop = Course::stop(0.0, 20.0, &BOUNDS);
        assert!((stop.time - (20.0 + 2.0 * 200.0_f64.sqrt()) / 1000.0).abs() < 1e-12, "{stop:?}");
    }

    #[test]
    fn ways_worked_out_by_hand() {
        // 10 mm at 10 mm/s: 2 · 0.25 s of change over 2.5 mm, 0.75 s through.
        let course = Course::to(10.0, 0.0, 0.0, 10.0, &BOUNDS);
        assert!((course.time - 1.25).abs() < 1e-12 && course.end == 10.0);
        // 0.054 mm: peak 0.9 mm/s, twice 0.06 s.
        let course = Course::to(-0.054, 0.0, 0.0, 10.0, &BOUNDS);
        assert!((course.time - 0.12).abs() < 1e-9 && course.end == -0.054, "{course:?}");
        assert_eq!(course.extent(), (-0.054, 0.0));
        // Too fast to stop in 1 mm: it brakes through standstill. 0.05 s to full braking, 10 · 0.05 − 0.125/6 mm at
        // 8.75 mm/s in the end, and 8.75²/(2 · 50) mm more.
        let (low, high) = Course::to(1.0, 10.0, 0.0, 10.0, &BOUNDS).extent();
        let turn = 0.5 - 0.125 / 6.0 + 8.75 * 8.75 / 100.0;
        assert!(low == 0.0 && (high - turn).abs() < 1e-9, "{high}");
    }

    #[test]
    fn phases_lead_to_the_place_from_any_state() {
        // A grid of states and ways, among them those that are already too near, too fast or turning.
        for jerk in [100.0, 1000.0, 5e7] {
            let bounds = Bounds { jerk, ..BOUNDS };
            for k in 0..40_000_u32 {
                let part = |n: u32| f64::from(k / n % 20) / 9.5 - 1.0;
                let (v, a) = (part(1) * 10.0, part(20) * 50.0);
                let way = part(400).powi(3) * 20.0;
                let course = Course::to(way, v, a, 2.0 + f64::from(k % 9), &bounds);
                let last = course.phases[..course.count].last().unwrap();
                let end = last.from.after(last.time, last.jerk);
                let miss = (end.s - way).abs().max(end.v.abs() / 100.0).max(end.a.abs() / 1e4);
                assert!(miss < 1e-10, "{way} from {v} {a}: {end:?}");
            }
        }
    }
}
