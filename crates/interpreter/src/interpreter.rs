//! The interpreter: an iterator of steps, and the state that blocks change.
//!
//! State is kept in parts, each owned by the file that knows it: modal codes ([`Modal`]), where the
//! tool is (`Location`), feed and spindle (`Technology`), the canned cycle
//! (`CycleState`), the order of blocks (`flow`). Blocks run ahead of motion; nothing that
//! an abort would have to take back is changed outside this value.

use crate::Fallible;
use crate::barrier::Present;
use crate::custom::CustomCodes;
use crate::cycles::CycleState;
use crate::cycles::described::Described;
use crate::cycles::pocket::KeptPockets;
use crate::cycles::zone::Zone;
use crate::data_setting::DataSetting;
use crate::dialect::{Dialect, MCode, Meaning, Rules, Variable};
use crate::dialects::fanuc::MACHINE_M;
use crate::dialects::rs274::State;
use crate::evaluate::Evaluator;
use crate::flow::Flow;
use crate::look_back::LookBack;
use crate::macros::INPUT_WORD;
use crate::modal::{Group, Modal};
use crate::origins::Origins;
use crate::output::Output;
use crate::reference::Intermediate;
use crate::referenced::Unreferenced;
use crate::stages::nesting::{Nested, Transform};
use crate::stages::polar::Polar;
use crate::stages::rotation::Rotation;
use crate::stages::scaling::Scaling;
use crate::stages::tool_length::ToolLength;
use crate::stages::work_offset::{System, WorkSystem};
use crate::tool_axes::ToolAxes;
use crate::words::{self, Tables, Words};
use ferrocut_geometry::{Axis, AxisNames, Position};
use ferrocut_machine::{Alarm, Fault, Machine, Memory, Severity, WorkOffset};
use ferrocut_program::{FileId, ProgramId, ProgramMemory, Span, lexer};
use ferrocut_toolpath::{Speed, SpindleState, Step};
use smallvec::SmallVec;
use std::collections::{BTreeMap, VecDeque};
use std::sync::{Arc, LazyLock};

/// The machine of an interpreter that was told of no other.
static DEMO_MILL: LazyLock<Arc<Machine>> = LazyLock::new(|| Arc::new(Machine::demo_mill()));

/// M codes of the machine that its control's language does not have: its ladder knows them (a machine's builder adds
/// M41 to M43 for gears to a GSK990MC, whose manual has none).
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct MachineCodes([u64; 16]);

impl MachineCodes {
    /// Those of a list; what is above M999 is not taken.
    pub fn of(codes: &[u16]) -> MachineCodes {
        let mut set = MachineCodes::default();
        for code in codes {
            if let Some(bits) = set.0.get_mut(usize::from(*code / 64)).filter(|_| *code <= 999) {
                *bits |= 1 << (code % 64);
            }
        }
        set
    }

    /// What such a code is to the language, where it is among them.
    pub(crate) fn row(&self, code: u16) -> Option<&'static MCode> {
        let is_one = self.0.get(usize::from(code / 64)).is_some_and(|bits| bits >> (code % 64) & 1 == 1);
        MACHINE_M.get(usize::from(code)).filter(|_| is_one)
    }
}

