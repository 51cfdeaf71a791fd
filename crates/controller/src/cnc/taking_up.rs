//! A program is taken up in its midst, and what a reset leaves for it (`restart`).

use super::program_spindle::ProgramSpindle;
use super::{Cnc, State};
use crate::restart::{Interrupted, Journal, Present, Restart};
use ferrocut_geometry::Position;
use ferrocut_interpreter::AtRest;
use ferrocut_machine::{Alarm, Fault, MemoryChange};
use ferrocut_program::Span;
use ferrocut_toolpath::{SpindleState, Step};
use std::collections::VecDeque;

/// What is kept to take a run up again.
#[derive(Default)]
pub(super) struct TakingUp {
    journal: Option<Box<Journal>>,
    /// It is being begun, where blocks are read.
    awaits_journal: bool,
    /// What is done before the program goes on.
    lead_in: VecDeque<Step>,
    leads: Leads,
    /// Where the axes stood when the block was broken off to which the lead-in goes: while it is on its way there, that
    /// is where the run was broken off, wherever the lead-in itself ends.
    broken_at: Option<Position>,
    /// The lead-in itself was broken off.
    stopped_short: bool,
    /// The number and the text of the block being run.
    pub at: (u64, Span),
    /// The tool in the spindle, and the one that was called last.
    pub tools: (u32, u32),
    /// The tool in the spindle by the ladder, where that tells it.
    pub told_tool: Option<u32>,
}

/// How far what leads to the place of a restart has come.
#[derive(Clone, Copy, PartialEq, Eq, Default)]
enum Leads {
    #[default]
    Nothing,
    /// Its steps are being taken.
    Steps,
    /// They are taken; moves up to this tag are of it.
    Moves(u64),
}

impl TakingUp {
    pub fn new(tools: (u32, u32)) -> TakingUp {
        TakingUp { tools, ..TakingUp::default() }
    }
}

impl Cnc {
    /// What is kept of the run, once it was started: until another program is loaded, or this one anew.
    pub fn journal(&self) -> Option<&Journal> {
        self.taking_up.journal.as_deref()
    }

    /// Somebody changes a value of the memory by hand. A run that is taken up has it from the block on that was being read
    /// then, as this run has.
    pub fn change_memory(&mut self, change: MemoryChange) {
        // It is of the run as that began.
        self.journal_mut();
        let interpreter = self.interpreter.own();
        interpreter.change_memory(&change);
        let block = interpreter.blocks_begun();
        if let Some(journal) = self.journal_mut().filter(|journal| journal.interrupted().is_none()) {
            journal.change(block, change);
        }
    }

    /// Between programs the tool in the spindle is the one that the ladder says: a change that was broken off may have come
    /// to its end or not.
    pub(super) fn follow_tool(&mut self) {
        let Some(tool) = self.taking_up.told_tool else { return };
        let is_said = self.taking_up.tools.0 == tool && self.interpreter.tools().0 == tool;
        if is_said || self.is_under_way() || self.state == State::Resetting || !self.interpreter.is_here() {
            return;
        }
        self.taking_up.tools.0 = tool;
        let tools = self.taking_up.tools;
        self.interpreter.own().set_tools(tools);
    }

    /// Takes the journal of a run that is over.
    pub fn take_journal(&mut self) -> Option<Journal> {
        self.journal_mut();
        self.taking_up.journal.take().map(|journal| *journal)
    }

    /// What is loaded was not begun: a block of what ran before is none of it.
    pub(super) fn no_block_was_run(&mut self) {
        self.taking_up.at = Default::default();
    }

    /// The number and the text of the block being run, or that was run last; line 0 where none was.
    pub fn block_run(&self) -> (u64, Span) {
        self.taking_up.at
    }

    /// The machine as a restart compares it with the program.
    pub fn present(&self) -> Present {
        let mut state = self.interpreter.program_state();
        // Keys and reset stop a spindle that no program does.
        if self.spindle.told() == 0.0 {
            state.spindle = SpindleState::Off;
        }
        Present { state, position: self.motion.position(), renamed: self.renamed }
    }

    /// Takes a program up in its midst: at cycle start what leads there is done, then it goes on. Only while the
    /// axes stand and no program is under way.
    ///
    /// # Errors
    /// [`Fault::RestartMoving`] else.
    pub fn restart(&mut self, restart: Restart, lead_in: VecDeque<Step>) -> Result<(), Box<Alarm>> {
        let is_free = matches!(self.state, State::Ready | State::Ended | State::Reset);
        if !is_free || self.manual.is_active || !self.motion.at_rest() {
            return Err(Box::new(Alarm::core(Fault::RestartMoving, restart.span)));
        }
        let (block, span) = (restart.block, restart.span);
        self.taking_up.broken_at = restart.broken_at;
        let (mut interpreter, journal) = restart.into_parts();
        interpreter.look_back();
        self.touches = None;
        self.wait_for_start();
        self.program_spindle = ProgramSpindle::taken_up(interpreter.program_state().spindle);
        self.span = span;
        self.taking_up.at = (block, span);
        self.taking_up.lead_in = lead_in;
        self.taking_up.leads = Leads::Steps;
        (self.taking_up.journal, self.taking_up.awaits_journal) = (Some(Box::new(journal)), false);
        *self.interpreter.own() = interpreter;
        let at = self.motion.position();
        self.motion.rename(at);
        Ok(())
    }

