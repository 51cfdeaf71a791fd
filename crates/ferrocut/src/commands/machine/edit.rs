//! Changes in the `[parameters]` table of a machine file that leave everything else as it stands.

use ferrocut_machine::{Catalogue, Machine, ParameterKey, ParameterTable};
use std::fs::{self, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use toml_edit::{DocumentMut, Item, Table, Value};

/// Largest whole number that a file shows without a decimal point; further on digits would be lost.
const LARGEST_WHOLE: f64 = 1e15;

/// What is to be set; none takes the parameter out of the file.
pub type Change = (ParameterKey, Option<f64>);

/// The text of a machine file with changed parameters. The reason where the file cannot be changed.
pub fn changed(
    text: &str,
    changes: &[Change],
    list: &ParameterTable,
    texts: Catalogue,
) -> Result<String, String> {
    if changes.is_empty() {
        Machine::from_toml(text).map_err(|e| e.told(texts))?;
        return Ok(text.to_owned());
    }
    let mut file: DocumentMut = text.parse().map_err(|e: toml_edit::TomlError| e.to_string())?;
    // A table that is not there has nothing to be taken out of.
    if !file.contains_key("parameters") && changes.iter().all(|(_, value)| value.is_none()) {
        return changed(text, &[], list, texts);
    }
    let table = file.entry("parameters").or_insert_with(|| Item::Table(Table::new()));
    let table = table.as_table_like_mut().ok_or("parameters is no table")?;
    for (key, value) in changes {
        let is_it = |name: &str| name.parse::<ParameterKey>().as_ref() == Ok(key);
        let names: Vec<String> = table.iter().map(|(name, _)| name.to_owned()).filter(|n| is_it(n)).collect();
        // Of several spellings of one parameter, one stays.
        let spare = if value.is_some() { 1 } else { 0 };
        names.iter().skip(spare).for_each(|name| drop(table.remove(name)));
        match (value, names.first()) {
            (None, _) => {}
            // A comment beside the value stays beside it.
            (Some(value), Some(name)) => {
                let item = table.entry(name).or_insert(Item::None);
                let decor = item.as_value().map(|v| v.decor().clone());
                *item = Item::Value(number(*value));
                if let (Some(new), Some(decor)) = (item.as_value_mut(), decor) {
                    *new.decor_mut() = decor;
                }
            }
            (Some(value), None) => {
                table.insert(&list.name(key), Item::Value(number(*value)));
            }
        }
    }
    let mut new = file.to_string();
    if text.contains("\r\n") {
        new = new.replace("\r\n", "\n").replace('\n', "\r\n");
    }
    // What is written must be a machine that every command takes.
    Machine::from_toml(&new).map_err(|e| e.told(texts))?;
    Ok(new)
}

fn number(value: f64) -> Value {
    match value.fract() == 0.0 && value.abs() < LARGEST_WHOLE {
        true => Value::from(value as i64),
        false => Value::from(value),
    }
}

/// Replaces a file at once: whoever reads it meanwhile, and whatever fails, finds the old text or the
/// new one.
pub fn replace(path: &Path, text: &str) -> io::Result<()> {
    // A link stays a link: what it leads to is replaced.
    let path = fs::canonicalize(path)?;
    let permissions = fs::metadata(&path)?.permissions();
    if permissions.readonly() {
        return Err(io::Error::new(io::ErrorKind::PermissionDenied, "it is read-only"));
    }
    let (beside, mut file) = beside(&path)?;
    let written = file
        .write_all(text.as_bytes())
        .and_then(|()| file.sync_all())
        .and_then(|()| fs::set_permissions(&beside, permissions))
        .and_then(|()| fs::rename(&beside, &path));
    if written.is_err() {
        // The first error is the one to tell.
        let _ = fs::remove_file(&beside);
    }
    written
}

/// Writes a file that may exist.
pub fn write(path: &Path, bytes: &[u8]) -> io::Result<()> {
    match std::str::from_utf8(bytes) {
        Ok(text) if path.is_file() => replace(path, text),
        _ => fs::write(path, bytes),
    }
}

/// A new file in the folder of another.
fn beside(path: &Path) -> io::Result<(PathBuf, fs::File)> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let mut attempt = 0;
    loop {
        let beside = path.with_file_name(format!(".{name}.{}-{attempt}", std::process::id()));
        match OpenOptions::new().write(true).create_new(true).open(&beside) {
            Ok(file) => return Ok((beside, file)),
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists && attempt < 100 => attempt += 1,
            Err(error) => return Err(error),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ferrocut_machine::Language;

    const FILE: &str = "# mine\nname = \"m\" # n\n\n[[axes]]\nname = \"X\"\nmin = 0\nmax = 1 # end\nrapid = 1\n\
        velocity = 1\nacceleration = 1\n\n[parameters] # set\n# retract\np0270 = 2.50 # mm\n\"NO43#1\" = 1\n";

    fn change(text: &str, changes: &[(&str, Option<f64>)]) -> Result<String, String> {
        let changes: Vec<Change> = changes.iter().map(|(k, v)| (k.parse().unwrap(), *v)).collect();
        changed(text, &changes, ParameterTable::of("gsk990mc").unwrap(), Catalogue::new(Language::En))
    }

    #[test]
    fn comments_order_and_spelling_stay() {
        let new = change(FILE, &[("P270", Some(1.5)), ("NO43.1", Some(0.0)), ("NO40.7", Some(1.0))]).unwrap();
        let expected =
            FILE.replace("2.50", "1.5").replace("\"NO43#1\" = 1\n", "\"NO43#1\" = 0\n\"NO40.7\" = 1\n");
        assert_eq!(new, expected);
        assert_eq!(change(FILE, &[]).unwrap(), FILE);
        let without = change(FILE, &[("NO43.1", None), ("P87", None)]).unwrap();
        assert_eq!(without, FILE.replace("\"NO43#1\" = 1\n", ""));
    }

    #[test]
    fn line_ends_of_windows_stay() {
        let new = change(&FILE.replace('\n', "\r\n"), &[("P87", Some(400.0))]).unwrap();
        assert_eq!(new, format!("{FILE}P87 = 400\n").replace('\n', "\r\n"));
    }

    #[test]
    fn two_spellings_of_one_parameter_become_one() {
        let new = change(&format!("{FILE}P270 = 7\n"), &[("P270", Some(1.0))]).unwrap();
        assert_eq!(new, FILE.replace("2.50", "1"));
    }

    #[test]
    fn a_file_without_the_table_gets_it() {
        let plain = FILE.split("[parameters]").next().unwrap();
        assert_eq!(change(plain, &[("P270", None)]).unwrap(), plain);
        assert_eq!(change(plain, &[]).unwrap(), plain);
        let new = change(plain, &[("NO43.1", Some(0.0))]).unwrap();
        assert!(new.starts_with(plain.trim_end()) && new.contains("[parameters]\n\"NO43.1\" = 0\n"), "{new}");
        let inline = format!("parameters = {{ P270 = 1 }}\n{plain}");
        let new = change(&inline, &[("P270", Some(2.0)), ("P271", Some(2.5))]).unwrap();
        let machine = Machine::from_toml(&new).unwrap();
        assert_eq!((machine.parameters["P270"], machine.parameters["P271"]), (2.0, 2.5));
    }

    #[test]
    fn a_file_that_is_no_machine_is_not_changed() {
        assert!(change("name = ", &[]).is_err());
        assert!(change("name = \"m\"\naxes = []\n", &[]).unwrap_err().contains("axes: there are 0"));
        assert!(change(&format!("parameters = 1\n{FILE}"), &[]).is_err());
    }
}
