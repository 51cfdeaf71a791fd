//! RS274/NGC: rules of LinuxCNC's manual, with values worked out by hand and asked of its program.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{interpreter_of, run_on};
use ferrocut_geometry::Axis;
use ferrocut_interpreter::Options;
use ferrocut_interpreter::dialects::rs274::DIALECT;
use ferrocut_machine::Fault;
use ferrocut_toolpath::Op;

/// The points that a program leads to, X and Y and Z of the machine, and its alarm with the line.
fn points(program: &str, setup: &str) -> (Vec<[f64; 3]>, Option<(Fault, u32)>) {
    let (steps, alarm) = run_on(&DIALECT, program, setup);
    let points = steps.iter().filter_map(|step| step.op.target());
    let rounded = |v: f64| (v * 1e4).round() / 1e4 + 0.0;
    let points = points.map(|to| [Axis::X, Axis::Y, Axis::Z].map(|axis| rounded(to[axis]))).collect();
    (points, alarm.map(|alarm| (alarm.fault, alarm.span.line)))
}

fn runs(program: &str, expected: &[[f64; 3]]) {
    assert_eq!(points(program, ""), (expected.to_vec(), None), "{program}");
}

/// The X coordinates that a program without an alarm leads to.
fn xs(program: &str) -> Vec<f64> {
    let (points, alarm) = points(program, "");
    assert_eq!(alarm, None, "{program}");
    points.iter().map(|p| p[0]).collect()
}

fn fails(program: &str, fault: Fault, line: u32) {
    assert_eq!(points(program, "").1, Some((fault, line)), "{program}");
}

#[test]
fn blanks_and_capitals_mean_nothing() {
    runs("g 0 x + 0. 12 34 y 7\nM2\n", &[[0.1234, 7.0, 0.0]]);
    runs("#<A b>=3\nG0 X#<ab>\nM2\n", &[[3.0, 0.0, 0.0]]);
}

#[test]
fn parameters_are_set_when_their_block_was_read() {
    // NGC 3.3.3: on the right and in the words the old value still stands.
    assert_eq!(xs("#1=6 #2=#1\nG0 X#1 #1=5\nG0 X[#1+#2]\nM2\n"), [6.0, 5.0]);
    assert_eq!(xs("#1=2\n##1=5\nG0 X#2\nM2\n"), [5.0]);
}

#[test]
fn operators_bind_as_the_manual_says() {
    for (expression, value) in [
        ("2 + 3 * 4 ** 2", 50.0),
        ("2 ** 3 ** 2", 64.0),
        ("10 - 4 - 3", 3.0),
        ("-2 ** 2", 4.0),
        ("5 MOD 3 + 1", 3.0),
        ("-5 MOD 3", 1.0),
        ("3 GT 2 AND 2 GT 1", 1.0),
        ("1 EQ 1.00005", 1.0),
        ("1 NE 1.0002", 1.0),
        ("2 XOR 3", 0.0),
        ("0 OR 3", 1.0),
        ("ATAN[-1]/[-1]", -135.0),
        ("FIX[-2.5]", -3.0),
        ("FUP[-2.5]", -2.0),
        ("ROUND[-2.5]", -3.0),
        ("ABS[-1] + SQRT[16] + EXP[0] + LN[1]", 6.0),
        ("EXISTS[#<_x>] + EXISTS[#<other>]", 1.0),
    ] {
        assert_eq!(xs(&format!("G0 X[[{expression}] + 100]\nM2\n")), [value + 100.0], "{expression}");
    }
    for (expression, fault) in [
        ("1/0", Fault::DivisionByZero),
        ("SQRT[-1]", Fault::FunctionDomain),
        ("LN[0]", Fault::FunctionDomain),
        ("ASIN[2]", Fault::FunctionDomain),
        ("[-8] ** [1/3]", Fault::FunctionDomain),
        ("5 MOD 0", Fault::ResultTooLarge),
        ("#5602", Fault::UnknownVariable),
        ("#0", Fault::UnknownVariable),
        ("#<none>", Fault::UnknownVariable),
        ("ATAN[1]", Fault::MalformedExpression),
        ("COT[1]", Fault::UnknownFunction),
        ("[1", Fault::UnbalancedBracket),
    ] {
        fails(&format!("G0 X1\nG0 X[{expression}]\nM2\n"), fault, 2);
    }
}

