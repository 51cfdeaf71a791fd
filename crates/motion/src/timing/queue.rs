//! The ring of cells between geometry and look-ahead.
//!
//! A **cell** is a stretch of path under one set of bounds: a line between its joints, an ease, a slice of an
//! arc, a span of a smoothed run, a rounded corner. Cells are numbered from the start of the program on; `head` is
//! the oldest. Along a run that is not at rest between moves the length `s` goes on from cell to cell; it is the
//! programmed length, so the end of a block is known by it, however many blocks one cell replaces (**marks**).
//!
//! What was passed is kept for as long as its place is not needed: so far the path can be gone back
//! ([`crate::retrace`]).

use crate::limits::{Class, Load};
use crate::path::shape::{Cubic, Shape, Smooth};
use crate::timing::piece::PLACES;
use crate::timing::ramp::Foot;
use ferrocut_geometry::{AXES, Position};

/// Cells in the queue; one to three a block where blocks are long, one for many where they are short.
pub(crate) const CELLS: usize = 8192;

/// Ends of blocks in the queue. Braking from 250 mm/s at 3000 mm/s² and 60 m/s³ takes 17 mm, which is 1,700
/// blocks of 0.01 mm.
pub(crate) const MARKS: usize = 8192;

/// Cells and marks that are kept behind the axes at least.
pub(crate) const PASSED: usize = 8192;

/// Places of both rings: powers of two, so that the place of a number is found without a division.
pub(crate) const CELL_RING: usize = CELLS + PASSED;
pub(crate) const MARK_RING: usize = MARKS + PASSED;

/// Lengths on the path this close are the same: sums that were rounded, mm.
pub(crate) const SAME_LENGTH: f64 = 1e-9;

/// A stretch of path: what interpolation needs of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cell {
    pub shape: Shape,
    /// The programmed point on which the path comes to rest at the end of this cell.
    pub rest: Option<Position>,
    /// It is run from its end to its start.
    pub is_back: bool,
}

impl Cell {
    pub fn new(shape: Shape, rest: Option<Position>) -> Cell {
        Cell { shape, rest, is_back: false }
    }

    /// The point at length `s` of the cell, which is `len` long.
    #[inline]
    pub fn at(&self, s: f64, len: f64) -> Position {
        self.shape.at(if self.is_back { len - s } else { s })
    }

    /// How far X, Y and Z go there for a millimetre of programmed length, where a joint bends the path away from it or rotary axes
    /// turn by more; 1 where they stand, and only others move.
    pub fn stretch(&self, s: f64, len: f64) -> f64 {
        let stretch = match &self.shape {
            Shape::Smooth(_) | Shape::Eased(..) | Shape::Line { .. } => {
                let [[x, y, z], ..] = self.derivatives(s, len);
                (x * x + y * y + z * z).sqrt()
            }
            Shape::Slice(piece, _) => piece.share(),
            Shape::Corner(_) | Shape::Axes { .. } => 1.0,
        };
        if stretch > STILL { stretch } else { 1.0 }
    }

    /// `q′`, `q″` and `q‴` of the `N` axes in front there, in the direction that it is run in.
    pub fn derivatives<const N: usize>(&self, s: f64, len: f64) -> [[f64; N]; 3] {
        self.as_run(s, len, |s| self.shape.derivatives(s))
    }

    /// The same of every axis at several places.
    #[inline(always)]
    pub fn derivatives_at<const N: usize>(&self, s: &[f64; PLACES], len: f64) -> [[[f64; PLACES]; N]; 3] {
        match &self.shape {
            // Where the shape is known before, all places are worked out at once.
            Shape::Smooth(Smooth::Xyz(cubic, _)) => {
                at_all(s, |s| self.as_run(s, len, |s| cubic.derivatives(s)))
            }
            Shape::Smooth(Smooth::All(cubic)) => at_all(s, |s| self.as_run(s, len, |s| cubic.derivatives(s))),
            _ => at_all(s, |s| self.derivatives(s, len)),
        }
    }

    /// Derivatives at a length, from those `of` the shape, in the direction that it is run in.
    #[inline(always)]
    fn as_run<const N: usize>(&self, s: f64, len: f64, of: impl Fn(f64) -> [[f64; N]; 3]) -> [[f64; N]; 3] {
        if !self.is_back {
            return of(s);
        }
        let [first, second, third] = of(len - s);
        [first.map(|c| -c), second, third.map(|c| -c)]
    }
}

