//! Rigid tapping in a run: axis and spindle in step, whatever the operator does.

use crate::common::{alarmed, cnc, machine};
use ferrocut_controller::{Activity, Cnc, DryRun, State, Tick};
use ferrocut_geometry::Axis;
use ferrocut_interpreter::{Interpreter, Options, dialects};
use ferrocut_machine::{Fault, Machine, Memory, PlantConfig, Smoothing};
use ferrocut_program::{ProgramMemory, Text};
use proptest::prelude::*;

/// An M10 x 1.5 hole 20 mm deep from R 5, S 600: 16 2/3 turns.
const PROGRAM: &str = "G94 G90 G0 X10\nM29 S600\nG84 Z-20 R5 P300 F900\nG80 X20\nM30\n";
const TURNS: f64 = 25.0 / 1.5;

/// What a period ends with: the setpoints and the angle of the spindle.
type Moment = (Tick, f64);

/// Runs to the end of program, reset or alarm; `hands` are told the number of the tick before it.
fn run(cnc: &mut Cnc, mut hands: impl FnMut(&mut Cnc, usize)) -> Vec<Moment> {
    cnc.cycle_start();
    let mut moments = Vec::new();
    for k in 0..200_000 {
        hands(cnc, k);
        let tick = cnc.tick();
        moments.push((tick, cnc.spindle().angle()));
        if !matches!(cnc.state(), State::Running | State::Held | State::Resetting) {
            return moments;
        }
    }
    panic!("does not end: {:?}", cnc.state());
}

fn z(moment: &Moment) -> f64 {
    moment.0.position[Axis::Z]
}

/// Where the spindle turned, Z is R less pitch times turns, within two counts of the encoder.
fn check_in_step(moments: &[Moment], pitch: f64) {
    let bound = 2.5 / 4096.0 * pitch;
    let mut turned = 0;
    for w in moments.windows(2) {
        if w[0].1 != w[1].1 {
            turned += 1;
            let meant = 5.0 - w[1].1 * pitch;
            assert!((z(&w[1]) - meant).abs() <= bound, "{} instead of {meant}", z(&w[1]));
        }
    }
    assert!(turned > 20, "{turned} periods");
}

/// Velocity, acceleration and jerk of Z.
fn check_limits(machine: &Machine, moments: &[Moment]) {
    let axis = machine.axis(Axis::Z).unwrap();
    let t = machine.servo_period_ms / 1000.0;
    let mut d: Vec<f64> = moments.iter().map(z).collect();
    for (n, limit) in [(1, axis.rapid / 60.0), (2, axis.acceleration)] {
        d = d.windows(2).map(|w| (w[1] - w[0]) / t).collect();
        let most = d.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
        assert!(most <= limit * 1.001 + 1e-3, "difference {n}: {most} above {limit}");
    }
}

#[test]
fn a_hole_is_tapped_in_step_with_the_spindle() {
    let machine = machine();
    let mut control = cnc(&machine, PROGRAM);
    let moments = run(&mut control, |_, _| {});
    assert_eq!(control.state(), &State::Ended);
    check_in_step(&moments, 1.5);
    check_limits(&machine, &moments);
    // At depth exactly, both at rest for the dwell, and back where it began.
    let deep = moments.iter().filter(|m| z(m) == -20.0 && !m.0.moving).count();
    assert_eq!(deep, 300);
    let deepest = moments.iter().map(z).fold(f64::INFINITY, f64::min);
    assert!(deepest >= -20.0 - 1.5 * 2.5 / 4096.0, "{deepest}");
    let turns = moments.iter().map(|m| m.1).fold(0.0, f64::max);
    assert!((turns - TURNS).abs() < 1e-9, "{turns}");
    assert!(moments.last().unwrap().1.abs() < 1e-9);
    // 600 r/min at 4000 a second: 0.15 s to run up, 0.75 turns; 1.8166 s a stroke and a little for jerk.
    let cutting = control.report().time(Activity::Cutting);
    assert!((3.63..3.66).contains(&cutting), "{cutting}");
    assert_eq!(control.report().cutting_mm, 50.0);
}

