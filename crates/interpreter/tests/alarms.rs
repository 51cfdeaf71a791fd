//! One program for every rule that the manual's list of alarms gives a number: the alarm, and the
//! words that it is about. The steps before it are given out as if nothing were wrong behind them.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{at_fault, lines, run, short};
use ferrocut_geometry::Position;
use ferrocut_interpreter::dialects::gsk990mc::DIALECT;
use ferrocut_machine::{AlarmId, Fault};

/// What the machine refuses and not the language: numbers of the control's supervisor and of its drives.
const OF_THE_MACHINE: &[Fault] = &[
    Fault::SpindleTooFast,
    Fault::ToolMissing,
    Fault::FollowingError,
    Fault::PitchPoint,
    Fault::NotReferenced,
    Fault::ReferenceNeeded,
    Fault::ReferenceByProgram,
    Fault::HomingStopped,
    Fault::EmergencyStop,
    Fault::LinesNotKept,
    Fault::RigidTappingOff,
    Fault::RestartOrder,
    Fault::RestartNotReferenced,
    Fault::RestartOtherProgram,
    Fault::MeasureNotReferenced,
    Fault::ProbeMissing,
    Fault::SetterMissed,
    Fault::ParametersClosed,
    Fault::ParametersOpen,
    Fault::PowerOffNeeded,
];

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
    (
        Fault::DwellLimits,
        168,
        "S100\nG0 X1\nG82 X2 Z-5 R0 P500\nM30",
        "P500",
        "[parameters]\nP281 = 1000\nP282 = 1000",
    ),
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
    (Fault::NegativeDwell, 6, "G0 X1\nG4 X-1\nM30", "X-1", ""),
    (Fault::ArcWithoutRadius, 20, "G0 X1\nG2 X1 I0 J0\nM30", "I0", ""),
    (Fault::ArcAxisBesidePlane, 21, "G0 X1\nG2 X11 R5 A9\nM30", "A9", ""),
    (Fault::HelixWithoutArc, 24, "G0 X1\nG2 X1 Z5 R5\nM30", "G2 X1 Z5 R5", ""),
    (Fault::VariableInNumber, 115, "G0 X1\nN#100 X2\nM30", "N#100", ""),
    (Fault::JumpTargetMissing, 140, "G0 X1\nG65 H80 P7\nM30", "G65 H80 P7", ""),
    (Fault::TappingNoSpeed, 176, "G0 X1\nM29\nG84 X2 Z-5 R0 F1\nM30", "G84", ""),
    (Fault::NullVariable, 18, "G0 X1\n#0=5\nM30", "#0=5", ""),
    (Fault::MacrosTooDeep, 122, "G0 X1\nG65 P1\nM30\nO1\nG65 P1\nM99", "P1", ""),
    (Fault::InvalidLoop, 126, "G0 X1\nWHILE[1EQ1]DO4\nEND4\nM30", "WHILE[1EQ1]DO4", ""),
    (Fault::SequenceMissing, 128, "G0 X1\nGOTO7\nM30", "GOTO7", ""),
    (Fault::ArgumentAddress, 129, "O1\nG0 X1\nG65 P1 O5\nM30", "O5", ""),
    (Fault::ArgumentAddress, 129, "O1\nG0 X1\nN7 G65 P1 N5\nM30", "N5", ""),
    (Fault::JumpIntoLoop, 137, "G0 X1\nWHILE[1EQ2]DO1\nN5\nEND1\nGOTO5\nM30", "GOTO5", ""),
    (Fault::LoopMismatch, 138, "G0 X1\nWHILE[1EQ1]DO1\nX1\nM30", "WHILE[1EQ1]DO1", ""),
    (Fault::UnknownOperation, 199, "G0 X1\nG65 H98 P#1 Q1 R1\nM30", "G65 H98 P#1 Q1 R1", ""),
    (Fault::RepeatedGroup, 238, "G0 X1\nG90 X2 G91\nM30", "G91", ""),
];

/// Radius 5 in the offset table, entered as a radius.
const RADIUS: &str = "[tools.1]\nradius = 5\n[parameters]\n\"NO40.7\" = 0";

/// Scaling by P.
const SCALING: &str = "[parameters]\n\"NO47.6\" = 0\n\"NO60.5\" = 1";

