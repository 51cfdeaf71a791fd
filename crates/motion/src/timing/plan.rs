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

use crate::limits::{Class, Drive, Inverses, Limits, MAX_SPINDLE_OVERRIDE};
use crate::path::corner::{pace_below, paced};
use crate::timing::beside::{self, Beside};
use crate::timing::brake::{Brake, PIECES, Start};
use crate::timing::chain::{Chain, KNOTS, Line};
use crate::timing::grid::{ALIKE, Grid, Port};
use crate::timing::piece::{Piece, State};
use crate::timing::queue::{CELLS, Node, Pass, Queue, SAME_LENGTH};
use crate::timing::ramp::{Foot, Phases, STOP_ROOM, summit};
use crate::timing::valley::Valley;
use ferrocut_geometry::AXES;

/// Overrides as factors, and what else the programmed speed depends on as it is run.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Overrides {
    pub feed: f64,
    pub rapid: f64,
    /// No axis positions faster than this, mm/s or degrees/s.
    pub rapid_speed: f64,
    /// Speed of the spindle, r/min, which feeds per revolution follow; as they were given where it is not known.
    pub rpm: Option<f64>,
    /// Slowest cutting, mm/s.
    pub lowest: f64,
}

impl Overrides {
    /// The factor that holds for `class`.
    pub fn of(&self, class: Class) -> f64 {
        match class {
            Class::Rapid => self.rapid,
            Class::Cut => self.feed,
            Class::Full | Class::Locked => 1.0,
        }
    }

    /// Highest speed of each axis that positions on its own, mm/s or degrees/s.
    pub fn rapid_speeds(&self, limits: &Limits) -> [f64; AXES] {
        limits.rapid.map(|rapid| (rapid * self.rapid).min(self.rapid_speed))
    }

    /// The factor of the programmed speed of a cell.
    #[inline]
    pub fn share(&self, node: &Node) -> f64 {
        let turns = match self.rpm {
            Some(rpm) if node.follows_spindle() => (rpm / node.basis).min(MAX_SPINDLE_OVERRIDE),
            _ => 1.0,
        };
        self.of(node.class) * turns
    }

    /// Highest speed in a cell, mm/s.
    #[inline]
    fn cap(&self, node: &Node) -> f64 {
        node.top.min(self.feed(node)).max(LEAST_SPEED)
    }

    /// The same, curves aside.
    fn most(&self, node: &Node) -> f64 {
        node.most.min(self.feed(node)).max(LEAST_SPEED)
    }

    /// The programmed speed as it is now.
    #[inline]
    fn feed(&self, node: &Node) -> f64 {
        let feed = if node.feed.is_finite() { node.feed } else { node.most };
        // At override 0 the path is held, or passes what it cannot be stopped before.
        let share = Some(self.share(node)).filter(|share| *share > 0.0).unwrap_or(HELD_SHARE);
        match node.class {
            Class::Rapid => (feed * share).min(self.rapid_speed / node.basis),
            Class::Cut | Class::Full => (feed * share).max(self.lowest),
            Class::Locked => feed * share,
        }
    }
}

/// What is planned with while the override is 0.
const HELD_SHARE: f64 = 0.05;

/// Slower than this nothing is planned, mm/s.
const LEAST_SPEED: f64 = 1e-6;

/// At a corner that could only be run at a lower share of its pace the path stops instead; two that are run as one are run as
/// slowly as there is a need to, which is no slower than this: beside them there is a way to stop on.
const LEAST_PACE: f64 = 0.1;
const LEAST_LINK_PACE: f64 = 1e-3;

/// Shares of the allowed speed that braking for a lower override ends at, tried in this order.
const BRAKE_TO: [f64; 5] = [1.0, 0.85, 0.65, 0.4, 0.15];

/// Cells that are planned at once at most, besides those that are planned again. What is left comes in the periods after;
/// until then the path is planned to rest before it.
const MOST_CELLS: u64 = 256;

/// They reach as far as the speed at their start does in this time, s: twice as far as braking for as long.
const REACH: f64 = 2.0;

/// Stretches that are run before a plan that failed is tried again.
const PATIENCE: usize = 8;

/// Final stretches before the path that are enough: planning on would bring nothing forward.
const ENOUGH: usize = 4096;

