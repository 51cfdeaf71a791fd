//! Knots: at the points that are kept, and a fan of them beside each.

use super::{STANDING_KNOTS, Smoother, TOLERANCE_SHARE, Vector};
use crate::quick::{larger, smaller};

/// Knots beside a vertex, in shares of the first distance.
const FAN: [f64; 5] = [1.0, 3.0, 7.0, 15.0, 31.0];

/// A step of knots is set if the way that is left is so many times as long.
const FAN_ROOM: f64 = 2.25;

/// The first knot beside a vertex, in shares of its reach.
const FIRST: f64 = 0.7;

/// Beyond so many of them a line is left as it is.
const FAN_FREE: usize = 4;

/// A line of which one end stays as it is has a fan at the other if it is so many times as long as the first distance there.
const KEPT_ROOM: f64 = 4.0;

impl Smoother {
    pub(super) fn place_knots(&mut self, from: f64, to: f64, open: bool) {
        if self.goes_on {
            self.knots.truncate(STANDING_KNOTS);
            self.is_dense.truncate(STANDING_KNOTS - 3);
        } else {
            self.knots.clear();
            // Two before the start, filled in below.
            self.knots.extend([0.0, 0.0, from]);
            self.is_dense.clear();
        }
        let count = self.chords.len();
        // The knots that stand were placed with what was known then.
        let mut before = if self.goes_on { self.anchor_reach } else { 0.0 };
        for i in 0..count - 1 {
            let after = self.reach(i + 1);
            let start = self.chords[i].0.max(from);
            let is_last = i + 2 == count;
            let end = if is_last && !open { self.chords[i + 1].0.min(to) } else { self.chords[i + 1].0 };
            let len = end - start;
            let is_first = i == 0 && !self.goes_on;
            let must = is_first || (is_last && !open);
            let (least, most) = (smaller(before, after), larger(before, after));
            let kept = [is_first && self.keeps[0], is_last && !open && self.keeps[1]];
            if self.is_bold(i) && self.is_bold(i + 1) {
                let sizes =
                    [if i == 0 && self.goes_on { self.anchor_size } else { self.size(i) }, self.size(i + 1)];
                if kept == [false; 2] || len > KEPT_ROOM * larger(sizes[0], sizes[1]) {
                    self.fan(start, end, sizes, self.is_thinned[i + 1], kept);
                    before = after;
                    continue;
                }
            }
            if least == 0.0 {
                // At an end of the run; the corner at the other side decides.
                let free = len - most;
                let on = if most > 0.0 && free > 0.2 * most.min(len) { most } else { 0.5 * len };
                if must || free > 0.2 * most.min(len) {
                    self.knots.push(if after > 0.0 { end - on } else { start + on });
                }
            } else if len - before - after >= 0.3 * least {
                self.knots.extend([start + before, end - after]);
            } else if len > least {
                let on = if least < 0.6 * len { least } else { 0.5 * len };
                self.knots.push(if before < after { start + on } else { end - on });
            }
            self.knots.push(end);
            self.is_dense.resize(self.knots.len() - 3, false);
            before = after;
        }
        self.mirror_knots();
    }

    /// The two knots beyond each end.
    pub(super) fn mirror_knots(&mut self) {
        if !self.goes_on {
            let t0 = self.knots[2];
            self.knots[1] = 2.0 * t0 - self.knots[3];
            self.knots[0] = 2.0 * t0 - self.knots[4.min(self.knots.len() - 1)];
        }
        let n = self.knots.len();
        let end = self.knots[n - 1];
        let (one, two) = (self.knots[n - 2], self.knots[n - 3]);
        self.knots.extend([2.0 * end - one, 2.0 * end - two]);
    }

    /// How far apart knots may be about the kept point `i`.
    pub(super) fn reach(&self, i: usize) -> f64 {
        if i == 0 || i + 1 >= self.chords.len() {
            return 0.0;
        }
        let turn = self.turn([i - 1, i, i + 1].map(|k| (self.chords[k].0, &self.chords[k].1)));
        let Some(at) = self.kept_at(i) else { return 0.0 };
        let (before, point) = (&self.points[at.saturating_sub(1)], &self.points[at]);
        let tolerance = smaller(point.tolerance, before.tolerance) * TOLERANCE_SHARE;
        point.level().spread * 6.0 * tolerance / turn
    }

    /// How far apart knots are to be beside kept point `i`: enough to round the corner there, and no more than the chords
    /// beside it are long.
    pub(super) fn size(&self, i: usize) -> f64 {
        let Some(at) = self.kept_at(i) else { return 0.0 };
        if i == 0 || i + 1 >= self.chords.len() || at == 0 || at + 1 >= self.points.len() {
            return 0.0;
        }
        let (a, b, c) = (&self.points[at - 1], &self.points[at], &self.points[at + 1]);
        let turn = self.turn([a, b, c].map(|point| (point.u, &point.p.0)));
        let reach = 6.0 * b.level().spread * smaller(a.tolerance, b.tolerance) / turn;
        let [before, at, behind] = [i - 1, i, i + 1].map(|k| self.chords[k].0);
        smaller(FIRST * reach, smaller(at - before, behind - at))
    }

    /// Whether kept point `i` is smoothed freely.
    fn is_bold(&self, i: usize) -> bool {
        self.kept_at(i).is_none_or(|at| self.points[at].level().reach > 0.0)
    }

    /// Knots of the chord from `start` to `end`, close beside a vertex and further apart away from it. What lies far from
    /// both vertices of a programmed line stays on it.
    fn fan(&mut self, start: f64, end: f64, [before, after]: [f64; 2], is_thinned: bool, kept: [bool; 2]) {
        // The shorter step first, each twice the one before on its side.
        let (mut left, mut right) = (0, 0);
        let step = |size: f64| if size > 0.0 { size } else { f64::INFINITY };
        let (mut next, mut last, mut gap) = (step(before), step(after), end - start);
        while FAN_ROOM * smaller(next, last) < gap && left.max(right) < FAN.len() {
            gap -= smaller(next, last);
            if next <= last {
                (left, next) = (left + 1, 2.0 * next);
            } else {
                (right, last) = (right + 1, 2.0 * last);
            }
        }
        let is_far = |k: usize| k >= FAN_FREE && !is_thinned;
        for (k, share) in FAN[..left].iter().enumerate() {
            self.knots.push(start + share * before);
            self.is_dense.push(!is_far(k));
        }
        let mut middle = !((kept[0] || is_far(left)) && (kept[1] || is_far(right)));
        if is_thinned && left + right == 0 {
            self.knots.push(0.5 * (start + end));
            self.is_dense.push(true);
        }
        for (k, share) in FAN[..right].iter().enumerate().rev() {
            self.knots.push(end - share * after);
            self.is_dense.push(if k + 1 == right { middle } else { !is_far(k + 1) });
            middle = true;
        }
        self.knots.push(end);
        self.is_dense.push(if right == 0 { middle } else { true });
    }

    /// How much the direction changes at the middle one of three places, each with its length: the distance of both
    /// directions, not less than what rounding makes of none.
    fn turn(&self, [a, b, c]: [(f64, &Vector); 3]) -> f64 {
        let mut square = 0.0;
        for k in 0..self.count {
            let turn = (c.1[k] - b.1[k]) / (c.0 - b.0) - (b.1[k] - a.1[k]) / (b.0 - a.0);
            square += turn * turn;
        }
        larger(1e-12, square.sqrt())
    }
}
