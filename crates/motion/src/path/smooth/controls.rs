//! Control points: on the chords first, then where the fit is best.

use super::check::Stray;
use super::{STANDING_CONTROLS, STANDING_KNOTS, Smoother, front};
use crate::path::fit::{BAND, Fit};
use crate::path::pace::Stretch;
use crate::quick::smaller;

/// Weight of the ends of a run, against that of a place inside.
const END_WEIGHT: f64 = 1e6;

/// In how many places a span is set against the lines; more where it lies on two or three of them. With up to sixteen runs are no
/// quicker, with or without rounding of coordinates, and planning takes longer.
const LOOKS: usize = 2;

/// How closely slow spans are fitted.
#[derive(Clone, Copy, Debug)]
struct Fineness {
    /// `ℓ` is so many times what would spend tolerance and jerk alike ([`crate::path::fit`]): the least of the squares still has more
    /// jerk in a turn than beside it.
    stiff: f64,
    /// How long they are at most, as a share of what is smoothed away there.
    split: f64,
    /// Where less of the jerk is taken than this, there and near by, there is less to bend for: it may be so much longer, up to so
    /// many times what is smoothed away.
    bends: f64,
    longest: f64,
}

const FINE: Fineness = Fineness { stiff: 1.1, split: 0.27, bends: 0.3, longest: 10.0 };

/// The same where turns are few among many lines, of which there are so many at least: there the speeds are not found once more behind
/// the first stiff curve, which is a little stiffer instead.
const FINE_FOR_FEW: Fineness = Fineness { stiff: 1.3, split: 0.55, bends: 0.7, longest: 20.0 };
const MANY_LINES: usize = 128;

/// So many parts are enough.
const MOST_PARTS: usize = 10;

/// At an end it is slow because it rests there: with more knots the fit, soft as it is where it is slow, would turn there so
/// sharply that it stays slow.
const PARTS_AT_END: usize = 3;

/// From an end at rest this share of the chord there has no corner to bend for.
const STRAIGHT: f64 = 0.5;

impl Smoother {
    /// Brings the curve closer where a span does not keep the tolerance. `false` where it can be brought no closer.
    pub(super) fn come_closer<const N: usize>(&mut self, fit: &mut Fit<N>, open: bool) -> bool {
        let mut is_closer = false;
        for &Stray { span, points: [first, _], u, tolerance } in &self.strays {
            let line = self.segment(u, first);
            let weight = (self.t(span + 1) - self.t(span)) / LOOKS as f64;
            let (basis, p) = (self.place(span).weights(u), self.on_line(line, u));
            let limit = tolerance * self.points[line].level().close;
            is_closer |= fit.look_closer(span, basis, weight, p, limit);
        }
        if is_closer {
            fit.close_in(self.strays.iter().map(|stray| stray.span), self.is_rough);
            self.follow(fit, open);
        }
        is_closer
    }

    /// Moves the control points to where the fit has them.
    fn follow<const N: usize>(&mut self, fit: &Fit<N>, open: bool) {
        for (control, (first, moved)) in self.controls.iter_mut().zip(fit.controls.iter().zip(&fit.moved)) {
            for i in 0..N {
                control[i] = first[i] + moved[i];
            }
        }
        self.hold_ends(self.turns(open), open);
    }

    /// Whether the first and the last span may turn and bend: an end at rest, of which only the place stands.
    fn turns(&self, open: bool) -> [bool; 2] {
        [!self.goes_on && !self.keeps[0], open || !self.keeps[1]]
    }

    /// Control points on the chords.
    pub(super) fn place_on_chords(&mut self) {
        let n = self.count;
        let standing = if self.goes_on { STANDING_CONTROLS } else { 0 };
        self.controls.truncate(standing);
        // One control point for every knot but the outermost two.
        let total = self.knots.len() - 2;
        let mut chord = 0;
        for j in standing..total {
            let u = (self.knots[j] + self.knots[j + 1] + self.knots[j + 2]) / 3.0;
            while chord + 2 < self.chords.len() && self.chords[chord + 1].0 < u {
                chord += 1;
            }
            let (a, b) = (&self.chords[chord], &self.chords[chord + 1]);
            let share = (u - a.0) / (b.0 - a.0);
            let mut control = a.1;
            for k in 0..n {
                control[k] += (b.1[k] - a.1[k]) * share;
            }
            self.controls.push(control);
        }
    }

