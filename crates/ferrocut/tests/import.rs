//! Drawings on the command line: turned into programs, and given to commands in place of one.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{ferrocut, json, json_lines, with_input, write};

const PLT: &str = "IN;SP1;\nPU400,800;\nPD1200,800;\nPD1200,1600,400,1600;\nPU;\nPU800,800;CI200;\nPU0,0;\n";

const SETUP: &str = "[start]\nz = 5.0\n[import]\nformat = \"plt\"\npen_down = -2.0\nfeed = 700\n";

fn dxf(layer: &str) -> String {
    format!(
        "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n{layer}\n10\n0\n20\n0\n11\n10\n21\n0\n0\nCIRCLE\n8\nHOLES\n10\n5\n\
         20\n30\n40\n2.5\n0\nENDSEC\n0\nEOF\n"
    )
}

#[test]
fn a_drawing_runs_in_place_of_a_program() {
    let folder = tempfile::tempdir().unwrap();
    let plot = write(&folder, "plate.plt", PLT);
    let answer = ferrocut(&["trace", &plot]);
    assert_eq!(answer.code, 0, "{}", answer.err);
    assert!(answer.err.contains("read as a PLT drawing (by its name)"), "{}", answer.err);
    let steps = json_lines(&answer.out);
    // What plotters are told beside the drawing is a message.
    assert_eq!((&steps[0]["op"], &steps[0]["line"]), (&"message".into(), &1.into()));
    let cut = steps.iter().find(|s| s["op"] == "feed" && s["to"]["x"] == 30).unwrap();
    assert_eq!((&cut["line"], &cut["f"], cut.get("file")), (&3.into(), &600.into(), None));
    let arc = steps.iter().find(|s| s["op"] == "arc").unwrap();
    assert_eq!((&arc["line"], &arc["sweep"]), (&6.into(), &360.into()));
    for command in ["time", "run"] {
        let answer = ferrocut(&[command, &plot]);
        assert_eq!(answer.code, 0, "{command}: {} {}", answer.out, answer.err);
    }
    let picture = folder.path().join("plate.svg");
    let answer = ferrocut(&["view", &plot, "-o", picture.to_str().unwrap()]);
    assert_eq!(answer.code, 0, "{}", answer.err);
    assert!(std::fs::read_to_string(picture).unwrap().contains("<svg"));
}

#[test]
fn the_set_up_says_how_it_is_cut_and_what_it_is() {
    let folder = tempfile::tempdir().unwrap();
    let setup = write(&folder, "setup.toml", SETUP);
    // By its name a program.
    let plot = write(&folder, "plate.nc", PLT);
    let answer = ferrocut(&["trace", &plot, "--setup", &setup]);
    assert_eq!((answer.code, answer.err.as_str()), (0, ""));
    let steps = json_lines(&answer.out);
    assert!(steps.iter().any(|s| s["op"] == "feed" && s["to"]["z"] == -2));
    assert!(steps.iter().any(|s| s["f"] == 700));
    // The command line wins over it.
    let answer = ferrocut(&["import", &plot, "--setup", &setup, "--depth=-3", "--feed", "900"]);
    assert!(answer.out.contains("Z-3.0") && answer.out.contains("F900"), "{}", answer.out);
    // Weihong 4.3: I and J from the start of the arc or from the work zero, as the control's parameter says.
    for (value, centre) in [(1, "I0.0 J-5.0"), (0, "I20.0 J20.0")] {
        let setup = format!("dialect = \"weihong\"\n{SETUP}[parameters]\nIJK_INCREMENTAL = {value}\n");
        let setup = write(&folder, "weihong.toml", &setup);
        let steps = json_lines(&ferrocut(&["trace", &plot, "--setup", &setup]).out);
        let arc = steps.iter().find(|s| s["op"] == "arc").unwrap();
        assert_eq!(arc["center"], serde_json::json!([20, 20]), "{value}");
        let answer = ferrocut(&["import", &plot, "--setup", &setup, "--to", "weihong"]);
        assert!(answer.code == 0 && answer.out.contains(centre), "{}", answer.out);
    }
    // A set-up need not say what it is, where the drawing does; what is none runs as a program.
    let setup = write(&folder, "setup.toml", SETUP.replace("format = \"plt\"\n", ""));
    for command in ["trace", "import"] {
        let answer = ferrocut(&[command, &plot, "--setup", &setup]);
        assert!(answer.code == 0 && answer.err.contains("(by its content)"), "{}", answer.err);
        assert!(answer.out.contains("700"), "{}", answer.out);
    }
    let program = write(&folder, "part.nc", "G1 X1 F100\nM30\n");
    let answer = ferrocut(&["trace", &program, "--setup", &setup]);
    assert_eq!((answer.code, answer.err.as_str()), (0, ""));
    let answer = ferrocut(&["import", &program, "--setup", &setup]);
    assert!(answer.code == 2 && answer.err.contains("FC-1020"), "{}", answer.err);
    // From standard input, by its content.
    let answer = with_input(&["trace", "-"], PLT);
    assert!(answer.code == 0 && answer.err.contains("(by its content)"), "{}", answer.err);
}

