//! `ferrocut import`: a drawing to a part program.

use crate::cli::ImportArgs;
use crate::commands::layout::print;
use crate::commands::view::picture_format;
use crate::drawing::{FromDrawing, Made, Opened, Source};
use crate::job::{Exit, Failure, Shop, text_of};
use crate::outputs;
use crate::view::{PathModel, render};
use ferrocut_exchange::write::Ends;
use ferrocut_exchange::{Change, Drawing, Format, Order, Settings, settings};
use ferrocut_interpreter::Options;
use ferrocut_machine::{Alarm, Argument, Fault};
use ferrocut_program::{OpenError, Span};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::{self, Write};
use std::path::Path;
use std::time::Duration;

/// Runs the command.
pub fn run(args: &ImportArgs) -> Result<Exit, Failure> {
    let mut common = args.common.clone();
    if args.to.is_some() {
        common.dialect = args.to.clone();
    }
    let shop = Shop::open(&common)?;
    for output in args.output.iter().chain(&args.picture) {
        outputs::check_beside(output, &args.file, &common)?;
    }
    let (dialect, told) = shop.own_dialect()?;
    let picture = match &args.picture {
        None => None,
        Some(path) => {
            let format = picture_format(path);
            let format = format.ok_or_else(|| Failure::picture_format(&path.to_string_lossy()))?;
            Some((path, format))
        }
    };
    let source = source(args, &shop)?;
    let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr());
    bar.set_style(ProgressStyle::default_spinner());
    bar.enable_steady_tick(Duration::from_millis(100));
    let stage = |key: &str| bar.set_message(shop.diagnostics.catalogue().label(key, &[]));
    let parameters = shop.memory_of(dialect, told)?.parameters;
    let made = source.program(dialect, &parameters, Ends::Raised, stage);
    let made = made.and_then(|made| all_named(args, &made.drawing).map(|()| made));
    let made = made.inspect_err(|_| bar.finish_and_clear())?;
    stage("label-stage-prove");
    let Made { drawing, program } = made;
    let (text, summary) = (program.text.clone(), program.summary);
    let (programs, origins) = source.memory(program, dialect)?;
    let from = FromDrawing::new(&source, origins, drawing);
    let job = shop.job_of(&args.file, (dialect, told), programs, Some(from))?;
    bar.suspend(|| job.tell(&shop));
    // The program is run through before it is given away.
    let mut interpreter = job.interpreter(Options { ends_at_fixed_point: false, ..shop.options() });
    let mut model = PathModel::new(shop.options().start);
    model.set_work_zero(interpreter.work_zero());
    let mut fault: Option<Box<Alarm>> = None;
    for step in &mut interpreter {
        match step {
            Ok(step) if picture.is_some() => model.step(&step.op),
            Ok(_) => {}
            Err(alarm) => fault = Some(alarm),
        }
    }
    bar.finish_and_clear();
    if let Some(alarm) = &fault {
        shop.diagnostics.report(alarm, &source.name, Some(interpreter.programs()));
    }
    let cannot_write = |path: &Path, reason: &dyn ToString| {
        Failure::cannot_write_for(&path.to_string_lossy(), &reason.to_string())
    };
    let is_kept = args.output.as_deref().is_some_and(|path| path != Path::new("-"));
    match args.output.as_deref().filter(|_| is_kept) {
        Some(path) => std::fs::write(path, &text).map_err(|e| cannot_write(path, &e))?,
        None => print(&text),
    }
    if let Some((path, format)) = picture {
        let catalogue = shop.diagnostics.catalogue();
        let title =
            Path::new(&source.name).file_name().map_or_else(String::new, |n| n.to_string_lossy().into());
        let bytes = render(&model, &title, args.width, format, catalogue)
            .map_err(|e| cannot_write(path, &e.told(catalogue)))?;
        std::fs::write(path, bytes).map_err(|e| cannot_write(path, &e))?;
    }
    // Standard output is the program's unless it went to a file.
    let said = said(args, &shop, &source, &summary, dialect.name);
    match is_kept {
        true => print(&said),
        // Nobody is left to tell if standard error is closed.
        false => drop(io::stderr().lock().write_all(said.as_bytes())),
    }
    Ok(if fault.is_some() { Exit::Finding } else { Exit::Fine })
}

