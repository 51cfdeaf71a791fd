//! The planner in a thread of its own: the same setpoints while it is in time, and a path within the limits where it is

//! not.

use crate::common::{HANGS, Run, cnc, ended, machine};
use ferrocut_controller::{Cnc, State};
use ferrocut_geometry::Position;
use std::fmt::Write;

const PROGRAM: &str = "S800 M3\nG0 X20 Y10 Z5\nG1 Z-1 F1500\nX60 F5000\nG3 X70 Y20 R10\nG1 Y40\nG61 X60\n\
                       Y30\nG64 X50\nG4 X0.1\nG92 X0\nG0 X5 Y0 A45\nG1 X10 F3000\nM30\n";

/// Short blocks on a curve, as a CAM system writes them.
fn curve(blocks: u32) -> String {
    let mut program = "G64 G1 F6000\n".to_owned();
    for k in 0..blocks {
        let t = f64::from(k) * 0.002;
        let (x, y) = (40.0 * t.sin() + 3.0 * (7.0 * t).sin(), 30.0 * (1.3 * t).cos());
        writeln!(program, "X{x:.3} Y{y:.3}").unwrap();
    }
    program + "M30\n"
}

/// The program with the planner beside, `wait` at each tick.
fn beside(program: &str, mut wait: impl FnMut(usize, &mut Cnc)) -> (Cnc, Run) {
    let mut cnc = cnc(&machine(), program);
    cnc.work_beside().unwrap();
    let start = cnc.tick().position;
    cnc.cycle_start();
    let mut run = Run { start, ticks: Vec::new(), events: Vec::new() };
    for tick in 0..HANGS {
        wait(tick, &mut cnc);
        run.ticks.push(cnc.tick());
        if !matches!(cnc.state(), State::Running | State::Held) {
            return (cnc, run);
        }
    }
    panic!("does not end: {:?} {:?}", cnc.state(), run.ticks.last());
}

fn moving(run: &Run) -> Vec<Position> {
    run.ticks.iter().map(|tick| tick.position).collect()
}

#[test]
fn setpoints_are_those_of_one_thread() {
    let (plain, there) = ended(&machine(), PROGRAM);
    let (cnc, run) = beside(PROGRAM, |_, cnc| cnc.await_beside());
    assert_eq!((cnc.state(), cnc.late_plans()), (&State::Ended, 0));
    assert_eq!((cnc.report().moves, cnc.report().parts), (plain.report().moves, plain.report().parts));
    // Where nothing moves it may be a period longer, until the planner is asked.
    let (mut here, mut there) = (moving(&run), moving(&there));
    here.dedup();
    there.dedup();
    assert_eq!(here, there);
    run.check_limits(&machine(), false);
}

#[test]
fn many_short_blocks_run_as_they_do_in_one_thread() {
    let program = curve(6000);
    let (plain, there) = ended(&machine(), &program);
    for looks_ahead in [false, true] {
        let (cnc, run) = beside(&program, |_, cnc| {
            cnc.await_beside();
            if looks_ahead {
                cnc.prepare();
                cnc.await_beside();
            }
        });
        assert_eq!((cnc.state(), cnc.late_plans()), (&State::Ended, 0));
        assert_eq!((run.end(), cnc.report().moves), (there.end(), plain.report().moves));
        run.check_limits(&machine(), true);
        // Once the queue is full no block is waited for. It fills in 500 periods at most.
        let longer = run.ticks.len() as i64 - there.ticks.len() as i64;
        assert!((0..=510).contains(&longer), "{longer}");
    }
}

#[test]
fn a_planner_that_is_late_or_asked_while_it_is_away_keeps_within_the_limits() {
    // Periods follow each other as fast as they can: it is late nearly always.
    let program = curve(1500);
    let (_, there) = ended(&machine(), &program);
    for every in [3, 7, 50] {
        let (cnc, run) = beside(&program, |tick, cnc| {
            if tick % every == 0 {
                cnc.await_beside();
            }
            match tick % 400 {
                100 => cnc.feed_hold(),
                180 => cnc.cycle_start(),
                250 => cnc.set_override(0.3, 0.3),
                300 => cnc.set_override(1.0, 1.0),
                _ => {}
            }
        });
        assert_eq!((cnc.state(), run.end()), (&State::Ended, there.end()));
        run.check_limits(&machine(), true);
    }
}

#[test]
fn a_reset_while_the_planner_is_away_is_not_lost() {
    for at in [120, 121, 122, 123, 200, 333] {
        let mut cnc = cnc(&machine(), &curve(3000));
        cnc.work_beside().unwrap();
        cnc.cycle_start();
        for _ in 0..at {
            cnc.await_beside();
            cnc.tick();
        }
        cnc.reset();
        let mut ticks = 0;
        while cnc.state() != &State::Reset {
            cnc.tick();
            std::thread::sleep(std::time::Duration::from_micros(50));
            ticks += 1;
            assert!(ticks < 20_000, "{:?}", cnc.state());
        }
        let rest = cnc.tick().position;
        (0..50).for_each(|_| assert_eq!(cnc.tick().position, rest));
    }
}

#[test]
fn a_program_of_many_blocks_without_a_way_does_not_end_early() {
    // More of them than are taken in a period.
    let program = format!("{}G1 X5 F3000\nM30\n", "G1 X0 F1000\n".repeat(100));
    let (cnc, run) = beside(&program, |_, cnc| cnc.await_beside());
    assert_eq!((cnc.state(), cnc.report().parts, run.end().0[0]), (&State::Ended, 1, 5.0));
}
