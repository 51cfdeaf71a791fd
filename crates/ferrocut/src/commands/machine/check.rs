//! `ferrocut machine check`: what is wrong or unlikely in a machine file, and what machine it makes.

use super::CheckArgs;
use super::params::problems;
use crate::cli::Common;
use crate::commands::explain::Book;
use crate::commands::layout::{padded, table, width};
use crate::job::{Exit, Failure, diagnostics};
use crate::stdout;
use ferrocut_interpreter::{Dialect, dialects};
use ferrocut_machine::{Argument, AxisConfig, AxisKind, Catalogue, Machine, Memory, Smoothing};
use std::io::{self, Read, Write};
use std::path::Path;
use toml_edit::{Document, Item};

/// Longest time in which an axis reaches its rapid speed, s: a slow drive takes one.
const LONGEST_RUN_UP: f64 = 5.0;
/// Shortest: 15 m/min within one millisecond are 25 g.
const SHORTEST_RUN_UP: f64 = 0.001;
/// Longest time in which an acceleration is built up, s; slower than that no axis is run.
const LONGEST_JERK_TIME: f64 = 1.0;
/// Longest time in which a spindle reaches its highest speed, s.
const LONGEST_SPINDLE_RUN_UP: f64 = 60.0;
/// Fastest positioning of any machine tool, mm/min.
const FASTEST: f64 = 300_000.0;
/// Fastest spindle of any milling machine, r/min.
const FASTEST_SPINDLE: f64 = 250_000.0;
/// Longest travel of a linear axis, mm.
const LONGEST: f64 = 100_000.0;
/// Largest tolerance that cuts a part, mm.
const LARGEST_TOLERANCE: f64 = 1.0;
/// Longest tool change, s.
const LONGEST_TOOL_CHANGE: f64 = 600.0;

/// What is to say of a file.
struct Remark {
    /// Line of the file, counted from 1; 0 where none is meant.
    line: usize,
    is_error: bool,
    text: String,
}

/// Runs the command.
pub fn run(args: &CheckArgs, common: &Common) -> Result<Exit, Failure> {
    let diagnostics = diagnostics(common);
    let mut exit = Exit::Fine;
    let mut out = stdout::lock();
    for (at, path) in args.files.iter().enumerate() {
        let file = path.to_string_lossy();
        let text = match read(path) {
            Ok(text) => text,
            Err(error) => {
                let failure = Failure::unreadable(&file, &error.to_string());
                diagnostics.report(&failure.alarm, &failure.file, None);
                exit = Exit::WrongUse;
                continue;
            }
        };
        let catalogue = diagnostics.catalogue();
        let (machine, remarks) = examine(&text, path, common, catalogue);
        if !remarks.is_empty() {
            exit = exit.max(Exit::Finding);
        }
        let written = match diagnostics.is_json() {
            true => write_json(&mut out, &file, machine.as_ref(), &remarks),
            false => write_text(&mut out, at, &file, machine.as_ref(), &remarks, catalogue),
        };
        // A reader that went away is no fault of the file.
        if written.is_err() {
            break;
        }
    }
    Ok(exit)
}

fn read(path: &Path) -> io::Result<String> {
    if path == Path::new("-") {
        let mut text = String::new();
        io::stdin().lock().read_to_string(&mut text)?;
        return Ok(text);
    }
    std::fs::read_to_string(path)
}

/// An object for each remark, and one for the machine that the file makes.
fn write_json(
    out: &mut dyn Write,
    file: &str,
    machine: Option<&Machine>,
    remarks: &[Remark],
) -> io::Result<()> {
    for remark in remarks {
        let severity = if remark.is_error { "error" } else { "warning" };
        let object = serde_json::json!({
            "file": file, "line": remark.line, "severity": severity, "message": remark.text,
        });
        writeln!(out, "{object}")?;
    }
    match machine {
        Some(machine) => writeln!(out, "{}", summary_json(file, machine)),
        None => Ok(()),
    }
}

