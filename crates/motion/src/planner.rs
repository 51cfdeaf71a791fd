//! The planner: moves in, stretches of motion out, some periods ahead of the axes.
//!
//! Planning takes as long as it takes: microseconds for a line, milliseconds for a thousand short blocks under a new
//! override. So it has no place in the servo period. The planner goes through the periods like the interpolator does,
//! along the same stretches by the same code ([`crate::timing::interpolate`]), but **ahead** of it by the
//! [lead](LEAD_S). Whatever is asked for now (a hold, an override, more path) is planned from the state at that front,
//! and takes over there, exactly. As nothing depends on when in between the planner came to it, a run on a real clock
//! and one on a virtual clock give the same setpoints, bit by bit.
//!
//! **At rest** it is ahead of nothing: once the axes stand and nothing is known that could be run, it waits until they
//! have come as far as it has. So what is asked for then begins with their next period, and the lead is taken as the
//! run begins.
//!
//! **Too late.** If the period has begun before its change is ready, the gate ([`crate::handover`]) refuses it, the
//! plan before is brought back, and the planner goes on from what runs: with twice the lead, until a change is in time
//! again, and with the half of it to spare for the next. Every such period is counted ([`Planner::late`]).
//!
//! **Always to rest.** What the interpolator has been given ends at rest within all limits, whatever becomes of the
//! planner.

use crate::assemble::{Assembler, CELLS_A_MOVE};
use crate::handover::{Course, Sender, Strip};
use crate::limits::{Class, Inverses, Limits, MAX_FEED_OVERRIDE};
use crate::motion::{Full, State};
use crate::moves::Move;
use crate::path::joint::JointRules;
use crate::path::shape::Shape;
use crate::retrace::Tape;
use crate::timing::interpolate::{Outcome, Track, Walk};
use crate::timing::overrides::Overrides;
use crate::timing::plan::{Plan, STOPPING, STRETCHES, Stretch};
use crate::timing::queue::Queue;
use ferrocut_geometry::Position;
use ferrocut_machine::Machine;

/// How far the planner is ahead, s: what a feed hold takes to begin, far below what an operator notices, and time
/// enough to plan some hundred blocks.
pub const LEAD_S: f64 = 0.008;

/// Most periods that it may be ahead after having been late.
const LONGEST_LEAD: u64 = 512;

/// Most changes of the plan a period.
const CHANGES_A_PERIOD: u32 = 4;

/// Time between tries to plan with new overrides, s.
const PATIENCE_S: f64 = 0.02;

/// The planner's half of motion.
///
/// It may be called in any thread; calls may take some milliseconds. A caller fills it up ([`push`](Self::push),
/// [`finish`](Self::finish)) before every [`tick`](Self::tick), and ticks while [`is_due`](Self::is_due).
#[derive(Debug)]
pub struct Planner {
    period: f64,
    limits: Limits,
    assembler: Assembler,
    queue: Queue,
    tape: Tape,
    plan: Plan,
    walk: Walk,
    sender: Sender,
    hold: bool,
    aborting: bool,
    /// The plan is being run.
    runs: bool,
    /// The plan ends with a stop on the path.
    stopping: bool,
    /// The overrides have changed since the plan was made.
    outdated: bool,
    /// Time until the next try to plan with them, s.
    patience: f64,
    /// The period that is gone through next.
    front: u64,
    /// How many periods it is ahead, and how many it is where it is in time.
    lead: u64,
    least_lead: u64,
    /// Whether what this period changes can be ready before it begins, and before which period nothing is tried.
    decides: bool,
    hopeless_to: u64,
    changes: u32,
    late: u64,
    /// The periods before these have moves, move the axes, or are of an abort.
    busy_to: u64,
    moves_to: u64,
    aborts_to: u64,
}

/// The plan as it is walked along.
struct Ahead<'a> {
    plan: &'a mut Plan,
    queue: &'a mut Queue,
}

