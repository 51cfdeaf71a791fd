//! Blocks of RS274/NGC: a line is a block, blanks mean nothing anywhere, parameters are set beside words,
//! and an O word leads a statement (RS274/NGC 3.3; LinuxCNC, G-code overview and O codes).
//!
//! A parameter that is set is a word `#` whose expression leaves two values: the number of the parameter and
//! what it is set to. A comment that is a command is a word `(` with its text.

use super::{Depth, Flaw, Lexer, MAX_WORDS};
use crate::expression::{Binary, Function, MAX_STACK, Node, Unary};
use crate::names::{FIRST_NAMED, LONGEST_NAME};
use crate::number;
use crate::page::{Block, DefectKind, ExprRange, Label, OKeyword, OWord, Statement, TextRange, Word};

/// Letters of the longest keyword or function.
const LONGEST_WORD: usize = 16;

/// Bytes of the longest number that is written with blanks within.
const LONGEST_NUMBER: usize = 64;

/// Arguments of a call at most: they become #1 to #30.
const MAX_ARGUMENTS: usize = 30;

/// What makes a comment a command, in lower case: text to show, and files to write to.
const COMMANDS: &[&[u8]] = &[
    b"msg,",
    b"print,",
    b"debug,",
    b"log,",
    b"logopen,",
    b"logappend,",
    b"logclose",
    b"probeopen",
    b"probeclose",
];

const KEYWORDS: &[(&[u8], OKeyword)] = &[
    (b"sub", OKeyword::Sub),
    (b"endsub", OKeyword::EndSub),
    (b"call", OKeyword::Call),
    (b"return", OKeyword::Return),
    (b"do", OKeyword::Do),
    (b"while", OKeyword::While),
    (b"endwhile", OKeyword::EndWhile),
    (b"if", OKeyword::If),
    (b"elseif", OKeyword::ElseIf),
    (b"else", OKeyword::Else),
    (b"endif", OKeyword::EndIf),
    (b"break", OKeyword::Break),
    (b"continue", OKeyword::Continue),
    (b"repeat", OKeyword::Repeat),
    (b"endrepeat", OKeyword::EndRepeat),
];

