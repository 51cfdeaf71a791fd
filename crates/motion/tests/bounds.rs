//! Times of paths of many kinds against the least that is known, with and without limits of jerk.
//!
//! The bounds were found by two independent programs: without jerk by a time-optimal parameterization of the path and of
//! the smooth path within the tolerance, with jerk by an optimization of path and time together. What is wanted is 1.10
//! of the second and 1.02 of the first; the shares here are those that are reached, and a little more, so that a change
//! that makes one of them slower is seen.
#![allow(clippy::unwrap_used)]

mod common;
use common::*;
use ferrocut_geometry::{Plane, Position};
use ferrocut_machine::Machine;
use ferrocut_toolpath::{Feed, FeedAlong, Op, PathMode};
use std::f64::consts::{PI, TAU};

/// X, Y, Z.
type Point = [f64; 3];

/// A path: its start, feed in mm/min, tolerance in mm and moves.
struct Path {
    start: Point,
    feed: f64,
    tolerance: f64,
    ops: Vec<Op>,
}

impl Path {
    fn new(start: Point, feed: f64, tolerance: f64) -> Path {
        Path { start, feed, tolerance, ops: Vec::new() }
    }

    fn mode(&self) -> PathMode {
        PathMode::ContinuousWithin(self.tolerance)
    }

    fn line(mut self, [x, y, z]: Point) -> Path {
        self.ops.push(line(x, y, z, self.feed, self.mode()));
        self
    }

    /// An arc, its sweep in degrees.
    fn arc(mut self, [x, y, z]: Point, plane: Plane, center: [f64; 2], sweep: f64) -> Path {
        self.ops.push(Op::Arc {
            to: Position::xyz(x, y, z),
            plane,
            center,
            sweep: sweep.to_radians(),
            feed: Feed::PerMinute(self.feed),
            feed_along: FeedAlong::Path,
            path: self.mode(),
        });
        self
    }

    /// Lines through these points, which are in the XY plane and may be rounded to so many decimals.
    fn through(points: &[[f64; 2]], feed: f64, tolerance: f64, decimals: Option<i32>) -> Path {
        let unit = decimals.map(|decimals| 10.0_f64.powi(decimals));
        let rounded = |c: f64| unit.map_or(c, |unit| (c * unit).round_ties_even() / unit);
        let points = points.iter().map(|[x, y]| [rounded(*x), rounded(*y), 0.0]);
        let mut points: Vec<Point> = points.collect();
        points.dedup();
        points[1..].iter().fold(Path::new(points[0], feed, tolerance), |path, point| path.line(*point))
    }
}

/// Corners `side` mm apart at which the way turns by `turn` degrees, begun at `rotation` rad.
fn polygon(sides: usize, side: f64, rotation: f64, turn: f64) -> Vec<[f64; 2]> {
    let mut at = [0.0, 0.0];
    let mut points = vec![at];
    for k in 0..sides {
        let (sin, cos) = (rotation + turn.to_radians() * k as f64).sin_cos();
        at = [at[0] + side * cos, at[1] + side * sin];
        points.push(at);
    }
    points
}

/// A zigzag: how far one leg goes in X and Y.
fn zigzag(legs: usize, [x, y]: [f64; 2]) -> Vec<[f64; 2]> {
    (0..=legs).map(|k| [x * k as f64, y * (k % 2) as f64]).collect()
}

/// Lines of `least` to `most` mm between turns of up to `turn` degrees to either side, all in no order.
fn corners_of_all_kinds([least, most]: [f64; 2], turn: f64) -> Vec<[f64; 2]> {
    let share = |k: u32, step: f64| (f64::from(k) * step).fract();
    let (mut at, mut heading) = ([0.0, 0.0], 0.0_f64);
    let mut points = vec![at];
    for k in 0..24 {
        let len = least + (most - least) * share(k, 0.618_034);
        heading += (turn * (2.0 * share(k, 0.754_877) - 1.0)).to_radians();
        at = [at[0] + len * heading.cos(), at[1] + len * heading.sin()];
        points.push(at);
    }
    points
}

