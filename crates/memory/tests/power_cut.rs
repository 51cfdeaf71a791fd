//! Power that goes off within a commit: of what was written and not yet synchronised, the disk has any part.
//!
//! After each commit the files are copied. What the next commit changed in them is then laid over them by sectors, some
//! and some not, as far as the database can have asked for it by then: first the log, which it waits for before it
//! answers; with the whole log the file itself, where it was brought up to date; and the mark, which is behind all. What
//! comes of it must open, and hold every commit that was answered.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

mod common;

use common::{all, open, owner, settings, something};
use ferrocut_memory::Store;
use std::fs;
use std::path::Path;

/// What a disk writes whole.
const SECTOR: usize = 512;

struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % n.max(1) as u64) as usize
    }
}

/// The files of a memory at a moment.
#[derive(Clone, PartialEq)]
struct Files {
    database: Vec<u8>,
    log: Vec<u8>,
    mark: Vec<u8>,
}

impl Files {
    fn of(folder: &Path) -> Files {
        let read = |name: &str| fs::read(folder.join(name)).unwrap_or_default();
        Files { database: read("memory.db"), log: read("memory.db-wal"), mark: read("mark") }
    }

    fn write(&self, folder: &Path) {
        fs::create_dir_all(folder).unwrap();
        for (name, bytes) in
            [("memory.db", &self.database), ("memory.db-wal", &self.log), ("mark", &self.mark)]
        {
            fs::write(folder.join(name), bytes).unwrap();
        }
        let _ = fs::remove_file(folder.join("memory.db-shm"));
    }
}

/// Some of the sectors that differ, and perhaps not the whole length.
fn torn(old: &[u8], new: &[u8], random: &mut Random) -> Vec<u8> {
    let grown = new.len().saturating_sub(old.len()) / SECTOR;
    let length = if grown > 0 { old.len() + random.below(grown + 1) * SECTOR } else { old.len() };
    let likely = 1 + random.below(4);
    let mut bytes = old.to_vec();
    bytes.resize(length.max(old.len()), 0);
    for (sector, now) in bytes.chunks_mut(SECTOR).zip(new.chunks(SECTOR)) {
        let end = sector.len().min(now.len());
        if random.below(4) < likely {
            sector[..end].copy_from_slice(&now[..end]);
        }
    }
    bytes
}

fn commits() -> u32 {
    std::env::var("FERROCUT_POWER_CUTS").ok().and_then(|text| text.parse().ok()).unwrap_or(60)
}

#[test]
fn a_power_cut_within_a_commit_loses_nothing_that_was_answered() {
    let folder = tempfile::tempdir().unwrap();
    let live = folder.path().join("live");
    let store = open(&live);
    store.commit(&owner(), something(0)).unwrap();
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    let (mut before, mut old) = (all(&store), Files::of(&live));
    let mut marks = vec![old.mark.clone()];
    let (mut checkpoints, mut kept, mut taken_back) = (0, 0, 0);
    for n in 1.. {
        // Until the log was brought into the file, however large it becomes before.
        if n > commits() && (checkpoints > 0 || n > 1000) {
            break;
        }
        store.commit(&owner(), something(n)).unwrap();
        let (after, new) = (all(&store), Files::of(&live));
        let is_checkpoint = new.database != old.database;
        checkpoints += u32::from(is_checkpoint);
        let within_log = Files { log: torn(&old.log, &new.log, &mut random), ..old.clone() };
        let within_file = Files {
            database: torn(&old.database, &new.database, &mut random),
            log: new.log.clone(),
            ..old.clone()
        };
        // The mark is not waited for: it may be that of a commit long ago.
        let long_ago = marks[random.below(marks.len())].clone();
        let with_mark = Files { mark: long_ago, ..new.clone() };
        for (what, files, is_answered) in
            [("log", within_log, false), ("file", within_file, true), ("mark", with_mark, true)]
        {
            let cut = folder.path().join("cut");
            files.write(&cut);
            match Store::open(&cut, settings()) {
                Ok(store) => {
                    let found = all(&store);
                    let is_new = found == after;
                    assert!(
                        is_new || !is_answered && found == before,
                        "commit {n}, {what}: a commit is lost"
                    );
                    kept += u32::from(is_new);
                    taken_back += u32::from(!is_new);
                }
                Err(error) => panic!("commit {n}, {what}: {error:?}"),
            }
            fs::remove_dir_all(&cut).unwrap();
        }
        marks.push(new.mark.clone());
        (before, old) = (after, new);
    }
    // Commits were really torn, and the log was brought into the file.
    assert!(checkpoints > 0 && taken_back > 0 && kept > taken_back, "{checkpoints} {taken_back} {kept}");
}
