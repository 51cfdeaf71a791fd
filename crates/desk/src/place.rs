//! What stands at a place of a program: the word there, and the modes that the text above it sets.

use ferrocut_interpreter::Dialect;
use ferrocut_interpreter::modal::{Group, Modal};
use ferrocut_machine::Parameters;
use ferrocut_program::{Block, FileId, Page, ProgramMemory, Span, Statement, Value, Word};
use std::io;

/// Bytes on either side of a place that hold its whole line.
const LINE: usize = 2 * (1 << 17);

/// A word of a line.
pub struct Spot {
    /// Column of its first character, counted from 1.
    pub column: usize,
    /// How it is written.
    pub text: String,
    /// Its address in upper case; none for a piece of a macro statement.
    pub letter: Option<u8>,
    /// Its value, where that is a number.
    pub value: Option<f64>,
}

/// A line of a program.
pub struct Line {
    /// Its words, in order.
    pub words: Vec<Spot>,
    /// Its characters.
    pub text: Vec<char>,
    /// Letter of parameters without a sign; names may hold digits where there is one.
    parameter_letter: Option<char>,
    /// What begins a comment up to the end of the line, beside brackets.
    line_comments: &'static [&'static [u8]],
    /// `( … )` is a comment.
    paren_comments: bool,
    /// Comparisons are written with signs, such as `>=`.
    compares_by_signs: bool,
    /// The codes in force in it, as far as the program's text above it and its own words tell.
    pub modal: Modal,
    /// The G codes that stand in it, in tenths.
    pub g_codes: Vec<u16>,
    /// The M codes that stand in it.
    pub m_codes: Vec<u16>,
}

impl Line {
    /// What stands at a column: a variable, function or keyword of a macro, else the word.
    pub fn at(&self, column: usize) -> Option<Spot> {
        let word = self.words.iter().find(|w| w.holds(column));
        let piece = || self.piece_at(column);
        match word {
            // Within an expression its own pieces are meant.
            Some(word) if word.value.is_none() => {
                piece().filter(|p| p.column > word.column).or_else(|| word.copy())
            }
            Some(word) => word.copy(),
            None if self.is_comment(column) => None,
            None => piece(),
        }
    }

    /// Whether a column lies in a comment.
    pub fn is_comment(&self, column: usize) -> bool {
        let mut inside = false;
        let begins = |c: char| {
            self.line_comments.iter().any(|mark| std::str::from_utf8(mark) == Ok(c.encode_utf8(&mut [0; 4])))
        };
        for (at, c) in (1..).zip(&self.text) {
            if !inside && begins(*c) {
                return at <= column;
            }
            inside |= self.paren_comments && *c == '(';
            if at == column {
                return inside;
            }
            inside &= *c != ')';
        }
        false
    }

    /// How many characters of a name follow its first one. A parameter behind an address is one by itself.
    fn rest_of_name(&self, rest: &[char]) -> usize {
        let Some(letter) = self.parameter_letter else {
            return rest.iter().take_while(|c| c.is_ascii_alphabetic()).count();
        };
        let next = |at: usize| rest.get(at + 1).is_some_and(char::is_ascii_digit);
        let is_of_name = |(at, c): &(usize, &char)| {
            (c.is_ascii_alphanumeric() || **c == '.') && !(c.eq_ignore_ascii_case(&letter) && next(*at))
        };
        rest.iter().enumerate().take_while(is_of_name).count()
    }

    /// Digits, or a name where variables have such.
    fn rest_of_variable(&self, rest: &[char]) -> usize {
        let is_name = |c: &&char| c.is_ascii_alphanumeric() || **c == '.';
        match rest.first().is_some_and(char::is_ascii_alphabetic) && self.parameter_letter.is_none() {
            true => rest.iter().take_while(is_name).count(),
            false => rest.iter().take_while(|c| c.is_ascii_digit()).count(),
        }
    }

