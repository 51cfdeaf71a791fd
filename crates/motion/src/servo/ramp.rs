//! A value that follows a target of steps with acceleration: what compensation adds to an axis.
//!
//! The target runs through three moving averages of a third of the time each (see [`super::average`]). With
//! `h` such a third, a step `Δ` becomes an S of length `3h` with
//!
//! ```text
//! velocity ≤ 3Δ/4h        acceleration ≤ Δ/h²        jerk ≤ 2Δ/h³
//! ```
//!
//! It is monotone, ends on the target exactly, and while the target goes to and fro between two values however
//! often, it stays between them; the bounds on acceleration and jerk then double.

use super::average::Average;
use crate::stroke::RampLimits;

/// The value.
#[derive(Clone, Debug)]
pub(crate) struct Ramp {
    target: f64,
    value: f64,
    /// The averages, each with its lag.
    stages: Option<[(Average, f64); 3]>,
}

impl Ramp {
    /// A value that is `start` and follows steps of at most `step` within `time` seconds, or as much longer as
    /// the limits ask for.
    pub fn new(start: f64, time: f64, step: f64, limits: &RampLimits, period: f64) -> Ramp {
        let third = (time / 3.0)
            .max(0.75 * step / limits.velocity)
            .max((2.0 * step / limits.acceleration).sqrt())
            .max((4.0 * step / limits.jerk).cbrt());
        let periods = (third / period - 1e-9).ceil();
        let stage = || Average::new(periods).map(|average| (average, 0.0));
        let stages = match (stage(), stage(), stage()) {
            (Some(a), Some(b), Some(c)) => Some([a, b, c]),
            _ => None,
        };
        Ramp { target: start, value: start, stages }
    }

    /// Goes on by a period; the value at its end.
    #[inline]
    pub fn tick(&mut self, target: f64) -> f64 {
        let step = target - self.target;
        self.target = target;
        let Some(stages) = &mut self.stages else {
            self.value = target;
            return target;
        };
        // What comes out of one is fed into the next: what came in, less what its lag grew by.
        let mut moved = step;
        self.value = target;
        for (average, lag) in stages {
            let grown = average.push(moved) - *lag;
            *lag += grown;
            moved -= grown;
            self.value -= *lag;
        }
        self.value
    }

    /// The value now.
    pub fn value(&self) -> f64 {
        self.value
    }

    /// Whether the value is the target, and stays it.
    pub fn is_at_rest(&self) -> bool {
        self.stages.iter().flatten().all(|(average, _)| average.is_at_rest())
    }
}
