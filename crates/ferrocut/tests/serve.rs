//! `ferrocut serve` as a sender meets it.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

mod common;

use assert_cmd::cargo::CommandCargoExt;
use common::served::{Front, Served};
use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// What comes, until it ends with a text.
fn until(stream: &mut TcpStream, end: &str) -> String {
    let mut heard = Vec::new();
    let began = Instant::now();
    while !heard.ends_with(end.as_bytes()) {
        assert!(began.elapsed() < Duration::from_secs(30), "{}", String::from_utf8_lossy(&heard));
        let mut piece = [0; 512];
        match stream.read(&mut piece) {
            Ok(0) => panic!("closed: {}", String::from_utf8_lossy(&heard)),
            Ok(count) => heard.extend_from_slice(&piece[..count]),
            Err(_) => {}
        }
    }
    String::from_utf8(heard).unwrap()
}

fn connect(place: &str) -> TcpStream {
    let stream = TcpStream::connect(place).unwrap();
    stream.set_read_timeout(Some(Duration::from_millis(200))).unwrap();
    stream
}

#[test]
fn a_sender_drives_the_machine() {
    let served = Served::new("--grbl", "tcp:0");
    assert!(served.place.starts_with("127.0.0.1:"), "{}", served.place);
    let mut stream = connect(&served.place);
    until(&mut stream, "to unlock]\r\n");
    // A second one is sent away.
    let mut other = connect(&served.place);
    assert_eq!(until(&mut other, "]\r\n"), "[MSG:Another sender has the machine]\r\n");
    stream.write_all(b"$X\nG1X5F6000\nG4P0.01\n").unwrap();
    until(&mut stream, "ok\r\nok\r\nok\r\n");
    stream.write_all(b"?").unwrap();
    let report = until(&mut stream, ">\r\n");
    assert!(report.starts_with("<Idle|MPos:5.000,0.000,0.000"), "{report}");
    // The one that comes next finds it as it is: unlocked.
    drop(stream);
    let began = Instant::now();
    loop {
        let mut next = connect(&served.place);
        if until(&mut next, "]\r\n").contains("Another") {
            std::thread::sleep(Duration::from_millis(20));
        } else {
            break;
        }
        assert!(began.elapsed() < Duration::from_secs(20));
    }
}

#[test]
fn wrong_use_is_said() {
    let busy = TcpListener::bind("127.0.0.1:0").unwrap();
    let port = busy.local_addr().unwrap().port();
    for (place, says) in [(format!("tcp:{port}"), "FC-1461"), ("udp:1".to_owned(), "tcp:PORT or pty")] {
        let mut command = Command::cargo_bin("ferrocut").unwrap();
        let done = command.args(["serve", "--headless", "--grbl", &place]).output().unwrap();
        assert_eq!(done.status.code(), Some(2), "{place}");
        assert!(String::from_utf8_lossy(&done.stderr).contains(says), "{done:?}");
    }
}

/// A key to a coil, as an editor of PLCopen writes it.
const DIAGRAM: &str = r#"<project><types><pous><pou name="MAIN" pouType="program"><body><LD>
<leftPowerRail localId="1"/>
<contact localId="2"><connectionPointIn><connection refLocalId="1"/></connectionPointIn><variable>X20.0</variable></contact>
<coil localId="3"><connectionPointIn><connection refLocalId="2"/></connectionPointIn><variable>Y100.0</variable></coil>
</LD></body></pou></pous></types></project>
"#;

#[test]
fn the_ladder_may_be_a_diagram() {
    let folder = tempfile::tempdir().unwrap();
    let diagram = common::write(&folder, "mill.xml", DIAGRAM);
    let served = Served::with(&["--tcp", "127.0.0.1:0", "--ladder", &diagram]);
    let mut front = Front::new(&served);
    let list = front.ask(json!({ "do": "ladder" }));
    let text = list["text"].as_str().unwrap_or_else(|| panic!("{list}"));
    assert!(text.contains("RD X0020.0\nWRT Y0100.0\n"), "{text}");
}

