//! What a block does, in the order of GSK990MC 4.1 and 5.2: modal codes, F S T, M codes that start
//! with the motion, the motion or the non-modal code, M codes that wait for its end.

use crate::Fallible;
use crate::barrier::Present;
use crate::custom::Custom;
use crate::cycles::CycleKind;
use crate::dialect::{GCode, MFunction, Meaning};
use crate::interpreter::Interpreter;
use crate::modal::Group;
use crate::words::{self, Code, Reader};
use ferrocut_geometry::{Axis, AxisSet};
use ferrocut_machine::{Alarm, Fault};
use ferrocut_program::{Block, DefectKind, Page, Span, Value as WordValue, Word};
use ferrocut_toolpath::Op;
use smallvec::SmallVec;

/// Addresses of a feed or a pitch.
const FEED_LETTERS: u32 = words::letters(b"FI");

/// What the codes of a block ask for beyond the modal state.
#[derive(Clone, Default)]
pub(crate) struct Codes {
    /// The non-modal code, if there is one.
    pub(crate) non_modal: Option<Code<GCode>>,
    /// The code of tool length compensation, if there is one.
    pub(crate) length: Option<Meaning>,
    /// Whether there is a code of cutter compensation.
    pub(crate) cutter: bool,
    /// Codes of scaling and rotation, to be carried out after the others.
    pub(crate) transforms: SmallVec<[Code<GCode>; 2]>,
    /// Whether a code takes the block's coordinates for itself, so that nothing moves.
    pub(crate) takes_words: bool,
    /// Whether a code of scaling may change the side of the tool.
    pub(crate) mirrors: bool,
    /// A code that a program stands for.
    pub(crate) custom: Option<(Custom, Span)>,
    /// What rotary axes do in this block alone.
    pub(crate) rotary: RotaryBlock,
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
#[derive(Clone, Default)]
pub(crate) struct Rest {
    pub(crate) codes: Codes,
    pub(crate) axes: AxisSet,
    pub part: Part,
    /// The M code, by its place in the block, whose program was run before the code itself.
    pub(crate) builtin: Option<usize>,
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
        if let Some(run) = self.dialect.blocks {
            return run(self, page, block, index);
        }
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
        if block.is_defective {
            for defect in page.defects(index) {
                let alarm = self.alarm(fault_of(defect.kind), page.span(block, defect.at, defect.len));
                self.note(alarm);
            }
            if !self.options.keep_going {
                self.hand_out();
                return Ok(());
            }
        }
        if !self.begins_program(page, block)? {
            return Ok(());
        }
        self.enter_program();
        self.note_sequence(page, block);
        if self.data_setting.is_some() && page.statement(block).is_some() {
            return self.give_up_block(self.alarm(Fault::CommandInDataSetting, page.block_span(block)));
        }
        if !self.guard_holds(page, block)? {
            return Ok(());
        }
        if let Some(statement) = page.statement(block) {
            let done = self.statement(page, *statement);
            return self.noted(done);
        }
        let macro_call = WordValue::Number(f64::from(self.dialect.macro_call) / 10.0);
        let is_macro_call = |word: &Word| word.letter == b'G' && word.value() == macro_call;
        if page.words(block).iter().any(is_macro_call) {
            let done = self.macro_block(page, block);
            return self.noted(done);
        }
        let sound = self.read_words(page, block) && !block.is_defective;
        if self.present == Present::Asked {
            return Ok(());
        }
        if !sound {
            if self.options.keep_going {
                return self.recover();
            }
            self.hand_out();
            return Ok(());
        }
        if self.waits_for_lock() {
            self.present = Present::Asked;
            self.asks_for_lock = true;
            return Ok(());
        }
        self.asks_for_lock = false;
        match self.block_of_words() {
            Ok(()) => Ok(()),
            Err(alarm) => self.give_up_block(alarm),
        }
    }

    /// The alarm of a statement, where a check goes on behind it.
    fn noted(&mut self, done: Fallible<()>) -> Fallible<()> {
        match done {
            Err(alarm) if self.options.keep_going => {
                self.note(alarm);
                Ok(())
            }
            done => done,
        }
    }

