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
//! What comes out is taken if it is faster and every piece of it keeps all bounds, looked at in eight places and wherever cells
//! meet; if not, once more with less where it did not. The plan before stands otherwise. So an iteration that goes astray costs time alone.
//!
//! **Windows** begin inside the one before. Its solution has used what there is, so in other steps, or with bounds that are a
//! thousandth tighter, there may be no way on from a state of it. A window keeps the steps and the tightened bounds of the
//! one before; a bound that its first state lies on is loosened by `INSIDE`, so that this state is strictly inside all of
//! them.

mod band;
mod bounds;
mod road;
mod rows;
mod solve;

use crate::limits::Inverses;
use crate::quick::{larger, smaller};
use crate::timing::piece::{Piece, ROUNDING, State};
use crate::timing::queue::{Node, Queue};
use band::Band;
use bounds::Ground;
use ferrocut_geometry::AXES;
use pulp::{Arch, NullaryFnOnce};
pub(crate) use road::Road;
use rows::{PAD, Rows, Speeds, Sums};
use solve::{FIRST_GAP, NEXT_GAP, Solution};

/// Most steps of a window of a valley.
const STEPS: usize = 160;

/// The last part of a window, one of so many, is of the next one too.
const OVERLAP: usize = 3;

/// A window that was not to be run within the bounds begins so many pieces earlier and has so many steps less, so many times.
const EARLIER: usize = 5;
const SHORTER: usize = 12;
const TRIES: usize = 2;

/// Pieces that there is room for.
const WAY: usize = 8192;

/// How closely the least time is looked for.
#[derive(Clone, Copy, Debug)]
struct Effort {
    /// A step in time, s.
    tau: f64,
    /// The share of the time that may be missing to the least.
    gap: f64,
    /// What may be left of by how much slacks and bounds differed.
    apart: f64,
    /// How far the path turns in a step at most, rad.
    turn: f64,
}

const CLOSE: Effort = Effort { tau: 0.004, gap: 2e-3, apart: 0.01, turn: 0.1 };

/// The same where turns are few and it rests at neither end: a raster of long rows takes 0.1 % longer, and a tenth more of it is
/// planned in a second.
const ROUGH: Effort = Effort { tau: 0.009, gap: 3e-2, apart: 0.03, turn: 0.15 };

/// Where jerk is limited, a step need not be shorter in time than so much for how far the path turns in it, s, unless that is as far as
/// [`MOST_TURN`] then.
const LEAST_TAU: f64 = 0.002;
const MOST_TURN: f64 = 0.3;

/// A step may be so much shorter to end where cells meet, and so much to end where the third derivative jumps.
const SHORT: f64 = 0.25;
const SHORTEST: f64 = 0.1;

/// How often it is tried with less where a piece was beyond its bounds, and with how much less: so many times what it was beyond
/// them, and a little, which is more each time. Where none is found the whole window is run by the plan before, up to a seventh
/// slower, and four times were not always enough.
const ROUNDS: usize = 8;
const LESS: f64 = 1.2;
const A_LITTLE: f64 = 5e-4;
const MORE_A_TIME: f64 = 2.0;
const MOST_MORE: f64 = 1.18;

/// Where that has not helped up to this round, what is beyond may be a bound that was far from the plan: once more with those that are
/// not far from what was found.
const TIGHTENED: usize = 3;

/// What a curve takes of a bound somewhere in a window, if it is worth to be looked at.
const TAKEN: f64 = 0.25;

/// What is gained must be worth it.
const WORTH: f64 = 0.997;

/// What came of a window.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Outcome {
    Quicker,
    /// There is nothing to be gained.
    Same,
    /// It would have been quicker, but not within the bounds.
    Broken,
}

