//! Bytes in, answers out.

use super::codes::{AlarmCode, Error};
use super::jog;
use super::machine::{Doing, Event, Machine, Overrides, Pins, Status};
use super::realtime::{Realtime, realtime};
use super::report::{Reporter, Shown};
use super::settings::Settings;
use super::words::{self, LONGEST_LINE, Limits};
use ferrocut_geometry::{Axis, Position};
use ferrocut_machine::{Fault, Machine as MachineFile};
use std::collections::VecDeque;
use std::fmt::Write;

/// What is told first, and behind every reset.
pub const BANNER: &str = "\r\nGrbl 1.1h ['$' for help]\r\n";

/// Bytes of lines kept that were not run: far beyond the 128 that a sender counts, so that one that does not count
/// loses nothing at once.
const MOST_RECEIVED: usize = 1 << 14;

/// Bytes of one line as it comes, comments included.
const MOST_OF_LINE: usize = 1 << 10;

/// Bytes of answers kept for a reader that is slow; lines wait beyond it.
const MOST_ANSWERS: usize = 1 << 14;

/// Blocks given to the machine and not answered.
const MOST_GIVEN: usize = 64;

/// Moves that there is room for before a jog is given.
const ROOM_FOR_JOG: usize = 16;

/// Line numbers remembered for blocks that motion looks ahead to.
const MOST_NUMBERS: usize = 4096;

/// Codes in force behind a reset, and behind the end of a program (Grbl 1.1, M2 and M30). G1 needs a feed, which is
/// forgotten behind it.
const AFTER_RESET: &str = "G0G17G21G90G94G54G40G49G91.1M5M9";
const AFTER_END: &str = "G17G90G94G54G40M5M9F1G1";
const NO_FEED: &str = "G94";
const NO_SHIFT: &str = "G92.1";

/// Coordinate systems, G54 to G59.
const SYSTEMS: u8 = 6;

/// The parameters of X of G28 and G30; those of the other axes follow (LinuxCNC).
const REFERENCE_POINTS: [u32; 2] = [5161, 5181];

/// What locks programs.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Lock {
    Free,
    Alarm(AlarmCode),
    Check,
    Sleep,
    /// The safety door: until the axes stand, and from then on with the spindle stopped.
    Door {
        is_parked: bool,
    },
}

/// An answer that is to be given, in the order of the lines.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Owed {
    /// Known already.
    Answer(Result<(), Error>),
    /// Once this block is taken, or refused.
    Block { line: u32, refused: Option<Fault>, given: Given },
    /// Once the axes are homed.
    Home,
}

/// What is to be known of a block until it is answered.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
struct Given {
    /// No sender waits for it.
    is_own: bool,
    /// G38.2 to G38.5; true where no contact is an alarm.
    probes: Option<bool>,
    /// T.
    tool: Option<u32>,
    /// M2 or M30.
    ends: bool,
    /// G53.
    in_machine: bool,
}

/// A connection's side of the protocol. One is kept for a machine, whoever connects.
#[derive(Debug)]
pub struct Grbl {
    pub(super) settings: Settings,
    pub(super) reporter: Reporter,
    axes: Vec<Axis>,
    letters: Vec<u8>,
    travel: Vec<(Axis, f64, f64)>,
    max_rpm: f64,
    /// The line being received; what is beyond its room is dropped and the line refused.
    line: Vec<u8>,
    is_too_long: bool,
    was_return: bool,
    /// Whole lines; `None` is one that was too long.
    lines: VecDeque<Option<Vec<u8>>>,
    /// Bytes of them.
    received: usize,
    owed: VecDeque<Owed>,
    /// Blocks given to the machine, all in all.
    given: u32,
    /// N words of blocks given.
    numbers: VecDeque<(u32, u32)>,
    pub(super) lock: Lock,
    overrides: Overrides,
    pub(super) tool: u32,
    is_asked: bool,
    /// Where the last jog ends.
    jog_end: Option<Position>,
    /// The machine is being reset; codes in force come next.
    begins: bool,
    /// The shift of G92 is to be cleared too.
    ends_program: bool,
    spindle_is_stopped: bool,
    /// Start lines to be run.
    start_lines: VecDeque<String>,
    /// As they were at the last poll.
    pub(super) pins: Pins,
    pub(super) out: String,
}

