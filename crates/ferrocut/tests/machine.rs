//! `machine`: machine files, and the parameters of the control in them.
#![allow(missing_docs)]

mod common;

use common::{Answer, ferrocut, json, json_lines, with_input, write};
use ferrocut_machine::{Machine, ParameterTable};
use std::fs;
use tempfile::{TempDir, tempdir};

const SET: &str = "\n[parameters] # mine\n# retract\nP270 = 1.50 # mm\n\"NO43.1\" = 0\n";

/// A machine file with two parameters.
fn mill(folder: &TempDir) -> String {
    write(folder, "mill.toml", format!("{}{SET}", Machine::DEMO_MILL))
}

#[test]
fn what_is_no_machine_file_and_what_is_no_number_are_told() {
    let folder = tempdir().unwrap();
    let program = write(&folder, "part.nc", "O1\nG0 X1\n#1=5\nM30\n");
    let answer = ferrocut(&["machine", "check", &program]);
    let says = "no machine file: it has no axes; \"ferrocut machine new\"";
    assert!(answer.code == 1 && answer.out.contains(says), "{}", answer.out);
    let answer = ferrocut(&["run", &program, "--machine", &program]);
    assert!(answer.code == 2 && answer.err.contains(says), "{}", answer.err);
    let axes = write(&folder, "axes.nc", "O1 (5 axes)\nG0 X1\nM30\n");
    let answer = ferrocut(&["machine", "check", &axes]);
    assert!(answer.code == 1 && answer.out.contains(says), "{}", answer.out);
    for (from, to, says) in [
        // A slip in a machine file is told with its line.
        ("[[axes]]", "[[axis]]", "unknown field `axis`"),
        ("max_rpm = ", "max_rpm = oops", "max_rpm = oops"),
        ("max = 500.0", "max = inf", "axes X: max is inf: it must be a finite number"),
        ("min = -500.0", "min = nan", "axes X: min is NaN: it must be a finite number"),
        ("max = 500.0", "max = -500.0", "axes X: min -500 must be below max -500"),
        ("rapid = 15000.0", "rapid = inf", "axes X: rapid is inf: it must be a finite number"),
    ] {
        assert!(Machine::DEMO_MILL.contains(from), "{from}");
        let file = write(&folder, "mill.toml", Machine::DEMO_MILL.replace(from, to));
        let answer = ferrocut(&["machine", "check", &file]);
        assert!(answer.code == 1 && answer.out.contains(says), "{to}: {}", answer.out);
    }
}

fn params(arguments: &[&str]) -> Answer {
    ferrocut(&[&["machine", "params"], arguments].concat())
}

/// What a command that cannot fail prints.
fn prints(arguments: &[&str]) -> String {
    let answer = params(arguments);
    assert_eq!((answer.code, answer.err.as_str()), (0, ""), "{arguments:?}");
    answer.out
}

fn fails(arguments: &[&str], code: i32, says: &[&str]) {
    let answer = params(arguments);
    assert_eq!((answer.code, answer.out.as_str()), (code, ""), "{arguments:?}: {}", answer.err);
    for text in says {
        assert!(answer.err.contains(text), "{arguments:?}: {text:?} in {}", answer.err);
    }
}

#[test]
fn files_that_a_machine_file_names_lie_beside_it() {
    let folder = tempdir().unwrap();
    let weihong = Machine::DEMO_MILL.replacen("dialect = \"gsk990mc\"", "dialect = \"weihong\"", 1);
    assert_ne!(weihong, Machine::DEMO_MILL);
    let file = write(&folder, "mill.toml", &weihong);
    let line = 1 + weihong.lines().position(|line| line.starts_with("public_programs")).unwrap();
    let answer = ferrocut(&["machine", "check", &file]);
    let place = format!("{file}:{line}: error: public.dat is named here");
    assert!(answer.code == 1 && answer.out.contains(&place), "{}", answer.out);
    write(&folder, "public.dat", Machine::DEMO_PROGRAMS);
    assert!(!ferrocut(&["machine", "check", &file]).out.contains("public.dat"));
}

