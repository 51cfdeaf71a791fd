//! Which program runs: that of AUTO from the memory, what the operator typed in MDI, what comes from outside in DNC.

use super::callable::Prepared;
use super::{Control, alarm, library};
use crate::signals::Mode;
use ferrocut_interpreter::Interpreter;
use ferrocut_machine::{Alarm, Fault};
use ferrocut_program::{FileId, ProgramId, Span, Text};

/// Where a program comes from.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Source {
    Memory,
    /// Its text may end without an end of program.
    Mdi,
    /// That too, and M99 is its end.
    Dnc,
}

/// What is loaded for the next cycle start.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Loaded {
    /// Nothing.
    Nothing,
    /// The program of this name.
    Auto(String),
    /// The text of the MDI page, or one block.
    Mdi,
    /// A program from outside.
    Dnc,
    /// Touches of a probe.
    Measuring,
}

impl Loaded {
    /// The mode that runs it.
    pub fn mode(&self) -> Option<Mode> {
        match self {
            Loaded::Nothing => None,
            Loaded::Auto(_) => Some(Mode::Auto),
            Loaded::Mdi => Some(Mode::Mdi),
            Loaded::Dnc => Some(Mode::Dnc),
            Loaded::Measuring => Some(Mode::Auto),
        }
    }
}

impl Control {
    /// Loads what the mode runs and starts it. Says why not.
    pub(super) fn start_program(&mut self) -> Result<(), Box<Alarm>> {
        match self.mode {
            Mode::Auto => {
                if self.start_auto()? {
                    return Ok(());
                }
            }
            Mode::Mdi => self.start_mdi()?,
            Mode::Dnc => {
                self.start_dnc()?;
                self.begin_part();
            }
            _ => return Err(Box::new(alarm(Fault::ControlMode))),
        }
        self.arm_stop();
        self.cnc.cycle_start();
        Ok(())
    }

    /// Whether it starts later, since its text is still read.
    fn start_auto(&mut self) -> Result<bool, Box<Alarm>> {
        if self.taking_up.is_ready() {
            return self.start_restart().map(|()| false);
        }
        if self.measuring.is_ready() {
            return self.start_measuring().map(|()| false);
        }
        let name = self.selected.clone().ok_or_else(|| alarm(Fault::NothingToRun))?;
        // None runs as it was before a change that somebody has asked for.
        if self.awaits_texts() {
            return Err(Box::new(alarm(Fault::ControlBusy)));
        }
        if self.read_ahead(&name) {
            self.start_when_read();
            return Ok(true);
        }
        let line = (self.cursor > 1).then_some(self.cursor);
        self.load_auto(&name)?;
        self.begin_at(line)?;
        self.forget_interrupted();
        self.begin_part();
        self.taking_up.from_line = line.unwrap_or(1);
        Ok(false)
    }

    /// Gives the interpreter a program of the memory, unless it has it.
    pub(super) fn load_auto(&mut self, name: &str) -> Result<(), Box<Alarm>> {
        if !self.has_loaded(name) {
            let prepared = self.program_to_load(name)?;
            self.load_prepared(*prepared, Source::Memory)?;
            self.loaded = Loaded::Auto(name.to_owned());
            self.texts_changed = false;
        }
        Ok(())
    }

    /// Whether the interpreter has a program, and all that it may have called, as they stand in the memory.
    pub(super) fn has_loaded(&self, name: &str) -> bool {
        !self.texts_changed && self.loaded == Loaded::Auto(name.to_owned())
    }

    pub(super) fn begin_at(&mut self, line: Option<u32>) -> Result<(), Box<Alarm>> {
        let is_there = self.cnc.rewind(line);
        let is_there =
            is_there.map_err(|error| alarm(Fault::FileUnreadable).with("reason", error.to_string()))?;
        let line = f64::from(line.unwrap_or(1));
        if is_there { Ok(()) } else { Err(Box::new(alarm(Fault::NoSuchLine).with("line", line))) }
    }

