//! Blocks far shorter than the tolerance: the same path in larger ones takes as long.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{Run, demo, line, run};
use ferrocut_geometry::Position;
use ferrocut_toolpath::{Feed, Op, PathMode};
use std::f64::consts::PI;

const FEED: f64 = 9000.0;

fn lines(points: &[(f64, f64)]) -> Vec<Op> {
    points.iter().map(|(x, y)| line(*x, *y, 0.0, FEED, PathMode::Continuous)).collect()
}

fn judged(points: &[(f64, f64)]) -> Run {
    let machine = demo();
    let run = run(&machine, Position::ZERO, &lines(points));
    run.check_limits(&machine);
    run.check_feed();
    let (x, y) = *points.last().unwrap();
    assert_eq!(run.samples.last().unwrap().position, Position::xyz(x, y, 0.0));
    run
}

/// Lines of 10 mm with quarter circles of 1 mm between them, these in steps of this length.
fn round_square(step: f64) -> Vec<(f64, f64)> {
    let mut points = Vec::new();
    let count = (PI / 2.0 / step).ceil() as usize;
    for (k, (x, y)) in [(10.0, 0.0), (11.0, 11.0), (0.0, 12.0), (-1.0, 1.0)].into_iter().enumerate() {
        let (dx, dy) = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)][k];
        points.push((x, y));
        points.extend((1..=count).map(|i| {
            let (sin, cos) = (PI / 2.0 * i as f64 / count as f64).sin_cos();
            (x + dx * sin - dy * (1.0 - cos), y + dy * sin + dx * (1.0 - cos))
        }));
    }
    points
}

/// A wave in steps of this length, in coordinates of so many decimals.
fn wave(step: f64, decimals: i32) -> Vec<(f64, f64)> {
    let scale = 10f64.powi(decimals);
    let round = |c: f64| (c * scale).round() / scale;
    let mut points: Vec<(f64, f64)> = Vec::new();
    let mut x = 0.0_f64;
    while x < 30.0 {
        x += step / (0.75 * (x / 4.0).cos()).hypot(1.0);
        points.push((round(x), round(3.0 * (x / 4.0).sin())));
    }
    points.dedup();
    points
}

#[test]
fn a_curve_in_steps_of_nanometres_ends_and_takes_as_long() {
    let tolerance = demo().path.tolerance;
    let coarse = judged(&round_square(0.02)).time();
    for step in [2e-3, 2e-4, 1e-5] {
        let run = judged(&round_square(step));
        for sample in &run.samples {
            // All of it is 1 mm from a square.
            let [x, y] = [sample.position.0[0], sample.position.0[1]];
            let off = (x - x.clamp(0.0, 10.0)).hypot(y - y.clamp(1.0, 11.0)) - 1.0;
            assert!(off.abs() < tolerance, "steps of {step} mm: {off} mm off at {x} {y}");
        }
        let time = run.time();
        assert!(time < 1.02 * coarse, "steps of {step} mm: {time} s, {coarse} s in steps of 0.02 mm");
    }
}

#[test]
fn a_line_in_steps_of_nanometres_ends_and_takes_as_long() {
    let ends = [(12.0, 0.0), (12.0, 9.0), (0.0, 0.0)];
    let whole = judged(&ends).time();
    for count in [12_000, 200_000] {
        let mut points = Vec::new();
        let (mut x, mut y) = (0.0, 0.0);
        for (a, b) in ends {
            let at = |i: usize| i as f64 / f64::from(count);
            points.extend((1..=count as usize).map(|i| (x + (a - x) * at(i), y + (b - y) * at(i))));
            (x, y) = (a, b);
        }
        let time = judged(&points).time();
        assert!(time < 1.005 * whole, "lines in {count} parts: {time} s, {whole} s as a whole");
    }
}

#[test]
fn rounded_coordinates_of_short_steps_fill_no_look_ahead() {
    let tolerance = demo().path.tolerance;
    let coarse = judged(&wave(0.02, 4)).time();
    for (step, decimals, most) in [(0.002, 3, 1.15), (0.001, 3, 1.25), (0.001, 4, 1.06)] {
        let points = wave(step, decimals);
        let run = judged(&points);
        // Blocks that are told as one may be more than a tag says.
        for sample in &run.samples {
            let [x, y] = [sample.position.0[0], sample.position.0[1]];
            let off = |w: &[(f64, f64)]| {
                let ((ax, ay), (dx, dy)) = (w[0], (w[1].0 - w[0].0, w[1].1 - w[0].1));
                let share = ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy);
                let share = share.clamp(0.0, 1.0);
                (x - ax - share * dx).hypot(y - ay - share * dy)
            };
            let least = points.windows(2).map(off).fold(x.hypot(y), f64::min);
            assert!(least < tolerance, "steps of {step} mm: {least} mm off at {x} {y}");
        }
        let time = run.time();
        assert!(
            time < most * coarse,
            "steps of {step} mm, {decimals} decimals: {time} s, {coarse} s in steps of 0.02 mm"
        );
    }
}

/// A cam around a rotary axis: where X hardly moves, its rounding leaves blocks that turn A alone. They are a part of the curve.
#[test]
fn rounding_does_not_stop_a_rotary_axis() {
    let machine = demo();
    let cam = |to: f64| -> Vec<Op> {
        let op = |k: u32| {
            let angle = 0.3 * f64::from(k);
            let mut p = Position::xyz((5.0 * angle.to_radians().cos() / to).round() * to, 0.0, 0.0);
            p.0[3] = angle;
            Op::Feed { to: p, feed: Feed::PerMinute(3000.0), path: PathMode::Continuous }
        };
        (1..=1200).map(op).collect()
    };
    let start = Position::xyz(5.0, 0.0, 0.0);
    let times = [1e-6, 1e-3].map(|to| {
        let run = run(&machine, start, &cam(to));
        run.check_limits(&machine);
        run.check_feed();
        run.check_path(0.01 + 1e-6);
        assert!(!run.stops_inside(), "{to}");
        run.time()
    });
    // A turns at 50 degrees a second where it is alone, at 90 beside X.
    assert!(times[1] < 1.03 * times[0] && times[0] < 360.0 / 90.0 * 1.1, "{times:?}");
}
