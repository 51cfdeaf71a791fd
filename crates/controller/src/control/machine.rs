//! The simulated machine that a machine file describes, and what follows when axes come to their reference points.

use super::Control;
use crate::drives::{self, Drives, Plant, Simulated};
use crate::signals::Mode;
use ferrocut_geometry::AxisSet;
use ferrocut_interpreter::Interpreter;
use ferrocut_machine::{Alarm, Machine};

/// The drives that a machine file describes: real ones, else a simulated machine, else ideal ones. The axes `known` of
/// a simulated one stand where the control takes them to be.
pub(super) fn drives(
    machine: &Machine,
    interpreter: &Interpreter,
    known: AxisSet,
) -> Result<Box<dyn Drives>, Box<Alarm>> {
    let mut as_set = machine.clone();
    let memory = interpreter.memory();
    (interpreter.dialect().machine_parameters)(&memory.parameters, &mut as_set);
    if let Some(real) = drives::connect(&as_set, interpreter.position())? {
        return Ok(real);
    }
    if machine.plant.is_none() {
        return Ok(Box::new(Simulated));
    }
    let reference = memory.reference_points.first().copied().unwrap_or_default();
    let mut plant = Plant::new(&as_set, interpreter.position(), reference);
    plant.stand_as_called(known);
    Ok(Box::new(plant))
}

impl Control {
    /// What takes long is done beside from now on, where the drives need a setpoint each period
    /// ([`Cnc::keep_time`](crate::Cnc::keep_time)).
    ///
    /// # Errors
    /// The system gives no thread.
    pub fn keep_time(&mut self) -> std::io::Result<()> {
        self.cnc.keep_time()?;
        if self.cnc.works_beside() {
            self.read_programs_beside();
        }
        Ok(())
    }

    /// The same whatever the drives need ([`Cnc::work_beside`](crate::Cnc::work_beside)).
    ///
    /// # Errors
    /// The system gives no thread.
    pub fn work_beside(&mut self) -> std::io::Result<()> {
        self.cnc.work_beside()?;
        if self.cnc.works_beside() {
            self.read_programs_beside();
        }
        Ok(())
    }

    /// Waits until what is due beside is done, for a clock that does not wait itself
    /// ([`Cnc::await_beside`](crate::Cnc::await_beside)).
    pub fn await_beside(&mut self) {
        self.cnc.await_beside();
    }

    /// Looks ahead, in the time that a period leaves ([`Cnc::prepare`](crate::Cnc::prepare)).
    pub fn prepare(&mut self) {
        self.cnc.prepare();
    }

    /// Another mode than HOME was chosen: axes that home by hand come to rest.
    pub(super) fn leave_home(&mut self, before: Mode) {
        if before == Mode::Home {
            self.cnc.stop_homing_by_hand();
        }
    }

    /// 10#2: relative coordinates of axes that have come to their reference points are 0 there. The place is not asked of
    /// the period, which has the name that it had before.
    pub(super) fn note_homed(&mut self, arrived_before: AxisSet) {
        let arrived = self.cnc.at_reference();
        if arrived != arrived_before && self.bit(10, 2) {
            let [reference, ..] = self.cnc.interpreter().memory().reference_points;
            for axis in arrived.iter().filter(|axis| !arrived_before.contains(*axis)) {
                self.origin[axis] = reference[axis];
            }
        }
    }
}
