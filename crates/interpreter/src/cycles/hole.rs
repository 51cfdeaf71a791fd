//! Drilling and boring cycles (GSK990MC 4.4, Kaitong appendix 7).

use super::{HoleCycle, NoDepth, Peck, Retract};
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
        let step = match (cycle.peck, self.cycle.q.filter(|q| *q > 0.0), self.rules.cycles.no_depth) {
            (Peck::None, ..) => None,
            (_, Some(q), _) | (_, None, NoDepth::Depth(q)) => {
                self.check_pecks(r - z, q)?;
                Some(q)
            }
            (_, None, NoDepth::Alarm) => {
                return Err(self.alarm(Fault::CycleNoPeck, self.cycle_span()));
            }
            (_, None, NoDepth::Position) => return self.position_over_hole(),
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
            Retract::SpindleStopped | Retract::ByHand | Retract::FeedSpindleStopped => {
                let turning = self.technology.spindle;
                self.spindle(SpindleState::Off);
                if cycle.retract == Retract::FeedSpindleStopped {
                    self.cut_z(r)?;
                }
                if cycle.retract == Retract::ByHand {
                    self.emit(Op::Stop(STOP));
                }
                self.rapid_z(top)?;
                self.restart(turning);
                Ok(())
            }
        }
    }

    /// G73: feeds a step, draws back a little, feeds on.
    fn chip_breaking(&mut self, r: f64, z: f64, q: f64) -> Fallible<()> {
        let mut depth = r - q;
        while depth > z + SAME_POINT_MM {
            self.cut_z(depth)?;
            self.rapid_z((depth + self.rules.cycles.chip_break_retract).min(r))?;
            depth -= q;
        }
        self.cut_z(z)
    }

    /// G83: feeds a step, leaves the hole, comes back to a little above where it was, feeds on.
    fn chip_clearing(&mut self, r: f64, z: f64, q: f64) -> Fallible<()> {
        let mut depth = r - q;
        while depth > z + SAME_POINT_MM {
            self.cut_z(depth)?;
            self.rapid_z(r)?;
            self.rapid_z((depth + self.rules.cycles.peck_clearance).min(r))?;
            depth -= q;
        }
        self.cut_z(z)
    }
}
