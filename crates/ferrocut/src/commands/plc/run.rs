//! `ferrocut plc run`: a ladder at a desk.

use super::{RunArgs, Source};
use crate::commands::names::near;
use crate::diagnostics::Diagnostics;
use crate::job::{Exit, Failure};
use crate::stdout;
use ferrocut_controller::control::ladder_alarm;
use ferrocut_plc::instruction::Code;
use ferrocut_plc::{Address, Area, Error, Fault, Maintenance, Pace, Plc, Program};
use ferrocut_program::Span;
use serde::Serialize;
use std::io::{self, Write};

/// A signal that is set at a time.
struct Change {
    ms: u64,
    address: Address,
    value: u8,
}

/// A signal that is watched, and what it was.
struct Watched {
    address: Address,
    name: Option<String>,
    value: u8,
}

/// A change as JSON.
#[derive(Serialize)]
struct Changed<'a> {
    ms: u64,
    signal: String,
    name: Option<&'a str>,
    value: u8,
}

/// The end of a run as JSON.
#[derive(Serialize)]
struct Ran {
    ms: u64,
    rounds: u32,
    steps: u32,
    stopped: bool,
}

/// The flow at an instruction as JSON.
#[derive(Serialize)]
struct Flowed<'a> {
    line: u32,
    instruction: &'a str,
    reached: bool,
    on: bool,
    powered: bool,
}

/// Runs the command.
pub fn run(args: &RunArgs, diagnostics: Diagnostics) -> Result<Exit, Failure> {
    let source = Source::open(&args.file)?;
    let Some(program) = source.program(&diagnostics) else { return Ok(Exit::Finding) };
    let mut changes =
        args.set.iter().map(|text| change(&program, "--set", text)).collect::<Result<Vec<_>, _>>()?;
    changes.sort_by_key(|change| change.ms);
    let forced =
        args.force.iter().map(|text| change(&program, "--force", text)).collect::<Result<Vec<_>, _>>()?;
    let mut watched = watched(&program, &args.watch)?;
    let pace = Pace { period_us: args.period * 1000, steps: args.steps, ..Pace::default() };
    let mut plc = Plc::new(program, pace);
    // At a desk there is no machine that a forced signal could move.
    let right = Maintenance::granted();
    for force in &forced {
        let bits = force.address.bit.map_or(0..8, |bit| bit..bit + 1);
        for bit in bits {
            let on = force.address.bit.map_or(force.value >> bit & 1 == 1, |_| force.value != 0);
            plc.force(&right, Address { bit: Some(bit), ..force.address }, on);
        }
    }
    plc.watch(args.flow);
    let mut out = stdout::lock();
    // A reader that went away ends the run.
    match simulate(args, &diagnostics, &mut plc, &changes, &mut watched, &mut out) {
        Ok(true) => {
            let alarm = ladder_alarm(&Error::new(Fault::TimeOut, Default::default()), Span::default());
            diagnostics.report(&alarm, &source.name, None);
            Ok(Exit::Finding)
        }
        Ok(false) | Err(_) => Ok(Exit::Fine),
    }
}

/// Runs the ladder for its time and prints what changes; whether it was stopped.
fn simulate(
    args: &RunArgs,
    diagnostics: &Diagnostics,
    plc: &mut Plc,
    changes: &[Change],
    watched: &mut [Watched],
    out: &mut impl Write,
) -> io::Result<bool> {
    let mut changes = changes.iter().peekable();
    let (mut rounds, mut most, mut ms) = (0, 0, 0);
    let mut is_stopped = false;
    while ms < u64::from(args.time) && !is_stopped {
        while let Some(change) = changes.next_if(|change| change.ms <= ms) {
            match change.address.bit {
                Some(_) => plc.memory_mut().set_bit(change.address, change.value != 0),
                None => plc.memory_mut().set_byte(change.address, change.value),
            }
        }
        let scanned = plc.scan();
        rounds += u32::from(scanned.is_round);
        most = most.max(scanned.steps);
        is_stopped = scanned.stop.is_some();
        for signal in watched.iter_mut() {
            let value = value(plc, signal.address);
            if std::mem::replace(&mut signal.value, value) != value {
                print_change(out, diagnostics, ms, signal)?;
            }
        }
        ms += u64::from(args.period);
    }
    if args.flow {
        print_flow(out, diagnostics, plc)?;
    }
    if diagnostics.is_json() {
        serde_json::to_writer(&mut *out, &Ran { ms, rounds, steps: most, stopped: is_stopped })?;
        out.write_all(b"\n")?;
        return Ok(is_stopped);
    }
    let key = if is_stopped { "label-ladder-stopped" } else { "label-ladder-ran" };
    let arguments = [
        ("time", (ms as f64).into()),
        ("rounds", f64::from(rounds).into()),
        ("steps", f64::from(most).into()),
    ];
    writeln!(out, "{}", diagnostics.catalogue().label(key, &arguments))?;
    Ok(is_stopped)
}

