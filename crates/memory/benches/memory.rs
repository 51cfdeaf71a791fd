//! What durability costs: a commit alone, a burst, a start.
#![allow(missing_docs, clippy::unwrap_used)]

use divan::Bencher;
use ferrocut_machine::ToolOffset;
use ferrocut_machine::setup::VariableName;
use ferrocut_memory::{Author, Change, Settings, Store};
use std::path::Path;

fn main() {
    divan::main();
}

fn open(folder: &Path) -> Store {
    Store::open(folder, Settings::new("gsk990mc")).unwrap()
}

fn variable(n: u32) -> Vec<Change> {
    vec![Change::Variable { name: VariableName::Number(500 + n % 500), value: Some(f64::from(n)) }]
}

fn part() -> Author {
    Author::Program { name: "O1".to_owned() }
}

/// One change, waited for.
#[divan::bench]
fn commit(bencher: Bencher) {
    let folder = tempfile::tempdir().unwrap();
    let store = open(folder.path());
    let mut n = 0;
    bencher.bench_local(|| {
        n += 1;
        store.commit(&part(), variable(n)).unwrap()
    });
}

/// A thousand changes of a loop, durable at its end.
#[divan::bench(sample_count = 20)]
fn burst_of_1000(bencher: Bencher) {
    let folder = tempfile::tempdir().unwrap();
    let store = open(folder.path());
    bencher.bench_local(|| {
        for n in 0..1000 {
            store.put(&part(), variable(n)).unwrap();
        }
        store.flush().unwrap()
    });
}

/// A start with 255 offsets, 500 variables, 1000 entries of the log, and as many MB of programs.
#[divan::bench(sample_count = 20, args = [1, 10, 100])]
fn start(bencher: Bencher, megabytes: usize) {
    let folder = tempfile::tempdir().unwrap();
    {
        let store = open(folder.path());
        let owner = Author::Maintenance { name: "bench".to_owned() };
        for n in 0..500u32 {
            store.put(&owner, variable(n)).unwrap();
            let number = u16::try_from(n % 255 + 1).unwrap();
            let offset = ToolOffset { length: f64::from(n) + 0.5, ..ToolOffset::ZERO };
            store.put(&owner, vec![Change::Offset { number, offset }]).unwrap();
        }
        for n in 0..megabytes {
            let text = b"G1 X12.345 Y-67.890 Z0.1\n".repeat(40_000);
            store
                .put(&owner, vec![Change::Program { name: format!("O{n}"), text, comment: String::new() }])
                .unwrap();
        }
        store.flush().unwrap();
    }
    bencher.with_inputs(|| ()).bench_local_values(|()| open(folder.path()));
}
