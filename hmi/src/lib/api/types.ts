// Commands, answers, events and status of the control (docs/api.md).
// Written from crates/controller/src/api by `FERROCUT_WRITE=1 cargo test -p ferrocut-server --test types`.

/** Values by the letters of axes. */
export type ByAxis = { [axis: string]: number };

/**
 * The mode of the control (GSK990MC part 2, 1.2.4).
 */
export type Mode = "edit" | "auto" | "mdi" | "home" | "jog" | "step" | "handle" | "dnc";

/**
 * What the control does.
 */
export type Activity = "idle" | "running" | "held" | "block_end" | "stopped" | "returning" | "by_hand" | "resetting" | "alarm" | "emergency";

/**
 * What a relative coordinate is set to.
 */
export type RelativeTo = "zero" | "half" | { "value": number };

/**
 * Values of a tool offset, mm and degrees.
 */
export type OffsetValues = {
/**
 * Length, H.
 */
length?: number,
/**
 * Wear of the length.
 */
length_wear?: number,
/**
 * Radius, D (a diameter where the control's parameter says so).
 */
radius?: number,
/**
 * Wear of the radius.
 */
radius_wear?: number,
/**
 * Length of the cutting edge, at least 0; 0 where it is not known.
 */
cutting_length?: number,
/**
 * Steepest angle at which it may enter the material, 0 to 90; 0 where it is not known.
 */
entry_angle?: number,
/**
 * Radius of the rounded tip, at least 0: 0 for a flat tool, that of the tool for a ball.
 */
tip_radius?: number, };

/**
 * An alarm or warning. Catalogues have its text by its number and values.
 */
export type AlarmInfo = {
/**
 * Its number: `gsk990mc:0045`, `FC-0302`.
 */
id: string,
/**
 * The line of the program that it is about, from 1; 0 for none.
 */
line: number,
/**
 * Whether it only warns.
 */
warning: boolean,
/**
 * The values that its text names.
 */
values: { [key in string]: string }, };

/**
 * A command that was refused, and why.
 */
export type Refusal = {
/**
 * Why.
 */
alarm: AlarmInfo, };

/**
 * A program of the list.
 */
export type ProgramInfo = {
/**
 * Its name.
 */
name: string,
/**
 * Length, bytes.
 */
bytes: number,
/**
 * Its comment.
 */
comment: string,
/**
 * When it was changed, ms since 1970 (UTC); 0 where nobody knows.
 */
changed: number,
/**
 * The level that locked it.
 */
locked: number | null, };

/**
 * An alarm of the history.
 */
export type PastAlarm = {
/**
 * When, ms since 1970 (UTC).
 */
time: number,
/**
 * Its number.
 */
id: string,
/**
 * The program that ran.
 */
program: string,
/**
 * Its line, from 1; 0 for none.
 */
line: number,
/**
 * The values that its text names.
 */
values: { [key in string]: string }, };

/**
 * An entry of the operation log.
 */
export type LogLine = {
/**
 * When, ms since 1970 (UTC).
 */
time: number,
/**
 * With which level; none where no person did it.
 */
level: number | null,
/**
 * Who.
 */
who: string,
/**
 * What kind of thing.
 */
item: string,
/**
 * What of it.
 */
name: string,
/**
 * What it was.
 */
from: string,
/**
 * What it became.
 */
to: string, };

/**
 * A signal that is forced: nothing writes it until it is released.
 */
export type ForcedSignal = {
/**
 * Its address: `Y0003.2`.
 */
address: string,
/**
 * What the ladder calls it; empty where it has no name.
 */
name: string,
/**
 * To what.
 */
value: boolean, };

/**
 * A signal that the NC or the ladder has a name for.
 */
export type NamedSignal = {
/**
 * Its name.
 */
name: string,
/**
 * Its address, `F7.0`; of a number, that of its first byte.
 */
address: string,
/**
 * What it means.
 */
meaning: string,
/**
 * What it is: a bit 0 or 1, a number without sign.
 */
value: number, };

/**
 * A block that is to come.
 */
export type NextBlock = {
/**
 * Its file.
 */
file: string,
/**
 * Its line, from 1.
 */
line: number,
/**
 * Its text.
 */
text: string, };

/**
 * A block behind which a program stops once (GSK990MC part 2, 3.4.1).
 */
export type StopAt = {
/**
 * The program.
 */
program: string | null,
/**
 * Its sequence number.
 */
sequence: number, };

/**
 * Positions, mm and degrees.
 */