fn write_text(
    out: &mut dyn Write,
    at: usize,
    file: &str,
    machine: Option<&Machine>,
    remarks: &[Remark],
    catalogue: Catalogue,
) -> io::Result<()> {
    if at > 0 {
        writeln!(out)?;
    }
    for remark in remarks {
        let place = if remark.line > 0 { format!("{file}:{}", remark.line) } else { file.to_owned() };
        let key = if remark.is_error { "label-error" } else { "label-warning" };
        writeln!(out, "{place}: {}", catalogue.label(key, &[("text", remark.text.as_str().into())]))?;
    }
    if let Some(machine) = machine {
        write!(out, "{}", summary(file, machine, catalogue))?;
    }
    Ok(())
}

/// What a file makes, and what is to say of it.
fn examine(text: &str, file: &Path, common: &Common, catalogue: Catalogue) -> (Option<Machine>, Vec<Remark>) {
    let machine = match Machine::from_toml(text) {
        Ok(machine) => machine,
        Err(error) => {
            let mut reason = error.told(catalogue);
            // `NO43.1 = 1` without quotation marks is a table to TOML.
            if text.lines().any(is_bare_bit) {
                reason = format!("{}\n{}", reason.trim_end(), catalogue.label("label-quote-bits", &[]));
            }
            return (None, vec![Remark { line: 0, is_error: true, text: reason }]);
        }
    };
    let lines = Lines::new(text);
    let mut remarks = Vec::new();
    let say = |key: &str, arguments: &[(&str, Argument)]| catalogue.label(key, arguments);
    let dialect = common.dialect.as_deref().unwrap_or(&machine.dialect);
    match dialects::by_name(dialect) {
        None => {
            let text = say("label-machine-dialect", &[("name", dialect.into())]);
            remarks.push(Remark { line: lines.of(&["dialect"]), is_error: true, text });
        }
        Some(dialect) => {
            let memory = Memory::new(dialect.name);
            let axes = (dialect.rules)(&memory.parameters).axes;
            for axis in machine.axes.iter().filter(|a| !axes.contains(a.name)) {
                let arguments =
                    [("axis", axis.name.letter().to_string().into()), ("dialect", dialect.name.into())];
                let line = lines.of_axis(&machine, axis, "name");
                remarks.push(Remark {
                    line,
                    is_error: false,
                    text: say("label-machine-no-axis", &arguments),
                });
            }
            let book = Book::new(dialect, memory, diagnostics(common));
            for (name, text) in problems(&machine, &book) {
                remarks.push(Remark { line: lines.of(&["parameters", &name]), is_error: true, text });
            }
        }
    }
    for axis in &machine.axes {
        for (field, key, value) in unlikely_axis(axis) {
            let arguments = [
                ("axis", axis.name.letter().to_string().into()),
                ("value", value.to_string().into()),
                ("limit", limit_of(key).to_string().into()),
            ];
            let line = lines.of_axis(&machine, axis, field);
            remarks.push(Remark { line, is_error: false, text: say(key, &arguments) });
        }
    }
    for (axis, field, key) in of_drives(&machine, dialects::by_name(dialect)) {
        let text = say(key, &[("axis", axis.name.letter().to_string().into())]);
        remarks.push(Remark { line: lines.of_axis(&machine, axis, field), is_error: false, text });
    }
    for (path, key, value) in unlikely(&machine) {
        let arguments = [("value", value.to_string().into()), ("limit", limit_of(key).to_string().into())];
        remarks.push(Remark { line: lines.of(path), is_error: false, text: say(key, &arguments) });
    }
    // What comes in by standard input lies nowhere.
    let beside = files_beside(&machine, dialects::by_name(dialect));
    for (path, name) in beside.filter(|_| file != Path::new("-")) {
        if let Err(error) = std::fs::File::open(file.with_file_name(name)) {
            let arguments = [("file", name.into()), ("reason", error.to_string().into())];
            let text = say("label-machine-file-missing", &arguments);
            remarks.push(Remark { line: lines.of(path), is_error: true, text });
        }
    }
    remarks.sort_by_key(|remark| remark.line);
    (Some(machine), remarks)
}

/// Files that lie beside the machine file and that its control needs, and where they are named.
fn files_beside<'a>(
    machine: &'a Machine,
    dialect: Option<&Dialect>,
) -> impl Iterator<Item = (&'static [&'static str], &'a str)> {
    let has_codes = dialect.is_some_and(|dialect| dialect.custom.is_some());
    let programs = machine.public_programs.as_deref().filter(|_| has_codes);
    let public: (&[&str], _) = (&["public_programs"], programs);
    let change: (&[&str], _) = (&["tool_change", "file"], machine.tool_change.file.as_deref());
    [public, change].into_iter().filter_map(|(path, name)| Some((path, name?)))
}

