//! Arcs, splines, cutter compensation, cycles and threads of RS274/NGC, with values worked out by hand from
//! LinuxCNC's user manual.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{at_fault, lines_on, run_on};
use ferrocut_geometry::{Axis, Plane, Position};
use ferrocut_interpreter::dialects::rs274::DIALECT;
use ferrocut_machine::Fault;
use ferrocut_toolpath::{Op, PathMode};

/// Each program, with G21, must make these steps before its end.
fn hold(cases: &[(&str, &[&str])]) {
    for (program, expected) in cases {
        let mut found = lines_on(&DIALECT, &format!("G21\n{program}\nM2\n"), "");
        assert_eq!(found.pop().as_deref(), Some("end M02"), "{program}");
        found.retain(|line| !line.starts_with("spindle"));
        assert_eq!(found, *expected, "{program}");
    }
}

#[test]
fn arcs_by_centre_radius_and_turns() {
    hold(&[
        ("G2 X10 I5 F100", &["xy X10 about 5 0 by -180 F100"]),
        ("G3 X10 Z6 I5 P3 F100", &["xy X10 Z6 about 5 0 by 900 F100"]),
        ("G3 X10 R-10 F100", &["xy X10 about 5 -8.6603 by 300 F100"]),
        ("G90.1 G2 X10 Y10 I10 J0 F100", &["xy X10 Y10 about 10 0 by -90 F100"]),
        ("G18 G2 X10 K0 I5 F100", &["zx X10 about 0 5 by -180 F100"]),
        ("G19 G3 Z10 K5 F100", &["yz Z10 about 0 5 by 180 F100"]),
        // A full circle without an end, and inches.
        ("G2 I5 F100", &["xy about 5 0 by -360 F100"]),
        ("G20\nG2 X1 I.5 F10", &["xy X25.4 about 12.7 0 by -180 F254"]),
        // F is read before the units of its block change, and stays the speed that it is.
        ("G20 G2 X1 I.5 F10\nG21\nG1 X30", &["xy X25.4 about 12.7 0 by -180 F10", "feed X30 F10"]),
        // Radii may differ by a thousandth, and by 0.028 mm whatever they are.
        ("G2 X2.018 I1 F100", &["xy X2.018 about 1 0 by -180 F100"]),
        ("G2 X1000.5 I500 F100", &["xy X1000.5 about 500 0 by -180 F100"]),
    ]);
}

#[test]
fn cycles_return_to_r_or_to_where_they_began() {
    hold(&[
        (
            "G0 Z10\nG98 G81 X5 R2 Z-3 F100\nX9",
            &[
                "rapid Z10",
                "rapid X5",
                "rapid Z2",
                "feed Z-3 F100",
                "rapid Z10",
                "rapid X9",
                "rapid Z2",
                "feed Z-3 F100",
                "rapid Z10",
            ],
        ),
        // R above where the tool is: out first, and R is where it returns to.
        ("G99 G81 X5 R2 Z-3 F100", &["rapid Z2", "rapid X5", "feed Z-3 F100", "rapid Z2"]),
        // With G91 the holes of L go on, R counts from where the cycles began and Z from R.
        (
            "G0 Z10\nG91 G99 G81 X5 R-8 Z-5 L2 F100",
            &[
                "rapid Z10",
                "rapid X5",
                "rapid Z2",
                "feed Z-3 F100",
                "rapid Z2",
                "rapid X10",
                "feed Z-3 F100",
                "rapid Z2",
            ],
        ),
        // Pecks go on 0.254 mm above the last depth.
        (
            "G0 Z10\nG99 G83 R2 Z-3 Q2 F100",
            &[
                "rapid Z10",
                "rapid Z2",
                "feed Z0 F100",
                "rapid Z2",
                "rapid Z0.254",
                "feed Z-2 F100",
                "rapid Z2",
                "rapid Z-1.746",
                "feed Z-3 F100",
                "rapid Z2",
            ],
        ),
        (
            "G0 Z10\nG99 G73 R2 Z-3 Q3 F100",
            &["rapid Z10", "rapid Z2", "feed Z-1 F100", "rapid Z-0.746", "feed Z-3 F100", "rapid Z2"],
        ),
        // In other planes along the axis square to them.
        ("G18 G99 G81 X5 Z4 R2 Y-3 F100", &["rapid Y2", "rapid X5 Z4", "feed Y-3 F100", "rapid Y2"]),
        ("G17.1 G99 G81 U5 V4 R2 W-3 F100", &["rapid W2", "rapid U5 V4", "feed W-3 F100", "rapid W2"]),
    ]);
}

