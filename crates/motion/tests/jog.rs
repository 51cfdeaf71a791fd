//! Axes moved by hand: limits at every sample whatever is asked for and when, exact ends, and no slower than the
//! time-optimal profiles of another library.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

use assert_no_alloc::{AllocDisabler, assert_no_alloc};
use ferrocut_geometry::{Axis, Position};
use ferrocut_machine::{AxisConfig, Machine};
use ferrocut_motion::Jog;
use ferrocut_motion::jog::Surplus;
use proptest::prelude::*;

#[global_allocator]
static ALLOCATOR: AllocDisabler = AllocDisabler;

/// The demo mill with an X axis of these limits, in mm/min, mm/s², mm/s³.
fn machine(velocity: f64, acceleration: f64, jerk: f64) -> Machine {
    let mut machine = Machine::demo_mill();
    let x = &mut machine.axes[0];
    (x.min, x.max) = (-50.0, 50.0);
    (x.rapid, x.velocity, x.acceleration, x.jerk) = (velocity, velocity, acceleration, jerk);
    machine
}

/// What the operator does.
#[derive(Clone, Copy, Debug)]
enum Hand {
    Run(f64),
    Step(i64, f64, f64),
    Wheel(i64, f64, Surplus),
    Stop,
}

fn hands() -> impl Strategy<Value = Vec<(usize, Hand)>> {
    let surplus = prop_oneof![Just(Surplus::Kept), Just(Surplus::Dropped)];
    let increment = prop_oneof![Just(0.001), Just(0.01), Just(0.1), Just(1.0), Just(0.00254)];
    let hand = prop_oneof![
        (-300.0..300.0).prop_map(Hand::Run),
        (-20i64..20, increment.clone(), 1.0..200.0).prop_map(|(n, inc, v)| Hand::Step(n, inc, v)),
        (-100i64..100, increment, surplus).prop_map(|(n, inc, s)| Hand::Wheel(n, inc, s)),
        Just(Hand::Stop),
    ];
    let wait = prop_oneof![0usize..5, 0usize..80, 0usize..900];
    prop::collection::vec((wait, hand), 1..40)
}

fn act(jog: &mut Jog, hand: Hand) {
    match hand {
        Hand::Run(speed) => jog.run(Axis::X, speed),
        Hand::Step(n, increment, speed) => jog.step(Axis::X, n, increment, speed),
        Hand::Wheel(n, increment, surplus) => jog.wheel(Axis::X, n, increment, 150.0, surplus),
        Hand::Stop => jog.stop(),
    }
}

/// Positions of X from rest to rest: no difference of them above its limit. Differences are means of the
/// derivatives, so that they never exceed them; the share and the sum pay for rounding.
fn check(x: &[f64], machine: &Machine) {
    let (axis, t) = (&machine.axes[0], machine.servo_period_ms / 1000.0);
    let jerk = if axis.jerk > 0.0 { axis.jerk } else { f64::INFINITY };
    for (k, w) in x.windows(4).enumerate() {
        let v = (w[1] - w[0]) / t;
        let a = (w[2] - 2.0 * w[1] + w[0]) / (t * t);
        let j = (w[3] - 3.0 * w[2] + 3.0 * w[1] - w[0]) / (t * t * t);
        assert!(v.abs() <= axis.velocity / 60.0 * 1.001, "{k}: {v} mm/s");
        assert!(a.abs() <= axis.acceleration * 1.001 + 1e-5, "{k}: {a} mm/s²");
        assert!(j.abs() <= jerk * 1.001 + 0.2, "{k}: {j} mm/s³");
        assert!((axis.min..=axis.max).contains(&w[0]), "{k}: {} beyond", w[0]);
    }
}

fn wait(jog: &mut Jog, periods: usize) {
    for _ in 0..periods {
        jog.tick();
    }
}

