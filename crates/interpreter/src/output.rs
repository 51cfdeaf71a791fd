//! The end of the stages: steps on machine axes through the two that look ahead, corner rounding and
//! cutter compensation, into the queue that the iterator gives out.
//!
//! Work offset and tool length shift a path as a whole, so that the two stages, which stand before tool
//! length in the order of the stages, may work on machine coordinates. While neither is in use a step
//! goes straight into the queue.

use crate::interpreter::Interpreter;
use crate::stages::corner::{Corner, CornerRequest, Refused};
use crate::stages::cutter::{self, Offset, Out, PlaneMove, Shape, Stage};
use ferrocut_geometry::{Axis, Plane, Position};
use ferrocut_machine::{Alarm, Fault};
use ferrocut_program::Span;
use ferrocut_toolpath::{Dwell, FeedAlong, Op, Step};
use std::collections::VecDeque;

/// How a positioning arrives that always comes from one side (G60). It is done behind cutter compensation, so
/// that the end point is the tool's own (GSK990MC 4.2.6).
#[derive(Clone, Copy, Debug)]
pub(crate) struct OneWay {
    /// From the end point to where the tool goes first, mm.
    pub beyond: Position,
    /// Pause there, s.
    pub dwell_s: f64,
}

/// What compensated steps go into.
#[derive(Clone)]
struct Queue {
    steps: VecDeque<Step>,
    /// Where the axes are commanded to be, compensation included.
    actual: Position,
    /// Positionings among the moves that compensation holds, by their blocks.
    one_way: VecDeque<(Span, OneWay)>,
}

/// How far the output was before a block.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mark {
    steps: usize,
    actual: Position,
    path_end: Position,
}

/// The stages that look ahead, and the queue behind them.
#[derive(Clone)]
pub(crate) struct Output {
    queue: Queue,
    corner: Corner,
    cutter: Stage<Step>,
    /// What the block asks to be put behind its move.
    request: Option<CornerRequest>,
    /// Codes of the block behind a corner that come before its move, which is still awaited.
    codes: Vec<Step>,
    /// How many of them are of blocks before this one, which moved.
    earlier_codes: usize,
    /// Compensation from that move on, and whether what is before ends square.
    later: Option<(Plane, Option<Offset>, bool)>,
    /// Plane of cutter compensation.
    plane: Plane,
    /// Compensation programmed.
    offset: Option<Offset>,
    /// A canned cycle leaves compensation aside.
    paused: bool,
    /// End of the programmed path.
    pub(crate) path_end: Position,
    /// The block being executed has moved in the plane of compensation.
    moved: bool,
    /// A stage has refused a move: what the block still makes is left out.
    refused: bool,
    /// Where the steps given out lead.
    given: Position,
    /// The block that entered a forbidden area: what it still makes is left out.
    left_out: Option<u64>,
    /// The block that turned stored stroke check 2 on or off last, and whether it was on before.
    check_changed: (u64, bool),
}

impl Output {
    pub(crate) fn new(rules: cutter::Rules, start: Position) -> Output {
        Output {
            queue: Queue { steps: VecDeque::with_capacity(64), actual: start, one_way: VecDeque::new() },
            corner: Corner::default(),
            cutter: Stage::new(rules),
            request: None,
            codes: Vec::new(),
            earlier_codes: 0,
            later: None,
            plane: Plane::Xy,
            offset: None,
            paused: false,
            path_end: start,
            moved: false,
            refused: false,
            given: start,
            left_out: None,
            check_changed: (0, false),
        }
    }

    /// The next step to be given out.
    #[inline]
    pub(crate) fn pop(&mut self) -> Option<Step> {
        self.queue.steps.pop_front()
    }

    /// Stored stroke check 2 is turned on or off by this block: moves that are held are of blocks before it.
    pub(crate) fn check_changes(&mut self, block: u64, was: bool) {
        self.check_changed = (block, was);
    }

    /// Steps that wait to be given out.
    pub(crate) fn waiting(&self) -> usize {
        self.queue.steps.len()
    }

    /// Whether no step waits to be given out.
    pub(crate) fn is_empty(&self) -> bool {
        self.queue.steps.is_empty()
    }

    /// How far it is now.
    #[inline]
    pub(crate) fn mark(&self) -> Mark {
        Mark { steps: self.queue.steps.len(), actual: self.queue.actual, path_end: self.path_end }
    }

    /// Takes back the steps since a mark, of which none was given out. False where a stage holds some of them: then
    /// they stay.
    pub(crate) fn take_back(&mut self, mark: Mark) -> bool {
        if !self.is_direct() {
            return false;
        }
        self.queue.steps.truncate(mark.steps);
        (self.queue.actual, self.path_end) = (mark.actual, mark.path_end);
        true
    }

