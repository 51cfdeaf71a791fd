//! The seam between the neutral interpreter and a control language.
//!
//! A [`Dialect`] is tables: what its codes mean and in which modal group they are, what its addresses
//! may hold, which number its manual gives an alarm. [`Rules`] are the numbers and choices that its
//! parameters set. Code that two languages share stands outside their folders and reads these.

use crate::Fallible;
use crate::coordinates;
use crate::cycles::described::{DescribedCycle, DescribedFigure};
use crate::cycles::zone::FigureFormat;
use crate::cycles::{self, CycleKind, Pattern};
use crate::directives::Directive;
use crate::evaluate::{Arithmetic, Value};
use crate::interpreter::Interpreter;
use crate::modal::{Group, Modal};
use crate::motion;
use crate::stages::cutter;
use crate::stages::polar::PoleRule;
use crate::stroke::StrokeRules;
use ferrocut_geometry::{Axis, AxisSet, Plane};
use ferrocut_machine::restart::RestartConfig;
use ferrocut_machine::{AlarmId, Fault, Machine, ParameterKey, Parameters, WorkOffset};
use ferrocut_program::{Block, Page, Syntax};
use ferrocut_toolpath::CornerRule;

/// What a G code means, in terms common to all controls.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Meaning {
    /// Positioning.
    Rapid,
    /// Straight cut.
    Linear,
    /// Clockwise arc.
    ArcClockwise,
    /// Counter-clockwise arc.
    ArcCounterClockwise,
    /// Pause.
    Dwell,
    /// Working plane.
    Plane(Plane),
    /// Inch input.
    Inch,
    /// Metric input.
    Metric,
    /// Cutter compensation off.
    CutterOff,
    /// Cutter compensation, tool left of the path.
    CutterLeft,
    /// Cutter compensation, tool right of the path.
    CutterRight,
    /// Arc about a corner in cutter compensation.
    CornerArc,
    /// Polar coordinates off.
    PolarOff,
    /// Polar coordinates on.
    PolarOn,
    /// Scaling off.
    ScalingOff,
    /// Scaling on.
    ScalingOn,
    /// Rotation off.
    RotationOff,
    /// Rotation on.
    RotationOn,
    /// Exact stop at the end of every cutting move.
    ExactStop,
    /// Override of inner corners.
    CornerOverride,
    /// Tapping mode: override and hold without effect.
    TappingMode,
    /// Cutting mode: moves run into each other.
    CuttingMode,
    /// S is a surface speed.
    SurfaceSpeed,
    /// S is a spindle speed.
    SpindleSpeed,
    /// Reference point check.
    ReferenceCheck,
    /// Return to the first reference point.
    ReferenceReturn,
    /// Return from a reference point.
    ReturnFromReference,
    /// Return to a further reference point.
    FurtherReferenceReturn,
    /// Straight cut until the skip signal.
    Skip,
    /// Positioning always from one side.
    OneWay,
    /// Stored stroke check 2 on.
    StrokeCheckOn,
    /// Stored stroke check 2 off.
    StrokeCheckOff,
    /// Data set by the program.
    DataSetting,
    /// End of it.
    DataSettingOff,
    /// Tool length added.
    LengthPlus,
    /// Tool length subtracted.
    LengthMinus,
    /// Tool length compensation off.
    LengthOff,
    /// Move in machine coordinates.
    MachinePosition,
    /// Work coordinate system; with P an additional one where the control has such.
    WorkOffset(u8),
    /// Canned cycle off.
    CycleOff,
    /// Canned cycle.
    Cycle(CycleKind),
    /// Absolute coordinates.
    Absolute,
    /// Incremental coordinates.
    Incremental,
    /// Zero of the work coordinate systems moved.
    LocalZero,
    /// Coordinate system set so that the tool stands at the given point.
    SetPosition,
    /// The same for one work coordinate system alone, and lasting.
    SetPositionOfOne,
    /// The same for all of them, until the program ends.
    SetPositionForNow,
    /// Zero of a work coordinate system, by its machine position.
    SetWorkZero,
    /// Length of a tool.
    SetToolLength,
    /// Mirror on.
    MirrorOn,
    /// Mirror off.
    MirrorOff,
    /// Subprogram call by a G code.
    Call,
    /// A row, circle or grid of the holes of the cycle in force.
    Pattern(Pattern),
    /// The cycle in force on the points of a figure, whose words stand behind the code.
    Figure(&'static FigureFormat),
    /// The axes of the plane and of the tool, by the numbers of their words.
    ChooseAxes,
    /// Homing of the axes named.
    HomeSearch,
    /// Origin of polar words.
    PolarOrigin,
    /// A corner of a profile is rounded.
    ProfileRound,
    /// It is cut off.
    ProfileChamfer,
    /// A profile is entered on an arc.
    ProfileEntry,
    /// It is left on one.
    ProfileExit,
    /// Axes move until inputs come.
    MoveUntilInput,
    /// The control waits for motion, and for an input.
    WaitForInput,
    /// The move runs at 100 %, whatever the feed override.
    FullFeed,
    /// A rotary axis goes the shorter way round.
    ShortestWay,
    /// A rotary axis is programmed in degrees.
    InDegrees,
    /// Without effect on what this system does.
    NoEffect,
    /// Of encoders that latch their counts at a signal (Weihong G916 to G919).
    EncoderLatch,
    /// A feed word is the inverse of the minutes that a move takes.
    InverseTime,
    /// Feed per minute.
    FeedPerMinute,
    /// Feed per revolution.
    FeedPerRevolution,
    /// Cycles return to the initial level.
    ReturnInitial,
    /// Cycles return to the R level.
    ReturnR,
    /// A code that the manual names without saying what it does: an alarm.
    Undescribed,
    /// Cubic spline by two directions.
    CubicSpline,
    /// Quadratic spline by one point.
    QuadraticSpline,
    /// A rational spline begins, or goes on.
    Nurbs,
    /// It ends, and is run.
    NurbsEnd,
    /// Working plane of U, V, W.
    PlaneOfUvw(Plane),
    /// The present position becomes a reference point.
    SaveReference,
    /// Straight cut in step with the spindle.
    Synchronised,
    /// Tapping in step with the spindle, there and back.
    RigidTap,
    /// Straight probe.
    Probe {
        /// Until contact is lost.
        away: bool,
        /// Without its signal it is an alarm.
        needs_contact: bool,
    },
    /// Threading of many passes.
    Threading,
    /// A cycle of lathes.
    LatheCycle,
    /// Cutter compensation left of the path, D is the diameter.
    CutterLeftOf,
    /// Cutter compensation right of the path, D is the diameter.
    CutterRightOf,
    /// Tool length given by the words of the block.
    LengthOf,
    /// A further tool length on top of those in force.
    LengthMore,
    /// Moves go through their points exactly.
    ExactPath,
    /// Centres of arcs are absolute.
    CentreAbsolute,
    /// Centres of arcs count from the start.
    CentreIncremental,
    /// X words are diameters.
    DiameterMode,
    /// X words are radii.
    RadiusMode,
    /// The shift of all coordinate systems is taken back and forgotten.
    ShiftCleared,
    /// It is taken back and kept.
    ShiftSuspended,
    /// It is put in force again.
    ShiftRestored,
}

