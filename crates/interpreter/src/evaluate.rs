//! Expressions to values.
//!
//! A value is a number or empty. An empty variable stays empty when it is only handed on; in
//! arithmetic it is 0 (GSK990MC 4.9.2). Angles are degrees or radians as the dialect says.

use crate::stages::rotation::sin_cos_degrees;
use ferrocut_machine::Fault;
use ferrocut_program::{Binary, Function, Node, Unary, expression::MAX_STACK};

/// A number, or `None` for empty.
pub type Value = Option<f64>;

/// Unit of angles in functions.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Angles {
    /// A full turn is 360.
    Degrees,
    /// A full turn is 2π.
    Radians,
}

impl Angles {
    fn of_radians(self, v: f64) -> f64 {
        match self {
            Angles::Degrees => v.to_degrees(),
            Angles::Radians => v,
        }
    }
}

/// What a control's arithmetic is like.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Arithmetic {
    /// Unit of angles in functions.
    pub angles: Angles,
    /// How finely values are told apart, as steps a unit: 10000 where the control counts in 0.0001. What is
    /// put into a variable is rounded to it, and numbers closer than that compare as equal and are as whole
    /// as their neighbour. 0 is as finely as can be.
    pub steps: f64,
    /// The largest result of EXP.
    pub largest_power: f64,
    /// The largest magnitude of what comes of a whole expression; on the way there it may be `LARGEST_RESULT`.
    pub largest_result: f64,
}

/// The largest result of Fanuc (its alarm 111, from which GSK990MC 0111 is).
const LARGEST_RESULT: f64 = 1e47;

/// Numbers from here on have no digits left behind those that are told apart.
const COARSE: f64 = 1e11;

impl Arithmetic {
    /// Angles in degrees, all digits that there are, and results up to Fanuc's largest.
    pub const EXACT: Arithmetic = Arithmetic {
        angles: Angles::Degrees,
        steps: 0.0,
        largest_power: f64::INFINITY,
        largest_result: LARGEST_RESULT,
    };

    /// The value as the control tells it from others.
    #[inline]
    pub fn rounded(self, v: f64) -> f64 {
        if self.steps > 0.0 && v.abs() < COARSE { (v * self.steps).round() / self.steps } else { v }
    }

    fn rounded_value(self, v: Value) -> Value {
        v.map(|v| self.rounded(v))
    }

    /// The number of a variable, given as a value. What stands behind the point is dropped
    /// (GSK990MC 4.9.5).
    pub fn variable_number(self, value: Value) -> Result<u32, Fault> {
        // An empty index is that of #0 (GSK990MC 4.9.2, 7).
        match Some(self.rounded(value.unwrap_or(0.0))) {
            Some(n) if n >= 0.0 && n <= f64::from(u32::MAX) => Ok(n as u32),
            _ => Err(Fault::UnknownVariable),
        }
    }
}

/// The stack that expressions are evaluated on; kept to spare its allocation.
#[derive(Clone, Debug)]
pub struct Evaluator {
    stack: Vec<Value>,
    arithmetic: Arithmetic,
}

impl Evaluator {
    /// An evaluator for one kind of arithmetic.
    pub fn new(arithmetic: Arithmetic) -> Evaluator {
        Evaluator { stack: Vec::with_capacity(MAX_STACK), arithmetic }
    }

    /// One that takes no memory, to stand in for another.
    pub fn empty(arithmetic: Arithmetic) -> Evaluator {
        Evaluator { stack: Vec::new(), arithmetic }
    }

