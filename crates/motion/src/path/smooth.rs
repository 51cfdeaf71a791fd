//! Runs of short lines as the smooth curve that they sample.
//!
//! A run of lines is replaced by a cubic B-spline over the programmed length `u` as parameter: C², with a third
//! derivative that is constant between knots, which is what jerk limits ask for. How it is found:
//!
//! 1. **Thin out.** From a kept point on, points are left out as long as all of them lie within a share of the
//!    tolerance of the chord. What rounding of coordinates does to directions of short blocks is gone then.
//! 2. **Knots** at the points that are kept, and a fan of them beside each, close at the vertex and further apart away
//!    from it: a corner that turns by `Δ` between knots `h` apart is missed by `Δ·h/6`.
//! 3. **Control points** first on the chords at the Greville lengths `ξₖ = (tₖ₋₁ + tₖ + tₖ₊₁)/3`, so that straight
//!    stretches are reproduced exactly, at unit speed (Schoenberg's operator). Those of dense stretches then go where
//!    `∫|S − P|² + ∫ℓ⁶·|S‴|²` is least, some times over: places that come near the tolerance weigh more. Once it is known
//!    about how fast the run will be ([`crate::path::pace`]), slow places get more knots, and `ℓ` is `v·(δ/J)^⅓`.
//! 4. **Check** of the true distance, of every programmed point from the spline and of the spline from the
//!    programmed lines. Where it is beyond the tolerance, places weigh more from further inside it on; then less is left
//!    out, knots come closer and in the end control points stay on the chords ([`LEVELS`]); the last level keeps the
//!    tolerance by construction.
//!
//! An end at rest only has its place. At an end that something is joined to, the spline has a span on the line itself, so
//! that it meets it with no curvature; far from its vertices a programmed line stays the line.

// Only the axes in front that move are looped over, in several vectors at once.
#![allow(clippy::needless_range_loop)]

use crate::limits::{Class, Inverse, Rates};
use crate::path::fit::{BAND, Fit};
use crate::path::pace::Stretch;
use crate::path::shape::Cubic;
use ferrocut_geometry::{AXES, Position};

/// Most points of a run that are smoothed at once; a longer run goes on from where it was, and smooths some spans again.
pub(crate) const POINTS: usize = 512;

/// Points that one more move may bring.
const SPARE: usize = 160;

/// Share of a span by which its end may lie beside a point by rounding.
const SAME_PLACE: f64 = 1e-6;

/// Knots: eight more a line at most.
const KNOTS: usize = 9 * (POINTS + SPARE) + 32;

/// Most points left out in a row.
const MOST_LEFT_OUT: usize = 48;

/// On how many of the points left out a chord is judged, about.
const FITTED: usize = 8;

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
    Level { chord: 2.0, spread: 1.0, reach: 0.9, close: 0.95 },
    Level { chord: 2.0, spread: 1.0, reach: 0.9, close: 0.85 },
    Level { chord: 1.0, spread: 0.8, reach: 0.7, close: 0.85 },
    Level { chord: 0.6, spread: 0.6, reach: 0.4, close: 0.85 },
    Level { chord: 0.5, spread: 1.4, reach: 0.0, close: 0.85 },
    Level { chord: 0.3, spread: 0.7, reach: 0.0, close: 0.85 },
    Level { chord: 0.0, spread: 0.6, reach: 0.0, close: 0.85 },
    Level { chord: 0.0, spread: 0.2, reach: 0.0, close: 0.85 },
];

/// Knots beside a vertex, in shares of the first distance.
const FAN: [f64; 4] = [1.0, 3.0, 7.0, 15.0];

/// A step of knots is set if the way that is left is so many times as long.
const FAN_ROOM: f64 = 2.25;

/// The first knot beside a vertex, in shares of its reach.
const FIRST: f64 = 0.7;

/// Beyond so many of them a line is left as it is.
const FAN_FREE: usize = 3;

/// A line of which one end stays as it is has a fan at the other if it is so many times as long as the first distance there.
const KEPT_ROOM: f64 = 4.0;

/// What two ways to work out one place may differ by, mm.
const ROUNDING: f64 = 1e-12;

/// Knots and control points that stand where a run goes on: what one span needs.
const STANDING_KNOTS: usize = 6;
const STANDING_CONTROLS: usize = 4;

/// Lines shorter than this share of the tolerance are run at the feed of those beside them.
const SHORT_FEED: f64 = 0.5;

