//! Cutter radius compensation: G40, G41, G42, G39. [`Compensator`] is of the intersection type (type C),
//! [`OneAhead`] that of RS274/NGC; [`Stage`] is the one that a control has.
//!
//! In: the programmed moves of the compensation plane, in order, each with a payload that is carried through.
//! Out: the moves of the tool centre, and everything else in its place between them.
//!
//! The tool centre keeps at distance r to the left or right of the path. A *vector* leads from the programmed
//! point to the tool centre; at a corner there may be up to four of them. A block is complete once
//! the blocks on both sides are known, and is handed out once the interference check of the block after
//! has had its say about the corner between them: two moves wait, whatever the length of the program.
//!
//! ```text
//! cancelled ──set(Some), push──▶ start-up ──push──▶ mode ──set(None), push──▶ cancelled
//!                                                   │  ▲
//!                                    suspend, push  ▼  │ push (start-up)
//!                                                 vector 0
//! ```
//!
//! | file | has |
//! |---|---|
//! | `mod` | the front and the queue |
//! | [`rules`] | what controls do differently, as data |
//! | [`stage`] | the front for both types |
//! | [`one_ahead`] | the whole of the other type |
//! | `offset` | one block and its offset curve |
//! | `corner` | joining two blocks |
//! | `interference` | alarm 41 |
//!
//! Source: GSK990MC programming 4.7.2 to 4.7.4; where it is silent, Fanuc 0i-M.

mod corner;
mod interference;
mod offset;
pub mod one_ahead;
pub mod rules;
pub mod stage;

#[cfg(test)]
mod tests;

pub use one_ahead::OneAhead;
pub use rules::{Method, Outside, OverTurn, Reversal, Rules, StartUp, ZeroMove};
pub use stage::Stage;

use corner::{Corner, How};
use ferrocut_geometry::vector::{Point, distance};
use offset::Element;
use std::collections::VecDeque;

/// A start-up block may be shorter than the radius by rounding, mm.
const SHORT_START_UP_MM: f64 = 1e-6;

/// Moves shorter than this are not inserted, mm.
const NO_MOVE_MM: f64 = 1e-9;

/// Half of the least increment, mm (GSK990MC 1.2): what moves by less says where the tool stands already, not in which direction it
/// goes. Such steps come from expressions, and from ends rounded to three digits that a rotation brings back to almost one point.
const LEAST_MOVE_MM: f64 = 0.0005;

/// At most so much waits between two moves, blocks that do not count as idle included.
const WAITING_LIMIT: usize = 256;

/// A programmed move in the compensation plane, mm. `from` is the `to` of the move before.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PlaneMove {
    /// Programmed start.
    pub from: [f64; 2],
    /// Programmed end.
    pub to: [f64; 2],
    /// The way between them.
    pub shape: Shape,
}

/// A straight or circular way.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Shape {
    /// Straight.
    Line,
    /// Circular. The distances of start and end from the centre may differ a little; the radius then goes over
    /// from one to the other.
    Arc {
        /// mm.
        center: [f64; 2],
        /// Signed angle, rad, counter-clockwise positive, beyond ±2π for several turns.
        sweep: f64,
    },
}

/// Where the tool runs, seen in the direction of travel.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Side {
    /// G41.
    Left,
    /// G42.
    Right,
}

/// Compensation as programmed.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Offset {
    /// G41 or G42.
    pub side: Side,
    /// Radius of the offset number D, mm. A negative one changes the sides over (table 4-7-3-1). D00 cancels:
    /// give no `Offset` at all.
    pub radius: f64,
}

impl Side {
    /// The other one.
    pub fn other(self) -> Side {
        match self {
            Side::Left => Side::Right,
            Side::Right => Side::Left,
        }
    }
}

impl Offset {
    /// Positive left of the path, negative right of it.
    fn signed(self) -> f64 {
        match self.side {
            Side::Left => self.radius,
            Side::Right => -self.radius,
        }
    }
}

/// Why the tool centre has no path. The numbers are those of GSK990MC, which are Fanuc's.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Fault {
    /// 33: the offsets of two blocks do not cross at an inside corner.
    NoIntersection,
    /// 34: start-up or cancel in an arc.
    StartOrCancelInArc,
    /// 38: an arc whose start or end, or the tool centre there, falls onto the arc's centre.
    ArcCenterOvercut,
    /// 41: the tool would cut into the part.
    Interference,
    /// 42: more blocks without movement than the control reads ahead.
    TooManyIdleBlocks,
    /// 114: G39 outside the mode.
    CornerArcOutsideMode,
    /// A block runs exactly back along the one before, where the control forbids it (Weihong 4.3).
    Reversal,
    /// The entry move is not longer than the radius.
    EntryTooShort,
    /// The tool does not fit into an arc.
    ArcTooSmall,
    /// The first move after the end of compensation is an arc.
    ArcAfterCancel,
    /// A coordinate or radius is not a number.
    NotFinite,
}

