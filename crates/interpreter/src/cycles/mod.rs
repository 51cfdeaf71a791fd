//! Canned cycles: one block that stands for the moves of a hole.
//!
//! What a cycle does is data ([`CycleKind`], [`Rules`]), so that a dialect's tables say it and the code is one.
//! The frame is common (GSK990MC 4.4): position, rapid to the R level, the work, rapid back to the R
//! level or to the initial one. Hole data are modal until the cycle is cancelled. [`hole`](self) drills
//! and bores, `tap` taps, `bore` has the borings that move the tool aside, [`milling`] pockets and walls,
//! [`pocket`] pockets of any profile.

pub mod acts;
pub mod area;
mod bore;
pub mod bore_milling;
pub mod boring;
pub mod depth;
pub mod described;
pub mod drilling;
mod hole;
mod mill;
pub mod milling;
pub mod operation;
pub mod parameter;
mod pattern;
pub mod pocket;
pub mod positions;
#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::expect_used)]
pub(crate) mod programs;
mod rules;
mod tap;
pub mod tapping;
pub mod thread_milling;
pub mod tool;
pub mod zone;

pub use mill::MillShape;
use mill::MillWords;
pub use pattern::Pattern;
use pattern::Places;
pub use rules::{NoDepth, Repeat, Restart, RigidSpeeds, Rules, Tapping};

use crate::Fallible;
use crate::dialect::{GCode, Meaning};
use crate::execute::{Part, Rest};
use crate::interpreter::Interpreter;
use crate::modal::Group;
use crate::stages::units;
use crate::words::{Code, letters};
use ferrocut_geometry::{Axis, AxisSet, Plane, Position, Turn};
use ferrocut_machine::Fault;
use ferrocut_program::Span;
use ferrocut_toolpath::{Dwell, Op, PathMode, SpindleState};

/// How a hole is cut.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Peck {
    /// In one go.
    None,
    /// In steps, drawn back a little after each (G73).
    ChipBreak,
    /// In steps, drawn out of the hole after each (G83).
    Clear,
}

/// How the tool leaves a hole.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Retract {
    /// At rapid.
    Rapid,
    /// At feed, to the R level (G85, G89).
    Feed,
    /// At rapid with the spindle at rest, which starts again at the top (G86).
    SpindleStopped,
    /// By the operator, with the spindle at rest, which starts again at the top (G88).
    ByHand,
    /// At feed, to the R level, with the spindle at rest, which starts again at the top (G88 of Weihong).
    FeedSpindleStopped,
}

/// A drilling or boring cycle.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct HoleCycle {
    /// How the hole is cut.
    pub peck: Peck,
    /// Pause of P at the bottom.
    pub dwell: bool,
    /// How the tool leaves it.
    pub retract: Retract,
}

/// What kind of canned cycle a code starts.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum CycleKind {
    /// Drilling and boring.
    Hole(HoleCycle),
    /// Tapping of a right-hand (G84) or left-hand thread (G74).
    Tap {
        /// Left-hand thread.
        left: bool,
    },
    /// Fine boring: out with the tool moved aside (G76).
    FineBore,
    /// Back boring: from below upwards (G87).
    BackBore,
    /// A pocket or wall (G22 to G26, G32 to G38).
    Mill {
        /// What is cut.
        shape: MillShape,
        /// The way round.
        turn: Turn,
    },
    /// One whose parameters stand behind its code, with a zone of influence.
    Words(&'static zone::WordFormat),
    /// A program of the shop for a code that the control lacks.
    Own,
}

impl CycleKind {
    /// Axes of which the addresses are words of its own (GSK990MC table 3-1-3-1).
    fn own_axes(self) -> AxisSet {
        match self {
            CycleKind::Mill { .. } => AxisSet::EMPTY.with(Axis::U).with(Axis::V).with(Axis::W),
            CycleKind::Tap { .. } => AxisSet::EMPTY.with(Axis::V),
            _ => AxisSet::EMPTY,
        }
    }

