//! What is written in another language does the same there: each text is run again, and its motion held against
//! that of the `#CYCLE` block.
#![allow(clippy::unwrap_used, clippy::panic)]

use ferrocut_editor::request::{Positions, ToolData, Value};
use ferrocut_editor::style::Style;
use ferrocut_editor::{Control, Request, Written, forms, make, motion, program, run, write};
use ferrocut_interpreter::{Dialect, dialects};
use ferrocut_machine::{Language, Memory, ParameterKey};
use std::time::Instant;

fn dialect(name: &str) -> &'static Dialect {
    dialects::ALL.iter().copied().find(|dialect| dialect.name == name).unwrap()
}

const OTHERS: [&str; 4] = ["gsk990mc", "kaitong", "weihong", "rs274"];

fn request(cycle: &str, values: &[(&str, Value)]) -> Request {
    let all = forms(Language::En);
    let form = all.iter().find(|form| form.id == cycle).unwrap();
    let standard = form.parameters.iter().filter_map(|field| {
        let value = serde_json::to_value(field.standard?).unwrap();
        Some((field.name.clone(), serde_json::from_value(value).unwrap()))
    });
    let mut request = Request { cycle: cycle.to_owned(), values: standard.collect(), ..Request::default() };
    for (name, value) in values {
        request.values.insert((*name).to_owned(), value.clone());
    }
    let tool = |number, diameter| ToolData {
        number,
        diameter: Some(diameter),
        cutting_length: Some(20.0),
        entry_angle: Some(5.0),
        tip_radius: Some(0.0),
    };
    request.tools = vec![tool(1, 8.0), tool(2, 6.0)];
    request
}

fn n(value: f64) -> Value {
    Value::Number(value)
}

fn w(word: &str) -> Value {
    Value::Text(word.to_owned())
}

/// The text in a language, run there by itself and compared with the cycle.
fn proved(request: &Request, name: &str) -> Written {
    let made = make(request, None);
    assert!(made.is_possible(), "{}: {:?}", request.cycle, made.wrong);
    let beside = run::BESIDE[0].to_string();
    let written = write(request, dialect(name), None);
    assert!(!written.text.is_empty(), "{} for {name}: {:?}", request.cycle, written.wrong);
    assert!(!written.text.contains(&beside), "{}", written.text);
    let whole = program(Style::of(name).unwrap(), &written.text);
    let ran = run::run(dialect(name), &whole, Memory::new(name), made.start, false);
    assert_eq!(ran.alarms, [], "{whole}");
    let wanted = motion::motions(&made.steps, made.start).unwrap();
    let done = motion::motions(&ran.steps, made.start).unwrap();
    let different = motion::difference(&wanted, &done);
    assert_eq!(
        different,
        None,
        "{name}\n{whole}\n{:?}\n{:?}",
        different.map(|i| wanted.get(i)),
        different.map(|i| done.get(i))
    );
    written
}

/// Cycles with what may go wrong in another language: arcs both ways, helices of several turns, an exact rest.
fn milling() -> Vec<Request> {
    let pocket =
        [("X", n(12.3456)), ("Y", n(-7.0)), ("alpha", n(15.0)), ("corner", w("round")), ("r", n(9.0))];
    let two_tools = [("finish.T", n(2.0)), ("finish.dir", w("cw")), ("rough.I", n(-4.0))];
    vec![
        request("G287", &[&pocket[..], &two_tools[..]].concat()),
        request("G287", &[("corner", w("chamfer")), ("r", n(6.0)), ("start", w("corner")), ("L", n(-80.0))]),
        request("G288", &[("rough.beta", n(3.0)), ("rough.dir", w("cw"))]),
        request("G289", &[]),
        request("G290", &[("strategy", w("spiral_y"))]),
        request("G291", &[("corner", w("round")), ("r", n(5.0))]),
        request("G292", &[]),
        request("G295", &[("kind", w("through_x"))]),
        request("G296", &[]),
        request("G298", &[("dir", w("cw"))]),
        request("G298", &[("bottom", w("no")), ("B", n(0.7))]),
        request("G299", &[]),
        request("G299", &[("side", w("external")), ("tool", w("single")), ("cut", w("up"))]),
    ]
}

#[test]
fn milling_cycles_are_the_same_moves_in_every_language() {
    for request in milling() {
        for name in OTHERS {
            let written = proved(&request, name);
            assert!(written.is_expanded, "{} {name}", request.cycle);
        }
    }
}

