//! The main job: setpoints within every limit, through every programmed point, and a report that adds
//! up.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{examples, ferrocut, json, json_lines, machine_file, number, on_example, root, with_input};
use ferrocut_machine::Machine;
use serde_json::Value;
use std::time::{Duration, Instant};

const BRACKET: &str = "examples/gsk990mc/bracket.nc";
const AXES: [&str; 4] = ["x", "y", "z", "a"];

/// Finite differences are means of the true derivative and never overstate it.
const SLACK: f64 = 1.001;

type Point = [f64; 4];

/// Setpoints of a run, one a servo period.
fn samples(example: &(String, Option<String>)) -> (Vec<Point>, Value, String) {
    let folder = tempfile::tempdir().unwrap();
    let csv = folder.path().join("samples.csv").into_os_string().into_string().unwrap();
    let mut arguments = on_example("run", example);
    arguments.extend(["--format", "json", "--samples", &csv]);
    let answer = ferrocut(&arguments);
    // A program may speak, but there is nothing to complain of.
    let complains = ["error", "warning"].iter().any(|word| answer.err.contains(word));
    assert!(answer.code == 0 && !complains, "{}: {}", example.0, answer.err);
    let text = std::fs::read_to_string(&csv).unwrap();
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("t,x,y,z,a"));
    let points = lines
        .enumerate()
        .map(|(k, line)| {
            let values: Vec<f64> = line.split(',').map(|v| v.parse().unwrap()).collect();
            assert!((values[0] - k as f64 * 0.001).abs() < 1e-9, "{line}: not one a period");
            values[1..].try_into().unwrap()
        })
        .collect();
    (points, json(&answer.out), text)
}

fn bracket() -> (String, Option<String>) {
    (BRACKET.to_owned(), None)
}

#[test]
fn no_axis_of_any_example_exceeds_its_limits() {
    for example in examples() {
        let text = machine_file(&example).map(|file| std::fs::read_to_string(root().join(file)).unwrap());
        let machine = text.map_or_else(Machine::demo_mill, |text| Machine::from_toml(&text).unwrap());
        let period = machine.servo_period_ms / 1000.0;
        let (points, ..) = samples(&example);
        assert!(points.len() > 10_000, "{}: {} setpoints", example.0, points.len());
        for (i, axis) in AXES.iter().enumerate() {
            let limits = machine.axes.iter().find(|a| a.name.name() == *axis).unwrap();
            let fastest = limits.rapid.max(limits.velocity) / 60.0 * SLACK;
            let steepest = limits.acceleration * SLACK;
            // Samples have nine digits behind the point; a third difference has eight halves of the last.
            let jerk_limit = if limits.jerk > 0.0 { limits.jerk } else { f64::INFINITY };
            let hardest = jerk_limit * SLACK + 8.0 * 0.5e-9 / period.powi(3);
            let at = |k: isize| points[k.clamp(0, points.len() as isize - 1) as usize][i];
            // Three periods of rest at either end.
            for k in -3..points.len() as isize {
                let (a, b, c, d) = (at(k), at(k + 1), at(k + 2), at(k + 3));
                let velocity = (b - a).abs() / period;
                let acceleration = (c - 2.0 * b + a).abs() / (period * period);
                assert!(velocity <= fastest, "{} {axis} at {k} ms: {velocity} mm/s", example.0);
                assert!(acceleration <= steepest, "{} {axis} at {k} ms: {acceleration} mm/s²", example.0);
                let jerk = (d - 3.0 * c + 3.0 * b - a).abs() / period.powi(3);
                assert!(jerk <= hardest, "{} {axis} at {k} ms: {jerk} mm/s³", example.0);
            }
        }
    }
}

/// The end of a programmed move, and whether the axes must come to rest there: something happens
/// before the next move, it ends positioning or begins it, or the way goes straight back.
struct Corner {
    at: Point,
    stops: bool,
    line: u64,
    /// Length of the move that ends there, rotary axes counted in.
    length: f64,
}

