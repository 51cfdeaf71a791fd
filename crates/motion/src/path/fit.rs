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
//! Every span keeps its own sum of products, so a round costs what has changed in it: the places are looked at, and only
//! those that weigh more are added again.

// Only as many axes as move are looped over; their number is known when compiling.
#![allow(clippy::needless_range_loop)]

use crate::limits::Inverse;
use crate::path::pace::{Pace, Stretch};
use crate::quick::larger;
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
/// which takes more rounds.
#[derive(Clone, Copy, Debug)]
struct Pressure {
    closer: f64,
    harder: f64,
}

const PRESSURE: Pressure = Pressure { closer: 1.02, harder: 0.1 };
const PRESSURE_WHERE_SLOW: Pressure = Pressure { closer: 1.01, harder: 0.05 };
const MOST_CLOSER: f64 = 30.0;

/// It is close enough where it is beyond the limit by no more than this, as a share of its square.
const CLOSE_ENOUGH: f64 = 1.02;

/// A row of the equations that differs by no more than this share of itself is that of the round before.
const SAME: f64 = 1e-7;

/// A control point that moves by no more than this share of the tolerance has not moved in a round.
const NOT_MOVED: f64 = 1e-5;

/// `ℓ` is so many times what would spend both alike: the least of the squares still has more jerk in a turn than beside it.
const STIFF: f64 = 1.1;

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

/// What a span adds to the normal equations.
#[derive(Clone, Copy, Debug)]
struct Strip<const N: usize> {
    /// `gram[i][d]` is the sum of the products of the weights of its control points `i` and `i − d`, 0 where there is none;
    /// and their right sides.
    gram: [[f64; BAND]; BAND],
    side: [[f64; N]; BAND],
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
    /// Whether one of them weighs more than at first.
    is_pressed: bool,
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
    pub moved: Vec<[f64; N]>,
    pub is_free: Vec<bool>,
    looks: Vec<Look<N>>,
    strips: Vec<Strip<N>>,
    /// Those before knots were put in.
    old: Vec<Strip<N>>,
    /// How fast every span is run, about.
    pub pace: Pace,
    /// `rows[i][d]` is the entry of row `i` and column `i − d`.
    rows: Vec<[f64; BAND]>,
    sides: Vec<[f64; N]>,
    /// How far every control point was moved by the last solution, no less.
    ways: Vec<f64>,
}

impl<const N: usize> Fit<N> {
    /// For so many control points and places.
    pub fn new(controls: usize, looks: usize) -> Fit<N> {
        Fit {
            controls: Vec::with_capacity(controls),
            moved: Vec::with_capacity(controls),
            is_free: Vec::with_capacity(controls),
            looks: Vec::with_capacity(looks),
            strips: Vec::with_capacity(controls),
            old: Vec::with_capacity(controls),
            pace: Pace::new(controls),
            rows: Vec::with_capacity(controls),
            sides: Vec::with_capacity(controls),
            ways: Vec::with_capacity(controls),
        }
    }

    pub fn clear(&mut self) {
        self.controls.clear();
        self.moved.clear();
        self.is_free.clear();
        self.looks.clear();
        self.strips.clear();
        self.pace.stretches.clear();
    }

    /// The same, but spans may be taken over as they are ([`take_over`](Self::take_over)).
    pub fn clear_for_finer(&mut self) {
        self.controls.clear();
        self.moved.clear();
        self.is_free.clear();
        std::mem::swap(&mut self.strips, &mut self.old);
        self.strips.clear();
        self.pace.keep_stretches();
    }

    /// The next span is the old span `k`, unless that one is no more as it was at first. Whether it is.
    pub fn take_over(&mut self, k: usize) -> bool {
        let Some(strip) = self.old.get(k).filter(|strip| !strip.is_pressed) else { return false };
        // Control points are moved from the first ones again.
        self.strips.push(Strip { room: 0.0, ..*strip });
        self.pace.take_over(k);
        true
    }

    /// Sets the first control points.
    pub fn begin(&mut self, controls: impl Iterator<Item = [f64; N]>) {
        self.controls.extend(controls);
        self.moved.resize(self.controls.len(), [0.0; N]);
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
        let (gram, side) = ([[0.0; BAND]; BAND], [[0.0; N]; BAND]);
        let k = self.strips.len();
        let (first_third, first_bend) = (self.at_first(k, &third), self.at_first(k, &bend));
        let looks = [self.looks.len(); 2];
        self.strips.push(Strip {
            gram,
            side,
            third,
            bend,
            first_third,
            first_bend,
            stiff: 0.0,
            load: 0.0,
            tolerance,
            looks,
            is_pressed: false,
            room: 0.0,
        });
        if let Some(strip) = self.strips.last_mut() {
            strip.stiffen(stiff);
        }
        self.pace.stretches.push(stretch);
    }

