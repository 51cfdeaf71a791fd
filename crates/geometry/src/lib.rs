//! Pure geometry of a machine tool with up to nine axes.
//!
//! In: numbers. Out: numbers. Nothing here knows of programs, machines or time.
//! Lengths are millimetres, angles radians unless a name says degrees.
//!
//! Read [`position`] first (axes and points), then [`arc`] (arcs and helices). Splines become lines and arcs
//! of the plane ([`curve`]) in [`spline`] and [`fit`](mod@fit).

pub mod arc;
pub mod axis_names;
pub mod curve;
pub mod fit;
pub mod plane;
pub mod position;
pub mod spline;
pub mod vector;

pub use arc::{Arc, RadiusError, Turn};
pub use axis_names::{AxisName, AxisNames};
pub use plane::Plane;
pub use position::{AXES, Axis, AxisSet, Position};

/// Millimetres in one inch, exact by definition.
pub const MM_PER_INCH: f64 = 25.4;

/// Two points closer than this are the same point: a thousandth of the finest increment that any of
/// the controls can program (0.0001 mm), yet far above the rounding of sums of `f64` coordinates.
pub const SAME_POINT_MM: f64 = 1e-7;
