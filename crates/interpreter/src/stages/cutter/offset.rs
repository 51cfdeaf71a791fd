//! One programmed block and its offset curve.
//!
//! With unit tangent `t` and left normal `n = (−t.y, t.x)`, the tool centre runs on `p + d·n`, where the
//! signed offset `d` is positive to the left (G41) and negative to the right (G42). The offset of a line is a
//! parallel line. On an arc turning in sense `s` (+1 counter-clockwise) the left normal points to the centre
//! for `s = +1` and away from it for `s = −1`; its offset is the concentric arc of radius
//!
//! ```text
//! ρ = R − s·d
//! ```
//!
//! which shrinks where the tool runs inside. `ρ = 0` puts the tool onto the centre (alarm 38), `ρ < 0`
//! means that the arc is smaller than the tool (alarm 41).

use super::{Fault, Offset, PlaneMove, Shape};
use ferrocut_geometry::SAME_POINT_MM;
use ferrocut_geometry::vector::{Point, along, angle, cross, distance, dot, finite, left, sub, unit};
use std::f64::consts::TAU;

/// An offset radius below this is none, mm: the least increment of the controls.
const LEAST_RADIUS_MM: f64 = 1e-3;

/// Circles and lines that miss each other by less touch, mm.
const TOUCH_MM: f64 = 1e-6;

/// An angle behind the start by less than this is rounding, not nearly a full turn, rad.
const BEHIND_RAD: f64 = 1e-6;

/// A programmed block with what the joining rules ask of it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Element {
    pub from: Point,
    pub to: Point,
    pub shape: Shape,
    /// +1 left of the path, −1 right of it.
    pub side: f64,
    /// Radius at the end of the block, mm, not negative. At its start that of the block before rules.
    pub radius: f64,
    /// Unit tangents at both ends.
    pub start: Point,
    pub end: Point,
}

/// Whether a block moves in the plane at all.
pub(super) fn is_zero(m: &PlaneMove) -> bool {
    is_within(m, SAME_POINT_MM)
}

/// Whether a block moves by no more than `least`, mm.
pub(super) fn is_within(m: &PlaneMove, least: f64) -> bool {
    let is_near = distance(m.from, m.to) <= least;
    match m.shape {
        Shape::Arc { center, sweep } if sweep != 0.0 => {
            is_near && distance(m.from, center) * sweep.abs() <= least
        }
        _ => is_near,
    }
}

/// Whether every number of a block is one.
pub(super) fn is_finite(m: &PlaneMove) -> bool {
    let shape = match m.shape {
        Shape::Line => true,
        Shape::Arc { center, sweep } => finite(center) && sweep.is_finite(),
    };
    shape && finite(m.from) && finite(m.to)
}

impl Element {
    /// # Errors
    /// [`Fault::ArcCenterOvercut`] for an arc that starts or ends on its centre, [`Fault::NoIntersection`] for a
    /// block that has no direction or an offset beyond all numbers.
    pub fn new(m: &PlaneMove, offset: Offset) -> Result<Element, Fault> {
        let (shape, start, end) = match m.shape {
            Shape::Arc { center, sweep } if sweep != 0.0 => {
                let tangent = |p: Point| {
                    unit(sub(p, center)).map(|u| left([u[0] * sweep.signum(), u[1] * sweep.signum()]))
                };
                match (tangent(m.from), tangent(m.to)) {
                    (Some(start), Some(end)) => (m.shape, start, end),
                    _ => return Err(Fault::ArcCenterOvercut),
                }
            }
            _ => {
                let t = unit(sub(m.to, m.from)).ok_or(Fault::NoIntersection)?;
                (Shape::Line, t, t)
            }
        };
        let (side, radius) = (offset.signed().signum(), offset.radius.abs());
        let element = Element { from: m.from, to: m.to, shape, side, radius, start, end };
        let fine = finite(element.end_tip(radius)) && element.length().is_finite();
        if fine { Ok(element) } else { Err(Fault::NoIntersection) }
    }

    pub fn is_arc(&self) -> bool {
        matches!(self.shape, Shape::Arc { .. })
    }

    /// Length of the programmed path, mm.
    pub fn length(&self) -> f64 {
        match self.shape {
            Shape::Line => distance(self.from, self.to),
            Shape::Arc { center, sweep } => distance(self.to, center) * sweep.abs(),
        }
    }

    /// Signed curvature, 1/mm, positive to the left.
    pub fn curvature(&self) -> f64 {
        match self.shape {
            Shape::Line => 0.0,
            Shape::Arc { center, sweep } => sweep.signum() / distance(self.to, center),
        }
    }

    /// Tool centre square to the start, on this block's side at distance `r`.
    pub fn start_tip(&self, r: f64) -> Point {
        along(self.from, left(self.start), self.side * r)
    }

    /// Tool centre square to the end.
    pub fn end_tip(&self, r: f64) -> Point {
        along(self.to, left(self.end), self.side * r)
    }

    /// The offset curve near the start, at distance `r`.
    pub fn start_track(&self, r: f64) -> Track {
        self.track(self.from, self.start, r)
    }

    /// The offset curve near the end.
    pub fn end_track(&self, r: f64) -> Track {
        self.track(self.to, self.end, r)
    }

