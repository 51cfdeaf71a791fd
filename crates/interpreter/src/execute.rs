//! What a block does, in the order of GSK990MC 4.1 and 5.2: modal codes, F S T, M codes that start
//! with the motion, the motion or the non-modal code, M codes that wait for its end.

use crate::Fallible;
use crate::barrier::Present;
use crate::custom::Custom;
use crate::dialect::{GCode, MCode, MFunction, Meaning};
use crate::interpreter::Interpreter;
use crate::modal::Group;
use crate::stages::cutter::{Offset, Side};
use crate::stages::units;
use crate::words::{self, Code, Reader};
use ferrocut_geometry::{Axis, AxisSet, Position};
use ferrocut_machine::{Alarm, Fault, ToolOffset};
use ferrocut_program::{Block, DefectKind, Page, ProgramId, Span, Value as WordValue, Word};
use ferrocut_toolpath::{Dwell, Op, Speed, SpindleState, Step};
use smallvec::SmallVec;

/// Addresses of a feed or a pitch.
const FEED_LETTERS: u32 = words::letters(b"FI");

/// What the codes of a block ask for beyond the modal state.
#[derive(Default)]
pub(crate) struct Codes {
    /// The non-modal code, if there is one.
    non_modal: Option<Code<GCode>>,
    /// The code of tool length compensation, if there is one.
    length: Option<Meaning>,
    /// Whether there is a code of cutter compensation.
    cutter: bool,
    /// Codes of scaling and rotation, to be carried out after the others.
    transforms: SmallVec<[Code<GCode>; 2]>,
    /// Whether a code takes the block's coordinates for itself, so that nothing moves.
    takes_words: bool,
    /// Whether a code of scaling may change the side of the tool.
    mirrors: bool,
    /// A code that a program stands for.
    custom: Option<(Custom, Span)>,
    /// What rotary axes do in this block alone.
    rotary: RotaryBlock,
}

/// What codes ask of the rotary axis in their block.
#[derive(Clone, Copy, Default)]
pub(crate) struct RotaryBlock {
    /// It goes the shorter way round.
    pub shortest: bool,
    /// It is programmed in degrees.
    pub degrees: bool,
}

/// What is still to be done of a block: from one of its parts on. Programs that stand for codes come between.
#[derive(Default)]
pub(crate) struct Rest {
    codes: Codes,
    axes: AxisSet,
    pub part: Part,
    /// The M code, by its place in the block, whose program was run before the code itself.
    builtin: Option<usize>,
}

impl Rest {
    /// From a part on behind the codes.
    pub(crate) fn at(part: Part) -> Rest {
        Rest { part, ..Rest::default() }
    }
}

/// The parts of a block behind its modal codes.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub(crate) enum Part {
    /// The program of an S word.
    #[default]
    Speed,
    /// M codes that start with the motion, from this one on.
    Before(usize),
    /// The motion, or what stands for it.
    Motion,
    /// The holes of a cycle.
    Holes,
    /// M codes that wait for the motion's end, from this one on.
    After(usize),
}

impl Interpreter {
    /// Executes one block.
    pub(crate) fn execute(&mut self, page: &Page, block: &Block, index: usize) -> Fallible<()> {
        // Blocks that may be skipped are refused there, skipped or not.
        let is_refused = block.skip > 0 && self.is_strictly_transformed();
        if self.is_skipped(block) && !is_refused {
            return Ok(());
        }
        self.words.start(page, block);
        self.output.start_block();
        if is_refused {
            let alarm = self.alarm(Fault::SkipBlockInTransform, page.block_span(block));
            return self.give_up_block(alarm);
        }
        if block.is_mark {
            self.ended = true;
            return Err(self.alarm(Fault::EndMarkReached, page.block_span(block)));
        }
        let mut sound = true;
        if block.is_defective {
            for defect in page.defects(index) {
                let alarm = self.alarm(fault_of(defect.kind), page.span(block, defect.at, defect.len));
                self.note(alarm);
            }
            if !self.options.keep_going {
                return Ok(());
            }
            sound = false;
        }
        if let Some(first) = page.words(block).first()
            && first.letter == b'O'
        {
            let number = match first.value() {
                WordValue::Number(number) => number,
                // A program with a name has no number.
                WordValue::Text(_) => 0.0,
                WordValue::Expression(_) => {
                    let alarm = self.alarm(Fault::VariableInNumber, page.word_span(block, first));
                    return self.give_up_block(alarm);
                }
            };
            self.program_number(number, page.word_span(block, first))?;
            if block.words == 1 && block.statement.is_none() {
                return Ok(());
            }
        }
        self.enter_program();
        self.note_sequence(page, block);
        if self.data_setting.is_some() && page.statement(block).is_some() {
            return self.give_up_block(self.alarm(Fault::CommandInDataSetting, page.block_span(block)));
        }
        if let Some(condition) = page.guard(block) {
            match self.evaluate(page, condition) {
                _ if self.present == Present::Asked => return Ok(()),
                Ok(value) if value.is_none_or(|v| v == 0.0) => return Ok(()),
                Ok(_) => {}
                Err(fault) => {
                    let alarm = self.alarm(fault, page.block_span(block));
                    return self.give_up_block(alarm);
                }
            }
        }
        if let Some(statement) = page.statement(block) {
            return match self.statement(page, *statement) {
                Err(alarm) if self.options.keep_going => {
                    self.note(alarm);
                    Ok(())
                }
                done => done,
            };
        }
        let macro_call = WordValue::Number(f64::from(self.dialect.macro_call) / 10.0);
        let is_macro_call = |word: &Word| word.letter == b'G' && word.value() == macro_call;
        if page.words(block).iter().any(is_macro_call) {
            return match self.macro_block(page, block) {
                Err(alarm) if self.options.keep_going => {
                    self.note(alarm);
                    Ok(())
                }
                done => done,
            };
        }
        let tool_axis = self.plane_axes()[2];
        for word in page.words(block) {
            let value = match word.value() {
                WordValue::Number(value) => Ok(value),
                WordValue::Text(text) => Err(text),
                // O and N are plain numbers (GSK990MC 4.9.2, 1 note 1).
                WordValue::Expression(_) if matches!(word.letter, b'O' | b'N') => {
                    let alarm = self.alarm(Fault::VariableInNumber, page.word_span(block, word));
                    self.note(alarm);
                    sound = false;
                    continue;
                }
                WordValue::Expression(range) => match self.evaluate_word(page, range) {
                    Ok(Some(value)) => Ok(value),
                    // A word with an empty variable is as if it were not there (GSK990MC 4.9.2).
                    Ok(None) => continue,
                    Err(fault) => {
                        let alarm = self.alarm(fault, page.word_span(block, word));
                        self.note(alarm);
                        sound = false;
                        continue;
                    }
                },
            };
            let reader = Reader {
                dialect: self.dialect,
                tables: &self.tables,
                page,
                block,
                repeats_are_alarms: self.rules.repeats_are_alarms,
                max_m_code: self.rules.max_m_code,
                distance_is_exclusive: self.rules.distance_is_exclusive,
                custom: self.custom.as_deref(),
                tool_axis,
                axis_names: self.options.axis_names,
            };
            let read = match value {
                Ok(value) => reader.word(&mut self.words, word, value),
                Err(text) => reader.text(&mut self.words, word, text),
            };
            if let Err(alarm) = read {
                self.note(alarm);
                sound = false;
            }
        }
        if self.present == Present::Asked {
            return Ok(());
        }
        if !sound {
            return if self.options.keep_going { self.recover() } else { Ok(()) };
        }
        match self.block_of_words() {
            Ok(()) => Ok(()),
            Err(alarm) => self.give_up_block(alarm),
        }
    }

