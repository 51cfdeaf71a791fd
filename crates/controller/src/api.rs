//! What a front (panel, socket, test) says to the control and hears of it: one type of commands, one of answers, one
//! of events, and the status. `docs/api.md` has them for those who write fronts.
//!
//! As JSON a command is an object whose field `do` names it, an answer one with `reply`, an event one with `event`.
//! Lengths are mm, angles degrees, feeds mm/min, speeds r/min, times s, overrides factors, unless a field says
//! otherwise. Axes are called by their letters. Numbers of a control's own tables (parameters) are in the control's
//! own units.

use crate::signals::Mode;
use ferrocut_machine::{Alarm, Argument, Severity};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Version of this interface. It counts up when a field changes its meaning or goes; new fields may come without.
pub const API_VERSION: u32 = 1;

/// Values by the letters of axes.
pub type ByAxis = BTreeMap<char, f64>;

/// What a front wants.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[serde(tag = "do", rename_all = "snake_case")]
pub enum Command {
    /// A key of the machine panel goes down or up. What it does is the ladder's.
    Key {
        /// The ladder's name of its signal, such as `KEY_START`.
        key: String,
        /// Pressed, or let go.
        down: bool,
    },
    /// A switch of the machine panel stands at a position.
    Switch {
        /// The ladder's name of its byte, such as `SWITCH_FEED`.
        switch: String,
        /// The position, from 0.
        position: u8,
    },
    /// The handwheel was turned.
    Handwheel {
        /// Counts; clockwise positive.
        counts: i32,
    },
    /// The button for emergency stop.
    EmergencyStop {
        /// Pressed, or released.
        pressed: bool,
    },
    /// The key reset of the keypad.
    Reset,

    /// The list of the programs.
    Programs,
    /// Chooses the program that AUTO runs.
    Select {
        /// Its name: `O1234`.
        program: String,
    },
    /// Stores a program, new or in place of the one of this name.
    Store {
        /// Its name.
        program: String,
        /// Its text.
        text: String,
    },
    /// Reads a program.
    Read {
        /// Its name.
        program: String,
    },
    /// Deletes a program.
    Delete {
        /// Its name.
        program: String,
    },
    /// Locks a program against those of lower rights, or unlocks it.
    Lock {
        /// Its name.
        program: String,
        /// Whether it is locked.
        locked: bool,
    },
    /// Puts the cursor into the program that is selected: cycle start begins there.
    Cursor {
        /// The line, from 1.
        line: u32,
    },
    /// The text of the MDI page, of any number of blocks.
    Mdi {
        /// The blocks.
        text: String,
    },
    /// One block of the page of the current block, which runs before the text of the MDI page.
    MdiBlock {
        /// The block; empty for none.
        block: String,
    },
    /// The program that DNC runs, or a further part of it.
    Dnc {
        /// Its text.
        text: String,
        /// Whether this begins it; else it goes on what came before.
        first: bool,
        /// Whether nothing follows.
        last: bool,
    },
    /// The program stops once behind this line.
    StopAt {
        /// The program; the one selected where it is missing.
        #[serde(default)]
        program: Option<String>,
        /// The sequence number N; none takes the stop back.
        sequence: Option<u32>,
    },
    /// Prepares the restart of an interrupted program.
    Restart {
        /// The line, from 1.
        line: u32,
        /// Which time that the line is reached, from 1.
        #[serde(default = "once")]
        pass: u32,
    },

