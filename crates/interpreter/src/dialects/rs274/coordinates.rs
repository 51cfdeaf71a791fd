//! Coordinate systems: G10, G52, G54 to G59.3, G92 to G92.3, and the positions G28 and G30 (LinuxCNC).
//!
//! Zeros are kept with the machine's work offsets, their turns in the parameters 5230, 5250 …; parameters that
//! are other names of them are read and written in `parameters`.

use super::expressions::WHOLE;
use super::parameters::{FIRST_SHIFT, SHIFT_IN_FORCE, SYSTEM, turn_of_system};
use super::state::Turned;
use crate::Fallible;
use crate::dialect::{GCode, Meaning};
use crate::interpreter::Interpreter;
use crate::modal::Group;
use ferrocut_geometry::{Axis, AxisSet, Plane, Position};
use ferrocut_machine::{Fault, WorkOffset};

/// Coordinate systems.
pub(super) const SYSTEMS: u8 = 9;

/// G59.3, which tool lengths may be measured against (G10 L11).
const FIXTURE: u8 = 9;

/// The name of a coordinate system in the memory of the machine: 1 is G54, 7 is G59.1.
pub(crate) fn system_name(number: u8) -> WorkOffset {
    match number {
        1..=6 => WorkOffset::Standard(number),
        _ => WorkOffset::Additional(u16::from(number.saturating_sub(6))),
    }
}

impl Interpreter {
    /// Zero of a coordinate system, the external one left aside.
    fn ngc_own_zero_of(&self, number: u8) -> Position {
        self.memory.work.get(system_name(number)).unwrap_or_default()
    }

    /// Zero and turn of a coordinate system.
    pub(super) fn ngc_zero_of(&self, number: u8) -> (Position, Turned) {
        let zero = self.ngc_own_zero_of(number);
        let external = self.memory.work.external;
        let degrees = self.memory.variables.get(turn_of_system(number)).unwrap_or(0.0);
        (zero + external, Turned::by(degrees))
    }

    /// Coordinate system and shift as the parameters have them at the start.
    pub(crate) fn ngc_start(&mut self) {
        let variables = &self.memory.variables;
        let number = variables.get(SYSTEM).filter(|n| (1.0..=f64::from(SYSTEMS)).contains(n));
        let number = number.map_or(1, |n| n as u8);
        self.ngc.shift = Position::ZERO;
        if variables.get(SHIFT_IN_FORCE) == Some(1.0) {
            for axis in Axis::ALL {
                let value = variables.get(FIRST_SHIFT + axis.index() as u32);
                self.ngc.shift[axis] = value.unwrap_or(0.0);
            }
        }
        let row = self.dialect.g_codes.iter().find(|row| row.meaning == Meaning::WorkOffset(number));
        if let Some(row) = row {
            self.modal.set(row);
        }
        self.ngc_take_system(number);
    }

    /// Whether cutter compensation is in force.
    pub(super) fn ngc_in_compensation(&self) -> bool {
        self.modal.meaning(Group::Cutter) != Meaning::CutterOff
    }

    /// Notes that what lies between program and machine changed; the axes stand still.
    pub(super) fn ngc_moved_zero(&mut self) {
        self.ngc.at = self.ngc.program_of(self.location.machine);
        self.location.work.shift = self.ngc.machine_of(Position::ZERO) - self.ngc.length;
        self.variable_writes += 1;
    }

    /// G17, G18, G19.
    pub(super) fn ngc_plane(&mut self, row: &'static GCode) -> Fallible<()> {
        // A lathe's compensation works in XZ, a mill's in XY too (LinuxCNC, G41): in no other, and in one at a
        // time.
        if self.ngc_in_compensation() && row.meaning != Meaning::Plane(self.modal.plane()) {
            let is_other = !matches!(row.meaning, Meaning::Plane(Plane::Xy | Plane::Zx | Plane::Yz))
                || row.meaning != self.modal.meaning(Group::Plane);
            if is_other {
                return Err(self.ngc_alarm(Fault::PlaneInCutter));
            }
        }
        self.modal.set(row);
        Ok(())
    }

