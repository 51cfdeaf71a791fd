//! Valleys: where a curve is slower than what is before and behind, at the lowest time.
//!
//! The passes over steps ([`crate::timing::grid`]) bound every axis by the sum of the magnitudes of its three terms. On a
//! way into a curve and out of it these cancel: braking takes from the jerk what the growing curvature adds to it. Here a
//! valley between two places of a plan, at which the states stay as they are, is run in nearly the least time that the
//! true derivatives of the curve allow.
//!
//! **Variables** are `x = v²`, the control points of a quadratic B-spline over steps of their own, as in the passes.
//! Between the steps `k` and `k + 1`, of lengths `h`, it is
//!
//! ```text
//! X = (xₖ·hₖ₊₁ + xₖ₊₁·hₖ)/(hₖ + hₖ₊₁)      a = (xₖ₊₁ − xₖ)/(hₖ + hₖ₊₁)      j = √X·(aₖ − aₖ₋₁)/hₖ
//! ```
//!
//! and with the derivatives of the path there, signs included, each axis has
//!
//! ```text
//! −A ≤ q″·X + q′·a ≤ A          −J ≤ √X·(q‴·X + 3·q″·a + q′·j/√X) ≤ J          X ≤ cap
//! ```
//!
//! Without `√X` these are linear in `x` and each touches three neighbours at most. The time `Σ h/√x` is convex.
//!
//! **Method**: a primal-dual interior point method with slacks (Nocedal and Wright, Numerical Optimization, chapter 19):
//! with `c(x) ≥ 0` for each side of each bound, slacks `z` and multipliers `λ`, each iteration solves
//!
//! ```text
//! (∇²f + Σ λ/z·∇c·∇cᵀ)·dx = −∇f + Σ ∇c·(μ − λ·(c − z))/z
//! dz = ∇cᵀ·dx + c − z          dλ = (μ − λ·z − λ·dz)/z
//! ```
//!
//! whose matrix has two diagonals on either side, and goes as far as `z` and `λ` stay positive. What is left of the
//! curvature of `√X` would only make steps longer.
//!
//! What comes out is taken if it is faster and every piece of it keeps all bounds, looked at in nine places and wherever cells
//! meet; if not, once more with less where it did not. The plan before stands otherwise. So an iteration that goes astray costs time alone.
//!
//! **Windows** begin inside the one before. Its solution has used what there is, so in other steps, or with bounds that are a
//! thousandth tighter, there may be no way on from a state of it. Its steps are taken over, and its bounds as they were
//! tightened, and where it is on one that is loosened by as little: it is inside all of them then.

use crate::limits::{Inverse, Inverses};
use crate::path::shape::Shape;
use crate::quick::larger;
use crate::timing::piece::{Piece, ROUNDING, State};
use crate::timing::queue::{Node, Queue};
use ferrocut_geometry::AXES;

/// Most steps of a window of a valley.
const STEPS: usize = 160;

/// The last part of a window, one of so many, is of the next one too.
const OVERLAP: usize = 3;

/// A window that was not to be run within the bounds begins so many pieces earlier and has so many steps less, so many times.
const EARLIER: usize = 5;
const SHORTER: usize = 12;
const TRIES: usize = 2;

/// Pieces that there is room for.
const WAY: usize = 4096;

/// A step in time, s, and how far the path turns in it at most, rad.
const TAU: f64 = 0.004;
const TURN: f64 = 0.1;

/// A step may be so much shorter to end where cells meet, and so much to end where the third derivative jumps by more than
/// this share of itself.
const SHORT: f64 = 0.25;
const SHORTEST: f64 = 0.1;
const JUMP: f64 = 0.1;

/// Shares of acceleration and jerk that are used; the rest is for what lies between the places looked at.
const ACCELERATION_SHARE: f64 = 0.998;
const JERK_SHARE: f64 = 0.993;

/// Iterations at most, the share of the time that may be missing to the least, and what may be left of by how much slacks
/// and bounds differed.
const ITERATIONS: usize = 30;
const GAP: f64 = 2e-3;
const APART: f64 = 0.01;

/// Multipliers at first: the share of the time that all of them together are worth.
const FIRST_GAP: f64 = 0.3;

/// The same where bounds were tightened: little changes.
const NEXT_GAP: f64 = 4e-3;

/// Slacks at first, at least.
const FIRST_SLACK: f64 = 0.15;

/// Multipliers aimed at, of those there are: after a step that went nearly all its way, and after a shorter one.
const AIMS: [f64; 2] = [0.15, 0.3];

/// How close to zero slacks and multipliers go in an iteration.
const NEARLY: f64 = 0.98;

/// Where the sum of the products is so many times the time, there is no way within the bounds.
const ASTRAY: f64 = 10.0;

/// Where a bound is far, it is none: a valley gets no faster than this share of `x` is more, and less than this share of a bound
/// is used then.
const FASTER: f64 = 6.0;
const HARMLESS: f64 = 0.95;

