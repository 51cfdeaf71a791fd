//! The periods of a program, from cycle start to its end: any allocation inside the guard ends the test program.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use assert_no_alloc::{AllocDisabler, assert_no_alloc};
use common::mill::{self, Mill};
use common::{HANGS, cnc, in_language, machine, panel};
use ferrocut_controller::api::{Activity, Command, Event};
use ferrocut_controller::{Cnc, State};
use ferrocut_geometry::Position;

#[global_allocator]
static ALLOCATOR: AllocDisabler = AllocDisabler;

/// Short blocks, arcs, positioning, and fewer of them than motion looks ahead.
fn rows() -> String {
    let mut text = String::from("M3 S1000\nG0 X0 Y0 Z5\nG1 Z0 F600\nF1500\n");
    for row in 0..6 {
        let y = f64::from(row) * 2.0;
        for k in 0..60 {
            let x = 0.5 * f64::from(if row % 2 == 0 { k } else { 60 - k });
            text += &format!("X{x} Y{:.3} Z{:.3}\n", y + 0.3 * (x / 4.0).sin(), 0.2 * (x / 3.0).cos());
        }
        text += &format!("G3 Y{} R1\nG0 Z3\nG1 Z0\n", y + 2.0);
    }
    text + "G0 X0 Y0 Z5\nM30\n"
}

/// What stands between moves: dwells, codes, tools, what reads the machine, and macro statements.
const BETWEEN: &str = "M3 S1000\nG0 X5 Z2\nG1 Z-1 F800\nG4 X0.05\nM8\nX10\nG61 X12\nG64 Y3\nT2 M6\nS500\n#1=0\n\
                       WHILE[#1LT4]DO1\n#1=#1+1\nG1 X[10+#1]\nEND1\n#2=#5021\nG92 X3\nG1 X[#5001+1]\nG92 X15\n\
                       G28 X10 Y1\nG1 X10 F900\nM98 P2000\nM9\nM5\nG0 X0 Y0 Z5\nM30\nO2000\nX12\nY5\nM99\n";

/// Runs a program, whose every period is guarded with what is prepared for the next; the operator does something before
/// each. Periods in which the axes moved, and those in which the interpreter was lent.
fn run(program: &str, operator: impl FnMut(&mut Cnc, usize)) -> [usize; 2] {
    run_on(cnc(&machine(), program), operator)
}

fn run_on(mut cnc: Cnc, mut operator: impl FnMut(&mut Cnc, usize)) -> [usize; 2] {
    cnc.work_beside().unwrap();
    cnc.tick();
    cnc.cycle_start();
    let (mut moved, mut lent) = (0, 0);
    for k in 0..HANGS {
        // What is planned and read beside is here, as it is in time on a clock.
        cnc.await_beside();
        operator(&mut cnc, k);
        let tick = assert_no_alloc(|| {
            let tick = cnc.tick();
            cnc.prepare();
            tick
        });
        moved += usize::from(tick.velocity > 0.0);
        lent += usize::from(cnc.is_reading());
        drop(cnc.events());
        if cnc.state() == &State::Ended {
            assert_eq!(tick.position, Position::xyz(0.0, 0.0, 5.0));
            return [moved, lent];
        }
    }
    panic!("does not end: {:?}", cnc.state());
}

#[test]
fn a_period_allocates_nothing() {
    let [moved, lent] = run(&rows(), |cnc, k| match k % 1000 {
        300 => cnc.feed_hold(),
        500 => cnc.cycle_start(),
        700 => cnc.set_override(1.7, 0.5),
        900 => cnc.set_override(1.0, 1.0),
        _ => {}
    });
    assert!(moved > 5000 && lent > 5, "{moved} {lent}");
}

/// Of short blocks in a line motion has room for many more than of others.
#[test]
fn a_period_of_short_blocks_in_a_line_allocates_nothing() {
    let mut text = String::from("M3 S1000\nG0 X0 Y0 Z5\nG1 Z0 F600\nF1500\n");
    (1..12_000).for_each(|k| text += &format!("X{:.3}\n", f64::from(k) * 0.003));
    let mut most = 0;
    let [moved, lent] = run(&(text + "G0 X0 Y0 Z5\nM30\n"), |cnc, k| {
        most = most.max(cnc.moves().count());
        cnc.set_single_block((3000..3200).contains(&k));
        if cnc.state() == &State::BlockEnd {
            cnc.cycle_start();
        }
    });
    assert!(moved > 1000 && lent > 5 && most > 2000, "{moved} {lent} {most}");
}