/// How the operator's switches stand, and what the steps are for.
#[derive(Clone, Copy, Debug, Default)]
pub struct Options {
    /// Machine position at the start, mm and degrees.
    pub start: Position,
    /// Names of the axes, where some have a digit.
    pub axis_names: AxisNames,
    /// Blocks with one `/` are left out.
    pub block_skip: bool,
    /// M01 stops.
    pub optional_stop: bool,
    /// The program is run block by block: macro statements that are blocks of their own are steps.
    pub single_block: bool,
    /// The run stops behind this line of a file, counted from 1.
    pub stop_line: Option<(FileId, u32)>,
    /// The simulated skip signal comes when this axis passes this machine position.
    pub skip: Option<(Axis, f64)>,
    /// Goes on behind an alarm, for checking; else it ends the run.
    pub keep_going: bool,
    /// Gives out to a run too what a check is warned of; the run goes on.
    pub warns: bool,
    /// A main program that ends with M99 is run again and again; else it ends there, unless a further pass comes to an end
    /// of its own.
    pub loops_forever: bool,
    /// A spindle or coolant code is a step even where it changes nothing that the program knows of: keys of a
    /// panel may have changed it.
    pub every_code: bool,
    /// The program that a tool change runs. Within it M06 is the built-in code, which says that the tool is in the
    /// spindle.
    pub tool_change_program: Option<u32>,
    /// Auxiliary lock: M06 is not executed (GSK990MC part 2, 7.8). It calls no program, and the tool in the spindle stays
    /// the same. Where there is such a switch, a block with M06 waits until the machine is there, as it may change before.
    pub auxiliary_lock: Option<bool>,
    /// The text may end without an end of program, as blocks do that the operator types.
    pub open_end: bool,
    /// M99 of the main program ends it as M30 does: DNC (GSK990MC part 2, 11.1.4; part 1, 5.2.5).
    pub return_ends: bool,
    /// The control takes the tool to its fixed point behind the end of a program, where its parameters say so. That is no move
    /// of the program's own.
    pub ends_at_fixed_point: bool,
    /// M codes that the machine has beside those of the language.
    pub machine_codes: MachineCodes,
}

/// Where the tool is, in the coordinates of both ends of the stages.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Location {
    /// The last end point as programmed.
    pub programmed: Position,
    /// The same as commanded to the axes.
    pub machine: Position,
    /// Work coordinate system in force.
    pub work: WorkSystem,
    /// Tool length compensation in force.
    pub length: ToolLength,
    /// Polar coordinates, scaling and rotation in force.
    pub polar: Option<Polar>,
    pub scaling: Option<Scaling>,
    pub rotation: Option<Rotation>,
    /// What the transformations come to together, where the control nests them.
    pub nested: Option<Nested>,
    /// Where the last skip signal came, in the work coordinate system.
    pub skip: Position,
}

impl Location {
    /// The work coordinate system by name; none for one that the program made.
    pub fn system(&self) -> Option<WorkOffset> {
        match self.work.system {
            System::Table(name) => Some(name),
            System::Floating => None,
        }
    }

    /// A programmed point through the stages scaling, rotation, work offset and tool length, to machine
    /// axes.
    #[inline]
    pub fn machine_of(&self, programmed: Position) -> Position {
        let mut point = programmed;
        if let Some(nested) = &self.nested {
            point = nested.apply(point);
        }
        if let Some(scaling) = &self.scaling {
            point = scaling.apply(point);
        }
        if let Some(rotation) = &self.rotation {
            point = rotation.apply(point);
        }
        point + self.work.shift + self.length.vector
    }

    /// The point in the work coordinate system where the axes stand, scaled and rotated.
    #[inline]
    pub fn in_work(&self) -> Position {
        self.machine - self.work.shift - self.length.vector
    }

    /// The programmed point of where the axes stand, after something between the two changed.
    pub fn take_machine(&mut self) {
        let mut point = self.in_work();
        if let Some(rotation) = &self.rotation {
            point = rotation.undo(point);
        }
        if let Some(scaling) = &self.scaling {
            point = scaling.undo(point);
        }
        if let Some(nested) = &self.nested {
            point = nested.undo(point);
        }
        self.programmed = point;
    }

    /// As [`take_machine`](Self::take_machine), of some axes alone.
    pub fn take_machine_of(&mut self, axes: &[Axis]) {
        let mut here = *self;
        here.take_machine();
        for axis in axes {
            self.programmed[*axis] = here.programmed[*axis];
        }
    }
}

