//! A program that is sent bit by bit gives the steps of the whole one, whatever the bits are; what leads elsewhere
//! in it is an alarm, and lines that are done are given back.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

use ferrocut_interpreter::{Dialect, Interpreter, Options, dialects};
use ferrocut_machine::{Fault, Memory};
use ferrocut_program::{FileId, MOST_KEPT, ProgramMemory, Refused, Text};
use ferrocut_toolpath::{Op, Step};
use proptest::prelude::*;

fn interpreter(dialect: &'static Dialect, text: Text) -> Interpreter {
    let programs = ProgramMemory::new("test.nc", text, dialect.syntax);
    Interpreter::new(dialect, programs, Memory::new(dialect.name), Options::default())
}

/// The steps of a program that is there as a whole, up to an alarm.
fn whole(dialect: &'static Dialect, program: &str) -> Vec<Step> {
    let text = Text::from_bytes(program.as_bytes().to_vec()).unwrap();
    interpreter(dialect, text).map_while(Result::ok).collect()
}

/// The steps of the same program sent in bits of these lengths, one after the other and again.
fn bits(dialect: &'static Dialect, program: &str, lengths: &[usize]) -> Vec<Step> {
    let mut interpreter = interpreter(dialect, Text::sent());
    let (mut rest, mut steps) = (program.as_bytes(), Vec::new());
    for length in lengths.iter().cycle() {
        let (bit, left) = rest.split_at((*length).min(rest.len()));
        interpreter.append(bit).unwrap();
        rest = left;
        while let Some(step) = interpreter.next() {
            let Ok(step) = step else { return steps };
            interpreter.give_back(step.span);
            steps.push(step);
        }
        if rest.is_empty() {
            break;
        }
        assert!(interpreter.is_starved() && interpreter.next().is_none(), "it waits for more");
    }
    interpreter.end_text();
    steps.extend(interpreter.map_while(Result::ok));
    steps
}

const GSK: &str = "O1\r\nG54 G90 G0 X10 Y20 Z50\nM3 S800\n\n(a comment)\nG1 Z-2 F200\r\nG2 X20 Y20 R5\n\
    G41 G1 D1 X30\nY40\nX50 Y60\nG40 X70\nG81 X10 Y10 Z-5 R2 F100\nX20\nX30 L2\nG80\nG4 X1.5\nM30\n";
const NGC: &str = "G21 G90 G94\nG0 X1 Y2\n#<depth> = 3\nG1 Z-#<depth> F100\n\
    o1 if [#<depth> GT 2]\nG1 X5\no1 endif\nG3 X10 I2.5\nM2\n";

