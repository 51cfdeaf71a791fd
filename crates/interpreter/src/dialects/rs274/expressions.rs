//! Expressions and parameters (NGC 3.3.2; LinuxCNC, parameters and expressions).
//!
//! Parameters with names are kept by the numbers of their names. Those of a subprogram's own are bound for as
//! long as it runs: a call notes what it hides, and its end puts that back, so that reading one is one look
//! and a call allocates nothing.

use super::parameters::{FIRST_SYSTEM_PARAMETER, READ_ONLY};
use super::rules::LAST_PARAMETER;
use crate::interpreter::Interpreter;
use ferrocut_machine::Fault;
use ferrocut_program::{Binary, ExprRange, FIRST_NAMED, Function, Node, Page, Unary};

/// Values that two comparisons tell apart, in units of the program (LinuxCNC: 0.0001).
const SAME: f64 = 1e-4;

/// Numbers of parameters, and codes, are as whole as a neighbour that is so close.
pub(super) const WHOLE: f64 = 1e-4;

/// Values of parameters with names.
#[derive(Clone, Default)]
pub(crate) struct Named {
    values: Vec<Binding>,
    /// What subprograms hide, to be put back when they end.
    hidden: Vec<(u32, Binding)>,
    /// How many were hidden when each of the subprograms began.
    marks: Vec<usize>,
    /// Levels of calls around the present block.
    depth: u32,
}

#[derive(Clone, Copy, Default)]
struct Binding {
    kind: Kind,
    /// Level that it is bound at, counted from 1; 0 where it has no value.
    depth: u32,
    value: f64,
}

/// Where a name is known.
#[derive(Clone, Copy, PartialEq, Eq, Default)]
enum Kind {
    /// Not looked at yet.
    #[default]
    Unknown,
    /// In one call of one subprogram.
    Local,
    /// Everywhere: it begins with `_`.
    Global,
}

impl Named {
    fn binding(&mut self, name: u32, text: impl FnOnce() -> bool) -> Option<&mut Binding> {
        let at = usize::try_from(name).ok()?;
        if self.values.len() <= at {
            self.values.resize(at + 1, Binding::default());
        }
        let binding = self.values.get_mut(at)?;
        if binding.kind == Kind::Unknown {
            binding.kind = if text() { Kind::Global } else { Kind::Local };
        }
        Some(binding)
    }

    /// Whether a name was given a value before.
    fn is_met(&self, name: u32) -> bool {
        let binding = usize::try_from(name).ok().and_then(|at| self.values.get(at));
        binding.is_some_and(|binding| binding.kind != Kind::Unknown)
    }

    /// The value of a name; none where it has none here.
    fn get(&self, name: u32) -> Option<f64> {
        let binding = self.values.get(usize::try_from(name).ok()?)?;
        let is_here = match binding.kind {
            Kind::Unknown => false,
            Kind::Global => binding.depth > 0,
            Kind::Local => binding.depth == self.depth + 1,
        };
        is_here.then_some(binding.value)
    }
}

impl Named {
    /// A subprogram begins: it has names of its own.
    pub(super) fn enter(&mut self) {
        self.depth += 1;
        self.marks.push(self.hidden.len());
    }

    /// Every subprogram ends.
    pub(super) fn leave_all(&mut self) {
        while !self.marks.is_empty() {
            self.leave();
        }
    }

    /// It ends: what it hid is back.
    pub(super) fn leave(&mut self) {
        let mark = self.marks.pop().unwrap_or(0);
        while self.hidden.len() > mark {
            let Some((name, was)) = self.hidden.pop() else { break };
            if let Some(binding) = usize::try_from(name).ok().and_then(|at| self.values.get_mut(at)) {
                *binding = was;
            }
        }
        self.depth = self.depth.saturating_sub(1);
    }
}

impl Interpreter {
    /// The value of an expression.
    #[inline]
    pub(super) fn ngc_value(&mut self, page: &Page, range: ExprRange) -> Result<f64, Fault> {
        let nodes = page.nodes(range);
        match nodes {
            [Node::Number(n)] => Ok(*n),
            [Node::VariableAt(n)] => self.ngc_parameter(*n),
            _ => {
                let mut stack = std::mem::take(&mut self.ngc.stack);
                stack.clear();
                let done = self.ngc_run(nodes, &mut stack);
                let value = stack.pop();
                self.ngc.stack = stack;
                done.and(value.ok_or(Fault::MalformedExpression))
            }
        }
    }

