//! What a front (panel, socket, test) says to the control and hears of it: one type of commands, one of answers, one
//! of events, and the status. `docs/api.md` has them for those who write fronts.
//!
//! As JSON a command is an object whose field `do` names it, an answer one with `reply`, an event one with `event`.
//! Lengths are mm, angles degrees, feeds mm/min, speeds r/min, times s, overrides factors, unless a field says
//! otherwise. Axes are called by their letters. Numbers of a control's own tables (parameters) are in the control's
//! own units.

use crate::signals::Mode;
use ferrocut_machine::{Alarm, Argument, Severity};
use serde::de::{Error as _, Unexpected};
use serde::{Deserialize, Deserializer, Serialize};
use std::collections::BTreeMap;

/// Version of this interface. It counts up when a field changes its meaning or goes; new fields may come without.
pub const API_VERSION: u32 = 1;

/// Values by the letters of axes.
pub type ByAxis = BTreeMap<char, f64>;

/// Values by number. A command is told by its field `do`, which may come last: until then all of it is kept as JSON has
/// it, numbers that name fields as text.
fn by_number<'de, D: Deserializer<'de>>(deserializer: D) -> Result<BTreeMap<u16, f64>, D::Error> {
    let named = BTreeMap::<String, f64>::deserialize(deserializer)?;
    let number = |(name, value): (String, f64)| match name.parse() {
        Ok(number) => Ok((number, value)),
        Err(_) => Err(D::Error::invalid_value(Unexpected::Str(&name), &"a whole number up to 65535")),
    };
    named.into_iter().map(number).collect()
}

