//! Look-ahead: the queue of cells and how fast each may be entered.
//!
//! A **cell** is a stretch of path under one [`Bound`]: a line between its blends, a blend, a slice of an
//! arc. Cells stand in a ring, oldest first, each with the speed squared `w` at which it is entered. For
//! a path that ends at rest the fastest `w` that still lets everything behind it be kept follows from the
//! end backwards, with `reach` solving one linear equation a cell:
//!
//! ```text
//! w_end = 0
//! w_k   = min( caps of cells k−1 and k, cap of the joint, reach_k(w_{k+1}) )
//! ```
//!
//! The forward half of the usual two passes is done by the interpolator when it enters a cell: it takes
//! the lower of `w_{k+1}` and what it can reach from the speed it has.
//!
//! **Always to rest.** The end of the queue is planned to rest whatever may follow, so a feeder that
//! falls behind stops the machine on the path, within limits. More cells can only raise `w`: a plan
//! already begun stays feasible.
//!
//! **When.** A sweep from the end is due when the part that no sweep has seen is a third of the part that
//! was: a cell is then swept four times on average, and a full queue always has three quarters of its
//! cells planned ahead. A sweep ends early where it changes nothing, which is where braking to the old
//! end began. It may also be interrupted after any cell: the cells before it then have lower speeds than
//! they could, or those of the overrides before, but never any that could not be braked from. So its cost is spread over pushes and periods.

use crate::blend::Blend;
use crate::limits::{Bound, Class};
use crate::piece::Turn;
use ferrocut_geometry::Position;

/// Cells in the queue; two a block where joints are blended. At 250 mm/s and 3000 mm/s² braking takes 10
/// mm, a thousand blocks of 0.01 mm; the queue holds twice that.
pub(crate) const CELLS: usize = 4096;

/// Cells swept for every cell pushed.
const SWEEP_A_CELL: usize = 16;

/// Cells swept every servo period.
pub(crate) const SWEEP_A_PERIOD: usize = 128;

/// With fewer planned cells than this ahead, a sweep is not spread.
const NEAR: u64 = 64;

/// Planned speed of a cell that no sweep has seen; read as 0, yet differs from every planned speed.
const UNPLANNED: f64 = -1.0;

/// Where a cell lies.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Shape {
    /// `p + d·s`.
    Line { p: Position, d: Position },
    /// Around a joint.
    Blend(Blend),
    /// A slice of an arc that begins at this length of it.
    Slice(Turn, f64),
    /// Every axis on its own.
    Axes { from: Position, to: Position },
}

impl Shape {
    /// The point at length `s` of the cell.
    #[inline]
    pub fn at(&self, s: f64) -> Position {
        match self {
            Shape::Line { p, d } => p.zip(*d, |p, d| p + d * s),
            Shape::Blend(blend) => blend.at(s),
            Shape::Slice(turn, from) => turn.at(from + s),
            Shape::Axes { from, .. } => *from,
        }
    }
}

/// A stretch of path: what the interpolator needs of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cell {
    pub shape: Shape,
    /// The programmed point on which the path comes to rest at the end of this cell.
    pub rest: Option<Position>,
    /// Marks of the moves in the first and in the second half of the cell.
    pub tags: [u64; 2],
}

/// A stretch of path: what look-ahead needs of it. Kept apart from [`Cell`] to be read in few cache lines.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Node {
    pub len: f64,
    pub bound: Bound,
    pub class: Class,
    /// Highest speed squared at the joint before this cell.
    pub entry: f64,
    /// Planned speed squared at the joint before this cell.
    pub w: f64,
}

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
}

impl Node {
    /// Highest speed squared in the cell at these overrides.
    #[inline]
    pub fn cap(&self, overrides: Overrides) -> f64 {
        let v = self.bound.feed * overrides.of(self.class);
        self.bound.w_max.min(v * v)
    }
}

/// A sweep under way: the next cell to look at and the speed squared behind it.
#[derive(Clone, Copy, Debug)]
struct Sweep {
    next: u64,
    w: f64,
    /// Goes on where nothing changes: the overrides changed everywhere.
    whole: bool,
}

/// The ring of cells. Cells are numbered from the start of the program on; `head` is the oldest.
#[derive(Debug)]
pub(crate) struct Queue {
    cells: Vec<Cell>,
    nodes: Vec<Node>,
    head: u64,
    tail: u64,
    /// How many cells end at rest.
    rests: usize,
    /// Where the last sweep began.
    planned: u64,
    sweep: Option<Sweep>,
    overrides: Overrides,
}

fn slot(number: u64) -> usize {
    (number % CELLS as u64) as usize
}

