//! The command line.

use crate::commands::explain::ExplainArgs;
use crate::commands::machine::MachineArgs;
use clap::{Args, Parser, Subcommand, ValueEnum};
use std::path::PathBuf;

/// What `ferrocut` is asked to do.
#[derive(Parser)]
#[command(
    name = "ferrocut",
    version,
    about = "An open CNC: check, simulate, time and run part programs",
    long_about = "An open CNC: check, simulate, time and run part programs of industrial milling controls.\n\n\
        The same engine interprets a program at a desk and on a machine: what `check` says is what the\n\
        machine does.\n\n\
        Exit status: 0 fine, 1 an alarm or a finding, 2 wrong use.",
    after_help = "Examples:\n  \
        ferrocut check part.nc                    every fault of a program, not only the first\n  \
        ferrocut run part.nc                      run it on a simulated machine and report times\n  \
        ferrocut time part.nc --machine mill.toml how long it takes on your machine\n  \
        ferrocut view part.nc -o part.png         a picture of the path\n  \
        ferrocut explain G84                      what a code is, and which parameters bear on it\n  \
        cat part.nc | ferrocut trace -            every step as a line of JSON"
)]
pub struct Cli {
    /// The command.
    #[command(subcommand)]
    pub command: Command,
}

/// The commands.
#[derive(Subcommand)]
pub enum Command {
    /// Run a part program on the machine (simulated, as fast as it can)
    Run(RunArgs),
    /// Find every fault of part programs: syntax, alarms, travel limits, spindle, tools
    Check(CheckArgs),
    /// Print the steps of a part program as JSON lines
    Trace(TraceArgs),
    /// Predict how long a part program takes
    Time(TimeArgs),
    /// Draw the tool path (PNG or SVG)
    View(ViewArgs),
    /// Explain a code, parameter, alarm, macro variable or word of a program
    Explain(ExplainArgs),
    /// Machine files, and the parameters of the control in them
    Machine(MachineArgs),
}

/// What every command that reads a program takes.
#[derive(Args, Clone, Default)]
pub struct Common {
    /// Control language of the program [default: that of the set-up file; else guessed from the program, the
    /// machine's before others]
    #[arg(long, value_name = "NAME")]
    pub dialect: Option<String>,
    /// Machine file: axes, limits, speeds [default: the built-in demo mill]
    #[arg(long, value_name = "FILE")]
    pub machine: Option<PathBuf>,
    /// Programs that come with the machine and may stand for codes (public.dat) [default: those of the
    /// machine file]
    #[arg(long, value_name = "FILE")]
    pub public: Option<PathBuf>,
    /// Set-up file: work offsets, tool offsets, parameters, start position
    #[arg(long, value_name = "FILE")]
    pub setup: Option<PathBuf>,
    /// How results are printed
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// Language of messages: en or zh [default: from LANG]
    #[arg(long, value_name = "LANGUAGE")]
    pub language: Option<String>,
    /// Leave out blocks with a single `/`, as with the operator's switch on
    #[arg(long)]
    pub block_skip: bool,
    /// Stop at M01, as with the operator's switch on
    #[arg(long)]
    pub optional_stop: bool,
}

/// How results are printed.
#[derive(Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum Format {
    /// For people
    #[default]
    Text,
    /// For programs
    Json,
}

/// `ferrocut run`
#[derive(Args)]
pub struct RunArgs {
    /// The part program; - reads standard input
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// What every command takes.
    #[command(flatten)]
    pub common: Common,
    /// Run at true speed instead of as fast as possible
    #[arg(long)]
    pub realtime: bool,
    /// Write the position of every axis each servo period to this CSV file; - is standard output
    #[arg(long, value_name = "FILE")]
    pub samples: Option<PathBuf>,
    /// Feed override in percent, 1 to 200
    #[arg(long, value_name = "PERCENT", default_value_t = 100.0, value_parser = percent::<200>)]
    pub feed_override: f64,
    /// Rapid override in percent, 1 to 100
    #[arg(long, value_name = "PERCENT", default_value_t = 100.0, value_parser = percent::<100>)]
    pub rapid_override: f64,
}

/// `ferrocut check`
#[derive(Args)]
pub struct CheckArgs {
    /// The part programs; - reads standard input
    #[arg(value_name = "FILE", required = true)]
    pub files: Vec<PathBuf>,
    /// What every command takes.
    #[command(flatten)]
    pub common: Common,
}

/// `ferrocut trace`
#[derive(Args)]
pub struct TraceArgs {
    /// The part program; - reads standard input
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// What every command takes.
    #[command(flatten)]
    pub common: Common,
}

/// `ferrocut time`
#[derive(Args)]
pub struct TimeArgs {
    /// The part program; - reads standard input
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// What every command takes.
    #[command(flatten)]
    pub common: Common,
}

/// `ferrocut view`
#[derive(Args)]
pub struct ViewArgs {
    /// The part program; - reads standard input
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// The picture: a .png or .svg file
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
    /// What every command takes.
    #[command(flatten)]
    pub common: Common,
    /// Width of the picture in pixels
    #[arg(long, default_value_t = crate::view::DEFAULT_WIDTH)]
    pub width: u32,
}

fn percent<const MOST: u32>(text: &str) -> Result<f64, String> {
    match text.trim_end_matches('%').parse::<f64>() {
        // At 0 the machine would stand still for ever.
        Ok(value) if (1.0..=f64::from(MOST)).contains(&value) => Ok(value),
        _ => Err(format!("give a number from 1 to {MOST}")),
    }
}
