//! Directives, `#NAME [arguments]`: axes of plane and tool, profiles, and cycles described as text.

use crate::Fallible;
use crate::barrier::Present;
use crate::cycles::area::profile::{Element, Profile, ProfileError};
use crate::cycles::described::{Entry, Kind, Parameter, Part, Section};
use crate::dialect::Meaning;
use crate::interpreter::Interpreter;
use crate::stages::corner::CornerKind;
use crate::stages::units;
use crate::tool_axes::ToolAxes;
use crate::words::letters;
use ferrocut_geometry::{Arc, Axis, AxisName, Plane, Position, SAME_POINT_MM, Turn};
use ferrocut_machine::{Alarm, Fault};
use ferrocut_program::{Argument, Block, Page, Span, Statement, TextRange};
use ferrocut_toolpath::Op;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// What a directive does, by its first name.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Directive {
    /// `#TOOL AX [Z+]`.
    ToolAxis,
    /// `#SET AX [X,Y,Z]`.
    SetAxes,
    /// A cycle, by its second name.
    Cycle,
    /// A part of it.
    Part(Part),
    /// The figure on which it is repeated, by its second name.
    Figure,
    /// A profile begins, by its second name.
    Profile,
    /// It ends.
    EndProfile,
    /// Text for the operator.
    Message,
    /// Without effect on what this system does.
    NoEffect,
    /// Cycles of another kind of machine, which `OFF` takes back.
    OtherCycles,
}

/// Most elements of a profile.
const MOST_ELEMENTS: usize = 100_000;

/// Largest difference of an arc's start and end radius in a profile, mm.
const ARC_TOLERANCE: f64 = 0.01;

/// A profile as the program defines it.
#[derive(Clone, PartialEq, Debug)]
pub struct RecordedProfile {
    /// Its axes: abscissa and ordinate, or one of these and the tool axis.
    pub axes: ProfileAxes,
    /// Its contours in the order of definition.
    pub contours: Vec<Contour>,
}

/// The axes of a profile.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ProfileAxes {
    /// Abscissa and ordinate.
    Plane,
    /// One of these, by its place in the plane, and the tool axis: a profile of depth.
    Depth(usize),
}

/// A contour of a profile.
#[derive(Clone, PartialEq, Debug)]
pub struct Contour {
    /// Its elements, corners made.
    pub profile: Profile,
    /// The corner between its last element and its first, and its size.
    pub closing: Option<(CornerKind, f64)>,
    /// Radius of a tangential way in; 0 for none.
    pub entry: f64,
    /// The same of the way out.
    pub exit: f64,
}

/// The corner asked for behind an element, its size and the words; none for a sharp one.
type DraftCorner = Option<(CornerKind, f64, Span)>;

/// A contour being defined.
#[derive(Clone)]
struct Draft {
    start: [f64; 2],
    elements: Vec<(Element, DraftCorner)>,
    entry: f64,
    exit: f64,
}

/// A profile being defined.
#[derive(Clone)]
struct Recording {
    name: Box<str>,
    letters: [u8; 2],
    /// Letters of the centres of its arcs.
    centers: [u8; 2],
    axes: ProfileAxes,
    drafts: Vec<Draft>,
    at: [f64; 2],
    motion: Option<Meaning>,
    span: Span,
    count: usize,
}

/// The profiles of a program, and the one being defined.
#[derive(Clone, Default)]
pub struct Profiles {
    known: BTreeMap<Box<str>, RecordedProfile>,
    recording: Option<Box<Recording>>,
}

impl Profiles {
    /// The profile with this name.
    pub fn get(&self, name: &str) -> Option<&RecordedProfile> {
        self.known.get(name)
    }

    /// Whether blocks define a profile.
    #[inline]
    pub(crate) fn is_recording(&self) -> bool {
        self.recording.is_some()
    }
}