/// A row of a dialect's table of G codes.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct GCode {
    /// The number in tenths: G54 is 540, G54.1 is 541.
    pub tenths: u16,
    /// What it means.
    pub meaning: Meaning,
    /// Its modal group.
    pub group: Group,
    /// The number that the manual gives the group.
    pub group_number: u8,
}

/// What the machine does on an M code.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum MFunction {
    /// Program stop.
    Stop,
    /// Program stop where the operator asks for it.
    OptionalStop,
    /// End of program, or return from a subprogram.
    End,
    /// Spindle clockwise.
    SpindleClockwise,
    /// Spindle counter-clockwise.
    SpindleCounterClockwise,
    /// Spindle off.
    SpindleOff,
    /// Tool change.
    ToolChange,
    /// Coolant on.
    CoolantOn,
    /// Coolant off.
    CoolantOff,
    /// Spindle stop at an angle.
    Orient,
    /// Subprogram call.
    Call,
    /// Return from a subprogram; in the main program, to its start.
    Return,
    /// End of program, in a subprogram too.
    ProgramEnd,
    /// Text for the operator.
    Message,
    /// A number for the control itself.
    Internal,
    /// The tool in the spindle gets another number.
    ToolNumber,
    /// Output of the machine set by the program.
    SetOutput,
    /// Reference return done: the axis stands on its reference point.
    ReferenceReached,
    /// The tapping cycles that follow are rigid.
    RigidTapping,
    /// They are not.
    RigidTappingOff,
    /// Handed to the machine.
    Machine,
}

