//! What the control's tables say: codes, parameters, alarms, signals, and one search through all of them. The same as
//! `ferrocut explain` has.

use super::Shared;
use super::problem::Problem;
use super::query::{Spoken, catalogue};
use axum::extract::{Query, State};
use axum::routing::get;
use axum::{Json, Router};
use ferrocut_controller::diagnosis::entries;
use ferrocut_desk::page::meaning;
use ferrocut_desk::{Book, asked, memory_of};
use ferrocut_interpreter::{Dialect, dialects};
use ferrocut_machine::{
    AlarmId, Catalogue, Fault, Machine, Meaning, ParameterKey, ParameterTable, Reference, alarm_table,
    g_code_name,
};
use ferrocut_memory::rights::needed_for_parameter;
use ferrocut_plc::{Area, Program};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Longest thing that is asked for, bytes.
const LONGEST: usize = 256;

/// Values of an alarm.
const MOST_VALUES: usize = 32;

/// What a search finds at most.
const MOST_FOUND: usize = 100;

/// Areas of signals that people look at.
const AREAS: [Area; 9] = [Area::X, Area::Y, Area::F, Area::G, Area::A, Area::K, Area::T, Area::C, Area::D];

pub(super) fn routes() -> Router<Arc<Shared>> {
    Router::new()
        .route("/api/alarm", get(alarm))
        .route("/api/explain", get(explain))
        .route("/api/words", get(words))
        .route("/api/parameters", get(parameters))
        .route("/api/signals", get(signals))
        .route("/api/search", get(search))
        .route("/api/list", get(list))
}

fn book(machine: &Machine, dialect: &'static Dialect, texts: Catalogue) -> Book {
    Book::new(dialect, memory_of(machine, dialect).0, texts)
}

fn short(text: String) -> Result<String, Problem> {
    if text.len() <= LONGEST { Ok(text) } else { Err(Problem::TooLarge) }
}

#[derive(Deserialize)]
struct AskedAlarm {
    id: String,
    values: Option<String>,
    language: Option<String>,
}

/// The number of an alarm as it is written, with the rules that it may stand for.
fn alarm_id(text: &str) -> Option<(AlarmId, Vec<Fault>)> {
    if let Some(number) = text.strip_prefix("FC-") {
        let number: u16 = number.parse().ok()?;
        let fault = Fault::ALL.iter().find(|fault| **fault as u16 == number)?;
        return Some((AlarmId::Core(*fault), Vec::new()));
    }
    let (dialect, number) = text.split_once(':')?;
    let dialect = dialects::by_name(dialect)?;
    let number: u16 = number.parse().ok()?;
    let faults = dialect.alarms.iter().filter(|(_, own)| *own == number).map(|(fault, _)| *fault);
    Some((AlarmId::Dialect(dialect.name, number), faults.collect()))
}

/// An alarm in words.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(super) struct AlarmText {
    id: String,
    text: String,
    /// What to do about it.
    help: Option<String>,
}

async fn alarm(Query(asked): Query<AskedAlarm>) -> Result<Json<AlarmText>, Problem> {
    let texts = catalogue(asked.language.as_deref())?;
    let (id, faults) = alarm_id(&short(asked.id)?).ok_or(Problem::Missing)?;
    let values: BTreeMap<String, Value> = match asked.values.as_deref() {
        None | Some("") => BTreeMap::new(),
        Some(text) => serde_json::from_str(text).map_err(|error| Problem::Unreadable(error.to_string()))?,
    };
    let as_text = |value: Value| match value {
        Value::String(text) => text,
        other => other.to_string(),
    };
    let values = values.into_iter().take(MOST_VALUES).map(|(name, value)| (name, as_text(value))).collect();
    let help = texts.help_of(id);
    let help = help.or_else(|| faults.iter().find_map(|fault| texts.help_of(AlarmId::Core(*fault))));
    Ok(Json(AlarmText { id: id.to_string(), text: texts.told(id, &faults, &values), help }))
}

#[derive(Deserialize)]
struct AskedWord {
    word: String,
    language: Option<String>,
    dialect: Option<String>,
}

/// One thing to say.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(super) struct Fact {
    label: String,
    text: String,
}

/// Rows of a name and what is to say of it, or of a name, a value and that.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(super) struct Table {
    label: String,
    rows: Vec<Vec<String>>,
}

