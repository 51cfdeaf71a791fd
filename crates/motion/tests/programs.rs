//! Programs as the trade knows them, against figures worked out by hand.
#![allow(clippy::unwrap_used)]

mod common;
use common::*;
use ferrocut_geometry::{Axis, Plane, Position};
use ferrocut_motion::{Motion, Move, State};
use ferrocut_toolpath::{Feed, FeedAlong, Op, PathMode};
use std::f64::consts::{PI, TAU};

const GO: PathMode = PathMode::Continuous;

fn chords(count: usize, r: f64, turns: f64, round: f64, f: f64) -> Vec<Op> {
    let at = |v: f64| (v / round).round() * round;
    (1..=count)
        .map(|i| {
            let phi = TAU * turns * i as f64 / count as f64;
            line(at(r * phi.cos()), at(r * phi.sin()), 0.0, f, GO)
        })
        .collect()
}

#[test]
fn a_square_with_exact_stop_takes_the_time_of_four_trapezoids() {
    let machine = round_machine();
    let ops: Vec<Op> = [(100.0, 0.0), (100.0, 100.0), (0.0, 100.0), (0.0, 0.0)]
        .map(|(x, y)| line(x, y, 0.0, 6000.0, PathMode::ExactStop))
        .to_vec();
    let run = run(&machine, Position::ZERO, &ops);
    run.check_limits(&machine);
    run.check_path(1e-9);
    // 100 mm at 100 mm/s, 2000 mm/s², 50000 mm/s³: 1 s, and a ramp of 100/2000 + 2000/50000 s a side.
    assert!((run.time() - 4.36).abs() < 0.01, "{}", run.time());
    for op in &ops {
        assert!(run.rests_on(*op.target().unwrap()));
    }
}

#[test]
fn sharp_corners_are_rounded_within_the_tolerance_and_quicker_than_stops() {
    let machine = demo();
    let ops = |path| {
        [
            line(10.0, 0.0, 0.0, 3000.0, path),
            line(10.0, 7.3, 0.0, 3000.0, path),
            line(3.3, 1.1, 0.7, 3000.0, path),
        ]
    };
    let rounded = run(&machine, Position::ZERO, &ops(GO));
    rounded.check_limits(&machine);
    rounded.check_path(0.01 + 1e-6);
    assert!(!rounded.stops_inside());
    let stopped = run(&machine, Position::ZERO, &ops(PathMode::ExactStop));
    stopped.check_limits(&machine);
    // A right angle: both ramps overlap by (48·δ/(√2·J))^⅓ = 19 ms; the second is sharper.
    assert!(rounded.time() < stopped.time() - 0.03, "{} {}", rounded.time(), stopped.time());
}

#[test]
fn a_path_that_turns_back_rests_on_its_point() {
    let machine = demo();
    let ops = [line(10.0, 0.0, 0.0, 3000.0, GO), line(4.0, 0.0, 0.0, 3000.0, GO)];
    let run = run(&machine, Position::ZERO, &ops);
    run.check_limits(&machine);
    for op in &ops {
        assert!(run.rests_on(*op.target().unwrap()));
    }
}

#[test]
fn tangent_joints_are_run_through() {
    let machine = demo();
    let half = |y: f64| Position::xyz(50.0, y, 0.0);
    let ops = [
        line(20.0, 0.0, 0.0, 4000.0, GO),
        line(50.0, 0.0, 0.0, 4000.0, GO),
        arc(half(20.0), [50.0, 10.0], PI, 4000.0),
        arc(half(40.0), [50.0, 30.0], -PI, 4000.0),
        line(80.0, 40.0, 0.0, 4000.0, GO),
    ];
    let run = run(&machine, Position::ZERO, &ops);
    run.check_limits(&machine);
    run.check_path(0.01 + 1e-6);
    assert!(!run.stops_inside());
    // Never slower than the arcs need: v² ≤ a·r is far above the feed.
    // A smoothed joint is as much as 0.002 longer than the lengths that the feed is kept by.
    let cruising = run.samples.iter().filter(|s| s.velocity > 4000.0 / 60.0 * 0.998).count();
    assert!(cruising as f64 * run.period > 0.92 * run.time(), "{cruising}");
    assert_eq!(run.samples.last().unwrap().position, *ops[4].target().unwrap());
}

