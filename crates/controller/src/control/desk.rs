//! Looking at programs beside the one that runs: with the control's memory as it is, and nothing that moves.

use super::callable::{Callable, Prepared};
use super::{Control, Library};
use crate::supervision::Supervisor;
use ferrocut_geometry::Position;
use ferrocut_interpreter::{Dialect, Interpreter, MachineCodes, Options};
use ferrocut_machine::{Alarm, Fault, Machine, Memory};
use ferrocut_program::{OpenError, Span, Text};

/// A copy of what programs are interpreted with. Parameters, offsets and zeros are those at the time of the copy;
/// programs are read from the control's memory as it is when they are called.
#[derive(Clone, Debug)]
pub struct Desk {
    machine: Machine,
    dialect: &'static Dialect,
    memory: Memory,
    callable: Callable,
    start: Position,
    block_skip: bool,
    every_code: bool,
}

impl Control {
    /// A copy of what programs are interpreted with.
    pub fn desk(&self) -> Desk {
        let interpreter = self.cnc.interpreter();
        Desk {
            machine: self.machine.clone(),
            dialect: interpreter.dialect(),
            memory: interpreter.memory().clone(),
            callable: self.callable.clone(),
            start: self.tick.position,
            block_skip: self.inputs.block_skip,
            every_code: self.plc.is_some(),
        }
    }

    /// The programs of the control.
    pub fn library(&self) -> Library {
        self.callable.library().clone()
    }
}

impl Desk {
    /// The machine.
    pub fn machine(&self) -> &Machine {
        &self.machine
    }

    /// The control language.
    pub fn dialect(&self) -> &'static Dialect {
        self.dialect
    }

    /// What the control remembers.
    pub fn memory(&self) -> &Memory {
        &self.memory
    }

    /// Where the axes stood, machine position.
    pub fn start(&self) -> Position {
        self.start
    }

    /// The same for a program of another control language: it meets none of the control's own parameters.
    pub fn speaking(mut self, dialect: &'static Dialect) -> Desk {
        if dialect.name != self.dialect.name {
            self.memory = Memory::new(dialect.name);
            self.dialect = dialect;
            self.callable = self.callable.speaking(dialect);
        }
        self
    }

    /// An interpreter of a text that is called `name`, before its first block. With `keep_going` it goes on behind
    /// alarms. Programs that it calls are those of the control; no file is read.
    pub fn interpreter(
        &self,
        name: &str,
        text: Vec<u8>,
        keep_going: bool,
    ) -> Result<Interpreter, Box<Alarm>> {
        let text = Text::from_bytes(text).map_err(|error| {
            let fault = if matches!(error, OpenError::Empty) { Fault::FileEmpty } else { Fault::FileNotText };
            Alarm::core(fault, Span::default()).with("file", name)
        })?;
        let Prepared { programs, changes_tools } = self.callable.prepare(name, text);
        let options = Options {
            start: self.start,
            block_skip: self.block_skip,
            optional_stop: true,
            keep_going,
            every_code: self.every_code,
            ends_at_fixed_point: true,
            machine_codes: MachineCodes::of(&self.machine.handshake.m_codes),
            tool_change_program: changes_tools,
            ..Options::default()
        };
        let mut interpreter = Interpreter::new(self.dialect, programs, self.memory.clone(), options);
        interpreter.set_machine(std::sync::Arc::new(self.machine.clone()));
        Ok(interpreter)
    }

    /// What the machine refuses of a program.
    pub fn supervisor(&self) -> Supervisor {
        Supervisor::new(&self.machine, self.dialect, self.start)
    }
}
