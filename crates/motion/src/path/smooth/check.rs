//! The true distance between the spline and the lines.

use super::{AtKnot, LEVELS, Smoother, TOLERANCE_SHARE, Vector, norm};
use crate::path::fit::Fit;
use crate::quick::{larger, smaller};

/// In how many parts a span is looked at.
const CHECKS: usize = 16;

/// A span that does not keep the tolerance, the first and the last point that it is set against, a place where it is beyond, and the
/// tolerance that it is to keep.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stray {
    pub span: usize,
    pub points: [usize; 2],
    pub u: f64,
    pub tolerance: f64,
}

impl Smoother {
    /// Whether the spans up to `last` keep the tolerance; those that do not are noted, and what is at the knots.
    pub(super) fn check<const N: usize>(&mut self, fit: &mut Fit<N>, last: usize) -> bool {
        fit.at_knots.clear();
        fit.at_knots.extend((0..=last).map(|k| self.at_knot(k)));
        self.strays.clear();
        let mut first = 0;
        for (span, ends) in fit.at_knots.windows(2).enumerate() {
            first = self.segment(self.t(span), first);
            let stray = self.goes_astray(span, first, &ends[0], &ends[1]);
            self.strays.extend(stray);
        }
        self.strays.is_empty()
    }

    /// The points of the spans that do not keep the tolerance go to their next level.
    pub(super) fn raise_levels(&mut self, round: usize) {
        for Stray { points: [first, last], .. } in &self.strays {
            let until = (last + 2).min(self.points.len());
            for point in &mut self.points[first.saturating_sub(1)..until] {
                // One level a round, however many spans are at fault.
                point.level =
                    (point.level + 1).min(round as u8 + 1).min(LEVELS.len() as u8 - 1).max(point.level);
            }
        }
    }

    /// Span `k`, which begins on line `first`, if it is too far from the lines; `from` and `to` is what is at its knots.
    fn goes_astray<const N: usize>(
        &self,
        k: usize,
        first: usize,
        from: &AtKnot<N>,
        to: &AtKnot<N>,
    ) -> Option<Stray> {
        let (begin, end) = (self.t(k), self.t(k + 1));
        let c = self.cubic(k, from, to);
        // At the same lengths the spline and the lines are no further apart than at the knots and at the points, and by what
        // the spline bends away from its chords between them.
        let mut most = self.off_line(first, begin, &from[0]);
        let (mut tolerance, mut longest, mut u) = (self.points[first].tolerance, 0.0, begin);
        let mut inside = 0;
        for point in self.points[first + 1..].iter().take_while(|point| point.u <= end) {
            inside += 1;
            tolerance = smaller(tolerance, point.tolerance);
            let s = point.u - begin;
            longest = larger(longest, point.u - u);
            u = point.u;
            let mut square = 0.0;
            for i in 0..N {
                let e = c[0][i] + s * (c[1][i] + s * (c[2][i] + s * c[3][i])) - point.p.0[i];
                square += e * e;
            }
            most = larger(most, square);
        }
        let last = first + inside;
        most = larger(most, self.off_line(last, end, &to[0]));
        longest = larger(longest, end - u);
        let limit = (tolerance * TOLERANCE_SHARE) * (tolerance * TOLERANCE_SHARE);
        let bend = larger(norm(&from[2]), norm(&to[2]));
        if most.sqrt() + 0.125 * bend * longest * longest <= tolerance * TOLERANCE_SHARE {
            return None;
        }
        // Programmed points from the spline.
        let points = &self.points[first + 1..=last];
        let stray = |u: f64| Some(Stray { span: k, points: [first, last], u, tolerance });
        if let Some(point) = points.iter().find(|point| is_across(&c, point.u - begin, &point.p.0, limit)) {
            return stray(point.u);
        }
        // The spline from the programmed lines, between them.
        let mut line = first;
        let looks = CHECKS.max(2 * inside);
        let step = (end - begin) / looks as f64;
        for look in 1..looks {
            let s = step * look as f64;
            line = self.segment(begin + s, line);
            let q: [f64; N] = std::array::from_fn(|i| c[0][i] + s * (c[1][i] + s * (c[2][i] + s * c[3][i])));
            let is_near = |i: usize| self.is_near(i, &q, limit);
            let is_beside =
                || (line > 0 && is_near(line - 1)) || (line + 2 < self.points.len() && is_near(line + 1));
            if !(is_near(line) || is_beside()) {
                return stray(begin + s);
            }
        }
        None
    }

    /// The square of how far `q` is from the place at the length `u` of line `i`.
    #[inline]
    fn off_line<const N: usize>(&self, i: usize, u: f64, q: &[f64; N]) -> f64 {
        let (a, b) = (&self.points[i], &self.points[(i + 1).min(self.points.len() - 1)]);
        let share = if b.u > a.u { (u - a.u) / (b.u - a.u) } else { 0.0 };
        let mut square = 0.0;
        for k in 0..N {
            let e = a.p.0[k] + (b.p.0[k] - a.p.0[k]) * share - q[k];
            square += e * e;
        }
        square
    }

    /// Whether `q` is no further from line `i` than the root of `limit`.
    #[inline]
    fn is_near<const N: usize>(&self, i: usize, q: &[f64; N], limit: f64) -> bool {
        let (a, b) = (&self.points[i].p.0, &self.points[i + 1].p.0);
        let (mut dot, mut square, mut own) = (0.0, 0.0, 0.0);
        for k in 0..N {
            let (d, e) = (b[k] - a[k], q[k] - a[k]);
            dot += d * e;
            square += d * d;
            own += e * e;
        }
        if dot <= 0.0 || square == 0.0 {
            own <= limit
        } else if dot >= square {
            own - 2.0 * dot + square <= limit
        } else {
            own * square - dot * dot <= limit * square
        }
    }
}

/// Whether `p` is further from the cubic beside the length `s`, across its direction, than the root of `limit`. In a hairpin the
/// direction changes on the way to the nearest place: there it is looked at again.
#[inline]
fn is_across<const N: usize>(c: &[[f64; N]; 4], s: f64, p: &Vector, limit: f64) -> bool {
    let (square, along, speed) = beside(c, s, p);
    if square <= limit {
        return false;
    }
    (square - limit) * speed > along * along || beside(c, s - along / speed, p).0 > limit
}

/// The square of how far the cubic is from `p` at the length `s`, the product of that way with the derivative, and the square of
/// the derivative.
#[inline]
fn beside<const N: usize>(c: &[[f64; N]; 4], s: f64, p: &Vector) -> (f64, f64, f64) {
    let [c0, c1, c2, c3] = c;
    let (mut square, mut along, mut speed) = (0.0, 0.0, 0.0);
    for k in 0..N {
        let e = c0[k] + s * (c1[k] + s * (c2[k] + s * c3[k])) - p[k];
        let d = c1[k] + s * (2.0 * c2[k] + s * 3.0 * c3[k]);
        square += e * e;
        along += e * d;
        speed += d * d;
    }
    (square, along, larger(1e-12, speed))
}
