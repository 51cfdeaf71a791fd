//! Interpreting a program of one million G01 blocks to steps, lexing included.

#![allow(clippy::unwrap_used)]

use ferrocut_interpreter::{Interpreter, Options, dialects};
use ferrocut_machine::Memory;
use ferrocut_program::{ProgramMemory, Text};

fn main() {
    divan::main();
}

fn program(blocks: usize) -> Vec<u8> {
    let mut text = b"G90 G54 G1 F3000\n".to_vec();
    for i in 0..blocks {
        let x = i as f64 * 0.01;
        text.extend_from_slice(
            format!("G01 X{:.3} Y{:.3} Z{:.3}\n", x % 400.0, (x * 0.1) % 300.0, x.sin()).as_bytes(),
        );
    }
    text.extend_from_slice(b"M30\n");
    text
}

#[divan::bench(sample_count = 10)]
fn one_million_g01_blocks(bencher: divan::Bencher) {
    let text = program(1_000_000);
    let dialect = dialects::by_name("gsk990mc").unwrap();
    bencher
        .counter(divan::counter::ItemsCount::new(1_000_000usize))
        .with_inputs(|| {
            let programs =
                ProgramMemory::new("bench", Text::from_bytes(text.clone()).unwrap(), dialect.syntax);
            Interpreter::new(dialect, programs, Memory::new("gsk990mc"), Options::default())
        })
        .bench_values(|interpreter| interpreter.filter(|step| step.is_ok()).count());
}