#[test]
fn new_writes_a_machine_that_every_command_takes_and_never_overwrites() {
    let folder = tempdir().unwrap();
    let file = folder.path().join("new.toml").into_os_string().into_string().unwrap();
    let answer = ferrocut(&["machine", "new", "-o", &file, "--name", "VMC 850"]);
    assert_eq!((answer.code, answer.out), (0, format!("written: {file}\n")));
    let text = fs::read_to_string(&file).unwrap();
    assert_eq!(Machine::from_toml(&text).unwrap().name, "VMC 850");
    assert_eq!(ferrocut(&["run", "examples/gsk990mc/bracket.nc", "--machine", &file]).code, 0);
    let answer = ferrocut(&["machine", "check", &file]);
    assert!(answer.code == 0 && answer.out.starts_with(&format!("{file}: VMC 850\n")), "{}", answer.out);
    let answer = ferrocut(&["machine", "new", "-o", &file]);
    assert_eq!((answer.code, answer.err), (2, format!("error: {file} exists already and was not changed\n")));
    assert_eq!(fs::read_to_string(&file).unwrap(), text);
    assert!(ferrocut(&["machine", "new", "-o", "-"]).out.starts_with("# A machine:"));
    let piped = json(&ferrocut(&["machine", "new", "-o", "-", "--format", "json"]).out);
    assert!(piped["text"].as_str().unwrap().starts_with("# A machine:"), "{piped}");
    let other = folder.path().join("other.toml").into_os_string().into_string().unwrap();
    let said = json(&ferrocut(&["machine", "new", "-o", &other, "--format", "json"]).out);
    assert_eq!(said["file"], other.as_str());
    assert_eq!(ferrocut(&["machine", "new", "-o", "no/such/folder/m.toml"]).code, 2);
}

#[test]
fn check_tells_what_is_wrong_and_summarises() {
    let folder = tempdir().unwrap();
    let good = mill(&folder);
    let answer = ferrocut(&["machine", "check", &good, "--language", "zh"]);
    assert!(
        answer.code == 0 && answer.out.contains("加速度") && answer.out.contains("2000 mm/s²"),
        "{}",
        answer.out
    );
    let text = Machine::DEMO_MILL.replacen("acceleration = 2000.0", "acceleration = 2.0", 1);
    let odd = write(&folder, "odd.toml", format!("{text}\n[parameters]\nP271 = -1\n"));
    let answer = ferrocut(&["machine", "check", &odd]);
    assert_eq!(answer.code, 1);
    let line = |of: &str| text.lines().position(|l| l.starts_with(of)).unwrap() + 1;
    let warning = format!("{odd}:{}: warning: axis X: it takes 125 s", line("acceleration = 2.0"));
    let error =
        format!("{odd}:{}: error: P271 cannot be -1: it must be 0 … 999.9999", text.lines().count() + 3);
    assert!(answer.out.contains(&warning) && answer.out.contains(&error), "{}", answer.out);
    let answer = ferrocut(&["machine", "check", &odd, "--format", "json"]);
    let severities: Vec<_> = json_lines(&answer.out).iter().map(|r| r["severity"].clone()).collect();
    // Behind the remarks the machine, as the text has it.
    assert_eq!(severities, ["warning".into(), "error".into(), serde_json::Value::Null]);
    let machine = json(&ferrocut(&["machine", "check", &good, "--format", "json"]).out);
    assert_eq!((&machine["machine"], &machine["axes"][0]["rapid"]), (&"Demo mill".into(), &15_000.0.into()));
    let bad = write(&folder, "bad.toml", Machine::DEMO_MILL.replacen("\nrapid =", "\nrapids =", 1));
    let answer = ferrocut(&["machine", "check", &bad, &good]);
    assert!(answer.code == 1 && answer.out.contains("unknown field `rapids`"), "{}", answer.out);
    assert!(answer.out.contains("Demo mill"), "the other file is checked all the same");
    assert_eq!(ferrocut(&["machine", "check", "no/such.toml"]).code, 2);
    assert_eq!(with_input(&["machine", "check", "-"], Machine::DEMO_MILL).code, 0);
}

