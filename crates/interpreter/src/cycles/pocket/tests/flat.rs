//! 2D pockets judged in cells: nothing gouged, nothing left, nothing entered too steeply or at rapid.

use super::super::{Finish2d, Plan2d, Pocket2d, Profile, Rough2d, Tool};
use super::mill::{Block, CELL, Rules, run, squared_distances};
use super::random::{Dice, drawing};
use crate::cycles::milling::CycleMove;
use std::convert::Infallible;

/// A place outside.
pub const START: [f64; 3] = [-50.0, -50.0, 20.0];

/// The moves of a stage from there.
pub fn rough_of(plan: &Plan2d) -> Vec<CycleMove> {
    let mut moves = Vec::new();
    let Ok(()) = plan.rough(START, &mut |step, _| -> Result<(), Infallible> {
        moves.push(step);
        Ok(())
    });
    moves
}

pub fn finish_of(plan: &Plan2d) -> Vec<CycleMove> {
    let mut moves = Vec::new();
    let Ok(()) = plan.finish(START, &mut |step, _| -> Result<(), Infallible> {
        moves.push(step);
        Ok(())
    });
    moves
}

/// For every cell whether it lies in the pocket.
fn inside(block: &Block, contours: &[&Profile]) -> Vec<bool> {
    let mut cells = vec![false; block.height.len()];
    for j in 0..block.size[1] {
        let y = block.middle(0, j)[1];
        let mut crossings = Vec::new();
        let (left, right) = (block.low[0] - 1.0, block.low[0] + block.size[0] as f64 * CELL + 1.0);
        // Just beside the row, so that it meets no corner.
        let row = super::super::Segment::Line { from: [left, y + 1e-7], to: [right, y + 1e-7] };
        for segment in contours.iter().flat_map(|c| &c.segments) {
            crossings.extend(super::super::meet::crossings(segment, &row).iter().map(|p| p[0]));
        }
        crossings.sort_by(f64::total_cmp);
        for pair in crossings.chunks(2) {
            if let [a, b] = pair {
                let first = ((a - block.low[0]) / CELL).ceil() as usize;
                let last = ((b - block.low[0]) / CELL).floor() as usize;
                for i in first..=last {
                    cells[j * block.size[0] + i] = true;
                }
            }
        }
    }
    cells
}

/// Cells nearer to a wall than `r`.
fn beside(block: &Block, contours: &[&Profile], r: f64) -> Vec<bool> {
    let mut cells = vec![false; block.height.len()];
    for segment in contours.iter().flat_map(|c| &c.segments) {
        block.swept(segment, r, |cell, _| cells[cell] = true);
    }
    cells
}

/// Compares a block with what a tool of that radius can and may do.
fn judge(block: &Block, contours: &[&Profile], radius: f64, stock: f64, floor: f64) -> Result<(), String> {
    let inside = inside(block, contours);
    let wall = beside(block, contours, (stock - 2.5e-3).max(0.0));
    let blocked = beside(block, contours, radius + stock);
    let free = squared_distances(block.size, |c| inside[c] && !blocked[c]);
    let reach = (((radius - 5e-3) / CELL) as f32).powi(2);
    // On the very wall a cell may be counted to either side.
    let edge = beside(block, contours, 2.5e-3);
    for (cell, height) in block.height.iter().enumerate() {
        let p = block.middle(cell % block.size[0], cell / block.size[0]);
        if *height < 0.0 && ((!inside[cell] && !edge[cell]) || (wall[cell] && stock > 0.0)) {
            return Err(format!("gouged at {p:?}"));
        }
        if f64::from(*height) < floor - 1e-4 {
            return Err(format!("too deep at {p:?}"));
        }
        if free[cell] <= reach && f64::from(*height) > floor + 1e-4 {
            return Err(format!("left at {p:?}: {height}"));
        }
    }
    Ok(())
}

