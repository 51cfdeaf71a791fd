//! A program that the handwheel drives (GSK990MC part 2, 6.4): with G42.0 on, in AUTO with dry run, cycle start moves no
//! axis; the wheel does, the faster it is turned the faster. Dry run itself has no effect then (note 1), single block has
//! (note 2).
//!
//! The manual leaves open what the wheel is measured by. Here one turn a second, 100 counts, is the programmed speed,
//! times the overrides; a wheel that is turned back stands. Threads and tapping follow their spindle and no override.

use super::Control;
use crate::signals::Mode;

/// Counts a second that give the programmed speed: a turn of a handwheel with 100 counts.
const RATED: f64 = 100.0;

/// Time in which the speed follows the wheel, s: counts come in portions.
const FOLLOWS_S: f64 = 0.1;

/// A wheel without a count for so long stands, s.
const STANDS_S: f64 = 0.1;

/// Overrides change by such steps, so that motion is not planned anew in each period.
const STEPS: f64 = 50.0;

/// How the wheel that drives a program is turned.
#[derive(Clone, Copy, Default)]
pub(super) struct Wheel {
    /// How fast, by its rated speed.
    rate: f64,
    /// For how long no count has come, s.
    silent: f64,
}

impl Control {
    /// Whether the wheel drives the program.
    pub(super) fn is_driven_by_wheel(&self) -> bool {
        self.inputs.handwheel_drive && self.inputs.dry_run && self.program_mode() == Mode::Auto
    }

    /// The factor by which the wheel lets the program run, from the counts of this period; 1 where it does not drive.
    pub(super) fn take_wheel_drive(&mut self) -> f64 {
        if !self.is_driven_by_wheel() {
            self.wheel = Wheel::default();
            return 1.0;
        }
        // A wheel that moves axes by hand meanwhile keeps its counts.
        let counts = if self.mode == Mode::Handle { 0 } else { std::mem::take(&mut self.counts) };
        let seconds = self.machine.servo_period_ms / 1000.0;
        let rate = f64::from(counts.max(0)) / seconds / RATED;
        let wheel = &mut self.wheel;
        wheel.rate += (rate - wheel.rate) * (seconds / FOLLOWS_S).min(1.0);
        wheel.silent = if counts > 0 { 0.0 } else { wheel.silent + seconds };
        if wheel.silent > STANDS_S || counts < 0 {
            wheel.rate = 0.0;
        }
        (wheel.rate * STEPS).round() / STEPS
    }
}