    /// Whether steps pass by the stages.
    #[inline]
    fn is_direct(&self) -> bool {
        self.request.is_none()
            && self.offset.is_none()
            && self.corner.is_empty()
            && !self.cutter.in_mode()
            && !self.cutter.takes_still_moves()
    }

    /// Whether a move to the end of the path counts: the tool may stand off it.
    #[inline]
    pub(crate) fn takes_still_moves(&self) -> bool {
        self.cutter.takes_still_moves()
    }

    /// Begins a block.
    #[inline]
    pub(crate) fn start_block(&mut self) {
        self.refused = false;
        self.moved = false;
        self.earlier_codes = self.codes.len();
    }

    /// Ends a block while compensation is in force or a corner waits. `names_plane`: it names axes of the plane
    /// for a move.
    pub(crate) fn end_block(&mut self, names_plane: bool, span: Span) -> Result<(), Refused> {
        if self.moved || self.paused || self.refused {
            return Ok(());
        }
        if names_plane || self.codes.len() > self.earlier_codes {
            self.move_is_missing()?;
        }
        let plane = self.plane;
        let queue = &mut self.queue;
        let done = self.cutter.idle(names_plane, &mut |out| queue.deliver(out, plane));
        done.map_err(|refused| match refused {
            Some(refused) => (fault_of(refused.fault), refused.at.span),
            None => (Fault::CutterIdleBlocks, span),
        })
    }

    /// The positioning that comes next, from the block of `span`, arrives from one side.
    pub(crate) fn arrive_one_way(&mut self, span: Span, how: OneWay) {
        self.queue.one_way.push_back((span, how));
    }

    /// Whether the end of a block matters to a stage.
    #[inline]
    pub(crate) fn looks_ahead(&self) -> bool {
        self.cutter.in_mode() || !self.corner.is_empty()
    }

    /// Where the axes are commanded to be after all steps given out, compensation included.
    pub(crate) fn commanded(&self) -> Position {
        self.queue.actual
    }

    /// Whether cutter compensation is in force or on its way out.
    pub(crate) fn in_cutter_mode(&self) -> bool {
        let offset = self.later.map_or(self.offset, |(_, offset, _)| offset);
        offset.is_some() || self.cutter.in_mode()
    }

    /// Whether compensation to this side is in force.
    pub(crate) fn is_on_side(&self, side: cutter::Side) -> bool {
        self.cutter.in_mode() && self.offset.is_some_and(|offset| offset.side == side)
    }

    /// On which side of the path the tool runs, where an offset other than 0 is in force.
    pub(crate) fn tool_is_left(&self) -> Option<bool> {
        let offset = self.offset.filter(|offset| self.cutter.in_mode() && offset.radius != 0.0)?;
        Some((offset.side == cutter::Side::Left) == (offset.radius > 0.0))
    }

    /// Takes a step.
    #[inline]
    pub(crate) fn push(&mut self, step: Step) -> Result<(), Refused> {
        if self.is_direct() && !self.refused {
            if let Some(to) = step.op.target() {
                self.path_end = *to;
                self.queue.actual = *to;
            }
            self.queue.steps.push_back(step);
            return Ok(());
        }
        if self.refused {
            return Ok(());
        }
        let done = self.push_through(step);
        self.refused |= done.is_err();
        done
    }

    /// Asks for a chamfer or arc behind the next move.
    pub(crate) fn request_corner(&mut self, request: CornerRequest) {
        if !self.in_cutter_mode() {
            self.plane = request.plane;
        }
        self.request = Some(request);
    }

    /// Whether a move waits for the one behind its corner.
    pub(crate) fn corner_waits(&self) -> bool {
        !self.corner.is_empty()
    }

    /// A move waits for the one behind its corner, which does not come.
    pub(crate) fn move_is_missing(&mut self) -> Result<(), Refused> {
        let Some(refused) = self.corner.interrupted() else { return Ok(()) };
        self.corner.release();
        self.codes.clear();
        self.begin_later();
        Err(refused)
    }