/// The same for rules of coordinates, compensation, cycles and data setting. What comes before the
/// block at fault makes steps of its own, or is still held back for the block after it.
const FURTHER: &[(Fault, u16, &str, &str, &str)] = &[
    (Fault::NoFeedPerRevolution, 14, "G95 G1 X2 F1", "G95", "[parameters]\n\"NO13.1\" = 0"),
    (Fault::TooManyAxes, 15, "G1 X2 Y2 Z2 A2 F10", "G1 X2 Y2 Z2 A2 F10", "[parameters]\n\"NO9.1\" = 0"),
    (Fault::ScalingDisabled, 19, "G51 X0 Y0 P2", "G51", "[parameters]\n\"NO60.5\" = 0"),
    (Fault::StrokeNotAlone, 25, "G12 G90 X5", "G12", ""),
    (Fault::OffsetTooLarge, 29, "G43 H1 Z5", "H1", "[tools.1]\nlength = 1000"),
    (Fault::DataNumber, 31, "G10 L2 P7 X1", "P7", ""),
    (Fault::DataValue, 32, "G10 L10 P1 R1000", "R1000", ""),
    // The tool fits into the circle of 3, but the line before it touches its inside.
    (
        Fault::CutterNoIntersection,
        33,
        "X-20\nG41 D1 G1 X0 F100\nX10\nG3 X10 Y0 I-2.9985 J0.094868\nG1 Y-30\nX-30",
        "G3 X10 Y0 I-2.9985 J0.094868",
        "[tools.1]\nradius = 2.9\n[parameters]\n\"NO40.7\" = 0",
    ),
    (Fault::CutterStartInArc, 34, "G41 D1\nG2 X11 Y10 R10 F100\nG1 X30", "G2 X11 Y10 R10 F100", RADIUS),
    (Fault::SkipInCutter, 36, "G41 D1 G1 X10 F100\nX20\nG31 X30", "G31", RADIUS),
    (Fault::PlaneInCutter, 37, "G41 D1 G1 X10 F100\nX20\nG18", "G18", RADIUS),
    // A corner arc of the tool's own radius.
    (Fault::CutterArcCenter, 38, "G41 D1 G1 X10 F100\nX55\nG3 X60 Y5 R5\nG1 Y40\nX0", "G3 X60 Y5 R5", RADIUS),
    (Fault::WorkOffsetInCutter, 40, "G41 D1 G1 X10 F100\nX20\nG55", "G55", RADIUS),
    (
        Fault::CutterInterference,
        41,
        "G41 D1 G1 X10 F100\nX57\nG3 X60 Y3 R3\nG1 Y40\nX0",
        "G3 X60 Y3 R3",
        RADIUS,
    ),
    (
        Fault::CutterIdleBlocks,
        42,
        "G41 D1 G1 X10 F100\nX20\nM8\nM9\nM8\nM9\nM8\nM9\nM8\nM9\nM8\nM9\nM8\nX30\nY20",
        "M8",
        RADIUS,
    ),
    (Fault::ReferenceInCycle, 44, "S100\nG81\nG28 X0", "G28", ""),
    (Fault::ReferenceNumber, 46, "G30 P5 X0", "P5", ""),
    (Fault::CycleDepthBelowR, 48, "S100\nG87 X2 Z-5 R0 F10", "Z-5", ""),
    (Fault::CornerWithoutMove, 51, "G1 X5 F100 ,L1\nM8", ",L1", ""),
    (Fault::CornerForm, 53, "G0 X5 ,L1", ",L1", ""),
    (Fault::CornerTooLong, 55, "G1 X8 F100 ,L10\nY50", ",L10", ""),
    (Fault::ReturnWithMacro, 56, "G65 P1 M99", "M99", ""),
    (Fault::CornerPlaneBehind, 51, "G1 X5 F100 ,R1\nX9 Z2", ",R1", ""),
    (
        Fault::ArcWithoutRadiusInCutter,
        38,
        "G41 D1 G1 X10 F100\nY20\nG2 X10 Y20 I0 J0",
        "I0",
        "[tools.1]\nradius = 5",
    ),
    (Fault::CornerPlane, 58, "G1 X5 Z2 F100 ,R1\nX9", ",R1", ""),
    (Fault::DataSettingInCycle, 66, "S100\nG81\nG10 L2 P1 X1", "G10", ""),
    (Fault::DataForm, 67, "G10 L3 P1", "L3", ""),
    (Fault::CallInMacro, 81, "G65 P1\nM30\nO1\nM98 P2\nM99\nO2\nM99", "M98", ""),
    (Fault::NotAtReference, 92, "G27 X5", "X5", ""),
    (Fault::CornerArcForm, 114, "G39 X2", "G39", ""),
    (Fault::ParameterFixed, 117, "G10 L50\nN0 P2 R1\nG11", "N0 P2 R1", ""),
    (Fault::ScaleFactor, 142, "G51 P0", "P0", SCALING),
    (Fault::ScaledTooLarge, 143, "G51 X0 Y0 P100\nX5000", "X5000", SCALING),
    (Fault::PlaneInRotation, 144, "G68 X0 Y0 R10\nG18", "G18", ""),
    (Fault::ArcInPolar, 160, "G16\nG2 X5 Y90 I5", "G2 X5 Y90 I5", ""),
    (Fault::CodeInPolar, 161, "G16\nG53 X0", "G53", ""),
    (Fault::CodeInRotation, 163, "G68 X0 Y0 R10\nG54", "G54", ""),
    (Fault::CodeInScaling, 164, "G51 X0 Y0 P2\nG28 X10", "G28", SCALING),
    (Fault::NeedsOwnBlock, 165, "G68 G53 X0 Y0 R10", "G68", ""),
    (Fault::ReferenceWithoutAxis, 166, "G28", "G28", ""),
    (Fault::IntermediateTooLarge, 167, "G91 G28 X99999", "X99999", ""),
    (Fault::NoOrientation, 177, "S100\nG76 Z-5 R0 Q1 F10", "G76", "[parameters]\n\"NO1.2\" = 1"),
    (Fault::NoOrientation, 177, "S1\nG87 Z-5 R-20 Q1 F10", "G87", "[parameters]\n\"NO1.2\" = 1"),
    (Fault::CycleNoSpindle, 178, "S100\nG96 S30 P1\nG84 Z-5 R2 F10", "G84", "[parameters]\n\"NO61.0\" = 1"),
    (Fault::ToolNumber, 183, "T100", "T100", "[parameters]\nP206 = 2"),
    (
        Fault::MillMirrored,
        52,
        "S100 M3\nG51 X0 Y0 I-1 J1 K1\nG22 X5 Z-10 R5 I50 L4 W2 Q2 V1 D1 F100",
        "G22",
        "[tools.1]\nradius = 5\n[parameters]\n\"NO47.3\" = 1\n\"NO47.6\" = 1\n\"NO60.5\" = 1",
    ),
    (Fault::MillStepTooSmall, 185, "S100 M3\nG22 X5 Z-10 R5 I50 L-1 W2 Q2 V1 D1 F100", "L-1", RADIUS),
    (Fault::MillStepTooLarge, 186, "S100 M3\nG22 X5 Z-10 R5 I50 L11 W2 Q2 V1 D1 F100", "L11", RADIUS),
    (Fault::MillToolTooLarge, 187, "S100 M3\nG22 X5 Z-10 R5 I8 L4 W2 Q2 V1 D1 F100", "D1", RADIUS),
    (Fault::MillCornerTooLarge, 188, "S100 M3\nG33 Z-10 R5 I50 J40 U21 L4 W2 Q2 V1 D1 F100", "U21", RADIUS),
    (Fault::MillCornerTooSmall, 189, "S100 M3\nG33 Z-10 R5 I50 J40 U4 L4 W2 Q2 V1 D1 F100", "U4", RADIUS),
    (Fault::MillGapMissing, 190, "S100 M3\nG22 X5 Z-10 R5 I50 L4 W2 Q2 D1 F100", "G22", RADIUS),
    (Fault::MillFirstDepthMissing, 191, "S100 M3\nG22 X5 Z-10 R5 I50 L4 Q2 V1 D1 F100", "G22", RADIUS),
    (Fault::MillDepthMissing, 192, "S100 M3\nG22 X5 Z-10 R5 I50 L4 W2 V1 D1 F100", "G22", RADIUS),
    (Fault::MillSizeMissing, 193, "S100 M3\nG22 X5 Z-10 R5 L4 W2 Q2 V1 D1 F100", "G22", RADIUS),
    (Fault::MillSecondSizeMissing, 194, "S100 M3\nG33 Z-10 R5 I50 L4 W2 Q2 V1 D1 F100", "G33", RADIUS),
    (Fault::MillToolMissing, 195, "S100 M3\nG22 X5 Z-10 R5 I50 L4 W2 Q2 V1 F100", "G22", RADIUS),
    (Fault::SurfaceSpeedAxis, 198, "G96 S100 P9", "G96", "[parameters]\n\"NO61.0\" = 1"),
    (Fault::TappingSpeed, 200, "S0\nG84 X2 Z-5 R0 F1", "G84", ""),
    (Fault::TappingFeed, 201, "M29 S100\nG84 X2 Z-5 R0", "G84", ""),
    (Fault::RigidMisplaced, 203, "M29 S100\nS200", "S200", ""),
    (Fault::RigidInCycle, 204, "S100\nG81\nM29", "M29", ""),
    (Fault::PlaneInRigidTapping, 206, "M29 S100\nG18", "G18", ""),
    (Fault::CommandInDataSetting, 208, "G10 L51\nG0 X5", "G0 X5", ""),
    (Fault::SkipInTransform, 216, "G68 X0 Y0 R10\nG31 X5 F10", "G31", ""),
    (Fault::SkipBlockInTransform, 217, "G68 X0 Y0 R10\n/X5", "/X5", ""),
    (Fault::OffsetInTransform, 218, "G68 X0 Y0 R10\nG10 L2 P1 X5", "G10", ""),
    (Fault::UnitsInTransform, 220, "G68 X0 Y0 R10\nG20", "G20", ""),
    (Fault::DataParameter, 231, "G10 L51\nN9999 R1", "N9999 R1", ""),
];

