//! The front of the planner: moves in, a setpoint every servo period out.

use crate::assemble::Assembler;
use crate::blend::JointRules;
use crate::interpolate::{Interpolator, Outcome};
use crate::limits::{Inverse, Limits, MAX_FEED_OVERRIDE};
use crate::moves::Move;
use crate::plan::{CELLS, Overrides, Queue, SWEEP_A_PERIOD};
use ferrocut_geometry::Position;
use ferrocut_machine::Machine;
use std::fmt;

/// Where the axes shall be at the end of one servo period.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Setpoint {
    /// Commanded position of every axis: mm, degrees.
    pub position: Position,
    /// Speed along the path, mm/s (degrees/s where only rotary axes move).
    pub velocity: f64,
    /// Mark of the move being run at the end of the period, or of the last one run.
    pub tag: u64,
    /// What the planner is doing.
    pub state: State,
}

/// What the planner is doing.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum State {
    /// Nothing to do, at rest on the end of the last move.
    Idle,
    /// At rest with moves, waiting for enough of them or for [`Motion::finish`].
    Waiting,
    /// Running; with override 0 at standstill too.
    Running,
    /// Slowing down for feed hold or abort, or running a move to its end that may not be held.
    Holding,
    /// At rest by feed hold, with moves left.
    Held,
}

/// There is no room for a move now: tick first.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Full;

impl fmt::Display for Full {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the look-ahead is full")
    }
}

impl std::error::Error for Full {}

/// The planner: a queue of moves run as one motion within the limits of every axis.
///
/// **When a run begins.** A run is a chain of moves that is not at rest between them. It begins when its
/// end is known (a corner, an exact stop, a change between positioning and cutting,
/// [`finish`](Self::finish)) or when the queue is full. Until then the state is [`State::Waiting`]. A
/// caller that fills up before every tick thus gets the same setpoints whatever the rhythm of its own
/// input.
///
/// **When moves fail to come.** What was pushed is always planned to rest. When the run is about to enter
/// the last cell it knows, the last move is closed: it ends at rest and what is pushed later begins a new
/// run.
#[derive(Debug)]
pub struct Motion {
    period: f64,
    assembler: Assembler,
    queue: Queue,
    interpolator: Interpolator,
    hold: bool,
    aborting: bool,
    /// The cell being run is to be planned again.
    retarget: bool,
}

/// Cells that a move and the blend before it take; an arc of many slices flows in as there is room.
const CELLS_A_MOVE: usize = 2;

impl Motion {
    /// A planner for `machine` whose axes stand at `start`. All memory is taken here.
    pub fn new(machine: &Machine, start: Position) -> Motion {
        let limits = Limits::new(machine);
        let period = machine.servo_period_ms / 1000.0;
        let rules =
            JointRules { tolerance: machine.path.tolerance, exact_stop: machine.path.exact_stop, period };
        Motion {
            period,
            assembler: Assembler::new(Inverse::new(&limits), rules, start),
            queue: Queue::new(),
            interpolator: Interpolator::new(limits, start),
            hold: false,
            aborting: false,
            retarget: false,
        }
    }

    /// How many lines can be pushed now; 0 is full. An arc of many turns may fill what is free alone, so ask
    /// before every push. During an abort it is 0.
    pub fn free(&self) -> usize {
        if self.assembler.is_blocked() || self.aborting { 0 } else { self.queue.room() / CELLS_A_MOVE }
    }

    /// Takes a move, which begins where the one before it ends. A move that goes nowhere is taken and
    /// forgotten.
    pub fn push(&mut self, m: &Move) -> Result<(), Full> {
        if self.free() == 0 {
            return Err(Full);
        }
        let added = self.assembler.push(m, &mut self.queue);
        self.retarget |= self.queue.plan_pushed(added);
        Ok(())
    }

    /// Nothing follows for now: what is there is run to rest on its end.
    pub fn finish(&mut self) {
        self.assembler.close(&mut self.queue);
        self.retarget |= self.queue.plan_all();
    }

    /// Feed override 0…2 and rapid override 0…1 as factors; clamped, and left as they are if not a
    /// number. Both take effect at once within the limits of acceleration.
    pub fn set_override(&mut self, feed: f64, rapid: f64) {
        let old = self.queue.overrides();
        let clamp = |new: f64, max: f64, old: f64| if new.is_nan() { old } else { new.clamp(0.0, max) };
        let new =
            Overrides { feed: clamp(feed, MAX_FEED_OVERRIDE, old.feed), rapid: clamp(rapid, 1.0, old.rapid) };
        if new != old {
            self.queue.set_overrides(new);
            self.retarget = true;
        }
    }

