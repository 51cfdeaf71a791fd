//! The words of a program, explained where they stand.

use crate::asked::Asked;
use crate::book::Book;
use crate::page::Page;
use crate::place::{self, Line, Spot};
use ferrocut_geometry::Axis;
use ferrocut_interpreter::modal::Group;
use ferrocut_machine::{Argument, Subject, g_code_name};
use ferrocut_program::{OpenError, ProgramMemory};

impl Book {
    /// The pages of the words at a place of a program that is called `name`; the reason where there is none, and what
    /// is wrong with a program that cannot be read.
    pub fn place(
        &self,
        name: &str,
        programs: &mut ProgramMemory,
        number: u32,
        column: Option<usize>,
    ) -> Result<Result<Vec<Page>, String>, OpenError> {
        let label = |key: &str, more: &[(&str, Argument)]| {
            let mut arguments = vec![("file", name.into()), ("line", number.to_string().into())];
            arguments.extend_from_slice(more);
            self.catalogue.label(key, &arguments)
        };
        let line = place::line(programs, number, self.dialect, &self.memory.parameters);
        let line = line.map_err(OpenError::Io)?;
        let none = if number == 0 { "label-explain-no-line" } else { "label-explain-no-block" };
        let Some(line) = line else { return Ok(Err(label(none, &[]))) };
        let spots = match column {
            None => self.spots(&line),
            Some(column) => match line.at(column) {
                Some(spot) => vec![spot],
                None => {
                    let words: Vec<String> =
                        line.words.iter().map(|w| format!("{} ({})", w.text.trim(), w.column)).collect();
                    let more = [("column", column.to_string().into()), ("words", words.join(", ").into())];
                    let key = match (line.is_comment(column), words.is_empty()) {
                        (true, _) => "label-explain-comment",
                        (false, true) => "label-explain-no-word",
                        (false, false) => "label-explain-no-word-there",
                    };
                    return Ok(Err(label(key, &more)));
                }
            },
        };
        Ok(Ok(spots.iter().map(|spot| self.spot(name, number, spot, &line)).collect()))
    }

    /// The words of a line, and what is known of the pieces of its macro statement, from left to right.
    fn spots(&self, line: &Line) -> Vec<Spot> {
        let is_macro_word =
            |text: &str| self.reference.is_some_and(|r| r.macro_word(&self.full_name(text)).is_some());
        let is_known = |text: &str| self.variable_of(text).is_some() || is_macro_word(text);
        let pieces = line.pieces().into_iter().filter(|piece| is_known(&piece.text));
        let mut spots: Vec<Spot> =
            line.words.iter().filter_map(|w| line.at(w.column)).chain(pieces).collect();
        spots.sort_by_key(|spot| spot.column);
        spots
    }

    /// The page of a word where it stands.
    fn spot(&self, file: &str, number: u32, spot: &Spot, line: &Line) -> Page {
        let text = spot.text.trim();
        let asked = match (spot.letter, spot.value) {
            (Some(b'G'), Some(value)) => place::tenths(value).filter(|t| self.knows_g(*t)).map(Subject::G),
            (Some(b'M'), Some(value)) => {
                place::tenths(value).map(|t| t / 10).filter(|code| self.knows_m(*code)).map(Subject::M)
            }
            (None, _) => self.variable_of(text).map(Subject::Variable).or_else(|| self.cycle_of(text)),
            _ => None,
        };
        let mut page = match (asked, spot.letter) {
            (Some(subject), _) => self.page(&Asked::Subject(subject)),
            (None, Some(letter)) => Some(self.word(letter, text, line)),
            (None, None) => self.page(&Asked::MacroWord(self.full_name(text))),
        }
        .unwrap_or_else(|| Page::new("word", text, ""));
        page.tell(
            "place",
            format!("{file}:{number}:{}  {text}", spot.column),
            serde_json::json!({ "file": file, "line": number, "column": spot.column, "text": text }),
        );
        page
    }

    /// The variable that `#100`, or `P5` where names have no sign, stands for.
    fn variable_of(&self, text: &str) -> Option<u32> {
        let numbered = text.strip_prefix('#').and_then(|number| number.parse().ok());
        numbered.or_else(|| self.unsigned_variable(text))
    }

