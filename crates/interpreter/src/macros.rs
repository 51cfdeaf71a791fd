//! Variables and statements of the macro language, and G65.

use crate::Fallible;
use crate::barrier::Present;
use crate::dialect::{Dialect, Variable};
use crate::evaluate::{Evaluator, Value};
use crate::flow::Locals;
use crate::interpreter::{Interpreter, Options};
use crate::stages::units;
use ferrocut_geometry::{Axis, MM_PER_INCH, Position};
use ferrocut_machine::{Alarm, AlarmId, Fault, Memory, WorkOffset};
use ferrocut_program::{
    Block, ExprRange, Node, Page, ProgramId, ProgramMemory, Span, Statement, Text, Unary, Value as WordValue,
    Word,
};
use ferrocut_toolpath::{Op, Port};

/// Local variables are #1 to this (GSK990MC 4.9.2).
const LAST_LOCAL: u32 = 50;

/// Where sixteen inputs that were set together are kept, beside those that were set one by one.
pub(crate) const INPUT_WORD: u16 = u16::MAX;

/// Common variables that power-off clears (table 4-9-2-1).
const VOLATILE: std::ops::RangeInclusive<u32> = 100..=199;

/// What a set-up gives variables that stand for something else is put there: `"#5201" = 10` into the zero.
///
/// # Errors
/// The alarm of a program that assigned it: the variable is only read, the value cannot be.
pub fn place_variables(dialect: &'static Dialect, memory: Memory) -> Fallible<Memory> {
    if dialect.blocks.is_some() {
        return Ok(memory);
    }
    let programs = ProgramMemory::new("", Text::sent(), dialect.syntax);
    let mut interpreter = Interpreter::new(dialect, programs, memory, Options::default());
    interpreter.place_variables()?;
    Ok(interpreter.memory)
}

impl Interpreter {
    /// Clears the variables that a reset clears.
    pub(crate) fn reset_variables(&mut self, locals: bool, commons: bool) {
        if locals {
            self.memory.variables.clear(1..=LAST_LOCAL);
        }
        if commons {
            self.memory.variables.clear(VOLATILE);
        }
    }

    /// Value of an expression of the page.
    pub(crate) fn evaluate(&mut self, page: &Page, range: ExprRange) -> Result<Value, Fault> {
        // The evaluator's stack is set aside so that variables can be read from the rest.
        let empty = Evaluator::empty(self.dialect.arithmetic);
        let mut evaluator = std::mem::replace(&mut self.evaluator, empty);
        let value = evaluator.value(page.nodes(range), |number| self.read_variable(number));
        self.evaluator = evaluator;
        value
    }

    /// Value of a word. A sign before `#` belongs to the reference: the word of an empty variable is as if
    /// it were not there, with it as without (GSK990MC 4.9.2, 7).
    pub(crate) fn evaluate_word(&mut self, page: &Page, range: ExprRange) -> Result<Value, Fault> {
        let value = match page.nodes(range) {
            [.., Node::Unary(Unary::Negate)] => {
                let referred = ExprRange { len: range.len - 1, ..range };
                self.evaluate(page, referred)?.map(|value| -value)
            }
            _ => self.evaluate(page, range)?,
        };
        Ok(value.map(|value| self.dialect.arithmetic.rounded(value)))
    }

    /// Value of a variable.
    #[inline]
    fn read_variable(&mut self, number: u32) -> Result<Value, Fault> {
        match (self.dialect.variable)(number) {
            Some(Variable::Plain) => Ok(self.memory.variables.get(number).or(self.dialect.unset_variable)),
            Some(variable) if variable.is_of_the_moment() && self.present != Present::Known => {
                // The block is left by this fault, which no one sees, and run again behind a barrier.
                self.present = Present::Asked;
                Err(Fault::UnknownVariable)
            }
            Some(variable) => self.read_system_variable(variable, number),
            None => Err(Fault::UnknownVariable),
        }
    }