/// How often it is tried with less where a piece was beyond its bounds, and with how much less: so many times what it was beyond
/// them, and a little, which is more each time. Where none is found the whole window is run by the plan before, up to a seventh
/// slower, and four times were not always enough.
const ROUNDS: usize = 8;
const LESS: f64 = 1.2;
const A_LITTLE: f64 = 5e-4;
const MORE_A_TIME: f64 = 2.0;
const MOST_MORE: f64 = 1.18;

/// How far inside its bounds a solution is that a window begins with.
const INSIDE: f64 = 3e-3;

/// In how many parts a piece is looked at, and in how many where one of them is nearly on a bound.
const PARTS: u8 = 4;
const FINE_PARTS: u8 = 8;
const NEARLY_ALL: f64 = 0.99;

/// What a curve takes of a bound somewhere in a window, if it is worth to be looked at.
const TAKEN: f64 = 0.25;

/// What is gained must be worth it.
const WORTH: f64 = 0.997;

/// Rows of a place: acceleration and jerk on both sides, of each axis and of the path, and the speed.
const ROWS: usize = 3 * (AXES + 1) + 1;

/// One bound, on both sides: `|√Xᵖ·(c₀x₀ + c₁x₁ + c₂x₂)| ≤ 1`.
#[derive(Clone, Copy, Debug, Default)]
struct Row {
    c: [f64; 3],
    /// Number of `x₀`.
    base: usize,
    /// Where it is looked at.
    place: usize,
    /// Where the place's own `x` is among the three, if the bound is one of jerk.
    root: Option<usize>,
    /// Slacks and multipliers of both sides, and `1/z`.
    z: [f64; 2],
    l: [f64; 2],
    inverse: [f64; 2],
    dz: [f64; 2],
    dl: [f64; 2],
    /// Value and gradient as of now.
    value: f64,
    g: [f64; 3],
}

/// What came of a window.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Outcome {
    Quicker,
    /// There is nothing to be gained.
    Same,
    /// It would have been quicker, but not within the bounds.
    Broken,
}

/// What came of the iterations.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Solution {
    Found,
    /// It would not be worth it.
    Worthless,
    /// There is none within the bounds.
    None,
}

/// Memory for one valley.
#[derive(Debug)]
pub(crate) struct Valley {
    /// Lengths of the steps; one more on either side than there are.
    h: Vec<f64>,
    /// Where they begin.
    s: Vec<f64>,
    x: Vec<f64>,
    /// How much more than it does a place is to count.
    more: Vec<f64>,
    rows: Vec<Row>,
    speeds: Vec<[f64; 3]>,
    /// Diagonals of the matrix, and the right side.
    band: Vec<[f64; 3]>,
    right: Vec<f64>,
    pieces: Vec<Piece>,
    /// The whole way, as far as it is found.
    way: Vec<Piece>,
    /// How much bounds were tightened where each of its pieces begins; 0 where that is one of the plan and no step.
    tight: Vec<f64>,
    /// The same at the places of the window, of whose steps the first so many are taken over.
    tighter: Vec<f64>,
    taken: usize,
}

impl Valley {
    pub fn new() -> Valley {
        Valley {
            h: Vec::with_capacity(STEPS + 2),
            s: Vec::with_capacity(STEPS + 2),
            x: Vec::with_capacity(STEPS + 2),
            more: Vec::with_capacity(STEPS + 2),
            rows: Vec::with_capacity(ROWS * (STEPS + 1)),
            speeds: Vec::with_capacity(STEPS + 2),
            band: Vec::with_capacity(STEPS + 2),
            right: Vec::with_capacity(STEPS + 2),
            pieces: Vec::with_capacity(STEPS),
            way: Vec::with_capacity(WAY),
            tight: Vec::with_capacity(WAY),
            tighter: Vec::with_capacity(STEPS + 2),
            taken: 0,
        }
    }

    /// The same way as `plan`, which begins in cell `first`, in less time; `cap` is the speed allowed in a cell, curves
    /// aside. `false` where no less is found; else it is in [`pieces`](Self::pieces), which are no more than `most`.
    ///
    /// What is longer than its steps is run window by window. Each begins inside the one before, so that the state at the
    /// end of that one, which was the plan's, does not stay.
    pub fn run(
        &mut self,
        queue: &Queue,
        inverses: &Inverses,
        plan: &[Piece],
        first: u64,
        most: usize,
        cap: impl Fn(&Node) -> f64,
    ) -> bool {
        let road = Road { queue, inverses, cap };
        self.way.clear();
        self.way.extend_from_slice(plan);
        self.tight.clear();
        self.tight.resize(plan.len(), 0.0);
        let (mut from, mut cell, mut found, mut tries) = (0, first, false, 0);
        // Where the window began that is tried.
        let mut origin = f64::NEG_INFINITY;
        while from < self.way.len() && self.way.len() + STEPS < most {
            if tries == 0 {
                origin = self.way[from].s;
            }
            cell = road.cell(cell, self.way[from].s);
            let Some(count) = self.place(&road, from, cell, STEPS - SHORTER * tries) else { break };
            let is_last = from + count == self.way.len();
            let outcome = self.window(&road, from..from + count, cell);
            let mut new = count;
            match outcome {
                Outcome::Quicker => {
                    new = self.pieces.len();
                    self.way.splice(from..from + count, self.pieces.iter().copied());
                    self.tight.splice(from..from + count, self.tighter[..new].iter().copied());
                    found = true;
                }
                // The states that it begins and ends with may be such that they hardly leave a choice.
                Outcome::Broken if tries < TRIES && (from > 0 || !is_last) => {
                    tries += 1;
                    from = from.saturating_sub(EARLIER);
                    cell = first;
                    continue;
                }
                Outcome::Broken | Outcome::Same => {}
            }
            tries = 0;
            if is_last {
                break;
            }
            from += new - (new / OVERLAP).min(new - 1);
            // On and on, wherever the window began in the end.
            while self.way.get(from).is_some_and(|piece| piece.s <= origin) {
                from += 1;
            }
        }
        found
    }

