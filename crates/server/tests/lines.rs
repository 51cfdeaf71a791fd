//! JSON lines over a socket: answers, watchers, keys that are let go, readers that are too slow, and whatever bytes.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

use ferrocut_server::hub::{Hub, LONGEST_LINE, MOST_LONG, start};
use ferrocut_server::lines::{listen_at, serve};
use ferrocut_server::service::{Aside, Caller, Need, Service};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use std::io::{BufRead, BufReader, ErrorKind, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::os::unix::fs::{FileTypeExt, MetadataExt};
use std::os::unix::net::{UnixListener, UnixStream};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

/// A machine of one axis and one key.
struct Toy {
    at: f64,
    is_pressed: bool,
    events: Vec<Value>,
    ticks: Arc<AtomicU64>,
}

#[derive(Deserialize)]
#[serde(tag = "do", rename_all = "snake_case")]
enum Command {
    Key {
        key: String,
        down: bool,
    },
    Stop,
    Position,
    Refuse,
    Chatter {
        count: usize,
    },
    /// Takes long.
    Ponder {
        ms: u64,
    },
}

#[derive(Serialize)]
struct Status {
    at: f64,
    is_pressed: bool,
}

impl Service for Toy {
    type Command = Command;
    type Reply = Value;
    type Refusal = &'static str;
    type Event = Value;
    type Status = Status;
    const VERSION: u32 = 7;

    fn tick(&mut self) {
        self.ticks.fetch_add(1, Ordering::Relaxed);
        self.at += f64::from(u8::from(self.is_pressed));
    }
    fn command(&mut self, command: Command, _: &Caller) -> Result<Value, &'static str> {
        match command {
            Command::Key { key, down } if key.starts_with("NO") => {
                self.events.push(json!({ "event": "no key", "down": down }));
                return Err("no key");
            }
            Command::Key { down, .. } => {
                self.is_pressed = down;
                self.events.push(json!({ "event": "key", "down": down }));
            }
            Command::Stop => self.is_pressed = false,
            Command::Position => {
                return Ok(json!({ "reply": "position", "at": self.at, "moves": self.is_pressed }));
            }
            Command::Refuse => return Err("no"),
            Command::Chatter { count } => {
                self.events.extend((0..count).map(|_| json!({ "text": "x".repeat(20_000) })))
            }
            Command::Ponder { .. } => return Err("not here"),
        }
        Ok(json!({ "reply": "done" }))
    }
    fn events(&mut self) -> Vec<Value> {
        // A few a period, as machines do.
        let count = self.events.len().min(8);
        self.events.drain(..count).collect()
    }
    fn status(&mut self) -> Status {
        Status { at: self.at, is_pressed: self.is_pressed }
    }
    fn need(command: &Command) -> Need {
        match command {
            Command::Position | Command::Stop | Command::Chatter { .. } => Need::Nothing,
            Command::Key { .. } | Command::Refuse | Command::Ponder { .. } => Need::Command,
        }
    }
    fn key(command: &Command) -> Option<(&str, bool)> {
        match command {
            Command::Key { key, down } => Some((key, *down)),
            _ => None,
        }
    }
    fn takes_long(command: &Command) -> bool {
        matches!(command, Command::Ponder { .. })
    }
    fn release(key: &str) -> Command {
        Command::Key { key: key.to_owned(), down: false }
    }
}

/// A machine with its thread.
fn machine() -> (ferrocut_server::runner::Runner<ferrocut_server::service::Served<Toy>>, Arc<Hub<Toy>>) {
    let toy = Toy { at: 0.0, is_pressed: false, events: Vec::new(), ticks: Arc::default() };
    let aside: Aside<Toy> = Box::new(|_, command, _| {
        let Command::Ponder { ms } = command else { return None };
        std::thread::sleep(Duration::from_millis(*ms));
        Some(Ok(json!({ "reply": "pondered" })))
    });
    start(toy, Duration::from_millis(1), None, Some(aside)).unwrap()
}

/// A machine that is served, at a port of its own.
struct Place {
    port: u16,
    _runner: ferrocut_server::runner::Runner<ferrocut_server::service::Served<Toy>>,
    _hub: Arc<Hub<Toy>>,
}

fn place() -> Place {
    let (runner, hub) = machine();
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let port = listener.local_addr().unwrap().port();
    serve(hub.clone(), listener).unwrap();
    Place { port, _runner: runner, _hub: hub }
}

struct Client {
    stream: BufReader<TcpStream>,
    number: u64,
}