/// The pocket of a number: tools, steps, stock and angles at random.
pub fn pocket(number: u64) -> (Pocket2d, Dice) {
    let (outer, islands, mut dice) = drawing(number);
    let tool = |dice: &mut Dice| {
        let whole = dice.one_in(2);
        let radius = dice.between(0.8, 4.0);
        let radius = if whole { (radius * 2.0).round().max(2.0) / 2.0 } else { radius };
        Tool { radius, cutting_length: 30.0, ..Tool::default() }
    };
    let angle = |dice: &mut Dice| if dice.one_in(3) { 0.0 } else { dice.between(2.0, 40.0) };
    let rough_tool = tool(&mut dice);
    let finish_tool = if dice.one_in(2) { rough_tool } else { tool(&mut dice) };
    let step = |dice: &mut Dice, r: f64| match (dice.unit() * 4.0) as u32 {
        0 => 0.0,
        1 => 2.0 * r,
        _ => r * dice.between(0.3, 2.0),
    };
    let rough = Rough2d {
        tool: rough_tool,
        step: step(&mut dice, rough_tool.radius),
        depth_step: if dice.one_in(2) { 2.0 } else { -2.0 },
        entry_angle: angle(&mut dice),
    };
    let finish = Finish2d {
        tool: finish_tool,
        step: step(&mut dice, finish_tool.radius),
        passes: f64::from((dice.unit() * 3.0) as u32),
        entry_angle: angle(&mut dice),
    };
    let pocket = Pocket2d {
        outer,
        islands,
        surface: 0.0,
        safety: 5.0,
        depth: dice.between(1.5, 4.5),
        wall_stock: if dice.one_in(4) { 0.0 } else { dice.between(0.05, 0.6) },
        floor_stock: if dice.one_in(4) { 0.0 } else { dice.between(0.05, 0.6) },
        rough: if dice.one_in(8) { None } else { Some(rough) },
        finish: if dice.one_in(8) { None } else { Some(finish) },
    };
    (pocket, dice)
}

/// The stages of a pocket: where the tool stands before each, and its moves. None where no tool fits.
pub type Stages = Option<Vec<([f64; 3], Vec<CycleMove>)>>;

fn planned(pocket: &Pocket2d) -> Result<Stages, String> {
    let plan = match pocket.plan() {
        Ok(plan) => plan,
        Err(fault) if fault.problem == super::super::Problem::ToolTooLarge => return Ok(None),
        Err(fault) => return Err(format!("{fault:?}")),
    };
    let rough = pocket.rough.is_some().then(|| (START, rough_of(&plan)));
    let finish = pocket.finish.is_some().then(|| (START, finish_of(&plan)));
    Ok(Some(rough.into_iter().chain(finish).collect()))
}

/// Cuts the pocket of a number and judges it. False where no tool fits.
pub fn check(number: u64, made: impl Fn(&Pocket2d) -> Result<Stages, String>) -> Result<bool, String> {
    let (pocket, _) = pocket(number);
    let Some(stages) = made(&pocket)? else { return Ok(false) };
    let contours: Vec<&Profile> = std::iter::once(&pocket.outer).chain(&pocket.islands).collect();
    let bounds = pocket.outer.bounds();
    let mut block = Block::new(bounds.low, bounds.high);
    let mut stages = stages.into_iter();
    let tan = |angle: f64| (angle > 0.0).then(|| angle.to_radians().tan());
    if let Some(rough) = &pocket.rough {
        let (start, moves) = stages.next().ok_or("no roughing")?;
        let rules = Rules { radius: rough.tool.radius, slope: tan(rough.entry_angle), slack: 1e-4 };
        run(&mut block, start, &moves, &rules)?;
        let floor = pocket.floor_stock - pocket.depth;
        judge(&block, &contours, rules.radius, pocket.wall_stock, floor)
            .map_err(|e| format!("rough: {e}"))?;
    }
    if let Some(finish) = &pocket.finish {
        let (start, moves) = stages.next().ok_or("no finishing")?;
        let rules = Rules { radius: finish.tool.radius, slope: tan(finish.entry_angle), slack: 1e-4 };
        run(&mut block, start, &moves, &rules)?;
        judge(&block, &contours, rules.radius, 0.0, -pocket.depth).map_err(|e| format!("finish: {e}"))?;
    }
    Ok(stages.next().is_none())
}

#[test]
fn random_pockets() {
    let mut cut = 0;
    let mut failed = Vec::new();
    let mut number = 0;
    while cut < 500 {
        match check(number, planned) {
            Ok(done) => cut += u32::from(done),
            Err(error) => failed.push((number, error)),
        }
        number += 1;
        assert!(number < 2000, "too few can be cut");
    }
    assert!(failed.is_empty(), "{} of {number}: {:?}", failed.len(), failed.first());
}
