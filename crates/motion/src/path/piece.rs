//! The geometry of one move over its length.
//!
//! A piece is a curve `q(s)` over all axes, `s` from 0 to [`Piece::len`], where `s` is what the feed is
//! measured along: `|q′| = 1` over the measured coordinates of lines, circles and helices. Where a move turns rotary axes by more,
//! it is along these.
//!
//! An arc with `u = s/len`, angle `φ = φ₀ + σu` and radius `r = r₀ + ρu` (start and end may lie a little
//! off one circle, see [`ferrocut_geometry::arc`]) has in its plane
//!
//! ```text
//! q  = c + r·(cos φ, sin φ)
//! q′ = (ρ·(cos φ, sin φ) + rσ·(−sin φ, cos φ)) / len
//! q″ = (2ρσ·(−sin φ, cos φ) − rσ²·(cos φ, sin φ)) / len²
//! q‴ = (−rσ³·(−sin φ, cos φ) − 3ρσ²·(cos φ, sin φ)) / len³
//! ```
//!
//! and is straight in every other axis.

use crate::limits::Rates;
use crate::moves::{Kind, Move, measured, ways};
use crate::path::shape::moves_others;
use ferrocut_geometry::{AXES, Arc, Position, SAME_POINT_MM};
use std::f64::consts::{FRAC_PI_2, PI};

/// An arc is planned in slices no longer than this angle, each under its own bounds, because the share of
/// an axis in velocity and in acceleration changes as the arc turns.
const SLICE_RAD: f64 = PI / 144.0;

/// Nor are slices shorter than this, mm: an arc that small is slow whatever it is cut into, and a servo
/// period shall not run through thousands of slices.
const LEAST_SLICE: f64 = 1e-4;

/// Arcs with less length in their plane than this are straight.
const STRAIGHT_MM: f64 = 1e-9;

/// The curve of one move.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Piece {
    /// Straight, on a path.
    Line(Line),
    /// Circle or helix.
    Arc(Turn),
    /// Every axis on its own: no path.
    Axes { from: Position, to: Position },
}

/// A straight piece.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Line {
    pub from: Position,
    pub to: Position,
    /// `q′`.
    pub dir: Position,
    /// Length that `s` runs over: the longest of the ways of X, Y, Z, of U, V, W and of A, B, C.
    pub len: f64,
    /// That length over the one that the feed is measured along.
    pub pace: f64,
}

/// A piece of circle or helix.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turn {
    start: Position,
    end: Position,
    /// Indices of the axes of the plane.
    plane: [usize; 2],
    center: [f64; 2],
    angle: f64,
    sweep: f64,
    radius: f64,
    growth: f64,
    /// What the closed form misses at start and end, mm; spread evenly over the arc. A few rounding errors,
    /// unless sweep and end point contradict each other.
    miss: [[f64; 2]; 2],
    /// As of a [`Line`]: the longest of the ways, and that over the one in X, Y, Z.
    pub len: f64,
    pace: f64,
}

impl Piece {
    /// The curve of `m` from `from`; `None` where nothing moves.
    pub fn new(from: Position, m: &Move) -> Option<Piece> {
        match m.kind {
            // One axis alone runs on a line.
            Kind::RapidAxes if from.0.iter().zip(m.to.0).filter(|(a, b)| **a != *b).count() > 1 => {
                Some(Piece::Axes { from, to: m.to })
            }
            Kind::RapidAxes => Line::new(from, m.to).map(Piece::Line),
            Kind::RapidStraight { .. } | Kind::Line { .. } => Line::new(from, m.to).map(Piece::Line),
            Kind::Arc { plane, center, sweep, .. } => {
                let arc = Arc { plane, center, start: from, end: m.to, sweep };
                match Turn::new(&arc) {
                    Some(turn) => Some(Piece::Arc(turn)),
                    None => Line::new(from, m.to).map(Piece::Line),
                }
            }
        }
    }

    /// A straight piece; `None` where nothing moves.
    pub fn line(from: Position, to: Position) -> Option<Piece> {
        Line::new(from, to).map(Piece::Line)
    }

    /// How `s` relates to what the feed is measured along.
    pub fn pace(&self) -> f64 {
        match self {
            Piece::Line(line) => line.pace,
            Piece::Arc(turn) => turn.pace,
            Piece::Axes { .. } => 1.0,
        }
    }

    /// How far X, Y and Z go, as a share of the length that `s` runs over.
    pub fn share(&self) -> f64 {
        match self {
            Piece::Line(line) if line.dir.0[3..] != [0.0; AXES - 3] => ways(&line.dir.0)[0],
            _ => self.pace().recip(),
        }
    }