#[test]
fn a_tangent_joint_rounded_to_a_micrometre_is_run_through() {
    let machine = demo();
    let r: f64 = 0.5;
    let angle: f64 = 0.7;
    let round = |v: f64| (v * 1e3).round() / 1e3;
    let (x, y) = (round(r * angle.cos()), round(r * angle.sin()));
    let ops = [
        arc(Position::xyz(x, y, 0.0), [0.0, 0.0], angle, 600.0),
        line(round(x - 5.0 * angle.sin()), round(y + 5.0 * angle.cos()), 0.0, 600.0, GO),
    ];
    let run = run(&machine, Position::xyz(r, 0.0, 0.0), &ops);
    run.check_limits(&machine);
    run.check_path(0.01 + 1e-6);
    assert!(!run.stops_inside());
}

#[test]
fn chords_of_a_circle_run_like_the_circle() {
    let machine = round_machine();
    let start = Position::xyz(25.0, 0.0, 0.0);
    for f in [2000.0, 6000.0, 10000.0, 15000.0] {
        let circle = run(&machine, start, &[arc(start, [0.0, 0.0], TAU, f)]);
        circle.check_limits(&machine);
        circle.check_path(1e-9);
        let many = run(&machine, start, &chords(500, 25.0, 1.0, 1e-6, f));
        many.check_limits(&machine);
        many.check_path(0.01 + 1e-6);
        assert!(!many.stops_inside());
        let ratio = many.time() / circle.time();
        assert!(ratio < 1.15, "F{f}: {} s, circle {} s", many.time(), circle.time());
    }
}

#[test]
fn micro_segments_several_a_period() {
    let machine = demo();
    let start = Position::xyz(25.0, 0.0, 0.0);
    // 0.01 mm blocks rounded to 1 µm: directions that jump by up to 8°.
    let ops = chords(15_000, 25.0, 1.0, 1e-3, 6000.0);
    let run = run(&machine, start, &ops);
    run.check_limits(&machine);
    run.check_path(0.01 + 1e-6);
    assert!(run.time() < 20.0, "{}", run.time());
}

#[test]
fn blends_keep_the_tolerance_on_both_sides() {
    let machine = demo();
    // Corners of 15°, slow enough for samples 5 µm apart.
    let mut ops = Vec::new();
    let (mut x, mut y) = (0.0, 0.0);
    for k in 0..10 {
        let angle: f64 = if k % 2 == 0 { 0.0 } else { 15f64.to_radians() };
        (x, y) = (x + 4.0 * angle.cos(), y + 4.0 * angle.sin());
        ops.push(line(x, y, 0.0, 300.0, PathMode::ContinuousWithin(0.02)));
    }
    let run = run(&machine, Position::ZERO, &ops);
    run.check_limits(&machine);
    run.check_path(0.02 + 1e-6);
    assert!(!run.stops_inside());
    for op in &ops {
        let p = *op.target().unwrap();
        let missed = run
            .samples
            .windows(2)
            .map(|w| {
                distance(
                    &Op::Rapid { to: w[1].position, straight: true, speed: None, path: PathMode::ON_PATH },
                    w[0].position,
                    p,
                )
            })
            .fold(f64::INFINITY, f64::min);
        assert!(missed <= 0.02 + 1e-6, "{missed}");
    }
}

#[test]
fn no_tolerance_no_blend() {
    let machine = demo();
    let path = PathMode::ContinuousWithin(0.0);
    let ops = [line(10.0, 0.0, 0.0, 3000.0, path), line(20.0, 1.0, 0.0, 3000.0, path)];
    let run = run(&machine, Position::ZERO, &ops);
    run.check_limits(&machine);
    run.check_path(1e-9);
    assert!(run.rests_on(Position::xyz(10.0, 0.0, 0.0)));
}

