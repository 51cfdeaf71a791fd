//! `ferrocut explain`: what a code, parameter, alarm, variable or word of a program is.

mod asked;
mod describe;
pub mod page;
mod place;
mod word;

use crate::cli::{Common, Show};
use crate::commands::names::complain;
use crate::diagnostics::Diagnostics;
use crate::job::{Exit, Failure, Shop};
use asked::Asked;
use clap::Args;
use ferrocut_interpreter::{Dialect, dialects};
use ferrocut_machine::{Alarm, Fault, Machine, Memory, ParameterTable, Reference};
use ferrocut_program::Span;
use page::Page;
use std::io::{self, Write};
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
    for asked in asked::read(&args.what, &book) {
        match asked.and_then(|things| book.pages(&things)) {
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
    let mut out = io::stdout().lock();
    for (at, page) in pages.iter().enumerate() {
        let written = match diagnostics.is_json() {
            true => writeln!(out, "{}", page.json()),
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

/// Everything that is known of a control, and the values of a machine.
pub struct Book {
    /// The control language.
    pub dialect: &'static Dialect,
    /// What its manual says; none where there are no such tables.
    pub reference: Option<&'static Reference>,
    /// Parameters as the machine sets them.
    pub memory: Memory,
    /// How messages are shown.
    pub diagnostics: Diagnostics,
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
                crate::commands::names::complain(&text, &shop.diagnostics);
            }
        }
        Ok(Book::new(dialect, memory, shop.diagnostics))
    }

    /// The tables of a control.
    pub fn new(dialect: &'static Dialect, memory: Memory, diagnostics: Diagnostics) -> Book {
        Book { dialect, reference: Reference::of(dialect.name), memory, diagnostics }
    }

    /// The list of parameters.
    pub fn table(&self) -> &'static ParameterTable {
        self.memory.parameters.table()
    }

    fn g_codes(&self) -> Vec<u16> {
        let listed = self.reference.into_iter().flat_map(|r| r.g_codes()).map(|row| row.tenths);
        let mut codes: Vec<u16> = self.dialect.g_codes.iter().map(|g| g.tenths).chain(listed).collect();
        codes.sort_unstable();
        codes.dedup();
        codes
    }

    fn m_codes(&self) -> Vec<u16> {
        let listed = self.reference.into_iter().flat_map(|r| r.m_codes()).map(|row| row.code);
        let mut codes: Vec<u16> = self.dialect.m_codes.iter().map(|m| m.code).chain(listed).collect();
        codes.sort_unstable();
        codes.dedup();
        codes
    }

    fn knows_g(&self, tenths: u16) -> bool {
        self.g_codes().contains(&tenths)
    }

    /// The variable of a name without a sign, where the language has such.
    fn unsigned_variable(&self, name: &str) -> Option<u32> {
        let syntax = self.dialect.syntax;
        syntax.parameter_letter.and_then(|_| syntax.variable(name.as_bytes()))
    }

    fn knows_m(&self, code: u16) -> bool {
        self.m_codes().contains(&code)
    }

    /// The pages of things; the reason where one is a place at which nothing stands.
    fn pages(&self, things: &[Asked]) -> Result<Vec<Page>, String> {
        let mut pages = Vec::new();
        for thing in things {
            match thing {
                Asked::Place(file, line, column) => pages.extend(self.place(file, *line, *column)?),
                thing => pages.extend(self.page(thing)),
            }
        }
        Ok(pages)
    }
}

/// The control language that a command is about.
pub fn dialect_of(common: &Common, machine: &Machine) -> Result<&'static Dialect, Failure> {
    let name = common.dialect.as_deref().unwrap_or(&machine.dialect);
    dialects::by_name(name).ok_or_else(|| {
        let alarm = Alarm::core(Fault::UnknownDialect, Span::default()).with("name", name);
        Failure::new(Box::new(alarm), Exit::WrongUse)
    })
}

/// What a machine's control remembers: the list's values, and those of the machine file; and why some of
/// the file's are passed over.
pub fn memory_of(machine: &Machine, dialect: &Dialect) -> (Memory, Vec<String>) {
    let mut memory = Memory::new(dialect.name);
    let mut sound = Vec::new();
    let mut wrong = Vec::new();
    for (name, value) in &machine.parameters {
        let checked = name
            .parse::<ferrocut_machine::ParameterKey>()
            .and_then(|key| memory.parameters.check(&key, *value).map(|()| key));
        match checked {
            Ok(key) => sound.push((key, *value)),
            Err(error) => wrong.push(error.to_string()),
        }
    }
    if let Err(error) = memory.set_parameters(sound.iter().map(|(key, value)| (key, *value))) {
        wrong.push(error.to_string());
    }
    (memory, wrong)
}

/// A machine file that cannot be used.
pub fn unusable(path: &Path, reason: &str) -> Failure {
    let alarm = Alarm::core(Fault::ConfigUnusable, Span::default())
        .with("file", path.to_string_lossy().into_owned())
        .with("reason", reason);
    Failure::new(Box::new(alarm), Exit::WrongUse)
}
