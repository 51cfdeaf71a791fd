//! One block: its words are read and checked, then done in the order of the language (LinuxCNC, order of
//! execution).
//!
//! Nothing is changed before every word was read and the codes were found to go together. What is at fault in a move
//! shows only where it is made; in a block that a sender sent that is taken back (`refused`).

use super::codes::{MGroup, m_group};
use super::expressions::WHOLE;
use super::polar::PolarWords;
use crate::Fallible;
use crate::dialect::{GCode, MCode, MFunction, Meaning};
use crate::execute::fault_of;
use crate::interpreter::Interpreter;
use crate::modal::Group;
use crate::words::{AXIS_LETTERS, Code, letters};
use ferrocut_machine::{Alarm, Fault};
use ferrocut_program::{Block, Page, Span, Value, Word};
use ferrocut_toolpath::{Dwell, Op};

/// M codes of a block at most.
const MAX_M: usize = 4;

/// Bytes within which the mark stands that a file may begin with.
const MARK_WITHIN: u32 = 4096;

/// Words that mean nothing without a code that uses them.
const USED_LETTERS: u32 = letters(b"DEHIJKLPQR");

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
            return self.ngc_mark();
        }
        if block.is_defective
            && let Some(defect) = page.defects(index).next()
        {
            return Err(self.alarm(fault_of(defect.kind), page.span(block, defect.at, defect.len)));
        }
        if let Some(word) = page.o_word(block) {
            return self.ngc_o_word(page, block, *word);
        }
        let codes = self.ngc_read(page, block)?;
        self.ngc_check(&codes)?;
        self.ngc_check_cutter(&codes)?;
        let before = self.ngc_before(&codes);
        self.ngc_execute(page, block, &codes).inspect_err(|alarm| {
            // A probe that meets nothing has moved.
            if let Some(before) = before.filter(|_| alarm.fault != Fault::SkipWithoutSignal) {
                self.ngc_undo(before);
            }
        })
    }

    /// `%`: the end of a program that began with one; in another it means nothing.
    fn ngc_mark(&mut self) -> Fallible<()> {
        let file = self.words.block_span().file;
        let begins = self.programs.text(file).is_some_and(|text| {
            let head = Span { file, offset: 0, len: MARK_WITHIN.min(text.len() as u32), line: 1 };
            let head = text.slice(head).unwrap_or_default();
            head.iter().find(|byte| !byte.is_ascii_whitespace() && **byte < 0x80) == Some(&b'%')
        });
        if !begins {
            return Err(self.ngc_alarm(Fault::IllegalCharacter));
        }
        self.emit(Op::End(2));
        self.ended = true;
        Ok(())
    }

    /// Reads the words of a block, and sets its parameters.
    fn ngc_read(&mut self, page: &Page, block: &Block) -> Fallible<Codes> {
        let mut codes = Codes { g: [None; Group::COUNT + 1], m: [None; MGroup::COUNT] };
        let mut m_codes = 0;
        self.ngc.settings.clear();
        self.ngc.polar = PolarWords::default();
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
                b'@' => self.ngc.polar.distance = Some(value),
                b'^' => self.ngc.polar.angle = Some(value),
                // There is one spindle; -1 are all.
                b'$' if value.round() == 0.0 || value.round() == -1.0 => {}
                b'$' => return Err(self.alarm(Fault::WordOutOfRange, span())),
                _ => self.ngc_plain_word(word, value, span())?,
            }
        }
        for at in 0..self.ngc.settings.len() {
            let Some((number, value)) = self.ngc.settings.get(at).copied() else { break };
            self.ngc_set(number, value).map_err(|fault| self.ngc_alarm(fault))?;
        }
        self.ngc_polar(&codes)?;
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

    /// Whether a code of the block that moves nothing takes its axis words.
    fn ngc_takes_axes(&self, codes: &Codes) -> bool {
        let length = codes.g(Group::Length).map(|row| row.meaning);
        let sets_length =
            length == Some(Meaning::LengthOf) || length == Some(Meaning::LengthMore) && !self.words.has(b'H');
        sets_length || codes.g(Group::NonModal).is_some_and(|row| takes_axes(row.meaning))
    }

    /// What the block moves by: its own motion code, or with axis words the one in force.
    pub(super) fn ngc_motion_code(&self, codes: &Codes) -> Option<&'static GCode> {
        let takes_axes = self.ngc_takes_axes(codes);
        codes.g(Group::Motion).or_else(|| {
            let moves = self.words.has_any(AXIS_LETTERS) && !takes_axes;
            moves.then(|| self.modal.code(Group::Motion)).flatten()
        })
    }

    /// Refuses codes and words that do not go together (NGC 3.4, 3.5; LinuxCNC, modal groups).
    fn ngc_check(&mut self, codes: &Codes) -> Fallible<()> {
        let non_modal = codes.g(Group::NonModal);
        let has_axes = self.words.has_any(AXIS_LETTERS);
        let takes = self.ngc_takes_axes(codes);
        match codes.g(Group::Motion) {
            Some(row) if row.meaning == Meaning::CycleOff && has_axes && !takes => {
                return Err(self.ngc_alarm(Fault::AxesWithoutCode));
            }
            Some(row) if row.meaning == Meaning::CycleOff => {}
            Some(_) if non_modal.is_some_and(|row| takes_axes(row.meaning)) => {
                return Err(self.ngc_alarm(Fault::CodesContradict));
            }
            Some(_) => {}
            None if takes || !has_axes => {}
            None if self.modal.meaning(Group::Motion) == Meaning::CycleOff => {
                return Err(self.ngc_alarm(Fault::AxesWithoutCode));
            }
            None => {}
        }
        let motion = self.ngc_motion_code(codes);
        match non_modal.map(|row| row.meaning) {
            Some(Meaning::SetPosition | Meaning::LocalZero) if !has_axes => {
                return Err(self.ngc_alarm(Fault::AxesMissing));
            }
            Some(Meaning::Dwell) if !self.words.get(b'P').is_some_and(|p| p >= 0.0) => {
                return Err(self.ngc_missing(b'P'));
            }
            Some(Meaning::MachinePosition) => {
                let moves = motion.or(self.modal.code(Group::Motion)).map(|row| row.meaning);
                if !matches!(moves, Some(Meaning::Rapid | Meaning::Linear)) {
                    return Err(self.ngc_alarm(Fault::CodesContradict));
                }
                let incremental = match codes.g(Group::Distance) {
                    Some(row) => row.meaning == Meaning::Incremental,
                    None => self.modal.is_incremental(),
                };
                if incremental {
                    return Err(self.ngc_alarm(Fault::CodesContradict));
                }
            }
            _ => {}
        }
        self.ngc_check_words(codes, motion)
    }

    /// An alarm of a word that a code of the block needs.
    pub(super) fn ngc_missing(&self, letter: u8) -> Box<Alarm> {
        let mut alarm = self.ngc_alarm(Fault::WordMissing);
        alarm.arguments.push(("word", char::from(letter).to_string().into()));
        alarm
    }

    /// Refuses words that no code of the block uses.
    fn ngc_check_words(&self, codes: &Codes, motion: Option<&GCode>) -> Fallible<()> {
        // Their words have other meanings.
        if motion.is_some_and(|row| row.meaning == Meaning::LatheCycle) {
            return Err(self.ngc_alarm(Fault::NotSupported));
        }
        if !self.words.has_any(USED_LETTERS) {
            return Ok(());
        }
        let motion = motion.map_or(u16::MAX, |row| row.tenths);
        let code = |group| codes.g(group).map_or(u16::MAX, |row| row.tenths);
        let m = |group| codes.m(group).map_or(u16::MAX, |row| row.code);
        let (once, io) = (code(Group::NonModal), m(MGroup::Io));
        let is_cycle = matches!(motion, 730 | 740 | 760 | 810..=890);
        let calls = m(MGroup::Stop) == 98;
        for letter in b'D'..=b'R' {
            if !self.words.has(letter) {
                continue;
            }
            let is_used = match letter {
                b'D' => {
                    matches!(code(Group::Cutter), 410 | 411 | 420 | 421) || code(Group::SurfaceSpeed) == 960
                }
                b'E' => motion == 760 || matches!(io, 66..=68),
                b'H' => motion == 760 || matches!(code(Group::Length), 430 | 432),
                b'I' => matches!(motion, 20 | 30 | 50 | 51 | 331 | 760 | 870) || once == 100,
                b'J' => matches!(motion, 20 | 30 | 50 | 51 | 331 | 760 | 870) || once == 100,
                b'K' => matches!(motion, 20 | 30 | 330 | 331 | 760 | 870),
                b'L' => {
                    is_cycle && motion != 740
                        || once == 100
                        || matches!(motion, 52 | 53)
                        || matches!(code(Group::Cutter), 410 | 411 | 420 | 421)
                        || io == 66
                        || calls
                }
                b'P' => {
                    matches!(once, 40 | 100)
                        || code(Group::PathControl) == 640
                        || matches!(motion, 20 | 30 | 50 | 52 | 740 | 760 | 820 | 840 | 860 | 880 | 890)
                        || matches!(m(MGroup::Override), 50..=53)
                        || matches!(io, 62..=66)
                        || m(MGroup::Spindle) == 19
                        || calls
                }
                b'Q' => {
                    matches!(motion, 50 | 730 | 760 | 830)
                        || once == 100
                        || code(Group::PathControl) == 640
                        || matches!(io, 66..=68)
                        || m(MGroup::Spindle) == 19
                        || m(MGroup::Tool) == 61
                }
                b'R' => matches!(motion, 20 | 30) || is_cycle || once == 100 || m(MGroup::Spindle) == 19,
                _ => true,
            };
            if !is_used {
                return Err(self.alarm_at(Fault::WordUnused, letter));
            }
        }
        Ok(())
    }

    /// Does a block that was read and found right (LinuxCNC, order of execution).
    fn ngc_execute(&mut self, page: &Page, block: &Block, codes: &Codes) -> Fallible<()> {
        // The call is all that its block does.
        if codes.m(MGroup::Stop).is_some_and(|row| row.function == MFunction::Call) {
            return self.ngc_program_call();
        }
        if let Some(io) = codes.m(MGroup::Io)
            && io.code == 66
            && !self.ngc_input()?
        {
            return Ok(());
        }
        self.ngc_comment(page, block)?;
        self.ngc_feed_and_speed(codes)?;
        self.ngc_tool_words(codes)?;
        self.ngc_machine_words(codes)?;
        let non_modal = codes.g(Group::NonModal).map(|row| row.meaning);
        if non_modal == Some(Meaning::Dwell)
            && let Some(seconds) = self.words.get(b'P').filter(|p| *p > 0.0)
        {
            self.emit(Op::Dwell(Dwell::Seconds(seconds)));
        }
        if let Some(row) = codes.g(Group::Plane) {
            self.ngc_plane(row)?;
        }
        for group in [Group::Units, Group::Diameter] {
            if let Some(row) = codes.g(group) {
                self.modal.set(row);
            }
        }
        if let Some(row) = codes.g(Group::Cutter) {
            self.ngc_cutter(row)?;
        }
        if let Some(row) = codes.g(Group::Length) {
            self.ngc_length(row)?;
        }
        if let Some(row) = codes.g(Group::WorkOffset) {
            self.ngc_system(row)?;
        }
        // In compensation neither of these changes.
        if self.ngc_in_compensation()
            && (codes.g(Group::PathControl).is_some() || codes.g(Group::Return).is_some())
        {
            return Err(self.ngc_alarm(Fault::NotInCutter));
        }
        if let Some(row) = codes.g(Group::PathControl) {
            self.modal.set(row);
            self.ngc.tolerance = self.ngc_length_word(b'P').filter(|p| *p > 0.0);
        }
        for group in [Group::Distance, Group::CentreDistance, Group::Return] {
            if let Some(row) = codes.g(group) {
                self.modal.set(row);
            }
        }
        self.ngc.in_machine = non_modal == Some(Meaning::MachinePosition);
        if let Some(row) = codes.g(Group::NonModal) {
            self.ngc_non_modal(row)?;
        }
        if let Some(row) = self.ngc_motion_code(codes) {
            self.ngc_move(row, codes.g(Group::Motion).is_some())?;
        }
        match codes.m(MGroup::Stop) {
            // It waits for the last hole of a cycle.
            Some(row) if self.ngc.cycles.defer(row) => Ok(()),
            Some(row) => self.ngc_stop(row),
            None => Ok(()),
        }
    }

    pub(super) fn ngc_stop(&mut self, row: &MCode) -> Fallible<()> {
        // What compensation holds back is done before, as it stands.
        self.output.flush().map_err(|(fault, _)| self.ngc_alarm(fault))?;
        match row.function {
            MFunction::ProgramEnd => self.end_program(row.code)?,
            // In a main program M99 ends it (no loop at a desk).
            MFunction::Return => {
                if !self.ngc_program_return() {
                    self.end_program(row.code)?;
                }
            }
            MFunction::OptionalStop if !self.options.optional_stop => {}
            _ => {
                self.emit(Op::Stop(row.code.into()));
                // Nothing behind it is read before the start.
                return self.emit_barrier_before();
            }
        }
        Ok(())
    }
}

/// Whether a code that is not modal takes the block's axis words.
fn takes_axes(meaning: Meaning) -> bool {
    matches!(
        meaning,
        Meaning::DataSetting
            | Meaning::ReferenceReturn
            | Meaning::FurtherReferenceReturn
            | Meaning::LocalZero
            | Meaning::SetPosition
    )
}
