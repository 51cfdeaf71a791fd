//! A board that makes step and direction signals, simulated down to the single edge: written from
//! `docs/pulse-protocol.md` alone, so that it and the control judge each other.
//!
//! Time is told to it. It remembers every pulse for whoever wants to judge them (`pulses`), and counts by itself what no
//! drive would understand (`wrong`).
#![allow(dead_code, missing_docs, clippy::unwrap_used, clippy::panic)]

use std::collections::BTreeMap;

/// Parts of a step in which positions are told.
const PARTS: f64 = 256.0;

pub const RUNNING: u8 = 2;
pub const STOPPED: u8 = 4;

/// What it can do.
#[derive(Clone, Debug)]
pub struct Able {
    pub version: u8,
    pub axes: u8,
    pub inputs: u8,
    pub outputs: u8,
    pub buffer: u16,
    pub period_ns: [u32; 2],
    pub rate: u32,
}

impl Default for Able {
    fn default() -> Able {
        Able {
            version: 1,
            axes: 6,
            inputs: 2,
            outputs: 2,
            buffer: 512,
            period_ns: [250_000, 4_000_000],
            rate: 400_000,
        }
    }
}

/// A pulse: when the direction was last changed before it, its edges, its way; ns of true time.
#[derive(Clone, Copy, Debug)]
pub struct Pulse {
    pub turned: f64,
    pub rise: f64,
    pub fall: f64,
    pub up: bool,
}

/// One output for an axis, and what is connected to it.
#[derive(Clone, Debug, Default)]
pub struct Stepper {
    times: [f64; 4],
    stop: f64,
    rate: f64,
    reversed: bool,
    /// Where it is, in parts of a step: of the command, and the steps made.
    place: f64,
    pub count: i64,
    /// Parts of a step in a ns.
    speed: f64,
    level: bool,
    turned: f64,
    fall: f64,
    pub pulses: Vec<Pulse>,
    /// Pulses that are too short, too close to each other or to a change of direction.
    pub wrong: u64,
    /// Longest that a pulse was put off, ns.
    pub put_off: f64,
    /// Steps from and to which its home switch is open, if it has one.
    pub home: Option<[i64; 2]>,
    /// Steps between two markers, if it has them.
    pub markers: Option<i64>,
    /// Beyond these steps its travel switches are open.
    pub travel: Option<[i64; 2]>,
    edge: Option<i32>,
    armed: u8,
    passed: u8,
    marker: i32,
    touch: i32,
}

/// A setpoint that waits.
#[derive(Clone, Debug)]
struct Waiting {
    enable: bool,
    until_open: bool,
    spindle: i16,
    probe: u8,
    outputs: [u8; 8],
    axes: Vec<(i32, u8)>,
}

pub struct Board {
    pub able: Able,
    pub axes: Vec<Stepper>,
    /// Its clock is slow by this share.
    pub drift: f64,
    pub keeps_pulses: bool,
    /// The probe touches where this axis is at this step or below.
    pub plane: Option<(usize, i64)>,
    /// Its input carries current while it touches nothing.
    pub probe_opens: bool,
    pub emergency_stop: bool,
    pub amplifier_fault: Option<u8>,
    pub inputs: [u8; 8],
    pub outputs: [u8; 8],
    pub spindle: i16,
    pub enabled: bool,
    /// When setpoints were begun, ns, from the first of this conversation.
    pub begun: Vec<f64>,
    pub doing: u8,
    pub fault: u8,
    fault_axis: u8,
    pub unreadable: u16,
    now: f64,
    due: f64,
    heard: Option<f64>,
    session: u16,
    period: f64,
    buffer: usize,
    watchdog: f64,
    waiting: BTreeMap<u32, Waiting>,
    next: u32,
    /// Setpoints that wait, evened out.
    pub level: f64,
    probe: u8,
    touched: u8,
    set_up: bool,
    stream: Vec<u8>,
    answers: Vec<u8>,
}

impl Board {
    pub fn new(able: Able) -> Board {
        Board {
            able,
            axes: Vec::new(),
            drift: 0.0,
            keeps_pulses: true,
            plane: None,
            probe_opens: false,
            emergency_stop: false,
            amplifier_fault: None,
            inputs: [0; 8],
            outputs: [0; 8],
            spindle: 0,
            enabled: false,
            begun: Vec::new(),
            doing: 0,
            fault: 0,
            fault_axis: 255,
            unreadable: 0,
            now: 0.0,
            due: 0.0,
            heard: None,
            session: 0,
            period: 1e6,
            buffer: 1,
            watchdog: 1e9,
            waiting: BTreeMap::new(),
            next: 0,
            level: 0.0,
            probe: 0,
            touched: 0,
            set_up: false,
            stream: Vec::new(),
            answers: Vec::new(),
        }
    }

