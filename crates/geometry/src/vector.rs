//! Points and directions of a plane as pairs.
//!
//! Coordinates are far from where their squares would overflow, and `hypot` is slow: lengths are roots of squares.

/// A point or a direction of a plane, mm.
pub type Point = [f64; 2];

/// What is shorter has no direction, mm.
const NO_LENGTH: f64 = 1e-12;

/// `a + b`.
#[inline]
pub fn add(a: Point, b: Point) -> Point {
    [a[0] + b[0], a[1] + b[1]]
}

/// `a − b`, the way from `b` to `a`.
#[inline]
pub fn sub(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1]]
}

/// `v·k`.
#[inline]
pub fn scale(v: Point, k: f64) -> Point {
    [v[0] * k, v[1] * k]
}

/// The point `k` times `v` beyond `p`.
#[inline]
pub fn along(p: Point, v: Point, k: f64) -> Point {
    [p[0] + v[0] * k, p[1] + v[1] * k]
}

/// The scalar product.
#[inline]
pub fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// The area that two vectors span, positive where `b` lies counter-clockwise of `a`.
#[inline]
pub fn cross(a: Point, b: Point) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// The length.
#[inline]
pub fn length(v: Point) -> f64 {
    dot(v, v).sqrt()
}

/// How far two points are apart.
#[inline]
pub fn distance(a: Point, b: Point) -> f64 {
    length(sub(a, b))
}

/// A quarter turn to the left.
#[inline]
pub fn left(v: Point) -> Point {
    [-v[1], v[0]]
}

/// The vector of length 1 in the direction of `v`; `None` where there is none.
pub fn unit(v: Point) -> Option<Point> {
    let l = length(v);
    (l > NO_LENGTH && l.is_finite()).then(|| [v[0] / l, v[1] / l])
}

/// `v` turned by an angle in radians, counter-clockwise.
pub fn turned(v: Point, angle: f64) -> Point {
    let (sin, cos) = angle.sin_cos();
    [v[0] * cos - v[1] * sin, v[0] * sin + v[1] * cos]
}

/// The angle from `a` to `b`, −π…π, counter-clockwise positive. Accurate for small angles, where a difference of two arc tangents
/// is not.
pub fn angle(a: Point, b: Point) -> f64 {
    cross(a, b).atan2(dot(a, b))
}

/// Whether both are numbers.
pub fn finite(v: Point) -> bool {
    v[0].is_finite() && v[1].is_finite()
}
