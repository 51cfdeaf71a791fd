//! Step and direction, made by a board: the control tells it a setpoint for every axis each servo period, it makes the
//! pulses (`docs/pulse-protocol.md`).
//!
//! The board runs setpoints at its own even pace, some periods after they were told, so that a late period of the control
//! is none of the axes. What is lost, unreadable or later than that stops them. Positions are absolute: nothing that
//! happens on the way can shift an axis.
//!
//! [`Drives::exchange`] takes what came, and sends the setpoint. It neither waits nor allocates nor takes a lock, from
//! the first look for the board on: a board that was lost is found again by the same calls.

mod fault;
mod frames;
mod link;

pub use link::{Link, Port};

use super::wires::AxisWires;
use super::{Contact, Drives, Switches};
use crate::signals::ESP_BUTTON;
use fault::PulseFault;
use ferrocut_geometry::{Axis, AxisSet, Position};
use ferrocut_machine::{Alarm, AxisConfig, LinkAt, Machine, PulseAxis, PulseConfig};
use ferrocut_program::Span;
use frames::{
    AxisSetup, EDGE_SEEN, Frame, HOME_CLOSED, Heard, LONGEST_CODED, LOWER_CLOSED, PARTS, Reader, Ready,
    Setpoint, Setup, State, UPPER_CLOSED, Welcome,
};
use std::collections::BTreeMap;
use std::io::ErrorKind;
use std::time::{Duration, SystemTime, UNIX_EPOCH};

/// Time within which a board answers, ms.
const PATIENCE_MS: f64 = 2000.0;
/// Time between two questions, ms.
const AGAIN_MS: f64 = 20.0;
/// Bytes that may wait to be sent: more and the line is blocked.
const UNSENT: usize = 16 * LONGEST_CODED;
/// Bytes taken in a period at most.
const MOST_TAKEN: usize = 64 * 1024;
/// Share above the highest speed that compensation may take.
const SPARE: f64 = 1.02;
/// Share of a serial line that is used.
const LINE_SHARE: f64 = 0.9;

/// How far the conversation has come.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Phase {
    /// The board is looked for.
    Greets,
    /// It is told what it has to do.
    SetsUp,
    /// It follows setpoints.
    Runs,
    /// It does not.
    Failed,
}

/// An axis of the board.
#[derive(Clone, Debug)]
struct Stepped {
    axis: Axis,
    /// Parts of a step in a mm or degree.
    scale: f64,
    /// Highest rate that it is driven at, steps/s.
    rate: f64,
    limits: bool,
    /// Where it is called 0, in parts of a step.
    zero: i64,
    /// What it was told last.
    told: i64,
    /// The marker that is waited for.
    marker: u8,
}

impl Stepped {
    fn new(config: &PulseAxis, axis: &AxisConfig) -> Stepped {
        Stepped {
            axis: config.name,
            scale: config.steps * PARTS,
            rate: highest_rate(config, axis),
            limits: config.limits,
            zero: 0,
            told: 0,
            marker: 0,
        }
    }

    /// A place by its name, in parts of a step from where the board counts.
    fn parts(&self, at: f64) -> i64 {
        (at * self.scale).round() as i64
    }

    /// The name of a place that the board counts, which is near where the axis was told to be.
    fn called(&self, counted: i32) -> f64 {
        // The board counts in a circle of 2³².
        let beside = i64::from(counted.wrapping_sub(self.told as i32));
        (self.told.wrapping_add(beside).wrapping_sub(self.zero)) as f64 / self.scale
    }
}

/// Highest rate of an axis, steps/s: its speed, and what compensation adds.
fn highest_rate(config: &PulseAxis, axis: &AxisConfig) -> f64 {
    let backlash = &axis.backlash;
    let play = backlash.cutting.abs().max(backlash.rapid.unwrap_or(0.0).abs());
    let taking_up = match backlash.rate > 0.0 {
        _ if play == 0.0 => 0.0,
        true => backlash.rate / 60.0,
        // An S in three equal parts (docs/drives.md).
        false => 2.25 * play / (backlash.time_ms / 1000.0).max(1e-3),
    };
    (axis.top_speed() * SPARE + taking_up) * config.steps
}

