//! What a command comes to.

use super::{ByAxis, OffsetValues, Status};
use ferrocut_machine::{Alarm, Argument, Severity};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// What a command comes to.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(tag = "reply", rename_all = "snake_case")]
pub enum Reply {
    /// It is done.
    Done,
    /// It is on its way to the durable memory, since axes must not wait for the disk. The event `changed` or `refused`
    /// follows.
    OnItsWay,
    /// The list of the programs.
    Programs {
        /// In the order of their names.
        programs: Vec<ProgramInfo>,
        /// How many there can be at most; none where nothing is kept.
        #[serde(default)]
        most: Option<u32>,
        /// Bytes that there is room for yet; none where nothing is kept, or the disk does not tell.
        #[serde(default)]
        room: Option<u64>,
    },
    /// A program's text, decoded.
    Program {
        /// Its name.
        program: String,
        /// Its text.
        text: String,
    },
    /// What cycle start runs in MDI.
    MdiText {
        /// The text of the MDI page.
        text: String,
        /// The block that runs before it; empty for none.
        block: String,
    },
    /// Tool offsets.
    Offsets {
        /// By number.
        offsets: BTreeMap<u16, OffsetValues>,
    },
    /// Zeros of the work coordinate systems.
    Zeros {
        /// Machine positions by name and axis.
        zeros: BTreeMap<String, ByAxis>,
    },
    /// Reference points.
    ReferencePoints {
        /// Machine positions by number, 1 to 4.
        points: BTreeMap<u8, ByAxis>,
    },
    /// A table of pitch errors.
    Pitch {
        /// The axis.
        axis: char,
        /// What is added to the commanded position, mm, by number of the point; points that are not here add nothing.
        points: BTreeMap<u16, f64>,
    },
    /// Macro variables that are not empty.
    Variables {
        /// By number.
        variables: BTreeMap<u32, f64>,
    },
    /// Parameters.
    Parameters {
        /// By name.
        parameters: BTreeMap<String, f64>,
        /// Those that somebody has set, here, in the machine file or in a program, be it as delivered.
        given: Vec<String>,
        /// Those that say nothing of the machine until somebody sets them: its file does.
        left_to_file: Vec<String>,
    },
    /// The rights in force.
    Level {
        /// 1 to 5.
        level: u8,
    },
    /// The alarm history.
    AlarmHistory {
        /// Newest first.
        alarms: Vec<PastAlarm>,
    },
    /// The operation log.
    OperationLog {
        /// Newest first.
        entries: Vec<LogLine>,
    },
    /// Signals.
    Signals {
        /// By the name that was asked for; bytes and numbers as they are, bits 0 or 1.
        signals: BTreeMap<String, i64>,
    },
    /// Signals that have a name.
    SignalTable {
        /// In the order of their addresses.
        signals: Vec<NamedSignal>,
    },
    /// Signals that are forced.
    Forced {
        /// In the order of their addresses.
        signals: Vec<ForcedSignal>,
    },
    /// Text: a ladder, a recording.
    Text {
        /// The text.
        text: String,
    },
    /// A ladder that was looked at.
    LadderChecked {
        /// Its list; none where it has faults.
        list: Option<String>,
        /// Its steps; 0 where it has faults.
        steps: u32,
        /// Its first 100 faults, in the order in which they were found: numbers of the control's list of alarms, lines of
        /// the text.
        faults: Vec<AlarmInfo>,
        /// How many faults there are.
        count: u32,
    },
    /// The powered flow of the ladder, by instruction.
    LadderFlow {
        /// Whether power flows behind each instruction.
        power: Vec<bool>,
    },
    /// What was recorded.
    Captured {
        /// Whether all samples are there.
        done: bool,
        /// When the trigger came, s since the recording began.
        triggered: Option<f64>,
        /// Samples that are there.
        samples: u32,
        /// Rows as CSV: time in s since the trigger or the beginning, and the quantities; the line of the names stands
        /// before row 0. Fewer than asked for at the end, and where the answer would be too long.
        csv: String,
    },
    /// What was traced of the ladder.
    Traced {
        /// Whether all samples are there.
        done: bool,
        /// When the trigger came, s since the ladder started.
        triggered: Option<f64>,
        /// The signals in the order of the bits, as addresses.
        signals: Vec<String>,
        /// Samples that are there.
        samples: u32,
        /// Samples: time, s since the ladder started, and the signals, bit n for signal n. The oldest is number 0: one
        /// that is written over while the trace runs is lost.
        rows: Vec<(f64, u32)>,
    },
    /// Points that were taken by hand, machine positions by number.
    Points {
        /// By number.
        points: BTreeMap<u8, ByAxis>,
    },
    /// What was measured; none yet.
    Measured {
        /// The last.
        measured: Option<Measurement>,
        /// Whether cycle start measures.
        ready: bool,
    },
    /// What can be taken up again.
    Restarts {
        /// The run that was broken off.
        interrupted: Option<InterruptedBlock>,
        /// Whether a restart is being searched.
        searching: bool,
        /// The restart that is ready for cycle start.
        ready: Option<Box<RestartPlan>>,
    },
    /// The status.
    Status(Box<Status>),
    /// The longest times.
    Timing {
        /// Servo periods since.
        periods: u64,
        /// The servo period, us.
        period_us: f64,
        /// From the beginning of a period to that of the next, us.
        worst_period_us: f64,
        /// What the control did in a period, us.
        worst_work_us: f64,
        /// Level 1 of the ladder, us.
        worst_level_1_us: f64,
        /// What was carried out of level 2 in a period, us.
        worst_level_2_us: f64,
        /// Periods that level 2 took from its beginning to its end.
        level_2_periods: u32,
    },
    /// Versions.
    Version {
        /// Of this interface.
        api: u32,
        /// Of the software.
        software: String,
        /// The control language.
        dialect: String,
        /// Name of the machine.
        machine: String,
        /// Letters of its axes, in its order.
        axes: Vec<char>,
        /// Servo period, ms.
        period_ms: f64,
        /// The clock of the control's computer, ms since 1970 (UTC).
        time: i64,
    },
}

