//! Steps as JSON lines.
//!
//! One object a line in execution order. `to` names the axes whose commanded value changed;
//! coordinates are machine coordinates in mm and degrees, `f` mm/min, `frev` mm/rev, `sweep` signed
//! degrees, counter-clockwise positive. `line` is the 1-based source line; `file` stands only where
//! it is not the main program. A move that changes nothing is not written.

use crate::step::{Dwell, Feed, Op, Speed, SpindleState, Step};
use ferrocut_geometry::{Axis, AxisNames, Position};
use ferrocut_program::{FileId, Span};
use std::io::{self, Write};

/// Smallest change of a coordinate that a trace shows, mm or degrees: a nanometre.
const VISIBLE: f64 = 1e-6;

/// When the buffer is handed on to the writer.
const FLUSH_AT: usize = 1 << 16;

/// Writes steps to `W` as JSON lines.
pub struct TraceWriter<W: Write> {
    out: W,
    line: Vec<u8>,
    at: Position,
    /// What was shown of them last: an axis that was given another place without being moved is behind.
    shown: Position,
    main: FileId,
    file_names: Vec<Box<str>>,
    axis_names: AxisNames,
}

impl<W: Write> TraceWriter<W> {
    /// A trace of axes that stand at `start`.
    pub fn new(out: W, start: Position) -> TraceWriter<W> {
        TraceWriter {
            out,
            line: Vec::with_capacity(FLUSH_AT + 4096),
            at: start,
            shown: start,
            main: FileId(0),
            file_names: Vec::new(),
            axis_names: AxisNames::default(),
        }
    }

    /// Takes another file than the first as the main program, whose steps name no file.
    pub fn set_main(&mut self, file: FileId) {
        self.main = file;
    }

    /// Gives the axes the names under which they are shown.
    pub fn name_axes(&mut self, names: AxisNames) {
        self.axis_names = names;
    }

    /// Gives the name under which steps from `file` are shown.
    pub fn name_file(&mut self, file: FileId, name: &str) {
        let at = usize::from(file.0);
        if self.file_names.len() <= at {
            self.file_names.resize(at + 1, Box::from(""));
        }
        if let Some(slot) = self.file_names.get_mut(at) {
            *slot = Box::from(name);
        }
    }

    /// Whether [`name_file`](Self::name_file) was called for `file`.
    pub fn knows_file(&self, file: FileId) -> bool {
        file == self.main || self.file_names.get(usize::from(file.0)).is_some_and(|n| !n.is_empty())
    }

    /// Writes one step.
    pub fn step(&mut self, step: &Step) -> io::Result<()> {
        let mark = self.line.len();
        if !self.write_op(&step.op) {
            self.line.truncate(mark);
            return Ok(());
        }
        self.end_line(step.span)
    }

    /// Writes the alarm that ended the run. `number` is the dialect's own number where it has one.
    pub fn alarm(&mut self, number: Option<u16>, id: &str, text: &str, span: Span) -> io::Result<()> {
        self.op("alarm");
        match number {
            Some(n) => self.field("no", f64::from(n)),
            None => self.text("no", id),
        }
        self.text("text", text);
        self.end_line(span)
    }

    /// Hands everything on.
    pub fn finish(mut self) -> io::Result<()> {
        self.out.write_all(&self.line)?;
        self.out.flush()
    }

    fn end_line(&mut self, span: Span) -> io::Result<()> {
        self.line.extend_from_slice(b",\"line\":");
        write_integer(&mut self.line, u64::from(span.line));
        if span.file != self.main {
            let name = self.file_names.get(usize::from(span.file.0)).cloned().unwrap_or_default();
            self.text("file", &name);
        }
        self.line.extend_from_slice(b"}\n");
        if self.line.len() >= FLUSH_AT {
            self.out.write_all(&self.line)?;
            self.line.clear();
        }
        Ok(())
    }

    // Names are constants: inlined, their bytes are stored without a call.
    #[inline(always)]
    fn op(&mut self, name: &str) {
        self.line.extend_from_slice(b"{\"op\":\"");
        self.line.extend_from_slice(name.as_bytes());
        self.line.push(b'"');
    }

    #[inline(always)]
    fn key(&mut self, key: &str) {
        self.line.extend_from_slice(b",\"");
        self.line.extend_from_slice(key.as_bytes());
        self.line.extend_from_slice(b"\":");
    }

    #[inline(always)]
    fn field(&mut self, key: &str, value: f64) {
        self.key(key);
        write_number(&mut self.line, value);
    }

