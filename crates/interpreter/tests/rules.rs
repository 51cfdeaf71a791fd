//! Small programs and the steps that the manual gives them, worked out by hand. Numbers at the cases
//! are sections of "GSK990MC programming and operation"; `31#0` is a bit parameter, `P87` a data one.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{holds, holds_turning, holds_with, lines, run};
use ferrocut_interpreter::place_variables;
use ferrocut_machine::{Fault, Memory};

#[test]
fn positioning_and_straight_cuts() {
    holds(&[
        // 4.2.1: F in a G00 block is the feed of the cuts after it.
        ("G0 X0 Y10 F800\nG1 X20 Y50", &["rapid Y10", "feed X20 Y50 F800"]),
        // 4.2.1, 3: G00 is G0; modal, so that the next block needs no code.
        ("G00X1.\nY2.\nG01Z-3.F100\nX-4.", &["rapid X1", "rapid Y2", "feed Z-3 F100", "feed X-4 F100"]),
        // 4.2.1, 2 and 4.2.2 note 2: without an axis only the mode changes.
        ("G1\nX5\nG0\nX6", &["feed X5 F300", "rapid X6"]),
        // 4.2.2, 2: F stays until the next one; the first is P87 = 300.
        ("G1 X1\nX2 F200\nG0 X3\nG1 X4", &["feed X1 F300", "feed X2 F200", "rapid X3", "feed X4 F200"]),
        // 4.2.2 note 1: P96 = 6000 is the upper limit.
        ("G1 X1 F9000", &["feed X1 F6000"]),
        // The fourth axis.
        ("G0 A90\nG1 X10 A180 F100", &["rapid A90", "feed X10 A180 F100"]),
        // A move to where the tool is moves nothing.
        ("G0 X5\nX5 Y0\nG1 X5 F10\nX6", &["rapid X5", "feed X6 F10"]),
        // 4.1 note 1: the non-modal code goes first, the modal one changes the mode and is not run.
        ("G1 G4 X2\nX5", &["dwell 2s", "feed X5 F300"]),
        // Note 3: G11 only ends G10, and the motion beside it is run.
        ("G11 G0 X5\nG11 X6\nG1 G11 X7", &["rapid X5", "rapid X6", "feed X7 F300"]),
    ]);
    // 4.2.1, 1 and 4.2.2 note 2: 31#0 makes G01 the mode at power-on. P87, P96, P97: the feeds.
    holds_with("[parameters]\n\"NO31.0\" = 1\nP87 = 150", "X5", &["feed X5 F150"]);
    holds_with("[parameters]\nP96 = 1000\nP97 = 50", "G1 X1 F2000", &["feed X1 F1000"]);
    holds_with("[parameters]\nP96 = 1000\nP97 = 50", "G1 X1 F20", &["feed X1 F50"]);
}

#[test]
fn absolute_and_incremental() {
    holds(&[
        // 4.2.4, figure 4-2-4-1: both forms are the same move from (100, 30).
        ("G0 X100 Y30\nG90 G0 X40 Y70", &["rapid X100 Y30", "rapid X40 Y70"]),
        ("G0 X100 Y30\nG91 G0 X-60 Y40", &["rapid X100 Y30", "rapid X40 Y70"]),
        // Modal, and from wherever the tool is.
        (
            "G91 X1\nX1\nG90 X1\nG91 Y-2.5\nY-2.5",
            &["rapid X1", "rapid X2", "rapid X1", "rapid Y-2.5", "rapid Y-5"],
        ),
    ]);
    // What the set-up gives a variable that stands for something else is put there.
    holds_with(
        "[variables]\n\"#5206\" = 10.0\n\"#1501\" = 4.0",
        "G54 G0 X1\nG43 H1 Z0",
        &["rapid X11", "rapid Z4"],
    );
    let mut memory = Memory::new("gsk990mc");
    memory.variables.set(5001, Some(1.0)).unwrap();
    let refused = place_variables(&ferrocut_interpreter::dialects::gsk990mc::DIALECT, memory).unwrap_err();
    assert_eq!(refused.fault, Fault::VariableNotWritable);
    // 31#4: G91 at power-on.
    holds_with("[start]\nx = 5\n[parameters]\n\"NO31.4\" = 1", "G0 X1", &["rapid X6"]);
}

#[test]
fn arcs_by_centre_and_by_radius() {
    // 4.2.3, figure 4-2-3-4: a quarter about (140, 40), then from (140, 100) about (90, 100) to
    // (120, 60), where the radius 50 points to (30, -40): atan(-40/30) = -53.1301 degrees.
    let by = [
        "rapid X200 Y40",
        "xy X140 Y100 about 140 40 by 90 F300",
        "xy X120 Y60 about 90 100 by -53.1301 F300",
    ];
    for program in [
        "G90 G0 X200 Y40 Z0\nG3 X140 Y100 R60 F300\nG2 X120 Y60 R50",
        "G0 X200 Y40 Z0\nG90 G3 X140 Y100 I-60 F300\nG2 X120 Y60 I-50",
        "G0 G90 X200 Y40 Z0\nG91 G3 X-60 Y60 R60 F300\nG2 X-20 Y-40 R50",
        "G0 G90 X200 Y40 Z0\nG91 G3 X-60 Y60 I-60 F300\nG2 X-20 Y-40 I-50",
    ] {
        holds_with("", program, &by);
    }
    // 4.2.3, 2: a half circle in three forms; the sign of R says nothing.
    for program in ["G2 X20 I10 F100", "G2 X20 R10 F100", "G2 X20 R-10 F100"] {
        holds_with("", program, &["xy X20 about 10 0 by -180 F100"]);
    }
    holds(&[
        // 4.2.3, 1, figure 4-2-3-3: chord (60, 20) of length sqrt 4000 with radius 50; the centre is
        // sqrt(2500 - 1000) = 38.7298 beside its middle (30, 10), to the right of it for the arc below
        // 180 degrees, to the left for the one above. cos of the turned angle = 1 - 4000/5000 = 0.2.
        ("G91 G02 X60 Y20 R50 F300", &["xy X60 Y20 about 42.2474 -26.7423 by -78.463 F300"]),
        ("G91 G02 X60 Y20 R-50 F300", &["xy X60 Y20 about 17.7526 46.7423 by -281.537 F300"]),
        ("G91 G03 X60 Y20 R50 F300", &["xy X60 Y20 about 17.7526 46.7423 by 78.463 F300"]),
        ("G91 G03 X60 Y20 R-50 F300", &["xy X60 Y20 about 42.2474 -26.7423 by 281.537 F300"]),
        // 4.2.3, 3: a full circle by I J, both ways.
        ("G2 I-30 F100", &["xy about -30 0 by -360 F100"]),
        ("G3 X0 Y0 I3 J4 F100", &["xy about 3 4 by 360 F100"]),
        // 4.2.3 limit 1: R goes before I J K.
        ("G2 X20 I99 J3 R10 F100", &["xy X20 about 10 0 by -180 F100"]),
        // 4.2.3 limit 5: R and no axis: the tool does not move.
        ("G2 R50 F100\nX20 R10", &["xy X20 about 10 0 by -180 F100"]),
        // The mode is arc until another one: a later block needs no code but its centre.
        (
            "G3 X10 Y10 I0 J10 F100\nX0 Y20 I-10\nG1 X5",
            &["xy X10 Y10 about 0 10 by 90 F100", "xy X0 Y20 about 0 10 by 90 F100", "feed X5 F100"],
        ),
    ]);
}

