//! What the memory holds, as plain data, and the changes that can be made to it.

use crate::rights::Level;
use ferrocut_geometry::{Axis, AxisSet, Position};
use ferrocut_machine::setup::VariableName;
use ferrocut_machine::{Alarm, AlarmId, Argument, Fault, ParameterKey, ToolOffset, WorkOffset, alarm_table};
use std::collections::BTreeMap;
use std::time::{SystemTime, UNIX_EPOCH};

/// Milliseconds since 1970, UTC.
pub type Time = i64;

/// The time now.
pub fn now() -> Time {
    let since = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
    Time::try_from(since.as_millis()).unwrap_or(Time::MAX)
}

/// A part of the memory that is backed up and restored by itself.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Hash)]
pub enum Item {
    /// Part programs.
    Programs,
    /// Parameters.
    Parameters,
    /// Tool offsets with their wear.
    Offsets,
    /// Work zeros.
    WorkZeros,
    /// Reference points.
    ReferencePoints,
    /// Macro variables.
    Variables,
    /// Pitch tables.
    Pitch,
    /// Keep relays, timers, counters and data of the ladder.
    Plc,
    /// Counters of parts and time.
    Counters,
    /// The alarm history.
    Alarms,
    /// The operation log.
    Log,
    /// Where the axes stood when power went off.
    LastPosition,
    /// The block at which a run was broken off.
    Interrupted,
    /// The ladder that was put in the place of the machine's own.
    Ladder,
}

impl Item {
    /// Every item.
    pub const ALL: [Item; 14] = [
        Item::Programs,
        Item::Parameters,
        Item::Offsets,
        Item::WorkZeros,
        Item::ReferencePoints,
        Item::Variables,
        Item::Pitch,
        Item::Plc,
        Item::Counters,
        Item::Alarms,
        Item::Log,
        Item::LastPosition,
        Item::Interrupted,
        Item::Ladder,
    ];

    /// Its name in files and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Item::Programs => "programs",
            Item::Parameters => "parameters",
            Item::Offsets => "offsets",
            Item::WorkZeros => "zeros",
            Item::ReferencePoints => "reference-points",
            Item::Variables => "variables",
            Item::Pitch => "pitch",
            Item::Plc => "plc",
            Item::Counters => "counters",
            Item::Alarms => "alarms",
            Item::Log => "log",
            Item::LastPosition => "position",
            Item::Interrupted => "interrupted",
            Item::Ladder => "ladder",
        }
    }

    /// The item of a name.
    pub fn named(name: &str) -> Option<Item> {
        Item::ALL.into_iter().find(|item| item.name() == name)
    }
}

/// A part program.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Program {
    /// Its text, in whatever encoding it came.
    pub text: Vec<u8>,
    /// Its comment, for the list.
    pub comment: String,
    /// When it was first stored.
    pub created: Time,
    /// When it was last changed.
    pub changed: Time,
    /// The level that locked it; those below cannot change it.
    pub locked: Option<Level>,
}

/// A program of the list.
#[derive(Clone, PartialEq, Debug)]
pub struct ProgramEntry {
    /// Its name or number: `O1234`, `MAIN`.
    pub name: String,
    /// Length of its text in bytes.
    pub bytes: u64,
    /// Its comment.
    pub comment: String,
    /// When it was first stored.
    pub created: Time,
    /// When it was last changed.
    pub changed: Time,
    /// The level that locked it.
    pub locked: Option<Level>,
}

/// Areas of the ladder that keep their values.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Hash)]
pub enum PlcArea {
    /// Keep relays.
    K,
    /// Times of timers.
    T,
    /// Counters.
    C,
    /// Data table.
    D,
}

/// How much of an area a value takes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SignalSize {
    /// This bit of a byte, 0 to 7.
    Bit(u8),
    /// So many bytes, 1 to 4, the lowest first.
    Bytes(u8),
}

impl PlcArea {
    /// Every area.
    pub const ALL: [PlcArea; 4] = [PlcArea::K, PlcArea::T, PlcArea::C, PlcArea::D];

    /// Its letter.
    pub fn name(self) -> &'static str {
        match self {
            PlcArea::K => "K",
            PlcArea::T => "T",
            PlcArea::C => "C",
            PlcArea::D => "D",
        }
    }

    /// The area of a letter.
    pub fn named(name: &str) -> Option<PlcArea> {
        PlcArea::ALL.into_iter().find(|area| area.name() == name)
    }
}

