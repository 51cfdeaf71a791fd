//! Tapping cycles (GSK990MC 4.4.5, 4.5).
//!
//! After M29 tapping is rigid: feed and spindle are one motion of a pitch F/S (G94) or F (G95). Without
//! it the tap sits in a floating holder and the spindle is reversed at the bottom.

use crate::Fallible;
use crate::interpreter::Interpreter;
use ferrocut_geometry::{Axis, SAME_POINT_MM};
use ferrocut_machine::Fault;
use ferrocut_toolpath::{Feed, Op, SpindleState};

impl Interpreter {
    /// Taps one hole.
    pub(super) fn tap(&mut self, left: bool) -> Fallible<()> {
        let Some((r, z)) = self.levels()? else { return Ok(()) };
        if z >= r {
            return Err(self.level_alarm(Fault::CycleDepthAboveR));
        }
        let q = self.cycle.q.filter(|q| *q > 0.0);
        if let Some(q) = q {
            self.check_pecks(r - z, q)?;
        }
        let rpm = self.technology.speed.unwrap_or(0.0);
        let rigid = self.taps_rigidly();
        let limit = if rigid { self.rules.max_rigid_rpm } else { self.rules.max_tapping_rpm };
        if rpm <= 0.0 || rpm > limit {
            return Err(self.alarm(Fault::TappingSpeed, self.cycle_span()));
        }
        if rigid && !self.feed_was_given() {
            return Err(self.alarm(Fault::TappingFeed, self.cycle_span()));
        }
        self.position_over_hole()?;
        self.approach(r)?;
        if rigid {
            if self.rules.rigid_tapping_orients {
                self.emit(Op::Orient(0.0));
            }
            // The spindle is an axis of the tapping from here on, and stands still after it (4.5.1).
            self.technology.spindle = SpindleState::Off;
            let pitch = match self.feed()? {
                Feed::PerMinute(feed) => feed / rpm,
                Feed::PerRevolution(feed) => feed,
                Feed::Duration(_) => 0.0,
            };
            let pitch = if left { -pitch } else { pitch };
            let out_rpm = rpm * self.rules.rigid_retract;
            self.tap_steps(r, z, q, |interpreter, z| {
                let down = z < interpreter.location.programmed[Axis::Z];
                interpreter.tap_z(z, pitch, if down { rpm } else { out_rpm })
            })?;
        } else {
            self.tap_floating(r, z, q, left)?;
        }
        self.rapid_z(self.top(r))
    }

    /// Whether tapping cycles are rigid now.
    pub(super) fn taps_rigidly(&self) -> bool {
        self.technology.rigid_tapping && self.rules.rigid_tapping
    }

    /// Whether a feed of the kind in force was ever programmed.
    fn feed_was_given(&self) -> bool {
        match self.modal.is_feed_per_revolution() {
            true => self.technology.feed_per_revolution > 0.0,
            false => self.technology.feed_per_minute_was_given,
        }
    }

    /// The strokes of a tap, in one go or in steps of Q. `stroke` moves to a level, up or down.
    ///
    /// A step ends with a draw-back by V or P284 (high-speed, 44#5 = 1) or to the R level (standard).
    fn tap_steps(
        &mut self,
        r: f64,
        z: f64,
        q: Option<f64>,
        mut stroke: impl FnMut(&mut Interpreter, f64) -> Fallible<()>,
    ) -> Fallible<()> {
        let retract = self.cycle.v.unwrap_or(self.rules.peck_tapping_retract);
        if let Some(q) = q {
            let mut depth = r - q;
            while depth > z + SAME_POINT_MM {
                stroke(self, depth)?;
                let back = (depth + retract).min(r);
                if !self.rules.peck_tapping_is_fast {
                    stroke(self, r)?;
                }
                stroke(self, back)?;
                depth -= q;
            }
        }
        stroke(self, z)?;
        self.cycle_dwell();
        stroke(self, r)?;
        self.cycle_dwell();
        Ok(())
    }

    /// A rigid stroke.
    fn tap_z(&mut self, z: f64, pitch: f64, rpm: f64) -> Fallible<()> {
        let mut to = self.location.programmed;
        to[Axis::Z] = z;
        let machine = self.location.machine_of(to);
        self.check_reach(machine)?;
        self.location.programmed = to;
        if machine != self.location.machine {
            self.location.machine = machine;
            self.emit(Op::Tap { to: machine, pitch, rpm });
        }
        Ok(())
    }

    /// Tapping with a floating holder: the spindle turns into the thread and is reversed for the way
    /// out. A spindle at rest is started at the R level (GSK990MC 4.4.5).
    fn tap_floating(&mut self, r: f64, z: f64, q: Option<f64>, left: bool) -> Fallible<()> {
        let speed = self.speed();
        let (inward, outward) = match left {
            false => (SpindleState::Clockwise(speed), SpindleState::CounterClockwise(speed)),
            true => (SpindleState::CounterClockwise(speed), SpindleState::Clockwise(speed)),
        };
        self.tap_steps(r, z, q, |interpreter, z| {
            let down = z < interpreter.location.programmed[Axis::Z];
            interpreter.spindle(if down { inward } else { outward });
            interpreter.cut_z(z)
        })?;
        self.spindle(inward);
        Ok(())
    }
}