/// A row of a dialect's table of M codes.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct MCode {
    /// The number.
    pub code: u16,
    /// What it does.
    pub function: MFunction,
    /// Whether it waits for the end of the block's motion.
    pub after_motion: bool,
    /// Whether it must be the only such M code in its block.
    pub controls_program: bool,
}

/// What an address may hold.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Address {
    /// The letter in upper case.
    pub letter: u8,
    /// Smallest value.
    pub min: f64,
    /// Largest value.
    pub max: f64,
    /// Whether the value must be whole.
    pub whole: bool,
    /// What is wrong with a value beyond the largest.
    pub beyond: Fault,
}

/// What a variable of the macro language stands for. Axes are counted from 0 in the control's order.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Variable {
    /// Always empty.
    Empty,
    /// Holds what is put into it.
    Plain,
    /// Tool length of an offset number.
    ToolLength(u16),
    /// Its wear.
    LengthWear(u16),
    /// Tool radius of an offset number, as entered.
    ToolRadius(u16),
    /// Its wear.
    RadiusWear(u16),
    /// Setting it raises an alarm.
    Alarm,
    /// The code in force of the group with this number.
    ModalGroup(u8),
    /// The word in force of an address.
    ModalWord(u8),
    /// End point of the block before, as programmed.
    BlockEnd(u8),
    /// Machine position.
    MachinePosition(u8),
    /// Position in the work coordinate system, tool length included.
    WorkPosition(u8),
    /// The same of the tip of the tool: what a move there would be programmed with.
    TipPosition(u8),
    /// Where the skip signal came, in the work coordinate system.
    SkipPosition(u8),
    /// Tool length compensation in force.
    LengthOffset(u8),
    /// Following error.
    ServoOffset(u8),
    /// Zero of a work coordinate system.
    WorkZero(WorkOffset, u8),
    /// An input of the machine.
    Input(u16),
    /// Sixteen inputs together, the lowest first.
    InputWord,
    /// An output to the machine.
    Output(u16),
    /// All inputs, a bit each.
    Inputs,
    /// All outputs that programs set, a bit each.
    Outputs,
    /// The parameter with a name, by its place in the control's list.
    Parameter(u16),
    /// A parameter of the canned cycle in force, by its letter.
    CycleParameter(u8),
    /// A table that the machine's builder fills.
    UserTable,
}

