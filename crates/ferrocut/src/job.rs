//! A program to work on, with the machine and set-up it runs on.

use crate::cli::{Common, Format};
use crate::diagnostics::Diagnostics;
use crate::drawing::{FromDrawing, Opened, Source};
use crate::pockets::BesideProgram;
use ferrocut_controller::control::PublicPrograms;
use ferrocut_geometry::AxisNames;
use ferrocut_interpreter::dialects::guess::{Reason, guess};
use ferrocut_interpreter::{Dialect, Interpreter, MachineCodes, Options, dialects, place_variables};
use ferrocut_machine::{
    Alarm, Catalogue, ConfigError, Fault, Language, Machine, Memory, ParameterFile, ParameterKey, Setup,
    ToolLibrary,
};
use ferrocut_program::{OpenError, ProgramMemory, Span, Text};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The language whose tool tables and parameter files have formats of their own.
const LINUXCNC: &str = "rs274";

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
    /// The file that it is about, and its text, where the alarm points into one.
    pub file: String,
    /// The text.
    pub programs: Option<Box<ProgramMemory>>,
}

impl Failure {
    /// A failure that points into no text.
    pub fn new(alarm: Box<Alarm>, exit: Exit) -> Failure {
        Failure { alarm, exit, file: String::new(), programs: None }
    }

    fn wrong_use(fault: Fault) -> Failure {
        Failure::new(Box::new(Alarm::core(fault, Span::default())), Exit::WrongUse)
    }

    /// A control language that there is none of.
    pub fn unknown_dialect(name: &str) -> Failure {
        Failure::wrong_use(Fault::UnknownDialect).with("name", name)
    }

    /// A setting that cannot be used.
    pub fn setting(alarm: Box<Alarm>) -> Failure {
        Failure::new(alarm, Exit::WrongUse)
    }

    fn of_setting(fault: Fault, setting: &str, value: &str, allowed: &str) -> Failure {
        let failure = Failure::wrong_use(fault).with("setting", setting).with("value", value);
        failure.with("allowed", allowed)
    }

    /// A setting by its name, what was given for it and what it may be.
    pub fn bad_setting(setting: &str, value: &str, allowed: &str) -> Failure {
        Failure::of_setting(Fault::ImportSetting, setting, value, allowed)
    }

    /// The same of a ladder's run.
    pub fn ladder_setting(setting: &str, value: &str, allowed: &str) -> Failure {
        Failure::of_setting(Fault::LadderSetting, setting, value, allowed)
    }

    /// The same of a plot.
    pub fn plot_setting(setting: &str, value: &str, allowed: &str) -> Failure {
        Failure::of_setting(Fault::PlotSetting, setting, value, allowed)
    }

    /// A configuration that cannot be used.
    pub fn config(file: &str, reason: &str) -> Failure {
        Failure::wrong_use(Fault::ConfigUnusable).with("file", file).with("reason", reason)
    }

    /// A place where nobody can be served.
    pub fn cannot_serve(place: &str, reason: &str) -> Failure {
        Failure::wrong_use(Fault::CannotServe).with("place", place).with("reason", reason)
    }

    /// A file that is no drawing.
    pub fn no_drawing(file: &str) -> Failure {
        Failure::wrong_use(Fault::NoDrawing).about(file)
    }

    /// A file that cannot be read.
    pub fn unreadable(file: &str, reason: &str) -> Failure {
        Failure::wrong_use(Fault::FileUnreadable).about(file).with("reason", reason)
    }

    /// A file that a result was to be written to.
    pub fn cannot_write(file: &str, error: &std::io::Error) -> Failure {
        Failure::cannot_write_for(file, &error.to_string())
    }

    /// A file that a result was to be written to, and why it cannot.
    pub fn cannot_write_for(file: &str, reason: &str) -> Failure {
        Failure::wrong_use(Fault::FileUnwritable).about(file).with("reason", reason)
    }

    /// A result that would be written over what the command reads.
    pub fn output_is_input(file: &str) -> Failure {
        Failure::wrong_use(Fault::OutputIsInput).about(file)
    }

    /// A picture in a format that there is not.
    pub fn picture_format(file: &str) -> Failure {
        Failure::wrong_use(Fault::PictureFormat).about(file)
    }

