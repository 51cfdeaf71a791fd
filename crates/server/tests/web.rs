//! What the panel asks the server for: files, tables, checks, paths, programs, and the socket.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

mod common;

use common::{Place, Socket, set_up};
use serde_json::{Value, json};
use std::time::{Duration, Instant};

fn encoded(text: &str) -> String {
    text.bytes()
        .map(|b| if b.is_ascii_alphanumeric() { char::from(b).to_string() } else { format!("%{b:02X}") })
        .collect()
}

#[test]
fn the_panel_is_served_with_its_policy_and_only_once() {
    let place = Place::local();
    let page = place.get("/");
    assert_eq!((page.status, page.head("content-type")), (200, Some("text/html; charset=utf-8")));
    let policy = page.head("content-security-policy").unwrap();
    assert!(policy.contains("default-src 'none'") && policy.contains("frame-ancestors 'none'"), "{policy}");
    assert!(!policy.split("script-src").nth(1).unwrap().contains("unsafe"), "{policy}");
    assert_eq!(page.head("x-content-type-options"), Some("nosniff"));
    let etag = page.head("etag").unwrap().to_owned();
    let again = place.http("GET", "/", &[("if-none-match", &etag)], b"");
    assert_eq!((again.status, again.body.len()), (304, 0));
    assert_eq!(place.http("POST", "/", &[], b"x").status, 405);
    assert_eq!(place.get("/nothing.js").status, 404);
}

#[test]
fn a_session_is_given_to_a_browser_and_known_again() {
    let place = Place::local();
    let first = place.get("/api/session");
    assert_eq!(first.json(), json!({ "level": 0, "needs_log_in": false }));
    let cookie = first.cookie();
    let again = place.http("GET", "/api/session", &[("cookie", &cookie)], b"");
    assert!(again.head("set-cookie").is_none());
    // There is no memory that could have passwords.
    let body = br#"{"level":2,"password":"whatever1"}"#;
    let refused = place.http("POST", "/api/session", &[], body);
    assert_eq!((refused.status, &refused.json()["refused"]["alarm"]["id"]), (409, &json!("FC-1406")));
}

#[test]
fn a_socket_speaks_the_lines_of_the_control() {
    let place = Place::local();
    let (mut first, mut second) = (place.socket(), place.socket());
    assert_eq!(first.hello["hello"], json!("ferrocut"));
    assert_eq!(first.hello["panel"]["ladder"], json!(true));
    assert_eq!(first.hello["session"], json!({ "level": 0, "needs_log_in": false }));
    assert_eq!(first.hello["dead_man_ms"], json!(250));
    let other = second.hello["connection"].clone();
    assert_eq!(first.ask(json!({ "do": "version" }))["dialect"], json!("gsk990mc"));
    assert_eq!(first.ask(json!({ "do": "reset" }))["error"], json!("not_in_command"));
    first.tell(json!({ "do": "watch", "events": true }));
    // Among what else happens as the control begins.
    let of_command = |socket: &mut Socket<_>| loop {
        let heard = socket.hear();
        if heard["event"] == json!("command") {
            return heard;
        }
    };
    let held = |holder: Value| json!({ "event": "command", "holder": holder, "you": false, "asking": [] });
    assert_eq!(of_command(&mut first), held(Value::Null));
    second.take_command();
    assert_eq!(of_command(&mut first), held(other));
    assert_eq!(first.ask(json!({ "do": "take_command" }))["error"], json!("taken"));
    // Whoever sees danger stops the machine.
    first.tell(json!({ "do": "emergency_stop", "pressed": true }));
    second.tell(json!({ "do": "emergency_stop", "pressed": false }));
    // And holds it; no other key is his.
    let key = |name: &str, down: bool| json!({ "do": "key", "key": name, "down": down });
    assert_eq!(first.ask(key("KEY_START", true))["error"], json!("not_in_command"));
    for down in [true, false] {
        assert_eq!(first.ask(key("KEY_HOLD", down))["reply"], json!("done"));
    }
    drop(second);
    let began = Instant::now();
    while first.hear() != json!({ "event": "command", "holder": null, "you": false, "asking": [] }) {
        assert!(began.elapsed() < Duration::from_secs(10));
    }
}

