//! What all connections to a control share: who is connected, who is in command, what each is told.
//!
//! A connection reads on a thread of its own and answers there ([`Connection::converse`]); what takes long is done on
//! a second one, so that nothing that comes behind it waits. What is told waits in a bounded queue. A key that is pressed over a connection is let go when the connection ends, or is not heard of for
//! [`DEAD_MAN`]. Where the bytes come from is the caller's affair: [`crate::lines`] has sockets of this computer,
//! [`crate::web`] browsers.

use crate::helm::{Helm, Person};
use crate::runner::{Latest, Runner};
use crate::service::{Aside, Caller, Need, Request, Served, Service};
use crate::told::{Asking, ConnectionCommand, ConnectionEvent, Hello, PanelInfo, SessionInfo};
use ferrocut_memory::password::Seat;
use ferrocut_memory::{Session, SessionNote};
use serde_json::{Map, Value, json};
use std::collections::HashMap;
use std::io::{self, ErrorKind};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender, sync_channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};
use tokio::sync::mpsc;

/// How long a connection that holds a key may be silent: then the key has been let go.
pub const DEAD_MAN: Duration = Duration::from_millis(250);

/// What the machine, and a computer that is busy, may need of it until the axes stop.
const RESERVE: Duration = Duration::from_millis(40);

/// Bytes of a line: a program that is stored with it.
pub const LONGEST_LINE: usize = 4 << 20;

/// Lines that wait for a reader.
const MOST_WAITING: usize = 256;

/// Commands of a connection that take long, and wait for the one that is being done.
pub const MOST_LONG: usize = 4;

/// Keys that a connection holds at once, and bytes of the name of one: more than a panel has, and few enough to let go
/// when it ends.
const MOST_KEYS: usize = 64;
const LONGEST_KEY: usize = 128;

/// Connections at once.
pub const MOST_CONNECTIONS: usize = 48;

/// Time between two looks of a connection at its dead man's key.
pub(crate) const LOOK: Duration = Duration::from_millis(25);

/// Time between two statuses that are pushed.
const STATUS: Duration = Duration::from_millis(20);

/// How long an answer of the machine may take.
const ANSWER: Duration = Duration::from_secs(10);

/// A line that is told, shared by all who are told it.
pub type Line = Arc<str>;

/// A connection, as the others see it.
struct Member {
    out: mpsc::Sender<Line>,
    /// It wants events.
    events: bool,
    /// It wants statuses.
    statuses: bool,
    /// It did not take what waited for it.
    is_slow: Arc<AtomicBool>,
    /// Who it is, for those who ask whether one of theirs is in command.
    owner: u64,
}

/// What connections share.
pub struct Hub<S: Service> {
    commands: SyncSender<Request<S>>,
    latest: Arc<Latest<S::Status>>,
    members: Mutex<HashMap<u64, Member>>,
    /// The connection in command, and those that ask for it. Whoever locks the members too does so behind it.
    helm: Mutex<Helm>,
    next: AtomicU64,
    aside: Option<Aside<S>>,
}

/// Who connects.
pub struct Visitor {
    /// Where from, as the log has it behind the connection's number; may be empty.
    pub from: String,
    /// Where passwords are given.
    pub seat: Seat,
    /// His rights at the moment; none once he may not be here any more.
    pub rights: Arc<dyn Fn() -> Option<Session> + Send + Sync>,
    /// What the first line says to a browser.
    pub panel: Option<PanelInfo>,
    /// Its session, likewise.
    pub session: Option<SessionInfo>,
    /// A number that all connections of one person have, 0 for none.
    pub owner: u64,
}

impl Visitor {
    /// A program on this computer.
    pub fn local() -> Visitor {
        Visitor {
            from: String::new(),
            seat: Seat::Machine,
            rights: Arc::new(|| Some(Session::OPERATOR)),
            panel: None,
            session: None,
            owner: 0,
        }
    }
}

