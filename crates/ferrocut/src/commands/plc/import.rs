//! `ferrocut plc import`: PLCopen XML to a mnemonic list.

use super::{ImportArgs, Source};
use crate::commands::layout::print;
use crate::diagnostics::Diagnostics;
use crate::job::{Exit, Failure};
use crate::outputs;
use ferrocut_plc::{Limits, Program, list};
use std::path::Path;

/// Runs the command.
pub fn run(args: &ImportArgs, diagnostics: Diagnostics) -> Result<Exit, Failure> {
    if let Some(output) = &args.output {
        outputs::check(output, [&args.file])?;
    }
    let source = Source::open(&args.file)?;
    let (ladder, errors) = source.ladder();
    let text = list::to_text(&ladder);
    // The list is compiled before it is given away.
    if let Err(errors) = Program::from_ladder(ladder, &Limits::default(), errors) {
        source.report(&errors, &diagnostics);
        return Ok(Exit::Finding);
    }
    match args.output.as_deref().filter(|path| *path != Path::new("-")) {
        None => print(&text),
        Some(path) => {
            let name = path.to_string_lossy();
            std::fs::write(path, &text).map_err(|error| Failure::cannot_write(&name, &error))?;
            let file = [("file", name.as_ref().into())];
            print(&format!("{}\n", diagnostics.catalogue().label("label-written", &file)));
        }
    }
    Ok(Exit::Fine)
}
