//! 3D pockets: the examples of the manual, and random ones judged in cells and by distances.

use super::super::depth_profile::Lean;
use super::super::slopes::Slope;
use super::super::{
    DepthProfile, Finish3d, Plan3d, Pocket3d, PocketFeed, Profile, Rough3d, Segment, Semi3d, Tool,
    WallDirection,
};
use super::mill::{Block, Rules, run};
use super::random::{circle, drawing, rectangle};
use crate::cycles::milling::CycleMove;
use std::convert::Infallible;

const START: [f64; 3] = [-50.0, -50.0, 20.0];

fn moves(plan: &Plan3d, stage: usize) -> Vec<CycleMove> {
    let mut moves = Vec::new();
    let mut sink = |step: CycleMove, _: PocketFeed| -> Result<(), Infallible> {
        moves.push(step);
        Ok(())
    };
    let Ok(()) = match stage {
        0 => plan.rough(START, &mut sink),
        1 => plan.semi(START, &mut sink),
        _ => plan.finish(START, &mut sink),
    };
    moves
}

pub fn depth(points: &[[f64; 2]]) -> DepthProfile {
    let segments = points.windows(2).map(|p| Segment::Line { from: p[0], to: p[1] }).collect();
    DepthProfile { segments, axis: 0 }
}

/// FAGOR-B of 4.16.3.
pub fn fagor_b() -> Pocket3d {
    let mut outer = rectangle([20.0, -40.0], [145.0, 40.0]);
    outer.segments.rotate_left(3);
    // From (20, 0) as the example draws it.
    let first = outer.segments.remove(0);
    outer.segments.insert(0, first.part(0.5, 1.0));
    outer.segments.push(first.part(0.0, 0.5));
    let island = Profile { segments: vec![Segment::circle([62.5, 0.0], [82.5, 0.0], -1.0)] };
    Pocket3d {
        outer,
        islands: vec![island],
        depth_profiles: vec![
            Some(depth(&[[20.0, 0.0], [30.0, -20.0]])),
            Some(depth(&[[62.5, -20.0], [77.5, 0.0]])),
        ],
        surface: 0.0,
        safety: 5.0,
        depth: 20.0,
        wall_stock: 0.0,
        rough: Some(Rough3d {
            tool: Tool { radius: 4.0, cutting_length: 30.0, ..Tool::default() },
            step: 5.0,
            depth_step: 8.0,
            entry_angle: 0.0,
        }),
        semi: None,
        finish: None,
    }
}

#[test]
fn roughing_of_the_example() {
    let plan = fagor_b().plan().unwrap();
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    let mut levels: Vec<f64> = Vec::new();
    let mut at = START;
    for step in moves(&plan, 0) {
        let (to, segment) = match step {
            CycleMove::Rapid { to } => {
                at = to;
                continue;
            }
            CycleMove::Feed { to } => (to, Segment::Line { from: [at[0], at[1]], to: [to[0], to[1]] }),
            CycleMove::Arc { to, center, sweep } => {
                (to, Segment::Arc { from: [at[0], at[1]], to: [to[0], to[1]], center, sweep })
            }
        };
        let bounds = segment.bounds();
        for k in 0..2 {
            low[k] = low[k].min(bounds.low[k]);
            high[k] = high[k].max(bounds.high[k]);
        }
        low[2] = low[2].min(to[2]);
        if (at[2] - to[2]).abs() < 1e-9 && levels.iter().all(|z| (z - to[2]).abs() > 1e-6) {
            levels.push(to[2]);
        }
        at = to;
    }
    let near = |a: f64, b: f64| assert!((a - b).abs() < 2e-3, "{a} instead of {b}");
    for (got, want) in levels.iter().zip([-6.66667, -13.33333, -20.0]) {
        near(*got, want);
    }
    for (got, want) in [(low[0], 27.33333), (low[1], -32.66667), (low[2], -20.0)] {
        near(got, want);
    }
    near(high[0], 137.66667);
    near(high[1], 32.66667);
    assert_eq!((levels.len(), at[2]), (3, 5.0));
}

/// Whether material is left where it must be: every cell that has been cut at a height is free there.
fn no_gouge(block: &Block, slopes: &[Slope], stock: f64) -> Result<(), String> {
    for j in (0..block.size[1]).step_by(3) {
        for i in (0..block.size[0]).step_by(3) {
            let height = f64::from(block.height[j * block.size[0] + i]);
            if height >= 0.0 {
                continue;
            }
            let p = block.middle(i, j);
            for slope in slopes {
                if slope.is_island && height >= slope.lean.top - 1e-6 && slope.lean.top < 0.0 {
                    continue;
                }
                let inset = slope.lean.inset(height + 1e-4);
                // Off a corner of an island that leans back, stock is not a distance from the contour.
                let needed = match slope.is_island {
                    true if inset > 0.0 => -inset,
                    true => stock,
                    false => stock + inset,
                };
                let d = slope.distance(p);
                if d < needed - 3e-3 {
                    return Err(format!("gouged by {} at {p:?}, {height}", needed - d));
                }
            }
        }
    }
    Ok(())
}

