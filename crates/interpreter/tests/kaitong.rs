//! The rules of the Kaitong control, with values worked out by hand from appendices 7 to 11 of its manual.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{at_fault, interpreter_of, lines_on, run_on, told_on};
use ferrocut_geometry::Position;
use ferrocut_interpreter::Options;
use ferrocut_interpreter::dialects::kaitong::DIALECT;
use ferrocut_machine::{AlarmId, Fault};

/// Program, set-up, the steps that it makes.
type Case = (&'static str, &'static str, &'static [&'static str]);

fn hold(cases: &[Case]) {
    for (program, setup, expected) in cases {
        assert_eq!(lines_on(&DIALECT, program, setup), *expected, "{program}");
    }
}

#[test]
fn holes_lie_at_equal_distances_on_a_line() {
    hold(&[
        // 1.7: the present place is no hole; in G91 X Y is the whole way, here in three holes.
        (
            "G91 G99 G81 X30 Y-6 R-8 Z-3 F50 L3\nM30",
            "[start]\nz = 10.0",
            &[
                "rapid X10 Y-2",
                "rapid Z2",
                "feed Z-1 F50",
                "rapid Z2",
                "rapid X20 Y-4",
                "feed Z-1 F50",
                "rapid Z2",
                "rapid X30 Y-6",
                "feed Z-1 F50",
                "rapid Z2",
                "end M30",
            ],
        ),
        // L counts for its block; L0 keeps the data and cuts nothing.
        ("G99 G81 X10 R0 Z-1 F50 L0\nY5\nM30", "", &["rapid Y5", "feed Z-1 F50", "rapid Z0", "end M30"]),
        // Polar words name the last place, at (0, 20); the line to it is straight. The second hole is
        // half way to the next one, at 20 mm and 180 degrees.
        (
            "G16 G99 G81 X20 Y90 R0 Z-1 F50\nG91 Y90 L2\nM30",
            "",
            &[
                "rapid Y20",
                "feed Z-1 F50",
                "rapid Z0",
                "rapid X-10 Y10",
                "feed Z-1 F50",
                "rapid Z0",
                "rapid X-20 Y0",
                "feed Z-1 F50",
                "rapid Z0",
                "end M30",
            ],
        ),
        // 2.10: without a place L is how often the hole is bored.
        (
            "S300 M3\nG87 R-5 Z-2 Q1 F60 L2\nM30",
            "",
            &[
                "spindle cw 300",
                "orient 0",
                "rapid X1",
                "rapid Z-5",
                "rapid X0",
                "spindle cw 300",
                "feed Z-2 F60",
                "orient 0",
                "rapid X1",
                "rapid Z0",
                "rapid X0",
                "spindle cw 300",
                "orient 0",
                "rapid X1",
                "rapid Z-5",
                "rapid X0",
                "spindle cw 300",
                "feed Z-2 F60",
                "orient 0",
                "rapid X1",
                "rapid Z0",
                "rapid X0",
                "spindle cw 300",
                "spindle off",
                "end M30",
            ],
        ),
    ]);
}