    /// 8.2 note 2: what stands on the page of the current block runs before the text of the MDI page.
    fn start_mdi(&mut self) -> Result<(), Box<Alarm>> {
        let is_block = !self.mdi_block.trim().is_empty();
        let text = if is_block { self.take_mdi_block() } else { self.mdi.clone() };
        // `%` ends it as M02 does (28#4).
        let text = match mark_of(&text).filter(|_| !is_block) {
            Some(at) => text[..at].to_owned(),
            None => text,
        };
        if text.trim().is_empty() {
            return Err(Box::new(alarm(Fault::NothingToRun)));
        }
        let text =
            Text::from_bytes(text.into_bytes()).map_err(|_| alarm(Fault::FileNotText).with("file", "MDI"))?;
        self.load_text("MDI", text, Source::Mdi)?;
        self.loaded = Loaded::Mdi;
        // 10#6: from the line of the cursor.
        let line = (!is_block && self.bit(10, 6) && self.mdi_cursor > 1).then_some(self.mdi_cursor);
        self.begin_at(line)
    }

    /// Gives the interpreter a text as its main program; all programs of the memory can be called from it.
    pub(super) fn load_text(&mut self, name: &str, text: Text, source: Source) -> Result<(), Box<Alarm>> {
        self.load_prepared(self.callable.prepare(name, text), source)
    }

    fn load_prepared(&mut self, prepared: Prepared, source: Source) -> Result<(), Box<Alarm>> {
        let Prepared { programs, changes_tools } = prepared;
        let old = self.cnc.load_programs(programs).map_err(|_| alarm(Fault::ControlBusy))?;
        self.reading.free(old);
        let interpreter = self.cnc.interpreter_mut();
        interpreter.set_open_end(source != Source::Memory);
        interpreter.set_return_ends(source == Source::Dnc);
        interpreter.set_tool_change_program(changes_tools);
        Ok(())
    }

    /// Chooses the program of AUTO. Says why not.
    pub(super) fn select(&mut self, name: &str) -> Result<String, Box<Alarm>> {
        if self.cnc.is_under_way() {
            return Err(Box::new(alarm(Fault::ControlBusy)));
        }
        if !matches!(self.mode, Mode::Auto | Mode::Edit) {
            return Err(Box::new(alarm(Fault::ControlMode).with("mode", super::name_of(self.mode))));
        }
        let missing = || alarm(Fault::NoSuchName).with("name", name);
        let name = self.name_asked(name).ok_or_else(missing)?;
        self.forget_prepared();
        self.selected = Some(name.clone());
        self.cursor = 1;
        self.loaded = Loaded::Nothing;
        self.reading.cancel_start();
        self.read_ahead(&name);
        Ok(name)
    }

    /// Whether a program is under way and this is its text, or that of a subprogram it has called.
    pub(super) fn is_in_use(&self, name: &str) -> bool {
        let programs = self.cnc.interpreter().programs();
        let files = (0..u16::MAX).map(|n| programs.file_name(FileId(n)));
        self.cnc.is_under_way() && files.take_while(|file| !file.is_empty()).any(|file| file == name)
    }

    /// 3.4.1, stop number: the run that begins, or is under way, stops behind the line that has the sequence number, in
    /// the program itself or where it calls the one that was named.
    pub(super) fn arm_stop(&mut self) {
        let place = self.stop_place();
        self.cnc.stop_behind(place);
    }

    fn stop_place(&mut self) -> Option<(FileId, u32)> {
        let (program, sequence) = self.stop_at.clone()?;
        let id = program.map(|program| library::id_of(&program));
        match (&self.loaded, id) {
            (Loaded::Auto(name), id) if id.as_ref().is_none_or(|id| *id == library::id_of(name)) => {
                let text = self.callable.library().text(name)?;
                line_of(&text, sequence).map(|line| (FileId(0), line))
            }
            (Loaded::Auto(_) | Loaded::Mdi | Loaded::Dnc, Some(id)) => {
                let (file, line) = self.cnc.interpreter_mut().place_of(&id)?;
                let text = self.cnc.interpreter().programs().text(file)?;
                let len = u32::try_from(text.len()).ok()?;
                let text = text.slice(Span { file, offset: 0, len, line: 1 }).ok()?;
                line_in(&text, line, sequence).map(|line| (file, line))
            }
            _ => None,
        }
    }

    /// Why a program that was named stops behind no such sequence number: it is not there, or has none.
    pub(super) fn may_stop_at(&self, program: &str, sequence: u32) -> Result<(), Box<Alarm>> {
        let id = library::id_of(program);
        let place = match self.callable.library().typed(program) {
            Some((_, text)) => line_of(&text, sequence),
            // One within the program that is chosen.
            None => {
                let text = self.selected.as_ref().and_then(|name| self.callable.library().text(name));
                let begins = text.as_ref().and_then(|text| begin_of(text, &id));
                let (text, begins) =
                    text.zip(begins).ok_or_else(|| alarm(Fault::NoSuchName).with("name", program))?;
                line_in(&text, begins, sequence)
            }
        };
        match place {
            Some(_) => Ok(()),
            None => Err(Box::new(alarm(Fault::NoSuchName).with("name", format!("{program} N{sequence}")))),
        }
    }

