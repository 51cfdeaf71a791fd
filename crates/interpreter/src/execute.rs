//! What a block does, in the order of GSK990MC 4.1 and 5.2: modal codes, F S T, M codes that start
//! with the motion, the motion or the non-modal code, M codes that wait for its end.

use crate::Fallible;
use crate::dialect::{MCode, MFunction, Meaning};
use crate::interpreter::Interpreter;
use crate::modal::Group;
use crate::stages::distance;
use crate::stages::units;
use crate::stages::work_offset::WorkSystem;
use crate::words::{AXIS_LETTERS, Code, Reader};
use ferrocut_geometry::{AxisSet, Position};
use ferrocut_machine::{Alarm, Fault, WorkOffset};
use ferrocut_program::{Block, DefectKind, Page, ProgramId, Span, Value as WordValue};
use ferrocut_toolpath::{Dwell, Op, SpindleState};

/// The non-modal code of a block, if it has one.
type NonModal = Option<Meaning>;

impl Interpreter {
    /// Executes one block.
    pub(crate) fn execute(&mut self, page: &Page, block: &Block, index: usize) -> Fallible<()> {
        if self.is_skipped(block) {
            return Ok(());
        }
        self.words.start(page, block);
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
            let number = if let WordValue::Number(number) = first.value() { number } else { 0.0 };
            self.program_number(number, page.word_span(block, first))?;
            if block.words == 1 && block.statement.is_none() {
                return Ok(());
            }
        }
        self.enter_program();
        if let Some(statement) = page.statement(block) {
            return match self.statement(page, *statement) {
                Err(alarm) if self.options.keep_going => {
                    self.note(alarm);
                    Ok(())
                }
                done => done,
            };
        }
        for word in page.words(block) {
            if word.letter == b'G' && word.value() == WordValue::Number(f64::from(self.dialect.macro_call) / 10.0) {
                return match self.macro_block(page, block) {
                    Err(alarm) if self.options.keep_going => {
                        self.note(alarm);
                        Ok(())
                    }
                    done => done,
                };
            }
            let value = match word.value() {
                WordValue::Number(value) => value,
                WordValue::Expression(range) => match self.evaluate(page, range) {
                    Ok(Some(value)) => value,
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
            };
            if let Err(alarm) = reader.word(&mut self.words, word, value) {
                self.note(alarm);
                sound = false;
            }
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
        if self.words.sequence.is_some() {
            self.technology.sequence = self.words.sequence;
        }
        self.check_m_codes()?;
        let axes = self.axes_of_block()?;
        let mut non_modal: NonModal = None;
        let mut motion = false;
        let mut cycle = None;
        let mut length = None;
        for at in 0..self.words.g.len() {
            let Some(&Code { row, span }) = self.words.g.get(at) else { break };
            match row.group {
                Group::NonModal => non_modal = Some(row.meaning),
                Group::Motion => {
                    motion = true;
                    self.modal.set(row);
                }
                Group::Cycle => cycle = Some(row),
                Group::Length => {
                    length = Some(row.meaning);
                    self.modal.set(row);
                }
                Group::WorkOffset => self.select_work_offset(row.meaning, span)?,
                Group::Plane => {
                    let was = self.modal.plane();
                    self.modal.set(row);
                    if self.cycle.is_active() && self.modal.plane() != was {
                        return Err(self.alarm(Fault::PlaneInCycle, span));
                    }
                }
                _ => self.modal.set(row),
            }
            if row.group == Group::WorkOffset {
                self.modal.set(row);
            }
        }
        // A motion code ends the cycle, also one of the same block (GSK990MC 4.1 note 6).
        match cycle {
            _ if motion => self.cancel_cycle(),
            Some(row) if row.meaning == Meaning::CycleOff => self.cancel_cycle(),
            Some(row) => self.modal.set(row),
            None => {}
        }
        if self.words.has(b'F') {
            self.feed_word()?;
        }
        if self.words.has(b'S') {
            self.speed_word();
        }
        if let Some(tool) = self.words.get(b'T') {
            self.technology.tool = tool as u32;
            self.emit(Op::Select(tool as u32));
        }
        self.m_functions(false)?;
        match non_modal {
            Some(code) => self.non_modal(code, axes, length)?,
            None if self.cycle_kind().is_some() => self.cycle_block(axes, length)?,
            None => {
                let length_moves = self.length_words(length, axes)?;
                self.motion_block(axes, length_moves)?;
            }
        }
        // The holes of a cycle are made one by one; what waits for the block's end comes after the last.
        if self.has_holes_left() { Ok(()) } else { self.m_functions(true) }
    }

    /// The axes that the block names; an alarm for one that the control does not carry.
    fn axes_of_block(&self) -> Fallible<AxisSet> {
        if !self.words.has_any(AXIS_LETTERS) {
            return Ok(AxisSet::EMPTY);
        }
        for axis in ferrocut_geometry::Axis::ALL {
            let letter = axis.letter() as u8;
            if self.words.has(letter) && !self.rules.axes.contains(axis) {
                return Err(self.alarm_at(Fault::UnknownAxis, letter));
            }
        }
        Ok(self.words.axes(self.rules.axes))
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

    /// G54 to G59 and G54 P.
    fn select_work_offset(&mut self, meaning: Meaning, span: Span) -> Fallible<()> {
        let Meaning::WorkOffset(standard) = meaning else { return Ok(()) };
        let name = match self.words.get(b'P') {
            Some(number) if standard == 1 => {
                self.words.take(b'P');
                if !(1.0..=f64::from(u16::MAX)).contains(&number) || number.fract() != 0.0 {
                    return Err(self.alarm(Fault::WorkOffsetNumber, span));
                }
                WorkOffset::Additional(number as u16)
            }
            _ => WorkOffset::Standard(standard),
        };
        let Some(system) = WorkSystem::select(name, &self.memory.work) else {
            return Err(self.alarm(Fault::WorkOffsetNumber, span));
        };
        self.location.work = system;
        // The axes stand still; their coordinates are those of the new system (GSK990MC 4.2.8).
        self.location.take_machine();
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
            _ => return Ok(false),
        };
        let axis = match self.rules.length_on_plane_normal {
            true => self.modal.plane().normal(),
            false => ferrocut_geometry::Axis::Z,
        };
        if let Some(h) = h {
            let Some(offset) = self.memory.tools.get(h as u16) else {
                return Err(self.alarm_at(Fault::OffsetNumber, b'H'));
            };
            self.location.length.number = h as u16;
            // H00 alone waits for the axis or for a code of its group (GSK990MC 4.7.1, 4).
            if h == 0.0 && code.is_none() && !axes.contains(axis) {
                self.location.length.waits = true;
                return Ok(false);
            }
            let value = sign * (offset.length + offset.length_wear);
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

    fn put_length(&mut self, axis: ferrocut_geometry::Axis, value: f64) -> bool {
        let changed = self.location.length.vector[axis] != value;
        self.location.length.set(axis, value);
        changed
    }

    /// F: feed in force until the next one. Feed per minute is held within the control's limits
    /// (GSK990MC 4.2.2, P96, P97); feed per revolution beyond its range is an alarm (7.2.2).
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
            self.technology.feed_per_minute = feed.clamp(self.rules.min_feed, self.rules.max_feed);
        }
        Ok(())
    }

    /// S: kept, and told to a spindle that turns. Beyond the limit it is held there (GSK990MC 7.10).
    fn speed_word(&mut self) {
        let Some(s) = self.words.get(b'S') else { return };
        let speed = s.min(self.rules.max_spindle_rpm);
        self.technology.speed = Some(speed);
        match self.technology.spindle {
            SpindleState::Off => {}
            SpindleState::Clockwise(_) => self.spindle(SpindleState::Clockwise(speed)),
            SpindleState::CounterClockwise(_) => self.spindle(SpindleState::CounterClockwise(speed)),
        }
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

    /// Carries out the M codes that start with the block's motion, or those that wait for its end.
    pub(crate) fn m_functions(&mut self, after_motion: bool) -> Fallible<()> {
        for at in 0..self.words.m.len() {
            match self.words.m.get(at).copied() {
                Some(Code { row, span }) if row.after_motion == after_motion => self.m_function(row, span)?,
                _ => {}
            }
        }
        Ok(())
    }

    fn m_function(&mut self, code: &MCode, span: Span) -> Fallible<()> {
        self.technology.m_code = Some(f64::from(code.code));
        let speed = self.technology.speed.unwrap_or(0.0);
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
            MFunction::ToolChange => {
                // The spindle stands still while a tool is changed.
                self.spindle(SpindleState::Off);
                self.emit(Op::Change(self.technology.tool));
            }
            MFunction::Machine => self.emit(Op::Machine(code.code.into())),
            MFunction::Call => return self.subprogram_call(span),
            MFunction::Return => {
                if !self.go_back() && self.start_again(span)? {
                    self.end_program(code.code);
                }
            }
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
        self.spindle(SpindleState::Off);
        self.coolant(false);
        self.emit(Op::End(code.into()));
        self.ended = true;
    }

    /// M98 P L (GSK990MC 3.2.2).
    fn subprogram_call(&mut self, span: Span) -> Fallible<()> {
        let Some(number) = self.words.get(b'P') else {
            return Err(self.alarm(Fault::CallWithoutProgram, span));
        };
        if !(1.0..=99_999.0).contains(&number) || number.fract() != 0.0 {
            return Err(self.alarm_at(Fault::ProgramNumber, b'P'));
        }
        let times = self.words.get(b'L').unwrap_or(1.0);
        if times > self.rules.max_repeats {
            return Err(self.alarm_at(Fault::TooManyRepeats, b'L'));
        }
        let at = self.words.span(b'P');
        self.call(&ProgramId::Number(number as u32), times.max(0.0) as u32, None, at)
    }

    fn non_modal(&mut self, code: Meaning, axes: AxisSet, length: Option<Meaning>) -> Fallible<()> {
        match code {
            Meaning::Dwell => self.dwell(),
            Meaning::MachinePosition => self.machine_position(axes),
            Meaning::SetPosition => {
                if length.is_some() {
                    return Err(self.alarm(Fault::LengthWithCoordinateSet, self.words.block_span()));
                }
                self.set_position(axes);
                Ok(())
            }
            _ => Ok(()),
        }
    }

    /// G04 (GSK990MC 4.2.5): X in seconds goes before P; neither is no pause.
    fn dwell(&mut self) -> Fallible<()> {
        let (letter, unit) = match self.words.has(b'X') {
            true => (b'X', 1.0),
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

    /// G53 (GSK990MC 4.2.10): rapid to a machine position, tool length left aside. With G91 the block
    /// does nothing, as on Fanuc.
    fn machine_position(&mut self, axes: AxisSet) -> Fallible<()> {
        if self.modal.is_incremental() {
            return Ok(());
        }
        let machine = self.location.machine;
        let to = distance::end_point(&self.words, axes, machine, false, self.modal.is_inch());
        self.rapid_machine(to)?;
        self.location.take_machine();
        Ok(())
    }

    /// G92 (GSK990MC 4.2.11): the point where the tool stands, tool length left aside, gets the given
    /// coordinates.
    fn set_position(&mut self, axes: AxisSet) {
        if axes.is_empty() {
            return;
        }
        let location = &mut self.location;
        let here = distance::end_point(&self.words, axes, location.programmed, false, self.modal.is_inch());
        let at = location.machine - location.length.vector;
        location.work = location.work.set_position(at, here, axes);
        location.take_machine();
    }

    /// After a faulty block, for a checker: takes its end point as reached and its end of program as
    /// meant, so that the blocks behind it are judged as the author meant them.
    fn recover(&mut self) -> Fallible<()> {
        let is_move = !self.words.g.iter().any(|g| g.row.group == Group::NonModal);
        if is_move {
            let axes = self.words.axes(self.rules.axes);
            let incremental = self.modal.is_incremental();
            let from = self.location.programmed;
            let to = distance::end_point(&self.words, axes, from, incremental, self.modal.is_inch());
            if to.is_finite() {
                self.location.programmed = to;
                self.location.machine = self.location.machine_of(to);
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
    }
}