    fn text(&mut self, key: &str, value: &str) {
        self.key(key);
        write_text(&mut self.line, value);
    }

    fn flag(&mut self, key: &str, value: bool) {
        self.key(key);
        self.line.extend_from_slice(if value { b"true" } else { b"false" });
    }

    fn code(&mut self, code: u32) {
        self.key("code");
        self.line.extend_from_slice(b"\"M");
        if code < 10 {
            self.line.push(b'0');
        }
        write_integer(&mut self.line, u64::from(code));
        self.line.push(b'"');
    }

    /// Writes `to` and remembers it; false if no coordinate changed visibly. Named are the axes that move, and those that were
    /// given another position since they were shown.
    fn to(&mut self, to: &Position) -> bool {
        let differs = |a: &Position, b: &Position, axis| (a[axis] - b[axis]).abs() >= VISIBLE;
        if !Axis::ALL.into_iter().any(|axis| differs(to, &self.at, axis)) {
            return false;
        }
        let mut any = false;
        for axis in Axis::ALL {
            if differs(to, &self.at, axis) || differs(&self.at, &self.shown, axis) {
                self.line.extend_from_slice(if any { b",\"" } else { b",\"to\":{\"" });
                any = true;
                self.line.extend(self.axis_names.name(axis).bytes());
                self.line.extend_from_slice(b"\":");
                write_number(&mut self.line, to[axis]);
            }
        }
        self.line.push(b'}');
        (self.at, self.shown) = (*to, *to);
        true
    }

    fn feed(&mut self, feed: Feed) {
        match feed {
            Feed::PerMinute(f) | Feed::Held { at: f, .. } => self.field("f", f),
            Feed::PerRevolution(f) => self.field("frev", f),
            Feed::Duration(s) => self.field("duration", s),
        }
    }

    /// Writes the op's own keys; false if there is nothing to show.
    fn write_op(&mut self, op: &Op) -> bool {
        match op {
            Op::Rapid { to, .. } => {
                self.op("rapid");
                return self.to(to);
            }
            Op::Feed { to, feed, .. } => {
                self.op("feed");
                if !self.to(to) {
                    return false;
                }
                self.feed(*feed);
            }
            Op::Arc { to, plane, center, sweep, feed, .. } => {
                self.op("arc");
                // A full circle ends where it began and is a move all the same: its plane's axes
                // are named with the values they come back to.
                if !self.to(to) {
                    self.key("to");
                    self.line.extend_from_slice(b"{\"");
                    self.line.extend_from_slice(plane.first().name().as_bytes());
                    self.line.extend_from_slice(b"\":");
                    write_number(&mut self.line, to[plane.first()]);
                    self.line.extend_from_slice(b",\"");
                    self.line.extend_from_slice(plane.second().name().as_bytes());
                    self.line.extend_from_slice(b"\":");
                    write_number(&mut self.line, to[plane.second()]);
                    self.line.push(b'}');
                }
                self.text("plane", plane.name());
                self.key("center");
                self.line.push(b'[');
                write_number(&mut self.line, center[0]);
                self.line.push(b',');
                write_number(&mut self.line, center[1]);
                self.line.push(b']');
                self.field("sweep", sweep.to_degrees());
                self.feed(*feed);
            }
            Op::Tap { to, pitch, rpm, .. } => {
                self.op("tap");
                if !self.to(to) {
                    return false;
                }
                self.field("pitch", *pitch);
                self.field("rpm", *rpm);
            }
            Op::Skip { to, feed, hit, away, .. } => {
                self.op("skip");
                // A signal that is there from the start is worth a line, though nothing moves.
                if !self.to(to) && !hit {
                    return false;
                }
                self.feed(*feed);
                self.flag("hit", *hit);
                if *away {
                    self.flag("away", true);
                }
            }
            // Nothing that an axis is commanded to do.
            Op::Barrier => return false,
            Op::Dwell(Dwell::Seconds(s)) => {
                self.op("dwell");
                self.field("s", *s);
            }
            Op::Dwell(Dwell::Revolutions(r)) => {
                self.op("dwell");
                self.field("rev", *r);
            }
            Op::Spindle(state) => {
                self.op("spindle");
                let dir = match state {
                    SpindleState::Off => "off",
                    SpindleState::Clockwise(_) => "cw",
                    SpindleState::CounterClockwise(_) => "ccw",
                };
                self.text("dir", dir);
                match state.speed() {
                    None => self.field("rpm", 0.0),
                    Some(Speed::Rpm(rpm)) => self.field("rpm", rpm),
                    Some(Speed::Surface { mm_per_min, max_rpm, .. }) => {
                        self.field("css", mm_per_min);
                        if let Some(max) = max_rpm {
                            self.field("max", max);
                        }
                    }
                }
            }
            Op::Orient(deg) => {
                self.op("orient");
                self.field("deg", *deg);
            }
            Op::Coolant(on) => {
                self.op("coolant");
                self.flag("on", *on);
            }
            Op::Select(t) => {
                self.op("select");
                self.field("t", f64::from(*t));
            }
            Op::Change(t) => {
                self.op("change");
                self.field("t", f64::from(*t));
            }
            Op::Machine(code) => {
                self.op("m");
                self.field("code", f64::from(*code));
            }
            Op::MachineNumber { code, number } => {
                self.op("m");
                self.field("code", f64::from(*code));
                self.field("p", f64::from(*number));
            }
            Op::ToolNumber(t) => {
                self.op("m");
                self.field("code", 903.0);
                self.field("p", f64::from(*t));
            }
            Op::Output { port, value, .. } => {
                self.op("out");
                self.text("addr", &port.to_string());
                self.field("value", *value);
            }
            Op::Wait { port, value, timeout, .. } => {
                self.op("wait");
                self.text("addr", &port.to_string());
                self.field("value", *value);
                match timeout {
                    Some(seconds) => self.field("timeout", *seconds),
                    None => {
                        self.key("timeout");
                        self.line.extend_from_slice(b"null");
                    }
                }
            }
            Op::Datum { at } => {
                // No axis is commanded anything; the next move shows the new position.
                self.at = *at;
                return false;
            }
            Op::Home(axes) => {
                self.op("home");
                self.key("axes");
                self.line.push(b'[');
                for (i, axis) in axes.iter().enumerate() {
                    if i > 0 {
                        self.line.push(b',');
                    }
                    self.line.push(b'"');
                    self.line.extend(self.axis_names.name(axis).bytes());
                    self.line.push(b'"');
                }
                self.line.push(b']');
            }
            Op::Stop(code) => {
                self.op("stop");
                self.code(*code);
            }
            Op::End(code) => {
                self.op("end");
                self.code(*code);
            }
            Op::Message(text) => {
                self.op("message");
                self.text("text", text);
            }
        }
        true
    }
}

