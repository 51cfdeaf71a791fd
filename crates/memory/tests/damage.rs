//! Files are damaged in every way that a bad disk knows: what is read afterwards is right or said to be damaged.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::expect_used)]

mod common;

use common::{all, open, owner, settings, something};
use ferrocut_memory::{Backup, Contents, Error, Finding, Item, OpenError, Source, Store};
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::tempdir;

/// A repeatable source of random numbers.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    fn below(&mut self, n: usize) -> usize {
        (self.next() % n.max(1) as u64) as usize
    }
}

/// Damages bytes: bits turned, a sector of zeros or noise, an end cut off, a piece moved.
fn damage(bytes: &mut Vec<u8>, random: &mut Random) {
    if bytes.is_empty() {
        return;
    }
    match random.below(7) {
        0..=2 => {
            for _ in 0..=random.below(4) {
                let at = random.below(bytes.len());
                bytes[at] ^= 1 << random.below(8);
            }
        }
        3 => {
            let at = random.below(bytes.len());
            let end = (at + 512).min(bytes.len());
            bytes[at..end].fill(0);
        }
        4 => {
            let at = random.below(bytes.len());
            let end = (at + random.below(4096)).min(bytes.len());
            for byte in &mut bytes[at..end] {
                *byte = random.next() as u8;
            }
        }
        5 => bytes.truncate(random.below(bytes.len())),
        _ => {
            let (from, to) = (random.below(bytes.len()), random.below(bytes.len()));
            let len = random.below(4096).min(bytes.len() - from.max(to));
            bytes.copy_within(from..from + len, to);
        }
    }
}

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap() {
        let entry = entry.unwrap();
        let target = to.join(entry.file_name());
        match entry.file_type().unwrap().is_dir() {
            true => copy(&entry.path(), &target),
            false => drop(fs::copy(entry.path(), target).unwrap()),
        }
    }
}

/// A memory as a kill leaves it, with a long write-ahead log and two snapshots; and the states that it went
/// through.
struct Scene {
    folder: tempfile::TempDir,
    states: Vec<Contents>,
}

