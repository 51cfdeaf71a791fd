//! Points and directions of the plane as pairs.

pub(crate) fn add(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] + b[0], a[1] + b[1]]
}

pub(crate) fn sub(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

/// The point `t` times `d` beyond `p`.
pub(crate) fn along(p: [f64; 2], d: [f64; 2], t: f64) -> [f64; 2] {
    [p[0] + d[0] * t, p[1] + d[1] * t]
}

pub(crate) fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

pub(crate) fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

pub(crate) fn length(v: [f64; 2]) -> f64 {
    // Lengths of a drawing are far from where squares overflow, and `hypot` is slow.
    dot(v, v).sqrt()
}

pub(crate) fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    length(sub(a, b))
}

/// A quarter turn to the left.
pub(crate) fn left(v: [f64; 2]) -> [f64; 2] {
    [-v[1], v[0]]
}

/// The direction of `v`; `None` where there is none.
pub(crate) fn unit(v: [f64; 2]) -> Option<[f64; 2]> {
    let l = length(v);
    (l > 1e-12 && l.is_finite()).then(|| [v[0] / l, v[1] / l])
}

/// `v` turned by an angle, counter-clockwise.
pub(crate) fn turned(v: [f64; 2], angle: f64) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    [v[0] * cos - v[1] * sin, v[0] * sin + v[1] * cos]
}

/// The angle from `a` to `b`, −π…π, counter-clockwise positive.
pub(crate) fn angle(a: [f64; 2], b: [f64; 2]) -> f64 {
    cross(a, b).atan2(dot(a, b))
}