#[test]
fn arcs_in_every_plane() {
    holds(&[
        // 4.2.3, figure 4-2-3-1: G18 is seen from Y+, Z to the right and X up; centre and angle are of
        // (Z, X). From Z30 X5 about Z20 X5 to the top, Z20 X15.
        ("G0 X5 Z30\nG18 G3 X15 Z20 K-10 I0 F100", &["rapid X5 Z30", "zx X15 Z20 about 20 5 by 90 F100"]),
        ("G0 X5 Z30\nG18 G2 X15 Z20 K-10 F100", &["rapid X5 Z30", "zx X15 Z20 about 20 5 by -270 F100"]),
        ("G0 X5 Z30\nG18 G3 X15 Z20 R10 F100", &["rapid X5 Z30", "zx X15 Z20 about 20 5 by 90 F100"]),
        ("G0 X5 Z30\nG18 G2 X15 Z20 R10 F100", &["rapid X5 Z30", "zx X15 Z20 about 30 15 by -90 F100"]),
        // G19 is seen from X+, Y to the right and Z up.
        ("G0 Y30 Z5\nG19 G2 Y20 Z-5 J-10 F100", &["rapid Y30 Z5", "yz Y20 Z-5 about 20 5 by -90 F100"]),
        ("G0 Y30 Z5\nG19 G3 Y20 Z-5 J-10 F100", &["rapid Y30 Z5", "yz Y20 Z-5 about 20 5 by 270 F100"]),
        ("G0 Y30 Z5\nG19 G3 Y20 Z15 R10 F100", &["rapid Y30 Z5", "yz Y20 Z15 about 20 5 by 90 F100"]),
        ("G0 Y30 Z5\nG19 G2 K-10 F100", &["rapid Y30 Z5", "yz about 30 -5 by -360 F100"]),
        // 4.2.12: a straight move does not care for the plane.
        ("G18 G0 Y7\nG1 X1 Y1 Z1 F10", &["rapid Y7", "feed X1 Y1 Z1 F10"]),
        // The plane stays.
        (
            "G0 Z10\nG18\nG3 X10 Z0 K-10 F50\nG17 G2 X20 I5",
            &["rapid Z10", "zx X10 Z0 about 0 0 by 90 F50", "xy X20 about 15 0 by -180 F50"],
        ),
    ]);
    // 31#1 and 31#2: G18 or G19 at power-on (31#2 goes first).
    holds_with("[parameters]\n\"NO31.1\" = 1", "G2 K10 F100", &["zx about 10 0 by -360 F100"]);
    holds_with("[parameters]\n\"NO31.2\" = 1", "G2 J10 F100", &["yz about 10 0 by -360 F100"]);
}

#[test]
fn helices() {
    holds(&[
        // 4.2.3 B: the third axis climbs beside the circle; F is along the circle.
        ("G0 X10\nG3 X0 Y10 Z5 I-10 F100", &["rapid X10", "xy X0 Y10 Z5 about 0 0 by 90 F100"]),
        ("G2 I-10 Z-4 F100", &["xy Z-4 about -10 0 by -360 F100"]),
        ("G2 X20 Z-4 R10 F100", &["xy X20 Z-4 about 10 0 by -180 F100"]),
        ("G0 X5 Z30\nG18 G3 X15 Y7 Z20 K-10 F100", &["rapid X5 Z30", "zx X15 Y7 Z20 about 20 5 by 90 F100"]),
        (
            "G0 Y30 Z5\nG19 G2 X-3 Y20 Z-5 R10 F100",
            &["rapid Y30 Z5", "yz X-3 Y20 Z-5 about 20 5 by -90 F100"],
        ),
        ("G91 G3 I5 Z1 F100\nI5 Z1", &["xy Z1 about 5 0 by 360 F100", "xy Z2 about 5 0 by 360 F100"]),
    ]);
}

#[test]
fn dwell() {
    holds(&[
        // 4.2.5: X in s, P in 0.001 s (table 4-2-5-2).
        ("G4 X2.5", &["dwell 2.5s"]),
        ("G04 P1500", &["dwell 1.5s"]),
        // 2: X goes before P. 4: neither is no dwell. 1: in its block only.
        ("G4 X2 P500", &["dwell 2s"]),
        ("G4\nX1", &["rapid X1"]),
        ("G4 X1\nX1", &["dwell 1s", "rapid X1"]),
        // Seconds have no inch (4.2.17 names what changes).
        ("G20\nG4 X2", &["dwell 2s"]),
        // 34#0 = 0: seconds with G95 too.
        ("M3 S60 G95\nG4 X2\nM5", &["spindle cw 60", "dwell 2s", "spindle off"]),
    ]);
    // 5#1: P counts 0.0001 s.
    holds_with("[parameters]\n\"NO5.1\" = 1", "G4 P1500", &["dwell 0.15s"]);
    // 34#0: turns of the spindle with G95, seconds with G94.
    let turns = "[parameters]\n\"NO34.0\" = 1";
    holds_turning(turns, "G95 G4 X10\nG94 G4 X10", &["dwell 10rev", "dwell 10s"]);
}

#[test]
fn inch_and_metric() {
    holds(&[
        // 4.2.17: positions and feed; 1 inch is 25.4 mm.
        ("G20\nG1 X1 Y0.5 F10\nG21\nX50", &["feed X25.4 Y12.7 F254", "feed X50 F254"]),
        ("G20\nG2 X2 I1 F10", &["xy X50.8 about 25.4 0 by -180 F254"]),
        ("G20\nG2 X2 R1 F10", &["xy X50.8 about 25.4 0 by -180 F254"]),
        ("G20\nG91 X1\nX1", &["rapid X25.4", "rapid X50.8"]),
        // Degrees stay degrees.
        ("G20\nG0 X1 A90", &["rapid X25.4 A90"]),
        ("G20\nG92 X1\nG0 X0", &["rapid X-25.4"]),
        ("G20\nG53 X-2", &["rapid X-50.8"]),
    ]);
    // Note 3: inch words meet a point in mm to half a unit.
    holds_with("[parameters]\nP45 = 30", "G20\nG27 X1.1811", &["rapid X29.9999"]);
    // 4, 00#2: inch at power-on.
    holds_with("[parameters]\n\"NO0.2\" = 1", "X1\nG21 X1", &["rapid X25.4", "rapid X1"]);
    // A cycle's Z, R and Q are lengths, its P is time.
    holds_turning(
        "",
        "G20 G99 G82 Z-1 R0.5 P500 F10",
        &["rapid Z12.7", "feed Z-25.4 F254", "dwell 0.5s", "rapid Z12.7"],
    );
    holds_turning(
        "[parameters]\nP271 = 2",
        "G20 G99 G83 Z-1 R0 Q0.6 F10",
        &["feed Z-15.24 F254", "rapid Z0", "rapid Z-13.24", "feed Z-25.4 F254", "rapid Z0"],
    );
}

