//! Which control language a program is read in, and the programs that a machine brings for it.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{Answer, ferrocut, json_lines, root, with_input, write};
use tempfile::TempDir;

/// All languages can read it.
const PLAIN: &str = "G0 X1\nM30\n";

/// `X=` is of the Weihong control alone.
const WEIHONG: &str = "G0 X=1\nM30\n";

/// The demo mill with a control of this language.
fn mill(folder: &TempDir, dialect: &str, more: &str) -> String {
    let text = std::fs::read_to_string(root().join("machines/demo-mill.toml")).unwrap();
    let key = |line: &&str| !line.starts_with("dialect =") && !line.starts_with("public_programs");
    let rest: Vec<&str> = text.lines().filter(key).collect();
    let head = format!("dialect = \"{dialect}\"\n{more}\n");
    write(folder, &format!("{dialect}.toml"), head + &rest.join("\n"))
}

fn check(arguments: &[&str]) -> Answer {
    ferrocut(&[&["check"], arguments].concat())
}

#[test]
fn a_language_that_nobody_named_is_told_with_what_it_was_guessed_from() {
    let folder = TempDir::new().unwrap();
    let plain = write(&folder, "plain.nc", PLAIN);
    // The usual language is no news; reports say it all the same.
    assert_eq!(check(&[&plain]).err, "");
    let report = ferrocut(&["run", &plain]).out;
    assert!(report.contains("gsk990mc (not named; --dialect"), "{report}");
    let content = write(&folder, "content.nc", WEIHONG);
    let answer = check(&[&content]);
    assert_eq!(answer.code, 0, "{}", answer.err);
    assert!(answer.err.contains("weihong (1 of 2 blocks are not gsk990mc; --dialect"), "{}", answer.err);
    for extension in ["mmg", "ENG"] {
        let by_name = write(&folder, &format!("plain.{extension}"), PLAIN);
        let answer = check(&[&by_name]);
        assert_eq!(answer.code, 0);
        assert!(answer.err.contains("weihong (by the extension of the file; --dialect"), "{}", answer.err);
    }
}

#[test]
fn files_of_linuxcnc_name_its_language() {
    let folder = TempDir::new().unwrap();
    let program = write(&folder, "part.nc", "T1 M6\nG43\nG0 Z10\nM2\n");
    let table = write(&folder, "mill.tbl", "T1 P1 Z50 D5\n");
    let variables = write(&folder, "mill.var", "5220\t1\n5221\t0\n");
    let ends = |arguments: &[&str]| {
        let trace = json_lines(&ferrocut(&[&["trace", &program], arguments].concat()).out);
        let last = trace.iter().filter_map(|step| step["to"]["z"].as_f64()).next_back();
        last.unwrap()
    };
    assert_eq!(ends(&[]), 10.0);
    assert_eq!(ends(&["--tool-table", &table]), 60.0);
    let report = ferrocut(&["run", &program, "--var-file", &variables]).out;
    assert!(report.contains("rs274"), "{report}");
    // Beside another language they are of no use, and are not passed over.
    let setup = write(&folder, "setup.toml", "dialect = \"gsk990mc\"\n");
    for (option, file) in [("--tool-table", &table), ("--var-file", &variables)] {
        assert_eq!(ferrocut(&["trace", &program, option, file, "--dialect", "rs274"]).code, 0);
        for other in [["--dialect", "gsk990mc"], ["--setup", &setup]] {
            let answer = ferrocut(&[&["trace", program.as_str(), option, file], &other[..]].concat());
            assert_eq!((answer.code, answer.out.as_str()), (2, ""), "{option} {other:?}");
            let says = format!("({option}: it is for programs of rs274, and gsk990mc is");
            assert!(answer.err.contains(&says), "{}", answer.err);
        }
        let answer = ferrocut(&["trace", &program, option, file, "--dialect", "nosuch"]);
        assert!(answer.code == 2 && answer.err.contains("FC-0905"), "{}", answer.err);
    }
}

#[test]
fn a_machine_file_names_the_language_unless_the_program_proves_another() {
    let folder = TempDir::new().unwrap();
    let gsk = mill(&folder, "gsk990mc", "");
    let by_name = write(&folder, "plain.mmg", PLAIN);
    let answer = check(&[&by_name, "--machine", &gsk]);
    assert_eq!((answer.code, answer.err.as_str()), (0, ""));
    let content = write(&folder, "content.mmg", WEIHONG);
    let answer = check(&[&content, "--machine", &gsk]);
    assert_eq!(answer.code, 0, "{}", answer.err);
    assert!(answer.err.contains("weihong (1 of 2 blocks are not gsk990mc"), "{}", answer.err);
    // What was asked for on the command line is what it is read in.
    let answer = check(&[&content, "--machine", &gsk, "--dialect", "gsk990mc"]);
    assert_eq!(answer.code, 1);
    assert!(!answer.err.contains("blocks are not"), "{}", answer.err);
    // The machine's own language needs no word.
    let weihong = mill(&folder, "weihong", "");
    let answer = check(&[&content, "--machine", &weihong]);
    assert_eq!((answer.code, answer.err.as_str()), (0, ""));
}

