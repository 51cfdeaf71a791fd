//! Canned cycles beside what each of them does: what their data are, when they cut, and what they leave in
//! force. Numbers are sections of "GSK990MC programming and operation".
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{holds_turning, holds_with, lines, run};
use ferrocut_interpreter::Options;
use ferrocut_machine::{Fault, Severity};
use ferrocut_toolpath::{Op, Step};

/// Radius 4 as offset 1.
const CUTTER: &str = "[start]\nz = 50\n[tools.1]\nradius = 4\n[parameters]\n\"NO40.7\" = 0";

const HIGH: &str = "[start]\nz = 50";

#[test]
fn compensation_is_left_aside_until_the_cycle_is_cancelled() {
    // 4.4 limits: also in the move aside of G76.
    holds_turning(
        CUTTER,
        "G90 G0 X-20 Y0\nG41 D1 G1 X-10 F200\nG99 G76 X30 Y0 Z-5 R2 Q3 F100\nG80 G1 X60\nX70\nG40 X80",
        &[
            "rapid X-20",
            "feed X-10 Y4 F200",
            "rapid X30 Y0",
            "rapid Z2",
            "feed Z-5 F100",
            "orient 0",
            "rapid X33",
            "rapid Z2",
            "rapid X30",
            "spindle cw 1000",
            // Started up anew.
            "feed X60 Y4 F100",
            "feed X70 F100",
            "feed X80 Y0 F100",
        ],
    );
    // A hole where the programmed point is already: the tool comes back from its vector first. What
    // follows the cycle is compensated whether the last block of it moved in the plane or not.
    holds_turning(
        CUTTER,
        "G90 G0 X-20 Y0\nG41 D1 G1 X-10 F200\nX0\nG99 G81 X0 Y0 Z-5 R2 F100\nZ-6\nG80\nG1 X40\nX50\nG40 X60",
        &[
            "rapid X-20",
            "feed X-10 Y4 F200",
            "feed X0 F200",
            "rapid Y0",
            "rapid Z2",
            "feed Z-5 F100",
            "rapid Z2",
            "feed Z-6 F100",
            "rapid Z2",
            "feed X40 Y4 F100",
            "feed X50 F100",
            "feed X60 Y0 F100",
        ],
    );
}

#[test]
fn a_block_that_cuts_nothing_keeps_what_it_says() {
    // 4.4 table 4-4-2: K0 stores data, a change of tool length too; it comes on the next way to R.
    holds_turning(
        "[start]\nz = 50\n[tools.1]\nlength = 7",
        "G90 G99 G81 G43 H1 X0 Y0 Z-5 R2 F100 K0\nX10",
        &["rapid X10", "rapid Z9", "feed Z2 F100", "rapid Z9"],
    );
    // Without Z nothing moves along it.
    holds_turning(
        "[start]\nz = 50\n[tools.1]\nlength = 7",
        "G90 G43 H1 G99 G81 X5 Y5 R2 F100\nX10\nX15 Z-5",
        &["rapid X5 Y5", "rapid X10", "rapid X15", "rapid Z9", "feed Z2 F100", "rapid Z9"],
    );
    // The factor of the tool axis comes back after K0 (4.2.14 limit 1).
    holds_turning(
        "[parameters]\n\"NO47.6\" = 0\n\"NO60.5\" = 1",
        "G90 G51 X0 Y0 Z0 P2\nG99 G81 X5 Y5 Z-5 R2 F100 K0\nG80\nG0 Z10",
        &["rapid Z20"],
    );
    // P of a call is no dwell.
    holds_turning(
        HIGH,
        "G90 G99 G82 X1 Y0 Z-5 R2 P1000 F100\nM98 P100\nM30\nO100\nX20\nM99",
        &[
            "rapid X1",
            "rapid Z2",
            "feed Z-5 F100",
            "dwell 1s",
            "rapid Z2",
            "rapid X20",
            "feed Z-5 F100",
            "dwell 1s",
            "rapid Z2",
        ],
    );
    // Nor is V a hole (4.5.3), nor a word of an axis that the control does not carry.
    holds_turning(
        HIGH,
        "G90 G99 G83 X1 Z-5 R2 Q9 F100\nV2\nU1",
        &["rapid X1", "rapid Z2", "feed Z-5 F100", "rapid Z2"],
    );
}