const LENGTHS: &str =
    "[tools.1]\nlength = 20\n[tools.2]\nlength = 30\n[tools.3]\nlength = 7\nlength_wear = 0.5";

#[test]
fn blocks_without_movement_in_compensation() {
    // 4.7.3, 8 b: one changes nothing, two end the move before square. Statements are no blocks there.
    let tool = "[parameters]\n\"NO40.7\" = 0\n[tools.1]\nradius = 2";
    // 4.7.4: G39 waits for the next move.
    holds_with(
        tool,
        "G0 X-10\nG1 G41 D1 X0 F100\nY10\nG39\nG4 P100\nX20\nG40 Y0",
        &[
            "rapid X-10",
            "feed X-2 F100",
            "feed Y10 F100",
            "xy X0 Y12 about 0 10 by -90 F100",
            "dwell 0.1s",
            "feed X20 F100",
            "feed Y0 F100",
        ],
    );
    for (idle, end) in [("M11\n", 18), ("#1=1\n#2=2\n#3=3\n", 18), ("M11\nM10\n", 20), ("M11\nS5\n", 20)] {
        let program = format!("G0 X-10\nG1 G41 D1 X0 F100\nX20\n{idle}Y20\nG40 X40\nM30");
        let steps = lines(&program, tool);
        let moves: Vec<&str> =
            steps.iter().map(String::as_str).filter(|step| step.contains("feed")).collect();
        let end = format!("feed X{end} F100");
        let then = if end.contains("18") { "feed Y20 F100" } else { "feed X18 Y20 F100" };
        assert_eq!(moves, ["feed X0 Y2 F100", &end, then, "feed X40 F100"], "{program}");
    }
}

#[test]
fn words_of_cycles_are_no_axes() {
    // Table 3-1-3-1: U, V and W of cycles, on a machine that has an axis of that name (P178).
    let setup = |name: u8| format!("[parameters]\nP178 = {name}\n[tools.1]\nradius = 5");
    for (name, program, axis) in [
        (8, "G22 X0 Y0 Z-5 R1 I50 L5 W2 Q2 V1 D1 F100", 'W'),
        (7, "G22 X0 Y0 Z-5 R1 I50 L5 W2 Q2 V1 D1 F100\nX9 V2", 'V'),
        (7, "M29 S100\nG84 X1 Z-5 R1 Q2 V1 F100", 'V'),
    ] {
        let steps = lines(&format!("M3 S100\n{program}\nG80\nM30"), &setup(name));
        assert!(steps.len() > 6 && steps.iter().all(|step| !step.contains(axis)), "{program}: {steps:?}");
    }
    // Beside no cycle it is the axis.
    holds_with(&setup(8), "G0 W2", &["rapid W2"]);
}

#[test]
fn tool_length() {
    let cases: &[(&str, &[&str])] = &[
        // 4.7.1, 2: a new number replaces the offset of the old one.
        ("G90 G43 Z100 H01\nG90 G43 Z100 H02", &["rapid Z120", "rapid Z130"]),
        // 1: G44 takes it off; the offset is the sum of geometry and wear.
        ("G44 Z100 H1", &["rapid Z80"]),
        ("G43 Z100 H3", &["rapid Z107.5"]),
        // 3: a new H acts at once in the mode; G49 at the end of its block.
        ("G43 Z10 H01\nG44 Z20 H02\nZ30 H03\nG49", &["rapid Z30", "rapid Z-10", "rapid Z22.5", "rapid Z30"]),
        // 4 note 2: without Z it is taken up and dropped where the tool stands.
        ("G0 Z5\nG43 H1\nX1\nG49\nX2", &["rapid Z5", "rapid Z25", "rapid X1", "rapid Z5", "rapid X2"]),
        // 4: H00 waits for the axis or for a code of its group.
        ("G43 Z0 H1\nH0\nX1\nZ0", &["rapid Z20", "rapid X1", "rapid Z0"]),
        ("G43 Z0 H1\nH0\nG43\nX1", &["rapid Z20", "rapid Z0", "rapid X1"]),
        ("G43 Z10 H1\nZ0 H0", &["rapid Z30", "rapid Z0"]),
        // H alone without G43 or G44 does nothing.
        ("H1\nZ5", &["rapid Z5"]),
        // Incremental: the end point is shifted, not the way.
        ("G91 G43 Z-5 H1\nZ-5", &["rapid Z15", "rapid Z10"]),
        // Cuts are shifted too, and arcs square to the offset as a whole.
        ("G43 H1\nG18 G2 X20 R10 F100", &["rapid Z20", "zx X20 about 20 10 by -180 F100"]),
    ];
    for (program, expected) in cases {
        holds_with(LENGTHS, program, expected);
    }
    // 4.7.1, 5: the manual's example, H01 = -4.
    holds_with(
        "[tools.1]\nlength = -4",
        "N1 G91 G00 X120 Y80\nN2 G43 Z-32 H01\nN3 G01 Z-21 F200\nN4 G04 P2000\nN5 G00 Z21\nN6 X30 Y-50\n\
         N7 G01 Z-41 F200\nN8 G00 Z41\nN9 X50 Y30\nN10 G01 Z-25 F100\nN11 G04 P2000\nN12 G00 Z57 H00\n\
         N13 X-200 Y-60",
        &[
            "rapid X120 Y80",
            "rapid Z-36",
            "feed Z-57 F200",
            "dwell 2s",
            "rapid Z-36",
            "rapid X150 Y30",
            "feed Z-77 F200",
            "rapid Z-36",
            "rapid X200 Y60",
            "feed Z-61 F100",
            "dwell 2s",
            "rapid Z0",
            "rapid X0 Y0",
        ],
    );
    // 4.7.1, method B (39#0 = 1): the axis square to the plane; G49 drops every axis, H00 that one.
    holds_with(LENGTHS, "G18 G43 Y5 H1", &["rapid Y25"]);
    holds_with(LENGTHS, "G19 G44 X5 H1", &["rapid X-15"]);
    holds_with(LENGTHS, "G43 H1\nG18 G43 H2\nG49", &["rapid Z20", "rapid Y30", "rapid Y0 Z0"]);
    holds_with(LENGTHS, "G43 H1\nG18 G43 H2\nY0 H0", &["rapid Z20", "rapid Y30", "rapid Y0"]);
    // Method A (39#0 = 0): Z in every plane.
    let a = format!("{LENGTHS}\n[parameters]\n\"NO39.0\" = 0");
    holds_with(&a, "G18 G43 Y5 Z5 H1", &["rapid Y5 Z25"]);
    // 4.3.1: G28 ends it, a length of 0 too; what the block itself calls is in force behind it (4.1 note 1).
    let home = |first: &str, through: &str, last: &str| {
        [first, through, "rapid Z0", "home", last].map(str::to_owned)
    };
    for (program, steps) in [
        ("G43 H1 Z5\nG28 Z20 G43 H2\nG0 Z10", home("rapid Z25", "rapid Z40", "rapid Z40")),
        ("G43 H1 Z5\nG28 Z20\nG0 Z10 H2", home("rapid Z25", "rapid Z40", "rapid Z10")),
        ("G43 H9 Z5\nG28 Z20\nG0 Z10 H2", home("rapid Z5", "rapid Z20", "rapid Z10")),
    ] {
        holds_with(LENGTHS, program, &steps.each_ref().map(String::as_str));
    }
}