    /// Whether it is straight, on a path.
    pub fn is_line(&self) -> bool {
        matches!(self, Piece::Line(_))
    }

    /// Where it ends.
    pub fn end(&self) -> Position {
        match self {
            Piece::Line(line) => line.to,
            Piece::Arc(turn) => turn.end,
            Piece::Axes { to, .. } => *to,
        }
    }

    /// Length that `s` runs over.
    pub fn len(&self) -> f64 {
        match self {
            Piece::Line(line) => line.len,
            Piece::Arc(turn) => turn.len,
            Piece::Axes { .. } => 0.0,
        }
    }

    /// Length of the slices that it is planned in.
    pub fn slice(&self) -> f64 {
        match self {
            Piece::Arc(turn) => (turn.len * (SLICE_RAD / turn.sweep.abs())).max(LEAST_SLICE),
            _ => f64::INFINITY,
        }
    }

    /// `q(s)`.
    pub fn at(&self, s: f64) -> Position {
        match self {
            Piece::Line(line) => line.at(s),
            Piece::Arc(turn) => turn.at(s),
            Piece::Axes { from, .. } => *from,
        }
    }

    /// `q′(s)`.
    pub fn tangent(&self, s: f64) -> Position {
        match self {
            Piece::Line(line) => line.dir,
            Piece::Arc(turn) => turn.tangent(s),
            Piece::Axes { .. } => Position::ZERO,
        }
    }

    /// `q″(s)`.
    pub fn bend(&self, s: f64) -> Position {
        match self {
            Piece::Arc(turn) => turn.bend(s),
            _ => Position::ZERO,
        }
    }

    /// `q′`, `q″` and `q‴` at `s`.
    pub fn derivatives(&self, s: f64) -> [Position; 3] {
        match self {
            Piece::Arc(turn) => turn.derivatives(s),
            _ => [self.tangent(s), Position::ZERO, Position::ZERO],
        }
    }

    /// Whether other axes than X, Y and Z move.
    pub fn moves_others(&self) -> bool {
        match self {
            Piece::Line(line) => moves_others(&line.dir),
            Piece::Arc(turn) => moves_others(&(turn.end - turn.start)),
            Piece::Axes { from, to, .. } => moves_others(&(*to - *from)),
        }
    }

    /// The piece as it is seen from its place `s`.
    pub fn seen_from(&self, s: f64) -> Reach {
        match self {
            Piece::Arc(turn) => turn.seen_from(s),
            _ => Reach {
                along: self.tangent(s),
                plane: [0; 2],
                angle: 0.0,
                turn: 0.0,
                radius: 0.0,
                growth: 0.0,
            },
        }
    }

    /// Bounds of the derivatives over `from`…`to`.
    pub fn rates(&self, from: f64, to: f64) -> Rates {
        match self {
            Piece::Line(line) => Rates { first: line.dir.0, second: [0.0; AXES], third: [0.0; AXES] },
            Piece::Arc(turn) => turn.rates(from, to),
            Piece::Axes { .. } => Rates { first: [0.0; AXES], second: [0.0; AXES], third: [0.0; AXES] },
        }
    }

    /// Largest `|q′|` over the measured coordinates in `from`…`to`.
    pub fn stretch(&self, from: f64, to: f64) -> f64 {
        match self {
            Piece::Arc(turn) => turn.stretch(from, to),
            _ => 1.0,
        }
    }
}

/// A piece as it is seen from one of its ends: where it is, by the length `u` from there on, negative before the end.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reach {
    /// What is straight of it.
    along: Position,
    /// Indices of the axes of the plane.
    plane: [u8; 2],
    /// Angle and radius at `u = 0`, and what they change by over a millimetre.
    angle: f64,
    turn: f64,
    radius: f64,
    growth: f64,
}

impl Reach {
    /// From the vertex to the place `u`.
    pub fn at(&self, u: f64) -> Position {
        let mut d = Position(self.along.0.map(|c| c * u));
        if self.turn != 0.0 {
            let ((sin0, cos0), (sin, cos)) = (self.angle.sin_cos(), (self.angle + self.turn * u).sin_cos());
            let r = self.radius + self.growth * u;
            d.0[usize::from(self.plane[0])] += r * cos - self.radius * cos0;
            d.0[usize::from(self.plane[1])] += r * sin - self.radius * sin0;
        }
        d
    }

