//! What a front says, and what comes of it. Data go through the durable memory, which judges rights.

use super::exchange::check_ladder;
use super::status::PARTS_MACHINED;
use super::taking_up::Wanted;
use super::{Control, alarm, capture, library, name_of, trace};
use crate::api::{
    API_VERSION, ByAxis, Command, Event, LogLine, OffsetValues, PastAlarm, ProgramInfo, Refusal, RelativeTo,
    Reply,
};
use crate::diagnosis::{self, named_in, table};
use crate::restart::How;
use crate::signals::Mode;
use ferrocut_geometry::{Axis, Position};
use ferrocut_machine::setup::VariableName;
use ferrocut_machine::{Alarm, Fault, ParameterKey, ToolOffset, WorkOffset};
use ferrocut_memory::items::limits;
use ferrocut_memory::password::Seat;
use ferrocut_memory::{Author, Backup, Change, Counter, Item, Level, Session, is_program_name};
use ferrocut_plc::{Address, Area};
use std::collections::BTreeMap;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use std::sync::{Arc, PoisonError};

/// Most numbers that one answer holds.
const MOST_VALUES: usize = 10_000;

/// How long the flow of the ladder is recorded after it was asked for, µs.
const FLOW_ASKED_US: u32 = 1_000_000;

/// Longest text of MDI, bytes (10.1.1.2: 65 characters a block).
const LONGEST_MDI: usize = 1 << 20;

/// What the event `changed` calls the backups in the folder of the memory.
pub const BACKUPS: &str = "backups";

/// What the event `changed` calls the text and the block of MDI.
const MDI: &str = "mdi";

pub(super) type Answer = Result<Reply, Box<Alarm>>;

pub(super) fn named(fault: Fault, name: impl Into<String>) -> Alarm {
    alarm(fault).with("name", name.into())
}

/// Counts of the handwheel that may be told at once: ten turns of it.
const MOST_COUNTS: i32 = 1000;

impl Control {
    /// Does what a front wants, or says why not. `author` is who wants it: rights are his, or those that he logged
    /// in with here. What changes the durable memory waits for it while nothing moves and no drives need a
    /// setpoint in each period.
    pub fn command(&mut self, command: Command, author: &Author) -> Result<Reply, Refusal> {
        self.settle_changes();
        let author = self.with_rights(author);
        self.obey(command, &author).map_err(|alarm| Refusal::from(*alarm))
    }

    /// The author with the rights that he has logged in with.
    pub(super) fn with_rights(&self, author: &Author) -> Author {
        match author {
            Author::Person { session, name } => {
                let taken = self.sessions.get(name);
                let session = taken.filter(|taken| taken.level().covers(session.level())).unwrap_or(session);
                Author::Person { session: session.clone(), name: name.clone() }
            }
            other => other.clone(),
        }
    }