/// First, second and third axis of the plane of an arc.
fn plane_axes(arc: &Value) -> [usize; 3] {
    match arc["plane"].as_str() {
        Some("xy") => [0, 1, 2],
        Some("zx") => [2, 0, 1],
        Some("yz") => [1, 2, 0],
        plane => panic!("{plane:?}"),
    }
}

/// `rapids_stop` where positioning does not run on into cutting and back, as it does under G64 of rs274.
fn corners(trace: &[Value], rapids_stop: bool) -> Vec<Corner> {
    let mut corners: Vec<Corner> = Vec::new();
    let mut at = [0.0; 4];
    let mut way: Option<[f64; 4]> = None;
    let mut rapid = false;
    for step in trace {
        // The path runs on over a message.
        if step["op"] == "message" {
            continue;
        }
        let Some(to) = step.get("to") else {
            // A pause, the spindle, a tool, coolant, the end.
            if let Some(last) = corners.last_mut() {
                last.stops = true;
            }
            continue;
        };
        let end: Point = std::array::from_fn(|i| to[AXES[i]].as_f64().unwrap_or(at[i]));
        let is_rapid = step["op"] == "rapid";
        let now = (step["op"] == "feed" || is_rapid).then(|| {
            let d: Point = std::array::from_fn(|i| end[i] - at[i]);
            let length = d.iter().map(|v| v * v).sum::<f64>().sqrt();
            d.map(|v| v / length)
        });
        if let Some(last) = corners.last_mut() {
            last.stops |= rapids_stop && rapid != is_rapid;
            if let (Some(a), Some(b)) = (way, now) {
                last.stops |= a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>() < -0.999_999;
            }
        }
        let length = match step["sweep"].as_f64() {
            None => distance(&at, &end),
            Some(sweep) => {
                let [a, b, c] = plane_axes(step);
                let center = |i: usize| step["center"][i].as_f64().unwrap();
                let radius = (at[a] - center(0)).hypot(at[b] - center(1));
                (radius * sweep.to_radians()).hypot(end[c] - at[c])
            }
        };
        corners.push(Corner { at: end, stops: false, line: step["line"].as_u64().unwrap(), length });
        (at, way, rapid) = (end, now, is_rapid);
    }
    corners
}

fn distance(a: &Point, b: &Point) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

/// Distance from `p` to the straight piece from `a` to `b`.
fn off(p: &Point, a: &Point, b: &Point) -> f64 {
    let d: Point = std::array::from_fn(|i| b[i] - a[i]);
    let dot = |x: &Point, y: &Point| x.iter().zip(y).map(|(x, y)| x * y).sum::<f64>();
    let rest: Point = std::array::from_fn(|i| p[i] - a[i]);
    let length = dot(&d, &d);
    let s = if length > 0.0 { (dot(&rest, &d) / length).clamp(0.0, 1.0) } else { 0.0 };
    distance(p, &std::array::from_fn(|i| a[i] + s * d[i]))
}