    /// Bytes that came over the line.
    pub fn feed(&mut self, bytes: &[u8]) {
        for byte in bytes {
            if *byte != 0 {
                self.stream.push(*byte);
                self.stream.truncate(300);
                continue;
            }
            let coded = std::mem::take(&mut self.stream);
            match frame_of(&coded) {
                Some(frame) => self.hear(&frame),
                None => self.unreadable = self.unreadable.saturating_add(1),
            }
        }
    }

    /// Bytes that it has to say.
    pub fn take(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.answers)
    }

    /// Time goes on, ns.
    pub fn run(&mut self, ns: f64) {
        self.now += ns;
        while self.set_up && self.due <= self.now {
            self.period_begins();
        }
    }

    fn hear(&mut self, frame: &[u8]) {
        let mut at = Cursor(frame);
        match at.take::<1>()[0] {
            0x01 => {
                let (_version, session) = (at.take::<1>()[0], at.u16());
                let able = self.able.clone();
                let mut say = vec![0x81, able.version];
                say.extend(session.to_le_bytes());
                say.extend([able.axes, able.inputs, able.outputs]);
                say.extend(able.buffer.to_le_bytes());
                say.extend(able.period_ns[0].to_le_bytes());
                say.extend(able.period_ns[1].to_le_bytes());
                say.extend(able.rate.to_le_bytes());
                self.say(say);
            }
            0x02 => self.set_up(&mut at),
            0x03 => self.setpoint(&mut at),
            0x04 if self.session == at.u16() && self.doing < 3 => {
                self.waiting.clear();
                self.doing = if self.set_up { 3 } else { 0 };
            }
            _ => {}
        }
    }

    fn set_up(&mut self, at: &mut Cursor) {
        if self.doing == 3 {
            // Axes that are being braked are not taken over: the control asks again.
            return;
        }
        self.session = at.u16();
        self.period = f64::from(at.u32());
        self.buffer = usize::from(at.u16());
        self.watchdog = f64::from(at.u16()) * 1e6;
        let count = usize::from(at.take::<1>()[0]);
        self.axes.resize(count, Stepper::default());
        for axis in &mut self.axes {
            axis.times = [at.u32(), at.u32(), at.u32(), at.u32()].map(f64::from);
            axis.rate = f64::from(at.u32());
            axis.stop = f64::from(at.u32());
            axis.reversed = at.take::<1>()[0] & 1 == 1;
            // It stands on a step.
            (axis.place, axis.speed) = (axis.count as f64 * PARTS, 0.0);
            (axis.edge, axis.armed, axis.passed) = (None, 0, 0);
        }
        self.waiting.clear();
        self.begun.clear();
        self.axes.iter_mut().for_each(|axis| axis.pulses.clear());
        (self.next, self.level) = (0, self.buffer as f64);
        (self.doing, self.fault, self.fault_axis, self.unreadable) = (1, 0, 255, 0);
        (self.heard, self.probe, self.touched) = (None, 0, 0);
        if !self.set_up {
            (self.set_up, self.due) = (true, self.now);
        }
        let mut say = vec![0x82];
        say.extend(self.session.to_le_bytes());
        say.extend([0, self.axes.len() as u8]);
        self.axes.iter().for_each(|axis| say.extend((axis.place as i64 as i32).to_le_bytes()));
        self.say(say);
    }

    fn setpoint(&mut self, at: &mut Cursor) {
        if at.u16() != self.session || !self.set_up {
            return;
        }
        self.heard = Some(self.now);
        let number = at.u32();
        let bits = at.take::<1>()[0];
        let setpoint = Waiting {
            enable: bits & 1 == 1,
            until_open: bits & 2 == 2,
            spindle: at.u16() as i16,
            probe: at.take::<1>()[0],
            outputs: at.take(),
            axes: self.axes.iter().map(|_| (at.u32() as i32, at.take::<1>()[0])).collect(),
        };
        if number.wrapping_sub(self.next) < u32::from(self.able.buffer) {
            self.waiting.insert(number, setpoint);
        }
    }

    fn stop(&mut self, fault: u8, axis: u8) {
        if self.fault == 0 {
            (self.fault, self.fault_axis, self.doing) = (fault, axis, 3);
            self.waiting.clear();
        }
    }

    fn watch(&mut self) {
        if self.doing == 0 || self.doing > 2 {
            return;
        }
        if self.heard.is_some_and(|heard| self.now - heard > self.watchdog) {
            self.stop(1, 255);
        } else if self.emergency_stop {
            self.stop(5, 255);
        } else if let Some(axis) = self.amplifier_fault {
            self.stop(6, axis);
        }
    }

    fn period_begins(&mut self) {
        let begin = self.due;
        self.watch();
        self.level += (self.waiting.len() as f64 - self.level) / 256.0;
        // With more waiting than there should be it goes a little faster.
        let pace = ((self.level - self.buffer as f64) * 1e-3).clamp(-2e-3, 2e-3);
        let length = self.period * (1.0 + self.drift) * (1.0 - pace);
        self.due += length;
        let end = self.due;
        match self.doing {
            1 if self.waiting.len() >= self.buffer => self.doing = RUNNING,
            3 if self.axes.iter().all(|axis| axis.speed == 0.0) => {
                self.doing = if self.fault == 0 { 0 } else { STOPPED };
                (self.enabled, self.spindle, self.outputs) = (false, 0, [0; 8]);
            }
            _ => {}
        }
        if self.doing == RUNNING {
            match self.waiting.remove(&self.next) {
                Some(setpoint) => return self.follow(&setpoint, begin, end),
                None if !self.waiting.is_empty() => self.stop(3, 255),
                None if self.axes.iter().any(|axis| axis.speed != 0.0) => self.stop(2, 255),
                None => self.doing = 1,
            }
        }
        if self.doing == 3 {
            for axis in &mut self.axes {
                // In straight pieces, each slower by what the acceleration takes.
                let slower = axis.stop * PARTS * 1e-18 * (end - begin);
                axis.speed -= slower.min(axis.speed.abs()).copysign(axis.speed);
                let to = axis.place + axis.speed * (end - begin);
                axis.follow(begin, end, to, self.keeps_pulses);
            }
        }
        self.tell();
    }

    fn follow(&mut self, setpoint: &Waiting, begin: f64, end: f64) {
        // Positions go round a circle of 2³².
        let way = |axis: &Stepper, to: i32| f64::from(to.wrapping_sub(axis.place as i64 as i32));
        for (number, (axis, (to, _))) in self.axes.iter().zip(&setpoint.axes).enumerate() {
            let most = axis.rate * PARTS * self.period * 1e-9 + 1.0;
            if way(axis, *to).abs() > most {
                self.stop(4, number as u8);
                return self.tell();
            }
        }
        if self.keeps_pulses {
            self.begun.push(begin);
        }
        self.next = self.next.wrapping_add(1);
        (self.enabled, self.spindle, self.outputs) = (setpoint.enable, setpoint.spindle, setpoint.outputs);
        if setpoint.probe != self.probe {
            (self.probe, self.touched) = (setpoint.probe, 0);
        }
        if let Some((number, step)) = self.plane
            && self.probe != 0
            && self.touched == 0
        {
            let plane = step as f64 * PARTS;
            let from = self.axes[number].place;
            let to = from + way(&self.axes[number], setpoint.axes[number].0);
            // Carries the input current, and is that what is waited for?
            let is_met = |place: f64| ((place <= plane) != self.probe_opens) != setpoint.until_open;
            if is_met(from) || is_met(to) {
                let part = if is_met(from) { 0.0 } else { (from - plane) / (from - to) };
                for (axis, (to, _)) in self.axes.iter_mut().zip(&setpoint.axes) {
                    axis.touch = (axis.place + part * way(axis, *to)).round() as i64 as i32;
                }
                self.touched = self.probe;
            }
        }
        for (axis, (to, marker)) in self.axes.iter_mut().zip(&setpoint.axes) {
            if *marker != axis.armed {
                (axis.armed, axis.passed) = (*marker, 0);
            }
            let to = axis.place + way(axis, *to);
            axis.speed = (to - axis.place) / (end - begin);
            axis.follow(begin, end, to, self.keeps_pulses);
        }
        self.tell();
    }

    fn tell(&mut self) {
        let probe = self.plane.is_some_and(|(axis, step)| self.axes[axis].count <= step);
        let mut say = vec![0x83];
        say.extend(self.session.to_le_bytes());
        say.extend(self.next.to_le_bytes());
        say.extend((self.waiting.len() as u16).to_le_bytes());
        say.extend([self.doing, self.fault, self.fault_axis]);
        say.extend(self.unreadable.to_le_bytes());
        let closed = u8::from(probe != self.probe_opens) | u8::from(!self.emergency_stop) << 1;
        say.extend([closed, self.touched]);
        say.extend(self.inputs);
        say.push(self.axes.len() as u8);
        for axis in &self.axes {
            say.extend(((axis.count as i128 * 256) as i32).to_le_bytes());
            say.extend(axis.edge.unwrap_or(0).to_le_bytes());
            say.extend(axis.marker.to_le_bytes());
            say.extend(axis.touch.to_le_bytes());
            say.extend([axis.passed, axis.switches()]);
        }
        self.say(say);
    }

    fn say(&mut self, mut content: Vec<u8>) {
        let crc = crc_of(&content);
        content.extend(crc.to_le_bytes());
        // COBS, piece by piece between zeros.
        for piece in content.split(|byte| *byte == 0) {
            self.answers.push(piece.len() as u8 + 1);
            self.answers.extend(piece);
        }
        self.answers.push(0);
    }
}

