//! Runs of short lines as the smooth curve that they sample.
//!
//! A run of lines is replaced by a cubic B-spline over the programmed length `u` as parameter: C², with a third
//! derivative that is constant between knots, which is what jerk limits ask for. How it is found:
//!
//! 1. **Thin out** (`smooth/thin.rs`). From a kept point on, points are left out as long as all of them lie within a share of the
//!    tolerance of the chord. What rounding of coordinates does to directions of short blocks is gone then.
//! 2. **Knots** (`smooth/knots.rs`) at the points that are kept, and a fan of them beside each, close at the vertex and further apart away
//!    from it: a corner that turns by `Δ` between knots `h` apart is missed by `Δ·h/6`.
//! 3. **Control points** (`smooth/controls.rs`) first on the chords at the Greville lengths `ξₖ = (tₖ₋₁ + tₖ + tₖ₊₁)/3`, so that straight
//!    stretches are reproduced exactly, at unit speed (Schoenberg's operator). Those of dense stretches then go where
//!    `∫|S − P|² + ∫ℓ⁶·|S‴|²` is least, some times over: places that come near the tolerance weigh more. Once it is known
//!    about how fast the run will be ([`crate::path::pace`]), slow places get more knots, and `ℓ` is `v·(δ/J)^⅓`.
//! 4. **Check** (`smooth/check.rs`) of the true distance, of every programmed point from the spline and of the spline from the
//!    programmed lines. Where it is beyond the tolerance, places weigh more from further inside it on; then less is left
//!    out, knots come closer and in the end control points stay on the chords ([`LEVELS`]); the last level keeps the
//!    tolerance by construction.
//!
//! Of a run that is not known to its end what is close to that is kept back (`smooth/ends.rs`).
//!
//! An end at rest only has its place. At an end that something is joined to, the spline has a span on the line itself, so
//! that it meets it with no curvature; far from its vertices a programmed line stays the line.

// Only the axes in front that move are looped over, in several vectors at once.
#![allow(clippy::needless_range_loop)]

mod check;
mod controls;
mod ends;
mod knots;
mod thin;

use crate::limits::{Class, Inverse};
use crate::moves::ways;
use crate::path::fit::Fit;
use crate::path::shape::Smooth;
use crate::quick::smaller;
use check::Stray;
use ferrocut_geometry::{AXES, Position, SAME_POINT_MM};

/// Most points of a run that are smoothed at once; a longer run goes on from where it was, and smooths some spans again.
pub(crate) const POINTS: usize = 512;

/// Points that one more move may bring.
const SPARE: usize = 160;

/// Share of a span by which its end may lie beside a point by rounding.
const SAME_PLACE: f64 = 1e-6;

/// Knots: ten more a line at most.
const KNOTS: usize = KNOTS_A_LINE * (POINTS + SPARE) + 32;

/// Places in which spans are set against the lines, of those before knots were put in too: no span has more than three.
const LOOKS: usize = 6 * KNOTS;

/// How far smoothing goes, from the boldest on.
struct Level {
    /// Share of the tolerance that points left out may be away from the chord.
    chord: f64,
    /// Distance of knots: times `6·δ/Δ`.
    spread: f64,
    /// How far `ℓ` a wave is smoothed away, times the distance of knots; 0 leaves control points on the chords.
    reach: f64,
    /// Share of the tolerance beyond which a place weighs more; the rest is for what lies between the places.
    close: f64,
}

const LEVELS: [Level; 8] = [
    Level { chord: 2.0, spread: 1.0, reach: 0.9, close: 0.97 },
    Level { chord: 2.0, spread: 1.0, reach: 0.9, close: 0.85 },
    Level { chord: 1.0, spread: 0.8, reach: 0.7, close: 0.85 },
    Level { chord: 0.6, spread: 0.6, reach: 0.4, close: 0.85 },
    Level { chord: 0.5, spread: 1.4, reach: 0.0, close: 0.85 },
    Level { chord: 0.3, spread: 0.7, reach: 0.0, close: 0.85 },
    Level { chord: 0.0, spread: 0.6, reach: 0.0, close: 0.85 },
    Level { chord: 0.0, spread: 0.2, reach: 0.0, close: 0.85 },
];

