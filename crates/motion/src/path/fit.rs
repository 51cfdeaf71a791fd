//! Control points where a weighted sum of squares is least.
//!
//! What is to be least is `Σ w·|Σ bᵢ·cᵢ − p|²` over places set against the lines and `Σ ℓ⁶·|Σ tᵢ·cᵢ|²` over spans, where
//! `bᵢ` and `tᵢ` weigh the four control points of a span in the value and in the third derivative. The normal equations
//! have three diagonals on either side and are solved by `L·D·Lᵀ`. A place that comes near the tolerance then weighs more,
//! and it is solved again.
//!
//! How stiff a span is: a third derivative `S‴` takes the jerk `v³·S‴` at the speed `v`. With
//!
//! ```text
//! ℓ = v·(δ/J)^⅓
//! ```
//!
//! `ℓ³·S‴` is `δ` where that jerk is `J`: the curve spends tolerance and jerk alike, everywhere as much as it is run fast
//! there ([`Pace`]). It is stiff far from a turn, where it is still fast, and swings out before it.
//!
//! The least sum of squares has more jerk in some places of a turn than in others. So spans are weighed anew by what each
//! takes of the jerk ([`Fit::level`]), as where a sum of higher powers is to be least.
//!
//! A round costs what has changed in it: places are looked at where control points have moved, those that weigh more are added
//! again, and control points are found again as far as that moves them, about each corner on its own.

// Only as many axes as move are looped over; their number is known when compiling.
#![allow(clippy::needless_range_loop)]

use crate::limits::Inverse;
use crate::path::pace::{Pace, Stretch};
use crate::quick::{larger, smaller};
use std::ops::Range;

/// Control points that bear on a span, and diagonals of the normal equations.
pub(crate) const BAND: usize = 4;

/// How often the spline is brought closer. Where it has not come close enough by then, less is smoothed at once, which costs
/// much more time on the machine than the rounds do here.
const ROUNDS: usize = 24;

/// How much more a place weighs that is beyond its limit: by the square of how far, with a little added, to a power that grows by
/// so much each round, and no more than [`MOST_CLOSER`]. A place that hardly gives way would take tens of rounds without.
///
/// What weighs too much in the end bends the curve more than it has to: where much is slow it is brought closer by less at once,
/// which takes more rounds; where turns are few by more.
#[derive(Clone, Copy, Debug)]
struct Pressure {
    closer: f64,
    harder: f64,
}

const PRESSURE: Pressure = Pressure { closer: 1.02, harder: 0.1 };
const PRESSURE_WHERE_SLOW: Pressure = Pressure { closer: 1.01, harder: 0.05 };
const PRESSURE_WHERE_FEW: Pressure = Pressure { closer: 1.03, harder: 0.2 };
const MOST_CLOSER: f64 = 30.0;

/// It is close enough where it is beyond the limit by no more than this, as a share of its square.
const CLOSE_ENOUGH: f64 = 1.02;

/// Rows of zeros before the first one and behind the last.
const ABOVE: usize = BAND - 1;
const BELOW: usize = BAND - 1;

/// A row of the equations that differs by no more than this share of itself is that of the round before.
const SAME: f64 = 1e-7;

/// Spans that weigh more and lie further apart than so many hardly bear on each other: about each of them control points are found
/// on their own.
const APART: usize = 16;

/// A control point that moves by no more than this share of the tolerance has not moved in a round.
const NOT_MOVED: f64 = 1e-5;

/// A span gets stiffer by its share of the mean jerk to this power, and stiffer and softer by no more than so many times: between
/// two sharp corners there is much that takes little.
const LEVEL: f64 = 0.6;
const MOST_LEVEL: [f64; 2] = [5.0, 2.5];

/// That is done where this share of a run is slow.
const MUCH_SLOW: f64 = 0.25;

/// What a span takes of the jerk tells how near something bends: beside it, it counts less by `e` over so many `ℓ`.
const FADES: f64 = 2.0;

/// `ℓ` is no more than this many times the length of the span.
const STIFFEST: f64 = 40.0;

/// Before the open end of a run it is no more than this share of the way to that end: the fit there is still to change.
const OPEN_SHARE: f64 = 0.5;