impl Grbl {
    /// The protocol of a machine that was just switched on: locked until its axes are homed.
    pub fn new(file: &MachineFile) -> Grbl {
        let of = |axis: &Axis| file.axes.iter().any(|own| own.name == *axis);
        let mut axes = vec![Axis::X, Axis::Y, Axis::Z];
        axes.extend([Axis::A, Axis::B, Axis::C].iter().take_while(|axis| of(axis)));
        let reporter = Reporter::new(axes.clone());
        let letters = reporter.letters();
        Grbl {
            settings: Settings::new(file, &letters),
            reporter,
            travel: file.axes.iter().map(|axis| (axis.name, axis.min, axis.max)).collect(),
            axes,
            letters,
            max_rpm: file.spindle.max_rpm,
            line: Vec::new(),
            is_too_long: false,
            was_return: false,
            lines: VecDeque::new(),
            received: 0,
            owed: VecDeque::new(),
            given: 0,
            numbers: VecDeque::new(),
            lock: Lock::Alarm(AlarmCode::NotHomed),
            overrides: Overrides::default(),
            tool: 0,
            is_asked: false,
            jog_end: None,
            begins: true,
            ends_program: false,
            spindle_is_stopped: false,
            start_lines: VecDeque::new(),
            pins: Pins::default(),
            out: String::new(),
        }
    }

    /// A sender connects: it is told who is there. The machine stays as it is.
    pub fn connect(&mut self, machine: &mut dyn Machine) {
        self.leave();
        if self.lock == Lock::Alarm(AlarmCode::NotHomed) && machine.status().is_homed {
            self.lock = Lock::Free;
        }
        self.greet();
    }

    /// The sender went away: nothing goes on that nobody watches. A jog ends, a program is held.
    pub fn disconnect(&mut self, machine: &mut dyn Machine) {
        match machine.status().doing {
            Doing::Jog => machine.cancel_jog(),
            Doing::Run => machine.hold(),
            _ => {}
        }
        self.leave();
    }

    /// Nobody is there any more to be answered. What the machine has it still takes or refuses, and that counts.
    fn leave(&mut self) {
        let mut owed = std::mem::take(&mut self.owed);
        owed.retain_mut(|owed| match owed {
            Owed::Block { given, .. } => {
                given.is_own = true;
                true
            }
            Owed::Answer(_) | Owed::Home => false,
        });
        self.forget();
        self.owed = owed;
        self.out.clear();
    }

    /// Answers to be sent.
    pub fn take_output(&mut self) -> String {
        std::mem::take(&mut self.out)
    }

    /// Bytes that are kept for this connection.
    pub fn kept(&self) -> usize {
        self.line.len() + self.received + self.out.len()
    }

    fn greet(&mut self) {
        self.out.push_str(BANNER);
        if let Lock::Alarm(_) = self.lock {
            self.out.push_str("[MSG:'$H'|'$X' to unlock]\r\n");
        }
        self.reporter.start_again();
    }

    /// Forgets what was received and is not answered.
    fn forget(&mut self) {
        self.line.clear();
        self.lines.clear();
        self.owed.clear();
        self.start_lines.clear();
        (self.received, self.is_too_long, self.was_return, self.is_asked) = (0, false, false, false);
    }

    /// Takes bytes as they come. Real-time bytes act at once.
    pub fn receive(&mut self, bytes: &[u8], machine: &mut dyn Machine) {
        for byte in bytes {
            match realtime(*byte) {
                Some(what) => self.act(what, machine),
                None => self.take(*byte),
            }
        }
    }

    fn take(&mut self, byte: u8) {
        let is_feed_of_return = byte == b'\n' && std::mem::take(&mut self.was_return);
        if is_feed_of_return {
            return;
        }
        self.was_return = byte == b'\r';
        if matches!(byte, b'\n' | b'\r') {
            let line = std::mem::take(&mut self.line);
            let is_too_long = std::mem::take(&mut self.is_too_long);
            // An answer costs room too.
            if self.received + line.len() + 1 > MOST_RECEIVED {
                self.owe(Owed::Answer(Err(Error::LINE_TOO_LONG)));
                return;
            }
            self.received += line.len() + 1;
            self.lines.push_back((!is_too_long).then_some(line));
        } else if self.line.len() < MOST_OF_LINE {
            self.line.push(byte);
        } else {
            self.is_too_long = true;
        }
    }

