//! Signals by their names, with what they mean: those of the NC, and those that the running ladder names.

use crate::api::NamedSignal;
use crate::signals;
use ferrocut_machine::{Catalogue, Language};
use ferrocut_plc::memory::Width;
use ferrocut_plc::{Address, Area, Memory, Program};

/// A signal as the page of diagnosis shows it.
#[derive(Clone, PartialEq, Debug)]
pub struct Entry {
    /// Its name; the address where it has none.
    pub name: String,
    /// Its address; of a value, that of its first byte.
    pub address: Address,
    /// Bytes of its value; 0 for a bit.
    pub bytes: u8,
}

/// Every signal of an area that has a name, by rising address. A ladder may have names of its own for signals of
/// the NC; those stand first.
pub fn entries(area: Area, ladder: &Program) -> Vec<Entry> {
    let mut entries: Vec<Entry> = ladder
        .symbols()
        .iter()
        .filter(|symbol| symbol.address.area == area)
        .map(|symbol| named(&symbol.name, symbol.address, ladder))
        .collect();
    for signal in signals::signals().filter(|signal| signal.address.area == area) {
        if entries.iter().all(|entry| entry.address != signal.address || entry.name != signal.name) {
            entries.push(Entry {
                name: signal.name.to_owned(),
                address: signal.address,
                bytes: signal.bytes,
            });
        }
    }
    entries.sort_by_key(|entry| (entry.address.byte, entry.address.bit));
    entries
}

/// The signals of an area that have a name, with their values and meanings.
pub fn table(area: Area, language: Language, ladder: &Program, memory: &Memory) -> Vec<NamedSignal> {
    let signal = |entry: Entry| NamedSignal {
        address: entry.place(),
        meaning: entry.meaning(language, ladder),
        value: entry.value(memory),
        name: entry.name,
    };
    entries(area, ladder).into_iter().map(signal).collect()
}

/// The area of a letter and the language of a tag, English where there is none; none where there is no such.
pub fn named_in(area: char, language: Option<&str>) -> Option<(Area, Language)> {
    Some((Area::from_letter(area)?, language.map_or(Some(Language::En), Language::from_tag)?))
}

/// The signal of a name or an address. At the address of a value of the NC it is that; at another it is the byte.
pub fn find(text: &str, ladder: &Program) -> Option<Entry> {
    if let Some(symbol) = ladder.symbols().iter().find(|symbol| symbol.name == text) {
        return Some(named(text, symbol.address, ladder));
    }
    if let Some(signal) = signals::signal(text) {
        let (name, address, bytes) = (signal.name.to_owned(), signal.address, signal.bytes);
        return Some(Entry { name, address, bytes });
    }
    let address = Address::parse(text).ok()?;
    let bytes = bytes_of_nc(address).unwrap_or(u8::from(address.bit.is_none()));
    Some(Entry { name: text.to_owned(), address, bytes })
}

/// Bytes of what the NC has at a place.
fn bytes_of_nc(address: Address) -> Option<u8> {
    signals::signals().find(|signal| signal.address == address).map(|signal| signal.bytes)
}

/// A signal of the ladder: where the NC has a value at that place, it is as wide as that, else as the ladder's functions
/// take it.
fn named(name: &str, address: Address, ladder: &Program) -> Entry {
    let of_ladder = || if address.bit.is_some() { 0 } else { ladder.bytes_at(address) };
    let bytes = bytes_of_nc(address).unwrap_or_else(of_ladder);
    Entry { name: name.to_owned(), address, bytes }
}

/// The value of so many bytes at an address, 0 for a bit: a bit 0 or 1, a number without sign.
pub fn value(address: Address, bytes: u8, memory: &Memory) -> u32 {
    match bytes {
        0 => u32::from(memory.bit(address)),
        1 => u32::from(memory.byte(address)),
        2 => memory.read(address.place(), Width::Two).cast_unsigned() & 0xFFFF,
        _ => memory.read(address.place(), Width::Four).cast_unsigned(),
    }
}

impl Entry {
    /// Its address as people write it: `F7.0`, `D12`.
    pub fn place(&self) -> String {
        let bit = self.address.bit.map_or_else(String::new, |bit| format!(".{bit}"));
        format!("{:?}{}{bit}", self.address.area, self.address.byte)
    }

    /// Its value: a bit 0 or 1, a number without sign.
    pub fn value(&self, memory: &Memory) -> u32 {
        value(self.address, self.bytes, memory)
    }