    /// Raises an alarm of the present block; a checker goes on behind it.
    pub(crate) fn give_up_block(&mut self, alarm: Box<Alarm>) -> Fallible<()> {
        if !self.options.keep_going {
            return Err(alarm);
        }
        self.note(alarm);
        self.recover()
    }

    /// Executes a block whose words were all read.
    fn block_of_words(&mut self) -> Fallible<()> {
        if self.described.profiles.is_recording() {
            return self.profile_block();
        }
        self.check_m_codes()?;
        if self.technology.rigid_tapping
            && self.words.has(b'S')
            && !self.words.m.iter().any(|m| m.row.function == MFunction::RigidTapping)
            && !self.words.g.iter().any(|g| g.row.group == Group::Cycle)
            && !self.cycle.is_active()
        {
            return Err(self.alarm_at(Fault::RigidMisplaced, b'S'));
        }
        let axes = self.words.axes(self.rules.axes);
        let ends_data = self.words.g.iter().any(|g| g.row.meaning == Meaning::DataSettingOff)
            || self.words.m.iter().any(|m| m.row.controls_program);
        if ends_data {
            self.technology.data_code = 11.0;
        }
        if let Some(what) = self.data_setting {
            if ends_data {
                self.data_setting = None;
            } else {
                return self.data_block(what);
            }
        }
        self.full_feed = false;
        // Filled in place: copies of it, just written, would be waited for in every block.
        let mut rest = Rest { axes, ..Rest::default() };
        let codes = &mut rest.codes;
        self.modal_codes(codes)?;
        self.check_axes()?;
        self.check_moving_axes(axes, codes)?;
        if codes.non_modal.is_some_and(|code| code.row.meaning == Meaning::DataSetting) {
            self.check_data_block_is_alone()?;
        }
        // The words beside a call are its arguments.
        if codes.non_modal.is_some_and(|code| code.row.meaning == Meaning::Call) {
            return self.finish_block(&mut rest);
        }
        if self.words.has_any(FEED_LETTERS) {
            match self.is_pitch_block() {
                true => self.pitch_words()?,
                false if self.rules.motion.rapid_takes_feed && self.is_rapid_block(axes) => {
                    self.rapid_feed_word()?;
                }
                false => self.feed_word()?,
            }
        }
        // With G92 an S is the highest speed of G96 (6.3), where there is such a code.
        let limits_speed = self.rules.surface_speed
            && codes.non_modal.is_some_and(|code| code.row.meaning == Meaning::SetPosition);
        if self.words.has(b'S') && !limits_speed {
            self.speed_word()?;
        }
        if let Some(tool) = self.words.get(b'T') {
            if tool > self.rules.max_tool {
                return Err(self.alarm_at(Fault::ToolNumber, b'T'));
            }
            self.technology.tool = tool as u32;
            if self.rules.tool_chooses_offsets {
                self.technology.radius_number = tool;
                self.location.length.number = tool as u16;
            }
            self.emit(Op::Select(tool as u32));
        }
        if self.rules.tools_carry_offsets {
            self.offset_word();
        }
        if codes.cutter || self.words.has(b'D') && !self.rules.tools_carry_offsets {
            self.cutter_words(codes.cutter)?;
        }
        if let Some(rotary) = self.rules.motion.rotary_y {
            self.rotary_word(rotary, codes.rotary);
        }
        self.finish_block(&mut rest)
    }

    /// Does what is left of a block.
    pub(crate) fn finish_block(&mut self, rest: &mut Rest) -> Fallible<()> {
        if rest.part == Part::Speed {
            rest.part = Part::Before(0);
            if self.words.has(b'S')
                && let Some(code) = self.custom_speed()
            {
                let span = self.words.span(b'S');
                return self.call_custom(code, rest, span);
            }
        }
        if let Part::Before(from) = rest.part {
            if let Some((code, span)) = self.m_functions(false, from, rest)? {
                return self.call_custom(code, rest, span);
            }
            rest.part = Part::Motion;
        }
        if rest.part == Part::Motion {
            rest.part = Part::After(0);
            let (axes, length) = (rest.axes, rest.codes.length);
            if let Some((code, span)) = rest.codes.custom {
                return self.call_custom(code, rest, span);
            }
            match rest.codes.non_modal {
                Some(code) if code.row.meaning == Meaning::Call => self.non_modal(code, axes, length)?,
                Some(code) => {
                    // What ends compensation ends it before the code (`G53 G49 Z0`); the axes stand still.
                    if self.length_ends(length) && code.row.meaning != Meaning::SetPosition {
                        self.location.length.cancel();
                        self.location.take_machine();
                    }
                    self.non_modal(code, axes, length)?;
                    // Modal codes beside it take effect without being run (4.1 note 1).
                    if length.is_some() || self.words.has(b'H') {
                        self.defer_length(length)?;
                    }
                }
                None if rest.codes.takes_words => self.length_by_itself(length)?,
                None if self.is_zone_block() => self.zone_block(axes)?,
                None if self.cycle_kind().is_some() => self.cycle_block(axes, length)?,
                None => {
                    let length_moves = self.length_words(length, axes)?;
                    self.motion_block(axes, length_moves)?;
                }
            }
            let codes = &rest.codes;
            let moves = codes.non_modal.is_none() && !codes.takes_words && self.cycle_kind().is_none();
            self.end_block(moves);
        }
        // The holes of a cycle are made one by one; what waits for the block's end comes after the last.
        if self.has_holes_left() {
            return Ok(());
        }
        let from = if let Part::After(from) = rest.part { from } else { 0 };
        match self.m_functions(true, from, rest)? {
            Some((code, span)) => self.call_custom(code, rest, span),
            None => Ok(()),
        }
    }