    /// Moves the control points of dense stretches to where `∫|S − P|² + ∫ℓ⁶·|S‴|²` is least ([`crate::path::fit`]). The
    /// integral over the distance from the programmed lines is taken at some places of every span; the third derivative
    /// is constant on a span.
    pub(super) fn relax<const N: usize>(&mut self, fit: &mut Fit<N>, open: bool) {
        let turns = self.turns(open);
        let unknown = f64::INFINITY;
        fit.pace.ends = [
            if self.goes_on { unknown } else { self.speeds[0] },
            if open { unknown } else { self.speeds[1] },
        ];
        fit.pace.straight = self.straight(open);
        self.origins.clear();
        (self.turns_are_few, self.is_rough) = (false, false);
        fit.clear();
        if self.set(fit, turns, open) {
            fit.solve();
            fit.find_pace(&self.soft);
            if fit.pace.is_slow() {
                self.turns_are_few = self.lines() >= MANY_LINES && !fit.is_much_slow();
                // A way from rest or to rest is long in time; without a limit of jerk another stiffness would be right.
                self.is_rough = self.turns_are_few
                    && !fit.pace.ends.contains(&0.0)
                    && !self.inverse.is_free_of_jerk(&[1.0; N]);
                self.pace(fit, turns, open);
            }
            fit.close(self.is_rough);
            self.follow(fit, open);
        } else {
            self.hold_ends(turns, open);
        }
    }

    /// How far from the ends, where it rests there, the path need not bend. A fit that is soft there, because it is slow, bends
    /// so much that it stays slow.
    fn straight(&self, open: bool) -> [f64; 2] {
        let [(a, _), (b, _), .., (c, _), (d, _)] = self.chords[..] else { return [0.0; 2] };
        let rests = [!self.goes_on && self.speeds[0] == 0.0, !open && self.speeds[1] == 0.0];
        [(rests[0], b - a), (rests[1], d - c)].map(|(rests, len)| if rests { STRAIGHT * len } else { 0.0 })
    }

    /// Makes the fit as fine and as stiff as the speed asks for.
    fn pace<const N: usize>(&mut self, fit: &mut Fit<N>, turns: [bool; 2], open: bool) {
        let fine = if self.is_rough { FINE_FOR_FEW } else { FINE };
        if !self.split(fit, open, fine) {
            return;
        }
        self.place_on_chords();
        fit.clear_for_finer();
        self.set(fit, turns, open);
        fit.pace.take_parts();
        fit.stiffen(open, fine.stiff);
        fit.solve();
        if self.is_rough {
            return;
        }
        let with_its_speeds = |fit: &mut Fit<N>| {
            fit.find_pace(&self.soft);
            fit.stiffen(open, fine.stiff);
            fit.press_all();
            fit.solve();
        };
        // Once more with the speeds of what came out of it.
        with_its_speeds(fit);
        // Where much is slow, once more, for the speeds of a stiffer curve are others; and with the jerk spread about evenly.
        if !fit.is_much_slow() {
            return;
        }
        with_its_speeds(fit);
        if fit.level(&self.soft) {
            fit.press_all();
            fit.solve();
        }
    }

    /// Sets up what is to be least, in a fit without spans. Whether anything is free.
    fn set<const N: usize>(&mut self, fit: &mut Fit<N>, turns: [bool; 2], open: bool) -> bool {
        let total = self.controls.len();
        let spans = self.knots.len().saturating_sub(5);
        // Control point `j` bears on the spans j−3…j.
        let first = if self.goes_on { STANDING_CONTROLS } else { 3 * usize::from(!turns[0]) };
        let last = total - 3 * usize::from(!turns[1]);
        // One behind the last span that is not dense.
        let mut dense = 0;
        for j in 0..total {
            if j < spans && !self.is_dense[j] {
                dense = j + 1;
            }
            fit.is_free.push((first..last).contains(&j) && dense <= j.saturating_sub(3));
        }
        if !fit.is_free.contains(&true) {
            return false;
        }
        fit.begin(self.controls.iter().map(front));
        self.look(fit);
        for (k, is_end) in [(0, turns[0]), (spans - 1, turns[1] && !open)] {
            if is_end {
                self.tie_end(fit, k);
            }
        }
        fit.sum_up();
        true
    }

