//! The programs that the control has: in the durable memory, or in its own where there is none.

use ferrocut_memory::Store;
use ferrocut_program::ProgramId;
use std::collections::BTreeMap;
use std::fmt;
use std::sync::{Arc, Mutex, PoisonError};

/// The programs of a control. Copies are of the same programs, and may be read on any thread.
#[derive(Clone)]
pub enum Library {
    /// In memory, by name.
    Held(Arc<Mutex<BTreeMap<String, Vec<u8>>>>),
    /// In the durable memory.
    Kept(Arc<Store>),
}

impl fmt::Debug for Library {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Library::Held(_) => "Held",
            Library::Kept(_) => "Kept",
        })
    }
}

impl Library {
    /// The text of a program. One that cannot be read is not there: whoever reads the memory says why.
    pub fn text(&self, name: &str) -> Option<Vec<u8>> {
        match self {
            Library::Held(programs) => {
                programs.lock().unwrap_or_else(PoisonError::into_inner).get(name).cloned()
            }
            Library::Kept(store) => store.reader().program(name).ok().flatten().map(|program| program.text),
        }
    }

    /// Bytes that the disk has room for; none where nothing is kept, or it does not tell.
    pub fn room(&self) -> Option<u64> {
        let Library::Kept(store) = self else { return None };
        let disk = rustix::fs::statvfs(store.folder()?).ok()?;
        Some(disk.f_bavail.saturating_mul(disk.f_frsize))
    }

    /// Whether there is a program of this name.
    pub fn has(&self, name: &str) -> bool {
        match self {
            Library::Held(programs) => {
                programs.lock().unwrap_or_else(PoisonError::into_inner).contains_key(name)
            }
            Library::Kept(store) => store.reader().has_program(name).unwrap_or(false),
        }
    }

    /// The program that is called so, with its text: `O12` finds `O0012`, small letters capital ones.
    pub fn named(&self, id: &ProgramId) -> Option<(String, Vec<u8>)> {
        let name = names(id).into_iter().find(|name| self.has(name));
        let name = name.or_else(|| self.spelled_otherwise(id))?;
        self.text(&name).map(|text| (name, text))
    }

    /// The name of the program that somebody means by this one: one that is written just so goes before.
    pub(super) fn name_of(&self, typed: &str) -> Option<String> {
        let found = names_of(typed).into_iter().find(|name| self.has(name));
        found.or_else(|| self.spelled_otherwise(&id_of(typed)))
    }

    /// The same with its text.
    pub fn typed(&self, name: &str) -> Option<(String, Vec<u8>)> {
        let name = self.name_of(name)?;
        self.text(&name).map(|text| (name, text))
    }

    /// The program with this name in other small and capital letters.
    fn spelled_otherwise(&self, id: &ProgramId) -> Option<String> {
        let is_it = |name: &String| id_of(name) == *id;
        match (id, self) {
            (ProgramId::Number(_), _) => None,
            (_, Library::Held(programs)) => {
                let programs = programs.lock().unwrap_or_else(PoisonError::into_inner);
                programs.keys().find(|name| is_it(name)).cloned()
            }
            (_, Library::Kept(store)) => {
                store.reader().programs().ok()?.into_iter().map(|entry| entry.name).find(is_it)
            }
        }
    }
}

/// Under which names a program may lie.
fn names(id: &ProgramId) -> Vec<String> {
    match id {
        ProgramId::Number(number) => {
            vec![format!("O{number:04}"), format!("O{number:05}"), format!("O{number}")]
        }
        ProgramId::Name(name) => vec![name.to_uppercase(), name.to_string()],
    }
}

/// The same for a name that somebody types.
pub(super) fn names_of(name: &str) -> Vec<String> {
    let name = name.trim();
    let others = names(&id_of(name)).into_iter().filter(|other| other != name);
    [name.to_owned()].into_iter().chain(others).collect()
}

/// The name under which a program is stored that somebody calls so: a number is written as one that is found.
pub(super) fn name_to_store(name: &str) -> String {
    let (name, id) = (name.trim(), id_of(name));
    let names = names(&id);
    let is_found = matches!(id, ProgramId::Name(_)) || names.iter().any(|other| other == name);
    names.into_iter().next().filter(|_| !is_found).unwrap_or_else(|| name.to_owned())
}

/// What a program is called by whoever types its name.
pub fn id_of(name: &str) -> ProgramId {
    let name = name.trim();
    match name.strip_prefix(['O', 'o']) {
        Some(digits) if !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit()) => {
            ProgramId::named(digits)
        }
        _ => ProgramId::named(name),
    }
}

/// The text of a program with the O number of its new name at its start; none where it has none there, or the names are
/// no numbers.
pub(super) fn renumbered(text: &[u8], name: &str, to: &str) -> Option<Vec<u8>> {
    let number = |name: &str| -> Option<u32> { name.trim().strip_prefix(['O', 'o'])?.parse().ok() };
    let (old, _) = (number(name)?, number(to)?);
    let start = text.iter().position(|b| !b.is_ascii_whitespace() && *b != b'%')?;
    let digits = text.get(start..)?.strip_prefix(b"O").or_else(|| text.get(start..)?.strip_prefix(b"o"))?;
    let length = digits.iter().position(|b| !b.is_ascii_digit()).unwrap_or(digits.len());
    let found: u32 = std::str::from_utf8(digits.get(..length)?).ok()?.parse().ok()?;
    if found != old {
        return None;
    }
    Some([text.get(..start)?, to.trim().as_bytes(), digits.get(length..)?].concat())
}

#[cfg(test)]
mod tests {
    use super::renumbered;

    #[test]
    fn the_number_at_the_start_follows_the_name() {
        for (text, name, to, wanted) in [
            ("O1 (PART)\nM30\n", "O0001", "O0077", Some("O0077 (PART)\nM30\n")),
            ("%\nO0001\nG0\n%", "O0001", "O12", Some("%\nO12\nG0\n%")),
            ("O2\nM30\n", "O0001", "O0077", None),
            ("G0 X0\n", "O0001", "O0077", None),
            ("O1\n", "O0001", "MAIN", None),
            ("", "O0001", "O0002", None),
        ] {
            let found = renumbered(text.as_bytes(), name, to);
            assert_eq!(found.as_deref(), wanted.map(str::as_bytes), "{text}");
        }
    }
}
