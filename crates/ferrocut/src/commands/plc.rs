//! `ferrocut plc`: ladders.

mod check;
mod import;
mod run;

use crate::cli::{Common, Show};
use crate::diagnostics::Diagnostics;
use crate::job::{Exit, Failure};
use clap::{Args, Subcommand};
use ferrocut_controller::control::ladder_alarm;
use ferrocut_machine::Alarm;
use ferrocut_plc::{Error, Fault, Limits, Program, list, plcopen};
use ferrocut_program::{FileId, ProgramMemory, Span, Syntax, Text};
use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

/// Largest ladder file that is read, bytes.
const MOST_BYTES: u64 = 16 << 20;

/// Faults of one ladder beyond which only their number is told.
const MOST_FAULTS: usize = 200;

/// `ferrocut plc`
#[derive(Args)]
pub struct PlcArgs {
    /// What to do.
    #[command(subcommand)]
    pub command: PlcCommand,
}

/// The commands of `ferrocut plc`.
#[derive(Subcommand)]
pub enum PlcCommand {
    /// Find every fault of ladders
    Check(CheckArgs),
    /// Run a ladder at a desk: set inputs at times, see what changes
    Run(RunArgs),
    /// Turn a ladder diagram (PLCopen XML) into a mnemonic list
    Import(ImportArgs),
}

/// `ferrocut plc check`
#[derive(Args)]
#[command(after_help = "A ladder is a mnemonic list or PLCopen XML (TC6) with ladder diagrams.\n\n\
    Exit status: 0 fine, 1 a fault, 2 a file that cannot be read.\n\n\
    Example:\n  \
    ferrocut plc check machines/standard.lad")]
pub struct CheckArgs {
    /// The ladders; - reads standard input
    #[arg(value_name = "FILE", required = true)]
    pub files: Vec<PathBuf>,
    /// How results are printed.
    #[command(flatten)]
    pub show: Show,
}

/// `ferrocut plc run`
#[derive(Args)]
#[command(
    after_help = "A signal is named by its address (X20.3, D10) or by its name in the ladder. Every change\n\
    of a watched signal is printed with its time; without --watch those are all bits of Y and G.\n\n\
    Exit status: 0 fine, 1 a fault of the ladder or its stop (1021), 2 wrong use.\n\n\
    Examples:\n  \
    ferrocut plc run machines/standard.lad --set X8.4=1 --set X1=255 --set F0.6=1 --set 100:KEY_COOLANT=1\n  \
    ferrocut plc run mill.lad --for 5000 --set 200:F10=3 --set 201:F7.0=1 --watch Y0.1,G4.3 --flow"
)]
pub struct RunArgs {
    /// The ladder; - reads standard input
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// How long, ms
    #[arg(long = "for", value_name = "MS", default_value_t = 1_000, value_parser = clap::value_parser!(u32).range(1..=86_400_000))]
    pub time: u32,
    /// Period of the scan, ms
    #[arg(long, value_name = "MS", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=100))]
    pub period: u32,
    /// Steps of the ladder in a period; level 2 is divided where it has more
    #[arg(long, value_name = "NUMBER", default_value_t = 5_000, value_parser = clap::value_parser!(u32).range(100..=1_000_000))]
    pub steps: u32,
    /// Set a bit or byte, at a time in ms or from the beginning: 100:X20.3=1. May be given several times
    #[arg(long, value_name = "[MS:]SIGNAL=VALUE")]
    pub set: Vec<String>,
    /// Force a bit or byte throughout, whatever the ladder writes
    #[arg(long, value_name = "SIGNAL=VALUE")]
    pub force: Vec<String>,
    /// Signals whose changes are printed
    #[arg(long, value_name = "SIGNAL", value_delimiter = ',')]
    pub watch: Vec<String>,
    /// Print the ladder with its powered flow at the end
    #[arg(long)]
    pub flow: bool,
    /// How results are printed.
    #[command(flatten)]
    pub show: Show,
}

