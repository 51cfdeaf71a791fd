//! The rules of the Fagor 8060/8065 control, with values worked out by hand from its manual.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{lines_on, run_on, told_on};
use ferrocut_interpreter::dialects::fagor8065::DIALECT;
use ferrocut_machine::{Fault, Severity};

/// Program, set-up, the steps that it makes.
type Case = (&'static str, &'static str, &'static [&'static str]);

fn hold(cases: &[Case]) {
    for (program, setup, expected) in cases {
        assert_eq!(lines_on(&DIALECT, program, setup), *expected, "{program}");
    }
}

/// Moves alone.
fn moves(program: &str, setup: &str) -> Vec<String> {
    let mut lines = lines_on(&DIALECT, program, setup);
    let is_move = |line: &String| ["rapid", "feed", "xy"].iter().any(|name| line.starts_with(name));
    lines.retain(is_move);
    lines
}

#[test]
fn another_tool_axis_ends_the_cycle_however_it_is_chosen() {
    for choice in ["G20 Y1 Z2 X3", "G19", "#TOOL AX [X+]"] {
        let program = format!("G0 G90 X20 Y0 Z20 F100 S500 M3\nG81 Z2 I-5\n{choice}\nY10\nM30");
        let found = moves(&program, "");
        assert_eq!(found.last().map(String::as_str), Some("rapid Y10"), "{choice}: {found:?}");
        assert_eq!(found.iter().filter(|line| line.starts_with("feed")).count(), 1, "{choice}");
    }
}

/// 1.1.1: a stopped spindle starts clockwise; one that a cycle stopped goes on as it was.
#[test]
fn a_spindle_that_the_program_stopped_starts_clockwise() {
    let hole = ["rapid Z2", "feed Z-5 F100", "rapid Z20"];
    for stop in ["M5", "M19"] {
        let program = format!("G0 G90 X0 Y0 Z20 F100 S500 M4\nG81 Z2 I-5\n{stop}\nX10\nM30");
        let found = lines_on(&DIALECT, &program, "");
        let starts: Vec<&String> = found.iter().filter(|line| line.starts_with("spindle ")).collect();
        assert!(starts[0].contains("ccw"), "{found:?}");
        let last = starts.iter().rfind(|line| !line.contains("off")).unwrap();
        assert!(last.contains("cw") && !last.contains("ccw"), "{stop}: {found:?}");
        assert!(found.windows(3).filter(|lines| *lines == hole).count() == 2, "{found:?}");
    }
    // G86 A1 goes in with the spindle stopped: it is not started for that.
    let program = "G0 G90 X0 Y0 Z20 F100 S500\nG99 G86 Z2 I-10 A1 Q45 D-0.5 E0.2\nM30";
    let found = lines_on(&DIALECT, program, "");
    let first_start = found.iter().position(|line| line.starts_with("spindle cw")).unwrap();
    let bottom = found.iter().position(|line| line.starts_with("feed Z-10")).unwrap();
    assert!(first_start > bottom, "{found:?}");
}

#[test]
fn m19_goes_to_the_angle_that_s_gives() {
    hold(&[("S500 M3\nM19 S30\nM19\nM30", "", &["spindle cw 500", "orient 30", "orient 0", "end M30"])]);
}

/// 2.5: an arc of travel says the way round, else the sign of I, else that of the whole angle.
#[test]
fn points_on_an_arc_go_the_way_that_c_and_i_say() {
    for (words, end) in [
        ("B-90 K3 C3", "X30 Y0"),
        ("B-90 I45 C2", "X30 Y40"),
        ("B-90 I-45", "X30 Y40"),
        ("B-90 I45", "X30 Y0"),
        ("B90 K3", "X30 Y0"),
        ("B-90 K3", "X30 Y40"),
        ("B90 I-45", "X30 Y40"),
    ] {
        let program = format!(
            "G0 G90 X10 Y20 Z20 F100 S500 M3\nG99 G81 Z2 I-5\nG164 X20 Y0 {words}\nG80 G0 G90 X0 Y0\nM30"
        );
        let at = |x: f64, y: f64| [x, y];
        let (steps, alarm) = run_on(&DIALECT, &program, "");
        assert_eq!(alarm, None);
        let targets: Vec<_> = steps.iter().filter_map(|step| step.op.target()).collect();
        let last = targets[targets.len() - 2];
        let wanted = if end == "X30 Y0" { at(30.0, 0.0) } else { at(30.0, 40.0) };
        let found = at(last.0[0], last.0[1]);
        assert!(
            (found[0] - wanted[0]).abs() < 1e-9 && (found[1] - wanted[1]).abs() < 1e-9,
            "{words}: {found:?}"
        );
    }
}