    /// The two values of a setting: number of the parameter, and what it is set to.
    pub(super) fn ngc_setting(&mut self, page: &Page, range: ExprRange) -> Result<(u32, f64), Fault> {
        let nodes = page.nodes(range);
        // A name exists from here on, in its own value too: 0 until it has one.
        if let Some(Node::Number(n)) = nodes.first()
            && *n >= f64::from(FIRST_NAMED)
            && !self.ngc_exists(*n as u32)
        {
            self.ngc_set(*n as u32, 0.0)?;
        }
        let mut stack = std::mem::take(&mut self.ngc.stack);
        stack.clear();
        let done = self.ngc_run(nodes, &mut stack);
        let (value, number) = (stack.pop(), stack.pop());
        self.ngc.stack = stack;
        done?;
        match (number, value) {
            (Some(number), Some(value)) => Ok((parameter_number(number)?, value)),
            _ => Err(Fault::MalformedExpression),
        }
    }

    fn ngc_run(&mut self, nodes: &[Node], stack: &mut Vec<f64>) -> Result<(), Fault> {
        fn pop(stack: &mut Vec<f64>) -> Result<f64, Fault> {
            stack.pop().ok_or(Fault::MalformedExpression)
        }
        for node in nodes {
            let value = match *node {
                Node::Number(n) => n,
                Node::VariableAt(n) => self.ngc_parameter(n)?,
                Node::Variable => {
                    let number = pop(stack)?;
                    self.ngc_parameter(parameter_number(number)?)?
                }
                Node::Exists(n) => truth(self.ngc_exists(n)),
                Node::Unary(Unary::Negate) => -pop(stack)?,
                Node::Unary(Unary::Plus) => pop(stack)?,
                Node::Unary(Unary::Not) => truth(pop(stack)? == 0.0),
                Node::Binary(operator) => {
                    let b = pop(stack)?;
                    let a = pop(stack)?;
                    binary(operator, a, b)?
                }
                Node::Call(Function::Atan2) => {
                    let b = pop(stack)?;
                    let a = pop(stack)?;
                    a.atan2(b).to_degrees()
                }
                Node::Call(function) => call(function, pop(stack)?)?,
            };
            // What is no number, or none that can be written, is no value (LinuxCNC).
            if !value.is_finite() {
                return Err(Fault::ResultTooLarge);
            }
            stack.push(value);
        }
        Ok(())
    }

    /// The value of a parameter.
    #[inline]
    pub(super) fn ngc_parameter(&mut self, number: u32) -> Result<f64, Fault> {
        if number < FIRST_NAMED {
            return match number {
                1..FIRST_SYSTEM_PARAMETER => Ok(self.memory.variables.get(number).unwrap_or(0.0)),
                FIRST_SYSTEM_PARAMETER..=LAST_PARAMETER => Ok(self
                    .ngc_system_parameter(number)
                    .unwrap_or_else(|| self.memory.variables.get(number).unwrap_or(0.0))),
                _ => Err(Fault::UnknownVariable),
            };
        }
        self.ngc_named(number - FIRST_NAMED).ok_or(Fault::UnknownVariable)
    }

    /// The value of a name.
    fn ngc_named(&self, name: u32) -> Option<f64> {
        if let Some(value) = self.ngc.named.get(name) {
            return Some(value);
        }
        self.ngc_predefined(self.programs.names().text(name)?)
    }

    fn ngc_exists(&self, number: u32) -> bool {
        match number.checked_sub(FIRST_NAMED) {
            Some(name) => self.ngc_named(name).is_some(),
            None => (1..=LAST_PARAMETER).contains(&number),
        }
    }

