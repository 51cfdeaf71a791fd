//! Splines (NURBS), in any place in space; seen from above they become lines and arcs.
//!
//! # Points close enough
//!
//! Each span between two knots is a Bézier curve, whose control points are the blossom of the spline at
//! the knots (Ramshaw). It is halved (de Casteljau) until all its control points lie within `c` of the
//! chord. A Bézier curve lies within the convex hull of its control points, also a rational one with
//! positive weights, and the points within `c` of a chord are convex: so the curve is within `c` of
//! the chord, whatever the degree. Its direction at either end is that to the nearest control point
//! that differs.
//!
//! Arcs are laid through the ends ([`fit`](mod@crate::fit)), span after span; only a corner of the
//! curve begins a new row of points.

use crate::curve::Curve;
use crate::fit::{self, Sample};
use crate::vector::{Point, cross, distance, dot, sub};

/// Highest degree; CAD programs go up to 25.
pub const MOST_DEGREE: usize = 25;

/// Behind so many points of a closed curve nothing is left of where it was begun: a quarter to this power.
const FADED: usize = 24;

/// Halvings of a span: shorter pieces than doubles can tell apart are not needed.
const MOST_HALVINGS: u32 = 40;

/// The share of the tolerance that is given to the chords; the rest is left to the arcs.
const CHORD_SHARE: f64 = 0.125;

/// Directions on both sides of a joint that differ by more make a corner, radians.
const CORNER: f64 = 1e-3;

/// A point or vector of space.
pub type Vector = [f64; 3];

/// A spline.
#[derive(Clone, PartialEq, Debug)]
pub struct Spline {
    degree: usize,
    knots: Vec<f64>,
    points: Vec<Vector>,
    /// As many as there are points.
    weights: Vec<f64>,
}

/// A control point seen from above, times its weight, and the weight.
type Weighted = [f64; 3];

impl Spline {
    /// A spline by its control points; `weights` may be empty. `None` if the parts do not fit each other.
    pub fn new(degree: usize, knots: Vec<f64>, points: Vec<Vector>, weights: Vec<f64>) -> Option<Spline> {
        let weights = if weights.is_empty() { vec![1.0; points.len()] } else { weights };
        let fits = (1..=MOST_DEGREE).contains(&degree)
            && points.len() > degree
            && knots.len() == points.len() + degree + 1
            && weights.len() == points.len()
            && weights.iter().all(|w| *w > 0.0 && w.is_finite())
            && knots.iter().chain(points.iter().flatten()).all(|c| c.is_finite())
            && knots.windows(2).all(|pair| pair.first() <= pair.last())
            && knots.get(degree) < knots.get(points.len());
        fits.then_some(Spline { degree, knots, points, weights })
    }

    /// The spline that begins in its first control point and ends in its last, with knots at equal distances
    /// between (RS274/NGC as LinuxCNC has it: G5 to G5.3). `order` is the degree and 1.
    pub fn clamped(order: usize, points: Vec<Vector>, weights: Vec<f64>) -> Option<Spline> {
        let degree = order.checked_sub(1)?;
        let spans = points.len().checked_sub(degree)?;
        let inner = (1..spans).map(|knot| knot as f64);
        let knots = std::iter::repeat_n(0.0, order).chain(inner);
        let knots = knots.chain(std::iter::repeat_n(spans as f64, order)).collect();
        Spline::new(degree, knots, points, weights)
    }

    /// The curve through `points` as CAD programs draw it: cubic with continuous curvature, run through
    /// at the speed of the chords, without curvature at the ends or in a given direction there.
    pub fn through(points: &[Vector], start: Option<Vector>, end: Option<Vector>) -> Option<Spline> {
        let distinct = distinct(points);
        let chords = chords(&distinct);
        let slopes = slopes(&distinct, &chords, start, end)?;
        Spline::along(&distinct, &chords, &slopes)
    }