export type Positions = {
/**
 * Commanded machine position.
 */
machine: { [key in string]: number },
/**
 * Where the axes are.
 */
actual: { [key in string]: number },
/**
 * In the work coordinate system: the tip of the tool, as programs have it.
 */
work: { [key in string]: number },
/**
 * What pages show of it: with the tool length on top where a parameter says so (GSK990MC 22#6).
 */
absolute: { [key in string]: number },
/**
 * Relative coordinates.
 */
relative: { [key in string]: number },
/**
 * To the end of the move being run.
 */
to_go: { [key in string]: number },
/**
 * Handwheel interruption.
 */
interruption: { [key in string]: number },
/**
 * The work coordinate system: `G54`; none after G92.
 */
system: string | null, };

/**
 * Speeds along the path, mm/min, and overrides, factors.
 */
export type FeedStatus = {
/**
 * What is run now.
 */
actual: number,
/**
 * The same by axis, with its sense (GSK990MC part 2, 3.1.1).
 */
components: { [key in string]: number },
/**
 * The F word in force.
 */
programmed: number,
/**
 * Feed override.
 */
feed_override: number,
/**
 * Rapid override.
 */
rapid_override: number,
/**
 * Override of jog.
 */
manual_override: number, };

/**
 * The spindle, r/min.
 */
export type SpindleStatus = {
/**
 * The S word in force: r/min, under G96 the surface speed in mm/min or inch/min.
 */
programmed: number,
/**
 * What it is told, without its sense.
 */
told: number,
/**
 * What it has, clockwise positive: of its encoder, or as its drive is known to run up where it has none.
 */
actual: number,
/**
 * Spindle override, a factor.
 */
spindle_override: number,
/**
 * The tool in it.
 */
tool: number,
/**
 * The tool that was called last.
 */
called_tool: number, };

/**
 * The program.
 */
export type ProgramStatus = {
/**
 * The program that AUTO runs.
 */
selected: string | null,
/**
 * The line where cycle start begins.
 */
cursor: number,
/**
 * The file of the block being run.
 */
running: string | null,
/**
 * Its line, from 1; 0 for none.
 */
line: number,
/**
 * Its text.
 */
block: string,
/**
 * G codes in force.
 */
g_codes: Array<string>,
/**
 * H and D in force.
 */
h?: number,
/**
 * D in force.
 */
d?: number,
/**
 * The block behind the one being run for which the machine does something, across jumps and calls; none where the
 * program was not read that far.
 */
next: NextBlock | null,
/**
 * Where the program stops once.
 */
stop_at: StopAt | null,
/**
 * The axes are behind the place where the program was held: cycle start brings them there again first.
 */
retraced: boolean, };

/**
 * Switches in force.
 */
export type SwitchStatus = {
/**
 * Single block.
 */
single_block: boolean,
/**
 * Block skip.
 */
block_skip: boolean,
/**
 * Optional stop.
 */
optional_stop: boolean,
/**
 * Dry run.
 */
dry_run: boolean,
/**
 * Machine lock.
 */
machine_lock: boolean,
/**
 * Auxiliary lock.
 */
auxiliary_lock: boolean,
/**
 * The parameter switch: parameters may be changed by hand. None on a control without one.
 */
parameters: boolean | null,
/**
 * The program switch: programs may be edited. None on a control without one.
 */
programs: boolean | null, };

/**
 * Counters and times.
 */
export type Counters = {
/**
 * Parts.
 */
parts: number,
/**
 * Parts since the machine was built.
 */
all_parts: number,
/**
 * Time in which programs ran, s.
 */
run_time: number,
/**
 * Time in which metal was cut, s.
 */
cutting_time: number,
/**
 * Time for which power was on, s.
 */
power_on_time: number, };

/**
 * How far a program of DNC has come.
 */
export type DncStatus = {
/**
 * Bytes of its text, in UTF-8, that the control took.
 */
taken: number,
/**
 * The last 64 of them or fewer, by which who sends it knows the place again.
 */
tail: string,
/**
 * Whether more of it is awaited: it has no end yet, and was not given up.
 */
awaited: boolean, };

/**
 * How things stand.
 */