#[test]
fn a_machine_that_was_just_started_can_be_used() {
    let place = Place::local();
    let mut socket = place.socket();
    // As soon as the ladder has looked at the panel.
    let status = socket.until("at 100 %", |status| {
        status["feed"]["feed_override"] == json!(1.0) && status["spindle"]["spindle_override"] == json!(1.0)
    });
    assert_eq!(
        (&status["feed"]["manual_override"], &status["feed"]["rapid_override"]),
        (&json!(1.0), &json!(0.25))
    );
    assert_eq!(status["panel"], json!({ "SWITCH_FEED": 10, "SWITCH_SPINDLE": 5 }));
    assert!(status["lamps"].as_array().unwrap().contains(&json!("LAMP_R_25")), "{status}");
}

#[test]
fn the_ladder_is_told_as_it_was_written() {
    let place = Place::local();
    let text = place.socket().ask(json!({ "do": "ladder" }))["text"].as_str().unwrap().to_owned();
    assert_eq!(text, include_str!("../../../machines/standard.lad"));
}

#[test]
fn statuses_come_fifty_times_a_second() {
    let place = Place::local();
    let mut socket = place.socket();
    socket.tell(json!({ "do": "watch", "status": true }));
    socket.hear();
    let began = Instant::now();
    let mut last = 0;
    for _ in 0..50 {
        let status = socket.hear();
        let periods = status["status"]["periods"].as_u64().unwrap();
        assert!(periods >= last && status.as_object().unwrap().len() == 1);
        last = periods;
    }
    // A computer that is busy may be late, never early.
    assert!(began.elapsed() >= Duration::from_millis(900), "{:?}", began.elapsed());
}

#[test]
fn programs_are_checked_as_they_are_typed() {
    let place = Place::local();
    let check = |query: &str, text: &str| -> Vec<Value> {
        let answer = place.http("POST", &format!("/api/check{query}"), &[], text.as_bytes());
        assert_eq!(answer.status, 200, "{}", answer.text());
        answer.json()["findings"].as_array().unwrap().clone()
    };
    assert_eq!(check("", ""), Vec::<Value>::new());
    assert_eq!(check("", "G90 G0 X10\nM3 S600\nG1 X20 F500\nM30\n"), Vec::<Value>::new());
    // Two units of UTF-16 for the sign of the piano; both faults are found.
    let found = check("", "(𝄞 part) G999\nG0 X9999\nM30\n");
    assert_eq!(found.len(), 2, "{found:?}");
    let place_of = |finding: &Value| {
        ["line", "column", "end_line", "end_column"].map(|name| finding[name].as_u64().unwrap())
    };
    assert_eq!((place_of(&found[0]), &found[0]["severity"]), ([1, 11, 1, 15], &json!("error")));
    assert_eq!(place_of(&found[1]), [2, 4, 2, 9]);
    assert!(found.iter().all(|finding| finding["help"].is_string() && finding["text"].is_string()));
    let chinese = check("?language=zh", "G999\nM30\n");
    assert!(!chinese[0]["text"].as_str().unwrap().is_ascii());
    // Another control's words are those of that control.
    assert!(check("?dialect=rs274", "O100 sub\nO100 endsub\nM2\n").is_empty());
    assert!(!check("", "O100 sub\nO100 endsub\nM2\n").is_empty());
    for query in ["?dialect=nothing", "?language=xx"] {
        assert_eq!(place.http("POST", &format!("/api/check{query}"), &[], b"G0").status, 400, "{query}");
    }
}

#[test]
fn a_fault_in_a_loop_hides_no_other() {
    let place = Place::local();
    let text = b"G91 M3 S500\n#1=0\nWHILE[#1 LT 3000]DO1\nG1 X9000 F500\nX-9000\n#1=#1+1\nEND1\nG777\nM30\n";
    let findings = place.http("POST", "/api/check", &[], text).json();
    let lines = findings["findings"].as_array().unwrap().iter().map(|finding| finding["line"].as_u64());
    assert_eq!(lines.collect::<Vec<_>>(), [Some(4), Some(8)], "{findings}");
}

#[test]
fn a_program_without_end_is_checked_within_bounds() {
    let place = Place::local();
    let began = Instant::now();
    let text = b"#1=0\nWHILE[1 EQ 1]DO1\nG1 X[#1] F500\n#1=#1+0.001\nIF[#1 GT 10]THEN #1=0\nEND1\nM30\n";
    let answer = place.http("POST", "/api/check", &[], text);
    let findings = answer.json();
    assert!(began.elapsed() < Duration::from_secs(45), "{:?}", began.elapsed());
    let last = findings["findings"].as_array().unwrap().last().cloned();
    assert!(last.is_some(), "neither an alarm nor the bound: {findings}");
    let path = place.http("POST", "/api/path", &[], text);
    assert_eq!(path.status, 200);
    assert!(u32_at(&path.body, 4) <= 2 << 20);
}

