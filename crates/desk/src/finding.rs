//! What a check finds, with the words at fault as editors and people count them.

use ferrocut_interpreter::Interpreter;
use ferrocut_machine::{Alarm, Argument, Catalogue, Fault};
use ferrocut_program::{ProgramMemory, Span};
use serde::Serialize;

/// Bytes of a line that are read to count columns: more than any control takes in a line.
const LINE_READ: usize = 1 << 16;

/// Longest piece of program quoted within a sentence, characters.
const WORD_QUOTED: usize = 40;

/// Something wrong in a program.
#[derive(Clone, PartialEq, Debug, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Finding {
    /// The alarm's number: `gsk990mc:0045`, `FC-0302`.
    pub id: String,
    /// `error` or `warning`.
    #[cfg_attr(feature = "typescript", ts(type = "'error' | 'warning'"))]
    pub severity: &'static str,
    /// The program that it is in, where that is not the one that was checked.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub program: Option<String>,
    /// The line, from 1; 0 where no place is meant.
    pub line: u32,
    /// Where the words at fault begin, in units of UTF-16 from 1.
    pub column: u32,
    /// The line in which they end.
    pub end_line: u32,
    /// Where they end; the last one lies before it.
    pub end_column: u32,
    /// What is wrong.
    pub text: String,
    /// What to do about it.
    pub help: Option<String>,
}

impl Finding {
    /// A finding of an alarm, in the catalogue's language.
    pub fn of(
        alarm: &Alarm,
        programs: &ProgramMemory,
        main: ferrocut_program::FileId,
        texts: Catalogue,
    ) -> Finding {
        let alarm = with_word(alarm, Some(programs));
        let (column, end_column) = columns(&alarm, programs).unwrap_or((1, 1));
        let is_main = alarm.span.line == 0 || alarm.span.file == main;
        Finding {
            id: alarm.id.to_string(),
            severity: alarm.severity.name(),
            program: (!is_main).then(|| programs.file_name(alarm.span.file).to_owned()),
            line: alarm.span.line,
            column,
            end_line: alarm.span.line,
            end_column,
            text: texts.message(&alarm),
            help: texts.help(&alarm),
        }
    }
}

/// An alarm of a program, and how often the program came to it.
#[derive(Debug)]
pub struct Found {
    /// Words or block at fault, as the program gave them.
    span: Span,
    /// The alarm, pointed at the word.
    pub alarm: Alarm,
    /// How often it came.
    pub times: u64,
}

impl Found {
    /// Whether an alarm says the same of the same place.
    fn is(&self, alarm: &Alarm) -> bool {
        self.span == alarm.span && self.alarm.id == alarm.id && axis(&self.alarm) == axis(alarm)
    }
}

/// The axis that an alarm is about: those of a block lie at one place.
fn axis(alarm: &Alarm) -> Option<&Argument> {
    alarm.arguments.iter().find(|(name, _)| *name == "axis").map(|(_, axis)| axis)
}

/// What was found in a program. A loop that comes to a fault again makes no new finding, so that none hides another.
#[derive(Debug)]
pub struct AllFound {
    /// Each once, in the order in which the program first came to them.
    pub found: Vec<Found>,
    /// How many came when there was no more room.
    pub further: usize,
    most: usize,
}

impl AllFound {
    /// Nothing yet; `most` are kept.
    pub fn new(most: usize) -> AllFound {
        AllFound { found: Vec::new(), further: 0, most }
    }

    /// Whether there is no more room.
    pub fn is_full(&self) -> bool {
        self.found.len() >= self.most
    }

    /// Adds an alarm of the block that the interpreter has run.
    pub fn add(&mut self, mut alarm: Alarm, interpreter: &Interpreter) {
        if let Some(known) = self.found.iter_mut().find(|known| known.is(&alarm)) {
            known.times += 1;
        } else if self.is_full() {
            self.further += 1;
        } else {
            let span = alarm.span;
            point_at_word(&mut alarm, interpreter);
            self.found.push(Found { span, alarm, times: 1 });
        }
    }
}

/// Columns of the words at fault; none where no place is meant.
fn columns(alarm: &Alarm, programs: &ProgramMemory) -> Option<(u32, u32)> {
    let text = programs.text(alarm.span.file).filter(|_| alarm.span.line > 0)?;
    let (line, at) = text.line_of(alarm.span, LINE_READ).ok()?;
    let end = at.saturating_add(alarm.span.len as usize).min(line.len());
    let units = |from: usize, to: usize| {
        let piece = text.encoding().decode(line.get(from..to).unwrap_or(&[]));
        u32::try_from(piece.encode_utf16().count()).unwrap_or(u32::MAX)
    };
    let column = units(0, at).saturating_add(1);
    // Nothing at all cannot be underlined.
    Some((column, column.saturating_add(units(at, end).max(1))))
}

/// The alarm with the words at fault as an argument.
pub fn with_word(alarm: &Alarm, programs: Option<&ProgramMemory>) -> Alarm {
    let mut alarm = alarm.clone();
    if let Some(programs) = programs
        && alarm.span.len > 0
        && alarm.arguments.iter().all(|(name, _)| *name != "word")
    {
        let word: String = programs.slice(alarm.span).chars().take(WORD_QUOTED).collect();
        alarm.arguments.push(("word", Argument::from(word.trim())));
    }
    alarm
}

/// Narrows an alarm about a block to the word at fault, where the alarm tells which.
pub fn point_at_word(alarm: &mut Alarm, interpreter: &Interpreter) {
    let axis = alarm.arguments.iter().find_map(|(name, value)| match value {
        Argument::Text(letter) if *name == "axis" => letter.bytes().next(),
        _ => None,
    });
    let letter = match alarm.fault {
        Fault::SoftLimit | Fault::UnknownAxis => axis,
        Fault::ToolMissing => Some(b'T'),
        Fault::SpindleTooFast => Some(b'S'),
        _ => None,
    };
    if let Some(span) = letter.and_then(|letter| interpreter.locate_word(alarm.span, letter)) {
        alarm.span = span;
    }
}
