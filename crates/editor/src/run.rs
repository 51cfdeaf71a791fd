//! Programs run at a desk, so that what is written is known to do what is meant.

use crate::Control;
use crate::request::Request;
use ferrocut_geometry::{Axis, Position};
use ferrocut_interpreter::{Dialect, Interpreter, Options};
use ferrocut_machine::{Alarm, Memory, ToolOffset, WorkOffset};
use ferrocut_program::{ProgramMemory, Text};
use ferrocut_toolpath::{Feed, Op, Speed, SpindleState, Step};

/// Steps of one cycle at most: text of a few megabytes.
pub const MOST_STEPS: usize = 200_000;

/// What came of a program.
#[derive(Debug, Default)]
pub struct Ran {
    /// Its steps, without its end.
    pub steps: Vec<Step>,
    /// What was wrong.
    pub alarms: Vec<Alarm>,
    /// It has more steps than are kept.
    pub is_cut_short: bool,
}

/// A control's memory for trying cycles: its parameters, no offsets at all, so that machine coordinates are those
/// of the program, and the tools' radii.
pub fn desk(dialect: &Dialect, machine: Option<Control<'_>>) -> Memory {
    let mut memory = match machine {
        Some(machine) if machine.dialect.name == dialect.name => machine.memory.clone(),
        _ => Memory::new(dialect.name),
    };
    memory.library = None;
    let systems = (1..=6).map(WorkOffset::Standard).chain([WorkOffset::External]);
    for system in systems {
        if let Some(offset) = memory.work.get_mut(system) {
            *offset = Position::ZERO;
        }
    }
    let used: Vec<u16> = memory.tools.used().map(|(number, _)| number).collect();
    for number in used {
        if let Some(row) = memory.tools.get_mut(number) {
            (row.length, row.length_wear) = (0.0, 0.0);
        }
    }
    memory
}

/// The memory that a Fagor block is run with: the tools of another control's table, and what the request says of
/// them.
pub fn fagor_desk(machine: Option<Control<'_>>, request: &Request) -> Memory {
    let mut memory = Memory::new("fagor8065");
    if let Some(Control { dialect, memory: machine }) = machine {
        let share = if (dialect.rules)(&machine.parameters).radius_is_diameter { 0.5 } else { 1.0 };
        for (number, row) in machine.tools.used() {
            if let Some(own) = memory.tools.get_mut(number) {
                let radius = (row.radius + row.radius_wear) * share;
                *own = ToolOffset { length: 0.0, length_wear: 0.0, radius, radius_wear: 0.0, ..*row };
            }
        }
    }
    for tool in &request.tools {
        if let Some(own) = memory.tools.get_mut(tool.number) {
            if let Some(diameter) = tool.diameter {
                (own.radius, own.radius_wear) = (diameter / 2.0, 0.0);
            }
            own.cutting_length = tool.cutting_length.unwrap_or(own.cutting_length);
            own.entry_angle = tool.entry_angle.unwrap_or(own.entry_angle);
            own.tip_radius = tool.tip_radius.unwrap_or(own.tip_radius);
        }
    }
    memory
}

/// Where cycles are begun in the plane: where no cycle has a point, so that the way to its first is always there.
pub const BESIDE: [f64; 2] = [-100_234.5, -100_345.5];

/// Where a cycle is begun on a level.
pub fn start(level: f64) -> Position {
    let [x, y] = BESIDE;
    Position::xyz(x, y, level)
}

/// Runs a program.
pub fn run(
    dialect: &'static Dialect,
    program: &str,
    memory: Memory,
    start: Position,
    keep_going: bool,
) -> Ran {
    let mut ran = Ran::default();
    let Ok(text) = Text::from_bytes(program.as_bytes().to_vec()) else { return ran };
    let programs = ProgramMemory::new("cycle.nc", text, dialect.syntax);
    let options = Options { start, keep_going, ..Options::default() };
    for step in Interpreter::new(dialect, programs, memory, options) {
        match step {
            Ok(Step { op: Op::End(_), .. }) => break,
            Ok(step) if ran.steps.len() < MOST_STEPS => ran.steps.push(step),
            Ok(_) => {
                ran.is_cut_short = true;
                break;
            }
            Err(alarm) => {
                ran.alarms.push(*alarm);
                if !keep_going {
                    break;
                }
            }
        }
    }
    ran
}

/// A feed in mm/min, one a turn at the spindle's speed; none where it is told neither way.
pub fn feed_a_minute(feed: Feed, spindle: Option<SpindleState>) -> Option<f64> {
    match (feed, spindle.and_then(|spindle| spindle.speed())) {
        (Feed::PerRevolution(feed), Some(Speed::Rpm(rpm))) => Some(feed * rpm),
        _ => feed.per_minute(),
    }
}

/// Its X, Y and Z; no cycle here moves another axis.
pub fn xyz(at: &Position) -> [f64; 3] {
    [at[Axis::X], at[Axis::Y], at[Axis::Z]]
}
