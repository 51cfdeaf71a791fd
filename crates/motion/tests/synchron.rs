//! The electronic gear: in step at every moment, within the limits of the axes, exact at depth.
#![allow(missing_docs, clippy::unwrap_used)]

use assert_no_alloc::{AllocDisabler, assert_no_alloc};
use ferrocut_geometry::{Axis, Position};
use ferrocut_machine::Machine;
use ferrocut_motion::synchron::{Synchron, Thread};
use proptest::prelude::*;

#[global_allocator]
static ALLOCATOR: AllocDisabler = AllocDisabler;

/// A spindle that comes behind its command with a time constant, and an encoder that counts.
struct Spindle {
    angle: f64,
    keep: f64,
    counts: f64,
}

impl Spindle {
    fn new(lag_s: f64, counts: f64, period: f64) -> Spindle {
        Spindle { angle: 0.0, keep: if lag_s > 0.0 { (-period / lag_s).exp() } else { 0.0 }, counts }
    }

    fn go(&mut self, command: f64) -> f64 {
        self.angle = command + (self.angle - command) * self.keep;
        (self.angle * self.counts).floor() / self.counts
    }
}

fn thread(to: Position, pitch: f64, rpm: f64, is_clockwise: bool) -> Thread {
    Thread { to, pitch, rpm, is_clockwise, acceleration_rpm_s: 4000.0, encoder_counts: 4096.0 }
}

/// What a stroke did: positions of Z and angles of the spindle, period by period, and the greatest change of its
/// lag, turns/s.
struct Run {
    z: Vec<f64>,
    angles: Vec<f64>,
    rate: f64,
}

/// Runs a stroke to its end, `stop` it after so many periods.
fn run(gear: &mut Synchron, spindle: &mut Spindle, period: f64, stop: Option<usize>) -> Run {
    let mut run = Run { z: Vec::new(), angles: Vec::new(), rate: 0.0 };
    let mut lag = 0.0;
    while run.z.is_empty() || !gear.is_done() {
        if stop == Some(run.z.len()) {
            gear.stop();
        }
        let command = gear.advance();
        let measured = spindle.go(command);
        run.z.push(gear.follow(measured)[Axis::Z]);
        run.angles.push(spindle.angle);
        let error = spindle.angle - command;
        run.rate = run.rate.max((error - lag).abs() / period);
        lag = error;
        assert!(run.z.len() < 2_000_000, "does not end");
    }
    run
}

/// Largest difference of order `n`, over period^n, at rest before and after.
fn difference(z: &[f64], start: f64, n: usize, period: f64) -> f64 {
    let end = *z.last().unwrap();
    let mut d: Vec<f64> = [start; 4].into_iter().chain(z.iter().copied()).chain([end; 4]).collect();
    for _ in 0..n {
        d = d.windows(2).map(|w| w[1] - w[0]).collect();
    }
    d.iter().fold(0.0, |m: f64, v| m.max(v.abs())) / period.powi(n as i32)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_thread_in_and_out_is_in_step_within_the_limits_and_exact(
        pitch in 0.2..6.0f64,
        depth in 0.05..40.0f64,
        rpm in 30.0..6000.0f64,
        out in 0.5..3.0f64,
        lag_ms in prop_oneof![Just(0.0), 0.2..2.0f64],
        counts in prop_oneof![Just(2048.0), Just(4096.0), Just(20_000.0)],
        period_ms in prop_oneof![Just(0.25), Just(1.0), Just(2.0)],
        right_hand in any::<bool>(),
        stop in prop::option::of(0usize..3000),
    ) {
        let mut machine = Machine::demo_mill();
        machine.servo_period_ms = period_ms;
        let period = period_ms / 1000.0;
        let mut gear = Synchron::new(&machine, Position::ZERO);
        let mut spindle = Spindle::new(lag_ms / 1000.0, counts, period);
        let z = machine.axis(Axis::Z).unwrap().clone();
        let bottom = Position::xyz(0.0, 0.0, -depth);
        let strokes = [(Position::ZERO, bottom, rpm, right_hand), (bottom, Position::ZERO, rpm * out, !right_hand)];
        let mut angle = 0.0;
        let mut from = Position::ZERO;
        for (k, (_, to, rpm, clockwise)) in strokes.into_iter().enumerate() {
            let thread = Thread { encoder_counts: counts, ..thread(to, pitch, rpm, clockwise) };
            prop_assert!(gear.begin(from, angle, &thread));
            let stop = stop.filter(|_| k == 0);
            let run = run(&mut gear, &mut spindle, period, stop);
            let way = to - from;
            let sense = if clockwise { 1.0 } else { -1.0 };
            // A count of the encoder, and what the gear promises.
            let bound = gear.error_bound(run.rate) + pitch / counts + 1e-9;
            let mut worst = 0.0f64;
            for (at, turned) in run.z.iter().zip(&run.angles) {
                let meant = from[Axis::Z] + (turned - angle) * sense * pitch * way[Axis::Z].signum();
                worst = worst.max((at - meant).abs());
            }
            prop_assert!(worst <= bound, "{worst} beside the spindle, bound {bound}");
            let from_z = from[Axis::Z];
            prop_assert!(difference(&run.z, from_z, 1, period) <= z.velocity / 60.0 * 1.001);
            prop_assert!(difference(&run.z, from_z, 2, period) <= z.acceleration * 1.001);
            prop_assert!(difference(&run.z, from_z, 3, period) <= z.jerk * 1.001);
            match stop {
                None => prop_assert_eq!(gear.position(), to),
                // The sum may be rounded.
                Some(_) => prop_assert!((gear.position()[Axis::Z] - from_z).abs() <= depth + 1e-9),
            }
            // The next stroke begins where this one ended, the spindle where it was commanded to be.
            from = gear.position();
            let turns = (from[Axis::Z] - from_z).abs() / pitch;
            angle += sense * turns;
            if (from - to) != Position::ZERO {
                break;
            }
        }
    }
}