#[test]
fn a_thread_has_a_pitch_of_its_own() {
    hold(&[
        // 2.2 note 1: the pitch outlives G80 and holds for both cycles; a feed is another thing.
        (
            "S200\nG99 G84 X1 R0 Z-2 F1.5\nG80 F300\nG1 X2\nG74 X3 R0 Z-2 P100\nM30",
            "",
            &[
                "rapid X1",
                "spindle cw 200",
                "tap 1.5 at 200 Z-2",
                "tap 1.5 at 200 Z0",
                "feed X2 F300",
                "rapid X3",
                "spindle ccw 200",
                "tap -1.5 at 200 Z-2",
                "dwell 0.1s",
                "tap -1.5 at 200 Z0",
                "dwell 0.1s",
                "spindle off",
                "end M30",
            ],
        ),
        // I: 25.4 / 20 = 1.27, kept for the next hole. F is in mm also with G20.
        (
            "S200 M3\nG20 G99 G84 X1 R0 Z-1 I20\nX2\nF1.27 X3\nM30",
            "",
            &[
                "spindle cw 200",
                "rapid X25.4",
                "tap 1.27 at 200 Z-25.4",
                "tap 1.27 at 200 Z0",
                "rapid X50.8",
                "tap 1.27 at 200 Z-25.4",
                "tap 1.27 at 200 Z0",
                "rapid X76.2",
                "tap 1.27 at 200 Z-25.4",
                "tap 1.27 at 200 Z0",
                "spindle off",
                "end M30",
            ],
        ),
        // Q is kept, and not of use in tapping.
        (
            "S200 M3\nG99 G84 R0 Z-2 Q1 F1\nG73 X1 F60\nM30",
            "[parameters]\nP230 = 500",
            &[
                "spindle cw 200",
                "tap 1 at 200 Z-2",
                "tap 1 at 200 Z0",
                "rapid X1",
                "feed Z-1 F60",
                "rapid Z-0.5",
                "feed Z-2 F60",
                "rapid Z0",
                "spindle off",
                "end M30",
            ],
        ),
    ]);
}

#[test]
fn borings_leave_with_the_spindle_clockwise() {
    hold(&[
        // 2.3: no Q is 0.1 mm; P018.5 chooses Y, P018.4 the negative direction.
        (
            "S300 M4\nG76 R0 Z-2 F60\nM30",
            "[parameters]\n\"P018.4\" = 1\n\"P018.5\" = 1",
            &[
                "spindle ccw 300",
                "feed Z-2 F60",
                "orient 0",
                "rapid Y-0.1",
                "rapid Z0",
                "rapid Y0",
                "spindle cw 300",
                "spindle off",
                "end M30",
            ],
        ),
        // 2.11, with a negative Q, which G88 only keeps for G76.
        (
            "S300\nG98 G88 R-1 Z-2 Q-0.5 P50 F60\nG76 X5\nM30",
            "",
            &[
                "rapid Z-1",
                "feed Z-2 F60",
                "dwell 0.05s",
                "stop M00",
                "rapid Z0",
                "spindle cw 300",
                "rapid X5",
                "rapid Z-1",
                "feed Z-2 F60",
                "dwell 0.05s",
                "orient 0",
                "rapid X5.5",
                "rapid Z0",
                "rapid X5",
                "spindle cw 300",
                "spindle off",
                "end M30",
            ],
        ),
    ]);
}

#[test]
fn tool_length_belongs_to_the_axis_square_to_the_plane() {
    let offsets = "[tools.1]\nlength = 3.0\n[tools.2]\nlength = -2.0";
    hold(&[
        // Appendix 8, 1.1.4: H00 takes the offset off the axis of its plane only, at once.
        (
            "G43 H1\nG19 H2\nH0\nG17 G44 H1\nH0\nM30",
            offsets,
            &["rapid Z3", "rapid X-2", "rapid X0", "rapid Z-3", "rapid Z0", "end M30"],
        ),
        // Note 2: the block that starts the cycle may have it; the tool comes back to where it was.
        (
            "G0 Z20\nG98 G43 H1 G81 X5 R1 Z-4 F50\nX9\nM30",
            offsets,
            &[
                "rapid Z20",
                "rapid X5",
                "rapid Z4",
                "feed Z-1 F50",
                "rapid Z20",
                "rapid X9",
                "rapid Z4",
                "feed Z-1 F50",
                "rapid Z20",
                "end M30",
            ],
        ),
        // In the cycle it is left aside, G49 and H too; G80 and G00 end the cycle before their own block.
        (
            "G43 H1\nG99 G81 X5 R1 Z-4 F50\nG49 X6\nH2 X7\nG80 G44 H2\nG49 G0 Z8\nM30",
            offsets,
            &[
                "rapid Z3",
                "rapid X5",
                "rapid Z4",
                "feed Z-1 F50",
                "rapid Z4",
                "rapid X6",
                "feed Z-1 F50",
                "rapid Z4",
                "rapid X7",
                "feed Z-1 F50",
                "rapid Z4",
                // G44 with -2 adds 2 instead of 3.
                "rapid Z3",
                "rapid Z8",
                "end M30",
            ],
        ),
    ]);
}

