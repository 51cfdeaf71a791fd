//! 2D pockets as programs of the Fagor editor: what its moves leave is judged as that of the plans is.

use super::super::{Pocket2d, Profile, Segment, Tool};
use super::flat::{START, Stages, check};
use crate::cycles::milling::CycleMove;
use crate::dialects::fagor8065::DIALECT;
use crate::{Interpreter, Options};
use ferrocut_geometry::Position;
use ferrocut_machine::{Fault, Memory, Setup};
use ferrocut_program::{ProgramMemory, Text};
use ferrocut_toolpath::Op;
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
    let programs =
        ProgramMemory::new("test.nc", Text::from_bytes(text.into_bytes()).unwrap(), DIALECT.syntax);
    let setup = Setup::from_toml(&setup).unwrap();
    let mut memory = Memory::new(DIALECT.name);
    setup.apply(&mut memory).unwrap();
    let options = Options { start: setup.start.position(), ..Options::default() };
    let mut at = START;
    let mut stages: Vec<([f64; 3], Vec<CycleMove>)> = Vec::new();
    let place = |to: Position| [to.0[0], to.0[1], to.0[2]];
    for step in Interpreter::new(&DIALECT, programs, memory, options) {
        let op = match step {
            Ok(step) => step.op,
            Err(alarm) if alarm.fault == Fault::CycleToolTooLarge => return Ok(None),
            Err(alarm) => return Err(format!("{alarm:?}")),
        };
        let step = match op {
            Op::Change(_) => {
                stages.push((at, Vec::new()));
                continue;
            }
            Op::Rapid { to, .. } => CycleMove::Rapid { to: place(to) },
            Op::Feed { to, .. } => CycleMove::Feed { to: place(to) },
            Op::Arc { to, center, sweep, .. } => CycleMove::Arc { to: place(to), center, sweep },
            _ => continue,
        };
        let (CycleMove::Rapid { to } | CycleMove::Feed { to } | CycleMove::Arc { to, .. }) = step;
        at = to;
        stages.last_mut().ok_or("a move without a tool")?.1.push(step);
    }
    Ok(Some(stages))
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
