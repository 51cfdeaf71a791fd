//! A program to work on, with the machine and set-up it runs on.

use crate::cli::{Common, Format};
use crate::diagnostics::Diagnostics;
use ferrocut_interpreter::{Dialect, Interpreter, Options, dialects};
use ferrocut_machine::{Alarm, Catalogue, Fault, Language, Machine, Memory, ParameterKey, Setup};
use ferrocut_program::{OpenError, ProgramMemory, Span, Text};
use std::path::{Path, PathBuf};

/// Exit status of a command.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Exit {
    /// Nothing to complain of.
    Fine,
    /// An alarm or a finding.
    Finding,
    /// The command was used wrongly.
    WrongUse,
}

/// Why a command could not start.
#[derive(Debug)]
pub struct Failure {
    /// What is wrong.
    pub alarm: Box<Alarm>,
    /// With which status to leave.
    pub exit: Exit,
}

impl Failure {
    fn wrong_use(fault: Fault) -> Failure {
        Failure { alarm: Box::new(Alarm::core(fault, Span::default())), exit: Exit::WrongUse }
    }

    /// A file that a result was to be written to.
    pub fn cannot_write(file: &str, error: &std::io::Error) -> Failure {
        Failure::cannot_write_for(file, &error.to_string())
    }

    /// A file that a result was to be written to, and why it cannot.
    pub fn cannot_write_for(file: &str, reason: &str) -> Failure {
        Failure::wrong_use(Fault::FileUnwritable).with("file", file).with("reason", reason)
    }

    /// A picture in a format that there is not.
    pub fn picture_format(file: &str) -> Failure {
        Failure::wrong_use(Fault::PictureFormat).with("file", file)
    }

    fn with(mut self, name: &'static str, value: impl Into<ferrocut_machine::Argument>) -> Failure {
        self.alarm.arguments.push((name, value.into()));
        self
    }
}

/// Machine and set-up of a command, read once for all its files.
pub struct Shop {
    /// The machine.
    pub machine: Machine,
    /// Whether the machine is the built-in one.
    pub machine_is_built_in: bool,
    /// The set-up.
    pub setup: Setup,
    /// How messages are shown.
    pub diagnostics: Diagnostics,
    dialect: Option<String>,
    block_skip: bool,
    optional_stop: bool,
}

impl Shop {
    /// Reads machine and set-up file.
    pub fn open(common: &Common) -> Result<Shop, Failure> {
        let machine = match &common.machine {
            None => Machine::demo_mill(),
            Some(path) => read_config(path, Machine::from_toml)?,
        };
        let setup = match &common.setup {
            None => Setup::default(),
            Some(path) => read_config(path, Setup::from_toml)?,
        };
        Ok(Shop {
            machine,
            machine_is_built_in: common.machine.is_none(),
            dialect: common.dialect.clone().or_else(|| setup.dialect.clone()),
            block_skip: common.block_skip || setup.options.block_skip,
            optional_stop: common.optional_stop || setup.options.optional_stop,
            setup,
            diagnostics: diagnostics(common),
        })
    }

    /// The control language of a program, and whether it had to be guessed.
    fn dialect(&self) -> Result<(&'static Dialect, bool), Failure> {
        let (name, guessed) = match &self.dialect {
            Some(name) => (name, false),
            None => (&self.machine.dialect, self.machine_is_built_in),
        };
        match dialects::by_name(name) {
            Some(dialect) => Ok((dialect, guessed)),
            None => Err(Failure::wrong_use(Fault::UnknownDialect).with("name", name.as_str())),
        }
    }

