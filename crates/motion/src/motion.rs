//! The front of the planner: moves in, a setpoint every servo period out.

use crate::assemble::{Assembler, CELLS_A_MOVE};
use crate::limits::{Class, Inverses, Limits, MAX_FEED_OVERRIDE};
use crate::moves::Move;
use crate::path::joint::JointRules;
use crate::timing::interpolate::{Interpolator, Outcome};
use crate::timing::plan::{Overrides, Plan};
use crate::timing::queue::{CELLS, Queue};
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
/// **When moves fail to come.** What was pushed is always planned to rest, so a run that is not fed comes to
/// rest on the path, before the joint that is not known yet, and goes on as a run that begins.
#[derive(Debug)]
pub struct Motion {
    period: f64,
    assembler: Assembler,
    queue: Queue,
    plan: Plan,
    interpolator: Interpolator,
    hold: bool,
    aborting: bool,
    /// The plan is being run.
    runs: bool,
    /// The plan ends with a stop on the path.
    stopping: bool,
    /// The plan is to be made anew before it is run.
    stale: bool,
    /// The overrides have changed since it was made.
    outdated: bool,
    /// Time until the next try to plan with them, s.
    patience: f64,
}

/// Time between tries to plan with new overrides, s.
const PATIENCE_S: f64 = 0.02;

impl Motion {
    /// A planner for `machine` whose axes stand at `start`. All memory is taken here.
    pub fn new(machine: &Machine, start: Position) -> Motion {
        let limits = Limits::new(machine);
        let period = machine.servo_period_ms / 1000.0;
        let rules = JointRules::new(machine);
        Motion {
            period,
            assembler: Assembler::new(Inverses::new(&limits), rules, start),
            queue: Queue::new(),
            plan: Plan::new(),
            interpolator: Interpolator::new(limits, start),
            hold: false,
            aborting: false,
            runs: false,
            stopping: false,
            stale: false,
            outdated: false,
            patience: 0.0,
        }
    }

    /// How many lines can be pushed now; 0 is full. An arc of many turns may fill what is free alone, so ask
    /// before every push. During an abort it is 0.
    pub fn free(&self) -> usize {
        if self.assembler.is_blocked() || self.aborting {
            return 0;
        }
        (self.queue.room() / CELLS_A_MOVE).min(self.queue.mark_room())
    }

    /// Takes a move, which begins where the one before it ends. A move that goes nowhere is taken and
    /// forgotten.
    pub fn push(&mut self, m: &Move) -> Result<(), Full> {
        if self.free() == 0 {
            return Err(Full);
        }
        self.assembler.push(m, &mut self.queue);
        if self.plan.is_due(&self.queue) {
            self.plan_on();
        }
        Ok(())
    }

    /// Nothing follows for now: what is there is run to rest on its end.
    pub fn finish(&mut self) {
        self.assembler.close(&mut self.queue);
    }

    /// Plans what is new, unless the path is being stopped.
    fn plan_on(&mut self) {
        if !self.stopping && !self.stale {
            self.plan.plan(&self.queue, self.interpolator.s());
        }
    }

    /// Feed override 0…2 and rapid override 0…1 as factors; clamped, and left as they are if not a
    /// number. Both take effect at once, within the limits, or as soon as a plan is possible with them.
    pub fn set_override(&mut self, feed: f64, rapid: f64) {
        let old = self.plan.overrides();
        let clamp = |new: f64, max: f64, old: f64| if new.is_nan() { old } else { new.clamp(0.0, max) };
        let new =
            Overrides { feed: clamp(feed, MAX_FEED_OVERRIDE, old.feed), rapid: clamp(rapid, 1.0, old.rapid) };
        if new == old {
            return;
        }
        self.plan.set_overrides(new);
        if !self.runs {
            self.stale = true;
        } else {
            self.outdated = true;
        }
        if self.outdated && !self.stopping && !self.is_stopping() {
            self.renew();
        }
    }

    /// Plans with the new overrides, now or as soon as it is possible.
    fn renew(&mut self) {
        self.patience = PATIENCE_S;
        self.outdated = !self.plan.renew(&self.queue, self.interpolator.t());
        self.interpolator.renewed(&self.plan);
    }

