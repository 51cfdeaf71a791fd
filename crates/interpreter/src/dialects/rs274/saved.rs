//! M70 to M73: the modal state is saved, forgotten, restored, or restored when the subprogram returns
//! (LinuxCNC, M70). Each level of calls has one.

use super::technology::Overrides;
use crate::Fallible;
use crate::interpreter::Interpreter;
use crate::modal::{Group, Modal};
use ferrocut_geometry::Position;
use ferrocut_machine::Fault;
use ferrocut_toolpath::SpindleState;

/// A saved state.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Saved {
    modal: Modal,
    /// Level of calls that it was saved at.
    depth: usize,
    /// Restored when that level returns.
    is_automatic: bool,
    feed: f64,
    feed_unit: f64,
    speed: Option<f64>,
    surface_speed: Option<f64>,
    spindle: SpindleState,
    coolant: bool,
    mist: bool,
    system: u8,
    length: Position,
    tolerance: Option<f64>,
    overrides: Overrides,
}

impl Interpreter {
    /// M70, M71, M72, M73.
    pub(super) fn ngc_state_word(&mut self, code: u16) -> Fallible<()> {
        let depth = self.ngc.o_words.depth();
        match code {
            70 | 73 => {
                self.ngc.saved.retain(|saved| saved.depth != depth);
                let saved = self.ngc_save(code == 73, depth);
                self.ngc.saved.push(saved);
            }
            71 => self.ngc.saved.retain(|saved| saved.depth != depth),
            _ => {
                let Some(saved) = self.ngc.saved.iter().find(|saved| saved.depth == depth).copied() else {
                    return Err(self.ngc_alarm(Fault::NothingSaved));
                };
                self.ngc_restore(&saved);
            }
        }
        Ok(())
    }

    fn ngc_save(&self, is_automatic: bool, depth: usize) -> Saved {
        Saved {
            modal: self.modal,
            depth,
            is_automatic,
            feed: self.ngc.feed,
            feed_unit: self.ngc.feed_unit,
            speed: self.technology.speed,
            surface_speed: self.technology.surface_speed,
            spindle: self.technology.spindle,
            coolant: self.technology.coolant,
            mist: self.ngc.mist,
            system: self.ngc.system,
            length: self.ngc.length,
            tolerance: self.ngc.tolerance,
            overrides: self.ngc.overrides,
        }
    }

    /// A level of calls returns: what it saved is forgotten, or restored first.
    pub(super) fn ngc_leave_saved(&mut self) {
        let depth = self.ngc.o_words.depth();
        let own = self.ngc.saved.iter().position(|saved| saved.depth >= depth);
        let Some(own) = own else { return };
        let saved = self.ngc.saved.swap_remove(own);
        self.ngc.saved.retain(|other| other.depth < depth);
        if saved.is_automatic {
            self.ngc_restore(&saved);
        }
    }

    /// Puts a state in force. The motion code stays the one in force.
    fn ngc_restore(&mut self, saved: &Saved) {
        let motion = self.modal.code(Group::Motion);
        self.modal = saved.modal;
        if let Some(motion) = motion {
            self.modal.set(motion);
        }
        if self.ngc.system != saved.system {
            self.ngc_take_system(saved.system);
        }
        if self.ngc.length != saved.length {
            self.ngc_set_length(saved.length);
        }
        self.ngc.feed = saved.feed;
        self.ngc.feed_unit = saved.feed_unit;
        self.ngc.tolerance = saved.tolerance;
        self.ngc.overrides = saved.overrides;
        self.ngc.mist = saved.mist;
        self.technology.speed = saved.speed;
        self.technology.surface_speed = saved.surface_speed;
        self.spindle(saved.spindle);
        self.coolant(saved.coolant);
    }
}
