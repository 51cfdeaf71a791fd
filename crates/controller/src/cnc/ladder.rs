//! The control with a ladder: what is handed to it, and what waits for it.

use super::tapping::ThreadKind;
use super::{Cnc, Given, State, Tick};
use crate::auxiliary::{Auxiliary, Handing, Now};
use crate::report::Activity;
use crate::signals::{Inputs, Outputs};
use ferrocut_machine::{Alarm, Fault, Machine};
use ferrocut_motion::servo::Kind;
use ferrocut_toolpath::{Op, Step};

/// Shares of the spindle speed that feeds of moves are given for, between which they are given for the same still. Motion
/// follows the spindle up to that much above twice the speed.
const SAME: [f64; 2] = [0.5, 1.2];

/// Share of a spindle speed by which it may change without a feed per revolution following.
const UNNOTICED: f64 = 0.005;

impl Cnc {
    /// From now on codes go to a ladder, and the spindle does what it says: [`hear`](Cnc::hear) before each period,
    /// [`tell`](Cnc::tell) behind it. `machine` is the one that the control was made for.
    pub fn connect_ladder(&mut self, machine: &Machine) {
        let mut machine = machine.clone();
        let memory = self.interpreter.memory();
        (self.interpreter.dialect().machine_parameters)(&memory.parameters, &mut machine);
        self.auxiliary = Some(Box::new(Auxiliary::new(&machine)));
        self.fit_interpreter();
    }

    /// What the ladder says of codes and spindle in the period that comes.
    pub fn hear(&mut self, inputs: &Inputs) {
        // GSK990MC 4.4.5: as at 100 %.
        let ignores_override = self.is_in(ThreadKind::Beside);
        self.taking_up.told_tool = inputs.tool_in_spindle;
        if let Some(auxiliary) = &mut self.auxiliary {
            self.interpreter.set_auxiliary_lock(inputs.auxiliary_lock);
            auxiliary.hear(inputs, self.interpreter.is_auxiliary_locked());
            if ignores_override {
                auxiliary.ignore_spindle_override();
            }
        }
    }

    /// Tells the ladder of codes, spindle and moves; what else it is told is left as it is.
    pub fn tell(&self, outputs: &mut Outputs) {
        let Some(auxiliary) = &self.auxiliary else { return };
        auxiliary.tell(&self.spindle, self.servo.is_at_rest(), outputs);
        // One that follows no angles is nowhere, whatever is simulated of it.
        outputs.spindle_oriented &= self.drives.leads_spindle();
        outputs.macro_outputs = self.program_outputs.word();
        let moves = !self.motion.at_rest();
        let kind = self.given.front().map(Given::kind).filter(|_| moves);
        (outputs.rapid, outputs.cutting) = (kind == Some(Kind::Rapid), kind == Some(Kind::Cutting));
        outputs.threading = self.stroke.is_some_and(|stroke| stroke.has_begun);
        outputs.tapping = self.thread.is_some();
        // Moves of the block are done, its codes are not.
        outputs.distribution_end = auxiliary.handed().is_some() && !moves && self.motion.is_empty();
    }

    /// Whether the ladder has not yet finished what was handed to it.
    pub fn waits_for_ladder(&self) -> bool {
        self.auxiliary.as_ref().is_some_and(|auxiliary| auxiliary.handed().is_some())
    }

    /// Whether a program runs of which the ladder has the end, M02 or M30.
    pub fn is_ending(&self) -> bool {
        let handed = self.auxiliary.as_ref().and_then(|auxiliary| auxiliary.handed());
        self.state == State::Running && handed.is_some_and(|step| matches!(step.op, Op::End(_)))
    }

    /// Codes and spindle, where there is a ladder.
    pub(super) fn serve_ladder(&mut self) {
        let is_in_step = self.is_in(ThreadKind::InStep);
        let is_under_way = self.is_under_way();
        let Some(auxiliary) = &mut self.auxiliary else { return };
        let positions = self.given.front().filter(|given| given.kind() == Kind::Rapid);
        let now = Now {
            at: if self.manual.is_active { self.actual } else { self.motion.position() },
            rapid_to: positions.filter(|_| !self.motion.at_rest()).map(|given| given.to),
            taps: is_in_step || self.stroke.is_some(),
        };
        if auxiliary.tick(&now, &mut self.spindle) {
            let alarm = Alarm::core(Fault::CodeNotFinished, self.span);
            let alarm = alarm.with("word", auxiliary.codes().word());
            self.come_to_rest();
            self.failed = Some(Box::new(alarm));
        } else if !is_under_way {
            // S that a person set: no program waits for it.
            let _ = auxiliary.take_done();
        }
    }

    /// A period in which nothing is done but what was handed to the ladder.
    pub(super) fn wait_for_ladder(&mut self) -> Tick {
        let handed = self.auxiliary.as_ref().and_then(|auxiliary| auxiliary.handed());
        self.report.period(match handed.map(|step| &step.op) {
            Some(Op::Spindle(_) | Op::Orient(_)) => Activity::Spindle,
            Some(Op::Select(_) | Op::Change(_)) => Activity::ToolChange,
            _ => Activity::Dwell,
        });
        self.at_rest()
    }

