//! Profiles as the profile editor draws them: elements, with corners between them rounded or chamfered, and
//! ways onto a profile and off it along a tangent (Fagor 4.15.3: corners; 4.21: tangential entry and exit).
//!
//! ```text
//! round r     an arc of radius r touches both elements: its centre lies r beside each of them, on the side to
//!             which the chain turns
//! chamfer c   a straight piece joins the points at the distance c from the corner on both elements
//! ```

use super::meet::lines_and_circles;
use super::problem::Problem;
use super::profile::Profile;
use super::segment::Segment;
use ferrocut_geometry::vector::{along, angle, cross, distance, dot, left, sub, turned, unit};
use std::f64::consts::TAU;

/// What becomes of the corner between an element and the next.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub enum Corner {
    /// It stays.
    #[default]
    Sharp,
    /// An arc of this radius, mm.
    Round(f64),
    /// A straight piece, this far along each side, mm.
    Chamfer(f64),
}

/// An element as drawn, and the corner at its end.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Drawn {
    /// The element between the corners as drawn.
    pub segment: Segment,
    /// The corner to the next element; in a closed chain that of the last one leads to the first.
    pub corner: Corner,
}

/// Elements that go straight on by less than this have no corner: the sine of 1°.
const STRAIGHT_ON: f64 = 0.017_452_406_437_283_51;

/// Slack of a parameter on an element, so that an arc may take all of it.
const WHOLE: f64 = 1e-9;

/// The closed profile of a drawing. On a problem also the number of the element before the corner at fault.
pub fn profile(drawn: &[Drawn]) -> Result<Profile, (Problem, usize)> {
    let mut segments: Vec<Segment> = drawn.iter().map(|d| d.segment).collect();
    let mut result: Vec<Segment> = Vec::with_capacity(2 * segments.len());
    for (n, element) in drawn.iter().enumerate() {
        let next = if n + 1 == drawn.len() { 0 } else { n + 1 };
        let (Some(a), Some(b)) = (segments.get(n).copied(), segments.get(next).copied()) else { break };
        if element.corner == Corner::Sharp {
            result.push(a);
            continue;
        }
        if next == n {
            return Err((Problem::CornerTooLarge, n));
        }
        let (a, between, b) = join(&a, &b, element.corner).ok_or((Problem::CornerTooLarge, n))?;
        result.push(a);
        result.extend(between);
        // Shortened elements leave less for the corners at their other ends.
        for (place, own) in [(n, a), (next, b)] {
            if let Some(slot) = segments.get_mut(place) {
                *slot = own;
            }
        }
        if next == 0 {
            // The first element is in the result already, with its old start.
            if let Some(first) = result.first_mut() {
                let end = first.nearest(b.from());
                *first = first.part(end, 1.0);
            }
        }
    }
    result.retain(|s| s.length() > 1e-6);
    Ok(Profile { segments: result })
}

/// Both elements shortened, and what comes between them.
fn join(a: &Segment, b: &Segment, corner: Corner) -> Option<(Segment, Option<Segment>, Segment)> {
    let (inward, outward) = (a.direction(1.0), b.direction(0.0));
    let turn = cross(inward, outward);
    match corner {
        Corner::Sharp => Some((*a, None, *b)),
        Corner::Chamfer(size) if size > 0.0 => {
            let (s, t) = (1.0 - share(a, size)?, share(b, size)?);
            let (from, to) = (a.point(s), b.point(t));
            Some((a.part(0.0, s), Some(Segment::Line { from, to }), b.part(t, 1.0)))
        }
        Corner::Round(radius) if radius > 0.0 => {
            if turn.abs() < STRAIGHT_ON && dot(inward, outward) > 0.0 {
                return Some((*a, None, *b));
            }
            let side = radius * turn.signum();
            let (p, q) = (beside(a, side)?, beside(b, side)?);
            let found = lines_and_circles(&p, &q).into_iter().filter_map(|center| {
                let (s, t) = (foot(a, center)?, foot(b, center)?);
                Some((distance(center, a.to()), center, s, t))
            });
            let (_, center, s, t) = found.min_by(|x, y| x.0.total_cmp(&y.0))?;
            let (from, to) = (a.point(s), b.point(t));
            let sweep = angle(sub(from, center), sub(to, center));
            let sweep = if sweep * turn < 0.0 { sweep + TAU * turn.signum() } else { sweep };
            Some((a.part(0.0, s), Some(Segment::Arc { from, to, center, sweep }), b.part(t, 1.0)))
        }
        _ => None,
    }
}