/// Where lines come from.
pub trait Incoming {
    /// The next line; none where none came for a moment (`LOOK` at most, so that the dead man's key is looked at).
    fn next(&mut self) -> io::Result<Option<Vec<u8>>>;
    /// When something came last.
    fn heard(&self) -> Instant;
}

/// A service that runs, and what connects to it.
type Begun<S> = (Runner<Served<S>>, Arc<Hub<S>>);

/// Starts the machine's thread and the one that tells its events. `aside` does what is not done on the machine's thread.
pub fn start<S: Service>(
    service: S,
    period: Duration,
    priority: Option<u8>,
    aside: Option<Aside<S>>,
) -> io::Result<Begun<S>> {
    let (events, told) = sync_channel(MOST_WAITING);
    let runner = Runner::start(Served::new(service, events), period, priority)?;
    let hub = Arc::new(Hub {
        commands: runner.commands(),
        latest: runner.latest(),
        members: Mutex::new(HashMap::new()),
        helm: Mutex::default(),
        next: AtomicU64::new(1),
        aside,
    });
    let teller = Arc::downgrade(&hub);
    std::thread::Builder::new().name("events".to_owned()).spawn(move || {
        let mut next = Instant::now();
        loop {
            let event = told.recv_timeout(next.saturating_duration_since(Instant::now()));
            let Some(hub) = teller.upgrade() else { return };
            match event {
                Ok(event) => hub.tell_event(&event),
                Err(RecvTimeoutError::Timeout) => {}
                Err(RecvTimeoutError::Disconnected) => return,
            }
            let now = Instant::now();
            if now >= next {
                next = (next + STATUS).max(now);
                hub.tell_status();
            }
        }
    })?;
    Ok((runner, hub))
}

pub(crate) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// What is told, as a line without its end.
pub(crate) fn line_of(value: &impl serde::Serialize) -> Line {
    // What is served has no maps with keys that are no text.
    serde_json::to_string(value).unwrap_or_default().into()
}

/// A connection that has joined. Whatever ends it lets its keys go.
pub struct Connection<S: Service> {
    joined: Arc<Joined<S>>,
    keys: Vec<String>,
    beside: Option<Beside<S>>,
}

/// What both threads of a connection need.
struct Joined<S: Service> {
    hub: Arc<Hub<S>>,
    number: u64,
    visitor: Visitor,
    out: mpsc::Sender<Line>,
    is_slow: Arc<AtomicBool>,
    /// The connection ends: what waits is not done any more.
    ends: AtomicBool,
}

/// The thread that does what takes long, one command behind the other.
struct Beside<S: Service> {
    commands: SyncSender<(Value, S::Command)>,
    thread: JoinHandle<()>,
}

impl<S: Service> Hub<S> {
    /// Takes a connection in, with the queue of what it is told; none where there are too many.
    pub fn join(self: &Arc<Hub<S>>, visitor: Visitor) -> Option<(Connection<S>, mpsc::Receiver<Line>)> {
        let number = self.next.fetch_add(1, Ordering::Relaxed);
        let (out, waiting) = mpsc::channel(MOST_WAITING);
        let is_slow = Arc::new(AtomicBool::new(false));
        let member = Member {
            out: out.clone(),
            events: false,
            statuses: false,
            is_slow: is_slow.clone(),
            owner: visitor.owner,
        };
        {
            let mut members = lock(&self.members);
            if members.len() >= MOST_CONNECTIONS {
                return None;
            }
            members.insert(number, member);
        }
        let hello = Hello {
            hello: "ferrocut",
            api: S::VERSION,
            connection: number,
            longest_line: LONGEST_LINE,
            dead_man_ms: DEAD_MAN.as_millis() as u64,
            panel: visitor.panel.clone(),
            session: visitor.session.clone(),
        };
        let _ = out.try_send(line_of(&hello));
        let ends = AtomicBool::new(false);
        let joined = Joined { hub: self.clone(), number, visitor, out, is_slow, ends };
        Some((Connection { joined: Arc::new(joined), keys: Vec::new(), beside: None }, waiting))
    }

    /// How many are connected.
    pub fn connections(&self) -> usize {
        lock(&self.members).len()
    }

