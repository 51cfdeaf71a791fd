//! The whole control, for any front: the NC with its axes, the ladder, the memory, the mode, and who may do what.
//!
//! [`Control::tick`] is one servo period: the ladder reads keys and switches and says what it wants of the NC
//! ([`Inputs`]), the NC does it, moves the axes, and tells the ladder ([`Outputs`]). [`Control::command`] is what a
//! front says, [`Control::events`] and [`Control::status`] what it hears ([`crate::api`]). A key of the panel is a
//! signal to the ladder; nothing but the ladder starts a motion. A control without a ladder is given its inputs
//! ([`Control::set_inputs`]).
//!
//! Read [`modes`] for what a change of mode does, `programs.rs` for what cycle start runs, `hand.rs` for axes moved by
//! hand, `keeping.rs` for what survives the power.

mod callable;
mod capture;
mod commands;
mod desk;
mod dnc;
mod exchange;
mod hand;
mod keeping;
mod keys;
mod ladder_names;
mod library;
mod machine;
mod machine_data;
mod measuring;
pub mod modes;
mod parameter_switch;
mod programs;
mod reading;
mod settings;
mod status;
mod taking_up;
mod timing;
mod trace;
mod wheel_drive;

use crate::api::{Activity, AlarmInfo, Event};
use crate::cnc::{self, Cnc, DryRun, State, Tick};
use crate::drives::{Drives, Switches};
use crate::restart::own_alarm;
use crate::restart::told::function;
use crate::signals::{ESP_BUTTON, Inputs, Mode, Outputs, SIGNAL_AXES};
use callable::Callable;
pub use callable::PublicPrograms;
pub use commands::{BACKUPS, backup_in};
pub use desk::Desk;
pub use exchange::{check_ladder, ladder_alarm, ladder_of};
use ferrocut_geometry::{Axis, AxisSet, Position};
use ferrocut_interpreter::{Interpreter, MachineCodes, Options, dialects};
use ferrocut_machine::{Alarm, Fault, Machine, Memory, ParameterKey, Parameters};
use ferrocut_memory::Store;
use ferrocut_plc::{Address, Area, Pace, Plc};
use ferrocut_program::{ProgramMemory, Span, Text};
use ferrocut_toolpath::{Op, SpindleState};
use keeping::{Found, Keeping};
pub use library::{Library, id_of};
use modes::{Change, Standing, Start};
use parameter_switch::ParameterSwitch;
use programs::Loaded;
use std::collections::{BTreeMap, VecDeque};
use std::sync::{Arc, Mutex};

/// Most events that wait for a front; the oldest go.
const MOST_EVENTS: usize = 1000;

/// What a control is made of besides its machine.
#[derive(Default)]
pub struct Parts {
    /// What the control remembers as delivered and set up; that of the durable memory goes over it.
    pub memory: Option<Memory>,
    /// The durable memory.
    pub store: Option<Arc<Store>>,
    /// Programs that come with the machine, where its control language knows such.
    pub public: Option<PublicPrograms>,
    /// The tool change program that comes with the machine (GSK990MC 8.1), in its control language.
    pub tool_change: Option<Vec<u8>>,
    /// The ladder.
    pub ladder: Option<ferrocut_plc::Program>,
    /// The drives; those of the machine file where there are none.
    pub drives: Option<Box<dyn Drives>>,
}