impl Interpreter {
    /// Whether a block continues the cycle that is being collected.
    pub(crate) fn continues_described(&self, page: &Page, block: &Block) -> bool {
        let Some(Statement::Directive(place)) = page.statement(block) else { return false };
        let Some(directive) = page.directive(*place) else { return false };
        let Some(first) = page.directive_names(directive).first() else { return false };
        let kind = self.directive_of(&self.text_of(page, *first));
        matches!(kind, Some(Directive::Part(_) | Directive::Figure))
    }

    fn directive_of(&self, name: &str) -> Option<Directive> {
        let of = |(n, kind): &(&str, Directive)| n.eq_ignore_ascii_case(name).then_some(*kind);
        self.dialect.directives.iter().find_map(of)
    }

    /// What stands in a range of a page.
    fn text_of(&self, page: &Page, range: TextRange) -> String {
        let span =
            Span { file: page.file, offset: page.offset + u64::from(range.at), len: range.len, line: 0 };
        self.programs.slice(span)
    }

    /// Carries out a directive.
    pub(crate) fn directive(&mut self, page: &Page, place: u32, span: Span) -> Fallible<()> {
        let Some(directive) = page.directive(place).copied() else { return Ok(()) };
        let names: Vec<String> =
            page.directive_names(&directive).iter().map(|name| self.text_of(page, *name)).collect();
        let first = names.first().map_or("", String::as_str);
        let second = names.get(1).map_or("", String::as_str);
        let arguments = page.directive_arguments(&directive);
        let Some(kind) = self.directive_of(first) else {
            let alarm = self.alarm(Fault::UnknownDirective, span);
            return Err(Box::new(alarm.with("word", format!("#{first}"))));
        };
        if self.described.profiles.is_recording() && kind != Directive::EndProfile {
            return Err(self.alarm(Fault::ProfileForm, span));
        }
        match kind {
            Directive::ToolAxis => self.tool_axis_directive(page, arguments, span),
            Directive::SetAxes => self.set_axes_directive(page, arguments, span),
            Directive::Cycle => {
                let found = self.dialect.described_cycles.iter().find(|c| c.id.eq_ignore_ascii_case(second));
                let Some(cycle) = found else {
                    let alarm = self.alarm(Fault::UnknownDirective, span);
                    return Err(Box::new(alarm.with("word", format!("#{first} {second}"))));
                };
                let parameters = cycle.parts.iter().find(|(part, _)| *part == Part::Main).map(|(_, p)| *p);
                let main = self.section(page, arguments, parameters.unwrap_or(&[]), None, span, span)?;
                self.begin_described(cycle, main, span)
            }
            Directive::Part(part) => {
                let at = self.described_span().unwrap_or(span);
                let Some(parameters) = self.part_of_described(part) else {
                    let alarm = self.alarm(Fault::DirectiveMisplaced, at);
                    return Err(Box::new(alarm.with("word", format!("#{first}"))));
                };
                let shared = self.shared_with_part(part);
                let section = self.section(page, arguments, parameters, shared, span, at)?;
                if !self.add_part(part, section) {
                    let alarm = self.alarm(Fault::RepeatedAddress, at);
                    return Err(Box::new(alarm.with("parameter", shared.map_or("", |p| p.name))));
                }
                Ok(())
            }
            Directive::Figure => {
                let at = self.described_span().unwrap_or(span);
                let found =
                    self.dialect.described_figures.iter().find(|f| f.name.eq_ignore_ascii_case(second));
                let Some(figure) = found.filter(|_| self.takes_figure()) else {
                    let fault =
                        if found.is_some() { Fault::DirectiveMisplaced } else { Fault::UnknownDirective };
                    let alarm = self.alarm(fault, at);
                    return Err(Box::new(alarm.with("word", format!("#{first} {second}"))));
                };
                let section = self.section(page, arguments, figure.parameters, None, span, at)?;
                self.add_figure(figure, section);
                Ok(())
            }
            Directive::Profile => {
                let bracket = arguments.first().map(|a| self.text_of(page, a.text));
                if names.len() > 2 && bracket.is_some() {
                    return Err(self.alarm(Fault::ProfileForm, span));
                }
                let plane = names.get(2).cloned().or(bracket);
                self.begin_profile(second, plane.map(|plane| plane.to_ascii_uppercase()).as_deref(), span)
            }
            Directive::EndProfile => self.end_profile(span),
            Directive::Message => {
                let text = arguments.first().map(|a| self.text_of(page, a.text)).unwrap_or_default();
                self.emit(Op::Message(text.trim_matches('"').into()));
                Ok(())
            }
            Directive::NoEffect => Ok(()),
            Directive::OtherCycles => {
                let on = second.eq_ignore_ascii_case("ON");
                if !on && !second.eq_ignore_ascii_case("OFF") {
                    let alarm = self.alarm(Fault::UnknownDirective, span);
                    return Err(Box::new(alarm.with("word", format!("#{first} {second}"))));
                }
                if on {
                    self.cancel_cycle();
                }
                self.described.other_cycles = on;
                Ok(())
            }
        }
    }