    /// The O word that a block begins with: the number of the program. Whether there is more to do of the block.
    fn begins_program(&mut self, page: &Page, block: &Block) -> Fallible<bool> {
        let Some(first) = page.words(block).first().filter(|word| word.letter == b'O') else {
            return Ok(true);
        };
        let span = page.word_span(block, first);
        let fault = match first.value() {
            // A plain number in every language: programs are found by it before any of their blocks is run.
            WordValue::Expression(_) => Some(Fault::VariableInNumber),
            // A decimal point has no place in it (GSK990MC 3.1.1).
            _ if first.has_point() => Some(Fault::WordNotWhole),
            _ => None,
        };
        if let Some(fault) = fault {
            return self.give_up_block(self.alarm(fault, span)).map(|()| false);
        }
        let number = match first.value() {
            WordValue::Number(number) => number,
            // A program with a name has no number.
            WordValue::Text(_) | WordValue::Expression(_) => 0.0,
        };
        self.program_number(number, span)?;
        Ok(block.words > 1 || block.statement.is_some())
    }

    /// Whether the condition before a block is true; without one it is. A condition that waits for the machine is none yet.
    fn guard_holds(&mut self, page: &Page, block: &Block) -> Fallible<bool> {
        let Some(condition) = page.guard(block) else { return Ok(true) };
        match self.evaluate(page, condition) {
            _ if self.present == Present::Asked => Ok(false),
            Ok(value) => Ok(value.is_some_and(|v| v != 0.0)),
            Err(fault) => {
                let alarm = self.alarm(fault, page.block_span(block));
                self.give_up_block(alarm).map(|()| false)
            }
        }
    }

