//! Canned cycles beside what each of them does: what their data are, when they cut, and what they leave in
//! force. Numbers are sections of "GSK990MC programming and operation".
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{holds_turning, holds_with};

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
