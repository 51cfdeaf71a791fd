//! What a program tells the machine itself: texts, outputs, inputs that it waits for, moves that inputs end
//! (Weihong 4.4).
//!
//! Addresses of the ladder are text in brackets, `PLC[04]`, or numbers; they are compared as numbers.

use crate::Fallible;
use crate::interpreter::Interpreter;
use crate::stages::units;
use crate::words::long;
use ferrocut_geometry::{Axis, Position};
use ferrocut_machine::Fault;
use ferrocut_program::Span;
use ferrocut_toolpath::{Feed, Op, Port};
use smallvec::SmallVec;

/// Numbers of M802 that the manual names.
mod internal {
    pub const LIMITS_OFF: u32 = 131_072;
    pub const LIMITS_ON: u32 = 131_073;
    pub const BUFFER_ON: u32 = 196_608;
    pub const BUFFER_OFF: u32 = 196_609;
    pub const CLEAR_EXTERNAL_OFFSET: u32 = 458_752;
}

/// Bits of an integer that a number holds exactly.
const PORTS: u16 = 52;

/// Inputs of programs that a machine has.
const MACHINE_PORTS: u16 = 16;

/// What ends a move of G904.
struct Signal {
    port: Port,
    is_off: bool,
}

/// An axis of G904 with its addresses: speed, input, level.
const AXES: [(Axis, u8, u8, u8); 3] = [
    (Axis::X, long::FX, long::PX, long::LX),
    (Axis::Y, long::FY, long::PY, long::LY),
    (Axis::Z, long::FZ, long::PZ, long::LZ),
];

impl Interpreter {
    /// M801: text for the operator; without text nothing.
    pub(crate) fn message(&mut self) {
        if let Some(text) = self.words.text(long::MSG) {
            let text = self.programs.slice(text);
            self.emit(Op::Message(text.into()));
        }
    }

    /// M802 P: a number for the control. Those of the manual are done here, any other is the machine's.
    pub(crate) fn internal_number(&mut self, span: Span) -> Fallible<()> {
        let Some(number) = self.whole_p()? else { return Err(self.missing("P", span)) };
        match number {
            internal::BUFFER_OFF => self.buffer_is_off = true,
            internal::BUFFER_ON => self.buffer_is_off = false,
            internal::LIMITS_OFF => self.tell_of(Fault::LimitsStay, span),
            // They were never off.
            internal::LIMITS_ON => {}
            internal::CLEAR_EXTERNAL_OFFSET => {
                self.memory.work.external = Position::ZERO;
                self.variable_writes += 1;
                self.work_zero_changed();
            }
            number => self.emit(Op::MachineNumber { code: 802, number }),
        }
        Ok(())
    }

    /// M903: the tool in the spindle has the number P, with the offsets that T calls (4.1); nothing is changed. The manual
    /// has no format for it: without P it is the tool that T called last.
    pub(crate) fn number_tool(&mut self) -> Fallible<()> {
        let tool = self.whole_p()?.unwrap_or(self.technology.tool);
        if f64::from(tool) > self.rules.max_tool {
            return Err(self.alarm_at(Fault::ToolNumber, b'P'));
        }
        // As the codes of T and M06, which the machine keeps back too.
        if !self.is_auxiliary_locked() {
            self.call_tool(tool);
            self.tool_comes()?;
            self.technology.in_spindle = tool;
            self.emit(Op::ToolNumber(tool));
        }
        Ok(())
    }

    /// P as a number for the machine. It is no word for the rest of the block.
    fn whole_p(&mut self) -> Fallible<Option<u32>> {
        let Some(p) = self.words.take(b'P') else { return Ok(None) };
        if p.fract() != 0.0 {
            return Err(self.alarm_at(Fault::WordNotWhole, b'P'));
        }
        if p < 0.0 {
            return Err(self.alarm_at(Fault::WordNegative, b'P'));
        }
        Ok(Some(p as u32))
    }

    /// G916 to G919 are of drives whose encoders latch their counts at a signal, and tell nobody what they come to but the
    /// control: none of their words is one for the rest of the block.
    pub(crate) fn encoder_latch(&mut self, span: Span) {
        self.words.take(b'H');
        self.tell_of(Fault::NoLatches, span);
    }

    /// Tells a check of a code that this control has no use for.
    fn tell_of(&mut self, fault: Fault, span: Span) {
        let warning = self.alarm(fault, span);
        self.tell(*warning);
    }