/// What is wrong from the first block on.
const FIRST_BLOCK: (Fault, u16, &str, &str) =
    (Fault::ProgramNumberTooLarge, 74, "O100000\nG0 X1\nM30\n", "O100000");

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

/// The alarm that ends a program, and the words that it is about.
fn alarm_of(program: &str, setup: &str) -> (Fault, AlarmId, String) {
    let (steps, alarm) = run(program, setup);
    let Some(alarm) = alarm else { panic!("{program}: no alarm, {steps:?}") };
    let before = &program[..usize::try_from(alarm.span.offset).unwrap()];
    assert_eq!(alarm.span.line as usize, before.matches('\n').count() + 1, "{program}");
    (alarm.fault, alarm.id, at_fault(program, &alarm).trim_end().to_owned())
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
    for (fault, number, blocks, words, setup) in FURTHER {
        let program = format!("G0 X1\n{blocks}\nM30\n");
        let expected = (*fault, AlarmId::Dialect("gsk990mc", *number), (*words).to_owned());
        assert_eq!(alarm_of(&program, setup), expected, "{program}");
    }
    let (fault, number, program, words) = FIRST_BLOCK;
    assert_eq!(alarm_of(program, ""), (fault, AlarmId::Dialect("gsk990mc", number), words.to_owned()));
    for (fault, number, program, words) in long_cases() {
        raises(fault, number, &program, &words, "");
    }
}

