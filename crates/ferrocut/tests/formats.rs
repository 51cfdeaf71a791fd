//! What programs read: JSON with its keys, standard input and output, pipes.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{command, ferrocut, json, json_lines, root, with_input, write};
use serde_json::Value;
use std::io::{BufRead, BufReader, Read};
use std::process::{Command, Stdio};

const BRACKET: &str = "examples/gsk990mc/bracket.nc";

fn keys(value: &Value) -> Vec<&str> {
    let mut keys: Vec<&str> = value.as_object().unwrap().keys().map(String::as_str).collect();
    keys.sort_unstable();
    keys
}

/// Keys that may not be missing; others may be added.
fn has_keys(value: &Value, needed: &[&str]) {
    let found = keys(value);
    let missing: Vec<_> = needed.iter().filter(|k| !found.contains(k)).collect();
    assert!(missing.is_empty(), "{missing:?} are not in {value}");
}

const TIMES: [&str; 10] = [
    "total_s",
    "cutting_s",
    "rapid_s",
    "dwell_s",
    "tool_change_s",
    "cutting_mm",
    "rapid_mm",
    "tools",
    "min",
    "max",
];

#[test]
fn time_and_run_have_their_keys() {
    for command in ["time", "run"] {
        let report = json(&ferrocut(&[command, BRACKET, "--format", "json"]).out);
        has_keys(&report, &TIMES);
        for tool in report["tools"].as_array().unwrap() {
            has_keys(tool, &["t", "total_s"]);
        }
        for side in ["min", "max"] {
            assert_eq!(keys(&report[side]), ["a", "x", "y", "z"]);
            assert!(report[side].as_object().unwrap().values().all(Value::is_number));
        }
        let tools: Vec<u64> =
            report["tools"].as_array().unwrap().iter().map(|t| t["t"].as_u64().unwrap()).collect();
        assert_eq!(tools, [0, 1, 2, 3, 4, 5, 6]);
    }
    let report = json(&ferrocut(&["run", BRACKET, "--format", "json"]).out);
    has_keys(&report, &["program", "machine", "dialect", "state", "alarm", "parts"]);
    // A program without a move has no extents, but the keys.
    let report = json(&with_input(&["time", "-", "--format", "json"], "M30\n").out);
    has_keys(&report, &TIMES);
    assert_eq!((keys(&report["min"]).len(), report["total_s"].as_f64()), (0, Some(0.0)));
}

#[test]
fn findings_have_their_keys() {
    let answer = with_input(&["check", "-", "--format", "json"], "G0 X1\nG77\nX600\nM30\n");
    let findings = json_lines(&answer.out);
    assert_eq!((answer.code, findings.len()), (1, 2));
    for finding in findings {
        has_keys(&finding, &["file", "line", "column", "length", "alarm", "severity", "message", "help"]);
    }
}

#[test]
fn steps_have_their_keys() {
    let program =
        "T1 M6\nS100 M3\nM8\nG0 X1 A5\nG1 Y2 F50\nG2 I1\nG95 G1 X3 F0.1\nG4 X1\nM10\nM19\nM0\nM30\n";
    let steps = json_lines(&with_input(&["trace", "-", "--format", "json"], program).out);
    let mut seen = Vec::new();
    for step in &steps {
        let op = step["op"].as_str().unwrap();
        let needed: &[&str] = match op {
            "rapid" => &["to"],
            "feed" if step["line"] == 7 => &["to", "frev"],
            "feed" => &["to", "f"],
            "arc" => &["to", "plane", "center", "sweep", "f"],
            "dwell" => &["s"],
            "spindle" => &["dir", "rpm"],
            "coolant" => &["on"],
            "select" | "change" => &["t"],
            "m" | "stop" | "end" => &["code"],
            "orient" => &["deg"],
            _ => panic!("{step}"),
        };
        has_keys(step, needed);
        has_keys(step, &["line"]);
        // Only what is not in the main program names a file.
        assert!(step.get("file").is_none());
        seen.push(op);
    }
    for op in [
        "rapid", "feed", "arc", "dwell", "spindle", "coolant", "select", "change", "m", "orient", "stop",
        "end",
    ] {
        assert!(seen.contains(&op), "{op}");
    }
}