    /// A ladder address of the block, as it is written and as a number.
    fn port(&self, letter: u8) -> Option<(String, Option<f64>)> {
        if let Some(text) = self.words.text(letter) {
            let text = self.programs.slice(text).trim().to_owned();
            let number = text.parse().ok();
            return Some((text, number));
        }
        self.words.long(letter).map(|number| (number.to_string(), Some(number)))
    }

    fn missing(&self, name: &'static str, span: Span) -> Box<ferrocut_machine::Alarm> {
        Box::new(self.alarm(Fault::WordMissing, span).with("word", name))
    }

    /// The level of an input or output in a word of several letters: 0 or 1 (Weihong 4.4).
    fn level(&self, letter: u8, name: &str) -> Fallible<Option<f64>> {
        let level = self.words.long(letter);
        level.map(|level| self.checked_level(level, name, self.words.long_span(letter))).transpose()
    }

    fn checked_level(&self, level: f64, name: &str, span: Span) -> Fallible<f64> {
        if level != 0.0 && level != 1.0 {
            let alarm = self.alarm(Fault::WordOutOfRange, span).with("word", name);
            return Err(Box::new(alarm.with("min", 0.0).with("max", 1.0)));
        }
        Ok(level)
    }

    /// M901 PLC[..] LEVEL_, or in the older way H_ P_.
    pub(crate) fn set_output(&mut self, span: Span) -> Fallible<()> {
        // Neither is a word for the rest of the block.
        let old = self.words.take(b'H').map(|number| (number.to_string(), Some(number)));
        let Some((address, number)) = self.port(long::PLC).or(old) else {
            return Err(self.missing("PLC", span));
        };
        let at = self.words.span(b'P');
        let old_level = self.words.take(b'P').map(|p| self.checked_level(p, "P", at)).transpose()?;
        let Some(value) = self.level(long::LEVEL, "LEVEL")?.or(old_level) else {
            return Err(self.missing("LEVEL", span));
        };
        if let Some(port) = number.and_then(whole_port) {
            self.outputs.insert(port, value);
        }
        self.emit(Op::Output { port: Port::Named(address.into()), value, with_next_move: false });
        Ok(())
    }

    /// The state of an input; `None` for one that nobody simulates.
    fn input(&self, number: Option<f64>) -> Option<f64> {
        self.inputs.get(&number.and_then(whole_port)?).copied()
    }

    /// The inputs, or outputs, as bits of a number.
    pub(crate) fn ports_as_bits(&self, outputs: bool) -> f64 {
        let ports = if outputs { &self.outputs } else { &self.inputs };
        let bit =
            |(port, value): (&u16, &f64)| (*value != 0.0 && *port < PORTS).then(|| 2f64.powi((*port).into()));
        ports.iter().filter_map(bit).sum()
    }

    /// G906: motion comes to rest; with PLC the control then waits for an input, P ms at most. At a desk an
    /// input that nobody simulates is taken to come. What else the block has comes afterwards (4.4).
    pub(crate) fn wait_for_input(&mut self, span: Span) -> Fallible<()> {
        self.emit_barrier()?;
        let level = self.level(long::LEVEL, "LEVEL")?;
        let Some((address, number)) = self.port(long::PLC) else {
            // A level without its input: nothing would be waited for.
            return if level.is_some() { Err(self.missing("PLC", span)) } else { Ok(()) };
        };
        let Some(value) = level else { return Err(self.missing("LEVEL", span)) };
        // It is no word for the rest of the block.
        let timeout = self.words.take(b'P').map(|p| p.max(0.0) * self.rules.dwell_p_unit_s);
        self.emit(Op::Wait {
            port: Port::Named(address.into()),
            value,
            is_edge: false,
            timeout,
            must_come: true,
        });
        match self.input(number) {
            Some(state) if self.machine_waits.is_none() && (state != 0.0) != (value != 0.0) => {
                Err(self.alarm(Fault::InputMissing, span))
            }
            _ => Ok(()),
        }
    }

