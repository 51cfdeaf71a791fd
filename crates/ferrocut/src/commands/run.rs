//! `ferrocut run`: the main job. Runs a program on the machine and reports.

use crate::cli::RunArgs;
use crate::commands::restart::{self, JsonRestart};
use crate::diagnostics::Diagnostics;
use crate::job::{Exit, Failure, Shop};
use crate::outputs;
use crate::report::{self, JsonReport};
use crate::samples::Samples;
use crate::stdout;
use ferrocut_controller::drives::{self, Simulated};
use ferrocut_controller::{Clock, Cnc, Event, State, Tick};
use ferrocut_desk::finding::{AllFound, point_at_word};
use ferrocut_geometry::Axis;
use ferrocut_interpreter::Options;
use ferrocut_machine::{Alarm, Fault, Machine};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use serde::Serialize;
use std::io::{self, IsTerminal, Write};
use std::path::Path;
use std::time::{Duration, Instant};

/// The result of a run as JSON.
#[derive(Serialize)]
struct JsonRun<'a> {
    program: &'a str,
    machine: &'a str,
    dialect: &'a str,
    /// `ended`, `alarm`
    state: &'static str,
    alarm: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    restart: Option<JsonRestart>,
    #[serde(flatten)]
    report: JsonReport,
}

/// Runs the command.
pub fn run(args: &RunArgs) -> Result<Exit, Failure> {
    let shop = Shop::open(&args.common)?;
    let job = shop.job(&args.file)?;
    job.tell(&shop);
    let name = job.path.to_string_lossy().into_owned();
    let dialect = job.dialect.name;
    let is_json = shop.diagnostics.is_json();
    let mut samples = match &args.samples {
        None => None,
        Some(path) => {
            outputs::check_beside(path, &args.file, &args.common)?;
            Some(Samples::create(path, &shop.machine, shop.options().start)?)
        }
    };
    let samples_on_stdout = args.samples.as_deref() == Some(Path::new("-"));
    if !is_json && !samples_on_stdout {
        // A reader that went away is no fault of the run.
        let _ = write_header(&mut stdout::lock(), &shop, &job, &name);
    }
    let options = Options { loops_forever: args.realtime, warns: true, ..shop.options() };
    let interpreter = job.keeping().interpreter(options);
    // Nothing but a run at true speed moves a real machine.
    let real = match args.realtime {
        true => drives::connect(&shop.machine, interpreter.position()).map_err(Failure::setting)?,
        false => None,
    };
    let drives = real.unwrap_or_else(|| Box::new(Simulated));
    let mut cnc = Cnc::with_drives(&shop.machine, interpreter, drives);
    let mut restart = None;
    if let Some(from) = &args.from {
        let lead = match restart::prepare(&mut cnc, &shop, from) {
            Ok(lead) => lead,
            Err(mut alarm) => {
                point_at_word(&mut alarm, cnc.interpreter());
                shop.diagnostics.report(&alarm, &name, Some(cnc.interpreter().programs()));
                // A file that is not there is wrong use, as it is everywhere.
                let is_there = alarm.fault != Fault::FileUnreadable;
                return Ok(if is_there { Exit::Finding } else { Exit::WrongUse });
            }
        };
        if let Some(warning) = &lead.warning {
            shop.diagnostics.report(warning, &name, Some(cnc.interpreter().programs()));
        }
        if !is_json && !samples_on_stdout {
            let _ = lead.write_text(&mut stdout::lock(), &shop);
        }
        restart = Some(lead.json);
    }
    cnc.set_override(args.feed_override / 100.0, args.rapid_override / 100.0);
    if args.realtime {
        // Without threads for it all is done in the period.
        let _ = cnc.keep_time();
    }
    let clock = if args.realtime { Clock::real(shop.machine.servo_period_ms) } else { Clock::Virtual };
    let mut screen = Screen::new(&shop, &cnc, args.realtime);
    let mut take = |_: &Cnc, tick: &Tick| match samples.as_mut() {
        Some(samples) => samples.take(tick).map(|()| true),
        None => Ok(true),
    };
    let lost = drive(&mut cnc, clock, &mut take, &mut screen, &shop.diagnostics, &name);
    screen.clear();
    if let Some(samples) = samples
        && let Err(error) = lost.and_then(|()| samples.finish())
    {
        // The run ended with the write that failed: it has no figures. What became of standard output is told
        // at the end.
        if samples_on_stdout {
            return Ok(Exit::Fine);
        }
        let file = args.samples.as_deref().unwrap_or(Path::new("")).to_string_lossy().into_owned();
        return Err(Failure::cannot_write(&file, &error));
    }
    let exit = report_end(&cnc, &shop, &name);
    let mut out: Box<dyn Write> = match samples_on_stdout {
        true => Box::new(io::stderr().lock()),
        false => Box::new(stdout::lock()),
    };
    // A reader that went away is no fault of the run.
    let _ = match is_json {
        true => write_json(&mut out, &cnc, &shop.machine, &name, dialect, restart),
        false => write_text(&mut out, &cnc, &shop),
    };
    Ok(exit)
}

