//! One block: its words are read and checked, then done in the order of the language (LinuxCNC, order of
//! execution).
//!
//! Nothing is changed before every word was read and the codes were found to go together, so that a block at
//! fault does nothing.

use super::codes::{MGroup, m_group};
use super::expressions::WHOLE;
use crate::Fallible;
use crate::dialect::{GCode, MCode, MFunction, Meaning};
use crate::execute::fault_of;
use crate::interpreter::Interpreter;
use crate::modal::Group;
use crate::words::Code;
use ferrocut_geometry::Turn;
use ferrocut_machine::{Alarm, Fault};
use ferrocut_program::{Block, Page, Span, Value, Word};
use ferrocut_toolpath::{Dwell, Op, Speed, SpindleState};

/// M codes of a block at most (LinuxCNC, read_m).
const MAX_M: usize = 4;

/// The codes of a block by their groups.
#[derive(Clone, Copy)]
pub(super) struct Codes {
    g: [Option<&'static GCode>; Group::COUNT + 1],
    m: [Option<&'static MCode>; MGroup::COUNT],
}

impl Codes {
    /// The code of a modal group.
    #[inline]
    pub(super) fn g(&self, group: Group) -> Option<&'static GCode> {
        self.g.get(group as usize).copied().flatten()
    }

    /// The M code of a group.
    #[inline]
    pub(super) fn m(&self, group: MGroup) -> Option<&'static MCode> {
        self.m.get(group as usize).copied().flatten()
    }
}

/// Runs a block.
pub(super) fn run(interpreter: &mut Interpreter, page: &Page, block: &Block, index: usize) -> Fallible<()> {
    if interpreter.is_skipped(block) {
        return Ok(());
    }
    interpreter.words.start(page, block);
    interpreter.output.start_block();
    match interpreter.ngc_block(page, block, index) {
        Err(alarm) if interpreter.options.keep_going => {
            interpreter.note(alarm);
            Ok(())
        }
        done => done,
    }
}

impl Interpreter {
    /// An alarm about the whole block.
    pub(super) fn ngc_alarm(&self, fault: Fault) -> Box<Alarm> {
        self.alarm(fault, self.words.block_span())
    }

    fn ngc_block(&mut self, page: &Page, block: &Block, index: usize) -> Fallible<()> {
        if block.is_mark {
            self.end_program(2);
            return Ok(());
        }
        if block.is_defective
            && let Some(defect) = page.defects(index).next()
        {
            return Err(self.alarm(fault_of(defect.kind), page.span(block, defect.at, defect.len)));
        }
        if let Some(word) = page.o_word(block) {
            let _ = word;
            return Err(self.ngc_alarm(Fault::NotSupported));
        }
        let codes = self.ngc_read(page, block)?;
        self.ngc_execute(&codes)
    }

    /// Reads the words of a block, and sets its parameters.
    fn ngc_read(&mut self, page: &Page, block: &Block) -> Fallible<Codes> {
        let mut codes = Codes { g: [None; Group::COUNT + 1], m: [None; MGroup::COUNT] };
        let mut m_codes = 0;
        self.ngc.settings.clear();
        for word in page.words(block) {
            let span = || page.word_span(block, word);
            let value = match word.value() {
                Value::Number(value) => value,
                Value::Text(_) => continue,
                Value::Expression(range) if word.letter == b'#' => {
                    let setting = self.ngc_setting(page, range).map_err(|fault| self.alarm(fault, span()))?;
                    self.ngc.settings.push(setting);
                    continue;
                }
                Value::Expression(range) => {
                    self.ngc_value(page, range).map_err(|fault| self.alarm(fault, span()))?
                }
            };
            match word.letter {
                b'G' => self.ngc_g_word(&mut codes, value, span())?,
                b'M' => {
                    m_codes += 1;
                    if m_codes > MAX_M {
                        return Err(self.alarm(Fault::TooManyMCodes, span()));
                    }
                    self.ngc_m_word(&mut codes, value, span())?;
                }
                b'N' => {}
                _ => self.ngc_plain_word(word, value, span())?,
            }
        }
        for at in 0..self.ngc.settings.len() {
            let Some((number, value)) = self.ngc.settings.get(at).copied() else { break };
            self.ngc_set(number, value).map_err(|fault| self.ngc_alarm(fault))?;
        }
        Ok(codes)
    }

    fn ngc_plain_word(&mut self, word: &Word, value: f64, span: Span) -> Fallible<()> {
        if self.dialect.address(word.letter).is_none() {
            return Err(self.alarm(Fault::UnknownAddress, span));
        }
        if !value.is_finite() {
            return Err(self.alarm(Fault::NumberTooLarge, span));
        }
        match self.words.put_word(word, value) {
            true => Ok(()),
            false => Err(self.alarm(Fault::RepeatedAddress, span)),
        }
    }

    fn ngc_g_word(&mut self, codes: &mut Codes, value: f64, span: Span) -> Fallible<()> {
        let tenths = value * 10.0;
        let whole = tenths.round();
        let row = ((tenths - whole).abs() <= 10.0 * WHOLE && (0.0..=999.0).contains(&whole))
            .then(|| self.dialect.g_code(whole as u16))
            .flatten();
        let Some(row) = row else { return Err(self.alarm(Fault::UnknownGCode, span)) };
        let Some(slot) = codes.g.get_mut(row.group as usize) else {
            return Err(self.alarm(Fault::UnknownGCode, span));
        };
        if slot.is_some() {
            return Err(self.alarm(Fault::RepeatedGroup, span));
        }
        *slot = Some(row);
        self.words.g.push(Code { row, span });
        Ok(())
    }

