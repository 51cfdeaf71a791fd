//! Tool offsets and work offsets: the tables an operator fills in before a program runs.

use ferrocut_geometry::Position;
use std::fmt;
use std::str::FromStr;

/// One row of the tool offset table.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct ToolOffset {
    /// Geometry of the length (H), mm.
    pub length: f64,
    /// Wear of the length, mm.
    pub length_wear: f64,
    /// Geometry of the radius (D) as entered, mm: the diameter where the control is set to take
    /// diameters (GSK990MC 40#7).
    pub radius: f64,
    /// Wear of the radius, entered as the geometry is, mm.
    pub radius_wear: f64,
    /// Length of the cutting edge, mm; 0 where not given.
    pub cutting_length: f64,
    /// Steepest angle at which the tool may enter the material, degrees; 0 where not given.
    pub entry_angle: f64,
    /// Radius of the rounded tip, mm: 0 for a flat tool, the radius for a ball.
    pub tip_radius: f64,
}

impl ToolOffset {
    /// An offset of nothing.
    pub const ZERO: ToolOffset = ToolOffset {
        length: 0.0,
        length_wear: 0.0,
        radius: 0.0,
        radius_wear: 0.0,
        cutting_length: 0.0,
        entry_angle: 0.0,
        tip_radius: 0.0,
    };
}

/// The tool offset table. Number 0 is always an offset of nothing.
#[derive(Clone, Debug)]
pub struct ToolTable {
    /// Rows from number 0 up to the highest one written, but at least those of a common table.
    rows: Vec<ToolOffset>,
    last: u16,
}

/// Rows held from the start: the whole table of the smallest controls.
const FIRST_ROWS: u16 = 256;

impl ToolTable {
    /// Highest number that any control has.
    pub const LARGEST: u16 = 9999;

    /// A table of zeros with the numbers 0 to `last`.
    pub fn new(last: u16) -> ToolTable {
        let last = last.min(ToolTable::LARGEST);
        let rows = usize::from(last.min(FIRST_ROWS - 1)) + 1;
        ToolTable { rows: vec![ToolOffset::ZERO; rows], last }
    }

    /// The highest number.
    pub fn last(&self) -> u16 {
        self.last
    }

    /// A row; none beyond the table.
    #[inline]
    pub fn get(&self, number: u16) -> Option<&ToolOffset> {
        match self.rows.get(usize::from(number)) {
            None if number <= self.last => Some(&ToolOffset::ZERO),
            row => row,
        }
    }

    /// A row to be written; none beyond the table and for number 0.
    pub fn get_mut(&mut self, number: u16) -> Option<&mut ToolOffset> {
        if number == 0 || number > self.last {
            return None;
        }
        let place = usize::from(number);
        if self.rows.len() <= place {
            self.rows.resize(place + 1, ToolOffset::ZERO);
        }
        self.rows.get_mut(place)
    }

    /// The rows that hold something, with their numbers.
    pub fn used(&self) -> impl Iterator<Item = (u16, &ToolOffset)> {
        (0u16..).zip(&self.rows).filter(|(_, row)| **row != ToolOffset::ZERO)
    }
}

/// The name of a work offset.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub enum WorkOffset {
    /// The one that is added to every other.
    External,
    /// G54 to G59, counted from 1 to 6.
    Standard(u8),
    /// G54 P1 and on, counted from 1.
    Additional(u16),
}

impl WorkOffset {
    /// The work offset that G54 to G59 selects.
    pub fn from_g(code: u16) -> Option<WorkOffset> {
        match code {
            54..=59 => u8::try_from(code - 53).ok().map(WorkOffset::Standard),
            _ => None,
        }
    }
}

/// `external`, `G54`, `G54 P2`.
impl fmt::Display for WorkOffset {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            WorkOffset::External => f.write_str("external"),
            WorkOffset::Standard(n) => write!(f, "G{}", 53 + u16::from(*n)),
            WorkOffset::Additional(n) => write!(f, "G54 P{n}"),
        }
    }
}

/// Text that names no work offset.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct WorkOffsetNameError(Box<str>);

impl fmt::Display for WorkOffsetNameError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?} names no work offset: write external, G54 to G59, or G54 P1 and on", self.0)
    }
}

impl std::error::Error for WorkOffsetNameError {}

impl FromStr for WorkOffset {
    type Err = WorkOffsetNameError;

