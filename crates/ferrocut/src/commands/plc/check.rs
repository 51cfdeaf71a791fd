//! `ferrocut plc check`: every fault of every ladder.

use super::{CheckArgs, MOST_FAULTS, Source, alarm};
use crate::diagnostics::Diagnostics;
use crate::job::{Exit, Failure};
use crate::stdout;
use ferrocut_plc::Program;
use serde::Serialize;
use std::io::{self, IsTerminal, Write};

/// What is said of a ladder without a fault.
#[derive(Serialize)]
struct Fine<'a> {
    file: &'a str,
    steps: u32,
    first_level_steps: u32,
    signals: usize,
}

/// Runs the command.
pub fn run(args: &CheckArgs, diagnostics: Diagnostics) -> Result<Exit, Failure> {
    let colour = io::stdout().is_terminal() && std::env::var_os("NO_COLOR").is_none();
    let mut out = stdout::lock();
    let mut exit = Exit::Fine;
    for path in &args.files {
        let source = match Source::open(path) {
            Ok(source) => source,
            Err(failure) => {
                diagnostics.report(&failure.alarm, "", None);
                exit = Exit::WrongUse;
                continue;
            }
        };
        // A reader that went away is no fault of the ladder.
        let _ = match source.compile() {
            Ok(program) => fine(&mut out, &source, &program, &diagnostics),
            Err(errors) => {
                exit = exit.max(Exit::Finding);
                let text = source.text();
                errors
                    .iter()
                    .take(MOST_FAULTS)
                    .try_for_each(|error| {
                        diagnostics.write(&mut out, &alarm(error), &source.name, text.as_ref(), colour, None)
                    })
                    .and_then(|()| match diagnostics.is_json() {
                        true => Ok(()),
                        false => {
                            let count = [("count", (errors.len() as f64).into())];
                            let count = diagnostics.catalogue().label("label-ladder-faults", &count);
                            writeln!(out, "{}: {count}", source.name)
                        }
                    })
            }
        };
    }
    Ok(exit)
}

fn fine(
    out: &mut impl Write,
    source: &Source,
    program: &Program,
    diagnostics: &Diagnostics,
) -> io::Result<()> {
    let fine = Fine {
        file: &source.name,
        steps: program.steps(),
        first_level_steps: program.first_level_steps(),
        signals: program.symbols().len(),
    };
    if diagnostics.is_json() {
        serde_json::to_writer(&mut *out, &fine)?;
        return out.write_all(b"\n");
    }
    let arguments = [
        ("file", fine.file.into()),
        ("steps", f64::from(fine.steps).into()),
        ("first", f64::from(fine.first_level_steps).into()),
        ("signals", (fine.signals as f64).into()),
    ];
    writeln!(out, "{}", diagnostics.catalogue().label("label-ladder-checked", &arguments))
}
