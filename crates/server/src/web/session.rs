//! Sessions: who asks, by a cookie that only his browser has.
//!
//! On this computer everybody is an operator without asking, and a session only tells which socket and which requests
//! are of one browser. From elsewhere nobody may do anything before he has logged in. Rights are those of the control:
//! the passwords, the waits after wrong ones and the log of log-ins are the durable memory's.

use super::Shared;
use super::body::read;
use super::listen::Peer;
use super::problem::Problem;
use crate::hub::lock;
use crate::told::SessionInfo;
use axum::extract::{Request, State};
use axum::http::header::{COOKIE, SET_COOKIE};
use axum::http::{HeaderMap, HeaderValue};
use axum::response::{IntoResponse, Response};
use axum::routing::get;
use axum::{Json, Router};
use base64::Engine;
use base64::prelude::BASE64_URL_SAFE_NO_PAD;
use ferrocut_machine::{Alarm, Fault};
use ferrocut_memory::{Author, Change, Level, Seat, Session, SessionNote};
use ferrocut_program::Span;
use governor::clock::DefaultClock;
use governor::state::keyed::HashMapStateStore;
use governor::{Quota, RateLimiter};
use serde::Deserialize;
use sha2::{Digest, Sha256};
use std::collections::HashMap;
use std::net::IpAddr;
use std::num::NonZeroU32;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

/// Sessions at once; the one that was idle longest goes.
const MOST_SESSIONS: usize = 256;

/// How long a session lives that nobody uses.
const IDLE: Duration = Duration::from_secs(12 * 3600);

/// Tries to log in that one address has at once, and how long until it has another.
const TRIES: NonZeroU32 = NonZeroU32::MIN.saturating_add(4);
const NEXT_TRY: Duration = Duration::from_secs(2);

/// Addresses whose tries are counted before those are forgotten that have waited long enough.
const MANY_ADDRESSES: usize = 1024;

/// Bytes of a log-in.
const LONGEST_LOG_IN: usize = 4096;

/// Random bytes of a token.
const TOKEN: usize = 32;

/// What is kept of a token: whoever sees it cannot make the cookie of it.
type Hash = [u8; 32];

/// A session.
pub(crate) struct Entry {
    /// Tells it from all others.
    pub number: u64,
    /// What its owner may; none where he must log in first, or has logged out.
    rights: Mutex<Option<Session>>,
    used: Mutex<Instant>,
}

impl Entry {
    /// What its owner may.
    pub fn rights(&self) -> Option<Session> {
        lock(&self.rights).clone()
    }

    /// The level as the panel shows it: 1 to 4, 0 for an operator or nobody.
    pub fn level(&self) -> u8 {
        self.rights().map_or(0, |session| shown(&session))
    }

    /// Keeps it from being forgotten.
    pub fn touch(&self) {
        *lock(&self.used) = Instant::now();
    }
}

fn shown(session: &Session) -> u8 {
    match session.level() {
        Level::Operator => 0,
        level => level.number(),
    }
}

/// All sessions.
pub(crate) struct Sessions {
    all: Mutex<HashMap<Hash, Arc<Entry>>>,
    tries: RateLimiter<IpAddr, HashMapStateStore<IpAddr>, DefaultClock>,
    next: AtomicU64,
    needs_log_in: bool,
    is_encrypted: bool,
}

impl Sessions {
    pub fn new(needs_log_in: bool, is_encrypted: bool) -> Sessions {
        let quota = Quota::with_period(NEXT_TRY).unwrap_or(Quota::per_minute(TRIES)).allow_burst(TRIES);
        Sessions {
            all: Mutex::default(),
            tries: RateLimiter::hashmap(quota),
            next: AtomicU64::new(1),
            needs_log_in,
            is_encrypted,
        }
    }

    /// Whether nobody may do anything before he has logged in.
    pub fn needs_log_in(&self) -> bool {
        self.needs_log_in
    }

    /// The rights of who has not logged in.
    fn at_first(&self) -> Option<Session> {
        (!self.needs_log_in).then_some(Session::OPERATOR)
    }

    /// The session of a token.
    pub fn find(&self, token: &[u8]) -> Option<Arc<Entry>> {
        let entry = lock(&self.all).get(&hash(token))?.clone();
        if lock(&entry.used).elapsed() > IDLE {
            return None;
        }
        entry.touch();
        Some(entry)
    }

    /// Begins a session, with the cookie that makes a browser know it. None where the system has no random numbers.
    pub fn begin(&self) -> Option<(Arc<Entry>, HeaderValue)> {
        let entry = Arc::new(Entry {
            number: self.next.fetch_add(1, Ordering::Relaxed),
            rights: Mutex::new(self.at_first()),
            used: Mutex::new(Instant::now()),
        });
        let cookie = self.admit(&entry)?;
        Some((entry, cookie))
    }