    /// Feed hold: comes to rest on the path as soon as the limits allow. Tapping is run to its end first.
    pub fn hold(&mut self) {
        self.retarget |= !self.hold;
        self.hold = true;
    }

    /// Ends feed hold.
    pub fn resume(&mut self) {
        self.retarget |= self.hold;
        self.hold = false;
    }

    /// Comes to rest on the path as soon as the limits allow, tapping or not, and forgets the moves that
    /// are left. [`position`](Self::position), once at rest, is where the next move begins. Feed hold
    /// stays as it is.
    pub fn abort(&mut self) {
        self.aborting = true;
        self.retarget = true;
        if self.at_rest() {
            self.forget();
        }
    }

    /// Calls the place where the axes stand by another position. Only at rest, with every move run to its end;
    /// else nothing changes.
    pub fn rename(&mut self, at: Position) {
        if self.is_empty() && self.at_rest() && at.is_finite() {
            self.interpolator.rename(at);
            self.forget();
        }
    }

    /// Where the axes are commanded to be.
    pub fn position(&self) -> Position {
        self.interpolator.position()
    }

    /// Whether the axes stand still.
    pub fn at_rest(&self) -> bool {
        self.interpolator.speed() == 0.0
    }

    /// Whether every move pushed has been run to its end.
    pub fn is_empty(&self) -> bool {
        self.queue.len() == 0 && self.assembler.is_empty()
    }

    /// Goes on by one servo period.
    pub fn tick(&mut self) -> Setpoint {
        self.assembler.run(&mut self.queue);
        self.retarget |= self.queue.plan(SWEEP_A_PERIOD);
        if !self.interpolator.is_begun() && self.may_begin() {
            let _ = self.queue.plan_all();
            self.interpolator.enter(&self.queue, self.is_stopping());
            self.retarget = false;
        }
        if self.interpolator.is_begun() {
            if self.retarget {
                self.retarget = false;
                self.interpolator.retarget(&self.queue, self.is_stopping());
            }
            self.advance();
        }
        if self.aborting && self.at_rest() {
            self.forget();
        }
        self.setpoint()
    }

    /// Runs through as many cells as end in this period.
    fn advance(&mut self) {
        let mut time = self.period;
        loop {
            match self.interpolator.advance(&self.queue, time) {
                Outcome::Inside => {
                    self.interpolator.sample(&self.queue);
                    return;
                }
                // The remainder of the period is spent at rest, so that one setpoint is the programmed
                // point.
                Outcome::Rest => {
                    self.interpolator.arrive(&self.queue);
                    self.queue.retire();
                    return;
                }
                Outcome::Left(left) => {
                    time = left;
                    self.queue.retire();
                    self.extend();
                    self.interpolator.enter(&self.queue, self.is_stopping());
                }
            }
        }
    }

    /// Sees to it that the oldest cell is not the last one known, unless it ends at rest.
    fn extend(&mut self) {
        let is_last = self.queue.len() == 1 && !self.queue.has_rest();
        if is_last {
            if !self.assembler.is_blocked() {
                self.assembler.close(&mut self.queue);
            } else {
                self.assembler.run(&mut self.queue);
            }
            let _ = self.queue.plan_all();
        } else {
            let _ = self.queue.plan(0);
        }
    }

    fn may_begin(&self) -> bool {
        !self.hold && !self.aborting && (self.queue.has_rest() || (self.queue.len() > 0 && self.free() == 0))
    }

    /// Whether the oldest cell is to be brought to a stop.
    fn is_stopping(&self) -> bool {
        use crate::limits::Class::Locked;
        let Some((_, node)) = self.queue.front() else { return true };
        let held = self.hold || self.queue.overrides().of(node.class) == 0.0;
        self.aborting || (held && node.class != Locked)
    }

    fn forget(&mut self) {
        self.queue.clear();
        self.interpolator.clear();
        self.assembler.clear(self.interpolator.position());
        self.aborting = false;
        self.retarget = false;
    }

    fn setpoint(&self) -> Setpoint {
        let state = match (self.is_empty(), self.at_rest()) {
            (true, _) => State::Idle,
            (_, true) if self.hold => State::Held,
            (_, false) if self.hold || self.aborting => State::Holding,
            _ if self.interpolator.is_begun() || self.may_begin() => State::Running,
            _ => State::Waiting,
        };
        Setpoint {
            position: self.position(),
            velocity: self.interpolator.speed(),
            tag: self.interpolator.tag(),
            state,
        }
    }

    /// How many lines fit into an empty planner.
    pub const CAPACITY: usize = CELLS / CELLS_A_MOVE;
}