#[test]
fn holes_are_cycles_where_the_control_has_the_same() {
    let grid = Positions {
        kind: "GRID".into(),
        values: [("IX", 20.0), ("NX", 3.0), ("IY", 15.0), ("NY", 2.0)]
            .map(|(k, v)| (k.to_owned(), n(v)))
            .into(),
        points: Vec::new(),
    };
    let with_grid = |request: Request| Request { positions: vec![grid.clone()], ..request };
    let word = |written: &Written| {
        let line = written.text.lines().find(|line| line.starts_with("G98 ")).unwrap_or("");
        line.split(' ').nth(1).unwrap_or("").to_owned()
    };
    for name in OTHERS {
        let drilled = proved(&with_grid(request("G281", &[])), name);
        assert_eq!(
            (word(&drilled).as_str(), drilled.is_expanded),
            ("G81", false),
            "{name}\n{}",
            drilled.text
        );
        assert_eq!(drilled.text.lines().filter(|line| line.starts_with('X')).count(), 5, "{}", drilled.text);
        let reamed = proved(&request("G285", &[]), name);
        assert_eq!((word(&reamed).as_str(), reamed.is_expanded), ("G85", false), "{name}\n{}", reamed.text);
        // One way or the other, the motion is that of the cycle.
        for other in [
            request("G281", &[("t", n(0.5))]),
            request("G281", &[("mode", w("angle")), ("phi", n(8.0))]),
            request("G282", &[("P", n(24.0)), ("I", n(7.0))]),
            request("G282", &[("P", n(4.0))]),
            request("G283", &[("P", n(24.0)), ("I", n(7.0))]),
            request("G283", &[("P", n(24.0)), ("I", n(7.0)), ("B", n(2.0))]),
            request("G285", &[("t", n(0.25))]),
            request("G286", &[("t", n(0.25))]),
            request("G286", &[("retract", w("rapid"))]),
            request("G284", &[("type", w("float")), ("feedtype", w("min")), ("F", n(450.0))]),
            request("G284", &[("type", w("float")), ("spindle", w("ccw"))]),
        ] {
            proved(&with_grid(other), name);
        }
    }
}

#[test]
fn a_cycle_of_the_control_is_used_only_where_its_parameters_make_it_the_same() {
    // GSK990MC P271 is the clearance of G83: 1 mm is the Fagor's (4.4). Its pecks count from R, the Fagor's from the
    // surface: both are the same where the approach plane lies on it.
    let deep = request("G283", &[("P", n(24.0)), ("I", n(7.0)), ("DP", n(0.0))]);
    let gsk = dialect("gsk990mc");
    let with_clearance = |mm: f64| {
        let mut memory = Memory::new("gsk990mc");
        memory.set_parameter(&"P271".parse::<ParameterKey>().unwrap(), mm).unwrap();
        write(&deep, gsk, Some(Control { dialect: gsk, memory: &memory }))
    };
    assert!(with_clearance(1.0).text.contains("G83"), "{}", with_clearance(1.0).text);
    assert!(!with_clearance(1.0).is_expanded);
    assert!(with_clearance(3.0).is_expanded && !with_clearance(3.0).text.is_empty());
}

#[test]
fn rigid_tapping_is_a_cycle_or_refused() {
    let plain = request("G284", &[]);
    for name in OTHERS {
        let written = write(&plain, dialect(name), None);
        match written.text.is_empty() {
            false => assert!(
                written.text.contains(if name == "rs274" { "G33.1 Z" } else { "G84" }),
                "{}",
                written.text
            ),
            true => assert_eq!(written.wrong.last().unwrap().alarm.id.to_string(), "FC-1527", "{name}"),
        }
    }
    for (values, name) in [
        (vec![], "gsk990mc"),
        (vec![], "kaitong"),
        (vec![], "rs274"),
        (vec![("KF", n(2.0))], "rs274"),
        (vec![("spindle", w("ccw"))], "gsk990mc"),
    ] {
        proved(&request("G284", &values), name);
    }
    let left = write(&request("G284", &[("spindle", w("ccw"))]), dialect("rs274"), None);
    assert_eq!(left.wrong.last().unwrap().alarm.id.to_string(), "FC-1527");
    assert!(write(&plain, dialect("gsk990mc"), None).text.contains("M29 S300"), "the GSK990MC taps rigidly");
}

#[test]
fn the_fagor_has_the_cycle_as_such_whatever_is_in_force_before_it() {
    let fagor = dialect("fagor8065");
    let asked = request("G287", &[]);
    let written = write(&asked, fagor, None);
    let text = &written.text;
    assert!(text.starts_with("G17 G71 G90\n#CYCLE G287 [") && !written.is_expanded, "{text}");
    let made = make(&asked, None);
    let run = |before: &str| {
        let program = format!("{before}\n{text}M30\n");
        let ran = run::run(fagor, &program, run::fagor_desk(None, &asked), made.start, false);
        assert!(ran.alarms.is_empty(), "{before}: {:?}", ran.alarms);
        motion::motions(&ran.steps, made.start).unwrap()
    };
    for before in ["G18 G70 G90", "G19 G71 G91"] {
        assert_eq!(motion::difference(&run("G17 G71 G90"), &run(before)), None, "{before}");
    }
}