    /// Value of an expression in postfix order. `read` gives the value of a variable by its number.
    pub fn value(
        &mut self,
        nodes: &[Node],
        mut read: impl FnMut(u32) -> Result<Value, Fault>,
    ) -> Result<Value, Fault> {
        self.stack.clear();
        let mut is_result = false;
        for node in nodes {
            is_result |= matches!(node, Node::Binary(_) | Node::Call(_));
            let value = match *node {
                Node::Number(n) => Some(n),
                Node::VariableAt(n) => read(n)?,
                Node::Variable => {
                    let number = self.pop()?;
                    read(self.arithmetic.variable_number(number)?)?
                }
                Node::Unary(op) => {
                    let v = self.pop()?.unwrap_or(0.0);
                    Some(match op {
                        Unary::Negate => -v,
                        Unary::Plus => v,
                        Unary::Not => truth(v == 0.0),
                    })
                }
                Node::Binary(op) => {
                    let b = self.pop()?;
                    let a = self.pop()?;
                    Some(self.arithmetic.binary(op, a, b)?)
                }
                Node::Call(Function::Atan2) => {
                    let b = self.pop()?.unwrap_or(0.0);
                    let a = self.pop()?.unwrap_or(0.0);
                    Some(atan2(a, b, self.arithmetic.angles)?)
                }
                Node::Exists(number) => Some(truth(read(number)?.is_some())),
                Node::Call(function) => {
                    let v = self.pop()?.unwrap_or(0.0);
                    Some(self.arithmetic.call(function, v)?)
                }
            };
            if self.stack.len() == MAX_STACK {
                return Err(Fault::BracketsTooDeep);
            }
            self.stack.push(value);
        }
        let value = self.pop()?;
        if is_result { self.arithmetic.result(value) } else { Ok(value) }
    }

    fn pop(&mut self) -> Result<Value, Fault> {
        self.stack.pop().ok_or(Fault::MalformedExpression)
    }
}

impl Arithmetic {
    /// Whether macro A has an operation with this number (GSK990MC table 4-9-4-1).
    pub fn has_operation(self, operation: i64) -> bool {
        matches!(operation, 1..=5 | 11..=13 | 21..=23 | 26 | 27 | 31..=34 | 80..=86 | 99)
    }

    /// Whether a jump H80 to H86 of macro A is taken.
    pub fn jumps(self, operation: i64, q: Value, r: Value) -> bool {
        let (a, b) = (self.rounded(q.unwrap_or(0.0)), self.rounded(r.unwrap_or(0.0)));
        match operation {
            80 => true,
            81 => self.rounded_value(q) == self.rounded_value(r),
            82 => self.rounded_value(q) != self.rounded_value(r),
            83 => a > b,
            84 => a < b,
            85 => a >= b,
            86 => a <= b,
            _ => false,
        }
    }

    /// The operations H01 to H34 of macro A (GSK990MC 4.9.4): the new value of a variable that holds `own`.
    pub fn macro_a(self, operation: i64, own: Value, q: Value, r: Value) -> Result<Value, Fault> {
        let (a, b) = (q.unwrap_or(0.0), r.unwrap_or(0.0));
        self.result(Some(match operation {
            1 => return Ok(q),
            2 => self.binary(Binary::Add, q, r)?,
            3 => self.binary(Binary::Subtract, q, r)?,
            4 => self.binary(Binary::Multiply, q, r)?,
            5 => self.binary(Binary::Divide, q, r)?,
            11 => self.binary(Binary::Or, q, r)?,
            12 => self.binary(Binary::And, q, r)?,
            13 => self.binary(Binary::Xor, q, r)?,
            21 => self.call(Function::Sqrt, a)?,
            22 => a.abs(),
            // Whole numbers only, as the manual notes for H23.
            23 => {
                self.binary(Binary::Modulo, Some(self.rounded(a).trunc()), Some(self.rounded(b).trunc()))?
            }
            26 => self.binary(Binary::Divide, Some(own.unwrap_or(0.0) * a), r)?,
            27 => a.hypot(b),
            31 => a * self.call(Function::Sin, b)?,
            32 => a * self.call(Function::Cos, b)?,
            33 => a * self.call(Function::Tan, b)?,
            34 => atan2(a, b, self.angles)?,
            _ => return Err(Fault::UnknownOperation),
        }))
    }

    /// Operands of AND, OR and XOR are whole numbers; what stands behind the point is dropped
    /// (GSK990MC 4.9.3, H11 to H13).
    fn whole(self, v: f64) -> Result<i64, Fault> {
        if v.abs() < 9e18 { Ok(self.rounded(v) as i64) } else { Err(Fault::ResultTooLarge) }
    }

    /// What comes of a whole expression or operation.
    fn result(self, value: Value) -> Result<Value, Fault> {
        let fits = value.is_none_or(|v| v.abs() <= self.largest_result);
        if fits { Ok(value) } else { Err(Fault::ResultTooLarge) }
    }