#[test]
fn machine_position() {
    let zero = "[work_offsets]\nG54 = { x = 10, y = 5 }\n[tools.1]\nlength = 20";
    let cases: &[(&str, &[&str])] = &[
        // 4.2.10: rapid to the machine position; in its block only, the system in force stays.
        ("G0 X5\nG53 X-20\nX5", &["rapid X15", "rapid X-20", "rapid X15"]),
        ("G1 X5 F100\nG53 X-20 Y0\nX5", &["feed X15 F100", "rapid X-20", "feed X15 F100"]),
        // Limit: with G91 it is left out.
        ("G91 X1\nG53 X-20\nX1", &["rapid X1", "rapid X2"]),
        // Note: tool length is left aside and taken up again by the next move of its axis.
        ("G43 Z10 H1\nG53 Z0\nX0\nZ10", &["rapid Z30", "rapid Z0", "rapid X10", "rapid Z30"]),
        ("G53", &[]),
    ];
    for (program, expected) in cases {
        holds_with(zero, program, expected);
    }
}

#[test]
fn work_offsets() {
    let table = "[work_offsets]\nG54 = { x = 10, y = 10, z = 10 }\nG55 = { x = 30, y = 30, z = 30 }";
    // Table 4-2-8-1: an axis that is not named keeps its machine position.
    holds_with(
        table,
        "G0 G54 X50 Y50 Z50\nG55 X100 Y100\nX120 Z80",
        &["rapid X60 Y60 Z60", "rapid X130 Y130", "rapid X150 Z110"],
    );
    // 4.2.8: the call alone moves nothing, but changes what an incremental move does not.
    holds_with(table, "X0\nG55\nG91 X5\nG90 X5", &["rapid X10", "rapid X15", "rapid X35"]);
    for n in 1..=6 {
        let code = 53 + n;
        let setup = format!("[work_offsets]\nG{code} = {{ x = {n}, a = 90 }}\nexternal = {{ x = 100 }}");
        // 4.2.8: P10 to P13, the external offset, shift every system.
        let expected = format!("rapid X{} A91", 101 + n);
        holds_with(&setup, &format!("G{code} X1 A1"), &[&expected]);
    }
    // 4.2.9: additional systems P1 to P50.
    let more = "[work_offsets]\n\"G54 P1\" = { x = 1 }\n\"G54 P50\" = { x = 50 }";
    holds_with(more, "G54 P1 X0\nG54 P50 X0\nG54 X3", &["rapid X1", "rapid X50", "rapid X3"]);
    // P beside a cycle is its dwell where it has one (table 4-1-2), else it names the system.
    let bored = ["rapid Z5", "rapid X2", "rapid Z1", "feed Z-1 F100", "feed Z1 F100", "rapid Z5"];
    holds_turning(more, "G0 Z5\nG54 P1 G85 X1 Z-1 R1 F100", &bored);
    let counterbored = ["rapid Z5", "rapid X1", "rapid Z1", "feed Z-1 F100", "dwell 0.25s", "rapid Z5"];
    holds_turning(more, "G0 Z5\nG54 P1 G82 X1 Z-1 R1 F100", &counterbored);
    // Arcs are shifted as a whole.
    holds_with(table, "G55 X0 Y0\nG2 X20 I10 F100", &["rapid X30 Y30", "xy X50 about 40 30 by -180 F100"]);
    // P10 and P15 are other names of the external offset and of G54 (appendix 1).
    holds_with("[parameters]\nP10 = 5\nP15 = 2", "X1", &["rapid X8"]);
}

#[test]
fn floating_system() {
    holds(&[
        // 4.2.11: no move; the tool stands at the given point from then on.
        ("G92 X25 Z23\nX0\nZ0", &["rapid X-25", "rapid Z-23"]),
        ("X10 Y10\nG92 X0\nX5 Y5", &["rapid X10 Y10", "rapid X15 Y5"]),
        // 1, 1): in force until a system of the table is called.
        ("G92 X25\nX0\nG54\nX0", &["rapid X-25", "rapid X0"]),
        ("G92 X25\nG91 X1\nG92 X0\nG90 X1", &["rapid X1", "rapid X2"]),
    ]);
    // Note 1: tool length is left aside, the point before it gets the coordinates.
    holds_with(LENGTHS, "G43 Z0 H1\nG92 Z5\nG49\nZ5\nZ0", &["rapid Z20", "rapid Z0", "rapid Z-5"]);
    // It has nothing to do with the work offset in force (1).
    let zero = "[work_offsets]\nG54 = { x = 100 }";
    holds_with(zero, "X0\nG92 X1\nX0\nG55 X0", &["rapid X100", "rapid X99", "rapid X0"]);
}

#[test]
fn feed_modes() {
    // 7.2: G94 at power-on; G95 in mm a turn. Each has its own F.
    holds_turning(
        "",
        "G1 X1 F100\nG95 X2 F0.2\nX3\nG94 X4\nG95 X5",
        &["feed X1 F100", "feed X2 0.2/rev", "feed X3 0.2/rev", "feed X4 F100", "feed X5 0.2/rev"],
    );
    holds_turning("", "G95 G3 X10 R5 F0.1", &["xy X10 about 5 0 by 180 0.1/rev"]);
    holds_turning("", "G20 G95 G1 X1 F0.01", &["feed X25.4 0.254/rev"]);
    // 13#1 tells of an encoder; without one 13#0 says whether there is a feed per revolution (alarm 0014).
    for (encoder, without, is_there) in [(1, 0, true), (1, 1, true), (0, 1, true), (0, 0, false)] {
        let setup = format!("[parameters]\n\"NO13.1\" = {encoder}\n\"NO13.0\" = {without}");
        if is_there {
            holds_turning(&setup, "G95 G1 X1 F0.2", &["feed X1 0.2/rev"]);
        } else {
            let (_, alarm) = common::run("M3 S1000\nG95 G1 X1 F0.2\nM30\n", &setup);
            assert_eq!(alarm.and_then(|alarm| alarm.id.number()), Some(14), "{setup}");
        }
    }
}

