//! `plc`: ladders at the command line.
#![allow(missing_docs)]

mod common;

use common::{ferrocut, json_lines, with_input, write};
use serde_json::Value;
use tempfile::tempdir;

const STANDARD: &str = "machines/standard.lad";
const BAD: &str = "END1\nRD X0.0\nTMR 999\nWRT R0.0\nRD X0.0\nWRT F0.0\nEND2\n";
const LATCH: &str = "START = X20.0 ; key\nMOTOR = Y0.0 ; motor\n\
    END1\nRD START\nOR MOTOR\nAND.NOT X20.1\nWRT MOTOR\nEND2\n";

#[test]
fn check_finds_every_fault_with_its_line() {
    let answer = with_input(&["plc", "check", "-", "--format", "json"], BAD);
    let found: Vec<(Value, Value, Value)> = json_lines(&answer.out)
        .into_iter()
        .map(|o| (o["alarm"].clone(), o["line"].clone(), o["column"].clone()))
        .collect();
    let wanted: Vec<(Value, Value, Value)> =
        vec![("gsk990mc:1023".into(), 3.into(), 5.into()), ("gsk990mc:1006".into(), 6.into(), 1.into())];
    assert_eq!((answer.code, found), (1, wanted));
    let answer = with_input(&["plc", "check", "-"], BAD);
    assert!(answer.out.contains("TMR 999") && answer.out.contains("^^^") && answer.out.contains("2 faults"));
    let answer = with_input(&["plc", "check", "-", "--language", "zh"], BAD);
    assert!(answer.out.contains("超出范围"), "{}", answer.out);
}

#[test]
fn the_standard_ladder_is_fine() {
    let answer = ferrocut(&["plc", "check", STANDARD]);
    assert_eq!((answer.code, answer.err.as_str()), (0, ""));
    let answer = ferrocut(&["plc", "check", STANDARD, "--format", "json"]);
    let fine = &json_lines(&answer.out)[0];
    assert!(fine["steps"].as_u64() > Some(900) && fine["first_level_steps"].as_u64() > Some(10));
}

#[test]
fn a_file_that_is_no_ladder_is_told() {
    let answer = ferrocut(&["plc", "check", "no-such.lad", STANDARD]);
    assert_eq!(answer.code, 2);
    assert!(answer.err.contains("gsk990mc:1029") && answer.err.contains("no-such.lad"), "{}", answer.err);
    assert!(answer.out.contains(STANDARD));
    for text in ["\0\0\0\0", "", "<html/>"] {
        let answer = with_input(&["plc", "check", "-"], text);
        assert_eq!(answer.code, 1, "{text:?}");
        assert!(answer.out.contains("gsk990mc:1028"), "{}", answer.out);
    }
    assert_eq!(ferrocut(&["plc", "run", "no-such.lad"]).code, 2);
}

#[test]
fn run_shows_what_changes_and_when() {
    let arguments = [
        "plc",
        "run",
        "-",
        "--set",
        "100:START=1",
        "--set",
        "150:START=0",
        "--set",
        "300:X20.1=1",
        "--for",
        "400",
    ];
    let answer = with_input(&[&arguments[..], &["--format", "json"]].concat(), LATCH);
    let lines = json_lines(&answer.out);
    let changes: Vec<(u64, &str, u64)> = lines
        .iter()
        .filter(|o| o["signal"].is_string())
        .map(|o| (o["ms"].as_u64().unwrap(), o["name"].as_str().unwrap(), o["value"].as_u64().unwrap()))
        .collect();
    assert_eq!((answer.code, changes), (0, vec![(100, "MOTOR", 1), (300, "MOTOR", 0)]));
    let last = lines.last().unwrap();
    assert_eq!((last["ms"].as_u64(), last["stopped"].as_bool()), (Some(400), Some(false)));
    let answer = with_input(&arguments, LATCH);
    assert!(answer.out.contains("100 ms  Y0000.0  on   MOTOR"), "{}", answer.out);
    // A forced signal stays; a byte is watched as a number.
    let answer = with_input(&[&arguments[..], &["--force", "MOTOR=0", "--watch", "Y0,X20"]].concat(), LATCH);
    assert!(!answer.out.contains("Y0000") && answer.out.contains("X0020    1"), "{}", answer.out);
}