#[test]
fn dwell_is_in_milliseconds_whatever_g04_counts_in() {
    // Table 4-4-2; 5#1 is for G04 (table 4-2-5-2).
    holds_turning(
        "[start]\nz = 50\n[parameters]\n\"NO5.1\" = 1",
        "G99 G82 X1 Z-5 R2 P1000 F100\nG80 G4 P1000",
        &["rapid X1", "rapid Z2", "feed Z-5 F100", "dwell 1s", "rapid Z2", "dwell 0.1s"],
    );
}

#[test]
fn a_fourth_axis_moves_with_the_other_two() {
    // 4.4: the positioning may include another axis. The tool axis moves after it.
    holds_turning(
        HIGH,
        "G90 G99 G81 X10 Y5 A45 Z-5 R2 F100",
        &["rapid X10 Y5 A45", "rapid Z2", "feed Z-5 F100", "rapid Z2"],
    );
}

/// G80 ends the waiting of M29 for its cycle, too.
#[test]
fn a_move_behind_g80_is_none_before_a_tapping_cycle() {
    let found = common::lines("M29 S1000\nG80\nG0 X1\nM30\n", "");
    assert_eq!(found[found.len() - 2..], ["rapid X1", "end M30"], "{found:?}");
}

#[test]
fn rigid_tapping_draws_back_at_the_override_of_its_parameters() {
    let taps = |parameters: &str| {
        let setup = format!("[start]\nz = 50\n[parameters]\n{parameters}");
        let (steps, alarm) = common::run("M29 S500\nG99 G84 X1 Z-5 R2 F500\nG80 M3\nM30\n", &setup);
        assert_eq!(alarm, None);
        let ops = steps.into_iter().map(|step| step.op);
        ops.filter_map(|op| match op {
            ferrocut_toolpath::Op::Tap { rpm, pitch, .. } => Some((rpm, pitch)),
            _ => None,
        })
        .collect::<Vec<_>>()
    };
    // 44#4, P283 in %, with 45#3 in 10 %.
    assert_eq!(taps(""), [(500.0, 1.0), (500.0, 1.0)]);
    assert_eq!(taps("\"NO44.4\" = 1\nP283 = 50"), [(500.0, 1.0), (250.0, 1.0)]);
    assert_eq!(taps("\"NO44.4\" = 1\n\"NO45.3\" = 1\nP283 = 20"), [(500.0, 1.0), (1000.0, 1.0)]);
    // Held where the spindle may turn no faster (P257).
    assert_eq!(taps("\"NO44.4\" = 1\n\"NO45.3\" = 1\nP283 = 90"), [(500.0, 1.0), (2000.0, 1.0)]);
}

/// A fault, and the words that it is about.
type Told = (Fault, String);

/// Pitch and speed.
type Thread = (f64, f64);

/// What a check tells of a program, and the threads that it cuts.
fn told_and_tapped(program: &str, setup: &str) -> (Vec<Told>, Vec<Thread>) {
    let options = Options { keep_going: true, ..Options::default() };
    let (mut told, mut taps) = (Vec::new(), Vec::new());
    for step in common::interpreter(program.as_bytes(), setup, options).unwrap() {
        match step {
            Ok(Step { op: Op::Tap { pitch, rpm, .. }, .. }) => taps.push((pitch, rpm)),
            Ok(_) => {}
            Err(alarm) => {
                assert_eq!(alarm.severity, Severity::Warning, "{program}: {alarm:?}");
                told.push((alarm.fault, common::at_fault(program, &alarm).to_owned()));
            }
        }
    }
    (told, taps)
}

