//! Programs one after the other on the same axes: position, spindle and what the interpreter remembers stay.

use super::program_spindle::ProgramSpindle;
use super::{Cnc, State};
use ferrocut_interpreter::{AtRest, Interpreter};
use ferrocut_program::{ProgramMemory, Span};
use ferrocut_toolpath::SpindleState;
use std::io;

impl Cnc {
    /// Whether no program is under way, no alarm stands, and no axis is moved by hand.
    pub fn is_idle(&self) -> bool {
        matches!(self.state, State::Ready | State::Ended | State::Reset) && !self.manual.is_active
    }

    /// Whether a program is under way: running, or stopped to go on.
    pub fn is_under_way(&self) -> bool {
        matches!(self.state, State::Running | State::Held | State::BlockEnd | State::Stopped(_))
    }

    /// Takes another interpreter, whose program waits for cycle start, and gives the one before back. Where none may
    /// be taken now, the new one comes back as an error.
    pub fn load(&mut self, interpreter: Interpreter) -> Result<Interpreter, Box<Interpreter>> {
        if !self.is_idle() {
            return Err(Box::new(interpreter));
        }
        let old = std::mem::replace(self.interpreter.own(), interpreter);
        self.fit_interpreter();
        let commanded = self.motion.position();
        if self.interpreter.position() != commanded {
            self.interpreter.own().came_to_rest(&AtRest::new(commanded, self.actual));
        }
        self.wait_at_first_block();
        Ok(old)
    }

    /// Takes other programs for the same interpreter, which keeps its modal state. The first block of the main one
    /// waits for cycle start. Gives those before back, or the new ones where none may be taken now.
    pub fn load_programs(&mut self, programs: ProgramMemory) -> Result<ProgramMemory, Box<ProgramMemory>> {
        if !self.is_idle() {
            return Err(Box::new(programs));
        }
        let old = self.interpreter.own().load(programs, self.motion.position());
        self.wait_at_first_block();
        Ok(old)
    }

    /// The program that was run waits for cycle start again, at its first block or at the one on `line`. `false`
    /// where that cannot be.
    pub fn rewind(&mut self, line: Option<u32>) -> io::Result<bool> {
        if !self.is_idle() {
            return Ok(false);
        }
        self.interpreter.own().rewind(self.motion.position());
        let is_there = match line {
            Some(line) => self.interpreter.own().start_at(line)?,
            None => true,
        };
        self.wait_at_first_block();
        Ok(is_there)
    }

    /// Reset with nothing under way: what the control's parameters say is cleared, the spindle stops. While
    /// something is under way that is [`reset`](Self::reset).
    pub fn clear(&mut self) {
        if self.is_idle() {
            self.spindle.command(SpindleState::Off, &self.commanded);
            self.clear_codes();
        }
    }

    /// What a reset clears, the spindle aside.
    pub(super) fn clear_codes(&mut self) {
        self.interpreter.own().reset(self.motion.position());
        self.forget_blocks();
        self.state = State::Reset;
    }

    /// The program waits for cycle start, and nothing of what ran before is remembered.
    fn wait_at_first_block(&mut self) {
        self.wait_for_start();
        self.forget_journal();
        self.no_block_was_run();
    }

    pub(super) fn wait_for_start(&mut self) {
        self.forget_blocks();
        self.retrace.forget();
        self.given.clear();
        (self.waiting, self.thread) = (None, None);
        (self.busy, self.input_came) = (None, None);
        self.program_spindle = ProgramSpindle::default();
        self.commanded = self.motion.position();
        self.supervisor.moved_to(self.commanded);
        self.span = Span::default();
        self.main_line = 0;
        self.state = State::Ready;
    }
}
