//! Feed, spindle, tools and axes as parameters and other words bear on them. Numbers are sections of "GSK990MC
//! programming and operation".
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{holds, holds_with, told_on};
use ferrocut_geometry::Position;
use ferrocut_interpreter::dialects::gsk990mc::DIALECT;
use ferrocut_machine::{AlarmId, Fault, Severity};

#[test]
fn feed_is_held_within_its_limits_where_it_is_used() {
    // 4.2.2 note 1, 7.2: P87 too, and a feed that was in force before the limit changed.
    holds_with("[parameters]\nP87 = 5000\nP96 = 1000", "G1 X1", &["feed X1 F1000"]);
    holds_with("[parameters]\nP87 = 10\nP97 = 60", "G1 X1", &["feed X1 F60"]);
    holds_with(
        "[parameters]\nP96 = 1000",
        "G1 X1 F1500\nG10 L51\nN96 R500\nG11\nG1 X2\nG10 L51\nN96 R2000\nG11\nG1 X3",
        &["feed X1 F1000", "feed X2 F500", "feed X3 F1500"],
    );
}

/// What a check tells of a program that runs.
fn told(program: &str, setup: &str) -> Vec<(AlarmId, String)> {
    let alarms = told_on(&DIALECT, program, setup).into_iter();
    let said = alarms.map(|alarm| {
        assert_eq!(alarm.severity, Severity::Warning, "{program}: {alarm:?}");
        (alarm.id, common::at_fault(program, &alarm).to_owned())
    });
    said.collect()
}

#[test]
fn a_speed_that_is_held_is_told() {
    // Part 2, 7.10: S beyond P258 turns at P258.
    let too_fast = |word: &str| vec![(AlarmId::Dialect("gsk990mc", 182), word.to_owned())];
    assert_eq!(told("M3 S6000\nM30\n", ""), []);
    assert_eq!(told("M3 S6001\nM30\n", ""), too_fast("S6001"));
    assert_eq!(told("M3 S900\nM30\n", "[parameters]\nP258 = 800"), too_fast("S900"));
    // A surface speed, and a gear, are no turns.
    assert_eq!(told("G96 S9000\nM30\n", "[parameters]\n\"NO61.0\" = 1"), []);
    assert_eq!(told("M3 S9001\nM30\n", "[parameters]\n\"NO1.2\" = 1"), []);
}

#[test]
fn the_demo_mill_turns_as_fast_as_its_control_lets_it() {
    // P258 as delivered is 6000 (appendix 1).
    let delivered = ferrocut_machine::Memory::new("gsk990mc").parameters.data(258);
    assert_eq!((ferrocut_machine::Machine::demo_mill().spindle.max_rpm, delivered), (6000.0, 6000.0));
}

#[test]
fn the_last_two_digits_of_a_gear_count() {
    // 6.2: with 1#2 S is the number of a gear; of four digits the last two are valid. P258 holds speeds alone.
    let switched = "[parameters]\n\"NO1.2\" = 1\nP258 = 1";
    for (word, gear) in [("S3", 3), ("S03", 3), ("S7002", 2), ("S1203", 3), ("S0001", 1)] {
        let expected = format!("spindle cw {gear}");
        holds_with(switched, &format!("M3 {word}\nM5"), &[&expected, "spindle off"]);
    }
    holds_with("", "M3 S1203\nM5", &["spindle cw 1203", "spindle off"]);
}

#[test]
fn a_unit_beside_other_words_is_told() {
    // 4.2.17 note 6: G20 and G21 have a block of their own. Modal codes beside them have no unit.
    let beside = |word: &str| vec![(AlarmId::Core(Fault::NeedsOwnBlock), word.to_owned())];
    for program in ["G21\nG0 X1", "N5 G20", "G21 G17 G40 G49 G80 G90 G94 G54"] {
        assert_eq!(told(&format!("{program}\nM30\n"), ""), [], "{program}");
    }
    for program in ["G20 X1", "G20 G1 F5", "G0 G20 G43 H1", "G20 M8", "G20 S100"] {
        assert_eq!(told(&format!("{program}\nM30\n"), ""), beside("G20"), "{program}");
    }
}

#[test]
fn a_machine_position_with_g91_is_told() {
    // 4.2.10: the block is ignored.
    let unused = |word: &str| (AlarmId::Core(Fault::WordUnused), word.to_owned());
    assert_eq!(told("G91 G53 Y1 Z-5\nM30\n", ""), [unused("Y1"), unused("Z-5")]);
    assert_eq!(told("G91 X1\nG90 G53 Z-5\nM30\n", ""), []);
}