#[test]
fn a_rigid_thread_keeps_its_pitch_beyond_the_highest_feed() {
    // 4.4.5, 4.5.1: F beyond P96 counts as P96, and the pitch is F/S: 3 mm at 500 r/min.
    let held = || vec![(Fault::TappingFeedHeld, "F3000".to_owned())];
    for (code, pitch) in [("G84", 3.0), ("G74", -3.0)] {
        // 4.4.5, example: tool length stands between.
        let program = format!("M29 S1000\nG43 H10\nG99 {code} X1 Z-5 R2 F3000\nX5\nG80\nM30\n");
        let setup = "[start]\nz = 50\n[parameters]\nP96 = 1500";
        assert_eq!(told_and_tapped(&program, setup), (held(), vec![(pitch, 500.0); 4]), "{program}");
    }
    // By turns the feed is as high.
    let by_turns = "G95\nM29 S1000\nG99 G84 X1 Z-5 R2 F3\nG80\nM30\n";
    let (told, taps) = told_and_tapped(by_turns, "[start]\nz = 50\n[parameters]\nP96 = 1500");
    assert_eq!((told.len(), taps), (1, vec![(3.0, 500.0); 2]));
    // A lowest feed makes no spindle turn faster than S.
    let slow = "M29 S100\nG99 G84 X1 Z-5 R2 F100\nG80\nM30\n";
    let setup = "[start]\nz = 50\n[parameters]\nP97 = 300";
    assert_eq!(told_and_tapped(slow, setup), (vec![], vec![(1.0, 100.0); 2]));
    // S beyond P258 is held there (part 2, 7.10), and F is of the S that was programmed.
    let (_, taps) = told_and_tapped(
        "M29 S1000\nG99 G84 X1 Z-5 R2 F1500\nG80\nM30\n",
        "[start]\nz = 50\n[parameters]\nP258 = 800",
    );
    assert_eq!(taps, [(1.5, 800.0); 2]);
}

#[test]
fn a_floating_tap_whose_feed_is_held_is_told() {
    let program = "M3 S1000\nG99 G84 X1 Z-5 R2 F3000\nG80\nM30\n";
    let setup = "[start]\nz = 50\n[parameters]\nP96 = 1500";
    assert_eq!(told_and_tapped(program, setup).0, [(Fault::TappingFeedHeld, "F3000".to_owned())]);
    assert_eq!(told_and_tapped(program, "[start]\nz = 50").0, []);
}

#[test]
fn rigid_tapping_has_the_spindle_for_itself() {
    // 46#5: oriented before. Afterwards it stands still, so that M03 starts it again (4.5.1).
    for (setup, orients) in [("", false), ("[parameters]\n\"NO46.5\" = 1", true)] {
        let found = common::lines("M3 S500\nM29\nG99 G84 X1 Z-5 R2 F500\nG80 M3\nM30\n", setup);
        assert_eq!(found.iter().filter(|line| *line == "spindle cw 500").count(), 2, "{found:?}");
        assert_eq!(found.contains(&"orient 0".to_owned()), orients, "{found:?}");
    }
}

#[test]
fn a_code_that_cancels_the_cycle_goes_before_those_that_it_forbids() {
    holds_turning(
        HIGH,
        "G99 G81 X1 Z-5 R2 F100\nG80 G18\nG17\nG81 X2\nZ-5 R2\nG0 G18 X3",
        &[
            "rapid X1",
            "rapid Z2",
            "feed Z-5 F100",
            "rapid Z2",
            "rapid X2",
            "feed Z-5 F100",
            "rapid Z2",
            "rapid X3",
        ],
    );
    // 4.1 note 6: a motion code of the block goes before the cycle, whose words are left aside.
    holds_with("", "G99 G01 G22 X25 Y25 Z-50 R5 I50 L10 W20 Q10 V10 D1 F800", &["feed X25 Y25 Z-50 F800"]);
}

