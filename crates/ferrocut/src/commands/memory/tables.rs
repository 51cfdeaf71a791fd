//! Items as rows with named columns, for people and for programs.

use super::utc;
use crate::commands::layout::table;
use crate::diagnostics::Diagnostics;
use ferrocut_geometry::{Axis, Position};
use ferrocut_machine::setup::VariableName;
use ferrocut_memory::{Contents, Item, Level, PlcArea};
use serde_json::{Value, json};

/// A row: columns with their values.
pub type Row = Vec<(&'static str, Value)>;

/// Bytes of the ladder in a row.
const BYTES: usize = 16;

/// The zero of the work coordinate system that G92 made, by axis.
const ZERO_NAMES: [&str; 9] =
    ["zero_x", "zero_y", "zero_z", "zero_a", "zero_b", "zero_c", "zero_u", "zero_v", "zero_w"];

/// The rows of an item.
pub fn rows(contents: &Contents, item: Item, diagnostics: &Diagnostics) -> Vec<Row> {
    match item {
        Item::Programs => contents
            .programs
            .iter()
            .map(|(name, program)| {
                vec![
                    ("name", name.as_str().into()),
                    ("bytes", program.text.len().into()),
                    ("changed", utc(program.changed).into()),
                    ("locked", level(program.locked)),
                    ("comment", program.comment.as_str().into()),
                ]
            })
            .collect(),
        Item::Parameters => {
            let row = |(key, value): (&ferrocut_machine::ParameterKey, &f64)| {
                vec![("name", key.to_string().into()), ("value", (*value).into())]
            };
            contents.parameters.iter().map(row).collect()
        }
        Item::Offsets => contents
            .offsets
            .iter()
            .map(|(number, offset)| {
                vec![
                    ("number", (*number).into()),
                    ("length", offset.length.into()),
                    ("length_wear", offset.length_wear.into()),
                    ("radius", offset.radius.into()),
                    ("radius_wear", offset.radius_wear.into()),
                    ("cutting_length", offset.cutting_length.into()),
                    ("entry_angle", offset.entry_angle.into()),
                    ("tip_radius", offset.tip_radius.into()),
                ]
            })
            .collect(),
        Item::WorkZeros => contents
            .work_zeros
            .iter()
            .map(|(name, zero)| on_axes(("name", name.to_string().into()), zero))
            .collect(),
        Item::ReferencePoints => contents
            .reference_points
            .iter()
            .map(|(number, point)| on_axes(("number", (*number).into()), point))
            .collect(),
        Item::Variables => {
            let name = |name: &VariableName| match name {
                VariableName::Number(number) => format!("#{number}"),
                VariableName::Named(name) => name.to_string(),
            };
            let row = |(key, value): (&VariableName, &f64)| {
                vec![("name", name(key).into()), ("value", (*value).into())]
            };
            contents.variables.iter().map(row).collect()
        }
        Item::Pitch => {
            let row = |((axis, point), value): (&(Axis, u16), &f64)| {
                vec![("axis", axis.name().into()), ("point", (*point).into()), ("value", (*value).into())]
            };
            contents.pitch.iter().map(row).collect()
        }
        Item::Plc => contents.plc.iter().flat_map(|(area, bytes)| signals(*area, bytes)).collect(),
        Item::Counters => {
            let row = |(counter, value): (&ferrocut_memory::Counter, &f64)| {
                vec![("name", counter.name().into()), ("value", (*value).into())]
            };
            contents.counters.iter().map(row).collect()
        }
        Item::Alarms => contents
            .alarms
            .iter()
            .map(|alarm| {
                let text = alarm.alarm_id().and_then(|id| diagnostics.catalogue().text(id));
                let values: Vec<String> =
                    alarm.arguments.iter().map(|(name, v)| format!("{name}={v}")).collect();
                vec![
                    ("time", utc(alarm.time).into()),
                    ("alarm", alarm.id.as_str().into()),
                    ("program", alarm.program.as_str().into()),
                    ("line", alarm.line.into()),
                    ("values", values.join(" ").into()),
                    ("message", text.into()),
                ]
            })
            .collect(),
        Item::Log => contents
            .log
            .iter()
            .map(|entry| {
                vec![
                    ("time", utc(entry.time).into()),
                    ("level", level(entry.level)),
                    ("who", entry.who.as_str().into()),
                    ("kind", entry.item.as_str().into()),
                    ("name", entry.name.as_str().into()),
                    ("from", entry.from.as_str().into()),
                    ("to", entry.to.as_str().into()),
                ]
            })
            .collect(),
        Item::LastPosition => contents
            .last_position
            .iter()
            .map(|last| {
                let referenced: String = last.referenced.iter().map(Axis::letter).collect();
                let mut row = on_axes(("time", utc(last.time).into()), &last.position);
                row.push(("referenced", referenced.into()));
                row.push(("work_system", last.work_system.map(|s| s.to_string()).into()));
                let zero = |axis| last.own_zero.map(|zero| zero[axis]);
                row.extend(
                    ZERO_NAMES.into_iter().zip(Axis::ALL).map(|(name, axis)| (name, zero(axis).into())),
                );
                row
            })
            .collect(),
        Item::Interrupted => contents
            .interrupted
            .iter()
            .map(|run| {
                let mut row: Row = vec![
                    ("time", utc(run.time).into()),
                    ("program", run.program.as_str().into()),
                    ("from_line", run.from_line.into()),
                    ("file", run.file.as_str().into()),
                    ("line", run.line.into()),
                    ("block", run.block.into()),
                    ("text", run.text.as_str().into()),
                ];
                let place = run.at.iter().flat_map(|at| Axis::ALL.map(|axis| (axis.name(), at[axis].into())));
                row.extend(place);
                row
            })
            .collect(),
        Item::Ladder => {
            let row = |text: &String| {
                let lines: Vec<&str> = text.lines().collect();
                let head = lines.iter().find(|line| !line.trim().is_empty()).copied().unwrap_or_default();
                vec![
                    ("bytes", text.len().into()),
                    ("lines", lines.len().into()),
                    ("head", head.trim().chars().take(60).collect::<String>().into()),
                ]
            };
            contents.ladder.iter().map(row).collect()
        }
    }
}

fn level(level: Option<Level>) -> Value {
    level.map(Level::number).into()
}

fn on_axes(first: (&'static str, Value), position: &Position) -> Row {
    let axes = Axis::ALL.into_iter().map(|axis| (axis.name(), position[axis].into()));
    std::iter::once(first).chain(axes).collect()
}

fn signals(area: PlcArea, bytes: &[u8]) -> Vec<Row> {
    let lines = (0..).step_by(BYTES).zip(bytes.chunks(BYTES));
    lines
        .filter(|(_, line)| line.iter().any(|byte| *byte != 0))
        .map(|(first, line): (usize, &[u8])| {
            let hex: Vec<String> = line.iter().map(|byte| format!("{byte:02X}")).collect();
            vec![("first", json!(format!("{}{first}", area.name()))), ("bytes", hex.join(" ").into())]
        })
        .collect()
}

/// Rows under their columns. Columns of axes that are 0 throughout are left out.
pub fn text(rows: &[Row]) -> String {
    let Some(first) = rows.first() else { return String::new() };
    let is_axis = |name: &str| Axis::ALL.iter().any(|axis| axis.name() == name);
    let shown: Vec<usize> = (0..first.len())
        .filter(|column| {
            let is_zero = |row: &Row| row.get(*column).is_none_or(|(_, value)| value.as_f64() == Some(0.0));
            let name = first.get(*column).map_or("", |(name, _)| name);
            !is_axis(name) || !rows.iter().all(is_zero)
        })
        .collect();
    let cell = |value: &Value| match value {
        Value::Null => String::new(),
        Value::String(text) => text.clone(),
        // As it is entered: 5 and not 5.0.
        Value::Number(number) => number.as_f64().map_or(number.to_string(), |number| number.to_string()),
        other => other.to_string(),
    };
    let line = |row: &Row, of: &dyn Fn(&(&'static str, Value)) -> String| -> Vec<String> {
        let cells = shown.iter().filter_map(|column| row.get(*column).map(of));
        std::iter::once(String::new()).chain(cells).collect()
    };
    let head = line(first, &|(name, _)| (*name).to_owned());
    let body = rows.iter().map(|row| line(row, &|(_, value)| cell(value)));
    table(&std::iter::once(head).chain(body).collect::<Vec<_>>())
}