/// Arcs by radius and angle: about their centre where they have one, else about the polar origin.
#[test]
fn polar_arcs_turn_about_their_own_centre() {
    hold(&[
        (
            "G0 G90 X60 Y40 F100\nG17 G3 Q0 I0 J50\nQ-90 I50 J0\nM30",
            "",
            &[
                "rapid X60 Y40",
                "xy X110 Y90 about 60 90 by 90 F100",
                "xy X160 Y40 about 160 90 by 90 F100",
                "end M30",
            ],
        ),
        (
            "G0 G90 X170 Y80 F100\nG2 Q360 I-50 J0\nM30",
            "",
            &["rapid X170 Y80", "xy about 120 80 by -360 F100", "end M30"],
        ),
    ]);
    let (_, alarm) = run_on(&DIALECT, "G0 G90 X10 Y0 Z0 F100\nG3 R5 Q90\nM30", "");
    assert_eq!(DIALECT.alarm_id(Fault::ArcRadiusMismatch), alarm.unwrap().id);
}

#[test]
fn the_pitch_of_a_helix_makes_its_turns() {
    let (steps, alarm) = run_on(&DIALECT, "G0 G90 X0 Y0 Z0 F100\nG3 X0 Y0 I15 J0 Z-50 K20\nM30", "");
    assert_eq!(alarm, None);
    let sweep = steps.iter().find_map(|step| match step.op {
        ferrocut_toolpath::Op::Arc { sweep, .. } => Some(sweep.to_degrees()),
        _ => None,
    });
    assert!((sweep.unwrap() - 720.0).abs() < 1e-9, "{sweep:?}");
}

/// 4.20: where the way in or out runs along the profile itself there is nothing to round.
#[test]
fn a_way_in_along_the_profile_has_no_arc() {
    let program = "#CYCLE G293 [X1=0, Y1=0, R1=5, P1=[10,0], P2=[50,0], P3=[50,30], P4=[20,30], P5=[20,30], RN=5, XN=0, YN=30, Z=0, ZS=5, P=6]\n#ROUGH [FZ=100, I=-6, F=400, S=1000, T=1, D=1]\nM30";
    let found = moves(program, "[tools.1]\nradius = 3\n");
    assert_eq!(
        found,
        [
            "rapid Z5",
            "rapid Z1",
            "feed Z-6 F100",
            "feed X10 F400",
            "feed X50 F400",
            "feed Y30 F400",
            "feed X20 F400",
            "feed X0 F400",
            "rapid Z5",
            "rapid Y0",
        ]
    );
}

/// 4.20: the way down to a level is rapid only where the level before was cut, and only roughing goes back.
#[test]
fn profiles_go_down_at_the_feed_of_the_plunge() {
    let program = "#CYCLE G293 [X1=0, Y1=0, P1=[10,0], P2=[50,0], Z=0, ZS=5, P=30]\n#ROUGH [I=-10, F=100, S=1000, T=1, D=1]\nM30";
    let found = moves(program, "[tools.1]\nradius = 3\n");
    assert_eq!(
        found,
        [
            "rapid Z5",
            "rapid Z1",
            "feed Z-10 F50",
            "feed X10 F100",
            "feed X50 F100",
            "rapid Z5",
            "rapid X0",
            "rapid Z-9",
            "feed Z-20 F50",
            "feed X10 F100",
            "feed X50 F100",
            "rapid Z5",
            "rapid X0",
            "rapid Z-19",
            "feed Z-30 F50",
            "feed X10 F100",
            "feed X50 F100",
            "rapid Z5",
            "rapid X0",
        ]
    );
    let program = "#PROFILE way\nG0 X0 Y0\nG1 X0 Y20\n#ENDPROFILE\n#CYCLE G294 [profile=way, X=-20, Y=-10, Z=0, ZS=5, P=4]\n#FINISH [F=100, S=1000, T=2]\nM30";
    let found = moves(program, "[tools.2]\nradius = 3\n");
    assert_eq!(found.last().map(String::as_str), Some("rapid Z5"), "{found:?}");
}

