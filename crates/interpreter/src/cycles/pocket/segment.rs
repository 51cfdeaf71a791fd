//! A straight piece or an arc: what profiles and tool paths are made of.
//!
//! A point of a segment is named by its parameter t, 0 at the start and 1 at the end. With centre c,
//! start a and signed sweep σ an arc is
//!
//! ```text
//! p(t) = c + R(σt)·(a − c),     0 < |σ| ≤ 2π,     R: rotation
//! ```
//!
//! An arc between two points is fixed by its sweep alone: the centre lies on the left of the chord at the
//! distance (chord/2)/tan(σ/2).

use ferrocut_geometry::vector::{add, along, angle, cross, distance, dot, left, length, sub, turned, unit};
use std::f64::consts::{PI, TAU};

/// A straight piece or an arc of the plane, mm.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Segment {
    /// Straight.
    Line {
        /// Where it starts.
        from: [f64; 2],
        /// Where it ends.
        to: [f64; 2],
    },
    /// Circular. A full circle ends where it starts and sweeps ±2π.
    Arc {
        /// Where it starts.
        from: [f64; 2],
        /// Where it ends.
        to: [f64; 2],
        /// Centre.
        center: [f64; 2],
        /// Angle turned, radians, counter-clockwise positive, at most one turn.
        sweep: f64,
    },
}

/// Edges of a box along the axes.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Bounds {
    pub low: [f64; 2],
    pub high: [f64; 2],
}

impl Bounds {
    pub const NONE: Bounds = Bounds { low: [f64::INFINITY; 2], high: [f64::NEG_INFINITY; 2] };

    pub fn take(&mut self, p: [f64; 2]) {
        for (k, c) in p.into_iter().enumerate() {
            self.low[k] = self.low[k].min(c);
            self.high[k] = self.high[k].max(c);
        }
    }

    pub fn grown(self, by: f64) -> Bounds {
        Bounds { low: self.low.map(|c| c - by), high: self.high.map(|c| c + by) }
    }

    /// The shorter side.
    pub fn width(&self) -> f64 {
        (self.high[0] - self.low[0]).min(self.high[1] - self.low[1])
    }
}

impl Segment {
    /// The arc between two different points that turns by `sweep`.
    pub fn arc(from: [f64; 2], to: [f64; 2], sweep: f64) -> Segment {
        let chord = sub(to, from);
        let center = along(along(from, chord, 0.5), left(chord), 0.5 / (sweep / 2.0).tan());
        Segment::Arc { from, to, center, sweep }
    }

    /// The full circle about `center` from a point of it.
    pub fn circle(from: [f64; 2], center: [f64; 2], sense: f64) -> Segment {
        Segment::Arc { from, to: from, center, sweep: TAU.copysign(sense) }
    }

    /// Where it starts.
    pub fn from(&self) -> [f64; 2] {
        match *self {
            Segment::Line { from, .. } | Segment::Arc { from, .. } => from,
        }
    }

    /// Where it ends.
    pub fn to(&self) -> [f64; 2] {
        match *self {
            Segment::Line { to, .. } | Segment::Arc { to, .. } => to,
        }
    }

    /// Its length, mm.
    pub fn length(&self) -> f64 {
        match *self {
            Segment::Line { from, to } => distance(from, to),
            Segment::Arc { from, center, sweep, .. } => distance(from, center) * sweep.abs(),
        }
    }

    /// The point at the parameter `t`.
    pub fn point(&self, t: f64) -> [f64; 2] {
        match *self {
            _ if t <= 0.0 => self.from(),
            _ if t >= 1.0 => self.to(),
            Segment::Line { from, to } => along(from, sub(to, from), t),
            Segment::Arc { from, center, sweep, .. } => add(center, turned(sub(from, center), sweep * t)),
        }
    }

    /// Direction of travel at the parameter `t`.
    pub fn direction(&self, t: f64) -> [f64; 2] {
        let v = match *self {
            Segment::Line { from, to } => sub(to, from),
            Segment::Arc { center, sweep, .. } => {
                let outward = left(sub(self.point(t), center));
                [outward[0] * sweep.signum(), outward[1] * sweep.signum()]
            }
        };
        unit(v).unwrap_or([1.0, 0.0])
    }