    fn obey(&mut self, command: Command, author: &Author) -> Answer {
        match command {
            Command::Key { key, down } => self.key(&key, down),
            Command::Switch { switch, position } => self.switch(&switch, position),
            Command::Handwheel { counts } => {
                self.counts = self.counts.saturating_add(counts).clamp(-MOST_COUNTS, MOST_COUNTS);
                Ok(Reply::Done)
            }
            Command::StopByHand => {
                self.counts = 0;
                self.cnc.stop_by_hand();
                Ok(Reply::Done)
            }
            Command::EmergencyStop { pressed } => {
                self.button = pressed;
                if let Some(plant) = self.cnc.drives().plant() {
                    plant.press_emergency_stop(pressed);
                }
                Ok(Reply::Done)
            }
            Command::Reset => {
                self.reset();
                Ok(Reply::Done)
            }
            Command::Programs => self.programs(),
            Command::Select { program } => {
                let program = self.select(&program)?;
                self.event(Event::Selected { program });
                Ok(Reply::Done)
            }
            Command::Store { program, text } => self.store(program, text, author),
            Command::Read { program } => self.read(&program),
            Command::Delete { program } => self.delete(&program, author),
            Command::Rename { program, to } => self.rename(&program, &to, author),
            Command::Lock { program, locked } => {
                let name = self.known(&program)?;
                if self.keeping.is_none() {
                    return Err(Box::new(named(Fault::NotFitted, "memory")));
                }
                self.change_data(author, Change::LockProgram { name, locked })
            }
            Command::Retrace => self.retrace().map(|()| Reply::Done),
            Command::Cursor { line } => self.put_cursor(line),
            Command::Mdi { text } => self.type_mdi(text, false),
            Command::MdiBlock { block } => self.type_mdi(block, true),
            Command::MdiText => Ok(Reply::MdiText { text: self.mdi.clone(), block: self.mdi_block.clone() }),
            Command::Dnc { text, first, last } => self.take_dnc(&text, first, last),
            Command::StopAt { program, sequence } => {
                if let Some(sequence) = sequence {
                    let of = program.as_ref().or(self.selected.as_ref());
                    let of = of.ok_or_else(|| named(Fault::NoSuchName, format!("N{sequence}")))?;
                    self.may_stop_at(of, sequence)?;
                }
                self.stop_at = sequence.map(|sequence| (program, sequence));
                self.arm_stop();
                Ok(Reply::Done)
            }
            Command::Offsets { from, to } => Ok(self.offsets(from, to)),
            Command::SetOffset { number, values, add } => self.set_offset(number, values, add, author),
            Command::Zeros => Ok(self.zeros()),
            Command::SetZero { system, axes, add } => self.set_zero(&system, &axes, add, author),
            Command::ZeroHere { system, axes, typed } => self.zero_here(&system, &axes, typed, author),
            Command::Variables { from, to } => Ok(self.variables(from, to)),
            Command::SetVariable { number, value } => {
                self.needs(Mode::Mdi, author)?;
                let name = VariableName::Number(number);
                self.change_data(author, Change::Variable { name, value: finite(value)? })
            }
            Command::Parameters { names } => self.parameters(&names),
            Command::SetParameter { name, value } => self.set_parameter(&name, value, author),
            Command::ParameterSwitch { on } => self.turn_parameter_switch(on, author),
            Command::AcceptParameterSwitch => Ok(self.accept_parameter_switch()),
            Command::ReferencePoints => Ok(self.reference_points()),
            Command::SetMachineZero { axes } => self.set_machine_zero(&axes, author),
            Command::SetReferencePoint { number, axes } => self.set_reference_point(number, &axes, author),
            Command::Pitch { axis } => self.pitch(axis),
            Command::SetPitch { axis, points } => self.set_pitch(axis, &points, author),
            Command::Relative { axis, to } => self.set_relative(axis, to),
            Command::SpindleSpeed { speed } => self.set_spindle_speed(speed),
            Command::ClearInterruption { axis } => {
                let axis = axis.map(|letter| self.axis_named(letter)).transpose()?;
                match self.cnc.clear_handwheel_shift(axis) {
                    true => Ok(Reply::Done),
                    false => Err(Box::new(alarm(Fault::ControlBusy))),
                }
            }
            Command::SetCounter { counter, value } => {
                let counter = Counter::named(&counter).ok_or_else(|| named(Fault::NoSuchName, counter))?;
                let range = 0.0..=counter.highest();
                let value = within(value, range.clone())?;
                if !counter.is_time() && value.fract() != 0.0 {
                    return Err(Box::new(outside(value.to_string(), &range)));
                }
                self.change_data(author, Change::Counter { counter, value })
            }
            Command::LogIn { level, password } => self.log_in(level, &password, author),
            Command::LogOut => {
                self.sessions.remove(author.name());
                self.event(Event::Level { level: Level::Operator.number() });
                Ok(Reply::Level { level: Level::Operator.number() })
            }
            Command::SetPassword { level, password } => self.set_password(level, &password, author),
            Command::AlarmHistory { most } => self.alarm_history(most),
            Command::ClearAlarmHistory => self.needs_memory(author, Change::ClearAlarms),
            Command::OperationLog { most } => self.operation_log(most),
            Command::ClearOperationLog => self.needs_memory(author, Change::ClearLog),
            Command::Signals { names } => self.signals(&names),
            Command::SignalTable { area, language } => self.signal_table(area, language.as_deref()),
            Command::Ladder => {
                let plc = self.plc.as_ref().ok_or_else(|| named(Fault::NotFitted, "ladder"))?;
                Ok(Reply::Text { text: plc.program().text() })
            }
            Command::WatchLadder { on } => {
                self.plc.as_mut().ok_or_else(|| named(Fault::NotFitted, "ladder"))?.watch(on);
                Ok(Reply::Done)
            }
            Command::LadderFlow => {
                let plc = self.plc.as_mut().ok_or_else(|| named(Fault::NotFitted, "ladder"))?;
                plc.watch_for(FLOW_ASKED_US);
                Ok(Reply::LadderFlow { power: plc.flow().map(|flow| flow.is_powered).collect() })
            }
            Command::Trace { signals, samples, trigger, behind, changes_only } => {
                self.begin_trace(&trace::Wanted { signals, samples, trigger, behind, changes_only })
            }
            Command::Traced { from, most } => self.traced(from, most),
            Command::EndTrace => Ok(self.end_trace()),
            Command::Forced => self.forced(),
            Command::Force { signal, value } => self.force(&signal, value, author),
            Command::SetSignal { signal, value, bytes } => self.set_signal(&signal, value, bytes, author),
            Command::CheckLadder { text } => Ok(check_ladder(&text)),
            Command::ExchangeLadder { text } => self.exchange_ladder(&text, author),
            Command::RollBackLadder => self.roll_back_ladder(author),
            Command::StartLadder => {
                self.needs_level(Level::Builder, author)?;
                self.plc.as_mut().ok_or_else(|| named(Fault::NotFitted, "ladder"))?.restart();
                Ok(Reply::Done)
            }
            Command::Restart { line, pass, file, sends, axis_by_axis } => {
                self.prepare_restart(Wanted { line, pass, file, how: How { sends, axis_by_axis } })
            }
            Command::Restarts => self.restarts(),
            Command::CancelRestart => {
                self.forget_restart();
                Ok(Reply::Done)
            }
            Command::Capture { quantities, seconds, every, trigger, before } => {
                self.begin_capture(capture::Wanted { quantities, seconds, every, trigger, before })
            }
            Command::Captured { from, most } => self.captured(from, most),
            Command::EndCapture => self.end_capture(),
            Command::TouchPoint { number } => self.touch_point(number),
            Command::Points => Ok(self.points()),
            Command::ClearPoints => Ok(self.clear_points()),
            Command::Centre { circle, system, values } => self.centre(circle, system, &values, author),
            Command::Measure(asked) => self.prepare_work(*asked, author),
            Command::MeasureTool(asked) => self.prepare_tool(*asked, author),
            Command::CancelMeasure => Ok(self.cancel_measure()),
            Command::Measured => Ok(self.measured()),
            Command::Backup { file, items } => self.back_up(&file, &items),
            Command::Restore { file, items } => self.restore(&file, &items, author),
            Command::Status => {
                let mut status = self.status();
                status.level = author.level().map(Level::number);
                Ok(Reply::Status(Box::new(status)))
            }
            Command::Timing { forget } => Ok(self.timing(forget)),
            Command::Version => Ok(Reply::Version {
                api: API_VERSION,
                software: env!("CARGO_PKG_VERSION").to_owned(),
                dialect: self.cnc.interpreter().dialect().name.to_owned(),
                machine: self.machine.name.clone(),
                axes: self.machine.axes.iter().map(|axis| axis.name.letter()).collect(),
                period_ms: self.machine.servo_period_ms,
                time: ferrocut_memory::items::now(),
            }),
        }
    }

