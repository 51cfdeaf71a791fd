//! The curve of one cell.

use crate::limits::Rates;
use crate::moves::ways;
use crate::path::corner::Corner;
use crate::path::joint::Ease;
use crate::path::piece::Piece;
use crate::quick::larger;
use ferrocut_geometry::{AXES, Position};

/// Where a cell lies; lengths are from the start of the cell.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Shape {
    /// `p + d·s`.
    Line { p: Position, d: Position },
    /// A stretch of a smoothed run.
    Cubic(Cubic),
    /// A slice of a move that begins at this length of it.
    Slice(Piece, f64),
    /// The same, eased at one end.
    Eased(Piece, f64, Ease),
    /// A corner rounded in time.
    Corner(Corner),
    /// Every axis on its own.
    Axes { from: Position, to: Position },
}

impl Shape {
    /// The point at length `s` of the cell; of a corner on its lines, as it is run where it is stopped at.
    #[inline]
    pub fn at(&self, s: f64) -> Position {
        match self {
            Shape::Line { p, d } => p.zip(*d, |p, d| p + d * s),
            Shape::Cubic(cubic) => cubic.at(s),
            Shape::Slice(piece, from) => piece.at(from + s),
            Shape::Eased(piece, from, ease) => piece.at(from + s) + ease.at(from + s),
            Shape::Corner(corner) => corner.square(s),
            Shape::Axes { from, .. } => *from,
        }
    }
}

impl Shape {
    /// `q′`, `q″` and `q‴` of the `N` axes in front at length `s` of the cell, where it is run along a path.
    pub fn derivatives<const N: usize>(&self, s: f64) -> [[f64; N]; 3] {
        let [first, second, third] = match self {
            Shape::Cubic(cubic) => return cubic.derivatives(s),
            Shape::Line { d, .. } => [*d, Position::ZERO, Position::ZERO],
            Shape::Slice(piece, from) => piece.derivatives(from + s),
            Shape::Eased(piece, from, ease) => {
                let at = from + s;
                let [tangent, bend, twist] = piece.derivatives(at);
                let [more_bend, more_twist] = ease.bends(at);
                [tangent + ease.slope(at), bend + more_bend, twist + more_twist]
            }
            Shape::Corner(_) | Shape::Axes { .. } => [Position::ZERO; 3],
        };
        [first, second, third].map(|d| std::array::from_fn(|i| d.0[i]))
    }

    /// Whether other axes than X, Y and Z move in it, where it is run along a path.
    pub fn moves_others(&self) -> bool {
        match self {
            Shape::Cubic(cubic) => cubic.moves_others(),
            Shape::Line { d, .. } => moves_others(d),
            Shape::Slice(piece, _) => piece.moves_others(),
            Shape::Eased(piece, _, ease) => piece.moves_others() || ease.moves_others(),
            Shape::Corner(_) | Shape::Axes { .. } => false,
        }
    }
}

/// Whether other axes than X, Y and Z move in this direction.
pub(crate) fn moves_others(d: &Position) -> bool {
    d.0[3..].iter().any(|c| *c != 0.0)
}

/// `c₀ + c₁·s + c₂·s² + c₃·s³`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cubic {
    pub c: [Position; 4],
    pub len: f64,
}

impl Cubic {
    /// Whether other axes than X, Y and Z move.
    pub fn moves_others(&self) -> bool {
        self.c[1..].iter().any(moves_others)
    }

    /// The point at `s`.
    #[inline]
    pub fn at(&self, s: f64) -> Position {
        let [c0, c1, c2, c3] = &self.c;
        Position(std::array::from_fn(|i| c0.0[i] + s * (c1.0[i] + s * (c2.0[i] + s * c3.0[i]))))
    }

    /// Its derivatives at `s`.
    #[inline]
    pub fn derivatives<const N: usize>(&self, s: f64) -> [[f64; N]; 3] {
        let [_, c1, c2, c3] = &self.c;
        [
            std::array::from_fn(|i| c1.0[i] + s * (2.0 * c2.0[i] + s * 3.0 * c3.0[i])),
            std::array::from_fn(|i| 2.0 * c2.0[i] + s * 6.0 * c3.0[i]),
            std::array::from_fn(|i| 6.0 * c3.0[i]),
        ]
    }

    /// The Bézier points of `q′`, which is quadratic and stays inside their hull.
    fn hull<const N: usize>(&self) -> [[f64; N]; 3] {
        let n = self.len;
        let [_, c1, c2, c3] = &self.c;
        let begin = std::array::from_fn(|i| c1.0[i]);
        let middle = std::array::from_fn(|i| c1.0[i] + c2.0[i] * n);
        let end = std::array::from_fn(|i| c1.0[i] + n * (2.0 * c2.0[i] + 3.0 * c3.0[i] * n));
        [begin, middle, end]
    }

    /// The stretch of it between two lengths.
    pub fn part(&self, from: f64, to: f64) -> Cubic {
        let [first, second, _] = self.derivatives::<AXES>(from);
        let c = [self.at(from), Position(first), Position(second.map(|c| 0.5 * c)), self.c[3]];
        Cubic { c, len: to - from }
    }

