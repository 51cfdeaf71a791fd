//! How many blocks a second are planned and interpolated, and what a servo period costs.
//!
//! The program is a finishing raster over a gently curved surface in G01 blocks of 0.25 mm, F6000.

use divan::counter::ItemsCount;
use ferrocut_geometry::Position;
use ferrocut_machine::Machine;
use ferrocut_motion::{Motion, Move, State};
use ferrocut_toolpath::PathMode;

fn main() {
    divan::main();
}

/// Rows of 100 mm, 0.5 mm apart, to and fro.
fn raster(blocks: usize) -> Vec<Move> {
    const STEP: f64 = 0.25;
    const ROW: usize = 400;
    let point = |k: usize| {
        let (row, column) = (k / ROW, k % ROW);
        let column = if row.is_multiple_of(2) { column } else { ROW - 1 - column };
        let (x, y) = (column as f64 * STEP, row as f64 * 0.5);
        Position::xyz(x, y, 3.0 * (x * 0.08).sin() * (y * 0.05).cos())
    };
    (1..=blocks).filter_map(|k| Move::line(point(k), 100.0, PathMode::Continuous, k as u64)).collect()
}

/// Runs the moves on a virtual clock; the number of periods.
fn run(machine: &Machine, moves: &[Move]) -> usize {
    let mut motion = Motion::new(machine, Position::ZERO);
    let mut left = moves.iter();
    let mut periods = 0;
    loop {
        while motion.free() > 0 {
            match left.next() {
                Some(m) => {
                    let _ = motion.push(m);
                }
                None => {
                    motion.finish();
                    break;
                }
            }
        }
        periods += 1;
        if divan::black_box(motion.tick()).state == State::Idle {
            return periods;
        }
    }
}

#[divan::bench(args = [100_000, 1_000_000], sample_count = 5, sample_size = 1)]
fn blocks(bencher: divan::Bencher, count: usize) {
    let machine = Machine::demo_mill();
    let moves = raster(count);
    bencher.counter(ItemsCount::new(count)).bench(|| run(&machine, &moves));
}

#[divan::bench(sample_count = 5, sample_size = 1)]
fn periods(bencher: divan::Bencher) {
    let machine = Machine::demo_mill();
    let moves = raster(100_000);
    let periods = run(&machine, &moves);
    bencher.counter(ItemsCount::new(periods)).bench(|| run(&machine, &moves));
}

/// A servo period of 1 s takes hundreds of blocks at once: what is left is planning.
#[divan::bench(args = [100_000], sample_count = 5, sample_size = 1)]
fn planning(bencher: divan::Bencher, count: usize) {
    let mut machine = Machine::demo_mill();
    machine.servo_period_ms = 1000.0;
    let moves = raster(count);
    bencher.counter(ItemsCount::new(count)).bench(|| run(&machine, &moves));
}
