//! The machine beside the axes: its inputs and outputs go between drives and ladder, its switches to the NC, and in the
//! mode HOME the axis keys send axes to their reference points (GSK990MC part 2, chapter 9).

use super::Control;
use crate::drives::{Drives, Plant, Simulated, Switches};
use crate::signals::{Mode, SIGNAL_AXES};
use ferrocut_geometry::{AxisSet, Position};
use ferrocut_interpreter::Interpreter;
use ferrocut_machine::Machine;
use ferrocut_plc::{Address, Area, Plc};

/// The drives of a machine whose file describes a simulated one; ideal ones where it does not. The axes `known` stand
/// where the control takes them to be.
pub(super) fn drives(machine: &Machine, interpreter: &Interpreter, known: AxisSet) -> Box<dyn Drives> {
    if machine.plant.is_none() {
        return Box::new(Simulated);
    }
    let mut as_set = machine.clone();
    let memory = interpreter.memory();
    (interpreter.dialect().machine_parameters)(&memory.parameters, &mut as_set);
    let reference = memory.reference_points.first().copied().unwrap_or_default();
    let mut plant = Plant::new(&as_set, interpreter.position(), reference);
    plant.stand_as_called(known);
    Box::new(plant)
}

/// Inputs of the machine, for the ladder.
pub(super) fn read(drives: &dyn Drives, plc: &mut Plc) {
    let memory = plc.memory_mut();
    drives.read(&mut |byte, bit, on| memory.set_bit(Address { area: Area::X, byte, bit: Some(bit) }, on));
}

/// Outputs of the ladder, for the machine.
pub(super) fn write(drives: &mut dyn Drives, plc: &Plc) {
    let memory = plc.memory();
    drives.write(&|byte, bit| memory.bit(Address { area: Area::Y, byte, bit: Some(bit) }));
}

impl Control {
    /// Where a ladder runs the NC has the switches from it; else from the drives.
    pub(super) fn take_machine_switches(&mut self) {
        let axes = self.machine.axes.iter().map(|axis| axis.name);
        let switches = self.plc.is_some().then(|| Switches::of(&self.inputs, axes));
        self.cnc.set_switches(switches);
    }

    /// The axis keys in the mode HOME: either of an axis sends it to its reference point.
    pub(super) fn home(&mut self) {
        for number in 0..SIGNAL_AXES {
            let Some(axis) = self.axis(number) else { break };
            let ways = |inputs: &crate::signals::Inputs| {
                inputs.jog.get(number).is_some_and(|ways| ways.plus || ways.minus)
            };
            match (ways(&self.before), ways(&self.inputs)) {
                (false, true) => drop(self.cnc.home(axis)),
                (true, false) => self.cnc.release_home(axis),
                _ => {}
            }
        }
    }

    /// Another mode than HOME was chosen: axes that home by hand come to rest.
    pub(super) fn leave_home(&mut self, before: Mode) {
        if before == Mode::Home {
            self.cnc.stop_homing_by_hand();
        }
    }

    /// 10#2: relative coordinates of axes that have come to their reference points are 0 there.
    pub(super) fn note_homed(&mut self, arrived_before: AxisSet, at: Position) {
        let arrived = self.cnc.at_reference();
        if arrived != arrived_before && self.bit(10, 2) {
            for axis in arrived.iter().filter(|axis| !arrived_before.contains(*axis)) {
                self.origin[axis] = at[axis];
            }
        }
    }
}