#[test]
fn no_number_of_the_table_is_without_a_program() {
    let mut shown: Vec<(Fault, u16)> = vec![(FIRST_BLOCK.0, FIRST_BLOCK.1)];
    shown.extend(CASES.iter().chain(FURTHER).map(|c| (c.0, c.1)));
    shown.extend(long_cases().iter().map(|c| (c.0, c.1)));
    let missing: Vec<_> = DIALECT
        .alarms
        .iter()
        .filter(|row| !shown.contains(row) && !OF_THE_MACHINE.contains(&row.0))
        // H is held to 0…255 (table 3-1-3-1) before the table of offsets is asked.
        .filter(|row| row.0 != Fault::OffsetNumber)
        .collect();
    assert!(missing.is_empty(), "add a program to CASES or FURTHER for {missing:?}");
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

/// Moves that compensation holds back for the next block are given out before an alarm which is of that block alone.
#[test]
fn what_comes_before_a_faulty_block_is_done() {
    let faulty = [
        ("G40 G2 X60 Y20 R20", Fault::CutterStartInArc),
        ("D0 G2 X60 Y20 R20", Fault::CutterStartInArc),
        ("G77", Fault::UnknownGCode),
        ("X", Fault::AddressWithoutNumber),
        ("G2 X60 Y20 R1", Fault::ArcRadiusTooSmall),
    ];
    for (block, fault) in faulty {
        let program = format!("G0 X-10 Y-10\nG41 D1 G1 X0 Y0 F100\nX40\n{block}\nM30");
        let (steps, alarm) = run(&program, RADIUS);
        let alarm = alarm.unwrap();
        assert_eq!((alarm.fault, alarm.span.line), (fault, 4), "{block}");
        assert_eq!(
            short(&steps, Position::ZERO),
            ["rapid X-10 Y-10", "feed X0 Y5 F100", "feed X40 F100"],
            "{block}"
        );
    }
}

#[test]
fn what_repeats_may_do_so_where_the_parameter_lets_it() {
    // 32#6 = 0: the last of an address or of a group counts (3.1.3, 4.1 note 5).
    let tolerant = "[parameters]\n\"NO32.6\" = 0";
    assert_eq!(lines("G1 X2 X3 G0\nM30", tolerant), ["rapid X3", "end M30"]);
    let scaled = format!("{tolerant}\n\"NO47.6\" = 0\n\"NO60.5\" = 1");
    for (program, setup, step) in [
        ("G51 X0 Y0 P2 G50\nX3\nM30", scaled.as_str(), "rapid X3"),
        ("G50 G51 X0 Y0 P2\nX3\nM30", &scaled, "rapid X6"),
        ("G68 X0 Y0 R90 G69\nX3\nM30", tolerant, "rapid X3"),
        ("G69 G68 X0 Y0 R90\nX3\nM30", tolerant, "rapid Y3"),
        ("G16 G15\nX3 Y90\nM30", tolerant, "rapid X3 Y90"),
        ("G15 G16\nX3 Y90\nM30", tolerant, "rapid Y3"),
    ] {
        assert_eq!(lines(program, setup), [step, "end M30"], "{program}");
    }
}

/// P and L beside M99 are of the other code of their block.
#[test]
fn a_return_takes_no_word_of_another_code() {
    let more = "[work_offsets]\n\"G54 P1\" = { x = 1 }";
    let mills = "[tools.1]\nradius = 5\n[parameters]\n\"NO40.7\" = 0\n[start]\nz = 50";
    for (block, setup, step) in [
        ("G54 P1 G0 X2 M99", more, "rapid X3"),
        ("G4 P500 M99", "", "dwell 0.5s"),
        ("G51 X0 Y0 P2 M99", SCALING, ""),
        ("G0 X1 M99", "", "rapid X1"),
    ] {
        let found = lines(&format!("M98 P7\nM30\nO7\n{block}\n"), setup);
        let expected: Vec<_> = [step, "end M30"].into_iter().filter(|line| !line.is_empty()).collect();
        assert_eq!(found, expected, "{block}");
    }
    let high = "[start]\nz = 50";
    let cycles = [
        ("G22 X5 Z-10 R5 I50 L4 W2 Q2 V1 D1 F100 M99", mills),
        ("G82 X5 Z-10 R5 F100 P2000 M99", high),
        ("G82 X1 Z-10 R5 F100\nX5 P2000 M99", high),
    ];
    for (block, setup) in cycles {
        let (_, alarm) = run(&format!("S100 M3\nM98 P7\nM30\nO7\n{block}\n"), setup);
        assert_eq!(alarm, None, "{block}");
    }
}

/// 5: one M code in a block, with 33#7 three; the list of alarms has no number for more, 0119 is of codes that stand alone.
#[test]
fn m_codes_of_a_block_are_counted() {
    let one = "[parameters]\n\"NO33.7\" = 0";
    for (program, words, setup, limit) in [
        ("M3 M8 M10 M11 S5\nM30", "M3 M8 M10 M11", "", "at most 3"),
        ("M8 M10\nM30", "M8 M10", one, "at most 1"),
    ] {
        let (_, alarm) = run(program, setup);
        let alarm = alarm.unwrap_or_else(|| panic!("{program}: no alarm"));
        let found = (alarm.id, at_fault(program, &alarm));
        assert_eq!(found, (AlarmId::Core(Fault::TooManyMCodes), words), "{program}");
        let text = ferrocut_machine::Catalogue::new(ferrocut_machine::Language::En).message(&alarm);
        assert!(text.contains(limit), "{text}");
    }
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
        ("G60 G4 P500\nM30", "[parameters]\n\"NO48.0\" = 1", "dwell 0.5s"),
        ("G81 R0 X1\nM30", "", "rapid X1"),
        ("G16\nG10 L51 N334 R1\nG11\nG10 L50 N34 P0 R1\nG11\nG15\nX1\nM30", "", "rapid X1"),
        ("IF[[#1EQ#2]AND1]THEN #3=1\nX#3\nM30", "", "rapid X1"),
        ("#1=99.6\nS#1 M3\nM30", "", "spindle cw 100"),
        ("N1 N333 G10 L51 R1\nG11\nX1\nM30", "", "rapid X1"),
        ("G1 X20 F100 ,R5\nG10 L51\nN334 R1\nG11\nY20\nM30", "", "feed X15 F100"),
        ("N1 G10 L51 N334 R1\nN2 N335 R1\nG11\nX1\nM30", "", "rapid X1"),
        ("G1 X20 F100 , R5\nY20\nM30", "", "feed X15 F100"),
        ("G1 X20 F100 ,R5\nG54 Y20\nM30", "", "feed X15 F100"),
    ];
    for (program, setup, first) in good {
        let program = match program.contains("G81") {
            true => format!("S100\n{program}"),
            false => (*program).to_owned(),
        };
        assert_eq!(lines(&program, setup)[0], *first, "{program}");
    }
}