/// A counter.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Hash)]
pub enum Counter {
    /// Parts made (GSK990MC operation 3.1.2: counted by M30 and M02, kept while power is off).
    Parts,
    /// Parts made since the machine was built.
    AllParts,
    /// Time in which programs ran, s.
    RunTime,
    /// Time in which metal was cut, s.
    CuttingTime,
    /// Time in which metal was cut since the machine was built, s.
    AllCuttingTime,
    /// Time for which power was on, s.
    PowerOnTime,
    /// How often the control was started.
    Starts,
}

impl Counter {
    /// Every counter.
    pub const ALL: [Counter; 7] = [
        Counter::Parts,
        Counter::AllParts,
        Counter::RunTime,
        Counter::CuttingTime,
        Counter::AllCuttingTime,
        Counter::PowerOnTime,
        Counter::Starts,
    ];

    /// The highest value that may be set: pieces and starts, of which only whole ones are there, or seconds.
    pub fn highest(self) -> f64 {
        if self.is_time() { 1e9 } else { 99_999_999.0 }
    }

    /// Whether it counts seconds.
    pub fn is_time(self) -> bool {
        matches!(
            self,
            Counter::RunTime | Counter::CuttingTime | Counter::AllCuttingTime | Counter::PowerOnTime
        )
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Counter::Parts => "parts",
            Counter::AllParts => "all-parts",
            Counter::RunTime => "run-time",
            Counter::CuttingTime => "cutting-time",
            Counter::AllCuttingTime => "all-cutting-time",
            Counter::PowerOnTime => "power-on-time",
            Counter::Starts => "starts",
        }
    }

    /// The counter of a name.
    pub fn named(name: &str) -> Option<Counter> {
        Counter::ALL.into_iter().find(|counter| counter.name() == name)
    }
}

/// An alarm of the history.
#[derive(Clone, PartialEq, Debug)]
pub struct AlarmEntry {
    /// When.
    pub time: Time,
    /// Its number as alarms are shown: `gsk990mc:0045`, `FC-0302`.
    pub id: String,
    /// The program that ran; empty where none did.
    pub program: String,
    /// The line of the program; 0 where none is meant.
    pub line: u32,
    /// The values that its text names.
    pub arguments: Vec<(String, String)>,
}

impl AlarmEntry {
    /// An alarm as it goes into the history.
    pub fn of(alarm: &Alarm, program: &str, time: Time) -> AlarmEntry {
        let argument = |argument: &Argument| match argument {
            Argument::Number(value) => value.to_string(),
            Argument::Text(text) => text.to_string(),
        };
        AlarmEntry {
            time,
            id: alarm.id.to_string(),
            program: program.to_owned(),
            line: alarm.span.line,
            arguments: alarm.arguments.iter().map(|(name, a)| ((*name).to_owned(), argument(a))).collect(),
        }
    }

    /// The number by which catalogues have its text; none of an alarm that this software does not know.
    pub fn alarm_id(&self) -> Option<AlarmId> {
        if let Some(number) = self.id.strip_prefix("FC-") {
            let number: u16 = number.parse().ok()?;
            return Fault::ALL.iter().find(|fault| **fault as u16 == number).copied().map(AlarmId::Core);
        }
        let (dialect, _) = self.id.split_once(':')?;
        alarm_table(dialect).iter().map(|row| row.id).find(|id| id.to_string() == self.id)
    }
}

/// An entry of the operation log.
#[derive(Clone, PartialEq, Debug)]
pub struct LogEntry {
    /// When.
    pub time: Time,
    /// With which level; none where no person at the control did it.
    pub level: Option<Level>,
    /// Who.
    pub who: String,
    /// What kind of thing: the name of an item, or `rights`, `memory`.
    pub item: String,
    /// What of it: `P270`, `12 length_wear`, `#500`, `G54 X`.
    pub name: String,
    /// What it was.
    pub from: String,
    /// What it became.
    pub to: String,
}

/// Where the axes stood.
#[derive(Clone, PartialEq, Debug)]
pub struct LastPosition {
    /// When that was told.
    pub time: Time,
    /// Machine position, mm and degrees.
    pub position: Position,
    /// The axes whose position was known (homed).
    pub referenced: AxisSet,
    /// The work coordinate system in force, which power-on shows again (GSK990MC 4.2.8, 3); where G92 made one of its own, the
    /// one that follows it.
    pub work_system: Option<WorkOffset>,
    /// The zero of the one that G92 made, mm and degrees.
    pub own_zero: Option<Position>,
}

