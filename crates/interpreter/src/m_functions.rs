//! What M codes do, before the motion of their block and after it (GSK990MC 5.2), and how programs end
//! and call one another.

use crate::Fallible;
use crate::custom::Custom;
use crate::dialect::{MCode, MFunction, Meaning};
use crate::execute::{Part, Rest};
use crate::interpreter::Interpreter;
use crate::words::Code;
use ferrocut_geometry::Axis;
use ferrocut_machine::Fault;
use ferrocut_program::{ProgramId, Span};
use ferrocut_toolpath::{Op, SpindleState};

impl Interpreter {
    /// Carries out the M codes that start with the block's motion, or those that wait for its end, from one
    /// on. Ends before one that a program stands for, and tells what is to be done behind it.
    pub(crate) fn m_functions(
        &mut self,
        after: bool,
        from: usize,
        rest: &mut Rest,
    ) -> Fallible<Option<(Custom, Span)>> {
        for at in from..self.words.m.len() {
            let Some(Code { row, span }) = self.words.m.get(at).copied() else { break };
            if row.after_motion != after {
                continue;
            }
            if row.function == MFunction::ToolChange && !self.is_auxiliary_locked() {
                self.tool_comes()?;
            }
            if rest.builtin != Some(at)
                && let Some(code) = self.custom_m(row)
            {
                // The program of an end of program comes before the end.
                let ends = row.function == MFunction::ProgramEnd;
                rest.builtin = ends.then_some(at);
                let next = if ends { at } else { at + 1 };
                rest.part = if after { Part::After(next) } else { Part::Before(next) };
                return Ok(Some((code, span)));
            }
            self.m_function(row, span)?;
        }
        Ok(None)
    }

    /// M00, and M01 where it is chosen: nothing behind it is read before the start, for the operator may change what it is read
    /// with (GSK990MC 5.2 note 2). In cutter compensation and at a corner the move behind it decides where the one before ends.
    fn program_stop(&mut self, code: &MCode) -> Fallible<()> {
        self.emit(Op::Stop(code.code.into()));
        if self.output.looks_ahead() { Ok(()) } else { self.emit_barrier_before() }
    }

    pub(crate) fn m_function(&mut self, code: &MCode, span: Span) -> Fallible<()> {
        self.technology.m_code = Some(f64::from(code.code));
        let speed = self.speed();
        match code.function {
            MFunction::Stop => return self.program_stop(code),
            MFunction::OptionalStop if self.options.optional_stop => return self.program_stop(code),
            MFunction::OptionalStop => {}
            MFunction::SpindleClockwise => self.spindle(SpindleState::Clockwise(speed)),
            MFunction::SpindleCounterClockwise => self.spindle(SpindleState::CounterClockwise(speed)),
            MFunction::SpindleOff => {
                self.zone.turn = None;
                self.spindle(SpindleState::Off);
            }
            MFunction::Orient => {
                self.zone.turn = None;
                self.technology.spindle = SpindleState::Off;
                let angle = self.words.get(b'S').filter(|_| self.rules.orients_to_speed_word);
                self.emit(Op::Orient(angle.unwrap_or(0.0)));
            }
            MFunction::CoolantOn => self.coolant(true),
            MFunction::CoolantOff => self.coolant(false),
            // By itself it changes nothing where the tool is in the spindle already (GSK990MC 8.1).
            MFunction::ToolChange
                if !self.words.has(b'T') && self.technology.in_spindle == self.technology.tool => {}
            MFunction::ToolChange if self.is_auxiliary_locked() => {}
            MFunction::ToolChange => {
                self.technology.in_spindle = self.technology.tool;
                // The spindle stands still while a tool is changed.
                self.zone.turn = None;
                self.spindle(SpindleState::Off);
                self.emit(Op::Change(self.technology.tool));
                if self.rules.tools_carry_offsets {
                    self.tool_changed(self.words.get(b'D'));
                }
            }
            MFunction::RigidTapping => {
                if self.cycle_kind().is_some() {
                    return Err(self.alarm(Fault::RigidInCycle, span));
                }
                self.technology.rigid_tapping = true;
                self.emit(Op::Machine(code.code.into()));
            }
            MFunction::RigidTappingOff => {
                self.technology.rigid_tapping = false;
                self.emit(Op::Machine(code.code.into()));
            }
            MFunction::Machine => self.emit(Op::Machine(code.code.into())),
            MFunction::Call => return self.subprogram_call(span),
            MFunction::Return => return self.program_return(code, span),
            MFunction::ProgramEnd => self.end_program(code.code)?,
            MFunction::Message => self.message(),
            MFunction::Internal => self.internal_number(span)?,
            MFunction::ToolNumber => self.number_tool()?,
            MFunction::SetOutput => self.set_output(span)?,
            MFunction::ReferenceReached => self.reference_reached(span)?,
            MFunction::End => {
                // In a subprogram M02 and M30 are M99 (GSK990MC 3.2).
                if !self.go_back() {
                    self.end_program(code.code)?;
                }
            }
        }
        Ok(())
    }

    /// Whether P is the block that M99 of the block names: no other code has it, nor a cycle that makes a hole here.
    pub(crate) fn p_is_of_return(&self) -> bool {
        let returns = self.words.m.iter().any(|m| m.row.function == MFunction::Return);
        let has_hole = || {
            let has_place = !self.words.axes(self.rules.axes).is_empty() || self.cycle_code().is_some();
            self.cycle_kind().is_some() && has_place
        };
        let is_own = || self.words.g.iter().any(|code| self.custom_g(code.row).is_some());
        returns && !has_hole() && !is_own() && !self.p_is_taken(Meaning::NoEffect)
    }