    /// Span of an argument in the block at `span`.
    fn argument_span(page: &Page, range: TextRange, span: Span) -> Span {
        Span { offset: page.offset + u64::from(range.at), len: range.len.max(1), ..span }
    }

    /// Reads arguments as parameters, of a list or `shared` with it. Their faults are told of the block at `at`, which is that of the cycle;
    /// where it is the arguments' own, of the argument.
    fn section(
        &mut self,
        page: &Page,
        arguments: &[Argument],
        parameters: &'static [Parameter],
        shared: Option<&'static Parameter>,
        span: Span,
        at: Span,
    ) -> Fallible<Section> {
        let mut section = Section::default();
        for argument in arguments {
            let name = self.text_of(page, argument.name);
            let place = if at == span { Interpreter::argument_span(page, argument.text, span) } else { at };
            let fail = |interpreter: &Interpreter, fault| -> Box<Alarm> {
                Box::new(interpreter.alarm(fault, place).with("parameter", name.clone()))
            };
            let Some(parameter) = parameters.iter().chain(shared).find(|p| p.name == name) else {
                return Err(fail(self, Fault::UnknownParameter));
            };
            let entry = match parameter.kind {
                Kind::Length | Kind::Number | Kind::NextTool => match self.argument_value(page, argument) {
                    Ok(Some(value)) if parameter.kind == Kind::Length => {
                        Entry::Number(units::length_mm(value, self.modal.is_inch()))
                    }
                    Ok(Some(value)) => Entry::Number(value),
                    Ok(None) if self.present == Present::Asked => return Ok(section),
                    Ok(None) => return Err(fail(self, Fault::ParameterKind)),
                    Err(fault) => return Err(fail(self, fault)),
                },
                Kind::Word(words) => {
                    let text = self.text_of(page, argument.text);
                    match words.iter().find(|word| word.eq_ignore_ascii_case(&text)) {
                        Some(word) => Entry::Word(word),
                        None => return Err(fail(self, Fault::ParameterKind)),
                    }
                }
                Kind::Name => match self.text_of(page, argument.text) {
                    text if text.is_empty() => return Err(fail(self, Fault::ParameterKind)),
                    text => Entry::Name(text.trim_matches('"').into()),
                },
                Kind::Point => match self.point_argument(page, argument) {
                    Ok(Some(entry)) => entry,
                    Ok(None) => return Err(fail(self, Fault::ParameterKind)),
                    Err(fault) => return Err(fail(self, fault)),
                },
            };
            if !section.put(parameter.name, entry) {
                return Err(fail(self, Fault::RepeatedAddress));
            }
        }
        Ok(section)
    }

    /// The number that an argument holds.
    fn argument_value(&mut self, page: &Page, argument: &Argument) -> Result<Option<f64>, Fault> {
        let Some(range) = argument.value else { return Ok(None) };
        let value = self.evaluate(page, range)?;
        Ok(value.filter(|value| value.is_finite()))
    }