/// Every fault of a ladder file is told, in words of the file, whichever form it has.
#[test]
fn faults_of_a_ladder_are_told_with_its_file() {
    let folder = tempfile::tempdir().unwrap();
    let list = "END1\nRD X0.0\nTMR 999\nWRT R0.0\nRD X0.0\nWRT F0.0\nEND2\n";
    let (head, coil) = DIAGRAM.split_once("<coil").unwrap();
    let (coil, end) = coil.split_once('\n').unwrap();
    let coils = ["LAMP", "PUMP"].map(|name| format!("<coil{}\n", coil.replace("Y100.0", name)));
    let diagram = format!("{head}{}{end}", coils.concat());
    for (name, text, faults) in [
        ("mill.lad", list, ["1023:3", "1006:6"]),
        ("mill.xml", diagram.as_str(), ["1012:4", "1012:5"]),
        // One that is not there is told by its name, too.
        ("none.lad", "", ["1029:0"; 2]),
    ] {
        let file = folder.path().join(name).to_str().unwrap().to_owned();
        if !text.is_empty() {
            common::write(&folder, name, text);
        }
        let serve = ["serve", "--headless", "--tcp", "127.0.0.1:0", "--ladder", &file];
        let answer = common::ferrocut(&serve);
        let is_there = !text.is_empty();
        assert_eq!((answer.code, answer.out.as_str()), (if is_there { 1 } else { 2 }, ""), "{}", answer.err);
        for fault in faults {
            let (number, line) = fault.split_once(':').unwrap();
            let place = if is_there { format!("{file}:{line}:") } else { file.clone() };
            let told = answer.err.contains(&format!("gsk990mc:{number}")) && answer.err.contains(&place);
            assert!(told, "{fault}: {}", answer.err);
        }
    }
}

/// What has no effect on a machine that is served is not taken.
#[test]
fn switches_of_other_commands_are_refused() {
    for (arguments, says) in [
        (&["--tcp", "127.0.0.1:0", "--dialect", "weihong"][..], "'--dialect'"),
        (&["--tcp", "127.0.0.1:0", "--tool-table", "mill.tbl"], "'--tool-table'"),
        (&["--tcp", "127.0.0.1:0", "--var-file", "mill.var"], "'--var-file'"),
        (&["--tcp", "127.0.0.1:0", "--block-skip"], "'--block-skip'"),
        (&["--tcp", "127.0.0.1:0", "--memory", "-"], "a memory is a folder"),
        (&["--grbl", "tcp:0", "--public", "public.dat"], "'--public <FILE>'"),
        // What was kept would have another below it at every start.
        (&["--tcp", "127.0.0.1:0", "--setup", "a.toml", "--memory", "kept"], "'--setup <FILE>'"),
    ] {
        let mut command = Command::cargo_bin("ferrocut").unwrap();
        let done = command.args(["serve", "--headless"]).args(arguments).output().unwrap();
        assert_eq!(done.status.code(), Some(2), "{arguments:?}");
        assert!(String::from_utf8_lossy(&done.stderr).contains(says), "{done:?}");
    }
}

/// The programs that come with a machine stand for its codes, and a set-up file is what there is before anything is kept.
#[test]
fn a_weihong_control_has_the_codes_of_its_shop_and_a_set_up() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let demo = include_str!("../../../machines/demo-mill.toml");
    let demo = demo.replace("dialect = \"gsk990mc\"", "dialect = \"weihong\"");
    std::fs::write(path("mill.toml"), demo).unwrap();
    std::fs::write(path("public.dat"), "O240\nG91 G01 X7 F900\nG90\nM17\n").unwrap();
    std::fs::write(path("setup.toml"), "[tools.3]\nlength = 12.5\n").unwrap();
    // One of another language needs no such file.
    std::fs::create_dir(path("alone")).unwrap();
    std::fs::write(path("alone/mill.toml"), include_str!("../../../machines/demo-mill.toml")).unwrap();
    let alone = path("alone/mill.toml");
    assert!(Served::with(&["--tcp", "127.0.0.1:0", "--machine", alone.as_str()]).place.contains(':'));
    let (machine, setup) = (path("mill.toml"), path("setup.toml"));
    let served =
        Served::with(&["--tcp", "127.0.0.1:0", "--machine", machine.as_str(), "--setup", setup.as_str()]);
    let mut front = Front::new(&served);
    let offsets = front.ask(json!({ "do": "offsets", "from": 3, "to": 3 }));
    assert_eq!(offsets["offsets"]["3"]["length"], 12.5, "{offsets}");
    front.press("KEY_MDI");
    front.done(json!({ "do": "mdi", "text": "G54 M40" }));
    front.press("KEY_START");
    front.until("there", |status| x(status) == 7.0 && status["activity"] == "idle");
}

