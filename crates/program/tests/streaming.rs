//! A flat program streams: memory does not grow with the file. Alone in its file, because the peak is
//! that of the whole process.

#![cfg(target_os = "linux")]
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

use ferrocut_program::{FileId, ProgramId, ProgramMemory, Syntax, Text};
use std::io::{BufWriter, Write};

/// The most memory that this process had, megabytes.
fn peak() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:")).unwrap();
    line.trim().trim_end_matches("kB").trim().parse::<u64>().unwrap() / 1024
}

fn read(memory: &mut ProgramMemory) -> usize {
    let (mut blocks, mut number) = (0, 0);
    while let Some(page) = memory.page(FileId(0), number).unwrap() {
        blocks += page.blocks.len();
        number += 1;
    }
    blocks
}

#[test]
fn memory_does_not_grow_with_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("big.nc");
    let mut out = BufWriter::new(std::fs::File::create(&path).unwrap());
    let blocks = (64 << 20) / 32;
    for i in 0..blocks {
        writeln!(out, "N{:08}X{:09.3}Y{:09.3}", i, f64::from(i) * 0.01, -f64::from(i) * 0.1).unwrap();
    }
    out.flush().unwrap();
    drop(out);
    std::fs::write(folder.path().join("main.nc"), "M98 P7\nM30\n").unwrap();

    let before = peak();
    let mut memory = ProgramMemory::open(&path, &Syntax::WORDS).unwrap();
    assert_eq!(read(&mut memory), blocks as usize);
    assert_eq!(memory.find_program(&ProgramId::Number(7)).unwrap(), None);
    drop(memory);
    // From a stream, as standard input is.
    let stream = Text::from_reader(std::fs::File::open(&path).unwrap()).unwrap();
    let mut memory = ProgramMemory::new("-", stream, &Syntax::WORDS);
    assert_eq!(read(&mut memory), blocks as usize);
    drop(memory);
    // Beside the main program, looked through for a number that it does not hold.
    let mut memory = ProgramMemory::open(&folder.path().join("main.nc"), &Syntax::WORDS).unwrap();
    assert_eq!(memory.find_program(&ProgramId::Number(7)).unwrap(), None);
    let grown = peak() - before;
    assert!(grown < 48, "{grown} MB more");
}
