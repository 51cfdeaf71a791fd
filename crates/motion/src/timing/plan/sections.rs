//! Sections: from one rest or corner to the next, planned one behind the other.

use super::corners::{Corners, least_pace};
use super::{Plan, STRETCHES, Stretch, queue_start};
use crate::limits::Drive;
use crate::path::corner::paced;
use crate::timing::beside;
use crate::timing::brake::Start;
use crate::timing::grid::{ALIKE, Port};
use crate::timing::overrides::LEAST_SPEED;
use crate::timing::piece::{Piece, State};
use crate::timing::queue::{Node, Pass, Queue, SAME_LENGTH};
use crate::timing::ramp::{Foot, Phases, summit};
use crate::timing::valley::Road;
use ferrocut_geometry::AXES;

/// Pieces from rest and to rest that stay as they are.
const AT_REST: usize = 3;

/// Pieces that valleys may add to a section.
const DEEPER: usize = 3072;

/// Valleys are this much slower than the feed.
const DEEP: f64 = 0.9;

/// Shares of the pace of a corner that are tried where it cannot be come to at the whole.
const CORNER_PACES: [f64; 6] = [1.0, 0.95, 0.88, 0.75, 0.55, 0.3];

/// Room that one section takes: its steps, what valleys add, and what ends it.
pub(super) const SPARE: usize = crate::timing::grid::STEPS + DEEPER + 16;

impl Plan {
    /// Plans from `start` to the end of what is known. `false` if a section cannot be planned.
    pub(super) fn sections(&mut self, queue: &Queue, start: Start, corners: Corners) -> bool {
        let Start { mut port, mut cell } = start;
        let tail = self.horizon;
        let is_portion = tail < queue.tail();
        cell = cell.max(queue.head());
        // The corner that the section begins behind, if its pace is still to be chosen.
        let mut corner = None;
        self.blamed = None;
        self.is_open = false;
        self.chain.clear();
        while cell < tail && self.stretches.len() + SPARE < STRETCHES {
            let (last, mut pace, is_final) = self.section_end(queue, cell, &port, corners);
            let node = queue.node(last);
            let behind = queue_start(queue, last + 1);
            let is_inside = port.s > node.s + SAME_LENGTH;
            match node.pass {
                Pass::Axes => {
                    self.stretches.push(Stretch::Axes { s: node.s, cell: last });
                    port = Port { s: behind, state: State::REST };
                    corner = None;
                    self.fix(Start { port, cell: last + 1 });
                }
                Pass::Corner { .. } if port.s >= node.s + 0.5 * node.len - SAME_LENGTH => {
                    let to = Port { s: node.end(), state: State::REST };
                    if !self.section(queue, port, to, cell, last) {
                        self.blamed = corner;
                        return false;
                    }
                }
                Pass::Corner { .. } if !is_inside && is_portion && last + beside::CELLS as u64 >= tail => {
                    // What follows is not looked at yet: to rest before it.
                    let to = Port { s: node.s, state: State::REST };
                    if cell < last && !self.section(queue, port, to, cell, last - 1) {
                        self.blamed = corner;
                        return false;
                    }
                    if cell == last || !self.grid.is_cut {
                        self.planned = last;
                    }
                    return true;
                }
                Pass::Corner { is_link, .. } if pace < least_pace(is_link) => {
                    // Without room to stop on beside it, at the vertex.
                    let to = Port { s: node.s + 0.5 * node.len, state: State::REST };
                    if !self.section(queue, port, to, cell, last) {
                        self.blamed = corner;
                        return false;
                    }
                    if self.grid.is_cut {
                        return true;
                    }
                    port = to;
                    self.fix(Start { port, cell: last });
                    corner = None;
                    cell = last;
                    continue;
                }
                Pass::Corner { .. } if last + 1 == tail => {
                    // What follows is not known yet: to rest before it.
                    let to = Port { s: node.s, state: State::REST };
                    if cell < last && !self.section(queue, port, to, cell, last - 1) {
                        self.blamed = corner;
                        return false;
                    }
                    if cell == last || !self.grid.is_cut {
                        self.planned = tail;
                    }
                    return true;
                }
                Pass::Corner { foot, time, .. } => {
                    if cell < last {
                        let Some(possible) = self.section_to_corner(queue, port, cell, last, foot, pace)
                        else {
                            self.blamed = corner;
                            return false;
                        };
                        if self.grid.is_cut {
                            return true;
                        }
                        pace = possible;
                    }
                    let foot_now = paced(foot, pace);
                    self.stretches.push(Stretch::Corner {
                        s: node.s,
                        end: node.end(),
                        cell: last,
                        pace,
                        foot,
                        time,
                    });
                    port = Port { s: node.end(), state: State { v: foot_now.v, a: foot_now.a } };
                    corner = Some(last);
                    self.is_open |= !is_final;
                    if last + 1 < tail {
                        self.fix(Start { port, cell: last + 1 });
                    }
                }
                Pass::Path => {
                    let to = Port { s: node.end(), state: State::REST };
                    if !self.section(queue, port, to, cell, last) {
                        self.blamed = corner;
                        return false;
                    }
                    if self.grid.is_cut {
                        return true;
                    }
                    if node.rests {
                        self.stretches.push(Stretch::Rest { s: node.end(), cell: last });
                        port = Port { s: behind, state: State::REST };
                        corner = None;
                        self.fix(Start { port, cell: last + 1 });
                    }
                }
            }
            cell = last + 1;
        }
        self.planned = cell;
        true
    }

