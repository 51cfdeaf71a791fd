//! Circular arcs and helices.
//!
//! With centre `c`, start angle `φ` and signed sweep `σ`, the point at parameter `t` in 0…1 is
//!
//! ```text
//! plane:  c + r(t)·(cos(φ + σt), sin(φ + σt)),   r(t) = r₀ + (r₁ − r₀)·t
//! others: start + (end − start)·t
//! ```
//!
//! `r₀` and `r₁` are the distances of start and end from the centre. They differ by what the control
//! tolerates (GSK990MC P214); the linear blend makes both ends exact, as controls of this class do.

use crate::plane::Plane;
use crate::position::Position;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Sense of rotation, seen from the positive end of the plane's normal.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Turn {
    /// G02.
    Clockwise,
    /// G03.
    CounterClockwise,
}

impl Turn {
    /// The other sense.
    pub fn reversed(self) -> Turn {
        match self {
            Turn::Clockwise => Turn::CounterClockwise,
            Turn::CounterClockwise => Turn::Clockwise,
        }
    }
}

/// Why no arc of the given radius joins two points.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum RadiusError {
    /// Start and end coincide: every circle of that radius through the point would do.
    SamePoint,
    /// The points lie further apart than the diameter; by how much, mm.
    TooFarApart(f64),
}

/// A circular arc or, where an axis outside the plane moves too, a helix.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Arc {
    /// Plane of the circle.
    pub plane: Plane,
    /// Centre on the plane's two axes.
    pub center: [f64; 2],
    /// Where it starts.
    pub start: Position,
    /// Where it ends.
    pub end: Position,
    /// Signed angle turned, radians; counter-clockwise positive; beyond ±2π for several turns.
    pub sweep: f64,
}

/// Angle from the start's direction to the end's below this is a full turn, not a vanishing arc:
/// 1 nrad is 1 nm on a radius of one metre, under the resolution of any control.
const FULL_TURN_RAD: f64 = 1e-9;

impl Arc {
    /// The arc about `center` from `start` to `end`. Start and end in the same direction give a full
    /// circle, as every control here defines it.
    pub fn about(plane: Plane, start: Position, end: Position, center: [f64; 2], turn: Turn) -> Arc {
        let [sa, sb] = plane.of(start);
        let [ea, eb] = plane.of(end);
        let (ua, ub) = (sa - center[0], sb - center[1]);
        let (va, vb) = (ea - center[0], eb - center[1]);
        // atan2 of cross and dot is accurate for small angles, where a difference of two atan2 is not.
        let angle = (ua * vb - ub * va).atan2(ua * va + ub * vb);
        let sweep = match turn {
            Turn::CounterClockwise if angle <= FULL_TURN_RAD => angle + TAU,
            Turn::Clockwise if angle >= -FULL_TURN_RAD => angle - TAU,
            _ => angle,
        };
        // A start and end that differ by rounding only turn once, not 2π plus that rounding.
        let sweep = if (sweep.abs() - TAU).abs() < FULL_TURN_RAD { TAU.copysign(sweep) } else { sweep };
        Arc { plane, center, start, end, sweep }
    }

    /// Centre of the arc with signed radius `r` (negative: the longer arc, above 180°) from `start`
    /// to `end`. `slack` is how far beyond the diameter the points may lie (they then become the
    /// ends of a diameter), mm.
    pub fn center_from_radius(
        start: [f64; 2],
        end: [f64; 2],
        r: f64,
        turn: Turn,
        slack: f64,
    ) -> Result<[f64; 2], RadiusError> {
        let (da, db) = (end[0] - start[0], end[1] - start[1]);
        let chord = da.hypot(db);
        if chord == 0.0 {
            return Err(RadiusError::SamePoint);
        }
        let gap = chord - 2.0 * r.abs();
        if gap > slack {
            return Err(RadiusError::TooFarApart(gap));
        }
        // (r − c/2)(r + c/2) keeps its digits where r² − (c/2)² would cancel.
        let half = chord / 2.0;
        let height = ((r.abs() - half).max(0.0) * (r.abs() + half)).sqrt();
        // Left of the chord for the shorter counter-clockwise arc.
        let left = (turn == Turn::CounterClockwise) == (r > 0.0);
        let h = if left { height } else { -height };
        Ok([start[0] + da / 2.0 - db / chord * h, start[1] + db / 2.0 + da / chord * h])
    }

    /// Distance of the start from the centre, mm.
    pub fn start_radius(&self) -> f64 {
        let [a, b] = self.plane.of(self.start);
        (a - self.center[0]).hypot(b - self.center[1])
    }

    /// Distance of the end from the centre, mm.
    pub fn end_radius(&self) -> f64 {
        let [a, b] = self.plane.of(self.end);
        (a - self.center[0]).hypot(b - self.center[1])
    }

    /// Direction of the start seen from the centre, radians.
    pub fn start_angle(&self) -> f64 {
        let [a, b] = self.plane.of(self.start);
        (b - self.center[1]).atan2(a - self.center[0])
    }

    /// The point at `t` in 0…1; both ends exact.
    pub fn at(&self, t: f64) -> Position {
        if t <= 0.0 {
            return self.start;
        }
        if t >= 1.0 {
            return self.end;
        }
        let mut p = self.start.lerp(self.end, t);
        let r = self.start_radius() + (self.end_radius() - self.start_radius()) * t;
        let (sin, cos) = (self.start_angle() + self.sweep * t).sin_cos();
        p[self.plane.first()] = self.center[0] + r * cos;
        p[self.plane.second()] = self.center[1] + r * sin;
        p
    }

    /// Length of the circle's part in its plane, mm: the mean radius times the angle turned.
    pub fn plane_length(&self) -> f64 {
        (self.start_radius() + self.end_radius()) / 2.0 * self.sweep.abs()
    }

    /// Length of the path over X, Y, Z (a helix climbs), mm.
    pub fn length(&self) -> f64 {
        let normal = self.plane.normal();
        self.plane_length().hypot(self.end[normal] - self.start[normal])
    }

    /// Smallest and largest coordinates reached, crossings of the quadrants included.
    pub fn extent(&self) -> (Position, Position) {
        let (mut min, mut max) = (self.start.min(self.end), self.start.max(self.end));
        let from = self.start_angle();
        let to = from + self.sweep;
        let (low, high) = if from <= to { (from, to) } else { (to, from) };
        // Four quadrant points make a turn: more cannot reach further, save by a radius that grows,
        // which only the last turn shows.
        let first = (low / FRAC_PI_2).ceil();
        let last = (high / FRAC_PI_2).floor();
        let mut quadrant = if last - first > 8.0 { last - 8.0 } else { first };
        while quadrant <= last {
            let p = self.at((quadrant * FRAC_PI_2 - from) / self.sweep);
            min = min.min(p);
            max = max.max(p);
            quadrant += 1.0;
        }
        (min, max)
    }
}