/// F, S and T words in force.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Technology {
    /// Feed per minute as programmed, mm/min.
    pub feed_per_minute: f64,
    /// Millimetres in the unit of the last F word.
    pub feed_unit: f64,
    /// Whether an F word of it ever came.
    pub feed_per_minute_was_given: bool,
    /// Feed per revolution as programmed, mm; 0 before the first.
    pub feed_per_revolution: f64,
    /// Speed of positioning that the program gives, mm/min.
    pub rapid_feed: Option<f64>,
    /// The last S word as programmed, r/min.
    pub speed: Option<f64>,
    /// The last S word of a surface speed, mm/min.
    pub surface_speed: Option<f64>,
    /// Highest spindle speed under surface speed (G92 S), r/min.
    pub surface_max_rpm: Option<f64>,
    /// Axis that surface speed is reckoned by (G96 P).
    pub surface_axis: Axis,
    /// Pitch of tapping cycles that give it themselves, mm; none before the first.
    pub tap_pitch: Option<f64>,
    /// M29: the tapping cycles that follow are rigid.
    pub rigid_tapping: bool,
    /// What the spindle was last told.
    pub spindle: SpindleState,
    /// Whether coolant is on.
    pub coolant: bool,
    /// Tool chosen last.
    pub tool: u32,
    /// Tool put into the spindle last.
    pub in_spindle: u32,
    /// Its offset, where tools carry their offsets.
    pub edge: f64,
    /// G10 while data are set by the program, else G11.
    pub data_code: f64,
    /// Offset number of the cutter radius in force, D.
    pub radius_number: f64,
    /// The last M, N and O words.
    pub m_code: Option<f64>,
    pub sequence: Option<f64>,
    pub program: f64,
}

/// What makes two passes of a program alike.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Fingerprint {
    modal: Modal,
    location: Location,
    technology: Technology,
    variable_writes: u64,
}

/// Turns the blocks of a program into steps.
#[derive(Clone)]
pub struct Interpreter {
    pub(crate) dialect: &'static Dialect,
    pub(crate) tables: Tables,
    pub(crate) rules: Rules,
    /// Bits of the axis addresses that the control does not carry.
    pub(crate) foreign_axes: u32,
    pub(crate) options: Options,
    pub(crate) programs: ProgramMemory,
    pub(crate) memory: Memory,
    pub(crate) modal: Modal,
    pub(crate) location: Location,
    pub(crate) technology: Technology,
    pub(crate) cycle: CycleState,
    pub(crate) zone: Zone,
    pub(crate) tool_axes: ToolAxes,
    /// Directives of a cycle and what they describe.
    pub(crate) described: Described,
    /// Where computed pockets are kept, if anywhere.
    pub(crate) kept_pockets: Option<Arc<dyn KeptPockets>>,
    /// Where polar words count from.
    pub(crate) polar_origin: [f64; 2],
    pub(crate) intermediate: Intermediate,
    pub(crate) data_setting: Option<DataSetting>,
    /// The block's moves run at 100 %.
    pub(crate) full_feed: bool,
    /// No block is read before the one before it has come to its end (Weihong M802 P196609).
    pub(crate) buffer_is_off: bool,
    /// Stored stroke check 2 is on.
    pub(crate) stroke_check_2: bool,
    pub(crate) flow: Flow,
    pub(crate) words: Words,
    pub(crate) evaluator: Evaluator,
    pub(crate) variable_writes: u64,
    pub(crate) inputs: BTreeMap<u16, f64>,
    /// What the program put out last.
    pub(crate) outputs: BTreeMap<u16, f64>,
    /// Transformations in force, the first one outermost, where the control nests them.
    pub(crate) transforms: Vec<Transform>,
    /// Codes that programs stand for.
    pub(crate) custom: Option<Box<CustomCodes>>,
    pub(crate) present: Present,
    /// The barrier given out last is that of a tool change, which asks for nothing but auxiliary lock.
    pub(crate) asks_for_lock: bool,
    /// How far the axes lagged behind at the last barrier.
    pub(crate) following_error: Position,
    pub(crate) unreferenced: Unreferenced,
    /// Software limits of the machine, lower and upper, where a probe is fitted.
    pub(crate) probe: Option<(Position, Position)>,
    /// A skip move whose end without its signal is an alarm, until the machine is at rest there.
    pub(crate) awaits_signal: Option<Span>,
    /// The machine waits for inputs, and says what came: its software limits, lower and upper.
    pub(crate) machine_waits: Option<(Position, Position)>,
    pub(crate) pass_state: Option<Fingerprint>,
    /// State of RS274/NGC.
    pub(crate) ngc: State,
    pub(crate) ended: bool,
    /// All that came of a program that is sent was run.
    pub(crate) starved: bool,
    /// What is in force with the blocks under way, where somebody asked for it.
    pub(crate) look_back: Option<Box<LookBack>>,
    /// Steps of blocks up to this one are not given out: they were done before.
    pub(crate) passed: u64,
    pub(crate) output: Output,
    pub(crate) alarms: VecDeque<Box<Alarm>>,
    /// The drawing that the main program was made from.
    pub(crate) origins: Option<Origins>,
    /// The machine, as its file describes it.
    pub(crate) machine: Arc<Machine>,
}