    fn push_through(&mut self, step: Step) -> Result<(), Refused> {
        let ends = matches!(step.op, Op::End(_));
        let Some(to) = step.op.target().copied() else {
            if ends {
                self.move_is_missing()?;
                self.flush()?;
            }
            if !self.corner.is_empty() {
                // The block may still move (5: its codes and its move are begun together).
                self.codes.push(step);
                return Ok(());
            }
            return self.compensate(self.path_end, step);
        };
        let from = self.path_end;
        self.path_end = to;
        self.moved |= plane_move(self.plane, from, &step.op).is_some();
        let mut pieces: Vec<(Position, Step)> = Vec::new();
        let request = self.request.take();
        // The move of the block comes last, if it is not held for a corner of its own.
        let is_held = request.is_some();
        let joined = self.corner.push(from, step, request, |from, step| pieces.push((from, step)));
        if joined.is_err() {
            self.codes.clear();
            self.begin_later();
        }
        joined?;
        let own = if is_held { None } else { pieces.pop() };
        for (from, step) in pieces {
            self.compensate(from, step)?;
        }
        self.square_later()?;
        self.begin_later();
        for step in std::mem::take(&mut self.codes) {
            self.compensate(from, step)?;
        }
        match own {
            Some((from, step)) => self.compensate(from, step),
            None => Ok(()),
        }
    }

    /// What is before the compensation that comes ends square, if it is to.
    fn square_later(&mut self) -> Result<(), Refused> {
        match self.later {
            Some((.., true)) => self.flush_cutter(),
            _ => Ok(()),
        }
    }

    /// Puts the compensation in force that was to come with the move behind a corner.
    fn begin_later(&mut self) {
        if let Some((plane, offset, _)) = self.later.take() {
            self.begin_cutter(plane, offset);
        }
    }

    /// A step through cutter compensation.
    fn compensate(&mut self, from: Position, step: Step) -> Result<(), Refused> {
        let plane = self.plane;
        let queue = &mut self.queue;
        let mut out = |out: Out<Step>| queue.deliver(out, plane);
        let done = match plane_move(plane, from, &step.op) {
            Some(m) => self.cutter.push(m, step, &mut out),
            // Blocks are counted at their end.
            None => match step.op {
                Op::Rapid { .. } | Op::Feed { .. } if self.cutter.takes_every_move() => {
                    let at = plane.of(from);
                    self.cutter.push(PlaneMove { from: at, to: at, shape: Shape::Line }, step, &mut out)
                }
                _ => self.cutter.pass(step, false, &mut out),
            },
        };
        done.map_err(|refused| (fault_of(refused.fault), refused.at.span))
    }

    /// Puts compensation in force from the next move on; `None` cancels it. What is before may end `square`.
    pub(crate) fn set_cutter(
        &mut self,
        plane: Plane,
        offset: Option<Offset>,
        square: bool,
    ) -> Result<(), Refused> {
        if !self.corner.is_empty() {
            // That is the move behind the corner, which belongs to what is before.
            let square = square || self.later.is_some_and(|(.., square)| square);
            self.later = Some((plane, offset, square));
            return Ok(());
        }
        if square {
            self.flush()?;
        }
        self.begin_cutter(plane, offset);
        Ok(())
    }

    fn begin_cutter(&mut self, plane: Plane, offset: Option<Offset>) {
        if !self.in_cutter_mode() {
            self.plane = plane;
        }
        self.offset = offset;
        if !self.paused {
            self.cutter.set(offset);
        }
    }

    /// How much longer compensation may make an arc than it was, rad.
    pub(crate) fn set_longer_arcs(&mut self, longer: f64) {
        self.cutter.set_longer(longer);
    }

    /// From the next move on compensation is left aside, until [`resume_cutter`](Self::resume_cutter).
    pub(crate) fn pause_cutter(&mut self) {
        self.paused = true;
        self.cutter.set(None);
    }

    /// Compensation as programmed again: the next move starts it up.
    pub(crate) fn resume_cutter(&mut self) {
        if self.paused {
            self.paused = false;
            self.cutter.set(self.offset);
        }
    }

    /// While compensation is left aside: brings the tool from its vector back onto the path, where no move
    /// in the plane does. `step` is a move to the end of the path.
    pub(crate) fn back_onto_path(&mut self, step: Step) -> Result<(), Refused> {
        self.flush()?;
        if self.cutter.in_mode() {
            self.cutter.forget();
            if let Some(to) = step.op.target().filter(|to| **to != self.queue.actual) {
                self.queue.actual = *to;
                self.queue.steps.push_back(step);
            }
        }
        Ok(())
    }

    /// The next move runs without compensation, the one after it starts up again.
    pub(crate) fn suspend_cutter(&mut self) {
        if self.in_cutter_mode() {
            self.cutter.suspend();
        }
    }

    /// G39: an arc about the corner. `step` is a cut to the corner itself, for its feed.
    pub(crate) fn corner_arc(&mut self, step: Step) -> Result<(), Refused> {
        self.move_is_missing()?;
        self.cutter.corner_arc(step).map_err(|refused| (fault_of(refused.fault), refused.at.span))
    }

