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
const DEEPER: usize = 1024;

/// Valleys are this much slower than the feed.
const DEEP: f64 = 0.9;

/// Shares of the pace of a corner that are tried where it cannot be come to at the whole.
const CORNER_PACES: [f64; 6] = [1.0, 0.95, 0.88, 0.75, 0.55, 0.3];

/// Room that one section takes: its steps, what valleys add, and what ends it.
pub(super) const SPARE: usize = crate::timing::grid::STEPS + DEEPER + 16;

/// What may be a valley: pieces that begin in a cell. `is_slack`: it begins or ends near a rest.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bed {
    begin: usize,
    end: usize,
    cell: u64,
    is_slack: bool,
}

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
            // Where the section ends: before a corner, at a rest, at the end of the queue.
            let mut last = cell;
            let (mut pace, mut is_final) = (1.0, true);
            loop {
                let node = queue.node(last);
                match node.pass {
                    Pass::Path if node.rests => break,
                    Pass::Path => {}
                    Pass::Axes => break,
                    // Behind a vertex that was stopped at.
                    Pass::Corner { .. }
                        if last == cell && port.s >= node.s + 0.5 * node.len - SAME_LENGTH => {}
                    // On the way to a vertex that is stopped at: the corner began before.
                    Pass::Corner { .. } if port.s > node.s + SAME_LENGTH => {
                        pace = 0.0;
                        break;
                    }
                    Pass::Corner { foot, .. } => {
                        (pace, is_final) = self.pace(queue, last, foot, &port, corners);
                        break;
                    }
                }
                if last + 1 == tail {
                    break;
                }
                last += 1;
            }
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
        let (ports, cells) = ([from, to], [first, last]);
        let is_drafted = self.grid.draft(queue, ports, cells, cap);
        // What valleys replace need not be settled before.
        if is_drafted && self.take_rough() {
            let count = self.final_count(is_open).0;
            self.find_beds(queue, count, first);
            for bed in &self.beds {
                self.grid.leave_draft(bed.begin..bed.end);
            }
        }
        let known = self.stretches.len();
        let mut is_settled = is_drafted && self.grid.settle(queue);
        loop {
            if !is_settled && !self.grid.plan_safely(queue, ports, cells, cap) || !self.take_rough() {
                return false;
            }
            let (count, touch) = self.final_count(is_open);
            self.find_beds(queue, count, first);
            if let Some(count) = self.deepen(queue, count) {
                if let Some((_, cell, port)) = touch {
                    self.fix_to(known + count, Start { port, cell });
                }
                break;
            }
            // One that was counted on is none.
            self.stretches.truncate(known);
            self.grid.leave_no_draft();
            is_settled = self.grid.settle(queue);
        }
        if self.grid.is_cut {
            self.planned = queue.find(first, self.stretches.last().map_or(from.s, Stretch::end));
        }
        true
    }

    /// Takes over the pieces of the grid; `false` where one is none.
    fn take_rough(&mut self) -> bool {
        self.rough.clear();
        self.rough.extend(self.grid.pieces().map_while(|piece| piece));
        self.rough.len() == self.grid.count()
    }

    /// How many of the pieces of the grid are final, of a section that may be `open`, and what lies behind them then.
    fn final_count(&self, is_open: bool) -> (usize, Option<(usize, u64, Port)>) {
        if !is_open && !self.grid.is_cut {
            return (self.rough.len(), None);
        }
        let touch = self.grid.last_touch();
        (touch.map_or(0, |(count, ..)| count), touch)
    }

    /// Finds what may be valleys of the first `count` pieces, which are in no cell before `first`.
    fn find_beds(&mut self, queue: &Queue, count: usize, first: u64) {
        self.beds.clear();
        let overrides = self.overrides;
        let (mut from, mut cell, mut here) = (0, first, first);
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
            let is_at_rest = [self.rough[from].from == State::REST, state == State::REST];
            let begin = if is_at_rest[0] { from + AT_REST } else { from };
            let end = if is_at_rest[1] { k.saturating_sub(AT_REST) } else { k };
            if begin + 4 < end {
                let plan = &self.rough[begin..end];
                cell = queue.find(cell, plan[0].s + 1e-9);
                if is_valley(queue, plan, cell, |node| overrides.most(node)) {
                    // What the passes miss of a ramp is little, but from rest on it takes long.
                    self.beds.push(Bed { begin, end, cell, is_slack: is_at_rest[0] || is_at_rest[1] });
                }
            }
            from = k;
        }
    }

    /// Adds the pieces, of which those of valleys are run in less time if they can be ([`crate::timing::valley`]). How many there
    /// are then of the first `count`; `None` where a draft is not replaced.
    fn deepen(&mut self, queue: &Queue, count: usize) -> Option<usize> {
        let overrides = self.overrides;
        let cap = |node: &Node| overrides.most(node);
        let (mut new, mut added) = (count, 0);
        let add = |stretches: &mut Vec<Stretch>, pieces: &[Piece]| {
            stretches.extend(pieces.iter().map(|piece| Stretch::Piece(*piece)));
        };
        for &Bed { begin, end, cell, is_slack } in &self.beds {
            let (plan, is_draft) = (&self.rough[begin..end], self.grid.has_draft(begin..end));
            let most = end - begin + count + DEEPER - new;
            let inverses = &self.inverses;
            let is_found = new < count + DEEPER
                && if queue.moves_others() {
                    let road = Road::<AXES, _> { queue, inverses, cap };
                    self.valley.run(&road, plan, cell, most, is_slack, is_draft)
                } else {
                    let road = Road::<3, _> { queue, inverses, cap };
                    self.valley.run(&road, plan, cell, most, is_slack, is_draft)
                };
            if is_found {
                let pieces = self.valley.way();
                if self.grid.has_draft(added..begin) {
                    return None;
                }
                add(&mut self.stretches, &self.rough[added..begin]);
                add(&mut self.stretches, pieces);
                new = new + pieces.len() - (end - begin);
                added = end;
            }
        }
        if self.grid.has_draft(added..self.rough.len()) {
            return None;
        }
        add(&mut self.stretches, &self.rough[added..]);
        Some(new)
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
