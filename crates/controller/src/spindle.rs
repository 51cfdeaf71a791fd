//! The simulated spindle: runs up and brakes at a constant rate.

use ferrocut_geometry::Position;
use ferrocut_machine::Machine;
use ferrocut_toolpath::SpindleState;

/// A spindle with its speed.
#[derive(Clone, Copy, Debug)]
pub struct Spindle {
    /// Speed, r/min; clockwise positive.
    speed: f64,
    rate: f64,
    max: f64,
}

impl Spindle {
    /// The spindle of a machine, at rest.
    pub fn new(machine: &Machine) -> Spindle {
        Spindle { speed: 0.0, rate: machine.spindle.acceleration_rpm_s, max: machine.spindle.max_rpm }
    }

    /// Speed without its sense, r/min.
    pub fn rpm(&self) -> f64 {
        self.speed.abs()
    }

    /// Commands a state with the axes at `at`; the time until it is reached, s. A surface speed is
    /// turned into the speed that it means there.
    pub fn command(&mut self, state: SpindleState, at: &Position) -> f64 {
        let rpm = state.speed().map_or(0.0, |speed| speed.rpm(at)).min(self.max);
        let target = if matches!(state, SpindleState::CounterClockwise(_)) { -rpm } else { rpm };
        let change = (target - self.speed).abs();
        self.speed = target;
        change / self.rate
    }
}