    /// Gives a session a token, new for one that had another.
    fn admit(&self, entry: &Arc<Entry>) -> Option<HeaderValue> {
        let mut token = [0; TOKEN];
        getrandom::fill(&mut token).ok()?;
        let mut all = lock(&self.all);
        all.retain(|_, other| other.number != entry.number && lock(&other.used).elapsed() <= IDLE);
        if all.len() >= MOST_SESSIONS {
            // Those who have logged in are the last to go.
            let oldest =
                all.iter().max_by_key(|(_, other)| (other.level() == 0, lock(&other.used).elapsed()));
            if let Some(oldest) = oldest.map(|(hash, _)| *hash) {
                all.remove(&oldest);
            }
        }
        all.insert(hash(&token), entry.clone());
        self.cookie(&BASE64_URL_SAFE_NO_PAD.encode(token), IDLE)
    }

    /// A cookie that scripts do not see and no other site's page sends.
    fn cookie(&self, value: &str, age: Duration) -> Option<HeaderValue> {
        let (name, secure) = if self.is_encrypted { (SECURE_COOKIE, "; Secure") } else { (PLAIN_COOKIE, "") };
        let age = age.as_secs();
        let text = format!("{name}={value}; Path=/; HttpOnly; SameSite=Strict; Max-Age={age}{secure}");
        HeaderValue::from_str(&text).ok()
    }

    /// Ends a session: its sockets end with it where a log-in is needed.
    fn end(&self, entry: &Arc<Entry>) {
        *lock(&entry.rights) = self.at_first();
        lock(&self.all).retain(|_, other| other.number != entry.number);
    }

    /// Whether an address may try to log in now.
    fn may_try(&self, address: IpAddr) -> bool {
        if self.tries.len() > MANY_ADDRESSES {
            self.tries.retain_recent();
        }
        self.tries.check_key(&address).is_ok()
    }
}

fn hash(token: &[u8]) -> Hash {
    Sha256::digest(token).into()
}

const PLAIN_COOKIE: &str = "ferrocut";
/// Browsers take this name only over an encrypted connection, and from this host alone.
const SECURE_COOKIE: &str = "__Host-ferrocut";

/// The token that a request carries.
pub(super) fn token_of(headers: &HeaderMap) -> Option<Vec<u8>> {
    let cookies = headers.get_all(COOKIE).iter().filter_map(|value| value.to_str().ok());
    let mut tokens = cookies.flat_map(|value| value.split(';')).filter_map(|cookie| {
        let (name, value) = cookie.trim().split_once('=')?;
        let value = value.trim();
        matches!(name, PLAIN_COOKIE | SECURE_COOKIE).then_some(value).filter(|value| value.len() <= 64)
    });
    tokens.find_map(|value| BASE64_URL_SAFE_NO_PAD.decode(value).ok().filter(|token| token.len() == TOKEN))
}

/// The session as it is told.
pub(super) fn told(sessions: &Sessions, entry: Option<&Arc<Entry>>) -> SessionInfo {
    SessionInfo { level: entry.map_or(0, |entry| entry.level()), needs_log_in: sessions.needs_log_in() }
}

pub(super) fn routes() -> Router<Arc<Shared>> {
    Router::new().route("/api/session", get(read_session).post(log_in).delete(log_out))
}

fn with_cookie(body: SessionInfo, cookie: Option<HeaderValue>) -> Response {
    let mut response = Json(body).into_response();
    if let Some(cookie) = cookie {
        response.headers_mut().append(SET_COOKIE, cookie);
    }
    response
}

async fn read_session(State(shared): State<Arc<Shared>>, request: Request) -> Response {
    let sessions = &shared.sessions;
    let entry = request.extensions().get::<Arc<Entry>>().cloned();
    // Who must log in has a session from then on.
    let fresh = (entry.is_none() && !sessions.needs_log_in()).then(|| sessions.begin()).flatten();
    let (entry, cookie) = fresh.map_or((entry, None), |(entry, cookie)| (Some(entry), Some(cookie)));
    with_cookie(told(sessions, entry.as_ref()), cookie)
}

#[derive(Deserialize)]
struct LogIn {
    level: u8,
    password: String,
}

