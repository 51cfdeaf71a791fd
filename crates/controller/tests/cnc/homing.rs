//! Machine zero return on the simulated machine: the same zero from wherever the axis starts, in every mode of the

//! parameters; what a program may do before it; what goes wrong.

use crate::common::{interpreter, machine};
use ferrocut_controller::drives::{Plant, Trouble};
use ferrocut_controller::{Cnc, JogSpeed, JogWay, State, Tick};
use ferrocut_geometry::{Axis, AxisSet, Position};
use ferrocut_interpreter::dialects;
use ferrocut_machine::{AlarmId, Fault, Machine, PlantAxis, PlantConfig};
use proptest::prelude::*;

/// The demo mill with a plant.
fn planted(change: impl Fn(&mut PlantAxis)) -> Machine {
    let mut machine = machine();
    let mut x = PlantAxis::new(Axis::X);
    change(&mut x);
    machine.plant = Some(PlantConfig { axes: vec![x], ..PlantConfig::default() });
    machine
}

/// A control on the plant, which takes its axes to stand at `called`.
fn on_plant(machine: &Machine, program: &str, setup: &str) -> Cnc {
    let interpreter = interpreter(program, setup);
    let called = interpreter.position();
    let reference = interpreter.memory().reference_points[0];
    let mut as_set = machine.clone();
    (dialects::gsk990mc::DIALECT.machine_parameters)(&interpreter.memory().parameters, &mut as_set);
    let plant = Plant::new(&as_set, called, reference);
    Cnc::with_drives(machine, interpreter, Box::new(plant))
}

fn plant(cnc: &mut Cnc) -> &mut Plant {
    cnc.drives().plant().unwrap()
}

/// Ticks until nothing moves.
fn settle(cnc: &mut Cnc) -> Vec<Tick> {
    let mut ticks = Vec::new();
    for _ in 0..300_000 {
        ticks.push(cnc.tick());
        if !ticks[ticks.len() - 1].moving && !cnc.is_homing() {
            return ticks;
        }
    }
    panic!("never at rest: {:?}", ticks.last());
}

fn homed(cnc: &mut Cnc, axis: Axis) -> Vec<Tick> {
    assert!(cnc.home(axis));
    let ticks = settle(cnc);
    assert_eq!(cnc.state(), &State::Ready);
    ticks
}

fn only(axes: &[Axis]) -> AxisSet {
    axes.iter().copied().collect()
}

/// Where the axis is and where the control takes it to be, once it has come to rest.
fn error(cnc: &mut Cnc, axis: Axis) -> f64 {
    let tick = (0..2000).map(|_| cnc.tick()).last().unwrap();
    (plant(cnc).places()[axis] - tick.position[axis]).abs()
}

/// No axis above its limits, by the commands; `ticks` begins at rest at `start` and ends before the places get other names.
fn check_limits(ticks: &[Tick], start: f64, machine: &Machine, axis: Axis) {
    let config = machine.axis(axis).unwrap();
    let t = machine.servo_period_ms / 1000.0;
    let at: Vec<f64> = [start; 3].into_iter().chain(ticks.iter().map(|tick| tick.position[axis])).collect();
    for w in at.windows(4) {
        let [a, b, c, d] = [w[0], w[1], w[2], w[3]];
        assert!((b - a).abs() / t <= config.rapid / 60.0 * 1.001 + 1e-6);
        assert!((c - 2.0 * b + a).abs() / (t * t) <= config.acceleration * 1.001 + 1e-3);
        assert!((d - 3.0 * c + 3.0 * b - a).abs() / (t * t * t) <= config.jerk * 1.001 + 1.0, "{w:?}");
    }
}