/// The whole control.
pub struct Control {
    machine: Machine,
    cnc: Cnc,
    plc: Option<Plc>,
    /// The text of the machine's own ladder.
    own_ladder: String,
    /// Who exchanged the ladder that is not kept yet.
    exchanged_by: Option<ferrocut_memory::Author>,
    keys: keys::Keys,
    callable: Callable,
    keeping: Option<Keeping>,
    /// What the ladder wants in this period, and in the one before.
    inputs: Inputs,
    before: Inputs,
    /// Commanded position of the period before.
    came_from: Position,
    outputs: Outputs,
    mode: Mode,
    loaded: Loaded,
    /// A program of the memory has another text since it was loaded.
    texts_changed: bool,
    selected: Option<String>,
    /// The line where AUTO begins, from 1.
    cursor: u32,
    /// The block that the cursor was put on last.
    followed: u64,
    mdi: String,
    mdi_block: String,
    /// What the program said last, until nothing runs.
    program_message: String,
    mdi_cursor: u32,
    dnc: dnc::Dnc,
    /// Program and sequence number behind which to stop.
    stop_at: Option<(Option<String>, u32)>,
    /// The keys of the axes in the last period: way, and rapid.
    jogs: [(i8, bool); SIGNAL_AXES],
    /// Axes of which a key was held when all was stopped, and is held still.
    stale_keys: [bool; SIGNAL_AXES],
    /// Cycle start was pressed, to start when it is let go.
    start_is_pressed: bool,
    /// It was let go while the ladder had the end of the program, which starts again behind that.
    starts_again: bool,
    /// Counts of the handwheel that were not given yet.
    counts: i32,
    /// The wheel, where it drives a program.
    wheel: wheel_drive::Wheel,
    /// The button of a front.
    button: bool,
    /// Where it opened the machine's line in the scan before: whether that was closed.
    button_opens: Option<bool>,
    emergency: bool,
    /// The alarm that stands, besides those of the emergency stop and the parameter switch.
    active: Option<Alarm>,
    parameter_switch: ParameterSwitch,
    /// Axes moved by hand that stand at a limit, upper or lower, with their alarms.
    at_limits: Vec<(Axis, bool, Alarm)>,
    /// The parameters that the machine was built with, and whether those of now would make another one of it.
    built_with: Parameters,
    /// What it remembers before anybody has set anything: the machine file's parameters and the set-up are in it.
    delivered: Memory,
    needs_power_off: bool,
    /// Parameters that say nothing of the machine until somebody sets them: as delivered, and, once that was asked, now.
    may_be_left: Vec<ParameterKey>,
    left_to_file: Option<Vec<ParameterKey>>,
    /// Axes that are moved back from their travel switches while the alarm of these stands.
    leaves: AxisSet,
    /// Relative coordinates are counted from this machine position.
    origin: Position,
    tick: Tick,
    moving: AxisSet,
    periods: u64,
    /// Periods for which the reset signal is still given.
    reset_left: u64,
    /// The reset brought the program to its head.
    rewinds: bool,
    state: State,
    /// What the control did as far as fronts were told.
    told_activity: Activity,
    parts: u32,
    /// Counters as their parameters had them last.
    shown: status::Shown,
    cutting_before: f64,
    ladder_names: ladder_names::LadderNames,
    counters: status::Count,
    sessions: BTreeMap<String, ferrocut_memory::Session>,
    taking_up: taking_up::TakingUp,
    capture: Option<Box<crate::capture::Capture>>,
    measuring: measuring::Measuring,
    /// Pitch errors that were set here; they hold from the next start on.
    pitch: machine_data::Pitch,
    /// Those of the machine file.
    own_pitch: machine_data::Pitch,
    timing: timing::Timing,
    reading: reading::Reading,
    /// Something is done within a servo period, which must not wait for the disk.
    is_in_period: bool,
    events: VecDeque<Event>,
}

/// Where [`ESP_BUTTON`] stands.
const EMERGENCY_BUTTON: Address = Address { area: Area::X, byte: ESP_BUTTON.1.0, bit: Some(ESP_BUTTON.1.1) };