/// Fanuc 0i-M: I, J and K in up to ten sets; of #7 as D and as the second I the later one stands.
#[test]
fn a_macro_takes_centres_in_sets() {
    let called = |words: &str, variables: &str| format!("G65 P9 {words}\nM30\nO9\nG0 {variables}\nM99");
    let cases: [(&str, &str, &[&str]); 4] = [
        (
            "A1 I2 J3 K4 I5 K6 J7",
            "X#4 Y#5 Z#6\nX#7 Y#11 Z#9",
            &["rapid X2 Y3 Z4", "rapid X5 Y7 Z6", "end M30"],
        ),
        ("J1 I2", "X#5 Y#7", &["rapid X1 Y2", "end M30"]),
        ("I1 I2 D3", "X#4 Y#7", &["rapid X1 Y3", "end M30"]),
        ("I1I1I1I1I1I1I1I1I1I1", "X#31", &["rapid X1", "end M30"]),
    ];
    for (words, variables, expected) in cases {
        assert_eq!(lines_on(&DIALECT, &called(words, variables), ""), expected, "{words}");
    }
    let (_, alarm) = run_on(&DIALECT, &called(&"I1".repeat(11), "X1"), "");
    assert_eq!(alarm.map(|alarm| alarm.fault), Some(Fault::ArgumentAddress));
}

/// Appendix 8, note 2: what a cycle leaves aside is told.
#[test]
fn a_check_tells_of_a_tool_length_that_a_cycle_leaves_as_it_is() {
    let program = "G99 G43 H1 G81 X5 R1 Z-4 F50\nG43 H2\nX6 H2\nX7 G49\nX8\nG80 G49\nG43 H2\nM30";
    let told = told_on(&DIALECT, program, "[tools.2]\nlength = 5.0").into_iter();
    let told: Vec<_> = told.map(|a| (a.fault, a.span.line, at_fault(program, &a).to_owned())).collect();
    let of = |line, word: &str| (Fault::LengthInCycle, line, word.to_owned());
    assert_eq!(told, [of(2, "G43"), of(3, "H2"), of(4, "G49")]);
}

#[test]
fn polar_coordinates_keep_the_pole_of_g16() {
    hold(&[
        // Appendix 9, 1.1: the pole is the zero of the local system of G52.
        (
            "G52 X10 Y5\nG16 G0 X20 Y90\nG15\nG52 X0 Y0\nX1 Y1\nM30",
            "[work_offsets]\nG54 = { x = 100.0 }",
            &["rapid X110 Y25", "rapid X101 Y1", "end M30"],
        ),
        // G91: radius and angle grow; the order of G16 and G91 in the block says nothing.
        (
            "G0 X10\nG16 G91\nX5 Y90\nX5 Y-90\nG90 X-4\nM30",
            "",
            &["rapid X10", "rapid Y5", "rapid X20 Y0", "rapid X14", "end M30"],
        ),
        // They grow from where the tool is, also behind a move that is not polar: 90 + 30 degrees, then 60 + 10 mm.
        (
            "G90 G16 G00 X50 Y30\nG53 X0 Y10\nG91 Y30\nG90 G53 X60 Y0\nG91 X10\nM30",
            "",
            &[
                "rapid X43.3013 Y25",
                "rapid X0 Y10",
                "rapid X-25 Y43.3013",
                "rapid X60 Y0",
                "rapid X-35 Y60.6218",
                "end M30",
            ],
        ),
        // In G19 the first axis is Y, the second Z.
        ("G19 G16\nG1 Y10 Z30 X7 F100\nM30", "", &["feed X7 Y8.6603 Z5 F100", "end M30"]),
        // Begun again, they may be in another plane; a plane alone is refused.
        ("G17 G16\nG90 G19 G16\nG0 Y20 Z90\nG15\nM30", "", &["rapid Z20", "end M30"]),
        // Arcs by their centre are taken; the centre is no polar word. G28 is none either (Fanuc).
        (
            "G0 X10\nG16 G3 Y90 I-10 F100\nG28 X5 Y5\nM30",
            "",
            &["rapid X10", "xy X0 Y10 about 0 0 by 90 F100", "rapid X5 Y5", "rapid X0 Y0", "home", "end M30"],
        ),
        // Polar words first, then the rotation: 30 + 60 degrees.
        ("G68 X0 Y0 R60\nG16 G0 X20 Y30\nM30", "", &["rapid Y20", "end M30"]),
    ]);
}