/// What `ferrocut explain` says of a word.
#[derive(Serialize, Default)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(super) struct Explanation {
    /// Whether there is such a thing; else `text` says why not.
    found: bool,
    kind: String,
    title: String,
    text: String,
    /// What is to say of it, each with its label.
    facts: Vec<Fact>,
    /// What else bears on it, such as the parameters with their values.
    tables: Vec<Table>,
    /// Where the manual has it.
    #[cfg_attr(test, ts(type = "string"))]
    source: Value,
    /// The same for programs.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(type = "unknown"))]
    page: Option<Value>,
}

async fn explain(
    State(shared): State<Arc<Shared>>,
    Query(asked): Query<AskedWord>,
) -> Result<Json<Explanation>, Problem> {
    let spoken = Spoken { language: asked.language, dialect: asked.dialect };
    let word = short(asked.word)?;
    let (dialect, texts) = (spoken.dialect(&shared)?, spoken.catalogue()?);
    // Values are those that the control has now.
    let desk = super::query::desk(&shared).await?.speaking(dialect);
    let book = Book::new(dialect, desk.memory().clone(), texts);
    // A place of a file is asked for by nobody here.
    let things = asked::read(&[word], &book, &|_| false).into_iter().next();
    let page = match things {
        Some(Ok(things)) => book.pages(&things).into_iter().next(),
        Some(Err(reason)) => {
            let source = json!("");
            return Ok(Json(Explanation { text: reason, source, ..Explanation::default() }));
        }
        None => None,
    };
    let Some(page) = page else { return Err(Problem::Missing) };
    let text = page.text(book.catalogue);
    let page_json = page.json(book.catalogue);
    let source = page_json.get("section").cloned().unwrap_or_else(|| json!(""));
    let title = match page.title.as_str() {
        "" => page.name.clone(),
        title => format!("{}  {title}", page.name),
    };
    let facts =
        page.facts_told(book.catalogue).into_iter().map(|(label, text)| Fact { label, text }).collect();
    let tables =
        page.tables_told(book.catalogue).into_iter().map(|(label, rows)| Table { label, rows }).collect();
    let (kind, page) = (page.kind.to_string(), Some(page_json));
    Ok(Json(Explanation { found: true, kind, title, text, facts, tables, source, page }))
}

/// A code or keyword of the control language.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(super) struct Word {
    word: String,
    kind: &'static str,
    title: String,
    form: String,
}

fn words_of(book: &Book) -> Vec<Word> {
    let title = |name: Option<(String, String)>| name.map(|(_, title)| title).unwrap_or_default();
    let g = book.g_codes().into_iter().map(|tenths| Word {
        word: g_code_name(tenths),
        kind: "g-code",
        title: title(book.code_line(&ferrocut_machine::Subject::G(tenths))),
        form: book
            .reference
            .and_then(|r| r.g_code(tenths))
            .map_or(String::new(), |row| row.format.to_string()),
    });
    let m = book.m_codes().into_iter().map(|code| Word {
        word: format!("M{code:02}"),
        kind: "m-code",
        title: title(book.code_line(&ferrocut_machine::Subject::M(code))),
        form: String::new(),
    });
    let macros = book.reference.into_iter().flat_map(Reference::macro_words).map(|row| Word {
        word: row.word.to_string(),
        kind: "macro",
        title: book.words(&row.meaning).to_owned(),
        form: row.format.to_string(),
    });
    g.chain(m).chain(macros).collect()
}

async fn words(
    State(shared): State<Arc<Shared>>,
    Query(spoken): Query<Spoken>,
) -> Result<Json<Vec<Word>>, Problem> {
    Ok(Json(words_of(&book(&shared.machine, spoken.dialect(&shared)?, spoken.catalogue()?))))
}

/// What a parameter is.
#[derive(Serialize, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub(super) enum ParameterKind {
    /// Bits, each with a meaning of its own.
    Bit,
    /// A value.
    Data,
}

/// A parameter of the control, with its bits.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(super) struct Parameter {
    /// The number, or the name of one without.
    #[cfg_attr(test, ts(type = "number | string"))]
    number: Value,
    /// What the command `parameters` calls it; of bits each has its own.
    name: String,
    kind: ParameterKind,
    bits: Vec<Bit>,
    symbol: String,
    meaning: String,
    unit: String,
    minimum: Option<f64>,
    maximum: Option<f64>,
    standard: f64,
    level: u8,
    room: String,
    /// Whether this version does something with it; of bits, with one at least.
    used: bool,
}

/// A bit of a parameter.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(super) struct Bit {
    bit: u8,
    name: String,
    symbol: String,
    meaning: String,
    standard: f64,
    level: u8,
    used: bool,
}

