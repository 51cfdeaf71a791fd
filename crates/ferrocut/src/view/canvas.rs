//! What a picture is drawn on: lines and filled shapes, nothing else.

use super::font::Align;
use super::ramp::Colour;

/// A point of the picture: pixels, x to the right and y down.
pub type Point = [f64; 2];

/// An upright rectangle, pixels.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Rect {
    /// Left side.
    pub x: f64,
    /// Upper side.
    pub y: f64,
    /// Width.
    pub width: f64,
    /// Height.
    pub height: f64,
}

impl Rect {
    /// Right side.
    pub fn right(&self) -> f64 {
        self.x + self.width
    }

    /// Lower side.
    pub fn bottom(&self) -> f64 {
        self.y + self.height
    }

    /// The rectangle without a border of this width.
    pub fn inset(&self, by: f64) -> Rect {
        Rect { x: self.x + by, y: self.y + by, width: self.width - 2.0 * by, height: self.height - 2.0 * by }
    }

    /// Whether the point lies within.
    pub fn contains(&self, [x, y]: Point) -> bool {
        x >= self.x && x <= self.right() && y >= self.y && y <= self.bottom()
    }

    /// The corners in order round.
    pub fn corners(&self) -> [Point; 4] {
        [[self.x, self.y], [self.right(), self.y], [self.right(), self.bottom()], [self.x, self.bottom()]]
    }

    /// The part of the line from `a` to `b` that lies within (Liang and Barsky 1984).
    pub fn clip(&self, a: Point, b: Point) -> Option<(Point, Point)> {
        if self.contains(a) && self.contains(b) {
            return Some((a, b));
        }
        let d = [b[0] - a[0], b[1] - a[1]];
        let sides = [
            (-d[0], a[0] - self.x),
            (d[0], self.right() - a[0]),
            (-d[1], a[1] - self.y),
            (d[1], self.bottom() - a[1]),
        ];
        let (mut enter, mut leave) = (0.0, 1.0);
        for (speed, room) in sides {
            if speed < 0.0 {
                enter = f64::max(enter, room / speed);
            } else if speed > 0.0 {
                leave = f64::min(leave, room / speed);
            } else if room < 0.0 {
                return None;
            }
        }
        let at = |t: f64| [a[0] + d[0] * t, a[1] + d[1] * t];
        (enter <= leave).then(|| (at(enter), at(leave)))
    }
}

/// How a line is drawn.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Pen {
    /// Its colour.
    pub colour: Colour,
    /// Its width, pixels.
    pub width: f64,
    /// Lengths of dash and gap, pixels; unbroken without.
    pub dash: Option<[f64; 2]>,
}

impl Pen {
    /// An unbroken line.
    pub fn solid(colour: Colour, width: f64) -> Pen {
        Pen { colour, width, dash: None }
    }
}

/// Polylines in one flat list.
#[derive(Clone, Default, Debug)]
pub struct Lines {
    points: Vec<Point>,
    /// Where each polyline ends in `points`; the last one ends with the list.
    ends: Vec<usize>,
}

impl Lines {
    /// Polylines with these points.
    pub fn of(polylines: &[&[Point]]) -> Lines {
        let mut lines = Lines::default();
        for points in polylines {
            lines.polyline(points.iter().copied());
        }
        lines
    }

    /// Adds a polyline.
    pub fn polyline(&mut self, points: impl IntoIterator<Item = Point>) {
        let before = self.points.len();
        self.points.extend(points);
        if self.points.len() > before {
            self.ends.push(self.points.len());
        }
    }

    /// Adds a line, as part of the last polyline if it goes on there.
    pub fn segment(&mut self, a: Point, b: Point) {
        if self.points.last() == Some(&a) {
            self.points.push(b);
            if let Some(end) = self.ends.last_mut() {
                *end = self.points.len();
            }
        } else {
            self.polyline([a, b]);
        }
    }

    /// Number of points.
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// Whether there is nothing.
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// The polylines.
    pub fn iter(&self) -> impl Iterator<Item = &[Point]> {
        let mut first = 0;
        self.ends.iter().map(move |end| {
            let points = self.points.get(first..*end).unwrap_or_default();
            first = *end;
            points
        })
    }
}

/// A surface to draw on. What is drawn later covers what was drawn before.
pub trait Canvas {
    /// Writes a text with letters of whoever looks at the picture, of a size in pixels, turned about its place
    /// (radians, counter-clockwise). `false`: it cannot.
    fn letters(&mut self, _: &str, _: Point, _: f64, _: Align, _: f64, _: Colour) -> bool {
        false
    }

    /// Draws lines with round joints; ends are round too where the line is unbroken, and a polyline of
    /// one point is a dot.
    fn stroke(&mut self, lines: &Lines, pen: &Pen);

    /// Fills a polygon.
    fn fill(&mut self, polygon: &[Point], colour: Colour);

    /// Fills a rectangle.
    fn rect(&mut self, rect: Rect, colour: Colour) {
        self.fill(&rect.corners(), colour);
    }

    /// Draws one line.
    fn line(&mut self, a: Point, b: Point, pen: &Pen) {
        self.stroke(&Lines::of(&[&[a, b]]), pen);
    }

    /// Draws the border of a polygon.
    fn outline(&mut self, polygon: &[Point], pen: &Pen) {
        let mut lines = Lines::default();
        lines.polyline(polygon.iter().chain(polygon.first()).copied());
        self.stroke(&lines, pen);
    }
}

/// A polygon that looks like a circle.
pub fn circle(centre: Point, radius: f64) -> Vec<Point> {
    const SIDES: u32 = 32;
    (0..SIDES)
        .map(|i| {
            let (sin, cos) = (f64::from(i) / f64::from(SIDES) * std::f64::consts::TAU).sin_cos();
            [centre[0] + radius * cos, centre[1] + radius * sin]
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAME: Rect = Rect { x: 0.0, y: 0.0, width: 10.0, height: 10.0 };

    #[test]
    fn lines_are_cut_at_the_frame() {
        assert_eq!(FRAME.clip([-5.0, 5.0], [15.0, 5.0]), Some(([0.0, 5.0], [10.0, 5.0])));
        assert_eq!(FRAME.clip([1.0, 1.0], [2.0, 1e12]), Some(([1.0, 1.0], [1.0 + 9.0 / (1e12 - 1.0), 10.0])));
        assert_eq!(FRAME.clip([-1.0, -1.0], [-1.0, 20.0]), None);
        assert_eq!(FRAME.clip([20.0, 20.0], [20.0, 20.0]), None);
    }

    #[test]
    fn segments_that_go_on_are_one_polyline() {
        let mut lines = Lines::default();
        lines.segment([0.0, 0.0], [1.0, 0.0]);
        lines.segment([1.0, 0.0], [2.0, 0.0]);
        lines.segment([5.0, 0.0], [6.0, 0.0]);
        assert_eq!(lines.iter().map(<[Point]>::len).collect::<Vec<_>>(), [3, 2]);
    }
}
