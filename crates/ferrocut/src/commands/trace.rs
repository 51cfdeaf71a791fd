//! `ferrocut trace`: every step as a line of JSON.

use crate::cli::TraceArgs;
use crate::job::{Exit, Failure, Shop};
use crate::stdout;
use ferrocut_interpreter::{Interpreter, Options};
use ferrocut_machine::Alarm;
use ferrocut_program::ProgramMemory;
use ferrocut_toolpath::{Op, Step, TraceWriter};
use std::io::{self, Write};

/// Runs the command.
pub fn run(args: &TraceArgs) -> Result<Exit, Failure> {
    let shop = Shop::open(&args.common)?;
    let job = shop.job(&args.file).inspect_err(|failure| {
        // A fault in a drawing stands in the trace as one in a program does.
        if failure.exit == Exit::Finding && failure.alarm.span.line > 0 {
            let text = shop.diagnostics.message(&failure.alarm, failure.programs.as_deref());
            let (id, span) = (failure.alarm.id, failure.alarm.span);
            let mut trace = TraceWriter::new(stdout::lock(), shop.options().start);
            let _ = trace.alarm(id.number(), &id.to_string(), &text, span).and_then(|()| trace.finish());
        }
    })?;
    let name = job.path.to_string_lossy().into_owned();
    job.tell(&shop);
    let notes: Vec<Step> = job.notes().map(|note| message(&shop, note, job.programs())).collect();
    // The steps that the program commands.
    let mut interpreter = job.interpreter(Options { ends_at_fixed_point: false, ..shop.options() });
    let mut trace = TraceWriter::new(stdout::lock(), shop.options().start);
    trace.name_axes(shop.options().axis_names);
    trace.set_main(interpreter.main_file());
    match notes
        .iter()
        .try_for_each(|note| trace.step(note))
        .and_then(|()| write(&shop, &mut interpreter, &mut trace))
    {
        Ok(alarm) => {
            // A reader that went away (a closed pipe) is no fault of the program.
            let _ = trace.finish();
            let Some(alarm) = alarm else { return Ok(Exit::Fine) };
            shop.diagnostics.report(&alarm, &name, Some(interpreter.programs()));
            Ok(Exit::Finding)
        }
        Err(_) => Ok(Exit::Fine),
    }
}

/// What was passed over in a drawing, as text for the operator (Weihong PLT jobs).
fn message(shop: &Shop, note: &Alarm, programs: &ProgramMemory) -> Step {
    let text = shop.diagnostics.message(note, Some(programs));
    Step::new(Op::Message(text.into()), note.span, 0)
}

/// Writes steps to the end or to the first alarm, which is returned.
fn write<W: Write>(
    shop: &Shop,
    interpreter: &mut Interpreter,
    trace: &mut TraceWriter<W>,
) -> io::Result<Option<Box<Alarm>>> {
    loop {
        let (span, step) = match interpreter.next() {
            None => return Ok(None),
            Some(Ok(step)) => (step.span, Ok(step)),
            Some(Err(alarm)) => (alarm.span, Err(alarm)),
        };
        if !trace.knows_file(span.file) {
            let name = interpreter.programs().file_name(span.file).to_owned();
            trace.name_file(span.file, &name);
        }
        match step {
            Ok(step) => trace.step(&step)?,
            Err(alarm) => {
                let text = shop.diagnostics.message(&alarm, Some(interpreter.programs()));
                trace.alarm(alarm.id.number(), &alarm.id.to_string(), &text, alarm.span)?;
                return Ok(Some(alarm));
            }
        }
    }
}
