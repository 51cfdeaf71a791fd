//! A run that is broken off at any instant leaves interpreter, position, offsets, tools and spindle in agreement,

//! and nothing moves any more; the program can be taken up again where it was.

use crate::common::panel::Mill;
use crate::common::random::Random;
use crate::common::{HANGS, cnc_with, machine};
use ferrocut_controller::api::{Activity, Command, InterruptedBlock, OffsetValues};
use ferrocut_controller::restart::{At, How};
use ferrocut_controller::{Cnc, Event, Plant, State};
use ferrocut_geometry::{Axis, Position};
use ferrocut_interpreter::{Interpreter, Until};
use ferrocut_machine::setup::VariableName;
use ferrocut_machine::{AxisConfig, Machine, WorkOffset};
use ferrocut_memory::{Author, Counter, Item, Session, Settings, Store};
use ferrocut_toolpath::SpindleState;
use std::fmt::Write;
use std::sync::{Arc, LazyLock};

/// Aborts that are tried; `FERROCUT_CASES` says otherwise.
const ABORTS: usize = 150;

/// One in so many is taken up again and run to its end.
const TAKEN_UP: usize = 5;

const SETUP: &str = "
[start]
z = -20.0
[work_offsets]
G54 = { x = 10.0, y = -20.0, z = -100.0 }
G55 = { x = -30.0, y = 5.0, z = -110.0 }
[tools.1]
length = 12.0
radius = 3.0
[tools.2]
length = 20.0
radius = 2.0
[variables]
\"#500\" = 7.0
";

/// A program of whatever a shop writes, within the limits of the machine.
fn program(random: &mut Random) -> String {
    let mut text = "O1\nG90 G54 G17 G21 G40 G49 G80 G94 F2000\nT1 M6\nS1000 M3\n".to_owned();
    for k in 0..10 + random.below(10) {
        let mut mm = |most: f64| (random.unit() * 2.0 - 1.0) * most;
        let (x, y, z) = (mm(30.0), mm(30.0), mm(5.0));
        let r = 1.0 + mm(0.5).abs() * 10.0;
        let line = match random.below(18) {
            0 | 1 => format!("G00 X{x:.3} Y{y:.3}"),
            2..=4 => format!("G01 X{x:.3} Y{y:.3} Z{z:.3}"),
            5 => format!("G91 G02 X{r:.3} Y{r:.3} R{r:.3}\nG90"),
            6 => format!("G01 X{x:.3}\nG03 I{r:.3} J0"),
            7 => "G04 X0.05".to_owned(),
            8 => random.one(&["M3 S2000", "M4 S500", "M5", "M3 S0"]).to_owned(),
            9 => random.one(&["M8", "M9", "M8\nM35", "M36"]).to_owned(),
            10 => random.one(&["G54", "G55", "G43 H2 Z5", "G43 H1 Z0", "G49"]).to_owned(),
            11 => random.one(&["T2 M6\nM3 S1500", "T1 M6\nM3 S900", "T2"]).to_owned(),
            12 => format!("#500=#500+1\nG01 X{x:.3}\n#501=#5001"),
            13 => format!("G10 L2 P2 X{:.3} Y5 Z-110\nG01 Y{y:.3}", -30.0 + r),
            14 => format!("G01 Z8\nG99 G81 X{x:.3} Y{y:.3} Z-3 R2 F1500\nX{:.3}\nG80 F2000", x + 5.0),
            15 => format!("G00 X{x:.3} Y{y:.3}\nG91 G41 D1 G01 X8 Y0\nY20\nX20\nY-20\nG40 X5\nG90"),
            16 => format!("M98 P{} L{}", random.one(&[2, 3]), 1 + k % 3),
            _ => format!("#1=0\nWHILE[#1 LT 3]DO1\n#1=#1+1\nG91 G01 X{:.2} Y1\nG90\nEND1", x / 10.0),
        };
        writeln!(text, "{line}").unwrap();
    }
    text + "M30\nO2\nG91 G01 X3 Y-2\n#502=#502+1\nG90\nM99\nO3\nG91 G00 X-2\nX2\nG90\nM98 P2\nM99\n"
}

