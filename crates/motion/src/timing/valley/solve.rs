//! The interior point method: `x` of least time within the bounds ([`super`] has the mathematics).

use super::band::Band;
use super::rows::PAD;
use super::{Valley, WORTH};
use crate::quick::larger;
use pulp::{Arch, NullaryFnOnce};

/// Iterations at most.
const ITERATIONS: usize = 30;

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

/// Control points fall by no more than this share of themselves.
const MOST_FALL: f64 = 0.7;

/// So many steps are done together.
const TOGETHER: usize = 8;

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
            if !self.band.solve(n) {
                return Solution::None;
            }
            // Where it leads, as far as slacks and multipliers stay positive.
            let lead = self.lead(mu);
            let fall = most_fall(&self.x[2..n - 2], &self.band.right[2..n - 2]);
            let far = (NEARLY / lead.most[0].max(NEARLY)).min(MOST_FALL / fall);
            for (x, change) in self.x[2..n - 2].iter_mut().zip(&self.band.right[2..n - 2]) {
                *x += far * change;
            }
            step = [far, NEARLY / lead.most[1].max(NEARLY)];
            sum = lead.sum(step);
            apart *= 1.0 - far;
            if apart < self.effort.apart && sum < self.effort.gap * planned {
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
        let Band { diagonals: [diagonal, beside, outer], right } = &mut self.band;
        for to in [&mut *diagonal, beside, outer, right] {
            to.clear();
            to.resize(n + PAD, 0.0);
        }
        let mut times = [0.0; TOGETHER];
        // Before and behind the steps there is one more each, of which the time does not count; what is given stays anyway.
        let steps = 1..n - 1;
        let from = self.x[steps.clone()].chunks(TOGETHER).zip(self.h[steps.clone()].chunks(TOGETHER));
        let to = diagonal[steps.clone()].chunks_mut(TOGETHER).zip(right[steps].chunks_mut(TOGETHER));
        for ((x, h), (diagonal, right)) in from.zip(to) {
            for ((time, (x, h)), (diagonal, right)) in
                times.iter_mut().zip(x.iter().zip(h)).zip(diagonal.iter_mut().zip(right))
            {
                let inverse = larger(1e-12, *x).recip();
                let own = h * inverse.sqrt();
                let slow = own * inverse;
                *time += own;
                *diagonal = 0.75 * slow * inverse;
                *right = 0.5 * slow;
            }
        }
        self.assemble_rows(step, mu);
        let Band { diagonals: [diagonal, ..], right } = &mut self.band;
        for i in [0, 1, n - 2, n - 1] {
            diagonal[i] = 1e30;
            right[i] = 0.0;
        }
        times.iter().sum()
    }
}

/// The most that one of these falls by, as a share of itself, where they change so.
#[inline(always)]
fn most_fall(x: &[f64], change: &[f64]) -> f64 {
    let mut most = [0.0; TOGETHER];
    for (x, change) in x.chunks(TOGETHER).zip(change.chunks(TOGETHER)) {
        for (most, (x, change)) in most.iter_mut().zip(x.iter().zip(change)) {
            *most = larger(*most, -change / x);
        }
    }
    most.into_iter().fold(0.0, larger)
}
