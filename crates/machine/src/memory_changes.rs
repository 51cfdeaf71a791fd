//! What differs between two states of a control's memory, value by value.

use crate::memory::Memory;
use crate::offsets::{ToolOffset, WorkOffset};
use crate::parameters::ParameterKey;
use crate::tool_library::{Tool, ToolLibrary};
use ferrocut_geometry::Position;
use std::collections::{BTreeMap, BTreeSet};

/// A value of the memory, and what it became.
#[derive(Clone, PartialEq, Debug)]
pub enum MemoryChange {
    /// A parameter, in the unit of the control's list.
    Parameter(ParameterKey, f64),
    /// A parameter that is as delivered again, and the value of that.
    AsDelivered(ParameterKey, f64),
    /// A row of the tool offset table.
    ToolOffset(u16, ToolOffset),
    /// A tool of the library; none where it was taken out.
    Tool(u32, Option<Tool>),
    /// The zero of a work coordinate system, mm and degrees.
    WorkOffset(WorkOffset, Position),
    /// A numbered variable; none where it was emptied.
    Variable(u32, Option<f64>),
    /// A variable with a name.
    Named(Box<str>, Option<f64>),
    /// A reference point, counted from 0, mm and degrees.
    ReferencePoint(usize, Position),
}

impl MemoryChange {
    /// Whether both are of the same value.
    pub fn is_of(&self, other: &MemoryChange) -> bool {
        if let (Some(one), Some(other)) = (self.parameter(), other.parameter()) {
            return one == other;
        }
        match (self, other) {
            (MemoryChange::ToolOffset(one, _), MemoryChange::ToolOffset(other, _)) => one == other,
            (MemoryChange::Tool(one, _), MemoryChange::Tool(other, _)) => one == other,
            (MemoryChange::WorkOffset(one, _), MemoryChange::WorkOffset(other, _)) => one == other,
            (MemoryChange::Variable(one, _), MemoryChange::Variable(other, _)) => one == other,
            (MemoryChange::Named(one, _), MemoryChange::Named(other, _)) => one == other,
            (MemoryChange::ReferencePoint(one, _), MemoryChange::ReferencePoint(other, _)) => one == other,
            _ => false,
        }
    }

    fn parameter(&self) -> Option<&ParameterKey> {
        match self {
            MemoryChange::Parameter(key, _) | MemoryChange::AsDelivered(key, _) => Some(key),
            _ => None,
        }
    }
}

impl Memory {
    /// What must be changed so that this memory becomes `other`.
    pub fn changes_to(&self, other: &Memory) -> Vec<MemoryChange> {
        let mut changes = Vec::new();
        self.parameter_changes(other, &mut changes);
        self.offset_changes(other, &mut changes);
        for (number, (was, is)) in self.reference_points.iter().zip(&other.reference_points).enumerate() {
            if was != is {
                changes.push(MemoryChange::ReferencePoint(number, *is));
            }
        }
        let (was, is): (BTreeMap<_, _>, BTreeMap<_, _>) =
            (self.variables.iter().collect(), other.variables.iter().collect());
        let numbers: BTreeSet<u32> = was.keys().chain(is.keys()).copied().collect();
        for number in numbers.into_iter().filter(|number| was.get(number) != is.get(number)) {
            changes.push(MemoryChange::Variable(number, is.get(&number).copied()));
        }
        let (was, is): (BTreeMap<_, _>, BTreeMap<_, _>) =
            (self.variables.iter_named().collect(), other.variables.iter_named().collect());
        let names: BTreeSet<&str> = was.keys().chain(is.keys()).copied().collect();
        for name in names.into_iter().filter(|name| was.get(name) != is.get(name)) {
            changes.push(MemoryChange::Named(name.into(), is.get(name).copied()));
        }
        changes
    }

    fn parameter_changes(&self, other: &Memory, changes: &mut Vec<MemoryChange>) {
        let keys: BTreeSet<&ParameterKey> =
            self.parameters.given().chain(other.parameters.given()).map(|(key, _)| key).collect();
        // Other names of offsets and reference points are told as those.
        for key in keys.into_iter().filter(|key| self.place(key).is_none()) {
            let value = other.parameters.get(key);
            if self.parameters.get(key) != value {
                changes.push(MemoryChange::Parameter(key.clone(), value));
            }
        }
    }