    /// Runs these pieces, for which steps are set, in less time, if that is possible.
    fn window(
        &mut self,
        road: &Road<'_, impl Fn(&Node) -> f64>,
        range: std::ops::Range<usize>,
        first: u64,
    ) -> Outcome {
        let time = |pieces: &[Piece]| pieces.iter().map(|piece| piece.time).sum::<f64>();
        let plan = &self.way[range.clone()];
        let (from, to, before) = (plan[0].from, plan[plan.len() - 1].to, time(plan));
        if !plan_bends(road, plan, first) {
            return Outcome::Same;
        }
        self.begin(range, from, to);
        self.bound(road, first);
        self.loosen();
        let planned = self.slacken();
        let mut little = A_LITTLE;
        for round in 0..ROUNDS {
            let solution = self.solve(planned, if round == 0 { FIRST_GAP } else { NEXT_GAP });
            if solution == Solution::Worthless {
                return Outcome::Same;
            }
            if !self.cut(from, to) {
                return Outcome::Broken;
            }
            // With less of the bounds it is no faster.
            if !(time(&self.pieces) < WORTH * before) {
                return Outcome::Same;
            }
            if self.keeps(road, first, little) {
                return Outcome::Quicker;
            }
            if solution == Solution::None {
                break;
            }
            little *= MORE_A_TIME;
        }
        Outcome::Broken
    }

    /// What was found.
    pub fn way(&self) -> &[Piece] {
        &self.way
    }

    /// Sets no more than `most` steps, for as many of the pieces from `from` on as there are steps for: how many. `None` if that
    /// are too few.
    fn place(
        &mut self,
        road: &Road<'_, impl Fn(&Node) -> f64>,
        from: usize,
        first: u64,
        most: usize,
    ) -> Option<usize> {
        let plan = &self.way[from..];
        let (begin, mut end) = (plan[0].s, plan[plan.len() - 1].end());
        let mut count = plan.len();
        let (mut s, mut cell, mut k) = (begin, first, 0);
        self.s.clear();
        self.h.clear();
        self.tighter.clear();
        self.taken = 0;
        // One more before and behind, as long as its neighbour.
        self.h.push(0.0);
        while s < end {
            if self.s.len() == most {
                // The window ends with the last piece that ends before; a step that would be short belongs to the one before.
                count = k;
                end = plan[k.checked_sub(1)?].end();
                while self.s.len() > 1 && self.s[self.s.len() - 1] + 0.5 * self.h[self.h.len() - 1] > end {
                    self.s.pop();
                    self.h.pop();
                    self.tighter.pop();
                }
                let last = self.h.len() - 1;
                self.h[last] = end - self.s[self.s.len() - 1];
                break;
            }
            while k + 1 < plan.len() && plan[k].end() <= s {
                k += 1;
            }
            if self.tight[from + k] > 0.0 {
                self.s.push(s);
                self.h.push(plan[k].h);
                self.tighter.push(self.tight[from + k]);
                self.taken = self.s.len();
                s = if k + 1 < plan.len() { plan[k].end() } else { end };
                continue;
            }
            cell = road.cell(cell, s);
            let derivatives = road.derivatives(cell, s);
            let norm = |d: &[f64; AXES]| d.iter().map(|c| c * c).sum::<f64>().sqrt();
            let turn = norm(&derivatives[1]) / norm(&derivatives[0]).max(1e-9);
            let mut h = TAU * speed(plan, k, s);
            h = h.min(TAU * speed(plan, k, (s + h).min(end)).max(0.3 * h / TAU));
            h = h.min(TURN / turn.max(1e-9)).max(1e-6);
            // It ends where the path changes, if that is about there, and does not reach over a jump.
            let (mut to, mut next) = (s + h, cell);
            while next + 1 < road.queue.tail() && road.queue.node(next).end() <= s + 1.3 * h {
                let border = road.queue.node(next).end();
                let jumps = border > s + SHORTEST * h && road.jumps(next);
                if jumps || border >= s + SHORT * h {
                    to = border;
                }
                if jumps {
                    break;
                }
                next += 1;
            }
            if to > end - 0.5 * h {
                to = end;
            }
            self.s.push(s);
            self.h.push(to - s);
            self.tighter.push(1.0);
            s = to;
        }
        self.s.push(end);
        self.tighter.push(1.0);
        let n = self.h.len();
        if n < 5 {
            return None;
        }
        self.h[0] = self.h[1];
        self.h.push(self.h[n - 1]);
        Some(count)
    }