/// `ferrocut plc import`
#[derive(Args)]
#[command(
    after_help = "A program POU named LEVEL1 is level 1, all others are level 2; function blocks P1, P2 …\n\
    are subprograms. Variables are signals by their name (X8.4) or location (%IX8.4 is X, %QX Y, %MX R);\n\
    those without a location get relays from R5000 on. What is not understood is told with its line.\n\n\
    Example:\n  \
    ferrocut plc import mill.xml -o mill.lad"
)]
pub struct ImportArgs {
    /// The PLCopen XML file; - reads standard input
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// The mnemonic list to write [default: standard output]
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// How results are printed.
    #[command(flatten)]
    pub show: Show,
}

impl PlcArgs {
    /// What it shares with the commands that read a program.
    pub fn common(&self) -> Common {
        let show = match &self.command {
            PlcCommand::Check(args) => &args.show,
            PlcCommand::Run(args) => &args.show,
            PlcCommand::Import(args) => &args.show,
        };
        show.common(None, None)
    }
}

/// Runs the command.
pub fn run(args: &PlcArgs) -> Result<Exit, Failure> {
    let diagnostics = crate::job::diagnostics(&args.common());
    match &args.command {
        PlcCommand::Check(args) => check::run(args, diagnostics),
        PlcCommand::Run(args) => run::run(args, diagnostics),
        PlcCommand::Import(args) => import::run(args, diagnostics),
    }
}

/// A ladder file, and what it is.
pub struct Source {
    name: String,
    bytes: Vec<u8>,
}

impl Source {
    /// Reads a file.
    pub fn open(path: &Path) -> Result<Source, Failure> {
        let is_input = path == Path::new("-");
        let name = if is_input { "standard input".into() } else { path.to_string_lossy().into_owned() };
        let mut bytes = Vec::new();
        let read = match is_input {
            true => io::stdin().lock().take(MOST_BYTES + 1).read_to_end(&mut bytes),
            false => File::open(path).and_then(|file| file.take(MOST_BYTES + 1).read_to_end(&mut bytes)),
        };
        let missing = |reason: String| {
            let error = Error::about(Fault::FileMissing, Default::default(), format!("{name}: {reason}"));
            Failure::new(Box::new(ladder_alarm(&error, Span::default())), Exit::WrongUse)
        };
        read.map_err(|error| missing(error.to_string()))?;
        if bytes.len() as u64 > MOST_BYTES {
            return Err(missing(format!("> {} MiB", MOST_BYTES >> 20)));
        }
        Ok(Source { name, bytes })
    }

    /// The ladder as it is written, with its faults.
    fn ladder(&self) -> (list::Ladder, Vec<Error>) {
        let mut errors = Vec::new();
        let ladder = match plcopen::is_xml(&self.bytes) {
            true => plcopen::read(&self.bytes, &mut errors),
            false => list::read(&self.bytes, &mut errors),
        };
        (ladder, errors)
    }

    fn compile(&self) -> Result<Program, Vec<Error>> {
        Program::from_file(&self.bytes, &Limits::default())
    }

    /// The ladder that is to be run; `None` once its faults were told, each with the file and its line.
    pub fn program(&self, diagnostics: &Diagnostics) -> Option<Program> {
        self.compile().map_err(|errors| self.report(&errors, diagnostics)).ok()
    }

    /// The text, for showing what a fault points at; none where the file is no text.
    fn text(&self) -> Option<ProgramMemory> {
        let text = Text::from_bytes(self.bytes.clone()).ok()?;
        Some(ProgramMemory::new(&self.name, text, &Syntax::WORDS))
    }

    /// Writes faults to standard error, each with its line.
    fn report(&self, errors: &[Error], diagnostics: &Diagnostics) {
        let text = self.text();
        for error in errors.iter().take(MOST_FAULTS) {
            diagnostics.report(&alarm(error), &self.name, text.as_ref());
        }
    }
}

/// A fault of a ladder as the control's alarm, which points at its place in the file.
fn alarm(error: &Error) -> Alarm {
    let span = Span {
        offset: error.span.offset as u64,
        len: u32::try_from(error.span.len).unwrap_or(u32::MAX),
        line: error.span.line,
        file: FileId(0),
    };
    ladder_alarm(error, span)
}