fn u32_at(bytes: &[u8], at: usize) -> u32 {
    u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap())
}

fn f32_at(bytes: &[u8], at: usize) -> f32 {
    f32::from_bits(u32_at(bytes, at))
}

#[test]
fn the_way_of_the_tool_is_drawn() {
    let place = Place::local();
    // 60 mm at 600 mm/min are 6 s; a half circle of radius 10 at 600 is 3.14 s.
    let text = b"G90 G54 G17 G0 X0 Y0 Z0\nG1 X60 F600\nG3 X40 Y0 R10\nM30\n";
    let answer = place.http("POST", "/api/path", &[], text);
    assert_eq!(answer.head("content-type"), Some("application/octet-stream"));
    let bytes = &answer.body;
    assert_eq!(&bytes[..4], b"FCP1");
    let n = u32_at(bytes, 4) as usize;
    assert_eq!((u32_at(bytes, 8), u32_at(bytes, 12), bytes.len()), (0, 0, 64 + 21 * n));
    let corner = |at: usize| f64::from_le_bytes(bytes[16 + 8 * at..24 + 8 * at].try_into().unwrap());
    assert!((corner(3) - corner(0) - 60.0).abs() < 1e-9, "{} {}", corner(0), corner(3));
    assert!((corner(4) - corner(1) - 10.0).abs() < 0.011, "{} {}", corner(1), corner(4));
    let (times, lines, kinds) = (64 + 12 * n, 64 + 16 * n, 64 + 20 * n);
    assert_eq!(bytes[kinds], 0);
    assert_eq!((u32_at(bytes, lines + 4 * (n - 1)), bytes[kinds + n - 1]), (3, 3));
    let took = f32_at(bytes, times + 4 * (n - 1)) - f32_at(bytes, times);
    assert!((took - (6.0 + std::f32::consts::PI)).abs() < 0.01, "{took}");
    // Chords of a radius of 10 mm within 0.01 mm.
    let chords = bytes[kinds..].iter().filter(|kind| **kind == 3).count();
    assert!((35..=40).contains(&chords), "{chords}");
    // An alarm ends it.
    let cut = place.http("POST", "/api/path", &[], b"G1 X10 F600\nG999\nX20\nM30\n");
    assert_eq!((u32_at(&cut.body, 8), u32_at(&cut.body, 4)), (1, 2));
}

