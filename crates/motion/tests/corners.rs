//! Which corners are stopped at, slowed down for or run through, measured in setpoints (G61 to G64, corners by angle
//! and by speed difference, arcs by their acceleration).
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{Event, Run, arc, demo, line, round_machine, run, run_with};
use ferrocut_geometry::{Plane, Position};
use ferrocut_machine::{ArcSlowdown, CornerSlowdown, Machine};
use ferrocut_motion::{Motion, Move};
use ferrocut_toolpath::{CornerRule, Feed, FeedAlong, InnerCorners, Op, PathMode};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

const GO: PathMode = PathMode::Continuous;

/// G62 with the tool on the left; corners of up to 100° slow down to 120 mm/min.
const INNER: InnerCorners =
    InnerCorners { plane: Plane::Xy, left: true, rule: CornerRule::Angle(100.0), lowest_feed: 120.0 };
const SLOW: f64 = 2.0;

fn distance(a: Position, b: Position) -> f64 {
    (a - b).0.iter().map(|c| c * c).sum::<f64>().sqrt()
}

/// Speeds at the samples of moves `tags` whose distance from `p` is in a range, with the lowest and the highest.
fn speeds(run: &Run, p: Position, from: f64, to: f64, tags: &[u64]) -> [f64; 2] {
    let near = |s: &&ferrocut_motion::Setpoint| {
        let d = distance(s.position, p);
        d >= from && d <= to && tags.contains(&s.tag) && s.velocity > 0.0
    };
    let found: Vec<f64> = run.samples.iter().filter(near).map(|s| s.velocity).collect();
    assert!(!found.is_empty(), "no sample is {from} to {to} mm from {p:?}");
    [found.iter().fold(f64::INFINITY, |m, v| m.min(*v)), found.iter().fold(0.0, |m, v| m.max(*v))]
}

fn judged(machine: &Machine, ops: &[Op]) -> Run {
    let run = run(machine, Position::ZERO, ops);
    run.check_limits(machine);
    run.check_feed();
    run.check_path(machine.path.tolerance * 1.001);
    run
}

/// 30 mm along X and then 30 mm in a direction that turns by `turn` degrees to the left.
fn corner(turn: f64, path: PathMode) -> [Op; 2] {
    let (sin, cos) = turn.to_radians().sin_cos();
    [line(30.0, 0.0, 0.0, 6000.0, path), line(30.0 + 30.0 * cos, 30.0 * sin, 0.0, 6000.0, path)]
}

