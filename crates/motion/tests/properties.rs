//! Limits, path and end points of random programs under random overrides, holds and aborts.
#![allow(clippy::unwrap_used)]

mod common;
use common::*;
use ferrocut_geometry::{AXES, Axis, Plane, Position};
use ferrocut_machine::{ArcSlowdown, CornerSlowdown, Machine, Ramp};
use ferrocut_motion::{Limits, Motion, Move, State};
use ferrocut_toolpath::{CornerRule, Feed, FeedAlong, InnerCorners, Op, PathMode};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// A move relative to the one before.
#[derive(Clone, Debug)]
enum Piece {
    Line {
        d: [f64; 3],
        feed: f64,
        path: PathMode,
    },
    /// Many short lines along a curve.
    Curve {
        count: usize,
        step: f64,
        bend: f64,
        wobble: f64,
        feed: f64,
        round: f64,
    },
    Arc {
        plane: Plane,
        radius: f64,
        from: f64,
        sweep: f64,
        climb: f64,
        feed: f64,
        off: f64,
        path: PathMode,
    },
    /// An arc that goes on in the direction of the move before.
    Tangent {
        radius: f64,
        sweep: f64,
        feed: f64,
    },
    /// A line that goes on in the direction of the move before.
    On {
        length: f64,
        feed: f64,
    },
    Back {
        feed: f64,
    },
    Rapid {
        d: [f64; 3],
        straight: bool,
    },
    /// A cam, wrapped around A in short lines with rounded coordinates: some of them do not move X.
    Cam {
        count: usize,
        step: f64,
        throw: f64,
        lobes: f64,
        feed: f64,
    },
    Rotary {
        a: f64,
        x: f64,
        feed: f64,
    },
    /// Rows to and fro, with short lines between them.
    Rows {
        count: usize,
        row: f64,
        across: [f64; 2],
        feed: f64,
        tolerance: f64,
    },
    Nothing,
}

fn path() -> impl Strategy<Value = PathMode> {
    prop_oneof![
        4 => Just(PathMode::Continuous),
        1 => Just(PathMode::ExactStop),
        1 => Just(PathMode::Tapping),
        2 => prop_oneof![Just(0.0), 1e-5..0.3f64].prop_map(PathMode::ContinuousWithin),
        1 => (any::<bool>(), 2.0..178.0f64, 10.0..1000.0f64).prop_map(|(left, angle, lowest_feed)| {
            let (plane, rule) = (Plane::Xy, CornerRule::Angle(angle));
            PathMode::InnerCorners(InnerCorners { plane, left, rule, lowest_feed })
        }),
    ]
}

fn vector(size: f64) -> impl Strategy<Value = [f64; 3]> {
    [-size..size, -size..size, -size..size]
}

fn piece() -> impl Strategy<Value = Piece> {
    let feed = || 200.0..12000.0f64;
    let plane = prop_oneof![Just(Plane::Xy), Just(Plane::Zx), Just(Plane::Yz)];
    prop_oneof![
        2 => (prop_oneof![vector(20.0), vector(0.01), vector(1e-6)], feed(), path())
            .prop_map(|(d, feed, path)| Piece::Line { d, feed, path }),
        3 => (5..300usize, prop_oneof![0.001..0.05f64, 0.1..1.0f64], -0.1..0.1f64, 0.0..0.2f64, feed(),
              prop_oneof![Just(1e-3), Just(1e-4), Just(1e-9)])
            .prop_map(|(count, step, bend, wobble, feed, round)| Piece::Curve { count, step, bend, wobble, feed, round }),
        2 => (plane, prop_oneof![0.01..1.0f64, 1.0..30.0f64], 0.0..6.3f64, -14.0..14.0f64,
              prop_oneof![Just(0.0), -10.0..10.0f64], feed(), prop_oneof![Just(0.0), -0.01..0.01f64], path())
            .prop_map(|(plane, radius, from, sweep, climb, feed, off, path)| Piece::Arc {
                plane, radius, from, sweep, climb, feed, off, path
            }),
        2 => (prop_oneof![0.05..1.0f64, 1.0..30.0f64], -7.0..7.0f64, feed())
            .prop_map(|(radius, sweep, feed)| Piece::Tangent { radius, sweep, feed }),
        2 => (prop_oneof![0.001..0.1f64, 0.1..30.0f64], feed()).prop_map(|(length, feed)| Piece::On { length, feed }),
        1 => feed().prop_map(|feed| Piece::Back { feed }),
        1 => (vector(60.0), any::<bool>()).prop_map(|(d, straight)| Piece::Rapid { d, straight }),
        1 => (-40.0..40.0f64, prop_oneof![Just(0.0), -5.0..5.0f64, Just(1e-5)], feed())
            .prop_map(|(a, x, feed)| Piece::Rotary { a, x, feed }),
        1 => (5..60usize, 0.05..1.5f64, 0.0..4.0f64, 1.0..6.0f64, feed())
            .prop_map(|(count, step, throw, lobes, feed)| Piece::Cam { count, step, throw, lobes, feed }),
        1 => (2..6usize, 0.2..20.0f64, [0.01..1.5f64, -0.5..0.5f64], feed(), 1e-3..0.3f64)
            .prop_map(|(count, row, across, feed, tolerance)| Piece::Rows { count, row, across, feed, tolerance }),
        1 => Just(Piece::Nothing),
    ]
}

