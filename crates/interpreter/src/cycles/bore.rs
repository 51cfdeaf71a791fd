//! Borings that move the stopped, oriented tool aside (GSK990MC 4.4.6, 4.4.9; Kaitong appendix 7, 2.3 and
//! 2.10).
//!
//! The axis and direction of the move aside are parameters; rotation does not turn them (GSK990MC 4.4.9
//! note).

use crate::Fallible;
use crate::interpreter::Interpreter;
use ferrocut_machine::Fault;
use ferrocut_toolpath::{Op, SpindleState};

impl Interpreter {
    /// G76: feeds down, pauses, orients, moves aside, leaves at rapid, moves back.
    pub(super) fn fine_bore(&mut self) -> Fallible<()> {
        let Some((r, z)) = self.levels()? else { return Ok(()) };
        if z >= r {
            return Err(self.level_alarm(Fault::CycleDepthAboveR));
        }
        self.check_orients()?;
        self.position_over_hole()?;
        self.approach(r)?;
        self.cut_z(z)?;
        self.cycle_dwell();
        let turning = self.orient();
        self.shift(1.0)?;
        self.rapid_z(self.top(r))?;
        self.shift(-1.0)?;
        self.restart(turning);
        Ok(())
    }

    /// G87: orients and moves aside above the hole, passes through it to R, which is the bottom, and
    /// cuts upwards to Z. It always returns to the initial level.
    pub(super) fn back_bore(&mut self) -> Fallible<()> {
        let Some((r, z)) = self.levels()? else { return Ok(()) };
        if z <= r {
            return Err(self.level_alarm(Fault::CycleDepthBelowR));
        }
        self.check_orients()?;
        self.position_over_hole()?;
        let turning = self.orient();
        self.shift(1.0)?;
        self.approach(r)?;
        self.shift(-1.0)?;
        self.restart(turning);
        self.cut_z(z)?;
        self.cycle_dwell();
        let turning = self.orient();
        self.shift(1.0)?;
        self.rapid_z(self.cycle.initial)?;
        if self.rules.cycles.restart_aside {
            self.restart(turning);
            return self.shift(-1.0);
        }
        self.shift(-1.0)?;
        self.restart(turning);
        Ok(())
    }

    /// Whether the spindle can stop at an angle: one that is switched by I/O points cannot.
    pub(super) fn check_orients(&self) -> Fallible<()> {
        match self.rules.spindle_has_position {
            true => Ok(()),
            false => Err(self.alarm(Fault::NoOrientation, self.cycle_span())),
        }
    }

    /// Stops the spindle at its angle; what it was doing is returned.
    fn orient(&mut self) -> SpindleState {
        let turning = self.technology.spindle;
        self.technology.spindle = SpindleState::Off;
        self.emit(Op::Orient(0.0));
        turning
    }

    /// Moves aside by Q, or back. The programmed point stays over the hole.
    fn shift(&mut self, sense: f64) -> Fallible<()> {
        let (axis, direction) = self.rules.cycles.shift;
        let distance = self.cycle.q.filter(|q| *q > 0.0).unwrap_or(self.rules.cycles.default_shift);
        if distance == 0.0 {
            self.tell_once(Fault::NoShift);
        }
        let mut to = self.location.machine;
        to[axis] += sense * direction * distance;
        self.rapid_machine(to)?;
        self.location.take_machine();
        Ok(())
    }
}