impl Stepper {
    /// Goes straight to a place within a time, with the pulses that make it the nearest step at every instant.
    fn follow(&mut self, begin: f64, end: f64, to: f64, keeps: bool) {
        let from = self.place;
        let [pulse, space, setup, hold] = self.times;
        let nearest = |place: f64| (place / PARTS + 0.5).floor() as i64;
        self.feel(from, to);
        while self.count != nearest(to) {
            let up = nearest(to) > self.count;
            let edge = (self.count as f64 + if up { 0.5 } else { -0.5 }) * PARTS;
            let part = if to == from { 0.0 } else { ((edge - from) / (to - from)).clamp(0.0, 1.0) };
            let wanted = begin + part * (end - begin);
            let mut rise = wanted.max(self.fall + space);
            if (up != self.reversed) != self.level {
                self.turned = begin.max(self.fall + hold);
                self.level = up != self.reversed;
                rise = rise.max(self.turned + setup);
            }
            self.put_off = self.put_off.max(rise - wanted);
            // What a scope at the connector would mark.
            let turns = self.turned > self.fall;
            let is_wrong = rise - self.fall < space
                || turns && (self.turned - self.fall < hold || rise - self.turned < setup)
                || rise < begin;
            self.wrong += u64::from(is_wrong);
            let made =
                Pulse { turned: self.turned, rise, fall: rise + pulse, up: self.level != self.reversed };
            self.fall = made.fall;
            self.count += if made.up { 1 } else { -1 };
            if keeps {
                self.pulses.push(made);
            }
        }
        self.place = to;
    }