/// Drives behind a board that makes step and direction.
pub struct Pulse {
    link: Box<dyn Link>,
    at: LinkAt,
    reader: Reader,
    unsent: Vec<u8>,
    phase: Phase,
    /// Periods in this phase, and since the board was heard.
    periods: u64,
    silence: u64,
    period_ms: f64,
    watchdog_ms: f64,
    axes: Vec<Stepped>,
    config: PulseConfig,
    setup: Setup,
    setpoint: Setpoint,
    state: Option<State>,
    fault: Option<PulseFault>,
    wires: AxisWires,
    /// Highest speed of the spindle, r/min.
    most_rpm: f64,
    actual: Position,
    commanded: Position,
    /// The amplifiers are to be on.
    enable: bool,
}

impl Pulse {
    /// Drives at the other end of a link, whose board is looked for from the first [`Drives::exchange`] on.
    pub fn new(machine: &Machine, config: &PulseConfig, link: Box<dyn Link>, at: Position) -> Pulse {
        let period_ms = machine.servo_period_ms;
        let named = config.axes.iter().filter_map(|axis| Some((axis, machine.axis(axis.name)?)));
        let axes: Vec<Stepped> = named.clone().map(|(pulse, axis)| Stepped::new(pulse, axis)).collect();
        let mut setup = Setup {
            period_ns: (period_ms * 1e6).round() as u32,
            buffer: config.buffer,
            watchdog_ms: config.watchdog_ms.ceil() as u16,
            axes: axes.len(),
            ..Setup::default()
        };
        for ((of, stepped), (pulse, axis)) in setup.of.iter_mut().zip(&axes).zip(named) {
            *of = AxisSetup {
                times: [pulse.pulse_ns, pulse.space_ns, pulse.setup_ns, pulse.hold_ns],
                rate: stepped.rate.ceil() as u32,
                stop: (axis.acceleration * pulse.steps).ceil().max(1.0) as u32,
                reversed: pulse.reversed,
            };
        }
        let since = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or(Duration::ZERO);
        // Another one than that of whoever spoke with the board before.
        setup.session = (since.subsec_nanos() ^ since.as_secs() as u32) as u16;
        Pulse {
            link,
            at: config.link.clone(),
            reader: Reader::new(),
            unsent: Vec::with_capacity(UNSENT),
            phase: Phase::Greets,
            periods: 0,
            silence: 0,
            period_ms,
            watchdog_ms: config.watchdog_ms,
            setpoint: Setpoint { axes: axes.len(), ..Setpoint::default() },
            axes,
            config: config.clone(),
            setup,
            state: None,
            fault: None,
            wires: AxisWires::new(machine, &BTreeMap::new(), config.probe_opens.unwrap_or(false)),
            most_rpm: machine.spindle.max_rpm,
            actual: at,
            commanded: at,
            enable: true,
        }
    }

    /// Opens the link that the machine file names, and waits until the board is set up. What stops it from then on, as the
    /// emergency stop that is pressed while power comes, is an alarm that reset ends, and no reason not to begin.
    ///
    /// # Errors
    /// Why it is not.
    pub fn connect(machine: &Machine, config: &PulseConfig, at: Position) -> Result<Pulse, Box<Alarm>> {
        let port = Port::open(&config.link)
            .map_err(|error| PulseFault::Cut(error.kind()).alarm(&config.link, Span::default()))?;
        let mut drives = Pulse::new(machine, config, Box::new(port), at);
        loop {
            drives.exchange(&at);
            // Only a board that is set up says how it stands.
            if drives.is_ready() || drives.state.is_some() {
                return Ok(drives);
            }
            if let Some(alarm) = drives.failure(Span::default()) {
                return Err(alarm);
            }
            std::thread::sleep(Duration::from_secs_f64(drives.period_ms / 1000.0));
        }
    }

    /// Whether the board follows setpoints.
    pub fn is_ready(&self) -> bool {
        self.phase == Phase::Runs
    }

    fn enter(&mut self, phase: Phase) {
        (self.phase, self.periods, self.silence) = (phase, 0, 0);
    }

    fn fail(&mut self, fault: PulseFault) {
        if self.phase != Phase::Failed {
            self.fault = Some(fault);
            self.enter(Phase::Failed);
        }
    }

    /// Takes what came since the last period.
    fn listen(&mut self) {
        let mut bytes = [0; 2048];
        for _ in 0..MOST_TAKEN / bytes.len() {
            match self.link.receive(&mut bytes) {
                Ok(count) => {
                    for byte in bytes.iter().take(count) {
                        if let Some(heard) = self.reader.take(*byte) {
                            self.hear(&heard);
                        }
                    }
                }
                Err(error) if is_later(error.kind()) => return,
                Err(error) => return self.fail(PulseFault::Cut(error.kind())),
            }
        }
    }

