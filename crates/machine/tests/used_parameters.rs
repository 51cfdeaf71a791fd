//! What the lists say of a parameter's use is what the sources do: a list that says `no` of a parameter that the control
//! obeys lets somebody change it in the belief that nothing comes of it.
#![allow(missing_docs, clippy::unwrap_used)]

use ferrocut_machine::{Meaning, ParameterKey, ParameterTable};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Where parameters are read: the folders of sources, below `crates`, and the control whose they are.
const SOURCES: &[(&str, &[&str])] = &[
    (
        "gsk990mc",
        &["interpreter/src/dialects/gsk990mc", "controller/src", "memory/src", "machine/src", "server/src"],
    ),
    ("kaitong", &["interpreter/src/dialects/kaitong"]),
];

/// How a bit and a number are read; `p` and its like are the short names that functions give `Parameters::data`.
const BITS: &[&str] = &["bit", "forbidden"];
const NUMBERS: &[&str] = &["data", "p", "parameter", "of_axis", "ParameterKey::Data"];

/// Which are named without being read: of the channel P0 the sources say only who may choose it.
const ONLY_NAMED: &[&str] = &["P0"];

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        match path.is_dir() {
            true => files(&path, found),
            false => found.extend(Some(path).filter(|path| path.extension().is_some_and(|e| e == "rs"))),
        }
    }
}

/// A source without its tests and remarks, blanks put to one.
fn code_of(text: &str) -> String {
    let lines = text.lines().take_while(|line| !line.starts_with("#[cfg(test)]"));
    let code = lines.map(|line| line.split("//").next().unwrap_or_default());
    code.flat_map(str::split_whitespace).collect::<Vec<_>>().join(" ")
}

/// What stands in the brackets behind each `name`.
fn behind<'a>(code: &'a str, name: &str, [opens, closes]: [char; 2]) -> Vec<&'a str> {
    let is_of_name = |c: char| c.is_alphanumeric() || c == '_';
    let places = code.match_indices(name).filter(|(at, _)| !code[..*at].ends_with(is_of_name));
    let inside = |(at, _): (usize, &str)| {
        let rest = code[at + name.len()..].trim_start().strip_prefix(opens)?;
        Some(&rest[..rest.find(closes)?])
    };
    places.filter_map(inside).collect()
}

/// The numbers of a pattern or of a sum: `5 | 175..=179` has six, `88 + k` the first of some that belong together.
fn numbers(text: &str) -> BTreeSet<u16> {
    let whole = |text: &str| text.split([' ', '+']).find(|word| !word.is_empty())?.parse::<u16>().ok();
    let of = |part: &str| match part.split_once("..=") {
        Some((first, last)) => whole(first).zip(whole(last)).map(|(first, last)| first..=last),
        None => whole(part).map(|number| number..=number),
    };
    text.split(['|', ',']).filter_map(of).flatten().collect()
}

