//! The tables of the database: what each row holds, and the sum that a row carries.
//!
//! Tables are data; the SQL that makes and reads them is made of this list (`database.rs`), and so are the lines
//! of a backup (`backup.rs`). Every row ends with a sum over its table and cells: a cell that changed by itself
//! is found where it is read. Nothing is ever empty: what has no value has no row.

use blake2::digest::consts::{U8, U32};
use blake2::{Blake2b, Digest};

/// What the cells of a column hold.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    /// A whole number.
    Whole,
    /// A number.
    Real,
    /// Text.
    Text,
    /// Bytes.
    Bytes,
}

/// A cell of a row.
#[derive(Clone, PartialEq, Debug)]
pub enum Cell {
    /// A whole number.
    Whole(i64),
    /// A number, finite, and never -0, which a database does not tell from 0.
    Real(f64),
    /// Text.
    Text(String),
    /// Bytes.
    Bytes(Vec<u8>),
}

/// A row without its sum.
pub type Row = Vec<Cell>;

impl Cell {
    /// What it holds.
    pub fn kind(&self) -> Kind {
        match self {
            Cell::Whole(_) => Kind::Whole,
            Cell::Real(_) => Kind::Real,
            Cell::Text(_) => Kind::Text,
            Cell::Bytes(_) => Kind::Bytes,
        }
    }
}

impl From<f64> for Cell {
    fn from(value: f64) -> Cell {
        Cell::Real(value + 0.0)
    }
}

impl From<u32> for Cell {
    fn from(value: u32) -> Cell {
        Cell::Whole(value.into())
    }
}

impl From<u16> for Cell {
    fn from(value: u16) -> Cell {
        Cell::Whole(value.into())
    }
}

impl From<u8> for Cell {
    fn from(value: u8) -> Cell {
        Cell::Whole(value.into())
    }
}

impl From<i64> for Cell {
    fn from(value: i64) -> Cell {
        Cell::Whole(value)
    }
}

impl From<&str> for Cell {
    fn from(value: &str) -> Cell {
        Cell::Text(value.to_owned())
    }
}

impl From<String> for Cell {
    fn from(value: String) -> Cell {
        Cell::Text(value)
    }
}

/// A table.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Table {
    /// Its name.
    pub name: &'static str,
    /// How many of the first columns name a row.
    pub keys: usize,
    /// The columns in order: name, and what they hold.
    pub columns: &'static [(&'static str, Kind)],
}

/// Name of the last column of every table.
pub const SUM: &str = "row_sum";

use Kind::{Bytes, Real, Text, Whole};

/// What the file is: schema, control.
pub const ABOUT: Table = Table { name: "about", keys: 1, columns: &[("name", Text), ("value", Text)] };

/// For each table how many rows it has and the sum of their sums; `commits` counts the commits. A row that
/// vanished, or came back from the past, is found by these.
pub const TOTAL: Table =
    Table { name: "total", keys: 1, columns: &[("name", Text), ("count", Whole), ("sum", Whole)] };

/// Part programs. Times are ms since 1970, UTC; `locked` is the level that locked it, 0 where none did.
pub const PROGRAM: Table = Table {
    name: "program",
    keys: 1,
    columns: &[
        ("name", Text),
        ("comment", Text),
        ("created", Whole),
        ("changed", Whole),
        ("locked", Whole),
        ("text", Bytes),
    ],
};

/// Parameters that somebody has set, in the unit of the control's list: `P270`, `NO43.1`.
pub const PARAMETER: Table =
    Table { name: "parameter", keys: 1, columns: &[("name", Text), ("value", Real)] };

/// Tool offsets that somebody has set, mm and degrees.
pub const TOOL_OFFSET: Table = Table {
    name: "tool_offset",
    keys: 1,
    columns: &[
        ("number", Whole),
        ("length", Real),
        ("length_wear", Real),
        ("radius", Real),
        ("radius_wear", Real),
        ("cutting_length", Real),
        ("entry_angle", Real),
        ("tip_radius", Real),
    ],
};

