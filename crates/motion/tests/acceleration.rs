//! Acceleration before interpolation: linear and S-shaped ramps of the path and of the axes, measured in setpoints.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{Event, Run, demo, line, round_machine, run, run_with};
use ferrocut_geometry::Position;
use ferrocut_machine::{Machine, Ramp};
use ferrocut_toolpath::{Op, PathMode};

const PERIOD: f64 = 0.001;

/// A ramp of the path; a linear one with axes that have no jerk limit while cutting.
fn cutting(ramp: Ramp) -> Machine {
    let mut machine = round_machine();
    machine.path.ramp = Some(ramp);
    if ramp.jerk == 0.0 {
        for axis in &mut machine.axes {
            axis.before_cutting = Some(Ramp { acceleration: axis.acceleration, jerk: 0.0 });
        }
    }
    machine
}

/// A run without the periods before it moves.
fn moving(machine: &Machine, ops: &[Op]) -> Run {
    let mut run = run(machine, Position::ZERO, ops);
    let first = run.samples.iter().position(|s| s.velocity > 0.0).unwrap();
    run.samples.drain(..first);
    run
}

/// Time after which the speed is first this.
fn time_to(run: &Run, v: f64) -> f64 {
    (run.samples.iter().position(|s| s.velocity >= v * (1.0 - 1e-6)).unwrap() + 1) as f64 * PERIOD
}

#[test]
fn a_linear_ramp_has_one_acceleration() {
    let machine = cutting(Ramp { acceleration: 1000.0, jerk: 0.0 });
    // To 100 mm/s in 100 ms, in whatever direction.
    for to in [[60.0, 0.0], [40.0, 40.0]] {
        let run = moving(&machine, &[line(to[0], to[1], 0.0, 6000.0, PathMode::Continuous)]);
        assert!((time_to(&run, 100.0) - 0.1).abs() <= 0.0012, "{}", time_to(&run, 100.0));
        for (k, s) in run.samples.iter().enumerate().take(99) {
            let straight = (k + 1) as f64;
            assert!((s.velocity - straight).abs() <= 0.002 * straight + 0.001, "{k}: {s:?}");
        }
        // Braking is the same.
        let top = run.samples.iter().rposition(|s| s.velocity >= 99.9999).unwrap();
        let last = run.samples.iter().rposition(|s| s.velocity > 0.0).unwrap();
        assert!((98..=102).contains(&(last - top)), "{top} {last}");
    }
}

#[test]
fn an_s_ramp_builds_its_acceleration_up() {
    // To 100 mm/s in 200 ms: 1000 mm/s² in the middle, 10,000 mm/s³.
    let machine = cutting(Ramp { acceleration: 1000.0, jerk: 10_000.0 });
    let ops = [line(40.0, 40.0, 0.0, 6000.0, PathMode::Continuous)];
    let run = moving(&machine, &ops);
    run.check_limits(&machine);
    assert!((time_to(&run, 100.0) - 0.2).abs() <= 0.002, "{}", time_to(&run, 100.0));
    // v = j·t²/2 in the first half.
    for k in [50, 100] {
        let (t, v) = (k as f64 * PERIOD, run.samples[k - 1].velocity);
        assert!((v - 5000.0 * t * t).abs() < 0.15, "{t}: {v}");
    }
    // Less speed takes less time, as the square root: 25 mm/s in 100 ms.
    let run = moving(&machine, &[line(40.0, 0.0, 0.0, 1500.0, PathMode::Continuous)]);
    assert!((time_to(&run, 25.0) - 0.1).abs() <= 0.002, "{}", time_to(&run, 25.0));
}

#[test]
fn a_ramp_of_the_path_keeps_axes_within_theirs() {
    // More than the axes do: nothing changes.
    let machine = cutting(Ramp { acceleration: 1e5, jerk: 1e9 });
    let ops = [
        line(30.0, 0.0, 0.0, 6000.0, PathMode::Continuous),
        line(30.0, 30.0, 0.0, 6000.0, PathMode::Continuous),
    ];
    let limited = run(&machine, Position::ZERO, &ops);
    limited.check_limits(&machine);
    assert!((limited.time() - run(&round_machine(), Position::ZERO, &ops).time()).abs() < 0.002);
}

