//! Jog, steps and handwheel on a control: who may, how fast, where they end, and that a program goes on from there.

use crate::common::{cnc, cnc_with, interpreter, machine, run, run_with};
use ferrocut_controller::{Cnc, Drives, JogSpeed, JogWay, State, Tick};
use ferrocut_geometry::{Axis, Position};
use ferrocut_machine::{Fault, Smoothing};
use proptest::prelude::*;

/// Periods until the axes stand, and the ticks.
fn settle(cnc: &mut Cnc) -> Vec<Tick> {
    let mut ticks = Vec::new();
    for _ in 0..100_000 {
        ticks.push(cnc.tick());
        if !ticks[ticks.len() - 1].moving {
            return ticks;
        }
    }
    panic!("never at rest: {:?}", ticks.last());
}

fn wait(cnc: &mut Cnc, periods: usize) -> Tick {
    (0..periods).map(|_| cnc.tick()).last().unwrap()
}

const PROGRAM: &str = "M3 S800\nG91 G1 X5 F3000\nM30\n";

#[test]
fn the_speed_of_a_key_is_that_of_the_parameters_and_overrides() {
    // P98 = 2000 mm/min, P170 = 5000 mm/min, P93 = 30 mm/min as delivered.
    let mut cnc = cnc(&machine(), PROGRAM);
    let mut speed = |way, key, feed, rapid| {
        cnc.set_override(feed, rapid);
        assert!(cnc.jog(Axis::X, way, key));
        (wait(&mut cnc, 600).velocity * 60.0).round()
    };
    assert_eq!(speed(JogWay::Plus, JogSpeed::Feed, 1.0, 1.0), 2000.0);
    assert_eq!(speed(JogWay::Plus, JogSpeed::Feed, 1.5, 1.0), 3000.0);
    assert_eq!(speed(JogWay::Minus, JogSpeed::Feed, 2.0, 0.25), 4000.0);
    assert_eq!(speed(JogWay::Minus, JogSpeed::Rapid, 0.0, 0.25), 1250.0);
    assert_eq!(speed(JogWay::Minus, JogSpeed::Rapid, 1.0, 1.0), 5000.0);
    assert_eq!(speed(JogWay::Plus, JogSpeed::Rapid, 1.0, 0.0), 30.0);
    assert_eq!(speed(JogWay::Plus, JogSpeed::Of(600.0), 1.0, 0.0), 600.0);
    // The highest speed of the axis stands above.
    assert_eq!(speed(JogWay::Minus, JogSpeed::Of(60_000.0), 1.0, 0.0), 10_000.0);
    assert_eq!(speed(JogWay::Plus, JogSpeed::Feed, 0.0, 1.0), 0.0);
    // A key that is held follows the override.
    cnc.set_override(0.5, 1.0);
    assert_eq!((wait(&mut cnc, 600).velocity * 60.0).round(), 1000.0);
    cnc.jog(Axis::X, JogWay::Stop, JogSpeed::Feed);
    settle(&mut cnc);
    // 12#4 = 1: at F0 nothing moves.
    let mut cnc = cnc_with(&machine(), PROGRAM, "[parameters]\n\"NO12.4\" = 1\nP98 = 700\nP171 = 900");
    cnc.jog(Axis::Y, JogWay::Plus, JogSpeed::Rapid);
    assert_eq!((wait(&mut cnc, 600).velocity * 60.0).round(), 900.0);
    cnc.set_override(1.0, 0.0);
    assert_eq!(wait(&mut cnc, 600).velocity, 0.0);
    cnc.jog(Axis::Y, JogWay::Plus, JogSpeed::Feed);
    assert_eq!((wait(&mut cnc, 600).velocity * 60.0).round(), 700.0);
}

#[test]
fn a_program_goes_on_from_where_the_axes_were_moved_to() {
    let mut machine = machine();
    for smoothing in [Smoothing::None, Smoothing::Linear { time_ms: 100.0 }] {
        machine.axes[0].after_jog = smoothing;
        let mut cnc = cnc(&machine, PROGRAM);
        assert!(cnc.jog_step(Axis::X, 3, 0.1) && cnc.jog_step(Axis::Y, -2, 1.0));
        // Not while they move.
        cnc.tick();
        cnc.cycle_start();
        assert_eq!(cnc.state(), &State::Ready);
        settle(&mut cnc);
        assert_eq!(cnc.tick().position, Position::xyz(0.3, -2.0, 0.0));
        let end = run(&mut cnc).end();
        assert_eq!((end, cnc.state()), (Position::xyz(5.3, -2.0, 0.0), &State::Ended));
        // And by hand again from its end.
        assert!(cnc.jog_step(Axis::X, -1, 0.3));
        settle(&mut cnc);
        assert_eq!(cnc.tick().position, Position::xyz(5.0, -2.0, 0.0));
    }
}

