//! Look-ahead: what is run next, and what of it is final.
//!
//! The path is planned section by section; a section ends at a rest, at a corner that is rounded in time, or where
//! no more cells are known. On a single line the shortest motion is known in closed form ([`crate::timing::ramp`]);
//! everything else is planned in steps ([`crate::timing::grid`]). Either way the plan is a list of pieces
//! ([`crate::timing::piece`]).
//!
//! **Always to rest.** The end of what is known is planned to rest whatever may follow, so a feeder that falls
//! behind stops the machine on the path, within limits.
//!
//! **What is final.** Where the speed is as high as it may be, nothing that follows can change what is before.
//! Planning goes on from there when more cells have come. Planning when as many cells are new as are not final
//! costs every cell about two plans, however long braking takes.
//!
//! **A plan is never replaced by one that does not keep the bounds.** Every piece is checked; if a new plan fails,
//! the one before is run on, and at its end the machine is at rest, from where a plan always exists.
//!
//! **What is handed over** is what a new plan made other: [`Plan::plan`], [`Plan::renew`] and [`Plan::stop`] say from
//! which stretch on. Stretches are counted from the first one on. If it comes too late [`Plan::undo`] brings back what
//! runs.
//!
//! **Corners** are run at a pace at which the path beside them is long enough to stop on, so that sections on either side
//! can be planned apart; those with one line between at paces that belong together ([`crate::timing::chain`]). A pace that may
//! rise once more is known is not final, nor what is behind it.

mod corners;
mod sections;
mod stop;

use crate::limits::Inverses;
use crate::path::corner::paced;
use crate::timing::brake::{Brake, PIECES, Start};
use crate::timing::chain::{Chain, KNOTS};
use crate::timing::grid::{Grid, Port};
use crate::timing::overrides::Overrides;
use crate::timing::piece::{Piece, State};
use crate::timing::queue::{CELLS, Queue};
use crate::timing::ramp::{Foot, STOP_ROOM};
use crate::timing::valley::Valley;
use corners::Corners;
use sections::SPARE;
use stop::THROUGH_SLOWER;

/// Shares of the allowed speed that braking for a lower override ends at, tried in this order.
const BRAKE_TO: [f64; 5] = [1.0, 0.85, 0.65, 0.4, 0.15];

/// Cells that are planned at once at most, besides those that are planned again. What is left comes in the periods after;
/// until then the path is planned to rest before it.
const MOST_CELLS: u64 = 1000;

/// They reach as far as the speed at their start does in this time, s: twice as far as braking for as long.
const REACH: f64 = 2.0;

/// Stretches that are run before a plan that failed is tried again.
const PATIENCE: usize = 8;

/// Final stretches before the path that are enough: planning on would bring nothing forward.
const ENOUGH: usize = 4096;

/// Where no section is found behind a corner it is tried with so much less of its pace, down to this share; of so many
/// corners at once.
const SLOWER_CORNER: f64 = 0.75;
const LEAST_SHARE: f64 = 0.2;
const SLOW_CORNERS: usize = 16;

/// How often a plan from rest is tried with slower corners.
const ROUNDS: i32 = 8;

/// So many new cells are worth a plan: few, but many where [`AHEAD`] stretches before the path are final. Every plan ends at rest
/// where no more is known, and most of what it has there is planned again.
const FEW_CELLS: u64 = 64;
const AHEAD: usize = 300;
const MANY_CELLS: u64 = 800;

/// A stretch of the plan.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Stretch {
    Piece(Piece),
    /// A corner, at a pace.
    Corner {
        s: f64,
        end: f64,
        cell: u64,
        pace: f64,
        foot: Foot,
        time: f64,
    },
    /// Every axis on its own.
    Axes {
        s: f64,
        cell: u64,
    },
    /// The path rests at the end of this cell.
    Rest {
        s: f64,
        cell: u64,
    },
}

