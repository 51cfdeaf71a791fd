//! Finished walls judged by distances: of the tool centre's path from the profile, and of the profile from
//! the path.

use super::super::finish::{Finish, finishes};
use super::super::walls::Walls;
use super::super::{Profile, Segment};
use super::random::{circle, drawing, rectangle};
use ferrocut_geometry::vector::{along, distance, dot, left};

/// 2 µm.
const EXACT: f64 = 2e-3;

fn near(segments: &[Segment], p: [f64; 2]) -> f64 {
    segments.iter().map(|s| s.distance(p)).fold(f64::INFINITY, f64::min)
}

fn samples(segment: &Segment) -> impl Iterator<Item = [f64; 2]> + '_ {
    let count = (segment.length() / 0.1).ceil().max(4.0) as u32;
    (0..=count).map(move |k| segment.point(f64::from(k) / f64::from(count)))
}

fn judge(walls: &Walls, all: &[Finish], radius: f64, clockwise: bool) {
    let wall: Vec<Segment> = walls.contours.iter().flat_map(|c| c.segments.clone()).collect();
    for finish in all {
        for p in finish.path.iter().flat_map(samples) {
            let d = near(&wall, p);
            assert!((d - radius).abs() <= EXACT, "{d} instead of {radius} at {p:?}");
        }
        for pair in finish.path.windows(2) {
            assert!(distance(pair[0].to(), pair[1].from()) < 1e-6);
        }
        let (first, last) = (finish.path.first().unwrap(), finish.path.last().unwrap());
        assert!(distance(first.from(), last.to()) < 1e-6);
        if let Some(tangent) = &finish.tangent {
            for p in samples(&tangent.on).chain(samples(&tangent.off)) {
                assert!(near(&wall, p) >= radius - EXACT, "the way on gouges");
            }
            for (a, b) in [(&tangent.on, first), (last, &tangent.off)] {
                assert!(distance(a.to(), b.from()) < 1e-6);
                assert!(dot(a.direction(1.0), b.direction(0.0)) > 1.0 - 1e-6, "{a:?} {b:?}");
            }
            let straight = [Segment::Line { from: tangent.center, to: tangent.on.from() }];
            assert!(straight.iter().flat_map(samples).all(|p| near(&wall, p) >= radius - EXACT));
        }
        // The pocket lies on the left of a path that goes round counter-clockwise.
        let s = finish.path.iter().max_by(|a, b| a.length().total_cmp(&b.length())).unwrap();
        let aside = |by: f64| near(&wall, along(s.point(0.5), left(s.direction(0.5)), by));
        let (left, right) = (aside(1e-3), aside(-1e-3));
        assert!((left > right) != clockwise || (left - right).abs() < 1e-4, "the wrong way round");
    }
    // Every point of a wall that the tool can touch is touched.
    let paths: Vec<Segment> = all.iter().flat_map(|f| f.path.clone()).collect();
    for contour in &walls.contours {
        for s in &contour.segments {
            for k in 1..20 {
                let t = f64::from(k) / 20.0;
                let center = along(s.point(t), left(s.direction(t)), radius);
                if near(&wall, center) >= radius - 1e-9 {
                    let d = near(&paths, s.point(t));
                    assert!((d - radius).abs() <= EXACT, "{d} instead of {radius} from {:?}", s.point(t));
                }
            }
        }
    }
}

#[test]
fn random_walls() {
    let (mut paths, mut smooth) = (0, 0);
    for number in 0..500 {
        let (outer, islands, mut dice) = drawing(number);
        let walls = Walls::new([&outer], &islands);
        let (radius, stock) = (dice.between(0.3, 3.0), dice.between(0.0, 0.5));
        let clockwise = outer.area() < 0.0;
        let all = finishes(&walls, clockwise, radius, stock).unwrap();
        judge(&walls, &all, radius, clockwise);
        paths += all.len();
        smooth += all.iter().filter(|f| f.tangent.is_some()).count();
    }
    assert!(paths > 500 && smooth * 10 > paths * 8, "{smooth} of {paths} with a tangent");
}

/// Arcs are not broken where the path begins: the island's corners are quarters, the boss' path a circle.
#[test]
fn arcs_stay_whole() {
    let islands = [rectangle([-12.0, -3.0], [-6.0, 3.0]), circle([8.0, 0.0], 4.0)];
    let walls = Walls::new([&rectangle([-20.0, -15.0], [20.0, 15.0])], &islands);
    let all = finishes(&walls, false, 2.0, 0.2).unwrap();
    let sweeps = |finish: &Finish| -> Vec<f64> {
        let sweep = |s: &Segment| match s {
            Segment::Arc { sweep, .. } => Some(sweep.to_degrees().round()),
            Segment::Line { .. } => None,
        };
        finish.path.iter().filter_map(sweep).collect()
    };
    let mut seen: Vec<Vec<f64>> = all.iter().map(sweeps).collect();
    seen.sort_by_key(Vec::len);
    assert_eq!(seen, [vec![], vec![-360.0], vec![-90.0; 4]]);
    assert!(all.iter().all(|f| f.tangent.is_some()));
}

/// In a slot hardly wider than the tool there is no room for a tangent: the wall is finished all the same.
#[test]
fn no_room_for_a_tangent() {
    let slot = rectangle([0.0, 0.0], [30.0, 4.1]);
    let walls = Walls::new([&slot], &[]);
    let all = finishes(&walls, false, 2.0, 0.3).unwrap();
    assert!(all.len() == 1 && all[0].tangent.is_none());
    judge(&walls, &all, 2.0, false);
    let _: &Profile = &slot;
}