#[test]
fn an_axis_finds_its_marker_behind_the_switch() {
    // The switch of X ends 0.4 turns of 10 mm before the reference point, 80 mm up from where the axis stands.
    let machine = planted(|_| {});
    let mut cnc = on_plant(&machine, "M30\n", "");
    assert_eq!((cnc.referenced(), cnc.at_reference()), (AxisSet::EMPTY, AxisSet::EMPTY));
    let ticks = homed(&mut cnc, Axis::X);
    assert_eq!((cnc.referenced(), cnc.at_reference()), (only(&[Axis::X]), only(&[Axis::X])));
    assert_eq!(cnc.tick().position[Axis::X], 0.0);
    assert!(error(&mut cnc, Axis::X) < 1e-3);
    // 46 mm at 4000 mm/min, 30 mm at 200 mm/min, 4 mm at 40 mm/min.
    let seconds = ticks.len() as f64 / 1000.0;
    assert!((seconds - (46.0 / 66.7 + 30.0 / 3.33 + 4.0 / 0.667)).abs() < 0.7, "{seconds}");
    let top = ticks.iter().map(|t| t.velocity).fold(0.0, f64::max) * 60.0;
    assert!((top - 4000.0).abs() < 1e-6, "{top}");
    // The lamp goes out as the axis leaves, and the software limits hold now.
    cnc.jog(Axis::X, JogWay::Plus, JogSpeed::Rapid);
    cnc.tick();
    for _ in 0..20 {
        cnc.tick();
    }
    assert_eq!((cnc.referenced(), cnc.at_reference()), (only(&[Axis::X]), AxisSet::EMPTY));
    settle(&mut cnc);
    assert_eq!((cnc.tick().position[Axis::X], cnc.state()), (500.0, &State::Ready));
}

#[test]
fn several_axes_home_at_once_or_one_by_one() {
    let machine = planted(|_| {});
    let mut cnc = on_plant(&machine, "M30\n", "[reference_points]\nfirst = { x = 10, z = 100 }");
    assert!(cnc.home(Axis::X) && cnc.home(Axis::Z) && !cnc.home(Axis::X) && !cnc.home(Axis::B));
    settle(&mut cnc);
    assert_eq!(cnc.at_reference(), only(&[Axis::X, Axis::Z]));
    assert_eq!(cnc.tick().position, Position::xyz(10.0, 0.0, 100.0));
    assert!(error(&mut cnc, Axis::X) < 1e-3 && error(&mut cnc, Axis::Z) < 1e-3);
    // 6#2: one at a time.
    let mut cnc = on_plant(&machine, "M30\n", "[parameters]\n\"NO6.2\" = 1");
    assert!(cnc.home(Axis::X) && !cnc.home(Axis::Z));
    settle(&mut cnc);
    assert_eq!(cnc.referenced(), only(&[Axis::X]));
    // The machine file's order: Z first.
    let mut ordered = planted(|_| {});
    ordered.homing.order = "ZX".to_owned();
    let mut cnc = on_plant(&ordered, "M30\n", "");
    assert!(cnc.home(Axis::X) && cnc.home(Axis::Z));
    let start = cnc.tick().position;
    (0..5000).for_each(|_| {
        cnc.tick();
    });
    let now = cnc.tick().position;
    assert!(now[Axis::X] == start[Axis::X] && now[Axis::Z] > start[Axis::Z]);
    settle(&mut cnc);
    assert_eq!(cnc.referenced(), only(&[Axis::X, Axis::Z]));
}

#[test]
fn a_reference_point_that_is_known_is_positioned_on() {
    // 5#4, and 6#4 which keeps it as well: no switch any more, at the speed of positioning or of manual rapid (14#1).
    for (bits, top) in [("\"NO5.4\" = 1", 15_000.0), ("\"NO6.4\" = 1\n\"NO14.1\" = 1", 5000.0)] {
        let machine = planted(|_| {});
        let mut cnc = on_plant(&machine, "M30\n", &format!("[parameters]\n{bits}"));
        homed(&mut cnc, Axis::X);
        cnc.jog_step(Axis::X, 1, 200.0);
        settle(&mut cnc);
        plant(&mut cnc).trouble(Axis::X, Trouble::HomeSwitch(Some(false)));
        let ticks = homed(&mut cnc, Axis::X);
        let highest = ticks.iter().map(|t| t.velocity).fold(0.0, f64::max) * 60.0;
        assert!((highest - top).abs() < 1e-6, "{highest}");
        assert_eq!((cnc.tick().position[Axis::X], cnc.at_reference()), (0.0, only(&[Axis::X])));
        assert_eq!(cnc.remembers_reference(), bits.contains("6.4"));
    }
    // Without it the switch is searched anew, and known to be missing.
    let mut cnc = on_plant(&planted(|_| {}), "M30\n", "");
    homed(&mut cnc, Axis::X);
    cnc.jog_step(Axis::X, -1, 60.0);
    settle(&mut cnc);
    plant(&mut cnc).trouble(Axis::X, Trouble::HomeSwitch(Some(false)));
    assert!(cnc.home(Axis::X));
    settle(&mut cnc);
    assert!(matches!(cnc.state(), State::Alarmed(_)));
    assert_eq!(cnc.referenced(), AxisSet::EMPTY);
}