/// The bound that a warning names.
fn limit_of(key: &str) -> f64 {
    match key {
        "label-machine-travel" => LONGEST,
        "label-machine-fast" => FASTEST,
        "label-machine-sluggish" => LONGEST_RUN_UP,
        "label-machine-abrupt" => SHORTEST_RUN_UP,
        "label-machine-jerk-low" => LONGEST_JERK_TIME,
        "label-machine-spindle" => FASTEST_SPINDLE,
        "label-machine-spindle-sluggish" => LONGEST_SPINDLE_RUN_UP,
        "label-machine-tolerance" => LARGEST_TOLERANCE,
        "label-machine-tool-change" => LONGEST_TOOL_CHANGE,
        _ => 0.0,
    }
}

/// Numbers of an axis that can hardly be meant: the field, the warning, the value it names.
fn unlikely_axis(axis: &AxisConfig) -> Vec<(&'static str, &'static str, f64)> {
    let is_linear = axis.kind == AxisKind::Linear;
    let mut found = Vec::new();
    let mut warn = |holds: bool, field, key, value: f64| {
        if holds {
            found.push((field, key, (value * 1e4).round() / 1e4));
        }
    };
    let travel = axis.max - axis.min;
    warn(is_linear && travel > LONGEST, "max", "label-machine-travel", travel);
    warn(!(axis.min..=axis.max).contains(&0.0), "min", "label-machine-zero", 0.0);
    warn(is_linear && axis.rapid > FASTEST, "rapid", "label-machine-fast", axis.rapid);
    warn(axis.velocity > axis.rapid, "velocity", "label-machine-velocity", axis.velocity);
    let run_up = axis.rapid / 60.0 / axis.acceleration;
    warn(run_up > LONGEST_RUN_UP, "acceleration", "label-machine-sluggish", run_up);
    warn(run_up < SHORTEST_RUN_UP, "acceleration", "label-machine-abrupt", axis.acceleration);
    let build_up = axis.acceleration / axis.jerk;
    warn(axis.jerk > 0.0 && build_up > LONGEST_JERK_TIME, "jerk", "label-machine-jerk-low", build_up);
    found
}

/// What of the drives has no effect or a bad one: the axis, the field, the warning.
fn of_drives<'a>(
    machine: &'a Machine,
    dialect: Option<&Dialect>,
) -> Vec<(&'a AxisConfig, &'static str, &'static str)> {
    let mut found = Vec::new();
    let linear = || machine.axes.iter().filter(|a| a.kind == AxisKind::Linear);
    // What the control makes of it, where its parameters can be read.
    let mut as_set = machine.clone();
    let mut parameters = dialect.map(|dialect| Memory::new(dialect.name).parameters);
    if let (Some(dialect), Some(parameters)) = (dialect, &mut parameters) {
        for (name, value) in &machine.parameters {
            // One that is wrong is told elsewhere.
            let _ = name.parse().map(|key| parameters.set(&key, *value));
        }
        (dialect.machine_parameters)(parameters, &mut as_set);
    }
    for axis in &machine.axes {
        // Lines become curves where one axis is slower than another.
        let differs = linear().any(|other| other.after_cutting != axis.after_cutting);
        if axis.kind == AxisKind::Linear && axis.after_cutting != Smoothing::None && differs {
            found.push((axis, "after_cutting", "label-machine-smoothing-differs"));
        }
        let table = as_set.axis(axis.name).and_then(|axis| axis.pitch_errors.as_ref());
        let is_placed = table.is_some_and(|t| t.start.is_some() && t.interval.is_some());
        if axis.pitch_errors.is_some() && !is_placed {
            found.push((axis, "pitch_errors", "label-machine-pitch-off"));
        }
    }
    found
}

