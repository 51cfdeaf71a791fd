//! Drilling and boring cycles (GSK990MC 4.4).

use super::{HoleCycle, Peck, Retract};
use crate::Fallible;
use crate::interpreter::Interpreter;
use ferrocut_geometry::SAME_POINT_MM;
use ferrocut_machine::Fault;
use ferrocut_toolpath::{Op, SpindleState};

/// The program stop that waits for an operator who draws the tool out by hand.
const STOP: u32 = 0;

impl Interpreter {
    /// Cuts one hole.
    pub(super) fn hole(&mut self, cycle: HoleCycle) -> Fallible<()> {
        let Some((r, z)) = self.levels()? else { return Ok(()) };
        if z >= r {
            return Err(self.level_alarm(Fault::CycleDepthAboveR));
        }
        let step = match (cycle.peck, self.cycle.q.filter(|q| *q > 0.0)) {
            (Peck::None, _) => None,
            (_, Some(q)) => {
                self.check_pecks(r - z, q)?;
                Some(q)
            }
            (_, None) if self.rules.peck_needs_depth => {
                return Err(self.alarm(Fault::CycleNoPeck, self.cycle_span()));
            }
            // GSK990MC 4.4.1 note 2, 43#1 = 0: positioned, not drilled.
            (_, None) => return self.position_over_hole(),
        };
        self.position_over_hole()?;
        self.approach(r)?;
        match (cycle.peck, step) {
            (Peck::ChipBreak, Some(q)) => self.chip_breaking(r, z, q)?,
            (Peck::Clear, Some(q)) => self.chip_clearing(r, z, q)?,
            _ => self.cut_z(z)?,
        }
        if cycle.dwell {
            self.cycle_dwell();
        }
        let top = self.top(r);
        match cycle.retract {
            Retract::Rapid => self.rapid_z(top),
            Retract::Feed => {
                self.cut_z(r)?;
                self.rapid_z(top)
            }
            Retract::SpindleStopped | Retract::ByHand => {
                let turning = self.technology.spindle;
                self.spindle(SpindleState::Off);
                if cycle.retract == Retract::ByHand {
                    self.emit(Op::Stop(STOP));
                }
                self.rapid_z(top)?;
                self.spindle(turning);
                Ok(())
            }
        }
    }

    /// G73: feeds a step, draws back by d (P270), feeds on.
    fn chip_breaking(&mut self, r: f64, z: f64, q: f64) -> Fallible<()> {
        let mut depth = r - q;
        while depth > z + SAME_POINT_MM {
            self.cut_z(depth)?;
            self.rapid_z((depth + self.rules.chip_break_retract).min(r))?;
            depth -= q;
        }
        self.cut_z(z)
    }

    /// G83: feeds a step, leaves the hole, comes back to d (P271) above where it was, feeds on.
    fn chip_clearing(&mut self, r: f64, z: f64, q: f64) -> Fallible<()> {
        let mut depth = r - q;
        while depth > z + SAME_POINT_MM {
            self.cut_z(depth)?;
            self.rapid_z(r)?;
            self.rapid_z((depth + self.rules.peck_clearance).min(r))?;
            depth -= q;
        }
        self.cut_z(z)
    }
}
