//! The programs of the control, and the text of MDI.

use super::super::{Control, alarm, library, name_of};
use super::{Answer, named};
use crate::api::{Event, ProgramInfo, Reply};
use crate::signals::Mode;
use ferrocut_machine::{Alarm, Fault};
use ferrocut_memory::items::limits;
use ferrocut_memory::rights::closing_bit;
use ferrocut_memory::{Author, Change, Level, is_program_name};
use std::sync::PoisonError;

/// Longest text of MDI, bytes (10.1.1.2: 65 characters a block).
const LONGEST_MDI: usize = 1 << 20;

/// What the event `changed` calls the text and the block of MDI.
const MDI: &str = "mdi";

impl Control {
    pub(super) fn programs(&self) -> Answer {
        let programs = match self.callable.library() {
            library::Library::Held(programs) => {
                let programs = programs.lock().unwrap_or_else(PoisonError::into_inner);
                let info = |(name, text): (&String, &Vec<u8>)| ProgramInfo {
                    name: name.clone(),
                    bytes: text.len() as u64,
                    comment: comment_of(text),
                    changed: 0,
                    locked: None,
                };
                programs.iter().map(info).collect()
            }
            library::Library::Kept(store) => {
                let found = store.reader().programs().map_err(|error| error.alarm())?;
                let info = |entry: ferrocut_memory::ProgramEntry| ProgramInfo {
                    name: entry.name,
                    bytes: entry.bytes,
                    comment: entry.comment,
                    changed: entry.changed,
                    locked: entry.locked.map(Level::number),
                };
                found.into_iter().map(info).collect()
            }
        };
        let most = match self.callable.library() {
            library::Library::Held(_) => None,
            library::Library::Kept(_) => u32::try_from(limits::PROGRAMS).ok(),
        };
        Ok(Reply::Programs { programs, most, room: self.callable.library().room() })
    }

    /// The name of a program that there is.
    pub(super) fn known(&self, program: &str) -> Result<String, Box<Alarm>> {
        let found = self.name_asked(program);
        found.ok_or_else(|| Box::new(named(Fault::NoSuchName, program)))
    }

    pub(super) fn read(&self, program: &str) -> Answer {
        let asked = self.name_asked(program).and_then(|name| self.text_asked(&name).map(|text| (name, text)));
        let found = asked.or_else(|| self.callable.named(&library::id_of(program)));
        let (program, text) = found.ok_or_else(|| named(Fault::NoSuchName, program))?;
        let text = match ferrocut_program::Text::from_bytes(text.clone()) {
            Ok(decoded) => decoded.encoding().decode(&text).into_owned(),
            Err(_) => String::from_utf8_lossy(&text).into_owned(),
        };
        Ok(Reply::Program { program, text })
    }

    /// Stores a program, in place of the one that has its number, however that is written: O1 is O0001. The one under way stays as
    /// it is (7.11 note 3); any other may be written meanwhile.
    pub(super) fn store(&mut self, program: String, text: String, author: &Author) -> Answer {
        self.may_edit_programs(author)?;
        let name = library::name_to_store(&program);
        if !is_program_name(&name) {
            return Err(Box::new(named(Fault::ValueImpossible, name)));
        }
        let name = self.known(&program).unwrap_or(name);
        if self.is_in_use(&name) {
            return Err(Box::new(named(Fault::ProgramInUse, name)));
        }
        let text = text.into_bytes();
        let comment = comment_of(&text);
        if let library::Library::Held(programs) = self.callable.library() {
            programs.lock().unwrap_or_else(PoisonError::into_inner).insert(name.clone(), text.clone());
        }
        self.change_data(author, Change::Program { name, text, comment })
    }

    pub(super) fn delete(&mut self, program: &str, author: &Author) -> Answer {
        self.may_edit_programs(author)?;
        let name = self.known(program)?;
        if self.is_in_use(&name) {
            return Err(Box::new(named(Fault::ProgramInUse, name)));
        }
        if let library::Library::Held(programs) = self.callable.library() {
            programs.lock().unwrap_or_else(PoisonError::into_inner).remove(&name);
        }
        self.change_data(author, Change::DeleteProgram { name })
    }