    /// Does what waits for the last hole of the block.
    pub(crate) fn end_holes(&mut self) -> Fallible<()> {
        self.finish_block(&mut Rest::at(Part::After(0)))
    }

    /// Puts the block's modal codes in force.
    fn modal_codes(&mut self, codes: &mut Codes) -> Fallible<()> {
        codes.custom = self.words.custom.map(|(number, span)| (Custom::G(number), span));
        let mut motion = false;
        let mut cycle = None;
        let mut length = None;
        let beside_motion = self.rules.cycles.stand_beside_motion;
        let ends_cycle = |code: &Code<GCode>| {
            code.row.group == Group::Motion && !beside_motion || code.row.meaning == Meaning::CycleOff
        };
        if self.words.g.iter().any(ends_cycle) {
            self.cancel_cycle();
        }
        // What ends a state first, what starts polar coordinates last, wherever they stand in the block.
        let count = self.words.g.len();
        let turns = if count > 1 { 3 } else { 1 };
        for at in 0..turns * count {
            let Some(&code) = self.words.g.get(at % count) else { break };
            let Code { row, span } = code;
            if count > 1 && at / count != turn_of(row.meaning) {
                continue;
            }
            if let Some(custom) = self.custom_g(row) {
                codes.custom = Some((custom, span));
                continue;
            }
            match row.group {
                Group::NonModal if row.meaning == Meaning::FullFeed => self.full_feed = true,
                // Its H is the number of an axis (Weihong 4.4, G916 to G919).
                Group::NonModal if row.meaning == Meaning::NoEffect => drop(self.words.take(b'H')),
                Group::NonModal if row.meaning == Meaning::ShortestWay => codes.rotary.shortest = true,
                Group::NonModal if row.meaning == Meaning::InDegrees => codes.rotary.degrees = true,
                Group::NonModal if row.meaning == Meaning::OneWay && self.rules.one_way_is_modal => {
                    motion = true;
                    self.modal.set(self.dialect.one_way_modal);
                }
                Group::NonModal => codes.non_modal = Some(code),
                Group::Motion => {
                    motion = true;
                    self.modal.set(row);
                }
                Group::Cycle => cycle = Some(row),
                Group::Cutter => {
                    codes.cutter = true;
                    self.modal.set(row);
                }
                Group::Length => length = Some(row),
                Group::WorkOffset => {
                    self.select_work_offset(row.meaning, span)?;
                    self.modal.set(row);
                }
                Group::Plane if self.rules.plane_ends_cycle => {
                    let was = self.plane_axes();
                    self.modal.set(row);
                    self.plane_chosen(was);
                }
                Group::Plane => {
                    let was = self.modal.plane();
                    self.modal.set(row);
                    if self.modal.plane() != was
                        && let Some(fault) = self.plane_change_fault()
                    {
                        return Err(self.alarm(fault, span));
                    }
                }
                Group::Units => {
                    if self.is_strictly_transformed() {
                        return Err(self.alarm(Fault::UnitsInTransform, span));
                    }
                    self.modal.set(row);
                }
                Group::Polar => {
                    self.modal.set(row);
                    self.polar(row.meaning);
                }
                Group::Scaling | Group::Rotation | Group::Mirror => {
                    self.modal.set(row);
                    match row.meaning {
                        _ if self.rules.coordinates.transforms_nest => codes.transforms.push(code),
                        Meaning::ScalingOff => self.scale_off(),
                        Meaning::RotationOff => self.rotate_off(),
                        _ => codes.transforms.push(code),
                    }
                    codes.mirrors |= row.group != Group::Rotation;
                }
                Group::SurfaceSpeed => self.surface_speed(row, span)?,
                Group::StrokeCheck => {
                    self.stroke_check_2 = row.meaning == Meaning::StrokeCheckOn;
                    self.modal.set(row);
                    if self.stroke_check_2 {
                        self.stroke_check_on(span)?;
                        codes.takes_words = true;
                    }
                }
                Group::FeedMode
                    if row.meaning == Meaning::FeedPerRevolution && !self.rules.feed_per_revolution =>
                {
                    return Err(self.alarm(Fault::NoFeedPerRevolution, span));
                }
                _ => self.modal.set(row),
            }
        }
        // A motion code ends the cycle, also one of the same block (GSK990MC 4.1 note 6).
        match cycle {
            _ if motion && !beside_motion => self.cancel_cycle(),
            Some(row) if row.meaning == Meaning::CycleOff => self.cancel_cycle(),
            Some(row) => self.modal.set(row),
            None => {}
        }
        self.length_code(length, codes)?;
        self.transform_codes(codes)
    }

