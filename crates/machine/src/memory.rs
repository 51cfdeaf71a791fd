//! What a control remembers when no program runs: parameters, offsets, variables, reference points.

use crate::offsets::{ToolTable, WorkOffset, WorkOffsets};
use crate::parameters::{ParameterError, ParameterKey, ParameterTable, Parameters};
use crate::tool_library::ToolLibrary;
use ferrocut_geometry::{Axis, Position};
use std::collections::BTreeMap;
use std::fmt;
use std::ops::RangeInclusive;

/// The memory of one control.
#[derive(Clone, Debug)]
pub struct Memory {
    /// The control's own parameters.
    pub parameters: Parameters,
    /// Tool offsets.
    pub tools: ToolTable,
    /// The tools that there are, where a tool table of LinuxCNC says so.
    pub library: Option<ToolLibrary>,
    /// Work offsets.
    pub work: WorkOffsets,
    /// Macro variables.
    pub variables: Variables,
    /// Machine positions of the reference points, first to fourth, mm and degrees.
    pub reference_points: [Position; 4],
    /// Whether P10 to P64 are other names of offsets and reference points.
    offsets_are_parameters: bool,
    /// Coordinate systems stand in variables too.
    systems_are_variables: bool,
}

/// Variables that keep their values while power is off (GSK990MC 4.9.2, table 4-9-2-1).
const KEPT: RangeInclusive<u32> = 500..=999;

/// Those in which RS274/NGC has the shift of G92, the coordinate system in force and the turns of all (LinuxCNC, numbered
/// parameters): they are kept as the zeros are.
const KEPT_SYSTEMS: RangeInclusive<u32> = 5210..=5390;

impl Memory {
    /// The memory as delivered: parameters at their default, everything else zero or empty.
    pub fn new(dialect: &str) -> Memory {
        // GSK990MC: offset numbers 0 to 255 (3.1.3), additional systems P1 to P50 (4.2.9). Other
        // controls get the largest tables until they have a row of their own.
        let (last_tool, additional) = match dialect {
            "gsk990mc" => (255, 50),
            // Kaitong: H01 to H24 (appendix 8, 1.1.3); additional systems as on the Fanuc 0i-M.
            "kaitong" => (24, 48),
            // Weihong: D00 to D07 and H00 to H07 (4.3); G54 to G59 alone.
            "weihong" => (7, 0),
            // Fagor: an offset for every tool; G54 to G59 alone.
            "fagor8065" => (ToolTable::LARGEST, 0),
            _ => (ToolTable::LARGEST, WorkOffsets::LARGEST),
        };
        let table = ParameterTable::of(dialect).unwrap_or_else(ParameterTable::empty);
        Memory {
            parameters: Parameters::new(table),
            tools: ToolTable::new(last_tool),
            library: None,
            work: WorkOffsets::new(additional),
            variables: Variables::new(),
            reference_points: [Position::ZERO; 4],
            offsets_are_parameters: dialect == "gsk990mc",
            systems_are_variables: dialect == "rs274",
        }
    }

    /// Whether a variable keeps its value while power is off.
    pub fn keeps_variable(&self, number: u32) -> bool {
        KEPT.contains(&number) || self.systems_are_variables && KEPT_SYSTEMS.contains(&number)
    }

    /// Sets a parameter, in the unit of the control's list. Where the parameter is another name of an
    /// offset or a reference point, that is set too.
    pub fn set_parameter(&mut self, key: &ParameterKey, value: f64) -> Result<(), ParameterError> {
        self.parameters.set(key, value)?;
        if let Some((place, axis)) = self.place(key)
            && let Some(position) = self.position_mut(place)
        {
            position[axis] = value;
        }
        Ok(())
    }

    /// Sets parameters in whatever order they come: the names of the axes go first, since others are another
    /// name of what belongs to an axis.
    pub fn set_parameters<'a>(
        &mut self,
        parameters: impl Iterator<Item = (&'a ParameterKey, f64)> + Clone,
    ) -> Result<(), ParameterError> {
        let names_axis = |key: &ParameterKey| matches!(key, ParameterKey::Data(5 | 175..=179));
        for first in [true, false] {
            for (key, value) in parameters.clone().filter(|(key, _)| names_axis(key) == first) {
                self.set_parameter(key, value)?;
            }
        }
        Ok(())
    }