/// Behind G68 the tool is not on the turned shape yet. What names no axis of the plane moves none of it (Fanuc); the next point is
/// one of the turned shape.
#[test]
fn a_plunge_behind_g68_goes_straight_down() {
    hold(&[
        (
            "G90 G0 X10 Y0 Z20\nG68 X0 Y0 R90\nM8\nG1 Z-5 F100\nX5 Y0\nM30",
            "",
            &["rapid X10 Z20", "coolant on", "feed Z-5 F100", "feed X0 Y5 F100", "coolant off", "end M30"],
        ),
        (
            "G0 X10 Z20\nG68 X0 Y0 R90\nG91 Z-5\nG90 X5 Y0\nM30",
            "",
            &["rapid X10 Z20", "rapid Z15", "rapid X0 Y5", "end M30"],
        ),
        (
            "G0 X10 Z20\nG68 X0 Y0 R90\nG43 H1\nM30",
            "[tools.1]\nlength = 4",
            &["rapid X10 Z20", "rapid Z24", "end M30"],
        ),
        (
            "G0 X10 Z20\nG43 H1\nG68 X0 Y0 R90\nG49\nM30",
            "[tools.1]\nlength = 4",
            &["rapid X10 Z20", "rapid Z24", "rapid Z20", "end M30"],
        ),
        (
            "G0 X10 Z20\nG68 X0 Y0 R90\nM3 S100\nG99 G81 R2 Z-5 F50\nG80\nM30",
            "",
            &[
                "rapid X10 Z20",
                "spindle cw 100",
                "rapid Z2",
                "feed Z-5 F50",
                "rapid Z2",
                "spindle off",
                "end M30",
            ],
        ),
    ]);
}

#[test]
fn a_rotation_is_replaced_or_added_to() {
    hold(&[
        // Appendix 10 with P24.0 off: R is absolute also in G91.
        ("G91 G68 X0 Y0 R60\nG68 X0 Y0 R30\nG90 G0 X10 Y0\nM30", "", &["rapid X8.6603 Y5", "end M30"]),
        // In G18 the axes are Z and X: (Z10, X0) turned by 90 degrees is X10.
        ("G18 G68 Z0 X0 R90\nG0 Z10 X0\nM30", "", &["rapid X10", "end M30"]),
        // G69 goes before the codes that a rotation does not allow.
        (
            "G68 X0 Y0 R90\nG0 X5 Y0\nG55 G69 X0\nM30",
            "[work_offsets]\nG55 = { x = 3.0 }",
            &["rapid Y5", "rapid X3", "end M30"],
        ),
        // Fanuc: one `/`, G20 and G31 are no alarms while points are turned.
        (
            "G68 X0 Y0 R90\n/G0 X1 Y0\nG20\nG21\nG31 X2 Y0 F50\nM30",
            "",
            &["rapid Y1", "skip Y2 F50", "Barrier", "end M30"],
        ),
    ]);
}