    /// The code that a directive names, `G287`.
    fn cycle_of(&self, text: &str) -> Option<Subject> {
        let number: f64 = text.strip_prefix(['G', 'g'])?.parse().ok()?;
        place::tenths(number).filter(|tenths| self.knows_g(*tenths)).map(Subject::G)
    }

    /// A word beside G and M: what its address holds, and which code reads it.
    fn word(&self, letter: u8, text: &str, line: &Line) -> Page {
        let mut page = Page::new("word", text, self.address_meaning(letter));
        self.say_range(&mut page, letter);
        if let Some(reader) = self.reader(letter, line) {
            // The form that the word itself chooses, `L2` of `G10 L2`, has a name and a format of its own.
            let row = match (&reader, self.reference) {
                (Subject::G(tenths), Some(reference)) => {
                    let form = reference.forms(*tenths).find(|row| row.is_form(text));
                    form.or_else(|| reference.g_code(*tenths))
                }
                _ => None,
            };
            let (name, title) = match row {
                Some(row) => self.row_line(row),
                None => self.code_line(&reader).unwrap_or_default(),
            };
            page.say("used_by", format!("{name}  {title}"));
            page.say("form", row.map_or("", |row| &*row.format));
        }
        // A group in which the language has no code is filled all the same.
        let own = line.modal.codes().filter(|c| self.dialect.g_code(c.tenths).is_some());
        let mut codes: Vec<_> = own.map(|c| (c.group_number, c.tenths)).collect();
        codes.sort_unstable();
        codes.dedup();
        let codes: Vec<String> = codes.iter().map(|(_, tenths)| g_code_name(*tenths)).collect();
        page.tell("in_force", codes.join(" "), codes.clone());
        page
    }

    /// The code that reads a word of a line: one that stands there, else one in force.
    fn reader(&self, letter: u8, line: &Line) -> Option<Subject> {
        let reference = self.reference?;
        let is_axis = Axis::from_letter(letter).is_some();
        let reads = |tenths: &u16| {
            let row = reference.g_code(*tenths);
            let group = self.dialect.g_code(*tenths).map(|c| c.group);
            row.is_some_and(|r| place::has_address(&r.format, letter))
                && (!is_axis || group.is_none_or(place::takes_axes))
        };
        let calls = |code: &u16| {
            reference
                .m_code(*code)
                .is_some_and(|row| row.meaning.contains(&format!(" {}_", char::from(letter))))
        };
        if let Some(code) = line.m_codes.iter().copied().find(calls) {
            return Some(Subject::M(code));
        }
        let is_modal = |t: &u16| self.dialect.g_code(*t).is_some_and(|c| c.group_number > 0);
        let here = line.g_codes.iter().copied();
        let first = here.clone().filter(|t| !is_modal(t)).find(reads).or_else(|| here.clone().find(reads));
        let cycle = || {
            let mut codes = line.modal.codes().filter(|c| c.tenths != self.dialect.cycle_off.tenths);
            codes.find(|c| c.group == Group::Cycle).map(|c| c.tenths)
        };
        let motion = || {
            let mut codes = line.modal.codes();
            codes.find(|c| c.group == Group::Motion).map(|c| c.tenths)
        };
        first.or_else(|| cycle().filter(reads)).or_else(|| motion().filter(reads)).map(Subject::G)
    }

    /// What a piece of a macro is called in the table of its words: a function that may be written with its first letters
    /// (`SI`) by its whole name, a parameter by a name that a program gives it by `<name>`.
    pub(crate) fn full_name(&self, text: &str) -> String {
        let text = text.trim_start_matches('#');
        let is_listed = || self.reference.is_some_and(|r| r.macro_word(text).is_some());
        if text.starts_with('<') && !is_listed() {
            return if text.starts_with("<_") { "<_name>" } else { "<name>" }.to_owned();
        }
        let functions = self.dialect.syntax.functions;
        let meant = functions.iter().find(|(name, _)| name.eq_ignore_ascii_case(text)).map(|(_, f)| f);
        let first = meant.and_then(|meant| functions.iter().find(|(_, f)| f == meant));
        first.map_or(text, |(name, _)| name).to_ascii_uppercase()
    }
}
