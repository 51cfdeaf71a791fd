//! What homing does to a program that runs ahead of it.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

use ferrocut_geometry::{Axis, Position};
use ferrocut_interpreter::{Interpreter, Options, Unreferenced, dialects};
use ferrocut_machine::{Fault, Memory, Setup};
use ferrocut_program::{ProgramMemory, Text};
use ferrocut_toolpath::Op;

fn interpreter(program: &str) -> Interpreter {
    interpreter_with("[work_offsets]\nG55 = { x = 30 }", program)
}

fn interpreter_with(setup: &str, program: &str) -> Interpreter {
    let dialect = &dialects::gsk990mc::DIALECT;
    let text = Text::from_bytes(program.as_bytes().to_vec()).unwrap();
    let programs = ProgramMemory::new("test.nc", text, dialect.syntax);
    let mut memory = Memory::new(dialect.name);
    Setup::from_toml(setup).unwrap().apply(&mut memory).unwrap();
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

#[test]
fn what_follows_a_search_counts_from_the_reference_point() {
    // 4.3.2: where G28 ends, wherever the axis was taken to be before.
    for (program, searched, ends) in [
        ("G91 G28 X-2\nG0 X-3\nM30\n", true, 7.0),
        ("G91 G28 X-2\nG0 X-3\nM30\n", false, 7.0),
        ("G90 G28 X-40\nG91 G0 X-3\nM30\n", true, 7.0),
        ("G28 X0\nG90 G0 X5\nM30\n", true, 5.0),
    ] {
        let mut interpreter = interpreter_with("[start]\nx = -34\n[parameters]\nP45 = 10", program);
        let axes = searched.then_some(Axis::X).into_iter().collect();
        interpreter.set_unreferenced(Unreferenced { axes, ..Unreferenced::default() });
        let last = interpreter.filter_map(|step| step.unwrap().op.target().copied()).last();
        assert_eq!(last.unwrap()[Axis::X], ends, "{program}");
    }
}

#[test]
fn strokes_are_judged_before_homing_where_the_parameter_says_so() {
    // 2.5.2 and 2.6, 5: 11#6 = 0 judges no axis that was not homed.
    let first = ("[parameters]\nP66 = -5\nP67 = 5", "G90 G0 X-30\nM30\n", Fault::SoftLimit);
    let inside = (
        "[parameters]\n\"NO11.0\" = 0",
        "G90 G0 X0 Y0 Z0\nG12 X-20 Y5 Z5 I-30 J-10 K-5\nG1 X-25 F2000\nM30\n",
        Fault::StoredStroke,
    );
    for (setup, program, fault) in [first, inside] {
        let alarm = |axes: &[Axis], limits_before: bool| {
            let mut interpreter = interpreter_with(setup, program);
            let axes = axes.iter().copied().collect();
            interpreter.set_unreferenced(Unreferenced { axes, limits_before, ..Unreferenced::default() });
            interpreter.find_map(Result::err).map(|alarm| alarm.fault)
        };
        assert_eq!(alarm(&[], false), Some(fault));
        assert_eq!(alarm(&[Axis::X, Axis::Z], false), None);
        assert_eq!(alarm(&[Axis::X, Axis::Z], true), Some(fault));
    }
}
