//! JSON lines over sockets of this computer: a command a line, an answer a line, events as they happen
//! (`docs/serve.md`).
//!
//! Two threads a connection: one reads commands, one writes what waits for it. What a slow reader has not taken waits in
//! a bounded queue; once that is full the connection ends. One connection is in command, the others watch. A key that
//! is pressed over a connection is let go when the connection ends, or is not heard of for [`DEAD_MAN`].

use crate::runner::{Latest, Runner};
use crate::service::{Need, Request, Served, Service};
use rustix::fs::Mode;
use serde_json::{Map, Value, json};
use std::collections::HashMap;
use std::io::{self, ErrorKind, Read, Write};
use std::net::{Shutdown, TcpListener, TcpStream};
use std::os::unix::fs::FileTypeExt;
use std::os::unix::net::{UnixListener, UnixStream};
use std::path::Path;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender, TrySendError, sync_channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// How long a connection that holds a key may be silent.
pub const DEAD_MAN: Duration = Duration::from_millis(250);

/// Bytes of a line: a program that is stored with it.
pub const LONGEST_LINE: usize = 4 << 20;

/// Lines that wait for a reader, and how long a write may take.
const MOST_WAITING: usize = 256;
const WRITE: Duration = Duration::from_secs(2);

/// Connections at once.
const MOST_CONNECTIONS: usize = 16;

/// Time between two looks of a reader at its dead man's key.
const LOOK: Duration = Duration::from_millis(25);

/// Time between two statuses that are pushed.
const STATUS: Duration = Duration::from_millis(100);

/// How long an answer of the machine may take.
const ANSWER: Duration = Duration::from_secs(10);

/// A stream of bytes that can be shared between a reader and a writer.
pub trait Stream: Read + Write + Send + Sized + 'static {
    /// Another handle of it.
    fn again(&self) -> io::Result<Self>;
    /// How long reads and writes wait.
    fn patience(&self, read: Duration, write: Duration) -> io::Result<()>;
    /// Ends it for both.
    fn end(&self);
}

impl Stream for TcpStream {
    fn again(&self) -> io::Result<TcpStream> {
        self.try_clone()
    }
    fn patience(&self, read: Duration, write: Duration) -> io::Result<()> {
        self.set_nodelay(true)?;
        self.set_read_timeout(Some(read))?;
        self.set_write_timeout(Some(write))
    }
    fn end(&self) {
        let _ = self.shutdown(Shutdown::Both);
    }
}

impl Stream for UnixStream {
    fn again(&self) -> io::Result<UnixStream> {
        self.try_clone()
    }
    fn patience(&self, read: Duration, write: Duration) -> io::Result<()> {
        self.set_read_timeout(Some(read))?;
        self.set_write_timeout(Some(write))
    }
    fn end(&self) {
        let _ = self.shutdown(Shutdown::Both);
    }
}

/// Something that streams come from.
pub trait Listener: Send + 'static {
    /// What comes.
    type Stream: Stream;
    /// The next one.
    fn next(&self) -> io::Result<Self::Stream>;
}

impl Listener for TcpListener {
    type Stream = TcpStream;
    fn next(&self) -> io::Result<TcpStream> {
        self.accept().map(|(stream, _)| stream)
    }
}

impl Listener for UnixListener {
    type Stream = UnixStream;
    fn next(&self) -> io::Result<UnixStream> {
        self.accept().map(|(stream, _)| stream)
    }
}

/// A connection, as the others see it.
struct Member {
    out: SyncSender<String>,
    /// It wants events.
    events: bool,
    /// It wants statuses.
    statuses: bool,
    /// It did not take what waited for it.
    is_slow: Arc<AtomicBool>,
}

/// What connections share.
pub struct Hub<S: Service> {
    commands: SyncSender<Request<S>>,
    latest: Arc<Latest<S::Status>>,
    members: Mutex<HashMap<u64, Member>>,
    /// The connection in command.
    commander: Mutex<Option<u64>>,
    next: AtomicU64,
}