    /// Whether the program has the parameter with a name in inches: lengths and feeds are in its unit, as positions are, so that
    /// they can stand in its words. The manual (Weihong 5) says nothing of it.
    fn parameter_is_inch(&self, place: u16) -> bool {
        self.modal.is_inch() && self.memory.parameters.table().is_named_in_mm(place)
    }

    fn axis_number(&self, index: u8) -> Result<Axis, Fault> {
        self.rules.axis_order.get(usize::from(index)).copied().ok_or(Fault::UnknownVariable)
    }

    fn read_system_variable(&self, variable: Variable, number: u32) -> Result<Value, Fault> {
        let tool = |number| self.memory.tools.get(number).ok_or(Fault::UnknownVariable);
        let location = &self.location;
        // Positions are in the unit of the program, as on Fanuc.
        let place = |position: &Position, axis: u8| -> Result<f64, Fault> {
            let axis = self.axis_number(axis)?;
            Ok(self.in_words(axis, position[axis]))
        };
        // Offsets and work zeros too (GSK990MC 4.2.17).
        let length = |mm: f64| units::from_mm(mm, self.modal.is_inch());
        Ok(Some(match variable {
            Variable::Empty => return Ok(None),
            Variable::Plain => return Err(Fault::UnknownVariable),
            Variable::ToolLength(n) => length(tool(n)?.length),
            Variable::LengthWear(n) => length(tool(n)?.length_wear),
            Variable::ToolRadius(n) => length(tool(n)?.radius),
            Variable::RadiusWear(n) => length(tool(n)?.radius_wear),
            Variable::ModalGroup(0) => self.technology.data_code,
            Variable::ModalGroup(group) => {
                let code = self.modal.codes().find(|code| code.group_number == group);
                return Ok(code.map(|code| f64::from(code.tenths) / 10.0));
            }
            Variable::ModalWord(letter) => return Ok(self.modal_word(letter)),
            Variable::BlockEnd(axis) => place(&location.programmed, axis)?,
            // Where the axes are commanded to be, cutter compensation included.
            Variable::MachinePosition(axis) => place(&self.output.commanded(), axis)?,
            Variable::WorkPosition(axis) => place(&(self.output.commanded() - location.work.shift), axis)?,
            Variable::TipPosition(axis) => {
                place(&(self.output.commanded() - location.work.shift - location.length.vector), axis)?
            }
            Variable::SkipPosition(axis) => place(&location.skip, axis)?,
            Variable::LengthOffset(axis) => place(&location.length.vector, axis)?,
            Variable::ServoOffset(axis) => place(&self.following_error, axis)?,
            Variable::WorkZero(name, axis) => {
                let zero = self.memory.work.get(name).ok_or(Fault::UnknownVariable)?;
                place(&zero, axis)?
            }
            Variable::Input(n) => self.inputs.get(&n).copied().unwrap_or(0.0),
            // One that was set by itself, else what its bits come to.
            Variable::InputWord => self.inputs.get(&INPUT_WORD).copied().unwrap_or_else(|| {
                (0..16)
                    .filter(|bit| self.inputs.get(bit).is_some_and(|on| *on != 0.0))
                    .map(|bit| f64::from(1u16 << bit))
                    .sum()
            }),
            Variable::Inputs => self.ports_as_bits(false),
            Variable::Outputs => self.ports_as_bits(true),
            Variable::Parameter(place) => {
                units::from_mm(self.memory.parameters.named_at(place), self.parameter_is_inch(place))
            }
            Variable::UserTable => self.memory.variables.get(number).unwrap_or(0.0),
            // What was put out last.
            Variable::Output(n) => return Ok(self.outputs.get(&n).copied()),
            Variable::Alarm => return Ok(None),
            Variable::CycleParameter(letter) => {
                return Ok(self.cycle_parameter(letter)?.or(self.dialect.unset_variable));
            }
        }))
    }