/// The control's parameters by rising number, the bits of one together.
fn parameters_of(book: &Book) -> Vec<Parameter> {
    let table = book.table();
    let level = |key: &ParameterKey| needed_for_parameter(table, key).number();
    let mut found: Vec<Parameter> = Vec::new();
    for definition in table.iter() {
        let parameter = |number: Value, name: String, kind| Parameter {
            number,
            name,
            kind,
            bits: Vec::new(),
            symbol: definition.symbol.to_string(),
            meaning: if kind == ParameterKind::Bit {
                String::new()
            } else {
                meaning(definition, book.catalogue)
            },
            unit: definition.unit.to_string(),
            minimum: definition.min,
            maximum: definition.max,
            standard: definition.default,
            level: level(&definition.key),
            room: definition.applies_to.to_string(),
            used: definition.used,
        };
        match &definition.key {
            ParameterKey::Data(number) => {
                found.push(parameter(json!(number), definition.name.to_string(), ParameterKind::Data));
            }
            ParameterKey::Named(name) => {
                found.push(parameter(json!(name), name.to_string(), ParameterKind::Data));
            }
            ParameterKey::Bit { number, bit } => {
                let of = json!(number);
                if found.last().is_none_or(|last| last.kind != ParameterKind::Bit || last.number != of) {
                    found.push(parameter(of, table.name_of_bits(*number), ParameterKind::Bit));
                }
                let bit = Bit {
                    bit: *bit,
                    name: definition.name.to_string(),
                    symbol: definition.symbol.to_string(),
                    meaning: meaning(definition, book.catalogue),
                    standard: definition.default,
                    level: level(&definition.key),
                    used: definition.used,
                };
                if let Some(last) = found.last_mut() {
                    last.used |= bit.used;
                    last.bits.push(bit);
                }
            }
        }
    }
    found
}

async fn parameters(
    State(shared): State<Arc<Shared>>,
    Query(spoken): Query<Spoken>,
) -> Result<Json<Vec<Parameter>>, Problem> {
    let texts = spoken.catalogue()?;
    let own = Spoken::default().dialect(&shared)?;
    Ok(Json(parameters_of(&book(&shared.machine, own, texts))))
}

/// A signal of the ladder.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(super) struct Signal {
    name: String,
    address: String,
    meaning: String,
}

/// The ladder that runs.
async fn ladder(shared: &Arc<Shared>) -> Result<Option<Program>, Problem> {
    let hub = shared.hub.clone();
    let copy = move || hub.look(|panel| panel.control().plc_mut().map(|plc| plc.program().clone()));
    tokio::task::spawn_blocking(copy).await.ok().flatten().ok_or(Problem::NoMachine("no_machine"))
}

fn signals_of(ladder: Option<&Program>, texts: Catalogue) -> Vec<Signal> {
    let Some(ladder) = ladder else { return Vec::new() };
    let all = AREAS.into_iter().flat_map(|area| entries(area, ladder));
    all.map(|entry| Signal {
        address: entry.place(),
        meaning: entry.meaning(texts.language(), ladder),
        name: entry.name,
    })
    .collect()
}

async fn signals(
    State(shared): State<Arc<Shared>>,
    Query(spoken): Query<Spoken>,
) -> Result<Json<Vec<Signal>>, Problem> {
    let texts = spoken.catalogue()?;
    Ok(Json(signals_of(ladder(&shared).await?.as_ref(), texts)))
}

#[derive(Deserialize)]
struct Sought {
    q: String,
    language: Option<String>,
}

/// Something that can be looked up.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(super) struct Found {
    kind: &'static str,
    key: String,
    title: String,
    text: String,
    /// How well it fits: less is better.
    #[serde(skip)]
    rank: u8,
}

/// How well a thing fits what is sought; none where it does not. Every word must be in it.
fn rank(sought: &[String], key: &str, text: &str) -> Option<u8> {
    let (key, text) = (key.to_lowercase(), text.to_lowercase());
    if !sought.iter().all(|word| key.contains(word) || text.contains(word)) {
        return None;
    }
    let whole = sought.join(" ");
    Some(match () {
        () if key == whole => 0,
        () if key.starts_with(&whole) => 1,
        () if key.contains(&whole) => 2,
        () if text.starts_with(&whole) => 3,
        () => 4,
    })
}