impl Track for Ahead<'_> {
    fn stretch(&mut self) -> Option<Stretch> {
        self.plan.current().copied()
    }

    fn go_on(&mut self) {
        self.plan.advance();
    }

    fn pass(&mut self, s: f64) -> u64 {
        let queue = &mut self.queue;
        while queue.len() > 1 && queue.node(queue.head()).end() < s && !queue.node(queue.head()).rests {
            queue.retire();
        }
        queue.head()
    }

    fn pass_to(&mut self, cell: u64) {
        while self.queue.head() < cell && self.queue.len() > 0 {
            self.queue.retire();
        }
    }

    fn cell<R>(&mut self, number: u64, look: impl FnOnce(&Strip) -> R) -> Option<R> {
        Some(look(&Strip::new(self.queue.node(number), self.queue.cell(number))))
    }
}

impl Planner {
    /// A planner for `machine` whose axes stand at `start`. All memory is taken here.
    pub(crate) fn new(machine: &Machine, start: Position, sender: Sender) -> Planner {
        let limits = Limits::new(machine);
        let period = machine.servo_period_ms / 1000.0;
        let rules = JointRules::new(machine);
        // What a quotient is above a whole number by rounding is no further period.
        let lead = ((LEAD_S / period - 1e-9).ceil().max(1.0) as u64).min(LONGEST_LEAD);
        Planner {
            period,
            plan: Plan::new(Inverses::new(&limits), rules.feeds[0]),
            assembler: Assembler::new(Inverses::new(&limits), rules, start),
            limits,
            queue: Queue::new(),
            tape: Tape::new(),
            walk: Walk::new(start),
            sender,
            hold: false,
            aborting: false,
            runs: false,
            stopping: false,
            outdated: false,
            patience: 0.0,
            front: 0,
            lead,
            least_lead: lead,
            decides: false,
            hopeless_to: 0,
            changes: 0,
            late: 0,
            busy_to: 0,
            moves_to: 0,
            aborts_to: 0,
        }
    }

    /// How many lines can be pushed now; 0 is full. An arc of many turns may fill what is free alone, so ask
    /// before every push. During an abort and on the way back it is 0.
    pub fn free(&self) -> usize {
        if self.assembler.is_blocked() || self.aborting || self.tape.is_back() {
            return 0;
        }
        (self.queue.room() / CELLS_A_MOVE).min(self.queue.mark_room().saturating_sub(self.assembler.marks()))
    }

    /// Takes a move, which begins where the one before it ends. A move that goes nowhere is taken and
    /// forgotten.
    pub fn push(&mut self, m: &Move) -> Result<(), Full> {
        if self.free() == 0 {
            return Err(Full);
        }
        self.assembler.push(m, &mut self.queue);
        Ok(())
    }

    /// Nothing follows for now: what is there is run to rest on its end.
    pub fn finish(&mut self) {
        if self.tape.is_back() {
            self.assembler.close_later();
        } else {
            self.assembler.close(&mut self.queue);
        }
    }

    /// From now on the path is run back (`true`), or forward again; whether it is. Only at rest, which is what
    /// [`hold`](Self::hold) is for, and back only where something was passed that is still known and may be run back.
    ///
    /// Back is within all limits, with overrides, holds and tolerances as ever, through the same points on which the
    /// path rests; at the end of what is known it rests too. Forward goes on with the program from there. No move is
    /// taken meanwhile.
    pub fn retrace(&mut self, back: bool) -> bool {
        if back == self.tape.is_back() {
            return true;
        }
        if !self.is_still() || self.aborting {
            return false;
        }
        let (s, position) = (self.walk.s(), self.walk.position());
        let s = if back {
            self.tape.turn_back(&mut self.queue, s, &position)
        } else {
            Some(self.tape.turn_forward(&mut self.queue, s, &position))
        };
        self.plan.clear(&self.queue);
        if let Some(s) = s {
            self.walk.set_s(s);
        }
        s.is_some()
    }

    /// What was passed up to here is not run back over: something else was done in this place. Where every move is run to its end
    /// lengths begin at 0 anew, so that a path is the same to the last bit whatever was run before it, and however much.
    pub fn forget_passed(&mut self) {
        if self.is_empty() && self.is_still() {
            self.forget();
        } else if !self.tape.is_back() {
            self.queue.forget_passed();
            self.tape.clear();
        }
    }

    /// Whether the path is run back.
    pub fn is_back(&self) -> bool {
        self.tape.is_back()
    }

    /// Whether the path was run back as far as it is known, and the axes stand there.
    pub fn is_at_back_end(&self) -> bool {
        self.is_back() && self.queue.len() == 0 && self.is_still()
    }