/// Pieces from rest and to rest that stay as they are.
const AT_REST: usize = 3;

/// Pieces that valleys may add to a section.
const DEEPER: usize = 1024;

/// Pieces that are followed with less speed take this long at most, s.
const EASE_STEP: f64 = 0.004;

/// Valleys are this much slower than the feed.
const DEEP: f64 = 0.9;

/// Shares of the pace of a corner that are tried where it cannot be come to at the whole.
const CORNER_PACES: [f64; 6] = [1.0, 0.95, 0.88, 0.75, 0.55, 0.3];

/// Where no section is found behind a corner it is tried with so much less of its pace, down to this share; of so many
/// corners at once.
const SLOWER_CORNER: f64 = 0.75;
const LEAST_SHARE: f64 = 0.2;
const SLOW_CORNERS: usize = 16;

/// Through how many corners a stop goes at most, and at which paces they are tried; and a lower override. The lowest pace is not
/// below a share that falls from corner to corner: one that is run slowly takes longer than several.
const THROUGH_STOPPING: (usize, &[f64]) = (KNOTS, &[1.0, 0.75, 0.5, 0.25, 0.0]);
const THROUGH_SLOWER: (usize, &[f64]) = (8, &[0.0]);
const THROUGH_LEAST: f64 = 0.5;
const THROUGH_FALL: f64 = 0.85;

/// Before a corner there is a way left on which the path starts again to run it at this pace at least.
const START_PACE: f64 = 0.2;

/// How often a plan from rest is tried with slower corners.
const ROUNDS: i32 = 8;

/// How fast corners are taken.
#[derive(Clone, Copy, PartialEq, Debug)]
struct Corners {
    /// Share of the pace.
    share: f64,
    /// On curves beside them the acceleration counts that a ramp from the corner has where it is, not that at the corner
    /// at a multiple of the speed.
    is_bold: bool,
}

impl Corners {
    /// In this order they are tried.
    const BOLD: Corners = Corners { share: 1.0, is_bold: true };
    const SAFE: Corners = Corners { share: 1.0, is_bold: false };

    fn slower(self, round: i32) -> Corners {
        Corners { share: self.share * 0.3_f64.powi(round), ..self }
    }
}

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
        let has_enough = self.fixed >= self.current + ENOUGH;
        let again = self.planned.saturating_sub(self.next.cell);
        let is_much = new >= 64 && new >= again;
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
    fn through_corners(
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
    fn brake(&mut self, queue: &Queue, start: Start, target: f64, limit: f64) -> bool {
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
    fn limit(&self, queue: &Queue, from: u64, or_thread: bool) -> f64 {
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

    /// Plans from `start` to the end of what is known. `false` if a section cannot be planned.
    fn sections(&mut self, queue: &Queue, start: Start, corners: Corners) -> bool {
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

    /// Highest pace of the corner in `cell`, to which the path goes from `from`: all that is behind it can be slowed down for,
    /// and it can be come to. Whether it is so whatever comes behind what is known.
    fn pace(&mut self, queue: &Queue, cell: u64, foot: Foot, from: &Port, corners: Corners) -> (f64, bool) {
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
    fn goes_on_behind(&self, queue: &Queue, cell: u64) -> bool {
        let more = if self.horizon < queue.tail() { beside::CELLS as u64 } else { 1 };
        cell + more < self.horizon
    }

    /// The one line on which the path comes from `s` to the corner in `cell`.
    fn line_before(&self, queue: &Queue, cell: u64, s: f64) -> Option<Line> {
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
                    found = self.valley.run(queue, &self.inverses, plan, cell, most, cap);
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
    fn line(&mut self, from: Port, to: Port, cap: f64, drive: Drive, open: Option<u64>) -> bool {
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

/// Whether a cell is a straight line on which the path runs on.
fn is_line(node: &Node) -> bool {
    node.pass == Pass::Path && !node.rests && node.load.is_straight()
}

fn least_pace(is_link: bool) -> f64 {
    if is_link { LEAST_LINK_PACE } else { LEAST_PACE }
}

/// Room that one section takes: its steps, what valleys add, and what ends it.
const SPARE: usize = crate::timing::grid::STEPS + DEEPER + 16;

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