/// Shows the alarm that a run ended with, if it did, and gives the exit code.
pub fn report_end(cnc: &Cnc, shop: &Shop, name: &str) -> Exit {
    let State::Alarmed(alarm) = cnc.state() else { return Exit::Fine };
    let mut alarm = alarm.clone();
    point_at_word(&mut alarm, cnc.interpreter());
    shop.diagnostics.report(&alarm, name, Some(cnc.interpreter().programs()));
    Exit::Finding
}

fn write_header(out: &mut dyn Write, shop: &Shop, job: &crate::job::Job, name: &str) -> io::Result<()> {
    let catalogue = shop.diagnostics.catalogue();
    let machine = shop.machine.name.as_str();
    let machine = match shop.machine_is_built_in {
        true => catalogue.label("label-built-in", &[("machine", machine.into())]),
        false => machine.to_owned(),
    };
    let dialect = shop.language(job.dialect, job.told);
    writeln!(out, "{name}")?;
    writeln!(out, "  {}: {machine}", catalogue.label("label-machine", &[]))?;
    writeln!(out, "  {}: {dialect}", catalogue.label("label-control", &[]))
}

/// Writes what a run took, for people.
pub fn write_text(out: &mut dyn Write, cnc: &Cnc, shop: &Shop) -> io::Result<()> {
    if matches!(cnc.state(), State::Alarmed(_)) {
        writeln!(out, "{}", shop.diagnostics.catalogue().label("label-ended-by-alarm", &[]))?;
    }
    write!(out, "{}", report::text(cnc.report(), &shop.machine, &shop.diagnostics))
}

fn write_json(
    out: &mut dyn Write,
    cnc: &Cnc,
    machine: &Machine,
    name: &str,
    dialect: &str,
    restart: Option<JsonRestart>,
) -> io::Result<()> {
    let alarm = match cnc.state() {
        State::Alarmed(alarm) => Some(alarm.id.to_string()),
        _ => None,
    };
    let run = JsonRun {
        program: name,
        machine: &machine.name,
        dialect,
        state: if alarm.is_some() { "alarm" } else { "ended" },
        alarm,
        restart,
        report: JsonReport::new(cnc.report(), machine),
    };
    serde_json::to_writer(&mut *out, &run)?;
    writeln!(out)
}

/// Runs the program to its end. `take` is given the periods of the run; its error ends it, and so does `false`.
pub fn drive(
    cnc: &mut Cnc,
    mut clock: Clock,
    take: &mut dyn FnMut(&Cnc, &Tick) -> io::Result<bool>,
    screen: &mut Screen,
    diagnostics: &Diagnostics,
    name: &str,
) -> io::Result<()> {
    cnc.cycle_start();
    loop {
        let before = cnc.state() == &State::Running;
        let tick = cnc.tick();
        for event in cnc.events() {
            screen.event(event, cnc, diagnostics, name);
        }
        match cnc.state() {
            // Axes that failed come to rest before their alarm is given.
            State::Running | State::Resetting => {}
            State::Stopped(code) => {
                screen.stopped(*code, tick.span.line, diagnostics);
                cnc.cycle_start();
                continue;
            }
            _ => return Ok(()),
        }
        if before && !take(cnc, &tick)? {
            return Ok(());
        }
        screen.show(&tick, cnc);
        // While there is time: what is left then runs in the period.
        cnc.prepare();
        clock.wait();
    }
}