impl Control {
    /// A control at power-on. Its axes stand where the durable memory says, else at zero.
    pub fn new(machine: &Machine, parts: Parts) -> Result<Control, Box<Alarm>> {
        let unknown = || alarm(Fault::UnknownDialect).with("name", machine.dialect.as_str());
        let dialect = dialects::by_name(&machine.dialect).ok_or_else(unknown)?;
        let mut memory = match parts.memory {
            Some(memory) => memory,
            None => as_delivered(machine)?,
        };
        let delivered = memory.clone();
        let library = match &parts.store {
            Some(store) => Library::Kept(store.clone()),
            None => Library::Held(Arc::new(Mutex::new(BTreeMap::new()))),
        };
        let own_ladder = parts.ladder.as_ref().map(ferrocut_plc::Program::text).unwrap_or_default();
        let mut plc = parts.ladder.map(|ladder| Plc::new(ladder, pace(machine)));
        let (keeping, found) = match parts.store {
            Some(store) => {
                let (keeping, found) = Keeping::open(store, &mut memory, plc.as_mut())?;
                (Some(keeping), found)
            }
            None => (None, Found::default()),
        };
        let (last, pitch) = (found.position, found.pitch);
        let start = last.as_ref().map_or(Position::ZERO, |last| last.position);
        let own_pitch = machine_data::points_of(machine);
        let machine = &machine_data::with_pitch(machine, &pitch);
        let text = Text::from_bytes(b"%".to_vec()).map_err(|_| alarm(Fault::FileNotText))?;
        let programs = ProgramMemory::new("", text, dialect.syntax);
        let every_code = plc.is_some();
        let machine_codes = MachineCodes::of(&machine.handshake.m_codes);
        let options = Options {
            start,
            optional_stop: true,
            loops_forever: true,
            every_code,
            ends_at_fixed_point: true,
            machine_codes,
            ..Options::default()
        };
        let mut interpreter = Interpreter::new(dialect, programs, memory, options);
        if let Some(system) = last.as_ref().and_then(|last| last.work_system) {
            interpreter.take_up_work_system(system);
        }
        if let Some(zero) = last.as_ref().and_then(|last| last.own_zero) {
            interpreter.take_up_own_zero(zero);
        }
        let built_with = interpreter.memory().parameters.clone();
        let all = delivered.parameters.table().iter().map(|row| row.key.clone());
        let may_be_left = dialect.left_to_file(machine, &delivered.parameters, all);
        let referenced = last.map(|last| last.referenced);
        let drives = match parts.drives {
            Some(drives) => drives,
            None => machine::drives(machine, &interpreter, referenced.unwrap_or(AxisSet::EMPTY))?,
        };
        let mut cnc = Cnc::with_drives(machine, interpreter, drives);
        if plc.is_some() {
            cnc.connect_ladder(machine);
        }
        // A simulated machine has the tool that the ladder kept, as its axes stand where they stood.
        if let (Some(plc), Some(plant)) = (&plc, cnc.drives().plant()) {
            let word = |name| Some(crate::diagnosis::value(plc.program().signal(name)?, 2, plc.memory()));
            if let (Some(tool), Some(pocket)) = (word("TOOL"), word("POCKET")) {
                plant.stand_with(tool, pocket.max(1));
            }
        }
        // 6#4: reference points that are kept. Drives that know their places by what was kept know no other ones.
        let drives = cnc.drives();
        let known_by_it = drives.knows_places() && drives.loses_place_with_power();
        if let Some(referenced) = referenced.filter(|_| cnc.remembers_reference() || known_by_it) {
            cnc.set_referenced(referenced);
        }
        let tick =
            Tick { position: start, actual: start, velocity: 0.0, span: Span::default(), moving: false };
        let mut control = Control {
            machine: machine.clone(),
            state: cnc.state().clone(),
            cnc,
            plc,
            own_ladder,
            exchanged_by: None,
            keys: keys::Keys::default(),
            callable: Callable::new(machine, dialect, library, parts.public, parts.tool_change, every_code),
            keeping,
            inputs: Inputs::default(),
            before: Inputs::default(),
            came_from: start,
            outputs: Outputs::default(),
            mode: Mode::default(),
            loaded: Loaded::Nothing,
            texts_changed: false,
            selected: None,
            cursor: 1,
            followed: 0,
            mdi: String::new(),
            mdi_block: String::new(),
            program_message: String::new(),
            mdi_cursor: 1,
            dnc: dnc::Dnc::default(),
            stop_at: None,
            jogs: [(0, false); SIGNAL_AXES],
            stale_keys: [false; SIGNAL_AXES],
            start_is_pressed: false,
            starts_again: false,
            counts: 0,
            wheel: wheel_drive::Wheel::default(),
            button: false,
            button_opens: None,
            emergency: false,
            active: None,
            parameter_switch: ParameterSwitch::default(),
            at_limits: Vec::new(),
            leaves: AxisSet::EMPTY,
            built_with,
            delivered,
            needs_power_off: false,
            may_be_left,
            left_to_file: None,
            origin: Position::ZERO,
            tick,
            moving: AxisSet::EMPTY,
            periods: 0,
            reset_left: 0,
            rewinds: false,
            told_activity: Activity::Idle,
            parts: 0,
            shown: status::Shown::default(),
            cutting_before: 0.0,
            ladder_names: ladder_names::LadderNames::default(),
            counters: found.counters,
            sessions: BTreeMap::new(),
            taking_up: taking_up::TakingUp::of(found.interrupted),
            capture: None,
            measuring: measuring::Measuring::default(),
            pitch,
            own_pitch,
            timing: timing::Timing::default(),
            reading: reading::Reading::default(),
            is_in_period: false,
            events: VecDeque::with_capacity(MOST_EVENTS),
        };
        if let Some(alarm) = found.ladder {
            control.log_alarm(&alarm);
        }
        // 11#6 (2.6, 5).
        if control.machine.homing.limits_before
            && let Some(alarm) = control.cnc.stroke_alarm_here()
        {
            control.raise(*alarm);
        }
        control.counters.starts += 1.0;
        control.show_counts();
        control.renew_ladder_names();
        Ok(control)
    }

    /// Inputs of a machine that is well, with nothing pressed: every permission given, overrides at 100 %. For a
    /// control without a ladder.
    pub fn free_inputs(mode: Mode) -> Inputs {
        Inputs {
            mode,
            axes_may_move: true,
            spindle_may_turn: true,
            spindle_at_speed: true,
            feed_override: 1.0,
            manual_override: 1.0,
            spindle_override: 1.0,
            ..Inputs::default()
        }
    }

    /// Sets what the NC is told from the next period on. A control with a ladder is told by that.
    pub fn set_inputs(&mut self, inputs: Inputs) {
        self.inputs = inputs;
    }

    /// What the NC was told last.
    pub fn inputs(&self) -> &Inputs {
        &self.inputs
    }

    /// What the NC told last.
    pub fn outputs(&self) -> &Outputs {
        &self.outputs
    }

    /// The ladder with its signals, for drives and tests that set inputs of the machine.
    pub fn plc_mut(&mut self) -> Option<&mut Plc> {
        self.plc.as_mut()
    }

