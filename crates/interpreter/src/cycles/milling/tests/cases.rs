//! The conformance cases of the cycles, judged as they are judged there.

use super::super::{CycleMove, Problem, Side};
use super::{circle_finish_example, cut, model::Path, rect_example, rect_finish_example, round_example};

const TOL: f64 = 0.002;

/// What a `contains` step asks for.
enum Want {
    RapidZ(f64),
    FeedZ(f64),
    Arc,
}
use Want::{Arc, FeedZ, RapidZ};

fn contains(path: &Path, wants: &[Want]) {
    let mut steps = path.segments.iter();
    for (n, want) in wants.iter().enumerate() {
        let found = steps.any(|s| match (want, s.step) {
            (RapidZ(z), CycleMove::Rapid { to }) | (FeedZ(z), CycleMove::Feed { to }) => {
                (to[2] - z).abs() < 0.0005
            }
            (Arc, CycleMove::Arc { .. }) => true,
            _ => false,
        });
        assert!(found, "never reached step {n}");
    }
}

fn extent(path: &Path, arcs_only: bool) -> ([f64; 3], [f64; 3]) {
    let (mut min, mut max) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for p in path.cutting().filter(|s| s.is_arc() || !arcs_only).flat_map(|s| s.points()) {
        for k in 0..3 {
            (min[k], max[k]) = (min[k].min(p[k]), max[k].max(p[k]));
        }
    }
    (min, max)
}

fn near(got: f64, want: f64) {
    assert!((got - want).abs() <= TOL, "{got} instead of {want}");
}

fn near_all(pairs: &[(f64, f64)]) {
    pairs.iter().for_each(|(got, want)| near(*got, *want));
}

fn count_arcs(path: &Path, degrees: f64) -> usize {
    let is = |s: &CycleMove| matches!(s, CycleMove::Arc { sweep, .. } if (sweep.to_degrees() - degrees).abs() < 0.0005);
    path.segments.iter().filter(|s| is(&s.step)).count()
}

#[test]
fn g22_round_pocket() {
    let path = cut(round_example().plan(), 5.0);
    assert_eq!(path.depths(), [-15.0, -25.0, -35.0, -45.0, -50.0]);
    let far = path
        .cutting()
        .flat_map(|s| s.points())
        .fold(0.0f64, |far, p| far.max((p[0] - 25.0).hypot(p[1] - 25.0)));
    near(far, 45.0);
    let (min, max) = extent(&path, false);
    near_all(&[(min[0], -20.0), (min[1], -20.0), (min[2], -50.0), (max[0], 70.0), (max[1], 70.0)]);
    let wants = [
        [RapidZ(5.0), RapidZ(5.0), RapidZ(-5.0), FeedZ(-25.0)],
        [RapidZ(5.0), RapidZ(5.0), RapidZ(-15.0), FeedZ(-35.0)],
        [RapidZ(5.0), RapidZ(5.0), RapidZ(-25.0), FeedZ(-45.0)],
        [RapidZ(5.0), RapidZ(5.0), RapidZ(-35.0), FeedZ(-50.0)],
    ];
    let mut wants: Vec<Want> = wants.into_iter().flatten().collect();
    wants.push(RapidZ(5.0));
    contains(&path, &wants);
    assert_eq!(path.segments.last().unwrap().to()[2], 5.0);
}

#[test]
fn g22_no_i_193() {
    let fault = super::super::RoundPocket { radius: None, ..round_example() }.plan().unwrap_err();
    assert_eq!((fault.problem, fault.letter), (Problem::SizeMissing, Some(b'I')));
}

#[test]
fn g24_inner_finish() {
    let path = cut(circle_finish_example(Side::Inside).plan(), 5.0);
    assert_eq!(path.depths(), [-50.0]);
    let (min, max) = extent(&path, true);
    near_all(&[(min[1], -20.0), (max[1], 70.0), (min[2], -50.0), (max[2], -50.0)]);
    contains(&path, &[RapidZ(5.0), FeedZ(-50.0), Arc, RapidZ(5.0)]);
    assert_eq!((count_arcs(&path, -360.0), count_arcs(&path, -180.0), count_arcs(&path, 360.0)), (0, 0, 1));
}

#[test]
fn g26_outer_finish() {
    let path = cut(circle_finish_example(Side::Outside).plan(), 5.0);
    assert_eq!(path.depths(), [-50.0]);
    let (min, max) = extent(&path, true);
    near_all(&[(min[1], -30.0), (max[1], 80.0), (min[2], -50.0), (max[2], -50.0)]);
    contains(&path, &[RapidZ(5.0), FeedZ(-50.0), Arc, RapidZ(5.0)]);
    // The transition arcs turn the other way (4.6.3).
    assert_eq!((count_arcs(&path, -360.0), count_arcs(&path, -180.0), count_arcs(&path, 360.0)), (0, 2, 1));
}

#[test]
fn g33_rect_pocket() {
    let path = cut(rect_example().plan(), 5.0);
    assert_eq!(path.depths(), [-15.0, -25.0, -35.0, -45.0, -50.0]);
    let (min, max) = extent(&path, false);
    near_all(&[(min[0], -5.0), (min[1], 5.0), (min[2], -50.0), (max[0], 55.0), (max[1], 45.0)]);
    contains(&path, &[RapidZ(5.0), RapidZ(5.0), RapidZ(5.0), RapidZ(5.0)]);
}

#[test]
fn g33_l_wide_186() {
    let mut words = rect_example();
    words.roughing.step = Some(12.0);
    let fault = words.plan().unwrap_err();
    assert_eq!((fault.problem, fault.letter), (Problem::StepTooLarge, Some(b'L')));
}

#[test]
fn g35_rect_finish() {
    let mut words = rect_finish_example(Side::Inside);
    words.distance = Some(40.0);
    let plan = words.plan();
    assert_eq!(plan.unwrap().start(), [10.0, 0.0]);
    let path = cut(plan, 5.0);
    assert_eq!(path.depths(), [-50.0]);
    let (min, max) = extent(&path, false);
    near_all(&[(min[0], -25.0), (min[1], -20.0), (min[2], -50.0), (max[0], 45.0), (max[1], 20.0)]);
    contains(&path, &[RapidZ(5.0), FeedZ(-50.0), RapidZ(5.0)]);
}

/// The example as printed: X10 L30 I80 puts the wall at 40 and the middle at 0.
#[test]
fn g35_start_is_l_from_the_side() {
    let (min, max) = extent(&cut(rect_finish_example(Side::Inside).plan(), 5.0), false);
    near(min[0], -35.0);
    near(max[0], 35.0);
}

#[test]
fn g37_start_is_l_from_the_side() {
    let (min, max) = extent(&cut(rect_finish_example(Side::Outside).plan(), 5.0), false);
    // The side is at 10 − 30, the other one 80 further; the start reaches out to 10.
    near_all(&[(min[0], -105.0), (max[0], 10.0), (min[1], -30.0), (max[1], 30.0)]);
}

/// G98: straight up to the initial level, without a stop at R.
#[test]
fn returns_in_one_move() {
    let path = cut(round_example().plan(), 50.0);
    let [.., cut, up] = path.segments.as_slice() else { panic!() };
    assert!(cut.is_arc());
    assert_eq!((up.from[2], up.to()[2]), (-50.0, 50.0));
}
