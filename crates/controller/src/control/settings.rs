//! The setting page (GSK990MC part 2, 3.4.1): what of it parameters hold, and the program switch.
//!
//! The switches and numbers of the page are parameters that are set there in MDI without the parameter switch; rights
//! are those of each parameter. The program switch is the parameter of its initial state (54#6 PRGS), so that it stands
//! after the power as it was left. It is delivered on, unlike the manual's standard setting: a control without
//! passwords can be used at once.

use super::{Control, alarm};
use ferrocut_machine::{Alarm, Fault, ParameterKey};
use ferrocut_memory::Author;
use ferrocut_memory::rights::PROGRAM_SWITCH;

/// 0#2 INI: programs are in inches.
pub(super) const INPUT_UNIT: ParameterKey = ParameterKey::Bit { number: 0, bit: 2 };

/// What the page sets: the program switch, the unit of programs, the channel (P0), sequence numbers (0#5) and their
/// increment (P210).
const SETTINGS: [ParameterKey; 5] = [
    PROGRAM_SWITCH,
    INPUT_UNIT,
    ParameterKey::Data(0),
    ParameterKey::Bit { number: 0, bit: 5 },
    ParameterKey::Data(210),
];

impl Control {
    /// Whether a parameter is one of the setting page, which only a control with a parameter switch has.
    pub(super) fn is_setting(&self, key: &ParameterKey) -> bool {
        self.cnc.interpreter().dialect().parameter_switch && SETTINGS.contains(key)
    }

    /// Whether programs may be edited, as the program switch has it; none on a control without the switch.
    pub(super) fn programs_open(&self) -> Option<bool> {
        let parameters = &self.cnc.interpreter().memory().parameters;
        let has_switch = self.cnc.interpreter().dialect().parameter_switch;
        (has_switch && parameters.table().get(&PROGRAM_SWITCH).is_some())
            .then(|| parameters.get(&PROGRAM_SWITCH) != 0.0)
    }

    /// Whether somebody may change programs now, rights aside.
    pub(super) fn may_edit_programs(&self, author: &Author) -> Result<(), Box<Alarm>> {
        match (self.programs_open(), author) {
            (Some(false), Author::Person { .. }) => Err(Box::new(alarm(Fault::ProgramsClosed))),
            _ => Ok(()),
        }
    }
}