    /// The piece between two parameters.
    pub fn part(&self, t0: f64, t1: f64) -> Segment {
        let (from, to) = (self.point(t0), self.point(t1));
        match *self {
            Segment::Line { .. } => Segment::Line { from, to },
            Segment::Arc { center, sweep, .. } => {
                Segment::Arc { from, to, center, sweep: sweep * (t1.min(1.0) - t0.max(0.0)) }
            }
        }
    }

    /// The same piece travelled the other way.
    pub fn reversed(&self) -> Segment {
        match *self {
            Segment::Line { from, to } => Segment::Line { from: to, to: from },
            Segment::Arc { from, to, center, sweep } => {
                Segment::Arc { from: to, to: from, center, sweep: -sweep }
            }
        }
    }

    /// The parameter of the point nearest to `p`.
    pub fn nearest(&self, p: [f64; 2]) -> f64 {
        match *self {
            Segment::Line { from, to } => {
                let d = sub(to, from);
                let square = dot(d, d);
                if square > 0.0 { (dot(sub(p, from), d) / square).clamp(0.0, 1.0) } else { 0.0 }
            }
            Segment::Arc { from, to, center, .. } => match self.turned_to(p) {
                Some(t) => t,
                None if distance(p, from) <= distance(p, to) || distance(p, center) == 0.0 => 0.0,
                None => 1.0,
            },
        }
    }

    /// The point nearest to `p`.
    pub fn foot(&self, p: [f64; 2]) -> [f64; 2] {
        match *self {
            Segment::Line { from, to } => {
                let d = sub(to, from);
                let (t, square) = (dot(sub(p, from), d), dot(d, d));
                match () {
                    () if t <= 0.0 || square <= 0.0 => from,
                    () if t >= square => to,
                    () => along(from, d, t / square),
                }
            }
            Segment::Arc { from, to, center, .. } => {
                let out = sub(p, center);
                let far = length(out);
                if far > 0.0 && self.spans(out) {
                    along(center, out, distance(from, center) / far)
                } else if distance(p, from) <= distance(p, to) {
                    from
                } else {
                    to
                }
            }
        }
    }

    /// Distance of a point, mm.
    pub fn distance(&self, p: [f64; 2]) -> f64 {
        match *self {
            Segment::Arc { from, center, .. } if self.spans(sub(p, center)) => {
                (distance(p, center) - distance(from, center)).abs()
            }
            _ => distance(p, self.foot(p)),
        }
    }

    /// Whether a direction from the centre leads to the arc.
    fn spans(&self, v: [f64; 2]) -> bool {
        let Segment::Arc { from, to, center, sweep } = *self else { return false };
        let (a, b, sense) = (sub(from, center), sub(to, center), sweep.signum());
        if sweep.abs() <= PI {
            cross(a, v) * sense >= 0.0 && cross(v, b) * sense >= 0.0 && dot(add(a, b), v) >= -dot(a, a) * 1e-9
        } else {
            // Not in the gap.
            from == to || !(cross(b, v) * sense > 0.0 && cross(v, a) * sense > 0.0)
        }
    }

    /// Parameter at which an arc points from its centre to `p`; `None` beyond its ends.
    pub fn turned_to(&self, p: [f64; 2]) -> Option<f64> {
        let Segment::Arc { from, center, sweep, .. } = *self else { return None };
        let mut turn = angle(sub(from, center), sub(p, center)) * sweep.signum();
        if turn < 0.0 {
            turn += TAU;
        }
        let t = turn / sweep.abs();
        // Just before the start is the start, not nearly a turn later.
        if t <= 1.0 {
            Some(t)
        } else if TAU - turn < 1e-12 {
            Some(0.0)
        } else {
            None
        }
    }