    /// The same closed: it ends where it begins, and runs on there as everywhere.
    ///
    /// What an end makes of the slope at a point falls to a quarter or so from point to point, so the slopes of the points gone
    /// through again and again are those of the closed curve but near both ends.
    pub fn through_closed(points: &[Vector]) -> Option<Spline> {
        let mut distinct = distinct(points);
        if distinct.len() > 1 && distinct.first() == distinct.last() {
            distinct.pop();
        }
        let count = distinct.len();
        if count < 3 {
            distinct.extend(distinct.first().copied());
            return Spline::through(&distinct, None, None);
        }
        let before = FADED.next_multiple_of(count);
        let again: Vec<Vector> = distinct.iter().cycle().take(before + count + FADED + 1).copied().collect();
        let all = chords(&again);
        let slopes = slopes(&again, &all, None, None)?;
        let own = before..before + count;
        Spline::along(
            again.get(own.start..=own.end)?,
            all.get(own.clone())?,
            slopes.get(own.start..=own.end)?,
        )
    }

    /// Through these points with these slopes, in chords so long.
    fn along(points: &[Vector], chords: &[f64], slopes: &[Vector]) -> Option<Spline> {
        let (first, mut knot) = (*points.first()?, 0.0);
        let (mut knots, mut control) = (vec![0.0; 4], vec![first]);
        for ((pair, slope), chord) in points.windows(2).zip(slopes.windows(2)).zip(chords) {
            let ([a, b], [m, n]) = (pair, slope) else { return None };
            control.push(std::array::from_fn(|i| a[i] + m[i] * chord / 3.0));
            control.push(std::array::from_fn(|i| b[i] - n[i] * chord / 3.0));
            control.push(*b);
            knot += chord;
            knots.extend([knot; 3]);
        }
        knots.push(knot);
        Spline::new(3, knots, control, Vec::new())
    }

    /// The spline in another place: `by` must be affine.
    pub fn placed(&self, by: impl Fn(Vector) -> Vector) -> Spline {
        Spline { points: self.points.iter().map(|p| by(*p)).collect(), ..self.clone() }
    }

    /// Its control points.
    pub fn points(&self) -> &[Vector] {
        &self.points
    }

    /// Seen from above: lines and arcs within `tolerance` of it. `more` is asked before each point that the
    /// curve is divided into, with how many the row has already; what it refuses ends the work.
    pub fn curves<E>(
        &self,
        tolerance: f64,
        mut more: impl FnMut(usize) -> Result<(), E>,
        out: &mut Vec<Curve>,
    ) -> Result<(), E> {
        let chord = tolerance * CHORD_SHARE;
        let room = tolerance - chord;
        let weighted: Vec<Weighted> =
            self.points.iter().zip(&self.weights).map(|(p, w)| [p[0] * w, p[1] * w, *w]).collect();
        let mut row: Vec<Sample> = Vec::new();
        let mut bezier = [[0.0; 3]; MOST_DEGREE + 1];
        for knot in self.degree..self.points.len() {
            let Some(control) = self.span(knot, &weighted, &mut bezier) else { continue };
            let Some(along) = leaving(control.iter().copied()) else { continue };
            let Some(first) = control.first() else { continue };
            let corner = row.last().filter(|last| !is_smooth(last.along, along)).copied();
            if corner.is_some() {
                fit::fit(&row, room, out);
                row.clear();
            }
            if row.is_empty() {
                let at = corner.map_or(seen(*first), |corner| corner.at);
                row.push(Sample { at, along });
            }
            halve(control, chord, MOST_HALVINGS, &mut more, &mut row)?;
        }
        fit::fit(&row, room, out);
        Ok(())
    }

    /// The Bézier points of the span from `knot` to the next one; `None` where it is empty.
    fn span<'b>(
        &self,
        knot: usize,
        weighted: &[Weighted],
        bezier: &'b mut [Weighted; MOST_DEGREE + 1],
    ) -> Option<&'b [Weighted]> {
        let degree = self.degree;
        let (low, high) = (*self.knots.get(knot)?, *self.knots.get(knot + 1)?);
        if low >= high {
            return None;
        }
        let around = weighted.get(knot - degree..=knot)?;
        for (place, point) in bezier.iter_mut().enumerate().take(degree + 1) {
            // The blossom at `low` (degree − place) times and `high` (place) times.
            let mut d = [[0.0; 3]; MOST_DEGREE + 1];
            d.get_mut(..=degree)?.copy_from_slice(around);
            for round in 1..=degree {
                let at = if round <= place { high } else { low };
                for i in (round..=degree).rev() {
                    let left = *self.knots.get(knot - degree + i)?;
                    let right = *self.knots.get(knot + 1 + i - round)?;
                    let share = (at - left) / (right - left);
                    let (a, b) = (*d.get(i - 1)?, *d.get(i)?);
                    *d.get_mut(i)? = std::array::from_fn(|c| a[c] + (b[c] - a[c]) * share);
                }
            }
            *point = *d.get(degree)?;
        }
        bezier.get(..=degree)
    }
}

