//! Expressions as flat trees.
//!
//! A tree is kept in postfix order: operands before their operator. `1+2*#3` is
//! `1 2 3 Variable Multiply Add`. Evaluating is one pass over a slice with a small stack, without
//! recursion, and a tree costs no allocation of its own.

/// Operators with one operand.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Unary {
    /// `-x`
    Negate,
    /// `+x`: the value, which makes an empty variable a number.
    Plus,
    /// `!x`: 1 where x is 0, else 0.
    Not,
}

/// Operators with two operands.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[allow(missing_docs)]
pub enum Binary {
    Add,
    Subtract,
    Multiply,
    Divide,
    Modulo,
    Power,
    And,
    Or,
    Xor,
    Equal,
    NotEqual,
    Greater,
    GreaterEqual,
    Less,
    LessEqual,
    LogicalAnd,
    LogicalOr,
    LogicalXor,
}

impl Binary {
    /// Whether it tells which of two values is larger, or whether they are equal.
    pub fn compares(self) -> bool {
        use Binary::{Equal, Greater, GreaterEqual, Less, LessEqual, NotEqual};
        matches!(self, Equal | NotEqual | Greater | GreaterEqual | Less | LessEqual)
    }
}

/// Functions. Whether angles are degrees or radians is the dialect's.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[allow(missing_docs)]
pub enum Function {
    Sin,
    Cos,
    Tan,
    Cot,
    Asin,
    Acos,
    /// Of one value.
    Atan,
    /// Of two, `ATAN[a]/[b]`.
    Atan2,
    Sqrt,
    Abs,
    Round,
    /// Towards zero.
    Fix,
    /// Away from zero.
    Fup,
    /// Downwards.
    Floor,
    /// Upwards.
    Ceil,
    /// Whether a variable with a name exists; a [`Node::Exists`] in an expression.
    Exists,
    Ln,
    Exp,
    /// Decimal coded in binary to a number.
    Bin,
    /// A number to decimal coded in binary.
    Bcd,
}

/// One node of an expression in postfix order.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Node {
    /// A number.
    Number(f64),
    /// The variable with this number.
    VariableAt(u32),
    /// The variable whose number is the operand.
    Variable,
    /// An operator on the operand before it.
    Unary(Unary),
    /// An operator on the two operands before it.
    Binary(Binary),
    /// A function of the operand before it (two for [`Function::Atan2`]).
    Call(Function),
    /// 1 where the variable with this number has a value, else 0.
    Exists(u32),
}

/// Values that evaluating an expression of the parser may have on the stack at most.
///
/// Within a bracket one value a precedence can wait for its right operand, and one for the second
/// half of `ATAN[a]/[b]`. With [`MAX_NESTING`] brackets a language of up to 7 precedences never gets
/// here (30 · (7 + 1) + 7 + 1 = 248); the parser refuses what does.
pub const MAX_STACK: usize = 256;

/// Brackets, signs and `#` nested deeper than this, counted together, are a defect in every language.
pub const MAX_NESTING: u8 = 30;