/// The block at which a run was broken off, or of a run that is under way the one that was told last.
#[derive(Clone, PartialEq, Debug)]
pub struct InterruptedRun {
    /// When that was told.
    pub time: Time,
    /// The program that was started.
    pub program: String,
    /// The line from which it was started, from 1.
    pub from_line: u32,
    /// The file of the block: the program itself, or one that it called.
    pub file: String,
    /// Its line, from 1.
    pub line: u32,
    /// The number of the block, each pass of a block counted.
    pub block: u64,
    /// Its text, cut where it is long: by this it is known again.
    pub text: String,
    /// Machine position where the axes stood; none in what an older version kept.
    pub at: Option<Position>,
}

/// What a person's session came to, for the operation log.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SessionNote {
    /// He commands the machine.
    TakesCommand,
    /// He commands it no longer: given up, or his connection has ended.
    LeavesCommand,
    /// He asked the one in command for it.
    AsksForCommand,
    /// He asks no longer: taken back, or his connection has ended.
    WithdrawsRequest,
    /// He gave command to one who asked for it.
    HandsOver {
        /// The number of the other's connection.
        to: u64,
    },
    /// He did not give it to one who asked for it.
    Declines {
        /// The number of the other's connection.
        to: u64,
    },
    /// He logged out of a panel.
    LogsOut,
}

impl SessionNote {
    /// What the log calls it, and what it came to.
    pub fn names(self) -> (&'static str, String) {
        match self {
            SessionNote::TakesCommand => ("command", "taken".to_owned()),
            SessionNote::LeavesCommand => ("command", "left".to_owned()),
            SessionNote::AsksForCommand => ("command", "asked for".to_owned()),
            SessionNote::WithdrawsRequest => ("command", "asked for no longer".to_owned()),
            SessionNote::HandsOver { to } => ("command", format!("handed over to connection {to}")),
            SessionNote::Declines { to } => ("command", format!("declined to connection {to}")),
            SessionNote::LogsOut => ("log out", String::new()),
        }
    }
}

/// A change to the memory.
#[derive(Clone, PartialEq, Debug)]
pub enum Change {
    /// Stores a program, new or in place of the one of this name.
    Program {
        /// Its name.
        name: String,
        /// Its text.
        text: Vec<u8>,
        /// Its comment.
        comment: String,
    },
    /// Deletes a program.
    DeleteProgram {
        /// Its name.
        name: String,
    },
    /// Gives a program another name. What there is of that name stays: then it is refused.
    RenameProgram {
        /// Its name.
        name: String,
        /// Its new name.
        to: String,
        /// Its text, which may name the program too.
        text: Vec<u8>,
    },
    /// Locks a program with the level of who asks, or unlocks it.
    LockProgram {
        /// Its name.
        name: String,
        /// Whether it is locked.
        locked: bool,
    },
    /// Sets a parameter, in the unit of the control's list; none is as delivered.
    Parameter {
        /// Which.
        key: ParameterKey,
        /// Its value.
        value: Option<f64>,
    },
    /// Sets a tool offset.
    Offset {
        /// Its number, from 1.
        number: u16,
        /// Its values.
        offset: ToolOffset,
    },
    /// Sets the zero of a work coordinate system.
    WorkZero {
        /// Which.
        name: WorkOffset,
        /// Machine position of the zero.
        zero: Position,
    },
    /// Sets a reference point, 1 to 4.
    ReferencePoint {
        /// Which.
        number: u8,
        /// Its machine position.
        position: Position,
    },
    /// Sets a macro variable; none empties it.
    Variable {
        /// Which.
        name: VariableName,
        /// Its value.
        value: Option<f64>,
    },
    /// Sets a point of the pitch table of an axis, mm.
    Pitch {
        /// The axis.
        axis: Axis,
        /// Number of the point.
        point: u16,
        /// What is added to the commanded position there.
        value: f64,
    },
    /// Sets bytes that the ladder keeps.
    Plc {
        /// The area.
        area: PlcArea,
        /// The first byte.
        first: u16,
        /// The bytes.
        bytes: Vec<u8>,
    },
    /// Sets a value that the ladder keeps.
    Signal {
        /// The area.
        area: PlcArea,
        /// The first byte.
        first: u16,
        /// What of it.
        size: SignalSize,
        /// The value, without sign.
        value: u32,
    },
    /// Says which ladder runs from now on.
    Ladder {
        /// Its text; none is the machine's own.
        text: Option<String>,
    },
    /// Adds to the log that a signal of the ladder was forced; nothing else is kept of it.
    Force {
        /// Its name or address.
        signal: String,
        /// To what; none releases it.
        value: Option<bool>,
    },
    /// Sets a counter.
    Counter {
        /// Which.
        counter: Counter,
        /// Its value, pieces or s.
        value: f64,
    },
    /// Adds an alarm to the history.
    Alarm(AlarmEntry),
    /// Empties the alarm history.
    ClearAlarms,
    /// Empties the operation log; that it was emptied stays in it.
    ClearLog,
    /// Notes in the operation log who may do what from now on.
    Session(SessionNote),
    /// Machine zero was set where an axis stood: noted in the operation log.
    MachineZero {
        /// The axis.
        axis: Axis,
        /// Its machine position, mm or degrees.
        from: f64,
        /// What the same place is called from now on: the first reference point.
        to: f64,
    },
    /// Says where the axes stand.
    LastPosition(LastPosition),
    /// Says where a run was broken off; none when it came to its end.
    Interrupted(Option<InterruptedRun>),
}