#[test]
fn drilling() {
    let cases: &[(&str, &[&str])] = &[
        // 4.4, figure 4-4-1 and 4.4.2: over the hole, to R, cut, back. G98 at power-on, to the level of
        // before the cycle; G99 to R.
        (
            "G0 Z50\nG81 X10 Y20 Z-10 R5 F100",
            &["rapid Z50", "rapid X10 Y20", "rapid Z5", "feed Z-10 F100", "rapid Z50"],
        ),
        (
            "G0 Z50\nG99 G81 X10 Z-10 R5 F100\nX20\nG98 X30\nX40",
            &[
                "rapid Z50",
                "rapid X10",
                "rapid Z5",
                "feed Z-10 F100",
                "rapid Z5",
                "rapid X20",
                "feed Z-10 F100",
                "rapid Z5",
                "rapid X30",
                "feed Z-10 F100",
                // 4.4 B: the initial level does not change while holes are cut with G99.
                "rapid Z50",
                "rapid X40",
                "rapid Z5",
                "feed Z-10 F100",
                "rapid Z50",
            ],
        ),
        // 4.4 A: with G91, R from the initial level, Z from R, the hole from the one before; K repeats.
        (
            "G0 Z50\nG91 G99 G81 X10 Z-15 R-45 K3 F100",
            &[
                "rapid Z50",
                "rapid X10",
                "rapid Z5",
                "feed Z-10 F100",
                "rapid Z5",
                "rapid X20",
                "feed Z-10 F100",
                "rapid Z5",
                "rapid X30",
                "feed Z-10 F100",
                "rapid Z5",
            ],
        ),
        // Table 4-4-1: K0 changes the mode only, a negative K counts by its amount, K is in force in
        // its block only.
        ("G99 G81 Z-10 R0 K0 F100\nX5", &["rapid X5", "feed Z-10 F100", "rapid Z0"]),
        (
            "G91 G99 G81 X5 Z-10 R0 K-2 F100\nX1",
            &[
                "rapid X5",
                "feed Z-10 F100",
                "rapid Z0",
                "rapid X10",
                "feed Z-10 F100",
                "rapid Z0",
                "rapid X11",
                "feed Z-10 F100",
                "rapid Z0",
            ],
        ),
        // 4.4: Z or R missing in the first hole: no move of Z.
        ("G81 X5 R0 F100\nX6 Z-1", &["rapid X5", "rapid X6", "feed Z-1 F100", "rapid Z0"]),
        ("G81 X5 Z-1 F100", &["rapid X5"]),
        // 4.4.7: no hole in a block without an axis.
        (
            "G81 X5 Z-1 R0 F100\nM8\nF200\nM9",
            &["rapid X5", "feed Z-1 F100", "rapid Z0", "coolant on", "coolant off"],
        ),
        // 4.4 limits: F of the cycle stays after it; G80 and a code of group 01 end it (4.1 note 6).
        (
            "G81 X5 Z-1 R0 F70\nG80\nG1 X6\nX7",
            &["rapid X5", "feed Z-1 F70", "rapid Z0", "feed X6 F70", "feed X7 F70"],
        ),
        ("G81 X5 Z-1 R0 F70\nG0 X6\nX7", &["rapid X5", "feed Z-1 F70", "rapid Z0", "rapid X6", "rapid X7"]),
        ("G81 X5 Z-1 R0 F70\nG80 X6\nX7", &["rapid X5", "feed Z-1 F70", "rapid Z0", "rapid X6", "rapid X7"]),
        // 4.4.2 limit: with a code of group 01 in its block the cycle is not begun.
        ("G1 G81 X5 Z-1 R0 F70\nX6", &["feed X5 Z-1 F70", "feed X6 F70"]),
        // 4.4.12: G80 forgets R and Z; the cycle after it needs them again.
        ("G81 X5 Z-1 R0 F70\nG80\nG81 X6", &["rapid X5", "feed Z-1 F70", "rapid Z0", "rapid X6"]),
        // 4.4.2: an M code runs with the way to the first hole, once.
        (
            "G91 G81 X5 Z-1 R0 K2 M8 F70\nM9",
            &[
                "coolant on",
                "rapid X5",
                "feed Z-1 F70",
                "rapid Z0",
                "rapid X10",
                "feed Z-1 F70",
                "rapid Z0",
                "coolant off",
            ],
        ),
        // 4.4.2 note: M00 and its kin after the last hole.
        (
            "G91 G81 X5 Z-1 R0 K2 M0 F70",
            &["rapid X5", "feed Z-1 F70", "rapid Z0", "rapid X10", "feed Z-1 F70", "rapid Z0", "stop M00"],
        ),
    ];
    for (program, expected) in cases {
        holds_turning("", program, expected);
    }
    // 4.4.2: tool length in the cycle's block is taken up on the way to R, alone at once.
    holds_turning(
        "[tools.1]\nlength = 20",
        "G0 Z50\nG99 G43 H1 G81 X5 Z-1 R5 F100\nG49",
        &["rapid Z50", "rapid X5", "rapid Z25", "feed Z19 F100", "rapid Z25", "rapid Z5"],
    );
}

#[test]
fn holes_with_dwell() {
    let g82 = |p: &str| format!("G99 G82 X5 Z-10 R2 {p} F100");
    // 4.4.3: P in ms at the bottom; from P281 = 250 to P282 = 9999.
    for (p, dwell) in [("P1000", "dwell 1s"), ("P50", "dwell 0.25s"), ("P20000", "dwell 9.999s")] {
        holds_turning("", &g82(p), &["rapid X5", "rapid Z2", "feed Z-10 F100", dwell, "rapid Z2"]);
    }
    let limits = "[parameters]\nP281 = 500\nP282 = 1500";
    for (p, dwell) in [("P100", "dwell 0.5s"), ("P1000", "dwell 1s"), ("P2000", "dwell 1.5s")] {
        holds_turning(limits, &g82(p), &["rapid X5", "rapid Z2", "feed Z-10 F100", dwell, "rapid Z2"]);
    }
    // 4.4.3: P is modal.
    holds_turning(
        "",
        "G82 X5 Z-1 R0 P500 F100\nX6",
        &[
            "rapid X5",
            "feed Z-1 F100",
            "dwell 0.5s",
            "rapid Z0",
            "rapid X6",
            "feed Z-1 F100",
            "dwell 0.5s",
            "rapid Z0",
        ],
    );
    // 4.4.11: G89 is G85 with a dwell.
    holds_turning(
        "",
        "G99 G89 X5 Z-10 R2 P1000 F100",
        &["rapid X5", "rapid Z2", "feed Z-10 F100", "dwell 1s", "feed Z2 F100"],
    );
}