/// 4.1.3: N = 0 finishes the wall on each level of roughing, the last one on the floor.
#[test]
fn walls_are_finished_on_the_levels_of_roughing() {
    let program = "#CYCLE G287 [X=0, Y=0, L=60, H=30, Z=0, ZS=5, P=10]\n#ROUGH [step=8, I=-4, FZ=100, F=500, S=1000, T=1, D=1]\n#FINISH [delta=.5, deltaz=0.5, N=0, F=300, T=1, D=1]\nM30";
    let (steps, alarm) = run_on(&DIALECT, program, "[tools.1]\nradius = 5\n");
    assert_eq!(alarm, None);
    let mut levels: Vec<f64> = Vec::new();
    for step in &steps {
        if let ferrocut_toolpath::Op::Feed { to, .. } = step.op
            && !levels.contains(&to.0[2])
        {
            levels.push(to.0[2]);
        }
    }
    assert_eq!(levels, [-4.0, -8.0, -9.5, -10.0]);
}

#[test]
fn a_value_may_begin_with_a_bracket() {
    let program = "P1=4\n#CYCLE G281 [X=[P1+1]*2, Y=[P1+1], Z=0, ZS=5, P=[P1]/2, F=100, S=1000, T=1]\nM30";
    let found = moves(program, "[tools.1]\nradius = 3\n");
    assert_eq!(found, ["rapid Z5", "rapid X10 Y5", "rapid Z1", "feed Z-2 F100", "rapid Z5"]);
}

/// 4.24, formats 7 to 9: the cycle's own point is the first, the others lie on the circle.
#[test]
fn the_circle_of_positions_is_the_one_given() {
    let program = "#CYCLE G281 [X=0, Y=0, Z=0, ZS=5, P=2, F=100, S=1000, T=1]\n#MULTI ARC [XA=50, YA=50, R=40, N=3, alpha=0, beta=90]\nM30";
    let found = moves(program, "[tools.1]\nradius = 3\n");
    let places: Vec<_> = found.iter().filter(|line| line.contains('X') || line.contains('Y')).collect();
    assert_eq!(places, ["rapid X50 Y90", "rapid X10 Y50"]);
}

/// 4.7: only a positive pitch mills the bottom.
#[test]
fn a_negative_pitch_of_bore_milling_leaves_the_bottom() {
    let arcs = |pitch: &str| {
        let program = format!(
            "#CYCLE G298 [X=0, Y=0, Z=0, ZS=5, P=4, phi=30, phiK=20, B={pitch}, F=100, S=1000, T=1]\nM30"
        );
        let (steps, alarm) = run_on(&DIALECT, &program, "[tools.1]\nradius = 5\n");
        assert_eq!(alarm, None, "{pitch}");
        let sweep = |step: &ferrocut_toolpath::Step| match step.op {
            ferrocut_toolpath::Op::Arc { sweep, .. } => sweep.abs().to_degrees(),
            _ => 0.0,
        };
        steps.iter().map(sweep).sum::<f64>()
    };
    assert!((arcs("2") - arcs("-2") - 360.0).abs() < 1e-6, "{} {}", arcs("2"), arcs("-2"));
}

