//! How fast a section of path may be run: passes over steps.
//!
//! A **section** goes from one state to another over cells that may be run through. It is divided into **steps**,
//! [`TAU`] of motion long. `x = v²` is found for the middle `g` of every step; in between `x(s)` is the quadratic
//! B-spline with these values as control points, which has a continuous slope and never lies above the highest of
//! three neighbours. Six passes, each over all steps once:
//!
//! 1. *Cells*: the speed at their ends by acceleration alone, forward and backward. This is more than jerk allows, so
//!    what the bounds leave at this speed may be used.
//! 2. *Bounds*: in every step the acceleration and jerk that are left to the path. Where the plan then turns out much
//!    slower, a curve takes less of them than was thought, and they are found once more at about the speed planned.
//! 3. *Foresight*: acceleration can only be taken back at the pace of the jerk, so where the bound of acceleration
//!    falls, the acceleration before is bounded too; of braking the same, mirrored.
//! 4. *Speeding up* from every valley, forward, and *slowing down* into every valley, backward: acceleration grows with
//!    the jerk from 0 where the speed is capped. The lower of both speeds.
//! 5. *Summits*: what grew must be taken back. Acceleration is `x′/2` and jerk `x″·v/2`, so that a jerk of at most `J`
//!    means `x″ ≥ −G`, `G = 2J/v`. With `H″ = G` that says that `x + H` is convex. The highest such profile that is
//!    nowhere above the one found is the **lower convex hull** of `x + H`, one pass with a stack.
//! 6. *Check* of every piece, from the start of a step to its end, against all bounds as they are. Where one is passed,
//!    passes 2 to 5 are made again with less, from the last place before it where some steps are at their cap to the first such
//!    place behind it: what lies beyond does not depend on it. From rest to rest a uniform slow-down ends this for certain,
//!    because speed, acceleration and jerk fall with `λ`, `λ²` and `λ³`.
//!
//! Everything left of a step at which the speed is the cap does not depend on what follows the section either.

use crate::limits::Room;
use crate::quick::{larger, smaller};
use crate::timing::piece::{Piece, ROUNDING, State, acceleration_behind, step};
use crate::timing::queue::{CELL_RING, Node, Pass, Queue};
use crate::timing::ramp::{Foot, most_speed, way_up};
use std::ops::Range;

/// Length of steps in time, s.
const TAU: f64 = 0.004;

/// The same where turns are few: what is lost is found again in the valleys ([`crate::timing::valley`]).
const TAU_OF_FEW: f64 = 0.007;

/// Cells that are run in less time than so many times that are one step: where the path turns they are many, and what is lost by taking
/// the lowest of their bounds is found again in the valley there ([`crate::timing::valley`]).
const BRIEF: f64 = 1.5;

/// The first step from rest at least, where the jerk is not limited, s.
const FIRST: f64 = TAU / 16.0;

/// Steps at the highest speed grow by this share of what lies before and behind, up to this time, s.
const GROWTH: f64 = 0.3;
const LONGEST: f64 = 0.1;

/// Most steps of a section; what is behind is planned later.
pub(crate) const STEPS: usize = 4096;

/// Share of the jerk and of the acceleration that the passes use; the rest is for what pieces deviate from them.
const JERK_SHARE: f64 = 0.97;
const ACCELERATION_SHARE: f64 = 0.995;

/// How often a section is planned with less where a piece is beyond its bounds.
const ROUNDS: usize = 16;

/// How much less is used there: what makes up for the excess, this much more, and by a little more every round.
const LESS: f64 = 0.98;
const EVERY_ROUND: f64 = 0.01;
const SAFELY_LESS: f64 = 0.88;

/// On curves where turns are few, this share is used from the first round on, but for the ways from rest and to rest: nearly
/// always it is enough, and valleys ([`crate::timing::valley`]) use what it leaves.
const SHARE_OF_FEW: f64 = 0.9;

/// Nothing is lessened below this share at once.
const MUCH_LESS: f64 = 0.7;
const LEAST_SHARE: f64 = 0.02;

/// Bounds found at more than this times the speed of a plan are found again at that speed, with so much to spare.
const FAR_ABOVE: f64 = 1.25;
const ABOVE: f64 = 1.1;

/// A step of the uniform slow-down.
const SLOWER: f64 = 0.9;

/// Caps that differ by no more than this share are one, the lowest.
pub(crate) const ALIKE: f64 = 5e-4;

/// Only where the curve would allow so many times as much, which is where the feed is the cap.
const FREE: f64 = 1.02;

/// Cells shorter than this are no more than a cap on the speed, mm.
const LEAST_STEP: f64 = 1e-9;

/// A speed this close to a cap is the cap.
const TOUCH: f64 = 1e-9;

/// Steps that a section is divided into at least, about.
const FEWEST: f64 = 12.0;

/// Steps at the cap that follow the place where planning goes on, if there is such a place.
const RUN: usize = 4;

/// Slower summits count as this fast, mm/s.
const LEAST_SUMMIT: f64 = 1e-6;

