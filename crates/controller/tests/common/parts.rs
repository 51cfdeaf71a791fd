//! Programs with all that they need: the examples, and those beside the tests.

use ferrocut_interpreter::cycles::pocket::{KeptPockets, PocketKind};
use ferrocut_interpreter::{Interpreter, Options, dialects};
use ferrocut_machine::{Machine, Memory, Setup};
use ferrocut_program::{ProgramId, ProgramMemory, Source, Text};
use std::collections::{BTreeMap, HashMap};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

/// Computed pockets, so that each is computed once.
#[derive(Clone, Default)]
pub struct Kept(Arc<Mutex<HashMap<String, Vec<u8>>>>);

impl KeptPockets for Kept {
    fn load(&self, name: &str, kind: PocketKind) -> Option<Vec<u8>> {
        self.0.lock().unwrap().get(&format!("{name} {kind:?}")).cloned()
    }

    fn keep(&self, name: &str, kind: PocketKind, bytes: &[u8]) {
        self.0.lock().unwrap().insert(format!("{name} {kind:?}"), bytes.to_vec());
    }
}

/// A program with all that it needs.
pub struct Part {
    pub name: String,
    pub dialect: String,
    pub text: Vec<u8>,
    pub setup: String,
    pub machine: Machine,
    pub public: Option<Vec<u8>>,
    /// Programs in files of their own, found when they are called first.
    pub others: Others,
    pub kept: Kept,
    pub is_example: bool,
}

/// Programs by their numbers.
#[derive(Clone, Debug, Default)]
pub struct Others(pub BTreeMap<u32, Vec<u8>>);

impl Source for Others {
    fn find(&mut self, id: &ProgramId) -> Option<(String, Text)> {
        let ProgramId::Number(number) = id else { return None };
        Some((format!("O{number}"), Text::from_bytes(self.0.get(number)?.clone()).unwrap()))
    }
}

impl Others {
    /// The programs of a folder; none where there is no such folder.
    pub fn of(folder: &Path) -> Others {
        let files = std::fs::read_dir(folder).into_iter().flatten().map(|file| file.unwrap().path());
        let number = |path: &Path| path.file_stem().unwrap().to_str().unwrap()[1..].parse().unwrap();
        Others(files.map(|path| (number(&path), std::fs::read(&path).unwrap())).collect())
    }
}

impl Part {
    pub fn new(name: &str, dialect: &str, setup: &str, text: &str) -> Part {
        Part {
            name: name.to_owned(),
            dialect: dialect.to_owned(),
            text: text.as_bytes().to_vec(),
            setup: setup.to_owned(),
            machine: Machine::demo_mill(),
            public: None,
            others: Others::default(),
            kept: Kept::default(),
            is_example: false,
        }
    }

    pub fn interpreter(&self) -> Interpreter {
        let dialect = dialects::by_name(&self.dialect).unwrap();
        let text = Text::from_bytes(self.text.clone()).unwrap();
        let mut programs = ProgramMemory::new(&self.name, text, dialect.syntax);
        if let Some(public) = &self.public {
            programs.add("public.dat", Text::from_bytes(public.clone()).unwrap());
        }
        programs.set_source(Box::new(self.others.clone()));
        let setup = Setup::from_toml(&self.setup).unwrap();
        let mut memory = Memory::new(dialect.name);
        if self.machine.dialect == self.dialect {
            let parameters: Vec<_> =
                self.machine.parameters.iter().map(|(key, value)| (key.parse().unwrap(), *value)).collect();
            memory.set_parameters(parameters.iter().map(|(key, value)| (key, *value))).unwrap();
        }
        setup.apply(&mut memory).unwrap();
        let names = setup.axis_names().unwrap();
        let options = Options {
            start: setup.start.position_of(&names),
            axis_names: names,
            block_skip: setup.options.block_skip,
            skip: setup.signals.skip.as_ref().map(|signal| (signal.axis, signal.at)),
            ..Options::default()
        };
        let mut interpreter = Interpreter::new(dialect, programs, memory, options);
        interpreter.keep_pockets(Box::new(self.kept.clone()));
        // Files are numbered as they are met, here in the same order in each run.
        for number in self.others.0.keys() {
            interpreter.file_of(&ProgramId::Number(*number)).unwrap();
        }
        for (name, value) in &setup.signals.inputs {
            match name.strip_prefix('#') {
                Some(number) => interpreter.set_input(number.parse().unwrap(), *value),
                None => interpreter.set_port(name.parse().unwrap(), *value),
            }
        }
        interpreter
    }
}

pub fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

/// A part of a folder, with the set-up or machine file of its name.
pub fn part_of(path: &Path) -> Part {
    let dialect = path.parent().unwrap().file_name().unwrap().to_str().unwrap();
    let setup = std::fs::read_to_string(path.with_extension("toml")).unwrap_or_default();
    let name = path.strip_prefix(path.parent().unwrap().parent().unwrap()).unwrap().to_str().unwrap();
    let mut part = Part::new(name, dialect, &setup, "");
    part.text = std::fs::read(path).unwrap();
    part.is_example = path.components().any(|folder| folder.as_os_str() == "examples");
    part.others = Others::of(&path.with_extension(""));
    if let Ok(machine) = std::fs::read_to_string(path.with_extension("machine.toml")) {
        part.machine = Machine::from_toml(&machine).unwrap();
    }
    if let Some(public) = &part.machine.public_programs {
        part.public = std::fs::read(path.with_file_name(public)).ok();
    }
    part
}

/// All examples, and the programs beside this test.
pub fn parts() -> Vec<Part> {
    let mut paths: Vec<PathBuf> = ["../../examples", "tests/programs"]
        .into_iter()
        .flat_map(|root| std::fs::read_dir(folder(root)).unwrap())
        .map(|dialect| dialect.unwrap().path())
        .filter(|dialect| dialect.is_dir() && !dialect.ends_with("drawings"))
        .flat_map(|dialect| std::fs::read_dir(dialect).unwrap())
        .map(|file| file.unwrap().path())
        .filter(|file| file.extension().is_some_and(|e| e == "nc"))
        .collect();
    paths.sort();
    paths.iter().map(|path| part_of(path)).collect()
}