    /// G54 to G59.3.
    pub(super) fn ngc_system(&mut self, row: &'static GCode) -> Fallible<()> {
        let Meaning::WorkOffset(number) = row.meaning else { return Ok(()) };
        if self.ngc_in_compensation() {
            return Err(self.ngc_alarm(Fault::WorkOffsetInCutter));
        }
        self.modal.set(row);
        // The one in force stays as it is, whatever its parameters say by now.
        if self.ngc.system != number {
            self.ngc_take_system(number);
        }
        Ok(())
    }

    /// The coordinate system in force.
    pub(crate) fn ngc_system_name(&self) -> WorkOffset {
        system_name(self.ngc.system)
    }

    /// Puts a coordinate system in force.
    pub(crate) fn ngc_take_system(&mut self, number: u8) {
        self.ngc.system = number;
        (self.ngc.zero, self.ngc.turn) = self.ngc_zero_of(number);
        self.ngc_remember(SYSTEM, f64::from(number));
        self.ngc_moved_zero();
    }

    /// Sets a parameter that there is room for.
    fn ngc_remember(&mut self, number: u32, value: f64) {
        let _ = self.memory.variables.set(number, Some(value));
    }

    /// Codes that act alone and take words for themselves.
    pub(super) fn ngc_non_modal(&mut self, row: &'static GCode) -> Fallible<()> {
        match row.meaning {
            Meaning::DataSetting => self.ngc_data(),
            Meaning::ReferenceReturn => self.ngc_reference(0),
            Meaning::FurtherReferenceReturn => self.ngc_reference(1),
            Meaning::SaveReference if self.ngc_in_compensation() => Err(self.ngc_alarm(Fault::NotInCutter)),
            Meaning::SaveReference => {
                let place = usize::from(row.tenths == 301);
                if let Some(point) = self.memory.reference_points.get_mut(place) {
                    *point = self.location.machine;
                }
                self.variable_writes += 1;
                Ok(())
            }
            Meaning::SetPosition
            | Meaning::LocalZero
            | Meaning::ShiftCleared
            | Meaning::ShiftSuspended
            | Meaning::ShiftRestored => self.ngc_shift(row.meaning),
            _ => Ok(()),
        }
    }

    /// G92 to G92.3 and G52, which share one shift of all systems.
    fn ngc_shift(&mut self, meaning: Meaning) -> Fallible<()> {
        if self.ngc_in_compensation() && matches!(meaning, Meaning::SetPosition | Meaning::LocalZero) {
            return Err(self.ngc_alarm(Fault::ShiftInCutter));
        }
        let mut shift = self.ngc.shift;
        match meaning {
            Meaning::ShiftCleared | Meaning::ShiftSuspended => shift = Position::ZERO,
            Meaning::ShiftRestored => {
                for axis in Axis::ALL {
                    let number = FIRST_SHIFT + axis.index() as u32;
                    shift[axis] = self.memory.variables.get(number).unwrap_or(0.0);
                }
            }
            _ => {
                for axis in self.words.axes(self.rules.axes).iter() {
                    let Some(value) = self.ngc_axis_word(axis) else { continue };
                    shift[axis] = match meaning {
                        Meaning::SetPosition => shift[axis] + self.ngc.at[axis] - value,
                        _ => value,
                    };
                }
            }
        }
        self.ngc.at = self.ngc.at + self.ngc.shift - shift;
        self.ngc.shift = shift;
        // Suspending keeps what can be restored.
        if !matches!(meaning, Meaning::ShiftSuspended | Meaning::ShiftRestored) {
            for axis in Axis::ALL {
                self.ngc_remember(FIRST_SHIFT + axis.index() as u32, shift[axis]);
            }
        }
        let in_force = !matches!(meaning, Meaning::ShiftCleared | Meaning::ShiftSuspended);
        self.ngc_remember(SHIFT_IN_FORCE, f64::from(u8::from(in_force)));
        self.location.work.shift = self.ngc.machine_of(Position::ZERO) - self.ngc.length;
        self.variable_writes += 1;
        Ok(())
    }