/// Memory for one valley.
#[derive(Debug)]
pub(crate) struct Valley {
    effort: Effort,
    /// Lengths of the steps; one more on either side than there are.
    h: Vec<f64>,
    /// Where they begin.
    s: Vec<f64>,
    x: Vec<f64>,
    /// The same of the plan before.
    planned: Vec<f64>,
    /// How much more than it does a place is to count.
    more: Vec<f64>,
    ground: Ground,
    rows: Rows,
    speeds: Speeds,
    sums: Sums,
    /// What an iteration solves.
    band: Band,
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
            effort: CLOSE,
            h: Vec::with_capacity(STEPS + 2),
            s: Vec::with_capacity(STEPS + 2),
            x: Vec::with_capacity(STEPS + 2 + PAD),
            planned: Vec::with_capacity(STEPS + 2 + PAD),
            more: Vec::with_capacity(STEPS + 2),
            ground: Ground::new(),
            rows: Rows::new(STEPS + 2),
            speeds: Speeds::new(STEPS + 2),
            sums: Sums::new(STEPS + 2),
            band: Band::new(STEPS + 2 + PAD),
            pieces: Vec::with_capacity(STEPS),
            way: Vec::with_capacity(WAY),
            tight: Vec::with_capacity(WAY),
            tighter: Vec::with_capacity(STEPS + 2),
            taken: 0,
        }
    }

    /// The same way as `plan`, which begins in cell `first`, in less time. `false` where no less is found; else it is in
    /// [`way`](Self::way), which is no more pieces than `most`. Where no curve takes a share of the bounds it is looked for only if
    /// the plan `is_slack`.
    ///
    /// What is longer than its steps is run window by window. Each begins inside the one before, so that the state at the
    /// end of that one, which was the plan's, does not stay.
    pub fn run<const N: usize>(
        &mut self,
        road: &Road<'_, N, impl Fn(&Node) -> f64>,
        plan: &[Piece],
        first: u64,
        most: usize,
        is_slack: bool,
    ) -> bool {
        self.effort = if road.queue.node(first).turns_are_few && !is_slack { ROUGH } else { CLOSE };
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
            let Some(count) = self.place(road, from, cell, STEPS - SHORTER * tries) else { break };
            let is_last = from + count == self.way.len();
            let outcome = self.window(road, from..from + count, cell, is_slack);
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
    fn window<const N: usize>(
        &mut self,
        road: &Road<'_, N, impl Fn(&Node) -> f64>,
        range: std::ops::Range<usize>,
        first: u64,
        is_slack: bool,
    ) -> Outcome {
        let time = |pieces: &[Piece]| pieces.iter().map(|piece| piece.time).sum::<f64>();
        let plan = &self.way[range.clone()];
        let (from, to, before) = (plan[0].from, plan[plan.len() - 1].to, time(plan));
        if !is_slack && !plan_bends(road, plan, first) {
            return Outcome::Same;
        }
        self.begin(range, from, to);
        self.bound(road, first);
        // What was taken over is as tight as it was.
        if self.taken > 0 {
            self.loosen();
        }
        self.planned.clone_from(&self.x);
        let planned = self.slacken();
        let (mut little, mut gap) = (A_LITTLE, FIRST_GAP);
        for round in 0..ROUNDS {
            let mut solution = self.solve(planned, gap);
            // From a solution that the tightened bounds have left, the way to the next is not always found: from the plan it is.
            if solution == Solution::None && round > 0 {
                self.x.clone_from(&self.planned);
                self.slacken();
                solution = self.solve(planned, FIRST_GAP);
            }
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
            // No closer than at first: what is closer to the least is beyond its bounds elsewhere.
            gap = NEXT_GAP.max(self.effort.gap);
            if round == TIGHTENED && self.outgrew() {
                self.bound_anew(road, first);
                gap = FIRST_GAP;
            }
        }
        Outcome::Broken
    }

    /// The bounds that are not far from what was found, from the plan on.
    fn bound_anew<const N: usize>(&mut self, road: &Road<'_, N, impl Fn(&Node) -> f64>, first: u64) {
        for (x, planned) in self.x.iter_mut().zip(&self.planned) {
            *x = larger(*x, *planned);
        }
        self.bound(road, first);
        self.x.clone_from(&self.planned);
        self.loosen();
        self.slacken();
    }

    /// What was found.
    pub fn way(&self) -> &[Piece] {
        &self.way
    }

    /// Sets no more than `most` steps, for as many of the pieces from `from` on as there are steps for: how many. `None` if that
    /// are too few.
    fn place<const N: usize>(
        &mut self,
        road: &Road<'_, N, impl Fn(&Node) -> f64>,
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
            let norm = |d: &[f64; N]| d.iter().map(|c| c * c).sum::<f64>().sqrt();
            let turn = (norm(&derivatives[1]) / norm(&derivatives[0]).max(1e-9)).max(1e-9);
            let (v, tau) = (speed(plan, k, s), self.effort.tau);
            let mut h = tau * v;
            h = h.min(tau * speed(plan, k, (s + h).min(end)).max(0.3 * h / tau));
            let inverse = road.inverses.of(road.queue.node(cell).class);
            let is_free = inverse.is_free_of_jerk(&derivatives[0]);
            let least = if is_free { 0.0 } else { (LEAST_TAU * v).min(MOST_TURN / turn) };
            h = h.min((self.effort.turn / turn).max(least)).max(1e-6);
            // It ends where the path changes, if that is about there, and does not reach over a jump.
            let (mut to, mut next) = (s + h, cell);
            while next + 1 < road.queue.tail() && road.queue.node(next).end() <= s + 1.3 * h {
                let border = road.queue.node(next).end();
                let jumps = border > s + SHORTEST * h && road.jumps(next, speed(plan, k, border));
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
        self.x.resize(n + PAD, 0.0);
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

    /// `X` at the place between the steps `k` and `k + 1`, and what both steps weigh in it.
    fn at(&self, k: usize) -> (f64, [f64; 2]) {
        let (h0, h1) = (self.h[k], self.h[k + 1]);
        let weights = [h1 / (h0 + h1), h0 / (h0 + h1)];
        (self.x[k] * weights[0] + self.x[k + 1] * weights[1], weights)
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
                State { v: larger(0.0, self.at(k).0).sqrt(), a }
            };
            let piece = Piece::new(self.s[k - 1], self.h[k], state, next).filter(Piece::is_forward);
            let Some(piece) = piece else { return false };
            self.pieces.push(piece);
            state = next;
        }
        true
    }

    /// Whether every piece keeps all bounds; where not, the bounds at its ends are tightened, by at least a little.
    fn keeps<const N: usize>(
        &mut self,
        road: &Road<'_, N, impl Fn(&Node) -> f64>,
        first: u64,
        little: f64,
    ) -> bool {
        self.more.clear();
        self.more.resize(self.s.len(), 1.0);
        let is_good = Arch::new().dispatch(Judge { valley: self, road, first, little });
        if !is_good {
            for (tighter, more) in self.tighter.iter_mut().zip(&self.more) {
                *tighter *= more;
            }
            self.rows.tighten(&self.more);
        }
        is_good
    }
}

