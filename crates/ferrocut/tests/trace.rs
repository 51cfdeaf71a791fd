//! The traces of the examples, step by step.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{answer, examples, ferrocut, json, json_lines, number, on_example, root, with_input, write};
use serde_json::{Map, Value};

/// Half a micrometre, half a thousandth of a degree.
const TOLERANCE: f64 = 0.0005;

/// Fills up `to` with the axes that were not named, from the start position on.
fn filled(steps: Vec<Value>) -> Vec<Value> {
    let mut at = Map::new();
    for axis in ["x", "y", "z", "a"] {
        at.insert(axis.to_owned(), Value::from(0.0));
    }
    steps
        .into_iter()
        .map(|mut step| {
            if let Some(to) = step.get("to").and_then(Value::as_object).cloned() {
                at.extend(to);
                step["to"] = Value::Object(at.clone());
            }
            step
        })
        .collect()
}

fn near(expected: &Value, found: &Value) -> bool {
    match (expected, found) {
        (Value::Number(a), Value::Number(b)) => {
            (a.as_f64().unwrap() - b.as_f64().unwrap()).abs() <= TOLERANCE
        }
        (Value::Array(a), Value::Array(b)) => a.len() == b.len() && a.iter().zip(b).all(|(a, b)| near(a, b)),
        (Value::Object(a), Value::Object(b)) => {
            a.len() == b.len() && a.iter().all(|(key, v)| b.get(key).is_some_and(|f| near(v, f)))
        }
        (a, b) => a == b,
    }
}

#[test]
fn examples_give_their_stored_traces() {
    let mut compared = 0;
    for example in examples() {
        let stored = root().join(example.0.replace(".nc", ".trace.jsonl"));
        let Ok(stored) = std::fs::read_to_string(&stored) else { continue };
        let answer = ferrocut(&on_example("trace", &example));
        assert_eq!((answer.code, answer.err.as_str()), (0, ""), "{}", example.0);
        let (expected, found) = (filled(json_lines(&stored)), filled(json_lines(&answer.out)));
        for (n, (expected, found)) in expected.iter().zip(&found).enumerate() {
            assert!(near(expected, found), "{} step {}: expected {expected}, got {found}", example.0, n + 1);
        }
        assert_eq!(expected.len(), found.len(), "{}", example.0);
        assert!(expected.len() > 20, "{} is hardly a trace", example.0);
        compared += 1;
    }
    assert!(compared >= 6, "{compared} stored traces");
}

#[test]
fn the_raster_holds_its_check() {
    let name = "examples/gsk990mc/raster.nc";
    let check = json(&std::fs::read_to_string(root().join("examples/gsk990mc/raster.check.json")).unwrap());
    let trace = ferrocut(&["trace", name]);
    assert_eq!(trace.code, 0, "{}", trace.err);
    let steps = filled(json_lines(&trace.out));
    let feeds: Vec<&Value> = steps.iter().filter(|s| s["op"] == "feed").collect();
    assert_eq!(feeds.len() as u64, check["feed_moves"].as_u64().unwrap());
    // Down into the material first.
    assert!(feeds[1..].iter().all(|s| s["f"] == check["feed_mm_min"]));
    let point = |step: &Value| ["x", "y", "z"].map(|axis| step["to"][axis].as_f64().unwrap());
    // Length and extents of the cuts: what the generator put out, rounded to micrometres a block.
    let (mut length, mut min, mut max) = (0.0, [f64::MAX; 3], [f64::MIN; 3]);
    let mut at = [0.0; 3];
    for step in steps.iter().filter(|s| s.get("to").is_some()) {
        let to = point(step);
        if step["op"] == "feed" {
            length += (0..3).map(|i| (to[i] - at[i]).powi(2)).sum::<f64>().sqrt();
            for i in 0..3 {
                (min[i], max[i]) = (min[i].min(to[i]), max[i].max(to[i]));
            }
        }
        at = to;
    }
    assert!((length - number(&check, "path_mm")).abs() < 0.01, "{length}");
    for (i, axis) in ["x", "y", "z"].into_iter().enumerate() {
        assert!((min[i] - number(&check["min"], axis)).abs() < TOLERANCE, "{axis} from {}", min[i]);
        assert!((max[i] - number(&check["max"], axis)).abs() < TOLERANCE, "{axis} to {}", max[i]);
        assert!((at[i] - number(&check["final"], axis)).abs() < TOLERANCE, "{axis} ends at {}", at[i]);
    }
    assert_eq!(steps.last().unwrap()["op"], "end");
}

#[test]
fn steps_in_another_file_name_it() {
    let folder = tempfile::tempdir().unwrap();
    let main = write(&folder, "main.nc", "O1\nG0 X1\nM98 P2002\nG0 X3\nM30\n");
    let other = write(&folder, "O2002.nc", "O2002\nG0 X2\nM99\n");
    let steps = json_lines(&ferrocut(&["trace", &main]).out);
    let places: Vec<(u64, bool)> =
        steps.iter().map(|s| (s["line"].as_u64().unwrap(), s.get("file").is_some())).collect();
    assert_eq!(places, [(2, false), (2, true), (4, false), (5, false)]);
    assert_eq!(steps[1]["file"], other.as_str());
    // From beside it as it is typed there.
    let beside = common::answer(common::command(&["trace", "main.nc"]).current_dir(folder.path()));
    assert_eq!(json_lines(&beside.out)[1]["file"], "O2002.nc");
}

#[test]
fn an_alarm_is_the_last_step() {
    let answer = with_input(&["trace", "-"], "G0 X1\nG77\nX2\nM30\n");
    let steps = json_lines(&answer.out);
    assert_eq!((answer.code, steps.len()), (1, 2));
    assert_eq!((steps[1]["op"].as_str(), steps[1]["no"].as_u64()), (Some("alarm"), Some(10)));
    assert_eq!(steps[1]["line"].as_u64(), Some(2));
}

#[test]
fn switches_of_the_operator() {
    let program = "/G0 X1\nG0 X2\nM1\nM30\n";
    let count = |arguments: &[&str]| {
        let mut all = vec!["trace", "-"];
        all.extend(arguments);
        let steps = json_lines(&with_input(&all, program).out);
        let of = |op: &str| steps.iter().filter(|s| s["op"] == op).count();
        (of("rapid"), of("stop"))
    };
    assert_eq!(count(&[]), (2, 0));
    assert_eq!(count(&["--block-skip"]), (1, 0));
    assert_eq!(count(&["--optional-stop"]), (2, 1));
}

#[test]
fn set_up_comes_from_its_file() {
    let folder = tempfile::tempdir().unwrap();
    let setup = write(&folder, "setup.toml", "[start]\nz = 5.0\n[work_offsets]\nG54 = { x = 10.0 }\n");
    let answer = answer(common::command(&["trace", "-", "--setup", &setup]).write_stdin("G0 X1 Z5\nM30\n"));
    let steps = json_lines(&answer.out);
    // X is shifted; Z is where it starts and does not move.
    assert_eq!(steps[0]["to"], serde_json::json!({ "x": 11 }));
}