#[test]
fn holes_of_polar_words_go_on_round() {
    // A quarter further with each hole, on the circle of 10.
    hold(&[(
        "G0 X10 Z1\nG91 G99 G81 ^90 R0 Z-2 L2 F100",
        &[
            "rapid X10 Z1",
            "rapid X0 Y10",
            "feed Z-1 F100",
            "rapid Z1",
            "rapid X-10 Y0",
            "feed Z-1 F100",
            "rapid Z1",
        ],
    )]);
}

#[test]
fn cycles_with_the_spindle() {
    hold(&[
        (
            "M3 S100 G0 Z10\nG98 G85 R2 Z-3 F100",
            &["rapid Z10", "rapid Z2", "feed Z-3 F100", "feed Z2 F100", "rapid Z10"],
        ),
        (
            "M3 S100 G0 Z10\nG98 G89 R2 Z-3 P1 F100",
            &["rapid Z10", "rapid Z2", "feed Z-3 F100", "dwell 1s", "feed Z10 F100"],
        ),
        (
            "M3 S100 G0 Z10\nG99 G88 R2 Z-3 P1 F100\nX5",
            &[
                "rapid Z10",
                "rapid Z2",
                "feed Z-3 F100",
                "dwell 1s",
                "stop M00",
                "rapid X5 Z2",
                "feed Z-3 F100",
                "dwell 1s",
                "stop M00",
            ],
        ),
        // I J from the hole, K where the back bore ends.
        (
            "M3 S100 G0 Z10\nG99 G87 X5 R2 Z-8 I1 J2 K-6 F100",
            &[
                "rapid Z10",
                "rapid X5",
                "rapid Z2",
                "rapid X6 Y2",
                "orient 0",
                "rapid Z-8",
                "rapid X5 Y0",
                "feed Z-6 F100",
                "feed Z-8 F100",
                "orient 0",
                "rapid X6 Y2",
                "rapid Z2",
                "rapid X5 Y0",
            ],
        ),
    ]);
    let tapped = lines_on(&DIALECT, "G21 M3 S100\nG0 Z10\nG99 G84 R2 Z-3 F100\nM2\n", "");
    let expected = [
        "spindle cw 100",
        "rapid Z10",
        "rapid Z2",
        "feed Z-3 F100",
        "spindle ccw 100",
        "feed Z2 F100",
        "spindle cw 100",
        "end M02",
    ];
    assert_eq!(
        tapped.iter().filter(|l| *l != "spindle off").collect::<Vec<_>>(),
        expected.iter().collect::<Vec<_>>()
    );
}

#[test]
fn a_stop_waits_for_the_last_hole_and_cycles_stop_exactly() {
    let (steps, alarm) = run_on(&DIALECT, "G21 G64\nG0 Z10\nG81 R2 Z-3 F100 L3 M0\nM2\n", "");
    assert_eq!(alarm, None);
    let stop = steps.iter().position(|step| step.op == Op::Stop(0)).unwrap();
    let feeds =
        |step: &&ferrocut_toolpath::Step| matches!(step.op, Op::Feed { path: PathMode::ExactStop, .. });
    assert_eq!(steps[..stop].iter().filter(feeds).count(), 3);
    assert_eq!(steps[stop..].iter().filter(feeds).count(), 0);
}

#[test]
fn threads_are_cut_in_step_with_the_spindle() {
    hold(&[
        ("M3 S100\nG33 Z-5 K2", &["tap 2 at 100 Z-5"]),
        ("M3 S100\nG33.1 Z-5 K2", &["tap 2 at 100 Z-5", "tap 2 at 100 Z0"]),
        // Depths of 1 and 2 of 2, the crest 5 inside the drive line.
        (
            "M3 S100\nG0 X20 Z10\nG76 P2 Z-5 I-5 J1 K2",
            &[
                "rapid X20 Z10",
                "rapid X21",
                "rapid X14",
                "tap 2 at 100 Z-5",
                "rapid X21",
                "rapid X20 Z10",
                "rapid X13",
                "tap 2 at 100 Z-5",
                "rapid X20",
            ],
        ),
    ]);
}