    /// How much `|q′|` over what the feed is measured along differs along it, as a share of its highest in three places.
    pub fn unevenness<const N: usize>(&self, share: f64) -> f64 {
        let speeds = [0.0, 0.5, 1.0].map(|at| stretch(&self.derivatives::<N>(at * self.len)[0], share));
        let most = speeds.into_iter().fold(0.0, f64::max);
        1.0 - speeds.into_iter().fold(most, f64::min) / most.max(1e-12)
    }

    /// Bounds of the derivatives, where `q″` is linear and largest at an end, and the largest `|q′|` over what the feed is
    /// measured along ([`stretch`]).
    pub fn rates<const N: usize>(&self, share: f64) -> (Rates<N>, f64) {
        let hull = self.hull::<N>();
        let stretch = if share == 1.0 {
            highest(&hull)
        } else {
            hull.iter().map(|d| stretch(d, share)).fold(0.0, f64::max)
        };
        let rates = Rates {
            first: std::array::from_fn(|i| {
                larger(larger(hull[0][i].abs(), hull[1][i].abs()), hull[2][i].abs())
            }),
            second: std::array::from_fn(|i| {
                let (c2, c3) = (2.0 * self.c[2].0[i], 6.0 * self.c[3].0[i] * self.len);
                larger(c2.abs(), (c2 + c3).abs())
            }),
            third: std::array::from_fn(|i| 6.0 * self.c[3].0[i].abs()),
        };
        (rates, stretch)
    }
}

/// A bound of the length of X, Y and Z of a quadratic with these Bézier points, by the Bézier points of its square, which is one of the
/// fourth degree: on an arc of the angle `θ` it is too much by `θ⁴`, where that of the points themselves is by `θ²/8`.
fn highest<const N: usize>([a, b, c]: &[[f64; N]; 3]) -> f64 {
    let dot = |a: &[f64; N], b: &[f64; N]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let middle = (dot(a, c) + 2.0 * dot(b, b)) / 3.0;
    larger(larger(dot(a, a), dot(c, c)), larger(middle, larger(dot(a, b), dot(b, c)))).sqrt()
}

/// How far what the feed is measured along goes in the direction `d`, against the line there: X, Y and Z, which go the `share` of its
/// length on it; all axes where that is 0.
#[inline]
pub(crate) fn stretch<const N: usize>(d: &[f64; N], share: f64) -> f64 {
    if share == 1.0 {
        return (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt();
    }
    let mut all = [0.0; AXES];
    all[..N].copy_from_slice(d);
    let ways = ways(&all);
    if share > 0.0 { ways[0] / share } else { ways.into_iter().fold(0.0, f64::max) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::moves::Move;
    use crate::path::joint::Ease;
    use ferrocut_toolpath::{Feed, FeedAlong, Op, PathMode};

    /// A spiral helix.
    fn turn() -> Piece {
        let from = Position::xyz(10.0, 0.0, 0.0);
        let op = Op::Arc {
            to: Position::xyz(-1.0, 12.0, 3.0),
            plane: ferrocut_geometry::Plane::Xy,
            center: [0.0, 0.0],
            sweep: 1.654,
            feed: Feed::PerMinute(1000.0),
            feed_along: FeedAlong::Path,
            path: PathMode::Continuous,
        };
        let moves: Vec<Move> = Move::from_step(&op, from, 1000.0, 0).into_iter().collect();
        Piece::new(from, &moves[0]).unwrap()
    }

    #[test]
    fn derivatives_are_those_of_the_points() {
        let p = |x, y, z| Position::xyz(x, y, z);
        let cubic =
            Cubic { c: [p(1.0, 2.0, 3.0), p(1.0, 0.1, 0.0), p(0.2, -0.3, 0.1), p(-0.4, 0.5, 0.2)], len: 2.0 };
        let ease = Ease::example(1.5, p(0.01, -0.02, 0.005), p(0.3, 0.1, 0.0), 1.2);
        let behind = Ease::example(0.0, p(0.01, -0.02, 0.005), p(0.3, 0.1, 0.0), 1.2);
        let line = Shape::Line { p: p(1.0, 0.0, 0.0), d: p(0.6, 0.8, 0.0) };
        let shapes = [
            line,
            Shape::Cubic(cubic),
            Shape::Slice(turn(), 0.7),
            Shape::Eased(turn(), 0.4, ease),
            Shape::Eased(turn(), 0.0, behind),
        ];
        for shape in shapes {
            for s in [0.1, 0.45, 1.0] {
                let h = 1e-3;
                let [a, b, c, d, e] = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|k| shape.at(s + k * h).0);
                let [first, second, third] = shape.derivatives::<AXES>(s);
                for i in 0..3 {
                    let near = |x: f64, y: f64, most: f64| {
                        assert!((x - y).abs() < most, "{shape:?} {s} {i}: {x} {y}")
                    };
                    near(first[i], (a[i] - 8.0 * b[i] + 8.0 * d[i] - e[i]) / (12.0 * h), 1e-9);
                    near(second[i], (b[i] - 2.0 * c[i] + d[i]) / (h * h), 1e-5);
                    near(third[i], (e[i] - 2.0 * d[i] + 2.0 * b[i] - a[i]) / (2.0 * h * h * h), 1e-4);
                }
            }
        }
    }
}
