//! The plan in time: pieces of a few milliseconds.
//!
//! A piece has the length `h` and runs from the speed `v₀` and the acceleration `a₀` to `v₁` and `a₁`, so that the
//! plan has a continuous acceleration whatever the pieces are. Within it the jerk goes linearly from `j₀` with the
//! slope `k`, the lowest order that meets five conditions (Δ = v₁ − v₀):
//!
//! ```text
//! s(t) = v₀·t + a₀·t²/2 + j₀·t³/6 + k·t⁴/24
//! k·T³ = 6·((a₀ + a₁)·T − 2·Δ)       j₀·T = a₁ − a₀ − k·T²/2
//! h    = (v₀ + v₁)/2·T + (a₀ − a₁)/12·T²
//! ```
//!
//! The last line gives the duration `T`. Where the jerk is constant `k` is 0.

use crate::limits::Load;
use crate::quick::{cube_root, larger};

/// How far a piece may be above a bound by rounding.
pub(crate) const ROUNDING: f64 = 1.0 + 1e-4;

/// What the acceleration may use within a piece whose ends keep the bounds: limits and what planning takes of them are
/// farther apart.
const SWELL: f64 = 1.001;

/// A last change of a time by this share leaves an error of its square.
const NEAR: f64 = 1e-5;

/// Speed and acceleration along the path, mm/s and mm/s².
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub(crate) struct State {
    pub v: f64,
    pub a: f64,
}

impl State {
    pub const REST: State = State { v: 0.0, a: 0.0 };
}

/// In how many places a piece is looked at.
pub(crate) const PLACES: usize = 8;

/// What a piece is like at several times: place on the path, speed, acceleration and jerk.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Places {
    pub s: [f64; PLACES],
    pub v: [f64; PLACES],
    pub a: [f64; PLACES],
    pub j: [f64; PLACES],
}

/// A piece of the plan.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Piece {
    /// Where it begins on the path, mm.
    pub s: f64,
    /// Its length, mm.
    pub h: f64,
    /// Its duration, s.
    pub time: f64,
    pub from: State,
    pub to: State,
    j: f64,
    k: f64,
}

impl Piece {
    /// Between two states; `None` where both are at rest, where no motion of this form is as long, or nothing is finite.
    pub fn new(s: f64, h: f64, from: State, to: State) -> Option<Piece> {
        let mean = 0.5 * (from.v + to.v);
        let square = mean * mean + (from.a - to.a) * h / 3.0;
        if !(square >= -1e-9 * mean * mean) {
            return None;
        }
        let root = larger(0.0, square).sqrt();
        let time = 2.0 * h / (mean + root);
        if !(time.is_finite() && time > 0.0) {
            return None;
        }
        let inverse = time.recip();
        let cube = inverse * inverse * inverse;
        let k = 6.0 * ((from.a + to.a) * time - 2.0 * (to.v - from.v)) * cube;
        let j = (to.a - from.a) * inverse - 0.5 * k * time;
        Some(Piece { s, h, time, from, to, j, k })
    }

    /// From `from` with the jerk `j` for `time`.
    pub fn steady(s: f64, from: State, j: f64, time: f64) -> Piece {
        let State { v, a } = from;
        let h = time * (v + time * (0.5 * a + time * j / 6.0));
        let to = State { v: (v + time * (a + 0.5 * time * j)).max(0.0), a: a + time * j };
        Piece { s, h, time, from, to, j, k: 0.0 }
    }

    /// Its first `t` seconds.
    pub fn until(&self, t: f64) -> Piece {
        let (s, v) = self.at(t);
        let a = self.from.a + t * (self.j + 0.5 * t * self.k);
        Piece { h: (s - self.s).min(self.h), time: t, to: State { v, a }, ..*self }
    }

    /// The same in parts of equal duration, `time` at most.
    pub fn parts(self, time: f64) -> impl Iterator<Item = Piece> {
        let count = (self.time / time).ceil().max(1.0);
        let (mut s, mut from) = (self.s, self.from);
        (1..=count as u64).map_while(move |k| {
            let (end, to) = if k as f64 == count {
                (self.end(), self.to)
            } else {
                let (end, state, _) = self.state(self.time * k as f64 / count);
                (end, state)
            };
            let part = Piece::new(s, end - s, from, to);
            (s, from) = (end, to);
            part
        })
    }

    /// Where it ends.
    pub fn end(&self) -> f64 {
        self.s + self.h
    }

    /// Whether it never goes back, looked at in three places.
    pub fn is_forward(&self) -> bool {
        let State { v, a } = self.from;
        let speed = |t: f64| v + t * (a + t * (self.j / 2.0 + t * self.k / 6.0));
        [0.25, 0.5, 0.75].iter().all(|share| speed(share * self.time) >= 0.0)
    }

    /// Jerk at both ends, mm/s³.
    fn jerks(&self) -> [f64; 2] {
        [self.j, self.j + self.k * self.time]
    }

    /// Whether the bounds of `load` hold at both ends, and for the acceleration between them.
    pub fn keeps(&self, load: &Load) -> bool {
        self.used(load) <= ROUNDING
    }

    /// Largest share of the bounds of `load` that is used at either end, and of the acceleration between them where it is
    /// more than all.
    #[inline]
    pub fn used(&self, load: &Load) -> f64 {
        let [from, to] = self.jerks();
        let at = |state: State, j: f64| load.used(state.v, state.a.abs(), j.abs());
        let ends = larger(at(self.from, from), at(self.to, to));
        if !(from * to < 0.0) {
            return ends;
        }
        // A limit of jerk at the ends hardly leaves the acceleration room to swell between them; where there is none, it may
        // be anything there.
        let inside = at(self.state(-self.j / self.k).1, 0.0);
        if inside > SWELL { ends.max(inside) } else { ends }
    }