#[test]
fn helix_feed_along_the_circle() {
    let machine = demo();
    let start = Position::xyz(10.0, 0.0, 0.0);
    for (feed_along, speed) in
        [(FeedAlong::Path, 20.0), (FeedAlong::Circle, 20.0 * (TAU * 10.0f64).hypot(30.0) / (TAU * 10.0))]
    {
        let ops = [Op::Arc {
            to: Position::xyz(10.0, 0.0, -90.0),
            plane: Plane::Xy,
            center: [0.0, 0.0],
            sweep: -3.0 * TAU,
            feed: Feed::PerMinute(1200.0),
            feed_along,
            path: GO,
        }];
        let run = run(&machine, start, &ops);
        run.check_limits(&machine);
        run.check_path(1e-9);
        let top = run.samples.iter().map(|s| s.velocity).fold(0.0, f64::max);
        assert!((top - speed).abs() < 1e-9, "{top} {speed}");
        assert_eq!(run.samples.last().unwrap().position, Position::xyz(10.0, 0.0, -90.0));
    }
}

#[test]
fn a_helix_of_a_thousand_turns_flows_through() {
    let machine = demo();
    let start = Position::xyz(1.0, 0.0, 0.0);
    let end = Position::xyz(1.0, 0.0, -100.0);
    let run = run(
        &machine,
        start,
        &[arc(end, [0.0, 0.0], 1000.0 * TAU, 6000.0), line(1.0, 5.0, -100.0, 600.0, GO)],
    );
    run.check_limits(&machine);
    assert!(!run.stops_inside());
    assert!(run.time() < 2000.0 * PI / 30.0, "{}", run.time());
}

#[test]
fn rapids_run_at_the_limit_of_the_slowest_axis() {
    let machine = demo();
    let to = Position::xyz(200.0, 100.0, -50.0);
    let straight = run(
        &machine,
        Position::ZERO,
        &[Op::Rapid { to, straight: true, speed: None, path: PathMode::ON_PATH }],
    );
    straight.check_limits(&machine);
    straight.check_path(1e-9);
    // X: 200 mm at 250 mm/s, 2000 mm/s² and 50000 mm/s³.
    let time = 200.0 / 250.0 + 250.0 / 2000.0 + 2000.0 / 50_000.0;
    assert!((straight.time() - time).abs() < 0.003, "{}", straight.time());
    let each = run(
        &machine,
        Position::ZERO,
        &[Op::Rapid { to, straight: false, speed: None, path: PathMode::ON_PATH }],
    );
    each.check_limits(&machine);
    each.check_path(1e-9);
    assert!((each.time() - straight.time()).abs() < 0.003);
    assert_eq!(each.samples.last().unwrap().position, to);
    let z_done = each.samples.iter().find(|s| s.position[Axis::Z] == -50.0).unwrap();
    assert!(z_done.position[Axis::X] < 100.0);
}

#[test]
fn collinear_rapids_are_one() {
    let machine = demo();
    let ops = [50.0, 120.0, 200.0].map(|x| Op::Rapid {
        to: Position::xyz(x, 0.0, 0.0),
        straight: true,
        speed: None,
        path: PathMode::ON_PATH,
    });
    let run = run(&machine, Position::ZERO, &ops);
    run.check_limits(&machine);
    assert!(!run.stops_inside());
    let ops = [line(50.0, 0.0, 0.0, 6000.0, GO), ops[1].clone()];
    let run = common::run(&machine, Position::ZERO, &ops);
    assert!(run.rests_on(Position::xyz(50.0, 0.0, 0.0)));
}