    /// Reads tool offsets.
    Offsets {
        /// The first number.
        from: u16,
        /// The last one.
        to: u16,
    },
    /// Sets values of a tool offset; those missing stay.
    SetOffset {
        /// Its number.
        number: u16,
        /// The values.
        #[serde(flatten)]
        values: OffsetValues,
        /// Whether they are added to what is there.
        #[serde(default)]
        add: bool,
    },
    /// Reads the zeros of the work coordinate systems.
    Zeros,
    /// Sets the zero of a work coordinate system on some axes.
    SetZero {
        /// Its name: `G54`, `G54 P12`, `external`.
        system: String,
        /// Machine positions, mm and degrees.
        axes: ByAxis,
        /// Whether they are added to what is there.
        #[serde(default)]
        add: bool,
    },
    /// Sets the zero of a work coordinate system so that the place where an axis stands has a coordinate.
    ZeroHere {
        /// Its name.
        system: String,
        /// The coordinate of each axis.
        axes: ByAxis,
    },
    /// Reads macro variables by their numbers.
    Variables {
        /// The first number.
        from: u32,
        /// The last one.
        to: u32,
    },
    /// Sets a macro variable.
    SetVariable {
        /// Its number.
        number: u32,
        /// Its value; none empties it.
        value: Option<f64>,
    },
    /// Reads parameters by their names: `P86`, `NO12.6`.
    Parameters {
        /// The names; empty for all.
        names: Vec<String>,
    },
    /// Sets a parameter, in the unit of the control's list.
    SetParameter {
        /// Its name.
        name: String,
        /// Its value; none is as delivered.
        value: Option<f64>,
    },
    /// Sets the relative coordinate of an axis.
    Relative {
        /// The axis.
        axis: char,
        /// To what.
        to: RelativeTo,
    },
    /// Forgets the handwheel interruption of an axis.
    ClearInterruption {
        /// The axis; none is all.
        #[serde(default)]
        axis: Option<char>,
    },
    /// Sets a counter: `parts`, `all-parts`, `run-time`, `cutting-time`, `power-on-time`.
    SetCounter {
        /// Its name.
        counter: String,
        /// Its value, pieces or s.
        value: f64,
    },

    /// Takes the rights of a level (1 to 4).
    LogIn {
        /// The level.
        level: u8,
        /// Its password.
        password: String,
    },
    /// Gives the rights back: level 5.
    LogOut,
    /// Sets the password of a level.
    SetPassword {
        /// The level.
        level: u8,
        /// The new password.
        password: String,
    },

    /// The alarm history, newest first.
    AlarmHistory {
        /// How many at most.
        most: u32,
    },
    /// Empties the alarm history.
    ClearAlarmHistory,
    /// The operation log, newest first.
    OperationLog {
        /// How many at most.
        most: u32,
    },
    /// Empties the operation log.
    ClearOperationLog,

    /// Reads signals by name or address: `KEY_START`, `F0.5`, `G12`.
    Signals {
        /// The names.
        names: Vec<String>,
    },
    /// The ladder that runs, as a list.
    Ladder,
    /// Has the powered flow of the ladder recorded, or no longer.
    WatchLadder {
        /// Whether.
        on: bool,
    },
    /// The powered flow of the ladder as of its last scan.
    LadderFlow,
    /// Forces a signal, in the right of maintenance (level 2).
    Force {
        /// Its name or address.
        signal: String,
        /// On or off; none releases it.
        value: Option<bool>,
    },
    /// Puts another ladder in the place of the running one (level 2).
    ExchangeLadder {
        /// Its text.
        text: String,
    },
    /// Puts the ladder of before the last exchange back (level 2).
    RollBackLadder,
    /// Starts a ladder that stands still.
    StartLadder,

    /// Begins to record quantities at the servo period.
    Capture {
        /// Names: `commanded.X`, `actual.X`, `velocity`, `spindle`, a signal.
        quantities: Vec<String>,
        /// Time that is recorded, s.
        seconds: f64,
    },
    /// What was recorded, as CSV.
    Captured,

    /// Writes a backup of items to a file in the folder of the memory.
    Backup {
        /// Its bare name, which ends in `.backup`.
        file: String,
        /// Names of the items; empty for all.
        items: Vec<String>,
    },
    /// Takes items of a backup in the folder of the memory.
    Restore {
        /// Its bare name.
        file: String,
        /// Names of the items.
        items: Vec<String>,
    },

    /// The status.
    Status,
    /// Version of this interface, the control and its machine.
    Version,
}

fn once() -> u32 {
    1
}

/// Values of a tool offset, mm.
#[derive(Clone, Copy, PartialEq, Debug, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct OffsetValues {
    /// Length, H.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub length: Option<f64>,
    /// Wear of the length.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub length_wear: Option<f64>,
    /// Radius, D (a diameter where the control's parameter says so).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub radius: Option<f64>,
    /// Wear of the radius.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub radius_wear: Option<f64>,
}

/// What a relative coordinate is set to.
#[derive(Clone, Copy, PartialEq, Debug, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum RelativeTo {
    /// Zero.
    Zero,
    /// Half of what it is: the middle between the place where it was zero and this one.
    Half,
    /// A value, mm or degrees.
    Value(f64),
}