/// A place where the spline is set against the lines.
#[derive(Clone, Copy, Debug)]
struct Look<const N: usize> {
    basis: [f64; BAND],
    weight: f64,
    /// `1/d²` of the distance `d` beyond which it weighs more.
    close: f64,
    /// Where it shall be, from where the first control points have it.
    p: [f64; N],
}

/// A row of the normal equations: its entries from the diagonal on to the left, and its right side.
#[derive(Clone, Copy, Debug)]
struct Row<const N: usize> {
    entries: [f64; BAND],
    side: [f64; N],
}

impl<const N: usize> Row<N> {
    const ZERO: Row<N> = Row { entries: [0.0; BAND], side: [0.0; N] };

    /// That of a control point that is not moved.
    const STANDING: Row<N> = Row { entries: [1.0, 0.0, 0.0, 0.0], side: [0.0; N] };
}

/// What a span adds to the rows of its control points: all entries between these, and the right sides axis by axis, so that four
/// numbers are added at once.
#[derive(Clone, Copy, Debug)]
struct Own<const N: usize> {
    entries: [[f64; BAND]; BAND],
    sides: [[f64; BAND]; N],
}

impl<const N: usize> Own<N> {
    const ZERO: Own<N> = Own { entries: [[0.0; BAND]; BAND], sides: [[0.0; BAND]; N] };

    /// Adds `weight·|Σ gᵢ·cᵢ − p|²` to what is to be least.
    #[inline]
    fn add(&mut self, weight: f64, g: &[f64; BAND], p: &[f64; N]) {
        let shares = g.map(|g| weight * g);
        for (row, share) in self.entries.iter_mut().zip(shares) {
            for k in 0..BAND {
                row[k] += share * g[k];
            }
        }
        for (side, p) in self.sides.iter_mut().zip(p) {
            for k in 0..BAND {
                side[k] += shares[k] * p;
            }
        }
    }
}

/// A span.
#[derive(Clone, Copy, Debug)]
struct Strip<const N: usize> {
    /// Weights of the control points in the third derivative.
    third: [f64; BAND],
    /// The same in the mean second one.
    bend: [f64; BAND],
    /// Both of the first control points.
    first_third: [f64; N],
    first_bend: [f64; N],
    stiff: f64,
    /// What it takes of the jerk, or what one near it does.
    load: f64,
    tolerance: f64,
    /// The first of its places, and one behind the last.
    looks: [usize; 2],
    /// How far its control points may move before one of its places can be beyond its limit.
    room: f64,
}

/// Control points being fitted, of `N` axes.
///
/// What is looked for is by how much they are moved from the first ones: where these lie on a line, nothing is moved, not
/// even by rounding.
#[derive(Debug, Default)]
pub(crate) struct Fit<const N: usize> {
    /// The first ones.
    pub controls: Vec<[f64; N]>,
    /// By how much they are moved, and [`BELOW`] that are not.
    pub moved: Vec<[f64; N]>,
    pub is_free: Vec<bool>,
    /// Value, first and second derivative at the knots of what was found.
    pub at_knots: Vec<[[f64; N]; 3]>,
    looks: Vec<Look<N>>,
    strips: Vec<Strip<N>>,
    /// What each span adds to the rows of its control points at first.
    own: Vec<Own<N>>,
    /// Both before knots were put in.
    old: Vec<Strip<N>>,
    old_own: Vec<Own<N>>,
    /// How fast every span is run, about.
    pub pace: Pace,
    /// The normal equations.
    sums: Vec<Row<N>>,
    /// Entry `d` of row `i` is that of `L` in column `i − d`, on the diagonal `1/D`; and what is left of the right side. Row `i` is behind
    /// [`ABOVE`] others.
    factors: Vec<Row<N>>,
    /// How far every control point was moved by the last solution, no less.
    ways: Vec<f64>,
    /// Spans of which control points have moved, and those of which places weigh more.
    moving: Vec<Range<usize>>,
    pressed: Vec<Range<usize>>,
}

