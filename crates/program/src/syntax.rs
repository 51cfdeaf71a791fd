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
    };

    pub(crate) fn keyword(&self, name: &[u8]) -> Option<Keyword> {
        find(self.keywords, name)
    }

    pub(crate) fn function(&self, name: &[u8]) -> Option<Function> {
        find(self.functions, name)
    }
}

fn find<T: Copy>(table: &[(&str, T)], name: &[u8]) -> Option<T> {
    table.iter().find(|(n, _)| n.as_bytes().eq_ignore_ascii_case(name)).map(|(_, t)| *t)
}
