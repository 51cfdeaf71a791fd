//! What a program can call: the programs of the memory, those that come with the machine, and the one that M06 runs.

use super::Library;
use ferrocut_interpreter::Dialect;
use ferrocut_machine::Machine;
use ferrocut_program::{ProgramId, ProgramMemory, Source, Text};
use std::sync::Arc;

/// The program that M06 runs (GSK990MC 8.1), where the machine file names no other.
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
    tool_change: ToolChange,
}

/// Which program M06 runs.
#[derive(Clone, Debug)]
struct ToolChange {
    /// Its number; none where M06 is the machine's own code.
    number: Option<u32>,
    /// Its text as it comes with the machine. One of the memory goes before.
    text: Option<Arc<[u8]>>,
    /// Only a program changes the tool: where it is missing that is an alarm (GSK990MC, 0078), since whoever goes on cuts
    /// with another tool. Where there is no ladder the machine itself changes it.
    is_needed: bool,
}

/// A program as the interpreter takes it.
pub(super) struct Prepared {
    pub programs: ProgramMemory,
    /// The program that M06 runs.
    pub changes_tools: Option<u32>,
}

impl Source for Callable {
    fn find(&mut self, id: &ProgramId) -> Option<(String, Text)> {
        let (name, text) = self.named(id)?;
        Some((name, Text::from_bytes(text).ok()?))
    }
}

impl Callable {
    pub fn new(
        machine: &Machine,
        dialect: &'static Dialect,
        library: Library,
        public: Option<PublicPrograms>,
        tool_change: Option<Vec<u8>>,
        has_ladder: bool,
    ) -> Callable {
        // 0 is none.
        let number = Some(machine.tool_change.program.unwrap_or(TOOL_CHANGE_PROGRAM)).filter(|n| *n > 0);
        let tool_change = ToolChange { number, text: tool_change.map(Arc::from), is_needed: has_ladder };
        Callable { library, dialect, public, tool_change }
    }

    /// The same for programs of another control language, in which no program of the control can be called by M06.
    pub fn speaking(self, dialect: &'static Dialect) -> Callable {
        let tool_change = ToolChange { number: None, ..self.tool_change };
        Callable { dialect, tool_change, ..self }
    }

    /// Whether programs run that of this name by M06.
    pub fn changes_tools(&self, program: &str) -> bool {
        self.tool_change.number.is_some_and(|number| super::id_of(program) == ProgramId::Number(number))
    }

    /// A program with its name: that of the memory, else the tool change that comes with the machine.
    pub fn named(&self, id: &ProgramId) -> Option<(String, Vec<u8>)> {
        let ToolChange { number, text, .. } = &self.tool_change;
        self.library.named(id).or_else(|| {
            let number = number.filter(|number| *id == ProgramId::Number(*number))?;
            Some((format!("O{number:04}"), text.as_ref()?.to_vec()))
        })
    }

    /// A text as the main program, with all that it can call.
    pub fn prepare(&self, name: &str, text: Text) -> Prepared {
        let mut programs = ProgramMemory::new(name, text, self.dialect.syntax);
        if let (Some(public), true) = (&self.public, self.dialect.custom.is_some()) {
            programs.add_shared(&public.name, public.text.clone());
        }
        programs.set_source(Box::new(self.clone()));
        let ToolChange { number, is_needed, .. } = self.tool_change;
        // RS274/NGC runs none: there it is an alarm where one is needed.
        let runs_programs = self.dialect.blocks.is_none();
        let is_there = |number: u32| runs_programs && self.named(&ProgramId::Number(number)).is_some();
        let runs = |number: &u32| is_needed || is_there(*number);
        Prepared { programs, changes_tools: number.filter(runs) }
    }
}