export type Status = {
/**
 * Periods since the start.
 */
periods: number,
/**
 * The mode.
 */
mode: Mode,
/**
 * The mode of the program that is under way.
 */
program_mode: Mode | null,
/**
 * What the control does.
 */
activity: Activity,
/**
 * Whether the program runs to the end of its block to stop there.
 */
finishing_block: boolean,
/**
 * Alarms that stand.
 */
alarms: Array<AlarmInfo>,
/**
 * Where things are.
 */
position: Positions,
/**
 * Speeds and overrides.
 */
feed: FeedStatus,
/**
 * The spindle.
 */
spindle: SpindleStatus,
/**
 * The program.
 */
program: ProgramStatus,
/**
 * Switches in force.
 */
switches: SwitchStatus,
/**
 * Counters and times.
 */
counters: Counters,
/**
 * Axes whose reference is established.
 */
referenced: Array<string>,
/**
 * The run that was broken off, which can be taken up again.
 */
interrupted: InterruptedBlock | null,
/**
 * Whether cycle start carries out a restart.
 */
restart_ready: boolean,
/**
 * Whether cycle start measures.
 */
measure_ready: boolean,
/**
 * How far the program of DNC has come: who sends it goes on from there.
 */
dnc: DncStatus | null,
/**
 * Messages of the ladder that stand, by its names.
 */
messages: Array<string>,
/**
 * What the program said last to the operator; empty once nothing runs any more.
 */
program_message: string,
/**
 * Lamps of the panel and of the tower that are lit, by the ladder's names.
 */
lamps: Array<string>,
/**
 * Positions of the panel's switches, by the ladder's names.
 */
panel: { [key in string]: number },
/**
 * The rights of who asks, 1 to 5. A status that nobody asked for has none.
 */
level?: number, };

/**
 * What of a tool is measured.
 */
export type ToolMode = "length" | "diameter" | "both" | "calibrate_length" | "calibrate_diameter";

/**
 * What was measured.
 */
export type Measurement = {
/**
 * Machine positions of the place that was found, by axis, mm.
 */
place: { [key in string]: number },
/**
 * Sizes that were found, mm: a diameter; widths along X and Y; length and diameter of a tool.
 */
sizes: Array<number>,
/**
 * The farthest that a touch lies beside the circle, mm.
 */
out_of_round: number,
/**
 * What it was stored to: `G54`, `H3`, `D3`, parameters.
 */
stored: Array<string>, };

/**
 * The block at which a run was broken off.
 */
export type InterruptedBlock = {
/**
 * The program that was started.
 */
program: string,
/**
 * The file of the block: the program, or one that it called.
 */
file: string,
/**
 * Its line, from 1.
 */
line: number,
/**
 * Its text.
 */
text: string,
/**
 * When, ms since 1970 (UTC).
 */
time: number,
/**
 * Whether the state at the program's start was kept: then a restart goes on with the variables of the run. After
 * power-off it is not.
 */
kept: boolean, };

/**
 * Something that program and machine do not have alike.
 */
export type RestartDifference = {
/**
 * What: `G03` (the modal group by the manual's number), `F`, `S`, `spindle`, `flood`, `mist`, `T`, `in_spindle`,
 * `H`, `D`, `zero.X`, `length.Z`.
 */
of: string,
/**
 * What the program has.
 */
program: string | null,
/**
 * What the machine has.
 */
machine: string | null, };

/**
 * A move of one axis.
 */
export type RestartMove = {
/**
 * The axis.
 */
axis: string,
/**
 * Machine position, mm or degrees.
 */
to: number,
/**
 * Whether it positions; else it cuts.
 */
rapid: boolean,
/**
 * mm/min; none is that of positioning.
 */
speed: number | null, };

/**
 * A restart that is ready: what cycle start will do, and what is not yet as the program has it.
 */
export type RestartPlan = {
/**
 * The program.
 */
program: string,
/**
 * The file of the block.
 */
file: string,
/**
 * Its line, from 1.
 */
line: number,
/**
 * The how manieth time it is reached; 0 for the block that was interrupted.
 */
pass?: number,
/**
 * Its text.
 */
text: string,
/**
 * The hole of a canned cycle with which it begins, from 1.
 */
hole: number,
/**
 * What the search started from: `kept` or `present` (docs/restart.md).
 */
origin: string,
/**
 * Where the axes stand when the block begins, machine positions.
 */
position: { [key in string]: number },
/**
 * What program and machine do not have alike now.
 */
differences: Array<RestartDifference>,
/**
 * T, M and S that make the machine as the program has it, in their order.
 */
functions: Array<string>,
/**
 * Whether the control sends them.
 */
sends: boolean,
/**
 * The moves of the axes, in their order, from where they stand now.
 */
approach: Array<RestartMove>,
/**
 * Whether each waits for cycle start.
 */
axis_by_axis: boolean,
/**
 * Differences for which cycle start is refused: tool and spindle, where the control does not send them.
 */
missing: Array<string>,
/**
 * Values of the memory that the search changes: variables that the program writes again.
 */
changes: number,
/**
 * What the search could not know.
 */
warning: AlarmInfo | null, };

/**
 * What a command comes to.
 */