/// A rectangle with rounded corners.
fn rectangle([w, h]: [f64; 2], r: f64, feed: f64, tolerance: f64) -> Path {
    let xy = |x: f64, y: f64| [x, y, 0.0];
    Path::new(xy(r, 0.0), feed, tolerance)
        .line(xy(w - r, 0.0))
        .arc(xy(w, r), Plane::Xy, [w - r, r], 90.0)
        .line(xy(w, h - r))
        .arc(xy(w - r, h), Plane::Xy, [w - r, h - r], 90.0)
        .line(xy(r, h))
        .arc(xy(0.0, h - r), Plane::Xy, [r, h - r], 90.0)
        .line(xy(0.0, r))
        .arc(xy(r, 0.0), Plane::Xy, [r, r], 90.0)
}

/// Points about `step` mm apart along a curve.
fn chords(curve: impl Fn(f64) -> [f64; 2], step: f64, [from, to]: [f64; 2]) -> Vec<[f64; 2]> {
    const FINE: usize = 199_999;
    let at = |i: usize| curve(from + (to - from) * i as f64 / FINE as f64);
    let apart = |a: [f64; 2], b: [f64; 2]| (b[0] - a[0]).hypot(b[1] - a[1]);
    let length: f64 = (0..FINE).map(|i| apart(at(i), at(i + 1))).sum();
    let count = (length / step).round().max(1.0);
    let (mut points, mut gone, mut last) = (vec![at(0)], 0.0, at(0));
    for i in 1..=FINE {
        let (here, before) = (at(i), gone);
        gone += apart(last, here);
        while (points.len() as f64) < count && length * points.len() as f64 / count <= gone {
            let share = (length * points.len() as f64 / count - before) / (gone - before);
            points.push([last[0] + share * (here[0] - last[0]), last[1] + share * (here[1] - last[1])]);
        }
        last = here;
    }
    points.push(at(FINE));
    points
}

/// Rows of `width` mm in lines of `step`, `across` apart, joined by half circles or by square ends.
fn raster(rows: usize, width: f64, across: f64, step: f64, is_round: bool) -> Vec<[f64; 2]> {
    let mut points = vec![[0.0, 0.0]];
    let count = (width / step + 1e-9) as usize;
    for row in 0..rows {
        let y = row as f64 * across;
        let (from, to) = if row % 2 == 0 { (0.0, width) } else { (width, 0.0) };
        points.extend((1..=count).map(|i| [from + (to - from) * i as f64 / count as f64, y]));
        if row + 1 == rows {
            continue;
        }
        if is_round {
            let (side, parts) =
                (if row % 2 == 0 { 1.0 } else { -1.0 }, ((PI * across / 2.0 / step) as usize).max(4));
            points.extend((1..=parts).map(|i| {
                let (sin, cos) = (PI * i as f64 / parts as f64).sin_cos();
                [to + side * across / 2.0 * sin, y + across / 2.0 - across / 2.0 * cos]
            }));
        } else {
            points.push([to, y + across]);
        }
    }
    points
}

/// The path's time on X and Y of 30 m/min, 3000 mm/s² and 60 m/s³ and Z of 18 m/min, 2000 and 40, within the limits and the
/// tolerance and without a stop, or the same without limits of jerk.
fn time(path: &Path, has_jerk: bool) -> f64 {
    let mut machine = Machine::from_toml(Machine::DEMO_MILL).unwrap();
    // Where a period is much of the time it is looked at in parts of it.
    machine.servo_period_ms = 0.25;
    for (i, axis) in machine.axes[..3].iter_mut().enumerate() {
        let (velocity, acceleration, jerk) =
            if i < 2 { (30_000.0, 3000.0, 60_000.0) } else { (18_000.0, 2000.0, 40_000.0) };
        (axis.rapid, axis.velocity, axis.acceleration) = (velocity, velocity, acceleration);
        axis.jerk = if has_jerk { jerk } else { 0.0 };
    }
    let [x, y, z] = path.start;
    let run = run(&machine, Position::xyz(x, y, z), &path.ops);
    run.check_limits(&machine);
    run.check_feed();
    run.check_path(path.tolerance + 1e-6);
    assert!(path.tolerance == 0.0 || !run.stops_inside());
    run.time()
}

