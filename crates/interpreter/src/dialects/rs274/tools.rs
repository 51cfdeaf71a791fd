//! Tools: T, M6, M61, and their length G43 to G43.2, G49 (LinuxCNC, tool table).
//!
//! Where a tool table was given, only its tools exist. Without one any tool does, with what the set-up file
//! says of its length and radius.

use super::blocks::Codes;
use super::codes::MGroup;
use crate::Fallible;
use crate::dialect::{GCode, Meaning};
use crate::interpreter::Interpreter;
use crate::words::AXIS_LETTERS;
use ferrocut_geometry::{Axis, Position};
use ferrocut_machine::{Fault, Tool};
use ferrocut_toolpath::{Op, SpindleState};

/// A number that a word gives is as whole as a neighbour that is so close.
const WHOLE: f64 = super::expressions::WHOLE;

impl Interpreter {
    /// The tool with a number; none where a tool table lacks it.
    pub(super) fn ngc_tool(&self, number: u32) -> Option<Tool> {
        if let Some(library) = &self.memory.library {
            return match number {
                // No tool.
                0 => Some(library.get(0).copied().unwrap_or_default()),
                _ => library.get(number).copied(),
            };
        }
        let row =
            u16::try_from(number).ok().and_then(|n| self.memory.tools.get(n).copied()).unwrap_or_default();
        let mut tool = Tool { pocket: number, ..Tool::default() };
        tool.length[Axis::Z] = row.length + row.length_wear;
        tool.diameter = 2.0 * (row.radius + row.radius_wear);
        Some(tool)
    }

    /// The whole number of a word that names a tool, and the tool.
    pub(super) fn ngc_tool_word(&self, letter: u8) -> Fallible<Option<(u32, Tool)>> {
        let Some(value) = self.words.get(letter) else { return Ok(None) };
        let number = value.round();
        if (value - number).abs() > WHOLE {
            return Err(self.alarm_at(Fault::WordNotWhole, letter));
        }
        let tool = match (0.0..=f64::from(u32::MAX)).contains(&number) {
            true => self.ngc_tool(number as u32),
            false => None,
        };
        match tool {
            Some(tool) => Ok(Some((number as u32, tool))),
            None => {
                let mut alarm = self.alarm_at(Fault::ToolMissing, letter);
                alarm.arguments.push(("tool", number.into()));
                Err(alarm)
            }
        }
    }

    /// T, M6 and M61.
    pub(super) fn ngc_tool_words(&mut self, codes: &Codes) -> Fallible<()> {
        if let Some((number, _)) = self.ngc_tool_word(b'T')? {
            self.technology.tool = number;
            self.emit(Op::Select(number));
        }
        match codes.m(MGroup::Tool).map(|row| row.code) {
            Some(6) => {
                if self.ngc_in_compensation() {
                    return Err(self.ngc_alarm(Fault::ToolInCutter));
                }
                // No program of this language is run, and a ladder that does nothing by M06 would leave the old tool.
                if self.options.tool_change_program.is_some()
                    && self.technology.tool != self.technology.in_spindle
                {
                    return Err(self.ngc_alarm(Fault::NobodyChangesTool));
                }
                // The spindle stands still while a tool is changed.
                self.spindle(SpindleState::Off);
                self.ngc_load(self.technology.tool);
                self.emit(Op::Change(self.technology.tool));
            }
            Some(_) => {
                if !self.words.get(b'Q').is_some_and(|q| q > -WHOLE) {
                    return Err(self.ngc_missing(b'Q'));
                }
                if let Some((number, _)) = self.ngc_tool_word(b'Q')? {
                    self.ngc_load(number);
                    self.technology.tool = number;
                }
            }
            None => {}
        }
        Ok(())
    }

    /// The tool is in the spindle.
    fn ngc_load(&mut self, number: u32) {
        self.technology.in_spindle = number;
    }

    /// The tool in the spindle.
    pub(super) fn ngc_loaded(&self) -> Tool {
        self.ngc_tool(self.technology.in_spindle).unwrap_or_default()
    }

    /// G43, G43.1, G43.2, G49.
    pub(super) fn ngc_length(&mut self, row: &'static GCode) -> Fallible<()> {
        let mut length = self.ngc.length;
        match row.meaning {
            Meaning::LengthPlus => {
                length = match self.ngc_tool_word(b'H')? {
                    // H0 is the tool in the spindle.
                    Some((number, tool)) if number > 0 => tool.length,
                    _ => self.ngc_loaded().length,
                };
            }
            Meaning::LengthOf => {
                // Axes that are not named keep theirs.
                for axis in self.words.axes(self.rules.axes).iter() {
                    length[axis] = self.ngc_axis_word(axis).unwrap_or(length[axis]);
                }
            }
            Meaning::LengthMore if self.words.has(b'H') && self.words.has_any(AXIS_LETTERS) => {
                return Err(self.ngc_alarm(Fault::CodesContradict));
            }
            Meaning::LengthMore => match self.ngc_tool_word(b'H')? {
                Some((_, tool)) => length = length + tool.length,
                None => {
                    let axes = self.words.axes(self.rules.axes);
                    if axes.is_empty() {
                        return Err(self.ngc_missing(b'H'));
                    }
                    for axis in axes.iter() {
                        length[axis] += self.ngc_axis_word(axis).unwrap_or(0.0);
                    }
                }
            },
            _ => length = Position::ZERO,
        }
        self.modal.set(row);
        self.ngc_set_length(length);
        Ok(())
    }

    /// Puts a tool length in force: the axes stand still, and their coordinates become others.
    pub(super) fn ngc_set_length(&mut self, length: Position) {
        self.ngc.at = self.ngc.at + self.ngc.turn.undo(self.ngc.length) - self.ngc.turn.undo(length);
        self.ngc.length = length;
    }
}