    /// Bounds of its derivatives as far as `u`.
    pub fn rates(&self, u: f64) -> Rates {
        let mut rates = Rates { first: self.along.0, second: [0.0; AXES], third: [0.0; AXES] };
        if self.turn != 0.0 {
            let turn = self.turn.abs();
            let (r, out) = (self.radius.abs() + (self.growth * u).abs(), self.growth.abs());
            let (slope, bend) = (self.slope(0.0), turn * (r * turn + 2.0 * out));
            for axis in self.plane.map(usize::from) {
                rates.first[axis] = slope.0[axis].abs() + bend * u.abs();
                rates.second[axis] = bend;
                rates.third[axis] = turn * turn * (r * turn + 3.0 * out);
            }
        }
        rates
    }

    /// Its direction there.
    pub fn slope(&self, u: f64) -> Position {
        let mut d = self.along;
        if self.turn != 0.0 {
            let (sin, cos) = (self.angle + self.turn * u).sin_cos();
            let across = (self.radius + self.growth * u) * self.turn;
            d.0[usize::from(self.plane[0])] += self.growth * cos - across * sin;
            d.0[usize::from(self.plane[1])] += self.growth * sin + across * cos;
        }
        d
    }
}

impl Line {
    fn new(from: Position, to: Position) -> Option<Line> {
        let d = to - from;
        let measured = measured(&d)?;
        // Where a rotary axis turns by more degrees than the others go millimetres, its way is the length: so what is hardly
        // more than rounding of the others does not decide how fast the path goes, and moves of it alone are no others.
        let len = ways(&d.0).into_iter().fold(measured, f64::max);
        Some(Line { from, to, dir: Position(d.0.map(|c| c / len)), len, pace: len / measured })
    }

    fn at(&self, s: f64) -> Position {
        self.from.zip(self.dir, |p, d| p + d * s)
    }

    /// Direction and length of a line from its end to `to`, if that is one of X, Y and Z alone as this one is; else `None`.
    /// As [`Line::new`] finds them, but for rounding.
    #[inline]
    pub fn next(&self, to: &Position) -> Option<([f64; 3], f64)> {
        if self.to.0[3..] != to.0[3..] {
            return None;
        }
        let d: [f64; 3] = std::array::from_fn(|i| to.0[i] - self.to.0[i]);
        let len = (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt();
        let inverse = len.recip();
        (len > SAME_POINT_MM && len.is_finite()).then(|| (d.map(|d| d * inverse), len))
    }

    /// From now on it is the line from its end to `to`, with this direction and length.
    #[inline]
    pub fn go_on(&mut self, to: &Position, dir: [f64; 3], len: f64) {
        self.from = self.to;
        self.to.0[..3].copy_from_slice(&to.0[..3]);
        self.dir.0[..3].copy_from_slice(&dir);
        (self.len, self.pace) = (len, 1.0);
    }
}

impl Turn {
    /// `None` if the arc is straight: no angle turned or no radius.
    fn new(arc: &Arc) -> Option<Turn> {
        if arc.plane_length() < STRAIGHT_MM {
            return None;
        }
        let (radius, growth) = (arc.start_radius(), arc.end_radius() - arc.start_radius());
        let own = arc.length().hypot(growth);
        let [_, others @ ..] = ways(&(arc.end - arc.start).0);
        let len = others.into_iter().fold(own, f64::max);
        let mut turn = Turn {
            start: arc.start,
            end: arc.end,
            plane: [arc.plane.first().index(), arc.plane.second().index()],
            center: arc.center,
            angle: arc.start_angle(),
            sweep: arc.sweep,
            radius,
            growth,
            miss: [[0.0; 2]; 2],
            len,
            pace: len / own,
        };
        let miss = |s: f64, p: Position| {
            let [a, b] = turn.circle(s);
            let [x, y] = arc.plane.of(p);
            [x - a, y - b]
        };
        turn.miss = [miss(0.0, arc.start), miss(turn.len, arc.end)];
        Some(turn)
    }

    /// Radius at its start, mm.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// The point of the closed form in the plane.
    fn circle(&self, s: f64) -> [f64; 2] {
        let u = s / self.len;
        let r = self.radius + self.growth * u;
        let (sin, cos) = (self.angle + self.sweep * u).sin_cos();
        [self.center[0] + r * cos, self.center[1] + r * sin]
    }

    pub fn at(&self, s: f64) -> Position {
        let u = s / self.len;
        let mut p = self.start.lerp(self.end, u);
        let [a, b] = self.circle(s);
        let missing = |i: usize| self.miss[0][i] * (1.0 - u) + self.miss[1][i] * u;
        p.0[self.plane[0]] = a + missing(0);
        p.0[self.plane[1]] = b + missing(1);
        p
    }

