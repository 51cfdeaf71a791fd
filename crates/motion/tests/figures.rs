//! Times of paths that LinuxCNC 2.9 was timed on with the same limits, which are those of acceleration alone.
#![allow(clippy::unwrap_used)]

mod common;
use common::*;
use ferrocut_geometry::Position;
use ferrocut_machine::Machine;
use ferrocut_toolpath::{Op, PathMode};

/// Axes of 30 m/min with this acceleration, mm/s².
fn mill(acceleration: f64) -> Machine {
    let mut machine = demo();
    for axis in &mut machine.axes {
        (axis.rapid, axis.velocity, axis.acceleration, axis.jerk) = (30_000.0, 30_000.0, acceleration, 0.0);
    }
    machine
}

const WITHIN: PathMode = PathMode::ContinuousWithin(0.01);

/// Time of a program, which is run within the limits and the tolerance and without a stop.
fn time(machine: &Machine, start: Position, ops: &[Op]) -> f64 {
    let run = run(machine, start, ops);
    run.check_limits(machine);
    run.check_feed();
    run.check_path(0.01 + 1e-6);
    assert!(!run.stops_inside());
    run.time()
}

/// Lines of about `chord` mm along an arc about the origin, from (`radius`, 0) over `length` mm.
fn chords_of(radius: f64, length: f64, chord: f64, feed: f64) -> Vec<Op> {
    let count = (length / chord).round() as u32;
    let at = |k: u32| (length / radius * f64::from(k) / f64::from(count)).sin_cos();
    (1..=count).map(at).map(|(sin, cos)| line(radius * cos, radius * sin, 0.0, feed, WITHIN)).collect()
}

#[test]
fn a_square_is_faster_than_with_parabolic_blends() {
    let corners = [(100.0, 0.0), (100.0, 100.0), (0.0, 100.0), (0.0, 0.0)];
    let ops = corners.map(|(x, y)| line(x, y, 0.0, 6000.0, WITHIN));
    let time = time(&mill(2000.0), Position::ZERO, &ops);
    // LinuxCNC: 4.247 s.
    assert!(time <= 4.20, "{time}");
}

#[test]
fn an_arc_and_its_chords_take_what_the_acceleration_allows() {
    let (radius, length, feed) = (300.0, 377.0, 12_000.0);
    let machine = mill(500.0);
    let start = Position::xyz(radius, 0.0, 0.0);
    let (sin, cos) = (length / radius).sin_cos();
    let whole = [arc(Position::xyz(radius * cos, radius * sin, 0.0), [0.0, 0.0], length / radius, feed)];
    let whole = time(&machine, start, &whole);
    // LinuxCNC: 3.487 s; possible are 2.29 s.
    assert!(whole <= 2.35, "{whole}");
    // LinuxCNC: 7.765 s.
    let chords = time(&machine, start, &chords_of(radius, length, 0.1, feed));
    assert!((chords / whole - 1.0).abs() <= 0.05, "{chords} {whole}");
}

#[test]
fn chords_of_a_slight_curve_take_the_time_of_a_line() {
    let (radius, length, feed) = (3000.0, 300.0, 12_000.0);
    let machine = mill(500.0);
    let chords = chords_of(radius, length, 0.5, feed);
    let chords = time(&machine, Position::xyz(radius, 0.0, 0.0), &chords);
    let line = time(&machine, Position::ZERO, &[line(length, 0.0, 0.0, feed, WITHIN)]);
    // LinuxCNC: 1.23 times.
    assert!(chords <= 1.02 * line, "{chords} {line}");
}
