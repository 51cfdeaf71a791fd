//! Names of parameters, and complaints about them.

use crate::diagnostics::Diagnostics;
pub use ferrocut_desk::names::*;
use std::io::{self, Write};

/// Says on standard error what is wrong: a line for people, an object for programs.
pub fn complain(text: &str, diagnostics: &Diagnostics) {
    let mut out = io::stderr().lock();
    // Nobody is left to tell if standard error is closed.
    let _ = match diagnostics.is_json() {
        true => writeln!(out, "{}", serde_json::json!({ "severity": "error", "message": text })),
        false => {
            writeln!(out, "{}", diagnostics.catalogue().label("label-error", &[("text", text.into())]))
        }
    };
}