#[test]
fn list_shows_value_default_range_unit_and_meaning() {
    let folder = tempdir().unwrap();
    let mill = mill(&folder);
    let all = prints(&["list"]);
    assert_eq!(all.lines().count(), 1 + ParameterTable::of("gsk990mc").unwrap().len());
    let found = prints(&["list", "--find", "retract distance"]);
    let words: Vec<_> = found.lines().nth(1).unwrap().split_whitespace().collect();
    assert_eq!(words[..8], ["P270", "g73_retract", "2", "2", "0", "…", "999.9999", "mm"]);
    assert_eq!(found.lines().count(), 2);
    let plc = prints(&["list", "--room", "plc"]);
    assert!(plc.lines().skip(1).all(|l| l.contains("  plc  ")) && plc.contains("NO53.0"));
    let changed = prints(&["list", "--changed", "--machine", &mill]);
    assert!(changed.lines().skip(1).all(|l| l.starts_with('*')) && changed.lines().count() == 3, "{changed}");
    assert!(prints(&["list", "--language", "zh"]).lines().next().unwrap().contains("缺省值"));
    let rows = json_lines(&prints(&["list", "--changed", "--machine", &mill, "--format", "json"]));
    assert_eq!(rows.len(), 2);
    assert_eq!(
        (&rows[1]["name"], &rows[1]["value"], &rows[1]["changed"]),
        (&"P270".into(), &1.5.into(), &true.into())
    );
    fails(&["list", "--find", "nothing"], 2, &["error: no parameter of gsk990mc matches nothing\n"]);
    fails(&["list", "--find", "retract", "--room", "plc"], 2, &["matches retract"]);
    for few in [&["--find", "retract distance"][..], &["--room", "plc"], &[]] {
        let unchanged = prints(&[&["list", "--changed"], few].concat());
        assert_eq!(unchanged, "none of these parameters differs from its default\n");
    }
    fails(&["list", "--room", "kitchen"], 2, &["there is no room kitchen; the rooms are acceleration, "]);
}

#[test]
fn get_and_explain_show_single_parameters() {
    let folder = tempdir().unwrap();
    let mill = mill(&folder);
    assert_eq!(prints(&["get", "P270", "43#1", "ODI", "--machine", &mill]), "P270=1.5\nNO43.1=0\nNO40.7=1\n");
    assert_eq!(prints(&["get", "P270"]), "P270=2\n");
    let row = json(&prints(&["get", "P270", "--machine", &mill, "--format", "json"]));
    assert_eq!((&row["value"], &row["default"], &row["max"]), (&1.5.into(), &2.0.into(), &999.9999.into()));
    assert!(prints(&["explain", "g73_retract", "--machine", &mill]).contains("1.5 mm"));
    assert_eq!(json(&prints(&["explain", "P270", "--format", "json"]))["kind"], "parameter");
    fails(&["get", "P270", "P272", "QZB"], 2, &["no parameter P272; near it: P271", "QZB; near it: "]);
    fails(&["explain", "INM"], 2, &["NO0.1, NO3.0"]);
}