    /// Why a file could not be opened as a program.
    pub fn of_open(path: &Path, error: OpenError) -> Failure {
        let (fault, exit, reason) = match error {
            OpenError::Io(error) => (Fault::FileUnreadable, Exit::WrongUse, Some(error.to_string())),
            OpenError::Folder => (Fault::FileUnreadable, Exit::WrongUse, Some("it is a folder".to_owned())),
            OpenError::NotText => (Fault::FileNotText, Exit::Finding, None),
            OpenError::Utf16 => (Fault::FileNotText, Exit::Finding, None),
            OpenError::Empty => (Fault::FileEmpty, Exit::Finding, None),
        };
        let mut failure =
            Failure::new(Box::new(Alarm::core(fault, Span::default())), exit).about(&path.to_string_lossy());
        if let Some(reason) = reason {
            failure = failure.with("reason", reason);
        }
        failure
    }

    /// With the file that it is about.
    fn about(mut self, file: &str) -> Failure {
        file.clone_into(&mut self.file);
        self.with("file", file)
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
    /// The files of both, for telling the line of what the control refuses.
    machine_file: Option<PathBuf>,
    setup_file: Option<PathBuf>,
    /// A tool table of LinuxCNC.
    library: Option<ToolLibrary>,
    /// A parameter file of LinuxCNC.
    parameter_file: Option<ParameterFile>,
    axis_names: AxisNames,
    dialect: Option<String>,
    public: Public,
    tool_change: Option<PathBuf>,
    block_skip: bool,
    optional_stop: bool,
}

/// Programs that come with the machine. The command line and the machine file name them, a program never.
enum Public {
    None,
    /// Those of the demo machine.
    BuiltIn,
    /// The file, and the machine file where that names it.
    File(PathBuf, Option<PathBuf>),
}

impl Public {
    fn of(common: &Common, machine: &Machine) -> Public {
        match (&common.public, &common.machine, &machine.public_programs) {
            (Some(path), ..) => Public::File(path.clone(), None),
            (None, _, None) => Public::None,
            (None, None, Some(_)) => Public::BuiltIn,
            (None, Some(machine), Some(name)) => {
                Public::File(machine.with_file_name(name), Some(machine.clone()))
            }
        }
    }

    fn path(&self) -> &Path {
        if let Public::File(path, _) = self { path } else { Path::new("public.dat") }
    }

    /// Their text; `None` where the machine brings none.
    fn text(&self) -> Option<Result<Text, OpenError>> {
        match self {
            Public::None => None,
            Public::BuiltIn => Some(Text::from_bytes(Machine::DEMO_PROGRAMS.as_bytes().to_vec())),
            Public::File(path, _) => Some(Text::open(path)),
        }
    }

    /// Their name and text. Without them a program cannot be run: any of its codes may be theirs.
    fn read(&self, texts: Catalogue) -> Result<Option<(String, Text)>, Failure> {
        let Some(text) = self.text() else { return Ok(None) };
        let path = self.path();
        let name = path.to_string_lossy();
        let text = text.map_err(|error| match (self, error) {
            (Public::File(_, Some(machine)), OpenError::Io(error)) => {
                let named = [("file", (&*name).into()), ("reason", error.to_string().into())];
                let reason = texts.label("label-public-missing", &named);
                Failure::config(&machine.to_string_lossy(), &reason)
            }
            (_, error) => Failure { exit: Exit::WrongUse, ..Failure::of_open(path, error) },
        })?;
        Ok(Some((name.into_owned(), text)))
    }
}

/// What the control language of a program was told from.
#[derive(Clone, Copy)]
pub enum Told {
    /// Someone named it.
    Named,
    /// Nothing: it is that of the built-in machine.
    NotNamed,
    /// It was guessed.
    Guessed(Reason),
}

impl Shop {
    /// The programs that come with the machine, for a control that runs it.
    pub fn public_programs(&self) -> Result<Option<PublicPrograms>, Failure> {
        // Other languages know no codes of a shop, and need no such file.
        let has_codes =
            dialects::by_name(&self.machine.dialect).is_some_and(|dialect| dialect.custom.is_some());
        let read = if has_codes { self.public.read(self.diagnostics.catalogue())? } else { None };
        Ok(read.map(|(name, text)| PublicPrograms { name, text: Arc::new(text) }))
    }

    /// The tool change program that the machine file names.
    pub fn tool_change(&self) -> Result<Option<Vec<u8>>, Failure> {
        let Some(path) = &self.tool_change else { return Ok(None) };
        let unreadable = |error: std::io::Error| Failure::of_open(path, OpenError::Io(error));
        let bytes = std::fs::read(path).map_err(unreadable)?;
        let text = Text::from_bytes(bytes.clone());
        text.map_err(|error| Failure { exit: Exit::WrongUse, ..Failure::of_open(path, error) })?;
        Ok(Some(bytes))
    }

