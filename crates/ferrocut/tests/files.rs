//! Files that are not there, cannot be read or are no programs, and wrong use: one clear sentence and
//! the right status.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{Answer, ferrocut, json, root, with_input, write};

const COMMANDS: [&str; 4] = ["run", "check", "trace", "time"];

/// The answer is one finding that names the file, with this status.
fn one_sentence(answer: &Answer, code: i32, name: &str, what: &str) {
    assert_eq!(answer.code, code, "{what}: {} {}", answer.out, answer.err);
    let all = format!("{}{}", answer.out, answer.err);
    let errors: Vec<&str> = all.lines().filter(|l| l.starts_with("error")).collect();
    assert_eq!(errors.len(), 1, "{what}: {all}");
    assert!(errors[0].contains(name), "{what}: {}", errors[0]);
    assert!(all.contains("help"), "{what} does not say what to do: {all}");
    assert!(!all.contains("Os {") && !all.contains("Error("), "{what}: {all}");
}

fn every_command(file: &str, code: i32, name: &str) {
    for command in COMMANDS {
        one_sentence(&ferrocut(&[command, file]), code, name, &format!("{command} {file}"));
        let answer = ferrocut(&[command, file, "--format", "json"]);
        let text = if command == "check" { &answer.out } else { &answer.err };
        let finding = json(text.trim());
        assert_eq!((answer.code, finding["line"].as_u64()), (code, Some(0)), "{command} {finding}");
        assert!(finding["message"].as_str().unwrap().contains(name), "{finding}");
        assert_eq!(finding["file"], file, "{command}");
    }
}

#[test]
fn a_file_that_is_not_there() {
    every_command("no/such/part.nc", 2, "no/such/part.nc");
}

/// A result is written over nothing that the command reads, whatever it is called there.
#[test]
fn an_output_that_is_an_input() {
    let folder = tempfile::tempdir().unwrap();
    let program = write(&folder, "part.nc", "G1 X1 F100\nM30\n");
    let machine = write(&folder, "mill.toml", std::fs::read(root().join("machines/demo-mill.toml")).unwrap());
    let drawing = write(&folder, "plate.plt", "PU0,0;PD400,0;PU;");
    let picture = write(&folder, "part.svg", "G1 X1 F100\nM30\n");
    let ladder = write(&folder, "mill.lad", std::fs::read(root().join("machines/standard.lad")).unwrap());
    let memory = folder.path().join("memory");
    let memory_folder = memory.to_str().unwrap();
    let database = memory.join("memory.db");
    ferrocut_memory::Store::open(&memory, ferrocut_memory::Settings::new("gsk990mc")).unwrap();
    // By another way to the same place.
    let around =
        format!("{}/../{}/part.nc", folder.path().display(), folder.path().file_name().unwrap().display());
    for (arguments, file) in [
        (vec!["run", &program, "--samples", &program], program.as_str()),
        (vec!["run", &program, "--samples", &around], &program),
        (vec!["plot", &program, "-o", &program], &program),
        (vec!["plot", &program, "--machine", &machine, "-o", &machine], &machine),
        (vec!["view", &picture, "-o", &picture], &picture),
        (vec!["import", &drawing, "-o", &drawing], &drawing),
        (vec!["import", &drawing, "--machine", &machine, "-o", &machine], &machine),
        (vec!["machine", "params", "export", "--machine", &machine, "-o", &machine], &machine),
        (vec!["plc", "import", &ladder, "-o", &ladder], &ladder),
        (
            vec!["memory", "backup", memory_folder, "-o", database.to_str().unwrap()],
            database.to_str().unwrap(),
        ),
    ] {
        let before = std::fs::read(file).unwrap();
        let answer = ferrocut(&arguments);
        assert_eq!(answer.code, 2, "{arguments:?}: {} {}", answer.out, answer.err);
        assert!(answer.err.contains("a file that the command reads"), "{arguments:?}: {}", answer.err);
        assert!(std::fs::read(file).unwrap() == before, "{arguments:?} wrote");
    }
    // What is there and is none of them is replaced.
    let other = write(&folder, "other.svg", "old");
    assert_eq!(ferrocut(&["plot", &program, "-o", &other]).code, 0);
    assert!(std::fs::read_to_string(&other).unwrap().contains("<svg"));
}