    /// A change of data, which the memory judges.
    pub(super) fn change_data(&mut self, author: &Author, change: Change) -> Answer {
        self.change_data_together(author, vec![change])
    }

    fn change_data_together(&mut self, author: &Author, changes: Vec<Change>) -> Answer {
        match self.change_together(author, changes)? {
            true => Ok(Reply::Done),
            false => Ok(Reply::OnItsWay),
        }
    }

    fn needs_memory(&mut self, author: &Author, change: Change) -> Answer {
        match self.keeping {
            Some(_) => self.change_data(author, change),
            None => Err(Box::new(named(Fault::NotFitted, "memory"))),
        }
    }

    /// A person does it in this mode alone.
    pub(super) fn needs(&self, mode: Mode, author: &Author) -> Result<(), Box<Alarm>> {
        match author {
            Author::Person { .. } if self.mode != mode => {
                Err(Box::new(alarm(Fault::ControlMode).with("mode", name_of(self.mode))))
            }
            _ => Ok(()),
        }
    }

    pub(super) fn needs_level(&self, needed: Level, author: &Author) -> Result<(), Box<Alarm>> {
        match author.level() {
            Some(level) if !level.covers(needed) => Err(Box::new(
                alarm(Fault::RightMissing)
                    .with("needed", f64::from(needed.number()))
                    .with("level", f64::from(level.number())),
            )),
            _ => Ok(()),
        }
    }

    // Keys and signals.

    fn key(&mut self, key: &str, down: bool) -> Answer {
        let plc = self.plc.as_mut().ok_or_else(|| named(Fault::NotFitted, "ladder"))?;
        let address = plc.program().signal(key).filter(|a| a.area == Area::X && a.bit.is_some());
        let address = address.ok_or_else(|| named(Fault::NoSuchName, key))?;
        self.keys.change(plc.memory_mut(), address, down);
        Ok(Reply::Done)
    }

    fn switch(&mut self, switch: &str, position: u8) -> Answer {
        let plc = self.plc.as_mut().ok_or_else(|| named(Fault::NotFitted, "ladder"))?;
        let address = plc.program().signal(switch).filter(|a| a.area == Area::X && a.bit.is_none());
        let address = address.ok_or_else(|| named(Fault::NoSuchName, switch))?;
        if let Some((_, last)) =
            LAST_POSITIONS.iter().find(|(name, last)| *name == switch && position > *last)
        {
            return Err(Box::new(outside(position.to_string(), &(0.0..=f64::from(*last)))));
        }
        plc.memory_mut().set_byte(address, position);
        Ok(Reply::Done)
    }

    pub(super) fn address(&self, name: &str) -> Result<Address, Box<Alarm>> {
        let plc = self.plc.as_ref().ok_or_else(|| named(Fault::NotFitted, "ladder"))?;
        let known = diagnosis::find(name, plc.program()).map(|signal| signal.address);
        known.ok_or_else(|| Box::new(named(Fault::NoSuchName, name)))
    }