/// Numbers and choices that the control's parameters set, in millimetres, minutes and degrees.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Rules {
    /// Feed in force at power-on, mm/min; 0 is none.
    pub default_feed: f64,
    /// Lowest feed per minute that is run, whatever the override; smaller ones are raised to it.
    pub min_feed: f64,
    /// Highest feed per minute that is run, whatever the override.
    pub max_feed: f64,
    /// Highest feed per revolution, mm; beyond it is an alarm.
    pub max_feed_per_revolution: f64,
    /// Spindle speed at which S words are held, r/min.
    pub max_spindle_rpm: f64,
    /// S is the number of a gear, in its last two digits, and no speed.
    pub speed_is_gear: bool,
    /// G00 runs along a straight line.
    pub rapid_is_straight: bool,
    /// Feed of a helix is along its circle.
    pub helix_feed_along_circle: bool,
    /// Largest difference of an arc's start and end radius, mm.
    pub arc_tolerance: f64,
    /// Address of a dwell in seconds.
    pub dwell_letter: u8,
    /// Whether P decides where both stand in a block.
    pub dwell_p_decides: bool,
    /// Seconds that P1 of a dwell stands for.
    pub dwell_p_unit_s: f64,
    /// Dwell counts spindle turns in feed per revolution.
    pub dwell_in_revolutions: bool,
    /// Tool length acts on the axis square to the plane; else always on Z.
    pub length_on_plane_normal: bool,
    /// H00 alone waits for its axis to move; else the offset is taken off at once.
    pub h00_waits: bool,
    /// Codes, in tenths, that may not stand in a block with tool length, and the alarms of it.
    pub length_not_with: &'static [(u16, Fault)],
    /// An address twice in a block, or two codes of one group, is an alarm; else the last counts.
    pub repeats_are_alarms: bool,
    /// I, J and K may stand ten times behind G65: Fanuc's second way of arguments.
    pub arguments_in_sets: bool,
    /// G90 and G91 in one block are an alarm.
    pub distance_is_exclusive: bool,
    /// N beside G10, or among the parameters that it sets, is the number of one and none of the block.
    pub data_has_number: bool,
    /// An expression may stand behind N; else it is a plain number.
    pub sequence_takes_expression: bool,
    /// M codes allowed in a block.
    pub m_codes_in_block: u8,
    /// Levels of subprograms.
    pub max_call_depth: usize,
    /// Levels of macro calls.
    pub max_macro_depth: usize,
    /// Most repeats of a call.
    pub max_repeats: f64,
    /// Counts of calls and cycles may be any number: a fraction goes for nothing, and less than one call is none.
    pub counts_take_any_number: bool,
    /// Canned cycles.
    pub cycles: cycles::Rules,
    /// Moves.
    pub motion: motion::Rules,
    /// Coordinate systems and transformations.
    pub coordinates: coordinates::Rules,
    /// Cutter compensation.
    pub cutter: cutter::Rules,
    /// Radius offsets are entered as diameters.
    pub radius_is_diameter: bool,
    /// Override of inner corners, where it is in use: which of them, and the lowest feed in mm/min.
    pub corner_override: Option<(CornerRule, f64)>,
    /// Stored stroke checks.
    pub stroke: StrokeRules,
    /// Largest coordinate that a program may name, mm or degrees.
    pub max_coordinate: f64,
    /// Axes that may move together in a block.
    pub max_moving_axes: usize,
    /// The spindle can stop at an angle.
    pub spindle_has_position: bool,
    /// Feed per revolution is fitted.
    pub feed_per_revolution: bool,
    /// Largest tool number.
    pub max_tool: f64,
    /// Largest S word.
    pub max_speed_word: f64,
    /// Largest M code.
    pub max_m_code: f64,
    /// T chooses the offsets of its number too, for G41 to G44 without D and H.
    pub tool_chooses_offsets: bool,
    /// The spindle stops with the program.
    pub end_stops_spindle: bool,
    /// Machine position of X, Y, Z that the control takes the tool to after each program.
    pub fixed_point: Option<[f64; 3]>,
    /// S beside the code of orientation is the angle, degrees; else it is the speed as ever.
    pub orients_to_speed_word: bool,
    /// Arcs about corners are fitted (G39).
    pub corner_arc: bool,
    /// Scaling.
    pub scaling: ScalingRules,
    /// Angle of a rotation that gives none, degrees.
    pub rotation_angle: f64,
    /// With G91 the angle of a rotation is added to the last one.
    pub rotation_follows_g91: bool,
    /// Largest angle that a rotation may be given, degrees.
    pub max_rotation: f64,
    /// What sets the pole of polar coordinates.
    pub pole: PoleRule,
    /// Codes of reference points and coordinate systems, and arcs by their centre, are alarms while polar
    /// coordinates are in force. With rotation and scaling those codes always are.
    pub polar_is_strict: bool,
    /// Changes of units, data setting, skip moves and optional blocks are alarms while points are
    /// transformed.
    pub transforms_are_strict: bool,
    /// A code of units stands in a block of its own; codes of other modal groups beside it have no unit and are let pass.
    pub units_stand_alone: bool,
    /// Overshoot of one-way positioning by axis, mm, with the sign of the direction of arrival.
    pub one_way_overshoot: [f64; 5],
    /// Pause of one-way positioning, s.
    pub one_way_dwell_s: f64,
    /// One-way positioning is modal.
    pub one_way_is_modal: bool,
    /// A skip move that ends without its signal is an alarm.
    pub skip_needs_signal: bool,
    /// Surface speed is fitted.
    pub surface_speed: bool,
    /// Lowest spindle speed under it, r/min.
    pub surface_min_rpm: f64,
    /// Axis that it is reckoned by where the program names none.
    pub surface_axis: Axis,
    /// Largest tool offset, mm.
    pub max_offset: f64,
    /// Largest wear of one, mm.
    pub max_wear: f64,
    /// Largest coordinate of a work zero, mm or degrees.
    pub max_zero: f64,
    /// The way to the intermediate point of a reference point is cutter-compensated; else compensation is
    /// left aside from there on.
    pub reference_keeps_cutter: bool,
    /// D names an offset of the tool in the spindle, in force from M6 on without another code; else a number
    /// of the table.
    pub tools_carry_offsets: bool,
    /// Functions that act in their block alone stand before a point and a cycle, which are made after them.
    pub functions_before_point: bool,
    /// A choice of plane ends canned cycles; else it is an alarm while one is in force.
    pub plane_ends_cycle: bool,
    /// With single block, macro statements are blocks of their own; else the program runs through them.
    pub single_in_macros: bool,
    /// Axes that the control carries.
    pub axes: AxisSet,
    /// Those of them that are linear.
    pub linear_axes: AxisSet,
    /// The same in the order that variables and parameters count them by.
    pub axis_order: [Axis; 5],
}