/// What two ways to work out one place may differ by, mm.
const ROUNDING: f64 = 1e-12;

/// Knots and control points that stand where a run goes on: what one span needs.
const STANDING_KNOTS: usize = 6;
const STANDING_CONTROLS: usize = 4;

/// How often a curve is brought closer where it does not keep the tolerance, as long as that is in no more places.
const CLOSER: usize = 4;

/// How often levels are raised one by one.
const ROUNDS: usize = 20;

/// Knots a line at most, with those put in.
const KNOTS_A_LINE: usize = 11;

/// The same where there are few lines, for all of them together.
const KNOTS_A_CORNER: usize = 36;
const KNOTS_OF_CORNERS: usize = 3000;

/// Faster is nothing, mm/s.
const FASTEST: f64 = 1e6;

/// Share of the tolerance that is used: the speed in a turn grows with `δ^⅓`. The rest is for what lies between the places
/// that are checked.
const TOLERANCE_SHARE: f64 = 0.985;

/// Spans behind those that are put out which are checked with them.
const KEPT_SPANS: usize = 5;

/// A point of a run.
#[derive(Clone, Copy, Debug)]
struct Point {
    p: Position,
    /// Programmed length up to here.
    u: f64,
    /// Of the line that begins here: mm/s, no override passes `most`, and how far the path may be left.
    feed: f64,
    most: f64,
    /// What of the programmed tolerance is left beside points that were left out.
    tolerance: f64,
    programmed: f64,
    level: u8,
}

impl Point {
    fn level(&self) -> &'static Level {
        &LEVELS[usize::from(self.level).min(LEVELS.len() - 1)]
    }

    /// How fast the line is run about, without an override, mm/s.
    fn pace(&self) -> f64 {
        smaller(smaller(self.feed, self.most), FASTEST)
    }
}

/// A stretch of the smoothed run.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Span {
    pub u: f64,
    pub curve: Smooth,
    pub feed: f64,
    /// Highest speed whatever the override, mm/s.
    pub most: f64,
    pub is_straight: bool,
    /// Whether turns are few where it lies.
    pub turns_are_few: bool,
    /// How far X, Y and Z go on its line, as a share of the length of that.
    pub share: f64,
}

type Vector = [f64; AXES];

/// `q`, `q′` and `q″` at a knot.
type AtKnot<const N: usize> = [[f64; N]; 3];

/// A run being smoothed.
#[derive(Debug)]
pub(crate) struct Smoother {
    pub class: Class,
    points: Vec<Point>,
    /// So many points in front stay: the first line, and what was smoothed already.
    standing: usize,
    /// Places of the points that are kept.
    kept: Vec<usize>,
    /// Ends of the chords: length and place.
    chords: Vec<(f64, Vector)>,
    /// Whether points were left out on the chord that ends here.
    is_thinned: Vec<bool>,
    knots: Vec<f64>,
    controls: Vec<Vector>,
    /// Whether the span that begins at knot `k` of the run lies on more than one line.
    is_dense: Vec<bool>,
    /// Spans that do not keep the tolerance.
    strays: Vec<Stray>,
    /// Whether the curve is brought close in few rounds.
    is_rough: bool,
    /// The control points being fitted: of X, Y, Z, and of all axes where others move.
    fit: Fit<3>,
    fit_all: Fit<AXES>,
    /// Limits of the axes.
    inverse: Inverse,
    /// The same, with a jerk where none is limited.
    soft: Inverse,
    /// Knots while some are added.
    finer: Vec<f64>,
    is_finer_dense: Vec<bool>,
    /// The spans before that was done which spans are; none of those that were split.
    origins: Vec<Option<usize>>,
    /// The run goes on: its first knots and control points stand, because a part of it is in the queue already.
    goes_on: bool,
    /// Where the last knot that stands lies.
    anchor: (f64, Vector),
    /// How far apart knots may be about it.
    anchor_reach: f64,
    anchor_size: f64,
    /// Highest speeds at both ends, mm/s.
    speeds: [f64; 2],
    /// The first and the last line stay as they are: something is joined to them.
    keeps: [bool; 2],
    /// Whether little of it is slow, of many lines: what is gained in a turn is little of the whole.
    turns_are_few: bool,
    /// How many axes in front move.
    count: usize,
}

