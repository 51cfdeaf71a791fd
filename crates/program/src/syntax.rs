//! What differs between the texts of control languages, as data.

use crate::expression::{Binary, Function};

/// Words of the macro language.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[allow(missing_docs)]
pub enum Keyword {
    If,
    Then,
    Goto,
    While,
    Do,
    End,
    ElseIf,
    Else,
    EndIf,
    For,
    EndFor,
    EndWhile,
    Break,
    Continue,
}

/// How a control language writes its programs.
#[derive(Clone, Copy, Debug)]
pub struct Syntax {
    /// `( … )` is a comment.
    pub paren_comments: bool,
    /// `( … )` groups in expressions beside `[ … ]`. Where a block or statement may hold a comment,
    /// `paren_comments` comes first; behind an address or within an expression, this does.
    pub paren_groups: bool,
    /// Macro words, in upper case, 2 to 15 letters.
    pub keywords: &'static [(&'static str, Keyword)],
    /// Functions, in upper case, up to 15 letters.
    pub functions: &'static [(&'static str, Function)],
    /// Operators, in upper case, and how tightly they bind: larger binds tighter. Longer names of
    /// symbols (`>=`) stand before their beginnings (`>`). Equal bindings group to the left.
    pub operators: &'static [(&'static str, Binary, u8)],
    /// Bytes in a line, without its end, beyond which the control refuses it; what exceeds
    /// [`MAX_LINE`](crate::lexer::MAX_LINE) counts as that.
    pub max_line: usize,
    /// Levels of brackets that the control allows, those of functions included; what exceeds
    /// [`MAX_NESTING`](crate::expression::MAX_NESTING) counts as that.
    pub max_brackets: u8,
    /// What begins a comment that runs to the end of the line: the bytes of a sign, in each of the
    /// encodings that files come in.
    pub line_comments: &'static [&'static [u8]],
    /// Whether an expression behind an address stands behind `=`: `X=1+2`.
    pub equals_in_words: bool,
    /// Whether blanks may stand within an expression; else a blank ends it.
    pub blanks_in_expressions: bool,
    /// Whether a function may stand before a number or variable without brackets: `log6`.
    pub bare_arguments: bool,
    /// Whether `!` makes 1 of 0 and 0 of everything else.
    pub logical_not: bool,
    /// Whether a condition is malformed in which nothing is compared (GSK990MC 4.9.5).
    pub conditions_compare: bool,
    /// Whether `IF (…)` rules over the rest of its block, whatever that is.
    pub if_guards_block: bool,
    /// Whether a word may hold text, `P"name"`.
    pub texts: bool,
    /// The address of text that stands without one.
    pub text_address: Option<u8>,
    /// Addresses of several letters, in upper case, and the byte that stands for each in
    /// [`Word::letter`](crate::Word::letter), from `a` on. Behind one, what stands in `[…]` is text.
    pub long_addresses: &'static [(&'static str, u8)],
    /// Whether what stands in `[…]` behind one is an expression and no text.
    pub long_values: bool,
    /// Variables that have names, in upper case, and the numbers that they are kept by.
    pub named_variables: &'static [(&'static str, u32)],
    /// Variables of a name and a number, `#FC12`: name, number of the first, how many.
    pub variable_families: &'static [(&'static str, u32, u32)],
    /// The letter of arithmetic parameters, `P10`, which then are variables of that family without a sign
    /// before them; so are variables with names, `V.C.Z`. Several may be set in a line: each is a block.
    pub parameter_letter: Option<u8>,
    /// The sign of keywords, `$IF`. With it conditions and loops are lines of their own, closed by
    /// `$ENDIF`, `$ENDFOR`, `$ENDWHILE`; else they are those of the custom macro.
    pub keyword_sign: Option<u8>,
    /// Whether `#` begins a directive, `#TOOL AX [Z+]`, and no variable.
    pub directives: bool,
    /// Whether an axis may be called by a letter and a digit, `X2=25`.
    pub numbered_axes: bool,
    /// Whether lines are those of RS274/NGC: statements behind O words, parameters set beside words, blanks
    /// anywhere. Of the forms above it asks only for functions and operators.
    pub o_words: bool,
}

