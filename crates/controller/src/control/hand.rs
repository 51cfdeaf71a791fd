//! Axes and spindle moved by hand: what the ladder asks for becomes jog, steps, handwheel (GSK990MC part 2, 4 to 6).

use super::{Control, ParameterSwitch, alarm, modes};
use crate::api::Event;
use crate::manual::{JogSpeed, JogWay};
use crate::signals::{Inputs, Mode, SIGNAL_AXES};
use ferrocut_geometry::{Axis, AxisSet};
use ferrocut_machine::{Alarm, Fault};
use ferrocut_toolpath::{Speed, SpindleState};

/// Least input increment, mm or degrees.
const LEAST_INCREMENT: f64 = 0.001;

/// Of linear axes where inches are programmed: a ten-thousandth of one, mm (table 6-1-3-1).
const LEAST_INCH_INCREMENT: f64 = 25.4e-4;

/// The handwheel has three increments, of 1, 10 and 100 least ones (6.1.1); STEP has a fourth.
const LARGEST_WHEEL_STEP: f64 = 100.0;

impl Control {
    /// The keys of the axes and the handwheel.
    pub(super) fn move_by_hand(&mut self) {
        self.see_keys_let_go();
        let shifts = self.bit(56, 3);
        let counts = std::mem::take(&mut self.counts);
        self.cnc.set_interruption(modes::by_hand(self.mode, shifts));
        let (upwards, downwards) = self.forbidden_by_hand();
        self.cnc.forbid_by_hand(upwards, downwards);
        self.follow_switches();
        self.leaves = self.moved_back();
        if !self.inputs.axes_may_move || self.keeps_axes() && self.leaves.is_empty() {
            self.release_axes();
            return;
        }
        match self.mode {
            Mode::Jog => self.jog(),
            Mode::Step => self.step(),
            Mode::Handle => self.turn_wheel(counts),
            Mode::Home => self.home(),
            _ => self.release_axes(),
        }
    }

    /// Ways on which the ladder lets no axis go on in a manual mode: up and down.
    fn forbidden_by_hand(&self) -> (AxisSet, AxisSet) {
        let axes = || {
            let is_manual = self.mode.is_manual();
            self.machine.axes.iter().zip(&self.inputs.no_motion).filter(move |_| is_manual)
        };
        let upwards = axes().filter(|(_, ways)| ways.plus).map(|(axis, _)| axis.name);
        let downwards = axes().filter(|(_, ways)| ways.minus).map(|(axis, _)| axis.name);
        (upwards.collect(), downwards.collect())
    }

    fn axis(&self, number: usize) -> Option<Axis> {
        self.machine.axes.get(number).map(|axis| axis.name)
    }

    /// Axes whose keys were held when all was stopped have effect again once these are let go.
    fn see_keys_let_go(&mut self) {
        for (stale, ways) in self.stale_keys.iter_mut().zip(&self.inputs.jog) {
            *stale &= ways.plus || ways.minus;
        }
    }

    /// The way that is asked for, if it may be gone.
    fn way(&self, number: usize) -> i8 {
        if self.stale_keys.get(number).copied().unwrap_or_default() {
            return 0;
        }
        let of = |ways: &[crate::signals::Ways; SIGNAL_AXES]| ways.get(number).copied().unwrap_or_default();
        let forbidden = of(&self.inputs.no_motion);
        let waits = !self.axis(number).is_some_and(|axis| self.may_be_moved(axis));
        match of(&self.inputs.jog).sign() {
            _ if waits => 0,
            1 if forbidden.plus => 0,
            -1 if forbidden.minus => 0,
            sign => sign,
        }
    }

    fn jog(&mut self) {
        for number in 0..SIGNAL_AXES {
            let Some(axis) = self.axis(number) else { break };
            let is_rapid = self.inputs.manual_rapid;
            let asked = (self.way(number), is_rapid);
            let Some(before) = self.jogs.get_mut(number) else { break };
            if *before == asked || asked.0 == 0 && before.0 == 0 {
                continue;
            }
            let way = match asked.0 {
                1 => JogWay::Plus,
                -1 => JogWay::Minus,
                _ => JogWay::Stop,
            };
            let speed = if is_rapid { JogSpeed::Rapid } else { JogSpeed::Feed };
            if self.cnc.jog(axis, way, speed) || way == JogWay::Stop {
                *before = asked;
            }
        }
    }

    /// What an axis moves by in a step of 1.
    fn least_increment(&self, axis: Axis) -> f64 {
        match axis.is_linear() && self.cnc.interpreter().reads_inches() {
            true => LEAST_INCH_INCREMENT,
            false => LEAST_INCREMENT,
        }
    }

    fn step(&mut self) {
        for number in 0..SIGNAL_AXES {
            let Some(axis) = self.axis(number) else { break };
            let asked = self.way(number);
            let Some(before) = self.jogs.get_mut(number) else { break };
            let is_pressed = asked != 0 && before.0 != asked;
            *before = (asked, false);
            if is_pressed {
                let increment = self.inputs.increment_of(self.least_increment(axis));
                self.cnc.jog_step(axis, i64::from(asked), increment);
            }
        }
    }

    /// A key sends its axis to the reference point (9.2); the parameters say what letting it go does.
    fn home(&mut self) {
        for number in 0..SIGNAL_AXES {
            let Some(axis) = self.axis(number) else { break };
            let asked = self.way(number);
            let Some(before) = self.jogs.get_mut(number) else { break };
            let was = std::mem::replace(before, (asked, false)).0;
            if asked != 0 && was == 0 {
                let busy = self.cnc.is_under_way().then(|| Box::new(alarm(Fault::ControlBusy)));
                match busy.or_else(|| self.locked_alarm()).or_else(|| self.cnc.home_alarm(axis)) {
                    Some(alarm) => self.refuse(&alarm),
                    None => drop(self.cnc.home(axis)),
                }
            } else if asked == 0 && was != 0 {
                self.cnc.release_home(axis);
            }
        }
    }