/// A fault and the blocks that it concerns.
#[derive(Clone, PartialEq, Debug)]
pub struct FaultAt<T> {
    /// What is wrong.
    pub fault: Fault,
    /// Payload of the block at fault.
    pub at: T,
    /// Payload of the block before, where the fault lies in the two together.
    pub before: Option<T>,
}

/// What comes out.
#[derive(Clone, PartialEq, Debug)]
pub enum Out<T> {
    /// A move of the tool centre.
    Move {
        /// End, mm.
        to: [f64; 2],
        /// Centre and sweep are those of the tool centre's arc.
        shape: Shape,
        /// Of the programmed block. Pieces inserted at a corner belong to the block before it (4.7.3 point 9),
        /// the arc of G39 to G39.
        payload: T,
        /// A piece at a corner: the payload's own move has been made.
        inserted: bool,
    },
    /// A piece that leads to the move of its payload, which comes next: other linear axes wait for that one.
    Corner {
        /// End, mm.
        to: [f64; 2],
        /// The tool centre's arc.
        shape: Shape,
        /// Of the programmed block.
        payload: T,
    },
    /// What was given to [`Compensator::pass`].
    Other(T),
}

/// What a queued block does to the vector.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Phase {
    StartUp,
    Mode,
}

/// A block whose corner at the end is not known yet.
#[derive(Clone, Debug)]
struct Pending<T> {
    element: Element,
    payload: T,
    phase: Phase,
    /// The corner between the block before and this.
    start: Corner,
    /// The tool goes straight, because the interference check left out tips.
    straight: bool,
    /// Handed out by [`Compensator::flush`]; kept for the corner to the next block.
    done: bool,
    /// G39 stands after it.
    rounded: bool,
    /// Entries of the waiting queue that follow it.
    waiting: usize,
    /// Those among them without movement.
    idle: usize,
}

#[derive(Clone, Debug)]
enum Waiting<T> {
    Other(T),
    CornerArc(T),
}

/// The stage. It owns its queue and nothing else.
#[derive(Clone, Debug)]
pub struct Compensator<T> {
    rules: Rules,
    offset: Option<Offset>,
    suspended: bool,
    /// The two blocks that wait. With `older` there is always a `newer`.
    older: Option<Pending<T>>,
    newer: Option<Pending<T>>,
    waiting: VecDeque<Waiting<T>>,
    /// Where the path stood before moves that were too short to have a direction.
    begun: Option<Point>,
    tool: Point,
}

type Done<T> = Result<(), FaultAt<T>>;

impl<T: Clone> Compensator<T> {
    /// A stage in the cancelled state.
    pub fn new(rules: Rules) -> Compensator<T> {
        let waiting = VecDeque::with_capacity(WAITING_LIMIT);
        Compensator {
            rules,
            offset: None,
            suspended: false,
            older: None,
            newer: None,
            waiting,
            begun: None,
            tool: [0.0; 2],
        }
    }

    /// Other rules, from the next corner on (a program may change the parameters behind them).
    pub fn set_rules(&mut self, rules: Rules) {
        self.rules = rules;
    }

    /// G41, G42, G40, D: valid from the next move on. From none to some is start-up, from some to none cancel;
    /// everything else changes side or radius in the mode. The new radius is reached at the end of the block
    /// that carries it (4.7.3 point 12 b).
    ///
    /// [`Self::flush`] first where the last move is to end square to itself: for G40 in a block that does not
    /// move in the plane (4.7.3 point 8 c), and for G41 or G42 given again in the mode (point 7).
    pub fn set(&mut self, offset: Option<Offset>) {
        self.offset = offset;
    }

    /// Temporary cancel (G28, G30, G53; 4.7.2 point 5, 4.7.3 point 6): the next move ends with vector 0 as in a
    /// cancel, and the one after starts up again. Call it before each move that is to run without a vector.
    pub fn suspend(&mut self) {
        self.suspended = true;
    }

    /// Whether a vector stands or waits: the start-up has been given and no cancel yet.
    pub fn in_mode(&self) -> bool {
        self.newer.is_some()
    }

    /// Where the moves handed out so far leave the tool centre, mm.
    pub fn tool(&self) -> [f64; 2] {
        self.tool
    }