/// What `of` finds at each of these places, place by place behind one another.
#[inline(always)]
fn at_all<const N: usize>(s: &[f64; PLACES], of: impl Fn(f64) -> [[f64; N]; 3]) -> [[[f64; PLACES]; N]; 3] {
    let mut at = [[[0.0; PLACES]; N]; 3];
    for k in 0..PLACES {
        let [first, second, third] = of(s[k]);
        for i in 0..N {
            (at[0][i][k], at[1][i][k], at[2][i][k]) = (first[i], second[i], third[i]);
        }
    }
    at
}

/// X, Y and Z stand where they go less than this for a millimetre or degree of programmed length: what rounding, or a corner
/// behind a turn of a rotary axis alone, makes of it is no speed to be told.
const STILL: f64 = 0.01;

/// How a cell is passed.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) enum Pass {
    /// As fast as its bounds allow.
    Path,
    /// In its own time: a corner, with its state at both ends and its duration; `top` is the highest speed on its
    /// lines where it is stopped at instead, which two that are run as one (`is_link`) never are.
    Corner { foot: Foot, time: f64, top: f64, is_link: bool },
    /// Every axis on its own, from rest to rest.
    Axes,
}

/// A stretch of path: what look-ahead needs of it. Kept apart from [`Cell`] to be read in few cache lines.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Node {
    /// Length at its start, mm.
    pub s: f64,
    pub len: f64,
    pub load: Load,
    /// Highest speed by the axes, mm/s.
    pub top: f64,
    /// The same, curves aside.
    pub most: f64,
    /// Programmed speed, mm/s; infinite for rapids.
    pub feed: f64,
    /// Cutting: speed of the spindle at which it is that, r/min; 0 where it does not follow the spindle. Positioning:
    /// the largest share that an axis has of the speed along the path.
    pub basis: f64,
    pub class: Class,
    pub pass: Pass,
    /// Whether it lies where turns are few among many lines: they are timed less closely.
    pub turns_are_few: bool,
    /// Whether the path rests at its end.
    pub rests: bool,
}

impl Node {
    pub fn end(&self) -> f64 {
        self.s + self.len
    }

    /// Whether its programmed speed is one per revolution of the spindle.
    pub fn follows_spindle(&self) -> bool {
        self.class != Class::Rapid && self.basis > 0.0
    }
}

/// The end of a block.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Mark {
    pub s: f64,
    pub tag: u64,
}

impl Mark {
    /// Whether the block ends before `s`.
    #[inline]
    pub fn is_before(&self, s: f64) -> bool {
        self.s < s - SAME_LENGTH
    }
}

/// The ring of cells, and the one of marks.
#[derive(Debug)]
pub(crate) struct Queue {
    cells: Vec<Cell>,
    nodes: Vec<Node>,
    head: u64,
    tail: u64,
    marks: Vec<Mark>,
    first_mark: u64,
    last_mark: u64,
    /// How many cells end at rest.
    rests: usize,
    /// Whether other axes than X, Y and Z move since there were no cells.
    moves_others: bool,
    /// Cells and marks before these were handed over.
    handed: [u64; 2],
    /// The oldest cell and the oldest mark that belong to the same path.
    first: [u64; 2],
}

fn slot(number: u64) -> usize {
    (number % CELL_RING as u64) as usize
}

fn mark_slot(number: u64) -> usize {
    (number % MARK_RING as u64) as usize
}

impl Queue {
    pub fn new() -> Queue {
        let shape = Shape::Line { p: Position::ZERO, d: Position::ZERO };
        let node = Node {
            s: 0.0,
            len: 0.0,
            load: Load::NONE,
            top: 0.0,
            most: 0.0,
            feed: 0.0,
            basis: 0.0,
            class: Class::Cut,
            pass: Pass::Path,
            turns_are_few: false,
            rests: false,
        };
        Queue {
            cells: vec![Cell::new(shape, None); CELL_RING],
            nodes: vec![node; CELL_RING],
            head: 0,
            tail: 0,
            marks: vec![Mark::default(); MARK_RING],
            first_mark: 0,
            last_mark: 0,
            rests: 0,
            moves_others: false,
            handed: [0; 2],
            first: [0; 2],
        }
    }

