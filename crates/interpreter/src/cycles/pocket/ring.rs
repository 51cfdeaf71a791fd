//! A closed path of the tool centre.

use super::segment::Segment;
use ferrocut_geometry::vector::{cross, distance, dot};

/// Pieces shorter than this are no move, mm.
const NOTHING: f64 = 1e-6;

/// A closed chain of segments, the free area on its left: counter-clockwise about an area, clockwise
/// about what stands in it.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Ring {
    pub segments: Vec<Segment>,
}

/// A place on a ring: a segment and its parameter.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Place {
    pub segment: usize,
    pub t: f64,
}

impl Ring {
    /// The ring of a closed chain; pieces that go on along the same line or circle become one. `None`
    /// where nothing is left.
    pub fn new(chain: Vec<Segment>) -> Option<Ring> {
        let mut segments: Vec<Segment> = Vec::with_capacity(chain.len());
        for segment in chain {
            if segment.length() < NOTHING {
                // Its end is kept, so that the chain stays closed.
                if let Some(last) = segments.last_mut() {
                    *last = ended(last, segment.to());
                }
                continue;
            }
            match segments.last_mut() {
                Some(last) => match joined(last, &segment) {
                    Some(one) => *last = one,
                    None => segments.push(segment),
                },
                None => segments.push(segment),
            }
        }
        while segments.len() > 1 {
            let (Some(first), Some(last)) = (segments.first(), segments.last()) else { break };
            let Some(one) = joined(last, first) else { break };
            segments.pop();
            if let Some(first) = segments.first_mut() {
                *first = one;
            }
        }
        (!segments.is_empty()).then_some(Ring { segments })
    }

    pub fn length(&self) -> f64 {
        self.segments.iter().map(Segment::length).sum()
    }

    pub fn point(&self, at: Place) -> [f64; 2] {
        self.segments.get(at.segment).map_or([0.0; 2], |s| s.point(at.t))
    }

    /// The place nearest to a point, and its distance.
    pub fn nearest(&self, p: [f64; 2]) -> (Place, f64) {
        let mut best = (Place { segment: 0, t: 0.0 }, f64::INFINITY);
        for (n, segment) in self.segments.iter().enumerate() {
            let d = segment.distance(p);
            if d < best.1 {
                best = (Place { segment: n, t: segment.nearest(p) }, d);
            }
        }
        best
    }

    /// The middle of the longest segment, straight ones first: where a path may begin without breaking an
    /// arc.
    pub fn middle(&self) -> Place {
        let key = |s: &Segment| (matches!(s, Segment::Line { .. }), s.length());
        let mut best = (0, (false, 0.0));
        for (n, segment) in self.segments.iter().enumerate() {
            let own = key(segment);
            if own > best.1 {
                best = (n, own);
            }
        }
        Place { segment: best.0, t: 0.5 }
    }

    /// Once round, from a place and back to it.
    pub fn once_round(&self, at: Place) -> Vec<Segment> {
        let Some(first) = self.segments.get(at.segment) else { return Vec::new() };
        let p = first.point(at.t);
        if let (1, Segment::Arc { center, sweep, .. }) = (self.segments.len(), *first) {
            return vec![Segment::circle(p, center, sweep)];
        }
        let at_start = first.length() * at.t < NOTHING;
        let at_end = first.length() * (1.0 - at.t) < NOTHING;
        let (before, after) = self.segments.split_at(at.segment);
        let mut path = Vec::with_capacity(self.segments.len() + 1);
        match () {
            () if at_start => path.extend_from_slice(after),
            () => {
                if !at_end {
                    path.push(first.part(at.t, 1.0));
                }
                path.extend_from_slice(after.get(1..).unwrap_or_default());
            }
        }
        path.extend_from_slice(before);
        if at_end {
            path.push(*first);
        } else if !at_start {
            path.push(first.part(0.0, at.t));
        }
        path
    }

    /// The way along the ring from one place on to another.
    pub fn between(&self, from: Place, to: Place) -> Vec<Segment> {
        let mut path = Vec::new();
        let target = self.point(to);
        for segment in self.once_round(from) {
            let t = segment.nearest(target);
            if segment.distance(target) < NOTHING && t > 0.0 {
                path.push(segment.part(0.0, t));
                break;
            }
            path.push(segment);
        }
        path
    }

    /// The ring travelled the other way.
    pub fn reversed(&self) -> Ring {
        let segments = self.segments.iter().rev().map(Segment::reversed).collect();
        Ring { segments }
    }
}

/// A segment with its end moved by next to nothing.
fn ended(segment: &Segment, to: [f64; 2]) -> Segment {
    match *segment {
        Segment::Line { from, .. } => Segment::Line { from, to },
        Segment::Arc { from, center, sweep, .. } => Segment::Arc { from, to, center, sweep },
    }
}

/// Two pieces of one line or one circle as one.
fn joined(a: &Segment, b: &Segment) -> Option<Segment> {
    match (*a, *b) {
        (Segment::Line { from, to: corner }, Segment::Line { to, .. }) => {
            let (d, e) = (a.direction(1.0), b.direction(0.0));
            let off = cross(d, [to[0] - corner[0], to[1] - corner[1]]).abs();
            (off < 1e-9 && dot(d, e) > 0.0).then_some(Segment::Line { from, to })
        }
        (Segment::Arc { from, center, sweep, .. }, Segment::Arc { to, center: other, sweep: more, .. }) => {
            let same = distance(center, other) < NOTHING && sweep * more > 0.0;
            let whole = sweep + more;
            if !same || whole.abs() > std::f64::consts::TAU + 1e-9 {
                return None;
            }
            if distance(from, to) < NOTHING {
                // Back at the start is a full circle; the two ends may differ by rounding.
                return (whole.abs() > 6.0).then(|| Segment::circle(from, center, whole));
            }
            Some(Segment::Arc { from, to, center, sweep: whole })
        }
        _ => None,
    }
}
