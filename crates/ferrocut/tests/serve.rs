//! `ferrocut serve` as a sender meets it.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use assert_cmd::cargo::CommandCargoExt;
use common::json;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// A machine that is served, ended with the value.
struct Served {
    process: Child,
    place: String,
}

impl Served {
    fn new(how: &str, place: &str) -> Served {
        let mut command = Command::cargo_bin("ferrocut").unwrap();
        let mut process =
            command.args(["serve", "--headless", how, place]).stdout(Stdio::piped()).spawn().unwrap();
        let mut line = String::new();
        BufReader::new(process.stdout.take().unwrap()).read_line(&mut line).unwrap();
        let place = line.trim().rsplit(' ').next().unwrap().to_owned();
        Served { process, place }
    }
}

impl Drop for Served {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

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

/// The demo mill, whose file describes no simulated machine, is one that can be used.
#[test]
fn a_front_finds_a_machine_that_is_well() {
    let served = Served::new("--tcp", "127.0.0.1:0");
    let mut stream = connect(&served.place);
    stream.set_read_timeout(None).unwrap();
    let mut lines = BufReader::new(stream.try_clone().unwrap()).lines();
    let mut hear = || json(&lines.next().unwrap().unwrap());
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
            assert_eq!(status["alarms"], serde_json::json!([]));
            break;
        }
        assert!(began.elapsed() < Duration::from_secs(30), "{status}");
    }
}
