//! Text to blocks, one page at a time, in one pass over the bytes.
//!
//! Lexing never fails. What cannot be read becomes a [`Defect`] of its block, and reading goes on
//! behind it, so that a checker sees every fault of a program and not only the first.
//!
//! The bytes are not decoded first: addresses, numbers and signs are ASCII in every encoding that
//! programs come in, and neither UTF-8 nor GB18030 uses the bytes of `)`, `;` or a line end inside a
//! longer character. Other text stands in comments, which are skipped.

use crate::expression::{Function, MAX_NESTING, Node, Unary};
use crate::number;
use crate::page::{Block, Defect, DefectKind, ExprRange, Page, Statement, Word};
use crate::span::FileId;
use crate::syntax::{Keyword, Syntax};

/// Words in a block beyond which it is refused; no control takes nearly as many.
const MAX_WORDS: usize = 512;

/// What [`lex`] read.
pub struct Lexed {
    /// The blocks.
    pub page: Page,
    /// Bytes read; lines are never cut.
    pub consumed: usize,
    /// Line at which the next page starts.
    pub next_line: u32,
}

/// Lexes whole lines of `text`, which stands in `file` at `offset` and starts line `line`.
///
/// `is_last` tells that the file ends where `text` ends; else only lines that are closed are read.
/// A `text` without any line end that is not the last is one over-long line: it is all consumed and
/// becomes one defective block.
pub fn lex(text: &[u8], file: FileId, offset: u64, line: u32, is_last: bool, syntax: &Syntax) -> Lexed {
    let end = if is_last { text.len() } else { end_of_lines(text) };
    let page = Page { file, offset, ..Page::default() };
    let mut lexer = Lexer { text: text.get(..end).unwrap_or(text), at: 0, line, line_start: 0, syntax, page };
    lexer.run();
    Lexed { page: lexer.page, consumed: end, next_line: lexer.line }
}

/// Length of the part of `text` that ends with a line end; all of it where it has none.
fn end_of_lines(text: &[u8]) -> usize {
    let last = text.iter().rposition(|b| *b == b'\n').or_else(|| {
        // A file with CR alone. The last byte may be the first half of CR LF: leave it.
        text.get(..text.len().saturating_sub(1))?.iter().rposition(|b| *b == b'\r')
    });
    last.map_or(text.len(), |at| at + 1)
}

/// A defect found in an expression or statement, before its block is known.
struct Flaw(DefectKind, usize, usize);

struct Lexer<'a> {
    text: &'a [u8],
    at: usize,
    line: u32,
    line_start: usize,
    syntax: &'a Syntax,
    page: Page,
}