    /// Reads machine and set-up file.
    pub fn open(common: &Common) -> Result<Shop, Failure> {
        let texts = diagnostics(common).catalogue();
        let machine = match &common.machine {
            None => Machine::demo_mill(),
            Some(path) => read_config(path, Machine::from_toml, texts)?,
        };
        let setup = match &common.setup {
            None => Setup::default(),
            Some(path) => read_config(path, Setup::from_toml, texts)?,
        };
        let public = Public::of(common, &machine);
        if common.public.is_some() {
            // Also where the control has no use for it: a wrong name is wrong use.
            public.read(texts)?;
        }
        let library =
            common.tool_table.as_deref().map(|path| read_config(path, ToolLibrary::from_tbl, texts));
        let parameter_file =
            common.var_file.as_deref().map(|path| read_config(path, ParameterFile::from_var, texts));
        // Who gives files of LinuxCNC says that the programs are too.
        let files = [("--tool-table", library.is_some()), ("--var-file", parameter_file.is_some())];
        let linuxcnc = files.into_iter().find_map(|(option, is_given)| is_given.then_some(option));
        let named = common.dialect.as_ref().or(setup.dialect.as_ref());
        // A name that is no language's is told as one.
        let is_other = |name: &&String| *name != LINUXCNC && dialects::by_name(name).is_some();
        if let (Some(option), Some(other)) = (linuxcnc, named.filter(is_other)) {
            let reason = texts.label("label-linuxcnc-file", &[("dialect", other.as_str().into())]);
            return Err(Failure::config(option, &reason));
        }
        let axis_names =
            setup.axis_names().map_err(|e| refused(common.setup.as_deref(), "setup", &e, texts))?;
        Ok(Shop {
            public,
            tool_change: (common.machine.as_deref().zip(machine.tool_change.file.as_ref()))
                .map(|(machine, name)| machine.with_file_name(name)),
            machine,
            axis_names,
            machine_is_built_in: common.machine.is_none(),
            dialect: named.cloned().or_else(|| linuxcnc.map(|_| LINUXCNC.to_owned())),
            block_skip: common.block_skip || setup.options.block_skip,
            optional_stop: common.optional_stop || setup.options.optional_stop,
            setup,
            machine_file: common.machine.clone(),
            setup_file: common.setup.clone(),
            library: library.transpose()?,
            parameter_file: parameter_file.transpose()?,
            diagnostics: diagnostics(common),
        })
    }

    /// The control language that is named, else the machine's, which a drawing is written in.
    pub fn own_dialect(&self) -> Result<(&'static Dialect, Told), Failure> {
        let name = self.dialect.as_ref().unwrap_or(&self.machine.dialect);
        let Some(dialect) = dialects::by_name(name) else {
            return Err(Failure::unknown_dialect(name));
        };
        let is_named = self.dialect.is_some() || !self.machine_is_built_in;
        Ok((dialect, if is_named { Told::Named } else { Told::NotNamed }))
    }

    /// The control language of a program: the one named, else the machine's, unless its text proves that it
    /// is another, or where the machine is the built-in one, its name says so.
    fn dialect(&self, text: &Text, path: &Path) -> Result<(&'static Dialect, Told), Failure> {
        let (dialect, told) = self.own_dialect()?;
        if self.dialect.is_some() {
            return Ok((dialect, told));
        }
        let extension = path.extension().map(|e| e.to_string_lossy());
        // One that cannot be read is told when the programs are taken in.
        let public = self.public.text().and_then(Result::ok);
        let is_firm = !self.machine_is_built_in;
        let guess = guess(text, public.as_ref(), extension.as_deref(), dialect, is_firm);
        Ok(match (guess.reason, self.machine_is_built_in) {
            (Reason::Preferred, true) => (dialect, Told::NotNamed),
            (Reason::Preferred, false) => (dialect, Told::Named),
            (reason, _) => (guess.dialect, Told::Guessed(reason)),
        })
    }

