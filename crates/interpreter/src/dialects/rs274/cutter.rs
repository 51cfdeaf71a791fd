//! Cutter compensation (LinuxCNC, G40 to G42.1): the codes. The geometry is the stage
//! [`OneAhead`](crate::stages::cutter::OneAhead).

use super::blocks::Codes;
use super::codes::MGroup;
use crate::Fallible;
use crate::dialect::{GCode, Meaning};
use crate::interpreter::Interpreter;
use crate::modal::Group;
use crate::stages::cutter::{Offset, Side};
use ferrocut_geometry::{MM_PER_INCH, Plane};
use ferrocut_machine::Fault;

/// How much longer compensation may make an arc than it was before the tool would run it backwards.
const LONGER_INCH: f64 = 0.001;

impl Interpreter {
    /// The block's code of cutter compensation.
    pub(super) fn ngc_cutter(&mut self, row: &'static GCode) -> Fallible<()> {
        let plane = self.modal.plane();
        let side = match row.meaning {
            Meaning::CutterLeft | Meaning::CutterLeftOf => Side::Left,
            Meaning::CutterRight | Meaning::CutterRightOf => Side::Right,
            _ => {
                self.modal.set(row);
                self.output.finish_cutter().map_err(|(fault, _)| self.ngc_alarm(fault))?;
                return self.ngc_set_cutter(plane, None);
            }
        };
        if self.ngc_uvw_plane() || plane == Plane::Yz {
            return Err(self.ngc_alarm(Fault::CutterPlane));
        }
        if self.output.in_cutter_mode() {
            return Err(self.ngc_alarm(Fault::CutterAlreadyOn));
        }
        let radius = match row.meaning {
            Meaning::CutterLeftOf | Meaning::CutterRightOf => self.ngc_radius_word()?,
            _ => self.ngc_tool_radius()?,
        };
        self.modal.set(row);
        // Radians, though LinuxCNC counts them in the units of length.
        self.output.set_longer_arcs(if self.modal.is_inch() {
            LONGER_INCH
        } else {
            LONGER_INCH * MM_PER_INCH
        });
        self.ngc_set_cutter(plane, Some(Offset { side, radius }))
    }

    fn ngc_set_cutter(&mut self, plane: Plane, offset: Option<Offset>) -> Fallible<()> {
        self.output.set_cutter(plane, offset, false).map_err(|(fault, _)| self.ngc_alarm(fault))
    }

    /// D of G41.1 and G42.1 is the diameter; L the orientation of a lathe tool.
    fn ngc_radius_word(&self) -> Fallible<f64> {
        if self.words.has(b'L') {
            self.ngc_check_orientation(self.words.get(b'L').unwrap_or(0.0))?;
        }
        self.ngc_length_word(b'D').map(|diameter| diameter / 2.0).ok_or_else(|| self.ngc_missing(b'D'))
    }

    /// The radius of the tool D; of the one in the spindle for 0, or without D.
    fn ngc_tool_radius(&self) -> Fallible<f64> {
        let tool = match self.ngc_tool_word(b'D')? {
            Some((number, tool)) if number > 0 => tool,
            _ => self.ngc_loaded(),
        };
        self.ngc_check_orientation(f64::from(tool.orientation))?;
        Ok(tool.diameter / 2.0)
    }

    /// Only tools whose tip is their centre are compensated here: mills (0) and round ones (9).
    fn ngc_check_orientation(&self, orientation: f64) -> Fallible<()> {
        match orientation == 0.0 || orientation == 9.0 {
            true => Ok(()),
            false => Err(self.ngc_alarm(Fault::CutterLatheTool)),
        }
    }

    /// Refuses what may not stand in a block while cutter compensation is on, but for what its own code refuses:
    /// other tool lengths, G53, and waiting for an input (LinuxCNC, cutter compensation).
    pub(super) fn ngc_check_cutter(&self, codes: &Codes) -> Fallible<()> {
        let was = self.output.in_cutter_mode();
        let is = codes.g(Group::Cutter).map_or(was, |row| row.meaning != Meaning::CutterOff);
        let waits = codes.m(MGroup::Io).is_some_and(|row| row.code == 66);
        let leaves = codes.g(Group::Length).is_some()
            || codes.g(Group::NonModal).is_some_and(|row| row.meaning == Meaning::MachinePosition);
        match was && waits || is && leaves {
            true => Err(self.ngc_alarm(Fault::NotInCutter)),
            false => Ok(()),
        }
    }
}
