//! Stage tool length: G43, G44, G49 with H.
//!
//! `machine point = point + vector`. The vector has the offset of H, its sign by G43 or G44, on one
//! axis: Z (method A), or the axis square to the plane (method B, GSK990MC 4.7.1, bit 39#0). A new
//! H replaces the old offset, it is not added to it.

use ferrocut_geometry::{Axis, Position};

/// Tool length compensation in force.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct ToolLength {
    /// Added to every point, mm.
    pub vector: Position,
    /// Number of the offset last called, H.
    pub number: u16,
    /// An H word came that waits for its axis to move (H00, GSK990MC 4.7.1 note 4).
    pub waits: bool,
}

impl ToolLength {
    /// The offset put on `axis`, with its sign.
    pub fn set(&mut self, axis: Axis, signed_offset: f64) {
        self.vector[axis] = signed_offset;
        self.waits = false;
    }

    /// Every axis without offset.
    pub fn cancel(&mut self) {
        self.vector = Position::ZERO;
        self.waits = false;
    }
}
