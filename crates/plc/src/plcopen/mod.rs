//! Ladder diagrams of PLCopen TC6 XML as a list of instructions.
//!
//! The way of the data: the file to POUs with their elements (`diagram`) → what leads to each element, as
//! contacts in series and parallel (`path`) → instructions (`networks`). What is not understood is a
//! fault with the line of its element.
//!
//! - A program POU named `LEVEL1` is level 1; all others are level 2, in the order of the file. A function or
//!   function block `P1`, `SP1` or `P001` is the subprogram of that number, which blocks of its name call.
//! - Signals are named by their address (`X8.4`), or declared: `%IX8.4` is X8.4, `%QX` Y and `%MX` R. A variable
//!   without an address gets a relay from R5000 on, in a byte that the document does not use itself. What a POU
//!   declares is its own; `externalVars` are those that are declared for all. A variable that power is led to is a
//!   coil.
//! - Blocks are the functions of the list. Their conditions come in by name (`RST`, `ACT`; `EN` is ACT), their
//!   parameters as `P1`, `P2` … from variables, and their W1 goes out. Of IEC 61131-3 `TON`, `TOF`, `TP`, `R_TRIG`,
//!   `F_TRIG`, `SR` and `RS` are known. `EN` beside another condition must be on always.
//! - Networks are carried out from top to bottom, by the position of what they lead to.

mod diagram;
mod networks;
mod path;
mod xml;

use crate::Limits;
use crate::compile::Program;
use crate::fault::{Error, Fault, Span};
use crate::list::Ladder;
use xml::Document;

/// Largest file, bytes: a ladder of 24,000 steps in the words of most editors.
const MOST_BYTES: usize = 8 << 20;

/// Whether bytes are XML, not ladder text.
pub fn is_xml(bytes: &[u8]) -> bool {
    let text = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    text.iter().find(|b| !b.is_ascii_whitespace()) == Some(&b'<')
}

/// Reads a file. Faults are put into `errors`; the ladder is of use only where there are none.
pub fn read(bytes: &[u8], errors: &mut Vec<Error>) -> Ladder {
    let start = Span { line: 1, ..Span::default() };
    let refused = |about: String| Error::about(Fault::FileFormat, start, about);
    if bytes.len() > MOST_BYTES {
        errors.push(refused(format!("> {} MiB", MOST_BYTES >> 20)));
        return Ladder::default();
    }
    let Ok(text) = std::str::from_utf8(bytes) else {
        errors.push(refused("UTF-8".to_owned()));
        return Ladder::default();
    };
    match Document::read(text) {
        Ok(document) => networks::ladder(&document, errors),
        Err(error) => {
            errors.push(error);
            Ladder::default()
        }
    }
}

impl Program {
    /// Compiles a ladder file, a list or PLCopen XML, which no list can begin like; all faults where there are any.
    pub fn from_file(bytes: &[u8], limits: &Limits) -> Result<Program, Vec<Error>> {
        match is_xml(bytes) {
            true => Program::from_plcopen(bytes, limits),
            false => Program::from_text(bytes, limits),
        }
    }

    /// Compiles a PLCopen file; all faults where there are any.
    pub fn from_plcopen(bytes: &[u8], limits: &Limits) -> Result<Program, Vec<Error>> {
        let mut errors = Vec::new();
        let ladder = read(bytes, &mut errors);
        Program::from_ladder(ladder, limits, errors)
    }
}
