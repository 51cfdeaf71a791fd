//! Look-ahead: how fast the cells are run through.
//!
//! **Valleys first.** Between two points at which the path has no acceleration (at rest, or at a steady speed)
//! the cell that allows the least speed is looked for. If a ramp from the point before and a ramp from the
//! point behind reach that speed, the cell is run at it: it is a steady stretch, and what lies before and what lies
//! behind are two smaller questions of the same kind, in which every cell allows more. If they do not reach it, the
//! speed rises to the summit at which the two ramps meet. A ramp thus goes over as many cells as it needs; it has
//! no acceleration only where it begins and ends, and it is under the bounds of the cells that it really
//! crosses.
//!
//! **Always to rest.** The end of the queue is planned to rest whatever may follow, so a feeder that falls
//! behind stops the machine on the path, within limits.
//!
//! **What is final.** A steady stretch at the full speed of its cell can be braked from whatever follows, and
//! more cells can only move its end on. So everything before its beginning is as it would be with the whole program
//! known, and planning goes on from there when more cells have come. Planning a chunk when as many cells are new as
//! are not final costs every cell about two sweeps, however long braking takes.
//!
//! **Corners** rounded in time are fixed points between such questions: their speed and acceleration are known. They
//! are run at a lower pace where the lines beside them are too short to stop on, or slower than the corner.

use crate::limits::{Class, Drive};
use crate::path::corner::{pace_below, paced};
use crate::timing::queue::{Node, Pass, Queue};
use crate::timing::ramp::{Foot, Phases, distance, most_speed, summit};

/// Overrides as factors.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Overrides {
    pub feed: f64,
    pub rapid: f64,
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

    /// Highest speed in a cell, mm/s.
    #[inline]
    fn cap(&self, node: &Node) -> f64 {
        let feed = if node.feed.is_finite() { node.feed } else { node.top };
        // At override 0 the path is held, or passes what it cannot be stopped before.
        let share = Some(self.of(node.class)).filter(|share| *share > 0.0).unwrap_or(HELD_SHARE);
        node.top.min(feed * share).max(LEAST_SPEED)
    }
}

/// What is planned with while the override is 0.
const HELD_SHARE: f64 = 0.05;

/// Slower than this nothing is planned, mm/s.
const LEAST_SPEED: f64 = 1e-6;

/// Lengths this close are the same, mm.
const SAME_LENGTH: f64 = 1e-9;

/// How often a drive is lowered before it is looked for more coarsely.
const ROUNDS: usize = 8;

/// A cell is no valley if it is crossed at less than this share of what it allows.
const REACH_SHARE: f64 = 0.9;

/// How many summits are tried where the bounds depend on them.
const MOST_SUMMITS: usize = 12;

/// Paces that are tried for a corner.
const PACES: i32 = 40;

/// See [`Plan::ramp_past`].
const PAST_SHARE: f64 = 0.6;

/// Cells whose speeds differ by less are one valley.
const SAME_SPEED: f64 = 1.003;

/// A ramp down to a third of a speed takes up to 1.089 times the length of the ramp down to rest. Lines beside
/// corners are this much longer than stopping takes, so that any speed can be reached on them.
const STOP_ROOM: f64 = 1.1;

/// A stretch of the plan.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Stretch {
    /// From `foot` at `s` up to the speed `v` at `end`, or, if `is_down`, from `v` at `s` down to `foot` at `end`.
    Ramp { s: f64, end: f64, foot: Foot, v: f64, drive: Drive, is_down: bool },
    /// From `s` to `end` at the speed `v`.
    Steady { s: f64, end: f64, v: f64 },
    /// A corner, at a pace.
    Corner { s: f64, end: f64, cell: u64, pace: f64, foot: Foot, time: f64 },
    /// Every axis on its own.
    Axes { s: f64, cell: u64 },
    /// The path rests at the end of this cell.
    Rest { s: f64, cell: u64 },
}

impl Stretch {
    /// Where it ends.
    pub fn end(&self) -> f64 {
        match *self {
            Stretch::Ramp { end, .. } | Stretch::Steady { end, .. } | Stretch::Corner { end, .. } => end,
            Stretch::Axes { s, .. } | Stretch::Rest { s, .. } => s,
        }
    }

    /// The state at its end.
    pub fn exit(&self) -> Foot {
        match *self {
            Stretch::Ramp { foot, is_down: true, .. } => foot,
            Stretch::Ramp { v, .. } | Stretch::Steady { v, .. } => Foot::still(v),
            Stretch::Corner { foot, .. } => foot,
            Stretch::Axes { .. } | Stretch::Rest { .. } => Foot::default(),
        }
    }

    /// The state at its start.
    fn entry(&self) -> Foot {
        match *self {
            Stretch::Ramp { v, is_down: true, .. } | Stretch::Steady { v, .. } => Foot::still(v),
            Stretch::Ramp { foot, .. } | Stretch::Corner { foot, .. } => foot,
            Stretch::Axes { .. } | Stretch::Rest { .. } => Foot::default(),
        }
    }

