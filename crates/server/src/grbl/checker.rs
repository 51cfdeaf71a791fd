//! `$C`: blocks are interpreted and judged as they would be, and nothing moves.

use super::machine::Status;
use ferrocut_controller::Supervisor;
use ferrocut_interpreter::{Interpreter, Options, dialects};
use ferrocut_machine::{Fault, Machine, Memory, Severity, WorkOffset};
use ferrocut_program::{ProgramMemory, Text};
use std::fmt::Write;

/// An interpreter of its own, in the state that the machine had.
pub struct Checker {
    interpreter: Interpreter,
    supervisor: Supervisor,
}

impl Checker {
    /// A checker that begins with what is in force.
    pub fn new(machine: &Machine, status: &Status) -> Checker {
        let dialect = &dialects::rs274::DIALECT;
        let mut memory = Memory::new(dialect.name);
        for (number, zero) in (1u8..).zip(status.offsets.systems) {
            if let Some(place) = memory.work.get_mut(WorkOffset::Standard(number)) {
                *place = zero;
            }
        }
        for (place, at) in memory.reference_points.iter_mut().zip(status.offsets.references) {
            *place = at;
        }
        let programs = ProgramMemory::new("check", Text::sent(), dialect.syntax);
        let options = Options { start: status.position, keep_going: true, ..Options::default() };
        let mut checker = Checker {
            interpreter: Interpreter::new(dialect, programs, memory, options),
            supervisor: Supervisor::new(machine, dialect, status.position),
        };
        let modal = &status.modal;
        let mut codes = String::new();
        for tenths in modal.codes {
            // A probe or an arc needs more than its code.
            if matches!(tenths, 0 | 10 | 40..) && !matches!(tenths, 382..=385) {
                let _ = write!(codes, "G{} ", tenths / 10);
            }
        }
        let _ = write!(codes, "F{} S{}", modal.feed, modal.speed);
        checker.check(&codes);
        checker
    }

    /// The first thing that is wrong with a block.
    pub fn check(&mut self, block: &str) -> Option<Fault> {
        self.interpreter.go_on();
        let line = format!("{block}\n");
        if self.interpreter.append(line.as_bytes()).is_err() {
            return Some(Fault::LineTooLong);
        }
        let mut found = None;
        while let Some(step) = self.interpreter.next() {
            match step {
                Err(alarm) => found = found.or(Some(alarm.fault)),
                Ok(step) => {
                    self.interpreter.give_back(step.span);
                    let found = &mut found;
                    self.supervisor.step(&step, |alarm| {
                        if alarm.severity == Severity::Error {
                            *found = found.or(Some(alarm.fault));
                        }
                    });
                }
            }
        }
        found
    }
}
