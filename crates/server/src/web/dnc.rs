//! A file for DNC (GSK990MC part 2, 11.3): laid down here as a whole, then given to the control while it runs, whoever
//! is connected. A page that is closed or loaded anew does not stop it.

use super::Shared;
use super::body::read_into_file;
use super::listen::Peer;
use super::problem::Problem;
use super::session::{Entry, panel_at, seat_of};
use crate::hub::{Hub, lock};
use crate::panel::Panel;
use crate::service::{Caller, Service};
use axum::extract::{Path, Request, State};
use axum::routing::{get, put};
use axum::{Json, Router};
use ferrocut_controller::api::{Command, DncStatus, Refusal};
use ferrocut_machine::{Alarm, AlarmId, Fault};
use ferrocut_program::{Decoder, OpenError, Span, Text};
use serde::Serialize;
use std::path::PathBuf;
use std::sync::{Arc, Mutex};
use std::time::Duration;
use tokio::sync::Semaphore;

/// Longest file, bytes.
const LONGEST: usize = 1 << 30;

/// Longest name that is shown.
const LONGEST_NAME: usize = 255;

/// Bytes that the control is given at a time.
const PIECE: usize = 128 << 10;

/// Time until it is asked again whether it has room: it has a megabyte to run meanwhile.
const AGAIN: Duration = Duration::from_millis(50);

/// One file comes at a time.
static TURN: Semaphore = Semaphore::const_new(1);

pub(super) fn routes() -> Router<Arc<Shared>> {
    Router::new().route("/api/dnc", get(told).delete(stop)).route("/api/dnc/{name}", put(begin))
}

/// A file for DNC.
#[derive(Clone, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(super) struct DncFile {
    /// What it is called where it came from.
    name: String,
    bytes: u64,
    /// Bytes of it that the control has.
    sent: u64,
    /// Whether the control is still given the rest.
    sending: bool,
    /// Why it is not.
    refused: Option<Refusal>,
}

impl DncFile {
    /// The control was given a part, and has `sent` bytes. It may have been stopped meanwhile.
    fn note(&mut self, given: Given, sent: u64, is_over: bool) {
        self.sent = sent;
        match given {
            Given::Taken => self.sending &= !is_over,
            Given::Full => {}
            Given::Foreign | Given::NoMachine => self.sending = false,
            Given::Refused(refusal) => (self.sending, self.refused) = (false, Some(refusal)),
        }
    }
}

/// The file that came last.
pub(super) type Current = Mutex<Option<Arc<Mutex<DncFile>>>>;

async fn told(State(shared): State<Arc<Shared>>) -> Json<Option<DncFile>> {
    let current = lock(&shared.dnc);
    Json(current.as_ref().map(|file| lock(file).clone()))
}

/// The control is given no more of it.
async fn stop(State(shared): State<Arc<Shared>>, request: Request) -> Result<Json<Option<DncFile>>, Problem> {
    let entry = request.extensions().get::<Arc<Entry>>().ok_or(Problem::Command)?;
    if !shared.hub.commands(entry.number) {
        return Err(Problem::Command);
    }
    if let Some(file) = lock(&shared.dnc).as_ref() {
        lock(file).sending = false;
    }
    Ok(told(State(shared)).await)
}

/// Takes a file, gives the control its beginning, and goes on beside; for the browser whose socket is in command.
async fn begin(
    State(shared): State<Arc<Shared>>,
    Path(name): Path<String>,
    request: Request,
) -> Result<Json<DncFile>, Problem> {
    if name.len() > LONGEST_NAME {
        return Err(Problem::Missing);
    }
    let entry = request.extensions().get::<Arc<Entry>>().cloned().ok_or(Problem::Command)?;
    let peer = request.extensions().get::<Peer>().copied().ok_or(Problem::Command)?;
    if !shared.hub.commands(entry.number) {
        return Err(Problem::Command);
    }
    let _turn = TURN.try_acquire().map_err(|_| Problem::Busy)?;
    let part = part_of(&shared);
    let come = read_into_file(request, LONGEST, &part).await;
    let opened = come.and_then(|()| Text::open(&part).map_err(|error| not_text(&error)));
    // It stays as long as it is open, and is gone with the process.
    let _ = std::fs::remove_file(&part);
    let text = opened?;
    let session = entry.rights().ok_or(Problem::LogIn)?;
    let from = Caller { name: panel_at(peer), seat: seat_of(peer), session };
    let begin = move || {
        // Command may have been given away while it came.
        if !shared.hub.commands(entry.number) {
            return Err(Problem::Command);
        }
        let bytes = text.len();
        let mut feed = Feed::new(text, from);
        // What the control has room for, so that a short one is whole at cycle start.
        while !feed.is_over() {
            match feed.give(&shared.hub) {
                Given::Taken => {}
                Given::Full => break,
                Given::Refused(refusal) => return Err(Problem::from(refusal)),
                Given::Foreign => return Err(Problem::Busy),
                Given::NoMachine => return Err(Problem::NoMachine("no_answer")),
            }
        }
        let file = DncFile { name, bytes, sent: feed.given, sending: !feed.is_over(), refused: None };
        let told = Arc::new(Mutex::new(file.clone()));
        *lock(&shared.dnc) = Some(told.clone());
        if file.sending {
            let run = move || feed.run(&shared, &told);
            let thread = std::thread::Builder::new().name("dnc".to_owned());
            thread.spawn(run).map_err(|error| Problem::of_file(&error))?;
        }
        Ok(Json(file))
    };
    tokio::task::spawn_blocking(begin).await.map_err(|_| Problem::Busy)?
}

