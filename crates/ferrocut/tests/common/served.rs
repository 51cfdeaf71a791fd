//! `ferrocut serve` in a process of its own, and a program that connects to it.

use assert_cmd::cargo::CommandCargoExt;
use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Write};
use std::net::TcpStream;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// A machine that is served, ended with the value.
pub struct Served {
    process: Child,
    pub place: String,
}

impl Served {
    pub fn new(how: &str, place: &str) -> Served {
        Served::with(&[how, place])
    }

    pub fn with(arguments: &[&str]) -> Served {
        let mut command = Command::cargo_bin("ferrocut").unwrap();
        command.args(["serve", "--headless"]).args(arguments);
        let mut process = command.stdout(Stdio::piped()).spawn().unwrap();
        let mut line = String::new();
        BufReader::new(process.stdout.take().unwrap()).read_line(&mut line).unwrap();
        let place = line.trim().rsplit(' ').next().unwrap().to_owned();
        Served { process, place }
    }

    /// Ends it as Ctrl-C does; whether it ended well.
    pub fn interrupt(mut self) -> bool {
        let told = Command::new("kill").args(["-2", &self.process.id().to_string()]).status().unwrap();
        told.success() && self.process.wait().unwrap().success()
    }
}

impl Drop for Served {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

/// A program that connected to the whole control, and is in command.
pub struct Front {
    stream: TcpStream,
    lines: std::io::Lines<BufReader<TcpStream>>,
    asked: u32,
    /// What happened meanwhile.
    pub events: Vec<Value>,
}

impl Front {
    pub fn new(served: &Served) -> Front {
        let stream = TcpStream::connect(&served.place).unwrap();
        let lines = BufReader::new(stream.try_clone().unwrap()).lines();
        let mut front = Front { stream, lines, asked: 0, events: Vec::new() };
        assert_eq!(front.hear()["hello"], "ferrocut");
        for command in [json!({ "do": "take_command" }), json!({ "do": "watch", "events": true })] {
            front.done(command);
        }
        front
    }

    pub fn hear(&mut self) -> Value {
        super::json(&self.lines.next().unwrap().unwrap())
    }

    /// What a command is answered by.
    pub fn ask(&mut self, mut command: Value) -> Value {
        self.asked += 1;
        command["id"] = self.asked.into();
        self.stream.write_all(format!("{command}\n").as_bytes()).unwrap();
        loop {
            let line = self.hear();
            if line["id"] == self.asked {
                return line;
            }
            self.events.push(line);
        }
    }

    pub fn done(&mut self, command: Value) {
        let answer = self.ask(command.clone());
        assert_eq!(answer["reply"], "done", "{command}: {answer}");
    }

    /// The alarm by which a command is refused.
    pub fn refused(&mut self, command: Value) -> Value {
        self.ask(command)["refused"]["alarm"]["id"].clone()
    }

    pub fn press(&mut self, key: &str) {
        for down in [true, false] {
            self.done(json!({ "do": "key", "key": key, "down": down }));
            // As long as a finger is on it, and off it.
            std::thread::sleep(Duration::from_millis(60));
        }
    }

    /// A key that is held for longer than a dead man may be silent.
    pub fn hold(&mut self, key: &str) {
        self.done(json!({ "do": "key", "key": key, "down": true }));
        for _ in 0..4 {
            std::thread::sleep(Duration::from_millis(60));
            self.done(json!({ "do": "alive" }));
        }
        self.done(json!({ "do": "key", "key": key, "down": false }));
    }

    pub fn until(&mut self, what: &str, is: impl Fn(&Value) -> bool) -> Value {
        let began = Instant::now();
        loop {
            let status = self.ask(json!({ "do": "status" }));
            if is(&status) {
                return status;
            }
            assert!(began.elapsed() < Duration::from_secs(60), "never {what}: {status}\n{:?}", self.events);
            std::thread::sleep(Duration::from_millis(10));
        }
    }

    pub fn heard(&self, event: &str) -> bool {
        self.events.iter().any(|line| line["event"] == event)
    }
}