    /// Keeps the places of what is passed.
    fn feel(&mut self, from: f64, to: f64) {
        if let Some(ends) = self.home {
            for end in ends {
                let end = end as f64 * PARTS;
                if (from < end) != (to < end) {
                    self.edge = Some(end as i64 as i32);
                }
            }
        }
        if let Some(pitch) = self.markers.filter(|_| self.armed != 0 && self.passed == 0) {
            let pitch = pitch as f64 * PARTS;
            let (first, last) = ((from / pitch).floor(), (to / pitch).floor());
            if first != last {
                self.marker = (if to > from { first + 1.0 } else { first } * pitch) as i64 as i32;
                self.passed = self.armed;
            }
        }
    }

    fn switches(&self) -> u8 {
        let open = self.home.is_some_and(|[from, to]| (from..to).contains(&self.count));
        let [lower, upper] = self.travel.unwrap_or([i64::MIN, i64::MAX]);
        let bits = [!open, self.count <= upper, self.count >= lower, self.edge.is_some()];
        bits.into_iter().enumerate().fold(0, |all, (bit, on)| all | u8::from(on) << bit)
    }
}

struct Cursor<'a>(&'a [u8]);

impl Cursor<'_> {
    /// The next bytes; zeros behind the end, which a board of this kind takes for a setpoint at rest. Frames have a CRC.
    fn take<const N: usize>(&mut self) -> [u8; N] {
        let mut bytes = [0; N];
        let count = N.min(self.0.len());
        bytes[..count].copy_from_slice(&self.0[..count]);
        self.0 = &self.0[count..];
        bytes
    }

    fn u16(&mut self) -> u16 {
        u16::from_le_bytes(self.take())
    }

    fn u32(&mut self) -> u32 {
        u32::from_le_bytes(self.take())
    }
}

/// A frame without COBS and CRC; `None` if it is none.
pub fn frame_of(coded: &[u8]) -> Option<Vec<u8>> {
    let mut frame = Vec::new();
    let mut at = 0;
    while at < coded.len() {
        let next = at + usize::from(coded[at]);
        frame.extend(coded.get(at + 1..next)?);
        if next < coded.len() {
            frame.push(0);
        }
        at = next;
    }
    let end = frame.len().checked_sub(4)?;
    let good = frame[end..] == crc_of(&frame[..end]).to_le_bytes() && end > 0;
    frame.truncate(end);
    good.then_some(frame)
}

/// CRC-32 bit by bit.
fn crc_of(bytes: &[u8]) -> u32 {
    let mut crc = u32::MAX;
    for byte in bytes {
        crc ^= u32::from(*byte);
        for _ in 0..8 {
            crc = if crc & 1 == 1 { (crc >> 1) ^ 0xEDB8_8320 } else { crc >> 1 };
        }
    }
    !crc
}
