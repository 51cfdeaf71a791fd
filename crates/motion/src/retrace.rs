//! Back along the path, and forward again, for as far as what was passed is still known.
//!
//! Going back, the cells that were passed are run from their ends to their starts, the newest first. A cell keeps its
//! curve and its bounds; its length on the path changes its sign, so that lengths grow all the same, and look-ahead,
//! handing over and interpolation know no difference. Meanwhile all the cells in their first order are kept on a
//! **tape**. Going forward again, what is ahead of the axes goes back into the queue as it was.
//!
//! What is behind ends at a move that must not be run back without the spindle (tapping, G63), at a place that was
//! renamed or aborted at, and where the ring is written over.

use crate::limits::Class;
use crate::path::shape::Shape;
use crate::timing::queue::{CELL_RING, Cell, MARK_RING, Mark, Node, PASSED, Pass, Queue, SAME_LENGTH};
use ferrocut_geometry::Position;

/// Cells in the order of the program, with the ends of blocks.
#[derive(Debug)]
pub(crate) struct Tape {
    cells: Vec<(Cell, Node)>,
    marks: Vec<Mark>,
    /// The axes are in front of this cell, or in it.
    at: usize,
    /// The first cell that may be gone back over.
    first: usize,
    /// The queue is run back.
    is_back: bool,
    /// Number in the queue of the cell that stands for `at`, while it is run back.
    number: u64,
}

impl Tape {
    pub fn new() -> Tape {
        Tape {
            cells: Vec::with_capacity(2 * CELL_RING),
            marks: Vec::with_capacity(2 * MARK_RING),
            at: 0,
            first: 0,
            is_back: false,
            number: 0,
        }
    }

    pub fn is_back(&self) -> bool {
        self.is_back
    }

    /// Forgets what was passed.
    pub fn clear(&mut self) {
        self.cells.clear();
        self.marks.clear();
        self.is_back = false;
    }

    /// The queue is run back from the length `s`, where the axes stand. Where this is on the path back; `None` if
    /// there is nothing to go back over.
    pub fn turn_back(&mut self, queue: &mut Queue, s: f64, position: &Position) -> Option<f64> {
        self.gather(queue);
        let Some((s, at)) = self.place(s, position) else {
            self.give_back(queue, self.at);
            return None;
        };
        self.at = at;
        let barrier = self.cells[..at].iter().rposition(|(_, node)| node.class == Class::Locked);
        // A rounded corner behind it is a part of it.
        let is_corner =
            |i: usize| self.cells.get(i).is_some_and(|(_, node)| matches!(node.pass, Pass::Corner { .. }));
        let barrier = barrier.map_or(0, |i| if is_corner(i + 1) { i + 2 } else { i + 1 });
        self.first = barrier.max(at.saturating_sub(PASSED));
        let last = self.marks.iter().position(|mark| mark.s >= s - SAME_LENGTH);
        let last = last.unwrap_or(self.marks.len());
        // Of a cell it is to be known which block it belongs to.
        let oldest = last.saturating_sub(PASSED);
        let is_whole = oldest == 0 && self.cells.first().is_some_and(|(_, node)| node.s <= 0.0);
        if !is_whole {
            let known = self.marks.get(oldest).map_or(f64::INFINITY, |mark| mark.s - SAME_LENGTH);
            let passed = self.cells[..at].iter().take_while(|(_, node)| node.s < known).count();
            self.first = self.first.max(passed);
        }
        if self.first >= at {
            self.give_back(queue, self.at);
            return None;
        }
        queue.clear();
        self.number = queue.tail();
        for i in (self.first..at).rev() {
            let (cell, node) = self.cells[i];
            let (shape, start) = match cell.shape {
                Shape::Axes { from, to } => (Shape::Axes { from: to, to: from }, from),
                shape => (shape, shape.at(0.0)),
            };
            let before = self.cells.get(i.wrapping_sub(1)).and_then(|(cell, _)| cell.rest);
            let rests = node.pass == Pass::Axes
                || i == self.first
                || self.cells.get(i.wrapping_sub(1)).is_some_and(|(_, node)| node.rests);
            let rest = rests.then(|| before.unwrap_or(start));
            queue.append(Cell { shape, rest, is_back: true }, Node { s: -node.end(), rests, ..node });
        }
        let begin = self.cells[self.first].1.s;
        for k in (0..self.marks.len().min(last + 1)).rev() {
            let start = k.checked_sub(1).map_or(begin, |k| self.marks[k].s);
            queue.mark(-start.max(begin), self.marks[k].tag);
            if start <= begin {
                break;
            }
        }
        self.is_back = true;
        Some(-s)
    }

