//! Feeds as they are run: with the spindle, behind the overrides, and behind a thread.

use crate::common::Hand::Override;
use crate::common::{Run, cnc_with, in_language, machine, run, run_with};
use ferrocut_controller::{Cnc, Event, State};
use ferrocut_geometry::Axis;

/// Runs a program; `act` is called before each period.
fn run_acting(cnc: &mut Cnc, mut act: impl FnMut(&mut Cnc, usize)) -> Run {
    let start = cnc.tick().position;
    cnc.cycle_start();
    let (mut ticks, mut events) = (Vec::new(), Vec::new());
    while matches!(cnc.state(), State::Running) {
        act(cnc, ticks.len());
        ticks.push(cnc.tick());
        events.extend(cnc.events());
        assert!(ticks.len() < crate::common::HANGS);
    }
    assert_eq!(cnc.state(), &State::Ended);
    Run { start, ticks, events }
}

/// A long cut of many blocks.
fn cut(head: &str) -> String {
    let blocks: String = (1..=100).map(|k| format!("X{}\n", 4 * k)).collect();
    format!("{head}\n{blocks}M30\n")
}

#[test]
fn a_feed_per_revolution_follows_the_spindle_with_moves_that_are_planned_already() {
    // 1.5 mm at 1000 r/min: 25 mm/s.
    let mut cnc = cnc_with(&machine(), &cut("M3 S1000\nG95 G1 F1.5"), "");
    let run = run_acting(&mut cnc, |cnc, k| match k {
        2000 => cnc.set_spindle_override(0.5),
        5000 => cnc.set_spindle_override(1.2),
        8000 => cnc.set_override(2.0, 1.0),
        9000 => cnc.set_spindle_override(0.8),
        _ => {}
    });
    run.check_limits(&machine(), true);
    for (tick, speed) in [(1990, 25.0), (2500, 12.5), (4990, 12.5), (5500, 30.0), (8500, 60.0), (9500, 40.0)]
    {
        let velocity = run.ticks[tick].velocity;
        assert!((velocity - speed).abs() < 1e-3 * speed, "tick {tick}: {velocity} instead of {speed} mm/s");
    }
}

#[test]
fn a_feed_per_revolution_waits_for_a_spindle_that_was_stopped() {
    let mut cnc = cnc_with(&machine(), &cut("M3 S1000\nG95 G1 F1.5"), "");
    let run = run_acting(&mut cnc, |cnc, k| match k {
        2000 => cnc.set_spindle_override(0.0),
        3000 => cnc.set_spindle_override(1.0),
        _ => {}
    });
    run.check_limits(&machine(), true);
    assert!(run.ticks[2500..2990].iter().all(|tick| tick.velocity == 0.0));
    assert!((run.ticks[3500].velocity - 25.0).abs() < 0.025);
}

#[test]
fn a_feed_per_minute_does_not_know_the_spindle() {
    let program = cut("M3 S1000\nG94 G1 F1500");
    let alone = run(&mut cnc_with(&machine(), &program, ""));
    let run = run_acting(&mut cnc_with(&machine(), &program, ""), |cnc, k| {
        if k == 2000 {
            cnc.set_spindle_override(0.5);
        }
    });
    assert!(run.ticks.iter().zip(&alone.ticks).all(|(a, b)| a.position == b.position));
}

