//! Feed and speed, spindle, coolant, overrides, outputs and inputs (LinuxCNC, F, S, M3 to M9, M19, M48 to M53,
//! M62 to M68, G93 to G97).

use super::blocks::Codes;
use super::codes::MGroup;
use crate::Fallible;
use crate::barrier::Present;
use crate::dialect::{MFunction, Meaning};
use crate::interpreter::Interpreter;
use crate::modal::Group;
use ferrocut_geometry::MM_PER_INCH;
use ferrocut_machine::Fault;
use ferrocut_toolpath::{Op, Port, SpindleState};

/// Surface speeds are feet a minute with inches, and metres a minute else.
const INCHES_PER_FOOT: f64 = 12.0;
const MM_PER_METRE: f64 = 1000.0;

/// The parameter that holds what an input was.
const INPUT_RESULT: u32 = 5399;

/// Ports from here on are analogue inputs.
const FIRST_ANALOGUE: u16 = 1000;

impl Interpreter {
    /// Feed mode, F, spindle mode and S.
    pub(super) fn ngc_feed_and_speed(&mut self, codes: &Codes) -> Fallible<()> {
        if let Some(row) = codes.g(Group::SurfaceSpeed) {
            if row.meaning == Meaning::SurfaceSpeed {
                if !self.words.has(b'S') {
                    return Err(self.ngc_missing(b'S'));
                }
                self.technology.surface_max_rpm = self.words.get(b'D').map(f64::abs);
            }
            self.modal.set(row);
        }
        if let Some(row) = codes.g(Group::FeedMode) {
            // The feed is given anew, even behind the code that was in force.
            self.ngc.feed = 0.0;
            self.modal.set(row);
        }
        self.ngc.has_feed_word = self.words.has(b'F');
        if let Some(feed) = self.words.get(b'F') {
            if feed < 0.0 {
                return Err(self.alarm_at(Fault::WordNegative, b'F'));
            }
            self.ngc.feed = feed;
            self.ngc.feed_unit = self.ngc_unit();
        }
        if let Some(speed) = self.words.get(b'S') {
            if speed < 0.0 {
                return Err(self.alarm_at(Fault::WordNegative, b'S'));
            }
            match self.modal.meaning(Group::SurfaceSpeed) {
                Meaning::SurfaceSpeed => {
                    let unit =
                        if self.modal.is_inch() { MM_PER_INCH * INCHES_PER_FOOT } else { MM_PER_METRE };
                    self.technology.surface_speed = Some(speed * unit);
                }
                _ => self.technology.speed = Some(speed),
            }
            self.tell_speed();
        }
        Ok(())
    }

    /// M codes of spindle, coolant, overrides and outputs.
    pub(super) fn ngc_machine_words(&mut self, codes: &Codes) -> Fallible<()> {
        if let Some(row) = codes.m(MGroup::Io)
            && row.function == MFunction::SetOutput
        {
            self.ngc_output(row.code)?;
        }
        if let Some(row) = codes.m(MGroup::Spindle) {
            let speed = self.speed();
            match row.function {
                MFunction::SpindleClockwise => self.spindle(SpindleState::Clockwise(speed)),
                MFunction::SpindleCounterClockwise => self.spindle(SpindleState::CounterClockwise(speed)),
                MFunction::SpindleOff => self.spindle(SpindleState::Off),
                MFunction::Orient => self.ngc_orient()?,
                _ => self.ngc_state_word(row.code)?,
            }
        }
        if let Some(row) = codes.m(MGroup::Coolant) {
            match row.function {
                MFunction::CoolantOn => self.coolant(true),
                MFunction::CoolantOff => {
                    self.coolant(false);
                    if std::mem::take(&mut self.ngc.mist) {
                        self.emit(Op::Machine(row.code.into()));
                    }
                }
                _ => {
                    self.ngc.mist = true;
                    self.emit(Op::Machine(row.code.into()));
                }
            }
        }
        if let Some(row) = codes.m(MGroup::Override) {
            self.ngc.overrides.set(row.code, self.words.get(b'P'));
            self.emit(Op::Machine(row.code.into()));
        }
        Ok(())
    }

    /// M19 R: the spindle stops at an angle.
    fn ngc_orient(&mut self) -> Fallible<()> {
        let angle = self.words.get(b'R').unwrap_or(0.0);
        if !(0.0..=360.0).contains(&angle) {
            return Err(self.alarm_at(Fault::WordOutOfRange, b'R'));
        }
        if let Some(way) = self.words.get(b'P')
            && ![0.0, 1.0, 2.0].contains(&way)
        {
            return Err(self.alarm_at(Fault::WordOutOfRange, b'P'));
        }
        self.technology.spindle = SpindleState::Off;
        self.emit(Op::Orient(angle));
        Ok(())
    }