/// The greatest distance of the steps' path from the curve at parameters 0 to 1, and the other way round, mm.
fn off(steps: &[ferrocut_toolpath::Step], curve: impl Fn(f64) -> [f64; 2]) -> f64 {
    let mut from = Position::ZERO;
    let mut path = Vec::new();
    for step in steps {
        let Some(to) = step.op.target().copied() else { continue };
        for i in 0..=400 {
            let t = f64::from(i) / 400.0;
            let p = step.op.arc(from).map_or(from.lerp(to, t), |arc| arc.at(t));
            path.push(Plane::Xy.of(p));
        }
        from = to;
    }
    let fine: Vec<[f64; 2]> = (0..=4000).map(|i| curve(f64::from(i) / 4000.0)).collect();
    let gap = |p: &[f64; 2], of: &[[f64; 2]]| {
        of.windows(2)
            .map(|w| {
                let (v, u) = ([w[1][0] - w[0][0], w[1][1] - w[0][1]], [p[0] - w[0][0], p[1] - w[0][1]]);
                let square = v[0] * v[0] + v[1] * v[1];
                let t =
                    if square > 0.0 { ((u[0] * v[0] + u[1] * v[1]) / square).clamp(0.0, 1.0) } else { 0.0 };
                (u[0] - t * v[0]).hypot(u[1] - t * v[1])
            })
            .fold(f64::MAX, f64::min)
    };
    let there = path.iter().step_by(7).map(|p| gap(p, &fine)).fold(0.0, f64::max);
    fine.iter().step_by(7).map(|p| gap(p, &path)).fold(there, f64::max)
}

#[test]
fn the_pieces_of_a_spline_run_on_and_its_end_joins_as_the_mode_says() {
    let inside = |tolerance| PathMode::WithinBlock(tolerance);
    for (mode, within, at_end) in [
        ("G61.1", inside(Some(0.0005)), PathMode::ExactStop),
        ("G61", inside(Some(0.0005)), PathMode::ContinuousWithin(0.0)),
        ("G64", inside(None), PathMode::Continuous),
        ("G64 P0.02", inside(Some(0.02)), PathMode::ContinuousWithin(0.02)),
    ] {
        let (steps, _) = run_on(&DIALECT, &format!("G21 {mode}\nG5 X20 Y0 I0 J10 P-10 Q-5 F100\nM2\n"), "");
        let paths = steps.iter().filter_map(|step| match step.op {
            Op::Arc { path, .. } => Some(path),
            _ => None,
        });
        let paths: Vec<PathMode> = paths.collect();
        let (last, before) = paths.split_last().unwrap();
        assert!(before.len() > 2 && before.iter().all(|path| *path == within), "{mode}: {before:?}");
        assert_eq!(*last, at_end, "{mode}");
    }
}

#[test]
fn splines_become_arcs_that_no_one_sees() {
    // G5: the cubic with control points (0,0), (0,10), (10,-5), (20,0); G5.1: the parabola by (5,10).
    let cubic = |t: f64| {
        let u = 1.0 - t;
        let of = |p: [f64; 4]| {
            u * u * u * p[0] + 3.0 * u * u * t * p[1] + 3.0 * u * t * t * p[2] + t * t * t * p[3]
        };
        [of([0.0, 0.0, 10.0, 20.0]), of([0.0, 10.0, -5.0, 0.0])]
    };
    let (steps, alarm) = run_on(&DIALECT, "G21\nG5 X20 Y0 I0 J10 P-10 Q-5 F100\nM2\n", "");
    assert_eq!(alarm, None);
    assert!(steps.iter().filter(|s| matches!(s.op, Op::Arc { .. })).count() < 60, "{}", steps.len());
    assert!(!steps.iter().any(|s| matches!(s.op, Op::Feed { .. })));
    assert!(off(&steps, cubic) < 0.0006, "{}", off(&steps, cubic));
    let parabola = |t: f64| {
        let u = 1.0 - t;
        [2.0 * u * t * 5.0 + t * t * 20.0, 2.0 * u * t * 10.0]
    };
    let (steps, alarm) = run_on(&DIALECT, "G21\nG5.1 X20 Y0 I5 J10 F100\nM2\n", "");
    assert_eq!(alarm, None);
    assert!(off(&steps, parabola) < 0.0006);
    // NURBS of order 3 by four points: two parabolas that meet in the middle of the second and third.
    let program = "G21\nG5.2 P1 X0 Y10 F100\nX10 Y10 P1\nX10 Y0 P1\nG5.3\nG0 X0\nM2\n";
    let (steps, alarm) = run_on(&DIALECT, program, "");
    assert_eq!(alarm, None);
    let nurbs = |t: f64| {
        let b = |p: [[f64; 2]; 3], t: f64| {
            let u = 1.0 - t;
            [0, 1].map(|i| u * u * p[0][i] + 2.0 * u * t * p[1][i] + t * t * p[2][i])
        };
        match t < 0.5 {
            true => b([[0.0, 0.0], [0.0, 10.0], [5.0, 10.0]], 2.0 * t),
            false => b([[5.0, 10.0], [10.0, 10.0], [10.0, 0.0]], 2.0 * t - 1.0),
        }
    };
    let rapid = steps.iter().position(|s| matches!(s.op, Op::Rapid { .. })).unwrap();
    assert!(off(&steps[..rapid], nurbs) < 0.0006);
}

