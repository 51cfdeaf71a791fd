//! `ferrocut machine`: machine files and the parameters of the control in them.

mod check;
mod edit;
mod new;
mod params;

use crate::cli::{Common, Show};
use crate::job::{Exit, Failure};
use clap::{Args, Subcommand};
use std::path::PathBuf;

/// `ferrocut machine`
#[derive(Args)]
pub struct MachineArgs {
    /// What to do.
    #[command(subcommand)]
    pub command: MachineCommand,
}

/// The commands of `ferrocut machine`.
#[derive(Subcommand)]
pub enum MachineCommand {
    /// Write a commented machine file to start from
    New(NewArgs),
    /// Check machine files and summarise them
    Check(CheckArgs),
    /// List, explain, get, set, check, import and export the parameters of the control
    Params(ParamsArgs),
}

/// `ferrocut machine new`
#[derive(Args)]
#[command(
    after_help = "The file is that of the demo mill, with a comment beside every number. An existing file is\n\
    never overwritten.\n\n\
    Examples:\n  \
    ferrocut machine new -o mill.toml --name \"VMC 850\"\n  \
    ferrocut machine new -o - | less"
)]
pub struct NewArgs {
    /// The file to write; - is standard output
    #[arg(short, long, value_name = "FILE", default_value = "machine.toml")]
    pub output: PathBuf,
    /// Name of the machine
    #[arg(long, value_name = "NAME")]
    pub name: Option<String>,
    /// How results are printed.
    #[command(flatten)]
    pub show: Show,
}

/// `ferrocut machine check`
#[derive(Args)]
#[command(
    after_help = "Reads each file as every command does, and warns of numbers that can hardly be meant, such\n\
    as an acceleration in m/s² where mm/s² belong.\n\n\
    Exit status: 0 nothing to complain of, 1 an error or a warning, 2 a file that cannot be read.\n\n\
    Example:\n  \
    ferrocut machine check mill.toml lathe.toml"
)]
pub struct CheckArgs {
    /// The machine files; - reads standard input
    #[arg(value_name = "FILE", required = true)]
    pub files: Vec<PathBuf>,
    /// How results are printed.
    #[command(flatten)]
    pub show: Show,
}

/// `ferrocut machine params`
#[derive(Args)]
#[command(
    after_help = "NAME is a number (P270, NO43.1 or 43#1) or a symbol of the list (ODI, g73_retract).\n\
    Values stand in the [parameters] table of a machine file; what is not there has its default.\n\n\
    Examples:\n  \
    ferrocut machine params list --room tapping\n  \
    ferrocut machine params list --changed --machine mill.toml\n  \
    ferrocut machine params explain 43#1\n  \
    ferrocut machine params set P270=1.5 43#1=0 --machine mill.toml\n  \
    ferrocut machine params export --machine mill.toml -o mill.csv"
)]
pub struct ParamsArgs {
    /// What to do.
    #[command(subcommand)]
    pub command: ParamsCommand,
}

/// The commands of `ferrocut machine params`.
#[derive(Subcommand)]
pub enum ParamsCommand {
    /// List parameters with value, default, range, unit and meaning
    List(ListArgs),
    /// Explain parameters: meaning, range, and the codes and alarms that they bear on
    Explain(NamesArgs),
    /// Print values as NAME=VALUE lines, which `set` reads
    Get(NamesArgs),
    /// Set values in a machine file; comments and order stay
    Set(SetArgs),
    /// Check that every parameter of a machine file exists and is in range
    Check(ParamsCheckArgs),
    /// Write parameters as a CSV table: name, value, default, min, max, unit, meaning
    Export(ExportArgs),
    /// Set the values of a CSV table in a machine file, all or none
    Import(ImportArgs),
}

/// Whose parameters.
#[derive(Args, Clone)]
pub struct Whose {
    /// Machine file whose values are shown [default: values as delivered]
    #[arg(long, value_name = "FILE")]
    pub machine: Option<PathBuf>,
    /// Control language [default: that of the machine]
    #[arg(long, value_name = "NAME")]
    pub dialect: Option<String>,
    /// How results are printed.
    #[command(flatten)]
    pub show: Show,
}

/// `ferrocut machine params list`
#[derive(Args)]
#[command(after_help = "A * marks values that differ from the default. The rooms are\n  \
    acceleration, bus-servo, canned-cycles, compensation, coordinates, display, feed, homing, io,\n  \
    limits, lookahead, macro, other, plc, program-edit, security, spindle, tapping, tool-change, tool-life.\n\
    Parameters marked as kept are stored with their value, meaning and range; this version does\n\
    nothing with them yet.\n\n\
    Examples:\n  \
    ferrocut machine params list --find retract\n  \
    ferrocut machine params list --room limits | less -S")]
