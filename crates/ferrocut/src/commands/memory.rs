//! `ferrocut memory`: what a control keeps while its power is off.

mod keep;
mod look;
mod tables;

pub use keep::open;

use crate::cli::{Common, Show};
use crate::diagnostics::Diagnostics;
use crate::job::{Exit, Failure};
use clap::builder::{PathBufValueParser, TypedValueParser};
use clap::{Args, Subcommand};
use ferrocut_machine::Alarm;
use ferrocut_memory::damage::Damage;
use ferrocut_memory::{Author, Error, Item, OpenError, Time};
use std::path::{Path, PathBuf};

/// `ferrocut memory`
#[derive(Args)]
pub struct MemoryArgs {
    /// What to do.
    #[command(subcommand)]
    pub command: MemoryCommand,
}

/// The commands of `ferrocut memory`.
#[derive(Subcommand)]
pub enum MemoryCommand {
    /// Show what a memory holds
    Show(ShowArgs),
    /// Check memories and backups: every byte that counts
    Check(CheckArgs),
    /// Write a memory, or parts of it, into one file
    Backup(BackupArgs),
    /// Read a backup, or parts of it, into a memory
    Restore(RestoreArgs),
    /// Take up the last good state of a damaged memory
    Recover(RecoverArgs),
    /// Set the password of a level
    Password(PasswordArgs),
}

/// Names of items, for help.
const ITEMS: &str = "The items are\n  \
    programs, parameters, offsets, zeros, reference-points, variables, pitch, plc, counters, alarms, log,\n  \
    position, interrupted, ladder.";

/// `ferrocut memory show`
#[derive(Args)]
#[command(after_help = format!("Without --item it says how much there is of each item. A control that runs may be\n\
    looked at too. {ITEMS}\n\n\
    Examples:\n  \
    ferrocut memory show /var/lib/ferrocut\n  \
    ferrocut memory show /var/lib/ferrocut --item offsets,zeros\n  \
    ferrocut memory show /var/lib/ferrocut --item log --format json | head"))]
pub struct ShowArgs {
    /// The folder of the memory
    #[arg(value_name = "FOLDER")]
    pub folder: PathBuf,
    /// Show these items, row by row
    #[arg(long, value_name = "ITEM", value_delimiter = ',', value_parser = item)]
    pub item: Vec<Item>,
    /// How results are printed.
    #[command(flatten)]
    pub show: Show,
}

/// `ferrocut memory check`
#[derive(Args)]
#[command(
    after_help = "Looks at the structure of the database, the sum of every row, the totals of every table, and\n\
    whether each commit that was confirmed is there; of a backup at its sum and every row. Nothing is changed. Of a\n\
    damaged memory the good states are listed.\n\n\
    Exit status: 0 whole, 1 damaged, 2 a memory or file that cannot be read.\n\n\
    Example:\n  \
    ferrocut memory check /var/lib/ferrocut /media/usb/mill.backup"
)]
pub struct CheckArgs {
    /// Folders of memories, and backups; - is a backup on standard input
    #[arg(value_name = "PATH", required = true)]
    pub paths: Vec<PathBuf>,
    /// How results are printed.
    #[command(flatten)]
    pub show: Show,
}

/// `ferrocut memory backup`
#[derive(Args)]
#[command(after_help = format!("The file is text, a row a line, with a sum over all of it: two backups can be compared by\n\
    any tool. It is of one moment, also of a control that runs. Passwords are never in it. {ITEMS}\n\n\
    Examples:\n  \
    ferrocut memory backup /var/lib/ferrocut -o mill.backup\n  \
    ferrocut memory backup /var/lib/ferrocut -o tools.backup --item offsets,parameters\n  \
    ferrocut memory backup /var/lib/ferrocut -o - | gzip > mill.backup.gz"))]
pub struct BackupArgs {
    /// The folder of the memory
    #[arg(value_name = "FOLDER")]
    pub folder: PathBuf,
    /// The backup to write; - is standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
    /// Only these items [default: all]
    #[arg(long, value_name = "ITEM", value_delimiter = ',', value_parser = item)]
    pub item: Vec<Item>,
    /// How results are printed.
    #[command(flatten)]
    pub show: Show,
}

