//! A machine that a sender drives: blocks come one by one, in RS274/NGC, and run with look-ahead across them.
//!
//! Its axes know where they are (drives with absolute encoders, as the simulated ones): homing drives them to machine
//! zero, Z first. Where its file describes a simulated machine (`[plant]`), that has the inputs: probe, travel switches,
//! door and emergency stop.

use crate::grbl::checker::Checker;
use crate::grbl::{Doing, Event, Machine, Modal, Offsets, Overrides, Pins, Status};
use ferrocut_controller::drives::{Drives, Plant, Simulated};
use ferrocut_controller::{Cnc, Event as CncEvent, State, Tick};
use ferrocut_geometry::{Axis, Position};
use ferrocut_interpreter::{Interpreter, Options, dialects};
use ferrocut_machine::{Fault, Machine as MachineFile, Memory, WorkOffset};
use ferrocut_program::{ProgramMemory, Text};
use ferrocut_toolpath::SpindleState;
use std::collections::VecDeque;

/// Speed of homing, mm/min: each axis is held to its own.
const HOMING: f64 = 3000.0;

/// Events kept for whoever takes them; a sender has few blocks under way.
const MOST_EVENTS: usize = 1024;

/// What a machine is told. What waits for nothing and needs no answer.
#[derive(Clone, PartialEq, Debug)]
pub enum Command {
    /// [`Machine::append`]
    Append(String),
    /// [`Machine::hold`]
    Hold,
    /// [`Machine::start`]
    Start,
    /// [`Machine::reset`]
    Reset,
    /// [`Machine::jog`]
    Jog(Position, f64),
    /// [`Machine::cancel_jog`]
    CancelJog,
    /// [`Machine::home`]
    Home,
    /// [`Machine::set_overrides`]
    Overrides(Overrides),
    /// [`Machine::stop_spindle`]
    StopSpindle(bool),
}

/// Where homing is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Homing {
    /// Asked for.
    Asked,
    /// The tool goes up.
    Up,
    /// The others follow.
    Others,
}

/// The machine.
pub struct Mill {
    file: MachineFile,
    cnc: Cnc,
    tick: Tick,
    events: VecDeque<Event>,
    was: State,
    homing: Option<Homing>,
    is_homed: bool,
    pins: Pins,
    status: Status,
    checker: Option<Checker>,
}

impl Mill {
    /// A machine that was just switched on, its axes at `start`.
    pub fn new(file: &MachineFile, memory: Memory, options: Options) -> Mill {
        let dialect = &dialects::rs274::DIALECT;
        let programs = ProgramMemory::new("sent", Text::sent(), dialect.syntax);
        let options = Options { keep_going: true, ..options };
        let mut file = file.clone();
        file.homing.absolute = true;
        let drives: Box<dyn Drives> = match file.plant {
            Some(_) => {
                let reference = memory.reference_points.first().copied().unwrap_or_default();
                let mut plant = Plant::new(&file, options.start, reference);
                plant.stand_as_called(file.axis_set());
                Box::new(plant)
            }
            None => Box::new(Simulated),
        };
        let interpreter = Interpreter::new(dialect, programs, memory, options);
        let mut cnc = Cnc::with_drives(&file, interpreter, drives);
        cnc.refuse_blocks(true);
        let tick = cnc.tick();
        Mill {
            file,
            cnc,
            tick,
            events: VecDeque::new(),
            was: State::Ready,
            homing: None,
            is_homed: false,
            pins: Pins::default(),
            status: Status::default(),
            checker: None,
        }
    }

    /// A servo period.
    pub fn tick(&mut self) -> Tick {
        self.tick = self.cnc.tick();
        for alarm in self.cnc.refused() {
            self.note(Event::Refused(alarm.span.line, alarm.fault));
        }
        for event in self.cnc.events() {
            match event {
                CncEvent::Message(text) => self.note(Event::Message(text)),
                CncEvent::Warning(_) | CncEvent::ToolChange(_) => {}
            }
        }
        if *self.cnc.state() != self.was {
            self.was = self.cnc.state().clone();
            match &self.was {
                State::Alarmed(alarm) => {
                    let fault = alarm.fault;
                    self.homing = None;
                    self.note(Event::Alarm(fault));
                }
                State::Ended => self.note(Event::Ended),
                _ => {}
            }
        }
        self.go_home();
        self.look_at_pins();
        self.tick
    }

