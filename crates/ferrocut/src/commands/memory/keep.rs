//! `ferrocut memory backup`, `restore`, `recover` and `password`.

use super::{
    BackupArgs, PasswordArgs, RecoverArgs, RestoreArgs, author, failure, items, label, name, refused,
    refused_backup, unopened, utc,
};
use crate::commands::layout::print;
use crate::diagnostics::Diagnostics;
use crate::job::{Exit, Failure};
use crate::outputs;
use crate::stdout;
use ferrocut_interpreter::dialects;
use ferrocut_machine::{Alarm, Fault};
use ferrocut_memory::{Backup, Error, Level, OpenError, Reader, Seat, Settings, Store, damage};
use ferrocut_program::Span;
use serde_json::json;
use std::fs::File;
use std::io::{self, BufRead, Read, Write};
use std::path::Path;

/// Longest line that is read as a password, bytes.
const LINE: u64 = 1024;

/// The memory in a folder, made where there is none.
pub fn open(folder: &Path, control: &str) -> Result<Store, Failure> {
    Store::open(folder, Settings::new(control)).map_err(|error| unopened(folder, &error))
}

/// The control of a memory that exists.
fn control_of(folder: &Path) -> Result<String, Failure> {
    let reader = Reader::open(folder).map_err(|error| unopened(folder, &error))?;
    reader.control().map_err(|error| refused(&error))
}

/// Writes a backup.
pub fn back_up(args: &BackupArgs, diagnostics: &Diagnostics) -> Result<Exit, Failure> {
    // What is damaged must not be handed on as a backup of something whole.
    damage::check(&args.folder).map_err(|error| unopened(&args.folder, &error))?;
    let reader = Reader::open(&args.folder).map_err(|error| unopened(&args.folder, &error))?;
    let of_memory = std::fs::read_dir(&args.folder).into_iter().flatten().flatten();
    outputs::check(&args.output, of_memory.map(|file| file.path()).chain([args.folder.clone()]))?;
    let is_piped = args.output == Path::new("-");
    let entries = match is_piped {
        true => reader.back_up_to(io::BufWriter::new(stdout::lock()), &items(&args.item)),
        false => reader.back_up(&args.output, &items(&args.item)),
    };
    let entries = match entries {
        Ok(entries) => entries,
        // What became of standard output is told at the end: a reader that went away is no fault.
        Err(_) if is_piped && stdout::is_lost() => return Ok(Exit::Fine),
        Err(Error::Disk(reason)) => return Err(Failure::cannot_write_for(&name(&args.output), &reason)),
        Err(error) => return Err(refused(&error)),
    };
    let file = name(&args.output);
    let said = match diagnostics.is_json() {
        true => {
            let rows: serde_json::Map<String, serde_json::Value> =
                entries.iter().map(|e| (e.item.name().to_owned(), e.rows.into())).collect();
            json!({"file": file, "items": rows}).to_string()
        }
        false => diagnostics.catalogue().label("label-written", &[("file", file.into())]),
    };
    match is_piped {
        // Standard output is the backup's, as that of `import` is the program's.
        true => drop(writeln!(io::stderr(), "{said}")),
        false => print(&format!("{said}\n")),
    }
    Ok(Exit::Fine)
}

/// A backup that was judged. One on standard input or in a pipe can be read once, and is copied meanwhile.
pub fn opened_backup(path: &Path) -> Result<Backup, Failure> {
    if path.is_dir() {
        return Err(Failure::of_open(path, ferrocut_program::OpenError::Folder));
    }
    let unreadable = |error: io::Error| Failure::unreadable(&name(path), &error.to_string());
    let copied = |from: &mut dyn Read| {
        let unwritable = |error| Failure::cannot_write(&name(&std::env::temp_dir()), &error);
        Ok(Backup::copied(from, tempfile::tempfile().map_err(unwritable)?, &name(path)))
    };
    let backup = match path == Path::new("-") {
        true => copied(&mut io::stdin().lock())?,
        false => {
            let mut file = File::open(path).map_err(unreadable)?;
            if path.is_file() { Backup::of(file, &name(path)) } else { copied(&mut file)? }
        }
    };
    backup.map_err(|error| refused_backup(path, &error))
}