#[test]
fn set_changes_the_file_in_place_and_keeps_comments() {
    let folder = tempdir().unwrap();
    let mill = mill(&folder);
    let out = prints(&["set", "P270=2.5", "43#1=1", "ODI=0", "--machine", &mill]);
    let rows: Vec<_> = out.lines().map(|l| l.split_whitespace().collect::<Vec<_>>().join(" ")).collect();
    assert_eq!(rows, ["P270 g73_retract 1.5 → 2.5 mm", "NO43.1 QZA 0 → 1", "NO40.7 ODI 1 → 0"]);
    let set = SET.replace("1.50", "2.5").replace("\"NO43.1\" = 0\n", "\"NO43.1\" = 1\n\"NO40.7\" = 0\n");
    assert_eq!(fs::read_to_string(&mill).unwrap(), format!("{}{set}", Machine::DEMO_MILL));
    prints(&["set", "NO40.7=default", "NO43.1=0", "P270=1.5", "--machine", &mill]);
    let text = fs::read_to_string(&mill).unwrap();
    assert_eq!(text, format!("{}{}", Machine::DEMO_MILL, SET.replace("1.50", "1.5")));
    // No other file is left behind.
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    let row = json(&prints(&["set", "P87=400", "--machine", &mill, "--format", "json"]));
    assert_eq!((&row["old"], &row["new"]), (&300.0.into(), &400.0.into()));
}

#[test]
fn set_takes_all_values_or_none() {
    let folder = tempdir().unwrap();
    let mill = mill(&folder);
    let before = fs::read_to_string(&mill).unwrap();
    let wrong = [
        "P270=1",
        "P271=-1",
        "ODI=2",
        "P9999=1",
        "NO47=1",
        "P5=x",
        "P5",
        "P270=3",
        "P87=inf",
        "--machine",
        &mill,
    ];
    fails(
        &[&["set"], &wrong[..]].concat(),
        2,
        &[
            "P271 cannot be -1: it must be 0 … 999.9999\n",
            "NO40.7 cannot be 2: it is a bit, 0 or 1\n",
            "gsk990mc has no parameter P9999\n",
            "NO47 has several bits: name one, as in NO47.1\n",
            "P5 cannot be x: that is no number\n",
            "P5 sets nothing: write NAME=VALUE\n",
            "P270 is set twice\n",
            "P87 cannot be inf",
            "nothing was written\n",
        ],
    );
    assert_eq!(fs::read_to_string(&mill).unwrap(), before);
    fails(
        &["set", "P271=-1", "--machine", &mill, "--language", "zh"],
        2,
        &["错误：P271 不能为 -1：须为 0 … 999.9999"],
    );
    fails(&["set", "P270=1"], 2, &["--machine"]);
    fails(&["set", "P270=1", "--machine", "no/such.toml"], 2, &["no/such.toml"]);
    let broken = write(&folder, "broken.toml", "name = 1");
    fails(&["set", "P270=1", "--machine", &broken], 2, &["FC-0904"]);
    assert_eq!(fs::read_to_string(&broken).unwrap(), "name = 1");
}

#[test]
fn a_control_without_parameters_takes_none() {
    let folder = tempdir().unwrap();
    for dialect in ["rs274", "fagor8065"] {
        let text =
            Machine::DEMO_MILL.replacen("dialect = \"gsk990mc\"", &format!("dialect = \"{dialect}\""), 1);
        let mill = write(&folder, "mill.toml", &text);
        let says = format!("error: {dialect} has no parameters\n");
        fails(&["list", "--dialect", dialect], 2, &[&says]);
        fails(&["set", "P270=1", "--machine", &mill], 2, &[&says]);
        assert_eq!(fs::read_to_string(&mill).unwrap(), text);
        // What stands in a file is found by a check, and can be taken out.
        let mill = write(&folder, "mill.toml", format!("{text}\n[parameters]\nP270 = 1\n"));
        let answer = params(&["check", "--machine", &mill]);
        assert!(
            answer.code == 1 && answer.out.contains(&format!("{dialect} has no parameters")),
            "{}",
            answer.out
        );
        prints(&["set", "P270=default", "--machine", &mill]);
        assert_eq!(params(&["check", "--machine", &mill]).code, 0);
    }
}