    /// A program is started from its first block: what it starts from is kept. What is sent bit by bit is not taken
    /// up again (GSK990MC part 2, 10.1.9, note 8).
    pub(super) fn begin_journal(&mut self) {
        let is_program = self.touches.is_none() && !self.interpreter.is_open();
        if self.state == State::Ready && self.taking_up.journal.is_none() && is_program {
            self.interpreter.own().look_back();
            self.taking_up.journal = self.interpreter.begin_journal(self.renamed);
            self.taking_up.awaits_journal = self.taking_up.journal.is_none();
        }
    }

    /// Takes the journal that was begun beside, as it comes.
    pub(super) fn take_up_journal(&mut self) {
        let Some(journal) = self.interpreter.take_journal() else { return };
        match std::mem::take(&mut self.taking_up.awaits_journal) {
            true => self.taking_up.journal = Some(journal),
            false => self.interpreter.forget_journal(Some(journal)),
        }
    }

    /// The journal, to note something in it. Where it is not here yet it is waited for.
    fn journal_mut(&mut self) -> Option<&mut Journal> {
        if std::mem::take(&mut self.taking_up.awaits_journal) {
            self.taking_up.journal = self.interpreter.await_journal();
        }
        self.taking_up.journal.as_deref_mut()
    }

    /// Another program, or this one anew.
    pub(super) fn forget_journal(&mut self) {
        self.forget_touches();
        self.taking_up.awaits_journal = false;
        let journal = self.taking_up.journal.take();
        self.interpreter.forget_journal(journal);
        self.forget_lead_in();
    }

    fn forget_lead_in(&mut self) {
        self.taking_up.lead_in.clear();
        self.taking_up.leads = Leads::Nothing;
        self.taking_up.stopped_short = false;
    }

    /// All comes to rest: whether the machine was still on its way to the place of a restart.
    pub(super) fn break_off_lead_in(&mut self) {
        self.taking_up.stopped_short |= self.is_leading_in();
    }

    /// Where the run was broken off that is being taken up, as long as it is not; none behind that.
    pub fn broken_at(&self) -> Option<Position> {
        self.taking_up.broken_at.filter(|_| self.taking_up.stopped_short || self.is_leading_in())
    }

    pub(super) fn next_of_lead_in(&mut self) -> Option<Step> {
        let step = self.taking_up.lead_in.pop_front();
        if step.is_none() && self.taking_up.leads == Leads::Steps {
            self.taking_up.leads = Leads::Moves(self.next_tag);
        }
        step
    }

    /// Whether the machine is still on its way to the place where a program is taken up.
    pub fn is_leading_in(&self) -> bool {
        match self.taking_up.leads {
            Leads::Nothing => false,
            Leads::Steps => true,
            Leads::Moves(end) => self.given.front().is_some_and(|given| given.tag < end),
        }
    }

    /// The machine comes to a block.
    pub(super) fn comes_to(&mut self, block: u64, span: Span) {
        if self.taking_up.at.0 != block {
            self.interpreter.forget_before(block);
        }
        self.taking_up.at = (block, span);
    }

    /// Tells the program what the machine found, and keeps it for a restart.
    pub(super) fn tell_program(&mut self, at_rest: &AtRest) {
        let block = self.taking_up.at.0;
        if let Some(journal) = self.journal_mut() {
            journal.answer(block, *at_rest);
        }
        self.interpreter.own().came_to_rest(at_rest);
    }

    /// The rest of the program is forgotten, and M functions end (GSK990MC part 2, 2.3.1). The interpreter was ahead
    /// of the machine: it is told of it.
    pub(super) fn forget_program(&mut self) {
        if self.auxiliary.is_none() {
            self.spindle.command(SpindleState::Off, &Position::ZERO);
        }
        // It is of the run as that began.
        let has_journal = self.journal_mut().is_some();
        let ((block, span), tools) = (self.taking_up.at, self.taking_up.tools);
        let stood = self.retrace.take_broken_off().unwrap_or(self.commanded);
        let at = self.broken_at().unwrap_or(stood);
        self.supervisor.comes_to_rest(self.commanded);
        match self.touches.take() {
            // No block of the program was run.
            Some(_) => self.interpreter.own().reset(self.commanded),
            None => self.interpreter.own().reset_at(block, self.commanded),
        }
        self.interpreter.own().set_tools(tools);
        self.forget_lead_in();
        let left = has_journal.then(|| self.interpreter.memory().clone());
        if let (Some(journal), Some(left)) = (&mut self.taking_up.journal, left) {
            journal.interrupt(Interrupted { block, span, at }, left);
        }
    }
}