    /// The word in force of an address (GSK990MC #4022 to #4030).
    fn modal_word(&self, letter: u8) -> Value {
        let technology = &self.technology;
        match letter {
            b'D' => Some(technology.radius_number),
            b'H' => Some(f64::from(self.location.length.number)),
            // As programmed, before the control's limits.
            b'F' => {
                let feed = match self.modal.is_feed_per_revolution() {
                    true => technology.feed_per_revolution,
                    false => technology.feed_per_minute,
                };
                Some(if self.modal.is_inch() { feed / MM_PER_INCH } else { feed })
            }
            b'M' => technology.m_code,
            b'S' => Some(technology.speed.unwrap_or(0.0)),
            b'T' => Some(f64::from(technology.tool)),
            b'N' => technology.sequence,
            b'O' => Some(technology.program),
            b'P' => match self.location.work.system {
                crate::stages::work_offset::System::Table(WorkOffset::Additional(n)) => Some(f64::from(n)),
                _ => Some(0.0),
            },
            _ => None,
        }
    }

    /// Sets a variable.
    fn write_variable(&mut self, number: u32, value: Value, span: Span) -> Fallible<()> {
        let v = value.unwrap_or(0.0);
        match (self.dialect.variable)(number) {
            Some(Variable::Alarm) => return Err(self.program_alarm(v, span)),
            Some(Variable::Output(n)) => {
                self.outputs.insert(n, v);
                let port = Port::Named(format!("#{number}").into());
                self.emit(Op::Output { port, value: v, with_next_move: false });
            }
            variable => self.store_at(variable, number, value, span)?,
        }
        self.variable_writes += 1;
        Ok(())
    }

    /// The same as [`store`](Self::store), with the alarm of what cannot be.
    fn store_at(
        &mut self,
        variable: Option<Variable>,
        number: u32,
        value: Value,
        span: Span,
    ) -> Fallible<()> {
        self.store(variable, number, value).map_err(|fault| {
            let mut alarm = self.alarm(fault, span);
            alarm.arguments.push(("variable", self.dialect.syntax.variable_name(number).into()));
            alarm
        })
    }

    /// Puts a value where a variable stands for.
    fn store(&mut self, variable: Option<Variable>, number: u32, value: Value) -> Result<(), Fault> {
        let variable = variable.ok_or(Fault::UnknownVariable)?;
        if variable == Variable::Plain {
            let value = value.map(|value| self.dialect.arithmetic.rounded(value));
            return self.memory.variables.set(number, value).map_err(|_| Fault::VariableNotWritable);
        }
        if variable == Variable::Empty {
            return Err(Fault::NullVariable);
        }
        if let Variable::Parameter(place) = variable {
            let key = self.memory.parameters.table().named_key(place).ok_or(Fault::UnknownVariable)?;
            let value = units::length_mm(value.unwrap_or(0.0), self.parameter_is_inch(place));
            self.memory.set_parameter(key, value).map_err(|_| Fault::DataParameter)?;
            self.rules = (self.dialect.rules)(&self.memory.parameters);
            self.output.set_rules(self.rules.cutter);
            return Ok(());
        }
        if let Variable::CycleParameter(letter) = variable {
            return self.set_cycle_parameter(letter, value.unwrap_or(0.0));
        }
        let limit = match variable {
            Variable::ToolLength(_) | Variable::ToolRadius(_) => self.rules.max_offset,
            Variable::LengthWear(_) | Variable::RadiusWear(_) => self.rules.max_wear,
            Variable::WorkZero(..) => self.rules.max_zero,
            _ => return Err(Fault::VariableNotWritable),
        };
        let transformed = self.is_transformed() || self.location.polar.is_some();
        let value = value.unwrap_or(0.0);
        let value = match variable {
            Variable::WorkZero(_, index) => {
                units::coordinate(self.axis_number(index)?, value, self.inch_axes())
            }
            _ => units::length_mm(value, self.modal.is_inch()),
        };
        let tools = &mut self.memory.tools;
        let place = match variable {
            Variable::ToolLength(n) => tools.get_mut(n).map(|row| &mut row.length),
            Variable::LengthWear(n) => tools.get_mut(n).map(|row| &mut row.length_wear),
            Variable::ToolRadius(n) => tools.get_mut(n).map(|row| &mut row.radius),
            Variable::RadiusWear(n) => tools.get_mut(n).map(|row| &mut row.radius_wear),
            Variable::WorkZero(name, index) => {
                let axis = self.axis_number(index)?;
                self.memory.work.get_mut(name).map(|zero| &mut zero[axis])
            }
            _ => None,
        };
        let place = place.ok_or(Fault::VariableNotWritable)?;
        if transformed {
            return Err(Fault::OffsetInTransform);
        }
        if self.output.corner_waits() {
            return Err(Fault::CornerWithoutMove);
        }
        if value.is_nan() || value.abs() > limit {
            return Err(Fault::DataValue);
        }
        *place = value;
        self.work_zero_changed();
        Ok(())
    }