/// T2 M06 on a machine of which nothing was stored, with a memory that is new and with none: the magazine gives the tool.
#[test]
fn a_control_that_is_new_changes_the_tool() {
    let folder = tempfile::tempdir().unwrap();
    let memory = folder.path().join("kept");
    let change = |with: &[&str]| {
        let served = Served::with(&[&["--tcp", "127.0.0.1:0"], with].concat());
        let mut front = Front::new(&served);
        front.press("KEY_HOME");
        ["KEY_Z+", "KEY_X+", "KEY_Y+"].iter().for_each(|key| front.hold(key));
        front.until("homed", |status| {
            status["referenced"].as_array().unwrap().len() >= 3 && status["activity"] == "idle"
        });
        front.press("KEY_MDI");
        front.done(json!({ "do": "mdi", "text": "T2 M06" }));
        front.press("KEY_START");
        front.until("changed", |status| status["spindle"]["tool"] == 2 && status["activity"] == "idle");
        // The ladder knows it by the clamp and the magazine.
        let at =
            front.ask(json!({ "do": "signals", "names": ["TOOL", "POCKET", "TOOL_CLAMPED", "MAG_AWAY"] }));
        (at["signals"].clone(), front.ask(json!({ "do": "programs" }))["programs"].clone())
    };
    for with in [&[][..], &["--memory", memory.to_str().unwrap()]] {
        let (at, programs) = change(with);
        let there = json!({ "TOOL": 2, "POCKET": 2, "TOOL_CLAMPED": 1, "MAG_AWAY": 1 });
        assert_eq!((at, programs), (there, json!([])), "{with:?}");
    }
}

/// Who has no memory is told so and how to keep what he makes, in any language; who has one is not.
#[test]
fn a_control_that_keeps_nothing_says_so() {
    let folder = tempfile::tempdir().unwrap();
    let memory = ["--memory", folder.path().to_str().unwrap()];
    for (language, with, says) in [
        ("en", &[][..], "Nothing is kept"),
        ("zh", &[], "不保存任何数据"),
        ("ru", &[], "Ничего не сохраняется"),
        ("es", &[], "No se guarda nada"),
        ("tr", &[], "Hiçbir şey saklanmıyor"),
        ("en", &memory, ""),
    ] {
        let mut command = Command::cargo_bin("ferrocut").unwrap();
        command.args(["serve", "--headless", "--tcp", "127.0.0.1:0", "--language", language]).args(with);
        let mut process = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        let mut line = String::new();
        BufReader::new(process.stdout.take().unwrap()).read_line(&mut line).unwrap();
        process.kill().unwrap();
        let told = process.wait_with_output().unwrap().stderr;
        let told = String::from_utf8(told).unwrap();
        match says {
            "" => assert_eq!(told, "", "{language}"),
            says => {
                for part in ["FC-1505", says, "--memory /var/lib/ferrocut"] {
                    assert!(told.contains(part), "{language} {part}: {told}");
                }
            }
        }
    }
}

/// Ended by a signal it leaves all that was entered, and a good state of it for who loses the file.
#[test]
fn a_control_that_is_ended_leaves_a_good_state() {
    let folder = tempfile::tempdir().unwrap();
    let memory = folder.path().join("memory");
    let memory = memory.to_str().unwrap();
    let served = Served::with(&["--tcp", "127.0.0.1:0", "--memory", memory]);
    let mut front = Front::new(&served);
    front.done(json!({ "do": "store", "program": "O0001", "text": "M30\n" }));
    assert!(served.interrupt());
    for file in std::fs::read_dir(memory).unwrap().flatten() {
        if file.file_name().to_string_lossy().starts_with("memory.db") {
            std::fs::remove_file(file.path()).unwrap();
        }
    }
    let ferrocut = |args: &[&str]| {
        let done = Command::cargo_bin("ferrocut").unwrap().args(args).output().unwrap();
        assert!(done.status.success(), "{done:?}");
        String::from_utf8(done.stdout).unwrap()
    };
    ferrocut(&["memory", "recover", memory]);
    assert!(ferrocut(&["memory", "show", memory, "--item", "programs"]).contains("O0001"));
}