    /// `[x, y]`, or with a corner `[x, y, round, 5]`; `[x, y, sharp]` is the same as none.
    fn point_argument(&mut self, page: &Page, argument: &Argument) -> Result<Option<Entry>, Fault> {
        let inch = self.modal.is_inch();
        let items = page.list(argument);
        let (x, y, corner) = match items {
            [x, y] => (x, y, None),
            [x, y, kind] | [x, y, kind, _] if self.text_of(page, kind.text).eq_ignore_ascii_case("sharp") => {
                (x, y, None)
            }
            [x, y, kind, size] => (x, y, Some((kind, size))),
            _ => return Ok(None),
        };
        let (Some(x), Some(y)) = (self.argument_value(page, x)?, self.argument_value(page, y)?) else {
            return Ok(None);
        };
        let at = [units::length_mm(x, inch), units::length_mm(y, inch)];
        let Some((kind, size)) = corner else { return Ok(Some(Entry::Point(at, None))) };
        let kind = match self.text_of(page, kind.text).to_ascii_lowercase().as_str() {
            "round" => CornerKind::Round,
            "chamfer" => CornerKind::Chamfer,
            _ => return Ok(None),
        };
        let Some(size) = self.argument_value(page, size)?.filter(|size| *size >= 0.0) else {
            return Ok(None);
        };
        Ok(Some(Entry::Point(at, Some((kind, units::length_mm(size, inch))))))
    }

    /// The axis that text names, `X` or `X2`.
    fn axis_named(&self, name: &str) -> Option<Axis> {
        let axis = match name.as_bytes() {
            [letter] => {
                Axis::from_letter(*letter).filter(|axis| !self.options.axis_names.renamed().contains(*axis))
            }
            [letter, digit] => self.options.axis_names.find(AxisName::numbered(*letter, *digit)?),
            _ => None,
        };
        axis.filter(|axis| self.rules.axes.contains(*axis))
    }

    fn axis_alarm(&self, name: &str, span: Span) -> Box<Alarm> {
        Box::new(self.alarm(Fault::UnknownAxis, span).with("axis", name.to_owned()))
    }

    fn tool_axis_directive(&mut self, page: &Page, arguments: &[Argument], span: Span) -> Fallible<()> {
        let [argument] = arguments else { return Err(self.alarm(Fault::PlaneAxes, span)) };
        let text = self.text_of(page, argument.text);
        let (name, sign) = match text.strip_suffix('-') {
            Some(name) => (name, -1.0),
            None => (text.strip_suffix('+').unwrap_or(&text), 1.0),
        };
        let Some(axis) = self.axis_named(name.trim()) else { return Err(self.axis_alarm(name, span)) };
        let tool = Some((axis, sign));
        self.set_tool_axes(ToolAxes { tool, ..self.tool_axes })
    }

    fn set_axes_directive(&mut self, page: &Page, arguments: &[Argument], span: Span) -> Fallible<()> {
        let mut axes = ToolAxes::default();
        if arguments.is_empty() || arguments.len() > Axis::ALL.len() {
            return Err(self.alarm(Fault::PlaneAxes, span));
        }
        for (slot, argument) in axes.axes.iter_mut().zip(arguments) {
            let name = self.text_of(page, argument.text);
            match self.axis_named(&name) {
                Some(axis) => *slot = axis,
                None => return Err(self.axis_alarm(&name, span)),
            }
        }
        let [a, b, c] = axes.axes;
        if a == b || b == c || a == c {
            return Err(self.alarm(Fault::PlaneAxes, span));
        }
        self.set_tool_axes(axes)
    }