/// Weight of the ends of a run, against that of a place inside.
const END_WEIGHT: f64 = 1e6;

/// How often levels are raised one by one.
const ROUNDS: usize = 20;

/// In how many places a span is set against the lines.
const LEAST_LOOKS: usize = 3;
const MOST_LOOKS: usize = 16;

/// A slow span is no longer than this share of what is smoothed away there, where so many parts are enough.
const SPLIT: f64 = 0.7;
const MOST_PARTS: usize = 4;

/// Knots a line at most, with those put in.
const KNOTS_A_LINE: usize = 9;

/// The same where there are few lines, for all of them together.
const KNOTS_A_CORNER: usize = 36;
const KNOTS_OF_CORNERS: usize = 3000;

/// Faster is nothing, mm/s.
const FASTEST: f64 = 1e6;

/// Share of the tolerance that is used: the speed in a turn grows with `δ^⅓`. The rest is for what lies between the places
/// that are checked.
const TOLERANCE_SHARE: f64 = 0.985;

/// Spans at the end of an unfinished run that still change with what follows.
const TAIL: usize = 8;

/// In how many parts a span is looked at.
const CHECKS: usize = 16;

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
    tolerance: f64,
    level: u8,
}

impl Point {
    fn level(&self) -> &'static Level {
        &LEVELS[usize::from(self.level).min(LEVELS.len() - 1)]
    }

    /// How fast the line is run about, without an override, mm/s.
    fn pace(&self) -> f64 {
        self.feed.min(self.most).min(FASTEST)
    }
}

/// A stretch of the smoothed run.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Span {
    pub u: f64,
    pub cubic: Cubic,
    pub feed: f64,
    /// Highest speed whatever the override, mm/s.
    pub most: f64,
    pub is_straight: bool,
}

type Vector = [f64; AXES];

/// A run being smoothed.
#[derive(Debug)]
pub(crate) struct Smoother {
    pub class: Class,
    points: Vec<Point>,
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
    /// How many axes in front move.
    count: usize,
}