fn scene() -> Scene {
    let folder = tempdir().unwrap();
    let live = folder.path().join("live");
    let mut states = Vec::new();
    let store = open(&live);
    states.push(all(&store));
    // The snapshot of the start is made beside, and is of this state.
    let is_there = |entry: &fs::DirEntry| entry.path().extension().is_some_and(|kind| kind == "db");
    let made =
        || fs::read_dir(live.join("good")).is_ok_and(|entries| entries.flatten().any(|e| is_there(&e)));
    while !made() {
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    for n in 1..=40 {
        store.commit(&owner(), something(n)).unwrap();
        states.push(all(&store));
        if n == 10 || n == 25 {
            store.snapshot().unwrap();
        }
    }
    // As it is at this moment, with the log not yet in the file; and as it is after power was turned off in order.
    copy(&live, &folder.path().join("killed"));
    drop(store);
    copy(&live, &folder.path().join("closed"));
    Scene { folder, states }
}

impl Scene {
    fn fresh(&self, name: &str) -> PathBuf {
        self.copy_of("killed", name)
    }

    fn copy_of(&self, which: &str, name: &str) -> PathBuf {
        let to = self.folder.path().join(name);
        if to.exists() {
            fs::remove_dir_all(&to).unwrap();
        }
        copy(&self.folder.path().join(which), &to);
        to
    }

    fn last(&self) -> &Contents {
        self.states.last().unwrap()
    }
}

/// What became of a damaged memory.
#[derive(PartialEq, Eq, Hash, Debug, Clone, Copy)]
enum Fate {
    /// It held nothing that was damaged.
    Right,
    /// It was said, and a good state taken.
    Recovered,
    /// It was said, and there was no good state.
    Lost,
}

/// Opens a memory; what it holds must be the last state, or the damage must be said.
fn open_damaged(scene: &Scene, folder: &Path, what: &str) -> Fate {
    match Store::open(folder, settings()) {
        Ok(store) => {
            assert!(all(&store) == *scene.last(), "{what}: wrong data without a word");
            Fate::Right
        }
        Err(OpenError::Damaged(damage)) => {
            assert!(!damage.findings().is_empty());
            let Some(state) = damage.states().first().cloned() else { return Fate::Lost };
            let (store, aside) = damage.recover(&state, settings(), &owner()).unwrap();
            assert!(aside.is_dir());
            let mut found = all(&store);
            let told = found.log.remove(0);
            assert_eq!((told.item.as_str(), told.name.as_str()), ("memory", "recovered"));
            assert!(scene.states.contains(&found), "{what}: {state:?} is no state that there ever was");
            drop(store);
            // It is whole again.
            drop(Store::open(folder, settings()).unwrap());
            Fate::Recovered
        }
        Err(error) => panic!("{what}: {error:?}"),
    }
}

fn rounds() -> usize {
    std::env::var("FERROCUT_DAMAGES").ok().and_then(|text| text.parse().ok()).unwrap_or(40)
}

#[test]
fn damage_is_said_and_the_last_good_state_is_there() {
    let scene = scene();
    let mut random = Random(0x2545_F491_4F6C_DD1D);
    let mut fates = std::collections::HashMap::new();
    for round in 0..rounds() {
        for (which, name) in [
            ("closed", "memory.db"),
            ("killed", "memory.db"),
            ("killed", "memory.db-wal"),
            ("killed", "memory.db-shm"),
            ("killed", "mark"),
        ] {
            let folder = scene.copy_of(which, "damaged");
            let path = folder.join(name);
            let mut bytes = fs::read(&path).unwrap();
            damage(&mut bytes, &mut random);
            fs::write(&path, &bytes).unwrap();
            let fate = open_damaged(&scene, &folder, &format!("round {round}, {name}"));
            assert_ne!(fate, Fate::Lost, "round {round}, {name}: two snapshots are whole");
            *fates.entry((name, fate)).or_insert(0) += 1;
        }
    }
    println!("{fates:?}");
    // Damage was really done, and told.
    assert!(fates[&("memory.db", Fate::Recovered)] > 0 && fates[&("memory.db-wal", Fate::Recovered)] > 0);
    // What is rebuilt at each start is no damage.
    assert!(!fates.contains_key(&("memory.db-shm", Fate::Recovered)));
}

#[test]
fn damage_everywhere_is_said() {
    let scene = scene();
    let mut random = Random(0x1234_5678_9ABC_DEF1);
    for round in 0..rounds() / 2 {
        let folder = scene.fresh("damaged");
        let mut files = vec![folder.join("memory.db"), folder.join("memory.db-wal"), folder.join("mark")];
        files.extend(fs::read_dir(folder.join("good")).unwrap().map(|e| e.unwrap().path()));
        for path in files {
            let mut bytes = fs::read(&path).unwrap();
            damage(&mut bytes, &mut random);
            fs::write(&path, &bytes).unwrap();
        }
        open_damaged(&scene, &folder, &format!("round {round}"));
    }
}

/// The log and the mark together: what is left looks like a control that was never used, but for its snapshots.
#[test]
fn a_memory_that_lost_every_commit_and_its_mark_is_not_a_new_one() {
    let scene = scene();
    let empty = scene.folder.path().join("empty");
    drop(open(&empty));
    let folder = scene.fresh("emptied");
    for rest in ["memory.db-wal", "memory.db-shm"] {
        let _ = fs::remove_file(folder.join(rest));
    }
    fs::copy(empty.join("memory.db"), folder.join("memory.db")).unwrap();
    fs::write(folder.join("mark"), [0xA5; 32]).unwrap();
    match Store::open(&folder, settings()) {
        Err(OpenError::Damaged(damage)) => assert_eq!(damage.findings(), [Finding::MarkLost]),
        other => panic!("{:?}", other.map(|_| ())),
    }
}

#[test]
fn a_file_that_vanished_is_damage_and_no_new_control() {
    let scene = scene();
    for (name, wanted) in [("memory.db", Finding::Missing), ("mark", Finding::MarkLost)] {
        let folder = scene.fresh("vanished");
        fs::remove_file(folder.join(name)).unwrap();
        match Store::open(&folder, settings()) {
            Err(OpenError::Damaged(damage)) => assert_eq!(damage.findings(), [wanted]),
            other => panic!("{name}: {:?}", other.map(|_| ())),
        }
        assert_eq!(open_damaged(&scene, &folder, name), Fate::Recovered);
    }
    // The log alone: the file is whole and older, which nobody but the mark can tell.
    let folder = scene.fresh("vanished");
    fs::remove_file(folder.join("memory.db-wal")).unwrap();
    let Err(OpenError::Damaged(damage)) = Store::open(&folder, settings()) else { panic!() };
    assert!(
        matches!(damage.findings(), [Finding::CommitsLost { found: 0..40, reported: 40 }]),
        "{:?}",
        damage.findings()
    );
    assert_eq!(damage.states()[0].missing, Some(15));
}

#[test]
fn the_newest_good_state_comes_first() {
    let scene = scene();
    let folder = scene.fresh("cut");
    // The log loses its last commit: the database itself has the most that is left.
    let path = folder.join("memory.db-wal");
    let bytes = fs::read(&path).unwrap();
    fs::write(&path, &bytes[..bytes.len() - 100]).unwrap();
    let Err(OpenError::Damaged(damage)) = Store::open(&folder, settings()) else { panic!() };
    let sources: Vec<_> =
        damage.states().iter().map(|s| (s.source == Source::Database, s.commits, s.missing)).collect();
    assert_eq!(
        sources,
        [(true, 39, Some(1)), (false, 25, Some(15)), (false, 10, Some(30)), (false, 0, Some(40))]
    );
    let state = damage.states()[1].clone();
    let (store, aside) = damage.recover(&state, settings(), &owner()).unwrap();
    let mut found = all(&store);
    found.log.remove(0);
    assert!(found == scene.states[25]);
    // The damaged files are kept, byte for byte.
    assert_eq!(fs::read(aside.join("memory.db-wal")).unwrap(), &bytes[..bytes.len() - 100]);
}

#[test]
fn snapshots_are_rotated_and_a_damaged_database_makes_none() {
    let folder = tempdir().unwrap();
    let store = open(folder.path());
    for n in 1..=6 {
        store.commit(&owner(), something(n)).unwrap();
        store.snapshot().unwrap();
        // Of the same state there is one.
        store.snapshot().unwrap();
    }
    let names = || {
        let mut names: Vec<_> = fs::read_dir(folder.path().join("good"))
            .unwrap()
            .map(|e| e.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    };
    assert_eq!(names(), ["00000000000000000004.db", "00000000000000000005.db", "00000000000000000006.db"]);
    drop(store);
    let path = folder.path().join("memory.db");
    let store = open(folder.path());
    let text = all(&store).programs["O1234"].text.clone();
    // Power stays on while the disk turns a bit of a program.
    let mut bytes = fs::read(&path).unwrap();
    let at = bytes.windows(text.len()).position(|w| w == text).unwrap();
    bytes[at] ^= 1;
    fs::write(&path, &bytes).unwrap();
    store.commit(&owner(), vec![common::variable(777, Some(1.0))]).unwrap();
    assert!(matches!(store.snapshot(), Err(Error::Damaged(_))));
    assert!(store.reader().check(folder.path()).is_err());
    drop(store);
    assert_eq!(names(), ["00000000000000000004.db", "00000000000000000005.db", "00000000000000000006.db"]);
    assert!(matches!(Store::open(folder.path(), settings()), Err(OpenError::Damaged(_))));
}

#[test]
fn a_damaged_backup_changes_nothing() {
    let scene = scene();
    let store = open(&scene.fresh("from"));
    let file = scene.folder.path().join("all.backup");
    store.reader().back_up(&file, &Item::ALL).unwrap();
    let whole = fs::read(&file).unwrap();
    let mut random = Random(0xDEAD_BEEF_CAFE_F00D);
    let bad = scene.folder.path().join("bad.backup");
    for round in 0..rounds() * 50 {
        let mut bytes = whole.clone();
        damage(&mut bytes, &mut random);
        if bytes == whole {
            continue;
        }
        fs::write(&bad, &bytes).unwrap();
        let error = Backup::open(&bad).map(|_| ()).expect_err(&format!("round {round}"));
        let is_said = matches!(error, Error::BackupDamaged(_) | Error::NotABackup | Error::NewerBackup(_));
        assert!(is_said, "round {round}: {error:?}");
    }
    // Changed between judging and writing.
    let backup = Backup::open(&file).unwrap();
    let text = String::from_utf8(whole).unwrap();
    fs::write(&file, text.replacen("PART 40", "PART 41", 1)).unwrap();
    let before = all(&store);
    assert!(matches!(backup.restore(&store, &owner(), &[Item::Programs]), Err(Error::BackupDamaged(_))));
    assert!(all(&store) == before);
}
