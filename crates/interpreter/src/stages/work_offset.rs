//! Stage work offset: G54 to G59 and the additional systems, the external offset, G52 and G92.
//!
//! `machine point = programmed point + shift`. For a system of the table the shift is its offset plus
//! the external one (GSK990MC 4.2.8) plus the local one of G52, which goes for every system (Fanuc). G92 makes a system of its own, in which the tool stands at the
//! given point; the next call of a system of the table ends it (GSK990MC 4.2.11).

use ferrocut_geometry::{AxisSet, Position};
use ferrocut_machine::{WorkOffset, WorkOffsets};

/// The work coordinate system in force.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum System {
    /// One of the table.
    Table(WorkOffset),
    /// Set by G92.
    Floating,
}

/// The work coordinate system in force and where its zero lies.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct WorkSystem {
    /// Which one.
    pub system: System,
    /// Machine position of its zero, mm and degrees.
    pub shift: Position,
    /// The part of it that G52 set.
    pub local: Position,
}

impl WorkSystem {
    /// No system of the table, with its zero at machine zero.
    pub fn at_machine_zero() -> WorkSystem {
        WorkSystem { system: System::Floating, shift: Position::ZERO, local: Position::ZERO }
    }

    /// The system `name` of the table with its zero moved by `local`; `None` if the table does not have it.
    pub fn select(name: WorkOffset, table: &WorkOffsets, local: Position) -> Option<WorkSystem> {
        let external = table.get(WorkOffset::External).unwrap_or_default();
        let shift = table.get(name)? + external + local;
        Some(WorkSystem { system: System::Table(name), shift, local })
    }

    /// The same system with its zero moved by `local` instead of by what it was moved before.
    pub fn with_local(self, local: Position) -> WorkSystem {
        WorkSystem { shift: self.shift - self.local + local, local, ..self }
    }

    /// The system in which the point `at` (machine position less tool length) has the coordinates
    /// `here` on the axes `named`; the other axes keep their coordinates.
    pub fn set_position(self, at: Position, here: Position, named: AxisSet) -> WorkSystem {
        let (mut shift, mut local) = (self.shift, self.local);
        for axis in named.iter() {
            shift[axis] = at[axis] - here[axis];
            local[axis] = 0.0;
        }
        WorkSystem { system: System::Floating, shift, local }
    }
}