/// 4.4.1 note 3: on the way to R; where there is none the axis takes it up when it is next moved.
#[test]
fn a_change_of_tool_length_is_not_lost_where_no_hole_is_made() {
    let setup = "[start]\nz = 50\n[tools.1]\nlength = 4\n[tools.2]\nlength = 7\n[parameters]\n\"NO43.1\" = 0";
    let cases: [(&str, &[&str]); 5] = [
        ("G90 G98 G43 H1 G81 X10 R5 Z-3 F100 K0\nG80\nG0 Z10", &["rapid Z14"]),
        ("G90 G98 G43 H1 G81 X10 R5 F100\nG0 Z10", &["rapid X10", "rapid Z14"]),
        ("G43 H1 G0 Z20\nG49 G81 X10 R5 Z-3 F100 K0\nG80\nG0 Z10", &["rapid Z24", "rapid Z10"]),
        ("G43 H1 G0 Z20\nH2 G81 X10 R5 Z-3 F100 K0\nG80\nG0 Z10", &["rapid Z24", "rapid Z17"]),
        // Given beside a code that moves nothing, it waits for the cycle too.
        (
            "G43 H1 G04 X1\nG99 G81 X5 Z-5 R1 F100",
            &["dwell 1s", "rapid X5", "rapid Z5", "feed Z-1 F100", "rapid Z5"],
        ),
    ];
    for (program, expected) in cases {
        holds_turning(setup, program, expected);
    }
}

/// Centres and radii of the full circles that are cut.
fn circles(setup: &str, program: &str) -> Vec<[f64; 3]> {
    let (steps, alarm) = run(&format!("M3 S1000\n{program}\nM30\n"), setup);
    assert_eq!(alarm, None, "{program}");
    let circle = |step: &ferrocut_toolpath::Step| match step.op {
        Op::Arc { to, center, sweep, .. } if sweep.abs() > 6.0 => {
            let [x, y] = center;
            let r = (to.0[0] - x).hypot(to.0[1] - y);
            Some([x, y, r].map(|value| (value * 1e6).round() / 1e6))
        }
        _ => None,
    };
    steps.iter().filter_map(circle).collect()
}

const CIRCLES: &str = "[start]\nz = 50\n[tools.1]\nradius = 5\n[parameters]\n\"NO40.7\" = 0\n\"NO47.6\" = 0";

/// 4.4: only what changes is given again; the cycle ends elsewhere, which is no reason for the next to be there.
#[test]
fn milling_cycles_go_on_from_the_last_place() {
    let circle = "G90 G99 G24 X25 Y25 Z-10 R5 I50 J10 D1 F800";
    let cases: [(String, &[[f64; 2]]); 5] = [
        ("G0 X50 Y50\nG99 G24 Z-10 R5 I50 J10 D1 F800 K2".into(), &[[50.0, 50.0], [50.0, 50.0]]),
        (format!("{circle}\nY200\nZ-12"), &[[25.0, 25.0], [25.0, 200.0], [25.0, 200.0]]),
        (format!("{circle}\nG91 X10 K2"), &[[25.0, 25.0], [35.0, 25.0], [45.0, 25.0]]),
        // Where something else has moved the tool it counts from there.
        (format!("{circle}\nG81 X200 Y200 Z-3\nG91 G24 X10 Z-15"), &[[25.0, 25.0], [210.0, 200.0]]),
        (format!("{circle}\nG53 X0 Y0\nG91 X10"), &[[25.0, 25.0], [10.0, 0.0]]),
    ];
    for (program, centres) in cases {
        let found: Vec<[f64; 2]> = circles(CIRCLES, &program).iter().map(|[x, y, _]| [*x, *y]).collect();
        assert_eq!(found, centres, "{program}");
    }
}