    /// M99. P is the number of the block where the caller goes on, in the main program that of the next block, as on Fanuc:
    /// manuals have M99 alone (Weihong 4.2, GSK990MC 5.2.5, Kaitong appendix 10), Weihong's 3.1 P as a sequence number too.
    fn program_return(&mut self, code: &MCode, span: Span) -> Fallible<()> {
        let number = self.words.get(b'P').filter(|_| self.p_is_of_return());
        let mut to = number.map(|number| (number, self.words.span(b'P')));
        let depth = self.flow.depth_of_calls();
        let is_main = !self.go_back();
        if is_main && (self.options.return_ends || to.is_none() && self.flow.looks_ahead()) {
            return self.end_program(30);
        }
        let (from, is_done) = (self.flow.executing(), self.flow.depth_of_calls() < depth);
        if let Some((number, at)) = to.filter(|_| is_main || is_done)
            && let Err(alarm) = self.go_to(number, Fault::SequenceMissing, at)
        {
            if !self.options.keep_going {
                return Err(alarm);
            }
            // The program has returned already; what else the block does it did.
            self.note(alarm);
            to = None;
        }
        let ends = match to {
            _ if !is_main => false,
            // Further down it is no other pass of the program.
            Some(_) => self.flow.next_place() <= from && self.goes_round(from),
            None => self.start_again(span)?,
        };
        if ends { self.end_program(code.code) } else { Ok(()) }
    }

    /// Spindle and coolant stop with the program (GSK990MC 5.2.1). A ladder that gets every code ends them by M02 and
    /// M30 themselves (DM02, DM30): no M05 and M09 that nobody wrote is to be finished before. M99 it does not get.
    pub(crate) fn end_program(&mut self, code: u16) -> Fallible<()> {
        if code != 99 {
            self.go_to_fixed_point()?;
        }
        if let Some(alarm) = self.unended_profile() {
            self.note(alarm);
        }
        let is_by_ladder = self.options.every_code && code != 99;
        match self.rules.end_stops_spindle {
            true if is_by_ladder => self.technology.spindle = SpindleState::Off,
            true => self.spindle(SpindleState::Off),
            false => {}
        }
        match is_by_ladder {
            true => self.technology.coolant = false,
            false => self.coolant(false),
        }
        self.emit(Op::End(code.into()));
        self.ended = true;
        Ok(())
    }

    /// After each program that ends as it should the control takes the tool to its fixed point (Weihong 5, parameters 19 to
    /// 22), as `G53 G00` does, at its own speed. The spindle still turns, since the tool may be in the part.
    fn go_to_fixed_point(&mut self) -> Fallible<()> {
        let Some(point) = self.rules.fixed_point.filter(|_| self.options.ends_at_fixed_point) else {
            return Ok(());
        };
        let axes = [Axis::X, Axis::Y, Axis::Z];
        self.check_referenced(Some(Meaning::MachinePosition), axes.into_iter().collect())?;
        let mut to = self.location.machine;
        for (axis, at) in axes.into_iter().zip(point) {
            to[axis] = at;
        }
        self.output.suspend_cutter();
        self.technology.rapid_feed = None;
        self.rapid_machine(to)?;
        self.location.take_machine();
        Ok(())
    }

    /// M98 P L (GSK990MC 3.2.2).
    pub(crate) fn subprogram_call(&mut self, span: Span) -> Fallible<()> {
        // A macro calls macros only (alarm 0081).
        if self.in_macro() {
            return Err(self.alarm(Fault::CallInMacro, span));
        }
        self.program_call(span)
    }

    /// G65 of a control whose programs share their variables: other words set them (Weihong 4.4).
    pub(crate) fn g_call(&mut self, span: Span) -> Fallible<()> {
        for letter in b'A'..=b'Z' {
            if let Some(variable) = (self.dialect.argument)(letter)
                && let Some(value) = self.words.get(letter)
            {
                // There is room for those of letters.
                let _ = self.memory.variables.set(variable, Some(value));
                self.variable_writes += 1;
            }
        }
        self.program_call(span)
    }

    /// Calls the program that P names, L times, with the variables of its caller.
    pub(crate) fn program_call(&mut self, span: Span) -> Fallible<()> {
        let (program, at) = match (self.words.text(b'P'), self.words.get(b'P')) {
            (Some(name), _) => (ProgramId::named(&self.programs.slice(name)), self.words.long_span(b'P')),
            (None, Some(number)) if (1.0..=99_999.0).contains(&number) && number.fract() == 0.0 => {
                (ProgramId::Number(number as u32), self.words.span(b'P'))
            }
            (None, Some(_)) => return Err(self.alarm_at(Fault::ProgramNumber, b'P')),
            (None, None) => return Err(self.alarm(Fault::CallWithoutProgram, span)),
        };
        let times = self.words.get(b'L').unwrap_or(1.0);
        if let Some(fault) = self.repeats_fault(times) {
            return Err(self.alarm_at(fault, b'L'));
        }
        self.call(&program, times as u32, None, at)
    }

    /// What is wrong with the L of a call.
    pub(crate) fn repeats_fault(&self, times: f64) -> Option<Fault> {
        match times {
            _ if self.rules.counts_take_any_number && times <= self.rules.max_repeats => None,
            _ if times < 0.0 => Some(Fault::WordNegative),
            _ if times.fract() != 0.0 => Some(Fault::WordNotWhole),
            _ => (times > self.rules.max_repeats).then_some(Fault::TooManyRepeats),
        }
    }
}
