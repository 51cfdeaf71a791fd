//! PLT, the language of plotters (HP-GL), as far as it draws lines and arcs (Weihong 7).
//!
//! PU and PD raise and lower the pen and move on; PA and PR say whether points are absolute; AA and AR
//! are arcs, CI a circle, EA and ER rectangles, EW a wedge. Values are separated by commas or blanks,
//! `;` may end an instruction, capitals do not count. One that has no bearing on a path is left out with a
//! message for each kind; any other is an alarm, because what is cut might not be what is drawn. Angles of
//! chords are ignored: arcs are true arcs.

use crate::affine::sin_cos;
use crate::alarm;
use crate::curve::{Bend, Curve};
use crate::drawing::{Action, Drawing, LayerNames};
use crate::limits::Limits;
use crate::settings::{Format, ROUNDING, Settings};
use ferrocut_geometry::vector::{Point, sub};
use ferrocut_machine::{Alarm, Fault};
use ferrocut_program::{FileId, Span};
use rustc_hash::FxHashSet;
use std::f64::consts::TAU;

/// Instructions that have no bearing on a path: pens, speeds and forces, line types, letters, questions to the plotter.
const WITHOUT_EFFECT: &[&[u8; 2]] = &[
    b"SP", b"VS", b"VN", b"PT", b"LT", b"SI", b"LB", b"AP", b"AS", b"BL", b"BP", b"CA", b"CO", b"CP", b"CS",
    b"CT", b"DI", b"DR", b"DT", b"DV", b"EC", b"ES", b"FS", b"FT", b"MG", b"IM", b"LA", b"LO", b"MC", b"NP",
    b"NR", b"OA", b"OC", b"OD", b"OE", b"OF", b"OG", b"OH", b"OI", b"OP", b"OS", b"OW", b"PB", b"PC", b"PG",
    b"PS", b"PW", b"QL", b"RF", b"SA", b"SB", b"SD", b"SL", b"SM", b"SR", b"SS", b"TD", b"TL", b"TR", b"UL",
    b"VA", b"WU",
];

/// Those of them that draw letters or symbols, which are missing then.
const DRAWS: &[&[u8; 2]] = &[b"LB", b"PB", b"SM"];

/// End of a label, where DT does not name another.
const LABEL_END: u8 = 0x03;

/// Values of one instruction that has a fixed number of them, at most.
const MOST_VALUES: usize = 4;

/// Reads a drawing.
pub fn read(bytes: &[u8], file: FileId, settings: &Settings) -> Result<Drawing, Box<Alarm>> {
    // A text in UTF-8 may begin with a mark that says so.
    let begin = if bytes.starts_with(b"\xEF\xBB\xBF") { 3 } else { 0 };
    let mut reader = Reader {
        text: Text { bytes, at: begin, line: 1, file },
        settings,
        limits: Limits::new(),
        unit: settings.scale / settings.units_per_mm,
        drawing: Drawing::new(Format::Plt),
        pens: LayerNames::default(),
        pen: 0,
        at: [0.0; 2],
        z: None,
        is_down: false,
        is_lifted: false,
        is_relative: false,
        label_end: LABEL_END,
        told: FxHashSet::default(),
    };
    reader.select(b"");
    while let Some((name, span)) = reader.text.instruction()? {
        reader.carry_out(&name, span)?;
    }
    reader.drawing.end = reader.text.span(reader.text.at);
    Ok(reader.drawing)
}

struct Reader<'a> {
    text: Text<'a>,
    settings: &'a Settings,
    limits: Limits,
    /// Length of a plotter unit, mm.
    unit: f64,
    drawing: Drawing,
    pens: LayerNames,
    pen: u32,
    at: Point,
    z: Option<f64>,
    is_down: bool,
    /// In space it is above what it would have cut, had it not been left out.
    is_lifted: bool,
    is_relative: bool,
    label_end: u8,
    told: FxHashSet<[u8; 2]>,
}

