//! `ferrocut run --from`: a program that is taken up in its midst, at a desk. What the control would tell the
//! operator (docs/restart.md) is shown, then it is carried out.

use crate::cli::Place;
use crate::job::Shop;
use ferrocut_controller::Cnc;
use ferrocut_controller::restart::told::{AxisMove, axis_moves, function, short};
use ferrocut_controller::restart::{At, Compared, Difference, How, Journal, Restart, Setting};
use ferrocut_geometry::{Axis, Position};
use ferrocut_interpreter::Fallible;
use ferrocut_machine::{Alarm, Argument, Catalogue, Fault, Machine};
use ferrocut_program::{FileId, Span};
use serde::Serialize;
use serde_json::{Map, Value};
use std::io::{self, Write};

/// A restart as JSON.
#[derive(Serialize)]
pub struct JsonRestart {
    file: String,
    line: u32,
    pass: u64,
    /// Where the block begins, machine coordinates, mm and degrees.
    position: Map<String, Value>,
    /// What the program has and the machine had not.
    modal: Vec<JsonDifference>,
    /// What is sent before the axes move.
    sent: Vec<String>,
    /// The axes in the order in which they move, with where to and, where there is one, the speed in mm/min.
    approach: Vec<JsonMove>,
}

#[derive(Serialize)]
struct JsonDifference {
    /// `G01`: the modal group by the manual's number; `F`, `S`, `zero.X` …
    of: String,
    program: Option<String>,
    machine: Option<String>,
}

#[derive(Serialize)]
struct JsonMove {
    axis: String,
    to: f64,
    /// `rapid`, `feed`
    kind: &'static str,
    speed: Option<f64>,
}

/// A restart that the control is about to carry out.
pub struct Lead {
    /// What of it is told.
    pub json: JsonRestart,
    /// What the search could not know.
    pub warning: Option<Alarm>,
    differences: Vec<Difference>,
}

/// Finds the place and makes the control ready to go on there.
pub fn prepare(cnc: &mut Cnc, shop: &Shop, from: &Place) -> Fallible<Lead> {
    let mut ahead = cnc.interpreter().clone();
    let file = match &from.file {
        None => FileId(0),
        // The program itself, by its name.
        Some(name) if *name == ahead.programs().file_name(FileId(0)) => FileId(0),
        Some(name) => ahead.file_named(name).ok_or_else(|| {
            let alarm = Alarm::core(Fault::FileUnreadable, Span::default());
            Box::new(alarm.with("file", name.as_str()))
        })?,
    };
    // The files that were opened stay known by their numbers.
    let journal = Journal::begin(&ahead, Position::ZERO);
    let at = At::Line { file, line: from.line, pass: from.pass };
    let restart = journal.find(at, cnc.interpreter().memory())?;
    let present = cnc.present();
    let lead_in = restart.lead_in(&present, &shop.machine, How { sends: true, axis_by_axis: false })?;
    let differences = restart.differences(&present.state);
    let json = JsonRestart {
        file: restart.interpreter().programs().file_name(restart.span.file).to_owned(),
        line: restart.span.line,
        pass: restart.pass,
        position: position(&restart, &shop.machine),
        modal: differences.iter().map(json_difference).collect(),
        sent: lead_in.iter().filter_map(|step| function(&step.op, &restart.position)).collect(),
        approach: axis_moves(lead_in.iter().map(|step| &step.op), restart.renamed(&present))
            .iter()
            .map(json_move)
            .collect(),
    };
    let warning = restart.warning();
    cnc.restart(restart, lead_in)?;
    Ok(Lead { json, warning, differences })
}

fn position(restart: &Restart, machine: &Machine) -> Map<String, Value> {
    let of = |axis: Axis| (axis.name().to_owned(), Value::from(restart.position[axis]));
    machine.axes.iter().map(|axis| of(axis.name)).collect()
}

fn json_move(way: &AxisMove) -> JsonMove {
    let kind = if way.is_rapid { "rapid" } else { "feed" };
    JsonMove { axis: way.axis.name().to_owned(), to: way.to, kind, speed: way.speed }
}

fn json_difference(difference: &Difference) -> JsonDifference {
    JsonDifference {
        of: difference.of.name(),
        program: difference.program.text(),
        machine: difference.machine.text(),
    }
}

/// What is compared, in words.
fn label(of: Compared, catalogue: Catalogue) -> String {
    let of_axis = |key: &str, axis: Axis| catalogue.label(key, &[("axis", axis.letter().to_string().into())]);
    let key = match of {
        Compared::Code(group) => {
            let group = Argument::from(format!("{group:02}"));
            return catalogue.label("label-restart-group", &[("group", group)]);
        }
        Compared::WorkZero(axis) => return of_axis("label-restart-zero", axis),
        Compared::Length(axis) => return of_axis("label-restart-tool-length", axis),
        Compared::Feed => "label-restart-feed",
        Compared::FeedPerRevolution => "label-restart-feed-per-turn",
        Compared::Speed => "label-restart-speed",
        Compared::Spindle => "label-restart-spindle",
        Compared::Coolant(0) => "label-restart-flood",
        Compared::Coolant(_) => "label-restart-mist",
        Compared::Tool => "label-restart-tool",
        Compared::InSpindle => "label-restart-in-spindle",
        Compared::LengthNumber => "label-restart-length",
        Compared::RadiusNumber => "label-restart-radius",
    };
    catalogue.label(key, &[])
}

impl Lead {
    /// Shows it for people.
    pub fn write_text(&self, out: &mut dyn Write, shop: &Shop) -> io::Result<()> {
        let catalogue = shop.diagnostics.catalogue();
        let word = |key: &str| catalogue.label(key, &[]);
        let JsonRestart { line, pass, position, sent, approach, .. } = &self.json;
        let at = [("line", Argument::from(line.to_string())), ("pass", Argument::from(pass.to_string()))];
        writeln!(out, "{}", catalogue.label("label-restart-at", &at))?;
        let place = shop.machine.axes.iter().filter_map(|axis| {
            let at = position.get(axis.name.name())?.as_f64()?;
            Some(format!("{}{}", axis.name.letter(), short(at)))
        });
        let place: Vec<String> = place.collect();
        writeln!(out, "  {}: {}", word("label-restart-position"), place.join(" "))?;
        let list = |items: Vec<String>| match items.is_empty() {
            true => word("label-restart-nothing"),
            false => items.join(" "),
        };
        writeln!(out, "  {}: {}", word("label-restart-sent"), list(sent.clone()))?;
        let ways = approach.iter().map(|way| format!("{}{}", way.axis.to_uppercase(), short(way.to)));
        writeln!(out, "  {}: {}", word("label-restart-approach"), list(ways.collect()))?;
        writeln!(out, "  {}:", word("label-restart-modal"))?;
        for Difference { of, program, machine } in &self.differences {
            let shown = |value: Setting| value.text().unwrap_or_else(|| "-".to_owned());
            writeln!(out, "    {}: {} / {}", label(*of, catalogue), shown(*program), shown(*machine))?;
        }
        Ok(())
    }
}
