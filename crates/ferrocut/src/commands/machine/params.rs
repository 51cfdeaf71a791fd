//! `ferrocut machine params`: the parameters of a control by its own numbers.

use super::edit::{self, Change};
use super::{ExportArgs, ImportArgs, ListArgs, ParamsCommand, SetArgs};
use crate::cli::Common;
use crate::commands::explain::{self, Book, dialect_of, unusable};
use crate::commands::layout::{print, table};
use crate::commands::names::{self, NameError, complain, name_error, parameter_error, range};
use crate::job::{Exit, Failure, Shop};
use crate::outputs;
use crate::stdout;
use ferrocut_desk::memory_of;
use ferrocut_desk::page::{meaning, parameter_json};
use ferrocut_machine::parameter_checks::{ContradictionKind, contradictions};
use ferrocut_machine::parameter_csv::{ParameterCsvError, read_parameters, write_parameters};
use ferrocut_machine::{Machine, Memory, ParameterDef, ParameterKey};
use std::collections::HashMap;
use std::io::{self, Read, Write};
use std::path::Path;

/// Runs the command.
pub fn run(command: &ParamsCommand, common: &Common) -> Result<Exit, Failure> {
    match command {
        ParamsCommand::List(args) => list(args, &Book::open(common)?),
        ParamsCommand::Explain(args) => explain_names(&args.names, &Book::open(common)?),
        ParamsCommand::Get(args) => get(&args.names, &Book::open(common)?),
        ParamsCommand::Set(args) => set(args, &Target::open(common, &args.machine)?),
        ParamsCommand::Check(args) => Ok(check(&args.machine, &Target::open(common, &args.machine)?)),
        ParamsCommand::Export(args) => {
            outputs::check(&args.output, common.files())?;
            export(args, &Book::open(common)?)
        }
        ParamsCommand::Import(args) => import(args, &Target::open(common, &args.machine)?),
    }
}

/// A machine file that is to be changed, as it stands.
struct Target {
    book: Book,
    machine: Machine,
    text: String,
}

impl Target {
    /// Reads the file. Parameters in it that are wrong are passed over: they may be what is to be mended.
    fn open(common: &Common, path: &Path) -> Result<Target, Failure> {
        let shop = Shop::open(common)?;
        let dialect = dialect_of(common, &shop.machine)?;
        let (memory, _) = memory_of(&shop.machine, dialect);
        let book = Book::new(dialect, memory, shop.diagnostics);
        let text = std::fs::read_to_string(path).map_err(|error| unusable(path, &error.to_string()))?;
        Ok(Target { book, machine: shop.machine, text })
    }

    fn say(&self, key: &str, arguments: &[(&str, ferrocut_machine::Argument)]) -> String {
        self.book.diagnostics.catalogue().label(key, arguments)
    }

    /// Writes changes and prints each, old value and new.
    fn write(&self, path: &Path, changes: &[Change]) -> Result<Exit, Failure> {
        let new = edit::changed(&self.text, changes, self.book.table(), self.book.diagnostics.catalogue())
            .map_err(|reason| unusable(path, &reason))?;
        if new != self.text {
            let file = path.to_string_lossy();
            edit::replace(path, &new).map_err(|error| Failure::cannot_write(&file, &error))?;
        }
        let mut rows = Vec::new();
        for (key, value) in changes {
            let old = self.book.memory.parameter(key);
            let definition = self.book.table().get(key);
            let name = self.book.table().name(key);
            let new = value.or(definition.map(|d| d.default)).unwrap_or(0.0);
            if self.book.diagnostics.is_json() {
                let object = serde_json::json!({ "name": name, "old": old, "new": new });
                print(&format!("{object}\n"));
            }
            let unit = definition.map_or("", |d| &*d.unit);
            let symbol = definition.map_or("", |d| &*d.symbol);
            rows.push(vec![name, symbol.to_owned(), format!("{old} → {new} {unit}").trim_end().to_owned()]);
        }
        if !self.book.diagnostics.is_json() {
            print(&table(&rows));
        }
        Ok(Exit::Fine)
    }
}