/// The rule, the program that breaks it, and the words at fault.
const FAULTS: &[(Fault, &str, &str)] = &[
    // Appendix 7, 2.2.
    (Fault::TappingPitchMissing, "S100 M3\nG84 R0 Z-1\nM30", "G84"),
    (Fault::TappingPitchTwice, "S100 M3\nG84 R0 Z-1 F1 I20\nM30", "I20"),
    (Fault::WordOutOfRange, "S100 M3\nG84 R0 Z-1 F500.1\nM30", "F500.1"),
    (Fault::WordOutOfRange, "S100 M3\nG74 R0 Z-1 F0\nM30", "F0"),
    (Fault::WordOutOfRange, "S100 M3\nG74 R0 Z-1 I0.05\nM30", "I0.05"),
    (Fault::WordOutOfRange, "S100 M3\nG74 R0 Z-1 I25401\nM30", "I25401"),
    (Fault::TappingSpeed, "G84 R0 Z-1 F1\nM30", "G84"),
    // The pitch is no feed.
    (Fault::NoFeed, "S100 M3\nG84 R0 Z-1 F1\nG81 X1\nM30", "G81 X1"),
    (Fault::NoFeed, "G81 R0 Z-1\nM30", "G81 R0 Z-1"),
    (Fault::CycleDepthAboveR, "G81 R0 Z1 F50\nM30", "Z1"),
    (Fault::CycleDepthBelowR, "S100 M3\nG87 R0 Z-1 F50\nM30", "Z-1"),
    // 1.1: the cycles drill along Z.
    (Fault::CyclePlane, "G18 G81 R0 Z-1 F50\nM30", "G81"),
    (Fault::PlaneInCycle, "G81 R0 Z-1 F50\nG18\nM30", "G18"),
    // Appendix 8, note 1.
    (Fault::LengthInArc, "G49 G2 X10 I5 F100\nM30", "G2"),
    (Fault::LengthInArc, "G44 H1 G3 X10 I5 F100\nM30", "G3"),
    (Fault::LengthWithCode, "G43 H1 G4 P100\nM30", "G4"),
    (Fault::LengthWithCode, "G43 H1 G31 X10 F100\nM30", "G31"),
    (Fault::LengthWithCode, "G43 H1\nG31 H0 X10 F100\nM30", "G31"),
    (Fault::LengthWithCode, "G43 H1 G142\nM30", "G142"),
    (Fault::LengthWithCode, "G49 G143\nM30", "G143"),
    (Fault::LengthWithCoordinateSet, "G43 H1 G92 X10\nM30", "G92"),
    (Fault::NotSupported, "G142 X1\nM30", "G142"),
    // 1.1.3: H01 to H24, ±9999.999 mm.
    (Fault::OffsetNumber, "G43 H25\nM30", "H25"),
    (Fault::OffsetTooLarge, "G43 H3\nM30", "H3"),
    // Appendix 10, limits.
    (Fault::WordOutOfRange, "G68 X0 Y0 R360.001\nM30", "R360.001"),
    (Fault::WordOutOfRange, "G68 X0 Y0 R-361\nM30", "R-361"),
    (Fault::PlaneInRotation, "G68 X0 Y0 R30\nG18\nM30", "G18"),
    (Fault::CodeInRotation, "G68 X0 Y0 R30\nG28 X0\nM30", "G28"),
    (Fault::CodeInRotation, "G68 X0 Y0 R30\nG92 X0\nM30", "G92"),
    (Fault::CodeInRotation, "G68 X0 Y0 R30\nG52 X1\nM30", "G52"),
    (Fault::CodeInRotation, "G68 X0 Y0 R30\nG59\nM30", "G59"),
    // What the control does not have.
    (Fault::UnknownGCode, "G51 X0 Y0 P2\nM30", "G51"),
    (Fault::UnknownMCode, "M1000\nM30", "M1000"),
    (Fault::UnknownVariable, "#34=1\nM30", "#34=1"),
];

#[test]
fn alarms_have_numbers_of_ferrocut_and_point_at_the_words() {
    let setup = "[tools.1]\nlength = 3.0\n[tools.3]\nlength = 10000.0";
    for (fault, program, words) in FAULTS {
        let (_, alarm) = run_on(&DIALECT, program, setup);
        let alarm = alarm.unwrap_or_else(|| panic!("{program}: no alarm"));
        let found = (alarm.fault, alarm.id, at_fault(program, &alarm).trim_end());
        assert_eq!(found, (*fault, AlarmId::Core(*fault), *words), "{program}");
    }
}