/// An axis that was homed stands behind its switch: none comes any more but the travel switch. It is positioned on its
/// point; one that is before its switch, or on it, searches.
#[test]
fn an_axis_that_is_homed_again_from_behind_its_switch_stays_off_the_travel_switch() {
    let modes = [
        "",
        "\"NO6.6\" = 0",
        "\"NO6.6\" = 0\n\"NO6.7\" = 0",
        "\"NO6.1\" = 1",
        "\"NO7.0\" = 1",
        "P180 = 2.5",
        "\"NO6.6\" = 0\n\"NO6.7\" = 0\nP180 = 2.5",
    ];
    for mode in modes {
        let onwards = if mode.contains("NO7.0") { -1 } else { 1 };
        let mut cnc = on_plant(&planted(|_| {}), "M30\n", &format!("[parameters]\n{mode}"));
        homed(&mut cnc, Axis::X);
        // On the point, behind it, between it and the switch, on the switch, before it.
        for way in [0.0, 3.0, 200.0, -2.0, -20.0, -60.0] {
            if way != 0.0 {
                cnc.jog_step(Axis::X, onwards, way);
                settle(&mut cnc);
            }
            let ticks = homed(&mut cnc, Axis::X);
            assert_eq!(cnc.at_reference(), only(&[Axis::X]), "{mode}: {way}");
            assert!(cnc.tick().position[Axis::X].abs() < 1e-3, "{mode}: {way}");
            assert!(error(&mut cnc, Axis::X) < 2e-3, "{mode}: {way}");
            // It leaves the point by no more than it was away, but for the way over the switch and back.
            let farthest = ticks.iter().map(|tick| tick.position[Axis::X].abs()).fold(0.0, f64::max);
            assert!(farthest < way.abs() + 50.0, "{mode}: {way}: {farthest}");
        }
    }
}

#[test]
fn absolute_encoders_and_kept_points_need_no_homing() {
    let machine = planted(|_| {});
    // 20#6.
    let cnc = on_plant(&machine, "M30\n", "[parameters]\n\"NO20.6\" = 1\n[start]\nX = 30");
    assert_eq!(cnc.referenced(), machine.axis_set());
    // What was kept through power-off is set by whoever starts the control.
    let mut cnc = on_plant(&machine, "M30\n", "[parameters]\n\"NO6.4\" = 1");
    cnc.set_referenced(only(&[Axis::X]));
    assert!(cnc.remembers_reference());
    assert_eq!(cnc.referenced(), only(&[Axis::X]));
}

#[test]
fn rapid_by_hand_and_software_limits_wait_for_homing() {
    // 12#0 = 0: the rapid key jogs at P98; 11#6 = 0: beyond 500 the axis goes on.
    let machine = planted(|axis| axis.limits = Some([-2000.0, 2000.0]));
    let speed = |cnc: &mut Cnc| {
        cnc.jog(Axis::X, JogWay::Plus, JogSpeed::Rapid);
        let tick = (0..1000).map(|_| cnc.tick()).last().unwrap();
        (tick.velocity * 60.0).round()
    };
    let mut cnc = on_plant(&machine, "M30\n", "");
    assert_eq!(speed(&mut cnc), 2000.0);
    (0..20_000).for_each(|_| {
        cnc.tick();
    });
    assert!(cnc.tick().position[Axis::X] > 600.0);
    let mut cnc = on_plant(&machine, "M30\n", "[parameters]\n\"NO12.0\" = 1\n\"NO11.6\" = 1");
    assert_eq!(speed(&mut cnc), 5000.0);
    settle(&mut cnc);
    assert_eq!(cnc.tick().position[Axis::X], 500.0);
}