    /// The plan as it is: the first two and the last two of `x` are what the states at the ends say.
    fn begin(&mut self, range: std::ops::Range<usize>, from: State, to: State) {
        let plan = &self.way[range.clone()];
        let tight = &self.tight[range];
        let n = self.h.len();
        self.x.clear();
        self.x.resize(n, 0.0);
        let mut k = 0;
        for i in 1..n - 1 {
            let s = self.s[i - 1] + 0.5 * self.h[i];
            while k + 1 < plan.len() && plan[k].end() <= s {
                k += 1;
            }
            self.x[i] = if tight[k] > 0.0 {
                let State { v, a } = plan[k].from;
                v * v + a * self.h[i]
            } else {
                speed(plan, k, s).powi(2)
            };
        }
        let (w, h) = (from.v * from.v, self.h[1]);
        (self.x[0], self.x[1]) = (w - from.a * h, w + from.a * h);
        let (w, h) = (to.v * to.v, self.h[n - 2]);
        (self.x[n - 2], self.x[n - 1]) = (w - to.a * h, w + to.a * h);
    }

    /// The bounds at all places, in the order of the control points that they begin with.
    fn bound(&mut self, road: &Road<'_, impl Fn(&Node) -> f64>, first: u64) {
        self.rows.clear();
        let places = self.s.len();
        let mut cell = first;
        let mut cap_cell = first;
        for k in 0..places {
            let s = self.s[k];
            cell = road.cell(cell, s);
            let node = road.queue.node(cell);
            let inverse = road.inverses.of(node.class);
            // A border belongs to both sides.
            let left = if s <= node.s + 1e-12 && k > 0 { road.side_before(cell, s) } else { cell };
            let here = road.derivatives(cell, s);
            let there = if left == cell { here } else { road.derivatives(left, s) };
            let (h0, h1) = (self.h[k], self.h[k + 1]);
            let both = h0 + h1;
            // X and a by x of both steps.
            let (x, a) = ([h1 / both, h0 / both], [-1.0 / both, 1.0 / both]);
            let is_inner = k > 0 && k + 1 < places;
            // Acceleration behind minus acceleration before, over the length of the step on either side.
            let left_push = (k > 0).then(|| {
                let (a0, h) = (1.0 / (self.h[k - 1] + h0), h0);
                // a of the place before: (x₁ − x₀)·a0.
                [a0 / h, (a[0] - a0) / h, a[1] / h]
            });
            let right_push = (k + 1 < places).then(|| {
                let (a1, h) = (1.0 / (h1 + self.h[k + 2]), h1);
                [-a[0] / h, (-a1 - a[1]) / h, a1 / h]
            });
            // More than the path can do here: what stays below its bounds then is none.
            let v = (FASTER * self.at(k).0).max(0.0).sqrt();
            let [a_most, j_most] = most_along([&there, &here], inverse, v);
            // On a line the end of a step at which it is faster decides.
            let is_line = |d: &[[f64; AXES]; 3]| d[1..].iter().flatten().all(|c| *c == 0.0);
            let has_left = !is_line(&there) || (k > 0 && self.at(k).0 >= self.at(k - 1).0);
            let has_right = !is_line(&here) || (k + 1 < places && self.at(k).0 >= self.at(k + 1).0);
            let is_harmful = |[d1, d2, d3]: [f64; 3], jmax: f64| {
                ((d3.abs() * v * v + 3.0 * d2.abs() * a_most) * v + d1.abs() * j_most) * jmax > HARMLESS
            };
            let of =
                |d: &[[f64; AXES]; 3], i: usize| if i < AXES { d.map(|d| d[i]) } else { [1.0, 0.0, 0.0] };
            for i in 0..=AXES {
                let jmax = if i < AXES { inverse.jerk[i] } else { inverse.along[1] } / JERK_SHARE;
                let [e1, e2, e3] = of(&there, i);
                if let Some(push) = left_push.filter(|_| has_left && is_harmful([e1, e2, e3], jmax)) {
                    let c = [
                        e1 * push[0] * jmax,
                        (e3 * x[0] + 3.0 * e2 * a[0] + e1 * push[1]) * jmax,
                        (e3 * x[1] + 3.0 * e2 * a[1] + e1 * push[2]) * jmax,
                    ];
                    self.rows.push(Row { c, place: k, base: k - 1, root: Some(1), ..Row::default() });
                }
            }
            // Between three of them the spline lies below the highest.
            if (2..self.x.len() - 2).contains(&k) {
                let (begin, end) = (self.s[k - 2], self.s[k + 1]);
                cap_cell = road.cell(cap_cell, begin);
                let cap = road.least_cap(cap_cell, end);
                if FASTER * self.x[k] > cap * cap {
                    self.rows.push(Row {
                        c: [1.0 / (cap * cap), 0.0, 0.0],
                        place: k,
                        base: k,
                        ..Row::default()
                    });
                }
            }
            for i in 0..=AXES {
                let (amax, jmax) = if i < AXES {
                    (inverse.acceleration[i] / ACCELERATION_SHARE, inverse.jerk[i] / JERK_SHARE)
                } else {
                    (inverse.along[0] / ACCELERATION_SHARE, inverse.along[1] / JERK_SHARE)
                };
                let [d1, d2, d3] = of(&here, i);
                if is_inner && (d2.abs() * v * v + d1.abs() * a_most) * amax > HARMLESS {
                    let c = [(d2 * x[0] + d1 * a[0]) * amax, (d2 * x[1] + d1 * a[1]) * amax, 0.0];
                    self.rows.push(Row { c, place: k, base: k, ..Row::default() });
                }
                if let Some(push) = right_push.filter(|_| has_right && is_harmful([d1, d2, d3], jmax)) {
                    let c = [
                        (d3 * x[0] + 3.0 * d2 * a[0] + d1 * push[0]) * jmax,
                        (d3 * x[1] + 3.0 * d2 * a[1] + d1 * push[1]) * jmax,
                        d1 * push[2] * jmax,
                    ];
                    self.rows.push(Row { c, place: k, base: k, root: Some(0), ..Row::default() });
                }
            }
        }
    }

