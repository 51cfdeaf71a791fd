//! Moves to cells: decides the joints and cuts moves up.
//!
//! The **newest** line is kept back until it is known that it does not go on ([`parts`]).
//!
//! A move can be cut up only when the move after it is known, because the joint between the two takes a part of
//! it. So the one before it is kept **open**. When the next one comes, the joint is decided, the open move goes
//! into the queue (as the **flow**, which for an arc of many turns may have to wait for room), and the new move
//! is the open one. [`Assembler::close`] ends the open move at rest instead.
//!
//! How a corner between two lines is rounded depends on whether the line behind it ends with such a corner too. So the line
//! before it waits, as a **turn**, for the move behind that.
//!
//! A line between two corners that may be run with both of them as one ([`crate::path::link`]) is **held** back until it is
//! known that the move behind it is longer, or goes on.
//!
//! Lines that run into each other without a sharp corner are gathered into a **chain**, of which the open move is
//! the last; it is smoothed as a whole ([`crate::path::smooth`]) when its end is known or when it is long.

mod open;
mod parts;

use crate::limits::{Class, Inverse, Inverses, Load, Rates};
use crate::moves::{Cut, Move};
use crate::path::corner::{Far, Recent};
use crate::path::joint::{Ease, Joint, JointRules, MOST_CHORDS, Member, add, is_lost};
use crate::path::piece::Piece;
use crate::path::shape::{Cubic, Shape, Smooth, stretch};
use crate::path::smooth::{Smoother, Span};
use crate::quick::{larger, smaller};
use crate::timing::queue::{Cell, MARKS, Mark, Node, Pass, Queue};
use ferrocut_geometry::{AXES, Position};
use open::{Before, End, Flow, Held, Open, Start, Turn};
use parts::{Newest, PARTS, PartEnd};
use std::collections::VecDeque;

/// Stretches shorter than this between two joints are left out, mm.
const LEAST_CELL: f64 = 1e-10;

/// A path that hardly moves the measured coordinates is not run faster for it.
const LEAST_STRETCH: f64 = 0.5;

/// In how many cells an ease is planned at least.
const EASE_SLICES: f64 = 3.0;

/// What a move of every axis on its own counts as on the path, mm.
pub(crate) const AXES_LENGTH: f64 = 1.0;

/// Cells that a line with its joints takes at most.
pub(crate) const CELLS_A_MOVE: usize = 8;

/// Where the feed decides, cells of a chain end where `|q′|` differs by about this share: so many of one, and so many more
/// in all at most.
const EVEN: f64 = 0.007;
const MOST_PARTS: f64 = 8.0;
const CELLS_OF_FEED: usize = 1024;

/// Cells that the ends of a chain take at most.
const CELLS_A_CHAIN: usize = 32;

/// What the speed of a cell with these rates follows ([`Node::basis`]).
fn basis(member: &Member, rates: &Rates) -> f64 {
    match member.class {
        Class::Rapid => rates.first.iter().map(|share| share.abs()).fold(0.0, f64::max),
        _ => member.rpm,
    }
}

/// Lines that may be on their way into the queue.
const LINES: usize = 4;

/// So many marks of a chain are no longer waited with for its end: cells come with what is smoothed, and motion makes room
/// for marks only where it has cells.
const CHAIN_MARKS: usize = MARKS / 4;

/// Notes that the block `tag` ends at `s`, and those that are parts of the line that it ends, as far as they are `apart`; how
/// many.
#[inline]
fn mark(inner: &mut VecDeque<Mark>, queue: &mut Queue, s: f64, tag: u64, apart: f64) -> usize {
    let (mut count, mut from) = (1, f64::NEG_INFINITY);
    while let Some(end) = inner.front().copied().filter(|end| end.s < s) {
        inner.pop_front();
        if end.s - from >= apart {
            queue.mark(end.s, end.tag);
            (count, from) = (count + 1, end.s);
        }
    }
    queue.mark(s, tag);
    count
}

/// What the cells of a smoothed run are made with.
struct Making<'a> {
    class: Class,
    rpm: f64,
    inverse: &'a Inverse,
    /// How many more there may be where the feed decides.
    spare: usize,
}

