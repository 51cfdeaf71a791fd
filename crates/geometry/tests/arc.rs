//! Arcs against plain geometry, for random ones.

use ferrocut_geometry::{Arc, Axis, Plane, Position, RadiusError, Turn};
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

fn plane() -> impl Strategy<Value = Plane> {
    prop_oneof![Just(Plane::Xy), Just(Plane::Zx), Just(Plane::Yz)]
}

fn turn() -> impl Strategy<Value = Turn> {
    prop_oneof![Just(Turn::Clockwise), Just(Turn::CounterClockwise)]
}

fn on_circle(plane: Plane, c: [f64; 2], r: f64, angle: f64, height: f64) -> Position {
    let mut p = Position::ZERO;
    p[plane.first()] = c[0] + r * angle.cos();
    p[plane.second()] = c[1] + r * angle.sin();
    p[plane.normal()] = height;
    p
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]

    #[test]
    fn every_point_keeps_its_radius_and_the_sense_is_right(
        plane in plane(), turn in turn(),
        ca in -500.0..500.0f64, cb in -500.0..500.0f64, r in 0.01..800.0f64,
        a0 in -PI..PI, a1 in -PI..PI, z in -50.0..50.0f64,
    ) {
        prop_assume!((a1 - a0).abs() > 1e-6);
        let start = on_circle(plane, [ca, cb], r, a0, 0.0);
        let end = on_circle(plane, [ca, cb], r, a1, z);
        let arc = Arc::about(plane, start, end, [ca, cb], turn);
        prop_assert_eq!(arc.sweep > 0.0, turn == Turn::CounterClockwise);
        prop_assert!(arc.sweep.abs() <= TAU);
        prop_assert_eq!(arc.at(0.0), start);
        prop_assert_eq!(arc.at(1.0), end);
        let (min, max) = arc.extent();
        for i in 0..=100 {
            let t = f64::from(i) / 100.0;
            let p = arc.at(t);
            let [a, b] = plane.of(p);
            prop_assert!(((a - ca).hypot(b - cb) - r).abs() < 1e-9);
            prop_assert!((p[plane.normal()] - z * t).abs() < 1e-9);
            for axis in Axis::ALL {
                prop_assert!(min[axis] - 1e-9 <= p[axis] && p[axis] <= max[axis] + 1e-9);
            }
        }
        // The extent is reached, not only kept.
        let reached = (0..=20_000).map(|i| arc.at(f64::from(i) / 20_000.0)).fold((start, start), |m, p| (m.0.min(p), m.1.max(p)));
        let coarse = r * (arc.sweep / 20_000.0).powi(2);
        prop_assert!((reached.0[plane.first()] - min[plane.first()]).abs() <= coarse + 1e-9);
        prop_assert!((reached.1[plane.second()] - max[plane.second()]).abs() <= coarse + 1e-9);
    }

    #[test]
    fn a_radius_gives_the_short_arc_and_a_negative_one_the_long(
        turn in turn(), r in 0.01..800.0f64, a0 in -PI..PI, sweep in 0.001..(PI - 0.001),
    ) {
        let start = [r * a0.cos(), r * a0.sin()];
        let a1 = if turn == Turn::Clockwise { a0 - sweep } else { a0 + sweep };
        let end = [r * a1.cos(), r * a1.sin()];
        let c = Arc::center_from_radius(start, end, r, turn, 0.0).unwrap();
        prop_assert!(c[0].hypot(c[1]) < 1e-6 * r / sweep.sin().abs(), "{:?}", c);
        let long = Arc::center_from_radius(start, end, -r, turn, 0.0).unwrap();
        let p = |q: [f64; 2]| Position::xyz(q[0], q[1], 0.0);
        let s = Arc::about(Plane::Xy, p(start), p(end), c, turn).sweep.abs();
        let l = Arc::about(Plane::Xy, p(start), p(end), long, turn).sweep.abs();
        prop_assert!(s < PI && l > PI && (s + l - TAU).abs() < 1e-6);
    }
}

#[test]
fn start_equal_to_end_is_a_full_turn() {
    let p = Position::xyz(10.0, 0.0, 0.0);
    assert_eq!(Arc::about(Plane::Xy, p, p, [0.0, 0.0], Turn::Clockwise).sweep, -TAU);
    assert_eq!(Arc::about(Plane::Xy, p, p, [0.0, 0.0], Turn::CounterClockwise).sweep, TAU);
}

#[test]
fn a_radius_that_cannot_reach_says_why() {
    let far = Arc::center_from_radius([0.0, 0.0], [10.0, 0.0], 4.0, Turn::Clockwise, 0.01);
    assert_eq!(far, Err(RadiusError::TooFarApart(2.0)));
    let same = Arc::center_from_radius([1.0, 1.0], [1.0, 1.0], 4.0, Turn::Clockwise, 0.01);
    assert_eq!(same, Err(RadiusError::SamePoint));
    let diameter = Arc::center_from_radius([0.0, 0.0], [10.001, 0.0], 5.0, Turn::Clockwise, 0.01);
    assert_eq!(diameter, Ok([5.0005, 0.0]));
}