    /// Where the section that begins in `cell` ends: before a corner, at a rest, at the end of what is planned. The last cell,
    /// and of a corner there the pace, and whether that stays whatever follows.
    fn section_end(&mut self, queue: &Queue, cell: u64, port: &Port, corners: Corners) -> (u64, f64, bool) {
        let mut last = cell;
        loop {
            let node = queue.node(last);
            match node.pass {
                Pass::Path if node.rests => break,
                Pass::Path => {}
                Pass::Axes => break,
                // Behind a vertex that was stopped at.
                Pass::Corner { .. } if last == cell && port.s >= node.s + 0.5 * node.len - SAME_LENGTH => {}
                // On the way to a vertex that is stopped at: the corner began before.
                Pass::Corner { .. } if port.s > node.s + SAME_LENGTH => return (last, 0.0, true),
                Pass::Corner { foot, .. } => {
                    let (pace, is_final) = self.pace(queue, last, foot, port, corners);
                    return (last, pace, is_final);
                }
            }
            if last + 1 == self.horizon {
                break;
            }
            last += 1;
        }
        (last, 1.0, true)
    }

    /// Plans the section before the corner in cell `last`: at which pace, `pace` at most, the corner can be run behind it.
    /// From the corner before there is always room to stop, though not always to come to the state that the corner
    /// begins with.
    fn section_to_corner(
        &mut self,
        queue: &Queue,
        port: Port,
        first: u64,
        last: u64,
        foot: Foot,
        pace: f64,
    ) -> Option<f64> {
        let (known, fixed, next, planned) = (self.stretches.len(), self.fixed, self.next, self.planned);
        let is_link = matches!(queue.node(last).pass, Pass::Corner { is_link: true, .. });
        for share in CORNER_PACES {
            let pace = pace * share;
            if pace < least_pace(is_link) {
                break;
            }
            let foot = paced(foot, pace);
            let to = Port { s: queue.node(last).s, state: State { v: foot.v, a: -foot.a } };
            if self.section(queue, port, to, first, last - 1) {
                return Some(pace);
            }
            self.stretches.truncate(known);
            (self.fixed, self.next, self.planned) = (fixed, next, planned);
        }
        None
    }

    /// Plans one section; its pieces are added.
    fn section(&mut self, queue: &Queue, from: Port, to: Port, first: u64, last: u64) -> bool {
        self.grid.is_cut = false;
        if to.s - from.s <= SAME_LENGTH {
            return from.state.v <= LEAST_SPEED && to.state.v <= LEAST_SPEED;
        }
        let is_open = to.state == State::REST && !queue.node(last).rests;
        let overrides = self.overrides;
        let cap = |node: &Node| match node.pass {
            Pass::Corner { top, .. } => top.min(overrides.cap(node)),
            _ => overrides.cap(node),
        };
        let node = queue.node(first);
        if first == last && node.load.is_straight() {
            let open = is_open.then_some(first);
            if self.line(from, to, cap(node), node.load.most(), open) {
                return true;
            }
        }
        if !self.grid.plan(queue, from, to, first, last, cap) {
            return false;
        }
        let known = self.stretches.len();
        for piece in self.grid.pieces() {
            let Some(piece) = piece else { return false };
            self.stretches.push(Stretch::Piece(piece));
        }
        let is_open = is_open || self.grid.is_cut;
        let touch = if is_open { self.grid.last_touch() } else { None };
        let count = match touch {
            Some((count, ..)) => count,
            None if is_open => 0,
            None => self.stretches.len() - known,
        };
        let count = self.deepen(queue, known, count, first);
        if is_open {
            if let Some((_, cell, port)) = touch {
                self.fix_to(known + count, Start { port, cell });
            }
            if self.grid.is_cut {
                self.planned = queue.find(first, self.stretches.last().map_or(from.s, Stretch::end));
            }
        }
        true
    }