#[test]
fn the_demo_machine_homes_by_the_programs_that_come_with_it() {
    let program = "G92 X0 Y0 Z0\nG65 P\"HOME\"\nM30\n";
    let trace = json_lines(&with_input(&["trace", "-", "--dialect", "weihong"], program).out);
    let skips: Vec<_> = trace.iter().filter(|step| step["op"] == "skip").collect();
    // Fast onto the switch and slowly off it, Z first so that the tool is out of the way.
    assert_eq!(skips.len(), 6, "{trace:?}");
    assert!(skips.iter().all(|step| step["file"] == "public.dat"));
    assert_eq!(trace.last().unwrap()["code"], "M30");
    assert!(!trace.iter().any(|step| step["op"] == "alarm"), "{trace:?}");
}

#[test]
fn public_programs_are_given_by_the_command_line_or_the_machine_file() {
    let folder = TempDir::new().unwrap();
    let program = "M40\nM30\n";
    let dwell = |answer: &Answer| {
        let trace = json_lines(&answer.out);
        trace.iter().find(|step| step["op"] == "dwell").map(|step| step["s"].as_f64().unwrap())
    };
    // Without a program for it M40 is no code of this control.
    let none = with_input(&["trace", "-", "--dialect", "weihong"], program);
    assert_eq!((none.code, dwell(&none)), (1, None));
    write(&folder, "shop.dat", "O240\nG04 P2000\nM17\n");
    let other = write(&folder, "other.dat", "O240\nG04 P3000\nM17\n");
    // A machine file's path counts from the machine file.
    let machine = mill(&folder, "weihong", "public_programs = \"shop.dat\"");
    let by_machine = with_input(&["trace", "-", "--machine", &machine], program);
    assert_eq!((by_machine.code, dwell(&by_machine)), (0, Some(2.0)), "{}", by_machine.err);
    let by_command = with_input(&["trace", "-", "--machine", &machine, "--public", &other], program);
    assert_eq!((by_command.code, dwell(&by_command)), (0, Some(3.0)), "{}", by_command.err);
    // A file that is not there is told, before anything is run.
    let missing = folder.path().join("none.dat");
    let answer =
        with_input(&["trace", "-", "--machine", &machine, "--public", missing.to_str().unwrap()], program);
    assert_eq!(answer.code, 2);
    assert!(answer.err.contains("none.dat"), "{}", answer.err);
    // One that the machine file names is told with the machine file, and with what to do; of no use to another control.
    let alone = mill(&folder, "weihong", "public_programs = \"none.dat\"");
    let answer = with_input(&["trace", "-", "--machine", &alone], program);
    assert_eq!((answer.code, answer.out.as_str()), (2, ""));
    for part in ["FC-0904", alone.as_str(), missing.to_str().unwrap(), "public_programs", "--public"] {
        assert!(answer.err.contains(part), "{part}: {}", answer.err);
    }
    assert_eq!(with_input(&["trace", "-", "--machine", &alone, "--public", &other], program).code, 0);
    assert_eq!(with_input(&["trace", "-", "--machine", &alone, "--dialect", "gsk990mc"], PLAIN).code, 0);
}

#[test]
fn parameters_of_the_weihong_control_are_set_by_name() {
    let folder = TempDir::new().unwrap();
    let machine = mill(&folder, "weihong", "");
    let params = |arguments: &[&str]| {
        ferrocut(&[&["machine", "params"], arguments, &["--machine", &machine]].concat())
    };
    let listed = params(&["list"]).out;
    assert!(listed.contains("SAFEHEIGHT") && listed.contains("FIXEDCALI_POS.Z"), "{listed}");
    assert_eq!(params(&["set", "SAFEHEIGHT=25"]).code, 0);
    assert_eq!(params(&["get", "SAFEHEIGHT"]).out, "SAFEHEIGHT=25\n");
    assert_ne!(params(&["set", "AUTOSTOPSPINDLE=2"]).code, 0);
    let read = with_input(&["trace", "-", "--machine", &machine], "X#SAFEHEIGHT\nM30\n");
    assert_eq!(json_lines(&read.out)[0]["to"]["x"], 25, "{}", read.err);
}

#[test]
fn a_machine_goes_to_the_fixed_point_and_a_trace_does_not() {
    // Weihong 5, parameters 19 to 22: after each program the control takes the tool there.
    let folder = TempDir::new().unwrap();
    let setup = "[start]\nz = -20\n[parameters]\nENABLE_CTP = 1\n\"CTP_POS.X\" = 12\n\"CTP_POS.Z\" = -5\n";
    let setup = write(&folder, "point.toml", setup);
    let answer = |command: &str, more: &[&str]| {
        let arguments = [&[command, "-", "--dialect", "weihong", "--setup", &setup], more].concat();
        with_input(&arguments, "G00 X1\nM30\n").out
    };
    let trace = json_lines(&answer("trace", &[]));
    assert_eq!(trace.len(), 2, "{trace:?}");
    let run = json_lines(&answer("run", &["--format", "json"]));
    let report = run.last().unwrap();
    assert_eq!(report["rapid_mm"], 27.0, "{report}");
}
