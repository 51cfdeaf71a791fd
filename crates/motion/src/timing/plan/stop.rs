//! Braking, for a stop and for a lower override: on the line being run, and through corners where that is too short.

use super::corners::is_line;
use super::{Plan, Stretch, behind, queue_start};
use crate::limits::Class;
use crate::path::corner::{pace_below, paced};
use crate::timing::brake::Start;
use crate::timing::chain::KNOTS;
use crate::timing::grid::Port;
use crate::timing::piece::{Piece, State};
use crate::timing::queue::{Pass, Queue, SAME_LENGTH};
use crate::timing::ramp::{Foot, STOP_ROOM};

/// Through how many corners a stop goes at most, and at which paces they are tried; and a lower override. The lowest pace is not
/// below a share that falls from corner to corner: one that is run slowly takes longer than several.
const THROUGH_STOPPING: (usize, &[f64]) = (KNOTS, &[1.0, 0.75, 0.5, 0.25, 0.0]);
pub(super) const THROUGH_SLOWER: (usize, &[f64]) = (8, &[0.0]);
const THROUGH_LEAST: f64 = 0.5;
const THROUGH_FALL: f64 = 0.85;

/// Before a corner there is a way left on which the path starts again to run it at this pace at least.
const START_PACE: f64 = 0.2;

/// Pieces that are followed with less speed take this long at most, s.
const EASE_STEP: f64 = 0.004;

impl Plan {
    /// Brings the path to rest as soon as the bounds allow; it is `t` seconds inside the stretch being run, from which
    /// on the plan is another. Where it cannot be stopped before a corner it goes on through that, slower. `None` if there is
    /// no way, or none before a rest: then it is to be tried again later. No thread is stopped in, unless the path `gives_up`
    /// there.
    pub fn stop(&mut self, queue: &Queue, t: f64, gives_up: bool) -> Option<u64> {
        self.keep(true);
        self.cut(t);
        if let (Some(Stretch::Piece(_)), Some(start)) = (self.current(), self.behind_current(queue)) {
            let limit = self.limit(queue, start.cell, !gives_up);
            if self.brake(queue, start, 0.0, limit) {
                self.stretches.truncate(self.current + 1);
                self.stretches.extend(self.brake.pieces().iter().map(|piece| Stretch::Piece(*piece)));
                self.fixed = self.stretches.len();
                return Some(self.number());
            }
            let stops = |plan: &mut Plan, at: Start| {
                let limit = plan.limit(queue, at.cell, !gives_up);
                let stops = plan.brake.run(queue, at, 0.0, limit);
                if stops {
                    plan.stretches.extend(plan.brake.pieces().iter().map(|piece| Stretch::Piece(*piece)));
                }
                stops
            };
            if self.through_corners(queue, start, THROUGH_STOPPING, gives_up, stops) {
                self.fixed = self.stretches.len();
                return Some(self.number());
            }
        }
        self.restore();
        None
    }

    /// Where the path cannot be slowed down on a line before a corner: it is slowed down for that, and so on for the next
    /// ones, `most` at most, until `goes_on` finds a plan behind one of them. Each is tried at these `paces`, from the lowest
    /// that can be come to at 0 to the highest at 1. `start` is where the stretch being run was cut. No thread is slowed down
    /// for, unless the path `gives_up` there.
    pub(super) fn through_corners(
        &mut self,
        queue: &Queue,
        start: Start,
        (most, paces): (usize, &[f64]),
        gives_up: bool,
        mut goes_on: impl FnMut(&mut Plan, Start) -> bool,
    ) -> bool {
        self.stretches.truncate(self.current + 1);
        let mut at = start;
        let mut floor = THROUGH_LEAST;
        for _ in 0..most {
            let cell = at.cell + 1;
            let line = self.line_before(queue, cell, at.port.s).filter(|_| cell < queue.tail());
            let (Some(line), State { v, a }) = (line, at.port.state) else { return false };
            let is_thread = [at.cell, cell].iter().any(|cell| queue.node(*cell).class == Class::Locked);
            if is_thread && !gives_up {
                return false;
            }
            let known = self.stretches.len();
            if a < 0.0 {
                // It slows down for the corner already.
                let Some(behind) = self.go_on_to_corner(queue, cell).filter(|_| at.cell == start.cell) else {
                    return false;
                };
                at = behind;
                if goes_on(self, at) {
                    return true;
                }
                continue;
            }
            let node = queue.node(cell);
            let Pass::Corner { foot, .. } = node.pass else { return false };
            let here = Foot { v, a };
            let Some(least) = line.least(here, foot) else { return false };
            // Its own speed at most, unless it is come to from a higher override.
            let cap = self.overrides.cap(node).min(line.cap).max(here.top(line.drive.j));
            let capped = pace_below(foot, cap, line.drive.j);
            let high = line.most(here, foot, 1.0).min(capped).max(least);
            let low = least.max(floor).min(high);
            floor *= THROUGH_FALL;
            let mut slowest = None;
            for share in paces {
                self.stretches.truncate(known);
                let pace = low + share * (high - low);
                let Some(behind) = self.slow_down_to_corner(queue, at, cell, pace) else { continue };
                let reached = self.stretches.len();
                if goes_on(self, behind) {
                    return true;
                }
                self.stretches.truncate(reached);
                slowest = Some(behind);
            }
            let Some(slowest) = slowest else { return false };
            at = slowest;
        }
        false
    }