    /// Forgets everything (reset).
    pub fn reset(&mut self) {
        (self.offset, self.suspended) = (None, false);
        self.drop_queue();
    }

    /// The vector is gone: the next move is the first. [`Self::flush`] first what waits.
    pub fn forget(&mut self) {
        self.drop_queue();
    }

    fn drop_queue(&mut self) {
        (self.older, self.newer, self.begun) = (None, None, None);
        self.waiting.clear();
    }

    /// The next move in the plane.
    ///
    /// # Errors
    /// Every [`Fault`] of the geometry. What waited is dropped then, and the next move starts up anew: good for
    /// looking for further findings, not for cutting.
    pub fn push(&mut self, mut m: PlaneMove, payload: T, out: &mut impl FnMut(Out<T>)) -> Done<T> {
        if !offset::is_finite(&m) || self.offset.is_some_and(|o| !o.radius.is_finite()) {
            return Err(at(Fault::NotFinite, payload));
        }
        if offset::is_zero(&m) {
            return self.push_zero(m, payload, out);
        }
        let begun = self.begun.take();
        if self.newer.is_some() && self.offset.is_some() && !self.suspended {
            m.from = begun.unwrap_or(m.from);
            if offset::is_within(&m, LEAST_MOVE_MM) {
                self.begun = Some(m.from);
                return self.pass(payload, false, out);
            }
        }
        let offset = if self.suspended { None } else { self.offset };
        self.suspended = false;
        let done = match (self.newer.take(), offset) {
            (None, None) => {
                self.tool = m.to;
                out(Out::Move { to: m.to, shape: m.shape, payload, inserted: false });
                Ok(())
            }
            (None, Some(o)) => self.start_up(m, o, payload),
            (Some(last), Some(o)) => self.go_on(last, m, o, payload, out),
            (Some(last), None) => self.cancel(last, m, payload, out),
        };
        if done.is_err() {
            self.drop_queue();
        }
        done
    }

    /// Anything that does not move in the plane; it keeps its place. `counts_as_idle`: a block that uses up
    /// the look-ahead (GSK990MC 4.7.3 point 8).
    pub fn pass(&mut self, payload: T, counts_as_idle: bool, out: &mut impl FnMut(Out<T>)) -> Done<T> {
        let Some(last) = &mut self.newer else {
            out(Out::Other(payload));
            return Ok(());
        };
        // Once cancelled nothing is read ahead for.
        last.idle += usize::from(counts_as_idle && self.offset.is_some());
        if last.idle > self.rules.idle_blocks || last.waiting >= WAITING_LIMIT {
            return Err(at(Fault::TooManyIdleBlocks, payload));
        }
        if last.done && last.waiting == 0 {
            out(Out::Other(payload));
        } else {
            last.waiting += 1;
            self.waiting.push_back(Waiting::Other(payload));
            return self.flush_if_blind(out);
        }
        Ok(())
    }

    /// A block that made nothing: it uses up the look-ahead as [`pass`](Self::pass) does. One that names the
    /// plane's axes and moves none of them is a move of no length ([`Rules::zero_move`]).
    pub fn idle(
        &mut self,
        is_zero_move: bool,
        out: &mut impl FnMut(Out<T>),
    ) -> Result<(), Option<FaultAt<T>>> {
        if is_zero_move && self.rules.zero_move == ZeroMove::Square {
            self.flush(out).map_err(Some)?;
        }
        let Some(last) = &mut self.newer else { return Ok(()) };
        last.idle += usize::from(self.offset.is_some());
        if last.idle > self.rules.idle_blocks {
            return Err(None);
        }
        self.flush_if_blind(out).map_err(Some)
    }

    /// Ends the last move square where so many blocks without movement came behind it that no more is read ahead; not the
    /// start-up, behind which the tool is not on the contour yet, nor what G39 waits behind for the next move.
    fn flush_if_blind(&mut self, out: &mut impl FnMut(Out<T>)) -> Done<T> {
        let last = self.newer.as_ref().filter(|last| last.phase == Phase::Mode && !last.rounded);
        let Some(idle) = last.map(|last| last.idle) else { return Ok(()) };
        if self.rules.blind_from.is_some_and(|n| idle >= n) {
            self.flush(out)?;
            if let Some(last) = &mut self.newer {
                last.idle = idle;
            }
        }
        Ok(())
    }