    /// Feed override 0…2 and rapid override 0…1 as factors; clamped, and left as they are if not a
    /// number. Both take effect at the front, within the limits, or as soon as a plan is possible with them.
    pub fn set_override(&mut self, feed: f64, rapid: f64) {
        let old = self.plan.overrides();
        let clamp = |new: f64, max: f64, old: f64| if new.is_nan() { old } else { new.clamp(0.0, max) };
        let (feed, rapid) = (clamp(feed, MAX_FEED_OVERRIDE, old.feed), clamp(rapid, 1.0, old.rapid));
        self.override_by(Overrides { feed, rapid, ..old });
    }

    /// Speed that no axis exceeds in positioning, mm/s or degrees/s, besides the rapid override: the lowest step of an
    /// override that is a speed and no share. Takes effect as the overrides do; left as it is if it is none.
    pub fn set_rapid_speed(&mut self, speed: f64) {
        if speed > 0.0 {
            self.override_by(Overrides { rapid_speed: speed, ..self.plan.overrides() });
        }
    }

    fn override_by(&mut self, new: Overrides) {
        if new != self.plan.overrides() {
            self.plan.set_overrides(new);
            self.outdated = self.runs;
            self.patience = 0.0;
        }
    }

    /// Speed of the spindle, r/min, which feeds per revolution follow, those of moves that were pushed too: like an
    /// override of [`MAX_SPINDLE_OVERRIDE`](crate::MAX_SPINDLE_OVERRIDE) times the speed that they were made with at
    /// most. At 0 the path comes to rest before them. Until it is told they are as they were made.
    pub fn set_spindle(&mut self, rpm: f64) {
        let old = self.plan.overrides();
        if !(rpm >= 0.0) || old.rpm == Some(rpm) {
            return;
        }
        self.plan.set_overrides(Overrides { rpm: Some(rpm), ..old });
        let mut known = self.queue.head()..self.queue.tail();
        if self.runs && known.any(|cell| self.queue.node(cell).follows_spindle()) {
            self.outdated = true;
            self.patience = 0.0;
        }
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
    /// are left. Where the axes come to rest is where the next move begins. Feed hold stays as it is.
    pub fn abort(&mut self) {
        self.aborting = true;
        if !self.runs {
            self.forget();
        }
    }

    /// Calls the place where the axes stand by another position; whether it did: only at rest, with every move run to
    /// its end. The interpolator is to be told too, before the next move is pushed.
    pub fn rename(&mut self, at: Position) -> bool {
        let can = self.is_empty() && self.is_still() && at.is_finite();
        if can {
            self.walk.rename(at);
            self.forget();
        }
        can
    }

    /// Whether every move pushed has been run to its end, by the axes too.
    pub fn is_empty(&self) -> bool {
        self.has_nothing() && self.sender.gate.done() >= self.busy_to
    }

    /// Whether the axes stand still and nothing that was begun will move them.
    pub fn is_still(&self) -> bool {
        !self.runs && self.sender.gate.done() >= self.moves_to
    }

    /// What the axes are doing.
    pub fn state(&self) -> State {
        if self.is_empty() {
            return State::Idle;
        }
        match self.is_still() {
            true if self.hold => State::Held,
            false if self.hold || self.aborting || self.sender.gate.done() < self.aborts_to => State::Holding,
            false => State::Running,
            true if self.queue.len() > 0 && self.share() == 0.0 => State::Running,
            true if self.may_begin() => State::Running,
            true => State::Waiting,
        }
    }

    /// How many periods could not be decided before they began, all in all: what ran went on in them, or a run began
    /// later.
    pub fn late(&self) -> u64 {
        self.late
    }

    /// Number of the period that is decided next: what is asked for now takes over there. Periods are counted by the
    /// interpolator from 0.
    pub fn front(&self) -> u64 {
        self.front
    }

    /// Whether a period is to be gone through.
    pub fn is_due(&self) -> bool {
        let lead = if self.runs || self.may_begin() { self.lead } else { 0 };
        self.front <= self.sender.gate.begun() + lead
    }

    /// Goes on by one servo period, and hands over what changes with it.
    pub fn tick(&mut self) {
        self.changes = 0;
        self.decides = self.front >= self.sender.gate.begun().max(self.hopeless_to);
        let was_busy = !self.has_nothing();
        if !self.decides && self.runs {
            self.late += 1;
        }
        // After an abort what is planned ends at rest, wherever no stop was found before.
        if !self.aborting && !self.tape.is_back() {
            self.assembler.run(&mut self.queue);
            // Where no more can be taken and nothing is left to be run, what there is ends here: nothing else would go on.
            if self.queue.len() == 0 && self.free() == 0 && !self.assembler.is_blocked() {
                self.assembler.close(&mut self.queue);
            }
        }
        if !self.runs && self.may_begin() {
            self.begin();
        }
        let next = self.front + 1;
        if self.aborting {
            self.aborts_to = next;
        }
        if self.runs {
            self.moves_to = next;
            self.advance();
        }
        if self.aborting && !self.runs {
            self.forget();
        }
        if was_busy || !self.has_nothing() {
            self.busy_to = next;
        }
        self.front = next;
    }

    /// Whether every move is behind the front.
    fn has_nothing(&self) -> bool {
        self.queue.len() == 0 && self.assembler.is_empty() && !self.tape.is_back()
    }

    fn begin(&mut self) {
        if !self.can_change(STRETCHES) {
            return;
        }
        self.plan.clear(&self.queue);
        self.walk.enter();
        if let Some(number) = self.plan.plan(&self.queue, self.walk.s()) {
            if self.hand_over(Some(number), true, false) {
                (self.runs, self.stopping, self.outdated) = (true, false, false);
            } else {
                self.plan.undo();
            }
        }
    }

    /// Runs through as many stretches as end in this period.
    fn advance(&mut self) {
        let mut time = self.period;
        self.patience -= time;
        self.renew_if_outdated();
        if self.plan.is_due(&self.queue) {
            self.plan_on();
        }
        loop {
            if !self.stopping && self.is_stopping() {
                self.stop();
            }
            if self.plan.is_short(&self.queue) {
                self.plan_on();
            }
            if !self.begin_axes() {
                return;
            }
            let mut ahead = Ahead { plan: &mut self.plan, queue: &mut self.queue };
            let outcome = self.walk.advance(&mut ahead, time);
            if let Some(s) = self.walk.mark() {
                self.queue.pass_marks(s);
            }
            match outcome {
                (Outcome::Moves, left) if left > 0.0 => {
                    time = left;
                    // What was not possible inside a stretch may be behind it.
                    self.renew_if_outdated();
                }
                (Outcome::Moves, _) => return,
                // The remainder of the period is spent at rest, so that one setpoint is the programmed
                // point.
                (Outcome::Rests, _) => {
                    if self.stopping || self.is_stopping() || self.has_nothing() {
                        self.pause();
                    }
                    return;
                }
                (Outcome::Out, _) => return self.pause(),
            }
        }
    }

    /// A move of every axis on its own that comes now is begun; `false` if it cannot be yet.
    fn begin_axes(&mut self) -> bool {
        let Some(Stretch::Axes { cell, .. }) = self.plan.current().copied() else { return true };
        if self.walk.axes.is_under_way() {
            return true;
        }
        let Shape::Axes { to, .. } = self.queue.cell(cell).shape else { return true };
        if self.stopping || self.is_stopping() {
            // The interpolator stands before it until it is begun.
            self.pause();
            return false;
        }
        self.look();
        // From where it is: it may have been stopped on the way.
        let speeds = self.plan.overrides().rapid_speeds(&self.limits);
        let before = self.walk.axes;
        self.walk.axes.begin(self.walk.position(), to, &self.limits.positioning, &speeds);
        if self.can_change(0) && self.hand_over(None, false, true) {
            return true;
        }
        self.walk.axes = before;
        false
    }

    /// Plans what is new, unless the path is being stopped.
    fn plan_on(&mut self) {
        if self.stopping || !self.can_change(STRETCHES) {
            return;
        }
        if let Some(number) = self.plan.plan(&self.queue, self.walk.s())
            && !self.hand_over(Some(number), false, false)
        {
            self.plan.undo();
        }
    }

    /// Plans with the new overrides, now or as soon as it is possible.
    fn renew_if_outdated(&mut self) {
        let may = self.outdated && self.patience <= 0.0 && !self.stopping && !self.is_stopping();
        if !may || !self.can_change(STRETCHES) {
            return;
        }
        let number = self.plan.renew(&self.queue, self.walk.t());
        let before = self.walk.axes;
        let is_apart = before.is_under_way();
        if is_apart {
            self.walk.axes.set_speeds(&self.plan.overrides().rapid_speeds(&self.limits));
        }
        if (number.is_none() && !is_apart) || self.hand_over(number, false, is_apart) {
            self.outdated = number.is_none();
            self.patience = PATIENCE_S;
        } else {
            self.walk.axes = before;
            if number.is_some() {
                self.plan.undo();
            }
        }
    }

    /// Brings the path to rest.
    fn stop(&mut self) {
        if !self.can_change(STOPPING) {
            return;
        }
        if self.walk.axes.is_under_way() {
            let before = self.walk.axes;
            self.walk.axes.stop();
            self.stopping = self.hand_over(None, false, true);
            if !self.stopping {
                self.walk.axes = before;
            }
        } else if let Some(number) =
            self.plan.stop(&self.queue, self.walk.t(), self.aborting || self.lacks_spindle())
        {
            self.stopping = self.hand_over(Some(number), false, false);
            if !self.stopping {
                self.plan.undo();
            }
        }
    }

    /// At rest; what follows is planned when it begins.
    fn pause(&mut self) {
        // The interpolator stands still by itself at the end, and before a move of every axis on its own.
        if !matches!(self.plan.current(), None | Some(Stretch::Axes { .. })) {
            if !self.can_change(0) {
                return;
            }
            self.plan.end_here();
            if !self.hand_over(Some(self.plan.number()), false, false) {
                return self.plan.undo();
            }
        }
        self.look();
        self.runs = false;
        self.stopping = false;
        self.outdated = false;
    }

    /// Works out where the axes are at the front.
    fn look(&mut self) {
        self.walk.look(&mut Ahead { plan: &mut self.plan, queue: &mut self.queue });
    }

    /// Whether the plan may be changed in this period, by this many stretches at most.
    fn can_change(&self, stretches: usize) -> bool {
        let [cells, marks] = self.queue.to_hand();
        self.decides && self.changes < CHANGES_A_PERIOD && self.sender.has_room(stretches, cells, marks)
    }

    /// Hands over the stretches from `number` on, and the move of every axis on its own as it is now. `false` if it
    /// is too late; then nothing is another.
    fn hand_over(&mut self, number: Option<u64>, begins: bool, axes: bool) -> bool {
        self.changes += 1;
        let (sender, period) = (&mut self.sender, self.front);
        let mut is_sent = true;
        if let Some(number) = number {
            is_sent = self.queue.hand_cells(|node, cell| sender.cell(node, cell))
                && self.queue.hand_marks(|marks| sender.marks(marks));
            let course = Course::new(number, self.queue.head(), self.queue.first_mark(), begins);
            is_sent = is_sent && sender.course(period, course, self.plan.from(number));
        }
        if axes {
            is_sent = is_sent && sender.axes(period, &self.walk.axes);
        }
        if is_sent && sender.settle(period) {
            self.lead = self.least_lead;
            return true;
        }
        self.decides = false;
        self.late += 1;
        self.lead = (2 * self.lead).min(LONGEST_LEAD);
        // As soon again would be too late again.
        self.hopeless_to = self.sender.gate.begun() + self.lead / 2;
        false
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
        let held = self.hold || self.share() == 0.0;
        let is_thread = self.queue.node(self.queue.head()).class == Class::Locked;
        self.aborting || self.lacks_spindle() || (held && !is_thread)
    }

    /// Whether the spindle stands that feeds the path: then nothing goes on, in a thread neither.
    fn lacks_spindle(&self) -> bool {
        self.queue.node(self.queue.head()).follows_spindle() && self.plan.overrides().rpm == Some(0.0)
    }

    /// The factor of the programmed speed where the path is.
    fn share(&self) -> f64 {
        self.plan.overrides().share(self.queue.node(self.queue.head()))
    }

    fn forget(&mut self) {
        self.queue.clear();
        self.tape.clear();
        self.plan.clear(&self.queue);
        self.walk.clear();
        self.assembler.clear(self.walk.position());
        self.aborting = false;
        self.runs = false;
        self.stopping = false;
        self.outdated = false;
    }
}