    /// G43, G44, G49. Once a cycle is in force some controls leave them and H aside, also as modal codes
    /// (Kaitong appendix 8, note 2).
    fn length_code(&mut self, row: Option<&'static GCode>, codes: &mut Codes) -> Fallible<()> {
        if self.rules.cycles.length_at_start_only && self.cycle.is_active() {
            self.words.take(b'H');
            return Ok(());
        }
        if let Some(row) = row {
            codes.length = Some(row.meaning);
            self.modal.set(row);
        }
        let acts = row.is_some() || self.words.has(b'H') && !self.in_force(Group::Length, Meaning::LengthOff);
        if !acts {
            return Ok(());
        }
        let refused = |c: &Code<GCode>| self.rules.length_not_with.iter().find(|(t, _)| *t == c.row.tenths);
        match self.words.g.iter().find_map(|c| Some((refused(c)?.1, c.span))) {
            Some((fault, span)) => Err(self.alarm(fault, span)),
            None => Ok(()),
        }
    }

    /// G51 and G68: they go before the block's motion (GSK990MC 4.1 note 8), and take its words for
    /// themselves.
    fn transform_codes(&mut self, codes: &mut Codes) -> Fallible<()> {
        for code in std::mem::take(&mut codes.transforms) {
            let Code { row, span } = code;
            let ends = matches!(row.meaning, Meaning::ScalingOff | Meaning::RotationOff | Meaning::MirrorOff);
            if !ends && codes.non_modal.is_some() {
                return Err(self.alarm(Fault::NeedsOwnBlock, span));
            }
            // The end of a mirror names axes too.
            codes.takes_words |= !ends || row.meaning == Meaning::MirrorOff;
            if self.rules.coordinates.transforms_nest {
                self.nested_transform(row.meaning, span)?;
                continue;
            }
            match row.meaning {
                Meaning::ScalingOn => self.scale(span)?,
                _ => self.rotate()?,
            }
        }
        // A mirror changes the side that the tool is on.
        if codes.mirrors && self.output.in_cutter_mode() {
            self.cutter_words(false)?;
        }
        Ok(())
    }

    /// An alarm for an axis that the control does not carry. A cycle has other uses for U, V and W.
    fn check_axes(&self) -> Fallible<()> {
        if !self.words.has_any(self.foreign_axes) {
            return Ok(());
        }
        // Also where a motion code of the block goes before its cycle (4.1 note 6).
        let has_cycle =
            self.cycle_kind().is_some() || self.words.g.iter().any(|code| code.row.group == Group::Cycle);
        for axis in Axis::ALL {
            let letter = axis.letter() as u8;
            let in_cycle = matches!(axis, Axis::U | Axis::V | Axis::W) && has_cycle;
            if self.words.has(letter) && !self.rules.axes.contains(axis) && !in_cycle {
                let alarm = self.alarm_at(Fault::UnknownAxis, letter);
                return Err(Box::new(alarm.with("axis", axis.letter().to_string())));
            }
        }
        Ok(())
    }

    /// How many M codes, and which together (GSK990MC alarm 0119, bit 33#7).
    fn check_m_codes(&self) -> Fallible<()> {
        let m = &self.words.m;
        let (Some(first), Some(last)) = (m.first(), m.last()) else { return Ok(()) };
        if m.len() < 2 {
            return Ok(());
        }
        let span = first.span.to(last.span);
        if m.iter().any(|c| c.row.controls_program) {
            return Err(self.alarm(Fault::ProgramCodesTogether, span));
        }
        if m.len() > usize::from(self.rules.m_codes_in_block) {
            return Err(self.alarm(Fault::TooManyMCodes, span));
        }
        Ok(())
    }

    /// More axes together than the control moves (GSK990MC 1.2, 9#1). In a cycle the tool axis moves by itself.
    fn check_moving_axes(&self, axes: AxisSet, codes: &Codes) -> Fallible<()> {
        if axes.len() <= self.rules.max_moving_axes {
            return Ok(());
        }
        let moves = match codes.non_modal.map(|code| code.row.meaning) {
            Some(Meaning::Skip | Meaning::MachinePosition | Meaning::OneWay) => axes.len(),
            Some(_) => 0,
            None if codes.takes_words => 0,
            None if self.cycle_kind().is_some() => axes.iter().filter(|a| *a != Axis::Z).count(),
            None => axes.len(),
        };
        if moves > self.rules.max_moving_axes {
            return Err(self.alarm(Fault::TooManyAxes, self.words.block_span()));
        }
        Ok(())
    }

    /// G10 stands alone but for the words of its form (GSK990MC 4.2.7 note 2).
    fn check_data_block_is_alone(&self) -> Fallible<()> {
        let others = [b'F', b'S', b'T', b'D', b'H'];
        if !self.words.m.is_empty() || others.into_iter().any(|letter| self.words.has(letter)) {
            return Err(self.alarm(Fault::NeedsOwnBlock, self.words.block_span()));
        }
        Ok(())
    }

    /// Keeps the N word; not among parameters, where N is the number of one.
    fn note_sequence(&mut self, page: &Page, block: &Block) {
        if self.data_setting.is_none()
            && let Some(word) = page.words(block).iter().find(|word| word.letter == b'N')
            && let WordValue::Number(number) = word.value()
        {
            self.technology.sequence = Some(number);
        }
    }

    /// In cutter compensation a block without a move in the plane uses up the look-ahead, and one whose move
    /// has no length ends the move before square (GSK990MC 4.7.3, 8). `moves`: its axis words are for a move.
    #[inline]
    fn end_block(&mut self, moves: bool) {
        if !self.output.looks_ahead() {
            return;
        }
        let plane = self.modal.plane();
        let named = |axis: Axis| self.words.has(axis.letter() as u8);
        let names_plane = moves && (named(plane.first()) || named(plane.second()));
        if let Err(refused) = self.output.end_block(names_plane, self.words.block_span()) {
            self.refuse(refused);
        }
    }

    /// A change of tool length in a block that does not move by it: the axis takes it up when it is next moved.
    fn defer_length(&mut self, code: Option<Meaning>) -> Fallible<()> {
        self.keep_length_number()?;
        if !self.length_ends(code) && self.modal.meaning(Group::Length) != Meaning::LengthOff {
            self.location.length.waits = true;
        }
        Ok(())
    }

    /// Whether the block ends tool length compensation.
    fn length_ends(&self, code: Option<Meaning>) -> bool {
        code == Some(Meaning::LengthOff) || !self.rules.h00_waits && self.words.get(b'H') == Some(0.0)
    }

