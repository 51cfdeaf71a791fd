//! The bytes of a program file, held whole or read in windows.
//!
//! A file larger than [`WHOLE`] is never held: windows of it are read where they are wanted. Reading
//! rather than mapping, because a file that someone shortens while it is mapped kills the process.

use crate::encoding::Encoding;
use crate::sent::{Refused, Sent};
use crate::span::Span;
use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom};
use std::path::Path;
use std::sync::{Mutex, PoisonError};

/// Files up to this size are held whole.
pub const WHOLE: u64 = 4 << 20;

/// Bytes looked at to tell text from other data; further on, a control character is one defect in a
/// program and not the sign of a picture. The encoding is told from up to [`WHOLE`] bytes.
const SAMPLE: usize = 1 << 16;

/// Why a file is no program text.
#[derive(Debug)]
pub enum OpenError {
    /// It cannot be read.
    Io(io::Error),
    /// It is a folder.
    Folder,
    /// It holds bytes that no text has.
    NotText,
    /// It is UTF-16, which no control reads.
    Utf16,
    /// There is nothing in it but blanks and padding.
    Empty,
}

#[derive(Debug)]
enum Bytes {
    Held(Vec<u8>),
    /// Locked from moving the file's position until what stands there is read.
    Windows(Mutex<File>),
    /// More of it may come.
    Sent(Sent),
}

/// The bytes of one program file.
#[derive(Debug)]
pub struct Text {
    bytes: Bytes,
    len: u64,
    encoding: Encoding,
}

impl Text {
    /// Opens a file.
    pub fn open(path: &Path) -> Result<Text, OpenError> {
        let mut file = File::open(path).map_err(OpenError::Io)?;
        let about = file.metadata().map_err(OpenError::Io)?;
        if about.is_dir() {
            return Err(OpenError::Folder);
        }
        if !about.is_file() {
            // A pipe or device has no length: read it as a stream is read.
            return Text::from_reader(file);
        }
        if about.len() <= WHOLE {
            let mut bytes = Vec::with_capacity(about.len() as usize);
            file.read_to_end(&mut bytes).map_err(OpenError::Io)?;
            return Text::from_bytes(bytes);
        }
        let mut start = vec![0; WHOLE as usize];
        file.read_exact(&mut start).map_err(OpenError::Io)?;
        let encoding = examine(&start, false)?;
        Ok(Text { bytes: Bytes::Windows(Mutex::new(file)), len: about.len(), encoding })
    }

    /// Takes everything that `reader` gives. Above [`WHOLE`] it is kept in a temporary file that
    /// vanishes with the value.
    pub fn from_reader(mut reader: impl Read) -> Result<Text, OpenError> {
        let mut bytes = Vec::new();
        reader.by_ref().take(WHOLE + 1).read_to_end(&mut bytes).map_err(OpenError::Io)?;
        if bytes.len() as u64 <= WHOLE {
            return Text::from_bytes(bytes);
        }
        let encoding = examine(&bytes, false)?;
        let mut file = tempfile::tempfile().map_err(OpenError::Io)?;
        io::copy(&mut bytes.as_slice(), &mut file).map_err(OpenError::Io)?;
        let rest = io::copy(&mut reader, &mut file).map_err(OpenError::Io)?;
        Ok(Text { len: bytes.len() as u64 + rest, bytes: Bytes::Windows(Mutex::new(file)), encoding })
    }

    /// Text that is already in memory.
    pub fn from_bytes(bytes: Vec<u8>) -> Result<Text, OpenError> {
        let encoding = match bytes.get(..WHOLE as usize) {
            Some(start) if start.len() < bytes.len() => examine(start, false)?,
            _ => examine(&bytes, true)?,
        };
        if bytes.iter().skip(encoding.mark).all(is_blank) {
            return Err(OpenError::Empty);
        }
        Ok(Text { len: bytes.len() as u64, bytes: Bytes::Held(bytes), encoding })
    }

    /// Text that is sent bit by bit, nothing of it yet. What people read in it is UTF-8.
    pub fn sent() -> Text {
        Text { bytes: Bytes::Sent(Sent::default()), len: 0, encoding: Encoding::default() }
    }

    /// More of a text that is sent. Nothing is taken where this is refused.
    pub fn append(&mut self, bytes: &[u8]) -> Result<(), Refused> {
        let Bytes::Sent(sent) = &mut self.bytes else { return Err(Refused::Ended) };
        sent.append(bytes)?;
        self.len = sent.len();
        Ok(())
    }

    /// Nothing more of a text comes that is sent.
    pub fn end(&mut self) {
        if let Bytes::Sent(sent) = &mut self.bytes {
            sent.end();
        }
    }

    /// Whether it is sent bit by bit, ended or not.
    pub fn is_sent(&self) -> bool {
        matches!(self.bytes, Bytes::Sent(_))
    }

    /// Whether more of it may come.
    pub fn is_open(&self) -> bool {
        matches!(&self.bytes, Bytes::Sent(sent) if sent.is_open())
    }

    /// Offset behind what can be read as lines by now.
    pub(crate) fn readable(&self) -> u64 {
        match &self.bytes {
            Bytes::Sent(sent) => sent.whole(),
            _ => self.len,
        }
    }