/// What a front wants.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
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
        /// Counts; clockwise positive. Those that wait are 1000 at most, ten turns.
        counts: i32,
    },
    /// Axes that are moved by hand come to rest: steps and counts of the handwheel that are left are lost.
    StopByHand,
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
    /// Deletes all programs but those that are locked for who asks.
    DeleteAll,
    /// Gives a program another name.
    Rename {
        /// Its name.
        program: String,
        /// Its new name, which no other has. An O number at its start follows.
        to: String,
    },
    /// Locks a program against those of lower rights, or unlocks it.
    Lock {
        /// Its name.
        program: String,
        /// Whether it is locked.
        locked: bool,
    },
    /// The axes of a program that is held go back along its path, as far as it is known, until feed hold; with cycle
    /// start they go forward again, and the program goes on where it was held.
    Retrace,
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
    /// Reads the text of the MDI page, and the block that runs before it.
    MdiText,
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
    /// Prepares the restart of a program, in AUTO. It is searched beside the machine: the event `restart` tells that it
    /// is ready, `refused` that it cannot be. The next cycle start carries it out.
    Restart {
        /// The line, from 1; the block that was interrupted where it is missing.
        #[serde(default)]
        line: Option<u32>,
        /// Which time that the line is reached, from 1.
        #[serde(default = "once")]
        pass: u32,
        /// The file of the line: a program that the one selected calls; itself where it is missing.
        #[serde(default)]
        file: Option<String>,
        /// Whether the control sends T, M and S itself; else the operator does so in MDI before.
        #[serde(default)]
        sends: bool,
        /// Whether each axis waits for cycle start; it does with single block too.
        #[serde(default)]
        axis_by_axis: bool,
    },
    /// What can be taken up again, and the restart that is prepared.
    Restarts,
    /// Forgets the restart that is prepared or being searched.
    CancelRestart,

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
        /// Whether they are what is typed behind the letter of the axis instead, on the page of the zeros (GSK990MC part 2,
        /// 3.4.2): added to the machine coordinate, or taken off it (10#5).
        #[serde(default)]
        typed: bool,
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
    /// Turns the parameter switch, in MDI. While it is on an alarm stands (GSK990MC part 2, 3.4.1).
    ParameterSwitch {
        /// On: parameters may be changed by hand.
        on: bool,
    },
    /// The alarm of the parameter switch goes, and the switch stays on.
    AcceptParameterSwitch,
    /// Reads the reference points.
    ReferencePoints,
    /// The places where axes stand at rest are their reference points from now on, in MDI and the right of
    /// commissioning (level 3), where a parameter allows it (GSK990MC 20#7).
    SetMachineZero {
        /// The axes.
        axes: Vec<char>,
    },
    /// Sets a reference point on some axes, in MDI and the right of commissioning (level 3).
    SetReferencePoint {
        /// Its number, 1 to 4.
        number: u8,
        /// Machine positions, mm and degrees.
        axes: ByAxis,
    },
    /// Reads the table of pitch errors of an axis.
    Pitch {
        /// The axis.
        axis: char,
    },
    /// Sets points of the table of pitch errors of an axis, in MDI and the right of commissioning (level 3). They hold
    /// from the next start on.
    SetPitch {
        /// The axis.
        axis: char,
        /// What is added to the commanded position, mm, by number of the point.
        #[serde(deserialize_with = "by_number")]
        points: BTreeMap<u16, f64>,
    },
    /// Sets the relative coordinate of an axis.
    Relative {
        /// The axis.
        axis: char,
        /// To what.
        to: RelativeTo,
    },
    /// Sets S, as the page of positions does: the modal speed of the spindle, told to it at once. Not while a program is
    /// under way.
    SpindleSpeed {
        /// r/min; while G96 is in force the surface speed, mm/min or inch/min.
        speed: f64,
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
    /// The signals of an area that have a name, with what they mean.
    SignalTable {
        /// Letter of the area: X, Y, F, G, A, K, T, C, D, R.
        area: char,
        /// Tag of the language of the meanings; English where it is missing.
        #[serde(default)]
        language: Option<String>,
    },
    /// The ladder that runs, as a list.
    Ladder,
    /// Has the powered flow of the ladder recorded all the time, or no longer.
    WatchLadder {
        /// Whether.
        on: bool,
    },
    /// The powered flow of the ladder as of its last scan. It is recorded for a second after each such request; the
    /// first one finds nothing yet.
    LadderFlow,
    /// Begins to trace signals of the ladder, sampled at each scan, in place of the trace before.
    Trace {
        /// Names or addresses of bits, up to 32.
        signals: Vec<String>,
        /// Samples that are kept, up to 100,000.
        #[serde(default = "many_samples")]
        samples: u32,
        /// What sets off the end; without it the last samples are kept.
        #[serde(default)]
        trigger: Option<TraceTrigger>,
        /// Samples behind the trigger; half of all where it is missing.
        #[serde(default)]
        behind: Option<u32>,
        /// Whether only samples that differ from the one before are kept.
        #[serde(default)]
        changes_only: bool,
    },
    /// What was traced, in as many parts as asked for.
    Traced {
        /// The first sample, from 0.
        #[serde(default)]
        from: u32,
        /// How many samples at most.
        #[serde(default = "many_rows")]
        most: u32,
    },
    /// Ends the trace and forgets it.
    EndTrace,
    /// Forces a signal, in the right of maintenance (level 2).
    Force {
        /// Its name or address.
        signal: String,
        /// On or off; none releases it.
        value: Option<bool>,
    },
    /// The signals that are forced.
    Forced,
    /// Sets data of the ladder, K, T, C or D (level 2). They are kept, and the operation log has it.
    SetSignal {
        /// Its name or address.
        signal: String,
        /// A bit, or a number with or without sign.
        value: i64,
        /// Bytes of the number, the lowest first; where it is missing 2 in T and C, 1 in K and D.
        #[serde(default)]
        bytes: Option<u8>,
    },
    /// Looks at a ladder, which is run nowhere: all of its faults, or its list and its size.
    CheckLadder {
        /// Its text: a list, or PLCopen XML (TC6) with ladder diagrams.
        text: String,
    },
    /// Puts another ladder in the place of the running one (level 2).
    ExchangeLadder {
        /// Its text: a list, or PLCopen XML (TC6) with ladder diagrams, which becomes one.
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
        /// Periods from one sample to the next, from 1.
        #[serde(default = "once")]
        every: u32,
        /// What sets off the end; without it the recording begins at once.
        #[serde(default)]
        trigger: Option<CaptureTrigger>,
        /// Time before the trigger that is kept, s.
        #[serde(default)]
        before: f64,
    },
    /// What was recorded, as CSV, in as many parts as asked for.
    Captured {
        /// The first row, from 0.
        #[serde(default)]
        from: u32,
        /// How many rows at most.
        #[serde(default = "many_rows")]
        most: u32,
    },
    /// Ends a recording; what was recorded stays.
    EndCapture,

    /// Takes the place where the axes stand as a point to measure by hand.
    TouchPoint {
        /// Its number, 1 to 8.
        number: u8,
    },
    /// The points that were taken.
    Points,
    /// Forgets the points.
    ClearPoints,
    /// The centre of the points, by hand: to a work zero where one is named.
    Centre {
        /// `true`: a circle through three points or more; else a rectangle: points 1 and 2 on walls across X, 3 and 4
        /// on walls across Y.
        circle: bool,
        /// The work coordinate system: `G54`.
        #[serde(default)]
        system: Option<String>,
        /// Coordinates of the centre there; 0 where they are missing.
        #[serde(default)]
        values: ByAxis,
    },
    /// Prepares the measuring of a work zero by the probe, in AUTO; cycle start does it.
    Measure(Box<MeasureWork>),
    /// Prepares the measuring of a tool, in AUTO; cycle start does it.
    MeasureTool(Box<MeasureTool>),
    /// Forgets the measuring that is prepared.
    CancelMeasure,
    /// What was measured last.
    Measured,

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
    /// How long periods and scans of the ladder took at worst, since power-on or since they were forgotten.
    Timing {
        /// They are taken anew from here.
        #[serde(default)]
        forget: bool,
    },
    /// Version of this interface, the control and its machine.
    Version,
}