pub struct ListArgs {
    /// Only parameters with this text in number, symbol, meaning or room
    #[arg(long, value_name = "TEXT")]
    pub find: Option<String>,
    /// Only parameters of this part of the control
    #[arg(long, value_name = "ROOM")]
    pub room: Option<String>,
    /// Only parameters whose value differs from the default
    #[arg(long)]
    pub changed: bool,
    /// Whose parameters.
    #[command(flatten)]
    pub whose: Whose,
}

/// `ferrocut machine params explain` and `get`
#[derive(Args)]
pub struct NamesArgs {
    /// Parameters: P270, NO43.1, 43#1, a symbol, or NO43 for all bits of a bit parameter
    #[arg(value_name = "NAME", required = true)]
    pub names: Vec<String>,
    /// Whose parameters.
    #[command(flatten)]
    pub whose: Whose,
}

/// `ferrocut machine params set`
#[derive(Args)]
#[command(
    after_help = "All values are checked first; if one is wrong, nothing is written. The value `default` takes\n\
    the parameter out of the file.\n\n\
    Exit status: 0, or 2 where nothing is written.\n\n\
    Example:\n  \
    ferrocut machine params set P270=1.5 NO43.1=0 P87=default --machine mill.toml"
)]
pub struct SetArgs {
    /// What to set: P270=1.5
    #[arg(value_name = "NAME=VALUE", required = true)]
    pub values: Vec<String>,
    /// The machine file to change
    #[arg(long, value_name = "FILE", required = true)]
    pub machine: PathBuf,
    /// How results are printed.
    #[command(flatten)]
    pub show: Show,
}

/// `ferrocut machine params check`
#[derive(Args)]
#[command(
    after_help = "Exit status: 0 fine, 1 a parameter that does not exist, stands twice or is out of range."
)]
pub struct ParamsCheckArgs {
    /// The machine file to check
    #[arg(long, value_name = "FILE", required = true)]
    pub machine: PathBuf,
    /// How results are printed.
    #[command(flatten)]
    pub show: Show,
}

/// `ferrocut machine params export`
#[derive(Args)]
pub struct ExportArgs {
    /// The table to write; - is standard output
    #[arg(short, long, value_name = "FILE", default_value = "-")]
    pub output: PathBuf,
    /// Only parameters whose value differs from the default
    #[arg(long)]
    pub changed: bool,
    /// Whose parameters.
    #[command(flatten)]
    pub whose: Whose,
}

/// `ferrocut machine params import`
#[derive(Args)]
#[command(
    after_help = "The columns `name` and `value` are read, in any order, with commas or semicolons. Values that\n\
    the machine has already are not written. If one row is wrong, nothing is written and every wrong\n\
    row is told.\n\n\
    Exit status: 0, or 2 where nothing is written, as that of `set`."
)]
pub struct ImportArgs {
    /// The table; - reads standard input
    #[arg(value_name = "FILE.csv")]
    pub file: PathBuf,
    /// The machine file to change
    #[arg(long, value_name = "FILE", required = true)]
    pub machine: PathBuf,
    /// How results are printed.
    #[command(flatten)]
    pub show: Show,
}

impl MachineArgs {
    /// What it shares with the commands that read a program.
    pub fn common(&self) -> Common {
        use ParamsCommand as P;
        match &self.command {
            MachineCommand::New(args) => args.show.common(None, None),
            MachineCommand::Check(args) => args.show.common(None, None),
            MachineCommand::Params(ParamsArgs { command }) => match command {
                P::List(ListArgs { whose, .. })
                | P::Explain(NamesArgs { whose, .. })
                | P::Get(NamesArgs { whose, .. })
                | P::Export(ExportArgs { whose, .. }) => {
                    whose.show.common(whose.machine.clone(), whose.dialect.clone())
                }
                P::Set(SetArgs { machine, show, .. })
                | P::Check(ParamsCheckArgs { machine, show })
                | P::Import(ImportArgs { machine, show, .. }) => show.common(Some(machine.clone()), None),
            },
        }
    }
}

/// Runs the command.
pub fn run(args: &MachineArgs) -> Result<Exit, Failure> {
    let common = args.common();
    match &args.command {
        MachineCommand::New(args) => new::run(args, &common),
        MachineCommand::Check(args) => check::run(args, &common),
        MachineCommand::Params(ParamsArgs { command }) => params::run(command, &common),
    }
}