    /// All programs (10.1.3) but those that are locked for the author. None where one of them is under way.
    pub(super) fn delete_all(&mut self, author: &Author) -> Answer {
        self.may_edit_programs(author)?;
        let Reply::Programs { programs, .. } = self.programs()? else { return Ok(Reply::Done) };
        let level = author.level().map_or(0, Level::number);
        // 27#0, 27#4: closed to every person.
        let is_person = matches!(author, Author::Person { .. }) && self.machine.dialect == "gsk990mc";
        let is_closed = |program: &ProgramInfo| {
            is_person && closing_bit(&program.name).is_some_and(|(number, bit)| self.bit(number, bit))
        };
        let is_free = |program: &ProgramInfo| {
            program.locked.is_none_or(|needed| level <= needed) && !is_closed(program)
        };
        let names: Vec<String> = programs.into_iter().filter(is_free).map(|program| program.name).collect();
        if names.is_empty() {
            return Ok(Reply::Done);
        }
        if let Some(name) = names.iter().find(|name| self.is_in_use(name)) {
            return Err(Box::new(named(Fault::ProgramInUse, name.as_str())));
        }
        if let library::Library::Held(programs) = self.callable.library() {
            programs.lock().unwrap_or_else(PoisonError::into_inner).retain(|name, _| !names.contains(name));
        }
        self.change_data_together(
            author,
            names.into_iter().map(|name| Change::DeleteProgram { name }).collect(),
        )
    }

    /// A program gets another name, and the O number at its start with it.
    pub(super) fn rename(&mut self, program: &str, to: &str, author: &Author) -> Answer {
        self.may_edit_programs(author)?;
        let name = self.known(program)?;
        let to = library::name_to_store(to);
        let taken = self.known(&to).is_ok_and(|other| other != name || other == to);
        if !is_program_name(&to) || taken {
            return Err(Box::new(named(Fault::ValueImpossible, to)));
        }
        if self.is_in_use(&name) {
            return Err(Box::new(named(Fault::ProgramInUse, name)));
        }
        let text = self.text_asked(&name).ok_or_else(|| named(Fault::NoSuchName, name.as_str()))?;
        let text = library::renumbered(&text, &name, &to).unwrap_or(text);
        if let library::Library::Held(programs) = self.callable.library() {
            let mut programs = programs.lock().unwrap_or_else(PoisonError::into_inner);
            programs.remove(&name);
            programs.insert(to.clone(), text.clone());
        }
        self.change_data(author, Change::RenameProgram { name, to, text })
    }

    /// 7.4: the cursor is moved in EDIT, and then stays.
    pub(super) fn put_cursor(&mut self, line: u32) -> Answer {
        if line == 0 {
            return Err(Box::new(named(Fault::ValueImpossible, "0").with("min", 1.0)));
        }
        if self.cnc.is_under_way() {
            return Err(Box::new(alarm(Fault::ControlBusy)));
        }
        let (lines, cursor) = match self.mode {
            Mode::Mdi => (lines_of(self.mdi.as_bytes()), &mut self.mdi_cursor),
            Mode::Edit | Mode::Auto => {
                let text = self.selected.as_ref().and_then(|name| self.callable.library().text(name));
                (text.map_or(0, |text| lines_of(&text)), &mut self.cursor)
            }
            mode => return Err(Box::new(alarm(Fault::ControlMode).with("mode", name_of(mode)))),
        };
        if line as usize > lines {
            return Err(Box::new(alarm(Fault::NoSuchLine).with("line", f64::from(line))));
        }
        *cursor = line;
        Ok(Reply::Done)
    }

    pub(super) fn type_mdi(&mut self, text: String, is_block: bool) -> Answer {
        if self.mode != Mode::Mdi {
            return Err(Box::new(alarm(Fault::ControlMode).with("mode", name_of(self.mode))));
        }
        if text.len() > LONGEST_MDI || is_block && text.trim_end().contains(['\n', '\r']) {
            return Err(Box::new(named(Fault::ValueImpossible, "MDI")));
        }
        if is_block {
            self.mdi_block = text;
        } else {
            self.mdi = text;
            self.mdi_cursor = 1;
        }
        self.tell_mdi();
        Ok(Reply::Done)
    }

    /// The text of MDI is cleared.
    pub(in crate::control) fn clear_mdi(&mut self) {
        if !self.mdi.is_empty() {
            self.mdi.clear();
            self.tell_mdi();
        }
    }

    /// The block before it is taken, to be run or to be forgotten.
    pub(in crate::control) fn take_mdi_block(&mut self) -> String {
        let block = std::mem::take(&mut self.mdi_block);
        if !block.is_empty() {
            self.tell_mdi();
        }
        block
    }

    pub(super) fn tell_mdi(&mut self) {
        self.event(Event::Changed { item: MDI.to_owned() });
    }
}

/// How many lines a text has; one behind a last line feed is the next.
fn lines_of(text: &[u8]) -> usize {
    text.iter().filter(|byte| **byte == b'\n').count() + 1
}

/// The first remark of a program's first lines.
fn comment_of(text: &[u8]) -> String {
    let head = text.get(..text.len().min(4096)).unwrap_or(text);
    let head = String::from_utf8_lossy(head);
    let remark =
        head.split_once('(').and_then(|(_, rest)| rest.split_once(')')).map(|(remark, _)| remark.trim());
    remark.unwrap_or_default().chars().take(80).collect()
}