impl Lexer<'_> {
    /// Reads one line and its end.
    pub(super) fn ngc_block(&mut self) {
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
            let byte = self.next_byte();
            if self.at >= self.text.len() || matches!(byte, b'\n' | b'\r') {
                break;
            }
            let nothing_read = self.page.words.len() == first_word && statement.is_none();
            let done = match byte {
                b';' => {
                    self.skip_line();
                    break;
                }
                b'(' => self.ngc_comment(first_word),
                b'/' if nothing_read && skip == 0 => {
                    skip = skip.saturating_add(1);
                    self.at += 1;
                    Ok(())
                }
                b'%' if nothing_read && skip == 0 => {
                    is_mark = !(self.is_head && self.page.blocks.is_empty());
                    self.at += 1;
                    text_end = self.at;
                    self.skip_line();
                    break;
                }
                _ if super::is_padding(byte) => {
                    self.at += 1;
                    continue;
                }
                b'O' | b'o' if statement.is_none() && self.only_sequence_number(first_word) => {
                    self.o_word().map(|word| {
                        self.page.o_words.push(word);
                        let at = self.page.o_words.len() - 1;
                        self.page.statements.push(Statement::OWord(at as u32));
                        statement = u16::try_from(self.page.statements.len() - 1).ok();
                    })
                }
                _ if statement.is_some() => {
                    Err(Flaw(DefectKind::MixedStatement, self.at, self.rest_of_block()))
                }
                b'N' | b'n' if nothing_read => self.sequence_number(),
                b'#' => self.setting(),
                b'N' | b'n' | b'O' | b'o' => Err(Flaw(DefectKind::IllegalCharacter, self.at, 1)),
                b'A'..=b'Z' | b'a'..=b'z' | b'@' | b'^' | b'$' => self.ngc_word(),
                _ => Err(Flaw(DefectKind::IllegalCharacter, self.at, 1)),
            };
            let done = match done {
                Ok(()) if self.page.words.len() - first_word > MAX_WORDS => {
                    Err(Flaw(DefectKind::LineTooLong, start, self.at - start))
                }
                done => done,
            };
            if let Err(flaw) = done {
                let end = flaw.1 + flaw.2;
                self.flaw(number, flaw);
                self.skip_line();
                text_end = end.min(self.at);
                break;
            }
            text_end = self.at;
        }
        let is_defective = self.page.defects.len() > first_defect;
        let says_nothing = self.page.words.len() == first_word && statement.is_none();
        if !says_nothing || skip > 0 || is_mark || is_defective {
            self.page.blocks.push(Block {
                at: start as u32,
                len: (text_end.max(start) - start) as u32,
                line,
                first_word: first_word as u32,
                words: (self.page.words.len() - first_word) as u16,
                skip,
                is_mark,
                is_defective,
                statement,
                guard: None,
            });
        }
        if self.at < self.text.len() {
            self.end_of_block();
        }
    }

    /// The next byte that is no blank, which is not taken.
    #[inline]
    fn next_byte(&mut self) -> u8 {
        self.skip_blanks();
        self.peek()
    }

    /// Takes these letters or signs, whatever blanks stand between them.
    fn take_text(&mut self, wanted: &[u8]) -> bool {
        let back = self.at;
        for byte in wanted {
            if !self.next_byte().eq_ignore_ascii_case(byte) {
                self.at = back;
                return false;
            }
            self.at += 1;
        }
        true
    }

    /// The run of letters from here on in lower case, blanks within left out; nothing is taken.
    fn letters_ahead(&self) -> ([u8; LONGEST_WORD], usize) {
        let (mut name, mut len) = ([0; LONGEST_WORD], 0);
        for byte in self.text.get(self.at..).unwrap_or(&[]) {
            match byte {
                b' ' | b'\t' => {}
                b'A'..=b'Z' | b'a'..=b'z' => {
                    let Some(slot) = name.get_mut(len) else { break };
                    *slot = byte.to_ascii_lowercase();
                    len += 1;
                }
                _ => break,
            }
        }
        (name, len)
    }

    /// Reads a number of digits and points behind `N`, which means nothing.
    fn sequence_number(&mut self) -> Result<(), Flaw> {
        let start = self.at;
        self.at += 1;
        if !self.next_byte().is_ascii_digit() {
            return Err(Flaw(DefectKind::AddressWithoutNumber, start, 1));
        }
        let (value, point) = self.ngc_number(start)?;
        self.page.words.push(Word::number(b'N', value, point, false, start as u32, self.word_len(start)));
        Ok(())
    }

    /// Reads a comment. One that is a command becomes a word; of several in a line the last one counts.
    fn ngc_comment(&mut self, first_word: usize) -> Result<(), Flaw> {
        let start = self.at;
        let rest = self.text.get(start + 1..).unwrap_or(&[]);
        let len = rest.iter().position(|b| matches!(b, b'(' | b')' | b'\n' | b'\r')).unwrap_or(rest.len());
        let inner = rest.get(..len).unwrap_or(&[]);
        self.at = start + 1 + len;
        if self.peek() != b')' {
            return Err(Flaw(DefectKind::UnclosedComment, start, 1 + len));
        }
        self.at += 1;
        let earlier = self.page.words.get(first_word..).unwrap_or(&[]);
        if let Some(place) = earlier.iter().position(|word| word.letter == b'(') {
            self.page.words.remove(first_word + place);
        }
        let blanks = inner.iter().take_while(|b| matches!(b, b' ' | b'\t')).count();
        let said = inner.get(blanks..).unwrap_or(&[]);
        let is_command = |c: &&[u8]| said.get(..c.len()).is_some_and(|s| s.eq_ignore_ascii_case(c));
        if COMMANDS.iter().any(is_command) {
            let text = TextRange { at: (start + 1 + blanks) as u32, len: said.len() as u32 };
            self.page.words.push(Word::text(b'(', text, start as u32, self.word_len(start)));
        }
        Ok(())
    }

    /// Reads a letter and its value.
    #[inline]
    fn ngc_word(&mut self) -> Result<(), Flaw> {
        let start = self.at;
        let letter = self.peek().to_ascii_uppercase();
        self.at += 1;
        let byte = self.next_byte();
        let is_number = match byte {
            b'0'..=b'9' | b'.' => true,
            b'+' | b'-' => self.sign_of_number(),
            _ => false,
        };
        if is_number {
            let (value, point) = self.ngc_number(start)?;
            let word = Word::number(letter, value, point, false, start as u32, self.word_len(start));
            self.page.words.push(word);
            return Ok(());
        }
        if self.at >= self.text.len() || matches!(byte, b'\n' | b'\r' | b';') {
            return Err(Flaw(DefectKind::AddressWithoutNumber, start, 1));
        }
        let first = self.page.nodes.len();
        self.ngc_value(Depth::default())?;
        let range = self.range_from(first);
        let len = self.word_len(start);
        self.page.words.push(Word::expression(letter, range, false, start as u32, len));
        Ok(())
    }

    /// Whether the sign that stands here is of a number, and not of a value.
    fn sign_of_number(&self) -> bool {
        let rest = self.text.get(self.at + 1..).unwrap_or(&[]);
        let next = rest.iter().find(|b| !matches!(b, b' ' | b'\t'));
        next.is_some_and(|b| b.is_ascii_digit() || *b == b'.')
    }

    /// Reads a number with or without sign, and tells whether it has a point. `start` is where its word starts.
    #[inline]
    fn ngc_number(&mut self, start: usize) -> Result<(f64, bool), Flaw> {
        let negative = self.peek() == b'-';
        if matches!(self.peek(), b'+' | b'-') {
            self.at += 1;
            self.skip_blanks();
        }
        let Some(mut decimal) = number::decimal(self.text.get(self.at..).unwrap_or(&[])) else {
            return Err(Flaw(DefectKind::AddressWithoutNumber, start, self.at + 1 - start));
        };
        let first = self.at;
        self.at += decimal.len;
        if matches!(self.peek(), b' ' | b'\t') && matches!(self.byte_behind_blanks(), b'0'..=b'9' | b'.') {
            decimal = self.number_with_blanks(first)?;
        }
        if !decimal.value.is_finite() {
            return Err(Flaw(DefectKind::NumberTooLarge, start, self.at - start));
        }
        if self.peek() == b'.' {
            return Err(Flaw(DefectKind::MisplacedPoint, start, self.at + 1 - start));
        }
        Ok((if negative { -decimal.value } else { decimal.value }, decimal.point))
    }

    fn byte_behind_blanks(&self) -> u8 {
        let rest = self.text.get(self.at..).unwrap_or(&[]);
        rest.iter().find(|b| !matches!(b, b' ' | b'\t')).copied().unwrap_or(0)
    }

    /// Reads a number that has blanks between its digits, from `first` on.
    fn number_with_blanks(&mut self, first: usize) -> Result<number::Decimal, Flaw> {
        self.at = first;
        let (mut digits, mut len) = ([0u8; LONGEST_NUMBER], 0);
        while matches!(self.next_byte(), b'0'..=b'9' | b'.') {
            let Some(slot) = digits.get_mut(len) else {
                return Err(Flaw(DefectKind::NumberTooLarge, first, self.at - first));
            };
            *slot = self.peek();
            len += 1;
            self.at += 1;
        }
        match number::decimal(digits.get(..len).unwrap_or(&[])) {
            Some(decimal) if decimal.len == len => Ok(decimal),
            _ => Err(Flaw(DefectKind::MisplacedPoint, first, self.at - first)),
        }
    }

    /// Reads `#… = value`.
    fn setting(&mut self) -> Result<(), Flaw> {
        let start = self.at;
        let first = self.page.nodes.len();
        self.parameter_place(Depth::default())?;
        if self.next_byte() != b'=' {
            return Err(Flaw(DefectKind::MalformedStatement, start, self.at - start));
        }
        self.at += 1;
        self.ngc_value(Depth::default().with_value())?;
        let range = self.range_from(first);
        let len = self.word_len(start);
        self.page.words.push(Word::expression(b'#', range, false, start as u32, len));
        Ok(())
    }

    /// Reads `#…` and pushes what computes the number of the parameter.
    fn parameter_place(&mut self, depth: Depth) -> Result<(), Flaw> {
        let start = self.at;
        let inner = depth.nested(start)?;
        self.at += 1;
        if self.next_byte() == b'<' {
            let number = self.named_variable()?;
            self.page.nodes.push(Node::Number(f64::from(number)));
            return Ok(());
        }
        self.ngc_value(inner)
    }

    /// Reads `<name>` and gives the number of the variable with that name.
    fn named_variable(&mut self) -> Result<u32, Flaw> {
        let start = self.at;
        let number = self.label_name()?;
        // There are fewer names than numbers above that of the first.
        number.checked_add(FIRST_NAMED).ok_or(Flaw(DefectKind::LineTooLong, start, 1))
    }

    /// Reads `<name>`: capitals and blanks mean nothing.
    fn label_name(&mut self) -> Result<u32, Flaw> {
        let start = self.at;
        self.at += 1;
        let rest = self.text.get(self.at..).unwrap_or(&[]);
        let len = rest.iter().position(|b| matches!(b, b'>' | b'\n' | b'\r')).unwrap_or(rest.len());
        if rest.get(len) != Some(&b'>') || len > LONGEST_NAME {
            return Err(Flaw(DefectKind::UnknownVariable, start, len + 1));
        }
        let mut name = String::with_capacity(len);
        for byte in rest.get(..len).unwrap_or(&[]) {
            match byte {
                b' ' | b'\t' => {}
                b'(' => return Err(Flaw(DefectKind::UnknownVariable, start, len + 1)),
                _ if byte.is_ascii_graphic() => name.push(char::from(byte.to_ascii_lowercase())),
                _ => return Err(Flaw(DefectKind::IllegalCharacter, start, len + 1)),
            }
        }
        self.at += len + 1;
        match self.names.number(&name) {
            Some(number) if !name.is_empty() => Ok(number),
            _ => Err(Flaw(DefectKind::UnknownVariable, start, len + 2)),
        }
    }

    /// Reads a parameter and pushes its value.
    fn parameter(&mut self, depth: Depth) -> Result<(), Flaw> {
        let first = self.page.nodes.len();
        self.parameter_place(depth)?;
        self.push_variable(first);
        Ok(())
    }

    /// Reads a number, parameter, bracket or function, with or without sign, and pushes it. A sign binds
    /// tighter than any operator.
    fn ngc_value(&mut self, depth: Depth) -> Result<(), Flaw> {
        let byte = self.next_byte();
        let start = self.at;
        if depth.values >= MAX_STACK {
            return Err(Flaw(DefectKind::BracketsTooDeep, start, 1));
        }
        match byte {
            b'0'..=b'9' | b'.' => self.pushed_number(),
            b'+' | b'-' if self.sign_of_number() => self.pushed_number(),
            b'+' | b'-' => {
                let inner = depth.nested(start)?;
                self.at += 1;
                self.ngc_value(inner)?;
                if byte == b'-' {
                    self.page.nodes.push(Node::Unary(Unary::Negate));
                }
                Ok(())
            }
            b'[' => {
                let inner = depth.nested(start)?;
                self.at += 1;
                self.ngc_expression(0, inner)?;
                if self.next_byte() != b']' {
                    return Err(match self.at_end_of_block() {
                        true => Flaw(DefectKind::UnbalancedBracket, start, 1),
                        false => Flaw(DefectKind::MalformedExpression, self.at, 1),
                    });
                }
                self.at += 1;
                Ok(())
            }
            b'#' => self.parameter(depth),
            b'A'..=b'Z' | b'a'..=b'z' => self.function(depth),
            _ if self.at_end_of_block() => Err(Flaw(DefectKind::MalformedExpression, self.last_code(), 1)),
            _ => Err(Flaw(DefectKind::MalformedExpression, start, 1)),
        }
    }

    fn pushed_number(&mut self) -> Result<(), Flaw> {
        let (value, _) = self.ngc_number(self.at)?;
        self.page.nodes.push(Node::Number(value));
        Ok(())
    }

    /// Reads operators that bind at least as tightly as `least`; those of one binding group to the left.
    fn ngc_expression(&mut self, least: u16, depth: Depth) -> Result<(), Flaw> {
        self.ngc_value(depth)?;
        loop {
            let byte = self.next_byte();
            if matches!(byte, b']' | b'\n' | b'\r') {
                return Ok(());
            }
            let operators = self.syntax.operators;
            let back = self.at;
            let found = operators.iter().find(|(name, _, _)| self.take_text(name.as_bytes()));
            let Some(&(_, operator, binding)) = found else { return Ok(()) };
            let binding = u16::from(binding);
            if binding < least {
                self.at = back;
                return Ok(());
            }
            self.ngc_expression(binding + 1, depth.with_value())?;
            self.page.nodes.push(Node::Binary(operator));
        }
    }

    /// Reads a function of a bracket.
    fn function(&mut self, depth: Depth) -> Result<(), Flaw> {
        let start = self.at;
        let (name, len) = self.letters_ahead();
        let name = name.get(..len).unwrap_or(&[]);
        let Some(function) = self.syntax.function(name) else {
            return Err(Flaw(DefectKind::UnknownFunction, start, len.max(1)));
        };
        self.take_text(name);
        if self.next_byte() != b'[' {
            return Err(Flaw(DefectKind::MalformedExpression, start, self.at - start));
        }
        if function == Function::Exists {
            return self.exists();
        }
        self.ngc_value(depth)?;
        if function == Function::Atan {
            if self.next_byte() != b'/' {
                return Err(Flaw(DefectKind::MalformedExpression, start, self.at - start));
            }
            self.at += 1;
            if self.next_byte() != b'[' {
                return Err(Flaw(DefectKind::MalformedExpression, start, self.at - start));
            }
            self.ngc_value(depth.with_value())?;
            self.page.nodes.push(Node::Call(Function::Atan2));
            return Ok(());
        }
        self.page.nodes.push(Node::Call(function));
        Ok(())
    }

    /// `EXISTS[#<name>]` or of a number, from its bracket on.
    fn exists(&mut self) -> Result<(), Flaw> {
        let start = self.at;
        self.at += 1;
        if !self.take_text(b"#") {
            return Err(Flaw(DefectKind::MalformedExpression, start, self.at - start));
        }
        let number = match self.next_byte() {
            b'<' => self.named_variable()?,
            b'0'..=b'9' => self.ngc_number(start)?.0.min(f64::from(u32::MAX >> 1)) as u32,
            _ => return Err(Flaw(DefectKind::MalformedExpression, start, self.at - start)),
        };
        if self.next_byte() != b']' {
            return Err(Flaw(DefectKind::UnbalancedBracket, start, 1));
        }
        self.at += 1;
        self.page.nodes.push(Node::Exists(number));
        Ok(())
    }

    /// Reads an O word, what it commands and the values behind it.
    fn o_word(&mut self) -> Result<OWord, Flaw> {
        let start = self.at;
        self.at += 1;
        let label = match self.next_byte() {
            b'<' => Label::Name(self.label_name()?),
            b'0'..=b'9' => {
                let (number, _) = self.ngc_number(start)?;
                if number.fract() != 0.0 || number > f64::from(u32::MAX) {
                    return Err(Flaw(DefectKind::MalformedStatement, start, self.at - start));
                }
                Label::Number(number as u32)
            }
            b'[' | b'#' => {
                let first = self.page.nodes.len();
                self.ngc_value(Depth::default())?;
                Label::Computed(self.range_from(first))
            }
            _ => return Err(Flaw(DefectKind::MalformedStatement, start, 1)),
        };
        self.skip_blanks();
        let (name, len) = self.letters_ahead();
        let name = name.get(..len).unwrap_or(&[]);
        if name.is_empty() {
            return Ok(OWord { label, keyword: OKeyword::Program, first: 0, count: 0 });
        }
        // Letters of a word behind it may follow without a blank, or with one that means nothing.
        let begins = KEYWORDS.iter().filter(|(keyword, _)| name.starts_with(keyword));
        let Some(&(name, keyword)) = begins.max_by_key(|(keyword, _)| keyword.len()) else {
            return Err(Flaw(DefectKind::MalformedStatement, self.at, len));
        };
        self.take_text(name);
        let first = self.page.values.len();
        while self.next_byte() == b'[' {
            if self.page.values.len() - first >= MAX_ARGUMENTS {
                return Err(Flaw(DefectKind::MalformedStatement, self.at, 1));
            }
            let range = self.bracket_range()?;
            self.page.values.push(range);
        }
        let count = self.page.values.len() - first;
        let is_right = match keyword {
            OKeyword::Call => true,
            OKeyword::If | OKeyword::ElseIf | OKeyword::While | OKeyword::Repeat => count == 1,
            OKeyword::Return | OKeyword::EndSub => count <= 1,
            _ => count == 0,
        };
        if !is_right {
            return Err(Flaw(DefectKind::MalformedStatement, start, self.at - start));
        }
        Ok(OWord { label, keyword, first: first as u32, count: count as u16 })
    }

    fn bracket_range(&mut self) -> Result<ExprRange, Flaw> {
        let first = self.page.nodes.len();
        self.ngc_value(Depth::default())?;
        Ok(self.range_from(first))
    }
}

/// Operators by how tightly they bind; of two signs the longer stands first.
pub const NGC_OPERATORS: &[(&str, Binary, u8)] = &[
    ("**", Binary::Power, 5),
    ("*", Binary::Multiply, 4),
    ("/", Binary::Divide, 4),
    ("MOD", Binary::Modulo, 4),
    ("+", Binary::Add, 3),
    ("-", Binary::Subtract, 3),
    ("EQ", Binary::Equal, 2),
    ("NE", Binary::NotEqual, 2),
    ("GT", Binary::Greater, 2),
    ("GE", Binary::GreaterEqual, 2),
    ("LT", Binary::Less, 2),
    ("LE", Binary::LessEqual, 2),
    ("AND", Binary::LogicalAnd, 1),
    ("OR", Binary::LogicalOr, 1),
    ("XOR", Binary::LogicalXor, 1),
];