/// The number with which a program's block ends in an alarm, and the words at fault.
const SAME_NUMBER: &[(u16, &str, &str, &str)] = &[
    // 0006: a sign where the address takes none.
    (6, "G-1 X2", "G-1", ""),
    (6, "M-3", "M-3", ""),
    (6, "N-3 X2", "N-3", ""),
    (6, "G4 P-1", "P-1", ""),
    (6, "O1\nM98 P2 L-1\nM30\nO2\nM99", "L-1", ""),
    (6, "O1\nG65 P2 L-1\nM30\nO2\nM99", "L-1", ""),
    // 0007: a point where it takes none.
    (7, "O1\nM98 P2 L1.5\nM30\nO2\nM99", "L1.5", ""),
    (7, "O1\nG65 P2 L1.5\nM30\nO2\nM99", "L1.5", ""),
    (7, "S100\nG81 X2 Z-5 R0 K2.7", "K2.7", ""),
    (7, "M3.0", "M3.0", ""),
    (7, "T1.", "T1.", ""),
    (7, "H1.", "H1.", ""),
    (7, "N1.5 X2", "N1.5", ""),
    // Beyond the range of table 3-1-3-1, or of P204 to P206.
    (11, "F100000", "F100000", ""),
    // 0029: H of an earlier block too.
    (29, "H3\nG43 Z1", "G43 Z1", "[tools.3]\nlength = 2999"),
    (30, "H256", "H256", ""),
    (30, "G41 D256 X2", "D256", ""),
    (181, "M10", "M10", "[parameters]\nP204 = 1"),
    (182, "S100000", "S100000", ""),
    (182, "S10000", "S10000", "[parameters]\nP205 = 4"),
    (183, "T10000", "T10000", ""),
    // 0032: offsets too large, by G10 and by variable; P267 limits wear.
    (32, "G10 L11 P1 R400.1", "R400.1", ""),
    (32, "G10 L13 P1 R10.5", "R10.5", "[parameters]\nP267 = 10"),
    (32, "G10 L2 P1 X10000", "X10000", ""),
    (32, "G10 L2 P1", "G10 L2 P1", ""),
    (32, "G10 L20 P1", "G10 L20 P1", ""),
    (32, "#1501=1000", "#1501=1000", ""),
    (32, "#1801=500", "#1801=500", ""),
    (32, "#2101=1000", "#2101=1000", ""),
    (32, "#2401=500", "#2401=500", ""),
    (32, "#5206=10000", "#5206=10000", ""),
    // 0040: compensation is to be cancelled before G92 (4.2.11 note 2).
    (40, "G41 D1 G1 X10 F100\nX20\nG92 X0", "G92", RADIUS),
    // 0092: the point that is reached includes the vector of the cutter (4.3.4, 3).
    (92, "G90 G41 D1 G1 X50 F100\nX60\nG27 X0 Y0", "Y0", RADIUS),
    // 0051: the move after the corner has no length. 0053: two words for one corner.
    (51, "G1 X20 F100 ,L3\nX20\nY10", ",L3", ""),
    (53, "G1 X20 F100 ,L3 ,R2\nY10", ",R2", ""),
    // Corners stand at the end of G01, G02 and G03 (4.2.18).
    (53, "G31 X20 F100 ,R2", ",R2", ""),
    (53, "G60 X20 ,R2", ",R2", ""),
    (53, "G60 X20 ,R2", ",R2", "[parameters]\n\"NO48.0\" = 1"),
    (53, "G53 X20 ,R2", ",R2", ""),
    (53, "G28 X20 ,L2", ",L2", ""),
    (53, "G92 X20 ,R2", ",R2", ""),
    (53, "G4 X2 ,R2", ",R2", ""),
    (53, "S100\nG81 X2 Z-5 R0 ,R2", ",R2", ""),
    (53, "G51 X2 Y0 P2 ,R2", ",R2", SCALING),
    (53, "M8 ,R2", ",R2", ""),
    // 0111: EXP beyond 99997.4535 (4.9.5).
    (111, "#1=EXP[12]", "#1=EXP[12]", ""),
    // 0114: G39 stands without words.
    (114, "G41 D1 G1 X10 F100\nX20\nG39 X30", "G39", RADIUS),
    // 0115: O and N take no variables.
    (115, "N[#120] X2", "N[#120]", ""),
    // 0111: results of more than nine digits before the point (4.9.2, 5).
    (111, "#1=999999999+1", "#1=999999999+1", ""),
    (111, "G65 H4 P#1 Q-100000 R10000", "G65 H4 P#1 Q-100000 R10000", ""),
    (111, "#1=ABS[12345678901]", "#1=ABS[12345678901]", ""),
    (111, "#1=12345678901\nG65 H22 P#2 Q#1", "G65 H22 P#2 Q#1", ""),
    // 0117: names and kinds of axes act from the next power-on.
    (117, "G10 L51\nN178 R5", "N178 R5", ""),
    // Note 5: what the machine is built of acts from the next power-on; as it is it may be set.
    (117, "G10 L51\nN98 R2000\nN98 R800", "N98 R800", ""),
    (117, "G10 L51\nN88 R3000", "N88 R3000", ""),
    (117, "G10 L51\nN86 R3000\nN96 R5000\nN376 R3124\nN180 R1", "N180 R1", ""),
    (117, "G10 L50\nN56 P7 R0", "N56 P7 R0", ""),
    (117, "G10 L50\nN8 P3 R0", "N8 P3 R0", ""),
    // 0127: words of the control beside an operation of macro A.
    (127, "G65 H01 P#100 Q1 G0 X5", "G0", ""),
    (127, "N10 G65 H80 P20 M3\nN20", "M3", ""),
    (127, "X5 G65 H01 P#100 Q1", "X5", ""),
    // 0129: what stands before G65, and other codes.
    (129, "X5 G65 P77 Y2", "X5", ""),
    (129, "G65 P77 X5 G91", "G91", ""),
    // 0137: also where no loop was run before.
    // 0007: a spindle speed has no point.
    (7, "M3 S100.5", "S100.5", ""),
    // 0038: on the centre of an arc in compensation.
    (38, "G41 D1 G1 X10 F100\nY20\nG2 X10 Y20 I0 J0\nG1 Y50", "I0", "[tools.1]\nradius = 5"),
    // 0051: about the block behind a corner; 0058 is about its own.
    (51, "G1 X10 F100 ,L2\nZ-5", ",L2", ""),
    (51, "G1 X10 F100 ,R3\nX10 Y20 Z-5", ",R3", ""),
    (51, "G1 X5 F100 ,R1\nG18 G2 X9 R2", ",R1", ""),
    (51, "G1 X20 F100 ,L5\nG92 X0 Y0\nY20", ",L5", ""),
    (51, "G1 X20 F100 ,L5\nG55\nY20", ",L5", "[work_offsets]\nG55 = { x = 1.0 }"),
    (51, "G1 X20 F100 ,L5\nG10 L10 P1 R1\nY20", ",L5", ""),
    (51, "G1 X20 F100 ,L5\n#5206=10\nX20 Y20", "#5206=10", ""),
    (51, "G1 X20 F100 ,L5\nG68 X0 Y0 R10\nY20", ",L5", ""),
    (51, "G1 X20 F100 ,L5\nG51 X0 Y0 P2\nY20", ",L5", ""),
    (51, "G1 X20 F100 ,L5\nG16\nY20", ",L5", ""),
    // 0007: nor has a program number.
    (7, "O1.5\nG0 X1", "O1.5", ""),
    // 0167: however large the middle of G28 is.
    (167, "G28 X100000", "X100000", ""),
    (167, "X100000 G28", "X100000", ""),
    (167, "G30 P2 Y-123456", "Y-123456", ""),
    // 0074: a program number is no higher than 99999.
    (74, "M98 P100000", "P100000", ""),
    (74, "P100000 M98", "P100000", ""),
    (74, "#1=100000\nM98 P#1", "P#1", ""),
    (74, "G65 P100000 A1", "P100000", ""),
    // 0231: N behind G10 is that of a parameter.
    (231, "G10 L51 N270", "G10 L51 N270", ""),
    // 0032: in inches as in millimetres.
    (32, "G20\n#1501=40", "#1501=40", ""),
    // 0125: a condition compares (4.9.5).
    (125, "IF[#1]GOTO5\nN5 X1", "[#1]", ""),
    (125, "WHILE[#2]DO1\nEND1", "[#2]", ""),
    (125, "IF[#1 AND 1]THEN #2=3", "[#1 AND 1]", ""),
    (137, "GOTO5\nWHILE[#1LT1]DO1\nN5\n#1=1\nEND1", "GOTO5", ""),
    // 0165: G10 stands alone (4.2.7 note 2).
    (165, "M3 G10 L10 P1 R5", "M3 G10 L10 P1 R5", ""),
    // 4.2.5 note 3: both.
    (6, "G4 X2 P-1", "P-1", ""),
    (165, "G10 L10 P1 R5 F100", "G10 L10 P1 R5 F100", ""),
    (165, "G10 L10 P1 R5 X7", "G10 L10 P1 R5 X7", ""),
    (165, "G10 L51 Y7", "G10 L51 Y7", ""),
    // 0199: an operation that there is not, whatever else the block has.
    (199, "G65 H50", "G65 H50", ""),
    // 0200: P294 for rigid tapping.
    (200, "M29 S1500\nG84 X2 Z-5 R0 F100", "G84", "[parameters]\nP294 = 1000"),
    // 0203: nor does an axis move between M29 and the cycle.
    (203, "M29 S100\nG1 X2 F100\nG84 X2 Z-5 R0 F100", "G1 X2 F100", ""),
    (203, "M29 S100\nG0 X2\nG84 X2 Z-5 R0 F100", "G0 X2", ""),
    (203, "M29 S100\nG28 Z0\nG84 X2 Z-5 R0 F100", "G28 Z0", ""),
    // 0201: a feed of the other kind does not count.
    (201, "G1 X3 F100\nG95\nM29 S500\nG84 X2 Z-5 R0", "G84", ""),
    (201, "G95 G1 X3 F0.2\nG94\nM29 S500\nG84 X2 Z-5 R0", "G84", ""),
    // 0208: between G10 L50 or L51 and G11 only parameters (4.2.7 note 1).
    (208, "G10 L51\nX5", "X5", ""),
    (208, "G10 L51\nM3", "M3", ""),
    (208, "G10 L51\n#1=5", "#1=5", ""),
    (208, "G10 L51\nN271 R3 X5", "N271 R3 X5", ""),
    // 0217: whether skipped or not.
    (217, "G68 X0 Y0 R10\n//X5", "//X5", ""),
    // 0218: tool offsets too.
    (218, "G68 X0 Y0 R10\n#1501=5", "#1501=5", ""),
    (218, "G16\n#2101=5", "#2101=5", ""),
    // Parameters may be set there, those of the coordinate systems not.
    (218, "G16\nG10 L51\nN15 R3", "N15 R3", ""),
    (218, "G16\nG10 L10 P1 R5", "G10", ""),
    // 0238: two codes of group 00 (4.1 note 5).
    (238, "G4 G28 X5", "G28", ""),
    (238, "O1\nG65 P77 X1 P5", "P5", ""),
    (238, "G65 H2 P#100 Q1 Q2 R5", "Q2", ""),
    (238, "N5 N6 G0 X1", "N6", ""),
    (238, "G65 H1 P#100 P#101 Q2", "P#101", ""),
    (238, "G65 H1 H2 P#101 Q2", "H2", ""),
    // Modal by 48#0, G60 is of group 01.
    (238, "G0 G60 X5", "G60", "[parameters]\n\"NO48.0\" = 1"),
    // 0015: axes that move together, in G53 and G31 too.
    (15, "G53 X1 Y1 Z1 A1", "G53 X1 Y1 Z1 A1", ""),
    (15, "G31 X1 Y1 Z1 A1 F100", "G31 X1 Y1 Z1 A1 F100", ""),
    (15, "G1 X1 Y1 Z1 A1 F9", "G1 X1 Y1 Z1 A1 F9", "[parameters]\n\"NO9.1\" = 1\n\"NO0.7\" = 1"),
];

