//! A line of 100 MB, in a process of its own so that its memory can be told.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

use ferrocut_interpreter::{Interpreter, Options, dialects};
use ferrocut_machine::{AlarmId, Fault, Memory};
use ferrocut_program::ProgramMemory;
use std::io::Write;

/// Most memory that reading it may take, bytes; the whole line would take more.
const MOST_MEMORY: u64 = 60 << 20;

/// The most memory that this process had so far, where the system tells it.
fn peak() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|l| l.strip_prefix("VmHWM:"))?;
    line.trim().strip_suffix("kB")?.trim().parse::<u64>().ok().map(|kb| kb * 1024)
}

#[test]
fn a_line_of_100_mb_is_an_alarm_and_takes_no_memory() {
    let dialect = &dialects::gsk990mc::DIALECT;
    let mut file = tempfile::Builder::new().suffix(".nc").tempfile().unwrap();
    let piece = b"X1 Y2 Z3 ".repeat(1 << 12);
    file.write_all(b"O1\nG0 X1\n").unwrap();
    let mut written = 0;
    while written < 100 << 20 {
        file.write_all(&piece).unwrap();
        written += piece.len();
    }
    file.write_all(b"\nX2\nM30\n").unwrap();
    file.flush().unwrap();

    for keep_going in [false, true] {
        let programs = ProgramMemory::open(file.path(), dialect.syntax).unwrap();
        let options = Options { keep_going, ..Options::default() };
        let interpreter = Interpreter::new(dialect, programs, Memory::new(dialect.name), options);
        let found: Vec<_> =
            interpreter.map(|s| s.map(|s| s.span.line).map_err(|a| (a.id, a.fault, a.span.line))).collect();
        // GSK990MC appendix 2: 0026.
        let alarm = Err((AlarmId::Dialect("gsk990mc", 26), Fault::LineTooLong, 3));
        let expected = if keep_going { vec![Ok(2), alarm, Ok(4), Ok(5)] } else { vec![Ok(2), alarm] };
        assert_eq!(found, expected);
    }
    if let Some(peak) = peak() {
        assert!(peak < MOST_MEMORY, "took {} MB", peak >> 20);
    }
}