    /// The box around it.
    pub(crate) fn bounds(&self) -> Bounds {
        let mut bounds = Bounds::NONE;
        bounds.take(self.from());
        bounds.take(self.to());
        if let Segment::Arc { from, center, .. } = *self {
            let radius = distance(from, center);
            for d in [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]] {
                let p = along(center, d, radius);
                if self.turned_to(p).is_some() {
                    bounds.take(p);
                }
            }
        }
        bounds
    }

    /// Twice the area between it and the origin, counter-clockwise positive.
    pub(crate) fn double_area(&self) -> f64 {
        match *self {
            Segment::Line { from, to } => cross(from, to),
            Segment::Arc { from, to, center, sweep } => {
                let radius = distance(from, center);
                cross(from, to) + radius * radius * (sweep - sweep.sin())
            }
        }
    }

    /// The angle under which it is seen from `p`, signed; for points not on it.
    pub(crate) fn seen_from(&self, p: [f64; 2]) -> f64 {
        let chord = |a: [f64; 2], b: [f64; 2]| angle(sub(a, p), sub(b, p));
        match *self {
            Segment::Line { from, to } => chord(from, to),
            Segment::Arc { center, sweep, .. } => {
                let pieces = (sweep.abs() / (PI / 2.0)).ceil().max(1.0);
                let mut sum = 0.0;
                for k in 0..pieces as u32 {
                    let (a, b) =
                        (self.point(f64::from(k) / pieces), self.point((f64::from(k) + 1.0) / pieces));
                    let seen = chord(a, b);
                    sum += seen;
                    // Between chord and arc, or on the chord, the arc passes on the other side.
                    if seen * sweep < 0.0 && distance(p, center) < distance(a, center) {
                        sum += TAU.copysign(sweep);
                    }
                }
                sum
            }
        }
    }

    /// Whether all its numbers are finite.
    pub(crate) fn is_finite(&self) -> bool {
        let pair = |p: [f64; 2]| length(p).is_finite();
        match *self {
            Segment::Line { from, to } => pair(from) && pair(to),
            Segment::Arc { from, to, center, sweep } => {
                pair(from) && pair(to) && pair(center) && sweep.is_finite()
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_inside_arcs() {
        // A half disc, radius 2 about the origin, above the x axis.
        let half =
            [Segment::arc([2.0, 0.0], [-2.0, 0.0], PI), Segment::Line { from: [-2.0, 0.0], to: [2.0, 0.0] }];
        let turns = |p: [f64; 2]| (half.iter().map(|s| s.seen_from(p)).sum::<f64>() / TAU).round();
        for (p, inside) in [([0.0, 1.0], 1.0), ([1.2, 1.2], 1.0), ([1.5, 1.5], 0.0), ([0.0, -1.0], 0.0)] {
            assert_eq!(turns(p), inside, "{p:?}");
        }
        // On the chord of an arc that turns away from it.
        let bay = [
            Segment::Line { from: [-2.0, -3.0], to: [2.0, -3.0] },
            Segment::Line { from: [2.0, -3.0], to: [2.0, 0.0] },
            Segment::arc([2.0, 0.0], [-2.0, 0.0], -PI),
            Segment::Line { from: [-2.0, 0.0], to: [-2.0, -3.0] },
        ];
        let turns = |p: [f64; 2]| (bay.iter().map(|s| s.seen_from(p)).sum::<f64>() / TAU).round();
        for (p, inside) in [([1.0, 0.0], 0.0), ([0.0, 0.0], 0.0), ([0.0, -2.5], 1.0), ([1.9, -1.5], 1.0)] {
            assert_eq!(turns(p), inside, "{p:?}");
        }
    }

    #[test]
    fn areas_and_lengths() {
        let arc = Segment::arc([2.0, 0.0], [0.0, 2.0], PI / 2.0);
        assert!((arc.length() - PI).abs() < 1e-12);
        assert!((arc.double_area() - 2.0 * PI).abs() < 1e-12);
        let bounds = arc.bounds();
        assert!(
            bounds.low.iter().all(|c| c.abs() < 1e-12) && bounds.high.iter().all(|c| (c - 2.0).abs() < 1e-12)
        );
        assert_eq!(arc.nearest([5.0, -1.0]), 0.0);
        assert!((arc.distance([3.0, 3.0]) - (18f64.sqrt() - 2.0)).abs() < 1e-12);
    }
}