/// 4.1.3: without an entry angle in the cycle or the tool table the tool goes straight down. A check says so of
/// stages that enter solid material: not of one behind another, nor of roughing with an open middle (4.14).
#[test]
fn a_check_names_the_angle_of_a_stage_that_goes_straight_down() {
    const RECTANGLE: &str = "G287 [X=0, Y=0, Z=0, ZS=5, P=10, L=60, H=50, start=centre]";
    const OPEN: &str = "G296 [XC=0, YC=0, Z=0, ZS=5, P=10, R=40, r=10]";
    const ROUGH: &str = "#ROUGH [T=1, F=300, S=1000, step=4, I=5";
    const FINISH: &str = "#FINISH [T=1, F=300, S=1000, delta=0.5, N=2";
    let table = "[tools.1]\nradius = 4\ncutting_length = 20\n";
    let said = |cycle: &str, stages: &[&str], table: &str| {
        let stages: Vec<String> = stages.iter().map(|stage| format!("{stage}]\n")).collect();
        let program = format!("G0 X0 Y0 Z50\n#CYCLE {cycle}\n{}M30\n", stages.concat());
        let told = told_on(&DIALECT, &program, table).into_iter().map(|alarm| {
            assert_eq!((alarm.fault, alarm.severity), (Fault::NoEntryAngle, Severity::Warning), "{program}");
            alarm.arguments.iter().map(|(_, value)| format!("{value:?}")).collect::<String>()
        });
        told.collect::<Vec<_>>()
    };
    let names = |told: Vec<String>, expected: &[&str]| {
        let fits = told.iter().zip(expected).all(|(told, name)| told.contains(name));
        assert!(fits && told.len() == expected.len(), "{told:?} {expected:?}");
    };
    names(said(RECTANGLE, &[ROUGH, FINISH], table), &["#ROUGH beta"]);
    names(said(RECTANGLE, &[FINISH], table), &["#FINISH theta"]);
    names(said(RECTANGLE, &[&format!("{ROUGH}, beta=5"), FINISH], table), &[]);
    names(said(RECTANGLE, &[&format!("{FINISH}, theta=5")], table), &[]);
    names(said(RECTANGLE, &[ROUGH], &format!("{table}entry_angle = 10\n")), &[]);
    names(said(OPEN, &[ROUGH, FINISH], table), &[]);
    names(said(OPEN, &[FINISH], table), &["#FINISH theta"]);
}

/// 4.25, 4.26: where the first point is not the lower left one, the signs of the distances say so.
#[test]
fn a_negative_distance_leads_the_other_way() {
    let hole = "#CYCLE G281 [X=0, Y=0, Z=0, ZS=5, P=2, F=100, S=1000, T=1]\n";
    let points = |figure: &str| -> Vec<String> {
        let mut found = moves(&format!("{hole}#MULTI {figure}\nM30"), "");
        found.retain(|line| line.contains('X') || line.contains('Y'));
        found
    };
    for (figure, expected) in [
        ("GRID [LX=20, LY=10, IX=-20, IY=-10]", ["rapid X-20", "rapid Y-10", "rapid X0"]),
        ("GRID [LX=-20, LY=-10, IX=20, IY=10]", ["rapid X-20", "rapid Y-10", "rapid X0"]),
        ("GRID [LX=-20, LY=-10, IX=-20, IY=-10]", ["rapid X-20", "rapid Y-10", "rapid X0"]),
        ("GRID [NX=2, NY=2, IX=-20, IY=-10]", ["rapid X-20", "rapid Y-10", "rapid X0"]),
        ("RECT [LX=20, LY=10, IX=20, IY=-10]", ["rapid X20", "rapid Y-10", "rapid X0"]),
    ] {
        assert_eq!(points(figure), expected, "{figure}");
    }
}

/// 3.1: the tool behind the cycle is made ready once the cycle needs no other any more.
#[test]
fn the_next_tool_is_made_ready_in_the_cycle() {
    let tools = "[tools.1]\nradius = 5\n[tools.2]\nradius = 5\n";
    let chosen = |program: &str| -> Vec<String> {
        let mut found = lines_on(&DIALECT, program, tools);
        found.retain(|line| line.starts_with("select") || line.starts_with("change"));
        found
    };
    let drill = "G281 [X=10, Y=20, Z=0, ZS=5, P=2, F=100, S=1000, T=1, D=1, next=2]";
    let in_spindle = format!("T1 D1 M6\n#CYCLE {drill}\n#MULTI LINE [alpha=0, N=3, I=10]\nM30");
    assert_eq!(chosen(&in_spindle), ["select 1", "change 1", "select 2"]);
    assert_eq!(chosen(&format!("#CYCLE {drill}\nM30")), ["select 1", "change 1", "select 2"]);
    let pocket = "#CYCLE G288 [XC=0, YC=0, R=20, Z=0, ZS=5, P=4, next=3]\n\
                  #ROUGH [step=4, I=2, F=100, S=1000, T=1, D=1]\n#FINISH [delta=0.5, F=100, S=1000, T=2, D=1, N=1]\nM30";
    assert_eq!(chosen(pocket), ["select 1", "change 1", "select 2", "change 2", "select 3"]);
    // 4.12: the dialogue asks for it with the finishing.
    let with_finishing = pocket.replace(", next=3", "").replace("N=1", "N=1, next=3");
    assert_eq!(chosen(&with_finishing), chosen(pocket));
    let fault =
        |program: &str| run_on(&DIALECT, program, tools).1.map(|alarm| (alarm.fault, alarm.span.line));
    assert_eq!(fault(&pocket.replace("N=1", "N=1, next=3")), Some((Fault::RepeatedAddress, 1)));
    assert_eq!(fault(&pocket.replace("I=2", "I=2, next=3")), Some((Fault::UnknownParameter, 1)));
}