    /// A place of the newest span that shall be within `limit` of `p`.
    #[inline]
    pub fn look_at(&mut self, basis: [f64; BAND], weight: f64, p: [f64; N], limit: f64) {
        let Some(k) = self.strips.len().checked_sub(1) else { return };
        let p = apart(p, self.at_first(k, &basis));
        let look = Look { basis, weight, close: (limit * limit).recip(), p };
        if let Some(strip) = self.strips.last_mut() {
            strip.press(&look, weight);
            self.looks.push(look);
            strip.looks[1] = self.looks.len();
        }
    }

    /// Span `k` shall go through `p`.
    pub fn tie(&mut self, k: usize, basis: [f64; BAND], weight: f64, p: [f64; N]) {
        let p = apart(p, self.at_first(k, &basis));
        let look = Look { basis, weight, close: 0.0, p };
        if let Some(strip) = self.strips.get_mut(k) {
            strip.press(&look, weight);
        }
    }

    /// Finds the control points that are free.
    pub fn solve(&mut self) {
        self.solve_about(0..self.strips.len(), 0.0);
    }

    /// The same again, with more weight where the spline is far from the lines, as long as it is. A round goes only as far as
    /// something changes.
    pub fn close(&mut self) {
        let mut spans = 0..self.strips.len();
        let pressure = self.pressure();
        for round in 0..=ROUNDS {
            let power = 1.0 + pressure.harder * round as f64;
            let (pressed, most) = self.press(spans, pressure.closer, power);
            if most <= CLOSE_ENOUGH || round == ROUNDS {
                if round > 0 {
                    self.solve();
                }
                return;
            }
            let least = self.strips[pressed.clone()]
                .iter()
                .map(|strip| strip.tolerance)
                .fold(f64::INFINITY, f64::min);
            spans = self.solve_about(pressed, NOT_MOVED * least);
        }
    }

