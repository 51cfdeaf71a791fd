//! A straight line that a program goes in parts.
//!
//! How the ends of a line are joined depends on how long it is: a corner may take a share of it, a swing the way to speed up
//! in. A program that cuts the line into blocks means the same path. So the newest move is kept back, and as long as those
//! behind it go on in its direction, at its feed, they are one line; where its blocks end is marked on it.
//!
//! Of a long line only as much is kept back as its end needs: some ways to stop ([`ENOUGH`]). So a program that comes in
//! slowly is not waited for.

use crate::limits::{Inverse, Rates};
use crate::moves::{Kind, Move};
use crate::timing::queue::Mark;
use crate::timing::ramp::distance;
use ferrocut_geometry::{AXES, Position};
use ferrocut_toolpath::PathMode;

/// Most parts of a line that are told apart.
pub(super) const PARTS: usize = 1024;

/// How far parts may end off the line of those before them, all together, mm: what rounding of coordinates as large as a
/// machine's makes. Of a curve in steps that are shorter than this each alone is no further off.
const OFF: f64 = 5e-8;

/// So many ways to stop from its feed are kept back of a line: the corners at its ends are what they would be at the ends of
/// a longer one.
const ENOUGH: f64 = 2.2;

/// The newest move, and the parts that it is made of.
#[derive(Clone, Copy, Debug)]
pub(super) struct Newest {
    /// The parts as one move; its mark is that of the last.
    pub whole: Move,
    /// The way of the whole, mm.
    way: [f64; 3],
    /// How far its parts are off it at most, mm.
    off: f64,
    /// More than twice this length is not kept back, mm; 0 before it is known.
    enough: f64,
    /// Other axes than X, Y and Z stand.
    is_plain: bool,
}

/// Where a part ends that is not the last.
#[derive(Clone, Copy, Debug)]
pub(super) struct PartEnd {
    pub mark: Mark,
    to: [f64; 3],
}

impl Newest {
    /// The move `m` from `from`.
    #[inline]
    pub fn new(from: &Position, m: &Move) -> Newest {
        let way = std::array::from_fn(|i| m.to.0[i] - from.0[i]);
        Newest { whole: *m, way, off: 0.0, enough: 0.0, is_plain: m.to.0[3..] == from.0[3..] }
    }

    /// The move `m` from where it ends takes its place.
    #[inline]
    pub fn follow(&mut self, m: &Move) {
        let from = self.whole.to;
        *self = Newest::new(&from, m);
    }

    fn len(&self) -> f64 {
        self.way.iter().map(|c| c * c).sum::<f64>().sqrt()
    }

    /// Whether it is a line that others may go on.
    #[inline]
    pub fn may_go_on(&self) -> bool {
        let Kind::Line { path, .. } = self.whole.kind else { return false };
        self.is_plain
            && matches!(path, PathMode::Continuous | PathMode::ContinuousWithin(_) | PathMode::FullFeed)
    }

    /// Goes on with `m`, if that is a part of the same line. Where a part ends is kept in `ends`.
    #[inline]
    pub fn go_on(&mut self, m: &Move, ends: &mut Vec<PartEnd>) -> bool {
        let (Kind::Line { feed, path }, Kind::Line { feed: next_feed, path: next_path }) =
            (self.whole.kind, m.kind)
        else {
            return false;
        };
        let ([ax, ay, az], here, there) = (self.way, &self.whole.to.0, &m.to.0);
        let [bx, by, bz] = std::array::from_fn(|i| there[i] - here[i]);
        let [cx, cy, cz] = [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx];
        let square = ax * ax + ay * ay + az * az;
        let cross = cx * cx + cy * cy + cz * cz;
        if cross > OFF * OFF * square || !(ax * bx + ay * by + az * bz > 0.0) {
            return false;
        }
        let off = self.off + (cross / square).sqrt();
        if off > OFF || feed != next_feed || self.whole.rpm != m.rpm || path != next_path {
            return false;
        }
        if !self.may_go_on() || here[3..] != there[3..] {
            return false;
        }
        if ends.len() == PARTS {
            // However short the parts are: of every two the second ends both.
            let mut is_second = true;
            ends.retain(|_| {
                is_second = !is_second;
                is_second
            });
        }
        ends.push(PartEnd {
            mark: Mark { s: square.sqrt(), tag: self.whole.tag },
            to: [here[0], here[1], here[2]],
        });
        (self.whole.to, self.whole.tag, self.off) = (m.to, m.tag, off);
        self.way = [ax + bx, ay + by, az + bz];
        true
    }

    /// The first part of a line that is longer than what is kept back: how many of its `ends` are in it, the last of them its
    /// own.
    pub fn beyond(&mut self, ends: &[PartEnd], inverse: &Inverse) -> Option<usize> {
        let len = self.len();
        if self.enough == 0.0 {
            self.enough = self.enough(len, inverse);
        }
        if len <= 2.0 * self.enough {
            return None;
        }
        let count = ends.partition_point(|end| end.mark.s <= len - self.enough);
        // What goes is no shorter than what stays: the corner before it is that of a longer line too.
        let is_long = ends.get(count.checked_sub(1)?).is_some_and(|end| end.mark.s >= self.enough);
        is_long.then_some(count)
    }

    fn enough(&self, len: f64, inverse: &Inverse) -> f64 {
        let Kind::Line { feed, .. } = self.whole.kind else { return 0.0 };
        let mut first = [0.0; AXES];
        for (first, way) in first.iter_mut().zip(self.way) {
            *first = way / len;
        }
        let none = [0.0; AXES];
        let top = feed.min(inverse.speed(&Rates { first, second: none, third: none }));
        ENOUGH * distance(0.0, top, inverse.straight(&first))
    }

    /// Takes the parts up to this `end` away, as one move.
    pub fn split(&mut self, end: &PartEnd) -> Move {
        let (mut to, last) = (self.whole.to, self.whole.to.0);
        to.0[..3].copy_from_slice(&end.to);
        self.way = std::array::from_fn(|i| last[i] - end.to[i]);
        self.off = 0.0;
        Move { to, tag: end.mark.tag, ..self.whole }
    }
}
