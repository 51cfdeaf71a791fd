//! Corners that follow each other, with one straight line between: how fast each may be run.
//!
//! On a line that is long enough the path can be stopped between two corners, and each may be run whatever the other does
//! ([`crate::timing::beside`]). On a shorter one their paces belong together. The state at both ends of a line of length `L`
//! is a [`Foot`], away from the corner: a line leads from one to the other if the acceleration behind the first can be taken
//! back and that before the second built up, with the way between both tops,
//!
//! ```text
//! D = s₀(T) + s₁(T) ≤ L          T = max(top₀, top₁)          sᵢ(T) the way from the foot up to the speed T
//! ```
//!
//! `D` is least where both tops are the same. So the highest pace of a corner that leads to the next one is found from that
//! pace upwards. Backwards from the last corner, behind which the path can be stopped, this gives every corner the pace from
//! which all that follows can be slowed down for, however many lines that takes; forwards, where the path is planned, the
//! line from the corner before limits it too. A stop goes the same way: each corner at the lowest pace that its line leads
//! to, until one has room to stop behind it.

use crate::limits::Drive;
use crate::path::corner::{pace_below, paced};
use crate::timing::beside::largest;
use crate::timing::ramp::Foot;

/// Corners that are looked at together.
pub(crate) const KNOTS: usize = 32;

/// Paces this close are the same.
const SAME_PACE: f64 = 1e-6;

/// Share of a line that ramps take at most, for rounding.
const LINE_SHARE: f64 = 1.0 - 1e-9;

/// A straight line between two corners, or from where the path is to one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Line {
    /// mm.
    pub len: f64,
    pub drive: Drive,
    /// Highest speed on it, mm/s.
    pub cap: f64,
}

impl Line {
    /// Whether it leads from one state to another, both away from its ends.
    pub fn joins(&self, from: Foot, to: Foot) -> bool {
        let top = from.top(self.drive.j).max(to.top(self.drive.j));
        let way = |foot: Foot| foot.distance(top, self.drive);
        way(from).zip(way(to)).is_some_and(|(one, other)| one + other <= self.len * LINE_SHARE)
    }

    /// The pace of a corner, no higher than `most`, at which the acceleration is gone at the speed `top`.
    fn level(&self, foot: Foot, top: f64, most: f64) -> f64 {
        most.min(pace_below(foot, top, self.drive.j))
    }

    /// The highest pace of a corner, up to `most`, that is joined to `other`.
    pub fn most(&self, other: Foot, foot: Foot, most: f64) -> f64 {
        let level = self.level(foot, other.top(self.drive.j), most);
        largest(level, most, |pace| pace <= level || self.joins(other, paced(foot, pace)))
    }

    /// The lowest pace of a corner that `from` leads to; `None` where it leads to none.
    pub fn least(&self, from: Foot, foot: Foot) -> Option<f64> {
        let level = self.level(foot, from.top(self.drive.j), 1.0);
        let joins = |pace: f64| self.joins(from, paced(foot, pace));
        // The share of it that it can be less.
        joins(level).then(|| level * (1.0 - largest(0.0, 1.0, |less| joins(level * (1.0 - less)))))
    }

    /// The highest paces of both its corners at which the acceleration behind one can be gone before that before the other is
    /// to be there.
    fn even(&self, feet: [Foot; 2]) -> [f64; 2] {
        let Drive { a, j } = self.drive;
        let paces = |top: f64| {
            feet.map(|foot| {
                let strong = if foot.a > a { (a / foot.a).sqrt() } else { 1.0 };
                self.level(foot, top, strong)
            })
        };
        let top = feet[0].top(j).max(feet[1].top(j)).min(self.cap);
        let is_short = |top: f64| {
            let [one, other] = paces(top);
            self.joins(paced(feet[0], one), paced(feet[1], other))
        };
        paces(largest(0.0, top, is_short))
    }
}

/// One of the corners.
#[derive(Clone, Copy, Debug)]
struct Knot {
    cell: u64,
    foot: Foot,
    /// Highest pace with what is known behind it, and if more came of the path.
    pace: f64,
    open: f64,
    /// The line to the next one.
    line: Option<Line>,
}

/// Corners that follow each other.
#[derive(Debug)]
pub(crate) struct Chain(Vec<Knot>);

impl Chain {
    pub fn new() -> Chain {
        Chain(Vec::with_capacity(KNOTS))
    }

    pub fn clear(&mut self) {
        self.0.clear();
    }

    /// Whether no more are looked at.
    pub fn is_full(&self) -> bool {
        self.0.len() + 1 >= KNOTS
    }

    /// Adds the corner in a cell, its highest pace by all but the lengths of its lines, and the line behind it to the next one.
    /// `open`: the same if more came where the path is not known, or not looked at, any more.
    pub fn push(&mut self, cell: u64, foot: Foot, [pace, open]: [f64; 2], line: Option<Line>) {
        self.0.push(Knot { cell, foot, pace, open, line });
    }

    /// Finds the paces that their lines allow.
    pub fn settle(&mut self) {
        for k in 1..self.0.len() {
            let [.., before, here] = &mut self.0[..=k] else { continue };
            let Some(line) = before.line else { continue };
            let most = line.even([before.foot, here.foot]);
            for (knot, most) in [before, here].into_iter().zip(most) {
                (knot.pace, knot.open) = (knot.pace.min(most), knot.open.min(most));
            }
        }
        for k in (1..self.0.len()).rev() {
            let [.., before, here] = &mut self.0[..=k] else { continue };
            let Some(line) = before.line else { continue };
            before.pace = line.most(paced(here.foot, here.pace), before.foot, before.pace);
            before.open = line.most(paced(here.foot, here.open), before.foot, before.open);
        }
    }

    /// The highest pace of the corner in a cell, and whether it is so whatever comes behind what is known.
    pub fn pace(&self, cell: u64) -> Option<(f64, bool)> {
        let knot = self.0.iter().find(|knot| knot.cell == cell)?;
        Some((knot.pace, knot.pace >= knot.open * (1.0 - SAME_PACE)))
    }
}
