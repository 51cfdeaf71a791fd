//! The interior point method: `x` of least time within the bounds ([`super`] has the mathematics).

use super::{Valley, WORTH};

/// Iterations at most, the share of the time that may be missing to the least, and what may be left of by how much slacks
/// and bounds differed.
const ITERATIONS: usize = 30;
const GAP: f64 = 2e-3;
const APART: f64 = 0.01;

/// Multipliers at first: the share of the time that all of them together are worth.
pub(super) const FIRST_GAP: f64 = 0.3;

/// The same where bounds were tightened: little changes.
pub(super) const NEXT_GAP: f64 = 4e-3;

/// Slacks at first, at least.
const FIRST_SLACK: f64 = 0.15;

/// Multipliers aimed at, of those there are: after a step that went nearly all its way, and after a shorter one.
const AIMS: [f64; 2] = [0.15, 0.3];

/// How close to zero slacks and multipliers go in an iteration.
const NEARLY: f64 = 0.98;

/// Where the sum of the products is so many times the time, there is no way within the bounds.
const ASTRAY: f64 = 10.0;

/// One bound, on both sides: `|√Xᵖ·(c₀x₀ + c₁x₁ + c₂x₂)| ≤ 1`.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Row {
    pub c: [f64; 3],
    /// Number of `x₀`.
    pub base: usize,
    /// Where it is looked at.
    pub place: usize,
    /// Where the place's own `x` is among the three, if the bound is one of jerk.
    pub root: Option<usize>,
    /// Slacks and multipliers of both sides, and `1/z`.
    pub z: [f64; 2],
    pub l: [f64; 2],
    pub inverse: [f64; 2],
    pub dz: [f64; 2],
    pub dl: [f64; 2],
    /// Value and gradient as of now.
    pub value: f64,
    pub g: [f64; 3],
}

/// What came of the iterations.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Solution {
    Found,
    /// It would not be worth it.
    Worthless,
    /// There is none within the bounds.
    None,
}

impl Valley {
    /// Value and gradient of every bound as of now; `each` is asked of every row before.
    pub(super) fn look(&mut self, mut each: impl FnMut(&mut Row)) {
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
    pub(super) fn slacken(&mut self) -> f64 {
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
    pub(super) fn mu(&self, sum: f64) -> f64 {
        sum / (2.0 * self.rows.len() as f64)
    }

    /// The interior point method from what is known, first with a sum of products of the share `gap` of the time `planned`.
    pub(super) fn solve(&mut self, planned: f64, gap: f64) -> Solution {
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
    pub(super) fn assemble(&mut self, mu: f64) -> f64 {
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
    pub(super) fn eliminate(&mut self) -> bool {
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