    fn from_str(text: &str) -> Result<WorkOffset, WorkOffsetNameError> {
        let wrong = || WorkOffsetNameError(text.into());
        let upper = text.trim().to_ascii_uppercase();
        if upper == "EXTERNAL" {
            return Ok(WorkOffset::External);
        }
        if let Some(number) = upper.strip_prefix("G54").map(str::trim_start).and_then(|r| r.strip_prefix('P'))
        {
            let digits = !number.is_empty() && number.bytes().all(|b| b.is_ascii_digit());
            let number = number.parse().ok().filter(|n| digits && *n > 0);
            return number.map(WorkOffset::Additional).ok_or_else(wrong);
        }
        let code = upper.strip_prefix('G').filter(|d| d.bytes().all(|b| b.is_ascii_digit()));
        code.and_then(|d| d.parse().ok()).and_then(WorkOffset::from_g).ok_or_else(wrong)
    }
}

/// The work offsets: for each work coordinate system the machine position of its zero, mm and degrees.
#[derive(Clone, Debug)]
pub struct WorkOffsets {
    /// Added to every other.
    pub external: Position,
    /// G54 to G59.
    pub standard: [Position; 6],
    /// G54 P1 and on.
    pub additional: Vec<Position>,
}

impl WorkOffsets {
    /// Most additional systems that any control has.
    pub const LARGEST: u16 = 300;

    /// All zeros, with `additional` systems beside G54 to G59.
    pub fn new(additional: u16) -> WorkOffsets {
        WorkOffsets {
            external: Position::ZERO,
            standard: [Position::ZERO; 6],
            additional: vec![Position::ZERO; usize::from(additional.min(WorkOffsets::LARGEST))],
        }
    }

    /// The zero of a system, without the external offset; none where the control has no such system.
    pub fn get(&self, name: WorkOffset) -> Option<Position> {
        match name {
            WorkOffset::External => Some(self.external),
            WorkOffset::Standard(n) => self.standard.get(usize::from(n).checked_sub(1)?).copied(),
            WorkOffset::Additional(n) => self.additional.get(usize::from(n).checked_sub(1)?).copied(),
        }
    }

    /// The zero of a system to be written; none where the control has no such system.
    pub fn get_mut(&mut self, name: WorkOffset) -> Option<&mut Position> {
        match name {
            WorkOffset::External => Some(&mut self.external),
            WorkOffset::Standard(n) => self.standard.get_mut(usize::from(n).checked_sub(1)?),
            WorkOffset::Additional(n) => self.additional.get_mut(usize::from(n).checked_sub(1)?),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tool_number_0_stays_nothing() {
        let mut tools = ToolTable::new(255);
        assert_eq!(tools.get(0), Some(&ToolOffset::ZERO));
        assert!(tools.get_mut(0).is_none());
        assert!(tools.get(256).is_none() && tools.get_mut(256).is_none());
        tools.get_mut(255).unwrap().radius = 5.0;
        assert_eq!(tools.get(255).unwrap().radius, 5.0);
        assert_eq!(tools.used().map(|(n, _)| n).collect::<Vec<_>>(), [255]);
    }

    #[test]
    fn a_large_table_grows_as_it_is_written() {
        let mut tools = ToolTable::new(u16::MAX);
        assert_eq!(tools.last(), ToolTable::LARGEST);
        assert_eq!(tools.get(9999), Some(&ToolOffset::ZERO));
        tools.get_mut(5000).unwrap().length = 1.0;
        assert_eq!(tools.get(5000).unwrap().length, 1.0);
        assert_eq!(tools.get(5001), Some(&ToolOffset::ZERO));
        assert!(tools.get(10_000).is_none());
    }

    #[test]
    fn work_offsets_read_as_they_are_written() {
        for name in ["external", "G54", "G59", "G54 P1", "G54 P300"] {
            assert_eq!(name.parse::<WorkOffset>().unwrap().to_string(), name);
        }
        assert_eq!("g54p2".parse(), Ok(WorkOffset::Additional(2)));
        for name in ["", "G", "G53", "G60", "54", "G54 P0", "G54 P", "G55 P1", "G54 P-1", "G+54"] {
            assert!(name.parse::<WorkOffset>().is_err(), "{name}");
        }
    }

    #[test]
    fn systems_beyond_the_table_do_not_exist() {
        let mut work = WorkOffsets::new(50);
        *work.get_mut(WorkOffset::Additional(50)).unwrap() = Position::xyz(1.0, 2.0, 3.0);
        *work.get_mut(WorkOffset::Standard(6)).unwrap() = Position::xyz(4.0, 0.0, 0.0);
        assert_eq!(work.get(WorkOffset::Additional(50)), Some(Position::xyz(1.0, 2.0, 3.0)));
        assert_eq!(work.standard[5], Position::xyz(4.0, 0.0, 0.0));
        for name in [
            WorkOffset::Additional(0),
            WorkOffset::Additional(51),
            WorkOffset::Standard(0),
            WorkOffset::Standard(7),
        ] {
            assert!(work.get(name).is_none() && work.get_mut(name).is_none());
        }
    }
}