/// A signal that the NC or the ladder has a name for.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct NamedSignal {
    /// Its name.
    pub name: String,
    /// Its address, `F7.0`; of a number, that of its first byte.
    pub address: String,
    /// What it means.
    pub meaning: String,
    /// What it is: a bit 0 or 1, a number without sign.
    pub value: u32,
}

/// A signal that is forced: nothing writes it until it is released.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct ForcedSignal {
    /// Its address: `Y0003.2`.
    pub address: String,
    /// What the ladder calls it; empty where it has no name.
    pub name: String,
    /// To what.
    pub value: bool,
}

/// A command that was refused, and why.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Refusal {
    /// Why.
    pub alarm: AlarmInfo,
}

/// An alarm or warning. Catalogues have its text by its number and values.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct AlarmInfo {
    /// Its number: `gsk990mc:0045`, `FC-0302`.
    pub id: String,
    /// The line of the program that it is about, from 1; 0 for none.
    pub line: u32,
    /// Whether it only warns.
    pub warning: bool,
    /// The values that its text names.
    pub values: BTreeMap<String, String>,
}

impl AlarmInfo {
    /// An alarm as fronts are told of it.
    pub fn of(alarm: &Alarm) -> AlarmInfo {
        let shown = |argument: &Argument| match argument {
            Argument::Number(value) => value.to_string(),
            Argument::Text(text) => text.to_string(),
        };
        AlarmInfo {
            id: alarm.id.to_string(),
            line: alarm.span.line,
            warning: alarm.severity == Severity::Warning,
            values: alarm.arguments.iter().map(|(name, value)| ((*name).to_owned(), shown(value))).collect(),
        }
    }
}

impl From<Alarm> for Refusal {
    fn from(alarm: Alarm) -> Refusal {
        Refusal { alarm: AlarmInfo::of(&alarm) }
    }
}