    /// Whether P is a word of its own.
    pub(crate) fn takes_p(self) -> bool {
        match self {
            CycleKind::Hole(hole) => hole.dwell,
            CycleKind::Tap { .. } | CycleKind::FineBore | CycleKind::BackBore | CycleKind::Own => true,
            CycleKind::Mill { .. } => false,
            CycleKind::Words(format) => format.letters.contains(&b'P'),
        }
    }

    /// Whether it bores: the way out is not that of a drill.
    fn bores(self) -> bool {
        match self {
            CycleKind::Hole(hole) => hole.retract != Retract::Rapid,
            CycleKind::FineBore | CycleKind::BackBore => true,
            _ => false,
        }
    }
}

/// The address that makes a block with an active cycle drill a hole although no axis is named.
const LEVEL_LETTER: u32 = letters(b"R");

/// Most repeats of a block with a cycle (GSK990MC table 4-4-1).
const MAX_REPEATS: f64 = 99_999.0;

/// Most steps of one hole; a depth of cut that needs more is an alarm and not a full memory.
const MAX_PECKS: f64 = 10_000.0;

/// Data of the active cycle, kept until it is cancelled.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub(crate) struct CycleState {
    active: bool,
    /// Level of the tool axis when the cycle mode began, programmed coordinate, mm.
    initial: f64,
    /// R level, mm. Kept as a level, so that G91 after it changes nothing (GSK990MC 4.4.12 example).
    r: Option<f64>,
    /// Level of the bottom, mm.
    z: Option<f64>,
    /// Its distance from the R level, where it was given so: it goes with a new one.
    depth: Option<f64>,
    /// Depth of cut or distance aside, mm.
    q: Option<f64>,
    /// Dwell, s.
    p: Option<f64>,
    /// Draw-back of peck tapping, mm.
    v: Option<f64>,
    /// Words of a milling cycle.
    mill: MillWords,
    /// Holes of the present block still to be cut.
    holes_left: u32,
    /// The line that they lie on, where they do.
    line: Option<Line>,
    /// The figure that they lie on, where they do.
    pattern: Option<Places>,
    /// A change of tool length that is made on the next way to an R level: the code in force.
    length: Option<Meaning>,
    /// The feed of a tapping that was told to be held, and the speed of its spindle.
    told: Option<(f64, Option<f64>)>,
    /// Whether something was told once for all holes ([`Interpreter::tell_once`]).
    is_told: bool,
    /// Scale factor of the tool axis, set aside while a block of the cycle runs.
    pub z_factor: Option<f64>,
}

/// Data of a hole: levels, mm, and dwell, s.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct HoleData {
    pub initial: f64,
    pub r: Option<f64>,
    pub z: Option<f64>,
    pub q: Option<f64>,
    pub p: Option<f64>,
}

/// A row of holes at equal distances.
#[derive(Clone, Copy, PartialEq, Debug)]
struct Line {
    /// Where the tool is before the first, which is no hole.
    from: Position,
    /// The last hole.
    to: Position,
    holes: u32,
}

impl Line {
    /// The hole with so many behind it.
    fn hole(&self, left: u32) -> Position {
        let number = self.holes.saturating_sub(left);
        // The last one is where it was programmed, to the last digit.
        if left == 0 { self.to } else { self.from.lerp(self.to, f64::from(number) / f64::from(self.holes)) }
    }
}

impl CycleState {
    /// Whether a cycle is modal.
    pub fn is_active(&self) -> bool {
        self.active
    }

    /// Leaves out the holes still to be cut.
    pub fn drop_holes(&mut self) {
        self.holes_left = 0;
    }

    /// Whether the holes of the block lie on a figure.
    pub fn is_in_figure(&self) -> bool {
        self.pattern.is_some()
    }

    /// The data that programs in the place of cycles are given.
    pub fn data(&self) -> HoleData {
        let CycleState { initial, r, z, q, p, .. } = *self;
        HoleData { initial, r, z, q, p }
    }
}