fn list(args: &ListArgs, book: &Book) -> Result<Exit, Failure> {
    if book.table().is_empty() {
        complain(&name_error(&NameError::None, book.dialect.name, book.catalogue), &book.diagnostics);
        return Ok(Exit::WrongUse);
    }
    let rooms: Vec<&str> = book.table().iter().map(|d| &*d.applies_to).collect();
    if let Some(room) = &args.room
        && !rooms.iter().any(|r| r.eq_ignore_ascii_case(room))
    {
        let mut known = rooms.clone();
        known.sort_unstable();
        known.dedup();
        let arguments = [("name", room.as_str().into()), ("names", known.join(", ").into())];
        complain(&book.diagnostics.catalogue().label("label-no-room", &arguments), &book.diagnostics);
        return Ok(Exit::WrongUse);
    }
    let find = args.find.as_ref().map(|text| text.to_lowercase());
    let has = |text: &str| find.as_ref().is_none_or(|find| text.to_lowercase().contains(find));
    let asked = |d: &ParameterDef| {
        args.room.as_ref().is_none_or(|room| d.applies_to.eq_ignore_ascii_case(room))
            && has(&format!(
                "{} {} {} {}",
                d.name,
                d.symbol,
                meaning(d, book.diagnostics.catalogue()),
                d.applies_to
            ))
    };
    let found: Vec<_> = values(book).filter(|(d, _)| asked(d)).collect();
    if let Some(find) = args.find.as_ref().filter(|_| found.is_empty()) {
        let arguments = [("name", find.as_str().into()), ("dialect", book.dialect.name.into())];
        complain(&book.diagnostics.catalogue().label("label-params-no-match", &arguments), &book.diagnostics);
        return Ok(Exit::WrongUse);
    }
    let rows: Vec<_> = found.into_iter().filter(|(d, value)| !args.changed || *value != d.default).collect();
    let mut out = stdout::lock();
    if book.diagnostics.is_json() {
        for (definition, value) in rows {
            // A reader that went away is no fault.
            if writeln!(out, "{}", parameter_json(definition, value, book.diagnostics.catalogue())).is_err() {
                break;
            }
        }
        return Ok(Exit::Fine);
    }
    let label = |key: &str| book.diagnostics.catalogue().label(key, &[]);
    let head = ["name", "symbol", "value", "default", "range", "unit", "room", "use", "meaning"];
    let mut cells: Vec<Vec<String>> = vec![vec![String::new()]];
    if let Some(first) = cells.first_mut() {
        first.extend(head.map(|key| label(&format!("label-params-{key}"))));
    }
    let empty = rows.is_empty();
    cells.extend(rows.iter().map(|(d, value)| {
        vec![
            if *value == d.default { String::new() } else { "*".to_owned() },
            d.name.to_string(),
            d.symbol.to_string(),
            value.to_string(),
            d.default.to_string(),
            range(d.min, d.max).unwrap_or_default(),
            d.unit.to_string(),
            d.applies_to.to_string(),
            label(if d.used { "label-params-used" } else { "label-params-kept" }),
            meaning(d, book.diagnostics.catalogue()),
        ]
    }));
    let _ = match empty {
        true => writeln!(out, "{}", label("label-params-unchanged")),
        false => write!(out, "{}", table(&cells)),
    };
    Ok(Exit::Fine)
}