    fn signals(&self, names: &[String]) -> Answer {
        let mut signals = BTreeMap::new();
        let plc = self.plc.as_ref().ok_or_else(|| named(Fault::NotFitted, "ladder"))?;
        for name in names.iter().take(MOST_VALUES) {
            let signal =
                diagnosis::find(name, plc.program()).ok_or_else(|| named(Fault::NoSuchName, name))?;
            signals.insert(name.clone(), i64::from(signal.value(plc.memory())));
        }
        Ok(Reply::Signals { signals })
    }

    /// It takes longer than a period where a ladder has many names: whoever serves a control does it beside.
    fn signal_table(&self, area: char, language: Option<&str>) -> Answer {
        let plc = self.plc.as_ref().ok_or_else(|| named(Fault::NotFitted, "ladder"))?;
        let (area, language) = named_in(area, language).ok_or_else(|| named(Fault::NoSuchName, area))?;
        Ok(Reply::SignalTable { signals: table(area, language, plc.program(), plc.memory()) })
    }

    // Programs.

    fn programs(&self) -> Answer {
        let programs = match self.callable.library() {
            library::Library::Held(programs) => {
                let programs = programs.lock().unwrap_or_else(PoisonError::into_inner);
                let info = |(name, text): (&String, &Vec<u8>)| ProgramInfo {
                    name: name.clone(),
                    bytes: text.len() as u64,
                    comment: comment_of(text),
                    changed: 0,
                    locked: None,
                };
                programs.iter().map(info).collect()
            }
            library::Library::Kept(store) => {
                let found = store.reader().programs().map_err(|error| error.alarm())?;
                let info = |entry: ferrocut_memory::ProgramEntry| ProgramInfo {
                    name: entry.name,
                    bytes: entry.bytes,
                    comment: entry.comment,
                    changed: entry.changed,
                    locked: entry.locked.map(Level::number),
                };
                found.into_iter().map(info).collect()
            }
        };
        let most = match self.callable.library() {
            library::Library::Held(_) => None,
            library::Library::Kept(_) => u32::try_from(limits::PROGRAMS).ok(),
        };
        Ok(Reply::Programs { programs, most, room: self.callable.library().room() })
    }

    /// The name of a program that there is.
    fn known(&self, program: &str) -> Result<String, Box<Alarm>> {
        let found = self.callable.library().name_of(&library::id_of(program));
        found.ok_or_else(|| Box::new(named(Fault::NoSuchName, program)))
    }

    fn read(&self, program: &str) -> Answer {
        let found = self.callable.named(&library::id_of(program));
        let (program, text) = found.ok_or_else(|| named(Fault::NoSuchName, program))?;
        let text = match ferrocut_program::Text::from_bytes(text.clone()) {
            Ok(decoded) => decoded.encoding().decode(&text).into_owned(),
            Err(_) => String::from_utf8_lossy(&text).into_owned(),
        };
        Ok(Reply::Program { program, text })
    }

    /// Stores a program, in place of the one that has its number, however that is written: O1 is O0001. The one under way stays as
    /// it is (7.11 note 3); any other may be written meanwhile.
    fn store(&mut self, program: String, text: String, author: &Author) -> Answer {
        self.may_edit_programs(author)?;
        let name = program.trim().to_owned();
        if !is_program_name(&name) {
            return Err(Box::new(named(Fault::ValueImpossible, name)));
        }
        let name = self.callable.library().name_of(&library::id_of(&name)).unwrap_or(name);
        if self.is_in_use(&name) {
            return Err(Box::new(named(Fault::ProgramInUse, name)));
        }
        let text = text.into_bytes();
        let comment = comment_of(&text);
        if let library::Library::Held(programs) = self.callable.library() {
            programs.lock().unwrap_or_else(PoisonError::into_inner).insert(name.clone(), text.clone());
        }
        self.change_data(author, Change::Program { name, text, comment })
    }

    fn delete(&mut self, program: &str, author: &Author) -> Answer {
        self.may_edit_programs(author)?;
        let name = self.known(program)?;
        if self.is_in_use(&name) {
            return Err(Box::new(named(Fault::ProgramInUse, name)));
        }
        if let library::Library::Held(programs) = self.callable.library() {
            programs.lock().unwrap_or_else(PoisonError::into_inner).remove(&name);
        }
        self.change_data(author, Change::DeleteProgram { name })
    }