    /// A change of tool length in a block whose coordinates are not for a move: the axis moves by it alone.
    fn length_by_itself(&mut self, code: Option<Meaning>) -> Fallible<()> {
        let was = self.location.length.vector;
        if !self.length_words(code, AxisSet::EMPTY)? {
            return Ok(());
        }
        self.rapid_machine(self.location.machine + self.location.length.vector - was)
    }

    /// H into force as the number that G43 and G44 take.
    pub(crate) fn keep_length_number(&mut self) -> Fallible<()> {
        if let Some(h) = self.words.get(b'H') {
            if self.memory.tools.get(h as u16).is_none() {
                return Err(self.alarm_at(Fault::OffsetNumber, b'H'));
            }
            self.location.length.number = h as u16;
        }
        Ok(())
    }

    /// G43, G44, G49 and H. True if an axis is to move by the change although it is not named
    /// (GSK990MC 4.7.1: without a move the change is made at once).
    pub(crate) fn length_words(&mut self, code: Option<Meaning>, axes: AxisSet) -> Fallible<bool> {
        let h = self.words.get(b'H');
        if code == Some(Meaning::LengthOff) {
            let was = self.location.length.vector;
            self.location.length.cancel();
            return Ok(was != Position::ZERO);
        }
        let sign = match self.modal.meaning(Group::Length) {
            Meaning::LengthPlus => 1.0,
            Meaning::LengthMinus => -1.0,
            // H without G43 waits for it.
            _ => return self.keep_length_number().map(|()| false),
        };
        let axis = self.length_axis();
        if let Some(h) = h {
            let Some(offset) = self.memory.tools.get(h as u16) else {
                return Err(self.alarm_at(Fault::OffsetNumber, b'H'));
            };
            self.location.length.number = h as u16;
            // H00 alone waits for the axis or for a code of its group (GSK990MC 4.7.1, 4).
            if self.rules.h00_waits && h == 0.0 && code.is_none() && !axes.contains(axis) {
                self.location.length.waits = true;
                return Ok(false);
            }
            let value = sign * (offset.length + offset.length_wear);
            if value.abs() > self.rules.max_offset {
                return Err(self.alarm_at(Fault::OffsetTooLarge, b'H'));
            }
            return Ok(self.put_length(axis, value));
        }
        let takes_up = self.location.length.waits && axes.contains(axis);
        if code.is_none() && !takes_up {
            return Ok(false);
        }
        let number = self.location.length.number;
        let offset = self.memory.tools.get(number).copied().unwrap_or_default();
        Ok(self.put_length(axis, sign * (offset.length + offset.length_wear)))
    }

    fn put_length(&mut self, axis: Axis, value: f64) -> bool {
        let changed = self.location.length.vector[axis] != value;
        self.location.length.set(axis, value);
        changed
    }

    /// Radius of a row of the offset table, which may hold diameters (40#7), mm.
    pub(crate) fn tool_radius(&self, row: &ToolOffset) -> f64 {
        let entered = row.radius + row.radius_wear;
        if self.rules.radius_is_diameter { entered / 2.0 } else { entered }
    }

    /// D of the tool in the spindle; with M6 it is that of the tool that comes.
    fn offset_word(&mut self) {
        let changes = self.words.m.iter().any(|m| m.row.function == MFunction::ToolChange);
        if let Some(edge) = self.words.get(b'D').filter(|_| !changes) {
            self.edge_chosen(edge);
        }
    }

    /// G40, G41, G42 and D (GSK990MC 4.7.2).
    fn cutter_words(&mut self, code: bool) -> Fallible<()> {
        if let Some(number) = self.words.get(b'D').filter(|_| !self.rules.tools_carry_offsets) {
            self.technology.radius_number = number;
        }
        let side = match self.modal.meaning(Group::Cutter) {
            Meaning::CutterLeft => Side::Left,
            Meaning::CutterRight => Side::Right,
            _ if code => return self.cancel_cutter(),
            _ => return Ok(()),
        };
        // D00 is no compensation.
        if self.technology.radius_number == 0.0 {
            return self.cancel_cutter();
        }
        let Some(row) = self.memory.tools.get(self.technology.radius_number as u16) else {
            return Err(self.alarm_at(Fault::OffsetNumber, b'D'));
        };
        if (row.radius + row.radius_wear).abs() > self.rules.max_offset {
            return Err(self.alarm_at(Fault::OffsetTooLarge, b'D'));
        }
        let radius = self.tool_radius(row);
        // A mirrored path has the tool on its other side (GSK990MC 4.2.14 note 2).
        let plane = self.modal.plane();
        let mirrored = self.location.scaling.is_some_and(|scaling| scaling.reverses(plane))
            ^ self.location.nested.is_some_and(|nested| nested.reverses(plane));
        let side = if mirrored { side.other() } else { side };
        let offset = Some(Offset { side, radius });
        // G41 or G42 given again ends the block before square (GSK990MC 4.7.3, 7).
        if code && self.output.is_on_side(side) {
            self.output.flush().map_err(|(fault, span)| self.alarm(fault, span))?;
        }
        self.output.set_cutter(self.modal.plane(), offset);
        Ok(())
    }

    /// G40. In a block that does not move in the plane the last move ends square to itself.
    fn cancel_cutter(&mut self) -> Fallible<()> {
        let plane = self.modal.plane();
        let moves = [plane.first(), plane.second()].into_iter().any(|a| self.words.has(a.letter() as u8));
        if !moves && self.output.in_cutter_mode() {
            self.output.flush().map_err(|(fault, span)| self.alarm(fault, span))?;
        }
        self.output.set_cutter(plane, None);
        Ok(())
    }

    /// G39 (GSK990MC 4.7.4).
    fn corner_arc(&mut self, span: Span) -> Fallible<()> {
        let has_words = self.words.has_any(words::AXIS_LETTERS | words::letters(b"IJKR"));
        if !self.rules.corner_arc || !self.output.in_cutter_mode() || has_words {
            return Err(self.alarm(Fault::CornerArcForm, span));
        }
        let op = Op::Feed { to: self.location.machine, feed: self.feed()?, path: self.path_mode() };
        let step = Step { op, span: self.words.block_span() };
        self.output.corner_arc(step).map_err(|(fault, span)| self.alarm(fault, span))
    }