    /// Opens a program.
    pub fn job(&self, path: &Path) -> Result<Job, Failure> {
        let text = match Source::open(path, self.setup.import.as_ref())? {
            Opened::Drawing(source) => {
                let (dialect, told) = self.own_dialect()?;
                let parameters = self.memory_of(dialect, told)?.parameters;
                let (programs, drawing) = source.run(dialect, &parameters)?;
                return self.job_of(path, (dialect, told), programs, Some(drawing));
            }
            Opened::Program(text) => text_of(path, text).map_err(|error| Failure::of_open(path, error))?,
        };
        let (dialect, told) = self.dialect(&text, path)?;
        let programs = match path == Path::new("-") {
            true => ProgramMemory::new("standard input", text, dialect.syntax),
            false => ProgramMemory::at(path, text, dialect.syntax),
        };
        self.job_of(path, (dialect, told), programs, None)
    }

    /// A job of a program that is in memory.
    pub fn job_of(
        &self,
        path: &Path,
        (dialect, told): (&'static Dialect, Told),
        mut programs: ProgramMemory,
        drawing: Option<FromDrawing>,
    ) -> Result<Job, Failure> {
        if dialect.custom.is_some()
            && let Some((name, text)) = self.public.read(self.diagnostics.catalogue())?
        {
            programs.add(&name, text);
        }
        let memory = self.memory_of(dialect, told)?;
        let inputs = self.setup.signals.inputs.iter().filter_map(|(name, value)| {
            let input = match name.strip_prefix('#') {
                Some(variable) => Input::Variable(variable.parse().ok()?),
                None => Input::Port(name.parse().ok()?),
            };
            Some((input, *value))
        });
        let inputs = inputs.collect();
        Ok(Job { path: path.to_path_buf(), dialect, told, programs, memory, inputs, drawing, keeps: false })
    }

    /// What the machine remembers before a program in this language.
    pub fn memory_of(&self, dialect: &'static Dialect, told: Told) -> Result<Memory, Failure> {
        let mut memory = Memory::new(dialect.name);
        let texts = self.diagnostics.catalogue();
        // A program of another control than the machine's meets none of its parameters.
        let own = dialect.name == self.machine.dialect || !matches!(told, Told::Guessed(_));
        let parse = |(name, value): (&String, &f64)| name.parse::<ParameterKey>().map(|key| (key, *value));
        let parameters: Result<Vec<_>, _> =
            self.machine.parameters.iter().filter(|_| own).map(parse).collect();
        parameters
            .and_then(|all| memory.set_parameters(all.iter().map(|(key, value)| (key, *value))))
            .map_err(ConfigError::parameter)
            .map_err(|error| refused(self.machine_file.as_deref(), &self.machine.name, &error, texts))?;
        // The files of LinuxCNC first: a set-up file has the last word.
        if dialect.name == LINUXCNC {
            memory.library = self.library.clone();
            if let Some(file) = &self.parameter_file {
                let unusable = |error: ConfigError| Failure::config("--var-file", &error.told(texts));
                file.apply(&mut memory).map_err(unusable)?;
            }
        }
        let unusable = |error: ConfigError| refused(self.setup_file.as_deref(), "setup", &error, texts);
        self.setup.apply(&mut memory).map_err(unusable)?;
        place_variables(dialect, memory).map_err(Failure::setting)
    }

    /// The control language and what it was told from, in words.
    pub fn language(&self, dialect: &Dialect, told: Told) -> String {
        let catalogue = self.diagnostics.catalogue();
        let name = ("dialect", dialect.name.into());
        match told {
            Told::Named => dialect.name.to_owned(),
            Told::NotNamed => catalogue.label("label-guessed", &[name]),
            Told::Guessed(Reason::Content { unread, blocks }) => {
                let other = ("other", self.machine.dialect.as_str().into());
                let counts = [("unread", (unread as f64).into()), ("blocks", (blocks as f64).into())];
                catalogue.label("label-guessed-content", &[[name, other], counts].concat())
            }
            Told::Guessed(_) => catalogue.label("label-guessed-extension", &[name]),
        }
    }

    /// How the operator's switches stand.
    pub fn options(&self) -> Options {
        Options {
            start: self.setup.start.position_of(&self.axis_names),
            axis_names: self.axis_names,
            block_skip: self.block_skip,
            optional_stop: self.optional_stop,
            skip: self.setup.signals.skip.as_ref().map(|signal| (signal.axis, signal.at)),
            ends_at_fixed_point: true,
            machine_codes: MachineCodes::of(&self.machine.handshake.m_codes),
            ..Options::default()
        }
    }
}

/// How messages of a command are shown.
pub fn diagnostics(common: &Common) -> Diagnostics {
    let language = common.show.language.clone().or_else(|| {
        ["LC_ALL", "LC_MESSAGES", "LANG"]
            .into_iter()
            .find_map(|v| std::env::var(v).ok().filter(|t| !t.is_empty()))
    });
    let language = language.and_then(|tag| Language::from_tag(&tag)).unwrap_or_default();
    Diagnostics::new(Catalogue::new(language), common.show.format == Format::Json)
}

/// A program that was opened.
pub struct Job {
    /// Where it came from.
    pub path: PathBuf,
    /// Its control language.
    pub dialect: &'static Dialect,
    /// What the language was told from.
    pub told: Told,
    programs: ProgramMemory,
    memory: Memory,
    inputs: Vec<(Input, f64)>,
    drawing: Option<FromDrawing>,
    /// What is computed of it may be kept beside it.
    keeps: bool,
}

/// A simulated input.
#[derive(Clone, Copy)]
enum Input {
    /// By the variable that programs read it as.
    Variable(u32),
    /// By its number.
    Port(u16),
}

impl Job {
    /// What was passed over in the drawing that the program was made from.
    pub fn notes(&self) -> impl Iterator<Item = &Alarm> {
        self.drawing.iter().flat_map(|drawing| drawing.warnings.iter().chain(&drawing.notes))
    }

