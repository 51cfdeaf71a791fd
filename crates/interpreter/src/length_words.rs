//! The words of tool length compensation: G43, G44, G49 and H (GSK990MC 4.5).

use crate::Fallible;
use crate::dialect::{GCode, Meaning};
use crate::execute::Codes;
use crate::interpreter::Interpreter;
use crate::modal::Group;
use crate::words::Code;
use ferrocut_geometry::{Axis, AxisSet, Position};
use ferrocut_machine::Fault;

impl Interpreter {
    /// G43, G44, G49. Once a cycle is in force some controls leave them and H aside, also as modal codes
    /// (Kaitong appendix 8, note 2).
    pub(crate) fn length_code(&mut self, row: Option<&'static GCode>, codes: &mut Codes) -> Fallible<()> {
        if self.rules.cycles.length_at_start_only && self.cycle.is_active() {
            if row.is_some() || self.words.has(b'H') {
                let code = self.words.g.iter().find(|code| code.row.group == Group::Length);
                let span = code.map_or_else(|| self.words.span(b'H'), |code| code.span);
                self.tell(*self.alarm(Fault::LengthInCycle, span));
            }
            self.words.take(b'H');
            return Ok(());
        }
        if let Some(row) = row {
            codes.length = Some(row.meaning);
            self.modal.set(row);
        }
        let acts = row.is_some() || self.words.has(b'H') && !self.in_force(Group::Length, Meaning::LengthOff);
        if !acts {
            return Ok(());
        }
        let refused = |c: &Code<GCode>| self.rules.length_not_with.iter().find(|(t, _)| *t == c.row.tenths);
        match self.words.g.iter().find_map(|c| Some((refused(c)?.1, c.span))) {
            Some((fault, span)) => Err(self.alarm(fault, span)),
            None => Ok(()),
        }
    }

    /// A change of tool length in a block that does not move by it: the axis takes it up when it is next moved.
    pub(crate) fn defer_length(&mut self, code: Option<Meaning>) -> Fallible<()> {
        self.keep_length_number()?;
        if !self.length_ends(code) && self.modal.meaning(Group::Length) != Meaning::LengthOff {
            self.location.length.waits = true;
        }
        Ok(())
    }

    /// A change of tool length that waits for its axis is taken up by a code that moves `axes` by itself.
    pub(crate) fn take_up_waiting_length(&mut self, moves: Meaning, axes: AxisSet) -> Fallible<()> {
        let goes_to_point = matches!(
            moves,
            Meaning::ReferenceReturn | Meaning::FurtherReferenceReturn | Meaning::Skip | Meaning::OneWay
        );
        if goes_to_point && self.location.length.waits && !self.words.has(b'H') {
            self.length_words(None, axes)?;
        }
        Ok(())
    }

    /// Whether the block ends tool length compensation.
    pub(crate) fn length_ends(&self, code: Option<Meaning>) -> bool {
        code == Some(Meaning::LengthOff) || !self.rules.h00_waits && self.words.get(b'H') == Some(0.0)
    }

    /// A change of tool length in a block whose coordinates are not for a move: the axis moves by it alone.
    pub(crate) fn length_by_itself(&mut self, code: Option<Meaning>) -> Fallible<()> {
        let was = self.location.length.vector;
        if !self.length_words(code, AxisSet::EMPTY)? {
            return Ok(());
        }
        self.rapid_machine(self.location.machine + self.location.length.vector - was)
    }

    /// H into force as the number that G43 and G44 take.
    pub(crate) fn keep_length_number(&mut self) -> Fallible<()> {
        if let Some(h) = self.words.get(b'H') {
            if self.memory.tools.get(h as u16).is_none() {
                return Err(self.alarm_at(Fault::OffsetNumber, b'H'));
            }
            self.location.length.number = h as u16;
        }
        Ok(())
    }

    /// G43, G44, G49 and H. True if an axis is to move by the change although it is not named
    /// (GSK990MC 4.7.1: without a move the change is made at once).
    pub(crate) fn length_words(&mut self, code: Option<Meaning>, axes: AxisSet) -> Fallible<bool> {
        let h = self.words.get(b'H');
        if code == Some(Meaning::LengthOff) {
            let was = self.location.length.vector;
            self.location.length.cancel();
            return Ok(was != Position::ZERO);
        }
        let sign = match self.modal.meaning(Group::Length) {
            Meaning::LengthPlus => 1.0,
            Meaning::LengthMinus => -1.0,
            // H without G43 waits for it.
            _ => return self.keep_length_number().map(|()| false),
        };
        let axis = self.length_axis();
        if let Some(h) = h {
            let Some(offset) = self.memory.tools.get(h as u16) else {
                return Err(self.alarm_at(Fault::OffsetNumber, b'H'));
            };
            self.location.length.number = h as u16;
            // H00 alone waits for the axis or for a code of its group (GSK990MC 4.7.1, 4).
            if self.rules.h00_waits && h == 0.0 && code.is_none() && !axes.contains(axis) {
                self.location.length.waits = true;
                return Ok(false);
            }
            return self.take_length(axis, sign * (offset.length + offset.length_wear));
        }
        let takes_up = self.location.length.waits && axes.contains(axis);
        if code.is_none() && !takes_up {
            return Ok(false);
        }
        let number = self.location.length.number;
        let offset = self.memory.tools.get(number).copied().unwrap_or_default();
        self.take_length(axis, sign * (offset.length + offset.length_wear))
    }

    /// A length of the table onto its axis.
    fn take_length(&mut self, axis: Axis, value: f64) -> Fallible<bool> {
        match value.abs() > self.rules.max_offset {
            true => Err(self.alarm_at(Fault::OffsetTooLarge, b'H')),
            false => Ok(self.put_length(axis, value)),
        }
    }

    pub(crate) fn put_length(&mut self, axis: Axis, value: f64) -> bool {
        let changed = self.location.length.vector[axis] != value;
        self.location.length.set(axis, value);
        changed
    }
}
