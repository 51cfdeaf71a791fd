//! The parameter switch of the setting page (GSK990MC part 2, 3.4.1): parameters are changed by hand only while it is
//! on, and while it is on an alarm stands until somebody accepts it there. It is off at power-on.

use super::{Control, alarm};
use crate::api::{Event, Reply};
use crate::signals::Mode;
use ferrocut_machine::{Alarm, Fault, ParameterKey};
use ferrocut_memory::Author;

/// How the switch stands.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(super) enum ParameterSwitch {
    /// Nobody changes parameters by hand.
    #[default]
    Off,
    /// On, with its alarm.
    On,
    /// On, and the alarm was accepted.
    Accepted,
}

impl Control {
    /// Whether parameters may be changed by hand; none on a control without the switch.
    pub(super) fn parameters_open(&self) -> Option<bool> {
        let has_switch = self.cnc.interpreter().dialect().parameter_switch;
        has_switch.then_some(self.parameter_switch != ParameterSwitch::Off)
    }

    /// The alarm that stands while the switch is on.
    pub(super) fn parameter_alarm(&self) -> Option<Alarm> {
        let stands = self.parameter_switch == ParameterSwitch::On;
        stands.then(|| self.own_alarm(Fault::ParametersOpen))
    }

    /// Data of the machine are set in MDI, as parameters are, and not while a program is under way.
    pub(super) fn may_set_machine(&self, author: &Author) -> Result<(), Box<Alarm>> {
        self.needs(Mode::Mdi, author)?;
        match self.cnc.is_under_way() {
            true => Err(Box::new(alarm(Fault::ControlBusy))),
            false => Ok(()),
        }
    }

    /// Whether somebody may set parameters now, rights aside.
    pub(super) fn may_set_parameters(&self, author: &Author) -> Result<(), Box<Alarm>> {
        self.may_set_machine(author)?;
        match (self.parameters_open(), author) {
            (Some(false), Author::Person { .. }) => Err(Box::new(self.own_alarm(Fault::ParametersClosed))),
            _ => Ok(()),
        }
    }

    /// Parameters were changed: what the machine was built of holds from the next power-on, which is told until then, or
    /// until it is as before (alarm 0000 of the GSK990MC). It stops nothing: the machine is the one that it was, and the
    /// manual says no more than that the power is to be cut once.
    pub(super) fn parameters_changed(&mut self) {
        self.left_to_file = None;
        let interpreter = self.cnc.interpreter();
        let now = &interpreter.memory().parameters;
        let needed = interpreter.dialect().builds_another(&self.machine, &self.built_with, now);
        match (std::mem::replace(&mut self.needs_power_off, needed), needed) {
            (false, true) => {
                if let Some(alarm) = self.power_off_alarm() {
                    self.log_alarm(&alarm);
                }
            }
            (true, false) if !self.is_alarmed() => self.event(Event::AlarmsCleared),
            _ => {}
        }
    }

    /// The parameters that say nothing of the machine as they are, since nobody has set them.
    pub(super) fn left_to_file(&mut self) -> Vec<ParameterKey> {
        let is_busy = self.must_not_wait();
        let interpreter = self.cnc.interpreter();
        let (dialect, now) = (interpreter.dialect(), &interpreter.memory().parameters);
        let others = || self.may_be_left.iter().filter(|key| !now.is_given(key)).cloned();
        match &self.left_to_file {
            Some(known) => known.clone(),
            // To build so many machines takes longer than a period: where there is no time those of a group are left of
            // which one was set.
            None if is_busy => others().collect(),
            None => {
                let left = dialect.left_to_file(&self.machine, now, others());
                self.left_to_file = Some(left.clone());
                left
            }
        }
    }

    /// The warning that stands until the power is cut.
    pub(super) fn power_off_alarm(&self) -> Option<Alarm> {
        self.needs_power_off.then(|| self.own_alarm(Fault::PowerOffNeeded).as_warning())
    }

    pub(super) fn turn_parameter_switch(&mut self, on: bool, author: &Author) -> Result<Reply, Box<Alarm>> {
        if self.parameters_open().is_none() {
            return Err(Box::new(alarm(Fault::NotFitted).with("name", "parameter switch")));
        }
        self.may_set_machine(author)?;
        match (on, self.parameter_switch) {
            (true, ParameterSwitch::Off) => {
                self.parameter_switch = ParameterSwitch::On;
                if let Some(alarm) = self.parameter_alarm() {
                    self.log_alarm(&alarm);
                }
            }
            (false, stood) => {
                self.parameter_switch = ParameterSwitch::Off;
                self.end_parameter_alarm(stood);
            }
            _ => {}
        }
        Ok(Reply::Done)
    }

    pub(super) fn accept_parameter_switch(&mut self) -> Reply {
        let stood = self.parameter_switch;
        if stood == ParameterSwitch::On {
            self.parameter_switch = ParameterSwitch::Accepted;
            self.end_parameter_alarm(stood);
        }
        Reply::Done
    }

    fn end_parameter_alarm(&mut self, stood: ParameterSwitch) {
        if stood == ParameterSwitch::On && !self.is_alarmed() {
            self.event(Event::AlarmsCleared);
        }
    }
}
