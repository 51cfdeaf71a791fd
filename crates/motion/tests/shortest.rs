//! Single moves from rest to rest against time-optimal profiles of another library.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{demo, line, run};
use ferrocut_geometry::Position;
use ferrocut_machine::Machine;
use ferrocut_toolpath::{Op, PathMode};
use proptest::prelude::*;
use rsruckig::prelude::{InputParameter, Ruckig, ThrowErrorHandler, Trajectory};

const PERIOD: f64 = 0.0001;

/// Velocity, acceleration and jerk of an axis: mm/s, mm/s², mm/s³.
type Axis = [f64; 3];

fn axis() -> impl Strategy<Value = Axis> {
    [1.0..500.0f64, 50.0..5000.0, 500.0..500_000.0]
}

/// Millimetres, many of them few.
fn way() -> impl Strategy<Value = f64> {
    (-2.0..2.3f64).prop_map(|power| 10f64.powf(power))
}

fn machine(axes: &[Axis; 3]) -> Machine {
    let mut machine = demo();
    machine.servo_period_ms = PERIOD * 1e3;
    for (axis, [velocity, acceleration, jerk]) in machine.axes.iter_mut().zip(axes) {
        (axis.velocity, axis.rapid) = (velocity * 60.0, velocity * 60.0);
        (axis.acceleration, axis.jerk) = (*acceleration, *jerk);
    }
    machine
}

/// Least time from rest to rest with every axis on its own, s.
fn least<const N: usize>(ways: [f64; N], axes: [Axis; N]) -> f64 {
    let mut ruckig = Ruckig::<N, ThrowErrorHandler>::new(None, PERIOD);
    let mut input = InputParameter::<N>::new(None);
    let mut trajectory = Trajectory::<N>::new(None);
    for i in 0..N {
        input.target_position[i] = ways[i];
        [input.max_velocity[i], input.max_acceleration[i], input.max_jerk[i]] = axes[i];
    }
    ruckig.calculate(&input, &mut trajectory).unwrap();
    trajectory.get_duration()
}

/// Planned with 0.1 % of every limit kept back, and seen at the ends of periods.
fn judge(time: f64, least: f64) -> Result<(), TestCaseError> {
    prop_assert!(time <= 1.01 * least + 2.0 * PERIOD, "{} s, possible {} s", time, least);
    prop_assert!(time >= least - 2.0 * PERIOD, "{} s, less than {} s", time, least);
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, ..ProptestConfig::default() })]

    #[test]
    fn one_axis(way in way(), axis in axis()) {
        let least = least([way], [axis]);
        prop_assume!(least < 4.0);
        let machine = machine(&[axis; 3]);
        let ops = [line(way, 0.0, 0.0, 1e6, PathMode::Continuous)];
        judge(run(&machine, Position::ZERO, &ops).time(), least)?;
    }

    #[test]
    fn several_axes_on_a_line(ways in [way(), way(), way()], axes in [axis(), axis(), axis()]) {
        // The path has the limits of the axis that is slowest on it.
        let len = ways[0].hypot(ways[1]).hypot(ways[2]);
        let limit = |k: usize| (0..3).map(|i| axes[i][k] / (ways[i] / len)).fold(f64::INFINITY, f64::min);
        let least = least([len], [[limit(0), limit(1), limit(2)]]);
        prop_assume!(least < 4.0);
        let to = Position::xyz(ways[0], -ways[1], ways[2]);
        for op in [
            Op::Rapid { to, straight: true, speed: None, path: PathMode::ON_PATH },
            line(to.0[0], to.0[1], to.0[2], 1e6, PathMode::Continuous),
        ] {
            judge(run(&machine(&axes), Position::ZERO, &[op]).time(), least)?;
        }
    }

    #[test]
    fn every_axis_on_its_own(ways in [way(), way(), way()], axes in [axis(), axis(), axis()]) {
        let least = least(ways, axes);
        prop_assume!(least < 4.0);
        let to = Position::xyz(ways[0], -ways[1], ways[2]);
        let run = run(&machine(&axes), Position::ZERO, &[Op::Rapid { to, straight: false, speed: None, path: PathMode::ON_PATH }]);
        judge(run.time(), least)?;
    }
}