impl Reader<'_> {
    fn carry_out(&mut self, name: &[u8; 2], span: Span) -> Result<(), Box<Alarm>> {
        match name {
            b"PU" => {
                // A point in space says itself how high the pen goes.
                if !(self.settings.three_dimensional && self.text.has_value()) {
                    self.raise(span)?;
                }
                self.is_down = false;
                self.points(span)
            }
            b"PD" => {
                if !(self.settings.three_dimensional && self.text.has_value()) {
                    self.lower(span)?;
                }
                self.is_down = true;
                self.points(span)
            }
            b"PA" | b"PR" => {
                self.is_relative = name == b"PR";
                self.points(span)
            }
            b"AA" | b"AR" => {
                let ([x, y, angle, _], span) = self.values(span, 3..=4)?;
                let center = self.point([x, y], name == b"AR", span)?;
                self.arc(center, angle, span)
            }
            b"CI" => {
                let ([radius, ..], span) = self.values(span, 1..=2)?;
                self.circle(radius * self.unit, span)
            }
            b"EA" | b"ER" => {
                let ([x, y, ..], span) = self.values(span, 2..=2)?;
                let corner = self.point([x, y], name == b"ER", span)?;
                self.rectangle(corner, span)
            }
            b"EW" => {
                let ([radius, start, angle, _], span) = self.values(span, 3..=4)?;
                self.wedge(radius * self.unit, start, angle.clamp(-360.0, 360.0), span)
            }
            b"SP" => {
                let (digits, span) = self.text.digits(span);
                if self.select(digits) {
                    return Ok(());
                }
                self.leave_out(name, span);
                Ok(())
            }
            b"LB" => {
                self.text.skip_label(self.label_end);
                self.leave_out(name, span);
                Ok(())
            }
            b"DT" => {
                if let Some(end) = self.text.peek().filter(|b| !matches!(b, b';' | b'\r' | b'\n')) {
                    self.label_end = end;
                    self.text.step();
                }
                self.leave_out(name, span);
                Ok(())
            }
            b"IN" | b"DF" => {
                // Both set the plotter back: points are absolute, labels end as they did, and IN raises the pen.
                self.is_relative = false;
                self.label_end = LABEL_END;
                if name == b"IN" && self.is_down {
                    self.raise(span)?;
                }
                self.text.skip_values(false);
                self.leave_out(name, span);
                Ok(())
            }
            b"SC" | b"IP" | b"RO" | b"IW" if !self.text.has_value() => {
                // Without values they set the standard that holds here in any case.
                self.leave_out(name, span);
                Ok(())
            }
            name if WITHOUT_EFFECT.contains(&name) => {
                // What they carry is of many kinds: everything up to their end.
                self.text.skip_values(matches!(name, b"BL" | b"CO" | b"PB"));
                self.leave_out(name, span);
                Ok(())
            }
            _ => {
                let instruction = String::from_utf8_lossy(name).into_owned();
                Err(Box::new(Alarm::core(Fault::PltUnknown, span).with("instruction", instruction)))
            }
        }
    }

    /// Notes an instruction that is passed over, once for each kind.
    fn leave_out(&mut self, name: &[u8; 2], span: Span) {
        if !self.told.insert(*name) {
            return;
        }
        let instruction = String::from_utf8_lossy(name).into_owned();
        let alarm = Alarm::core(Fault::PltLeftOut, span).with("instruction", instruction).as_warning();
        match DRAWS.contains(&name) {
            true => self.drawing.warnings.push(alarm),
            false => self.drawing.notes.push(alarm),
        }
    }

    /// Takes a pen; whether the settings say how it cuts.
    fn select(&mut self, number: &[u8]) -> bool {
        let name = String::from_utf8_lossy(number);
        let name = name.trim_start_matches('0');
        let settings = self.settings;
        self.pen = self.pens.number(name, &mut self.drawing, || settings.of_layer(Format::Plt, name));
        settings.pens.iter().any(|(pen, _)| &**pen == name)
    }

    fn raise(&mut self, span: Span) -> Result<(), Box<Alarm>> {
        self.is_down = false;
        self.z = Some(self.settings.pen_up);
        self.drawing.push(Action::Raise, None, self.pen, span)
    }

    fn lower(&mut self, span: Span) -> Result<(), Box<Alarm>> {
        self.is_down = true;
        self.z = Some(self.settings.cutting.depth);
        let action = if self.is_left_out() { Action::Raise } else { Action::Lower };
        self.drawing.push(action, None, self.pen, span)
    }

    /// The points behind PU, PD, PA and PR.
    fn points(&mut self, span: Span) -> Result<(), Box<Alarm>> {
        let dims = if self.settings.three_dimensional { 3 } else { 2 };
        while let Some((x, first)) = self.text.value()? {
            let mut values = [x, 0.0, 0.0];
            let mut point = first;
            for value in values.iter_mut().take(dims).skip(1) {
                let Some((v, at)) = self.text.value()? else {
                    return Err(alarm(Fault::PltArguments, span.to(first)));
                };
                *value = v;
                if at.line == first.line {
                    point = first.to(at);
                }
            }
            let [x, y, z] = values;
            let to = self.point([x, y], self.is_relative, point)?;
            let z = self.settings.three_dimensional.then(|| {
                let before = if self.is_relative { self.z.unwrap_or(0.0) } else { 0.0 };
                before + z * self.unit
            });
            self.go(to, z, point)?;
        }
        Ok(())
    }

    /// A point in mm.
    fn point(&self, units: [f64; 2], is_relative: bool, span: Span) -> Result<Point, Box<Alarm>> {
        let base = if is_relative { self.at } else { [0.0; 2] };
        let point = [base[0] + units[0] * self.unit, base[1] + units[1] * self.unit];
        self.limits.reach(point).map_err(|refused| refused.at(span))?;
        Ok(point)
    }

    /// Moves on, cutting if the pen is down. What is not cut is passed over at the height of a raised pen, however deep the drawing
    /// has it; from there the next cut begins straight down.
    fn go(&mut self, to: Point, z: Option<f64>, span: Span) -> Result<(), Box<Alarm>> {
        let from = self.at;
        self.at = to;
        let Some(z) = z else {
            let action = match self.is_down && !self.is_left_out() {
                true => Action::Cut(Curve::line(from, to)),
                false => Action::Travel(to),
            };
            return self.drawing.push(action, None, self.pen, span);
        };
        self.limits.reach([z, 0.0]).map_err(|refused| refused.at(span))?;
        let before = self.z.replace(z);
        if self.is_down && self.is_left_out() {
            if !std::mem::replace(&mut self.is_lifted, true) {
                self.drawing.push(Action::Raise, None, self.pen, span)?;
            }
            return self.drawing.push(Action::Travel(to), Some(self.settings.pen_up), self.pen, span);
        }
        let was_lifted = std::mem::replace(&mut self.is_lifted, false);
        if !self.is_down {
            return self.drawing.push(Action::Travel(to), Some(z), self.pen, span);
        }
        if let Some(before) = before.filter(|_| was_lifted) {
            let down = Action::Cut(Curve::line(from, from));
            self.drawing.push(down, Some(before), self.pen, span)?;
        }
        self.drawing.push(Action::Cut(Curve::line(from, to)), Some(z), self.pen, span)
    }

    /// Whether nothing is cut with this pen.
    fn is_left_out(&self) -> bool {
        self.drawing.layers.get(self.pen as usize).is_some_and(|pen| pen.cutting.is_none())
    }

    fn cut(&mut self, curve: Curve, span: Span) -> Result<(), Box<Alarm>> {
        if self.is_left_out() {
            return self.go(curve.to, None, span);
        }
        self.at = curve.to;
        self.drawing.cut(curve, self.settings.tolerance - ROUNDING, self.pen, span, &self.limits)
    }

    /// An arc from the present point about a centre. With the pen up it is a way to its end. One of more than a turn is a
    /// circle and what is left: a second time round cuts nothing.
    fn arc(&mut self, center: Point, degrees: f64, span: Span) -> Result<(), Box<Alarm>> {
        let arm = sub(self.at, center);
        if arm == [0.0; 2] || degrees == 0.0 {
            return Ok(());
        }
        if degrees.abs() > 360.0 {
            self.arc(center, 360.0_f64.copysign(degrees), span)?;
            return self.arc(center, degrees % 360.0, span);
        }
        if degrees.abs() == 360.0 {
            if !self.is_down {
                return Ok(());
            }
            let bend = Bend { center, sweep: TAU.copysign(degrees) };
            return self.cut(Curve { from: self.at, to: self.at, bend: Some(bend) }, span);
        }
        let (sin, cos) = sin_cos(degrees);
        let to = [center[0] + arm[0] * cos - arm[1] * sin, center[1] + arm[0] * sin + arm[1] * cos];
        if !self.is_down {
            self.limits.reach(to).map_err(|refused| refused.at(span))?;
            return self.go(to, None, span);
        }
        let bend = Bend { center, sweep: degrees.to_radians() };
        self.cut(Curve { from: self.at, to, bend: Some(bend) }, span)
    }

    /// A circle about the present point, from angle 0; point and pen are as before afterwards.
    fn circle(&mut self, radius: f64, span: Span) -> Result<(), Box<Alarm>> {
        let (center, was_down) = (self.at, self.is_down);
        let start = [center[0] + radius, center[1]];
        self.raise(span)?;
        self.limits.reach(start).map_err(|refused| refused.at(span))?;
        self.go(start, None, span)?;
        self.lower(span)?;
        if radius != 0.0 {
            self.cut(Curve::circle(center, start), span)?;
        }
        self.raise(span)?;
        self.go(center, None, span)?;
        if was_down { self.lower(span) } else { Ok(()) }
    }

    /// The edges of a rectangle from the present point on.
    fn rectangle(&mut self, corner: Point, span: Span) -> Result<(), Box<Alarm>> {
        let (start, was_down) = (self.at, self.is_down);
        self.lower(span)?;
        for to in [[corner[0], start[1]], corner, [start[0], corner[1]], start] {
            self.go(to, None, span)?;
        }
        if was_down { Ok(()) } else { self.raise(span) }
    }

    /// A piece of cake with its point at the present point. A negative radius turns it half round.
    fn wedge(&mut self, radius: f64, start: f64, degrees: f64, span: Span) -> Result<(), Box<Alarm>> {
        let (center, was_down) = (self.at, self.is_down);
        let (sin, cos) = sin_cos(start);
        self.lower(span)?;
        let from = [center[0] + radius * cos, center[1] + radius * sin];
        self.limits.reach(from).map_err(|refused| refused.at(span))?;
        self.go(from, None, span)?;
        self.arc(center, degrees, span)?;
        self.go(center, None, span)?;
        if was_down { Ok(()) } else { self.raise(span) }
    }

    /// The values of an instruction that has this many, the rest 0, and where all of it stands.
    fn values(
        &mut self,
        span: Span,
        count: std::ops::RangeInclusive<usize>,
    ) -> Result<([f64; MOST_VALUES], Span), Box<Alarm>> {
        let mut values = [0.0; MOST_VALUES];
        let (mut found, mut whole) = (0, span);
        while let Some((value, at)) = self.text.value()? {
            if let Some(place) = values.get_mut(found) {
                *place = value;
            }
            found += 1;
            if at.line == span.line {
                whole = span.to(at);
            }
        }
        if count.contains(&found) { Ok((values, whole)) } else { Err(alarm(Fault::PltArguments, whole)) }
    }
}