/// The share of an element whose ends are `size` apart.
fn share(segment: &Segment, size: f64) -> Option<f64> {
    let share = match *segment {
        Segment::Line { .. } => size / segment.length(),
        Segment::Arc { from, center, sweep, .. } => {
            let half = size / (2.0 * distance(from, center));
            if half > 1.0 {
                return None;
            }
            2.0 * half.asin() / sweep.abs()
        }
    };
    (share <= 1.0 + WHOLE).then_some(share.min(1.0))
}

/// The line or circle beside an element, to the left by `side`.
fn beside(segment: &Segment, side: f64) -> Option<Segment> {
    match *segment {
        Segment::Line { from, to } => {
            let normal = left(segment.direction(0.0));
            Some(Segment::Line { from: along(from, normal, side), to: along(to, normal, side) })
        }
        Segment::Arc { from, center, sweep, .. } => {
            // Left of a counter-clockwise arc is towards its centre.
            let radius = distance(from, center) - side * sweep.signum();
            let outward = unit(sub(from, center))?;
            (radius > 1e-9).then(|| Segment::circle(along(center, outward, radius), center, sweep))
        }
    }
}

/// The parameter of the foot of a point on an element; `None` beyond its ends.
fn foot(segment: &Segment, p: [f64; 2]) -> Option<f64> {
    match *segment {
        Segment::Line { from, to } => {
            let d = sub(to, from);
            let t = dot(sub(p, from), d) / dot(d, d);
            (-WHOLE..=1.0 + WHOLE).contains(&t).then(|| t.clamp(0.0, 1.0))
        }
        Segment::Arc { .. } => segment.turned_to(p).or_else(|| {
            let t = segment.nearest(p);
            let off = cross(segment.direction(t), sub(p, segment.point(t)));
            // A hair beyond an end is the end.
            (off.is_finite() && dot(segment.direction(t), sub(p, segment.point(t))).abs() < WHOLE)
                .then_some(t)
        }),
    }
}

/// From a point onto the start of a chain along a tangent: a straight piece, and an arc of that radius which
/// both touches. It lies on the side of the chain from which the tool comes.
pub fn tangential_entry(from: [f64; 2], chain: &[Segment], radius: f64) -> Result<Vec<Segment>, Problem> {
    let first = chain.first().ok_or(Problem::ProfileEmpty)?;
    let (start, heading) = (first.from(), first.direction(0.0));
    let side = cross(heading, sub(from, start));
    if side.abs() < 1e-9 || radius <= 0.0 {
        // It comes along the tangent itself.
        return Ok(vec![Segment::Line { from, to: start }]);
    }
    let side = side.signum();
    let center = along(start, left(heading), radius * side);
    let away = sub(from, center);
    let far = distance(from, center);
    if far <= radius {
        return Err(Problem::CornerTooLarge);
    }
    // The tangent from a point at the distance D touches at the angle acos(r/D) from the way to it.
    let toward = unit(away).ok_or(Problem::CornerTooLarge)?;
    let touch = along(center, turned(toward, side * (radius / far).acos()), radius);
    let sweep = angle(sub(touch, center), sub(start, center));
    let sweep = if sweep * side < 0.0 { sweep + TAU * side } else { sweep };
    let mut way = vec![Segment::Line { from, to: touch }];
    if distance(touch, start) > 1e-9 {
        way.push(Segment::Arc { from: touch, to: start, center, sweep });
    }
    Ok(way)
}

