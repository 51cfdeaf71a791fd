//! Planner and interpolator together: moves in, a setpoint every servo period out.

use crate::handover::pair;
use crate::interpolator::Interpolator;
use crate::moves::Move;
use crate::planner::Planner;
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

/// A queue of moves run as one motion within the limits of every axis: planner and interpolator in one thread, the
/// planner called before every period. [`Motion::halves`] gives them to two threads, with the same setpoints.
///
/// **When a run begins.** A run is a chain of moves that is not at rest between them. It begins when its
/// end is known (a corner, an exact stop, a change between positioning and cutting,
/// [`finish`](Self::finish)) or when the queue is full. Until then the state is [`State::Waiting`]. A
/// caller that fills up before every tick thus gets the same setpoints whatever the rhythm of its own
/// input.
///
/// **When something takes over.** An override, a feed hold and an abort take over [`LEAD_S`](crate::LEAD_S) after they are
/// asked for; a run from rest begins with the next period.
///
/// **When moves fail to come.** What was pushed is always planned to rest, so a run that is not fed comes to
/// rest on the path, before the joint that is not known yet, and goes on as a run that begins.
#[derive(Debug)]
pub struct Motion {
    planner: Planner,
    interpolator: Interpolator,
}

impl Motion {
    /// Motion of `machine` whose axes stand at `start`. All memory is taken here.
    pub fn new(machine: &Machine, start: Position) -> Motion {
        let (planner, interpolator) = Motion::halves(machine, start);
        Motion { planner, interpolator }
    }

    /// The two halves, for a thread each: the planner fills the interpolator, which runs in the servo period.
    pub fn halves(machine: &Machine, start: Position) -> (Planner, Interpolator) {
        let (sender, receiver) = pair();
        (Planner::new(machine, start, sender), Interpolator::new(machine, start, receiver))
    }

    /// How many lines can be pushed now; 0 is full. An arc of many turns may fill what is free alone, so ask
    /// before every push. During an abort it is 0.
    pub fn free(&self) -> usize {
        self.planner.free()
    }

    /// Takes a move, which begins where the one before it ends. A move that goes nowhere is taken and
    /// forgotten.
    pub fn push(&mut self, m: &Move) -> Result<(), Full> {
        self.planner.push(m)
    }

    /// Nothing follows for now: what is there is run to rest on its end.
    pub fn finish(&mut self) {
        self.planner.finish();
    }

    /// Feed override 0…2 and rapid override 0…1 as factors; clamped, and left as they are if not a
    /// number. Both take effect within the limits, or as soon as a plan is possible with them.
    pub fn set_override(&mut self, feed: f64, rapid: f64) {
        self.planner.set_override(feed, rapid);
    }

    /// Speed that no axis exceeds in positioning, mm/s or degrees/s ([`Planner::set_rapid_speed`]).
    pub fn set_rapid_speed(&mut self, speed: f64) {
        self.planner.set_rapid_speed(speed);
    }

    /// Speed of the spindle, r/min, which feeds per revolution follow ([`Planner::set_spindle`]).
    pub fn set_spindle(&mut self, rpm: f64) {
        self.planner.set_spindle(rpm);
    }

    /// Feed hold: comes to rest on the path as soon as the limits allow; a corner that cannot be stopped before is
    /// passed. Tapping is run to its end first.
    pub fn hold(&mut self) {
        self.planner.hold();
    }

    /// Ends feed hold. A stop under way is brought to its end first.
    pub fn resume(&mut self) {
        self.planner.resume();
    }

    /// From now on the path is run back (`true`), or forward again; whether it is: only at rest, see
    /// [`Planner::retrace`].
    pub fn retrace(&mut self, back: bool) -> bool {
        self.planner.retrace(back)
    }

    /// What was passed up to here is not run back over.
    pub fn forget_passed(&mut self) {
        self.planner.forget_passed();
    }

    /// Whether the path is run back.
    pub fn is_back(&self) -> bool {
        self.planner.is_back()
    }

    /// Comes to rest on the path as soon as the limits allow, tapping or not, and forgets the moves that
    /// are left. [`position`](Self::position), once [still](Self::is_still), is where the next move begins. Feed hold
    /// stays as it is.
    pub fn abort(&mut self) {
        self.planner.abort();
    }

    /// Calls the place where the axes stand by another position. Only at rest, with every move run to its end;
    /// else nothing changes.
    pub fn rename(&mut self, at: Position) {
        if self.planner.rename(at) {
            self.interpolator.rename(at);
        }
    }

    /// Where the axes are commanded to be.
    pub fn position(&self) -> Position {
        self.interpolator.sample().position
    }

    /// Whether the axes stand still now; they may be about to move.
    pub fn at_rest(&self) -> bool {
        self.interpolator.at_rest()
    }

    /// Whether the axes stand still and nothing that was begun will move them.
    pub fn is_still(&self) -> bool {
        self.planner.is_still()
    }

    /// Whether every move pushed has been run to its end.
    pub fn is_empty(&self) -> bool {
        self.planner.is_empty()
    }

    /// Goes on by one servo period: plans, then moves.
    pub fn tick(&mut self) -> Setpoint {
        self.plan();
        self.step()
    }

    /// The planner's part of the next period; it takes as long as it takes.
    pub fn plan(&mut self) {
        while self.planner.is_due() {
            self.planner.tick();
        }
    }

    /// The part of the period that runs in it.
    pub fn step(&mut self) -> Setpoint {
        let sample = self.interpolator.tick();
        Setpoint {
            position: sample.position,
            velocity: sample.velocity,
            tag: sample.tag,
            state: self.planner.state(),
        }
    }
}