/// Columns of a position, mm and degrees, in the order of the axes.
macro_rules! position_columns {
    ($($first:expr),+) => {{
        use $crate::table::Kind::Real;
        &[
            $($first,)+
            ("x", Real), ("y", Real), ("z", Real), ("a", Real), ("b", Real), ("c", Real),
            ("u", Real), ("v", Real), ("w", Real),
        ]
    }};
}
pub(crate) use position_columns;

/// Work zeros that somebody has set: `external`, `G54`, `G54 P2`.
pub const WORK_ZERO: Table = Table { name: "work_zero", keys: 1, columns: position_columns![("name", Text)] };

/// Reference points that somebody has set, 1 to 4.
pub const REFERENCE_POINT: Table =
    Table { name: "reference_point", keys: 1, columns: position_columns![("number", Whole)] };

/// Macro variables that hold a value: `#500`. One without a row is empty, which is not 0.
pub const VARIABLE: Table = Table { name: "variable", keys: 1, columns: &[("name", Text), ("value", Real)] };

/// Points of the pitch tables that somebody has set, mm.
pub const PITCH: Table =
    Table { name: "pitch", keys: 2, columns: &[("axis", Text), ("point", Whole), ("value", Real)] };

/// Signals of the ladder that are kept, in blocks: area K, T, C or D, number of the block, its bytes.
pub const SIGNAL: Table =
    Table { name: "signal", keys: 2, columns: &[("area", Text), ("block", Whole), ("bytes", Bytes)] };

/// Counters of parts and of time (s).
pub const COUNTER: Table = Table { name: "counter", keys: 1, columns: &[("name", Text), ("value", Real)] };

/// Alarms, counted upwards.
pub const ALARM: Table = Table {
    name: "alarm",
    keys: 1,
    columns: &[
        ("number", Whole),
        ("time", Whole),
        ("id", Text),
        ("program", Text),
        ("line", Whole),
        ("arguments", Text),
    ],
};

/// Who changed what, counted upwards.
pub const LOG: Table = Table {
    name: "log",
    keys: 1,
    columns: &[
        ("number", Whole),
        ("time", Whole),
        ("level", Whole),
        ("who", Text),
        ("item", Text),
        ("name", Text),
        ("old", Text),
        ("new", Text),
    ],
};

/// Where the axes stood when it was last told, and which of them knew it; one row.
pub const LAST_POSITION: Table = Table {
    name: "last_position",
    keys: 1,
    columns: position_columns![
        ("number", Whole),
        ("time", Whole),
        ("referenced", Whole),
        ("work_system", Text),
        ("has_zero", Whole),
        ("zero_x", Real),
        ("zero_y", Real),
        ("zero_z", Real),
        ("zero_a", Real),
        ("zero_b", Real),
        ("zero_c", Real),
        ("zero_u", Real),
        ("zero_v", Real),
        ("zero_w", Real)
    ],
};

/// The block at which a run was broken off; one row.
pub const INTERRUPTED: Table = Table {
    name: "interrupted",
    keys: 1,
    columns: position_columns![
        ("number", Whole),
        ("time", Whole),
        ("program", Text),
        ("from_line", Whole),
        ("file", Text),
        ("line", Whole),
        ("block", Whole),
        ("text", Text),
        ("has_place", Whole)
    ],
};

/// The ladder that runs in the place of the machine's own; one row, or none.
pub const LADDER: Table = Table { name: "ladder", keys: 1, columns: &[("number", Whole), ("text", Text)] };

/// Passwords as argon2 writes them (PHC form), by level.
pub const PASSWORD: Table = Table { name: "password", keys: 1, columns: &[("level", Whole), ("hash", Text)] };

/// Wrong passwords since the last right one, by level and by where they were given.
pub const TRIES: Table =
    Table { name: "tries", keys: 2, columns: &[("level", Whole), ("seat", Text), ("failed", Whole)] };