/// Room for the digits of any number that is written in one go: 20 of an integer, point, 6 places, sign.
const DIGITS: usize = 32;

/// Writes the digits of `n` in front of `at`; where they begin.
#[inline]
fn digits(buffer: &mut [u8; DIGITS], mut at: usize, mut n: u64) -> usize {
    loop {
        at -= 1;
        buffer[at] = b'0' + (n % 10) as u8;
        n /= 10;
        if n == 0 {
            return at;
        }
    }
}

fn write_integer(out: &mut Vec<u8>, n: u64) {
    let mut buffer = [0u8; DIGITS];
    let at = digits(&mut buffer, DIGITS, n);
    out.extend_from_slice(&buffer[at..]);
}

/// Writes `v` rounded to a nanometre, without trailing zeros.
fn write_number(out: &mut Vec<u8>, v: f64) {
    const UNIT: f64 = 1e6;
    // Integers up to 2^53 are exact in f64; larger or not finite values take the long way.
    if v.is_nan() || v.abs() >= 9e15 / UNIT {
        if v.is_finite() {
            // Writing to a Vec cannot fail.
            let _ = write!(out, "{v}");
        } else {
            out.extend_from_slice(b"null");
        }
        return;
    }
    let magnitude = (v.abs() * UNIT + 0.5) as u64;
    let mut buffer = [0u8; DIGITS];
    let mut at = DIGITS;
    let mut fraction = magnitude % 1_000_000;
    if fraction != 0 {
        let mut places = 6;
        while fraction.is_multiple_of(10) {
            fraction /= 10;
            places -= 1;
        }
        for _ in 0..places {
            at -= 1;
            buffer[at] = b'0' + (fraction % 10) as u8;
            fraction /= 10;
        }
        at -= 1;
        buffer[at] = b'.';
    }
    at = digits(&mut buffer, at, magnitude / 1_000_000);
    if v < 0.0 && magnitude != 0 {
        at -= 1;
        buffer[at] = b'-';
    }
    out.extend_from_slice(&buffer[at..]);
}

