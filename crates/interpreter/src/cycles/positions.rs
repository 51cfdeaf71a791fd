//! Figures of points on which an operation is repeated (Fagor 2.1 to 2.6, 4.23 to 4.27).
//!
//! A figure is reckoned point by point, so that a thousand points take no more memory than one. Point 1 is
//! where the tool stands when it begins. Angles are degrees, counter-clockwise from the abscissa.

use super::parameter::{WrongParameter, refuse};
use crate::stages::rotation::sin_cos_degrees;
use ferrocut_machine::Fault;
use std::sync::Arc;

/// Most points of a figure.
pub const MOST: f64 = 9999.0;

/// A figure.
#[derive(Clone, PartialEq, Debug)]
pub struct Figure {
    from: [f64; 2],
    shape: Shape,
    count: u32,
}

#[derive(Clone, PartialEq, Debug)]
enum Shape {
    /// At equal distances.
    Line { step: [f64; 2] },
    /// On a circle: centre, where it begins, angle from one to the next.
    Round { center: [f64; 2], first: [f64; 2], step: f64 },
    /// In rows to and fro; with `outline` round the parallelogram alone. Steps along both, counts of both.
    Rows { steps: [[f64; 2]; 2], counts: [u32; 2], outline: bool },
    /// One by one.
    Listed(Arc<[[f64; 2]]>),
}

/// Two of the length of a path, the distance of its points and their number.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Path {
    /// Length with its sign, mm.
    pub length: Option<f64>,
    /// Distance, mm.
    pub distance: Option<f64>,
    /// Number of points, the first included.
    pub count: Option<f64>,
}

/// What a control calls them, and how far from whole a number of points may be.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PathNames {
    /// Length.
    pub length: &'static str,
    /// Distance.
    pub distance: &'static str,
    /// Number.
    pub count: &'static str,
    /// Tolerance.
    pub tolerance: f64,
}

/// A whole number of points from one that may be rounded.
pub fn whole(value: f64, tolerance: f64, word: &'static str) -> Result<u32, WrongParameter> {
    let count = value.round();
    refuse(!((value - count).abs() <= tolerance), Fault::PatternNotWhole, word)?;
    refuse(!(1.0..=MOST).contains(&count), Fault::CycleParameter, word)?;
    Ok(count as u32)
}

impl Path {
    /// Signed distance of neighbours, and number of points.
    pub fn steps(self, names: PathNames) -> Result<(f64, u32), WrongParameter> {
        let spaces =
            |count: f64| -> Result<u32, WrongParameter> { whole(count, names.tolerance, names.count) };
        match self {
            Path { length: Some(length), distance: Some(distance), count } => {
                refuse(distance == 0.0, Fault::CycleParameter, names.distance)?;
                let number = whole((length / distance).abs() + 1.0, names.tolerance, names.distance)?;
                // All three may be given where they agree.
                let agrees = match count {
                    Some(count) => spaces(count)? == number,
                    None => true,
                };
                refuse(!agrees, Fault::PatternForm, names.count)?;
                Ok((length / f64::from(number - 1).max(1.0), number))
            }
            Path { length: Some(length), count: Some(count), .. } => {
                let number = spaces(count)?;
                Ok((length / f64::from(number - 1).max(1.0), number))
            }
            Path { distance: Some(distance), count: Some(count), .. } => Ok((distance, spaces(count)?)),
            Path { length, distance, .. } => {
                let missing = match (length, distance) {
                    (None, None) => names.length,
                    _ => names.count,
                };
                Err(WrongParameter::new(Fault::PatternForm, missing))
            }
        }
    }
}

impl Figure {
    /// Points on a line at `degrees`.
    pub fn line(from: [f64; 2], degrees: f64, distance: f64, count: u32) -> Figure {
        let (sin, cos) = sin_cos_degrees(degrees);
        Figure { from, shape: Shape::Line { step: [distance * cos, distance * sin] }, count }
    }

    /// Points from one to another.
    pub fn between(from: [f64; 2], to: [f64; 2], count: u32) -> Figure {
        let spaces = f64::from(count.saturating_sub(1).max(1));
        let step = [(to[0] - from[0]) / spaces, (to[1] - from[1]) / spaces];
        Figure { from, shape: Shape::Line { step }, count }
    }

    /// Points about a centre, `step` degrees from one to the next.
    pub fn round(from: [f64; 2], center: [f64; 2], step: f64, count: u32) -> Figure {
        Figure::on_circle(from, center, from, step, count)
    }