/// The live line on a terminal; nothing elsewhere.
pub struct Screen {
    bar: ProgressBar,
    axes: Vec<Axis>,
    next: Instant,
    asks: bool,
    /// Warnings told, each once however often the program comes to it.
    told: AllFound,
    /// Ticks until the clock is looked at again.
    countdown: u32,
}

/// How often the live line is drawn.
const REDRAW: Duration = Duration::from_millis(100);

/// Warnings of different places that are told.
const MOST_WARNINGS: usize = 200;

/// Ticks between two looks at the clock on a virtual clock, which are cheaper than the look.
const LOOK_EVERY: u32 = 64;

impl Screen {
    /// The line of a run of the main program.
    pub fn new(shop: &Shop, cnc: &Cnc, realtime: bool) -> Screen {
        let interpreter = cnc.interpreter();
        let length = interpreter.programs().text(interpreter.main_file()).map_or(0, |text| text.len());
        let bar = ProgressBar::with_draw_target(Some(length), ProgressDrawTarget::stderr());
        if let Ok(style) = ProgressStyle::with_template("{bar:30} {percent:>3} %  {msg}") {
            bar.set_style(style);
        }
        let axes = shop.machine.axis_set().iter().collect();
        let asks = realtime && io::stdin().is_terminal() && !shop.diagnostics.is_json();
        Screen { bar, axes, next: Instant::now(), asks, told: AllFound::new(MOST_WARNINGS), countdown: 0 }
    }

    /// Draws position, line and time so far.
    pub fn show(&mut self, tick: &Tick, cnc: &Cnc) {
        if self.countdown > 0 {
            self.countdown -= 1;
            return;
        }
        self.countdown = LOOK_EVERY;
        if self.bar.is_hidden() {
            return;
        }
        let now = Instant::now();
        if now < self.next {
            return;
        }
        self.next = now + REDRAW;
        if tick.span.file == cnc.interpreter().main_file() {
            self.bar.set_position(tick.span.offset);
        }
        let position: Vec<String> =
            self.axes.iter().map(|a| format!("{}{:9.3}", a.letter(), tick.position[*a])).collect();
        self.bar.set_message(format!(
            "N{} T{} {}  F{:.0}  {}",
            tick.span.line,
            cnc.report().tool(),
            position.join(" "),
            tick.velocity * 60.0,
            report::clock(cnc.report().total()),
        ));
    }

    fn event(&mut self, event: Event, cnc: &Cnc, diagnostics: &Diagnostics, name: &str) {
        match event {
            Event::Warning(alarm) => self.warn(alarm, cnc, diagnostics, name),
            Event::Message(text) => self.bar.suspend(|| eprintln!("{text}")),
            Event::ToolChange(_) => {}
        }
    }

    /// Tells a warning of a place that none was told of.
    pub fn warn(&mut self, alarm: Alarm, cnc: &Cnc, diagnostics: &Diagnostics, name: &str) {
        let known = self.told.found.len();
        self.told.add(alarm, cnc.interpreter());
        if let Some(new) = self.told.found.get(known) {
            let programs = cnc.interpreter().programs();
            self.bar.suspend(|| diagnostics.report(&new.alarm, name, Some(programs)));
        }
    }

    /// M00 and M01: asks for cycle start where somebody sits there, else goes on.
    fn stopped(&self, code: u32, line: u32, diagnostics: &Diagnostics) {
        let catalogue = diagnostics.catalogue();
        let text = catalogue.label("label-stopped", &[("code", format!("M{code:02}").into())]);
        self.bar.suspend(|| {
            if !diagnostics.is_json() {
                eprintln!("{line}: {text}");
            }
            if self.asks {
                eprintln!("{}", catalogue.label("label-press-enter", &[]));
                let mut answer = String::new();
                let _ = io::stdin().read_line(&mut answer);
            }
        });
    }

    /// Takes the line away.
    pub fn clear(&self) {
        self.bar.finish_and_clear();
    }
}