/// `ferrocut memory restore`
#[derive(Args)]
#[command(after_help = format!("The whole file is checked first; then all is written or nothing. Programs of the backup are put\n\
    beside those that there are, in place of those of the same name; the histories are merged; every other item becomes\n\
    what the backup has of it. The position at power-off and the interrupted program are restored only where named. A memory that does not exist\n\
    is made. The control must not run. {ITEMS}\n\n\
    Examples:\n  \
    ferrocut memory restore mill.backup /var/lib/ferrocut\n  \
    ferrocut memory restore mill.backup /var/lib/ferrocut --item parameters,pitch\n  \
    gzip -dc mill.backup.gz | ferrocut memory restore - /var/lib/ferrocut"))]
pub struct RestoreArgs {
    /// The backup; - reads standard input
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// The folder of the memory
    #[arg(value_name = "FOLDER", value_parser = folder())]
    pub folder: PathBuf,
    /// Only these items [default: all that the backup holds, but position and interrupted]
    #[arg(long, value_name = "ITEM", value_delimiter = ',', value_parser = item)]
    pub item: Vec<Item>,
    /// How results are printed.
    #[command(flatten)]
    pub show: Show,
}

/// `ferrocut memory recover`
#[derive(Args)]
#[command(
    after_help = "Takes the newest good state up: the database itself where only its last commits are lost, else a\n\
    snapshot. The damaged files are kept in a folder damaged-…, and the operation log has what was done. A memory that is\n\
    whole is left alone. `ferrocut memory check` lists the states.\n\n\
    Examples:\n  \
    ferrocut memory recover /var/lib/ferrocut\n  \
    ferrocut memory recover /var/lib/ferrocut --commit 1200"
)]
pub struct RecoverArgs {
    /// The folder of the memory
    #[arg(value_name = "FOLDER")]
    pub folder: PathBuf,
    /// The good state with this commit [default: the newest]
    #[arg(long, value_name = "NUMBER")]
    pub commit: Option<u64>,
    /// How results are printed.
    #[command(flatten)]
    pub show: Show,
}

/// `ferrocut memory password`
#[derive(Args)]
#[command(
    after_help = "For a new control, and for one whose passwords are lost: whoever has its files in hand may do\n\
    it. The password is the first line of standard input, so that it stands in no list of commands. A level without a\n\
    password is locked. 1 is the maker of the control, 2 the builder of the machine, 3 commissioning, 4 the shop; the\n\
    operator, 5, needs none.\n\n\
    Example:\n  \
    ferrocut memory password /var/lib/ferrocut --level 3\n  \
    ferrocut memory password /var/lib/ferrocut --level 1 --dialect gsk990mc   # a new control"
)]
pub struct PasswordArgs {
    /// The folder of the memory
    #[arg(value_name = "FOLDER", value_parser = folder())]
    pub folder: PathBuf,
    /// Make a memory of this control where there is none yet
    #[arg(long, value_name = "NAME")]
    pub dialect: Option<String>,
    /// The level, 1 to 4
    #[arg(long, value_name = "LEVEL", value_parser = clap::value_parser!(u8).range(1..=4))]
    pub level: u8,
    /// How results are printed.
    #[command(flatten)]
    pub show: Show,
}

impl MemoryArgs {
    /// What it shares with the commands that read a program.
    pub fn common(&self) -> Common {
        let show = match &self.command {
            MemoryCommand::Show(args) => &args.show,
            MemoryCommand::Check(args) => &args.show,
            MemoryCommand::Backup(args) => &args.show,
            MemoryCommand::Restore(args) => &args.show,
            MemoryCommand::Recover(args) => &args.show,
            MemoryCommand::Password(args) => &args.show,
        };
        show.common(None, None)
    }
}

/// Runs the command.
pub fn run(args: &MemoryArgs) -> Result<Exit, Failure> {
    let diagnostics = crate::job::diagnostics(&args.common());
    match &args.command {
        MemoryCommand::Show(args) => look::show(args, &diagnostics),
        MemoryCommand::Check(args) => look::check(args, &diagnostics),
        MemoryCommand::Backup(args) => keep::back_up(args, &diagnostics),
        MemoryCommand::Restore(args) => keep::restore(args, &diagnostics),
        MemoryCommand::Recover(args) => keep::recover(args, &diagnostics),
        MemoryCommand::Password(args) => keep::password(args, &diagnostics),
    }
}

/// A folder that is made where there is none; - is no name for one.
pub fn folder() -> impl TypedValueParser<Value = PathBuf> {
    PathBufValueParser::new().try_map(|folder| match folder.as_os_str() == "-" {
        true => Err("a memory is a folder; only a backup goes through - (./- is a folder of this name)"),
        false => Ok(folder),
    })
}