    /// The simulated machine, where the drives are that.
    pub fn plant_mut(&mut self) -> Option<&mut crate::drives::Plant> {
        self.cnc.drives().plant()
    }

    /// The NC.
    pub fn cnc(&self) -> &Cnc {
        &self.cnc
    }

    /// The machine.
    pub fn machine(&self) -> &Machine {
        &self.machine
    }

    /// Takes what happened since the last call, oldest first.
    pub fn events(&mut self) -> Vec<Event> {
        self.events.drain(..).collect()
    }

    /// Goes on by one servo period.
    pub fn tick(&mut self) -> Tick {
        self.timing.begin();
        self.periods += 1;
        self.scan();
        self.take_emergency();
        self.take_switches();
        self.take_mode();
        self.take_keys();
        self.follow_reading();
        self.move_by_hand();
        self.turn_spindle();
        let before = self.tick.position;
        let arrived = self.cnc.at_reference();
        self.tick = self.cnc.tick();
        self.came_from = before;
        self.note_homed(arrived);
        let names = self.machine.axes.iter().map(|axis| axis.name);
        self.moving = names.filter(|axis| self.tick.position[*axis] != before[*axis]).collect();
        self.follow_cnc();
        self.follow_limits();
        self.tell_activity();
        self.follow_search();
        self.count();
        self.keep();
        self.tell(before);
        self.sample();
        self.before.clone_from(&self.inputs);
        self.timing.end();
        self.tick
    }

    /// The ladder, and what it wants.
    fn scan(&mut self) {
        let Some(plc) = &mut self.plc else { return };
        let memory = plc.memory_mut();
        // The button of a front is in one line with that of the machine, which says last whether it is closed.
        if let Some(was_closed) = self.button_opens.take() {
            memory.set_bit(EMERGENCY_BUTTON, was_closed);
        }
        self.cnc.drives().read(&mut |byte, bit, on| {
            memory.set_bit(Address { area: Area::X, byte, bit: Some(bit) }, on);
        });
        if self.button {
            self.button_opens = Some(memory.bit(EMERGENCY_BUTTON));
            memory.set_bit(EMERGENCY_BUTTON, false);
        }
        let was_stopped = plc.stopped().is_some();
        let scanned = plc.scan();
        let is_stopped = plc.stopped().is_some();
        match is_stopped {
            true => self.keys.settle(plc.memory_mut()),
            false if scanned.has_begun => self.keys.seen(plc.memory_mut()),
            false => {}
        }
        self.inputs = Inputs::read(plc.memory());
        let axes = self.machine.axes.iter().map(|axis| axis.name);
        let probe_opens = self.cnc.drives().probe_opens();
        // A ladder that has nothing to do with them leaves them as they are wired.
        let homes = self.ladder_names.has_home_switches && self.cnc.homes_through_ladder();
        self.cnc.set_switches(Some(Switches::of(&self.inputs, axes, homes, probe_opens)));
        self.cnc.hear(&self.inputs);
        self.renew_ladder_names();
        if let Some(plc) = &self.plc {
            // In manual modes only (part 2, 2.5.3).
            let is_manual = self.inputs.mode.is_manual();
            self.cnc.release_overtravel(is_manual && self.ladder_names.releases_overtravel(plc));
        }
        if scanned.rolled_back {
            self.tell_of(&alarm(Fault::LadderTakenOut).as_warning());
        }
        if is_stopped && !was_stopped {
            self.raise(alarm(Fault::LadderStopped));
        }
        self.tell_machine_messages();
    }

    /// The emergency stop (2.3.2): everything stands while it is pressed; released, it is gone.
    fn take_emergency(&mut self) {
        let pressed = self.button || self.inputs.emergency_stop;
        if pressed && !self.emergency {
            self.leave_done_block();
            self.cnc.emergency_stop();
            self.cnc.turn_spindle(SpindleState::Off);
            self.cancel_start();
            self.release_axes();
            self.give_up();
            self.cancel_relative();
            self.log_alarm(&self.own_alarm(Fault::EmergencyStop));
        }
        let is_released = !pressed && self.emergency;
        if is_released {
            self.cancel_start();
        }
        self.emergency = pressed;
        self.cnc.power_drives(!pressed);
        if is_released && !self.is_alarmed() {
            self.event(Event::AlarmsCleared);
        }
    }

