//! What a scan of a large ladder costs: 4,700 steps, the most that the GSK990MC holds, in one period.

#![allow(missing_docs, clippy::unwrap_used, clippy::indexing_slicing)]

#[path = "shared/largest.rs"]
mod largest;

use divan::counter::ItemsCount;
use ferrocut_plc::Address;
use largest::{STEPS, plc};

fn main() {
    divan::main();
}

/// Inputs that change from scan to scan.
fn bench(bencher: divan::Bencher, functions: bool, watched: bool) {
    let mut plc = plc(functions);
    plc.watch(watched);
    let inputs: Vec<Address> = (0..16).map(|n| Address::parse(&format!("X{}", n * 4)).unwrap()).collect();
    let mut n: u8 = 0;
    bencher.counter(ItemsCount::new(STEPS)).bench_local(|| {
        n = n.wrapping_add(73);
        for input in &inputs {
            plc.memory_mut().set_byte(*input, n);
        }
        plc.scan()
    });
}

#[divan::bench(sample_count = 200, sample_size = 50)]
fn contacts_and_coils(bencher: divan::Bencher) {
    bench(bencher, false, false);
}

#[divan::bench(sample_count = 200, sample_size = 50)]
fn with_functions(bencher: divan::Bencher) {
    bench(bencher, true, false);
}

#[divan::bench(sample_count = 200, sample_size = 50)]
fn with_functions_watched(bencher: divan::Bencher) {
    bench(bencher, true, true);
}