#[test]
fn tables_say_what_explain_says() {
    let place = Place::local();
    let page = place.get("/api/explain?word=G84&language=en").json();
    assert_eq!((&page["found"], &page["kind"]), (&json!(true), &json!("g-code")));
    assert!(page["title"].as_str().unwrap().starts_with("G84") && page["source"].is_string());
    // In parts, for whoever draws it otherwise than in lines.
    let of = |parts: &str, label: &str| {
        let parts = page[parts].as_array().unwrap().iter();
        parts.filter(|part| part["label"].as_str().unwrap() == label).cloned().collect::<Vec<_>>()
    };
    assert!(of("facts", "form")[0]["text"].as_str().unwrap().starts_with("G84 X"), "{page}");
    let parameters = of("tables", "parameters")[0]["rows"].clone();
    let rigid = parameters.as_array().unwrap().iter().find(|row| row[0] == json!("NO46.1")).unwrap();
    assert!(rigid[1].is_string() && rigid[2].as_str().unwrap().starts_with("1: "), "{rigid}");
    // What a number is for says its meaning, in the reader's language.
    let found = place.get("/api/search?q=P220&language=ru").json();
    let row = found.as_array().unwrap().iter().find(|row| row["key"] == json!("P220")).unwrap();
    assert!(row["title"] == json!("") && !row["text"].as_str().unwrap().is_ascii(), "{row}");
    let nothing = place.get("/api/explain?word=G777").json();
    assert_eq!(nothing["found"], json!(false));
    assert!(nothing["text"].as_str().unwrap().contains("G777"));
    // A place of a file is no word here.
    for word in ["/etc/passwd:1", "/etc/passwd:1:1", "-:1:1"] {
        let answer = place.get(&format!("/api/explain?word={}", encoded(word)));
        assert!(answer.status == 404 || answer.json()["found"] == json!(false), "{}", answer.text());
        assert!(!answer.text().contains("root:"), "{}", answer.text());
    }
    let words = place.get("/api/words").json();
    assert!(
        words
            .as_array()
            .unwrap()
            .iter()
            .any(|word| word["word"] == json!("G84") && word["title"] != json!(""))
    );
    let parameters = place.get("/api/parameters").json();
    let bits = parameters.as_array().unwrap().iter().find(|row| row["number"] == json!(47)).unwrap();
    assert_eq!((bits["kind"].as_str(), bits["bits"].as_array().unwrap().len()), (Some("bit"), 5));
    // Whether something is done with it is said of each bit, and of all together.
    let used_of = |name: &str| {
        let row = parameters.as_array().unwrap().iter().find(|row| row["name"] == json!(name)).unwrap();
        let bits = row["bits"].as_array().unwrap().iter();
        (row["used"].as_bool().unwrap(), bits.map(|bit| bit["used"].as_bool().unwrap()).collect::<Vec<_>>())
    };
    let (used, bits) = used_of("NO0");
    assert!(used && bits.contains(&true) && !bits.iter().all(|bit| *bit), "{bits:?}");
    assert!(!used_of("NO19").0 && used_of("P88").0 && !used_of("P201").0);
    let data = parameters.as_array().unwrap().iter().find(|row| row["name"] == json!("P270")).unwrap();
    assert!(data["kind"] == json!("data") && data["level"].as_u64().is_some(), "{data}");
    let signals = place.get("/api/signals?language=zh").json();
    let start = signals.as_array().unwrap().iter().find(|row| row["name"] == json!("KEY_START")).unwrap();
    assert!(
        start["address"].as_str().unwrap().starts_with('X') && !start["meaning"].as_str().unwrap().is_ascii()
    );
    let found = place.get("/api/search?q=g84").json();
    assert_eq!((&found[0]["kind"], &found[0]["key"]), (&json!("code"), &json!("G84")));
    // A bit as the manual prints it; an alarm by its number alone.
    for (sought, kind, key) in [
        ("43#1", "parameter", "NO43.1"),
        ("no10#5", "parameter", "NO10.5"),
        ("NO40.7", "parameter", "NO40.7"),
        ("alarm 45", "alarm", "gsk990mc:0045"),
        ("报警 45", "alarm", "gsk990mc:0045"),
        ("alarm 1206", "alarm", "FC-1206"),
        ("#5021", "variable", "#5021"),
    ] {
        let found = place.get(&format!("/api/search?q={}", encoded(sought))).json();
        let first = (found[0]["kind"].as_str(), found[0]["key"].as_str());
        assert!(first.0 == Some(kind) && (kind == "variable" || first.1 == Some(key)), "{sought}: {first:?}");
    }
    let kinds = place.get("/api/search?q=spindle").json();
    let kinds: std::collections::BTreeSet<_> =
        kinds.as_array().unwrap().iter().map(|row| row["kind"].as_str().unwrap().to_owned()).collect();
    assert!(kinds.len() >= 3, "{kinds:?}");
    // All of a kind.
    for (kind, least, one) in [
        ("alarm", 300, "FC-0302"),
        ("parameter", 500, "P88"),
        ("variable", 20, "#3000"),
        ("address", 15, "F"),
        ("signal", 200, "KEY_START"),
        ("code", 100, "G84"),
    ] {
        let list = place.get(&format!("/api/list?kind={kind}")).json();
        let rows = list.as_array().unwrap();
        assert!(rows.len() >= least && rows.iter().all(|row| row["kind"] == kind), "{kind}: {}", rows.len());
        assert!(rows.iter().any(|row| row["key"] == one), "{kind} {one}");
    }
    assert_eq!(place.get("/api/list?kind=nothing").json(), json!([]));
    assert_eq!(place.get("/api/list").status, 400);
}

