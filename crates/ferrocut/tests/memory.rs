//! `memory`: what a control keeps, at the command line.
#![allow(missing_docs, clippy::unwrap_used)]

mod common;

use common::{answer, command, ferrocut, json, json_lines, with_input};
use ferrocut_geometry::Position;
use ferrocut_machine::setup::VariableName;
use ferrocut_machine::{ToolOffset, WorkOffset};
use ferrocut_memory::{Author, Change, Level, Seat, Settings, Store};
use std::path::Path;
use tempfile::{TempDir, tempdir};

fn owner() -> Author {
    Author::Maintenance { name: "test".to_owned() }
}

fn open(folder: &Path) -> Store {
    Store::open(folder, Settings::new("gsk990mc")).unwrap()
}

/// A memory with a little of several items, closed.
fn memory() -> (TempDir, String) {
    let folder = tempdir().unwrap();
    let path = folder.path().join("memory");
    let text = b"O1234 (BRACKET)\nM30\n".to_vec();
    let changes = vec![
        Change::Program { name: "O1234".into(), text, comment: "BRACKET".into() },
        Change::Parameter { key: "P270".parse().unwrap(), value: Some(1.5) },
        Change::Offset { number: 12, offset: ToolOffset { length: 100.5, ..ToolOffset::ZERO } },
        Change::WorkZero { name: WorkOffset::Standard(1), zero: Position::xyz(10.0, -20.0, 0.0) },
        Change::Variable { name: VariableName::Number(500), value: Some(0.0) },
    ];
    open(&path).commit(&owner(), changes).unwrap();
    (folder, path.to_str().unwrap().to_owned())
}

/// As a kill leaves it: with a log beside the file.
fn killed() -> (TempDir, String) {
    let (folder, path) = memory();
    let copy = folder.path().join("killed");
    let store = open(Path::new(&path));
    for n in 1..=9 {
        let value = Some(f64::from(n));
        store.commit(&owner(), vec![Change::Variable { name: VariableName::Number(501), value }]).unwrap();
    }
    std::fs::create_dir_all(copy.join("good")).unwrap();
    for entry in std::fs::read_dir(&path).unwrap().chain(std::fs::read_dir(format!("{path}/good")).unwrap()) {
        let entry = entry.unwrap();
        let name = entry.path().strip_prefix(&path).unwrap().to_owned();
        if entry.path().is_file() && !name.ends_with("new.part") {
            std::fs::copy(entry.path(), copy.join(name)).unwrap();
        }
    }
    (folder, copy.to_str().unwrap().to_owned())
}

#[test]
fn show_says_how_much_there_is_and_what() {
    let (_folder, path) = memory();
    let shown = ferrocut(&["memory", "show", &path]);
    assert_eq!((shown.code, shown.err.as_str()), (0, ""));
    for part in ["gsk990mc", "programs", "part programs", "levels with a password  none"] {
        assert!(shown.out.contains(part), "{part}: {}", shown.out);
    }
    let all = json(&ferrocut(&["memory", "show", &path, "--format", "json"]).out);
    assert_eq!((&all["control"], &all["items"]["offsets"]), (&"gsk990mc".into(), &1.into()));
    let items = "programs,parameters,offsets,zeros,variables,log,pitch";
    let shown = ferrocut(&["memory", "show", &path, "--item", items]);
    for part in [
        "O1234",
        "BRACKET",
        "P270  1.5",
        "100.5",
        "G54   10  -20\n",
        "#500  0",
        "12 length",
        "nothing stored",
    ] {
        assert!(shown.out.contains(part), "{part}: {}", shown.out);
    }
    let rows = json_lines(&ferrocut(&["memory", "show", &path, "--item", "zeros", "--format", "json"]).out);
    assert_eq!(
        (&rows[0]["item"], &rows[0]["name"], &rows[0]["y"]),
        (&"zeros".into(), &"G54".into(), &(-20.0).into())
    );
    let chinese = ferrocut(&["memory", "show", &path, "--language", "zh"]);
    assert!(chinese.out.contains("工件零点"), "{}", chinese.out);
}