#[test]
fn what_goes_wrong_is_an_alarm_and_rest() {
    let cases: &[(Trouble, &str, AlarmId, Fault)] = &[
        // Runs onto the travel switch at 510.
        (Trouble::HomeSwitch(Some(false)), "", AlarmId::Dialect("gsk990mc", 511), Fault::HardLimit),
        (Trouble::HomeSwitch(Some(true)), "", AlarmId::Dialect("gsk990mc", 511), Fault::HardLimit),
        (Trouble::NoMarker(true), "", AlarmId::Dialect("gsk990mc", 87), Fault::HomeMarker),
        (
            Trouble::Stuck(true),
            "[parameters]\nP445 = 5",
            AlarmId::Dialect("gsk990mc", 121),
            Fault::FollowingError,
        ),
        // Travel switches that are not there (61#6).
        (
            Trouble::HomeSwitch(Some(false)),
            "[parameters]\n\"NO61.6\" = 1",
            AlarmId::Core(Fault::HomeSwitch),
            Fault::HomeSwitch,
        ),
    ];
    for (trouble, setup, id, fault) in cases {
        let machine = planted(|_| {});
        let mut cnc = on_plant(&machine, "M30\n", setup);
        plant(&mut cnc).trouble(Axis::X, *trouble);
        assert!(cnc.home(Axis::X));
        let ticks = settle(&mut cnc);
        check_limits(&ticks, 0.0, &machine, Axis::X);
        let State::Alarmed(alarm) = cnc.state().clone() else { panic!("{trouble:?}: {:?}", cnc.state()) };
        assert_eq!((alarm.id, alarm.fault), (*id, *fault), "{trouble:?}");
        assert_eq!(alarm.arguments[0], ("axis", "X".into()));
        assert_eq!((cnc.referenced(), cnc.at_reference()), (AxisSet::EMPTY, AxisSet::EMPTY));
        let rest = cnc.tick().position;
        (0..100).for_each(|_| assert_eq!(cnc.tick().position, rest));
    }
}

#[test]
fn reset_and_emergency_stop_give_homing_up() {
    for emergency in [false, true] {
        let machine = planted(|_| {});
        let mut cnc = on_plant(&machine, "M30\n", "");
        assert!(cnc.home(Axis::Y));
        (0..300).for_each(|_| {
            cnc.tick();
        });
        if emergency {
            cnc.emergency_stop()
        } else {
            cnc.reset()
        }
        let ticks = settle(&mut cnc);
        assert!(ticks.len() < 100 && !cnc.is_homing() && cnc.referenced().is_empty());
        cnc.tick();
        match (emergency, cnc.state()) {
            (false, State::Reset) => {}
            (true, State::Alarmed(alarm)) => assert_eq!(alarm.id, AlarmId::Dialect("gsk990mc", 251)),
            (_, state) => panic!("{state:?}"),
        }
        // And again from there.
        cnc.reset();
        (0..5).for_each(|_| {
            cnc.tick();
        });
        assert!(cnc.home(Axis::Y));
        settle(&mut cnc);
        assert!(cnc.at_reference().contains(Axis::Y) && error(&mut cnc, Axis::Y) < 1e-3);
    }
}

#[test]
fn a_key_that_is_to_be_held_ends_homing_when_it_is_let_go() {
    let mut machine = planted(|_| {});
    for held in [false, true] {
        machine.homing.key_held = held;
        let mut cnc = on_plant(&machine, "M30\n", "");
        assert!(cnc.home(Axis::X));
        (0..1000).for_each(|_| {
            cnc.tick();
        });
        cnc.release_home(Axis::X);
        settle(&mut cnc);
        assert_eq!((cnc.state(), cnc.referenced().is_empty()), (&State::Ready, held));
    }
}