    /// M62 to M65 P, M67 and M68 E Q: M62, M63 and M67 in step with the next move, M64, M65 and M68 before it.
    fn ngc_output(&mut self, code: u16) -> Fallible<()> {
        let (port, value) = match code {
            62..=65 => {
                let Some(port) = self.words.get(b'P') else { return Err(self.ngc_missing(b'P')) };
                (Port::Digital(port.round() as i64), f64::from(u8::from(matches!(code, 62 | 64))))
            }
            _ => {
                let Some(port) = self.words.get(b'E') else { return Err(self.ngc_missing(b'E')) };
                // Where no value is given it is the one that stands for none.
                (Port::Analog(port.round() as i64), self.words.get(b'Q').unwrap_or(-1.0))
            }
        };
        self.emit(Op::Output { port, value, with_next_move: matches!(code, 62 | 63 | 67) });
        Ok(())
    }

    /// M66: waits for an input, or reads it. False where the block has to be run again with the machine at
    /// rest, and once more when it has waited.
    pub(super) fn ngc_input(&mut self) -> Fallible<bool> {
        let (digital, analogue) = (self.words.get(b'P'), self.words.get(b'E'));
        let kind = self.words.get(b'L').unwrap_or(0.0).round();
        let timeout = self.words.get(b'Q').unwrap_or(0.0);
        let (port, first, letter) = match (digital, analogue) {
            (Some(_), Some(_)) => return Err(self.ngc_alarm(Fault::CodesContradict)),
            (Some(port), None) => (port, 0, b'P'),
            (None, Some(port)) => (port, FIRST_ANALOGUE, b'E'),
            (None, None) => return Err(self.ngc_missing(b'P')),
        };
        if !(0.0..f64::from(FIRST_ANALOGUE)).contains(&port.round()) {
            return Err(self.alarm_at(Fault::WordOutOfRange, letter));
        }
        if !(0.0..=4.0).contains(&kind) || kind != 0.0 && letter == b'E' {
            return Err(self.alarm_at(Fault::WordOutOfRange, b'L'));
        }
        if kind != 0.0 && timeout <= 0.0 {
            return Err(self.ngc_missing(b'Q'));
        }
        if self.present != Present::Known {
            self.present = Present::Asked;
            self.ngc.awaits_input = false;
            return Ok(false);
        }
        if std::mem::take(&mut self.ngc.awaits_input) {
            // The machine has waited, and said what came.
            return Ok(true);
        }
        let port = port.round() as u16 + first;
        let state = self.inputs.get(&port).copied();
        if kind == 0.0 {
            let value = state.unwrap_or(0.0);
            self.memory
                .variables
                .set(INPUT_RESULT, Some(value))
                .map_err(|_| self.ngc_alarm(Fault::DataValue))?;
            self.variable_writes += 1;
            return Ok(true);
        }
        // 1 rise, 2 fall, 3 high, 4 low. At a desk an input that nobody simulates is taken to come; one that
        // keeps another state is not.
        let wanted = f64::from(u8::from(kind == 1.0 || kind == 3.0));
        self.emit(Op::Wait {
            port: Port::Digital(i64::from(port)),
            value: wanted,
            is_edge: kind == 1.0 || kind == 2.0,
            timeout: Some(timeout),
            must_come: false,
        });
        self.ngc.awaited_input = wanted;
        self.ngc_input_came(state.is_none_or(|state| (state != 0.0) == (wanted != 0.0)));
        if self.machine_waits.is_some() {
            // The rest of the block comes behind what it says.
            self.present = Present::Asked;
            self.ngc.awaits_input = true;
        }
        Ok(self.machine_waits.is_none())
    }

    /// Whether the input came that the program waited for.
    pub(crate) fn ngc_input_came(&mut self, came: bool) {
        let value = if came { self.ngc.awaited_input } else { -1.0 };
        // 1, 0 and -1 are values that every parameter takes.
        let _ = self.memory.variables.set(INPUT_RESULT, Some(value));
        self.variable_writes += 1;
    }
}

/// What M48 to M53 set: whether the operator's overrides and hold have effect.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Overrides {
    pub feed: bool,
    pub speed: bool,
    pub adaptive: bool,
    pub hold: bool,
}

impl Overrides {
    /// As a machine starts.
    pub(super) const START: Overrides = Overrides { feed: true, speed: true, adaptive: false, hold: true };

    /// Does one of the codes, with its P word.
    fn set(&mut self, code: u16, p: Option<f64>) {
        let on = p != Some(0.0);
        match code {
            48 => (self.feed, self.speed) = (true, true),
            49 => (self.feed, self.speed) = (false, false),
            50 => self.feed = on,
            51 => self.speed = on,
            52 => self.adaptive = on,
            _ => self.hold = on,
        }
    }
}
