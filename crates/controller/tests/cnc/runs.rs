//! A program from cycle start to its end: states, times to a period, path and limits.

use crate::common::panel::Mill;
use crate::common::{ACTIVITIES, Hand, cnc, cnc_with, ended, machine, run, run_with};
use ferrocut_controller::api::{self, Command};
use ferrocut_controller::{Activity, Cnc, Drives, Event, State, Tick};
use ferrocut_geometry::{Axis, Position};

/// A little of everything that moves.
const MIXED: &str = "G0 Z20\nT1 M6\nG0 X10 Y10 S1000 M3\nG1 Z-2 F600\nX40 F2000\nG3 X50 Y20 R10\nG1 Y40\n\
                     X10 Y10\nG2 I5 Z-4\nG4 X0.2\nG81 X20 Y20 Z-6 R2 F300\nG80 G0 Z20 A90\nX0 Y0 M5\nM30\n";

#[test]
fn from_cycle_start_to_the_end() {
    let machine = machine();
    let mut cnc = cnc(&machine, MIXED);
    assert_eq!(cnc.state(), &State::Ready);
    // Before cycle start nothing moves and no time passes.
    for _ in 0..10 {
        let tick = cnc.tick();
        assert_eq!((tick.position, tick.velocity, tick.moving), (Position::ZERO, 0.0, false));
    }
    assert_eq!(cnc.report().total(), 0.0);
    let run = run(&mut cnc);
    assert_eq!(cnc.state(), &State::Ended);
    let mut end = Position::xyz(0.0, 0.0, 20.0);
    end[Axis::A] = 90.0;
    assert_eq!(run.end(), end);
    assert_eq!((cnc.report().parts, cnc.report().tool()), (1, 1));
    assert_eq!(run.events, [Event::ToolChange(1)]);
    run.check_limits(&machine, false);
    // Behind the end there is nothing, whatever is pressed.
    cnc.cycle_start();
    cnc.feed_hold();
    assert_eq!(cnc.tick().position, end);
    assert_eq!(cnc.state(), &State::Ended);
    assert_eq!(cnc.report().parts, 1);
}

#[test]
fn every_tick_is_counted_once() {
    let machine = machine();
    let (cnc, run) = ended(&machine, MIXED);
    let report = cnc.report();
    let period = machine.servo_period_ms / 1000.0;
    // The tick that finds the end takes no time.
    assert!((report.total() - (run.ticks.len() - 1) as f64 * period).abs() < 1e-9);
    let sum: f64 = ACTIVITIES.iter().map(|a| report.time(*a)).sum();
    assert!((report.total() - sum).abs() < 1e-9);
    let tools: f64 = report.tools().map(|(_, s)| s).sum();
    assert!((report.total() - tools).abs() < 1e-9);
    let moving = run.ticks.iter().filter(|t| t.moving).count() as f64 * period;
    assert!((report.time(Activity::Cutting) + report.time(Activity::Rapid) - moving).abs() < 1e-9);
}

#[test]
fn distances_and_extents_are_those_of_the_program() {
    let machine = machine();
    let program = "M3 S1000\nG0 X30 Y40\nG1 X30 Y100 F3000\nG2 X50 Y100 R10\nG3 I-20 Z-5\nG0 A90\nM30\n";
    let (cnc, _) = ended(&machine, program);
    let report = cnc.report();
    let turn = std::f64::consts::TAU;
    // 50 mm to (30, 40); 60 mm, a half circle of radius 10, one turn of radius 20 that climbs 5 mm;
    // degrees are no distance.
    assert!((report.rapid_mm - 50.0).abs() < 1e-9, "{}", report.rapid_mm);
    let cut = 60.0 + turn / 2.0 * 10.0 + (turn * 20.0).hypot(5.0);
    assert!((report.cutting_mm - cut).abs() < 1e-9, "{} {cut}", report.cutting_mm);
    assert_eq!(report.moves, 5);
    let (min, max) = report.extent.unwrap();
    // The circle about (30, 100) reaches from 10 to 50 and from 80 to 120.
    let close = |a: Position, b: [f64; 4]| a.0.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9);
    assert!(close(min, [0.0, 0.0, -5.0, 0.0]), "{min:?}");
    assert!(close(max, [50.0, 120.0, 0.0, 90.0]), "{max:?}");
}