#[test]
fn alarms_are_told_with_their_values() {
    let place = Place::local();
    let values = encoded(r#"{"axis":"X","position":"512.3","limit":"500"}"#);
    let told = place.get(&format!("/api/alarm?id=FC-0901&values={values}"));
    let known = place.get("/api/alarm?id=gsk990mc:0045").json();
    assert!(known["text"].as_str().unwrap().len() > 5 && known["help"].is_string(), "{known}");
    assert!(told.status == 200 || told.status == 404);
    let line =
        place.get(&format!("/api/alarm?id=FC-1411&values={}&language=en", encoded(r#"{"line":7}"#))).json();
    assert!(line["text"].as_str().unwrap().contains('7'), "{line}");
    assert_eq!(place.get("/api/alarm?id=FC-9999").status, 404);
    assert_eq!(place.get("/api/alarm?id=FC-1411&values=x").status, 400);
}

#[test]
fn programs_go_in_and_out() {
    let place = Place::local();
    let cookie = place.get("/").cookie();
    let text = "O0007\nG1 X1 F100 (孔)\nM30\n";
    let put = |cookie: &str| place.http("PUT", "/api/programs/O0007", &[("cookie", cookie)], text.as_bytes());
    assert_eq!(put(&cookie).json()["error"], json!("not_in_command"));
    let mut socket = Socket::new(place.address(), &[("cookie", &cookie)]).unwrap();
    socket.take_command();
    assert_eq!(put(&cookie).json()["reply"], json!("done"));
    // Another browser is not in command.
    assert_eq!(put(&place.get("/").cookie()).json()["error"], json!("not_in_command"));
    let out = place.get("/api/programs/O7");
    assert_eq!((out.status, out.text().as_str()), (200, text));
    assert_eq!(socket.ask(json!({ "do": "read", "program": "O0007" }))["text"], json!(text));
    assert_eq!(u32_at(&place.get("/api/path?program=O0007").body, 4), 2);
    assert_eq!(place.get("/api/path?program=O0008").status, 404);
    assert_eq!(place.get("/api/programs/O0008").status, 404);
    // What can be stored can be fetched, whichever way it came.
    let longest = "x".repeat(128);
    for (name, sent) in [
        ("A.NC", "A.NC"),
        ("PART 1", "PART%201"),
        ("50%", "50%25"),
        ("零件", "%E9%9B%B6%E4%BB%B6"),
        (&longest, &longest),
    ] {
        let text = format!("({name})\nM30\n");
        let stored = socket.ask(json!({ "do": "store", "program": name, "text": text }));
        assert_eq!(stored["reply"], json!("done"), "{name} {stored}");
        let path = format!("/api/programs/{sent}");
        let out = place.get(&path);
        assert_eq!((out.status, out.text().as_str()), (200, text.as_str()), "{name}");
        assert_eq!(place.http("PUT", &path, &[("cookie", &cookie)], b"M30\n").status, 200, "{name}");
    }
    let too_long = "x".repeat(129);
    for name in [".", "..", "a/b", "a\\b", "a\"b", "a\nb", " ", &too_long] {
        let stored = socket.ask(json!({ "do": "store", "program": name, "text": "M30" }));
        assert_eq!(stored["refused"]["alarm"]["id"], json!("FC-1409"), "{name:?}");
        let renamed = socket.ask(json!({ "do": "rename", "program": "O0007", "to": name }));
        assert_eq!(renamed["refused"]["alarm"]["id"], json!("FC-1409"), "{name:?}");
    }
}

/// GSK990MC part 2, 11.3: the file is the server's, whoever is connected.
#[test]
fn a_file_for_dnc_runs_to_its_end_when_its_page_is_closed() {
    let place = Place::local();
    let cookie = place.get("/").cookie();
    // Longer than the control keeps, and written as shops do. It runs for a while.
    let count = 3000;
    let mut text = b"G90 G04 X1.\n#500 = 0\n".to_vec();
    for _ in 0..count {
        text.extend_from_slice(b"#500 = #500 + 1 (");
        (0..128).for_each(|_| text.extend_from_slice(b"\xcf\xb3 "));
        text.extend_from_slice(b")\n");
    }
    text.extend_from_slice(b"M30\n");
    let put = |name: &str, text: &[u8]| {
        place.http("PUT", &format!("/api/dnc/{name}"), &[("cookie", &cookie)], text)
    };
    let told = || place.get("/api/dnc").json();
    assert_eq!(told(), json!(null));
    assert_eq!(put("long.nc", &text).json()["error"], json!("not_in_command"));
    let mut socket = Socket::new(place.address(), &[("cookie", &cookie)]).unwrap();
    set_up(&mut socket);
    socket.press("KEY_DNC");
    let come = put("long.nc", &text);
    assert_eq!((come.status, &come.json()["sending"]), (200, &json!(true)), "{}", come.text());
    // Nothing that is no program, or too long, takes its place.
    assert_eq!(put("picture.nc", b"\x89PNG\x01\x02\x00\x09").json()["error"], json!("unreadable"));
    assert_eq!(put("nothing.nc", b"").json()["error"], json!("unreadable"));
    let most = [("cookie", cookie.as_str()), ("content-length", "1073741825")];
    assert_eq!(place.http("PUT", "/api/dnc/most.nc", &most, b"").status, 413);
    assert_eq!(place.http("DELETE", "/api/dnc", &[], b"").json()["error"], json!("not_in_command"));
    assert_eq!((&told()["name"], &told()["sending"]), (&json!("long.nc"), &json!(true)));
    socket.press("KEY_START");
    // Another does not break into it.
    let busy = put("other.nc", b"G91 G0 X1.\nM30\n");
    assert_eq!((busy.status, &busy.json()["refused"]["alarm"]["id"]), (409, &json!("FC-1401")));
    drop(socket);
    let began = Instant::now();
    while told()["sending"] == json!(true) {
        assert!(began.elapsed() < Duration::from_secs(60), "{}", told());
        std::thread::sleep(Duration::from_millis(50));
    }
    let whole = json!({ "name": "long.nc", "bytes": text.len(), "sent": text.len(), "sending": false, "refused": null });
    assert_eq!(told(), whole);
    let mut socket = Socket::new(place.address(), &[("cookie", &cookie)]).unwrap();
    socket.until("idle", |status| status["activity"] == json!("idle"));
    let read = socket.ask(json!({ "do": "variables", "from": 500, "to": 500 }));
    assert_eq!(read["variables"]["500"], json!(f64::from(count)), "{read}");

    // A reset gives up the rest, and nothing of it comes behind what is begun next.
    socket.take_command();
    assert_eq!(put("long.nc", &text).status, 200);
    socket.press("KEY_START");
    socket.tell(json!({ "do": "reset" }));
    let began = Instant::now();
    while told()["sending"] == json!(true) {
        assert!(began.elapsed() < Duration::from_secs(60), "{}", told());
        std::thread::sleep(Duration::from_millis(50));
    }
    assert_eq!(told()["refused"], json!(null));
    let short = put("short.nc", b"#500 = 7\nM30\n");
    assert_eq!((short.status, &short.json()["sending"]), (200, &json!(false)), "{}", short.text());
    socket.press("KEY_START");
    socket.until("run", |status| status["counters"]["all_parts"] == json!(2));
    let read = socket.ask(json!({ "do": "variables", "from": 500, "to": 500 }));
    assert_eq!(read["variables"]["500"], json!(7.0), "{read}");
    // Nobody wants the rest.
    assert_eq!(put("long.nc", &text).json()["sending"], json!(true));
    let stopped = place.http("DELETE", "/api/dnc", &[("cookie", &cookie)], b"");
    assert_eq!((stopped.status, &stopped.json()["sending"]), (200, &json!(false)));
    let sent = told()["sent"].clone();
    std::thread::sleep(Duration::from_millis(200));
    assert_eq!(told()["sent"], sent);
}

#[test]
fn everything_that_is_described_is_there() {
    let place = Place::local();
    let description = place.get("/api/openapi.json").json();
    let paths = description["paths"].as_object().unwrap();
    assert!(paths.len() >= 12);
    for (path, methods) in paths {
        let path = path.replace("{name}", "O1");
        for method in methods.as_object().unwrap().keys().filter(|name| *name != "parameters") {
            let answer = place.http(&method.to_uppercase(), &path, &[], b"");
            let is_missing =
                matches!(answer.status, 0 | 405) || answer.status == 404 && answer.body.is_empty();
            assert!(!is_missing, "{method} {path}: {}", answer.status);
        }
    }
}

#[test]
fn the_server_ends_when_it_is_told() {
    let place = Place::local();
    let mut socket = place.socket();
    set_up(&mut socket);
    let began = Instant::now();
    drop(place.web);
    assert!(began.elapsed() < Duration::from_secs(8), "{:?}", began.elapsed());
    while socket.try_hear().is_ok() {}
}
