//! Holes that are tapped and threads that are cut: strokes of axes and spindle in step.
//!
//! What the operator asks for waits until the tool is out (GSK990MC 4.5.1).

use super::{Cnc, Given, State, Tick};
use crate::programmed::{Programmed, Way};
use crate::report::Activity;
use crate::restart::own_alarm;
use ferrocut_geometry::Position;
use ferrocut_machine::{Alarm, Fault};
use ferrocut_motion::servo::Kind;
use ferrocut_motion::synchron::Thread;

/// A thread that the tool is in.
#[derive(Clone, Copy, Debug)]
pub(super) struct InThread {
    /// Where the tool entered it.
    pub entry: Position,
    pub kind: ThreadKind,
    /// The gear of the spindle that it was begun in: none is engaged while the tool is in it.
    pub gear: u8,
    /// Speed that the spindle is asked for again behind it, r/min, clockwise positive; 0 where it stays at rest.
    pub speed_behind: f64,
    /// What the operator asked for, which waits until the tool is out.
    pub asked: Option<Asked>,
}

impl InThread {
    /// One that the spindle cuts beside the axes, whatever its gear.
    fn beside(entry: Position) -> InThread {
        InThread { entry, kind: ThreadKind::Beside, gear: 1, speed_behind: 0.0, asked: None }
    }
}

/// How axes and spindle cut it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum ThreadKind {
    /// The axes follow the spindle: a rigid tap, a thread.
    InStep,
    /// Beside each other: a tap in a floating holder (GSK990MC 4.4.5), or G63.
    Beside,
}

/// A stroke in a hole.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stroke {
    pub from: Position,
    pub thread: Thread,
    pub programmed: Programmed,
    /// Whether the axes move already; else the spindle comes to rest first.
    pub has_begun: bool,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Asked {
    Hold,
    Reset,
}

impl Cnc {
    /// Looks whether the move being run is one of a thread that the spindle cuts beside.
    pub(super) fn follow_floating(&mut self, given: &Given) {
        match (self.thread.map(|thread| thread.kind), given.motion.is_tapping()) {
            // What is given up by a reset comes to rest, and cuts no thread any more.
            (None, true) if self.state == State::Running => {
                let entry = match given.programmed.way {
                    Way::Line(from, _) => from,
                    Way::Arc(arc) => arc.at(0.0),
                    Way::Apart => self.motion.position(),
                };
                self.thread = Some(InThread::beside(entry));
            }
            (Some(ThreadKind::Beside), false) => self.leave_thread(),
            _ => {}
        }
    }

    /// The axes stand where all moves end that were given: the tool is out of the thread where it entered it.
    pub(super) fn rest_floating(&mut self) {
        if self.is_in(ThreadKind::Beside)
            && self.thread.is_some_and(|thread| thread.entry == self.motion.position())
        {
            self.leave_thread();
        }
    }

    /// Whether the tool is in a thread of this kind.
    pub(super) fn is_in(&self, kind: ThreadKind) -> bool {
        self.thread.is_some_and(|thread| thread.kind == kind)
    }

    /// Whether a tap in a floating holder that is about to enter, the axes at rest, waits for the spindle: from here on
    /// that turns as at 100 % (4.4.5), and has its speed before the first turn in the work.
    pub(super) fn tap_waits(&mut self) -> bool {
        let at = self.motion.position();
        // The first move may be run to its end already.
        let mut moves = self.given.iter().enumerate().filter(|(n, given)| *n > 0 || given.to != at);
        if !moves.next().is_some_and(|(_, given)| given.motion.is_tapping()) {
            return false;
        }
        match self.thread {
            None => {
                self.thread = Some(InThread::beside(at));
                true
            }
            Some(thread) => thread.entry == at && !self.spindle.has_its_speed(),
        }
    }

    /// A hold that was asked for in a thread is not wanted any more.
    pub(super) fn forget_hold_behind_thread(&mut self) {
        if let Some(thread) = self.thread.as_mut().filter(|thread| thread.asked == Some(Asked::Hold)) {
            thread.asked = None;
        }
    }

    /// Whether what is asked for waits until the tool is out of the thread that it is in while the program runs; then
    /// it is remembered. A reset waits for one in step alone.
    pub(super) fn waits_in_thread(&mut self, asked: Asked) -> bool {
        let is_running = self.state == State::Running;
        let waits = |thread: &&mut InThread| {
            is_running && (asked == Asked::Hold || thread.kind == ThreadKind::InStep)
        };
        match self.thread.as_mut().filter(waits) {
            Some(thread) => {
                // A reset is more than a hold.
                if thread.asked != Some(Asked::Reset) {
                    thread.asked = Some(asked);
                }
                true
            }
            None => false,
        }
    }