#[test]
fn pecked_holes() {
    // 4.4.4, figure 4-4-4-1: Q a step; out to R, back to d (P271 = 2) above the bottom.
    let g83 = [
        "rapid X5",
        "rapid Z2",
        "feed Z-6 F100",
        "rapid Z2",
        "rapid Z-4",
        "feed Z-14 F100",
        "rapid Z2",
        "rapid Z-12",
        "feed Z-20 F100",
        "rapid Z2",
    ];
    holds_turning("", "G99 G83 X5 Z-20 R2 Q8 F100", &g83);
    // The sign of Q is left aside.
    holds_turning("", "G99 G83 X5 Z-20 R2 Q-8 F100", &g83);
    holds_turning(
        "[parameters]\nP271 = 0.5",
        "G99 G83 X5 Z-10 R2 Q8 F100",
        &["rapid X5", "rapid Z2", "feed Z-6 F100", "rapid Z2", "rapid Z-5.5", "feed Z-10 F100", "rapid Z2"],
    );
    // 4.4.1, figure 4-4-1-1: drawn back by d (P270 = 2) after each step.
    holds_turning(
        "",
        "G0 Z50\nG98 G73 X5 Z-20 R2 Q8 F100",
        &[
            "rapid Z50",
            "rapid X5",
            "rapid Z2",
            "feed Z-6 F100",
            "rapid Z-4",
            "feed Z-14 F100",
            "rapid Z-12",
            "feed Z-20 F100",
            "rapid Z50",
        ],
    );
    holds_turning(
        "[parameters]\nP270 = 0.5",
        "G99 G73 Z-10 R0 Q6 F100",
        &["feed Z-6 F100", "rapid Z-5.5", "feed Z-10 F100", "rapid Z0"],
    );
    // A step that ends on the bottom is the last one.
    holds_turning(
        "",
        "G99 G83 Z-10 R0 Q5 F100",
        &["feed Z-5 F100", "rapid Z0", "rapid Z-3", "feed Z-10 F100", "rapid Z0"],
    );
    // 4.4.1 note 2: with 43#1 = 0 a hole without Q is positioned and not drilled; Q is modal.
    let tolerant = "[parameters]\n\"NO43.1\" = 0";
    holds_turning(
        tolerant,
        "G99 G83 X5 Z-10 R2 F100\nX6 Q20",
        &["rapid X5", "rapid X6", "rapid Z2", "feed Z-10 F100", "rapid Z2"],
    );
}

#[test]
fn boring() {
    // 4.4.7: fed out to R, then rapid to the initial level.
    holds_turning(
        "",
        "G0 Z50\nG85 X5 Z-10 R2 F100\nG99 X6",
        &[
            "rapid Z50",
            "rapid X5",
            "rapid Z2",
            "feed Z-10 F100",
            "feed Z2 F100",
            "rapid Z50",
            "rapid X6",
            "rapid Z2",
            "feed Z-10 F100",
            "feed Z2 F100",
        ],
    );
    // 4.4.8: the spindle stops at the bottom and turns again at the top, the way it did.
    holds_turning(
        "",
        "G0 Z50\nG86 X5 Z-10 R2 F100",
        &[
            "rapid Z50",
            "rapid X5",
            "rapid Z2",
            "feed Z-10 F100",
            "spindle off",
            "rapid Z50",
            "spindle cw 1000",
        ],
    );
}

#[test]
fn hole_data_are_modal() {
    // Table 4-4-2, with numbers: 1 to 9.
    holds_turning(
        "",
        "G00 X10 M3\nG81 X20 Y5 Z-5 R2 F100\nY15\nG82 X30 P1000\nG80 X40 Y0\nG85 X50 Z-6 R3 P500\nX60 Z-7\n\
         G89 X70 Y1\nG01 X80 Y0",
        &[
            "rapid X10",
            // 2
            "rapid X20 Y5",
            "rapid Z2",
            "feed Z-5 F100",
            "rapid Z0",
            // 3
            "rapid Y15",
            "rapid Z2",
            "feed Z-5 F100",
            "rapid Z0",
            // 4
            "rapid X30",
            "rapid Z2",
            "feed Z-5 F100",
            "dwell 1s",
            "rapid Z0",
            // 5
            "rapid X40 Y0",
            // 6: P is kept
            "rapid X50",
            "rapid Z3",
            "feed Z-6 F100",
            "feed Z3 F100",
            "rapid Z0",
            // 7
            "rapid X60",
            "rapid Z3",
            "feed Z-7 F100",
            "feed Z3 F100",
            "rapid Z0",
            // 8
            "rapid X70 Y1",
            "rapid Z3",
            "feed Z-7 F100",
            "dwell 0.5s",
            "feed Z3 F100",
            "rapid Z0",
            // 9
            "feed X80 Y0 F100",
        ],
    );
}

#[test]
fn numbers_of_parameters_are_none_of_blocks() {
    holds(&[
        // 3.1.2 note: N beside G10 is no sequence number, nor is it among the parameters.
        ("GOTO271\nN271 G10 L51 R3\nG11\nN271 X5", &["rapid X5"]),
        ("GOTO271\nG10 L51\nN271 R3\nN272 R1\nG11\nN271 X5", &["rapid X5"]),
        ("GOTO5\nG10 L50\nN5 P1 R0\nG11\nX9\nN5 X5", &["rapid X5"]),
        ("GOTO7\nN7 G10 L10 P1 R5\nX9\nN7 X5", &["rapid X5"]),
        // Behind G11, and behind other forms of G10, lines have numbers again.
        ("GOTO7\nX9\nG10 L2 P1 X0\nN7 X5", &["rapid X5"]),
        ("GOTO7\nX9\nG10 L51\nN271 R3\nN7 G11\nX5", &["rapid X5"]),
        // A line number alone opens the input, as on Fanuc, and sets nothing. Of two the last is the parameter.
        ("N7 G10 L51\nN271 R3\nN8 G11\nX5", &["rapid X5"]),
    ]);
    holds_turning(
        "",
        "N10 G10 L51 N271 R3\nN20 G11\nG99 G83 X1 Z-9 R0 Q5 F100",
        &["rapid X1", "feed Z-5 F100", "rapid Z0", "rapid Z-2", "feed Z-9 F100", "rapid Z0"],
    );
    let (_, alarm) = common::run("GOTO271\nN271 G10 L51 R3\nG11\nM30", "");
    assert_eq!(alarm.unwrap().fault, Fault::SequenceMissing);
}