#[test]
fn a_control_that_runs_can_be_looked_at() {
    let (_folder, path) = memory();
    let store = open(Path::new(&path));
    let value = Some(7.0);
    store.commit(&owner(), vec![Change::Variable { name: VariableName::Number(502), value }]).unwrap();
    assert!(ferrocut(&["memory", "show", &path, "--item", "variables"]).out.contains("#502  7"));
    assert_eq!(ferrocut(&["memory", "check", &path]).code, 0);
    let file = format!("{path}.backup");
    assert_eq!(ferrocut(&["memory", "backup", &path, "-o", &file]).code, 0);
    let restored = ferrocut(&["memory", "restore", &file, &path]);
    assert_eq!(restored.code, 2);
    assert!(restored.err.contains("FC-1202"), "{}", restored.err);
    // Looking left no trace: the control goes on.
    let value = Some(8.0);
    store.commit(&owner(), vec![Change::Variable { name: VariableName::Number(502), value }]).unwrap();
}

#[test]
fn a_backup_goes_to_a_pipe() {
    let (folder, path) = memory();
    let file = folder.path().join("mill.backup").to_str().unwrap().to_owned();
    let piped = ferrocut(&["memory", "backup", &path, "-o", "-", "--item", "programs,offsets"]);
    assert_eq!((piped.code, piped.err.as_str()), (0, "written: -\n"));
    std::fs::write(&file, &piped.out).unwrap();
    let checked = ferrocut(&["memory", "check", &file]);
    assert_eq!(checked.code, 0, "{} {}", checked.out, checked.err);
    assert!(!common::root().join("-").exists());
    // And comes from one.
    let restored = folder.path().join("restored").to_str().unwrap().to_owned();
    for (arguments, says) in [
        (&["memory", "check", "-"][..], "-: whole, a backup of gsk990mc"),
        (&["memory", "restore", "-", &restored], "programs, offsets"),
    ] {
        let answer = with_input(arguments, &piped.out);
        assert!(answer.code == 0 && answer.out.contains(says), "{} {}", answer.out, answer.err);
        let cut = with_input(arguments, &piped.out[..piped.out.len() - 9]);
        assert!(cut.code == 1 && cut.err.contains("FC-1210"), "{}", cut.err);
        assert_eq!(with_input(arguments, "").code, 2);
    }
    assert!(ferrocut(&["memory", "show", &restored, "--item", "programs"]).out.contains("O1234"));
    #[cfg(unix)]
    {
        // What is none may have no end.
        let endless = ferrocut(&["memory", "check", "/dev/zero"]);
        assert_eq!((endless.code, endless.out.as_str()), (2, ""), "{}", endless.err);
        // Nor what begins as one.
        let begun: String = piped.out.split_inclusive('\n').take(2).collect();
        let script = "(cat; exec yes) | \"$0\" memory check -";
        let mut shell = assert_cmd::Command::new("sh");
        let program = env!("CARGO_BIN_EXE_ferrocut");
        let answer = common::answer(shell.args(["-c", script, program]).write_stdin(begun));
        assert!(answer.code == 1 && answer.err.contains("FC-1210"), "{}", answer.err);
        let mut check = command(&["memory", "check", "-"]);
        let answer = common::answer(check.env("TMPDIR", "/no/such").write_stdin(piped.out.as_str()));
        let says = answer.err.contains("FC-0907") && answer.err.contains("/no/such");
        assert!(answer.code == 2 && says, "{}", answer.err);
        // A standard error that takes nothing does not stop the backup.
        if let Ok(full) = std::fs::OpenOptions::new().write(true).open("/dev/full") {
            let mut backup = std::process::Command::new(env!("CARGO_BIN_EXE_ferrocut"));
            let done = backup.args(["memory", "backup", &path, "-o", "-"]).stderr(full).output().unwrap();
            assert_eq!(done.status.code(), Some(0));
        }
    }
    // A memory does not.
    let refused = ferrocut(&["memory", "restore", &file, "-"]);
    assert!(refused.code == 2 && refused.err.contains("a memory is a folder"), "{}", refused.err);
    assert!(!common::root().join("-").exists());
    let json_said = ferrocut(&["memory", "backup", &path, "-o", "-", "--format", "json"]);
    assert_eq!(json(&json_said.err)["items"]["offsets"], 1);
    // What the help says that there is, is all that there is.
    let help = ferrocut(&["memory", "show", "--help"]).out;
    for item in ferrocut_memory::Item::ALL {
        assert!(help.contains(item.name()), "{}: {help}", item.name());
    }
}