/// The same of the rest of the machine: path to the field, the warning, the value it names.
fn unlikely(machine: &Machine) -> Vec<(&'static [&'static str], &'static str, f64)> {
    let mut found: Vec<(&'static [&'static str], &'static str, f64)> = Vec::new();
    let spindle = &machine.spindle;
    if spindle.max_rpm > FASTEST_SPINDLE {
        found.push((&["spindle", "max_rpm"], "label-machine-spindle", spindle.max_rpm));
    }
    let run_up = spindle.max_rpm / spindle.acceleration_rpm_s;
    if run_up > LONGEST_SPINDLE_RUN_UP {
        found.push((&["spindle", "acceleration_rpm_s"], "label-machine-spindle-sluggish", run_up));
    }
    if machine.path.tolerance > LARGEST_TOLERANCE {
        found.push((&["path", "tolerance"], "label-machine-tolerance", machine.path.tolerance));
    }
    if machine.tool_change.time_s > LONGEST_TOOL_CHANGE {
        found.push((&["tool_change", "time_s"], "label-machine-tool-change", machine.tool_change.time_s));
    }
    found
}

/// Whether a line sets a bit parameter by a name that is not in quotation marks.
fn is_bare_bit(line: &str) -> bool {
    let name = line.split('=').next().unwrap_or_default().trim();
    let rest = name.strip_prefix("NO").or_else(|| name.strip_prefix("no")).unwrap_or_default();
    matches!(rest.split_once(['.', '#']), Some((number, _)) if number.trim().parse::<u16>().is_ok())
}

/// Where things stand in a file.
struct Lines<'a> {
    text: &'a str,
    file: Option<Document<&'a str>>,
}