    fn hear(&mut self, heard: &Heard) {
        let session = self.setup.session;
        match heard {
            Heard::Welcome(welcome) if self.phase == Phase::Greets && welcome.session == session => {
                match self.suits(welcome) {
                    Ok(()) => self.enter(Phase::SetsUp),
                    Err(fault) => self.fail(fault),
                }
            }
            Heard::Ready(ready) if self.phase == Phase::SetsUp && ready.session == session => {
                match ready.refused {
                    0 => self.begin(ready),
                    code => self.fail(PulseFault::Board { code, axis: None, unreadable: 0 }),
                }
            }
            Heard::State(state)
                if matches!(self.phase, Phase::Runs | Phase::Failed) && state.session == session =>
            {
                self.silence = 0;
                self.state = Some(*state);
                for (axis, heard) in self.axes.iter().zip(&state.axes) {
                    self.actual[axis.axis] = axis.called(heard.position);
                }
                if state.fault != 0 {
                    let axis = self.axes.get(usize::from(state.axis)).map(|axis| axis.axis);
                    let unreadable = state.unreadable;
                    self.fail(PulseFault::Board { code: state.fault, axis, unreadable });
                }
            }
            _ => {}
        }
    }

    /// Whether the board can do what the machine file asks for.
    fn suits(&self, board: &Welcome) -> Result<(), PulseFault> {
        let setup = &self.setup;
        if board.version != frames::VERSION {
            let (wanted, possible) = (f64::from(frames::VERSION), f64::from(board.version));
            return Err(PulseFault::Unsuited { key: "version", wanted, possible });
        }
        let [shortest, longest] = board.period_ns.map(|ns| f64::from(ns) / 1e6);
        let period = self.period_ms;
        // A frame of the board; setpoints are shorter.
        let bits = (41 + 18 * self.axes.len()) as f64 * 10.0 / (period / 1000.0);
        let baud = match &self.at {
            LinkAt::Serial(_, baud) => f64::from(*baud) * LINE_SHARE,
            _ => f64::INFINITY,
        };
        for (key, wanted, least, most) in [
            ("drives.axes", self.axes.len() as f64, 0.0, f64::from(board.axes)),
            ("drives.inputs", self.config.inputs.len() as f64, 0.0, f64::from(board.inputs)),
            ("drives.outputs", self.config.outputs.len() as f64, 0.0, f64::from(board.outputs)),
            ("drives.buffer", f64::from(setup.buffer), 0.0, f64::from(board.buffer)),
            ("servo_period_ms", period, shortest, longest),
            ("drives.link", bits, 0.0, baud),
        ] {
            if !(least..=most).contains(&wanted) {
                let possible = if wanted < least { least } else { most };
                return Err(PulseFault::Unsuited { key, wanted, possible });
            }
        }
        for (axis, setup) in self.axes.iter().zip(&setup.of) {
            let [pulse, space, ..] = setup.times.map(f64::from);
            let possible = f64::from(board.rate).min(1e9 / (pulse + space).max(1.0));
            if axis.rate > possible {
                return Err(PulseFault::StepRate { axis: axis.axis, needed: axis.rate, possible });
            }
        }
        Ok(())
    }

    /// The board stands ready: what it counts is where the axes are commanded to be.
    fn begin(&mut self, ready: &Ready) {
        for (axis, position) in self.axes.iter_mut().zip(ready.positions) {
            axis.told = i64::from(position);
            axis.zero = axis.told - axis.parts(self.commanded[axis.axis]);
            axis.marker = 0;
        }
        self.setpoint = Setpoint {
            session: self.setup.session,
            enable: self.enable,
            axes: self.axes.len(),
            outputs: self.setpoint.outputs,
            ..Setpoint::default()
        };
        self.actual = self.commanded;
        self.state = None;
        self.enter(Phase::Runs);
    }

    /// The setpoint of this period.
    fn command(&mut self) {
        let places = self.setpoint.positions.iter_mut().zip(&mut self.setpoint.markers);
        for (axis, (position, marker)) in self.axes.iter_mut().zip(places) {
            axis.told = axis.zero.wrapping_add(axis.parts(self.commanded[axis.axis]));
            (*position, *marker) = (axis.told as i32, axis.marker);
        }
        let frame = Frame::setpoint(&self.setpoint);
        self.setpoint.number = self.setpoint.number.wrapping_add(1);
        self.send(frame);
    }

