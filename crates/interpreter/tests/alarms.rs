//! One program for every rule that the manual's list of alarms gives a number: the alarm, and the
//! words that it is about. The steps before it are given out as if nothing were wrong behind them.
#![allow(missing_docs)]

mod common;

use common::{at_fault, lines, run};
use ferrocut_interpreter::dialects::gsk990mc::DIALECT;
use ferrocut_machine::{AlarmId, Fault};

/// What the machine refuses and not the language: numbers of the control's supervisor.
const OF_THE_MACHINE: &[Fault] = &[Fault::SpindleTooFast, Fault::ToolMissing];

/// The rule, its number in appendix 2, a program that breaks it, the words at fault, and a set-up.
const CASES: &[(Fault, u16, &str, &str, &str)] = &[
    (Fault::NumberWithoutAddress, 4, "G0 X1\n5 X2\nM30", "5", ""),
    (Fault::AddressWithoutNumber, 5, "G0 X1\nX Y2\nM30", "X", ""),
    (Fault::MisplacedSign, 6, "G0 X1\nX--2\nM30", "--", ""),
    (Fault::WordNegative, 6, "G0 X1\nG1 X2 F-5\nM30", "F-5", ""),
    (Fault::MisplacedPoint, 7, "G0 X1\nX1.2.3\nM30", "X1.2.3", ""),
    (Fault::WordNotWhole, 7, "G0 X1\nT1.5\nM30", "T1.5", ""),
    (Fault::IllegalCharacter, 9, "G0 X1\nX2 & Y3\nM30", "&", ""),
    (Fault::UnknownAddress, 9, "G0 X1\nE5\nM30", "E5", ""),
    (Fault::UnknownGCode, 10, "G0 X1\nG99 G77 X2\nM30", "G77", ""),
    (Fault::NoFeed, 11, "G0 X1\nG1 X2\nM30", "G1 X2", "[parameters]\nP87 = 0"),
    (Fault::FeedOutOfRange, 11, "G0 X1\nG1 X2 F0\nM30", "F0", ""),
    (Fault::ArcRadiusMismatch, 20, "G0 X1\nG2 X21 Y5 I10\nM30", "G2 X21 Y5 I10", ""),
    (Fault::ArcRadiusTooSmall, 20, "G0 X1\nG2 X21 R9\nM30", "R9", ""),
    (Fault::ArcWithoutCentre, 22, "G0 X1\nG2 X21\nM30", "G2 X21", ""),
    (Fault::LengthWithCoordinateSet, 27, "G0 X1\nG43 G92 Z5 H1\nM30", "G43 G92 Z5 H1", ""),
    (Fault::WorkOffsetNumber, 30, "G0 X1\nG54 P51\nM30", "G54", ""),
    (Fault::CycleNoPeck, 45, "S100\nG0 X1\nG83 X2 Z-5 R0\nM30", "G83", ""),
    (Fault::CycleDepthAboveR, 49, "S100\nG0 X1\nG81 X2 Z5 R0\nM30", "Z5", ""),
    (Fault::CallWithoutProgram, 76, "G0 X1\nM98 L2\nM30", "M98", ""),
    (Fault::ProgramMissing, 78, "G0 X1\nM98 P77\nM30", "P77", ""),
    (Fault::PlaneInCycle, 86, "S100\nG0 X1\nG81\nG18\nM30", "G18", ""),
    (Fault::ResultTooLarge, 111, "G0 X1\nX[EXP[999]]\nM30", "X[EXP[999]]", ""),
    (Fault::DivisionByZero, 112, "G0 X1\nX[1/0]\nM30", "X[1/0]", ""),
    (Fault::UnknownFunction, 113, "G0 X1\nX[FOO[1]]\nM30", "FOO", ""),
    (Fault::UnknownVariable, 115, "G0 X1\nX#99999\nM30", "X#99999", ""),
    (Fault::VariableNotWritable, 116, "G0 X1\n#5001=5\nM30", "#5001=5", ""),
    (Fault::BracketsTooDeep, 118, "G0 X1\nX[[[[[[1]]]]]]\nM30", "[", ""),
    (Fault::ProgramCodesTogether, 119, "G0 X1\nM8 M0\nM30", "M8 M0", ""),
    (Fault::TooManyMCodes, 119, "G0 X1\nM3 M8 M10 M11 S5\nM30", "M3 M8 M10 M11", ""),
    (Fault::NoProgramEnd, 124, "G0 X1\n", "G0 X1", ""),
    (Fault::MalformedExpression, 125, "G0 X1\nX[1+]\nM30", "]", ""),
    (Fault::MalformedStatement, 125, "G0 X1\n#1\nM30", "1", ""),
    (Fault::UnbalancedBracket, 125, "G0 X1\nX[1+2\nM30", "[", ""),
    (Fault::MixedStatement, 127, "G0 X1\n#1=5 X2\nM30", "X2", ""),
    (Fault::UnknownAxis, 133, "G0 X1\nB5\nM30", "B5", ""),
    (Fault::ProgramNumber, 172, "G0 X1\nM98 P0\nM30", "P0", ""),
    (Fault::TooManyRepeats, 173, "O1\nG0 X1\nM98 P1 L10000\nM30", "L10000", ""),
    (Fault::CyclePlane, 175, "S100\nG0 X1\nG18\nG81 Z-1 R0\nM30", "G81", ""),
    (Fault::CycleNoSpindle, 178, "G0 X1\nG81 Z-1 R0\nM30", "G81", ""),
    (Fault::UnknownMCode, 181, "G0 X1\nM123\nM30", "M123", ""),
    (Fault::TooManyHelicalAxes, 232, "G0 X1\nG2 X11 Z1 A9 R5\nM30", "G2 X11 Z1 A9 R5", ""),
    (Fault::EndMarkReached, 235, "%\nG0 X1\n%\n", "%", ""),
    (Fault::RepeatedAddress, 238, "G0 X1\nX2 X3\nM30", "X3", ""),
    (Fault::NullVariable, 18, "G0 X1\n#0=5\nM30", "#0=5", ""),
    (Fault::MacrosTooDeep, 122, "G0 X1\nG65 P1\nM30\nO1\nG65 P1\nM99", "P1", ""),
    (Fault::InvalidLoop, 126, "G0 X1\nWHILE[1EQ1]DO4\nEND4\nM30", "WHILE[1EQ1]DO4", ""),
    (Fault::SequenceMissing, 128, "G0 X1\nGOTO7\nM30", "GOTO7", ""),
    (Fault::ArgumentAddress, 129, "O1\nG0 X1\nG65 P1 O5\nM30", "O5", ""),
    (Fault::JumpIntoLoop, 137, "G0 X1\nWHILE[1EQ2]DO1\nN5\nEND1\nGOTO5\nM30", "GOTO5", ""),
    (Fault::LoopMismatch, 138, "G0 X1\nWHILE[1EQ1]DO1\nX1\nM30", "WHILE[1EQ1]DO1", ""),
    (Fault::UnknownOperation, 199, "G0 X1\nG65 H98 P#1 Q1 R1\nM30", "G65 H98 P#1 Q1 R1", ""),
    (Fault::RepeatedGroup, 238, "G0 X1\nG90 X2 G91\nM30", "G91", ""),
];