    fn begin_profile(&mut self, name: &str, plane: Option<&str>, span: Span) -> Fallible<()> {
        let (letters, centers, axes) = match plane {
            None | Some("XY") => (*b"XY", *b"IJ", ProfileAxes::Plane),
            Some("XZ") => (*b"XZ", *b"IK", ProfileAxes::Depth(0)),
            Some("YZ") => (*b"YZ", *b"JK", ProfileAxes::Depth(1)),
            Some(_) => return Err(self.alarm(Fault::ProfileForm, span)),
        };
        if name.is_empty() {
            return Err(self.alarm(Fault::ProfileForm, span));
        }
        self.described.profiles.recording = Some(Box::new(Recording {
            name: name.into(),
            letters,
            centers,
            axes,
            drafts: Vec::new(),
            at: [0.0; 2],
            motion: None,
            span,
            count: 0,
        }));
        Ok(())
    }

    /// A block of words within a profile.
    pub(crate) fn profile_block(&mut self) -> Fallible<()> {
        let span = self.words.block_span();
        let Some(mut recording) = self.described.profiles.recording.take() else { return Ok(()) };
        let done = self.take_element(&mut recording, span);
        self.described.profiles.recording = Some(recording);
        done
    }

    fn take_element(&mut self, recording: &mut Recording, span: Span) -> Fallible<()> {
        let inch = self.modal.is_inch();
        let mm = |letter: u8| self.words.get(letter).map(|v| units::length_mm(v, inch));
        let form = |interpreter: &Interpreter| interpreter.alarm(Fault::ProfileForm, span);
        recording.count += 1;
        if recording.count > MOST_ELEMENTS || !self.words.m.is_empty() {
            return Err(form(self));
        }
        let mut special = None;
        for code in &self.words.g {
            match code.row.meaning {
                Meaning::Rapid | Meaning::Linear | Meaning::ArcClockwise | Meaning::ArcCounterClockwise => {
                    recording.motion = Some(code.row.meaning);
                }
                Meaning::ProfileRound
                | Meaning::ProfileChamfer
                | Meaning::ProfileEntry
                | Meaning::ProfileExit => special = Some(code.row.meaning),
                // Points of profiles are absolute.
                Meaning::Absolute => {}
                _ => return Err(form(self)),
            }
        }
        let is_round = matches!(recording.motion, Some(Meaning::ArcClockwise | Meaning::ArcCounterClockwise));
        // Of a depth profile I and J stand for the axes as drawn, unless K says otherwise.
        let centers = if self.words.has(b'K') { recording.centers } else { *b"IJ" };
        let of_shape = match special {
            Some(_) => letters(b"I"),
            None if is_round && self.words.has(b'R') => letters(&recording.letters) | letters(b"R"),
            None if is_round => letters(&recording.letters) | letters(&centers),
            None => letters(&recording.letters),
        };
        // A word that is left aside would make another profile than the one that is written.
        if self.words.has_any(!of_shape) || self.words.comma.is_some() {
            return Err(form(self));
        }
        if let Some(special) = special {
            let size = mm(b'I').filter(|size| *size >= 0.0).ok_or_else(|| form(self))?;
            let draft = recording.drafts.last_mut().ok_or_else(|| form(self))?;
            match special {
                Meaning::ProfileEntry => draft.entry = size,
                Meaning::ProfileExit => draft.exit = size,
                _ => {
                    let round = special == Meaning::ProfileRound;
                    let kind = if round { CornerKind::Round } else { CornerKind::Chamfer };
                    let Some((_, corner)) = draft.elements.last_mut() else { return Err(form(self)) };
                    *corner = Some((kind, size, span));
                }
            }
            return Ok(());
        }
        let [first, second] = recording.letters;
        let [x, y] = recording.at;
        let to = [mm(first).unwrap_or(x), mm(second).unwrap_or(y)];
        let motion = recording.motion.ok_or_else(|| form(self))?;
        let element = match motion {
            Meaning::Rapid => {
                recording.drafts.push(Draft { start: to, elements: Vec::new(), entry: 0.0, exit: 0.0 });
                recording.at = to;
                return Ok(());
            }
            Meaning::Linear => Element::Line { to },
            _ => {
                let turn =
                    if motion == Meaning::ArcClockwise { Turn::Clockwise } else { Turn::CounterClockwise };
                let [i, j] = centers;
                self.profile_arc(recording.at, to, turn, [mm(b'R'), mm(i), mm(j)])?
            }
        };
        let draft = recording.drafts.last_mut().ok_or_else(|| form(self))?;
        draft.elements.push((element, None));
        recording.at = to;
        Ok(())
    }

