//! Moves on their way into the queue: how they begin and end, and the short line that is held back until it is known what
//! follows it.

use crate::limits::{Class, Inverses};
use crate::path::corner::{Corner, Far, Lines, Recent};
use crate::path::joint::{Behind, Ease, Joint, JointRules, Member};
use crate::path::link::LONGER;
use ferrocut_geometry::Position;

/// How a move begins.
#[derive(Clone, Copy, Debug)]
#[expect(clippy::large_enum_variant, reason = "there is one of it at a time")]
pub(super) enum Start {
    /// At rest.
    Rest,
    /// Run through, at no more than this speed.
    Plain(f64),
    Ease(Ease),
    Corner(Corner, Before),
}

/// The move before a corner.
#[derive(Clone, Copy, Debug)]
pub(super) struct Before {
    pub class: Class,
    /// How far it is straight there, mm.
    pub room: f64,
}

/// The newest move.
#[derive(Clone, Copy, Debug)]
pub(super) struct Open {
    pub member: Member,
    pub start: Start,
    /// Where on the path it begins, mm.
    pub s: f64,
}

impl Open {
    /// How it runs into `next`; it may be `chained` to a line before it.
    pub fn join(&self, next: &Member, chained: bool, rules: &JointRules, inverses: &Inverses) -> Joint {
        let behind = match self.start {
            _ if chained => Behind::Chain,
            Start::Corner(..) => Behind::Corner,
            _ => Behind::Other,
        };
        self.member.join(next, behind, rules, inverses)
    }

    /// How far it is straight before its end, mm.
    pub fn room(&self) -> f64 {
        let taken = if let Start::Corner(corner, _) = self.start { corner.reach } else { 0.0 };
        if self.member.piece.is_line() { self.member.piece.len() - taken } else { 0.0 }
    }
}

/// How a move ends.
#[derive(Clone, Copy, Debug)]
#[expect(clippy::large_enum_variant, reason = "there is one of it at a time")]
pub(super) enum End {
    Rest(Position),
    Through,
    Ease(Ease),
    /// The corner takes its reach.
    Corner(Corner),
}

/// A move, or the end of a chain, on its way into the queue.
#[derive(Clone, Copy, Debug)]
pub(super) struct Flow {
    pub open: Open,
    pub end: End,
    /// The move is the last of the chain; the chain goes on behind it.
    pub chain: Option<bool>,
    /// How far it is in the queue, mm of the move.
    pub at: f64,
    pub begun: bool,
}

/// A line between two corners, and what it is with them if the move behind it is long enough.
#[derive(Clone, Copy, Debug)]
pub(super) struct Held {
    pub line: Open,
    pub end: Corner,
    pub link: Corner,
    pub before: Before,
}

impl Held {
    /// The line `open`, which ends with this corner, if it can be run as one with it and the one it begins with.
    pub fn new(open: &Open, end: Corner, next: &Member, inverses: &Inverses) -> Option<Held> {
        let Start::Corner(corner, before) = open.start else { return None };
        let (member, len) = (&open.member, open.member.piece.len());
        let are_alike = [before.class, member.class, next.class] == [Class::Cut; 3]
            && member.rpm == next.rpm
            && member.inner.is_none()
            && next.inner.is_none();
        let is_line = member.piece.is_line() && next.piece.is_line();
        if !are_alike || !is_line || before.room < LONGER * len {
            return None;
        }
        let inverse = inverses.of(Class::Cut);
        let direction = member.piece.tangent(0.0);
        let mut link = corner.linked(&end, direction, len, inverse)?;
        (link.feed, link.cap) = (member.feed, link.cap.min(member.most));
        let top = link.foot.top(inverse.straight(&direction.0).j);
        let is_fast = member.feed.min(next.feed).min(link.cap) >= top * link.haste;
        is_fast.then_some(Held { line: *open, end, link, before })
    }

    /// Whether a `next` move is long enough for it to be run as one with its corners.
    pub fn is_followed_by(&self, next: &Member) -> bool {
        next.piece.len() >= LONGER * self.line.member.piece.len()
    }

    /// The line on its own.
    pub fn flow(&self) -> Flow {
        Flow { open: self.line, end: End::Corner(self.end), chain: None, at: 0.0, begun: false }
    }
}

/// A line before a corner that may swing out, and the lines on both sides of that.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turn {
    pub flow: Flow,
    pub lines: Lines,
}

impl Turn {
    /// The line before the corner, as that is rounded; `open` is the line behind it, and begins so. `None` for what is at the
    /// end of that where it may be run as one with the corners.
    pub fn flow(
        mut self,
        open: &mut Open,
        far: Option<Far>,
        inverses: &Inverses,
        recent: &mut Recent,
    ) -> Flow {
        let (End::Corner(corner), Start::Corner(begins, _)) = (&mut self.flow.end, &mut open.start) else {
            return self.flow;
        };
        if let Some(far) = far {
            let [before, behind] = &mut self.lines.sides;
            before.end = match self.flow.open.start {
                _ if self.flow.chain.is_some() => Far::Other,
                Start::Corner(..) => Far::Corner,
                Start::Rest => Far::Rest,
                Start::Plain(_) | Start::Ease(_) => Far::Other,
            };
            behind.end = far;
            let inverse = inverses.beside(self.flow.open.member.class, open.member.class);
            *corner = corner.swinging(&self.lines, inverse, recent);
            *begins = *corner;
        }
        self.flow
    }
}