#[test]
fn a_backup_is_checked_and_restored() {
    let (folder, path) = memory();
    let file = folder.path().join("mill.backup").to_str().unwrap().to_owned();
    let other = folder.path().join("other").to_str().unwrap().to_owned();
    let written = ferrocut(&["memory", "backup", &path, "-o", &file]);
    assert_eq!((written.code, written.out.contains("mill.backup")), (0, true));
    let checked = ferrocut(&["memory", "check", &path, &file]);
    assert_eq!(checked.code, 0, "{}", checked.err);
    assert!(checked.out.contains("a backup of gsk990mc at 20"), "{}", checked.out);
    let restored = ferrocut(&["memory", "restore", &file, &other, "--item", "offsets,variables"]);
    assert_eq!(restored.code, 0, "{}", restored.err);
    let counts = json(&ferrocut(&["memory", "show", &other, "--format", "json"]).out)["items"].clone();
    let count = |item: &str| counts[item].as_u64().unwrap();
    assert_eq!((count("offsets"), count("variables"), count("programs"), count("zeros")), (1, 1, 0, 0));
    assert_eq!(ferrocut(&["memory", "restore", &file, &other]).code, 0);
    assert!(ferrocut(&["memory", "show", &other, "--item", "programs"]).out.contains("O1234"));
    // A bit turned on the way.
    let mut bytes = std::fs::read(&file).unwrap();
    let middle = bytes.len() / 2;
    bytes[middle] ^= 1;
    std::fs::write(&file, bytes).unwrap();
    for arguments in [["memory", "check", &file, &file], ["memory", "restore", &file, &other]] {
        let refused = ferrocut(&arguments);
        assert_eq!(refused.code, 1, "{}", refused.out);
        assert!(refused.err.contains("FC-1210"), "{}", refused.err);
    }
    let refused = ferrocut(&["memory", "check", "README.md", "no-such-file"]);
    assert_eq!(refused.code, 2);
    for part in ["FC-1209", "(README.md)", "FC-0901"] {
        assert!(refused.err.contains(part), "{part}: {}", refused.err);
    }
}

#[test]
fn damage_is_told_and_a_good_state_taken_up() {
    let (_folder, path) = killed();
    assert_eq!(ferrocut(&["memory", "check", &path]).code, 0);
    // The log loses its end, and with it a commit that was confirmed.
    let log = format!("{path}/memory.db-wal");
    let bytes = std::fs::read(&log).unwrap();
    std::fs::write(&log, &bytes[..bytes.len() - 50]).unwrap();
    let checked = ferrocut(&["memory", "check", &path]);
    assert_eq!(checked.code, 1);
    for part in ["FC-1201", "ferrocut memory recover"] {
        assert!(checked.err.contains(part), "{part}: {}", checked.err);
    }
    for part in
        ["9 commits are there, 10 were confirmed", "the database itself", "1 confirmed commit is missing"]
    {
        assert!(checked.out.contains(part), "{part}: {}", checked.out);
    }
    // Who starts the control on it is told the newest good state, and how it is taken up.
    let served = ferrocut(&["serve", "--headless", "--tcp", "127.0.0.1:0", "--memory", &path]);
    assert_eq!(served.code, 1, "{}", served.err);
    let command = format!("ferrocut memory recover {path}");
    for part in ["FC-1201", "The newest good state is commit 9 of 20", &command] {
        assert!(served.err.contains(part), "{part}: {}", served.err);
    }
    let told = json(&ferrocut(&["memory", "check", &path, "--format", "json"]).out);
    assert_eq!((&told["whole"], &told["good_states"][0]["commit"]), (&false.into(), &9.into()));
    let file = format!("{path}.backup");
    assert_eq!(ferrocut(&["memory", "backup", &path, "-o", &file]).code, 1);
    assert!(!Path::new(&file).exists());
    let none = ferrocut(&["memory", "recover", &path, "--commit", "77"]);
    assert_eq!((none.code, none.err.contains("no good state with commit 77")), (1, true), "{}", none.err);
    let recovered = ferrocut(&["memory", "recover", &path]);
    assert_eq!(recovered.code, 0, "{}", recovered.err);
    assert!(
        recovered.out.contains("recovered: commit 9") && recovered.out.contains("/damaged-"),
        "{}",
        recovered.out
    );
    assert_eq!(ferrocut(&["memory", "check", &path]).code, 0);
    assert!(ferrocut(&["memory", "show", &path, "--item", "variables"]).out.contains("#501  8"));
    assert!(ferrocut(&["memory", "show", &path, "--item", "log"]).out.contains("recovered"));
    // Once whole it is left alone.
    assert!(ferrocut(&["memory", "recover", &path]).out.contains("whole"));
}