    fn ngc_m_word(&mut self, codes: &mut Codes, value: f64, span: Span) -> Fallible<()> {
        let whole = value.round();
        let row = ((value - whole).abs() <= WHOLE && (0.0..=999.0).contains(&whole))
            .then(|| self.dialect.m_code(whole as u16))
            .flatten();
        let Some(row) = row else { return Err(self.alarm(Fault::UnknownMCode, span)) };
        let group = m_group(row.code).map(|group| group as usize);
        let Some(slot) = group.and_then(|group| codes.m.get_mut(group)) else {
            return Err(self.alarm(Fault::UnknownMCode, span));
        };
        if slot.is_some() {
            return Err(self.alarm(Fault::RepeatedGroup, span));
        }
        *slot = Some(row);
        self.words.m.push(Code { row, span });
        Ok(())
    }

    /// Does a block that was read and found right.
    fn ngc_execute(&mut self, codes: &Codes) -> Fallible<()> {
        if let Some(row) = codes.g(Group::FeedMode) {
            self.modal.set(row);
        }
        self.ngc.has_feed_word = self.words.has(b'F');
        if let Some(feed) = self.words.get(b'F') {
            if feed < 0.0 {
                return Err(self.alarm_at(Fault::FeedOutOfRange, b'F'));
            }
            self.ngc.feed = feed;
        }
        if let Some(speed) = self.words.get(b'S') {
            if speed < 0.0 {
                return Err(self.alarm_at(Fault::WordNegative, b'S'));
            }
            self.technology.speed = Some(speed);
            self.tell_speed();
        }
        if let Some(tool) = self.words.get(b'T') {
            if !(0.0..=f64::from(u32::MAX)).contains(&tool) {
                return Err(self.alarm_at(Fault::ToolNumber, b'T'));
            }
            self.technology.tool = tool.round() as u32;
            self.emit(Op::Select(self.technology.tool));
        }
        if codes.m(MGroup::Tool).is_some() {
            self.technology.in_spindle = self.technology.tool;
            self.spindle(SpindleState::Off);
            self.emit(Op::Change(self.technology.tool));
        }
        if let Some(row) = codes.m(MGroup::Spindle) {
            let speed = Speed::Rpm(self.technology.speed.unwrap_or(0.0));
            match row.function {
                MFunction::SpindleClockwise => self.spindle(SpindleState::Clockwise(speed)),
                MFunction::SpindleCounterClockwise => self.spindle(SpindleState::CounterClockwise(speed)),
                _ => self.spindle(SpindleState::Off),
            }
        }
        if let Some(row) = codes.m(MGroup::Coolant) {
            self.coolant(row.function == MFunction::CoolantOn);
        }
        let non_modal = codes.g(Group::NonModal).map(|row| row.meaning);
        if non_modal == Some(Meaning::Dwell) {
            match self.words.get(b'P') {
                Some(p) if p > 0.0 => self.emit(Op::Dwell(Dwell::Seconds(p))),
                Some(0.0) => {}
                _ => return Err(self.alarm_at(Fault::NegativeDwell, b'P')),
            }
        }
        for group in [Group::Plane, Group::Units] {
            if let Some(row) = codes.g(group) {
                self.modal.set(row);
            }
        }
        for group in [Group::PathControl, Group::Distance, Group::CentreDistance, Group::Return] {
            if let Some(row) = codes.g(group) {
                self.modal.set(row);
            }
        }
        self.ngc.in_machine = non_modal == Some(Meaning::MachinePosition);
        self.ngc_motion(codes)?;
        if let Some(row) = codes.m(MGroup::Stop) {
            self.ngc_stop(row);
        }
        Ok(())
    }

    /// The move of the block by the motion code in force.
    fn ngc_motion(&mut self, codes: &Codes) -> Fallible<()> {
        let axes = self.words.axes(self.rules.axes);
        if let Some(row) = codes.g(Group::Motion) {
            self.modal.set(row);
        }
        let motion = self.modal.meaning(Group::Motion);
        match motion {
            Meaning::ArcClockwise | Meaning::ArcCounterClockwise => {
                let names_centre = [b'I', b'J', b'K'].into_iter().any(|letter| self.words.has(letter));
                if axes.is_empty() && !names_centre {
                    return Ok(());
                }
                let clockwise = motion == Meaning::ArcClockwise;
                self.ngc_arc(axes, if clockwise { Turn::Clockwise } else { Turn::CounterClockwise })
            }
            _ if axes.is_empty() => Ok(()),
            Meaning::Rapid => self.ngc_rapid(self.ngc_end_point(axes)),
            Meaning::Linear => self.ngc_cut(self.ngc_end_point(axes)),
            _ => Err(self.ngc_alarm(Fault::NotSupported)),
        }
    }

    fn ngc_stop(&mut self, row: &MCode) {
        match row.function {
            MFunction::ProgramEnd => self.end_program(row.code),
            MFunction::OptionalStop if !self.options.optional_stop => {}
            _ => self.emit(Op::Stop(row.code.into())),
        }
    }
}
