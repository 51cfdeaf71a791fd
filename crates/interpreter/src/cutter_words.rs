//! The words of cutter compensation and of corners: G40 to G42, D, `,R` and `,L` (GSK990MC 4.7).

use crate::Fallible;
use crate::dialect::{MFunction, Meaning};
use crate::interpreter::Interpreter;
use crate::modal::Group;
use crate::stages::cutter::{Offset, Side};
use crate::words::{self};
use ferrocut_machine::{Fault, ToolOffset};
use ferrocut_program::Span;
use ferrocut_toolpath::Op;

impl Interpreter {
    /// Radius of a row of the offset table, which may hold diameters (40#7), mm.
    pub(crate) fn tool_radius(&self, row: &ToolOffset) -> f64 {
        let entered = row.radius + row.radius_wear;
        if self.rules.radius_is_diameter { entered / 2.0 } else { entered }
    }

    /// D of the tool in the spindle; with M6 it is that of the tool that comes.
    pub(crate) fn offset_word(&mut self) {
        let changes = self.words.m.iter().any(|m| m.row.function == MFunction::ToolChange);
        if let Some(edge) = self.words.get(b'D').filter(|_| !changes) {
            self.edge_chosen(edge);
        }
    }

    /// G40, G41, G42 and D (GSK990MC 4.7.2).
    pub(crate) fn cutter_words(&mut self, code: bool) -> Fallible<()> {
        if let Some(number) = self.words.get(b'D').filter(|_| !self.rules.tools_carry_offsets) {
            self.technology.radius_number = number;
        }
        let side = match self.modal.meaning(Group::Cutter) {
            Meaning::CutterLeft => Side::Left,
            Meaning::CutterRight => Side::Right,
            _ if code => return self.cancel_cutter(),
            _ => return Ok(()),
        };
        // D00 is no compensation.
        if self.technology.radius_number == 0.0 {
            return self.cancel_cutter();
        }
        let Some(row) = self.memory.tools.get(self.technology.radius_number as u16) else {
            return Err(self.alarm_at(Fault::OffsetNumber, b'D'));
        };
        if (row.radius + row.radius_wear).abs() > self.rules.max_offset {
            return Err(self.alarm_at(Fault::OffsetTooLarge, b'D'));
        }
        let radius = self.tool_radius(row);
        let plane = self.modal.plane();
        if radius != 0.0 {
            self.refuse_rotary_plane(plane, self.words.block_span())?;
        }
        // A mirrored path has the tool on its other side (GSK990MC 4.2.14 note 2).
        let mirrored = self.location.scaling.is_some_and(|scaling| scaling.reverses(plane))
            ^ self.location.nested.is_some_and(|nested| nested.reverses(plane));
        let side = if mirrored { side.other() } else { side };
        let offset = Some(Offset { side, radius });
        // G41 or G42 given again ends the block before square (GSK990MC 4.7.3, 7).
        let square = code && self.output.is_on_side(side);
        self.set_cutter(offset, square)
    }

    /// G40. In a block that does not move in the plane the last move ends square to itself.
    pub(crate) fn cancel_cutter(&mut self) -> Fallible<()> {
        let plane = self.modal.plane();
        let moves = [plane.first(), plane.second()].into_iter().any(|a| self.words.has(a.letter() as u8));
        self.set_cutter(None, !moves && self.output.in_cutter_mode())
    }

    fn set_cutter(&mut self, offset: Option<Offset>, square: bool) -> Fallible<()> {
        let done = self.output.set_cutter(self.modal.plane(), offset, square);
        done.map_err(|(fault, span)| self.alarm(fault, span))
    }

    /// G39 (GSK990MC 4.7.4).
    pub(crate) fn corner_arc(&mut self, span: Span) -> Fallible<()> {
        let has_words = self.words.has_any(words::AXIS_LETTERS | words::letters(b"IJKR"));
        if !self.rules.corner_arc || !self.output.in_cutter_mode() || has_words {
            return Err(self.alarm(Fault::CornerArcForm, span));
        }
        let op = Op::Feed { to: self.location.machine, feed: self.feed()?, path: self.path_mode() };
        let step = self.step(op);
        self.output.corner_arc(step).map_err(|(fault, span)| self.alarm(fault, span))
    }
}
