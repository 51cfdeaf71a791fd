//! Values that only a machine at rest knows: where the axes are, how far they lag behind, what an input
//! says.
//!
//! Blocks are interpreted ahead of motion. A block that reads such a value is left before it has changed
//! anything, a [`Barrier`](ferrocut_toolpath::Op::Barrier) is given out in its place, and it is run again
//! once that step was taken: whoever takes it lets the axes come to rest and tells the interpreter of them
//! by [`Interpreter::came_to_rest`]. At a desk no one does, and the commanded position stands for the
//! machine's.

use crate::Fallible;
use crate::dialect::Variable;
use crate::interpreter::Interpreter;
use ferrocut_geometry::Position;
use ferrocut_machine::{Alarm, Fault};
use ferrocut_program::Span;
use ferrocut_toolpath::{Op, Step};

/// The machine as it came to rest at a barrier. Machine positions of the axes, mm and degrees.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct AtRest {
    /// Where the axes are commanded to be.
    pub commanded: Position,
    /// Where they are.
    pub actual: Position,
    /// Where the skip signal of the move before came; `None` if it was no skip or the signal did not come.
    pub skip: Option<Position>,
    /// Whether the input that was waited for before came; `None` if none was.
    pub input: Option<bool>,
    /// Inputs of programs, from bit 0 on; `None` where the machine has none.
    pub inputs: Option<u16>,
}

impl AtRest {
    /// With neither a signal nor an input that was waited for, and inputs as they were.
    pub fn new(commanded: Position, actual: Position) -> AtRest {
        AtRest { commanded, actual, skip: None, input: None, inputs: None }
    }
}

/// Whether blocks may read the machine's present.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(crate) enum Present {
    /// Motion may be under way.
    #[default]
    Unknown,
    /// The block being run asked for it.
    Asked,
    /// The axes are at rest, until the next block.
    Known,
}

impl Variable {
    /// Whether the value is that of the moment, which the control does not read during motion
    /// (GSK990MC table 4-9-2-3; the position in the work coordinate system and the inputs are of the
    /// moment too).
    pub(crate) fn is_of_the_moment(self) -> bool {
        matches!(
            self,
            Variable::MachinePosition(_)
                | Variable::WorkPosition(_)
                | Variable::TipPosition(_)
                | Variable::LengthOffset(_)
                | Variable::ServoOffset(_)
                | Variable::Input(_)
                | Variable::InputWord
                | Variable::Inputs
        )
    }
}

impl Interpreter {
    /// Tells how the machine came to rest, between a barrier and the step after it.
    pub fn came_to_rest(&mut self, machine: &AtRest) {
        self.following_error = machine.commanded - machine.actual;
        if let Some(inputs) = machine.inputs {
            self.set_ports(inputs);
        }
        let moved = machine.commanded - self.output.commanded();
        if moved != Position::ZERO {
            self.location.machine = self.location.machine + moved;
            self.location.take_machine();
            self.ngc.at = self.ngc.program_of(self.location.machine);
            self.output.jump_to(self.location.machine);
        }
        if let Some(at) = machine.skip {
            self.awaits_signal = None;
            self.location.skip = at - self.location.work.shift;
        }
        if self.dialect.blocks.is_some() {
            self.ngc_came_to_rest(machine.skip);
            if let Some(came) = machine.input {
                self.ngc_input_came(came);
            }
        }
    }

    /// A probe is fitted to a machine with these software limits: skip moves are given out as programmed, and the
    /// machine says at the barrier behind them where the signal came.
    pub fn fit_probe(&mut self, min: Position, max: Position) {
        self.probe = Some((min, max));
    }

    /// Inputs that a program waits for are waited for by the machine, which says what came, and has these software limits.
    /// Without that they are simulated.
    pub fn leave_waits_to_machine(&mut self, min: Position, max: Position) {
        self.machine_waits = Some((min, max));
    }

    /// The machine came to rest behind a skip move without having had its signal: the alarm, where that is one.
    pub fn missed_signal(&mut self) -> Option<Box<Alarm>> {
        self.awaits_signal.take().map(|span| self.alarm(Fault::SkipWithoutSignal, span))
    }

    /// A skip move had its signal where it was to begin: the alarm, where that is one. G38.2 and G38.4 need the probe to come
    /// into contact, or out of it (LinuxCNC 2.9, EMCMOT_PROBE); G31 of the other languages ends there.
    pub fn signal_before(&mut self) -> Option<Box<Alarm>> {
        let span = self.awaits_signal.filter(|_| self.dialect.blocks.is_some())?;
        Some(self.alarm(Fault::SignalBefore, span))
    }

    /// A skip move needs its signal and has none so far: an alarm, unless the machine has a probe that will tell.
    pub(crate) fn miss_signal(&mut self, span: Span) -> Fallible<()> {
        match self.probe {
            None => Err(self.alarm(Fault::SkipWithoutSignal, span)),
            Some(_) => {
                self.awaits_signal = Some(span);
                Ok(())
            }
        }
    }

    /// Gives out a barrier. What cutter compensation holds back ends here, square to its last move, as
    /// before a block that it cannot look beyond (GSK990MC 4.7.3, 7).
    pub(crate) fn emit_barrier(&mut self) -> Fallible<()> {
        let step = self.step(Op::Barrier);
        self.push_barrier(step)
    }

    /// The same before a block, which single block does not take for one.
    pub(crate) fn emit_barrier_before(&mut self) -> Fallible<()> {
        let step = Step { section: Step::PASSED, ..self.step(Op::Barrier) };
        self.push_barrier(step)
    }

    fn push_barrier(&mut self, step: Step) -> Fallible<()> {
        // Not by `emit`: a program that only waits does not get on.
        let output = &mut self.output;
        let done = output.move_is_missing().and_then(|()| output.flush()).and_then(|()| output.push(step));
        done.map_err(|(fault, span)| self.alarm(fault, span))
    }
}
