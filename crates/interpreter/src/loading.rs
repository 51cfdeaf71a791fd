//! Another program on the same control: what a program leaves behind stays, only the order of blocks begins anew.
//!
//! A control has one modal state, whatever runs: blocks that the operator types set codes for the program that is
//! started after them (GSK990MC part 2, 7.4).

use crate::barrier::Present;
use crate::custom::CustomCodes;
use crate::dialect::{MFunction, Meaning, Variable};
use crate::dialects::rs274::Turned;
use crate::flow::Flow;
use crate::interpreter::Interpreter;
use crate::modal::Group;
use crate::output::Output;
use crate::stages::work_offset::{System, WorkSystem};
use ferrocut_geometry::Position;
use ferrocut_machine::{Alarm, Memory, WorkOffset};
use ferrocut_program::{FileId, ProgramMemory};
use std::io;

impl Interpreter {
    /// Takes other programs; the first block of the main one comes next. Modal codes, words, offsets and variables
    /// stay as they are. The axes are at rest at `machine`. Gives the programs back that it had.
    pub fn load(&mut self, programs: ProgramMemory, machine: Position) -> ProgramMemory {
        let old = std::mem::replace(&mut self.programs, programs);
        self.origins = None;
        self.rewind(machine);
        let found = self.dialect.custom.map(|custom| CustomCodes::find(custom, &mut self.programs));
        self.custom = match found {
            Some(Ok(custom)) => custom,
            Some(Err(error)) => {
                self.note(Interpreter::unreadable_programs(&error));
                None
            }
            None => None,
        };
        old
    }

    /// The first block of the main program comes next, whatever was to come. Modal codes, words, offsets and
    /// variables stay as they are. The axes are at rest at `machine`.
    pub fn rewind(&mut self, machine: Position) {
        self.cycle.drop_holes();
        self.leave_zone();
        self.described.reset();
        self.data_setting = None;
        self.technology.data_code = 11.0;
        self.pass_state = None;
        self.alarms.clear();
        // The compensated path of the program before is no path of this one.
        let initial = (self.dialect.power_on)(&self.memory.parameters);
        let cutter = initial.codes().find(|code| code.group == Group::Cutter).map(|code| code.group_number);
        self.modal = self.modal.reset_to(&initial, |group| Some(group) == cutter);
        self.flow = Flow::new();
        self.present = Present::default();
        self.buffer_is_off = false;
        self.ended = false;
        self.parameters_changed();
        self.output = Output::new(self.rules.cutter, machine);
        self.location.machine = machine;
        self.location.take_machine();
        self.ngc.at = self.ngc.program_of(machine);
    }

    /// The block of the main program that stands on `line`, counted from 1, comes next: the first one from there on
    /// (GSK990MC part 2, 7.4). What is passed over has no effect. `false` where there is none.
    pub fn start_at(&mut self, line: u32) -> io::Result<bool> {
        let found = self.programs.block_from_line(FileId(0), line)?;
        if let Some(place) = found {
            self.flow.start_at(place);
        }
        Ok(found.is_some())
    }

    /// How the operator's switches stand, for the blocks that are read from now on.
    pub fn set_switches(&mut self, block_skip: bool, optional_stop: bool) {
        self.options.block_skip = block_skip;
        self.options.optional_stop = optional_stop;
    }

    /// Whether blocks that are read from now on are run one by one.
    pub fn set_single_block(&mut self, single_block: bool) {
        self.options.single_block = single_block;
    }

    /// The line behind which the run stops, for the blocks that are read from now on: it gets a step of its own.
    pub fn set_stop_line(&mut self, line: Option<(FileId, u32)>) {
        self.options.stop_line = line;
    }

    /// Whether the text of the main program may end without an end of program, as blocks do that the operator types.
    pub fn set_open_end(&mut self, open: bool) {
        self.options.open_end = open;
    }

    /// Whether M99 of the main program ends it as M30 does: DNC (GSK990MC part 2, 11.1.4).
    pub fn set_return_ends(&mut self, ends: bool) {
        self.options.return_ends = ends;
    }

    /// The program that a tool change runs; none is the built-in code.
    pub fn set_tool_change_program(&mut self, program: Option<u32>) {
        self.options.tool_change_program = program;
    }

    /// Auxiliary lock, for the blocks that are read from now on.
    pub fn set_auxiliary_lock(&mut self, locked: bool) {
        self.options.auxiliary_lock = Some(locked);
    }

    /// Whether M06 is not executed.
    pub(crate) fn is_auxiliary_locked(&self) -> bool {
        self.options.auxiliary_lock == Some(true)
    }

    /// Whether the block changes the tool and is to be read once the machine is there, where auxiliary lock may come
    /// before it. A change that is begun is finished.
    pub(crate) fn waits_for_lock(&self) -> bool {
        self.options.auxiliary_lock.is_some()
            && self.present == Present::Unknown
            && self.words.m.iter().any(|m| m.row.function == MFunction::ToolChange)
            && !self.changes_tool()
    }