    /// Whether a `=` is that of an assignment: in no bracket, and no part of a comparison.
    fn is_assignment(&self, at: usize) -> bool {
        let before = self.text.get(..at).unwrap_or(&[]);
        let count = |signs: [char; 2]| before.iter().filter(|c| signs.contains(c)).count();
        let beside = [before.last(), self.text.get(at + 1)];
        self.text.get(at) == Some(&'=')
            && count(['[', '(']) == count([']', ')'])
            && !(self.compares_by_signs && beside.into_iter().flatten().any(|c| "=<>!".contains(*c)))
    }

    /// What stands beside the words of the line and in no comment: the pieces of its macro statement, each once.
    pub fn pieces(&self) -> Vec<Spot> {
        let mut pieces: Vec<Spot> = Vec::new();
        let mut column = 1;
        while column <= self.text.len() {
            let word = self.words.iter().find(|word| word.holds(column));
            match word.map(|word| word.end()).or_else(|| self.is_comment(column).then_some(column + 1)) {
                Some(end) => column = end,
                None => {
                    let piece = self.piece_at(column);
                    column = piece.as_ref().map_or(column + 1, Spot::end);
                    pieces.extend(piece.filter(|new| {
                        pieces.iter().all(|known| !known.text.eq_ignore_ascii_case(&new.text))
                    }));
                }
            }
        }
        pieces
    }

    /// A variable, number or name of a macro statement.
    fn piece_at(&self, column: usize) -> Option<Spot> {
        let mut at = 0;
        while let Some(first) = self.text.get(at) {
            let rest = self.text.get(at + 1..).unwrap_or(&[]);
            let length = 1 + match first {
                '#' if rest.first() == Some(&'<') => {
                    rest.iter().position(|c| *c == '>').map_or(0, |end| end + 1)
                }
                '#' => self.rest_of_variable(rest),
                c if c.is_ascii_alphabetic() => self.rest_of_name(rest),
                c if c.is_ascii_digit() => {
                    rest.iter().take_while(|c| c.is_ascii_digit() || **c == '.').count()
                }
                _ => 0,
            };
            if (at + 1..=at + length).contains(&column) {
                let text: String = self.text.get(at..at + length)?.iter().collect();
                let meant = text.chars().any(|c| c.is_ascii_alphanumeric()) || self.is_assignment(at);
                return meant.then_some(Spot { column: at + 1, text, letter: None, value: None });
            }
            at += length;
        }
        None
    }
}

impl Spot {
    /// The column behind it.
    fn end(&self) -> usize {
        self.column + self.text.chars().count().max(1)
    }

    fn holds(&self, column: usize) -> bool {
        (self.column..self.end()).contains(&column)
    }

    fn copy(&self) -> Option<Spot> {
        let (column, letter, value) = (self.column, self.letter, self.value);
        Some(Spot { column, text: self.text.clone(), letter, value })
    }
}

/// Reads a line of the main program; none where it holds no block.
pub fn line(
    programs: &mut ProgramMemory,
    number: u32,
    dialect: &'static Dialect,
    parameters: &Parameters,
) -> io::Result<Option<Line>> {
    let at_start = || (dialect.power_on)(parameters);
    let mut modal = at_start();
    let mut found: Option<Line> = None;
    let mut page_number = 0;
    while let Some(page) = programs.page(FileId(0), page_number)? {
        for block in &page.blocks {
            if block.line > number {
                return Ok(found);
            }
            let words = page.words(block);
            // A program starts where no mode of the text above it is in force.
            if words.first().is_some_and(|w| w.letter == b'O') {
                modal = at_start();
            }
            for code in words.iter().filter(|w| w.letter == b'G').filter_map(g_code) {
                if let Some(row) = dialect.g_code(code) {
                    modal.set(row);
                }
            }
            if block.line == number {
                let line = found.get_or_insert_with(|| empty_line(&modal, dialect));
                line.modal = modal;
                add_block(line, programs, &page, block);
            }
            if words.iter().any(|w| w.letter == b'M' && matches!(w.value(), Value::Number(2.0 | 30.0))) {
                modal = at_start();
            }
        }
        page_number += 1;
    }
    Ok(found)
}