fn round(v: f64, to: f64) -> f64 {
    (v / to).round() * to
}

/// The program, as a CAM system would write it: coordinates with four decimals.
fn build(pieces: &[Piece]) -> Vec<Op> {
    let mut ops = Vec::new();
    let mut at = Position::ZERO;
    // Direction in the XY plane.
    let mut heading: f64 = 0.3;
    for piece in pieces {
        let feed_op = |to, feed, path| Op::Feed { to, feed: Feed::PerMinute(feed), path };
        let from = at;
        match *piece {
            Piece::Line { d, feed, path } => {
                at = at + Position::xyz(d[0], d[1], d[2]);
                heading = d[1].atan2(d[0]);
                ops.push(feed_op(at, feed, path));
            }
            Piece::Curve { count, step, bend, wobble, feed, round: to } => {
                let mut exact = at;
                for k in 0..count {
                    heading += bend * step.min(1.0) + wobble * (k as f64 * 0.1).sin() * step;
                    exact = exact + Position::xyz(step * heading.cos(), step * heading.sin(), 0.1 * step);
                    at = Position(exact.0.map(|c| round(c, to)));
                    ops.push(feed_op(at, feed, PathMode::Continuous));
                }
            }
            Piece::Arc { plane, radius, from: angle, sweep, climb, feed, off, path } => {
                let [a, b] = plane.of(at);
                let center = [a - radius * angle.cos(), b - radius * angle.sin()];
                let r = radius + off * radius.min(1.0);
                at[plane.first()] = round(center[0] + r * (angle + sweep).cos(), 1e-4);
                at[plane.second()] = round(center[1] + r * (angle + sweep).sin(), 1e-4);
                at[plane.normal()] += climb;
                let along = if climb > 0.0 { FeedAlong::Circle } else { FeedAlong::Path };
                ops.push(Op::Arc {
                    to: at,
                    plane,
                    center,
                    sweep,
                    feed: Feed::PerMinute(feed),
                    feed_along: along,
                    path,
                });
            }
            Piece::Tangent { radius, sweep, feed } => {
                let side = sweep.signum();
                let center =
                    [at.0[0] - side * radius * heading.sin(), at.0[1] + side * radius * heading.cos()];
                heading += sweep;
                at.0[0] = round(center[0] + side * radius * heading.sin(), 1e-4);
                at.0[1] = round(center[1] - side * radius * heading.cos(), 1e-4);
                ops.push(arc(at, center, sweep, feed));
            }
            Piece::On { length, feed } => {
                at = at + Position::xyz(length * heading.cos(), length * heading.sin(), 0.0);
                ops.push(feed_op(at, feed, PathMode::Continuous));
            }
            Piece::Back { feed } => {
                let back = if ops.len() > 1 { *ops[ops.len() - 2].target().unwrap() } else { Position::ZERO };
                at = back;
                ops.push(feed_op(at, feed, PathMode::Continuous));
            }
            Piece::Rapid { d, straight } => {
                at = at + Position::xyz(d[0], d[1], d[2]);
                ops.push(Op::Rapid { to: at, straight, speed: None, path: PathMode::ON_PATH });
            }
            Piece::Cam { count, step, throw, lobes, feed } => {
                let (x, a) = (at[Axis::X], at[Axis::A]);
                for k in 1..=count {
                    let angle = step * k as f64;
                    at[Axis::A] = round(a + angle, 1e-3);
                    at[Axis::X] = round(x + throw * (1.0 - (lobes * angle.to_radians()).cos()), 1e-3);
                    ops.push(feed_op(at, feed, PathMode::Continuous));
                }
            }
            Piece::Rotary { a, x, feed } => {
                at[Axis::A] += a;
                at[Axis::X] += x;
                ops.push(feed_op(at, feed, PathMode::Continuous));
            }
            Piece::Rows { count, row, across: [across, along], feed, tolerance } => {
                let (sin, cos) = heading.sin_cos();
                for k in 0..2 * count {
                    let (x, y) = match k % 4 {
                        0 => (row, 0.0),
                        2 => (-row, 0.0),
                        _ => (along * across, across),
                    };
                    at = at + Position::xyz(x * cos - y * sin, x * sin + y * cos, 0.0);
                    at = Position(at.0.map(|c| round(c, 1e-4)));
                    ops.push(feed_op(at, feed, PathMode::ContinuousWithin(tolerance)));
                }
            }
            Piece::Nothing => ops.push(feed_op(at, 100.0, PathMode::Continuous)),
        }
        // An arc whose rounded end contradicts its sweep is no arc that an interpreter lets through.
        if let Some(Op::Arc { plane, center, sweep, .. }) = ops.last_mut() {
            let (u, v) = (plane.of(from), plane.of(at));
            let (u, v) = ([u[0] - center[0], u[1] - center[1]], [v[0] - center[0], v[1] - center[1]]);
            let angle = (u[0] * v[1] - u[1] * v[0]).atan2(u[0] * v[0] + u[1] * v[1]);
            let turns = ((*sweep - angle) / std::f64::consts::TAU).round();
            *sweep = angle + turns * std::f64::consts::TAU;
        }
    }
    ops
}

