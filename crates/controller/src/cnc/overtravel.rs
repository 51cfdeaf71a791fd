//! Travel switches: an axis that comes onto one brings all to rest with an alarm. It leaves it by hand, while the
//! overtravel release is held, and only backwards (GSK990MC part 2, 2.5.1 and 2.5.3).

use super::{Cnc, State};
use crate::manual::JogWay;
use ferrocut_geometry::{Axis, AxisSet};
use ferrocut_machine::Fault;

/// What the travel switches say, and the key.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Overtravel {
    above: AxisSet,
    below: AxisSet,
    /// The release is held.
    released: bool,
    /// No alarms of them (GSK990MC 61#6).
    ignored: bool,
}

impl Overtravel {
    pub fn new(ignored: bool) -> Overtravel {
        Overtravel { ignored, ..Overtravel::default() }
    }

    fn is_clear(&self) -> bool {
        self.released || self.ignored || self.above.is_empty() && self.below.is_empty()
    }

    /// Whether an axis may not go that way.
    fn blocks(&self, axis: Axis, upwards: bool) -> bool {
        !self.ignored && if upwards { self.above.contains(axis) } else { self.below.contains(axis) }
    }
}

impl Cnc {
    /// The overtravel release is held or let go. Held, an axis on its travel switch may be moved back by hand, which
    /// ends the alarm.
    pub fn release_overtravel(&mut self, held: bool) {
        self.overtravel.released = held;
    }

    /// Whether the release keeps a switch from being an alarm: where axes are moved by hand, or nothing moves them. A
    /// program, the way back to it and homing end on a switch all the same.
    fn acts_release(&self) -> bool {
        let by_hand = self.manual.is_active || !self.is_under_way();
        self.overtravel.released && by_hand && !self.homing.is_active() && !self.returns()
    }

    /// Looks at the travel switches, once a period.
    pub(super) fn watch_switches(&mut self) {
        let switches = self.switches();
        let (above, below) = (switches.above.and(self.machine_axes), switches.below.and(self.machine_axes));
        (self.overtravel.above, self.overtravel.below) = (above, below);
        if above.is_empty() && below.is_empty() {
            return;
        }
        if self.overtravel.ignored || self.acts_release() {
            // The release lets an axis go back, not on.
            for axis in self.machine_axes.iter() {
                let velocity = self.manual.velocity(axis);
                if velocity != 0.0 && self.overtravel.blocks(axis, velocity > 0.0) {
                    self.manual.drive(axis, 0.0);
                }
            }
        } else if !matches!(self.state, State::Alarmed(_)) && self.failed.is_none() {
            let upper = above.iter().next();
            let Some(axis) = upper.or(below.iter().next()) else { return };
            let alarm = self.axis_alarm(Fault::HardLimit, axis, upper.is_some());
            let alarm = alarm.with("side", if upper.is_some() { "+" } else { "-" });
            self.come_to_rest();
            self.failed = Some(Box::new(alarm));
        }
    }

    /// Whether an alarm stands that moving an axis back by hand ends.
    pub(super) fn may_leave_switch(&self) -> bool {
        matches!(&self.state, State::Alarmed(alarm) if alarm.fault == Fault::HardLimit)
            && self.overtravel.is_clear()
    }

    /// What becomes of a key that leads an axis onto its switch.
    pub(super) fn off_switch(&self, axis: Axis, way: JogWay) -> JogWay {
        let blocked = match way {
            JogWay::Plus => self.overtravel.blocks(axis, true),
            JogWay::Minus => self.overtravel.blocks(axis, false),
            JogWay::Stop => false,
        };
        if blocked { JogWay::Stop } else { way }
    }

    /// Steps or counts that do not lead an axis onto its switch.
    pub(super) fn steps_off_switch(&self, axis: Axis, steps: i64, increment: f64) -> i64 {
        let upwards = (steps > 0) == (increment > 0.0);
        if steps != 0 && self.overtravel.blocks(axis, upwards) { 0 } else { steps }
    }
}
