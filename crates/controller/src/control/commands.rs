//! What a front says, and what comes of it. Data go through the durable memory, which judges rights.

mod backups;
mod data;
mod histories;
mod stored;

pub use backups::backup_in;

use super::exchange::check_ladder;
use super::taking_up::Wanted;
use super::{Control, alarm, capture, name_of, trace};
use crate::api::{API_VERSION, Command, Event, Refusal, Reply};
use crate::diagnosis::{self, named_in, table};
use crate::restart::How;
use crate::signals::Mode;
use ferrocut_machine::setup::VariableName;
use ferrocut_machine::{Alarm, Fault};
use ferrocut_memory::{Author, Change, Counter, Level};
use ferrocut_plc::{Address, Area};
use std::collections::BTreeMap;
use std::ops::RangeInclusive;

/// Most numbers that one answer holds.
const MOST_VALUES: usize = 10_000;

/// How long the flow of the ladder is recorded after it was asked for, µs.
const FLOW_ASKED_US: u32 = 1_000_000;

/// What the event `changed` calls the backups in the folder of the memory.
pub const BACKUPS: &str = "backups";

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
            Command::DeleteAll => self.delete_all(author),
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
                // 3.3.3.2: what stands for something else is set by programs alone.
                if !self.cnc.interpreter().is_entered_by_hand(number) {
                    return Err(Box::new(named(Fault::NoSuchName, format!("#{number}"))));
                }
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

    pub(super) fn change_data_together(&mut self, author: &Author, changes: Vec<Change>) -> Answer {
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
}

/// The last position of the switches that `docs/api.md` names; others are of a ladder's own.
const LAST_POSITIONS: [(&str, u8); 2] = [("SWITCH_FEED", 20), ("SWITCH_SPINDLE", 7)];

/// A number of a range; what is none is in no range.
fn within(value: f64, range: RangeInclusive<f64>) -> Result<f64, Box<Alarm>> {
    match range.contains(&value) {
        true => Ok(value),
        false => Err(Box::new(outside(value.to_string(), &range))),
    }
}

/// The alarm of a value outside its range, which it tells unless it is open.
pub(super) fn outside(value: String, range: &RangeInclusive<f64>) -> Alarm {
    let bounds = [("min", *range.start()), ("max", *range.end())].into_iter();
    let known = bounds.filter(|(_, bound)| bound.is_finite());
    known.fold(named(Fault::ValueImpossible, value), |alarm, (name, bound)| alarm.with(name, bound))
}

/// A number that is one.
fn finite(value: Option<f64>) -> Result<Option<f64>, Box<Alarm>> {
    match value {
        Some(value) if !value.is_finite() => Err(Box::new(named(Fault::ValueImpossible, value.to_string()))),
        value => Ok(value),
    }
}