impl Stretch {
    /// Where it ends.
    pub fn end(&self) -> f64 {
        match *self {
            Stretch::Piece(piece) => piece.end(),
            Stretch::Corner { end, .. } => end,
            Stretch::Axes { s, .. } | Stretch::Rest { s, .. } => s,
        }
    }

    /// Duration, s; of moves of every axis on its own it is not known here.
    pub fn duration(&self) -> f64 {
        match *self {
            Stretch::Piece(piece) => piece.time,
            Stretch::Corner { time, pace, .. } => time / pace,
            Stretch::Axes { .. } | Stretch::Rest { .. } => 0.0,
        }
    }
}

/// What is brought back with the plan before.
#[derive(Clone, Copy, Debug)]
struct Kept {
    from: usize,
    fixed: usize,
    next: Start,
    planned: u64,
}

/// The plan: what is to be run, and what is final of it.
#[derive(Debug)]
pub(crate) struct Plan {
    stretches: Vec<Stretch>,
    /// The one being run.
    current: usize,
    /// How many are final; planning goes on behind them.
    fixed: usize,
    next: Start,
    /// The first cell that is not planned.
    planned: u64,
    /// Cells from this one on count as not known yet.
    horizon: u64,
    overrides: Overrides,
    grid: Grid,
    valley: Valley,
    inverses: Inverses,
    /// A section as the grid planned it.
    rough: Vec<Piece>,
    /// Number of the first stretch of the list.
    base: u64,
    /// The plan before from stretch `kept.from` of the list on, should the new one fail.
    before: Vec<Stretch>,
    kept: Kept,
    brake: Brake,
    /// Corners behind which a section was not to be planned, and the share of their pace that is tried.
    slow: Vec<(u64, f64)>,
    /// The corner behind which the section lies that was not to be planned.
    blamed: Option<u64>,
    /// The corners ahead.
    chain: Chain,
    /// A corner was passed that may be run faster once more of the path is known.
    is_open: bool,
    /// Stretches to be run before planning is tried again.
    patience: usize,
}

/// Most stretches: every step of the sections that are known.
pub(crate) const STRETCHES: usize = 4 * CELLS;

/// Most stretches of a stop: braking, what was planned before a corner, and the lines and corners that are passed.
pub(crate) const STOPPING: usize = PIECES + SPARE + 8 * KNOTS;

impl Plan {
    /// `lowest` is the slowest cutting, mm/s.
    pub fn new(inverses: Inverses, lowest: f64) -> Plan {
        let start = Start { port: Port { s: 0.0, state: State::REST }, cell: 0 };
        Plan {
            stretches: Vec::with_capacity(STRETCHES),
            current: 0,
            fixed: 0,
            next: start,
            planned: 0,
            horizon: 0,
            overrides: Overrides { feed: 1.0, rapid: 1.0, rapid_speed: f64::INFINITY, rpm: None, lowest },
            grid: Grid::new(),
            valley: Valley::new(),
            inverses,
            rough: Vec::with_capacity(crate::timing::grid::STEPS + 8),
            base: 0,
            before: Vec::with_capacity(STRETCHES),
            kept: Kept { from: 0, fixed: 0, next: start, planned: 0 },
            brake: Brake::new(),
            slow: Vec::with_capacity(SLOW_CORNERS),
            blamed: None,
            chain: Chain::new(),
            is_open: false,
            patience: 0,
        }
    }

    pub fn overrides(&self) -> Overrides {
        self.overrides
    }

    pub fn set_overrides(&mut self, overrides: Overrides) {
        self.overrides = overrides;
    }

    /// The stretch being run.
    pub fn current(&self) -> Option<&Stretch> {
        self.stretches.get(self.current)
    }

    /// Number of the stretch being run.
    pub fn number(&self) -> u64 {
        self.base + self.current as u64
    }

    /// The stretches from number `number` on.
    pub fn from(&self, number: u64) -> &[Stretch] {
        let skip = usize::try_from(number.saturating_sub(self.base)).unwrap_or(usize::MAX);
        self.stretches.get(skip..).unwrap_or(&[])
    }

