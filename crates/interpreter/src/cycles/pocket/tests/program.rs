//! 2D pockets as programs of the Fagor editor: what its moves leave is judged as that of the plans is.

use super::super::{Pocket2d, Profile, Segment, Tool};
use super::flat::{START, Stages, check};
use crate::cycles::milling::CycleMove;
use crate::cycles::programs::stages;
use crate::cycles::tool::Act;
use ferrocut_machine::Fault;
use std::fmt::Write;

fn contour(text: &mut String, profile: &Profile) {
    let [x, y] = profile.segments[0].from();
    writeln!(text, "G0 X{x} Y{y}").unwrap();
    for segment in &profile.segments {
        let [x, y] = segment.to();
        match *segment {
            Segment::Line { .. } => writeln!(text, "G1 X{x} Y{y}").unwrap(),
            Segment::Arc { from, center, sweep, .. } => {
                let code = if sweep > 0.0 { 3 } else { 2 };
                let (i, j) = (center[0] - from[0], center[1] - from[1]);
                writeln!(text, "G{code} X{x} Y{y} I{i} J{j}").unwrap();
            }
        }
    }
}

/// The program of a pocket, and its tool table: tool 1 roughs, tool 2 finishes.
fn program(pocket: &Pocket2d) -> (String, String) {
    let mut text = String::from("#PROFILE A [XY]\n");
    contour(&mut text, &pocket.outer);
    pocket.islands.iter().for_each(|island| contour(&mut text, island));
    let Pocket2d { surface, safety, depth, wall_stock, floor_stock, .. } = pocket;
    writeln!(text, "#ENDPROFILE\n#CYCLE P2D [pocket=A, profile=A, Z={surface}, ZS={safety}, P={depth}]")
        .unwrap();
    let mut setup = format!("[start]\nx = {}\ny = {}\nz = {}\n", START[0], START[1], START[2]);
    let mut tool = |number: u32, tool: &Tool| {
        let (r, length) = (tool.radius, tool.cutting_length);
        writeln!(setup, "[tools.{number}]\nradius = {r}\ncutting_length = {length}").unwrap();
    };
    if let Some(rough) = &pocket.rough {
        tool(1, &rough.tool);
        let (step, i, beta) = (rough.step, rough.depth_step, rough.entry_angle);
        writeln!(text, "#ROUGH [T=1, F=500, S=1000, step={step}, I={i}, beta={beta}]").unwrap();
    }
    write!(text, "#FINISH [delta={wall_stock}, deltaz={floor_stock}").unwrap();
    if let Some(finish) = &pocket.finish {
        tool(2, &finish.tool);
        let (step, n, theta) = (finish.step, finish.passes, finish.entry_angle);
        write!(text, ", T=2, F=300, S=1000, step={step}, N={n}, theta={theta}").unwrap();
    }
    text.push_str("]\nM30\n");
    (text, setup)
}

fn run(pocket: &Pocket2d) -> Result<Stages, String> {
    let (text, setup) = program(pocket);
    let found = match stages(&text, &setup) {
        Ok(found) => found,
        Err(alarm) if alarm.fault == Fault::CycleToolTooLarge => return Ok(None),
        Err(alarm) => return Err(format!("{alarm:?}")),
    };
    let step = |act: Act| match act {
        Act::Rapid { to } => Ok(CycleMove::Rapid { to }),
        Act::Feed { to, .. } => Ok(CycleMove::Feed { to }),
        Act::Arc { to, center, sweep, .. } => Ok(CycleMove::Arc { to, center, sweep }),
        other => Err(format!("{other:?} in a pocket")),
    };
    let stage = |(at, acts): ([f64; 3], Vec<Act>)| {
        Ok((at, acts.into_iter().map(step).collect::<Result<Vec<_>, String>>()?))
    };
    found.into_iter().map(stage).collect::<Result<Vec<_>, String>>().map(Some)
}

#[test]
fn random_pockets() {
    let (mut cut, mut number) = (0, 10_000);
    let mut failed = Vec::new();
    while cut < 500 {
        match check(number, run) {
            Ok(done) => cut += u32::from(done),
            Err(error) => failed.push((number, error)),
        }
        number += 1;
        assert!(number < 12_000, "too few can be cut");
    }
    assert!(failed.is_empty(), "{} of {number}: {:?}", failed.len(), failed.first());
}