#[test]
fn import_writes_a_program_that_makes_the_same_path() {
    let folder = tempfile::tempdir().unwrap();
    let plot = write(&folder, "plate.plt", PLT);
    let (program, picture) = (folder.path().join("plate.nc"), folder.path().join("plate.png"));
    let (program, picture) = (program.to_str().unwrap(), picture.to_str().unwrap());
    let options = ["import", &plot, "-o", program, "--order", "as-drawn", "--picture", picture];
    let answer = ferrocut(&options);
    assert_eq!(answer.code, 0, "{}", answer.err);
    assert!(answer.out.contains("PLT, 20 x 25 mm, 4 cuts"), "{}", answer.out);
    assert!(std::fs::read(picture).unwrap().starts_with(b"\x89PNG"));
    let text = std::fs::read_to_string(program).unwrap();
    assert!(text.starts_with("O0001\n(plate.plt)\nG21 ") && text.ends_with("M30\n"), "{text}");
    let moves = |file: &str| -> Vec<String> {
        let steps = json_lines(&ferrocut(&["trace", file]).out);
        let moves = steps.into_iter().filter(|s| s["op"] != "message").map(|mut step| {
            step.as_object_mut().unwrap().remove("line");
            step.to_string()
        });
        moves.collect()
    };
    let (mut drawn, written) = (moves(&plot), moves(program));
    // A program that is kept raises the tool before it ends.
    assert_eq!(drawn.pop(), written.last().cloned());
    assert_eq!(drawn, written[..written.len() - 1]);
    let json_said = ferrocut(&["import", &plot, "-o", program, "--format", "json"]);
    let said = json(json_said.out.trim());
    assert_eq!((&said["lines"], &said["arcs"], &said["lowered"]), (&3.into(), &1.into(), &2.into()));
}

#[test]
fn layers_have_their_own_depths_and_tools() {
    let folder = tempfile::tempdir().unwrap();
    let file = write(&folder, "part.dxf", dxf("Outline"));
    let answer = ferrocut(&[
        "import",
        &file,
        "--layer",
        "outline=-3,2,F500",
        "--layer",
        "HOLES=-6,1,S9000",
        "--spindle",
        "12000",
        "--safe",
        "8",
        "--units",
        "inch",
    ]);
    assert_eq!(answer.code, 0, "{}", answer.err);
    for words in [
        "(LAYER Outline)",
        "T2 M6",
        "S12000 M3",
        "G1 Z-3.0",
        "X254.0 F500",
        "T1 M6",
        "S9000 M3",
        "Z-6.0",
        "G0 Z8.0",
    ] {
        assert!(answer.out.contains(words), "{words} in {}", answer.out);
    }
    assert_eq!(answer.out.matches("G0 G43 H2 Z8.0").count(), 1, "{}", answer.out);
    // The control has lengths of seven tools.
    let answer = ferrocut(&["import", &file, "--to", "weihong", "--layer", "holes=-1,7", "--tool", "8"]);
    assert_eq!(answer.code, 0, "{}", answer.err);
    assert!(answer.out.contains("T7 M6\nG0 G43 H7 Z5.0\n") && answer.out.contains("T8 M6\nG0 G49 Z5.0\n"));
    let answer = ferrocut(&["import", &file, "--layer", "holes=skip"]);
    assert!(!answer.out.contains("G3"), "{}", answer.out);
}