#[test]
fn a_folder() {
    let folder = tempfile::tempdir().unwrap();
    every_command(folder.path().to_str().unwrap(), 2, "folder");
}

#[cfg(unix)]
#[test]
fn a_file_that_may_not_be_read() {
    use std::os::unix::fs::PermissionsExt;
    let folder = tempfile::tempdir().unwrap();
    let file = write(&folder, "secret.nc", "M30\n");
    std::fs::set_permissions(&file, std::fs::Permissions::from_mode(0o000)).unwrap();
    // Root may read everything; then there is nothing to see here.
    if std::fs::read(&file).is_err() {
        every_command(&file, 2, "secret.nc");
    }
}

#[test]
fn a_picture() {
    let folder = tempfile::tempdir().unwrap();
    let png = b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x01\0\0\0\x01\x08\x06\0\0\0\x1f\x15\xc4\x89";
    every_command(&write(&folder, "part.png", png), 1, "part.png");
    // A program of the computer, which is larger than what is looked at first.
    let mut binary = b"\x7fELF\x02\x01\x01\0\0\0\0\0\0\0\0\0".to_vec();
    binary.resize(6 << 20, 7);
    every_command(&write(&folder, "tool.nc", binary), 1, "tool.nc");
}

#[test]
fn utf_16() {
    let folder = tempfile::tempdir().unwrap();
    let text: Vec<u8> = "\u{FEFF}G0 X1\r\nM30\r\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
    every_command(&write(&folder, "notepad.nc", text), 1, "notepad.nc");
    let text: Vec<u8> = "\u{FEFF}G0 X1\r\nM30\r\n".encode_utf16().flat_map(u16::to_be_bytes).collect();
    every_command(&write(&folder, "notepad.nc", text), 1, "notepad.nc");
}

#[test]
fn empty_files() {
    let folder = tempfile::tempdir().unwrap();
    for text in ["", "\n\n", "  \t\r\n", "\u{FEFF}"] {
        every_command(&write(&folder, "empty.nc", text), 1, "empty.nc");
    }
    for command in COMMANDS {
        let answer = with_input(&[command, "-"], "");
        assert_eq!(answer.code, 1, "{command} {}", answer.err);
    }
}

#[test]
fn some_files_of_many() {
    let folder = tempfile::tempdir().unwrap();
    let good = write(&folder, "good.nc", "G0 X1\nM30\n");
    let bad = write(&folder, "bad.nc", "G77\nM30\n");
    // The worst of all is the status, and every file is checked.
    let answer = ferrocut(&["check", "missing.nc", &good, &bad]);
    assert_eq!(answer.code, 2);
    assert!(answer.out.contains("missing.nc") && answer.out.contains("gsk990mc:0010"), "{}", answer.out);
    assert_eq!(ferrocut(&["check", &good, &bad]).code, 1);
    assert_eq!(ferrocut(&["check", &good, &good]).code, 0);
}