#[test]
fn rotary_axes_have_no_inch() {
    // 0#2: degrees a minute where nothing but a rotary axis moves, whatever the unit of the lengths is.
    holds(&[
        ("G20 G1 A90 F10", &["feed A90 F10"]),
        ("G20 G1 X1 A90 F10", &["feed X25.4 A90 F254"]),
        ("G20 G31 A9 F10", &["skip A9 F10", "Barrier"]),
        ("G1 A9 F100\nG20 A18", &["feed A9 F100", "feed A18 F100"]),
        ("G20 F10\nG21 G1 A9\nX1", &["feed A9 F10", "feed X1 F254"]),
    ]);
}

#[test]
fn rotary_axes_turn_the_near_way() {
    // 9#0, set by standard: the readout of 370 is 10. Half a turn goes up.
    holds(&[
        ("G90 G0 A350\nA10", &["rapid A-10", "rapid A10"]),
        (
            "G0 A170\nA350\nG1 A10 F100\nA180",
            &["rapid A170", "rapid A350", "feed A370 F100", "feed A540 F100"],
        ),
        ("G0 A170\nA-170", &["rapid A170", "rapid A190"]),
        ("G0 A720", &[]),
        ("G91 G0 A350\nA10", &["rapid A350", "rapid A360"]),
        ("G0 X400", &["rapid X400"]),
    ]);
    holds_with("[parameters]\n\"NO9.0\" = 0", "G90 G0 A350\nA10", &["rapid A350", "rapid A10"]);
    holds_with("[parameters]\n\"NO8.3\" = 0", "G90 G0 A350\nA10", &["rapid A350", "rapid A10"]);
}

#[test]
fn surface_speed_has_words_of_its_own() {
    let setup = "[start]\nx = 50\ny = 100\n[parameters]\n\"NO61.0\" = 1";
    // 6.3: G96 without S takes the last surface speed; none is 0. G97 without S keeps the turns.
    let trace = |program: &str, setup: &str| common::lines(&format!("{program}\nM30\n"), setup);
    assert_eq!(
        trace("G96 P1 S600\nM3\nG97 S450\nG96", setup)[..3],
        ["spindle cw css 600", "spindle cw 450", "spindle cw css 600"]
    );
    assert_eq!(trace("M3 S1000\nG96 P1", setup)[1], "spindle cw css 0");
    // G92 S limits at once.
    assert_eq!(trace("G96 S600 M3\nG92 S500", setup)[..2], ["spindle cw css 600", "spindle cw css 600"]);
    // It is no speed, also where surface speed is not fitted.
    holds_with("", "M3 S500\nG92 S3000", &["spindle cw 500", "spindle off"]);
    // P255: not slower than 100 r/min; P254 = 2 reckons by Y.
    assert_eq!(trace("G96 S1 M3\nG97", setup)[1], "spindle cw 100");
    let rpm = |axis: u8| trace("G96 S62832 M3\nG97", &format!("{setup}\nP254 = {axis}"))[1].clone();
    assert!(rpm(0).starts_with("spindle cw 200.00") && rpm(0) == rpm(1), "{}", rpm(0));
    assert!(rpm(2).starts_with("spindle cw 100.00"), "{}", rpm(2));
}

#[test]
fn scaling_without_a_centre_is_about_the_tool() {
    // 4.2.14, 1: X20 stands on 40 with the first factor, which is the centre of the second: 40 + (20 - 40) / 2.
    holds_with(
        "[parameters]\n\"NO47.6\" = 0\n\"NO60.5\" = 1",
        "G90 G0 X10 Y0\nG51 X0 Y0 P2\nG1 X20 F100\nG51 P0.5\nG1 X20",
        &["rapid X10", "feed X40 F100", "feed X30 F100"],
    );
}

#[test]
fn p_belongs_to_the_other_code_of_a_block_with_g54() {
    holds_with(
        "[work_offsets]\n\"G54 P3\" = { x = 1 }\n[reference_points]\nthird = { x = 30.0 }",
        "G54 G30 P3 X0\nG0 X5",
        &["rapid X30", "home", "rapid X5"],
    );
    let scaling = "[parameters]\n\"NO47.6\" = 0\n\"NO60.5\" = 1";
    holds_with(scaling, "G90 G54 G51 X0 Y0 P2\nG0 X10", &["rapid X20"]);
    // Turns by the second axis, 62.832 m a minute on a radius of 100; P beside a dwell is the dwell's.
    let setup = "[start]\nx = 50\ny = 100\n[parameters]\n\"NO61.0\" = 1";
    let second = |program: &str| common::lines(program, setup)[1].clone();
    let turns = second("G54 G96 P2 S62832 M3\nG97\nM30\n");
    assert!(turns.starts_with("spindle cw 100.00"), "{turns}");
    assert_eq!(second("G96 G4 P500 S600 M3\nM30\n"), "dwell 0.5s");
}