impl Making<'_> {
    /// What look-ahead needs of a part of a span that begins at the length `u`.
    #[inline]
    fn node<const N: usize>(&self, span: &Span, u: f64, cubic: &Cubic<N>) -> Node {
        let (rates, stretch) = cubic.rates(span.share);
        let stretch = larger(LEAST_STRETCH, stretch);
        let (most, highest) = (self.inverse.velocity(&rates.first), span.most / stretch);
        Node {
            s: u,
            len: cubic.len,
            load: self.inverse.load(&rates),
            top: smaller(self.inverse.curve_speed(&rates, most), highest),
            most: smaller(most, highest),
            feed: span.feed / stretch,
            basis: self.rpm,
            class: self.class,
            pass: Pass::Path,
            turns_are_few: span.turns_are_few,
            rests: false,
        }
    }

    /// Adds the cells of a span.
    #[inline]
    fn cells<const N: usize>(
        &mut self,
        span: &Span,
        cubic: &Cubic<N>,
        queue: &mut Queue,
        append: impl Fn(&mut Queue, &Cubic<N>, &Node),
    ) {
        let whole = self.node(span, span.u, cubic);
        if span.is_straight {
            queue.append(Cell::new(span.curve.line(), None), whole);
            return;
        }
        // The feed is along the curve: where `|q′|` differs, so does what it is along the programmed length.
        let uneven = if whole.feed < whole.top { cubic.unevenness(span.share) } else { 0.0 };
        let parts = if uneven > 2.0 * EVEN { (uneven / EVEN).ceil().min(MOST_PARTS) as usize } else { 1 };
        if parts == 1 || parts > self.spare {
            append(queue, cubic, &whole);
            return;
        }
        self.spare -= parts;
        let len = cubic.len;
        let place = |k: usize| if k == parts { len } else { len * k as f64 / parts as f64 };
        for k in 0..parts {
            let part = cubic.part(place(k), place(k + 1));
            append(queue, &part, &self.node(span, span.u + place(k), &part));
        }
    }
}

/// A move under G62, which is cut up where an inner corner is at its end.
#[derive(Clone, Copy, Debug)]
struct Cornering {
    from: Position,
    step: Move,
    member: Member,
    /// It begins behind an inner corner.
    begins: bool,
}

/// Turns moves into cells.
#[derive(Debug)]
pub(crate) struct Assembler {
    inverses: Inverses,
    rules: JointRules,
    /// The newest move, and where the parts of its line end.
    newest: Option<Newest>,
    ends: Vec<PartEnd>,
    /// The mark of a line that is not begun yet, and where its parts end, from its start.
    of_line: (u64, Vec<Mark>),
    /// Where parts of lines that are begun end, along the path, on their way into the queue.
    inner: VecDeque<Mark>,
    /// Parts of the move before it that are still to be taken, the last one first.
    parts: Vec<Member>,
    /// A short arc as the newest move: what follows decides whether it is smoothed with the lines beside it.
    arc: Option<Member>,
    /// The newest move under G62: what follows decides whether there is an inner corner at its end.
    cornering: Option<Cornering>,
    open: Option<Open>,
    /// Before the open move.
    held: Option<Held>,
    turn: Option<Turn>,
    /// The swings of the last corners.
    recent: Recent,
    flow: Option<Flow>,
    closing: bool,
    smoother: Smoother,
    /// The first line of the chain that the open move ends; how it begins is still to be put into the queue.
    first: Option<Open>,
    chained: bool,
    /// How many marks of it are in the queue, of which no cell is yet.
    chain_marks: usize,
    /// Where the newest move ends.
    end: Position,
    /// Its length on the path.
    s: f64,
}

impl Assembler {
    pub fn new(inverses: Inverses, rules: JointRules, start: Position) -> Assembler {
        Assembler {
            rules,
            newest: None,
            ends: Vec::with_capacity(PARTS),
            of_line: (0, Vec::with_capacity(PARTS)),
            inner: VecDeque::with_capacity(LINES * PARTS),
            parts: Vec::with_capacity(MOST_CHORDS as usize + 3),
            arc: None,
            cornering: None,
            open: None,
            held: None,
            turn: None,
            recent: Recent::default(),
            flow: None,
            closing: false,
            smoother: Smoother::new(*inverses.of(Class::Cut)),
            inverses,
            first: None,
            chained: false,
            chain_marks: 0,
            end: start,
            s: 0.0,
        }
    }