fn once() -> u32 {
    1
}

fn many_rows() -> u32 {
    1000
}

fn many_samples() -> u32 {
    10_000
}

/// What sets off the end of a trace.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct TraceTrigger {
    /// Its name or address.
    pub signal: String,
    /// What it does.
    pub edge: TraceEdge,
}

/// What a signal does.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum TraceEdge {
    /// It turns on.
    Rising,
    /// It turns off.
    Falling,
    /// Either.
    Change,
}

/// What sets off the end of a recording.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct CaptureTrigger {
    /// One of the quantities that are recorded.
    pub quantity: String,
    /// The value that it passes.
    pub level: f64,
    /// From below; else from above.
    pub rises: bool,
}

/// A form that a probe measures. Sizes are mm, angles degrees from X+ to Y+.
#[derive(Clone, Copy, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(tag = "form", rename_all = "snake_case")]
pub enum MeasureForm {
    /// A hole, from its rough centre.
    Hole {
        /// Nominal diameter.
        diameter: f64,
    },
    /// A boss.
    Boss {
        /// Nominal diameter.
        diameter: f64,
    },
    /// A slot: the axes of which a width is given.
    Slot {
        /// Nominal width along X.
        #[serde(default)]
        lx: Option<f64>,
        /// Nominal width along Y.
        #[serde(default)]
        ly: Option<f64>,
    },
    /// A web or block.
    Web {
        /// Nominal width along X.
        #[serde(default)]
        lx: Option<f64>,
        /// Nominal width along Y.
        #[serde(default)]
        ly: Option<f64>,
    },
    /// A hole touched at three angles.
    VectorHole {
        /// Nominal diameter.
        diameter: f64,
        /// The angles, each 5 or more from the others.
        angles: [f64; 3],
    },
    /// A boss touched at three angles.
    VectorBoss {
        /// Nominal diameter.
        diameter: f64,
        /// The angles, each 5 or more from the others.
        angles: [f64; 3],
    },
    /// A slot that lies at an angle.
    VectorSlot {
        /// Nominal width.
        width: f64,
        /// The direction across it.
        angle: f64,
    },
    /// A web that lies at an angle.
    VectorWeb {
        /// Nominal width.
        width: f64,
        /// The direction across it.
        angle: f64,
    },
    /// One surface.
    Edge {
        /// The axis along which it is touched; Z downwards alone.
        axis: char,
        /// In its positive direction.
        #[serde(default)]
        positive: bool,
        /// How far it is searched, mm.
        distance: f64,
    },
}