    /// How things stand.
    pub fn status(&self) -> Arc<S::Status> {
        self.latest.get()
    }

    /// Whether a connection of this owner is in command.
    pub fn commands(&self, owner: u64) -> bool {
        let commander = lock(&self.helm).holder();
        commander.is_some_and(|number| {
            lock(&self.members).get(&number).is_some_and(|member| owner != 0 && member.owner == owner)
        })
    }

    /// Has the service looked at between two periods, and waits for what comes of it; none where there is no service
    /// any more. What is done must be as short as a command.
    pub fn look<T: Send + 'static>(&self, look: impl FnOnce(&mut S) -> T + Send + 'static) -> Option<T> {
        let (to, seen) = sync_channel(1);
        let look = move |service: &mut S| drop(to.try_send(look(service)));
        self.commands.send(Request::Look(Box::new(look))).ok()?;
        seen.recv_timeout(ANSWER).ok()
    }

    /// Has a command done, and waits for the answer. Whether the caller may give it was looked at before.
    pub fn ask(
        &self,
        command: S::Command,
        from: Caller,
    ) -> Result<Result<S::Reply, S::Refusal>, &'static str> {
        if let Some(done) = self.aside.as_ref().and_then(|aside| aside(self, &command, &from)) {
            return Ok(done);
        }
        let (to, answer) = sync_channel(1);
        let request = Request::Command { command, from, answer: Some(to) };
        self.commands.send(request).map_err(|_| "no_machine")?;
        answer.recv_timeout(ANSWER).map_err(|_| "no_answer")
    }

    /// Sends an event to those who want them. Who does not keep up is marked, and its reader ends the connection.
    pub fn tell_event(&self, event: &S::Event) {
        let members = lock(&self.members);
        if !members.values().any(|member| member.events) {
            return;
        }
        let line = line_of(event);
        members.values().filter(|member| member.events).for_each(|member| send(member, line.clone()));
    }

    /// Sends how things stand. It is left out where much waits already: the next one has it all.
    fn tell_status(&self) {
        let members = lock(&self.members);
        let takes = |member: &&Member| member.statuses && member.out.capacity() > MOST_WAITING / 2;
        if !members.values().any(|member| takes(&member)) {
            return;
        }
        let line = line_of(&json!({ "status": &*self.latest.get() }));
        members.values().filter(takes).for_each(|member| send(member, line.clone()));
    }

    /// Says who is in command, and who asks for it.
    fn tell_command(&self) {
        // As it stands while it is told: of two who tell it the later one tells the later state.
        let helm = lock(&self.helm);
        for (number, member) in lock(&self.members).iter().filter(|(_, member)| member.events) {
            send(member, command_event(&helm, *number));
        }
    }
}

fn command_event(helm: &Helm, number: u64) -> Line {
    let holder = helm.holder();
    line_of(&ConnectionEvent::Command { holder, you: holder == Some(number), asking: helm.asking() })
}

fn send(member: &Member, line: Line) {
    if let Err(mpsc::error::TrySendError::Full(_)) = member.out.try_send(line) {
        member.is_slow.store(true, Ordering::Relaxed);
    }
}

impl<S: Service> Drop for Connection<S> {
    fn drop(&mut self) {
        self.joined.ends.store(true, Ordering::Relaxed);
        self.release();
        self.joined.withdraw();
        self.give_command();
        // What it began ends before its rights do.
        if let Some(Beside { commands, thread }) = self.beside.take() {
            drop(commands);
            let _ = thread.join();
        }
        if let Some(command) = S::farewell() {
            self.joined.order(command);
        }
        lock(&self.joined.hub.members).remove(&self.joined.number);
    }
}

