//! What forbids a pocket, and that nothing at all makes one panic or go on without end.

use super::super::{
    DepthProfile, Finish2d, Finish3d, MAX_MOVES, Plan2d, Pocket2d, Pocket3d, PocketFault, PocketFeed,
    Problem, Profile, Rough2d, Rough3d, Segment, Semi3d, Stage, Tool, WallDirection,
};
use super::deep::{depth, fagor_b};
use super::random::{Dice, circle, drawing, polygon, rectangle};
use crate::cycles::milling::CycleMove;
use std::convert::Infallible;

fn tool(radius: f64) -> Tool {
    Tool { radius, cutting_length: 30.0, ..Tool::default() }
}

fn pocket() -> Pocket2d {
    Pocket2d {
        outer: rectangle([0.0, 0.0], [60.0, 40.0]),
        islands: vec![circle([20.0, 20.0], 5.0), rectangle([35.0, 15.0], [45.0, 25.0])],
        surface: 0.0,
        safety: 5.0,
        depth: 6.0,
        wall_stock: 0.2,
        floor_stock: 0.2,
        rough: Some(Rough2d { tool: tool(3.0), step: 0.0, depth_step: 3.0, entry_angle: 5.0 }),
        finish: Some(Finish2d { tool: tool(2.0), step: 0.0, passes: 0.0, entry_angle: 0.0 }),
    }
}

fn fault(change: impl Fn(&mut Pocket2d)) -> (Problem, &'static str, Option<usize>) {
    let mut pocket = pocket();
    change(&mut pocket);
    let PocketFault { problem, parameter, contour, .. } = pocket.plan().map(|_| ()).unwrap_err();
    (problem, parameter, contour)
}

#[test]
fn profiles() {
    assert!(pocket().plan().is_ok());
    let outer = |profile: Profile| fault(|p| p.outer = profile.clone());
    assert_eq!(outer(Profile::default()), (Problem::ProfileEmpty, "profile", Some(0)));
    let mut open = rectangle([0.0, 0.0], [60.0, 40.0]);
    open.segments.pop();
    assert_eq!(outer(open), (Problem::ProfileOpen, "profile", Some(0)));
    let mut gap = rectangle([0.0, 0.0], [60.0, 40.0]);
    gap.segments.remove(1);
    assert_eq!(outer(gap), (Problem::ProfileOpen, "profile", Some(0)));
    let bow = polygon(&[[0.0, 0.0], [60.0, 40.0], [60.0, 0.0], [0.0, 40.0]]);
    assert_eq!(outer(bow).0, Problem::ProfileEmpty);
    let eight = polygon(&[[0.0, 0.0], [60.0, 40.0], [60.0, 0.0], [0.0, 30.0]]);
    assert_eq!(outer(eight), (Problem::ProfileCrossesItself, "profile", Some(0)));
    let touching = polygon(&[[0.0, 0.0], [60.0, 0.0], [60.0, 40.0], [30.0, 0.0], [0.0, 40.0]]);
    assert_eq!(outer(touching).0, Problem::ProfileCrossesItself);
    let spike = polygon(&[[0.0, 0.0], [60.0, 0.0], [60.0, 40.0], [60.0, 60.0], [60.0, 40.0], [0.0, 40.0]]);
    assert_eq!(outer(spike).0, Problem::ProfileCrossesItself);
    // Elements far shorter than any tolerance still join.
    let fine: Vec<[f64; 2]> = (0..30_000).map(|k| [f64::from(k) * 3e-4, 0.0]).collect();
    let fine = [fine.as_slice(), &[[9.0, 40.0], [0.0, 40.0]]].concat();
    assert!(polygon(&fine).checked().is_ok());
    let mut arc = rectangle([0.0, 0.0], [60.0, 40.0]);
    arc.segments[1] = Segment::Arc { from: [60.0, 0.0], to: [60.0, 40.0], center: [50.0, 20.0], sweep: 1.0 };
    assert_eq!(outer(arc), (Problem::ArcEnds, "profile", Some(0)));
    let mut wild = rectangle([0.0, 0.0], [60.0, 40.0]);
    wild.segments[1] = Segment::Line { from: [60.0, 0.0], to: [f64::NAN, 40.0] };
    assert_eq!(outer(wild).0, Problem::OutOfRange);
}

