//! Copies of the last good states, in the folder `good`, each named by the number of its last commit.
//!
//! A copy counts once it was read back and found whole; then the oldest goes. A database that has become damaged
//! while it was in use therefore never takes the place of a good state.

use crate::database::{Access, Database, Identity};
use crate::error::{Error, Finding};
use crate::migrate::tables_of;
use std::fs::{self, File};
use std::path::{Path, PathBuf};

/// The folder of the snapshots.
pub const FOLDER: &str = "good";

/// The snapshots of a memory with the numbers of their last commits, the newest first.
pub fn list(folder: &Path) -> Vec<(u64, PathBuf)> {
    let Ok(entries) = fs::read_dir(folder.join(FOLDER)) else { return Vec::new() };
    let mut found: Vec<(u64, PathBuf)> = entries
        .filter_map(|entry| {
            let path = entry.ok()?.path();
            let commits = path.file_name()?.to_str()?.strip_suffix(".db")?.parse().ok()?;
            Some((commits, path))
        })
        .collect();
    found.sort_by_key(|(commits, _)| std::cmp::Reverse(*commits));
    found
}

/// Copies the database into a snapshot, unless the newest one is of the same state, and keeps the `most` newest.
/// Says the number of its last commit.
pub fn take(folder: &Path, database: &Database, most: usize) -> Result<u64, Error> {
    let commits = database.commits_now()?;
    let existing = list(folder);
    // One that has become damaged is made anew.
    if let Some((newest, path)) = existing.first()
        && *newest == commits
        && Database::verify(path, Access::Untouched, tables_of).is_ok()
    {
        return Ok(commits);
    }
    let good = folder.join(FOLDER);
    fs::create_dir_all(&good)?;
    let part = good.join("new.part");
    remove_if_there(&part)?;
    let copied = copy(database, &part);
    if copied.is_err() {
        // The error that counts is the one at hand.
        let _ = fs::remove_file(&part);
    }
    let identity = copied?;
    fs::rename(&part, good.join(format!("{:020}.db", identity.commits)))?;
    sync_folder(&good)?;
    for (_, path) in list(folder).into_iter().skip(most.max(1)) {
        fs::remove_file(path)?;
    }
    Ok(identity.commits)
}

fn copy(database: &Database, part: &Path) -> Result<Identity, Error> {
    database.copy_to(part)?;
    let identity = Database::verify(part, Access::Untouched, tables_of)
        .map_err(|verdict| Error::damaged(Finding::Structure(format!("{verdict:?}"))))?;
    File::open(part)?.sync_all()?;
    Ok(identity)
}

/// Removes a file that may not be there.
pub fn remove_if_there(path: &Path) -> Result<(), Error> {
    match fs::remove_file(path) {
        Err(error) if error.kind() != std::io::ErrorKind::NotFound => Err(error.into()),
        _ => Ok(()),
    }
}

/// Waits until the disk has the names of a folder.
pub fn sync_folder(folder: &Path) -> Result<(), Error> {
    Ok(File::open(folder)?.sync_all()?)
}