#[test]
fn a_program_in_bits_gives_the_steps_of_the_whole() {
    for (dialect, program) in [(&dialects::gsk990mc::DIALECT, GSK), (&dialects::rs274::DIALECT, NGC)] {
        let expected = whole(dialect, program);
        assert!(matches!(expected.last(), Some(Step { op: Op::End(_), .. })), "{:?}", expected.last());
        for lengths in [&[1][..], &[7], &[40, 3], &[1000]] {
            assert_eq!(bits(dialect, program, lengths), expected, "{} {lengths:?}", dialect.name);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]
    #[test]
    fn whatever_the_bits_are(lengths in prop::collection::vec(1usize..60, 1..12)) {
        let dialect = &dialects::gsk990mc::DIALECT;
        prop_assert_eq!(bits(dialect, GSK, &lengths), whole(dialect, GSK));
    }

    #[test]
    fn whatever_is_sent(bytes in prop::collection::vec(any::<u8>(), 0..400), length in 1usize..90) {
        for dialect in dialects::ALL {
            let mut interpreter = interpreter(dialect, Text::sent());
            for bit in bytes.chunks(length) {
                let _ = interpreter.append(bit);
                prop_assert!(interpreter.by_ref().take(10_000).count() < 10_000);
            }
        }
    }
}

#[test]
fn lines_and_spans_are_those_of_all_that_was_sent() {
    let mut interpreter = interpreter(&dialects::rs274::DIALECT, Text::sent());
    interpreter.append(b"G0 X1\n").unwrap();
    let first = interpreter.next().unwrap().unwrap();
    assert_eq!((first.span.offset, first.span.line, interpreter.lines_done()), (0, 1, 1));
    assert!(interpreter.next().is_none() && interpreter.is_starved());
    interpreter.give_back(first.span);
    interpreter.append(b"\nG0 X2\nG0 X").unwrap();
    let second = interpreter.next().unwrap().unwrap();
    assert_eq!((second.span.offset, second.span.line), (7, 3));
    assert_eq!(interpreter.programs().slice(second.span), "G0 X2");
    assert!(interpreter.next().is_none());
    assert_eq!(interpreter.lines_done(), 3, "the line that is begun does not count");
}

#[test]
fn what_was_run_is_given_back_and_memory_is_bounded() {
    let mut interpreter = interpreter(&dialects::rs274::DIALECT, Text::sent());
    let line = format!("G1 X1 F100 ({})\nG1 X0\n", "x".repeat(150));
    // Thirty times as much as is ever kept.
    for _ in 0..30 * MOST_KEPT / line.len() {
        interpreter.append(line.as_bytes()).unwrap();
        while let Some(step) = interpreter.next() {
            interpreter.give_back(step.unwrap().span);
        }
    }
    // Without giving back there is an end.
    let mut refused = Ok(());
    for _ in 0..2 * MOST_KEPT / line.len() {
        refused = interpreter.append(line.as_bytes());
    }
    assert_eq!(refused, Err(Refused::Full));
}

#[test]
fn a_jump_in_what_is_sent_is_an_alarm() {
    for (dialect, program) in [
        (&dialects::gsk990mc::DIALECT, "G0 X1\nGOTO 20\n"),
        (&dialects::gsk990mc::DIALECT, "G0 X1\nWHILE [#1 LT 3] DO1\nX2\n"),
        (&dialects::rs274::DIALECT, "G0 X1\no1 while [0]\nG0 X2\n"),
    ] {
        let mut interpreter = interpreter(dialect, Text::sent());
        interpreter.append(program.as_bytes()).unwrap();
        let last = interpreter.by_ref().last().unwrap();
        let alarm = last.unwrap_err();
        assert_eq!((alarm.fault, alarm.span.line), (Fault::LinesNotKept, 2), "{program}");
    }
}

#[test]
fn after_its_end_another_program_may_follow() {
    let mut interpreter = interpreter(&dialects::rs274::DIALECT, Text::sent());
    interpreter.append(b"o1 if [1]\nG0 X1\no1 endif\nM2\nG0 X2\n").unwrap();
    let steps: Vec<Op> = interpreter.by_ref().map(|step| step.unwrap().op).collect();
    assert!(matches!(steps.last(), Some(Op::End(2))) && !interpreter.is_starved());
    interpreter.go_on();
    assert!(matches!(interpreter.next().unwrap().unwrap().op, Op::Rapid { to, .. } if to.0[0] == 2.0));
    // Its labels are its own.
    interpreter.append(b"o1 if [1]\nG0 X3\no1 endif\n").unwrap();
    assert_eq!(interpreter.by_ref().filter(|step| step.is_ok()).count(), 1);
}

#[test]
fn a_reset_forgets_what_was_sent_and_not_run() {
    let mut interpreter = interpreter(&dialects::rs274::DIALECT, Text::sent());
    interpreter.append(b"G0 X1\n").unwrap();
    let at = *interpreter.next().unwrap().unwrap().op.target().unwrap();
    interpreter.append(b"G0 X2\nG0 X3\nG0").unwrap();
    interpreter.reset(at);
    assert!(interpreter.next().is_none());
    interpreter.append(b"G0 Y5\n").unwrap();
    let step = interpreter.next().unwrap().unwrap();
    assert_eq!((step.span.line, &step.op.target().unwrap().0[..2]), (5, &[1.0, 5.0][..]));
    assert_eq!(interpreter.programs().text(FileId(0)).unwrap().len(), 26);
}