#[test]
fn cuts_keep_the_feed_and_the_limits_of_cutting() {
    let machine = machine();
    // 6000 mm/min is the highest feed of the control: 100 mm/s, and no axis gets faster in a corner,
    // an arc or a helix.
    let program = "M3 S1000\nG1 X200 F6000\nY100\nX0 Y0\nG3 X20 R10\nG2 I-5\nG3 X0 Y20 I-20 Z-30\n\
                   G1 X0.5 Y20.5\nX1 Y20\nX1.5\nX1 Y0\nM30\n";
    let (_, run) = ended(&machine, program);
    run.check_limits(&machine, true);
    let period = machine.servo_period_ms / 1000.0;
    let mut before = run.start;
    let mut fastest = 0.0_f64;
    for tick in &run.ticks {
        fastest = fastest.max(before.distance(tick.position) / period);
        before = tick.position;
    }
    // The helix has its feed along the circle (GSK990MC 4.2.3 B), which adds its climb.
    assert!(fastest > 99.0 && fastest < 100.0 * 1.5, "{fastest}");
    let (_, flat) = ended(&machine, "M3 S1000\nG1 X200 F6000\nY100\nG3 X180 Y120 R20\nG1 X0 Y0\nM30\n");
    let mut before = flat.start;
    for tick in &flat.ticks {
        assert!(before.distance(tick.position) / period <= 100.0 * 1.001);
        before = tick.position;
    }
}

#[test]
fn the_end_of_every_stop_is_the_programmed_point() {
    let machine = machine();
    // What stands between two moves makes the first end exactly.
    for between in ["G4 X0.01", "M8", "M0", "T2", "S900", "M10", "G0 X5 Y5"] {
        let program = format!("M3 S1000\nG1 X12.345 Y-6.789 Z0.001 F3000\n{between}\nG1 X20 F3000\nM30\n");
        let mut cnc = cnc(&machine, &program);
        let mut ticks = run(&mut cnc).ticks;
        if between == "M0" {
            assert_eq!(cnc.state(), &State::Stopped(0));
            ticks.extend(run(&mut cnc).ticks);
        }
        let corner = Position::xyz(12.345, -6.789, 0.001);
        assert!(ticks.iter().any(|t| t.position == corner), "{between}");
        assert_eq!(cnc.state(), &State::Ended);
    }
}

#[test]
fn exact_stop_machines_reach_every_corner() {
    let mut machine = machine();
    machine.path.exact_stop = true;
    let corners = [(10.0, 0.0), (10.0, 10.0), (10.1, 10.0), (20.0, 10.0), (20.0, 10.001), (0.0, 0.0)];
    let blocks: String = corners.iter().map(|(x, y)| format!("G1 X{x} Y{y} F3000\n")).collect();
    let (_, run) = ended(&machine, &format!("M3 S1000\n{blocks}M30\n"));
    run.check_limits(&machine, true);
    let mut ticks = run.ticks.iter();
    for (x, y) in corners {
        // In their order, each at rest for a setpoint.
        assert!(ticks.any(|t| t.position == Position::xyz(x, y, 0.0)), "{x} {y}");
    }
}

#[test]
fn dwell_spindle_and_changer_take_their_times_to_a_period() {
    for period_ms in [0.25, 1.0, 2.0] {
        let mut machine = machine();
        machine.servo_period_ms = period_ms;
        machine.spindle.acceleration_rpm_s = 4000.0;
        machine.tool_change.time_s = 5.0;
        let cases: &[(&str, Activity, f64)] = &[
            ("G4 X0.1", Activity::Dwell, 0.1),
            ("G4 P100", Activity::Dwell, 0.1),
            ("G4 X0.0001", Activity::Dwell, 0.0001),
            ("G4 X0.1005", Activity::Dwell, 0.1005),
            // Up, and down at the end of the program.
            ("M3 S1000", Activity::Spindle, 0.5),
            // Up, to the other sense, off: 1000 + 2000 + 1000 r/min.
            ("M3 S1000\nM4\nM5", Activity::Spindle, 1.0),
            // A new speed; more than the machine reaches is held at 6000 by the control (P258).
            ("M3 S1000\nS3000\nM5", Activity::Spindle, 1.5),
            ("M3 S99999\nM5", Activity::Spindle, 3.0),
            ("M5", Activity::Spindle, 0.0),
            ("T1 M6\nT2 M6", Activity::ToolChange, 10.0),
            // M06 stops the spindle first.
            ("M3 S2000\nT3 M6", Activity::Spindle, 1.0),
            ("G82 Z-1 R0 P500 F100 S1000\nG80", Activity::Dwell, 0.5),
        ];
        for (program, activity, seconds) in cases {
            let (cnc, _) = ended(&machine, &format!("{program}\nM30\n"));
            let period = period_ms / 1000.0;
            // Each pause is rounded up to whole periods.
            let expected = (seconds / period - 1e-9).ceil() * period;
            let found = cnc.report().time(*activity);
            assert!((found - expected).abs() < 1e-9, "{program} at {period_ms} ms: {found} for {expected}");
        }
    }
}

