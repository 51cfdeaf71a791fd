//! What can be wrong with the memory, and the alarm that says it.

use crate::items::Item;
use crate::rights::Level;
use ferrocut_machine::{Alarm, Argument, Fault, ParameterError};
use ferrocut_program::Span;
use std::fmt;
use std::time::Duration;

/// A piece of damage that was found.
#[derive(Clone, PartialEq, Debug)]
pub enum Finding {
    /// The database is not there, while other files say that there was one.
    Missing,
    /// What SQLite finds wrong with the structure of the file, in its words.
    Structure(String),
    /// The tables are not those of the schema.
    Schema,
    /// A row of this table does not make up its sum.
    Row {
        /// The table.
        table: &'static str,
    },
    /// Rows of this table have vanished or come back.
    Total {
        /// The table.
        table: &'static str,
    },
    /// Commits are missing that were reported as done.
    CommitsLost {
        /// Commits that are there.
        found: u64,
        /// Commits that were reported.
        reported: u64,
    },
    /// The file that counts reported commits is not there or cannot be read.
    MarkLost,
}

impl Finding {
    /// The text of the catalogue that tells it to people, and its values.
    pub fn label(&self) -> (&'static str, Vec<(&'static str, Argument)>) {
        match self {
            Finding::Missing => ("label-finding-missing", vec![]),
            Finding::Structure(said) => ("label-finding-structure", vec![("said", said.as_str().into())]),
            Finding::Schema => ("label-finding-schema", vec![]),
            Finding::Row { table } => ("label-finding-row", vec![("table", (*table).into())]),
            Finding::Total { table } => ("label-finding-total", vec![("table", (*table).into())]),
            Finding::CommitsLost { found, reported } => (
                "label-finding-commits",
                vec![("found", (*found as f64).into()), ("reported", (*reported as f64).into())],
            ),
            Finding::MarkLost => ("label-finding-mark", vec![]),
        }
    }
}

/// As it stands in logs; people read the label.
impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Finding::Missing => f.write_str("memory.db: missing"),
            Finding::Structure(said) => write!(f, "memory.db: {said}"),
            Finding::Schema => f.write_str("memory.db: schema"),
            Finding::Row { table } => write!(f, "memory.db: {table}: row_sum"),
            Finding::Total { table } => write!(f, "memory.db: {table}: total"),
            Finding::CommitsLost { found, reported } => {
                write!(f, "memory.db-wal: commits {found} < {reported}")
            }
            Finding::MarkLost => f.write_str("mark: missing"),
        }
    }
}

/// Why the memory did not do what it was asked.
#[derive(Clone, PartialEq, Debug)]
pub enum Error {
    /// Damage that was met while reading.
    Damaged(Box<Finding>),
    /// The disk or the database refuses, in its words.
    Disk(String),
    /// The memory is closing.
    Closed,
    /// A higher level is needed.
    Right {
        /// The lowest level that may.
        needed: Level,
        /// The level that asked.
        level: Level,
    },
    /// A parameter forbids the change: its name.
    Protected(Box<str>),
    /// A program is locked by a level.
    Locked(Level),
    /// What asked may never do this: a part program that would change a password, for one.
    NotByThis,
    /// The level has no password yet, so that nobody has it.
    NoPassword(Level),
    /// The password is wrong.
    WrongPassword,
    /// The password is too short or too long.
    PasswordLength,
    /// Too many wrong passwords: wait.
    Wait(Duration),
    /// A parameter that does not exist or cannot have the value.
    Parameter(ParameterError),
    /// A value that cannot be stored: its name.
    Value(Box<str>),
    /// No room for more of this.
    Full(Item),
    /// A file that is no backup.
    NotABackup,
    /// A backup of a later version.
    NewerBackup(u64),
    /// A backup that is damaged: the line.
    BackupDamaged(u64),
    /// A backup of the memory of another control.
    OtherControl(Box<str>),
    /// A backup does not hold what was asked of it.
    NotInBackup(Item),
}

impl Error {
    /// Damage.
    pub fn damaged(finding: Finding) -> Error {
        Error::Damaged(Box::new(finding))
    }

    /// The alarm that tells it.
    pub fn alarm(&self) -> Alarm {
        let alarm = |fault| Alarm::core(fault, Span::default());
        match self {
            Error::Damaged(finding) => alarm(Fault::MemoryDamaged).with("detail", finding.to_string()),
            Error::Disk(reason) => alarm(Fault::MemoryDisk).with("reason", reason.as_str()),
            Error::Closed => alarm(Fault::MemoryDisk).with("reason", "closed"),
            Error::Right { needed, level } => alarm(Fault::RightMissing)
                .with("needed", f64::from(needed.number()))
                .with("level", f64::from(level.number())),
            Error::Protected(name) => alarm(Fault::ChangeProtected).with("parameter", &**name),
            Error::Locked(level) => alarm(Fault::ProgramLocked).with("level", f64::from(level.number())),
            Error::NotByThis => alarm(Fault::ChangeNotByProgram),
            Error::NoPassword(level) => {
                alarm(Fault::LevelWithoutPassword).with("level", f64::from(level.number()))
            }
            Error::WrongPassword => alarm(Fault::PasswordWrong),
            Error::PasswordLength => alarm(Fault::PasswordLength),
            Error::Wait(time) => alarm(Fault::PasswordWait).with("time", time.as_secs_f64().ceil()),
            Error::Parameter(error) => error.alarm(),
            Error::Value(name) => alarm(Fault::MemoryValue).with("detail", &**name),
            Error::Full(item) => alarm(Fault::MemoryFull).with("detail", item.name()),
            Error::NotABackup => alarm(Fault::NotABackup),
            Error::NewerBackup(version) => alarm(Fault::NotABackup).with("version", *version as f64),
            Error::BackupDamaged(line) => alarm(Fault::BackupDamaged).with("line", *line as f64),
            Error::OtherControl(name) => alarm(Fault::BackupOfOther).with("name", &**name),
            Error::NotInBackup(item) => alarm(Fault::NotInBackup).with("detail", item.name()),
        }
    }
}

/// As it stands in logs; people read the alarm.
impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Error::Damaged(finding) => finding.fmt(f),
            Error::Disk(reason) => f.write_str(reason),
            other => write!(f, "{other:?}"),
        }
    }
}

impl std::error::Error for Error {}

impl From<std::io::Error> for Error {
    fn from(error: std::io::Error) -> Error {
        Error::Disk(error.to_string())
    }
}

impl From<rusqlite::Error> for Error {
    fn from(error: rusqlite::Error) -> Error {
        use rusqlite::ErrorCode as Code;
        /// A sector that cannot be read, or a file that ends too early.
        const CANNOT_READ: [i32; 2] =
            [rusqlite::ffi::SQLITE_IOERR_READ, rusqlite::ffi::SQLITE_IOERR_SHORT_READ];
        let said = error.to_string();
        match error.sqlite_error() {
            Some(code) if CANNOT_READ.contains(&code.extended_code) => {
                Error::damaged(Finding::Structure(said))
            }
            Some(code) => match code.code {
                // `Unknown` is the general error: a table that is not there, a schema that cannot be read.
                Code::DatabaseCorrupt | Code::NotADatabase | Code::TypeMismatch | Code::Unknown => {
                    Error::damaged(Finding::Structure(said))
                }
                _ => Error::Disk(said),
            },
            // A cell of another type than its column.
            None => Error::damaged(Finding::Structure(said)),
        }
    }
}
