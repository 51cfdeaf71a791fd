//! Joints: how one move runs into the next.
//!
//! At a joint the direction `q'` jumps by `Δ`. Run through at speed `v`, the axes would have to change
//! their velocity by `Δ·v` in no time. There are three ways out:
//!
//! - **Rest** where the direction changes by more than 20° ([`BLEND_CHORD`]), where the program asks for
//!   it, and between positioning and cutting. The path comes to rest on the programmed point.
//! - **Through** where `Δ` is no more than rounding: the jump is then lost in the margin of acceleration
//!   that planning keeps ([`JOINT_SHARE`]).
//! - **Blend** otherwise: a stretch of length `h` on both sides is replaced by a curve that meets both
//!   moves in position and direction. Between lines it is the parabola with `q'' = Δ/2h`; where an arc
//!   takes part, the cubic Hermite curve, of which the parabola is the special case. The path is then C¹
//!   with bounded `q''`, and velocity is continuous.
//!
//! Deviation. A kink `Δ` at the middle leaves the parabola `|Δ|·h/4` away from the vertex. What an arc of
//! curvature `κ` adds is the error of Hermite interpolation over `2h`: in the middle, with the Peano kernel
//! `|t|/2 − h/4`, at most `κh²/4`; twice that is allowed for. Both add up, point by point at the same
//! `s`, so the distance in both directions (the missed vertex too) keeps
//!
//! ```text
//! |Δ|·h/4 + κ·h²/2 ≤ tolerance
//! ```
//!
//! and `h` is the largest that does, at most half of either move.

use crate::limits::{Bound, Class, Inverse, MAX_FEED_OVERRIDE};
use crate::moves::{Kind, Move};
use crate::piece::Piece;
use ferrocut_geometry::{AXES, Position};
use ferrocut_toolpath::PathMode;

/// Joints that turn by no more than 20° are taken as points on a curve and blended: above what a CAM
/// raster or a coarsely sampled circle has, below any corner that a drawing shows. This is 2·sin(20°/2),
/// the distance of the unit vectors.
const BLEND_CHORD: f64 = 0.347_296_355_333_860_7;

/// Share of the acceleration, over one servo period, that the jumps of direction at joints run through
/// without a blend may take. With the share that the path takes (see [`crate::limits`]) it stays under
/// the whole.
const JOINT_SHARE: f64 = 0.0005;

/// Joints that would have to be run through slower than this come to rest, mm/s.
const CRAWL: f64 = 1.0;

/// Angle of an arc that a blend may take away on either side, radians; far inside the range of the
/// estimate above.
const BLEND_ARC: f64 = 0.25;

/// Shortest half of a blend, mm.
const LEAST_BLEND: f64 = 1e-9;

/// A move whose end is still open: its curve and what is needed to join the next one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Member {
    pub tag: u64,
    pub piece: Piece,
    pub class: Class,
    /// Programmed speed along `s`, mm/s; infinite for rapids.
    pub feed: f64,
    /// Bound of a line as a whole; of arcs only the feed holds.
    pub bound: Bound,
    /// How far the joint after it may leave the programmed path, mm; `None` is an exact stop.
    tolerance: Option<f64>,
}

/// How two moves are joined.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) enum Joint {
    /// Comes to rest.
    Rest,
    /// Runs through at no more than this speed squared.
    Through(f64),
    /// Blended over this length on both sides, mm.
    Blend(f64),
}

/// Settings of the machine that joints depend on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct JointRules {
    pub tolerance: f64,
    pub exact_stop: bool,
    /// Servo period, s.
    pub period: f64,
}

impl Member {
    /// The move `m` from `from`; `None` where nothing moves.
    pub fn new(from: Position, m: &Move, rules: &JointRules, inverse: &Inverse) -> Option<Member> {
        let piece = Piece::new(from, m)?;
        let (feed, path) = match m.kind {
            Kind::RapidAxes => (f64::INFINITY, PathMode::ContinuousWithin(0.0)),
            Kind::RapidStraight { speed } => (speed, PathMode::ContinuousWithin(0.0)),
            Kind::Line { feed, path } | Kind::Arc { feed, path, .. } => (feed, path),
        };
        let class = match (m.kind, path) {
            (Kind::RapidAxes | Kind::RapidStraight { .. }, _) => Class::Rapid,
            (_, PathMode::Tapping) => Class::Locked,
            (_, PathMode::FullFeed) => Class::Full,
            _ => Class::Cut,
        };
        let tolerance = match path {
            _ if rules.exact_stop => None,
            PathMode::ExactStop => None,
            // The slow-down at inner corners does not act yet; the path is the same.
            PathMode::Continuous | PathMode::InnerCorners(_) | PathMode::Tapping | PathMode::FullFeed => {
                Some(rules.tolerance)
            }
            PathMode::ContinuousWithin(t) => Some(if t.is_finite() { t.max(0.0) } else { rules.tolerance }),
        };
        let bound = match &piece {
            Piece::Line(line) => inverse.straight(class, &line.dir.0, feed),
            _ => Bound { w_max: (feed * MAX_FEED_OVERRIDE).powi(2), feed, a0: 0.0, fade: 0.0 },
        };
        Some(Member { tag: m.tag, piece, class, feed, bound, tolerance })
    }