#[test]
fn g28_finds_the_reference_points_of_a_program() {
    let machine = planted(|_| {});
    let run = |program: &str, setup: &str| {
        let mut cnc = on_plant(&machine, program, setup);
        cnc.cycle_start();
        for _ in 0..300_000 {
            let tick = cnc.tick();
            // Nothing of the program runs beside it.
            assert!(!cnc.is_homing() || cnc.state() == &State::Running && tick.span.line == 1);
            if !matches!(cnc.state(), State::Running | State::Resetting) {
                break;
            }
        }
        cnc
    };
    let points = "[reference_points]\nfirst = { x = 20, y = 5 }\nsecond = { x = 70 }";
    let program = "G91 G28 X10 Y0\nG90 G0 X50\nG30 X50\nG53 Y1\nG1 X60 F3000\nG28 X0\nM30\n";
    let mut cnc = run(program, points);
    assert_eq!(cnc.state(), &State::Ended);
    assert_eq!(cnc.tick().position, Position::xyz(20.0, 1.0, 0.0));
    assert!(error(&mut cnc, Axis::X) < 1e-3 && error(&mut cnc, Axis::Y) < 1e-3);
    assert_eq!((cnc.referenced(), cnc.at_reference()), (only(&[Axis::X, Axis::Y]), only(&[Axis::X])));

    let alarm = |program: &str, bits: &str| match run(program, &format!("[parameters]\n{bits}")).state() {
        State::Alarmed(alarm) => (alarm.id.number(), alarm.span.line),
        State::Ended => (None, 0),
        state => panic!("{state:?}"),
    };
    // 6#3: not by G28. 6#0: nothing but G28. G30 and G53 never.
    assert_eq!(alarm("G0 Y1\nG28 X0\nM30\n", "\"NO6.3\" = 1"), (Some(145), 2));
    assert_eq!(alarm("G28 X0\nG1 X5 F100\nG1 Y5\nM30\n", "\"NO6.0\" = 1"), (Some(224), 3));
    assert_eq!(alarm("G1 X5 F1000\nM30\n", ""), (None, 0));
    assert_eq!(alarm("G28 X0\nG30 Y0\nM30\n", ""), (Some(47), 2));
    assert_eq!(alarm("G53 X0\nM30\n", ""), (Some(47), 1));
    assert_eq!(alarm("G28 X0\nG30 X0\nG53 X1\nM30\n", "\"NO6.0\" = 1"), (None, 0));
}

#[test]
fn homing_in_a_program_is_held_and_goes_on() {
    let machine = planted(|_| {});
    let mut cnc = on_plant(&machine, "G28 X0\nM30\n", "");
    cnc.cycle_start();
    (0..1000).for_each(|_| {
        cnc.tick();
    });
    assert!(cnc.is_homing());
    cnc.feed_hold();
    (0..500).for_each(|_| {
        cnc.tick();
    });
    assert_eq!((cnc.state(), cnc.is_homing()), (&State::Held, true));
    let rest = cnc.tick().position;
    (0..500).for_each(|_| assert_eq!(cnc.tick().position, rest));
    cnc.cycle_start();
    (0..60_000).for_each(|_| {
        cnc.tick();
    });
    assert_eq!((cnc.state(), cnc.at_reference()), (&State::Ended, only(&[Axis::X])));
    assert!(error(&mut cnc, Axis::X) < 1e-3);
}