/// Where a weighted point is.
fn seen(p: Weighted) -> Point {
    [p[0] / p[2], p[1] / p[2]]
}

/// Unit vector from the first control point to the next that differs.
fn leaving(mut control: impl Iterator<Item = Weighted>) -> Option<Point> {
    let from = seen(control.next()?);
    control.find_map(|p| {
        let v = sub(seen(p), from);
        let length = v[0].hypot(v[1]);
        (length > 1e-12).then(|| v.map(|c| c / length))
    })
}

fn is_smooth(before: Point, after: Point) -> bool {
    dot(before, after) > 0.0 && cross(before, after).abs() <= CORNER
}

/// Adds the ends of pieces whose control points are within `room` of their chords.
fn halve<E>(
    control: &[Weighted],
    room: f64,
    halvings: u32,
    more: &mut impl FnMut(usize) -> Result<(), E>,
    row: &mut Vec<Sample>,
) -> Result<(), E> {
    let (Some(first), Some(last)) = (control.first(), control.last()) else { return Ok(()) };
    let (from, to) = (seen(*first), seen(*last));
    if halvings == 0 || control.iter().all(|p| off_chord(from, to, seen(*p)) <= room) {
        more(row.len())?;
        let along = leaving(control.iter().rev().copied()).map_or([0.0; 2], |v| v.map(|c| -c));
        row.push(Sample { at: to, along });
        return Ok(());
    }
    let degree = control.len() - 1;
    let (mut left, mut right) = ([[0.0; 3]; MOST_DEGREE + 1], [[0.0; 3]; MOST_DEGREE + 1]);
    let Some(work) = right.get_mut(..=degree) else { return Ok(()) };
    work.copy_from_slice(control);
    for (round, corner) in left.iter_mut().enumerate().take(degree + 1) {
        *corner = work.first().copied().unwrap_or_default();
        for i in 0..degree - round {
            if let Some([a, b]) = work.get_mut(i..i + 2) {
                *a = std::array::from_fn(|c| (a[c] + b[c]) / 2.0);
            }
        }
    }
    halve(left.get(..=degree).unwrap_or(&[]), room, halvings - 1, more, row)?;
    halve(right.get(..=degree).unwrap_or(&[]), room, halvings - 1, more, row)
}

/// The length of a vector.
fn norm(v: Vector) -> f64 {
    v[0].hypot(v[1]).hypot(v[2])
}

/// Distance of a point from a chord, its ends included.
fn off_chord(from: Point, to: Point, p: Point) -> f64 {
    let (v, w) = (sub(to, from), sub(p, from));
    let square = dot(v, v);
    let share = if square > 0.0 { (dot(v, w) / square).clamp(0.0, 1.0) } else { 0.0 };
    distance([from[0] + v[0] * share, from[1] + v[1] * share], p)
}

/// The points without those that repeat the one before.
fn distinct(points: &[Vector]) -> Vec<Vector> {
    let mut distinct: Vec<Vector> = Vec::with_capacity(points.len());
    for p in points {
        if distinct.last() != Some(p) {
            distinct.push(*p);
        }
    }
    distinct
}

/// How far it is from each point to the next.
fn chords(points: &[Vector]) -> Vec<f64> {
    let between = |(a, b): (&Vector, &Vector)| norm(std::array::from_fn(|i| b[i] - a[i]));
    points.iter().zip(points.iter().skip(1)).map(between).collect()
}

