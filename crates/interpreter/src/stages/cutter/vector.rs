//! The few operations on plane vectors that the stage needs.

/// A point or a vector of the compensation plane, mm.
pub(super) type Point = [f64; 2];

pub(super) fn add([ax, ay]: Point, [bx, by]: Point) -> Point {
    [ax + bx, ay + by]
}

pub(super) fn sub([ax, ay]: Point, [bx, by]: Point) -> Point {
    [ax - bx, ay - by]
}

pub(super) fn scale([x, y]: Point, k: f64) -> Point {
    [x * k, y * k]
}

/// `p + v·k`.
pub(super) fn along(p: Point, v: Point, k: f64) -> Point {
    add(p, scale(v, k))
}

pub(super) fn dot([ax, ay]: Point, [bx, by]: Point) -> f64 {
    ax * bx + ay * by
}

/// Positive where `b` lies to the left of `a`.
pub(super) fn cross([ax, ay]: Point, [bx, by]: Point) -> f64 {
    ax * by - ay * bx
}

/// A quarter turn to the left.
pub(super) fn left([x, y]: Point) -> Point {
    [-y, x]
}

pub(super) fn length([x, y]: Point) -> f64 {
    x.hypot(y)
}

pub(super) fn distance(a: Point, b: Point) -> f64 {
    length(sub(a, b))
}

/// Signed angle from `a` to `b` in (−π, π], rad. Accurate for small angles, where a difference of two
/// arc tangents is not.
pub(super) fn angle(a: Point, b: Point) -> f64 {
    cross(a, b).atan2(dot(a, b))
}

/// The vector of length 1 in the direction of `v`; none for a vector that has no direction.
pub(super) fn unit(v: Point) -> Option<Point> {
    let l = length(v);
    (l > f64::MIN_POSITIVE && l.is_finite()).then(|| scale(v, 1.0 / l)).filter(|&u| finite(u))
}

pub(super) fn finite([x, y]: Point) -> bool {
    x.is_finite() && y.is_finite()
}
