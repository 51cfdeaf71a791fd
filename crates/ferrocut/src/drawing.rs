//! Drawings given in place of a part program.

use crate::diagnostics::Diagnostics;
use crate::job::{Exit, Failure};
use ferrocut_exchange::limits::MOST_BYTES;
use ferrocut_exchange::recognise::LOOKED_AT;
use ferrocut_exchange::write::Ends;
use ferrocut_exchange::{By, Drawing, Format, Order, Program, Settings, Style, plan, recognise, write};
use ferrocut_interpreter::{Dialect, Origins};
use ferrocut_machine::{Alarm, Fault, ImportSetup, Parameters};
use ferrocut_program::{FileId, OpenError, ProgramMemory, Span, Text};
use std::fs::File;
use std::io::{self, Read, Write};
use std::path::Path;

/// The drawing's place in program memory, behind the program that is made from it.
const DRAWING: FileId = FileId(1);

/// The bytes of a drawing, and how it is to be cut.
pub struct Source {
    /// Its name as it was given.
    pub name: String,
    /// What kind of drawing it is.
    pub format: Format,
    /// What told the kind; `None` where the user did.
    pub by: Option<By>,
    /// How it is cut.
    pub settings: Settings,
    bytes: Vec<u8>,
}

/// What a drawing became.
pub struct Made {
    /// The drawing as it was read, for what was left out of it.
    pub drawing: Drawing,
    /// The part program.
    pub program: Program,
}

/// What is known of a program that was made from a drawing.
pub struct FromDrawing {
    /// Where its lines come from.
    pub origins: Origins,
    /// What of the drawing was left out and should be known.
    pub warnings: Vec<Alarm>,
    /// What was passed over because it has no bearing on the path.
    pub notes: Vec<Alarm>,
    /// How the drawing was recognised, where nobody said what it is.
    recognised: Option<(&'static str, By)>,
}

impl FromDrawing {
    /// What `program`, made of `source`, brings along.
    pub fn new(source: &Source, origins: Origins, drawing: Drawing) -> FromDrawing {
        let recognised = source.by.map(|by| (source.format.name(), by));
        FromDrawing { origins, warnings: drawing.warnings, notes: drawing.notes, recognised }
    }

    /// Says on standard error that `file` was taken for a drawing, and what of it was left out.
    pub fn tell(&self, file: &str, programs: &ProgramMemory, diagnostics: &Diagnostics) {
        if let Some((kind, by)) = self.recognised.filter(|_| !diagnostics.is_json()) {
            let key = match by {
                By::Name => "label-drawing-by-name",
                By::Content => "label-drawing-by-content",
            };
            let arguments = [("file", file.into()), ("kind", kind.into())];
            // Nobody is left to tell if standard error is closed.
            let _ = writeln!(io::stderr(), "{}", diagnostics.catalogue().label(key, &arguments));
        }
        for warning in &self.warnings {
            diagnostics.report(warning, file, Some(programs));
        }
    }
}

/// What a file turned out to be.
pub enum Opened {
    /// A drawing.
    Drawing(Box<Source>),
    /// No drawing, and its text where it was read already.
    Program(Option<Text>),
}

impl Source {
    /// Looks whether a file is a drawing. The set-up may say so.
    pub fn open(path: &Path, setup: Option<&ImportSetup>) -> Result<Opened, Failure> {
        let (settings, format) = match setup {
            Some(setup) => Settings::of(setup, Order::AsDrawn).map_err(Failure::setting)?,
            None => (Settings::default(), None),
        };
        Source::open_as(path, settings, format)
    }

    /// Opens a file as this kind of drawing, or looks whether it is one.
    pub fn open_as(path: &Path, settings: Settings, format: Option<Format>) -> Result<Opened, Failure> {
        let is_input = path == Path::new("-");
        let name = if is_input { "standard input".to_owned() } else { path.to_string_lossy().into_owned() };
        let unreadable = |error: io::Error| Failure::unreadable(&name, &error.to_string());
        if let Some(format) = format {
            let bytes = match is_input {
                true => all(io::stdin().lock()),
                false if path.is_dir() => return Err(Failure::of_open(path, OpenError::Folder)),
                false => File::open(path).and_then(all),
            };
            let bytes = bytes.map_err(unreadable)?;
            return Ok(Opened::Drawing(Box::new(Source { name, format, by: None, settings, bytes })));
        }
        if is_input {
            let text = match Text::from_reader(io::stdin().lock()) {
                Ok(text) => text,
                Err(error) => return Err(Failure::of_open(path, error)),
            };
            let read = |text: &Text, most| text.window(0, most, &mut Vec::new(), <[u8]>::to_vec);
            let Some((format, by)) = recognise(path, &read(&text, LOOKED_AT).map_err(unreadable)?) else {
                return Ok(Opened::Program(Some(text)));
            };
            let bytes = read(&text, MOST_BYTES as usize + 1).map_err(unreadable)?;
            return Ok(Opened::Drawing(Box::new(Source { name, format, by: Some(by), settings, bytes })));
        }
        // What cannot be opened or is no file is no drawing, and told as such.
        let is_file = std::fs::metadata(path).is_ok_and(|about| about.is_file());
        let Some(file) = File::open(path).ok().filter(|_| is_file) else {
            return Ok(Opened::Program(None));
        };
        let mut bytes = Vec::new();
        (&file).take(LOOKED_AT as u64).read_to_end(&mut bytes).map_err(unreadable)?;
        let Some((format, by)) = recognise(path, &bytes) else { return Ok(Opened::Program(None)) };
        file.take(MOST_BYTES + 1 - LOOKED_AT as u64).read_to_end(&mut bytes).map_err(unreadable)?;
        Ok(Opened::Drawing(Box::new(Source { name, format, by: Some(by), settings, bytes })))
    }

