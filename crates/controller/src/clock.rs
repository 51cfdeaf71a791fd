//! When the next servo period begins.

use std::time::{Duration, Instant};

/// The clock that servo periods are counted on.
#[derive(Clone, Copy, Debug)]
pub enum Clock {
    /// The next period begins at once: a run takes no longer than computing it.
    Virtual,
    /// The next period begins when it is due.
    Real {
        /// When it is due.
        due: Instant,
        /// Length of a period.
        period: Duration,
    },
}

impl Clock {
    /// A clock at true speed whose first period begins now.
    pub fn real(period_ms: f64) -> Clock {
        Clock::Real { due: Instant::now(), period: Duration::from_secs_f64(period_ms / 1000.0) }
    }

    /// Waits for the next period. Deadlines are absolute, so that a late period does not shift those
    /// after it.
    pub fn wait(&mut self) {
        let Clock::Real { due, period } = self else { return };
        *due += *period;
        let now = Instant::now();
        if let Some(left) = due.checked_duration_since(now) {
            std::thread::sleep(left);
        } else if now - *due > Duration::from_secs(1) {
            // The process was stopped or the computer slept: go on from here, not in a hurry.
            *due = now;
        }
    }
}