impl Interpreter {
    /// An interpreter at power-on state before the first block of the main program.
    pub fn new(
        dialect: &'static Dialect,
        programs: ProgramMemory,
        memory: Memory,
        options: Options,
    ) -> Interpreter {
        let rules = (dialect.rules)(&memory.parameters);
        let modal = (dialect.power_on)(&memory.parameters);
        let work =
            WorkSystem::select(dialect.power_on_work_offset, &memory.work, &WorkSystem::at_machine_zero())
                .unwrap_or(WorkSystem::at_machine_zero());
        let mut location = Location {
            programmed: Position::ZERO,
            machine: options.start,
            work,
            length: ToolLength::default(),
            polar: None,
            scaling: None,
            rotation: None,
            nested: None,
            skip: Position::ZERO,
        };
        location.take_machine();
        let technology = Technology {
            feed_per_minute: rules.default_feed,
            feed_unit: 1.0,
            feed_per_minute_was_given: false,
            feed_per_revolution: 0.0,
            rapid_feed: None,
            speed: None,
            surface_speed: None,
            surface_max_rpm: None,
            surface_axis: rules.surface_axis,
            tap_pitch: None,
            rigid_tapping: false,
            spindle: SpindleState::Off,
            coolant: false,
            tool: 0,
            in_spindle: 0,
            data_code: 11.0,
            edge: 0.0,
            radius_number: 0.0,
            m_code: None,
            sequence: None,
            program: 0.0,
        };
        let output = Output::new(rules.cutter, options.start);
        let mut programs = programs;
        let mut alarms = VecDeque::new();
        let custom = dialect.custom.and_then(|custom| {
            CustomCodes::find(custom, &mut programs).unwrap_or_else(|error| {
                alarms.push_back(Interpreter::unreadable_programs(&error));
                None
            })
        });
        let mut memory = memory;
        memory.variables.name_numbers(|name| dialect.syntax.variable(name.as_bytes()));
        let mut interpreter = Interpreter {
            tables: Tables::new(dialect).without(options.axis_names.renamed()),
            evaluator: Evaluator::new(dialect.arithmetic),
            dialect,
            foreign_axes: words::foreign_axes(rules.axes),
            rules,
            options,
            programs,
            memory,
            modal,
            location,
            technology,
            cycle: CycleState::default(),
            zone: Zone::default(),
            tool_axes: ToolAxes::default(),
            described: Described::default(),
            kept_pockets: None,
            polar_origin: [0.0; 2],
            intermediate: Intermediate::default(),
            data_setting: None,
            full_feed: false,
            buffer_is_off: false,
            stroke_check_2: modal.meaning(Group::StrokeCheck) == Meaning::StrokeCheckOn,
            flow: Flow::new(),
            words: Words::new(),
            variable_writes: 0,
            inputs: BTreeMap::new(),
            outputs: BTreeMap::new(),
            transforms: Vec::new(),
            custom,
            present: Present::default(),
            asks_for_lock: false,
            following_error: Position::ZERO,
            unreferenced: Unreferenced::default(),
            probe: None,
            awaits_signal: None,
            machine_waits: None,
            pass_state: None,
            ngc: State::new(work.shift, options.start),
            ended: false,
            starved: false,
            look_back: None,
            passed: 0,
            output,
            alarms,
            origins: None,
            machine: DEMO_MILL.clone(),
        };
        if dialect.blocks.is_some() {
            interpreter.ngc_start();
        }
        interpreter
    }

