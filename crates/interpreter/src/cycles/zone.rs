//! Cycles whose parameters stand behind their code, and their zone of influence (Fagor 1.1).
//!
//! From the code on, letters of the cycle's format are its parameters, whatever they mean elsewhere. The
//! cycle is made where its block leads, and then behind every move until it is cancelled. Coordinates are
//! turned into absolute ones where it is defined; `V.C.x` reads and changes them there.

use super::operation::Operation;
use super::parameter::WrongParameter;
use super::positions::{Figure, Omitted};
use super::{CycleKind, MAX_REPEATS};
use crate::Fallible;
use crate::dialect::{GCode, Meaning};
use crate::interpreter::Interpreter;
use crate::modal::Group;
use crate::stages::units;
use crate::words::{WordValues, letters, long};
use ferrocut_geometry::{AxisSet, SAME_POINT_MM, Turn};
use ferrocut_machine::{Alarm, Fault};
use ferrocut_program::Span;
use ferrocut_toolpath::SpindleState;

/// The parameters of a cycle, and what is made of them.
#[derive(Debug)]
pub struct WordFormat {
    /// Their letters; Z stands for the word of the tool axis.
    pub letters: &'static [u8],
    /// Those that are lengths.
    pub lengths: &'static [u8],
    /// The one that is the level of the bottom: with G91 it counts from the reference level.
    pub depth: Option<u8>,
    /// Makes an operation of them.
    pub build: fn(&Given<'_>) -> Result<Operation, WrongParameter>,
}

impl PartialEq for WordFormat {
    fn eq(&self, other: &WordFormat) -> bool {
        std::ptr::eq(self, other)
    }
}

impl Eq for WordFormat {}

/// What a cycle is made of. Lengths in mm, levels are coordinates of the tool axis.
#[derive(Clone, Copy, Debug)]
pub struct Given<'a> {
    /// The parameters.
    pub words: &'a WordValues,
    /// Reference level.
    pub reference: f64,
    /// Level to which the tool returns.
    pub top: f64,
    /// F in force, in its unit.
    pub feed: f64,
    /// F is a length a turn.
    pub feed_per_turn: bool,
    /// S in force, r/min.
    pub rpm: f64,
    /// Sense of the spindle.
    pub turn: Turn,
    /// The tool in the spindle.
    pub tool: ToolData,
}

/// What cycles know of a tool: mm, degrees.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct ToolData {
    /// Radius, wear included.
    pub radius: f64,
    /// Length of the cutting edge; 0 where not given.
    pub cutting_length: f64,
    /// Steepest entry angle; 0 where not given.
    pub entry_angle: f64,
    /// Radius of the rounded tip; 0 for a flat tool.
    pub tip_radius: f64,
}

/// Points on which the cycle in force is repeated, and its parameters (Fagor 2).
#[derive(Debug)]
pub struct FigureFormat {
    /// Letters of the parameters.
    pub letters: &'static [u8],
    /// Those that are lengths.
    pub lengths: &'static [u8],
    /// Makes a figure of them that begins at a point.
    pub build: fn(&WordValues, [f64; 2]) -> Result<Repetition, WrongParameter>,
}

impl PartialEq for FigureFormat {
    fn eq(&self, other: &FigureFormat) -> bool {
        std::ptr::eq(self, other)
    }
}

impl Eq for FigureFormat {}

/// A figure, and the way from point to point.
#[derive(Clone, PartialEq, Debug)]
pub struct Repetition {
    /// The figure.
    pub figure: Figure,
    /// Points that are passed by.
    pub omitted: Omitted,
    /// The way.
    pub travel: Travel,
    /// Its feed, where it has one of its own.
    pub feed: Option<f64>,
}

/// A way from point to point.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Travel {
    /// At rapid.
    Rapid,
    /// Straight at feed.
    Line,
    /// Along the circle at feed.
    Arc,
}

/// The state of the cycle in force.
#[derive(Clone, Debug, Default)]
pub(crate) struct Zone {
    /// Parameters, lengths in mm, coordinates absolute.
    words: WordValues,
    /// Reference level, and that of the tool where the cycle was defined.
    reference: f64,
    initial: f64,
    /// F and S where it was defined, and the code that says the unit of F.
    feed: f64,
    feed_mode: Option<&'static GCode>,
    speed: Option<f64>,
    /// Sense of the spindle, also while a cycle has stopped it; none once the program has.
    pub turn: Option<Turn>,
    /// What the present block still does before its operations.
    block: BlockOfZone,
    /// Points of a figure, and the one where the tool is.
    repetition: Option<(Repetition, u32)>,
}