#[test]
fn flow_shows_where_the_line_is_on() {
    let answer = with_input(&["plc", "run", "-", "--set", "START=1", "--flow"], LATCH);
    for line in ["4 | RD         X0020.0  *", "6 | AND.NOT    X0020.1  *", "7 | WRT        Y0000.0  *"] {
        assert!(answer.out.contains(line), "{line}: {}", answer.out);
    }
    let answer = with_input(&["plc", "run", "-", "--flow", "--format", "json"], LATCH);
    let lines = json_lines(&answer.out);
    let read = lines.iter().find(|o| o["instruction"] == "RD X0020.0").unwrap();
    assert_eq!(
        (&read["reached"], &read["on"], &read["powered"]),
        (&true.into(), &false.into(), &false.into())
    );
}

#[test]
fn a_loop_is_stopped() {
    let answer =
        with_input(&["plc", "run", "-", "--for", "1000"], "END1\nLBL 1\nRD.NOT X0.0\nJMPB 1\nEND2\n");
    assert_eq!(answer.code, 1);
    assert!(answer.err.contains("gsk990mc:1021") && answer.out.contains("stopped"), "{}", answer.err);
}

#[test]
fn settings_that_cannot_be_used_are_told() {
    for (option, setting, allowed) in [
        ("--set", "NOPE=1", "X20.3, D10, NAME"),
        ("--set", "MOTR=1", "MOTOR"),
        ("--set", "X0.0=2", "0, 1"),
        ("--set", "X0=256", "0 … 255"),
        ("--set", "X0.0", "[MS:]SIGNAL=VALUE"),
        ("--set", "x:X0.0=1", "[MS:]SIGNAL=VALUE"),
        ("--set", "X0.9=1", "X20.3, D10, NAME"),
        ("--force", "X0.0", "SIGNAL=VALUE"),
        ("--watch", "STRT", "START"),
    ] {
        let answer = with_input(&["plc", "run", "-", option, setting], LATCH);
        assert_eq!(answer.code, 2, "{setting}");
        let says = format!("({option}: {setting}; allowed: {allowed})");
        assert!(answer.err.contains("FC-1102") && answer.err.contains(&says), "{}", answer.err);
    }
    let answer = with_input(&["plc", "run", "-"], BAD);
    assert!(answer.code == 1 && answer.err.contains("gsk990mc:1023"));
}

const DIAGRAM: &str = r#"<project><types><pous><pou name="MAIN" pouType="program"><body><LD>
<leftPowerRail localId="1"/>
<contact localId="2"><connectionPointIn><connection refLocalId="1"/></connectionPointIn><variable>X20.0</variable></contact>
<coil localId="3"><connectionPointIn><connection refLocalId="2"/></connectionPointIn><variable>Y0.0</variable></coil>
</LD></body></pou></pous></types></project>
"#;

#[test]
fn a_diagram_becomes_a_list_that_runs_the_same() {
    let folder = tempdir().unwrap();
    let xml = write(&folder, "mill.xml", DIAGRAM);
    let list = folder.path().join("mill.lad").into_os_string().into_string().unwrap();
    let answer = ferrocut(&["plc", "import", &xml]);
    assert_eq!((answer.code, answer.out.as_str()), (0, "END1\nRD X0020.0\nWRT Y0000.0\nEND2\nEND\n"));
    let answer = ferrocut(&["plc", "import", &xml, "-o", &list]);
    assert!(answer.code == 0 && answer.out.contains(&list));
    let run = |file: &str| ferrocut(&["plc", "run", file, "--set", "10:X20.0=1", "--format", "json"]);
    assert_eq!(run(&xml).out, run(&list).out);
    assert!(run(&list).out.contains("Y0000.0"));
    let bad = write(&folder, "bad.xml", DIAGRAM.replace("Y0.0", "MOTOR"));
    let answer = ferrocut(&["plc", "import", &bad]);
    assert_eq!((answer.code, answer.out.as_str()), (1, ""));
    assert!(answer.err.contains("gsk990mc:1012") && answer.err.contains(":4:"), "{}", answer.err);
}

/// What the help and docs/plc.md show does what it shows: a key of the panel and what comes of it.
#[test]
fn the_example_of_the_help_turns_the_coolant_on() {
    let document = std::fs::read_to_string("../../docs/plc.md").unwrap();
    let example = document.lines().find(|line| line.ends_with("KEY_COOLANT=1")).unwrap();
    // The help breaks its lines.
    let help = ferrocut(&["plc", "run", "--help"]).out;
    assert!(help.split_whitespace().collect::<Vec<_>>().join(" ").contains(example), "{help}");
    let words: Vec<&str> = example.split_whitespace().skip(1).collect();
    let answer = ferrocut(&words);
    assert_eq!((answer.code, answer.err.as_str()), (0, ""));
    let turned = answer.out.lines().find(|line| line.ends_with(" COOLANT")).unwrap();
    assert!(turned.contains("100 ms") && turned.contains(" on "), "{turned}");
}