/// A language that bounds nothing and has nothing fitted beyond what all have. What a control does otherwise
/// stands in its `rules`.
impl Default for Rules {
    fn default() -> Rules {
        Rules {
            default_feed: 0.0,
            min_feed: 0.0,
            max_feed: f64::INFINITY,
            max_feed_per_revolution: f64::INFINITY,
            max_spindle_rpm: f64::INFINITY,
            speed_is_gear: false,
            rapid_is_straight: true,
            helix_feed_along_circle: false,
            arc_tolerance: 0.01,
            dwell_letter: b'X',
            dwell_p_decides: false,
            dwell_p_unit_s: 1.0,
            dwell_in_revolutions: false,
            length_on_plane_normal: true,
            h00_waits: false,
            length_not_with: &[],
            repeats_are_alarms: false,
            arguments_in_sets: false,
            distance_is_exclusive: true,
            data_has_number: false,
            sequence_takes_expression: false,
            m_codes_in_block: u8::MAX,
            single_in_macros: false,
            max_call_depth: 0,
            max_macro_depth: 0,
            max_repeats: 0.0,
            counts_take_any_number: false,
            cycles: cycles::Rules::default(),
            motion: motion::Rules::default(),
            coordinates: coordinates::Rules::default(),
            cutter: cutter::Rules::default(),
            radius_is_diameter: false,
            corner_override: None,
            stroke: StrokeRules::default(),
            max_coordinate: 1e8,
            max_moving_axes: 9,
            spindle_has_position: true,
            feed_per_revolution: true,
            max_tool: 9999.0,
            max_speed_word: f64::INFINITY,
            max_m_code: 9999.0,
            tool_chooses_offsets: false,
            end_stops_spindle: true,
            fixed_point: None,
            orients_to_speed_word: false,
            corner_arc: false,
            scaling: ScalingRules::default(),
            rotation_angle: 0.0,
            rotation_follows_g91: false,
            max_rotation: f64::INFINITY,
            pole: PoleRule::Code,
            polar_is_strict: false,
            transforms_are_strict: false,
            units_stand_alone: false,
            one_way_overshoot: [0.0; 5],
            one_way_dwell_s: 0.0,
            one_way_is_modal: false,
            surface_speed: false,
            surface_min_rpm: 0.0,
            surface_axis: Axis::X,
            max_offset: 99_999_999.0,
            max_wear: 99_999_999.0,
            skip_needs_signal: false,
            max_zero: 99_999_999.0,
            reference_keeps_cutter: false,
            tools_carry_offsets: false,
            functions_before_point: false,
            plane_ends_cycle: false,
            axes: Axis::ALL.into_iter().collect(),
            linear_axes: Axis::ALL.into_iter().filter(|axis| axis.is_linear()).collect(),
            axis_order: [Axis::X, Axis::Y, Axis::Z, Axis::A, Axis::B],
        }
    }
}