impl Interpreter {
    /// The cycle in force.
    #[inline]
    pub(crate) fn cycle_kind(&self) -> Option<CycleKind> {
        match self.modal.meaning(Group::Cycle) {
            Meaning::Cycle(kind) => Some(kind),
            _ => None,
        }
    }

    /// Whether the cycle in force is a program of the shop, for a code that the control lacks.
    pub(crate) fn is_own_cycle(&self) -> bool {
        self.cycle_kind() == Some(CycleKind::Own)
    }

    /// Those of the axes of which the words are not the cycle's.
    pub(crate) fn axes_beside_cycle(&self, axes: AxisSet) -> AxisSet {
        let own = self.cycle_kind().map_or(AxisSet::EMPTY, CycleKind::own_axes);
        match axes.and(own).is_empty() {
            true => axes,
            false => axes.iter().filter(|axis| !own.contains(*axis)).collect(),
        }
    }

    /// G80 and what acts like it: the cycle and its data are gone, rigid tapping too.
    #[inline]
    pub(crate) fn cancel_cycle(&mut self) {
        if self.cycle_kind().is_some() {
            self.modal.set(self.dialect.cycle_off);
            self.scale_tool_axis_again();
            self.output.resume_cutter();
            self.hand_length_over();
            self.cycle = CycleState::default();
            self.technology.rigid_tapping = false;
            self.leave_zone();
        }
    }

    /// A change of tool length that no way to an R level has taken up, because no hole was made, waits for the axis to be moved.
    fn hand_length_over(&mut self) {
        match self.cycle.length.take() {
            Some(Meaning::LengthOff) => {
                self.location.length.cancel();
                self.location.take_machine();
            }
            Some(_) => self.location.length.waits = true,
            None => {}
        }
    }

    /// A block while a cycle is in force.
    pub(crate) fn cycle_block(&mut self, axes: AxisSet, length: Option<Meaning>) -> Fallible<()> {
        let is_own = self.is_own_cycle();
        if self.modal.plane() != Plane::Xy && !self.rules.cycles.in_any_plane && !is_own {
            return Err(self.alarm(Fault::CyclePlane, self.cycle_span()));
        }
        if self.is_nested_on_z() && !is_own {
            return Err(self.alarm(Fault::CycleScaled, self.cycle_span()));
        }
        self.leave_tool_axis_unscaled();
        if !self.cycle.active {
            let z_factor = self.cycle.z_factor;
            let initial = self.location.programmed[Axis::Z];
            self.cycle = CycleState { active: true, initial, z_factor, ..CycleState::default() };
        }
        self.store_cycle_data()?;
        self.store_mill_words();
        let level_cuts =
            !(self.rules.cycles.boring_needs_axis && self.cycle_kind().is_some_and(CycleKind::bores));
        // A program of the shop is run by its code, whatever words stand there.
        let is_called = is_own && self.cycle_code().is_some();
        if axes.is_empty() && !is_called && !(level_cuts && self.words.has_any(LEVEL_LETTER)) {
            // Nothing to cut; a change of tool length alone is made at once (GSK990MC 4.4.1 note 3).
            if self.length_words(length, axes)? {
                self.rapid(self.location.programmed)?;
            }
            self.scale_tool_axis_again();
            return Ok(());
        }
        // S of G96 is one too (GSK990MC 6.3); tapping has none by it, whatever S was in r/min before (4.5).
        let taps = matches!(self.cycle_kind(), Some(CycleKind::Tap { .. }));
        let by_surface = self.is_surface_speed();
        let has_speed = !(taps && by_surface)
            && (self.technology.speed.is_some() || by_surface && self.technology.surface_speed.is_some());
        if self.rules.cycles.needs_speed && !has_speed {
            let fault =
                if taps && self.taps_rigidly() { Fault::TappingNoSpeed } else { Fault::CycleNoSpindle };
            return Err(self.alarm(fault, self.cycle_span()));
        }
        // What K is there, the program says.
        let repeats = if is_own { 1.0 } else { self.repeats() };
        let fault = match repeats {
            _ if repeats.fract() != 0.0 && !self.rules.counts_take_any_number => Some(Fault::WordNotWhole),
            _ if repeats < 0.0 => Some(Fault::WordNegative),
            _ => (repeats > MAX_REPEATS).then_some(Fault::WordOutOfRange),
        };
        if let Some(fault) = fault {
            let letter = self.repeats_word().map_or(self.rules.cycles.repeat_letter, |(letter, _)| letter);
            return Err(self.alarm_at(fault, letter));
        }
        let holes = repeats as u32;
        // A program that stands for the cycle repeats by itself.
        self.cycle.holes_left = if self.custom_cycle().is_some() { holes.min(1) } else { holes };
        self.cycle.pattern = None;
        self.cycle.line = match self.rules.cycles.repeat {
            Repeat::Line if holes > 0 => {
                let (from, to) = (self.location.programmed, self.place_of_hole());
                Some(Line { from, to, holes })
            }
            _ => None,
        };
        if length.is_some() || self.words.has(b'H') {
            self.keep_length_number()?;
            self.cycle.length = Some(length.unwrap_or(self.modal.meaning(Group::Length)));
            if is_own {
                // No way to an R level takes it up: the next one of the tool axis does.
                self.hand_length_over();
            }
        }
        if self.cycle.holes_left == 0 {
            self.scale_tool_axis_again();
        }
        Ok(())
    }