#[test]
fn axes_follow_a_spindle_that_lags() {
    let machine = Machine { plant: Some(PlantConfig::default()), ..machine() };
    let mut ideal = cnc(&crate::common::machine(), PROGRAM);
    let ideal = run(&mut ideal, |_, _| {});
    let mut control = cnc(&machine, PROGRAM);
    let moments = run(&mut control, |_, _| {});
    assert_eq!(control.state(), &State::Ended);
    // 1 ms behind at 10 turns a second: 0.01 turns, 15 µm if the axis went by the command.
    let lag = ideal.iter().zip(&moments).map(|(a, b)| (a.1 - b.1).abs()).take(1500).fold(0.0, f64::max);
    assert!((0.005..0.02).contains(&lag), "{lag}");
    // pitch · (1.5 counts + 1.5·h·|de/dt|), the lag growing by 1 ms · 4000 r/min per second; and a count of the encoder.
    let bound = 1.5 * (2.5 / 4096.0 + 1.5 * 0.006 * 0.001 * 4000.0 / 60.0);
    for w in moments.windows(2).filter(|w| w[0].1 != w[1].1) {
        let meant = 5.0 - w[1].1 * 1.5;
        assert!((z(&w[1]) - meant).abs() <= bound, "{} instead of {meant}", z(&w[1]));
    }
    check_limits(&machine, &moments);
    assert!(moments.iter().any(|m| z(m) == -20.0 && !m.0.moving));
    let last = moments.last().unwrap();
    assert!(last.1.abs() < 1e-3, "{}", last.1);
}

#[test]
fn a_left_hand_thread_turns_the_other_way_and_a_turning_spindle_stops_first() {
    let program = PROGRAM.replace("G84", "G74").replace("M29 S600", "M3 S1200\nM29 S600");
    let mut control = cnc(&machine(), &program);
    let moments = run(&mut control, |_, _| {});
    assert_eq!(control.state(), &State::Ended);
    let bottom = moments.iter().position(|m| z(m) == -20.0).unwrap();
    let start = moments[..bottom].iter().rposition(|m| z(m) == 5.0).unwrap();
    let turned = moments[bottom].1 - moments[start].1;
    assert!((turned + TURNS).abs() < 1e-9, "{turned}");
    // It came to rest on its marker.
    assert!(moments[start].1.fract().abs() < 1e-9, "{}", moments[start].1);
}

#[test]
fn smoothing_of_cutting_does_not_delay_a_tap() {
    let mut machine = machine();
    for axis in &mut machine.axes {
        axis.after_cutting = Smoothing::Linear { time_ms: 80.0 };
    }
    let moments = run(&mut cnc(&machine, PROGRAM), |_, _| {});
    check_in_step(&moments, 1.5);
}

#[test]
fn the_way_out_has_its_own_time_constant() {
    // In the first gear, and in the second and the third one, which S 600 needs.
    for setup in [
        "P294 = 600\nP298 = 300\nP302 = 600",
        "P246 = 599\nP294 = 100\nP295 = 600\nP299 = 300\nP303 = 600",
        "P246 = 500\nP247 = 599\nP295 = 100\nP296 = 600\nP300 = 300\nP304 = 600",
    ] {
        let mut control = crate::common::cnc_with(&machine(), PROGRAM, &format!("[parameters]\n{setup}"));
        let moments = run(&mut control, |_, _| {});
        check_in_step(&moments, 1.5);
        // 600 r/min in 0.3 s takes 1.5 turns, in 0.6 s 3; the rest at 10 turns a second.
        let cutting = control.report().time(Activity::Cutting);
        let expected = 2.0 * TURNS / 10.0 + 0.3 + 0.6;
        assert!((cutting - expected).abs() < 0.02, "{setup}: {cutting} {expected}");
    }
}

/// GSK990MC P294 to P297: 0200. Where the ladder chooses the gear (38#5) the machine judges it, not the program's
/// reader.
#[test]
fn no_gear_taps_faster_than_it_may() {
    for (setup, in_program) in [
        ("P294 = 599", true),
        ("P246 = 599\nP295 = 599", true),
        ("P246 = 599\nP294 = 1", false),
        ("\"NO38.5\" = 1\nP294 = 599\nP246 = 600", true),
    ] {
        let mut control = crate::common::cnc_with(&machine(), PROGRAM, &format!("[parameters]\n{setup}"));
        run(&mut control, |_, _| {});
        let fault = match control.state() {
            State::Alarmed(alarm) => Some((alarm.fault, alarm.span.line)),
            _ => None,
        };
        assert_eq!(fault, in_program.then_some((Fault::TappingSpeed, 3)), "{setup}");
    }
}

#[test]
fn pecks_stay_in_one_thread() {
    for (bit, strokes) in [(1, 8), (0, 11)] {
        let program = PROGRAM.replace("P300", "Q7 V2");
        let setup = format!("[parameters]\n\"NO44.5\" = {bit}");
        let mut control = crate::common::cnc_with(&machine(), &program, &setup);
        let moments = run(&mut control, |_, _| {});
        assert_eq!(control.state(), &State::Ended);
        check_in_step(&moments, 1.5);
        // The rapid to R and the one behind the hole, the way to X10 and X20.
        assert!(control.report().moves >= strokes, "{}", control.report().moves);
    }
}