#[test]
fn islands() {
    let second = |island: Profile| fault(|p| p.islands[1] = island.clone());
    assert_eq!(second(circle([100.0, 20.0], 5.0)), (Problem::IslandOutside, "profile", Some(2)));
    assert_eq!(second(circle([60.0, 20.0], 5.0)), (Problem::IslandCrosses, "profile", Some(2)));
    assert_eq!(second(circle([24.0, 20.0], 5.0)), (Problem::IslandCrosses, "profile", Some(2)));
    assert_eq!(second(circle([20.0, 20.0], 2.0)), (Problem::IslandCrosses, "profile", Some(2)));
    assert_eq!(second(circle([55.0, 20.0], 5.0)), (Problem::IslandCrosses, "profile", Some(2)));
    assert_eq!(second(rectangle([-10.0, -10.0], [90.0, 90.0])).0, Problem::IslandOutside);
}

#[test]
fn parameters() {
    let rough = |change: fn(&mut Rough2d)| fault(|p| change(p.rough.as_mut().unwrap()));
    let finish = |change: fn(&mut Finish2d)| fault(|p| change(p.finish.as_mut().unwrap()));
    assert_eq!(fault(|p| p.depth = 0.0), (Problem::DepthMissing, "P", None));
    assert_eq!(fault(|p| p.wall_stock = -0.1), (Problem::Negative, "delta", None));
    assert_eq!(fault(|p| p.floor_stock = 7.0), (Problem::OutOfRange, "deltaz", None));
    assert_eq!(fault(|p| p.surface = f64::INFINITY), (Problem::OutOfRange, "Z", None));
    assert_eq!(rough(|r| r.tool.radius = 0.0), (Problem::ToolMissing, "T", None));
    assert_eq!(rough(|r| r.tool.radius = 20.0), (Problem::ToolTooLarge, "T", None));
    assert_eq!(rough(|r| r.step = 6.1), (Problem::StepTooLarge, "step", None));
    assert_eq!(rough(|r| r.step = -1.0), (Problem::Negative, "step", None));
    assert_eq!(rough(|r| r.step = 1e-3), (Problem::TooManyMoves, "step", None));
    assert_eq!(rough(|r| r.entry_angle = 91.0), (Problem::EntryAngle, "beta", None));
    assert_eq!(rough(|r| r.entry_angle = 1e-6), (Problem::TooManyMoves, "beta", None));
    assert_eq!(rough(|r| r.depth_step = 1e-4), (Problem::TooManyMoves, "I", None));
    let no_length = |r: &mut Rough2d| (r.depth_step, r.tool.cutting_length) = (0.0, 0.0);
    assert_eq!(rough(no_length), (Problem::DepthStepMissing, "I", None));
    assert_eq!(finish(|f| f.passes = -1.0), (Problem::Negative, "N", None));
    assert_eq!(finish(|f| f.passes = 1e9), (Problem::OutOfRange, "N", None));
    assert_eq!(finish(|f| f.entry_angle = -1.0), (Problem::Negative, "theta", None));
    assert_eq!(finish(|f| f.tool.tip_radius = 3.0), (Problem::ToolMissing, "T", None));
}

/// A fault names its stage.
#[test]
fn stages() {
    let stage = |change: fn(&mut Pocket2d)| {
        let mut pocket = pocket();
        change(&mut pocket);
        pocket.plan().map(|_| ()).unwrap_err().stage
    };
    assert_eq!(stage(|p| p.rough.as_mut().unwrap().step = 9.0), Some(Stage::Rough));
    assert_eq!(stage(|p| p.finish.as_mut().unwrap().step = 9.0), Some(Stage::Finish));
    assert_eq!(stage(|p| p.finish.as_mut().unwrap().tool.radius = 0.0), Some(Stage::Finish));
    assert_eq!(stage(|p| p.depth = 0.0), None);
}

