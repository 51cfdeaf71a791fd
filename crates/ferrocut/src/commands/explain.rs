//! `ferrocut explain`: what a code, parameter, alarm, variable or word of a program is.

use crate::cli::{Common, Show};
use crate::commands::names::complain;
use crate::diagnostics::Diagnostics;
use crate::job::{Exit, Failure, Shop};
use crate::stdout;
use clap::Args;
use ferrocut_desk::{Asked, Page, asked, memory_of};
use ferrocut_interpreter::{Dialect, dialects};
use ferrocut_machine::{Alarm, Fault, Machine, Memory};
use ferrocut_program::{OpenError, ProgramMemory, Span, Text};
use std::io::{self, Write};
use std::ops::Deref;
use std::path::{Path, PathBuf};

/// `ferrocut explain`
#[derive(Args)]
#[command(after_help = "WHAT is one of\n  \
    G84, g54, \"G10 L2\"       a G code, or one form of it\n  \
    M98                      an M code\n  \
    P270, NO43.1, 43#1, ODI  a parameter by number or symbol; NO43 for all bits of it\n  \
    45, 0045, gsk990mc:0045  an alarm of the control; FC-0302 one of Ferrocut's own\n  \
    '#5206'                  a macro variable (in quotes: a shell takes # for a comment)\n  \
    X, WHILE, SIN            an address letter, a word of the macro language\n  \
    part.nc:12:5             the word at line 12, column 5; part.nc:12 every word of the line;\n  \
    -- -:12:5                the same of a program on standard input\n\n\
    Examples:\n  \
    ferrocut explain G84\n  \
    ferrocut explain G73 P270 43#1 alarm 45\n  \
    ferrocut explain part.nc:12:5 --machine mill.toml\n\n\
    Exit status: 0, or 2 if something asked for does not exist.")]
pub struct ExplainArgs {
    /// Codes, parameters, alarms, variables, words, or places of a program (below)
    #[arg(value_name = "WHAT", required = true)]
    pub what: Vec<String>,
    /// Control language [default: that of the machine]
    #[arg(long, value_name = "NAME")]
    pub dialect: Option<String>,
    /// Machine file whose parameter values are shown [default: values as delivered]
    #[arg(long, value_name = "FILE")]
    pub machine: Option<PathBuf>,
    /// How results are printed.
    #[command(flatten)]
    pub show: Show,
}

impl ExplainArgs {
    /// What it shares with the commands that read a program.
    pub fn common(&self) -> Common {
        self.show.common(self.machine.clone(), self.dialect.clone())
    }
}

/// Runs the command.
pub fn run(args: &ExplainArgs) -> Result<Exit, Failure> {
    let book = Book::open(&args.common())?;
    let mut pages: Vec<Page> = Vec::new();
    let mut exit = Exit::Fine;
    for asked in asked::read(&args.what, &book, &|name| Path::new(name).is_file()) {
        match asked.and_then(|things| pages_of(&book, &things)) {
            Ok(found) => pages.extend(found),
            Err(reason) => {
                complain(&reason, &book.diagnostics);
                exit = Exit::WrongUse;
            }
        }
    }
    print(&pages, &book.diagnostics);
    Ok(exit)
}

/// Prints pages: one after the other for people, an object a line for programs.
pub fn print(pages: &[Page], diagnostics: &Diagnostics) {
    let mut out = stdout::lock();
    for (at, page) in pages.iter().enumerate() {
        let written = match diagnostics.is_json() {
            true => writeln!(out, "{}", page.json(diagnostics.catalogue())),
            false => {
                let gap = if at > 0 { "\n" } else { "" };
                write!(out, "{gap}{}", page.text(diagnostics.catalogue()))
            }
        };
        // A reader that went away is no fault.
        if written.is_err() {
            return;
        }
    }
}

/// All that is known of a control, and how messages of a command are shown.
pub struct Book {
    book: ferrocut_desk::Book,
    /// How messages are shown.
    pub diagnostics: Diagnostics,
}

impl Deref for Book {
    type Target = ferrocut_desk::Book;

    fn deref(&self) -> &ferrocut_desk::Book {
        &self.book
    }
}

impl Book {
    /// The tables of a control, with the values of the machine file where one is named.
    pub fn open(common: &Common) -> Result<Book, Failure> {
        let shop = Shop::open(common)?;
        let dialect = dialect_of(common, &shop.machine)?;
        let mut memory = Memory::new(dialect.name);
        if let Some(path) = &common.machine {
            let (read, passed_over) = memory_of(&shop.machine, dialect);
            memory = read;
            for reason in passed_over {
                let file = path.to_string_lossy();
                let arguments = [("file", (&*file).into()), ("reason", reason.into())];
                let text = shop.diagnostics.catalogue().label("label-passed-over", &arguments);
                complain(&text, &shop.diagnostics);
            }
        }
        Ok(Book::new(dialect, memory, shop.diagnostics))
    }

    /// The tables of a control.
    pub fn new(dialect: &'static Dialect, memory: Memory, diagnostics: Diagnostics) -> Book {
        Book { book: ferrocut_desk::Book::new(dialect, memory, diagnostics.catalogue()), diagnostics }
    }
}

/// The pages of things; the reason where one is a place at which nothing stands.
fn pages_of(book: &Book, things: &[Asked]) -> Result<Vec<Page>, String> {
    let mut pages = Vec::new();
    for thing in things {
        match thing {
            Asked::Place(file, line, column) => {
                let name = file.to_string_lossy();
                let found = open_program(file, book.dialect)
                    .and_then(|mut programs| book.place(&name, &mut programs, *line, *column));
                pages.extend(found.map_err(|error| open_error(&name, &error, &book.diagnostics))??);
            }
            thing => pages.extend(book.page(thing)),
        }
    }
    Ok(pages)
}

fn open_program(file: &Path, dialect: &'static Dialect) -> Result<ProgramMemory, OpenError> {
    match file == Path::new("-") {
        true => Text::from_reader(io::stdin().lock())
            .map(|text| ProgramMemory::new("standard input", text, dialect.syntax)),
        false => ProgramMemory::open(file, dialect.syntax),
    }
}

fn open_error(name: &str, error: &OpenError, diagnostics: &Diagnostics) -> String {
    let alarm = |fault| Alarm::core(fault, Span::default()).with("file", name);
    let alarm = match error {
        OpenError::Io(error) => alarm(Fault::FileUnreadable).with("reason", error.to_string()),
        OpenError::Folder => alarm(Fault::FileUnreadable).with("reason", "it is a folder"),
        OpenError::NotText | OpenError::Utf16 => alarm(Fault::FileNotText),
        OpenError::Empty => alarm(Fault::FileEmpty),
    };
    diagnostics.message(&alarm, None)
}

/// The control language that a command is about.
pub fn dialect_of(common: &Common, machine: &Machine) -> Result<&'static Dialect, Failure> {
    let name = common.dialect.as_deref().unwrap_or(&machine.dialect);
    dialects::by_name(name).ok_or_else(|| Failure::unknown_dialect(name))
}

/// A machine file that cannot be used.
pub fn unusable(path: &Path, reason: &str) -> Failure {
    Failure::config(&path.to_string_lossy(), reason)
}