    /// F: feed in force until the next one. Feed per minute is kept as programmed and held within the
    /// control's limits where it is used; feed per revolution beyond its range is an alarm (7.2.2).
    fn feed_word(&mut self) -> Fallible<()> {
        let Some(f) = self.words.get(b'F') else { return Ok(()) };
        let feed = units::length_mm(f, self.modal.is_inch());
        if self.modal.is_feed_per_revolution() {
            if !(feed > 0.0 && feed <= self.rules.max_feed_per_revolution) {
                return Err(self.alarm_at(Fault::FeedOutOfRange, b'F'));
            }
            self.technology.feed_per_revolution = feed;
        } else {
            if feed <= 0.0 {
                return Err(self.alarm_at(Fault::FeedOutOfRange, b'F'));
            }
            self.technology.feed_per_minute_was_given = true;
            self.technology.feed_per_minute = feed;
        }
        Ok(())
    }

    /// Whether F of the block is the speed of positioning: G00 stands in it, or its words are positioned to
    /// (Weihong 4.1).
    fn is_rapid_block(&self, axes: AxisSet) -> bool {
        let names_rapid = self.words.g.iter().any(|g| g.row.meaning == Meaning::Rapid);
        let moves = !axes.is_empty() && !self.words.g.iter().any(|g| g.row.group == Group::NonModal);
        self.in_force(Group::Motion, Meaning::Rapid) && self.cycle_kind().is_none() && (names_rapid || moves)
    }

    /// F of positioning, in force until the next one.
    fn rapid_feed_word(&mut self) -> Fallible<()> {
        let Some(f) = self.words.get(b'F') else { return Ok(()) };
        let feed = units::length_mm(f, self.modal.is_inch());
        if feed <= 0.0 {
            return Err(self.alarm_at(Fault::FeedOutOfRange, b'F'));
        }
        self.technology.rapid_feed = Some(feed);
        Ok(())
    }

    /// S: kept as programmed, and told to a spindle that turns. A surface speed is kept apart: G96 without S
    /// takes the last one, and none is 0 (GSK990MC 6.3).
    fn speed_word(&mut self) -> Fallible<()> {
        let Some(s) = self.words.get(b'S') else { return Ok(()) };
        if s > self.rules.max_speed_word {
            return Err(self.alarm_at(Fault::SpindleTooFast, b'S'));
        }
        match self.in_force(Group::SurfaceSpeed, Meaning::SurfaceSpeed) {
            true => self.technology.surface_speed = Some(units::length_mm(s, self.modal.is_inch())),
            false => self.technology.speed = Some(s),
        }
        self.tell_speed();
        Ok(())
    }

    /// Tells a spindle that turns its speed.
    pub(crate) fn tell_speed(&mut self) {
        let speed = self.speed();
        match self.technology.spindle {
            SpindleState::Off => {}
            SpindleState::Clockwise(_) => self.spindle(SpindleState::Clockwise(speed)),
            SpindleState::CounterClockwise(_) => self.spindle(SpindleState::CounterClockwise(speed)),
        }
    }

    /// The speed in force. Turns beyond the limit are held there (GSK990MC part 2, 7.10).
    pub(crate) fn speed(&self) -> Speed {
        if !self.in_force(Group::SurfaceSpeed, Meaning::SurfaceSpeed) {
            return Speed::Rpm(self.technology.speed.unwrap_or(0.0).min(self.rules.max_spindle_rpm));
        }
        let axis = self.technology.surface_axis;
        let max = self.technology.surface_max_rpm.unwrap_or(self.rules.max_spindle_rpm);
        Speed::Surface {
            mm_per_min: self.technology.surface_speed.unwrap_or(0.0),
            min_rpm: self.rules.surface_min_rpm,
            max_rpm: Some(max.min(self.rules.max_spindle_rpm)),
            axis,
            // The centre is the zero of the work coordinate system (6.3, 3).
            center: self.location.work.shift[axis] + self.location.length.vector[axis],
        }
    }

    /// G96 and G97 (GSK990MC 6.3). Where surface speed is not fitted G96 changes nothing.
    fn surface_speed(&mut self, row: &'static GCode, span: Span) -> Fallible<()> {
        if !self.rules.surface_speed {
            return Ok(());
        }
        let was = self.speed();
        self.modal.set(row);
        if row.meaning == Meaning::SurfaceSpeed {
            if let Some(number) = self.words.take(b'P') {
                let axis = self.rules.axis_order.get((number - 1.0).max(-1.0) as usize).copied();
                let is_carried = |axis: &Axis| self.rules.axes.contains(*axis);
                match axis.filter(is_carried).filter(|_| number >= 1.0 && number.fract() == 0.0) {
                    Some(axis) => self.technology.surface_axis = axis,
                    None => return Err(self.alarm(Fault::SurfaceSpeedAxis, span)),
                }
            }
            if !self.words.has(b'S') {
                self.tell_speed();
            }
            return Ok(());
        }
        // The turns of the moment go on where G97 gives no S.
        if let Speed::Surface { .. } = was {
            self.technology.speed = Some(was.rpm(&self.location.machine));
            if !self.words.has(b'S') {
                self.tell_speed();
            }
        }
        Ok(())
    }

    /// Tells the spindle, unless it is as told already.
    pub(crate) fn spindle(&mut self, state: SpindleState) {
        if self.technology.spindle != state {
            self.technology.spindle = state;
            self.emit(Op::Spindle(state));
        }
    }

    fn coolant(&mut self, on: bool) {
        if self.technology.coolant != on {
            self.technology.coolant = on;
            self.emit(Op::Coolant(on));
        }
    }

