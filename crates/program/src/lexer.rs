//! Text to blocks, one page at a time, in one pass over the bytes.
//!
//! Lexing never fails. What cannot be read becomes a [`Defect`] of its block, and reading goes on
//! behind it, so that a checker sees every fault of a program and not only the first.
//!
//! The bytes are not decoded first: addresses, numbers and signs are ASCII in every encoding that
//! programs come in, and neither UTF-8 nor GB18030 uses the bytes of `)`, `;` or a line end inside a
//! longer character. Other text stands in comments, which are skipped.
//!
//! Work and memory are proportional to the text, whatever it holds: what looks ahead is bounded, and
//! so is recursion ([`MAX_NESTING`], [`MAX_STACK`]).

use crate::expression::{Binary, Function, MAX_NESTING, MAX_STACK, Node, Unary};
use crate::names::Names;
use crate::number;
use crate::page::{
    Argument, Block, Defect, DefectKind, Directive, ExprRange, Page, Statement, TextRange, Word,
};
use crate::span::FileId;
use crate::syntax::{Keyword, Syntax, numbered_axis};

mod ngc;

pub use ngc::NGC_OPERATORS;

/// Words in a block beyond which it is refused; no control takes nearly as many.
const MAX_WORDS: usize = 512;

/// Bytes read by one call of [`lex`]. The shortest statement with its end of block (`DO1;`) takes four
/// bytes, so that the index of a statement fits its 16 bits.
pub const MAX_TEXT: usize = 4 << 16;

/// Bytes of a line beyond which it is refused whatever the syntax allows: the length of a word fits
/// 16 bits, and a line with its end (CR LF) fits a page.
pub const MAX_LINE: usize = (1 << 16) - 2;

/// Letters of a name that are looked at; names of keywords and functions are shorter.
const LONGEST_NAME: usize = 16;

/// Words of Fanuc's custom macro, which programs bring along to controls that lack them.
const MACRO_WORDS: [&[u8]; 6] = [b"THEN", b"ELSE", b"GOTO", b"WHILE", b"DO", b"END"];

/// Bytes of an over-long line that its defect underlines.
const UNDERLINED: usize = 80;

/// What [`lex`] read.
pub struct Lexed {
    /// The blocks.
    pub page: Page,
    /// Bytes read; they end with a line end, with the file, or as [`Lexed::is_cut`] tells.
    pub consumed: usize,
    /// Line at which the text behind the bytes read starts, counted from 1.
    pub next_line: u32,
    /// Whether the bytes read end within an over-long line, whose rest belongs to no block.
    pub is_cut: bool,
}

/// Where in a file a page starts.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Start {
    pub(crate) file: FileId,
    /// Offset in the file, bytes.
    pub(crate) offset: u64,
    /// Line, counted from 1.
    pub(crate) line: u32,
    /// Whether the file has no block before: a `%` here opens the program and does not close it.
    pub(crate) is_head: bool,
}

/// Lexes whole lines of `text`, which stands in `file` at `offset` (bytes) and starts line `line`
/// (counted from 1; in line 1 nothing stands before it).
///
/// `is_last` tells that the file ends where `text` ends; else only lines that are closed are read.
/// At most [`MAX_TEXT`] bytes are read; call again for more. A `text` without any line end that is not
/// the last is the start of one over-long line: it is consumed and becomes one defective block.
pub fn lex(text: &[u8], file: FileId, offset: u64, line: u32, is_last: bool, syntax: &Syntax) -> Lexed {
    let start = Start { file, offset, line, is_head: line == 1 };
    lex_from(text, start, is_last, syntax, &mut Names::default())
}

/// The same with the names met before in other pages.
pub(crate) fn lex_from(
    text: &[u8],
    start: Start,
    is_last: bool,
    syntax: &Syntax,
    names: &mut Names,
) -> Lexed {
    let (text, is_last) = match text.get(..MAX_TEXT) {
        Some(first) if text.len() > MAX_TEXT => (first, false),
        _ => (text, is_last),
    };
    let end_of_lines = if is_last { Some(text.len()) } else { end_of_lines(text) };
    // A CR that ends the text may be the first half of CR LF: leave it with what follows.
    let end = end_of_lines.unwrap_or(text.len() - usize::from(text.ends_with(b"\r")));
    let page = Page { file: start.file, offset: start.offset, ..Page::default() };
    let mut lexer = Lexer {
        text: text.get(..end).unwrap_or(text),
        at: 0,
        line: start.line,
        line_start: 0,
        is_head: start.is_head,
        syntax,
        names,
        page,
        skip: 0,
    };
    lexer.run();
    let is_cut = end_of_lines.is_none() && end > 0;
    if is_cut {
        lexer.refuse_line();
    }
    Lexed { page: lexer.page, consumed: end, next_line: lexer.line, is_cut }
}

/// Length of the part of `text` that ends with a line end; `None` where it has none.
fn end_of_lines(text: &[u8]) -> Option<usize> {
    let last = text.iter().rposition(|b| *b == b'\n').or_else(|| {
        // A file with CR alone. The last byte may be the first half of CR LF: leave it.
        text.get(..text.len().saturating_sub(1))?.iter().rposition(|b| *b == b'\r')
    });
    last.map(|at| at + 1)
}

/// What text stands between, opening and closing: ASCII quotes, and the typographic ones in UTF-8 and in
/// GB18030, which print and office programs put in their place.
const QUOTES: &[(&[u8], &[u8])] =
    &[(b"\"", b"\""), ("\u{201c}".as_bytes(), "\u{201d}".as_bytes()), (b"\xA1\xB0", b"\xA1\xB1")];

/// The brackets of an address of the ladder, `PLC[04]`.
const BRACKETS: (&[u8], &[u8]) = (b"[", b"]");

/// A defect whose block is not known yet: kind, offset, length.
struct Flaw(DefectKind, usize, usize);

/// How deep in an expression the parser is.
#[derive(Clone, Copy, Default)]
struct Depth {
    /// Signs, brackets and `#` around the present place.
    nesting: u8,
    /// The brackets among them.
    brackets: u8,
    /// Values on the evaluator's stack when it comes here.
    values: usize,
}

impl Depth {
    /// Behind a sign, bracket or `#` that stands at `at`.
    fn nested(self, at: usize) -> Result<Depth, Flaw> {
        if self.nesting >= MAX_NESTING {
            return Err(Flaw(DefectKind::BracketsTooDeep, at, 1));
        }
        Ok(Depth { nesting: self.nesting + 1, ..self })
    }

