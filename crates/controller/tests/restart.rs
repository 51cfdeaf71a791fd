//! A program that is taken up in its midst goes on as if it had been run from its start (GSK990MC part 2, 10.1.9;
//! here from any line).
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

mod common;

use common::random::Random;
use ferrocut_controller::restart::{At, Journal, Restart};
use ferrocut_geometry::Position;
use ferrocut_interpreter::cycles::pocket::{KeptPockets, PocketKind};
use ferrocut_interpreter::program_state::ProgramState;
use ferrocut_interpreter::{Interpreter, Options, Until, dialects};
use ferrocut_machine::{Machine, Memory, Setup};
use ferrocut_program::{FileId, ProgramId, ProgramMemory, Source, Text};
use ferrocut_toolpath::Step;
use std::collections::{BTreeMap, HashMap};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

/// Lines that are tried in all; `FERROCUT_CASES` says otherwise.
const LINES: usize = 1200;

/// Blocks of a run that are looked at.
const MOST_BLOCKS: u64 = 4000;

/// Computed pockets, so that each is computed once.
#[derive(Clone, Default)]
struct Kept(Arc<Mutex<HashMap<String, Vec<u8>>>>);

impl KeptPockets for Kept {
    fn load(&self, name: &str, kind: PocketKind) -> Option<Vec<u8>> {
        self.0.lock().unwrap().get(&format!("{name} {kind:?}")).cloned()
    }

    fn keep(&self, name: &str, kind: PocketKind, bytes: &[u8]) {
        self.0.lock().unwrap().insert(format!("{name} {kind:?}"), bytes.to_vec());
    }
}

/// A program with all that it needs.
struct Part {
    name: String,
    dialect: String,
    text: Vec<u8>,
    setup: String,
    machine: Machine,
    public: Option<Vec<u8>>,
    /// Programs in files of their own, found when they are called first.
    others: Others,
    kept: Kept,
}

/// Programs by their numbers.
#[derive(Clone, Debug, Default)]
struct Others(BTreeMap<u32, Vec<u8>>);

impl Source for Others {
    fn find(&mut self, id: &ProgramId) -> Option<(String, Text)> {
        let ProgramId::Number(number) = id else { return None };
        Some((format!("O{number}"), Text::from_bytes(self.0.get(number)?.clone()).unwrap()))
    }
}

impl Others {
    /// The programs of a folder; none where there is no such folder.
    fn of(folder: &Path) -> Others {
        let files = std::fs::read_dir(folder).into_iter().flatten().map(|file| file.unwrap().path());
        let number = |path: &Path| path.file_stem().unwrap().to_str().unwrap()[1..].parse().unwrap();
        Others(files.map(|path| (number(&path), std::fs::read(&path).unwrap())).collect())
    }
}

impl Part {
    fn new(name: &str, dialect: &str, setup: &str, text: &str) -> Part {
        Part {
            name: name.to_owned(),
            dialect: dialect.to_owned(),
            text: text.as_bytes().to_vec(),
            setup: setup.to_owned(),
            machine: Machine::demo_mill(),
            public: None,
            others: Others::default(),
            kept: Kept::default(),
        }
    }

