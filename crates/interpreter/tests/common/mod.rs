//! Runs programs and writes their steps in short lines that a table can hold.
#![allow(dead_code, missing_docs, clippy::unwrap_used, clippy::panic)]

use ferrocut_geometry::{Axis, Position};
use ferrocut_interpreter::{Dialect, Interpreter, Options, dialects};
use ferrocut_machine::{Alarm, Memory, Setup};
use ferrocut_program::{ProgramMemory, Text};
use ferrocut_toolpath::{Dwell, Feed, Op, Step, TraceWriter};
use std::fmt::Write;

/// An interpreter before the first block of `program`, on the GSK990MC with a set-up file's text.
pub fn interpreter(program: &[u8], setup: &str, options: Options) -> Option<Interpreter> {
    interpreter_of(&dialects::gsk990mc::DIALECT, program, setup, options)
}

/// The same of any control.
pub fn interpreter_of(
    dialect: &'static Dialect,
    program: &[u8],
    setup: &str,
    options: Options,
) -> Option<Interpreter> {
    let text = Text::from_bytes(program.to_vec()).ok()?;
    let programs = ProgramMemory::new("test.nc", text, dialect.syntax);
    let setup = Setup::from_toml(setup).unwrap();
    let mut memory = Memory::new(dialect.name);
    setup.apply(&mut memory).unwrap();
    let memory = ferrocut_interpreter::place_variables(dialect, memory).unwrap();
    let options = Options {
        start: setup.start.position(),
        block_skip: options.block_skip || setup.options.block_skip,
        optional_stop: options.optional_stop || setup.options.optional_stop,
        skip: options.skip.or(setup.signals.skip.map(|signal| (signal.axis, signal.at))),
        ..options
    };
    Some(Interpreter::new(dialect, programs, memory, options))
}

/// Steps beyond which a program of a test is taken as running away.
pub const RUNS_AWAY: usize = 1_000_000;

/// The steps of a program to its end or its first alarm, on the GSK990MC.
pub fn run(program: &str, setup: &str) -> (Vec<Step>, Option<Alarm>) {
    run_on(&dialects::gsk990mc::DIALECT, program, setup)
}

/// The same on any control.
pub fn run_on(dialect: &'static Dialect, program: &str, setup: &str) -> (Vec<Step>, Option<Alarm>) {
    let mut interpreter = interpreter_of(dialect, program.as_bytes(), setup, Options::default()).unwrap();
    let mut steps = Vec::new();
    for step in &mut interpreter {
        match step {
            // Behind a stop nothing is read before the start: no step of its own here.
            Ok(step)
                if step.op == Op::Barrier && matches!(steps.last(), Some(Step { op: Op::Stop(_), .. })) => {}
            Ok(step) => steps.push(step),
            Err(alarm) => return (steps, Some(*alarm)),
        }
        assert!(steps.len() < RUNS_AWAY, "{program}: runs away");
    }
    (steps, None)
}

/// What a check tells of a program, on any control.
pub fn told_on(dialect: &'static Dialect, program: &str, setup: &str) -> Vec<Alarm> {
    let options = Options { keep_going: true, ..Options::default() };
    let interpreter = interpreter_of(dialect, program.as_bytes(), setup, options).unwrap();
    interpreter.filter_map(Result::err).map(|alarm| *alarm).collect()
}

/// The steps of a program that raises no alarm, in short lines.
pub fn lines(program: &str, setup: &str) -> Vec<String> {
    lines_on(&dialects::gsk990mc::DIALECT, program, setup)
}

/// The same on any control.
pub fn lines_on(dialect: &'static Dialect, program: &str, setup: &str) -> Vec<String> {
    let (steps, alarm) = run_on(dialect, program, setup);
    assert_eq!(alarm, None, "{program}");
    let start = Setup::from_toml(setup).unwrap().start.position();
    short(&steps, start)
}