impl<const N: usize> Fit<N> {
    /// For so many control points and places.
    pub fn new(controls: usize, looks: usize) -> Fit<N> {
        Fit {
            controls: Vec::with_capacity(controls),
            moved: Vec::with_capacity(controls + BELOW),
            is_free: Vec::with_capacity(controls),
            at_knots: Vec::with_capacity(controls),
            looks: Vec::with_capacity(looks),
            strips: Vec::with_capacity(controls),
            own: Vec::with_capacity(controls),
            old: Vec::with_capacity(controls),
            old_own: Vec::with_capacity(controls),
            pace: Pace::new(controls),
            sums: Vec::with_capacity(controls),
            factors: Vec::with_capacity(ABOVE + controls + BELOW),
            ways: Vec::with_capacity(controls),
            moving: Vec::with_capacity(controls),
            pressed: Vec::with_capacity(controls),
        }
    }

    pub fn clear(&mut self) {
        self.controls.clear();
        self.moved.clear();
        self.is_free.clear();
        self.looks.clear();
        self.strips.clear();
        self.own.clear();
        self.pace.stretches.clear();
    }

    /// The same, but spans may be taken over as they are ([`take_over`](Self::take_over)).
    pub fn clear_for_finer(&mut self) {
        self.controls.clear();
        self.moved.clear();
        self.is_free.clear();
        std::mem::swap(&mut self.strips, &mut self.old);
        std::mem::swap(&mut self.own, &mut self.old_own);
        self.strips.clear();
        self.own.clear();
        self.pace.keep_stretches();
    }

    /// The next span is the old span `k` as it was at first. Whether there is such a span.
    pub fn take_over(&mut self, k: usize) -> bool {
        let (Some(strip), Some(own)) = (self.old.get(k), self.old_own.get(k)) else { return false };
        // Control points are moved from the first ones again.
        self.strips.push(Strip { room: 0.0, ..*strip });
        self.own.push(*own);
        self.pace.take_over(k);
        true
    }

    /// Sets the first control points.
    pub fn begin(&mut self, controls: impl Iterator<Item = [f64; N]>) {
        self.controls.extend(controls);
        self.moved.resize(self.controls.len() + BELOW, [0.0; N]);
    }

    /// What the first control points of span `k` make of the weights `g`.
    fn at_first(&self, k: usize, g: &[f64; BAND]) -> [f64; N] {
        weighted(g, &self.controls[k..k + BAND])
    }

    /// Whether one of the control points of span `k` is free.
    pub fn bears(&self, k: usize) -> bool {
        self.is_free[k..k + BAND].contains(&true)
    }

    /// The next span, of which nothing is free.
    pub fn skip(&mut self, stretch: Stretch) {
        self.add_span([[0.0; BAND]; 2], 0.0, 0.0, stretch);
    }

    /// The next span: weights in its third derivative and in the mean of its second, how stiff it is, and the tolerance.
    pub fn add_span(
        &mut self,
        [third, bend]: [[f64; BAND]; 2],
        stiff: f64,
        tolerance: f64,
        stretch: Stretch,
    ) {
        let k = self.strips.len();
        let (first_third, first_bend) = (self.at_first(k, &third), self.at_first(k, &bend));
        let looks = [self.looks.len(); 2];
        let mut own = Own::ZERO;
        own.add(stiff, &third, &first_third.map(|c| -c));
        self.own.push(own);
        let (load, room) = (0.0, 0.0);
        self.strips.push(Strip { third, bend, first_third, first_bend, stiff, load, tolerance, looks, room });
        self.pace.stretches.push(stretch);
    }

    /// A place of the newest span that shall be within `limit` of `p`.
    #[inline]
    pub fn look_at(&mut self, basis: [f64; BAND], weight: f64, p: [f64; N], limit: f64) {
        let Some(k) = self.strips.len().checked_sub(1) else { return };
        let p = apart(p, self.at_first(k, &basis));
        let look = Look { basis, weight, close: (limit * limit).recip(), p };
        if let (Some(strip), Some(own)) = (self.strips.last_mut(), self.own.last_mut()) {
            own.add(weight, &look.basis, &look.p);
            self.looks.push(look);
            strip.looks[1] = self.looks.len();
        }
    }