    /// Adds the line from `at` to the corner in `cell`, and that at this pace. Where the path is then; `None` if the line does
    /// not lead to it.
    fn slow_down_to_corner(&mut self, queue: &Queue, at: Start, cell: u64, pace: f64) -> Option<Start> {
        let line = self.line_before(queue, cell, at.port.s)?;
        let node = queue.node(cell);
        let Pass::Corner { foot, time, .. } = node.pass else { return None };
        let here = Foot { v: at.port.state.v, a: at.port.state.a };
        let there = paced(foot, pace);
        // It may come from a higher override.
        let cap = here.top(line.drive.j).max(there.top(line.drive.j));
        let to = Port { s: node.s, state: State { v: there.v, a: -there.a } };
        if !self.line(at.port, to, cap, line.drive, None) {
            return None;
        }
        self.stretches.push(Stretch::Corner { s: node.s, end: node.end(), cell, pace, foot, time });
        self.behind_last(queue)
    }

    /// The stretch that was cut, and what was planned behind it, up to the corner in `cell` and that. Where the path is then.
    fn go_on_to_corner(&mut self, queue: &Queue, cell: u64) -> Option<Start> {
        let is_corner = |stretch: &Stretch| matches!(stretch, Stretch::Corner { .. });
        let planned = self.before.iter().position(is_corner)?;
        if !matches!(self.before[planned], Stretch::Corner { cell: its, .. } if its == cell) {
            return None;
        }
        self.stretches.truncate(self.current);
        self.stretches.extend_from_slice(&self.before[..=planned]);
        self.behind_last(queue)
    }

    /// The state behind the last stretch, a corner with more path behind it.
    fn behind_last(&self, queue: &Queue) -> Option<Start> {
        let behind = behind(queue, self.stretches.last()?);
        (behind.cell < queue.tail()).then_some(behind)
    }

    /// Finds the pieces that slow down from `start`, in the stretch that was cut, to `target` before `limit`.
    pub(super) fn brake(&mut self, queue: &Queue, start: Start, target: f64, limit: f64) -> bool {
        if self.brake.run(queue, start, target, limit) {
            return true;
        }
        // What is left of the piece that was cut, and what was planned behind it.
        let mut planned = self.before.iter().map_while(|stretch| match stretch {
            Stretch::Piece(piece) => Some(*piece),
            _ => None,
        });
        self.rough.clear();
        let Port { s, state } = start.port;
        let cut = planned.next().filter(|piece| piece.end() > s + SAME_LENGTH);
        let rest = cut.and_then(|piece| Piece::new(s, piece.end() - s, state, piece.to));
        for piece in rest.into_iter().chain(planned) {
            let room = self.rough.capacity() - self.rough.len();
            self.rough.extend(piece.parts(EASE_STEP).take(room));
        }
        self.brake.ease_off(queue, &self.inverses, &self.rough, start, target, limit)
    }

    /// Where the next corner or rest is, or the next thread where those count.
    pub(super) fn limit(&self, queue: &Queue, from: u64, or_thread: bool) -> f64 {
        let mut cell = from;
        while cell < queue.tail() {
            let node = queue.node(cell);
            if or_thread && node.class == Class::Locked {
                return node.s;
            }
            match node.pass {
                Pass::Path if !node.rests => cell += 1,
                Pass::Path => return node.end(),
                Pass::Corner { foot, .. } => {
                    // With a way left to start again.
                    let before = cell.checked_sub(1).filter(|before| *before >= queue.head());
                    let line = before.map(|before| queue.node(before)).filter(|node| is_line(node));
                    let way = line.map(|line| STOP_ROOM * paced(foot, START_PACE).room(line.load.most()));
                    return node.s - way.unwrap_or(node.len).min(node.len);
                }
                Pass::Axes => return node.s,
            }
        }
        queue_start(queue, cell)
    }
}