    fn seen_from(&self, s: f64) -> Reach {
        let mut along = self.start.zip(self.end, |a, b| (b - a) / self.len);
        for i in [0, 1] {
            along.0[self.plane[i]] = self.closing(i);
        }
        Reach {
            along,
            plane: self.plane.map(|axis| axis as u8),
            angle: self.angle + self.sweep * s / self.len,
            turn: self.sweep / self.len,
            radius: self.radius + self.growth * s / self.len,
            growth: self.growth / self.len,
        }
    }

    /// What closing the arc onto its end point adds to `q′`.
    fn closing(&self, i: usize) -> f64 {
        (self.miss[1][i] - self.miss[0][i]) / self.len
    }

    fn tangent(&self, s: f64) -> Position {
        let [tangent, ..] = self.derivatives(s);
        tangent
    }

    fn bend(&self, s: f64) -> Position {
        let [_, bend, _] = self.derivatives(s);
        bend
    }

    fn derivatives(&self, s: f64) -> [Position; 3] {
        let u = s / self.len;
        let [a, b] = self.plane;
        let (sin, cos) = (self.angle + self.sweep * u).sin_cos();
        let (r, turn, out) = (self.radius + self.growth * u, self.sweep / self.len, self.growth / self.len);
        let along = r * turn;
        let mut first = self.start.zip(self.end, |a, b| (b - a) / self.len);
        first.0[a] = out * cos - along * sin + self.closing(0);
        first.0[b] = out * sin + along * cos + self.closing(1);
        let (inward, across) = (along * turn, 2.0 * out * turn);
        let mut second = Position::ZERO;
        second.0[a] = -across * sin - inward * cos;
        second.0[b] = across * cos - inward * sin;
        let (back, outward) = (inward * turn, 1.5 * across * turn);
        let mut third = Position::ZERO;
        third.0[a] = back * sin - outward * cos;
        third.0[b] = -back * cos - outward * sin;
        [first, second, third]
    }

    /// Largest `|q′|` over X, Y, Z in `from`…`to`, against what it is on the circle.
    fn stretch(&self, from: f64, to: f64) -> f64 {
        let r = self.widest(from, to);
        let climb = 3 - self.plane[0] - self.plane[1];
        let along = (r * self.sweep).hypot(self.growth).hypot(self.end.0[climb] - self.start.0[climb]);
        self.pace * (along / self.len + self.closing(0).hypot(self.closing(1)))
    }

    fn widest(&self, from: f64, to: f64) -> f64 {
        let radius = |s: f64| self.radius + self.growth * (s / self.len);
        radius(from).max(radius(to))
    }

    fn rates(&self, from: f64, to: f64) -> Rates {
        let (u0, u1) = (from / self.len, to / self.len);
        let (sin0, cos0) = (self.angle + self.sweep * u0).sin_cos();
        let (sin1, cos1) = (self.angle + self.sweep * u1).sin_cos();
        // Up to a quarter turn |cos| is 1 where sin changes sign, else largest at an end; and the same
        // the other way round.
        let short = (self.sweep * (u1 - u0)).abs() < FRAC_PI_2;
        let largest = |x0: f64, x1: f64, y0: f64, y1: f64| {
            if short && y0 * y1 > 0.0 { x0.abs().max(x1.abs()) } else { 1.0 }
        };
        let (cos, sin) = (largest(cos0, cos1, sin0, sin1), largest(sin0, sin1, cos0, cos1));
        let r = self.widest(from, to);
        let (along, out) = (r * self.sweep.abs() / self.len, self.growth.abs() / self.len);
        let turn = self.sweep.abs() / self.len;
        let (bend, twist) = (along * turn, 2.0 * out * turn);
        let mut first = self.end.zip(self.start, |b, a| (b - a) / self.len).0;
        let (mut second, mut third) = ([0.0; AXES], [0.0; AXES]);
        let [a, b] = self.plane;
        first[a] = out * cos + along * sin + self.closing(0).abs();
        first[b] = out * sin + along * cos + self.closing(1).abs();
        second[a] = twist * sin + bend * cos;
        second[b] = twist * cos + bend * sin;
        third[a] = (bend * sin + 1.5 * twist * cos) * turn;
        third[b] = (bend * cos + 1.5 * twist * sin) * turn;
        Rates { first, second, third }
    }
}