/// 4.6.1: the spindle is oriented once, not at each of several points.
#[test]
fn rigid_tapping_of_several_points_orients_once() {
    let program = "#CYCLE G284 [X=10, Y=20, Z=0, ZS=5, P=10, type=rigid, feedtype=rev, F=1.5, S=1000, T=1]\n\
                   #MULTI LINE [alpha=0, N=3, I=10]\nM30";
    let found = lines_on(&DIALECT, program, "");
    assert_eq!(found.iter().filter(|line| line.starts_with("orient")).count(), 1, "{found:?}");
    assert_eq!(found.iter().filter(|line| line.starts_with("tap")).count(), 6, "{found:?}");
}

/// 4.6.1: a dwell has the spindle stopped, M05, whatever turned it; a feed a turn is one.
#[test]
fn a_tapped_hole_is_dwelt_in_with_the_spindle_stopped() {
    let tapped = |words: &str| {
        let program =
            format!("#CYCLE G284 [X=3, Y=4, Z=0, ZS=5, P=12, t=0.5, F=1.5, S=100, T=1, {words}]\nM30");
        let found = lines_on(&DIALECT, &program, "");
        let at = found.iter().position(|line| line.contains("Z-12")).unwrap();
        found[at..at + 4].to_vec()
    };
    assert_eq!(
        tapped("type=rigid, feedtype=rev"),
        ["tap 1.5 at 100 Z-12", "spindle off", "dwell 0.5s", "tap 1.5 at 100 Z1"]
    );
    assert_eq!(
        tapped("type=float, feedtype=rev"),
        ["feed Z-12 1.5/rev", "spindle off", "dwell 0.5s", "spindle ccw 100"]
    );
}

/// 4.20: each of the points has an icon of its corner, of which sharp is one.
#[test]
fn a_sharp_corner_is_no_corner() {
    let found = |point: &str| {
        let points = format!("P1=[10,0], P2={point}, P3=[50,30], P4=[50,30]");
        let head = format!("#CYCLE G293 [X1=0, Y1=0, {points}, Z=0, ZS=5, P=6]");
        moves(&format!("{head}\n#ROUGH [I=-6, F=100, S=1000, T=1, D=1]\nM30"), "[tools.1]\nradius = 3\n")
    };
    for point in ["[50,0,sharp]", "[50,0,Sharp,0]"] {
        assert_eq!(found(point), found("[50,0]"));
    }
    assert_ne!(found("[50,0,round,5]"), found("[50,0]"));
}

/// 1.1: the turning cycles of a combined machine have the same codes, and hold until they are switched off.
#[test]
fn turning_cycles_are_switched_on_and_off() {
    let drilled = "S1000 M3 F100\nG0 X0 Y0 Z20\n#LATHECY ON\n#LATHECY OFF\nG99 G81 X10 Z2 I-5\nM30";
    assert!(moves(drilled, "").contains(&"feed Z-5 F100".into()));
    let fault = |blocks: &str| {
        let (_, alarm) = run_on(&DIALECT, &format!("S1000 M3 F100\n{blocks}\nM30"), "");
        alarm.map(|alarm| (alarm.fault, alarm.span.line))
    };
    assert_eq!(fault("#LATHECY ON\nG0 X1\nG81 X10 Z2 I-5"), Some((Fault::NotSupported, 4)));
    assert_eq!(fault("#LATHECY MAYBE"), Some((Fault::UnknownDirective, 2)));
    // A milling cycle is over then.
    let over = "S1000 M3 F100\nG0 X0 Y0 Z20\nG99 G81 X10 Z2 I-5\n#LATHECY ON\nX20\nM30";
    assert_eq!(moves(over, "").last().map(String::as_str), Some("rapid X20"));
}

