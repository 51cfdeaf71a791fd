//! What a drawing may hold at most, so that no file can fill the memory or run for ever.

use ferrocut_geometry::vector::Point;
use ferrocut_machine::{Alarm, Fault};
use ferrocut_program::Span;

/// Largest file, bytes: a million entities.
pub const MOST_BYTES: u64 = 256 << 20;
/// Lines and arcs of a drawing, blocks written out: with the ways between them half a gigabyte.
pub const MOST_CURVES: usize = 1_000_000;
/// Points that curves may be divided into on the way to arcs.
const MOST_POINTS: u64 = 50_000_000;
/// Points of one curve.
const MOST_POINTS_OF_ONE: f64 = 1_000_000.0;
/// Blocks inserted.
const MOST_INSERTS: u64 = 1_000_000;
/// Largest coordinate, mm: the longest words of controls hold 99999.9999.
pub const FURTHEST: f64 = 99_999.0;

/// Why a drawing is refused; the place is added by who knows it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Refused {
    /// More than the named number.
    TooMany(&'static str, f64),
    /// A coordinate out of reach, mm.
    TooFar(f64),
}

impl Refused {
    /// The alarm at its place.
    pub fn at(self, span: Span) -> Box<Alarm> {
        Box::new(match self {
            Refused::TooMany(what, most) => Alarm::core(Fault::DrawingTooLarge, span).with(what, most),
            Refused::TooFar(position) => {
                Alarm::core(Fault::DrawingTooFar, span).with("position", position).with("limit", FURTHEST)
            }
        })
    }
}

/// What is left of the numbers above.
pub struct Limits {
    points: u64,
    inserts: u64,
}

impl Limits {
    /// Nothing used yet.
    pub fn new() -> Limits {
        Limits { points: MOST_POINTS, inserts: MOST_INSERTS }
    }

    /// Takes the points of one curve.
    pub fn points(&mut self, count: f64) -> Result<usize, Refused> {
        if count.is_nan() || count > MOST_POINTS_OF_ONE {
            return Err(Refused::TooMany("points", MOST_POINTS_OF_ONE));
        }
        self.points =
            self.points.checked_sub(count as u64).ok_or(Refused::TooMany("points", MOST_POINTS as f64))?;
        Ok(count as usize)
    }

    /// Takes one more point of a curve that has `already` as many.
    pub fn point(&mut self, already: usize) -> Result<(), Refused> {
        if already as f64 >= MOST_POINTS_OF_ONE {
            return Err(Refused::TooMany("points", MOST_POINTS_OF_ONE));
        }
        self.points(1.0).map(|_| ())
    }

    /// Takes one inserted block.
    pub fn insert(&mut self) -> Result<(), Refused> {
        self.inserts = self.inserts.checked_sub(1).ok_or(Refused::TooMany("inserts", MOST_INSERTS as f64))?;
        Ok(())
    }

    /// Holds a point to what a machine can reach.
    pub fn reach(&self, point: Point) -> Result<(), Refused> {
        match point.into_iter().find(|c| c.is_nan() || c.abs() > FURTHEST) {
            Some(far) => Err(Refused::TooFar(far)),
            None => Ok(()),
        }
    }
}

impl Default for Limits {
    fn default() -> Limits {
        Limits::new()
    }
}