    /// How many holes the block asks for.
    pub(crate) fn repeats(&self) -> f64 {
        let given = self.repeats_word().map_or(1.0, |(_, repeats)| repeats);
        if self.rules.cycles.repeats_lose_sign { given.abs() } else { given }
    }

    /// The word that counts them, and its value.
    fn repeats_word(&self) -> Option<(u8, f64)> {
        let letters = [Some(self.rules.cycles.repeat_letter), self.rules.cycles.other_repeat_letter];
        letters.into_iter().flatten().find_map(|letter| Some((letter, self.words.get(letter)?)))
    }

    /// Whether holes of the present block are still to be cut.
    #[inline]
    pub(crate) fn has_holes_left(&self) -> bool {
        self.cycle.holes_left > 0 || self.ngc.cycles.has_holes_left()
    }

    /// Cuts the next hole of the present block, and after the last one does what waits for the end of
    /// the block. A repeated cycle makes its steps hole by hole, so that K99999 takes no more memory
    /// than one.
    pub(crate) fn next_hole(&mut self) -> Fallible<()> {
        if self.ngc.cycles.has_holes_left() {
            return self.ngc_next_hole();
        }
        self.cycle.holes_left -= 1;
        self.flow.count_hole();
        if let Some(code) = self.custom_cycle() {
            return match self.call_custom(code, &mut Rest::at(Part::Holes), self.words.block_span()) {
                Err(alarm) => self.give_up_block(alarm),
                done => done,
            };
        }
        let done = match self.cycle_kind() {
            _ if self.zone_runs() => self.zone_hole(),
            Some(CycleKind::Hole(cycle)) => self.hole(cycle),
            Some(CycleKind::Tap { left }) => self.tap(left),
            Some(CycleKind::FineBore) => self.fine_bore(),
            Some(CycleKind::BackBore) => self.back_bore(),
            Some(CycleKind::Mill { shape, turn }) => self.mill(shape, turn),
            Some(CycleKind::Words(_) | CycleKind::Own) | None => Ok(()),
        };
        if let Err(alarm) = done {
            self.cycle.holes_left = 0;
            self.end_zone_block();
            return self.give_up_block(alarm);
        }
        if self.cycle.holes_left > 0 {
            if !self.zone_runs() {
                self.flow.begin_section();
            }
            return Ok(());
        }
        self.end_zone_block();
        self.scale_tool_axis_again();
        self.end_holes()
    }