    /// How this move runs into `next`.
    pub fn join(&self, next: &Member, rules: &JointRules, inverse: &Inverse) -> Joint {
        let Some(tolerance) = self.tolerance else { return Joint::Rest };
        let is_rapid = self.class == Class::Rapid;
        if is_rapid != (next.class == Class::Rapid) || !same_measure(&self.piece, &next.piece) {
            return Joint::Rest;
        }
        let (len, next_len) = (self.piece.len(), next.piece.len());
        let (before, after) = (self.piece.tangent(len), next.piece.tangent(0.0));
        let jump = after - before;
        let top = self.bound.w_max.min(next.bound.w_max).sqrt();
        // Several joints may fall into the two periods that an acceleration is seen over.
        let crowd = (2.0 * top * rules.period / len.min(next_len)).max(1.0);
        let through =
            JOINT_SHARE * rules.period / (inverse.change_time(&jump.0) * crowd).max(f64::MIN_POSITIVE);
        if through >= top {
            return Joint::Through(f64::INFINITY);
        }
        // Rotary axes that turn much a millimetre would hide a reversal of X, Y, Z.
        if turn(&before.0, &after.0).max(turn(&before.0[..3], &after.0[..3])) > BLEND_CHORD {
            return Joint::Rest;
        }
        let delta = norm(&jump.0) / 4.0;
        let bend = self.piece.curvature().max(next.piece.curvature());
        let h = (2.0 * tolerance / (delta + (delta * delta + 2.0 * bend * tolerance).sqrt()))
            .min(len / 2.0)
            .min(next_len / 2.0)
            .min(BLEND_ARC / bend);
        if h > LEAST_BLEND && !is_rapid {
            Joint::Blend(h)
        } else if through >= CRAWL {
            Joint::Through(through * through)
        } else {
            Joint::Rest
        }
    }
}

fn same_measure(a: &Piece, b: &Piece) -> bool {
    use crate::moves::Measure::Xyz;
    let measure = |p: &Piece| match p {
        Piece::Line(line) => Some(line.measure),
        Piece::Arc(_) => Some(Xyz),
        Piece::Axes { .. } => None,
    };
    measure(a).is_some() && measure(a) == measure(b)
}

fn norm(v: &[f64]) -> f64 {
    v.iter().map(|c| c * c).sum::<f64>().sqrt()
}

/// How much two directions differ: the distance of their unit vectors, which keeps the small angles that
/// `acos` loses. 0 if both vectors vanish; 2 if one does.
fn turn(a: &[f64], b: &[f64]) -> f64 {
    let (na, nb) = (norm(a), norm(b));
    if na == 0.0 || nb == 0.0 {
        return if na == nb { 0.0 } else { 2.0 };
    }
    a.iter().zip(b).map(|(a, b)| (a / na - b / nb).powi(2)).sum::<f64>().sqrt()
}

/// The curve that replaces a joint: `p + d·s + c₂·s² + c₃·s³`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Blend {
    pub p: Position,
    pub d: Position,
    pub c2: Position,
    pub c3: Position,
    pub len: f64,
}

impl Blend {
    /// The blend of half length `h` between the end of `a` and the start of `b`.
    pub fn new(a: &Piece, b: &Piece, h: f64) -> Blend {
        let len = 2.0 * h;
        let (sa, sb) = (a.len() - h, h);
        let (da, db) = (a.tangent(sa), b.tangent(sb));
        if let (Piece::Line(_), Piece::Line(_)) = (a, b) {
            // From the programmed vertex: a difference of two points would lose digits over a short blend.
            let p = a.end().zip(da, |p, d| p - d * h);
            return Blend { p, d: da, c2: db.zip(da, |b, a| (b - a) / (2.0 * len)), c3: Position::ZERO, len };
        }
        let (p, end) = (a.at(sa), b.at(sb));
        let mean = (end - p).zip(p, |d, _| d / len);
        let c2 = Position(std::array::from_fn(|i| (3.0 * mean.0[i] - 2.0 * da.0[i] - db.0[i]) / len));
        let c3 = Position(std::array::from_fn(|i| (da.0[i] + db.0[i] - 2.0 * mean.0[i]) / (len * len)));
        Blend { p, d: da, c2, c3, len }
    }