/// Goes on until all stands still.
fn settle(jog: &mut Jog, x: &mut Vec<f64>) {
    for _ in 0..200_000 {
        x.push(jog.tick()[Axis::X]);
        if jog.is_at_rest() {
            let end = x[x.len() - 1];
            x.extend([end; 3]);
            return;
        }
    }
    panic!("never at rest");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn limits_hold_whatever_is_asked_for_and_when(
        hands in hands(),
        velocity in 600.0..15_000.0,
        acceleration in 50.0..5000.0,
        jerk in prop_oneof![200.0..5000.0, 5e3..2e5, Just(0.0)],
        start in -50.0..50.0,
    ) {
        let machine = machine(velocity, acceleration, jerk);
        let mut jog = Jog::new(&machine, Position::xyz(start, 0.0, 0.0));
        let mut x = vec![start; 3];
        for (wait, hand) in hands {
            act(&mut jog, hand);
            x.extend((0..wait).map(|_| jog.tick()[Axis::X]));
        }
        jog.stop();
        settle(&mut jog, &mut x);
        check(&x, &machine);
        // The same from there: ten steps end ten steps on, or on the limit.
        let from = jog.position()[Axis::X];
        jog.step(Axis::X, 10, 0.1, 50.0);
        settle(&mut jog, &mut x);
        check(&x, &machine);
        let end = jog.position()[Axis::X];
        prop_assert!(end == 50.0 || (end - from - 1.0).abs() < 1e-9, "{from} {end}");
        jog.run(Axis::X, 1e9);
        settle(&mut jog, &mut x);
        check(&x, &machine);
        prop_assert_eq!(jog.position()[Axis::X], 50.0);
    }

    #[test]
    fn from_rest_to_rest_as_fast_as_time_optimal_profiles(
        units in 1i64..9_000_000,
        scale in 0u32..4,
        velocity in 60.0..30_000.0,
        acceleration in 50.0..5000.0,
        jerk in 500.0..200_000.0,
    ) {
        let way = (units / 10i64.pow(scale)).max(1);
        let mut machine = machine(velocity, acceleration, jerk);
        machine.servo_period_ms = 0.1;
        let mut jog = Jog::new(&machine, Position::xyz(-50.0, 0.0, 0.0));
        jog.step(Axis::X, way, 0.00001, velocity / 60.0);
        let mut periods = 0u32;
        while !jog.is_at_rest() {
            jog.tick();
            periods += 1;
        }
        let mut other = rsruckig::prelude::Ruckig::<1, rsruckig::prelude::ThrowErrorHandler>::new(None, 0.0001);
        let mut input = rsruckig::prelude::InputParameter::<1>::new(None);
        let mut trajectory = rsruckig::prelude::Trajectory::<1>::new(None);
        input.target_position[0] = way as f64 * 1e-5;
        input.max_velocity[0] = velocity / 60.0;
        input.max_acceleration[0] = acceleration;
        input.max_jerk[0] = jerk;
        other.calculate(&input, &mut trajectory).unwrap();
        // The last period is begun and not filled.
        let (own, best) = (f64::from(periods) * 1e-4, trajectory.get_duration());
        prop_assert!(own <= best * 1.01 + 1e-4 && own >= best * 0.999_999, "{own} s instead of {best}");
    }
}

#[test]
fn a_released_key_stops_in_the_time_that_the_jerk_allows() {
    // 10 mm/s at 50 mm/s² and 1000 mm/s³: 10/50 + 50/1000 = 0.25 s and 1.25 mm.
    let machine = machine(600.0, 50.0, 1000.0);
    let mut jog = Jog::new(&machine, Position::ZERO);
    jog.run(Axis::X, 10.0);
    wait(&mut jog, 500);
    let (from, speed) = (jog.position()[Axis::X], jog.velocity()[Axis::X]);
    assert!((speed - 10.0).abs() < 1e-12);
    jog.run(Axis::X, 0.0);
    let periods = (1..).find(|_| jog.tick() != Position::ZERO && jog.is_at_rest()).unwrap();
    assert!((250..=251).contains(&periods), "{periods}");
    assert!((jog.position()[Axis::X] - from - 1.25).abs() < 1e-9);
}

