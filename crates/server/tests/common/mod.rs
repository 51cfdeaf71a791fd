//! A control with its panel on a port of its own, and clients of it.
#![allow(dead_code)]

use ferrocut_controller::{Control, Parts, Tick};
use ferrocut_machine::Machine;
use ferrocut_memory::Store;
use ferrocut_plc::{Limits, Program};
use ferrocut_server::hub::{self, Hub};
use ferrocut_server::panel::{self, Panel};
use ferrocut_server::runner::Runner;
use ferrocut_server::service::Served;
use ferrocut_server::web::{Certificate, Settings, Web};
use serde_json::{Value, json};
use std::collections::VecDeque;
use std::io::{Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::sync::Arc;
use std::time::{Duration, Instant};
use tungstenite::client::IntoClientRequest;
use tungstenite::{Message, WebSocket};

const LADDER: &str = include_str!("../../../../machines/standard.lad");
const TOOL_CHANGE: &str = include_str!("../../../../machines/tool-change.nc");

/// The demo mill with the standard ladder and its tool change.
pub fn control(store: Option<Arc<Store>>) -> Control {
    let mut machine = Machine::demo_mill();
    machine.plant.get_or_insert_default();
    let ladder = Program::from_text(LADDER.as_bytes(), &Limits::default()).unwrap();
    let tool_change = Some(TOOL_CHANGE.into());
    let parts = Parts { ladder: Some(ladder), store, tool_change, ..Parts::default() };
    Control::new(&machine, parts).unwrap()
}

pub struct Place {
    pub web: Web,
    pub hub: Arc<Hub<Panel>>,
    pub runner: Runner<Served<Panel>>,
}

impl Place {
    /// On this computer alone.
    pub fn local() -> Place {
        Place::new(Panel::new(control(None)), None, "127.0.0.1:0", None)
    }

    /// The same, with somebody who sees each period.
    pub fn watched(watcher: impl FnMut(&Tick) + Send + 'static) -> Place {
        Place::new(Panel::watched(control(None), Box::new(watcher)), None, "127.0.0.1:0", None)
    }

    pub fn new(
        panel: Panel,
        store: Option<Arc<Store>>,
        address: &str,
        certificate: Option<Certificate>,
    ) -> Place {
        let aside = Some(panel::aside(store.clone()));
        let (runner, hub) = hub::start(panel, Duration::from_millis(1), None, aside).unwrap();
        let settings = Settings {
            address: address.parse().unwrap(),
            certificate,
            names: Vec::new(),
            machine: Machine::demo_mill(),
            store,
        };
        let web = Web::start(settings, hub.clone()).unwrap();
        Place { web, hub, runner }
    }

    pub fn address(&self) -> SocketAddr {
        self.web.address()
    }

    pub fn get(&self, path: &str) -> Answer {
        self.http("GET", path, &[], b"")
    }

    pub fn http(&self, method: &str, path: &str, heads: &[(&str, &str)], body: &[u8]) -> Answer {
        ask(TcpStream::connect(self.address()).unwrap(), method, path, heads, body)
    }

    pub fn socket(&self) -> Socket {
        Socket::new(self.address(), &[]).unwrap()
    }

    /// Periods of the machine.
    pub fn periods(&self) -> u64 {
        self.hub.status().periods
    }
}

pub struct Answer {
    pub status: u16,
    pub head: String,
    pub body: Vec<u8>,
}

impl Answer {
    pub fn json(&self) -> Value {
        serde_json::from_slice(&self.body).unwrap_or_else(|error| panic!("{error}: {}", self.text()))
    }

    pub fn text(&self) -> String {
        String::from_utf8_lossy(&self.body).into_owned()
    }

    /// A line of the head.
    pub fn head(&self, name: &str) -> Option<&str> {
        let lines = self.head.lines().filter_map(|line| line.split_once(':'));
        lines.filter(|(own, _)| own.eq_ignore_ascii_case(name)).map(|(_, value)| value.trim()).next()
    }

    /// The cookie as it is sent back.
    pub fn cookie(&self) -> String {
        self.head("set-cookie").unwrap().split(';').next().unwrap().to_owned()
    }
}

/// Sends a request over a stream of its own, and reads all that comes.
pub fn ask(
    mut stream: impl Read + Write,
    method: &str,
    path: &str,
    heads: &[(&str, &str)],
    body: &[u8],
) -> Answer {
    let mut request = format!("{method} {path} HTTP/1.1\r\nconnection: close\r\n");
    if heads.iter().all(|(name, _)| !name.eq_ignore_ascii_case("host")) {
        request += "host: localhost\r\n";
    }
    if heads.iter().all(|(name, _)| !name.eq_ignore_ascii_case("content-length")) {
        request += &format!("content-length: {}\r\n", body.len());
    }
    heads.iter().for_each(|(name, value)| request += &format!("{name}: {value}\r\n"));
    request += "\r\n";
    stream.write_all(request.as_bytes()).unwrap();
    // The server may have answered and closed before all was sent.
    let _ = stream.write_all(body);
    let mut all = Vec::new();
    let _ = stream.read_to_end(&mut all);
    answer(&all)
}

pub fn answer(all: &[u8]) -> Answer {
    let split = all.windows(4).position(|four| four == b"\r\n\r\n");
    let Some(at) = split else { return Answer { status: 0, head: String::new(), body: Vec::new() } };
    let head = String::from_utf8_lossy(&all[..at]).into_owned();
    let status = head.split(' ').nth(1).and_then(|code| code.parse().ok()).unwrap_or(0);
    let mut body = all[at + 4..].to_vec();
    if head.to_ascii_lowercase().contains("transfer-encoding: chunked") {
        body = unchunked(&body);
    }
    Answer { status, head, body }
}

fn unchunked(mut rest: &[u8]) -> Vec<u8> {
    let mut body = Vec::new();
    while let Some(at) = rest.windows(2).position(|two| two == b"\r\n") {
        let length = usize::from_str_radix(std::str::from_utf8(&rest[..at]).unwrap(), 16).unwrap();
        if length == 0 {
            break;
        }
        body.extend_from_slice(&rest[at + 2..at + 2 + length]);
        rest = &rest[at + 2 + length + 2..];
    }
    body
}

/// A browser's socket.
pub struct Socket<S: Read + Write = TcpStream> {
    pub socket: WebSocket<S>,
    pub hello: Value,
    waiting: VecDeque<Value>,
    next: u64,
}

impl Socket {
    pub fn new(address: SocketAddr, heads: &[(&'static str, &str)]) -> Result<Socket, String> {
        let stream = TcpStream::connect(address).map_err(|error| error.to_string())?;
        stream.set_nodelay(true).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(20))).unwrap();
        Socket::over(stream, "ws", heads)
    }
}

impl<S: Read + Write> Socket<S> {
    pub fn over(stream: S, scheme: &str, heads: &[(&'static str, &str)]) -> Result<Socket<S>, String> {
        let mut request = format!("{scheme}://localhost/api/socket").into_client_request().unwrap();
        for (name, value) in heads {
            request.headers_mut().insert(*name, value.parse().unwrap());
        }
        let (socket, _) = tungstenite::client::client(request, stream).map_err(|error| error.to_string())?;
        let mut socket = Socket { socket, hello: Value::Null, waiting: VecDeque::new(), next: 1 };
        socket.hello = socket.hear();
        Ok(socket)
    }

    /// The next thing that comes.
    pub fn hear(&mut self) -> Value {
        self.try_hear().unwrap()
    }

    pub fn try_hear(&mut self) -> Result<Value, String> {
        if let Some(value) = self.waiting.pop_front() {
            return Ok(value);
        }
        self.read()
    }

    fn read(&mut self) -> Result<Value, String> {
        loop {
            match self.socket.read().map_err(|error| error.to_string())? {
                Message::Text(text) => return Ok(serde_json::from_str(&text).unwrap()),
                Message::Close(_) => return Err("closed".to_owned()),
                _ => {}
            }
        }
    }

    pub fn say(&mut self, mut command: Value) -> u64 {
        let id = self.next;
        self.next += 1;
        command["id"] = json!(id);
        self.socket.send(Message::Text(command.to_string().into())).unwrap();
        id
    }

    /// The answer to a command; what else comes waits.
    pub fn ask(&mut self, command: Value) -> Value {
        let id = self.say(command);
        loop {
            let value = self.read().unwrap();
            if value["id"] == json!(id) {
                return value;
            }
            self.waiting.push_back(value);
        }
    }

    /// Has something done.
    pub fn tell(&mut self, command: Value) {
        let answer = self.ask(command.clone());
        assert_eq!(answer["reply"], json!("done"), "{command}: {answer}");
    }

    pub fn status(&mut self) -> Value {
        self.ask(json!({ "do": "status" }))
    }

    /// Presses a key and lets it go.
    pub fn press(&mut self, key: &str) {
        for down in [true, false] {
            self.tell(json!({ "do": "key", "key": key, "down": down }));
            std::thread::sleep(Duration::from_millis(60));
        }
    }

    /// Takes command as soon as nobody has it.
    pub fn take_command(&mut self) {
        let began = Instant::now();
        while self.ask(json!({ "do": "take_command" }))["reply"] != json!("done") {
            assert!(began.elapsed() < Duration::from_secs(20), "command is never free");
            std::thread::sleep(Duration::from_millis(2));
        }
    }

    /// Waits until the status is as wanted.
    pub fn until(&mut self, what: &str, is: impl Fn(&Value) -> bool) -> Value {
        let began = Instant::now();
        loop {
            let status = self.status();
            if is(&status) {
                return status;
            }
            assert!(began.elapsed() < Duration::from_secs(60), "never {what}: {status}");
            std::thread::sleep(Duration::from_millis(20));
        }
    }
}

/// Switches as they stand on a machine that is used.
pub fn set_up(socket: &mut Socket) {
    socket.take_command();
    socket.tell(json!({ "do": "switch", "switch": "SWITCH_FEED", "position": 10 }));
    socket.tell(json!({ "do": "switch", "switch": "SWITCH_SPINDLE", "position": 5 }));
    std::thread::sleep(Duration::from_millis(100));
    socket.press("KEY_R_100");
}