#[test]
fn what_is_left_out_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let text = dxf("0").replace("0\nENDSEC\n0\nEOF", "0\nTEXT\n8\n0\n1\nwords\n0\nENDSEC\n0\nEOF");
    let file = write(&folder, "part.dxf", &text);
    let answer = ferrocut(&["import", &file]);
    assert_eq!(answer.code, 0);
    assert!(answer.err.contains("warning[FC-1013]") && answer.err.contains("TEXT, 1"), "{}", answer.err);
    // A warning is a finding.
    let answer = ferrocut(&["check", &file, "--format", "json"]);
    assert_eq!(answer.code, 1);
    let found = json_lines(&answer.out);
    assert!(found.iter().any(|f| f["alarm"] == "FC-1013" && f["line"] == 28 && f["severity"] == "warning"));
    let plot = write(&folder, "part.plt", "PU0,0;\nVS3;PD40,0;\nVS4;");
    let answer = ferrocut(&["trace", &plot]);
    assert_eq!(answer.out.matches(r#""op":"message""#).count(), 1, "{} {}", answer.out, answer.err);
}

#[test]
fn a_broken_drawing_is_one_alarm_at_its_place() {
    let folder = tempfile::tempdir().unwrap();
    let cut = dxf("0");
    for (name, text, alarm, line) in [
        ("a.plt", "PU0,0;\nPD10;\n", "FC-1012", 2),
        ("b.plt", "PU0,0;\n\u{1}?;\n", "FC-1011", 2),
        ("c.plt", "IN;SP1;\n", "FC-1003", 1),
        ("g.plt", "PU0,0;\nXY1,2;\nPD40,0;\n", "FC-1022", 2),
        ("d.dxf", &cut[..cut.len() - 20], "FC-1001", 26),
        ("e.dxf", "0\nSECTION\n2\nENTITIES\n0\nLINE\n10\nx\n", "FC-1006", 8),
        ("f.dxf", "nonsense\n", "FC-1005", 1),
    ] {
        let file = write(&folder, name, text);
        for command in ["trace", "import", "check"] {
            let answer = ferrocut(&[command, &file, "--format", "json"]);
            assert_eq!(answer.code, 1, "{command} {name}: {} {}", answer.out, answer.err);
            let text = if command == "check" { &answer.out } else { &answer.err };
            let finding = json(text.trim());
            assert_eq!((&finding["alarm"], &finding["line"]), (&alarm.into(), &line.into()), "{finding}");
            assert!(
                finding["help"].is_string() && finding["file"].as_str().unwrap().ends_with(name),
                "{finding}"
            );
        }
    }
}

#[test]
fn wrong_use_is_told_as_such() {
    let folder = tempfile::tempdir().unwrap();
    let file = write(&folder, "part.dxf", dxf("0"));
    let program = write(&folder, "part.nc", "G0 X1\nM30\n");
    let plot = write(&folder, "part.plt", PLT);
    let penless = write(&folder, "penless.plt", "PU0,0;PD40,0;PU;");
    for (arguments, says) in [
        (vec!["import", &plot, "--pen", "9=-1"], "(9; it has: 1)"),
        (vec!["import", &penless, "--pen", "9=-1"], "(9; it has: -)"),
        (vec!["import", &program], "neither a PLT nor a DXF"),
        (vec!["import", "no/such.dxf"], "no/such.dxf"),
        (
            vec!["import", &file, "--units", "ell"],
            "--units: ell; allowed: mm, cm, m, inch, in, foot, ft, um, mil)",
        ),
        (vec!["import", &file, "--layer", "HOLES"], "--layer: HOLES; allowed: NAME=DEPTH,TOOL"),
        (vec!["import", &file, "--order", "random"], "--order: random; allowed: shortest, as-drawn)"),
        (vec!["import", &file, "--tolerance", "0"], "--tolerance: 0; allowed: 0.001 … 10)"),
        (vec!["import", &file, "--feed", "0"], "--feed: 0; allowed: > 0, ≤ 1000000)"),
        (vec!["import", &file, "--depth=-3", "--safe=-5"], "--safe: -5, --depth -3; allowed: > -3)"),
        (vec!["import", &file, "--depth", "10"], "--safe: 5, --depth 10"),
        (vec!["import", &file, "--layer", "HOLES=6"], "--safe: 5, depth 6"),
        (vec!["import", &file, "--layer", "HOLSE=skip"], "HOLSE; it has: 0, HOLES"),
        (vec!["import", &file, "--pen", "1=skip"], "1; it has: 0, HOLES"),
        (vec!["import", &file, "--from", "svg"], "--from: svg; allowed: plt, dxf)"),
        (vec!["import", &file, "--to", "fagor"], "fagor"),
        (vec!["import", &file, "--picture", "x.gif"], "x.gif"),
        (vec!["import", &file, "-o", "no/such/folder.nc"], "no/such/folder.nc"),
    ] {
        let answer = ferrocut(&arguments);
        assert_eq!(answer.code, 2, "{arguments:?}: {} {}", answer.out, answer.err);
        assert!(answer.err.contains(says) && answer.err.contains("help"), "{arguments:?}: {}", answer.err);
    }
    let setup = write(&folder, "setup.toml", "[import]\nformat = \"svg\"\n");
    let answer = ferrocut(&["trace", &file, "--setup", &setup]);
    assert!(answer.code == 2 && answer.err.contains("format: svg"), "{}", answer.err);
    // What was given by a set-up file has its name there, and what was given behind it that of the option.
    for (table, options, says) in [
        ("pen_up = -5.0", &[][..], "pen_up: -5, pen_down -1"),
        ("pen_down = -2.0", &["--safe=-5"][..], "--safe: -5, pen_down -2"),
        ("pen_up = 4.0", &["--depth", "6"][..], "pen_up: 4, --depth 6"),
    ] {
        let setup = write(&folder, "setup.toml", format!("[import]\nformat = \"dxf\"\n{table}\n"));
        let answer = ferrocut(&[&["import", file.as_str(), "--setup", setup.as_str()], options].concat());
        assert!(answer.code == 2 && answer.err.contains(says), "{table} {options:?}: {}", answer.err);
    }
}

#[test]
fn a_folder_and_an_empty_file_are_told_as_such() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path().to_str().unwrap();
    let named = folder.path().join("folder.dxf");
    std::fs::create_dir(&named).unwrap();
    for options in [&[][..], &["--from", "plt"]] {
        for file in [place, named.to_str().unwrap()] {
            let answer = ferrocut(&[&["import", file], options].concat());
            let says = format!("{file}: it is a folder");
            assert!(answer.code == 2 && answer.err.contains(&says), "{options:?}: {}", answer.err);
        }
        for name in ["empty.dxf", "empty.plt", "empty.nc"] {
            for text in ["", " \r\n\n"] {
                let file = write(&folder, name, text);
                let answer = ferrocut(&[&["import", file.as_str()], options].concat());
                assert!(answer.code == 1 && answer.err.contains("FC-0903"), "{name}: {}", answer.err);
                assert!(answer.err.contains(&file), "{}", answer.err);
            }
        }
    }
    let answer = with_input(&["import", "-"], "");
    assert!(answer.code == 1 && answer.err.contains("FC-0903"), "{}", answer.err);
}