/// 4.19.1, 4.22.1: roughing ends over its start, finishing on the safety plane where it is.
#[test]
fn finishing_a_face_does_not_go_back_to_its_start() {
    let face = "#CYCLE G290 [X=10, Y=20, L=-40, H=20, Z=0, ZS=5, P=3, strategy=bidir_x, begin=ur]\n";
    let rough = "#ROUGH [step=8, E=2, I=3, FZ=50, F=500, S=1000, T=1, D=1]\n";
    let finish = "#FINISH [deltaz=0.5, F=300, S=900, T=1, D=1]\n";
    let tools = "[start]\nz = 50\n[tools.1]\nradius = 5\ncutting_length = 8\n";
    let ends = |parts: &str| moves(&format!("{face}{parts}M30"), tools).pop().unwrap();
    assert!(ends(rough).starts_with("rapid X"), "{}", ends(rough));
    assert_eq!(ends(&format!("{rough}{finish}")), "rapid Z5");
}

/// 1.1.3: functions stand before the point and the cycle, whose words are its own whatever it is made beside.
#[test]
fn a_cycle_beside_a_dwell_or_a_polar_origin_is_made() {
    let head = "S1000 M3 F100\nG0 X0 Y0 Z20\nG99";
    let found =
        lines_on(&DIALECT, &format!("{head}\nG83 X10 Z2 I-5 J1\nG4 K.5 G81 X20 Z2 I-8\nX30\nM30"), "");
    let expected =
        ["dwell 0.5s", "rapid X20", "feed Z-8 F100", "rapid Z2", "rapid X30", "feed Z-8 F100", "rapid Z2"];
    assert!(found.windows(expected.len()).any(|lines| lines == expected), "{found:?}");
    let found = moves(&format!("{head}\nG30 I10 J10 G81 R50 Q0 Z2 I-5\nM30"), "");
    assert!(found.contains(&"rapid X60 Y10".into()) && found.contains(&"feed Z-5 F100".into()), "{found:?}");
    // What takes the words of the point has a block of its own.
    for line in ["G20 X1 Y2 Z3 G85 Z2 I-5", "Z30 G160 I10 K2", "X40 G160 I10 K2", "G81 X10 Z2 G160 A10 K2"] {
        let program = format!("{head}\nG81 X10 Z2 I-5\n{line}\nM30");
        let (_, alarm) = run_on(&DIALECT, &program, "");
        assert_eq!(
            alarm.map(|alarm| (alarm.fault, alarm.span.line)),
            Some((Fault::NeedsOwnBlock, 5)),
            "{line}"
        );
    }
}

/// 2: all holes of a figure are made with the F of the definition, in its unit.
#[test]
fn the_feed_of_a_figure_has_the_unit_of_the_definition() {
    let found =
        moves("S1000 M3 F100\nG0 X0 Y0 Z20\nG99 G81 X10 Z2 I-5\nG95 F0.1\nX20\nG160 I10 K2\nX50\nM30", "");
    let cuts: Vec<&String> = found.iter().filter(|line| line.starts_with("feed Z-5")).collect();
    assert_eq!(cuts, ["feed Z-5 F100", "feed Z-5 0.1/rev", "feed Z-5 F100", "feed Z-5 F100"], "{found:?}");
}

/// 1.1.3: behind the parameters D and M are the offset and the function of the block; another letter stands once.
#[test]
fn a_letter_of_a_cycle_stands_once() {
    let head = "S1000 M3 F100\nG0 X0 Y0 Z20\nG99";
    let setup = "[tools.1]\nradius = 3\n[tools.2]\nradius = 2\n";
    let once = moves(&format!("{head}\nT1 D1 M6\nG88 X10 Z2 I-5 D2 J10 B5\nM30"), setup);
    let twice = moves(&format!("{head}\nT1 M6\nG88 X10 Z2 I-5 D2 J10 B5 D1\nM30"), setup);
    assert_eq!(once, twice);
    let (_, alarm) = run_on(&DIALECT, &format!("{head}\nG81 X10 Z2 I-5 I-50\nM30"), setup);
    assert_eq!(alarm.map(|alarm| alarm.fault), Some(Fault::RepeatedAddress));
}

