//! The interior point method: `x` of least time within the bounds ([`super`] has the mathematics).

use super::rows::PAD;
use super::{Valley, WORTH};
use pulp::{Arch, NullaryFnOnce};

/// Iterations at most, the share of the time that may be missing to the least, and what may be left of by how much slacks
/// and bounds differed.
const ITERATIONS: usize = 30;
const GAP: f64 = 2e-3;
const APART: f64 = 0.01;

/// Multipliers at first: the share of the time that all of them together are worth.
pub(super) const FIRST_GAP: f64 = 1.0;

/// The same where bounds were tightened: little changes.
pub(super) const NEXT_GAP: f64 = 4e-3;

/// Slacks at first, at least.
const FIRST_SLACK: f64 = 0.15;

/// Multipliers aimed at, of those there are: after a step that went more than this share of its way.
const AIMS: [(f64, f64); 3] = [(0.8, 0.15), (0.4, 0.3), (0.0, 0.5)];

/// How close to zero slacks and multipliers go in an iteration.
const NEARLY: f64 = 0.98;

/// Where the sum of the products is so many times the time, there is no way within the bounds.
const ASTRAY: f64 = 10.0;

/// What came of the iterations.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Solution {
    Found,
    /// It would not be worth it.
    Worthless,
    /// There is none within the bounds.
    None,
}

/// [`Valley::iterate`], with vectors of eight or sixteen numbers where the processor has them; in every bit the same.
struct Solve<'a> {
    valley: &'a mut Valley,
    planned: f64,
    gap: f64,
}

impl NullaryFnOnce for Solve<'_> {
    type Output = Solution;

    #[inline(always)]
    fn call(self) -> Solution {
        self.valley.iterate(self.planned, self.gap)
    }
}

impl Valley {
    /// Slacks and multipliers that are positive, at the plan as it is; the time that it takes by its control points.
    pub(super) fn slacken(&mut self) -> f64 {
        let n = self.h.len();
        let planned: f64 = (1..n - 1).map(|i| self.h[i] / self.x[i].max(1e-12).sqrt()).sum();
        self.slacken_rows(FIRST_SLACK, self.mu(FIRST_GAP * planned));
        planned
    }

    /// What each product of slack and multiplier is when all together are `sum`.
    #[inline(always)]
    pub(super) fn mu(&self, sum: f64) -> f64 {
        sum / (2.0 * self.rows.count.max(1) as f64)
    }

    /// The interior point method from what is known, first with a sum of products of the share `gap` of the time `planned`.
    pub(super) fn solve(&mut self, planned: f64, gap: f64) -> Solution {
        Arch::new().dispatch(Solve { valley: self, planned, gap })
    }

    #[inline(always)]
    pub(super) fn iterate(&mut self, planned: f64, gap: f64) -> Solution {
        let n = self.h.len();
        let mut sum = gap * planned;
        let mut mu = self.mu(sum);
        let mut step = [0.0; 2];
        // How much of what slacks and bounds differed by is left.
        let mut apart = 1.0;
        for _ in 0..ITERATIONS {
            let now = self.assemble(step, mu);
            // No more than the gap is to be gained.
            if now - sum > WORTH * planned {
                return Solution::Worthless;
            }
            if !self.eliminate() {
                return Solution::None;
            }
            // Where it leads, as far as slacks and multipliers stay positive.
            let lead = self.lead(mu);
            let mut far = NEARLY / lead.most[0].max(NEARLY);
            for i in 2..n - 2 {
                if self.right[i] < 0.0 {
                    far = far.min(-0.7 * self.x[i] / self.right[i]);
                }
            }
            for i in 2..n - 2 {
                self.x[i] += far * self.right[i];
            }
            step = [far, NEARLY / lead.most[1].max(NEARLY)];
            sum = lead.sum(step);
            apart *= 1.0 - far;
            if apart < APART && sum < GAP * planned {
                break;
            }
            if sum > ASTRAY * planned {
                return Solution::None;
            }
            let went = far.min(step[1]);
            let aim = AIMS.iter().find(|(least, _)| went > *least).map_or(1.0, |(_, aim)| *aim);
            mu = aim * self.mu(sum);
        }
        self.step_rows(step);
        Solution::Found
    }

    /// The matrix and the right side behind a step; the time that it takes as it is.
    #[inline(always)]
    fn assemble(&mut self, step: [f64; 2], mu: f64) -> f64 {
        let n = self.h.len();
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
        self.band.resize(n + PAD, [0.0; 3]);
        self.right.resize(n + PAD, 0.0);
        self.assemble_rows(step, mu);
        // What is given stays.
        for i in [0, 1, n - 2, n - 1] {
            self.band[i][0] = 1e30;
            self.right[i] = 0.0;
        }
        time
    }

    /// Solves `L·D·Lᵀ·dx = right` in place.
    #[inline(always)]
    fn eliminate(&mut self) -> bool {
        let n = self.h.len();
        let (band, right) = (&mut self.band[..n], &mut self.right[..n]);
        // What the rows above take from this one and the next: of the diagonal, the one beside it and the right side.
        let (mut own, mut next) = ([0.0; 3], [0.0; 3]);
        for (band, right) in band.iter_mut().zip(&mut *right) {
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
        for (band, right) in band.iter().zip(right).rev() {
            *right = *right * band[0] - band[1] * below[0] - band[2] * below[1];
            below = [*right, below[0]];
        }
        true
    }
}