    /// The same on a circle that begins elsewhere: the first point alone is where the figure begins.
    pub fn on_circle(from: [f64; 2], center: [f64; 2], first: [f64; 2], step: f64, count: u32) -> Figure {
        Figure { from, shape: Shape::Round { center, first, step }, count }
    }

    /// Points of a parallelogram: distance and number along either side, angle of the first side, angle
    /// between them.
    pub fn rows(
        from: [f64; 2],
        [(first, columns), (second, rows)]: [(f64, u32); 2],
        [angle, between]: [f64; 2],
        outline: bool,
    ) -> Result<Figure, WrongParameter> {
        let (sin, cos) = sin_cos_degrees(angle);
        let (sin_b, cos_b) = sin_cos_degrees(angle + between);
        let steps = [[first * cos, first * sin], [second * cos_b, second * sin_b]];
        let count = match outline && columns > 1 && rows > 1 {
            true => 2 * (columns - 1) + 2 * (rows - 1),
            false => columns.saturating_mul(rows),
        };
        refuse(f64::from(count) > MOST, Fault::CycleParameter, "N")?;
        Ok(Figure { from, shape: Shape::Rows { steps, counts: [columns, rows], outline }, count })
    }

    /// The points themselves, the first included.
    pub fn listed(points: Vec<[f64; 2]>) -> Figure {
        let from = points.first().copied().unwrap_or_default();
        let count = points.len() as u32;
        Figure { from, shape: Shape::Listed(points.into()), count }
    }

    /// Number of points.
    pub fn count(&self) -> u32 {
        self.count
    }

    /// Centre of a round figure.
    pub fn center(&self) -> Option<[f64; 2]> {
        match self.shape {
            Shape::Round { center, .. } => Some(center),
            _ => None,
        }
    }

    /// Angle from one point of a round figure to another, degrees.
    pub fn angle(&self, from: u32, to: u32) -> f64 {
        match self.shape {
            Shape::Round { step, .. } => step * (f64::from(to) - f64::from(from)),
            _ => 0.0,
        }
    }

    /// The point with this number, counted from 1.
    pub fn point(&self, number: u32) -> [f64; 2] {
        let n = number.saturating_sub(1);
        let [a, b] = self.from;
        match &self.shape {
            Shape::Line { step: [x, y] } => [a + f64::from(n) * x, b + f64::from(n) * y],
            Shape::Round { .. } if n == 0 => self.from,
            Shape::Round { center: [ca, cb], first, step } => {
                let (sin, cos) = sin_cos_degrees(step * f64::from(n));
                let (x, y) = (first[0] - ca, first[1] - cb);
                [ca + x * cos - y * sin, cb + x * sin + y * cos]
            }
            Shape::Rows { steps: [[xa, xb], [ya, yb]], counts, outline } => {
                let [i, j] = node(n, *counts, *outline).map(f64::from);
                [a + i * xa + j * ya, b + i * xb + j * yb]
            }
            Shape::Listed(points) => points.get(n as usize).copied().unwrap_or(self.from),
        }
    }
}

/// Column and row of the point `n`, counted from 0: all in rows to and fro, or the outline along the first
/// side, up, back and down.
fn node(n: u32, [columns, rows]: [u32; 2], outline: bool) -> [u32; 2] {
    let columns = columns.max(1);
    if !outline || columns == 1 || rows <= 1 {
        let (row, column) = (n / columns, n % columns);
        return [if row % 2 == 0 { column } else { columns - 1 - column }, row];
    }
    let (across, up) = (columns - 1, rows - 1);
    match n {
        _ if n <= across => [n, 0],
        _ if n <= across + up => [across, n - across],
        _ if n <= 2 * across + up => [(2 * across + up) - n, up],
        _ => [0, (2 * across + 2 * up).saturating_sub(n)],
    }
}

/// Points that are left out, as words say them: 7 is point 7, 10.013 the points 10 to 13 (2.1).
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Omitted {
    ranges: [Option<[u32; 2]>; 7],
}