    /// Hands out what the stages hold.
    pub(crate) fn flush(&mut self) -> Result<(), Refused> {
        if let Some((from, step)) = self.corner.release() {
            self.compensate(from, step)?;
        }
        self.square_later()?;
        self.begin_later();
        for step in std::mem::take(&mut self.codes) {
            self.compensate(self.path_end, step)?;
        }
        self.flush_cutter()
    }

    fn flush_cutter(&mut self) -> Result<(), Refused> {
        let plane = self.plane;
        let queue = &mut self.queue;
        let done = self.cutter.flush(&mut |out| queue.deliver(out, plane));
        done.map_err(|refused| (fault_of(refused.fault), refused.at.span))
    }

    /// Hands out what the stages hold before compensation is cancelled.
    pub(crate) fn finish_cutter(&mut self) -> Result<(), Refused> {
        let plane = self.plane;
        let queue = &mut self.queue;
        let done = self.cutter.finish(&mut |out| queue.deliver(out, plane));
        done.map_err(|refused| (fault_of(refused.fault), refused.at.span))
    }

    /// The parameters behind the rules of compensation changed.
    pub(crate) fn set_rules(&mut self, rules: cutter::Rules) {
        self.cutter.set_rules(rules);
    }

    /// A checker goes on from another point than the last move's end.
    pub(crate) fn jump_to(&mut self, at: Position) {
        self.path_end = at;
        if self.is_direct() {
            self.queue.actual = at;
            if self.is_empty() {
                self.given = at;
            }
        }
    }
}

/// The move as one of the plane; `None` if nothing moves in it.
fn plane_move(plane: Plane, from: Position, op: &Op) -> Option<PlaneMove> {
    let (start, end) = (plane.of(from), plane.of(*op.target()?));
    let shape = match *op {
        Op::Arc { plane: own, center, sweep, .. } if own == plane => Shape::Arc { center, sweep },
        Op::Rapid { .. } | Op::Feed { .. } if start != end => Shape::Line,
        _ => return None,
    };
    Some(PlaneMove { from: start, to: end, shape })
}

impl Queue {
    /// Takes what comes out of compensation in `plane`.
    fn deliver(&mut self, out: Out<Step>, plane: Plane) {
        // A piece about a corner moves no axis but those of the plane: where the move before was handed out by itself, others
        // may have moved since.
        let (mut step, place, shape, own) = match out {
            Out::Move { to, shape, payload, inserted } => (payload, to, Some(shape), !inserted),
            Out::Corner { to, shape, payload } => return self.deliver_corner(payload, to, shape, plane),
            Out::Other(step) => (step, plane.of(self.actual), None, true),
        };
        let Some(programmed) = step.op.target() else {
            self.steps.push_back(step);
            return;
        };
        let mut to = if own { *programmed } else { self.actual };
        to[plane.first()] = place[0];
        to[plane.second()] = place[1];
        step.op = with_shape(step.op, to, plane, shape);
        if own && self.one_way.front().is_some_and(|(span, _)| *span == step.span) {
            return self.arrive(step, to);
        }
        let stays = Axis::ALL.into_iter().all(|axis| to[axis] == self.actual[axis]);
        if stays && !matches!(step.op, Op::Arc { .. }) {
            return;
        }
        self.actual = to;
        self.steps.push_back(step);
    }

    /// A piece about a corner before the move of `step`: rotary axes go with it, the others wait for the move
    /// (LinuxCNC).
    fn deliver_corner(&mut self, mut step: Step, place: [f64; 2], shape: Shape, plane: Plane) {
        let Some(programmed) = step.op.target() else { return };
        let mut to = *programmed;
        to[plane.first()] = place[0];
        to[plane.second()] = place[1];
        to[plane.normal()] = self.actual[plane.normal()];
        step.op = with_shape(step.op, to, plane, Some(shape));
        self.actual = to;
        self.steps.push_back(step);
    }

    /// A positioning to `to` from one side.
    fn arrive(&mut self, step: Step, to: Position) {
        if let (Some((span, how)), &Op::Rapid { straight, speed, path, .. }) =
            (self.one_way.pop_front(), &step.op)
        {
            let first = Op::Rapid { to: to + how.beyond, straight, speed, path };
            let (block, section, main_line) = (step.block, step.section, step.main_line);
            let of_block = |op: Op| Step { op, span, block, section, main_line };
            self.steps.push_back(of_block(first));
            if how.dwell_s > 0.0 {
                self.steps.push_back(of_block(Op::Dwell(Dwell::Seconds(how.dwell_s))));
            }
        }
        self.actual = to;
        self.steps.push_back(step);
    }
}

