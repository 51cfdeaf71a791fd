//! Drives that stop by themselves: a cable that is cut, a setpoint that came too late, an amplifier at fault.

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
}