    /// With one more value on the stack.
    fn with_value(self) -> Depth {
        Depth { values: self.values + 1, ..self }
    }
}

struct Lexer<'a> {
    text: &'a [u8],
    at: usize,
    line: u32,
    line_start: usize,
    is_head: bool,
    syntax: &'a Syntax,
    names: &'a mut Names,
    page: Page,
    /// The `/` of a line of which a block was read already; 0 at the start of a line.
    skip: u8,
}

impl Lexer<'_> {
    fn run(&mut self) {
        while self.at < self.text.len() {
            match self.syntax.o_words {
                true => self.ngc_block(),
                false => self.block(),
            }
        }
        self.check_line_length();
    }

    #[inline]
    fn peek(&self) -> u8 {
        // 0 stands for the end of the text as well as for a zero byte in it, which is padding.
        self.text.get(self.at).copied().unwrap_or(0)
    }

    #[inline]
    fn byte_at(&self, at: usize) -> u8 {
        self.text.get(at).copied().unwrap_or(0)
    }

    #[inline]
    fn skip_blanks(&mut self) {
        while matches!(self.peek(), b' ' | b'\t') {
            self.at += 1;
        }
    }

    /// Skips blanks where they may stand within an expression.
    #[inline]
    fn skip_inner_blanks(&mut self) {
        if self.syntax.blanks_in_expressions {
            self.skip_blanks();
        }
    }

    fn at_end_of_block(&self) -> bool {
        self.at >= self.text.len() || matches!(self.peek(), b'\n' | b'\r' | b';')
    }

    /// Reads the end of a block and counts lines.
    fn end_of_block(&mut self) {
        match self.peek() {
            b'\n' => self.new_line(1),
            b'\r' if self.byte_at(self.at + 1) == b'\n' => self.new_line(2),
            b'\r' => self.new_line(1),
            _ if self.starts_line_comment() => self.skip_line(),
            _ => self.at += 1,
        }
    }

    fn new_line(&mut self, len: usize) {
        self.check_line_length();
        self.at += len;
        self.line = self.line.saturating_add(1);
        self.line_start = self.at;
    }

    fn check_line_length(&mut self) {
        if self.at.min(self.text.len()) - self.line_start > self.syntax.max_line.min(MAX_LINE) {
            self.refuse_line();
        }
    }

    /// Puts one defective block in the place of what was read of this line.
    fn refuse_line(&mut self) {
        let start = self.line_start as u32;
        let len = self.at.min(self.text.len()) - self.line_start;
        let number = self.page.blocks.partition_point(|b| b.at < start);
        if let Some(first) = self.page.blocks.get(number) {
            self.page.words.truncate(first.first_word as usize);
            self.page.blocks.truncate(number);
            let others = self.page.defects.partition_point(|d| (d.block as usize) < number);
            self.page.defects.truncate(others);
        }
        self.page.blocks.push(Block {
            at: start,
            len: len as u32,
            line: self.line,
            first_word: self.page.words.len() as u32,
            is_defective: true,
            ..Block::default()
        });
        self.flaw(number as u32, Flaw(DefectKind::LineTooLong, self.line_start, len.min(UNDERLINED)));
    }

    /// Reads one block and its end.
    fn block(&mut self) {
        self.skip_blanks();
        let start = self.at;
        let first_word = self.page.words.len();
        let first_defect = self.page.defects.len();
        let number = self.page.blocks.len() as u32;
        let line = self.line;
        let mut skip = self.skip;
        let mut is_split = false;
        let mut statement = None;
        let mut guard = None;
        let mut is_mark = false;
        let mut text_end = start;
        loop {
            let byte = self.peek();
            match byte {
                b'P' | b'p' | b'V' | b'v'
                    if self.syntax.parameter_letter.is_some() && self.starts_assignment() =>
                {
                    if statement.is_some() || !self.only_sequence_number(first_word) {
                        is_split = true;
                        break;
                    }
                    statement = self.statement(number, first_word);
                    text_end = self.at;
                }
                b'A'..=b'Z' | b'a'..=b'z'
                    if statement.is_some() && self.syntax.parameter_letter.is_some() =>
                {
                    is_split = true;
                    break;
                }
                b'A'..=b'Z' | b'a'..=b'z' => {
                    match self.byte_at(self.at + 1).is_ascii_alphabetic() {
                        true => self.name(number, first_word, &mut statement, &mut guard),
                        false => self.word(number, first_word, false),
                    }
                    text_end = self.at;
                }
                b' ' | b'\t' => self.at += 1,
                _ if is_padding(byte) && self.at < self.text.len() => self.at += 1,
                b';' if self.starts_line_comment() => self.skip_line(),
                b'\n' | b'\r' | b';' => break,
                b'(' if self.syntax.paren_comments => {
                    if !self.comment(number) {
                        text_end = self.at;
                    }
                }
                b'/' if self.only_sequence_number(first_word) => {
                    skip = skip.saturating_add(1);
                    self.at += 1;
                    // Fanuc's /1 to /9 choose a switch; one is enough to skip by.
                    if self.peek().is_ascii_digit() {
                        self.at += 1;
                    }
                    text_end = self.at;
                }
                b'#' => {
                    statement = self.statement(number, first_word);
                    text_end = self.at;
                }
                b',' if self.is_before_letter() => {
                    self.word(number, first_word, true);
                    text_end = self.at;
                }
                b'%' if self.page.words.len() == first_word && skip == 0 => {
                    is_mark = !(self.is_head && self.page.blocks.is_empty());
                    text_end = self.at + 1;
                    self.skip_rest_of_block();
                }
                _ if self.at >= self.text.len() => break,
                _ if Some(byte) == self.syntax.keyword_sign => {
                    statement = self.statement(number, first_word);
                    text_end = self.at;
                }
                b':' if self.syntax.keyword_sign.is_some() && self.has_sequence_number(first_word) => {
                    self.at += 1;
                    text_end = self.at;
                }
                _ if self.starts_line_comment() => self.skip_line(),
                _ if self.syntax.text_address.is_some() && self.opening_quote() > 0 => {
                    self.text_word(number, self.syntax.text_address.unwrap_or(0), self.at);
                    text_end = self.at;
                }
                _ => {
                    self.stray(number, byte);
                    text_end = self.at;
                }
            }
        }
        let is_defective = self.page.defects.len() > first_defect;
        let says_nothing = self.page.words.len() == first_word && statement.is_none() && guard.is_none();
        if !says_nothing || skip > 0 || is_mark || is_defective {
            let words = (self.page.words.len() - first_word) as u16;
            let len = (text_end.max(start) - start) as u32;
            self.page.blocks.push(Block {
                at: start as u32,
                len,
                line,
                first_word: first_word as u32,
                words,
                skip,
                is_mark,
                is_defective,
                statement,
                guard,
            });
        }
        self.skip = if is_split { skip } else { 0 };
        if self.at < self.text.len() && !is_split {
            self.end_of_block();
        }
    }

    /// Whether nothing but an N word, or nothing, was read of this block.
    fn only_sequence_number(&self, first_word: usize) -> bool {
        match self.page.words.get(first_word..) {
            Some([]) => true,
            Some([word]) => word.letter == b'N' && !word.has_comma(),
            _ => false,
        }
    }

    /// Whether an N word, and nothing else, was read of this block.
    fn has_sequence_number(&self, first_word: usize) -> bool {
        self.page.words.len() > first_word && self.only_sequence_number(first_word)
    }

    fn flaw(&mut self, block: u32, Flaw(kind, at, mut len): Flaw) {
        // Bytes outside ASCII are parts of characters, which stay whole.
        let is_foreign = |at: usize| self.text.get(at).is_some_and(|byte| *byte >= 0x80);
        while len > 0 && is_foreign(at + len - 1) && is_foreign(at + len) {
            len += 1;
        }
        self.page.defects.push(Defect { block, kind, at: at as u32, len: len as u32 });
    }

    /// Skips what is left of a block that cannot be read further.
    fn skip_rest_of_block(&mut self) {
        while !self.at_end_of_block() {
            if self.starts_line_comment() {
                return self.skip_line();
            }
            self.at += 1;
        }
    }

    /// Whether a comment to the end of the line begins here.
    fn starts_line_comment(&self) -> bool {
        let rest = self.text.get(self.at..).unwrap_or(&[]);
        self.syntax.line_comments.iter().any(|sign| rest.starts_with(sign))
    }

    /// Skips to the end of the line, over every end of block in it.
    fn skip_line(&mut self) {
        while self.at < self.text.len() && !matches!(self.peek(), b'\n' | b'\r') {
            self.at += 1;
        }
    }

    /// Length of the quote that opens text here; 0 where there is none.
    fn opening_quote(&self) -> usize {
        let rest = self.text.get(self.at..).unwrap_or(&[]);
        QUOTES
            .iter()
            .find(|(open, _)| self.syntax.texts && rest.starts_with(open))
            .map_or(0, |(o, _)| o.len())
    }

    /// Reads text between quotes, or in brackets, as the value of the word that started at `start`.
    fn text_word(&mut self, block: u32, letter: u8, start: usize) {
        let rest = self.text.get(self.at..).unwrap_or(&[]);
        let Some((open, close)) = QUOTES.iter().chain([&BRACKETS]).find(|(o, _)| rest.starts_with(o)) else {
            return;
        };
        let inner = rest.get(open.len()..).unwrap_or(&[]);
        let line = inner.iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(inner.len());
        let end = |sign: &[u8]| (0..line).find(|at| inner.get(*at..).is_some_and(|i| i.starts_with(sign)));
        let from = self.at + open.len();
        match end(close) {
            Some(len) => {
                self.at = from + len + close.len();
                let text = TextRange { at: from as u32, len: len as u32 };
                let len = self.word_len(start);
                self.page.words.push(Word::text(letter, text, start as u32, len));
            }
            None => {
                self.flaw(block, Flaw(DefectKind::UnclosedText, start, from + line - start));
                self.at = from + line;
            }
        }
    }

    /// What a run of letters begins: a statement, a guard, an address of several letters, or words whose
    /// values are missing.
    fn name(&mut self, block: u32, first_word: usize, statement: &mut Option<u16>, guard: &mut Option<u16>) {
        let name = self.letters();
        let keyword = if self.syntax.keyword_sign.is_none() { self.syntax.keyword(name) } else { None };
        match keyword {
            Some(Keyword::If) if self.syntax.if_guards_block => {
                *guard = self.guard(block, first_word, *guard)
            }
            Some(_) => *statement = self.statement(block, first_word),
            None => match self.long_address(name) {
                Some((letter, len)) => self.long_word(block, letter, len, first_word),
                None if MACRO_WORDS.iter().any(|word| word.eq_ignore_ascii_case(name)) => {
                    let flaw = Flaw(DefectKind::MalformedStatement, self.at, name.len());
                    self.flaw(block, flaw);
                    self.skip_rest_of_block();
                }
                None => self.word(block, first_word, false),
            },
        }
    }

    /// The address of several letters that a run of letters is, or is but for the parameter behind it (`NRP1`), and its length.
    fn long_address(&self, name: &[u8]) -> Option<(u8, usize)> {
        let whole = self.syntax.long_address(name).map(|letter| (letter, name.len()));
        whole.or_else(|| {
            let (_, short) = name.split_last().filter(|_| self.syntax.long_values)?;
            let letter = self.syntax.long_address(short)?;
            self.is_parameter(self.at + short.len()).then_some((letter, short.len()))
        })
    }

    /// Reads `IF (…)` before what it rules over. It stands first in its block, and once.
    fn guard(&mut self, block: u32, first_word: usize, before: Option<u16>) -> Option<u16> {
        let start = self.at;
        let mixed = before.is_some() || !self.only_sequence_number(first_word);
        self.at += self.letters().len();
        let flaw = match self.condition() {
            Ok(_) if mixed => Flaw(DefectKind::MixedStatement, start, self.at - start),
            Ok(condition) => {
                self.page.guards.push(condition);
                return u16::try_from(self.page.guards.len() - 1).ok();
            }
            Err(flaw) => flaw,
        };
        self.flaw(block, flaw);
        self.skip_rest_of_block();
        None
    }

    /// Reads the value of an address of several letters: a number, `=` and an expression, or text.
    fn long_word(&mut self, block: u32, letter: u8, name: usize, first_word: usize) {
        let start = self.at;
        if self.page.words.len() - first_word >= MAX_WORDS {
            self.flaw(block, Flaw(DefectKind::LineTooLong, self.at, 1));
            return self.skip_rest_of_block();
        }
        self.at += name;
        let end = self.at;
        self.skip_blanks();
        match self.peek() {
            b'[' if self.syntax.long_values => self.expression_word(block, letter, start, false, false),
            b'[' => self.text_word(block, letter, start),
            b'=' => self.equals_word(block, letter, start, false),
            _ if self.at_parameter() => self.expression_word(block, letter, start, false, false),
            b'-' | b'+' | b'0'..=b'9' | b'.' => {
                let negative = self.peek() == b'-';
                self.at += usize::from(matches!(self.peek(), b'-' | b'+'));
                self.numeric_word(block, letter, start, negative, false);
            }
            _ if self.opening_quote() > 0 => self.text_word(block, letter, start),
            _ => {
                self.at = end;
                self.flaw(block, Flaw(DefectKind::AddressWithoutNumber, start, end - start));
            }
        }
    }

    /// Reads `=` and an expression as the value of the word that started at `start`.
    fn equals_word(&mut self, block: u32, letter: u8, start: usize, comma: bool) {
        self.at += 1;
        self.skip_blanks();
        let first = self.page.nodes.len();
        match self.expression(0, Depth::default()) {
            Ok(()) => {
                let range = self.range_from(first);
                let len = self.word_len(start);
                self.page.words.push(Word::expression(letter, range, comma, start as u32, len));
            }
            Err(flaw) => {
                self.flaw(block, flaw);
                self.skip_rest_of_block();
            }
        }
    }

    /// Skips a comment; false, and a defect, if it is not closed.
    fn comment(&mut self, block: u32) -> bool {
        let start = self.at;
        let rest = self.text.get(start..).unwrap_or(&[]);
        let len = rest.iter().position(|b| matches!(b, b')' | b'\n' | b'\r')).unwrap_or(rest.len());
        self.at = start + len;
        let is_closed = self.peek() == b')';
        if is_closed {
            self.at += 1;
        } else {
            self.flaw(block, Flaw(DefectKind::UnclosedComment, start, len));
        }
        is_closed
    }

    /// Something that starts neither word nor statement.
    fn stray(&mut self, block: u32, byte: u8) {
        let start = self.at;
        match byte {
            b'0'..=b'9' | b'.' | b'-' | b'+' => {
                // One flaw for the whole number, whatever it is made of.
                while matches!(self.peek(), b'0'..=b'9' | b'.' | b'-' | b'+') {
                    self.at += 1;
                }
                self.flaw(block, Flaw(DefectKind::NumberWithoutAddress, start, self.at - start));
            }
            b'[' | b']' => {
                self.at += 1;
                self.flaw(block, Flaw(DefectKind::UnbalancedBracket, start, 1));
            }
            _ => {
                // A run of bytes outside ASCII is one piece of foreign text.
                self.at += 1;
                while byte >= 0x80 && self.peek() >= 0x80 {
                    self.at += 1;
                }
                self.flaw(block, Flaw(DefectKind::IllegalCharacter, start, self.at - start));
            }
        }
    }

    /// Whether a letter stands behind the comma here.
    fn is_before_letter(&self) -> bool {
        let rest = self.text.get(self.at + 1..).unwrap_or_default();
        rest.iter().find(|byte| !matches!(byte, b' ' | b'\t')).is_some_and(u8::is_ascii_alphabetic)
    }

    /// Reads an address and its value, and gives up a block that has too many.
    #[inline]
    fn word(&mut self, block: u32, first_word: usize, comma: bool) {
        if self.page.words.len() - first_word >= MAX_WORDS {
            self.flaw(block, Flaw(DefectKind::LineTooLong, self.at, 1));
            return self.skip_rest_of_block();
        }
        let start = self.at;
        if comma {
            self.at += 1;
            self.skip_blanks();
        }
        let letter_end = self.at + 1;
        let mut letter = self.peek().to_ascii_uppercase();
        self.at = letter_end;
        if self.syntax.numbered_axes
            && self.byte_at(self.at + 1) == b'='
            && let Some(axis) = numbered_axis(letter, self.peek())
        {
            letter = axis;
            self.at += 1;
        }
        self.skip_to_code();
        let mut negative = false;
        let mut signs = 0;
        let sign_at = self.at;
        // The blanks behind belong to nobody if no value follows.
        let mut end = letter_end;
        while matches!(self.peek(), b'-' | b'+') {
            negative ^= self.peek() == b'-';
            signs += 1;
            self.at += 1;
            end = self.at;
            self.skip_to_code();
        }
        if signs > 1 {
            self.flaw(block, Flaw(DefectKind::MisplacedSign, sign_at, end - sign_at));
        }
        match self.peek() {
            b'0'..=b'9' | b'.' => self.numeric_word(block, letter, start, negative, comma),
            b'#' | b'[' => self.expression_word(block, letter, start, negative, comma),
            b'=' if self.syntax.equals_in_words && signs == 0 => {
                self.equals_word(block, letter, start, comma);
            }
            _ if signs == 0 && !comma && self.opening_quote() > 0 => self.text_word(block, letter, start),
            _ if self.at_parameter() => self.expression_word(block, letter, start, negative, comma),
            b'(' if self.syntax.paren_groups => self.expression_word(block, letter, start, negative, comma),
            _ => {
                self.at = end;
                self.flaw(block, Flaw(DefectKind::AddressWithoutNumber, start, self.at - start));
            }
        }
    }

    fn expression_word(&mut self, block: u32, letter: u8, start: usize, negative: bool, comma: bool) {
        let first = self.page.nodes.len();
        match self.primary(Depth::default()) {
            Ok(()) => {
                if negative {
                    self.page.nodes.push(Node::Unary(Unary::Negate));
                }
                let range = self.range_from(first);
                let len = self.word_len(start);
                self.page.words.push(Word::expression(letter, range, comma, start as u32, len));
            }
            Err(flaw) => {
                self.flaw(block, flaw);
                self.skip_rest_of_block();
            }
        }
    }

    /// Length of the word that started at `start`. One that is longer than 16 bits tell is of a line
    /// that will be refused.
    #[inline]
    fn word_len(&self, start: usize) -> u16 {
        (self.at - start).min(usize::from(u16::MAX)) as u16
    }

    #[inline(always)]
    fn numeric_word(&mut self, block: u32, letter: u8, start: usize, negative: bool, comma: bool) {
        let number_at = self.at;
        let Some(decimal) = number::decimal(self.text.get(number_at..).unwrap_or(&[])) else {
            self.at += 1;
            return self.flaw(block, Flaw(DefectKind::AddressWithoutNumber, start, self.at - start));
        };
        self.at += decimal.len;
        if !decimal.value.is_finite() {
            return self.flaw(block, Flaw(DefectKind::NumberTooLarge, start, self.at - start));
        }
        let value = if negative { -decimal.value } else { decimal.value };
        let len = self.word_len(start);
        self.page.words.push(Word::number(letter, value, decimal.point, comma, start as u32, len));
        let next = self.peek();
        if matches!(next, b'.' | b'-' | b'+') {
            let kind = if next == b'.' { DefectKind::MisplacedPoint } else { DefectKind::MisplacedSign };
            while matches!(self.peek(), b'0'..=b'9' | b'.' | b'-' | b'+') {
                self.at += 1;
            }
            self.flaw(block, Flaw(kind, start, self.at - start));
        }
    }

    fn range_from(&self, first: usize) -> ExprRange {
        ExprRange { start: first as u32, len: (self.page.nodes.len() - first) as u32 }
    }

    /// The run of letters from here on, or the start of a longer one than any name.
    fn letters(&self) -> &[u8] {
        let rest = self.text.get(self.at..).unwrap_or(&[]);
        let len = rest.iter().take(LONGEST_NAME).take_while(|b| b.is_ascii_alphabetic()).count();
        rest.get(..len).unwrap_or(&[])
    }

    /// Reads a statement; `None`, and a defect, if it cannot be read.
    fn statement(&mut self, block: u32, first_word: usize) -> Option<u16> {
        let start = self.at;
        let mixed = !self.only_sequence_number(first_word);
        let read = self.parse_statement().and_then(|statement| {
            self.skip_to_code();
            if mixed {
                return Err(Flaw(DefectKind::MixedStatement, start, self.at - start));
            }
            match self.at_end_of_block() {
                true => Ok(statement),
                // The rest of the line is a block of its own.
                false
                    if self.syntax.parameter_letter.is_some()
                        && matches!(statement, Statement::Assign { .. })
                        && self.peek().is_ascii_alphabetic() =>
                {
                    Ok(statement)
                }
                // A comment that is not closed; it is read, and reported, with the block.
                false if self.peek() == b'(' && self.syntax.paren_comments => Ok(statement),
                false if self.starts_line_comment() => Ok(statement),
                false if self.peek().is_ascii_alphabetic() => {
                    Err(Flaw(DefectKind::MixedStatement, self.at, self.rest_of_block()))
                }
                false => Err(Flaw(DefectKind::MalformedStatement, self.at, self.rest_of_block())),
            }
        });
        match read {
            Ok(statement) => {
                self.page.statements.push(statement);
                u16::try_from(self.page.statements.len() - 1).ok()
            }
            Err(flaw) => {
                self.flaw(block, flaw);
                self.skip_rest_of_block();
                None
            }
        }
    }

    /// Skips blanks, padding and comments.
    fn skip_to_code(&mut self) {
        loop {
            while self.at < self.text.len()
                && (is_padding(self.peek()) || matches!(self.peek(), b' ' | b'\t'))
            {
                self.at += 1;
            }
            if self.peek() != b'(' || !self.syntax.paren_comments {
                return;
            }
            let rest = self.text.get(self.at..).unwrap_or(&[]);
            match rest.iter().position(|b| matches!(b, b')' | b'\n' | b'\r')) {
                Some(len) if rest.get(len) == Some(&b')') => self.at += len + 1,
                _ => return,
            }
        }
    }

    fn rest_of_block(&self) -> usize {
        let rest = self.text.get(self.at..).unwrap_or(&[]);
        rest.iter().position(|b| matches!(b, b'\n' | b'\r' | b';')).unwrap_or(rest.len())
    }

    /// The last byte that is no blank, to point at where something is missing at the end of a block.
    fn last_code(&self) -> usize {
        let read = self.text.get(..self.at).unwrap_or(&[]);
        read.iter().rposition(|b| !matches!(b, b' ' | b'\t')).unwrap_or(0)
    }

    fn malformed<T>(&self) -> Result<T, Flaw> {
        Err(match self.at_end_of_block() {
            true => Flaw(DefectKind::MalformedStatement, self.last_code(), 1),
            false => Flaw(DefectKind::MalformedStatement, self.at, self.rest_of_block()),
        })
    }

    fn take_keyword(&mut self, wanted: Keyword) -> bool {
        self.skip_blanks();
        let name = self.letters();
        let found = self.syntax.keyword(name) == Some(wanted);
        if found {
            self.at += name.len();
        }
        found
    }

    fn parse_statement(&mut self) -> Result<Statement, Flaw> {
        self.skip_blanks();
        if self.peek() == b'#' && self.syntax.directives {
            return self.directive();
        }
        if Some(self.peek()) == self.syntax.keyword_sign {
            return self.parse_block_statement();
        }
        if self.peek() == b'#' || self.at_parameter() {
            let (target, value) = self.assignment()?;
            return Ok(Statement::Assign { target, value });
        }
        let name = self.letters();
        let keyword = self.syntax.keyword(name);
        let len = name.len();
        match keyword {
            Some(Keyword::Goto) => {
                self.at += len;
                Ok(Statement::Goto { condition: None, target: self.goto_target()? })
            }
            Some(Keyword::If) => {
                self.at += len;
                let condition = self.condition()?;
                if self.take_keyword(Keyword::Goto) {
                    return Ok(Statement::Goto { condition: Some(condition), target: self.goto_target()? });
                }
                if !self.take_keyword(Keyword::Then) {
                    return self.malformed();
                }
                self.skip_blanks();
                if self.peek() != b'#' {
                    return self.malformed();
                }
                let (target, value) = self.assignment()?;
                Ok(Statement::IfAssign { condition, target, value })
            }
            Some(Keyword::While) => {
                self.at += len;
                let condition = Some(self.condition()?);
                if !self.take_keyword(Keyword::Do) {
                    return self.malformed();
                }
                Ok(Statement::While { condition, label: self.label()? })
            }
            Some(Keyword::Do) => {
                self.at += len;
                Ok(Statement::While { condition: None, label: self.label()? })
            }
            Some(Keyword::End) => {
                self.at += len;
                Ok(Statement::EndWhile { label: self.label()? })
            }
            _ => self.malformed(),
        }
    }

    /// A statement whose keyword has a sign before it.
    fn parse_block_statement(&mut self) -> Result<Statement, Flaw> {
        let start = self.at;
        self.at += 1;
        let name = self.letters();
        let (keyword, len) = (self.syntax.keyword(name), name.len());
        self.at += len;
        let Some(keyword) = keyword else {
            return Err(Flaw(DefectKind::MalformedStatement, start, len + 1));
        };
        let mut condition = || {
            let first = self.page.nodes.len();
            self.expression(0, Depth::default())?;
            Ok(self.range_from(first))
        };
        Ok(match keyword {
            Keyword::If => Statement::If { condition: condition()? },
            Keyword::ElseIf => Statement::ElseIf { condition: condition()? },
            Keyword::While => Statement::WhileBlock { condition: condition()? },
            Keyword::Else => Statement::Else,
            Keyword::EndIf => Statement::EndIf,
            Keyword::EndFor => Statement::EndFor,
            Keyword::EndWhile => Statement::EndWhileBlock,
            Keyword::Break => Statement::Break,
            Keyword::Continue => Statement::Continue,
            Keyword::For => return self.for_statement(),
            Keyword::Goto => {
                self.skip_blanks();
                // `$GOTO N10`: the letter belongs to the number.
                if self.peek().eq_ignore_ascii_case(&b'N') {
                    self.at += 1;
                }
                Statement::Goto { condition: None, target: self.goto_target()? }
            }
            Keyword::Then | Keyword::Do | Keyword::End => return self.malformed(),
        })
    }

    /// `P0=first,last,step` behind `$FOR`.
    fn for_statement(&mut self) -> Result<Statement, Flaw> {
        self.skip_blanks();
        if !self.at_parameter() {
            return self.malformed();
        }
        let (target, first) = self.assignment()?;
        let mut next = || {
            self.skip_blanks();
            if self.peek() != b',' {
                return Ok(None);
            }
            self.at += 1;
            let start = self.page.nodes.len();
            self.expression(0, Depth::default())?;
            Ok(Some(self.range_from(start)))
        };
        let last = next()?;
        let step = next()?;
        match last {
            Some(last) => Ok(Statement::For { target, first, last, step }),
            None => self.malformed(),
        }
    }

    /// `#NAME NAME [argument, …]`.
    fn directive(&mut self) -> Result<Statement, Flaw> {
        let start = self.at;
        self.at += 1;
        let (first_name, first_argument) = (self.page.names.len(), self.page.arguments.len());
        loop {
            self.skip_blanks();
            let len = self.word_of_directive();
            if len == 0 {
                break;
            }
            self.page.names.push(TextRange { at: self.at as u32, len: len as u32 });
            self.at += len;
        }
        // Names have two letters at least, so that the index of a statement fits its 16 bits.
        if self.page.names.get(first_name).is_none_or(|name| name.len < 2) {
            return Err(Flaw(DefectKind::MalformedStatement, start, 1));
        }
        if self.peek() == b'[' {
            let open = self.at;
            self.at += 1;
            loop {
                let argument = self.argument(open, true)?;
                self.page.arguments.push(argument);
                if self.page.arguments.len() - first_argument > MAX_WORDS {
                    return Err(Flaw(DefectKind::LineTooLong, self.at, 1));
                }
                match self.peek() {
                    b',' => self.at += 1,
                    b']' => break,
                    _ => return Err(Flaw(DefectKind::UnbalancedBracket, open, 1)),
                }
            }
            self.at += 1;
        }
        self.page.directives.push(Directive {
            first_name: first_name as u32,
            names: (self.page.names.len() - first_name) as u16,
            first_argument: first_argument as u32,
            arguments: (self.page.arguments.len() - first_argument) as u16,
        });
        Ok(Statement::Directive(self.page.directives.len() as u32 - 1))
    }

    /// Length of the name that begins here.
    fn word_of_directive(&self) -> usize {
        let rest = self.text.get(self.at..).unwrap_or(&[]);
        rest.iter().take_while(|b| b.is_ascii_alphanumeric() || matches!(b, b'_' | b'-' | b'.')).count()
    }

    /// An argument, up to the comma or bracket that ends it; `open` is where the bracket before it stands.
    fn argument(&mut self, open: usize, may_be_list: bool) -> Result<Argument, Flaw> {
        self.skip_blanks();
        let mut name = TextRange::default();
        let len = self.word_of_directive();
        let behind = self.text.get(self.at + len..).unwrap_or(&[]);
        let blanks = behind.iter().take_while(|b| matches!(b, b' ' | b'\t')).count();
        if may_be_list
            && len > 0
            && behind.get(blanks) == Some(&b'=')
            && behind.get(blanks + 1) != Some(&b'=')
        {
            name = TextRange { at: self.at as u32, len: len as u32 };
            self.at += len + blanks + 1;
            self.skip_blanks();
        }
        let start = self.at;
        if may_be_list && self.is_list() {
            let first = self.page.items.len();
            self.at += 1;
            loop {
                let item = self.argument(start, false)?;
                self.page.items.push(item);
                if self.page.items.len() - first > MAX_WORDS {
                    return Err(Flaw(DefectKind::LineTooLong, self.at, 1));
                }
                match self.peek() {
                    b',' => self.at += 1,
                    b']' => break,
                    _ => return Err(Flaw(DefectKind::UnbalancedBracket, start, 1)),
                }
            }
            self.at += 1;
            let count = (self.page.items.len() - first) as u16;
            let text = TextRange { at: start as u32, len: (self.at - start) as u32 };
            self.skip_blanks();
            return Ok(Argument { name, text, value: None, items: Some((first as u32, count)) });
        }
        let end = self.end_of_argument().ok_or(Flaw(DefectKind::UnbalancedBracket, open, 1))?;
        let written = self.text.get(start..end).unwrap_or(&[]);
        let len = written.iter().rposition(|b| !matches!(b, b' ' | b'\t')).map_or(0, |last| last + 1);
        let first = self.page.nodes.len();
        let value = match self.expression(0, Depth::default()) {
            Ok(()) if len > 0 => {
                self.skip_blanks();
                (self.at == end).then(|| self.range_from(first))
            }
            _ => None,
        };
        if value.is_none() {
            self.page.nodes.truncate(first);
        }
        self.at = end;
        Ok(Argument { name, text: TextRange { at: start as u32, len: len as u32 }, value, items: None })
    }

    /// Whether brackets that begin here hold a list, `[1,2]`, and not the first part of an expression, `[1+2]*3`.
    fn is_list(&self) -> bool {
        let (mut depth, mut quoted, mut has_comma) = (0u32, false, false);
        let rest = self.text.get(self.at..).unwrap_or(&[]);
        for byte in rest {
            match byte {
                b'\n' | b'\r' | b';' => return false,
                b'"' => quoted = !quoted,
                _ if quoted => {}
                b'[' => depth += 1,
                b']' => depth = depth.saturating_sub(1),
                b',' if depth == 1 => has_comma = true,
                _ => {}
            }
            if depth == 0 {
                return has_comma;
            }
        }
        false
    }

    /// Where the comma or bracket stands that ends the value beginning here.
    fn end_of_argument(&self) -> Option<usize> {
        let (mut depth, mut quoted) = (0u32, false);
        let rest = self.text.get(self.at..).unwrap_or(&[]);
        for (place, byte) in rest.iter().enumerate() {
            match byte {
                b'\n' | b'\r' => break,
                b'"' => quoted = !quoted,
                _ if quoted => {}
                b'[' => depth += 1,
                b']' if depth > 0 => depth -= 1,
                b']' | b',' if depth == 0 => return Some(self.at + place),
                b';' => break,
                _ => {}
            }
        }
        None
    }

    /// Whether a parameter or a variable with a name begins here.
    fn at_parameter(&self) -> bool {
        self.is_parameter(self.at)
    }

    fn is_parameter(&self, at: usize) -> bool {
        let Some(letter) = self.syntax.parameter_letter else { return false };
        let [here, next, behind] = [0, 1, 2].map(|k| self.byte_at(at + k));
        if here.eq_ignore_ascii_case(&letter) && (next.is_ascii_digit() || next == b'[') {
            return true;
        }
        next == b'.' && here.eq_ignore_ascii_case(&b'V') && behind.is_ascii_alphabetic()
    }

    /// Whether a parameter or variable is set here.
    fn starts_assignment(&self) -> bool {
        if !self.at_parameter() {
            return false;
        }
        let rest = self.text.get(self.at..).unwrap_or(&[]);
        let (mut depth, mut name) = (0u32, 1);
        while let Some(byte) = rest.get(name) {
            match byte {
                b'[' => depth += 1,
                b']' if depth > 0 => depth -= 1,
                b'\n' | b'\r' | b';' => return false,
                _ if depth > 0 => {}
                b'0'..=b'9' | b'A'..=b'Z' | b'a'..=b'z' | b'.' | b'_' => {}
                _ => break,
            }
            name += 1;
        }
        let behind = rest.get(name..).unwrap_or(&[]);
        let blanks = behind.iter().take_while(|b| matches!(b, b' ' | b'\t')).count();
        behind.get(blanks) == Some(&b'=') && behind.get(blanks + 1) != Some(&b'=')
    }

    /// Reads `P10`, `P[…]` or `V.C.Z` and pushes what computes the number that it is kept by.
    fn parameter_number(&mut self, depth: Depth) -> Result<(), Flaw> {
        let start = self.at;
        match self.byte_at(self.at + 1) {
            b'[' => {}
            b'.' => return self.variable_name(),
            _ => {
                let rest = self.text.get(self.at + 1..).unwrap_or(&[]);
                let len = 1 + rest.iter().take_while(|b| b.is_ascii_digit()).count();
                return self.variable_name_of(len);
            }
        }
        // The family of the letter starts at a number of its own.
        let letter = [self.peek().to_ascii_uppercase(), b'0'];
        let Some(first) = self.syntax.variable(&letter) else {
            return Err(Flaw(DefectKind::UnknownVariable, start, 1));
        };
        self.at += 1;
        self.page.nodes.push(Node::Number(f64::from(first)));
        self.primary(depth.nested(start)?.with_value())?;
        self.page.nodes.push(Node::Binary(Binary::Add));
        Ok(())
    }

    fn label(&mut self) -> Result<u16, Flaw> {
        self.skip_blanks();
        match number::decimal(self.text.get(self.at..).unwrap_or(&[])) {
            Some(n) if n.value.fract() == 0.0 && n.value <= f64::from(u16::MAX) => {
                self.at += n.len;
                Ok(n.value as u16)
            }
            _ => self.malformed(),
        }
    }

    fn goto_target(&mut self) -> Result<ExprRange, Flaw> {
        let first = self.page.nodes.len();
        self.signed_primary(Depth::default())?;
        Ok(self.range_from(first))
    }

    fn condition(&mut self) -> Result<ExprRange, Flaw> {
        self.skip_blanks();
        let (start, first) = (self.at, self.page.nodes.len());
        match self.peek() {
            b'[' => self.primary(Depth::default())?,
            b'(' if self.syntax.paren_groups => self.primary(Depth::default())?,
            _ => return self.malformed(),
        }
        let compares = |node: &Node| matches!(node, Node::Binary(operator) if operator.compares());
        if self.syntax.conditions_compare && !self.page.nodes[first..].iter().any(compares) {
            return Err(Flaw(DefectKind::MalformedStatement, start, self.at - start));
        }
        Ok(self.range_from(first))
    }

    /// Reads `#i = value`.
    fn assignment(&mut self) -> Result<(ExprRange, ExprRange), Flaw> {
        let first = self.page.nodes.len();
        self.variable_number(Depth::default())?;
        let target = self.range_from(first);
        self.skip_blanks();
        if self.peek() != b'=' {
            return self.malformed();
        }
        self.at += 1;
        self.skip_blanks();
        let first = self.page.nodes.len();
        self.expression(0, Depth::default())?;
        Ok((target, self.range_from(first)))
    }

    /// Reads `#` and pushes what computes the number of the variable. Of `#1.5` that is 1.5: what a
    /// fraction means is the dialect's.
    fn variable_number(&mut self, depth: Depth) -> Result<(), Flaw> {
        if self.at_parameter() {
            return self.parameter_number(depth);
        }
        let start = self.at;
        let inner = depth.nested(start)?;
        self.at += 1;
        self.skip_inner_blanks();
        match self.peek() {
            b'0'..=b'9' => self.number(),
            b'[' => self.primary(inner),
            b'(' if self.syntax.paren_groups => self.primary(inner),
            b'#' => self.variable(inner),
            b'A'..=b'Z' | b'a'..=b'z' if self.has_names() => self.variable_name(),
            _ => Err(Flaw(DefectKind::MalformedExpression, start, 1)),
        }
    }

    fn has_names(&self) -> bool {
        !self.syntax.named_variables.is_empty() || !self.syntax.variable_families.is_empty()
    }

    /// Reads the name of a variable and pushes the number that it is kept by.
    fn variable_name(&mut self) -> Result<(), Flaw> {
        let rest = self.text.get(self.at..).unwrap_or(&[]);
        let len = rest.iter().take_while(|b| b.is_ascii_alphanumeric() || matches!(b, b'_' | b'.')).count();
        self.variable_name_of(len)
    }

    /// The same of a name of so many bytes.
    fn variable_name_of(&mut self, len: usize) -> Result<(), Flaw> {
        let rest = self.text.get(self.at..).unwrap_or(&[]);
        let number = rest.get(..len).and_then(|name| self.syntax.variable(name));
        let Some(number) = number else { return Err(Flaw(DefectKind::UnknownVariable, self.at, len)) };
        self.at += len;
        self.page.nodes.push(Node::Number(f64::from(number)));
        Ok(())
    }

    /// Reads `#…` and pushes its value.
    fn variable(&mut self, depth: Depth) -> Result<(), Flaw> {
        let first = self.page.nodes.len();
        self.variable_number(depth)?;
        self.push_variable(first);
        Ok(())
    }

    /// Pushes what gives the value of the variable whose number the nodes from `first` on compute. A number
    /// that is written takes no computing.
    #[inline]
    fn push_variable(&mut self, first: usize) {
        let node = match self.page.nodes.get(first..) {
            Some([Node::Number(n)]) if n.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(n) => {
                let at = *n as u32;
                self.page.nodes.truncate(first);
                Node::VariableAt(at)
            }
            _ => Node::Variable,
        };
        self.page.nodes.push(node);
    }

    /// Reads an unsigned number.
    fn number(&mut self) -> Result<(), Flaw> {
        match number::decimal(self.text.get(self.at..).unwrap_or(&[])) {
            Some(d) if d.value.is_finite() => {
                self.at += d.len;
                self.page.nodes.push(Node::Number(d.value));
                Ok(())
            }
            Some(d) => Err(Flaw(DefectKind::NumberTooLarge, self.at, d.len)),
            None => Err(Flaw(DefectKind::MalformedExpression, self.at, 1)),
        }
    }

    /// Precedence climbing: reads operators that bind at least as tightly as `least`.
    fn expression(&mut self, least: u16, depth: Depth) -> Result<(), Flaw> {
        self.signed_primary(depth)?;
        loop {
            self.skip_inner_blanks();
            let rest = self.text.get(self.at..).unwrap_or(&[]);
            let found = self.syntax.operators.iter().find(|(name, _, _)| {
                rest.get(..name.len()).is_some_and(|r| r.eq_ignore_ascii_case(name.as_bytes()))
            });
            let Some(&(name, operator, binding)) = found else { return Ok(()) };
            let binding = u16::from(binding);
            if binding < least {
                return Ok(());
            }
            self.at += name.len();
            // Operators of one binding group to the left.
            self.expression(binding + 1, depth.with_value())?;
            self.page.nodes.push(Node::Binary(operator));
        }
    }

    fn signed_primary(&mut self, depth: Depth) -> Result<(), Flaw> {
        self.skip_inner_blanks();
        let sign = match self.peek() {
            b'-' => Unary::Negate,
            b'+' => Unary::Plus,
            b'!' if self.syntax.logical_not => Unary::Not,
            _ => return self.primary(depth),
        };
        let inner = depth.nested(self.at)?;
        self.at += 1;
        self.signed_primary(inner)?;
        self.page.nodes.push(Node::Unary(sign));
        Ok(())
    }

    fn primary(&mut self, depth: Depth) -> Result<(), Flaw> {
        self.skip_inner_blanks();
        let start = self.at;
        if depth.values >= MAX_STACK {
            return Err(Flaw(DefectKind::BracketsTooDeep, start, 1));
        }
        match self.peek() {
            b'0'..=b'9' | b'.' => self.number(),
            b'#' => self.variable(depth),
            b'[' => self.bracket(b']', depth),
            b'(' if self.syntax.paren_groups => self.bracket(b')', depth),
            _ if self.at_parameter() => self.variable(depth),
            b'A'..=b'Z' | b'a'..=b'z' => self.call(depth),
            _ if self.at_end_of_block() => Err(Flaw(DefectKind::MalformedExpression, self.last_code(), 1)),
            _ => Err(Flaw(DefectKind::MalformedExpression, start, 1)),
        }
    }

    fn bracket(&mut self, close: u8, depth: Depth) -> Result<(), Flaw> {
        let start = self.at;
        if depth.brackets >= self.syntax.max_brackets {
            return Err(Flaw(DefectKind::BracketsTooDeep, start, 1));
        }
        let inner = depth.nested(start)?;
        self.at += 1;
        self.expression(0, Depth { brackets: depth.brackets + 1, ..inner })?;
        self.skip_inner_blanks();
        if self.peek() != close {
            return match self.at_end_of_block() {
                true => Err(Flaw(DefectKind::UnbalancedBracket, start, 1)),
                false => Err(Flaw(DefectKind::MalformedExpression, self.at, 1)),
            };
        }
        self.at += 1;
        Ok(())
    }

    fn call(&mut self, depth: Depth) -> Result<(), Flaw> {
        let start = self.at;
        let name = self.letters();
        let len = name.len();
        let Some(function) = self.syntax.function(name) else {
            return Err(Flaw(DefectKind::UnknownFunction, start, len));
        };
        self.at += len;
        self.skip_inner_blanks();
        let is_bare = self.syntax.bare_arguments && matches!(self.peek(), b'0'..=b'9' | b'.' | b'#');
        if !(self.peek() == b'[' || self.peek() == b'(' && self.syntax.paren_groups || is_bare) {
            return Err(Flaw(DefectKind::MalformedExpression, start, self.at - start));
        }
        self.primary(depth)?;
        // ATAN[a]/[b] is one function of two values in every language with brackets.
        if function == Function::Atan {
            let back = self.at;
            self.skip_inner_blanks();
            if self.peek() == b'/' {
                self.at += 1;
                self.skip_inner_blanks();
                if self.peek() == b'[' {
                    self.primary(depth.with_value())?;
                    self.page.nodes.push(Node::Call(Function::Atan2));
                    return Ok(());
                }
            }
            self.at = back;
        }
        self.page.nodes.push(Node::Call(function));
        Ok(())
    }
}

/// Padding of tapes and files: zero bytes, form feeds, reader controls, the old end of file.
#[inline]
fn is_padding(byte: u8) -> bool {
    matches!(byte, 0 | 0x0B | 0x0C | 0x11..=0x14 | 0x1A)
}