    /// When it is at `s`, by Newton's method.
    pub fn time_at(&self, s: f64) -> f64 {
        let mut t = (s - self.s) / self.h * self.time;
        for _ in 0..4 {
            let (at, v) = self.at(t);
            t = (t + (s - at) / v.max(1e-9)).clamp(0.0, self.time);
        }
        t
    }

    /// Place on the path, speed and acceleration, and jerk after `t`.
    #[inline]
    pub fn state(&self, t: f64) -> (f64, State, f64) {
        let (s, v) = self.at(t);
        (s, State { v, a: self.from.a + t * (self.j + 0.5 * t * self.k) }, self.j + t * self.k)
    }

    /// The same at [`PLACES`] times, equally far apart, from its begin to its end.
    #[inline(always)]
    pub fn places(&self) -> Places {
        let step = self.time / (PLACES - 1) as f64;
        let mut at = Places::default();
        for i in 0..PLACES {
            let (s, State { v, a }, j) = self.state(i as f64 * step);
            (at.s[i], at.v[i], at.a[i], at.j[i]) = (s, v, a, j);
        }
        at
    }

    /// Place on the path and speed after `t`.
    #[inline]
    pub fn at(&self, t: f64) -> (f64, f64) {
        let State { v, a } = self.from;
        let way = t * (v + t * (a / 2.0 + t * (self.j / 6.0 + t * self.k / 24.0)));
        let speed = v + t * (a + t * (self.j / 2.0 + t * self.k / 6.0));
        (self.s + way, larger(0.0, speed))
    }
}

/// The state behind the length `h` that is entered in `from` and run with the jerk `j`.
///
/// `v·T + a·T²/2 + j·T³/6 = h` is solved by Newton's method from above: for `j ≥ 0`, `a ≥ 0` every term alone is less
/// than `h`, and the sum is convex.
#[inline]
pub(crate) fn step(from: State, j: f64, h: f64) -> State {
    behind(from, j, h, 6)
}

/// The acceleration there, about.
#[inline]
pub(crate) fn acceleration_behind(from: State, j: f64, h: f64) -> f64 {
    behind(from, j, h, 1).a
}

/// [`step`] with at most so many iterations. Each squares the error, so one that changes little is the last.
#[inline]
fn behind(from: State, j: f64, h: f64, iterations: usize) -> State {
    let State { v, a } = from;
    let mut t = if a >= 0.0 {
        let t = 2.0 * h / (v + (v * v + 2.0 * a * h).sqrt());
        if t * t * t * j <= 6.0 * h { t } else { cube_root(6.0 * h / j) }
    } else {
        // Never slower than where the braking is gone.
        h / (v - 0.5 * a * a / j)
    };
    for _ in 0..iterations {
        let off = t * (v + t * (0.5 * a + t * j / 6.0)) - h;
        let less = off / (v + t * (a + 0.5 * t * j));
        t -= less;
        if !(less.abs() > NEAR * t) {
            break;
        }
    }
    State { v: v + t * (a + 0.5 * t * j), a: a + t * j }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_piece_meets_its_conditions() {
        let from = State { v: 20.0, a: 300.0 };
        let to = State { v: 21.3, a: 200.0 };
        let piece = Piece::new(5.0, 0.1, from, to).unwrap();
        let (s, v) = piece.at(piece.time);
        assert!((s - 5.1).abs() < 1e-12 && (v - 21.3).abs() < 1e-10, "{s} {v}");
        let [j0, j1] = piece.jerks();
        assert!((from.a + 0.5 * (j0 + j1) * piece.time - to.a).abs() < 1e-9);
    }

    #[test]
    fn parts_of_a_piece_are_that_piece() {
        let piece = Piece::new(5.0, 2.0, State { v: 20.0, a: 300.0 }, State { v: 35.0, a: -20.0 }).unwrap();
        let parts: Vec<_> = piece.parts(0.01).collect();
        assert_eq!(parts.len(), (piece.time / 0.01).ceil() as usize);
        let mut before = 0.0;
        for part in &parts {
            let (s, v) = part.at(0.3 * part.time);
            let (whole_s, whole_v) = piece.at(before + 0.3 * part.time);
            assert!((s - whole_s).abs() < 1e-9 && (v - whole_v).abs() < 1e-7, "{part:?}");
            before += part.time;
        }
        assert_eq!((parts.last().unwrap().end(), parts.last().unwrap().to), (piece.end(), piece.to));
        assert!((before - piece.time).abs() < 1e-9);
    }

    #[test]
    fn what_cannot_be_that_long_is_no_piece() {
        let (from, to) = (State { v: 0.2179, a: -104.15 }, State { v: 0.0066, a: -0.3632 });
        assert_eq!(Piece::new(0.0, 4.54e-4, from, to), None);
        let piece = Piece::new(0.0, 3.4e-4, from, to).unwrap();
        assert!((piece.at(piece.time).0 - 3.4e-4).abs() < 1e-12);
    }

    #[test]
    fn constant_jerk_from_rest() {
        let to = step(State::REST, 60_000.0, 60_000.0 * 1e-6 / 6.0);
        assert!((to.v - 3.0).abs() < 1e-9 && (to.a - 600.0).abs() < 1e-7);
        let piece = Piece::new(0.0, 0.01, State::REST, to).unwrap();
        assert!((piece.time - 0.01).abs() < 1e-12);
        assert!(piece.jerks().iter().all(|j| (j - 60_000.0).abs() < 1e-3), "{:?}", piece.jerks());
    }
}
