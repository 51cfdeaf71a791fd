//! Plots of velocity, acceleration, jerk and path error.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{command, examples, ferrocut, json, number, on_example, root, with_input, write};
use serde_json::Value;
use tempfile::TempDir;

/// Along X, round a corner, along Y, back.
const CORNER: &str = "M3 S1000\nG0 X0 Y0\nG1 X20 F3000\nY20\nG2 X40 Y0 R20\nG1 X0\nM30\n";

fn near(value: &Value, expected: f64, tolerance: f64) {
    let value = value.as_f64().unwrap();
    assert!((value - expected).abs() <= tolerance, "{value}, not {expected}");
}

#[test]
fn a_corner_is_within_its_tolerance_and_every_axis_within_its_limits() {
    let answer = with_input(&["plot", "-", "--format", "json"], CORNER);
    assert_eq!((answer.code, answer.err.as_str()), (0, ""));
    let plot = json(&answer.out);
    assert_eq!(plot["state"], "ended");
    near(&plot["jerk_window_ms"], 3.0, 1e-9);
    // The demo mill: 10000 mm/min, 2000 mm/s²; tolerance 0.01 mm.
    for axis in ["x", "y"] {
        near(&plot["axes"][axis]["velocity"]["max"], 3000.0, 3.0);
        near(&plot["axes"][axis]["velocity"]["share"], 0.3, 3e-4);
        let share = number(&plot["axes"][axis]["acceleration"], "share");
        assert!((0.3..1.001).contains(&share), "{axis}: {share}");
    }
    // Z stood still.
    assert!(plot["axes"].get("z").is_none());
    near(&plot["speed"]["max"], 3000.0, 3.0);
    near(&plot["speed"]["share"], 1.0, 1e-3);
    let error = &plot["path_error"];
    assert!(number(error, "max") < 0.010_001, "{error}");
}

#[test]
fn a_rounded_joint_shows_in_the_path_error() {
    // A bend of 10 degrees at full feed.
    let program = "M3 S1000\nG1 X20 F3000\nX40 Y3.5\nM30\n";
    let error = &json(&with_input(&["plot", "-", "--format", "json"], program).out)["path_error"];
    assert!((1e-6..0.010_001).contains(&number(error, "max")), "{error}");
    near(&error["limit"], 0.01, 0.0);
}

#[test]
fn exact_stops_leave_no_path_error() {
    let program = "G61\nG1 X10 F2000\nY10\nG3 X0 Y0 R10 Z2\nG2 X0 Y0 I5 J0 Z-3\nM30\n";
    let plot = json(&with_input(&["plot", "-", "--format", "json"], program).out);
    assert!(number(&plot["path_error"], "max") < 1e-9, "{}", plot["path_error"]);
    assert!(number(&plot["axes"]["z"]["velocity"], "max") > 100.0);
}

#[test]
fn positioning_with_every_axis_on_its_own_has_no_path_error() {
    let program = "M3 S1000\nG1 X10 F2000\nG0 X100 Y20 Z-50\nG1 Y40\nG0 Z0\nM30\n";
    let plot = json(&with_input(&["plot", "-", "--format", "json"], program).out);
    assert!(number(&plot["path_error"], "max") < 1e-9, "{}", plot["path_error"]);
}

#[test]
fn every_example_keeps_its_path_and_its_limits() {
    for example in examples() {
        let answer = ferrocut(&[&on_example("plot", &example)[..], &["--format", "json"]].concat());
        let plot = json(&answer.out);
        assert_eq!((answer.code, &plot["state"]), (0, &Value::from("ended")), "{} {}", example.0, answer.err);
        // Where no line is programmed there is no error.
        let share = |of: &Value| of["share"].as_f64().unwrap_or(0.0);
        assert!(share(&plot["path_error"]) <= 1.001, "{}: {}", example.0, plot["path_error"]);
        for (name, axis) in plot["axes"].as_object().unwrap() {
            for quantity in ["velocity", "acceleration", "jerk"] {
                assert!(share(&axis[quantity]) <= 1.001, "{} {name} {quantity}: {axis}", example.0);
            }
        }
    }
}