#[test]
fn a_tool_that_is_in_the_spindle_is_not_changed() {
    // 8.1.
    holds(&[
        ("M6", &[]),
        ("T2 M6\nM6", &["select 2", "change 2"]),
        ("T2 M6\nT2\nM6", &["select 2", "change 2", "select 2"]),
        ("T2 M6\nT3\nM6", &["select 2", "change 2", "select 3", "change 3"]),
    ]);
}

#[test]
fn axes_are_those_that_the_parameters_name() {
    // P175 to P179 in whatever order a file has them; P10 to P64 belong to the axes so named.
    holds_with(
        "[parameters]\nP178 = 5\nP18 = 30\nP48 = 7",
        "G54 G0 C1\nG28 C0",
        &["rapid C31", "rapid C30", "rapid C7", "home"],
    );
    holds_with("[parameters]\nP175 = 1\nP176 = 0\nP15 = 10\nP16 = 20", "G54 G0 X1 Y1", &["rapid X21 Y11"]);
    // The fourth may have the name of a fifth that is not carried.
    // What is set by the number of an axis follows its number: here the first is Y.
    let turned = "P175 = 1\nP176 = 0";
    let scaled = |more: &str| format!("[parameters]\n{turned}\n{more}");
    let g51 = "G51 X0 Y0 Z0\nG0 X10 Y10";
    holds_with(&scaled("P331 = 2"), g51, &["rapid X10 Y20"]);
    holds_with(&scaled("\"NO47.3\" = 0"), "G51 X0 Y0 Z0 I2 J2 K2\nG0 X10 Y10", &["rapid X20 Y10"]);
    holds_with("[parameters]\nP178 = 4", "G0 B10", &["rapid B10"]);
    // P5 = 5: five axes.
    holds_with("[parameters]\nP5 = 5", "G0 A1\nB2", &["rapid A1", "rapid B2"]);
    // 8#n: which are linear, and so have inches.
    holds_with("[parameters]\n\"NO8.3\" = 0", "G20 G0 A1", &["rapid A25.4"]);
    holds(&[("G20 G0 A1 X1", &["rapid X25.4 A1"])]);
}

#[test]
fn codes_beside_another_go_in_the_order_of_what_they_do() {
    holds(&[
        // 4.2.13: the pole of G16 with G91 is the present point, wherever G91 stands.
        ("G0 X10 Y20\nG16 G91\nG1 X50 Y30 F100", &["rapid X10 Y20", "feed X53.3013 Y45 F100"]),
        ("G16 G18\nG15\nG16\nG15 G54 G0 X1", &["rapid X1"]),
        ("G68 X0 Y0 R90\nG69 G54 G0 X5", &["rapid X5"]),
        ("G68 X0 Y0 R90\nG69 G18\nG17 G0 X5", &["rapid X5"]),
        // 4.2.15, 4 and alarm 0144 are of another plane; that in force is chosen again without harm.
        ("G68 X0 Y0 R90\nG17 G0 X5", &["rapid Y5"]),
        // P belongs to the call, the dwell, the cycle.
        ("G54 G4 P500", &["dwell 0.5s"]),
        ("G54 M98 P2\nM30\nO2\nG0 X1\nM99", &["rapid X1"]),
    ]);
    // 4.1 note 1: length beside a code of group 00 takes effect with the next move of its axis.
    holds_with("[tools.1]\nlength = 3", "G4 X1 G43 H1\nG0 X2\nZ5", &["dwell 1s", "rapid X2", "rapid Z8"]);
    holds_with("[tools.1]\nlength = 3", "G43 H1 G53 Z10\nG0 Z5", &["rapid Z10", "rapid Z8"]);
    holds_with("[tools.1]\nlength = 3", "H1\nG43 Z0", &["rapid Z3"]);
}