    /// Span `k` shall go through `p`.
    pub fn tie(&mut self, k: usize, basis: [f64; BAND], weight: f64, p: [f64; N]) {
        let p = apart(p, self.at_first(k, &basis));
        if let Some(own) = self.own.get_mut(k) {
            own.add(weight, &basis, &p);
        }
    }

    /// Sums up what all spans add to the normal equations at first.
    pub fn sum_up(&mut self) {
        self.sums.clear();
        self.sums.resize(self.controls.len(), Row::ZERO);
        for (k, own) in self.own.iter().enumerate() {
            for (i, sum) in self.sums[k..k + BAND].iter_mut().enumerate() {
                for back in 0..=i {
                    sum.entries[back] += own.entries[i][i - back];
                }
                for axis in 0..N {
                    sum.side[axis] += own.sides[axis][i];
                }
            }
        }
    }

    /// Finds the control points that are free.
    pub fn solve(&mut self) {
        self.solve_about(0..self.strips.len(), 0.0);
    }

    /// The same again, with more weight where the spline is far from the lines, as long as it is: in fewer rounds where turns are
    /// `few`. A round goes only as far as something changes.
    pub fn close(&mut self, few: bool) {
        self.all_move();
        self.come_close(few);
    }

    /// One more place of span `k`, where a fit that is close elsewhere is not: it is looked at by [`close_in`](Self::close_in). `false`
    /// where nothing is free, or there is no room.
    pub fn look_closer(
        &mut self,
        k: usize,
        basis: [f64; BAND],
        weight: f64,
        p: [f64; N],
        limit: f64,
    ) -> bool {
        let Some([from, to]) = self.strips.get(k).map(|strip| strip.looks) else { return false };
        if !self.bears(k) || self.looks.len() + (to - from) >= self.looks.capacity() {
            return false;
        }
        let p = apart(p, self.at_first(k, &basis));
        let strip = &mut self.strips[k];
        strip.looks = [self.looks.len(); 2];
        strip.room = 0.0;
        self.looks.extend_from_within(from..to);
        self.looks.push(Look { basis, weight, close: (limit * limit).recip(), p });
        strip.looks[1] = self.looks.len();
        if let Some(sums) = self.sums[k..].first_chunk_mut() {
            add(sums, weight, &basis, &p);
        }
        true
    }

    /// [`close`](Self::close) for these spans, one behind the other, and what bears on them.
    pub fn close_in(&mut self, spans: impl Iterator<Item = usize>, few: bool) {
        self.moving.clear();
        self.moving.extend(spans.map(|k| k..k + 1));
        self.come_close(few);
    }

    /// Weighs more where the spans that move are far from the lines, again and again.
    fn come_close(&mut self, few: bool) {
        let pressure = if few { PRESSURE_WHERE_FEW } else { self.pressure() };
        for round in 0..=ROUNDS {
            let power = 1.0 + pressure.harder * round as f64;
            if self.press(pressure.closer, power) <= CLOSE_ENOUGH {
                return;
            }
            self.solve_about_pressed();
        }
    }

    /// Finds the control points again about the spans of which places weigh more.
    fn solve_about_pressed(&mut self) {
        let pressed = std::mem::take(&mut self.pressed);
        let strips = pressed.iter().flat_map(|spans| &self.strips[spans.clone()]);
        let least = NOT_MOVED * strips.map(|strip| strip.tolerance).fold(f64::INFINITY, f64::min);
        self.moving.clear();
        for spans in &pressed {
            let mut moved = self.solve_about(spans.clone(), least);
            // Those before may have moved once more.
            while let Some(before) = self.moving.pop_if(|before| before.end >= moved.start) {
                moved = before.start.min(moved.start)..before.end.max(moved.end);
            }
            self.moving.push(moved);
        }
        self.pressed = pressed;
    }

    /// Every span is to be looked at.
    fn all_move(&mut self) {
        self.moving.clear();
        self.moving.push(0..self.strips.len());
    }

