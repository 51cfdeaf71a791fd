//! The pairs of lines that a DXF file is made of: a group code, and the value that it gives a meaning.

use crate::alarm;
use ferrocut_machine::{Alarm, Fault};
use ferrocut_program::{FileId, Span};

/// One pair.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Pair<'a> {
    /// The group code.
    pub code: i32,
    /// The value's line without blanks around it.
    pub value: &'a [u8],
    /// Where the value stands.
    pub span: Span,
}

impl Pair<'_> {
    /// The value as a number.
    pub fn number(&self) -> Result<f64, Box<Alarm>> {
        let number = std::str::from_utf8(self.value).ok().and_then(|text| text.parse::<f64>().ok());
        number.filter(|n| n.is_finite()).ok_or_else(|| alarm(Fault::DxfValue, self.span))
    }

    /// The value as a whole number; some writers give it decimals.
    pub fn whole(&self) -> Result<i32, Box<Alarm>> {
        let number = self.number()?;
        if number.fract() == 0.0 && (f64::from(i32::MIN)..=f64::from(i32::MAX)).contains(&number) {
            Ok(number as i32)
        } else {
            Err(alarm(Fault::DxfValue, self.span))
        }
    }

    /// Whether this begins the named section, entity or end.
    pub fn is(&self, code: i32, value: &[u8]) -> bool {
        self.code == code && self.value == value
    }
}

/// The pairs of a file, one by one.
pub struct Pairs<'a> {
    bytes: &'a [u8],
    at: usize,
    line: u32,
    file: FileId,
    put_back: Option<Pair<'a>>,
}

impl<'a> Pairs<'a> {
    /// The pairs of the bytes of a file.
    pub fn new(bytes: &'a [u8], file: FileId) -> Pairs<'a> {
        let mark = if bytes.starts_with(b"\xEF\xBB\xBF") { 3 } else { 0 };
        Pairs { bytes, at: mark, line: 1, file, put_back: None }
    }

    /// The next pair. A file that ends without its end mark is cut off.
    pub fn next(&mut self) -> Result<Pair<'a>, Box<Alarm>> {
        if let Some(pair) = self.put_back.take() {
            return Ok(pair);
        }
        loop {
            let (code, at_code) = self.line()?;
            let code = std::str::from_utf8(code).ok().and_then(|text| text.parse::<i32>().ok());
            let code = code.ok_or_else(|| alarm(Fault::DxfGroupCode, at_code))?;
            let (value, span) = self.line()?;
            // 999 is a comment.
            if code != 999 {
                return Ok(Pair { code, value, span });
            }
        }
    }

    /// Gives a pair back, to be the next once more.
    pub fn put_back(&mut self, pair: Pair<'a>) {
        self.put_back = Some(pair);
    }

    /// Where reading stands.
    pub fn here(&self) -> Span {
        Span { offset: self.at as u64, len: 0, line: self.line, file: self.file }
    }

    /// The next line without blanks around it. It ends with LF, CR LF or CR.
    fn line(&mut self) -> Result<(&'a [u8], Span), Box<Alarm>> {
        let rest = self.bytes.get(self.at..).unwrap_or(&[]);
        if rest.is_empty() {
            return Err(alarm(Fault::DrawingTruncated, self.here()));
        }
        let len = rest.iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(rest.len());
        let line = rest.get(..len).unwrap_or(rest);
        let value = line.trim_ascii();
        let blanks = line.len() - line.trim_ascii_start().len();
        let span = Span {
            offset: (self.at + blanks) as u64,
            len: u32::try_from(value.len()).unwrap_or(u32::MAX),
            line: self.line,
            file: self.file,
        };
        let end = match rest.get(len..).unwrap_or(&[]) {
            [b'\r', b'\n', ..] => 2,
            [] => 0,
            _ => 1,
        };
        self.at += len + end;
        self.line = self.line.saturating_add(1);
        Ok((value, span))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs_know_their_lines() {
        let mut pairs = Pairs::new(b"999\r\nmade by hand\r\n  0\r\n SECTION\n 70\r  1\n", FileId(1));
        let first = pairs.next().unwrap();
        assert!(first.is(0, b"SECTION"));
        assert_eq!((first.span.line, first.span.offset, first.span.len), (4, 25, 7));
        let second = pairs.next().unwrap();
        assert_eq!((second.code, second.whole().unwrap(), second.span.line), (70, 1, 6));
        assert_eq!(pairs.next().unwrap_err().fault, Fault::DrawingTruncated);
    }

    #[test]
    fn what_is_no_code_or_number_points_at_its_line() {
        let fault = Pairs::new(b"0\nA\nB\nC\n", FileId(1));
        let mut fault = fault;
        fault.next().unwrap();
        let alarm = fault.next().unwrap_err();
        assert_eq!((alarm.fault, alarm.span.line), (Fault::DxfGroupCode, 3));
        let number = |text: &[u8]| {
            let pair = Pair { code: 10, value: text, span: Span::default() };
            (pair.number().is_ok(), pair.whole().is_ok())
        };
        assert_eq!(number(b"1.50"), (true, false));
        assert_eq!(number(b"2.0"), (true, true));
        assert_eq!(number(b"1e400"), (false, false));
        assert_eq!(number(b"nan"), (false, false));
        assert_eq!(number(b"99999999999"), (true, false));
    }
}
