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
    Line {
        p: Position,
        d: Position,
    },
    Smooth(Smooth),
    /// A slice of a move that begins at this length of it.
    Slice(Piece, f64),
    /// The same, eased at one end.
    Eased(Piece, f64, Ease),
    /// A corner rounded in time.
    Corner(Corner),
    /// Every axis on its own.
    Axes {
        from: Position,
        to: Position,
    },
}

impl Shape {
    /// The point at length `s` of the cell; of a corner on its lines, as it is run where it is stopped at.
    #[inline]
    pub fn at(&self, s: f64) -> Position {
        match self {
            Shape::Line { p, d } => p.zip(*d, |p, d| p + d * s),
            Shape::Smooth(curve) => curve.at(s),
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
            Shape::Smooth(Smooth::Xyz(cubic, _)) => return cubic.derivatives(s),
            Shape::Smooth(Smooth::All(cubic)) => return cubic.derivatives(s),
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
            Shape::Smooth(Smooth::Xyz(..)) => false,
            Shape::Smooth(Smooth::All(cubic)) => cubic.c[1..].iter().any(|c| c[3..] != [0.0; AXES - 3]),
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

/// A stretch of a smoothed run.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Smooth {
    /// In X, Y and Z, and where the other axes stand: most are, and this is a third of the room of the other.
    Xyz(Cubic<3>, [f64; AXES - 3]),
    All(Cubic<AXES>),
}

impl Smooth {
    /// With these coefficients of X, Y and Z or of all axes; where there are none, the others stand as they do in `place`.
    #[inline]
    pub fn new<const N: usize>(c: &[[f64; N]; 4], len: f64, place: &Position) -> Smooth {
        if N == 3 {
            let others = std::array::from_fn(|i| place.0[3 + i]);
            Smooth::Xyz(Cubic { c: c.map(|c| std::array::from_fn(|i| c[i])), len }, others)
        } else {
            Smooth::All(Cubic { c: c.map(|c| std::array::from_fn(|i| c[i])), len })
        }
    }

    #[inline]
    fn at(&self, s: f64) -> Position {
        match self {
            Smooth::Xyz(cubic, others) => with_others(&cubic.at(s), others),
            Smooth::All(cubic) => Position(cubic.at(s)),
        }
    }

    /// The line that it is where it is straight.
    pub fn line(&self) -> Shape {
        let [p, d] = match self {
            Smooth::Xyz(cubic, others) => {
                [with_others(&cubic.c[0], others), with_others(&cubic.c[1], &[0.0; AXES - 3])]
            }
            Smooth::All(cubic) => [cubic.c[0], cubic.c[1]].map(Position),
        };
        Shape::Line { p, d }
    }
}

/// All axes.
#[inline]
fn with_others(xyz: &[f64; 3], others: &[f64; AXES - 3]) -> Position {
    let mut all = [0.0; AXES];
    all[..3].copy_from_slice(xyz);
    all[3..].copy_from_slice(others);
    Position(all)
}

/// `c₀ + c₁·s + c₂·s² + c₃·s³` of the axes in front.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cubic<const N: usize> {
    pub c: [[f64; N]; 4],
    pub len: f64,
}

impl<const N: usize> Cubic<N> {
    /// The point at `s`.
    #[inline]
    pub fn at(&self, s: f64) -> [f64; N] {
        let [c0, c1, c2, c3] = &self.c;
        std::array::from_fn(|i| c0[i] + s * (c1[i] + s * (c2[i] + s * c3[i])))
    }

    /// The derivatives of so many axes at `s`; those that it has none of stand.
    #[inline]
    pub fn derivatives<const M: usize>(&self, s: f64) -> [[f64; M]; 3] {
        let [_, c1, c2, c3] = &self.c;
        let mut at = [[0.0; M]; 3];
        for i in 0..N.min(M) {
            at[0][i] = c1[i] + s * (2.0 * c2[i] + s * 3.0 * c3[i]);
            at[1][i] = 2.0 * c2[i] + s * 6.0 * c3[i];
            at[2][i] = 6.0 * c3[i];
        }
        at
    }

    /// The Bézier points of `q′`, which is quadratic and stays inside their hull.
    fn hull(&self) -> [[f64; N]; 3] {
        let n = self.len;
        let [_, c1, c2, c3] = &self.c;
        let middle = std::array::from_fn(|i| c1[i] + c2[i] * n);
        let end = std::array::from_fn(|i| c1[i] + n * (2.0 * c2[i] + 3.0 * c3[i] * n));
        [*c1, middle, end]
    }

    /// The stretch of it between two lengths.
    pub fn part(&self, from: f64, to: f64) -> Cubic<N> {
        let [first, second, _] = self.derivatives::<N>(from);
        Cubic { c: [self.at(from), first, second.map(|c| 0.5 * c), self.c[3]], len: to - from }
    }

    /// How much `|q′|` over what the feed is measured along differs along it, as a share of its highest in three places.
    pub fn unevenness(&self, share: f64) -> f64 {
        let speeds = [0.0, 0.5, 1.0].map(|at| stretch(&self.derivatives::<N>(at * self.len)[0], share));
        let most = speeds.into_iter().fold(0.0, f64::max);
        1.0 - speeds.into_iter().fold(most, f64::min) / most.max(1e-12)
    }

    /// Bounds of the derivatives, where `q″` is linear and largest at an end, and the largest `|q′|` over what the feed is
    /// measured along ([`stretch`]).
    pub fn rates(&self, share: f64) -> (Rates<N>, f64) {
        let hull = self.hull();
        let stretch = hull.iter().map(|d| stretch(d, share)).fold(0.0, f64::max);
        let rates = Rates {
            first: std::array::from_fn(|i| {
                larger(larger(hull[0][i].abs(), hull[1][i].abs()), hull[2][i].abs())
            }),
            second: std::array::from_fn(|i| {
                let (c2, c3) = (2.0 * self.c[2][i], 6.0 * self.c[3][i] * self.len);
                larger(c2.abs(), (c2 + c3).abs())
            }),
            third: std::array::from_fn(|i| 6.0 * self.c[3][i].abs()),
        };
        (rates, stretch)
    }
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
        let c = [[1.0, 2.0, 3.0], [1.0, 0.1, 0.0], [0.2, -0.3, 0.1], [-0.4, 0.5, 0.2]];
        let others = [4.0, 5.0, 6.0, 7.0, 8.0, 9.0];
        let xyz = Smooth::Xyz(Cubic { c, len: 2.0 }, others);
        let all = c.map(|c| with_others(&c, &[0.0; AXES - 3]).0);
        let all = Smooth::All(Cubic { c: [with_others(&c[0], &others).0, all[1], all[2], all[3]], len: 2.0 });
        assert_eq!(xyz.at(0.7), all.at(0.7));
        let ease = Ease::example(1.5, p(0.01, -0.02, 0.005), p(0.3, 0.1, 0.0), 1.2);
        let behind = Ease::example(0.0, p(0.01, -0.02, 0.005), p(0.3, 0.1, 0.0), 1.2);
        let line = Shape::Line { p: p(1.0, 0.0, 0.0), d: p(0.6, 0.8, 0.0) };
        let shapes = [
            line,
            Shape::Smooth(xyz),
            Shape::Smooth(all),
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