#[test]
fn every_programmed_point_is_reached() {
    for example in examples() {
        let (points, ..) = samples(&example);
        let trace = json_lines(&ferrocut(&on_example("trace", &example)).out);
        let text = std::fs::read_to_string(root().join(&example.0)).unwrap();
        let rapids_stop = !text.contains("G64");
        let corners = corners(&trace, rapids_stop);
        let fewest = if rapids_stop { 5 } else { 1 };
        assert!(corners.iter().filter(|c| c.stops).count() >= fewest, "{}", example.0);
        // The machine's tolerance, or the program's own.
        let own = text.split("G64 P").nth(1).and_then(|rest| rest.split_whitespace().next());
        let tolerance = own.map_or(0.01, |own| own.parse().unwrap()) + 0.0005;
        let mut walked = vec![0.0];
        for pair in points.windows(2) {
            walked.push(walked.last().unwrap() + distance(&pair[0], &pair[1]));
        }
        let (mut from, mut passed, mut length) = (0, Vec::new(), 0.0);
        for corner in &corners {
            length += corner.length;
            if !corner.stops {
                passed.push((corner, length));
                continue;
            }
            // A round corner is shorter than a sharp one by less than five times what it leaves it by.
            let least = length - (0.05 * passed.len() as f64).min(0.1 * length) - 0.001;
            length = 0.0;
            // At rest on the point itself, to a micrometre: the last period's way is what an axis makes of
            // its acceleration from rest, a·t² = 2 µm, for each of them at most.
            let rests = |k: usize| k == 0 || distance(&points[k - 1], &points[k]) < 0.004;
            let found = (from..points.len()).find(|k| {
                walked[*k] - walked[from] >= least && distance(&points[*k], &corner.at) < 0.001 && rests(*k)
            });
            let Some(found) = found.map(|k| k - from) else {
                panic!("{} line {}: {:?} is missed", example.0, corner.line, corner.at)
            };
            for (corner, after) in passed.drain(..) {
                // Run through within the machine's tolerance; between two setpoints the way leaves the
                // chord by less than a·t²/8.
                let first = walked.partition_point(|w| *w < walked[from] + 0.9 * after - 1.0).max(from);
                let way = &points[first..=from + found];
                // Axes that position on their own go round by this much at most.
                const MOST: f64 = 1.75;
                let enough = walked[first..].partition_point(|w| *w < walked[from] + MOST * after + 1.0);
                let near = way.windows(2).take(enough).map(|w| off(&corner.at, &w[0], &w[1]));
                let nearest = near.fold(f64::MAX, f64::min);
                assert!(nearest <= tolerance, "{} line {}: passed at {nearest} mm", example.0, corner.line);
            }
            from += found;
        }
        assert!(passed.is_empty());
        // The end is the programmed one and nothing follows.
        // To the digits of the trace, a nanometre.
        let end = distance(points.last().unwrap(), &corners.last().unwrap().at);
        assert!(end < 1e-6, "{} ends {end} mm beside", example.0);
        assert!(distance(&points[from], points.last().unwrap()) < 0.001, "{}", example.0);
    }
}

#[test]
fn the_same_file_gives_the_same_setpoints_byte_by_byte() {
    let (_, first_report, first) = samples(&bracket());
    let (_, second_report, second) = samples(&bracket());
    assert!(first == second, "the setpoints differ");
    assert_eq!(first_report, second_report);
}

/// Lengths of the cutting and positioning moves of a trace over X, Y, Z, mm.
fn lengths(trace: &[Value]) -> (f64, f64) {
    let (mut cut, mut rapid) = (0.0, 0.0);
    let mut at = [0.0; 4];
    let moves = trace.iter().filter(|s| s.get("to").is_some());
    for (step, corner) in moves.zip(corners(trace, true)) {
        // Degrees are no distance.
        let [x, y, z, _]: Point = std::array::from_fn(|i| corner.at[i] - at[i]);
        let straight = x.hypot(y).hypot(z);
        match step["op"].as_str() {
            Some("rapid") => rapid += straight,
            Some("arc") => cut += corner.length,
            _ => cut += straight,
        }
        at = corner.at;
    }
    (cut, rapid)
}

