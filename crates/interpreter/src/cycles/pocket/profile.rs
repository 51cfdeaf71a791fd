//! A closed profile: the outer wall of a pocket or the wall of an island.

use super::index::{envelope, index};
use super::meet::{closest, crossings};
use super::problem::Problem;
use super::segment::{Bounds, Segment};
use ferrocut_geometry::vector::{distance, dot};
use std::f64::consts::TAU;

/// A closed chain of lines and arcs, in the direction in which it was defined.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Profile {
    /// The elements, each from where the last one ended.
    pub segments: Vec<Segment>,
}

/// Ends this near to each other are joined, mm: the finest step in which the control shows and takes
/// coordinates. Anything wider is a gap.
const JOINED: f64 = 0.001;

/// How far the centre of an arc may lie from where its ends and sweep put it, mm; half the ends' own
/// rounding at a flat arc of a large radius makes this much.
const CENTER: f64 = 0.01;

/// Elements nearer to each other than this touch, mm. The paths on the two sides of a web this thin could
/// not be told apart.
const TOUCHES: f64 = 1e-4;

impl Profile {
    /// The chain made exact: ends joined, centres where the ends put them, nothing of no length.
    ///
    /// A profile must be closed and simple (Fagor 4.16: all contours closed, none crossing another).
    pub fn checked(&self) -> Result<Profile, Problem> {
        let finite = |s: &Segment| s.is_finite() && s.bounds().low.iter().all(|c| c.abs() < 1e6);
        if !self.segments.iter().all(finite) {
            return Err(Problem::OutOfRange);
        }
        let (Some(first), Some(last)) = (self.segments.first(), self.segments.last()) else {
            return Err(Problem::ProfileEmpty);
        };
        if distance(first.from(), last.to()) > JOINED {
            return Err(Problem::ProfileOpen);
        }
        let start = first.from();
        // Where the exact chain has come to, and where the drawn one has.
        let (mut at, mut drawn) = (start, start);
        let mut segments: Vec<Segment> = Vec::with_capacity(self.segments.len());
        for (n, segment) in self.segments.iter().enumerate() {
            if distance(drawn, segment.from()) > JOINED {
                return Err(Problem::ProfileOpen);
            }
            drawn = segment.to();
            let is_last = n + 1 == self.segments.len();
            let to = if is_last { start } else { segment.to() };
            match *segment {
                Segment::Line { .. } => {
                    if distance(at, to) <= JOINED {
                        if is_last {
                            close(&mut segments, start);
                        }
                        continue;
                    }
                    segments.push(Segment::Line { from: at, to });
                }
                Segment::Arc { center, sweep, .. } => segments.push(exact(at, to, center, sweep)?),
            }
            at = to;
        }
        let profile = Profile { segments };
        if profile.segments.is_empty() || profile.area().abs() < JOINED * JOINED {
            return Err(Problem::ProfileEmpty);
        }
        if profile.crosses_itself() {
            return Err(Problem::ProfileCrossesItself);
        }
        Ok(profile)
    }

    /// Area, mm², positive where it was defined counter-clockwise.
    pub fn area(&self) -> f64 {
        self.segments.iter().map(Segment::double_area).sum::<f64>() / 2.0
    }

    /// The same profile travelled the other way.
    pub fn reversed(&self) -> Profile {
        Profile { segments: self.segments.iter().rev().map(Segment::reversed).collect() }
    }

    /// Whether a point that is not on it lies inside: the profile turns about it.
    pub fn contains(&self, p: [f64; 2]) -> bool {
        encloses(&self.segments, p)
    }

    pub(crate) fn bounds(&self) -> Bounds {
        let mut bounds = Bounds::NONE;
        for segment in &self.segments {
            let own = segment.bounds();
            bounds.take(own.low);
            bounds.take(own.high);
        }
        bounds
    }