#[test]
fn an_emergency_stop_brings_both_to_rest_in_step() {
    let machine = machine();
    for after in [1usize, 100, 900, 2200, 2500] {
        let mut control = cnc(&machine, PROGRAM);
        let mut begun = 0;
        let moments = run(&mut control, |cnc, _| {
            begun += usize::from(cnc.spindle().angle() != 0.0);
            if begun == after {
                cnc.emergency_stop();
            }
        });
        assert_eq!(control.state(), &State::Reset);
        check_limits(&machine, &moments);
        if after >= 100 {
            check_in_step(&moments, 1.5);
        }
        let last = moments.last().unwrap();
        assert!(z(last) < 5.0 && z(last) >= -20.01 && !last.0.moving, "{}", z(last));
        for _ in 0..5 {
            let tick = control.tick();
            assert_eq!((tick.position, control.spindle().angle()), (last.0.position, last.1));
        }
    }
}

#[test]
fn the_passes_of_a_thread_meet() {
    let program = "M3 S300\nG0 X1 Z0\nG33 Z-10.3 K1.75\nG0 X3\nZ0\nX0.9\nG33 Z-10.3 K1.75\nG0 X3\nM2\n";
    let dialect = &dialects::rs274::DIALECT;
    let text = Text::from_bytes(program.as_bytes().to_vec()).unwrap();
    let programs = ProgramMemory::new("thread.ngc", text, dialect.syntax);
    let interpreter = Interpreter::new(dialect, programs, Memory::new(dialect.name), Options::default());
    let mut control = Cnc::new(&machine(), interpreter);
    let moments = run(&mut control, |_, _| {});
    assert_eq!(control.state(), &State::Ended);
    // Wherever the tool is deep in the thread, angle and place belong together.
    let mut seen = [0, 0];
    for (tick, angle) in &moments {
        let [x, _, z, ..] = tick.position.0;
        if x < 2.0 && z < 0.0 && z > -10.3 {
            let off = (angle + z / 1.75).rem_euclid(1.0);
            assert!(off.min(1.0 - off) < 2.5 / 4096.0, "Z {z}, {angle} turns: {off}");
            seen[usize::from(x < 0.95)] += 1;
        }
    }
    assert!(seen.iter().all(|n| *n > 1000), "{seen:?}");
}

#[test]
fn a_thread_that_cannot_be_is_an_alarm() {
    // 0.001 mm/min at 600 r/min are fifteen million turns.
    let (alarm, run) = alarmed(&mut cnc(&machine(), &PROGRAM.replace("F900", "F0.001")));
    assert_eq!((alarm.fault, alarm.span.line, run.end()[Axis::Z]), (Fault::FeedNotReachable, 3, 5.0));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() })]

    /// GSK990MC 4.5.1: feed hold and reset act once the tool is out.
    #[test]
    fn hold_and_reset_wait_until_the_tool_is_out(at in 0usize..6000, resets in any::<bool>()) {
        let machine = machine();
        let mut control = cnc(&machine, PROGRAM);
        let mut held = 0;
        let moments = run(&mut control, |cnc, k| {
            if k == at && resets {
                cnc.reset();
            } else if k == at {
                cnc.feed_hold();
            }
            if cnc.state() == &State::Held {
                held += 1;
                if held == 3000 {
                    cnc.cycle_start();
                }
            }
        });
        check_limits(&machine, &moments);
        let through = run(&mut cnc(&machine, PROGRAM), |_, _| {});
        let turned = moments.iter().map(|m| m.1).fold(0.0, f64::max);
        // The thread is cut whole or not at all, and the tool is out of it.
        prop_assert!(turned == 0.0 || (turned - TURNS).abs() < 1e-9, "{turned}");
        prop_assert!(z(moments.last().unwrap()) >= -1e-9);
        match control.state() {
            State::Ended => prop_assert_eq!(moments.last().unwrap().0.position, through.last().unwrap().0.position),
            state => prop_assert!(resets && state == &State::Reset, "{:?}", state),
        }
    }
}

/// The same, whose hands are told where Z is.
fn run_at(cnc: &mut Cnc, mut hands: impl FnMut(&mut Cnc, f64)) -> Vec<Moment> {
    let mut moments: Vec<Moment> = Vec::new();
    cnc.cycle_start();
    for _ in 0..200_000 {
        hands(cnc, moments.last().map_or(0.0, z));
        let tick = cnc.tick();
        moments.push((tick, cnc.spindle().angle()));
        if !matches!(cnc.state(), State::Running | State::Held | State::Resetting) {
            return moments;
        }
    }
    panic!("does not end: {:?}", cnc.state());
}

