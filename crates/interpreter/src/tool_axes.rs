//! The axes of the plane and of the tool, and the tool in the spindle, where programs choose them
//! (Fagor 1.1.4: `#SET AX`, `#TOOL AX`, G20; tools by T, D and M6).

use crate::Fallible;
use crate::cycles::zone::ToolData;
use crate::interpreter::Interpreter;
use ferrocut_geometry::{Axis, AxisSet, Plane, Position};
use ferrocut_machine::Fault;

/// Which axes stand for X, Y and Z, and along which the tool is.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct ToolAxes {
    /// The first three axes of the channel.
    pub axes: [Axis; 3],
    /// The tool's, where it is not that square to the plane, and +1 or −1 for the end that the tool is on.
    pub tool: Option<(Axis, f64)>,
}

impl Default for ToolAxes {
    fn default() -> ToolAxes {
        ToolAxes { axes: [Axis::X, Axis::Y, Axis::Z], tool: None }
    }
}

impl ToolAxes {
    /// Abscissa, ordinate and tool axis in a plane.
    fn of(&self, plane: Plane) -> [Axis; 3] {
        let [x, y, z] = self.axes;
        let [a, b, normal] = match plane {
            Plane::Xy => [x, y, z],
            Plane::Zx => [z, x, y],
            Plane::Yz => [y, z, x],
        };
        [a, b, self.tool.map_or(normal, |(axis, _)| axis)]
    }
}

impl Interpreter {
    /// Abscissa, ordinate and tool axis.
    pub(crate) fn plane_axes(&self) -> [Axis; 3] {
        self.tool_axes.of(self.modal.plane())
    }

    /// Whether the axes of the plane are those that arcs are made in.
    pub(crate) fn has_own_axes(&self) -> bool {
        self.tool_axes.axes == ToolAxes::default().axes
    }

    /// Puts other axes in force. Another tool axis ends the cycle, and takes the tool's length with it.
    pub(crate) fn set_tool_axes(&mut self, axes: ToolAxes) -> Fallible<()> {
        self.put_tool_axes(axes, self.plane_axes())
    }

    /// The same, where `was` was in force: the plane may have been changed before.
    fn put_tool_axes(&mut self, axes: ToolAxes, was: [Axis; 3]) -> Fallible<()> {
        self.tool_axes = axes;
        if self.plane_axes() != was {
            self.cancel_cycle();
        }
        if self.rules.tools_carry_offsets {
            self.take_up_tool();
        }
        Ok(())
    }

    /// G17, G18, G19 end `#TOOL AX`, and where the axes are others than they were, the cycle.
    pub(crate) fn plane_chosen(&mut self, was: [Axis; 3]) {
        self.tool_axes.tool = None;
        if self.plane_axes() != was {
            self.cancel_cycle();
        }
        if self.rules.tools_carry_offsets {
            self.take_up_tool();
        }
    }

    /// G20: the axes of the plane and of the tool, by the numbers of their words: 1 and 2 the plane's, 3 the
    /// tool's, negative for a tool on the other end.
    pub(crate) fn choose_axes(&mut self, axes: AxisSet) -> Fallible<()> {
        let mut chosen = self.tool_axes;
        let was = self.plane_axes();
        chosen.axes = was;
        chosen.tool = None;
        let mut tool = None;
        for axis in axes.iter() {
            let Some(number) = self.words.get(axis.letter() as u8) else { continue };
            let place = match number.abs() {
                1.0 => 0,
                2.0 => 1,
                3.0 => 2,
                _ => return Err(self.alarm_at(Fault::PlaneAxes, axis.letter() as u8)),
            };
            if let Some(slot) = chosen.axes.get_mut(place) {
                *slot = axis;
            }
            if place == 2 {
                tool = Some((axis, number.signum()));
            }
        }
        let [a, b, c] = chosen.axes;
        if a == b || b == c || a == c {
            return Err(self.alarm(Fault::PlaneAxes, self.words.block_span()));
        }
        // The standard planes keep their arcs.
        let standard = [Plane::Xy, Plane::Zx, Plane::Yz]
            .into_iter()
            .find(|plane| ToolAxes::default().of(*plane) == chosen.axes);
        match standard.and_then(|plane| self.dialect.plane_code(plane)) {
            Some(row) => {
                self.modal.set(row);
                self.put_tool_axes(ToolAxes { tool, ..ToolAxes::default() }, was)
            }
            None => self.put_tool_axes(ToolAxes { tool, ..chosen }, was),
        }
    }

    /// M6: the chosen tool is in the spindle, with the offset of the block or its first one.
    pub(crate) fn tool_changed(&mut self, edge: Option<f64>) {
        self.technology.in_spindle = self.technology.tool;
        self.technology.edge = edge.unwrap_or(1.0);
        self.take_up_tool();
    }

    /// D: another offset of the tool in the spindle; D0 is none.
    pub(crate) fn edge_chosen(&mut self, edge: f64) {
        self.technology.edge = edge;
        self.take_up_tool();
    }

    /// Adds the tool's length along its axis. The tool stands where it stands.
    fn take_up_tool(&mut self) {
        let (tool, edge) = (self.technology.in_spindle, self.technology.edge);
        let has_offset = edge != 0.0 && tool != 0;
        let number = if has_offset { u16::try_from(tool).unwrap_or(0) } else { 0 };
        let row = self.memory.tools.get(number).copied().unwrap_or_default();
        let sign = self.tool_axes.tool.map_or(1.0, |(_, sign)| sign);
        let [_, _, axis] = self.plane_axes();
        let mut vector = Position::ZERO;
        vector[axis] = sign * (row.length + row.length_wear);
        self.technology.radius_number = f64::from(number);
        self.location.length.number = number;
        if vector != self.location.length.vector {
            self.location.length.vector = vector;
            self.location.take_machine();
        }
    }

    /// What cycles know of a tool.
    pub(crate) fn tool_data(&self, tool: u32, edge: f64) -> ToolData {
        let number = if edge == 0.0 { 0 } else { u16::try_from(tool).unwrap_or(0) };
        let row = self.memory.tools.get(number).copied().unwrap_or_default();
        ToolData {
            radius: self.tool_radius(&row),
            cutting_length: row.cutting_length,
            entry_angle: row.entry_angle,
            tip_radius: row.tip_radius,
        }
    }
}
