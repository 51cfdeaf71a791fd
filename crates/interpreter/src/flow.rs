//! The order of blocks: one after the other, through subprograms, to the end of the program.

use crate::Fallible;
use crate::interpreter::Interpreter;
use ferrocut_machine::{Alarm, Fault};
use ferrocut_program::{Block, Page, Place, ProgramId, ProgramMemory, Span};
use std::sync::Arc;

/// A subprogram being run.
#[derive(Clone, Copy, Debug)]
struct Call {
    /// First block of the subprogram.
    program: Place,
    /// Block after the call.
    back: Place,
    /// How often it is still to be run again.
    repeats: u32,
}

/// Blocks run without a step before a program is taken for endless: seconds of work, and more than
/// any program that cuts needs between two moves.
const IDLE_BLOCKS: u64 = 50_000_000;

/// Passes of a main program that ends with M99, where the machine's state never repeats.
const MAX_PASSES: u64 = 10_000;

/// Where execution stands.
#[derive(Debug)]
pub(crate) struct Flow {
    /// The next block.
    place: Place,
    /// The page of `place`, taken out while one of its blocks is executed.
    page: Option<Arc<Page>>,
    calls: Vec<Call>,
    /// Whether a block other than its O word was run of the present program.
    entered: bool,
    /// Span of the block run last.
    last: Span,
    idle: u64,
    passes: u64,
}

impl Flow {
    pub(crate) fn new() -> Flow {
        Flow {
            place: Place::default(),
            page: None,
            calls: Vec::new(),
            entered: false,
            last: Span::default(),
            idle: 0,
            passes: 0,
        }
    }

    fn jump(&mut self, to: Place) {
        self.place = to;
        self.page = None;
        self.entered = false;
    }

    /// Notes that a step was made: the program gets on.
    #[inline]
    pub(crate) fn got_on(&mut self) {
        self.idle = 0;
    }

    /// Whether a subprogram is being run.
    pub(crate) fn in_subprogram(&self) -> bool {
        !self.calls.is_empty()
    }

    /// The page and index of the next block; `None` past the end of the text.
    fn next(&mut self, programs: &mut ProgramMemory) -> std::io::Result<Option<(Arc<Page>, usize)>> {
        loop {
            let page = match self.page.take() {
                Some(page) => page,
                None => match programs.page(self.place.file, self.place.page)? {
                    Some(page) => page,
                    None => return Ok(None),
                },
            };
            let index = self.place.block as usize;
            if index < page.blocks.len() {
                return Ok(Some((page, index)));
            }
            self.place = Place { page: self.place.page + 1, block: 0, ..self.place };
        }
    }
}

impl Interpreter {
    /// Runs one block.
    pub(crate) fn run_block(&mut self) -> Fallible<()> {
        self.flow.idle += 1;
        if self.flow.idle > IDLE_BLOCKS {
            self.ended = true;
            return Err(self.alarm(Fault::EndlessProgram, self.flow.last));
        }
        let (page, index) = match self.flow.next(&mut self.programs) {
            Ok(Some(found)) => found,
            Ok(None) => return self.end_of_text(),
            Err(error) => {
                self.ended = true;
                let alarm = Alarm::core(Fault::FileUnreadable, self.flow.last);
                return Err(Box::new(alarm.with("reason", error.to_string())));
            }
        };
        let at = self.flow.place;
        self.flow.place.block += 1;
        let result = match page.blocks.get(index) {
            Some(block) => {
                self.flow.last = page.block_span(block);
                self.execute(&page, block, index)
            }
            None => Ok(()),
        };
        if (self.flow.place.file, self.flow.place.page) == (at.file, at.page) {
            self.flow.page = Some(page);
        }
        result
    }

    /// The text ended without an end of program.
    fn end_of_text(&mut self) -> Fallible<()> {
        let alarm = self.alarm(Fault::NoProgramEnd, self.flow.last);
        // A checker goes on behind the call of a subprogram that does not end.
        if self.options.keep_going && self.flow.in_subprogram() {
            self.go_back();
        } else {
            self.ended = true;
        }
        Err(alarm)
    }

    /// An O word: where a program starts. Inside a program it means that the one before has no end.
    pub(crate) fn program_number(&mut self, span: Span) -> Fallible<()> {
        if self.flow.entered {
            self.ended = true;
            return Err(self.alarm(Fault::NoProgramEnd, span));
        }
        Ok(())
    }

    /// Notes that a block of the program proper is run.
    #[inline]
    pub(crate) fn enter_program(&mut self) {
        self.flow.entered = true;
    }

    /// Whether the block is left out (GSK990MC: one `/` by the operator's switch, two always).
    #[inline]
    pub(crate) fn is_skipped(&self, block: &Block) -> bool {
        block.skip > 1 || block.skip == 1 && self.options.block_skip
    }

    /// M98 and its kin: runs a subprogram `times` times, then goes on behind the call.
    pub(crate) fn call(&mut self, program: &ProgramId, times: u32, span: Span) -> Fallible<()> {
        if times == 0 {
            return Ok(());
        }
        if self.flow.calls.len() >= self.rules.max_call_depth {
            return Err(self.alarm(Fault::CallsTooDeep, span));
        }
        let found = self.programs.find_program(program).map_err(|error| {
            Box::new(Alarm::core(Fault::FileUnreadable, span).with("reason", error.to_string()))
        })?;
        let Some(start) = found else {
            let mut alarm = self.alarm(Fault::ProgramMissing, span);
            alarm.arguments.push((
                "program",
                match program {
                    ProgramId::Number(n) => format!("O{n:04}").into(),
                    ProgramId::Name(name) => name.as_ref().into(),
                },
            ));
            return Err(alarm);
        };
        self.flow.calls.push(Call { program: start, back: self.flow.place, repeats: times - 1 });
        self.flow.jump(start);
        Ok(())
    }

    /// Returns from the subprogram, or runs it again where the call asked for it. False in the main
    /// program.
    pub(crate) fn go_back(&mut self) -> bool {
        let Some(call) = self.flow.calls.last_mut() else { return false };
        if call.repeats > 0 {
            call.repeats -= 1;
            let start = call.program;
            self.flow.jump(start);
        } else {
            let back = call.back;
            self.flow.calls.pop();
            self.flow.jump(back);
            self.flow.entered = true;
        }
        true
    }

    /// M99 in the main program: its start again (GSK990MC 3.2.3). True where the program ends
    /// instead: at a desk, once the machine's state repeats and another pass would be like the last.
    pub(crate) fn start_again(&mut self, span: Span) -> Fallible<bool> {
        self.flow.passes += 1;
        if !self.options.loops_forever {
            let state = self.fingerprint();
            if self.pass_state.as_ref() == Some(&state) {
                return Ok(true);
            }
            if self.flow.passes > MAX_PASSES {
                self.ended = true;
                return Err(self.alarm(Fault::EndlessProgram, span));
            }
            self.pass_state = Some(state);
        }
        self.flow.jump(Place::default());
        Ok(false)
    }
}