impl Omitted {
    /// Reads the words in the order of their letters, in which the points must rise.
    pub fn read(
        words: impl IntoIterator<Item = (&'static str, Option<f64>)>,
    ) -> Result<Omitted, WrongParameter> {
        let mut omitted = Omitted::default();
        let mut last = 0;
        for (slot, (word, value)) in omitted.ranges.iter_mut().zip(words) {
            let Some(value) = value else { continue };
            refuse(!(1.0..=MOST).contains(&value), Fault::CycleParameter, word)?;
            let first = value.trunc();
            // The last point has three digits: 10.13 is 10 to 130.
            let end = ((value - first) * 1000.0).round();
            let end = if end == 0.0 { first } else { end };
            refuse(first <= f64::from(last) || end < first, Fault::PatternOrder, word)?;
            *slot = Some([first as u32, end as u32]);
            last = end as u32;
        }
        Ok(omitted)
    }

    /// Whether a point is left out.
    pub fn contains(&self, number: u32) -> bool {
        self.ranges.iter().flatten().any(|[first, last]| (*first..=*last).contains(&number))
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    const NAMES: PathNames = PathNames { length: "X", distance: "I", count: "K", tolerance: 0.001 };

    fn points(figure: &Figure) -> Vec<[f64; 2]> {
        let round = |v: f64| (v * 1e6).round() / 1e6 + 0.0;
        (1..=figure.count()).map(|n| figure.point(n).map(round)).collect()
    }

    #[test]
    fn two_of_length_distance_and_number_give_the_third() {
        let path = |length, distance, count| Path { length, distance, count }.steps(NAMES);
        assert_eq!(path(Some(1200.0), Some(100.0), None), Ok((100.0, 13)));
        assert_eq!(path(Some(-1200.0), None, Some(13.0)), Ok((-100.0, 13)));
        assert_eq!(path(None, Some(100.0), Some(13.0)), Ok((100.0, 13)));
        assert_eq!(path(Some(1200.0), Some(100.0), Some(13.0)), Ok((100.0, 13)));
        let fault =
            |result: Result<(f64, u32), WrongParameter>| result.map_err(|w| (w.fault, w.word)).unwrap_err();
        assert_eq!(fault(path(Some(1200.0), Some(110.0), None)), (Fault::PatternNotWhole, "I"));
        assert_eq!(fault(path(Some(1200.0), Some(100.0), Some(12.0))), (Fault::PatternForm, "K"));
        assert_eq!(fault(path(Some(1200.0), None, None)), (Fault::PatternForm, "K"));
        assert_eq!(fault(path(None, None, Some(3.0))), (Fault::PatternForm, "X"));
        assert_eq!(fault(path(None, Some(1.0), Some(2.5))), (Fault::PatternNotWhole, "K"));
    }

    #[test]
    fn a_grid_goes_to_and_fro_and_an_outline_round() {
        let grid = Figure::rows([0.0; 2], [(1.0, 3), (2.0, 2)], [0.0, 90.0], false).unwrap();
        assert_eq!(points(&grid), [[0., 0.], [1., 0.], [2., 0.], [2., 2.], [1., 2.], [0., 2.]]);
        let outline = Figure::rows([0.0; 2], [(1.0, 3), (1.0, 3)], [0.0, 90.0], true).unwrap();
        let round = [[0., 0.], [1., 0.], [2., 0.], [2., 1.], [2., 2.], [1., 2.], [0., 2.], [0., 1.]];
        assert_eq!(points(&outline), round);
        let row = Figure::rows([0.0; 2], [(1.0, 3), (1.0, 1)], [0.0, 90.0], true).unwrap();
        assert_eq!(points(&row), [[0., 0.], [1., 0.], [2., 0.]]);
        let column = Figure::rows([0.0; 2], [(1.0, 1), (1.0, 3)], [0.0, 90.0], true).unwrap();
        assert_eq!(points(&column), [[0., 0.], [0., 1.], [0., 2.]]);
    }

    #[test]
    fn ranges_of_omitted_points_have_three_digits_and_rise() {
        let read = |p: Option<f64>, q: Option<f64>| Omitted::read([("P", p), ("Q", q)]);
        let omitted = read(Some(2.003), Some(10.13)).unwrap();
        let left: Vec<u32> = (1..140).filter(|n| !omitted.contains(*n)).collect();
        assert_eq!((left.len(), left[1], left.last()), (139 - 2 - 121, 4, Some(&139)));
        let wrong = read(Some(20.022), Some(12.015)).unwrap_err();
        assert_eq!((wrong.fault, wrong.word), (Fault::PatternOrder, "Q"));
        assert_eq!(read(Some(5.002), None).unwrap_err().fault, Fault::PatternOrder);
        assert_eq!(read(Some(0.5), None).unwrap_err().fault, Fault::CycleParameter);
    }
}
