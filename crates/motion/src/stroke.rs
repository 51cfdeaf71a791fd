//! From rest to rest, and from any state to rest, in the shortest time that speed, acceleration and jerk allow:
//! one quantity, in phases of constant jerk.
//!
//! A change of speed from 0 to `v` takes `v/a + a/j`, or `2·√(v/j)` where `a` is not reached, at half of `v` in the
//! mean. So a way too short for the speed limit is run at the `v` at which both changes fill it: `v·(v/a + a/j) = s`,
//! a quadratic, or `2·v·√(v/j) = s`.
//!
//! Every phase is evaluated from its own start, and the end is what was asked for: nothing is summed up.

/// Limits, in units of the quantity per s, s², s³. Infinite jerk is none.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct RampLimits {
    /// Highest speed.
    pub velocity: f64,
    /// Highest acceleration.
    pub acceleration: f64,
    /// Highest jerk.
    pub jerk: f64,
}

/// Place, speed and acceleration at a moment.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub(crate) struct At {
    /// How far it has come.
    pub s: f64,
    /// Speed.
    pub v: f64,
    /// Acceleration.
    pub a: f64,
}

/// Constant jerk for a time.
#[derive(Clone, Copy, Debug, Default)]
struct Phase {
    time: f64,
    from: At,
    j: f64,
}

/// A motion in phases.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Stroke {
    phases: [Phase; 7],
    count: usize,
    end: f64,
    time: f64,
}

impl Phase {
    fn at(&self, t: f64) -> At {
        let At { s, v, a } = self.from;
        At {
            s: s + t * (v + t * (a / 2.0 + t * self.j / 6.0)),
            v: v + t * (a + t * self.j / 2.0),
            a: a + t * self.j,
        }
    }
}

impl Stroke {
    /// From rest at 0 to rest at `way`, which is not negative.
    pub fn rest_to_rest(way: f64, limits: &RampLimits) -> Stroke {
        let RampLimits { velocity, acceleration: a, jerk: j } = *limits;
        let has_jerk = j.is_finite();
        // The highest speed that is reached without constant acceleration.
        let knee = if has_jerk { a * a / j } else { 0.0 };
        let long = a / 2.0 * ((knee / a).powi(2) + 4.0 * way / a).sqrt() - knee / 2.0;
        let peak = if long >= knee { long } else { (way * way * j / 4.0).cbrt() };
        let v = peak.min(velocity);
        let (build, hold) = match (has_jerk, v >= knee) {
            (false, _) => (0.0, v / a),
            (true, true) => (a / j, (v - knee) / a),
            (true, false) => ((v / j).sqrt(), 0.0),
        };
        let ramp = v / 2.0 * (2.0 * build + hold);
        let cruise = if v > 0.0 { ((way - 2.0 * ramp) / v).max(0.0) } else { 0.0 };
        let mut stroke = Stroke { end: way, ..Stroke::default() };
        let mut at = At::default();
        let top = if has_jerk { j * build } else { a };
        let steps = [
            (build, 0.0, j),
            (hold, top, 0.0),
            (build, top, -j),
            (cruise, 0.0, 0.0),
            (build, 0.0, -j),
            (hold, -top, 0.0),
            (build, -top, j),
        ];
        for (time, a, j) in steps {
            at = stroke.push(time, At { a, ..at }, j);
        }
        stroke.time = stroke.phases.iter().map(|p| p.time).sum();
        stroke
    }

    /// From a state with `v ≥ 0` to rest as soon as possible, at `farthest` at the latest.
    pub fn stop(from: At, farthest: f64, limits: &RampLimits) -> Stroke {
        let RampLimits { acceleration: most, jerk: j, .. } = *limits;
        let mut stroke = Stroke::default();
        let v = from.v.max(0.0);
        if j.is_finite() {
            // Down to −p, held, back to 0: p²/j + p·hold = v + a²/2j.
            let lost = v + from.a * from.a / (2.0 * j);
            let p = (lost * j).sqrt().min(most).max(-from.a);
            let hold = if p > 0.0 { ((lost - p * p / j) / p).max(0.0) } else { 0.0 };
            let at = stroke.push((p + from.a).max(0.0) / j, At { v, ..from }, -j);
            let at = stroke.push(hold, At { a: -p, ..at }, 0.0);
            stroke.push(p / j, At { a: -p, ..at }, j);
        } else {
            stroke.push(v / most, At { v, a: -most, ..from }, 0.0);
        }
        stroke.time = stroke.phases.iter().map(|p| p.time).sum();
        let last = stroke.count.checked_sub(1).and_then(|i| stroke.phases.get(i));
        stroke.end = last.map_or(from.s, |phase| phase.at(phase.time).s).min(farthest);
        stroke
    }