async fn log_in(State(shared): State<Arc<Shared>>, request: Request) -> Result<Response, Problem> {
    let peer = request.extensions().get::<Peer>().copied().ok_or(Problem::LogIn)?;
    if !shared.sessions.may_try(peer.0.ip()) {
        return Err(Problem::TooOften);
    }
    let entry = request.extensions().get::<Arc<Entry>>().cloned();
    let body = read(request, LONGEST_LOG_IN).await?;
    let given: LogIn =
        serde_json::from_slice(&body).map_err(|error| Problem::Unreadable(error.to_string()))?;
    let level = Level::of(given.level.into()).filter(|level| *level != Level::Operator).ok_or_else(|| {
        Alarm::core(Fault::ValueImpossible, Span::default()).with("name", given.level.to_string())
    })?;
    let store = shared.store.clone();
    let store = store.ok_or_else(|| Alarm::core(Fault::NotFitted, Span::default()).with("name", "memory"))?;
    let seat = seat_of(peer);
    let who = panel_at(peer);
    let found = tokio::task::spawn_blocking(move || store.log_in(level, &given.password, seat, &who)).await;
    let session = found.map_err(|_| Problem::Busy)?.map_err(|error| error.alarm())?;
    let sessions = &shared.sessions;
    let begun = match entry {
        // A new token: one that somebody had put into the browser before is worth nothing.
        Some(entry) => sessions.admit(&entry).map(|cookie| (entry, cookie)),
        None => sessions.begin(),
    };
    let (entry, cookie) = begun.ok_or(Problem::Busy)?;
    *lock(&entry.rights) = Some(session);
    Ok(with_cookie(told(sessions, Some(&entry)), Some(cookie)))
}

async fn log_out(State(shared): State<Arc<Shared>>, request: Request) -> Response {
    let sessions = &shared.sessions;
    if let Some(entry) = request.extensions().get::<Arc<Entry>>() {
        let session = lock(&entry.rights).clone();
        sessions.end(entry);
        if let (Some(session), Some(store), Some(peer)) =
            (session, shared.store.clone(), request.extensions().get::<Peer>())
        {
            let author = Author::Person { session, name: panel_at(*peer) };
            // Who logs out waits for no disk.
            drop(tokio::task::spawn_blocking(move || {
                store.put(&author, vec![Change::Session(SessionNote::LogsOut)])
            }));
        }
    }
    with_cookie(told(sessions, None), sessions.cookie("", Duration::ZERO))
}

/// How the log names whoever is at a panel.
pub(super) fn panel_at(peer: Peer) -> String {
    format!("panel from {}", peer.0.ip())
}

/// Where somebody gives passwords.
pub(super) fn seat_of(peer: Peer) -> Seat {
    if peer.0.ip().to_canonical().is_loopback() { Seat::Machine } else { Seat::Network }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn heads(cookie: &HeaderValue) -> HeaderMap {
        let value = cookie.to_str().unwrap().split(';').next().unwrap().to_owned();
        HeaderMap::from_iter([(COOKIE, HeaderValue::from_str(&format!("a=b; {value}")).unwrap())])
    }

    #[test]
    fn a_session_is_known_by_its_cookie_until_it_ends() {
        let sessions = Sessions::new(false, false);
        let (entry, cookie) = sessions.begin().unwrap();
        let text = cookie.to_str().unwrap();
        assert!(text.contains("HttpOnly") && text.contains("SameSite=Strict") && !text.contains("Secure"));
        let find = || sessions.find(&token_of(&heads(&cookie)).unwrap());
        assert_eq!(find().unwrap().number, entry.number);
        assert!(sessions.find(&[0; TOKEN]).is_none());
        // A new token takes the place of the old one.
        let next = sessions.admit(&entry).unwrap();
        assert!(find().is_none() && sessions.find(&token_of(&heads(&next)).unwrap()).is_some());
        sessions.end(&entry);
        assert!(sessions.find(&token_of(&heads(&next)).unwrap()).is_none());
    }

    #[test]
    fn a_remote_session_has_no_rights_before_the_log_in_and_its_cookie_is_secure() {
        let sessions = Sessions::new(true, true);
        let (entry, cookie) = sessions.begin().unwrap();
        assert!(entry.rights().is_none());
        assert!(
            cookie.to_str().unwrap().starts_with("__Host-ferrocut=")
                && cookie.to_str().unwrap().contains("; Secure")
        );
    }

    #[test]
    fn sessions_are_bounded() {
        let sessions = Sessions::new(false, false);
        (0..MOST_SESSIONS + 50).for_each(|_| drop(sessions.begin()));
        assert_eq!(lock(&sessions.all).len(), MOST_SESSIONS);
    }

    #[test]
    fn tries_are_rationed_by_address() {
        let sessions = Sessions::new(true, true);
        let address = IpAddr::from([10, 0, 0, 1]);
        let allowed = (0..20).filter(|_| sessions.may_try(address)).count();
        assert_eq!(allowed, TRIES.get() as usize);
        assert!(sessions.may_try(IpAddr::from([10, 0, 0, 2])));
    }
}