    /// Duration, s; of moves of every axis on its own it is not known here.
    pub fn duration(&self) -> f64 {
        match *self {
            Stretch::Ramp { foot, v, drive, .. } => Phases::new(foot, v, drive).total(),
            Stretch::Steady { s, end, v } => (end - s) / v,
            Stretch::Corner { time, pace, .. } => time / pace,
            Stretch::Axes { .. } | Stretch::Rest { .. } => 0.0,
        }
    }
}

/// A point between questions.
#[derive(Clone, Copy, Debug)]
struct Point {
    s: f64,
    foot: Foot,
    /// The cell on the side of the question.
    cell: u64,
}

/// A ramp known to fit into a question.
#[derive(Clone, Copy, Debug)]
struct Direct {
    drive: Drive,
    way: f64,
    /// Whether all cells that it crosses allow it; else those that do not are still to be looked at.
    is_sure: bool,
}

/// Something still to be planned.
#[derive(Clone, Copy, Debug)]
enum Task {
    Between {
        left: Point,
        right: Point,
        direct: Direct,
    },
    Done(Stretch),
    /// A steady stretch at the full speed of its cell that begins in this one.
    Final {
        cell: u64,
    },
}

/// The plan: what is to be run, and what is final of it.
#[derive(Debug)]
pub(crate) struct Plan {
    stretches: Vec<Stretch>,
    /// The one being run.
    current: usize,
    /// How many are final; planning goes on behind them.
    fixed: usize,
    /// Where planning goes on: the first cell that is not final.
    next: u64,
    /// Cells planned so far.
    planned: u64,
    overrides: Overrides,
    caps: Vec<f64>,
    tasks: Vec<Task>,
    /// The plan before, should the new one ask for more than the bounds allow.
    before: Vec<Stretch>,
    failed: bool,
}

/// Most stretches a cell takes: up, steady and down.
const STRETCHES: usize = 3;

