//! How things stand.

use super::{AlarmInfo, ByAxis, InterruptedBlock};
use crate::signals::Mode;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// What the control does.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
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

/// How far a program of DNC has come.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct DncStatus {
    /// Bytes of its text, in UTF-8, that the control took.
    pub taken: u64,
    /// The last 64 of them or fewer, by which who sends it knows the place again.
    pub tail: String,
    /// Whether more of it is awaited: it has no end yet, and was not given up.
    pub awaited: bool,
}

/// How things stand.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
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
    /// The run that was broken off, which can be taken up again.
    #[serde(default)]
    pub interrupted: Option<InterruptedBlock>,
    /// Whether cycle start carries out a restart.
    #[serde(default)]
    pub restart_ready: bool,
    /// Whether cycle start measures.
    #[serde(default)]
    pub measure_ready: bool,
    /// How far the program of DNC has come: who sends it goes on from there.
    #[serde(default)]
    pub dnc: Option<DncStatus>,
    /// Messages of the ladder that stand, by its names.
    #[serde(default)]
    pub messages: Vec<String>,
    /// What the program said last to the operator; empty once nothing runs any more.
    #[serde(default)]
    pub program_message: String,
    /// Lamps of the panel and of the tower that are lit, by the ladder's names.
    pub lamps: Vec<String>,
    /// Positions of the panel's switches, by the ladder's names.
    pub panel: BTreeMap<String, u8>,
    /// The rights of who asks, 1 to 5. A status that nobody asked for has none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub level: Option<u8>,
}

/// Positions, mm and degrees.
#[derive(Clone, PartialEq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Positions {
    /// Commanded machine position.
    pub machine: ByAxis,
    /// Where the axes are.
    pub actual: ByAxis,
    /// In the work coordinate system: the tip of the tool, as programs have it.
    pub work: ByAxis,
    /// What pages show of it: with the tool length on top where a parameter says so (GSK990MC 22#6).
    #[serde(default)]
    pub absolute: ByAxis,
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
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct FeedStatus {
    /// What is run now.
    pub actual: f64,
    /// The same by axis, with its sense (GSK990MC part 2, 3.1.1).
    #[serde(default)]
    pub components: ByAxis,
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
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct SpindleStatus {
    /// The S word in force: r/min, under G96 the surface speed in mm/min or inch/min.
    pub programmed: f64,
    /// What it is told, without its sense.
    pub told: f64,
    /// What it has, clockwise positive: of its encoder, or as its drive is known to run up where it has none.
    #[serde(default)]
    pub actual: f64,
    /// Spindle override, a factor.
    pub spindle_override: f64,
    /// The tool in it.
    pub tool: u32,
    /// The tool that was called last.
    pub called_tool: u32,
}

/// The program.
#[derive(Clone, PartialEq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
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
    /// The block behind the one being run for which the machine does something, across jumps and calls; none where the
    /// program was not read that far.
    #[serde(default)]
    pub next: Option<NextBlock>,
    /// Where the program stops once.
    #[serde(default)]
    pub stop_at: Option<StopAt>,
    /// The axes are behind the place where the program was held: cycle start brings them there again first.
    #[serde(default)]
    pub retraced: bool,
}

/// A block that is to come.
#[derive(Clone, PartialEq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct NextBlock {
    /// Its file.
    pub file: String,
    /// Its line, from 1.
    pub line: u32,
    /// Its text.
    pub text: String,
}

/// A block behind which a program stops once (GSK990MC part 2, 3.4.1).
#[derive(Clone, PartialEq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct StopAt {
    /// The program.
    pub program: Option<String>,
    /// Its sequence number.
    pub sequence: u32,
}

/// Switches in force.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
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
    /// The parameter switch: parameters may be changed by hand. None on a control without one.
    #[serde(default)]
    pub parameters: Option<bool>,
    /// The program switch: programs may be edited. None on a control without one.
    #[serde(default)]
    pub programs: Option<bool>,
}

/// Counters and times.
#[derive(Clone, Copy, PartialEq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
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