/// The text of a drawing, read from the start.
struct Text<'a> {
    bytes: &'a [u8],
    at: usize,
    line: u32,
    file: FileId,
}

impl<'a> Text<'a> {
    fn peek(&self) -> Option<u8> {
        self.bytes.get(self.at).copied()
    }

    fn step(&mut self) {
        // A line ends with LF, CR, or both.
        let after_cr = |at: usize| self.bytes.get(at + 1) == Some(&b'\n');
        match self.peek() {
            Some(b'\n') => self.line = self.line.saturating_add(1),
            Some(b'\r') if !after_cr(self.at) => self.line = self.line.saturating_add(1),
            _ => {}
        }
        self.at += 1;
    }

    /// The span from here to `end`.
    fn span(&self, end: usize) -> Span {
        let len = u32::try_from(end.saturating_sub(self.at)).unwrap_or(u32::MAX);
        Span { offset: self.at as u64, len, line: self.line, file: self.file }
    }

    /// The next instruction's letters in capitals; `None` at the end.
    fn instruction(&mut self) -> Result<Option<([u8; 2], Span)>, Box<Alarm>> {
        self.skip_between();
        let Some(first) = self.peek() else { return Ok(None) };
        let second = self.bytes.get(self.at + 1).copied().unwrap_or(0);
        let span = self.span((self.at + 2).min(self.bytes.len()));
        if !first.is_ascii_alphabetic() || !second.is_ascii_alphabetic() {
            let span = if first.is_ascii_alphabetic() { span } else { self.span(self.at + 1) };
            return Err(alarm(Fault::PltInstruction, span));
        }
        self.at += 2;
        Ok(Some(([first.to_ascii_uppercase(), second.to_ascii_uppercase()], span)))
    }

