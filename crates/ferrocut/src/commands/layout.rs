//! Text in columns, and how it is printed.

pub use ferrocut_desk::layout::*;
use std::io::{self, Write};

/// Prints a text. A reader that went away is no fault of what was done.
pub fn print(text: &str) {
    let _ = io::stdout().lock().write_all(text.as_bytes());
}
