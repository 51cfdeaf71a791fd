//! `ferrocut check`: every finding of every file, not only the first.

use crate::cli::CheckArgs;
use crate::job::{Exit, Failure, Shop};
use crate::stdout;
use ferrocut_controller::Supervisor;
use ferrocut_desk::finding::{AllFound, Found};
use ferrocut_interpreter::Options;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use rayon::prelude::*;
use std::io::{self, IsTerminal, Write};
use std::path::Path;
use std::time::Duration;

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
    let bar = ProgressBar::with_draw_target(Some(args.files.len() as u64), ProgressDrawTarget::stderr());
    if let Ok(style) = ProgressStyle::with_template("{spinner} {pos}/{len}  {elapsed}  {msg}") {
        bar.set_style(style);
    }
    bar.enable_steady_tick(Duration::from_millis(100));
    let results: Vec<Findings> = args.files.par_iter().map(|file| check(&shop, file, colour, &bar)).collect();
    bar.finish_and_clear();
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

/// Checks one file, and shows on the bar that it is at it.
fn check(shop: &Shop, path: &Path, colour: bool, bar: &ProgressBar) -> Findings {
    bar.set_message(path.to_string_lossy().into_owned());
    let mut found = Findings { text: Vec::new(), count: 0, exit: Exit::Fine };
    let name = path.to_string_lossy();
    let mut job = match shop.job(path) {
        Ok(job) => job,
        Err(Failure { alarm, exit, programs, .. }) => {
            let programs = programs.as_deref();
            let _ = shop.diagnostics.write(&mut found.text, &alarm, &name, programs, colour, Some(1));
            found.count = 1;
            found.exit = exit;
            bar.inc(1);
            return found;
        }
    };
    let warnings = job.take_warnings();
    bar.suspend(|| job.tell(shop));
    let mut supervisor = Supervisor::new(&shop.machine, job.dialect, shop.options().start);
    let mut interpreter = job.interpreter(Options { keep_going: true, ..shop.options() });
    interpreter.set_machine(std::sync::Arc::new(shop.machine.clone()));
    let mut pending = warnings;
    let mut all = AllFound::new(MOST_FINDINGS);
    while supervisor.follow(&mut interpreter, &mut pending) {
        for alarm in pending.drain(..) {
            all.add(alarm, &interpreter);
        }
    }
    bar.inc(1);
    let AllFound { found: all, further, .. } = all;
    found.count = all.len() + further;
    if found.count > 0 {
        found.exit = Exit::Finding;
    }
    let programs = Some(interpreter.programs());
    // Writing to memory cannot fail.
    for Found { alarm, times, .. } in &all {
        let _ = shop.diagnostics.write(&mut found.text, alarm, &name, programs, colour, Some(*times));
    }
    if further > 0 {
        let count = [("count", (further as f64).into())];
        let told = shop.diagnostics.catalogue().label("label-further", &count);
        let _ = match shop.diagnostics.is_json() {
            true => {
                let told = serde_json::json!({
                    "file": name, "severity": "warning", "message": told, "further": further,
                });
                writeln!(found.text, "{told}")
            }
            false => writeln!(found.text, "{name}: {told}\n"),
        };
    }
    found
}
