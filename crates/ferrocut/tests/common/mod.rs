//! The command line as a user meets it.
#![allow(dead_code, missing_docs, clippy::unwrap_used, clippy::panic)]

pub mod served;

use assert_cmd::Command;
use ferrocut_interpreter::dialects;
use serde_json::Value;
use std::path::{Path, PathBuf};

/// What a command gave back.
pub struct Answer {
    pub code: i32,
    pub out: String,
    pub err: String,
}

/// The command in English, whatever the language of the machine that runs the tests.
pub fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ferrocut"));
    command.args(arguments).current_dir(root()).timeout(std::time::Duration::from_secs(120));
    for variable in ["LC_ALL", "LC_MESSAGES", "LANG"] {
        command.env_remove(variable);
    }
    command
}

pub fn answer(command: &mut Command) -> Answer {
    let output = command.output().unwrap();
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
    let (out, err) = (text(&output.stdout), text(&output.stderr));
    assert!(!err.contains("panicked"), "{err}");
    // A status beside 0, 1 and 2, or none, is a crash.
    let code = output.status.code().unwrap_or_else(|| panic!("killed: {:?} {err}", output.status));
    assert!((0..=2).contains(&code), "{code} {err}");
    Answer { code, out, err }
}

pub fn ferrocut(arguments: &[&str]) -> Answer {
    answer(&mut command(arguments))
}

/// Runs with a program on standard input.
pub fn with_input(arguments: &[&str], program: &str) -> Answer {
    answer(command(arguments).write_stdin(program))
}

/// The workspace.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The example programs of every control, with the set-up beside them where there is one.
pub fn examples() -> Vec<(String, Option<String>)> {
    let controls = dialects::ALL.iter().map(|dialect| format!("examples/{}", dialect.name));
    controls.flat_map(|folder| examples_in(&folder)).collect()
}

fn examples_in(folder: &str) -> Vec<(String, Option<String>)> {
    let mut names: Vec<String> = std::fs::read_dir(root().join(folder))
        .unwrap()
        .map(|e| e.unwrap().file_name().into_string().unwrap())
        .filter(|n| n.ends_with(".nc"))
        .collect();
    names.sort();
    assert!(names.len() >= 2, "{folder}: {names:?}");
    names
        .into_iter()
        .map(|name| {
            let program = format!("{folder}/{name}");
            let setup = program.replace(".nc", ".toml");
            let setup = root().join(&setup).exists().then_some(setup);
            (program, setup)
        })
        .collect()
}

/// The machine file beside an example, where there is one.
pub fn machine_file(example: &(String, Option<String>)) -> Option<String> {
    Some(example.0.replace(".nc", ".machine.toml")).filter(|file| root().join(file).exists())
}

/// `command example --setup … --machine …`
pub fn on_example<'a>(command: &'a str, example: &'a (String, Option<String>)) -> Vec<&'a str> {
    let mut arguments = vec![command, example.0.as_str()];
    if let Some(machine) = machine_file(example) {
        arguments.extend(["--machine", machine.leak()]);
    }
    if let Some(setup) = &example.1 {
        arguments.extend(["--setup", setup.as_str()]);
    }
    arguments
}

/// Lines of JSON.
pub fn json_lines(text: &str) -> Vec<Value> {
    text.lines().map(|l| serde_json::from_str(l).unwrap_or_else(|e| panic!("{e}: {l}"))).collect()
}

/// The one JSON object of a text.
pub fn json(text: &str) -> Value {
    serde_json::from_str(text).unwrap_or_else(|e| panic!("{e}: {text}"))
}

/// A number of a JSON object.
pub fn number(value: &Value, key: &str) -> f64 {
    value[key].as_f64().unwrap_or_else(|| panic!("no number {key} in {value}"))
}

/// A file in a folder that vanishes with the folder.
pub fn write(folder: &tempfile::TempDir, name: &str, bytes: impl AsRef<[u8]>) -> String {
    let path = folder.path().join(name);
    std::fs::write(&path, bytes).unwrap();
    path.into_os_string().into_string().unwrap()
}