    /// G39: an arc about the end of the last move, to the vector square to the next (4.7.4). Where the
    /// corner has no outside to go round (tangent joint, start-up, cancel, change of side) the payload comes out
    /// as [`Out::Other`]; inside a corner it is [`Fault::Interference`].
    pub fn corner_arc(&mut self, payload: T) -> Done<T> {
        let Some(last) = &mut self.newer else {
            return Err(at(Fault::CornerArcOutsideMode, payload));
        };
        if last.waiting >= WAITING_LIMIT {
            return Err(at(Fault::TooManyIdleBlocks, payload));
        }
        last.rounded = true;
        last.waiting += 1;
        self.waiting.push_back(Waiting::CornerArc(payload));
        Ok(())
    }

    /// Hands out all that waits: at the end of the program, before a barrier, and where [`Self::set`] says so.
    /// The last move ends square to itself; the mode stays. From there the tool goes on round the corner if the
    /// next block makes it an outside one. Inside, it goes straight to that block's end, or to an arc's start.
    pub fn flush(&mut self, out: &mut impl FnMut(Out<T>)) -> Done<T> {
        let Some(mut last) = self.newer.take() else { return Ok(()) };
        if !last.done {
            let mut end = last.square_corner();
            let next = last.element;
            if let Err(fault) = self.check(&mut last, &next, &mut end) {
                self.drop_queue();
                return Err(fault);
            }
            self.emit_older(&last.start, out);
            self.emit(&mut last, &end, out);
        }
        // What still waits are corner arcs that have no next block, and what stands behind them.
        while let Some(item) = self.waiting.pop_front() {
            let (Waiting::Other(payload) | Waiting::CornerArc(payload)) = item;
            out(Out::Other(payload));
        }
        (last.done, last.waiting, last.rounded, last.idle) = (true, 0, false, 0);
        self.newer = Some(last);
        Ok(())
    }

    /// A start-up without movement is made by the next block that moves (4.7.3 point 8 a).
    fn push_zero(&mut self, m: PlaneMove, payload: T, out: &mut impl FnMut(Out<T>)) -> Done<T> {
        if self.newer.is_none() {
            self.tool = m.to;
            out(Out::Move { to: m.to, shape: m.shape, payload, inserted: false });
            return Ok(());
        }
        if self.rules.zero_move == ZeroMove::Square {
            self.flush(out)?;
        }
        self.pass(payload, true, out)
    }

    fn start_up(&mut self, m: PlaneMove, o: Offset, payload: T) -> Done<T> {
        if m.shape != Shape::Line {
            return Err(at(Fault::StartOrCancelInArc, payload));
        }
        let element = match Element::new(&m, o) {
            Ok(element) => element,
            Err(fault) => return Err(at(fault, payload)),
        };
        let short = element.length() < element.radius - SHORT_START_UP_MM;
        if short && self.rules.interference && self.rules.long_start_up {
            return Err(at(Fault::Interference, payload));
        }
        self.tool = m.from;
        self.newer = Some(Pending::new(element, payload, Phase::StartUp, Corner::at(m.from)));
        Ok(())
    }

    /// A block in the mode: joins it to the last, which can then be checked, which settles the one before.
    fn go_on(
        &mut self,
        mut last: Pending<T>,
        m: PlaneMove,
        o: Offset,
        payload: T,
        out: &mut impl FnMut(Out<T>),
    ) -> Done<T> {
        let how = match last.phase {
            Phase::StartUp if last.done => How::StartedUp,
            _ if last.done => How::Square,
            Phase::StartUp => How::StartUp,
            Phase::Mode if last.rounded => How::Round,
            Phase::Mode => How::Mode,
        };
        let joined = Element::new(&m, o).and_then(|element| {
            element.fits(last.element.radius, self.rules.interference)?;
            Ok((element, corner::join(&last.element, &element, how, &self.rules)?))
        });
        let (element, mut start) = match joined {
            Ok(joined) => joined,
            Err(fault) => return Err(FaultAt { fault, at: payload, before: Some(last.payload) }),
        };
        self.check(&mut last, &element, &mut start)?;
        self.emit_older(&last.start, out);
        self.older = Some(last);
        self.newer = Some(Pending::new(element, payload, Phase::Mode, start));
        Ok(())
    }