/// Letters of axes that may have a digit behind them.
const AXIS_LETTERS: &[u8; 9] = b"XYZABCUVW";

/// First byte of such axes in [`Word::letter`](crate::Word::letter).
pub const FIRST_NUMBERED: u8 = 0x80;

/// The byte that stands for an axis with a digit from 1 to 9, such as X2, in
/// [`Word::letter`](crate::Word::letter).
pub fn numbered_axis(letter: u8, digit: u8) -> Option<u8> {
    let place = AXIS_LETTERS.iter().position(|l| *l == letter.to_ascii_uppercase())?;
    let digit = digit.checked_sub(b'1').filter(|d| *d < 9)?;
    Some(FIRST_NUMBERED + place as u8 * 9 + digit)
}

/// Letter and digit of such a byte.
pub fn numbered_axis_name(byte: u8) -> Option<[u8; 2]> {
    let number = byte.checked_sub(FIRST_NUMBERED)?;
    let letter = AXIS_LETTERS.get(usize::from(number / 9))?;
    Some([*letter, b'1' + number % 9])
}

impl Syntax {
    /// Words only, no macro language: for tests and for scanning foreign files.
    pub const WORDS: Syntax = Syntax {
        paren_comments: true,
        paren_groups: false,
        keywords: &[],
        functions: &[],
        operators: &[
            ("+", Binary::Add, 1),
            ("-", Binary::Subtract, 1),
            ("*", Binary::Multiply, 2),
            ("/", Binary::Divide, 2),
        ],
        max_line: 4096,
        max_brackets: 5,
        line_comments: &[],
        equals_in_words: false,
        blanks_in_expressions: true,
        bare_arguments: false,
        logical_not: false,
        conditions_compare: false,
        if_guards_block: false,
        texts: false,
        text_address: None,
        long_addresses: &[],
        long_values: false,
        named_variables: &[],
        variable_families: &[],
        parameter_letter: None,
        keyword_sign: None,
        directives: false,
        numbered_axes: false,
        o_words: false,
    };

    pub(crate) fn keyword(&self, name: &[u8]) -> Option<Keyword> {
        find(self.keywords, name)
    }

    pub(crate) fn function(&self, name: &[u8]) -> Option<Function> {
        find(self.functions, name)
    }

    pub(crate) fn long_address(&self, name: &[u8]) -> Option<u8> {
        find(self.long_addresses, name)
    }

    /// The number that a variable with a name is kept by.
    pub fn variable(&self, name: &[u8]) -> Option<u32> {
        find(self.named_variables, name).or_else(|| {
            let digits = name.iter().rev().take_while(|b| b.is_ascii_digit()).count();
            let (family, index) = name.split_at_checked(name.len() - digits)?;
            let named = |(n, _, _): &&(&str, u32, u32)| n.as_bytes().eq_ignore_ascii_case(family);
            let (_, first, count) = self.variable_families.iter().find(named)?;
            let index: u32 = std::str::from_utf8(index).ok()?.parse().ok()?;
            (index < *count).then(|| first + index)
        })
    }

    /// What a variable is called, `#500`, `#FC12`.
    pub fn variable_name(&self, number: u32) -> String {
        let sign = if self.parameter_letter.is_some() { "" } else { "#" };
        if let Some((name, _)) = self.named_variables.iter().find(|(_, n)| *n == number) {
            return format!("{sign}{name}");
        }
        let of = |(_, first, count): &&(&str, u32, u32)| (*first..first + count).contains(&number);
        match self.variable_families.iter().find(of) {
            Some((family, first, _)) => format!("{sign}{family}{}", number - first),
            None => format!("#{number}"),
        }
    }
}

fn find<T: Copy>(table: &[(&str, T)], name: &[u8]) -> Option<T> {
    table.iter().find(|(n, _)| n.as_bytes().eq_ignore_ascii_case(name)).map(|(_, t)| *t)
}