#[test]
fn rotary_moves_and_mixed_moves() {
    let machine = demo();
    let with = |x: f64, a: f64| {
        let mut p = Position::xyz(x, 0.0, 0.0);
        p[Axis::A] = a;
        p
    };
    let feed = |to: Position, f: f64| Op::Feed { to, feed: Feed::PerMinute(f), path: GO };
    // 90° at 1800°/min, 500°/s² and 10000°/s³: 3 s, 30/500 s and 500/10000 s.
    let run = run(&machine, Position::ZERO, &[feed(with(0.0, 90.0), 1800.0)]);
    run.check_limits(&machine);
    assert!((run.time() - 3.11).abs() < 0.003, "{}", run.time());
    let run = common::run(
        &machine,
        Position::ZERO,
        &[
            feed(with(10.0, 5.0), 3000.0),
            feed(with(20.0, 10.5), 3000.0),
            feed(with(20.1, 3000.0), 3000.0),
            feed(with(30.0, 3000.0), 3000.0),
            feed(with(30.0, 0.0), 3000.0),
        ],
    );
    run.check_limits(&machine);
    assert_eq!(run.samples.last().unwrap().position, with(30.0, 0.0));
}

#[test]
fn arcs_that_turn_a_rotary_axis_beside_them_are_run_through() {
    let machine = demo();
    // A turns by 9 degrees a millimetre all along.
    let at = |x: f64, y: f64, way: f64| {
        let mut p = Position::xyz(x, y, 0.0);
        p[Axis::A] = 9.0 * way;
        p
    };
    let quarter = 5.0 * PI;
    let line = |to: Position| Op::Feed { to, feed: Feed::PerMinute(300.0), path: GO };
    let ops = [
        line(at(20.0, 0.0, 20.0)),
        Op::Arc {
            to: at(30.0, 10.0, 20.0 + quarter),
            plane: Plane::Xy,
            center: [20.0, 10.0],
            sweep: 0.5 * PI,
            feed: Feed::PerMinute(300.0),
            feed_along: FeedAlong::Path,
            path: GO,
        },
        line(at(30.0, 30.0, 40.0 + quarter)),
    ];
    let run = run(&machine, Position::ZERO, &ops);
    run.check_limits(&machine);
    run.check_feed();
    run.check_path(0.01 + 1e-6);
    // At 5 mm/s, A at 45 degrees a second, from rest and to rest once each.
    let steady = (40.0 + quarter) / 5.0;
    assert!((steady..steady + 0.2).contains(&run.time()), "{} {steady}", run.time());
    let told: Vec<f64> = run.samples.iter().map(|s| s.velocity).collect();
    let (first, last) = (200, told.len() - 200);
    assert!(
        told[first..last].iter().all(|v| (v - 5.0).abs() < 0.01),
        "{:?}",
        told.iter().fold(9.0_f64, |a, b| a.min(*b))
    );
}

#[test]
fn tapping_ignores_override_and_hold() {
    let machine = demo();
    let ops = [line(0.0, 0.0, -20.0, 600.0, PathMode::Tapping)];
    let plain = run(&machine, Position::ZERO, &ops);
    let events = [(100, Event::Override(0.1, 1.0)), (300, Event::Hold), (400, Event::Override(0.0, 0.0))];
    let disturbed = run_with(&machine, Position::ZERO, &ops, &events, &[]);
    assert_eq!(plain.time(), disturbed.time());
}

#[test]
fn hold_stops_on_the_path_and_resume_goes_on() {
    let machine = demo();
    let ops = chords(500, 25.0, 1.0, 1e-6, 9000.0);
    let start = Position::xyz(25.0, 0.0, 0.0);
    let plain = run(&machine, start, &ops);
    let held = run_with(&machine, start, &ops, &[(400, Event::Hold), (700, Event::Resume)], &[]);
    held.check_limits(&machine);
    held.check_path(0.01 + 1e-6);
    assert_eq!(held.samples[699].state, State::Held);
    assert_eq!(held.samples[699].velocity, 0.0);
    // 150 mm/s at 2000 mm/s² and 50000 mm/s³ is 115 ms; the curve takes a part of both.
    let stopped = held.samples.iter().skip(400).position(|s| s.velocity == 0.0).unwrap();
    assert!(stopped < 200, "{stopped}");
    assert!(held.time() > plain.time() + 0.2 && held.time() < plain.time() + 0.5);
    assert_eq!(held.samples.last().unwrap().position, plain.samples.last().unwrap().position);
}

