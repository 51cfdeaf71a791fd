//! Drilling and boring cycles (GSK990MC 4.4).

use super::{HoleCycle, MAX_PECKS, Peck, Retract};
use crate::Fallible;
use crate::dialect::Meaning;
use crate::interpreter::Interpreter;
use crate::modal::Group;
use ferrocut_geometry::{Axis, SAME_POINT_MM};
use ferrocut_machine::Fault;
use ferrocut_toolpath::{Dwell, Op, SpindleState};

impl Interpreter {
    /// Cuts one hole.
    pub(super) fn hole(&mut self, cycle: HoleCycle) -> Fallible<()> {
        let (Some(r), Some(z)) = (self.cycle.r, self.cycle.z) else {
            // Without Z or R the tool is positioned only (GSK990MC 4.4.1).
            return self.position_over_hole();
        };
        if z >= r {
            return Err(
                self.alarm_at(Fault::CycleDepthAboveR, if self.words.has(b'Z') { b'Z' } else { b'R' })
            );
        }
        let step = match cycle.peck {
            Peck::None => None,
            _ => match self.cycle.q.filter(|q| *q > 0.0) {
                Some(q) if (r - z) / q > MAX_PECKS => return Err(self.alarm_at(Fault::WordOutOfRange, b'Q')),
                Some(q) => Some(q),
                None if self.rules.peck_needs_depth => {
                    return Err(self.alarm(Fault::CycleNoPeck, self.cycle_span()));
                }
                // GSK990MC 4.4.1 note 2, 43#1 = 0: positioned, not drilled.
                None => return self.position_over_hole(),
            },
        };
        self.position_over_hole()?;
        self.rapid_z(r)?;
        match (cycle.peck, step) {
            (Peck::ChipBreak, Some(q)) => self.chip_breaking(r, z, q)?,
            (Peck::Clear, Some(q)) => self.chip_clearing(r, z, q)?,
            _ => self.cut_z(z)?,
        }
        if let Some(seconds) = self.cycle.p.filter(|_| cycle.dwell) {
            self.emit(Op::Dwell(Dwell::Seconds(seconds)));
        }
        let returns_to_r = self.modal.meaning(Group::Return) == Meaning::ReturnR;
        let top = if returns_to_r { r } else { self.cycle.initial };
        match cycle.retract {
            Retract::Rapid => self.rapid_z(top),
            Retract::Feed => {
                self.cut_z(r)?;
                self.rapid_z(top)
            }
            Retract::SpindleStopped => {
                let turning = self.technology.spindle;
                self.spindle(SpindleState::Off);
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

    fn rapid_z(&mut self, z: f64) -> Fallible<()> {
        let mut to = self.location.programmed;
        to[Axis::Z] = z;
        self.rapid(to)
    }

    fn cut_z(&mut self, z: f64) -> Fallible<()> {
        let mut to = self.location.programmed;
        to[Axis::Z] = z;
        self.cut(to)
    }
}
