//! `ferrocut plot`: velocity, acceleration, jerk and path error over time, by the same code that runs a program.

use crate::cli::PlotArgs;
use crate::commands::layout;
use crate::commands::run::{Screen, drive, report_end};
use crate::job::{Exit, Failure, Shop};
use crate::outputs;
use crate::plot::{Gauge, Peak, QUANTITIES, draw};
use ferrocut_controller::{Clock, Cnc, State};
use ferrocut_geometry::Axis;
use ferrocut_interpreter::Options;
use serde::Serialize;
use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::io::{self, Write};
use std::path::Path;

/// What was measured as JSON.
#[derive(Serialize)]
struct JsonPlot<'a> {
    program: &'a str,
    machine: &'a str,
    /// `ended`, `running` where `--to` came first, `alarm`
    state: &'static str,
    period_ms: f64,
    /// Time over which jerk is a mean.
    jerk_window_ms: f64,
    /// Along the path; the limit is the programmed feed.
    speed: JsonPeak,
    axes: BTreeMap<&'static str, BTreeMap<&'static str, JsonPeak>>,
    path_error: JsonPeak,
}

/// A highest value, with the unit that limit has too.
#[derive(Serialize)]
struct JsonPeak {
    max: f64,
    unit: &'static str,
    time_s: f64,
    line: u32,
    limit: Option<f64>,
    share: Option<f64>,
}

impl JsonPeak {
    fn new(peak: &Peak, unit: &'static str) -> JsonPeak {
        let &Peak { value, time, line, limit } = peak;
        let limit = (limit > 0.0).then_some(limit);
        JsonPeak { max: value, unit, time_s: time, line, limit, share: peak.share() }
    }
}

/// Runs the command.
pub fn run(args: &PlotArgs) -> Result<Exit, Failure> {
    let shop = Shop::open(&args.common)?;
    let is_piped = args.output.as_deref() == Some(Path::new("-"));
    let output = args.output.as_deref().filter(|_| !is_piped);
    if let Some(output) = output {
        outputs::check_beside(output, &args.file, &args.common)?;
        let is_other = |extension: &OsStr| !extension.eq_ignore_ascii_case("svg");
        if output.extension().is_some_and(is_other) {
            return Err(Failure::plot_setting("--output", &output.to_string_lossy(), ".svg, -"));
        }
    }
    let span = [args.from, args.to.unwrap_or(f64::INFINITY)];
    if span[0] >= span[1] {
        let allowed = format!("> {}", span[0]);
        return Err(Failure::plot_setting("--to", &span[1].to_string(), &allowed));
    }
    let axes = chosen_axes(args, &shop)?;
    let job = shop.job(&args.file)?;
    job.tell(&shop);
    let name = job.path.to_string_lossy().into_owned();
    let interpreter = job.keeping().interpreter(Options { warns: true, ..shop.options() });
    // The limits are those that the control's own parameters leave.
    let mut machine = shop.machine.clone();
    (interpreter.dialect().machine_parameters)(&interpreter.memory().parameters, &mut machine);
    let mut gauge = Gauge::new(&machine, &axes, shop.options().start, span);
    let mut cnc = Cnc::new(&shop.machine, interpreter);
    cnc.set_override(args.feed_override / 100.0, args.rapid_override / 100.0);
    let mut screen = Screen::new(&shop, &cnc, false);
    let mut take = |cnc: &Cnc, tick: &_| Ok(gauge.take(cnc, tick));
    // Measuring cannot fail.
    let _ = drive(&mut cnc, Clock::Virtual, &mut take, &mut screen, &shop.diagnostics, &name);
    screen.clear();
    let length = gauge.time();
    gauge.finish();
    if args.axes.is_none() {
        gauge.axes.retain(|axis| axis.peaks.iter().any(|peak| peak.value > 0.0));
    }
    let exit = report_end(&cnc, &shop, &name);
    if exit == Exit::Fine && length > 0.0 && args.from >= length {
        return Err(Failure::plot_setting("--from", &args.from.to_string(), &format!("< {length:.3}")));
    }
    let is_json = shop.diagnostics.is_json();
    let svg = || draw(&gauge, &name, &machine.name, &shop.diagnostics.catalogue());
    match output {
        Some(path) => {
            let file = path.to_string_lossy().into_owned();
            std::fs::write(path, svg()).map_err(|error| Failure::cannot_write(&file, &error))?;
            if !is_json {
                let said = shop.diagnostics.catalogue().label("label-written", &[("file", file.into())]);
                layout::print(&format!("{said}\n"));
            }
        }
        None if is_json && !is_piped => {}
        None => layout::print(&svg()),
    }
    if is_json {
        let said = serde_json::json!(report(&gauge, &cnc, &name, &machine.name));
        match is_piped {
            // Standard output is the picture's, as that of `import` is the program's.
            true => drop(writeln!(io::stderr(), "{said}")),
            false => layout::print(&format!("{said}\n")),
        }
    }
    Ok(exit)
}

/// The axes asked for; without a word all that the machine has.
fn chosen_axes(args: &PlotArgs, shop: &Shop) -> Result<Vec<Axis>, Failure> {
    let all = shop.machine.axis_set();
    let Some(letters) = &args.axes else { return Ok(all.iter().collect()) };
    let axis = |letter: u8| Axis::from_letter(letter.to_ascii_uppercase()).filter(|axis| all.contains(*axis));
    let chosen: Option<Vec<Axis>> = letters.bytes().map(axis).collect();
    chosen.filter(|chosen| !chosen.is_empty()).ok_or_else(|| {
        let allowed: String = all.iter().map(Axis::letter).collect();
        Failure::plot_setting("--axes", letters, &allowed)
    })
}

fn report<'a>(gauge: &Gauge, cnc: &Cnc, program: &'a str, machine: &'a str) -> JsonPlot<'a> {
    let state = match cnc.state() {
        State::Alarmed(_) => "alarm",
        State::Running => "running",
        _ => "ended",
    };
    let axes = gauge.axes.iter().map(|axis| {
        let units = match axis.is_rotary {
            true => ["deg/min", "deg/s2", "deg/s3"],
            false => ["mm/min", "mm/s2", "mm/s3"],
        };
        let peaks = QUANTITIES.into_iter().zip(axis.peaks.iter().zip(units));
        (axis.axis.name(), peaks.map(|(name, (peak, unit))| (name, JsonPeak::new(peak, unit))).collect())
    });
    JsonPlot {
        program,
        machine,
        state,
        period_ms: gauge.period * 1000.0,
        jerk_window_ms: (gauge.apart as f64 + 2.0) * gauge.period * 1000.0,
        speed: JsonPeak::new(&gauge.speed_peak, "mm/min"),
        axes: axes.collect(),
        path_error: JsonPeak::new(&gauge.error_peak, "mm"),
    }
}