#[test]
fn a_large_cycle_is_written_in_time_or_refused() {
    let fine =
        request("G287", &[("L", n(400.0)), ("H", n(300.0)), ("rough.step", n(0.5)), ("rough.I", n(0.1))]);
    let begun = Instant::now();
    let written = write(&fine, dialect("gsk990mc"), None);
    println!("{} bytes in {:?}", written.text.len(), begun.elapsed());
    assert!(!written.text.is_empty() || !written.wrong.is_empty());
    // What a Fagor makes of one block may be too long block by block.
    let many = Positions {
        kind: "GRID".into(),
        values: [("IX", 1.0), ("NX", 90.0), ("IY", 1.0), ("NY", 90.0)]
            .map(|(k, v)| (k.to_owned(), n(v)))
            .into(),
        points: Vec::new(),
    };
    let pecked = request("G283", &[("P", n(60.0)), ("I", n(1.0))]);
    let many = Request { positions: vec![many], ..pecked };
    let written = write(&many, dialect("weihong"), None);
    assert_eq!(written.wrong.last().map(|wrong| wrong.alarm.id.to_string()).as_deref(), Some("FC-1526"));
    assert!(write(&many, dialect("fagor8065"), None).text.contains("#MULTI GRID"));
    let endless = request("G287", &[("L", n(90_000.0)), ("H", n(90_000.0)), ("rough.step", n(0.001))]);
    let written = write(&endless, dialect("gsk990mc"), None);
    assert!(written.text.is_empty() && written.wrong.iter().any(|wrong| wrong.is_error()));
}

#[test]
fn the_tools_of_the_machine_are_taken_as_its_table_has_them() {
    let gsk = dialect("gsk990mc");
    let least = |bit: f64| {
        let mut memory = Memory::new("gsk990mc");
        memory.set_parameter(&"P40.7".parse::<ParameterKey>().unwrap(), bit).unwrap();
        memory.tools.get_mut(1).unwrap().radius = 8.0;
        let mut plain = request("G287", &[]);
        plain.tools.clear();
        plain.values.insert("finish.T".into(), n(0.0));
        let made = make(&plain, Some(Control { dialect: gsk, memory: &memory }));
        assert!(made.is_possible(), "{:?}", made.wrong);
        let cuts = made.steps.iter().filter(|step| step.op.is_cutting()).filter_map(|step| step.op.target());
        cuts.map(|to| run::xyz(to)[0]).fold(f64::INFINITY, f64::min)
    };
    // 80 wide about 0, the wall stock 0.2: the tool's middle stays its radius off, which 40#7 has entered as 8 or 16.
    assert!((least(0.0) + 40.0 - 8.2).abs() < 1e-6, "{}", least(0.0));
    assert!((least(1.0) + 40.0 - 4.2).abs() < 1e-6, "{}", least(1.0));
}

/// What is said of a tool is said of that alone; all else is its row of the table, with the wear.
#[test]
fn of_a_tool_that_is_described_in_part_the_rest_is_as_the_table_has_it() {
    let mut memory = Memory::new("gsk990mc");
    memory.set_parameter(&"P40.7".parse::<ParameterKey>().unwrap(), 1.0).unwrap();
    for number in [1, 2] {
        let row = memory.tools.get_mut(number).unwrap();
        (row.radius, row.radius_wear, row.cutting_length) = (10.0, -0.2, 25.0);
        (row.entry_angle, row.tip_radius) = (3.0, 1.0);
    }
    let row = |tool: ToolData| {
        let asked = Request { tools: vec![tool], ..Request::default() };
        let machine = Control { dialect: dialect("gsk990mc"), memory: &memory };
        let desk = run::fagor_desk(Some(machine), &asked);
        let values = |number| {
            let row = desk.tools.get(number).unwrap();
            [row.radius + row.radius_wear, row.cutting_length, row.entry_angle, row.tip_radius]
        };
        // Another tool is none of its business.
        assert_eq!(values(2), [4.9, 25.0, 3.0, 1.0]);
        values(1)
    };
    let only = ToolData { number: 1, ..ToolData::default() };
    assert_eq!(row(only), [4.9, 25.0, 3.0, 1.0]);
    assert_eq!(row(ToolData { diameter: Some(6.0), ..only }), [3.0, 25.0, 3.0, 1.0]);
    assert_eq!(row(ToolData { cutting_length: Some(0.0), ..only }), [4.9, 0.0, 3.0, 1.0]);
    assert_eq!(row(ToolData { entry_angle: Some(7.0), ..only }), [4.9, 25.0, 7.0, 1.0]);
    assert_eq!(row(ToolData { tip_radius: Some(0.5), ..only }), [4.9, 25.0, 3.0, 0.5]);
    // As JSON what is missing is left out.
    let said: ToolData = serde_json::from_str(r#"{"number":1,"tip_radius":0.5}"#).unwrap();
    assert_eq!(said, ToolData { tip_radius: Some(0.5), ..only });
}
