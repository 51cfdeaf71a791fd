//! Stage rotation: G68 and G69 (GSK990MC 4.2.15). Scaling comes first.

use ferrocut_geometry::{Plane, Position};

/// Rotation in force.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Rotation {
    /// Plane of the rotation.
    pub plane: Plane,
    /// Centre on the plane's axes, scaled coordinates, mm.
    pub center: [f64; 2],
    /// Angle, degrees, counter-clockwise positive.
    pub degrees: f64,
}

impl Rotation {
    fn turned(&self, mut p: Position, degrees: f64) -> Position {
        let [a, b] = self.vector(self.plane.of(p), self.center, degrees);
        p[self.plane.first()] = self.center[0] + a;
        p[self.plane.second()] = self.center[1] + b;
        p
    }

    fn vector(&self, to: [f64; 2], from: [f64; 2], degrees: f64) -> [f64; 2] {
        let (sin, cos) = sin_cos_degrees(degrees);
        let (a, b) = (to[0] - from[0], to[1] - from[1]);
        [a * cos - b * sin, a * sin + b * cos]
    }

    /// The rotated point.
    pub fn apply(&self, p: Position) -> Position {
        self.turned(p, self.degrees)
    }

    /// The point that is rotated to `p`.
    pub fn undo(&self, p: Position) -> Position {
        self.turned(p, -self.degrees)
    }

    /// The rotated vector.
    pub fn apply_vector(&self, v: [f64; 2]) -> [f64; 2] {
        self.vector(v, [0.0, 0.0], self.degrees)
    }
}

/// Sine and cosine of degrees, exact at the multiples of a right angle, so that a part turned by 90°
/// stays on its coordinates.
pub fn sin_cos_degrees(degrees: f64) -> (f64, f64) {
    if degrees % 90.0 == 0.0 {
        return match (degrees / 90.0).rem_euclid(4.0) as u8 {
            0 => (0.0, 1.0),
            1 => (1.0, 0.0),
            2 => (0.0, -1.0),
            _ => (-1.0, 0.0),
        };
    }
    (degrees % 360.0).to_radians().sin_cos()
}