    /// Puts what variables have that stand for something else where they stand for it.
    fn place_variables(&mut self) -> Fallible<()> {
        let values: Vec<_> = self.memory.variables.iter().collect();
        for (number, value) in values {
            let variable = (self.dialect.variable)(number);
            if variable.is_none() || self.is_entered_by_hand(number) {
                continue;
            }
            // There is room for no value.
            let _ = self.memory.variables.set(number, None);
            self.store_at(variable, number, Some(value), Span::default())?;
        }
        Ok(())
    }

    /// `#3000 = n` and `G65 H99 Pn`: alarm n of the program (GSK990MC 4.9.4).
    fn program_alarm(&self, n: f64, span: Span) -> Box<Alarm> {
        if !(0.0..=999.0).contains(&n) {
            return self.alarm(Fault::WordOutOfRange, span);
        }
        let Some(first) = self.dialect.program_alarms else {
            return Box::new(Alarm::core(Fault::ProgramAlarm, span).with("detail", n.to_string()));
        };
        let id = AlarmId::Dialect(self.dialect.name, first.saturating_add(n as u16));
        Box::new(Alarm::new(id, Fault::ProgramAlarm, span))
    }

    /// Runs a statement.
    pub(crate) fn statement(&mut self, page: &Page, statement: Statement) -> Fallible<()> {
        let span = self.words.block_span();
        match statement {
            Statement::Assign { target, value } => self.assign(page, target, value, span),
            Statement::IfAssign { condition, target, value } => match self.holds(page, condition, span)? {
                true => self.assign(page, target, value, span),
                false => Ok(()),
            },
            Statement::Goto { condition, target } => {
                if let Some(condition) = condition
                    && !self.holds(page, condition, span)?
                {
                    return Ok(());
                }
                let number = self.evaluate_word(page, target).map_err(|fault| self.alarm(fault, span))?;
                self.go_to(number.unwrap_or(-1.0), Fault::SequenceMissing, span)
            }
            Statement::While { condition, .. } => {
                let holds = match condition {
                    Some(condition) => self.holds(page, condition, span)?,
                    None => true,
                };
                self.leave_or_enter_loop(holds, span)
            }
            Statement::EndWhile { .. } | Statement::EndWhileBlock => self.loop_again(span),
            Statement::WhileBlock { condition } => {
                let holds = self.holds(page, condition, span)?;
                self.leave_or_enter_loop(holds, span)
            }
            Statement::If { condition } => {
                let holds = self.holds(page, condition, span)?;
                self.take_branch(holds, span)
            }
            Statement::ElseIf { condition } if self.is_branch() => {
                let holds = self.holds(page, condition, span)?;
                self.take_branch(holds, span)
            }
            Statement::Else if self.is_branch() => Ok(()),
            // Reached from the branch before them, which is done.
            Statement::ElseIf { .. } | Statement::Else => self.leave_branches(span),
            Statement::EndIf => Ok(()),
            Statement::For { target, first, last, step } => {
                self.count_loop(page, [target, first, last], step, span)
            }
            Statement::EndFor => self.loop_again_counting(span),
            Statement::Break => self.leave_loop(span),
            Statement::Continue => self.next_pass(span),
            Statement::Directive(place) => self.directive(page, place, span),
            // Of languages that run their blocks themselves.
            Statement::OWord(_) => Err(self.alarm(Fault::MalformedStatement, span)),
        }
    }

