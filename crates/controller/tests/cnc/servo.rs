//! Acceleration after interpolation, compensation and supervision in a run.

use crate::common::{Hand, Run, alarmed, cnc, ended, interpreter, machine, run, run_with};
use ferrocut_controller::{Activity, Cnc, Drives, State};
use ferrocut_geometry::{Axis, Position};
use ferrocut_machine::{AlarmId, Backlash, Fault, Machine, PitchErrors, Smoothing};
use proptest::prelude::*;
use std::sync::{Arc, Mutex};

/// Drives that write down what they are told, and do it.
struct Recorder(Arc<Mutex<Vec<Position>>>);

impl Drives for Recorder {
    fn exchange(&mut self, commanded: &Position) -> Position {
        self.0.lock().unwrap().push(*commanded);
        *commanded
    }
}

/// Drives that stay behind by a part of the way, and at the end by a rest.
struct Lazy {
    at: Position,
    share: f64,
    rest: f64,
}

impl Drives for Lazy {
    fn exchange(&mut self, commanded: &Position) -> Position {
        let way = *commanded - self.at;
        self.at = self.at.zip(way, |at, d| at + d * self.share);
        self.at - Position::xyz(self.rest, 0.0, 0.0)
    }
}

fn smooth() -> Machine {
    let mut machine = machine();
    for axis in &mut machine.axes {
        axis.after_rapid = Smoothing::Exponential { time_ms: 30.0, least: 10.0 };
        axis.after_cutting = Smoothing::Linear { time_ms: 80.0 };
    }
    machine
}

const PROGRAM: &str = "S800 M3\nG0 X20 Y10 Z5\nG1 Z-1 F1500\nX60 F5000\nG3 X70 Y20 R10\nG1 Y40\nG61 X60\n\
                       Y30\nG64 X50\nG4 X0.1\nG0 X0 Y0 A45\nG1 X10 F3000\nM30\n";

/// Whether one of the positions is this one.
fn is_reached(run: &Run, at: [f64; 3]) -> bool {
    run.ticks.iter().any(|t| t.position.0[..3] == at)
}

#[test]
fn smoothed_axes_are_where_the_program_means_them_to_be() {
    let (plain, through) = ended(&machine(), PROGRAM);
    let (cnc, run) = ended(&smooth(), PROGRAM);
    run.check_limits(&smooth(), false);
    assert_eq!(run.end(), through.end());
    // Positioning is over before cutting begins, G61 stops, and a dwell begins at rest.
    for at in
        [[20.0, 10.0, 5.0], [60.0, 40.0, -1.0], [60.0, 30.0, -1.0], [50.0, 30.0, -1.0], [0.0, 0.0, -1.0]]
    {
        assert!(is_reached(&through, at) && is_reached(&run, at), "{at:?}");
    }
    let time = |cnc: &Cnc, activity| cnc.report().time(activity);
    for activity in [Activity::Dwell, Activity::Spindle] {
        assert_eq!(time(&cnc, activity), time(&plain, activity));
    }
    // Every stop takes the window once more, 80 ms less a period.
    let stops = ((time(&cnc, Activity::Cutting) - time(&plain, Activity::Cutting)) / 0.079).round();
    assert_eq!(stops, 4.0, "two under G61, before the dwell and at the end");
    assert!(time(&cnc, Activity::Rapid) > time(&plain, Activity::Rapid) + 0.1);
    assert_eq!(
        (cnc.report().moves, cnc.report().cutting_mm),
        (plain.report().moves, plain.report().cutting_mm)
    );
}

#[test]
fn drives_are_told_the_compensated_position_and_nobody_else() {
    let mut machine = machine();
    machine.axes[0].backlash = Backlash { cutting: 0.02, ..Backlash::default() };
    machine.axes[1].pitch_errors = Some(PitchErrors {
        start: Some(0.0),
        interval: Some(100.0),
        corrections: vec![0.0, 0.1],
        opposite: Vec::new(),
    });
    let program = "G0 X50 Y50\nX20\nG4 X0.1\nM30\n";
    let (_, plain) = ended(&crate::common::machine(), program);
    let told = Arc::new(Mutex::new(Vec::new()));
    let drives = Box::new(Recorder(told.clone()));
    let run = run(&mut Cnc::with_drives(&machine, interpreter(program, ""), drives));
    let positions = |run: &Run| run.ticks.iter().map(|t| t.position).collect::<Vec<_>>();
    assert_eq!(positions(&run), positions(&plain));
    assert!(run.ticks.iter().all(|t| t.actual == t.position));
    let last = *told.lock().unwrap().last().unwrap();
    assert!((last - Position::xyz(19.98, 50.05, 0.0)).0.iter().all(|d| d.abs() < 1e-12), "{last:?}");
}

