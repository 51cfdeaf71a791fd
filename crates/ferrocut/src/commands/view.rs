//! `ferrocut view`: a picture of the tool path.

use crate::cli::ViewArgs;
use crate::job::{Exit, Failure, Shop};
use crate::outputs;
use crate::view::{PathModel, Picture, render};
use ferrocut_desk::finding::point_at_word;
use std::path::Path;

/// Runs the command.
pub fn run(args: &ViewArgs) -> Result<Exit, Failure> {
    let shop = Shop::open(&args.common)?;
    outputs::check_beside(&args.output, &args.file, &args.common)?;
    let Some(format) = picture_format(&args.output) else {
        return Err(Failure::picture_format(&args.output.to_string_lossy()));
    };
    let job = shop.job(&args.file)?;
    job.tell(&shop);
    let name = job.path.to_string_lossy().into_owned();
    let mut interpreter = job.keeping().interpreter(shop.options());
    let mut model = PathModel::new(shop.options().start);
    model.set_work_zero(interpreter.work_zero());
    let mut exit = Exit::Fine;
    for step in &mut interpreter {
        match step {
            Ok(step) => model.step(&step.op),
            Err(alarm) => {
                exit = Exit::Finding;
                let mut alarm = alarm;
                point_at_word(&mut alarm, &interpreter);
                shop.diagnostics.report(&alarm, &name, Some(interpreter.programs()));
                break;
            }
        }
    }
    let title =
        args.file.file_name().map_or_else(|| name.clone(), |file| file.to_string_lossy().into_owned());
    let output = args.output.to_string_lossy().into_owned();
    let catalogue = shop.diagnostics.catalogue();
    let cannot_write = |reason: String| Failure::cannot_write_for(&output, &reason);
    // What was drawn until an alarm shows where it came.
    let bytes = render(&model, &title, args.width, format, catalogue)
        .map_err(|error| cannot_write(error.told(catalogue)))?;
    std::fs::write(&args.output, bytes).map_err(|error| cannot_write(error.to_string()))?;
    let said = match shop.diagnostics.is_json() {
        true => serde_json::json!({ "program": name, "picture": output, "width": args.width }).to_string(),
        false => catalogue.label("label-written", &[("file", output.into())]),
    };
    crate::commands::layout::print(&format!("{said}\n"));
    Ok(exit)
}

/// The format that the name of a file asks for.
pub fn picture_format(path: &Path) -> Option<Picture> {
    match path.extension()?.to_str()?.to_ascii_lowercase().as_str() {
        "png" => Some(Picture::Png),
        "svg" => Some(Picture::Svg),
        _ => None,
    }
}