/// Runs until the control waits for nobody but the operator.
fn settle(cnc: &mut Cnc, changes: &mut [u32; 2]) {
    for _ in 0..HANGS {
        cnc.tick();
        note(cnc, changes);
        if !matches!(cnc.state(), State::Running | State::Resetting) {
            return;
        }
    }
    panic!("does not end: {:?}", cnc.state());
}

/// How many tools were changed, and which came last.
fn note(cnc: &mut Cnc, changes: &mut [u32; 2]) {
    for event in cnc.events() {
        if let Event::ToolChange(tool) = event {
            *changes = [changes[0] + 1, tool];
        }
    }
}

/// Machine, interpreter and memory say the same.
fn agrees(cnc: &mut Cnc, machine: &Machine, tool: u32, place: &str) {
    let at = cnc.tick();
    // Longer than the spindle needs.
    let seconds = machine.spindle.max_rpm / machine.spindle.acceleration_rpm_s + 0.1;
    for _ in 0..(seconds * 1000.0 / machine.servo_period_ms) as usize {
        let tick = cnc.tick();
        assert_eq!((tick.position, tick.actual), (at.position, at.position), "{place}: moves on");
        assert!(!tick.moving && tick.velocity == 0.0, "{place}");
    }
    assert_eq!(cnc.spindle().rpm(), 0.0, "{place}");
    let interpreter = cnc.interpreter();
    let in_force = interpreter.program_state();
    assert_eq!(interpreter.position(), at.position, "{place}");
    assert_eq!((in_force.spindle, in_force.coolant), (SpindleState::Off, [false; 2]), "{place}");
    assert_eq!(in_force.in_spindle, tool, "{place}");
    assert_eq!(in_force.calls, 0, "{place}");
    offsets_agree(interpreter, at.position, place);
}

/// Zero and tool length in force are those of the tables, and the coordinates lead to where the axes stand.
fn offsets_agree(interpreter: &Interpreter, at: Position, place: &str) {
    let in_force = interpreter.program_state();
    let code = |low, high| in_force.codes().map(|code| code.tenths).find(|code| (low..=high).contains(code));
    let system = code(540, 590).unwrap();
    let zero = interpreter.memory().work.standard[usize::from(system / 10 - 54)];
    assert_eq!(in_force.work_zero, zero, "{place}");
    let offset = |number: u16| *interpreter.memory().tools.get(number).unwrap();
    let length = match code(430, 490) {
        Some(490) => 0.0,
        _ => offset(in_force.length_number).length,
    };
    assert_eq!(in_force.length, Position::xyz(0.0, 0.0, length), "{place}");
    let there = in_force.programmed + in_force.work_zero + in_force.length;
    assert!(there.distance(at) < 1e-9, "{place}: {there:?} is not {at:?}");
    assert!(in_force.machine == at, "{place}");
}

/// The G codes of motion, distance, plane and zero in force, and F, H, D.
fn codes(interpreter: &Interpreter) -> (Vec<u16>, [f64; 3]) {
    let in_force = interpreter.program_state();
    let all = in_force.codes().map(|code| code.tenths);
    let kept = all.filter(|code| matches!(code, 0..=30 | 170..=190 | 540..=590 | 900 | 910));
    let (h, d) = (f64::from(in_force.length_number), in_force.radius_number);
    (kept.collect(), [in_force.feed_per_minute, h, d])
}

/// What was read ahead is forgotten: the codes in force are those of the block that was being run, as it begins or
/// as it ends.
fn codes_are_of_the_block(cnc: &Cnc, text: &str, place: &str) {
    let block = cnc.journal().unwrap().interrupted().unwrap().block;
    let mut run = crate::common::interpreter(text, SETUP);
    let ends = [block, block + 1].map(|number| {
        run.set_mark(Some(Until::Number(number)));
        (&mut run).for_each(|step| drop(step.unwrap()));
        codes(&run)
    });
    let found = codes(cnc.interpreter());
    for (k, code) in found.0.iter().enumerate() {
        assert!(
            ends.iter().any(|(codes, _)| codes[k] == *code),
            "{place}: {found:?}, block {block} has {ends:?}"
        );
    }
    for (k, word) in found.1.iter().enumerate() {
        assert!(
            ends.iter().any(|(_, words)| words[k] == *word),
            "{place}: {found:?}, block {block} has {ends:?}"
        );
    }
}