    /// Where the next hole will be.
    pub(crate) fn place_of_next_hole(&mut self) -> Position {
        match (self.cycle.pattern, self.cycle.line) {
            (Some(places), _) => places.hole(self.cycle.holes_left, self.location.programmed),
            (None, Some(line)) => {
                let mut to = line.hole(self.cycle.holes_left);
                to[Axis::Z] = self.location.programmed[Axis::Z];
                to
            }
            (None, None) => self.place_of_hole(),
        }
    }

    /// Words of hole data, kept for the blocks that follow.
    fn store_cycle_data(&mut self) -> Fallible<()> {
        let inch = self.modal.is_inch();
        let incremental = self.modal.is_incremental();
        let mm = |v: f64| units::length_mm(v, inch);
        self.cycle.is_told &= self.cycle_code().is_none();
        if let Some(r) = self.words.get(b'R') {
            // From the initial level; of a milling cycle from where its block begins (4.6.1).
            let mills = matches!(self.cycle_kind(), Some(CycleKind::Mill { .. }));
            let from = if mills { self.location.programmed[Axis::Z] } else { self.cycle.initial };
            self.cycle.r = Some(if incremental { from + mm(r) } else { mm(r) });
            if !incremental {
                // A depth given from the R before is a level now.
                self.cycle.depth = None;
            }
        }
        if let Some(z) = self.words.get(b'Z') {
            self.cycle.z = Some(mm(z));
            self.cycle.depth = incremental.then(|| mm(z));
        }
        if let Some(depth) = self.cycle.depth {
            self.cycle.z = Some(self.cycle.r.unwrap_or(self.cycle.initial) + depth);
        }
        // What they mean is for the program of the shop to say.
        let is_own = self.is_own_cycle();
        if let Some(q) = self.words.get(b'Q') {
            // The sign is left aside (GSK990MC 4.4.4, 4.4.9).
            self.cycle.q = Some(if is_own { mm(q) } else { mm(q).abs() });
        }
        if let Some(v) = self.words.get(b'V') {
            self.cycle.v = Some(mm(v).abs());
        }
        // P of a call is the number of a program.
        if let Some(p) = self.words.get(b'P').filter(|_| !self.words.calls() && !self.p_is_of_return()) {
            // P outside P281…P282 is taken as the nearer of them (GSK990MC 4.4.3).
            let (shortest, longest) = self.rules.cycles.dwell;
            if shortest >= longest {
                return Err(self.alarm_at(Fault::DwellLimits, b'P'));
            }
            let seconds = p * self.rules.cycles.dwell_p_unit_s;
            self.cycle.p = Some(if is_own { seconds } else { seconds.clamp(shortest, longest) });
        }
        Ok(())
    }

    pub(crate) fn cycle_span(&self) -> Span {
        self.cycle_code().map_or(self.words.block_span(), |code| code.span)
    }

    /// The code of a cycle in the block.
    pub(crate) fn cycle_code(&self) -> Option<&Code<GCode>> {
        self.words.g.iter().find(|code| code.row.group == Group::Cycle)
    }

    /// The levels R and bottom; `None` where one is missing, and the tool is positioned only
    /// (GSK990MC 4.4.1).
    fn levels(&mut self) -> Fallible<Option<(f64, f64)>> {
        match (self.cycle.r, self.cycle.z) {
            (Some(r), Some(z)) => Ok(Some((r, z))),
            _ => {
                self.tell_once(Fault::NoHole);
                self.position_over_hole()?;
                Ok(None)
            }
        }
    }

    /// Tells what is wrong with the cycle, once until it is programmed again.
    fn tell_once(&mut self, fault: Fault) {
        if !std::mem::replace(&mut self.cycle.is_told, true) {
            self.tell(*self.alarm(fault, self.cycle_span()));
        }
    }

