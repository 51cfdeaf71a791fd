//! What is added to the command of an axis that turns back, so that its play is taken up.
//!
//! Moving in the direction `side` (1 or −1) under the backlash `b` of cutting or positioning, what is to be
//! added is `(side·b − home·b_cutting)/2`: nothing where the axis moves as it did when it was homed, and on a
//! reversal the mean of both values if positioning and cutting follow each other, as on Fanuc (parameters 1851
//! and 1852 with RBK). GSK990MC: P190 to P194, with 18#6 positioning by P231 to P235.
//!
//! It is added at a fixed rate (18#7 = 0, P195 to P199), or with acceleration within a time (18#7 = 1, P200).

use super::ramp::Ramp;
use crate::stroke::RampLimits;
use ferrocut_machine::Backlash;

/// Backlash compensation of one axis.
#[derive(Clone, Debug)]
pub(crate) struct TakeUp {
    /// What is to be added while cutting and while positioning, moving in the negative and in the positive
    /// direction, mm.
    targets: [[f64; 2]; 2],
    target: f64,
    added: f64,
    /// Where it is added with acceleration.
    ramp: Option<Ramp>,
    /// Else how much is added in a period, mm.
    step: f64,
    waits: bool,
}

impl TakeUp {
    /// Compensation by `backlash` within the limits of the axis, `period` in s; `None` without backlash.
    pub fn new(backlash: &Backlash, limits: &RampLimits, period: f64) -> Option<TakeUp> {
        let cutting = backlash.cutting;
        let rapid = backlash.rapid.unwrap_or(cutting);
        if cutting == 0.0 && rapid == 0.0 {
            return None;
        }
        let home = if backlash.homes_negative { -1.0 } else { 1.0 };
        let target = |value: f64, side: f64| (side * value - home * cutting) / 2.0;
        let targets = [cutting, rapid].map(|value| [target(value, -1.0), target(value, 1.0)]);
        let most = cutting.abs().max(rapid.abs());
        let step = backlash.rate.min(limits.velocity * 60.0) / 60.0 * period;
        let ramp = || Ramp::new(0.0, backlash.time_ms / 1000.0, most, limits, period);
        let ramp = (backlash.rate == 0.0).then(ramp);
        Some(TakeUp { targets, target: 0.0, added: 0.0, ramp, step, waits: backlash.waits })
    }

    /// Goes on by a period; what is added at its end, mm.
    #[inline]
    pub fn tick(&mut self, side: f64, positions: bool) -> f64 {
        let [[cut_back, cut_on], [rapid_back, rapid_on]] = self.targets;
        let target = match (positions, side > 0.0) {
            (false, false) => cut_back,
            (false, true) => cut_on,
            (true, false) => rapid_back,
            (true, true) => rapid_on,
        };
        self.target = target;
        self.added = match &mut self.ramp {
            Some(ramp) => ramp.tick(target),
            None => {
                let left = target - self.added;
                if left.abs() <= self.step { target } else { self.added + self.step.copysign(left) }
            }
        };
        self.added
    }

    /// What is added now, mm.
    pub fn added(&self) -> f64 {
        self.added
    }

    /// Whether the next move may begin.
    pub fn lets_go(&self) -> bool {
        let is_done = self.added == self.target && self.ramp.as_ref().is_none_or(Ramp::is_at_rest);
        is_done || !self.waits
    }
}