    /// Forgets every move; the next begins at `at`, at rest.
    pub fn clear(&mut self, at: Position) {
        self.newest = None;
        self.ends.clear();
        self.of_line.1.clear();
        self.inner.clear();
        self.parts.clear();
        self.arc = None;
        self.cornering = None;
        self.open = None;
        (self.held, self.turn) = (None, None);
        self.recent.clear();
        self.flow = None;
        self.closing = false;
        self.smoother.clear();
        self.first = None;
        self.chained = false;
        self.chain_marks = 0;
        self.end = at;
        self.s = 0.0;
    }

    /// Whether a move waits to be cut up.
    pub fn is_blocked(&self) -> bool {
        self.flow.is_some() || self.closing || !self.parts.is_empty()
    }

    /// Whether nothing is left here.
    pub fn is_empty(&self) -> bool {
        self.newest.is_none()
            && self.open.is_none()
            && self.flow.is_none()
            && self.parts.is_empty()
            && !self.waits()
    }

    /// Whether a move waits for the one behind it.
    fn waits(&self) -> bool {
        self.arc.is_some() || self.cornering.is_some()
    }

    /// How many ends of blocks wait for their place in the queue.
    pub fn marks(&self) -> usize {
        self.ends.len() + self.of_line.1.len() + self.inner.len()
    }

    /// Takes a move. The caller saw that nothing is blocked.
    pub fn push(&mut self, m: &Move, queue: &mut Queue) {
        if let Some(newest) = &mut self.newest {
            if newest.whole.to() == m.to && !m.is_arc() {
                return;
            }
            if !self.rules.exact_stop && newest.go_on(m, &mut self.ends) {
                // Where a chain has no cells for so many marks, it ends here.
                let is_too_many = self.chained && self.chain_marks + self.ends.len() >= 2 * CHAIN_MARKS;
                let count = if is_too_many {
                    Some(self.ends.len())
                } else {
                    newest.beyond(&self.ends, self.inverses.of(Class::Cut))
                };
                let Some(count) = count else { return };
                let end = self.ends[count - 1];
                let first = newest.split(&end);
                self.take_line(&first, count, true, queue);
                self.ends.iter_mut().for_each(|behind| behind.mark.s -= end.mark.s);
                return self.run(queue);
            }
        }
        if self.newest_runs_on(queue)
            && let Some(newest) = &mut self.newest
        {
            newest.follow(m);
        } else {
            self.take_newest(queue);
            self.run(queue);
            self.newest = Some(Newest::new(&self.end, m));
        }
        let is_kept = |newest: &Newest| !self.rules.exact_stop && newest.may_go_on();
        if !self.is_blocked() && !self.newest.as_ref().is_some_and(is_kept) {
            self.newest = None;
            self.take(m, false, queue);
            self.run(queue);
        }
    }

    /// Whether the newest move is a line that is smoothed with those before it ([`run_on`](Self::run_on)): then it is, and its place
    /// is free. Nearly all moves of programs of short lines go this way.
    #[inline]
    fn newest_runs_on(&mut self, queue: &mut Queue) -> bool {
        let cut = self.newest.as_ref().and_then(|newest| newest.whole.cut());
        self.ends.is_empty() && cut.is_some_and(|cut| self.run_on(&cut, queue))
    }

    fn take_newest(&mut self, queue: &mut Queue) {
        if let Some(newest) = self.newest.take() {
            self.take_line(&newest.whole, self.ends.len() + 1, false, queue);
        }
    }

    /// Takes a line of so many parts, of which there may be more behind it.
    fn take_line(&mut self, whole: &Move, parts: usize, goes_on: bool, queue: &mut Queue) {
        // Where the last of them ends, so does the line.
        let inner = (parts - 1).min(self.ends.len());
        let (tag, of_line) = &mut self.of_line;
        *tag = whole.tag;
        of_line.extend(self.ends[..inner].iter().map(|end| end.mark));
        self.ends.drain(..parts.min(self.ends.len()));
        self.take(whole, goes_on, queue);
    }

    /// The line with this mark begins at `s`: so its parts end there.
    #[inline]
    fn begin_line(&mut self, tag: u64, s: f64) {
        let (of, ends) = &self.of_line;
        if !ends.is_empty() && *of == tag {
            self.begin_parts(s);
        }
    }

    #[cold]
    fn begin_parts(&mut self, s: f64) {
        self.inner.extend(self.of_line.1.drain(..).map(|end| Mark { s: s + end.s, ..end }));
    }