    /// A program gets another name, and the O number at its start with it.
    fn rename(&mut self, program: &str, to: &str, author: &Author) -> Answer {
        self.may_edit_programs(author)?;
        let name = self.known(program)?;
        let to = to.trim().to_owned();
        let taken = self
            .callable
            .library()
            .name_of(&library::id_of(&to))
            .is_some_and(|other| other != name || other == to);
        if !is_program_name(&to) || taken {
            return Err(Box::new(named(Fault::ValueImpossible, to)));
        }
        if self.is_in_use(&name) {
            return Err(Box::new(named(Fault::ProgramInUse, name)));
        }
        let text =
            self.callable.library().text(&name).ok_or_else(|| named(Fault::NoSuchName, name.as_str()))?;
        let text = library::renumbered(&text, &name, &to).unwrap_or(text);
        if let library::Library::Held(programs) = self.callable.library() {
            let mut programs = programs.lock().unwrap_or_else(PoisonError::into_inner);
            programs.remove(&name);
            programs.insert(to.clone(), text.clone());
        }
        self.change_data(author, Change::RenameProgram { name, to, text })
    }

    /// 7.4: the cursor is moved in EDIT, and then stays.
    fn put_cursor(&mut self, line: u32) -> Answer {
        if line == 0 {
            return Err(Box::new(named(Fault::ValueImpossible, "0")));
        }
        if self.cnc.is_under_way() {
            return Err(Box::new(alarm(Fault::ControlBusy)));
        }
        let (lines, cursor) = match self.mode {
            Mode::Mdi => (lines_of(self.mdi.as_bytes()), &mut self.mdi_cursor),
            Mode::Edit | Mode::Auto => {
                let text = self.selected.as_ref().and_then(|name| self.callable.library().text(name));
                (text.map_or(0, |text| lines_of(&text)), &mut self.cursor)
            }
            mode => return Err(Box::new(alarm(Fault::ControlMode).with("mode", name_of(mode)))),
        };
        if line as usize > lines {
            return Err(Box::new(alarm(Fault::NoSuchLine).with("line", f64::from(line))));
        }
        *cursor = line;
        Ok(Reply::Done)
    }

    fn type_mdi(&mut self, text: String, is_block: bool) -> Answer {
        if self.mode != Mode::Mdi {
            return Err(Box::new(alarm(Fault::ControlMode).with("mode", name_of(self.mode))));
        }
        if text.len() > LONGEST_MDI || is_block && text.trim_end().contains(['\n', '\r']) {
            return Err(Box::new(named(Fault::ValueImpossible, "MDI")));
        }
        if is_block {
            self.mdi_block = text;
        } else {
            self.mdi = text;
            self.mdi_cursor = 1;
        }
        self.tell_mdi();
        Ok(Reply::Done)
    }

    /// The text of MDI is cleared.
    pub(super) fn clear_mdi(&mut self) {
        if !self.mdi.is_empty() {
            self.mdi.clear();
            self.tell_mdi();
        }
    }

    /// The block before it is taken, to be run or to be forgotten.
    pub(super) fn take_mdi_block(&mut self) -> String {
        let block = std::mem::take(&mut self.mdi_block);
        if !block.is_empty() {
            self.tell_mdi();
        }
        block
    }

    fn tell_mdi(&mut self) {
        self.event(Event::Changed { item: MDI.to_owned() });
    }

    // Data.

    fn offsets(&self, from: u16, to: u16) -> Reply {
        let table = &self.cnc.interpreter().memory().tools;
        let values = |row: &ToolOffset| OffsetValues {
            length: Some(row.length),
            length_wear: Some(row.length_wear),
            radius: Some(row.radius),
            radius_wear: Some(row.radius_wear),
            cutting_length: Some(row.cutting_length),
            entry_angle: Some(row.entry_angle),
            tip_radius: Some(row.tip_radius),
        };
        let rows = (from..=to.min(table.last())).take(MOST_VALUES);
        let offsets = rows.filter_map(|number| Some((number, values(table.get(number)?)))).collect();
        Reply::Offsets { offsets }
    }

    fn set_offset(&mut self, number: u16, values: OffsetValues, add: bool, author: &Author) -> Answer {
        let row = self.offset_asked(number).filter(|_| number > 0);
        let mut offset = row.ok_or_else(|| named(Fault::NoSuchName, number.to_string()))?;
        for (slot, value, range) in [
            (&mut offset.length, values.length, ENTERED),
            (&mut offset.length_wear, values.length_wear, ENTERED),
            (&mut offset.radius, values.radius, ENTERED),
            (&mut offset.radius_wear, values.radius_wear, ENTERED),
            (&mut offset.cutting_length, values.cutting_length, 0.0..=MOST_ENTERED),
            (&mut offset.entry_angle, values.entry_angle, 0.0..=90.0),
            (&mut offset.tip_radius, values.tip_radius, 0.0..=MOST_ENTERED),
        ] {
            if let Some(value) = value {
                let value = if add { *slot + value } else { value };
                *slot = within(value, range)?;
            }
        }
        self.change_data(author, Change::Offset { number, offset })
    }

