//! The simulated machine that a machine file describes, and what follows when axes come to their reference points.

use super::Control;
use crate::drives::{Drives, Plant, Simulated};
use crate::signals::Mode;
use ferrocut_geometry::{AxisSet, Position};
use ferrocut_interpreter::Interpreter;
use ferrocut_machine::Machine;

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

impl Control {
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