export type Reply = { "reply": "done" } | { "reply": "on_its_way" } | { "reply": "programs",
/**
 * In the order of their names.
 */
programs: Array<ProgramInfo>,
/**
 * How many there can be at most; none where nothing is kept.
 */
most: number | null,
/**
 * Bytes that there is room for yet; none where nothing is kept, or the disk does not tell.
 */
room: number | null, } | { "reply": "program",
/**
 * Its name.
 */
program: string,
/**
 * Its text.
 */
text: string, } | { "reply": "mdi_text",
/**
 * The text of the MDI page.
 */
text: string,
/**
 * The block that runs before it; empty for none.
 */
block: string, } | { "reply": "offsets",
/**
 * By number.
 */
offsets: { [key in number]: OffsetValues }, } | { "reply": "zeros",
/**
 * Machine positions by name and axis.
 */
zeros: { [key in string]: { [key in string]: number } }, } | { "reply": "reference_points",
/**
 * Machine positions by number, 1 to 4.
 */
points: { [key in number]: { [key in string]: number } }, } | { "reply": "pitch",
/**
 * The axis.
 */
axis: string,
/**
 * What is added to the commanded position, mm, by number of the point; points that are not here add nothing.
 */
points: { [key in number]: number }, } | { "reply": "variables",
/**
 * By number.
 */
variables: { [key in number]: number }, } | { "reply": "parameters",
/**
 * By name.
 */
parameters: { [key in string]: number },
/**
 * Those that somebody has set, here, in the machine file or in a program, be it as delivered.
 */
given: Array<string>,
/**
 * Those that say nothing of the machine until somebody sets them: its file does.
 */
left_to_file: Array<string>, } | { "reply": "level",
/**
 * 1 to 5.
 */
level: number, } | { "reply": "alarm_history",
/**
 * Newest first.
 */
alarms: Array<PastAlarm>, } | { "reply": "operation_log",
/**
 * Newest first.
 */
entries: Array<LogLine>, } | { "reply": "signals",
/**
 * By the name that was asked for; bytes and numbers as they are, bits 0 or 1.
 */
signals: { [key in string]: number }, } | { "reply": "signal_table",
/**
 * In the order of their addresses.
 */
signals: Array<NamedSignal>, } | { "reply": "forced",
/**
 * In the order of their addresses.
 */
signals: Array<ForcedSignal>, } | { "reply": "text",
/**
 * The text.
 */
text: string, } | { "reply": "ladder_checked",
/**
 * Its list; none where it has faults.
 */
list: string | null,
/**
 * Its steps; 0 where it has faults.
 */
steps: number,
/**
 * Its first 100 faults, in the order in which they were found: numbers of the control's list of alarms, lines of
 * the text.
 */
faults: Array<AlarmInfo>,
/**
 * How many faults there are.
 */
count: number, } | { "reply": "ladder_flow",
/**
 * Whether power flows behind each instruction.
 */
power: Array<boolean>, } | { "reply": "captured",
/**
 * Whether all samples are there.
 */
done: boolean,
/**
 * When the trigger came, s since the recording began.
 */
triggered: number | null,
/**
 * Samples that are there.
 */
samples: number,
/**
 * Rows as CSV: time in s since the trigger or the beginning, and the quantities; the line of the names stands
 * before row 0. Fewer than asked for at the end, and where the answer would be too long.
 */
csv: string, } | { "reply": "traced",
/**
 * Whether all samples are there.
 */
done: boolean,
/**
 * When the trigger came, s since the ladder started.
 */
triggered: number | null,
/**
 * The signals in the order of the bits, as addresses.
 */
signals: Array<string>,
/**
 * Samples that are there.
 */
samples: number,
/**
 * Samples: time, s since the ladder started, and the signals, bit n for signal n. The oldest is number 0: one
 * that is written over while the trace runs is lost.
 */
rows: Array<[number, number]>, } | { "reply": "points",
/**
 * By number.
 */
points: { [key in number]: { [key in string]: number } }, } | { "reply": "measured",
/**
 * The last.
 */
measured: Measurement | null,
/**
 * Whether cycle start measures.
 */
ready: boolean, } | { "reply": "restarts",
/**
 * The run that was broken off.
 */
interrupted: InterruptedBlock | null,
/**
 * Whether a restart is being searched.
 */
searching: boolean,
/**
 * The restart that is ready for cycle start.
 */
ready: RestartPlan | null, } | { "reply": "status" } & Status | { "reply": "timing",
/**
 * Servo periods since.
 */
periods: number,
/**
 * The servo period, us.
 */
period_us: number,
/**
 * From the beginning of a period to that of the next, us.
 */
worst_period_us: number,
/**
 * What the control did in a period, us.
 */
worst_work_us: number,
/**
 * Level 1 of the ladder, us.
 */
worst_level_1_us: number,
/**
 * What was carried out of level 2 in a period, us.
 */
worst_level_2_us: number,
/**
 * Periods that level 2 took from its beginning to its end.
 */
level_2_periods: number, } | { "reply": "version",
/**
 * Of this interface.
 */
api: number,
/**
 * Of the software.
 */
software: string,
/**
 * The control language.
 */
dialect: string,
/**
 * Name of the machine.
 */
machine: string,
/**
 * Letters of its axes, in its order.
 */
axes: Array<string>,
/**
 * Servo period, ms.
 */
period_ms: number,
/**
 * The clock of the control's computer, ms since 1970 (UTC).
 */
time: number, };