#[test]
fn further_ways_to_the_same_number() {
    for (number, block, words, setup) in SAME_NUMBER {
        let (_, id, found) = alarm_of(&format!("{block}\nM30\n"), setup);
        assert_eq!((id.number(), found.as_str()), (Some(*number), *words), "{block}");
    }
}

#[test]
fn rules_without_a_number_of_the_manual() {
    let cases: &[(Fault, &str, &str)] = &[
        // Table 3-1-3-1: values beyond what an address holds.
        (Fault::WordOutOfRange, "G0 X1\nX100000\nM30", "X100000"),
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

#[test]
fn forbidden_areas_are_judged_by_the_way_of_the_tool() {
    let limit = |row: &str| format!("{RADIUS}\n{row}");
    let zone = "G12 X60 Y10 Z10 I20 J3 K-10\n";
    let after_g13 = format!("{zone}G41 D1 G1 X10 F100\nX50\nG13\nX70\nG40 Y-20\nM30");
    for (program, row, expected) in [
        // Part 2, 2.5.2: the tool of radius 5 comes to Y45, beyond the upper limit of the second axis.
        ("G1 G41 D1 X0 Y0 F500\nY40\nX40\nM30", "P69 = 42", Some((503, "Y40"))),
        ("G1 G41 D1 X0 Y0 F500\nY40\nX40\nM30", "P69 = 45", None),
        // It turns off inside the corner at X35, short of X40.
        ("G0 X-20 Y20\nG1 G41 D1 X0 Y0 F100\nX40\nY40\nX0\nG40 Y20\nM30", "P67 = 37", None),
        ("G0 X-20 Y20\nG1 G41 D1 X0 Y0 F100\nX40\nY40\nX0\nG40 Y20\nM30", "P67 = 34", Some((501, "X40"))),
        // A rounded corner does not come to its point.
        ("G1 X40 F100 ,R5\nX0 Y40\nM30", "P67 = 39", None),
        // 2.6: a move on Y0 with the tool on Y5, which G13 behind it does not allow.
        (&after_g13, "\"NO11.0\" = 0", Some((0, "X50"))),
    ] {
        let (_, alarm) = run(program, &limit(row));
        let found = alarm.as_ref().map(|a| (a.id.number().unwrap_or(0), at_fault(program, a).trim_end()));
        assert_eq!(found, expected, "{program}");
    }
}

#[test]
fn a_checker_goes_on_behind_a_forbidden_area() {
    let program = "G0 X1\nG0 X50\nG0 X2\nG0 X60\nM30\n";
    let options = ferrocut_interpreter::Options { keep_going: true, ..Default::default() };
    let setup = "[parameters]\nP67 = 40";
    let mut interpreter = common::interpreter(program.as_bytes(), setup, options).unwrap();
    let alarms = interpreter.by_ref().filter_map(Result::err);
    let lines: Vec<u32> = alarms.map(|alarm| alarm.span.line).collect();
    assert_eq!(lines, [2, 4]);
}