    fn cancel(
        &mut self,
        mut last: Pending<T>,
        m: PlaneMove,
        payload: T,
        out: &mut impl FnMut(Out<T>),
    ) -> Done<T> {
        if m.shape != Shape::Line {
            // The fault is this block's alone: those before it are done.
            let before = Some(last.payload.clone());
            self.newer = Some(last);
            self.flush(out)?;
            return Err(FaultAt { fault: Fault::StartOrCancelInArc, at: payload, before });
        }
        let side = if last.element.side > 0.0 { Side::Left } else { Side::Right };
        // Straight from start-up to cancel there is no block in the mode to stand square to.
        let square = last.done || last.phase == Phase::StartUp;
        let joined = Element::new(&m, Offset { side, radius: last.element.radius }).and_then(|element| {
            let end = corner::join(&last.element, &element, How::Cancel, &self.rules)?;
            Ok((element, if square { last.square_corner() } else { end }))
        });
        let (element, mut end) = match joined {
            Ok(joined) => joined,
            Err(fault) => return Err(FaultAt { fault, at: payload, before: Some(last.payload) }),
        };
        self.check(&mut last, &element, &mut end)?;
        self.emit_older(&last.start, out);
        self.emit(&mut last, &end, out);
        self.tool = m.to;
        out(Out::Move { to: m.to, shape: Shape::Line, payload, inserted: false });
        Ok(())
    }

    /// The interference check of `last` between its two corners. Start-up runs at any angle.
    fn check(&self, last: &mut Pending<T>, next: &Element, end: &mut Corner) -> Done<T> {
        if last.done || last.phase == Phase::StartUp {
            return Ok(());
        }
        let before = self.older.as_ref();
        let neighbour = before.map(|p| &p.element);
        match interference::check(neighbour, &last.element, next, &mut last.start, end, &self.rules) {
            Ok(straight) => {
                last.straight = straight;
                Ok(())
            }
            Err(fault) => {
                Err(FaultAt { fault, at: last.payload.clone(), before: before.map(|p| p.payload.clone()) })
            }
        }
    }

    fn emit_older(&mut self, end: &Corner, out: &mut impl FnMut(Out<T>)) {
        if let Some(mut older) = self.older.take() {
            self.emit(&mut older, end, out);
        }
    }

    /// The block's own move, the pieces round its corner, and what waits behind it: blocks without movement
    /// are executed where the corner ends (4.7.3 points 8 b and 9).
    fn emit(&mut self, p: &mut Pending<T>, end: &Corner, out: &mut impl FnMut(Out<T>)) {
        if !p.done {
            let shape = p.shape(end);
            self.tool = end.entry();
            out(Out::Move { to: self.tool, shape, payload: p.payload.clone(), inserted: false });
        }
        let mut arc_due = p.rounded && end.round.is_some();
        if !arc_due {
            self.pieces(&p.payload, end, out);
        }
        for _ in 0..p.waiting {
            match self.waiting.pop_front() {
                Some(Waiting::CornerArc(payload)) if arc_due => {
                    arc_due = false;
                    self.pieces(&payload, end, out);
                }
                Some(Waiting::Other(payload) | Waiting::CornerArc(payload)) => out(Out::Other(payload)),
                None => {}
            }
        }
        p.waiting = 0;
    }

    fn pieces(&mut self, payload: &T, end: &Corner, out: &mut impl FnMut(Out<T>)) {
        for (i, &to) in end.tips().iter().enumerate() {
            if distance(self.tool, to) <= NO_MOVE_MM {
                continue;
            }
            let shape = match end.round {
                Some((center, sweep)) if i + 1 == end.tips().len() => Shape::Arc { center, sweep },
                _ => Shape::Line,
            };
            self.tool = to;
            out(Out::Move { to, shape, payload: payload.clone(), inserted: true });
        }
    }
}

impl<T> Pending<T> {
    fn new(element: Element, payload: T, phase: Phase, start: Corner) -> Pending<T> {
        Pending {
            element,
            payload,
            phase,
            start,
            straight: false,
            done: false,
            rounded: false,
            waiting: 0,
            idle: 0,
        }
    }

    /// The corner that ends square to the block.
    fn square_corner(&self) -> Corner {
        Corner::at(self.element.end_tip(self.element.radius))
    }

    /// The tool centre's way along the block.
    fn shape(&self, end: &Corner) -> Shape {
        match self.element.shape {
            Shape::Arc { center, sweep } if !self.straight => {
                let left = interference::sweep_left(sweep, &self.start, end);
                // An offset that shrank to nothing may be left with the rounding of its angles.
                let vanished = distance(self.start.exit(), end.entry()) <= NO_MOVE_MM
                    && left * sweep.signum() < NO_MOVE_MM;
                if vanished { Shape::Line } else { Shape::Arc { center, sweep: left } }
            }
            _ => Shape::Line,
        }
    }
}

fn at<T>(fault: Fault, payload: T) -> FaultAt<T> {
    FaultAt { fault, at: payload, before: None }
}