impl<'a> Lines<'a> {
    fn new(text: &'a str) -> Lines<'a> {
        Lines { text, file: Document::parse(text).ok() }
    }

    fn line(&self, item: Option<&Item>) -> usize {
        let start = item.and_then(Item::span).map(|span| span.start);
        let before = start.and_then(|start| self.text.get(..start));
        before.map_or(0, |before| before.matches('\n').count() + 1)
    }

    /// Line of a field; 0 where it does not stand in the file.
    fn of(&self, path: &[&str]) -> usize {
        let file = self.file.as_ref().map(Document::as_item);
        self.line(path.iter().try_fold(file, |item, name| Some(item?.get(name))).flatten())
    }

    fn of_axis(&self, machine: &Machine, axis: &AxisConfig, field: &str) -> usize {
        let at = machine.axes.iter().position(|a| a.name == axis.name).unwrap_or(0);
        let axes = self.file.as_ref().and_then(|file| file.as_item().get("axes"));
        self.line(axes.and_then(|axes| axes.get(at)).and_then(|axis| axis.get(field)))
    }
}

/// The machine as an object.
fn summary_json(file: &str, machine: &Machine) -> serde_json::Value {
    let axes = machine.axes.iter().map(|axis| {
        serde_json::json!({
            "axis": axis.name.letter().to_string(),
            "kind": if axis.kind == AxisKind::Linear { "linear" } else { "rotary" },
            "min": axis.min,
            "max": axis.max,
            "rapid": axis.rapid,
            "velocity": axis.velocity,
            "acceleration": axis.acceleration,
            "jerk": axis.jerk,
        })
    });
    serde_json::json!({
        "file": file,
        "machine": machine.name,
        "dialect": machine.dialect,
        "servo_period_ms": machine.servo_period_ms,
        "axes": axes.collect::<Vec<_>>(),
        "spindle_max_rpm": machine.spindle.max_rpm,
        "tool_change_s": machine.tool_change.time_s,
        "tools": machine.tool_change.tools,
        "tolerance": machine.path.tolerance,
        "exact_stop": machine.path.exact_stop,
        "parameters": machine.parameters.len(),
    })
}

/// The machine in lines.
fn summary(file: &str, machine: &Machine, catalogue: Catalogue) -> String {
    let label = |key: &str| catalogue.label(&format!("label-machine-{key}"), &[]);
    let mut text = format!("{file}: {}\n", machine.name);
    let head = ["axis", "kind", "limits", "rapid", "cutting", "acceleration", "jerk"];
    let mut rows = vec![head.map(label).to_vec()];
    for axis in &machine.axes {
        let (kind, length) = match axis.kind {
            AxisKind::Linear => ("linear", "mm"),
            AxisKind::Rotary => ("rotary", "°"),
        };
        let jerk = if axis.jerk > 0.0 { format!("{} {length}/s³", axis.jerk) } else { label("unlimited") };
        rows.push(vec![
            axis.name.letter().to_string(),
            label(kind),
            format!("{} … {} {length}", axis.min, axis.max),
            format!("{} {length}/min", axis.rapid),
            format!("{} {length}/min", axis.velocity),
            format!("{} {length}/s²", axis.acceleration),
            jerk,
        ]);
    }
    text += &table(&rows).lines().map(|line| format!("  {line}\n")).collect::<String>();
    let spindle = &machine.spindle;
    let run_up = spindle.max_rpm / spindle.acceleration_rpm_s;
    let mut facts = vec![
        ("control", machine.dialect.clone()),
        ("period", format!("{} ms", machine.servo_period_ms)),
        ("spindle-name", format!("{} r/min, {run_up:.1} s", spindle.max_rpm)),
    ];
    let mut change = format!("{} s", machine.tool_change.time_s);
    if machine.tool_change.tools > 0 {
        let tools = [("tools", f64::from(machine.tool_change.tools).into())];
        change = format!("{change}, {}", catalogue.label("label-machine-tools", &tools));
    }
    facts.push(("tool-change-name", change));
    let path = match machine.path.exact_stop {
        true => label("exact-stop"),
        false => format!("{} mm", machine.path.tolerance),
    };
    facts.push(("tolerance-name", path));
    facts.push(("parameters", machine.parameters.len().to_string()));
    let facts: Vec<_> = facts.into_iter().map(|(key, value)| (label(key), value)).collect();
    let widest = facts.iter().map(|(name, _)| width(name)).max().unwrap_or(0);
    text += &facts.iter().map(|(n, v)| format!("  {}  {v}\n", padded(n, widest))).collect::<String>();
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use ferrocut_machine::Language;

    fn remarks(text: &str) -> Vec<(usize, String)> {
        let (_, remarks) = examine(text, Path::new("-"), &Common::default(), Catalogue::new(Language::En));
        remarks.into_iter().map(|r| (r.line, r.text)).collect()
    }

    #[test]
    fn the_demo_mill_has_nothing_to_complain_of() {
        assert_eq!(remarks(Machine::DEMO_MILL), []);
    }

    #[test]
    fn numbers_that_cannot_be_meant_are_told_with_their_lines() {
        let line = |text: &str, of: &str| text.lines().position(|l| l.starts_with(of)).unwrap() + 1;
        for (from, to, says) in [
            ("acceleration = 2000.0", "acceleration = 2.0", "mm/s²"),
            ("acceleration = 2000.0", "acceleration = 2e9", "mm/s²"),
            ("rapid = 15000.0", "rapid = 1500000.0", "mm/min"),
            ("velocity = 10000.0", "velocity = 20000.0", "faster than rapid"),
            ("jerk = 50000.0", "jerk = 50.0", "jerk"),
            ("max = 500.0", "max = 500000.0", "500500 mm"),
            ("min = -500.0", "min = 100.0", "0 lies outside"),
            ("max_rpm = 6000.0", "max_rpm = 6000000.0", "r/min"),
            ("acceleration_rpm_s = 4000.0", "acceleration_rpm_s = 4.0", "1500 s"),
            ("tolerance = 0.01", "tolerance = 10.0", "10 mm"),
            ("time_s = 5.0", "time_s = 5000.0", "5000 s"),
            ("dialect = \"gsk990mc\"", "dialect = \"gsk\"", "gsk"),
            ("jerk = 50000.0", "after_cutting = { kind = \"linear\", time_ms = 40.0 }", "lines are bent"),
            ("jerk = 50000.0", "pitch_errors = { corrections = [0.1] }", "axis X"),
            ("name = \"A\"", "name = \"W\"", "axis W"),
        ] {
            let text = Machine::DEMO_MILL.replacen(from, to, 1);
            let found = remarks(&text);
            assert!(found.iter().any(|(l, t)| *l == line(&text, to) && t.contains(says)), "{to}: {found:?}");
        }
    }

    #[test]
    fn bits_without_quotation_marks_are_explained() {
        let text = format!("{}\n[parameters]\nNO43.1 = 0\n", Machine::DEMO_MILL);
        assert!(remarks(&text).first().unwrap().1.contains("quotation marks"));
        assert!(!is_bare_bit("\"NO43.1\" = 0") && !is_bare_bit("note.1 = 2") && is_bare_bit(" no3.1=1"));
    }
}