impl Lexer<'_> {
    fn run(&mut self) {
        while self.at < self.text.len() {
            self.block();
        }
        self.check_line_length();
    }

    #[inline]
    fn peek(&self) -> u8 {
        // 0 stands for the end of the text; a zero byte in the text is an illegal character.
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

    fn at_end_of_block(&self) -> bool {
        self.at >= self.text.len() || matches!(self.peek(), b'\n' | b'\r' | b';')
    }

    /// Reads the end of a block and counts lines.
    fn end_of_block(&mut self) {
        match self.peek() {
            b'\n' => self.new_line(1),
            b'\r' if self.byte_at(self.at + 1) == b'\n' => self.new_line(2),
            b'\r' => self.new_line(1),
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
        let len = self.at.min(self.text.len()) - self.line_start;
        if len <= self.syntax.max_line {
            return;
        }
        // The block of this line carries the defect; a line without one gets a block for it.
        let start = self.line_start as u32;
        if self.page.blocks.last().is_none_or(|b| b.at < start) {
            let first_word = self.page.words.len() as u32;
            self.page.blocks.push(Block { at: start, line: self.line, first_word, ..Block::default() });
        }
        if let Some(block) = self.page.blocks.last_mut() {
            block.is_defective = true;
        }
        let block = (self.page.blocks.len() as u32).saturating_sub(1);
        self.flaw(block, Flaw(DefectKind::LineTooLong, self.line_start, len.min(80)));
    }

    /// Reads one block and its end.
    fn block(&mut self) {
        self.skip_blanks();
        let start = self.at;
        let first_word = self.page.words.len();
        let first_defect = self.page.defects.len();
        let number = self.page.blocks.len() as u32;
        let line = self.line;
        let mut skip = 0u8;
        let mut statement = None;
        let mut is_mark = false;
        let mut text_end = start;
        loop {
            let byte = self.peek();
            match byte {
                b'A'..=b'Z' | b'a'..=b'z' => {
                    if self.byte_at(self.at + 1).is_ascii_alphabetic() && self.is_keyword() {
                        statement = self.statement(number, first_word);
                    } else {
                        self.word(number, false);
                        if self.page.words.len() - first_word > MAX_WORDS {
                            self.flaw(number, Flaw(DefectKind::LineTooLong, start, 80));
                            self.to_end_of_block();
                        }
                    }
                    text_end = self.at;
                }
                b' ' | b'\t' => self.at += 1,
                // Padding of tapes: zero bytes, form feeds, reader controls, the old end of file.
                0 | 0x0B | 0x0C | 0x11..=0x14 | 0x1A if self.at < self.text.len() => self.at += 1,
                b'\n' | b'\r' | b';' => break,
                b'(' if self.syntax.paren_comments => self.comment(number),
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
                b',' if self.byte_at(self.at + 1).is_ascii_alphabetic() => {
                    self.word(number, true);
                    text_end = self.at;
                }
                b'%' if self.page.words.len() == first_word && skip == 0 => {
                    self.to_end_of_line();
                    is_mark = self.page.offset + start as u64 > 0;
                    text_end = start + 1;
                    break;
                }
                _ if self.at >= self.text.len() => break,
                _ => {
                    self.stray(number, byte);
                    text_end = self.at;
                }
            }
        }
        let is_defective = self.page.defects.len() > first_defect;
        if self.page.words.len() > first_word || skip > 0 || statement.is_some() || is_mark || is_defective {
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
            });
        }
        if self.at < self.text.len() {
            self.end_of_block();
        }
    }

    /// Whether nothing but an N word was read of this block.
    fn only_sequence_number(&self, first_word: usize) -> bool {
        self.page.words.get(first_word..).is_some_and(|w| w.iter().all(|w| w.letter == b'N'))
    }

    fn flaw(&mut self, block: u32, Flaw(kind, at, len): Flaw) {
        self.page.defects.push(Defect { block, kind, at: at as u32, len: len as u32 });
    }

    fn to_end_of_line(&mut self) {
        while self.at < self.text.len() && !matches!(self.peek(), b'\n' | b'\r') {
            self.at += 1;
        }
    }

    /// Skips what is left of a block whose statement cannot be read.
    fn to_end_of_block(&mut self) {
        while !self.at_end_of_block() {
            self.at += 1;
        }
    }

    fn comment(&mut self, block: u32) {
        let start = self.at;
        let rest = self.text.get(start..).unwrap_or(&[]);
        let len = rest.iter().position(|b| matches!(b, b')' | b'\n' | b'\r')).unwrap_or(rest.len());
        self.at = start + len;
        if self.peek() == b')' {
            self.at += 1;
        } else {
            self.flaw(block, Flaw(DefectKind::UnclosedComment, start, len));
        }
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

    /// Reads an address and its value.
    #[inline]
    fn word(&mut self, block: u32, comma: bool) {
        let start = self.at;
        self.at += usize::from(comma);
        let letter = self.peek().to_ascii_uppercase();
        self.at += 1;
        self.skip_blanks();
        let mut negative = false;
        let mut signs = 0;
        let sign_at = self.at;
        while matches!(self.peek(), b'-' | b'+') {
            negative ^= self.peek() == b'-';
            signs += 1;
            self.at += 1;
            self.skip_blanks();
        }
        if signs > 1 {
            self.flaw(block, Flaw(DefectKind::MisplacedSign, sign_at, self.at - sign_at));
        }
        match self.peek() {
            b'0'..=b'9' | b'.' => self.numeric_word(block, letter, start, negative, comma),
            b'#' | b'[' => {
                let first = self.page.nodes.len();
                match self.primary(1) {
                    Ok(()) => {
                        if negative {
                            self.page.nodes.push(Node::Unary(Unary::Negate));
                        }
                        let range = self.range_from(first);
                        let len = (self.at - start) as u16;
                        self.page.words.push(Word::expression(letter, range, comma, start as u32, len));
                    }
                    Err(flaw) => {
                        self.flaw(block, flaw);
                        self.to_end_of_block();
                    }
                }
            }
            _ => {
                // The blanks looked past belong to nobody.
                self.at = start + usize::from(comma) + 1 + signs;
                self.flaw(block, Flaw(DefectKind::AddressWithoutNumber, start, self.at - start));
            }
        }
    }

    #[inline]
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
        let len = (self.at - start).min(usize::from(u16::MAX)) as u16;
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

    /// The run of letters from here on.
    fn letters(&self) -> &[u8] {
        let rest = self.text.get(self.at..).unwrap_or(&[]);
        let len = rest.iter().position(|b| !b.is_ascii_alphabetic()).unwrap_or(rest.len());
        rest.get(..len).unwrap_or(&[])
    }

    fn is_keyword(&self) -> bool {
        self.syntax.keyword(self.letters()).is_some()
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
                self.to_end_of_block();
                None
            }
        }
    }

    /// Skips blanks and comments.
    fn skip_to_code(&mut self) {
        loop {
            self.skip_blanks();
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
        rest.iter().position(|b| matches!(b, b'\n' | b'\r' | b';')).unwrap_or(rest.len()).max(1)
    }

    fn malformed<T>(&self) -> Result<T, Flaw> {
        Err(Flaw(DefectKind::MalformedStatement, self.at, self.rest_of_block()))
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
        if self.peek() == b'#' {
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
        self.signed_primary(1)?;
        Ok(self.range_from(first))
    }

    fn condition(&mut self) -> Result<ExprRange, Flaw> {
        self.skip_blanks();
        let first = self.page.nodes.len();
        match self.peek() {
            b'[' => self.primary(1)?,
            b'(' if self.syntax.paren_groups => self.primary(1)?,
            _ => return self.malformed(),
        }
        Ok(self.range_from(first))
    }

    /// Reads `#i = value`.
    fn assignment(&mut self) -> Result<(ExprRange, ExprRange), Flaw> {
        let first = self.page.nodes.len();
        self.variable_number(1)?;
        let target = self.range_from(first);
        self.skip_blanks();
        if self.peek() != b'=' {
            return self.malformed();
        }
        self.at += 1;
        let first = self.page.nodes.len();
        self.expression(0, 1)?;
        Ok((target, self.range_from(first)))
    }

    /// Reads `#` and pushes what computes the number of the variable.
    fn variable_number(&mut self, depth: u8) -> Result<(), Flaw> {
        let start = self.at;
        if depth > MAX_NESTING {
            return Err(Flaw(DefectKind::BracketsTooDeep, start, 1));
        }
        self.at += 1;
        self.skip_blanks();
        match self.peek() {
            b'0'..=b'9' => {
                let digits = self.text.get(self.at..).unwrap_or(&[]);
                let len = digits.iter().position(|b| !b.is_ascii_digit()).unwrap_or(digits.len());
                let number = number::decimal(digits.get(..len).unwrap_or(&[])).map_or(0.0, |d| d.value);
                self.at += len;
                self.page.nodes.push(Node::Number(number));
                Ok(())
            }
            b'[' => self.primary(depth + 1),
            b'#' => self.variable(depth + 1),
            _ => Err(Flaw(DefectKind::MalformedExpression, start, 1)),
        }
    }

    /// Reads `#…` and pushes its value.
    fn variable(&mut self, depth: u8) -> Result<(), Flaw> {
        let first = self.page.nodes.len();
        self.variable_number(depth)?;
        let only = self.page.nodes.get(first..);
        if let Some([Node::Number(n)]) = only
            && *n <= f64::from(u32::MAX)
        {
            let node = Node::VariableAt(*n as u32);
            self.page.nodes.truncate(first);
            self.page.nodes.push(node);
        } else {
            self.page.nodes.push(Node::Variable);
        }
        Ok(())
    }

    /// Precedence climbing: reads operators that bind at least as tightly as `least`.
    fn expression(&mut self, least: u8, depth: u8) -> Result<(), Flaw> {
        self.signed_primary(depth)?;
        loop {
            self.skip_blanks();
            let rest = self.text.get(self.at..).unwrap_or(&[]);
            let found = self.syntax.operators.iter().find(|(name, _, _)| {
                rest.get(..name.len()).is_some_and(|r| r.eq_ignore_ascii_case(name.as_bytes()))
            });
            let Some(&(name, operator, binding)) = found else { return Ok(()) };
            if binding < least {
                return Ok(());
            }
            self.at += name.len();
            // Operators of one binding group to the left.
            self.expression(binding + 1, depth)?;
            self.page.nodes.push(Node::Binary(operator));
        }
    }

    fn signed_primary(&mut self, depth: u8) -> Result<(), Flaw> {
        self.skip_blanks();
        let sign = match self.peek() {
            b'-' => Unary::Negate,
            b'+' => Unary::Plus,
            _ => return self.primary(depth),
        };
        if depth > MAX_NESTING {
            return Err(Flaw(DefectKind::BracketsTooDeep, self.at, 1));
        }
        self.at += 1;
        self.signed_primary(depth + 1)?;
        self.page.nodes.push(Node::Unary(sign));
        Ok(())
    }

    fn primary(&mut self, depth: u8) -> Result<(), Flaw> {
        self.skip_blanks();
        let start = self.at;
        match self.peek() {
            b'0'..=b'9' | b'.' => match number::decimal(self.text.get(start..).unwrap_or(&[])) {
                Some(d) if d.value.is_finite() => {
                    self.at += d.len;
                    self.page.nodes.push(Node::Number(d.value));
                    Ok(())
                }
                Some(d) => Err(Flaw(DefectKind::NumberTooLarge, start, d.len)),
                None => Err(Flaw(DefectKind::MalformedExpression, start, 1)),
            },
            b'#' => self.variable(depth),
            b'[' => self.bracket(b']', depth),
            b'(' if self.syntax.paren_groups => self.bracket(b')', depth),
            b'A'..=b'Z' | b'a'..=b'z' => self.call(depth),
            _ if self.at_end_of_block() => {
                Err(Flaw(DefectKind::MalformedExpression, start.saturating_sub(1), 1))
            }
            _ => Err(Flaw(DefectKind::MalformedExpression, start, 1)),
        }
    }

    fn bracket(&mut self, close: u8, depth: u8) -> Result<(), Flaw> {
        let start = self.at;
        if depth > self.syntax.max_brackets.min(MAX_NESTING) {
            return Err(Flaw(DefectKind::BracketsTooDeep, start, 1));
        }
        self.at += 1;
        self.expression(0, depth + 1)?;
        self.skip_blanks();
        if self.peek() != close {
            return match self.at_end_of_block() {
                true => Err(Flaw(DefectKind::UnbalancedBracket, start, 1)),
                false => Err(Flaw(DefectKind::MalformedExpression, self.at, 1)),
            };
        }
        self.at += 1;
        Ok(())
    }

    fn call(&mut self, depth: u8) -> Result<(), Flaw> {
        let start = self.at;
        let name = self.letters();
        let len = name.len();
        let Some(function) = self.syntax.function(name) else {
            return Err(Flaw(DefectKind::UnknownFunction, start, len));
        };
        self.at += len;
        self.skip_blanks();
        if !(self.peek() == b'[' || self.peek() == b'(' && self.syntax.paren_groups) {
            return Err(Flaw(DefectKind::MalformedExpression, start, self.at - start));
        }
        self.primary(depth)?;
        // ATAN[a]/[b] is one function of two values in every language with brackets.
        if function == Function::Atan {
            let back = self.at;
            self.skip_blanks();
            if self.peek() == b'/' {
                self.at += 1;
                self.skip_blanks();
                if self.peek() == b'[' {
                    self.primary(depth)?;
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