    /// Bounds as tight as they were for the steps that are taken over, and looser where what was found there is on one of them.
    fn loosen(&mut self) {
        if self.taken == 0 {
            return;
        }
        for row in &mut self.rows {
            let tighter = self.tighter[row.place];
            row.c = row.c.map(|c| c * tighter);
        }
        self.look(|_| ());
        for row in self.rows.iter_mut().filter(|row| row.base + 2 <= self.taken) {
            let looser = ((1.0 - INSIDE) / row.value.abs()).min(1.0);
            row.c = row.c.map(|c| c * looser);
        }
    }

    /// `X` at the place between the steps `k` and `k + 1`, and what both steps weigh in it.
    fn at(&self, k: usize) -> (f64, [f64; 2]) {
        let (h0, h1) = (self.h[k], self.h[k + 1]);
        let weights = [h1 / (h0 + h1), h0 / (h0 + h1)];
        (self.x[k] * weights[0] + self.x[k + 1] * weights[1], weights)
    }

    /// Value and gradient of every bound as of now; `each` is asked of every row before.
    fn look(&mut self, mut each: impl FnMut(&mut Row)) {
        let Valley { x, h, rows, speeds, .. } = self;
        // Speed between the steps, and what the control points before and behind bear on it.
        speeds.clear();
        speeds.extend(x.windows(2).zip(h.windows(2)).map(|(x, h)| {
            let both = (h[0] + h[1]).recip();
            let v = ((x[0] * h[1] + x[1] * h[0]) * both).max(1e-12).sqrt();
            let share = 0.5 * both / v;
            [v, h[1] * share, h[0] * share]
        }));
        for row in rows {
            each(row);
            let x = &x[row.base..row.base + 3];
            let line = row.c[0] * x[0] + row.c[1] * x[1] + row.c[2] * x[2];
            (row.value, row.g) = (line, row.c);
            if let Some(root) = row.root {
                let [v, before, behind] = speeds[row.base + root];
                row.value *= v;
                row.g = row.c.map(|c| c * v);
                row.g[root] += line * before;
                row.g[root + 1] += line * behind;
            }
        }
    }

    /// Slacks and multipliers that are positive, at the plan as it is; the time that it takes by its control points.
    fn slacken(&mut self) -> f64 {
        let planned: f64 = (1..self.x.len() - 1).map(|i| self.h[i] / self.x[i].max(1e-12).sqrt()).sum();
        let mu = self.mu(FIRST_GAP * planned);
        self.look(|_| ());
        for row in &mut self.rows {
            row.z = [1.0 - row.value, 1.0 + row.value].map(|z| z.max(FIRST_SLACK));
            row.l = row.z.map(|z| mu / z);
        }
        planned
    }

    /// What each product of slack and multiplier is when all together are `sum`.
    fn mu(&self, sum: f64) -> f64 {
        sum / (2.0 * self.rows.len() as f64)
    }