    /// The program has ended: where the next start begins, and what is left of MDI.
    pub(super) fn program_ended(&mut self, code: Option<u32>) {
        // 33#2 and 33#4: M02 and M30 lead back to the start.
        let rewinds = match code {
            Some(2) => self.bit(33, 2),
            Some(30) => self.bit(33, 4),
            _ => true,
        };
        match self.loaded {
            Loaded::Auto(_) if rewinds => self.cursor = 1,
            // Else it stays on the block of the end, and not on the last one that took time.
            Loaded::Auto(_) if self.tick.span.file == FileId(0) => self.cursor = self.tick.span.line.max(1),
            // 28#4.
            Loaded::Mdi if self.bit(28, 4) => {
                let is_end = code.map_or(mark_of(&self.mdi).is_some(), |code| matches!(code, 2 | 30));
                if is_end {
                    self.clear_mdi();
                }
            }
            _ => {}
        }
    }

    /// The interpreter, to look at.
    pub fn interpreter(&self) -> &Interpreter {
        self.cnc.interpreter()
    }
}

/// Where the line begins that ends a text of MDI by `%`. One before everything else is its head.
fn mark_of(text: &str) -> Option<usize> {
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        if line.trim() == "%" && !text[..at].trim().is_empty() {
            return Some(at);
        }
        at += line.len();
    }
    None
}

/// The line on which a block begins with a sequence number, counted from 1.
fn line_of(text: &[u8], sequence: u32) -> Option<u32> {
    let at = text.split(|b| *b == b'\n').position(|line| number_behind(line, b'N') == Some(sequence))?;
    u32::try_from(at).ok()?.checked_add(1)
}

/// The same within the program that begins on the line `first`.
fn line_in(text: &[u8], first: u32, sequence: u32) -> Option<u32> {
    let lines = (1u32..).zip(text.split(|b| *b == b'\n')).skip_while(|(line, _)| *line < first);
    let within = lines.take_while(|(line, text)| *line == first || number_behind(text, b'O').is_none());
    within.filter(|(_, text)| number_behind(text, b'N') == Some(sequence)).map(|(line, _)| line).next()
}

/// The line on which a program begins within a text.
fn begin_of(text: &[u8], id: &ProgramId) -> Option<u32> {
    let ProgramId::Number(number) = id else { return None };
    let mut lines = (1u32..).zip(text.split(|b| *b == b'\n'));
    lines.find(|(_, line)| number_behind(line, b'O') == Some(*number)).map(|(line, _)| line)
}

/// The number behind the letter with which a line begins.
fn number_behind(line: &[u8], letter: u8) -> Option<u32> {
    let line = line.trim_ascii_start();
    let line = line.strip_prefix(b"/").unwrap_or(line).trim_ascii_start();
    let digits = line.split_first().filter(|(first, _)| first.to_ascii_uppercase() == letter)?.1;
    let end = digits.iter().position(|b| !b.is_ascii_digit()).unwrap_or(digits.len());
    std::str::from_utf8(digits.get(..end)?).ok()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::{begin_of, line_in, line_of};
    use ferrocut_program::ProgramId;

    #[test]
    fn a_sequence_number_is_found_at_the_start_of_its_line() {
        let text = b"O1\nN10 G0\n/ n20 G1 N30\nX5 N40\nN010\n";
        assert_eq!([10, 20, 30, 40, 1].map(|n| line_of(text, n)), [Some(2), Some(3), None, None, None]);
    }

    #[test]
    fn a_program_within_a_text_has_its_own_sequence_numbers() {
        let text = b"O1\nN10 G0\nM30\no0002\nN20\nM99\nO3\nN30\n";
        let begins = [1, 2, 3, 4].map(|n| begin_of(text, &ProgramId::Number(n)));
        assert_eq!(begins, [Some(1), Some(4), Some(7), None]);
        assert_eq!([10, 20, 30].map(|n| line_in(text, 4, n)), [None, Some(5), None]);
    }
}