/// GSK990MC 4.4.5: in the thread of a floating tap overrides count as 100 %, dry run changes nothing, and feed hold acts
/// once the tool is out.
#[test]
fn overrides_and_hold_have_no_effect_in_the_thread_of_a_floating_tap() {
    let program = "G94 G90 G98 G0 X10 Z20\nM3 S600\nG84 Z-20 R5 P300 F900\nG80 X20\nM30\n";
    let machine = machine();
    let undisturbed = run(&mut cnc(&machine, program), |_, _| {});
    let in_thread = |moments: &[Moment]| -> Vec<f64> {
        let above = moments.iter().position(|m| z(m) == 20.0).unwrap();
        let first = above + moments[above..].iter().position(|m| z(m) < 5.0).unwrap();
        let last = moments.iter().rposition(|m| z(m) < 5.0).unwrap();
        moments[first..=last].iter().map(z).collect()
    };
    let wanted = in_thread(&undisturbed);
    for asked_at in [-1.0, -19.0, -20.0] {
        let mut control = cnc(&machine, program);
        let (mut above, mut asked, mut held_at) = (false, false, None);
        let moments = run_at(&mut control, |control, at| {
            above |= at == 20.0;
            if above && at < 5.0 - 1e-9 {
                control.set_override(0.3, 0.25);
                control.set_dry_run(Some(ferrocut_controller::DryRun {
                    speed: 10.0,
                    cutting: true,
                    rapid: true,
                    tapping: false,
                }));
            } else {
                control.set_override(1.0, 1.0);
                control.set_dry_run(None);
            }
            if above && !asked && at <= asked_at {
                asked = true;
                control.feed_hold();
                assert_eq!(control.state(), &State::Running, "{asked_at}");
            }
            if control.state() == &State::Held && held_at.is_none() {
                held_at = Some(at);
                control.cycle_start();
            }
        });
        assert_eq!(control.state(), &State::Ended);
        // It was held where the tool is out: in R.
        assert_eq!(held_at, Some(5.0), "{asked_at}");
        let is = in_thread(&moments);
        assert_eq!(is.len(), wanted.len(), "{asked_at}");
        let apart = is.iter().zip(&wanted).map(|(is, wanted)| (is - wanted).abs()).fold(0.0, f64::max);
        assert!(apart < 1e-9, "{asked_at}: {apart}");
    }
    // A reset and an emergency stop act at once.
    let mut control = cnc(&machine, program);
    let moments = run_at(&mut control, |control, at| {
        if at < -10.0 {
            control.reset();
        }
    });
    assert_eq!(control.state(), &State::Reset);
    assert!(z(moments.last().unwrap()) < -9.0);
}

/// 12#5 (7.5, note 2): dry run holds for tapping only where it is set; a rigid tap stays in step, as fast as its gear goes.
#[test]
fn dry_run_taps_faster_only_where_it_holds_for_tapping() {
    let floating = "G94 G90 G98 G0 X10 Z20\nM3 S600\nG84 Z-20 R5 P300 F900\nG80 X20\nM30\n";
    let rigid = &floating.replace("M3 S", "M29 S");
    let machine = machine();
    let fastest = |program: &str, dry: Option<DryRun>| {
        let mut control = cnc(&machine, program);
        control.set_dry_run(dry);
        let moments = run(&mut control, |_, _| {});
        assert_eq!(control.state(), &State::Ended);
        let from_r = moments.iter().skip_while(|m| z(m) < 20.0).filter(|m| m.0.moving && z(m) < 4.9);
        let speed = from_r.map(|m| m.0.velocity).fold(0.0, f64::max);
        (moments, speed * 60.0)
    };
    let dry = DryRun { speed: 30.0, cutting: true, rapid: false, tapping: false };
    for program in [floating, rigid] {
        for (dry, speed) in [
            (None, 900.0),
            (Some(dry), 900.0),
            (Some(DryRun { tapping: true, cutting: false, ..dry }), 1800.0),
        ] {
            let (moments, fastest) = fastest(program, dry);
            assert!((fastest - speed).abs() < 0.5, "{program} {dry:?}: {fastest}");
            if program == rigid {
                check_in_step(&moments, 1.5);
                check_limits(&machine, &moments);
            }
        }
    }
    // No faster than the spindle may turn: 1000 r/min.
    let mut slow = machine.clone();
    slow.spindle.max_rpm = 1000.0;
    let mut control = cnc(&slow, rigid);
    control.set_dry_run(Some(DryRun { tapping: true, ..dry }));
    let moments = run(&mut control, |_, _| {});
    let turned = moments.windows(2).map(|w| (w[1].1 - w[0].1).abs()).fold(0.0, f64::max);
    assert!((turned * 60_000.0 / machine.servo_period_ms - 1000.0).abs() < 1.0, "{turned}");
}