#[test]
fn subprograms_have_parameters_of_their_own() {
    let program = "o1 sub\nG0 X[#1+#2+#3]\n#1=50\n#<own>=1\n#<_all>=7\no1 endsub [#1+1]\n\
        #1=7 #2=8 #3=9\no1 call [10]\nG0 X[#1+#<_all>]\nG0 X#<_value>\nG0 X[EXISTS[#<own>]]\nM2\n";
    assert_eq!(xs(program), [10.0, 14.0, 51.0, 0.0]);
    // Nine calls may stand in each other.
    let deep =
        |n: u32| format!("o1 sub\no2 if [#1 LT {n}]\no1 call [#1+1]\no2 endif\no1 endsub\no1 call [1]\nM2\n");
    assert_eq!(points(&deep(9), "").1, None);
    fails(&deep(10), Fault::CallsTooDeep, 3);
}

#[test]
fn a_subprogram_may_stand_further_down() {
    assert_eq!(xs("o1 call [3]\nG0 X9\nM2\no1 sub\nG0 X#1\no1 endsub\n"), [3.0, 9.0]);
    // But its definition is not come to from above any more.
    fails("o1 call\no1 sub\nG0 X1\no1 endsub\nM2\n", Fault::LabelRepeated, 2);
}

#[test]
fn loops_and_conditions() {
    let program = "o100 while [#1 LT 5]\n#1=[#1+1]\no101 if [#1 EQ 2]\no100 continue\no101 elseif [#1 EQ 4]\n\
        o100 break\no101 else\nG0 X#1\no101 endif\no100 endwhile\no2 do\n#1=[#1-1]\nG0 X[#1+50]\n\
        o2 while [#1 GT 2]\no3 repeat [2.6]\nG91 G0 X1\no3 endrepeat\no4 repeat [-1]\nG0 X99\no4 endrepeat\nM2\n";
    assert_eq!(xs(program), [1.0, 3.0, 53.0, 52.0, 53.0, 54.0, 55.0]);
    // Labels are of their subprogram.
    let twice = "o1 sub\no9 if [1]\nG0 X1\no9 endif\no1 endsub\no1 call\no9 if [1]\nG0 X2\no9 endif\nM2\n";
    assert_eq!(xs(twice), [1.0, 2.0]);
    // What is passed over is not read, but for its comments.
    assert_eq!(xs("o1 if [0]\nG0 X1 what is this!\no1 endif\nG0 X2\nM2\n"), [2.0]);
    fails("o1 if [0]\nG0 X1 (open\no1 endif\nM2\n", Fault::UnclosedComment, 2);
}

#[test]
fn o_words_out_of_place() {
    for (program, fault, line) in [
        ("o1 if [1]\no1 endif\no1 if [1]\no1 endif\nM2\n", Fault::LabelRepeated, 3),
        ("o1 sub\no1 endsub\nG0 X1\no1 sub\no1 endsub\nM2\n", Fault::LabelRepeated, 4),
        ("o1 endif\nM2\n", Fault::LabelMissing, 1),
        ("o1 repeat [2]\no1 break\no1 endrepeat\nM2\n", Fault::LabelMissing, 2),
        ("G0 X1\no1 endsub\nM2\n", Fault::OutsideSubprogram, 2),
        ("o1 sub\no2 sub\no2 endsub\no1 endsub\nM2\n", Fault::SubprogramNested, 2),
        ("o1 while [0]\nG0 X1\nM2\n", Fault::NoProgramEnd, 3),
        ("G0 X1\no1 call\nM2\n", Fault::ProgramMissing, 2),
        ("o1 call G0 X1\nM2\n", Fault::MixedStatement, 1),
        ("o1 what\nM2\n", Fault::MalformedStatement, 1),
        ("G0 X1 o1 call\nM2\n", Fault::IllegalCharacter, 1),
        ("G0 X1\n", Fault::NoProgramEnd, 1),
    ] {
        fails(program, fault, line);
    }
}

