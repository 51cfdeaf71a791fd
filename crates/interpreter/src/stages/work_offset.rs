//! Stage work offset: G54 to G59 and the additional systems, the external offset, G52 and G92.
//!
//! `machine point = programmed point + shift`. For a system of the table the shift is its offset plus
//! the external one (GSK990MC 4.2.8) plus what goes for every system: the local one of G52 and, on some
//! controls, that of G92 (Fanuc). On others G92 makes a system of its own, in which the tool stands at the
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
    /// The part of it by which G92 moved every system.
    pub common: Position,
}

impl WorkSystem {
    /// No system of the table, with its zero at machine zero.
    pub fn at_machine_zero() -> WorkSystem {
        let zero = Position::ZERO;
        WorkSystem { system: System::Floating, shift: zero, local: zero, common: zero }
    }

    /// The system `name` of the table, its zero moved as that of the one `before`; `None` if the table does not
    /// have it.
    pub fn select(name: WorkOffset, table: &WorkOffsets, before: &WorkSystem) -> Option<WorkSystem> {
        let external = table.get(WorkOffset::External).unwrap_or_default();
        let WorkSystem { local, common, .. } = *before;
        let shift = table.get(name)? + external + local + common;
        Some(WorkSystem { system: System::Table(name), shift, local, common })
    }

    /// Every system moved so that the point `at` (machine position less tool length) has the coordinates `here`
    /// on the axes `named`. What G52 moved them by is gone.
    pub fn move_every_system(self, at: Position, here: Position, named: AxisSet) -> WorkSystem {
        let WorkSystem { system, mut shift, mut local, mut common } = self;
        for axis in named.iter() {
            let zero = at[axis] - here[axis];
            common[axis] += zero - (shift[axis] - local[axis]);
            shift[axis] = zero;
            local[axis] = 0.0;
        }
        WorkSystem { system, shift, local, common }
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
        WorkSystem { system: System::Floating, shift, local, common: self.common }
    }
}
