//! What the machine refuses before anything moves, and what it warns of.

use crate::common::{alarmed, cnc, cnc_with, ended, machine, run};
use ferrocut_controller::{Activity, Event, State};
use ferrocut_geometry::{Axis, Position};
use ferrocut_machine::{AlarmId, Fault, Severity};

fn number(id: AlarmId) -> Option<u16> {
    id.number()
}

#[test]
fn a_move_beyond_a_limit_does_not_begin() {
    let machine = machine();
    for program in [
        "M3 S1000\nG0 X100\nG1 X500.01 F1000\nM30\n",
        "M3 S1000\nG0 X100\nX501\nM30\n",
        "M3 S1000\nG0 X100\nG91 X200\nX200\nX200\nM30\n",
        "M3 S1000\nG0 X100\nG54 X501 Y3\nM30\n",
    ] {
        let mut cnc = cnc(&machine, program);
        let (alarm, run) = alarmed(&mut cnc);
        // GSK990MC appendix 2: 0501, the positive side of X.
        assert_eq!((number(alarm.id), alarm.fault), (Some(501), Fault::SoftLimit), "{program}");
        let end = run.end();
        assert!(
            end == Position::xyz(100.0, 0.0, 0.0) || end == Position::xyz(500.0, 0.0, 0.0),
            "{program} {end:?}"
        );
        run.check_limits(&machine, false);
        assert_eq!(cnc.report().parts, 0);
    }
}

#[test]
fn every_axis_has_its_numbers() {
    // 0500 to 0507: X Y Z and the fourth axis, negative side first.
    let machine = machine();
    for (block, expected) in [
        ("X-501", 500),
        ("X501", 501),
        ("Y-401", 502),
        ("Y401", 503),
        ("Z-401", 504),
        ("Z201", 505),
        ("A-36001", 506),
        ("A36001", 507),
    ] {
        let (alarm, run) = alarmed(&mut cnc(&machine, &format!("G91 G0 {block}\nM30\n")));
        assert_eq!((number(alarm.id), alarm.span.line), (Some(expected), 1), "{block}");
        assert_eq!(run.end(), Position::ZERO);
    }
}

#[test]
fn the_limit_itself_can_be_reached() {
    let machine = machine();
    let (_, run) = ended(&machine, "G0 X500 Y-400 Z200\nX-500 Y400 Z-400\nM30\n");
    assert_eq!(run.end(), Position::xyz(-500.0, 400.0, -400.0));
    // Sums of decimals: 5000 × 0.1.
    let (_, run) = ended(&machine, "O1\nG91 G0\nM98 P2 L5000\nM30\nO2\nX0.1\nM99\n");
    assert!((run.end()[Axis::X] - 500.0).abs() < 1e-6);
}

#[test]
fn arcs_count_by_their_true_extent() {
    let machine = machine();
    let head = "M3 S1000\nG0 X495 Y10\n";
    // Clockwise from (495, 10) to (495, -10) it bulges to X505, counter-clockwise to X485; radius 5 to
    // X500 and no further.
    let bulges = format!("{head}G2 Y-10 J-10 F1000\nM30\n");
    let (alarm, run) = alarmed(&mut cnc(&machine, &bulges));
    assert_eq!((number(alarm.id), alarm.span.line), (Some(501), 3));
    assert_eq!(run.end(), Position::xyz(495.0, 10.0, 0.0));
    for good in ["G3 Y-10 J-10 F1000", "G2 Y0 J-5 F1000", "G3 I-3 F1000"] {
        ended(&machine, &format!("{head}{good}\nM30\n"));
    }
    let (alarm, _) = alarmed(&mut cnc(&machine, &format!("{head}G2 I5.1 F1000\nM30\n")));
    assert_eq!(number(alarm.id), Some(501));
    // A helix that climbs beyond, an arc in another plane, and the same below.
    let (alarm, _) = alarmed(&mut cnc(&machine, "M3 S1000\nG2 I5 Z201 F1000\nM30\n"));
    assert_eq!(number(alarm.id), Some(505));
    let (alarm, _) = alarmed(&mut cnc(&machine, "M3 S1000\nG0 Z195\nG18 G2 X-20 I-10 F1000\nM30\n"));
    assert_eq!(number(alarm.id), Some(505));
    ended(&machine, "M3 S1000\nG0 Z195\nG18 G3 X-20 I-10 F1000\nM30\n");
}

#[test]
fn a_way_back_from_beyond_is_free() {
    let machine = machine();
    let mut back = cnc_with(&machine, "G0 X490\nM30\n", "[start]\nx = 510");
    run(&mut back);
    // The move begins beyond the limit: refused or run, but never further out.
    if let State::Alarmed(alarm) = back.state() {
        assert_eq!(alarm.fault, Fault::SoftLimit);
    } else {
        assert_eq!(back.tick().position[Axis::X], 490.0);
    }
    let (alarm, run) = alarmed(&mut cnc_with(&machine, "G0 X520\nM30\n", "[start]\nx = 510"));
    assert_eq!((alarm.fault, run.end()[Axis::X]), (Fault::SoftLimit, 510.0));
}