/// Cases whose text is too long for the table.
fn long_cases() -> Vec<(Fault, u16, String, String)> {
    // 0026: a line of more than 1024 bytes.
    let long = format!("N1{}", " X1".repeat(341));
    assert_eq!(long.len(), 1025);
    // 0077: more levels than 3.2.2 note 3 allows.
    let level = |n: u32| format!("O{n}\nM98 P{}\nM99\n", n + 1);
    let deep: String = (1..10).map(level).collect();
    vec![
        (Fault::LineTooLong, 26, format!("G0 X1\n{long}\nM30"), long[..80].to_owned()),
        (Fault::CallsTooDeep, 77, format!("G0 X1\nM98 P1\nM30\n{deep}"), "P5".to_owned()),
    ]
}

fn raises(fault: Fault, number: u16, program: &str, words: &str, setup: &str) {
    let (steps, alarm) = run(program, setup);
    let Some(alarm) = alarm else { panic!("{program}: no alarm") };
    let found = (alarm.fault, alarm.id, at_fault(program, &alarm).trim_end());
    assert_eq!(found, (fault, AlarmId::Dialect("gsk990mc", number), words), "{program}");
    let before = &program[..usize::try_from(alarm.span.offset).unwrap()];
    assert_eq!(alarm.span.line as usize, before.matches('\n').count() + 1, "{program}");
    // The block before the one at fault was carried out, nothing of the one at fault.
    let moves: Vec<f64> = steps.iter().filter_map(|s| s.op.target()).map(|to| to.0[0]).collect();
    assert_eq!(moves, [1.0], "{program}");
}

