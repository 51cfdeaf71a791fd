//! A program that is taken up in its midst goes on as if it had been run from its start (GSK990MC part 2, 10.1.9;

//! here from any line).

use crate::common::parts::{Part, parts};
use crate::common::random::Random;
use ferrocut_controller::restart::{At, Journal, Restart};
use ferrocut_geometry::Position;
use ferrocut_interpreter::Until;
use ferrocut_interpreter::program_state::ProgramState;
use ferrocut_machine::Memory;
use ferrocut_program::FileId;
use ferrocut_toolpath::Step;
use std::collections::HashMap;

/// Lines that are tried in all; `FERROCUT_CASES` says otherwise.
const LINES: usize = 1200;

/// Blocks of a run that are looked at.
const MOST_BLOCKS: u64 = 4000;

/// A block of a full run, as it stands before it.
struct Reached {
    block: u64,
    file: FileId,
    line: u32,
    pass: u64,
    in_force: ProgramState,
    memory: Memory,
    position: Position,
}

/// Steps of a full run, and the blocks of it that are looked at: those that begin their line.
fn full_run(part: &Part, random: &mut Random, samples: usize) -> (Vec<Step>, Vec<Reached>) {
    let steps: Vec<Step> = part
        .interpreter()
        .map(|step| step.unwrap_or_else(|alarm| panic!("{}: {alarm:?}", part.name)))
        .collect();
    // Another run, block by block.
    let mut interpreter = part.interpreter();
    let mut passes: HashMap<(FileId, u64), u64> = HashMap::new();
    let mut blocks = Vec::new();
    for block in 1..=MOST_BLOCKS {
        interpreter.set_mark(Some(Until::Number(block)));
        (&mut interpreter).for_each(|step| drop(step.unwrap()));
        if !interpreter.is_at_mark() {
            break;
        }
        let Some(span) = interpreter.next_block() else { continue };
        let pass = passes.entry((span.file, span.offset)).or_default();
        *pass += 1;
        let first = interpreter.block_of_line(span.file, span.line).unwrap().unwrap();
        if first.1 == span {
            blocks.push((block, span.file, span.line, *pass));
        }
    }
    let mut chosen: Vec<_> = (0..samples).map(|_| blocks[random.below(blocks.len())]).collect();
    chosen.sort_unstable();
    chosen.dedup();
    let mut interpreter = part.interpreter();
    let reached = chosen.into_iter().map(|(block, file, line, pass)| {
        interpreter.set_mark(Some(Until::Number(block)));
        (&mut interpreter).for_each(|step| drop(step.unwrap()));
        // Where the full run's own steps say that the axes are.
        let before = steps.iter().take_while(|step| step.block < block);
        let start = part.interpreter().position();
        let position = before.fold(start, |at, step| match &step.op {
            ferrocut_toolpath::Op::Datum { at } => *at,
            op => op.target().copied().unwrap_or(at),
        });
        let (in_force, memory) = (interpreter.program_state(), interpreter.memory().clone());
        Reached { block, file, line, pass, in_force, memory, position }
    });
    let reached = reached.collect();
    (steps, reached)
}

fn find(part: &Part, file: FileId, line: u32, pass: u64) -> Restart {
    let interpreter = part.interpreter();
    let memory = interpreter.memory().clone();
    let found = Journal::begin(&interpreter, Position::ZERO).find(At::Line { file, line, pass }, &memory);
    found.unwrap_or_else(|alarm| panic!("{} {file:?}:{line}:{pass}: {alarm:?}", part.name))
}

#[test]
fn from_random_lines_programs_go_on_as_in_a_full_run() {
    let lines = std::env::var("FERROCUT_CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(LINES);
    let parts = parts();
    assert!(parts.len() >= 20);
    let mut random = Random::new(17);
    let (mut tried, mut in_others) = (0, 0);
    for part in &parts {
        let (steps, reached) = full_run(part, &mut random, lines.div_ceil(parts.len()) * 5 / 4);
        for full in &reached {
            let Reached { block, file, line, pass, .. } = *full;
            let place = format!("{} {file:?}:{line}:{pass} (block {block})", part.name);
            let restart = find(part, file, line, pass);
            assert_eq!(restart.pass, pass, "{place}");
            assert_eq!(restart.in_force, full.in_force, "{place}");
            assert_eq!(restart.interpreter().memory().changes_to(&full.memory), [], "{place}");
            assert_eq!(restart.position, full.position, "{place}");
            let (rest, _) = restart.into_parts();
            let mut rest = rest.map(|step| step.unwrap());
            for step in steps.iter().skip_while(|step| step.block < block) {
                assert_eq!(rest.next().as_ref(), Some(step), "{place}");
            }
            assert_eq!(rest.next(), None, "{place}");
            tried += 1;
            in_others += usize::from(file != FileId(0));
        }
    }
    println!("{tried} lines of {} programs, {in_others} in files of their own", parts.len());
    assert!(tried >= lines.min(LINES) * 5 / 6, "{tried}");
    assert!(in_others * 10 >= tried, "{in_others} of {tried}");
}
