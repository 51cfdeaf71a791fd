//! A main program that is sent bit by bit: blocks are run as far as they came, and when they fail to come the
//! interpreter starves without ending.
//!
//! The program need not be kept: what is behind the machine is given back. So a block leads on, into other
//! programs and back, and not to another line of a program that is sent.

use crate::flow::Flow;
use crate::interpreter::Interpreter;
use ferrocut_program::{FileId, Place, Refused, Span, Text};

impl Interpreter {
    /// More of the main program ([`Text::sent`]). Refused as a whole where there is no room.
    pub fn append(&mut self, text: &[u8]) -> Result<(), Refused> {
        self.programs.append(text)?;
        self.starved &= text.is_empty();
        Ok(())
    }

    /// Nothing more of the main program comes; its end is the end of its text.
    pub fn end_text(&mut self) {
        self.starved = false;
        self.programs.end_text();
    }

    /// Whether all that came of the main program was run, and more may come. No step is given out until then.
    pub fn is_starved(&self) -> bool {
        self.starved && !self.ended
    }

    /// Whether the main program is sent and may still grow.
    pub fn is_open(&self) -> bool {
        self.programs.text(FileId(0)).is_some_and(Text::is_open)
    }

    /// Number of the last line of the main program all of whose steps and alarms were given out. Not while a
    /// subprogram is run.
    pub fn lines_done(&self) -> u32 {
        let is_under_way = self.has_more_of_block();
        match self.starved && !is_under_way {
            true => self.programs.lines_read(),
            false => self.flow.last_line().saturating_sub(u32::from(is_under_way)),
        }
    }

    /// The machine is at the block of `span`: lines before it are not needed any more.
    pub fn give_back(&mut self, span: Span) {
        if span.file == FileId(0) {
            self.programs.give_back(span.offset);
        }
    }

    /// All that was read is done: no line of it is needed any more.
    pub fn give_back_read(&mut self) {
        self.programs.give_back(u64::MAX);
    }

    /// Goes on behind the end of a program (M02, M30) where the text that is sent goes on.
    pub fn go_on(&mut self) {
        if self.ended && self.is_open() {
            self.ended = false;
            let place = Some(self.flow.next_place()).filter(|place| place.file == FileId(0));
            self.begin_at(place);
            self.ngc.end_calls();
        }
    }

    /// Another program begins at a place of the text that is sent, else behind all that was read.
    pub(crate) fn begin_at(&mut self, place: Option<Place>) {
        self.starved = false;
        self.flow = Flow::new();
        if let Some(place) = place.or_else(|| self.programs.forget_unread()) {
            self.flow.go_on_at(place, self.programs.lines_read());
        }
    }
}
