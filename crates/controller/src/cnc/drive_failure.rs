//! Drives that stop by themselves: a cable that is cut, a setpoint that came too late, an amplifier at fault. And
//! amplifiers that are taken off.

use super::{Cnc, State};
use ferrocut_geometry::AxisSet;

impl Cnc {
    /// The drives follow no command any more: everything comes to rest with their alarm. Where the axes came to rest is
    /// not where the path did: they are to be homed again.
    pub(super) fn fail_drives(&mut self) {
        if self.drives_failed || matches!(self.state, State::Alarmed(_)) || self.failed.is_some() {
            return;
        }
        let Some(alarm) = self.drives.failure(self.span) else { return };
        self.come_to_rest();
        self.drives_failed = true;
        self.failed = Some(alarm);
        self.set_referenced(AxisSet::EMPTY);
    }

    /// Whether the drives have stopped by themselves and were not reset since.
    pub fn drives_have_failed(&self) -> bool {
        self.drives_failed
    }

    /// Reset: drives whose alarm was given begin anew. Without it they would go on from a place that nobody was told of.
    pub(super) fn restart_drives(&mut self) {
        if std::mem::take(&mut self.drives_failed) {
            self.drives.restart();
        }
    }

    /// Amplifiers that are to be on or off, as in an emergency stop: off once the axes stand. Drives that lose their
    /// place then are to be homed again.
    pub fn power_drives(&mut self, on: bool) {
        if on == self.is_powered || !on && !self.stands_free() {
            return;
        }
        self.is_powered = on;
        if !self.drives.enable(on) {
            self.set_referenced(AxisSet::EMPTY);
        }
    }

    /// Whether no axis moves and nothing is about to move one.
    fn stands_free(&self) -> bool {
        let is_over = matches!(self.state, State::Ready | State::Ended | State::Reset | State::Alarmed(_));
        is_over && !self.manual.is_active && self.motion.is_still() && self.servo.is_at_rest()
    }
}