/// Judges paths: the name, the path, the bounds without and with limits of jerk, s, and what of them it may take.
fn judge(paths: Vec<(&str, Path, [f64; 2], [f64; 2])>) {
    for (name, path, bounds, most) in paths {
        for (i, kind) in ["acceleration", "jerk"].into_iter().enumerate() {
            let share = time(&path, i == 1) / bounds[i];
            println!("{name}, limits of {kind}: {share:.4}");
            assert!(
                share <= most[i],
                "{name}, limits of {kind}: {share:.4} of the bound, {} allowed",
                most[i]
            );
        }
    }
}

#[test]
fn corners() {
    let poly = |sides, side, rotation, turn, feed, tolerance| {
        Path::through(&polygon(sides, side, rotation, turn), feed, tolerance, None)
    };
    let (sin, cos) = 15.0_f64.to_radians().sin_cos();
    judge(vec![
        ("triangle", poly(3, 60.0, 0.3, 120.0, 12_000.0, 0.01), [1.07756, 1.17353], [1.005, 1.015]),
        ("hexagon", poly(6, 20.0, 0.2, 60.0, 15_000.0, 0.1), [0.84710, 1.03556], [1.005, 1.05]),
        ("slow hexagon", poly(6, 1.0, 0.2, 60.0, 100.0, 0.02), [3.55823, 3.55635], [1.02, 1.03]),
        ("small octagon", poly(8, 2.0, 0.4, 45.0, 12_000.0, 0.02), [0.31713, 0.53148], [0.94, 1.065]),
        (
            "small nonagon within 50 um",
            poly(9, 2.0, 0.3, 40.0, 12_000.0, 0.05),
            [0.26456, 0.45910],
            [0.98, 1.07],
        ),
        ("star", poly(5, 40.0, 0.1, 144.0, 10_000.0, 0.001), [1.44968, 1.59271], [1.005, 1.015]),
        ("star within 50 um", poly(5, 40.0, 0.1, 144.0, 10_000.0, 0.05), [1.44648, 1.50424], [1.005, 1.015]),
        (
            "zigzag of 90 degrees",
            Path::through(&zigzag(30, [2.828, 2.828]), 6000.0, 0.005, None),
            [1.90481, 3.23559],
            [1.005, 1.01],
        ),
        (
            "zigzag of 30 degrees",
            Path::through(&zigzag(24, [10.0 * cos, 10.0 * sin]), 20_000.0, 0.05, None),
            [2.08540, 2.83742],
            [0.9, 1.01],
        ),
        (
            "zigzag of 127 degrees",
            Path::through(&zigzag(24, [2.0, 4.0]), 12_000.0, 0.02, None),
            [1.748_886, 2.25913],
            [1.01, 1.05],
        ),
        (
            "zigzag of right angles, too short for swings",
            Path::through(&zigzag(20, [2.0, 2.0]), 12_000.0, 0.07, None),
            [1.001_994, 1.478_651],
            [1.005, 1.06],
        ),
        (
            "zigzag of right angles within 50 um",
            Path::through(&zigzag(20, [2.0, 2.0]), 12_000.0, 0.05, None),
            [1.011_583, 1.485_508],
            [1.005, 1.085],
        ),
        (
            "larger zigzag of right angles within 50 um",
            Path::through(&zigzag(20, [3.0, 3.0]), 12_000.0, 0.05, None),
            [1.248_409, 1.763_582],
            [1.005, 1.065],
        ),
        (
            "zigzag of 53 degrees within 50 um",
            Path::through(&zigzag(20, [4.0, 2.0]), 12_000.0, 0.05, None),
            [1.243_354, 1.746_269],
            [0.93, 1.07],
        ),
        (
            "zigzag in space",
            (1..=24).fold(Path::new([0.0; 3], 9000.0, 0.02), |path, k| {
                let turned = f64::from(k % 2);
                path.line([2.0 * f64::from(k), 5.0 * turned, 3.0 * turned])
            }),
            [1.957_716, 2.43546],
            [1.02, 1.05],
        ),
        (
            "fine zigzag",
            Path::through(&zigzag(60, [0.25, 0.433]), 12_000.0, 0.01, None),
            [1.41593, 2.64299],
            [1.005, 1.025],
        ),
        (
            "zigzag of exact points",
            Path::through(&zigzag(12, [0.5, 4.0]), 12_000.0, 0.0, None),
            [0.87636, 1.54478],
            [1.02, 1.01],
        ),
    ]);
}