#[test]
fn reports_add_up() {
    for example in examples() {
        let (points, report, _) = samples(&example);
        let total = number(&report, "total_s");
        let parts = ["cutting_s", "rapid_s", "dwell_s", "tool_change_s", "spindle_s"];
        let sum: f64 = parts.iter().map(|key| number(&report, key)).sum();
        assert!((total - sum).abs() < 1e-6, "{}: {total} of {sum}", example.0);
        let tools = report["tools"].as_array().unwrap();
        let by_tool: f64 = tools.iter().map(|t| number(t, "total_s")).sum();
        assert!((total - by_tool).abs() < 1e-6, "{}: {total} by tools {by_tool}", example.0);
        assert!(tools.iter().all(|t| t["t"].is_u64()));
        assert_eq!((report["parts"].as_u64(), report["state"].as_str()), (Some(1), Some("ended")));
        // One setpoint a period from the first motion on, and the one of before.
        let sampled = (points.len() - 1) as f64 * 0.001;
        assert!(sampled <= total + 1e-9 && sampled > total - 10.0, "{}: {sampled} of {total}", example.0);
        // The way is the programmed one, and no faster than the fastest axes.
        let trace = json_lines(&ferrocut(&on_example("trace", &example)).out);
        let (cut, rapid) = lengths(&trace);
        assert!((number(&report, "cutting_mm") - cut).abs() < 0.01, "{}: {cut}", example.0);
        assert!((number(&report, "rapid_mm") - rapid).abs() < 0.01, "{}: {rapid}", example.0);
        // A tap is fed by its pitch.
        let tap = |s: &Value| Some(s["pitch"].as_f64()?.abs() * s["rpm"].as_f64()?);
        let feed = |s: &Value| s["f"].as_f64().or_else(|| tap(s));
        let fastest_cut = trace.iter().filter_map(feed).fold(0.0, f64::max) / 60.0;
        // A helix has its feed along the circle, and climbs beside it.
        assert!(number(&report, "cutting_s") * fastest_cut * 1.2 > cut, "{}", example.0);
        assert!(number(&report, "rapid_s") * 250.0 * 3f64.sqrt() > rapid, "{}", example.0);
        let moves = trace.iter().filter(|s| s.get("to").is_some()).count();
        assert_eq!(report["moves"].as_u64(), Some(moves as u64), "{}", example.0);
        // Extents: where the setpoints were, as near as corners are rounded.
        for (i, axis) in AXES.iter().enumerate() {
            let least = points.iter().map(|p| p[i]).fold(f64::MAX, f64::min);
            let most = points.iter().map(|p| p[i]).fold(f64::MIN, f64::max);
            assert!(
                (number(&report["min"], axis) - least).abs() < 0.011,
                "{} {axis} from {least}",
                example.0
            );
            assert!((number(&report["max"], axis) - most).abs() < 0.011, "{} {axis} to {most}", example.0);
        }
    }
}

#[test]
fn prediction_is_what_the_run_takes() {
    for example in examples() {
        let mut arguments = on_example("time", &example);
        arguments.extend(["--format", "json"]);
        let time = json(&ferrocut(&arguments).out);
        arguments[0] = "run";
        let run = json(&ferrocut(&arguments).out);
        for (key, value) in time.as_object().unwrap() {
            assert_eq!(value, &run[key], "{} {key}", example.0);
        }
    }
}

#[test]
fn examples_have_nothing_to_complain_of() {
    for example in examples() {
        let mut arguments = on_example("check", &example);
        arguments.extend(["--format", "json"]);
        let answer = ferrocut(&arguments);
        assert_eq!((answer.code, answer.out.as_str(), answer.err.as_str()), (0, "", ""), "{}", example.0);
    }
}

#[test]
fn the_report_for_people() {
    let answer = ferrocut(&["run", BRACKET]);
    assert_eq!((answer.code, answer.err.as_str()), (0, ""));
    let run = json(&ferrocut(&["run", BRACKET, "--format", "json"]).out);
    let seconds = number(&run, "total_s");
    let clock = format!("{}:{:04.1}", (seconds / 60.0) as u64, seconds % 60.0);
    for needed in [
        BRACKET.to_owned(),
        "Demo mill".to_owned(),
        "gsk990mc".to_owned(),
        clock,
        "T6".to_owned(),
        format!("{:.1} mm", number(&run, "cutting_mm")),
        format!("{:.1} mm", number(&run, "rapid_mm")),
        "parts".to_owned(),
    ] {
        assert!(answer.out.contains(&needed), "no {needed} in {}", answer.out);
    }
    // No colours, no progress in a pipe.
    assert!(!answer.out.contains(['\u{1b}', '\r']));
}