    /// An alarm about the level that the block gives.
    fn level_alarm(&self, fault: Fault) -> Box<ferrocut_machine::Alarm> {
        let mut alarm = self.alarm_at(fault, if self.words.has(b'Z') { b'Z' } else { b'R' });
        if let (Some(r), Some(z)) = (self.cycle.r, self.cycle.z) {
            alarm.arguments.push(("depth", z.into()));
            alarm.arguments.push(("r", r.into()));
        }
        alarm
    }

    /// Refuses a depth of cut that would make a hole of endless steps.
    fn check_pecks(&self, depth: f64, step: f64) -> Fallible<()> {
        if depth / step > MAX_PECKS {
            return Err(self.alarm_at(Fault::WordOutOfRange, b'Q'));
        }
        Ok(())
    }

    /// Level to which the tool returns.
    fn top(&self, r: f64) -> f64 {
        if self.modal.meaning(Group::Return) == Meaning::ReturnR { r } else { self.cycle.initial }
    }

    /// Rapid over the hole, all named axes but the tool axis together.
    fn position_over_hole(&mut self) -> Fallible<()> {
        let to = self.place_of_next_hole();
        self.position_at(to)
    }

    /// The place that the block gives a hole, at the level where the tool is.
    fn place_of_hole(&mut self) -> Position {
        let axes = self.axes_beside_cycle(self.words.axes(self.rules.axes));
        let axes: AxisSet = axes.iter().filter(|a| *a != Axis::Z).collect();
        self.end_point(axes)
    }

    /// Rapid to where a cycle begins, at the level where the tool is. Cutter compensation is left aside from
    /// here until the cycle is cancelled (GSK990MC 4.4 limits).
    fn position_at(&mut self, to: Position) -> Fallible<()> {
        self.output.pause_cutter();
        let (here, there) = (self.location.machine, self.location.machine_of(to));
        if Plane::Xy.of(here) == Plane::Xy.of(there) {
            let op = Op::Rapid {
                to: here,
                straight: self.rules.rapid_is_straight,
                speed: None,
                path: PathMode::ON_PATH,
            };
            let step = self.step(op);
            self.output.back_onto_path(step).map_err(|(fault, span)| self.alarm(fault, span))?;
        }
        self.rapid(to)?;
        self.flow.begin_section();
        Ok(())
    }

    /// Rapid to the R level, on which a change of tool length is taken up.
    fn approach(&mut self, r: f64) -> Fallible<()> {
        self.take_up_length()?;
        self.rapid_z(r)?;
        self.flow.begin_section();
        Ok(())
    }

    /// The change of tool length that waits for the way to the R level, or for any way of the axis.
    fn take_up_length(&mut self) -> Fallible<()> {
        let code = self.cycle.length.take();
        if code.is_some() || self.location.length.waits {
            let before = self.location.length.vector[Axis::Z];
            self.length_words(code, AxisSet::EMPTY.with(Axis::Z))?;
            if self.rules.cycles.length_at_start_only {
                self.cycle.initial -= self.location.length.vector[Axis::Z] - before;
            }
        }
        Ok(())
    }

    /// The pause of P, where one was given.
    fn cycle_dwell(&mut self) {
        if let Some(seconds) = self.cycle.p.filter(|seconds| *seconds > 0.0) {
            self.emit(Op::Dwell(Dwell::Seconds(seconds)));
        }
    }

    /// Starts the spindle that a cycle stopped. `before` is what it did.
    fn restart(&mut self, before: SpindleState) {
        let state = match self.rules.cycles.restart {
            Restart::AsBefore => before,
            Restart::Clockwise => SpindleState::Clockwise(self.speed()),
        };
        self.spindle(state);
    }

    fn rapid_z(&mut self, z: f64) -> Fallible<()> {
        let mut to = self.location.programmed;
        to[Axis::Z] = z;
        self.rapid(to)
    }

    fn cut_z(&mut self, z: f64) -> Fallible<()> {
        let mut to = self.location.programmed;
        to[Axis::Z] = z;
        self.cut(to)
    }
}