    /// Feed hold: comes to rest on the path as soon as the limits allow; a corner that cannot be stopped before is
    /// passed. Tapping is run to its end first.
    pub fn hold(&mut self) {
        self.hold = true;
    }

    /// Ends feed hold. A stop under way is brought to its end first.
    pub fn resume(&mut self) {
        self.hold = false;
    }

    /// Comes to rest on the path as soon as the limits allow, tapping or not, and forgets the moves that
    /// are left. [`position`](Self::position), once at rest, is where the next move begins. Feed hold
    /// stays as it is.
    pub fn abort(&mut self) {
        self.aborting = true;
        if self.at_rest() && !self.runs {
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
        // After an abort what is planned ends at rest, wherever no stop was found before.
        if !self.aborting {
            self.assembler.run(&mut self.queue);
        }
        if !self.runs && self.may_begin() {
            self.begin();
        }
        if self.runs {
            self.advance();
        }
        if self.aborting && !self.runs {
            self.forget();
        }
        self.setpoint()
    }

    fn begin(&mut self) {
        if self.stale {
            self.plan.clear(&self.queue);
            self.stale = false;
        }
        self.plan.plan(&self.queue, self.interpolator.s());
        self.interpolator.enter();
        self.runs = true;
        self.stopping = false;
    }

    /// Runs through as many stretches as end in this period.
    fn advance(&mut self) {
        let mut time = self.period;
        self.patience -= time;
        loop {
            if !self.stopping && self.is_stopping() {
                self.stopping = self.interpolator.stop(&mut self.plan, &self.queue);
            }
            if !self.stopping && self.plan.is_short(&self.queue) {
                self.plan.plan(&self.queue, self.interpolator.s());
            }
            match self.interpolator.advance(&mut self.plan, &mut self.queue, time) {
                (Outcome::Moves, left) if left > 0.0 => {
                    time = left;
                    // What was not possible inside a stretch may be behind it.
                    if self.outdated && self.patience <= 0.0 && !self.stopping && !self.is_stopping() {
                        self.renew();
                    }
                }
                (Outcome::Moves, _) => return,
                // The remainder of the period is spent at rest, so that one setpoint is the programmed
                // point.
                (Outcome::Rests, _) => {
                    if self.stopping || self.is_stopping() || self.is_empty() {
                        self.pause();
                    }
                    return;
                }
                (Outcome::Out, _) => return self.pause(),
            }
        }
    }

    /// At rest; what follows is planned when it begins.
    fn pause(&mut self) {
        self.runs = false;
        self.stopping = false;
        self.stale = true;
        self.outdated = false;
    }

    fn may_begin(&self) -> bool {
        let known = self.queue.has_rest() || (self.queue.len() > 0 && self.free() == 0 && !self.aborting);
        known && !self.hold && !self.aborting && !self.is_stopping()
    }

    /// Whether the path is to be brought to a stop.
    fn is_stopping(&self) -> bool {
        if self.queue.len() == 0 {
            return self.aborting;
        }
        let class = self.queue.node(self.queue.head()).class;
        let held = self.hold || self.plan.overrides().of(class) == 0.0;
        self.aborting || (held && class != Class::Locked)
    }

    fn forget(&mut self) {
        self.queue.clear();
        self.plan.clear(&self.queue);
        self.interpolator.clear();
        self.assembler.clear(self.interpolator.position());
        self.aborting = false;
        self.runs = false;
        self.stopping = false;
        self.stale = false;
    }

    fn setpoint(&self) -> Setpoint {
        let state = match (self.is_empty(), self.at_rest()) {
            (true, _) => State::Idle,
            (_, true) if self.hold => State::Held,
            (_, false) if self.hold || self.aborting => State::Holding,
            _ if self.runs || (self.queue.len() > 0 && self.plan.overrides().of(self.class()) == 0.0) => {
                State::Running
            }
            _ if self.may_begin() => State::Running,
            _ => State::Waiting,
        };
        Setpoint {
            position: self.position(),
            velocity: self.interpolator.speed(),
            tag: self.interpolator.tag(),
            state,
        }
    }

    fn class(&self) -> Class {
        self.queue.node(self.queue.head()).class
    }

    /// How many lines fit into an empty planner.
    pub const CAPACITY: usize = CELLS / CELLS_A_MOVE;
}