    /// Takes a move on its way to its cells. It may be a line that goes on.
    fn take(&mut self, m: &Move, goes_on: bool, queue: &mut Queue) {
        if !goes_on && m.cut().is_some_and(|cut| self.run_on(&cut, queue)) {
            return;
        }
        let from = self.end;
        let Some(mut member) = Member::new(from, m, &self.rules) else { return };
        member.is_part = goes_on;
        self.end = m.to;
        let is_line = member.piece.is_line();
        if !self.waits() && member.inner.is_none() && is_line {
            // What most moves are: nothing to be cut up.
            return self.push_member(&mut member, queue);
        }
        let begins = self.push_cornering(Some(&member));
        self.push_arc(Some(&member));
        if member.inner.is_some() {
            self.cornering = Some(Cornering { from, step: *m, member, begins });
        } else if member.chords() > 1 {
            self.arc = Some(member);
        } else {
            self.parts.push(member);
        }
        self.parts.reverse();
    }

    /// The move under G62 that waits for what is behind it: the stretches beside inner corners have a feed of their own.
    /// Whether `next` begins behind an inner corner.
    fn push_cornering(&mut self, next: Option<&Member>) -> bool {
        let Some(Cornering { from, step, mut member, begins }) = self.cornering.take() else { return false };
        let ends = next.is_some_and(|next| member.clone().slow_inner_corner(&mut next.clone()).is_some());
        let inner = member.inner;
        let beside = |is_beside: bool| inner.filter(|_| is_beside);
        let chords = member.chords();
        if !(begins || ends) {
            member.inner = None;
            if chords > 1 {
                self.arc = Some(member);
                self.push_arc(next);
            } else {
                self.parts.push(member);
            }
        } else if chords > 1 {
            let first = self.parts.len();
            self.push_chords(&member, chords);
            let last = self.parts.len().saturating_sub(1);
            for (k, part) in self.parts.iter_mut().enumerate().skip(first) {
                part.inner = beside(begins && k == first || ends && k == last);
            }
        } else if let Some([first, last]) = member.reaches() {
            let first = if begins { first } else { 0.0 };
            let last = if ends { last } else { 1.0 };
            let mut at = from;
            let known = self.parts.len();
            for part in step.parts(from, [first, last, 1.0]) {
                self.parts.extend(Member::new(at, &part, &self.rules));
                at = part.to();
            }
            // Only the last of them ends as the move does.
            let last = self.parts.len().saturating_sub(1);
            for (k, part) in self.parts.iter_mut().enumerate().skip(known) {
                part.inner = beside(begins && k == known || ends && k == last);
                if k < last {
                    part.tolerance = part.tolerance.or(Some(0.0));
                }
            }
        }
        ends
    }

    /// The short arc that waits for what is behind it, in chords where no other arc is beside it: a chord turns away from an
    /// arc, and is too short to be eased into it.
    fn push_arc(&mut self, next: Option<&Member>) {
        let Some(member) = self.arc.take() else { return };
        let before = self.open.as_ref().map(|open| &open.member);
        let is_beside_lines = before.is_none_or(|before| before.piece.is_line())
            && next.is_none_or(|next| next.piece.is_line() || next.chords() > 1);
        let is_smooth = before.is_none_or(|before| before.meets_smoothly(&member, &self.inverses))
            && next.is_none_or(|next| member.meets_smoothly(next, &self.inverses));
        if is_beside_lines && !is_smooth {
            self.push_chords(&member, member.chords());
        } else {
            self.parts.push(member);
        }
    }

    fn push_chords(&mut self, member: &Member, chords: usize) {
        let len = member.piece.len();
        let mut from = member.piece.at(0.0);
        for k in 1..=chords {
            let at = len * k as f64 / chords as f64;
            let to = if k == chords { member.piece.end() } else { member.piece.at(at) };
            self.parts.extend(member.chord(from, to));
            from = to;
        }
    }