    /// An operator.
    fn binary(self, op: Binary, a: Value, b: Value) -> Result<f64, Fault> {
        // Empty differs from 0 only for EQ and NE (GSK990MC 4.9.2).
        match op {
            Binary::Equal => return Ok(truth(self.rounded_value(a) == self.rounded_value(b))),
            Binary::NotEqual => return Ok(truth(self.rounded_value(a) != self.rounded_value(b))),
            _ => {}
        }
        let (a, b) = (a.unwrap_or(0.0), b.unwrap_or(0.0));
        let (fine_a, fine_b) = (self.rounded(a), self.rounded(b));
        in_range(match op {
            Binary::Add => a + b,
            Binary::Subtract => a - b,
            Binary::Multiply => a * b,
            Binary::Divide | Binary::Modulo if b == 0.0 => return Err(Fault::DivisionByZero),
            Binary::Divide => a / b,
            Binary::Modulo => a % b,
            Binary::Power => {
                let v = a.powf(b);
                if v.is_nan() {
                    return Err(Fault::FunctionDomain);
                }
                v
            }
            Binary::And => (self.whole(a)? & self.whole(b)?) as f64,
            Binary::Or => (self.whole(a)? | self.whole(b)?) as f64,
            Binary::Xor => (self.whole(a)? ^ self.whole(b)?) as f64,
            Binary::Equal => truth(fine_a == fine_b),
            Binary::NotEqual => truth(fine_a != fine_b),
            Binary::Greater => truth(fine_a > fine_b),
            Binary::GreaterEqual => truth(fine_a >= fine_b),
            Binary::Less => truth(fine_a < fine_b),
            Binary::LessEqual => truth(fine_a <= fine_b),
            Binary::LogicalAnd => truth(a != 0.0 && b != 0.0),
            Binary::LogicalOr => truth(a != 0.0 || b != 0.0),
            Binary::LogicalXor => truth((a != 0.0) != (b != 0.0)),
        })
    }

    /// A function of one operand.
    fn call(self, function: Function, v: f64) -> Result<f64, Fault> {
        let within = |ok: bool| if ok { Ok(()) } else { Err(Fault::FunctionDomain) };
        in_range(match function {
            Function::Sin => sin_cos(v, self.angles).0,
            Function::Cos => sin_cos(v, self.angles).1,
            Function::Tan => {
                let (sin, cos) = sin_cos(v, self.angles);
                // GSK990MC alarm 0112 counts the tangent of 90 degrees as a division by zero.
                if cos == 0.0 {
                    return Err(Fault::DivisionByZero);
                }
                sin / cos
            }
            Function::Cot => {
                let (sin, cos) = sin_cos(v, self.angles);
                if sin == 0.0 {
                    return Err(Fault::DivisionByZero);
                }
                cos / sin
            }
            Function::Asin => {
                within(v.abs() <= 1.0)?;
                self.angles.of_radians(v.asin())
            }
            Function::Acos => {
                within(v.abs() <= 1.0)?;
                self.angles.of_radians(v.acos())
            }
            Function::Atan | Function::Atan2 => self.angles.of_radians(v.atan()),
            Function::Sqrt => {
                within(v >= 0.0)?;
                v.sqrt()
            }
            Function::Abs => v.abs(),
            Function::Round => self.rounded(v).round(),
            Function::Fix => self.rounded(v).trunc(),
            Function::Floor => self.rounded(v).floor(),
            Function::Ceil => self.rounded(v).ceil(),
            // Not a call: the lexer makes another node of it.
            Function::Exists => return Err(Fault::UnknownFunction),
            Function::Fup => self.rounded(v).abs().ceil().copysign(v),
            Function::Ln => {
                within(v > 0.0)?;
                v.ln()
            }
            Function::Exp => match v.exp() {
                power if power > self.largest_power => return Err(Fault::ResultTooLarge),
                power => power,
            },
            Function::Bin => bcd_to_number(self.whole(v)?)?,
            Function::Bcd => number_to_bcd(self.whole(v)?)?,
        })
    }
}

fn in_range(v: f64) -> Result<f64, Fault> {
    if v.abs() <= LARGEST_RESULT { Ok(v) } else { Err(Fault::ResultTooLarge) }
}

fn truth(condition: bool) -> f64 {
    f64::from(u8::from(condition))
}

/// Angle of the point (`b`, `a`), 0 to below a full turn, as ATAN[a]/[b] gives it.
fn atan2(a: f64, b: f64, angles: Angles) -> Result<f64, Fault> {
    if a == 0.0 && b == 0.0 {
        return Err(Fault::FunctionDomain);
    }
    let angle = a.atan2(b);
    let angle = if angle < 0.0 { angle + std::f64::consts::TAU } else { angle };
    Ok(angles.of_radians(angle))
}