    /// Lets steps and alarms name the places of the drawing that the main program was made from.
    pub fn set_origins(&mut self, origins: Origins) {
        self.origins = Some(origins);
    }

    /// Gives computed pockets a place where they are kept between runs.
    pub fn keep_pockets(&mut self, kept: Box<dyn KeptPockets>) {
        self.kept_pockets = Some(kept.into());
    }

    /// The file that people know as the main program: the drawing, where the program was made from one.
    pub fn main_file(&self) -> FileId {
        self.origins.as_ref().map_or(FileId(0), Origins::drawing)
    }

    /// The programs, for showing what a span says.
    pub fn programs(&self) -> &ProgramMemory {
        &self.programs
    }

    /// Tells which machine parameters build, so that a program changes none that acts from the next power-on; else it is
    /// the demo mill.
    pub fn set_machine(&mut self, machine: Arc<Machine>) {
        self.machine = machine;
    }

    /// Where a program begins that can be called: its file, and its line there, counted from 1.
    pub fn place_of(&mut self, id: &ProgramId) -> Option<(FileId, u32)> {
        let place = self.programs.find_program(id).ok().flatten()?;
        let page = self.programs.page(place.file, place.page).ok().flatten()?;
        let line = page.blocks.get(place.block as usize).map_or(1, |block| page.block_span(block).line);
        Some((place.file, line))
    }