    /// Takes a part of a move. The caller saw that nothing is on its way into the queue.
    fn push_member(&mut self, member: &mut Member, queue: &mut Queue) {
        if let (Some(held), Some(open)) = (self.held.take(), &self.open) {
            if let Joint::Chain = open.join(member, false, &self.rules, &self.inverses) {
                self.link(&held, queue);
            } else {
                self.flow = Some(held.flow());
                self.parts.push(*member);
                return;
            }
        }
        if let (Some(turn), Some(open)) = (self.turn.take(), &mut self.open) {
            let far = match open.join(member, false, &self.rules, &self.inverses) {
                Joint::Corner(end, _) if Held::new(open, end, member, &self.inverses).is_some() => None,
                Joint::Corner(..) => Some(Far::Corner),
                Joint::Rest => Some(Far::Rest),
                _ => Some(Far::Other),
            };
            self.flow = Some(turn.flow(open, far, &self.inverses, &mut self.recent));
            self.parts.push(*member);
            return;
        }
        let s = self.s;
        self.begin_line(member.tag, s);
        self.s += if let Piece::Axes { .. } = member.piece { AXES_LENGTH } else { member.piece.len() };
        let Some(open) = &mut self.open else {
            self.open = Some(Open { member: *member, start: Start::Rest, s });
            return;
        };
        if let Some(feed) = open.member.slow_inner_corner(member)
            && self.chained
        {
            self.smoother.slow_last(feed);
        }
        let joint = match open.join(member, self.chained, &self.rules, &self.inverses) {
            // What is lost in rounding behind so long a path is not smoothed.
            Joint::Chain if is_lost(open.member.piece.len().min(member.piece.len()), self.s) => Joint::Rest,
            joint => joint,
        };
        let mut swings = None;
        let (end, start) = match joint {
            Joint::Chain => return self.chain(member, s, queue),
            Joint::Rest => (End::Rest(open.member.piece.end()), Start::Rest),
            Joint::Through(cap) => (End::Through, Start::Plain(cap)),
            Joint::Ease(ease) => (End::Ease(ease), Start::Ease(ease.behind())),
            Joint::Corner(corner, lines) => {
                if !self.chained
                    && let Some(held) = Held::new(open, corner, member, &self.inverses)
                {
                    let start = Start::Corner(corner, held.before);
                    self.open = Some(Open { member: *member, start, s });
                    if held.is_followed_by(member) {
                        self.link(&held, queue);
                    } else {
                        self.held = Some(held);
                    }
                    return;
                }
                let room = if self.chained { f64::INFINITY } else { open.room() };
                swings = lines;
                (End::Corner(corner), Start::Corner(corner, Before { class: open.member.class, room }))
            }
        };
        let open = std::mem::replace(open, Open { member: *member, start, s });
        let chain = self.chained.then_some(false);
        self.chained = false;
        let flow = Flow { open, end, chain, at: 0.0, begun: false };
        match swings {
            Some(lines) => self.turn = Some(Turn { flow, lines }),
            None => self.flow = Some(flow),
        }
    }

    /// The line before the open move is run as one with the corners at its ends.
    fn link(&mut self, held: &Held, queue: &mut Queue) {
        let Some(open) = &mut self.open else { return };
        mark(&mut self.inner, queue, open.s, held.line.member.tag, 0.0);
        open.start = Start::Corner(held.link, held.before);
    }

    /// The open line runs on into the line `next`, which begins at `s`.
    fn chain(&mut self, next: &Member, s: f64, queue: &mut Queue) {
        let Some(open) = &mut self.open else { return };
        let tolerance = open.member.tolerance.unwrap_or(0.0);
        // A line that ends with an exact stop is joined to the one before within its tolerance.
        let next_tolerance = next.tolerance.unwrap_or(tolerance);
        let end = open.s + open.member.piece.len();
        if !self.chained {
            let from = open.member.piece.at(0.0);
            self.smoother.begin(from, open.s, open.member.class);
            self.smoother.set_last(open.member.feed, open.member.most, tolerance);
            self.smoother.add(open.member.piece.end(), end);
            self.first = Some(*open);
            self.chained = true;
        }
        self.chain_marks += mark(&mut self.inner, queue, end, open.member.tag, tolerance);
        self.smoother.set_last(next.feed, next.most, next_tolerance);
        let left_out = self.smoother.add(next.piece.end(), self.s);
        self.unmark(left_out, queue);
        let Some(open) = &mut self.open else { return };
        if self.smoother.is_full() || self.chain_marks >= CHAIN_MARKS {
            let open = *open;
            self.flow = Some(Flow { open, end: End::Through, chain: Some(true), at: 0.0, begun: false });
        }
        (open.member, open.start, open.s) = (*next, Start::Plain(f64::INFINITY), s);
    }

