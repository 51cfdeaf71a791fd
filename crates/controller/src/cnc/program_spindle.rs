//! The spindle as the program that runs has it: where a door, a drive or a key stopped it beside the program, cutting
//! does not go on before it turns again.

use super::Cnc;
use ferrocut_geometry::Turn;
use ferrocut_toolpath::{Op, SpindleState};

/// What the program asked for last, and whether that came.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct ProgramSpindle {
    state: SpindleState,
    /// It turned so. What a machine without a spindle of the control's makes of M03 is its own matter.
    has_turned: bool,
}

impl ProgramSpindle {
    /// A program that is taken up where the spindle shall be in this state.
    pub fn taken_up(state: SpindleState) -> ProgramSpindle {
        ProgramSpindle { state, has_turned: false }
    }
}

impl Cnc {
    /// A step of the program reaches the machine.
    pub(super) fn note_spindle(&mut self, op: &Op) {
        // M03 has no effect.
        if self.is_auxiliary_locked() {
            return;
        }
        let spindle = &mut self.program_spindle;
        match op {
            Op::Spindle(state) => *spindle = ProgramSpindle::taken_up(*state),
            Op::Orient(_) | Op::End(_) => *spindle = ProgramSpindle::default(),
            // Behind it the spindle may stand.
            Op::Tap { .. } => spindle.has_turned = false,
            _ => {}
        }
    }

    /// Once a period in which the program runs; `code_done`: the ladder has just finished a code, and what it stopped
    /// the spindle for is what the program wanted (M29, a tool change).
    pub(super) fn watch_spindle(&mut self, code_done: bool) {
        let turns = self.spindle_turns();
        let wanted = self.program_spindle.state.turn();
        if wanted.is_some() && turns == wanted {
            self.program_spindle.has_turned = true;
        } else if code_done {
            self.program_spindle.has_turned = false;
        }
    }

    /// Before a program begins: keys, or a lock, may have left the spindle otherwise than the program before did.
    pub(crate) fn finds_spindle(&mut self) {
        if let Some(auxiliary) = &self.auxiliary {
            let turn = auxiliary.spindle_turns();
            self.interpreter.own().finds_spindle(turn);
        }
    }

    /// Which way the spindle is asked to turn and may.
    fn spindle_turns(&self) -> Option<Turn> {
        match &self.auxiliary {
            Some(auxiliary) => auxiliary.spindle_turns(),
            None => match self.spindle.asked() {
                0.0 => None,
                rpm if rpm > 0.0 => Some(Turn::Clockwise),
                _ => Some(Turn::CounterClockwise),
            },
        }
    }

    /// What the spindle is to do before the program that is stopped may go on: it turned so and does not any more.
    /// Nobody cuts under a lock or in a dry run.
    pub fn spindle_due(&self) -> Option<SpindleState> {
        let ProgramSpindle { state, has_turned } = self.program_spindle;
        let cuts = !self.is_locked() && !self.is_auxiliary_locked() && !self.is_dry_run();
        (cuts && has_turned && self.spindle_turns() != state.turn()).then_some(state)
    }
}
