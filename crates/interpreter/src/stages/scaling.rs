//! Stage scaling and mirror: G50 and G51 (GSK990MC 4.2.14).
//!
//! `p' = c + f·(p − c)` on each linear axis of X, Y, Z. A negative factor mirrors. The centre is a
//! point of the work coordinate system whatever G90 or G91.

use ferrocut_geometry::{Plane, Position};

/// Scaling in force.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Scaling {
    /// Centre, programmed coordinates of X, Y, Z, mm.
    pub center: [f64; 3],
    /// Factors of X, Y, Z; never 0.
    pub factors: [f64; 3],
}

impl Scaling {
    /// The scaled point.
    pub fn apply(&self, mut p: Position) -> Position {
        for ((coordinate, center), factor) in p.0.iter_mut().zip(self.center).zip(self.factors) {
            *coordinate = center + factor * (*coordinate - center);
        }
        p
    }

    /// The point that is scaled to `p`.
    pub fn undo(&self, mut p: Position) -> Position {
        for ((coordinate, center), factor) in p.0.iter_mut().zip(self.center).zip(self.factors) {
            *coordinate = center + (*coordinate - center) / factor;
        }
        p
    }

    /// Factors on the two axes of a plane.
    pub fn in_plane(&self, plane: Plane) -> [f64; 2] {
        let of = |axis: ferrocut_geometry::Axis| self.factors.get(axis.index()).copied().unwrap_or(1.0);
        [of(plane.first()), of(plane.second())]
    }

    /// Whether the sense of arcs in a plane is reversed: one of its axes is mirrored.
    pub fn reverses(&self, plane: Plane) -> bool {
        let [a, b] = self.in_plane(plane);
        a * b < 0.0
    }
}