/**
 * What happens, as it happens.
 */
export type Event = { "event": "alarm",
/**
 * What.
 */
alarm: AlarmInfo, } | { "event": "alarms_cleared" } | { "event": "refused",
/**
 * Why.
 */
alarm: AlarmInfo, } | { "event": "message",
/**
 * The text.
 */
text: string, } | { "event": "machine_message",
/**
 * Its name in the ladder.
 */
name: string,
/**
 * Whether it comes.
 */
on: boolean, } | { "event": "mode",
/**
 * Which.
 */
mode: Mode, } | { "event": "selected",
/**
 * Its name.
 */
program: string, } | { "event": "activity",
/**
 * What.
 */
activity: Activity, } | { "event": "part",
/**
 * Parts since the count was set.
 */
parts: number, } | { "event": "tool_change",
/**
 * Its number.
 */
tool: number, } | { "event": "changed",
/**
 * What kind: the name of an item of the memory, `forced`, `backups` or `mdi`.
 */
item: string, } | { "event": "level",
/**
 * 1 to 5.
 */
level: number, } | { "event": "restart",
/**
 * Whether it is ready.
 */
ready: boolean,
/**
 * The line of its block, from 1.
 */
line: number, } | { "event": "measured",
/**
 * What.
 */
measured: Measurement, } | { "event": "interrupted",
/**
 * The program.
 */
program: string,
/**
 * The line of the block, from 1.
 */
line: number, };

/**
 * What a signal does.
 */
export type TraceEdge = "rising" | "falling" | "change";

/**
 * What sets off the end of a trace.
 */
export type TraceTrigger = {
/**
 * Its name or address.
 */
signal: string,
/**
 * What it does.
 */
edge: TraceEdge, };

/**
 * What sets off the end of a recording.
 */
export type CaptureTrigger = {
/**
 * One of the quantities that are recorded.
 */
quantity: string,
/**
 * The value that it passes.
 */
level: number,
/**
 * From below; else from above.
 */
rises: boolean, };

/**
 * A form that a probe measures. Sizes are mm, angles degrees from X+ to Y+.
 */
export type MeasureForm = { "form": "hole",
/**
 * Nominal diameter.
 */
diameter: number, } | { "form": "boss",
/**
 * Nominal diameter.
 */
diameter: number, } | { "form": "slot",
/**
 * Nominal width along X.
 */
lx?: number | null,
/**
 * Nominal width along Y.
 */
ly?: number | null, } | { "form": "web",
/**
 * Nominal width along X.
 */
lx?: number | null,
/**
 * Nominal width along Y.
 */
ly?: number | null, } | { "form": "vector_hole",
/**
 * Nominal diameter.
 */
diameter: number,
/**
 * The angles, each 5 or more from the others.
 */
angles: [number, number, number], } | { "form": "vector_boss",
/**
 * Nominal diameter.
 */
diameter: number,
/**
 * The angles, each 5 or more from the others.
 */
angles: [number, number, number], } | { "form": "vector_slot",
/**
 * Nominal width.
 */
width: number,
/**
 * The direction across it.
 */
angle: number, } | { "form": "vector_web",
/**
 * Nominal width.
 */
width: number,
/**
 * The direction across it.
 */
angle: number, } | { "form": "edge",
/**
 * The axis along which it is touched; Z downwards alone.
 */
axis: string,
/**
 * In its positive direction.
 */
positive?: boolean,
/**
 * How far it is searched, mm.
 */
distance: number, };

/**
 * Speeds of measuring, mm/min, and how far the probe backs off, mm. Those missing are 1500, 300, 60 and 1.
 */
export type MeasurePace = {
/**
 * Moves between touches, on which a touch is an alarm.
 */
way?: number | null,
/**
 * The search.
 */
search?: number | null,
/**
 * The touch that counts.
 */
fine?: number | null,
/**
 * Back from the search.
 */
back_off?: number | null, };

/**
 * Measuring of a work zero by a probe (GSK990MC part 2, 3.4.3.1). Places are coordinates of the work system in force.
 */
