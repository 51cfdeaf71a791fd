//! Ellipses and their arcs, in any place in space; seen from above they become lines and arcs.
//!
//! `P(t) = center + u cos t + v sin t`: two conjugate radii describe an ellipse in a form that any
//! placing keeps (each of the three vectors is placed by itself), and a circle is the case of equal and
//! square radii.
//!
//! # Points close enough
//!
//! Between two parameters that are `h` apart, `P` leaves the straight line from one to the other by
//! `h²/8 · max |P″|` at most (the error of linear interpolation), and `|P″(t)| = |u cos t + v sin t|` is
//! at most the half major axis `a`. So `h = √(8 c / a)` keeps the chords within `c`.

use crate::affine::{Affine, Vector};
use crate::curve::{Bend, Curve};
use crate::fit::{self, Sample};
use crate::limits::{Limits, Refused};
use ferrocut_geometry::vector::{Point, cross, dot};
use std::f64::consts::TAU;

/// A part of an ellipse, or all of it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Ellipse {
    /// Middle.
    pub center: Vector,
    /// Radius at parameter 0.
    pub u: Vector,
    /// Radius at a quarter turn.
    pub v: Vector,
    /// Parameter at the start, radians.
    pub from: f64,
    /// Signed parameter run through, radians, a turn at most.
    pub sweep: f64,
}

/// An ellipse whose half axes differ by no more than this is a circle, mm: a nanometre.
const ROUND: f64 = 1e-6;

/// Arcs of circles up to this radius are known to a hundredth of a micrometre, mm. Only what is cut of them has to be within reach.
const LARGEST_CIRCLE: f64 = 1e8;

/// The share of the tolerance that is given to the chords; the rest is left to the arcs.
const CHORD_SHARE: f64 = 0.125;

impl Ellipse {
    /// The ellipse in another place.
    pub fn placed(&self, by: &Affine) -> Ellipse {
        let (center, u, v) = (by.point(self.center), by.vector(self.u), by.vector(self.v));
        Ellipse { center, u, v, ..*self }
    }

    /// Seen from above: lines and arcs within `tolerance` of it.
    pub fn curves(&self, tolerance: f64, limits: &mut Limits, out: &mut Vec<Curve>) -> Result<(), Refused> {
        let flat = |v: Vector| [v[0], v[1]];
        let (center, u, v) = (flat(self.center), flat(self.u), flat(self.v));
        let at = |t: f64| {
            let (sin, cos) = t.sin_cos();
            [center[0] + u[0] * cos + v[0] * sin, center[1] + u[1] * cos + v[1] * sin]
        };
        // The half axes: their squares add up to those of the radii, their product is the area between.
        let (squares, area) = (dot(u, u) + dot(v, v), cross(u, v));
        let sum = (squares + 2.0 * area.abs()).max(0.0).sqrt();
        let difference = (squares - 2.0 * area.abs()).max(0.0).sqrt();
        let is_whole = (self.sweep.abs() - TAU).abs() < 1e-9;
        // Squares of large radii cancel to rounding errors of their own.
        if difference <= ROUND.max(sum * 1e-7) && sum > 0.0 && sum <= 2.0 * LARGEST_CIRCLE {
            let sweep = if area < 0.0 { -self.sweep } else { self.sweep };
            let from = at(self.from);
            if is_whole {
                let whole = Bend { center, sweep: TAU.copysign(sweep) };
                out.push(Curve { from, to: from, bend: Some(whole) });
            } else {
                out.push(Curve { from, to: at(self.from + self.sweep), bend: Some(Bend { center, sweep }) });
            }
            return Ok(());
        }
        for radius in [u, v] {
            limits.reach(radius)?;
        }
        limits.reach(center)?;
        let major = (sum + difference) / 2.0;
        let chord = tolerance * CHORD_SHARE;
        let step = (8.0 * chord / major.max(chord)).sqrt();
        // At least eight a turn, so that directions between two samples stay apart by less than half a
        // turn.
        let count = (self.sweep.abs() / step).ceil().max((self.sweep.abs() / (TAU / 8.0)).ceil()).max(1.0);
        let count = limits.points(count)?;
        let samples: Vec<Sample> = (0..=count)
            .map(|i| {
                // A whole turn ends where it began, to the last digit.
                let i = if is_whole && i == count { 0 } else { i };
                let t = self.from + self.sweep * i as f64 / count as f64;
                let (sin, cos) = t.sin_cos();
                let along = [v[0] * cos - u[0] * sin, v[1] * cos - u[1] * sin];
                let length = along[0].hypot(along[1]) * self.sweep.signum();
                let along = if length == 0.0 { [0.0; 2] } else { along.map(|c| c / length) };
                Sample { at: at(t), along }
            })
            .collect();
        fit::fit(&samples, tolerance - chord, out);
        Ok(())
    }