fn value(plc: &Plc, address: Address) -> u8 {
    match address.bit {
        Some(_) => u8::from(plc.memory().bit(address)),
        None => plc.memory().byte(address),
    }
}

fn print_change(
    out: &mut impl Write,
    diagnostics: &Diagnostics,
    ms: u64,
    signal: &Watched,
) -> io::Result<()> {
    let Watched { address, name, value } = signal;
    if diagnostics.is_json() {
        let changed = Changed { ms, signal: address.to_string(), name: name.as_deref(), value: *value };
        serde_json::to_writer(&mut *out, &changed)?;
        return out.write_all(b"\n");
    }
    let shown = match (address.bit, value) {
        (None, value) => value.to_string(),
        (Some(_), 0) => diagnostics.catalogue().label("label-ladder-off", &[]),
        (Some(_), _) => diagnostics.catalogue().label("label-ladder-on", &[]),
    };
    writeln!(out, "{ms:>8} ms  {:<8} {shown:<4} {}", address.to_string(), name.as_deref().unwrap_or_default())
}

/// The ladder with a mark of each contact and line.
fn print_flow(out: &mut impl Write, diagnostics: &Diagnostics, plc: &Plc) -> io::Result<()> {
    let is_json = diagnostics.is_json();
    if !is_json {
        writeln!(out, "{}", diagnostics.catalogue().label("label-ladder-legend", &[]))?;
    }
    for (instruction, flow) in plc.program().instructions().iter().zip(plc.flow()) {
        let (name, operand) = match &instruction.code {
            Code::Basic(basic, address) => (basic.text(), *address),
            Code::Function(row, ..) => (row.text, None),
        };
        let operand = operand.map_or_else(String::new, |address| address.to_string());
        let line = instruction.span.line;
        if is_json {
            let (reached, on, powered) = (flow.is_reached, flow.is_on, flow.is_powered);
            let text = format!("{name} {operand}");
            let flowed = Flowed { line, instruction: text.trim_end(), reached, on, powered };
            serde_json::to_writer(&mut *out, &flowed)?;
            out.write_all(b"\n")?;
            continue;
        }
        let contact = match (flow.is_reached, flow.is_on) {
            (false, _) => '-',
            (true, true) => '|',
            (true, false) => 'o',
        };
        let power = if flow.is_powered { "*" } else { "" };
        let text = format!("{line:>6} {contact} {name:<10} {operand:<8} {power}");
        writeln!(out, "{}", text.trim_end())?;
    }
    Ok(())
}

/// Reads `[MS:]SIGNAL=VALUE`.
fn change(program: &Program, setting: &str, text: &str) -> Result<Change, Failure> {
    let form = if setting == "--set" { "[MS:]SIGNAL=VALUE" } else { "SIGNAL=VALUE" };
    let wrong = || Failure::ladder_setting(setting, text, form);
    let (time, rest) = match text.split_once(':') {
        Some((time, rest)) => (time.parse().map_err(|_| wrong())?, rest),
        None => (0, text),
    };
    let (signal, value) = rest.split_once('=').ok_or_else(wrong)?;
    let address =
        program.signal(signal.trim()).ok_or_else(|| no_signal(program, setting, text, signal.trim()))?;
    let (most, allowed) = if address.bit.is_some() { (1, "0, 1") } else { (u8::MAX, "0 … 255") };
    let value = value.trim().parse::<u8>().ok().filter(|value| *value <= most);
    let value = value.ok_or_else(|| Failure::ladder_setting(setting, text, allowed))?;
    Ok(Change { ms: time, address, value })
}

/// A signal that the ladder does not have: names near to it, else the forms that a signal has.
fn no_signal(program: &Program, setting: &str, text: &str, name: &str) -> Failure {
    let near = near(name, program.symbols().iter().map(|symbol| symbol.name.to_string()));
    let allowed = if near.is_empty() { "X20.3, D10, NAME".to_owned() } else { near.join(", ") };
    Failure::ladder_setting(setting, text, &allowed)
}

/// The signals that are watched: those asked for, else all bits of Y and G.
fn watched(program: &Program, asked: &[String]) -> Result<Vec<Watched>, Failure> {
    let name_of = |address: Address| {
        program.symbols().iter().find(|symbol| symbol.address == address).map(|symbol| symbol.name.clone())
    };
    let watch = |address: Address| Watched { address, name: name_of(address), value: 0 };
    if !asked.is_empty() {
        let signal = |name: &String| {
            let address = program.signal(name.trim());
            address.map(watch).ok_or_else(|| no_signal(program, "--watch", name, name.trim()))
        };
        return asked.iter().map(signal).collect();
    }
    let mut all = Vec::new();
    for area in [Area::Y, Area::G] {
        for byte in 0..u16::MAX {
            let address = Address { area, byte, bit: None };
            if !address.holds(1) {
                break;
            }
            all.extend((0..8).map(|bit| watch(Address { bit: Some(bit), ..address })));
        }
    }
    Ok(all)
}
