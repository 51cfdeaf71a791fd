//! Axes whose reference points the machine does not know yet: what a program may do with them (GSK990MC 4.3, bits
//! 6#0 and 6#3). At a desk all are known.

use crate::Fallible;
use crate::coordinates::SetPosition;
use crate::dialect::Meaning;
use crate::interpreter::Interpreter;
use crate::modal::Group;
use crate::stages::work_offset::WorkSystem;
use ferrocut_geometry::AxisSet;
use ferrocut_machine::{Fault, WorkOffset};

/// Axes that were not homed, and what programs may do with them.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Unreferenced {
    /// These axes.
    pub axes: AxisSet,
    /// To move one of them is an alarm, except to its reference point.
    pub stand: bool,
    /// To send one to its reference point is an alarm.
    pub not_by_program: bool,
    /// Stored strokes hold for them too.
    pub limits_before: bool,
}

impl Unreferenced {
    /// Axes whose places are not judged by stored strokes (GSK990MC 2.5.2, 2.6, 5).
    pub fn not_judged(&self) -> AxisSet {
        if self.limits_before { AxisSet::EMPTY } else { self.axes }
    }
}

impl Interpreter {
    /// Tells which axes the machine has not homed. They are taken as homed once the program sent them to their
    /// reference points.
    pub fn set_unreferenced(&mut self, unreferenced: Unreferenced) {
        self.unreferenced = unreferenced;
    }

    /// Axes were homed by hand: a system that G92 made of its own is lost, that of the table is in force again
    /// (GSK990MC part 2, 4.1.5 note 3).
    pub fn homed_by_hand(&mut self) {
        if self.own_zero().is_none() {
            return;
        }
        let before = WorkSystem::at_machine_zero();
        let behind = self.system_behind_own();
        if let Some(system) = behind.and_then(|name| WorkSystem::select(name, &self.memory.work, &before)) {
            self.location.work = system;
            self.location.take_machine();
        }
    }

    /// Whether G92 makes a system of its own.
    pub(crate) fn has_own_systems(&self) -> bool {
        self.rules.coordinates.set_position == SetPosition::OwnSystem
    }

    /// The system of the table that is in force again where one that G92 made is lost.
    pub(crate) fn system_behind_own(&self) -> Option<WorkOffset> {
        match self.modal.meaning(Group::WorkOffset) {
            Meaning::WorkOffset(number) if self.has_own_systems() => Some(WorkOffset::Standard(number)),
            _ => None,
        }
    }

    /// Whether a block may name these axes with its code, or without one that acts alone.
    pub(crate) fn check_referenced(&self, code: Option<Meaning>, axes: AxisSet) -> Fallible<()> {
        let Some(axis) = axes.and(self.unreferenced.axes).iter().next() else { return Ok(()) };
        let fault = match code {
            Some(Meaning::ReferenceReturn | Meaning::HomeSearch) => {
                self.unreferenced.not_by_program.then_some(Fault::ReferenceByProgram)
            }
            // Alarm 0047 names G28, G30 and G53; G28 finds the point by itself (6#3).
            Some(
                Meaning::FurtherReferenceReturn
                | Meaning::ReferenceCheck
                | Meaning::ReturnFromReference
                | Meaning::MachinePosition,
            ) => Some(Fault::ReferenceNeeded),
            None | Some(Meaning::OneWay | Meaning::Skip | Meaning::MoveUntilInput) => {
                self.unreferenced.stand.then_some(Fault::NotReferenced)
            }
            Some(_) => None,
        };
        match fault {
            None => Ok(()),
            Some(fault) => {
                let mut alarm = self.alarm_at(fault, axis.letter() as u8);
                alarm.arguments.push(("axis", axis.letter().to_string().into()));
                Err(alarm)
            }
        }
    }

    /// The program sends axes to their reference points: those among them that the machine has to search.
    pub(crate) fn take_unreferenced(&mut self, axes: AxisSet) -> AxisSet {
        let searched = axes.and(self.unreferenced.axes);
        let left = self.unreferenced.axes.iter().filter(|axis| !axes.contains(*axis));
        self.unreferenced.axes = left.collect();
        searched
    }
}
