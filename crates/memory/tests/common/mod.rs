//! What the tests of the memory share.
#![allow(dead_code, missing_docs, clippy::unwrap_used, clippy::panic, clippy::expect_used)]

use ferrocut_geometry::{Axis, Position};
use ferrocut_machine::setup::VariableName;
use ferrocut_machine::{ParameterKey, ToolOffset, WorkOffset};
use ferrocut_memory::{Author, Change, Contents, Counter, Item, PlcArea, Settings, Store};
use std::path::Path;
use std::time::Duration;

pub const CONTROL: &str = "gsk990mc";

pub fn settings() -> Settings {
    Settings { snapshot_every: Duration::from_secs(3600), ..Settings::new(CONTROL) }
}

pub fn open(folder: &Path) -> Store {
    Store::open(folder, settings()).unwrap()
}

pub fn owner() -> Author {
    Author::Maintenance { name: "test".to_owned() }
}

pub fn number(number: u32) -> VariableName {
    VariableName::Number(number)
}

pub fn variable(n: u32, value: Option<f64>) -> Change {
    Change::Variable { name: number(n), value }
}

pub fn parameter(name: &str, value: f64) -> Change {
    Change::Parameter { key: name.parse().unwrap(), value: Some(value) }
}

pub fn program(name: &str, text: &str) -> Change {
    Change::Program { name: name.to_owned(), text: text.as_bytes().to_vec(), comment: String::new() }
}

pub fn all(store: &Store) -> Contents {
    store.reader().contents(&Item::ALL).unwrap()
}

/// Something of everything, different for each `n`.
pub fn something(n: u32) -> Vec<Change> {
    let f = f64::from(n);
    vec![
        program("O1234", &format!("O1234 (PART {n})\nG0 X{n}\nM30\n")),
        program(&format!("O{}", 2000 + n % 7), "M99\n"),
        parameter("P270", f64::from(n % 900) + 0.5),
        parameter("NO43.1", f64::from(n % 2)),
        Change::Offset {
            number: u16::try_from(n % 255 + 1).unwrap(),
            offset: ToolOffset { length: 100.0 + f, radius_wear: -0.001 * f, ..ToolOffset::ZERO },
        },
        Change::WorkZero { name: WorkOffset::Standard(1), zero: Position::xyz(f, -f, 0.1 * f) },
        Change::WorkZero {
            name: WorkOffset::Additional(u16::try_from(n % 50 + 1).unwrap()),
            zero: Position::xyz(0.0, f, 0.0),
        },
        Change::ReferencePoint { number: 2, position: Position::xyz(0.0, 0.0, f) },
        variable(500 + n % 500, Some(f * 0.1)),
        variable(500 + (n + 250) % 500, None),
        Change::Pitch { axis: Axis::X, point: u16::try_from(n % 128).unwrap(), value: 0.0001 * f },
        Change::Plc {
            area: PlcArea::D,
            first: u16::try_from(n % 9000).unwrap(),
            bytes: n.to_le_bytes().to_vec(),
        },
        Change::Plc { area: PlcArea::K, first: 0, bytes: vec![(n % 256) as u8] },
        Change::Counter { counter: Counter::Parts, value: f },
        Change::Ladder { text: (!n.is_multiple_of(5)).then(|| format!("; ladder {n}\nEND1\nEND2\n")) },
    ]
}

pub fn key(name: &str) -> ParameterKey {
    name.parse().unwrap()
}