impl<S: Service> Connection<S> {
    /// Answers what comes until it ends. Says why it does.
    pub fn converse(mut self, incoming: &mut impl Incoming) -> &'static str {
        let out = self.joined.out.clone();
        let reason = loop {
            if self.joined.is_slow.load(Ordering::Relaxed) {
                break "too_slow";
            }
            if (self.joined.visitor.rights)().is_none() {
                break "logged_out";
            }
            // The next look would come too late.
            if !self.keys.is_empty() && incoming.heard().elapsed() + LOOK + RESERVE > DEAD_MAN {
                self.release();
            }
            match incoming.next() {
                Ok(Some(line)) => {
                    let (answer, then) = self.answer(&line);
                    if answer.is_some_and(|answer| out.try_send(line_of_answer(&answer)).is_err()) {
                        break "too_slow";
                    }
                    if let Some(then) = then {
                        let _ = out.try_send(then);
                    }
                }
                Ok(None) => {}
                Err(error) if error.kind() == ErrorKind::FileTooLarge => break "line_too_long",
                Err(error) if error.kind() == ErrorKind::TimedOut => break "too_slow",
                Err(_) => break "closed",
            }
        };
        drop(self);
        let _ = out.try_send(line_of(&json!({ "end": reason })));
        reason
    }

    /// Set where what waits is not taken.
    pub fn slow(&self) -> Arc<AtomicBool> {
        self.joined.is_slow.clone()
    }

    /// Lets all keys go.
    fn release(&mut self) {
        for key in std::mem::take(&mut self.keys) {
            self.joined.order(S::release(&key));
        }
    }

    /// Presses a key or lets it go. One that is pressed is noted before the machine has it: the dead man must know of it.
    fn put_key(&mut self, key: &str, down: bool, command: S::Command) -> Answer {
        let was_down = self.keys.iter().any(|own| own == key);
        if down && !was_down {
            if key.len() > LONGEST_KEY || self.keys.len() >= MOST_KEYS {
                return Err(error("busy", ""));
            }
            self.keys.push(key.to_owned());
        }
        let answer = self.joined.ask(command);
        let is_refused = answer.as_ref().is_err_and(|error| error.contains_key("refused"));
        if !down || is_refused && !was_down {
            self.keys.retain(|own| own != key);
        }
        answer
    }

    /// What it moves by hand comes to rest, since it commands no longer.
    fn abandon(&mut self) {
        self.release();
        if let Some(command) = S::abandoned() {
            self.joined.order(command);
        }
    }

    fn give_command(&mut self) {
        // Nobody else gives up this one's command; whoever takes it next comes behind all that ends with it.
        if lock(&self.joined.hub.helm).holder() == Some(self.joined.number) {
            self.abandon();
            self.joined.note_command(SessionNote::LeavesCommand);
            lock(&self.joined.hub.helm).leave();
            self.joined.hub.tell_command();
        }
    }

    fn hand_over(&mut self, to: u64) -> Result<(), &'static str> {
        // All that ends with this one's command stands in the machine's queue before the other may add to it. It is
        // only this thread that takes command from this connection, so that it is still in command then.
        if lock(&self.joined.hub.helm).may_answer(self.joined.number, to).is_ok() {
            self.abandon();
        }
        lock(&self.joined.hub.helm).hand_over(self.joined.number, to)?;
        self.joined.note_command(SessionNote::HandsOver { to });
        self.joined.hub.tell_command();
        Ok(())
    }

    /// The answer to a line, and what is told behind it; no answer yet where it takes long.
    fn answer(&mut self, line: &[u8]) -> (Option<Value>, Option<Line>) {
        let Ok(Value::Object(mut object)) = serde_json::from_slice::<Value>(line) else {
            return (Some(json!({ "id": null, "error": "no_object" })), None);
        };
        let id = object.remove("id").unwrap_or(Value::Null);
        if !matches!(id, Value::Null | Value::Number(_) | Value::String(_)) {
            return (Some(json!({ "id": null, "error": "bad_id" })), None);
        }
        let mut then = None;
        let answer = match self.own_command(&object, &mut then) {
            Some(answer) => Some(answer),
            None => self.request(&id, object),
        };
        (answer.map(|answer| with_id(answer, id)), then)
    }

    /// Commands of the connection itself.
    fn own_command(&mut self, object: &Map<String, Value>, then: &mut Option<Line>) -> Option<Answer> {
        let command = match ConnectionCommand::of(object)? {
            Ok(command) => command,
            Err(e) => return Some(Err(error("no_command", &e.to_string()))),
        };
        let joined = self.joined.clone();
        let (mut done, mut took) = (Ok(()), false);
        match command {
            ConnectionCommand::Alive => {}
            ConnectionCommand::Watch { events, status } => {
                if let Some(member) = lock(&joined.hub.members).get_mut(&joined.number) {
                    (member.events, member.statuses) = (events, status);
                }
                if events {
                    *then = Some(command_event(&lock(&joined.hub.helm), joined.number));
                }
            }
            ConnectionCommand::TakeCommand => match lock(&joined.hub.helm).take(joined.number) {
                Err(other) => return Some(Err(error("taken", &other.to_string()))),
                Ok(is_new) => took = is_new,
            },
            ConnectionCommand::GiveCommand => {
                self.release();
                self.give_command();
            }
            ConnectionCommand::AskForCommand => done = joined.ask_for_command(),
            ConnectionCommand::WithdrawRequest => joined.withdraw(),
            ConnectionCommand::HandOver { to } => done = self.hand_over(to),
            ConnectionCommand::Decline { to } => done = joined.decline(to),
        }
        if took {
            joined.note_command(SessionNote::TakesCommand);
            joined.hub.tell_command();
        }
        Some(done.map(|()| Value::Null).map_err(|code| error(code, "")))
    }

    /// Has a command of the machine done; no answer yet where that takes long.
    fn request(&mut self, id: &Value, object: Map<String, Value>) -> Option<Answer> {
        let command: S::Command = match serde_json::from_value(Value::Object(object)) {
            Ok(command) => command,
            Err(e) => return Some(Err(error("no_command", &e.to_string()))),
        };
        if let Err(error) = self.joined.may(&command) {
            return Some(Err(error));
        }
        if S::takes_long(&command) {
            return self.put_beside(id.clone(), command).err().map(Err);
        }
        Some(match S::key(&command).map(|(key, down)| (key.to_owned(), down)) {
            Some((key, down)) => self.put_key(&key, down, command),
            None => self.joined.ask(command),
        })
    }

    /// Has a command done that takes long, on the thread for these: `busy` where too many wait.
    fn put_beside(&mut self, id: Value, command: S::Command) -> Result<(), Map<String, Value>> {
        let busy = || error("busy", "");
        if self.beside.is_none() {
            let (commands, waiting) = sync_channel(MOST_LONG);
            let joined = self.joined.clone();
            let thread = std::thread::Builder::new()
                .name("long commands".to_owned())
                .spawn(move || joined.do_long(&waiting))
                .map_err(|_| busy())?;
            self.beside = Some(Beside { commands, thread });
        }
        let sent = self.beside.as_ref().map(|beside| beside.commands.try_send((id, command)));
        if sent.is_some_and(|sent| sent.is_ok()) { Ok(()) } else { Err(busy()) }
    }
}