    /// Blanks, ends of instructions, and what is meant for the plotter's interface: escape sequences
    /// and job lines that begin with `@PJL`.
    fn skip_between(&mut self) {
        while let Some(byte) = self.peek() {
            match byte {
                0x1B => self.skip_escape(),
                b'@' if self.bytes.get(self.at..self.at + 4) == Some(b"@PJL") => {
                    while self.peek().is_some_and(|b| b != b'\n') {
                        self.step();
                    }
                }
                b';' | b',' | 0..=0x20 => self.step(),
                _ => return,
            }
        }
    }

    /// `ESC . letter values :` (the colon only behind values), `ESC % value letter`, `ESC letter`.
    fn skip_escape(&mut self) {
        self.step();
        let kind = self.peek();
        self.step();
        match kind {
            Some(b'.') => {
                self.step();
                while self.peek().is_some_and(|b| b.is_ascii_digit() || matches!(b, b';' | b',')) {
                    self.step();
                }
                if self.peek() == Some(b':') {
                    self.step();
                }
            }
            Some(b'%' | b'*' | b'&' | b'(' | b')') => {
                while self.peek().is_some_and(|b| !b.is_ascii_uppercase() && b > 0x20) {
                    self.step();
                }
                self.step();
            }
            _ => {}
        }
        // Stepping over the end leaves the end.
        self.at = self.at.min(self.bytes.len());
    }