    /// Whether other axes than X, Y and Z move in the cells, or may.
    pub fn moves_others(&self) -> bool {
        self.moves_others
    }

    pub fn len(&self) -> usize {
        (self.tail - self.head) as usize
    }

    pub fn room(&self) -> usize {
        CELLS.saturating_sub(self.len())
    }

    /// Room for ends of blocks.
    pub fn mark_room(&self) -> usize {
        MARKS.saturating_sub((self.last_mark - self.first_mark) as usize)
    }

    /// Number of the oldest cell.
    pub fn head(&self) -> u64 {
        self.head
    }

    /// Number that the next cell will have.
    pub fn tail(&self) -> u64 {
        self.tail
    }

    /// Whether the oldest run is known to its end.
    pub fn has_rest(&self) -> bool {
        self.rests > 0
    }

    #[inline]
    pub fn node(&self, number: u64) -> &Node {
        &self.nodes[slot(number)]
    }

    #[inline]
    pub fn cell(&self, number: u64) -> &Cell {
        &self.cells[slot(number)]
    }

    /// Adds a cell; the caller looked for room.
    #[inline]
    pub fn append(&mut self, cell: Cell, node: Node) {
        let moves_others = cell.shape.moves_others();
        *self.next(&node, moves_others) = cell;
    }

    /// The same of a stretch of a smoothed run in X, Y and Z: what that has is copied, not as much as the largest of shapes has.
    #[inline]
    pub fn append_xyz(&mut self, cubic: &Cubic<3>, others: &[f64; AXES - 3], node: &Node) {
        let cell = self.next(node, false);
        cell.shape = Shape::Smooth(Smooth::Xyz(*cubic, *others));
        (cell.rest, cell.is_back) = (None, false);
    }

    /// The same of all axes.
    #[inline]
    pub fn append_all(&mut self, cubic: &Cubic<AXES>, node: &Node) {
        let cell = self.next(node, true);
        cell.shape = Shape::Smooth(Smooth::All(*cubic));
        (cell.rest, cell.is_back) = (None, false);
    }

    /// The place of a new cell, which may move others than X, Y and Z.
    #[inline]
    fn next(&mut self, node: &Node, moves_others: bool) -> &mut Cell {
        self.rests += usize::from(node.rests);
        self.moves_others &= self.head < self.tail;
        self.moves_others = self.moves_others || moves_others;
        let place = slot(self.tail);
        self.tail += 1;
        self.nodes[place] = *node;
        &mut self.cells[place]
    }

    /// The cell from `from` on that the length `s` lies in.
    pub fn find(&self, from: u64, s: f64) -> u64 {
        let mut cell = from;
        while cell < self.tail() {
            let node = self.node(cell);
            if node.end() > s + 1e-12 || node.rests {
                break;
            }
            cell += 1;
        }
        cell
    }

    /// The path rests at the end of the newest cell, on this point.
    pub fn rest_at(&mut self, point: Position) {
        if self.head == self.tail {
            return;
        }
        let newest = self.tail - 1;
        if newest < self.handed[0] && self.room() > 0 {
            // What was handed over stays as it is.
            let node = *self.node(newest);
            let cell = Cell::new(Shape::Line { p: point, d: Position::ZERO }, Some(point));
            let load = Load::NONE;
            return self
                .append(cell, Node { s: node.end(), len: 0.0, load, pass: Pass::Path, rests: true, ..node });
        }
        let slot = slot(newest);
        self.cells[slot].rest = Some(point);
        self.rests += usize::from(!self.nodes[slot].rests);
        self.nodes[slot].rests = true;
    }

    /// Notes that the block `tag` ends at `s`; the caller looked for room.
    pub fn mark(&mut self, s: f64, tag: u64) {
        self.marks[mark_slot(self.last_mark)] = Mark { s, tag };
        self.last_mark += 1;
    }