fn write_text(out: &mut Vec<u8>, text: &str) {
    out.push(b'"');
    for c in text.chars() {
        match c {
            '"' => out.extend_from_slice(b"\\\""),
            '\\' => out.extend_from_slice(b"\\\\"),
            '\n' => out.extend_from_slice(b"\\n"),
            '\r' => out.extend_from_slice(b"\\r"),
            '\t' => out.extend_from_slice(b"\\t"),
            c if (c as u32) < 0x20 => {
                let _ = write!(out, "\\u{:04x}", c as u32);
            }
            c => {
                let mut buffer = [0; 4];
                out.extend_from_slice(c.encode_utf8(&mut buffer).as_bytes());
            }
        }
    }
    out.push(b'"');
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::step::PathMode;
    use ferrocut_geometry::Plane;

    fn number(v: f64) -> String {
        let mut out = Vec::new();
        write_number(&mut out, v);
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn numbers_are_short_and_right() {
        for (v, text) in [
            (0.0, "0"),
            (-0.0, "0"),
            (12.5, "12.5"),
            (-0.000_001, "-0.000001"),
            (0.1 + 0.2, "0.3"),
            (99_999.999, "99999.999"),
            (1e-9, "0"),
            (1e20, "100000000000000000000"),
            (f64::NAN, "null"),
            (0.100_001, "0.100001"),
        ] {
            assert_eq!(number(v), text);
        }
    }

    #[test]
    fn a_code_has_the_number_that_it_hands_over() {
        let mut out = Vec::new();
        let mut trace = TraceWriter::new(&mut out, Position::ZERO);
        let span = Span { line: 7, ..Span::default() };
        for op in [Op::Machine(10), Op::MachineNumber { code: 802, number: 196_611 }, Op::ToolNumber(4)] {
            trace.step(&Step::new(op, span, 0)).unwrap();
        }
        trace.finish().unwrap();
        assert_eq!(
            String::from_utf8(out).unwrap(),
            "{\"op\":\"m\",\"code\":10,\"line\":7}\n\
             {\"op\":\"m\",\"code\":802,\"p\":196611,\"line\":7}\n\
             {\"op\":\"m\",\"code\":903,\"p\":4,\"line\":7}\n"
        );
    }

    #[test]
    fn an_axis_with_a_new_position_is_named_by_the_next_move() {
        let mut out = Vec::new();
        let mut trace = TraceWriter::new(&mut out, Position::xyz(1.0, 6.0, 0.0));
        let rapid = |to| Op::Rapid { to, straight: true, speed: None, path: PathMode::ON_PATH };
        let renamed = Position::xyz(1.0, 0.0, 0.0);
        // The last one goes to the place that was shown first.
        let ops = [
            Op::Datum { at: renamed },
            rapid(renamed),
            rapid(Position::xyz(3.0, 0.0, 0.0)),
            Op::Datum { at: Position::xyz(3.0, 5.0, 0.0) },
            rapid(Position::xyz(3.0, 0.0, 0.0)),
        ];
        for op in ops {
            trace.step(&Step::new(op, Span { line: 1, ..Span::default() }, 0)).unwrap();
        }
        trace.finish().unwrap();
        assert_eq!(
            String::from_utf8(out).unwrap(),
            "{\"op\":\"rapid\",\"to\":{\"x\":3,\"y\":0},\"line\":1}\n{\"op\":\"rapid\",\"to\":{\"y\":0},\"line\":1}\n"
        );
    }

    #[test]
    fn a_move_that_changes_nothing_is_left_out_but_a_full_circle_is_not() {
        let mut out = Vec::new();
        let at = Position::xyz(1.0, 2.0, 3.0);
        let mut trace = TraceWriter::new(&mut out, at);
        let span = Span { line: 7, ..Span::default() };
        trace
            .step(&Step::new(
                Op::Rapid { to: at, straight: true, speed: None, path: PathMode::ON_PATH },
                span,
                0,
            ))
            .unwrap();
        let feed = Feed::PerMinute(100.0);
        let path = PathMode::Continuous;
        let circle = Op::Arc {
            to: at,
            plane: Plane::Xy,
            center: [0.0, 2.0],
            sweep: std::f64::consts::TAU,
            feed,
            feed_along: crate::step::FeedAlong::Path,
            path,
        };
        trace.step(&Step::new(circle, span, 0)).unwrap();
        trace.finish().unwrap();
        assert_eq!(
            String::from_utf8(out).unwrap(),
            "{\"op\":\"arc\",\"to\":{\"x\":1,\"y\":2},\"plane\":\"xy\",\"center\":[0,2],\"sweep\":360,\"f\":100,\"line\":7}\n"
        );
    }
}
