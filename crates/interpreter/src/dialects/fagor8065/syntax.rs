//! How programs are written.

use super::variables::{FIRST_PARAMETER, PARAMETERS, VARIABLES};
use ferrocut_program::lexer::MAX_LINE;
use ferrocut_program::{Binary, Function, Keyword, Syntax};

/// Comments behind `;` or in brackets, parameters `P0`, variables `V.C.x`, keywords with `$`, directives
/// with `#`.
pub static SYNTAX: Syntax = Syntax {
    paren_comments: true,
    keywords: &[
        ("IF", Keyword::If),
        ("ELSEIF", Keyword::ElseIf),
        ("ELSE", Keyword::Else),
        ("ENDIF", Keyword::EndIf),
        ("FOR", Keyword::For),
        ("ENDFOR", Keyword::EndFor),
        ("WHILE", Keyword::While),
        ("ENDWHILE", Keyword::EndWhile),
        ("GOTO", Keyword::Goto),
        ("BREAK", Keyword::Break),
        ("CONTINUE", Keyword::Continue),
    ],
    functions: &[
        ("SIN", Function::Sin),
        ("COS", Function::Cos),
        ("TAN", Function::Tan),
        ("ASIN", Function::Asin),
        ("ACOS", Function::Acos),
        ("ATAN", Function::Atan),
        ("ABS", Function::Abs),
        ("SQRT", Function::Sqrt),
        ("LN", Function::Ln),
        ("DEXP", Function::Exp),
        ("ROUND", Function::Round),
        ("INT", Function::Fix),
        ("FUP", Function::Fup),
    ],
    operators: &[
        ("||", Binary::LogicalOr, 1),
        ("&&", Binary::LogicalAnd, 2),
        ("==", Binary::Equal, 3),
        ("!=", Binary::NotEqual, 3),
        (">=", Binary::GreaterEqual, 3),
        ("<=", Binary::LessEqual, 3),
        (">", Binary::Greater, 3),
        ("<", Binary::Less, 3),
        ("+", Binary::Add, 4),
        ("-", Binary::Subtract, 4),
        ("*", Binary::Multiply, 5),
        ("/", Binary::Divide, 5),
        ("MOD", Binary::Modulo, 5),
        ("EXP", Binary::Power, 6),
    ],
    max_line: MAX_LINE,
    max_brackets: 10,
    line_comments: &[b";"],
    equals_in_words: true,
    blanks_in_expressions: true,
    long_addresses: &[("NR", crate::words::long::NR)],
    long_values: true,
    named_variables: VARIABLES,
    variable_families: &[("P", FIRST_PARAMETER, PARAMETERS)],
    parameter_letter: Some(b'P'),
    keyword_sign: Some(b'$'),
    directives: true,
    numbered_axes: true,
    ..Syntax::WORDS
};