    /// Whether the axes, at rest, are not to begin to cut yet.
    pub(super) fn cutting_waits(&self) -> bool {
        if !self.auxiliary.as_ref().is_some_and(|auxiliary| auxiliary.cutting_waits()) {
            return false;
        }
        let at = self.motion.position();
        // The first move may be run to its end already.
        let mut moves = self.given.iter().enumerate().filter(|(n, given)| *n > 0 || given.to != at);
        moves.next().is_some_and(|(_, given)| given.kind() == Kind::Cutting)
    }

    /// S that a person sets between programs (GSK990MC part 2, 3.1.2): the modal one from now on, handed to the ladder, and
    /// told to a spindle that turns. `false` where a program is under way, whose speed it is, or a code.
    pub fn set_spindle_speed(&mut self, s: f64) -> bool {
        if self.is_under_way() || self.waits_for_ladder() {
            return false;
        }
        let turning = self.interpreter.own().set_spindle_speed(s);
        if self.auxiliary.is_some() {
            self.hands_over_speed();
        } else if let Some(state) = turning {
            let at = self.motion.position();
            self.spindle.command(state, &at);
        }
        true
    }

    /// A program that ends hands over a speed that was not told to the spindle.
    pub(super) fn hands_over_speed(&mut self) -> bool {
        let speed = self.interpreter.spindle_speed();
        let step = Step::new(Op::Barrier, self.span, self.taking_up.at.0);
        self.auxiliary.as_mut().is_some_and(|auxiliary| auxiliary.hand_over_speed(speed, &step))
    }

    /// The next step; none while it has to wait for what was handed to the ladder.
    pub(super) fn next_from_ladder(&mut self) -> Option<Result<Step, Box<Alarm>>> {
        let kept = match &mut self.auxiliary {
            Some(auxiliary) if auxiliary.is_full() => return None,
            Some(auxiliary) => auxiliary.take_next(),
            None => None,
        };
        let next = match kept {
            Some(step) => Some(Ok(step)),
            None if self.touches.is_some() => self.next_of_touches(),
            None => match self.next_of_lead_in() {
                Some(step) => Some(Ok(step)),
                None => self.interpreter.next(self.blocks.is_single()),
            },
        };
        let waits = match (&next, &mut self.auxiliary) {
            (Some(Ok(step)), Some(auxiliary)) => auxiliary.keeps(step),
            _ => false,
        };
        if waits { None } else { next }
    }

    /// Speed of the spindle for a feed per revolution, r/min: under auxiliary lock the one it would have.
    pub(super) fn feed_rpm(&self) -> f64 {
        let locked = self.auxiliary.as_ref().and_then(|auxiliary| auxiliary.locked_rpm());
        locked.unwrap_or_else(|| self.spindle.rpm())
    }

    /// The speed that a feed per revolution is worked out with, r/min: without the override where it is known.
    pub(super) fn asked_rpm(&self) -> f64 {
        let is_locked = self.auxiliary.as_ref().is_some_and(|auxiliary| auxiliary.locked_rpm().is_some());
        let asked = self.spindle.asked().abs();
        if asked > 0.0 && !is_locked { asked } else { self.feed_rpm() }
    }

    /// The same for motion, which makes of it what the spindle has as it is run: one speed for moves that are given under
    /// different overrides, or beside a surface speed, so that short ones are alike and are run as one curve.
    pub(super) fn given_rpm(&mut self) -> f64 {
        let asked = self.asked_rpm();
        if asked < SAME[0] * self.given_rpm || asked > SAME[1] * self.given_rpm {
            self.given_rpm = asked;
        }
        self.given_rpm
    }

    /// Motion follows the spindle with feeds per revolution. Of changes that nobody notices nothing is planned again.
    pub(super) fn tell_motion_of_spindle(&mut self) {
        let rpm = self.feed_rpm();
        let change = (rpm - self.told_rpm).abs();
        if change == 0.0 || change <= UNNOTICED * rpm && !self.motion.is_empty() {
            return;
        }
        self.told_rpm = rpm;
        self.motion.set_spindle(rpm);
    }

    /// Hands a step to the ladder, if there is one and the step is for it.
    pub(super) fn is_for_ladder(&mut self, step: &Step) -> bool {
        let in_force = self.interpreter.spindle_speed();
        // A tool that is in a thread must come out of it: a reset takes the signal back meanwhile.
        let enters = matches!(step.op, Op::Tap { .. }) && !self.is_in(ThreadKind::InStep);
        let Some(auxiliary) = &mut self.auxiliary else { return false };
        match auxiliary.hand_over(step, in_force) {
            Handing::Nothing if enters && auxiliary.lacks_rigid_tapping() => {
                let rule = Fault::RigidTappingOff;
                let alarm = Alarm::new(self.interpreter.dialect().alarm_id(rule), rule, step.span);
                self.state = State::Alarmed(Box::new(alarm));
                true
            }
            Handing::Nothing => false,
            Handing::Begun | Handing::Done => true,
        }
    }
}