    fn owe(&mut self, owed: Owed) {
        // A sender that sends more than this without reading an answer counts none of them.
        if self.owed.len() < MOST_RECEIVED {
            self.owed.push_back(owed);
        }
    }

    fn act(&mut self, what: Realtime, machine: &mut dyn Machine) {
        let doing = machine.status().doing;
        match what {
            Realtime::Status => self.is_asked = true,
            Realtime::Reset => self.reset(machine),
            Realtime::Hold if doing == Doing::Jog || self.jog_end.is_some() => self.cancel_jog(machine),
            // As Grbl: nothing but a reset breaks homing off.
            Realtime::Hold if self.lock == Lock::Free && doing != Doing::Home => machine.hold(),
            Realtime::Start => self.start(machine),
            Realtime::CancelJog if doing == Doing::Jog || self.jog_end.is_some() => self.cancel_jog(machine),
            Realtime::Door if doing == Doing::Home => {
                machine.reset();
                self.begins = true;
                self.alarm(AlarmCode::HomingDoor);
            }
            Realtime::Door if self.lock == Lock::Free => {
                match doing {
                    Doing::Jog => self.cancel_jog(machine),
                    _ => machine.hold(),
                }
                self.lock = Lock::Door { is_parked: false };
                self.out.push_str("[MSG:Check Door]\r\n");
            }
            Realtime::Feed(change) => {
                self.overrides.feed = change.of(self.overrides.feed);
                machine.set_overrides(self.overrides);
            }
            Realtime::Rapid(percent) => {
                self.overrides.rapid = percent;
                machine.set_overrides(self.overrides);
            }
            Realtime::Spindle(change) => {
                self.overrides.spindle = change.of(self.overrides.spindle);
                machine.set_overrides(self.overrides);
            }
            Realtime::SpindleStop if doing == Doing::Held && self.lock == Lock::Free => {
                self.spindle_is_stopped = !self.spindle_is_stopped;
                machine.stop_spindle(self.spindle_is_stopped);
            }
            Realtime::Flood => self.toggle_coolant(machine, b'8'),
            Realtime::Mist => self.toggle_coolant(machine, b'7'),
            _ => {}
        }
    }

    /// Coolant goes on or off behind the blocks that are taken.
    fn toggle_coolant(&mut self, machine: &mut dyn Machine, which: u8) {
        let status = machine.status();
        let is_free = matches!(status.doing, Doing::Idle | Doing::Run | Doing::Held);
        if self.lock != Lock::Free || !is_free || !status.is_current {
            return;
        }
        let (is_on, on, other_is_on, other) = match which {
            b'8' => (status.modal.flood, "M8", status.modal.mist, "M7"),
            _ => (status.modal.mist, "M7", status.modal.flood, "M8"),
        };
        if !is_on {
            return self.give_own(machine, on);
        }
        // There is no code for one of them alone.
        self.give_own(machine, "M9");
        if other_is_on {
            self.give_own(machine, other);
        }
    }

    fn start(&mut self, machine: &mut dyn Machine) {
        let doing = machine.status().doing;
        match self.lock {
            Lock::Door { is_parked } if doing != Doing::Holding && !self.pins.door => {
                self.lock = Lock::Free;
                if is_parked {
                    machine.stop_spindle(false);
                }
                machine.start();
            }
            Lock::Free if matches!(doing, Doing::Held | Doing::Holding) => {
                if std::mem::take(&mut self.spindle_is_stopped) {
                    machine.stop_spindle(false);
                }
                machine.start();
            }
            _ => {}
        }
    }