impl Smoother {
    pub fn new(inverse: Inverse) -> Smoother {
        Smoother {
            class: Class::Cut,
            points: Vec::with_capacity(POINTS + SPARE),
            standing: 0,
            kept: Vec::with_capacity(POINTS + SPARE),
            chords: Vec::with_capacity(POINTS + SPARE),
            is_thinned: Vec::with_capacity(POINTS + SPARE),
            knots: Vec::with_capacity(KNOTS),
            controls: Vec::with_capacity(KNOTS),
            is_dense: Vec::with_capacity(KNOTS),
            strays: Vec::with_capacity(KNOTS),
            is_rough: false,
            fit: Fit::new(KNOTS, LOOKS),
            fit_all: Fit::new(KNOTS, LOOKS),
            inverse,
            soft: inverse,
            finer: Vec::with_capacity(KNOTS),
            is_finer_dense: Vec::with_capacity(KNOTS),
            origins: Vec::with_capacity(KNOTS),
            goes_on: false,
            anchor: (0.0, [0.0; AXES]),
            anchor_reach: 0.0,
            anchor_size: 0.0,
            speeds: [f64::INFINITY; 2],
            keeps: [false; 2],
            turns_are_few: false,
            count: 3,
        }
    }

    pub fn clear(&mut self) {
        self.points.clear();
        self.goes_on = false;
        self.count = 3;
    }

    /// How many lines it holds.
    pub fn lines(&self) -> usize {
        self.points.len().saturating_sub(1)
    }

    /// Most spans that its lines are smoothed to.
    pub fn most_spans(&self) -> usize {
        let lines = self.lines();
        (KNOTS_A_LINE * lines).max((KNOTS_A_CORNER * lines).min(KNOTS_OF_CORNERS))
    }

    pub fn is_full(&self) -> bool {
        self.points.len() >= POINTS
    }

    /// Whether it is full with one more.
    pub fn is_nearly_full(&self) -> bool {
        self.points.len() + 1 >= POINTS
    }

    /// Begins a run of this class.
    pub fn begin(&mut self, p: Position, u: f64, class: Class) {
        self.clear();
        self.class = class;
        self.run_on(p, u);
        self.standing = 1;
    }

    /// Adds a line to `p`. Where a point before it is left out, the length of the one before that.
    pub fn add(&mut self, p: Position, u: f64) -> Option<f64> {
        if self.count < AXES && self.points.last().is_some_and(|last| last.p.0[3..] != p.0[3..]) {
            self.count = AXES;
        }
        self.run_on(p, u)
    }

    /// The same to a point that differs from the newest in X, Y and Z alone.
    #[inline]
    pub fn run_on(&mut self, p: Position, u: f64) -> Option<f64> {
        let tolerance = f64::INFINITY;
        let point =
            Point { p, u, feed: 0.0, most: f64::INFINITY, tolerance, programmed: tolerance, level: 0 };
        self.points.push(point);
        self.leave_out()
    }

    /// Feed, highest speed and tolerance of the line that begins at the newest point.
    pub fn set_last(&mut self, feed: f64, most: f64, tolerance: f64) {
        if let Some(last) = self.points.last_mut() {
            (last.feed, last.most, last.tolerance, last.programmed) = (feed, most, tolerance, tolerance);
        }
    }

