//! A process that writes heavily is killed at random instants: nothing that it was told is durable may be lost,
//! nothing half of a batch be there, and every start must succeed.
//!
//! `cargo test` kills 200 times; `FERROCUT_KILLS=1000` (as `.ci/run` has it) as often as it says.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::expect_used)]

mod common;

use common::{CONTROL, all, something, variable};
use ferrocut_memory::{AlarmEntry, Author, Change, Contents, Settings, Store};
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};
use tempfile::tempdir;

/// Names the folder to the child.
const FOLDER: &str = "FERROCUT_KILL_FOLDER";

/// Snapshots come so often that kills meet them too.
fn settings() -> Settings {
    Settings { snapshot_every: Duration::from_millis(7), ..Settings::new(CONTROL) }
}

/// What the child writes as its batch `n`. #1000 holds the number.
fn batch(n: u32) -> Vec<Change> {
    let mut changes = something(n);
    changes.push(variable(1000, Some(f64::from(n))));
    let id = "FC-0302".to_owned();
    changes.push(Change::Alarm(AlarmEntry {
        time: n.into(),
        id,
        program: String::new(),
        line: n,
        arguments: vec![("axis".into(), "X".into())],
    }));
    changes
}

/// The batch that the memory has come to.
fn reached(contents: &Contents) -> u32 {
    contents.variables.get(&common::number(1000)).map_or(0, |value| *value as u32)
}

/// The child: writes batch after batch, some with a wait and some in bursts, and says which are durable.
#[test]
#[ignore = "the child of the kill test"]
fn child() {
    let Some(folder) = std::env::var_os(FOLDER) else { return };
    let store = Store::open(Path::new(&folder), settings()).unwrap();
    let mut n = reached(&all(&store));
    loop {
        if n % 16 < 8 {
            n += 1;
            store.commit(&Author::Control, batch(n)).unwrap();
        } else {
            let burst: Vec<_> =
                (n + 1..=n + 8).map(|m| store.begin(&Author::Control, batch(m)).unwrap()).collect();
            for pending in burst {
                pending.wait().unwrap();
            }
            n += 8;
        }
        eprintln!("durable {n}");
    }
}

/// Memory as it must be after batch `n`, grown from the last one that was compared.
struct Wanted {
    store: Store,
    n: u32,
    _folder: tempfile::TempDir,
}

impl Wanted {
    fn at(&mut self, n: u32) -> Contents {
        for m in self.n + 1..=n {
            self.store.put(&Author::Control, batch(m)).unwrap();
        }
        self.store.flush().unwrap();
        self.n = n;
        let mut contents = all(&self.store);
        timeless(&mut contents);
        contents
    }
}

fn timeless(contents: &mut Contents) {
    for program in contents.programs.values_mut() {
        (program.created, program.changed) = (0, 0);
    }
    for entry in &mut contents.log {
        entry.time = 0;
    }
}

#[test]
fn no_durable_value_is_lost_when_the_process_is_killed() {
    let kills: u32 = std::env::var("FERROCUT_KILLS").ok().and_then(|text| text.parse().ok()).unwrap_or(200);
    let folder = tempdir().unwrap();
    let other = tempdir().unwrap();
    let mut wanted =
        Wanted { store: Store::open(other.path(), Settings::new(CONTROL)).unwrap(), n: 0, _folder: other };
    let mut random = 0x9E37_79B9_7F4A_7C15u64;
    let mut all_told = 0;
    let begin = Instant::now();
    let (mut during_writing, mut longest_start) = (0, Duration::ZERO);
    for kill in 0u32.. {
        if during_writing >= kills {
            break;
        }
        let mut child = Command::new(std::env::current_exe().unwrap())
            .args(["--exact", "child", "--ignored", "--nocapture"])
            .env(FOLDER, folder.path())
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let acknowledged = BufReader::new(child.stderr.take().unwrap());
        random ^= random << 13;
        random ^= random >> 7;
        random ^= random << 17;
        let (tell, told) = std::sync::mpsc::channel();
        let reader = std::thread::spawn(move || {
            let (mut durable, mut said) = (None, Vec::new());
            for line in acknowledged.lines() {
                let line = line.unwrap();
                match line.strip_prefix("durable ").and_then(|n| n.parse::<u32>().ok()) {
                    Some(n) => {
                        durable = Some(n);
                        // After the first nobody waits for it.
                        let _ = tell.send(());
                    }
                    None => said.push(line),
                }
            }
            (durable, said)
        });
        // Nine of ten kills meet the writing, the others the start; only the former count.
        if kill % 10 != 9 {
            told.recv_timeout(Duration::from_secs(60)).expect("the child writes");
        }
        std::thread::sleep(Duration::from_micros(random % 25_000));
        child.kill().unwrap();
        let status = child.wait().unwrap();
        let (durable, said) = reader.join().unwrap();
        during_writing += u32::from(durable.is_some());
        let durable = durable.unwrap_or(0);
        // It ended by the signal and not by a panic of its own.
        assert!(status.code().is_none(), "kill {kill}: {status} {said:?}");
        // In between the memory is opened and compared here, so that every kind of start follows a kill.
        if kill % 2 == 0 {
            let at = Instant::now();
            let store = Store::open(folder.path(), settings())
                .unwrap_or_else(|error| panic!("kill {kill}: the start failed: {error:?}"));
            longest_start = longest_start.max(at.elapsed());
            let mut found = all(&store);
            timeless(&mut found);
            let n = reached(&found);
            assert!(n >= durable.max(all_told), "kill {kill}: {durable} was durable, {n} is there");
            // Eight may have been under way, and the word of eight be on its way to us.
            assert!(found == wanted.at(n), "kill {kill}: not what batch {n} left");
            all_told = n;
        } else {
            all_told = all_told.max(durable);
        }
    }
    println!(
        "{during_writing} kills of writing in {:.1} s; {all_told} batches; longest start {:.1} ms",
        begin.elapsed().as_secs_f64(),
        longest_start.as_secs_f64() * 1e3
    );
    assert!(all_told > kills, "hardly anything was written: {all_told}");
    let leftovers: Vec<_> =
        std::fs::read_dir(folder.path()).unwrap().map(|e| e.unwrap().file_name()).collect();
    assert!(leftovers.iter().all(|name| !name.to_string_lossy().starts_with("damaged")), "{leftovers:?}");
}