#[test]
fn machine_and_set_up_files() {
    let folder = tempfile::tempdir().unwrap();
    let good = write(&folder, "good.nc", "G0 X1\nM30\n");
    let wrong = write(&folder, "wrong.toml", "[start]\nq = 1.0\n");
    let no_toml = write(&folder, "no.toml", "G0 X1\n");
    let machine = write(&folder, "machine.toml", "name = \"m\"\naxes = []\n");
    let parameter = write(&folder, "parameter.toml", "[parameters]\nP270 = -1\n");
    for flag in ["--setup", "--machine"] {
        for command in COMMANDS {
            for file in ["missing.toml", &wrong, &no_toml, folder.path().to_str().unwrap()] {
                let answer = ferrocut(&[command, &good, flag, file]);
                one_sentence(&answer, 2, file, &format!("{command} {flag} {file}"));
            }
        }
    }
    let answer = ferrocut(&["run", &good, "--machine", &machine]);
    one_sentence(&answer, 2, "machine.toml", "a machine without axes");
    assert!(answer.err.contains("axes"), "{}", answer.err);
    // The key at fault is named.
    assert!(ferrocut(&["run", &good, "--setup", &wrong]).err.contains("\"q\""));
    assert!(ferrocut(&["run", &good, "--setup", &parameter]).err.contains("P270"));
    assert_eq!(ferrocut(&["run", &good, "--setup", &parameter]).code, 2);
    // What the control refuses is told with file and line, however its key is written.
    for (text, line) in [
        ("[parameters]\nP271 = 1\np0270 = -1\n", 3),
        ("[parameters]\n\n\"NO43#1\" = 2\n", 3),
        ("[parameters]\nP9999 = 1\n", 2),
        ("[tools.1]\nlength = 1\n\n[tools.999]\nlength = 1\n", 4),
        ("[work_offsets]\nG54 = { x = 1 }\n\"G54 P99\" = { x = 1 }\n", 3),
        ("[variables]\n\"#100\" = 1\n\"#0\" = 1\n", 3),
    ] {
        let setup = write(&folder, "set.toml", text);
        let answer = ferrocut(&["run", &good, "--setup", &setup]);
        assert!(answer.code == 2 && answer.err.contains(&format!("({setup}:{line}: [")), "{}", answer.err);
    }
    let text = format!("{}\n[parameters]\nP270 = -1\n", ferrocut_machine::Machine::DEMO_MILL);
    let machine = write(&folder, "mill.toml", &text);
    let answer = ferrocut(&["run", &good, "--machine", &machine]);
    let says = format!("({machine}:{}: [parameters] P270", text.lines().count());
    assert!(answer.code == 2 && answer.err.contains(&says), "{}", answer.err);
    // A period of the servo loop that motion is not made for.
    for period in ["0.2", "4.5"] {
        let text = ferrocut_machine::Machine::DEMO_MILL.replacen(
            "period_ms = 1.0",
            &format!("period_ms = {period}"),
            1,
        );
        let machine = write(&folder, "mill.toml", text);
        let answer = ferrocut(&["run", &good, "--machine", &machine]);
        assert!(answer.code == 2 && answer.err.contains("it must be 0.25 to 4"), "{}", answer.err);
    }
}

#[test]
fn wrong_use() {
    let folder = tempfile::tempdir().unwrap();
    let good = write(&folder, "good.nc", "G0 X1\nM30\n");
    for arguments in [
        &["run"][..],
        &["mill", &good],
        &["run", &good, "--fast"],
        &["run", &good, "--format", "xml"],
        &["run", &good, "--dialect", "klingon"],
        &["run", &good, "--language", "de"],
        &["run", &good, "--public", "no/such/public.dat"],
        &["view", &good, "-o", "view.svg", "--width", "399"],
        &["view", &good, "-o", "view.svg", "--width", "10001"],
        &["run", &good, "--feed-override", "0"],
        &["run", &good, "--feed-override", "201"],
        &["run", &good, "--rapid-override", "101"],
        &["run", &good, "--feed-override", "fast"],
        &["run", &good, &good],
        &["check"],
        &["run", &good, "--samples", "no/such/folder/samples.csv"],
    ] {
        let answer = ferrocut(arguments);
        assert_eq!(answer.code, 2, "{arguments:?}: {}", answer.err);
        assert!(answer.err.starts_with("error"), "{arguments:?}: {}", answer.err);
    }
    // Help is no fault.
    for arguments in [&["--help"][..], &["--version"], &["run", "--help"], &["check", "--help"]] {
        let answer = ferrocut(arguments);
        assert_eq!((answer.code, answer.err.as_str()), (0, ""), "{arguments:?}");
        assert!(!answer.out.is_empty());
    }
}