fn empty_line(modal: &Modal, dialect: &'static Dialect) -> Line {
    let (words, text, g_codes, m_codes) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    let parameter_letter = dialect.syntax.parameter_letter.map(char::from);
    let (line_comments, paren_comments) = (dialect.syntax.line_comments, dialect.syntax.paren_comments);
    let compares_by_signs = dialect.syntax.operators.iter().any(|(name, ..)| *name == "==");
    Line {
        words,
        text,
        parameter_letter,
        line_comments,
        paren_comments,
        compares_by_signs,
        modal: *modal,
        g_codes,
        m_codes,
    }
}

fn add_block(line: &mut Line, programs: &ProgramMemory, page: &Page, block: &Block) {
    let Some(text) = programs.text(page.file) else { return };
    let column = |span: Span| {
        let (bytes, at) = text.line_of(span, LINE).ok()?;
        let before = text.encoding().decode(bytes.get(..at)?).chars().count();
        Some((before + 1, text.encoding().decode(&bytes).into_owned()))
    };
    for word in page.words(block) {
        let span = page.word_span(block, word);
        let Some((column, _)) = column(span) else { continue };
        // A parameter that is set stands among the words on some controls; its pieces are explained.
        if word.letter == b'#' {
            continue;
        }
        let value = match word.value() {
            Value::Number(number) => Some(number),
            Value::Expression(_) | Value::Text(_) => None,
        };
        line.words.push(Spot { column, text: programs.slice(span), letter: Some(word.letter), value });
        line.g_codes.extend(Some(word).filter(|w| w.letter == b'G').and_then(g_code));
        line.m_codes.extend(Some(word).filter(|w| w.letter == b'M').and_then(m_code));
    }
    if let Some(Statement::Directive(place)) = page.statement(block)
        && let Some(directive) = page.directive(*place)
    {
        for name in page.directive_names(directive) {
            let offset = page.offset + u64::from(name.at);
            let span = Span { offset, len: name.len, ..page.block_span(block) };
            let Some((column, _)) = column(span) else { continue };
            line.words.push(Spot { column, text: programs.slice(span), letter: None, value: None });
        }
    }
    if line.text.is_empty()
        && let Some((_, whole)) = column(page.block_span(block))
    {
        line.text = whole.chars().collect();
    }
}

/// The number of a G word in tenths.
pub fn g_code(word: &Word) -> Option<u16> {
    match word.value() {
        Value::Number(number) => tenths(number),
        Value::Expression(_) | Value::Text(_) => None,
    }
}

/// A code's number in tenths, where it is one.
pub fn tenths(number: f64) -> Option<u16> {
    let tenths = (number * 10.0).round();
    ((tenths / 10.0 - number).abs() < 1e-9 && (0.0..10_000.0).contains(&tenths)).then_some(tenths as u16)
}

fn m_code(word: &Word) -> Option<u16> {
    match word.value() {
        Value::Number(n) if n.fract() == 0.0 && (0.0..10_000.0).contains(&n) => Some(n as u16),
        _ => None,
    }
}

/// Whether a form such as `G84 X_ Y_ (Q_ V_)` holds an address.
pub fn has_address(format: &str, letter: u8) -> bool {
    let pieces = format.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_' || c == '#'));
    let of_letter = |piece: &str| piece.as_bytes().first() == Some(&letter);
    pieces.filter(|p| of_letter(p)).any(|p| !p.as_bytes().get(1).is_some_and(u8::is_ascii_digit))
}

/// Codes whose axis words are no end point of a move.
pub fn takes_axes(group: Group) -> bool {
    matches!(group, Group::NonModal | Group::Scaling | Group::Rotation | Group::Cycle | Group::Motion)
}
