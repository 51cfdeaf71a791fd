//! What a valley lies on: the derivatives of the path, and what a piece takes of the bounds.

use crate::limits::{Inverses, peak};
use crate::path::shape::Shape;
use crate::quick::{larger, smaller};
use crate::timing::piece::{PLACES, Piece, Places, State};
use crate::timing::queue::{Node, Queue};
use std::ops::Range;

/// The third derivative jumps where it does by more than this share of itself, and that takes more than this share of the jerk.
const JUMP: f64 = 0.1;
const JUMP_TAKES: f64 = 0.02;

/// What a valley lies on, where none but the `N` axes in front move.
pub(crate) struct Road<'a, const N: usize, C: Fn(&Node) -> f64> {
    pub queue: &'a Queue,
    pub inverses: &'a Inverses,
    /// The speed allowed in a cell, curves aside.
    pub cap: C,
}

impl<const N: usize, C: Fn(&Node) -> f64> Road<'_, N, C> {
    /// The cell in which `s` lies, from `cell` on.
    pub(super) fn cell(&self, mut cell: u64, s: f64) -> u64 {
        while cell + 1 < self.queue.tail() && self.queue.node(cell).end() <= s + 1e-12 {
            cell += 1;
        }
        cell
    }

    /// The cell before the border of `cell` at `s` that has a length.
    pub(super) fn side_before(&self, cell: u64, s: f64) -> u64 {
        let mut side = cell;
        while side > self.queue.head() && self.queue.node(side).s >= s - 1e-12 {
            side -= 1;
        }
        side
    }

    /// `q′`, `q″` and `q‴` at `s`, which lies in `cell`.
    pub(super) fn derivatives(&self, cell: u64, s: f64) -> [[f64; N]; 3] {
        let node = self.queue.node(cell);
        self.queue.cell(cell).derivatives((s - node.s).clamp(0.0, node.len), node.len)
    }

    /// Whether the third derivative jumps behind `cell`, which is left at the speed `v`. Slices are of one arc as a rule.
    pub(super) fn jumps(&self, cell: u64, v: f64) -> bool {
        let shape = |cell: u64| &self.queue.cell(cell).shape;
        if let (Shape::Slice(..), Shape::Slice(..)) = (shape(cell), shape(cell + 1)) {
            return false;
        }
        let border = self.queue.node(cell).end();
        let (before, behind) = (self.derivatives(cell, border)[2], self.derivatives(cell + 1, border)[2]);
        let norm = |d: [f64; N]| d.iter().map(|c| c * c).sum::<f64>();
        let jump = std::array::from_fn(|i| behind[i] - before[i]);
        let inverse = self.inverses.of(self.queue.node(cell).class);
        let takes = peak(&jump, &inverse.jerk) * v * v * v;
        (takes > JUMP_TAKES || inverse.is_free_of_jerk(&jump))
            && norm(jump) > JUMP * JUMP * norm(before).max(norm(behind))
    }

    /// Lowest speed allowed, curves aside, from cell `from` to the length `to`.
    pub(super) fn least_cap(&self, from: u64, to: f64) -> f64 {
        let mut least = f64::MAX.sqrt();
        for cell in from..self.queue.tail() {
            let node = self.queue.node(cell);
            if node.s >= to && cell > from {
                break;
            }
            least = smaller(least, (self.cap)(node));
        }
        least
    }

    /// Largest share of a bound that a piece uses, which begins in `cell` or behind it; `cell` is then the one that it ends in.
    #[inline(always)]
    pub(super) fn most_used(&self, piece: &Piece, cell: &mut u64) -> f64 {
        *cell = self.cell(*cell, piece.s);
        let places = piece.places();
        let mut begin = f64::NEG_INFINITY;
        let mut used = 0.0;
        loop {
            let border = self.queue.node(*cell).end();
            let is_last = border >= piece.end() - 1e-9 || *cell + 1 >= self.queue.tail();
            let end = if is_last { f64::INFINITY } else { border };
            used = larger(used, self.used_inside(*cell, &places, begin..end));
            if is_last {
                return used;
            }
            // Where cells meet inside it the derivatives may jump.
            if border > piece.s + 1e-9 {
                let (s, state, j) = piece.state(piece.time_at(border));
                let border = larger(self.used(*cell, s, state, j), self.used(*cell + 1, s, state, j));
                used = larger(used, border);
            }
            begin = border;
            *cell += 1;
        }
    }

    /// Largest share of a bound that is used at those of the places that lie in this `range` of lengths, all of `cell`.
    #[inline(always)]
    fn used_inside(&self, cell: u64, places: &Places, range: Range<f64>) -> f64 {
        let node = self.queue.node(cell);
        let inverse = self.inverses.of(node.class);
        let Places { s, v, a, j } = places;
        let along = s.map(|s| (s - node.s).clamp(0.0, node.len));
        let [first, second, third] = self.queue.cell(cell).derivatives_at::<N>(&along, node.len);
        let slow = (self.cap)(node).recip();
        let mut most = [0.0; PLACES];
        for k in 0..PLACES {
            let along = larger(a[k].abs() * inverse.along[0], j[k].abs() * inverse.along[1]);
            most[k] = larger(v[k] * slow, along);
        }
        for i in 0..N {
            let (d1, d2, d3) = (&first[i], &second[i], &third[i]);
            let (most_a, most_j) = (inverse.acceleration[i], inverse.jerk[i]);
            for k in 0..PLACES {
                let (v, a, j) = (v[k], a[k], j[k]);
                let (w, swing) = (v * v, 3.0 * v * a);
                let acceleration = (d2[k] * w + d1[k] * a) * most_a;
                let jerk = (d3[k] * (w * v) + d2[k] * swing + d1[k] * j) * most_j;
                most[k] = larger(larger(most[k], acceleration.abs()), jerk.abs());
            }
        }
        let inside = |k: usize| s[k] >= range.start && s[k] < range.end;
        (0..PLACES).filter(|k| inside(*k)).fold(0.0, |used, k| larger(used, most[k]))
    }

    /// Largest share of a bound that is used at `s`.
    fn used(&self, cell: u64, s: f64, state: State, j: f64) -> f64 {
        let node = self.queue.node(cell);
        let inverse = self.inverses.of(node.class);
        let [d1, d2, d3] = self.derivatives(cell, s);
        let State { v, a } = state;
        let (w, cube, swing) = (v * v, v * v * v, 3.0 * v * a);
        let mut most = (v / (self.cap)(node)).max(a.abs() * inverse.along[0]).max(j.abs() * inverse.along[1]);
        for i in 0..N {
            let acceleration = (d2[i] * w + d1[i] * a) * inverse.acceleration[i];
            let jerk = (d3[i] * cube + d2[i] * swing + d1[i] * j) * inverse.jerk[i];
            most = larger(larger(most, acceleration.abs()), jerk.abs());
        }
        most
    }
}