/// Without the permission of the interlock no axis moves, whoever homes it: a program goes on with it, by hand it is begun
/// anew.
#[test]
fn an_interlock_stops_homing() {
    let machine = planted(|_| {});
    for by_program in [true, false] {
        for at in [3, 400, 1500, 3500] {
            let mut cnc = on_plant(&machine, "G28 X0\nM30\n", "");
            let wait = |cnc: &mut Cnc, n: usize| (0..n).map(|_| cnc.tick().position).last().unwrap();
            wait(&mut cnc, 2);
            match by_program {
                true => cnc.cycle_start(),
                false => assert!(cnc.home(Axis::X)),
            }
            wait(&mut cnc, at);
            assert!(cnc.is_homing(), "{at}");
            cnc.set_may_move(false);
            let rest = wait(&mut cnc, 600);
            (0..500).for_each(|_| assert_eq!(cnc.tick().position, rest, "{by_program} {at}"));
            cnc.set_may_move(true);
            if !by_program {
                assert_eq!((wait(&mut cnc, 500), cnc.is_homing()), (rest, false), "{at}");
                homed(&mut cnc, Axis::X);
            } else {
                wait(&mut cnc, 60_000);
                assert_eq!(cnc.state(), &State::Ended, "{at}");
            }
            assert_eq!(cnc.at_reference(), only(&[Axis::X]), "{by_program} {at}");
            assert!(error(&mut cnc, Axis::X) < 1e-3, "{by_program} {at}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, failure_persistence: None, ..ProptestConfig::default() })]

    /// Every mode, direction and speed, wherever switch, marker and axis are.
    #[test]
    fn the_zero_is_the_same_from_anywhere(
        bits in prop::array::uniform5(any::<bool>()),
        reference in -200.0..200.0_f64,
        shift in prop_oneof![Just(0.0_f64), 0.0..12.0_f64],
        pitch in 2.0..20.0_f64,
        // Of a turn of the screw, away from where the switch lets go.
        marker in 0.1..0.9_f64,
        switch in 8.0..60.0_f64,
        from in 0.0..150.0_f64,
        again in 0.0..150.0_f64,
        speeds in (300.0..9000.0_f64, 60.0..400.0_f64, 5.0..60.0_f64),
        servo in (20.0..120.0_f64, 0.0..4.0_f64, 0.0..1.0_f64),
        filter in any::<bool>(),
    ) {
        let [by_marker, before, twice, negative, closes] = bits;
        let (fast, slow, search) = speeds;
        let mut machine = planted(|_| {});
        let shift = (shift * 1e4_f64).round() / 1e4;
        let up = if negative { -1.0 } else { 1.0 };
        let leaves = if before { -up } else { up };
        // Where the switch lets go, and which place the reference point then is.
        let edge = reference - shift - if by_marker { leaves * marker * pitch } else { 0.0 };
        let far = edge - leaves * switch;
        let home = [edge.min(far), edge.max(far)];
        // Before the switch, or on it.
        let start = |way: f64| if before { edge - up * (way - 0.9 * switch) } else { far - up * (way - 0.9 * switch) };
        let x = PlantAxis {
            gain: servo.0,
            lag_ms: servo.1.min(200.0 / servo.0),
            feed_forward: servo.2,
            pitch,
            marker: Some(reference - shift + 3.0 * pitch),
            home: Some(home),
            limits: Some([-1000.0, 1000.0]),
            at: Some(start(from)),
            ..PlantAxis::new(Axis::X)
        };
        machine.plant = Some(PlantConfig { axes: vec![x], ..PlantConfig::default() });
        if filter {
            machine.axes[0].after_jog = ferrocut_machine::Smoothing::Linear { time_ms: 60.0 };
        }
        let bit = |number: &str, on: bool| format!("\"NO{number}\" = {}\n", u8::from(on));
        let setup = format!(
            "[reference_points]\nfirst = {{ x = {reference} }}\n[parameters]\n{}{}{}{}{}P100 = {fast}\nP342 = {slow}\nP99 = {search}\nP180 = {shift}\n",
            bit("6.6", by_marker), bit("6.1", before), bit("6.7", twice), bit("7.0", negative), bit("2.0", closes),
        );
        let mut cnc = on_plant(&machine, "M30\n", &setup);
        for way in [None, Some(again)] {
            if let Some(way) = way {
                // By hand to another place, and from there again.
                let there = start(way) - plant(&mut cnc).places()[Axis::X];
                cnc.jog_step(Axis::X, (there * 1e3).round() as i64, 1e-3);
                settle(&mut cnc);
            }
            let begin = cnc.tick().position[Axis::X];
            let ticks = homed(&mut cnc, Axis::X);
            check_limits(&ticks[..ticks.len() - 1], begin, &machine, Axis::X);
            prop_assert_eq!(cnc.at_reference(), only(&[Axis::X]));
            prop_assert!((cnc.tick().position[Axis::X] - reference).abs() < 1e-9);
            let error = error(&mut cnc, Axis::X);
            prop_assert!(error < 1e-3, "{error}");
        }
    }
}