/// GSK990MC 4.2.2, note 1: the speed behind the override is held.
#[test]
fn the_speed_behind_the_overrides_is_held_between_p97_and_p96() {
    let fastest = |head: &str, hands: &[(usize, crate::common::Hand)]| {
        let setup = "[parameters]\nP96 = 6000\nP97 = 300\n";
        let mut cnc = cnc_with(&machine(), &cut(head), setup);
        let run = run_with(&mut cnc, hands);
        run.check_limits(&machine(), true);
        run.ticks.iter().map(|tick| tick.velocity).fold(0.0, f64::max)
    };
    let is = |speed: f64, head: &str, hands: &[(usize, crate::common::Hand)]| {
        let found = fastest(head, hands);
        assert!(found < speed * 1.001 && found > speed * 0.995, "{head}: {found} instead of {speed} mm/s");
    };
    is(100.0, "M3 S1000\nG1 F6000", &[(0, Override(2.0, 1.0))]);
    is(100.0, "M3 S1000\nG1 F4000", &[(0, Override(2.0, 1.0))]);
    is(80.0, "M3 S1000\nG1 F2400", &[(0, Override(2.0, 1.0))]);
    // 8 mm at 1000 r/min.
    is(100.0, "M3 S1000\nG95 G1 F8", &[]);
    is(100.0, "M3 S1000\nG95 G1 F5", &[(0, Override(2.0, 1.0))]);
    // 10 % of 1200 mm/min.
    is(5.0, "M3 S1000\nG1 F1200", &[(0, Override(0.1, 1.0))]);
    // F may be beyond a limit where the override leads back: 50 % of 12000, and of 10000; 200 % of 150 mm/min, and of 200.
    is(100.0, "M3 S1000\nG1 F12000", &[(0, Override(0.5, 1.0))]);
    is(83.333, "M3 S1000\nG1 F10000", &[(0, Override(0.5, 1.0))]);
    is(100.0, "M3 S1000\nG1 F12000", &[]);
    is(66.667, "M3 S1000\nG95 G1 F8", &[(0, Override(0.5, 1.0))]);
    is(5.0, "M3 S1000\nG1 F150", &[(0, Override(2.0, 1.0))]);
    is(6.667, "M3 S1000\nG1 F200", &[(0, Override(2.0, 1.0))]);
    is(5.0, "M3 S1000\nG1 F100", &[]);
    // A limit that the program sets holds as well, and in a thread.
    is(10.0, "M3 S1000\nG10 L51\nN96 R1200\nG11\nG1 F2400", &[(0, Override(0.5, 1.0))]);
    is(100.0, "M3 S1000\nG63 G1 F12000", &[(0, Override(0.5, 1.0))]);
    // 0 % holds all the same.
    is(20.0, "M3 S1000\nG1 F1200", &[(0, Override(0.0, 1.0)), (3000, Override(1.0, 1.0))]);
}

/// LinuxCNC, G33: M3 stays in force.
#[test]
fn the_spindle_goes_on_behind_a_thread_in_the_language_in_which_it_does() {
    let program =
        "G21 M3 S300\nG0 X1 Z0\nG33 Z-5 K1\nG33 Z-6 X2 K1\nG0 X3\nG1 X10 F600\nG33.1 Z-12 K1\nG1 X20\nM2\n";
    let mut cnc = Cnc::new(&machine(), in_language("rs274", program));
    let mut rpm = Vec::new();
    let run = run_acting(&mut cnc, |cnc, _| rpm.push(cnc.spindle().actual_rpm()));
    let warnings: Vec<&Event> = run.events.iter().filter(|e| matches!(e, Event::Warning(_))).collect();
    assert!(warnings.is_empty(), "{warnings:?}");
    // What is fed behind the threads.
    for (x, to) in [(3.001, 9.999), (10.001, 19.999)] {
        let fed = run.ticks.iter().zip(&rpm).filter(|(tick, _)| (x..to).contains(&tick.position[Axis::X]));
        let speeds: Vec<f64> = fed.map(|(_, rpm)| *rpm).collect();
        assert!(speeds.len() > 500 && speeds.iter().all(|rpm| *rpm == 300.0), "{x}");
    }
}

/// Inverse time: each block takes its part of a minute, whatever its length, arcs, helices and blocks run through included.
#[test]
fn inverse_time_is_the_time_of_the_block() {
    let program = "G21 G90 G17 G64\nG93 G1 X50 F12\nX60 F12\nG2 X80 Y-20 R20 F20\nG3 X80 Y0 Z-10 I0 J10 F10\nG1 X80 Y4 F30\nM2\n";
    let mut cnc = Cnc::new(&machine(), in_language("rs274", program));
    let run = run(&mut cnc);
    run.check_limits(&machine(), true);
    let period = machine().servo_period_ms / 1000.0;
    let took =
        |line: u32| run.ticks.iter().filter(|t| t.moving && t.span.line == line).count() as f64 * period;
    // Into and out of what is slower the axes take a little more: v/a and the jerk's part, some hundredths.
    for (line, wanted) in [(2, 5.0), (3, 5.0), (4, 3.0), (5, 6.0), (6, 2.0)] {
        let found = took(line);
        assert!(found > wanted - 0.01 && found < wanted + 0.06, "line {line}: {found} s instead of {wanted}");
    }
}
