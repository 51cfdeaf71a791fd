//! What is in force between two blocks: what a restart compares with the machine, and what shows that two
//! interpreters stand at the same place of a program.

use crate::cycles::CycleState;
use crate::dialect::{Dialect, MCode, MFunction};
use crate::interpreter::{Interpreter, Location, Technology};
use crate::modal::Modal;
use crate::stages::nesting::Transform;
use crate::tool_axes::ToolAxes;
use ferrocut_geometry::Position;
use ferrocut_toolpath::SpindleState;

/// A G code in force.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct CodeInForce {
    /// The modal group by the manual's number.
    pub group: u8,
    /// The code, in tenths.
    pub tenths: u16,
}

/// What is in force between two blocks. Two of them are equal where everything is, also what has no name here:
/// the transformations, the data of a cycle, the axes that were chosen.
#[derive(Clone, PartialEq, Debug)]
pub struct ProgramState {
    /// Speed along the path as programmed, mm/min; 0 before the first.
    pub feed_per_minute: f64,
    /// The same for a turn of the spindle, mm.
    pub feed_per_revolution: f64,
    /// The last S word, r/min.
    pub speed: Option<f64>,
    /// What the spindle was told last.
    pub spindle: SpindleState,
    /// Whether coolant is on: flood, mist.
    pub coolant: [bool; 2],
    /// Tool chosen last.
    pub tool: u32,
    /// Tool in the spindle.
    pub in_spindle: u32,
    /// Number of the tool length in force, H; 0 for none.
    pub length_number: u16,
    /// Number of the cutter radius in force, D; 0 for none.
    pub radius_number: f64,
    /// What tool length adds, mm.
    pub length: Position,
    /// Machine position of the zero of the work coordinate system, mm and degrees.
    pub work_zero: Position,
    /// The end point of the block before, as programmed, mm and degrees.
    pub programmed: Position,
    /// The same in machine coordinates, without cutter compensation.
    pub machine: Position,
    /// How many subprograms and macros are being run.
    pub calls: usize,
    modal: Modal,
    location: Location,
    technology: Technology,
    cycle: CycleState,
    tool_axes: ToolAxes,
    transforms: Vec<Transform>,
    polar_origin: [f64; 2],
    tolerance: Option<f64>,
    is_compensated: bool,
}

impl ProgramState {
    /// The G codes in force, one a group, by the order of groups.
    pub fn codes(&self) -> impl Iterator<Item = CodeInForce> {
        self.modal.codes().map(|code| CodeInForce { group: code.group_number, tenths: code.tenths })
    }

    /// Whether an M code has no effect any more, though no other code ended it: rigid tapping ends with its cycle.
    pub fn has_ended(&self, dialect: &Dialect, code: u32) -> bool {
        let is_rigid = |row: &MCode| row.function == MFunction::RigidTapping && u32::from(row.code) == code;
        !self.technology.rigid_tapping && dialect.m_codes.iter().any(is_rigid)
    }
}

impl Interpreter {
    /// What is in force between the blocks begun and the next.
    pub fn program_state(&self) -> ProgramState {
        let Interpreter { modal, location, technology, ngc, .. } = self;
        let has_own_blocks = self.dialect.blocks.is_some();
        ProgramState {
            feed_per_minute: if has_own_blocks {
                ngc.feed * ngc.feed_unit
            } else {
                technology.feed_per_minute
            },
            feed_per_revolution: technology.feed_per_revolution,
            speed: technology.speed,
            spindle: technology.spindle,
            coolant: [technology.coolant, ngc.mist],
            tool: technology.tool,
            in_spindle: technology.in_spindle,
            length_number: location.length.number,
            radius_number: technology.radius_number,
            length: if has_own_blocks { ngc.length } else { location.length.vector },
            work_zero: location.work.shift,
            programmed: if has_own_blocks { ngc.at } else { location.programmed },
            machine: location.machine,
            calls: self.calls(),
            modal: *modal,
            location: *location,
            technology: *technology,
            cycle: self.cycle,
            tool_axes: self.tool_axes,
            transforms: self.transforms.clone(),
            polar_origin: self.polar_origin,
            tolerance: ngc.tolerance,
            is_compensated: self.output.in_cutter_mode(),
        }
    }
}