    fn push(&mut self, time: f64, from: At, j: f64) -> At {
        let phase = Phase { time, from, j: if time > 0.0 && j.is_finite() { j } else { 0.0 } };
        if time > 0.0
            && let Some(place) = self.phases.get_mut(self.count)
        {
            *place = phase;
            self.count += 1;
        }
        phase.at(time)
    }

    /// The state `time` after the begin; at and behind the end, rest there.
    pub fn at(&self, time: f64) -> At {
        let mut left = time;
        for phase in self.phases.iter().take(self.count) {
            if left < phase.time {
                let at = phase.at(left.max(0.0));
                return At { s: at.s.min(self.end), v: at.v.max(0.0), a: at.a };
            }
            left -= phase.time;
        }
        At { s: self.end, v: 0.0, a: 0.0 }
    }

    /// How long it takes, s.
    pub fn duration(&self) -> f64 {
        self.time
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LIMITS: RampLimits = RampLimits { velocity: 10.0, acceleration: 50.0, jerk: 1000.0 };

    /// Goes through the motion in small steps: continuous, within the limits, exact at its end.
    fn check(stroke: &Stroke, from: At, limits: &RampLimits) -> At {
        let n = 20_000;
        let dt = stroke.duration() / f64::from(n);
        let mut before = from;
        for k in 1..=n {
            let at = stroke.at(f64::from(k) * dt);
            assert!(
                at.v <= limits.velocity * (1.0 + 1e-9) && at.a.abs() <= limits.acceleration * (1.0 + 1e-9)
            );
            assert!((at.s - before.s - (at.v + before.v) / 2.0 * dt).abs() < 1e-6, "{at:?} after {before:?}");
            if limits.jerk.is_finite() {
                assert!(
                    (at.a - before.a).abs() <= limits.jerk * dt * (1.0 + 1e-6) + 1e-6,
                    "{at:?} {before:?}"
                );
            }
            before = at;
        }
        stroke.at(stroke.duration() * 2.0)
    }

    #[test]
    fn from_rest_to_rest_in_the_shortest_time() {
        // v/a + a/j = 0.25 s for a change of speed, 1.25 on the way: 2.5 of 10, and 0.75 s at full speed.
        let long = Stroke::rest_to_rest(10.0, &LIMITS);
        assert!((long.duration() - 1.25).abs() < 1e-12, "{}", long.duration());
        for way in [0.0, 1e-9, 0.01, 0.3, 0.6, 2.4, 2.6, 100.0] {
            for jerk in [1000.0, 100.0, f64::INFINITY] {
                let limits = RampLimits { jerk, ..LIMITS };
                let stroke = Stroke::rest_to_rest(way, &limits);
                assert_eq!(check(&stroke, At::default(), &limits), At { s: way, v: 0.0, a: 0.0 });
            }
        }
    }

    #[test]
    fn it_stops_from_anywhere_before_its_end() {
        for jerk in [1000.0, 60.0, f64::INFINITY] {
            let limits = RampLimits { jerk, ..LIMITS };
            for way in [0.2, 2.0, 20.0] {
                let stroke = Stroke::rest_to_rest(way, &limits);
                for k in 0..=40 {
                    let from = stroke.at(stroke.duration() * f64::from(k) / 40.0);
                    let stop = Stroke::stop(from, way, &limits);
                    let end = check(&stop, from, &limits);
                    assert!(end.v == 0.0 && end.s >= from.s - 1e-9 && end.s <= way, "{from:?} {end:?}");
                }
            }
        }
    }
}