    /// What the machine remembers, to be changed by others than the program. After parameters
    /// [`parameters_changed`](Self::parameters_changed) is called, after zeros
    /// [`zeros_changed`](Self::zeros_changed).
    pub fn memory_mut(&mut self) -> &mut Memory {
        &mut self.memory
    }

    /// Parameters were changed: what follows from them does too.
    pub fn parameters_changed(&mut self) {
        self.rules = (self.dialect.rules)(&self.memory.parameters);
        self.output.set_rules(self.rules.cutter);
    }

    /// The parameter of the unit of programs was set: G20 or G21 is in force as at power-on.
    pub fn unit_changed(&mut self) {
        let initial = (self.dialect.power_on)(&self.memory.parameters);
        if let Some(code) = initial.code(Group::Units) {
            self.modal.set(code);
        }
    }

    /// Zeros were changed: the coordinates of the place where the axes stand change with them.
    pub fn zeros_changed(&mut self) {
        match self.dialect.blocks {
            Some(_) => self.ngc_take_system(self.ngc.system),
            None => self.work_zero_changed(),
        }
    }

    /// Another memory was entered, or parts of one, while no program runs: what is in force is as that says.
    pub fn memory_restored(&mut self) {
        self.parameters_changed();
        match self.dialect.blocks {
            Some(_) => self.ngc_start(),
            None => self.work_zero_changed(),
        }
    }

    /// Counts up when the program changes what the machine remembers.
    pub fn writes(&self) -> u64 {
        self.variable_writes
    }

    /// The work coordinate system in force, as the program calls it; where G92 made one of its own, the one that is in force
    /// behind it.
    pub fn work_system(&self) -> Option<WorkOffset> {
        match self.dialect.blocks {
            Some(_) => Some(self.ngc_system_name()),
            None => self.location.system().or_else(|| self.system_behind_own()),
        }
    }

    /// Machine position of the zero of the system that G92 made of its own, if it is in force (GSK990MC 4.2.11).
    pub fn own_zero(&self) -> Option<Position> {
        let WorkSystem { system, shift, .. } = self.location.work;
        (self.has_own_systems() && system == System::Floating).then_some(shift)
    }

    /// The system that G92 had made before power went off (GSK990MC 4.2.8, 3).
    pub fn take_up_own_zero(&mut self, zero: Position) {
        if self.has_own_systems() {
            self.location.work = WorkSystem { shift: zero, ..WorkSystem::at_machine_zero() };
            self.location.take_machine();
        }
    }

    /// Whether a person may set the variable: one that stands for nothing else.
    pub fn is_entered_by_hand(&self, number: u32) -> bool {
        matches!((self.dialect.variable)(number), Some(Variable::Plain | Variable::UserTable))
    }

    /// The work coordinate system that was in force before power went off (GSK990MC 4.2.8, 3), if the control has it still.
    pub fn take_up_work_system(&mut self, name: WorkOffset) {
        // RS274/NGC has it in a variable.
        if self.dialect.blocks.is_some() {
            return;
        }
        let Some(system) = WorkSystem::select(name, &self.memory.work, &self.location.work) else { return };
        let number = match name {
            WorkOffset::Standard(number) => number,
            // Those with a number are called by P beside G54.
            WorkOffset::Additional(_) => 1,
            WorkOffset::External => return,
        };
        let is_its = |row: &&'static crate::dialect::GCode| row.meaning == Meaning::WorkOffset(number);
        if let Some(row) = self.dialect.g_codes.iter().find(is_its) {
            self.modal.set(row);
            self.location.work = system;
            self.location.take_machine();
        }
    }

    /// Machine position of the tool tip at the zero of the work coordinate system: its zero and the tool length.
    pub fn program_zero(&self) -> Position {
        self.location.work.shift + self.location.length.vector
    }

    /// How the work coordinate system is turned (RS274/NGC, R of G10 L2).
    pub fn program_turn(&self) -> Turned {
        self.ngc.turn
    }

    /// What tool length compensation adds to positions.
    pub fn length_in_force(&self) -> Position {
        self.location.length.vector
    }

    /// The last F word in mm/min, and S in r/min.
    pub fn feed_and_speed(&self) -> (f64, f64) {
        (self.technology.feed_per_minute, self.technology.speed.unwrap_or(0.0))
    }

    /// The tool in the spindle, and the one that was called last.
    pub fn tools(&self) -> (u32, u32) {
        (self.technology.in_spindle, self.technology.tool)
    }

    /// The alarm that the dialect has for a fault.
    pub fn alarm_of(&self, fault: ferrocut_machine::Fault) -> Alarm {
        *self.alarm(fault, ferrocut_program::Span::default())
    }
}