/// Measuring of a work zero by a probe (GSK990MC part 2, 3.4.3.1). Places are coordinates of the work system in force.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct MeasureWork {
    /// The form.
    #[serde(flatten)]
    pub form: MeasureForm,
    /// Rough centre, for an edge where its search begins; where the probe stands where it is missing.
    #[serde(default)]
    pub x: Option<f64>,
    /// Rough centre, for an edge where its search begins; where the probe stands where it is missing.
    #[serde(default)]
    pub y: Option<f64>,
    /// The height at which is touched; where the probe stands where it is missing. Needed from outside.
    #[serde(default)]
    pub z: Option<f64>,
    /// The work coordinate system that gets the zero: `G54`; none measures alone.
    #[serde(default)]
    pub system: Option<String>,
    /// Coordinates that the place found has there; 0 where they are missing.
    #[serde(default)]
    pub values: ByAxis,
    /// Number of the length offset of the probe, for a surface across Z.
    #[serde(default)]
    pub h: Option<u16>,
    /// Most by which a size may be beside its nominal one, mm.
    #[serde(default)]
    pub tolerance: Option<f64>,
    /// From a surface to where the probe goes down, mm: 8.
    #[serde(default)]
    pub clearance: Option<f64>,
    /// How far is searched behind the nominal surface, mm: 10.
    #[serde(default)]
    pub overtravel: Option<f64>,
    /// Diameter of the probe's ball, mm: P391.
    #[serde(default)]
    pub probe: Option<f64>,
    /// How fast.
    #[serde(default)]
    pub pace: MeasurePace,
}

/// Speeds of measuring, mm/min, and how far the probe backs off, mm. Those missing are 1500, 300, 60 and 1.
#[derive(Clone, Copy, PartialEq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(default)]
pub struct MeasurePace {
    /// Moves between touches, on which a touch is an alarm.
    pub way: Option<f64>,
    /// The search.
    pub search: Option<f64>,
    /// The touch that counts.
    pub fine: Option<f64>,
    /// Back from the search.
    pub back_off: Option<f64>,
}

/// What of a tool is measured.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum ToolMode {
    /// Its length.
    Length,
    /// Its diameter.
    Diameter,
    /// Both.
    Both,
    /// The setter's place, by a tool of known length that stands over its middle.
    CalibrateLength,
    /// The setter's diameter, by a tool of known diameter.
    CalibrateDiameter,
}

/// Measuring of a tool (GSK990MC part 2, 3.4.3.2).
#[derive(Clone, Copy, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct MeasureTool {
    /// What.
    pub mode: ToolMode,
    /// Number of the offset that gets the length; 0 stores nothing.
    #[serde(default)]
    pub h: u16,
    /// Number of the offset that gets the radius (a diameter where the control's parameter says so); 0 stores nothing.
    #[serde(default)]
    pub d: u16,
    /// Estimated length, mm; that of the offset H where it is missing.
    #[serde(default)]
    pub length: Option<f64>,
    /// Estimated diameter, mm; that of the offset D where it is missing.
    #[serde(default)]
    pub diameter: Option<f64>,
    /// How far below the top of the setter its side is touched, mm: 5.
    #[serde(default)]
    pub depth: Option<f64>,
    /// From where and how far behind the estimate is searched, mm: 4; to calibrate a length 50.
    #[serde(default)]
    pub overtravel: Option<f64>,
    /// Most by which a size may be beside the estimate, mm: a tool that broke.
    #[serde(default)]
    pub tolerance: Option<f64>,
    /// Number of an offset that is in no other use: its length becomes 1 where the tool broke, and 0 where it did not.
    #[serde(default)]
    pub mark: Option<u16>,
    /// By how much the radius that is stored is smaller than the one that was measured, mm: 0.
    #[serde(default)]
    pub adjust: Option<f64>,
    /// Diameter of the setter, mm: P391.
    #[serde(default)]
    pub stylus: Option<f64>,
    /// Speed of the spindle while a diameter is measured, r/min, clockwise positive: against the sense of cutting. It
    /// stands where it is missing.
    #[serde(default)]
    pub rpm: Option<f64>,
    /// How fast.
    #[serde(default)]
    pub pace: MeasurePace,
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

/// Values of a tool offset, mm and degrees.
#[derive(Clone, Copy, PartialEq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
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
    /// Length of the cutting edge, at least 0; 0 where it is not known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cutting_length: Option<f64>,
    /// Steepest angle at which it may enter the material, 0 to 90; 0 where it is not known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub entry_angle: Option<f64>,
    /// Radius of the rounded tip, at least 0: 0 for a flat tool, that of the tool for a ball.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tip_radius: Option<f64>,
}

/// What a relative coordinate is set to.
#[derive(Clone, Copy, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
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