#[test]
fn a_mirror_turns_rotation_and_compensation_round() {
    let setup = "[tools.1]\nradius = 5\n[parameters]\n\"NO60.5\" = 1\n\"NO47.6\" = 1\n\"NO40.7\" = 0";
    // 4.2.14 note 2.
    holds_with(
        setup,
        "G51 X0 Y0 I-1 J1\nG91 G68 X0 Y0 R30\nG90 G1 X20 Y0 F100",
        &["feed X-17.3205 Y10 F100"],
    );
    // The mirror image of the path without a mirror: X5 in its place, at 5 from the contour.
    holds_with(
        setup,
        "G51 X0 Y0 I-1 J1 K1\nG90 G0 X-20 Y0\nG1 G41 D1 X0 Y0 F100\nY50\nX50\nY0\nG40 X0\nG50",
        &["rapid X20", "feed X5 F100", "feed Y55 F100", "feed X-55 F100", "feed Y0 F100", "feed X0 F100"],
    );
}

/// Behind G51 the tool is not on the scaled shape yet: what names no axis of the plane moves none of it, and the tool axis moves
/// where it is named (Fanuc).
#[test]
fn a_plunge_behind_g51_goes_straight_down() {
    let setup = "[tools.1]\nlength = 4\n[parameters]\n\"NO60.5\" = 1\n\"NO47.6\" = 1";
    let there = "G0 X60 Y60 Z20";
    let trace = |program: &str, more: &[&str]| {
        let mut wanted = vec!["rapid X60 Y60 Z20"];
        wanted.extend(more);
        holds_with(setup, &format!("{there}\n{program}"), &wanted);
    };
    trace("G51 X50 Y50 I-1 J1\nG0 Z5\nX60 Y60", &["rapid Z5", "rapid X40"]);
    trace("G51 X50 Y50 I-1 J1\nG91 G0 Z-5\nG90 X70 Y60", &["rapid Z15", "rapid X30"]);
    trace("G51 X0 Y0 Z0 I2 J2 K2\nG0 X10 Y10\nZ5", &["rapid X20 Y20", "rapid Z10"]);
    trace("G43 H1\nG51 X50 Y50 Z0 I-1 J1 K2\nG49\nG0 X60 Y60", &["rapid Z24", "rapid Z20", "rapid X40"]);
}

/// GSK990MC 4.2.14 limit 1: the factor of the tool axis bears on nothing of a cycle, so neither on where its first hole is.
#[test]
fn a_scaled_tool_axis_leaves_the_first_hole_in_its_place() {
    let setup = "[parameters]\n\"NO60.5\" = 1\n\"NO47.6\" = 1";
    for k in [1, 2] {
        holds_with(
            setup,
            &format!("S100\nG0 X10 Y10 Z10\nG51 X0 Y0 Z0 I2 J2 K{k}\nG99 G81 X20 R2 Z-5 F100"),
            &["rapid X10 Y10 Z10", "rapid X40 Y20", "rapid Z2", "feed Z-5 F100", "rapid Z2"],
        );
    }
}

/// GSK990MC 4.2.14, 3: 47#3 to 47#5, whether the first, second and third axis is scaled, by P and by I, J, K.
#[test]
fn each_axis_is_scaled_where_its_bit_says() {
    for bits in 0..8_u8 {
        let is_on = |axis: u8| u8::from(bits & 1 << axis != 0);
        let setup = |by_axis: u8| {
            let axes: String =
                (0..3).map(|axis| format!("\n\"NO47.{}\" = {}", 3 + axis, is_on(axis))).collect();
            format!("[parameters]\n\"NO60.5\" = 1\n\"NO47.6\" = {by_axis}{axes}")
        };
        let [x, y, z] = [(0, 10), (1, 20), (2, 30)].map(|(axis, to)| to << is_on(axis));
        let wanted = format!("rapid X{x} Y{y} Z{z}");
        for (factors, by_axis) in [("P2", 0), ("I2 J2 K2", 1)] {
            let program = format!("G51 X0 Y0 Z0 {factors}\nG0 X10 Y20 Z30");
            holds_with(&setup(by_axis), &program, &[&wanted]);
        }
    }
}

#[test]
fn blocks_without_a_move_in_compensation() {
    let setup = "[tools.1]\nradius = 5\n[parameters]\n\"NO40.7\" = 0";
    // 4.7.3, 8 b, figure 4-7-3-18: a move of no length ends the move before square.
    holds_with(
        setup,
        "G90 G42 D1 G1 X20 F100\nX40\nX40\nY-40\nG40 X60",
        &["feed X20 Y-5 F100", "feed X40 F100", "feed X35 Y-40 F100", "feed X60 F100"],
    );
    // 0042 counts blocks: four of them with two functions each are four.
    let many = "T1 S100 M3\nT2 S200 M4\nT3 S300 M3\nT4 S400 M4";
    let (_, alarm) = common::run(&format!("G41 D1 G1 X10 F100\nX20\n{many}\nX30\nG40 X40\nM30\n"), setup);
    assert_eq!(alarm, None);
    for block in ["M5", "G91", "S21", "G4 X0", "Z0"] {
        let idle = |count: usize| format!("{block}\n").repeat(count);
        let program = |count| format!("G41 D1 G1 X10 F100\nX20\n{}G90 X30\nG40 X40\nM30\n", idle(count));
        let alarm = |count| common::run(&program(count), setup).1.and_then(|alarm| alarm.id.number());
        assert_eq!((alarm(10), alarm(11)), (None, Some(42)), "{block}");
    }
}