    /// Opens a program.
    pub fn job(&self, path: &Path) -> Result<Job, Failure> {
        let (dialect, guessed) = self.dialect()?;
        let programs = open_program(path, dialect).map_err(|error| open_failure(path, error))?;
        let mut memory = Memory::new(dialect.name);
        let parse = |(name, value): (&String, &f64)| name.parse::<ParameterKey>().map(|key| (key, *value));
        let parameters: Result<Vec<_>, _> = self.machine.parameters.iter().map(parse).collect();
        parameters
            .and_then(|all| memory.set_parameters(all.iter().map(|(key, value)| (key, *value))))
            .map_err(|error| {
                Failure::wrong_use(Fault::ConfigUnusable)
                    .with("file", self.machine.name.as_str())
                    .with("reason", error.to_string())
            })?;
        self.setup.apply(&mut memory).map_err(|error| {
            Failure::wrong_use(Fault::ConfigUnusable).with("file", "setup").with("reason", error.to_string())
        })?;
        let inputs = self
            .setup
            .signals
            .inputs
            .iter()
            .filter_map(|(name, value)| Some((name.strip_prefix('#')?.parse().ok()?, *value)));
        let inputs = inputs.collect();
        Ok(Job { path: path.to_path_buf(), dialect, guessed, programs, memory, inputs })
    }

    /// How the operator's switches stand.
    pub fn options(&self) -> Options {
        Options {
            start: self.setup.start.position(),
            block_skip: self.block_skip,
            optional_stop: self.optional_stop,
            skip: self.setup.signals.skip.as_ref().map(|signal| (signal.axis, signal.at)),
            ..Options::default()
        }
    }
}

/// How messages of a command are shown.
pub fn diagnostics(common: &Common) -> Diagnostics {
    let language = common.language.clone().or_else(|| {
        ["LC_ALL", "LC_MESSAGES", "LANG"]
            .into_iter()
            .find_map(|v| std::env::var(v).ok().filter(|t| !t.is_empty()))
    });
    let language = language.and_then(|tag| Language::from_tag(&tag)).unwrap_or_default();
    Diagnostics::new(Catalogue::new(language), common.format == Format::Json)
}

/// A program that was opened.
pub struct Job {
    /// Where it came from.
    pub path: PathBuf,
    /// Its control language.
    pub dialect: &'static Dialect,
    /// Whether the language was guessed.
    pub guessed: bool,
    programs: ProgramMemory,
    memory: Memory,
    /// Inputs that programs read as variables.
    inputs: Vec<(u32, f64)>,
}

impl Job {
    /// An interpreter before the first block.
    pub fn interpreter(self, options: Options) -> Interpreter {
        let mut interpreter = Interpreter::new(self.dialect, self.programs, self.memory, options);
        for (variable, value) in self.inputs {
            interpreter.set_input(variable, value);
        }
        interpreter
    }
}

fn open_program(path: &Path, dialect: &'static Dialect) -> Result<ProgramMemory, OpenError> {
    if path == Path::new("-") {
        let text = Text::from_reader(std::io::stdin().lock())?;
        return Ok(ProgramMemory::new("standard input", text, dialect.syntax));
    }
    ProgramMemory::open(path, dialect.syntax)
}

fn open_failure(path: &Path, error: OpenError) -> Failure {
    let name = path.to_string_lossy().into_owned();
    let (fault, exit, reason) = match error {
        OpenError::Io(error) => (Fault::FileUnreadable, Exit::WrongUse, Some(error.to_string())),
        OpenError::Folder => (Fault::FileUnreadable, Exit::WrongUse, Some("it is a folder".to_owned())),
        OpenError::NotText => (Fault::FileNotText, Exit::Finding, None),
        OpenError::Utf16 => (Fault::FileNotText, Exit::Finding, None),
        OpenError::Empty => (Fault::FileEmpty, Exit::Finding, None),
    };
    let mut failure =
        Failure { alarm: Box::new(Alarm::core(fault, Span::default())), exit }.with("file", name);
    if let Some(reason) = reason {
        failure = failure.with("reason", reason);
    }
    failure
}

fn read_config<T>(
    path: &Path,
    parse: impl Fn(&str) -> Result<T, ferrocut_machine::ConfigError>,
) -> Result<T, Failure> {
    let name = path.to_string_lossy().into_owned();
    let text = std::fs::read_to_string(path).map_err(|e| {
        Failure::wrong_use(Fault::FileUnreadable).with("file", name.as_str()).with("reason", e.to_string())
    })?;
    parse(&text).map_err(|e| {
        Failure::wrong_use(Fault::ConfigUnusable).with("file", name.as_str()).with("reason", e.to_string())
    })
}