/// Steps as lines such as `feed X10 Z-5 F300`, naming the axes whose machine coordinate changed.
pub fn short(steps: &[Step], start: Position) -> Vec<String> {
    let mut at = start;
    let mut out = Vec::new();
    for step in steps {
        let mut line = match &step.op {
            Op::Rapid { .. } => "rapid".to_owned(),
            Op::Feed { .. } => "feed".to_owned(),
            Op::Arc { plane, .. } => plane.name().to_owned(),
            Op::Dwell(Dwell::Seconds(s)) => format!("dwell {}s", round(*s)),
            Op::Dwell(Dwell::Revolutions(r)) => format!("dwell {}rev", round(*r)),
            Op::Spindle(_) => spindle(step),
            Op::Tap { pitch, rpm, .. } => format!("tap {} at {}", round(*pitch), round(*rpm)),
            Op::Coolant(on) => format!("coolant {}", if *on { "on" } else { "off" }),
            Op::Select(t) => format!("select {t}"),
            Op::Change(t) => format!("change {t}"),
            Op::Machine(code) => format!("M{code}"),
            Op::MachineNumber { code, number } => format!("M{code} P{number}"),
            Op::ToolNumber(t) => format!("tool {t}"),
            Op::Orient(deg) => format!("orient {deg}"),
            Op::Stop(code) => format!("stop M{code:02}"),
            Op::End(code) => format!("end M{code:02}"),
            Op::Output { port, value, with_next_move: false } => format!("out {port} {value}"),
            Op::Output { port, value, with_next_move: true } => {
                format!("out {port} {value} with the next move")
            }
            Op::Wait { port, value, timeout: None, .. } => format!("wait {port} {value}"),
            Op::Wait { port, value, timeout: Some(s), .. } => format!("wait {port} {value} {}s", round(*s)),
            Op::Message(text) => format!("message {text}"),
            Op::Home(_) => "home".to_owned(),
            Op::Skip { hit: true, .. } => "skip to the signal".to_owned(),
            Op::Skip { hit: false, .. } => "skip".to_owned(),
            // Where the axes stand has another name from here on.
            Op::Datum { at: renamed } => {
                at = *renamed;
                continue;
            }
            other => format!("{other:?}"),
        };
        if let Some(to) = step.op.target() {
            for axis in Axis::ALL {
                if (to[axis] - at[axis]).abs() > 1e-9 {
                    write!(line, " {}{}", axis.letter(), round(to[axis])).unwrap();
                }
            }
            at = *to;
        }
        if let Op::Arc { center, sweep, .. } = &step.op {
            let [a, b] = center.map(round);
            write!(line, " about {a} {b} by {}", round(sweep.to_degrees())).unwrap();
        }
        match &step.op {
            Op::Feed { feed, .. } | Op::Arc { feed, .. } | Op::Skip { feed, .. } => match feed {
                Feed::PerMinute(f) | Feed::Held { at: f, .. } => write!(line, " F{}", round(*f)).unwrap(),
                Feed::PerRevolution(f) => write!(line, " {}/rev", round(*f)).unwrap(),
                Feed::Duration(s) => write!(line, " in {}s", round(*s)).unwrap(),
            },
            _ => {}
        }
        out.push(line);
    }
    out
}

/// `spindle cw 1000`, from the trace, which says what a speed comes to.
fn spindle(step: &Step) -> String {
    let mut json = Vec::new();
    let mut trace = TraceWriter::new(&mut json, Position::ZERO);
    trace.step(step).unwrap();
    trace.finish().unwrap();
    let json = String::from_utf8(json).unwrap();
    let value = |key: &str| {
        let rest = json.split_once(&format!("\"{key}\":")).unwrap_or_else(|| panic!("no {key} in {json}")).1;
        rest.split([',', '}']).next().unwrap_or_default().trim_matches('"').to_owned()
    };
    match value("dir").as_str() {
        "off" => "spindle off".to_owned(),
        dir if json.contains("css") => format!("spindle {dir} css {}", value("css")),
        dir => format!("spindle {dir} {}", value("rpm")),
    }
}

/// A tenth of a micrometre, a ten-thousandth of a degree: what the manual's figures are good for.
fn round(v: f64) -> f64 {
    let rounded = (v * 1e4).round() / 1e4;
    // -0 is 0.
    rounded + 0.0
}

/// The piece of `program` that an alarm is about.
pub fn at_fault<'a>(program: &'a str, alarm: &Alarm) -> &'a str {
    let start = usize::try_from(alarm.span.offset).unwrap();
    &program[start..start + alarm.span.len as usize]
}

/// Each program, started at machine zero, must give these steps; of the end of program only what
/// comes before it is named.
pub fn holds(cases: &[(&str, &[&str])]) {
    for (program, expected) in cases {
        holds_with("", program, expected);
    }
}

pub fn holds_with(setup: &str, program: &str, expected: &[&str]) {
    let mut found = lines(&format!("{program}\nM30\n"), setup);
    assert_eq!(found.pop().as_deref(), Some("end M30"), "{program}");
    assert_eq!(found, expected, "{program}");
}

const SPINDLE: &str = "M3 S1000";
const TURNS: &str = "spindle cw 1000";

/// A program with the spindle turning: its steps between the start of the spindle and its stop at the
/// end.
pub fn holds_turning(setup: &str, program: &str, expected: &[&str]) {
    let mut found = lines(&format!("{SPINDLE}\n{program}\nM30\n"), setup);
    assert_eq!(found.pop().as_deref(), Some("end M30"), "{program}");
    assert_eq!(found.pop().as_deref(), Some("spindle off"), "{program}");
    assert_eq!(found.first().map(String::as_str), Some(TURNS), "{program}");
    assert_eq!(found[1..], *expected, "{program}");
}