#[test]
fn m98_shares_parameters_and_repeats() {
    let program = "#1=5\nM98 P100 L2\nG0 X[#1+20]\nM2\no100\n#1=[#1+1]\nG0 X#1\nM99\n";
    assert_eq!(xs(program), [6.0, 7.0, 27.0]);
    assert_eq!(xs("G0 X1\nM99\nG0 X2\nM2\n"), [1.0]);
    fails("M98 P1\nM2\no1 sub\no1 endsub\n", Fault::CallForm, 3);
    fails("M98\nM2\n", Fault::CallWithoutProgram, 1);
}

#[test]
fn codes_and_words_that_do_not_go_together() {
    for (block, fault) in [
        ("X1", Fault::AxesWithoutCode),
        ("G80 X1", Fault::AxesWithoutCode),
        ("G0 G1 X1", Fault::RepeatedGroup),
        ("M3 M70", Fault::RepeatedGroup),
        ("G28 G92 X1", Fault::RepeatedGroup),
        ("G10 L2 P1 X1 G0", Fault::CodesContradict),
        ("G53 G2 X1 I1", Fault::CodesContradict),
        ("G91 G53 G0 X1", Fault::CodesContradict),
        ("G92", Fault::AxesMissing),
        ("G4", Fault::WordMissing),
        ("G0 X1 P1", Fault::WordUnused),
        ("G0 X1 R1", Fault::WordUnused),
        ("G0 X1 K1", Fault::WordUnused),
        ("H1", Fault::WordUnused),
        ("D1", Fault::WordUnused),
        ("Q1", Fault::WordUnused),
        ("G0 X1 X2", Fault::RepeatedAddress),
        ("M3 M7 M48 M0 M62 P1", Fault::TooManyMCodes),
        ("M11", Fault::UnknownMCode),
        ("G12", Fault::UnknownGCode),
        ("G1 X1", Fault::NoFeed),
        ("F-1", Fault::WordNegative),
        ("G93 G1 X1", Fault::NoFeed),
        ("G95 F1 G1 X1", Fault::SpindleAtRest),
        ("G10 L2 P10 X1", Fault::WorkOffsetNumber),
        ("G10 L3 P1 X1", Fault::DataForm),
        ("G10 L20 P1 R5", Fault::WordUnused),
        ("G10 L1 P1", Fault::DataValue),
        ("#5400=1", Fault::VariableNotWritable),
        ("#<_x>=1", Fault::VariableNotWritable),
        ("M61", Fault::WordMissing),
        ("M66 P1 E1", Fault::CodesContradict),
        ("M66 P1 L3", Fault::WordMissing),
        ("G96 D5", Fault::WordMissing),
        ("M72", Fault::NothingSaved),
        ("(LOG,text)", Fault::FilesNotWritten),
        ("G0 X1 (a (b) c)", Fault::UnclosedComment),
        ("G0 X1 N5", Fault::IllegalCharacter),
        ("//G0 X1", Fault::IllegalCharacter),
        ("%", Fault::IllegalCharacter),
    ] {
        fails(&format!("G17\n{block}\nM2\n"), fault, 2);
    }
}

#[test]
fn one_formula_leads_to_the_machine() {
    // A quarter turn: (1, 2) is (-2, 1) from the zero.
    runs("G10 L2 P1 X10 Y20 R90\nG0 X1 Y2\nM2\n", &[[8.0, 21.0, 0.0]]);
    // G53 is not turned; the axes not named stay.
    runs("G10 L2 P1 X10 Y20 R90\nG0 X1 Y2\nG53 G0 X3\nM2\n", &[[8.0, 21.0, 0.0], [3.0, 21.0, 0.0]]);
    // G92: here X is 0; G92.2 takes it back, G92.3 brings it again, G92.1 forgets it.
    assert_eq!(
        xs("G0 X10\nG92 X0\nG0 X1\nG92.2\nG0 X1\nG92.3\nG0 X1\nG92.1\nG92.3\nG0 X1\nM2\n"),
        [10.0, 11.0, 1.0, 11.0, 1.0]
    );
    assert_eq!(xs("G52 X3\nG0 X1\nG92 X5\nG0 X6\nG52 X0\nG0 X1\nM2\n"), [4.0, 5.0, 1.0]);
    // Inches.
    assert_eq!(xs("G20 G0 X1\nG21\nG91 G0 X1\nM2\n"), [25.4, 26.4]);
    assert_eq!(xs("G7 G0 X10\nG8\nG0 X11\nM2\n"), [5.0, 11.0]);
}