    /// The value of a parameter, in the unit of the control's list; 0 where it does not exist. Where it
    /// is another name of an offset or a reference point, the value of that.
    pub fn parameter(&self, key: &ParameterKey) -> f64 {
        let aliased = self.place(key).and_then(|(place, axis)| match place {
            Place::Work(name) => self.work.get(name).map(|p| p[axis]),
            Place::Reference(n) => self.reference_points.get(n).map(|p| p[axis]),
        });
        aliased.unwrap_or_else(|| self.parameters.get(key))
    }

    /// What P10 to P64 stand for: five axes each of the external offset, G54 to G59 and the four
    /// reference points (GSK990MC appendix 1). None of any other parameter.
    pub fn place(&self, key: &ParameterKey) -> Option<(Place, Axis)> {
        let &ParameterKey::Data(number) = key else { return None };
        if !self.offsets_are_parameters || !(10..=64).contains(&number) {
            return None;
        }
        let place = match (number - 10) / 5 {
            0 => Place::Work(WorkOffset::External),
            system @ 1..=6 => Place::Work(WorkOffset::Standard(u8::try_from(system).ok()?)),
            point => Place::Reference(usize::from(point) - 7),
        };
        Some((place, self.parameters.axis_names().get(usize::from((number - 10) % 5)).copied()?))
    }

    fn position_mut(&mut self, place: Place) -> Option<&mut Position> {
        match place {
            Place::Work(name) => self.work.get_mut(name),
            Place::Reference(n) => self.reference_points.get_mut(n),
        }
    }
}

/// A position that a parameter is another name of.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Place {
    /// The zero of a work coordinate system.
    Work(WorkOffset),
    /// A reference point, counted from 0.
    Reference(usize),
}

/// Numbers held flat; the others are few.
const FLAT: usize = 1000;

/// Most variables beyond the flat ones, and most named ones: a program that counts upwards for ever
/// must not take the memory of the machine.
const LARGEST_REST: usize = 65_536;

/// The macro variables. A variable holds a number or is empty, which is not the same as zero.
#[derive(Clone, Debug)]
pub struct Variables {
    /// #0 to #999; NaN is an empty variable and never leaves this type.
    flat: Vec<f64>,
    more: BTreeMap<u32, f64>,
    named: BTreeMap<Box<str>, f64>,
}

/// Why a variable cannot be set.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum VariableError {
    /// #0 is always empty.
    Null,
    /// No room for another variable.
    Full,
}

impl fmt::Display for VariableError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            VariableError::Null => f.write_str("#0 is always empty and cannot be set"),
            VariableError::Full => write!(f, "no room for more than {LARGEST_REST} further variables"),
        }
    }
}

impl std::error::Error for VariableError {}

impl Default for Variables {
    fn default() -> Variables {
        Variables::new()
    }
}

impl Variables {
    /// All empty.
    pub fn new() -> Variables {
        Variables { flat: vec![f64::NAN; FLAT], more: BTreeMap::new(), named: BTreeMap::new() }
    }

    /// The value of `#number`; none where it is empty.
    #[inline]
    pub fn get(&self, number: u32) -> Option<f64> {
        match usize::try_from(number).ok().and_then(|n| self.flat.get(n)) {
            Some(value) if value.is_nan() => None,
            Some(value) => Some(*value),
            None => self.more.get(&number).copied(),
        }
    }

    /// Sets `#number`; none, or a value that is no number, empties it.
    pub fn set(&mut self, number: u32, value: Option<f64>) -> Result<(), VariableError> {
        let value = value.filter(|v| !v.is_nan());
        if number == 0 {
            return Err(VariableError::Null);
        }
        if let Some(cell) = usize::try_from(number).ok().and_then(|n| self.flat.get_mut(n)) {
            *cell = value.unwrap_or(f64::NAN);
            return Ok(());
        }
        put(&mut self.more, number, value)
    }

    /// Empties all variables whose numbers lie in `range`.
    pub fn clear(&mut self, range: std::ops::RangeInclusive<u32>) {
        for (number, cell) in (0u32..).zip(&mut self.flat) {
            if range.contains(&number) {
                *cell = f64::NAN;
            }
        }
        self.more.retain(|number, _| !range.contains(number));
    }

    /// The value of a variable that has a name; none where it was never set.
    pub fn named(&self, name: &str) -> Option<f64> {
        self.named.get(name).copied()
    }