    /// Smooths the line `m` with those before it, if it runs on from them ([`Member::run_on`]).
    #[inline]
    fn run_on(&mut self, m: &Cut, queue: &mut Queue) -> bool {
        // With the last point of a run more is to be done.
        let is_nearly_full = self.smoother.is_nearly_full() || self.chain_marks >= CHAIN_MARKS;
        if !self.chained || self.waits() || is_nearly_full {
            return false;
        }
        let Some(Open { member, start, s }) = &mut self.open else { return false };
        if member.is_part {
            return false;
        }
        let (end, tag, tolerance) = (*s + member.piece.len(), member.tag, member.tolerance.unwrap_or(0.0));
        let Some(len) = member.run_on(m, &self.rules, self.s) else { return false };
        self.chain_marks += mark(&mut self.inner, queue, end, tag, tolerance);
        self.smoother.set_last(member.feed, member.most, member.tolerance.unwrap_or(tolerance));
        (*start, *s) = (Start::Plain(f64::INFINITY), self.s);
        self.begin_line(m.tag, self.s);
        self.s += len;
        self.end = m.to;
        let left_out = self.smoother.run_on(m.to, self.s);
        self.unmark(left_out, queue);
        true
    }

    /// Where points were left out of the chain behind this length, their blocks need no marks of their own.
    #[inline]
    fn unmark(&mut self, left_out: Option<f64>, queue: &mut Queue) {
        if let Some(s) = left_out {
            self.chain_marks = self.chain_marks.saturating_sub(queue.unmark(s));
        }
    }

    /// The same, as soon as cells are added again.
    pub fn close_later(&mut self) {
        self.closing = self.newest.is_some() || self.open.is_some() || !self.parts.is_empty() || self.waits();
        // So that a path is the same whatever was run before it.
        self.recent.clear();
    }

    /// The open move ends at rest.
    pub fn close(&mut self, queue: &mut Queue) {
        self.close_later();
        self.run(queue);
    }

    /// Adds cells as far as there is room.
    #[inline]
    pub fn run(&mut self, queue: &mut Queue) {
        // Nearly always nothing waits.
        if self.is_blocked() {
            self.run_blocked(queue);
        }
    }

    fn run_blocked(&mut self, queue: &mut Queue) {
        loop {
            if let Some(flow) = self.flow.take() {
                self.flow = self.run_flow(flow, queue);
                if self.flow.is_some() {
                    return;
                }
            }
            if let Some(mut part) = self.parts.pop() {
                self.push_member(&mut part, queue);
                continue;
            }
            if !self.closing {
                return;
            }
            if self.newest.is_some() {
                self.take_newest(queue);
                continue;
            }
            if self.waits() {
                // Nothing is behind it that it would have to be joined to.
                self.push_cornering(None);
                self.push_arc(None);
                self.parts.reverse();
                continue;
            }
            if let Some(held) = self.held.take() {
                self.flow = Some(held.flow());
                continue;
            }
            if let (Some(turn), Some(open)) = (self.turn.take(), &mut self.open) {
                self.flow = Some(turn.flow(open, Some(Far::Rest), &self.inverses, &mut self.recent));
                continue;
            }
            self.closing = false;
            if let Some(open) = self.open.take() {
                let chain = self.chained.then_some(false);
                self.chained = false;
                let end = End::Rest(open.member.piece.end());
                self.flow = Some(Flow { open, end, chain, at: 0.0, begun: false });
            }
        }
    }

    /// Adds the cells of `flow`; what did not find room is returned.
    fn run_flow(&mut self, mut flow: Flow, queue: &mut Queue) -> Option<Flow> {
        let member = flow.open.member;
        if let Piece::Axes { from, to } = member.piece {
            if queue.room() == 0 || queue.mark_room() == 0 {
                return Some(flow);
            }
            self.axes(&flow.open, from, to, queue);
            return None;
        }
        let len = member.piece.len();
        if let Some(goes_on) = flow.chain {
            let cells = self.smoother.most_spans() + CELLS_OF_FEED + CELLS_A_CHAIN;
            if queue.room() < cells || queue.mark_room() == 0 {
                return Some(flow);
            }
            self.run_chain(&flow, goes_on, queue);
            return None;
        }
        let ends = match flow.end {
            End::Rest(_) | End::Through => len,
            End::Ease(ease) => len - ease.h,
            End::Corner(corner) => len - corner.reach,
        };
        if !flow.begun {
            if queue.room() < 2 || queue.mark_room() == 0 {
                return Some(flow);
            }
            mark(&mut self.inner, queue, flow.open.s + len, member.tag, 0.0);
            flow.at = self.begin(&flow.open, queue);
            flow.begun = true;
        }
        loop {
            let (to, step, ease) = match (flow.open.start, flow.end) {
                (Start::Ease(ease), _) if flow.at < ease.h - LEAST_CELL => {
                    (ease.h, (ease.h / EASE_SLICES).min(member.piece.slice()), Some(ease))
                }
                _ if flow.at < ends - LEAST_CELL => (ends, member.piece.slice(), None),
                (_, End::Ease(ease)) if flow.at < len - LEAST_CELL => {
                    (len, (ease.h / EASE_SLICES).min(member.piece.slice()), Some(ease))
                }
                _ => return None,
            };
            if queue.room() == 0 {
                return Some(flow);
            }
            // Equal slices, without a last one of a rounding error.
            let count = ((to - flow.at) / step * (1.0 - 1e-9)).ceil().max(1.0);
            let next = if count > 1.0 { flow.at + (to - flow.at) / count } else { to };
            self.stretch(&flow.open, flow.at, next, ease, queue);
            if let (End::Rest(point), true) = (flow.end, next >= len) {
                queue.rest_at(point);
            }
            flow.at = next;
        }
    }

