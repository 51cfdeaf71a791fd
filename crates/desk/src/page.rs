//! An explanation as data, and how it reads in a terminal and as JSON.

use crate::layout::{padded, width, wrapped};
use ferrocut_machine::{Catalogue, Meaning, ParameterDef};
use serde_json::{Map, Value, json};

/// Columns of an explanation.
const COLUMNS: usize = 100;

/// What is known of one thing.
pub struct Page {
    /// What kind of thing: `g-code`, `parameter` …
    pub kind: &'static str,
    /// Its name as it is written.
    pub name: String,
    /// What it is, in a few words.
    pub title: String,
    /// What is to say of it, by the key of JSON and of the label.
    pub facts: Vec<Fact>,
    /// Lists of further things, by key: name and text.
    pub lists: Vec<(&'static str, Vec<(String, String)>)>,
    /// The parameters that bear on it, with their values.
    pub parameters: Vec<(&'static ParameterDef, f64)>,
}

/// One thing to say.
pub struct Fact {
    key: &'static str,
    /// For people; none where it is for programs only.
    text: Option<String>,
    json: Value,
}

impl Page {
    /// A page without facts.
    pub fn new(kind: &'static str, name: impl Into<String>, title: impl Into<String>) -> Page {
        let (facts, lists, parameters) = (Vec::new(), Vec::new(), Vec::new());
        Page { kind, name: name.into(), title: title.into(), facts, lists, parameters }
    }

    /// Adds a text, for people and programs; an empty one is left out.
    pub fn say(&mut self, key: &'static str, text: impl Into<String>) {
        let text = text.into();
        if !text.is_empty() {
            self.facts.push(Fact { key, json: Value::from(text.clone()), text: Some(text) });
        }
    }

    /// Adds something that reads otherwise for programs.
    pub fn tell(&mut self, key: &'static str, text: impl Into<String>, json: impl Into<Value>) {
        self.facts.push(Fact { key, text: Some(text.into()), json: json.into() });
    }

    /// Adds something for programs only.
    pub fn note(&mut self, key: &'static str, json: impl Into<Value>) {
        self.facts.push(Fact { key, text: None, json: json.into() });
    }

    /// Adds a list; an empty one is left out.
    pub fn list(&mut self, key: &'static str, rows: Vec<(String, String)>) {
        if !rows.is_empty() {
            self.lists.push((key, rows));
        }
    }

    /// As one object.
    pub fn json(&self, catalogue: Catalogue) -> Value {
        let mut object = Map::new();
        object.insert("kind".into(), self.kind.into());
        object.insert("name".into(), self.name.clone().into());
        object.insert("title".into(), self.title.clone().into());
        for fact in &self.facts {
            object.insert(fact.key.into(), fact.json.clone());
        }
        for (key, rows) in &self.lists {
            let rows: Vec<Value> = rows.iter().map(|(n, t)| json!({ "name": n, "text": t })).collect();
            object.insert((*key).into(), rows.into());
        }
        if !self.parameters.is_empty() {
            let of = |(d, v): &(&ParameterDef, f64)| parameter_json(d, *v, catalogue);
            let rows: Vec<Value> = self.parameters.iter().map(of).collect();
            object.insert("parameters".into(), rows.into());
        }
        Value::Object(object)
    }

    /// What is to say to people, with its labels.
    pub fn facts_told(&self, catalogue: Catalogue) -> Vec<(String, String)> {
        let told = |f: &Fact| Some((labelled(f.key, catalogue), f.text.clone()?));
        self.facts.iter().filter_map(told).collect()
    }

    /// Its tables for people: the label of each, and its rows of two or three cells.
    pub fn tables_told(&self, catalogue: Catalogue) -> Vec<(String, Vec<Vec<String>>)> {
        let parameters = families(&self.parameters, catalogue);
        let parameters: Vec<_> =
            parameters.into_iter().map(|(name, value, text)| vec![name, value, text]).collect();
        let parameters = (!parameters.is_empty()).then(|| (labelled("parameters", catalogue), parameters));
        let of = |rows: &[(String, String)]| {
            rows.iter().map(|(name, text)| vec![name.clone(), text.clone()]).collect()
        };
        let lists = self.lists.iter().map(|(key, rows)| (labelled(key, catalogue), of(rows)));
        parameters.into_iter().chain(lists).collect()
    }

    /// As lines for people.
    pub fn text(&self, catalogue: Catalogue) -> String {
        let mut lines = hanging(&format!("{}  ", self.name), &self.title);
        let facts = self.facts_told(catalogue);
        let widest = facts.iter().map(|(name, _)| width(name)).max().unwrap_or(0);
        for (name, text) in facts {
            lines.extend(hanging(&format!("  {}  ", padded(&name, widest)), &text));
        }
        for (label, rows) in self.tables_told(catalogue) {
            lines.push(format!("  {label}"));
            let widest =
                |at: usize| rows.iter().filter_map(|row| row.get(at)).map(|c| width(c)).max().unwrap_or(0);
            for row in &rows {
                let Some((text, cells)) = row.split_last() else { continue };
                let cells = cells.iter().enumerate().map(|(at, cell)| padded(cell, widest(at)) + "  ");
                lines.extend(hanging(&format!("    {}", cells.collect::<String>()), text));
            }
        }
        lines.iter().map(|line| format!("{}\n", line.trim_end())).collect()
    }
}

/// What is before a fact or above a table.
fn labelled(key: &str, catalogue: Catalogue) -> String {
    catalogue.label(&format!("label-explain-{key}"), &[])
}

/// A text behind a head, its further lines under its first.
fn hanging(head: &str, text: &str) -> Vec<String> {
    let indent = width(head);
    let room = COLUMNS.saturating_sub(indent).max(30);
    let lines = wrapped(text, room).into_iter().enumerate();
    lines
        .map(|(at, line)| if at == 0 { format!("{head}{line}") } else { " ".repeat(indent) + &line })
        .collect()
}

/// What a parameter says, in one line.
pub fn meaning(definition: &ParameterDef, catalogue: Catalogue) -> String {
    let of = |text| catalogue.of_reference(text);
    match &definition.meaning {
        Meaning::Value(text) => of(text).to_owned(),
        Meaning::Bit { one, zero } => format!("1: {}; 0: {}", of(one), of(zero)),
    }
}

/// A value with its unit.
pub fn with_unit(value: f64, definition: &ParameterDef) -> String {
    in_unit(&value.to_string(), definition)
}

/// A number, or a range of numbers, with the unit of a parameter, which may be so many of another.
pub fn in_unit(number: &str, definition: &ParameterDef) -> String {
    let unit = &*definition.unit;
    let times = if unit.starts_with(|c: char| c.is_ascii_digit()) { "× " } else { "" };
    format!("{number} {times}{unit}").trim_end().to_owned()
}

/// The value of a parameter, and its default where that is another.
pub fn value_text(definition: &ParameterDef, value: f64, catalogue: Catalogue) -> String {
    let text = with_unit(value, definition);
    match value == definition.default {
        true => text,
        false => {
            let arguments = [("value", text.into()), ("default", definition.default.to_string().into())];
            catalogue.label("label-value-changed", &arguments)
        }
    }
}

/// A parameter as an object.
pub fn parameter_json(definition: &ParameterDef, value: f64, catalogue: Catalogue) -> Value {
    let mut object = json!({
        "name": definition.name,
        "symbol": definition.symbol,
        "value": value,
        "default": definition.default,
        "changed": value != definition.default,
        "min": definition.min,
        "max": definition.max,
        "unit": definition.unit,
        "axis": definition.axis,
        "room": definition.applies_to,
        "used": definition.used,
        "meaning": meaning(definition, catalogue),
    });
    if let (Value::Object(fields), Meaning::Bit { one, zero }) = (&mut object, &definition.meaning) {
        fields.insert("one".into(), catalogue.of_reference(one).into());
        fields.insert("zero".into(), catalogue.of_reference(zero).into());
    }
    object
}

/// Parameters as rows of name, value, meaning. Neighbours that differ in the number of their axis or
/// gear alone are one row.
fn families(parameters: &[(&ParameterDef, f64)], catalogue: Catalogue) -> Vec<(String, String, String)> {
    let mut rows: Vec<(String, String, String)> = Vec::new();
    let mut rest = parameters;
    while let Some(((first, value), behind)) = rest.split_first() {
        let member = numbered(first);
        let same = behind.iter().enumerate().take_while(|(at, (other, v))| {
            let Some((before, number, after)) = member else { return false };
            numbered(other) == Some((before, number + at + 1, after))
                && (&other.unit, other.default, v) == (&first.unit, first.default, value)
        });
        let count = same.count();
        let last = behind.get(..count).and_then(<[_]>::last);
        let value = value_text(first, *value, catalogue);
        rows.push(match (last, member) {
            (Some((last, _)), Some((before, number, _))) => {
                let name = format!("{}-{}", first.name, last.name);
                let run = runs_of_digits(before).filter(|run| run.1 == number.to_string()).count();
                (name, value, up_to(&meaning(first, catalogue), number, run, number + count))
            }
            _ => (first.name.to_string(), value, meaning(first, catalogue)),
        });
        rest = behind.get(count..).unwrap_or(&[]);
    }
    rows
}

/// Where there are digits in a text, and which.
fn runs_of_digits(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let starts = text.match_indices(|c: char| c.is_ascii_digit()).map(|(at, _)| at);
    let starts = starts.filter(|at| !text[..*at].ends_with(|c: char| c.is_ascii_digit()));
    starts.map(|at| {
        let end = text[at..].find(|c: char| !c.is_ascii_digit()).map_or(text.len(), |len| at + len);
        (at, &text[at..end])
    })
}

/// A text with `number-last` in place of `number`, where that stands for the time `run`, counted from 0.
fn up_to(text: &str, number: usize, run: usize, last: usize) -> String {
    let number = number.to_string();
    match runs_of_digits(text).filter(|found| found.1 == number).nth(run) {
        Some((at, _)) => {
            let (before, after) = text.split_at(at + number.len());
            format!("{before}-{last}{after}")
        }
        None => text.to_owned(),
    }
}

/// What stands before and behind the number of an axis or gear in the meaning of a number.
fn numbered(definition: &ParameterDef) -> Option<(&str, usize, &str)> {
    let Meaning::Value(text) = &definition.meaning else { return None };
    let ends = ["axis ", "gear "].into_iter().flat_map(|word| text.match_indices(word));
    let mut ends = ends.map(|(at, word)| at + word.len());
    let at = ends.find(|at| text.as_bytes().get(*at).is_some_and(u8::is_ascii_digit))?;
    let (before, rest) = text.split_at_checked(at)?;
    let end = rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len());
    let (number, after) = rest.split_at_checked(end)?;
    Some((before, number.parse().ok()?, after))
}