export type MeasureWork = {
/**
 * Rough centre, for an edge where its search begins; where the probe stands where it is missing.
 */
x?: number | null,
/**
 * Rough centre, for an edge where its search begins; where the probe stands where it is missing.
 */
y?: number | null,
/**
 * The height at which is touched; where the probe stands where it is missing. Needed from outside.
 */
z?: number | null,
/**
 * The work coordinate system that gets the zero: `G54`; none measures alone.
 */
system?: string | null,
/**
 * Coordinates that the place found has there; 0 where they are missing.
 */
values: { [key in string]: number },
/**
 * Number of the length offset of the probe, for a surface across Z.
 */
h?: number | null,
/**
 * Most by which a size may be beside its nominal one, mm.
 */
tolerance?: number | null,
/**
 * From a surface to where the probe goes down, mm: 8.
 */
clearance?: number | null,
/**
 * How far is searched behind the nominal surface, mm: 10.
 */
overtravel?: number | null,
/**
 * Diameter of the probe's ball, mm: P391.
 */
probe?: number | null,
/**
 * How fast.
 */
pace?: MeasurePace, } & ({ "form": "hole",
/**
 * Nominal diameter.
 */
diameter: number, } | { "form": "boss",
/**
 * Nominal diameter.
 */
diameter: number, } | { "form": "slot",
/**
 * Nominal width along X.
 */
lx?: number | null,
/**
 * Nominal width along Y.
 */
ly?: number | null, } | { "form": "web",
/**
 * Nominal width along X.
 */
lx?: number | null,
/**
 * Nominal width along Y.
 */
ly?: number | null, } | { "form": "vector_hole",
/**
 * Nominal diameter.
 */
diameter: number,
/**
 * The angles, each 5 or more from the others.
 */
angles: [number, number, number], } | { "form": "vector_boss",
/**
 * Nominal diameter.
 */
diameter: number,
/**
 * The angles, each 5 or more from the others.
 */
angles: [number, number, number], } | { "form": "vector_slot",
/**
 * Nominal width.
 */
width: number,
/**
 * The direction across it.
 */
angle: number, } | { "form": "vector_web",
/**
 * Nominal width.
 */
width: number,
/**
 * The direction across it.
 */
angle: number, } | { "form": "edge",
/**
 * The axis along which it is touched; Z downwards alone.
 */
axis: string,
/**
 * In its positive direction.
 */
positive?: boolean,
/**
 * How far it is searched, mm.
 */
distance: number, });

/**
 * Measuring of a tool (GSK990MC part 2, 3.4.3.2).
 */
export type MeasureTool = {
/**
 * What.
 */
mode: ToolMode,
/**
 * Number of the offset that gets the length; 0 stores nothing.
 */
h?: number,
/**
 * Number of the offset that gets the radius (a diameter where the control's parameter says so); 0 stores nothing.
 */
d?: number,
/**
 * Estimated length, mm; that of the offset H where it is missing.
 */
length?: number | null,
/**
 * Estimated diameter, mm; that of the offset D where it is missing.
 */
diameter?: number | null,
/**
 * How far below the top of the setter its side is touched, mm: 5.
 */
depth?: number | null,
/**
 * From where and how far behind the estimate is searched, mm: 4; to calibrate a length 50.
 */
overtravel?: number | null,
/**
 * Most by which a size may be beside the estimate, mm: a tool that broke.
 */
tolerance?: number | null,
/**
 * Number of an offset that is in no other use: its length becomes 1 where the tool broke, and 0 where it did not.
 */
mark?: number | null,
/**
 * By how much the radius that is stored is smaller than the one that was measured, mm: 0.
 */
adjust?: number | null,
/**
 * Diameter of the setter, mm: P391.
 */
stylus?: number | null,
/**
 * Speed of the spindle while a diameter is measured, r/min, clockwise positive: against the sense of cutting. It
 * stands where it is missing.
 */
rpm?: number | null,
/**
 * How fast.
 */
pace?: MeasurePace, };

/**
 * What a front wants.
 */