#[test]
fn backlash_by_parameters_is_waited_for() {
    let run_with_bits = |bits: &str| {
        let setup = format!("[parameters]\nP190 = 0.03\nP195 = 0.0001\n{bits}");
        let mut cnc = Cnc::new(&machine(), interpreter("G0 X5\nX0\nX1\nM30\n", &setup));
        let run = run(&mut cnc);
        assert_eq!(cnc.state(), &State::Ended);
        run.ticks.len()
    };
    // 0.03 mm in steps of 0.0001 mm are 300 periods; the last turn is waited for as well.
    let free = run_with_bits("");
    let waits = run_with_bits("\"NO18.0\" = 1");
    assert!(waits > free + 150, "{free} {waits}");
    // 0.03 is within the tolerance of P371.
    assert_eq!(run_with_bits("\"NO18.0\" = 1\nP371 = 0.05"), free);
}

#[test]
fn acceleration_is_selected_by_parameters_where_the_machine_says_so() {
    let mut machine = machine();
    let (_, plain) = ended(&machine, PROGRAM);
    machine.servo.acceleration_by_parameters = Some(true);
    // As delivered: cutting is accelerated after interpolation in 80 ms (17#0, P127), positioning is not.
    let (_, run) = ended(&machine, PROGRAM);
    let mut same = crate::common::machine();
    for axis in &mut same.axes {
        axis.after_cutting = Smoothing::Linear { time_ms: 80.0 };
    }
    let (_, expected) = ended(&same, PROGRAM);
    assert_eq!(run.ticks, expected.ticks);
    assert!(run.ticks.len() > plain.ticks.len());
}

#[test]
fn acceleration_before_interpolation_is_selected_by_parameters() {
    let mut machine = machine();
    machine.servo.acceleration_by_parameters = Some(true);
    // Periods from the first that moves to the first at 100 mm/s; P96 is 6000 mm/min.
    let periods = |bits: &str| {
        let setup = format!("[parameters]\n\"NO17.0\" = 0\n{bits}");
        let mut cnc = Cnc::new(&machine, interpreter("G1 X60 F6000\nM30\n", &setup));
        let run = run(&mut cnc);
        assert_eq!(cnc.state(), &State::Ended);
        let x: Vec<f64> = run.ticks.iter().map(|t| t.position.0[0]).collect();
        let first = x.iter().position(|x| *x > 0.0).unwrap();
        let fast = x.windows(2).position(|w| w[1] - w[0] > 0.09999).unwrap();
        fast - first
    };
    // Linear in 100 ms as delivered, in 250 ms, and an S in 200 ms.
    for (bits, expected) in
        [("", 100), ("P125 = 250", 250), ("\"NO17.1\" = 1\nP126 = 200", 200), ("P96 = 7500", 80)]
    {
        let found = periods(bits);
        assert!(found.abs_diff(expected) <= 3, "{bits}: {found} instead of {expected}");
    }
}

#[test]
fn inner_corners_of_a_compensated_path_are_slowed_down_for() {
    // With the tool on the left and the radius 2 the corner of the centre's path is at (28, 2).
    let speed_beside = |mode: &str, setup: &str| {
        let program = format!("G1 G41 D1 X10 Y0 F1500\n{mode}\nX30\nY30\nG40 X0\nM30\n");
        let setup = format!("[parameters]\n\"NO40.7\" = 0\n{setup}\n[tools.1]\nradius = 2.0\n");
        let mut cnc = Cnc::new(&machine(), interpreter(&program, &setup));
        let run = run(&mut cnc);
        assert_eq!(cnc.state(), &State::Ended, "{program}");
        let corner = Position::xyz(28.0, 2.0, 0.0);
        let distance = |a: Position, b: Position| (a - b).0.iter().fold(0.0_f64, |h, c| h.hypot(*c));
        let pairs = run.ticks.windows(2).filter(|w| {
            (0.3..0.9).contains(&distance(w[0].position, corner))
                && (0.3..0.9).contains(&distance(w[1].position, corner))
        });
        pairs.fold(0.0_f64, |m, w| m.max(distance(w[1].position, w[0].position) / 0.001))
    };
    let on = "\"NO16.7\" = 1\nP144 = 100\nP145 = 120";
    let slow = speed_beside("G62", on);
    assert!((slow - 2.0).abs() < 0.01, "{slow}");
    // G64; without 16#7; a wider angle; acceleration before interpolation (limit 1).
    for (mode, setup) in [
        ("G64", on),
        ("G62", "P144 = 100"),
        ("G62", "\"NO16.7\" = 1\nP144 = 80"),
        ("G62", &format!("{on}\n\"NO17.0\" = 0")),
    ] {
        let v = speed_beside(mode, setup);
        assert!(v > 5.0, "{mode} {setup}: {v}");
    }
}

