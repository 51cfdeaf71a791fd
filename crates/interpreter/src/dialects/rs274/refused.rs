//! A block that a sender sent and that is at fault does nothing, though its fault may show only in its move (no feed,
//! an arc that cannot be): what it changed is put back, and none of its steps is given out. In a program that is there
//! as a whole it stays done as far as it came (LinuxCNC), since nobody sends another in its place.
//!
//! Kept is what codes change that may stand beside a move: not what G10 and G92 set, which have no move with them, and
//! not the stages of compensation.

use super::blocks::Codes;
use super::parameters::{FIRST_SHIFT, SHIFT_IN_FORCE, SYSTEM};
use super::state::Turned;
use super::technology::Overrides;
use crate::interpreter::{Interpreter, Location, Technology};
use crate::modal::{Group, Modal};
use crate::output::Mark;
use ferrocut_geometry::{Axis, Position};

/// What was in force before a block.
pub(super) struct Before {
    modal: Modal,
    location: Location,
    technology: Technology,
    at: Position,
    shift: Position,
    zero: Position,
    turn: Turned,
    length: Position,
    system: u8,
    feed: f64,
    feed_unit: f64,
    mist: bool,
    tolerance: Option<f64>,
    overrides: Overrides,
    references: [Position; 4],
    /// Parameters that the block may set.
    parameters: Vec<(u32, Option<f64>)>,
    output: Mark,
}

impl Interpreter {
    /// What is in force before a block with these codes, where it is one of a sender.
    pub(super) fn ngc_before(&self, codes: &Codes) -> Option<Before> {
        if !self.options.keep_going || !self.is_open() {
            return None;
        }
        let sets = codes.g(Group::WorkOffset).is_some() || codes.g(Group::NonModal).is_some();
        let shifts = FIRST_SHIFT..FIRST_SHIFT + Axis::ALL.len() as u32;
        let numbers = [SYSTEM, SHIFT_IN_FORCE].into_iter().chain(shifts).filter(|_| sets);
        let ngc = &self.ngc;
        Some(Before {
            modal: self.modal,
            location: self.location,
            technology: self.technology,
            at: ngc.at,
            shift: ngc.shift,
            zero: ngc.zero,
            turn: ngc.turn,
            length: ngc.length,
            system: ngc.system,
            feed: ngc.feed,
            feed_unit: ngc.feed_unit,
            mist: ngc.mist,
            tolerance: ngc.tolerance,
            overrides: ngc.overrides,
            references: self.memory.reference_points,
            parameters: numbers.map(|number| (number, self.memory.variables.get(number))).collect(),
            output: self.output.mark(),
        })
    }

    /// As if the block had not been.
    pub(super) fn ngc_undo(&mut self, before: Before) {
        if !self.output.take_back(before.output) {
            return;
        }
        self.modal = before.modal;
        self.location = before.location;
        self.technology = before.technology;
        let ngc = &mut self.ngc;
        (ngc.at, ngc.shift, ngc.zero, ngc.turn) = (before.at, before.shift, before.zero, before.turn);
        (ngc.length, ngc.system) = (before.length, before.system);
        (ngc.feed, ngc.feed_unit) = (before.feed, before.feed_unit);
        (ngc.mist, ngc.tolerance, ngc.overrides) = (before.mist, before.tolerance, before.overrides);
        self.memory.reference_points = before.references;
        for (number, value) in before.parameters {
            // There was room for it before.
            let _ = self.memory.variables.set(number, value);
        }
        self.forget_in_force();
    }
}
