//! How programs are written.

use ferrocut_program::{Function, NGC_OPERATORS, Syntax};

/// LinuxCNC, G-code overview: functions and operators. Its program refuses a line of more than 252 bytes.
pub static SYNTAX: Syntax = Syntax {
    functions: &[
        ("ABS", Function::Abs),
        ("ACOS", Function::Acos),
        ("ASIN", Function::Asin),
        ("ATAN", Function::Atan),
        ("COS", Function::Cos),
        ("EXP", Function::Exp),
        ("EXISTS", Function::Exists),
        ("FIX", Function::Floor),
        ("FUP", Function::Ceil),
        ("LN", Function::Ln),
        ("ROUND", Function::Round),
        ("SIN", Function::Sin),
        ("SQRT", Function::Sqrt),
        ("TAN", Function::Tan),
    ],
    operators: NGC_OPERATORS,
    max_line: 252,
    o_words: true,
    ..Syntax::WORDS
};