fn random(number: u64) -> (Pocket3d, f64) {
    let (outer, islands, mut dice) = drawing(number + 5000);
    let total = dice.between(3.0, 8.0);
    let start = |p: &Profile| p.segments[0].from()[0];
    let slope = dice.between(0.1, 0.6);
    let out = start(&outer);
    let outer_depth = if dice.one_in(2) {
        depth(&[[out, 0.0], [out + slope * total, -total]])
    } else {
        // A ledge and an arc.
        let middle = -0.5 * total;
        let r = 0.2 * total;
        let mut profile = depth(&[[out, 0.0], [out + 0.3, middle], [out + 0.3 + 0.1 * total, middle]]);
        let x = out + 0.3 + 0.1 * total;
        profile.segments.push(Segment::arc([x, middle], [x + r, middle - r], -std::f64::consts::FRAC_PI_2));
        profile
    };
    let mut depth_profiles = vec![Some(outer_depth)];
    for (n, island) in islands.iter().enumerate() {
        let x = start(island);
        depth_profiles.push(match n % 3 {
            0 => Some(depth(&[[x, -total], [x - 0.3 * slope * total, 0.0]])),
            1 => Some(depth(&[[x, -total], [x + 0.2, -0.4 * total]])),
            _ => None,
        });
    }
    let radius = dice.between(0.8, 2.5);
    let tool = Tool { radius, cutting_length: 30.0, ..Tool::default() };
    let angle = if dice.one_in(2) { 0.0 } else { dice.between(3.0, 30.0) };
    let pocket = Pocket3d {
        outer,
        islands,
        depth_profiles,
        surface: 0.0,
        safety: 5.0,
        depth: total,
        wall_stock: dice.between(0.0, 0.3),
        rough: Some(Rough3d { tool, step: 0.0, depth_step: dice.between(0.8, 3.0), entry_angle: angle }),
        semi: Some(Semi3d { tool, depth_step: dice.between(0.4, 1.0) }),
        finish: Some(Finish3d {
            tool,
            width: dice.between(0.3, 1.0),
            direction: [WallDirection::Down, WallDirection::Up, WallDirection::Zigzag]
                [(dice.unit() * 3.0) as usize],
        }),
    };
    (pocket, angle)
}

fn check(number: u64) -> Result<bool, String> {
    use super::super::Problem;
    let (pocket, angle) = random(number);
    let plan = match pocket.plan() {
        Ok(plan) => plan,
        Err(fault) if matches!(fault.problem, Problem::ToolTooLarge | Problem::WallsMeet) => {
            return Ok(false);
        }
        Err(fault) => return Err(format!("{fault:?}")),
    };
    let bounds = pocket.outer.bounds();
    let mut block = Block::new(bounds.low, bounds.high);
    let radius = pocket.rough.unwrap().tool.radius;
    let slope = (angle > 0.0).then(|| angle.to_radians().tan());
    let rules = Rules { radius, slope, slack: 1e-4 };
    run(&mut block, START, &moves(&plan, 0), &rules).map_err(|e| format!("rough: {e}"))?;
    no_gouge(&block, &plan.slopes, pocket.wall_stock).map_err(|e| format!("rough: {e}"))?;
    run(&mut block, START, &moves(&plan, 1), &rules).map_err(|e| format!("semi: {e}"))?;
    no_gouge(&block, &plan.slopes, pocket.wall_stock).map_err(|e| format!("semi: {e}"))?;
    // Along the wall is as steep as the wall is.
    let rules = Rules { radius, slope: None, slack: 0.12 };
    run(&mut block, START, &moves(&plan, 2), &rules).map_err(|e| format!("finish: {e}"))?;
    no_gouge(&block, &plan.slopes, 0.0).map_err(|e| format!("finish: {e}"))?;
    Ok(true)
}

#[test]
fn random_pockets() {
    let mut failed = Vec::new();
    let mut cut = 0;
    let mut number = 0;
    while cut < 60 {
        match check(number) {
            Ok(done) => cut += u32::from(done),
            Err(error) => failed.push((number, error)),
        }
        number += 1;
        assert!(number < 400);
    }
    assert!(failed.is_empty(), "{} of {number}: {:?}", failed.len(), failed.first());
}