/// The place of a hole beside the programmed one is none; nor is a pocket that is moved by the tool's radius.
#[test]
fn cycles_are_refused_while_cutter_compensation_is_in_force() {
    let program = "T1 D1 M6\nS1000 M3 F100\nG0 X0 Y0 Z20\nG41 G1 X10\nG88 X30 Z2 D2 I-5 J8 B5\nM30";
    let (_, alarm) = run_on(&DIALECT, program, "[tools.1]\nradius = 5\n");
    assert_eq!(alarm.map(|alarm| (alarm.fault, alarm.span.line)), Some((Fault::NotInCutter, 5)));
}

/// A described cycle starts the spindle (4.2): never at no speed at all. S of an earlier stage, or of the program, is one.
#[test]
fn a_described_cycle_needs_a_speed() {
    let hole = |s: &str| format!("#CYCLE G281 [X=0, Y=0, Z=0, ZS=5, P=2, F=100{s}, T=1]\nM30");
    let pocket = |rough: &str, finish: &str| {
        format!(
            "#CYCLE G287 [X=0, Y=0, L=60, H=30, Z=0, ZS=5, P=4]\n#ROUGH [step=4, I=4, F=500{rough}, T=1]\n\
             #FINISH [delta=0.5, N=1, F=300{finish}, T=1]\nM30"
        )
    };
    for (program, stands) in [
        (hole(""), true),
        (hole(", S=0"), true),
        (format!("S0\n{}", hole("")), true),
        (hole(", S=1000"), false),
        (format!("S1000\n{}", hole("")), false),
        (pocket("", ""), true),
        (pocket("", ", S=1000"), true),
        (pocket(", S=1000", ""), false),
    ] {
        let (steps, alarm) = run_on(&DIALECT, &program, "[tools.1]\nradius = 3\n");
        let fault = alarm.map(|alarm| alarm.fault);
        assert_eq!(fault, stands.then_some(Fault::CycleNoSpindle), "{program}");
        assert!(!stands || steps.iter().all(|step| step.op.target().is_none()), "{program}");
    }
}

/// What a cycle or a profile would leave aside is refused.
#[test]
fn nothing_of_a_cycle_is_left_aside() {
    let hole = "#CYCLE G281 [X=0, Y=0, Z=0, ZS=5, P=2, F=100, T=1";
    let milled = "#CYCLE G293 [X1=0, Y1=0, Z=0, ZS=5, P=2, P1=[10,0], P2=[20,0]";
    let rough = "]\n#ROUGH [T=1, F=100, I=2]\nM30";
    let profile =
        |block: &str| format!("#PROFILE a [XY]\nG0 X0 Y0\nG1 X10\n{block}\nG1 Y10\n#ENDPROFILE\nM30");
    for (program, fault) in [
        // 4.20, 4.27: lists of points end with the first that is missing.
        (format!("{milled}{rough}"), None),
        (format!("{milled}, P4=[20,10]{rough}"), Some(Fault::CycleParameterMissing)),
        (format!("{milled}, XN=30{rough}"), Some(Fault::CycleParameterMissing)),
        (format!("{hole}]\n#MULTI POINTS [P2=[9,0], P4=[9,9]]\nM30"), Some(Fault::CycleParameterMissing)),
        // 4.23, 4.24.
        (format!("{hole}]\n#MULTI LINE [XN=9, alpha=0, L=9, N=2]\nM30"), Some(Fault::PatternForm)),
        (format!("{hole}]\n#MULTI ARC [XA=9, R=9, alpha=0, N=2, tau=90]\nM30"), Some(Fault::PatternForm)),
        (format!("{hole}]\n#MULTI ARC [XA=9, YA=0, N=3, beta=30, tau=300]\nM30"), Some(Fault::PatternForm)),
        (format!("{hole}]\n#MULTI ARC [XA=9, YA=0, N=5, beta=30, tau=300]\nM30"), None),
        // 3.1: what M functions do comes before the moves.
        (format!("{hole}, M1=8, M2=0]\nM30"), None),
        (format!("{hole}, M1=30]\nM30"), Some(Fault::CycleParameter)),
        (format!("{hole}, M4=2]\nM30"), Some(Fault::CycleParameter)),
        (format!("{hole}, M2=6]\nM30"), Some(Fault::CycleParameter)),
        (format!("{hole}, S=-1000]\nM30"), Some(Fault::CycleParameter)),
        (format!("{hole}, D=-1]\nM30"), Some(Fault::CycleParameter)),
        (format!("{hole}, D=1.5]\nM30"), Some(Fault::CycleParameter)),
        // Part B of the syntax: the words of profiles.
        (profile("G36 I2"), None),
        (profile("G36 I2 X5"), Some(Fault::ProfileForm)),
        (profile("G37 I2 Y5"), Some(Fault::ProfileForm)),
        (profile("G90 G1 X20"), None),
        (profile("G91 G1 X20"), Some(Fault::ProfileForm)),
        (profile("G1 X20 Z-1"), Some(Fault::ProfileForm)),
        (profile("G1 X20 R5"), Some(Fault::ProfileForm)),
        (profile("G1 X20 S500"), Some(Fault::ProfileForm)),
        (profile("G1 X20 T2"), Some(Fault::ProfileForm)),
        (profile("G2 X20 I5"), None),
        (profile("G2 X20 I5 K0"), Some(Fault::ProfileForm)),
    ] {
        let (_, alarm) = run_on(&DIALECT, &format!("S1000\n{program}"), "[tools.1]\nradius = 1\n");
        assert_eq!(alarm.map(|alarm| alarm.fault), fault, "{program}");
    }
}

