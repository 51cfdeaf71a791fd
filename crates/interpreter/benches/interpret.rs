//! Interpreting to steps, lexing included: flat programs, macro loops, subprogram calls.

#![allow(clippy::unwrap_used)]

use divan::counter::ItemsCount;
use ferrocut_interpreter::{Interpreter, Options, dialects};
use ferrocut_machine::Memory;
use ferrocut_program::{ProgramMemory, Text};

fn main() {
    divan::main();
}

fn interpreter(text: &[u8]) -> Interpreter {
    let dialect = dialects::by_name("gsk990mc").unwrap();
    let programs = ProgramMemory::new("bench", Text::from_bytes(text.to_vec()).unwrap(), dialect.syntax);
    Interpreter::new(dialect, programs, Memory::new("gsk990mc"), Options::default())
}

fn bench(bencher: divan::Bencher, text: &[u8], items: usize) {
    bencher
        .counter(ItemsCount::new(items))
        .with_inputs(|| interpreter(text))
        .bench_values(|interpreter| interpreter.filter(Result::is_ok).count());
}

#[divan::bench(sample_count = 10)]
fn one_million_g01_blocks(bencher: divan::Bencher) {
    let mut text = b"G90 G54 G1 F3000\n".to_vec();
    for i in 0..1_000_000 {
        let x = f64::from(i) * 0.01;
        let (x, y, z) = (x % 400.0, (x * 0.1) % 300.0, x.sin());
        text.extend_from_slice(format!("G01 X{x:.3} Y{y:.3} Z{z:.3}\n").as_bytes());
    }
    text.extend_from_slice(b"M30\n");
    bench(bencher, &text, 1_000_000);
}

#[divan::bench(sample_count = 5)]
fn one_million_passes_of_a_macro_loop(bencher: divan::Bencher) {
    let text = b"#1=0\nWHILE[#1 LT 1000000] DO1\n#1=#1+1\n#2=SIN[#1]*ABS[#1]\nEND1\nM30\n";
    bench(bencher, text, 1_000_000);
}

#[divan::bench(sample_count = 5)]
fn nine_hundred_thousand_subprogram_calls(bencher: divan::Bencher) {
    let text = b"M98 P10 L9000\nM30\nO10\nM98 P20 L100\nM99\nO20\n#1=1\nM99\n";
    bench(bencher, text, 900_000);
}
