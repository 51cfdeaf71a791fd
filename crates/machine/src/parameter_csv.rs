//! Parameters as a table that spreadsheets read: `name,value,default,min,max,unit,symbol,axis,room,
//! meaning`.
//!
//! Reading needs the columns `name` and `value` only, in any order, with commas or semicolons.

use crate::parameters::{Meaning, ParameterDef};
use std::io;

/// What a spreadsheet may put before the first cell.
const BYTE_ORDER_MARK: char = '\u{feff}';

/// A row as read. Neither cell was looked at.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ParameterCells {
    /// Line of the file, counted from 1.
    pub line: u64,
    /// The name.
    pub name: String,
    /// The value.
    pub value: String,
}

/// Why a table cannot be read.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum ParameterCsvError {
    /// There is no column of this name.
    NoColumn(&'static str),
    /// A line that is no row of the table.
    Row {
        /// The line, counted from 1.
        line: u64,
    },
}

/// Writes parameters with their values.
pub fn write_parameters<'a>(
    out: impl io::Write,
    rows: impl IntoIterator<Item = (&'a ParameterDef, f64)>,
) -> io::Result<()> {
    let mut csv = csv::Writer::from_writer(out);
    csv.write_record(["name", "value", "default", "min", "max", "unit", "symbol", "axis", "room", "meaning"])
        .map_err(io::Error::from)?;
    for (row, value) in rows {
        let number = |n: Option<f64>| n.map(|n| n.to_string()).unwrap_or_default();
        let meaning = match &row.meaning {
            Meaning::Value(text) => text.to_string(),
            Meaning::Bit { one, zero } => format!("1: {one}; 0: {zero}"),
        };
        csv.write_record([
            row.name.to_string(),
            value.to_string(),
            row.default.to_string(),
            number(row.min),
            number(row.max),
            row.unit.to_string(),
            row.symbol.to_string(),
            row.axis.to_string(),
            row.applies_to.to_string(),
            meaning,
        ])
        .map_err(io::Error::from)?;
    }
    csv.flush()
}

/// Reads names and values. Lines without either are passed over.
pub fn read_parameters(text: &str) -> Result<Vec<ParameterCells>, ParameterCsvError> {
    let text = text.trim_start_matches(BYTE_ORDER_MARK);
    let header = text.lines().next().unwrap_or_default();
    let delimiter = if header.contains(';') && !header.contains(',') { b';' } else { b',' };
    let mut csv = csv::ReaderBuilder::new()
        .delimiter(delimiter)
        .flexible(true)
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    let line_of = |e: &csv::Error| e.position().map_or(1, csv::Position::line);
    let header = csv.headers().map_err(|e| ParameterCsvError::Row { line: line_of(&e) })?.clone();
    let column = |name: &'static str| {
        let at = header.iter().position(|cell| cell.eq_ignore_ascii_case(name));
        at.ok_or(ParameterCsvError::NoColumn(name))
    };
    let (name, value) = (column("name")?, column("value")?);
    let mut rows = Vec::new();
    let (mut line, mut counted) = (1, 0);
    for row in csv.records() {
        let row = row.map_err(|e| ParameterCsvError::Row { line: line_of(&e) })?;
        // The reader's own count is one short where lines end with CR LF.
        let start = row.position().and_then(|p| usize::try_from(p.byte()).ok()).unwrap_or(counted);
        let start = start + text.bytes().skip(start).take_while(|b| matches!(b, b'\r' | b'\n')).count();
        line += text.bytes().take(start).skip(counted).filter(|b| *b == b'\n').count() as u64;
        counted = start;
        let cell = |at| row.get(at).unwrap_or_default().to_owned();
        let cells = ParameterCells { line, name: cell(name), value: cell(value) };
        if !(cells.name.is_empty() && cells.value.is_empty()) {
            rows.push(cells);
        }
    }
    Ok(rows)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parameters::{ParameterTable, Parameters};

    #[test]
    fn what_is_written_reads_back() {
        let table = ParameterTable::of("gsk990mc").unwrap();
        let mut bytes = Vec::new();
        write_parameters(&mut bytes, Parameters::new(table).iter()).unwrap();
        let text = String::from_utf8(bytes).unwrap();
        let rows = read_parameters(&text).unwrap();
        assert_eq!(rows.len(), table.len());
        for (definition, cells) in table.iter().zip(&rows) {
            assert_eq!((definition.key.to_string(), definition.default.to_string()), {
                (cells.name.clone(), cells.value.clone())
            });
        }
    }

    #[test]
    fn tables_of_spreadsheets_are_read() {
        let cells =
            |line, name: &str, value: &str| ParameterCells { line, name: name.into(), value: value.into() };
        let text =
            "\u{feff}Meaning;Value;Name\r\nretract; 1.5 ;P270\r\n;;\r\n\"two\nlines\";1;NO43.1\r\n;;P5";
        let rows = read_parameters(text).unwrap();
        assert_eq!(rows, [cells(2, "P270", "1.5"), cells(4, "NO43.1", "1"), cells(6, "P5", "")]);
        assert_eq!(read_parameters("name;values\n"), Err(ParameterCsvError::NoColumn("value")));
        assert_eq!(read_parameters(""), Err(ParameterCsvError::NoColumn("name")));
    }
}