    fn skip_separators(&mut self) {
        while self.peek().is_some_and(|b| matches!(b, b',' | b' ' | b'\t' | b'\r' | b'\n')) {
            self.step();
        }
    }

    /// Whether a value follows.
    fn has_value(&mut self) -> bool {
        self.skip_separators();
        self.peek().is_some_and(|b| b.is_ascii_digit() || matches!(b, b'+' | b'-' | b'.'))
    }

    /// The next value of the instruction; a sign begins a new one.
    fn value(&mut self) -> Result<Option<(f64, Span)>, Box<Alarm>> {
        if !self.has_value() {
            return Ok(None);
        }
        let rest = self.bytes.get(self.at + 1..).unwrap_or(&[]);
        let len = 1 + rest.iter().position(|b| !b.is_ascii_digit() && *b != b'.').unwrap_or(rest.len());
        let span = self.span(self.at + len);
        let text = self.bytes.get(self.at..self.at + len).unwrap_or(&[]);
        let value = std::str::from_utf8(text).ok().and_then(|t| t.parse::<f64>().ok());
        match value.filter(|v| v.is_finite()) {
            Some(value) => {
                self.at += len;
                Ok(Some((value, span)))
            }
            None => Err(alarm(Fault::PltArguments, span)),
        }
    }