#[test]
fn an_axis_without_limits_runs_on_and_one_beyond_them_moves_back_only() {
    let machine = machine(6000.0, 1000.0, 50_000.0);
    let mut jog = Jog::new(&machine, Position::ZERO);
    assert!(jog.set_travel(Axis::X, None));
    jog.run(Axis::X, 100.0);
    for _ in 0..60_000 {
        jog.tick();
    }
    assert!((jog.position()[Axis::X] - 5995.0).abs() < 10.0, "{:?}", jog.position());
    assert!(!jog.set_travel(Axis::X, Some((-50.0, 50.0))));
    jog.stop();
    let mut x = Vec::new();
    settle(&mut jog, &mut x);
    assert!(jog.set_travel(Axis::X, Some((-50.0, 50.0))));
    let at = jog.position();
    jog.run(Axis::X, 100.0);
    jog.wheel(Axis::X, 5, 0.1, 100.0, Surplus::Kept);
    wait(&mut jog, 1000);
    assert_eq!(jog.position(), at);
    jog.run(Axis::X, -100.0);
    settle(&mut jog, &mut x);
    assert_eq!(jog.position()[Axis::X], -50.0);
}

#[test]
fn the_axis_ends_on_the_wheel_or_lets_go_of_what_is_too_fast() {
    let machine = machine(6000.0, 1000.0, 50_000.0);
    let turn = |surplus| {
        let mut jog = Jog::new(&machine, Position::ZERO);
        // Five turns of a hundred counts in a second, 0.1 mm each; the axis may run 20 mm/s.
        for k in 0..1000 {
            jog.wheel(Axis::X, i64::from(k % 2 == 0), 0.1, 20.0, surplus);
            jog.tick();
        }
        settle(&mut jog, &mut Vec::new());
        jog.position()[Axis::X]
    };
    assert_eq!(turn(Surplus::Kept), 50.0);
    // 20 mm/s for a second, less the time to get there (20/1000 + 1000/50000 = 0.04 s at half of it).
    let end = turn(Surplus::Dropped);
    assert!((19.0..20.5).contains(&end) && (end * 10.0 - (end * 10.0).round()).abs() < 1e-9, "{end}");
}

#[test]
fn a_million_changes_leave_no_trace() {
    let machine = machine(6000.0, 1000.0, 50_000.0);
    for start in [0.0, 12.345_678_912_3] {
        let mut jog = Jog::new(&machine, Position::xyz(start, 0.0, 0.0));
        for k in 0..1_000_000u32 {
            // Three forth, one back, and the other way round: 0 in the end.
            let sign = if (k % 4 == 3) == (k % 8 < 4) { -1 } else { 1 };
            match k % 3 {
                0 => jog.step(Axis::X, sign, 0.001, 50.0),
                _ => jog.wheel(Axis::X, sign, 0.001, 100.0, Surplus::Kept),
            }
            jog.tick();
        }
        settle(&mut jog, &mut Vec::new());
        assert_eq!(jog.position()[Axis::X], start);
    }
}

#[test]
fn a_period_allocates_nothing() {
    let mut machine = Machine::demo_mill();
    let model = machine.axes[0].clone();
    machine.axes = Axis::ALL.map(|name| AxisConfig { name, ..model.clone() }).to_vec();
    let mut jog = Jog::new(&machine, Position::ZERO);
    assert_no_alloc(|| {
        for k in 0..100_000u32 {
            for (i, axis) in (0u32..).zip(Axis::ALL) {
                match (k + 37 * i) % 97 {
                    0 => jog.run(axis, f64::from(k % 500) - 250.0),
                    30 => jog.step(axis, 3, 0.1, 50.0),
                    60..75 => jog.wheel(axis, 1, 0.01, 50.0, Surplus::Dropped),
                    90 => jog.stop(),
                    _ => {}
                }
            }
            jog.tick();
        }
    });
    // Out of range, without meaning: nothing moves, nothing ends.
    let mut jog = Jog::new(&machine, Position::ZERO);
    jog.run(Axis::X, f64::NAN);
    jog.step(Axis::X, i64::MAX, f64::NAN, 50.0);
    jog.step(Axis::Y, i64::MIN, 1.0, f64::NAN);
    jog.tick();
    assert_eq!(jog.position(), Position::ZERO);
    jog.step(Axis::X, i64::MIN, 1e3, 50.0);
    wait(&mut jog, 100_000);
    assert_eq!(jog.position()[Axis::X], model.min);
}