fn event() -> impl Strategy<Value = Event> {
    prop_oneof![
        3 => (0.0..2.2f64, 0.0..1.1f64).prop_map(|(f, r)| Event::Override(f, r)),
        1 => Just(Event::Override(0.0, 0.0)),
        1 => Just(Event::Override(1.0, 1.0)),
        2 => Just(Event::Hold),
        2 => Just(Event::Resume),
    ]
}

/// Events at rising ticks, some close together; at the end everything runs again.
fn events() -> impl Strategy<Value = Vec<(usize, Event)>> {
    prop::collection::vec((prop_oneof![0..20usize, 0..700usize], event()), 0..12).prop_map(|list| {
        let mut tick = 0;
        let mut events = Vec::new();
        for (after, event) in list {
            tick += after;
            events.push((tick, event));
        }
        if !events.is_empty() {
            events.extend([(tick + 30, Event::Resume), (tick + 31, Event::Override(1.0, 1.0))]);
        }
        events
    })
}

/// Overrides alone, of which none is 0.
fn overrides() -> impl Strategy<Value = Vec<(usize, Event)>> {
    events().prop_map(|events| {
        let moves = |share: f64| share.max(0.05);
        let lasting = events.into_iter().filter_map(|(tick, event)| match event {
            Event::Override(feed, rapid) => Some((tick, Event::Override(moves(feed), moves(rapid)))),
            Event::Hold | Event::Resume | Event::Abort => None,
        });
        lasting.collect()
    })
}

/// The demo mill, or one whose axes differ more, at another servo period.
fn machine() -> impl Strategy<Value = Machine> {
    let one = (500.0..30000.0f64, 500.0..20000.0f64, 100.0..8000.0f64);
    (prop::collection::vec(one, 4), prop_oneof![Just(1.0), Just(0.25), Just(4.0), Just(2.0)], any::<bool>())
        .prop_map(|(limits, period, is_demo)| {
            let mut machine = demo();
            if !is_demo {
                for (axis, limit) in machine.axes.iter_mut().zip(limits) {
                    (axis.rapid, axis.velocity, axis.acceleration) = limit;
                }
                machine.servo_period_ms = period;
            }
            machine
        })
}

