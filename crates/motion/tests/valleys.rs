//! Valleys: a curve between two fast stretches is run in nearly the least time, and may be held and slowed down in it.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{Event, Run, arc, demo, line, run_with};
use ferrocut_geometry::Position;
use ferrocut_machine::Machine;
use ferrocut_toolpath::{Op, PathMode};

const GO: PathMode = PathMode::ContinuousWithin(0.01);

/// Limits 500 mm/s, 3000 mm/s² and 60 m/s³ in X and Y.
fn machine() -> Machine {
    let mut machine = demo();
    machine.servo_period_ms = 1.0;
    machine.path.tolerance = 0.01;
    for axis in &mut machine.axes {
        (axis.rapid, axis.velocity, axis.acceleration, axis.jerk) = (30000.0, 30000.0, 3000.0, 60000.0);
    }
    machine
}

/// Two rows of 20 mm in blocks of 0.25 mm, joined by a half circle of radius 0.25 mm.
fn rows() -> Vec<Op> {
    let there = (1..=80).map(|k| line(0.25 * f64::from(k), 0.0, 0.0, 9000.0, GO));
    let mut link = arc(Position::xyz(20.0, 0.5, 0.0), [20.0, 0.25], std::f64::consts::PI, 9000.0);
    if let Op::Arc { path, .. } = &mut link {
        *path = GO;
    }
    let back = (1..=80).map(|k| line(20.0 - 0.25 * f64::from(k), 0.5, 0.0, 9000.0, GO));
    there.chain([link]).chain(back).collect()
}

fn judged(events: &[(usize, Event)]) -> Run {
    let machine = machine();
    let run = run_with(&machine, Position::ZERO, &rows(), events, &[]);
    run.check_limits(&machine);
    run.check_path(0.01 + 1e-6);
    run
}

#[test]
fn a_turn_between_two_rows_takes_little_more_than_the_least_time() {
    // Geometry and timing optimised together, anywhere inside the tolerance, take 0.4483 s; bounds by magnitudes 0.544 s.
    let run = judged(&[]);
    assert!(run.time() < 1.14 * 0.4483, "{}", run.time());
}

#[test]
fn a_half_circle_between_two_lines_takes_little_more_than_the_least_time() {
    let machine = machine();
    let mut turn = arc(Position::xyz(20.0, 10.0, 0.0), [20.0, 5.0], std::f64::consts::PI, 9000.0);
    if let Op::Arc { path, .. } = &mut turn {
        *path = GO;
    }
    let ops = [line(20.0, 0.0, 0.0, 9000.0, GO), turn, line(0.0, 10.0, 0.0, 9000.0, GO)];
    let run = run_with(&machine, Position::ZERO, &ops, &[], &[]);
    run.check_limits(&machine);
    run.check_path(0.01 + 1e-6);
    // The near-optimum anywhere inside the tolerance takes 0.5354 s; bounds by magnitudes 0.607 s.
    assert!(run.time() < 1.08 * 0.5354, "{}", run.time());
}

#[test]
fn a_hold_in_a_valley_stops_before_its_end() {
    let plain = judged(&[]);
    let turn = plain.samples.iter().position(|s| s.position.0[1] > 0.25).unwrap();
    for tick in (turn - 80..turn + 80).step_by(8) {
        let run = judged(&[(tick, Event::Hold), (tick + 400, Event::Resume)]);
        let stands = run.samples.iter().enumerate().skip(tick).find(|(_, s)| s.velocity == 0.0).unwrap().0;
        // A stop from the feed takes 0.1 s on a line.
        assert!(stands < tick + 190, "held in period {tick}, at rest in {stands}");
        assert_eq!(run.samples.last().unwrap().position, plain.samples.last().unwrap().position);
    }
}

#[test]
fn another_override_in_a_valley_keeps_path_and_limits() {
    let plain = judged(&[]);
    let turn = plain.samples.iter().position(|s| s.position.0[1] > 0.25).unwrap();
    for (k, tick) in (turn - 80..turn + 80).step_by(16).enumerate() {
        let share = [0.1, 0.5, 1.5][k % 3];
        judged(&[(tick, Event::Override(share, 1.0)), (tick + 60, Event::Override(1.0, 1.0))]);
    }
}