#[test]
fn the_axis_does_not_jump_where_the_spindle_turns_back() {
    // M8 at 1000 r/min, 20 mm deep: the axis passes through depth with the spindle, at rest for a moment.
    let machine = Machine::demo_mill();
    let mut gear = Synchron::new(&machine, Position::ZERO);
    let mut spindle = Spindle::new(0.001, 4096.0, 0.001);
    let bottom = Position::xyz(0.0, 0.0, -20.0);
    assert!(gear.begin(Position::ZERO, 0.0, &thread(bottom, 1.25, 1000.0, true)));
    let down = run(&mut gear, &mut spindle, 0.001, None);
    assert!((spindle.angle - 16.0).abs() < 1.0 / 4096.0, "20 / 1.25 turns: {}", spindle.angle);
    assert!(gear.begin(bottom, 16.0, &thread(Position::ZERO, 1.25, 1000.0, false)));
    let up = run(&mut gear, &mut spindle, 0.001, None);
    let both: Vec<f64> = down.z.iter().chain(&up.z).copied().collect();
    assert!(difference(&both, 0.0, 2, 0.001) <= 1500.0 && difference(&both, 0.0, 3, 0.001) <= 40_000.0);
    assert!(spindle.angle.abs() < 1.0 / 4096.0 && gear.position() == Position::ZERO);
}

#[test]
fn a_spindle_without_lag_takes_the_time_of_its_own_acceleration() {
    // 3000 r/min at 4000 r/min per second: 0.75 s each for running up and braking, 18.75 turns each. 40 turns of
    // 0.5 mm leave 2.5 at 50 a second. The axis could accelerate 36 times as much.
    let machine = Machine::demo_mill();
    let mut gear = Synchron::new(&machine, Position::ZERO);
    let mut spindle = Spindle::new(0.0, 4096.0, 0.001);
    assert!(gear.begin(Position::ZERO, 0.0, &thread(Position::xyz(0.0, 0.0, -20.0), 0.5, 3000.0, true)));
    let run = run(&mut gear, &mut spindle, 0.001, None);
    let time = run.z.len() as f64 * 0.001;
    // Building up the acceleration twice takes what 66.7 / (32,000/0.5) s are, a ms.
    assert!((1.55..1.56).contains(&time), "{time}");
}

#[test]
fn what_is_no_thread_is_refused() {
    let mut gear = Synchron::new(&Machine::demo_mill(), Position::ZERO);
    let to = Position::xyz(0.0, 0.0, -10.0);
    let good = thread(to, 1.0, 100.0, true);
    for bad in [
        Thread { pitch: 0.0, ..good },
        Thread { pitch: f64::NAN, ..good },
        Thread { pitch: f64::INFINITY, ..good },
        Thread { rpm: 0.0, ..good },
        Thread { to: Position::ZERO, ..good },
        Thread { acceleration_rpm_s: 0.0, ..good },
        Thread { to: Position::xyz(0.0, 0.0, f64::NAN), ..good },
    ] {
        assert!(!gear.begin(Position::ZERO, 0.0, &bad), "{bad:?}");
    }
    assert!(gear.begin(Position::ZERO, 0.0, &good));
}

#[test]
fn a_stroke_allocates_nothing() {
    let mut gear = Synchron::new(&Machine::demo_mill(), Position::ZERO);
    let mut spindle = Spindle::new(0.002, 4096.0, 0.001);
    assert_no_alloc(|| {
        for pitch in [0.2, 6.0, 1.0] {
            let to = Position::xyz(0.0, 0.0, -10.0);
            assert!(gear.begin(Position::ZERO, spindle.angle, &thread(to, pitch, 800.0, true)));
            for _ in 0..20_000 {
                let command = gear.advance();
                gear.follow(spindle.go(command));
            }
            gear.stop();
            assert!(gear.is_done());
        }
    });
}