/// Numbers of the programs that take the place of codes: Mn is run by program `m` + n, Gn by `g` + n, and
/// an S word runs `speed`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct CustomPrograms {
    /// That of M00.
    pub m: u32,
    /// That of G00.
    pub g: u32,
    /// How many M codes, and how many G codes.
    pub count: u32,
    /// The program of S words, which is of no code.
    pub speed: u32,
    /// What the words of the block are for that program: the variable of each address, G98 or G99, G90 or
    /// G91, and the initial level.
    pub arguments: &'static [(u8, u32)],
    /// Variable that is 1 with G99.
    pub returns_to_r: u32,
    /// Variable that is 1 with G91.
    pub incremental: u32,
    /// Variable of the initial level of a cycle.
    pub initial: u32,
}

/// What a reset or emergency stop clears.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ResetRules {
    /// Modal groups that go back to their power-on code: bit n for the group that the manual numbers n.
    pub groups: u32,
    /// F, H and D.
    pub feed_and_offsets: bool,
    /// Local variables.
    pub locals: bool,
    /// Common variables that power-off clears too.
    pub commons: bool,
}

/// What the parameters set for scaling.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ScalingRules {
    /// Scaling is fitted.
    pub enabled: bool,
    /// I, J, K give the factors of the axes; else P gives one for all.
    pub factors_by_axis: bool,
    /// Factor where P is not given.
    pub factor: f64,
    /// Factors where I, J, K are not given.
    pub axis_factors: [f64; 3],
    /// Whether each of X, Y, Z is scaled.
    pub axes: [bool; 3],
}

/// Not fitted.
impl Default for ScalingRules {
    fn default() -> ScalingRules {
        ScalingRules {
            enabled: false,
            factors_by_axis: false,
            factor: 1.0,
            axis_factors: [1.0; 3],
            axes: [false; 3],
        }
    }
}

/// Runs one block of a page, by its index.
pub type RunBlock = fn(&mut Interpreter, &Page, &Block, usize) -> Fallible<()>;

/// A control language.
#[derive(Debug)]
pub struct Dialect {
    /// Its name on the command line and in alarm numbers.
    pub name: &'static str,
    /// Extensions that its files alone have, in lower case.
    pub extensions: &'static [&'static str],
    /// How its programs are written.
    pub syntax: &'static Syntax,
    /// Its arithmetic.
    pub arithmetic: Arithmetic,
    /// Its G codes, in rising order.
    pub g_codes: &'static [GCode],
    /// Its M codes, in rising order.
    pub m_codes: &'static [MCode],
    /// What any other M code does, by its number; none beyond the end.
    pub other_m_codes: &'static [MCode],
    /// The code that ends canned cycles.
    pub cycle_off: &'static GCode,
    /// The code that ends tool length compensation.
    pub length_off: &'static GCode,
    /// One-way positioning as a motion code, where it is modal.
    pub one_way_modal: &'static GCode,
    /// Whether a parameter cannot be set by the program.
    pub is_fixed_parameter: fn(&ParameterKey) -> bool,
    /// Whether a parameter is a work zero, which no program sets while coordinates are turned or scaled.
    pub is_work_zero: fn(&ParameterKey) -> bool,
    /// Whether parameters are changed by hand only while the parameter switch is on.
    pub parameter_switch: bool,
    /// The code that calls a macro with variables of its own, in tenths.
    pub macro_call: u16,
    /// What a variable holds that was never set.
    pub unset_variable: Value,
    /// Programs that stand for codes, where the control has such.
    pub custom: Option<CustomPrograms>,
    /// Directives by their first name.
    pub directives: &'static [(&'static str, Directive)],
    /// Cycles that directives describe.
    pub described_cycles: &'static [DescribedCycle],
    /// Figures on which they are repeated.
    pub described_figures: &'static [DescribedFigure],
    /// Runs a block, where the language has an order of its own.
    pub blocks: Option<RunBlock>,
    /// What a variable stands for; `None` for one that does not exist.
    pub variable: fn(u32) -> Option<Variable>,
    /// The local variable that an address of a macro call sets.
    pub argument: fn(letter: u8) -> Option<u32>,
    /// The addresses that a block may hold.
    pub addresses: &'static [Address],
    /// The numbers that its manual gives faults.
    pub alarms: &'static [(Fault, u16)],
    /// Numbers of faults that have one for each axis, counted from 0, and some for each side of it.
    pub axis_alarm: fn(fault: Fault, axis: usize, upper: bool) -> Option<u16>,
    /// Writes what the parameters say of the drives over what the machine file says.
    pub machine_parameters: fn(&Parameters, &mut Machine),
    /// Alarm `n` of the program is this number and `n`; `None` where such alarms have no number.
    pub program_alarms: Option<u16>,
    /// Reads the rules that the parameters set.
    pub rules: fn(&Parameters) -> Rules,
    /// Modal state at power-on.
    pub power_on: fn(&Parameters) -> Modal,
    /// What a reset clears.
    pub reset: fn(&Parameters) -> ResetRules,
    /// Work coordinate system at power-on.
    pub power_on_work_offset: WorkOffset,
}

