//! The simulated spindle: runs up and brakes at a constant rate.

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

    /// Commands a state; the time until it is reached, s.
    pub fn command(&mut self, state: SpindleState) -> f64 {
        let target = match state {
            SpindleState::Off => 0.0,
            SpindleState::Clockwise(rpm) => rpm.min(self.max),
            SpindleState::CounterClockwise(rpm) => -rpm.min(self.max),
        };
        let change = (target - self.speed).abs();
        self.speed = target;
        change / self.rate
    }
}