/// The same move to another end and in another shape.
fn with_shape(op: Op, to: Position, plane: Plane, shape: Option<Shape>) -> Op {
    match (op, shape) {
        (Op::Rapid { straight, speed, path, .. }, _) => Op::Rapid { to, straight, speed, path },
        (Op::Feed { feed, path, .. } | Op::Arc { feed, path, .. }, Some(Shape::Line)) => {
            Op::Feed { to, feed, path }
        }
        (Op::Arc { feed, feed_along, path, .. }, Some(Shape::Arc { center, sweep })) => {
            Op::Arc { to, plane, center, sweep, feed, feed_along, path }
        }
        (Op::Feed { feed, path, .. }, Some(Shape::Arc { center, sweep })) => {
            Op::Arc { to, plane, center, sweep, feed, feed_along: FeedAlong::Path, path }
        }
        (Op::Feed { feed, path, .. }, None) => Op::Feed { to, feed, path },
        (Op::Tap { pitch, rpm, goes_on, .. }, _) => Op::Tap { to, pitch, rpm, goes_on },
        (Op::Skip { feed, hit, away, input, .. }, _) => Op::Skip { to, feed, hit, away, input },
        (op, _) => op,
    }
}

pub(crate) fn fault_of(fault: cutter::Fault) -> Fault {
    match fault {
        cutter::Fault::NoIntersection => Fault::CutterNoIntersection,
        cutter::Fault::StartOrCancelInArc => Fault::CutterStartInArc,
        cutter::Fault::ArcCenterOvercut => Fault::CutterArcCenter,
        cutter::Fault::Interference => Fault::CutterInterference,
        cutter::Fault::TooManyIdleBlocks => Fault::CutterIdleBlocks,
        cutter::Fault::CornerArcOutsideMode => Fault::CornerArcForm,
        cutter::Fault::Reversal => Fault::CutterReversal,
        cutter::Fault::EntryTooShort => Fault::CutterEntryTooShort,
        cutter::Fault::ArcTooSmall => Fault::CutterArcTooSmall,
        cutter::Fault::ArcAfterCancel => Fault::CutterArcAfterCancel,
        cutter::Fault::NotFinite => Fault::CoordinateTooLarge,
    }
}

impl Interpreter {
    /// A step of the block being executed.
    #[inline]
    pub(crate) fn step(&self, op: Op) -> Step {
        let (block, section, main_line) = (self.flow.begun(), self.flow.section(), self.flow.main_line());
        Step { op, span: self.words.block_span(), block, section, main_line }
    }

    /// Gives out a step of the block being executed.
    #[inline]
    pub(crate) fn emit(&mut self, op: Op) {
        self.flow.got_on();
        if self.look_back.is_some() {
            self.note_in_force();
        }
        let step = self.step(op);
        if let Err(refused) = self.output.push(step) {
            self.refuse(refused);
        }
    }

    /// Whether a step that is about to be given out is left out, as its block enters a forbidden area: judged here, behind
    /// the stages, by the way of the tool itself (GSK990MC part 2, 2.5.2 and 2.6).
    #[inline]
    pub(crate) fn is_left_out(&mut self, step: &Step) -> bool {
        if self.output.left_out == Some(step.block) {
            return true;
        }
        let from = self.output.given;
        let (changed, was) = self.output.check_changed;
        let check_2 = if step.block < changed { was } else { self.stroke_check_2 };
        if (self.rules.stroke.first_is_set || check_2)
            && let Some(alarm) = self.stroke_alarm_of(from, &step.op, check_2)
        {
            self.leave_out(Box::new(Alarm { span: step.span, ..*alarm }), step.block);
            return true;
        }
        match &step.op {
            Op::Datum { at } => self.output.given = *at,
            op => {
                if let Some(to) = op.target() {
                    self.output.given = *to;
                }
            }
        }
        false
    }

    /// The alarm of a step comes behind those before it, and in the place of all that comes after; a checker goes on.
    fn leave_out(&mut self, alarm: Box<Alarm>, block: u64) {
        self.output.left_out = Some(block);
        if !self.options.keep_going {
            self.output.queue.steps.clear();
            self.alarms.clear();
        }
        self.note(alarm);
    }

    /// Raises the alarm of a stage that looks ahead. It may concern an earlier block.
    pub(crate) fn refuse(&mut self, (fault, span): (Fault, Span)) {
        let alarm = self.alarm(fault, span);
        self.note(alarm);
    }
}