    /// Goes on to the next stretch.
    pub fn advance(&mut self) {
        self.current += 1;
        self.patience = self.patience.saturating_sub(1);
    }

    /// Whether what comes behind the stretch being run is not final, though more cells are known.
    pub fn is_short(&self, queue: &Queue) -> bool {
        self.current + 1 >= self.fixed && self.planned < queue.tail() && self.patience == 0
    }

    /// Whether so much is new that planning it is worth while, and not enough is final already.
    pub fn is_due(&self, queue: &Queue) -> bool {
        let new = queue.tail() - self.planned;
        let ahead = self.fixed.saturating_sub(self.current);
        let has_enough = ahead >= ENOUGH;
        let again = self.planned.saturating_sub(self.next.cell);
        let least = if ahead >= AHEAD { MANY_CELLS } else { FEW_CELLS };
        let is_much = new >= least.max(again);
        // What ends at rest is all there is for now: the sooner it is known, the more can be done for it.
        let is_last = new > 0 && new >= again / 8 && queue.node(queue.tail() - 1).rests;
        self.patience == 0 && !has_enough && (is_much || is_last)
    }

    /// Forgets everything.
    pub fn clear(&mut self, queue: &Queue) {
        self.stretches.clear();
        self.patience = 0;
        self.base += self.current as u64;
        self.current = 0;
        self.fixed = 0;
        self.next.cell = queue.head();
        self.planned = queue.head();
    }

    /// Plans everything behind this moment again, because the overrides are others. The path is `t` seconds inside the
    /// stretch being run. `None` if no plan is possible from there: then the one before stands, and it is to be tried
    /// again later. Else what is another, from the stretch being run on.
    pub fn renew(&mut self, queue: &Queue, t: f64) -> Option<u64> {
        self.keep(true);
        self.cut(t);
        let changed = self.number();
        let Some(start) = self.behind_current(queue) else { return Some(changed) };
        let fixed = self.stretches.len().min(self.current + 1);
        self.stretches.truncate(fixed);
        // Of the plan before nothing behind this moment is final.
        (self.fixed, self.next) = (fixed, start);
        let is_planned = self.renew_from(queue, start)
            || !self.can_stop_on_line(queue, start)
                && self.through_corners(queue, start, THROUGH_SLOWER, false, |plan, at| {
                    plan.renew_from(queue, at)
                });
        if is_planned {
            return Some(changed);
        }
        self.give_up(queue);
        None
    }

    /// Whether the path is on a line before a corner that is long enough to stop on.
    fn can_stop_on_line(&self, queue: &Queue, start: Start) -> bool {
        let State { v, a } = start.port.state;
        let line = self.line_before(queue, start.cell + 1, start.port.s);
        line.is_some_and(|line| STOP_ROOM * Foot { v, a: a.max(0.0) }.room(line.drive) <= line.len)
    }

    /// Plans everything behind the last stretch again, from `start` on.
    fn renew_from(&mut self, queue: &Queue, start: Start) -> bool {
        let fixed = self.stretches.len();
        self.look_ahead(queue, start, start.cell);
        for corners in [Corners::BOLD, Corners::SAFE] {
            if self.sections_behind(queue, start, fixed, corners) {
                return true;
            }
        }
        let limit = self.limit(queue, start.cell, false);
        for share in BRAKE_TO {
            self.stretches.truncate(fixed);
            let target = share * self.overrides.cap(queue.node(start.cell.min(queue.tail() - 1)));
            if !(target < start.port.state.v) || !self.brake(queue, start, target, limit) {
                continue;
            }
            let end = self.brake.pieces().last().map_or(start.port.s, Piece::end);
            self.stretches.extend(self.brake.pieces().iter().map(|piece| Stretch::Piece(*piece)));
            let port = Port { s: end, state: State { v: target, a: 0.0 } };
            let behind = Start { port, cell: queue.find(start.cell, end) };
            let braked = self.stretches.len();
            self.look_ahead(queue, behind, behind.cell);
            if self.sections_behind(queue, behind, braked, Corners::SAFE) {
                return true;
            }
        }
        self.stretches.truncate(fixed);
        false
    }

