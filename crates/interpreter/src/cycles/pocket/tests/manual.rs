//! The examples of Fagor 4.15.3, and what the steps of 4.15.2 promise.

use super::super::corner::{Corner, Drawn, profile};
use super::super::{Finish2d, Pocket2d, PocketFeed, Profile, Rough2d, Segment, Tool};
use super::random::{polygon, rectangle};
use crate::cycles::milling::CycleMove;
use std::convert::Infallible;
use std::f64::consts::PI;

type Step = (CycleMove, PocketFeed);

fn line(from: [f64; 2], to: [f64; 2]) -> Drawn {
    Drawn { segment: Segment::Line { from, to }, corner: Corner::Sharp }
}

fn arc(from: [f64; 2], to: [f64; 2], sweep: f64) -> Drawn {
    Drawn { segment: Segment::arc(from, to, sweep), corner: Corner::Sharp }
}

/// FAGOR 101: a peninsula, an arc bulging in, two chamfers.
fn fagor_101() -> Profile {
    let p = [
        [20.0, -8.0],
        [20.0, -40.0],
        [145.0, -40.0],
        [145.0, -25.0],
        [145.0, 25.0],
        [145.0, 40.0],
        [20.0, 40.0],
        [20.0, 8.0],
        [55.0, 8.0],
        [55.0, -8.0],
    ];
    let mut drawn: Vec<Drawn> = (0..10).map(|k| line(p[k], p[(k + 1) % 10])).collect();
    drawn[3] = arc(p[3], p[4], -PI);
    drawn[0].corner = Corner::Chamfer(15.0);
    drawn[5].corner = Corner::Chamfer(15.0);
    profile(&drawn).unwrap()
}

/// FAGOR 102: four chamfers, and an island with two concave quarters.
fn fagor_102() -> (Profile, Profile) {
    let p = [[20.0, 0.0], [20.0, -40.0], [145.0, -40.0], [145.0, 40.0], [20.0, 40.0]];
    let mut drawn: Vec<Drawn> = (0..5).map(|k| line(p[k], p[(k + 1) % 5])).collect();
    drawn[..4].iter_mut().for_each(|d| d.corner = Corner::Chamfer(15.0));
    let island = [
        line([115.0, -25.0], [115.0, 0.0]),
        arc([115.0, 0.0], [90.0, 25.0], -PI / 2.0),
        line([90.0, 25.0], [50.0, 25.0]),
        line([50.0, 25.0], [50.0, 0.0]),
        arc([50.0, 0.0], [75.0, -25.0], -PI / 2.0),
        line([75.0, -25.0], [115.0, -25.0]),
    ];
    (profile(&drawn).unwrap(), profile(&island).unwrap())
}

fn tool(radius: f64) -> Tool {
    Tool { radius, cutting_length: 30.0, ..Tool::default() }
}

fn first_example() -> Pocket2d {
    Pocket2d {
        outer: fagor_101(),
        islands: vec![],
        surface: 0.0,
        safety: 5.0,
        depth: 10.0,
        wall_stock: 0.5,
        floor_stock: 0.5,
        rough: Some(Rough2d { tool: tool(5.0), step: 7.0, depth_step: 5.0, entry_angle: 0.0 }),
        finish: Some(Finish2d { tool: tool(4.0), step: 0.0, passes: 1.0, entry_angle: 0.0 }),
    }
}

fn second_example() -> Pocket2d {
    let (outer, island) = fagor_102();
    Pocket2d {
        outer,
        islands: vec![island],
        depth: 8.0,
        floor_stock: 0.0,
        rough: Some(Rough2d { tool: tool(5.0), step: 6.0, depth_step: -3.0, entry_angle: 0.0 }),
        finish: Some(Finish2d { tool: tool(5.0), step: 0.0, passes: 2.0, entry_angle: 0.0 }),
        ..first_example()
    }
}

fn steps(pocket: &Pocket2d, from: [f64; 3]) -> (Vec<Step>, Vec<Step>) {
    let plan = pocket.plan().unwrap();
    let (mut rough, mut finish) = (Vec::new(), Vec::new());
    let Ok(()) = plan.rough(from, &mut |step, feed| -> Result<(), Infallible> {
        rough.push((step, feed));
        Ok(())
    });
    let Ok(()) = plan.finish(from, &mut |step, feed| -> Result<(), Infallible> {
        finish.push((step, feed));
        Ok(())
    });
    (rough, finish)
}

fn to(step: &CycleMove) -> [f64; 3] {
    match *step {
        CycleMove::Rapid { to } | CycleMove::Feed { to } | CycleMove::Arc { to, .. } => to,
    }
}