#[test]
fn corners_in_no_order() {
    let of = |lengths, turn, feed, tolerance| {
        Path::through(&corners_of_all_kinds(lengths, turn), feed, tolerance, None)
    };
    judge(vec![
        ("corners of all kinds", of([2.0, 14.0], 160.0, 12_000.0, 0.02), [1.990_199, 2.70639], [1.005, 1.12]),
        ("the same, small", of([0.5, 5.0], 150.0, 6000.0, 0.01), [1.148_799, 1.793_144], [1.0, 1.148]),
        (
            "corners of up to 120 degrees",
            of([1.0, 6.0], 120.0, 12_000.0, 0.05),
            [1.152_425, 1.577_164],
            [0.95, 1.106],
        ),
        (
            "corners of up to 60 degrees",
            of([2.0, 14.0], 60.0, 12_000.0, 0.02),
            [1.703_058, 2.544_797],
            [0.945, 1.07],
        ),
        (
            "corners of up to 45 degrees",
            of([3.0, 20.0], 45.0, 15_000.0, 0.05),
            [1.741_871, 2.360_028],
            [0.93, 1.06],
        ),
    ]);
}

#[test]
fn arcs() {
    let xy = |x: f64, y: f64| [x, y, 0.0];
    let circle = |r: f64, feed: f64, sweep: f64| {
        Path::new([0.0; 3], feed, 0.0).arc([0.0; 3], Plane::Xy, [r, 0.0], sweep)
    };
    judge(vec![
        ("circle of R1", circle(1.0, 6000.0, -360.0), [0.130_773, 0.221_703], [1.02, 1.03]),
        ("circle of R0.2", circle(0.2, 3000.0, 360.0), [0.058_548, 0.129_873], [1.02, 1.03]),
        (
            "S of two half circles",
            Path::new([0.0; 3], 12_000.0, 0.01).arc(xy(20.0, 0.0), Plane::Xy, [10.0, 0.0], -180.0).arc(
                xy(40.0, 0.0),
                Plane::Xy,
                [30.0, 0.0],
                180.0,
            ),
            [0.41254, 0.53408],
            [1.015, 1.045],
        ),
        (
            "half circles of three radii",
            Path::new([0.0; 3], 9000.0, 0.02)
                .arc(xy(20.0, 0.0), Plane::Xy, [10.0, 0.0], -180.0)
                .arc(xy(14.0, 0.0), Plane::Xy, [17.0, 0.0], -180.0)
                .arc(xy(26.0, 0.0), Plane::Xy, [20.0, 0.0], -180.0),
            [0.49610, 0.57305],
            [1.02, 1.045],
        ),
        (
            "helix about Y",
            Path::new([0.0; 3], 12_000.0, 0.0).arc([0.0, 100.0, 0.0], Plane::Zx, [5.0, 0.0], 1800.0),
            [1.46678, 1.62771],
            [1.025, 1.02],
        ),
        (
            "helix about X",
            Path::new([0.0; 3], 30_000.0, 0.0).arc([15.0, 0.0, 0.0], Plane::Yz, [20.0, 0.0], -1080.0),
            [1.83192, 1.90793],
            [1.01, 1.015],
        ),
        ("corners of R5", rectangle([40.0, 25.0], 5.0, 15_000.0, 0.02), [0.74840, 0.89518], [1.025, 1.065]),
        (
            "corners of R1",
            rectangle([30.0, 20.0], 1.0, 12_000.0, 0.02).line(xy(15.0, 0.0)),
            [0.849_160, 0.929_416],
            [1.01, 1.085],
        ),
        (
            "corners of R0.5",
            rectangle([30.0, 20.0], 0.5, 12_000.0, 0.02).line(xy(15.0, 0.0)),
            [0.871_728, 0.956_929],
            [1.01, 1.07],
        ),
        ("corners of R20", rectangle([80.0, 50.0], 20.0, 30_000.0, 0.005), [0.91114, 1.23829], [1.025, 1.05]),
    ]);
}