/// The same with what the path may be set to.
fn set_machine() -> impl Strategy<Value = Machine> {
    let corner = prop_oneof![
        3 => Just(None),
        1 => (10.0..179.0f64, 10.0..2000.0f64).prop_map(|(angle, lowest_feed)| Some(CornerSlowdown {
            angle: Some(angle), speed_difference: None, lowest_feed
        })),
        1 => (50.0..5000.0f64, 10.0..2000.0f64).prop_map(|(most, lowest_feed)| Some(CornerSlowdown {
            angle: None, speed_difference: Some(most), lowest_feed
        })),
    ];
    let arc = prop_oneof![
        3 => Just(None),
        1 => (20.0..3000.0f64, 0.0..1000.0f64)
            .prop_map(|(acceleration, lowest_feed)| Some(ArcSlowdown { acceleration, lowest_feed })),
    ];
    let ramp = prop_oneof![
        3 => Just(None),
        1 => (100.0..5000.0f64, prop_oneof![Just(0.0), 1000.0..100_000.0f64])
            .prop_map(|(acceleration, jerk)| Some(Ramp { acceleration, jerk })),
    ];
    let feeds = prop_oneof![
        2 => Just((0.0, None)),
        1 => (0.0..500.0f64, 600.0..15_000.0f64).prop_map(|(lowest, highest)| (lowest, Some(highest))),
    ];
    let tolerance = prop_oneof![2 => Just(0.01), 1 => 0.0..0.2f64];
    (machine(), corner, arc, ramp, feeds, tolerance).prop_map(
        |(mut machine, corner, arc, ramp, feeds, tolerance)| {
            let path = &mut machine.path;
            (path.corner, path.arc, path.ramp, path.tolerance) = (corner, arc, ramp, tolerance);
            (path.lowest_feed, path.highest_feed) = feeds;
            machine
        },
    )
}

/// How far a move may be left: its own tolerance. One that ends in an exact stop has that of the move before it, and so has
/// one that goes nowhere.
fn tolerance(machine: &Machine, ops: &[Op], number: usize) -> f64 {
    let before =
        || number.checked_sub(1).map_or(machine.path.tolerance, |before| tolerance(machine, ops, before));
    let from = number.checked_sub(1).map_or(Position::ZERO, |before| *ops[before].target().unwrap());
    match ops.get(number) {
        Some(op @ (Op::Feed { path, .. } | Op::Arc { path, .. })) if op.length(from) > 0.0 => match path {
            PathMode::ContinuousWithin(tolerance) => *tolerance,
            PathMode::ExactStop => before(),
            _ => machine.path.tolerance,
        },
        _ => before(),
    }
}

/// Directions in which a move begins and ends; `None` where it goes nowhere to speak of.
fn directions(op: &Op, from: Position) -> Option<[Position; 2]> {
    let to = *op.target().unwrap();
    let arc = op.arc(from);
    // Arcs of some hundredths are no more than the rounding of their ends, nor are lines of some thousandths.
    let least = if arc.is_some() { 0.1 } else { 0.01 };
    if op.length(from) < least {
        return None;
    }
    let ways = match arc {
        Some(arc) => [arc.at(1e-6) - from, to - arc.at(1.0 - 1e-6)],
        None => [to - from; 2],
    };
    Some(ways.map(|way| Position(way.0.map(|d| d / way.distance(Position::ZERO)))))
}

/// Whether the path has to rest between two moves: where one is positioning, the first is an exact stop, the axes change, no
/// tolerance lets a corner be rounded, or the path all but turns back.
fn must_rest(machine: &Machine, ops: &[Op], run: &Run, number: usize) -> bool {
    let (Some(one), Some(next)) = (ops.get(number), ops.get(number + 1)) else { return true };
    let is_exact = |op: &Op| {
        matches!(
            op,
            Op::Rapid { .. }
                | Op::Feed { path: PathMode::ExactStop, .. }
                | Op::Arc { path: PathMode::ExactStop, .. }
        )
    };
    if is_exact(one) || matches!(next, Op::Rapid { .. }) {
        return true;
    }
    // What is too short to have a direction takes its neighbours along.
    let of = |i: usize| directions(&ops[i], run.from(i));
    let both = number
        .checked_sub(1)
        .map_or(Some(()), |before| of(before).map(drop))
        .and(of(number))
        .zip(of(number + 1));
    let Some(([_, end], [begin, _])) = both else { return true };
    let cosine = |axes: usize| -> f64 {
        let size = |d: &Position| d.0[..axes].iter().map(|c| c * c).sum::<f64>().sqrt();
        (0..axes).map(|i| end.0[i] * begin.0[i]).sum::<f64>() / (size(&end) * size(&begin)).max(1e-12)
    };
    // Where X, Y and Z go further than A turns they may turn back beside it.
    let decide = |d: &Position| d[Axis::A].abs() <= d.0[..3].iter().map(|c| c * c).sum::<f64>().sqrt();
    let cosine = if decide(&end) && decide(&begin) { cosine(3).min(cosine(4)) } else { cosine(4) };
    let may_round =
        |op: &Op| matches!(op, Op::Feed { path, .. } | Op::Arc { path, .. } if *path != PathMode::Tapping);
    let tolerance = tolerance(machine, ops, number).min(tolerance(machine, ops, number + 1));
    let is_rounded = may_round(one) && may_round(next) && tolerance > 1e-4;
    if is_rounded { cosine < -0.9 } else { cosine < 1.0 - 1e-9 }
}