    /// The interior point method from what is known, first with a sum of products of the share `gap` of the time `planned`.
    fn solve(&mut self, planned: f64, gap: f64) -> Solution {
        let n = self.x.len();
        let mut sum = gap * planned;
        let mut mu = self.mu(sum);
        self.look(|_| ());
        // How much of what slacks and bounds differed by is left.
        let mut apart = 1.0;
        for _ in 0..ITERATIONS {
            let now = self.assemble(mu);
            // No more than the gap is to be gained.
            if now - sum > WORTH * planned {
                return Solution::Worthless;
            }
            if !self.eliminate() {
                return Solution::None;
            }
            // Where it leads, as far as slacks and multipliers stay positive.
            let mut far = 1.0_f64;
            for i in 2..n - 2 {
                if self.right[i] < 0.0 {
                    far = far.min(-0.7 * self.x[i] / self.right[i]);
                }
            }
            let (mut most, mut far_l) = ([0.0_f64; 2], 1.0_f64);
            let right = &self.right;
            for row in &mut self.rows {
                let d = &right[row.base..row.base + 3];
                let d = row.g[0] * d[0] + row.g[1] * d[1] + row.g[2] * d[2] + row.value;
                let c = [1.0 - d, 1.0 + d];
                for side in 0..2 {
                    let (z, l, inverse) = (row.z[side], row.l[side], row.inverse[side]);
                    let dz = c[side] - z;
                    row.dz[side] = dz;
                    row.dl[side] = (mu - l * dz) * inverse - l;
                    most[side] = most[side].max(-dz * inverse);
                }
                for (l, dl) in row.l.iter().zip(row.dl) {
                    if dl < -NEARLY * l {
                        far_l = far_l.min(-NEARLY * l / dl);
                    }
                }
            }
            far = far.min(NEARLY / most[0].max(most[1]).max(NEARLY));
            for i in 2..n - 2 {
                self.x[i] += far * self.right[i];
            }
            let mut sums = [0.0; 2];
            self.look(|row| {
                for (side, sum) in sums.iter_mut().enumerate() {
                    row.z[side] += far * row.dz[side];
                    row.l[side] += far_l * row.dl[side];
                    *sum += row.z[side] * row.l[side];
                }
            });
            sum = sums[0] + sums[1];
            apart *= 1.0 - far;
            if apart < APART && sum < GAP * planned {
                break;
            }
            if sum > ASTRAY * planned {
                return Solution::None;
            }
            mu = AIMS[usize::from(far.min(far_l) <= 0.8)] * self.mu(sum);
        }
        Solution::Found
    }

    /// The matrix and the right side; the time that it takes as it is.
    fn assemble(&mut self, mu: f64) -> f64 {
        let n = self.x.len();
        let mut time = 0.0;
        self.band.clear();
        self.right.clear();
        for i in 0..n {
            let inverse = self.x[i].max(1e-12).recip();
            let own = self.h[i] * inverse.sqrt();
            let slow = own * inverse;
            // Before and behind the steps there is one more each.
            if i > 0 && i + 1 < n {
                time += own;
            }
            self.band.push([0.75 * slow * inverse, 0.0, 0.0]);
            self.right.push(0.5 * slow);
        }
        // Rows that begin with the same control point stand together: their sums need not go through the matrix one by one.
        let (mut base, mut sums) = (0, [0.0; 9]);
        for row in &mut self.rows {
            if row.base != base {
                pour(&mut self.band, &mut self.right, base, sums);
                (base, sums) = (row.base, [0.0; 9]);
            }
            row.inverse = row.z.map(f64::recip);
            let (c, mut weights, mut pushes) = ([1.0 - row.value, 1.0 + row.value], [0.0; 2], [0.0; 2]);
            for side in 0..2 {
                let inverse = row.inverse[side];
                weights[side] = row.l[side] * inverse;
                pushes[side] = mu * inverse - weights[side] * (c[side] - row.z[side]);
            }
            let (weight, push) = (weights[0] + weights[1], pushes[1] - pushes[0]);
            let [g0, g1, g2] = row.g;
            let [w0, w1, w2] = row.g.map(|g| weight * g);
            for (sum, more) in sums.iter_mut().zip([
                w0 * g0,
                w1 * g1,
                w2 * g2,
                w0 * g1,
                w1 * g2,
                w0 * g2,
                push * g0,
                push * g1,
                push * g2,
            ]) {
                *sum += more;
            }
        }
        pour(&mut self.band, &mut self.right, base, sums);
        // What is given stays.
        for i in [0, 1, n - 2, n - 1] {
            self.band[i][0] = 1e30;
            self.right[i] = 0.0;
        }
        time
    }

    /// Solves `L·D·Lᵀ·dx = right` in place.
    fn eliminate(&mut self) -> bool {
        // What the rows above take from this one and the next: of the diagonal, the one beside it and the right side.
        let (mut own, mut next) = ([0.0; 3], [0.0; 3]);
        for (band, right) in self.band.iter_mut().zip(&mut self.right) {
            let [d, e, f] = [band[0] - own[0], band[1] - own[1], band[2]];
            if !(d > 0.0) {
                return false;
            }
            let inverse = d.recip();
            let (l1, l2) = (e * inverse, f * inverse);
            *right -= own[2];
            own = [next[0] + l1 * e, l1 * f, next[2] + l1 * *right];
            next = [l2 * f, 0.0, l2 * *right];
            *band = [inverse, l1, l2];
        }
        let mut below = [0.0; 2];
        for (band, right) in self.band.iter().zip(&mut self.right).rev() {
            *right = *right * band[0] - band[1] * below[0] - band[2] * below[1];
            below = [*right, below[0]];
        }
        true
    }