    /// The digits behind SP.
    fn digits(&mut self, span: Span) -> (&'a [u8], Span) {
        self.skip_separators();
        let rest = self.bytes.get(self.at..).unwrap_or(&[]);
        let len = rest.iter().position(|b| !b.is_ascii_digit()).unwrap_or(rest.len());
        let whole = if self.line == span.line && len > 0 { span.to(self.span(self.at + len)) } else { span };
        self.at += len;
        (rest.get(..len).unwrap_or(&[]), whole)
    }

    /// The letters of a label up to its end mark, or where it has none up to the end of the line.
    fn skip_label(&mut self, end: u8) {
        let rest = self.bytes.get(self.at..).unwrap_or(&[]);
        let line = rest.iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(rest.len());
        let mark = rest.get(..line).unwrap_or(&[]).iter().position(|b| *b == end);
        self.at += mark.map_or(line, |at| at + 1);
    }

    /// What stands behind an instruction that is passed over: its values, or with `is_free` anything up
    /// to its end.
    fn skip_values(&mut self, is_free: bool) {
        while let Some(byte) = self.peek() {
            let belongs = match is_free {
                true => byte != b';',
                false => !byte.is_ascii_alphabetic() && !matches!(byte, b';' | 0x1B | b'@'),
            };
            if !belongs {
                return;
            }
            self.step();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, PI};

    fn drawing(text: &str) -> Drawing {
        read(text.as_bytes(), FileId(1), &Settings::default()).unwrap()
    }

    fn actions(text: &str) -> Vec<Action> {
        drawing(text).moves.iter().map(|m| m.action).collect()
    }

    use Action::{Cut, Lower, Raise, Travel};

    #[test]
    fn the_pen_goes_up_and_down_before_its_points() {
        let line = |from, to| Cut(Curve::line(from, to));
        assert_eq!(
            actions("PU400,800;PD1200 800,1200,1600;"),
            [
                Raise,
                Travel([10.0, 20.0]),
                Lower,
                line([10.0, 20.0], [30.0, 20.0]),
                line([30.0, 20.0], [30.0, 40.0])
            ]
        );
        // Relative until the next PA; no end marks, small letters, signs that separate.
        assert_eq!(
            actions("pu40,40 pr40-40 pd40,0 pa0,0"),
            [
                Raise,
                Travel([1.0, 1.0]),
                Travel([2.0, 0.0]),
                Lower,
                line([2.0, 0.0], [3.0, 0.0]),
                line([3.0, 0.0], [0.0, 0.0])
            ]
        );
    }

    #[test]
    fn arcs_turn_about_absolute_and_relative_centres() {
        let moves = actions("PU400,0;PD;AA0,0,90,5;AR-400,0,-180;");
        let [.., Cut(first), Cut(second)] = moves[..] else { panic!("{moves:?}") };
        assert_eq!(first.to, [0.0, 10.0]);
        assert_eq!(first.bend, Some(Bend { center: [0.0; 2], sweep: FRAC_PI_2 }));
        assert_eq!((second.from, second.to), ([0.0, 10.0], [-20.0, 10.0]));
        assert_eq!(second.bend, Some(Bend { center: [-10.0, 10.0], sweep: -PI }));
        // With the pen up one way to the end.
        assert_eq!(actions("PU400,0;AA0,0,90").last(), Some(&Travel([0.0, 10.0])));
        // More than a turn goes round and on.
        let moves = actions("PU400,0;PD;AA0,0,-450;");
        let sweeps: Vec<_> = moves
            .iter()
            .filter_map(
                |m| if let Cut(curve) = m { curve.bend.map(|bend| (curve.to, bend.sweep)) } else { None },
            )
            .collect();
        assert_eq!(sweeps, [([10.0, 0.0], -2.0 * PI), ([0.0, -10.0], -FRAC_PI_2)]);
    }

    #[test]
    fn figures_lower_the_pen_and_restore_it() {
        let circle = actions("PU800,800;CI200;");
        let arc = Curve::circle([20.0, 20.0], [25.0, 20.0]);
        assert_eq!(circle[2..], [Raise, Travel([25.0, 20.0]), Lower, Cut(arc), Raise, Travel([20.0, 20.0])]);
        assert_eq!(actions("PD;CI200;").last(), Some(&Lower));
        let edges = actions("PU400,400;ER-200,200;");
        let cuts = edges.iter().filter(|a| matches!(a, Cut(_))).count();
        assert_eq!((cuts, edges.last()), (4, Some(&Raise)));
        let wedge = actions("PU0,0;EW400,0,90;");
        let [.., Lower, Cut(out), Cut(arc), Cut(back), Raise] = wedge[..] else { panic!("{wedge:?}") };
        assert_eq!((out.to, arc.to, back.to), ([10.0, 0.0], [0.0, 10.0], [0.0, 0.0]));
        let half_round = actions("PU0,0;EW-400,0,90;");
        assert!(half_round.contains(&Cut(Curve::line([0.0; 2], [-10.0, 0.0]))));
    }

    #[test]
    fn what_does_not_bear_on_the_path_is_passed_over() {
        let text = "\x1b.(;\x1b.I81;;17:\x1b%0BIN;SP1;VS20;LBPU 9,9\x03PU0,0;SP2;PD40,0;@PJL x\nSP3";
        let drawing = drawing(text);
        assert_eq!(drawing.moves.len(), 4);
        let notes = |alarms: &[Alarm]| alarms.iter().map(|a| a.arguments[0].1.clone()).collect::<Vec<_>>();
        assert_eq!(notes(&drawing.notes), ["IN".into(), "SP".into(), "VS".into()]);
        assert_eq!(notes(&drawing.warnings), ["LB".into()]);
    }

    #[test]
    fn what_has_no_bearing_on_a_path_is_told_once() {
        let drawing = drawing("PU0,0;VS1,2;PD40,0;VS;CO a PD note;VS3");
        assert_eq!(drawing.moves.len(), 4);
        let spans: Vec<(u64, u32)> = drawing.notes.iter().map(|a| (a.span.offset, a.span.len)).collect();
        assert_eq!(spans, [(6, 2), (22, 2)]);
    }

    #[test]
    fn letters_are_missing_and_the_start_is_one() {
        assert_eq!(drawing("PU0,0;LBtext\x03PD40,0;").warnings.len(), 1);
        // IN: absolute again, and with the pen up.
        let moves = actions("PU0,0;PD40,0;PR;PD40,0;IN;PA400,400;");
        assert_eq!(moves[moves.len() - 2..], [Raise, Travel([10.0, 10.0])]);
        // IN and DF set back what DT says, and the text ends before the line.
        for set_back in ["IN", "DF"] {
            let moves = actions(&format!("DT#;{set_back};LBtext\x03PU0,0;PD40,0;"));
            assert_eq!(moves.last(), Some(&Cut(Curve::line([0.0, 0.0], [1.0, 0.0]))), "{set_back}");
        }
    }

    #[test]
    fn pens_with_a_depth_are_layers() {
        let deep = crate::settings::Change { depth: Some(-3.0), ..Default::default() };
        let settings = Settings { pens: vec![("2".into(), deep)], ..Settings::default() };
        let drawing = read(b"SP1;PU0,0;PD40,0;SP02;PD80,0;", FileId(1), &settings).unwrap();
        let depth = |m: &crate::drawing::Move| drawing.layers[m.layer as usize].cutting.unwrap().depth;
        let depths: Vec<f64> = drawing.moves.iter().map(depth).collect();
        assert_eq!(depths, [-1.0, -1.0, -1.0, -1.0, -3.0, -3.0]);
    }

    #[test]
    fn points_in_space_bring_their_height() {
        let settings = Settings { three_dimensional: true, ..Settings::default() };
        let drawing = read(b"PU40,40,200;PD40,40,-20;PR40,0,-20;PU;", FileId(1), &settings).unwrap();
        let found: Vec<_> = drawing.moves.iter().map(|m| (m.action, m.z)).collect();
        assert_eq!(
            found,
            [
                (Travel([1.0, 1.0]), Some(5.0)),
                (Cut(Curve::line([1.0, 1.0], [1.0, 1.0])), Some(-0.5)),
                (Cut(Curve::line([1.0, 1.0], [2.0, 1.0])), Some(-1.0)),
                (Raise, None)
            ]
        );
    }

    #[test]
    fn what_is_not_cut_in_space_is_passed_over_above_the_work() {
        let left_out = crate::settings::Change { skip: true, ..Default::default() };
        let settings =
            Settings { three_dimensional: true, pens: vec![("2".into(), left_out)], ..Settings::default() };
        let text = b"SP1;PU0,0,200;PD40,0,-40;SP2;PD80,0,-80,120,0,-80;SP1;PD160,0,-40;PU;";
        let drawing = read(text, FileId(1), &settings).unwrap();
        let found: Vec<_> = drawing.moves.iter().map(|m| (m.action, m.z)).collect();
        assert_eq!(
            found,
            [
                (Travel([0.0, 0.0]), Some(5.0)),
                (Cut(Curve::line([0.0, 0.0], [1.0, 0.0])), Some(-1.0)),
                (Raise, None),
                (Travel([2.0, 0.0]), Some(5.0)),
                (Travel([3.0, 0.0]), Some(5.0)),
                (Cut(Curve::line([3.0, 0.0], [3.0, 0.0])), Some(-2.0)),
                (Cut(Curve::line([3.0, 0.0], [4.0, 0.0])), Some(-1.0)),
                (Raise, None)
            ]
        );
    }

    #[test]
    fn a_mark_of_utf_8_may_stand_before_the_text() {
        let text = b"\xEF\xBB\xBFIN;PU0,0;PD40,0;";
        assert_eq!(read(text, FileId(1), &Settings::default()).unwrap().moves.len(), 4);
    }

    #[test]
    fn a_raised_pen_may_be_all_that_moves() {
        let raised = drawing("IN;SP1;PU400,400;PR-40,-80;");
        assert!(!raised.is_empty());
        for order in [crate::Order::AsDrawn, crate::Order::Shortest] {
            let moves = crate::plan::plan(&raised, order);
            assert_eq!(moves.last().map(|m| m.action), Some(Travel([9.0, 8.0])));
        }
        assert!(drawing("IN;SP1;PU;").is_empty());
        // What a pen would cut that is left out is no way of its own.
        let left_out = crate::settings::Change { skip: true, ..Default::default() };
        let settings = Settings { pens: vec![("1".into(), left_out)], ..Settings::default() };
        assert!(read(b"SP1;PU400,400;PD0,0;", FileId(1), &settings).unwrap().is_empty());
    }

    #[test]
    fn faults_point_at_their_place() {
        let fault = |text: &str| {
            let alarm = read(text.as_bytes(), FileId(1), &Settings::default()).unwrap_err();
            (alarm.fault, alarm.span.line, alarm.span.offset, alarm.span.len)
        };
        assert_eq!(fault("PU0,0;\nPD1,2,3;"), (Fault::PltArguments, 2, 7, 7));
        assert_eq!(drawing("SC;IP;RO;PU0,0;PD40,0;").moves.len(), 4);
        for name in ["XX1,2", "RA40,40", "SC0,1,0,1", "PE<=~"] {
            assert_eq!(fault(&format!("PU0,0;\n{name};PD40,0;")), (Fault::PltUnknown, 2, 7, 2), "{name}");
        }
        assert_eq!(fault("PU0,0;\r\n?"), (Fault::PltInstruction, 2, 8, 1));
        assert_eq!(fault("PU0,0;\rP"), (Fault::PltInstruction, 2, 7, 1));
        assert_eq!(fault("PU0,1.2.3;"), (Fault::PltArguments, 1, 4, 5));
        assert_eq!(fault("AA0,0;"), (Fault::PltArguments, 1, 0, 5));
        assert_eq!(fault("PU0,99999999999;").0, Fault::DrawingTooFar);
    }
}