/// Everything that the memory holds, of one moment.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Contents {
    /// Programs by name.
    pub programs: BTreeMap<String, Program>,
    /// Parameters that somebody has set.
    pub parameters: BTreeMap<ParameterKey, f64>,
    /// Tool offsets that somebody has set.
    pub offsets: BTreeMap<u16, ToolOffset>,
    /// Work zeros that somebody has set.
    pub work_zeros: BTreeMap<WorkOffset, Position>,
    /// Reference points that somebody has set, by number.
    pub reference_points: BTreeMap<u8, Position>,
    /// Variables that are not empty.
    pub variables: BTreeMap<VariableName, f64>,
    /// Points of the pitch tables that somebody has set.
    pub pitch: BTreeMap<(Axis, u16), f64>,
    /// What the ladder keeps: for each area its bytes from 0 to the last that was ever stored.
    pub plc: BTreeMap<PlcArea, Vec<u8>>,
    /// Counters that were ever set.
    pub counters: BTreeMap<Counter, f64>,
    /// The alarm history, newest first.
    pub alarms: Vec<AlarmEntry>,
    /// The operation log, newest first.
    pub log: Vec<LogEntry>,
    /// Where the axes stood.
    pub last_position: Option<LastPosition>,
    /// Where a run was broken off.
    pub interrupted: Option<InterruptedRun>,
    /// The ladder that runs in the place of the machine's own.
    pub ladder: Option<String>,
}

/// Whether a program can be called so, and be asked for by it over HTTP: nothing that a path or the head of an answer is
/// made of.
pub fn is_program_name(name: &str) -> bool {
    let is_part = |c: char| !c.is_control() && !matches!(c, '/' | '\\' | '"');
    let is_long = name.len() > limits::NAME;
    !name.trim().is_empty() && !is_long && !matches!(name, "." | "..") && name.chars().all(is_part)
}

/// Bounds of the memory. Each is far above what the controls have; none can be passed, so that neither a
/// program in a loop nor a hostile backup fills the disk.
pub mod limits {
    /// Longest name of a program or a variable, bytes.
    pub const NAME: usize = 128;
    /// Longest comment, program name of an alarm, name of a person, bytes.
    pub const TEXT: usize = 1024;
    /// Longest program, bytes. The GSK990MC asks for DNC above 4 MB (operation 3.4.4).
    pub const PROGRAM: usize = 16 << 20;
    /// Longest ladder, bytes: far above that of the 4,700 steps of a GSK990MC, with remarks.
    pub const LADDER: usize = 4 << 20;
    /// Most programs.
    pub const PROGRAMS: i64 = 10_000;
    /// Most bytes of all programs together in a backup.
    pub const PROGRAM_BYTES: u64 = 1 << 30;
    /// Most parameters, variables, points of pitch tables.
    pub const VALUES: i64 = 65_536;
    /// Alarms that are kept. The GSK990MC shows 9 pages (operation 3.7).
    pub const ALARMS: i64 = 1_000;
    /// Entries of the operation log that are kept. The GSK990MC shows 29 pages (operation 3.7).
    pub const LOG: i64 = 10_000;
    /// Bytes of an area of the ladder.
    pub const AREA: usize = 10_000;
    /// Most values of an alarm's text.
    pub const ARGUMENTS: usize = 16;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_name_of_a_program_leads_out_of_the_memory() {
        let longest = "x".repeat(limits::NAME);
        for name in ["O0001", "PLATE-2", "A.NC", "PART 1", "零件", "...", &longest] {
            assert!(is_program_name(name), "{name:?}");
        }
        let too_long = format!("{longest}x");
        let wrong =
            ["", " ", ".", "..", "../O1", "a/b", "a\\b", "/etc/passwd", "a\"b", "a\nb", "a\0b", &too_long];
        for name in wrong {
            assert!(!is_program_name(name), "{name:?}");
        }
    }
}