/// Where a file comes to lie until it is opened.
fn part_of(shared: &Shared) -> PathBuf {
    match shared.store.as_ref().and_then(|store| store.folder()) {
        Some(folder) => folder.join("dnc.part"),
        None => std::env::temp_dir().join(format!("ferrocut-dnc-{}.part", std::process::id())),
    }
}

fn not_text(error: &OpenError) -> Problem {
    match error {
        OpenError::Io(error) => Problem::of_file(error),
        _ => Problem::Unreadable("not_text".to_owned()),
    }
}

/// What became of a part.
enum Given {
    Taken,
    /// There is no room for it yet.
    Full,
    /// The control has another program than this by now, or gave it up.
    Foreign,
    Refused(Refusal),
    NoMachine,
}

/// A file on its way into the control.
struct Feed {
    text: Text,
    from: Caller,
    decoder: Decoder,
    /// Offset behind what the control has.
    given: u64,
    /// The next part, the offset behind it, and what the control had before it.
    part: String,
    read: u64,
    before: Option<DncStatus>,
    buffer: Vec<u8>,
}

impl Feed {
    fn new(text: Text, from: Caller) -> Feed {
        let encoding = text.encoding();
        let given = encoding.mark as u64;
        let decoder = encoding.decoder();
        Feed {
            text,
            from,
            decoder,
            given,
            part: String::new(),
            read: given,
            before: None,
            buffer: Vec::new(),
        }
    }

    fn is_over(&self) -> bool {
        self.given >= self.text.len()
    }

    /// Reads the next part, unless there is one that has found no room.
    fn prepare(&mut self) -> std::io::Result<()> {
        if self.read > self.given {
            return Ok(());
        }
        let (at, whole, decoder) = (self.read, self.text.len(), &mut self.decoder);
        let decode = |bytes: &[u8]| {
            let behind = at + bytes.len() as u64;
            (decoder.decode(bytes, behind >= whole), behind)
        };
        (self.part, self.read) = self.text.window(at, PIECE, &mut self.buffer, decode)?;
        // The file is this process's own: it does not become shorter.
        if self.read == at { Err(std::io::ErrorKind::UnexpectedEof.into()) } else { Ok(()) }
    }

    /// Gives the control a part, where it has what came before: another may have begun a program since.
    fn give(&mut self, hub: &Hub<Panel>) -> Given {
        if let Err(error) = self.prepare() {
            let alarm = Alarm::core(Fault::FileUnreadable, Span::default());
            return Given::Refused(Refusal::from(alarm.with("reason", error.to_string())));
        }
        let last = self.read >= self.text.len();
        let (text, before, from) = (self.part.clone(), self.before.clone(), self.from.clone());
        let first = before.is_none();
        let look = move |panel: &mut Panel| {
            if before.is_some_and(|before| panel.control().dnc_status() != Some(before)) {
                return (Given::Foreign, None);
            }
            match panel.command(Command::Dnc { text, first, last }, &from) {
                Ok(_) => (Given::Taken, panel.control().dnc_status()),
                Err(refusal) if refusal.alarm.id == AlarmId::Core(Fault::NoRoomYet).to_string() => {
                    (Given::Full, None)
                }
                Err(refusal) => (Given::Refused(refusal), None),
            }
        };
        let Some((given, now)) = hub.look(look) else { return Given::NoMachine };
        if matches!(given, Given::Taken) {
            (self.given, self.before) = (self.read, now);
        }
        given
    }

    /// Gives the rest, until it is over, nobody wants it any more, or the server ends.
    fn run(mut self, shared: &Shared, told: &Mutex<DncFile>) {
        while lock(told).sending && !*shared.stops.borrow() {
            let given = self.give(&shared.hub);
            let is_full = matches!(given, Given::Full);
            lock(told).note(given, self.given, self.is_over());
            if is_full {
                std::thread::sleep(AGAIN);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_that_was_stopped_stays_stopped() {
        for (sending, is_over, goes_on) in [(true, false, true), (true, true, false), (false, false, false)] {
            let mut file = DncFile { name: "A.NC".to_owned(), bytes: 9, sent: 0, sending, refused: None };
            file.note(Given::Taken, 5, is_over);
            assert_eq!((file.sent, file.sending), (5, goes_on), "{sending} {is_over}");
        }
    }
}
