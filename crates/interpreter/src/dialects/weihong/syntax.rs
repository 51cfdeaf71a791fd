//! How Weihong programs are written (4.4 to 4.6, 5).

use super::variables::{FAMILIES, NAMES};
use crate::words::long;
use ferrocut_program::lexer::MAX_LINE;
use ferrocut_program::{Binary, Function, Keyword, Syntax};

/// 4.5 has seven ranks, from `||` and `&&` to brackets; equal ranks group to the left. There is no word of
/// the macro language but `IF`, which rules over the rest of its line (5).
pub static SYNTAX: Syntax = Syntax {
    paren_comments: false,
    paren_groups: true,
    keywords: &[("IF", Keyword::If)],
    functions: &[
        ("SIN", Function::Sin),
        ("COS", Function::Cos),
        ("EXP", Function::Exp),
        ("SQRT", Function::Sqrt),
        ("LOG", Function::Ln),
        ("TG", Function::Tan),
        ("CTG", Function::Cot),
        ("ASIN", Function::Asin),
        ("ACOS", Function::Acos),
        ("ATG", Function::Atan),
        ("INT", Function::Floor),
        ("ABS", Function::Abs),
    ],
    operators: &[
        ("||", Binary::LogicalOr, 1),
        ("&&", Binary::LogicalAnd, 1),
        ("==", Binary::Equal, 2),
        ("!=", Binary::NotEqual, 2),
        (">", Binary::Greater, 2),
        ("<", Binary::Less, 2),
        ("+", Binary::Add, 3),
        ("-", Binary::Subtract, 3),
        ("*", Binary::Multiply, 4),
        ("/", Binary::Divide, 4),
    ],
    max_line: MAX_LINE,
    max_brackets: 30,
    line_comments: QUOTES,
    equals_in_words: true,
    blanks_in_expressions: false,
    bare_arguments: true,
    logical_not: true,
    if_guards_block: true,
    texts: true,
    text_address: Some(long::MSG),
    long_addresses: &[
        ("MSG", long::MSG),
        ("PLC", long::PLC),
        ("LEVEL", long::LEVEL),
        ("FX", long::FX),
        ("FY", long::FY),
        ("FZ", long::FZ),
        ("PX", long::PX),
        ("PY", long::PY),
        ("PZ", long::PZ),
        ("LX", long::LX),
        ("LY", long::LY),
        ("LZ", long::LZ),
    ],
    named_variables: NAMES,
    variable_families: FAMILIES,
    ..Syntax::WORDS
};

/// The quote of a comment (4.6), and those that the manual's print and word processors put in its place:
/// ′ ’ ‘ „ ＇ ´, in UTF-8 and in GB18030.
const QUOTES: &[&[u8]] = &[
    b"'",
    "\u{2032}".as_bytes(),
    "\u{2019}".as_bytes(),
    "\u{2018}".as_bytes(),
    "\u{201e}".as_bytes(),
    "\u{ff07}".as_bytes(),
    "\u{b4}".as_bytes(),
    b"\xA1\xE4",
    b"\xA1\xAF",
    b"\xA1\xAE",
    b"\x81\x36\xA5\x37",
    b"\xA3\xA7",
    b"\x81\x30\x85\x37",
];