#[test]
fn a_program_from_standard_input_is_the_same_program() {
    let text = std::fs::read_to_string(root().join(BRACKET)).unwrap();
    for command in ["trace", "time"] {
        let file = ferrocut(&[command, BRACKET, "--format", "json"]);
        let piped = with_input(&[command, "-", "--format", "json"], &text);
        assert!(!file.out.is_empty());
        assert_eq!((file.code, file.out), (piped.code, piped.out), "{command}");
    }
    assert_eq!(with_input(&["check", "-"], &text).code, 0);
    let finding = json(with_input(&["check", "-", "--format", "json"], "G77\nM30\n").out.trim());
    assert_eq!((finding["line"].as_u64(), finding["length"].as_u64()), (Some(1), Some(3)));
    assert!(!finding["file"].as_str().unwrap().is_empty());
}

#[test]
fn samples_go_to_standard_output_and_the_report_beside() {
    let folder = tempfile::tempdir().unwrap();
    let file = write(&folder, "part.nc", "G0 X10\nM3 S500\nG1 X20 F600\nM30\n");
    let csv = folder.path().join("samples.csv").into_os_string().into_string().unwrap();
    assert_eq!(ferrocut(&["run", &file, "--samples", &csv]).code, 0);
    let answer = ferrocut(&["run", &file, "--samples", "-"]);
    assert_eq!(answer.out, std::fs::read_to_string(&csv).unwrap());
    assert!(answer.err.contains("parts"), "{}", answer.err);
    let rows: Vec<&str> = answer.out.lines().collect();
    assert_eq!((rows[0], rows[1]), ("t,x,y,z,a", "0,0,0,0,0"));
    assert!(rows.last().unwrap().ends_with(",20,0,0,0"));
    // Digits enough that the value comes back as it was: at least nine.
    assert!(rows.iter().any(|r| r.split(',').nth(1).is_some_and(|x| x.len() >= 11)));
}

/// Starts a command, reads a line of its output, closes the pipe and waits.
fn with_closed_pipe(arguments: &[&str]) {
    let mut child = Command::new(env!("CARGO_BIN_EXE_ferrocut"))
        .args(arguments)
        .current_dir(root())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut out = BufReader::with_capacity(64, child.stdout.take().unwrap());
    let mut line = String::new();
    out.read_line(&mut line).unwrap();
    assert!(!line.is_empty());
    drop(out);
    let mut err = String::new();
    child.stderr.take().unwrap().read_to_string(&mut err).unwrap();
    let status = child.wait().unwrap();
    assert!(!err.contains("panicked"), "{arguments:?}: {err}");
    // A reader that went away is no fault of the program: 0, or 1 where there were findings.
    assert!(matches!(status.code(), Some(0 | 1)), "{arguments:?}: {status} {err}");
}

#[test]
fn a_closed_pipe_ends_it_quietly() {
    let folder = tempfile::tempdir().unwrap();
    let raster = "examples/gsk990mc/raster.nc";
    with_closed_pipe(&["trace", raster]);
    with_closed_pipe(&["run", raster, "--samples", "-"]);
    with_closed_pipe(&["time", raster]);
    with_closed_pipe(&["run", raster]);
    let faults = write(&folder, "faults.nc", "G77 (WHAT FOLLOWS FILLS A PIPE)\n".repeat(2000) + "M30\n");
    with_closed_pipe(&["check", &faults, &faults, &faults, &faults]);
    with_closed_pipe(&["check", &faults, &faults, &faults, &faults, "--format", "json"]);
}

