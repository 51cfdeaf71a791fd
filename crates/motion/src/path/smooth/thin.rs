//! Points that lie close to the chord between others are left out: first those of lines far shorter than the tolerance, as they
//! come, then what a run does not need.

use super::{Point, Smoother, front};
use crate::quick::smaller;

/// Points on lines that are no longer than this share of the tolerance together are left out as they come, where the lines
/// stay within so much of it of their chord: what comes in steps far below the tolerance fills no look-ahead.
const NEAR: f64 = 1.0;
const NEAR_OFF: f64 = 0.2;

/// Most points left out in a row.
const MOST_LEFT_OUT: usize = 48;

/// Of the two last chords before a line that stays the second is no shorter than this share of the first.
const UNEVEN: f64 = 0.7;

/// On how many of the points left out a chord is judged, about.
const FITTED: usize = 8;

/// Lines shorter than this share of the tolerance are run at the feed of those beside them.
const SHORT_FEED: f64 = 0.5;

/// Feeds that differ by less of themselves are the same.
const SAME_FEED: f64 = 1e-6;

impl Smoother {
    /// Leaves the point before the newest line but one out, if it is close enough to its neighbours; the length of the first of
    /// these. The newest line may be one that stays as it is, and so may the first.
    ///
    /// What was left out before is as far from the new chord as it was from the old one and the end of that from the new one, at
    /// most. Nor is it further than `½·√(L² − c²)` from a chord `c` between lines of the length `L` in all: no point is further from
    /// both ends together than `L`.
    #[inline]
    pub(super) fn leave_out(&mut self) -> Option<f64> {
        let at = self.points.len().checked_sub(3).filter(|at| *at > self.standing)?;
        let [.., a, b, c, _] = self.points.as_mut_slice() else { return None };
        // Lengths are of X, Y and Z.
        if self.count > 3 {
            return None;
        }
        let len = c.u - a.u;
        if len > NEAR * a.programmed || (a.feed, a.most, a.programmed) != (b.feed, b.most, b.programmed) {
            return None;
        }
        let [ab, ac]: [[f64; 3]; 2] = [&b, &c].map(|to| std::array::from_fn(|k| to.p.0[k] - a.p.0[k]));
        let dot = |x: &[f64; 3], y: &[f64; 3]| x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
        let (square, along) = (dot(&ac, &ac), dot(&ab, &ac));
        let share = if square > 0.0 { (along / square).clamp(0.0, 1.0) } else { 0.0 };
        let beside: [f64; 3] = std::array::from_fn(|k| ab[k] - share * ac[k]);
        let off = a.programmed - a.tolerance + dot(&beside, &beside).sqrt();
        let off = off.min(0.5 * (len * len - square).max(0.0).sqrt());
        if off > NEAR_OFF * a.programmed {
            return None;
        }
        a.tolerance = a.programmed - off;
        let u = a.u;
        self.points.remove(at);
        Some(u)
    }

    /// Which points are kept.
    pub(super) fn thin_out<const N: usize>(&mut self) {
        self.kept.clear();
        self.chords.clear();
        self.is_thinned.clear();
        self.is_thinned.push(false);
        let mut anchor = if self.goes_on {
            // From the last knot that stands, on the chord that it stood on.
            self.chords.push(self.anchor);
            self.segment(self.anchor.0, 0)
        } else {
            self.kept.push(0);
            self.chords.push((self.points[0].u, self.points[0].p.0));
            0
        };
        let last = self.points.len() - 1;
        let (mut from_u, mut from_p) = (self.chords[0].0, front::<N>(&self.chords[0].1));
        while anchor < last {
            let mut end = anchor + 1;
            let mut cone = Cone::new(from_u, from_p);
            // What is shorter than the tolerance has no feed of its own.
            let is_short = |from: usize, to: usize| {
                let (a, b) = (&self.points[from], &self.points[to]);
                b.u - a.u < SHORT_FEED * a.tolerance
            };
            // The line whose speeds the chord has, and the first behind it with others.
            let (mut own, mut other) = (anchor, None);
            let is_kept = self.keeps[0] && !self.goes_on && anchor == 0;
            while end < last && end - anchor < MOST_LEFT_OUT && !is_kept {
                if self.keeps[1] && end + 1 == last {
                    break;
                }
                if other.is_none() && !self.are_alike(end, own) {
                    other = Some(end);
                }
                if let Some(first) = other
                    && !is_short(first, end + 1)
                {
                    if !is_short(anchor, first) {
                        end = first;
                        break;
                    }
                    (own, other) = (first, (first..=end).find(|i| !self.are_alike(*i, first)));
                }
                let point = &self.points[end];
                cone.narrow(point, self.points[end - 1].tolerance);
                // What the cone does not say is looked at.
                if !cone.holds(&self.points[end + 1]) && !self.fits(from_u, &from_p, anchor + 1, end + 1) {
                    break;
                }
                end += 1;
            }
            self.kept.push(end);
            self.is_thinned.push(end > anchor + 1);
            let point = &self.points[end];
            self.chords.push((point.u, point.p.0));
            (from_u, from_p) = (point.u, front(&point.p.0));
            anchor = end;
        }
        if self.keeps[1] {
            self.even_out::<N>();
        }
    }

