//! `ferrocut time`: how long a program takes, by the same code that runs it.

use crate::cli::TimeArgs;
use crate::commands::run::{Screen, report_end, write_text};
use crate::job::{Exit, Failure, Shop};
use crate::report::JsonReport;
use crate::stdout;
use ferrocut_controller::{Cnc, Event, State};
use ferrocut_interpreter::Options;
use std::io::{self, Write};

/// Runs the command.
pub fn run(args: &TimeArgs) -> Result<Exit, Failure> {
    let shop = Shop::open(&args.common)?;
    let job = shop.job(&args.file)?;
    job.tell(&shop);
    let name = job.path.to_string_lossy().into_owned();
    let interpreter = job.keeping().interpreter(Options { warns: true, ..shop.options() });
    let mut cnc = Cnc::new(&shop.machine, interpreter);
    let mut screen = Screen::new(&shop, &cnc, false);
    loop {
        cnc.cycle_start();
        while cnc.state() == &State::Running {
            let tick = cnc.tick();
            for event in cnc.events() {
                if let Event::Warning(alarm) = event {
                    screen.warn(alarm, &cnc, &shop.diagnostics, &name);
                }
            }
            screen.show(&tick, &cnc);
        }
        // What waits for the operator takes no time that a prediction could know.
        if !matches!(cnc.state(), State::Stopped(_)) {
            break;
        }
    }
    screen.clear();
    let exit = report_end(&cnc, &shop, &name);
    let mut out = stdout::lock();
    // A reader that went away is no fault of the program.
    let _ = match shop.diagnostics.is_json() {
        true => serde_json::to_writer(&mut out, &JsonReport::new(cnc.report(), &shop.machine))
            .map_err(io::Error::from)
            .and_then(|()| writeln!(out)),
        false => writeln!(out, "{name}").and_then(|()| write_text(&mut out, &cnc, &shop)),
    };
    Ok(exit)
}