    /// The newest line is run at no more than this feed.
    pub fn slow_last(&mut self, feed: f64) {
        if let [.., begin, _] = self.points.as_mut_slice() {
            begin.feed = begin.feed.min(feed);
        }
    }

    /// Highest speeds at the begin and the end of the run, mm/s.
    pub fn set_speeds(&mut self, speeds: [f64; 2]) {
        self.speeds = speeds;
    }

    /// Smooths the run between the lengths `from` and `to`, which lie on its first and its last line, and hands its
    /// spans to `out`. If the run is `open`, it goes on: the last spans are kept back. `keeps` says whether its first
    /// and its last line stay as they are.
    pub fn run(&mut self, from: f64, to: f64, keeps: [bool; 2], open: bool, out: impl FnMut(Span)) {
        // What follows is not joined to it where it goes on.
        self.keeps = [keeps[0], keeps[1] && !open];
        if self.points.len() < 2 {
            return;
        }
        let tolerance = self.points.iter().map(|point| point.tolerance).fold(f64::INFINITY, f64::min);
        self.soft = self.inverse.with_some_jerk(tolerance);
        if self.count == 3 {
            let mut fit = std::mem::take(&mut self.fit);
            self.smooth(&mut fit, [from, to], open, out);
            self.fit = fit;
        } else {
            let mut fit = std::mem::take(&mut self.fit_all);
            self.smooth(&mut fit, [from, to], open, out);
            self.fit_all = fit;
        }
    }

    /// The same with a fit of the axes that move.
    fn smooth<const N: usize>(
        &mut self,
        fit: &mut Fit<N>,
        [from, to]: [f64; 2],
        open: bool,
        out: impl FnMut(Span),
    ) {
        for round in 0..=ROUNDS {
            if round == ROUNDS {
                // The last level keeps the tolerance by construction.
                for point in &mut self.points {
                    point.level = LEVELS.len() as u8 - 1;
                }
            }
            self.thin_out::<N>();
            self.place_knots(from, to, open);
            self.place_on_chords();
            self.relax(fit, open);
            let last = self.last(open);
            // What is kept back rests on the knots that stand, so these must be good too.
            let spans = self.knots.len().saturating_sub(5);
            let last = (last + KEPT_SPANS).min(spans);
            if self.keeps_close(fit, last, open) {
                break;
            }
            self.raise_levels(round);
        }
        let last = self.last(open);
        self.hand_out(&fit.at_knots, last, out);
        if open {
            self.keep_from(last);
        } else {
            self.clear();
        }
    }

    /// Whether the spans up to `last` keep the tolerance, be it that the curve is brought closer where they do not: that takes far less
    /// time than to smooth all of the run again.
    fn keeps_close<const N: usize>(&mut self, fit: &mut Fit<N>, last: usize, open: bool) -> bool {
        let mut before = usize::MAX;
        for _ in 0..CLOSER {
            if self.check(fit, last) {
                return true;
            }
            if self.strays.len() > before || !self.come_closer(fit, open) {
                return false;
            }
            before = self.strays.len();
        }
        self.check(fit, last)
    }

    // Knot `k` of the run is `knots[k + 2]`, control point `k` is `controls[k + 1]`; spans are 0, 1, …
    fn t(&self, k: usize) -> f64 {
        self.knots[k + 2]
    }

    /// How far X, Y and Z go on line `i`, as a share of its length.
    fn share(&self, i: usize) -> f64 {
        let (a, b) = (&self.points[i], &self.points[i + 1]);
        // Else it is their length.
        if self.count == 3 {
            return 1.0;
        }
        let way = ways(&(b.p - a.p).0)[0];
        if way > SAME_POINT_MM { (way / (b.u - a.u)).min(1.0) } else { 0.0 }
    }