    /// An arc of a profile by R, or by its centre from its start; one that ends where it starts is a circle.
    fn profile_arc(
        &self,
        from: [f64; 2],
        to: [f64; 2],
        turn: Turn,
        [radius, i, j]: [Option<f64>; 3],
    ) -> Fallible<Element> {
        let span = self.words.block_span();
        let center = match radius {
            Some(r) => Arc::center_from_radius(from, to, r, turn, ARC_TOLERANCE)
                .map_err(|_| self.alarm_at(Fault::ArcRadiusTooSmall, b'R'))?,
            None if i.is_some() || j.is_some() => [from[0] + i.unwrap_or(0.0), from[1] + j.unwrap_or(0.0)],
            None => return Err(self.alarm(Fault::ArcWithoutCentre, span)),
        };
        let radius_at = |p: [f64; 2]| (p[0] - center[0]).hypot(p[1] - center[1]);
        let (start, end) = (radius_at(from), radius_at(to));
        if start < SAME_POINT_MM {
            return Err(self.alarm(Fault::ArcWithoutRadius, span));
        }
        if (start - end).abs() > ARC_TOLERANCE {
            let alarm = self.alarm(Fault::ArcRadiusMismatch, span);
            let alarm = alarm.with("start", start).with("end", end).with("limit", ARC_TOLERANCE);
            return Err(Box::new(alarm));
        }
        let place = |[x, y]: [f64; 2]| Position::xyz(x, y, 0.0);
        let same = (from[0] - to[0]).hypot(from[1] - to[1]) <= SAME_POINT_MM;
        let sweep = match (same, turn) {
            (true, Turn::Clockwise) => -TAU,
            (true, Turn::CounterClockwise) => TAU,
            _ => Arc::about(Plane::Xy, place(from), place(to), center, turn).sweep,
        };
        Ok(Element::Arc { to, center, sweep })
    }

    fn end_profile(&mut self, span: Span) -> Fallible<()> {
        let Some(recording) = self.described.profiles.recording.take() else {
            return Err(self.alarm(Fault::ProfileForm, span));
        };
        let mut contours = Vec::with_capacity(recording.drafts.len());
        for draft in recording.drafts {
            let Draft { start, mut elements, entry, exit } = draft;
            let is_closed = elements.last().is_some_and(|(last, _)| {
                let [x, y] = last.to();
                (x - start[0]).hypot(y - start[1]) <= SAME_POINT_MM
            });
            let closing = elements.last_mut().filter(|_| is_closed).and_then(|(_, corner)| corner.take());
            let closing = closing.map(|(kind, size, _)| (kind, size)).filter(|(_, size)| *size > 0.0);
            let profile = Profile::new(start, elements).map_err(|error| match error {
                ProfileError::Corner(at) => self.alarm(Fault::ProfileCorner, at),
                _ => self.alarm(Fault::ProfileForm, recording.span),
            })?;
            contours.push(Contour { profile, closing, entry, exit });
        }
        if contours.is_empty() {
            return Err(self.alarm(Fault::ProfileForm, recording.span));
        }
        let profile = RecordedProfile { axes: recording.axes, contours };
        self.described.profiles.known.insert(recording.name, profile);
        Ok(())
    }

    /// The alarm of a profile that the program ends in.
    pub(crate) fn unended_profile(&mut self) -> Option<Box<Alarm>> {
        let recording = self.described.profiles.recording.take()?;
        Some(self.alarm(Fault::ProfileForm, recording.span))
    }
}