/// Everything that can be looked up: kind, key, title and text of each.
fn each_of(book: &Book, ladder: Option<&Program>, mut add: impl FnMut(&'static str, String, String, String)) {
    for word in words_of(book) {
        add("code", word.word, word.title, word.form);
    }
    for definition in book.table().iter() {
        // A bit is known by the manual's symbol; what a number is for says its meaning alone.
        let symbol = match definition.meaning {
            Meaning::Bit { .. } => definition.symbol.to_string(),
            Meaning::Value(_) => String::new(),
        };
        add("parameter", definition.name.to_string(), symbol, meaning(definition, book.catalogue));
    }
    let own = alarm_table(book.dialect.name).iter().map(|row| row.id);
    for id in own.chain(Fault::ALL.iter().map(|fault| AlarmId::Core(*fault))) {
        let text = |text: Option<String>| text.unwrap_or_default();
        add("alarm", id.to_string(), text(book.catalogue.text(id)), text(book.catalogue.help_of(id)));
    }
    for row in book.reference.into_iter().flat_map(Reference::variables) {
        let words = |text| book.words(text).to_owned();
        add("variable", row.name(), words(&row.meaning), words(&row.notes));
    }
    for letter in b'A'..=b'Z' {
        let meaning = book.address_meaning(letter);
        if !meaning.is_empty() {
            add("address", char::from(letter).to_string(), meaning.to_owned(), String::new());
        }
    }
    for signal in signals_of(ladder, book.catalogue) {
        add("signal", signal.name, signal.address, signal.meaning);
    }
}

/// What the panel calls an alarm, in its languages.
const ALARM: [&str; 4] = ["alarm", "报警", "авария", "alarma"];

/// What is sought, as the tables write it: `43#1`, as the manual prints a bit, is `NO43.1`, and the alarm of `alarm 45`
/// is listed with four digits.
fn as_listed(sought: &[String], table: &ParameterTable) -> Vec<String> {
    let is_number = |word: &str| !word.is_empty() && word.bytes().all(|b| b.is_ascii_digit());
    if let [kind, number] = sought
        && ALARM.contains(&kind.as_str())
        && is_number(number)
    {
        return vec![format!("{number:0>4}")];
    }
    let bit = |word: &String| {
        let (number, bit) = word.strip_prefix("no").unwrap_or(word).split_once('#')?;
        let key: ParameterKey = format!("NO{number}.{bit}").parse().ok().filter(|_| is_number(number))?;
        Some(table.name(&key).to_lowercase())
    };
    sought.iter().map(|word| bit(word).unwrap_or_else(|| word.clone())).collect()
}

fn found_in(book: &Book, ladder: Option<&Program>, sought: &[String]) -> Vec<Found> {
    let sought = &as_listed(sought, book.table());
    let mut found = Vec::new();
    each_of(book, ladder, |kind, key, title, text| {
        if let Some(rank) = rank(sought, &key, &format!("{title} {text}")) {
            found.push(Found { kind, key, title, text, rank });
        }
    });
    found.sort_by_key(|found| found.rank);
    found.truncate(MOST_FOUND);
    found
}

#[derive(Deserialize)]
struct Listed {
    kind: String,
    language: Option<String>,
}

/// All of a kind, in the control's order.
async fn list(
    State(shared): State<Arc<Shared>>,
    Query(listed): Query<Listed>,
) -> Result<Json<Vec<Found>>, Problem> {
    let texts = catalogue(listed.language.as_deref())?;
    let own = Spoken::default().dialect(&shared)?;
    let ladder = ladder(&shared).await?;
    let machine = shared.machine.clone();
    let all = super::work::work(move |_| {
        let mut found = Vec::new();
        each_of(&book(&machine, own, texts), ladder.as_ref(), |kind, key, title, text| {
            if kind == listed.kind {
                found.push(Found { kind, key, title, text, rank: 0 });
            }
        });
        found
    });
    Ok(Json(all.await?))
}

async fn search(
    State(shared): State<Arc<Shared>>,
    Query(sought): Query<Sought>,
) -> Result<Json<Vec<Found>>, Problem> {
    let texts = catalogue(sought.language.as_deref())?;
    let sought: Vec<String> = short(sought.q)?.to_lowercase().split_whitespace().map(str::to_owned).collect();
    if sought.is_empty() {
        return Ok(Json(Vec::new()));
    }
    let own = Spoken::default().dialect(&shared)?;
    let ladder = ladder(&shared).await?;
    let machine = shared.machine.clone();
    let found = super::work::work(move |_| found_in(&book(&machine, own, texts), ladder.as_ref(), &sought));
    Ok(Json(found.await?))
}
