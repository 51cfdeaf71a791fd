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

/// What a program can call, and how it is read.
#[derive(Clone, Debug)]
pub(super) struct Callable {
    stored: Stored,
    dialect: &'static Dialect,
    public: Option<PublicPrograms>,
    /// A memory with those that come with the machine, which were read: no load reads them again.
    prepared: ProgramMemory,
}

/// Programs that are found by their name while another runs.
#[derive(Clone, Debug)]
struct Stored {
    /// Those of the memory.
    library: Library,
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

impl Source for Stored {
    fn find(&mut self, id: &ProgramId) -> Option<(String, Text)> {
        let (name, text) = self.named(id)?;
        Some((name, Text::from_bytes(text).ok()?))
    }
}

impl Stored {
    /// A program with its name: that of the memory, else the tool change that comes with the machine.
    fn named(&self, id: &ProgramId) -> Option<(String, Vec<u8>)> {
        let ToolChange { number, text, .. } = &self.tool_change;
        self.library.named(id).or_else(|| {
            let number = number.filter(|number| *id == ProgramId::Number(*number))?;
            Some((format!("O{number:04}"), text.as_ref()?.to_vec()))
        })
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
        let prepared = memory_of(dialect, public.as_ref());
        Callable { stored: Stored { library, tool_change }, dialect, public, prepared }
    }

    /// The same for programs of another control language, in which no program of the control can be called by M06.
    pub fn speaking(self, dialect: &'static Dialect) -> Callable {
        let tool_change = ToolChange { number: None, ..self.stored.tool_change };
        let prepared = memory_of(dialect, self.public.as_ref());
        Callable { stored: Stored { tool_change, ..self.stored }, dialect, prepared, ..self }
    }

    /// Whether programs run that of this name by M06.
    pub fn changes_tools(&self, program: &str) -> bool {
        self.stored
            .tool_change
            .number
            .is_some_and(|number| super::id_of(program) == ProgramId::Number(number))
    }

    /// The programs of the memory.
    pub fn library(&self) -> &Library {
        &self.stored.library
    }

    /// A program with its name: that of the memory, else the tool change that comes with the machine.
    pub fn named(&self, id: &ProgramId) -> Option<(String, Vec<u8>)> {
        self.stored.named(id)
    }

    /// A text as the main program, with all that it can call.
    pub fn prepare(&self, name: &str, text: Text) -> Prepared {
        let mut programs = self.prepared.with_main(name, text);
        if self.dialect.custom.is_some() {
            // Here, beside the period as it may be, and not as the interpreter takes it. What cannot be read fails there.
            let _ = programs.look_for_programs();
        }
        programs.set_source(Box::new(self.stored.clone()));
        let ToolChange { number, is_needed, .. } = self.stored.tool_change;
        // RS274/NGC runs none: there it is an alarm where one is needed.
        let runs_programs = self.dialect.blocks.is_none();
        let is_there = |number: u32| runs_programs && self.named(&ProgramId::Number(number)).is_some();
        let runs = |number: &u32| is_needed || is_there(*number);
        Prepared { programs, changes_tools: number.filter(runs) }
    }
}

/// A memory without a main program, with the programs that come with the machine.
fn memory_of(dialect: &'static Dialect, public: Option<&PublicPrograms>) -> ProgramMemory {
    let mut programs = ProgramMemory::new("", Text::sent(), dialect.syntax);
    if let (Some(public), true) = (public, dialect.custom.is_some()) {
        programs.add_shared(&public.name, public.text.clone());
        // What cannot be read fails as a program is loaded.
        let _ = programs.look_for_programs();
    }
    programs
}

#[cfg(test)]
mod tests {
    use super::*;
    use ferrocut_interpreter::dialects;
    use ferrocut_program::FileId;

    #[test]
    fn what_comes_with_the_machine_is_read_once() {
        let text = |text: &str| Text::from_bytes(text.as_bytes().to_vec()).unwrap();
        let public = PublicPrograms { name: "public.dat".into(), text: Arc::new(text("O9001\nX1\nM17\n")) };
        let machine = Machine::demo_mill();
        let (dialect, other) = (&dialects::weihong::DIALECT, &dialects::gsk990mc::DIALECT);
        let callable =
            Callable::new(&machine, dialect, Library::Held(Arc::default()), Some(public), None, false);
        let page = |callable: &Callable, main: &str| {
            let mut programs = callable.prepare(main, text(&format!("X5\nO1\n{main}"))).programs;
            assert_eq!(programs.file_name(FileId(0)), main);
            assert!(programs.find_program(&ProgramId::Number(1)).unwrap().is_some());
            let place = programs.find_program(&ProgramId::Number(9001)).unwrap();
            place.map(|place| programs.page(place.file, place.page).unwrap().unwrap())
        };
        let first = page(&callable, "M30").unwrap();
        assert!(Arc::ptr_eq(&first, &page(&callable, "M02").unwrap()));
        // Another language has no such programs.
        let callable = callable.speaking(other);
        assert!(page(&callable, "M30").is_none());
        assert!(page(&callable.speaking(dialect), "M30").is_some());
    }
}