    /// The line that length `u` lies on, searched from line `from` on.
    fn segment(&self, u: f64, from: usize) -> usize {
        let inner = self.points.len().saturating_sub(1);
        let behind = self.points.get(from + 1..inner).unwrap_or(&[]);
        from + behind.iter().take_while(|point| point.u <= u).count()
    }

    /// The point that chord `i` begins with; none where a run goes on from a knot inside a line.
    fn kept_at(&self, i: usize) -> Option<usize> {
        let inside = self.chords.len() - self.kept.len();
        i.checked_sub(inside).and_then(|i| self.kept.get(i)).copied()
    }

    /// `q`, `q′` and `q″` at knot `k`.
    #[inline]
    fn at_knot<const N: usize>(&self, k: usize) -> AtKnot<N> {
        let [a, b, c, d, e] = std::array::from_fn(|i| self.knots[k + i]);
        let (p, q, r) = (&self.controls[k], &self.controls[k + 1], &self.controls[k + 2]);
        let (f, g, whole) = ((d - a).recip(), (e - b).recip(), (d - b).recip());
        let (left, right) = ((d - c) * whole, (c - b) * whole);
        let (w0, w2) = ((d - c) * left * f, (c - b) * right * g);
        let mut at = [[0.0; N]; 3];
        for i in 0..N {
            let (before, behind) = (q[i] - p[i], r[i] - q[i]);
            let (x, y) = (3.0 * f * before, 3.0 * g * behind);
            at[0][i] = q[i] + (w2 * behind - w0 * before);
            at[1][i] = left * x + right * y;
            at[2][i] = 2.0 * whole * (y - x);
        }
        at
    }

    /// Span `k` between what is at its knots.
    #[inline]
    fn cubic<const N: usize>(&self, k: usize, from: &AtKnot<N>, to: &AtKnot<N>) -> [[f64; N]; 4] {
        let sixth = (6.0 * (self.t(k + 1) - self.t(k))).recip();
        let [q, first, second] = *from;
        [q, first, second.map(|e| 0.5 * e), std::array::from_fn(|i| (to[2][i] - second[i]) * sixth)]
    }

    /// Hands out the spans before `last`, between what is `at` their knots.
    fn hand_out<const N: usize>(&self, at: &[AtKnot<N>], last: usize, mut out: impl FnMut(Span)) {
        let mut first = 0;
        for (k, ends) in at.windows(2).take(last).enumerate() {
            let (begin, end) = (self.t(k), self.t(k + 1));
            let (mut c, len) = (self.cubic(k, &ends[0], &ends[1]), end - begin);
            first = self.segment(begin, first);
            let middle = self.segment(0.5 * (begin + end), first);
            let line = &self.points[middle];
            // What bounds a line bounds every span over some of it.
            let rounding = SAME_PLACE * len;
            let begun = self.segment(begin + rounding, first);
            let over = self.points[begun + 1..].iter().take_while(|point| point.u < end - rounding);
            let most = over.fold(self.points[begun].most, |most, point| smaller(most, point.most));
            let is_straight =
                (0..N).all(|i| (2.0 * c[2][i]).abs() < 1e-9 && (6.0 * c[3][i] * len).abs() < 1e-9);
            if k == 0 {
                // A run begins exactly on its point, not beside it by rounding.
                for (own, p) in c[0].iter_mut().zip(&self.points[0].p.0) {
                    *own = if (*own - p).abs() <= ROUNDING { *p } else { *own };
                }
            }
            let (curve, feed) = (Smooth::new(&c, len, &line.p), line.feed);
            let (turns_are_few, share) = (self.turns_are_few, self.share(middle));
            out(Span { u: begin, curve, feed, most, is_straight, turns_are_few, share });
        }
    }
}

fn norm<const N: usize>(d: &[f64; N]) -> f64 {
    d.iter().map(|d| d * d).sum::<f64>().sqrt()
}

/// The axes in front.
fn front<const N: usize>(p: &Vector) -> [f64; N] {
    std::array::from_fn(|i| p[i])
}