#[test]
fn findings_beyond_counting_are_counted() {
    let folder = tempfile::tempdir().unwrap();
    let faults = write(&folder, "faults.nc", "G77\n".repeat(1000) + "M30\n");
    let answer = ferrocut(&["check", &faults]);
    assert_eq!(answer.code, 1);
    assert!(
        answer.out.lines().last().unwrap().replace([',', '\u{a0}', '.'], "").contains("1000"),
        "{:?}",
        answer.out.lines().last()
    );
    assert!(answer.out.lines().filter(|l| l.starts_with("error")).count() < 1000);
    let answer = ferrocut(&["check", &faults, "--format", "json"]);
    let last = json(answer.out.lines().last().unwrap());
    let told = answer.out.lines().count() as u64 - 1;
    assert_eq!(last["further"].as_u64(), Some(1000 - told), "{last}");
}

#[test]
fn a_finding_in_a_loop_is_told_once_and_hides_no_other() {
    let folder = tempfile::tempdir().unwrap();
    let text = "O1\nM3 S1000\nG91 G1 X600 F500\nX-600\n#1=0\nWHILE[#1LT300]DO1\nG1 X600\nG1 X-600\n\
        #1=#1+1\nEND1\nG777\nM30\n";
    let file = write(&folder, "loop.nc", text);
    let answer = ferrocut(&["check", &file, "--format", "json"]);
    let findings = common::json_lines(&answer.out);
    let of = |f: &serde_json::Value| (f["line"].as_u64().unwrap(), f["times"].as_u64().unwrap());
    assert_eq!(findings.iter().map(of).collect::<Vec<_>>(), [(3, 1), (7, 300), (11, 1)], "{}", answer.out);
    let answer = ferrocut(&["check", &file]);
    assert!(answer.out.contains("G777") && answer.out.contains("300 times"), "{}", answer.out);
    assert!(answer.out.trim_end().ends_with("3 findings"), "{}", answer.out);
}

/// Each path to standard output tells a disk that is full.
#[test]
#[cfg(target_os = "linux")]
fn what_could_not_be_printed_is_told() {
    let raster = "examples/gsk990mc/raster.nc";
    let commands: [&[&str]; 15] = [
        &["import", "crates/exchange/tests/everything.dxf"],
        &["trace", raster],
        &["time", raster],
        &["check", raster],
        &["run", raster],
        &["run", raster, "--samples", "-"],
        &["machine", "params", "export"],
        &["machine", "params", "list"],
        &["machine", "params", "get", "P270"],
        &["machine", "new", "-o", "-"],
        &["machine", "check", "machines/demo-mill.toml"],
        &["plot", raster],
        &["explain", "G84"],
        &["plc", "run", "machines/standard.lad", "--for", "100"],
        &["plc", "check", "machines/standard.lad"],
    ];
    for arguments in commands {
        let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        let output = Command::new(env!("CARGO_BIN_EXE_ferrocut"))
            .args(arguments)
            .current_dir(root())
            .env("LANG", "C")
            .stdout(full)
            .output()
            .unwrap();
        let err = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {err}");
        assert!(err.contains("FC-0907"), "{arguments:?}: {err}");
        // A run that was cut off has no figures.
        assert!(!err.contains("parts"), "{arguments:?}: {err}");
    }
}

#[test]
fn a_program_of_a_million_blocks_streams() {
    // 20 MB: more than is held whole.
    let folder = tempfile::tempdir().unwrap();
    let mut text = String::from("M3 S1000\nG1 F1000\n");
    for k in 0..1_000_000u32 {
        text.push_str(&format!("G1 X{}.{:03} Y{}\n", k % 97, k % 1000, k % 89));
    }
    text.push_str("M30\n");
    let file = write(&folder, "long.nc", text);
    let answer = common::answer(command(&["check", &file]).timeout(std::time::Duration::from_secs(60)));
    assert_eq!(answer.code, 0, "{}", answer.out);
}