/// A Unix socket that only its owner may use. One that a process left behind is replaced; one that is served is not.
pub fn listen_at(path: &Path) -> io::Result<UnixListener> {
    let is_socket = std::fs::symlink_metadata(path).is_ok_and(|about| about.file_type().is_socket());
    if is_socket && UnixStream::connect(path).is_err() {
        std::fs::remove_file(path)?;
    }
    // Never open to others, not even for the moment before its rights are set.
    let before = rustix::process::umask(Mode::from_raw_mode(0o177));
    let listener = UnixListener::bind(path);
    rustix::process::umask(before);
    listener
}

/// A service that runs, and what connects to it.
type Begun<S> = (Runner<Served<S>>, Arc<Hub<S>>);

/// Starts the machine's thread and the one that tells its events.
pub fn start<S: Service>(service: S, period: Duration, priority: Option<u8>) -> io::Result<Begun<S>> {
    let (events, told) = sync_channel(MOST_WAITING);
    let runner = Runner::start(Served::new(service, events), period, priority)?;
    let hub = Arc::new(Hub {
        commands: runner.commands(),
        latest: runner.latest(),
        members: Mutex::new(HashMap::new()),
        commander: Mutex::new(None),
        next: AtomicU64::new(1),
    });
    let teller = Arc::downgrade(&hub);
    std::thread::Builder::new().name("events".to_owned()).spawn(move || {
        let mut next = Instant::now();
        loop {
            let event = told.recv_timeout(STATUS.min(next.saturating_duration_since(Instant::now())));
            let Some(hub) = teller.upgrade() else { return };
            match event {
                Ok(event) => hub.tell(|member| member.events, &event),
                Err(RecvTimeoutError::Timeout) => {}
                Err(RecvTimeoutError::Disconnected) => return,
            }
            if Instant::now() >= next {
                next = Instant::now() + STATUS;
                let status = hub.latest.get();
                hub.tell(|member| member.statuses, &json!({ "event": "status", "status": &*status }));
            }
        }
    })?;
    Ok((runner, hub))
}