    /// Offset of the first byte that is kept.
    fn start(&self) -> u64 {
        match &self.bytes {
            Bytes::Sent(sent) => sent.start(),
            _ => 0,
        }
    }

    /// The bytes of a text that is sent are not needed any more before `offset`.
    pub(crate) fn give_back(&mut self, offset: u64) {
        if let Bytes::Sent(sent) = &mut self.bytes {
            sent.give_back(offset);
        }
    }

    /// Forgets what came of a text that is sent from `offset` on; how many lines they were.
    pub(crate) fn forget(&mut self, offset: u64) -> u32 {
        match &mut self.bytes {
            Bytes::Sent(sent) => sent.forget(offset),
            _ => 0,
        }
    }

    /// Length, bytes; of a text that is sent, all that came so far.
    pub fn len(&self) -> u64 {
        self.len
    }

    /// Whether there are no bytes.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Encoding of what people read in it.
    pub fn encoding(&self) -> Encoding {
        self.encoding
    }

    /// Calls `with` with up to `len` bytes from `offset` on, fewer only at the end of the file. What
    /// must be read for it is read into `buffer`. Bytes that were given back are [`io::ErrorKind::NotSeekable`].
    pub fn window<R>(
        &self,
        offset: u64,
        len: usize,
        buffer: &mut Vec<u8>,
        with: impl FnOnce(&[u8]) -> R,
    ) -> io::Result<R> {
        match &self.bytes {
            Bytes::Held(bytes) => {
                let start = usize::try_from(offset).unwrap_or(usize::MAX).min(bytes.len());
                let end = start.saturating_add(len).min(bytes.len());
                Ok(with(bytes.get(start..end).unwrap_or(&[])))
            }
            Bytes::Windows(file) => {
                buffer.clear();
                let mut file = file.lock().unwrap_or_else(PoisonError::into_inner);
                file.seek(SeekFrom::Start(offset))?;
                file.by_ref().take(len as u64).read_to_end(buffer)?;
                drop(file);
                Ok(with(buffer))
            }
            Bytes::Sent(sent) => match sent.window(offset, len) {
                Some(bytes) => Ok(with(bytes)),
                None => Err(given_back()),
            },
        }
    }

    /// The line that `span` stands in, without its end, at most `most` bytes of it, and where in what
    /// is returned the span starts. A long line is shortened around the start of the span.
    pub fn line_of(&self, span: Span, most: usize) -> io::Result<(Vec<u8>, usize)> {
        let first = self.start().max(self.encoding.mark as u64);
        let before = span.offset.saturating_sub(first).min(most as u64 / 2);
        let start = span.offset - before;
        let mut buffer = Vec::new();
        self.window(start, most.saturating_add(before as usize), &mut buffer, |bytes| {
            // Less than that only where the file became shorter.
            let before = bytes.len().min(before as usize);
            let is_end = |b: &u8| matches!(b, b'\n' | b'\r');
            let head = bytes.get(..before).unwrap_or(&[]);
            let from = head.iter().rposition(is_end).map_or(0, |at| at + 1);
            let tail = bytes.get(before..).unwrap_or(&[]);
            let to = before + tail.iter().position(is_end).unwrap_or(tail.len());
            let to = to.min(from.saturating_add(most));
            (bytes.get(from..to).unwrap_or(&[]).to_vec(), before - from)
        })
    }

    /// The bytes of a span.
    pub fn slice(&self, span: Span) -> io::Result<Vec<u8>> {
        let mut buffer = Vec::new();
        self.window(span.offset, span.len as usize, &mut buffer, <[u8]>::to_vec)
    }
}

/// The error of lines that are not kept any more.
pub(crate) fn given_back() -> io::Error {
    io::Error::from(io::ErrorKind::NotSeekable)
}

/// Tells text from other data and finds its encoding, from the start of a file or all of it.
fn examine(start: &[u8], is_all: bool) -> Result<Encoding, OpenError> {
    let encoding = Encoding::detect(start, is_all);
    if !encoding.is_ascii_based() {
        return Err(OpenError::Utf16);
    }
    // Control characters other than line ends, tabs and the old end-of-file mark mean a picture, an
    // archive, a program. Tapes are padded with zero bytes at either end, never between words.
    let sample = start.get(..SAMPLE).unwrap_or(start);
    let inside = match (sample.iter().position(|b| !is_blank(b)), sample.iter().rposition(|b| !is_blank(b))) {
        (Some(from), Some(to)) => sample.get(from..=to).unwrap_or(sample),
        // No tape has as much padding before its program.
        _ if sample.len() == SAMPLE && sample.contains(&0) => return Err(OpenError::NotText),
        _ => &[],
    };
    let is_control =
        |b: &u8| *b < 0x20 && !matches!(b, b'\n' | b'\r' | b'\t' | 0x1A | 0x0C | 0x0B | 0x11..=0x14);
    if inside.iter().any(is_control) {
        return Err(OpenError::NotText);
    }
    Ok(encoding)
}

fn is_blank(byte: &u8) -> bool {
    byte.is_ascii_whitespace() || *byte == 0
}