    /// G28 and G30: to the point that the block names, and from there to the reference point on the same axes;
    /// on all where none is named.
    fn ngc_reference(&mut self, place: usize) -> Fallible<()> {
        if self.ngc_in_compensation() {
            return Err(self.ngc_alarm(Fault::ReferenceInCutter));
        }
        let axes = self.words.axes(self.rules.axes);
        let mut to = self.ngc_end_point(axes);
        self.ngc_rapid_exactly(to)?;
        let reference = self.memory.reference_points.get(place).copied().unwrap_or_default();
        let reference = self.ngc.program_of(reference);
        for axis in Axis::ALL {
            if axes.is_empty() || axes.contains(axis) {
                to[axis] = reference[axis];
            }
        }
        self.ngc_rapid_exactly(to)
    }

    /// G10.
    fn ngc_data(&mut self) -> Fallible<()> {
        let l = self.words.get(b'L').unwrap_or(-1.0);
        let whole = l.round();
        if (l - whole).abs() > WHOLE {
            return Err(self.alarm_at(Fault::WordNotWhole, b'L'));
        }
        match whole {
            // The tool table is read again: it is the one that this program has.
            0.0 => Ok(()),
            1.0 | 10.0 | 11.0 => self.ngc_tool_data(whole),
            2.0 | 20.0 => self.ngc_system_data(whole == 20.0),
            _ => Err(self.ngc_alarm(Fault::DataForm)),
        }
    }

    /// G10 L2 and L20: zero and turn of a coordinate system, P0 is the one in force.
    fn ngc_system_data(&mut self, by_position: bool) -> Fallible<()> {
        let p = self.words.get(b'P').unwrap_or(-1.0).trunc();
        if !(0.0..=f64::from(SYSTEMS)).contains(&p) {
            return Err(self.ngc_alarm(Fault::WorkOffsetNumber));
        }
        if self.words.has(b'I') || self.words.has(b'J') {
            return Err(self.ngc_alarm(Fault::WordUnused));
        }
        if by_position && self.words.has(b'R') {
            return Err(self.alarm_at(Fault::WordUnused, b'R'));
        }
        let number = if p == 0.0 { self.ngc.system } else { p as u8 };
        let is_own = number == self.ngc.system;
        if is_own && self.ngc_in_compensation() {
            return Err(self.ngc_alarm(Fault::WorkOffsetInCutter));
        }
        let external = self.memory.work.external;
        let mut zero = self.ngc_own_zero_of(number);
        let (_, mut turn) = self.ngc_zero_of(number);
        let axes = self.words.axes(self.rules.axes);
        if by_position {
            let free = self.location.machine - self.ngc.length;
            zero = self.ngc_zero_by_position(number, free, axes, |axis| self.ngc_axis_word(axis));
        } else {
            for axis in axes.iter() {
                zero[axis] = self.ngc_axis_word(axis).unwrap_or(zero[axis]);
            }
            if let Some(degrees) = self.words.get(b'R') {
                turn = Turned::by(degrees);
                self.ngc_remember(turn_of_system(number), degrees);
            }
        }
        if let Some(place) = self.memory.work.get_mut(system_name(number)) {
            *place = zero;
        }
        if is_own {
            (self.ngc.zero, self.ngc.turn) = (zero + external, turn);
            self.ngc_moved_zero();
        }
        self.variable_writes += 1;
        Ok(())
    }