#[test]
fn an_alarm_of_the_program_says_its_number() {
    let (_, alarm) = run_on(&DIALECT, "#3000=12\nM30", "");
    let alarm = alarm.unwrap();
    assert_eq!(alarm.id, AlarmId::Core(Fault::ProgramAlarm));
    assert_eq!(alarm.arguments.as_slice(), [("detail", "12".into())]);
}

#[test]
fn a_reset_ends_polar_coordinates_and_the_cycle() {
    let program = "G99 G16 G81 X10 Y90 R0 Z-1 F50\nG4 P10\nX1 Y1\nM30";
    let mut interpreter = interpreter_of(&DIALECT, program.as_bytes(), "", Options::default()).unwrap();
    let at = interpreter.by_ref().filter_map(Result::ok).find_map(|step| step.op.target().copied());
    assert_eq!(at, Some(Position::xyz(0.0, 10.0, 0.0)));
    interpreter.reset(Position::ZERO);
    let codes: Vec<u16> = interpreter.codes_in_force().collect();
    assert!(codes.contains(&150) && codes.contains(&800) && codes.contains(&990), "{codes:?}");
}

#[test]
fn p021_5_chooses_the_level_of_return_at_power_on() {
    for (setup, code) in [("", 980), ("[parameters]\n\"P021.5\" = 1", 990)] {
        let interpreter = interpreter_of(&DIALECT, b"M30", setup, Options::default()).unwrap();
        assert!(interpreter.codes_in_force().any(|tenths| tenths == code), "{setup}");
    }
}

#[test]
fn what_follows_a_semicolon_is_a_remark() {
    // Appendices 8 to 10, examples.
    hold(&[("G90 G0 X1; abc ( Z5\nY2 ；说明\nM30", "", &["rapid X1", "rapid Y2", "end M30"])]);
}

#[test]
fn tool_length_ends_at_once_beside_other_codes() {
    // Appendix 8, 1.1.4.
    let setup = "[tools.1]\nlength = 4";
    hold(&[
        (
            "G90 G0 G43 H1 Z10\nG53 G49 Z0\nX10\nM30",
            setup,
            &["rapid Z14", "rapid Z0", "rapid X10", "end M30"],
        ),
        (
            "G90 G0 G43 H1 Z10\nG49 G68 X0 Y0 R90\nX10 Y0\nZ5\nM30",
            setup,
            &["rapid Z14", "rapid Z10", "rapid Y10", "rapid Z5", "end M30"],
        ),
        // An arc in force from a block before is no obstacle.
        (
            "G90 G0 G43 H1 Z5\nG1 X5 F100\nG2 X10 R5\nG49\nM30",
            setup,
            &["rapid Z9", "feed X5 F100", "xy X10 about 7.5 -4.3301 by -60 F100", "feed Z5 F100", "end M30"],
        ),
    ]);
}

#[test]
fn g92_moves_every_system() {
    // Fanuc: until the next G92; the call of a system does not end it.
    hold(&[
        ("G92 X10\nG55 G90 G0 X0\nM30", "", &["rapid X-10", "end M30"]),
        (
            "G92 X10\nG0 X0\nG52 X1\nX0\nG52 X0\nG54 X0\nM30",
            "",
            &["rapid X-10", "rapid X-9", "rapid X-10", "end M30"],
        ),
    ]);
}

#[test]
fn a_second_rotation_is_about_where_the_tool_is() {
    // Appendix 10: without a centre.
    hold(&[(
        "G90 G0 X3 Y4\nG68 X10 Y4 R30\nX20 Y4\nG68 R60\nX20 Y4\nM30",
        "",
        &["rapid X3 Y4", "rapid X18.6603 Y9", "rapid X23.6603 Y7.6603", "end M30"],
    )]);
}

#[test]
fn other_m_codes_and_a_skip_without_signal() {
    hold(&[("M10\nM30", "", &["M10", "end M30"])]);
    let program = "G31 X10 F100\nM30\n";
    let fault = |setup| run_on(&DIALECT, program, setup).1.map(|alarm| alarm.fault);
    assert_eq!(fault(""), None);
    assert_eq!(fault("[parameters]\n\"P021.3\" = 1"), Some(Fault::SkipWithoutSignal));
}

