//! What moves the axes.

mod simulated;

pub use simulated::Simulated;

use ferrocut_geometry::Position;

/// The drives of a machine, asked once a servo period.
pub trait Drives {
    /// Commands a position, mm and degrees, and returns where the axes are.
    fn exchange(&mut self, commanded: &Position) -> Position;

    /// The place where the axes stand is called by these positions from here on. Drives that count for
    /// themselves take them over; to others, which are told positions alone, it is nothing.
    fn rename(&mut self, _at: &Position) {}
}