    /// Takes the warnings about the drawing, for a command that shows them itself.
    pub fn take_warnings(&mut self) -> Vec<Alarm> {
        self.drawing.as_mut().map(|drawing| std::mem::take(&mut drawing.warnings)).unwrap_or_default()
    }

    /// Says on standard error that the control language was guessed, or that the file was taken for a drawing and
    /// what of it was left out.
    pub fn tell(&self, shop: &Shop) {
        if let (Told::Guessed(_), false) = (self.told, shop.diagnostics.is_json()) {
            eprintln!("{}: {}", self.path.display(), shop.language(self.dialect, self.told));
        }
        if let Some(drawing) = &self.drawing {
            drawing.tell(&self.path.to_string_lossy(), &self.programs, &shop.diagnostics);
        }
    }

    /// The programs, for showing what a span says.
    pub fn programs(&self) -> &ProgramMemory {
        &self.programs
    }

    /// The job of a command that executes the program: what is computed of it is kept beside it.
    pub fn keeping(self) -> Job {
        Job { keeps: true, ..self }
    }

    /// An interpreter before the first block.
    pub fn interpreter(self, options: Options) -> Interpreter {
        let mut interpreter = Interpreter::new(self.dialect, self.programs, self.memory, options);
        if let Some(kept) = BesideProgram::of(&self.path, self.keeps).filter(|_| self.drawing.is_none()) {
            interpreter.keep_pockets(Box::new(kept));
        }
        if let Some(drawing) = self.drawing {
            interpreter.set_origins(drawing.origins);
        }
        for (input, value) in self.inputs {
            match input {
                Input::Variable(variable) => interpreter.set_input(variable, value),
                Input::Port(port) => interpreter.set_port(port, value),
            }
        }
        interpreter
    }
}

/// The text of a file, or of standard input, where it was not `read` already.
pub fn text_of(path: &Path, read: Option<Text>) -> Result<Text, OpenError> {
    match (read, path == Path::new("-")) {
        (Some(text), _) => Ok(text),
        (None, true) => Text::from_reader(std::io::stdin().lock()),
        (None, false) => Text::open(path),
    }
}

/// What a control refuses of a file, with its line where that is known; `name` stands for a file that is not there.
fn refused(file: Option<&Path>, name: &str, error: &ConfigError, texts: Catalogue) -> Failure {
    let Some(path) = file else { return Failure::config(name, &error.told(texts)) };
    let name = path.to_string_lossy();
    let text = std::fs::read_to_string(path).unwrap_or_default();
    let place = error.line(&text).map_or_else(|| name.to_string(), |line| format!("{name}:{line}"));
    Failure::config(&place, &error.told(texts))
}

fn read_config<T>(
    path: &Path,
    parse: impl Fn(&str) -> Result<T, ConfigError>,
    texts: Catalogue,
) -> Result<T, Failure> {
    let name = path.to_string_lossy().into_owned();
    let text = std::fs::read_to_string(path).map_err(|e| Failure::unreadable(&name, &e.to_string()))?;
    parse(&text).map_err(|e| Failure { file: name.clone(), ..Failure::config(&name, &e.told(texts)) })
}