    /// Why no place gets the name of a reference point: under machine lock the axes are not where they seem to be.
    pub(super) fn locked_alarm(&self) -> Option<Box<Alarm>> {
        self.cnc.is_locked().then(|| Box::new(alarm(Fault::MachineLocked)))
    }

    fn turn_wheel(&mut self, counts: i32) {
        let axis = self.inputs.handwheel_axis.and_then(|number| self.axis(number));
        if let Some(axis) = axis.filter(|axis| counts != 0 && self.may_be_moved(*axis)) {
            let least = self.least_increment(axis);
            let increment = self.inputs.increment_of(least).min(LARGEST_WHEEL_STEP * least);
            self.cnc.handwheel(axis, i64::from(counts), increment);
        }
    }

    /// Axes that are moved by hand although an alarm stands, where nothing else keeps them: off the travel switches while
    /// their release is held (2.5.3), and out of a forbidden area, before the reset (2.6, 6).
    fn moved_back(&self) -> AxisSet {
        let may_move = !self.emergency
            && self.parameter_switch != ParameterSwitch::On
            && matches!(self.mode, Mode::Jog | Mode::Step | Mode::Handle);
        match &self.active {
            Some(alarm) if may_move && alarm.fault == Fault::HardLimit => self.cnc.leaves_switch(),
            Some(alarm) if may_move && alarm.fault == Fault::StoredStroke => {
                self.machine.axes.iter().map(|axis| axis.name).collect()
            }
            _ => AxisSet::EMPTY,
        }
    }

    /// While such an alarm stands its axes alone are moved.
    fn may_be_moved(&self, axis: Axis) -> bool {
        self.leaves.is_empty() || self.leaves.contains(axis)
    }

    /// The alarm of the travel switches goes once its axes have left them.
    fn follow_switches(&mut self) {
        let is_of_switches = self.active.as_ref().is_some_and(|alarm| alarm.fault == Fault::HardLimit);
        if is_of_switches && self.state == *self.cnc.state() && self.cnc.has_left_switches() {
            self.active = None;
            if !self.is_alarmed() {
                self.event(Event::AlarmsCleared);
            }
        }
    }

    /// An axis that is to go on over a limit stands there with an alarm, until it is moved back (2.5.2).
    pub(super) fn follow_limits(&mut self) {
        let stood = self.at_limits.len();
        let mut standing = std::mem::take(&mut self.at_limits);
        standing.retain(|(axis, upper, _)| self.cnc.cut_short().any(|cut| cut == (*axis, *upper)));
        let is_known = |cut: &(Axis, bool)| standing.iter().any(|(axis, upper, _)| *cut == (*axis, *upper));
        let new: Vec<(Axis, bool)> = self.cnc.cut_short().filter(|cut| !is_known(cut)).collect();
        let is_over = stood > 0 && standing.is_empty();
        self.at_limits = standing;
        for (axis, upper) in new {
            let alarm = self.cnc.cut_short_alarm(axis, upper);
            self.log_alarm(&alarm);
            self.at_limits.push((axis, upper, alarm));
        }
        if is_over && !self.is_alarmed() {
            self.event(Event::AlarmsCleared);
        }
    }

    /// No key of an axis has effect any more. One that is held has none before it is let go and pressed anew: the end of
    /// what stopped the axes moves none.
    pub(super) fn release_axes(&mut self) {
        for (stale, (ways, before)) in
            self.stale_keys.iter_mut().zip(self.inputs.jog.iter().zip(&self.before.jog))
        {
            // One that is pressed together with what stops the axes is pressed anew.
            *stale |= (ways.plus || ways.minus) && (before.plus || before.minus);
        }
        for number in 0..SIGNAL_AXES {
            let Some(axis) = self.axis(number) else { break };
            if let Some(before) = self.jogs.get_mut(number)
                && std::mem::take(before).0 != 0
            {
                self.cnc.jog(axis, JogWay::Stop, JogSpeed::Feed);
            }
        }
    }

    /// The keys of the spindle, in the modes in which they have effect (4.2): it turns at the S given before. Only of a
    /// control without a ladder: else they reach the spindle through that, which knows whether it may turn.
    pub(super) fn turn_spindle(&mut self) {
        if self.plc.is_some() || !self.mode.is_manual() || self.emergency {
            return;
        }
        let (now, before) = (self.inputs.clone(), self.before.clone());
        let (_, rpm) = self.cnc.interpreter().feed_and_speed();
        let jog_rpm = self.parameter(242);
        let turns = |inputs: &Inputs| inputs.spindle_forward || inputs.spindle_reverse || inputs.spindle_jog;
        let rises = |now: bool, before: bool| now && !before;
        if rises(now.spindle_orient, before.spindle_orient) {
            self.cnc.orient_spindle();
        } else if rises(now.spindle_forward, before.spindle_forward) {
            self.cnc.turn_spindle(SpindleState::Clockwise(Speed::Rpm(rpm)));
        } else if rises(now.spindle_reverse, before.spindle_reverse) {
            self.cnc.turn_spindle(SpindleState::CounterClockwise(Speed::Rpm(rpm)));
        } else if rises(now.spindle_jog, before.spindle_jog) {
            self.cnc.turn_spindle(SpindleState::Clockwise(Speed::Rpm(jog_rpm)));
        } else if turns(&before) && !turns(&now) {
            self.cnc.turn_spindle(SpindleState::Off);
        }
    }
}