#[test]
fn the_numbers_are_those_of_the_samples() {
    let folder = TempDir::new().unwrap();
    let (program, csv) = (write(&folder, "part.nc", CORNER), folder.path().join("samples.csv"));
    assert_eq!(ferrocut(&["run", &program, "--samples", csv.to_str().unwrap()]).code, 0);
    let text = std::fs::read_to_string(csv).unwrap();
    let mut x: Vec<f64> =
        text.lines().skip(1).map(|l| l.split(',').nth(1).unwrap().parse().unwrap()).collect();
    // The axis stays where it is.
    x.splice(0..0, [x[0]; 3]);
    x.extend([x[x.len() - 1]; 3]);
    let most = |order: usize, scale: f64| {
        let mut d = x.clone();
        (0..order).for_each(|_| d = d.windows(2).map(|w| (w[1] - w[0]) * 1000.0).collect());
        d.iter().fold(0.0, |most: f64, v| most.max(v.abs())) * scale
    };
    let plot = json(&ferrocut(&["plot", &program, "--format", "json"]).out);
    for (name, order, scale) in [("velocity", 1, 60.0), ("acceleration", 2, 1.0), ("jerk", 3, 1.0)] {
        let expected = most(order, scale);
        near(&plot["axes"]["x"][name]["max"], expected, expected * 1e-9);
    }
}

#[test]
fn acceleration_after_interpolation_shows_in_the_path_error() {
    let folder = TempDir::new().unwrap();
    let text = std::fs::read_to_string(root().join("machines/demo-mill.toml")).unwrap();
    let smooth = "\nafter_cutting = { kind = \"linear\", time_ms = 40.0 }\njerk = 50000.0";
    let text = text.replace("public_programs", "# public_programs").replace("\njerk = 50000.0", smooth);
    let machine = write(&folder, "smooth.toml", text);
    // 3000 mm/min and 40 ms: a corner of continuous path is cut by far more than its tolerance.
    let plot = json(&with_input(&["plot", "-", "--format", "json", "--machine", &machine], CORNER).out);
    let error = &plot["path_error"];
    assert!(number(error, "max") > 0.012 && number(error, "max") < 2.0, "{error}");
    assert!(number(error, "share") > 1.2);
}

#[test]
fn a_plot_is_an_svg_with_what_was_asked_for() {
    let svg = with_input(&["plot", "-", "--axes", "xz"], CORNER).out;
    assert!(svg.starts_with("<svg ") && svg.ends_with("</svg>\n"));
    assert!(svg.contains("<title id=\"title\">- on Demo mill</title>"), "{}", &svg[..400]);
    for text in ["velocity X, mm/min", "jerk Z, mm/s³", "mean over 3 ms", "path error and tolerance"] {
        assert!(svg.contains(text), "{text}");
    }
    assert!(!svg.contains("velocity Y") && !svg.contains("NaN") && !svg.contains("inf"));
    let chinese = with_input(&["plot", "-", "--language", "zh"], CORNER).out;
    assert!(chinese.contains("X 轴加加速度") && chinese.contains("轨迹误差"));
}

#[test]
fn a_long_program_makes_no_larger_file_than_a_short_one() {
    let long = format!("{}M30\n", "G1 X50 Y3 F6000\nX0 Y0\n".repeat(60));
    let svg = with_input(&["plot", "-"], &long).out;
    assert!((20_000..400_000).contains(&svg.len()), "{}", svg.len());
    let folder = TempDir::new().unwrap();
    let file = folder.path().join("plot.svg").into_os_string().into_string().unwrap();
    let answer = with_input(&["plot", "-", "-o", &file, "--from", "1", "--to", "1.5"], &long);
    assert!(answer.code == 0 && answer.out.contains(&file), "{}", answer.err);
    assert!(std::fs::read_to_string(&file).unwrap().len() < 100_000);
}