#[test]
fn reference_points_leave_compensation_aside_in_the_plane_alone() {
    let head = "G41 D1 G1 X0 Y10 F100\nY50\n";
    let with = |bit: u8| format!("[tools.1]\nradius = 5\n[parameters]\n\"NO40.7\" = 0\n\"NO40.2\" = {bit}");
    // 4.7.2, 5: another axis than those of the plane leaves the vector as it is.
    let found = common::lines(&format!("{head}G28 Z10\nG1 X50\nY0\nG40 X0\nM30\n"), &with(1));
    assert!(
        found.contains(&"feed X55 Y55 F100".to_owned()) || found.contains(&"feed X55 F100".to_owned()),
        "{found:?}"
    );
    // 40#2 = 1: without compensation to the intermediate point; 0: with it, and from there without.
    let found = common::lines(&format!("{head}G28 X-30 Y80\nM30\n"), &with(1));
    assert!(found.contains(&"rapid X-30 Y80".to_owned()), "{found:?}");
    let found = common::lines(&format!("{head}G28 X-30 Y80\nM30\n"), &with(0));
    assert!(!found.iter().any(|line| line.contains("X-30 Y80")), "{found:?}");
    // G29: without it to the intermediate point (4.7.3, 6).
    let found = common::lines(&format!("{head}G28 X-30 Y80\nG29 X50 Y60\nG1 Y0\nG40 X0\nM30\n"), &with(1));
    assert_eq!(found.iter().filter(|line| *line == "rapid X-30 Y80").count(), 2, "{found:?}");
}

#[test]
fn the_way_back_goes_through_a_point_that_was_given() {
    // 4.3.1: the point of each axis is kept from the last G28 or G30 that named it.
    holds(&[(
        "G0 X50 Y50\nG28 X40\nG28 Y60\nG29 X20 Y30",
        &[
            "rapid X50 Y50",
            "rapid X40",
            "rapid X0",
            "home",
            "rapid Y60",
            "rapid Y0",
            "home",
            "rapid X40 Y60",
            "rapid X20 Y30",
        ],
    )]);
    for (program, fault) in [
        ("G0 X50 Y50\nG29 X60 Y60\nM30", "X60"),
        ("G0 X50 Y50\nG28 X40\nG29 X60 Y60\nM30", "Y60"),
        ("G0 X50 Y50\nG29\nM30", "G29"),
    ] {
        let (steps, alarm) = common::run(program, "");
        let alarm = alarm.unwrap();
        assert_eq!(alarm.id, AlarmId::Core(Fault::IntermediateMissing), "{program}");
        assert_eq!(common::at_fault(program, &alarm), fault, "{program}");
        assert_ne!(common::short(&steps, Position::ZERO), [""; 0], "{program}");
    }
}

#[test]
fn corners_between_moves_that_run_on() {
    // No corner to round, as on Fanuc.
    holds(&[("G1 X10 F100 ,R3\nX20", &["feed X10 F100", "feed X20 F100"])]);
    // The programmed shape is scaled, its corner too (4.2.14).
    holds_with(
        "[parameters]\n\"NO60.5\" = 1\n\"NO47.6\" = 0",
        "G51 X0 Y0 P2\nG1 X20 F100 ,R3\nY20",
        &["feed X34 F100", "xy X40 Y6 about 34 6 by 90 F100", "feed Y40 F100"],
    );
}

#[test]
fn one_way_positioning_overshoots_behind_compensation() {
    // 4.2.6: the track is that of the tool, compensation included.
    let setup = "[tools.1]\nradius = 2\n[parameters]\n\"NO40.7\" = 0\nP335 = -8";
    let found = common::lines("G41 D1 G1 X10 F100\nX20\nG60 X30\nG1 X40\nG40 X50\nM30\n", setup);
    assert_eq!(
        found[..4],
        ["feed X10 Y2 F100", "feed X20 F100", "rapid X38", "rapid X30"].map(str::to_owned),
        "{found:?}"
    );
}