#[test]
fn a_period_between_moves_allocates_nothing() {
    let [moved, lent] = run(BETWEEN, |_, _| {});
    assert!(moved > 1000 && lent > 5, "{moved} {lent}");
}

#[test]
fn a_period_at_the_end_of_a_block_allocates_nothing() {
    for program in [&rows(), BETWEEN] {
        let mut stops = 0;
        let [moved, lent] = run(program, |cnc, k| {
            // Single block for a while, then not.
            cnc.set_single_block(k / 4000 % 2 == 0);
            if cnc.state() == &State::BlockEnd {
                stops += 1;
                cnc.cycle_start();
            }
        });
        assert!(moved > 1000 && lent > 5 && stops > 10, "{moved} {lent} {stops}");
    }
}

/// Outputs in step with motion, several before a move too, and more of them than are kept.
#[test]
fn a_period_in_which_outputs_change_allocates_nothing() {
    let mut text = String::from("G21 G64 P0.01\nG0 Z5\nG1 F1500\nM62 P1\n");
    for k in 1..600 {
        (0..30).for_each(|port| text += &format!("M67 E{port} Q{k}\nM6{} P{port}\n", 2 + k % 2));
        text += &format!("X{:.3}\n", f64::from(k) * 0.05);
    }
    let cnc = Cnc::new(&machine(), in_language("rs274", &(text + "G0 X0 Y0 Z5\nM62 P2\nM2\n")));
    let mut changes = 0;
    let mut was = 0.0;
    let [moved, lent] = run_on(cnc, |cnc, k| {
        changes += usize::from(cnc.analog_output(29) != was);
        was = cnc.analog_output(29);
        match k % 500 {
            300 => cnc.feed_hold(),
            400 => cnc.cycle_start(),
            _ => {}
        }
    });
    assert!(moved > 1000 && lent > 5 && changes > 500, "{moved} {lent} {changes}");
}

#[test]
fn a_period_with_a_ladder_allocates_nothing() {
    let program =
        "M3 S1200\nG0 X5\nG95 G1 X10 F0.2\nM8\nG94 X20 F900\n#1=#1000\nG4 X0.1\nT2 M6\nG0 X0\nM5\nM30";
    let mut mill = Mill::new(program);
    mill.cnc.work_beside().unwrap();
    mill.start();
    mill.period = |cnc| {
        cnc.await_beside();
        assert_no_alloc(|| {
            let tick = cnc.tick();
            cnc.prepare();
            tick
        })
    };
    mill.until(|mill| mill.cnc.state() != &State::Running);
    assert_eq!((mill.cnc.state(), mill.cnc.report().tool()), (&State::Ended, 2));
}

/// The whole control: keys, ladder, machine, program, parts count. What is told besides, alarms and texts, has memory of its own.
#[test]
fn a_period_of_the_whole_control_allocates_nothing() {
    let mut mill = panel::Mill::power_on();
    mill.home();
    mill.control.work_beside().unwrap();
    mill.press("KEY_EDIT");
    let text =
        format!("O1\n{}", rows().replace("G0 X0 Y0 Z5\nM30", "T2 M6\nM8\nG4 X0.2\n#500=#5021\nM9\nM5\nM30"));
    mill.say(Command::Store { program: "O0001".into(), text });
    mill.say(Command::Store { program: "O9001".into(), text: mill::TOOL_CHANGE.into() });
    mill.say(Command::Select { program: "O1".into() });
    mill.press("KEY_AUTO");
    mill.wait(2000);
    mill.control.events();
    mill.press("KEY_START");
    let mut told = Vec::new();
    for k in 0..HANGS {
        match k % 3000 {
            1000 => drop(mill.say(Command::Key { key: "KEY_HOLD".into(), down: true })),
            1100 => drop(mill.say(Command::Key { key: "KEY_HOLD".into(), down: false })),
            1500 => drop(mill.say(Command::Key { key: "KEY_START".into(), down: true })),
            1600 => drop(mill.say(Command::Key { key: "KEY_START".into(), down: false })),
            _ => {}
        }
        mill.control.await_beside();
        assert_no_alloc(|| {
            mill.control.tick();
            mill.control.prepare();
        });
        told.extend(mill.control.events());
        if told.iter().any(|event| matches!(event, Event::Part { .. })) {
            let holds =
                told.iter().filter(|event| matches!(event, Event::Activity { activity: Activity::Held }));
            assert!(holds.count() > 2 && told.contains(&Event::ToolChange { tool: 2 }), "{told:?}");
            return;
        }
    }
    panic!("does not end: {told:?}");
}
