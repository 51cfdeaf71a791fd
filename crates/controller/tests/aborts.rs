//! A run that is broken off at any instant leaves interpreter, position, offsets, tools and spindle in agreement,
//! and nothing moves any more; the program can be taken up again where it was.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

mod common;
#[allow(dead_code)]
#[path = "common/panel.rs"]
mod panel;

use common::random::Random;
use common::{HANGS, cnc_with, machine};
use ferrocut_controller::api::{Activity, Command};
use ferrocut_controller::restart::{At, How};
use ferrocut_controller::{Cnc, Event, State};
use ferrocut_geometry::Position;
use ferrocut_interpreter::{Interpreter, Until};
use ferrocut_machine::Machine;
use ferrocut_toolpath::SpindleState;
use panel::Mill;
use std::fmt::Write;

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
    // The zero in force is that of the table, and the coordinates lead to where the axes stand.
    let system = in_force.codes().find(|code| (540..=590).contains(&code.tenths)).unwrap();
    let zero = interpreter.memory().work.standard[usize::from(system.tenths / 10 - 54)];
    assert_eq!(in_force.work_zero, zero, "{place}");
    let there = in_force.programmed + in_force.work_zero + in_force.length;
    assert!(there.distance(at.position) < 1e-9, "{place}: {there:?} is not {at:?}");
    assert!(in_force.machine == at.position, "{place}");
}

/// The G codes of motion, distance, plane and zero in force, and F.
fn codes(interpreter: &Interpreter) -> (Vec<u16>, f64) {
    let in_force = interpreter.program_state();
    let all = in_force.codes().map(|code| code.tenths);
    let kept = all.filter(|code| matches!(code, 0..=30 | 170..=190 | 540..=590 | 900 | 910));
    (kept.collect(), in_force.feed_per_minute)
}

/// What was read ahead is forgotten: the codes in force are those of the block that was being run, as it begins or
/// as it ends.
fn codes_are_of_the_block(cnc: &Cnc, text: &str, place: &str) {
    let block = cnc.journal().unwrap().interrupted().unwrap().block;
    let mut run = common::interpreter(text, SETUP);
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
    assert!(ends.iter().any(|(_, feed)| *feed == found.1), "{place}: {found:?}, block {block} has {ends:?}");
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
                let is_good = |text: &String| common::interpreter(text, SETUP).all(|step| step.is_ok());
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

/// What the ladder has to do with: spindle both ways, coolant, tools called, tapping, stops of the block.
const BY_LADDER: &str = "O1\nG90 G17 G21 G40 G49 G80 G94\nG53 G0 Z-60\nG53 X-120 Y-120\nT3\nM3 S600\nM8\nG91\nG1 X15 Y5 F6000\n\
    G2 X6 Y6 R6\nT4\nG1 Z-5\nX-10\nM5\nG4 X0.05\nM4 S500\nM98 P2 L2\nG0 Z10\nM9\nM5\nM29 S800\n\
    G98 G84 X0 Y0 Z-4 R-2 F800\nG80\nM28\nM3 S700\nG1 X-10 Y-8 F5000\nG90\nM30\n";
const PASS: &str = "O2\nG1 X8 F6000\nM8\nG3 X-8 R4\nM99\n";

/// Periods that the machine goes on by, without looking at it.
fn run(mill: &mut Mill, periods: usize) {
    (0..periods).for_each(|_| _ = mill.control.tick());
    mill.control.events();
}

/// A key that is pressed and let go, for as long as the ladder needs to see it.
fn press(mill: &mut Mill, key: &str) {
    for down in [true, false] {
        mill.say(Command::Key { key: key.into(), down });
        run(mill, KEY_MS);
    }
}

/// Nothing of the machine is left as the run had it, and everybody knows where the axes are.
fn is_quiet(mill: &mut Mill, place: &str) {
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
    run(mill, LAG);
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
    let there = in_force.programmed + in_force.work_zero + in_force.length;
    assert!(there.distance(interpreter.position()) < 1e-9, "{place}: {there:?}");
}

/// Aborts of a machine of its own, with random numbers of its own.
fn abort_whole(mut random: Random, aborts: usize) {
    let mut mill = Mill::power_on();
    mill.press("KEY_EDIT");
    for (name, text) in [("O0001", BY_LADDER), ("O0002", PASS)] {
        mill.say(Command::Store { program: name.into(), text: text.into() });
    }
    mill.home();
    mill.press("KEY_AUTO");
    mill.say(Command::Select { program: "O1".into() });
    mill.press("KEY_START");
    let mut length = 0;
    while mill.wait(1).counters.parts == 0 {
        length += 1;
        assert!(length < HANGS, "{:?}", mill.control.status());
    }
    mill.until("done", |status| status.activity == Activity::Idle);
    for case in 0..aborts {
        press(&mut mill, "KEY_AUTO");
        mill.say(Command::Cursor { line: 1 });
        press(&mut mill, "KEY_START");
        let instant = random.below(length);
        run(&mut mill, instant);
        let how = random.below(4);
        let block = mill.control.status().program.block.clone();
        match how {
            0 => {
                mill.say(Command::EmergencyStop { pressed: true });
                run(&mut mill, 1 + random.below(800));
                mill.say(Command::EmergencyStop { pressed: false });
                run(&mut mill, 20);
            }
            1 => {}
            2 => {
                mill.say(Command::Key { key: "KEY_HOLD".into(), down: true });
                run(&mut mill, KEY_MS + random.below(200));
                mill.say(Command::Key { key: "KEY_HOLD".into(), down: false });
                run(&mut mill, random.below(KEY_MS));
            }
            // Another mode takes the program's way first.
            _ => press(&mut mill, random.one(&["KEY_JOG", "KEY_MDI", "KEY_EDIT"])),
        }
        mill.say(Command::Reset);
        let place = format!("case {case}, {how} at {instant} of {length}, {block}");
        is_quiet(&mut mill, &place);
    }
    // All of it runs again, to its end.
    let before = mill.control.status().counters.parts;
    mill.press("KEY_AUTO");
    mill.say(Command::Cursor { line: 1 });
    mill.press("KEY_START");
    mill.until("another part", |status| status.counters.parts == before + 1);
}

#[test]
fn at_random_instants_everything_agrees_with_ladder_and_machine_too() {
    let aborts = std::env::var("FERROCUT_CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(WHOLE);
    std::thread::scope(|scope| {
        for mill in 0..MILLS {
            let share = aborts / MILLS + usize::from(mill < aborts % MILLS);
            scope.spawn(move || abort_whole(Random::new(31 + mill as u64), share));
        }
    });
}
