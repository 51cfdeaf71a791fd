//! Points that lie close to the chord between others are left out.

use super::{Point, Smoother, front};
use ferrocut_geometry::AXES;

/// Most points left out in a row.
const MOST_LEFT_OUT: usize = 48;

/// On how many of the points left out a chord is judged, about.
const FITTED: usize = 8;

/// Lines shorter than this share of the tolerance are run at the feed of those beside them.
const SHORT_FEED: f64 = 0.5;

impl Smoother {
    /// Which points are kept.
    pub(super) fn thin_out(&mut self) {
        self.kept.clear();
        self.chords.clear();
        self.is_thinned.clear();
        self.is_thinned.push(false);
        let anchor = if self.goes_on {
            // From the last knot that stands, on the chord that it stood on.
            self.chords.push(self.anchor);
            self.segment(self.anchor.0, 0)
        } else {
            self.kept.push(0);
            self.chords.push((self.points[0].u, self.points[0].p.0));
            0
        };
        if self.count == 3 {
            self.thin_out_from::<3>(anchor);
        } else {
            self.thin_out_from::<AXES>(anchor);
        }
    }

    /// The same from point `anchor` on.
    fn thin_out_from<const N: usize>(&mut self, mut anchor: usize) {
        let last = self.points.len() - 1;
        let (mut from_u, mut from_p) = (self.chords[0].0, front::<N>(&self.chords[0].1));
        while anchor < last {
            let mut end = anchor + 1;
            let mut cone = Cone::new(from_u, from_p);
            let speeds = |i: usize| (self.points[i].feed, self.points[i].most);
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
                if other.is_none() && speeds(end) != speeds(own) {
                    other = Some(end);
                }
                if let Some(first) = other
                    && !is_short(first, end + 1)
                {
                    if !is_short(anchor, first) {
                        end = first;
                        break;
                    }
                    (own, other) = (first, (first..=end).find(|i| speeds(*i) != speeds(first)));
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
            let most = level.chord * point.tolerance.min(self.points[i - 1].tolerance);
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
        let own = point.level().chord * point.tolerance.min(before) * self.inverse;
        let mut off = [0.0; N];
        let mut square = 0.0;
        for k in 0..N {
            off[k] = self.last[k] - self.middle[k];
            square += off[k] * off[k];
        }
        let apart = square.sqrt();
        if is_first || apart + own <= self.radius {
            (self.middle, self.radius) = (self.last, own);
        } else if apart + self.radius > own {
            // The largest ball in what both have in common; none if that is nothing.
            let share = 0.5 * (apart - own + self.radius) / apart;
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