/// How a plan is looked for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Care {
    /// In longer steps, with bounds found once and summits rounded once. There may be no way to a corner then where there is one with
    /// others.
    Rough,
    /// With the bounds at about the speed that results.
    Bold,
    /// With bounds at more than that speed, where this fails.
    Safe,
}

impl Care {
    /// Length of steps in time, s.
    fn tau(self) -> f64 {
        if self == Care::Rough { TAU_OF_FEW } else { TAU }
    }
}

/// What decides the speed of a step.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
enum By {
    /// A ramp up, of which the states are known.
    Up,
    /// A ramp down.
    Down,
    /// What is allowed.
    Cap,
    /// A summit.
    #[default]
    Summit,
}

/// A ramp through a step and what it was worked out for. Where a section is planned again because a few of its pieces were
/// beyond their bounds, most steps are entered as before.
#[derive(Clone, Copy, Debug, Default)]
struct Climb {
    state: State,
    most: f64,
    to: [State; 2],
}

/// A step.
#[derive(Clone, Copy, Debug, Default)]
struct Step {
    /// Where it begins, mm.
    s: f64,
    h: f64,
    /// The cells that it lies in, the last one included.
    cell: u64,
    last: u64,
    /// Highest speed, here and in the steps beside it.
    cap: f64,
    /// More than the speed here, and the time that takes.
    most: f64,
    time: f64,
    /// From the middle of the step before to that of the step behind, or to the ends of the section.
    gap: f64,
    /// `1/(h₀ + h)`, with the length `h₀` of the step before.
    both: f64,
    /// What is left to the path at that speed.
    room: Room,
    /// Acceleration left, and jerk left at no acceleration and at that one: the share of it that is used.
    a: f64,
    j: [f64; 2],
    /// `(j₁ − j₀)/a`.
    slack: f64,
    /// Acceleration and braking at its start and its end, with foresight.
    up: [f64; 2],
    down: [f64; 2],
    /// Share of the bounds that is used.
    share: f64,
    by: By,
    /// Speed squared, and acceleration, in the middle.
    x: f64,
    slope: f64,
    /// The same with summits rounded.
    rounded: f64,
    /// State at its start: on a ramp up, on a ramp down, and as planned.
    rising: State,
    falling: State,
    from: State,
    /// Whether its bounds are other than in the last pass that went over it.
    is_new: bool,
}

/// What is known of a step from the pass before. Apart from it: most passes do without.
#[derive(Clone, Copy, Debug, Default)]
struct Known {
    up: Climb,
    down: Climb,
    /// The ends of a piece that keeps its bounds.
    good: Option<[State; 2]>,
}

impl Step {
    fn middle(&self) -> f64 {
        self.s + 0.5 * self.h
    }

    /// Whether the speed is the highest that is allowed.
    fn is_at_cap(&self) -> bool {
        self.x >= self.cap * self.cap * (1.0 - TOUCH)
    }

    /// The loads that it is under.
    #[inline]
    fn nodes<'a>(&self, queue: &'a Queue) -> impl Iterator<Item = &'a Node> + use<'a> {
        (self.cell..=self.last).map(|cell| queue.node(cell))
    }

    /// What is left to the path all along it at the speed `v`.
    #[inline]
    fn room_at(&self, queue: &Queue, v: f64) -> Room {
        let mut nodes = self.nodes(queue);
        let room = nodes.next().map_or_else(Room::default, |node| node.load.room(v));
        nodes.fold(room, |room, node| room.min(node.load.room(v)))
    }

    /// [`climb`], unless it is known from the pass before.
    #[inline]
    fn climb(&self, known: &mut Climb, most: f64, state: State) -> [State; 2] {
        if self.is_new || known.state != state || known.most != most {
            *known = Climb { state, most, to: climb(self, most, state) };
        }
        known.to
    }

    /// Jerk left at the acceleration `a`.
    #[inline]
    fn jerk(&self, a: f64) -> f64 {
        self.j[0] + self.slack * smaller(a, self.a)
    }
}

/// Where a section begins or ends.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Port {
    pub s: f64,
    pub state: State,
}

/// The steps of a section.
#[derive(Debug)]
pub(crate) struct Grid {
    steps: Vec<Step>,
    known: Vec<Known>,
    care: Care,
    to: Port,
    /// Speeds at the starts of cells.
    ends: Vec<f64>,
    hull: Vec<(f64, f64, usize)>,
    bulges: Vec<f64>,
    /// `gap/v` of the steps.
    times: Vec<f64>,
    /// Steps of which less is used than before.
    lessened: Vec<Range<usize>>,
    /// Whether the section ends before the port that was asked for, at rest, because there are too many steps.
    pub is_cut: bool,
}

impl Grid {
    pub fn new() -> Grid {
        Grid {
            steps: Vec::with_capacity(STEPS + 8),
            known: Vec::with_capacity(STEPS + 8),
            care: Care::Safe,
            to: Port { s: 0.0, state: State::REST },
            ends: Vec::with_capacity(CELL_RING + 8),
            hull: Vec::with_capacity(STEPS + 8),
            bulges: Vec::with_capacity(STEPS + 8),
            times: Vec::with_capacity(STEPS + 8),
            lessened: Vec::with_capacity(STEPS + 8),
            is_cut: false,
        }
    }