#[test]
fn the_number_of_repetitions_is_an_expression() {
    let holes = |word: &str| {
        let program = format!("P1=2\nF100 S500 M3\nG0 Z20\nG99 G81 Z2 I-5\nG91 X10 {word}\nM30");
        moves(&program, "").iter().filter(|line| line.starts_with("feed Z-5")).count()
    };
    // One of the definition, and those of the block (1.1.1).
    for (word, count) in
        [("", 2), ("NR3", 4), ("NR[3]", 4), ("NR [P1+1]", 4), ("NRP1", 3), ("NR=P1", 3), ("NR[0]", 1)]
    {
        assert_eq!(holes(word), count, "{word}");
    }
}

#[test]
fn an_internal_thread_goes_up_in_the_middle_between_its_passes() {
    let setup = "[start]\nz = 50.0\n[tools.1]\nradius = 5.0";
    let thread = |words: &str| {
        moves(
            &format!("T1 D1 M6\nG0 X0 Y0 Z20 F100 S500 M3\nG99 G211 Z2 D2 I-6 J30 K1 {words} E2\nM30"),
            setup,
        )
    };
    // 1.11, steps 7, 8 and 3: to the middle, up there, out.
    let made = thread("B1.5 C1 A0.5");
    let between = made.iter().skip_while(|line| !line.starts_with("xy X7.5")).skip(1).take(3);
    assert_eq!(between.collect::<Vec<_>>(), ["rapid X0", "rapid Z0.75", "rapid X8"], "{made:?}");
    // Between the turns of a pass it stays aside.
    let made = thread("B1.5 C2");
    assert_eq!(made.iter().filter(|line| line.starts_with("rapid X0")).count(), 1, "{made:?}");
}

#[test]
fn half_the_pocket_as_the_pass_asks_for_the_wall_alone() {
    let setup = "[start]\nz = 25.0\n[tools.1]\nradius = 5.0";
    for cycle in ["G99 G87 Z2 I-5 J-40 K20 M0 B10 C20 L2 H300", "G99 G88 Z2 I-5 J20 B10 C20 L3 H300"] {
        let made = moves(&format!("T1 D1 M6\nG0 F800 S100\n{cycle}\nM30"), setup);
        // Down to the bottom, and along the wall at its feed.
        assert!(made.iter().any(|line| line.contains("F300")), "{made:?}");
    }
    // Any other pass is no wider than the tool.
    let (_, alarm) = run_on(&DIALECT, "T1 D1 M6\nG0 F800 S100\nG99 G88 Z2 I-5 J20 B10 C19 L3\nM30", setup);
    assert_eq!(alarm.map(|alarm| alarm.fault), Some(Fault::CycleStepTooWide));
}