    /// Start and end of an arc may lie on slightly different radii (GSK990MC P214): each end has its own.
    fn track(&self, at: Point, tangent: Point, r: f64) -> Track {
        let tip = along(at, left(tangent), self.side * r);
        match self.shape {
            Shape::Line => Track { tip, kind: Kind::Line(tangent) },
            Shape::Arc { center, sweep } => {
                let sense = sweep.signum();
                let rho = distance(at, center) - sense * self.side * r;
                Track { tip, kind: Kind::Circle { center, rho, sense } }
            }
        }
    }

    /// Whether the tool fits into the arc: 38 where its centre would stand on the arc's, 41 beyond.
    pub fn fits(&self, start_radius: f64, interference: bool) -> Result<(), Fault> {
        for track in [self.start_track(start_radius), self.end_track(self.radius)] {
            if let Kind::Circle { rho, .. } = track.kind {
                if rho.abs() < LEAST_RADIUS_MM {
                    return Err(Fault::ArcCenterOvercut);
                }
                if rho < 0.0 && interference {
                    return Err(Fault::Interference);
                }
            }
        }
        Ok(())
    }
}

/// An offset curve without ends, and the point of it that belongs to the programmed corner.
#[derive(Clone, Copy, Debug)]
pub(super) struct Track {
    pub tip: Point,
    pub kind: Kind,
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Kind {
    /// Unit tangent.
    Line(Point),
    Circle {
        center: Point,
        rho: f64,
        sense: f64,
    },
}

impl Track {
    /// Whether the curve exists: circles that the tool does not fit into have none.
    pub fn exists(&self) -> bool {
        match self.kind {
            Kind::Line(_) => true,
            Kind::Circle { rho, .. } => rho > 0.0,
        }
    }

    /// How far `p` lies beyond the tip in the direction of travel: (mm, rad). A circle is closed: what lies a
    /// little behind lies nearly a turn ahead, so the answer is 0…2π there.
    pub fn ahead(&self, p: Point) -> (f64, f64) {
        match self.kind {
            Kind::Line(t) => (dot(sub(p, self.tip), t), 0.0),
            Kind::Circle { center, rho, sense } => {
                let a = sense * angle(sub(self.tip, center), sub(p, center));
                let a = if a < -BEHIND_RAD { a + TAU } else { a };
                (a * rho, a)
            }
        }
    }

    /// How far `p` lies before the tip, likewise.
    pub fn behind(&self, p: Point) -> (f64, f64) {
        let (mm, rad) = self.reversed().ahead(p);
        (mm, rad)
    }

    fn reversed(&self) -> Track {
        let kind = match self.kind {
            Kind::Line(t) => Kind::Line([-t[0], -t[1]]),
            Kind::Circle { center, rho, sense } => Kind::Circle { center, rho, sense: -sense },
        };
        Track { tip: self.tip, kind }
    }

    /// The crossings of two tracks: none, or two that may coincide.
    pub fn crossings(&self, other: &Track) -> Option<[Point; 2]> {
        match (self.kind, other.kind) {
            (Kind::Line(a), Kind::Line(b)) => {
                let sine = cross(a, b);
                let k = cross(sub(other.tip, self.tip), b) / sine;
                let p = along(self.tip, a, k);
                finite(p).then_some([p, p])
            }
            (Kind::Line(t), Kind::Circle { center, rho, .. }) => line_circle(self.tip, t, center, rho),
            (Kind::Circle { center, rho, .. }, Kind::Line(t)) => line_circle(other.tip, t, center, rho),
            (Kind::Circle { center: a, rho: ra, .. }, Kind::Circle { center: b, rho: rb, .. }) => {
                circle_circle(a, ra, b, rb)
            }
        }
    }
}

/// The foot of the centre on the line, and half the chord to either side: `h² = ρ² − e²`.
fn line_circle(p: Point, t: Point, center: Point, rho: f64) -> Option<[Point; 2]> {
    let foot = along(p, t, dot(sub(center, p), t));
    let h = half_chord(rho, cross(t, sub(center, p)).abs())?;
    Some([along(foot, t, h), along(foot, t, -h)])
}

/// The radical line cuts the line of centres at `a = (e² + ρa² − ρb²) / 2e` from the first centre.
fn circle_circle(a: Point, ra: f64, b: Point, rb: f64) -> Option<[Point; 2]> {
    let e = distance(a, b);
    let u = unit(sub(b, a))?;
    let m = (e + (ra - rb) * (ra + rb) / e) / 2.0;
    if !m.is_finite() {
        return None;
    }
    // Circles that miss by a hair touch on the line of centres.
    let gap = (e - ra - rb).max((ra - rb).abs() - e);
    let h = if gap > TOUCH_MM {
        return None;
    } else if m.abs() >= ra {
        0.0
    } else {
        half_chord(ra, m.abs())?
    };
    let foot = along(a, u, m.clamp(-ra, ra));
    Some([along(foot, left(u), h), along(foot, left(u), -h)])
}

/// `√(ρ² − e²)`, keeping its digits; none where the distance `e` exceeds the radius by more than a touch.
fn half_chord(rho: f64, e: f64) -> Option<f64> {
    (e - rho <= TOUCH_MM).then(|| ((rho - e).max(0.0) * (rho + e)).sqrt()).filter(|h| h.is_finite())
}