    /// Smooths the chain that the move of `flow` ends, and adds its cells.
    fn run_chain(&mut self, flow: &Flow, goes_on: bool, queue: &mut Queue) {
        let known = queue.tail();
        let last = &flow.open;
        let len = last.member.piece.len();
        let mut keeps = [false, !matches!(flow.end, End::Rest(_))];
        let (mut from, mut speed) = (0.0, f64::INFINITY);
        if let Some(first) = self.first.take() {
            let mut at = self.begin(&first, queue);
            if let Start::Ease(ease) = first.start {
                at = self.eased(&first, ease, 0.0, ease.h, queue);
            }
            keeps[0] = !matches!(first.start, Start::Rest);
            speed = match first.start {
                Start::Rest => 0.0,
                Start::Plain(cap) => cap,
                Start::Ease(ease) => ease.speed(self.inverses.of(self.smoother.class)),
                Start::Corner(corner, _) => corner.foot.v,
            };
            from = first.s + at;
        }
        let to = match flow.end {
            End::Rest(_) | End::Through => len,
            End::Ease(ease) => len - ease.h,
            End::Corner(corner) => len - corner.reach,
        };
        let class = self.smoother.class;
        let inverse = self.inverses.of(class);
        let rpm = last.member.rpm;
        self.smoother.set_speeds([
            speed,
            match flow.end {
                End::Rest(_) => 0.0,
                End::Through => f64::INFINITY,
                End::Ease(ease) => ease.speed(inverse),
                End::Corner(corner) => corner.foot.v,
            },
        ]);
        let mut making = Making { class, rpm, inverse, spare: CELLS_OF_FEED };
        self.smoother.run(from, last.s + to, keeps, goes_on, |span| match &span.curve {
            Smooth::Xyz(cubic, others) => {
                making.cells(&span, cubic, queue, |queue, cubic, node| queue.append_xyz(cubic, others, node))
            }
            Smooth::All(cubic) => making.cells(&span, cubic, queue, Queue::append_all),
        });
        if !goes_on || queue.tail() > known {
            self.chain_marks = 0;
        }
        if goes_on {
            return;
        }
        mark(&mut self.inner, queue, last.s + len, last.member.tag, 0.0);
        match flow.end {
            End::Rest(point) => queue.rest_at(point),
            End::Ease(ease) => {
                self.eased(last, ease, len - ease.h, len, queue);
            }
            End::Through | End::Corner(_) => {}
        }
    }

    /// Adds the cells of an ease; where it ends.
    fn eased(&self, open: &Open, ease: Ease, from: f64, to: f64, queue: &mut Queue) -> f64 {
        let step = (to - from) / EASE_SLICES;
        for k in 0..EASE_SLICES as usize {
            let at = from + step * k as f64;
            let next = if k + 1 == EASE_SLICES as usize { to } else { at + step };
            self.stretch(open, at, next, Some(ease), queue);
        }
        to
    }

