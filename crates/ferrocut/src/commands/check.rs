//! `ferrocut check`: every finding of every file, not only the first.

use crate::cli::CheckArgs;
use crate::job::{Exit, Failure, Shop};
use crate::stdout;
use ferrocut_controller::Supervisor;
use ferrocut_desk::finding::point_at_word;
use ferrocut_interpreter::Options;
use rayon::prelude::*;
use std::io::{self, IsTerminal, Write};
use std::path::Path;

/// Findings of one file beyond which only their number is told.
const MOST_FINDINGS: usize = 200;

/// What was found in one file, ready to print.
struct Findings {
    text: Vec<u8>,
    count: usize,
    exit: Exit,
}

/// Runs the command.
pub fn run(args: &CheckArgs) -> Result<Exit, Failure> {
    let shop = Shop::open(&args.common)?;
    let colour = io::stdout().is_terminal() && std::env::var_os("NO_COLOR").is_none();
    let results: Vec<Findings> = args.files.par_iter().map(|file| check(&shop, file, colour)).collect();
    let mut out = stdout::lock();
    let mut exit = Exit::Fine;
    let mut total = 0;
    for found in &results {
        // A reader that went away is no fault of the programs.
        if out.write_all(&found.text).is_err() {
            break;
        }
        total += found.count;
        exit = exit.max(found.exit);
    }
    if !shop.diagnostics.is_json() {
        let arguments = [
            ("files", (results.len() as f64).into()),
            ("machine", shop.machine.name.as_str().into()),
            ("findings", (total as f64).into()),
        ];
        let _ = writeln!(out, "{}", shop.diagnostics.catalogue().label("label-checked", &arguments));
    }
    Ok(exit)
}

/// Checks one file.
fn check(shop: &Shop, path: &Path, colour: bool) -> Findings {
    let mut found = Findings { text: Vec::new(), count: 0, exit: Exit::Fine };
    let name = path.to_string_lossy();
    let mut job = match shop.job(path) {
        Ok(job) => job,
        Err(Failure { alarm, exit, programs, .. }) => {
            let programs = programs.as_deref();
            let _ = shop.diagnostics.write(&mut found.text, &alarm, &name, programs, colour);
            found.count = 1;
            found.exit = exit;
            return found;
        }
    };
    let warnings = job.take_warnings();
    job.tell(&shop.diagnostics);
    let mut supervisor = Supervisor::new(&shop.machine, job.dialect, shop.options().start);
    let mut interpreter = job.interpreter(Options { keep_going: true, ..shop.options() });
    interpreter.set_machine(std::sync::Arc::new(shop.machine.clone()));
    let mut pending = warnings;
    while supervisor.follow(&mut interpreter, &mut pending) {
        for mut alarm in pending.drain(..) {
            found.count += 1;
            found.exit = Exit::Finding;
            if found.count > MOST_FINDINGS {
                continue;
            }
            point_at_word(&mut alarm, &interpreter);
            let programs = Some(interpreter.programs());
            // Writing to memory cannot fail.
            let _ = shop.diagnostics.write(&mut found.text, &alarm, &name, programs, colour);
        }
    }
    if found.count > MOST_FINDINGS && !shop.diagnostics.is_json() {
        let further = [("count", ((found.count - MOST_FINDINGS) as f64).into())];
        let _ = writeln!(
            found.text,
            "{name}: {}\n",
            shop.diagnostics.catalogue().label("label-further", &further)
        );
    }
    found
}