#[test]
fn a_pause_stands_still_where_the_move_before_it_ended() {
    let machine = machine();
    let (_, run) = ended(&machine, "G0 X10\nG4 X0.05\nX20\nM30\n");
    let at_ten: Vec<Tick> =
        run.ticks.iter().copied().filter(|t| t.position == Position::xyz(10.0, 0.0, 0.0)).collect();
    let (moving, still): (Vec<Tick>, Vec<Tick>) = at_ten.into_iter().partition(|t| t.moving);
    // The one that arrives, and 50 of the dwell.
    assert_eq!((moving.len(), still.len()), (1, 50));
    assert!(still.iter().all(|t| t.velocity == 0.0 && t.span.line == 2));
}

#[test]
fn stops_wait_for_cycle_start() {
    let machine = machine();
    let program = "G0 X10 M0\nX20 M1\nX30\nM30\n";
    let mut control = cnc_with(&machine, program, "[options]\noptional_stop = true");
    let mut at = Vec::new();
    for _ in 0..2 {
        let part = run(&mut control);
        at.push((control.state().clone(), part.end()[Axis::X]));
        part.check_limits(&machine, false);
        // As long as it takes; feed hold is nothing here.
        let before = control.report().total();
        control.feed_hold();
        for _ in 0..100 {
            assert_eq!(control.tick().position, part.end());
        }
        assert_eq!(control.report().total(), before);
    }
    assert_eq!(at, [(State::Stopped(0), 10.0), (State::Stopped(1), 20.0)]);
    assert_eq!(run(&mut control).end()[Axis::X], 30.0);
    assert_eq!((control.state(), control.report().parts), (&State::Ended, 1));
    // With the switch off M01 is nothing.
    let mut control = cnc(&machine, program);
    assert_eq!(run(&mut control).end()[Axis::X], 10.0);
    assert_eq!(run(&mut control).end()[Axis::X], 30.0);
    assert_eq!(control.state(), &State::Ended);
}

#[test]
fn feed_override_scales_cuts_and_rapid_override_positioning() {
    let machine = machine();
    let program = "M3 S1000\nG1 X300 F1200\nG0 X0\nM30\n";
    let times = |feed: f64, rapid: f64| {
        let mut cnc = cnc(&machine, program);
        cnc.set_override(feed, rapid);
        let run = run(&mut cnc);
        run.check_limits(&machine, false);
        assert_eq!(run.end(), Position::ZERO);
        (cnc.report().time(Activity::Cutting), cnc.report().time(Activity::Rapid))
    };
    // 300 mm at 20 mm/s: 15 s and one time of speeding up at 50000 mm/s³, 2·√(20/50000) s; at rapid 250 mm/s
    // 1.2 s, 250/2000 s and 2000/50000 s. A period each for the remainder.
    let close = |a: f64, b: f64| (a - b).abs() <= 0.0021;
    let (cut, rapid) = times(1.0, 1.0);
    assert!(close(cut, 15.04) && close(rapid, 1.365), "{cut} {rapid}");
    let (cut, rapid) = times(0.5, 1.0);
    assert!(close(cut, 30.0283) && close(rapid, 1.365), "{cut} {rapid}");
    let (cut, rapid) = times(2.0, 0.5);
    assert!(close(cut, 7.5566) && close(rapid, 2.5025), "{cut} {rapid}");
    // Beyond its range an override is held at it.
    assert_eq!(times(3.0, 1.5), times(2.0, 1.0));
}

#[test]
fn feed_override_of_nought_stands_still_until_it_is_raised() {
    let machine = machine();
    let mut cnc = cnc(&machine, "M3 S1000\nG1 X300 F6000\nM30\n");
    let hands = [(600, Hand::Override(0.0, 1.0)), (2000, Hand::Override(1.5, 1.0))];
    let run = run_with(&mut cnc, &hands);
    run.check_limits(&machine, true);
    let still: Vec<f64> = run.ticks[1000..2000].iter().map(|t| t.position[Axis::X]).collect();
    assert!(still[0] > 0.0 && still[0] < 300.0 && still.iter().all(|x| *x == still[0]));
    assert_eq!((run.end()[Axis::X], cnc.state()), (300.0, &State::Ended));
}

#[test]
fn feed_per_revolution_takes_the_spindle_s_speed() {
    let machine = machine();
    // 0.5 mm a turn at 600 r/min: 5 mm/s, and 2·√(5/50000) s of speeding up.
    let (cnc, _) = ended(&machine, "M3 S600\nG95 G1 X10 F0.5\nM30\n");
    let cut = cnc.report().time(Activity::Cutting);
    assert!((cut - 2.02).abs() <= 0.0021, "{cut}");
    // Turns of the spindle as a dwell (34#0): 10 turns at 600 r/min.
    let mut cnc = cnc_with(&machine, "M3 S600\nG95 G4 X10\nM30\n", "[parameters]\n\"NO34.0\" = 1");
    run(&mut cnc);
    assert!((cnc.report().time(Activity::Dwell) - 1.0).abs() < 1e-9);
}