/// The tables of today's schema.
pub const TABLES: &[Table] = &[
    ABOUT,
    TOTAL,
    PROGRAM,
    PARAMETER,
    TOOL_OFFSET,
    WORK_ZERO,
    REFERENCE_POINT,
    VARIABLE,
    PITCH,
    SIGNAL,
    COUNTER,
    ALARM,
    LOG,
    LAST_POSITION,
    INTERRUPTED,
    LADDER,
    PASSWORD,
    TRIES,
];

impl Table {
    /// The table of this name in today's schema.
    pub fn named(name: &str) -> Option<&'static Table> {
        TABLES.iter().find(|table| table.name == name)
    }

    /// Whether a row has the cells of this table.
    pub fn fits(&self, row: &[Cell]) -> bool {
        row.len() == self.columns.len()
            && row.iter().zip(self.columns).all(|(cell, (_, k))| cell.kind() == *k)
    }

    /// The sum of a row.
    pub fn sum(&self, row: &[Cell]) -> i64 {
        let mut hash = Blake2b::<U8>::new();
        // Lengths stand before what they measure, so that no two rows are the same bytes.
        let mut add = |tag: u8, bytes: &[u8]| {
            hash.update([tag]);
            hash.update((bytes.len() as u64).to_le_bytes());
            hash.update(bytes);
        };
        add(b'N', self.name.as_bytes());
        for cell in row {
            match cell {
                Cell::Whole(value) => add(b'W', &value.to_le_bytes()),
                Cell::Real(value) => add(b'R', &value.to_bits().to_le_bytes()),
                Cell::Text(text) => add(b'T', text.as_bytes()),
                Cell::Bytes(bytes) => add(b'B', bytes),
            }
        }
        i64::from_le_bytes(hash.finalize().into())
    }
}

/// The sum over a whole file, built piece by piece.
#[derive(Clone, Default)]
pub struct FileSum(Blake2b<U32>);

impl FileSum {
    /// Adds a piece.
    pub fn add(&mut self, bytes: &[u8]) {
        self.0.update(bytes);
    }

    /// The sum in hexadecimal digits.
    pub fn finish(self) -> String {
        self.0.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_tables_and_columns_are_plain_words_and_unique() {
        let plain =
            |name: &str| !name.is_empty() && name.bytes().all(|b| b.is_ascii_lowercase() || b == b'_');
        for (n, table) in TABLES.iter().enumerate() {
            assert!(plain(table.name) && table.keys >= 1 && table.keys <= table.columns.len());
            assert!(TABLES.iter().skip(n + 1).all(|other| other.name != table.name));
            for (c, (name, _)) in table.columns.iter().enumerate() {
                assert!(plain(name) && *name != SUM);
                assert!(table.columns.iter().skip(c + 1).all(|(other, _)| other != name));
            }
        }
    }

    #[test]
    fn a_sum_depends_on_the_table_and_every_cell() {
        let row: Row = vec!["P1".into(), 2.5.into()];
        let sum = PARAMETER.sum(&row);
        assert_eq!(sum, PARAMETER.sum(&row.clone()));
        assert_ne!(sum, VARIABLE.sum(&row));
        assert_ne!(sum, PARAMETER.sum(&["P2".into(), 2.5.into()]));
        assert_ne!(sum, PARAMETER.sum(&["P1".into(), 2.500_000_000_000_000_4.into()]));
        // The same bytes, divided in another way.
        assert_ne!(ABOUT.sum(&["ab".into(), "c".into()]), ABOUT.sum(&["a".into(), "bc".into()]));
        assert_eq!(Cell::from(-0.0), Cell::Real(0.0));
        let Cell::Real(zero) = Cell::from(-0.0) else { panic!() };
        assert!(zero.is_sign_positive());
    }

    #[test]
    fn a_row_that_is_not_of_the_table_does_not_fit() {
        assert!(PARAMETER.fits(&["P1".into(), 1.0.into()]));
        assert!(!PARAMETER.fits(&["P1".into()]));
        assert!(!PARAMETER.fits(&["P1".into(), 1u8.into()]));
    }
}
