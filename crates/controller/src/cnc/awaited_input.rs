//! Inputs that a program waits for (LinuxCNC M codes: M66 with L1 to L4; Weihong 4.4: G906).
//!
//! The axes are at rest. With a ladder it is one of the inputs of programs, UI from 0 on, that is looked at in every period
//! of the wait, and what became of it is told at the barrier behind. Feed hold stops the wait as it does a dwell. Without a
//! ladder inputs are simulated: the interpreter has decided already, and no time passes.

use super::{Cnc, State};
use crate::report::Activity;
use ferrocut_machine::{Alarm, Fault};
use ferrocut_toolpath::Port;

/// An input that is waited for.
#[derive(Clone, Copy, Debug)]
pub(super) struct AwaitedInput {
    /// Its number; none where the machine has no such input: it never comes.
    port: Option<u16>,
    /// The state that is waited for.
    state: bool,
    /// That it had another one was not seen yet, which is asked for.
    is_early: bool,
    must_come: bool,
}

impl AwaitedInput {
    /// One that is to have this state, or with `is_edge` to come to it; else it is an alarm if it `must_come`.
    pub fn new(state: bool, is_edge: bool, must_come: bool) -> AwaitedInput {
        AwaitedInput { port: None, state, is_early: is_edge, must_come }
    }
}

impl Cnc {
    /// Waits for an input, `timeout` seconds at most.
    pub(super) fn wait_for_input(&mut self, port: &Port, awaited: AwaitedInput, timeout: Option<f64>) {
        if self.auxiliary.is_none() {
            // Time passes, so that a program that waits in a loop comes to its end.
            return self.keep_busy(Activity::Dwell, self.period);
        }
        let port = port.number().filter(|port| self.program_input(*port).is_some());
        let awaited = AwaitedInput { port, ..awaited };
        if port.is_none() && awaited.must_come && timeout.is_none() {
            return self.end_wait(awaited, false);
        }
        // At least one period, in which it is looked at.
        let seconds = timeout.map_or(f64::INFINITY, |seconds| seconds.max(self.period));
        self.keep_busy(Activity::Dwell, seconds);
        if let Some(busy) = &mut self.busy {
            busy.until = Some(awaited);
        }
    }

    /// State of an input of programs; `None` for one that the machine does not have.
    pub(super) fn program_input(&self, port: u16) -> Option<bool> {
        let inputs = self.auxiliary.as_ref()?.macro_inputs();
        inputs.checked_shr(port.into()).map(|inputs| inputs & 1 == 1)
    }

    /// A period of the wait, which `is_over` with it.
    pub(super) fn look_for_input(&mut self, awaited: AwaitedInput, is_over: bool) {
        let state = awaited.port.and_then(|port| self.program_input(port));
        let has_state = state == Some(awaited.state);
        let is_early = awaited.is_early && has_state;
        if has_state && !is_early {
            self.end_wait(awaited, true);
        } else if is_over {
            self.end_wait(awaited, false);
        } else if let Some(busy) = &mut self.busy {
            busy.until = Some(AwaitedInput { is_early, ..awaited });
        }
    }

    fn end_wait(&mut self, awaited: AwaitedInput, came: bool) {
        self.busy = None;
        if !awaited.must_come {
            self.input_came = Some(came);
        } else if !came {
            self.state = State::Alarmed(Box::new(Alarm::core(Fault::InputMissing, self.span)));
        }
    }
}
