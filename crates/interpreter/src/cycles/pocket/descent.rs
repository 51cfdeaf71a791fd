//! Down into full material under the entry angle.
//!
//! The tool follows a closed way and sinks by tan β for each millimetre of it. It keeps that angle until the
//! depth is reached (Fagor 4.15), so the way down over a height h is h/tan β long and, counted back from
//! where it is to end, begins somewhere on the closed way:
//!
//! ```text
//! begins at  −h/tan β mod L      L: length of the closed way, on which the end is 0
//! ```
//!
//! Without an angle the tool goes straight down (4.1.3: 0 in cycle and tool table is 90°).

use super::pen::{Pen, PocketFeed, PocketSink};
use super::problem::{PocketFault, Problem, in_range};
use super::segment::Segment;

/// The slope of an entry; `None` straight down.
pub(crate) type Slope = Option<f64>;

/// tan β of an angle in degrees. 0 stands for the tool's own, which also bounds others (4.1.3).
pub(crate) fn slope(angle: f64, of_tool: f64, parameter: &'static str) -> Result<Slope, PocketFault> {
    let (angle, of_tool) = (in_range(angle, parameter)?, in_range(of_tool, parameter)?);
    Problem::Negative.when(angle < 0.0 || of_tool < 0.0, parameter)?;
    Problem::EntryAngle.when(angle > 90.0 || of_tool > 90.0, parameter)?;
    let wanted = match (angle, of_tool) {
        (angle, 0.0) => angle,
        (0.0, own) => own,
        (angle, own) => angle.min(own),
    };
    // Within a thousandth of a degree of it is straight down.
    let steep = wanted == 0.0 || wanted > 89.999;
    Ok(if steep { None } else { Some(wanted.to_radians().tan()) })
}

/// A way down.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Descent<'a> {
    way: &'a [Segment],
    /// Whole turns after the first part.
    turns: u32,
    /// Segment and parameter where it begins.
    first: usize,
    t: f64,
    slope: Slope,
}

impl<'a> Descent<'a> {
    /// The way down over a height, ending where the closed way does.
    pub fn new(way: &'a [Segment], height: f64, slope: Slope) -> Descent<'a> {
        let straight = Descent { way, turns: 0, first: way.len(), t: 0.0, slope: None };
        let whole: f64 = way.iter().map(Segment::length).sum();
        let Some(tan) = slope.filter(|_| height > 0.0 && whole > 0.0) else { return straight };
        let long = height / tan;
        let turns = (long / whole).floor();
        // From the end backwards.
        let mut left = long - turns * whole;
        for (n, segment) in way.iter().enumerate().rev() {
            let own = segment.length();
            if left <= own {
                let t = if own > 0.0 { 1.0 - left / own } else { 1.0 };
                return Descent { way, turns: turns.min(1e7) as u32, first: n, t, slope };
            }
            left -= own;
        }
        Descent { way, turns: turns.min(1e7) as u32, first: 0, t: 0.0, slope }
    }

    /// Where it begins.
    pub fn start(&self) -> [f64; 2] {
        match (self.way.get(self.first), self.way.last()) {
            (Some(segment), _) => segment.point(self.t),
            (None, Some(last)) => last.to(),
            (None, None) => [0.0; 2],
        }
    }

    /// Number of moves that it takes.
    pub fn moves(&self) -> f64 {
        1.0 + self.way.len() as f64 * (f64::from(self.turns) + 1.0)
    }

    /// Points of the plane that it passes, close enough that nothing hides between them.
    pub fn points(&self) -> impl Iterator<Item = [f64; 2]> + '_ {
        let ways = if self.slope.is_some() { self.way } else { &[] };
        let between = ways.iter().flat_map(|s| (1..8).map(|k| s.point(f64::from(k) / 8.0)));
        between.chain([self.start()])
    }

    /// Down to a level, from where it begins at the height `from`.
    pub fn go<S: PocketSink>(&self, pen: &mut Pen<'_, S>, from: f64, to: f64) -> Result<(), S::Error> {
        let Some(tan) = self.slope else { return pen.plunge(to) };
        let mut height = from;
        let mut sink = |segment: &Segment, pen: &mut Pen<'_, S>| {
            height = (height - segment.length() * tan).max(to);
            pen.along(segment, height, PocketFeed::Plunge)
        };
        if let Some(segment) = self.way.get(self.first).filter(|s| s.length() * (1.0 - self.t) > 1e-6) {
            sink(&segment.part(self.t, 1.0), pen)?;
        }
        for segment in self.way.get(self.first + 1..).unwrap_or_default() {
            sink(segment, pen)?;
        }
        for _ in 0..self.turns {
            for segment in self.way {
                sink(segment, pen)?;
            }
        }
        // The level itself, where rounding left a trace.
        pen.plunge(to)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_by_hand() {
        let tan = |a, b| slope(a, b, "beta").unwrap();
        assert_eq!(tan(0.0, 0.0), None);
        assert_eq!(tan(90.0, 0.0), None);
        assert!((tan(45.0, 0.0).unwrap() - 1.0).abs() < 1e-12);
        assert!((tan(60.0, 45.0).unwrap() - 1.0).abs() < 1e-12);
        assert!((tan(0.0, 45.0).unwrap() - 1.0).abs() < 1e-12);
        assert_eq!(slope(91.0, 0.0, "beta").unwrap_err().problem, Problem::EntryAngle);
    }

    #[test]
    fn begins_so_that_it_ends_at_the_end() {
        // A square of 4 · 10; 45°: 56 of height are one turn and 16 more.
        let corners = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]];
        let way: Vec<Segment> =
            (0..4).map(|k| Segment::Line { from: corners[k], to: corners[(k + 1) % 4] }).collect();
        let descent = Descent::new(&way, 56.0, Some(1.0));
        assert_eq!((descent.start(), descent.turns), ([6.0, 10.0], 1));
        assert_eq!(Descent::new(&way, 56.0, None).start(), [0.0, 0.0]);
    }
}