    /// A move in step with the spindle. The first one of a thread begins with the spindle at rest on its marker, so
    /// that passes, and threads that are cut again, meet (GSK990MC 4.5.2). Behind the thread it `goes_on` as before, or
    /// stands still; where there is a ladder that is the ladder's matter.
    pub(super) fn begin_stroke(&mut self, to: Position, pitch: f64, rpm: f64, goes_on: bool) {
        let from = self.commanded;
        let way = to - from;
        // The sense of the way is that of the axis that goes farthest.
        let farthest = way.0.iter().fold(0.0, |far: f64, d| if d.abs() > far.abs() { *d } else { far });
        let is_first = !self.is_in(ThreadKind::InStep);
        if is_first {
            let alarm = self.supervisor.beside((from.min(to), from.max(to)), self.aside.shift, self.span);
            if let Some(alarm) = alarm {
                self.state = State::Alarmed(alarm);
                return;
            }
            let speed_behind = if goes_on && self.auxiliary.is_none() { self.spindle.asked() } else { 0.0 };
            let gear = self.gear(rpm);
            self.thread =
                Some(InThread { entry: from, kind: ThreadKind::InStep, gear, speed_behind, asked: None });
        }
        let entry = self.thread.map_or(from, |thread| thread.entry);
        let is_out = from.distance(entry) > to.distance(entry);
        let of_gear = self.spindle_config.tapping_in(self.thread.map_or(1, |thread| thread.gear));
        let [inwards, outwards] = of_gear.rpm_s;
        self.spindle.set_encoder(of_gear.encoder_counts);
        let thread = Thread {
            to,
            pitch: pitch.abs(),
            // The way out may be asked for at more than the gear has (GSK990MC 44#4, P283).
            rpm: if is_first { rpm } else { rpm.min(of_gear.max_rpm) },
            // A right-hand thread goes in clockwise, in the negative direction.
            is_clockwise: farthest * pitch < 0.0,
            acceleration_rpm_s: if is_out { outwards } else { inwards },
            encoder_counts: of_gear.encoder_counts,
        };
        if is_first && thread.rpm > of_gear.max_rpm {
            // P294 to P297. Where the ladder chooses the gear nobody knew it before.
            self.thread = None;
            let alarm = own_alarm(self.interpreter.dialect(), Fault::TappingSpeed, self.span);
            self.state = State::Alarmed(Box::new(alarm));
            return;
        }
        // As fast as a program may ask for.
        let most = of_gear.max_rpm.min(self.spindle_config.max_rpm).min(self.interpreter.max_spindle_rpm());
        let rpm = self.dry_tapping(pitch).map_or(thread.rpm, |rpm| rpm.min(most));
        let thread = Thread { rpm, ..thread };
        let number = self.next_tag;
        self.next_tag += 1;
        let programmed = Programmed {
            number,
            way: Way::Line(from, to),
            is_rapid: false,
            feed: Some((pitch * thread.rpm / 60.0).abs()),
            tolerance: None,
        };
        self.stroke = Some(Stroke { from, thread, programmed, has_begun: false });
        if is_first && !self.spindle.is_at_marker() {
            let seconds = self.spindle.orient(0.0);
            self.keep_busy(Activity::Spindle, seconds);
        }
    }

    /// The gear in which the spindle turns so fast.
    fn gear(&self, rpm: f64) -> u8 {
        let by_speed = || self.spindle_config.gears.of_speed(rpm).unwrap_or(1);
        self.auxiliary.as_ref().map_or_else(by_speed, |auxiliary| auxiliary.gear())
    }

    /// A period of a stroke in a thread.
    pub(super) fn cut_thread(&mut self) -> Tick {
        let Some(stroke) = self.stroke else { return self.at_rest() };
        if !stroke.has_begun {
            if !self.may_move() {
                return self.at_rest();
            }
            // The spindle is at rest by now.
            let Stroke { from, thread, .. } = stroke;
            if !self.synchron.begin(from, self.spindle.angle(), &thread) {
                (self.stroke, self.thread) = (None, None);
                let alarm = Alarm::core(Fault::FeedNotReachable, self.span);
                self.state = State::Alarmed(Box::new(alarm));
                return self.at_rest();
            }
            self.stroke = Some(Stroke { has_begun: true, ..stroke });
            self.comes_to_move(stroke.programmed.number);
        }
        self.spindle.follow(self.synchron.advance());
        let setpoint = self.synchron.follow(self.spindle.encoder().turns);
        self.kind = Kind::Tapping;
        self.report.period(Activity::Cutting);
        let position = self.exchange(&self.beside(setpoint));
        let tick = Tick {
            position,
            actual: self.actual,
            velocity: self.synchron.speed(),
            span: self.span,
            moving: true,
        };
        if self.synchron.is_done() {
            self.end_stroke(&stroke);
        } else if self.synchron.overdue() > self.patience {
            self.fail_spindle();
        }
        tick
    }

    /// The stroke is run to its end, or was stopped.
    pub(super) fn end_stroke(&mut self, stroke: &Stroke) {
        let at = self.synchron.position();
        self.stroke = None;
        self.motion.rename(at);
        self.commanded = at;
        let (from, length) = (stroke.from, stroke.from.distance(at));
        self.report.finished(Activity::Cutting, length, from.min(at), from.max(at));
        if self.thread.is_some_and(|thread| thread.entry == at) {
            self.leave_thread();
        }
    }

    /// The tool is out: the spindle goes on as before, and what the operator asked for is done now.
    pub(super) fn leave_thread(&mut self) {
        let thread = self.thread.take();
        if let Some(speed) = thread.map(|thread| thread.speed_behind).filter(|speed| *speed != 0.0) {
            let seconds = self.spindle.tell(speed);
            self.keep_busy(Activity::Spindle, seconds);
        }
        match thread.and_then(|thread| thread.asked) {
            Some(Asked::Hold) => self.feed_hold(),
            Some(Asked::Reset) => self.come_to_rest(),
            None => {}
        }
    }

    /// The spindle does not come to its angle: without it no axis may move on.
    pub(super) fn fail_spindle(&mut self) {
        let rule = Fault::NotInPosition;
        let alarm = Alarm::new(self.interpreter.dialect().alarm_id(rule), rule, self.span).with("axis", "S");
        if let Some(thread) = &mut self.thread {
            thread.speed_behind = 0.0;
        }
        if let Some(stroke) = self.stroke {
            self.end_stroke(&stroke);
        }
        self.come_to_rest();
        self.failed = Some(Box::new(alarm));
    }
}