    /// The queue is run forward again from `s` on the path back. Where this is on the path.
    pub fn turn_forward(&mut self, queue: &mut Queue, s: f64, position: &Position) -> f64 {
        let gone = (queue.head() - self.number) as usize;
        // The cell that it is in, or where all is behind, the first.
        let at = self.at.saturating_sub(gone + 1).max(self.first);
        let (cell, node) = self.cells[at];
        let s = if queue.len() == 0 { node.s } else { (-s).clamp(node.s, node.end()) };
        let is_behind = match cell.shape {
            Shape::Axes { to, .. } => to == *position,
            _ => s >= node.end() - SAME_LENGTH,
        };
        self.give_back(queue, if is_behind { at + 1 } else { at });
        s
    }

    /// All that is known goes on the tape.
    fn gather(&mut self, queue: &Queue) {
        let [cell, mark] = queue.kept();
        // What was put on it before is in front of that, unless there is a gap.
        let is_joined = self.cells.last().is_none_or(|(_, node)| {
            cell >= queue.tail() || (node.end() - queue.node(cell).s).abs() <= SAME_LENGTH
        });
        if !is_joined {
            self.clear();
        }
        self.at = self.cells.len() + (queue.head() - cell) as usize;
        let too_many = (self.cells.len() + (queue.tail() - cell) as usize).saturating_sub(2 * CELL_RING);
        if too_many > 0 {
            self.cells.drain(..too_many.min(self.cells.len()));
            self.at = self.at.saturating_sub(too_many);
        }
        let too_many = (self.marks.len() + (queue.last_mark() - mark) as usize).saturating_sub(2 * MARK_RING);
        self.marks.drain(..too_many.min(self.marks.len()));
        self.cells.extend((cell..queue.tail()).map(|number| (*queue.cell(number), *queue.node(number))));
        self.marks.extend((mark..queue.last_mark()).map(|number| queue.mark_of(number)));
    }

    /// What is ahead from cell `at` on goes into the queue; what is behind stays on the tape.
    fn give_back(&mut self, queue: &mut Queue, at: usize) {
        queue.clear();
        for (cell, node) in self.cells.drain(at..) {
            queue.append(cell, node);
        }
        let s = match queue.len() {
            0 => f64::INFINITY,
            _ => queue.node(queue.head()).s,
        };
        let from = self.marks.iter().position(|mark| mark.s >= s - SAME_LENGTH).unwrap_or(self.marks.len());
        for mark in self.marks.drain(from..) {
            queue.mark(mark.s, mark.tag);
        }
        self.is_back = false;
    }

    /// Where the axes are, as a length on the path and the cell in front of which everything is behind them, wholly or
    /// in part. `None` where they are in a move that must not be run back.
    fn place(&self, s: f64, position: &Position) -> Option<(f64, usize)> {
        let Some((cell, node)) = self.cells.get(self.at) else {
            return self.cells.last().map(|(_, node)| (node.end(), self.at));
        };
        let s = match cell.shape {
            Shape::Axes { from, .. } if from == *position => node.s,
            Shape::Axes { .. } => node.end(),
            _ => s.clamp(node.s, node.end()),
        };
        if s <= node.s + SAME_LENGTH {
            return Some((node.s, self.at));
        }
        (node.class != Class::Locked).then_some((s, self.at + 1))
    }
}
