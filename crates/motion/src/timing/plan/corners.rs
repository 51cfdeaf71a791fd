//! At which pace corners are run, so that all that is behind them can be slowed down for.

use super::Plan;
use crate::path::corner::pace_below;
use crate::timing::beside::{self, Beside};
use crate::timing::chain::Line;
use crate::timing::grid::Port;
use crate::timing::piece::State;
use crate::timing::queue::{Node, Pass, Queue, SAME_LENGTH};
use crate::timing::ramp::Foot;

/// At a corner that could only be run at a lower share of its pace the path stops instead; two that are run as one are run as
/// slowly as there is a need to, which is no slower than this: beside them there is a way to stop on.
const LEAST_PACE: f64 = 0.1;
const LEAST_LINK_PACE: f64 = 1e-3;

/// How fast corners are taken.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Corners {
    /// Share of the pace.
    pub share: f64,
    /// On curves beside them the acceleration counts that a ramp from the corner has where it is, not that at the corner
    /// at a multiple of the speed.
    pub is_bold: bool,
}

impl Corners {
    /// In this order they are tried.
    pub const BOLD: Corners = Corners { share: 1.0, is_bold: true };
    pub const SAFE: Corners = Corners { share: 1.0, is_bold: false };

    pub fn slower(self, round: i32) -> Corners {
        Corners { share: self.share * 0.3_f64.powi(round), ..self }
    }
}

impl Plan {
    /// Highest pace of the corner in `cell`, to which the path goes from `from`: all that is behind it can be slowed down for,
    /// and it can be come to. Whether it is so whatever comes behind what is known.
    pub(super) fn pace(
        &mut self,
        queue: &Queue,
        cell: u64,
        foot: Foot,
        from: &Port,
        corners: Corners,
    ) -> (f64, bool) {
        let line = self.line_before(queue, cell, from.s);
        if line.is_none() || self.chain.pace(cell).is_none() {
            self.follow_corners(queue, cell, from, line.is_some(), corners);
        }
        let (pace, is_final) = self.chain.pace(cell).unwrap_or((0.0, true));
        match line {
            Some(line) if from.state.a >= 0.0 => {
                let State { v, a } = from.state;
                (line.most(Foot { v, a }, foot, pace), is_final)
            }
            _ => (pace, is_final),
        }
    }

    /// Finds how fast the corner in `first` and those that follow it with one line between may be run. The path comes to the
    /// first from `from`, along one line (`is_line`) or not.
    fn follow_corners(&mut self, queue: &Queue, first: u64, from: &Port, is_line: bool, corners: Corners) {
        self.chain.clear();
        let mut cell = first;
        let mut before = if is_line { self.line_before(queue, first, from.s) } else { None };
        while let Pass::Corner { foot, .. } = queue.node(cell).pass {
            let behind = self.line_behind(queue, cell).filter(|_| !self.chain.is_full());
            let cap = self.overrides.cap(queue.node(cell));
            let top = |node: &Node| self.overrides.cap(node);
            // Not the sides that are such lines.
            let side_before = before.is_none().then(|| {
                let nodes =
                    (queue.head()..cell).rev().map(|cell| queue.node(cell)).take_while(|node| !node.rests);
                let mut before = Beside::new(nodes, foot, corners.is_bold, cap, top);
                if from.state == State::REST {
                    before.begins_at_rest(queue.node(cell).s - from.s);
                }
                before
            });
            let side_behind = behind.is_none().then(|| {
                let mut ends = false;
                let nodes = (cell + 1..self.horizon).map(|cell| queue.node(cell));
                let nodes = nodes.take_while(|node| !std::mem::replace(&mut ends, node.rests));
                Beside::new(nodes, foot, corners.is_bold, cap, top)
            });
            let slow = self.slow.iter().find(|(slow, _)| *slow == cell).map_or(1.0, |(_, share)| *share);
            let lines = before.iter().chain(&behind);
            let capped =
                lines.map(|line| pace_below(foot, cap.min(line.cap), line.drive.j)).fold(1.0, f64::min);
            let pace = |behind: Option<&Beside>| {
                beside::pace(foot, side_before.iter().chain(behind)).min(capped) * corners.share * slow
            };
            let known = pace(side_behind.as_ref());
            let open = match side_behind {
                Some(side) if self.is_open_behind(queue, cell) => pace(Some(&side.endless())),
                _ => known,
            };
            self.chain.push(cell, foot, [known, open], behind);
            if behind.is_none() {
                break;
            }
            (before, cell) = (behind, cell + 2);
        }
        self.chain.settle();
    }

    /// Whether more is to come of the path behind the corner in `cell` than is looked at.
    fn is_open_behind(&self, queue: &Queue, cell: u64) -> bool {
        for number in (cell + 1..self.horizon).take(beside::CELLS) {
            let node = queue.node(number);
            match node.pass {
                Pass::Corner { .. } => return self.chain.is_full() || !self.goes_on_behind(queue, number),
                Pass::Axes => return false,
                Pass::Path if node.rests => return false,
                Pass::Path => {}
            }
        }
        cell + (beside::CELLS as u64) >= self.horizon
    }

    /// Whether the path goes on behind the corner in `cell`, and is not planned to rest before it for now.
    pub(super) fn goes_on_behind(&self, queue: &Queue, cell: u64) -> bool {
        let more = if self.horizon < queue.tail() { beside::CELLS as u64 } else { 1 };
        cell + more < self.horizon
    }

    /// The one line on which the path comes from `s` to the corner in `cell`.
    pub(super) fn line_before(&self, queue: &Queue, cell: u64, s: f64) -> Option<Line> {
        let number = cell.checked_sub(1).filter(|number| *number >= queue.head())?;
        let node = queue.node(number);
        let is_on = s >= node.s - SAME_LENGTH && s < node.end() - SAME_LENGTH;
        (is_on && is_line(node)).then(|| self.line_of(node, node.end() - s))
    }

    /// The one line between the corner in `cell` and the next.
    fn line_behind(&self, queue: &Queue, cell: u64) -> Option<Line> {
        let next = cell + 2;
        let is_known =
            self.goes_on_behind(queue, next) && matches!(queue.node(next).pass, Pass::Corner { .. });
        let node = is_known.then(|| queue.node(cell + 1)).filter(|node| is_line(node))?;
        Some(self.line_of(node, node.len))
    }

    fn line_of(&self, node: &Node, len: f64) -> Line {
        Line { len, drive: node.load.most(), cap: self.overrides.cap(node) }
    }
}

/// Whether a cell is a straight line on which the path runs on.
pub(super) fn is_line(node: &Node) -> bool {
    node.pass == Pass::Path && !node.rests && node.load.is_straight()
}

pub(super) fn least_pace(is_link: bool) -> f64 {
    if is_link { LEAST_LINK_PACE } else { LEAST_PACE }
}
