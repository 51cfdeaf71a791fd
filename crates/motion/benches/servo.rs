//! What a servo period costs between path and drives: nine axes with acceleration after interpolation, backlash
//! and pitch errors in both directions, and as many with nothing.

use divan::counter::ItemsCount;
use ferrocut_geometry::{Axis, Position};
use ferrocut_machine::{AxisConfig, Backlash, Machine, PITCH_POINTS, PitchErrors, Smoothing};
use ferrocut_motion::Servo;
use ferrocut_motion::servo::Kind;

fn main() {
    divan::main();
}

const PERIODS: u32 = 100_000;

/// Nine axes like the X axis of the demo mill.
fn nine_axes(change: impl Fn(&mut AxisConfig)) -> Machine {
    let mut machine = Machine::demo_mill();
    machine.servo_period_ms = 0.25;
    let model = machine.axes.first().cloned();
    machine.axes = Axis::ALL
        .iter()
        .flat_map(|name| model.clone().map(|axis| AxisConfig { name: *name, ..axis }))
        .collect();
    machine.axes.iter_mut().for_each(change);
    machine
}

fn everything(axis: &mut AxisConfig) {
    axis.after_rapid = Smoothing::Linear { time_ms: 80.0 };
    axis.after_cutting = Smoothing::Linear { time_ms: 400.0 };
    axis.after_jog = Smoothing::Exponential { time_ms: 60.0, least: 10.0 };
    axis.backlash = Backlash { cutting: 0.01, rapid: Some(0.02), time_ms: 400.0, ..Backlash::default() };
    axis.pitch_errors = Some(PitchErrors {
        start: Some(-500.0),
        interval: Some(0.1),
        corrections: (0..PITCH_POINTS).map(|k| (k as f64 * 0.01).sin() * 0.01).collect(),
        opposite: (0..PITCH_POINTS).map(|k| (k as f64 * 0.01).cos() * 0.01).collect(),
    });
    (axis.following_error, axis.in_position) = (0.5, 0.01);
}

/// Circles over all axes, positioning and cutting in turns.
fn run(servo: &mut Servo, way: &[Position]) {
    for (k, at) in (0u32..).zip(way) {
        let kind = if k / 500 % 2 == 0 { Kind::Rapid } else { Kind::Cutting };
        let command = servo.tick(at, kind);
        divan::black_box(servo.supervise(&command.drive));
    }
}

fn way() -> Vec<Position> {
    let place = |k: u32, i: usize| ((f64::from(k) * 0.002 + i as f64).sin() - (i as f64).sin()) * 100.0;
    (0..PERIODS).map(|k| Position(std::array::from_fn(|i| place(k, i)))).collect()
}

fn measure(bencher: divan::Bencher, machine: &Machine) {
    let way = way();
    bencher
        .counter(ItemsCount::new(PERIODS))
        .with_inputs(|| Servo::new(machine, Position::ZERO))
        .bench_refs(|servo| run(servo, &way));
}

#[divan::bench(sample_count = 20, sample_size = 1)]
fn nine_axes_with_everything(bencher: divan::Bencher) {
    measure(bencher, &nine_axes(everything));
}

#[divan::bench(sample_count = 20, sample_size = 1)]
fn nine_axes_with_nothing(bencher: divan::Bencher) {
    measure(bencher, &nine_axes(|_| {}));
}
