//! `ferrocut`: the command line.

mod cli;
mod commands;
mod diagnostics;
mod drawing;
mod job;
mod outputs;
mod plot;
mod pockets;
mod report;
mod samples;
mod stdout;
mod view;

use cli::{Cli, Command};
use job::{Exit, Failure};
use std::process::ExitCode;

fn main() -> ExitCode {
    let cli = Cli::read();
    let (done, common) = match cli.command {
        Command::Trace(args) => (commands::trace::run(&args), args.common),
        Command::Check(args) => (commands::check::run(&args), args.common),
        Command::Run(args) => (commands::run::run(&args), args.common),
        Command::Time(args) => (commands::time::run(&args), args.common),
        Command::View(args) => (commands::view::run(&args), args.common),
        Command::Plot(args) => (commands::plot::run(&args), args.common),
        Command::Import(args) => (commands::import::run(&args), args.common),
        Command::Explain(args) => (commands::explain::run(&args), args.common()),
        Command::Machine(args) => (commands::machine::run(&args), args.common()),
        Command::Memory(args) => (commands::memory::run(&args), args.common()),
        Command::Plc(args) => (commands::plc::run(&args), args.common()),
        Command::Serve(args) => (commands::serve::run(&args), args.common()),
    };
    let told = |Failure { alarm, exit, file, programs }| {
        job::diagnostics(&common).report(&alarm, &file, programs.as_deref());
        exit
    };
    let exit = done.unwrap_or_else(told);
    let exit = stdout::end().map_or_else(told, |()| exit);
    ExitCode::from(match exit {
        Exit::Fine => 0,
        Exit::Finding => 1,
        Exit::WrongUse => 2,
    })
}