    /// Gives a parameter a value.
    pub(super) fn ngc_set(&mut self, number: u32, value: f64) -> Result<(), Fault> {
        self.variable_writes += 1;
        if number < FIRST_NAMED {
            if !(1..=LAST_PARAMETER).contains(&number) {
                return Err(Fault::UnknownVariable);
            }
            if READ_ONLY.contains(&number) {
                return Err(Fault::VariableNotWritable);
            }
            if number >= FIRST_SYSTEM_PARAMETER {
                self.ngc_set_system_parameter(number, value);
            }
            return self.memory.variables.set(number, Some(value)).map_err(|_| Fault::UnknownVariable);
        }
        let name = number - FIRST_NAMED;
        // Names of the language are looked for once: behind that the binding tells.
        if !self.ngc.named.is_met(name)
            && let Some(text) = self.programs.names().text(name)
            && self.ngc_predefined(text).is_some()
        {
            return Err(Fault::VariableNotWritable);
        }
        let named = &mut self.ngc.named;
        let depth = named.depth + 1;
        let programs = &self.programs;
        let is_global = || programs.names().text(name).is_some_and(|text| text.starts_with('_'));
        let Some(binding) = named.binding(name, is_global) else { return Err(Fault::UnknownVariable) };
        let was = *binding;
        binding.value = value;
        if binding.kind == Kind::Global {
            binding.depth = 1;
        } else if binding.depth != depth {
            binding.depth = depth;
            named.hidden.push((name, was));
        }
        Ok(())
    }
}

/// The number of a parameter, given as a value.
pub(super) fn parameter_number(value: f64) -> Result<u32, Fault> {
    let whole = value.round();
    match (value - whole).abs() <= WHOLE && (0.0..=f64::from(u32::MAX)).contains(&whole) {
        true => Ok(whole as u32),
        false => Err(Fault::UnknownVariable),
    }
}

fn truth(condition: bool) -> f64 {
    f64::from(u8::from(condition))
}

/// Comparisons tell values apart from 0.0001 on.
fn binary(operator: Binary, a: f64, b: f64) -> Result<f64, Fault> {
    Ok(match operator {
        Binary::Add => a + b,
        Binary::Subtract => a - b,
        Binary::Multiply => a * b,
        Binary::Divide if b == 0.0 => return Err(Fault::DivisionByZero),
        Binary::Divide => a / b,
        Binary::Modulo => {
            // Never negative.
            let rest = a % b;
            if rest < 0.0 { rest + b.abs() } else { rest }
        }
        Binary::Power if a < 0.0 && b.fract() != 0.0 => return Err(Fault::FunctionDomain),
        Binary::Power => a.powf(b),
        Binary::Equal => truth((a - b).abs() < SAME),
        Binary::NotEqual => truth((a - b).abs() >= SAME),
        Binary::Greater => truth(a > b),
        Binary::GreaterEqual => truth(a >= b),
        Binary::Less => truth(a < b),
        Binary::LessEqual => truth(a <= b),
        Binary::LogicalAnd | Binary::And => truth(a != 0.0 && b != 0.0),
        Binary::LogicalOr | Binary::Or => truth(a != 0.0 || b != 0.0),
        Binary::LogicalXor | Binary::Xor => truth((a != 0.0) != (b != 0.0)),
    })
}

fn call(function: Function, v: f64) -> Result<f64, Fault> {
    let within = |holds: bool| if holds { Ok(()) } else { Err(Fault::FunctionDomain) };
    Ok(match function {
        Function::Abs => v.abs(),
        Function::Acos => {
            within(v.abs() <= 1.0)?;
            v.acos().to_degrees()
        }
        Function::Asin => {
            within(v.abs() <= 1.0)?;
            v.asin().to_degrees()
        }
        Function::Cos => v.to_radians().cos(),
        Function::Sin => v.to_radians().sin(),
        Function::Tan => v.to_radians().tan(),
        Function::Exp => v.exp(),
        Function::Floor => v.floor(),
        Function::Ceil => v.ceil(),
        Function::Round => v.round(),
        Function::Ln => {
            within(v > 0.0)?;
            v.ln()
        }
        Function::Sqrt => {
            within(v >= 0.0)?;
            v.sqrt()
        }
        _ => return Err(Fault::UnknownFunction),
    })
}