    /// Inputs as they stand now. A switch that a reset was behind lets its axis go until it is off it.
    fn look_at_pins(&mut self) {
        let Some(plant) = self.cnc.drives().plant() else { return };
        let switches = plant.switches();
        self.pins = Pins {
            probe: switches.skip,
            limits: Axis::ALL
                .into_iter()
                .filter(|axis| switches.above.contains(*axis) || switches.below.contains(*axis))
                .collect(),
            door: plant.door_is_open(),
            reset: plant.emergency_stop_is_pressed(),
        };
        if self.pins.limits.is_empty() {
            self.cnc.release_overtravel(false);
        }
    }

    /// What of the next period may take longer than one: interpreting and planning ahead.
    pub fn prepare(&mut self) {
        self.cnc.prepare();
    }

    fn note(&mut self, event: Event) {
        if self.events.len() < MOST_EVENTS {
            self.events.push_back(event);
        }
    }

    /// Whether something happened that is not taken yet.
    pub fn has_news(&self) -> bool {
        !self.events.is_empty()
    }

    /// The control.
    pub fn cnc(&self) -> &Cnc {
        &self.cnc
    }

    /// The drives, for what a person does at a simulated machine.
    pub fn drives(&mut self) -> &mut dyn Drives {
        self.cnc.drives()
    }

    /// Does a command.
    pub fn take(&mut self, command: Command) {
        match command {
            Command::Append(block) => {
                if self.cnc.append(format!("{block}\n").as_bytes()).is_ok()
                    && *self.cnc.state() == State::Ready
                {
                    // It may be at an end again before the next period is over.
                    self.was = State::Ready;
                    self.cnc.cycle_start();
                }
            }
            Command::Hold => self.cnc.feed_hold(),
            Command::Start => self.cnc.cycle_start(),
            Command::Reset => {
                self.homing = None;
                // The spindle stops too.
                self.cnc.emergency_stop();
                // As with Grbl, whose limits act when they are met: unlocked, the axis can leave its switch.
                self.cnc.release_overtravel(true);
            }
            Command::Jog(to, feed) => {
                // One beyond a limit was refused before it came here.
                let _ = self.cnc.jog_to(to, feed);
            }
            Command::CancelJog => {
                self.homing = None;
                self.cnc.cancel_jog();
            }
            Command::Home => self.homing = Some(Homing::Asked),
            Command::Overrides(Overrides { feed, rapid, spindle }) => {
                self.cnc.set_override(f64::from(feed) / 100.0, f64::from(rapid) / 100.0);
                self.cnc.set_spindle_override(f64::from(spindle) / 100.0);
            }
            Command::StopSpindle(stops) => self.cnc.stop_spindle(stops),
        }
    }

    fn home_axes(&mut self, which: impl Fn(Axis) -> bool) {
        let mut to = self.tick.position;
        for axis in &self.file.axes {
            if which(axis.name) {
                to[axis.name] = 0f64.clamp(axis.min, axis.max.max(axis.min));
            }
        }
        if self.cnc.jog_to(to, HOMING).is_err() {
            self.homing = None;
        }
    }

    fn go_home(&mut self) {
        let Some(homing) = self.homing else { return };
        if self.cnc.is_jogging() || !self.cnc.awaits_work() {
            return;
        }
        match homing {
            Homing::Asked => {
                self.homing = Some(Homing::Up);
                self.home_axes(|axis| axis == Axis::Z);
            }
            Homing::Up => {
                self.homing = Some(Homing::Others);
                self.home_axes(|_| true);
            }
            Homing::Others => {
                self.homing = None;
                self.is_homed = true;
            }
        }
    }