/// Slopes at the points of a cubic with continuous curvature (Thomas's algorithm on
/// `h₁ m₀ + 2 (h₀ + h₁) m₁ + h₀ m₂ = 3 (h₁ s₀ + h₀ s₁)`, `h` the chords, `s` their slopes).
fn slopes(
    points: &[Vector],
    chords: &[f64],
    start: Option<Vector>,
    end: Option<Vector>,
) -> Option<Vec<Vector>> {
    let last = chords.len().checked_sub(1)?;
    let unit = |v: Vector| {
        let length = norm(v);
        (length > 0.0).then(|| v.map(|c| c / length))
    };
    let chord_slope = |i: usize| -> Option<Vector> {
        let (a, b, h) = (points.get(i)?, points.get(i + 1)?, chords.get(i)?);
        Some(std::array::from_fn(|c| (b[c] - a[c]) / h))
    };
    // Rows as (left, middle, right, value).
    let row = |i: usize| -> Option<(f64, f64, f64, Vector)> {
        if i == 0 {
            return Some(match start.and_then(unit) {
                Some(given) => (0.0, 1.0, 0.0, given),
                None => (0.0, 2.0, 1.0, chord_slope(0)?.map(|c| 3.0 * c)),
            });
        }
        if i > last {
            return Some(match end.and_then(unit) {
                Some(given) => (0.0, 1.0, 0.0, given),
                None => (1.0, 2.0, 0.0, chord_slope(last)?.map(|c| 3.0 * c)),
            });
        }
        let (before, after) = (*chords.get(i - 1)?, *chords.get(i)?);
        let (s, t) = (chord_slope(i - 1)?, chord_slope(i)?);
        let value = std::array::from_fn(|c| 3.0 * (after * s[c] + before * t[c]));
        Some((after, 2.0 * (before + after), before, value))
    };
    let mut swept: Vec<(f64, Vector)> = Vec::with_capacity(points.len());
    for i in 0..points.len() {
        let (left, middle, right, value) = row(i)?;
        let (share, above) = swept.last().copied().unwrap_or((0.0, [0.0; 3]));
        let pivot = middle - left * share;
        swept.push((right / pivot, std::array::from_fn(|c| (value[c] - left * above[c]) / pivot)));
    }
    let mut slopes = vec![[0.0; 3]; points.len()];
    let mut next = [0.0; 3];
    for ((share, value), slope) in swept.iter().zip(&mut slopes).rev() {
        next = std::array::from_fn(|c| value[c] - share * next[c]);
        *slope = next;
    }
    Some(slopes)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    fn curves(spline: &Spline) -> Vec<Curve> {
        let mut out = Vec::new();
        spline.curves(0.01, |_| Ok::<(), ()>(()), &mut out).unwrap();
        out
    }

    #[test]
    fn a_rational_quarter_circle_is_one() {
        let w = 0.5f64.sqrt();
        let points = vec![[10.0, 0.0, 0.0], [10.0, 10.0, 0.0], [0.0, 10.0, 0.0]];
        let knots = vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0];
        let spline = Spline::new(2, knots, points, vec![1.0, w, 1.0]).unwrap();
        let arcs = curves(&spline);
        assert!(arcs.len() <= 2, "{arcs:?}");
        for arc in &arcs {
            assert!((arc.radius() - 10.0).abs() < 1e-6, "{arc:?}");
        }
    }

    #[test]
    fn a_clamped_spline_begins_and_ends_in_its_points() {
        let points = vec![[0.0, 1.0, 0.0], [1.0, 1.0, 0.0], [2.0, 2.0, 0.0], [3.0, 0.0, 0.0]];
        let spline = Spline::clamped(3, points.clone(), vec![1.0, 2.0, 1.0, 1.0]).unwrap();
        let arcs = curves(&spline);
        assert_eq!((arcs.first().unwrap().from, arcs.last().unwrap().to), ([0.0, 1.0], [3.0, 0.0]));
        // Two spans: half way round it is the middle of the second and third point, with their weights.
        let middle = [(2.0 * 1.0 + 2.0) / 3.0, (2.0 * 1.0 + 2.0) / 3.0];
        let nearest = arcs.iter().flat_map(|arc| (0..=500).map(|i| arc.at(f64::from(i) / 500.0)));
        let off = nearest.map(|p| distance(p, middle)).fold(f64::MAX, f64::min);
        assert!(off < 0.011, "{off}");
        assert!(Spline::clamped(0, points.clone(), Vec::new()).is_none());
        assert!(Spline::clamped(5, points.clone(), Vec::new()).is_none());
        assert!(Spline::clamped(4, points, Vec::new()).is_some());
    }

    #[test]
    fn a_spline_of_degree_1_is_its_polygon() {
        let points = vec![[0.0, 0.0, 0.0], [5.0, 0.0, 0.0], [5.0, 5.0, 0.0]];
        let spline = Spline::new(1, vec![0.0, 0.0, 1.0, 2.0, 2.0], points, Vec::new()).unwrap();
        assert_eq!(
            curves(&spline),
            [Curve::line([0.0, 0.0], [5.0, 0.0]), Curve::line([5.0, 0.0], [5.0, 5.0])]
        );
    }

    #[test]
    fn a_curve_through_points_goes_through_them() {
        let points =
            [[0.0, 0.0, 0.0], [10.0, 5.0, 0.0], [20.0, -5.0, 0.0], [20.0, -5.0, 0.0], [30.0, 0.0, 0.0]];
        let spline = Spline::through(&points, None, None).unwrap();
        let arcs = curves(&spline);
        assert_eq!(arcs.first().unwrap().from, [0.0, 0.0]);
        assert_eq!(arcs.last().unwrap().to, [30.0, 0.0]);
        // Without curvature at the ends and symmetric about the middle (15, 0).
        let straight = Spline::through(&points[..2], None, None).unwrap();
        assert_eq!(curves(&straight), [Curve::line([0.0, 0.0], [10.0, 5.0])]);
    }

    #[test]
    fn a_closed_curve_runs_on_where_it_begins() {
        // Eight points of a circle, without the first once more and with it.
        let circle: Vec<Vector> = (0..8)
            .map(|k| (f64::from(k) * PI / 4.0).sin_cos())
            .map(|(s, c)| [10.0 * c, 10.0 * s, 0.0])
            .collect();
        let again: Vec<Vector> = circle.iter().chain(circle.first()).copied().collect();
        for points in [&circle, &again] {
            let spline = Spline::through_closed(points).unwrap();
            let control = spline.points();
            assert_eq!((control.len(), control[0]), (25, control[24]));
            // The slope before the join is the one behind it, and across the radius.
            let (behind, before) = (control[1], control[23]);
            assert!(
                (behind[0] - 10.0).abs() < 1e-9 && (before[0] - 10.0).abs() < 1e-9,
                "{behind:?} {before:?}"
            );
            assert!((behind[1] + before[1]).abs() < 1e-9, "{behind:?} {before:?}");
            let arcs = curves(&spline);
            assert!(arcs.iter().all(|arc| (arc.at(0.5)[0].hypot(arc.at(0.5)[1]) - 10.0).abs() < 0.03));
            assert_eq!(arcs.first().unwrap().from, arcs.last().unwrap().to);
        }
        // Two points are a line there and back.
        let line = Spline::through_closed(&circle[..2]).unwrap();
        assert_eq!(line.points().first(), line.points().last());
        assert!(Spline::through_closed(&circle[..1]).is_none());
    }

    #[test]
    fn what_does_not_fit_is_no_spline() {
        let points = vec![[0.0; 3], [1.0; 3], [2.0; 3]];
        let knots = vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0];
        let build = |degree, knots: &[f64], weights: &[f64]| {
            Spline::new(degree, knots.to_vec(), points.clone(), weights.to_vec())
        };
        assert!(build(2, &knots, &[]).is_some());
        assert!(build(3, &knots, &[]).is_none());
        assert!(build(0, &knots, &[]).is_none());
        assert!(build(2, &knots[1..], &[]).is_none());
        assert!(build(2, &knots, &[1.0]).is_none());
        assert!(build(2, &knots, &[1.0, 0.0, 1.0]).is_none());
        assert!(build(2, &[0.0, 0.0, 1.0, 0.5, 1.0, 1.0], &[]).is_none());
        assert!(build(2, &[0.0; 6], &[]).is_none());
        assert!(build(2, &[0.0, 0.0, 0.0, f64::NAN, 1.0, 1.0], &[]).is_none());
    }
}