    /// How fast every span is run with the control points as they are.
    pub fn find_pace(&mut self, inverse: &Inverse) {
        let [first, last] = self.pace.straight;
        let len: f64 = self.pace.stretches.iter().map(|stretch| stretch.len).sum();
        let mut at = 0.0;
        for (k, (strip, stretch)) in self.strips.iter().zip(&mut self.pace.stretches).enumerate() {
            let begin = at;
            at += stretch.len;
            if strip.tolerance == 0.0 || at < first || begin > len - last {
                stretch.v = stretch.top;
                continue;
            }
            let moved = &self.moved[k..k + BAND];
            let bend = weighted(&strip.bend, moved);
            let mut acceleration: f64 = 0.0;
            for axis in 0..N {
                let bend = (strip.first_bend[axis] + bend[axis]).abs();
                acceleration = larger(acceleration, bend * inverse.acceleration[axis]);
            }
            let jerk = strip.jerk(moved, inverse);
            stretch.limit(jerk, acceleration);
        }
        self.pace.find();
    }

    /// Finds what every span takes of the jerk at its speed, or one near it does.
    pub fn find_loads(&mut self, inverse: &Inverse) {
        for (k, strip) in self.strips.iter_mut().enumerate() {
            let v = self.pace.stretches[k].v;
            let is_free = strip.tolerance > 0.0;
            strip.load =
                if is_free { strip.jerk(&self.moved[k..k + BAND], inverse) * v * v * v } else { 0.0 };
        }
        let pace = &self.pace;
        let fade = |load: &mut f64, (k, strip): (usize, &mut Strip<N>)| {
            let way = pace.stretches[k].len / (FADES * pace.reach(k)).max(f64::MIN_POSITIVE);
            // `exp(way)` about.
            *load = larger(*load / (1.0 + way * (1.0 + 0.5 * way)), strip.load);
            strip.load = *load;
        };
        let mut load = 0.0;
        self.strips.iter_mut().enumerate().for_each(|strip| fade(&mut load, strip));
        let mut load = 0.0;
        self.strips.iter_mut().enumerate().rev().for_each(|strip| fade(&mut load, strip));
    }

    /// What span `k` takes of the jerk, or one near it does.
    pub fn load(&self, k: usize) -> f64 {
        self.strips[k].load
    }

    /// Makes spans as stiff as their speed asks for: `ℓ` is `stiff` times what would spend tolerance and jerk alike. Before an end that
    /// is still `open`, it is no more than a share of what is known behind.
    pub fn stiffen(&mut self, open: bool, stiff: f64) {
        let mut known: f64 = self.pace.stretches.iter().map(|stretch| stretch.len).sum();
        for (k, strip) in self.strips.iter_mut().enumerate() {
            let len = self.pace.stretches[k].len;
            let most = if open { OPEN_SHARE * known } else { f64::INFINITY };
            known -= len;
            if strip.tolerance == 0.0 {
                continue;
            }
            let l = smaller(smaller(stiff * self.pace.reach(k), STIFFEST * len), most);
            let cube = l * l * l;
            strip.stiffen(cube * cube * len - strip.stiff, &mut self.sums[k..]);
        }
    }

    /// Makes slow spans stiffer that take more of the jerk than others, and the others softer: what holds a turn back is the
    /// most that is taken anywhere, not the sum of its squares. Again and again it would find the least most, if the speed
    /// stayed as it is; it does not, and once is quickest.
    ///
    /// Whether it changes anything.
    pub fn level(&mut self, inverse: &Inverse) -> bool {
        let (mut sum, mut len) = (0.0, 0.0);
        for (k, strip) in self.strips.iter_mut().enumerate() {
            let stretch = &self.pace.stretches[k];
            strip.load = 0.0;
            if strip.tolerance == 0.0 || !stretch.is_slow {
                continue;
            }
            let jerk = strip.jerk(&self.moved[k..k + BAND], inverse);
            strip.load = jerk * stretch.v * stretch.v * stretch.v;
            sum += strip.load * strip.load * stretch.len;
            len += stretch.len;
        }
        if !(sum > 0.0) {
            return false;
        }
        let mean = (sum / len).sqrt();
        for (k, strip) in self.strips.iter_mut().enumerate() {
            if strip.load > 0.0 {
                let [stiffer, softer] = MOST_LEVEL;
                let factor = (strip.load / mean).powf(LEVEL).clamp(softer.recip(), stiffer);
                strip.stiffen(strip.stiff * (factor - 1.0), &mut self.sums[k..]);
            }
        }
        true
    }

