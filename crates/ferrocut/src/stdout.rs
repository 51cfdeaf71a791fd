//! Standard output, and whether it took what was printed.
//!
//! A command prints to its end, and what could not be written is told once, by [`end`]: a full disk must not
//! pass for a result.

use crate::job::Failure;
use std::io::{self, StdoutLock, Write};
use std::sync::OnceLock;

/// The first write that failed.
static LOST: OnceLock<io::Error> = OnceLock::new();

/// Standard output, which keeps the first error.
pub struct Stdout(StdoutLock<'static>);

/// Standard output.
pub fn lock() -> Stdout {
    Stdout(io::stdout().lock())
}

/// Prints a text.
pub fn print(text: &str) {
    // What fails is kept for `end`.
    let _ = lock().write_all(text.as_bytes());
}

/// Writes what is left. A reader that went away is no fault of what was done; all else is.
pub fn end() -> Result<(), Failure> {
    let _ = lock().flush();
    match LOST.get() {
        Some(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(Failure::cannot_write("-", error)),
        _ => Ok(()),
    }
}

/// Whether something was printed that standard output did not take.
pub fn is_lost() -> bool {
    LOST.get().is_some()
}

fn kept<T>(done: io::Result<T>) -> io::Result<T> {
    done.map_err(|error| {
        let kind = error.kind();
        // An interrupted write is tried again by whoever writes.
        if kind != io::ErrorKind::Interrupted {
            let _ = LOST.set(error);
        }
        kind.into()
    })
}

impl Write for Stdout {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        kept(self.0.write(bytes))
    }

    fn flush(&mut self) -> io::Result<()> {
        kept(self.0.flush())
    }
}