#[test]
fn a_plot_ends_where_it_is_told_to() {
    let endless = "N1 G1 X10 F1000\nX0\nGOTO 1\n";
    let arguments = ["plot", "-", "--format", "json", "--from", "0.2", "--to", "0.5"];
    let answer = with_input(&arguments, endless);
    let plot = json(&answer.out);
    assert_eq!((answer.code, &plot["state"]), (0, &Value::from("running")));
    let time = number(&plot["speed"], "time_s");
    assert!((0.2..=0.5).contains(&time), "{time}");
}

#[test]
fn a_plot_begins_before_the_program_ends() {
    let folder = TempDir::new().unwrap();
    let file = folder.path().join("plot.svg").into_os_string().into_string().unwrap();
    // Without the spindle, which runs up before motion begins.
    let program = CORNER.trim_start_matches("M3 S1000\n");
    let total = json(&with_input(&["time", "-", "--format", "json"], program).out);
    let total = number(&total, "total_s");
    for from in [1e9, total + 0.01] {
        let answer = with_input(&["plot", "-", "-o", &file, "--from", &from.to_string()], program);
        let says = format!("(--from: {from}; allowed: < ");
        assert!(answer.code == 2 && answer.err.contains(&says), "{}", answer.err);
        let length: f64 = answer.err.split(&says).nth(1).unwrap().split(')').next().unwrap().parse().unwrap();
        assert!((length - total).abs() < 0.01, "{length} {total}");
        assert!(!std::path::Path::new(&file).exists());
    }
    let from = (total - 0.01).to_string();
    assert_eq!(with_input(&["plot", "-", "-o", &file, "--from", &from], program).code, 0);
    // What does not move has a plot all the same.
    assert_eq!(with_input(&["plot", "-"], "M30\n").code, 0);
    assert_eq!(with_input(&["plot", "-", "--from", "1"], "M30\n").code, 0);
}

#[test]
fn an_alarm_leaves_the_plot_of_what_was_run() {
    let answer = with_input(&["plot", "-"], "G1 X10 F1000\nG1 X900\nM30\n");
    assert_eq!(answer.code, 1);
    assert!(answer.err.contains("error") && answer.out.contains("velocity X"));
}

#[test]
fn wrong_settings_are_told() {
    for (arguments, says) in [
        (&["--axes", "XQ"][..], "(--axes: XQ; allowed: XYZA)"),
        (&["--axes", "B"], "(--axes: B; allowed: XYZA)"),
        (&["--axes", ""], "(--axes: ; allowed: XYZA)"),
        (&["--from", "2", "--to", "1"], "(--to: 1; allowed: > 2)"),
        (&["-o", "a.png"], "(--output: a.png; allowed: .svg, -)"),
        (&["--from", "nan"], "seconds"),
        (&["-o", "no/such/folder/plot.svg"], "FC-0907"),
    ] {
        let answer = with_input(&[&["plot", "-"], arguments].concat(), CORNER);
        assert!(answer.code == 2 && answer.err.contains(says), "{arguments:?}: {}", answer.err);
    }
    assert!(!common::root().join("a.png").exists());
    let piped = with_input(&["plot", "-", "-o", "-"], CORNER);
    assert!(piped.code == 0 && piped.out.starts_with("<svg"), "{}", piped.err);
    // The picture that is asked for comes, and the figures beside it.
    let both = with_input(&["plot", "-", "-o", "-", "--format", "json"], CORNER);
    assert_eq!((both.code, both.out), (0, piped.out));
    assert_eq!(json(&both.err)["state"], "ended");
    let help = ferrocut(&["plot", "--help"]).out;
    assert!(help.contains("Examples:") && help.contains("1 % of the limit"), "{help}");
    assert!(command(&["--help"]).output().unwrap().status.success());
}