/// Restores a backup.
pub fn restore(args: &RestoreArgs, diagnostics: &Diagnostics) -> Result<Exit, Failure> {
    let backup = opened_backup(&args.file)?;
    let items = match args.item.as_slice() {
        [] => backup.items(),
        named => named.to_vec(),
    };
    let store = open(&args.folder, backup.control())?;
    backup.restore(&store, &author(), &items).map_err(|error| refused_backup(&args.file, &error))?;
    let names = items.iter().map(|item| item.name()).collect::<Vec<_>>();
    let folder = name(&args.folder);
    let said = match diagnostics.is_json() {
        true => json!({"folder": folder, "restored": names}).to_string(),
        false => {
            let named = [("folder", folder.into()), ("items", names.join(", ").into())];
            diagnostics.catalogue().label("label-memory-restored", &named)
        }
    };
    print(&format!("{said}\n"));
    Ok(Exit::Fine)
}

/// Takes a good state up.
pub fn recover(args: &RecoverArgs, diagnostics: &Diagnostics) -> Result<Exit, Failure> {
    let folder = &args.folder;
    let damage = match damage::check(folder) {
        Ok(commits) => {
            let named = [("file", name(folder).into()), ("commits", commits.to_string().into())];
            print(&format!("{}\n", diagnostics.catalogue().label("label-memory-whole", &named)));
            return Ok(Exit::Fine);
        }
        Err(OpenError::Damaged(damage)) => damage,
        Err(error) => return Err(unopened(folder, &error)),
    };
    let mut states = damage.states().iter();
    let state = match args.commit {
        None => states.next(),
        Some(commit) => states.find(|state| state.commits == commit),
    };
    let Some(state) = state.cloned() else {
        let alarm = Alarm::core(Fault::MemoryDamaged, Span::default());
        let detail = match args.commit {
            None => label(diagnostics, "label-memory-no-good-state"),
            Some(commits) => {
                let named = [("commits", commits.to_string().into())];
                diagnostics.catalogue().label("label-memory-no-such-state", &named)
            }
        };
        return Err(failure(alarm.with("detail", detail), Exit::Finding));
    };
    // A state that is whole says whose it is; a damaged memory need not.
    let control = state.control.clone();
    let recovered = damage.recover(&state, Settings::new(&control), &author());
    let (_store, aside) = recovered.map_err(|error| unopened(folder, &error))?;
    let said = match diagnostics.is_json() {
        true => json!({"folder": name(folder), "commit": state.commits, "damaged_files": name(&aside)})
            .to_string(),
        false => {
            let named = [
                ("commits", state.commits.to_string().into()),
                ("time", utc(state.time).into()),
                ("file", name(&aside).into()),
            ];
            diagnostics.catalogue().label("label-memory-recovered", &named)
        }
    };
    print(&format!("{said}\n"));
    Ok(Exit::Fine)
}

/// Sets a password.
pub fn password(args: &PasswordArgs, diagnostics: &Diagnostics) -> Result<Exit, Failure> {
    let mut line = String::new();
    let read = io::stdin().lock().take(LINE).read_line(&mut line);
    read.map_err(|error| Failure::unreadable("standard input", &error.to_string()))?;
    let password = line.trim_end_matches(['\n', '\r']);
    let control = match &args.dialect {
        Some(name) => {
            let dialect = dialects::by_name(name).ok_or_else(|| Failure::unknown_dialect(name))?;
            dialect.name.to_owned()
        }
        None => control_of(&args.folder)?,
    };
    let store = open(&args.folder, &control)?;
    // The parser lets 1 to 4 through.
    let level = Level::of(args.level.into()).unwrap_or(Level::Shop);
    store.set_password(&author(), level, password, Seat::Machine).map_err(|error| refused(&error))?;
    let named = [("level", f64::from(args.level).into())];
    print(&format!("{}\n", diagnostics.catalogue().label("label-memory-password-set", &named)));
    Ok(Exit::Fine)
}