/// Every parameter of the list with its value, as the memory holds it.
fn values(book: &Book) -> impl Iterator<Item = (&'static ParameterDef, f64)> + '_ {
    book.table().iter().map(|d| (d, book.memory.parameter(&d.key)))
}

/// The parameters of names. Those that name nothing are told, and none is returned.
fn keys(names: &[String], book: &Book) -> Option<Vec<ParameterKey>> {
    let mut found = Some(Vec::new());
    for name in names {
        match names::parameters(name, book.table()) {
            Ok(keys) => {
                if let Some(found) = &mut found {
                    found.extend(keys);
                }
            }
            Err(error) => {
                complain(&name_error(&error, book.dialect.name, book.catalogue), &book.diagnostics);
                found = None;
            }
        }
    }
    found
}

fn explain_names(names: &[String], book: &Book) -> Result<Exit, Failure> {
    let Some(keys) = keys(names, book) else { return Ok(Exit::WrongUse) };
    let pages: Vec<_> = keys.iter().filter_map(|key| book.parameter(key)).collect();
    explain::print(&pages, &book.diagnostics);
    Ok(Exit::Fine)
}

fn get(names: &[String], book: &Book) -> Result<Exit, Failure> {
    let Some(keys) = keys(names, book) else { return Ok(Exit::WrongUse) };
    let mut out = stdout::lock();
    for key in keys {
        let value = book.memory.parameter(&key);
        let written = match book.table().get(&key) {
            Some(definition) if book.diagnostics.is_json() => {
                writeln!(out, "{}", parameter_json(definition, value, book.diagnostics.catalogue()))
            }
            _ => writeln!(out, "{}={value}", book.table().name(&key)),
        };
        if written.is_err() {
            break;
        }
    }
    Ok(Exit::Fine)
}

/// A value as people write it; none for `default`.
fn value(text: &str) -> Option<Option<f64>> {
    match text.trim() {
        "default" => Some(None),
        text => text.parse::<f64>().ok().filter(|v| v.is_finite()).map(Some),
    }
}

/// What `name` and `text` ask for, checked against the list; else why not.
fn change(name: &str, text: &str, memory: &mut Memory, target: &Target) -> Result<Change, String> {
    let book = &target.book;
    let dialect = book.dialect.name;
    // What a file has wrongly can be taken out of it.
    if value(text) == Some(None)
        && let Ok(key) = name.parse::<ParameterKey>()
        && target.machine.parameters.keys().any(|name| name.parse::<ParameterKey>().as_ref() == Ok(&key))
    {
        return Ok((key, None));
    }
    let key = names::parameter(name, book.table()).map_err(|e| name_error(&e, dialect, book.catalogue))?;
    let Some(value) = value(text) else {
        let arguments = [("name", book.table().name(&key).into()), ("value", text.trim().into())];
        return Err(book.diagnostics.catalogue().label("label-no-number", &arguments));
    };
    // What stands already is no change, even where the list's own default is outside its range (P4).
    if let Some(value) = value.filter(|value| *value != memory.parameter(&key)) {
        let set = memory.set_parameter(&key, value);
        set.map_err(|error| parameter_error(&error, dialect, book.catalogue))?;
    }
    Ok((key, value))
}

fn set(args: &SetArgs, target: &Target) -> Result<Exit, Failure> {
    let book = &target.book;
    let mut memory = book.memory.clone();
    let mut changes: Vec<Change> = Vec::new();
    let mut wrong = false;
    for given in &args.values {
        let found = match given.split_once('=') {
            None => Err(target.say("label-no-assignment", &[("text", given.as_str().into())])),
            Some((name, text)) => change(name, text, &mut memory, target),
        };
        match found {
            Ok(change) if changes.iter().any(|(key, _)| *key == change.0) => {
                let text = target.say("label-set-twice", &[("name", book.table().name(&change.0).into())]);
                complain(&text, &book.diagnostics);
                wrong = true;
            }
            Ok(change) => changes.push(change),
            Err(reason) => {
                complain(&reason, &book.diagnostics);
                wrong = true;
            }
        }
    }
    if wrong {
        complain(&target.say("label-nothing-written", &[]), &book.diagnostics);
        return Ok(Exit::WrongUse);
    }
    target.write(&args.machine, &changes)
}

fn check(path: &Path, target: &Target) -> Exit {
    let book = &target.book;
    let file = path.to_string_lossy();
    let problems = problems(&target.machine, book);
    for (name, text) in &problems {
        let object = serde_json::json!({ "file": file, "name": name, "severity": "error", "message": text });
        print(&if book.diagnostics.is_json() { format!("{object}\n") } else { format!("{file}: {text}\n") });
    }
    if !book.diagnostics.is_json() {
        let arguments = [
            ("file", (&*file).into()),
            ("parameters", (target.machine.parameters.len() as f64).into()),
            ("findings", (problems.len() as f64).into()),
        ];
        print(&format!("{}\n", target.say("label-params-checked", &arguments)));
    }
    if problems.is_empty() { Exit::Fine } else { Exit::Finding }
}

/// What is wrong with the parameters of a machine file: the name as it stands there, and why.
pub fn problems(machine: &Machine, book: &Book) -> Vec<(String, String)> {
    let dialect = book.dialect.name;
    let mut memory = Memory::new(dialect);
    let mut seen: HashMap<ParameterKey, &String> = HashMap::new();
    let mut found = Vec::new();
    for (name, value) in &machine.parameters {
        let key = match name.parse::<ParameterKey>() {
            Ok(key) => key,
            Err(error) => {
                found.push((name.clone(), parameter_error(&error, dialect, book.catalogue)));
                continue;
            }
        };
        if book.table().is_empty() {
            found.push((name.clone(), name_error(&NameError::None, dialect, book.catalogue)));
        } else if let Err(error) = memory.set_parameter(&key, *value) {
            found.push((name.clone(), parameter_error(&error, dialect, book.catalogue)));
        }
        if let Some(other) = seen.insert(key, name) {
            let arguments = [("name", name.as_str().into()), ("other", other.as_str().into())];
            found.push((name.clone(), book.diagnostics.catalogue().label("label-named-twice", &arguments)));
        }
    }
    for pair in contradictions(&memory.parameters) {
        let label = match pair.kind {
            ContradictionKind::LowerAboveUpper => "label-lower-above-upper",
            ContradictionKind::SameAxis => "label-same-axis",
            ContradictionKind::BothBits => "label-both-bits",
        };
        let (first, second) = (book.table().name(&pair.first), book.table().name(&pair.second));
        let arguments = [("first", first.clone().into()), ("second", second.into())];
        found.push((first, book.diagnostics.catalogue().label(label, &arguments)));
    }
    found
}

fn export(args: &ExportArgs, book: &Book) -> Result<Exit, Failure> {
    let rows = values(book).filter(|(d, value)| !args.changed || *value != d.default);
    if args.output == Path::new("-") {
        // A reader that went away is no fault.
        let _ = write_parameters(stdout::lock(), rows);
        return Ok(Exit::Fine);
    }
    let file = args.output.to_string_lossy();
    let mut bytes = Vec::new();
    let written = write_parameters(&mut bytes, rows).and_then(|()| edit::write(&args.output, &bytes));
    written.map_err(|error| Failure::cannot_write(&file, &error))?;
    if !book.diagnostics.is_json() {
        let text = book.diagnostics.catalogue().label("label-written", &[("file", (&*file).into())]);
        print(&format!("{text}\n"));
    }
    Ok(Exit::Fine)
}

fn import(args: &ImportArgs, target: &Target) -> Result<Exit, Failure> {
    let book = &target.book;
    let file = args.file.to_string_lossy();
    let mut text = String::new();
    let read = match args.file == Path::new("-") {
        true => io::stdin().lock().read_to_string(&mut text).map(|_| ()),
        false => std::fs::read_to_string(&args.file).map(|read| text = read),
    };
    read.map_err(|error| unusable(&args.file, &error.to_string()))?;
    let rows = match read_parameters(&text) {
        Ok(rows) => rows,
        Err(error) => {
            let text = match error {
                ParameterCsvError::NoColumn(name) => {
                    target.say("label-no-column", &[("file", (&*file).into()), ("name", name.into())])
                }
                ParameterCsvError::Row { line } => {
                    let arguments = [("file", (&*file).into()), ("line", line.to_string().into())];
                    target.say("label-no-row", &arguments)
                }
            };
            complain(&text, &book.diagnostics);
            return Ok(Exit::WrongUse);
        }
    };
    let mut memory = book.memory.clone();
    let mut changes: Vec<Change> = Vec::new();
    let mut lines: HashMap<ParameterKey, u64> = HashMap::new();
    let mut wrong = 0;
    for row in &rows {
        let found = change(&row.name, &row.value, &mut memory, target).and_then(|change| {
            match lines.insert(change.0.clone(), row.line) {
                None => Ok(change),
                Some(line) => {
                    let arguments =
                        [("name", book.table().name(&change.0).into()), ("line", line.to_string().into())];
                    Err(target.say("label-row-twice", &arguments))
                }
            }
        });
        match found {
            Ok(change) => changes.push(change),
            Err(reason) => {
                wrong += 1;
                complain(&format!("{file}:{}: {reason}", row.line), &book.diagnostics);
            }
        }
    }
    if wrong > 0 {
        complain(&target.say("label-nothing-written", &[]), &book.diagnostics);
        return Ok(Exit::WrongUse);
    }
    let all = changes.len();
    let present = |(key, value): &Change| value.is_some_and(|v| v == book.memory.parameter(key));
    changes.retain(|change| !present(change));
    let exit = target.write(&args.machine, &changes)?;
    if !book.diagnostics.is_json() {
        let arguments =
            [("changed", (changes.len() as f64).into()), ("same", ((all - changes.len()) as f64).into())];
        print(&format!("{}\n", target.say("label-imported", &arguments)));
    }
    Ok(exit)
}
