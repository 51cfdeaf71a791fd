//! What a servo period of moving by hand costs: nine axes on their way, and nine that get a new command in
//! every period, which is the worst that can be asked for.

use divan::counter::ItemsCount;
use ferrocut_geometry::{Axis, Position};
use ferrocut_machine::{AxisConfig, Machine};
use ferrocut_motion::Jog;
use ferrocut_motion::jog::Surplus;

fn main() {
    divan::main();
}

const PERIODS: u32 = 20_000;

fn nine_axes() -> Jog {
    let mut machine = Machine::demo_mill();
    let model = machine.axes.first().cloned();
    let axis = |name: &Axis| model.clone().map(|axis| AxisConfig { name: *name, ..axis });
    machine.axes = Axis::ALL.iter().flat_map(axis).collect();
    Jog::new(&machine, Position::ZERO)
}

#[divan::bench(sample_count = 20, sample_size = 1)]
fn on_their_way(bencher: divan::Bencher) {
    bencher.counter(ItemsCount::new(PERIODS)).with_inputs(nine_axes).bench_refs(|jog| {
        for axis in Axis::ALL {
            jog.run(axis, 10.0);
        }
        for _ in 0..PERIODS {
            divan::black_box(jog.tick());
        }
    });
}

#[divan::bench(sample_count = 20, sample_size = 1)]
fn a_new_place_for_each_in_every_period(bencher: divan::Bencher) {
    bencher.counter(ItemsCount::new(PERIODS)).with_inputs(nine_axes).bench_refs(|jog| {
        for k in 0..PERIODS {
            let back = if k / 300 % 2 == 0 { 1 } else { -1 };
            for (i, axis) in (0i64..).zip(Axis::ALL) {
                jog.wheel(axis, back * (1 + i), 0.1, 100.0, Surplus::Kept);
            }
            divan::black_box(jog.tick());
        }
    });
}
