//! The box that a set of points fills.

/// A point over X, Y, Z, mm.
pub type Point3 = [f64; 3];

/// Smallest and largest coordinates of some points, mm.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Extent {
    /// Smallest coordinates.
    pub min: Point3,
    /// Largest coordinates.
    pub max: Point3,
}

impl Extent {
    /// The box of no points.
    pub const EMPTY: Extent = Extent { min: [f64::INFINITY; 3], max: [f64::NEG_INFINITY; 3] };

    /// Whether no point was added.
    pub fn is_empty(&self) -> bool {
        self.min[0] > self.max[0]
    }

    /// Takes in a point.
    pub fn add(&mut self, p: Point3) {
        self.min = zip(self.min, p, f64::min);
        self.max = zip(self.max, p, f64::max);
    }

    /// The box of both.
    pub fn union(&self, other: &Extent) -> Extent {
        Extent { min: zip(self.min, other.min, f64::min), max: zip(self.max, other.max, f64::max) }
    }

    /// Lengths of the sides, mm; 0 where empty.
    pub fn size(&self) -> Point3 {
        zip(self.max, self.min, |a, b| (a - b).max(0.0))
    }

    /// Length of the longest side, mm.
    pub fn longest(&self) -> f64 {
        self.size().into_iter().fold(0.0, f64::max)
    }

    /// The eight corners.
    pub fn corners(&self) -> [Point3; 8] {
        let pick = |i: usize, bit: usize, low: f64, high: f64| if i & bit == 0 { low } else { high };
        std::array::from_fn(|i| {
            [
                pick(i, 1, self.min[0], self.max[0]),
                pick(i, 2, self.min[1], self.max[1]),
                pick(i, 4, self.min[2], self.max[2]),
            ]
        })
    }
}

/// Coordinate-wise combination of two points.
pub fn zip(a: Point3, b: Point3, f: impl Fn(f64, f64) -> f64) -> Point3 {
    [f(a[0], b[0]), f(a[1], b[1]), f(a[2], b[2])]
}
