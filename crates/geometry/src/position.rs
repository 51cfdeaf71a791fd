//! Axes by name, sets of them, and points over all of them.

use std::ops::{Index, IndexMut};

/// Number of axes a [`Position`] holds.
pub const AXES: usize = 9;

/// A machine axis by its programmed name. The order is that of RS274 and of every table here.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
#[repr(u8)]
pub enum Axis {
    /// First linear axis.
    X,
    /// Second linear axis.
    Y,
    /// Third linear axis, along the spindle.
    Z,
    /// Rotary about X.
    A,
    /// Rotary about Y.
    B,
    /// Rotary about Z.
    C,
    /// Second axis parallel to X.
    U,
    /// Second axis parallel to Y.
    V,
    /// Second axis parallel to Z.
    W,
}

impl Axis {
    /// Every axis, in order.
    pub const ALL: [Axis; AXES] =
        [Axis::X, Axis::Y, Axis::Z, Axis::A, Axis::B, Axis::C, Axis::U, Axis::V, Axis::W];

    /// The axis with this address letter, in either case.
    pub fn from_letter(letter: u8) -> Option<Axis> {
        Some(match letter.to_ascii_uppercase() {
            b'X' => Axis::X,
            b'Y' => Axis::Y,
            b'Z' => Axis::Z,
            b'A' => Axis::A,
            b'B' => Axis::B,
            b'C' => Axis::C,
            b'U' => Axis::U,
            b'V' => Axis::V,
            b'W' => Axis::W,
            _ => return None,
        })
    }

    /// The upper-case address letter.
    pub fn letter(self) -> char {
        char::from(b"XYZABCUVW"[self as usize])
    }

    /// The name used in traces and samples: the lower-case letter.
    pub fn name(self) -> &'static str {
        ["x", "y", "z", "a", "b", "c", "u", "v", "w"][self as usize]
    }

    /// Place of the axis in a [`Position`].
    pub fn index(self) -> usize {
        self as usize
    }

    /// Whether positions of this axis are lengths, which scaling and inch input act on.
    /// A, B and C are angles in degrees.
    pub fn is_linear(self) -> bool {
        !matches!(self, Axis::A | Axis::B | Axis::C)
    }
}

/// A set of axes, one bit each.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub struct AxisSet(u16);

impl AxisSet {
    /// No axis.
    pub const EMPTY: AxisSet = AxisSet(0);

    /// The set with `axis` added.
    pub fn with(self, axis: Axis) -> AxisSet {
        AxisSet(self.0 | 1 << axis as u16)
    }

    /// Whether `axis` is in the set.
    pub fn contains(self, axis: Axis) -> bool {
        self.0 & (1 << axis as u16) != 0
    }

    /// Whether no axis is in the set.
    pub fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// How many axes are in the set.
    pub fn len(self) -> usize {
        self.0.count_ones() as usize
    }

    /// The set with these bits, in the order of [`Axis`]; bits beyond the axes are left out.
    #[inline]
    pub const fn from_bits(bits: u16) -> AxisSet {
        AxisSet(bits & ((1 << AXES as u16) - 1))
    }

    /// The axes that are in both.
    #[inline]
    pub const fn and(self, other: AxisSet) -> AxisSet {
        AxisSet(self.0 & other.0)
    }

    /// The axes in the set, in order.
    #[inline]
    pub fn iter(self) -> impl Iterator<Item = Axis> {
        let mut left = self.0;
        std::iter::from_fn(move || {
            let axis = Axis::ALL.get(left.trailing_zeros() as usize).copied()?;
            left &= left - 1;
            Some(axis)
        })
    }
}

impl FromIterator<Axis> for AxisSet {
    fn from_iter<I: IntoIterator<Item = Axis>>(axes: I) -> AxisSet {
        axes.into_iter().fold(AxisSet::EMPTY, AxisSet::with)
    }
}

/// A point over all axes: mm for linear axes, degrees for rotary ones.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Position(pub [f64; AXES]);

impl Position {
    /// The point with every coordinate 0.
    pub const ZERO: Position = Position([0.0; AXES]);

    /// A point given by its first three coordinates.
    pub fn xyz(x: f64, y: f64, z: f64) -> Position {
        Position([x, y, z, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])
    }

    /// Coordinate-wise combination of two points.
    #[inline]
    pub fn zip(self, other: Position, f: impl Fn(f64, f64) -> f64) -> Position {
        Position(std::array::from_fn(|i| f(self.0[i], other.0[i])))
    }

    /// Coordinate-wise smaller of the two.
    #[inline]
    pub fn min(self, other: Position) -> Position {
        self.zip(other, f64::min)
    }

    /// Coordinate-wise larger of the two.
    #[inline]
    pub fn max(self, other: Position) -> Position {
        self.zip(other, f64::max)
    }

    /// The point a fraction `t` of the straight way to `end`.
    #[inline]
    pub fn lerp(self, end: Position, t: f64) -> Position {
        self.zip(end, |a, b| a + (b - a) * t)
    }

    /// Length of the straight move to `end`, taken as controllers take it for feed: over the linear
    /// axes X, Y, Z; where these stand still over U, V, W; where these stand still too, over the
    /// rotary axes in degrees (RS274/NGC 2.1.2.5).
    pub fn distance(self, end: Position) -> f64 {
        let norm = |from: usize| {
            let d = |i: usize| end.0[i] - self.0[i];
            (d(from) * d(from) + d(from + 1) * d(from + 1) + d(from + 2) * d(from + 2)).sqrt()
        };
        [0, 6, 3].into_iter().map(norm).find(|d| *d > 0.0).unwrap_or(0.0)
    }

    /// Whether every coordinate is finite.
    pub fn is_finite(self) -> bool {
        self.0.iter().all(|c| c.is_finite())
    }
}

impl std::ops::Add for Position {
    type Output = Position;
    #[inline]
    fn add(self, other: Position) -> Position {
        self.zip(other, |a, b| a + b)
    }
}

impl std::ops::Sub for Position {
    type Output = Position;
    #[inline]
    fn sub(self, other: Position) -> Position {
        self.zip(other, |a, b| a - b)
    }
}

impl Index<Axis> for Position {
    type Output = f64;
    #[inline]
    fn index(&self, axis: Axis) -> &f64 {
        &self.0[axis as usize]
    }
}

impl IndexMut<Axis> for Position {
    #[inline]
    fn index_mut(&mut self, axis: Axis) -> &mut f64 {
        &mut self.0[axis as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_set_gives_its_axes_back_in_order() {
        for bits in 0..1u16 << AXES {
            let set = AxisSet::from_bits(bits);
            let axes: Vec<Axis> = set.iter().collect();
            assert_eq!(axes.len(), set.len());
            assert!(axes.windows(2).all(|w| w[0] < w[1]));
            assert_eq!(axes.into_iter().collect::<AxisSet>(), set);
            assert_eq!(set.is_empty(), bits == 0);
        }
        assert_eq!(AxisSet::from_bits(u16::MAX).len(), AXES);
    }
}