#[test]
fn overrides_stretch_their_kind_of_motion() {
    let program = "M3 S1000\nG1 X300 F1200\nG0 X0\nM30\n";
    let times = |arguments: &[&str]| {
        let mut all = vec!["run", "-", "--format", "json"];
        all.extend(arguments);
        let report = json(&with_input(&all, program).out);
        (number(&report, "cutting_s"), number(&report, "rapid_s"))
    };
    let (cut, rapid) = times(&[]);
    assert!((cut - 15.04).abs() < 0.0021, "{cut}");
    let (slow_cut, same) = times(&["--feed-override", "50"]);
    assert!((slow_cut - 30.0283).abs() < 0.0021 && same == rapid, "{slow_cut} {same}");
    let (same, slow_rapid) = times(&["--rapid-override", "25%"]);
    assert!(slow_rapid > 3.5 * rapid && same == cut, "{slow_rapid} {same}");
}

#[test]
fn real_time_takes_its_time_and_gives_the_same_report() {
    let program = "G0 X20\nG4 X0.3\nX0\nM30\n";
    let began = Instant::now();
    let real = with_input(&["run", "-", "--realtime", "--format", "json"], program);
    let took = began.elapsed();
    let report = json(&real.out);
    assert_eq!(report, json(&with_input(&["run", "-", "--format", "json"], program).out));
    // Never early; how late is the business of the machine that the test runs on.
    assert!(took >= Duration::from_secs_f64(number(&report, "total_s") * 0.98), "{took:?}");
}

#[test]
fn stops_are_told_and_passed_where_nobody_sits() {
    let answer = with_input(&["run", "-"], "G0 X1\nM0\nX2\nM30\n");
    assert_eq!(answer.code, 0);
    assert!(answer.err.contains("M00"), "{}", answer.err);
    assert!(answer.out.contains("parts"));
}

#[test]
fn what_an_alarm_ended_says_so_above_its_times() {
    for command in ["time", "run"] {
        let answer = with_input(&[command, "-"], "G1 X5 F0\nM30\n");
        assert_eq!(answer.code, 1);
        let text = "stopped by an alarm; what was done until then:\n  time      0:00.0\n";
        assert!(answer.out.contains(text), "{}", answer.out);
    }
}

#[test]
fn a_run_tells_what_a_check_warns_of() {
    let folder = tempfile::tempdir().unwrap();
    // Part 2, 7.10: S beyond P258 is held there; 4.5.1: F beyond P96 counts as P96. A line that comes again is told once.
    let setup =
        common::write(&folder, "held.toml", "[start]\nz = 50\n[parameters]\nP96 = 1500\nP258 = 3000\n");
    let program = "M98 P100 L2\nM3 S1000\nG99 G84 X1 Z-5 R2 F3000\nG80 M5\nM30\nO100\nM3 S4000\nM5\nM99\n";
    for (command, more) in [("run", None), ("time", None), ("plot", None), ("run", Some("--realtime"))] {
        let program = if more.is_some() { "M3 S4000\nM5\nM30\n" } else { program };
        let mut arguments = vec![command, "-", "--setup", &setup, "--format", "json"];
        arguments.extend(more);
        let answer = with_input(&arguments, program);
        let told: Vec<(Value, Value)> = json_lines(&answer.err)
            .into_iter()
            .inspect(|told| assert_eq!(told["severity"], "warning"))
            .map(|mut told| (told["alarm"].take(), told["line"].take()))
            .collect();
        let fast = |line| (Value::from("gsk990mc:0182"), Value::from(line));
        let expected = match more {
            None => vec![fast(7), (Value::from("FC-0533"), Value::from(3))],
            Some(_) => vec![fast(1)],
        };
        assert_eq!((answer.code, told), (0, expected), "{command} {more:?}: {}", answer.out);
    }
    // The search for the place to take a program up is no run.
    let taken_up =
        with_input(&["run", "-", "--setup", &setup, "--from", "3"], "M3 S4000\nG1 X1 F100\nX2\nX3\nM30\n");
    assert_eq!((taken_up.code, taken_up.err.matches("0182").count()), (0, 0), "{}", taken_up.err);
}