#[test]
fn curves() {
    let of = |curve: &dyn Fn(f64) -> [f64; 2], step: f64, to: f64, feed: f64, tolerance: f64| {
        Path::through(&chords(curve, step, [0.0, to]), feed, tolerance, Some(3))
    };
    let circle = |r: f64| move |u: f64| [r * u.cos(), r * u.sin()];
    judge(vec![
        ("circle of R5", of(&circle(5.0), 0.05, TAU, 6000.0, 0.005), [0.41600, 0.40322], [0.86, 1.025]),
        (
            "circle of R200",
            of(&circle(200.0), 5.0, 1.5 * PI, 24_000.0, 0.02),
            [2.48897, 2.53910],
            [1.005, 1.005],
        ),
        (
            "ellipse",
            of(&|u| [20.0 * u.cos(), 5.0 * u.sin()], 0.3, TAU, 12_000.0, 0.005),
            [0.56692, 0.65419],
            [0.99, 0.98],
        ),
        (
            "spiral",
            of(&|u| [(1.0 + 0.4 * u) * u.cos(), (1.0 + 0.4 * u) * u.sin()], 0.2, 6.0 * PI, 9000.0, 0.01),
            [0.76541, 0.86404],
            [1.015, 1.035],
        ),
        (
            "sine",
            of(&|u| [u, 2.0 * (TAU * u / 8.0).sin()], 0.1, 40.0, 12_000.0, 0.003),
            [0.76198, 1.01245],
            [1.01, 1.05],
        ),
        (
            "trochoid",
            of(&|u| [2.0 * u.cos() + 0.8 * u / TAU, 2.0 * u.sin()], 0.1, 8.0 * PI, 8000.0, 0.01),
            [0.67022, 0.84579],
            [1.01, 1.04],
        ),
    ]);
}

/// Rows over a wavy surface in lines far shorter than what joins the rows; coordinates of 4 decimals, so that some of them are one.
fn fine_rows() -> Path {
    const LINES: usize = 320;
    let place = |row: usize, k: usize| {
        let along = 32.03 * k as f64 / LINES as f64;
        let (x, y) = (if row.is_multiple_of(2) { along } else { 32.03 - along }, 0.5 * row as f64);
        [x, y, 2.0 * (0.1 * x).sin() * (0.07 * y).cos()].map(|c| (c * 1e4).round_ties_even() / 1e4)
    };
    let rows = (0..4).flat_map(|row| (0..=LINES).map(move |k| place(row, k)));
    rows.skip(1).fold(Path::new([0.0; 3], 6000.0, 0.01), Path::line)
}

#[test]
fn rasters() {
    let of = |points: &[[f64; 2]]| Path::through(points, 12_000.0, 0.01, Some(3));
    judge(vec![
        ("raster of fine blocks", fine_rows(), [1.478_395, 1.663_622], [1.01, 1.04]),
        ("raster with half circles", of(&raster(8, 25.0, 1.5, 0.2, true)), [1.64232, 1.91046], [1.0, 1.075]),
        (
            "raster with square ends",
            of(&raster(10, 25.0, 0.4, 0.5, false)),
            [2.05385, 2.51812],
            [1.025, 1.05],
        ),
    ]);
}