    fn zeros(&self) -> Reply {
        let work = &self.cnc.interpreter().memory().work;
        let additional = u16::try_from(work.additional.len()).unwrap_or(u16::MAX);
        let names = [WorkOffset::External]
            .into_iter()
            .chain((1..=6).map(WorkOffset::Standard))
            .chain((1..=additional).map(WorkOffset::Additional));
        let zeros = names.filter_map(|name| Some((name.to_string(), self.by_axis(work.get(name)?))));
        Reply::Zeros { zeros: zeros.collect() }
    }

    pub(super) fn set_zero(&mut self, system: &str, axes: &ByAxis, add: bool, author: &Author) -> Answer {
        // 7.2: not while a program runs.
        if self.cnc.is_under_way() && self.standing() != super::Standing::Stopped {
            return Err(Box::new(alarm(Fault::ControlBusy)));
        }
        // 29#4 IWZ: nor while it is stopped.
        if self.cnc.is_under_way() && self.bit(29, 4) && matches!(author, Author::Person { .. }) {
            return Err(Box::new(alarm(Fault::ControlBusy)));
        }
        let (name, mut zero) = self.zero_of(system)?;
        for (letter, value) in axes {
            let axis = self.axis_named(*letter)?;
            zero[axis] = within(if add { zero[axis] + value } else { *value }, PLACES)?;
        }
        self.change_data(author, Change::WorkZero { name, zero })
    }

    pub(super) fn zero_of(&self, system: &str) -> Result<(WorkOffset, Position), Box<Alarm>> {
        let missing = || named(Fault::NoSuchName, system);
        let name: WorkOffset = system.parse().map_err(|_| missing())?;
        Ok((name, self.zero_asked(name).ok_or_else(missing)?))
    }

    /// The axis at rest has this coordinate in the system, other shifts aside; or the value is `typed` as the page of the
    /// zeros takes it: X10 is the machine coordinate + 10 (3.4.2), with 10#5 it is taken off.
    fn zero_here(&mut self, system: &str, axes: &ByAxis, typed: bool, author: &Author) -> Answer {
        if self.tick.moving {
            return Err(Box::new(alarm(Fault::ControlBusy)));
        }
        let adds = typed && !self.bit(10, 5);
        let mut wanted = ByAxis::new();
        for (letter, value) in axes {
            let axis = self.axis_named(*letter)?;
            let value = if adds { *value } else { -value };
            wanted.insert(*letter, self.tick.position[axis] + value);
        }
        let wanted = self.without_external(system, wanted)?;
        self.set_zero(system, &wanted, false, author)
    }

    /// Machine positions of a zero, as the zero of a system that the external one is added to.
    pub(super) fn without_external(&self, system: &str, zeros: ByAxis) -> Result<ByAxis, Box<Alarm>> {
        let (name, _) = self.zero_of(system)?;
        let external = self.zero_asked(WorkOffset::External).unwrap_or_default();
        let external = if name == WorkOffset::External { Position::ZERO } else { external };
        let less = |(letter, at)| Ok((letter, at - external[self.axis_named(letter)?]));
        zeros.into_iter().map(less).collect()
    }

    fn variables(&self, from: u32, to: u32) -> Reply {
        let all = self.cnc.interpreter().memory().variables.iter();
        let within = all.filter(|(number, _)| (from..=to).contains(number));
        Reply::Variables { variables: within.take(MOST_VALUES).collect() }
    }

    fn parameters(&self, names: &[String]) -> Answer {
        let memory = self.cnc.interpreter().memory();
        let mut parameters = BTreeMap::new();
        if names.is_empty() {
            let table = memory.parameters.table();
            for (row, value) in memory.parameters.iter() {
                parameters.insert(table.name(&row.key), value);
            }
        }
        for name in names.iter().take(MOST_VALUES) {
            let key: ParameterKey = name.parse().map_err(|_| named(Fault::NoSuchName, name.as_str()))?;
            if memory.parameters.table().get(&key).is_none() {
                return Err(Box::new(named(Fault::NoSuchName, name.as_str())));
            }
            parameters.insert(name.clone(), memory.parameter(&key));
        }
        Ok(Reply::Parameters { parameters })
    }

    fn set_parameter(&mut self, name: &str, value: Option<f64>, author: &Author) -> Answer {
        let key: ParameterKey = name.parse().map_err(|_| named(Fault::NoSuchName, name))?;
        match self.is_setting(&key) {
            true => self.may_set_machine(author)?,
            false => self.may_set_parameters(author)?,
        }
        if let Some(value) = finite(value)? {
            let parameters = &self.cnc.interpreter().memory().parameters;
            parameters.check(&key, value).map_err(|error| error.alarm())?;
        }
        let mut changes = vec![Change::Parameter { key: key.clone(), value }];
        if key == PARTS_MACHINED {
            // The counter is what is kept of it.
            changes.push(Change::Counter { counter: Counter::Parts, value: value.unwrap_or_default() });
        }
        self.change_data_together(author, changes)
    }