#[test]
fn zeros_by_the_present_position() {
    // From the program of LinuxCNC: G54 is turned by 30°, G55 by 50°, the axes stand at (8.6603, 5).
    let program = "G10 L2 P1 R30\nG0 X10 Y0\nG10 L20 P1 X0\nG10 L2 P2 X1 R50\nG10 L20 P2 X3\nG55\nG0 X0 Y0\n\
        G0 X[#5241] Y[#5242]\nM2\n";
    let (points, alarm) = points(program, "");
    assert_eq!(alarm, None);
    assert_eq!(points[0], [8.6603, 5.0, 0.0]);
    assert_eq!(points[1], [4.6987, 4.4079, 0.0]);
}

#[test]
fn reference_points() {
    let setup = "[reference_points]\nfirst = { x = 1.0, y = 2.0, z = 30.0 }\nsecond = { z = 50.0 }\n";
    let program = "G10 L2 P1 X5\nG0 X1 Y1\nG28 Z3\nG30\nG28.1\nG0 X7 Z1\nG28 X7\nM2\n";
    let (points, alarm) = points(program, setup);
    assert_eq!(alarm, None);
    let expected = [
        [6.0, 1.0, 0.0],
        [6.0, 1.0, 3.0],
        [6.0, 1.0, 30.0],
        [0.0, 0.0, 50.0],
        [12.0, 0.0, 1.0],
        [0.0, 0.0, 1.0],
    ];
    assert_eq!(points, expected);
}

#[test]
fn tool_lengths() {
    let setup = "[tools.1]\nlength = 10.0\n[tools.2]\nlength = 3.0\n";
    let z = |program: &str| {
        let (points, alarm) = points(program, setup);
        assert_eq!(alarm, None, "{program}");
        points.iter().map(|p| p[2]).collect::<Vec<_>>()
    };
    assert_eq!(
        z("T1 M6 G43\nG0 Z0\nG43.2 H2\nG0 Z0\nG43 H2\nG0 Z0\nG49\nG0 Z0\nM2\n"),
        [10.0, 13.0, 3.0, 0.0]
    );
    assert_eq!(z("G43.1 Z4\nG0 Z1\nM61 Q1\nG43\nG0 Z1\nM2\n"), [5.0, 11.0]);
    assert_eq!(z("G10 L1 P1 Z7\nG43 H1\nG0 Z1\nM2\n"), [8.0]);
    // At Z8 and so that it would be Z5: the length is 3.
    assert_eq!(z("G0 Z8\nG10 L10 P1 Z5\nG43 H1\nG0 Z0\nM2\n"), [8.0, 3.0]);
}

#[test]
fn saved_states() {
    assert_eq!(xs("G21 G90\nM70\nG20 G91\nG0 X1\nM72\nG0 X2\nM2\n"), [25.4, 2.0]);
    // M73 restores when its subprogram returns.
    assert_eq!(xs("o1 sub\nM73\nG20 G55\nG0 X1\no1 endsub\nG10 L2 P2 X5\no1 call\nG0 X2\nM2\n"), [30.4, 2.0]);
    fails("M70\nM71\nM72\nM2\n", Fault::NothingSaved, 3);
}

