//! `ferrocut explain`: what a code, parameter, alarm, variable or word of a program is.

use crate::cli::{Common, Show};
use crate::commands::names::complain;
use crate::diagnostics::Diagnostics;
use crate::drawing::{Opened, Source};
use crate::job::{Exit, Failure, Shop, text_of};
use crate::stdout;
use clap::Args;
use ferrocut_desk::{Asked, Page, asked, memory_of};
use ferrocut_interpreter::{Dialect, dialects};
use ferrocut_machine::{Machine, Memory};
use ferrocut_program::ProgramMemory;
use std::io::Write;
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
                let mut programs = open_program(file, book)?;
                let found = book.place(&file.to_string_lossy(), &mut programs, *line, *column);
                pages.extend(found.map_err(|error| told(&Failure::of_open(file, error), book))??);
            }
            thing => pages.extend(book.page(thing)),
        }
    }
    Ok(pages)
}

/// The program in a file; what it is instead in a sentence.
fn open_program(file: &Path, book: &Book) -> Result<ProgramMemory, String> {
    let text = match Source::open(file, None).map_err(|failure| told(&failure, book))? {
        Opened::Drawing(source) => {
            let named = [("file", source.name.as_str().into()), ("kind", source.format.name().into())];
            return Err(book.catalogue.label("label-explain-drawing", &named));
        }
        Opened::Program(text) => text_of(file, text),
    };
    let text = text.map_err(|error| told(&Failure::of_open(file, error), book))?;
    Ok(match file == Path::new("-") {
        true => ProgramMemory::new("standard input", text, book.dialect.syntax),
        false => ProgramMemory::at(file, text, book.dialect.syntax),
    })
}

fn told(failure: &Failure, book: &Book) -> String {
    book.diagnostics.message(&failure.alarm, None)
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