    /// Whether so much of the run is slow that its shape is worth more time.
    pub fn is_much_slow(&self) -> bool {
        let lengths = self.pace.stretches.iter().fold([0.0; 2], |[slow, all], stretch| {
            [slow + if stretch.is_slow { stretch.len } else { 0.0 }, all + stretch.len]
        });
        lengths[0] >= MUCH_SLOW * lengths[1]
    }

    /// Finds the control points again of which these spans have changed, and the others as far as they move by more than
    /// `least`: the spans of which some have moved.
    ///
    /// Rows of `L·D·Lᵀ` above the first that has changed stay as they are, and so do those below where three of them in a
    /// row have come out as they were.
    fn solve_about(&mut self, changed: Range<usize>, least: f64) -> Range<usize> {
        let total = self.controls.len();
        self.factors.truncate(ABOVE + total);
        self.factors.resize(ABOVE + total + BELOW, Row::ZERO);
        self.ways.resize(total, 0.0);
        let (mut end, mut same) = (total, 0);
        for i in changed.start..total {
            let Row { entries: [a0, a1, a2, a3], mut side } = self.row(i);
            let Some([farthest, far, near, own]) = self.factors[i..].first_chunk_mut() else { break };
            // Entries of `L·D`, then of `L`. What is known last, of the row above, comes last: the rows wait for each other.
            let ([d0, l01, l02, _], [d1, l11, ..], [d2, ..]) = (near.entries, far.entries, farthest.entries);
            let e3 = a3;
            let e2 = a2 - e3 * l11;
            let e1 = (a1 - e3 * l02) - e2 * l01;
            let (l1, l2, l3) = (e1 * d0, e2 * d1, e3 * d2);
            let d = (a0 - e3 * l3 - e2 * l2) - e1 * l1;
            let entries = [larger(d, f64::MIN_POSITIVE).recip(), l1, l2, l3];
            for axis in 0..N {
                let left = side[axis] - l3 * farthest.side[axis] - l2 * far.side[axis];
                side[axis] = left - l1 * near.side[axis];
            }
            let old = std::mem::replace(own, Row { entries, side });
            let is_same = i >= changed.end + BAND - 1
                && (entries[0] - old.entries[0]).abs() <= SAME * entries[0]
                && (1..BAND).all(|k| (entries[k] - old.entries[k]).abs() <= SAME)
                && (0..N).all(|axis| (side[axis] - old.side[axis]).abs() * entries[0] <= least);
            same = if is_same { same + 1 } else { 0 };
            if same == BAND - 1 {
                end = i + 1;
                break;
            }
        }
        let (mut begin, mut same) = (0, 0);
        for i in (0..end).rev() {
            let Some([own, near, far, farthest]) = self.factors[ABOVE + i..].first_chunk() else { break };
            let Some([to, low0, low1, low2]) = self.moved[i..].first_chunk_mut() else { break };
            let moved = std::array::from_fn(|axis| {
                let below = farthest.entries[3] * low2[axis] + far.entries[2] * low1[axis];
                (own.side[axis] * own.entries[0] - below) - near.entries[1] * low0[axis]
            });
            let by: [f64; N] = apart(moved, *to);
            *to = moved;
            let way = by.iter().map(|by| by.abs()).sum();
            self.ways[i] = way;
            let is_same = i < changed.start && by.iter().all(|by| by.abs() <= least);
            same = if is_same { same + 1 } else { 0 };
            if same == BAND - 1 {
                begin = i;
                break;
            }
        }
        // No place of a span moves further than the control point that moves the furthest.
        let spans = begin.saturating_sub(BAND - 1)..end.min(self.strips.len());
        // Nothing else has moved.
        self.ways[spans.start..begin].fill(0.0);
        self.ways[end..total.min(end + BAND)].fill(0.0);
        for (strip, ways) in self.strips[spans.clone()].iter_mut().zip(self.ways[spans.start..].windows(BAND))
        {
            strip.room -= ways.iter().fold(0.0, |most, way| larger(most, *way));
        }
        spans
    }