#[test]
fn an_axis_that_does_not_follow_is_an_alarm_with_its_name() {
    let program = "G0 X100\nM30\n";
    let lazy = |share, rest| Box::new(Lazy { at: Position::ZERO, share, rest });
    let mut machine = machine();
    machine.axes[0].following_error = 3.0;
    let mut cnc = Cnc::with_drives(&machine, interpreter(program, ""), lazy(0.05, 0.0));
    let (alarm, run) = alarmed(&mut cnc);
    assert_eq!((alarm.id, alarm.fault), (AlarmId::Dialect("gsk990mc", 121), Fault::FollowingError));
    assert_eq!(alarm.arguments[0], ("axis", "X".into()));
    assert_eq!(alarm.span.line, 1);
    // Braked on the way, and not beyond.
    let end = run.end();
    assert!((1.0..99.0).contains(&end[Axis::X]), "{end:?}");
    for _ in 0..5 {
        assert_eq!((cnc.tick().position, cnc.tick().velocity), (end, 0.0));
    }
    // Reset leads on.
    cnc.reset();
    for _ in 0..3000 {
        cnc.tick();
    }
    assert!(!matches!(cnc.state(), State::Running), "{:?}", cnc.state());

    machine.axes[0].following_error = 30.0;
    let mut cnc = Cnc::with_drives(&machine, interpreter(program, ""), lazy(0.05, 0.0));
    assert_eq!((crate::common::run(&mut cnc).end()[Axis::X], cnc.state()), (100.0, &State::Ended));

    // 0.05 mm beside its place for ever: nobody asks after positioning, and P131 is 0.03 after cutting.
    let mut cnc = Cnc::with_drives(&machine, interpreter(program, ""), lazy(1.0, 0.05));
    crate::common::run(&mut cnc);
    assert_eq!(cnc.state(), &State::Ended);
    let program = "G1 X100 F6000\nM30\n";
    let mut cnc = Cnc::with_drives(&machine, interpreter(program, ""), lazy(1.0, 0.05));
    let (alarm, _) = alarmed(&mut cnc);
    assert_eq!((alarm.id, alarm.fault), (AlarmId::Core(Fault::NotInPosition), Fault::NotInPosition));
}

#[test]
fn travel_beyond_the_pitch_points_is_an_alarm() {
    let mut machine = machine();
    machine.axes[0].pitch_errors = Some(PitchErrors { corrections: vec![0.0; 20], ..PitchErrors::default() });
    // Point 1 at zero, every 10 mm: the numbers end at −10.
    let setup = "[parameters]\n\"NO37.0\" = 1\nP216 = 1\nP226 = 10";
    let mut cnc = Cnc::new(&machine, interpreter("G0 X50\nX-14\nX-50\nM30\n", setup));
    let (alarm, _) = alarmed(&mut cnc);
    assert_eq!((alarm.id, alarm.fault), (AlarmId::Dialect("gsk990mc", 16), Fault::PitchPoint));
    assert_eq!(alarm.span.line, 3);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn hold_and_reset_come_to_rest_with_smoothed_axes_too(
        at in 0usize..3000,
        length in 1usize..400,
        resets in any::<bool>(),
    ) {
        let machine = smooth();
        let mut control = cnc(&machine, PROGRAM);
        let hands: &[_] = match resets {
            true => &[(at, Hand::Reset)],
            false => &[(at, Hand::Hold), (at + length, Hand::CycleStart)],
        };
        let run = run_with(&mut control, hands);
        run.check_limits(&machine, false);
        if !resets {
            prop_assert_eq!(control.state(), &State::Ended);
            let (through, _) = ended(&machine, PROGRAM);
            prop_assert_eq!(control.report().moves, through.report().moves);
        }
        let end = run.end();
        for _ in 0..5 {
            let tick = control.tick();
            prop_assert_eq!((tick.position, tick.moving), (end, false));
        }
    }
}