export type Command = { "do": "key",
/**
 * The ladder's name of its signal, such as `KEY_START`.
 */
key: string,
/**
 * Pressed, or let go.
 */
down: boolean, } | { "do": "switch",
/**
 * The ladder's name of its byte, such as `SWITCH_FEED`.
 */
switch: string,
/**
 * The position, from 0.
 */
position: number, } | { "do": "handwheel",
/**
 * Counts; clockwise positive. Those that wait are 1000 at most, ten turns.
 */
counts: number, } | { "do": "stop_by_hand" } | { "do": "emergency_stop",
/**
 * Pressed, or released.
 */
pressed: boolean, } | { "do": "reset" } | { "do": "programs" } | { "do": "select",
/**
 * Its name: `O1234`.
 */
program: string, } | { "do": "store",
/**
 * Its name.
 */
program: string,
/**
 * Its text.
 */
text: string, } | { "do": "read",
/**
 * Its name.
 */
program: string, } | { "do": "delete",
/**
 * Its name.
 */
program: string, } | { "do": "delete_all" } | { "do": "rename",
/**
 * Its name.
 */
program: string,
/**
 * Its new name, which no other has. An O number at its start follows.
 */
to: string, } | { "do": "lock",
/**
 * Its name.
 */
program: string,
/**
 * Whether it is locked.
 */
locked: boolean, } | { "do": "retrace" } | { "do": "cursor",
/**
 * The line, from 1.
 */
line: number, } | { "do": "mdi",
/**
 * The blocks.
 */
text: string, } | { "do": "mdi_block",
/**
 * The block; empty for none.
 */
block: string, } | { "do": "mdi_text" } | { "do": "dnc",
/**
 * Its text.
 */
text: string,
/**
 * Whether this begins it; else it goes on what came before.
 */
first: boolean,
/**
 * Whether nothing follows.
 */
last: boolean, } | { "do": "stop_at",
/**
 * The program; the one selected where it is missing.
 */
program?: string | null,
/**
 * The sequence number N; none takes the stop back.
 */
sequence?: number | null, } | { "do": "restart",
/**
 * The line, from 1; the block that was interrupted where it is missing.
 */
line?: number | null,
/**
 * Which time that the line is reached, from 1.
 */
pass?: number,
/**
 * The file of the line: a program that the one selected calls; itself where it is missing.
 */
file?: string | null,
/**
 * Whether the control sends T, M and S itself; else the operator does so in MDI before.
 */
sends: boolean,
/**
 * Whether each axis waits for cycle start; it does with single block too.
 */
axis_by_axis: boolean, } | { "do": "restarts" } | { "do": "cancel_restart" } | { "do": "offsets",
/**
 * The first number.
 */
from: number,
/**
 * The last one.
 */
to: number, } | { "do": "set_offset",
/**
 * Its number.
 */
number: number,
/**
 * Whether they are added to what is there.
 */
add?: boolean,
/**
 * Length, H.
 */
length?: number | null,
/**
 * Wear of the length.
 */
length_wear?: number | null,
/**
 * Radius, D (a diameter where the control's parameter says so).
 */
radius?: number | null,
/**
 * Wear of the radius.
 */
radius_wear?: number | null,
/**
 * Length of the cutting edge, at least 0; 0 where it is not known.
 */
cutting_length?: number | null,
/**
 * Steepest angle at which it may enter the material, 0 to 90; 0 where it is not known.
 */
entry_angle?: number | null,
/**
 * Radius of the rounded tip, at least 0: 0 for a flat tool, that of the tool for a ball.
 */
tip_radius?: number | null, } | { "do": "zeros" } | { "do": "set_zero",
/**
 * Its name: `G54`, `G54 P12`, `external`.
 */
system: string,
/**
 * Machine positions, mm and degrees.
 */
axes: { [key in string]: number },
/**
 * Whether they are added to what is there.
 */
add?: boolean, } | { "do": "zero_here",
/**
 * Its name.
 */
system: string,
/**
 * The coordinate of each axis.
 */
axes: { [key in string]: number },
/**
 * Whether they are what is typed behind the letter of the axis instead, on the page of the zeros (GSK990MC part 2,
 * 3.4.2): added to the machine coordinate, or taken off it (10#5).
 */
typed?: boolean, } | { "do": "variables",
/**
 * The first number.
 */
from: number,
/**
 * The last one.
 */
to: number, } | { "do": "set_variable",
/**
 * Its number.
 */
number: number,
/**
 * Its value; none empties it.
 */
value?: number | null, } | { "do": "parameters",
/**
 * The names; empty for all.
 */
names: Array<string>, } | { "do": "set_parameter",
/**
 * Its name.
 */
name: string,
/**
 * Its value; none is as delivered.
 */
value?: number | null, } | { "do": "parameter_switch",
/**
 * On: parameters may be changed by hand.
 */
on: boolean, } | { "do": "accept_parameter_switch" } | { "do": "reference_points" } | { "do": "set_machine_zero",
/**
 * The axes.
 */
axes: Array<string>, } | { "do": "set_reference_point",
/**
 * Its number, 1 to 4.
 */
number: number,
/**
 * Machine positions, mm and degrees.
 */
axes: { [key in string]: number }, } | { "do": "pitch",
/**
 * The axis.
 */
axis: string, } | { "do": "set_pitch",
/**
 * The axis.
 */
axis: string,
/**
 * What is added to the commanded position, mm, by number of the point.
 */
points: { [key in number]: number }, } | { "do": "relative",
/**
 * The axis.
 */
axis: string,
/**
 * To what.
 */
to: RelativeTo, } | { "do": "spindle_speed",
/**
 * r/min; while G96 is in force the surface speed, mm/min or inch/min.
 */
speed: number, } | { "do": "clear_interruption",
/**
 * The axis; none is all.
 */
axis?: string | null, } | { "do": "set_counter",
/**
 * Its name.
 */
counter: string,
/**
 * Its value, pieces or s.
 */
value: number, } | { "do": "log_in",
/**
 * The level.
 */
level: number,
/**
 * Its password.
 */
password: string, } | { "do": "log_out" } | { "do": "set_password",
/**
 * The level.
 */
level: number,
/**
 * The new password.
 */
password: string, } | { "do": "alarm_history",
/**
 * How many at most.
 */
most: number, } | { "do": "clear_alarm_history" } | { "do": "operation_log",
/**
 * How many at most.
 */
most: number, } | { "do": "clear_operation_log" } | { "do": "signals",
/**
 * The names.
 */
names: Array<string>, } | { "do": "signal_table",
/**
 * Letter of the area: X, Y, F, G, A, K, T, C, D, R.
 */
area: string,
/**
 * Tag of the language of the meanings; English where it is missing.
 */
language?: string | null, } | { "do": "ladder" } | { "do": "watch_ladder",
/**
 * Whether.
 */
on: boolean, } | { "do": "ladder_flow" } | { "do": "trace",
/**
 * Names or addresses of bits, up to 32.
 */
signals: Array<string>,
/**
 * Samples that are kept, up to 100,000.
 */
samples: number,
/**
 * What sets off the end; without it the last samples are kept.
 */
trigger?: TraceTrigger | null,
/**
 * Samples behind the trigger; half of all where it is missing.
 */
behind?: number | null,
/**
 * Whether only samples that differ from the one before are kept.
 */
changes_only: boolean, } | { "do": "traced",
/**
 * The first sample, from 0.
 */
from: number,
/**
 * How many samples at most.
 */
most: number, } | { "do": "end_trace" } | { "do": "force",
/**
 * Its name or address.
 */
signal: string,
/**
 * On or off; none releases it.
 */
value?: boolean | null, } | { "do": "forced" } | { "do": "set_signal",
/**
 * Its name or address.
 */
signal: string,
/**
 * A bit, or a number with or without sign.
 */
value: number,
/**
 * Bytes of the number, the lowest first; where it is missing 2 in T and C, 1 in K and D.
 */
bytes?: number | null, } | { "do": "check_ladder",
/**
 * Its text: a list, or PLCopen XML (TC6) with ladder diagrams.
 */
text: string, } | { "do": "exchange_ladder",
/**
 * Its text: a list, or PLCopen XML (TC6) with ladder diagrams, which becomes one.
 */
text: string, } | { "do": "roll_back_ladder" } | { "do": "start_ladder" } | { "do": "capture",
/**
 * Names: `commanded.X`, `actual.X`, `velocity`, `spindle`, a signal.
 */
quantities: Array<string>,
/**
 * Time that is recorded, s.
 */
seconds: number,
/**
 * Periods from one sample to the next, from 1.
 */
every?: number,
/**
 * What sets off the end; without it the recording begins at once.
 */
trigger?: CaptureTrigger | null,
/**
 * Time before the trigger that is kept, s.
 */
before?: number, } | { "do": "captured",
/**
 * The first row, from 0.
 */
from: number,
/**
 * How many rows at most.
 */
most: number, } | { "do": "end_capture" } | { "do": "touch_point",
/**
 * Its number, 1 to 8.
 */
number: number, } | { "do": "points" } | { "do": "clear_points" } | { "do": "centre",
/**
 * `true`: a circle through three points or more; else a rectangle: points 1 and 2 on walls across X, 3 and 4
 * on walls across Y.
 */
circle: boolean,
/**
 * The work coordinate system: `G54`.
 */
system?: string | null,
/**
 * Coordinates of the centre there; 0 where they are missing.
 */
values: { [key in string]: number }, } | { "do": "measure" } & MeasureWork | { "do": "measure_tool" } & MeasureTool | { "do": "cancel_measure" } | { "do": "measured" } | { "do": "backup",
/**
 * Its bare name, which ends in `.backup`.
 */
file: string,
/**
 * Names of the items; empty for all.
 */
items: Array<string>, } | { "do": "restore",
/**
 * Its bare name.
 */
file: string,
/**
 * Names of the items.
 */
items: Array<string>, } | { "do": "status" } | { "do": "timing",
/**
 * They are taken anew from here.
 */
forget?: boolean, } | { "do": "version" };