    /// The zero, without the external one, with which the axes at the machine position `free` of tool length have in that system
    /// the coordinates that are given for `axes`.
    fn ngc_zero_by_position(
        &self,
        number: u8,
        free: Position,
        axes: AxisSet,
        given: impl Fn(Axis) -> Option<f64>,
    ) -> Position {
        let (zero, turn) = self.ngc_zero_of(number);
        let external = self.memory.work.external;
        let mut point = turn.undo(free - zero) - self.ngc.shift;
        for axis in axes.iter() {
            point[axis] = given(axis).unwrap_or(point[axis]);
        }
        let moved = free - external - turn.apply(point + self.ngc.shift);
        let turns_both = |axis| matches!(axis, Axis::X | Axis::Y) && turn.degrees != 0.0;
        let names_both = axes.contains(Axis::X) || axes.contains(Axis::Y);
        let mut found = self.ngc_own_zero_of(number);
        for axis in Axis::ALL {
            if axes.contains(axis) || names_both && turns_both(axis) {
                found[axis] = moved[axis];
            }
        }
        found
    }

    /// Touch off, as G10 L20 does it: the zero of a system with which the axes, at the machine position `free` of tool length, have
    /// these coordinates. None in another language, or of a system that this one has not.
    pub fn touched_off(
        &self,
        system: WorkOffset,
        free: Position,
        coordinates: &[(Axis, f64)],
    ) -> Option<Position> {
        let number = (1..=SYSTEMS).find(|number| system_name(*number) == system)?;
        self.dialect.blocks?;
        let axes = coordinates.iter().map(|(axis, _)| *axis).collect();
        let given = |axis| coordinates.iter().find(|(of, _)| *of == axis).map(|(_, value)| *value);
        Some(self.ngc_zero_by_position(number, free, axes, given))
    }

    /// G10 L1, L10 and L11: length, radius and angles of a tool.
    fn ngc_tool_data(&mut self, l: f64) -> Fallible<()> {
        let Some((number, mut tool)) = self.ngc_tool_word(b'P')? else { return Err(self.ngc_missing(b'P')) };
        let axes = self.words.axes(self.rules.axes);
        let says_something =
            !axes.is_empty() || [b'R', b'I', b'J', b'Q'].into_iter().any(|w| self.words.has(w));
        if !says_something {
            return Err(self.ngc_alarm(Fault::DataValue));
        }
        if l == 1.0 {
            for axis in axes.iter() {
                tool.length[axis] = self.ngc_axis_word(axis).unwrap_or(tool.length[axis]);
            }
        } else {
            // The length with which the axes would stand at the coordinates that the block gives: in the
            // system in force, or in G59.3 without shift.
            let (zero, turn, shift) = match l == 10.0 {
                true => (self.ngc.zero, self.ngc.turn, self.ngc.shift),
                false => {
                    let (zero, turn) = self.ngc_zero_of(FIXTURE);
                    (zero, turn, Position::ZERO)
                }
            };
            let machine = self.location.machine;
            let mut point = turn.undo(machine - zero - self.ngc.length) - shift;
            for axis in axes.iter() {
                point[axis] = self.ngc_axis_word(axis).unwrap_or(point[axis]);
            }
            let length = machine - zero - turn.apply(point + shift);
            for axis in axes.iter() {
                tool.length[axis] = length[axis];
            }
        }
        if let Some(radius) = self.ngc_length_word(b'R') {
            tool.diameter = 2.0 * radius;
        }
        if let Some(angle) = self.words.get(b'I') {
            tool.front_angle = angle;
        }
        if let Some(angle) = self.words.get(b'J') {
            tool.back_angle = angle;
        }
        if let Some(orientation) = self.words.get(b'Q') {
            if !(0.0..=9.0).contains(&orientation) {
                return Err(self.alarm_at(Fault::WordOutOfRange, b'Q'));
            }
            tool.orientation = orientation.round() as u8;
        }
        match &mut self.memory.library {
            Some(library) => {
                if let Some(row) = library.get_mut(number) {
                    *row = tool;
                }
            }
            None => {
                if let Some(row) = u16::try_from(number).ok().and_then(|n| self.memory.tools.get_mut(n)) {
                    (row.length, row.length_wear) = (tool.length[Axis::Z], 0.0);
                    (row.radius, row.radius_wear) = (tool.diameter / 2.0, 0.0);
                }
            }
        }
        self.variable_writes += 1;
        Ok(())
    }
}
