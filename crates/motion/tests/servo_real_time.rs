//! After `new`, what lies between path and drives allocates nothing: any allocation inside the guard ends the
//! test program.
#![allow(missing_docs, clippy::unwrap_used)]

use assert_no_alloc::{AllocDisabler, assert_no_alloc};
use ferrocut_geometry::{Axis, Position};
use ferrocut_machine::{Backlash, Machine, PITCH_POINTS, PitchErrors, Smoothing};
use ferrocut_motion::Servo;
use ferrocut_motion::servo::Kind;

#[global_allocator]
static ALLOCATOR: AllocDisabler = AllocDisabler;

/// Nine axes with everything that there is.
fn nine_axes() -> Machine {
    let mut machine = Machine::demo_mill();
    machine.servo_period_ms = 0.25;
    let model = machine.axes[0].clone();
    machine.axes = Axis::ALL.map(|name| ferrocut_machine::AxisConfig { name, ..model.clone() }).to_vec();
    for axis in &mut machine.axes {
        axis.after_rapid = Smoothing::Exponential { time_ms: 60.0, least: 10.0 };
        axis.after_cutting = Smoothing::Linear { time_ms: 80.0 };
        axis.after_jog = Smoothing::Linear { time_ms: 400.0 };
        axis.backlash = Backlash { cutting: 0.01, rapid: Some(0.02), waits: true, ..Backlash::default() };
        axis.pitch_errors = Some(PitchErrors {
            start: Some(-500.0),
            interval: Some(0.1),
            corrections: (0..PITCH_POINTS).map(|k| (k as f64 * 0.01).sin() * 0.01).collect(),
            opposite: (0..PITCH_POINTS).map(|k| (k as f64 * 0.01).cos() * 0.01).collect(),
        });
        (axis.following_error, axis.in_position) = (0.5, 0.01);
    }
    machine
}

#[test]
fn a_period_allocates_nothing() {
    let mut servo = Servo::new(&nine_axes(), Position::ZERO);
    let kinds = [Kind::Rapid, Kind::Cutting, Kind::Jog];
    let mut faults = 0u32;
    assert_no_alloc(|| {
        for k in 0..100_000u32 {
            let phi = f64::from(k) * 0.003;
            let mut at = Position::ZERO;
            for (i, axis) in Axis::ALL.into_iter().enumerate() {
                at[axis] = (phi + i as f64).sin() * 100.0 - (i as f64).sin() * 100.0;
            }
            let command = servo.tick(&at, kinds[k as usize / 1000 % 3]);
            // Beyond a limit and behind the command now and then.
            let behind = if k % 997 == 0 { 1.0 } else { 0.0 };
            let actual = command.drive - Position::xyz(behind, 0.0, 0.0);
            faults += u32::from(servo.supervise(&actual).is_some());
        }
        let at = servo.tick(&Position::xyz(1e9, f64::MAX, f64::NAN), Kind::Cutting).position;
        servo.rename(Position::xyz(0.0, 0.0, 0.0));
        assert!(at[Axis::X] != 0.0 && servo.tick(&Position::ZERO, Kind::Jog).fault.is_none());
    });
    assert!(faults > 90);
}
