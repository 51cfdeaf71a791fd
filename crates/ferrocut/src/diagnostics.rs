//! Alarms as people and programs read them.

use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};
use ferrocut_desk::finding::with_word;
use ferrocut_machine::{Alarm, Catalogue, Severity};
use ferrocut_program::ProgramMemory;
use serde::Serialize;
use std::io::{self, IsTerminal, Write};

/// Characters of a line that are shown around the words at fault.
const LINE_SHOWN: usize = 160;

/// Bytes of a line that are read to count columns: more than any control takes in a line.
const LINE_READ: usize = 1 << 16;

/// Shows alarms in one language, for people or for programs.
#[derive(Clone, Copy)]
pub struct Diagnostics {
    catalogue: Catalogue,
    json: bool,
}

/// One finding as JSON.
#[derive(Serialize)]
struct Finding<'a> {
    file: &'a str,
    line: u32,
    column: usize,
    length: usize,
    alarm: String,
    severity: &'static str,
    message: String,
    help: Option<String>,
    /// How often the program came to it, where that was counted.
    #[serde(skip_serializing_if = "Option::is_none")]
    times: Option<u64>,
}

/// The line that an alarm points at.
struct Place {
    text: String,
    /// Bytes of `text` at fault.
    start: usize,
    end: usize,
    /// Characters before the words at fault, counted from 1, in the whole line.
    column: usize,
}

impl Diagnostics {
    /// Diagnostics in the catalogue's language.
    pub fn new(catalogue: Catalogue, json: bool) -> Diagnostics {
        Diagnostics { catalogue, json }
    }

    /// The texts.
    pub fn catalogue(&self) -> Catalogue {
        self.catalogue
    }

    /// Whether messages are for programs.
    pub fn is_json(&self) -> bool {
        self.json
    }

    /// Text of an alarm in one line.
    pub fn message(&self, alarm: &Alarm, programs: Option<&ProgramMemory>) -> String {
        self.catalogue.message(&with_word(alarm, programs))
    }

    /// Writes a finding: with the line and the words underlined for people, as one object for
    /// programs. `times` is how often the program came to it, where that was counted.
    pub fn write(
        &self,
        out: &mut dyn Write,
        alarm: &Alarm,
        file: &str,
        programs: Option<&ProgramMemory>,
        colour: bool,
        times: Option<u64>,
    ) -> io::Result<()> {
        let alarm = with_word(alarm, programs);
        let file = programs.filter(|_| alarm.span.line > 0).map_or(file, |p| p.file_name(alarm.span.file));
        let place = programs.filter(|_| alarm.span.line > 0).and_then(|p| place(&alarm, p));
        let message = self.catalogue.message(&alarm);
        let help = self.catalogue.help(&alarm);
        if self.json {
            let (column, length) = place
                .as_ref()
                .map_or((0, 0), |p| (p.column, p.text.get(p.start..p.end).map_or(0, |t| t.chars().count())));
            let finding = Finding {
                file,
                line: alarm.span.line,
                column,
                length,
                alarm: alarm.id.to_string(),
                severity: alarm.severity.name(),
                message,
                help,
                times,
            };
            serde_json::to_writer(&mut *out, &finding)?;
            return out.write_all(b"\n");
        }
        let level = match alarm.severity {
            Severity::Error => Level::ERROR,
            Severity::Warning => Level::WARNING,
        };
        let id = alarm.id.to_string();
        let title = level.primary_title(message.as_str()).id(id.as_str());
        let mut group = match &place {
            Some(place) => {
                let snippet = Snippet::source(place.text.as_str())
                    .line_start(alarm.span.line as usize)
                    .path(file)
                    .annotation(AnnotationKind::Primary.span(place.start..place.end));
                title.element(snippet)
            }
            None => Group::with_title(title),
        };
        if let Some(help) = &help {
            group = group.element(Level::HELP.message(help.as_str()));
        }
        let times = times.filter(|times| *times > 1);
        let times =
            times.map(|times| self.catalogue.label("label-times", &[("count", (times as f64).into())]));
        if let Some(times) = &times {
            group = group.element(Level::NOTE.message(times.as_str()));
        }
        let renderer = if colour { Renderer::styled() } else { Renderer::plain() };
        writeln!(out, "{}\n", renderer.render(&[group]))
    }

    /// Writes a finding to standard error.
    pub fn report(&self, alarm: &Alarm, file: &str, programs: Option<&ProgramMemory>) {
        let mut out = io::stderr().lock();
        let colour = out.is_terminal() && std::env::var_os("NO_COLOR").is_none();
        // Nobody is left to tell if standard error is closed.
        let _ = self.write(&mut out, alarm, file, programs, colour, None);
    }
}

fn place(alarm: &Alarm, programs: &ProgramMemory) -> Option<Place> {
    let text = programs.text(alarm.span.file)?;
    let encoding = text.encoding();
    let (line, at) = text.line_of(alarm.span, LINE_READ).ok()?;
    let end = (at + (alarm.span.len as usize).max(1)).min(line.len());
    let decoded = |from: usize, to: usize| encoding.decode(line.get(from..to).unwrap_or(&[]));
    let (before, words, after) = (decoded(0, at), decoded(at, end), decoded(end, line.len()));
    let characters = before.chars().count();
    // A long line is shown around the words at fault.
    let before: String = before.chars().skip(characters.saturating_sub(LINE_SHOWN / 2)).collect();
    let words: String = words.chars().take(LINE_SHOWN).collect();
    let left = LINE_SHOWN.saturating_sub(before.chars().count() + words.chars().count());
    let after: String = after.chars().take(left).collect();
    let start = before.len();
    let end = start + words.len();
    Some(Place { text: format!("{before}{words}{after}"), start, end, column: characters + 1 })
}