    /// G904: each axis moves with F, on the side of its sign, until its input has the level, X, Y, Z at most.
    /// On a machine with a ladder it is looked at there; at a desk the simulated skip signal stands for it. Without a
    /// distance the axis moves until then; at a desk where nobody simulates the signal, it is taken to be there.
    ///
    /// Axes that are programmed together move one after the other here, since each ends by a signal of its own.
    pub(crate) fn move_until_input(&mut self, span: Span) -> Fallible<()> {
        let inch = self.inch_axes();
        // Nothing moves where a word is missing of any axis.
        let mut moves = SmallVec::<[_; AXES.len()]>::new();
        for (axis, feed, port, level) in AXES {
            let given = [feed, port, level].map(|letter| self.words.has_long(letter));
            let distance = self.words.get(axis.letter() as u8);
            if given == [false; 3] && distance.is_none() {
                continue;
            }
            if let Some(at) = given.iter().position(|given| !given) {
                let name = ["F", "P", "L"].get(at).copied().unwrap_or("F");
                let word = format!("{name}{}", axis.letter());
                return Err(Box::new(self.alarm(Fault::WordMissing, span).with("word", word)));
            }
            let Some(speed) = self.words.long(feed).map(|f| units::coordinate(axis, f, inch)) else {
                return Err(self.alarm(Fault::WordMissing, self.words.long_span(feed)));
            };
            if speed == 0.0 {
                return Err(self.alarm(Fault::FeedOutOfRange, self.words.long_span(feed)));
            }
            let distance = distance.map(|d| units::coordinate(axis, d, inch).abs());
            let Some((address, _)) = self.port(port) else { return Err(self.missing("PX", span)) };
            let port = Port::Named(address.into());
            if self.machine_waits.is_some() && port.number().is_none_or(|port| port >= MACHINE_PORTS) {
                // It would never come.
                return Err(self.alarm(Fault::InputMissing, span));
            }
            let name = format!("L{}", axis.letter());
            let signal = Signal { port, is_off: self.level(level, &name)? == Some(0.0) };
            moves.push((axis, speed, distance, signal));
        }
        if moves.is_empty() {
            return Err(self.missing("FX", span));
        }
        for (axis, speed, distance, signal) in moves {
            self.move_axis_until(axis, speed, distance, signal, span)?;
        }
        self.emit_barrier()
    }

    fn move_axis_until(
        &mut self,
        axis: Axis,
        speed: f64,
        distance: Option<f64>,
        until: Signal,
        span: Span,
    ) -> Fallible<()> {
        let from = self.location.machine;
        let signal =
            self.options.skip.filter(|(of, _)| *of == axis).map(|(_, at)| (at - from[axis]) * speed.signum());
        // Behind the tool, or further than it may go, it does not come.
        let signal = signal.filter(|way| *way >= 0.0 && distance.is_none_or(|most| *way <= most));
        let (way, hit) = match (signal, distance) {
            (Some(way), _) => (way, true),
            (None, Some(most)) => (most, false),
            (None, None) => match self.machine_waits.or(self.probe) {
                // As far as the axis may go.
                Some((_, most)) if speed > 0.0 => ((most[axis] - from[axis]).max(0.0), false),
                Some((least, _)) => ((from[axis] - least[axis]).max(0.0), false),
                None => (0.0, true),
            },
        };
        // Where it ends is known too late for a path beside the programmed one, as with G31.
        let [first, second] = [self.modal.plane().first(), self.modal.plane().second()];
        if self.output.in_cutter_mode() && (axis == first || axis == second) {
            return Err(self.alarm(Fault::SkipInCutter, span));
        }
        let mut to = from;
        to[axis] += way * speed.signum();
        self.check_reach(to)?;
        self.location.machine = to;
        self.location.take_machine();
        if hit {
            self.location.skip = to - self.location.work.shift;
        }
        self.output.suspend_cutter();
        let feed = Feed::PerMinute(speed.abs());
        self.emit(Op::Skip { to, feed, hit, away: until.is_off, input: Some(until.port) });
        Ok(())
    }

    /// M902 H: the axis (0 to 3 for X, Y, Z, A) stands on its reference point, whose machine position the
    /// control knows.
    pub(crate) fn reference_reached(&mut self, span: Span) -> Fallible<()> {
        let at = self.words.span(b'H');
        let Some(number) = self.words.take(b'H') else { return Err(self.missing("H", span)) };
        let axis = [Axis::X, Axis::Y, Axis::Z, Axis::A].into_iter().find(|a| a.index() as f64 == number);
        let Some(axis) = axis.filter(|axis| self.rules.axes.contains(*axis)) else {
            return Err(self.alarm(Fault::ReferenceNumber, at));
        };
        self.output.flush().map_err(|(fault, span)| self.alarm(fault, span))?;
        let reference = self.memory.reference_points.first().copied().unwrap_or_default();
        self.location.machine[axis] = reference[axis];
        self.location.take_machine();
        self.emit(Op::Datum { at: self.location.machine });
        self.output.jump_to(self.location.machine);
        Ok(())
    }
}

/// A port number that inputs and outputs are kept by.
fn whole_port(number: f64) -> Option<u16> {
    (number.fract() == 0.0 && (0.0..=f64::from(u16::MAX)).contains(&number)).then_some(number as u16)
}
