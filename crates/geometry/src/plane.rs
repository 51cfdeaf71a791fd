//! The working planes G17, G18, G19.

use crate::position::{Axis, Position};

/// A working plane. Its two axes and its normal form a right-handed system, so that
/// counter-clockwise is seen from the positive end of the normal in every plane (ISO 6983).
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Plane {
    /// G17: X then Y, normal Z.
    #[default]
    Xy,
    /// G18: Z then X, normal Y.
    Zx,
    /// G19: Y then Z, normal X.
    Yz,
}

impl Plane {
    /// First axis of the plane.
    #[inline]
    pub fn first(self) -> Axis {
        match self {
            Plane::Xy => Axis::X,
            Plane::Zx => Axis::Z,
            Plane::Yz => Axis::Y,
        }
    }

    /// Second axis of the plane.
    #[inline]
    pub fn second(self) -> Axis {
        match self {
            Plane::Xy => Axis::Y,
            Plane::Zx => Axis::X,
            Plane::Yz => Axis::Z,
        }
    }

    /// The axis square to the plane.
    #[inline]
    pub fn normal(self) -> Axis {
        match self {
            Plane::Xy => Axis::Z,
            Plane::Zx => Axis::Y,
            Plane::Yz => Axis::X,
        }
    }

    /// The name used in traces.
    pub fn name(self) -> &'static str {
        match self {
            Plane::Xy => "xy",
            Plane::Zx => "zx",
            Plane::Yz => "yz",
        }
    }

    /// The two coordinates of `p` in this plane.
    #[inline]
    pub fn of(self, p: Position) -> [f64; 2] {
        [p[self.first()], p[self.second()]]
    }
}