/// P of M99 is the block where the caller goes on, in the main program the next one (Fanuc 0i-M).
#[test]
fn a_return_names_a_block() {
    let returns = "G90 X1\nM98 P7\nX9\nN4 Y2\nM30\nO7\nZ5\nM99 P4";
    let cases: &[Case] = &[
        (returns, "", &["rapid X1", "rapid Z5", "rapid Y2", "end M30"]),
        // It is no dwell of a cycle in force.
        (
            "G99 G82 X1 R0 Z-1 F50\nM98 P7\nN4 X2\nM30\nO7\nM99 P4",
            "",
            &["rapid X1", "feed Z-1 F50", "rapid Z0", "rapid X2", "feed Z-1 F50", "rapid Z0", "end M30"],
        ),
        // Further down it leads on, whatever the program ends with.
        ("X1\nM99 P4\nX9\nN4 Y2\nM99", "", &["rapid X1", "rapid Y2", "end M99"]),
        ("X1\nM99 P4\nX9\nN4 Y2\nM30", "", &["rapid X1", "rapid Y2", "end M30"]),
        // Further up it goes on as long as that leads to an end, and a pass is not like the one before.
        (
            "N1 #1=0\nN2 #1=#1+1\nX#1\nIF[#1EQ3]GOTO9\nM99 P2\nN9 M30",
            "",
            &["rapid X1", "rapid X2", "rapid X3", "end M30"],
        ),
        // So does one that leads to M99 alone.
        (
            "#1=0\nN2 #1=#1+1\nX#1\nIF[#1EQ3]GOTO9\nM99 P2\nN9 Y1\nM99",
            "",
            &["rapid X1", "rapid X2", "rapid X3", "rapid Y1", "end M99"],
        ),
        // Else it is one pass, whether each is like the one before or not.
        ("X1\nN2 Y1\nY2\nM99 P2", "", &["rapid X1", "rapid Y1", "rapid Y2", "end M99"]),
        ("N1 G91 X1\nM99 P1", "", &["rapid X1", "end M99"]),
        ("N1 #1=#1+1\nX1\nM99 P1", "", &["rapid X1", "end M99"]),
    ];
    hold(cases);
    let (_, alarm) = run_on(&DIALECT, "X1\nM99 P7", "");
    assert_eq!(alarm.map(|alarm| alarm.fault), Some(Fault::SequenceMissing));
    // A check looks further: at what such a jump leads to, and behind the call of one that leads nowhere.
    let told = |program: &str| {
        told_on(&DIALECT, program, "").iter().map(|a| (a.span.line, a.fault)).collect::<Vec<_>>()
    };
    let passes = "O1\n#1=0\nN2 #1=#1+1\nG91 G0 X1\nIF[#1 GE 3] GOTO 9\nM99 P2\nN9 G90 G0 X5\nG777\nM99";
    assert_eq!(told(passes), [(8, Fault::UnknownGCode)]);
    assert_eq!(told(&passes.replace("M99 P2", "GOTO 2")), [(8, Fault::UnknownGCode)]);
    assert_eq!(told("X1\nM99 P7"), [(2, Fault::SequenceMissing)]);
    let nowhere = "M98 P7\nG777\nM30\nO7\nX1\nM99 P5";
    assert_eq!(told(nowhere), [(6, Fault::SequenceMissing), (2, Fault::UnknownGCode)]);
    // Where another code of the block has P, or the cycle in force, it is no block.
    for block in ["G4 P500 M99", "G30 P2 Z0 M99", "G82 X5 R0 Z-1 F50 P2000 M99"] {
        assert_eq!(told(&format!("M98 P7\nM30\nO7\n{block}")), [], "{block}");
    }
    assert_eq!(told("G82 X1 R0 Z-1 F50\nM98 P7\nM30\nO7\nX5 P2000 M99"), []);
}
