//! What a scan of the largest ladder of the GSK990MC costs, 4,700 steps of which some are functions.
//!
//! `scan_work [SCANS] [BOUND]`: 20,000 scans if not given, with inputs that change. The least of each run of a hundred
//! counts, so that what the computer does beside does not; with a bound in µs it is an error if half of these take more.
#![allow(missing_docs, clippy::unwrap_used)]

#[path = "../benches/shared/largest.rs"]
mod largest;

use ferrocut_plc::Address;
use std::hint::black_box;
use std::process::ExitCode;
use std::time::Instant;

/// Scans whose least time counts.
const RUN: usize = 100;

fn main() -> ExitCode {
    let mut words = std::env::args().skip(1).filter_map(|word| word.parse::<usize>().ok());
    let scans = words.next().unwrap_or(20_000);
    let bound = words.next();
    let mut plc = largest::plc(true);
    let inputs: Vec<Address> = (0..16).map(|n| Address::parse(&format!("X{}", n * 4)).unwrap()).collect();
    let mut times = Vec::with_capacity(scans);
    let mut value: u8 = 0;
    for _ in 0..scans.max(RUN) {
        value = value.wrapping_add(73);
        for input in &inputs {
            plc.memory_mut().set_byte(*input, value);
        }
        let began = Instant::now();
        black_box(plc.scan());
        times.push(began.elapsed().as_secs_f64() * 1e6);
    }
    let mut least: Vec<f64> =
        times.chunks(RUN).map(|run| run.iter().copied().fold(f64::INFINITY, f64::min)).collect();
    least.sort_by(f64::total_cmp);
    let median = least.get(least.len() / 2).copied().unwrap_or(f64::INFINITY);
    println!("{} steps: {median:.1} us a scan", largest::STEPS);
    match bound {
        Some(bound) if median > bound as f64 => {
            eprintln!("a scan is to take at most {bound} us");
            ExitCode::FAILURE
        }
        _ => ExitCode::SUCCESS,
    }
}