/// What a command comes to.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
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
    },
    /// A program's text, decoded.
    Program {
        /// Its name.
        program: String,
        /// Its text.
        text: String,
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
    /// Macro variables that are not empty.
    Variables {
        /// By number.
        variables: BTreeMap<u32, f64>,
    },
    /// Parameters.
    Parameters {
        /// By name.
        parameters: BTreeMap<String, f64>,
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
    /// Text: a ladder, a recording.
    Text {
        /// The text.
        text: String,
    },
    /// The powered flow of the ladder, by instruction.
    LadderFlow {
        /// Whether power flows behind each instruction.
        power: Vec<bool>,
    },
    /// The status.
    Status(Box<Status>),
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
    },
}

/// A command that was refused, and why.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct Refusal {
    /// Why.
    pub alarm: AlarmInfo,
}

/// An alarm or warning. Catalogues have its text by its number and values.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
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

/// What happens, as it happens.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[serde(tag = "event", rename_all = "snake_case")]
pub enum Event {
    /// Something worth knowing, or that stands until reset.
    Alarm {
        /// What.
        alarm: AlarmInfo,
    },
    /// No alarm stands any more.
    AlarmsCleared,
    /// A key was pressed that does nothing now, and why.
    Refused {
        /// Why.
        alarm: AlarmInfo,
    },
    /// Text of the program for the operator.
    Message {
        /// The text.
        text: String,
    },
    /// A message of the machine comes or goes.
    MachineMessage {
        /// Its name in the ladder.
        name: String,
        /// Whether it comes.
        on: bool,
    },
    /// Another mode is in force.
    Mode {
        /// Which.
        mode: Mode,
    },
    /// A program was selected.
    Selected {
        /// Its name.
        program: String,
    },
    /// The control does something else.
    Activity {
        /// What.
        activity: Activity,
    },
    /// A part is done.
    Part {
        /// Parts since the count was set.
        parts: u64,
    },
    /// A tool was put into the spindle.
    ToolChange {
        /// Its number.
        tool: u32,
    },
    /// Data were changed.
    Changed {
        /// What kind: the name of an item of the memory.
        item: String,
    },
    /// Somebody has other rights.
    Level {
        /// 1 to 5.
        level: u8,
    },
}

/// What the control does.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Activity {
    /// Nothing; no program is under way.
    Idle,
    /// A program runs.
    Running,
    /// Feed hold.
    Held,
    /// The program has stopped at the end of a block.
    BlockEnd,
    /// The program has stopped by M00 or M01.
    Stopped,
    /// Axes come back from manual intervention.
    Returning,
    /// Axes are moved by hand.
    ByHand,
    /// Reset is under way.
    Resetting,
    /// An alarm stands.
    Alarm,
    /// The emergency stop is pressed.
    Emergency,
}

/// How things stand.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct Status {
    /// Periods since the start.
    pub periods: u64,
    /// The mode.
    pub mode: Mode,
    /// The mode of the program that is under way.
    pub program_mode: Option<Mode>,
    /// What the control does.
    pub activity: Activity,
    /// Whether the program runs to the end of its block to stop there.
    pub finishing_block: bool,
    /// Alarms that stand.
    pub alarms: Vec<AlarmInfo>,
    /// Where things are.
    pub position: Positions,
    /// Speeds and overrides.
    pub feed: FeedStatus,
    /// The spindle.
    pub spindle: SpindleStatus,
    /// The program.
    pub program: ProgramStatus,
    /// Switches in force.
    pub switches: SwitchStatus,
    /// Counters and times.
    pub counters: Counters,
    /// Axes whose reference is established.
    pub referenced: Vec<char>,
    /// Lamps of the panel and of the tower that are lit, by the ladder's names.
    pub lamps: Vec<String>,
    /// Positions of the panel's switches, by the ladder's names.
    pub panel: BTreeMap<String, u8>,
    /// The rights of who asks, 1 to 5; else the highest that anyone has logged in with.
    pub level: u8,
}

/// Positions, mm and degrees.
#[derive(Clone, PartialEq, Debug, Default, Serialize, Deserialize)]
pub struct Positions {
    /// Commanded machine position.
    pub machine: ByAxis,
    /// Where the axes are.
    pub actual: ByAxis,
    /// In the work coordinate system.
    pub work: ByAxis,
    /// Relative coordinates.
    pub relative: ByAxis,
    /// To the end of the move being run.
    pub to_go: ByAxis,
    /// Handwheel interruption.
    pub interruption: ByAxis,
    /// The work coordinate system: `G54`; none after G92.
    pub system: Option<String>,
}