    /// Sets a variable that has a name; none, or a value that is no number, forgets it.
    pub fn set_named(&mut self, name: &str, value: Option<f64>) -> Result<(), VariableError> {
        put(&mut self.named, name.into(), value.filter(|v| !v.is_nan()))
    }

    /// The variables that have a name, in order.
    pub fn iter_named(&self) -> impl Iterator<Item = (&str, f64)> {
        self.named.iter().map(|(name, value)| (&**name, *value))
    }

    /// Gives values of names to the numbers that they are kept by, where `number` knows them.
    pub fn name_numbers(&mut self, number: impl Fn(&str) -> Option<u32>) {
        let named: Vec<(u32, f64)> =
            self.named.iter().filter_map(|(name, value)| Some((number(name)?, *value))).collect();
        for (number, value) in named {
            // There are no more of them than names.
            let _ = self.set(number, Some(value));
        }
    }

    /// The numbered variables that hold a value, in order.
    pub fn iter(&self) -> impl Iterator<Item = (u32, f64)> {
        let flat = (0u32..).zip(self.flat.iter().copied()).filter(|(_, value)| !value.is_nan());
        flat.chain(self.more.iter().map(|(number, value)| (*number, *value)))
    }
}

fn put<K: Ord>(map: &mut BTreeMap<K, f64>, key: K, value: Option<f64>) -> Result<(), VariableError> {
    match value {
        None => {
            map.remove(&key);
            Ok(())
        }
        Some(_) if map.len() >= LARGEST_REST && !map.contains_key(&key) => Err(VariableError::Full),
        Some(value) => {
            map.insert(key, value);
            Ok(())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn empty_is_not_zero() {
        let mut v = Variables::new();
        for number in [1, 999, 1000, 1_000_000] {
            assert_eq!(v.get(number), None);
            v.set(number, Some(0.0)).unwrap();
            assert_eq!(v.get(number), Some(0.0));
            v.set(number, Some(f64::NAN)).unwrap();
            assert_eq!(v.get(number), None);
        }
        assert_eq!(v.set(0, Some(1.0)), Err(VariableError::Null));
        assert_eq!(v.get(0), None);
    }

    #[test]
    fn a_range_can_be_emptied() {
        let mut v = Variables::new();
        for number in [50, 100, 199, 200, 1500, 2000] {
            v.set(number, Some(1.0)).unwrap();
        }
        v.clear(100..=199);
        v.clear(1000..=1999);
        assert_eq!(v.iter().map(|(n, _)| n).collect::<Vec<_>>(), [50, 200, 2000]);
    }

    #[test]
    fn variables_cannot_fill_the_memory() {
        let mut v = Variables::new();
        let first = 10_000;
        let last = first + u32::try_from(LARGEST_REST).unwrap();
        for number in first..last {
            v.set(number, Some(1.0)).unwrap();
        }
        assert_eq!(v.set(last, Some(1.0)), Err(VariableError::Full));
        assert_eq!(v.set(last - 1, Some(2.0)), Ok(()));
        assert_eq!(v.get(last), None);
    }

    #[test]
    fn offsets_and_their_parameters_are_one_value() {
        let mut memory = Memory::new("gsk990mc");
        let key = |number| ParameterKey::Data(number);
        memory.set_parameter(&key(12), 1.5).unwrap();
        memory.set_parameter(&key(43), 90.0).unwrap();
        memory.set_parameter(&key(60), -7.0).unwrap();
        assert_eq!(memory.work.external, Position::xyz(0.0, 0.0, 1.5));
        assert_eq!(memory.work.standard[5][Axis::A], 90.0);
        assert_eq!(memory.reference_points[3][Axis::X], -7.0);
        memory.work.standard[0][Axis::Y] = 4.0;
        assert_eq!(memory.parameter(&key(16)), 4.0);
        assert_eq!(memory.parameter(&key(270)), 2.0);
        assert!(memory.set_parameter(&key(12), 1e6).is_err());
        // Elsewhere P12 is a parameter like others.
        let mut memory = Memory::new("rs274");
        memory.set_parameter(&key(12), 1.5).unwrap();
        assert_eq!(memory.work.external, Position::ZERO);
        assert_eq!(memory.parameter(&key(12)), 1.5);
    }
}