#[test]
fn an_alarm_of_the_program_waits_for_the_moves_before_it() {
    let machine = machine();
    for (bad, id) in [("G77", 10), ("G1 X5 F0", 11), ("M98 P9", 78), ("#1=1/0", 112), ("G2 X60 R1", 20)] {
        let program = format!("M3 S1000\nG0 X10 Y20\nG1 X50 Y20 F3000\nX10\n{bad}\nX99\nM30\n");
        let mut cnc = cnc(&machine, &program);
        let (alarm, run) = alarmed(&mut cnc);
        assert_eq!((number(alarm.id), alarm.span.line), (Some(id), 5));
        assert_eq!(run.end(), Position::xyz(10.0, 20.0, 0.0), "{bad}");
        assert_eq!((cnc.report().moves, cnc.report().parts), (3, 0));
        run.check_limits(&machine, false);
        // It stays there, whatever is pressed.
        cnc.cycle_start();
        cnc.feed_hold();
        assert_eq!(cnc.tick().position, run.end());
        assert!(matches!(cnc.state(), State::Alarmed(_)));
    }
}

#[test]
fn tools_and_speeds_that_the_machine_lacks() {
    let mut machine = machine();
    machine.tool_change.tools = 24;
    machine.spindle.max_rpm = 4000.0;
    let (alarm, run) = alarmed(&mut cnc(&machine, "G0 X1\nT25 M6\nX2\nM30\n"));
    assert_eq!((number(alarm.id), alarm.fault), (Some(184), Fault::ToolMissing));
    assert_eq!(run.end()[Axis::X], 1.0);
    ended(&machine, "T24 M6\nM30\n");
    let (alarm, run) = alarmed(&mut cnc(&machine, "G0 X1\nM3 S4001\nX2\nM30\n"));
    assert_eq!((number(alarm.id), alarm.fault), (Some(182), Fault::SpindleTooFast));
    assert_eq!(run.end()[Axis::X], 1.0);
    ended(&machine, "M3 S4000\nM30\n");
    // Without a count of places every tool is there.
    machine.tool_change.tools = 0;
    ended(&machine, "T9999 M6\nM30\n");
}

#[test]
fn cutting_with_the_spindle_at_rest_is_a_warning_once() {
    let machine = machine();
    let warnings = |program: &str| {
        let (_, run) = ended(&machine, program);
        let warnings: Vec<u32> = run
            .events
            .iter()
            .filter_map(|e| match e {
                Event::Warning(alarm) => Some(alarm),
                _ => None,
            })
            .inspect(|a| assert_eq!((a.fault, a.severity), (Fault::CuttingSpindleStopped, Severity::Warning)))
            .map(|a| a.span.line)
            .collect();
        warnings
    };
    assert_eq!(warnings("G1 X1 F100\nX2\nG2 I1\nM30\n"), [1]);
    assert_eq!(warnings("M3 S100\nG1 X1 F100\nM5\nX2\nX3\nM30\n"), [4]);
    assert_eq!(warnings("M3 S100\nG1 X1 F100\nM5\nG0 X2\nM30\n"), [0_u32; 0]);
    // S0 does not turn it.
    assert_eq!(warnings("M3 S0\nG1 X1 F100\nM30\n"), [2]);
}

#[test]
fn feed_per_revolution_needs_a_turning_spindle() {
    let machine = machine();
    for program in [
        "G0 X1\nG95 G1 X10 F0.5\nM30\n",
        "G0 X1\nG95 F0.5 G3 X11 R5\nM30\n",
        "M3 S9\nG0 X1\nM5\nG95 G1 X9 F1\nM30\n",
    ] {
        let mut cnc = cnc(&machine, program);
        let (alarm, run) = alarmed(&mut cnc);
        assert_eq!(alarm.fault, Fault::FeedNotReachable, "{program}");
        assert_eq!(run.end()[Axis::X], 1.0);
        assert_eq!(cnc.report().time(Activity::Cutting), 0.0);
    }
    let turns = "[parameters]\n\"NO34.0\" = 1";
    let (alarm, _) = alarmed(&mut cnc_with(&machine, "G95 G4 X3\nM30\n", turns));
    assert_eq!(alarm.fault, Fault::FeedNotReachable);
}

#[test]
fn an_axis_that_the_machine_lacks_cannot_be_moved() {
    let mut machine = machine();
    machine.axes.retain(|a| a.name != Axis::A);
    let mut cnc = cnc(&machine, "G0 X1\nG0 X2 A90\nM30\n");
    let (alarm, run) = alarmed(&mut cnc);
    assert_eq!((alarm.fault, alarm.span.line), (Fault::UnknownAxis, 2));
    assert_eq!(run.end(), Position::xyz(1.0, 0.0, 0.0));
    // One that stands still needs no motor.
    ended(&machine, "G0 X1 A0\nM30\n");
}