    pub(super) fn axis_named(&self, letter: char) -> Result<Axis, Box<Alarm>> {
        let axis = u8::try_from(letter).ok().and_then(Axis::from_letter);
        let axis = axis.filter(|axis| self.machine.axis(*axis).is_some());
        axis.ok_or_else(|| Box::new(alarm(Fault::UnknownAxis).with("axis", letter.to_string())))
    }

    /// 4.1.5: where the axis stands becomes 0, half, or a value.
    fn set_relative(&mut self, letter: char, to: RelativeTo) -> Answer {
        let axis = self.axis_named(letter)?;
        let place = self.tick.position[axis] - self.cnc.handwheel_shift()[axis];
        let relative = match to {
            RelativeTo::Zero => 0.0,
            RelativeTo::Half => (place - self.origin[axis]) / 2.0,
            RelativeTo::Value(value) => within(value, PLACES)?,
        };
        self.origin[axis] = place - relative;
        Ok(Reply::Done)
    }

    /// 3.1.2: S from 0 to P258 is set at the cursor of the page, which the manual binds to no mode. A program under way
    /// has its own.
    fn set_spindle_speed(&mut self, speed: f64) -> Answer {
        let interpreter = self.cnc.interpreter();
        let highest = match interpreter.is_surface_speed() {
            true => HIGHEST_SURFACE_SPEED,
            false => interpreter.max_spindle_rpm(),
        };
        let speed = within(speed, 0.0..=highest)?;
        match self.cnc.set_spindle_speed(speed) {
            true => Ok(Reply::Done),
            false => Err(Box::new(alarm(Fault::ControlBusy))),
        }
    }

    // Rights and histories.

    fn kept(&self) -> Result<Arc<ferrocut_memory::Store>, Box<Alarm>> {
        let keeping = self.keeping.as_ref().ok_or_else(|| named(Fault::NotFitted, "memory"))?;
        Ok(keeping.store.clone())
    }

    fn log_in(&mut self, level: u8, password: &str, author: &Author) -> Answer {
        let level =
            Level::of(level.into()).ok_or_else(|| named(Fault::ValueImpossible, level.to_string()))?;
        let session = match level {
            Level::Operator => Session::OPERATOR,
            level => {
                let log_in = self.kept()?.log_in(level, password, Seat::Machine, author.name());
                log_in.map_err(|error| error.alarm())?
            }
        };
        Ok(self.admit(author.name(), session))
    }

    /// Gives somebody the rights of a session that the durable memory has given him, until he logs out. For whoever
    /// looks at passwords on another thread than the machine's: that takes longer than a period.
    pub fn admit(&mut self, name: &str, session: Session) -> Reply {
        let level = session.level().number();
        self.sessions.insert(name.to_owned(), session);
        self.event(Event::Level { level });
        Reply::Level { level }
    }

    /// The rights that somebody has logged in with.
    pub fn rights_of(&self, name: &str) -> Option<Session> {
        self.sessions.get(name).cloned()
    }

    fn set_password(&mut self, level: u8, password: &str, author: &Author) -> Answer {
        let level =
            Level::of(level.into()).ok_or_else(|| named(Fault::ValueImpossible, level.to_string()))?;
        let set = self.kept()?.set_password(author, level, password, Seat::Machine);
        set.map(|_| Reply::Done).map_err(|error| Box::new(error.alarm()))
    }

    fn alarm_history(&self, most: u32) -> Answer {
        let found = self.kept()?.reader().alarms(most.min(1000)).map_err(|error| error.alarm())?;
        let past = |entry: ferrocut_memory::AlarmEntry| PastAlarm {
            time: entry.time,
            id: entry.id,
            program: entry.program,
            line: entry.line,
            values: entry.arguments.into_iter().collect(),
        };
        Ok(Reply::AlarmHistory { alarms: found.into_iter().map(past).collect() })
    }

    fn operation_log(&self, most: u32) -> Answer {
        let found = self.kept()?.reader().log(most.min(10_000)).map_err(|error| error.alarm())?;
        let line = |entry: ferrocut_memory::LogEntry| LogLine {
            time: entry.time,
            level: entry.level.map(Level::number),
            who: entry.who,
            item: entry.item,
            name: entry.name,
            from: entry.from,
            to: entry.to,
        };
        Ok(Reply::OperationLog { entries: found.into_iter().map(line).collect() })
    }

    // Backups.

    fn items(names: &[String]) -> Result<Vec<Item>, Box<Alarm>> {
        let missing = |name: &String| Box::new(named(Fault::NoSuchName, name.as_str()));
        let item = |name: &String| Item::named(name).ok_or_else(|| missing(name));
        names.iter().map(item).collect()
    }

    fn back_up(&mut self, file: &str, items: &[String]) -> Answer {
        let items = Control::items(items)?;
        let items = if items.is_empty() { Item::ALL.to_vec() } else { items };
        if self.tick.moving || self.cnc.is_under_way() {
            return Err(Box::new(alarm(Fault::ControlBusy)));
        }
        self.flush()?;
        let store = self.kept()?;
        let written = store.reader().back_up(&backup_in(folder_of(&store)?, file)?, &items);
        written.map_err(|error| error.alarm())?;
        self.event(Event::Changed { item: BACKUPS.to_owned() });
        Ok(Reply::Done)
    }