    /// Makes a program of the drawing in the words of a control with these parameters. `stage` is told what is
    /// being done.
    pub fn program(
        &self,
        dialect: &Dialect,
        parameters: &Parameters,
        ends: Ends,
        stage: impl Fn(&str),
    ) -> Result<Made, Failure> {
        let Some(style) = Style::of(dialect.name) else {
            let alarm = Alarm::core(Fault::NoWriter, Span::default()).with("name", dialect.name);
            return Err(Failure::new(Box::new(alarm), Exit::WrongUse));
        };
        if self.bytes.trim_ascii().is_empty() {
            return Err(Failure::of_open(Path::new(&self.name), OpenError::Empty));
        }
        // Some controls read I and J as a parameter says (Weihong 4.3, G02).
        let centre_is_absolute = (dialect.rules)(parameters).motion.centre_is_absolute;
        let style = &Style { centre_is_absolute, ..*style };
        stage("label-stage-read");
        let read = ferrocut_exchange::read(&self.bytes, self.format, DRAWING, &self.settings);
        let drawing = read.map_err(|alarm| self.failure(alarm, dialect))?;
        stage("label-stage-plan");
        let moves = plan::plan(&drawing, self.settings.order);
        stage("label-stage-write");
        let title =
            Path::new(&self.name).file_name().map_or(self.name.clone(), |n| n.to_string_lossy().into());
        let program = write::write(&moves, &drawing, &self.settings, style, &title, ends);
        Ok(Made { drawing, program })
    }

    /// The drawing as the control runs it by itself.
    pub fn run(
        &self,
        dialect: &Dialect,
        parameters: &Parameters,
    ) -> Result<(ProgramMemory, FromDrawing), Failure> {
        let made = self.program(dialect, parameters, Ends::AsDrawn, |_| {})?;
        let (programs, origins) = self.memory(made.program, dialect)?;
        Ok((programs, FromDrawing::new(self, origins, made.drawing)))
    }

    /// An alarm about the drawing, with its text to show it in.
    fn failure(&self, mut alarm: Box<Alarm>, dialect: &Dialect) -> Failure {
        let exit = if alarm.fault == Fault::ImportSetting { Exit::WrongUse } else { Exit::Finding };
        alarm.span.file = FileId(0);
        let text = self.text().map(|text| Box::new(ProgramMemory::new(&self.name, text, dialect.syntax)));
        Failure { programs: text, file: self.name.clone(), ..Failure::new(alarm, exit) }
    }

    /// The program and behind it the drawing, for interpreting the one and showing the other.
    pub fn memory(&self, program: Program, dialect: &Dialect) -> Result<(ProgramMemory, Origins), Failure> {
        let text = Text::from_bytes(program.text.into_bytes());
        let text = text.map_err(|error| Failure::of_open(Path::new(&self.name), error))?;
        let mut programs = ProgramMemory::new(&self.name, text, dialect.syntax);
        if let Some(text) = self.text() {
            programs.add_shown(&self.name, text);
        }
        Ok((programs, Origins::new(DRAWING, program.origins)))
    }

    /// The drawing as text; `None` where it is none. What plotters are told beside the drawing has
    /// control characters, which are shown as blanks.
    fn text(&self) -> Option<Text> {
        let shown = |b: &u8| if *b < 0x20 && !matches!(b, b'\n' | b'\r' | b'\t') { b' ' } else { *b };
        Text::from_bytes(self.bytes.iter().map(shown).collect()).ok()
    }
}

/// Everything that a reader gives, up to a byte more than a drawing may have.
fn all(reader: impl Read) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    reader.take(MOST_BYTES + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}
