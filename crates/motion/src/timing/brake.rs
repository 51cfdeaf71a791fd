//! Slowing down as soon as the bounds allow: for a hold, and for lower overrides.
//!
//! **Braking** goes in steps of time. At each the path takes what the curve leaves to it of acceleration and jerk, the
//! bounds taken by magnitudes ([`crate::limits::Load::room`]), and no more than can be taken back until the speed wanted is
//! there.
//!
//! **Easing off.** In a valley ([`crate::timing::valley`]) the curve takes all, by magnitudes more than all: there is
//! nothing to brake with. There the plan is followed, its time `τ` running ever slower, until there is: at the rate
//! `r = 1 − u` of time
//!
//! ```text
//! v = r·v₀          a = r²·a₀ − r·u̇·v₀          u̇ = du/dτ
//! ```
//!
//! What the curve takes of acceleration falls with `r²`, of jerk with `r³`, and so every bit of `u` leaves room for more: it
//! grows as `ü = g·κ²·(u + u₀)`, about exponentially. Which `g` the true derivatives allow is tried piece by piece, the
//! largest first; where none does, the piece before is gone about less boldly.

use crate::limits::Inverses;
use crate::timing::grid::Port;
use crate::timing::piece::{Piece, State};
use crate::timing::queue::Queue;
use crate::timing::valley;

/// A step of braking, s.
const STEP: f64 = 0.002;

/// How well the moment is found from which on the acceleration is taken back, as a share; and most halvings for that.
const SAME_TIME: f64 = 1e-6;
const HALVINGS: usize = 64;

/// Most steps of braking, and most pieces of the plan that are eased off.
const STEPS: usize = 2000;
const EASED: usize = 256;

/// Most pieces in all.
pub(crate) const PIECES: usize = STEPS + EASED;

/// Share of the bounds that braking uses.
const SHARE: f64 = 0.95;

/// The rate `κ` in 1/s, the share `u₀`, and the `g` in the order in which they are tried.
const GROWTH: f64 = 80.0;
const FIRST: f64 = 0.004;
const WAYS: [f64; 7] = [1.0, 0.6, 0.3, 0.1, 0.0, -0.2, -1.0];

/// How many pieces are tried at most.
const TRIES: usize = 500;

/// Below this share braking is not tried; above this one nothing more is eased off.
const LEAST_EASED: f64 = 0.02;
const MOST_EASED: f64 = 0.8;

/// Where something begins on the path.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Start {
    pub port: Port,
    pub cell: u64,
}

/// Where easing off has come to.
#[derive(Clone, Copy, Debug)]
struct Eased {
    start: Start,
    /// `u` and `u̇`.
    share: f64,
    growth: f64,
}

/// Memory for slowing down, and what was found.
#[derive(Debug)]
pub(crate) struct Brake {
    pieces: Vec<Piece>,
    /// Where the pieces that are eased off begin, and the number of the `g` of each.
    eased: Vec<(Eased, usize)>,
}

impl Brake {
    pub fn new() -> Brake {
        Brake { pieces: Vec::with_capacity(PIECES + 1), eased: Vec::with_capacity(EASED) }
    }

    /// What was found.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// Finds the pieces that slow down from `start` to the speed `target` before the length `limit`. `false` if the bounds
    /// by magnitudes do not allow it.
    pub fn run(&mut self, queue: &Queue, start: Start, target: f64, limit: f64) -> bool {
        self.pieces.clear();
        self.slow_down(queue, start, target, limit)
    }

    /// The same where [`run`](Self::run) finds none; `plan` is what was to be run from `start` on.
    pub fn ease_off(
        &mut self,
        queue: &Queue,
        inverses: &Inverses,
        plan: &[Piece],
        start: Start,
        target: f64,
        limit: f64,
    ) -> bool {
        self.pieces.clear();
        self.eased.clear();
        let mut at = Eased { start, share: 0.0, growth: 0.0 };
        let mut way = 0;
        for _ in 0..TRIES {
            let k = self.eased.len();
            let next = match plan.get(k).filter(|piece| k < EASED && piece.end() <= limit) {
                Some(plan) => eased(queue, inverses, plan, at, WAYS[way]),
                None => {
                    way = WAYS.len();
                    None
                }
            };
            if let Some((piece, next)) = next {
                self.pieces.push(piece);
                self.eased.push((at, way));
                (at, way) = (next, 0);
                let brakes = at.share > LEAST_EASED && self.slow_down(queue, at.start, target, limit);
                if brakes {
                    return true;
                }
                self.pieces.truncate(k + 1);
                continue;
            }
            way += 1;
            while way >= WAYS.len() {
                let Some((from, tried)) = self.eased.pop() else { return false };
                self.pieces.pop();
                (at, way) = (from, tried + 1);
            }
        }
        false
    }