#[test]
fn what_has_no_effect_is_refused() {
    for switch in ["--block-skip", "--optional-stop"] {
        let answer = ferrocut(&["import", "examples/drawings/plate.dxf", switch]);
        assert!(answer.code == 2 && answer.err.contains(switch), "{}", answer.err);
        assert!(!ferrocut(&["import", "--help"]).out.contains(switch));
        assert!(ferrocut(&["trace", "--help"]).out.contains(switch));
    }
}

#[test]
fn the_examples_become_programs() {
    let plate = "examples/drawings/plate.dxf";
    // As the help of the command has it.
    let help = ferrocut(&["import", "--help"]).out;
    let layers = help.lines().find(|line| line.contains("--layer HOLES=")).unwrap();
    let arguments: Vec<&str> = layers.split_whitespace().skip(3).collect();
    let answer = ferrocut(&[&["import", plate], &arguments[..]].concat());
    assert_eq!(answer.code, 0, "{arguments:?}: {}", answer.err);
    let answer = ferrocut(&["import", plate, "--setup", "examples/drawings/plate.toml"]);
    assert_eq!(answer.code, 0, "{}", answer.err);
    let place = |words: &str| answer.out.find(words).unwrap_or_else(|| panic!("{words}: {}", answer.out));
    // Holes and engraving lie inside of the outline.
    assert!(place("(LAYER OUTLINE)") > place("(LAYER HOLES)"));
    assert!(place("(LAYER OUTLINE)") > place("(LAYER ENGRAVING)"));
    let answer =
        ferrocut(&["import", "examples/drawings/sign.plt", "--pen", "2=-0.5", "--order", "as-drawn"]);
    assert_eq!(answer.code, 0, "{}", answer.err);
    assert!(answer.out.contains("(PEN 2)") && answer.out.contains("G1 Z-0.5"), "{}", answer.out);
}
