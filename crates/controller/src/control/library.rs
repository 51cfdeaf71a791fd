//! The programs that the control has: in the durable memory, or in its own where there is none.

use ferrocut_memory::Store;
use ferrocut_program::{ProgramId, Source, Text};
use std::collections::BTreeMap;
use std::fmt;
use std::sync::{Arc, Mutex, PoisonError};

/// Where programs are found.
#[derive(Clone)]
pub(super) enum Library {
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

    /// The name under which there is such a program: `O12` finds `O0012`, small letters capital ones.
    pub fn named(&self, id: &ProgramId) -> Option<(String, Vec<u8>)> {
        let names = match id {
            ProgramId::Number(number) => {
                vec![format!("O{number:04}"), format!("O{number:05}"), format!("O{number}")]
            }
            ProgramId::Name(name) => vec![name.to_string(), name.to_uppercase()],
        };
        names.into_iter().find_map(|name| self.text(&name).map(|text| (name, text)))
    }
}

impl Source for Library {
    fn find(&mut self, id: &ProgramId) -> Option<(String, Text)> {
        let (name, text) = self.named(id)?;
        Some((name, Text::from_bytes(text).ok()?))
    }
}

/// What a program is called by whoever types its name.
pub(super) fn id_of(name: &str) -> ProgramId {
    let name = name.trim();
    match name.strip_prefix(['O', 'o']) {
        Some(digits) if !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit()) => {
            ProgramId::named(digits)
        }
        _ => ProgramId::named(name),
    }
}