    /// Plans the cells behind what is final, to rest at the last one. `at` is where the path begins if nothing is
    /// planned. From which stretch on the plan is another; `None` if it stands.
    pub fn plan(&mut self, queue: &Queue, at: f64) -> Option<u64> {
        self.keep(false);
        if self.stretches.is_empty() {
            let s = at.max(queue_start(queue, queue.head()));
            let cell = queue.find(queue.head(), s);
            self.next = Start { port: Port { s, state: State::REST }, cell };
            self.fixed = 0;
        } else if self.fixed <= self.current {
            let next = self.behind_current(queue)?;
            self.next = next;
            self.fixed = self.stretches.len().min(self.current + 1);
        }
        let (start, fixed) = (self.next, self.fixed);
        self.look_ahead(queue, start, self.planned.max(start.cell));
        let is_rest = start.port.state == State::REST;
        let slower = (0..if is_rest { ROUNDS } else { 1 }).map(|round| Corners::SAFE.slower(round));
        let corners = std::iter::once(Corners::BOLD).chain(slower);
        let planned =
            self.plan_behind(queue, start, fixed, corners).or_else(|| self.plan_from_current(queue));
        if planned.is_none() {
            self.give_up(queue);
        }
        planned
    }

    /// Plans from `start` on, behind the first `fixed` stretches, with the first of `corners` with which there is a plan. From
    /// which stretch on the plan is another.
    fn plan_behind(
        &mut self,
        queue: &Queue,
        start: Start,
        fixed: usize,
        mut corners: impl Iterator<Item = Corners>,
    ) -> Option<u64> {
        let is_planned = corners.any(|corners| self.sections_behind(queue, start, fixed, corners));
        is_planned.then(|| self.base + fixed as u64)
    }

    /// Plans from `start` on, behind the first `fixed` stretches, with corners as slow as it takes.
    fn sections_behind(&mut self, queue: &Queue, start: Start, fixed: usize, corners: Corners) -> bool {
        self.slow.clear();
        loop {
            self.stretches.truncate(fixed);
            (self.next, self.fixed) = (start, fixed);
            if self.sections(queue, start, corners) {
                return true;
            }
            if !self.slow_down_corner() {
                return false;
            }
        }
    }

    /// Tries the corner behind which no section was found at a lower pace. `false` if there is none, or it was tried.
    fn slow_down_corner(&mut self) -> bool {
        let Some(cell) = self.blamed.take() else { return false };
        if let Some((_, share)) = self.slow.iter_mut().find(|(slow, _)| *slow == cell) {
            *share *= SLOWER_CORNER;
            return *share > LEAST_SHARE;
        }
        let has_room = self.slow.len() < SLOW_CORNERS;
        if has_room {
            self.slow.push((cell, SLOWER_CORNER));
        }
        has_room
    }

    /// Plans everything behind the stretch being run, what is final too: where the path is as fast as it may be there can be
    /// no way to slow down for what has come to be known, and from further back there is. From which stretch on the plan is
    /// another.
    fn plan_from_current(&mut self, queue: &Queue) -> Option<u64> {
        self.restore();
        if self.fixed <= self.current + 1 {
            return None;
        }
        let start = self.behind_current(queue)?;
        self.keep(true);
        self.plan_behind(queue, start, self.current + 1, [Corners::BOLD, Corners::SAFE].into_iter())
    }

    /// Decides how far a plan from `start` looks, of which the cells up to `known` are planned again.
    fn look_ahead(&mut self, queue: &Queue, start: Start, known: u64) {
        let far = start.port.s + REACH * start.port.state.v;
        self.horizon = queue.tail().min(known + MOST_CELLS);
        while self.horizon < queue.tail() && queue.node(self.horizon).s < far {
            self.horizon += 1;
        }
    }

