//! What each motion code does (LinuxCNC, G0 to G3, G5 to G5.3, G33, G38.2 to G38.5, G73 to G89).

use crate::Fallible;
use crate::dialect::{GCode, Meaning};
use crate::interpreter::Interpreter;
use crate::modal::Group;
use ferrocut_geometry::Turn;
use ferrocut_machine::Fault;

impl Interpreter {
    /// The move of a block by the motion code in force. `is_given`: the block names it.
    pub(super) fn ngc_move(&mut self, row: &'static GCode, is_given: bool) -> Fallible<()> {
        let axes = self.words.axes(self.rules.axes);
        let goes_on = self.modal.code(Group::Motion).is_some_and(|code| code.tenths == row.tenths);
        let moves = !axes.is_empty();
        let needs_axes = !matches!(
            row.meaning,
            Meaning::Rapid
                | Meaning::Linear
                | Meaning::ArcClockwise
                | Meaning::ArcCounterClockwise
                | Meaning::Nurbs
                | Meaning::NurbsEnd
                | Meaning::CycleOff
                | Meaning::LatheCycle
        );
        if is_given && needs_axes && !moves {
            return Err(self.ngc_alarm(Fault::AxesMissing));
        }
        // G5 and G5.1 are done and leave the code in force as it is; G5.3 leaves none.
        if !matches!(row.meaning, Meaning::CubicSpline | Meaning::QuadraticSpline | Meaning::NurbsEnd) {
            self.modal.set(row);
        }
        if !matches!(row.meaning, Meaning::Cycle(_)) {
            self.ngc.cycles.end();
        }
        if !goes_on && row.meaning == Meaning::Nurbs {
            self.ngc_forget_nurbs();
        }
        match row.meaning {
            Meaning::CycleOff => Ok(()),
            Meaning::Rapid => self.ngc_rapid(self.ngc_end_point(axes)),
            Meaning::Linear => self.ngc_cut(self.ngc_end_point(axes)),
            Meaning::ArcClockwise => self.ngc_arc(axes, Turn::Clockwise),
            Meaning::ArcCounterClockwise => self.ngc_arc(axes, Turn::CounterClockwise),
            Meaning::CubicSpline | Meaning::QuadraticSpline => self.ngc_spline(axes, row.meaning),
            Meaning::Nurbs => self.ngc_nurbs(),
            Meaning::NurbsEnd => self.ngc_nurbs_end(),
            Meaning::Synchronised => self.ngc_synchronised(axes, false),
            Meaning::RigidTap => self.ngc_synchronised(axes, true),
            Meaning::Threading => self.ngc_thread(axes),
            Meaning::Probe { away, needs_contact } => self.ngc_probe(axes, away, needs_contact),
            Meaning::Cycle(kind) => self.ngc_cycle(kind, axes, goes_on),
            _ => Err(self.ngc_alarm(Fault::NotSupported)),
        }
    }
}
