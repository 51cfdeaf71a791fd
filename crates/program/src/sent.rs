//! Text that is sent bit by bit: what is still needed of it is kept, and no more.
//!
//! Offsets count from the first byte ever sent, so that a span keeps its meaning while others are given back.

use crate::lexer::MAX_LINE;
use std::fmt;

/// Bytes kept at most; a sender that gets on faster than the machine has to wait.
pub const MOST_KEPT: usize = 1 << 20;

/// Why bytes were not taken. None of them was.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Refused {
    /// There is no room until lines are done.
    Full,
    /// A line is longer than any control takes.
    LineTooLong,
    /// The text has ended, or is none that grows.
    Ended,
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Refused::Full => "there is no room until lines are done",
            Refused::LineTooLong => "a line is too long",
            Refused::Ended => "the text has ended",
        })
    }
}

impl std::error::Error for Refused {}

/// The bytes of a text that is being sent.
#[derive(Debug, Default)]
pub(crate) struct Sent {
    bytes: Vec<u8>,
    /// Offset of the first byte that is kept.
    start: u64,
    /// How many of the kept bytes are whole lines.
    whole: usize,
    has_ended: bool,
}

impl Sent {
    /// Takes more bytes. CR alone ends a line as LF does: it is kept as LF, so that a page of the lexer always
    /// ends with one.
    pub fn append(&mut self, bytes: &[u8]) -> Result<(), Refused> {
        if self.has_ended {
            return Err(Refused::Ended);
        }
        if self.bytes.len().saturating_add(bytes.len()) > MOST_KEPT {
            return Err(Refused::Full);
        }
        let before = self.bytes.len();
        let whole_before = self.whole;
        // A CR that ended what came before is only now known to stand alone.
        let last_is_cr = self.bytes.last() == Some(&b'\r') && self.whole < before;
        self.bytes.extend_from_slice(bytes);
        let mut line = self.whole;
        let mut too_long = false;
        for at in before - usize::from(last_is_cr)..self.bytes.len() {
            let next_is_feed = self.bytes.get(at + 1).map(|next| *next == b'\n');
            let Some(byte) = self.bytes.get_mut(at) else { break };
            if *byte == b'\r' && next_is_feed == Some(false) {
                *byte = b'\n';
            }
            if *byte == b'\n' {
                self.whole = at + 1;
                line = at + 1;
            }
            too_long |= at + 1 - line > MAX_LINE - 2;
        }
        if too_long {
            self.bytes.truncate(before);
            self.whole = whole_before;
            if let (true, Some(last)) = (last_is_cr, self.bytes.last_mut()) {
                *last = b'\r';
            }
            return Err(Refused::LineTooLong);
        }
        Ok(())
    }

    /// Nothing more comes.
    pub fn end(&mut self) {
        self.has_ended = true;
        self.whole = self.bytes.len();
    }

    /// Whether more may come.
    pub fn is_open(&self) -> bool {
        !self.has_ended
    }

    /// Offset of the first byte that is kept.
    pub fn start(&self) -> u64 {
        self.start
    }

    /// Offset behind the last byte that came.
    pub fn len(&self) -> u64 {
        self.start + self.bytes.len() as u64
    }

    /// Offset behind the last whole line.
    pub fn whole(&self) -> u64 {
        self.start + self.whole as u64
    }

    /// Up to `len` bytes from `offset` on; `None` where they were given back.
    pub fn window(&self, offset: u64, len: usize) -> Option<&[u8]> {
        let from = usize::try_from(offset.checked_sub(self.start)?).ok()?.min(self.bytes.len());
        self.bytes.get(from..from.saturating_add(len).min(self.bytes.len()))
    }

    /// The bytes before `offset` are not needed any more.
    pub fn give_back(&mut self, offset: u64) {
        let done = offset.saturating_sub(self.start).min(self.whole as u64) as usize;
        // Moving what is left costs as much as what goes saves.
        if done * 2 >= self.bytes.len() {
            self.bytes.drain(..done);
            self.start += done as u64;
            self.whole -= done;
        }
    }

    /// Forgets every byte that came from `offset` on; how many lines they were.
    pub fn forget(&mut self, offset: u64) -> u32 {
        let from = offset.saturating_sub(self.start).min(self.bytes.len() as u64) as usize;
        let gone = self.bytes.get(from..).unwrap_or(&[]);
        let ends = gone.iter().filter(|byte| **byte == b'\n').count();
        // What was begun and not ended is a line too.
        let lines = ends + usize::from(!gone.is_empty() && gone.last() != Some(&b'\n'));
        self.start += self.bytes.len() as u64;
        self.bytes.clear();
        self.whole = 0;
        u32::try_from(lines).unwrap_or(u32::MAX)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_whole_once_their_end_is_there() {
        let mut sent = Sent::default();
        sent.append(b"G0 X1\nG1").unwrap();
        assert_eq!((sent.len(), sent.whole()), (8, 6));
        sent.append(b" X2\r").unwrap();
        assert_eq!(sent.whole(), 6, "the CR may be the first half of CR LF");
        sent.append(b"G4").unwrap();
        assert_eq!((sent.whole(), sent.window(6, 7)), (12, Some(&b"G1 X2\nG"[..])));
        sent.append(b" P1\r\n").unwrap();
        assert_eq!(sent.window(12, 99), Some(&b"G4 P1\r\n"[..]));
        sent.end();
        assert_eq!(sent.append(b"M30"), Err(Refused::Ended));
    }

    #[test]
    fn what_is_refused_changes_nothing() {
        let mut sent = Sent::default();
        sent.append(b"G0\nX1\r").unwrap();
        let long = vec![b'X'; MAX_LINE];
        assert_eq!(sent.append(&long), Err(Refused::LineTooLong));
        assert_eq!(sent.append(&vec![b'\n'; MOST_KEPT]), Err(Refused::Full));
        assert_eq!((sent.len(), sent.whole(), sent.window(0, 99)), (6, 3, Some(&b"G0\nX1\r"[..])));
    }

    #[test]
    fn what_is_given_back_is_gone_and_offsets_stay() {
        let mut sent = Sent::default();
        sent.append(b"G0 X1\nG0 X2\nG0 X3\nG0").unwrap();
        sent.give_back(12);
        assert_eq!((sent.start(), sent.len(), sent.whole()), (12, 20, 18));
        assert_eq!((sent.window(0, 6), sent.window(12, 5)), (None, Some(&b"G0 X3"[..])));
        // Bytes of a line that is not whole stay, whatever is said.
        sent.give_back(99);
        assert_eq!((sent.start(), sent.window(18, 9)), (18, Some(&b"G0"[..])));
        assert_eq!(sent.forget(18), 1);
        assert_eq!((sent.len(), sent.whole()), (20, 20));
    }
}