    /// Row `i` of the normal equations, in which control points that stand are not moved.
    #[inline]
    fn row(&self, i: usize) -> Row<N> {
        if !self.is_free[i] {
            return Row::STANDING;
        }
        let mut row = self.sums[i];
        for back in 1..BAND {
            if i.checked_sub(back).is_some_and(|k| !self.is_free[k]) {
                row.entries[back] = 0.0;
            }
        }
        row
    }

    /// Weighs more where the spline is far from the lines.
    pub fn press_all(&mut self) {
        self.all_move();
        self.press(self.pressure().closer, 1.0);
    }

    fn pressure(&self) -> Pressure {
        if self.is_much_slow() { PRESSURE_WHERE_SLOW } else { PRESSURE }
    }

    /// Weighs more where a span that has moved is far from the lines, by how far and a little `closer`, to this power: how far at
    /// most, as a share of the square of the limit.
    fn press(&mut self, closer: f64, power: f64) -> f64 {
        let mut most = 0.0_f64;
        self.pressed.clear();
        for k in self.moving.iter().cloned().flatten() {
            let strip = &mut self.strips[k];
            if strip.room > 0.0 {
                continue;
            }
            let moved = &self.moved[k..k + BAND];
            let [from, to] = strip.looks;
            let (mut nearest, mut closest) = (0.0_f64, 0.0_f64);
            for look in &mut self.looks[from..to] {
                let off = apart(weighted(&look.basis, moved), look.p);
                let square: f64 = off.iter().map(|off| off * off).sum();
                let over = square * look.close;
                (nearest, closest) = (larger(nearest, over), larger(closest, look.close));
                if over > 1.0 {
                    // The power, to its second term.
                    let beyond = over * closer * closer - 1.0;
                    let more = power * beyond * (1.0 + 0.5 * (power - 1.0) * beyond);
                    let more = look.weight * more.min(MOST_CLOSER - 1.0);
                    look.weight += more;
                    if let Some(sums) = self.sums[k..].first_chunk_mut() {
                        add(sums, more, &look.basis, &look.p);
                    }
                }
            }
            if nearest > 1.0 {
                most = larger(most, nearest);
                match self.pressed.last_mut() {
                    Some(spans) if k < spans.end + APART => spans.end = k + 1,
                    _ => self.pressed.push(k..k + 1),
                }
            }
            strip.room = (1.0 - nearest.sqrt()) / closest.sqrt();
        }
        most
    }
}

impl<const N: usize> Strip<N> {
    /// The largest share of the jerk of an axis that it takes at the speed 1, with its control points moved so.
    fn jerk(&self, moved: &[[f64; N]], inverse: &Inverse) -> f64 {
        let third = weighted(&self.third, moved);
        (0..N).fold(0.0_f64, |most, axis| {
            larger(most, (self.first_third[axis] + third[axis]).abs() * inverse.jerk[axis])
        })
    }

    /// Makes it stiffer by so much; `sums` are the rows from its first control point on.
    fn stiffen(&mut self, more: f64, sums: &mut [Row<N>]) {
        self.stiff += more;
        if let Some(sums) = sums.first_chunk_mut() {
            add(sums, more, &self.third, &self.first_third.map(|c| -c));
        }
    }
}

/// What the control points of a span are with these weights.
#[inline]
fn weighted<const N: usize>(g: &[f64; BAND], controls: &[[f64; N]]) -> [f64; N] {
    let [a, b, c, d] = controls else { return [0.0; N] };
    std::array::from_fn(|i| g[0] * a[i] + g[1] * b[i] + g[2] * c[i] + g[3] * d[i])
}

#[inline]
fn apart<const N: usize>(a: [f64; N], b: [f64; N]) -> [f64; N] {
    std::array::from_fn(|i| a[i] - b[i])
}

/// Adds `weight·|Σ gᵢ·cᵢ − p|²` to what is to be least: to the rows of these control points.
#[inline]
fn add<const N: usize>(rows: &mut [Row<N>; BAND], weight: f64, g: &[f64; BAND], p: &[f64; N]) {
    for (i, row) in rows.iter_mut().enumerate() {
        let share = weight * g[i];
        for back in 0..=i {
            row.entries[back] += share * g[i - back];
        }
        for axis in 0..N {
            row.side[axis] += share * p[axis];
        }
    }
}