    /// `$FOR`: starts to count, or counts on where its end was reached.
    fn count_loop(
        &mut self,
        page: &Page,
        [target, first, last]: [ExprRange; 3],
        step: Option<ExprRange>,
        span: Span,
    ) -> Fallible<()> {
        let arithmetic = self.dialect.arithmetic;
        let number = self.evaluate(page, target).and_then(|number| arithmetic.variable_number(number));
        let number = number.map_err(|fault| self.alarm(fault, span))?;
        let value = |interpreter: &mut Interpreter, range: ExprRange| -> Fallible<f64> {
            let value = interpreter.evaluate(page, range).map_err(|fault| interpreter.alarm(fault, span))?;
            Ok(value.unwrap_or(0.0))
        };
        let step = match step {
            Some(step) => value(self, step)?,
            None => 1.0,
        };
        let last = value(self, last)?;
        let next = match self.is_next_pass() {
            true => {
                self.read_variable(number).map_err(|fault| self.alarm(fault, span))?.unwrap_or(0.0) + step
            }
            false => value(self, first)?,
        };
        if step == 0.0 {
            return Err(self.alarm(Fault::InvalidLoop, span));
        }
        self.write_variable(number, Some(next), span)?;
        // A sum of steps may miss the last value by rounding.
        let rest = (last - next) * step.signum();
        self.leave_or_enter_loop(rest >= -step.abs() * 1e-9, span)
    }

    fn holds(&mut self, page: &Page, condition: ExprRange, span: Span) -> Fallible<bool> {
        let value = self.evaluate(page, condition).map_err(|fault| self.alarm(fault, span))?;
        Ok(value.is_some_and(|v| v != 0.0))
    }

    fn assign(&mut self, page: &Page, target: ExprRange, value: ExprRange, span: Span) -> Fallible<()> {
        let arithmetic = self.dialect.arithmetic;
        let number = self.evaluate(page, target).and_then(|number| arithmetic.variable_number(number));
        let number = number.map_err(|fault| self.alarm(fault, span))?;
        let value = self.evaluate(page, value).map_err(|fault| self.alarm(fault, span))?;
        self.write_variable(number, value, span)
    }

    /// The caller's local variables, kept while a macro has its own: the arguments, and empty ones.
    pub(crate) fn enter_locals(&mut self, arguments: &[(u32, f64)]) -> Locals {
        let kept = (1..=LAST_LOCAL).map(|n| self.memory.variables.get(n)).collect();
        self.memory.variables.clear(1..=LAST_LOCAL);
        for (number, value) in arguments {
            // Arguments are numbered from 1 to 26.
            let _ = self.memory.variables.set(*number, Some(*value));
        }
        kept
    }

    /// Puts the caller's local variables back.
    pub(crate) fn leave_locals(&mut self, locals: &Locals) {
        for (number, value) in (1..).zip(locals.iter()) {
            let _ = self.memory.variables.set(number, *value);
        }
        self.variable_writes += 1;
    }

