//! Programs of the Fagor editor as the stages of a part, for proofs that judge what is cut.

use super::tool::Act;
use crate::dialects::fagor8065::DIALECT;
use crate::{Interpreter, Options};
use ferrocut_geometry::Position;
use ferrocut_machine::{Alarm, Memory, Setup};
use ferrocut_program::{ProgramMemory, Text};
use ferrocut_toolpath::{Feed, Op};

/// A stage: where the tool stands before it, and its moves.
pub type Stage = ([f64; 3], Vec<Act>);

/// The stages of a program, each of which begins with a tool change.
pub fn stages(program: &str, setup: &str) -> Result<Vec<Stage>, Box<Alarm>> {
    let text = Text::from_bytes(program.as_bytes().to_vec()).unwrap();
    let programs = ProgramMemory::new("test.nc", text, DIALECT.syntax);
    let setup = Setup::from_toml(setup).unwrap();
    let mut memory = Memory::new(DIALECT.name);
    setup.apply(&mut memory).unwrap();
    let start = setup.start.position();
    let place = |to: Position| [to.0[0], to.0[1], to.0[2]];
    let minute = |feed: Feed| feed.per_minute().unwrap_or(f64::NAN);
    let mut at = place(start);
    let mut stages: Vec<Stage> = Vec::new();
    for step in Interpreter::new(&DIALECT, programs, memory, Options { start, ..Options::default() }) {
        let act = match step?.op {
            Op::Change(_) => {
                stages.push((at, Vec::new()));
                continue;
            }
            Op::Rapid { to, .. } => Act::Rapid { to: place(to) },
            Op::Feed { to, feed, .. } => Act::Feed { to: place(to), feed: minute(feed) },
            Op::Arc { to, center, sweep, feed, .. } => {
                Act::Arc { to: place(to), center, sweep, feed: minute(feed) }
            }
            _ => continue,
        };
        if let Act::Rapid { to } | Act::Feed { to, .. } | Act::Arc { to, .. } = act {
            at = to;
        }
        stages.last_mut().expect("a move without a tool").1.push(act);
    }
    Ok(stages)
}
