//! `run --from`: a program that is taken up in its midst, at a desk.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{ferrocut, json, with_input};
use serde_json::json;

const PART: &str = "O1
G90 G54 G00 X0 Y0 Z-10
T2 M06
S1200 M03 M08
M35
M98 P2 L3
G90 G00 X0 Y0
M30
O2
G91 G01 X10 F3000
Y5
M99
";

#[test]
fn it_is_told_what_is_done_first_and_the_program_goes_on_there() {
    let answer =
        with_input(&["run", "-", "--dialect", "gsk990mc", "--from", "11:2", "--format", "json"], PART);
    assert_eq!(answer.code, 0, "{}", answer.err);
    let report = json(&answer.out);
    let restart = &report["restart"];
    assert_eq!((&restart["line"], &restart["pass"]), (&json!(11), &json!(2)));
    // Before the second Y5: twice X10, once Y5.
    assert_eq!(restart["position"], json!({"x": 20.0, "y": 5.0, "z": -10.0, "a": 0.0}));
    assert_eq!(restart["sent"], json!(["T2", "M06", "M35", "M03 S1200", "M08"]));
    let way = |axis: &str, to: f64| json!({"axis": axis, "to": to, "kind": "rapid", "speed": 5000.0});
    assert_eq!(restart["approach"], json!([way("x", 20.0), way("y", 5.0), way("z", -10.0)]));
    let modal = restart["modal"].as_array().unwrap();
    assert!(modal.contains(&json!({"of": "G03", "program": "G91", "machine": "G90"})), "{modal:?}");
    assert!(modal.contains(&json!({"of": "spindle", "program": "M03 S1200", "machine": "M05"})), "{modal:?}");
    // What is left to cut: Y5, X10, Y5.
    assert_eq!(report["cutting_mm"], json!(20.0));
    assert_eq!((&report["state"], &report["parts"]), (&json!("ended"), &json!(1)));
    // Without it the report is as ever.
    let whole = json(&with_input(&["run", "-", "--dialect", "gsk990mc", "--format", "json"], PART).out);
    assert_eq!((whole.get("restart"), &whole["cutting_mm"]), (None, &json!(45.0)));
}

#[test]
fn people_read_the_same() {
    let answer = with_input(&["run", "-", "--dialect", "gsk990mc", "--from", "7"], PART);
    assert_eq!(answer.code, 0, "{}", answer.err);
    for line in [
        "taken up at line 7, reached for time 1",
        "  block begins at: X30 Y15 Z-10 A0",
        "  sent first: T2 M06 M35 M03 S1200 M08",
        "  the axes go there: X30 Y15 Z-10",
        "    G group 03: G91 / G90",
        "    tool in the spindle: 2 / 0",
    ] {
        assert!(answer.out.contains(line), "{line}\n{}", answer.out);
    }
}

#[test]
fn setpoints_end_where_those_of_the_whole_run_end() {
    let folder = tempfile::tempdir().unwrap();
    let last = |from: &[&str]| {
        let csv = folder.path().join("samples.csv").into_os_string().into_string().unwrap();
        let all = [&["run", "-", "--dialect", "gsk990mc", "--samples", &csv], from].concat();
        assert_eq!(with_input(&all, PART).code, 0);
        let text = std::fs::read_to_string(&csv).unwrap();
        let row = text.lines().last().unwrap();
        row.split_once(',').unwrap().1.to_owned()
    };
    assert_eq!(last(&["--from", "10:3"]), last(&[]));
}

#[test]
fn a_file_beside_the_program_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let main = folder.path().join("main.nc");
    std::fs::write(&main, "O1\nG00 X0\nM98 P2\nM30\n").unwrap();
    std::fs::write(folder.path().join("two.nc"), "O2\nG00 X5\nG00 X9\nM99\n").unwrap();
    let main = main.to_str().unwrap();
    let answer = ferrocut(&["run", main, "--dialect", "gsk990mc", "--from", "two.nc:3", "--format", "json"]);
    assert_eq!(answer.code, 0, "{}", answer.err);
    let report = json(&answer.out);
    assert_eq!((&report["restart"]["line"], &report["restart"]["position"]["x"]), (&json!(3), &json!(5.0)));
    // The program itself may be named too.
    let own = format!("{main}:1");
    assert_eq!(ferrocut(&["run", main, "--dialect", "gsk990mc", "--from", &own]).code, 0);
    let answer = ferrocut(&["run", main, "--dialect", "gsk990mc", "--from", "three.nc:3"]);
    assert!(answer.code == 2 && answer.err.contains("three.nc"), "{}", answer.err);
}

#[test]
fn what_cannot_be_is_refused() {
    let run = |from: &str| with_input(&["run", "-", "--dialect", "gsk990mc", "--from", from], PART);
    for (from, id) in [("10:4", "FC-1441"), ("99", "FC-1440")] {
        let answer = run(from);
        assert!(answer.code == 1 && answer.err.contains(id), "{from}: {}", answer.err);
    }
    for from in ["0", "x", "3:0", "-1", "", "3:x"] {
        assert_eq!(run(from).code, 2, "{from}");
    }
    // A place outside of the limits moves nothing.
    let answer = with_input(&["run", "-", "--from", "3"], "G00 X9000\nG00 X9000 Y1\nG00 Y2\nG00 X0\nM30\n");
    assert!(answer.code == 1 && answer.err.contains("gsk990mc:0501"), "{}", answer.err);
    assert!(!answer.out.contains("parts"), "{}", answer.out);
}