    /// `q(s)`.
    #[inline]
    pub fn at(&self, s: f64) -> Position {
        Position(std::array::from_fn(|i| {
            self.p.0[i] + s * (self.d.0[i] + s * (self.c2.0[i] + s * self.c3.0[i]))
        }))
    }

    /// The Bézier points of `q'`, which is quadratic and stays inside their hull.
    fn hull(&self) -> [Position; 3] {
        let n = self.len;
        let middle = self.d.zip(self.c2, |d, c2| d + c2 * n);
        let end = middle.zip(self.c2, |m, c2| m + c2 * n).zip(self.c3, |e, c3| e + 3.0 * c3 * n * n);
        [self.d, middle, end]
    }

    /// Largest `|q'|` over X, Y, Z, at least 1.
    pub fn stretch(&self) -> f64 {
        self.hull().iter().map(|d| norm(&d.0[..3])).fold(1.0, f64::max)
    }

    /// Bounds of `|q'|` and `|q''|`; the latter is linear and largest at an end.
    pub fn derivatives(&self) -> ([f64; AXES], [f64; AXES]) {
        let hull = self.hull();
        let first = std::array::from_fn(|i| hull.iter().fold(0.0, |m: f64, d| m.max(d.0[i].abs())));
        let second = std::array::from_fn(|i| {
            let (c2, c3) = (self.c2.0[i], self.c3.0[i]);
            (2.0 * c2).abs().max((2.0 * c2 + 6.0 * c3 * self.len).abs())
        });
        (first, second)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::moves::Move;

    fn piece(from: Position, m: Option<Move>) -> Piece {
        Piece::new(from, &m.unwrap()).unwrap()
    }

    fn apart(a: Position, b: Position) -> f64 {
        norm(&(a - b).0)
    }

    #[test]
    fn a_blend_meets_both_moves_in_position_and_direction_and_stays_near() {
        let corner = Position::xyz(10.0, 0.0, 1.0);
        let line = |to| Move::line(to, 10.0, PathMode::Continuous, 0);
        let before = piece(Position::ZERO, line(corner));
        let to = Position::xyz(13.0, 1.0, 2.0);
        let center = [9.0, 40.0];
        let sweep = {
            let angle = |p: Position| (p.0[1] - center[1]).atan2(p.0[0] - center[0]);
            angle(to) - angle(corner)
        };
        let arc = Move::arc(to, ferrocut_geometry::Plane::Xy, center, sweep, 10.0, PathMode::Continuous, 0);
        for after in [piece(corner, line(to)), piece(corner, arc)] {
            let h = 0.6;
            let blend = Blend::new(&before, &after, h);
            let speed = |s: f64| {
                let e = 1e-5;
                let d = blend.at(s + e) - blend.at(s - e);
                Position(d.0.map(|c| c / (2.0 * e)))
            };
            assert!(apart(blend.at(0.0), before.at(before.len() - h)) < 1e-12);
            assert!(apart(blend.at(2.0 * h), after.at(h)) < 1e-12);
            assert!(apart(speed(0.0), before.tangent(before.len())) < 1e-7);
            assert!(apart(speed(2.0 * h), after.tangent(h)) < 1e-7);
            let jump = norm(&(after.tangent(0.0) - before.tangent(0.0)).0);
            let allowed = jump * h / 4.0 + after.curvature() * h * h / 2.0;
            let (first, second) = blend.derivatives();
            for k in 0..=100 {
                let s = 2.0 * h * f64::from(k) / 100.0;
                let programmed = if s < h { before.at(before.len() - h + s) } else { after.at(s - h) };
                assert!(apart(blend.at(s), programmed) <= allowed + 1e-12);
                let bend = speed(s + 1e-5) - speed(s - 1e-5);
                for i in 0..AXES {
                    assert!(speed(s).0[i].abs() <= first[i] + 1e-6);
                    assert!((bend.0[i] / 2e-5).abs() <= second[i] + 1e-3);
                }
            }
        }
    }
}