    /// What it means, in a language. Where the catalogue has no such name the ladder's own words stand, and nothing
    /// where it has none.
    pub fn meaning(&self, language: Language, ladder: &Program) -> String {
        let key = label(&self.name);
        let text = Catalogue::new(language).label(&key, &[]);
        if text != key {
            return text;
        }
        let own = ladder.symbols().iter().find(|symbol| symbol.name.as_str() == self.name.as_str());
        own.map(|symbol| symbol.meaning.to_string()).unwrap_or_default()
    }
}

/// The key of a signal's meaning in the catalogues: `*` is `not-`, `+` and `-` at the end are `-plus` and `-minus`.
pub fn label(name: &str) -> String {
    let (name, end) = match name.strip_suffix('+') {
        Some(name) => (name, "-plus"),
        None => name.strip_suffix('-').map_or((name, ""), |name| (name, "-minus")),
    };
    format!("label-signal-{}{end}", name.replace('*', "not-"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use ferrocut_plc::{Limits, Pace, Plc};

    const LADDER: &str = include_str!("../../../machines/standard.lad");
    const DOCUMENT: &str = include_str!("../../../docs/plc.md");

    fn ladder() -> Program {
        Program::from_text(LADDER.as_bytes(), &Limits::default()).unwrap()
    }

    #[test]
    fn every_signal_has_a_meaning_in_every_language_and_the_document_says_the_same() {
        let ladder = ladder();
        let mut rows = 0;
        for area in [Area::X, Area::Y, Area::F, Area::G, Area::A, Area::K, Area::D] {
            for entry in entries(area, &ladder) {
                let [en, zh] =
                    [Language::En, Language::Zh].map(|l| Catalogue::new(l).label(&label(&entry.name), &[]));
                assert!(en != label(&entry.name), "no text for {}", entry.name);
                assert!(zh != en && !zh.is_ascii(), "{}: {zh}", entry.name);
                let row = format!("| `{}` | `{}` | {en} |", entry.place(), entry.name);
                assert!(DOCUMENT.contains(&row), "docs/plc.md lacks\n{row}");
                rows += 1;
            }
        }
        let first_cell = |line: &'static str| line.strip_prefix("| `")?.split('`').next();
        let written = DOCUMENT.lines().filter_map(first_cell).filter(|cell| Address::parse(cell).is_ok());
        assert_eq!(written.count(), rows, "docs/plc.md has rows that neither NC nor ladder have");
    }

    #[test]
    fn the_ladder_and_the_nc_mean_the_same_place_by_a_name() {
        let ladder = ladder();
        for signal in signals::signals() {
            if let Some(address) = ladder.signal(signal.name) {
                assert_eq!(address, signal.address, "{}", signal.name);
            }
        }
        // What the ladder exchanges with the NC, the NC has.
        for symbol in ladder.symbols().iter().filter(|s| matches!(s.address.area, Area::F | Area::G)) {
            assert!(signals::signal(&symbol.name).is_some(), "the NC has no {}", symbol.name);
        }
    }

    #[test]
    fn signals_are_read_by_name_or_address() {
        let mut plc = Plc::new(ladder(), Pace::default());
        let memory = plc.memory_mut();
        memory.set_bit(Address::parse("F7.0").unwrap(), true);
        memory.write(Address::parse("F10").unwrap().place(), Width::Four, 70_000);
        memory.write(Address::parse("G10").unwrap().place(), Width::Two, -1);
        let value = |text: &str| find(text, plc.program()).map(|entry| entry.value(plc.memory()));
        assert_eq!([value("MF"), value("F7.0"), value("F7"), value("SF")], [1, 1, 1, 0].map(Some));
        assert_eq!([value("M_CODE"), value("*JV"), value("DEN")], [70_000, 0xFFFF, 0].map(Some));
        assert_eq!([value("F10"), value("F11")], [70_000, 17].map(Some), "a value, and a byte of it");
        assert_eq!([value("NOPE"), value("F9999")], [None, None]);
        let meaning =
            |text: &str, language| find(text, plc.program()).unwrap().meaning(language, plc.program());
        assert_eq!(meaning("*LX+", Language::En), "limit switch +X");
        assert_eq!(meaning("*LX+", Language::Zh), "+X 限位开关");
        // A name of the ladder's own has the ladder's words, an address none.
        assert_eq!(meaning("GOAL", Language::Zh), "pocket that is wanted, a word");
        assert_eq!(meaning("G99.1", Language::En), "");
    }
}