    /// Whether two profiles come nearer than paths can tell apart.
    pub(crate) fn touches(&self, other: &Profile) -> bool {
        let tree = index(&other.segments);
        self.segments.iter().any(|a| {
            tree.locate_in_envelope_intersecting(envelope(a.bounds().grown(TOUCHES)))
                .any(|b| closest(a, &b.segment).0 < TOUCHES)
        })
    }

    fn crosses_itself(&self) -> bool {
        let count = self.segments.len();
        let tree = index(&self.segments);
        self.segments.iter().enumerate().any(|(n, a)| {
            tree.locate_in_envelope_intersecting(envelope(a.bounds().grown(TOUCHES))).any(|other| {
                let (m, b) = (other.number, &other.segment);
                if m <= n {
                    return false;
                }
                match (m == n + 1, n == 0 && m + 1 == count) {
                    (false, false) => closest(a, b).0 < TOUCHES,
                    // Two elements in all meet at both ends.
                    (next, last) => neighbours_cross(a, b, next, last),
                }
            })
        })
    }
}

/// Whether neighbours meet elsewhere than at their joint: `b` after `a`, or round the start before it.
fn neighbours_cross(a: &Segment, b: &Segment, next: bool, last: bool) -> bool {
    let joint =
        |p: [f64; 2]| (next && distance(p, a.to()) < TOUCHES) || (last && distance(p, a.from()) < TOUCHES);
    let turns_back = |before: &Segment, after: &Segment| {
        // Back along itself, and not only along a tangent.
        dot(before.direction(1.0), after.direction(0.0)) < -1.0 + 1e-9 && {
            let reach = 0.5 * before.length().min(after.length());
            let p = after.point(reach / after.length());
            before.distance(p) < TOUCHES.min(reach * 1e-3)
        }
    };
    crossings(a, b).into_iter().any(|p| !joint(p))
        || (next && turns_back(a, b))
        || (last && turns_back(b, a))
        || (!(next && last) && far_ends_touch(a, b, next))
}

fn far_ends_touch(a: &Segment, b: &Segment, next: bool) -> bool {
    let (free_a, free_b) = if next { (a.from(), b.to()) } else { (a.to(), b.from()) };
    // Full circles have no free end.
    distance(a.from(), a.to()) > TOUCHES
        && distance(b.from(), b.to()) > TOUCHES
        && (b.distance(free_a) < TOUCHES || a.distance(free_b) < TOUCHES)
}

/// Whether a closed chain turns about a point.
pub(crate) fn encloses(segments: &[Segment], p: [f64; 2]) -> bool {
    let turns: f64 = segments.iter().map(|s| s.seen_from(p)).sum::<f64>() / TAU;
    turns.round() != 0.0
}

/// Moves the end of the chain onto its start.
fn close(segments: &mut [Segment], start: [f64; 2]) {
    if let Some(last) = segments.last_mut() {
        *last = match *last {
            Segment::Line { from, .. } => Segment::Line { from, to: start },
            Segment::Arc { from, sweep, .. } => Segment::arc(from, start, sweep),
        };
    }
}

/// The arc with its centre where the ends and the sweep put it.
fn exact(from: [f64; 2], to: [f64; 2], center: [f64; 2], sweep: f64) -> Result<Segment, Problem> {
    if sweep == 0.0 || sweep.abs() > TAU + 1e-9 {
        return Err(Problem::ArcEnds);
    }
    if distance(from, to) <= JOINED && sweep.abs() > 6.0 {
        if distance(from, center) <= JOINED {
            return Err(Problem::ProfileEmpty);
        }
        return Ok(Segment::circle(from, center, sweep));
    }
    let arc = Segment::arc(from, to, sweep);
    match arc {
        Segment::Arc { center: exact, .. } if distance(exact, center) <= CENTER && arc.length() > JOINED => {
            Ok(arc)
        }
        _ => Err(Problem::ArcEnds),
    }
}
