//! Where two segments cross, and where they come closest.
//!
//! Closest points of two segments that do not cross are an end of one and its foot on the other, or lie
//! on the common normal: for a line and an arc the normal of the line through the centre, for two arcs the
//! line through both centres.

use super::segment::Segment;
use ferrocut_geometry::vector::{along, cross, distance, dot, sub, unit};
use smallvec::SmallVec;

/// Points nearer than this to the end of a segment are its end, mm: a tenth of a nanometre.
const AT_END: f64 = 1e-10;

type Points = SmallVec<[[f64; 2]; 8]>;

/// Points at which two segments cross or touch. Pieces that run along each other have none.
pub(crate) fn crossings(a: &Segment, b: &Segment) -> Points {
    let mut found = lines_and_circles(a, b);
    found.retain(|p| on(a, *p) && on(b, *p));
    found
}

/// The least distance of two segments, and the points of the first and of the second that have it.
pub(crate) fn closest(a: &Segment, b: &Segment) -> (f64, [f64; 2], [f64; 2]) {
    if let Some(p) = crossings(a, b).first() {
        return (0.0, *p, *p);
    }
    let mut best = (f64::INFINITY, a.from(), b.from());
    let mut take = |p: [f64; 2], q: [f64; 2]| {
        let d = distance(p, q);
        if d < best.0 {
            best = (d, p, q);
        }
    };
    for p in [a.from(), a.to()].into_iter().chain(normal_points(a, b)) {
        take(p, b.foot(p));
    }
    for q in [b.from(), b.to()].into_iter().chain(normal_points(b, a)) {
        take(a.foot(q), q);
    }
    best
}

/// Points of `a` on a common normal with the circle or line of `b`.
fn normal_points(a: &Segment, b: &Segment) -> Points {
    let mut points = Points::new();
    match (*a, *b) {
        (Segment::Line { .. }, Segment::Arc { center, .. }) => points.push(a.foot(center)),
        (Segment::Arc { from, center, .. }, _) => {
            let direction = match *b {
                Segment::Line { from, to } => unit(sub(to, from)).map(|d| [-d[1], d[0]]),
                Segment::Arc { center: other, .. } => unit(sub(other, center)),
            };
            let radius = distance(from, center);
            for side in [radius, -radius] {
                if let Some(p) = direction.map(|d| along(center, d, side))
                    && a.distance(p) <= AT_END * (1.0 + radius)
                {
                    points.push(p);
                }
            }
        }
        _ => {}
    }
    points
}

/// Whether a point of the carried-on line or circle lies on the segment.
fn on(segment: &Segment, p: [f64; 2]) -> bool {
    segment.distance(p) <= AT_END * (1.0 + p[0].abs() + p[1].abs())
}

/// Crossings of the lines and circles that the segments lie on.
pub(crate) fn lines_and_circles(a: &Segment, b: &Segment) -> Points {
    match (*a, *b) {
        (Segment::Line { from: p, to: q }, Segment::Line { from: r, to: s }) => {
            let (Some(d), Some(e)) = (unit(sub(q, p)), unit(sub(s, r))) else { return Points::new() };
            let det = cross(d, e);
            if det.abs() < 1e-12 {
                return Points::new();
            }
            Points::from_slice(&[along(p, d, cross(sub(r, p), e) / det)])
        }
        (Segment::Line { from, to }, Segment::Arc { from: on, center, .. })
        | (Segment::Arc { from: on, center, .. }, Segment::Line { from, to }) => {
            let Some(d) = unit(sub(to, from)) else { return Points::new() };
            let foot = along(from, d, dot(sub(center, from), d));
            halves(foot, d, distance(on, center), distance(foot, center))
        }
        (Segment::Arc { from: on_p, center: p, .. }, Segment::Arc { from: on_q, center: q, .. }) => {
            let Some(d) = unit(sub(q, p)) else { return Points::new() };
            let (r, s, gap) = (distance(on_p, p), distance(on_q, q), distance(p, q));
            let t = (gap * gap + (r - s) * (r + s)) / (2.0 * gap);
            halves(along(p, d, t), [-d[1], d[0]], r, t.abs())
        }
    }
}

/// The ends of the chord of a circle of that radius, at that distance from its centre.
fn halves(middle: [f64; 2], d: [f64; 2], radius: f64, distance: f64) -> Points {
    let square = (radius - distance) * (radius + distance);
    if square < 0.0 {
        return Points::new();
    }
    let half = square.sqrt();
    Points::from_slice(&[along(middle, d, half), along(middle, d, -half)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    fn line(from: [f64; 2], to: [f64; 2]) -> Segment {
        Segment::Line { from, to }
    }

    #[test]
    fn closest_points_by_hand() {
        let near = |a: &Segment, b: &Segment, want: f64| {
            let (d, p, q) = closest(a, b);
            assert!((d - want).abs() < 1e-12 && (distance(p, q) - want).abs() < 1e-12, "{d} not {want}");
            assert!(a.distance(p) < 1e-12 && b.distance(q) < 1e-12);
            assert!((closest(b, a).0 - want).abs() < 1e-12);
        };
        // A half circle of radius 5 about the origin, open below.
        let arch = Segment::arc([5.0, 0.0], [-5.0, 0.0], PI);
        near(&arch, &line([-9.0, 8.0], [9.0, 8.0]), 3.0);
        near(&arch, &line([0.0, 0.0], [1.0, 0.0]), 4.0);
        near(&arch, &line([-9.0, 1.0], [9.0, 1.0]), 0.0);
        // Below its ends.
        near(&arch, &line([-9.0, -2.0], [9.0, -2.0]), 2.0);
        // A small circle inside, nearest above, and one outside.
        near(&arch, &Segment::circle([1.0, 2.0], [0.0, 2.0], 1.0), 2.0);
        near(&arch, &Segment::circle([1.0, 9.0], [0.0, 9.0], 1.0), 3.0);
        // Parallel lines beside each other, and lines that overlap.
        near(&line([0.0, 0.0], [9.0, 0.0]), &line([4.0, 1.5], [5.0, 1.5]), 1.5);
        near(&line([0.0, 0.0], [9.0, 0.0]), &line([4.0, 0.0], [15.0, 0.0]), 0.0);
    }

    #[test]
    fn crossings_by_hand() {
        let arch = Segment::arc([5.0, 0.0], [-5.0, 0.0], PI);
        assert_eq!(crossings(&arch, &line([3.0, -9.0], [3.0, 9.0])).as_slice(), [[3.0, 4.0]]);
        assert_eq!(crossings(&arch, &line([-9.0, 3.0], [9.0, 3.0])).len(), 2);
        assert!(crossings(&arch, &line([3.0, -9.0], [3.0, 3.9])).is_empty());
        let other = Segment::circle([11.0, 0.0], [6.0, 0.0], 1.0);
        assert_eq!(crossings(&arch, &other).as_slice(), [[3.0, 4.0]]);
    }
}
