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
        if let Some(q) = step {
            self.pecks(r, z, q, cycle.peck == Peck::Clear)?;
        }
        self.cut_z(z)?;
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

    /// All pecks but the last. After each the tool draws back a little (G73), or leaves the hole and comes back
    /// to a little above where it was (G83).
    fn pecks(&mut self, r: f64, z: f64, q: f64, clears: bool) -> Fallible<()> {
        let rules = &self.rules.cycles;
        let back = if clears { rules.peck_clearance } else { rules.chip_break_retract };
        let mut depth = r - q;
        while depth > z + SAME_POINT_MM {
            self.cut_z(depth)?;
            if clears {
                self.rapid_z(r)?;
            }
            self.rapid_z((depth + back).min(r))?;
            depth -= q;
        }
        Ok(())
    }
}
