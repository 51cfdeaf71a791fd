//! Lexing a program of one million G01 blocks.

#![allow(clippy::unwrap_used)]

use ferrocut_program::{FileId, ProgramMemory, Syntax, Text};

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
    bencher
        .counter(divan::counter::ItemsCount::new(1_000_000usize))
        .with_inputs(|| text.clone())
        .bench_values(|text| {
            let mut memory = ProgramMemory::new("bench", Text::from_bytes(text).unwrap(), &Syntax::WORDS);
            let mut blocks = 0;
            let mut number = 0;
            while let Some(page) = memory.page(FileId(0), number).unwrap() {
                blocks += page.blocks.len();
                number += 1;
            }
            blocks
        });
}