    /// Switches and overrides.
    fn take_switches(&mut self) {
        let is_driven = self.is_driven_by_wheel();
        let wheel = self.take_wheel_drive();
        let inputs = &self.inputs;
        let rapid = inputs.rapid_override.factor();
        // F0 is a speed for each axis, or none (7.9).
        let (rapid_share, rapid_speed) = match rapid {
            Some(share) => (share, f64::INFINITY),
            None if self.bit(12, 4) || !(self.parameter(93) > 0.0) => (0.0, f64::INFINITY),
            None => (1.0, self.parameter(93) / 60.0),
        };
        let (feed, manual) = (inputs.feed_override, inputs.manual_override);
        let dry = (inputs.dry_run && !is_driven).then(|| DryRun {
            speed: self.parameter(86) / 60.0,
            cutting: self.bit(12, 6),
            rapid: self.bit(12, 7),
            tapping: self.bit(12, 5),
        });
        let (single, skip) = (inputs.single_block, inputs.block_skip);
        let (optional, auxiliary, lock) = (inputs.optional_stop, inputs.auxiliary_lock, inputs.machine_lock);
        let may = inputs.axes_may_move;
        self.cnc.set_overrides(feed * wheel, rapid_share * wheel, manual, rapid.unwrap_or(0.0));
        self.cnc.set_rapid_speed(rapid_speed * wheel);
        self.cnc.set_dry_run(dry);
        self.cnc.set_single_block(single);
        self.cnc.set_auxiliary_lock(auxiliary);
        self.cnc.set_optional_stop(optional);
        let is_new = lock != self.before.machine_lock;
        if !self.cnc.set_machine_lock(lock) && is_new && self.cnc.is_under_way() {
            // It comes and goes once the program has ended: nobody is to think that the axes are locked.
            self.refuse(&alarm(Fault::ControlBusy));
        }
        self.cnc.set_may_move(may);
        // What took the permission may have stopped the spindle.
        let is_given_back = may && !self.before.axes_may_move;
        if is_given_back && self.standing() == Standing::Runs && self.cnc.spindle_due().is_some() {
            self.cnc.feed_hold();
        }
        // M01 is given out always: whether it stops is decided where it stands.
        self.cnc.set_block_skip(skip, true);
    }

    fn standing(&self) -> Standing {
        match self.cnc.state() {
            State::Running if self.cnc.finishes_block() => Standing::Finishes,
            State::Running => Standing::Runs,
            State::Held | State::BlockEnd | State::Stopped(_) => Standing::Stopped,
            _ => Standing::None,
        }
    }

    /// The mode of the program that is loaded.
    fn program_mode(&self) -> Mode {
        self.loaded.mode().unwrap_or(Mode::Auto)
    }

    fn take_mode(&mut self) {
        if self.inputs.mode == self.mode {
            return;
        }
        self.leave_home(self.mode);
        self.mode = self.inputs.mode;
        self.reading.cancel_start();
        self.starts_again = false;
        self.release_axes();
        self.event(Event::Mode { mode: self.mode });
        // Steps and counts that were given are of the mode that is left.
        self.cnc.stop_by_hand();
        if self.cnc.goes_back() || self.cnc.returns() {
            self.cnc.feed_hold();
        }
        if matches!(self.standing(), Standing::Runs | Standing::Finishes) {
            match modes::change(self.program_mode(), self.mode) {
                Change::Nothing => {}
                Change::FinishBlock => self.cnc.finish_block(),
                Change::StopAtOnce => self.cnc.feed_hold(),
            }
        }
    }

    /// Cycle start, feed hold, reset, program restart.
    fn take_keys(&mut self) {
        self.take_restart_key();
        if self.inputs.reset && !self.before.reset || self.inputs.rewind && !self.before.rewind {
            self.reset();
            self.rewinds = self.inputs.rewind;
            if self.rewinds {
                self.cursor = 1;
            }
        }
        // It starts when the key is let go (Fanuc 0i, ST). What was pressed before the end of an emergency
        // stop, or before a reset, is over.
        let is_let_go = !self.inputs.cycle_start && std::mem::take(&mut self.start_is_pressed);
        self.start_is_pressed |= self.inputs.cycle_start && !self.before.cycle_start;
        if self.inputs.feed_hold {
            self.reading.cancel_start();
        }
        let moves = matches!(self.standing(), Standing::Runs | Standing::Finishes) || self.cnc.goes_back();
        // An interlock acts where the key does not (2.4 notes 1, 2, 4): behind an open door no block is finished.
        let locks = self.inputs.start_lock && moves;
        if self.inputs.feed_hold || locks {
            self.starts_again = false;
            if locks || self.cnc.returns() || self.cnc.goes_back() || modes::holds(self.standing()) {
                self.cnc.feed_hold();
            }
            return;
        }
        let starts_again = self.cnc.state() == &State::Ended && std::mem::take(&mut self.starts_again);
        if (is_let_go || starts_again)
            && let Err(why) = self.cycle_start()
        {
            self.refuse(&why);
        }
    }

    /// No program starts any more by what was pressed so far.
    fn cancel_start(&mut self) {
        self.reading.cancel_start();
        (self.start_is_pressed, self.starts_again) = (false, false);
    }

    /// An alarm under the number that the control has for it, if it has one.
    fn own_alarm(&self, fault: Fault) -> Alarm {
        own_alarm(self.cnc.interpreter().dialect(), fault, Span::default())
    }