#[test]
fn machine_functions_and_their_moment() {
    holds(&[
        // 5.1: codes of the machine start with the move of their block.
        ("G0 X10 M3 S500\nX20 M5", &["spindle cw 500", "rapid X10", "spindle off", "rapid X20"]),
        ("G0 X10 M4 S500\nX20 M5", &["spindle ccw 500", "rapid X10", "spindle off", "rapid X20"]),
        ("X1 M8\nX2 M9", &["coolant on", "rapid X1", "coolant off", "rapid X2"]),
        ("X1 M10\nM11", &["M10", "rapid X1", "M11"]),
        // 5.1.2: M05 keeps S.
        ("M3 S500\nM5\nM4\nM5", &["spindle cw 500", "spindle off", "spindle ccw 500", "spindle off"]),
        // A new S with the spindle turning.
        ("M3 S500\nS800\nM5", &["spindle cw 500", "spindle cw 800", "spindle off"]),
        // P258 = 6000 is the highest speed.
        ("M3 S9000\nM5", &["spindle cw 6000", "spindle off"]),
        ("M3 S6001\nM5", &["spindle cw 6000", "spindle off"]),
        // 4.4.1 note 1: M06 after the move.
        ("T2 X10 M6", &["select 2", "rapid X10", "change 2"]),
        ("T2\nT3 M6\nM6", &["select 2", "select 3", "change 3"]),
        // 5.2: M00 after the move; the program goes on behind it.
        ("G1 X10 F100 M00\nX20", &["feed X10 F100", "stop M00", "feed X20 F100"]),
        // 5.2.3: M01 does nothing with the switch off.
        ("X10 M01\nX20", &["rapid X10", "rapid X20"]),
        // 33#7: up to three M codes in a block.
        ("M3 M8 M10 S10\nM5 M9", &["spindle cw 10", "coolant on", "M10", "spindle off", "coolant off"]),
    ]);
    holds_with("[options]\noptional_stop = true", "X10 M01\nX20", &["rapid X10", "stop M01", "rapid X20"]);
    // 5.2.1: the end stops spindle and coolant, after the move of its block. What follows is not run.
    for (code, end) in [("M30", "end M30"), ("M02", "end M02")] {
        let program = format!("M3 S100\nM8\nX5 {code}\nX6\n");
        let expected = ["spindle cw 100", "coolant on", "rapid X5", "spindle off", "coolant off", end];
        assert_eq!(lines(&program, ""), expected);
    }
}

#[test]
fn skipped_blocks() {
    // Operation part, chapter 10 note 2: one `/` by the operator's switch, two always.
    holds(&[("/X1\n//X2\nX3", &["rapid X1", "rapid X3"])]);
    holds_with("[options]\nblock_skip = true", "/X1\n//X2\nX3\n/M30\nX4", &["rapid X3", "rapid X4"]);
}

#[test]
fn subprograms() {
    // 3.2.2: L times, once without L.
    let program = "O1\nM98 P1002 L3\nM98 P1002\nX0\nM30\nO1002\nG91 X1\nG90\nM99\n";
    assert_eq!(lines(program, ""), ["rapid X1", "rapid X2", "rapid X3", "rapid X4", "rapid X0", "end M30"]);
    // 5.2.4, 5.2 note 1: after the move of its block.
    let program = "O1\nX5 M98 P2\nX7\nM30\nO2\nX6\nM99\n";
    assert_eq!(lines(program, ""), ["rapid X5", "rapid X6", "rapid X7", "end M30"]);
    // 3.2: M02 and M30 in a subprogram are M99; its last block may move first.
    for end in ["M99", "M30", "M02"] {
        let program = format!("O1\nM98 P2\nX7\nM30\nO2\nX6 {end}\nX8\n");
        assert_eq!(lines(&program, ""), ["rapid X6", "rapid X7", "end M30"], "{end}");
    }
    // 3.2.2 note 3, figure 3-2-2: four levels, each goes on behind its call.
    let program = "O1\nM98 P10\nX1\nM30\nO10\nM98 P20\nX10\nM99\nO20\nM98 P30\nX20\nM99\n\
                   O30\nM98 P40\nX30\nM99\nO40\nX40\nM99\n";
    assert_eq!(
        lines(program, ""),
        ["rapid X40", "rapid X30", "rapid X20", "rapid X10", "rapid X1", "end M30"]
    );
    // Modal state is one for all programs.
    let program = "O1\nM98 P2\nX2\nM30\nO2\nG91 G1 X1 F50\nM99\n";
    assert_eq!(lines(program, ""), ["feed X1 F50", "feed X3 F50", "end M30"]);
    // 3.2.2: calls repeat within repeats, 2 × 3 times.
    let program = "O1\nM98 P2 L2\nM30\nO2\nM98 P3 L3\nM99\nO3\nG91 X1\nM99\n";
    let found = lines(program, "");
    assert_eq!((found.len(), found[5].as_str()), (7, "rapid X6"));
    // 3.2.2: L0 calls nothing; numbers are the same with leading zeros.
    let program = "O0001\nM98 P0002 L0\nM98 P02\nM30\nO2\nX1\nM99\n";
    assert_eq!(lines(program, ""), ["rapid X1", "end M30"]);
}

#[test]
fn main_program_that_ends_with_m99_repeats() {
    // 3.2.3, 5.2.5: again from its start. At a desk one pass is enough, whatever the next one begins with.
    for (program, pass) in [
        ("O1\nG90 G0 X10\nX0\nM99\n", &["rapid X10", "rapid X0"][..]),
        ("O1\n#500=#500+1\nG91 G0 X10\nG92 X0\nM99\n", &["rapid X10"]),
        ("O1\nIF[#500 LT 0]GOTO9\n#500=#500+1\nG0 X#500\nM99\nN9 M30\n", &["rapid X1"]),
    ] {
        assert_eq!(lines(program, ""), [pass, &["end M99"]].concat(), "{program}");
    }
    // A pass that comes to an end of its own is run.
    let program = "O1\nIF[#500 EQ 2]GOTO9\n#500=#500+1\nG0 X#500\nM99\nN9 M30\n";
    assert_eq!(lines(program, "[variables]\n\"#500\" = 0"), ["rapid X1", "rapid X2", "end M30"]);
    // On a machine it runs until it is stopped.
    let options = ferrocut_interpreter::Options { loops_forever: true, ..Default::default() };
    let interpreter = common::interpreter(b"O1\nX10\nX0\nM99\n", "", options).unwrap_or_else(|| panic!());
    assert_eq!(interpreter.take(10_001).filter(Result::is_ok).count(), 10_001);
}

#[test]
fn spans_name_the_block_and_its_line() {
    let program = "O1 (LINE 1)\nG0 X1\n\nM3 S10\nG81 X2 Z-1 R0 F10 (HOLE)\nM98 P2\nM30\nO2\nG1 X3\nM99\n";
    let (steps, alarm) = common::run(program, "");
    assert_eq!(alarm, None);
    let found: Vec<(u32, &str)> = steps
        .iter()
        .map(|s| {
            let at = usize::try_from(s.span.offset).unwrap_or(usize::MAX);
            (s.span.line, program[at..at + s.span.len as usize].trim())
        })
        .collect();
    // The moves of a cycle are those of its block, the steps of a subprogram those of its own blocks.
    let hole = (5, "G81 X2 Z-1 R0 F10 (HOLE)");
    let starts =
        |found: (u32, &str), expected: (u32, &str)| found.0 == expected.0 && expected.1.starts_with(found.1);
    let expected = [(2, "G0 X1"), (4, "M3 S10"), hole, hole, hole, (9, "G1 X3"), (7, "M30"), (7, "M30")];
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for (found, expected) in found.into_iter().zip(expected) {
        assert!(starts(found, expected), "{found:?} for {expected:?}");
    }
}