    fn doing(&self) -> Doing {
        match self.cnc.state() {
            _ if self.homing.is_some() => Doing::Home,
            State::Running if self.cnc.is_jogging() => Doing::Jog,
            State::Running if self.cnc.awaits_work() => Doing::Idle,
            State::Running => Doing::Run,
            State::Held if self.tick.moving => Doing::Holding,
            State::Held | State::BlockEnd | State::Stopped(_) => Doing::Held,
            State::Resetting => Doing::Resetting,
            State::Alarmed(_) => Doing::Alarm,
            State::Ready | State::Reset | State::Ended => Doing::Idle,
        }
    }

    /// How it is now.
    pub fn now(&self) -> Status {
        let interpreter = self.cnc.interpreter();
        let words = interpreter.words_in_force();
        let memory = interpreter.memory();
        let mut codes = Modal::default().codes;
        for tenths in interpreter.codes_in_force() {
            let place = match tenths {
                0 | 10 | 20 | 30 | 382..=385 | 800 => 0,
                540 | 550 | 560 | 570 | 580 | 590 => 1,
                170 | 180 | 190 => 2,
                200 | 210 => 3,
                900 | 910 => 4,
                930 | 940 => 5,
                _ => continue,
            };
            if let Some(code) = codes.get_mut(place) {
                *code = tenths;
            }
        }
        let mut offsets = Offsets { shift: words.shift, length: words.length[Axis::Z], ..Offsets::default() };
        for (number, place) in (1u8..).zip(&mut offsets.systems) {
            *place = memory.work.get(WorkOffset::Standard(number)).unwrap_or_default();
        }
        for (place, at) in offsets.references.iter_mut().zip(&memory.reference_points) {
            *place = *at;
        }
        let doing = self.doing();
        Status {
            is_current: true,
            doing,
            position: self.tick.position,
            feed: self.tick.velocity * 60.0,
            rpm: self.cnc.spindle().rpm(),
            line: if doing == Doing::Run || doing == Doing::Holding { self.tick.span.line } else { 0 },
            lines_done: self.cnc.lines_done(),
            room: self.cnc.room(),
            is_homed: self.is_homed,
            modal: Modal {
                codes,
                spindle: match words.spindle {
                    SpindleState::Off => 5,
                    SpindleState::Clockwise(_) => 3,
                    SpindleState::CounterClockwise(_) => 4,
                },
                flood: words.flood,
                mist: words.mist,
                feed: words.feed,
                speed: words.speed,
                zero: words.zero,
            },
            offsets,
            probe: words.probed.unwrap_or_default(),
            pins: self.pins,
        }
    }
}

impl Machine for Mill {
    fn status(&mut self) -> &Status {
        self.status = self.now();
        &self.status
    }

    fn event(&mut self) -> Option<Event> {
        self.events.pop_front()
    }

    fn append(&mut self, block: &str) {
        self.take(Command::Append(block.to_owned()));
    }

    fn check(&mut self, block: &str) -> Option<Fault> {
        let status = self.now();
        let checker = self.checker.get_or_insert_with(|| Checker::new(&self.file, &status));
        checker.check(block)
    }

    fn end_check(&mut self) {
        self.checker = None;
    }

    fn hold(&mut self) {
        self.take(Command::Hold);
    }

    fn start(&mut self) {
        self.take(Command::Start);
    }

    fn reset(&mut self) {
        self.take(Command::Reset);
    }

    fn jog(&mut self, to: Position, feed: f64) {
        self.take(Command::Jog(to, feed));
    }

    fn cancel_jog(&mut self) {
        self.take(Command::CancelJog);
    }

    fn home(&mut self) {
        self.take(Command::Home);
    }

    fn set_overrides(&mut self, overrides: Overrides) {
        self.take(Command::Overrides(overrides));
    }

    fn stop_spindle(&mut self, stops: bool) {
        self.take(Command::StopSpindle(stops));
    }
}
