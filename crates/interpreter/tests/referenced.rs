//! What homing does to a program that runs ahead of it.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

use ferrocut_geometry::{Axis, Position};
use ferrocut_interpreter::{Interpreter, Options, dialects};
use ferrocut_machine::{Memory, Setup};
use ferrocut_program::{ProgramMemory, Text};
use ferrocut_toolpath::Op;

fn interpreter(program: &str) -> Interpreter {
    let dialect = &dialects::gsk990mc::DIALECT;
    let text = Text::from_bytes(program.as_bytes().to_vec()).unwrap();
    let programs = ProgramMemory::new("test.nc", text, dialect.syntax);
    let mut memory = Memory::new(dialect.name);
    Setup::from_toml("[work_offsets]\nG55 = { x = 30 }").unwrap().apply(&mut memory).unwrap();
    Interpreter::new(dialect, programs, memory, Options::default())
}

/// Machine position of the move behind the stop, `act` done there.
fn behind_the_stop(act: impl Fn(&mut Interpreter)) -> Position {
    let mut interpreter = interpreter("G55 G92 X500\nM0\nG90 G1 X540 F600\nM30\n");
    while !matches!(interpreter.next().unwrap().unwrap().op, Op::Stop(0)) {}
    act(&mut interpreter);
    let targets = interpreter.filter_map(|step| step.unwrap().op.target().copied());
    targets.last().unwrap()
}

#[test]
fn homing_by_hand_ends_the_system_of_g92() {
    // G92 calls machine position 0 500; G55 has its zero at 30.
    assert_eq!(behind_the_stop(|_| {})[Axis::X], 40.0);
    assert_eq!(behind_the_stop(Interpreter::homed_by_hand)[Axis::X], 570.0);
}