    /// Puts knots into slow spans that are longer than what is to be smoothed away there. Whether there are any. Knots stay
    /// as they are close to an end that something is joined to, where the spline has to bend away from the line, and close
    /// to an open one, where it is still to change.
    fn split<const N: usize>(&mut self, fit: &mut Fit<N>, open: bool, fine: Fineness) -> bool {
        let spans = self.knots.len().saturating_sub(5);
        let standing = if self.goes_on { STANDING_KNOTS - 3 } else { 0 };
        // No more than cells are kept room for.
        let mut left = self.most_spans().saturating_sub(spans);
        self.finer.clear();
        self.is_finer_dense.clear();
        self.origins.clear();
        let Fineness { split, bends, longest, .. } = fine;
        fit.find_loads(&self.soft);
        fit.pace.begin_split();
        self.finer.extend_from_slice(&self.knots[..3]);
        let keeps = [!self.goes_on && self.keeps[0], open || self.keeps[1]];
        for k in 0..spans {
            let (begin, end) = (self.t(k), self.t(k + 1));
            let mut parts = 1;
            if k >= standing && fit.pace.stretches[k].is_slow && self.is_dense[k] && fit.bears(k) {
                let away = fit.pace.most_reach(k);
                let is_close = keeps[0] && begin - self.t(0) < away || keeps[1] && self.t(spans) - end < away;
                if !is_close {
                    let share = (split * (bends / fit.load(k)).max(1.0)).min(longest);
                    let most = share * fit.pace.reach(k);
                    let is_end = k == 0 || k + 1 == spans;
                    let most_parts = if is_end { PARTS_AT_END } else { MOST_PARTS };
                    let fits = ((end - begin) / most).min(most_parts as f64) as usize;
                    parts = (fits + 1).min(most_parts).min(left + 1);
                    left -= parts - 1;
                }
            }
            fit.pace.split(k, parts);
            self.origins.resize(self.origins.len() + parts, (parts == 1).then_some(k));
            for part in 1..parts {
                self.finer.push(begin + (end - begin) * part as f64 / parts as f64);
                self.is_finer_dense.push(true);
            }
            self.finer.push(end);
            self.is_finer_dense.push(self.is_dense[k]);
        }
        if self.finer.len() + 2 == self.knots.len() {
            return false;
        }
        std::mem::swap(&mut self.knots, &mut self.finer);
        std::mem::swap(&mut self.is_dense, &mut self.is_finer_dense);
        self.mirror_knots();
        true
    }

    /// The spline ends on the ends of the run.
    fn tie_end<const N: usize>(&self, fit: &mut Fit<N>, k: usize) {
        let (point, u) = if k == 0 { (0, self.t(0)) } else { (self.points.len() - 1, self.t(k + 1)) };
        let weight = END_WEIGHT * (self.t(k + 1) - self.t(k));
        fit.tie(k, self.place(k).weights(u), weight, front(&self.points[point].p.0));
    }

    /// Sets the outermost control points so that the spline ends on the ends of the run to the last bit.
    fn hold_ends(&mut self, turns: [bool; 2], open: bool) {
        let total = self.controls.len();
        if turns[0] {
            let w = self.weights(0);
            let p = self.points[0].p.0;
            for axis in 0..self.count {
                self.controls[0][axis] =
                    (p[axis] - w[1] * self.controls[1][axis] - w[2] * self.controls[2][axis]) / w[0];
            }
        }
        if turns[1] && !open {
            let w = self.weights(total - 3);
            let Some(p) = self.points.last().map(|point| point.p.0) else { return };
            for axis in 0..self.count {
                let (a, b) = (self.controls[total - 3][axis], self.controls[total - 2][axis]);
                self.controls[total - 1][axis] = (p[axis] - w[0] * a - w[1] * b) / w[2];
            }
        }
    }

    /// Where the spline is set against the lines, and how stiff its spans are.
    fn look<const N: usize>(&self, fit: &mut Fit<N>) {
        let spans = self.knots.len().saturating_sub(5);
        let mut line = 0;
        for k in 0..spans {
            let (begin, end) = (self.t(k), self.t(k + 1));
            let len = end - begin;
            if self.origin(k).is_some_and(|k| fit.take_over(k)) {
                continue;
            }
            line = self.segment(begin, line);
            if !fit.bears(k) {
                fit.skip(Stretch::free(len, self.points[line].pace()));
                continue;
            }
            let lines = self.points[line + 1..].iter().take_while(|point| point.u < end).count();
            let last = (line + lines).min(self.points.len() - 2);
            let near = |k: usize| self.t(k + 1) - self.t(k);
            let least = smaller(smaller(near(k.saturating_sub(1)), len), near((k + 1).min(spans - 1)));
            let l = self.points[last].level().reach * least;
            let stiff = l * l * l * l * l * l * len;
            let (from, to) = (self.on_line::<N>(line, begin), self.on_line::<N>(last, end));
            let direction: [f64; N] = std::array::from_fn(|i| (to[i] - from[i]) / len);
            let top = smaller(self.points[last].pace(), self.inverse.velocity(&direction));
            let drive = self.soft.straight(&direction);
            let tolerance = smaller(self.points[line].tolerance, self.points[last].tolerance);
            let place = self.place(k);
            fit.add_span(place.bends(), stiff, tolerance, Stretch::new(len, top, drive, tolerance));
            let mut look = |line: usize, u: f64, weight: f64| {
                fit.look_at(place.weights(u), weight, self.on_line(line, u), self.limit(line, u));
            };
            if lines < LOOKS {
                // At every vertex, and between them.
                let mut from = begin;
                for line in line..=last {
                    let to = if line == last { end } else { smaller(self.points[line + 1].u, end) };
                    let looks = (LOOKS as f64 * (to - from) / len).ceil().max(1.0);
                    let weight = (to - from) / looks;
                    for i in 0..looks as usize {
                        look(line, from + weight * i as f64, weight);
                    }
                    from = to;
                }
                continue;
            }
            let weight = len / LOOKS as f64;
            let mut line = line;
            for i in 0..LOOKS {
                let u = begin + weight * i as f64;
                line = self.segment(u, line);
                look(line, u, weight);
            }
        }
    }

