//! `ferrocut memory show` and `check`.

use super::keep::opened_backup;
use super::{CheckArgs, ShowArgs, label, name, refused, tables, unopened, utc};
use crate::commands::layout::{print, table};
use crate::diagnostics::Diagnostics;
use crate::job::{Exit, Failure};
use ferrocut_memory::{Damage, Finding, OpenError, Reader, Source, damage};
use serde_json::{Map, Value, json};
use std::path::Path;

/// Shows a memory.
pub fn show(args: &ShowArgs, diagnostics: &Diagnostics) -> Result<Exit, Failure> {
    let reader = Reader::open(&args.folder).map_err(|error| unopened(&args.folder, &error))?;
    let failed = |error| refused(&error);
    if args.item.is_empty() {
        let control = reader.control().map_err(failed)?;
        let commits = reader.commits().map_err(failed)?;
        let counts = reader.counts().map_err(failed)?;
        let levels = reader.levels_with_password().map_err(failed)?;
        let levels: Vec<u8> = levels.into_iter().map(|level| level.number()).collect();
        if diagnostics.is_json() {
            let rows: Map<String, Value> =
                counts.into_iter().map(|(item, rows)| (item.name().to_owned(), rows.into())).collect();
            let said = json!({"control": control, "commits": commits, "items": rows, "levels_with_password": levels});
            print(&format!("{said}\n"));
            return Ok(Exit::Fine);
        }
        let passwords = match levels.as_slice() {
            [] => label(diagnostics, "label-memory-none"),
            levels => levels.iter().map(u8::to_string).collect::<Vec<_>>().join(" "),
        };
        let about = [
            ("label-memory-folder", name(&args.folder)),
            ("label-memory-control", control),
            ("label-memory-commits", commits.to_string()),
            ("label-memory-passwords", passwords),
        ];
        let about: Vec<Vec<String>> =
            about.into_iter().map(|(key, value)| vec![label(diagnostics, key), value]).collect();
        let counts: Vec<Vec<String>> = counts
            .into_iter()
            .map(|(item, rows)| {
                let says = label(diagnostics, &format!("label-item-{}", item.name()));
                vec![item.name().to_owned(), rows.to_string(), says]
            })
            .collect();
        print(&format!("{}\n{}", table(&about), table(&counts)));
        return Ok(Exit::Fine);
    }
    let contents = reader.contents(&args.item).map_err(failed)?;
    for item in &args.item {
        let rows = tables::rows(&contents, *item, diagnostics);
        if diagnostics.is_json() {
            for row in rows {
                let named = [("item", Value::from(item.name()))].into_iter().chain(row);
                let object: Map<String, Value> =
                    named.map(|(column, value)| (column.to_owned(), value)).collect();
                print(&format!("{}\n", Value::Object(object)));
            }
            continue;
        }
        let title = label(diagnostics, &format!("label-item-{}", item.name()));
        let text = match rows.is_empty() {
            true => format!("  {}\n", label(diagnostics, "label-memory-empty")),
            false => tables::text(&rows),
        };
        print(&format!("{} ({title})\n{text}\n", item.name()));
    }
    Ok(Exit::Fine)
}

/// Checks memories and backups.
pub fn check(args: &CheckArgs, diagnostics: &Diagnostics) -> Result<Exit, Failure> {
    let mut exit = Exit::Fine;
    for path in &args.paths {
        let checked = match path.is_dir() {
            true => check_folder(path, diagnostics),
            false => check_backup(path, diagnostics),
        };
        exit = exit.max(checked.unwrap_or_else(|failure| {
            diagnostics.report(&failure.alarm, "", None);
            failure.exit
        }));
    }
    Ok(exit)
}

fn check_folder(folder: &Path, diagnostics: &Diagnostics) -> Result<Exit, Failure> {
    let file = name(folder);
    match damage::check(folder) {
        Ok(commits) if diagnostics.is_json() => {
            print(&format!("{}\n", json!({"file": file, "whole": true, "commits": commits})));
            Ok(Exit::Fine)
        }
        Ok(commits) => {
            let named = [("file", file.into()), ("commits", commits.to_string().into())];
            print(&format!("{}\n", diagnostics.catalogue().label("label-memory-whole", &named)));
            Ok(Exit::Fine)
        }
        Err(OpenError::Damaged(damage)) => {
            say_damage(&file, &damage, diagnostics);
            diagnostics.report(&OpenError::Damaged(damage).alarm(), &file, None);
            Ok(Exit::Finding)
        }
        Err(error) => Err(unopened(folder, &error)),
    }
}

fn say_damage(file: &str, damage: &Damage, diagnostics: &Diagnostics) {
    let catalogue = diagnostics.catalogue();
    let said = |finding: &Finding| {
        let (key, named) = finding.label();
        catalogue.label(key, &named)
    };
    let findings: Vec<String> = damage.findings().iter().map(said).collect();
    let source = |source: &Source| match source {
        Source::Database => label(diagnostics, "label-memory-in-database"),
        Source::Snapshot(path) => name(path),
    };
    if diagnostics.is_json() {
        let states: Vec<Value> = damage
            .states()
            .iter()
            .map(|state| {
                let snapshot = match &state.source {
                    Source::Database => Value::Null,
                    Source::Snapshot(path) => name(path).into(),
                };
                json!({"commit": state.commits, "missing": state.missing, "time": utc(state.time), "snapshot": snapshot})
            })
            .collect();
        let said = json!({"file": file, "whole": false, "findings": findings, "good_states": states});
        print(&format!("{said}\n"));
        return;
    }
    let mut text = format!("{}\n", catalogue.label("label-memory-damaged", &[("file", file.into())]));
    for finding in findings {
        text.push_str(&format!("  {finding}\n"));
    }
    let key = match damage.states() {
        [] => "label-memory-no-good-state",
        _ => "label-memory-good-states",
    };
    text.push_str(&format!("{}\n", label(diagnostics, key)));
    let rows: Vec<Vec<String>> = damage
        .states()
        .iter()
        .map(|state| {
            let lost = |count: u64| catalogue.label("label-memory-lost", &[("count", (count as f64).into())]);
            let missing = state.missing.map(lost).unwrap_or_default();
            vec![format!("  {}", state.commits), utc(state.time), source(&state.source), missing]
        })
        .collect();
    print(&format!("{text}{}\n", table(&rows)));
}

fn check_backup(path: &Path, diagnostics: &Diagnostics) -> Result<Exit, Failure> {
    let file = name(path);
    let backup = opened_backup(path)?;
    if diagnostics.is_json() {
        let rows: Map<String, Value> =
            backup.entries().iter().map(|e| (e.item.name().to_owned(), e.rows.into())).collect();
        let said = json!({
            "file": file, "whole": true, "control": backup.control(), "time": utc(backup.time()),
            "commits": backup.commits(), "items": rows,
        });
        print(&format!("{said}\n"));
        return Ok(Exit::Fine);
    }
    let named =
        [("file", file.into()), ("control", backup.control().into()), ("time", utc(backup.time()).into())];
    let whole = diagnostics.catalogue().label("label-memory-backup-whole", &named);
    let rows: Vec<Vec<String>> = backup
        .entries()
        .iter()
        .map(|entry| {
            let says = label(diagnostics, &format!("label-item-{}", entry.item.name()));
            vec![format!("  {}", entry.item.name()), entry.rows.to_string(), says]
        })
        .collect();
    print(&format!("{whole}\n{}", table(&rows)));
    Ok(Exit::Fine)
}