    /// Jogs that came and were not run are answered and forgotten: the key that asked for them is released.
    fn cancel_jog(&mut self, machine: &mut dyn Machine) {
        machine.cancel_jog();
        self.jog_end = None;
        let is_jog =
            |line: &Option<Vec<u8>>| line.as_ref().is_some_and(|line| words::strip(line).starts_with(b"$J="));
        while self.lines.front().is_some_and(is_jog) {
            if let Some(Some(line)) = self.lines.pop_front() {
                self.received = self.received.saturating_sub(line.len() + 1);
            }
            self.owe(Owed::Answer(Ok(())));
        }
    }

    /// 0x18: as if switched on, but for where the axes are and what is kept.
    pub(super) fn reset(&mut self, machine: &mut dyn Machine) {
        let status = machine.status();
        let moves = match status.doing {
            Doing::Run | Doing::Holding | Doing::Jog | Doing::Resetting => Some(AlarmCode::Abort),
            Doing::Home => Some(AlarmCode::HomingReset),
            Doing::Idle | Doing::Held | Doing::Alarm => None,
        };
        machine.reset();
        self.forget();
        self.numbers.clear();
        (self.jog_end, self.begins, self.ends_program) = (None, true, false);
        self.spindle_is_stopped = false;
        self.overrides = Overrides::default();
        machine.set_overrides(self.overrides);
        machine.end_check();
        // A sender that reads nothing of so much hears nothing of one more.
        let is_heard = self.out.len() < MOST_ANSWERS;
        self.lock = match (self.lock, moves) {
            (Lock::Alarm(_) | Lock::Sleep, None) => match self.lock {
                Lock::Alarm(AlarmCode::NotHomed) => self.lock,
                // What made it critical is acknowledged.
                _ => Lock::Alarm(AlarmCode::Abort),
            },
            (Lock::Check, _) | (_, None) => Lock::Free,
            (_, Some(code)) => {
                if is_heard {
                    let _ = write!(self.out, "ALARM:{}\r\n", code as u8);
                }
                Lock::Alarm(code)
            }
        };
        if is_heard {
            self.greet();
        }
    }

    /// Locks programs until someone unlocks them.
    fn alarm(&mut self, code: AlarmCode) {
        let probes = |owed: &&Owed| matches!(owed, Owed::Block { given: Given { probes: Some(_), .. }, .. });
        if code.is_of_probe() {
            // The lines before it are done.
            while let Some(owed) = self.owed.front().filter(|owed| !probes(owed)).copied() {
                self.owed.pop_front();
                self.settle(owed);
            }
        }
        let _ = write!(self.out, "ALARM:{}\r\n", code as u8);
        if code.is_critical() {
            self.out.push_str("[MSG:Reset to continue]\r\n");
        }
        self.lock = Lock::Alarm(code);
        (self.jog_end, self.ends_program) = (None, false);
        if code.is_of_probe() {
            // Its line is answered like any other, and those behind it by the lock.
            if let Some(Owed::Block { refused, .. }) = self.owed.front_mut().filter(|owed| probes(&&**owed)) {
                *refused = None;
            }
            while let Some(owed) = self.owed.pop_front() {
                self.settle(owed);
            }
            return;
        }
        self.lines.clear();
        self.owed.clear();
        self.received = 0;
    }

    /// Answers what is done.
    fn settle(&mut self, owed: Owed) {
        match owed {
            Owed::Answer(answer) => self.answered(answer),
            Owed::Block { refused, given, .. } => {
                if refused.is_none() {
                    self.tool = given.tool.unwrap_or(self.tool);
                }
                if !given.is_own {
                    let error = |fault| Error::of_block(fault, given.in_machine);
                    self.answered(refused.map_or(Ok(()), |fault| Err(error(fault))));
                }
            }
            Owed::Home => self.answered(Ok(())),
        }
    }

    fn answered(&mut self, answer: Result<(), Error>) {
        match answer {
            Ok(()) => self.out.push_str("ok\r\n"),
            Err(Error(number)) => drop(write!(self.out, "error:{number}\r\n")),
        }
    }

    /// `$X`: programs are taken again.
    pub(super) fn unlock(&mut self, machine: &mut dyn Machine) {
        if machine.status().doing == Doing::Alarm {
            machine.reset();
            self.begins = true;
        }
        self.lock = Lock::Free;
    }