/// From the end of a chain along a tangent to a point: an entry travelled the other way.
pub fn tangential_exit(chain: &[Segment], to: [f64; 2], radius: f64) -> Result<Vec<Segment>, Problem> {
    let last = chain.last().ok_or(Problem::ProfileEmpty)?.reversed();
    let way = tangential_entry(to, &[last], radius)?;
    Ok(way.iter().rev().map(Segment::reversed).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, PI};

    fn square(corner: Corner) -> Vec<Drawn> {
        let p = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]];
        (0..4).map(|k| Drawn { segment: Segment::Line { from: p[k], to: p[(k + 1) % 4] }, corner }).collect()
    }

    #[test]
    fn corners_of_a_square() {
        let round = profile(&square(Corner::Round(2.0))).unwrap().checked().unwrap();
        assert_eq!(round.segments.len(), 8);
        assert!((round.area() - (100.0 - 4.0 * (4.0 - PI))).abs() < 1e-9);
        let chamfer = profile(&square(Corner::Chamfer(2.0))).unwrap().checked().unwrap();
        assert!((chamfer.area() - 92.0).abs() < 1e-9);
        // Two arcs of 5 take all of each side.
        let all = profile(&square(Corner::Round(5.0))).unwrap().checked().unwrap();
        assert!((all.area() - 25.0 * PI).abs() < 1e-6);
        assert_eq!(profile(&square(Corner::Round(5.1))), Err((Problem::CornerTooLarge, 1)));
        assert_eq!(profile(&square(Corner::Chamfer(10.1))), Err((Problem::CornerTooLarge, 0)));
    }

    #[test]
    fn corner_between_line_and_arc() {
        // A half disc of radius 10; its right corner rounded by 2: centre 2 above the line and 8 from the
        // middle.
        let line = Segment::Line { from: [-10.0, 0.0], to: [10.0, 0.0] };
        let arc = Segment::arc([10.0, 0.0], [-10.0, 0.0], PI);
        let drawn = [
            Drawn { segment: line, corner: Corner::Round(2.0) },
            Drawn { segment: arc, corner: Corner::Sharp },
        ];
        let found = profile(&drawn).unwrap().checked().unwrap();
        let Segment::Arc { center, sweep, .. } = found.segments[1] else { panic!("no arc") };
        assert!((center[0] - 60f64.sqrt()).abs() < 1e-9 && (center[1] - 2.0).abs() < 1e-9);
        assert!(sweep > FRAC_PI_2);
    }

    #[test]
    fn tangential_ways() {
        let chain = [Segment::Line { from: [0.0, 0.0], to: [10.0, 0.0] }];
        let way = tangential_entry([-10.0, 20.0], &chain, 5.0).unwrap();
        let [line, arc] = way.as_slice() else { panic!("{way:?}") };
        // The line touches the arc, and the arc the chain.
        for (a, b) in [(line, arc), (arc, &chain[0])] {
            assert!(distance(a.to(), b.from()) < 1e-9);
            assert!(dot(a.direction(1.0), b.direction(0.0)) > 1.0 - 1e-9);
        }
        let Segment::Arc { center, sweep, .. } = *arc else { panic!("no arc") };
        assert!(center == [0.0, 5.0] && sweep > 0.0 && sweep < PI);
        let out = tangential_exit(&chain, [20.0, -20.0], 5.0).unwrap();
        assert!(dot(out[0].direction(0.0), [1.0, 0.0]) > 1.0 - 1e-9);
        assert_eq!(out.last().unwrap().to(), [20.0, -20.0]);
        assert_eq!(tangential_entry([0.0, 6.0], &chain, 5.0), Err(Problem::CornerTooLarge));
        assert_eq!(tangential_entry([-9.0, 0.0], &chain, 5.0).unwrap().len(), 1);
    }
}