    /// Carries out the M codes that start with the block's motion, or those that wait for its end, from one
    /// on. Ends before one that a program stands for, and tells what is to be done behind it.
    fn m_functions(&mut self, after: bool, from: usize, rest: &mut Rest) -> Fallible<Option<(Custom, Span)>> {
        for at in from..self.words.m.len() {
            let Some(Code { row, span }) = self.words.m.get(at).copied() else { break };
            if row.after_motion != after {
                continue;
            }
            if rest.builtin != Some(at)
                && let Some(code) = self.custom_m(row)
            {
                // The program of an end of program comes before the end.
                let ends = row.function == MFunction::ProgramEnd;
                rest.builtin = ends.then_some(at);
                let next = if ends { at } else { at + 1 };
                rest.part = if after { Part::After(next) } else { Part::Before(next) };
                return Ok(Some((code, span)));
            }
            self.m_function(row, span)?;
        }
        Ok(None)
    }

    pub(crate) fn m_function(&mut self, code: &MCode, span: Span) -> Fallible<()> {
        self.technology.m_code = Some(f64::from(code.code));
        let speed = self.speed();
        match code.function {
            MFunction::Stop => self.emit(Op::Stop(code.code.into())),
            MFunction::OptionalStop if self.options.optional_stop => self.emit(Op::Stop(code.code.into())),
            MFunction::OptionalStop => {}
            MFunction::SpindleClockwise => self.spindle(SpindleState::Clockwise(speed)),
            MFunction::SpindleCounterClockwise => self.spindle(SpindleState::CounterClockwise(speed)),
            MFunction::SpindleOff => self.spindle(SpindleState::Off),
            MFunction::Orient => {
                self.technology.spindle = SpindleState::Off;
                self.emit(Op::Orient(0.0));
            }
            MFunction::CoolantOn => self.coolant(true),
            MFunction::CoolantOff => self.coolant(false),
            // By itself it changes nothing where the tool is in the spindle already (GSK990MC 8.1).
            MFunction::ToolChange
                if !self.words.has(b'T') && self.technology.in_spindle == self.technology.tool => {}
            MFunction::ToolChange => {
                self.technology.in_spindle = self.technology.tool;
                // The spindle stands still while a tool is changed.
                self.spindle(SpindleState::Off);
                self.emit(Op::Change(self.technology.tool));
                if self.rules.tools_carry_offsets {
                    self.tool_changed(self.words.get(b'D'));
                }
            }
            MFunction::RigidTapping => {
                if self.cycle_kind().is_some() {
                    return Err(self.alarm(Fault::RigidInCycle, span));
                }
                self.technology.rigid_tapping = true;
                self.emit(Op::Machine(code.code.into()));
            }
            MFunction::RigidTappingOff => {
                self.technology.rigid_tapping = false;
                self.emit(Op::Machine(code.code.into()));
            }
            MFunction::Machine => self.emit(Op::Machine(code.code.into())),
            MFunction::Call => return self.subprogram_call(span),
            MFunction::Return => {
                if !self.go_back() && self.start_again(span)? {
                    self.end_program(code.code);
                }
            }
            MFunction::ProgramEnd => self.end_program(code.code),
            MFunction::Message => self.message(),
            MFunction::Internal => self.internal_number()?,
            MFunction::SetOutput => self.set_output(span)?,
            MFunction::ReferenceReached => self.reference_reached(span)?,
            MFunction::End => {
                // In a subprogram M02 and M30 are M99 (GSK990MC 3.2).
                if !self.go_back() {
                    self.end_program(code.code);
                }
            }
        }
        Ok(())
    }

    /// Spindle and coolant stop with the program (GSK990MC 5.2.1).
    fn end_program(&mut self, code: u16) {
        if let Some(alarm) = self.unended_profile() {
            self.note(alarm);
        }
        if self.rules.end_stops_spindle {
            self.spindle(SpindleState::Off);
        }
        self.coolant(false);
        self.emit(Op::End(code.into()));
        self.ended = true;
    }

    /// M98 P L (GSK990MC 3.2.2).
    fn subprogram_call(&mut self, span: Span) -> Fallible<()> {
        // A macro calls macros only (alarm 0081).
        if self.in_macro() {
            return Err(self.alarm(Fault::CallInMacro, span));
        }
        self.program_call(span)
    }

    /// G65 of a control whose programs share their variables: other words set them (Weihong 4.4).
    fn g_call(&mut self, span: Span) -> Fallible<()> {
        for letter in b'A'..=b'Z' {
            if let Some(variable) = (self.dialect.argument)(letter)
                && let Some(value) = self.words.get(letter)
            {
                // There is room for those of letters.
                let _ = self.memory.variables.set(variable, Some(value));
                self.variable_writes += 1;
            }
        }
        self.program_call(span)
    }

    /// Calls the program that P names, L times, with the variables of its caller.
    fn program_call(&mut self, span: Span) -> Fallible<()> {
        let (program, at) = match (self.words.text(b'P'), self.words.get(b'P')) {
            (Some(name), _) => (ProgramId::named(&self.programs.slice(name)), self.words.long_span(b'P')),
            (None, Some(number)) if (1.0..=99_999.0).contains(&number) && number.fract() == 0.0 => {
                (ProgramId::Number(number as u32), self.words.span(b'P'))
            }
            (None, Some(_)) => return Err(self.alarm_at(Fault::ProgramNumber, b'P')),
            (None, None) => return Err(self.alarm(Fault::CallWithoutProgram, span)),
        };
        let times = self.words.get(b'L').unwrap_or(1.0);
        if times > self.rules.max_repeats {
            return Err(self.alarm_at(Fault::TooManyRepeats, b'L'));
        }
        self.call(&program, times.max(0.0) as u32, None, at)
    }