    /// Adds the pieces that brake from `start`.
    fn slow_down(&mut self, queue: &Queue, start: Start, target: f64, limit: f64) -> bool {
        let (mut s, mut state, mut cell) = (start.port.s, start.port.state, start.cell);
        for _ in 0..STEPS {
            if state.v <= target && state.a == 0.0 {
                return s <= limit;
            }
            if cell >= queue.tail() || s > limit {
                return false;
            }
            let room = queue.node(cell).load.room(state.v);
            let (a, j) = (room.a * SHARE, room.j[1] * SHARE);
            // After braking a little more the acceleration can be taken back just in time.
            let then = |t: f64| {
                let a = (state.a - j * t).max(-a).min(state.a.max(-a));
                State { v: state.v + 0.5 * (state.a + a) * t, a }
            };
            let is_late = |state: State| state.a < 0.0 && state.v - state.a * state.a / (2.0 * j) <= target;
            if is_late(state) {
                let left = state.v - target;
                if left <= 0.0 {
                    return false;
                }
                let (time, jerk) = (-2.0 * left / state.a, state.a * state.a / (2.0 * left));
                let mut piece = Piece::steady(s, state, jerk, time);
                piece.to = State { v: target, a: 0.0 };
                return self.push(queue, piece, cell).is_some() && piece.end() <= limit;
            }
            let mut t = STEP;
            if is_late(then(t)) {
                let (mut low, mut high) = (0.0, t);
                for _ in 0..HALVINGS {
                    // Of a speed that is all but none too.
                    if high - low <= SAME_TIME * high {
                        break;
                    }
                    let middle = 0.5 * (low + high);
                    if is_late(then(middle)) {
                        high = middle;
                    } else {
                        low = middle;
                    }
                }
                t = high;
            }
            let to = then(t);
            let piece = Piece::steady(s, state, (to.a - state.a) / t, t);
            let Some(reached) = self.push(queue, piece, cell) else { return false };
            (s, state, cell) = (piece.end(), piece.to, reached);
        }
        false
    }

    /// Adds a piece of braking that begins in cell `from`; the cell in which it ends, `None` if a bound is passed.
    fn push(&mut self, queue: &Queue, piece: Piece, from: u64) -> Option<u64> {
        let mut cell = from;
        let v = piece.from.v.max(piece.to.v);
        while cell < queue.tail() {
            let node = queue.node(cell);
            if !piece.keeps(&node.load) || v > node.top * (1.0 + 1e-6) {
                return None;
            }
            if node.end() >= piece.end() || node.rests {
                self.pieces.push(piece);
                return Some(cell);
            }
            cell += 1;
        }
        None
    }
}

/// A piece of the plan, eased off further with `g`, and where that leads; `None` if a bound is passed.
fn eased(queue: &Queue, inverses: &Inverses, plan: &Piece, at: Eased, g: f64) -> Option<(Piece, Eased)> {
    let growth = at.growth + g * GROWTH * GROWTH * (at.share + FIRST) * plan.time;
    let share = at.share + 0.5 * (at.growth + growth) * plan.time;
    if growth < 0.0 || share > MOST_EASED {
        return None;
    }
    let r = 1.0 - share;
    let state = State { v: r * plan.to.v, a: r * (r * plan.to.a - growth * plan.to.v) };
    let Port { s, state: from } = at.start.port;
    let piece = Piece::new(s, plan.end() - s, from, state)?;
    // It is slower than the plan; the feed may be lower by now.
    let mut cell = at.start.cell;
    if !valley::keeps(queue, inverses, &piece, &mut cell, |node| node.most) {
        return None;
    }
    let cell = queue.find(cell, piece.end());
    let port = Port { s: piece.end(), state };
    Some((piece, Eased { start: Start { port, cell }, share, growth }))
}
