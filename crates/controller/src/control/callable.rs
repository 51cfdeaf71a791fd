//! What a program can call: the programs of the memory, those that come with the machine, and the one that M06 runs.

use super::Library;
use ferrocut_interpreter::Dialect;
use ferrocut_machine::Machine;
use ferrocut_program::{ProgramId, ProgramMemory, Text};
use std::sync::Arc;

/// The program of the memory that M06 runs, where there is one (GSK990MC 8.1) and the machine file names no other.
const TOOL_CHANGE_PROGRAM: u32 = 9001;

/// Programs that come with the machine and may stand for codes (Weihong 5, public.dat).
#[derive(Clone, Debug)]
pub struct PublicPrograms {
    /// Name of their file.
    pub name: String,
    /// What is in it.
    pub text: Arc<Text>,
}

/// What a program can call.
#[derive(Clone, Debug)]
pub(super) struct Callable {
    /// The programs of the memory.
    pub library: Library,
    dialect: &'static Dialect,
    public: Option<PublicPrograms>,
    tool_change: u32,
}

/// A program as the interpreter takes it.
pub(super) struct Prepared {
    pub programs: ProgramMemory,
    /// The program of the memory that M06 runs.
    pub changes_tools: Option<u32>,
}

impl Callable {
    pub fn new(
        machine: &Machine,
        dialect: &'static Dialect,
        library: Library,
        public: Option<PublicPrograms>,
    ) -> Callable {
        let tool_change = machine.tool_change.program.unwrap_or(TOOL_CHANGE_PROGRAM);
        Callable { library, dialect, public, tool_change }
    }

    /// The same for programs of another control language.
    pub fn speaking(self, dialect: &'static Dialect) -> Callable {
        Callable { dialect, ..self }
    }

    /// Whether programs run that of this name by M06.
    pub fn changes_tools(&self, program: &str) -> bool {
        super::id_of(program) == ProgramId::Number(self.tool_change)
    }

    /// A text as the main program, with all that it can call.
    pub fn prepare(&self, name: &str, text: Text) -> Prepared {
        let mut programs = ProgramMemory::new(name, text, self.dialect.syntax);
        if let (Some(public), true) = (&self.public, self.dialect.custom.is_some()) {
            programs.add_shared(&public.name, public.text.clone());
        }
        programs.set_source(Box::new(self.library.clone()));
        let is_there = self.library.name_of(&ProgramId::Number(self.tool_change)).is_some();
        Prepared { programs, changes_tools: is_there.then_some(self.tool_change) }
    }
}