#[test]
fn overrides_scale_feed_and_rapid() {
    let machine = demo();
    let ops = [
        line(100.0, 0.0, 0.0, 3000.0, GO),
        Op::Rapid { to: Position::ZERO, straight: false, speed: None, path: PathMode::ON_PATH },
    ];
    let events = [(0, Event::Override(2.0, 0.5))];
    let run = run_with(&machine, Position::ZERO, &ops, &events, &[]);
    run.check_limits(&machine);
    let top = |tag: u64| run.samples.iter().filter(|s| s.tag == tag).map(|s| s.velocity).fold(0.0, f64::max);
    assert!((top(0) - 100.0).abs() < 1e-9);
    assert!((top(1) - 125.0).abs() < 1e-9);
    let events = [(0, Event::Override(0.0, 1.0)), (500, Event::Override(9.0, 1.0))];
    let run = run_with(&machine, Position::ZERO, &ops, &events, &[]);
    assert!(run.samples[..500].iter().all(|s| s.velocity == 0.0 && s.state == State::Running));
    // 200 % of the feed.
    assert!(run.samples.iter().any(|s| (s.velocity - 100.0).abs() < 1e-9));
    assert!(run.samples.iter().filter(|s| s.tag == 0).all(|s| s.velocity < 100.0 + 1e-9));
}

#[test]
fn abort_forgets_and_the_next_move_begins_there() {
    let machine = demo();
    let mut motion = Motion::new(&machine, Position::ZERO);
    motion.push(&Move::line(Position::xyz(100.0, 50.0, 0.0), 100.0, GO, 7).unwrap()).unwrap();
    assert_eq!(motion.tick().state, State::Waiting);
    motion.finish();
    for _ in 0..300 {
        assert_eq!(motion.tick().state, State::Running);
    }
    motion.abort();
    assert_eq!(motion.free(), 0);
    let ticks = (0..1000).position(|_| motion.tick().state == State::Idle).unwrap();
    // 100 mm/s; X, the steeper axis, takes 2000 mm/s² and 50000 mm/s³: 45 ms and 40 ms, 8 ms after it was asked for.
    assert!((91..=95).contains(&ticks), "{ticks}");
    let at = motion.position();
    assert!(distance(&line(100.0, 50.0, 0.0, 1.0, GO), Position::ZERO, at) < 1e-9);
    assert!(motion.is_empty() && motion.at_rest());
    motion.push(&Move::line(Position::ZERO, 100.0, GO, 8).unwrap()).unwrap();
    motion.finish();
    let first = motion.tick();
    assert!(
        first.tag == 8
            && first.position != at
            && first.state == State::Running
            && !motion.is_still()
            && (first.position - at).0[0].abs() < 0.001
    );
    while motion.tick().state != State::Idle {}
    assert_eq!(motion.position(), Position::ZERO);
}

#[test]
fn feed_drops_before_the_slower_block() {
    let machine = demo();
    let ops = [line(50.0, 0.0, 0.0, 6000.0, GO), line(100.0, 0.0, 0.0, 600.0, GO)];
    for feed in [0.5, 1.0, 1.5] {
        let run = run_with(&machine, Position::ZERO, &ops, &[(0, Event::Override(feed, 1.0))], &[]);
        run.check_limits(&machine);
        assert!(!run.stops_inside());
        let slow = run.samples.iter().filter(|s| s.position.0[0] > 50.0);
        assert!(slow.into_iter().all(|s| s.velocity <= 10.0 * feed + 1e-9));
    }
}

#[test]
fn a_slow_feeder_stops_the_machine_and_nothing_else() {
    let machine = demo();
    let ops = chords(500, 25.0, 1.0, 1e-6, 6000.0);
    let start = Position::xyz(25.0, 0.0, 0.0);
    for rhythm in [&[1][..], &[0, 0, 0, 0, 0, 1], &[400, 0, 0, 0], &[3, 0, 0, 2, 40, 0, 0, 0, 0]] {
        let run = run_with(&machine, start, &ops, &[], rhythm);
        run.check_limits(&machine);
        run.check_path(0.01 + 1e-6);
        assert_eq!(run.samples.last().unwrap().position, *ops[499].target().unwrap());
    }
}