/// A ball touches the wall all the way and never enters it, judged at close heights of the tool.
#[test]
fn tips_touch_the_wall() {
    for tip in [0.0, 1.0, 2.5, 3.0] {
        let tool = Tool { radius: 3.0, tip_radius: tip, cutting_length: 30.0, ..Tool::default() };
        let finish = Finish3d { tool, width: 1.0, direction: WallDirection::Down };
        let mut pocket = Pocket3d { finish: Some(finish), ..fagor_b() };
        pocket.depth_profiles[0] = Some(depth(&[[20.0, 0.0], [22.0, -8.0], [26.0, -11.0], [27.0, -20.0]]));
        let plan = pocket.plan().unwrap();
        let mut touching = 0;
        let mut all = 0;
        for pass in plan.finish.iter().flatten() {
            for [x, y, z] in &pass.points {
                let off: Vec<f64> = plan.slopes.iter().map(|s| s.distance([*x, *y])).collect();
                let least = (0..=4000).fold(f64::INFINITY, |least: f64, k| {
                    let up = f64::from(k) * 0.005;
                    let u = (tip - up).max(0.0);
                    let rho = tool.radius - tip + (tip * tip - u * u).max(0.0).sqrt();
                    let lean = |lean: &Lean| lean.inset((z + up).min(-1e-9));
                    plan.slopes.iter().zip(&off).fold(least, |least, (slope, off)| {
                        let sign = if slope.is_island { -1.0 } else { 1.0 };
                        least.min(off - sign * lean(&slope.lean) - rho)
                    })
                });
                all += 1;
                assert!(least > -2e-3, "enters by {least} at {x}, {y}, {z}, tip {tip}");
                touching += usize::from(least < 8e-3);
            }
        }
        assert!(touching == all && all > 500, "{touching} of {all}, tip {tip}");
    }
}

#[test]
fn island_below_the_surface_is_faced() {
    let mut pocket = fagor_b();
    pocket.depth_profiles = vec![None, Some(depth(&[[62.5, -20.0], [62.5, -11.0]]))];
    let plan = pocket.plan().unwrap();
    let heights: Vec<f64> = plan.rough.iter().map(|(cross, _)| cross.height).collect();
    assert_eq!(heights.len(), 4);
    assert!((heights[1] + 11.0).abs() < 1e-9);
    let counts: Vec<usize> = plan.rough.iter().map(|(cross, _)| cross.walls.contours.len()).collect();
    assert_eq!(counts, [1, 1, 2, 2]);
}

/// What finishing leaves: on walls of every slope no more than the steps of this model.
#[test]
fn nothing_left_on_the_walls() {
    for direction in [WallDirection::Down, WallDirection::Up, WallDirection::Zigzag] {
        let tool = Tool { radius: 1.5, cutting_length: 30.0, ..Tool::default() };
        let pocket = Pocket3d {
            outer: rectangle([0.0, 0.0], [34.0, 26.0]),
            islands: vec![circle([17.0, 13.0], 5.0)],
            depth_profiles: vec![
                Some(depth(&[[0.0, 0.0], [0.5, -1.0], [1.5, -1.0], [2.5, -5.0]])),
                Some(depth(&[[22.0, -5.0], [20.0, 0.0]])),
            ],
            surface: 0.0,
            safety: 5.0,
            depth: 5.0,
            wall_stock: 0.3,
            rough: Some(Rough3d { tool, step: 0.0, depth_step: 2.0, entry_angle: 5.0 }),
            semi: None,
            finish: Some(Finish3d { tool, width: 0.2, direction }),
        };
        let plan = pocket.plan().unwrap();
        let mut block = Block::new([0.0, 0.0], [34.0, 26.0]);
        for (stage, slack) in [(0, 1e-4), (2, 0.12)] {
            let slope = (stage == 0).then(|| 5f64.to_radians().tan());
            let rules = Rules { radius: tool.radius, slope, slack };
            run(&mut block, START, &moves(&plan, stage), &rules).unwrap();
        }
        no_gouge(&block, &plan.slopes, 0.0).unwrap();
        let mut seen = 0;
        for j in (0..block.size[1]).step_by(2) {
            for i in (0..block.size[0]).step_by(2) {
                let p = block.middle(i, j);
                // Away from the valleys of the corners, which a round tool does not reach.
                let [x, y] = [p[0].min(34.0 - p[0]), p[1].min(26.0 - p[1])];
                if x < 0.0 || y < 0.0 || (x < 5.0 && y < 5.0) {
                    continue;
                }
                // The lowest height at which every wall leaves the point free.
                let free = |h: f64| {
                    plan.slopes.iter().all(|s| {
                        let inset = s.lean.inset(h);
                        s.distance(p) >= if s.is_island { -inset } else { inset }
                    })
                };
                let lowest = (0..=500).map(|k| -5.0 + f64::from(k) * 0.01).find(|h| free(*h));
                let height = f64::from(block.height[j * block.size[0] + i]);
                let want = lowest.unwrap_or(0.0);
                // 0.1 of the steps, and the scallops between two passes 0.2 apart.
                assert!(height < want + 0.15, "{direction:?}: {height} instead of {want} at {p:?}");
                seen += 1;
            }
        }
        assert!(seen > 50_000);
    }
}
