//! Stage polar: G15 and G16 (GSK990MC 4.2.13, Kaitong appendix 9).
//!
//! The plane's first address is a radius, its second an angle. With G90 the pole is the work zero, with G91
//! the present point; an angle of G91 is added to the last one, or to that of where the tool is.

use crate::stages::rotation::sin_cos_degrees;
use ferrocut_geometry::Plane;

/// What sets the pole.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum PoleRule {
    /// Every radius does, by G90 or G91 of its block (GSK990MC 4.2.13).
    Radius,
    /// G16 does, until the next G16. Radius and angle of G91 are added to those of where the tool is; a radius is
    /// never negative, its sign is left aside (Kaitong appendix 9).
    Code,
}

/// Polar coordinates in force.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Polar {
    rule: PoleRule,
    pole: [f64; 2],
    radius: f64,
    degrees: f64,
    /// The point that radius and angle are of.
    at: [f64; 2],
}

impl Polar {
    /// G16 where the tool stands at `here` in the plane.
    pub fn new(rule: PoleRule, here: [f64; 2], incremental: bool) -> Polar {
        // A first block that names only one of the two takes the other from where the tool stands.
        let degrees = if here == [0.0, 0.0] { 0.0 } else { here[1].atan2(here[0]).to_degrees() };
        match (incremental, rule) {
            (false, _) => Polar { rule, pole: [0.0, 0.0], radius: here[0].hypot(here[1]), degrees, at: here },
            (true, PoleRule::Radius) => Polar { rule, pole: here, radius: 0.0, degrees: 0.0, at: here },
            // The present angle is that of the vector from the work zero (Kaitong appendix 9, 1.2).
            (true, PoleRule::Code) => Polar { rule, pole: here, radius: 0.0, degrees, at: here },
        }
    }

    /// The point in the plane that a block's radius (mm) and angle (degrees) make.
    pub fn point(
        &mut self,
        here: [f64; 2],
        radius: Option<f64>,
        angle: Option<f64>,
        incremental: bool,
    ) -> [f64; 2] {
        let mut present = (self.radius, self.degrees);
        // A move that was not polar came between.
        let (x, y) = (here[0] - self.pole[0], here[1] - self.pole[1]);
        if self.rule == PoleRule::Code && here != self.at {
            let degrees = if (x, y) == (0.0, 0.0) { self.degrees } else { y.atan2(x).to_degrees() };
            present = (x.hypot(y), degrees);
        }
        match (radius, self.rule) {
            (None, _) => {}
            (Some(radius), PoleRule::Radius) => {
                self.pole = if incremental { here } else { [0.0, 0.0] };
                self.radius = radius;
            }
            (Some(radius), PoleRule::Code) => {
                self.radius = if incremental { present.0 + radius } else { radius }.abs();
            }
        }
        if let Some(angle) = angle {
            self.degrees = if incremental { present.1 + angle } else { angle };
        }
        let (sin, cos) = sin_cos_degrees(self.degrees);
        self.at = [self.pole[0] + self.radius * cos, self.pole[1] + self.radius * sin];
        self.at
    }
}

/// The addresses of radius and angle in a plane.
pub fn addresses(plane: Plane) -> (u8, u8) {
    (plane.first().letter() as u8, plane.second().letter() as u8)
}