    /// A block with G65: an operation or jump (macro A) where it has an H, else a macro call.
    pub(crate) fn macro_block(&mut self, page: &Page, block: &Block) -> Fallible<()> {
        let words = page.words(block);
        if let Some(m) = words.iter().find(|w| w.letter == b'M' && w.value() == WordValue::Number(99.0)) {
            return Err(self.alarm(Fault::ReturnWithMacro, page.word_span(block, m)));
        }
        let word = |letter: u8| words.iter().find(|word| word.letter == letter);
        match word(b'H') {
            Some(h) => {
                // Beside it stand its own words alone (4.9.2, 5).
                let call = WordValue::Number(f64::from(self.dialect.macro_call) / 10.0);
                let is_own = |w: &Word| match w.letter {
                    b'G' => w.value() == call,
                    letter => matches!(letter, b'O' | b'N' | b'H' | b'P' | b'Q' | b'R'),
                };
                if let Some(other) = words.iter().find(|w| !is_own(w)) {
                    return Err(self.alarm(Fault::MixedStatement, page.word_span(block, other)));
                }
                let again = |(at, w): (usize, &Word)| {
                    let own = matches!(w.letter, b'H' | b'P' | b'Q' | b'R');
                    own && words.iter().take(at).any(|before| before.letter == w.letter)
                };
                if self.rules.repeats_are_alarms
                    && let Some(at) = words.iter().enumerate().position(again)
                {
                    return Err(self.alarm(Fault::RepeatedAddress, page.word_span(block, &words[at])));
                }
                let operation = self.word_value(page, block, h)?.unwrap_or(0.0);
                let target = word(b'P');
                let q = self.operand(page, block, word(b'Q'))?;
                let r = self.operand(page, block, word(b'R'))?;
                self.macro_a(page, block, operation, target, q, r)
            }
            None => self.macro_call(page, block),
        }
    }

    fn word_value(&mut self, page: &Page, block: &Block, word: &Word) -> Fallible<Value> {
        match word.value() {
            WordValue::Number(number) => Ok(Some(number)),
            WordValue::Text(_) => Ok(None),
            WordValue::Expression(range) => self
                .evaluate_word(page, range)
                .map_err(|fault| self.alarm(fault, page.word_span(block, word))),
        }
    }

    fn operand(&mut self, page: &Page, block: &Block, word: Option<&Word>) -> Fallible<Value> {
        match word {
            Some(word) => self.word_value(page, block, word),
            // What is not given takes part as zero (4.9.4 note 2).
            None => Ok(Some(0.0)),
        }
    }

    /// G65 Hm P#i Q#j R#k (GSK990MC 4.9.4).
    fn macro_a(
        &mut self,
        page: &Page,
        block: &Block,
        operation: f64,
        target: Option<&Word>,
        q: Value,
        r: Value,
    ) -> Fallible<()> {
        let span = self.words.block_span();
        let code = if operation.fract() == 0.0 { operation as i64 } else { -1 };
        let arithmetic = self.dialect.arithmetic;
        if !arithmetic.has_operation(code) {
            return Err(self.alarm(Fault::UnknownOperation, span));
        }
        let Some(target) = target else { return Err(self.alarm(Fault::MalformedStatement, span)) };
        if let 80..=86 = code {
            if !arithmetic.jumps(code, q, r) {
                return Ok(());
            }
            let number = self.word_value(page, block, target)?;
            // The list of alarms has a number of its own for the jumps of macro A (0140).
            return self.go_to(number.unwrap_or(-1.0), Fault::JumpTargetMissing, span);
        }
        if code == 99 {
            let number = self.word_value(page, block, target)?.unwrap_or(0.0);
            return Err(self.program_alarm(number, span));
        }
        let number = self.variable_of(page, block, target)?;
        let own = self.read_variable(number).map_err(|fault| self.alarm(fault, span))?;
        let value = arithmetic.macro_a(code, own, q, r).map_err(|fault| self.alarm(fault, span))?;
        self.write_variable(number, value, span)
    }

