//! What was in force where the machine is, while blocks are read ahead of it.
//!
//! A reset forgets the blocks that were read and not run, and with them the codes that they put in force. So whoever
//! runs steps may have this kept for the blocks whose steps are under way, as LinuxCNC keeps it with each move. What
//! blocks wrote to the memory (variables, G10) stays written, as macro statements read ahead do on the Fanuc 0i-M.

use crate::in_force::Shown;
use crate::interpreter::{Interpreter, Location, Technology};
use crate::modal::Modal;
use crate::tool_axes::ToolAxes;
use ferrocut_geometry::Position;
use std::collections::VecDeque;

/// Blocks that are kept at most; motion holds the steps of fewer.
const MOST: usize = 8192;

/// What was in force when a block gave out its last step so far.
#[derive(Clone, Debug)]
struct Executed {
    block: u64,
    modal: Modal,
    location: Location,
    technology: Technology,
    tool_axes: ToolAxes,
    /// Of RS274/NGC: coordinate system, tool length, F and its unit.
    ngc: (u8, Position, f64, f64),
}

/// The blocks whose steps are under way, in the order in which they were begun.
#[derive(Debug, Default)]
pub(crate) struct LookBack {
    executed: VecDeque<Executed>,
}

impl Clone for LookBack {
    /// A copy has run nothing itself, so nothing is under way: it keeps what comes.
    fn clone(&self) -> LookBack {
        LookBack::default()
    }
}

impl Interpreter {
    /// Keeps from here on what is in force with each block, until [`forget_before`](Self::forget_before).
    pub fn look_back(&mut self) {
        self.look_back.get_or_insert_default();
    }

    /// The machine is at this block: those before it are done.
    #[inline]
    pub fn forget_before(&mut self, block: u64) {
        if let Some(kept) = &mut self.look_back {
            // The last one stays, for blocks that give out nothing.
            while kept.executed.get(1).is_some_and(|next| next.block <= block) {
                kept.executed.pop_front();
            }
        }
    }

    /// What was in force as a block gave out its last step so far; without such a record, what is now.
    pub fn shown_at(&self, block: u64) -> Shown {
        let kept = self.look_back.iter().flat_map(|kept| kept.executed.iter().rev());
        let at = kept.into_iter().find(|kept| kept.block <= block);
        at.map_or_else(
            || self.shown(),
            |at| Shown::new(self.dialect, &at.modal, &at.location, &at.technology),
        )
    }

    /// Notes what is in force as the present block gives out a step.
    #[inline]
    pub(crate) fn note_in_force(&mut self) {
        let Some(mut kept) = self.look_back.take() else { return };
        let block = self.flow.begun();
        if kept.executed.back().is_some_and(|last| last.block >= block) || kept.executed.len() >= MOST {
            kept.executed.pop_back();
        }
        let Interpreter { modal, location, technology, tool_axes, ngc, .. } = self;
        kept.executed.push_back(Executed {
            block,
            modal: *modal,
            location: *location,
            technology: *technology,
            tool_axes: *tool_axes,
            ngc: (ngc.system, ngc.length, ngc.feed, ngc.feed_unit),
        });
        self.look_back = Some(kept);
    }

    /// The present block gives out no step after all.
    pub(crate) fn forget_in_force(&mut self) {
        let block = self.flow.begun();
        if let Some(kept) = &mut self.look_back
            && kept.executed.back().is_some_and(|last| last.block == block)
        {
            kept.executed.pop_back();
        }
    }

    /// Puts back in force what was so at a block, where that is kept.
    pub(crate) fn go_back_to(&mut self, block: u64) {
        let Some(kept) = &mut self.look_back else { return };
        let executed = std::mem::take(&mut kept.executed);
        let Some(at) = executed.into_iter().take_while(|kept| kept.block <= block).last() else { return };
        self.modal = at.modal;
        self.location = Location { skip: self.location.skip, ..at.location };
        self.technology = at.technology;
        self.tool_axes = at.tool_axes;
        // A zero that was written meanwhile holds.
        self.work_zero_changed();
        if self.dialect.blocks.is_some() {
            let system;
            (system, self.ngc.length, self.ngc.feed, self.ngc.feed_unit) = at.ngc;
            self.ngc_take_system(system);
        }
    }

    /// The same as [`reset`](Self::reset) for a machine that is at a block behind those that were read.
    pub fn reset_at(&mut self, block: u64, machine: Position) {
        self.go_back_to(block);
        self.reset(machine);
    }
}