    /// Notes the plan as it is. The stretches before the one being run are forgotten when they are as many as the others:
    /// so each is moved once, about.
    fn keep(&mut self, cuts: bool) {
        if 2 * self.current >= self.stretches.len() || self.stretches.len() + SPARE > STRETCHES / 2 {
            let gone = self.current.min(self.stretches.len());
            self.stretches.drain(..gone);
            self.fixed = self.fixed.saturating_sub(gone);
            self.current -= gone;
            self.base += gone as u64;
        }
        // What is final stays, unless the stretch being run is cut.
        let from = (if cuts { self.current } else { self.fixed }).min(self.stretches.len());
        self.before.clear();
        self.before.extend_from_slice(&self.stretches[from..]);
        self.kept = Kept { from, fixed: self.fixed, next: self.next, planned: self.planned };
    }

    /// The plan noted stands.
    fn restore(&mut self) {
        self.stretches.truncate(self.kept.from);
        self.stretches.extend_from_slice(&self.before);
        (self.fixed, self.next) = (self.kept.fixed, self.kept.next);
    }

    /// The plan before the last that was made stands, as if that had never been made.
    pub fn undo(&mut self) {
        self.restore();
        self.planned = self.kept.planned;
    }

    /// Nothing is run behind what was run so far.
    pub fn end_here(&mut self) {
        self.keep(true);
        self.stretches.truncate(self.current);
        self.fixed = self.stretches.len();
    }

    /// The plan noted stands; planning is tried again when a part of it was run.
    fn give_up(&mut self, queue: &Queue) {
        self.restore();
        // Where nothing more will come it is the same that is tried again.
        self.planned =
            if self.horizon < queue.tail() { self.horizon.max(self.kept.planned) } else { self.kept.planned };
        self.patience = PATIENCE.min(self.stretches.len().saturating_sub(self.current));
    }

    /// Ends the stretch being run at this moment, if it can be left.
    fn cut(&mut self, t: f64) {
        if let Some(Stretch::Piece(piece)) = self.stretches.get_mut(self.current)
            && t < piece.time
        {
            *piece = piece.until(t);
        }
    }

    /// The state behind the stretch being run.
    fn behind_current(&self, queue: &Queue) -> Option<Start> {
        self.stretches.get(self.current).map(|stretch| behind(queue, stretch))
    }

    /// Everything so far is final, planning goes on from `start`.
    fn fix(&mut self, start: Start) {
        self.fix_to(self.stretches.len(), start);
    }

    /// The first so many stretches are, unless they are behind a corner that may yet be run faster.
    fn fix_to(&mut self, count: usize, start: Start) {
        if !self.is_open {
            (self.fixed, self.next) = (count, start);
        }
    }
}

/// The state behind a stretch.
fn behind(queue: &Queue, stretch: &Stretch) -> Start {
    match *stretch {
        Stretch::Piece(piece) => {
            let s = piece.end();
            Start { port: Port { s, state: piece.to }, cell: queue.find(queue.head(), s) }
        }
        Stretch::Corner { end, cell, pace, foot, .. } => {
            let foot = paced(foot, pace);
            Start { port: Port { s: end, state: State { v: foot.v, a: foot.a } }, cell: cell + 1 }
        }
        Stretch::Axes { cell, .. } | Stretch::Rest { cell, .. } => {
            let s = queue_start(queue, cell + 1);
            Start { port: Port { s, state: State::REST }, cell: cell + 1 }
        }
    }
}

/// Where cell `number` begins; if it does not exist yet, where the last one ends.
fn queue_start(queue: &Queue, number: u64) -> f64 {
    if number < queue.tail() {
        queue.node(number).s
    } else if number > queue.head() {
        queue.node(number - 1).end()
    } else {
        0.0
    }
}