#[test]
fn depth_profiles() {
    let wrong = |profiles: Vec<Option<DepthProfile>>| {
        let pocket = Pocket3d { depth_profiles: profiles, ..fagor_b() };
        let fault = pocket.plan().map(|_| ()).unwrap_err();
        (fault.problem, fault.parameter)
    };
    let outer = || Some(depth(&[[20.0, 0.0], [30.0, -20.0]]));
    assert_eq!(wrong(vec![Some(depth(&[[21.0, 0.0], [30.0, -20.0]]))]), (Problem::DepthProfileStart, "Z1"));
    let island = Some(depth(&[[62.5, 0.0], [77.5, -20.0]]));
    assert_eq!(wrong(vec![outer(), island]), (Problem::DepthProfileStart, "Z2"));
    let back = Some(depth(&[[20.0, 0.0], [30.0, -10.0], [28.0, -20.0]]));
    assert_eq!(wrong(vec![back]), (Problem::DepthProfileTurnsBack, "Z1"));
    // The outer wall runs into the island.
    assert_eq!(wrong(vec![Some(depth(&[[20.0, 0.0], [45.0, -20.0]]))]), (Problem::WallsMeet, "Z1"));
    let mut five = vec![None; 4];
    five.push(outer());
    assert_eq!(wrong(five), (Problem::TooManyDepthProfiles, "Z4"));
}

/// Plausible values, round ones, and any bit pattern.
fn value(dice: &mut Dice) -> f64 {
    match (dice.unit() * 12.0) as u32 {
        0 => 0.0,
        1 => 10f64.powf(dice.between(-9.0, 9.0)),
        2 => f64::from_bits((dice.unit() * u64::MAX as f64) as u64),
        3 => [f64::NAN, f64::INFINITY, -1.0, 1e300, 90.0, -0.0][(dice.unit() * 6.0) as usize],
        4 | 5 => dice.between(-60.0, 60.0).round(),
        _ => dice.between(0.0, 8.0),
    }
}

fn bounded(plan: &Plan2d) {
    let mut count = 0.0;
    let mut take = |step: CycleMove, _: PocketFeed| -> Result<(), ()> {
        let finite = match step {
            CycleMove::Rapid { to } | CycleMove::Feed { to } => to.iter().all(|c| c.is_finite()),
            CycleMove::Arc { to, center, sweep } => {
                to.iter().chain(&center).all(|c| c.is_finite()) && sweep.is_finite()
            }
        };
        assert!(finite, "{step:?}");
        count += 1.0;
        // Enough to see; the plan has counted them.
        if count > 2e4 { Err(()) } else { Ok(()) }
    };
    let _ = plan.rough([0.0, 0.0, 10.0], &mut take);
    let _ = plan.finish([0.0, 0.0, 10.0], &mut take);
    assert!(count <= MAX_MOVES);
}

#[test]
fn any_numbers() {
    let mut planned = 0;
    for number in 0..3000 {
        let (outer, islands, mut dice) = drawing(number % 200);
        let (mut outer, mut islands) = (outer, islands);
        let d = &mut dice;
        for _ in 0..number {
            d.unit();
        }
        // Some profiles are broken, some are made of anything.
        if d.one_in(4) {
            let n = (d.unit() * outer.segments.len() as f64) as usize;
            let (p, q) = ([value(d), value(d)], [value(d), value(d)]);
            outer.segments[n] = match (d.unit() * 3.0) as u32 {
                0 => Segment::Line { from: p, to: q },
                1 => Segment::Arc { from: p, to: q, center: [value(d), value(d)], sweep: value(d) },
                _ => outer.segments[n].reversed(),
            };
        }
        if d.one_in(4) {
            islands.push(circle([value(d), value(d)], value(d)));
        }
        if d.one_in(8) {
            islands.push(outer.clone());
        }
        // Most words are plausible: a pocket of nonsense alone is refused at the first of them.
        let word = |d: &mut Dice, low: f64, high: f64| match d.one_in(14) {
            true => value(d),
            false => d.between(low, high),
        };
        let tool = |d: &mut Dice| Tool {
            radius: word(d, 0.5, 3.0),
            tip_radius: word(d, 0.0, 0.5),
            cutting_length: word(d, 5.0, 30.0),
            entry_angle: word(d, 0.0, 20.0),
        };
        let pocket = Pocket2d {
            outer,
            islands,
            surface: word(d, -5.0, 5.0),
            safety: word(d, -9.0, 9.0),
            depth: word(d, 1.0, 9.0),
            wall_stock: word(d, 0.0, 0.5),
            floor_stock: word(d, 0.0, 0.5),
            rough: Some(Rough2d {
                tool: tool(d),
                step: word(d, 0.2, 1.0),
                depth_step: word(d, -3.0, 3.0),
                entry_angle: word(d, 0.0, 30.0),
            }),
            finish: Some(Finish2d {
                tool: tool(d),
                step: word(d, 0.2, 1.0),
                passes: word(d, 0.0, 4.0),
                entry_angle: word(d, 0.0, 30.0),
            }),
        };
        if let Ok(plan) = pocket.plan() {
            bounded(&plan);
            planned += 1;
        }
    }
    assert!(planned > 300, "only {planned} are pockets");
}

