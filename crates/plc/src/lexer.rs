//! Ladder text to words with their places.
//!
//! A line is words between blanks or commas; `;` begins a comment, and a line with `%` is the mark of a
//! tape and no instruction.

use crate::fault::{Error, Fault, Span};

/// A word.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Word<'a> {
    /// What it says.
    pub text: &'a str,
    /// Where it stands.
    pub span: Span,
}

/// The words of a line, and what its comment says.
#[derive(Debug)]
pub struct Line<'a> {
    /// At least one.
    pub words: Vec<Word<'a>>,
    /// Behind `;`.
    pub comment: &'a str,
}

/// Reads all lines that have words. Faults are put into `errors`, and reading goes on.
pub fn lines<'a>(bytes: &'a [u8], errors: &mut Vec<Error>) -> Vec<Line<'a>> {
    let mark = if bytes.starts_with(b"\xEF\xBB\xBF") { 3 } else { 0 };
    let mut lines = Vec::new();
    let mut offset = 0;
    for (number, raw) in bytes.split(|b| *b == b'\n').enumerate() {
        let skip = if number == 0 { mark } else { 0 };
        let line = u32::try_from(number + 1).unwrap_or(u32::MAX);
        let start = offset + skip;
        offset += raw.len() + 1;
        let raw = raw.get(skip..).unwrap_or_default();
        if raw.contains(&0) {
            // Text has no NUL: a picture or program was named by mistake. One alarm is enough.
            errors.push(Error::new(Fault::FileFormat, Span { offset: start, len: raw.len(), line }));
            return lines;
        }
        if let Some(line) = words(raw, start, line, errors) {
            lines.push(line);
        }
    }
    lines
}

/// The words of one line; `None` where there are none.
fn words<'a>(raw: &'a [u8], start: usize, line: u32, errors: &mut Vec<Error>) -> Option<Line<'a>> {
    let end = raw.iter().position(|b| *b == b';').unwrap_or(raw.len());
    let (code, comment) = (raw.get(..end)?, raw.get(end + 1..).unwrap_or_default());
    if code.first() == Some(&b'%') {
        return None;
    }
    let comment = std::str::from_utf8(comment).unwrap_or_default().trim();
    let mut words = Vec::new();
    let mut at = 0;
    while let Some(first) = code.get(at..).and_then(|rest| rest.iter().position(|b| !is_blank(*b))) {
        let from = at + first;
        let rest = code.get(from..).unwrap_or_default();
        let len = match rest.first() {
            // A sign of its own, between a name and its address.
            Some(b'=') => 1,
            _ => rest.iter().position(|b| is_blank(*b) || *b == b'=').unwrap_or(rest.len()),
        };
        at = from + len;
        let piece = rest.get(..len).unwrap_or_default();
        let span = Span { offset: start + from, len, line };
        match std::str::from_utf8(piece) {
            Ok(text) if piece == b"=" || piece.iter().all(|b| is_part(*b)) => words.push(Word { text, span }),
            _ => errors.push(Error::new(Fault::OutOfRange, span)),
        }
    }
    (!words.is_empty()).then_some(Line { words, comment })
}

fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\r' | b',')
}

fn is_part(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || matches!(byte, b'.' | b'_' | b'*' | b'+' | b'-' | b'/')
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Number, line and offset of a fault.
    type Told = (u16, u32, usize);

    fn read(text: &str) -> (Vec<Vec<String>>, Vec<Told>) {
        let mut errors = Vec::new();
        let lines = lines(text.as_bytes(), &mut errors);
        let words = lines.iter().map(|l| l.words.iter().map(|w| w.text.to_owned()).collect()).collect();
        (words, errors.iter().map(|e| (e.fault.number(), e.span.line, e.span.offset)).collect())
    }

    #[test]
    fn lines_have_words_and_comments() {
        let (words, errors) =
            read("%@3\n\u{20}RD X0.0 ; 启动\r\n\n; nothing\nMOVE 1111,0000 R0,R1\n*ESP=X8.4\n");
        assert_eq!(words[0], ["RD", "X0.0"]);
        assert_eq!(words[1], ["MOVE", "1111", "0000", "R0", "R1"]);
        assert_eq!(words[2], ["*ESP", "=", "X8.4"]);
        assert!(errors.is_empty() && words.len() == 3);
    }

    #[test]
    fn places_count_bytes_and_lines() {
        let (words, errors) = read("\u{feff}RD X0.0\nWRT Ä0.0\n");
        assert_eq!(words, [vec!["RD", "X0.0"], vec!["WRT"]]);
        assert_eq!(errors, [(1013, 2, 15)]);
        assert_eq!(read("RD X0.0\n\0\u{1}\n").1, [(1028, 2, 8)]);
    }
}
