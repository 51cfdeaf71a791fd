//! The WebSocket: the JSON lines of [`crate::hub`], a text message each.
//!
//! Each socket has a thread of its own that answers, as a connection of JSON lines has; tasks carry messages there and
//! back. A page that is closed, asleep or gone is noticed by the dead man's key and by the hub, as any connection.

use super::Shared;
use super::listen::Peer;
use super::problem::Problem;
use super::session::{Entry, seat_of, told};
use crate::hub::{Incoming, LONGEST_LINE, LOOK, Line, MOST_CONNECTIONS, Visitor, line_of};
use crate::told::PanelInfo;
use axum::Router;
use axum::extract::ws::{Message, WebSocket, WebSocketUpgrade};
use axum::extract::{Extension, State};
use axum::response::Response;
use axum::routing::get;
use ferrocut_machine::Language;
use ferrocut_memory::Session;
use futures_util::stream::{SplitSink, SplitStream};
use futures_util::{SinkExt, StreamExt};
use serde_json::json;
use std::io::{self, ErrorKind};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender, TrySendError, sync_channel};
use std::time::{Duration, Instant};
use tokio::sync::mpsc;
use tokio::time::{MissedTickBehavior, interval, sleep, timeout};

/// How long a message may take to be taken.
const WRITE: Duration = Duration::from_secs(2);

/// Time between two signs of life that are asked of a browser, and how long none may come.
const PING: Duration = Duration::from_secs(10);
const SILENCE: Duration = Duration::from_secs(35);

/// Messages that wait to be answered.
const MOST_UNANSWERED: usize = 4;

/// Time until a message that found no room is tried again.
const AGAIN: Duration = Duration::from_millis(2);

pub(super) fn routes() -> Router<Arc<Shared>> {
    Router::new().route("/api/socket", get(open))
}

async fn open(
    State(shared): State<Arc<Shared>>,
    Extension(peer): Extension<Peer>,
    entry: Option<Extension<Arc<Entry>>>,
    upgrade: WebSocketUpgrade,
) -> Result<Response, Problem> {
    if shared.hub.connections() >= MOST_CONNECTIONS {
        return Err(Problem::Busy);
    }
    let entry = entry.map(|Extension(entry)| entry);
    Ok(upgrade
        .max_message_size(LONGEST_LINE)
        .max_frame_size(LONGEST_LINE)
        .write_buffer_size(0)
        .max_write_buffer_size(LONGEST_LINE + (1 << 20))
        .on_upgrade(move |socket| run(socket, shared, peer, entry)))
}

/// Who a socket is.
fn visitor(shared: &Arc<Shared>, peer: Peer, entry: Option<Arc<Entry>>) -> Visitor {
    let languages = Language::ALL.into_iter().map(Language::tag).collect();
    let panel = Some(PanelInfo { ladder: shared.has_ladder, languages });
    let session = Some(told(&shared.sessions, entry.as_ref()));
    let owner = entry.as_ref().map_or(0, |entry| entry.number);
    let needs_log_in = shared.sessions.needs_log_in();
    Visitor {
        from: peer.0.ip().to_string(),
        seat: seat_of(peer),
        rights: Arc::new(move || match &entry {
            Some(entry) => entry.rights(),
            None => (!needs_log_in).then_some(Session::OPERATOR),
        }),
        panel,
        session,
        owner,
    }
}

async fn run(socket: WebSocket, shared: Arc<Shared>, peer: Peer, entry: Option<Arc<Entry>>) {
    let (mut sink, stream) = socket.split();
    let Some((connection, waiting)) = shared.hub.join(visitor(&shared, peer, entry.clone())) else {
        let full = line_of(&json!({ "end": "too_many_connections" }));
        let _ = timeout(WRITE, sink.send(text(&full))).await;
        let _ = timeout(WRITE, sink.close()).await;
        return;
    };
    let slow = connection.slow();
    let (to, from) = sync_channel(MOST_UNANSWERED);
    let mut messages = Messages { from, heard: Instant::now() };
    let thread = std::thread::Builder::new().name("panel".to_owned());
    // A socket that finds no thread is ended by being dropped.
    if thread.spawn(move || connection.converse(&mut messages)).is_err() {
        return;
    }
    let mut stops = shared.stops.clone();
    let writer = write(sink, waiting, slow);
    let reader = read(stream, to, entry);
    tokio::pin!(writer, reader);
    tokio::select! {
        _ = &mut writer => {}
        // Nothing comes any more; what waits is for nobody.
        () = &mut reader => {}
        _ = stops.changed() => {}
    }
}

fn text(line: &Line) -> Message {
    Message::Text((&**line).into())
}

/// Carries messages to the thread that answers them, until none comes.
async fn read(
    mut stream: SplitStream<WebSocket>,
    to: SyncSender<(Instant, Vec<u8>)>,
    entry: Option<Arc<Entry>>,
) {
    while let Ok(Some(Ok(message))) = timeout(SILENCE, stream.next()).await {
        let mut next = match message {
            Message::Text(text) => (Instant::now(), text.as_bytes().to_vec()),
            Message::Binary(bytes) => (Instant::now(), bytes.to_vec()),
            // The browser answers these by itself, also for a page that hangs.
            Message::Ping(_) | Message::Pong(_) => {
                if let Some(entry) = &entry {
                    entry.touch();
                }
                continue;
            }
            Message::Close(_) => return,
        };
        loop {
            match to.try_send(next) {
                Ok(()) => break,
                Err(TrySendError::Full(again)) => {
                    next = again;
                    sleep(AGAIN).await;
                }
                Err(TrySendError::Disconnected(_)) => return std::future::pending().await,
            }
        }
    }
}

/// Writes what waits, until nobody can add to it. A write that takes too long ends the socket.
async fn write(
    mut sink: SplitSink<WebSocket, Message>,
    mut waiting: mpsc::Receiver<Line>,
    slow: Arc<AtomicBool>,
) {
    let mut ping = interval(PING);
    ping.set_missed_tick_behavior(MissedTickBehavior::Delay);
    loop {
        let message = tokio::select! {
            line = waiting.recv() => match line {
                Some(line) => text(&line),
                None => break,
            },
            _ = ping.tick() => Message::Ping(Default::default()),
        };
        if !matches!(timeout(WRITE, sink.send(message)).await, Ok(Ok(()))) {
            slow.store(true, Ordering::Relaxed);
            return;
        }
    }
    let _ = timeout(WRITE, sink.close()).await;
}

/// Messages as lines for the thread that answers them.
struct Messages {
    from: Receiver<(Instant, Vec<u8>)>,
    heard: Instant,
}

impl Incoming for Messages {
    fn next(&mut self) -> io::Result<Option<Vec<u8>>> {
        match self.from.recv_timeout(LOOK) {
            Ok((heard, line)) => {
                self.heard = heard;
                Ok(Some(line))
            }
            Err(RecvTimeoutError::Timeout) => Ok(None),
            Err(RecvTimeoutError::Disconnected) => Err(io::Error::from(ErrorKind::UnexpectedEof)),
        }
    }

    fn heard(&self) -> Instant {
        self.heard
    }
}