impl Plan {
    pub fn new() -> Plan {
        use crate::timing::queue::CELLS;
        Plan {
            stretches: Vec::with_capacity(STRETCHES * CELLS + 64),
            current: 0,
            fixed: 0,
            next: 0,
            planned: 0,
            overrides: Overrides { feed: 1.0, rapid: 1.0 },
            caps: vec![0.0; CELLS],
            tasks: Vec::with_capacity(STRETCHES * CELLS + 64),
            before: Vec::with_capacity(STRETCHES * CELLS + 64),
            failed: false,
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

    /// Goes on to the next stretch.
    pub fn advance(&mut self) {
        self.current += 1;
    }

    /// Whether what comes behind the stretch being run is not final, though more cells are known.
    pub fn is_short(&self, queue: &Queue) -> bool {
        self.current + 1 >= self.fixed && self.planned < queue.tail()
    }

    /// Whether so much is new that planning it is worth while.
    pub fn is_due(&self, queue: &Queue) -> bool {
        let new = queue.tail() - self.planned;
        new >= 64 && new >= self.planned.saturating_sub(self.next)
    }

    /// Forgets everything.
    pub fn clear(&mut self, queue: &Queue) {
        self.stretches.clear();
        self.current = 0;
        self.fixed = 0;
        self.next = queue.head();
        self.planned = queue.head();
    }

    /// Plans everything behind the stretch being run again, because the overrides are others. The path is at `s`.
    /// `false` if the new plan is not possible from there: then the one before stands, and it is to be tried again
    /// behind the stretch being run.
    pub fn renew(&mut self, queue: &Queue, s: f64) -> bool {
        let current = self.stretches.get(self.current).copied();
        let fixed = self.fixed;
        // A steady stretch can be left at any moment.
        if let Some(Stretch::Steady { end, .. }) = self.stretches.get_mut(self.current) {
            *end = end.min(s);
        }
        self.fixed = 0;
        let is_possible = self.attempt(queue, s);
        if !is_possible {
            if let (Some(slot), Some(current)) = (self.stretches.get_mut(self.current), current) {
                *slot = current;
            }
            self.fixed = fixed.min(self.stretches.len());
        }
        is_possible
    }

    /// Plans the cells behind what is final, to rest at the last one. `at` is where the path begins if nothing is
    /// final.
    pub fn plan(&mut self, queue: &Queue, at: f64) {
        self.attempt(queue, at);
    }

    fn attempt(&mut self, queue: &Queue, at: f64) -> bool {
        self.before.clear();
        self.before.extend_from_slice(&self.stretches);
        let (current, fixed, next, planned) = (self.current, self.fixed, self.next, self.planned);
        self.failed = false;
        self.plan_behind(queue, at);
        self.failed |= !self.is_continuous();
        if self.failed && current < self.before.len() {
            std::mem::swap(&mut self.before, &mut self.stretches);
            (self.current, self.fixed, self.next) = (current, fixed, next);
            // Not before there is something new.
            self.planned = if planned < queue.tail() { queue.tail() } else { planned };
            return false;
        }
        true
    }

    /// Keeps nothing behind the stretch being run, and brings the path to rest with the stretches of `stop`.
    fn stop_with(&mut self, keep_current: bool, stop: [Option<Stretch>; 2]) {
        self.stretches.truncate(self.current + usize::from(keep_current));
        self.stretches.extend(stop.into_iter().flatten());
        self.fixed = self.stretches.len();
    }

    /// Brings the path to rest as soon as the bounds allow; it is at `s`, `t` seconds inside the stretch being run, in
    /// cell `cell`. The time inside the stretch that is then run; `None` if the path cannot be stopped before a corner
    /// or a rest, or within the stretch being run: then try again behind it.
    pub fn stop(&mut self, queue: &Queue, s: f64, t: f64, cell: u64) -> Option<f64> {
        let begin = |s: f64, foot: Foot, cell: u64| self.halt(queue, Point { s, foot, cell });
        match *self.stretches.get(self.current)? {
            Stretch::Steady { v, .. } => {
                let stop = begin(s, Foot::still(v), cell)?;
                self.stop_with(false, stop);
                Some(0.0)
            }
            Stretch::Ramp { s: from, foot, v, drive, is_down: false, .. } => {
                let (way, v, a) = Phases::new(foot, v, drive).at(foot, t);
                let foot = Foot { v, a: a.max(0.0) };
                let top = foot.top(drive.j);
                let rise = Phases::new(foot, top, drive);
                let (way_up, ..) = rise.at(foot, rise.total());
                let s = from + way;
                let crest = s + way_up;
                let stop = begin(crest, Foot::still(top), cell)?;
                let up = Stretch::Ramp { s, end: crest, foot, v: top, drive, is_down: false };
                self.stop_with(false, [Some(up), stop[0]]);
                Some(0.0)
            }
            Stretch::Ramp { s: from, end, foot, v, drive, is_down: true } => {
                if foot.a > 0.0 {
                    return None;
                }
                let phases = Phases::new(foot, v, drive);
                let (left, now, a) = phases.at(foot, phases.total() - t);
                let s = end - left;
                let a = a.max(0.0).min(drive.a);
                // The ramp to rest of which this state is a part.
                let high = now + a * a / (2.0 * drive.j);
                let gone = a / drive.j;
                let since = gone * (high - drive.j * gone * gone / 6.0);
                let way = distance(0.0, high, drive);
                let (s, end) = (s - since, s - since + way);
                let _ = from;
                if end > self.limit(queue, cell) {
                    return None;
                }
                let last = self.find(queue, cell, end).min(queue.tail().saturating_sub(1));
                let holds = |cell: u64| {
                    let node = queue.node(cell);
                    let here = high.min(most_speed(Foot::default(), (end - node.s).max(0.0), drive));
                    node.load.holds(high, here, drive)
                };
                if !(cell..=last).all(holds) {
                    return None;
                }
                let ramp = Stretch::Ramp { s, end, foot: Foot::default(), v: high, drive, is_down: true };
                self.stop_with(false, [Some(ramp), None]);
                Some(gone)
            }
            Stretch::Corner { .. } | Stretch::Axes { .. } | Stretch::Rest { .. } => None,
        }
    }

    /// Where the next corner or rest is.
    fn limit(&self, queue: &Queue, from: u64) -> f64 {
        let mut cell = from;
        while cell < queue.tail() {
            let node = queue.node(cell);
            match node.pass {
                Pass::Path if !node.rests => cell += 1,
                Pass::Path => return node.end(),
                // With a way left to start again.
                Pass::Corner { .. } => return node.s - node.len,
                Pass::Axes => return node.s,
            }
        }
        queue_start(queue, cell)
    }

    /// From a steady speed to rest.
    fn halt(&self, queue: &Queue, from: Point) -> Option<[Option<Stretch>; 2]> {
        let v = from.foot.v;
        let limit = self.limit(queue, from.cell);
        if limit <= from.s {
            return None;
        }
        let (drive, way) = self.ramp(queue, from, 0.0, limit, true)?;
        let foot = Foot::default();
        Some([Some(Stretch::Ramp { s: from.s, end: from.s + way, foot, v, drive, is_down: true }), None])
    }

    /// The cell of `queue` from `from` on that `s` lies in.
    fn find(&self, queue: &Queue, from: u64, s: f64) -> u64 {
        let mut cell = from;
        while cell < queue.tail() {
            let node = queue.node(cell);
            if node.end() > s + 1e-12 || node.rests {
                break;
            }
            cell += 1;
        }
        cell
    }

    fn cap(&self, cell: u64) -> f64 {
        self.caps[(cell % self.caps.len() as u64) as usize]
    }

    /// Whether every stretch begins as the one before it ends.
    fn is_continuous(&self) -> bool {
        self.stretches.windows(2).all(|pair| {
            let (exit, entry) = (pair[0].exit(), pair[1].entry());
            (exit.v - entry.v).abs() <= 1e-6 * (1.0 + exit.v)
        })
    }

    fn plan_behind(&mut self, queue: &Queue, at: f64) {
        // What is being run stays.
        if self.fixed <= self.current {
            let mut last = self.current;
            // Who slows down into a corner passes it as planned.
            if let Some(Stretch::Ramp { foot, is_down: true, .. }) = self.stretches.get(last) {
                last += usize::from(foot.a > 0.0);
            }
            self.fixed = self.stretches.len().min(last + 1);
            self.next = match self.stretches.get(last) {
                Some(
                    Stretch::Corner { cell, .. } | Stretch::Axes { cell, .. } | Stretch::Rest { cell, .. },
                ) => cell + 1,
                Some(stretch) => self.find(queue, queue.head(), stretch.end()),
                // Without a stretch the path is at rest where it is.
                None => self.find(queue, queue.head(), at),
            };
        }
        self.stretches.truncate(self.fixed);
        // What was run is forgotten.
        if self.current > 0 {
            self.stretches.drain(..self.current);
            self.fixed -= self.current;
            self.current = 0;
        }
        self.next = self.next.max(queue.head());
        for cell in self.next..queue.tail() {
            let slot = (cell % self.caps.len() as u64) as usize;
            self.caps[slot] = self.overrides.cap(queue.node(cell));
        }
        let (s, foot) = match self.stretches.last() {
            Some(Stretch::Rest { cell, .. } | Stretch::Axes { cell, .. }) => {
                (queue_start(queue, cell + 1), Foot::default())
            }
            Some(last) => (last.end(), last.exit()),
            None => (at.max(queue_start(queue, self.next)), Foot::default()),
        };
        self.planned = queue.tail();
        let mut left = Point { s, foot, cell: self.next };
        while left.cell < queue.tail() {
            left = self.leg(queue, left);
        }
    }

    /// Plans from `left` to the next corner or rest; where planning goes on.
    fn leg(&mut self, queue: &Queue, left: Point) -> Point {
        // Where the leg ends: before a corner, at a rest, at the end of the queue.
        let mut last = left.cell;
        loop {
            let node = queue.node(last);
            match node.pass {
                Pass::Axes => {
                    self.stretches.push(Stretch::Axes { s: node.s, cell: last });
                    self.fix(last + 1);
                    return Point { s: queue_start(queue, last + 1), foot: Foot::default(), cell: last + 1 };
                }
                Pass::Corner { foot, time } => {
                    return self.leg_to_corner(queue, left, last, foot, time);
                }
                Pass::Path if node.rests || last + 1 == queue.tail() => break,
                Pass::Path => last += 1,
            }
        }
        let node = queue.node(last);
        let right = Point { s: node.end(), foot: Foot::default(), cell: last };
        self.between(queue, left, right);
        if node.rests {
            self.stretches.push(Stretch::Rest { s: node.end(), cell: last });
            self.fix(last + 1);
        }
        Point { s: queue_start(queue, last + 1), foot: Foot::default(), cell: last + 1 }
    }

    fn leg_to_corner(&mut self, queue: &Queue, left: Point, cell: u64, foot: Foot, time: f64) -> Point {
        let node = queue.node(cell);
        let before = Point { s: node.s, foot, cell: cell.saturating_sub(1) };
        let after = Point { s: node.end(), foot, cell: cell + 1 };
        let from = if left.foot.a > 0.0 || left.foot.v > 0.0 { None } else { Some(left.s) };
        let has_after = cell + 1 < queue.tail();
        let stops = |pace: f64| {
            let foot = paced(foot, pace);
            let back = left.cell >= cell || self.stops(queue, Point { foot, ..before }, false, from);
            back && has_after && self.stops(queue, Point { foot, ..after }, true, None)
        };
        let jerk = |neighbour: u64| queue.node(neighbour).load.most().j;
        let j = jerk(before.cell.max(queue.head())).min(jerk(after.cell.min(queue.tail() - 1)));
        let most = pace_below(foot, self.cap(cell), j);
        let mut pace = largest(most, stops);
        if (left.foot.a > 0.0 || left.foot.v > 0.0) && left.cell < cell {
            // Under way, what lies between must be possible: neither too fast nor too slow for it.
            let len = node.s - left.s;
            let possible = |pace: f64| {
                let foot = paced(foot, pace);
                let Some(rest) = self.crossing(queue, left, Point { foot, ..before }) else { return false };
                rest <= len
            };
            if !possible(pace) {
                let scan = (1..PACES).map(|k| pace * 0.88_f64.powi(k)).find(|pace| possible(*pace));
                let faster = (0..PACES).map(|k| most * 0.88_f64.powi(k)).find(|pace| possible(*pace));
                pace = scan.or(faster).unwrap_or_else(|| {
                    self.failed = true;
                    pace
                });
            }
        }
        let foot = paced(foot, pace);
        self.between(queue, left, Point { foot, ..before });
        self.stretches.push(Stretch::Corner { s: node.s, end: node.end(), cell, pace, foot, time });
        if has_after {
            self.fix(cell + 1);
        }
        Point { foot, ..after }
    }

    /// Least length between two states: up to the higher of the speeds at which their accelerations are gone, and
    /// down to the other.
    fn crossing(&self, queue: &Queue, left: Point, right: Point) -> Option<f64> {
        let most = |point: Point| queue.node(point.cell).load.most().j;
        let mut top = left.foot.top(most(left)).max(right.foot.top(most(right))) * (1.0 + 1e-9);
        for _ in 0..3 {
            let up = self.ramp(queue, left, top, right.s, true);
            let down = self.ramp(queue, right, top, left.s, false);
            if let (Some(up), Some(down)) = (up, down) {
                return Some(up.1 + down.1);
            }
            // A lower jerk on the way lets the speed rise further.
            top *= 1.15;
        }
        None
    }

    /// Whether the path can be stopped beside a corner before the next corner, rest or end; `limit` if it begins
    /// there.
    fn stops(&self, queue: &Queue, from: Point, forward: bool, limit: Option<f64>) -> bool {
        let limit = limit.unwrap_or(if forward { f64::INFINITY } else { f64::NEG_INFINITY });
        self.beside(queue, from, forward, limit).is_some()
    }

    /// Drive beside a corner, and the length of taking its acceleration back and of stopping then; `None` if there is
    /// no room for that.
    fn beside(&self, queue: &Queue, from: Point, forward: bool, limit: f64) -> Option<(Drive, f64)> {
        let mut drive = Drive::MOST;
        let mut cell = from.cell;
        loop {
            if cell >= queue.tail() || cell < queue.head() {
                return None;
            }
            let node = queue.node(cell);
            if node.pass != Pass::Path || (!forward && node.rests) {
                return None;
            }
            let top = from.foot.top(node.load.most().j.min(drive.j));
            if top > self.cap(cell) {
                return None;
            }
            drive = drive.min(node.load.drive(0.0, top, top));
            let top = from.foot.top(drive.j);
            let need = from.foot.distance(top, drive)? + STOP_ROOM * distance(0.0, top, drive);
            let covered = if forward { node.end() - from.s } else { from.s - node.s };
            if need <= covered.min((from.s - limit).abs()) {
                return Some((drive, need));
            }
            if (forward && node.rests) || (limit - from.s).abs() <= covered {
                return None;
            }
            if forward {
                cell += 1;
            } else if cell > 0 {
                cell -= 1;
            } else {
                return None;
            }
        }
    }

    fn fix(&mut self, next: u64) {
        self.fixed = self.stretches.len();
        self.next = next;
    }

    /// Least drive of the cells `from`…`to` for ramps between `low` and `high`.
    fn drive(&self, queue: &Queue, from: u64, to: u64, low: f64, high: f64) -> Drive {
        let mut drive = Drive::MOST;
        for cell in from..=to {
            let node = queue.node(cell);
            drive = drive.min(node.load.drive(low, high, node.top));
        }
        drive
    }

    /// Drive for a summit of `high` between `left` and `right`.
    fn summit_drive(&self, queue: &Queue, left: Point, right: Point, high: f64) -> Drive {
        let low = left.foot.v.min(right.foot.v);
        let mut drive = queue.node(left.cell).load.drive(low, high, left.foot.v.max(1.0));
        for round in 0..ROUNDS {
            let mut least = drive;
            for cell in left.cell..=right.cell {
                let node = queue.node(cell);
                let from_left = most_speed(left.foot, (node.end() - left.s).max(0.0), drive);
                let from_right = most_speed(right.foot, (right.s - node.s).max(0.0), drive);
                let here = high.min(from_left).min(from_right);
                if !node.load.holds(high, here, least) {
                    least = least.min(node.load.drive(low, high, here));
                }
            }
            if least == drive {
                break;
            }
            drive = least;
            if round + 2 == ROUNDS {
                return self.drive(queue, left.cell, right.cell, low, high).min(drive);
            }
        }
        drive
    }

    /// The ramp between `from` and the speed `v`, under the bounds of the cells that it crosses: its drive and
    /// length. `None` if it would go beyond `limit`.
    ///
    /// How fast it is in a cell depends on the drive, and the drive on how fast it is: begun with what the first cell
    /// allows, the drive is lowered until it holds in all of them.
    fn ramp(&self, queue: &Queue, from: Point, v: f64, limit: f64, forward: bool) -> Option<(Drive, f64)> {
        self.ramp_past(queue, from, v, limit, forward, 1.0)
    }

    /// The same past cells that it would cross at more than a share of what they allow: they are valleys of their own
    /// and looked at later.
    fn ramp_past(
        &self,
        queue: &Queue,
        from: Point,
        v: f64,
        limit: f64,
        forward: bool,
        share: f64,
    ) -> Option<(Drive, f64)> {
        let room = (limit - from.s).abs() + 1e-12;
        let is_up = v >= from.foot.v;
        if !is_up && from.foot.a > 0.0 {
            return None;
        }
        let (low, high) = (v.min(from.foot.v), v.max(from.foot.v));
        let foot = if is_up { from.foot } else { Foot::still(v) };
        let mut drive = queue.node(from.cell).load.drive(low, high, if is_up { low.max(1.0) } else { high });
        for round in 0..2 * ROUNDS {
            let way = foot.distance(high, drive)?;
            if way > room {
                return None;
            }
            let mut least = drive;
            let mut cell = from.cell;
            loop {
                let node = queue.node(cell);
                // Far end of the cell, seen from the slow end of the ramp.
                let (near, far) = if forward {
                    (node.s - from.s, node.end() - from.s)
                } else {
                    (from.s - node.end(), from.s - node.s)
                };
                let x = if is_up { far.min(way) } else { way - near.max(0.0) };
                let here = high.min(most_speed(foot, x.max(0.0), drive));
                let here = if share < 1.0 { here } else { here.min(node.top) };
                if here <= node.top * share && !node.load.holds(high, here, least) {
                    least = least.min(node.load.drive(low, high, here));
                }
                if way <= far + 1e-12 {
                    break;
                }
                if forward {
                    cell += 1;
                    if cell >= queue.tail() {
                        return None;
                    }
                } else {
                    if cell <= self.next {
                        return None;
                    }
                    cell -= 1;
                }
            }
            if least == drive {
                return Some((drive, way));
            }
            drive = least;
            if round > ROUNDS {
                drive = Drive { a: 0.9 * drive.a, j: 0.9 * drive.j };
            }
        }
        None
    }

    /// Plans from `left` to `right`, between which there is no corner and no rest.
    fn between(&mut self, queue: &Queue, left: Point, right: Point) {
        if right.cell < left.cell || right.cell >= queue.tail() || right.s <= left.s {
            return;
        }
        let direct = self.direct(queue, left, right);
        self.tasks.clear();
        self.tasks.push(Task::Between { left, right, direct });
        // Every split leaves smaller questions; rounding shall not make them many.
        let mut budget = 4 * (right.cell - left.cell) as usize + 64;
        while let Some(task) = self.tasks.pop() {
            budget = budget.saturating_sub(1);
            match task {
                Task::Done(stretch) => {
                    if stretch.end() > stretch_start(&stretch) {
                        self.stretches.push(stretch);
                    }
                }
                Task::Final { cell } => {
                    // Not within a corner's escape.
                    self.fixed = self.stretches.len();
                    self.next = cell;
                }
                Task::Between { left, right, direct } if budget > 0 => self.split(queue, left, right, direct),
                Task::Between { left, right, direct } => {
                    let least = (left.cell..=right.cell).map(|cell| self.cap(cell)).fold(f64::MAX, f64::min);
                    self.rise(queue, left, right, direct, least);
                }
            }
        }
    }

    /// The ramp between both ends, which fits by what was planned before.
    fn direct(&self, queue: &Queue, left: Point, right: Point) -> Direct {
        // From the higher end, where the bounds are narrower.
        let (low, high) = (left.foot.v.min(right.foot.v), left.foot.v.max(right.foot.v));
        let at_left = left.foot.v > right.foot.v;
        let found = if at_left {
            self.ramp(queue, Point { foot: Foot::still(high), ..left }, low, right.s, true)
        } else {
            self.ramp(queue, Point { foot: Foot::still(high), ..right }, low, left.s, false)
        };
        let (drive, way) = found.unwrap_or_else(|| {
            let drive = self.drive(queue, left.cell, right.cell, low, high);
            (drive, distance(low, high, drive))
        });
        Direct { drive, way, is_sure: false }
    }

    /// One question: the valley between `left` and `right`, or the summit if it is not reached.
    fn split(&mut self, queue: &Queue, left: Point, right: Point, direct: Direct) {
        let total = right.s - left.s;
        if total <= 0.0 || left.cell > right.cell {
            return;
        }
        // The valley: the cell that allows the least, of those that can be reached at what they allow.
        let free = self.free(queue, left, right);
        let (mut valley, mut v, mut most) = (left.cell, f64::INFINITY, 0.0_f64);
        for cell in left.cell..=right.cell {
            let cap = self.cap(cell);
            most = most.max(cap);
            if cap < v {
                let node = queue.node(cell);
                let from_left = most_speed(left.foot, (node.end() - left.s).max(0.0), free);
                let from_right = most_speed(right.foot, (right.s - node.s).max(0.0), free);
                if from_left.min(from_right) >= REACH_SHARE * cap {
                    (valley, v) = (cell, cap);
                }
            }
        }
        if v == f64::INFINITY {
            return self.rise(queue, left, right, direct, most);
        }
        // And the cells beside it that allow the same.
        let (mut first, mut last) = (valley, valley);
        // A ramp does not pass one and a half times its speed within this.
        let near = 2.0 * v * (0.5 * v / queue.node(valley).load.most().j).sqrt();
        let belongs = |cap: f64, far: f64| cap <= v * SAME_SPEED || (cap <= 1.5 * v && far <= near);
        while first > left.cell
            && belongs(self.cap(first - 1), queue.node(valley).s - queue.node(first - 1).s)
        {
            first -= 1;
        }
        while last < right.cell
            && belongs(self.cap(last + 1), queue.node(last + 1).end() - queue.node(valley).end())
        {
            last += 1;
        }
        let from = queue.node(first).s.max(left.s);
        let to = queue.node(last).end().min(right.s);
        // Where the acceleration behind a corner goes beyond the valley it is taken back at once.
        for (is_left, point) in [(true, left), (false, right)] {
            if point.foot.a > 0.0 && v < point.foot.top(queue.node(point.cell).load.most().j) {
                return self.escape(queue, left, right, direct, is_left);
            }
        }
        let down = self.ramp(queue, right, v, left.s, false);
        if left.foot.v > v && right.foot.v <= v {
            // Coming down into the valley, as late as possible; at the speed behind it if it leaves no room for more.
            let (v, begin, end) = match down {
                Some((_, way)) => {
                    (v, from.min(right.s - way), to.min(right.s - way).max(from.min(right.s - way)))
                }
                None => (right.foot.v, from, right.s),
            };
            if begin > left.s {
                let still =
                    Point { s: begin, foot: Foot::still(v), cell: self.cell_before(queue, left.cell, begin) };
                for share in [1.0, PAST_SHARE] {
                    let ramp = self.ramp_past(queue, still, left.foot.v, left.s, false, share);
                    if let Some((drive, way)) = ramp {
                        let direct = Direct { drive, way, is_sure: false };
                        let down = down.unwrap_or((drive, 0.0));
                        return self.valley(
                            queue,
                            (left, right),
                            (begin, end, v),
                            (Some(direct), Some(down)),
                        );
                    }
                }
            }
        }
        let up = self.ramp(queue, left, v, right.s, true);
        let (Some(up), Some(down)) = (up, down) else {
            return self.rise(queue, left, right, direct, v);
        };
        if up.1 + down.1 > total + 1e-12 {
            return self.rise(queue, left, right, direct, v);
        }
        let begin = from.max(left.s + up.1).min(right.s - down.1);
        let end = to.min(right.s - down.1).max(begin);
        let before = Direct { drive: up.0, way: up.1, is_sure: true };
        self.valley(queue, (left, right), (begin, end, v), (Some(before), Some(down)));
    }

    /// A steady stretch between two smaller questions.
    fn valley(
        &mut self,
        queue: &Queue,
        (left, right): (Point, Point),
        (begin, end, v): (f64, f64, f64),
        (before, down): (Option<Direct>, Option<(Drive, f64)>),
    ) {
        let (Some(before), Some(down)) = (before, down) else { return };
        let still = |s, cell| Point { s, foot: Foot::still(v), cell };
        // Behind the valley.
        if right.s - down.1 > end + SAME_LENGTH {
            let direct = Direct { drive: down.0, way: down.1, is_sure: true };
            let left = still(end, self.cell_at(queue, left.cell, end));
            self.tasks.push(Task::Between { left, right, direct });
        } else {
            self.tasks.push(Task::Done(ramp_between(v, end, right, down.0, false)));
        }
        self.tasks.push(Task::Done(Stretch::Steady { s: begin, end, v }));
        if end > begin {
            self.tasks.push(Task::Final { cell: self.cell_at(queue, left.cell, begin) });
        }
        // Before the valley.
        if left.s + before.way < begin - SAME_LENGTH {
            let right = still(begin, self.cell_before(queue, left.cell, begin));
            self.tasks.push(Task::Between { left, right, direct: before });
        } else {
            let ramp = ramp_between(v, begin, left, before.drive, true);
            self.failed |= !before.is_sure && !self.keeps(queue, left.cell, &ramp);
            self.tasks.push(Task::Done(ramp));
        }
    }

    /// Whether the cells from `from` on allow a ramp.
    fn keeps(&self, queue: &Queue, from: u64, ramp: &Stretch) -> bool {
        let Stretch::Ramp { s, end, foot, v, drive, is_down } = *ramp else { return true };
        let mut cell = from;
        while cell < queue.tail() && queue.node(cell).s < end {
            let node = queue.node(cell);
            let x = if is_down { end - node.s } else { node.end() - s };
            let here = v.min(most_speed(foot, x.clamp(0.0, end - s), drive));
            if node.end() > s && (here > node.top * (1.0 + 1e-6) || !node.load.holds(v, here, drive)) {
                return false;
            }
            cell += 1;
        }
        true
    }

    /// The cell, from `from` on, that ends at or behind `s`.
    fn cell_before(&self, queue: &Queue, from: u64, s: f64) -> u64 {
        let cell = self.cell_at(queue, from, s);
        if s <= queue.node(cell).s && cell > from { cell - 1 } else { cell }
    }

    /// More than any ramp between both points uses.
    fn free(&self, queue: &Queue, left: Point, right: Point) -> Drive {
        let a = queue.node(left.cell).load.most();
        let b = queue.node(right.cell).load.most();
        // Axes share the path in other ways between both.
        Drive { a: 3.0 * a.a.max(b.a), j: 3.0 * a.j.max(b.j) }
    }

    fn cell_at(&self, queue: &Queue, from: u64, s: f64) -> u64 {
        let mut cell = from;
        while cell + 1 < queue.tail() && queue.node(cell).end() <= s {
            cell += 1;
        }
        cell
    }

    /// Takes the acceleration beside a corner back at once; the rest is a question without it.
    fn escape(&mut self, queue: &Queue, left: Point, right: Point, _: Direct, is_left: bool) {
        let point = if is_left { left } else { right };
        let limit = if is_left { right.s } else { left.s };
        let drive =
            self.beside(queue, point, is_left, limit).map_or(queue.node(point.cell).load.most(), |(d, _)| d);
        let top = point.foot.top(drive.j);
        let drive = Drive { a: drive.a.max(point.foot.a), ..drive };
        let way = point.foot.distance(top, drive).unwrap_or(0.0);
        if is_left {
            let s = (left.s + way).min(right.s);
            let still = Point { s, foot: Foot::still(top), cell: self.cell_at(queue, left.cell, s) };
            let direct = self.direct(queue, still, right);
            self.tasks.push(Task::Between { left: still, right, direct });
            self.tasks.push(Task::Done(Stretch::Ramp {
                s: left.s,
                end: s,
                foot: left.foot,
                v: top,
                drive,
                is_down: false,
            }));
        } else {
            let s = (right.s - way).max(left.s);
            let mut cell = right.cell;
            while cell > left.cell && queue.node(cell).s >= s {
                cell -= 1;
            }
            let still = Point { s, foot: Foot::still(top), cell };
            let direct = self.direct(queue, left, still);
            self.tasks.push(Task::Done(Stretch::Ramp {
                s,
                end: right.s,
                foot: right.foot,
                v: top,
                drive,
                is_down: true,
            }));
            self.tasks.push(Task::Between { left, right: still, direct });
        }
    }

    /// The valley is not reached: up to a summit below `v` and down again.
    fn rise(&mut self, queue: &Queue, left: Point, right: Point, direct: Direct, v: f64) {
        let total = right.s - left.s;
        let mut best: Option<(f64, Drive)> = None;
        let mut high = v;
        for _ in 0..MOST_SUMMITS {
            let drive = self.summit_drive(queue, left, right, high);
            let low = left.foot.top(drive.j).max(right.foot.top(drive.j));
            let fits = low <= high && drive.a >= left.foot.a.max(right.foot.a);
            let top = fits.then(|| summit(left.foot, right.foot, total, low, high, drive)).flatten();
            match top {
                Some(top) => {
                    if best.is_some_and(|(v, _)| top <= v * 1.002) {
                        break;
                    }
                    best = Some((top, drive));
                    if top >= high * 0.95 {
                        break;
                    }
                    // Lower speeds leave more to the path.
                    high = (top * 1.15).min(high * 0.95);
                }
                None if best.is_some() || high <= left.foot.v.max(right.foot.v) => break,
                None => high = (high * 0.7).max(left.foot.v.max(right.foot.v)),
            }
        }
        if let Some((top, drive)) = best {
            let up = left.foot.distance(top, drive).unwrap_or(0.0);
            let down = right.foot.distance(top, drive).unwrap_or(0.0);
            let (begin, end) = ((left.s + up).min(right.s), (right.s - down).max(left.s));
            let end = end.max(begin);
            self.tasks.push(Task::Done(ramp_between(top, end, right, drive, false)));
            self.tasks.push(Task::Done(Stretch::Steady { s: begin, end, v: top }));
            self.tasks.push(Task::Done(ramp_between(top, begin, left, drive, true)));
            return;
        }
        if left.foot.a > 0.0 {
            return self.escape(queue, left, right, direct, true);
        }
        if right.foot.a > 0.0 {
            return self.escape(queue, left, right, direct, false);
        }
        let (low, high) = (left.foot.v.min(right.foot.v), left.foot.v.max(right.foot.v));
        let is_down = left.foot.v > right.foot.v;
        self.failed |= direct.way > total * (1.0 + 1e-6) + SAME_LENGTH;
        let way = direct.way.min(total);
        let foot = Foot::still(low);
        let ramp = |s: f64| Stretch::Ramp { s, end: s + way, foot, v: high, drive: direct.drive, is_down };
        // What is left of the way is run at the higher speed.
        let placed = ramp(if is_down { right.s - way } else { left.s });
        self.failed |= !direct.is_sure && !self.keeps(queue, left.cell, &placed);
        let v = high.max(LEAST_SPEED);
        if is_down {
            self.tasks.push(Task::Done(placed));
            self.tasks.push(Task::Done(Stretch::Steady { s: left.s, end: right.s - way, v }));
        } else {
            self.tasks.push(Task::Done(Stretch::Steady { s: left.s + way, end: right.s, v }));
            self.tasks.push(Task::Done(placed));
        }
    }
}

/// The ramp between the steady speed `v` at `s` and `point`, which lies before it or behind it.
fn ramp_between(v: f64, s: f64, point: Point, drive: Drive, point_is_left: bool) -> Stretch {
    let (s, end) = if point_is_left { (point.s, s) } else { (s, point.s) };
    if point.foot.v <= v {
        Stretch::Ramp { s, end, foot: point.foot, v, drive, is_down: !point_is_left }
    } else {
        Stretch::Ramp { s, end, foot: Foot::still(v), v: point.foot.v, drive, is_down: point_is_left }
    }
}

fn stretch_start(stretch: &Stretch) -> f64 {
    match *stretch {
        Stretch::Ramp { s, .. }
        | Stretch::Steady { s, .. }
        | Stretch::Corner { s, .. }
        | Stretch::Axes { s, .. }
        | Stretch::Rest { s, .. } => s,
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

/// Largest number up to `most` for which `fits` holds, which holds for small ones.
fn largest(most: f64, fits: impl Fn(f64) -> bool) -> f64 {
    if fits(most) {
        return most;
    }
    let (mut low, mut high) = (0.0, most);
    for _ in 0..40 {
        let middle = 0.5 * (low + high);
        if fits(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    low.max(1e-6)
}