/// Without `--memory` rights are judged as with one (GSK990MC part 2, 3.4.5), and the histories last as long as the process.
#[test]
fn a_control_that_keeps_nothing_has_rights_and_histories() {
    let served = Served::new("--tcp", "127.0.0.1:0");
    let mut front = Front::new(&served);
    front.press("KEY_MDI");
    front.done(json!({ "do": "parameter_switch", "on": true }));
    front.done(json!({ "do": "accept_parameter_switch" }));
    let set = json!({ "do": "set_parameter", "name": "P86", "value": 1234.0 });
    assert_eq!(front.refused(set.clone()), "FC-1213");
    // Nobody has a password; the first is the maker's, who gives it at the machine.
    let log_in = |level: u8| json!({ "do": "log_in", "level": level, "password": "a word of mine" });
    let password = |level: u8| json!({ "do": "set_password", "level": level, "password": "a word of mine" });
    assert_eq!(front.refused(log_in(3)), "FC-1217");
    assert_eq!(front.refused(password(3)), "FC-1213");
    front.done(password(1));
    assert_eq!(front.ask(log_in(1))["level"], 1);
    front.done(set);
    front.done(json!({ "do": "emergency_stop", "pressed": true }));
    front.until("stopped", |status| status["activity"] == "emergency");
    front.done(json!({ "do": "emergency_stop", "pressed": false }));
    let history = front.ask(json!({ "do": "alarm_history", "most": 10 }));
    assert!(
        history["alarms"].as_array().unwrap().iter().any(|alarm| alarm["id"] == "gsk990mc:0251"),
        "{history}"
    );
    let log = front.ask(json!({ "do": "operation_log", "most": 10 }));
    let changed = |line: &Value| line["name"] == "P86" && line["to"] == "1234" && line["level"] == 1;
    assert!(log["entries"].as_array().unwrap().iter().any(changed), "{log}");
}

fn x(status: &Value) -> f64 {
    status["position"]["machine"]["X"].as_f64().unwrap()
}