/// Whether every piece keeps all bounds, with vectors as wide as the processor has them; where not, how much more the places
/// at its ends are to count.
struct Judge<'a, 'q, const N: usize, C: Fn(&Node) -> f64> {
    valley: &'a mut Valley,
    road: &'a Road<'q, N, C>,
    first: u64,
    little: f64,
}

impl<const N: usize, C: Fn(&Node) -> f64> NullaryFnOnce for Judge<'_, '_, N, C> {
    type Output = bool;

    #[inline(always)]
    fn call(self) -> bool {
        let Valley { pieces, more, .. } = self.valley;
        let (mut is_good, mut cell) = (true, self.first);
        for (k, piece) in pieces.iter().enumerate() {
            let used = self.road.most_used(piece, &mut cell);
            if !(used <= ROUNDING) {
                is_good = false;
                let by = (1.0 + LESS * (used - 1.0) + self.little).min(MOST_MORE);
                more[k] *= by;
                more[k + 1] *= by;
            }
        }
        is_good
    }
}

/// Whether somewhere a curve takes a share of the bounds that could be shared better.
fn plan_bends<const N: usize>(road: &Road<'_, N, impl Fn(&Node) -> f64>, plan: &[Piece], first: u64) -> bool {
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
    larger(1e-12, larger(w, 0.25 * smaller(w0, w1))).sqrt()
}

/// Whether a piece keeps all bounds by the true derivatives; it begins in `cell`, which goes on to where it ends.
pub(crate) fn keeps(
    queue: &Queue,
    inverses: &Inverses,
    piece: &Piece,
    cell: &mut u64,
    cap: impl Fn(&Node) -> f64,
) -> bool {
    piece.is_forward() && {
        let used = if queue.moves_others() {
            Road::<AXES, _> { queue, inverses, cap }.most_used(piece, cell)
        } else {
            Road::<3, _> { queue, inverses, cap }.most_used(piece, cell)
        };
        used <= ROUNDING
    }
}