    /// Plans from `from`, in cell `first`, to `to`, in cell `last`; `cap` is the speed allowed in a cell. `false` if no
    /// plan was found that keeps all bounds.
    pub fn plan(
        &mut self,
        queue: &Queue,
        from: Port,
        to: Port,
        first: u64,
        last: u64,
        cap: impl Fn(&Node) -> f64,
    ) -> bool {
        self.to = to;
        self.reach_cells(queue, from, first, last, &cap);
        let are_few = queue.node(first).turns_are_few;
        for care in [Care::Rough, Care::Bold, Care::Safe].into_iter().skip(usize::from(!are_few)) {
            self.to = to;
            self.care = care;
            self.place(queue, from, [first, last], &cap);
            if self.steps.is_empty() {
                return false;
            }
            if self.find(queue, from, last) {
                return true;
            }
        }
        if from.state == State::REST && self.to.state == State::REST {
            for _ in 0..200 {
                for step in &mut self.steps {
                    step.from.v *= SLOWER;
                    step.from.a *= SLOWER * SLOWER;
                }
                if self.check(queue, SAFELY_LESS) {
                    return true;
                }
            }
        }
        false
    }

    /// Hands out the pieces.
    pub fn pieces(&self) -> impl Iterator<Item = Option<Piece>> + '_ {
        let ends = self.steps.iter().skip(1).map(|step| step.from).chain([self.to.state]);
        self.steps.iter().zip(ends).map(|(step, to)| Piece::new(step.s, step.h, step.from, to))
    }

    /// The start of the last step in which the speed is the cap: how many pieces are before it, its cell and place.
    pub fn last_touch(&self) -> Option<(usize, u64, Port)> {
        let inner = self.steps.get(..self.steps.len().saturating_sub(1))?;
        // One that others follow leaves room for another division into steps.
        let run = inner.windows(RUN).rposition(|steps| steps.iter().all(Step::is_at_cap));
        let last = || {
            let last = inner.iter().rposition(Step::is_at_cap)?;
            // On the floor of a turn the path is slowed down before its middle, and speeds up behind.
            let floor = inner[..last].iter().rev().take_while(|step| step.is_at_cap()).count();
            Some(last - floor / 2)
        };
        let k = run.filter(|k| *k > 0).or_else(last)?;
        let step = &self.steps[k];
        (k > 0).then_some((k, step.cell, Port { s: step.s, state: step.from }))
    }

    /// Pass 1.
    fn reach_cells(&mut self, queue: &Queue, from: Port, first: u64, last: u64, cap: &impl Fn(&Node) -> f64) {
        self.ends.clear();
        self.ends.push(from.state.v);
        let mut before = cap(queue.node(first));
        for cell in first + 1..=last {
            let here = cap(queue.node(cell));
            self.ends.push(smaller(before, here));
            before = here;
        }
        self.ends.push(self.to.state.v);
        let to = self.to.s;
        let reach = |cell: u64, v: f64| {
            let node = queue.node(cell);
            let len = smaller(node.end(), to) - larger(node.s, from.s);
            (v * v + 2.0 * node.load.room(v).a * len).sqrt()
        };
        // Where it does not rise nothing is to be reached.
        for i in 0..self.ends.len() - 1 {
            if self.ends[i + 1] > self.ends[i] {
                let reached = reach(first + i as u64, self.ends[i]);
                self.ends[i + 1] = smaller(self.ends[i + 1], reached);
            }
        }
        for i in (0..self.ends.len() - 1).rev() {
            if self.ends[i] > self.ends[i + 1] {
                let reached = reach(first + i as u64, self.ends[i + 1]);
                self.ends[i] = smaller(self.ends[i], reached);
            }
        }
        // A state that is given is.
        self.ends[0] = self.ends[0].max(from.state.v);
    }

    /// The last cell of those from `cell` to `last` over which nothing changes, and the lowest cap there: caps are about
    /// the same, and reached at every end between the cells. `first` is that of the section, which begins at speed `v`.
    fn alike(
        &self,
        queue: &Queue,
        [first, cell, last]: [u64; 3],
        v: f64,
        cap: &impl Fn(&Node) -> f64,
    ) -> (u64, f64) {
        let here = cap(queue.node(cell));
        let lowest = (here * (1.0 - ALIKE)).max(if cell == first { v } else { 0.0 });
        let (mut farthest, mut least) = (cell, here);
        while farthest < last {
            let [node, next] = [queue.node(farthest), queue.node(farthest + 1)];
            let there = cap(next);
            let is_alike = node.pass == Pass::Path
                && next.pass == Pass::Path
                && node.top > FREE * here
                && next.top > FREE * here
                && (lowest..=here * (1.0 + ALIKE)).contains(&there)
                && self.ends[(farthest + 1 - first) as usize] >= smaller(least, there);
            if !is_alike {
                break;
            }
            (farthest, least) = (farthest + 1, smaller(least, there));
        }
        (farthest, least)
    }

    /// The same of cells that are run in less than `most` seconds all together; the section begins at the length `from`.
    fn brief(
        &self,
        queue: &Queue,
        [first, cell, last]: [u64; 3],
        from: f64,
        most: f64,
        cap: &impl Fn(&Node) -> f64,
    ) -> (u64, f64) {
        let begin = queue.node(cell).s.max(from);
        let (mut farthest, mut least) = (cell, cap(queue.node(cell)));
        let end_of = |cell: u64| self.ends[(cell - first) as usize];
        let mut slowest = smaller(smaller(least, end_of(cell)), end_of(cell + 1));
        while farthest < last {
            let [node, next] = [queue.node(farthest), queue.node(farthest + 1)];
            let there = cap(next);
            slowest = smaller(smaller(slowest, there), end_of(farthest + 2));
            let is_path = node.pass == Pass::Path && next.pass == Pass::Path;
            if !is_path || next.end() - begin > most * slowest {
                break;
            }
            (farthest, least) = (farthest + 1, smaller(least, there));
        }
        (farthest, least)
    }

    /// Sets the steps. Where the speed is a cap that goes on over many cells, so do steps.
    fn place(&mut self, queue: &Queue, from: Port, [first, last]: [u64; 2], cap: &impl Fn(&Node) -> f64) {
        let tau = self.care.tau();
        self.steps.clear();
        self.is_cut = false;
        let mut door = f64::INFINITY;
        let mut next = first;
        'cells: while next <= last {
            let mut cell = next;
            let alike = self.alike(queue, [first, cell, last], from.state.v, cap);
            let is_alike = alike.0 > cell;
            let (farthest, here) = if is_alike {
                alike
            } else {
                self.brief(queue, [first, cell, last], from.s, BRIEF * tau, cap)
            };
            let is_brief = !is_alike && farthest > cell;
            next = farthest + 1;
            let (left_node, right_node) = (queue.node(cell), queue.node(farthest));
            let (begin, end) = (larger(left_node.s, from.s), smaller(right_node.end(), self.to.s));
            door = smaller(door, here);
            if end - begin <= LEAST_STEP {
                continue;
            }
            // The steps on both sides keep what is allowed between them.
            if let Some(step) = self.steps.last_mut() {
                step.cap = smaller(step.cap, door);
            }
            let end_of = |cell: u64| self.ends[(cell - first) as usize];
            // What changes the speed at either end is in the cell there.
            let drives = [left_node.load.most(), right_node.load.most()];
            let foot = |cell: u64| Foot::still(smaller(end_of(cell), here));
            let (low, high) = (foot(cell), foot(next));
            // Far enough from an end its speed holds nothing back.
            let free = [way_up(low, here, drives[0]), way_up(high, here, drives[1])];
            let rising = |s: f64| {
                let way = s - begin;
                if way >= free[0] { f64::INFINITY } else { most_speed(low, way, drives[0]) }
            };
            let falling = |s: f64| {
                let way = end - s;
                if way >= free[1] { f64::INFINITY } else { most_speed(high, way, drives[1]) }
            };
            let speed = |s: f64| smaller(smaller(here, rising(s)), falling(s));
            // In the first step from rest the acceleration grows all along: it is as long as that takes, or TAU.
            // However short, a section has room to speed up and slow down in.
            let drive = drives[0].min(drives[1]);
            let time = (drive.a / drive.j).clamp(FIRST, TAU);
            let least = smaller(drive.j * time / 3.0, drive.a) * 0.5 * time * time;
            let least = smaller(least, (self.to.s - from.s) / FEWEST);
            // Over many cells the highest speed is reached that much later: by the jerk, and by what a curve takes from the
            // acceleration there.
            let longer = if farthest > cell {
                let left = left_node.load.room(here).a.min(right_node.load.room(here).a);
                here * drive.a / drive.j + here * here / (2.0 * left)
            } else {
                0.0
            };
            // Where the highest speed begins, and where slowing down for the end begins.
            let mut top_begin = None;
            let top_end = end - (here * here - high.v * high.v).max(0.0) / (2.0 * drives[1].a);
            let mut s = begin;
            while s < end {
                if self.steps.len() >= STEPS {
                    self.is_cut = true;
                    break 'cells;
                }
                while cell < farthest && queue.node(cell).end() <= s + LEAST_STEP {
                    cell += 1;
                }
                let now = speed(s);
                let mut h = smaller(larger(tau * now, least), (self.to.s - from.s) / 4.0);
                if now >= here {
                    // Nothing changes for a while.
                    let begin = *top_begin.get_or_insert(s);
                    let grown = GROWTH * (smaller(s - begin, top_end - s) - longer);
                    h = larger(h, smaller(grown, LONGEST * now));
                }
                // A step that meets a lower speed at its end is shorter.
                let met = speed(smaller(s + h, end));
                if met < here {
                    h = smaller(h, larger(tau * met, least));
                }
                // Of many cells, to the end of one.
                let mut reached = cell;
                while reached < farthest
                    && (is_brief || now >= here && queue.node(reached + 1).end() <= s + h)
                {
                    reached += 1;
                }
                let stop = smaller(queue.node(reached).end(), end);
                let left = stop - s;
                if is_brief || left < 1.5 * h {
                    h = left;
                } else if left < 2.5 * h {
                    h = 0.5 * left;
                }
                let to = if h < left { s + h } else { stop };
                let then = if to < end { speed(to) } else { high.v };
                // Between both the speed may rise above them.
                let between = smaller(rising(s + h), falling(s));
                let most = smaller(here, larger(larger(now, then), between));
                self.steps.push(Step {
                    s,
                    h,
                    cell,
                    last: reached,
                    cap: door,
                    most,
                    share: 1.0,
                    ..Step::default()
                });
                door = here;
                s = to;
            }
        }
        if let Some(step) = self.steps.last_mut() {
            if self.is_cut {
                self.to = Port { s: step.s + step.h, state: State::REST };
            }
            step.h = self.to.s - step.s;
        }
        self.known.clear();
        self.known.resize(self.steps.len(), Known::default());
        let (mut before, mut at) = (None, from.s);
        for i in 0..self.steps.len() {
            let behind = self.steps.get(i + 1).map_or(self.to.s, Step::middle);
            let step = &mut self.steps[i];
            step.time = step.h / step.most;
            step.gap = behind - at;
            step.both = (before.unwrap_or(step.h) + step.h).recip();
            (before, at) = (Some(step.h), step.middle());
        }
    }

    /// Passes 2 to 6, again and again; `false` if no plan was found.
    fn find(&mut self, queue: &Queue, from: Port, last: u64) -> bool {
        self.leave(queue);
        self.spare(queue, [from.state == State::REST, queue.node(last).rests]);
        let all = 0..self.steps.len();
        if !self.rise_and_fall(all.clone(), from.state) {
            return false;
        }
        // With its summits rounded it will be no faster.
        if self.care == Care::Bold && self.come_closer(queue) && !self.rise_and_fall(all.clone(), from.state)
        {
            return false;
        }
        self.round_off(all, from);
        for round in 0..ROUNDS {
            let less = match self.care {
                Care::Rough | Care::Bold => LESS - EVERY_ROUND * round as f64,
                Care::Safe => SAFELY_LESS,
            };
            if self.check(queue, less) {
                return true;
            }
            if !self.pass_about_lessened(from) && !self.pass(from) {
                return false;
            }
        }
        false
    }

    /// Passes 2 to 5; `false` if the path cannot be slowed down from its first state.
    fn pass(&mut self, from: Port) -> bool {
        self.pass_over(0..self.steps.len(), from)
    }

    /// The same about the steps of which less is used: where a steady speed lies between them, each on its own. `false` if that is
    /// not all that changes.
    fn pass_about_lessened(&mut self, from: Port) -> bool {
        let lessened = std::mem::take(&mut self.lessened);
        let mut rest = lessened.iter().cloned();
        let mut goes = true;
        if let Some(mut about) = rest.next() {
            for next in rest {
                let between = self.steps.get(about.end..next.start).unwrap_or(&[]);
                if between.windows(RUN).any(is_steady) {
                    goes = goes && self.pass_about(about, from);
                    about = next;
                } else {
                    about.end = about.end.max(next.end);
                }
            }
            goes = goes && self.pass_about(about, from);
        }
        self.lessened = lessened;
        goes
    }

    /// The same about the steps `changed`, from one place where the speed is the cap to the next: what is beyond stays as it is.
    /// `false` if it does not.
    fn pass_about(&mut self, changed: Range<usize>, from: Port) -> bool {
        let n = self.steps.len();
        let before = self.steps[..changed.start].windows(RUN).rposition(is_steady);
        let behind = self.steps[changed.end..].windows(RUN).position(is_steady);
        let begin = before.map_or(0, |k| k + RUN / 2);
        let end = behind.map_or(n, |k| changed.end + k + RUN / 2);
        if begin == 0 && end == n {
            return false;
        }
        let port = if begin == 0 { from } else { self.port(begin) };
        self.pass_over(begin..end, port)
            && (begin == 0 || is_steady(&self.steps[begin..begin + RUN / 2]))
            && (end == n || is_steady(&self.steps[end - RUN / 2..end]))
    }

    /// Passes 2 to 5 over these steps, which begin at `from`; `false` if the path cannot be slowed down from there.
    fn pass_over(&mut self, range: Range<usize>, from: Port) -> bool {
        let goes = self.rise_and_fall(range.clone(), from.state);
        if goes {
            self.round_off(range, from);
        }
        goes
    }

    /// Pass 5, and the states between the steps.
    fn round_off(&mut self, range: Range<usize>, from: Port) {
        self.round_summits(range.clone(), from);
        self.join(range, from.state);
    }

    /// Passes 2 to 4 over these steps; `false` if the path cannot be slowed down from `from`.
    fn rise_and_fall(&mut self, range: Range<usize>, from: State) -> bool {
        self.bound(range.clone());
        self.foresee(range.clone());
        self.ramp(range, from)
    }

    /// Where the steps before `end` end, and that one begins.
    fn port(&self, end: usize) -> Port {
        self.steps.get(end).map_or(self.to, |step| Port { s: step.s, state: step.from })
    }

    /// What is left to the path in every step.
    fn leave(&mut self, queue: &Queue) {
        for step in &mut self.steps {
            step.room = step.room_at(queue, step.most);
        }
    }

    /// Uses less of that on curves where turns are few ([`SHARE_OF_FEW`]); whether the section begins and ends at rest.
    fn spare(&mut self, queue: &Queue, [from_rest, to_rest]: [bool; 2]) {
        let n = self.steps.len();
        let is_at_cap = |step: &Step| step.most >= step.cap;
        let begin = if from_rest { self.steps.iter().position(is_at_cap).unwrap_or(n) } else { 0 };
        let end = if to_rest { self.steps.iter().rposition(is_at_cap).map_or(0, |k| k + 1) } else { n };
        for step in &mut self.steps[begin.min(end)..end] {
            let is_curve = step.room.j[1] < step.room.j[0];
            if is_curve && queue.node(step.cell).turns_are_few {
                step.share = SHARE_OF_FEW;
            }
        }
    }

    /// Where a step of a curve is run much slower than its bounds were found at, they are found again. Whether there is
    /// such a step.
    fn come_closer(&mut self, queue: &Queue) -> bool {
        let mut comes_closer = false;
        let n = self.steps.len();
        let mut before = self.steps[0].x;
        for i in 0..n {
            let behind = self.steps[(i + 1).min(n - 1)].x;
            let step = &mut self.steps[i];
            let x = larger(larger(before, step.x), behind);
            before = step.x;
            if step.most * step.most > FAR_ABOVE * FAR_ABOVE * x
                && !step.nodes(queue).all(|node| node.load.is_straight())
            {
                step.most = smaller(step.most, ABOVE * larger(x.sqrt(), LEAST_SUMMIT));
                step.time = step.h / step.most;
                step.room = step.room_at(queue, step.most);
                comes_closer = true;
            }
        }
        comes_closer
    }

    /// Pass 2.
    fn bound(&mut self, range: Range<usize>) {
        for step in &mut self.steps[range] {
            let a = step.room.a * step.share * ACCELERATION_SHARE;
            let j = step.room.j.map(|j| j * step.share * JERK_SHARE);
            step.is_new = a != step.a || j != step.j;
            if step.is_new {
                (step.a, step.j, step.slack) = (a, j, (j[1] - j[0]) / a);
            }
        }
    }

    /// Pass 3.
    fn foresee(&mut self, range: Range<usize>) {
        let mut up = self.steps.get(range.end).map_or(f64::INFINITY, |step| step.up[0]);
        for i in range.clone().rev() {
            let before = if i > 0 { self.steps[i - 1].a } else { f64::INFINITY };
            let step = &mut self.steps[i];
            step.up[1] = smaller(up, step.a);
            up = smaller(smaller(before, step.a), step.up[1] + step.j[1] * step.time);
            step.up[0] = up;
        }
        let mut down = range.start.checked_sub(1).map_or(f64::INFINITY, |i| self.steps[i].down[1]);
        for i in range {
            let behind = self.steps.get(i + 1).map_or(f64::INFINITY, |step| step.a);
            let step = &mut self.steps[i];
            step.down[0] = smaller(down, step.a);
            down = smaller(smaller(behind, step.a), step.down[0] + step.j[1] * step.time);
            step.down[1] = down;
        }
    }

    /// Pass 4: the lower of speeding up, forward, and of slowing down, backward. `false` if the path cannot be slowed down from
    /// `from`.
    ///
    /// Both go step by step at the same time: each waits for its own step before, and a processor does one while the other waits.
    fn ramp(&mut self, range: Range<usize>, from: State) -> bool {
        // Mirrored: braking is speeding up.
        let State { v, a } = self.port(range.end).state;
        let (mut rising, mut falling) = (from, State { v, a: -a });
        let first = range.start;
        let (steps, known) = (&mut self.steps[range.clone()], &mut self.known[range]);
        let n = steps.len();
        for i in 0..n {
            let step = &mut steps[i];
            step.rising = rising;
            [_, rising] = step.climb(&mut known[i].up, step.up[1], rising);
            let k = n - 1 - i;
            let step = &mut steps[k];
            [_, falling] = step.climb(&mut known[k].down, step.down[0], falling);
            step.falling = State { v: falling.v, a: -falling.a };
        }
        for (step, known) in steps.iter_mut().zip(known) {
            let ([up, _], [down, _]) = (known.up.to, known.down.to);
            let (high, low) = (up.v * up.v, down.v * down.v);
            (step.x, step.slope, step.by) = if low < high {
                (low, -down.a, By::Down)
            } else {
                (high, up.a, if up.v < step.cap { By::Up } else { By::Cap })
            };
        }
        // Only the first step's cap may be below the state that is given.
        falling.v >= from.v * (1.0 - 1e-9) || self.steps[first].cap < from.v
    }

    /// Pass 5. Which jerk is left depends on the acceleration that results: twice, if that is worth the time.
    fn round_summits(&mut self, range: Range<usize>, from: Port) {
        self.times.clear();
        let steps = self.steps[range.clone()].iter();
        self.times.extend(steps.map(|step| step.gap / larger(step.x.sqrt(), LEAST_SUMMIT)));
        self.lower(range.clone(), from, |steps, i| steps[i].slope.abs());
        if self.care != Care::Rough {
            self.lower(range.clone(), from, |steps, i| {
                let (Some(before), Some(behind)) = (i.checked_sub(1), steps.get(i + 1)) else {
                    return steps[i].slope.abs();
                };
                (0.5 * (behind.rounded - steps[before].rounded) / steps[i].gap).abs()
            });
        }
        for step in &mut self.steps[range] {
            if step.rounded < step.x {
                step.x = step.rounded;
                step.by = By::Summit;
            }
        }
    }

    /// The lower hull, where the acceleration of step `i` is about `slope(steps, i)`.
    fn lower(&mut self, range: Range<usize>, from: Port, slope_of: impl Fn(&[Step], usize) -> f64) {
        let to = self.port(range.end);
        let steps = &self.steps[range.clone()];
        self.bulges.clear();
        let (mut slope, mut bulge, mut at) = (0.0, 0.0, from.s);
        for (i, (step, time)) in steps.iter().zip(&self.times).enumerate() {
            let g = step.middle();
            bulge += slope * (g - at);
            self.bulges.push(bulge);
            slope += step.jerk(slope_of(&self.steps, range.start + i)) * time;
            at = g;
        }
        self.bulges.push(bulge + slope * (to.s - at));
        self.hull.clear();
        self.hull.push((from.s, from.state.v * from.state.v, 0));
        for (i, bulge) in self.bulges.iter().enumerate() {
            let (s, x) = match steps.get(i) {
                Some(step) => (step.middle(), step.x),
                None => (to.s, to.state.v * to.state.v),
            };
            let y = x + bulge;
            while let [.., a, b] = self.hull[..] {
                // Whether `b` is above the line from `a` to here.
                if (b.1 - a.1) * (s - a.0) >= (y - a.1) * (b.0 - a.0) {
                    self.hull.pop();
                } else {
                    break;
                }
            }
            // Number of the step behind.
            self.hull.push((s, y, i + 1));
        }
        let steps = &mut self.steps[range];
        for step in &mut *steps {
            step.rounded = step.x;
        }
        for pair in self.hull.windows(2) {
            let (a, b) = (pair[0], pair[1]);
            if a.2 + 1 >= b.2 {
                continue;
            }
            let slope = (b.1 - a.1) / (b.0 - a.0);
            let between = a.2..b.2 - 1;
            for (step, bulge) in steps[between.clone()].iter_mut().zip(&self.bulges[between]) {
                let x = a.1 + slope * (step.middle() - a.0) - bulge;
                step.rounded = larger(smaller(x, step.x), 0.0);
            }
        }
    }

    /// The states between the steps.
    fn join(&mut self, range: Range<usize>, from: State) {
        self.steps[range.start].from = from;
        for i in range.start + 1..range.end {
            let (before, here) = (&self.steps[i - 1], &self.steps[i]);
            let state = match (before.by, here.by) {
                (By::Up | By::Cap, By::Up) => here.rising,
                (By::Down, By::Down | By::Cap) => here.falling,
                _ => {
                    let x = (before.x * here.h + here.x * before.h) * here.both;
                    State { v: x.sqrt(), a: (here.x - before.x) * here.both }
                }
            };
            self.steps[i].from = state;
        }
    }

    /// Pass 6: whether every piece keeps all bounds; where not, that much less is used next time.
    fn check(&mut self, queue: &Queue, less: f64) -> bool {
        self.lessened.clear();
        let n = self.steps.len();
        for i in 0..n {
            let here = &self.steps[i];
            let to = self.steps.get(i + 1).map_or(self.to.state, |step| step.from);
            // A steady speed that is allowed.
            let is_steady = here.from == to && to.a == 0.0 && to.v > 0.0;
            if is_steady && here.nodes(queue).all(|node| to.v <= node.top) {
                continue;
            }
            if self.known[i].good == Some([here.from, to]) {
                continue;
            }
            let piece = Piece::new(here.s, here.h, here.from, to).filter(Piece::is_forward);
            let most_used =
                |piece: Piece| here.nodes(queue).map(|node| piece.used(&node.load)).fold(0.0, larger);
            let used = piece.map_or(f64::INFINITY, most_used);
            if !(used <= ROUNDING) {
                let less = (less / used).max(MUCH_LESS);
                let about = i.saturating_sub(1)..(i + 2).min(n);
                for step in &mut self.steps[about.clone()] {
                    step.share = (step.share * less).max(LEAST_SHARE);
                }
                self.lessened.push(about);
            } else {
                self.known[i].good = Some([here.from, to]);
            }
        }
        self.lessened.is_empty()
    }
}