#[test]
fn every_number_has_a_program_that_raises_it() {
    for (fault, number, program, words, setup) in CASES {
        raises(*fault, *number, program, words, setup);
    }
    for (fault, number, program, words) in long_cases() {
        raises(fault, number, &program, &words, "");
    }
}

#[test]
fn no_number_of_the_table_is_without_a_program() {
    let long = long_cases();
    let shown: Vec<(Fault, u16)> =
        CASES.iter().map(|c| (c.0, c.1)).chain(long.iter().map(|c| (c.0, c.1))).collect();
    let missing: Vec<_> = DIALECT
        .alarms
        .iter()
        .filter(|row| !shown.contains(row) && !OF_THE_MACHINE.contains(&row.0))
        // H is held to 0…255 (table 3-1-3-1) before the table of offsets is asked.
        .filter(|row| row.0 != Fault::OffsetNumber)
        .collect();
    assert!(missing.is_empty(), "add a program to CASES for {missing:?}");
}

#[test]
fn the_tables_of_alarms_and_of_their_texts_agree() {
    let catalogue = ferrocut_machine::Catalogue::new(ferrocut_machine::Language::default());
    for (fault, number) in DIALECT.alarms {
        let alarm =
            ferrocut_machine::Alarm::new(AlarmId::Dialect("gsk990mc", *number), *fault, Default::default());
        let text = catalogue.message(&alarm);
        assert!(!text.is_empty() && !text.contains("gsk990mc"), "{number} has no text: {text:?}");
        assert!(catalogue.help(&alarm).is_some(), "{number} does not say what to do");
    }
}

#[test]
fn what_repeats_may_do_so_where_the_parameter_lets_it() {
    // 32#6 = 0: the last of an address or of a group counts (3.1.3, 4.1 note 5).
    let tolerant = "[parameters]\n\"NO32.6\" = 0";
    assert_eq!(lines("G1 X2 X3 G0\nM30", tolerant), ["rapid X3", "end M30"]);
    // 33#7 = 0: one M code in a block.
    let one = "[parameters]\n\"NO33.7\" = 0";
    raises(Fault::TooManyMCodes, 119, "G0 X1\nM8 M10\nM30", "M8 M10", one);
}

#[test]
fn just_inside_is_no_alarm() {
    // The neighbours of cases above that a control must take.
    let good: &[(&str, &str, &str)] = &[
        // P214 = 0.05 mm between the radii of start and end.
        ("G2 X20.05 I10\nM30", "", "xy X20.05 about 10 0 by -180 F300"),
        // R a little too small for the chord, within the same.
        ("G2 X20 R9.98\nM30", "", "xy X20 about 10 0 by -180 F300"),
        ("G54 P50 X1\nM30", "", "rapid X1"),
        ("G43 H255 X1\nM30", "", "rapid X1"),
        ("X[[[[[1]]]]]\nM30", "", "rapid X1"),
        ("O1\nM98 P2 L9999\nX1\nM30\nO2\nM99\n", "", "rapid X1"),
        ("X1\nM30\n%\n", "", "rapid X1"),
        ("G81 R0 X1\nM30", "", "rapid X1"),
    ];
    for (program, setup, first) in good {
        let program = match program.contains("G81") {
            true => format!("S100\n{program}"),
            false => (*program).to_owned(),
        };
        assert_eq!(lines(&program, setup)[0], *first, "{program}");
    }
}