/// What happens, as it happens.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
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
        /// What kind: the name of an item of the memory, `forced`, `backups` or `mdi`.
        item: String,
    },
    /// Somebody has other rights.
    Level {
        /// 1 to 5.
        level: u8,
    },
    /// A restart is ready for cycle start, or no longer.
    Restart {
        /// Whether it is ready.
        ready: bool,
        /// The line of its block, from 1.
        line: u32,
    },
    /// Something was measured.
    Measured {
        /// What.
        measured: Measurement,
    },
    /// A run was broken off: it can be taken up again.
    Interrupted {
        /// The program.
        program: String,
        /// The line of the block, from 1.
        line: u32,
    },
}

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commands_are_objects_named_by_do() {
        for (command, json) in [
            (Command::Reset, r#"{"do":"reset"}"#),
            (Command::StopByHand, r#"{"do":"stop_by_hand"}"#),
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
            (Command::SpindleSpeed { speed: 1200.0 }, r#"{"do":"spindle_speed","speed":1200.0}"#),
            (
                Command::SetZero { system: "G54".into(), axes: ByAxis::from([('X', 1.5)]), add: false },
                r#"{"do":"set_zero","system":"G54","axes":{"X":1.5},"add":false}"#,
            ),
            (
                Command::SetPitch { axis: 'Y', points: BTreeMap::from([(2, 0.0035)]) },
                r#"{"do":"set_pitch","axis":"Y","points":{"2":0.0035}}"#,
            ),
        ] {
            assert_eq!(serde_json::to_string(&command).unwrap(), json);
            assert_eq!(serde_json::from_str::<Command>(json).unwrap(), command);
        }
        let short = r#"{"do":"set_zero","system":"G54","axes":{}}"#;
        assert!(matches!(serde_json::from_str(short).unwrap(), Command::SetZero { add: false, .. }));
        for bad in [
            "{}",
            r#"{"do":"dance"}"#,
            r#"{"do":"key","key":"KEY_START"}"#,
            "7",
            "[]",
            r#"{"do":"set_pitch","axis":"Y","points":{"-2":0.1}}"#,
        ] {
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

    /// The variants of an enum of this file with the names of their fields.
    fn variants(name: &str) -> Vec<(&'static str, Vec<&'static str>)> {
        let source = include_str!("api.rs");
        let (_, body) = source.split_once(&format!("pub enum {name} {{")).unwrap();
        let is_name = |text: &str| text.bytes().all(|b| b.is_ascii_lowercase() || b == b'_');
        let mut all: Vec<(&str, Vec<&str>)> = Vec::new();
        for line in body.split_once("\n}\n").unwrap().0.lines() {
            if let Some((field, _)) = line.strip_prefix("        ").and_then(|line| line.split_once(": ")) {
                if is_name(field) {
                    all.last_mut().unwrap().1.push(field);
                }
            } else if let Some(variant) = line.strip_prefix("    ")
                && variant.starts_with(|c: char| c.is_ascii_uppercase())
            {
                all.push((variant.trim_end_matches([' ', '{', ',']), Vec::new()));
            }
        }
        all
    }

    const DOCUMENT: &str = include_str!("../../../docs/api.md");

    #[test]
    fn every_field_of_a_command_is_in_the_document() {
        let fields: Vec<&str> = variants("Command").into_iter().flat_map(|(_, fields)| fields).collect();
        for field in fields.iter().filter(|field| **field != "values") {
            assert!(DOCUMENT.contains(&format!("`{field}`")), "docs/api.md lacks {field}");
        }
        assert!(fields.len() > 80, "{fields:?}");
    }

    #[test]
    fn every_event_is_in_the_document_with_its_fields() {
        let section = DOCUMENT.split_once("## Events").unwrap().1.split("\n## ").next().unwrap();
        let events = variants("Event");
        for (event, fields) in &events {
            // As serde writes it.
            let mut name = String::new();
            for c in event.chars() {
                if c.is_ascii_uppercase() && !name.is_empty() {
                    name.push('_');
                }
                name.push(c.to_ascii_lowercase());
            }
            let row = section.lines().find(|line| line.starts_with(&format!("| `{name}` |")));
            let row = row.unwrap_or_else(|| panic!("docs/api.md lacks the event {name}"));
            let told: Vec<String> = fields.iter().map(|field| format!("`{field}`")).collect();
            assert_eq!(row.split('|').nth(2).unwrap().trim(), told.join(", "), "{name}");
        }
        assert!(events.len() > 10, "{events:?}");
    }
}