fn sin_cos(v: f64, angles: Angles) -> (f64, f64) {
    match angles {
        Angles::Degrees => sin_cos_degrees(v),
        Angles::Radians => v.sin_cos(),
    }
}

/// Decimal digits packed in four bits each, as a number: 0x25 is 25.
fn bcd_to_number(v: i64) -> Result<f64, Fault> {
    let mut rest = v;
    if rest < 0 {
        return Err(Fault::FunctionDomain);
    }
    let (mut number, mut place) = (0i64, 1i64);
    while rest > 0 {
        let digit = rest & 0xF;
        if digit > 9 {
            return Err(Fault::FunctionDomain);
        }
        number += digit * place;
        place = place.saturating_mul(10);
        rest >>= 4;
    }
    Ok(number as f64)
}

fn number_to_bcd(v: i64) -> Result<f64, Fault> {
    let mut rest = v;
    // Eight digits fill the 32 bits that controls keep such numbers in.
    if !(0..=99_999_999).contains(&rest) {
        return Err(Fault::FunctionDomain);
    }
    let (mut packed, mut shift) = (0i64, 0);
    while rest > 0 {
        packed |= (rest % 10) << shift;
        rest /= 10;
        shift += 4;
    }
    Ok(packed as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    const EXACT: Arithmetic = Arithmetic::EXACT;

    fn value(nodes: &[Node]) -> Result<Value, Fault> {
        Evaluator::new(EXACT).value(nodes, |n| match n {
            0 => Ok(None),
            1 => Ok(Some(7.0)),
            _ => Err(Fault::UnknownVariable),
        })
    }

    #[test]
    fn empty_is_zero_in_arithmetic_and_differs_from_zero_in_equality() {
        use Node::{Binary as B, Number as N, VariableAt as V};
        assert_eq!(value(&[V(0)]), Ok(None));
        assert_eq!(value(&[V(0), N(5.0), B(Binary::Multiply)]), Ok(Some(0.0)));
        assert_eq!(value(&[V(0), N(0.0), B(Binary::Equal)]), Ok(Some(0.0)));
        assert_eq!(value(&[V(0), V(0), B(Binary::Equal)]), Ok(Some(1.0)));
        assert_eq!(value(&[V(0), N(0.0), B(Binary::GreaterEqual)]), Ok(Some(1.0)));
    }

    #[test]
    fn functions_have_their_domains() {
        use Node::{Binary as B, Call, Number as N};
        let of = |function, v| value(&[N(v), Call(function)]);
        assert_eq!(of(Function::Sin, 90.0), Ok(Some(1.0)));
        assert_eq!(of(Function::Cos, -270.0), Ok(Some(0.0)));
        assert_eq!(of(Function::Tan, 90.0), Err(Fault::DivisionByZero));
        assert_eq!(of(Function::Sqrt, -1.0), Err(Fault::FunctionDomain));
        assert_eq!(of(Function::Ln, 0.0), Err(Fault::FunctionDomain));
        assert_eq!(of(Function::Asin, 1.1), Err(Fault::FunctionDomain));
        assert_eq!(of(Function::Exp, 1000.0), Err(Fault::ResultTooLarge));
        assert_eq!(of(Function::Fup, -1.2), Ok(Some(-2.0)));
        assert_eq!(of(Function::Bin, 37.0), Ok(Some(25.0)));
        assert_eq!(of(Function::Bcd, 25.0), Ok(Some(37.0)));
        assert_eq!(value(&[N(-1.0), N(-1.0), Call(Function::Atan2)]), Ok(Some(225.0)));
        assert_eq!(value(&[N(1.0), N(0.0), B(Binary::Divide)]), Err(Fault::DivisionByZero));
        assert_eq!(value(&[N(12.0), N(10.0), B(Binary::Xor)]), Ok(Some(6.0)));
    }

    #[test]
    fn nodes_that_are_no_expression_are_an_error() {
        assert_eq!(value(&[]), Err(Fault::MalformedExpression));
        assert_eq!(value(&[Node::Binary(Binary::Add)]), Err(Fault::MalformedExpression));
        assert_eq!(value(&[Node::Number(-1.0), Node::Variable]), Err(Fault::UnknownVariable));
        assert_eq!(value(&[Node::Number(1.9), Node::Variable]), Ok(Some(7.0)));
    }
}