    fn send(&mut self, frame: Frame) {
        let mut coded = [0; LONGEST_CODED];
        let coded = frame.coded(&mut coded);
        if self.unsent.len() + coded.len() > self.unsent.capacity() {
            return self.fail(PulseFault::Cut(ErrorKind::TimedOut));
        }
        self.unsent.extend_from_slice(coded);
        while !self.unsent.is_empty() {
            match self.link.send(&self.unsent) {
                Ok(count) if count > 0 => drop(self.unsent.drain(..count.min(self.unsent.len()))),
                Ok(_) => return,
                Err(error) if is_later(error.kind()) => return,
                Err(error) => {
                    self.unsent.clear();
                    return self.fail(PulseFault::Cut(error.kind()));
                }
            }
        }
    }

    /// Asks now and then, and not for ever.
    fn ask(&mut self, frame: fn(&Setup) -> Frame) {
        let every = (AGAIN_MS / self.period_ms).ceil().max(1.0) as u64;
        if self.periods.is_multiple_of(every) {
            self.send(frame(&self.setup));
        }
        if self.periods as f64 * self.period_ms > PATIENCE_MS {
            self.fail(PulseFault::Silent);
        }
    }

    /// The place where an axis was when something was met.
    fn met(&self, at: usize, place: impl Fn(&frames::AxisState) -> Option<i32>) -> Option<f64> {
        let state = self.state.as_ref()?.axes.get(at)?;
        Some(self.axes.get(at)?.called(place(state)?))
    }

    fn number(&self, axis: Axis) -> Option<usize> {
        self.axes.iter().position(|stepped| stepped.axis == axis)
    }

    fn set_of(&self, is: impl Fn(&Stepped, u8) -> bool) -> AxisSet {
        let Some(state) = &self.state else { return AxisSet::EMPTY };
        let of = self.axes.iter().zip(&state.axes);
        of.filter(|(axis, heard)| is(axis, heard.switches)).map(|(axis, _)| axis.axis).collect()
    }
}

fn is_later(kind: ErrorKind) -> bool {
    matches!(kind, ErrorKind::WouldBlock | ErrorKind::Interrupted)
}

/// The next number of something that is waited for; 0 is nothing.
fn next_number(number: u8) -> u8 {
    number % 255 + 1
}

impl Drives for Pulse {
    fn keeps_time(&self) -> bool {
        true
    }

    fn exchange(&mut self, commanded: &Position) -> Position {
        self.commanded = *commanded;
        let was_ready = self.is_ready();
        self.listen();
        match self.phase {
            Phase::Greets => self.ask(|setup| Frame::hello(setup.session)),
            Phase::SetsUp => self.ask(Frame::setup),
            // The board's watchdog begins with the first setpoint: that is for the first period of whoever waited for the
            // board, and has something else to do before.
            Phase::Runs if !was_ready => {}
            Phase::Runs => {
                self.command();
                self.silence += 1;
                let ms = self.silence as f64 * self.period_ms;
                if ms > self.watchdog_ms {
                    self.fail(PulseFault::Lost { ms });
                }
            }
            Phase::Failed if self.periods.is_multiple_of(8) => self.send(Frame::stop(self.setup.session)),
            Phase::Failed => {}
        }
        self.periods += 1;
        let mut actual = *commanded;
        // Where they are now is where they are commanded to be when they are ready.
        if matches!(self.phase, Phase::Runs | Phase::Failed) {
            for axis in &self.axes {
                actual[axis.axis] = self.actual[axis.axis];
            }
        }
        actual
    }

    fn rename(&mut self, at: &Position) {
        for axis in &mut self.axes {
            let zero = axis.told.wrapping_sub(axis.parts(at[axis.axis]));
            let by = (axis.zero.wrapping_sub(zero)) as f64 / axis.scale;
            self.actual[axis.axis] += by;
            axis.zero = zero;
        }
        self.commanded = *at;
    }

    fn knows_places(&self) -> bool {
        self.config.absolute
    }

    fn switches(&self) -> Switches {
        let closed = self.state.as_ref().is_some_and(|state| state.probe_closed);
        Switches {
            home: self.set_of(|_, switches| switches & HOME_CLOSED == 0),
            above: self.set_of(|axis, switches| axis.limits && switches & UPPER_CLOSED == 0),
            below: self.set_of(|axis, switches| axis.limits && switches & LOWER_CLOSED == 0),
            skip: self.config.probe && self.state.is_some() && closed != self.wires.probe_opens,
        }
    }