#[test]
fn offsets_are_set_by_their_parameters() {
    let folder = tempdir().unwrap();
    let mill = mill(&folder);
    prints(&["set", "P15=12.5", "g54_offset_axis2=-3", "--machine", &mill]);
    assert_eq!(prints(&["get", "P15", "P16", "--machine", &mill]), "P15=12.5\nP16=-3\n");
    let program = write(&folder, "p.nc", "G54 G0 X1 Y1\nM30\n");
    let trace = ferrocut(&["trace", &program, "--machine", &mill]);
    assert!(trace.out.contains("13.5") && trace.code == 0, "{}", trace.out);
}

#[test]
fn check_finds_every_wrong_parameter() {
    let folder = tempdir().unwrap();
    let good = mill(&folder);
    assert!(
        prints(&["check", "--machine", &good])
            .ends_with("2 parameters of {} checked: no findings\n".replace("{}", &good).as_str())
    );
    let wrong = "\n[parameters]\nP270 = -1\np0270 = 1\nP9999 = 1\n\"NO43.1\" = 2\n\"43#1\" = 1\n";
    let file = write(&folder, "wrong.toml", format!("{}{wrong}", Machine::DEMO_MILL));
    let answer = params(&["check", "--machine", &file]);
    assert_eq!(answer.code, 1);
    for says in [
        "P270 cannot be -1: it must be 0 … 999.9999",
        "p0270 is the same parameter as P270",
        "no parameter P9999",
        "NO43.1 cannot be 2: it is a bit, 0 or 1",
        "43#1 names no parameter",
        "5 parameters of",
        "5 findings",
    ] {
        assert!(answer.out.contains(says), "{says} in {}", answer.out);
    }
    let findings = json_lines(&params(&["check", "--machine", &file, "--format", "json"]).out);
    assert_eq!(findings.len(), 5);
    // What is wrong can be mended.
    prints(&["set", "P270=1", "43#1=1", "--machine", &file]);
    let answer = params(&["check", "--machine", &file]);
    assert!(answer.out.contains("2 findings"), "{}", answer.out);
    // What names nothing can be taken out, and the rest is shown meanwhile.
    let answer = params(&["get", "P270", "--machine", &file]);
    assert_eq!((answer.code, answer.out.as_str()), (0, "P270=1\n"));
    assert!(answer.err.contains("P9999") && answer.err.contains("passed over"), "{}", answer.err);
    prints(&["set", "P9999=default", "--machine", &file]);
    let answer = params(&["check", "--machine", &file]);
    assert!(answer.out.contains("1 finding"), "{}", answer.out);
}

#[test]
fn parameters_that_contradict_each_other_are_found() {
    let folder = tempdir().unwrap();
    let wrong = "\n[parameters]\nP66 = 10\nP67 = 5\nP178 = 1\n\"NO31.1\" = 1\n\"NO31.2\" = 1\nP206 = 2.5\n";
    let file = write(&folder, "wrong.toml", format!("{}{wrong}", Machine::DEMO_MILL));
    let answer = params(&["check", "--machine", &file]);
    for says in [
        "P66 must be below P67",
        "P176 and P178 name the same axis",
        "NO31.1 and NO31.2 cannot both be 1",
        "P206 cannot be 2.5: it is a whole number",
    ] {
        assert!(answer.out.contains(says), "{says} in {}", answer.out);
    }
    // Nothing to change is nothing written.
    let plain = write(&folder, "plain.toml", Machine::DEMO_MILL);
    prints(&["set", "P87=default", "--machine", &plain]);
    assert_eq!(fs::read_to_string(&plain).unwrap(), Machine::DEMO_MILL);
}