#[test]
fn rules_without_a_number_of_the_manual() {
    let cases: &[(Fault, &str, &str)] = &[
        // Table 3-1-3-1: values beyond what an address holds.
        (Fault::WordOutOfRange, "G0 X1\nX100000\nM30", "X100000"),
        (Fault::WordOutOfRange, "G0 X1\nH256\nM30", "H256"),
        (Fault::WordOutOfRange, "G0 X1\nF100000\nM30", "F100000"),
        // 4.2.5, 3.
        (Fault::NegativeDwell, "G0 X1\nG4 X-1\nM30", "X-1"),
        (Fault::NegativeDwell, "G0 X1\nG4 P-1\nM30", "P-1"),
        // A circle about its own start.
        (Fault::ArcWithoutRadius, "G0 X1\nG2 X1 I0 J0\nM30", "I0"),
        (Fault::LengthInArc, "G0 X1\nG43\nG2 X11 I5 H1\nM30", "G2 X11 I5 H1"),
    ];
    for (fault, program, words) in cases {
        let setup = if *fault == Fault::LengthInArc { "[tools.1]\nlength = 5" } else { "" };
        let (_, alarm) = run(program, setup);
        let alarm = alarm.unwrap_or_else(|| panic!("{program}: no alarm"));
        assert_eq!((alarm.fault, at_fault(program, &alarm)), (*fault, *words), "{program}");
    }
}

#[test]
fn an_endless_way_out_ends_where_numbers_lose_their_digits() {
    // Incremental moves that repeat for ever would come to where 1 mm is below what a number resolves.
    let program = "O1\nG20 G91 G0\nM98 P2 L9999\nM30\nO2\nX99999.\nM99\n";
    let (steps, alarm) = run(program, "");
    let alarm = alarm.map(|a| (a.fault, at_fault(program, &a).trim_end().to_owned()));
    assert_eq!(alarm, Some((Fault::CoordinateTooLarge, "X99999.".to_owned())));
    // 1e8 mm at 25.4 × 99999 mm a move.
    assert_eq!(steps.len(), 39);
}

#[test]
fn an_alarm_changes_nothing_and_ends_the_run() {
    let program = "G0 X5\nG1 Y5 F0\nX9\nM30";
    let options = ferrocut_interpreter::Options::default();
    let mut interpreter = common::interpreter(program.as_bytes(), "", options).unwrap();
    let before = interpreter.position();
    assert!(interpreter.next().unwrap().is_ok());
    let at = interpreter.position();
    assert_ne!(at, before);
    assert!(interpreter.next().unwrap().is_err());
    assert_eq!(interpreter.position(), at);
    assert!(interpreter.next().is_none());
    assert!(interpreter.next().is_none());
}

#[test]
fn a_checker_goes_on_to_every_alarm() {
    // Seven faults, three of them in one block, in the order of the text; the block behind a fault is
    // judged from where the faulty one was meant to end.
    let program = "G0 X1\nG77 X2 E5 H999\nG1 X3 F100\nG2 X23 Y5 I10\nM98 P5\nX#0[\nG81 Z-1 R0\nM30\n";
    let options = ferrocut_interpreter::Options { keep_going: true, ..Default::default() };
    let mut interpreter = common::interpreter(program.as_bytes(), "", options).unwrap();
    let mut found = Vec::new();
    let mut ends = 0;
    for step in &mut interpreter {
        match step {
            Ok(step) => ends += usize::from(matches!(step.op, ferrocut_toolpath::Op::End(30))),
            Err(alarm) => found.push((alarm.span.line, at_fault(program, &alarm).trim_end().to_owned())),
        }
    }
    let expected =
        [(2, "G77"), (2, "E5"), (2, "H999"), (4, "G2 X23 Y5 I10"), (5, "P5"), (6, "["), (7, "G81")];
    let expected: Vec<(u32, String)> = expected.into_iter().map(|(line, w)| (line, w.to_owned())).collect();
    assert_eq!((found, ends), (expected, 1));
}