#[test]
fn texts_for_the_operator() {
    let program =
        "#1=2.5\n(MSG, a (note)\n(msg,here)\n(print,x=#1 y=#<_y> #nothing %d#1)\n#5599=0\n(debug,no)\nM2\n";
    fails(program, Fault::UnclosedComment, 2);
    let program = program.replace("(MSG, a (note)\n", "(MSG, first) (MSG, last)\n");
    let (steps, alarm) = run_on(&DIALECT, &program, "");
    assert_eq!(alarm, None);
    let texts: Vec<_> = steps
        .iter()
        .filter_map(|step| match &step.op {
            Op::Message(text) => Some(text.to_string()),
            _ => None,
        })
        .collect();
    assert_eq!(texts, ["last", "here", "x=2.500000 y=0.000000 #nothing 2"]);
}

#[test]
fn inputs_are_read_with_the_machine_at_rest() {
    let program = "G0 X1\nM66 P3 L0\nG0 X[#5399+5]\nM66 P4 L3 Q2\nG0 X[#5399]\nM2\n";
    let mut interpreter = interpreter_of(&DIALECT, program.as_bytes(), "", Options::default()).unwrap();
    interpreter.set_port(3, 1.0);
    interpreter.set_port(4, 0.0);
    let ops: Vec<Op> = interpreter.map(|step| step.unwrap().op).collect();
    let xs: Vec<f64> = ops.iter().filter_map(|op| Some(op.target()?[Axis::X])).collect();
    assert_eq!(xs, [1.0, 6.0, -1.0]);
    assert!(matches!(ops[1], Op::Barrier));
}

#[test]
fn percent_signs_frame_a_program() {
    assert_eq!(xs("\n  %\nG0 X1\n%\nG0 X2\n"), [1.0]);
    fails("%\nG0 X1\n", Fault::NoProgramEnd, 2);
}

#[test]
fn many_calls_end_and_take_no_memory() {
    let program = "o1 sub\n#<n>=#1\no1 endsub\no2 repeat [100000]\no1 call [5]\no2 endrepeat\nG0 X1\nM2\n";
    assert_eq!(xs(program), [1.0]);
}

/// What LinuxCNC keeps away from the depth reached before: 0.010 inch.
const CLEARANCE: &str = "[parameters]\nP270 = 0.254\nP271 = 0.254\n";

#[test]
fn a_drilled_and_contoured_part_is_the_same_as_on_the_gsk() {
    let tools =
        "[tools.1]\nlength = 40.0\n[tools.2]\nlength = 55.5\n[work_offsets]\nG54 = { x = 5.0, y = -3.0 }\n";
    let part = "G17 G21 G40 G49 G80 G90 G94 G54
T1 M6
S2000 M3
M8
G43 H1 G0 Z30
G0 X-5 Y0
G0 Z2
G1 Z-3 F120
G1 X0 F300
G1 Y20
G2 X10 Y30 I10 J0
G1 X40
G3 X50 Y40 R10
G1 Y60
G2 X50 Y60 I10 J0
G91 G1 X10 Y-5
G90
G3 X60 Y55 Z-6 I5 J0
G1 Z2
G0 Z30
M9
G49 G0 Z100
T2 M6
S900 M3
G43 H2 G0 Z30
G99 G81 X20 Y10 R3 Z-12 F150
X40
G80
G0 Z30
G98 G81 X40 Y30 R3 Z-12
G82 X60 Y10 R3 Z-5 P500
G83 X20 Y50 R2 Z-25 Q10 F120
G99 G73 X40 Y50 R2 Z-25 Q10
G85 X60 Y50 R2 Z-8
G80
G0 Z30
G49 G0 Z100
M5
M30
";
    let gsk = common::lines(&format!("O10\n{part}"), &format!("{CLEARANCE}{tools}"));
    // The same but for the unit of a dwell: a second, and a thousandth of it.
    let rs274 = common::lines_on(&DIALECT, &part.replace("P500", "P0.5"), tools);
    assert_eq!(gsk, rs274);
    assert!(rs274.len() > 50, "{rs274:?}");
}

/// G53 holds for its block alone: the way of G28 behind it is in the coordinate system again.
#[test]
fn machine_coordinates_end_with_their_block() {
    runs(
        "G10 L2 P1 X10\nG54\nG53 G0 X1\nG28 X2\nM2\n",
        &[[1.0, 0.0, 0.0], [12.0, 0.0, 0.0], [0.0, 0.0, 0.0]],
    );
}
