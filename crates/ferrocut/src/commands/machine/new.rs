//! `ferrocut machine new`: a machine file to start from.

use super::NewArgs;
use crate::cli::Common;
use crate::commands::layout::print;
use crate::commands::names::complain;
use crate::job::{Exit, Failure, diagnostics};
use ferrocut_machine::Machine;
use std::fs::OpenOptions;
use std::io::{self, Write};
use std::path::Path;
use toml_edit::{DocumentMut, value};

/// What stands above the machine's name.
const HEAD: &str = "# A machine: where its axes end, how fast they are, and what its control has set.\n\
    # Change the numbers to those of yours, look at it with `ferrocut machine check` and pass it to any\n\
    # command with --machine.\n\n";

/// What stands behind the last table.
const TAIL: &str = "
[parameters]
# Parameters of the control that differ from its list, by their own names; bits in quotation marks.
# `ferrocut machine params list` shows them, `ferrocut machine params set` changes them here.
#
# P270 = 1.5                    # retract of chip breaking (G73), mm
# \"NO43.1\" = 1                  # peck cycles without depth of cut are an alarm
";

/// Runs the command.
pub fn run(args: &NewArgs, common: &Common) -> Result<Exit, Failure> {
    let diagnostics = diagnostics(common);
    let file = args.output.to_string_lossy();
    let text = text(args.name.as_deref());
    if args.output == Path::new("-") {
        print(&match diagnostics.is_json() {
            true => format!("{}\n", serde_json::json!({ "file": file, "text": text })),
            false => text,
        });
        return Ok(Exit::Fine);
    }
    let made = OpenOptions::new().write(true).create_new(true).open(&args.output);
    match made.and_then(|mut file| file.write_all(text.as_bytes())) {
        Ok(()) => {
            let said = match diagnostics.is_json() {
                true => serde_json::json!({ "file": file }).to_string(),
                false => diagnostics.catalogue().label("label-written", &[("file", (&*file).into())]),
            };
            print(&format!("{said}\n"));
            Ok(Exit::Fine)
        }
        Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {
            complain(
                &diagnostics.catalogue().label("label-exists", &[("file", (&*file).into())]),
                &diagnostics,
            );
            Ok(Exit::WrongUse)
        }
        Err(error) => Err(Failure::cannot_write(&file, &error)),
    }
}

/// The demo mill's file, under another name.
fn text(name: Option<&str>) -> String {
    // A test holds that the built-in file can be read.
    let Ok(mut file) = Machine::DEMO_MILL.parse::<DocumentMut>() else { return String::new() };
    // A file beside the demo machine's, and none beside this one.
    file.as_table_mut().remove("public_programs");
    let comment = file.get("name").and_then(|item| item.as_value()).map(|v| v.decor().clone());
    if let Some(item) = file.get_mut("name") {
        *item = value(name.unwrap_or("My mill"));
        if let (Some(new), Some(comment)) = (item.as_value_mut(), comment) {
            *new.decor_mut() = comment;
        }
    }
    if let Some(mut key) = file.as_table_mut().key_mut("name") {
        key.leaf_decor_mut().set_prefix(HEAD);
    }
    format!("{}\n{}", file.to_string().trim_end(), TAIL)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_file_reads_back_under_its_name() {
        for name in [None, Some("VMC \"850\" \\ 立式")] {
            let text = text(name);
            let machine = Machine::from_toml(&text).unwrap();
            assert_eq!(machine.name, name.unwrap_or("My mill"));
            assert_eq!(machine.axes.len(), 4);
            assert!(text.starts_with("# A machine:") && text.contains("# jerk           mm/s³"));
            // The examples in the comment are parameters where they stand.
            let open = text.replace("# P270", "P270").replace("# \"NO43.1", "\"NO43.1");
            assert_eq!(Machine::from_toml(&open).unwrap().parameters.len(), 2);
        }
    }
}