const VERTEX: Position = Position([30.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);

#[test]
fn inner_corners_are_slowed_down_for_a_millimetre_on_either_side() {
    let machine = round_machine();
    let slow = judged(&machine, &corner(90.0, PathMode::InnerCorners(INNER)));
    assert!(speeds(&slow, VERTEX, 0.0, 1.0, &[0, 1])[1] <= SLOW * 1.0001);
    // Further away only what slowing down takes: from 2 mm/s a ramp of 1 mm reaches 20 mm/s.
    for tag in [0, 1] {
        assert!(speeds(&slow, VERTEX, 2.0, 3.0, &[tag])[0] > 20.0);
        assert!(speeds(&slow, VERTEX, 10.0, 20.0, &[tag])[1] > 99.0);
    }
    // On the outside, or where the angle is wider than the critical one, nothing changes.
    for (turn, corners) in [
        (-90.0, INNER),
        (79.0, INNER),
        (90.0, InnerCorners { left: false, ..INNER }),
        (90.0, InnerCorners { rule: CornerRule::Angle(89.0), ..INNER }),
    ] {
        let plain = judged(&machine, &corner(turn, GO)).time();
        let same = judged(&machine, &corner(turn, PathMode::InnerCorners(corners))).time();
        assert!((same - plain).abs() < 1e-9, "{turn}: {plain} {same}");
    }
    // To the right with the tool on the right.
    let right =
        judged(&machine, &corner(-90.0, PathMode::InnerCorners(InnerCorners { left: false, ..INNER })));
    assert!((right.time() - slow.time()).abs() < 1e-9);
}

#[test]
fn a_block_without_inner_corners_beside_the_corner_is_run_as_ever() {
    let machine = round_machine();
    // The second block is one of G40 or G41 (GSK990MC 4.8.2, limit 2).
    let [first, _] = corner(90.0, PathMode::InnerCorners(INNER));
    let [_, second] = corner(90.0, GO);
    let plain = judged(&machine, &corner(90.0, GO)).time();
    assert!((judged(&machine, &[first, second]).time() - plain).abs() < 1e-9);
}

#[test]
fn inner_corners_of_short_blocks_and_arcs_are_slowed_down_for() {
    let machine = round_machine();
    let path = PathMode::InnerCorners(INNER);
    // Blocks of 0.2 mm to the vertex and away from it: of each the whole, and no more.
    let mut ops: Vec<Op> = (1..=100).map(|k| line(0.2 * f64::from(k), 0.0, 0.0, 1500.0, path)).collect();
    ops.extend((1..=100).map(|k| line(20.0, 0.2 * f64::from(k), 0.0, 1500.0, path)));
    let run = judged(&machine, &ops);
    let vertex = Position::xyz(20.0, 0.0, 0.0);
    assert!(speeds(&run, vertex, 0.0, 0.1, &[99, 100])[1] <= SLOW * 1.0001);
    assert!(speeds(&run, vertex, 3.0, 10.0, &(20..180).collect::<Vec<_>>())[1] > 24.9);
    // A line that runs into an arc turning by 90° to the left at the vertex, and one out of it.
    let into = |path| {
        let mut around = arc(Position::xyz(20.0, 20.0, 0.0), [10.0, 10.0], FRAC_PI_2, 1500.0);
        if let Op::Arc { to, center, sweep, path: mode, .. } = &mut around {
            // From (20, 0) up, about (30, 0): it begins in the direction +Y.
            (*to, *center, *sweep, *mode) = (Position::xyz(30.0, 10.0, 0.0), [30.0, 0.0], -FRAC_PI_2, path);
        }
        [line(20.0, 0.0, 0.0, 1500.0, path), around, line(30.0, 30.0, 0.0, 1500.0, path)]
    };
    let run = judged(&machine, &into(path));
    for vertex in [vertex, Position::xyz(30.0, 10.0, 0.0)] {
        assert!(speeds(&run, vertex, 0.0, 0.99, &[0, 1, 2])[1] <= SLOW * 1.0001);
    }
    assert!(speeds(&run, vertex, 5.0, 7.0, &[1])[1] > 24.9);
}

#[test]
fn inner_corners_by_speed_difference_are_as_slow_as_the_axes_ask_for() {
    let machine = round_machine();
    let rule = CornerRule::SpeedDifference(300.0);
    let path = PathMode::InnerCorners(InnerCorners { rule, ..INNER });
    // 5 mm/s where both axes change by all of it; the corner itself takes less than 0.3 mm on either side.
    let run = judged(&machine, &corner(90.0, path));
    let [low, high] = speeds(&run, VERTEX, 0.3, 0.9, &[0, 1]);
    assert!(low > 4.9 && high <= 5.0005, "{low} {high}");
}

#[test]
fn inner_corners_of_a_machine_that_stops_everywhere_stop_at_ends_of_blocks_alone() {
    let mut machine = round_machine();
    machine.path.exact_stop = true;
    let run = judged(&machine, &corner(90.0, PathMode::InnerCorners(INNER)));
    assert!(speeds(&run, VERTEX, 0.0, 1.0, &[0, 1])[1] <= SLOW * 1.0001);
    let rests = |s: &&ferrocut_motion::Setpoint| s.velocity == 0.0 && distance(s.position, VERTEX) > 1e-9;
    let ends = [Position::ZERO, Position::xyz(30.0, 30.0, 0.0)];
    let mut rests = run.samples.iter().filter(rests).map(|s| s.position);
    assert!(rests.all(|p| ends.iter().any(|end| distance(p, *end) < 1e-9)));
    assert!(run.rests_on(VERTEX));
}

#[test]
fn inner_corners_are_overridden_like_any_feed() {
    let machine = round_machine();
    let ops = corner(90.0, PathMode::InnerCorners(INNER));
    let run = run_with(&machine, Position::ZERO, &ops, &[(0, Event::Override(0.5, 1.0))], &[]);
    assert!(speeds(&run, VERTEX, 0.0, 1.0, &[0, 1])[1] <= 0.5 * SLOW * 1.0001);
}

#[test]
fn exact_stops_rest_and_continuous_paths_do_not() {
    let machine = round_machine();
    let stopped = judged(&machine, &corner(90.0, PathMode::ExactStop));
    assert!(stopped.rests_on(VERTEX) && stopped.stops_inside());
    let through = judged(&machine, &corner(90.0, GO));
    assert!(!through.stops_inside(), "{}", at_vertex(&through));
    assert!(through.time() < stopped.time(), "{} {}", through.time(), stopped.time());
    // Straight on the speed does not fall at all, under G63 neither.
    for path in [GO, PathMode::Tapping] {
        let straight = judged(&machine, &corner(0.0, path));
        let [low, high] = speeds(&straight, VERTEX, 0.0, 5.0, &[0, 1]);
        assert!(low > 99.99 && high < 100.01, "{path:?}: {low} {high}");
    }
}

#[test]
fn under_g63_neither_override_nor_hold_has_an_effect() {
    let machine = round_machine();
    let tapping = corner(0.0, PathMode::Tapping);
    let free = run(&machine, Position::ZERO, &tapping);
    let events = [(0, Event::Override(0.3, 0.3)), (100, Event::Hold), (200, Event::Override(0.0, 0.0))];
    let held = run_with(&machine, Position::ZERO, &tapping, &events, &[]);
    for (a, b) in free.samples.iter().zip(&held.samples) {
        assert!(distance(a.position, b.position) < 1e-9 && (a.velocity - b.velocity).abs() < 1e-6);
    }
    // What follows is held.
    let mut ops = tapping.to_vec();
    ops.push(line(90.0, 0.0, 0.0, 6000.0, GO));
    let events = [(100, Event::Hold), (3000, Event::Resume)];
    let run = run_with(&machine, Position::ZERO, &ops, &events, &[]);
    let at_hold = run.samples[2900];
    assert!(at_hold.velocity == 0.0 && at_hold.position.0[0] >= 60.0, "{at_hold:?}");
    assert_eq!(run.samples.last().unwrap().position, Position::xyz(90.0, 0.0, 0.0));
}

/// A hold or an override of 0 shortly before a thread stops before it or behind it, never inside it.
#[test]
fn nothing_rests_inside_a_thread_that_it_was_asked_for_before() {
    let machine = round_machine();
    let ops = [
        line(30.0, 0.0, 0.0, 6000.0, GO),
        line(60.0, 0.0, 0.0, 3000.0, PathMode::Tapping),
        line(90.0, 0.0, 0.0, 6000.0, GO),
    ];
    let free = run(&machine, Position::ZERO, &ops);
    let enters = free.samples.iter().position(|s| s.position.0[0] > 30.0).unwrap();
    let mut rests = [0, 0];
    for tick in enters - 200..enters {
        for (stop, go) in
            [(Event::Hold, Event::Resume), (Event::Override(0.0, 0.0), Event::Override(1.0, 1.0))]
        {
            let events = [(tick, stop), (tick + 3000, go)];
            let held = run_with(&machine, Position::ZERO, &ops, &events, &[]);
            let rest = held.samples[tick + 2990];
            let x = rest.position.0[0];
            assert!(rest.velocity == 0.0 && (x <= 30.0 || x >= 60.0), "{tick}: {x} at {}", rest.velocity);
            rests[usize::from(x >= 60.0)] += 1;
        }
    }
    assert!(rests[0] > 100 && rests[1] > 10, "{rests:?}");
}

/// A thread that the spindle feeds rests where the spindle does.
#[test]
fn a_thread_per_revolution_waits_for_its_spindle() {
    let op = Op::Feed {
        to: Position::xyz(0.0, 0.0, -30.0),
        feed: Feed::PerRevolution(1.0),
        path: PathMode::Tapping,
    };
    let mut motion = Motion::new(&round_machine(), Position::ZERO);
    motion.set_spindle(1000.0);
    motion.push(&Move::from_step(&op, Position::ZERO, 1000.0, 1).unwrap()).unwrap();
    motion.finish();
    let wait = |motion: &mut Motion, n: usize| (0..n).map(|_| motion.tick()).last().unwrap();
    assert!((wait(&mut motion, 500).velocity - 1000.0 / 60.0).abs() < 1e-6);
    motion.set_spindle(0.0);
    let rest = wait(&mut motion, 500);
    assert_eq!((rest.velocity, wait(&mut motion, 500).position), (0.0, rest.position));
    motion.set_spindle(1000.0);
    assert_eq!(wait(&mut motion, 3000).position, Position::xyz(0.0, 0.0, -30.0));
}

/// Of the sample at the vertex: its speed.
fn at_vertex(run: &Run) -> f64 {
    let near = |a: &&ferrocut_motion::Setpoint, b: &&ferrocut_motion::Setpoint| {
        distance(a.position, VERTEX).total_cmp(&distance(b.position, VERTEX))
    };
    run.samples.iter().min_by(near).unwrap().velocity
}

fn with_corners(angle: Option<f64>, speed_difference: Option<f64>, lowest_feed: f64) -> Machine {
    let mut machine = round_machine();
    machine.path.tolerance = 0.05;
    machine.path.corner = Some(CornerSlowdown { angle, speed_difference, lowest_feed });
    machine
}

#[test]
fn corners_by_angle_are_run_at_the_lowest_feed() {
    // A turn by 60° leaves an angle of 120°.
    let natural = at_vertex(&judged(&with_corners(Some(119.9), None, 300.0), &corner(60.0, GO)));
    assert!(natural > 10.0, "{natural}");
    let slow = at_vertex(&judged(&with_corners(Some(120.0), None, 300.0), &corner(60.0, GO)));
    assert!(slow <= 5.0005 && slow > 3.0, "{slow}");
    // No more than the lowest feed, which may be more than the corner allows.
    let same = at_vertex(&judged(&with_corners(Some(120.0), None, 6000.0), &corner(60.0, GO)));
    assert_eq!(same, natural);
}

#[test]
fn corners_by_speed_difference_keep_the_steps_of_every_axis() {
    // A turn by 60° changes X by a half of the speed and Y by 0.866 of it: 4 mm/s are 4.62.
    let slow = at_vertex(&judged(&with_corners(None, Some(240.0), 60.0), &corner(60.0, GO)));
    assert!(slow <= 4.0 / 0.75_f64.sqrt() * 1.0001 && slow > 2.7, "{slow}");
    // Small turns are slowed down for where the feed asks for it: 0.0349 of 100 mm/s in Y.
    let slow = at_vertex(&judged(&with_corners(None, Some(60.0), 60.0), &corner(2.0, GO)));
    let most = 1.0 / 2.0_f64.to_radians().sin();
    assert!(slow <= most * 1.0001 && slow > 0.9 * most, "{slow} {most}");
    // Never below the lowest feed.
    let slow = at_vertex(&judged(&with_corners(None, Some(60.0), 600.0), &corner(60.0, GO)));
    assert!(slow > 6.0 && slow <= 10.001, "{slow}");
}

#[test]
fn corners_of_short_blocks_are_no_smooth_run_where_the_rule_counts_them() {
    // 36 sides of a polygon turn by 10° each.
    let polygon: Vec<Op> = (1..=36)
        .map(|k| (f64::from(k) / 36.0 * TAU).sin_cos())
        .map(|(sin, cos)| line(10.0 * cos - 10.0, 10.0 * sin, 0.0, 3000.0, GO))
        .collect();
    let plain = judged(&with_corners(Some(169.0), None, 120.0), &polygon);
    let slow = judged(&with_corners(Some(170.5), None, 120.0), &polygon);
    for op in &polygon[..35] {
        let vertex = *op.target().unwrap();
        let near = slow.samples.iter().map(|s| (distance(s.position, vertex), s.velocity));
        let (_, v) = near.min_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
        assert!(v <= SLOW * 1.001, "{v}");
    }
    assert!(slow.time() > plain.time() + 36.0 * 0.02);
}

#[test]
fn arcs_keep_an_acceleration_towards_their_centre() {
    let mut machine = round_machine();
    let circle = |feed| [arc(Position::ZERO, [10.0, 0.0], TAU, feed)];
    let top = |machine: &Machine, feed: f64, over: f64| {
        let events = [(0, Event::Override(over, 1.0))];
        let run = run_with(machine, Position::ZERO, &circle(feed), &events, &[]);
        run.samples.iter().fold(0.0, |m: f64, s| m.max(s.velocity))
    };
    assert!(top(&machine, 6000.0, 1.0) > 99.9);
    // v² = 250·10; no override passes it.
    machine.path.arc = Some(ArcSlowdown { acceleration: 250.0, lowest_feed: 0.0 });
    for over in [1.0, 2.0] {
        let v = top(&machine, 6000.0, over);
        assert!(v > 49.9 && v <= 50.001, "{over}: {v}");
    }
    assert!((top(&machine, 1200.0, 1.0) - 20.0).abs() < 0.01);
    // Not below the lowest feed.
    machine.path.arc = Some(ArcSlowdown { acceleration: 250.0, lowest_feed: 4200.0 });
    let v = top(&machine, 6000.0, 1.0);
    assert!(v > 69.9 && v <= 70.001, "{v}");
}

#[test]
fn arcs_so_short_that_they_are_smoothed_keep_it_too() {
    let mut machine = round_machine();
    // A fillet of 0.5 mm between two lines.
    let r = 0.5;
    let ops = |feed| {
        let fillet = arc(Position::xyz(30.0 + r, r, 0.0), [30.0, r], FRAC_PI_2, feed);
        [line(30.0, 0.0, 0.0, feed, GO), fillet, line(30.0 + r, 30.0, 0.0, feed, GO)]
    };
    let on_fillet = |machine: &Machine, over: f64| {
        let events = [(0, Event::Override(over, 1.0))];
        let run = run_with(machine, Position::ZERO, &ops(6000.0), &events, &[]);
        assert!(!run.stops_inside());
        let is_on = |p: &Position| p.0[0] > 30.0 && p.0[1] < r;
        let pairs = run.samples.windows(2).filter(|w| w.iter().all(|s| is_on(&s.position)));
        let period = machine.servo_period_ms / 1000.0;
        let on: Vec<f64> = pairs.map(|w| w[0].position.distance(w[1].position) / period).collect();
        assert!(on.len() > 5, "{}", on.len());
        // The lines beside it are run as they were.
        assert!(run.samples.iter().any(|s| s.velocity > 80.0));
        on.into_iter().fold(0.0, f64::max)
    };
    assert!(on_fillet(&machine, 1.0) > 12.0);
    // v² = 200·0.5.
    machine.path.arc = Some(ArcSlowdown { acceleration: 200.0, lowest_feed: 0.0 });
    for over in [1.0, 2.0] {
        let v = on_fillet(&machine, over);
        assert!(v > 9.9 && v <= 10.001, "{over}: {v}");
    }
}

#[test]
fn sharp_corners_beside_arcs_are_rounded_within_the_tolerance() {
    let way = |angle: f64, len: f64| {
        let (sin, cos) = angle.to_radians().sin_cos();
        Position::xyz(len * cos, len * sin, 0.0)
    };
    for jerk in [50_000.0, 0.0] {
        let mut machine = round_machine();
        for axis in &mut machine.axes {
            axis.jerk = jerk;
        }
        for (r, feed) in [(10.0, 6000.0), (10.0, 600.0), (1.0, 3000.0), (0.2, 3000.0)] {
            // A half circle to the left that goes to `angle` begins at right angles to that and ends the other way: from
            // the line by 90°, to the next by 60°, to the last line by 100°.
            let half = |from: Position, angle: f64| {
                let center = from + way(angle, r);
                arc(from + way(angle, 2.0 * r), [center.0[0], center.0[1]], PI, feed)
            };
            let first = half(VERTEX, 0.0);
            let second = half(*first.target().unwrap(), 120.0);
            let end = *second.target().unwrap() + way(310.0, 30.0);
            let ops =
                [line(30.0, 0.0, 0.0, feed, GO), first, second, line(end.0[0], end.0[1], 0.0, feed, GO)];
            let rounded = judged(&machine, &ops);
            assert!(!rounded.stops_inside(), "jerk {jerk} radius {r} F{feed}");
            // Small arcs are smoothed as the lines that they nearly are; the others are no slower than with stops.
            if r < 10.0 {
                continue;
            }
            let mut exact = machine.clone();
            exact.path.exact_stop = true;
            let stopped = run(&exact, Position::ZERO, &ops);
            assert!(stopped.stops_inside());
            assert!(rounded.time() <= stopped.time() + 0.001, "{} {}", rounded.time(), stopped.time());
        }
    }
}

/// A corner is of both of its moves: it is no rounder than the stricter of them lets it be (G64 P0.3 and then P0.005, G61).
#[test]
fn a_corner_between_two_tolerances_keeps_the_lesser() {
    let machine = round_machine();
    let within = PathMode::ContinuousWithin;
    for [first, second] in [[0.3, 0.005], [0.005, 0.3], [0.3, 0.0], [0.0, 0.3]] {
        let to = Position::xyz(60.0, 30.0, 0.0);
        let mut round = arc(to, [60.0, 0.0], -FRAC_PI_2, 6000.0);
        if let Op::Arc { path, .. } = &mut round {
            *path = within(second);
        }
        let straight = line(30.0, 30.0, 0.0, 6000.0, within(second));
        for next in [straight, round] {
            let ops = [line(30.0, 0.0, 0.0, 6000.0, within(first)), next];
            let run = run(&machine, Position::ZERO, &ops);
            run.check_limits(&machine);
            // What is left of a round move is as its own tolerance lets it be; its corner is as exact as the line.
            run.check_path_within(|number| [first, second][number.min(1)] + 1e-6);
            if matches!(run.ops[1], Op::Feed { .. }) {
                run.check_path(first.min(second) + 1e-6);
            }
            assert_eq!(run.stops_inside(), first.min(second) == 0.0, "{first} {second}");
        }
    }
}

#[test]
fn a_tangent_arc_is_met_on_the_path_where_nothing_may_be_left() {
    let machine = round_machine();
    let mode = PathMode::ContinuousWithin(0.0);
    let ops = [
        line(20.0, 0.0, 0.0, 3000.0, mode),
        Op::Arc {
            to: Position::xyz(25.0, 5.0, 0.0),
            plane: Plane::Xy,
            center: [20.0, 5.0],
            sweep: FRAC_PI_2,
            feed: Feed::PerMinute(3000.0),
            feed_along: FeedAlong::Path,
            path: mode,
        },
        line(25.0, 25.0, 0.0, 3000.0, mode),
    ];
    let run = run(&machine, Position::ZERO, &ops);
    run.check_limits(&machine);
    run.check_path(1e-9);
}

#[test]
fn positioning_runs_on_into_cutting_within_its_tolerance() {
    let machine = round_machine();
    let rapid = |x: f64, y: f64, z: f64, path: PathMode| Op::Rapid {
        to: Position::xyz(x, y, z),
        straight: true,
        speed: None,
        path,
    };
    for (path, stops) in [
        (PathMode::ContinuousWithin(0.05), false),
        (PathMode::ON_PATH, true),
        (PathMode::ContinuousWithin(0.0), true),
    ] {
        let ops = [
            rapid(30.0, 0.0, 0.0, path),
            line(30.0, 20.0, 0.0, 3000.0, path),
            line(30.0, 30.0, 5.0, 3000.0, path),
            rapid(0.0, 30.0, 5.0, path),
        ];
        let run = run(&machine, Position::ZERO, &ops);
        run.check_limits(&machine);
        run.check_feed();
        run.check_path(0.05 + 1e-6);
        assert_eq!(run.stops_inside(), stops, "{path:?}");
    }
}

/// Rows of 25 mm on the demo mill, joined by lines of so much.
fn rows(across: f64, tolerance: f64) -> Vec<Op> {
    let (mode, feed) = (PathMode::ContinuousWithin(tolerance), 12_000.0);
    let mut ops = Vec::new();
    for row in 0..6 {
        let (x, y) = (if row % 2 == 0 { 25.0 } else { 0.0 }, f64::from(row) * across);
        ops.extend([line(x, y, 0.0, feed, mode), line(x, y + across, 0.0, feed, mode)]);
    }
    ops.pop();
    ops
}

#[test]
fn a_short_line_between_rows_costs_no_stop() {
    let mut machine = demo();
    // What X may.
    let (a, j, v) = (2000.0, 50_000.0, 10_000.0 / 60.0);
    for (across, tolerance) in [(0.2, 0.01), (0.4, 0.01), (0.4, 0.05), (0.8, 0.2)] {
        machine.path.tolerance = tolerance;
        let run = judged(&machine, &rows(across, tolerance));
        assert!(!run.stops_inside());
        // Rows from rest to rest, and what the short lines take beyond what both their ends overlap.
        let row = 25.0 / v + v / a + a / j;
        let reach = (8.0 * tolerance / 2.0_f64.sqrt()).min(0.4 * across);
        let end = 4.0 * (across / (2.0 * j)).cbrt() - 2.0 * (6.0 * reach / j).cbrt();
        let least = 6.0 * row + 5.0 * end;
        assert!(run.time() < 1.015 * least, "{across} within {tolerance}: {} s, of {least} s", run.time());
    }
}

#[test]
fn rows_are_held_and_overridden_at_any_instant() {
    let machine = demo();
    let ops = rows(0.4, 0.01);
    let plain = judged(&machine, &ops);
    for tick in (40..plain.samples.len() - 20).step_by(7) {
        let events = [
            (tick, Event::Hold),
            (tick + 400, Event::Override(0.05 + 0.1 * (tick % 15) as f64, 1.0)),
            (tick + 401, Event::Resume),
        ];
        let run = run_with(&machine, Position::ZERO, &ops, &events, &[]);
        run.check_limits(&machine);
        run.check_path(0.01 + 1e-6);
        assert_eq!(run.samples.last().unwrap().position, *ops.last().unwrap().target().unwrap());
        let held = &run.samples[tick + 399];
        assert!(held.velocity == 0.0, "held at {tick}: {held:?}");
    }
}

/// Legs so short that the path cannot be stopped between two corners: it goes on through them, slower each time.
#[test]
fn short_zigzags_are_held_and_overridden_at_any_instant() {
    let mut machine = demo();
    for (x, y, tolerance) in [(4.0, 2.0, 0.05), (2.0, 2.0, 0.05), (1.0, 4.0, 0.02), (3.0, 1.0, 0.02)] {
        machine.path.tolerance = tolerance;
        let mode = PathMode::ContinuousWithin(tolerance);
        let ops: Vec<Op> =
            (1..=24).map(|k| line(x * f64::from(k), y * f64::from(k % 2), 0.0, 12_000.0, mode)).collect();
        let plain = judged(&machine, &ops);
        assert!(!plain.stops_inside());
        let (mut longest, mut slowest) = (0, 0);
        for tick in (20..plain.samples.len() - 20).step_by(11) {
            // Held until it rests, and on with a lower override, in the midst too.
            let share = 0.1 + 0.1 * (tick % 8) as f64;
            let events =
                [(tick, Event::Hold), (tick + 500, Event::Resume), (tick + 540, Event::Override(share, 1.0))];
            let run = run_with(&machine, Position::ZERO, &ops, &events, &[]);
            run.check_limits(&machine);
            run.check_path(tolerance + 1e-6);
            assert_eq!(run.samples.last().unwrap().position, *ops.last().unwrap().target().unwrap());
            let rests = run.samples[tick..].iter().position(|s| s.velocity == 0.0).unwrap();
            longest = longest.max(rests);
            let after = tick + 540;
            let feed = share * 12_000.0 / 60.0;
            let slow = run
                .samples
                .get(after..)
                .and_then(|samples| samples.iter().rposition(|s| s.velocity > 1.001 * feed));
            slowest = slowest.max(slow.map_or(0, |k| k + 1));
        }
        println!("{x} {y} {tolerance}: rests after {longest} ms, slow after {slowest} ms");
        assert!(longest <= 500 && slowest <= 200, "{x} {y}: {longest} ms, {slowest} ms");
    }
}

/// The speed between setpoints, mm/s, the fastest of them behind a tick.
fn fastest_behind(run: &Run, tick: usize) -> f64 {
    let speed =
        |pair: &[ferrocut_motion::Setpoint]| distance(pair[0].position, pair[1].position) / run.period;
    run.samples[tick..].windows(2).map(speed).fold(0.0, f64::max)
}

/// What the rules of corners and an override allow holds for corners that follow each other too.
#[test]
fn corners_that_follow_each_other_keep_their_own_speed() {
    let mut machine = demo();
    machine.path.tolerance = 0.01;
    for share in [0.02, 0.05, 0.2] {
        let run =
            run_with(&machine, Position::ZERO, &rows(0.75, 0.01), &[(0, Event::Override(share, 1.0))], &[]);
        run.check_limits(&machine);
        let (fastest, allowed) = (fastest_behind(&run, 0), share * 200.0);
        assert!(fastest <= allowed * 1.001, "{share}: {fastest} of {allowed}");
    }
    for (angle, difference) in [(None, Some(1000.0)), (None, Some(1500.0)), (Some(100.0), None)] {
        let mut machine = with_corners(angle, difference, 600.0);
        machine.path.tolerance = 0.05;
        let mode = PathMode::ContinuousWithin(0.05);
        let ops: Vec<Op> =
            (1..=24).map(|k| line(2.0 * f64::from(k), 2.0 * f64::from(k % 2), 0.0, 12_000.0, mode)).collect();
        let run = judged(&machine, &ops);
        // At each vertex: slowest near it.
        let allowed = match difference {
            // The directions differ by the square root of 2 on one axis.
            Some(difference) => difference / 60.0 / 2.0_f64.sqrt(),
            None => 10.0,
        };
        for op in &ops[..23] {
            let vertex = *op.target().unwrap();
            let near = run.samples.iter().filter(|s| distance(s.position, vertex) < 0.2);
            let fastest = near.map(|s| s.velocity).fold(0.0, f64::max);
            assert!(
                fastest <= allowed * 1.01,
                "{angle:?} {difference:?}: {fastest} of {allowed} at {vertex:?}"
            );
        }
    }
}

/// A slow line before a fast one: the override is obeyed on the line, and not from the corner on.
#[test]
fn a_lower_override_holds_on_a_slow_line_before_a_fast_one() {
    let machine = demo();
    for feeds in [[1000.0, 6000.0], [6000.0, 1000.0], [1500.0, 12_000.0]] {
        let ops = [
            line(60.0, 0.0, 0.0, feeds[0], GO),
            line(60.0, 30.0, 0.0, feeds[1], GO),
            line(0.0, 30.0, 0.0, feeds[1], GO),
        ];
        for steps in [&[0.1][..], &[0.9, 0.7, 0.5, 0.4, 0.3, 0.2, 0.1], &[0.5, 0.2]] {
            for first in [300, 500, 551] {
                let events: Vec<_> = steps
                    .iter()
                    .enumerate()
                    .map(|(k, share)| (first + 30 * k, Event::Override(*share, 1.0)))
                    .collect();
                let run = run_with(&machine, Position::ZERO, &ops, &events, &[]);
                run.check_limits(&machine);
                let after = first + 30 * steps.len() + 250;
                for (k, pair) in run.samples.windows(2).enumerate().skip(after) {
                    let allowed = if pair[1].tag == 0 { feeds[0] } else { feeds[0].max(feeds[1]) };
                    let allowed = allowed * steps.last().unwrap() / 60.0;
                    let speed = distance(pair[0].position, pair[1].position) / run.period;
                    assert!(
                        speed <= allowed * 1.001,
                        "{feeds:?} {steps:?} {first}: tick {k} {speed} of {allowed}"
                    );
                }
            }
        }
    }
}

/// Directions in which a rotary axis turns are longer than one: what a corner leaves its lines by is bounded all the same.
#[test]
fn corners_beside_rotary_axes_keep_their_tolerance() {
    let mut machine = demo();
    let mut seed = 0x2545_f491_4f6c_dd1d_u64;
    let mut next = |most: f64| {
        seed ^= seed << 13;
        seed ^= seed >> 7;
        seed ^= seed << 17;
        most * (2.0 * (seed >> 11) as f64 / (1u64 << 53) as f64 - 1.0)
    };
    for tolerance in [0.005, 0.02, 0.05] {
        machine.path.tolerance = tolerance;
        for _ in 0..60 {
            let mut at = Position::ZERO;
            let ops: Vec<Op> = (0..3)
                .map(|_| {
                    let mut by = Position::xyz(next(20.0), next(20.0), next(2.0));
                    by.0[3] = next(60.0);
                    at = at + by;
                    Op::Feed { to: at, feed: Feed::PerMinute(5000.0), path: GO }
                })
                .collect();
            let run = run(&machine, Position::ZERO, &ops);
            run.check_limits(&machine);
            run.check_path(tolerance * 1.001);
        }
    }
}