/// Whether all of these are at a cap.
fn is_steady(steps: &[Step]) -> bool {
    steps.iter().all(|step| step.by == By::Cap && step.is_at_cap())
}

/// The states in the middle and at the end of a step that is entered in `state` with growing acceleration, which may
/// be `most` at its end. The jerk is constant up to the cap.
#[inline]
fn climb(at: &Step, most: f64, state: State) -> [State; 2] {
    let h = at.h;
    if state.v >= at.cap && state.a <= 0.0 {
        return [State { v: at.cap, a: 0.0 }; 2];
    }
    let mut j = at.jerk(larger(state.a, 0.0));
    if at.j[0] != at.j[1] {
        let a = acceleration_behind(state, j, h);
        j = at.jerk(a.clamp(0.0, most.max(0.0)));
    }
    let mut end = step(state, j, h);
    if end.a > most {
        // (2a₀+a₁)/6·T² + v₀·T = h.
        let a = most.max(0.0);
        let square = state.v * state.v + (2.0 * state.a + a) * h / 1.5;
        let t = 2.0 * h / (state.v + larger(0.0, square).sqrt());
        j = (a - state.a) / t;
        end = State { v: state.v + 0.5 * (state.a + a) * t, a };
    }
    let mut middle = step(state, j, 0.5 * h);
    for (to, from) in [(&mut middle, state.v), (&mut end, smaller(state.v, at.cap))] {
        if to.v > at.cap {
            let rise = (at.cap * at.cap - from * from) / (2.0 * h);
            *to = State { v: at.cap, a: rise.clamp(0.0, to.a.max(0.0)) };
        }
    }
    if middle.v >= at.cap {
        end.a = 0.0;
    }
    [middle, end]
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::limits::{Class, Inverses, Limits, Rates};
    use crate::path::shape::Shape;
    use crate::timing::queue::Cell;
    use ferrocut_geometry::{AXES, Position};
    use ferrocut_machine::Machine;

    const CELLS: u64 = 240;
    const LEN: f64 = 0.5;

    /// A long way with two bends in it, in cells.
    fn queue() -> Queue {
        let inverses = Inverses::new(&Limits::new(&Machine::demo_mill()));
        let inverse = inverses.of(Class::Cut);
        let mut queue = Queue::new();
        for k in 0..CELLS {
            let mut rates = Rates { first: [0.0; AXES], second: [0.0; AXES], third: [0.0; AXES] };
            rates.first[0] = 1.0;
            if (80..90).contains(&k) || (160..164).contains(&k) {
                rates.second[1] = 2.0;
            }
            let top = inverse.speed(&rates);
            let shape = Shape::Line { p: Position::ZERO, d: Position::ZERO };
            queue.append(
                Cell::new(shape, None),
                Node {
                    s: k as f64 * LEN,
                    len: LEN,
                    load: inverse.load(&rates),
                    top,
                    most: f64::INFINITY,
                    feed: 100.0,
                    basis: 0.0,
                    class: Class::Cut,
                    pass: Pass::Path,
                    turns_are_few: false,
                    rests: k + 1 == CELLS,
                },
            );
        }
        queue
    }

    fn planned(queue: &Queue) -> (Grid, Port) {
        let mut grid = Grid::new();
        let (from, to) =
            (Port { s: 0.0, state: State::REST }, Port { s: CELLS as f64 * LEN, state: State::REST });
        assert!(grid.plan(queue, from, to, 0, CELLS - 1, |node| node.top.min(100.0)));
        (grid, from)
    }

    #[test]
    fn a_part_is_planned_again_as_the_whole_would_be() {
        let queue = queue();
        let (planned, from) = planned(&queue);
        let n = planned.steps.len();
        let slowest = |cells: std::ops::Range<u64>| {
            let inside = (0..n).filter(|i| cells.contains(&planned.steps[*i].cell));
            inside.min_by(|a, b| planned.steps[*a].x.total_cmp(&planned.steps[*b].x)).unwrap()
        };
        let (first, second) = (slowest(78..92), slowest(158..166));
        let mut parts = 0;
        for changed in [first..first + 2, second..second + 1, first..second, 0..2, n - 2..n, 0..n] {
            let lessened = || {
                let mut grid = Grid::new();
                grid.steps.clone_from(&planned.steps);
                grid.known.clone_from(&planned.known);
                grid.to = planned.to;
                for step in &mut grid.steps[changed.clone()] {
                    step.share *= 0.9;
                }
                grid
            };
            let (mut part, mut whole) = (lessened(), lessened());
            assert!(whole.pass(from));
            if !part.pass_about(changed.clone(), from) {
                // Then the whole is planned again, from what the part left.
                assert!(part.pass(from));
            } else {
                parts += 1;
            }
            for (a, b) in part.steps.iter().zip(&whole.steps) {
                let off = (a.from.v - b.from.v).abs();
                assert!(off < 1e-9, "{changed:?}: {} {} at {}", a.from.v, b.from.v, a.s);
            }
        }
        // The bends and the ends lie between places of full speed; only the whole does not.
        assert_eq!(parts, 5);
    }
}