    /// The control language.
    pub fn dialect(&self) -> &'static Dialect {
        self.dialect
    }

    /// The rules in force.
    pub fn rules(&self) -> &Rules {
        &self.rules
    }

    /// What the machine remembers, as the program has changed it so far.
    pub fn memory(&self) -> &Memory {
        &self.memory
    }

    /// Commanded machine position at the end of the steps given out.
    pub fn position(&self) -> Position {
        self.location.machine
    }

    /// Sets an input that programs read, by the number of its variable (GSK990MC #1000 to #1032).
    pub fn set_input(&mut self, variable: u32, value: f64) {
        match (self.dialect.variable)(variable) {
            Some(Variable::Input(number)) => drop(self.inputs.insert(number, value)),
            Some(Variable::InputWord) => drop(self.inputs.insert(INPUT_WORD, value)),
            _ => {}
        }
    }

    /// Sets the first 16 inputs, from bit 0 on.
    pub fn set_ports(&mut self, inputs: u16) {
        (0..16).for_each(|port| self.set_port(port, f64::from(inputs >> port & 1)));
    }

    /// Sets an input by the number of its port, on controls that count them so.
    pub fn set_port(&mut self, port: u16, value: f64) {
        self.inputs.insert(port, value);
    }

    /// Reset or emergency stop with the axes at rest at `machine`: the program is left and its start
    /// comes next, modal state and words are kept or cleared as the control's parameters say
    /// (GSK990MC 4.1 note 7; part 2, 2.3.1). Offsets and kept variables stay as the program set them.
    pub fn reset(&mut self, machine: Position) {
        let rules = (self.dialect.reset)(&self.memory.parameters);
        let initial = (self.dialect.power_on)(&self.memory.parameters);
        self.modal = self.modal.reset_to(&initial, |group| rules.groups & 1 << group != 0);
        let clears = |group: Group| {
            initial.codes().any(|code| code.group == group && rules.groups & 1 << code.group_number != 0)
        };
        if clears(Group::WorkOffset)
            && let Some(system) = WorkSystem::select(
                self.dialect.power_on_work_offset,
                &self.memory.work,
                &WorkSystem::at_machine_zero(),
            )
        {
            self.location.work = system;
        }
        if rules.feed_and_offsets {
            self.technology.feed_per_minute = self.rules.default_feed;
            self.technology.feed_unit = 1.0;
            self.technology.feed_per_revolution = 0.0;
            self.technology.rapid_feed = None;
            self.technology.tap_pitch = None;
            self.technology.radius_number = 0.0;
            self.location.length.number = 0;
        }
        if self.modal.meaning(Group::Length) == Meaning::LengthOff {
            self.location.length.cancel();
        }
        self.transforms.clear();
        self.location.nested = None;
        for (group, off) in [
            (Group::Polar, Meaning::PolarOff),
            (Group::Scaling, Meaning::ScalingOff),
            (Group::Rotation, Meaning::RotationOff),
        ] {
            if self.modal.meaning(group) == off {
                match group {
                    Group::Polar => self.location.polar = None,
                    Group::Scaling => self.location.scaling = None,
                    _ => self.location.rotation = None,
                }
            }
        }
        self.reset_variables(rules.locals, rules.commons);
        // The data of a hole stay with its cycle (36#1; 4.4 table 4-4-2).
        if self.cycle_kind().is_none() {
            self.cycle = CycleState::default();
        }
        self.cycle.drop_holes();
        self.leave_zone();
        self.tool_axes = ToolAxes::default();
        self.described.reset();
        self.polar_origin = [0.0; 2];
        self.technology.rigid_tapping = false;
        self.technology.spindle = SpindleState::Off;
        self.technology.coolant = false;
        self.data_setting = None;
        self.technology.data_code = 11.0;
        self.pass_state = None;
        // What was sent of a program and not run is forgotten with it.
        self.begin_at(None);
        self.alarms.clear();
        self.present = Present::default();
        self.buffer_is_off = false;
        self.ended = false;
        self.passed = 0;
        self.output = Output::new(self.rules.cutter, machine);
        self.location.machine = machine;
        self.location.take_machine();
        self.ngc.reset(machine);
    }

    /// Whether lengths are inches now (G20).
    pub fn reads_inches(&self) -> bool {
        self.modal.is_inch()
    }

    /// The G codes in force, in tenths, by the order of groups.
    pub fn codes_in_force(&self) -> impl Iterator<Item = u16> {
        self.modal.codes().map(|code| code.tenths)
    }

    /// The speed in force, whether the spindle turns or not.
    pub fn spindle_speed(&self) -> Speed {
        self.speed()
    }

    /// Machine position of the zero of the work coordinate system in force.
    pub fn work_zero(&self) -> Position {
        self.location.work.shift
    }

    /// The word with this address in the block that `block` is the span of.
    pub fn locate_word(&self, block: Span, letter: u8) -> Option<Span> {
        if self.origins.is_some() {
            // A drawing has no words.
            return None;
        }
        let bytes = self.programs.text(block.file)?.slice(block).ok()?;
        let page = lexer::lex(&bytes, block.file, block.offset, block.line, true, self.dialect.syntax).page;
        page.blocks.iter().find_map(|b| {
            let word = page.words(b).iter().find(|w| w.letter == letter)?;
            Some(page.word_span(b, word))
        })
    }

    /// An alarm of this dialect.
    pub(crate) fn alarm(&self, fault: Fault, span: Span) -> Box<Alarm> {
        words::alarm(self.dialect, fault, span)
    }

    /// An alarm about the word with this address.
    pub(crate) fn alarm_at(&self, fault: Fault, letter: u8) -> Box<Alarm> {
        self.alarm(fault, self.words.span(letter))
    }

    /// Tells what it is well to know a check, and a run that asks for it; of blocks that are looked for it is told nothing.
    pub(crate) fn tell(&mut self, alarm: Alarm) {
        if self.tells() {
            self.note(Box::new(alarm.as_warning()));
        }
    }

    /// Tells of the words with these addresses: the code that they stand beside uses none of them. Beside an M code P and L may
    /// be its own.
    pub(crate) fn tell_unused(&mut self, letters: impl IntoIterator<Item = u8>) {
        let of_m = |letter| matches!(letter, b'L' | b'P') && !self.words.m.is_empty();
        let unused = letters.into_iter().filter(|letter| self.words.has(*letter) && !of_m(*letter));
        for letter in unused.collect::<SmallVec<[u8; 4]>>() {
            self.tell(*self.alarm_at(Fault::WordUnused, letter));
        }
    }

    /// Whether warnings are given out.
    pub(crate) fn tells(&self) -> bool {
        self.options.keep_going || self.options.warns && self.flow.mark().is_none()
    }

    /// A copy that looks ahead, past any mark, and warns of nothing: what it comes to is told when it is run.
    pub fn looking_ahead(&self) -> Interpreter {
        let mut ahead = self.clone();
        ahead.set_mark(None);
        ahead.options.warns = false;
        ahead
    }

    /// Notes an alarm and goes on with the block.
    pub(crate) fn note(&mut self, alarm: Box<Alarm>) {
        self.alarms.push_back(alarm);
    }

    /// Alarms noted and not yet given out.
    pub(crate) fn alarms_noted(&self) -> usize {
        self.alarms.len()
    }

    /// Takes back the alarms noted since there were `before`.
    pub(crate) fn forget_alarms(&mut self, before: usize) {
        self.alarms.truncate(before);
    }

    /// An alarm ends the run: the moves before the block at fault are given out first.
    fn stop_by(&mut self, alarm: Box<Alarm>) {
        if !self.options.keep_going {
            self.hand_out();
        }
        self.alarms.push_back(alarm);
    }

    /// Gives out the moves before a block at fault.
    pub(crate) fn hand_out(&mut self) {
        // What cannot be handed out any more is no second fault.
        let _ = self.output.flush();
    }

    /// Whether steps, alarms or holes of the block run last are still to be given out.
    pub(crate) fn has_more_of_block(&self) -> bool {
        !self.output.is_empty()
            || !self.alarms.is_empty()
            || self.described.is_running()
            || self.has_holes_left()
    }

    pub(crate) fn fingerprint(&self) -> Fingerprint {
        Fingerprint {
            modal: self.modal,
            location: self.location,
            technology: self.technology,
            variable_writes: self.variable_writes,
        }
    }

    /// The next step, if it comes of the next `blocks`, of which those that were read are taken off: none, and `blocks`
    /// 0, says that there may be more. For a machine that has other things to do while a program reckons.
    #[inline]
    pub fn next_within(&mut self, blocks: &mut u64) -> Option<Fallible<Step>> {
        let mut next = self.advance(blocks)?;
        if let Some(origins) = &self.origins {
            match &mut next {
                Ok(step) => step.span = origins.of(step.span),
                Err(alarm) => alarm.span = origins.of(alarm.span),
            }
        }
        Some(next)
    }

    /// The next step or alarm, at its place in the program.
    #[inline]
    fn advance(&mut self, blocks: &mut u64) -> Option<Fallible<Step>> {
        loop {
            if let Some(step) = self.output.pop() {
                if self.is_left_out(&step) || step.block <= self.passed {
                    continue;
                }
                return Some(Ok(step));
            }
            if let Some(alarm) = self.alarms.pop_front() {
                let is_error = alarm.severity == Severity::Error;
                if is_error && self.options.keep_going {
                    self.flow.goes_on_behind_fault();
                } else if is_error {
                    self.ended = true;
                    self.alarms.clear();
                    // What was read up to here is done once the machine comes to it. Not so where a stage that looks ahead
                    // has stopped the run: it holds back blocks before.
                    if self.flow.last().holds(alarm.span) {
                        self.note_in_force();
                    }
                }
                return Some(Err(alarm));
            }
            if self.ended || self.stands() {
                return None;
            }
            *blocks = blocks.checked_sub(1)?;
            if self.described.is_running() {
                if let Err(alarm) = self.next_described() {
                    self.stop_by(alarm);
                }
                continue;
            }
            if self.has_holes_left() {
                if let Err(alarm) = self.next_hole() {
                    self.stop_by(alarm);
                }
                continue;
            }
            if let Err(alarm) = self.run_block() {
                self.stop_by(alarm);
            }
            if self.starved {
                return None;
            }
        }
    }
}

impl Iterator for Interpreter {
    type Item = Fallible<Step>;

    #[inline]
    fn next(&mut self) -> Option<Fallible<Step>> {
        let mut any = u64::MAX;
        self.next_within(&mut any)
    }
}
