//! Moves to cells: decides the joints and cuts moves up.
//!
//! A move can be cut up only when the move after it is known, because the joint between the two may take
//! up to half of it. So the newest move is kept **open**. When the next one comes, the joint is decided,
//! the open move goes into the queue (as the **flow**, which for an arc of many turns may have to wait
//! for room), and the new move is the open one. [`Assembler::close`] ends the open move at rest instead.

use crate::blend::{Blend, Joint, JointRules, Member};
use crate::limits::{Class, Inverse};
use crate::moves::Move;
use crate::piece::Piece;
use crate::plan::{Cell, Node, Queue, Shape};
use ferrocut_geometry::Position;

/// Stretches shorter than this between two blends are left out, mm.
const LEAST_CELL: f64 = 1e-10;

/// A move on its way into the queue: from `s` to `to`, in steps.
#[derive(Clone, Copy, Debug)]
struct Flow {
    member: Member,
    s: f64,
    to: f64,
    step: f64,
    then: Then,
}

/// What follows the stretch of a [`Flow`].
#[derive(Clone, Copy, Debug)]
enum Then {
    /// Rest on this point.
    Rest(Position),
    /// The next move, entered at no more than this speed squared.
    Through(f64),
    /// A blend over this length of both moves; the next move is the open one.
    Blend(f64),
}

/// Turns moves into cells.
#[derive(Debug)]
pub(crate) struct Assembler {
    inverse: Inverse,
    rules: JointRules,
    /// The newest move and the length of it that the blend before took.
    open: Option<(Member, f64)>,
    flow: Option<Flow>,
    closing: bool,
    /// Highest speed squared at the start of the next cell.
    entry: f64,
    /// Where the newest move ends.
    end: Position,
}

impl Assembler {
    pub fn new(inverse: Inverse, rules: JointRules, start: Position) -> Assembler {
        Assembler { inverse, rules, open: None, flow: None, closing: false, entry: 0.0, end: start }
    }

    /// Forgets every move; the next begins at `at`, at rest.
    pub fn clear(&mut self, at: Position) {
        self.open = None;
        self.flow = None;
        self.closing = false;
        self.entry = 0.0;
        self.end = at;
    }

    /// Whether a move waits to be cut up.
    pub fn is_blocked(&self) -> bool {
        self.flow.is_some() || self.closing
    }

    /// Whether nothing is left here.
    pub fn is_empty(&self) -> bool {
        self.open.is_none() && self.flow.is_none()
    }

    /// Takes a move. The caller saw that nothing is blocked and that there is room for two cells.
    /// How many cells were added.
    pub fn push(&mut self, m: &Move, queue: &mut Queue) -> usize {
        let Some(member) = Member::new(self.end, m, &self.rules, &self.inverse) else { return 0 };
        self.end = m.to;
        let Some((open, from)) = self.open.take() else {
            self.open = Some((member, 0.0));
            return 0;
        };
        let len = open.piece.len();
        let (cut, then) = match open.join(&member, &self.rules, &self.inverse) {
            Joint::Rest => (0.0, Then::Rest(open.piece.end())),
            Joint::Through(cap) => (0.0, Then::Through(cap)),
            Joint::Blend(h) => (h, Then::Blend(h)),
        };
        self.open = Some((member, cut));
        self.flow = Some(Flow::new(open, from, len - cut, then));
        self.run(queue)
    }

    /// The open move ends at rest. How many cells were added.
    pub fn close(&mut self, queue: &mut Queue) -> usize {
        self.closing = self.open.is_some();
        self.run(queue)
    }

    /// Adds cells as far as there is room. How many were added.
    pub fn run(&mut self, queue: &mut Queue) -> usize {
        let before = queue.room();
        loop {
            if let Some(flow) = self.flow.take() {
                self.flow = self.run_flow(flow, queue);
                if self.flow.is_some() {
                    break;
                }
            }
            if !self.closing {
                break;
            }
            self.closing = false;
            if let Some((open, from)) = self.open.take() {
                let (to, end) = (open.piece.len(), open.piece.end());
                self.flow = Some(Flow::new(open, from, to, Then::Rest(end)));
            }
        }
        before - queue.room()
    }