fn item(name: &str) -> Result<Item, String> {
    let names = || Item::ALL.map(Item::name).join(", ");
    Item::named(name).ok_or_else(|| format!("the items are {}", names()))
}

/// Items of the command line; all where none is named.
fn items(named: &[Item]) -> Vec<Item> {
    match named {
        [] => Item::ALL.to_vec(),
        named => named.to_vec(),
    }
}

/// Who works on the files of a control by the command line, as the log names it.
fn author() -> Author {
    let user = std::env::var("USER").or_else(|_| std::env::var("USERNAME")).unwrap_or_default();
    let name = match user.is_empty() {
        true => "ferrocut memory".to_owned(),
        false => format!("ferrocut memory ({user})"),
    };
    Author::Maintenance { name }
}

fn failure(alarm: Alarm, exit: Exit) -> Failure {
    Failure::new(Box::new(alarm), exit)
}

/// What the memory refuses, as the end of a command.
fn refused(error: &Error) -> Failure {
    let exit = match error {
        Error::Damaged(_) | Error::BackupDamaged(_) => Exit::Finding,
        _ => Exit::WrongUse,
    };
    failure(error.alarm(), exit)
}

/// A backup that is refused, as the end of a command.
fn refused_backup(file: &Path, error: &Error) -> Failure {
    let mut failure = refused(error);
    failure.alarm = Box::new(failure.alarm.with("file", name(file)));
    failure
}

/// A memory that cannot be opened, as the end of a command.
fn unopened(folder: &Path, error: &OpenError) -> Failure {
    match error {
        OpenError::Missing => failure(error.alarm().with("file", name(folder)), Exit::WrongUse),
        OpenError::Damaged(damage) => failure(with_good_state(error.alarm(), folder, damage), Exit::Finding),
        _ => failure(error.alarm(), Exit::WrongUse),
    }
}

/// Damage with the newest good state, and the command that takes it up.
fn with_good_state(alarm: Alarm, folder: &Path, damage: &Damage) -> Alarm {
    match damage.states().first() {
        None => alarm,
        Some(state) => alarm
            .with("commits", state.commits.to_string())
            .with("time", utc(state.time))
            .with("command", format!("ferrocut memory recover {}", name(folder))),
    }
}

/// A path as it is shown.
fn name(path: &Path) -> String {
    path.to_string_lossy().into_owned()
}

fn label(diagnostics: &Diagnostics, key: &str) -> String {
    diagnostics.catalogue().label(key, &[])
}

/// A time in UTC: `2026-11-21 22:19:03Z`.
fn utc(time: Time) -> String {
    let seconds = time.div_euclid(1000);
    let (days, rest) = (seconds.div_euclid(86_400), seconds.rem_euclid(86_400));
    // Days of a calendar whose years begin in March: the leap day comes last. Eras are of 400 years.
    let day = days + 719_468;
    let (era, of_era) = (day.div_euclid(146_097), day.rem_euclid(146_097));
    let year = (of_era - of_era / 1460 + of_era / 36_524 - of_era / 146_096) / 365;
    let of_year = of_era - (365 * year + year / 4 - year / 100);
    let month = (5 * of_year + 2) / 153;
    let of_month = of_year - (153 * month + 2) / 5 + 1;
    let month = if month < 10 { month + 3 } else { month - 9 };
    let year = year + era * 400 + i64::from(month <= 2);
    let (hour, minute, second) = (rest / 3600, rest / 60 % 60, rest % 60);
    format!("{year:04}-{month:02}-{of_month:02} {hour:02}:{minute:02}:{second:02}Z")
}

#[cfg(test)]
mod tests {
    use super::utc;

    #[test]
    fn times_are_those_of_the_calendar() {
        for (seconds, text) in [
            (0, "1970-01-01 00:00:00Z"),
            (951_782_399, "2000-02-28 23:59:59Z"),
            (951_782_400, "2000-02-29 00:00:00Z"),
            (951_868_800, "2000-03-01 00:00:00Z"),
            (4_107_542_400, "2100-03-01 00:00:00Z"),
            (-1, "1969-12-31 23:59:59Z"),
            (1_795_299_543, "2026-11-21 22:19:03Z"),
        ] {
            assert_eq!(utc(seconds * 1000), text);
        }
    }
}