/// What a block does besides the operation.
#[derive(Clone, Copy, Debug, Default)]
struct BlockOfZone {
    /// It moves, every time it is repeated.
    moves: bool,
    /// It defines the cycle.
    defines: Option<&'static WordFormat>,
    /// It is carried out by the zone.
    runs: bool,
}

impl Interpreter {
    /// The cycle by words in force.
    pub(crate) fn word_cycle(&self) -> Option<&'static WordFormat> {
        match self.cycle_kind() {
            Some(CycleKind::Words(format)) => Some(format),
            _ => None,
        }
    }

    /// Whether the present block is carried out by the zone: one of a cycle by words, or one that is repeated.
    pub(crate) fn is_zone_block(&self) -> bool {
        self.word_cycle().is_some() || self.words.has_long(long::NR)
    }

    /// Whether holes of the present block are the zone's.
    pub(crate) fn zone_runs(&self) -> bool {
        self.zone.block.runs
    }

    /// Forgets the cycle.
    pub(crate) fn leave_zone(&mut self) {
        self.zone = Zone::default();
    }

    /// Letters that belong to a code from its word on; Z stands for the tool axis.
    pub(crate) fn owned_letters(meaning: Meaning, tool_axis: u8) -> u32 {
        let of = match meaning {
            Meaning::Cycle(CycleKind::Words(format)) => format.letters,
            // The plane's own words are lengths of the figure.
            Meaning::Figure(format) => return letters(format.letters),
            _ => return 0,
        };
        let tool = if tool_axis.is_ascii_uppercase() { letters(&[tool_axis]) } else { 0 };
        letters(of) & !letters(b"Z") | tool
    }

    /// The cycle that the block defines.
    fn defined_cycle(&self) -> Option<&'static WordFormat> {
        self.words.g.iter().rev().find_map(|g| match g.row.meaning {
            Meaning::Cycle(CycleKind::Words(format)) => Some(format),
            _ => None,
        })
    }

    /// Whether a code that acts in its block alone leaves the point to the rest of the block: functions stand before the point
    /// and the cycle (Fagor 1.1.3), and these take no words of axes.
    pub(crate) fn leaves_point_to_block(&self, meaning: Meaning) -> bool {
        self.rules.functions_before_point && matches!(meaning, Meaning::Dwell | Meaning::PolarOrigin)
    }

    /// Whether the block moves or defines a cycle.
    pub(crate) fn has_point_or_cycle(&self, axes: AxisSet) -> bool {
        self.block_moves(axes) || self.defined_cycle().is_some()
    }

    /// Refuses a cycle beside a code that takes the words of its point, and either beside holes on a figure, which begin where
    /// the tool is with the cycle in force (2).
    pub(crate) fn refuse_beside_cycle(&self, meaning: Meaning, axes: AxisSet, span: Span) -> Fallible<()> {
        let is_figure = matches!(meaning, Meaning::Figure(_));
        let takes_point = is_figure || !self.leaves_point_to_block(meaning);
        let is_refused = takes_point && self.defined_cycle().is_some()
            || is_figure && (self.block_moves(axes) || self.words.has_long(long::NR));
        if is_refused { Err(self.alarm(Fault::NeedsOwnBlock, span)) } else { Ok(()) }
    }

    /// A block in the zone of influence, or one with NR.
    pub(crate) fn zone_block(&mut self, axes: AxisSet) -> Fallible<()> {
        let defines = self.defined_cycle();
        // The machined place would be beside the programmed one.
        if (defines.is_some() || self.word_cycle().is_some()) && self.output.in_cutter_mode() {
            return Err(self.alarm(Fault::NotInCutter, self.cycle_span()));
        }
        if defines.is_some() && self.described.other_cycles {
            let word = self.cycle_code().map(|code| format!("G{}", code.row.tenths / 10)).unwrap_or_default();
            return Err(Box::new(self.alarm(Fault::NotSupported, self.cycle_span()).with("word", word)));
        }
        let moves = self.block_moves(axes);
        let repeats = self.words.long(long::NR).unwrap_or(1.0);
        if repeats.fract() != 0.0 || !(0.0..=MAX_REPEATS).contains(&repeats) {
            let alarm = self.alarm(Fault::WordOutOfRange, self.words.long_span(long::NR));
            return Err(Box::new(alarm.with("min", 0.0).with("max", MAX_REPEATS)));
        }
        self.zone.repetition = None;
        self.zone.block = BlockOfZone { moves, defines, runs: true };
        if repeats == 0.0 {
            // 1.1.1: NR0 is the move alone.
            let done = self.zone_move(axes);
            self.zone.block.runs = false;
            return done;
        }
        if moves || defines.is_some() {
            self.cycle.holes_left = repeats as u32;
        } else {
            self.zone.block.runs = false;
        }
        Ok(())
    }

    /// The move of the block, and the definition behind it.
    fn zone_move(&mut self, axes: AxisSet) -> Fallible<()> {
        if self.zone.block.moves {
            self.motion_block(axes, false)?;
        }
        match self.zone.block.defines.take() {
            Some(format) => self.define_cycle(format),
            None => Ok(()),
        }
    }

    /// Makes the next move and operation of the present block.
    pub(crate) fn zone_hole(&mut self) -> Fallible<()> {
        if self.zone.repetition.is_some() {
            return self.next_point();
        }
        let axes = self.words.axes(self.rules.axes);
        self.zone_move(axes)?;
        match self.word_cycle() {
            Some(format) => self.make_cycle(format),
            None => Ok(()),
        }
    }

    /// Ends the block.
    pub(crate) fn end_zone_block(&mut self) {
        self.zone.block = BlockOfZone::default();
        self.zone.repetition = None;
    }

    /// Takes the words of the block as parameters.
    fn define_cycle(&mut self, format: &'static WordFormat) -> Fallible<()> {
        let [_, _, tool_axis] = self.plane_axes();
        let (inch, incremental) = (self.modal.is_inch(), self.modal.is_incremental());
        let initial = self.location.programmed[tool_axis];
        let own = self.words.own;
        let mm = |letter: u8, value: f64| match format.lengths.contains(&letter) {
            true => units::length_mm(value, inch),
            false => value,
        };
        let reference =
            own.get(tool_axis.letter() as u8).map(|z| units::coordinate(tool_axis, z, self.inch_axes()));
        let reference = match reference {
            Some(z) if incremental => initial + z,
            Some(z) => z,
            // Z = Zi (1.2).
            None => initial,
        };
        let mut words = WordValues::default();
        for letter in format.letters.iter().copied().filter(|letter| *letter != b'Z') {
            let Some(value) = own.get(letter).map(|value| mm(letter, value)) else { continue };
            let counts = format.depth == Some(letter) && incremental;
            words.put(letter, if counts { reference + value } else { value });
        }
        let (feed, feed_mode) = (self.feed_value(), self.modal.code(Group::FeedMode));
        let speed = self.technology.speed;
        let turn = self.technology.spindle.turn().unwrap_or(Turn::Clockwise);
        let block = self.zone.block;
        self.zone = Zone {
            words,
            reference,
            initial,
            feed,
            feed_mode,
            speed,
            turn: Some(turn),
            block,
            repetition: None,
        };
        Ok(())
    }

    /// F in force, in its unit.
    fn feed_value(&self) -> f64 {
        match self.modal.is_feed_per_revolution() {
            true => self.technology.feed_per_revolution,
            false => self.technology.feed_per_minute,
        }
    }

    /// Makes the cycle where the tool stands.
    fn make_cycle(&mut self, format: &'static WordFormat) -> Fallible<()> {
        self.feed()?;
        self.zone.turn = self.technology.spindle.turn().or(self.zone.turn);
        let turn = self.zone.turn.unwrap_or(Turn::Clockwise);
        let returns = self.modal.meaning(Group::Return) == Meaning::ReturnR;
        let given = Given {
            words: &self.zone.words,
            reference: self.zone.reference,
            top: if returns { self.zone.reference } else { self.zone.initial },
            feed: self.feed_value(),
            feed_per_turn: self.modal.is_feed_per_revolution(),
            rpm: self.technology.speed.unwrap_or(0.0),
            turn,
            tool: self.tool_data(self.technology.in_spindle, self.technology.edge),
        };
        let operation =
            (format.build)(&given).map_err(|wrong| self.wrong_parameter(wrong, self.cycle_span()))?;
        if operation.is_endless() {
            return Err(self.alarm(Fault::MillTooManyMoves, self.cycle_span()));
        }
        // A stopped spindle is started: clockwise, or as a cycle that stopped it found it (1.2, 1.5, 1.7).
        if self.technology.spindle == SpindleState::Off && !operation.begins_stopped() {
            self.turn_spindle(turn);
        }
        let [a, b, _] = self.in_plane_axes();
        self.make(&operation, [a, b])
    }

    /// G160 to G165: the cycle in force on the points of a figure.
    pub(crate) fn repeat_on_figure(&mut self, format: &'static FigureFormat, span: Span) -> Fallible<()> {
        if self.word_cycle().is_none() {
            return Err(self.alarm(Fault::PatternWithoutCycle, span));
        }
        let inch = self.modal.is_inch();
        let mut words = WordValues::default();
        for letter in format.letters.iter().copied() {
            if let Some(value) = self.words.own.get(letter) {
                let is_length = format.lengths.contains(&letter);
                words.put(letter, if is_length { units::length_mm(value, inch) } else { value });
            }
        }
        let [a, b, _] = self.in_plane_axes();
        let repetition = (format.build)(&words, [a, b]).map_err(|wrong| self.wrong_parameter(wrong, span))?;
        // All of them are made with the F and S of the definition, and F is that of the cycle afterwards (2), in its unit.
        if let Some(mode) = self.zone.feed_mode {
            self.modal.set(mode);
        }
        match self.modal.is_feed_per_revolution() {
            true => self.technology.feed_per_revolution = self.zone.feed,
            false => self.technology.feed_per_minute = self.zone.feed,
        }
        if self.technology.speed != self.zone.speed && self.zone.speed.is_some() {
            self.technology.speed = self.zone.speed;
            self.tell_speed();
        }
        let points = (2..=repetition.figure.count()).filter(|n| !repetition.omitted.contains(*n)).count();
        self.zone.block = BlockOfZone { moves: false, defines: None, runs: points > 0 };
        self.zone.repetition = Some((repetition, 1));
        self.cycle.holes_left = points as u32;
        Ok(())
    }

    /// Goes to the next point of the figure that is not left out, and makes the cycle there.
    fn next_point(&mut self) -> Fallible<()> {
        let Some((repetition, at)) = &mut self.zone.repetition else { return Ok(()) };
        let Some(next) = (*at + 1..=repetition.figure.count()).find(|n| !repetition.omitted.contains(*n))
        else {
            return Ok(());
        };
        let point = repetition.figure.point(next);
        let angle = repetition.figure.angle(*at, next);
        let (center, travel, feed) = (repetition.figure.center(), repetition.travel, repetition.feed);
        *at = next;
        self.travel(point, travel, center, angle, feed.unwrap_or(self.zone.feed))?;
        match self.word_cycle() {
            Some(format) => self.make_cycle(format),
            None => Ok(()),
        }
    }

    /// Value of a parameter of the cycle in force, in the units of the program.
    pub(crate) fn cycle_parameter(&self, letter: u8) -> Result<Option<f64>, Fault> {
        let Some(format) = self.word_cycle() else { return Err(Fault::NoCycleParameter) };
        let is_length = format.lengths.contains(&letter);
        let own = |value: f64| if is_length { units::from_mm(value, self.modal.is_inch()) } else { value };
        match self.is_reference_letter(letter) {
            true => Ok(Some(units::from_mm(self.zone.reference, self.modal.is_inch()))),
            false if format.letters.contains(&letter) => Ok(self.zone.words.get(letter).map(own)),
            false => Err(Fault::NoCycleParameter),
        }
    }

    /// Changes it: an absolute coordinate whatever G90 or G91 is in force (1.1.5).
    pub(crate) fn set_cycle_parameter(&mut self, letter: u8, value: f64) -> Result<(), Fault> {
        let Some(format) = self.word_cycle() else { return Err(Fault::NoCycleParameter) };
        let inch = self.modal.is_inch();
        if self.is_reference_letter(letter) {
            self.zone.reference = units::length_mm(value, inch);
            return Ok(());
        }
        if !format.letters.contains(&letter) {
            return Err(Fault::NoCycleParameter);
        }
        let is_length = format.lengths.contains(&letter);
        self.zone.words.put(letter, if is_length { units::length_mm(value, inch) } else { value });
        Ok(())
    }

    /// Whether a letter is that of the reference level: Z, and that of the tool axis.
    fn is_reference_letter(&self, letter: u8) -> bool {
        let [_, _, tool_axis] = self.plane_axes();
        letter == b'Z' || letter == tool_axis.letter() as u8
    }

    /// The alarm of a wrong parameter.
    pub(crate) fn wrong_parameter(&self, wrong: WrongParameter, span: Span) -> Box<Alarm> {
        let word = wrong.word.as_bytes();
        let span = match word {
            [letter] if self.words.own.get(*letter).is_some() => self.words.own_span(*letter),
            _ => span,
        };
        let mut alarm = self.alarm(wrong.fault, span);
        let name = match wrong.part {
            Some(part) => format!("{part} {}", wrong.word),
            None => wrong.word.to_owned(),
        };
        alarm.arguments.push(("parameter", name.into()));
        if let Some(contour) = wrong.contour {
            // People count from 1, the outer one.
            alarm.arguments.push(("contour", (contour as f64 + 1.0).into()));
        }
        if let Some([value, limit]) = wrong.values {
            // Rounded up or down towards what is allowed, as a person would read it.
            alarm.arguments.push(("value", value.into()));
            alarm.arguments.push(("limit", if limit.abs() < SAME_POINT_MM { 0.0 } else { limit }.into()));
        }
        alarm
    }
}