    /// The pieces between the places. `false` if there is one that goes back.
    fn cut(&mut self, from: State, to: State) -> bool {
        self.pieces.clear();
        let mut state = from;
        for k in 1..self.s.len() {
            let next = if k + 1 == self.s.len() {
                to
            } else {
                let a = (self.x[k + 1] - self.x[k]) / (self.h[k] + self.h[k + 1]);
                State { v: self.at(k).0.max(0.0).sqrt(), a }
            };
            let piece = Piece::new(self.s[k - 1], self.h[k], state, next).filter(Piece::is_forward);
            let Some(piece) = piece else { return false };
            self.pieces.push(piece);
            state = next;
        }
        true
    }

    /// Whether every piece keeps all bounds; where not, the bounds at its ends are tightened, by at least a little.
    fn keeps(&mut self, road: &Road<'_, impl Fn(&Node) -> f64>, first: u64, little: f64) -> bool {
        let mut is_good = true;
        let mut cell = first;
        self.more.clear();
        self.more.resize(self.s.len(), 1.0);
        for k in 0..self.pieces.len() {
            let used = road.most_used(&self.pieces[k], &mut cell);
            if !(used <= ROUNDING) {
                is_good = false;
                let more = (1.0 + LESS * (used - 1.0) + little).min(MOST_MORE);
                self.more[k] *= more;
                self.more[k + 1] *= more;
            }
        }
        if !is_good {
            for (tighter, more) in self.tighter.iter_mut().zip(&self.more) {
                *tighter *= more;
            }
            for row in &mut self.rows {
                let more = self.more[row.place];
                row.c = row.c.map(|c| c * more);
            }
        }
        is_good
    }
}

/// Adds the sums of the rows that begin with `base`: of the diagonal, the one beside it, the outer one and the right side.
fn pour(band: &mut [[f64; 3]], right: &mut [f64], base: usize, sums: [f64; 9]) {
    let [a0, a1, a2, b0, b1, c, r @ ..] = sums;
    let [x, y, z] = &mut band[base..base + 3] else { return };
    *x = [x[0] + a0, x[1] + b0, x[2] + c];
    *y = [y[0] + a1, y[1] + b1, y[2]];
    z[0] += a2;
    for (right, r) in right[base..base + 3].iter_mut().zip(r) {
        *right += r;
    }
}

/// Highest acceleration and jerk along the path where it is no faster than `v`, by its derivatives on both sides: an axis has what its
/// bounds leave it, and as much more as the curve takes the other way.
fn most_along(sides: [&[[f64; AXES]; 3]; 2], inverse: &Inverse, v: f64) -> [f64; 2] {
    let [mut a, mut j] = inverse.along.map(|inverse| inverse.max(1e-12).recip());
    let most =
        |derivative: usize, i: usize| larger(sides[0][derivative][i].abs(), sides[1][derivative][i].abs());
    let axes =
        |inverse: &[f64; AXES]| -> [f64; AXES] { std::array::from_fn(|i| sides[1][0][i].abs() * inverse[i]) };
    for (i, share) in axes(&inverse.acceleration).into_iter().enumerate().filter(|(_, share)| *share > 0.0) {
        a = a.min((1.0 + most(1, i) * v * v * inverse.acceleration[i]) / share);
    }
    for (i, share) in axes(&inverse.jerk).into_iter().enumerate().filter(|(_, share)| *share > 0.0) {
        let curve = (most(2, i) * v * v + 3.0 * most(1, i) * a) * v;
        j = j.min((1.0 + curve * inverse.jerk[i]) / share);
    }
    [a, j]
}

/// Whether somewhere a curve takes a share of the bounds that could be shared better.
fn plan_bends(road: &Road<'_, impl Fn(&Node) -> f64>, plan: &[Piece], first: u64) -> bool {
    let mut cell = first;
    plan.iter().any(|piece| {
        cell = road.cell(cell, piece.s);
        road.queue.node(cell).load.taken(piece.from.v, piece.from.a.abs()) > TAKEN
    })
}

/// Speed at the length `s` of the plan, in its piece `k` or one behind.
fn speed(plan: &[Piece], mut k: usize, s: f64) -> f64 {
    while k + 1 < plan.len() && plan[k].end() <= s {
        k += 1;
    }
    let piece = &plan[k];
    let (w0, w1) = (piece.from.v * piece.from.v, piece.to.v * piece.to.v);
    let u = ((s - piece.s) / piece.h).clamp(0.0, 1.0);
    // Hermite's cubic through both states.
    let (d0, d1) = (2.0 * piece.from.a * piece.h, 2.0 * piece.to.a * piece.h);
    let left = 1.0 - u;
    let w = left * left * ((1.0 + 2.0 * u) * w0 + u * d0) + u * u * ((1.0 + 2.0 * left) * w1 - left * d1);
    w.max(0.25 * w0.min(w1)).max(1e-12).sqrt()
}