#[test]
fn positioning_has_ramps_of_its_own() {
    let mut machine = round_machine();
    // To 15 m/min = 250 mm/s: X in 250 ms at 1000 mm/s², Y along an S in 250 ms.
    machine.axes[0].before_rapid = Some(Ramp { acceleration: 1000.0, jerk: 0.0 });
    machine.axes[1].before_rapid = Some(Ramp { acceleration: 2000.0, jerk: 16_000.0 });
    for straight in [true, false] {
        for to in [Position::xyz(200.0, 0.0, 0.0), Position::xyz(0.0, 200.0, 0.0)] {
            let ops = [Op::Rapid { to, straight, speed: None, path: PathMode::ON_PATH }];
            let run = moving(&machine, &ops);
            assert!(
                (time_to(&run, 250.0) - 0.25).abs() <= 0.002,
                "{straight} {to:?} {}",
                time_to(&run, 250.0)
            );
        }
    }
    // Cutting is as it was.
    let cut = [line(50.0, 0.0, 0.0, 6000.0, PathMode::Continuous)];
    let plain = run(&round_machine(), Position::ZERO, &cut);
    assert_eq!(run(&machine, Position::ZERO, &cut).samples, plain.samples);
    // Together on a line neither axis passes its own.
    let to = Position::xyz(200.0, 200.0, 0.0);
    let run = moving(&machine, &[Op::Rapid { to, straight: true, speed: None, path: PathMode::ON_PATH }]);
    let all: Vec<f64> = run.samples.iter().map(|s| s.position.0[0]).collect();
    for w in all.windows(3) {
        let a = (w[2] - 2.0 * w[1] + w[0]) / (PERIOD * PERIOD);
        assert!(a.abs() <= 1001.0, "{a}");
    }
    for w in all.windows(4) {
        let j = (w[3] - 3.0 * w[2] + 3.0 * w[1] - w[0]) / (PERIOD * PERIOD * PERIOD);
        assert!(j.abs() <= 16_100.0, "{j}");
    }
}

#[test]
fn a_corner_without_limits_of_jerk_is_quicker_than_a_stop() {
    let mut machine = round_machine();
    for axis in &mut machine.axes {
        axis.jerk = 0.0;
    }
    for turn in [45.0_f64, 60.0, 90.0, 135.0, 170.0] {
        let (sin, cos) = turn.to_radians().sin_cos();
        let ops = |path| {
            [line(30.0, 0.0, 0.0, 6000.0, path), line(30.0 + 30.0 * cos, 30.0 * sin, 0.0, 6000.0, path)]
        };
        let rounded = run(&machine, Position::ZERO, &ops(PathMode::ContinuousWithin(0.02)));
        rounded.check_limits(&machine);
        rounded.check_feed();
        rounded.check_path(0.02 + 1e-9);
        assert!(!rounded.stops_inside());
        let stopped = run(&machine, Position::ZERO, &ops(PathMode::ExactStop));
        // With d = |d₂ − d₁| and its largest part e, the corner is entered at v = √(8·δ·A/(d·e)) and takes 8·δ/(d·v).
        let (d, e) = ((2.0 - 2.0 * cos).sqrt(), (1.0 - cos).max(sin));
        let v = (8.0 * 0.02 * 2000.0 / (d * e)).sqrt();
        let a = 2000.0 / cos.abs().max(sin.abs());
        let reach = 4.0 * 0.02 / d;
        // Either side: what is left to slow down, and the way at the feed that it saves.
        let side = |from: f64, a: f64, way: f64| {
            (100.0 - from) / a + (way - (1e4 - from * from) / (2.0 * a)) / 100.0
        };
        let saved = side(0.0, 2000.0, 30.0) - side(v, 2000.0, 30.0 - reach) + side(0.0, a, 30.0)
            - side(v, a, 30.0 - reach)
            - 2.0 * reach / v;
        assert!(saved > 0.0);
        let found = stopped.time() - rounded.time();
        // Up to 74° it is a curve, which saves more.
        let more = if turn < 74.0 { 0.003..0.01 } else { -0.0025..0.0025 };
        assert!(more.contains(&(found - saved)), "{turn}: {found} {saved}");
    }
}

#[test]
fn a_lower_override_keeps_the_acceleration_where_no_jerk_is_limited() {
    let mut machine = demo();
    for axis in &mut machine.axes {
        (axis.rapid, axis.velocity, axis.acceleration, axis.jerk) = (5000.0, 4000.0, 800.0, 0.0);
    }
    let to = Position::xyz(0.0, 0.0, 16.0);
    for op in [
        Op::Rapid { to, straight: true, speed: None, path: PathMode::ON_PATH },
        line(0.0, 0.0, 16.0, 4000.0, PathMode::Continuous),
    ] {
        for tick in (10..250).step_by(9) {
            let events = [(0, Event::Override(0.7, 0.7)), (tick, Event::Override(0.25, 0.5))];
            let run = run_with(&machine, Position::ZERO, std::slice::from_ref(&op), &events, &[]);
            run.check_limits(&machine);
        }
    }
}