    fn non_modal(&mut self, code: Code<GCode>, axes: AxisSet, length: Option<Meaning>) -> Fallible<()> {
        let Code { row, span } = code;
        let reference = matches!(
            row.meaning,
            Meaning::ReferenceCheck
                | Meaning::ReferenceReturn
                | Meaning::FurtherReferenceReturn
                | Meaning::ReturnFromReference
        );
        let sets_position = row.meaning == Meaning::SetPosition && !axes.is_empty();
        let system = sets_position || row.meaning == Meaning::LocalZero;
        if reference || row.meaning == Meaning::MachinePosition || system {
            self.refuse_in_transform(span)?;
        }
        // Compensation is to be cancelled first (4.2.11 note 2); the manual gives no number.
        if sets_position && self.output.in_cutter_mode() {
            return Err(self.alarm(Fault::WorkOffsetInCutter, span));
        }
        if self.rules.coordinates.transforms_nest
            && (reference || system || row.meaning == Meaning::MachinePosition)
        {
            self.refuse_in_nested_scaling(span)?;
        }
        if reference && self.cycle_kind().is_some() && !self.rules.coordinates.reference_in_cycle {
            return Err(self.alarm(Fault::ReferenceInCycle, span));
        }
        match row.meaning {
            Meaning::Dwell => self.dwell(),
            Meaning::MachinePosition => self.machine_position(axes),
            Meaning::SetPosition => {
                if length.is_some() {
                    return Err(self.alarm(Fault::LengthWithCoordinateSet, self.words.block_span()));
                }
                if let Some(s) = self.words.get(b'S').filter(|_| self.rules.surface_speed) {
                    self.technology.surface_max_rpm = Some(s);
                    self.tell_speed();
                }
                self.set_position(axes);
                Ok(())
            }
            Meaning::LocalZero => {
                self.local_zero(axes);
                Ok(())
            }
            Meaning::SetPositionOfOne => self.set_position_of_one(axes),
            Meaning::SetPositionForNow => {
                self.set_position_for_now(axes);
                Ok(())
            }
            Meaning::SetWorkZero => self.set_zero_word(axes),
            Meaning::SetToolLength => self.set_tool_length(),
            Meaning::Call => self.g_call(span),
            Meaning::Pattern(pattern) => self.pattern(pattern, axes, span),
            Meaning::Figure(format) => self.repeat_on_figure(format, span),
            Meaning::ChooseAxes => self.choose_axes(axes),
            Meaning::HomeSearch => self.home_search(axes),
            Meaning::PolarOrigin => {
                self.set_polar_origin();
                Ok(())
            }
            // Corners and ways of profiles stand in profiles alone.
            Meaning::ProfileRound
            | Meaning::ProfileChamfer
            | Meaning::ProfileEntry
            | Meaning::ProfileExit => Err(self.alarm(Fault::ProfileForm, span)),
            Meaning::MoveUntilInput => self.move_until_input(span),
            Meaning::WaitForInput => self.wait_for_input(span),
            Meaning::Undescribed => Err(self.alarm(Fault::NotSupported, span)),
            Meaning::ReferenceCheck => self.reference_check(axes),
            Meaning::ReferenceReturn => self.reference_return(axes, 1),
            Meaning::FurtherReferenceReturn => self.further_reference_return(axes),
            Meaning::ReturnFromReference => self.return_from_reference(axes),
            Meaning::Skip if self.output.in_cutter_mode() => Err(self.alarm(Fault::SkipInCutter, span)),
            Meaning::Skip => self.skip(axes, span),
            Meaning::CornerArc => self.corner_arc(span),
            Meaning::OneWay => self.position_one_way(axes),
            Meaning::DataSetting => self.set_data(axes, span),
            _ => Ok(()),
        }
    }

    /// G04 (GSK990MC 4.2.5): X, or another letter, in seconds goes before P; neither is no pause.
    fn dwell(&mut self) -> Fallible<()> {
        let seconds = self.rules.dwell_letter;
        let (letter, unit) = match self.words.has(seconds) {
            true => (seconds, 1.0),
            false => (b'P', self.rules.dwell_p_unit_s),
        };
        let Some(value) = self.words.get(letter) else { return Ok(()) };
        if value < 0.0 {
            return Err(self.alarm_at(Fault::NegativeDwell, letter));
        }
        if value == 0.0 {
            return Ok(());
        }
        let turns = self.rules.dwell_in_revolutions && self.modal.is_feed_per_revolution();
        let amount = value * unit;
        self.emit(Op::Dwell(if turns { Dwell::Revolutions(amount) } else { Dwell::Seconds(amount) }));
        Ok(())
    }

    /// After a faulty block, for a checker: takes its end point as reached and its end of program as
    /// meant, so that the blocks behind it are judged as the author meant them.
    fn recover(&mut self) -> Fallible<()> {
        let is_move = !self.words.g.iter().any(|g| g.row.group == Group::NonModal);
        if is_move {
            let axes = self.words.axes(self.rules.axes);
            let to = self.end_point(axes);
            if to.is_finite() {
                self.location.programmed = to;
                self.location.machine = self.location.machine_of(to);
                self.output.jump_to(self.location.machine);
            }
        }
        for at in 0..self.words.m.len() {
            if let Some(Code { row, span }) = self.words.m.get(at).copied()
                && matches!(row.function, MFunction::End | MFunction::Return)
            {
                return self.m_function(row, span);
            }
        }
        Ok(())
    }
}

/// When a code of a block with several has its turn.
fn turn_of(meaning: Meaning) -> usize {
    match meaning {
        Meaning::PolarOff | Meaning::ScalingOff | Meaning::RotationOff => 0,
        Meaning::PolarOn => 2,
        _ => 1,
    }
}

/// The rule that a defect of the text breaks.
fn fault_of(kind: DefectKind) -> Fault {
    match kind {
        DefectKind::IllegalCharacter => Fault::IllegalCharacter,
        DefectKind::NumberWithoutAddress => Fault::NumberWithoutAddress,
        DefectKind::AddressWithoutNumber => Fault::AddressWithoutNumber,
        DefectKind::MisplacedSign => Fault::MisplacedSign,
        DefectKind::MisplacedPoint => Fault::MisplacedPoint,
        DefectKind::NumberTooLarge => Fault::NumberTooLarge,
        DefectKind::LineTooLong => Fault::LineTooLong,
        DefectKind::UnclosedComment => Fault::UnclosedComment,
        DefectKind::UnbalancedBracket => Fault::UnbalancedBracket,
        DefectKind::BracketsTooDeep => Fault::BracketsTooDeep,
        DefectKind::MalformedExpression => Fault::MalformedExpression,
        DefectKind::UnknownFunction => Fault::UnknownFunction,
        DefectKind::MalformedStatement => Fault::MalformedStatement,
        DefectKind::MixedStatement => Fault::MixedStatement,
        DefectKind::UnknownVariable => Fault::UnknownVariable,
        DefectKind::UnclosedText => Fault::UnclosedText,
    }
}