impl<S: Service> Joined<S> {
    fn caller(&self) -> Caller {
        let name = match self.visitor.from.as_str() {
            "" => format!("connection {}", self.number),
            from => format!("connection {} from {from}", self.number),
        };
        let session = (self.visitor.rights)().unwrap_or(Session::OPERATOR);
        Caller { name, seat: self.visitor.seat, session }
    }

    /// Gives a command that nobody waits for.
    fn order(&self, command: S::Command) {
        let _ = self.hub.commands.send(Request::Command { command, from: self.caller(), answer: None });
    }

    /// Has it noted who commands, or what he asked came to.
    fn note_command(&self, note: SessionNote) {
        let from = self.caller();
        let _ = self
            .hub
            .commands
            .send(Request::Look(Box::new(move |service: &mut S| service.commanded(&from, note))));
    }

    fn person(&self) -> Person {
        match self.visitor.owner {
            0 => Person::Connection(self.number),
            owner => Person::Session(owner),
        }
    }

    fn ask_for_command(&self) -> Result<(), &'static str> {
        let level = (self.visitor.rights)().unwrap_or(Session::OPERATOR).level().number();
        let asking = Asking { connection: self.number, from: self.visitor.from.clone(), level };
        if lock(&self.hub.helm).ask(self.person(), asking, Instant::now())? {
            self.note_command(SessionNote::AsksForCommand);
            self.hub.tell_command();
        }
        Ok(())
    }

    fn withdraw(&self) {
        if lock(&self.hub.helm).settle(self.number, Instant::now()) {
            self.note_command(SessionNote::WithdrawsRequest);
            self.hub.tell_command();
        }
    }

    fn decline(&self, to: u64) -> Result<(), &'static str> {
        lock(&self.hub.helm).decline(self.number, to, Instant::now())?;
        self.note_command(SessionNote::Declines { to });
        if let Some(member) = lock(&self.hub.members).get(&to).filter(|member| member.events) {
            send(member, line_of(&ConnectionEvent::Declined { by: self.number }));
        }
        self.hub.tell_command();
        Ok(())
    }

    /// Whether it may give a command now.
    fn may(&self, command: &S::Command) -> Result<(), Map<String, Value>> {
        match S::need(command) == Need::Command && lock(&self.hub.helm).holder() != Some(self.number) {
            true => Err(error("not_in_command", "")),
            false => Ok(()),
        }
    }

    fn ask(&self, command: S::Command) -> Answer {
        match self.hub.ask(command, self.caller()) {
            Ok(Ok(reply)) => Ok(serde_json::to_value(&reply).unwrap_or_default()),
            Ok(Err(refusal)) => {
                let mut map = Map::new();
                map.insert("refused".to_owned(), serde_json::to_value(&refusal).unwrap_or_default());
                Err(map)
            }
            Err(code) => Err(error(code, "")),
        }
    }

    /// Does what takes long until the connection ends. Command may have gone meanwhile.
    fn do_long(&self, waiting: &Receiver<(Value, S::Command)>) {
        while let Ok((id, command)) = waiting.recv() {
            if self.ends.load(Ordering::Relaxed) {
                return;
            }
            let answer = self.may(&command).map_or_else(Err, |()| self.ask(command));
            if self.out.try_send(line_of_answer(&with_id(answer, id))).is_err() {
                self.is_slow.store(true, Ordering::Relaxed);
            }
        }
    }
}