    /// Reads the words of a block with the values that they have now, and notes what is wrong with them; whether nothing is.
    fn read_words(&mut self, page: &Page, block: &Block) -> bool {
        let mut sound = true;
        let tool_axis = self.plane_axes()[2];
        for word in page.words(block) {
            let value = match word.value() {
                WordValue::Number(value) => Ok(value),
                WordValue::Text(text) => Err(text),
                // O and N are plain numbers (GSK990MC 4.9.2, 1 note 1), but for N of some controls.
                WordValue::Expression(_)
                    if word.letter == b'O'
                        || word.letter == b'N' && !self.rules.sequence_takes_expression =>
                {
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
                sets_data: self.data_setting.is_some(),
                max_m_code: self.rules.max_m_code,
                machine_codes: &self.options.machine_codes,
                distance_is_exclusive: self.rules.distance_is_exclusive,
                one_way: self.rules.one_way_is_modal.then_some(self.dialect.one_way_modal),
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
        sound
    }

    /// T calls a tool, and on some controls its offsets (Weihong 4.1).
    pub(crate) fn call_tool(&mut self, tool: u32) {
        self.technology.tool = tool;
        if self.rules.tool_chooses_offsets {
            self.technology.radius_number = f64::from(tool);
            self.location.length.number = tool as u16;
        }
    }

    /// A tool comes into the spindle: the offsets that T called take the place of those in force (Weihong 4.1), the
    /// length when the axis is next moved.
    pub(crate) fn tool_comes(&mut self) -> Fallible<()> {
        if !self.rules.tool_chooses_offsets {
            return Ok(());
        }
        self.location.length.waits |= self.modal.meaning(Group::Length) != Meaning::LengthOff;
        self.cutter_words(false)
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
        let mut rest = Rest::default();
        let codes = &mut rest.codes;
        self.modal_codes(codes)?;
        let axes = self.axes_beside_cycle(axes);
        rest.axes = axes;
        self.check_axes()?;
        self.check_moving_axes(axes, codes)?;
        self.check_rigid_tapping(axes, codes)?;
        self.check_corner(axes, codes)?;
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
        // With G92 an S is the highest speed of G96 (6.3), where the language has such a code, fitted or not.
        let limits_speed = codes.non_modal.is_some_and(|code| code.row.meaning == Meaning::SetPosition)
            && self.dialect.g_codes.iter().any(|row| row.meaning == Meaning::SurfaceSpeed);
        if self.words.has(b'S') && !limits_speed {
            self.speed_word()?;
        }
        if let Some(tool) = self.words.get(b'T') {
            if tool > self.rules.max_tool {
                return Err(self.alarm_at(Fault::ToolNumber, b'T'));
            }
            self.call_tool(tool as u32);
            self.emit(Op::Select(tool as u32));
        }
        if self.rules.tools_carry_offsets {
            self.offset_word();
        }
        if codes.cutter || self.words.has(b'D') && !self.rules.tools_carry_offsets {
            self.cutter_words(codes.cutter)?;
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
            self.check_referenced(rest.codes.non_modal.map(|code| code.row.meaning), axes)?;
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
                    if self.leaves_point_to_block(code.row.meaning) && self.has_point_or_cycle(axes) {
                        self.axes_of_block(axes, None)?;
                    }
                }
                None if rest.codes.takes_words => self.length_by_itself(length)?,
                None => self.axes_of_block(axes, length)?,
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

    /// What the words of axes are there for: a cycle, or a move.
    fn axes_of_block(&mut self, axes: AxisSet, length: Option<Meaning>) -> Fallible<()> {
        self.stay_where_not_named(axes, length.is_some());
        if self.is_zone_block() {
            return self.zone_block(axes);
        }
        if self.cycle_kind().is_some() {
            return self.cycle_block(axes, length);
        }
        let length_moves = self.length_words(length, axes)?;
        self.motion_block(axes, length_moves)
    }

    /// Does what waits for the last hole of the block.
    pub(crate) fn end_holes(&mut self) -> Fallible<()> {
        self.finish_block(&mut Rest::at(Part::After(0)))
    }

    /// Puts the block's modal codes in force.
    fn modal_codes(&mut self, codes: &mut Codes) -> Fallible<()> {
        let mut motion: Option<Code<GCode>> = None;
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
            if count > 1 && (at / count != turn_of(row.meaning) || self.is_overruled(at % count)) {
                continue;
            }
            if let Some(custom) = self.custom_g(row) {
                if let Some((_, before)) = codes.custom.replace((custom, span)) {
                    return Err(self.alarm(Fault::NeedsOwnBlock, before));
                }
                continue;
            }
            match row.group {
                Group::NonModal if row.meaning == Meaning::FullFeed => self.full_feed = true,
                // G11 has done what it does ([`Self::block_of_words`]), and has no words of its own.
                Group::NonModal if matches!(row.meaning, Meaning::NoEffect | Meaning::DataSettingOff) => {}
                Group::NonModal if row.meaning == Meaning::EncoderLatch => self.encoder_latch(span),
                Group::NonModal if row.meaning == Meaning::WaitForInput => self.wait_for_input(span)?,
                Group::NonModal if row.meaning == Meaning::ShortestWay => codes.rotary.shortest = true,
                Group::NonModal if row.meaning == Meaning::InDegrees => codes.rotary.degrees = true,
                Group::NonModal => codes.non_modal = Some(code),
                Group::Motion => {
                    motion = Some(code);
                    self.modal.set(row);
                }
                Group::Cycle => {
                    if row.meaning == Meaning::CycleOff {
                        self.technology.rigid_tapping = false;
                    }
                    if let Some(before) = cycle.replace(code) {
                        self.refuse_beside_own(before, row)?;
                    }
                }
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
                    self.check_units_alone(span);
                    self.modal.set(row);
                }
                Group::Polar => {
                    self.refuse_in_corner()?;
                    self.modal.set(row);
                    self.polar(row.meaning);
                }
                Group::Scaling | Group::Rotation | Group::Mirror => {
                    self.refuse_in_corner()?;
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
                    self.output.check_changes(self.flow.begun(), self.stroke_check_2);
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
        // The program of a code takes the block's words: no other code of the block acts on them.
        if codes.custom.is_some()
            && let Some(other) =
                codes.non_modal.or(cycle.filter(|code| code.row.meaning != Meaning::CycleOff))
        {
            return Err(self.alarm(Fault::NeedsOwnBlock, other.span));
        }
        // A motion code ends the cycle, also one of the same block (GSK990MC 4.1 note 6).
        match cycle.map(|code| code.row) {
            // A program of the shop is run, whatever stands beside its code.
            Some(row) if row.meaning == Meaning::Cycle(CycleKind::Own) => {
                if let Some(code) = codes.non_modal {
                    return Err(self.alarm(Fault::NeedsOwnBlock, code.span));
                }
                self.modal.set(row);
                // Within itself the code is what the control has for it: nothing.
                if self.custom_cycle().is_none() {
                    self.cancel_cycle();
                    return Err(self.alarm(Fault::UnknownGCode, self.cycle_span()));
                }
            }
            _ if motion.is_some() && !beside_motion => self.cancel_cycle(),
            Some(row) if row.meaning == Meaning::CycleOff => self.cancel_cycle(),
            Some(row) => self.modal.set(row),
            None => {}
        }
        // It makes no hole there, and beside a code that acts alone its words are lost (GSK990MC 4.1 notes 1 and 6). Cycles of
        // words in a zone of influence are refused.
        if let Some(Code { row: GCode { meaning: Meaning::Cycle(kind), .. }, span }) = cycle
            && !matches!(kind, CycleKind::Own | CycleKind::Words(_))
            && let Some(other) = codes.non_modal.or(motion.filter(|_| !beside_motion))
        {
            let alarm = Alarm::core(Fault::CycleBesideCode, span);
            self.tell(alarm.with("word", self.programs.slice(other.span)));
        }
        self.length_code(length, codes)?;
        // Centres of transformations are coordinates too; the words of a call are its arguments.
        if let Some(rotary) = self.rules.motion.rotary_y
            && codes.non_modal.is_none_or(|code| code.row.meaning != Meaning::Call)
        {
            self.rotary_word(rotary, codes.rotary);
        }
        self.transform_codes(codes)
    }

    /// Whether a code of the block goes for nothing because a later one of its group wins (4.1 note 5). Others are put in
    /// force one over the other, so that the last stays; these do something of their own.
    fn is_overruled(&self, at: usize) -> bool {
        let g = &self.words.g;
        let Some(group) = g.get(at).map(|code| code.row.group) else { return false };
        let acts = matches!(group, Group::Polar | Group::Scaling | Group::Rotation);
        acts && !self.rules.coordinates.transforms_nest
            && g.iter().skip(at + 1).any(|later| later.row.group == group)
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

    /// How many M codes (GSK990MC 5, bit 33#7, which names no alarm), and which together (alarm 0119).
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
            let limit = f64::from(self.rules.m_codes_in_block);
            return Err(Box::new(self.alarm(Fault::TooManyMCodes, span).with("limit", limit)));
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

    /// Neither a speed nor a move of the axes stands between M29 and its tapping cycle (GSK990MC alarm 0203, which is Fanuc's);
    /// tool length does (4.4.5, example).
    fn check_rigid_tapping(&self, axes: AxisSet, codes: &Codes) -> Fallible<()> {
        let waits = self.technology.rigid_tapping && self.cycle_kind().is_none();
        let decides = |function| matches!(function, MFunction::RigidTapping | MFunction::RigidTappingOff);
        if !waits || self.words.m.iter().any(|m| decides(m.row.function)) {
            return Ok(());
        }
        if self.words.has(b'S') {
            return Err(self.alarm_at(Fault::RigidMisplaced, b'S'));
        }
        let moves = match codes.non_modal.map(|code| code.row.meaning) {
            Some(
                Meaning::Skip
                | Meaning::MachinePosition
                | Meaning::OneWay
                | Meaning::ReferenceReturn
                | Meaning::FurtherReferenceReturn
                | Meaning::ReturnFromReference,
            ) => !axes.is_empty(),
            Some(_) => false,
            None => !codes.takes_words && self.block_moves(axes),
        };
        if moves { Err(self.alarm(Fault::RigidMisplaced, self.words.block_span())) } else { Ok(()) }
    }

    /// `,L` and `,R` stand at the end of moves that the motion codes make (GSK990MC 4.2.18).
    fn check_corner(&self, axes: AxisSet, codes: &Codes) -> Fallible<()> {
        let Some((.., span)) = self.words.comma else { return Ok(()) };
        let moves = codes.non_modal.is_none()
            && codes.custom.is_none()
            && !codes.takes_words
            && self.cycle_kind().is_none()
            && self.modal.meaning(Group::Motion) != Meaning::OneWay
            && self.block_moves(axes);
        if moves { Ok(()) } else { Err(self.alarm(Fault::CornerForm, span)) }
    }

    /// G20 and G21 stand in a block of their own (GSK990MC 4.2.17 note 6). The manual has no alarm for it, and its alarm 0165
    /// names other codes; which unit words beside them have is not said.
    fn check_units_alone(&mut self, span: Span) {
        let stands_alone = !self.words.has_any(u32::MAX) && self.words.m.is_empty();
        if self.rules.units_stand_alone && !stands_alone {
            self.tell(Alarm::core(Fault::NeedsOwnBlock, span));
        }
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
pub(crate) fn fault_of(kind: DefectKind) -> Fault {
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