/// Where a full run ends, and what it leaves in #500 to #502 and G55.
fn outcome(cnc: &Cnc) -> (Position, [Option<f64>; 3], Position) {
    let memory = cnc.interpreter().memory();
    let variables = [500, 501, 502].map(|n| memory.variables.get(n));
    (cnc.interpreter().position(), variables, memory.work.standard[1])
}

#[test]
fn at_random_instants_everything_agrees_and_nothing_moves_any_more() {
    let aborts = std::env::var("FERROCUT_CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(ABORTS);
    let machine = machine();
    let mut random = Random::new(29);
    let (mut broken_off, mut taken_up) = (0, 0);
    let mut program_run = None;
    for case in 0..aborts {
        // Ten aborts of each program.
        let (text, length, whole) = match program_run.take().filter(|_| case % 10 > 0) {
            Some(run) => run,
            None => {
                // One that the control takes.
                let is_good =
                    |text: &String| crate::common::interpreter(text, SETUP).all(|step| step.is_ok());
                let text = loop {
                    let text = program(&mut random);
                    if is_good(&text) {
                        break text;
                    }
                };
                let mut cnc = cnc_with(&machine, &text, SETUP);
                cnc.cycle_start();
                let mut ticks = 0;
                while cnc.state() == &State::Running && ticks < HANGS {
                    cnc.tick();
                    ticks += 1;
                }
                assert_eq!(cnc.state(), &State::Ended, "{text}");
                let whole = outcome(&cnc);
                (text, ticks, whole)
            }
        };
        let instant = random.below(length);
        let place = format!("case {case}, tick {instant} of {length}\n{text}");
        let mut cnc = cnc_with(&machine, &text, SETUP);
        let mut changes = [0, 0];
        cnc.cycle_start();
        for _ in 0..instant {
            cnc.tick();
            note(&mut cnc, &mut changes);
        }
        match random.below(3) {
            0 => cnc.emergency_stop(),
            1 => cnc.reset(),
            _ => {
                cnc.feed_hold();
                (0..random.below(200)).for_each(|_| _ = cnc.tick());
                cnc.reset();
            }
        }
        settle(&mut cnc, &mut changes);
        assert_eq!(cnc.state(), &State::Reset, "{place}");
        agrees(&mut cnc, &machine, changes[1], &place);
        if instant > 0 {
            codes_are_of_the_block(&cnc, &text, &place);
        }
        broken_off += 1;
        if case % TAKEN_UP == 0 {
            let journal = cnc.journal().unwrap().clone();
            let restart = journal.find(At::Interrupted, cnc.interpreter().memory());
            let restart = restart.unwrap_or_else(|alarm| panic!("{place}\n{alarm:?}"));
            let how = How { sends: true, axis_by_axis: false };
            let lead_in = restart.lead_in(&cnc.present(), &machine, how).unwrap();
            cnc.restart(restart, lead_in).unwrap();
            cnc.cycle_start();
            settle(&mut cnc, &mut changes);
            assert_eq!(cnc.state(), &State::Ended, "{place}");
            assert_eq!(outcome(&cnc), whole, "{place}");
            taken_up += 1;
        }
        program_run = Some((text, length, whole));
    }
    println!("{broken_off} aborts, {taken_up} taken up again");
}

/// Aborts of the whole control; `FERROCUT_CASES` says otherwise.
const WHOLE: usize = 60;

/// Machines that share them, a thread each. Each has its own cases, so that they are the same on any computer.
const MILLS: usize = 4;

/// How long a key is held, and let go before the next, ms: some scans of the ladder.
const KEY_MS: usize = 30;

/// How long the axes take at most to come to where their drives are commanded to be, ms.
const LAG: usize = 60;

/// How long nothing may move behind an abort, ms.
const QUIET: usize = 100;

/// How long the ladder needs to see that the emergency stop is released, ms.
const RELEASED: usize = 20;

/// How long the magazine, the clamp and the ladder take to end what they had begun, ms.
const MAGAZINE: usize = 1500;

/// What the ladder has to do with: spindle both ways, coolant, tools called, tapping, stops of the block. What the
/// memory keeps: a zero that the program writes, variables. Length and cutter compensation. Three programs, each short, so
/// that an abort costs little of what came before it; each begins in whatever the aborted one before it left.
const BY_LADDER: [(&str, &str); 3] = [
    (
        "O0001",
        "O1\nG90 G17 G21 G40 G49 G80 G94 G54\nG53 G0 Z-60\nG53 X-120 Y-120\nT3 M6\nM3 S600\nM8\n#510=#510+1\n\
         G10 L2 P2 X[#510/10] Y-3 Z-40\nG91\nG1 X15 Y5 F6000\nG43 H1 Z-8\nG55\nG2 X6 Y6 R6\nT4\nG1 Z-5\n\
         G41 D2 X-10\nY-9\nX-6\nG40 X4\nG90\nM30\n",
    ),
    (
        "O0003",
        "O3\nG90 G17 G21 G40 G49 G80 G94 G55\nG53 G0 Z-60\nG53 X-105 Y-110\nT2 M6\nG91\nG43 H1 Z-4\nG4 X0.05\nM4 S500\n\
         M98 P2 L2\nG54\nG0 Z10\nG43 H2 Z-2\nM9\nM5\nG90\nM30\n",
    ),
    (
        "O0004",
        "O4\nG90 G17 G21 G40 G49 G80 G94 G54\nG53 G0 Z-60\nG91\nG43 H2 Z-2\nM29 S800\n\
         G98 G84 X0 Y0 Z-4 R-2 F800\nG80\nM28\nG49\nG10 L2 P1 Y[#510/20]\nM3 S700\nG1 X-10 Y-8 F5000\n\
         X10 Y8\nG90\nM30\n",
    ),
];
const PASS: &str = "O2\nG1 X8 F6000\nM8\n#511=#511+1\nG3 X-8 R4\nM99\n";
const TOOL_CHANGE: &str = include_str!("../../../../machines/tool-change.nc");

/// Its tapping: depth from the retract plane, and the speed of the spindle, mm and r/min.
const TAP: [f64; 2] = [4.0, 800.0];

/// Periods that the machine goes on by, with nobody looking; the last one in which an axis was moved, from 1. None of them
/// takes an axis farther than its rapid speed does.
fn run(mill: &mut Mill, periods: usize) -> usize {
    static FARTHEST: LazyLock<Vec<(Axis, f64)>> = LazyLock::new(|| {
        let machine = Machine::demo_mill();
        let way = |axis: &AxisConfig| (axis.name, 1.001 * axis.rapid / 60_000.0 * machine.servo_period_ms);
        machine.axes.iter().map(way).collect()
    });
    let (mut last, mut at) = (0, None::<Position>);
    for period in 1..=periods {
        let tick = mill.control.tick();
        if tick.moving {
            last = period;
        }
        let before = at.replace(tick.position).unwrap_or(tick.position);
        for (axis, farthest) in FARTHEST.iter() {
            let way = (tick.position[*axis] - before[*axis]).abs();
            assert!(way <= *farthest, "{axis:?} jumps by {way} mm");
        }
    }
    mill.control.events();
    last
}

/// Holds the run where that can be done, and moves the axes aside by hand or back along the path. Then the run goes on, so
/// that what comes next meets it on a way back, or shortly behind it.
fn intervene(mill: &mut Mill, random: &mut Random) {
    press(mill, "KEY_HOLD");
    for _ in 0..40 {
        run(mill, 50);
        let status = mill.control.status();
        if status.activity == Activity::Held && status.feed.actual == 0.0 {
            break;
        }
    }
    if mill.control.status().activity != Activity::Held {
        return;
    }
    if random.below(3) == 0 {
        // Refused where nothing was cut yet.
        let author = Author::Person { session: Session::OPERATOR, name: "panel".into() };
        let _ = mill.control.command(Command::Retrace, &author);
        run(mill, random.below(150));
        return;
    }
    press(mill, "KEY_JOG");
    let key = random.one(&["KEY_Z+", "KEY_X+", "KEY_Y-"]);
    mill.say(Command::Key { key: key.into(), down: true });
    run(mill, KEY_MS + random.below(400));
    mill.say(Command::Key { key: key.into(), down: false });
    run(mill, 500);
    press(mill, "KEY_AUTO");
    press(mill, "KEY_START");
    run(mill, random.below(300));
}

/// The same counted from an earlier instant.
fn later(since: usize, moved: usize) -> usize {
    if moved == 0 { 0 } else { since + moved }
}

/// A key that is pressed and let go, for as long as the ladder needs to see it.
fn press(mill: &mut Mill, key: &str) {
    for down in [true, false] {
        mill.say(Command::Key { key: key.into(), down });
        run(mill, KEY_MS);
    }
}

/// The longest that the axes of the program take to come to rest, ms: each brakes from its highest speed within its
/// acceleration, which it reaches and leaves within its jerk, from the end of what motion has planned ahead. On arcs,
/// what turns the path is not there to brake. A tap comes out of its thread first, which takes no longer than in and out
/// with the ramps of the spindle.
fn braking(machine: &Machine, taps: bool) -> usize {
    let brake = |axis: &AxisConfig| {
        axis.velocity.max(axis.rapid) / 60.0 / axis.acceleration + 2.0 * axis.acceleration / axis.jerk
    };
    let moved = machine.axes.iter().filter(|axis| axis.name != Axis::A);
    let [depth, rpm] = TAP;
    let stroke = depth / (rpm / 60.0) + 2.0 * rpm / machine.spindle.acceleration_rpm_s;
    let seconds = TURNING * moved.map(brake).fold(0.0, f64::max) + if taps { 2.0 * stroke } else { 0.0 };
    AHEAD + (seconds * 1000.0 / machine.servo_period_ms).ceil() as usize
}

/// By how much braking takes longer on an arc at the limit of its acceleration: ∫du/√(1-u⁴) = 1.31, and its jerk.
const TURNING: f64 = 1.5;

/// Periods that motion is planned ahead, and one each in which command and standstill are seen.
const AHEAD: usize = 8 + 2;

/// Nothing of the machine is left as the run had it, and everybody knows where the axes are.
fn is_quiet(mill: &mut Mill, store: Option<&Store>, place: &str) {
    let signal = |mill: &mut Mill, name: &str| {
        let plc = mill.control.plc_mut().unwrap();
        let address = plc.program().signal(name).unwrap_or_else(|| panic!("no signal {name}"));
        plc.memory().bit(address)
    };
    let is_calm = |mill: &mut Mill| {
        let status = mill.control.status();
        let is_idle = status.activity == Activity::Idle && status.alarms.is_empty();
        // The reset signal, the ramp of the spindle.
        is_idle && signal(mill, "SSTA") && !signal(mill, "RESET")
    };
    // The signal of the reset comes with the next period.
    run(mill, 2);
    for _ in 0..HANGS {
        if is_calm(mill) {
            break;
        }
        run(mill, 10);
    }
    run(mill, LAG + MAGAZINE);
    let at = mill.control.tick();
    for _ in 0..QUIET {
        let tick = mill.control.tick();
        assert_eq!(
            (tick.position, tick.velocity, tick.moving),
            (at.position, 0.0, false),
            "{place}: moves on"
        );
        // The encoders count in units of the machine file.
        assert!(tick.actual.distance(tick.position) < 0.002, "{place}: {tick:?}");
    }
    mill.control.events();
    let status = mill.control.status();
    assert_eq!((status.activity, status.feed.actual), (Activity::Idle, 0.0), "{place}");
    for name in ["MF", "SF", "TF", "OP", "STL", "SPL", "SFRA", "SRVA", "COOLANT"] {
        assert!(!signal(mill, name), "{place}: {name}");
    }
    assert!(signal(mill, "SSTA"), "{place}: the spindle turns");
    let interpreter = mill.control.interpreter();
    assert_eq!(interpreter.position(), at.position, "{place}");
    let in_force = interpreter.program_state();
    assert_eq!(
        (in_force.spindle, in_force.coolant, in_force.calls),
        (SpindleState::Off, [false; 2], 0),
        "{place}"
    );
    assert_eq!(
        (status.program.h, status.program.d),
        (in_force.length_number, in_force.radius_number),
        "{place}"
    );
    offsets_agree(interpreter, at.position, place);
    tools_agree(mill, place);
    if let Some(store) = store {
        is_kept(mill, store, place);
    }
}

/// NC, ladder and panel have the tool that the spindle has, and the ladder the pocket at which the magazine stands.
fn tools_agree(mill: &mut Mill, place: &str) {
    let (tool, pocket) = mill.control.plant_mut().unwrap().tool_and_pocket();
    let plc = mill.control.plc_mut().unwrap();
    let [counted, between] = ["POCKET", "BETWEEN"].map(|name| plc.program().signal(name).unwrap());
    if !plc.memory().bit(between) {
        assert_eq!(u32::from(plc.memory().byte(counted)), pocket, "{place}: pocket");
    }
    let told = mill.control.inputs().tool_in_spindle;
    let (in_spindle, _) = mill.control.interpreter().tools();
    let shown = mill.control.status().spindle.tool;
    assert_eq!((told, in_spindle, shown), (Some(tool), tool, tool), "{place}");
}

/// What an operator does where a change of tool was broken off: sends the magazine away, or has the change ended.
fn end_change(mill: &mut Mill, place: &str) {
    let is = |mill: &mut Mill, name: &str| {
        let plc = mill.control.plc_mut().unwrap();
        let address = plc.program().signal(name).unwrap();
        plc.memory().bit(address)
    };
    match (is(mill, "TOOL_CLAMPED"), is(mill, "MAG_AWAY")) {
        (true, true) => return,
        (true, false) => mill.mdi("M22"),
        (false, _) => mill.mdi("G91 G28 Z0\nT5 M06"),
    }
    assert!(is(mill, "TOOL_CLAMPED") && is(mill, "MAG_AWAY"), "{place}");
    tools_agree(mill, place);
}

/// The durable memory has what the control has.
fn is_kept(mill: &mut Mill, store: &Store, place: &str) {
    mill.control.flush().unwrap();
    let status = mill.control.status();
    let items = [
        Item::WorkZeros,
        Item::Offsets,
        Item::Variables,
        Item::Counters,
        Item::LastPosition,
        Item::Interrupted,
    ];
    let kept = store.reader().contents(&items).unwrap();
    let memory = mill.control.interpreter().memory();
    for (system, zero) in (1..).zip(&memory.work.standard) {
        let found = kept.work_zeros.get(&WorkOffset::Standard(system)).copied().unwrap_or_default();
        assert_eq!(found, *zero, "{place}: zero {system}");
    }
    for number in 1..=memory.tools.last() {
        let found = kept.offsets.get(&number).copied().unwrap_or_default();
        assert_eq!(Some(found), memory.tools.get(number).copied(), "{place}: offset {number}");
    }
    for number in 500..600 {
        let found = kept.variables.get(&VariableName::Number(number)).copied();
        assert_eq!(found, memory.variables.get(number), "{place}: #{number}");
    }
    assert_eq!(kept.counters[&Counter::Parts], status.counters.parts as f64, "{place}");
    let position = kept.last_position.unwrap();
    let mine = mill.control.interpreter();
    assert_eq!((position.position, position.work_system), (mine.position(), mine.work_system()), "{place}");
    let told = |at: &InterruptedBlock| (at.file.clone(), at.line, at.time);
    let block = kept.interrupted.map(|at| (at.file, at.line, at.time));
    assert_eq!(block, status.interrupted.as_ref().map(told), "{place}");
}

/// Aborts of a machine of its own, with random numbers of its own.
fn abort_whole(mut random: Random, aborts: usize, is_kept: bool) {
    let machine = Machine::demo_mill();
    let folder = tempfile::tempdir().unwrap();
    let store = is_kept.then(|| Arc::new(Store::open(folder.path(), Settings::new("gsk990mc")).unwrap()));
    let plant = Plant::new(&machine, Position::ZERO, Position::ZERO);
    let mut mill = Mill::of(&machine, plant, store.clone());
    mill.press("KEY_EDIT");
    for (name, text) in BY_LADDER.into_iter().chain([("O0002", PASS), ("O9001", TOOL_CHANGE)]) {
        mill.say(Command::Store { program: name.into(), text: text.into() });
    }
    for (number, length, radius) in [(1, 12.0, 3.0), (2, 20.0, 2.0)] {
        let (length, radius) = (Some(length), Some(radius));
        let values = OffsetValues { length, radius, ..OffsetValues::default() };
        mill.say(Command::SetOffset { number, values, add: false });
    }
    mill.home();
    // The one that is in the spindle; the ladder is not told of it yet.
    mill.mdi("T1 M06");
    tools_agree(&mut mill, "power-on");
    mill.press("KEY_AUTO");
    let mut made = 0;
    let mut whole_run = |mill: &mut Mill, program: &str| {
        press(mill, "KEY_AUTO");
        mill.say(Command::Select { program: program.into() });
        press(mill, "KEY_START");
        made += 1;
        let mut length = 0;
        while mill.wait(1).counters.parts < made {
            length += 1;
            assert!(length < HANGS, "{:?}", mill.control.status());
        }
        mill.until("done", |status| status.activity == Activity::Idle);
        length
    };
    // The second runs begin where others end, as most of the aborted ones do.
    BY_LADDER.iter().for_each(|(program, _)| _ = whole_run(&mut mill, program));
    let lengths = BY_LADDER.map(|(program, _)| whole_run(&mut mill, program));
    let (mut broken_off, mut longest) = (0, [0; 2]);
    // Where the program came to its end before, nothing was broken off: that is none of them.
    let mut case = 0;
    while broken_off < aborts {
        case += 1;
        assert!(case < 100 + 2 * aborts, "{broken_off} of {aborts} in {case}");
        press(&mut mill, "KEY_AUTO");
        let which = random.below(BY_LADDER.len());
        let ((program, _), length) = (BY_LADDER[which], lengths[which]);
        mill.say(Command::Select { program: program.into() });
        press(&mut mill, "KEY_START");
        let begun = mill.control.status();
        assert!(begun.program_mode.is_some() && begun.interrupted.is_none(), "case {case}: {begun:?}");
        let instant = random.below(length);
        run(&mut mill, instant);
        let intervened = random.below(6) == 0;
        if intervened {
            intervene(&mut mill, &mut random);
        }
        let how = random.below(4);
        let mut before = mill.control.status();
        // When an axis was moved last, and how long ago that was asked to end.
        let (mut moved, mut since) = (0, 0);
        match how {
            0 => {
                mill.say(Command::EmergencyStop { pressed: true });
                let pressed = 1 + random.below(800);
                moved = run(&mut mill, pressed);
                mill.say(Command::EmergencyStop { pressed: false });
                moved = moved.max(later(pressed, run(&mut mill, RELEASED)));
                since = pressed + RELEASED;
            }
            1 => {}
            2 => {
                mill.say(Command::Key { key: "KEY_HOLD".into(), down: true });
                let pressed = KEY_MS + random.below(200);
                run(&mut mill, pressed);
                mill.say(Command::Key { key: "KEY_HOLD".into(), down: false });
                run(&mut mill, random.below(KEY_MS));
            }
            // Another mode takes the program's way first.
            _ => press(&mut mill, random.one(&["KEY_JOG", "KEY_MDI", "KEY_EDIT"])),
        }
        let place = format!(
            "case {case}, {program} {how} {intervened} at {instant} of {length}, {}",
            before.program.block
        );
        if how > 0 {
            before = mill.control.status();
        }
        mill.say(Command::Reset);
        let taps = before.program.block.contains("G84");
        let most = braking(&machine, taps);
        moved = moved.max(later(since, run(&mut mill, most + LAG)));
        assert!(moved <= most, "{place}: comes to rest after {moved} of {most}");
        longest[usize::from(taps)] = moved.max(longest[usize::from(taps)]);
        is_quiet(&mut mill, store.as_deref(), &place);
        // A run that was under way was broken off where it was, and made no part.
        let status = mill.control.status();
        assert_eq!((status.program_mode, status.counters.parts), (None, before.counters.parts), "{place}");
        let block = status.interrupted.map(|at| (at.program, at.kept));
        let wanted = before.program_mode.map(|_| (program.to_owned(), true));
        assert_eq!(block, wanted, "{place}");
        broken_off += usize::from(wanted.is_some());
        end_change(&mut mill, &place);
    }
    println!(
        "{broken_off} aborts in {case} runs of {lengths:?} ms; at rest after {longest:?} ms, in a thread the second"
    );
    // All of it runs again, to its end.
    BY_LADDER.iter().for_each(|(program, _)| _ = whole_run(&mut mill, program));
}

#[test]
fn at_random_instants_everything_agrees_with_ladder_and_machine_too() {
    let aborts = std::env::var("FERROCUT_CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(WHOLE);
    std::thread::scope(|scope| {
        for mill in 0..MILLS {
            let share = aborts / MILLS + usize::from(mill < aborts % MILLS);
            // Every other has a durable memory.
            scope.spawn(move || abort_whole(Random::new(31 + mill as u64), share, mill % 2 == 0));
        }
    });
}

/// Aborts of changes of tool; `FERROCUT_CASES` says otherwise.
const CHANGES: usize = 24;

/// How long a change takes, ms: the way of the magazine twice, the clamp twice, the axis, a few pockets.
const CHANGE: usize = 5_000;

#[test]
fn a_change_of_tool_that_is_broken_off_anywhere_leaves_the_tool_that_is_there() {
    let aborts = std::env::var("FERROCUT_CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(CHANGES);
    let machine = Machine::demo_mill();
    let plant = Plant::new(&machine, Position::ZERO, Position::ZERO);
    let mut mill = Mill::of(&machine, plant, None);
    let mut random = Random::new(47);
    mill.press("KEY_EDIT");
    mill.say(Command::Store { program: "O9001".into(), text: TOOL_CHANGE.into() });
    mill.home();
    mill.mdi("T1 M06");
    let mut within = 0;
    for case in 0..aborts {
        let (tool, _) = mill.control.plant_mut().unwrap().tool_and_pocket();
        let next = tool % 4 + 1;
        press(&mut mill, "KEY_MDI");
        mill.say(Command::Mdi { text: format!("T{next} M06") });
        press(&mut mill, "KEY_START");
        let instant = random.below(CHANGE);
        run(&mut mill, instant);
        let place = format!("case {case}, T{tool} to T{next}, {instant}");
        within += usize::from(mill.control.status().activity != Activity::Idle);
        match random.below(2) {
            0 => drop(mill.say(Command::Reset)),
            _ => {
                mill.say(Command::EmergencyStop { pressed: true });
                run(&mut mill, 100);
                mill.say(Command::EmergencyStop { pressed: false });
            }
        }
        run(&mut mill, MAGAZINE);
        tools_agree(&mut mill, &place);
        end_change(&mut mill, &place);
        // The same change once more, to its end.
        mill.mdi(&format!("T{next} M06"));
        tools_agree(&mut mill, &place);
        let (tool, _) = mill.control.plant_mut().unwrap().tool_and_pocket();
        assert_eq!(tool, next, "{place}");
    }
    println!("{within} of {aborts} within the change");
}