#[test]
fn any_numbers_in_depth() {
    let mut planned = 0;
    for number in 0..600 {
        let (outer, islands, mut dice) = drawing(number % 150 + 9000);
        let d = &mut dice;
        for _ in 0..number {
            d.unit();
        }
        let word = |d: &mut Dice, low: f64, high: f64| match d.one_in(20) {
            true => value(d),
            false => d.between(low, high),
        };
        let tool = |d: &mut Dice| Tool {
            radius: word(d, 0.5, 2.0),
            tip_radius: word(d, 0.0, 0.5),
            cutting_length: word(d, 5.0, 30.0),
            entry_angle: word(d, 0.0, 20.0),
        };
        let total = 4.0;
        let mut depth_profiles = Vec::new();
        for (n, contour) in std::iter::once(&outer).chain(&islands).enumerate() {
            let x = contour.segments[0].from()[0];
            let (from, to) = if n == 0 { (0.0, -total) } else { (-total, 0.0) };
            let out = word(d, 0.0, 0.5);
            let end = if d.one_in(10) { value(d) } else { to };
            let axis = if d.one_in(20) { 7 } else { 0 };
            depth_profiles
                .push((!d.one_in(4)).then(|| DepthProfile { axis, ..depth(&[[x, from], [x + out, end]]) }));
        }
        let pocket = Pocket3d {
            outer,
            islands,
            depth_profiles,
            surface: 0.0,
            safety: word(d, 1.0, 9.0),
            depth: total,
            wall_stock: word(d, 0.0, 0.5),
            rough: Some(Rough3d {
                tool: tool(d),
                step: word(d, 0.5, 1.0),
                depth_step: word(d, -3.0, 3.0),
                entry_angle: word(d, 0.0, 30.0),
            }),
            semi: Some(Semi3d { tool: tool(d), depth_step: word(d, 0.5, 2.0) }),
            finish: Some(Finish3d {
                tool: tool(d),
                width: word(d, 0.3, 2.0),
                direction: WallDirection::Zigzag,
            }),
        };
        if let Ok(plan) = pocket.plan() {
            let mut take = |step: CycleMove, _: PocketFeed| -> Result<(), Infallible> {
                let (CycleMove::Rapid { to } | CycleMove::Feed { to } | CycleMove::Arc { to, .. }) = step;
                assert!(to.iter().all(|c| c.is_finite()), "{step:?}");
                Ok(())
            };
            let Ok(()) = plan.rough([0.0, 0.0, 10.0], &mut take);
            let Ok(()) = plan.semi([0.0, 0.0, 10.0], &mut take);
            let Ok(()) = plan.finish([0.0, 0.0, 10.0], &mut take);
            planned += 1;
        }
    }
    assert!(planned > 60, "only {planned} are pockets");
}

/// An error of the taker ends the pocket at once.
#[test]
fn stops_when_refused() {
    let plan = pocket().plan().unwrap();
    let mut count = 0;
    let result = plan.rough([0.0, 0.0, 20.0], &mut |_, _| {
        count += 1;
        if count == 7 { Err("limit") } else { Ok(()) }
    });
    assert_eq!((result, count), (Err("limit"), 7));
}