    /// The tolerance of span `k`.
    pub fn tolerance(&self, k: usize) -> f64 {
        self.strips[k].tolerance
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
                acceleration = acceleration.max(bend * inverse.acceleration[axis]);
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
            let way = pace.stretches[k].len / (FADES * pace.reach(k, strip.tolerance)).max(f64::MIN_POSITIVE);
            // `exp(way)` about.
            *load = (*load / (1.0 + way * (1.0 + 0.5 * way))).max(strip.load);
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

    /// Makes spans as stiff as their speed asks for. Before an end that is still `open`, `ℓ` is no more than a share of what
    /// is known behind.
    pub fn stiffen(&mut self, open: bool) {
        let mut known: f64 = self.pace.stretches.iter().map(|stretch| stretch.len).sum();
        for (k, strip) in self.strips.iter_mut().enumerate() {
            let len = self.pace.stretches[k].len;
            let most = if open { OPEN_SHARE * known } else { f64::INFINITY };
            known -= len;
            if strip.tolerance == 0.0 {
                continue;
            }
            let l = (STIFF * self.pace.reach(k, strip.tolerance)).min(STIFFEST * len).min(most);
            let cube = l * l * l;
            strip.stiffen(cube * cube * len - strip.stiff);
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
        for strip in &mut self.strips {
            if strip.load > 0.0 {
                let [stiffer, softer] = MOST_LEVEL;
                let factor = (strip.load / mean).powf(LEVEL).clamp(softer.recip(), stiffer);
                strip.stiffen(strip.stiff * (factor - 1.0));
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
        self.rows.resize(total, [0.0; BAND]);
        self.sides.resize(total, [0.0; N]);
        self.ways.resize(total, 0.0);
        // The three rows and right sides above, the nearest first.
        let above = |k: usize| changed.start.checked_sub(k);
        let mut rows: [[f64; BAND]; 3] =
            std::array::from_fn(|k| above(k + 1).map_or([0.0; BAND], |i| self.rows[i]));
        let mut sides: [[f64; N]; 3] =
            std::array::from_fn(|k| above(k + 1).map_or([0.0; N], |i| self.sides[i]));
        let (mut end, mut same) = (total, 0);
        for i in changed.start..total {
            let ([a0, a1, a2, a3], mut side) = self.row(i);
            // Entries of `L·D`, then of `L`.
            let e3 = a3;
            let e2 = a2 - e3 * rows[1][1];
            let e1 = a1 - e2 * rows[0][1] - e3 * rows[0][2];
            let (l1, l2, l3) = (e1 * rows[0][0], e2 * rows[1][0], e3 * rows[2][0]);
            let d = a0 - e1 * l1 - e2 * l2 - e3 * l3;
            let row = [larger(d, f64::MIN_POSITIVE).recip(), l1, l2, l3];
            for axis in 0..N {
                side[axis] -= l1 * sides[0][axis] + l2 * sides[1][axis] + l3 * sides[2][axis];
            }
            let (old_row, old_side) = (&mut self.rows[i], &mut self.sides[i]);
            let is_same = i >= changed.end + BAND - 1
                && (row[0] - old_row[0]).abs() <= SAME * row[0]
                && (1..BAND).all(|k| (row[k] - old_row[k]).abs() <= SAME)
                && (0..N).all(|axis| (side[axis] - old_side[axis]).abs() * row[0] <= least);
            same = if is_same { same + 1 } else { 0 };
            (*old_row, *old_side) = (row, side);
            if same == BAND - 1 {
                end = i + 1;
                break;
            }
            rows = [row, rows[0], rows[1]];
            sides = [side, sides[0], sides[1]];
        }
        let below = |k: usize| (end + k < total).then_some(end + k);
        let mut rows: [[f64; BAND]; 3] =
            std::array::from_fn(|k| below(k).map_or([0.0; BAND], |i| self.rows[i]));
        let mut low: [[f64; N]; 3] = std::array::from_fn(|k| below(k).map_or([0.0; N], |i| self.moved[i]));
        let (mut begin, mut same) = (0, 0);
        for i in (0..end).rev() {
            let (row, side) = (&self.rows[i], &self.sides[i]);
            let moved = std::array::from_fn(|axis| {
                side[axis] * row[0]
                    - rows[0][1] * low[0][axis]
                    - rows[1][2] * low[1][axis]
                    - rows[2][3] * low[2][axis]
            });
            let by: [f64; N] = apart(moved, self.moved[i]);
            self.moved[i] = moved;
            let way = by.iter().map(|by| by.abs()).sum();
            self.ways[i] = way;
            let is_same = i < changed.start && by.iter().all(|by| by.abs() <= least);
            same = if is_same { same + 1 } else { 0 };
            if same == BAND - 1 {
                begin = i;
                break;
            }
            rows = [*row, rows[0], rows[1]];
            low = [moved, low[0], low[1]];
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

    /// Row `i` of the normal equations, the sum of what the spans add to it: its entries from the diagonal on to the left, and
    /// its right side. A control point that stands is not moved.
    #[inline]
    fn row(&self, i: usize) -> ([f64; BAND], [f64; N]) {
        let (mut row, mut side) = ([0.0; BAND], [0.0; N]);
        if !self.is_free[i] {
            return ([1.0, 0.0, 0.0, 0.0], side);
        }
        for own in (0..BAND).rev() {
            let Some(strip) = i.checked_sub(own).and_then(|k| self.strips.get(k)) else { continue };
            for back in 0..BAND {
                row[back] += strip.gram[own][back];
            }
            for axis in 0..N {
                side[axis] += strip.side[own][axis];
            }
        }
        for back in 1..BAND {
            if i.checked_sub(back).is_some_and(|k| !self.is_free[k]) {
                row[back] = 0.0;
            }
        }
        (row, side)
    }

    /// Weighs more where the spline is far from the lines.
    pub fn press_all(&mut self) {
        self.press(0..self.strips.len(), self.pressure().closer, 1.0);
    }

    fn pressure(&self) -> Pressure {
        if self.is_much_slow() { PRESSURE_WHERE_SLOW } else { PRESSURE }
    }

    /// Weighs more where one of these spans is far from the lines, by how far and a little `closer`, to this power: which are, and
    /// how far at most, as a share of the square of the limit.
    fn press(&mut self, spans: Range<usize>, closer: f64, power: f64) -> (Range<usize>, f64) {
        let (mut most, mut first, mut behind) = (0.0_f64, usize::MAX, 0);
        for k in spans {
            let strip = &mut self.strips[k];
            let moved = &self.moved[k..k + BAND];
            if strip.room > 0.0 {
                continue;
            }
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
                    strip.press(look, more);
                    strip.is_pressed = true;
                    most = most.max(over);
                    (first, behind) = (first.min(k), k + 1);
                }
            }
            strip.room = (1.0 - nearest.sqrt()) / closest.sqrt();
        }
        (first..behind, most)
    }
}

impl<const N: usize> Strip<N> {
    /// The largest share of the jerk of an axis that it takes at the speed 1, with its control points moved so.
    fn jerk(&self, moved: &[[f64; N]], inverse: &Inverse) -> f64 {
        let third = weighted(&self.third, moved);
        (0..N).fold(0.0_f64, |most, axis| {
            most.max((self.first_third[axis] + third[axis]).abs() * inverse.jerk[axis])
        })
    }

    /// Makes it stiffer by so much.
    fn stiffen(&mut self, more: f64) {
        self.stiff += more;
        add(&mut self.gram, &self.third, more);
        for i in 0..BAND {
            let share = more * self.third[i];
            for axis in 0..N {
                self.side[i][axis] -= share * self.first_third[axis];
            }
        }
    }

    /// Adds the place with this weight.
    #[inline]
    fn press(&mut self, look: &Look<N>, weight: f64) {
        add(&mut self.gram, &look.basis, weight);
        for i in 0..BAND {
            let share = weight * look.basis[i];
            for axis in 0..N {
                self.side[i][axis] += share * look.p[axis];
            }
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

/// Adds `weight·gᵢ·gⱼ`.
#[inline]
fn add(gram: &mut [[f64; BAND]; BAND], g: &[f64; BAND], weight: f64) {
    for i in 0..BAND {
        let share = weight * g[i];
        for back in 0..=i {
            gram[i][back] += share * g[i - back];
        }
    }
}