    /// `$H` is asked for: the axes are sent home, and the line is answered when they are there.
    pub(super) fn home(&mut self, machine: &mut dyn Machine) {
        machine.home();
        self.owe(Owed::Home);
    }

    /// Does what can be done by now. To be called every few milliseconds.
    pub fn poll(&mut self, machine: &mut dyn Machine) {
        let status = machine.status().clone();
        while let Some(event) = machine.event() {
            self.happened(event, machine);
        }
        let before = std::mem::replace(&mut self.pins, status.pins);
        // As long as it is open: it may have been so before a lock was given up.
        if self.pins.door && (self.lock == Lock::Free || status.doing == Doing::Home) {
            self.act(Realtime::Door, machine);
        }
        if self.pins.reset && !before.reset {
            self.act(Realtime::Reset, machine);
        }
        if let Lock::Door { is_parked: false } = self.lock
            && status.is_current
            && matches!(status.doing, Doing::Held | Doing::Idle)
        {
            machine.stop_spindle(true);
            self.lock = Lock::Door { is_parked: true };
        }
        if status.is_current && status.doing == Doing::Idle {
            self.jog_end = None;
            self.begin(machine, &status);
        }
        self.answer(&status);
        self.run_lines(machine);
        if std::mem::take(&mut self.is_asked) && self.out.len() < MOST_ANSWERS {
            self.report(&status);
        }
    }

    /// The codes in force behind a reset.
    fn begin(&mut self, machine: &mut dyn Machine, status: &Status) {
        if !std::mem::take(&mut self.begins) {
            return;
        }
        // What the machine has read is all that counts from here on.
        self.given = status.lines_done;
        self.give_own(machine, AFTER_RESET);
        self.give_own(machine, NO_SHIFT);
        self.start_with_lines();
    }

    /// `$N0` and `$N1` come next.
    pub(super) fn start_with_lines(&mut self) {
        if self.lock == Lock::Free {
            self.start_lines =
                self.settings.start_lines.iter().filter(|line| !line.is_empty()).cloned().collect();
        }
    }

    fn happened(&mut self, event: Event, machine: &mut dyn Machine) {
        match event {
            Event::Refused(line, fault) => {
                let of_line =
                    |owed: &&mut Owed| matches!(owed, Owed::Block { line: own, .. } if *own == line);
                if let Some(Owed::Block { refused, .. }) = self.owed.iter_mut().find(of_line) {
                    // The first thing that was found counts.
                    *refused = refused.or(Some(fault));
                }
            }
            Event::Alarm(fault) => self.alarm(AlarmCode::of(fault)),
            Event::Ended => {
                self.out.push_str("[MSG:Pgm End]\r\n");
                self.overrides = Overrides::default();
                machine.set_overrides(self.overrides);
                self.give_own(machine, AFTER_END);
                self.give_own(machine, NO_FEED);
                self.ends_program = false;
            }
            Event::Message(text) => {
                let text: String = text.chars().filter(|c| !c.is_control()).take(LONGEST_LINE).collect();
                let _ = write!(self.out, "[MSG:{text}]\r\n");
            }
        }
    }

    /// G54 to G59, G28 and G30 are machine zero (`$RST=#`).
    pub(super) fn clear_offsets(&mut self, machine: &mut dyn Machine) {
        let axes: String = self.letters.iter().map(|letter| format!("{}0", char::from(*letter))).collect();
        for system in 1..=SYSTEMS {
            self.give_own(machine, &format!("G10L2P{system}{axes}R0"));
        }
        for first in REFERENCE_POINTS {
            let numbers = (first..).take(Axis::ALL.len());
            let block: String = numbers.map(|number| format!("#{number}=0")).collect();
            self.give_own(machine, &block);
        }
    }

    /// Gives a block that no sender waits for.
    fn give_own(&mut self, machine: &mut dyn Machine, block: &str) {
        self.give(machine, block, Given { is_own: true, ..Given::default() });
    }

    fn give(&mut self, machine: &mut dyn Machine, block: &str, given: Given) {
        machine.append(block);
        self.given = self.given.saturating_add(1);
        self.owe(Owed::Block { line: self.given, refused: None, given });
    }