    fn offset_changes(&self, other: &Memory, changes: &mut Vec<MemoryChange>) {
        let rows: BTreeSet<u16> = self.tools.used().chain(other.tools.used()).map(|(row, _)| row).collect();
        for row in rows {
            if let (was, Some(is)) = (self.tools.get(row), other.tools.get(row))
                && was != Some(is)
            {
                changes.push(MemoryChange::ToolOffset(row, *is));
            }
        }
        let tools = |memory: &Memory| -> BTreeMap<u32, Tool> {
            memory.library.iter().flat_map(ToolLibrary::iter).map(|(number, tool)| (number, *tool)).collect()
        };
        let (was, is) = (tools(self), tools(other));
        let numbers: BTreeSet<u32> = was.keys().chain(is.keys()).copied().collect();
        for number in numbers.into_iter().filter(|number| was.get(number) != is.get(number)) {
            changes.push(MemoryChange::Tool(number, is.get(&number).copied()));
        }
        let additional = (1..).zip(&other.work.additional).map(|(n, _)| WorkOffset::Additional(n));
        let standard = (1..=6).map(WorkOffset::Standard);
        for name in std::iter::once(WorkOffset::External).chain(standard).chain(additional) {
            if let (was, Some(is)) = (self.work.get(name), other.work.get(name))
                && was != Some(is)
            {
                changes.push(MemoryChange::WorkOffset(name, is));
            }
        }
    }

    /// Makes a change. One that this memory has no room for is left out.
    pub fn make_change(&mut self, change: &MemoryChange) {
        match change {
            MemoryChange::Parameter(key, value) => drop(self.set_parameter(key, *value)),
            MemoryChange::AsDelivered(key, value) => {
                if self.set_parameter(key, *value).is_ok() {
                    self.parameters.take_back(key, *value);
                }
            }
            MemoryChange::ToolOffset(row, value) => {
                if let Some(row) = self.tools.get_mut(*row) {
                    *row = *value;
                }
            }
            MemoryChange::Tool(number, tool) => {
                if let Some(library) = &mut self.library {
                    library.put(*number, *tool);
                }
            }
            MemoryChange::WorkOffset(name, zero) => {
                if let Some(place) = self.work.get_mut(*name) {
                    *place = *zero;
                }
            }
            MemoryChange::Variable(number, value) => drop(self.variables.set(*number, *value)),
            MemoryChange::Named(name, value) => drop(self.variables.set_named(name, *value)),
            MemoryChange::ReferencePoint(number, at) => {
                if let Some(point) = self.reference_points.get_mut(*number) {
                    *point = *at;
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ferrocut_geometry::Axis;

    #[test]
    fn changes_made_to_the_one_give_the_other() {
        let was = Memory::new("gsk990mc");
        let mut is = was.clone();
        is.set_parameter(&ParameterKey::Data(86), 1234.0).unwrap();
        is.set_parameter(&ParameterKey::Data(60), -7.0).unwrap();
        is.tools.get_mut(3).unwrap().radius_wear = -0.02;
        is.work.standard[1][Axis::Y] = 12.5;
        is.work.additional[49][Axis::Z] = -1.0;
        is.variables.set(500, Some(0.0)).unwrap();
        is.variables.set(1_000_000, Some(3.0)).unwrap();
        is.variables.set_named("depth", Some(2.0)).unwrap();
        let changes = was.changes_to(&is);
        assert_eq!(changes.len(), 8);
        assert!(changes.contains(&MemoryChange::Variable(500, Some(0.0))));
        assert!(changes.contains(&MemoryChange::ReferencePoint(3, is.reference_points[3])));
        let mut copy = was.clone();
        changes.iter().for_each(|change| copy.make_change(change));
        assert_eq!(copy.changes_to(&is), []);
        // And back: what was set is emptied again.
        is.changes_to(&was).iter().for_each(|change| copy.make_change(change));
        assert_eq!(copy.changes_to(&was), []);
        assert_eq!(copy.variables.get(500), None);
    }

    #[test]
    fn tools_of_a_library_come_and_go() {
        let mut was = Memory::new("rs274");
        was.library = Some(ToolLibrary::from_tbl("T1 P1 D6 Z50\nT2 P2 D8 Z60\n").unwrap());
        let mut is = was.clone();
        is.library = Some(ToolLibrary::from_tbl("T2 P2 D8 Z61\nT3 P3 D9\n").unwrap());
        let changes = was.changes_to(&is);
        assert_eq!(changes.len(), 3);
        changes.iter().for_each(|change| was.make_change(change));
        assert_eq!(was.library, is.library);
    }
}