/// Takes connections, until the process ends.
pub fn serve<S: Service, L: Listener>(hub: Arc<Hub<S>>, listener: L) -> io::Result<()> {
    std::thread::Builder::new().name("sockets".to_owned()).spawn(move || {
        loop {
            match listener.next() {
                Ok(stream) => {
                    let hub = hub.clone();
                    // A connection that finds no thread is ended by being dropped.
                    let _ = std::thread::Builder::new()
                        .name("connection".to_owned())
                        .spawn(move || drop(hub.connection(stream)));
                }
                // Out of descriptors: others will be given back.
                Err(_) => std::thread::sleep(STATUS),
            }
        }
    })?;
    Ok(())
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

fn line_of(value: &impl serde::Serialize) -> String {
    // What is served has no maps with keys that are no text.
    serde_json::to_string(value).unwrap_or_default() + "\n"
}

/// The keys that a connection holds.
struct Held<S: Service> {
    hub: Arc<Hub<S>>,
    number: u64,
    keys: Vec<String>,
}

impl<S: Service> Held<S> {
    /// Lets all of them go.
    fn release(&mut self) {
        for key in std::mem::take(&mut self.keys) {
            let _ = self.hub.commands.send(Request {
                command: S::release(&key),
                from: self.number,
                answer: None,
            });
        }
    }

    fn note(&mut self, key: &str, down: bool) {
        self.keys.retain(|own| own != key);
        if down {
            self.keys.push(key.to_owned());
        }
    }
}

impl<S: Service> Drop for Held<S> {
    fn drop(&mut self) {
        self.release();
        if let Some(command) = S::farewell() {
            let _ = self.hub.commands.send(Request { command, from: self.number, answer: None });
        }
        lock(&self.hub.members).remove(&self.number);
        let mut commander = lock(&self.hub.commander);
        if *commander == Some(self.number) {
            *commander = None;
        }
    }
}

impl<S: Service> Hub<S> {
    /// Sends to those who want it. Who does not keep up is marked, and its reader ends the connection.
    fn tell(&self, wants: impl Fn(&Member) -> bool, what: &impl serde::Serialize) {
        let members = lock(&self.members);
        if !members.values().any(&wants) {
            return;
        }
        let line = line_of(what);
        for member in members.values().filter(|member| wants(member)) {
            if let Err(TrySendError::Full(_)) = member.out.try_send(line.clone()) {
                member.is_slow.store(true, Ordering::Relaxed);
            }
        }
    }

    fn connection<L: Stream>(self: Arc<Hub<S>>, mut stream: L) -> io::Result<()> {
        stream.patience(LOOK, WRITE)?;
        let number = self.next.fetch_add(1, Ordering::Relaxed);
        let (out, waiting) = sync_channel(MOST_WAITING);
        let is_slow = Arc::new(AtomicBool::new(false));
        {
            let mut members = lock(&self.members);
            if members.len() >= MOST_CONNECTIONS {
                return stream.write_all(line_of(&json!({ "end": "too_many_connections" })).as_bytes());
            }
            let member =
                Member { out: out.clone(), events: false, statuses: false, is_slow: is_slow.clone() };
            members.insert(number, member);
        }
        // From here on whatever ends the connection lets its keys go.
        let mut held = Held { hub: self.clone(), number, keys: Vec::new() };
        let hello = json!({ "hello": "ferrocut", "api": S::VERSION, "connection": number,
            "longest_line": LONGEST_LINE, "dead_man_ms": DEAD_MAN.as_millis() as u64 });
        let _ = out.try_send(line_of(&hello));
        let mut writer = stream.again()?;
        let ends = is_slow.clone();
        std::thread::Builder::new()
            .name("writer".to_owned())
            .spawn(move || write(&mut writer, &waiting, &ends))?;
        let mut lines = Lines::default();
        let reason = loop {
            if is_slow.load(Ordering::Relaxed) {
                break "too_slow";
            }
            if !held.keys.is_empty() && lines.heard.elapsed() > DEAD_MAN {
                held.release();
            }
            match lines.next(&mut stream) {
                Ok(Some(line)) => {
                    let answer = self.answer(&line, &mut held);
                    if out.try_send(line_of(&answer)).is_err() {
                        break "too_slow";
                    }
                }
                Ok(None) => {}
                Err(error) if error.kind() == ErrorKind::FileTooLarge => break "line_too_long",
                Err(_) => break "closed",
            }
        };
        drop(held);
        let _ = out.try_send(line_of(&json!({ "end": reason })));
        drop(out);
        if reason != "closed" {
            // Time for the reason to be read.
            std::thread::sleep(LOOK);
        }
        stream.end();
        Ok(())
    }

    /// The answer to a line.
    fn answer(self: &Arc<Hub<S>>, line: &[u8], held: &mut Held<S>) -> Value {
        let Ok(Value::Object(mut object)) = serde_json::from_slice::<Value>(line) else {
            return json!({ "id": null, "error": "no_object" });
        };
        let id = object.remove("id").unwrap_or(Value::Null);
        if !matches!(id, Value::Null | Value::Number(_) | Value::String(_)) {
            return json!({ "id": null, "error": "bad_id" });
        }
        let mut answer = Map::new();
        match self.request(object, held) {
            Ok(Value::Object(reply)) => answer = reply,
            Ok(_) => drop(answer.insert("reply".to_owned(), json!("done"))),
            Err(error) => answer = error,
        }
        answer.insert("id".to_owned(), id);
        Value::Object(answer)
    }

    fn request(
        self: &Arc<Hub<S>>,
        object: Map<String, Value>,
        held: &mut Held<S>,
    ) -> Result<Value, Map<String, Value>> {
        let number = held.number;
        let flag = |name: &str| object.get(name).and_then(Value::as_bool).unwrap_or(false);
        match object.get("do").and_then(Value::as_str) {
            Some("alive") => return Ok(Value::Null),
            Some("watch") => {
                if let Some(member) = lock(&self.members).get_mut(&number) {
                    (member.events, member.statuses) = (flag("events"), flag("status"));
                }
                return Ok(Value::Null);
            }
            Some("take_command") => {
                let mut commander = lock(&self.commander);
                return match *commander {
                    Some(other) if other != number => Err(error("taken", &other.to_string())),
                    _ => {
                        *commander = Some(number);
                        Ok(Value::Null)
                    }
                };
            }
            Some("give_command") => {
                held.release();
                let mut commander = lock(&self.commander);
                if *commander == Some(number) {
                    *commander = None;
                }
                return Ok(Value::Null);
            }
            _ => {}
        }
        let command: S::Command =
            serde_json::from_value(Value::Object(object)).map_err(|e| error("no_command", &e.to_string()))?;
        if S::need(&command) == Need::Command && *lock(&self.commander) != Some(number) {
            return Err(error("not_in_command", ""));
        }
        if let Some((key, down)) = S::key(&command) {
            held.note(key, down);
        }
        let (to, answer) = sync_channel(1);
        let request = Request { command, from: number, answer: Some(to) };
        self.commands.send(request).map_err(|_| error("no_machine", ""))?;
        match answer.recv_timeout(ANSWER) {
            Ok(Ok(reply)) => Ok(serde_json::to_value(&reply).unwrap_or_default()),
            Ok(Err(refusal)) => {
                let mut map = Map::new();
                map.insert("refused".to_owned(), serde_json::to_value(&refusal).unwrap_or_default());
                Err(map)
            }
            Err(_) => Err(error("no_answer", "")),
        }
    }
}

fn error(code: &str, detail: &str) -> Map<String, Value> {
    let mut map = Map::new();
    map.insert("error".to_owned(), json!(code));
    if !detail.is_empty() {
        map.insert("detail".to_owned(), json!(detail));
    }
    map
}

/// Writes what waits, until nobody can add to it. A write that takes too long ends the connection.
fn write(stream: &mut impl Stream, waiting: &Receiver<String>, is_slow: &AtomicBool) {
    for line in waiting {
        if stream.write_all(line.as_bytes()).is_err() {
            is_slow.store(true, Ordering::Relaxed);
            return;
        }
    }
}

/// Lines of a stream, of bounded length.
struct Lines {
    bytes: Vec<u8>,
    /// Bytes of it in which no line end was found.
    searched: usize,
    /// When something came last.
    heard: Instant,
    buffer: Vec<u8>,
}

impl Default for Lines {
    fn default() -> Lines {
        Lines { bytes: Vec::new(), searched: 0, heard: Instant::now(), buffer: vec![0; 1 << 14] }
    }
}

impl Lines {
    /// The next line, if one is whole by now.
    fn next(&mut self, stream: &mut impl Read) -> io::Result<Option<Vec<u8>>> {
        if let Some(line) = self.cut() {
            return Ok(Some(line));
        }
        match stream.read(&mut self.buffer) {
            Ok(0) => Err(io::Error::from(ErrorKind::UnexpectedEof)),
            Ok(count) => {
                self.heard = Instant::now();
                self.bytes.extend_from_slice(self.buffer.get(..count).unwrap_or(&[]));
                let line = self.cut();
                if line.is_none() && self.bytes.len() > LONGEST_LINE {
                    return Err(io::Error::from(ErrorKind::FileTooLarge));
                }
                Ok(line)
            }
            Err(e)
                if matches!(
                    e.kind(),
                    ErrorKind::WouldBlock | ErrorKind::TimedOut | ErrorKind::Interrupted
                ) =>
            {
                Ok(None)
            }
            Err(e) => Err(e),
        }
    }

    fn cut(&mut self) -> Option<Vec<u8>> {
        let rest = self.bytes.get(self.searched..)?;
        match rest.iter().position(|byte| *byte == b'\n') {
            Some(at) => {
                let end = self.searched + at;
                self.searched = 0;
                let mut line: Vec<u8> = self.bytes.drain(..=end).collect();
                line.pop();
                Some(line)
            }
            None => {
                self.searched = self.bytes.len();
                None
            }
        }
    }
}
