//! Where in which file a piece of program text stands.

/// A file of program memory; 0 is the main program's.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default, PartialOrd, Ord)]
pub struct FileId(pub u16);

/// A piece of program text. It stays meaningful for a file that is not held in memory.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Span {
    /// First byte, counted from the start of the file.
    pub offset: u64,
    /// Length in bytes; 0 marks a place between bytes.
    pub len: u32,
    /// Line of the first byte, counted from 1; 0 where nothing in the text is meant.
    pub line: u32,
    /// The file.
    pub file: FileId,
}

impl Span {
    /// Whether `other` begins within it.
    pub fn holds(self, other: Span) -> bool {
        let end = self.offset + u64::from(self.len);
        other.line > 0 && self.file == other.file && (self.offset..=end).contains(&other.offset)
    }

    /// The smallest span of one line's text that holds both; `other` is in the same block.
    pub fn to(self, other: Span) -> Span {
        let end = (self.offset + u64::from(self.len)).max(other.offset + u64::from(other.len));
        let offset = self.offset.min(other.offset);
        Span { offset, len: u32::try_from(end - offset).unwrap_or(u32::MAX), ..self }
    }
}