    /// Blocks that end behind `s` are told as the last of them, unless they are handed over; how many fewer marks there are.
    pub fn unmark(&mut self, s: f64) -> usize {
        let last = self.last_mark;
        let known = self.handed[1].max(self.first_mark);
        while self.last_mark >= known + 2 && self.mark_of(self.last_mark - 2).s > s {
            self.last_mark -= 1;
            self.marks[mark_slot(self.last_mark - 1)] = self.marks[mark_slot(self.last_mark)];
        }
        (last - self.last_mark) as usize
    }

    /// The marks of the blocks that end before `s` are forgotten.
    pub fn pass_marks(&mut self, s: f64) {
        while self.first_mark + 1 < self.last_mark && self.marks[mark_slot(self.first_mark)].is_before(s) {
            self.first_mark += 1;
        }
    }

    /// Number of the oldest mark.
    pub fn first_mark(&self) -> u64 {
        self.first_mark
    }

    /// Numbers of the oldest cell and the oldest mark that are still there, passed or not.
    pub fn kept(&self) -> [u64; 2] {
        [
            self.first[0].max(self.tail.saturating_sub(CELL_RING as u64)),
            self.first[1].max(self.last_mark.saturating_sub(MARK_RING as u64)),
        ]
    }

    /// Number that the next mark will have.
    pub fn last_mark(&self) -> u64 {
        self.last_mark
    }

    /// The mark `number`.
    pub fn mark_of(&self, number: u64) -> Mark {
        self.marks[mark_slot(number)]
    }

    /// How many cells and marks are to be handed over.
    pub fn to_hand(&self) -> [usize; 2] {
        [self.tail - self.handed[0], self.last_mark - self.handed[1]].map(|count| count as usize)
    }

    /// Hands cells over, each to `give`, which says whether it took it.
    pub fn hand_cells(&mut self, mut give: impl FnMut(&Node, &Cell) -> bool) -> bool {
        while self.handed[0] < self.tail {
            if !give(self.node(self.handed[0]), self.cell(self.handed[0])) {
                return false;
            }
            self.handed[0] += 1;
        }
        true
    }

    /// The same for marks, many at once.
    pub fn hand_marks(&mut self, mut give: impl FnMut(&[Mark]) -> bool) -> bool {
        while self.handed[1] < self.last_mark {
            let first = mark_slot(self.handed[1]);
            let count = (self.last_mark - self.handed[1]).min((MARK_RING - first) as u64);
            if !give(&self.marks[first..first + count as usize]) {
                return false;
            }
            self.handed[1] += count;
        }
        true
    }

    /// Takes the oldest cell away.
    pub fn retire(&mut self) {
        if self.head < self.tail {
            self.rests -= usize::from(self.node(self.head).rests);
            self.head += 1;
        }
    }

    /// Forgets what was passed.
    pub fn forget_passed(&mut self) {
        self.first = [self.head, self.first_mark];
    }

    /// Forgets every cell, the passed ones too.
    pub fn clear(&mut self) {
        // Numbers that nobody else knows are used again.
        self.tail = self.handed[0].max(self.head);
        self.last_mark = self.handed[1].max(self.first_mark);
        self.head = self.tail;
        self.first_mark = self.last_mark;
        self.first = [self.head, self.first_mark];
        self.rests = 0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn several_places_are_as_each_of_them() {
        let p = |x, y, z| Position::xyz(x, y, z);
        let c = [[1.0, 2.0, 3.0], [1.0, 0.1, 0.0], [0.2, -0.3, 0.1], [-0.4, 0.5, 0.2]];
        let curve = Smooth::Xyz(Cubic { c, len: 2.0 }, [0.0; AXES - 3]);
        for shape in [Shape::Smooth(curve), Shape::Line { p: p(1.0, 0.0, 0.0), d: p(0.6, 0.8, 0.0) }] {
            for is_back in [false, true] {
                let cell = Cell { is_back, ..Cell::new(shape, None) };
                let places: [f64; PLACES] = std::array::from_fn(|k| 0.25 * k as f64);
                let at = cell.derivatives_at::<3>(&places, 2.0);
                for (k, s) in places.into_iter().enumerate() {
                    let expected = cell.derivatives::<3>(s, 2.0);
                    for (at, expected) in at.iter().flatten().zip(expected.iter().flatten()) {
                        assert!((at[k] - expected).abs() < 1e-12, "{is_back} {k}: {} {expected}", at[k]);
                    }
                }
            }
        }
    }
}
