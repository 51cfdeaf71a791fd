//! Everything that is known of a control.

use crate::asked::Asked;
use crate::page::Page;
use ferrocut_interpreter::Dialect;
use ferrocut_machine::{Catalogue, Machine, Memory, ParameterTable, Reference};

/// Everything that is known of a control, and the values of a machine.
pub struct Book {
    /// The control language.
    pub dialect: &'static Dialect,
    /// What its manual says; none where there are no such tables.
    pub reference: Option<&'static Reference>,
    /// Parameters as the machine sets them.
    pub memory: Memory,
    /// The texts.
    pub catalogue: Catalogue,
}

impl Book {
    /// The tables of a control.
    pub fn new(dialect: &'static Dialect, memory: Memory, catalogue: Catalogue) -> Book {
        Book { dialect, reference: Reference::of(dialect.name), memory, catalogue }
    }

    /// The list of parameters.
    pub fn table(&self) -> &'static ParameterTable {
        self.memory.parameters.table()
    }

    /// Its G codes in tenths, those that the manual has and those that run.
    pub fn g_codes(&self) -> Vec<u16> {
        let listed = self.reference.into_iter().flat_map(|r| r.g_codes()).map(|row| row.tenths);
        let mut codes: Vec<u16> = self.dialect.g_codes.iter().map(|g| g.tenths).chain(listed).collect();
        codes.sort_unstable();
        codes.dedup();
        codes
    }

    /// Its M codes, those that the manual has and those that run.
    pub fn m_codes(&self) -> Vec<u16> {
        let listed = self.reference.into_iter().flat_map(|r| r.m_codes()).map(|row| row.code);
        let mut codes: Vec<u16> = self.dialect.m_codes.iter().map(|m| m.code).chain(listed).collect();
        codes.sort_unstable();
        codes.dedup();
        codes
    }

    pub(crate) fn knows_g(&self, tenths: u16) -> bool {
        self.g_codes().contains(&tenths)
    }

    /// The variable of a name without a sign, where the language has such.
    pub(crate) fn unsigned_variable(&self, name: &str) -> Option<u32> {
        let syntax = self.dialect.syntax;
        syntax.parameter_letter.and_then(|_| syntax.variable(name.as_bytes()))
    }

    pub(crate) fn knows_m(&self, code: u16) -> bool {
        self.m_codes().contains(&code)
    }

    /// The pages of things; those of places are made by [`Book::place`].
    pub fn pages(&self, things: &[Asked]) -> Vec<Page> {
        things.iter().filter_map(|thing| self.page(thing)).collect()
    }
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