/// The drawing with the settings of the set-up file and those of the command line, which win.
fn source(args: &ImportArgs, shop: &Shop) -> Result<Box<Source>, Failure> {
    let (mut settings, named) = match &shop.setup.import {
        Some(setup) => {
            Settings::of(setup, default_order(args, setup.dims.map(|n| n.0))).map_err(Failure::setting)?
        }
        None => (Settings { order: default_order(args, None), ..Settings::default() }, None),
    };
    apply(args, &mut settings)?;
    let has_file = shop.setup.import.is_some();
    settings.check_named(&|key| option(args, key, has_file)).map_err(Failure::setting)?;
    let format = match &args.from {
        Some(name) => {
            Some(Format::named(name).ok_or_else(|| Failure::bad_setting("--from", name, settings::FORMATS))?)
        }
        None => named,
    };
    // Only a drawing is looked for: what is none must be named.
    match Source::open_as(&args.file, settings, format)? {
        Opened::Drawing(source) => Ok(source),
        Opened::Program(text) => match text_of(&args.file, text) {
            Ok(_) | Err(OpenError::NotText | OpenError::Utf16) => {
                Err(Failure::no_drawing(&args.file.to_string_lossy()))
            }
            // A file that is not there, a folder, or one that is empty, is told as such.
            Err(error) => Err(Failure::of_open(&args.file, error)),
        },
    }
}

/// A program that is kept is cut in the shortest order, save in space, where the order may matter.
fn default_order(args: &ImportArgs, dims: Option<f64>) -> Order {
    let dims = args.dims.map(f64::from).or(dims);
    if dims == Some(3.0) { Order::AsDrawn } else { Order::Shortest }
}