    /// Whether a program may be started, or its axes be sent back.
    fn may_start(&self) -> Result<(), Box<Alarm>> {
        if self.emergency {
            return Err(Box::new(self.own_alarm(Fault::EmergencyStop)));
        }
        if self.is_alarmed() {
            return Err(Box::new(alarm(Fault::ControlAlarmed)));
        }
        if self.inputs.start_lock {
            return Err(Box::new(alarm(Fault::StartLocked)));
        }
        Ok(())
    }

    /// Sends the axes of a program that is held back along its path.
    fn retrace(&mut self) -> Result<(), Box<Alarm>> {
        self.may_start()?;
        if self.mode != self.program_mode() {
            return Err(Box::new(alarm(Fault::ControlMode).with("mode", name_of(self.mode))));
        }
        match !self.inputs.feed_hold && self.cnc.retrace() {
            true => Ok(()),
            false => Err(Box::new(alarm(Fault::NoWayBack))),
        }
    }

    fn cycle_start(&mut self) -> Result<(), Box<Alarm>> {
        self.may_start()?;
        match modes::start(self.program_mode(), self.standing(), self.mode) {
            Start::Nothing => {
                // All stands, and to who pressed it the program has ended.
                self.starts_again = self.cnc.is_ending();
                Ok(())
            }
            Start::WrongMode => Err(Box::new(alarm(Fault::ControlMode).with("mode", name_of(self.mode)))),
            Start::OtherMode => {
                Err(Box::new(alarm(Fault::ControlInterrupted).with("mode", name_of(self.program_mode()))))
            }
            Start::GoesOn => {
                if let Some(alarm) = self.cnc.way_back_alarm().or_else(|| self.cnc.shift_alarm()) {
                    return Err(alarm);
                }
                self.spindle_must_turn()?;
                self.cnc.do_not_finish_block();
                self.cnc.cycle_start();
                Ok(())
            }
            Start::Starts if !self.cnc.is_idle() => Err(Box::new(alarm(Fault::ControlBusy))),
            Start::Starts => self.start_program(),
        }
    }

    /// A program that has stopped goes on with the spindle as it has it.
    fn spindle_must_turn(&self) -> Result<(), Box<Alarm>> {
        match self.cnc.spindle_due().filter(|_| self.standing() == Standing::Stopped) {
            None => Ok(()),
            Some(state) => {
                let code = function(&Op::Spindle(state), &self.tick.position);
                Err(Box::new(alarm(Fault::RestartNotAsProgram).with("name", code.unwrap_or_default())))
            }
        }
    }

    /// Reset (2.3.1): axes and spindle stop, the program is given up, parameters say what else is cleared.
    fn reset(&mut self) {
        self.rewinds = false;
        self.leave_done_block();
        self.cancel_start();
        if self.cnc.is_idle() {
            self.cnc.clear();
        } else {
            self.cnc.reset();
        }
        self.release_axes();
        self.give_up();
        // 10.1.9 note 3: the restart is to be prepared anew.
        self.forget_prepared();
        self.cnc.forget_cut_short();
        let stood = !std::mem::take(&mut self.at_limits).is_empty();
        if (self.active.take().is_some() || stood) && !self.is_alarmed() {
            self.event(Event::AlarmsCleared);
        }
        // P203: ms for which the signal is given.
        self.reset_left = (self.parameter(203) / self.machine.servo_period_ms).clamp(1.0, 1e6) as u64;
        // 28#7, in MDI.
        if self.mode == Mode::Mdi && self.bit(28, 7) {
            self.clear_mdi();
        }
        self.cancel_relative();
        // 10#7.
        if self.mode != Mode::Edit && self.bit(10, 7) {
            self.cursor = 1;
        }
    }

    /// 10#3: a reset cancels relative coordinates. The manual names the key alone (2.3.1); the emergency stop is a reset here
    /// as on the Fanuc 0i-M, for these as for the variables of 52#6 and 52#7.
    fn cancel_relative(&mut self) {
        if self.bit(10, 3) {
            self.origin = Position::ZERO;
        }
    }

    /// The program under way is given up: the cursor stays on its block.
    fn give_up(&mut self) {
        self.take_mdi_block();
    }

    /// What the NC came to in this period.
    fn follow_cnc(&mut self) {
        while let Some(event) = self.cnc.next_event() {
            match event {
                cnc::Event::Warning(alarm) => self.tell_of(&alarm),
                cnc::Event::Message(text) => {
                    self.program_message = text.into();
                    self.event(Event::Message { text: self.program_message.clone() });
                }
                cnc::Event::ToolChange(tool) => self.event(Event::ToolChange { tool }),
            }
        }
        self.follow_cursor();
        if self.cnc.state() == &self.state {
            return;
        }
        let state = self.cnc.state().clone();
        self.is_in_period = true;
        match &state {
            State::Alarmed(alarm) => self.raise((**alarm).clone()),
            State::Ended if self.loaded == Loaded::Measuring => self.end_measuring(),
            State::Ended => self.program_ended(self.cnc.ended_by()),
            State::BlockEnd if self.cnc.stops_behind().is_none() => self.stop_at_is_done(),
            _ => {}
        }
        self.follow_run(&state);
        self.is_in_period = false;
        self.state = state;
        if matches!(self.state, State::Ready | State::Ended | State::Reset) {
            self.program_message.clear();
        }
    }