/// An answer as it is sent.
fn with_id(answer: Answer, id: Value) -> Value {
    let mut fields = match answer {
        Ok(Value::Object(reply)) => reply,
        Ok(_) => Map::from_iter([("reply".to_owned(), json!("done"))]),
        Err(error) => error,
    };
    fields.insert("id".to_owned(), id);
    Value::Object(fields)
}

/// An answer as a line; one that is longer than a line may be says so.
fn line_of_answer(answer: &Value) -> Line {
    let line = line_of(answer);
    match line.len() <= LONGEST_LINE {
        true => line,
        false => {
            let id = answer.get("id").cloned().unwrap_or(Value::Null);
            line_of(&with_id(Err(error("too_large", &line.len().to_string())), id))
        }
    }
}

/// A reply, or what stands in its place.
type Answer = Result<Value, Map<String, Value>>;

fn error(code: &str, detail: &str) -> Map<String, Value> {
    let mut map = Map::new();
    map.insert("error".to_owned(), json!(code));
    if !detail.is_empty() {
        map.insert("detail".to_owned(), json!(detail));
    }
    map
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_answer_that_is_longer_than_a_line_says_so() {
        let answer = |length: usize| {
            let text = "x".repeat(length);
            line_of_answer(&with_id(Ok(json!({ "reply": "program", "text": text })), json!(7)))
        };
        assert!(answer(1000).contains("xxx"));
        let told: Value = serde_json::from_str(&answer(LONGEST_LINE)).unwrap();
        assert_eq!((&told["error"], &told["id"]), (&json!("too_large"), &json!(7)));
    }
}