/// What a setting is called to whoever gave it: the option, or the key of the set-up file. What neither gave is an option
/// where there is no such file.
fn option(args: &ImportArgs, key: &'static str, has_file: bool) -> &'static str {
    let (option, is_given) = match key {
        "units_per_mm" => ("--units-per-mm", args.units_per_mm.is_some()),
        "units" => ("--units", args.units.is_some()),
        "scale" => ("--scale", args.scale.is_some()),
        "tolerance" => ("--tolerance", args.tolerance.is_some()),
        "order" => ("--order", args.order.is_some()),
        "pen_up" => ("--safe", args.safe.is_some()),
        "pen_down" => ("--depth", args.depth.is_some()),
        "feed" => ("--feed", args.feed.is_some()),
        "plunge" => ("--plunge", args.plunge.is_some()),
        "spindle" => ("--spindle", args.spindle.is_some()),
        key => (key, true),
    };
    if is_given || !has_file { option } else { key }
}

/// Puts the options of the command line over the settings.
fn apply(args: &ImportArgs, to: &mut Settings) -> Result<(), Failure> {
    let set = |place: &mut f64, value: Option<f64>| {
        if let Some(value) = value {
            *place = value;
        }
    };
    set(&mut to.units_per_mm, args.units_per_mm);
    set(&mut to.scale, args.scale);
    set(&mut to.tolerance, args.tolerance);
    set(&mut to.pen_up, args.safe);
    set(&mut to.cutting.depth, args.depth);
    set(&mut to.cutting.feed, args.feed);
    set(&mut to.cutting.plunge, args.plunge);
    to.cutting.spindle = args.spindle.or(to.cutting.spindle);
    to.cutting.tool = args.tool.or(to.cutting.tool);
    if let Some(dims) = args.dims {
        to.three_dimensional = dims == 3;
    }
    if let Some(name) = &args.units {
        let wrong = || Failure::bad_setting("--units", name, &settings::units());
        to.unit = Some(settings::unit_named(name).ok_or_else(wrong)?);
    }
    if let Some(name) = &args.order {
        let wrong = || Failure::bad_setting("--order", name, settings::ORDERS);
        to.order = Order::named(name).ok_or_else(wrong)?;
    }
    for (option, given, rows) in
        [("--layer", &args.layers, &mut to.layers), ("--pen", &args.pens, &mut to.pens)]
    {
        for text in given {
            // Names may hold an equals sign, what stands behind the last one does not.
            let row = text.rsplit_once('=').and_then(|(name, change)| Some((name, Change::parse(change)?)));
            let (name, change) = row.ok_or_else(|| Failure::bad_setting(option, text, settings::ROW))?;
            rows.push((name.into(), change));
        }
    }
    Ok(())
}

/// Whether the drawing has the layers and pens that the command line names: under a wrong name they would be cut
/// as all else.
fn all_named(args: &ImportArgs, drawing: &Drawing) -> Result<(), Failure> {
    // A layer that is not shown is there all the same.
    let left_out = drawing.warnings.iter().filter(|warning| warning.fault == Fault::LayerLeftOut);
    let left_out = left_out.flat_map(|warning| &warning.arguments).filter_map(|argument| match argument {
        ("name", Argument::Text(name)) => Some(&**name),
        _ => None,
    });
    let names: Vec<&str> = drawing.layers.iter().map(|layer| &*layer.name).chain(left_out).collect();
    let (asked, other) = match drawing.format {
        Format::Dxf => (&args.layers, &args.pens),
        Format::Plt => (&args.pens, &args.layers),
    };
    let of = |row: &String| row.rsplit_once('=').map_or(row.clone(), |(name, _)| name.to_owned());
    let unknown = |name: &String| !names.iter().any(|known| settings::is_layer(known, name));
    match asked.iter().map(of).find(unknown).or(other.first().map(of)) {
        None => Ok(()),
        Some(name) => {
            // What a PLT drawing has before it takes a pen has no name to give.
            let named: Vec<&str> = names.iter().copied().filter(|name| !name.is_empty()).collect();
            let named = if named.is_empty() { "-".to_owned() } else { named.join(", ") };
            let alarm = Alarm::core(Fault::NothingOnLayer, Span::default()).with("name", name);
            Err(Failure::new(Box::new(alarm.with("names", named)), Exit::WrongUse))
        }
    }
}

/// What was done, in a line or as an object.
fn said(
    args: &ImportArgs,
    shop: &Shop,
    source: &Source,
    summary: &ferrocut_exchange::Summary,
    dialect: &str,
) -> String {
    let file = |path: &Option<std::path::PathBuf>| path.as_ref().map(|p| p.to_string_lossy().into_owned());
    if shop.diagnostics.is_json() {
        let rounded = |mm: f64| (mm * 1e3).round() / 1e3;
        let said = serde_json::json!({
            "drawing": source.name,
            "format": source.format.name(),
            "dialect": dialect,
            "program": file(&args.output),
            "picture": file(&args.picture),
            "lines": summary.lines,
            "arcs": summary.arcs,
            "lowered": summary.lowered,
            "cutting_mm": rounded(summary.cut_mm),
            "rapid_mm": rounded(summary.way_mm),
            "min": summary.extent.map(|[low, _]| low.map(rounded)),
            "max": summary.extent.map(|[_, high]| high.map(rounded)),
        });
        return format!("{said}\n");
    }
    let label = |key: &str, arguments: &[_]| shop.diagnostics.catalogue().label(key, arguments);
    let size = |axis: usize| {
        let size = summary.extent.map_or(0.0, |[low, high]| high[axis] - low[axis]);
        ((size * 1e3).round() / 1e3).to_string()
    };
    let mut said = label(
        "label-drawing-made",
        &[
            ("file", source.name.as_str().into()),
            ("kind", source.format.name().into()),
            ("wide", size(0).into()),
            ("high", size(1).into()),
            ("curves", ((summary.lines + summary.arcs) as f64).into()),
            ("cut", format!("{:.1}", summary.cut_mm).into()),
            ("ways", (summary.lowered as f64).into()),
            ("way", format!("{:.1}", summary.way_mm).into()),
        ],
    );
    said.push('\n');
    for written in [file(&args.output), file(&args.picture)].into_iter().flatten() {
        said.push_str(&label("label-written", &[("file", written.into())]));
        said.push('\n');
    }
    said
}