/// Parameters that a source reads.
fn read_in(code: &str, table: &ParameterTable) -> BTreeSet<ParameterKey> {
    let mut found = BTreeSet::new();
    let mut bits = |number: u16, bits: &str| {
        let bits = numbers(bits);
        // A bit that is counted may be any of them.
        let any = |bit: &u8| bits.is_empty() || bits.contains(&u16::from(*bit));
        found.extend((0..8).filter(any).map(|bit| ParameterKey::Bit { number, bit }));
    };
    for name in BITS {
        for (number, bit) in behind(code, name, ['(', ')']).iter().filter_map(|text| text.split_once(',')) {
            numbers(number).into_iter().for_each(|number| bits(number, bit));
        }
    }
    for text in behind(code, "ParameterKey::Bit", ['{', '}']) {
        let field = |name: &str| text.split(',').find_map(|f| f.trim().strip_prefix(name)?.strip_prefix(':'));
        let number = field("number").map(numbers).unwrap_or_default();
        number.into_iter().for_each(|number| bits(number, field("bit").unwrap_or_default()));
    }
    for name in NUMBERS {
        let texts = behind(code, name, ['(', ')']);
        // Some at once, as `[294, 295].map(p)`.
        let map = format!("].map({name})");
        let before = code.match_indices(&map).map(|(at, _)| &code[code[..at].rfind('[').unwrap() + 1..at]);
        // `data(1, …)` is of something else.
        let single = texts.into_iter().filter(|text| !text.contains(','));
        found.extend(single.chain(before).flat_map(numbers).map(ParameterKey::Data));
    }
    // `const SETTER: [u16; 3] = [387, 388, 389];` is read by its name.
    for (at, _) in code.match_indices("const ") {
        let Some((head, value)) = code[at..].split_once('=') else { continue };
        let name = head["const ".len()..].split(':').next().unwrap_or_default().trim();
        let is_read = ["parameter(", "data("].iter().any(|reader| code.contains(&format!("{reader}{name}")));
        if head.contains("u16") && (is_read || code.contains(&format!("{name}.map(|number| self.parameter")))
        {
            let value = value.split(';').next().unwrap_or_default().trim_matches([' ', '[', ']']);
            found.extend(numbers(value).into_iter().map(ParameterKey::Data));
        }
    }
    with_their_like(found, table)
}

/// Numbers that differ by axis or gear alone (`rapid_speed_axis1`) are read as one.
fn with_their_like(mut found: BTreeSet<ParameterKey>, table: &ParameterTable) -> BTreeSet<ParameterKey> {
    let family = |symbol: &str| {
        let family = symbol.trim_end_matches(|c: char| c.is_ascii_digit());
        ["_axis", "_g"].iter().any(|end| family.ends_with(end)).then(|| family.to_owned())
    };
    let read: BTreeSet<String> = found.iter().filter_map(|key| family(&table.get(key)?.symbol)).collect();
    let numbers = table.iter().filter(|row| matches!(row.meaning, Meaning::Value(_)));
    let like = numbers.filter(|row| family(&row.symbol).is_some_and(|family| read.contains(&family)));
    found.extend(like.map(|row| row.key.clone()));
    found
}

fn read_by(dialect: &str) -> BTreeSet<ParameterKey> {
    let table = ParameterTable::of(dialect).unwrap();
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
    let mut sources = Vec::new();
    for (_, folders) in SOURCES.iter().filter(|(of, _)| *of == dialect) {
        folders.iter().for_each(|folder| files(&crates.join(folder), &mut sources));
    }
    let read = |path: &PathBuf| read_in(&code_of(&fs::read_to_string(path).unwrap()), table);
    sources.iter().flat_map(read).collect()
}

#[test]
fn what_the_control_reads_is_not_called_unused() {
    for (dialect, _) in SOURCES {
        let table = ParameterTable::of(dialect).unwrap();
        let read = read_by(dialect);
        let rows = read.iter().filter_map(|key| table.get(key)).filter(|row| !row.used);
        let wrong: Vec<&str> = rows.map(|row| &*row.name).filter(|name| !ONLY_NAMED.contains(name)).collect();
        assert_eq!(wrong, [""; 0], "{dialect}");
    }
}

/// The search finds every way that sources write a parameter.
#[test]
fn parameters_are_found_in_the_sources() {
    let read = read_by("gsk990mc");
    for name in [
        "NO29.3", "NO10.5", "NO17.5", "NO4.0", "NO0.2", "NO2.4", "NO27.4", "P86", "P90", "P94", "P133",
        "P154", "P158", "P172", "P287", "P296", "P356", "P388", "P391", "P214", "P211",
    ] {
        assert!(read.contains(&name.parse().unwrap()), "{name}");
    }
    for name in ["NO53.0", "NO19.0", "P184", "P201", "P340", "P402"] {
        assert!(!read.contains(&name.parse().unwrap()), "{name}");
    }
    assert!(read_by("kaitong").contains(&"P018.4".parse().unwrap()));
}
