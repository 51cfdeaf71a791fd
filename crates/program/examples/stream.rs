//! Reads a flat program of any size block by block and tells how long it took and how much memory.
//!
//! `cargo run --release -p ferrocut-program --example stream -- 1024` writes a program of 1024 MB to a
//! folder for temporary files, reads it page by page, and removes it.

use ferrocut_program::{FileId, ProgramMemory, Syntax, Text};
use std::error::Error;
use std::io::{BufWriter, Write};
use std::time::Instant;

fn main() -> Result<(), Box<dyn Error>> {
    let megabytes: u64 = std::env::args().nth(1).map_or(Ok(1024), |n| n.parse())?;
    let file = tempfile::Builder::new().suffix(".nc").tempfile()?;
    let size = write_program(file.as_file(), megabytes << 20)?;

    let start = Instant::now();
    let text = Text::open(file.path()).map_err(|e| format!("{e:?}"))?;
    let mut memory = ProgramMemory::new("stream.nc", text, &Syntax::WORDS);
    let (mut blocks, mut words, mut number) = (0u64, 0u64, 0);
    while let Some(page) = memory.page(FileId(0), number)? {
        blocks += page.blocks.len() as u64;
        words += page.words.len() as u64;
        number += 1;
    }
    let seconds = start.elapsed().as_secs_f64();
    println!("{size} bytes, {blocks} blocks, {words} words");
    println!("{seconds:.2} s, {:.1} million blocks/s", blocks as f64 / seconds / 1e6);
    match peak_memory() {
        Some(kilobytes) => println!("{:.1} MB of memory at most", kilobytes as f64 / 1024.0),
        None => println!("memory at most: not told by this system"),
    }
    Ok(())
}

/// Writes cutting moves until the file has this many bytes or some more; returns how many.
fn write_program(file: impl Write, bytes: u64) -> std::io::Result<u64> {
    let mut out = BufWriter::new(file);
    let mut written = 0;
    for i in 0u64.. {
        let x = i as f64 * 0.01;
        let block = format!("G01 X{:.3} Y{:.3} Z{:.3}\n", x % 400.0, (x * 0.1) % 300.0, x.sin());
        out.write_all(block.as_bytes())?;
        written += block.len() as u64;
        if written >= bytes {
            break;
        }
    }
    out.flush()?;
    Ok(written)
}

/// The most memory that this process had, kilobytes; Linux tells it.
fn peak_memory() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    line.trim().trim_end_matches("kB").trim().parse().ok()
}
