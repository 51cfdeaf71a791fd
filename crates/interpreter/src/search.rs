//! Interpreting to a block and no further: how a program is entered in its midst.
//!
//! A mark is set at a block and the interpreter is run as ever; it gives out nothing more once the marked block
//! comes, and stands before it as a full run does: modal codes, offsets, variables, calls and loops are those
//! of the program, since it is the program that was interpreted. What cutter compensation and corner rounding
//! hold back then belongs to blocks before; it comes out behind the mark and is left out, having been done.

use crate::Fallible;
use crate::custom::Custom;
use crate::interpreter::Interpreter;
use ferrocut_geometry::Position;
use ferrocut_program::{FileId, Place, ProgramId, Span};
use std::io;

/// Where interpretation ends.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Until {
    /// Before a block is reached for the `pass`th time, counted from 1.
    Block {
        /// The block.
        place: Place,
        /// Which time.
        pass: u64,
    },
    /// Before the block with this number is begun, each pass of a block counted, from 1
    /// ([`Step::block`](ferrocut_toolpath::Step::block)).
    Number(u64),
}

/// A mark, and whether it was come to.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mark {
    until: Until,
    /// Blocks begun after which it is given up.
    most: u64,
    /// How often the block was reached.
    passes: u64,
    is_met: bool,
    is_given_up: bool,
}

impl Mark {
    /// Whether the block at `at` is not begun: it is the marked one, or the search is given up. `begun` were begun
    /// before it.
    #[inline]
    pub(crate) fn stops_before(&mut self, at: Place, begun: u64) -> bool {
        self.is_met = match self.until {
            Until::Number(number) => begun + 1 >= number,
            Until::Block { place, pass } => {
                if at == place {
                    self.passes += 1;
                }
                at == place && self.passes >= pass
            }
        };
        self.is_given_up = !self.is_met && begun >= self.most;
        self.is_met || self.is_given_up
    }

    /// Whether no further block is begun.
    #[inline]
    pub(crate) fn stands(&self) -> bool {
        self.is_met || self.is_given_up
    }
}

impl Interpreter {
    /// The first block that begins on a line of a file or below it, and its place in the text.
    pub fn block_of_line(&mut self, file: FileId, line: u32) -> io::Result<Option<(Place, Span)>> {
        let mut number = 0;
        while let Some(page) = self.programs.page(file, number)? {
            let found = page.blocks.iter().position(|block| page.block_span(block).line >= line);
            if let Some((at, block)) = found.and_then(|at| Some((at, page.blocks.get(at)?))) {
                let place = Place { file, page: number, block: at as u32 };
                return Ok(Some((place, page.block_span(block))));
            }
            number += 1;
        }
        Ok(None)
    }

    /// A file that the programs were read from, by its name.
    pub fn file_named(&mut self, name: &str) -> Option<FileId> {
        self.programs.file_named(name)
    }

    /// The file that has a program that can be called, opened if it was not yet.
    pub fn file_of(&mut self, id: &ProgramId) -> Option<FileId> {
        self.programs.find_program(id).ok().flatten().map(|place| place.file)
    }

    /// Gives out nothing more once this block comes; `None` lets the program go on.
    pub fn set_mark(&mut self, until: Option<Until>) {
        match until {
            Some(until) => self.set_mark_within(until, u64::MAX),
            None => self.flow.set_mark(None),
        }
    }

    /// The same; nothing more is given out either once `most` blocks were begun.
    pub fn set_mark_within(&mut self, until: Until, most: u64) {
        let mark = Mark { until, most, passes: 0, is_met: false, is_given_up: false };
        self.flow.set_mark(Some(mark));
    }

    /// Whether the interpreter stands before the block that was marked.
    pub fn is_at_mark(&self) -> bool {
        self.flow.mark().is_some_and(|mark| mark.is_met)
    }

    /// Whether no further block is begun, the mark being met or given up.
    #[inline]
    pub(crate) fn stands(&self) -> bool {
        self.flow.mark().is_some_and(Mark::stands)
    }

    /// How often the marked block was reached so far.
    pub fn passes_of_mark(&self) -> u64 {
        self.flow.mark().map_or(0, |mark| mark.passes)
    }

    /// Blocks begun so far, each pass counted.
    pub fn blocks_begun(&self) -> u64 {
        self.flow.begun()
    }

    /// Line of the main program's block run last, counted from 1: within a subprogram that of its call. 0 before the first.
    pub fn main_line(&self) -> u32 {
        self.flow.main_line()
    }

    /// The block run last.
    pub fn last_block(&self) -> Span {
        self.flow.last()
    }

    /// Whether the program that stands for the tool change is being run.
    pub fn changes_tool(&self) -> bool {
        self.flow.runs_custom(Custom::ToolChange)
    }

    /// Whether the barrier given out last is that of a tool change, which asks for nothing but auxiliary lock.
    pub fn asks_for_lock(&self) -> bool {
        self.asks_for_lock
    }

    /// How many subprograms and macros are being run.
    pub fn calls(&self) -> usize {
        self.flow.depth_of_calls() + self.ngc.o_words.depth()
    }

    /// Takes all blocks begun so far as done: their steps that are still held back are not given out.
    pub fn leave_begun_blocks_behind(&mut self) {
        self.passed = self.flow.begun();
    }

    /// Where the axes are commanded to be when the block that comes begins. While stages hold moves back that is
    /// known once later blocks are, which are read on a copy of the interpreter.
    pub fn start_of_next_block(&self) -> Fallible<Position> {
        let mut at = self.output.commanded();
        if !self.output.looks_ahead() {
            return Ok(at);
        }
        let mut ahead = self.looking_ahead();
        // What the block that comes does wrong is told when it is run.
        while let Some(Ok(step)) = ahead.next() {
            if step.block > self.flow.begun() {
                break;
            }
            at = step.op.target().copied().unwrap_or(at);
        }
        Ok(at)
    }

    /// The tool in the spindle, and the one that was called last, where blocks were read that the machine did not
    /// come to.
    pub fn set_tools(&mut self, (in_spindle, called): (u32, u32)) {
        (self.technology.in_spindle, self.technology.tool) = (in_spindle, called);
    }

    /// The text of the block that comes, if one does.
    pub fn next_block(&mut self) -> Option<Span> {
        let place = self.flow.next_place();
        let page = self.programs.page(place.file, place.page).ok()??;
        page.blocks.get(place.block as usize).map(|block| page.block_span(block))
    }

    /// Whether a main program that ends with M99 is run again for ever.
    pub fn loops_forever(&self) -> bool {
        self.options.loops_forever
    }

    /// The same, to be set.
    pub fn set_loops_forever(&mut self, forever: bool) {
        self.options.loops_forever = forever;
    }

    /// Somebody changes a value of the memory by hand: what follows from it does too.
    pub fn change_memory(&mut self, change: &ferrocut_machine::MemoryChange) {
        use ferrocut_machine::MemoryChange;
        self.memory.make_change(change);
        match change {
            MemoryChange::WorkOffset(..) => self.zeros_changed(),
            MemoryChange::Parameter(..)
            | MemoryChange::AsDelivered(..)
            | MemoryChange::ReferencePoint(..) => self.parameters_changed(),
            _ => {}
        }
    }

    /// A memory that others changed takes the place of the interpreter's before its first block.
    pub fn set_memory(&mut self, memory: ferrocut_machine::Memory) {
        self.memory = memory;
        self.parameters_changed();
        self.zeros_changed();
    }
}