impl Smoother {
    pub fn new(inverse: Inverse) -> Smoother {
        Smoother {
            class: Class::Cut,
            points: Vec::with_capacity(POINTS + SPARE),
            kept: Vec::with_capacity(POINTS + SPARE),
            chords: Vec::with_capacity(POINTS + SPARE),
            is_thinned: Vec::with_capacity(POINTS + SPARE),
            knots: Vec::with_capacity(KNOTS),
            controls: Vec::with_capacity(KNOTS),
            is_dense: Vec::with_capacity(KNOTS),
            fit: Fit::new(KNOTS, MOST_LOOKS * KNOTS / 2),
            fit_all: Fit::new(KNOTS, MOST_LOOKS * KNOTS / 2),
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
    }

    /// Adds a line to `p`.
    pub fn add(&mut self, p: Position, u: f64) {
        if self.count < AXES && self.points.last().is_some_and(|last| last.p.0[3..] != p.0[3..]) {
            self.count = AXES;
        }
        self.run_on(p, u);
    }

    /// The same to a point that differs from the newest in X, Y and Z alone.
    #[inline]
    pub fn run_on(&mut self, p: Position, u: f64) {
        let tolerance = f64::INFINITY;
        self.points.push(Point { p, u, feed: 0.0, most: f64::INFINITY, tolerance, level: 0 });
    }

    /// Feed, highest speed and tolerance of the line that begins at the newest point.
    pub fn set_last(&mut self, feed: f64, most: f64, tolerance: f64) {
        if let Some(last) = self.points.last_mut() {
            (last.feed, last.most, last.tolerance) = (feed, most, tolerance);
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
        self.keeps = keeps;
        if self.points.len() < 2 {
            return;
        }
        for round in 0..=ROUNDS {
            if round == ROUNDS {
                // The last level keeps the tolerance by construction.
                for point in &mut self.points {
                    point.level = LEVELS.len() as u8 - 1;
                }
            }
            self.thin_out();
            self.place_knots(from, to, open);
            self.place_controls(open);
            let last = self.last(open);
            // What is kept back rests on the knots that stand, so these must be good too.
            let spans = self.knots.len().saturating_sub(5);
            let last = (last + KEPT_SPANS).min(spans);
            let is_good =
                if self.count == 3 { self.check::<3>(last, round) } else { self.check::<AXES>(last, round) };
            if is_good {
                break;
            }
        }
        let last = self.last(open);
        if self.count == 3 {
            self.hand_out::<3>(last, out);
        } else {
            self.hand_out::<AXES>(last, out);
        }
        if open {
            self.keep_from(last);
        } else {
            self.clear();
        }
    }

    /// One behind the last span to be put out.
    fn last(&self, open: bool) -> usize {
        let spans = self.knots.len().saturating_sub(5);
        if !open {
            return spans;
        }
        // The last knot that span `k` needs is a point that is kept: thinning out goes on from it as it did before.
        let is_kept =
            |k: usize| self.chords.binary_search_by(|chord| chord.0.total_cmp(&self.knots[k + 5])).is_ok();
        let most = spans.saturating_sub(TAIL);
        (0..=most).rev().find(|k| is_kept(*k)).unwrap_or(0)
    }

    // Knot `k` of the run is `knots[k + 2]`, control point `k` is `controls[k + 1]`; spans are 0, 1, …
    fn t(&self, k: usize) -> f64 {
        self.knots[k + 2]
    }

    /// Which points are kept.
    fn thin_out(&mut self) {
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

    /// The line that length `u` lies on, searched from line `from` on.
    fn segment(&self, u: f64, from: usize) -> usize {
        let mut i = from;
        while i + 2 < self.points.len() && self.points[i + 1].u <= u {
            i += 1;
        }
        i
    }

    /// The point that chord `i` begins with; none where a run goes on from a knot inside a line.
    fn kept_at(&self, i: usize) -> Option<usize> {
        let inside = self.chords.len() - self.kept.len();
        i.checked_sub(inside).and_then(|i| self.kept.get(i)).copied()
    }

    /// How much the direction changes at the middle one of three places, each with its length: the distance of both
    /// directions, not less than what rounding makes of none.
    fn turn(&self, [a, b, c]: [(f64, &Vector); 3]) -> f64 {
        let mut square = 0.0;
        for k in 0..self.count {
            let turn = (c.1[k] - b.1[k]) / (c.0 - b.0) - (b.1[k] - a.1[k]) / (b.0 - a.0);
            square += turn * turn;
        }
        square.sqrt().max(1e-12)
    }

    /// How far apart knots may be about the kept point `i`.
    fn reach(&self, i: usize) -> f64 {
        if i == 0 || i + 1 >= self.chords.len() {
            return 0.0;
        }
        let turn = self.turn([i - 1, i, i + 1].map(|k| (self.chords[k].0, &self.chords[k].1)));
        let Some(at) = self.kept_at(i) else { return 0.0 };
        let (before, point) = (&self.points[at.saturating_sub(1)], &self.points[at]);
        let tolerance = point.tolerance.min(before.tolerance) * TOLERANCE_SHARE;
        point.level().spread * 6.0 * tolerance / turn
    }

    fn place_knots(&mut self, from: f64, to: f64, open: bool) {
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
            let (least, most) = (before.min(after), before.max(after));
            let kept = [is_first && self.keeps[0], is_last && !open && self.keeps[1]];
            if self.is_bold(i) && self.is_bold(i + 1) {
                let sizes =
                    [if i == 0 && self.goes_on { self.anchor_size } else { self.size(i) }, self.size(i + 1)];
                if kept == [false; 2] || len > KEPT_ROOM * sizes[0].max(sizes[1]) {
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
    fn mirror_knots(&mut self) {
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

    /// How far apart knots are to be beside kept point `i`: enough to round the corner there, and no more than the chords
    /// beside it are long.
    fn size(&self, i: usize) -> f64 {
        let Some(at) = self.kept_at(i) else { return 0.0 };
        if i == 0 || i + 1 >= self.chords.len() || at == 0 || at + 1 >= self.points.len() {
            return 0.0;
        }
        let (a, b, c) = (&self.points[at - 1], &self.points[at], &self.points[at + 1]);
        let turn = self.turn([a, b, c].map(|point| (point.u, &point.p.0)));
        let reach = 6.0 * b.level().spread * a.tolerance.min(b.tolerance) / turn;
        let beside = (self.chords[i].0 - self.chords[i - 1].0).min(self.chords[i + 1].0 - self.chords[i].0);
        (FIRST * reach).min(beside)
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
        while FAN_ROOM * next.min(last) < gap && left.max(right) < FAN.len() {
            gap -= next.min(last);
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

    fn place_controls(&mut self, open: bool) {
        self.place_on_chords();
        if self.count == 3 {
            let mut fit = std::mem::take(&mut self.fit);
            self.relax(&mut fit, open);
            self.fit = fit;
        } else {
            let mut fit = std::mem::take(&mut self.fit_all);
            self.relax(&mut fit, open);
            self.fit_all = fit;
        }
    }

    /// Control points on the chords.
    fn place_on_chords(&mut self) {
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
    fn relax<const N: usize>(&mut self, fit: &mut Fit<N>, open: bool) {
        // An end at rest may turn and bend; only its place stands.
        let turns = [!self.goes_on && !self.keeps[0], open || !self.keeps[1]];
        let unknown = f64::INFINITY;
        fit.pace.ends = [
            if self.goes_on { unknown } else { self.speeds[0] },
            if open { unknown } else { self.speeds[1] },
        ];
        let tolerance = self.points.iter().map(|point| point.tolerance).fold(f64::INFINITY, f64::min);
        self.soft = self.inverse.with_some_jerk(tolerance);
        self.origins.clear();
        fit.clear();
        if self.set(fit, turns, open) {
            fit.solve();
            fit.find_pace(&self.soft);
            if fit.pace.is_slow() {
                self.pace(fit, turns, open);
            }
            fit.close();
            for (control, moved) in self.controls.iter_mut().zip(&fit.moved) {
                for i in 0..N {
                    control[i] += moved[i];
                }
            }
        }
        self.hold_ends(turns, open);
    }

    /// Makes the fit as fine and as stiff as the speed asks for.
    fn pace<const N: usize>(&mut self, fit: &mut Fit<N>, turns: [bool; 2], open: bool) {
        if !self.split(fit, open) {
            return;
        }
        self.place_on_chords();
        fit.clear_for_finer();
        self.set(fit, turns, open);
        fit.pace.take_parts();
        fit.stiffen(open);
        fit.solve();
        let with_its_speeds = |fit: &mut Fit<N>| {
            fit.find_pace(&self.soft);
            fit.stiffen(open);
            fit.press();
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
            fit.press();
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
        true
    }

    /// Puts knots into slow spans that are longer than what is to be smoothed away there. Whether there are any. Knots stay
    /// as they are close to an end that something is joined to, where the spline has to bend away from the line, and close
    /// to an open one, where it is still to change.
    fn split<const N: usize>(&mut self, fit: &mut Fit<N>, open: bool) -> bool {
        let spans = self.knots.len().saturating_sub(5);
        let standing = if self.goes_on { STANDING_KNOTS - 3 } else { 0 };
        // No more than cells are kept room for.
        let mut left = self.most_spans().saturating_sub(spans);
        self.finer.clear();
        self.is_finer_dense.clear();
        self.origins.clear();
        fit.pace.begin_split();
        self.finer.extend_from_slice(&self.knots[..3]);
        let keeps = [!self.goes_on && self.keeps[0], open || self.keeps[1]];
        for k in 0..spans {
            let (begin, end) = (self.t(k), self.t(k + 1));
            let mut parts = 1;
            if k >= standing && fit.pace.stretches[k].is_slow && self.is_dense[k] && fit.bears(k) {
                let tolerance = fit.tolerance(k);
                let away = fit.pace.most_reach(k, tolerance);
                let is_close = keeps[0] && begin - self.t(0) < away || keeps[1] && self.t(spans) - end < away;
                if !is_close {
                    let most = SPLIT * fit.pace.reach(k, tolerance);
                    let fits = ((end - begin) / most).min(MOST_PARTS as f64) as usize;
                    parts = (fits + 1).min(MOST_PARTS).min(left + 1);
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
            let least = near(k.saturating_sub(1)).min(len).min(near((k + 1).min(spans - 1)));
            let l = self.points[last].level().reach * least;
            let stiff = l * l * l * l * l * l * len;
            let on = |line: usize, u: f64| {
                let (a, b) = (&self.points[line], &self.points[line + 1]);
                let share = (u - a.u) / (b.u - a.u);
                std::array::from_fn::<f64, N, _>(|i| a.p.0[i] + (b.p.0[i] - a.p.0[i]) * share)
            };
            let (from, to) = (on(line, begin), on(last, end));
            let mut rates = Rates { first: [0.0; AXES], second: [0.0; AXES], third: [0.0; AXES] };
            for i in 0..N {
                rates.first[i] = (to[i] - from[i]) / len;
            }
            let top = self.points[last].pace().min(self.inverse.velocity(&rates));
            let drive = self.soft.straight(&rates.first);
            let tolerance = self.points[line].tolerance.min(self.points[last].tolerance);
            let stretch = Stretch { drive, ..Stretch::free(len, top) };
            fit.add_span(self.bends(k), stiff, tolerance, stretch);
            let place = self.place(k);
            let mut look = |line: usize, u: f64, weight: f64| {
                let point = &self.points[line];
                let limit = point.tolerance * point.level().close;
                fit.look_at(place.weights(u), weight, on(line, u), limit);
            };
            if lines < LEAST_LOOKS {
                // At every vertex, and between them.
                let mut from = begin;
                for line in line..=last {
                    let to = if line == last { end } else { self.points[line + 1].u.min(end) };
                    let looks = (LEAST_LOOKS as f64 * (to - from) / len).ceil().max(1.0);
                    let weight = (to - from) / looks;
                    for i in 0..looks as usize {
                        look(line, from + weight * i as f64, weight);
                    }
                    from = to;
                }
                continue;
            }
            let looks = (lines + 1).min(MOST_LOOKS);
            let weight = len / looks as f64;
            let mut line = line;
            for i in 0..looks {
                let u = begin + weight * i as f64;
                line = self.segment(u, line);
                look(line, u, weight);
            }
        }
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

    /// Weights of the four control points in the third derivative on span `k`, and in the mean of the second.
    fn bends(&self, k: usize) -> [[f64; BAND]; 2] {
        let t: [f64; 6] = std::array::from_fn(|i| self.knots[k + i]);
        let h = t[3] - t[2];
        let [f0, f1, f2] = [3.0 / (t[3] - t[0]), 3.0 / (t[4] - t[1]), 3.0 / (t[5] - t[2])];
        let [a, b] = [(t[3] - t[1]).recip(), (t[4] - t[2]).recip()];
        let [w0, w1] = [2.0 * a / h, 2.0 * b / h];
        [
            [-w0 * f0, w1 * f1 + w0 * (f1 + f0), -w1 * (f2 + f1) - w0 * f1, w1 * f2],
            [a * f0, b * f1 - a * (f1 + f0), a * f1 - b * (f2 + f1), b * f2],
        ]
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

    /// `q`, `q′` and `q″` at knot `k`.
    #[inline]
    fn at_knot<const N: usize>(&self, k: usize) -> [[f64; N]; 3] {
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
    fn cubic<const N: usize>(&self, k: usize, from: &[[f64; N]; 3], to: &[[f64; N]; 3]) -> [[f64; N]; 4] {
        let sixth = (6.0 * (self.t(k + 1) - self.t(k))).recip();
        let [q, first, second] = *from;
        [q, first, second.map(|e| 0.5 * e), std::array::from_fn(|i| (to[2][i] - second[i]) * sixth)]
    }

    /// Whether the spans up to `last` keep the tolerance; if not, the points concerned go to their next level.
    fn check<const N: usize>(&mut self, last: usize, round: usize) -> bool {
        let mut is_good = true;
        let mut first = 0;
        let mut to = self.at_knot::<N>(0);
        for k in 0..last {
            let from = to;
            to = self.at_knot(k + 1);
            first = self.segment(self.t(k), first);
            let Some(behind) = self.strays(k, first, &from, &to) else { continue };
            is_good = false;
            let until = (behind + 2).min(self.points.len());
            for point in &mut self.points[first.saturating_sub(1)..until] {
                // One level a round, however many spans are at fault.
                point.level =
                    (point.level + 1).min(round as u8 + 1).min(LEVELS.len() as u8 - 1).max(point.level);
            }
        }
        is_good
    }

    /// The last point of span `k`, which begins on line `first`, if the span is too far from the lines; `from` and `to` is
    /// what is at its knots.
    fn strays<const N: usize>(
        &self,
        k: usize,
        first: usize,
        from: &[[f64; N]; 3],
        to: &[[f64; N]; 3],
    ) -> Option<usize> {
        let (begin, end) = (self.t(k), self.t(k + 1));
        let c = self.cubic(k, from, to);
        let inside = self.points[first + 1..].iter().take_while(|point| point.u <= end).count();
        let last = first + inside;
        let tolerance =
            self.points[first..=last].iter().map(|point| point.tolerance).fold(f64::INFINITY, f64::min);
        let limit = (tolerance * TOLERANCE_SHARE) * (tolerance * TOLERANCE_SHARE);
        let points = &self.points[first + 1..=last];
        // At the same lengths the spline and the lines are no further apart than at the knots and at the points, and by what
        // the spline bends away from its chords between them.
        let mut most = self.off_line(first, begin, &from[0]).max(self.off_line(last, end, &to[0]));
        let (mut longest, mut u) = (0.0, begin);
        for point in points {
            let s = point.u - begin;
            longest = f64::max(longest, point.u - u);
            u = point.u;
            let mut square = 0.0;
            for i in 0..N {
                let e = c[0][i] + s * (c[1][i] + s * (c[2][i] + s * c[3][i])) - point.p.0[i];
                square += e * e;
            }
            most = most.max(square);
        }
        longest = longest.max(end - u);
        let bend = norm(&from[2]).max(norm(&to[2]));
        if most.sqrt() + 0.125 * bend * longest * longest <= tolerance * TOLERANCE_SHARE {
            return None;
        }
        // Programmed points from the spline.
        if points.iter().any(|point| is_across(&c, point.u - begin, &point.p.0, limit)) {
            return Some(last);
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
                return Some(last);
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

    /// Hands out the spans before `last`.
    fn hand_out<const N: usize>(&self, last: usize, mut out: impl FnMut(Span)) {
        let mut first = 0;
        let mut to = self.at_knot::<N>(0);
        for k in 0..last {
            let from = to;
            to = self.at_knot(k + 1);
            let (begin, end) = (self.t(k), self.t(k + 1));
            let (c, len) = (self.cubic(k, &from, &to), end - begin);
            first = self.segment(begin, first);
            let line = &self.points[self.segment(0.5 * (begin + end), first)];
            // What bounds a line bounds every span over some of it.
            let rounding = SAME_PLACE * len;
            let begun = self.segment(begin + rounding, first);
            let over = self.points[begun + 1..].iter().take_while(|point| point.u < end - rounding);
            let most = over.fold(self.points[begun].most, |most, point| most.min(point.most));
            let is_straight =
                (0..N).all(|i| (2.0 * c[2][i]).abs() < 1e-9 && (6.0 * c[3][i] * len).abs() < 1e-9);
            let mut cubic = Cubic { c: [Position::ZERO; 4], len };
            for (own, c) in cubic.c.iter_mut().zip(&c) {
                own.0[..N].copy_from_slice(c);
            }
            cubic.c[0].0[N..].copy_from_slice(&line.p.0[N..]);
            if k == 0 {
                // A run begins exactly on its point, not beside it by rounding.
                for (own, p) in cubic.c[0].0.iter_mut().zip(&self.points[0].p.0) {
                    *own = if (*own - p).abs() <= ROUNDING { *p } else { *own };
                }
            }
            out(Span { u: begin, cubic, feed: line.feed, most, is_straight });
        }
    }

    /// Keeps what the spans from `next` on need.
    fn keep_from(&mut self, next: usize) {
        // Span `next` needs knots next−2…next+3 and control points next−1…next+2.
        let begin = self.t(next);
        let u = self.knots[next + 5];
        let i =
            self.chords.iter().skip(1).take_while(|chord| chord.0 <= u).count().min(self.chords.len() - 2);
        let (a, b) = (&self.chords[i], &self.chords[i + 1]);
        let share = (u - a.0) / (b.0 - a.0);
        self.anchor_reach = self.reach(i);
        self.anchor_size = self.size(i);
        self.anchor = (u, std::array::from_fn(|k| a.1[k] + (b.1[k] - a.1[k]) * share));
        self.knots.copy_within(next..next + STANDING_KNOTS, 0);
        self.knots.truncate(STANDING_KNOTS);
        self.is_dense.copy_within(next..next + STANDING_KNOTS - 3, 0);
        self.is_dense.truncate(STANDING_KNOTS - 3);
        self.controls.copy_within(next..next + STANDING_CONTROLS, 0);
        self.controls.truncate(STANDING_CONTROLS);
        self.goes_on = true;
        let first = self.segment(begin, 0).saturating_sub(1);
        self.points.drain(..first);
    }
}

fn norm<const N: usize>(d: &[f64; N]) -> f64 {
    d.iter().map(|d| d * d).sum::<f64>().sqrt()
}

/// The axes in front.
fn front<const N: usize>(p: &Vector) -> [f64; N] {
    std::array::from_fn(|i| p[i])
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

/// The knots of a span, and the inverses of their distances.
struct Place {
    t: [f64; 6],
    inverses: [f64; 6],
}

impl Place {
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
    (square, along, speed.max(1e-12))
}