    /// Answers what is done, in the order of the lines.
    fn answer(&mut self, status: &Status) {
        while let Some(owed) = self.owed.front().copied() {
            match owed {
                Owed::Answer(_) => {}
                Owed::Block { line, refused, given } => {
                    if !status.is_current || status.lines_done < line {
                        return;
                    }
                    if let Some(fault @ Fault::SkipWithoutSignal) = refused {
                        return self.alarm(AlarmCode::of(fault));
                    }
                    // A refused one does nothing.
                    self.ends_program &= !(refused.is_some() && given.ends);
                    if let (Some(needs_contact), None) = (given.probes, refused) {
                        self.reporter.probe(&mut self.out, status, &self.settings);
                        if needs_contact && !status.probe.1 {
                            return self.alarm(AlarmCode::ProbeMissed);
                        }
                    }
                }
                Owed::Home => {
                    if !status.is_current || matches!(status.doing, Doing::Home | Doing::Resetting) {
                        return;
                    }
                    if !status.is_homed {
                        return self.alarm(AlarmCode::HomingFailed);
                    }
                    self.lock = Lock::Free;
                    self.start_with_lines();
                }
            }
            self.owed.pop_front();
            self.settle(owed);
        }
    }

    /// Runs the lines that came, as far as they need not wait for those before.
    fn run_lines(&mut self, machine: &mut dyn Machine) {
        while self.out.len() < MOST_ANSWERS && !self.begins && !self.ends_program {
            let waits = self.owed.iter().filter(|owed| matches!(owed, Owed::Block { .. })).count();
            // Behind a probe that meets nothing no block is run.
            let is_probing =
                |owed: &Owed| matches!(owed, Owed::Block { given: Given { probes: Some(_), .. }, .. });
            if waits >= MOST_GIVEN || self.owed.contains(&Owed::Home) || self.owed.iter().any(is_probing) {
                return;
            }
            if let Some(line) = self.start_lines.pop_front() {
                let done = self.block(line.as_bytes(), machine, true);
                let _ = match done {
                    Ok(()) => write!(self.out, ">{line}:ok\r\n"),
                    Err(Error(number)) => write!(self.out, ">{line}:error:{number}\r\n"),
                };
                continue;
            }
            let Some(line) = self.lines.front() else { return };
            let stripped =
                line.as_ref().map(|line| words::strip(line)).filter(|line| line.len() <= LONGEST_LINE);
            // A command wants to see the machine as it is behind the lines before.
            let is_command = stripped.as_ref().is_some_and(|line| line.starts_with(b"$"));
            if is_command && (!self.owed.is_empty() || !machine.status().is_current) {
                return;
            }
            // A jog wants room for its move.
            let is_jog = stripped.as_ref().is_some_and(|line| line.starts_with(b"$J"));
            if is_jog && machine.status().room < ROOM_FOR_JOG {
                return;
            }
            let taken = self.lines.pop_front().flatten().map_or(0, |line| line.len());
            self.received = self.received.saturating_sub(taken + 1);
            let Some(line) = stripped else {
                self.owe(Owed::Answer(Err(Error::LINE_TOO_LONG)));
                continue;
            };
            let done = match line.as_slice() {
                // A mark of a file that a sender passes on means nothing.
                [] | [b'%'] => Ok(()),
                [b'$', command @ ..] => match self.command(command, machine) {
                    Some(done) => done,
                    // Answered later.
                    None => continue,
                },
                line => match self.block(line, machine, false) {
                    Ok(()) if self.lock != Lock::Check => continue,
                    done => done,
                },
            };
            // What is done already is told at once, so that a command's own text stands before its answer.
            if self.owed.is_empty() {
                self.answered(done);
            } else {
                self.owe(Owed::Answer(done));
            }
        }
    }