/// GSK990MC 17#5: the handwheel has an acceleration after interpolation of its own, linear or exponential, and the jog keys
/// keep theirs (17#3). Where the axis ends is the same.
#[test]
fn the_handwheel_is_accelerated_as_its_parameters_say() {
    // Periods from the wheel's last count, or the key's release, to the standstill.
    let rests_after = |parameters: &str, by_wheel: bool| {
        let mut machine = machine();
        machine.servo.acceleration_by_parameters = None;
        let mut cnc = cnc_with(&machine, PROGRAM, &format!("[parameters]\n\"NO56.0\" = 1\n{parameters}"));
        let turn = |cnc: &mut Cnc, k: usize| {
            match by_wheel {
                true if k < 10 => assert!(cnc.handwheel(Axis::X, 1, 0.1)),
                true => {}
                false => {
                    _ = cnc.jog(Axis::X, if k < 300 { JogWay::Plus } else { JogWay::Stop }, JogSpeed::Feed)
                }
            }
            cnc.tick()
        };
        let last = if by_wheel { 10 } else { 300 };
        (0..last).for_each(|k| _ = turn(&mut cnc, k));
        let mut at = cnc.tick().position[Axis::X];
        for k in 0..3000 {
            let now = turn(&mut cnc, last + k);
            if now.position[Axis::X] == at && k > 20 {
                if by_wheel {
                    assert!((at - 1.0).abs() < 1e-9, "{parameters}: {at}");
                }
                return k;
            }
            at = now.position[Axis::X];
        }
        panic!("{parameters}: does not rest");
    };
    let of_file = rests_after("", true);
    let linear = rests_after("\"NO17.5\" = 0\nP152 = 400", true);
    let shorter = rests_after("\"NO17.5\" = 0\nP152 = 200", true);
    assert!((of_file + 190..of_file + 230).contains(&shorter), "{of_file} {shorter}");
    assert!((of_file + 390..of_file + 430).contains(&linear), "{of_file} {linear}");
    // No shorter than the clamp.
    assert_eq!(rests_after("\"NO17.5\" = 0\nP152 = 50\nP154 = 200", true), shorter);
    // Exponential: a way that goes on until its lowest speed.
    let exponential = rests_after("P153 = 200", true);
    assert!(exponential > shorter + 100, "{exponential} {shorter}");
    // The keys have their own.
    let key = rests_after("P156 = 110", false);
    assert_eq!(rests_after("P156 = 110\nP152 = 400\nP153 = 400\n\"NO17.5\" = 0", false), key);
    assert!(rests_after("P156 = 300", false) > key + 150);
}

#[test]
fn nobody_moves_the_axes_of_a_program() {
    let mut control = cnc(&machine(), "G0 X100\nM0\nG7777\nM30\n");
    let tries = |cnc: &mut Cnc| {
        [
            cnc.jog(Axis::X, JogWay::Plus, JogSpeed::Feed),
            cnc.jog_step(Axis::X, 1, 0.1),
            cnc.handwheel(Axis::X, 1, 0.1),
        ]
    };
    control.cycle_start();
    wait(&mut control, 50);
    assert_eq!(tries(&mut control), [false; 3]);
    control.feed_hold();
    wait(&mut control, 500);
    assert_eq!((tries(&mut control), control.state()), ([false; 3], &State::Held));
    run(&mut control);
    assert_eq!((tries(&mut control), control.state()), ([false; 3], &State::Stopped(0)));
    run(&mut control);
    assert!(matches!(control.state(), State::Alarmed(_)));
    assert_eq!(tries(&mut control), [false; 3]);
    control.reset();
    wait(&mut control, 5);
    assert_eq!((tries(&mut control), control.state()), ([true; 3], &State::Reset));
}

#[test]
fn an_axis_comes_to_rest_on_its_limit_and_leads_back() {
    let machine = machine();
    let mut cnc = cnc(&machine, PROGRAM);
    cnc.jog(Axis::X, JogWay::Plus, JogSpeed::Rapid);
    let ticks = settle(&mut cnc);
    assert!(ticks.iter().all(|t| t.position[Axis::X] <= 500.0));
    assert_eq!((cnc.tick().position[Axis::X], cnc.state()), (500.0, &State::Ready));
    // Counts against the limit are lost.
    cnc.handwheel(Axis::X, 20, 0.1);
    settle(&mut cnc);
    cnc.handwheel(Axis::X, -3, 0.1);
    settle(&mut cnc);
    assert_eq!(cnc.tick().position[Axis::X], 499.7);
}