    /// The circular arc from `from` to `to`, both with the height of `from`, whose bulge (DXF: the
    /// tangent of a quarter of the angle turned, counter-clockwise positive) is given.
    pub fn bulged(from: Vector, to: Vector, bulge: f64) -> Ellipse {
        let chord: Point = [to[0] - from[0], to[1] - from[1]];
        // From the middle of the chord to the centre, in chords to the left.
        let aside = (1.0 - bulge * bulge) / (4.0 * bulge);
        let center = [
            from[0] + chord[0] / 2.0 - chord[1] * aside,
            from[1] + chord[1] / 2.0 + chord[0] * aside,
            from[2],
        ];
        let u = [from[0] - center[0], from[1] - center[1], 0.0];
        Ellipse { center, u, v: [-u[1], u[0], 0.0], from: 0.0, sweep: 4.0 * bulge.atan() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, PI};

    fn curves(ellipse: &Ellipse, tolerance: f64) -> Vec<Curve> {
        let mut out = Vec::new();
        ellipse.curves(tolerance, &mut Limits::new(), &mut out).unwrap();
        out
    }

    #[test]
    fn a_circle_stays_one_whichever_way_it_is_looked_at() {
        let circle = Ellipse {
            center: [1.0, 2.0, 3.0],
            u: [5.0, 0.0, 0.0],
            v: [0.0, 5.0, 0.0],
            from: 0.0,
            sweep: TAU,
        };
        let turned = Affine::turn(30.0).after(&Affine::scale([-1.0, 1.0, 1.0]));
        let [curve] = curves(&circle.placed(&turned), 0.01)[..] else { panic!("one circle") };
        assert_eq!(curve.from, curve.to);
        assert!((curve.radius() - 5.0).abs() < 1e-12);
        assert_eq!(curve.bend.unwrap().sweep, -TAU, "a mirror turns the sense round");
    }

    #[test]
    fn bulges_are_tangents_of_quarter_angles() {
        // A half circle to the right of the way from (0,0) to (10,0), counter-clockwise: through (5,-5).
        let [half] = curves(&Ellipse::bulged([0.0; 3], [10.0, 0.0, 0.0], 1.0), 0.01)[..] else { panic!() };
        let middle = half.at(0.5);
        assert!((middle[0] - 5.0).abs() < 1e-12 && (middle[1] + 5.0).abs() < 1e-12, "{middle:?}");
        // A quarter clockwise, bulge -tan 22.5°.
        let bulge = -(PI / 8.0).tan();
        let [quarter] = curves(&Ellipse::bulged([0.0; 3], [10.0, 10.0, 0.0], bulge), 0.01)[..] else {
            panic!()
        };
        let bend = quarter.bend.unwrap();
        assert!((bend.sweep + FRAC_PI_2).abs() < 1e-12);
        assert!((bend.center[0] - 10.0).abs() < 1e-12 && bend.center[1].abs() < 1e-12, "{bend:?}");
    }

    #[test]
    fn an_ellipse_needs_few_arcs() {
        let ellipse =
            Ellipse { center: [0.0; 3], u: [40.0, 0.0, 0.0], v: [0.0, 20.0, 0.0], from: 0.0, sweep: TAU };
        let arcs = curves(&ellipse, 0.01);
        assert!(arcs.iter().all(|c| c.bend.is_some()) && arcs.len() <= 40, "{} arcs", arcs.len());
        assert_eq!(arcs.first().unwrap().from, arcs.last().unwrap().to);
        let lengths: f64 = arcs.iter().map(Curve::length).sum();
        // Ramanujan's formula, good to 1e-7 here.
        let h = (20.0f64 / 60.0).powi(2);
        let length = PI * 60.0 * (1.0 + 3.0 * h / (10.0 + (4.0 - 3.0 * h).sqrt()));
        assert!((lengths - length).abs() < 0.01, "{lengths} {length}");
    }
}