    /// What stands before a move: a cap or a corner. Where on the move it ends.
    fn begin(&self, open: &Open, queue: &mut Queue) -> f64 {
        match open.start {
            Start::Rest => 0.0,
            Start::Plain(cap) => {
                if cap.is_finite() {
                    let p = open.member.piece.at(0.0);
                    let cell = Cell::new(Shape::Line { p, d: Position::ZERO }, None);
                    let node = Node {
                        s: open.s,
                        len: 0.0,
                        load: Load::NONE,
                        top: cap,
                        most: cap,
                        feed: open.member.feed,
                        basis: open.member.rpm,
                        class: open.member.class,
                        pass: Pass::Path,
                        turns_are_few: false,
                        rests: false,
                    };
                    queue.append(cell, node);
                }
                0.0
            }
            Start::Ease(_) => 0.0,
            Start::Corner(corner, before) => {
                let cell = Cell::new(Shape::Corner(corner), None);
                let rates = corner.rates();
                let inverse = self.inverses.beside(before.class, open.member.class);
                let top = inverse.speed(&rates);
                // Faster in it than at its ends, it is as much slower there.
                let most = (corner.cap.min(open.member.most) / corner.haste).min(f64::MAX);
                let node = Node {
                    s: open.s - corner.begin(),
                    len: corner.begin() + corner.reach,
                    load: inverse.load(&rates),
                    top: most,
                    most,
                    feed: open.member.feed.min(corner.feed) / corner.haste,
                    basis: basis(&open.member, &rates),
                    class: open.member.class,
                    pass: Pass::Corner {
                        foot: corner.foot,
                        time: corner.time,
                        top,
                        is_link: corner.is_link(),
                    },
                    turns_are_few: false,
                    rests: false,
                };
                queue.append(cell, node);
                corner.reach
            }
        }
    }

    /// The cell of a move from `from` to `to`.
    fn stretch(&self, open: &Open, from: f64, to: f64, ease: Option<Ease>, queue: &mut Queue) {
        let member = &open.member;
        let mut rates = member.piece.rates(from, to);
        let mut stretch = member.piece.stretch(from, to);
        let mut cap = f64::INFINITY;
        if let Some(ease) = ease {
            let share = member.piece.share();
            let eased = |share: f64| self.eased_stretch(member, ease, share, from, to);
            rates = add(&rates, &ease.rates(from, to));
            stretch = stretch.max(eased(share));
            // That is along the path, whatever goes on it.
            cap = ease.cap / if share == 1.0 { stretch } else { eased(0.0) }.max(1.0);
        }
        let most = cap.min(member.most / stretch.max(1.0));
        let shape = match (&member.piece, ease) {
            (piece, Some(ease)) => Shape::Eased(*piece, from, ease),
            (Piece::Line(line), None) => Shape::Line { p: member.piece.at(from), d: line.dir },
            (piece, None) => Shape::Slice(*piece, from),
        };
        let feed = if member.feed.is_finite() { member.feed / stretch } else { member.feed };
        let inverse = self.inverses.of(member.class);
        let node = Node {
            s: open.s + from,
            len: to - from,
            load: inverse.load(&rates),
            top: inverse.speed(&rates).min(most),
            most: inverse.velocity(&rates.first).min(most),
            feed,
            basis: basis(member, &rates),
            class: member.class,
            pass: Pass::Path,
            turns_are_few: false,
            rests: false,
        };
        queue.append(Cell::new(shape, None), node);
    }

    /// Largest `|q′|` of an eased stretch over what its feed is measured along, looked at in some places: it changes by little
    /// and smoothly.
    fn eased_stretch(&self, member: &Member, ease: Ease, share: f64, from: f64, to: f64) -> f64 {
        let at = |k: u32| {
            let s = from + (to - from) * f64::from(k) / 4.0;
            stretch(&(member.piece.tangent(s) + ease.slope(s)).0, share)
        };
        (0..=4).map(at).fold(0.0, f64::max) * (1.0 + 1e-5)
    }

    fn axes(&self, open: &Open, from: Position, to: Position, queue: &mut Queue) {
        let none = Rates { first: [0.0; AXES], second: [0.0; AXES], third: [0.0; AXES] };
        let node = Node {
            s: open.s,
            len: AXES_LENGTH,
            load: self.inverses.of(Class::Rapid).load(&none),
            top: f64::MAX,
            most: f64::MAX,
            feed: f64::INFINITY,
            basis: 1.0,
            class: Class::Rapid,
            pass: Pass::Axes,
            turns_are_few: false,
            rests: true,
        };
        queue.mark(open.s + AXES_LENGTH, open.member.tag);
        queue.append(Cell::new(Shape::Axes { from, to }, Some(to)), node);
    }
}