/// Tool 1 has a radius of 2.
const TOOL: &str = "[tools.1]\nradius = 2";

#[test]
fn compensation_of_a_contour() {
    let program = "G21 F100\nG0 X-20\nG41 D1\nG1 X0\nX20\nZ-1\nY30 A9\nX0\nG40 G0 Z5\nX-20\nM2\n";
    let expected = [
        "rapid X-20",
        "feed X0 Y2 F100",
        "feed X18 F100",
        "feed Z-1 F100",
        "feed Y28 A9 F100",
        "feed X0 F100",
        // G40 takes the vector away: the next move leads to the programmed point.
        "rapid Y30 Z5",
        "rapid X-20",
        "end M02",
    ];
    assert_eq!(lines_on(&DIALECT, program, TOOL), expected);
    // Outside corners are arcs about the programmed point before the move, whose other axes wait for it.
    let program = "G21 F100\nG0 X-20\nG42 D1\nG1 X0\nX20\nY30 Z-1\nG40\nM2\n";
    let expected = [
        "rapid X-20",
        "feed X0 Y-2 F100",
        "feed X20 F100",
        "xy X22 Y0 about 20 0 by 90 F100",
        "feed Y30 Z-1 F100",
        "end M02",
    ];
    assert_eq!(lines_on(&DIALECT, program, TOOL), expected);
    // The diameter may stand in the block; a negative one changes the sides over.
    let given = "G21 F100\nG0 X-20\nG41.1 D-4\nG1 X0\nX20\nG40\nM2\n";
    assert_eq!(lines_on(&DIALECT, given, "")[1], "feed X0 Y-2 F100");
}

#[test]
fn probing_ends_where_the_signal_comes() {
    let setup = "[signals]\nskip = { axis = \"z\", at = -3.0 }";
    let mut found = lines_on(&DIALECT, "G21 F100\nG38.2 Z-10\nG0 X#5063 Y#5070\nM2\n", setup);
    found.retain(|line| line != "Barrier");
    assert_eq!(found, ["skip to the signal Z-3 F100", "rapid X-3 Y1", "end M02"]);
}