    fn arm_marker(&mut self, axis: Axis) {
        if let Some(axis) = self.axes.iter_mut().find(|stepped| stepped.axis == axis) {
            axis.marker = next_number(axis.marker);
        }
    }

    fn marker(&self, axis: Axis) -> Option<f64> {
        let at = self.number(axis)?;
        let wanted = self.axes.get(at)?.marker;
        self.met(at, |state| (wanted != 0 && state.passed == wanted).then_some(state.marker))
    }

    fn home_edge(&self, axis: Axis) -> Option<f64> {
        self.met(self.number(axis)?, |state| (state.switches & EDGE_SEEN != 0).then_some(state.edge))
    }

    fn has_probe(&self) -> bool {
        self.config.probe
    }

    fn probe_opens(&self) -> bool {
        self.wires.probe_opens
    }

    fn arm_probe(&mut self, until: Contact) {
        // The input that carries current while the probe is free is waited for the other way round.
        self.setpoint.until_open = (until == Contact::Lost) != self.wires.probe_opens;
        self.setpoint.probe = next_number(self.setpoint.probe);
    }

    fn probe(&self) -> Option<Position> {
        let state = self.state.as_ref()?;
        if self.setpoint.probe == 0 || state.touched != self.setpoint.probe {
            return None;
        }
        let mut touched = self.commanded;
        for (axis, heard) in self.axes.iter().zip(&state.axes) {
            touched[axis.axis] = axis.called(heard.touch);
        }
        Some(touched)
    }

    fn read(&self, put: &mut dyn FnMut(u16, u8, bool)) {
        let Some(state) = &self.state else { return };
        for (byte, values) in self.config.inputs.iter().zip(state.inputs) {
            (0..8).for_each(|bit| put(*byte, bit, values >> bit & 1 == 1));
        }
        self.wires.put(&self.switches(), put);
        let (_, (byte, bit)) = ESP_BUTTON;
        put(byte, bit, state.emergency_closed);
    }

    fn write(&mut self, is_on: &dyn Fn(u16, u8) -> bool) {
        for (byte, values) in self.config.outputs.iter().zip(&mut self.setpoint.outputs) {
            *values = (0..8).fold(0, |values, bit| values | u8::from(is_on(*byte, bit)) << bit);
        }
    }

    fn turn_spindle(&mut self, rpm: f64) {
        let share = (rpm / self.most_rpm).clamp(-1.0, 1.0);
        self.setpoint.spindle = (share * f64::from(i16::MAX)).round() as i16;
    }

    fn leads_spindle(&self) -> bool {
        false
    }

    fn enable(&mut self, on: bool) -> bool {
        (self.enable, self.setpoint.enable) = (on, on);
        // Without current a motor follows whatever moves it, and nobody counts.
        on || self.config.absolute
    }

    fn has_failed(&self) -> bool {
        self.phase == Phase::Failed
    }

    fn failure(&self, span: Span) -> Option<Box<Alarm>> {
        self.fault.filter(|_| self.has_failed()).map(|fault| fault.alarm(&self.at, span))
    }

    fn restart(&mut self) {
        if self.has_failed() {
            self.setup.session = self.setup.session.wrapping_add(1);
            self.fault = None;
            self.reader = Reader::new();
            self.unsent.clear();
            self.link.reopen();
            self.enter(Phase::Greets);
        }
    }
}

impl Drop for Pulse {
    /// Whoever ends the control leaves no axis running.
    fn drop(&mut self) {
        self.send(Frame::stop(self.setup.session));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_go_round_the_circle_of_the_board() {
        let machine = Machine::demo_mill();
        let config = PulseAxis {
            name: Axis::X,
            steps: 1000.0,
            reversed: false,
            pulse_ns: 0,
            space_ns: 0,
            setup_ns: 0,
            hold_ns: 0,
            limits: false,
        };
        let mut axis = Stepped::new(&config, machine.axis(Axis::X).unwrap());
        // 8388.608 mm are 2³¹ parts.
        for at in [0.0, 8388.0, 8389.0, -8400.0, 123_456.789, -1e6] {
            axis.told = axis.zero + axis.parts(at);
            let counted = (axis.told as i32).wrapping_add(-512);
            assert!((axis.called(counted) - (at - 0.002)).abs() < 1e-5, "{at}");
        }
        assert!((axis.rate - 250.0 * 1.02 * 1000.0).abs() < 1e-6);
    }
}