/// 4.2.18 in the planes G18 and G19, without compensation.
#[test]
fn corners_in_every_plane() {
    holds(&[
        ("G18 G1 Z20 ,R5 F100\nX20", &["feed Z15 F100", "zx X5 Z20 about 15 5 by 90 F100", "feed X20 F100"]),
        ("G19 G1 Y20 ,R5 F100\nZ20", &["feed Y15 F100", "yz Y20 Z5 about 15 5 by 90 F100", "feed Z20 F100"]),
        ("G19 G1 Y20 ,L5 F100\nZ20", &["feed Y15 F100", "feed Y20 Z5 F100", "feed Z20 F100"]),
    ]);
}

/// Chapter 5: a code and the move behind a corner stand in one block; a block without a move is none (alarm 51).
#[test]
fn codes_stand_beside_the_move_behind_a_corner() {
    let arc = "xy X20 Y5 about 15 5 by 90 F100";
    holds(&[
        ("G1 X20 ,R5 F100\nY20 M8", &["feed X15 F100", arc, "coolant on", "feed Y20 F100", "coolant off"]),
        ("G1 X20 ,R5 F100\nY20 T2", &["feed X15 F100", arc, "select 2", "feed Y20 F100"]),
    ]);
    // A code of the corner's own block says nothing of the blocks behind it.
    holds(&[("G1 X20 ,R5 F100 M0\nG90\nY20", &["feed X15 F100", arc, "stop M00", "feed Y20 F100"])]);
    for between in ["M8", "G4 X1", "T2"] {
        let (_, alarm) = run(&format!("G1 X20 ,R5 F100\n{between}\nY20\nM30"), "");
        let alarm = alarm.unwrap();
        assert_eq!((alarm.fault, alarm.span.line), (Fault::CornerWithoutMove, 1), "{between}");
    }
}

/// 4.2.18 with 4.7: compensation that the block behind a corner changes holds from its own move on, as where the corner is
/// written out in blocks.
#[test]
fn compensation_changes_behind_a_corner() {
    let setup =
        "[start]\nx = -10\n[tools.1]\nradius = 2\n[tools.2]\nradius = 4\n[parameters]\n\"NO40.7\" = 0";
    for (before, behind) in [
        ("G41 D1 G1 X0 Y0 F100", "G40 Y-20"),
        ("G1 X0 Y0 F100", "G41 D1 Y-20\nX0\nG40 X-20"),
        ("G41 D1 G1 X0 Y0 F100", "G42 Y-20\nX0\nG40 X-20"),
        ("G41 D1 G1 X0 Y0 F100", "D2 Y-20\nX0\nG40 X-20"),
        ("G41 D1 G1 X0 Y0 F100", "G41 Y-20\nX0\nG40 X-20"),
        ("G41 D1 G1 X0 Y0 F100", "G40\nY-20"),
        ("G41 D1 G1 X0 Y0 F100", "G40\nG42\nY-20\nX0\nG40 X-20"),
        ("G41 D1 G1 X0 Y0 F100", "Y-20 ,L5\nG40 X0"),
    ] {
        let corner = lines(&format!("{before}\nX20 ,L5\n{behind}\nM30"), setup);
        let written = lines(
            &format!("{before}\nX15\nX20 Y-5\n{}\nM30", behind.replace("Y-20 ,L5", "Y-15\nX15 Y-20")),
            setup,
        );
        assert_eq!(corner, written, "{before}, {behind}");
    }
}

/// 4.6.1: R of a milling cycle under G91 counts from where its block begins.
#[test]
fn the_level_of_a_milling_cycle_counts_from_its_block() {
    let setup = "[tools.1]\nradius = 2\n[parameters]\n\"NO40.7\" = 0";
    let program = "M3 S100\nG0 Z50\nG91 G99 G24 X50 Y0 Z-10 R-40 I20 J5 D1 F100\nX50 Y0 R-2 Z-5\nM30";
    let found = lines(program, setup);
    let behind = found.iter().rposition(|line| line.starts_with("rapid X")).unwrap();
    assert!(found[behind + 1..].contains(&"rapid Z8".to_owned()), "{found:?}");
    assert!(found[behind + 1..].iter().any(|line| line.starts_with("feed Z3 ")), "{found:?}");
}

#[test]
fn vectors_that_are_ignored_at_corners() {
    let setup = |limit: u32| format!("[tools.1]\nradius = 5\n[parameters]\n\"NO40.7\" = 0\nP266 = {limit}");
    for (limit, program, steps) in [
        // Appendix 1, P266: outside corners alone. Inside, the crossings are where they are.
        (
            5,
            "G0 X-20 Y20\nG1 G41 D1 X0 Y0 F100\nX40\nY40\nX0\nG40 Y20",
            &[
                "rapid X-20 Y20",
                "feed X0 Y5 F100",
                "feed X35 F100",
                "feed Y35 F100",
                "feed X0 F100",
                "feed Y20 F100",
            ][..],
        ),
        // 4.7.3, 9: back by 45 degrees, both lines carried on by 5: (45, -5) and (40, 0) + 5 (1, 1) / sqrt 2 + 5 (1, -1)
        // / sqrt 2 = (47.0711, 0). The later of them is ignored.
        (
            6,
            "G1 G42 D1 X10 F100\nX40\nX20 Y20\nG40 X0",
            &["feed X10 Y-5 F100", "feed X45 F100", "feed X23.5355 Y23.5355 F100", "feed X0 Y20 F100"][..],
        ),
        (
            4,
            "G1 G42 D1 X10 F100\nX40\nX20 Y20\nG40 X0",
            &[
                "feed X10 Y-5 F100",
                "feed X45 F100",
                "feed X47.0711 Y0 F100",
                "feed X23.5355 Y23.5355 F100",
                "feed X0 Y20 F100",
            ][..],
        ),
        // A half circle goes on from (45, -5), atan(5 / 25) = 11.3099 degrees before its start.
        (
            6,
            "G1 G42 D1 X10 F100\nX40\nG3 X0 R20\nG1 Y-30\nG40 X30",
            &[
                "feed X10 Y-5 F100",
                "feed X45 F100",
                "xy X-5 Y0 about 20 0 by 191.3099 F100",
                "feed Y-30 F100",
                "feed X30 F100",
            ][..],
        ),
        // Not before more: the circle would be lost (figure 4-7-3-21).
        (
            6,
            "G1 G42 D1 X10 F100\nX40\nG3 I-20\nG1 Y30\nG40 X0",
            &[
                "feed X10 Y-5 F100",
                "feed X45 F100",
                "feed Y0 F100",
                "xy about 20 0 by 360 F100",
                "feed Y30 F100",
                "feed X0 F100",
            ][..],
        ),
        // The arc of G39 is programmed (4.7.4).
        (
            6,
            "G1 G41 D1 X10 F100\nX40\nG39\nY-30\nG40 Y-50",
            &[
                "feed X10 Y5 F100",
                "feed X40 F100",
                "xy X45 Y0 about 40 0 by -90 F100",
                "feed Y-30 F100",
                "feed X40 Y-50 F100",
            ][..],
        ),
    ] {
        holds_with(&setup(limit), program, steps);
    }
}
