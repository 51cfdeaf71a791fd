//! The rules of the Weihong control, with values worked out by hand from its manual.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{at_fault, interpreter_of, lines_on, run_on, told_on};
use ferrocut_geometry::{Axis, Position};
use ferrocut_interpreter::dialects::weihong::DIALECT;
use ferrocut_interpreter::{Interpreter, Options, Unreferenced};
use ferrocut_machine::{Catalogue, Fault, Language, Severity};
use ferrocut_toolpath::{Op, PathMode};

/// Program, set-up, the steps that it makes.
type Case = (&'static str, &'static str, &'static [&'static str]);

/// Line, fault, words.
type Told = (u32, Fault, &'static str);

/// What a check tells: line, fault, words.
fn told(program: &str, setup: &str) -> Vec<(u32, Fault, String)> {
    let alarms = told_on(&DIALECT, program, setup);
    alarms.iter().map(|a| (a.span.line, a.fault, at_fault(program, a).to_owned())).collect()
}

fn hold(cases: &[Case]) {
    for (program, setup, expected) in cases {
        let mut found = lines_on(&DIALECT, program, setup);
        found.retain(|line| line != "Barrier");
        assert_eq!(found, *expected, "{program}");
    }
}

#[test]
fn words_take_expressions_and_radians() {
    hold(&[
        // 4.5: equal ranks from the left, comparisons above the logical ones, whole numbers downwards.
        ("G90 X=1||0&&0 Y=int(-1.5) Z=7-2-1\nM30", "", &["rapid Z4", "rapid Y-2", "end M30"]),
        ("G90 G01 X=2*asin(1) Y=ctg(0.5) F=100+20\nM30", "", &["feed X3.1416 Y1.8305 F120", "end M30"]),
        // What was never set is 0; the index of a variable may be reckoned.
        ("#3=7\n#(1+1)=#9+5\nX=#2 Y=#(#2-2)\nM30", "", &["rapid X5 Y7", "end M30"]),
        ("N=1+2 X5\nM30", "", &["rapid X5", "end M30"]),
        // A blank ends an expression, and comments run to the end of the line, ends of blocks in them too.
        ("X=1+2 Y3;Z4 'X9; Y9\nM30", "", &["rapid X3 Y3", "rapid Z4", "end M30"]),
        (
            "X1 \u{2032}X2\nX3 \u{2019}\nX4;\u{2018}x\nX5 \u{ff07}\n\u{201e}X6\nM30",
            "",
            &["rapid X1", "rapid X3", "rapid X4", "rapid X5", "end M30"],
        ),
    ]);
    let gb = b"X1 \xA1\xE4\xBF\xEC\xD2\xC6X2\r\nX3 '\xB6\xD4\xB5\xB6\r\nM30\r\n";
    let interpreter = interpreter_of(&DIALECT, gb, "", Options::default()).unwrap();
    assert_eq!(interpreter.filter_map(Result::ok).count(), 3);
}

#[test]
fn a_guard_rules_over_its_line() {
    hold(&[
        (
            "#1=4\nIF(#1>3&&!#2)X1\nIF(#1<3||#2)X2\nIF(#1==4)#5=7\nN9 IF(#5)G01 X=#5 F10\nM30",
            "",
            &["rapid X1", "feed X7 F10", "end M30"],
        ),
        // Nothing of a line left out is read: neither what it divides by, nor the place of the moment.
        ("IF(0)X=1/0\nIF(#1)X=#CURMACHPOS.X+1\nM30", "", &["end M30"]),
    ]);
}

#[test]
fn programs_are_called_by_number_and_name_and_share_variables() {
    hold(&[
        ("#1=2\nG65 P\"Step\" L=#1\nX=#1\nM30\nO\"STEP\"\n#1=#1+10\nM17", "", &["rapid X22", "end M30"]),
        ("G65 P9002 L2\nM30\nO\"9002\"\nG91 X1\nM99", "", &["rapid X1", "rapid X2", "end M30"]),
        // G90 and G91 beside the call are in force in it; no repeats is no call.
        ("G91 G65 P7 L2\nG65 P7 L0\nG65 P7 L-1\nM30\nO7\nX1\nM17", "", &["rapid X1", "rapid X2", "end M30"]),
        // Words beside it set variables as on Fanuc.
        ("M98 P8\nG65 P8 A4 X6\nM30\nO8\nX=#1 Y=#24\nM17", "", &["rapid X4 Y6", "end M30"]),
        ("G65 P8 H6\nM30\nO8\nX=#11\nM17", "", &["rapid X6", "end M30"]),
        // They are no numbers of offsets and tools there.
        (
            "G65 P8 H-8.5 D12.5 T2.5\nM30\nO8\nX=#11 Y=#7 Z=#20\nM17",
            "",
            &["rapid Z2.5", "rapid X-8.5 Y12.5", "end M30"],
        ),
        // P beside M99 that another code has is no block; L is no word of it.
        ("G4 P500 M99", "", &["dwell 0.5s", "end M99"]),
        ("N1 G65 P7\nX5\nM30\nO7\nG4 P500 M99", "", &["dwell 0.5s", "rapid X5", "end M30"]),
        // Its caller goes on at the block that P of M99 names, behind the last repeat.
        (
            "N1 G65 P7 L2\nX5\nN3 Y3\nM30\nO7\nG91 X1\nG90 M99 P3",
            "",
            &["rapid X1", "rapid X2", "rapid Y3", "end M30"],
        ),
        // M17 in the main program ends it, M30 in a subprogram too.
        ("X1\nM17\nX2", "", &["rapid X1", "end M17"]),
        ("G65 P1\nX9\nM30\nO1\nX1\nM30", "", &["rapid X1", "end M30"]),
    ]);
}

#[test]
fn positioning_moves_z_apart_and_has_a_speed_of_its_own() {
    hold(&[
        (
            "G28 X10 Z5\nM30",
            "[start]\nx = 20.0\nz = 3.0\n[work_offsets]\nG54 = { x = 1.0 }",
            &["rapid Z5", "rapid X11", "rapid X0", "rapid Z0", "home", "end M30"],
        ),
        ("G91 G28 X10\nM30", "[start]\nx = 20.0", &["rapid X30", "rapid X0", "home", "end M30"]),
        // Before its first F a cut has the default feed; F of G00 is none.
        (
            "G00 X1 F3000\nG01 X2\nF50\nX3\nM30",
            "[parameters]\nDEFAULT_FEED = 700",
            &["rapid X1", "feed X2 F700", "feed X3 F50", "end M30"],
        ),
        (
            "G53 G01 X1 Y2 F90\nG91 G53 G00 X1\nM30",
            "[work_offsets]\nG54 = { x = 5.0 }",
            &["feed X1 Y2 F90", "rapid X2", "end M30"],
        ),
    ]);
    let (steps, alarm) = run_on(&DIALECT, "X1\nF3000\nG00 X2 F2000\nX3\nX4 F1500\nG903 X5 F1200\nM30", "");
    assert_eq!(alarm, None);
    let speed = |op: &Op| if let Op::Rapid { speed, .. } = op { Some(*speed) } else { None };
    let speeds: Vec<_> = steps.iter().filter_map(|step| speed(&step.op)).collect();
    assert_eq!(speeds, [None, Some(2000.0), Some(2000.0), Some(1500.0), Some(1200.0)]);
    let (steps, _) = run_on(&DIALECT, "G903 G905 G01 X1 F100\nX2\nM30", "");
    let full = |at: usize| matches!(steps[at].op, Op::Feed { path: PathMode::FullFeed, .. });
    assert!(full(0) && !full(1));
}

#[test]
fn arcs_are_half_circles_where_r_is_short_and_helices_have_a_pitch() {
    hold(&[
        ("G02 X10 R-3 F200\nM30", "", &["xy X10 about 5 0 by -180 F200", "end M30"]),
        // Three full turns and a quarter, a little rounding of the pitch or not.
        (
            "X30\nG03 X0 Y30 R30 Z=13 K4 F100\nM30",
            "",
            &["rapid X30", "xy X0 Y30 Z13 about 0 0 by 1170 F100", "end M30"],
        ),
        // In other planes K is the centre.
        (
            "G18 G02 X0 Z10 I-10 K0 F50\nM30",
            "[start]\nx = 10.0",
            &["zx X0 Z10 about 0 0 by -90 F50", "end M30"],
        ),
        (
            "G02 X20 Y10 I10 J10 F300\nM30",
            "[start]\nx = 10.0\ny = 20.0\n[parameters]\nIJK_INCREMENTAL = 0",
            &["xy X20 Y10 about 10 10 by -90 F300", "end M30"],
        ),
    ]);
}

#[test]
fn coordinate_systems_move_for_good_alone_or_for_now() {
    let setup =
        "[start]\nx = 50.0\n[work_offsets]\nG54 = { x = 10.0 }\nG55 = { x = 100.0 }\nexternal = { x = 1.0 }";
    hold(&[
        // G92 goes before G00 and moves every system by as much: by 39.
        ("G92 G00 X0\nG55 X0\nM30", setup, &["rapid X140", "end M30"]),
        ("G921 X0\nG55 X0\nG54 X0\nM30", setup, &["rapid X101", "rapid X50", "end M30"]),
        ("G992 X0\nG55 X0\nM30", setup, &["rapid X140", "end M30"]),
        ("G992 I5\nG992 I5 J1\nX0 Y0\nM30", setup, &["rapid X21 Y1", "end M30"]),
        ("G922 X7 P0\nG922 X2 P-4\nG922 Y3\nX0 Y0\nM30", setup, &["rapid X9 Y3", "end M30"]),
        ("M802 P458752\nX0\nM30", setup, &["rapid X10", "end M30"]),
        // G54 takes no P of a call beside it.
        ("G55 G65 P9\nM30\nO9\nX0\nM17", setup, &["rapid X101", "end M30"]),
        // With G68 in force the place is named in turned coordinates.
        ("G68 X0 Y0 R90\nG92 X1 Y0\nX2 Y0\nM30", "[start]\nx = 5.0", &["rapid Y1", "end M30"]),
    ]);
}

#[test]
fn transformations_nest() {
    hold(&[
        // The manual's G51 example as it stands: an axis that is not named stays where it is.
        (
            "G00 X50 Y50\nG51 X100 Y80 P0.5\nG01 Y150 F1000\nX175 Y50\nG50\nG00 X0 Y0\nM30",
            "",
            &["rapid X50 Y50", "feed Y115 F1000", "feed X137.5 Y65 F1000", "rapid X0 Y0", "end M30"],
        ),
        // G91 counts from the real place: 10 programmed are 20.
        ("G51 X0 Y0 P2\nG91 X10\nG50\nX10\nM30", "", &["rapid X20", "rapid X30", "end M30"]),
        // G69 takes the latest rotation back, whatever stands between; without a centre it is here.
        (
            "G68 R90\nG51 X0 Y0 P2\nG91 X10\nG69\nX10\nG50\nX1\nM30",
            "",
            &["rapid Y20", "rapid X20", "rapid X21", "end M30"],
        ),
        // A mirror moves where it is given again, and goes for the axes named; arcs turn the other way.
        (
            "G51.1 X10\nG51.1 X0\nX4 Y2\nG50.1 Y0\nX3\nG50.1\nX3\nM30",
            "",
            &["rapid X-4 Y2", "rapid X-3", "rapid X3", "end M30"],
        ),
        ("G51.1 X0 Y0\nG02 X10 Y10 R10 F50\nM30", "", &["xy X-10 Y-10 about -10 0 by -90 F50", "end M30"]),
        (
            "G68 X0 Y0 R90\nG01 X10 F60\nG02 X0 Y10 I-10 J0\nM30",
            "",
            &["feed Y10 F60", "xy X-10 Y0 about 0 0 by -270 F60", "end M30"],
        ),
    ]);
}

#[test]
fn cycles_follow_the_steps_of_the_manual() {
    hold(&[
        // L counts where K is missing; a plane is no matter.
        (
            "G18 G91 G99 G81 X5 R-3 Z-2 F80 L2\nM30",
            "[start]\nz = 10.0",
            &[
                "rapid X5",
                "rapid Z7",
                "feed Z5 F80",
                "rapid Z7",
                "rapid X10",
                "feed Z5 F80",
                "rapid Z7",
                "end M30",
            ],
        ),
        // A cycle without X and Y drills where it stands.
        (
            "G98 G82 R2 Z-1 P250 F60\nM30",
            "[start]\nz = 5.0",
            &["rapid Z2", "feed Z-1 F60", "dwell 0.25s", "rapid Z5", "end M30"],
        ),
        (
            "M03 S500\nG99 G88 X1 R2 Z-1 P100 F60\nM30",
            "[start]\nz = 5.0",
            &[
                "spindle cw 500",
                "rapid X1",
                "rapid Z2",
                "feed Z-1 F60",
                "dwell 0.1s",
                "spindle off",
                "feed Z2 F60",
                "spindle cw 500",
                "end M30",
            ],
        ),
        (
            "M03 S500\nG98 G76 X9 R2 Z-1 Q0.5 F60\nM30",
            "[start]\nz = 5.0\n[parameters]\nFIXEDCYCLE_OSS = 3",
            &[
                "spindle cw 500",
                "rapid X9",
                "rapid Z2",
                "feed Z-1 F60",
                "orient 0",
                "rapid Y0.5",
                "rapid Z5",
                "rapid Y0",
                "spindle cw 500",
                "end M30",
            ],
        ),
        // The spindle turns again before the tool is moved back (4.3, G87, step 8).
        (
            "M04 S100\nG98 G87 X5 R-20 Z-10 Q3 F100\nM30",
            "[start]\nz = 10.0",
            &[
                "spindle ccw 100",
                "rapid X5",
                "orient 0",
                "rapid X2",
                "rapid Z-20",
                "rapid X5",
                "spindle cw 100",
                "feed Z-10 F100",
                "orient 0",
                "rapid X2",
                "rapid Z10",
                "spindle cw 100",
                "rapid X5",
                "end M30",
            ],
        ),
        // A depth that was given from R goes with a new R.
        (
            "G91 G98 G81 X5 Z-6 R-8 F100\nR-6 X5\nM30",
            "[start]\nz = 10.0",
            &[
                "rapid X5",
                "rapid Z2",
                "feed Z-4 F100",
                "rapid Z10",
                "rapid X10",
                "rapid Z4",
                "feed Z-2 F100",
                "rapid Z10",
                "end M30",
            ],
        ),
        // P decides over the dwell, whatever else stands there (4.3, G04).
        ("G04 X3 P100\nG04 P50 X1\nM30", "", &["dwell 0.1s", "dwell 0.05s", "end M30"]),
        (
            "M04 S300\nG99 G74 X1 R2 Z-1 P0 F240\nM30",
            "[start]\nz = 5.0",
            &[
                "spindle ccw 300",
                "rapid X1",
                "rapid Z2",
                "feed Z-1 F240",
                "spindle cw 300",
                "feed Z2 F240",
                "spindle ccw 300",
                "end M30",
            ],
        ),
    ]);
}

#[test]
fn figures_of_holes_stand_where_their_words_say() {
    hold(&[
        // Counter-clockwise with K below 0; G91 moves the centre, the next hole is by itself.
        (
            "G91 X10\nG99 G81 R0 Z-1 F9 K0\nG34 X10 I5 J0 K-2\nX1\nM30",
            "",
            &[
                "rapid X10",
                "rapid X25",
                "feed Z-1 F9",
                "rapid Z0",
                "rapid X15",
                "feed Z-1 F9",
                "rapid Z0",
                "rapid X16",
                "feed Z-1 F9",
                "rapid Z0",
                "end M30",
            ],
        ),
        // A negative distance goes the other way.
        (
            "G99 G81 R0 Z-1 F9 K0\nG35 X0 Y0 I-10 J90 K2\nM30",
            "",
            &["feed Z-1 F9", "rapid Z0", "rapid Y-10", "feed Z-1 F9", "rapid Z0", "end M30"],
        ),
        // P of the figure is an angle and no pause.
        (
            "G99 G82 R0 Z-1 P100 F9 K0\nG36 X0 Y0 I10 J0 P-90 K2\nM30",
            "",
            &[
                "rapid X10",
                "feed Z-1 F9",
                "dwell 0.1s",
                "rapid Z0",
                "rapid X0 Y10",
                "feed Z-1 F9",
                "dwell 0.1s",
                "rapid Z0",
                "end M30",
            ],
        ),
    ]);
}

#[test]
fn inputs_and_outputs() {
    hold(&[
        (
            "M901 PLC[04] LEVEL1\nM901 H2 P1\nX=#OUTPORTMAP\nM901 PLC=1+1 LEVEL0\nX=#OUTPORTMAP\nM30",
            "",
            &["out 04 1", "out 2 1", "rapid X20", "out 2 0", "rapid X16", "end M30"],
        ),
        (
            "M801 MSG\"|D|wait\"\nM801 \u{201c}Hello\u{201d}\nM801\nM30",
            "",
            &["message |D|wait", "message Hello", "end M30"],
        ),
        // 4.4: it brings to rest, and then comes what else the block has, whichever of them stands first.
        (
            "G906 G01 X5 F60\nG65 P1 G906\nG921 X0 G906\nX1\nG906 PLC[7] LEVEL1 P20 G4 X2\nM30\nO1\nY3\nM17",
            "",
            &["feed X5 F60", "feed Y3 F60", "feed X6 F60", "wait 7 1 0.02s", "dwell 2s", "end M30"],
        ),
        (
            "G906 G81 X1 R2 Z0 F9\nM30",
            "[start]\nz = 5.0",
            &["rapid X1", "rapid Z2", "feed Z0 F9", "rapid Z5", "end M30"],
        ),
        // An input that nobody simulates is taken to come.
        ("G906 PLC[7] LEVEL1 P500\nG906 PLC=7 LEVEL1\nM30", "", &["wait 7 1 0.5s", "wait 7 1", "end M30"]),
    ]);
    let mut interpreter =
        interpreter_of(&DIALECT, b"X=#INPORTMAP\nG906 PLC[3] LEVEL0 P9\nM30", "", Options::default());
    let interpreter = interpreter.as_mut().unwrap();
    interpreter.set_port(3, 1.0);
    interpreter.set_port(0, 1.0);
    let results: Vec<_> = interpreter.filter(|r| !r.as_ref().is_ok_and(|s| s.op == Op::Barrier)).collect();
    assert_eq!(results[0].as_ref().unwrap().op.target().unwrap().0[0], 9.0);
    assert!(matches!(results[1].as_ref().unwrap().op, Op::Wait { .. }));
    assert_eq!(results[2].as_ref().unwrap_err().fault, Fault::InputMissing);
}

#[test]
fn moves_that_inputs_end() {
    let skip = "[signals]\nskip = { axis = \"z\", at = -3.0 }";
    hold(&[
        // Its own axis alone, in machine coordinates; the next move starts there.
        (
            "G904 FZ-60 PZ=#CALIBRATION_SW LZ1\nG91 Z5\nM30",
            skip,
            &["skip to the signal Z-3 F60", "rapid Z2", "end M30"],
        ),
        ("G904 FX50 PX[1] LX1 X4\nM30", skip, &["skip X4 F50", "end M30"]),
        // Behind the tool, or further than it may go, the signal does not come.
        (
            "G904 FZ60 PZ1 LZ1 Z2\nG904 FZ-60 PZ1 LZ1 Z1\nM30",
            skip,
            &["skip Z2 F60", "skip Z1 F60", "end M30"],
        ),
        // Homing: where it stands is the reference point from there on.
        (
            "M902 H2\nG91 Z1\nM30",
            "[start]\nz = 7.0\n[reference_points]\nfirst = { z = 100.0 }",
            &["rapid Z101", "end M30"],
        ),
    ]);
}

#[test]
fn a_rotary_y_turns() {
    let surface = "[parameters]\nISYREVAXIS = 1\n\"UNIT.YR\" = 1\nWPREVDIAM = 40.0\n";
    hold(&[
        ("Y=3.14159265358979*10\nG91 G908 Y-45\nM30", surface, &["rapid Y90", "rapid Y45", "end M30"]),
        // An inch on the surface.
        ("G20 Y=3.14159265358979*10/25.4\nM30", surface, &["rapid Y90", "end M30"]),
        // 5, parameter 12: else radians.
        ("Y=asin(1)\nM30", "[parameters]\nISYREVAXIS = 1", &["rapid Y90", "end M30"]),
        (
            "G908 Y350\nG907 G908 Y10\nG907 G908 Y190\nM30",
            surface,
            &["rapid Y350", "rapid Y370", "rapid Y550", "end M30"],
        ),
        // What a program reads is in the units of its words: of a block, of the hole of a cycle, of where the axes are.
        (
            "G91 G77 G908 Y90\nG99 G81 G908 Y45 R-1 Z-1 F9\nG90 Y=#CURWORKPOS.Y*2\nM30\n\
             O677\nY=#FC2\nM17\nO681\nY=#FC2\nM17",
            surface,
            &["rapid Y90", "rapid Y135", "rapid Y270", "end M30"],
        ),
        (
            "G20 Y=asin(1)\nX=#CURMACHPOS.Y\nM30",
            "[parameters]\nISYREVAXIS = 1",
            &["rapid Y90", "rapid X39.8982", "end M30"],
        ),
        // The centre of a mirror is a coordinate too.
        ("G51.1 G908 Y90\nG908 Y10\nM30", surface, &["rapid Y170", "end M30"]),
        // A plane without the axis has arcs; a tool without a radius has no path beside the programmed one.
        (
            "G18 G02 X2 I1 K0 F9\nG17 G41 D1 G01 Y0 X3\nM30",
            surface,
            &["zx X2 about 0 1 by -180 F9", "feed X3 F9", "end M30"],
        ),
    ]);
    let surface = &format!("{surface}[tools.1]\nradius = 2");
    for (program, words) in [
        ("G02 X10 R5 F9\nM30", "G02 X10 R5 F9"),
        ("G68 X0 Y0 R30\nM30", "G68"),
        ("G41 D1 X10\nM30", "G41 D1 X10"),
        ("G81 R1 Z0 F9 K0\nG34 X0 Y0 I5 J0 K3\nM30", "G34"),
    ] {
        let (_, alarm) = run_on(&DIALECT, program, surface);
        let alarm = alarm.unwrap_or_else(|| panic!("no alarm: {program}"));
        assert_eq!((alarm.fault, at_fault(program, &alarm)), (Fault::RotaryInPlane, words));
    }
}

#[test]
fn parameters_are_read_and_written_by_name() {
    hold(&[
        (
            "#SAFEHEIGHT=#SAFEHEIGHT*2\nZ=#safeheight\nM30",
            "[parameters]\nSAFEHEIGHT = 6.0",
            &["rapid Z12", "end M30"],
        ),
        // Lengths and feeds are in the unit of the program, other things not.
        (
            "G20\nG01 X=#SAFEHEIGHT Y=#FIXEDCYCLE_OSS F=#BKREF_F1.X\n#SAFEHEIGHT=2\nG21\nX=#SAFEHEIGHT\nM30",
            "[parameters]\nSAFEHEIGHT = 12.7\nFIXEDCYCLE_OSS = 1\n\"BKREF_F1.X\" = 500",
            &["feed X12.7 Y25.4 F500", "feed X50.8 F500", "end M30"],
        ),
        // A cycle of the shop with a draw-back from the list (5, example 2).
        (
            "G20 G77 Z0\nM30\nO677\nZ=#FC3\nG91 Z=#FIXEDCYCLE_BACK\nM17",
            "[parameters]\nFIXEDCYCLE_BACK = 5.4\n[start]\nz = 25.4",
            &["rapid Z0", "rapid Z5.4", "end M30"],
        ),
        // What a parameter sets is in force from there on.
        (
            "#FIXEDCYCLE_BACK=3\nG99 G83 R0 Z-6 Q4 F9\nM30",
            "",
            &["feed Z-4 F9", "rapid Z0", "rapid Z-1", "feed Z-6 F9", "rapid Z0", "end M30"],
        ),
        (
            "X=#CURWORKPOS.X+1 Y=#CURMACHPOS.X\nM30",
            "[start]\nx = 3.0\n[work_offsets]\nG54 = { x = 1.0 }",
            &["rapid X4 Y3", "end M30"],
        ),
        // What a move to there would be programmed with: 0 behind G92 Z0, whatever the tool's length.
        (
            "G43 H1 Z10\nX=#CURWORKPOS.Z\nG92 Z0\nY=#CURWORKPOS.Z+2\nM30",
            "[tools.1]\nlength = 4",
            &["rapid Z14", "rapid X10", "rapid Y2", "end M30"],
        ),
    ]);
}

#[test]
fn positions_are_waited_for_in_compensation() {
    let tool = "[tools.1]\nradius = 2";
    hold(&[
        // Round the corner at the height of that moment: the tool does not go down again.
        (
            "G41 D1 G01 X10 F100\nY20\nG906\nG00 Z5\nX20\nG40 Y0\nM30",
            tool,
            &[
                "feed X8 F100",
                "feed Y20 F100",
                "rapid Z5",
                "feed Y22 F100",
                "rapid X20",
                "rapid Y0",
                "end M30",
            ],
        ),
        // From the end of a start-up to where the contour begins.
        (
            "G41 D1 G01 X10 F100\nG906\nY20\nX20\nG40 Y0\nM30",
            tool,
            &[
                "feed X10 Y2 F100",
                "feed X8 Y0 F100",
                "feed Y22 F100",
                "feed X20 F100",
                "feed Y0 F100",
                "end M30",
            ],
        ),
    ]);
}

#[test]
fn programs_stand_for_codes() {
    hold(&[
        // 6: before the motion that the code starts with; its own number is the built-in code.
        (
            "S300 M03 X5\nM30\nO203\nM901 H2 P1\nM03\nM17",
            "",
            &["out 2 1", "spindle cw 300", "rapid X5", "end M30"],
        ),
        // A code that waits for the motion's end waits for it too, and those behind it for the program.
        (
            "T4 X1 M06 M00\nM30\nO206\nX9\nM17",
            "",
            &["select 4", "rapid X1", "rapid X9", "stop M00", "end M30"],
        ),
        // S runs O202; M02 is never replaced.
        ("S300\nX1\nM02\nO202\nG04 P5\nM17", "", &["dwell 0.005s", "rapid X1", "end M02"]),
        ("M30\nO230\nX1\nM17", "", &["rapid X1", "end M30"]),
        // A G code of one's own, with its words.
        (
            "G91 G77 X3 I4 R5\nM30\nO677\nX=#FC1 Y=#FC9 Z=#FC4\nM17",
            "",
            &["rapid Z5", "rapid X3 Y4", "end M30"],
        ),
        // It repeats as a cycle does: at every place, with the levels that were given, until another code ends it.
        (
            "G77 X3 Z-2 I4 K8\nX5 Y6\nM08\nG80\nX1\nG77\nG00 Y2\nM30\nO677\nX=#FC1 Y=#FC2 Z=#FC3+#FC9+#FC11\nM17",
            "",
            &[
                "rapid Z10",
                "rapid X3",
                "rapid X5 Y6",
                "rapid Z-2",
                "coolant on",
                "rapid X1",
                "rapid Y2",
                "coolant off",
                "end M30",
            ],
        ),
        // A code of motion beside it is in force behind it; a tool length comes with the next way of the tool axis.
        ("G01 G77 X5 F60\nG80\nX6\nM30\nO677\nY=#FC1\nM17", "", &["feed Y5 F60", "feed X6 F60", "end M30"]),
        (
            "G77 X5\nG43 H1 X6\nM30\nO677\nG00 X=#FC1 Z=#FC3+1\nM17",
            "[tools.1]\nlength = 7.0",
            &["rapid Z1", "rapid X5", "rapid Z9", "rapid X6", "end M30"],
        ),
        // Its words are handed on as they are.
        (
            "G77 P-3 Q-5\nM30\nO677\nX=#FC6 Y=#FC5 Z=#FC3\nM17",
            "[start]\nz = 20",
            &["rapid X-3 Y-5", "end M30"],
        ),
        // The end of a cycle comes before it.
        ("G81 R1 Z0 F9 K0\nG80 G77 X5\nM30\nO677\nX=#FC1\nM17", "", &["rapid X5", "end M30"]),
        // It is no canned cycle of the plane XY.
        ("G18 G77\nM30\nO677\nX4\nM17", "", &["rapid X4", "end M30"]),
        // The code of the program itself is the built-in one, also a level deeper.
        ("G04 P100\nM30\nO604\nG65 P5\nM17\nO5\nG04 P=#FC6*2\nM17", "", &["dwell 0.2s", "end M30"]),
        // Levels of a cycle are levels, also with G91; the cycle stays in force behind its program.
        (
            "G91 G99 G81 X2 R-3 Z-2 F80 K7\nY1\nG80\nX1\nM30\n\
             O681\nG90 G01 X=#FC3 Y=#FC4 Z=#FC14 F=#FC7+#FC11\nG00 X0 Y0\nG91 X=#FC1 Y=#FC2\nM17",
            "[start]\nz = 9.0",
            &[
                "feed X4 Y6 F87",
                "rapid X0 Y0",
                "rapid X2",
                "feed X4 Y6 F88",
                "rapid X0 Y0",
                "rapid Y1",
                "rapid X1",
                "end M30",
            ],
        ),
        // Each hole of a figure is one call.
        (
            "G99 G81 R1 Z-1 F9 K0\nG35 X5 Y6 I10 J0 K2 M05\nX1\nM30\nO681\nX=#FC1 Y=#FC2\nM17",
            "",
            &["rapid X5 Y6", "rapid X15", "rapid X1", "end M30"],
        ),
        // It is made once, and the words of the figure are none of its own.
        (
            "G91 G99 G81 R-1 Z-1 F9 K0\nG35 X5 Y6 I10 J90 K2\nM30\n\
             O681\nG65 P781 L=#FC11\nM17\nO781\nX=#FC1+#FC9 Y=#FC2+#FC10\nM17",
            "",
            &["rapid X5 Y6", "rapid Y16", "end M30"],
        ),
    ]);
    let interpreter = interpreter_of(&DIALECT, b"M40\nM30\nO241\nM17\n", "", Options::default()).unwrap();
    assert_eq!(interpreter.filter_map(Result::err).next().unwrap().fault, Fault::UnknownMCode);
}

#[test]
fn a_scale_factor_out_of_range_tells_the_range() {
    let interpreter = interpreter_of(&DIALECT, b"G51 X0 P0\nM30\n", "", Options::default()).unwrap();
    let alarm = interpreter.filter_map(Result::err).next().unwrap();
    let text = Catalogue::new(Language::En).message(&alarm);
    assert!(text.contains("0.000001 to 99.999999"), "{text}");
}

#[test]
fn programs_break_rules() {
    for (program, setup, fault, words) in [
        ("G90 G91 X1\nM30", "", Fault::RepeatedGroup, "G91"),
        ("G34 X1 I1 K1\nM30", "", Fault::PatternWithoutCycle, "G34"),
        ("G81 R1 Z0 F9 K0\nG34 X1 I1 K0\nM30", "", Fault::WordOutOfRange, "K0"),
        ("G81 R1 Z0 F9 K0\nG35 X1 I1 J0 K-2\nM30", "", Fault::WordOutOfRange, "K-2"),
        ("G81 R1 Z0 F9 K0\nG37 X1 I1 J1 K2\nM30", "", Fault::WordMissing, "G37"),
        ("G81 R1 Z0 F9 K0\nG34 X1 K10000\nM30", "", Fault::WordOutOfRange, "K10000"),
        // 4.4: a level is 0 or 1.
        ("M901 PLC[04] LEVEL7\nM30", "", Fault::WordOutOfRange, "LEVEL7"),
        ("M901 H2 P5\nM30", "", Fault::WordOutOfRange, "P5"),
        ("G906 PLC[04] LEVEL2 P10\nM30", "", Fault::WordOutOfRange, "LEVEL2"),
        ("G904 FZ-10 PZ1 LZ2 Z-5\nM30", "", Fault::WordOutOfRange, "LZ2"),
        // A level without the input: it would not be waited for.
        ("G906 LEVEL1\nM30", "", Fault::WordMissing, "G906"),
        ("G51 Z0 P2\nG81 R1 Z0 F9\nM30", "", Fault::CycleScaled, "G81"),
        ("G51 X0 P0\nM30", "", Fault::ScaleFactor, "P0"),
        ("G51 X0 I100\nM30", "", Fault::ScaleFactor, "I100"),
        ("G51 X0 P2 I3\nM30", "", Fault::ScaleForm, "G51 X0 P2 I3"),
        ("G51 P2\nM30", "", Fault::ScaleForm, "G51 P2"),
        ("G51 X0 P2\nG28 X0\nM30", "", Fault::CodeInScaling, "G28"),
        ("G51.1\nM30", "", Fault::MirrorForm, "G51.1"),
        ("G41 D1 G00 X5\nG51 X0 P2\nM30", "[tools.1]\nradius = 1.0", Fault::ScalingInCutter, "G51"),
        ("G65 P1\nM30\nO1\nG68 R1\nG65 P1 L1\nM17", "", Fault::CallsTooDeep, "P1"),
        ("G65 P1 L999\nM30\nO1\nG68 R1\nM17", "", Fault::TooManyTransforms, "G68"),
        ("G53 G02 X1 R1 F9\nM30", "", Fault::ArcInMachine, "G53 G02 X1 R1 F9"),
        // In its own program it is what the control has.
        ("G77\nM30\nO677\nG77 X1\nM17", "", Fault::UnknownGCode, "G77"),
        ("G53 G77 X1\nM30\nO677\nX1\nM17", "", Fault::NeedsOwnBlock, "G53"),
        // Of two codes of which a program takes the words none goes for nothing.
        ("G5 G6 X1\nM30\nO605\nX1\nM17\nO606\nX2\nM17", "", Fault::NeedsOwnBlock, "G5"),
        ("G5 G81 X1 R1 Z0 F9\nM30\nO605\nX1\nM17", "", Fault::NeedsOwnBlock, "G5"),
        ("G81 G5 X1 R1 Z0 F9\nM30\nO605\nX1\nM17", "", Fault::NeedsOwnBlock, "G81"),
        ("G82 G81 X1 R1 Z0 F9\nM30\nO681\nX1\nM17", "", Fault::NeedsOwnBlock, "G82"),
        ("G4 G28 X1\nM30\nO604\nX1\nM17\nO628\nX2\nM17", "", Fault::NeedsOwnBlock, "G4"),
        ("G4 G28 X1\nM30\nO604\nX1\nM17", "", Fault::NeedsOwnBlock, "G28"),
        ("G65 P1 G4\nM30\nO1\nX2\nM17\nO604\nX1\nM17", "", Fault::NeedsOwnBlock, "G65"),
        ("G54 G81 X1 R1 Z0 F9\nM30\nO654\nX1\nM17", "", Fault::NeedsOwnBlock, "G81"),
        ("M901 LEVEL1\nM30", "", Fault::WordMissing, "M901"),
        ("G904 FX9 LX1\nM30", "", Fault::WordMissing, "G904"),
        ("G904 FX0 PX1 LX1\nM30", "", Fault::FeedOutOfRange, "FX0"),
        (
            "G41 D1 G01 X5 F9\nX9\nG904 FX9 PX1 LX1 X3\nM30",
            "[tools.1]\nradius = 1",
            Fault::SkipInCutter,
            "G904",
        ),
        ("M902 H7\nM30", "", Fault::ReferenceNumber, "H7"),
        ("G922 X1 P6\nM30", "", Fault::DataNumber, "P6"),
        ("G923 Z1\nM30", "", Fault::OffsetNumber, "G923 Z1"),
        ("G43 H8 Z1\nM30", "", Fault::OffsetNumber, "H8"),
        ("G41 D8 X1\nM30", "", Fault::OffsetNumber, "D8"),
        ("G83 R0 Z-5 F9\nM30", "", Fault::CycleNoPeck, "G83"),
        // 4.3: K and L are numbers of holes; only those of figures say by their sign which way round.
        ("G81 X1 R1 Z0 F9 K-2\nM30", "", Fault::WordNegative, "K-2"),
        ("G81 X1 R1 Z0 F9 L-2\nM30", "", Fault::WordNegative, "L-2"),
        ("X=#NONESUCH\nM30", "", Fault::UnknownVariable, "NONESUCH"),
        ("#CURMACHPOS.X=1\nM30", "", Fault::VariableNotWritable, "#CURMACHPOS.X=1"),
        ("#FIXEDCYCLE_OSS=9\nM30", "", Fault::DataParameter, "#FIXEDCYCLE_OSS=9"),
        ("X=1/0\nM30", "", Fault::DivisionByZero, "X=1/0"),
        ("M801 MSG\"a\nM30", "", Fault::UnclosedText, "MSG\"a"),
        ("X\"a\"\nM30", "", Fault::AddressWithoutNumber, "X\"a\""),
        ("G65 P\"NONE\"\nM30", "", Fault::ProgramMissing, "P\"NONE\""),
        ("G65 L2\nM30", "", Fault::CallWithoutProgram, "G65"),
        ("G65 P1\nM30\nO1\nN5 M99 P5", "", Fault::SequenceMissing, "P5"),
        ("N=1/2 X5\nM30", "", Fault::WordNotWhole, "N=1/2"),
        ("O=7 X5\nM30", "", Fault::VariableInNumber, "O=7"),
        ("(a)\nM30", "", Fault::IllegalCharacter, "("),
    ] {
        let (_, alarm) = run_on(&DIALECT, program, setup);
        let alarm = alarm.unwrap_or_else(|| panic!("no alarm: {program}"));
        assert_eq!((alarm.fault, at_fault(program, &alarm)), (fault, words), "{program}");
    }
}

/// 4.4, G904: words of an axis are whole; where one of them is not, no other moves before that is told.
#[test]
fn an_axis_without_its_words_keeps_all_at_rest() {
    let (steps, alarm) = run_on(&DIALECT, "G904 FX-60 PX2 LX1 FY10 X50 Y5\nM30", "");
    let moves = steps.iter().any(|step| matches!(step.op, ferrocut_toolpath::Op::Skip { .. }));
    assert_eq!((moves, alarm.unwrap().fault), (false, Fault::WordMissing));
}

/// 4.4, M802: its numbers for the control itself, and any other for the machine.
#[test]
fn a_number_is_for_the_control_or_for_the_machine() {
    hold(&[
        (
            "M802 P131073\nM802 P196608\nM802 P0\nM802 P=458752+1\nM30",
            "",
            &["M802 P0", "M802 P458753", "end M30"],
        ),
        ("M802 P7 X1\nM30", "", &["M802 P7", "rapid X1", "end M30"]),
    ]);
    // The buffer is off: each block begins at rest, until it is on again; the next program has it on.
    let program = "X1\nM802 P196609\n#1=2\nX=#1 M8\nIF(0) X9\nM802 P196608\nX3\nX4\nM802 P196609\nM30";
    let wanted = [
        "rapid X1",
        "Barrier",
        "Barrier",
        "coolant on",
        "rapid X2",
        "Barrier",
        "Barrier",
        "rapid X3",
        "rapid X4",
        "Barrier",
        "coolant off",
        "end M30",
    ];
    assert_eq!(lines_on(&DIALECT, program, ""), wanted);
    let mut interpreter = interpreter_of(&DIALECT, program.as_bytes(), "", Options::default()).unwrap();
    let run = |interpreter: &mut Interpreter| {
        let steps: Vec<_> = interpreter.map(Result::unwrap).collect();
        steps.iter().take_while(|step| !matches!(step.op, Op::Coolant(_))).count()
    };
    let first = run(&mut interpreter);
    interpreter.rewind(interpreter.position());
    assert_eq!((first, run(&mut interpreter)), (3, 3));
    for (block, fault) in
        [("M802", Fault::WordMissing), ("M802 P1.5", Fault::WordNotWhole), ("M802 P-1", Fault::WordNegative)]
    {
        let (_, alarm) = run_on(&DIALECT, &format!("{block}\nM30"), "");
        assert_eq!(alarm.map(|alarm| alarm.fault), Some(fault), "{block}");
    }
}

/// 4.2, M903: the tool in the spindle gets another number, and with it the offsets that T calls (4.1).
#[test]
fn a_tool_gets_another_number() {
    let tools = "[tools.1]\nlength = 1\n[tools.2]\nlength = 2";
    hold(&[
        (
            "T1 M06\nG43 X1 Z10\nM903 P2\nG43 Z20\nM30",
            tools,
            &["select 1", "change 1", "rapid Z11", "rapid X1", "tool 2", "rapid Z22", "end M30"],
        ),
        // It is in the spindle already.
        ("M903 P2\nM06\nM30", tools, &["tool 2", "end M30"]),
        ("M903 T2\nM30", tools, &["select 2", "tool 2", "end M30"]),
        (
            "T1 M06 G43 Z10\nM903 P2\nZ20\nM30",
            tools,
            &["select 1", "rapid Z11", "change 1", "tool 2", "rapid Z22", "end M30"],
        ),
    ]);
    for (block, fault) in [("M903 P-1", Fault::WordNegative), ("M903 P0.5", Fault::WordNotWhole)] {
        let (_, alarm) = run_on(&DIALECT, &format!("{block}\nM30"), "");
        assert_eq!(alarm.map(|alarm| alarm.fault), Some(fault), "{block}");
    }
}

/// 4.1, T: the offsets of the tool before are in force until the next one is changed to.
#[test]
fn offsets_come_with_the_tool() {
    let tools = "[tools.1]\nlength = 7\nradius = 1\n[tools.2]\nlength = 9\nradius = 2";
    hold(&[
        (
            "T1 M06\nG43 Z20\nT2\nZ19\nM06\nX1\nZ21\nG81 X3 Z-5 R1 F100\nG80 G49 Z0\nM30",
            tools,
            &[
                "select 1",
                "change 1",
                "rapid Z27",
                "select 2",
                "rapid Z26",
                "change 2",
                "rapid X1",
                "rapid Z30",
                "rapid X3",
                "rapid Z10",
                "feed Z4 F100",
                "rapid Z30",
                "rapid Z0",
                "end M30",
            ],
        ),
        // A cycle takes the length up on its way to the R level, and a program in the place of M06 changes tools too.
        (
            "T1 M06\nG43 Z20\nT2 M06\nG99 G81 X3 Z-5 R1 F100\nM30\nO206\nM17",
            tools,
            &[
                "select 1",
                "rapid Z27",
                "select 2",
                "rapid X3",
                "rapid Z10",
                "feed Z4 F100",
                "rapid Z10",
                "end M30",
            ],
        ),
        // The radius changes along the next move.
        (
            "T1 M06\nG41 G01 Y5 F9\nX5\nT2 M06\nX9\nX20\nG40 Y9\nM30",
            tools,
            &[
                "select 1",
                "change 1",
                "feed Y6 F9",
                "feed X5 F9",
                "select 2",
                "change 2",
                "feed X9 Y7 F9",
                "feed X20 F9",
                "feed Y9 F9",
                "end M30",
            ],
        ),
    ]);
}

/// 5, parameters 19 to 22: the control takes the tool to the fixed point, and no program does.
#[test]
fn the_tool_goes_to_the_fixed_point_after_each_program() {
    let point = "[start]\nz = 5\n[parameters]\nENABLE_CTP = 1\n\"CTP_POS.X\" = 12\n\"CTP_POS.Y\" = -8\n\"CTP_POS.Z\" = 40\n";
    let ended = |program: &str, setup: &str, homed: bool| {
        let options = Options { ends_at_fixed_point: true, ..Options::default() };
        let mut interpreter = interpreter_of(&DIALECT, program.as_bytes(), setup, options).unwrap();
        if !homed {
            let axes = [Axis::Z].into_iter().collect();
            interpreter.set_unreferenced(Unreferenced { axes, ..Unreferenced::default() });
        }
        let start = Position::xyz(0.0, 0.0, 5.0);
        let steps: Vec<_> = interpreter.collect();
        let fault =
            steps.iter().find_map(|step| step.as_ref().err()).map(|alarm| (alarm.fault, alarm.span.line));
        let steps: Vec<_> = steps.into_iter().filter_map(Result::ok).collect();
        (common::short(&steps, start), fault)
    };
    let way = ["rapid Z40", "rapid X12 Y-8", "end M30"];
    for program in ["M30", "G91\nG70 M30", "G51 P2 X0 Y0 Z0\nM30", "G43 H1\nM30"] {
        assert_eq!(ended(program, point, true), (way.map(String::from).to_vec(), None), "{program}");
    }
    // Not at the speed of the program's rapids, and with the spindle on.
    let stops = format!("{point}AUTOSTOPSPINDLE = 1\n");
    let (steps, _) = ended("S100 M3\nG00 Z50 F10\nM02", &stops, true);
    let behind = ["rapid X12 Y-8", "rapid Z40", "spindle off", "end M02"];
    assert_eq!(steps[steps.len() - 4..], behind, "{steps:?}");
    // Neither where it is not asked for, nor after a program that did not end.
    assert_eq!(ended("M30", "", true).0, ["end M30"]);
    assert_eq!(ended("M30", &point.replace("ENABLE_CTP = 1", "ENABLE_CTP = 0"), true).0, ["end M30"]);
    assert_eq!(
        ended("X1\nG999\nM30", point, true),
        (vec!["rapid X1".to_owned()], Some((Fault::UnknownGCode, 2)))
    );
    assert_eq!(lines_on(&DIALECT, "M30", point), ["end M30"]);
    // It is a machine position.
    assert_eq!(ended("M30", point, false), (vec![], Some((Fault::ReferenceNeeded, 1))));
}

/// What is not done is told by a check, and ends no run.
#[test]
fn a_check_tells_of_codes_that_have_no_effect() {
    let program = "G916 PX[00000] LX0\nG918\nG919 H0\nM802 P131072\nM802 P131073\nM30";
    let told = |keep_going| {
        let options = Options { keep_going, ..Options::default() };
        let interpreter = interpreter_of(&DIALECT, program.as_bytes(), "", options).unwrap();
        let alarms: Vec<_> = interpreter.filter_map(Result::err).collect();
        assert!(alarms.iter().all(|alarm| alarm.severity == Severity::Warning), "{alarms:?}");
        alarms.into_iter().map(|alarm| (alarm.span.line, alarm.fault)).collect::<Vec<_>>()
    };
    let latches = [1, 2, 3].map(|line| (line, Fault::NoLatches));
    assert_eq!(told(true), [&latches[..], &[(4, Fault::LimitsStay)]].concat());
    assert_eq!(told(false), []);
}

/// Of two subprograms with one number a call runs the first, and says so once.
#[test]
fn a_check_tells_of_a_second_program_of_a_number() {
    let program = "G65 P7 L2\nG65 P7\nM30\nO7\nG91 X1\nM17\nO8\nM17\nO7\nX9\nM17\nO8\nM17";
    let told = told_on(&DIALECT, program, "");
    let found: Vec<_> = told
        .iter()
        .map(|alarm| (alarm.severity, alarm.fault, alarm.span.line, at_fault(program, alarm)))
        .collect();
    assert_eq!(found, [(Severity::Warning, Fault::ProgramRepeated, 9, "O7")]);
    let text = Catalogue::new(Language::En).message(&told[0]);
    assert!(text.contains("O0007"), "{text}");
    hold(&[(program, "", &["rapid X1", "rapid X2", "rapid X3", "end M30"])]);
}

/// 4.3: words that a code does not have.
#[test]
fn a_check_tells_of_words_without_effect() {
    let tool = "[tools.1]\nlength = 1";
    let cases: [(&str, &[Told]); 7] = [
        (
            "G81 R1 Z0 F9 K0\nG34 X10 I5 K2 Z3 P4\nG36 X10 I5 K2 P4 R3\nM30",
            &[(2, Fault::WordUnused, "Z3"), (2, Fault::WordUnused, "P4"), (3, Fault::WordUnused, "R3")],
        ),
        // The manual's own form.
        ("G923 X1 Y2 Z3 P1\nM30", &[]),
        ("G923 P1\nM30", &[(1, Fault::WordUnused, "P1")]),
        ("G922 P1\nG922 X1 P1\nM30", &[(1, Fault::WordUnused, "P1")]),
        ("G4 S5\nG4 P5 S5\nM30", &[(1, Fault::WordMissing, "G4 S5")]),
        ("G4 P5 X1 Y2\nG4 X1\nM30", &[(1, Fault::WordUnused, "X1"), (1, Fault::WordUnused, "Y2")]),
        ("G81 R1 Z0 F9 K0\nG35 X10 I5 K2 M901 H2 P1\nM30", &[]),
    ];
    for (program, expected) in cases {
        let expected: Vec<_> =
            expected.iter().map(|(line, fault, words)| (*line, *fault, (*words).to_owned())).collect();
        assert_eq!(told(program, tool), expected, "{program}");
    }
}

/// A cycle makes no hole beside a motion code, which ends it (4.3), nor beside a code that acts alone.
#[test]
fn a_check_tells_of_cycles_that_make_no_hole() {
    let program = "G00 G81 X1 R1 Z0 F9\nG4 P5 G82 X2 R1 Z0\nG00 G80 X3\nG99 G81 X4 R1 Z0\nM30";
    let expected = [
        (1, Fault::CycleBesideCode, "G81"),
        (2, Fault::CycleBesideCode, "G82"),
        (2, Fault::WordUnused, "X2"),
        (2, Fault::WordUnused, "Z0"),
        (2, Fault::WordUnused, "R1"),
    ];
    assert_eq!(told(program, ""), expected.map(|(line, fault, word)| (line, fault, word.to_owned())));
    let text = Catalogue::new(Language::En).message(&told_on(&DIALECT, program, "")[0]);
    assert!(text.contains("G00"), "{text}");
}

/// 5 has no word of the macro language but IF: each of the others is told once, as a word.
#[test]
fn a_check_tells_of_macro_words_as_words() {
    let program = "IF(#1==0)GOTO 10\nN10 while[#1 LT 5]DO1\n#1=#1+1\nEND1\nM30";
    let found = told(program, "");
    let expected = [(1, "GOTO"), (2, "while"), (4, "END")];
    assert_eq!(found, expected.map(|(line, word)| (line, Fault::MalformedStatement, word.to_owned())));
}

#[test]
fn words_belong_to_the_code_that_takes_them() {
    let tools = "[tools.1]\nlength = 1\n[tools.2]\nlength = 2";
    hold(&[
        // S beside G92 is the speed of the spindle: there is no G96 that it could limit.
        ("G92 X0 Y0 Z0 M03 S600\nG01 X1 F500\nM30", "", &["spindle cw 600", "feed X1 F500", "end M30"]),
        // P of M802 and M901 is no dwell of the cycle in force.
        (
            "S100 M3\nG00 Z10\nG99 G82 X5 Z-6 R0 F200 P500\nM802 P7\nX6\nM901 H2 P1\nG80 M5\nM30",
            "",
            &[
                "spindle cw 100",
                "rapid Z10",
                "rapid X5",
                "rapid Z0",
                "feed Z-6 F200",
                "dwell 0.5s",
                "rapid Z0",
                "M802 P7",
                "rapid X6",
                "feed Z-6 F200",
                "dwell 0.5s",
                "rapid Z0",
                "out 2 1",
                "spindle off",
                "end M30",
            ],
        ),
        // H of G919 is an axis, H of G65 an argument.
        ("G43 H1 G00 Z10\nG919 H0\nG00 Z12\nM30", tools, &["rapid Z11", "rapid Z13", "end M30"]),
        (
            "G43 H1 G00 Z5\nG65 P10 H2 F50 T4\nZ6\nM30\nO10\nG00 X1\nM17",
            tools,
            &["rapid Z6", "rapid X1", "rapid Z7", "end M30"],
        ),
        // 4.3: with the centre in work coordinates a word left out is 0.
        (
            "G00 X10 Y0\nG03 X0 Y10 I0 F100\nM30",
            "[parameters]\nIJK_INCREMENTAL = 0",
            &["rapid X10", "xy X0 Y10 about 0 0 by 90 F100", "end M30"],
        ),
    ]);
}

/// K of a helix is a length of the program, as its climb is: scaling changes the number of turns by nothing.
#[test]
fn scaling_leaves_the_turns_of_a_helix() {
    for scale in ["P1", "P2", "P0.5", "I1 J1 K3"] {
        let program = format!("G51 X0 Y0 Z0 {scale}\nG0 X10\nG3 X10 Y0 I-10 J0 Z-20 K5 F100\nM30");
        let (steps, alarm) = run_on(&DIALECT, &program, "");
        assert_eq!(alarm, None, "{scale}");
        let sweep = steps.iter().find_map(|step| match step.op {
            Op::Arc { sweep, .. } => Some(sweep.to_degrees().round()),
            _ => None,
        });
        assert_eq!(sweep, Some(1440.0), "{scale}");
    }
}