#[test]
fn a_front_logs_in_runs_holds_captures_and_takes_a_program_up_again() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path().to_str().unwrap();
    let password = ["memory", "password", folder, "--level", "4", "--dialect", "gsk990mc"];
    assert_eq!(common::with_input(&password, "the shop's own word\n").code, 0);
    let serve = ["--tcp", "127.0.0.1:0", "--memory", folder];
    let served = Served::with(&serve);
    let mut front = Front::new(&served);

    // What is written needs no rights, what is locked the shop's.
    let text = "O1\nM3 S500\nG90 G94 G1 X20 F900\n#500=#500+1\nG91 X15 Y4 F600\nG90 X45 F900\nM5\nM30\n";
    front.done(json!({ "do": "store", "program": "O0001", "text": text }));
    let lock = |locked: bool| json!({ "do": "lock", "program": "O0001", "locked": locked });
    assert_eq!(front.refused(lock(true)), "FC-1213");
    let log_in = |password: &str| json!({ "do": "log_in", "level": 4, "password": password });
    assert!(front.refused(log_in("another word")).is_string());
    assert_eq!(front.ask(log_in("the shop's own word"))["level"], 4);
    assert_eq!(front.ask(json!({ "do": "status" }))["level"], 4);
    [true, false].iter().for_each(|locked| front.done(lock(*locked)));
    assert_eq!(front.ask(json!({ "do": "log_out" }))["level"], 5);
    assert_eq!(front.refused(lock(true)), "FC-1213");

    // Every axis to its reference point.
    front.press("KEY_R_100");
    front.press("KEY_HOME");
    ["KEY_Z+", "KEY_X+", "KEY_Y+"].iter().for_each(|key| front.hold(key));
    let homed = |status: &Value| status["referenced"].as_array().is_some_and(|axes| axes.len() >= 3);
    front.until("homed", |status| homed(status) && status["activity"] == "idle");

    // It is run, recorded, held and goes on.
    front.press("KEY_MDI");
    front.done(json!({ "do": "mdi", "text": "G90 G53 G0 X0 Y0" }));
    front.press("KEY_START");
    front.until("at zero", |status| x(status) == 0.0 && status["activity"] == "idle");
    front.press("KEY_AUTO");
    front.until("AUTO", |status| status["mode"] == "auto" && status["activity"] == "idle");
    front.done(json!({ "do": "select", "program": "O1" }));
    front.press("KEY_START");
    front.until("on its way", |status| status["activity"] == "running" && x(status) > 1.0);
    front.done(json!({ "do": "capture", "quantities": ["commanded.X", "velocity"], "seconds": 0.2 }));
    front.until("farther", |status| x(status) > 6.0);
    front.press("KEY_HOLD");
    let held = front.until("held", |status| status["activity"] == "held" && status["feed"]["actual"] == 0.0);
    assert!((6.0..20.0).contains(&x(&held)), "{held}");
    let captured = front.ask(json!({ "do": "captured" }));
    let text = captured["csv"].as_str().unwrap_or_else(|| panic!("{captured}"));
    let rows: Vec<Vec<f64>> =
        text.lines().skip(1).map(|line| line.split(',').map(|v| v.parse().unwrap()).collect()).collect();
    // A sample a period, in which the axis goes as far as its speed says: 15 mm/s once it has run up.
    assert!((199..=201).contains(&rows.len()), "{}", rows.len());
    for pair in rows.windows(2) {
        let way = (pair[1][1] - pair[0][1], pair[1][2] / 1000.0);
        assert!((way.0 - way.1).abs() < 1e-4 && (14.0..=15.001).contains(&pair[1][2]), "{pair:?}");
    }
    front.press("KEY_START");
    front.until("in the next move", |status| status["program"]["line"] == 5 && x(status) > 25.0);

    // Broken off in its second move, and taken up again there.
    front.done(json!({ "do": "reset" }));
    let stopped = front.until("reset", |status| status["activity"] == "idle");
    let block = &stopped["interrupted"];
    assert_eq!((&block["program"], &block["line"]), (&json!("O0001"), &json!(5)), "{stopped}");
    assert_eq!((&stopped["counters"]["parts"], &stopped["spindle"]["told"]), (&json!(0), &json!(0.0)));
    assert_eq!(front.ask(json!({ "do": "restart", "sends": true }))["reply"], "on_its_way");
    front.until("found", |status| status["restart_ready"] == true);
    front.press("KEY_START");
    let ended = front.until("done", |status| status["counters"]["parts"] == 1);
    assert!((x(&ended) - 45.0).abs() < 1e-9 && ended["position"]["machine"]["Y"] == 4.0, "{ended}");
    for event in ["level", "selected", "activity", "interrupted", "restart", "part"] {
        assert!(front.heard(event), "{event}: {:?}", front.events);
    }
    // The line was read twice and counts once, behind a kill too.
    let counted = |front: &mut Front| front.ask(json!({ "do": "variables", "from": 500, "to": 500 }));
    assert_eq!(counted(&mut front)["variables"], json!({ "500": 1.0 }));
    // What a program changed follows within a moment, counters within a second.
    std::thread::sleep(Duration::from_millis(1500));
    drop(served);
    let again = Served::with(&serve);
    let mut front = Front::new(&again);
    assert_eq!(counted(&mut front)["variables"], json!({ "500": 1.0 }));
    let status = front.until("well", |status| status["activity"] == "idle");
    assert_eq!((&status["counters"]["parts"], x(&status)), (&json!(1), 45.0));
    assert_eq!(status["interrupted"], Value::Null);
}

/// The demo mill, whose file describes no simulated machine, is one that can be used.
#[test]
fn a_front_finds_a_machine_that_is_well() {
    let served = Served::new("--tcp", "127.0.0.1:0");
    let mut stream = connect(&served.place);
    stream.set_read_timeout(None).unwrap();
    let mut lines = BufReader::new(stream.try_clone().unwrap()).lines();
    let mut hear = || common::json(&lines.next().unwrap().unwrap());
    assert_eq!(hear()["hello"], "ferrocut");
    let mut ask = |id: u32, command: &str| {
        stream.write_all(format!("{{\"id\":{id},{command}}}\n").as_bytes()).unwrap();
        loop {
            let line = hear();
            if line["id"] == id {
                return line;
            }
        }
    };
    assert_eq!(ask(1, "\"do\":\"take_command\"")["reply"], "done");
    assert_eq!(ask(2, "\"do\":\"key\",\"key\":\"KEY_AUTO\",\"down\":true")["reply"], "done");
    let began = Instant::now();
    loop {
        let status = ask(3, "\"do\":\"status\"");
        if (&status["mode"], &status["activity"]) == (&"auto".into(), &"idle".into()) {
            assert_eq!(status["alarms"], json!([]));
            break;
        }
        assert!(began.elapsed() < Duration::from_secs(30), "{status}");
    }
}