    /// The cursor stands on the block of the main program that is run: within a subprogram on its call. Once it does it may
    /// be moved by hand.
    fn follow_cursor(&mut self) {
        let (line, (block, _)) = (self.cnc.main_line(), self.cnc.block_run());
        let is_run = self.cnc.is_under_way() && !self.cnc.is_leading_in()
            || matches!(self.cnc.state(), State::Alarmed(_));
        let is_new = self.cnc.state() == &State::Running || block != self.followed;
        if is_run && is_new && matches!(self.loaded, Loaded::Auto(_)) && line > 0 {
            (self.cursor, self.followed) = (line, block);
        }
    }

    /// The program is about to be given up: the cursor leaves a block that is done.
    fn leave_done_block(&mut self) {
        if let Some(line) = self.cnc.main_line_behind()
            && matches!(self.loaded, Loaded::Auto(_))
            && self.cursor == self.cnc.main_line()
        {
            self.cursor = line;
        }
    }

    /// Tells once what the control does now, whatever it comes from: the NC, the emergency stop, an alarm. Axes moved by hand
    /// come and go with each count of the handwheel, and are no news.
    fn tell_activity(&mut self) {
        let activity = match self.activity() {
            Activity::ByHand => Activity::Idle,
            activity => activity,
        };
        if activity != self.told_activity {
            self.told_activity = activity;
            self.event(Event::Activity { activity });
        }
    }

    /// 3.4.1: the stop number goes once it has stopped.
    fn stop_at_is_done(&mut self) {
        let line = self.stop_at.as_ref().map(|(_, sequence)| *sequence);
        let text = self.cnc.interpreter().programs().slice(self.tick.span);
        let is_there = line.is_some_and(|n| {
            let text = text.trim_start().trim_start_matches('/').trim_start();
            let number: String = text.chars().skip(1).take_while(char::is_ascii_digit).collect();
            text.starts_with(['N', 'n']) && number.parse() == Ok(n)
        });
        if is_there {
            self.stop_at = None;
        }
    }

    /// An alarm stands until reset.
    fn raise(&mut self, alarm: Alarm) {
        self.log_alarm(&alarm);
        self.active = Some(alarm);
        self.starts_again = false;
    }

    /// Whether an alarm stands.
    fn is_alarmed(&self) -> bool {
        self.keeps_axes() || !self.at_limits.is_empty()
    }

    /// Whether an alarm stands with which no axis is moved by hand.
    fn keeps_axes(&self) -> bool {
        self.emergency || self.active.is_some() || self.parameter_switch == ParameterSwitch::On
    }

    /// Tells of an alarm and puts it into the history.
    fn log_alarm(&mut self, alarm: &Alarm) {
        self.tell_of(alarm);
        let program = self.running_program();
        if let Some(keeping) = &mut self.keeping {
            keeping.alarm(alarm, &program);
        }
    }

    /// The name of the file of the block being run.
    fn running_program(&self) -> String {
        self.cnc.interpreter().programs().file_name(self.tick.span.file).to_owned()
    }

    /// What the control does.
    pub fn activity(&self) -> Activity {
        if self.emergency {
            return Activity::Emergency;
        }
        if self.is_alarmed() {
            return Activity::Alarm;
        }
        if self.cnc.returns() {
            return Activity::Returning;
        }
        match self.cnc.state() {
            State::Running => Activity::Running,
            State::Held => Activity::Held,
            State::BlockEnd => Activity::BlockEnd,
            State::Stopped(_) => Activity::Stopped,
            State::Resetting => Activity::Resetting,
            State::Alarmed(_) => Activity::Alarm,
            State::Ready | State::Ended | State::Reset if self.tick.moving => Activity::ByHand,
            State::Ready | State::Ended | State::Reset => Activity::Idle,
        }
    }