    fn limits(&self) -> Limits<'_> {
        Limits { axes: &self.letters, max_rpm: self.max_rpm }
    }

    /// Whether Grbl would take a block at all.
    pub(super) fn checks(&self, line: &[u8]) -> Result<words::Block, Error> {
        words::block(line, &self.limits())
    }

    /// A block of a program.
    fn block(&mut self, line: &[u8], machine: &mut dyn Machine, is_own: bool) -> Result<(), Error> {
        let is_jogging = machine.status().doing == Doing::Jog || self.jog_end.is_some();
        if matches!(self.lock, Lock::Alarm(_) | Lock::Sleep) || is_jogging {
            return Err(Error::LOCKED);
        }
        let block = self.checks(line)?;
        if self.lock == Lock::Check {
            return match machine.check(&block.text) {
                Some(ferrocut_machine::Fault::SoftLimit) => {
                    self.alarm(AlarmCode::SoftLimit);
                    Ok(())
                }
                Some(fault) => Err(Error::of_block(fault, block.in_machine)),
                None => {
                    self.tool = block.tool.unwrap_or(self.tool);
                    Ok(())
                }
            };
        }
        let given = Given {
            is_own,
            probes: block.probes,
            tool: block.tool,
            ends: block.ends,
            in_machine: block.in_machine,
        };
        if block.text.is_empty() {
            self.tool = block.tool.unwrap_or(self.tool);
            if !is_own {
                self.owe(Owed::Answer(Ok(())));
            }
            return Ok(());
        }
        self.give(machine, &block.text, given);
        self.ends_program = block.ends;
        if let Some(number) = block.number {
            if self.numbers.len() >= MOST_NUMBERS {
                self.numbers.pop_front();
            }
            self.numbers.push_back((self.given, number));
        }
        Ok(())
    }

    /// `$J=`
    pub(super) fn jog(&mut self, line: &[u8], machine: &mut dyn Machine) -> Result<(), Error> {
        let status = machine.status();
        if self.lock != Lock::Free || !matches!(status.doing, Doing::Idle | Doing::Jog) {
            return Err(Error::NOT_IDLE);
        }
        let from = self.jog_end.unwrap_or(status.position);
        let jog = jog::read(line, &self.axes, &status.modal, from)?;
        let is_beyond = |(axis, min, max): &(Axis, f64, f64)| !(*min..=*max).contains(&jog.to[*axis]);
        if self.travel.iter().any(is_beyond) || !jog.to.is_finite() {
            return Err(Error::TRAVEL);
        }
        machine.jog(jog.to, jog.feed);
        self.jog_end = Some(jog.to);
        Ok(())
    }

    /// The name of the state in reports.
    fn state(&self, status: &Status) -> &'static str {
        let doing = if status.is_current { status.doing } else { Doing::Run.max_of(status.doing) };
        match (self.lock, doing) {
            (Lock::Alarm(_), Doing::Home) => "Home",
            (Lock::Alarm(_), _) | (_, Doing::Alarm) => "Alarm",
            (Lock::Sleep, _) => "Sleep",
            (Lock::Check, _) => "Check",
            (Lock::Door { .. }, Doing::Holding | Doing::Jog | Doing::Run) => "Door:2",
            (Lock::Door { .. }, _) if status.pins.door => "Door:1",
            (Lock::Door { .. }, _) => "Door:0",
            (Lock::Free, doing) => match doing {
                Doing::Idle => "Idle",
                Doing::Run | Doing::Resetting => "Run",
                Doing::Holding => "Hold:1",
                Doing::Held => "Hold:0",
                Doing::Jog => "Jog",
                Doing::Home => "Home",
                Doing::Alarm => "Alarm",
            },
        }
    }

    fn report(&mut self, status: &Status) {
        while self.numbers.get(1).is_some_and(|(line, _)| *line <= status.line) {
            self.numbers.pop_front();
        }
        let number = self.numbers.front().filter(|(line, _)| *line == status.line).map(|(_, number)| *number);
        let shown = Shown {
            state: self.state(status),
            received: self.received + self.line.len(),
            number,
            overrides: self.overrides,
        };
        let mut out = std::mem::take(&mut self.out);
        self.reporter.status(&mut out, status, &shown, &self.settings);
        self.out = out;
    }
}

impl Doing {
    /// What a machine does that has commands before it: an idle one is about to run.
    fn max_of(self, now: Doing) -> Doing {
        if now == Doing::Idle { self } else { now }
    }
}
