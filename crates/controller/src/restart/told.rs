//! A restart in words: what program and machine do not have alike, the functions that are sent, the way of the axes.

use ferrocut_geometry::{Axis, Position};
use ferrocut_interpreter::program_state::ProgramState;
use ferrocut_machine::g_code_name;
use ferrocut_toolpath::{Op, Speed, SpindleState};

/// Something that program and machine do not have alike.
#[derive(Clone, PartialEq, Debug)]
pub struct Difference {
    /// What it is.
    pub of: Compared,
    /// What the program has.
    pub program: Setting,
    /// What the machine has.
    pub machine: Setting,
}

/// What is compared.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Compared {
    /// The G code of a modal group, by the manual's number.
    Code(u8),
    /// F, mm/min.
    Feed,
    /// F, mm a turn.
    FeedPerRevolution,
    /// S, r/min.
    Speed,
    /// What the spindle does.
    Spindle,
    /// Coolant: flood, mist.
    Coolant(usize),
    /// T: the tool chosen last.
    Tool,
    /// The tool in the spindle.
    InSpindle,
    /// H.
    LengthNumber,
    /// D.
    RadiusNumber,
    /// Machine position of the zero that an axis is measured from, mm or degrees.
    WorkZero(Axis),
    /// Tool length on an axis, mm.
    Length(Axis),
}

/// A value of what is compared.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Setting {
    /// Nothing.
    None,
    /// A G code in tenths.
    Code(u16),
    /// A number.
    Number(f64),
    /// What the spindle does.
    Spindle(SpindleState),
    /// On or off.
    Switch(bool),
}

pub(super) fn differences(program: &ProgramState, machine: &ProgramState) -> Vec<Difference> {
    let mut all = Vec::new();
    let mut compare = |of, program: Setting, machine: Setting| {
        if program != machine {
            all.push(Difference { of, program, machine });
        }
    };
    let code_of = |state: &ProgramState, group| {
        let code = state.codes().find(|code| code.group == group);
        code.map_or(Setting::None, |code| Setting::Code(code.tenths))
    };
    for code in program.codes() {
        compare(Compared::Code(code.group), Setting::Code(code.tenths), code_of(machine, code.group));
    }
    let number = |value: f64| Setting::Number(value);
    let numbers = |state: &ProgramState| {
        [
            (Compared::Feed, state.feed_per_minute),
            (Compared::FeedPerRevolution, state.feed_per_revolution),
            (Compared::Tool, f64::from(state.tool)),
            (Compared::InSpindle, f64::from(state.in_spindle)),
            (Compared::LengthNumber, f64::from(state.length_number)),
            (Compared::RadiusNumber, state.radius_number),
        ]
    };
    for ((of, a), (_, b)) in numbers(program).into_iter().zip(numbers(machine)) {
        compare(of, number(a), number(b));
    }
    let speed = |state: &ProgramState| state.speed.map_or(Setting::None, number);
    compare(Compared::Speed, speed(program), speed(machine));
    compare(Compared::Spindle, Setting::Spindle(program.spindle), Setting::Spindle(machine.spindle));
    for (which, (a, b)) in program.coolant.iter().zip(&machine.coolant).enumerate() {
        compare(Compared::Coolant(which), Setting::Switch(*a), Setting::Switch(*b));
    }
    for axis in Axis::ALL {
        compare(Compared::WorkZero(axis), number(program.work_zero[axis]), number(machine.work_zero[axis]));
        compare(Compared::Length(axis), number(program.length[axis]), number(machine.length[axis]));
    }
    all
}

impl Compared {
    /// Its name: `G03` (the modal group by the manual's number), `F`, `zero.X`.
    pub fn name(self) -> String {
        match self {
            Compared::Code(group) => format!("G{group:02}"),
            Compared::Feed => "F".to_owned(),
            Compared::FeedPerRevolution => "F_per_turn".to_owned(),
            Compared::Speed => "S".to_owned(),
            Compared::Spindle => "spindle".to_owned(),
            Compared::Coolant(0) => "flood".to_owned(),
            Compared::Coolant(_) => "mist".to_owned(),
            Compared::Tool => "T".to_owned(),
            Compared::InSpindle => "in_spindle".to_owned(),
            Compared::LengthNumber => "H".to_owned(),
            Compared::RadiusNumber => "D".to_owned(),
            Compared::WorkZero(axis) => format!("zero.{}", axis.letter()),
            Compared::Length(axis) => format!("length.{}", axis.letter()),
        }
    }
}

impl Setting {
    /// As a program has it; none for nothing.
    pub fn text(self) -> Option<String> {
        Some(match self {
            Setting::None => return None,
            Setting::Code(tenths) => g_code_name(tenths),
            Setting::Number(number) => short(number),
            Setting::Spindle(state) => spindle(state, &Position::ZERO),
            Setting::Switch(on) => if on { "on" } else { "off" }.to_owned(),
        })
    }
}

/// A move of one axis to where a block begins.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct AxisMove {
    /// The axis.
    pub axis: Axis,
    /// Where to, mm or degrees.
    pub to: f64,
    /// Whether it positions; else it cuts.
    pub is_rapid: bool,
    /// mm/min; none is that of positioning.
    pub speed: Option<f64>,
}

/// The moves among steps that begin at `from`, in their order.
pub fn axis_moves<'a>(ops: impl Iterator<Item = &'a Op>, from: Position) -> Vec<AxisMove> {
    let mut at = from;
    let mut moves = Vec::new();
    for op in ops {
        let Some(to) = op.target() else { continue };
        let (is_rapid, speed) = match op {
            Op::Rapid { speed, .. } => (true, *speed),
            Op::Feed { feed, .. } => (false, feed.per_minute()),
            _ => (false, None),
        };
        for axis in Axis::ALL.into_iter().filter(|axis| at[*axis] != to[*axis]) {
            moves.push(AxisMove { axis, to: to[axis], is_rapid, speed });
        }
        at = *to;
    }
    moves
}

/// A function as a program has it; none for what is none. `at` is where surface speeds are reckoned.
pub fn function(op: &Op, at: &Position) -> Option<String> {
    Some(match op {
        Op::Select(tool) => format!("T{tool}"),
        Op::Change(_) => "M06".to_owned(),
        Op::Machine(code) => format!("M{code:02}"),
        Op::MachineNumber { code, number } => format!("M{code:02} P{number}"),
        Op::Spindle(state) => spindle(*state, at),
        Op::Coolant(on) => if *on { "M08" } else { "M09" }.to_owned(),
        Op::Output { port, value, .. } => format!("{port} = {value}"),
        _ => return None,
    })
}

fn spindle(state: SpindleState, at: &Position) -> String {
    let code = match state {
        SpindleState::Off => return "M05".to_owned(),
        SpindleState::Clockwise(_) => "M03",
        SpindleState::CounterClockwise(_) => "M04",
    };
    let rpm = state.speed().map_or(0.0, |speed| speed.rpm(at));
    let surface = matches!(state.speed(), Some(Speed::Surface { .. }));
    format!("{code} S{}{}", short(rpm), if surface { " (G96)" } else { "" })
}

/// A number as short as it is exact to 0.0001.
pub fn short(value: f64) -> String {
    let text = format!("{value:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
