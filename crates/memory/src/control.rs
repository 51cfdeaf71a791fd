//! Between the durable memory and that of the running control ([`ferrocut_machine::Memory`]), which the
//! interpreter reads: a plain copy, both ways.

use crate::items::{Change, Contents, Item};
use ferrocut_geometry::{Axis, Position};
use ferrocut_machine::setup::VariableName;
use ferrocut_machine::{Memory, ToolOffset, ToolTable, WorkOffset};
use std::collections::BTreeSet;

/// The items that [`enter`] needs.
pub const ENTERED: [Item; 5] =
    [Item::Parameters, Item::Offsets, Item::WorkZeros, Item::ReferencePoints, Item::Variables];

/// Enters what was kept into the memory of a control as delivered. Says what the control does not take: values of
/// a table that is smaller, or of a parameter whose range is another in this version.
pub fn enter(contents: &Contents, memory: &mut Memory) -> Vec<String> {
    let mut refused = Vec::new();
    let parameters = contents.parameters.iter().map(|(key, value)| (key, *value));
    // One that is refused must not keep the others out; the names of the axes go first within.
    for pair in in_order(parameters) {
        if let Err(error) = memory.set_parameter(pair.0, pair.1) {
            refused.push(error.to_string());
        }
    }
    for (name, zero) in &contents.work_zeros {
        match memory.work.get_mut(*name) {
            Some(place) => *place = *zero,
            None => refused.push(name.to_string()),
        }
    }
    for (number, offset) in &contents.offsets {
        match memory.tools.get_mut(*number) {
            Some(row) => *row = *offset,
            None => refused.push(format!("offset {number}")),
        }
    }
    for (number, point) in &contents.reference_points {
        match usize::from(*number).checked_sub(1).and_then(|n| memory.reference_points.get_mut(n)) {
            Some(place) => *place = *point,
            None => refused.push(format!("reference point {number}")),
        }
    }
    for (name, value) in &contents.variables {
        let set = match name {
            // Typed by hand it was written down as all that is; with the power it goes.
            VariableName::Number(number) if !memory.keeps_variable(*number) => Ok(()),
            VariableName::Number(number) => memory.variables.set(*number, Some(*value)),
            VariableName::Named(name) => memory.variables.set_named(name, Some(*value)),
        };
        if let Err(error) = set {
            refused.push(error.to_string());
        }
    }
    refused
}

fn in_order<'a>(
    parameters: impl Iterator<Item = (&'a ferrocut_machine::ParameterKey, f64)> + Clone,
) -> impl Iterator<Item = (&'a ferrocut_machine::ParameterKey, f64)> {
    use ferrocut_machine::ParameterKey;
    // As `Memory::set_parameters` has it: P5 and P175 to P179 name the axes that others belong to.
    let names_axis = |key: &ParameterKey| matches!(key, ParameterKey::Data(5 | 175..=179));
    let first = parameters.clone().filter(move |(key, _)| names_axis(key));
    first.chain(parameters.filter(move |(key, _)| !names_axis(key)))
}

/// The changes that make what is kept of `before` into what is kept of `after`.
pub fn changes(before: &Memory, after: &Memory) -> Vec<Change> {
    let mut changes = Vec::new();
    let keys: BTreeSet<_> =
        before.parameters.given().chain(after.parameters.given()).map(|(key, _)| key).collect();
    for key in keys {
        // What is another name of a zero is kept as the zero.
        let value = after.parameters.get(key);
        if after.place(key).is_none() && before.parameters.get(key) != value {
            changes.push(Change::Parameter { key: key.clone(), value: Some(value) });
        }
    }
    let used: BTreeSet<u16> =
        before.tools.used().chain(after.tools.used()).map(|(number, _)| number).collect();
    for number in used.into_iter().filter(|number| (1..=ToolTable::LARGEST).contains(number)) {
        let row = |memory: &Memory| memory.tools.get(number).copied().unwrap_or(ToolOffset::ZERO);
        if row(before) != row(after) {
            changes.push(Change::Offset { number, offset: row(after) });
        }
    }
    let systems = u16::try_from(after.work.additional.len()).unwrap_or(u16::MAX);
    let names = [WorkOffset::External].into_iter();
    let names =
        names.chain((1..=6).map(WorkOffset::Standard)).chain((1..=systems).map(WorkOffset::Additional));
    for name in names {
        let zero = |memory: &Memory| memory.work.get(name).unwrap_or(Position::ZERO);
        if !same(zero(before), zero(after)) {
            changes.push(Change::WorkZero { name, zero: zero(after) });
        }
    }
    let points = before.reference_points.iter().zip(&after.reference_points);
    for (number, (old, new)) in (1u8..).zip(points) {
        if !same(*old, *new) {
            changes.push(Change::ReferencePoint { number, position: *new });
        }
    }
    let numbers: BTreeSet<u32> = before
        .variables
        .iter()
        .chain(after.variables.iter())
        .map(|(number, _)| number)
        .filter(|number| after.keeps_variable(*number))
        .collect();
    for number in numbers {
        let value = after.variables.get(number);
        if before.variables.get(number) != value {
            changes.push(Change::Variable { name: VariableName::Number(number), value });
        }
    }
    changes
}

fn same(a: Position, b: Position) -> bool {
    Axis::ALL.into_iter().all(|axis| a[axis] == b[axis])
}