impl Client {
    fn new(place: &Place) -> Client {
        let stream = TcpStream::connect(("127.0.0.1", place.port)).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(20))).unwrap();
        let mut client = Client { stream: BufReader::new(stream), number: 0 };
        let hello = client.hear();
        assert_eq!((hello["hello"].as_str(), hello["api"].as_u64()), (Some("ferrocut"), Some(7)));
        client.number = hello["connection"].as_u64().unwrap();
        client
    }

    fn hear(&mut self) -> Value {
        let mut line = String::new();
        assert!(self.stream.read_line(&mut line).unwrap() > 0, "ended");
        serde_json::from_str(&line).unwrap()
    }

    fn say(&mut self, line: &str) {
        self.stream.get_mut().write_all(format!("{line}\n").as_bytes()).unwrap();
    }

    fn ask(&mut self, line: &str) -> Value {
        self.say(line);
        self.hear()
    }

    fn moves(&mut self) -> bool {
        self.ask(r#"{"do":"position"}"#)["moves"].as_bool().unwrap()
    }
}

#[test]
fn commands_are_answered_by_their_ids() {
    let place = place();
    let mut client = Client::new(&place);
    let answer = client.ask(r#"{"id":3,"do":"position"}"#);
    assert_eq!((&answer["id"], &answer["reply"]), (&json!(3), &json!("position")));
    assert_eq!(client.ask(r#"{"id":"a","do":"refuse"}"#), json!({"id":"a","error":"not_in_command"}));
    assert_eq!(client.ask(r#"{"id":4,"do":"take_command"}"#), json!({"id":4,"reply":"done"}));
    assert_eq!(client.ask(r#"{"id":5,"do":"refuse"}"#), json!({"id":5,"refused":"no"}));
    for (line, code) in [
        ("", "no_object"),
        ("[1]", "no_object"),
        ("{", "no_object"),
        (r#"{"id":[],"do":"stop"}"#, "bad_id"),
        (r#"{"do":"dance"}"#, "no_command"),
        ("{}", "no_command"),
    ] {
        assert_eq!(client.ask(line)["error"], json!(code), "{line}");
    }
}

#[test]
fn one_is_in_command_and_others_watch_and_stop() {
    let place = place();
    let (mut first, mut second) = (Client::new(&place), Client::new(&place));
    first.ask(r#"{"do":"take_command"}"#);
    assert_eq!(second.ask(r#"{"do":"take_command"}"#)["error"], json!("taken"));
    second.ask(r#"{"do":"watch","events":true}"#);
    assert_eq!(second.hear(), json!({"event":"command","holder":1,"you":false,"asking":[]}));
    first.ask(r#"{"do":"key","key":"X+","down":true}"#);
    assert_eq!(second.hear(), json!({"event":"key","down":true}));
    assert_eq!(second.ask(r#"{"do":"stop"}"#)["reply"], json!("done"));
    assert!(!second.moves());
    first.ask(r#"{"do":"give_command"}"#);
    // The key that was held is let go.
    let mut heard = [second.hear(), second.hear()];
    heard.sort_by_key(|event| event["event"].to_string());
    assert_eq!(heard[0], json!({"event":"command","holder":null,"you":false,"asking":[]}));
    assert_eq!(heard[1], json!({"event":"key","down":false}));
    assert_eq!(
        second.ask(r#"{"do":"take_command"}"#),
        json!({"event":"command","holder":2,"you":true,"asking":[]})
    );
    assert_eq!(second.hear()["reply"], json!("done"));
    drop(second);
    // It goes back when its connection ends.
    let until = Instant::now() + Duration::from_secs(10);
    while first.ask(r#"{"do":"take_command"}"#)["reply"] != json!("done") {
        assert!(Instant::now() < until);
        std::thread::sleep(Duration::from_millis(10));
    }
}

/// What comes of a request goes to all who watch; who has command lets what he holds go before the other has it.
#[test]
fn command_is_asked_for_and_handed_over() {
    let place = place();
    let mut clients = [Client::new(&place), Client::new(&place), Client::new(&place)];
    let asks = |number: u64| json!({ "connection": number, "from": "", "level": 5 });
    let [first, second, third] = &mut clients;
    assert_eq!(second.ask(r#"{"do":"ask_for_command"}"#)["error"], json!("free"));
    first.ask(r#"{"do":"take_command"}"#);
    for client in [&mut *first, &mut *second] {
        client.ask(r#"{"do":"watch","events":true}"#);
        assert_eq!(client.hear()["asking"], json!([]));
    }
    assert_eq!(third.ask(r#"{"do":"ask_for_command"}"#)["reply"], json!("done"));
    assert_eq!(third.ask(r#"{"do":"ask_for_command"}"#)["reply"], json!("done"), "he asks already");
    for client in [&mut *first, &mut *second] {
        assert_eq!(client.hear()["asking"], json!([asks(3)]), "once");
    }
    // What he asked ends with him, and who asks has nothing of command.
    clients[2] = Client::new(&place);
    let [first, second, third] = &mut clients;
    for client in [&mut *first, &mut *second] {
        assert_eq!(client.hear(), json!({"event":"command","holder":1,"you":client.number == 1,"asking":[]}));
    }
    second.say(r#"{"do":"ask_for_command"}"#);
    assert_eq!(second.hear()["asking"], json!([asks(2)]));
    assert_eq!(second.hear()["reply"], json!("done"));
    assert_eq!(first.hear()["asking"], json!([asks(2)]));
    for line in [r#"{"do":"hand_over","to":2}"#, r#"{"do":"decline","to":2}"#, r#"{"do":"refuse"}"#] {
        for watcher in [&mut *second, &mut *third] {
            assert_eq!(watcher.ask(line)["error"], json!("not_in_command"), "{line}");
        }
    }
    assert_eq!(first.ask(r#"{"do":"hand_over","to":4}"#)["error"], json!("does_not_ask"));
    assert_eq!(first.ask(r#"{"do":"decline"}"#)["error"], json!("no_command"));
    first.say(r#"{"do":"decline","to":2}"#);
    assert_eq!(first.hear()["asking"], json!([]));
    assert_eq!(first.hear()["reply"], json!("done"));
    assert_eq!(second.hear(), json!({"event":"declined","by":1}));
    assert_eq!(second.hear()["asking"], json!([]));
    assert_eq!(second.ask(r#"{"do":"ask_for_command"}"#)["error"], json!("asked_lately"));
    third.ask(r#"{"do":"ask_for_command"}"#);
    assert_eq!(
        (first.hear()["asking"].clone(), second.hear()["asking"].clone()),
        (json!([asks(4)]), json!([asks(4)]))
    );
    first.say(r#"{"do":"key","key":"X+","down":true}"#);
    first.say(r#"{"do":"hand_over","to":4}"#);
    // Pressed, let go, and who commands: from two threads.
    let mut heard = [second.hear(), second.hear(), second.hear()];
    heard.sort_by_key(|event| (event["event"].to_string(), event["down"] == json!(false)));
    assert_eq!(heard[0], json!({"event":"command","holder":4,"you":false,"asking":[]}));
    assert_eq!(heard[2], json!({"event":"key","down":false}));
    assert!(!third.moves(), "the key was let go");
    assert_eq!(third.ask(r#"{"do":"refuse"}"#)["refused"], json!("no"));
}

#[test]
fn a_key_is_let_go_when_nobody_is_heard_of() {
    let place = place();
    let (mut operator, mut other) = (Client::new(&place), Client::new(&place));
    operator.ask(r#"{"do":"take_command"}"#);
    operator.ask(r#"{"do":"key","key":"X+","down":true}"#);
    for _ in 0..10 {
        std::thread::sleep(Duration::from_millis(60));
        operator.ask(r#"{"do":"alive"}"#);
    }
    assert!(other.moves(), "heard of every 60 ms");
    let until = Instant::now() + Duration::from_secs(10);
    while other.moves() {
        assert!(Instant::now() < until, "still pressed");
        std::thread::sleep(Duration::from_millis(10));
    }
    operator.ask(r#"{"do":"key","key":"X+","down":true}"#);
    assert!(other.moves());
    drop(operator);
    let until = Instant::now() + Duration::from_secs(10);
    while other.moves() {
        assert!(Instant::now() < until, "still pressed by nobody");
        std::thread::sleep(Duration::from_millis(10));
    }
}

#[test]
fn only_keys_that_were_pressed_are_let_go_and_they_are_few() {
    let place = place();
    let (mut operator, mut other) = (Client::new(&place), Client::new(&place));
    other.ask(r#"{"do":"watch","events":true}"#);
    operator.ask(r#"{"do":"take_command"}"#);
    let mut press = |key: &str| operator.ask(&json!({ "do": "key", "key": key, "down": true }).to_string());
    for number in 0..100 {
        assert_eq!(press(&format!("NO{number}"))["refused"], json!("no key"));
    }
    let longest = "L".repeat(128);
    let keys =
        ["X+".to_owned(), longest.clone()].into_iter().chain((2..64).map(|number| format!("K{number}")));
    for key in keys {
        assert_eq!(press(&key)["reply"], json!("done"), "{key}");
        assert_eq!(press(&key)["reply"], json!("done"), "{key} again");
        assert_eq!(press(&format!("{longest}L"))["error"], json!("busy"));
    }
    assert_eq!(press("K64")["error"], json!("busy"));
    drop(operator);
    let mut let_go = 0;
    while let_go < 64 {
        let event = other.hear();
        let_go += u32::from(event == json!({"event":"key","down":false}));
        assert_ne!(event, json!({"event":"no key","down":false}), "after {let_go}");
    }
}

#[test]
fn what_takes_long_holds_up_nothing_of_the_same_connection() {
    let place = place();
    let (mut client, mut other) = (Client::new(&place), Client::new(&place));
    client.ask(r#"{"do":"take_command"}"#);
    client.ask(r#"{"do":"key","key":"X+","down":true}"#);
    assert!(other.moves());
    let began = Instant::now();
    client.say(r#"{"id":1,"do":"ponder","ms":3000}"#);
    client.say(r#"{"id":2,"do":"ponder","ms":1}"#);
    // The key is let go at once, and what comes behind is done too.
    assert_eq!(client.ask(r#"{"id":3,"do":"key","key":"X+","down":false}"#), json!({"id":3,"reply":"done"}));
    assert_eq!(client.ask(r#"{"id":4,"do":"position"}"#)["moves"], json!(false));
    assert_eq!(client.ask(r#"{"id":5,"do":"stop"}"#), json!({"id":5,"reply":"done"}));
    assert!(began.elapsed() < Duration::from_secs(2), "{:?}", began.elapsed());
    // Their answers come in their own order.
    assert_eq!(client.hear(), json!({"id":1,"reply":"pondered"}));
    assert!(began.elapsed() >= Duration::from_secs(3));
    assert_eq!(client.hear(), json!({"id":2,"reply":"pondered"}));
}

#[test]
fn a_key_is_let_go_by_a_connection_that_ends_while_something_takes_long() {
    let place = place();
    let (mut client, mut other) = (Client::new(&place), Client::new(&place));
    client.ask(r#"{"do":"take_command"}"#);
    let began = Instant::now();
    client.say(r#"{"do":"ponder","ms":5000}"#);
    client.ask(r#"{"do":"key","key":"X+","down":true}"#);
    assert!(other.moves());
    drop(client);
    while other.moves() {
        assert!(began.elapsed() < Duration::from_secs(4), "still pressed");
        std::thread::sleep(Duration::from_millis(10));
    }
    // Command is free as well.
    while other.ask(r#"{"do":"take_command"}"#)["reply"] != json!("done") {
        assert!(began.elapsed() < Duration::from_secs(4), "still in command");
        std::thread::sleep(Duration::from_millis(10));
    }
}

#[test]
fn what_takes_long_needs_command_and_waits_in_a_bounded_queue() {
    let place = place();
    let mut client = Client::new(&place);
    assert_eq!(client.ask(r#"{"do":"ponder","ms":1}"#)["error"], json!("not_in_command"));
    client.ask(r#"{"do":"take_command"}"#);
    client.say(r#"{"id":0,"do":"ponder","ms":2000}"#);
    // It is being done by now.
    std::thread::sleep(Duration::from_millis(300));
    for id in 1..=MOST_LONG + 1 {
        client.say(&format!(r#"{{"id":{id},"do":"ponder","ms":1}}"#));
    }
    let mut answer = client.hear();
    assert_eq!(answer["error"], json!("busy"));
    // Who gives command away has none for what waits.
    assert_eq!(client.ask(r#"{"id":"a","do":"give_command"}"#)["id"], json!("a"));
    let mut pondered = 0;
    for _ in 0..MOST_LONG {
        answer = client.hear();
        pondered += u32::from(answer["reply"] == json!("pondered"));
        assert!(
            answer["reply"] == json!("pondered") || answer["error"] == json!("not_in_command"),
            "{answer}"
        );
    }
    assert_eq!(pondered, 1);
}

#[test]
fn statuses_are_pushed_to_those_who_want_them() {
    let place = place();
    let mut client = Client::new(&place);
    client.ask(r#"{"do":"watch","status":true}"#);
    let began = Instant::now();
    for _ in 0..10 {
        let status = client.hear();
        assert_eq!(status, json!({"status": { "at": 0.0, "is_pressed": false }}));
    }
    // Every 20 ms.
    assert!(began.elapsed() >= Duration::from_millis(150), "{:?}", began.elapsed());
}

#[test]
fn a_reader_that_takes_nothing_is_cut_off_and_the_machine_goes_on() {
    let place = place();
    let (mut slow, mut other) = (Client::new(&place), Client::new(&place));
    slow.ask(r#"{"do":"watch","events":true}"#);
    slow.hear();
    // 40 MB that it does not read.
    for _ in 0..4 {
        other.ask(r#"{"do":"chatter","count":500}"#);
        std::thread::sleep(Duration::from_millis(200));
    }
    let mut all = Vec::new();
    // What the system held is still there, then it ends.
    slow.stream.read_to_end(&mut all).unwrap_or_default();
    assert!(all.len() < 40_000_000);
    assert!(!other.moves());
}

#[test]
fn a_line_without_an_end_is_cut_off() {
    let place = place();
    let mut client = Client::new(&place);
    let piece = vec![b'x'; 1 << 16];
    let mut sent = 0;
    while sent <= LONGEST_LINE + piece.len() {
        if client.stream.get_mut().write_all(&piece).is_err() {
            break;
        }
        sent += piece.len();
    }
    let mut rest = String::new();
    let _ = client.stream.read_to_string(&mut rest);
    assert!(rest.is_empty() || rest.contains("line_too_long"), "{rest}");
    assert!(!Client::new(&place).moves());
}

#[test]
fn any_bytes_end_in_an_answer() {
    let place = place();
    let mut client = Client::new(&place);
    let mut seed = 1u64;
    for _ in 0..300 {
        let mut line: Vec<u8> = (0..seed % 60)
            .map(|_| {
                seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                br#"{}[]",:0123 "do"nulltrue\"#[(seed >> 33) as usize % 25]
            })
            .collect();
        seed = seed.wrapping_add(1);
        line.push(b'\n');
        client.stream.get_mut().write_all(&line).unwrap();
        assert!(client.hear().is_object());
    }
    let deep = "[".repeat(100_000);
    assert_eq!(client.ask(&deep)["error"], json!("no_object"));
}

#[test]
fn a_unix_socket_is_its_owners_and_is_taken_over_from_the_dead_alone() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mill.sock");
    // Somebody who died left his behind, open to all.
    drop(UnixListener::bind(&path).unwrap());
    std::fs::set_permissions(&path, std::os::unix::fs::PermissionsExt::from_mode(0o777)).unwrap();
    let (_runner, hub) = machine();
    let listener = listen_at(&path).unwrap();
    let about = std::fs::symlink_metadata(&path).unwrap();
    assert!(about.file_type().is_socket() && about.mode() & 0o777 == 0o600, "{:o}", about.mode());
    // One that is served stays, whoever comes second.
    serve(hub, listener).unwrap();
    assert_eq!(listen_at(&path).unwrap_err().kind(), ErrorKind::AddrInUse);
    assert_eq!(std::fs::metadata(&path).unwrap().ino(), about.ino());
    let stream = UnixStream::connect(&path).unwrap();
    stream.set_read_timeout(Some(Duration::from_secs(20))).unwrap();
    let mut lines = BufReader::new(stream.try_clone().unwrap()).lines();
    let mut hear = || serde_json::from_str::<Value>(&lines.next().unwrap().unwrap()).unwrap();
    assert_eq!(hear()["hello"], json!("ferrocut"));
    (&stream).write_all(b"{\"id\":1,\"do\":\"position\"}\n").unwrap();
    assert_eq!(hear()["reply"], json!("position"));
}

/// Nothing but a socket is ever removed.
#[test]
fn a_file_where_a_socket_should_be_stays() {
    let folder = tempfile::tempdir().unwrap();
    let (file, link) = (folder.path().join("program.nc"), folder.path().join("link"));
    std::fs::write(&file, "M30\n").unwrap();
    std::os::unix::fs::symlink(&file, &link).unwrap();
    for path in [&file, &link] {
        assert_eq!(listen_at(path).unwrap_err().kind(), ErrorKind::AddrInUse, "{path:?}");
    }
    assert_eq!(std::fs::read_to_string(&link).unwrap(), "M30\n");
    assert!(listen_at(&folder.path().join("none/mill.sock")).is_err());
}