    /// What the ladder is told.
    fn tell(&mut self, before: Position) {
        let state = self.cnc.state();
        let is_alarm = self.is_alarmed();
        let failed = self.cnc.drives_have_failed();
        let mut outputs = Outputs {
            mode: self.mode,
            ready: true,
            servo_ready: !self.emergency && !failed,
            // They turn the spindle, too.
            spindle_alarm: failed,
            alarm: is_alarm,
            reset: self.reset_left > 0 || matches!(state, State::Resetting),
            rewinding: self.reset_left > 0 && self.rewinds,
            automatic: self.cnc.is_under_way(),
            running: matches!(state, State::Running) || self.cnc.goes_back(),
            held: matches!(state, State::Held) && !self.cnc.goes_back(),
            distribution_end: !self.tick.moving,
            dry_run: self.inputs.dry_run,
            block_skip: self.inputs.block_skip,
            machine_lock: self.cnc.is_locked(),
            single_block: self.inputs.single_block,
            auxiliary_lock: self.cnc.is_auxiliary_locked(),
            spindle_rpm: self.cnc.spindle().rpm().clamp(0.0, 65_535.0) as u16,
            spindle_enabled: self.cnc.spindle().rpm() > 0.0,
            spindle_zero: self.cnc.spindle().rpm() == 0.0,
            parts_reached: self.parts_are_made(),
            restarting: self.taking_up.is_ready() || self.cnc.is_leading_in(),
            ..self.outputs.clone()
        };
        let (referenced, at_reference) = (self.cnc.referenced(), self.cnc.at_reference());
        for (number, axis) in self.machine.axes.iter().enumerate().take(SIGNAL_AXES) {
            let way = self.tick.position[axis.name] - before[axis.name];
            let set = |bits: &mut [bool; SIGNAL_AXES], on: bool| {
                if let Some(bit) = bits.get_mut(number) {
                    *bit = on;
                }
            };
            set(&mut outputs.moving, way != 0.0);
            if way != 0.0 {
                set(&mut outputs.downwards, way < 0.0);
            }
            set(&mut outputs.referenced, referenced.contains(axis.name));
            let points = &self.cnc.interpreter().memory().reference_points;
            let at = |point: &Position| (point[axis.name] - self.tick.position[axis.name]).abs() < 1e-6;
            let knows = referenced.contains(axis.name) && way == 0.0 && !self.cnc.is_locked();
            set(&mut outputs.at_reference, at_reference.contains(axis.name));
            for (further, point) in outputs.at_further_reference.iter_mut().zip(points.iter().skip(1)) {
                set(further, knows && at(point));
            }
            set(&mut outputs.in_position, way == 0.0);
        }
        self.reset_left = self.reset_left.saturating_sub(1);
        self.cnc.tell(&mut outputs);
        self.outputs = outputs;
        if let Some(plc) = &mut self.plc {
            self.outputs.write(plc.memory_mut());
            let memory = plc.memory();
            self.cnc.drives().write(&|byte, bit| memory.bit(Address { area: Area::Y, byte, bit: Some(bit) }));
        }
    }

    fn event(&mut self, event: Event) {
        if self.events.len() >= MOST_EVENTS {
            self.events.pop_front();
        }
        self.events.push_back(event);
    }

    /// Tells that something asked for is refused.
    fn refuse(&mut self, why: &Alarm) {
        self.event(Event::Refused { alarm: AlarmInfo::of(why) });
    }

    /// Tells of an alarm or a warning.
    fn tell_of(&mut self, alarm: &Alarm) {
        self.event(Event::Alarm { alarm: AlarmInfo::of(alarm) });
    }

    /// A bit parameter; off on controls that do not have it.
    fn bit(&self, number: u16, bit: u8) -> bool {
        self.cnc.interpreter().memory().parameters.bit(number, bit)
    }

    /// A data parameter.
    fn parameter(&self, number: u16) -> f64 {
        self.cnc.interpreter().memory().parameters.get(&ParameterKey::Data(number))
    }
}

fn alarm(fault: Fault) -> Alarm {
    Alarm::core(fault, Span::default())
}

/// The name of a mode in alarms.
fn name_of(mode: Mode) -> &'static str {
    match mode {
        Mode::Edit => "EDIT",
        Mode::Auto => "AUTO",
        Mode::Mdi => "MDI",
        Mode::Home => "HOME",
        Mode::Jog => "JOG",
        Mode::Step => "STEP",
        Mode::Handle => "HANDLE",
        Mode::Dnc => "DNC",
    }
}

fn pace(machine: &Machine) -> Pace {
    Pace { period_us: (machine.servo_period_ms * 1000.0).clamp(1.0, 1e6) as u32, ..Pace::default() }
}

/// The memory of a new control, with the parameters of the machine file.
pub fn as_delivered(machine: &Machine) -> Result<Memory, Box<Alarm>> {
    let mut memory = Memory::new(&machine.dialect);
    let unusable = |reason: String| alarm(Fault::ConfigUnusable).with("reason", reason);
    let mut parameters = Vec::new();
    for (name, value) in &machine.parameters {
        let key: ParameterKey = name.parse().map_err(|error| unusable(format!("{error}")))?;
        parameters.push((key, *value));
    }
    memory
        .set_parameters(parameters.iter().map(|(key, value)| (key, *value)))
        .map_err(|error| unusable(error.to_string()))?;
    Ok(memory)
}