/// Levels of level cuts, in order of first appearance.
fn levels(steps: &[Step], from: [f64; 3]) -> Vec<f64> {
    let (mut at, mut seen) = (from, Vec::<f64>::new());
    for (step, _) in steps {
        let end = to(step);
        let level = !matches!(step, CycleMove::Rapid { .. }) && (end[2] - at[2]).abs() < 1e-9;
        if level && seen.iter().all(|z| (z - end[2]).abs() > 1e-6) {
            seen.push(end[2]);
        }
        at = end;
    }
    seen
}

fn bounds(steps: &[Step], from: [f64; 3]) -> ([f64; 2], [f64; 2]) {
    let (mut at, mut low, mut high) = (from, [f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for (step, _) in steps {
        let end = to(step);
        let (a, b) = ([at[0], at[1]], [end[0], end[1]]);
        let segment = match *step {
            CycleMove::Arc { center, sweep, .. } => Some(Segment::Arc { from: a, to: b, center, sweep }),
            CycleMove::Feed { .. } => Some(Segment::Line { from: a, to: b }),
            CycleMove::Rapid { .. } => None,
        };
        if let Some(own) = segment.map(|s| s.bounds()) {
            for k in 0..2 {
                low[k] = low[k].min(own.low[k]);
                high[k] = high[k].max(own.high[k]);
            }
        }
        at = end;
    }
    (low, high)
}

fn close(a: f64, b: f64) {
    assert!((a - b).abs() < 5e-4, "{a} instead of {b}");
}

#[test]
fn first_example_of_the_manual() {
    let from = [0.0, 0.0, 50.0];
    let (rough, finish) = steps(&first_example(), from);
    assert_eq!(levels(&rough, from), [-4.75, -9.5]);
    assert_eq!(levels(&finish, from), [-10.0]);
    let (low, high) = bounds(&finish, from);
    [low[0] - 24.0, low[1] + 36.0, high[0] - 141.0, high[1] - 36.0].into_iter().for_each(|d| close(d, 0.0));
    // From above first in the plane, then to the safety plane and to 1 mm above the surface.
    let start = to(&rough[0].0);
    assert_eq!((start[2], to(&rough[1].0)[2], to(&rough[2].0)[2]), (50.0, 5.0, 1.0));
    assert_eq!(rough[3], (CycleMove::Feed { to: [start[0], start[1], -4.75] }, PocketFeed::Plunge));
    // To 1 mm above each level.
    for above in [-3.75, -8.5] {
        assert!(rough.iter().any(|s| matches!(s.0, CycleMove::Rapid { to } if (to[2] - above).abs() < 1e-9)));
    }
    assert!(finish.iter().any(|s| matches!(s.0, CycleMove::Rapid { to } if (to[2] + 8.5).abs() < 1e-9)));
    // The arc bulging in, unbroken: of radius 25 + 4 as far as x = 141 lets it.
    let whole = 2.0 * (4.0f64 / 29.0).acos();
    let arc = |s: &Step| match s.0 {
        CycleMove::Arc { center, sweep, to } => {
            (center[0] - 145.0).abs() < 5e-4
                && center[1].abs() < 5e-4
                && to[2] == -10.0
                && (sweep.abs() - whole).abs() < 1e-3
        }
        _ => false,
    };
    assert_eq!(finish.iter().filter(|s| arc(s)).count(), 1);
    for steps in [&rough, &finish] {
        assert_eq!(to(&steps.last().unwrap().0)[2], 5.0);
    }
}

#[test]
fn second_example_of_the_manual() {
    let from = [0.0, 0.0, 50.0];
    let (rough, finish) = steps(&second_example(), from);
    assert_eq!(levels(&rough, from), [-3.0, -6.0, -8.0]);
    assert_eq!(levels(&finish, from), [-8.0, -4.0]);
    let (low, high) = bounds(&finish, from);
    [low[0] - 25.0, low[1] + 35.0, high[0] - 140.0, high[1] - 35.0].into_iter().for_each(|d| close(d, 0.0));
    // Defined clockwise, the island is cut the other way: its hollow quarters turn by +90 on both levels.
    for z in [-4.0, -8.0] {
        for [cx, cy] in [[115.0, 25.0], [50.0, -25.0]] {
            let quarter = |s: &&Step| match s.0 {
                CycleMove::Arc { center, sweep, to } => {
                    (center[0] - cx).abs() < 5e-4
                        && (center[1] - cy).abs() < 5e-4
                        && (sweep.to_degrees() - 90.0).abs() < 5e-4
                        && (to[2] - z).abs() < 1e-9
                }
                _ => false,
            };
            assert!(finish.iter().filter(quarter).count() >= 1, "no quarter about {cx}, {cy} at {z}");
        }
    }
}

/// With Zs below Z the pocket is cut upwards; with both in one the sign of P decides (4.1.2).
#[test]
fn direction_of_machining() {
    let upward = Pocket2d { safety: -5.0, ..first_example() };
    let (rough, finish) = steps(&upward, [0.0, 0.0, -50.0]);
    assert_eq!(levels(&rough, [0.0; 3]), [4.75, 9.5]);
    assert_eq!(levels(&finish, [0.0; 3]), [10.0]);
    assert_eq!(to(&rough.last().unwrap().0)[2], -5.0);
    for (depth, level) in [(10.0, -4.75), (-10.0, 4.75)] {
        let (rough, _) = steps(&Pocket2d { safety: 0.0, depth, ..first_example() }, [0.0, 0.0, 50.0]);
        assert_eq!(levels(&rough, [0.0; 3])[0], level);
    }
}

/// From below the safety plane the tool goes up first (4.1.2).
#[test]
fn from_below_the_safety_plane() {
    let (rough, _) = steps(&first_example(), [0.0, 0.0, 2.0]);
    assert_eq!(rough[0].0, CycleMove::Rapid { to: [0.0, 0.0, 5.0] });
}

/// Outer rings go as the outer profile was drawn.
#[test]
fn direction_of_the_outer_profile() {
    for clockwise in [false, true] {
        let drawn = rectangle([0.0, 0.0], [40.0, 30.0]);
        let outer = if clockwise { drawn.reversed() } else { drawn };
        let pocket = Pocket2d { outer, ..first_example() };
        let (rough, finish) = steps(&pocket, [0.0, 0.0, 50.0]);
        for steps in [rough, finish] {
            // Twice the area about the middle that level moves enclose.
            let mut at = [0.0; 3];
            let mut area = 0.0;
            for (step, _) in &steps {
                let end = to(step);
                if !matches!(step, CycleMove::Rapid { .. }) {
                    area += (at[0] - 20.0) * (end[1] - 15.0) - (at[1] - 15.0) * (end[0] - 20.0);
                }
                at = end;
            }
            assert_eq!(area < 0.0, clockwise);
        }
    }
}

/// All passes are equal and none above Δ: 7 over a span of 15 − 5.5 makes two.
#[test]
fn equal_passes() {
    let pocket = Pocket2d { outer: rectangle([0.0, 0.0], [60.0, 30.0]), finish: None, ..first_example() };
    let plan = pocket.plan().unwrap();
    let rough = plan.rough.as_ref().unwrap();
    let mut offsets: Vec<f64> = rough
        .clearing
        .chains
        .iter()
        .flat_map(|c| &c.path)
        .filter(|s| s.length() > 10.0)
        .map(|s| plan.walls.distance(s.point(0.5)))
        .collect();
    offsets.sort_by(f64::total_cmp);
    offsets.dedup_by(|a, b| (*a - *b).abs() < 0.01);
    assert!(offsets.len() == 2 && (offsets[1] - offsets[0] - 4.75).abs() < 0.15, "{offsets:?}");
}

/// Two lobes joined by a neck that the tool does not pass: two holes to drill, one in each.
#[test]
fn drill_points() {
    let outer = polygon(&[
        [0.0, 0.0],
        [30.0, 0.0],
        [30.0, 12.0],
        [40.0, 12.0],
        [40.0, 0.0],
        [70.0, 0.0],
        [70.0, 30.0],
        [40.0, 30.0],
        [40.0, 18.0],
        [30.0, 18.0],
        [30.0, 30.0],
        [0.0, 30.0],
    ]);
    let pocket = Pocket2d { outer, ..first_example() };
    let points = pocket.plan().unwrap().drill_points();
    assert_eq!(points.len(), 2);
    assert!(points.iter().filter(|p| p[0] < 30.0).count() == 1 && points.iter().all(|p| p[1] > 5.0));
    let plan = pocket.plan().unwrap();
    // 4.15: the diameter of the drill against the radius of the tool, 5.
    assert_eq!(plan.drilling(2.5).unwrap(), points);
    assert_eq!(plan.drilling(2.6).unwrap_err().problem, super::super::Problem::DrillTooLarge);
    // Straight down, the tool enters exactly there.
    let (rough, _) = steps(&pocket, [0.0, 0.0, 50.0]);
    for (step, feed) in &rough {
        if let (CycleMove::Feed { to }, PocketFeed::Plunge) = (step, feed) {
            assert!(points.iter().any(|p| (p[0] - to[0]).abs() < 1e-9 && (p[1] - to[1]).abs() < 1e-9));
        }
    }
}