fn close(a: Position, b: Position) -> bool {
    (0..AXES).all(|i| (a.0[i] - b.0[i]).abs() < 1e-9)
}

/// Random programs a property, or as many as `FERROCUT_CASES` says.
fn cases() -> u32 {
    std::env::var("FERROCUT_CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(100)
}

/// The same programs every time, so that a change is judged by what it changed; `FERROCUT_SEED` gives others.
fn seed() -> RngSeed {
    RngSeed::Fixed(std::env::var("FERROCUT_SEED").ok().and_then(|n| n.parse().ok()).unwrap_or(1))
}

proptest! {
    #![proptest_config(ProptestConfig { rng_seed: seed(), max_shrink_iters: 100, ..ProptestConfig::with_cases(cases()) })]

    #[test]
    fn limits_path_and_end(
        machine in set_machine(),
        pieces in prop::collection::vec(piece(), 1..8),
        events in events(),
        rhythm in prop_oneof![3 => Just(vec![]), 1 => prop::collection::vec(0..6usize, 1..20)
            .prop_map(|mut r| { r.push(1); r })],
    ) {
        let ops = build(&pieces);
        let run = run_with(&machine, Position::ZERO, &ops, &events, &rhythm);
        run.check_limits(&machine);
        run.check_path_within(|number| tolerance(&machine, &ops, number) + 1e-6);
        let strongest = machine.axes.iter().map(|axis| axis.acceleration * axis.acceleration).sum::<f64>().sqrt();
        run.check_reach_within(strongest, |number| tolerance(&machine, &ops, number) + 1e-6);
        // Cutting is no faster than the machine's highest feed, whatever the override.
        let highest = machine.path.highest_feed.map_or(f64::INFINITY, |feed| feed / 60.0);
        for w in run.samples.windows(2) {
            let cuts = |tag: u64| {
                let op = &ops[tag as usize];
                let is_held = matches!(op, Op::Feed { path, .. } | Op::Arc { path, .. } if *path != PathMode::Tapping);
                is_held && run.from(tag as usize)[Axis::A] == op.target().unwrap()[Axis::A]
            };
            if (w[0].tag..=w[1].tag).all(cuts) {
                let d = (w[1].position - w[0].position).0;
                let v = d[0].hypot(d[1]).hypot(d[2]) / run.period;
                prop_assert!(v <= highest * 1.001 + 1e-9, "{v} mm/s above {highest}: {w:?}");
            }
        }
        // Moves that go nowhere end where they began, in every bit.
        prop_assert_eq!(run.samples.last().unwrap().position, *ops.last().unwrap().target().unwrap());
        for (i, op) in ops.iter().enumerate() {
            let stops = matches!(op, Op::Feed { path: PathMode::ExactStop, .. }
                | Op::Arc { path: PathMode::ExactStop, .. });
            if stops && *op.target().unwrap() != run.from(i) {
                prop_assert!(run.rests_on(*op.target().unwrap()), "move {} of {:?}", i, ops);
            }
        }
    }

    /// Nothing stops that need not, whatever the override is that is not 0.
    #[test]
    fn nothing_rests_without_a_reason(
        machine in machine(),
        pieces in prop::collection::vec(piece(), 1..8),
        events in prop_oneof![Just(vec![]), overrides()],
    ) {
        let ops = build(&pieces);
        // What is to be passed at a lowest feed may be too short for any other speed.
        prop_assume!(!ops.iter().any(|op| matches!(op,
            Op::Feed { path: PathMode::InnerCorners(_), .. } | Op::Arc { path: PathMode::InnerCorners(_), .. })));
        let run = run_with(&machine, Position::ZERO, &ops, &events, &[]);
        // Of a stop within the limits of jerk a sample is no faster than this; without them, one rests. What is told is the speed
        // of X, Y and Z; where these turn back, A may go on.
        let jerks = Limits::new(&machine).jerk;
        let least = |jerk: f64| if jerk.is_finite() { 0.125 * jerk * run.period * run.period } else { 0.0 };
        let linear = least(jerks.into_iter().take(3).fold(0.0, f64::max));
        let turned = |k: usize| run.samples[k].position[Axis::A] - run.samples[k.saturating_sub(1)].position[Axis::A];
        let moving = |k: &usize| {
            run.samples[*k].velocity > linear || turned(*k).abs() > run.period * least(jerks[3])
        };
        let all = 0..run.samples.len();
        let first = all.clone().find(moving).unwrap_or(0);
        let last = all.rev().find(moving).unwrap_or(0);
        for k in (first..last).filter(|k| !moving(k)) {
            let s = &run.samples[k];
            let tag = s.tag as usize;
            let near = tag.saturating_sub(3)..(tag + 4).min(ops.len());
            // Where the speed is as low as that the end of a move is not far.
            let has_reason = near.clone().any(|i| {
                ops[i].target().unwrap().distance(s.position) < 0.01 && must_rest(&machine, &ops, &run, i)
            });
            prop_assert!(has_reason, "{s:?} in {:?}", ops.get(near));
        }
    }

    #[test]
    fn abort_ends_on_the_path(
        machine in set_machine(),
        pieces in prop::collection::vec(piece(), 1..5),
        events in events(),
        tick in 0..1500usize,
    ) {
        let ops = build(&pieces);
        let mut events: Vec<_> = events.into_iter().filter(|(t, _)| *t < tick).collect();
        events.push((tick, Event::Abort));
        let run = run_with(&machine, Position::ZERO, &ops, &events, &[]);
        run.check_limits(&machine);
        run.check_path_within(|number| tolerance(&machine, &ops, number) + 1e-6);
    }

    #[test]
    fn feed_holds_and_overrides_do_not_move_the_end(
        pieces in prop::collection::vec(piece(), 1..4),
        events in events(),
    ) {
        let ops = build(&pieces);
        let plain = run(&demo(), Position::ZERO, &ops);
        plain.check_feed();
        let disturbed = run_with(&demo(), Position::ZERO, &ops, &events, &[]);
        prop_assert!(close(plain.samples.last().unwrap().position, disturbed.samples.last().unwrap().position));
    }

    /// Numbers that no interpreter passes on must not hang, panic or lose the axes.
    #[test]
    fn senseless_moves_do_no_harm(
        moves in prop::collection::vec((wild(), wild(), wild(), wild(), wild(), wild(), 0..4u8), 1..30),
        events in events(),
    ) {
        let machine = demo();
        let mut motion = Motion::new(&machine, Position::ZERO);
        let mut at = Position::ZERO;
        let mut moves = moves.into_iter();
        for tick in 0..400 {
            while motion.free() > 0 {
                let Some((x, y, a, b, sweep, feed, kind)) = moves.next() else {
                    motion.finish();
                    break;
                };
                let mut to = Position::xyz(x, y, b);
                to[Axis::A] = a;
                let feed = Feed::PerMinute(feed);
                let op = match kind {
                    0 => Op::Feed { to, feed, path: PathMode::Continuous },
                    1 => Op::Rapid { to, straight: a > b, speed: None, path: PathMode::ON_PATH },
                    2 => Op::Feed { to, feed: Feed::Duration(b), path: PathMode::ContinuousWithin(a) },
                    _ => Op::Arc { to, plane: Plane::Zx, center: [a, x], sweep, feed, feed_along: FeedAlong::Circle,
                        path: PathMode::Continuous },
                };
                if let Some(m) = Move::from_step(&op, at, x, 0) {
                    at = to;
                    prop_assert_eq!(motion.push(&m), Ok(()));
                }
            }
            for (_, event) in events.iter().filter(|(t, _)| *t == tick) {
                match event {
                    Event::Override(feed, rapid) => motion.set_override(*feed, *rapid),
                    Event::Hold => motion.hold(),
                    _ => motion.resume(),
                }
            }
            prop_assert!(motion.tick().position.is_finite());
        }
        motion.abort();
        let rested = (0..100_000).any(|_| motion.tick().state == State::Idle);
        prop_assert!(rested);
    }
}

/// Any number.
fn wild() -> impl Strategy<Value = f64> {
    let size = (-320.0..12.0f64).prop_map(|e| 10f64.powf(e));
    prop_oneof![
        Just(0.0),
        Just(-0.0),
        Just(f64::NAN),
        Just(f64::INFINITY),
        Just(1e9),
        -100.0..100.0f64,
        (-9.0..3.0f64).prop_map(|e| 10f64.powf(e)),
        size.prop_map(|s| -s),
        -1e9..1e9f64,
    ]
}
