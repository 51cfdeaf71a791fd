//! Lines and arcs in the plane.

use crate::vector::{Point, cross, distance, dot, sub};
use std::f64::consts::{FRAC_PI_2, TAU};

/// How a curve is bent.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Bend {
    /// Centre, mm.
    pub center: Point,
    /// Signed angle turned, radians, counter-clockwise positive; a whole turn for a circle, never more.
    pub sweep: f64,
}

/// A straight line or a circular arc.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Curve {
    /// Where it starts.
    pub from: Point,
    /// Where it ends.
    pub to: Point,
    /// The arc's centre and angle; `None` for a line.
    pub bend: Option<Bend>,
}

impl Curve {
    /// A straight line.
    pub fn line(from: Point, to: Point) -> Curve {
        Curve { from, to, bend: None }
    }

    /// The circle about `center` from `from` on, once round counter-clockwise.
    pub fn circle(center: Point, from: Point) -> Curve {
        Curve { from, to: from, bend: Some(Bend { center, sweep: TAU }) }
    }

    /// The arc that leaves `from` in the direction of the unit vector `along` and ends at `to`: a line
    /// where `to` lies straight ahead. The angle between tangent and chord is half the angle turned, so
    /// the arc is the only one.
    pub fn tangent(from: Point, along: Point, to: Point) -> Curve {
        let chord = sub(to, from);
        let (ahead, aside) = (dot(along, chord), cross(along, chord));
        // Below this the centre is further away than doubles can tell from infinity.
        if aside.abs() <= 1e-12 * ahead.abs() {
            return Curve::line(from, to);
        }
        let radius = dot(chord, chord) / (2.0 * aside);
        let center = [from[0] - along[1] * radius, from[1] + along[0] * radius];
        Curve { from, to, bend: Some(Bend { center, sweep: 2.0 * aside.atan2(ahead) }) }
    }

    /// Radius, mm; infinite for a line.
    pub fn radius(&self) -> f64 {
        self.bend.map_or(f64::INFINITY, |bend| distance(bend.center, self.from))
    }

    /// Length, mm.
    pub fn length(&self) -> f64 {
        match self.bend {
            None => distance(self.from, self.to),
            Some(bend) => distance(bend.center, self.from) * bend.sweep.abs(),
        }
    }

    /// Greatest distance between the arc and its chord, mm; the diameter for a circle.
    pub fn sagitta(&self) -> f64 {
        self.bend.map_or(0.0, |bend| {
            // r (1 − cos(s/2)) without cancellation.
            let quarter = (bend.sweep / 4.0).sin();
            2.0 * distance(bend.center, self.from) * quarter * quarter
        })
    }

    /// The same curve run backwards.
    pub fn reversed(&self) -> Curve {
        let bend = self.bend.map(|bend| Bend { sweep: -bend.sweep, ..bend });
        Curve { from: self.to, to: self.from, bend }
    }

    /// The point at `t` in 0…1, both ends exact.
    pub fn at(&self, t: f64) -> Point {
        let Some(bend) = self.bend else {
            return [
                self.from[0] + (self.to[0] - self.from[0]) * t,
                self.from[1] + (self.to[1] - self.from[1]) * t,
            ];
        };
        if t <= 0.0 || t >= 1.0 {
            return if t <= 0.0 { self.from } else { self.to };
        }
        let arm = sub(self.from, bend.center);
        let (sin, cos) = (bend.sweep * t).sin_cos();
        [bend.center[0] + arm[0] * cos - arm[1] * sin, bend.center[1] + arm[0] * sin + arm[1] * cos]
    }

    /// Smallest and largest coordinates reached.
    pub fn extent(&self) -> [Point; 2] {
        let mut low = [self.from[0].min(self.to[0]), self.from[1].min(self.to[1])];
        let mut high = [self.from[0].max(self.to[0]), self.from[1].max(self.to[1])];
        let Some(bend) = self.bend else { return [low, high] };
        let arm = sub(self.from, bend.center);
        let radius = arm[0].hypot(arm[1]);
        let start = arm[1].atan2(arm[0]);
        let (first, last) = (start.min(start + bend.sweep), start.max(start + bend.sweep));
        // A turn at most, so five quadrants at most.
        let mut quadrant = (first / FRAC_PI_2).ceil();
        for _ in 0..5 {
            if quadrant * FRAC_PI_2 > last {
                break;
            }
            match quadrant.rem_euclid(4.0) as u8 {
                0 => high[0] = high[0].max(bend.center[0] + radius),
                1 => high[1] = high[1].max(bend.center[1] + radius),
                2 => low[0] = low[0].min(bend.center[0] - radius),
                _ => low[1] = low[1].min(bend.center[1] - radius),
            }
            quadrant += 1.0;
        }
        [low, high]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    fn near(a: Point, b: Point) -> bool {
        distance(a, b) < 1e-12
    }

    #[test]
    fn a_quarter_circle() {
        let arc = Curve::tangent([10.0, 0.0], [0.0, 1.0], [0.0, 10.0]);
        let bend = arc.bend.unwrap();
        assert!(near(bend.center, [0.0, 0.0]) && (bend.sweep - FRAC_PI_2).abs() < 1e-12);
        assert!((arc.length() - 5.0 * PI).abs() < 1e-12 && (arc.radius() - 10.0).abs() < 1e-12);
        assert!((arc.sagitta() - 10.0 * (1.0 - 0.5f64.sqrt())).abs() < 1e-12);
        assert!(near(arc.at(0.5), [50f64.sqrt(), 50f64.sqrt()]));
        let back = arc.reversed();
        assert!(near(back.at(0.5), arc.at(0.5)) && back.from == arc.to);
    }

    #[test]
    fn extents_reach_the_quadrants() {
        let arc = Curve::tangent([-3.0, 4.0], [0.8, 0.6], [3.0, 4.0]);
        let [low, high] = arc.extent();
        assert!(near(low, [-3.0, 4.0]) && near(high, [3.0, 5.0]), "{low:?} {high:?}");
        let [low, high] = Curve::circle([1.0, 2.0], [3.0, 2.0]).extent();
        assert!(near(low, [-1.0, 0.0]) && near(high, [3.0, 4.0]));
    }
}