impl Dialect {
    /// The row of a G code.
    pub fn g_code(&self, tenths: u16) -> Option<&'static GCode> {
        let at = self.g_codes.binary_search_by_key(&tenths, |g| g.tenths).ok()?;
        self.g_codes.get(at)
    }

    /// The code of a working plane.
    pub fn plane_code(&self, plane: Plane) -> Option<&'static GCode> {
        self.g_codes.iter().find(|g| g.meaning == Meaning::Plane(plane))
    }

    /// The row of an M code.
    pub fn m_code(&self, code: u16) -> Option<&'static MCode> {
        match self.m_codes.binary_search_by_key(&code, |m| m.code) {
            Ok(at) => self.m_codes.get(at),
            Err(_) => self.other_m_codes.get(usize::from(code)),
        }
    }

    /// The row of an address.
    pub fn address(&self, letter: u8) -> Option<&'static Address> {
        self.addresses.iter().find(|a| a.letter == letter)
    }

    /// The number that the manual gives a fault.
    pub fn alarm_number(&self, fault: Fault) -> Option<u16> {
        self.alarms.iter().find(|(f, _)| *f == fault).map(|(_, number)| *number)
    }

    /// The alarm of a fault: the manual's number where it has one.
    pub fn alarm_id(&self, fault: Fault) -> AlarmId {
        self.numbered(self.alarm_number(fault), fault)
    }

    /// The alarm of the software limit of axis `index`, on its lower or upper side.
    pub fn soft_limit_id(&self, index: usize, upper: bool) -> AlarmId {
        self.axis_alarm_id(Fault::SoftLimit, index, upper)
    }

    /// Whether a machine that was built with the parameters `before` would be another one with those of `now`: these hold
    /// from the next power-on. Found by building it, so that a parameter counts where it makes a difference.
    pub fn builds_another(&self, machine: &Machine, before: &Parameters, now: &Parameters) -> bool {
        self.built(machine, before) != self.built(machine, now)
    }

    /// The machine that the parameters make of what the file says, as far as it is made at power-on.
    fn built(&self, machine: &Machine, parameters: &Parameters) -> Machine {
        let mut built = machine.clone();
        (self.machine_parameters)(parameters, &mut built);
        // Read anew for each restart, and feeds are held by what their parameters are now.
        built.restart = RestartConfig::default();
        (built.path.lowest_feed, built.path.highest_feed) = (0.0, None);
        built
    }

    /// Those of `among` that say nothing of the machine as long as nobody has set them, since its file does: set to the value
    /// that they have they would make another one of it.
    pub fn left_to_file(
        &self,
        machine: &Machine,
        parameters: &Parameters,
        among: impl Iterator<Item = ParameterKey>,
    ) -> Vec<ParameterKey> {
        let built = self.built(machine, parameters);
        let is_left = |key: &ParameterKey| {
            let mut set = parameters.clone();
            !parameters.is_given(key)
                && set.set(key, parameters.get(key)).is_ok()
                && self.built(machine, &set) != built
        };
        among.filter(is_left).collect()
    }

    /// The alarm of a fault of axis `index`, where it has sides on its lower or upper one.
    pub fn axis_alarm_id(&self, fault: Fault, index: usize, upper: bool) -> AlarmId {
        self.numbered((self.axis_alarm)(fault, index, upper).or(self.alarm_number(fault)), fault)
    }

    fn numbered(&self, number: Option<u16>, fault: Fault) -> AlarmId {
        number.map_or(AlarmId::Core(fault), |number| AlarmId::Dialect(self.name, number))
    }
}

/// A table row: G code in units of 0.1.
pub(crate) const fn g(tenths: u16, meaning: Meaning, group: Group, group_number: u8) -> GCode {
    GCode { tenths, meaning, group, group_number }
}
