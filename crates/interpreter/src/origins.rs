//! Where the lines of a program that was made from a drawing come from.

use ferrocut_program::{FileId, Span};

/// The piece of a drawing that caused each line of the main program.
#[derive(Clone)]
pub struct Origins {
    drawing: FileId,
    lines: Vec<Span>,
}

impl Origins {
    /// `lines` holds a span of the file `drawing` for each line, from the first on; those with line 0
    /// were caused by none.
    pub fn new(drawing: FileId, lines: Vec<Span>) -> Origins {
        Origins { drawing, lines }
    }

    /// The file that the spans are of.
    pub fn drawing(&self) -> FileId {
        self.drawing
    }

    /// The place in the drawing for a place in the program; that of another file stays.
    pub fn of(&self, span: Span) -> Span {
        if span.file != FileId(0) {
            return span;
        }
        let line = (span.line as usize).checked_sub(1).and_then(|line| self.lines.get(line));
        line.copied().filter(|span| span.line > 0).unwrap_or(Span { file: self.drawing, ..Span::default() })
    }
}
