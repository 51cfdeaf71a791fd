//! What a front asks for.

use super::ByAxis;
use serde::de::{Error as _, Unexpected};
use serde::{Deserialize, Deserializer, Serialize};
use std::collections::BTreeMap;

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