#[test]
fn a_password_is_set_by_who_has_the_files() {
    let (_folder, path) = memory();
    let set = |password: &str| {
        answer(command(&["memory", "password", &path, "--level", "3"]).write_stdin(password.to_owned()))
    };
    let short = set("short\n");
    assert_eq!((short.code, short.err.contains("FC-1219")), (2, true), "{}", short.err);
    assert_eq!(set("correct horse\n").code, 0);
    let store = open(Path::new(&path));
    assert!(store.log_in(Level::Commissioning, "correct horse", Seat::Machine, "Li").is_ok());
    drop(store);
    let shown = ferrocut(&["memory", "show", &path]).out;
    assert!(shown.contains("levels with a password  3"), "{shown}");
    assert!(ferrocut(&["memory", "show", &path, "--item", "log"]).out.contains("password 3"));
}

#[test]
fn a_new_control_gets_its_first_password_before_it_runs() {
    let folder = tempdir().unwrap();
    let path = folder.path().join("new").to_str().unwrap().to_owned();
    let set = |more: &[&str]| {
        let arguments = [&["memory", "password", &path, "--level", "1"], more].concat();
        answer(command(&arguments).write_stdin("correct horse\n"))
    };
    // Without the control there is nothing to make.
    let missing = set(&[]);
    assert_eq!((missing.code, missing.err.contains("FC-1208")), (2, true), "{}", missing.err);
    assert_eq!(set(&["--dialect", "hat"]).code, 2);
    assert!(!Path::new(&path).exists());
    assert_eq!(set(&["--dialect", "gsk990mc"]).code, 0);
    let store = open(Path::new(&path));
    assert!(store.log_in(Level::Maker, "correct horse", Seat::Machine, "Li").is_ok());
    drop(store);
    // The memory of one control is not that of another.
    assert_eq!(set(&["--dialect", "kaitong"]).code, 2);
}

#[test]
fn wrong_use_is_told() {
    let (folder, path) = memory();
    let empty = folder.path().join("empty").to_str().unwrap().to_owned();
    std::fs::create_dir(&empty).unwrap();
    for arguments in [["memory", "show", &empty], ["memory", "check", &empty], ["memory", "recover", &empty]]
    {
        let missing = ferrocut(&arguments);
        assert_eq!((missing.code, missing.err.contains("FC-1208")), (2, true), "{}", missing.err);
    }
    // A file is no folder, and is left as it is.
    let file = common::write(&folder, "mill.backup", "text");
    for arguments in [
        &["memory", "show", &file][..],
        &["memory", "check", &file],
        &["memory", "recover", &file],
        &["memory", "backup", &file, "-o", &format!("{file}.2")],
        &["memory", "password", &file, "--level", "1", "--dialect", "gsk990mc"],
        &["serve", "--headless", "--tcp", "127.0.0.1:0", "--memory", &file],
    ] {
        let answer = answer(command(arguments).write_stdin("correct horse\n"));
        assert!(answer.code == 2 && answer.err.contains(&file), "{arguments:?}: {}", answer.err);
        assert!(!answer.err.contains("FC-1205"), "{arguments:?}: {}", answer.err);
    }
    // What a backup cannot be written to is no fault of the memory's disk.
    for (output, says) in
        [(path.as_str(), "FC-0910"), (empty.as_str(), "FC-0907"), ("no/such/folder/mill.backup", "FC-0907")]
    {
        let answer = ferrocut(&["memory", "backup", &path, "-o", output]);
        assert!(answer.code == 2 && answer.err.contains(says), "{output}: {}", answer.err);
        assert!(answer.err.contains(output), "{output}: {}", answer.err);
    }
    // Looking makes nothing.
    assert!(!Path::new(&empty).join("memory.db").exists());
    let wrong = ferrocut(&["memory", "show", &path, "--item", "tools"]);
    assert_eq!((wrong.code, wrong.err.contains("offsets, zeros")), (2, true), "{}", wrong.err);
    let help = ferrocut(&["memory", "restore", "--help"]).out;
    assert!(help.contains("Examples:") && help.contains("reference-points"));
}