    /// Adds the cells of `flow`; what did not find room is returned.
    fn run_flow(&mut self, mut flow: Flow, queue: &mut Queue) -> Option<Flow> {
        let rests = matches!(flow.then, Then::Rest(_));
        while flow.s < flow.to && (rests || flow.to - flow.s > LEAST_CELL) {
            if queue.room() == 0 {
                return Some(flow);
            }
            // Without a last slice of a rounding error.
            let is_last = flow.to - flow.s < 1.5 * flow.step;
            let to = if is_last { flow.to } else { flow.s + flow.step };
            let (mut cell, node) = self.stretch(&flow.member, flow.s, to);
            if let (true, Then::Rest(end)) = (is_last, flow.then) {
                cell.rest = Some(end);
            }
            self.append(cell, node, queue);
            flow.s = to;
        }
        match flow.then {
            Then::Rest(_) => self.entry = 0.0,
            Then::Through(cap) => self.entry = self.entry.min(cap),
            Then::Blend(_) if queue.room() == 0 => return Some(flow),
            Then::Blend(h) => {
                if let Some((next, _)) = &self.open {
                    let (cell, node) = self.blend(&flow.member, next, h);
                    self.append(cell, node, queue);
                }
            }
        }
        None
    }

    fn append(&mut self, cell: Cell, node: Node, queue: &mut Queue) {
        queue.append(cell, Node { entry: self.entry, ..node });
        self.entry = f64::INFINITY;
    }

    /// The cell of a move from `from` to `to`.
    fn stretch(&self, member: &Member, from: f64, to: f64) -> (Cell, Node) {
        let (shape, bound) = match &member.piece {
            Piece::Line(line) => (Shape::Line { p: member.piece.at(from), d: line.dir }, member.bound),
            Piece::Arc(turn) => {
                let bounds = turn.derivatives(from, to);
                let feed = member.feed / turn.stretch(from, to);
                let bound = self.inverse.curved(member.class, &bounds.first, &bounds.second, feed);
                (Shape::Slice(*turn, from), bound)
            }
            Piece::Axes { from, to } => (Shape::Axes { from: *from, to: *to }, member.bound),
        };
        let cell = Cell { shape, rest: None, tags: [member.tag; 2] };
        (cell, Node { len: to - from, bound, class: member.class, entry: 0.0, w: 0.0 })
    }

    /// The cell of a blend over `h` of both moves.
    fn blend(&self, a: &Member, b: &Member, h: f64) -> (Cell, Node) {
        let blend = Blend::new(&a.piece, &b.piece, h);
        let (first, second) = blend.derivatives();
        // What one of the two does without, the blend does without.
        let either = |class| a.class == class || b.class == class;
        let class =
            [Class::Locked, Class::Full].into_iter().find(|class| either(*class)).unwrap_or(Class::Cut);
        let bound = self.inverse.curved(class, &first, &second, a.feed.min(b.feed) / blend.stretch());
        let cell = Cell { shape: Shape::Blend(blend), rest: None, tags: [a.tag, b.tag] };
        (cell, Node { len: blend.len, bound, class, entry: 0.0, w: 0.0 })
    }
}

impl Flow {
    fn new(member: Member, s: f64, to: f64, then: Then) -> Flow {
        // Equal slices.
        let count = ((to - s) / member.piece.slice()).ceil().max(1.0);
        // The length of a move of every axis on its own is not along a path: one cell.
        let to = if let Piece::Axes { .. } = member.piece { f64::MIN_POSITIVE } else { to };
        Flow { member, s, to, step: (to - s) / count, then }
    }
}