/// Whether a piece keeps all bounds by the true derivatives; it begins in `cell`, which goes on to where it ends.
pub(crate) fn keeps(
    queue: &Queue,
    inverses: &Inverses,
    piece: &Piece,
    cell: &mut u64,
    cap: impl Fn(&Node) -> f64,
) -> bool {
    piece.is_forward() && Road { queue, inverses, cap }.most_used(piece, cell) <= ROUNDING
}

/// What a valley lies on.
struct Road<'a, C: Fn(&Node) -> f64> {
    queue: &'a Queue,
    inverses: &'a Inverses,
    cap: C,
}

impl<C: Fn(&Node) -> f64> Road<'_, C> {
    /// The cell in which `s` lies, from `cell` on.
    fn cell(&self, mut cell: u64, s: f64) -> u64 {
        while cell + 1 < self.queue.tail() && self.queue.node(cell).end() <= s + 1e-12 {
            cell += 1;
        }
        cell
    }

    /// The cell before the border of `cell` at `s` that has a length.
    fn side_before(&self, cell: u64, s: f64) -> u64 {
        let mut side = cell;
        while side > self.queue.head() && self.queue.node(side).s >= s - 1e-12 {
            side -= 1;
        }
        side
    }

    /// `q′`, `q″` and `q‴` at `s`, which lies in `cell`.
    fn derivatives(&self, cell: u64, s: f64) -> [[f64; AXES]; 3] {
        let node = self.queue.node(cell);
        self.queue.cell(cell).derivatives((s - node.s).clamp(0.0, node.len), node.len)
    }

    /// Whether the third derivative jumps behind `cell`. Slices are of one arc as a rule.
    fn jumps(&self, cell: u64) -> bool {
        let shape = |cell: u64| &self.queue.cell(cell).shape;
        if let (Shape::Slice(..), Shape::Slice(..)) = (shape(cell), shape(cell + 1)) {
            return false;
        }
        let border = self.queue.node(cell).end();
        let (before, behind) = (self.derivatives(cell, border)[2], self.derivatives(cell + 1, border)[2]);
        let norm = |d: [f64; AXES]| d.iter().map(|c| c * c).sum::<f64>();
        let jump = std::array::from_fn(|i| behind[i] - before[i]);
        norm(jump) > JUMP * JUMP * norm(before).max(norm(behind))
    }

    /// Lowest speed allowed, curves aside, from cell `from` to the length `to`.
    fn least_cap(&self, from: u64, to: f64) -> f64 {
        let mut least = f64::MAX.sqrt();
        for cell in from..self.queue.tail() {
            let node = self.queue.node(cell);
            if node.s >= to && cell > from {
                break;
            }
            least = least.min((self.cap)(node));
        }
        least
    }

    /// Largest share of a bound that a piece uses, which begins in `cell` or behind it.
    fn most_used(&self, piece: &Piece, cell: &mut u64) -> f64 {
        *cell = self.cell(*cell, piece.s);
        let used_at = |part: u8, of: u8| {
            let (s, state, j) = piece.state(f64::from(part) / f64::from(of) * piece.time);
            let at = self.cell(*cell, s.min(piece.end() - 1e-9));
            self.used(at, s, state, j)
        };
        let mut used = (0..=PARTS).map(|part| used_at(part, PARTS)).fold(0.0, f64::max);
        if used > NEARLY_ALL {
            let between = (1..FINE_PARTS).step_by(2).map(|part| used_at(part, FINE_PARTS));
            used = between.fold(used, f64::max);
        }
        // Where cells meet inside it the derivatives may jump.
        loop {
            let border = self.queue.node(*cell).end();
            if border >= piece.end() - 1e-9 || *cell + 1 >= self.queue.tail() {
                return used;
            }
            if border > piece.s + 1e-9 {
                let (s, state, j) = piece.state(piece.time_at(border));
                used = used.max(self.used(*cell, s, state, j)).max(self.used(*cell + 1, s, state, j));
            }
            *cell += 1;
        }
    }

    /// Largest share of a bound that is used at `s`.
    fn used(&self, cell: u64, s: f64, state: State, j: f64) -> f64 {
        let node = self.queue.node(cell);
        let inverse = self.inverses.of(node.class);
        let [d1, d2, d3] = self.derivatives(cell, s);
        let State { v, a } = state;
        let (w, cube, swing) = (v * v, v * v * v, 3.0 * v * a);
        let mut most = (v / (self.cap)(node)).max(a.abs() * inverse.along[0]).max(j.abs() * inverse.along[1]);
        for i in 0..AXES {
            let acceleration = (d2[i] * w + d1[i] * a) * inverse.acceleration[i];
            let jerk = (d3[i] * cube + d2[i] * swing + d1[i] * j) * inverse.jerk[i];
            most = larger(larger(most, acceleration.abs()), jerk.abs());
        }
        most
    }
}