    fn interpreter(&self) -> Interpreter {
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

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

/// A part of a folder, with the set-up or machine file of its name.
fn part_of(path: &Path) -> Part {
    let dialect = path.parent().unwrap().file_name().unwrap().to_str().unwrap();
    let setup = std::fs::read_to_string(path.with_extension("toml")).unwrap_or_default();
    let name = path.strip_prefix(path.parent().unwrap().parent().unwrap()).unwrap().to_str().unwrap();
    let mut part = Part::new(name, dialect, &setup, "");
    part.text = std::fs::read(path).unwrap();
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
fn parts() -> Vec<Part> {
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

/// A block of a full run, as it stands before it.
struct Reached {
    block: u64,
    file: FileId,
    line: u32,
    pass: u64,
    in_force: ProgramState,
    memory: Memory,
    position: Position,
}

/// Steps of a full run, and the blocks of it that are looked at: those that begin their line.
fn full_run(part: &Part, random: &mut Random, samples: usize) -> (Vec<Step>, Vec<Reached>) {
    let steps: Vec<Step> = part
        .interpreter()
        .map(|step| step.unwrap_or_else(|alarm| panic!("{}: {alarm:?}", part.name)))
        .collect();
    // Another run, block by block.
    let mut interpreter = part.interpreter();
    let mut passes: HashMap<(FileId, u64), u64> = HashMap::new();
    let mut blocks = Vec::new();
    for block in 1..=MOST_BLOCKS {
        interpreter.set_mark(Some(Until::Number(block)));
        (&mut interpreter).for_each(|step| drop(step.unwrap()));
        if !interpreter.is_at_mark() {
            break;
        }
        let Some(span) = interpreter.next_block() else { continue };
        let pass = passes.entry((span.file, span.offset)).or_default();
        *pass += 1;
        let first = interpreter.block_of_line(span.file, span.line).unwrap().unwrap();
        if first.1 == span {
            blocks.push((block, span.file, span.line, *pass));
        }
    }
    let mut chosen: Vec<_> = (0..samples).map(|_| blocks[random.below(blocks.len())]).collect();
    chosen.sort_unstable();
    chosen.dedup();
    let mut interpreter = part.interpreter();
    let reached = chosen.into_iter().map(|(block, file, line, pass)| {
        interpreter.set_mark(Some(Until::Number(block)));
        (&mut interpreter).for_each(|step| drop(step.unwrap()));
        // Where the full run's own steps say that the axes are.
        let before = steps.iter().take_while(|step| step.block < block);
        let start = part.interpreter().position();
        let position = before.fold(start, |at, step| match &step.op {
            ferrocut_toolpath::Op::Datum { at } => *at,
            op => op.target().copied().unwrap_or(at),
        });
        let (in_force, memory) = (interpreter.program_state(), interpreter.memory().clone());
        Reached { block, file, line, pass, in_force, memory, position }
    });
    let reached = reached.collect();
    (steps, reached)
}

fn find(part: &Part, file: FileId, line: u32, pass: u64) -> Restart {
    let interpreter = part.interpreter();
    let memory = interpreter.memory().clone();
    let found = Journal::begin(&interpreter, Position::ZERO).find(At::Line { file, line, pass }, &memory);
    found.unwrap_or_else(|alarm| panic!("{} {file:?}:{line}:{pass}: {alarm:?}", part.name))
}

#[test]
fn from_random_lines_programs_go_on_as_in_a_full_run() {
    let lines = std::env::var("FERROCUT_CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(LINES);
    let parts = parts();
    assert!(parts.len() >= 20);
    let mut random = Random::new(17);
    let (mut tried, mut in_others) = (0, 0);
    for part in &parts {
        let (steps, reached) = full_run(part, &mut random, lines.div_ceil(parts.len()) * 5 / 4);
        for full in &reached {
            let Reached { block, file, line, pass, .. } = *full;
            let place = format!("{} {file:?}:{line}:{pass} (block {block})", part.name);
            let restart = find(part, file, line, pass);
            assert_eq!(restart.pass, pass, "{place}");
            assert_eq!(restart.in_force, full.in_force, "{place}");
            assert_eq!(restart.interpreter().memory().changes_to(&full.memory), [], "{place}");
            assert_eq!(restart.position, full.position, "{place}");
            let (rest, _) = restart.into_parts();
            let mut rest = rest.map(|step| step.unwrap());
            for step in steps.iter().skip_while(|step| step.block < block) {
                assert_eq!(rest.next().as_ref(), Some(step), "{place}");
            }
            assert_eq!(rest.next(), None, "{place}");
            tried += 1;
            in_others += usize::from(file != FileId(0));
        }
    }
    println!("{tried} lines of {} programs, {in_others} in files of their own", parts.len());
    assert!(tried >= lines.min(LINES) * 5 / 6, "{tried}");
    assert!(in_others * 10 >= tried, "{in_others} of {tried}");
}