impl Queue {
    pub fn new() -> Queue {
        let shape = Shape::Axes { from: Position::ZERO, to: Position::ZERO };
        let cell = Cell { shape, rest: None, tags: [0; 2] };
        let bound = Bound { w_max: 0.0, feed: 0.0, a0: 0.0, fade: 0.0 };
        let node = Node { len: 0.0, bound, class: Class::Cut, entry: 0.0, w: UNPLANNED };
        Queue {
            cells: vec![cell; CELLS],
            nodes: vec![node; CELLS],
            head: 0,
            tail: 0,
            rests: 0,
            planned: 0,
            sweep: None,
            overrides: Overrides { feed: 1.0, rapid: 1.0 },
        }
    }

    pub fn len(&self) -> usize {
        (self.tail - self.head) as usize
    }

    pub fn room(&self) -> usize {
        CELLS - self.len()
    }

    /// Whether the oldest run is known to its end.
    pub fn has_rest(&self) -> bool {
        self.rests > 0
    }

    pub fn overrides(&self) -> Overrides {
        self.overrides
    }

    /// The oldest cell.
    pub fn front(&self) -> Option<(&Cell, &Node)> {
        (self.head < self.tail).then(|| (&self.cells[slot(self.head)], &self.nodes[slot(self.head)]))
    }

    /// Planned speed squared at the end of the oldest cell.
    pub fn exit(&self) -> f64 {
        if self.head + 1 < self.tail { self.nodes[slot(self.head + 1)].w.max(0.0) } else { 0.0 }
    }

    /// Adds a cell; the caller looked for room.
    pub fn append(&mut self, cell: Cell, node: Node) {
        self.rests += usize::from(cell.rest.is_some());
        self.cells[slot(self.tail)] = cell;
        self.nodes[slot(self.tail)] = Node { w: UNPLANNED, ..node };
        self.tail += 1;
    }

    /// Takes the oldest cell away.
    pub fn retire(&mut self) {
        if let Some((cell, _)) = self.front() {
            self.rests -= usize::from(cell.rest.is_some());
            self.head += 1;
        }
    }

    /// Forgets every cell.
    pub fn clear(&mut self) {
        self.head = self.tail;
        self.planned = self.tail;
        self.rests = 0;
        self.sweep = None;
    }

    /// New overrides: everything is to be planned again.
    pub fn set_overrides(&mut self, overrides: Overrides) {
        if overrides != self.overrides {
            self.overrides = overrides;
            self.begin(true);
        }
    }

    fn begin(&mut self, whole: bool) {
        self.planned = self.tail;
        self.sweep = (self.tail > self.head).then(|| Sweep { next: self.tail - 1, w: 0.0, whole });
    }

    /// Plans some more after `pushed` cells were added. Whether the exit of the oldest cell changed.
    #[must_use]
    pub fn plan_pushed(&mut self, pushed: usize) -> bool {
        self.plan(pushed * SWEEP_A_CELL)
    }

    /// Plans some more, by about `budget` cells. Whether the exit of the oldest cell changed.
    #[must_use]
    pub fn plan(&mut self, budget: usize) -> bool {
        let ahead = self.planned.saturating_sub(self.head);
        if self.sweep.is_none() {
            let unplanned = self.tail - self.planned.max(self.head);
            if unplanned == 0 || 3 * unplanned < ahead {
                return false;
            }
            self.begin(false);
        }
        self.run_sweep(if ahead < NEAR { usize::MAX } else { budget })
    }

    /// Plans to the last cell. Whether the exit of the oldest cell changed.
    #[must_use]
    pub fn plan_all(&mut self) -> bool {
        let mut changed = self.run_sweep(usize::MAX);
        if self.planned < self.tail {
            self.begin(false);
            changed |= self.run_sweep(usize::MAX);
        }
        changed
    }

    fn run_sweep(&mut self, budget: usize) -> bool {
        let Some(mut sweep) = self.sweep.take() else { return false };
        let mut changed = false;
        for _ in 0..budget {
            // The oldest cell is being run: how it was entered is no longer to be planned.
            if sweep.next <= self.head {
                return changed;
            }
            let before = self.nodes[slot(sweep.next - 1)].cap(self.overrides);
            let node = &mut self.nodes[slot(sweep.next)];
            let cap = before.min(node.cap(self.overrides)).min(node.entry);
            let w = node.bound.reach(sweep.w, node.len).min(cap);
            if w == node.w && !sweep.whole {
                return changed;
            }
            changed |= sweep.next == self.head + 1 && w != node.w;
            node.w = w;
            sweep = Sweep { next: sweep.next - 1, w, ..sweep };
        }
        self.sweep = Some(sweep);
        changed
    }
}
