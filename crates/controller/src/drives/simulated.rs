//! Drives that exist in memory only: the axes are where they are commanded to be.

use super::Drives;
use ferrocut_geometry::Position;

/// Ideal drives.
#[derive(Clone, Copy, Debug, Default)]
pub struct Simulated;

impl Drives for Simulated {
    fn exchange(&mut self, commanded: &Position) -> Position {
        *commanded
    }

    /// They are where they are commanded to be, and have no switch to find it again.
    fn loses_place_with_power(&self) -> bool {
        false
    }
}