    /// Whether two lines have the same programmed feed and highest speed.
    fn are_alike(&self, i: usize, k: usize) -> bool {
        let (a, b) = (&self.points[i], &self.points[k]);
        if self.count == 3 {
            return (a.feed, a.most) == (b.feed, b.most);
        }
        // Along X, Y and Z, where these move.
        let along = |i: usize| {
            let share = self.share(i);
            if share > 0.0 { share } else { 1.0 }
        };
        let (x, y) = (along(i), along(k));
        let is_same = |a: f64, b: f64| a == b || (a - b).abs() <= SAME_FEED * a;
        is_same(a.feed * x, b.feed * y) && is_same(a.most * x, b.most * y)
    }

    /// Chords go as far as they can, so what is left for the last one before a line that stays may be a short one, which would have
    /// the knots beside that line close together: the two last ones are made about equal.
    fn even_out<const N: usize>(&mut self) {
        let (&[.., from, middle, end, _], count) = (self.kept.as_slice(), self.chords.len()) else { return };
        let place = |i: usize| self.points[i].u;
        let (begin, last) = (place(from), place(end));
        if last - place(middle) > UNEVEN * (place(middle) - begin) {
            return;
        }
        let half = 0.5 * (begin + last);
        let new = from + self.points[from..end].partition_point(|point| point.u < half);
        let are_alike = (from..end).all(|i| self.are_alike(i, from));
        let at = |i: usize| front::<N>(&self.points[i].p.0);
        let fits = new > from
            && new < middle
            && are_alike
            && self.fits(begin, &at(from), from + 1, new)
            && self.fits(place(new), &at(new), new + 1, end);
        if !fits {
            return;
        }
        let point = &self.points[new];
        self.chords[count - 3] = (point.u, point.p.0);
        let place = self.kept.len() - 3;
        self.kept[place] = new;
        let thinned = self.is_thinned.len();
        self.is_thinned[thinned - 3] = new > from + 1;
        self.is_thinned[thinned - 2] = end > new + 1;
    }

    /// Whether the points `first`…`end − 1` are close enough to the chord from a place to point `end`.
    fn fits<const N: usize>(&self, from_u: f64, from: &[f64; N], first: usize, end: usize) -> bool {
        let to = &self.points[end];
        let len = to.u - from_u;
        // Of many, some: the check of the spline looks at all of them.
        for i in (first..end).rev().step_by(1 + (end - first) / FITTED) {
            let point = &self.points[i];
            let level = point.level();
            if level.chord == 0.0 {
                return false;
            }
            let share = (point.u - from_u) / len;
            let mut square = 0.0;
            for k in 0..N {
                let on = from[k] + (to.p.0[k] - from[k]) * share;
                square += (point.p.0[k] - on) * (point.p.0[k] - on);
            }
            // Apart at the same share of the way is a little more than the distance.
            let most = level.chord * smaller(point.tolerance, self.points[i - 1].tolerance);
            if square > most * most {
                return false;
            }
        }
        true
    }
}

/// The chords from a place that pass all points so far closely enough: mean velocities `(p − p₀)/(u − u₀)` that lie in a
/// ball. Every point allows a ball about its own velocity, with the radius `δ/(u − u₀)`; this one is inside all of them.
struct Cone<const N: usize> {
    u: f64,
    p: [f64; N],
    middle: [f64; N],
    radius: f64,
    /// Velocity of the point that was asked for last, and what there is `1/(u − u₀)`.
    last: [f64; N],
    inverse: f64,
}

impl<const N: usize> Cone<N> {
    fn new(u: f64, p: [f64; N]) -> Cone<N> {
        Cone { u, p, middle: [0.0; N], radius: f64::INFINITY, last: [0.0; N], inverse: 0.0 }
    }

    fn aim(&mut self, point: &Point) {
        self.inverse = (point.u - self.u).recip();
        self.last = std::array::from_fn(|k| (point.p.0[k] - self.p[k]) * self.inverse);
    }

    /// Only what passes `point` too; `before` is the tolerance of the line to it.
    fn narrow(&mut self, point: &Point, before: f64) {
        let is_first = self.radius == f64::INFINITY;
        if is_first {
            self.aim(point);
        }
        let own = point.level().chord * smaller(point.tolerance, before) * self.inverse;
        let mut off = [0.0; N];
        let mut square = 0.0;
        for k in 0..N {
            off[k] = self.last[k] - self.middle[k];
            square += off[k] * off[k];
        }
        // Both at once, and no division behind the root.
        let (apart, inverse) = (square.sqrt(), square.recip());
        if is_first || apart + own <= self.radius {
            (self.middle, self.radius) = (self.last, own);
        } else if apart + self.radius > own {
            // The largest ball in what both have in common; none if that is nothing.
            let share = 0.5 * (apart - own + self.radius) * (apart * inverse);
            for k in 0..N {
                self.middle[k] += share * off[k];
            }
            self.radius = 0.5 * (self.radius + own - apart);
        }
    }

    /// Whether the chord to `point` is one of them.
    fn holds(&mut self, point: &Point) -> bool {
        self.aim(point);
        let mut square = 0.0;
        for k in 0..N {
            square += (self.last[k] - self.middle[k]) * (self.last[k] - self.middle[k]);
        }
        self.radius > 0.0 && square <= self.radius * self.radius
    }
}