    /// How far the curve may be from the length `u` of a line: a point where two lines meet is within what both leave it.
    #[inline]
    fn limit(&self, line: usize, u: f64) -> f64 {
        let point = &self.points[line];
        let tolerance = match line.checked_sub(1) {
            Some(before) if u <= point.u => smaller(point.tolerance, self.points[before].tolerance),
            _ => point.tolerance,
        };
        tolerance * point.level().close
    }

    /// The place at the length `u` of a line.
    #[inline]
    fn on_line<const N: usize>(&self, line: usize, u: f64) -> [f64; N] {
        let (a, b) = (&self.points[line], &self.points[line + 1]);
        let share = (u - a.u) / (b.u - a.u);
        std::array::from_fn(|i| a.p.0[i] + (b.p.0[i] - a.p.0[i]) * share)
    }

    /// Which span `k` was before knots were put in, if all knots that bear on it are the same.
    fn origin(&self, k: usize) -> Option<usize> {
        let first = self.origins.get(k.checked_sub(2)?).copied().flatten()?;
        let last = self.origins.get(k + 2).copied().flatten()?;
        (last == first + 4).then_some(first + 2)
    }

    /// What the weights of the control points of span `k` are found with.
    fn place(&self, k: usize) -> Place {
        let t: [f64; 6] = std::array::from_fn(|i| self.knots[k + i]);
        let inverse = |low: usize, high: usize| (t[high] - t[low]).recip();
        let inverses =
            [inverse(2, 3), inverse(1, 3), inverse(2, 4), inverse(0, 3), inverse(1, 4), inverse(2, 5)];
        Place { t, inverses }
    }

    /// Weights of the three control points about knot `k` in the value there.
    fn weights(&self, k: usize) -> [f64; 3] {
        let [a, b, c, d, e] = [0, 1, 2, 3, 4].map(|i| self.knots[k + i]);
        let (left, right) = (c - b, d - c);
        let whole = d - b;
        let w0 = right * right / (whole * (d - a));
        let w2 = left * left / (whole * (e - b));
        [w0, 1.0 - w0 - w2, w2]
    }
}

/// The knots of a span, and the inverses of their distances.
struct Place {
    t: [f64; 6],
    inverses: [f64; 6],
}

impl Place {
    /// Weights of the four control points in the third derivative, and in the mean of the second.
    fn bends(&self) -> [[f64; BAND]; 2] {
        let [h, a, b, h3, h4, h5] = self.inverses;
        let [f0, f1, f2] = [3.0 * h3, 3.0 * h4, 3.0 * h5];
        let [w0, w1] = [2.0 * a * h, 2.0 * b * h];
        [
            [-w0 * f0, w1 * f1 + w0 * (f1 + f0), -w1 * (f2 + f1) - w0 * f1, w1 * f2],
            [a * f0, b * f1 - a * (f1 + f0), a * f1 - b * (f2 + f1), b * f2],
        ]
    }

    /// Weights of the four control points at `u` (de Boor).
    fn weights(&self, u: f64) -> [f64; BAND] {
        let t = &self.t;
        let (left, right) = ([u - t[2], u - t[1], u - t[0]], [t[3] - u, t[4] - u, t[5] - u]);
        let [h0, h1, h2, h3, h4, h5] = self.inverses;
        let (a0, a1) = (right[0] * h0, left[0] * h0);
        let (b0, b1) = (a0 * h1, a1 * h2);
        let (c0, c1, c2) = (right[0] * b0 * h3, (left[1] * b0 + right[1] * b1) * h4, left[0] * b1 * h5);
        [right[0] * c0, left[2] * c0 + right[1] * c1, left[1] * c1 + right[2] * c2, left[0] * c2]
    }
}