#[test]
fn steps_and_wheel_have_speeds_of_their_own() {
    let top = |ticks: &[Tick]| (ticks.iter().map(|t| t.velocity).fold(0.0, f64::max) * 60.0).round();
    // P155 = 1000 mm/min whatever the override (5.1.3).
    let mut control = cnc(&machine(), PROGRAM);
    control.set_override(0.1, 0.25);
    control.jog_step(Axis::X, 20, 1.0);
    assert_eq!(top(&settle(&mut control)), 1000.0);
    // 56#0 = 1 as delivered: all counts are run, as fast as the axis can; 56#7 = 1: in the sense of the wheel.
    control.handwheel(Axis::X, 1000, 0.1);
    assert_eq!(top(&settle(&mut control)), 10_000.0);
    assert_eq!(control.tick().position[Axis::X], 120.0);
    // 56#0 = 0: P151 and no more than can be braked; 56#7 = 0: against it.
    let setup = "[parameters]\n\"NO56.0\" = 0\n\"NO56.7\" = 0\nP151 = 600";
    let mut control = cnc_with(&machine(), PROGRAM, setup);
    for _ in 0..1000 {
        control.handwheel(Axis::X, 1, 0.1);
        control.tick();
    }
    assert_eq!(top(&settle(&mut control)), 600.0);
    // 10 mm/s for a second.
    let end = control.tick().position[Axis::X];
    assert!((-10.3..=-9.7).contains(&end), "{end}");
}

#[test]
fn reset_and_emergency_stop_bring_axes_moved_by_hand_to_rest() {
    for stop in [Cnc::reset, Cnc::emergency_stop] {
        for ended in [false, true] {
            let mut cnc = cnc(&machine(), PROGRAM);
            if ended {
                run(&mut cnc);
            }
            cnc.jog(Axis::X, JogWay::Plus, JogSpeed::Feed);
            wait(&mut cnc, 500);
            stop(&mut cnc);
            let ticks = settle(&mut cnc);
            // 33.3 mm/s at 2000 mm/s² and 50000 mm/s³: 2·√(33.3/50000) = 0.052 s, and the period that notes it.
            assert!((50..60).contains(&ticks.len()), "{}", ticks.len());
            wait(&mut cnc, 5);
            assert_eq!(cnc.state(), &State::Reset);
            assert!(!cnc.tick().moving);
        }
    }
}

/// Drives that do not move.
struct Stuck;

impl Drives for Stuck {
    fn exchange(&mut self, _: &Position) -> Position {
        Position::ZERO
    }
}

#[test]
fn an_axis_that_does_not_follow_the_hand_is_an_alarm() {
    let mut machine = machine();
    machine.axes[0].following_error = 1.0;
    let mut cnc = Cnc::with_drives(&machine, interpreter(PROGRAM, ""), Box::new(Stuck));
    cnc.jog(Axis::X, JogWay::Plus, JogSpeed::Feed);
    wait(&mut cnc, 1000);
    let State::Alarmed(alarm) = cnc.state() else { panic!("{:?}", cnc.state()) };
    assert_eq!(alarm.fault, Fault::FollowingError);
    assert_eq!(cnc.tick().velocity, 0.0);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn limits_hold_through_the_control(
        keys in prop::collection::vec((0usize..400, 0usize..4, 0usize..3, any::<bool>(), -50i64..50), 1..20),
        smooth in any::<bool>(),
    ) {
        let mut machine = machine();
        if smooth {
            machine.axes[0].after_jog = Smoothing::Linear { time_ms: 60.0 };
        }
        let mut control = cnc(&machine, PROGRAM);
        let start = control.tick().position;
        let mut ticks = Vec::new();
        for (periods, axis, way, rapid, n) in keys {
            let axis = [Axis::X, Axis::Y, Axis::Z, Axis::A][axis];
            match (way, n % 3) {
                (_, 1) => control.handwheel(axis, n, 0.1),
                (_, 2) => control.jog_step(axis, n, 1.0),
                (way, _) => control.jog(
                    axis,
                    [JogWay::Plus, JogWay::Minus, JogWay::Stop][way],
                    if rapid { JogSpeed::Rapid } else { JogSpeed::Feed },
                ),
            };
            ticks.extend((0..periods).map(|_| control.tick()));
        }
        control.reset();
        ticks.extend(settle(&mut control));
        let by_hand = crate::common::Run { start, ticks, events: Vec::new() };
        by_hand.check_limits(&machine, false);
        for tick in &by_hand.ticks {
            for axis in &machine.axes {
                prop_assert!((axis.min..=axis.max).contains(&tick.position[axis.name]));
            }
        }
        wait(&mut control, 3);
        prop_assert_eq!(control.state(), &State::Reset);
    }
}

#[test]
fn a_run_after_jog_is_the_run_from_there() {
    let mut by_hand = cnc(&machine(), "G90 G1 X20 Y5 F2000\nG0 X0\nM30\n");
    by_hand.handwheel(Axis::X, 73, 0.1);
    settle(&mut by_hand);
    let run = run_with(&mut by_hand, &[]);
    let mut there = cnc_with(&machine(), "G90 G1 X20 Y5 F2000\nG0 X0\nM30\n", "[start]\nX = 7.3");
    let other = run_with(&mut there, &[]);
    let positions = |run: &crate::common::Run| run.ticks.iter().map(|t| t.position).collect::<Vec<_>>();
    assert_eq!(positions(&run), positions(&other));
}