    /// What was restored holds at once, save what the drives are made of.
    fn restore(&mut self, file: &str, items: &[String], author: &Author) -> Answer {
        let items = Control::items(items)?;
        if self.tick.moving || !self.cnc.is_idle() {
            return Err(Box::new(alarm(Fault::ControlBusy)));
        }
        // It would give places of axes that stand where they are the names of another moment, and be written over as soon
        // as one has moved.
        if items.contains(&Item::LastPosition) {
            return Err(Box::new(alarm(Fault::PositionInUse)));
        }
        self.flush()?;
        let store = self.kept()?;
        let path = backup_in(folder_of(&store)?, file)?;
        if !path.is_file() {
            return Err(Box::new(named(Fault::NoSuchName, file)));
        }
        let backup = Backup::open(&path).map_err(|error| error.alarm())?;
        let items = if items.is_empty() { backup.items() } else { items };
        if items.contains(&Item::Programs) {
            self.may_edit_programs(author)?;
        }
        backup.restore(&store, author, &items).map_err(|error| error.alarm())?;
        self.read_again(&items)?;
        for item in items {
            self.event(Event::Changed { item: item.name().to_owned() });
        }
        Ok(Reply::Done)
    }
}

/// The folder that backups lie in; none where nothing is kept.
fn folder_of(store: &ferrocut_memory::Store) -> Result<&Path, Box<Alarm>> {
    store.folder().ok_or_else(|| Box::new(named(Fault::NotFitted, "memory")))
}

/// The file of a backup: nothing that a front names may lie outside the folder, or be anything else in it.
///
/// # Errors
/// The name is that of no backup.
pub fn backup_in(folder: &Path, name: &str) -> Result<PathBuf, Box<Alarm>> {
    let is_plain = |c: char| c.is_alphanumeric() || matches!(c, '-' | '_' | '.' | ' ');
    let is_bare = name.len() <= limits::NAME && name.chars().all(is_plain) && !name.starts_with(['.', ' ']);
    match is_bare && name.ends_with(".backup") {
        true => Ok(folder.join(name)),
        false => Err(Box::new(named(Fault::ValueImpossible, name))),
    }
}

/// What an offset is at most, mm (GSK990MC part 2, 3.4.3.2): more is a decimal point that was forgotten.
const MOST_ENTERED: f64 = 9_999.999_9;
const ENTERED: RangeInclusive<f64> = -MOST_ENTERED..=MOST_ENTERED;

/// Where a zero may lie, and a relative coordinate: the range of positions, mm and degrees (GSK990MC part 1, 1.2).
const PLACES: RangeInclusive<f64> = -99_999.999_9..=99_999.999_9;

/// The last position of the switches that `docs/api.md` names; others are of a ladder's own.
const LAST_POSITIONS: [(&str, u8); 2] = [("SWITCH_FEED", 20), ("SWITCH_SPINDLE", 7)];

/// A number of a range; what is none is in no range.
fn within(value: f64, range: RangeInclusive<f64>) -> Result<f64, Box<Alarm>> {
    match range.contains(&value) {
        true => Ok(value),
        false => Err(Box::new(outside(value.to_string(), &range))),
    }
}

/// The highest S under G96, mm/min or inch/min.
const HIGHEST_SURFACE_SPEED: f64 = 99_999_999.0;

/// The alarm of a value outside its range, which it tells unless it is open.
pub(super) fn outside(value: String, range: &RangeInclusive<f64>) -> Alarm {
    let bounds = [("min", *range.start()), ("max", *range.end())].into_iter();
    let known = bounds.filter(|(_, bound)| bound.is_finite());
    known.fold(named(Fault::ValueImpossible, value), |alarm, (name, bound)| alarm.with(name, bound))
}

/// How many lines a text has; one behind a last line feed is the next.
fn lines_of(text: &[u8]) -> usize {
    text.iter().filter(|byte| **byte == b'\n').count() + 1
}

/// A number that is one.
fn finite(value: Option<f64>) -> Result<Option<f64>, Box<Alarm>> {
    match value {
        Some(value) if !value.is_finite() => Err(Box::new(named(Fault::ValueImpossible, value.to_string()))),
        value => Ok(value),
    }
}

/// The first remark of a program's first lines.
fn comment_of(text: &[u8]) -> String {
    let head = text.get(..text.len().min(4096)).unwrap_or(text);
    let head = String::from_utf8_lossy(head);
    let remark =
        head.split_once('(').and_then(|(_, rest)| rest.split_once(')')).map(|(remark, _)| remark.trim());
    remark.unwrap_or_default().chars().take(80).collect()
}