#[test]
fn the_same_program_gives_the_same_ticks() {
    let machine = machine();
    let (a, first) = ended(&machine, MIXED);
    let (b, second) = ended(&machine, MIXED);
    assert_eq!(first.ticks, second.ticks);
    assert_eq!((a.report(), first.events), (b.report(), second.events));
}

/// Round a square with round corners, from the zero point and back to it. Sums of lengths that went on from what was run before
/// would be rounded in other digits, and curves fitted to the last of them be others in the seventh.
#[test]
fn a_job_is_the_same_to_the_last_bit_whatever_was_run_before_it() {
    let round = "G1 X-70\nG3 X-80 Y-20 J-10\nG1 Y-70\nG3 X-70 Y-80 I10\nG1 X-20\nG3 X-10 Y-70 J10\n\
                 G1 Y-20\nG3 X-20 Y-10 I-10\n";
    let job = format!("G90 G17 G1 X-20 Y-10 F2400\n{round}{round}G4 P30\nG1 X0 Y0 Z-3\nZ0\nM30\n");
    let mut mill = Mill::power_on();
    mill.home();
    mill.press("KEY_AUTO");
    mill.say(Command::Store { program: "O0001".into(), text: job });
    mill.say(Command::Select { program: "O0001".into() });
    let mut runs = Vec::new();
    for before in ["", "G1 X-0.1 F1000\nX0", "G1 X-300.7 Y-200 F4000\nX0 Y0"] {
        if !before.is_empty() {
            mill.mdi(before);
        }
        mill.press("KEY_AUTO");
        mill.key("KEY_START", true);
        mill.say(Command::Key { key: "KEY_START".into(), down: false });
        let mut places: Vec<_> = (0..25_000).map(|_| mill.control.tick().position).collect();
        let first = places.iter().position(|place| *place != places[0]);
        places.drain(..first.unwrap_or_else(|| panic!("nothing moves: {:?}", mill.events)));
        mill.until("done", |status| status.activity == api::Activity::Idle);
        assert_eq!(places.last(), places.iter().rev().nth(1000), "at rest");
        runs.push(places);
    }
    for (run, places) in runs.iter().enumerate().skip(1) {
        let other = places.iter().zip(&runs[0]).position(|(one, other)| one != other);
        assert_eq!(other, None, "the first place of run {run} that is another");
    }
}

#[test]
fn main_program_ended_by_m99_counts_no_part() {
    let machine = machine();
    let (cnc, run) = ended(&machine, "G90 G0 X10\nX0\nM99\n");
    assert_eq!((cnc.report().parts, run.end()), (0, Position::ZERO));
}

/// Drives that stay behind by a quarter of a millimetre.
struct Lagging;

impl Drives for Lagging {
    fn exchange(&mut self, commanded: &Position) -> Position {
        let mut actual = *commanded;
        actual[Axis::X] -= 0.25;
        actual
    }
}

#[test]
fn a_program_that_reads_the_machine_waits_until_it_is_at_rest() {
    let machine = machine();
    let program = "G1 X20 F3000\n#500=#5006\n#501=#5026\nG0 X[#500+10]\nM30\n";
    // Without 17#7 nobody waits until the axis is within P131.
    let interpreter = crate::common::interpreter(program, "[parameters]\n\"NO17.7\" = 0");
    let mut cnc = Cnc::with_drives(&machine, interpreter, Box::new(Lagging));
    let run = run(&mut cnc);
    assert_eq!(cnc.state(), &State::Ended);
    assert_eq!(run.end()[Axis::X], 30.0);
    let variable = |n| cnc.interpreter().memory().variables.get(n);
    assert_eq!((variable(500), variable(501)), (Some(20.0), Some(0.25)));
    // It came to rest on the end of the move before it read.
    assert!(run.ticks.iter().any(|t| t.position[Axis::X] == 20.0 && !t.moving));
}

#[test]
fn a_loop_that_waits_for_an_input_takes_time() {
    let machine = machine();
    let mut cnc = cnc(&machine, "WHILE[#1000 EQ 0]DO1\nEND1\nG0 X1\nM30\n");
    cnc.cycle_start();
    for _ in 0..100 {
        assert!(!cnc.tick().moving);
    }
    assert_eq!(cnc.state(), &State::Running);
}