#[test]
fn the_rhythm_of_feeding_does_not_matter_as_long_as_the_queue_stays_full() {
    let machine = demo();
    let ops = chords(6000, 60.0, 3.0, 1e-4, 5000.0);
    let start = Position::xyz(60.0, 0.0, 0.0);
    let moving = |run: Run| -> Vec<Position> {
        run.samples.iter().filter(|s| s.velocity > 0.0).map(|s| s.position).collect()
    };
    let full = moving(run(&machine, start, &ops));
    assert_eq!(full, moving(run_with(&machine, start, &ops, &[], &[5])));
    assert_eq!(full, moving(run_with(&machine, start, &ops, &[], &[0, 17, 1])));
}

#[test]
fn the_same_calls_give_the_same_bits() {
    let machine = demo();
    let ops = chords(3000, 20.0, 2.0, 1e-3, 5000.0);
    let start = Position::xyz(20.0, 0.0, 0.0);
    let events = [(50, Event::Override(1.3, 1.0)), (200, Event::Hold), (300, Event::Resume)];
    let one = run_with(&machine, start, &ops, &events, &[]);
    let two = run_with(&machine, start, &ops, &events, &[]);
    assert_eq!(one.samples, two.samples);
}

#[test]
fn what_is_no_move_is_refused_and_what_goes_nowhere_forgotten() {
    let machine = demo();
    assert!(Move::line(Position::xyz(f64::NAN, 0.0, 0.0), 1.0, GO, 0).is_none());
    assert!(Move::line(Position::ZERO, f64::NAN, GO, 0).is_none());
    assert!(Move::from_step(&Op::Stop(0), Position::ZERO, 0.0, 0).is_none());
    let mut motion = Motion::new(&machine, Position::ZERO);
    let free = motion.free();
    motion.push(&Move::line(Position::ZERO, 1.0, GO, 0).unwrap()).unwrap();
    assert_eq!(motion.free(), free);
    motion.finish();
    assert_eq!(motion.tick().state, State::Idle);
}

#[test]
fn an_override_that_is_taken_back_goes_on_from_the_plan_with_the_new_one() {
    // A micrometre a block, so that what is known is too short for the feed, but not for a twentieth of it: with that
    // much is final, which the plan with the whole feed is not.
    let machine = demo();
    let start = Position::xyz(25.0, 0.0, 0.0);
    let ops = chords(40_000, 25.0, 0.25, 1e-6, 12_000.0);
    for at in [300, 450, 601] {
        let events = [(0, Event::Override(0.05, 1.0)), (at, Event::Override(1.0, 1.0))];
        let run = run_with(&machine, start, &ops, &events, &[]);
        run.check_limits(&machine);
        run.check_path(0.01 + 1e-6);
        assert!(!run.stops_inside());
        assert_eq!(run.samples.last().unwrap().position, *ops.last().unwrap().target().unwrap());
    }
}

#[test]
fn a_run_from_rest_begins_with_the_next_period() {
    let machine = demo();
    let mut motion = Motion::new(&machine, Position::ZERO);
    let mut at = Position::ZERO;
    for (k, wait) in [0, 1, 7, 8, 9, 40].into_iter().enumerate() {
        for _ in 0..wait {
            let still = motion.tick();
            assert_eq!((still.position, still.state), (at, State::Idle));
        }
        at = Position::xyz(at.0[0] + 5.0, 0.0, 0.0);
        motion.push(&Move::line(at, 100.0, GO, k as u64).unwrap()).unwrap();
        motion.finish();
        assert!(motion.tick().velocity > 0.0, "after {wait}");
        // A hold is planned ahead, and what is resumed begins at once too.
        motion.hold();
        let ticks = (0..1000).position(|_| motion.tick().state == State::Held).unwrap();
        assert!(ticks > 8, "{ticks}");
        motion.resume();
        assert!(motion.tick().velocity > 0.0);
        assert!((0..1000).any(|_| motion.tick().state == State::Idle));
        assert_eq!(motion.position(), at);
    }
}
