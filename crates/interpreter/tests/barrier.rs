//! Reading what only a machine at rest knows (GSK990MC table 4-9-2-3).
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::lines;
use ferrocut_geometry::{Axis, Position};
use ferrocut_interpreter::{AtRest, Options};
use ferrocut_machine::Fault;
use ferrocut_toolpath::Op;

#[test]
fn positions_of_the_moment_and_inputs_wait_for_the_machine() {
    for (read, waits) in [
        ("#5001", false), // End of the block before: known to the program.
        ("#5006", true),
        ("#5011", true),
        ("#5016", false), // Where the skip signal came: G31 has waited for it.
        ("#5021", true),
        ("#5026", true),
        ("#1000", true),
        ("#[5000+6]", true),
        ("#4001", false),
        ("#100", false),
    ] {
        let found = lines(&format!("G0 X1\n#100={read}\nG0 X2\nM30\n"), "");
        let expected: &[&str] = match waits {
            true => &["rapid X1", "Barrier", "rapid X2", "end M30"],
            false => &["rapid X1", "rapid X2", "end M30"],
        };
        assert_eq!(found, expected, "{read}");
    }
}

#[test]
fn what_is_behind_a_stop_is_read_after_it() {
    // 5.2 note 2: the operator changes a length and a variable meanwhile.
    let program = "#500=1\nG0 X10\nM00\nG43 H1 G0 Z20\nG0 X#500\nM30\n";
    let mut interpreter =
        common::interpreter(program.as_bytes(), "[tools.1]\nlength = 5", Options::default()).unwrap();
    while !matches!(interpreter.next().unwrap().unwrap().op, Op::Stop(0)) {}
    assert_eq!(interpreter.next().unwrap().unwrap().op, Op::Barrier);
    interpreter.memory_mut().tools.get_mut(1).unwrap().length = 8.0;
    let ends: Vec<Position> = interpreter.filter_map(|step| step.unwrap().op.target().copied()).collect();
    assert_eq!(ends[0][Axis::Z], 28.0);
    // In cutter compensation the move before is still to end.
    let found = lines("G41 D1 G1 X10 F100\nX20\nM00\nY10\nG40 X40\nM30\n", "[tools.1]\nradius = 5");
    assert!(!found.contains(&"Barrier".to_owned()), "{found:?}");
    // LinuxCNC reads no further either; M1 that does not stop holds nothing up.
    let ngc = |program: &str| {
        let dialect = &ferrocut_interpreter::dialects::rs274::DIALECT;
        let interpreter =
            common::interpreter_of(dialect, program.as_bytes(), "", Options::default()).unwrap();
        let ops: Vec<Op> = interpreter.map(|step| step.unwrap().op).collect();
        ops.windows(2).filter(|pair| pair[0] == Op::Stop(0) && pair[1] == Op::Barrier).count()
    };
    assert_eq!([ngc("G0 X1\nM0\nG0 X2\nM2\n"), ngc("G0 X1\nM1\nG0 X2\nM2\n")], [1, 0]);
}

#[test]
fn a_block_that_waited_acts_once() {
    // A word, a condition, an argument, an operation, a block that begins its program.
    let found = lines("O1 G91 G0 X[#5006+1]\nX[#5006+1] M8\nM30\n", "");
    assert_eq!(found, ["Barrier", "rapid X1", "Barrier", "coolant on", "rapid X3", "coolant off", "end M30"]);
    let found = lines("#1=#5006\nIF[#5006 EQ 0]GOTO 5\nG0 X9\nN5 G65 H02 P#1 Q#5006 R3\nG0 X#1\nM30\n", "");
    assert_eq!(found, ["Barrier", "Barrier", "Barrier", "rapid X3", "end M30"]);
    let found = lines("O1\nG65 P2 A[#5006+4]\nM30\nO2\nG0 X#1\nM99\n", "");
    assert_eq!(found, ["Barrier", "rapid X4", "end M30"]);
}

#[test]
fn a_fault_beside_the_read_is_raised_once() {
    for keep_going in [false, true] {
        let program = "G0 X1\nG0 X[1/0] Y#5006\nM30\n";
        let options = Options { keep_going, ..Options::default() };
        let interpreter = common::interpreter(program.as_bytes(), "", options).unwrap();
        let faults: Vec<Fault> = interpreter.filter_map(|step| Some(step.err()?.fault)).collect();
        assert_eq!(faults, [Fault::DivisionByZero], "{keep_going}");
    }
}

#[test]
fn what_compensation_holds_back_is_given_out_before_the_wait() {
    let found = lines("G41 D1 G1 X0 Y10 F100\nX20\n#100=#5006\nX40\nG40 X60\nM30\n", "[tools.1]\nradius = 5");
    let barrier = found.iter().position(|line| line == "Barrier").unwrap();
    // Square to the move before: 5 to the left of its end (20, 10).
    assert_eq!(found.get(barrier - 1).map(String::as_str), Some("feed X20 F100"), "{found:?}");
}

#[test]
fn the_machine_tells_where_it_came_to_rest() {
    let program = "G91 G31 X50 F100\n#500=#5006\n#501=#5016\n#502=#5026\nG0 X5\nM30\n";
    let mut interpreter = common::interpreter(program.as_bytes(), "", Options::default()).unwrap();
    let x = |at: f64| {
        let mut position = Position::ZERO;
        position[Axis::X] = at;
        position
    };
    let mut told = 0;
    let mut targets = Vec::new();
    while let Some(step) = interpreter.next() {
        let step = step.unwrap();
        if step.op == Op::Barrier {
            told += 1;
            // The signal came at 20, the axes stopped at 20.5 and lag behind by 0.25.
            let skip = (told == 1).then(|| x(20.0));
            interpreter.came_to_rest(&AtRest { skip, ..AtRest::new(x(20.5), x(20.25)) });
        }
        targets.extend(step.op.target().map(|to| to[Axis::X]));
    }
    let value = |n| interpreter.memory().variables.get(n).unwrap();
    assert_eq!((value(500), value(501), value(502)), (20.5, 20.0, 0.25));
    assert_eq!(targets, [50.0, 25.5]);
}

#[test]
fn a_loop_that_waits_for_an_input_for_ever_is_found_out() {
    let program = b"WHILE[#1000 EQ 0]DO1\nEND1\nM30\n";
    let mut interpreter = common::interpreter(program, "", Options::default()).unwrap();
    let alarm = interpreter.find_map(Result::err).unwrap();
    assert_eq!(alarm.fault, Fault::EndlessProgram);
}

/// What would end the loop is at fault itself: the findings come all the same, and soon.
#[test]
fn a_loop_with_a_fault_in_it_is_not_looked_through_for_ever() {
    for program in
        ["#1=0\nWHILE[#1 LT 5]DO1\nG0 X1\nX2\n#1=#1+1]\nEND1\nM30\n", "N1 G1 X1 F100\n#1=SQRT[-1]\nGOTO 1\n"]
    {
        let options = Options { keep_going: true, ..Options::default() };
        let interpreter = common::interpreter(program.as_bytes(), "", options).unwrap();
        let (mut steps, mut faults) = (0, 0);
        for next in interpreter {
            match next {
                Ok(_) => steps += 1,
                Err(_) => faults += 1,
            }
        }
        assert!(faults > 0 && steps < 100_000, "{program}: {steps} steps, {faults} faults");
    }
}