/// 4.2.14, 7: scaling is none of the tool.
#[test]
fn scaling_leaves_the_tool_of_a_milling_cycle_alone() {
    let scaled = |factors: &str, cycle: &str| {
        format!("G51 X0 Y0 Z0 {factors}\nG90 G99 {cycle} X0 Y0 Z-20 R5 I50 J20 D1 F800")
    };
    assert_eq!(circles(CIRCLES, &scaled("P0.5", "G26")), [[0.0, 0.0, 30.0]]);
    assert_eq!(circles(CIRCLES, &scaled("P2", "G24")), [[0.0, 0.0, 95.0]]);
    let by_axis = CIRCLES.replace("\"NO47.6\" = 0", "\"NO47.6\" = 1");
    let (_, alarm) = run(&format!("M3 S1000\n{}\nM30\n", scaled("I2 J1 K1", "G26")), &by_axis);
    assert_eq!(alarm.unwrap().fault, Fault::MillScaledUnevenly);
}

/// 4.4.6 to 4.4.11: no boring in a block without an axis; R is kept for the next hole. Drilling has no such sentence.
#[test]
fn r_alone_bores_nothing() {
    holds_turning(
        HIGH,
        "G99 G85 X5 Z-4 R2 F100\nR3\nX6",
        &[
            "rapid X5",
            "rapid Z2",
            "feed Z-4 F100",
            "feed Z2 F100",
            "rapid X6",
            "rapid Z3",
            "feed Z-4 F100",
            "feed Z3 F100",
        ],
    );
    holds_turning(
        HIGH,
        "G99 G81 X5 Z-4 R2 F100\nR3",
        &["rapid X5", "rapid Z2", "feed Z-4 F100", "rapid Z2", "rapid Z3", "feed Z-4 F100", "rapid Z3"],
    );
}

#[test]
fn a_surface_speed_is_a_speed_for_drilling() {
    // 178 is for cycles before any S (6.3).
    let setup = "[parameters]\n\"NO61.0\" = 1";
    let drills = |program: &str| lines(program, setup).iter().any(|line| line.starts_with("feed Z-20"));
    assert!(drills("G96 S100 M3\nG99 G81 X10 Z-20 R2 F500\nM30"));
    let (_, alarm) = run("G96 M3\nG99 G81 X10 Z-20 R2 F500\nM30", setup);
    assert_eq!(alarm.map(|alarm| alarm.fault), Some(Fault::CycleNoSpindle));
}

#[test]
fn a_cycle_that_cuts_nothing_or_does_not_move_aside_is_told_once() {
    // 4.4.1: without R or Z it only positions. 4.4.9: Q is how far the tool moves aside, and has no default here.
    let setup = "[start]\nz = 50";
    let head = "M3 S1000 F100\n";
    for (block, fault, at) in [
        ("G81 X1 Z-5", Fault::NoHole, "G81"),
        ("G83 X1 R2 Q1", Fault::NoHole, "G83"),
        ("G84 X1 R2", Fault::NoHole, "G84"),
        ("G76 X1 R2 Z-5", Fault::NoShift, "G76"),
        ("G87 X1 R-5 Z2", Fault::NoShift, "G87"),
    ] {
        // Once for all its holes, and again where it is programmed again.
        let program = format!("{head}G98 {block}\nX5\nX9\n{block}\nG80\nM30\n");
        let told = (fault, at.to_owned());
        assert_eq!(told_and_tapped(&program, setup).0, [told.clone(), told], "{program}");
    }
    for block in ["G81 X1 R2 Z-5", "G76 X1 R2 Z-5 Q0.5", "G81 R2 Z-5 L0"] {
        let program = format!("{head}G98 {block}\nX5\nG80\nM30\n");
        assert_eq!(told_and_tapped(&program, setup).0, [], "{program}");
    }
    // A full circle by its radius is none (4.2.3 limits 3 and 5).
    let program = "G17 G90 F100\nG2 X0 Y0 R5\nG2 X0 Y0 I5\nG2 X10 R5\nM30\n";
    assert_eq!(told_and_tapped(program, setup).0, [(Fault::ArcOfNoLength, "R5".to_owned())]);
}