    /// Runs the valleys of the `count` pieces from stretch `known` on in less time ([`crate::timing::valley`]); they are
    /// in no cell before `first`. How many pieces there are then.
    fn deepen(&mut self, queue: &Queue, known: usize, count: usize, first: u64) -> usize {
        self.rough.clear();
        self.rough.extend(self.stretches[known..].iter().filter_map(|stretch| match stretch {
            Stretch::Piece(piece) => Some(*piece),
            _ => None,
        }));
        let overrides = self.overrides;
        let (mut from, mut cell, mut is_other) = (0, first, false);
        let (mut new, mut here) = (count, first);
        for k in 1..=count {
            // From one place of steady speed, or end, to the next.
            let state = self.rough[k - 1].to;
            let mut is_fast = || {
                here = queue.find(here, self.rough[k - 1].end() - 1e-9);
                let node = queue.node(here);
                state.v >= overrides.most(node) * (1.0 - 2.0 * ALIKE)
            };
            if k < count && !(state.a == 0.0 && is_fast()) {
                continue;
            }
            let begin = if self.rough[from].from == State::REST { from + AT_REST } else { from };
            let end = if self.rough[k - 1].to == State::REST { k.saturating_sub(AT_REST) } else { k };
            let mut found = false;
            if begin + 4 < end && new < count + DEEPER {
                let plan = &self.rough[begin..end];
                cell = queue.find(cell, plan[0].s + 1e-9);
                let most = end - begin + count + DEEPER - new;
                let cap = |node: &Node| overrides.most(node);
                if is_valley(queue, plan, cell, cap) {
                    // What the passes miss of a ramp is little, but from rest on it takes long.
                    let is_slack =
                        self.rough[from].from == State::REST || self.rough[k - 1].to == State::REST;
                    let inverses = &self.inverses;
                    found = if queue.moves_others() {
                        self.valley.run(&Road::<AXES, _> { queue, inverses, cap }, plan, cell, most, is_slack)
                    } else {
                        self.valley.run(&Road::<3, _> { queue, inverses, cap }, plan, cell, most, is_slack)
                    };
                }
            }
            if found {
                let pieces = self.valley.way();
                if !is_other {
                    self.stretches.truncate(known + begin);
                    is_other = true;
                } else {
                    self.stretches.extend(self.rough[from..begin].iter().map(|piece| Stretch::Piece(*piece)));
                }
                new = new + pieces.len() - (end - begin);
                self.stretches.extend(pieces.iter().map(|piece| Stretch::Piece(*piece)));
                self.stretches.extend(self.rough[end..k].iter().map(|piece| Stretch::Piece(*piece)));
            } else if is_other {
                self.stretches.extend(self.rough[from..k].iter().map(|piece| Stretch::Piece(*piece)));
            }
            from = k;
        }
        if is_other {
            self.stretches.extend(self.rough[count..].iter().map(|piece| Stretch::Piece(*piece)));
        }
        new
    }

    /// The shortest motion on a line: up to a summit, steady, and down. `false` if it has another form. If the line is
    /// the last cell that is known, `open`, what comes before the steady part at the highest speed is final.
    pub(super) fn line(&mut self, from: Port, to: Port, cap: f64, drive: Drive, open: Option<u64>) -> bool {
        let len = to.s - from.s;
        if from.state.a < 0.0 {
            return false;
        }
        let (left, right) =
            (Foot { v: from.state.v, a: from.state.a }, Foot { v: to.state.v, a: -to.state.a });
        let low = left.top(drive.j).max(right.top(drive.j));
        if low > cap * (1.0 + 1e-9) || left.a > drive.a || right.a > drive.a {
            return false;
        }
        let Some(top) = summit(left, right, len, low, cap.max(low), drive) else { return false };
        let (up, down) = (Phases::new(left, top, drive), Phases::new(right, top, drive));
        let mut s = from.s;
        let mut state = from.state;
        for (time, j) in up.times.into_iter().zip([up.j, 0.0, -up.j]) {
            self.go_on(&mut s, &mut state, j, time);
        }
        state = State { v: top, a: 0.0 };
        let steady = to.s - right.distance(top, drive).unwrap_or(0.0) - s;
        if steady > 0.0 && top > 0.0 {
            if let Some(cell) = open.filter(|_| top >= cap) {
                self.fix(Start { port: Port { s, state }, cell });
            }
            self.go_on(&mut s, &mut state, 0.0, steady / top);
        }
        // Mirrored in time: what builds up acceleration there takes it back here.
        for (time, j) in down.times.into_iter().zip([down.j, 0.0, -down.j]).rev() {
            self.go_on(&mut s, &mut state, j, time);
        }
        true
    }

    /// Adds a piece of constant jerk.
    fn go_on(&mut self, s: &mut f64, state: &mut State, j: f64, time: f64) {
        if time > 0.0 {
            let piece = Piece::steady(*s, *state, j, time);
            (*s, *state) = (piece.end(), piece.to);
            self.stretches.push(Stretch::Piece(piece));
        }
    }
}

/// Whether there may be something to be gained: somewhere it is much slower than `most`, and no corner is passed.
fn is_valley(queue: &Queue, plan: &[Piece], first: u64, most: impl Fn(&Node) -> f64) -> bool {
    let end = plan[plan.len() - 1].end();
    let is_path = (first..queue.tail())
        .map(|cell| queue.node(cell))
        .take_while(|node| node.s < end)
        .all(|node| node.pass == Pass::Path);
    let mut cell = first;
    is_path
        && plan.iter().any(|piece| {
            cell = queue.find(cell, piece.s);
            piece.from.v < DEEP * most(queue.node(cell))
        })
}