#[test]
fn what_is_exported_is_imported() {
    let folder = tempdir().unwrap();
    let mill = mill(&folder);
    assert!(
        prints(&["export"])
            .starts_with("name,value,default,min,max,unit,symbol,axis,room,meaning\nNO0.0,0,0,0,1,,")
    );
    let changed = prints(&["export", "--changed", "--machine", &mill]);
    assert!(
        changed.contains("\nP270,1.5,2,0,999.9999,mm,g73_retract,,canned-cycles,Retract distance d of G73\n"),
        "{changed}"
    );
    assert_eq!(changed.lines().count(), 3);
    let table = folder.path().join("all.csv").into_os_string().into_string().unwrap();
    for _ in 0..2 {
        assert_eq!(prints(&["export", "--machine", &mill, "-o", &table]), format!("written: {table}\n"));
    }
    let before = fs::read_to_string(&mill).unwrap();
    let all = ParameterTable::of("gsk990mc").unwrap().len();
    assert_eq!(
        prints(&["import", &table, "--machine", &mill]),
        format!("no value changed, {all} as before\n")
    );
    assert_eq!(fs::read_to_string(&mill).unwrap(), before);
    let plain = write(&folder, "plain.toml", Machine::DEMO_MILL);
    let out = prints(&["import", &table, "--machine", &plain]);
    assert!(
        out.contains("2 → 1.5 mm") && out.ends_with(&format!("2 values changed, {} as before\n", all - 2)),
        "{out}"
    );
    assert_eq!(prints(&["export", "--changed", "--machine", &plain]), changed);
    assert!(fs::read_to_string(&plain).unwrap().starts_with(Machine::DEMO_MILL));
}

#[test]
fn import_takes_all_rows_or_none_and_tells_every_wrong_one() {
    let folder = tempdir().unwrap();
    let mill = mill(&folder);
    let before = fs::read_to_string(&mill).unwrap();
    let bad = write(&folder, "bad.csv", "name,value\nP271,3\nP270,99999\nfoo,1\nP271,4\n\nP5,abc\nODI,\n");
    let line = |n: u32, says: &str| format!("error: {bad}:{n}: {says}");
    fails(
        &["import", &bad, "--machine", &mill],
        2,
        &[
            &line(3, "P270 cannot be 99999: it must be 0 … 999.9999"),
            &line(4, "gsk990mc has no parameter foo"),
            &line(5, "P271 stands in line 2 already"),
            &line(7, "P5 cannot be abc: that is no number"),
            &line(8, "NO40.7 cannot be : that is no number"),
            "nothing was written",
        ],
    );
    let other = write(&folder, "other.csv", "a,b\n1,2\n");
    fails(&["import", &other, "--machine", &mill], 2, &["has no column name"]);
    fails(&["import", "no/such.csv", "--machine", &mill], 2, &["no/such.csv"]);
    assert_eq!(fs::read_to_string(&mill).unwrap(), before);
    // As a German or Chinese spreadsheet writes it, from standard input.
    let text = "\u{feff}VALUE;Name\r\n3;P270\r\n1;43#1\r\n";
    let answer =
        with_input(&["machine", "params", "import", "-", "--machine", &mill, "--language", "zh"], text);
    assert!(
        answer.code == 0 && answer.out.ends_with("更改 2 个值，0 个不变\n"),
        "{} {}",
        answer.out,
        answer.err
    );
    assert_eq!(prints(&["get", "P270", "43#1", "--machine", &mill]), "P270=3\nNO43.1=1\n");
}

#[test]
fn every_command_has_help_with_what_it_takes() {
    for (command, says) in [
        (&["machine", "--help"][..], "params"),
        (&["machine", "new", "--help"], "never overwritten"),
        (&["machine", "check", "--help"], "Exit status"),
        (&["machine", "params", "--help"], "Examples"),
        (&["machine", "params", "list", "--help"], "canned-cycles"),
        (&["machine", "params", "set", "--help"], "NAME=VALUE"),
        (&["machine", "params", "import", "--help"], "all or none"),
    ] {
        let answer = ferrocut(command);
        assert!(answer.code == 0 && answer.out.contains(says), "{command:?}: {}", answer.out);
    }
}