/// Speeds along the path, mm/min, and overrides, factors.
#[derive(Clone, PartialEq, Debug, Default, Serialize, Deserialize)]
pub struct FeedStatus {
    /// What is run now.
    pub actual: f64,
    /// The F word in force.
    pub programmed: f64,
    /// Feed override.
    pub feed_override: f64,
    /// Rapid override.
    pub rapid_override: f64,
    /// Override of jog.
    pub manual_override: f64,
}

/// The spindle, r/min.
#[derive(Clone, PartialEq, Debug, Default, Serialize, Deserialize)]
pub struct SpindleStatus {
    /// The S word in force.
    pub programmed: f64,
    /// What it is told, without its sense.
    pub told: f64,
    /// Spindle override, a factor.
    pub spindle_override: f64,
    /// The tool in it.
    pub tool: u32,
    /// The tool that was called last.
    pub called_tool: u32,
}

/// The program.
#[derive(Clone, PartialEq, Debug, Default, Serialize, Deserialize)]
pub struct ProgramStatus {
    /// The program that AUTO runs.
    pub selected: Option<String>,
    /// The line where cycle start begins.
    pub cursor: u32,
    /// The file of the block being run.
    pub running: Option<String>,
    /// Its line, from 1; 0 for none.
    pub line: u32,
    /// Its text.
    pub block: String,
    /// G codes in force.
    pub g_codes: Vec<String>,
    /// H and D in force.
    pub h: u16,
    /// D in force.
    pub d: f64,
}

/// Switches in force.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
pub struct SwitchStatus {
    /// Single block.
    pub single_block: bool,
    /// Block skip.
    pub block_skip: bool,
    /// Optional stop.
    pub optional_stop: bool,
    /// Dry run.
    pub dry_run: bool,
    /// Machine lock.
    pub machine_lock: bool,
    /// Auxiliary lock.
    pub auxiliary_lock: bool,
}

/// Counters and times.
#[derive(Clone, Copy, PartialEq, Debug, Default, Serialize, Deserialize)]
pub struct Counters {
    /// Parts.
    pub parts: u64,
    /// Parts since the machine was built.
    pub all_parts: u64,
    /// Time in which programs ran, s.
    pub run_time: f64,
    /// Time in which metal was cut, s.
    pub cutting_time: f64,
    /// Time for which power was on, s.
    pub power_on_time: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commands_are_objects_named_by_do() {
        for (command, json) in [
            (Command::Reset, r#"{"do":"reset"}"#),
            (
                Command::Key { key: "KEY_START".into(), down: true },
                r#"{"do":"key","key":"KEY_START","down":true}"#,
            ),
            (
                Command::SetOffset {
                    number: 3,
                    values: OffsetValues { length: Some(-100.5), ..OffsetValues::default() },
                    add: false,
                },
                r#"{"do":"set_offset","number":3,"length":-100.5,"add":false}"#,
            ),
            (
                Command::Relative { axis: 'X', to: RelativeTo::Value(20.0) },
                r#"{"do":"relative","axis":"X","to":{"value":20.0}}"#,
            ),
            (
                Command::SetZero { system: "G54".into(), axes: ByAxis::from([('X', 1.5)]), add: false },
                r#"{"do":"set_zero","system":"G54","axes":{"X":1.5},"add":false}"#,
            ),
        ] {
            assert_eq!(serde_json::to_string(&command).unwrap(), json);
            assert_eq!(serde_json::from_str::<Command>(json).unwrap(), command);
        }
        let short = r#"{"do":"set_zero","system":"G54","axes":{}}"#;
        assert!(matches!(serde_json::from_str(short).unwrap(), Command::SetZero { add: false, .. }));
        for bad in ["{}", r#"{"do":"dance"}"#, r#"{"do":"key","key":"KEY_START"}"#, "7", "[]"] {
            assert!(serde_json::from_str::<Command>(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn events_and_replies_are_objects_named_by_event_and_reply() {
        let event = Event::Mode { mode: Mode::Mdi };
        assert_eq!(serde_json::to_string(&event).unwrap(), r#"{"event":"mode","mode":"mdi"}"#);
        assert_eq!(serde_json::to_string(&Reply::Done).unwrap(), r#"{"reply":"done"}"#);
        let level = Reply::Level { level: 5 };
        assert_eq!(serde_json::to_string(&level).unwrap(), r#"{"reply":"level","level":5}"#);
    }
}