    /// The number of the variable that a word names: 100 for `P#100`.
    fn variable_of(&mut self, page: &Page, block: &Block, word: &Word) -> Fallible<u32> {
        let span = page.word_span(block, word);
        let WordValue::Expression(range) = word.value() else {
            return Err(self.alarm(Fault::MalformedStatement, span));
        };
        match page.nodes(range) {
            [Node::VariableAt(number)] => Ok(*number),
            [.., Node::Variable] => {
                let inner = ExprRange { len: range.len - 1, ..range };
                let arithmetic = self.dialect.arithmetic;
                let number = self.evaluate(page, inner).and_then(|n| arithmetic.variable_number(n));
                number.map_err(|fault| self.alarm(fault, span))
            }
            _ => Err(self.alarm(Fault::MalformedStatement, span)),
        }
    }

    /// G65 P L and arguments (GSK990MC 4.9.3).
    fn macro_call(&mut self, page: &Page, block: &Block) -> Fallible<()> {
        let span = self.words.block_span();
        let mut program = None;
        let mut times = 1.0;
        let mut arguments: Vec<(u32, f64)> = Vec::with_capacity(26);
        let mut sets = (0, b'A');
        let call = f64::from(self.dialect.macro_call) / 10.0;
        let mut called = false;
        for word in page.words(block) {
            let word_span = page.word_span(block, word);
            let Some(value) = self.word_value(page, block, word)? else { continue };
            match word.letter {
                // Behind G65 it is one of the letters that are no argument (GSK990MC 4.9.2, 4 note 1; Fanuc 0i-M).
                b'N' if !called => {}
                b'G' if value == call => called = true,
                // Arguments follow G65, and no other code is among them (table 4-9-2-5 notes 1 and 2).
                b'G' => return Err(self.alarm(Fault::ArgumentAddress, word_span)),
                _ if !called => return Err(self.alarm(Fault::ArgumentAddress, word_span)),
                b'P' if program.is_some() && self.rules.repeats_are_alarms => {
                    return Err(self.alarm(Fault::RepeatedAddress, word_span));
                }
                b'P' => program = Some((value, word_span)),
                b'L' => {
                    times = value;
                    if let Some(fault) = self.repeats_fault(times) {
                        return Err(self.alarm(fault, word_span));
                    }
                }
                letter => {
                    let number = match letter {
                        b'I'..=b'K' if self.rules.arguments_in_sets => argument_of_set(letter, &mut sets),
                        _ => (self.dialect.argument)(letter),
                    };
                    let Some(number) = number else {
                        return Err(self.alarm(Fault::ArgumentAddress, word_span));
                    };
                    if arguments.iter().any(|(n, _)| *n == number) && self.rules.repeats_are_alarms {
                        return Err(self.alarm(Fault::RepeatedAddress, word_span));
                    }
                    arguments.push((number, value));
                }
            }
        }
        let Some((program, at)) = program else {
            return Err(self.alarm(Fault::CallWithoutProgram, span));
        };
        if program > 99_999.0 {
            return Err(self.alarm(Fault::ProgramNumberTooLarge, at));
        }
        if !(program >= 1.0) || program.fract() != 0.0 {
            return Err(self.alarm(Fault::ProgramNumber, at));
        }
        self.call(&ProgramId::Number(program as u32), times as u32, Some(&arguments), at)
    }

    /// A zero of the table of work coordinate systems was written: the system in force takes it over.
    pub(crate) fn work_zero_changed(&mut self) {
        use crate::stages::work_offset::{System, WorkSystem};
        if let System::Table(name) = self.location.work.system
            && let Some(system) = WorkSystem::select(name, &self.memory.work, &self.location.work)
            && system != self.location.work
        {
            self.location.work = system;
            self.location.take_machine();
        }
    }
}

/// The local variable of I, J or K where they may stand ten times behind G65 (Fanuc 0i-M): one that does not follow in the alphabet
/// begins the next set of three. `sets` is the number of sets before this one, and the letter before.
fn argument_of_set(letter: u8, sets: &mut (u32, u8)) -> Option<u32> {
    let (before, last) = *sets;
    let before = before + u32::from(letter <= last);
    *sets = (before, letter);
    (before < 10).then_some(4 + 3 * before + u32::from(letter - b'I'))
}