/// A program of the list.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct ProgramInfo {
    /// Its name.
    pub name: String,
    /// Length, bytes.
    pub bytes: u64,
    /// Its comment.
    pub comment: String,
    /// When it was changed, ms since 1970 (UTC); 0 where nobody knows.
    pub changed: i64,
    /// The level that locked it.
    pub locked: Option<u8>,
}

/// An alarm of the history.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct PastAlarm {
    /// When, ms since 1970 (UTC).
    pub time: i64,
    /// Its number.
    pub id: String,
    /// The program that ran.
    pub program: String,
    /// Its line, from 1; 0 for none.
    pub line: u32,
    /// The values that its text names.
    pub values: BTreeMap<String, String>,
}

/// An entry of the operation log.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct LogLine {
    /// When, ms since 1970 (UTC).
    pub time: i64,
    /// With which level; none where no person did it.
    pub level: Option<u8>,
    /// Who.
    pub who: String,
    /// What kind of thing.
    pub item: String,
    /// What of it.
    pub name: String,
    /// What it was.
    pub from: String,
    /// What it became.
    pub to: String,
}

/// The block at which a run was broken off.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct InterruptedBlock {
    /// The program that was started.
    pub program: String,
    /// The file of the block: the program, or one that it called.
    pub file: String,
    /// Its line, from 1.
    pub line: u32,
    /// Its text.
    pub text: String,
    /// When, ms since 1970 (UTC).
    pub time: i64,
    /// Whether the state at the program's start was kept: then a restart goes on with the variables of the run. After
    /// power-off it is not.
    pub kept: bool,
}

/// A restart that is ready: what cycle start will do, and what is not yet as the program has it.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct RestartPlan {
    /// The program.
    pub program: String,
    /// The file of the block.
    pub file: String,
    /// Its line, from 1.
    pub line: u32,
    /// The how manieth time it is reached; 0 for the block that was interrupted.
    pub pass: u64,
    /// Its text.
    pub text: String,
    /// The hole of a canned cycle with which it begins, from 1.
    pub hole: u32,
    /// What the search started from: `kept` or `present` (docs/restart.md).
    pub origin: String,
    /// Where the axes stand when the block begins, machine positions.
    pub position: ByAxis,
    /// What program and machine do not have alike now.
    pub differences: Vec<RestartDifference>,
    /// T, M and S that make the machine as the program has it, in their order.
    pub functions: Vec<String>,
    /// Whether the control sends them.
    pub sends: bool,
    /// The moves of the axes, in their order, from where they stand now.
    pub approach: Vec<RestartMove>,
    /// Whether each waits for cycle start.
    pub axis_by_axis: bool,
    /// Differences for which cycle start is refused: tool and spindle, where the control does not send them.
    pub missing: Vec<String>,
    /// Values of the memory that the search changes: variables that the program writes again.
    pub changes: u32,
    /// What the search could not know.
    pub warning: Option<AlarmInfo>,
}

/// Something that program and machine do not have alike.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct RestartDifference {
    /// What: `G03` (the modal group by the manual's number), `F`, `S`, `spindle`, `flood`, `mist`, `T`, `in_spindle`,
    /// `H`, `D`, `zero.X`, `length.Z`.
    pub of: String,
    /// What the program has.
    pub program: Option<String>,
    /// What the machine has.
    pub machine: Option<String>,
}

/// A move of one axis.
#[derive(Clone, Copy, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct RestartMove {
    /// The axis.
    pub axis: char,
    /// Machine position, mm or degrees.
    pub to: f64,
    /// Whether it positions; else it cuts.
    pub rapid: bool,
    /// mm/min; none is that of positioning.
    pub speed: Option<f64>,
}

/// What was measured.
#[derive(Clone, PartialEq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Measurement {
    /// Machine positions of the place that was found, by axis, mm.
    pub place: ByAxis,
    /// Sizes that were found, mm: a diameter; widths along X and Y; length and diameter of a tool.
    pub sizes: Vec<f64>,
    /// The farthest that a touch lies beside the circle, mm.
    pub out_of_round: f64,
    /// What it was stored to: `G54`, `H3`, `D3`, parameters.
    pub stored: Vec<String>,
}