/// A rule, a program that breaks it with its last block.
const FAULTS: &[(Fault, &str)] = &[
    (Fault::ArcWithoutCentre, "F100\nG2 X10"),
    (Fault::ArcRadiusAndCentre, "F100\nG2 X10 I5 R5"),
    (Fault::ArcCentreLetter, "F100\nG2 X10 I5 K0"),
    (Fault::ArcEndIsStart, "F100\nG2 X0 R5"),
    (Fault::ArcRadiusTooSmall, "F100\nG2 X10 R4"),
    (Fault::ArcWithoutRadius, "F100\nG2 X10 I0"),
    (Fault::ArcRadiusMismatch, "F100\nG2 X10.1 I5"),
    (Fault::ArcRadiusMismatch, "F100\nG2 X10010 I5000"),
    (Fault::ArcInUvwPlane, "F100 G17.1\nG2 X10 I5"),
    (Fault::WordMissing, "F100 G90.1\nG2 X10 I5"),
    (Fault::WordMissing, "F100\nG2 Z3 R5"),
    (Fault::WordNotWhole, "F100\nG2 X10 I5 P1.5"),
    (Fault::WordOutOfRange, "F100\nG2 X10 I5 P0"),
    (Fault::NoFeed, "G2 X10 I5"),
    (Fault::SplinePlane, "F100 G18\nG5.1 X9 I1 J1"),
    (Fault::SplineAxis, "F100\nG5.1 X9 Z1 I1 J1"),
    (Fault::WordMissing, "F100\nG5.1 X9 I1"),
    (Fault::WordMissing, "F100\nG5 X9 I1 J1 P1"),
    (Fault::WordMissing, "F100\nG5.2 X9"),
    (Fault::NurbsTooFew, "F100\nG5.2 X9 Y1 P1\nG5.3"),
    (Fault::NurbsEndAlone, "F100\nG5.3"),
    (Fault::ProbeTooClose, "F100\nG38.2 Z0"),
    (Fault::CodesContradict, "M3 S100 G95 F1\nG38.2 Z-1"),
    (Fault::CutterPlane, "G19\nG41 D1"),
    (Fault::CutterAlreadyOn, "G41 D1\nG42 D1"),
    (Fault::NotInCutter, "G41 D1\nG43 H1"),
    (Fault::NotInCutter, "F100 G41 D1\nG81 R1 Z0"),
    (Fault::NotInCutter, "F100 G41 D1\nG5.1 X9 I1 J1"),
    (Fault::NotInCutter, "G0 X1\nG41 D1\nG53 X1"),
    (Fault::NotInCutter, "F100 G41 D1\nG38.2 Z-1"),
    (Fault::NotInCutter, "M3 S1 G41 D1\nG33 Z-1 K1"),
    (Fault::CutterLatheTool, "G18\nG41.1 D1 L3"),
    (Fault::CutterEntryTooShort, "F100 G41 D1\nG1 X2"),
    (Fault::CutterArcTooSmall, "F100 G41 D1\nG1 X9\nG3 X9 Y4 J2"),
    (Fault::CutterArcAfterCancel, "F100 G41 D1\nG1 X9\nG40\nG3 X9 Y8 J4"),
    (Fault::CutterInterference, "F100 G41 D1\nG1 X9\nY1\nX8"),
    (Fault::CycleAxis, "F100\nG81 X1 A1 R1 Z0"),
    (Fault::CycleAxis, "F100\nG81 X1 U1 R1 Z0"),
    (Fault::CycleInverseTime, "G93\nG81 X1 R1 Z0 F10"),
    (Fault::CycleDepthAboveR, "F100\nG81 X1 R1 Z2"),
    (Fault::WordMissing, "F100\nG81 X1 Z2"),
    (Fault::WordMissing, "F100\nG81 X1 R2"),
    (Fault::WordMissing, "F100\nG81 X1 R2 Z0\nG82 X2 R2 Z0"),
    (Fault::WordMissing, "F100\nG83 X1 R2 Z0"),
    (Fault::WordMissing, "F100 M3 S1\nG87 X1 R2 Z0 I1 J1"),
    (Fault::WordOutOfRange, "F100\nG83 X1 R2 Z0 Q0"),
    (Fault::WordOutOfRange, "F100\nG83 X1 R2 Z0 Q0.00001"),
    (Fault::WordOutOfRange, "F100\nG81 X1 R2 Z0 L0"),
    (Fault::AxesMissing, "F100\nG81 R2"),
    (Fault::SpindleNotTurning, "F100\nG84 X1 R2 Z0"),
    (Fault::SpindleNotTurning, "G33 Z1 K1"),
    (Fault::SpindleWrongWay, "F100 M4 S1\nG84 X1 R2 Z0"),
    (Fault::SpindleWrongWay, "F100 M3 S1\nG74 X1 R2 Z0"),
    (Fault::ThreadDepths, "M3 S1\nG76 P1 Z-9 I-1 J1 K1"),
    (Fault::WordOutOfRange, "M3 S1\nG76 P1 Z-9 I-1 J0.00001 K1"),
    (Fault::WordMissing, "M3 S1\nG33 Z1"),
    (Fault::NotSupported, "G71 X1 P1"),
];

#[test]
fn every_rule_has_its_alarm_on_the_block_that_breaks_it() {
    for (fault, program) in FAULTS {
        let text = format!("G21\n{program}\nM2\n");
        let (_, alarm) = run_on(&DIALECT, &text, TOOL);
        let alarm = alarm.unwrap_or_else(|| panic!("{program}: no alarm"));
        assert_eq!(alarm.fault, *fault, "{program}");
        let last = program.lines().last().unwrap();
        assert!(
            last.contains(at_fault(&text, &alarm).trim_end()),
            "{program}: {:?}",
            at_fault(&text, &alarm)
        );
    }
}

#[test]
fn all_points_of_a_turned_coordinate_system_turn() {
    // G54 turned by 90°: X of the program is Y of the machine.
    let program = "G21 G10 L2 P1 X5 R90\nG1 X10 Y0 F100\nG2 X20 I5\nG5.1 X30 Y0 I5 J0\nM2\n";
    let (steps, alarm) = run_on(&DIALECT, program, "");
    assert_eq!(alarm, None);
    let Op::Arc { to, center, .. } = steps[1].op else { panic!("{steps:?}") };
    assert!((to[Axis::Y] - 20.0).abs() < 1e-9 && (to[Axis::X] - 5.0).abs() < 1e-9, "{to:?}");
    assert!((center[0] - 5.0).abs() < 1e-9 && (center[1] - 15.0).abs() < 1e-9, "{center:?}");
    let end = steps.iter().rev().find_map(|step| step.op.target()).unwrap();
    assert!((end[Axis::Y] - 30.0).abs() < 1e-9, "{end:?}");
}
