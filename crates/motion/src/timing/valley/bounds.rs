//! The bounds of a window at the places between its steps.

use super::Valley;
use super::road::Road;
use super::rows::{LANES, Root, SPEED};
use crate::limits::Inverse;
use crate::quick::larger;
use crate::timing::queue::Node;
use ferrocut_geometry::AXES;

/// Shares of acceleration and jerk that are used; the rest is for what lies between the places looked at.
const ACCELERATION_SHARE: f64 = 0.998;
const JERK_SHARE: f64 = 0.993;

/// Where a bound is far, it is none: less than the second share of it is used where `x` is the first times as much. A solution that is
/// faster somewhere is looked for again, with the bounds that are not far from it.
const FASTER: f64 = 3.0;
const HARMLESS: f64 = 0.95;

/// How far inside its bounds a solution is that a window begins with.
const INSIDE: f64 = 3e-3;

impl Valley {
    /// The bounds at all places, in the order of the control points that they begin with.
    pub(super) fn bound<const N: usize>(&mut self, road: &Road<'_, N, impl Fn(&Node) -> f64>, first: u64) {
        self.rows.clear();
        self.speeds.begin(&self.h);
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
            let is_line = |d: &[[f64; N]; 3]| d[1..].iter().flatten().all(|c| *c == 0.0);
            let has_left = !is_line(&there) || (k > 0 && self.at(k).0 >= self.at(k - 1).0);
            let has_right = !is_line(&here) || (k + 1 < places && self.at(k).0 >= self.at(k + 1).0);
            let is_harmful = |[d1, d2, d3]: [f64; 3], jmax: f64| {
                ((d3.abs() * v * v + 3.0 * d2.abs() * a_most) * v + d1.abs() * j_most) * jmax > HARMLESS
            };
            let of = |d: &[[f64; N]; 3], i: usize| if i < N { d.map(|d| d[i]) } else { [1.0, 0.0, 0.0] };
            // Along the path there may be no bounds.
            let bounds = if inverse.along == [0.0; 2] { N } else { N + 1 };
            for i in 0..bounds {
                let jmax = if i < N { inverse.jerk[i] } else { inverse.along[1] } / JERK_SHARE;
                let [e1, e2, e3] = of(&there, i);
                if let Some(push) = left_push.filter(|_| has_left && is_harmful([e1, e2, e3], jmax)) {
                    let c = [
                        e1 * push[0] * jmax,
                        (e3 * x[0] + 3.0 * e2 * a[0] + e1 * push[1]) * jmax,
                        (e3 * x[1] + 3.0 * e2 * a[1] + e1 * push[2]) * jmax,
                    ];
                    self.rows.put(i, Root::Before, k - 1, c);
                }
            }
            // Between three of them the spline lies below the highest.
            if (2..self.h.len() - 2).contains(&k) {
                let (begin, end) = (self.s[k - 2], self.s[k + 1]);
                cap_cell = road.cell(cap_cell, begin);
                let cap = road.least_cap(cap_cell, end);
                if FASTER * self.x[k] > cap * cap {
                    self.rows.put(SPEED, Root::None, k, [1.0 / (cap * cap), 0.0, 0.0]);
                }
            }
            for i in 0..bounds {
                let (amax, jmax) = if i < N {
                    (inverse.acceleration[i] / ACCELERATION_SHARE, inverse.jerk[i] / JERK_SHARE)
                } else {
                    (inverse.along[0] / ACCELERATION_SHARE, inverse.along[1] / JERK_SHARE)
                };
                let [d1, d2, d3] = of(&here, i);
                if is_inner && (d2.abs() * v * v + d1.abs() * a_most) * amax > HARMLESS {
                    let c = [(d2 * x[0] + d1 * a[0]) * amax, (d2 * x[1] + d1 * a[1]) * amax, 0.0];
                    self.rows.put(i, Root::None, k, c);
                }
                if let Some(push) = right_push.filter(|_| has_right && is_harmful([d1, d2, d3], jmax)) {
                    let c = [
                        (d3 * x[0] + 3.0 * d2 * a[0] + d1 * push[0]) * jmax,
                        (d3 * x[1] + 3.0 * d2 * a[1] + d1 * push[1]) * jmax,
                        d1 * push[2] * jmax,
                    ];
                    self.rows.put(i, Root::Behind, k, c);
                }
            }
        }
    }

    /// Whether it is so much faster than the plan somewhere that bounds which were far from that may be none of those set.
    pub(super) fn outgrew(&self) -> bool {
        let free = 2..self.h.len() - 2;
        self.x[free.clone()].iter().zip(&self.planned[free]).any(|(x, planned)| *x > FASTER * planned)
    }

    /// Bounds as tight as they were for the steps that are taken over, and as far as they were tightened since; looser where what was
    /// found for those steps is on one of them.
    pub(super) fn loosen(&mut self) {
        self.rows.tighten(&self.tighter);
        if self.taken == 0 {
            return;
        }
        self.look();
        for block in &mut self.rows.blocks {
            for i in (0..LANES).filter(|i| block.base + i + 2 <= self.taken) {
                let looser = ((1.0 - INSIDE as f32) / block.value[i].abs()).min(1.0);
                for c in &mut block.c {
                    c[i] *= looser;
                }
            }
        }
    }
}

/// Highest acceleration and jerk along the path where it is no faster than `v`, by its derivatives on both sides: an axis has what its
/// bounds leave it, and as much more as the curve takes the other way.
fn most_along<const N: usize>(sides: [&[[f64; N]; 3]; 2], inverse: &Inverse, v: f64) -> [f64; 2] {
    let [mut a, mut j] = inverse.along.map(|inverse| inverse.max(1e-12).recip());
    let most =
        |derivative: usize, i: usize| larger(sides[0][derivative][i].abs(), sides[1][derivative][i].abs());
    let axes =
        |inverse: &[f64; AXES]| -> [f64; N] { std::array::from_fn(|i| sides[1][0][i].abs() * inverse[i]) };
    for (i, share) in axes(&inverse.acceleration).into_iter().enumerate().filter(|(_, share)| *share > 0.0) {
        a = a.min((1.0 + most(1, i) * v * v * inverse.acceleration[i]) / share);
    }
    for (i, share) in axes(&inverse.jerk).into_iter().enumerate().filter(|(_, share)| *share > 0.0) {
        let curve = (most(2, i) * v * v + 3.0 * most(1, i) * a) * v;
        j = j.min((1.0 + curve * inverse.jerk[i]) / share);
    }
    [a, j]
}
