//! Backups that lie in the folder of the memory, and those that take one away or bring one (GSK990MC operation 3.4.4).

use super::Shared;
use super::body::read_into_file;
use super::listen::Peer;
use super::problem::Problem;
use super::session::{Entry, panel_at, seat_of};
use super::work::work;
use crate::service::Caller;
use axum::body::{Body, Bytes};
use axum::extract::{Path, Request, State};
use axum::http::HeaderValue;
use axum::http::header::{CONTENT_DISPOSITION, CONTENT_LENGTH, CONTENT_TYPE};
use axum::response::{IntoResponse, Response};
use axum::routing::get;
use axum::{Json, Router};
use ferrocut_controller::api::Event;
use ferrocut_controller::control::{BACKUPS, backup_in};
use ferrocut_machine::{Alarm, Fault};
use ferrocut_memory::rights::CARRIES_BACKUPS;
use ferrocut_memory::{Level, Session, Store};
use ferrocut_program::Span;
use futures_util::stream::try_unfold;
use serde::Serialize;
use std::fs::{self, File, Metadata};
use std::io::{self, Read};
use std::sync::Arc;
use std::time::UNIX_EPOCH;
use tokio::sync::Semaphore;

/// Most backups of a list; the oldest are left out.
const MOST: usize = 1000;

/// Bytes that are read at a time.
const PIECE: usize = 256 << 10;

/// Longest backup that is taken, bytes; a larger one is laid into the folder by who has the computer.
const LONGEST: usize = 256 << 20;

/// What a backup that comes is called until it is judged: in the folder of the memory, so that it only changes its
/// name.
const COMING: &str = "upload.part";

/// One backup comes at a time.
static TURN: Semaphore = Semaphore::const_new(1);

pub(super) fn routes() -> Router<Arc<Shared>> {
    Router::new().route("/api/backups", get(list)).route("/api/backups/{name}", get(download).put(upload))
}

/// Refuses who may not carry backups.
fn may_carry(session: &Session) -> Result<(), Problem> {
    if session.level().covers(CARRIES_BACKUPS) {
        return Ok(());
    }
    let number = |level: Level| f64::from(level.number());
    let alarm = Alarm::core(Fault::RightMissing, Span::default());
    Err(Problem::from(alarm.with("needed", number(CARRIES_BACKUPS)).with("level", number(session.level()))))
}

/// A backup of the list.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(super) struct Backup {
    name: String,
    bytes: u64,
    /// When it was written, ms since 1970 (UTC).
    changed: i64,
}

/// The memory and its folder, where something is kept.
fn store_of(shared: &Shared) -> Result<(Arc<Store>, std::path::PathBuf), Problem> {
    let missing = || Alarm::core(Fault::NotFitted, Span::default()).with("name", "memory");
    let store = shared.store.as_ref().ok_or_else(missing)?;
    Ok((store.clone(), store.folder().ok_or_else(missing)?.to_owned()))
}

/// When a file was written, ms since 1970 (UTC).
fn changed(about: &Metadata) -> i64 {
    let since = about.modified().ok().and_then(|time| time.duration_since(UNIX_EPOCH).ok());
    since.map_or(0, |since| i64::try_from(since.as_millis()).unwrap_or(i64::MAX))
}

/// The backups of a folder, the newest first.
fn backups(folder: &std::path::Path) -> io::Result<Vec<Backup>> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let Ok(name) = entry.file_name().into_string() else { continue };
        let is_file = entry.file_type()?.is_file();
        if !is_file || backup_in(folder, &name).is_err() {
            continue;
        }
        let about = entry.metadata()?;
        found.push(Backup { name, bytes: about.len(), changed: changed(&about) });
    }
    found.sort_by(|one, other| other.changed.cmp(&one.changed).then_with(|| one.name.cmp(&other.name)));
    found.truncate(MOST);
    Ok(found)
}

async fn list(State(shared): State<Arc<Shared>>) -> Result<Json<Vec<Backup>>, Problem> {
    let (_, folder) = store_of(&shared)?;
    let found = work(move |_| backups(&folder)).await?;
    found.map(Json).map_err(|error| Problem::of_file(&error))
}

async fn download(
    State(shared): State<Arc<Shared>>,
    Path(name): Path<String>,
    request: Request,
) -> Result<Response, Problem> {
    let entry = request.extensions().get::<Arc<Entry>>();
    let session = entry.and_then(|entry| entry.rights()).unwrap_or(Session::OPERATOR);
    may_carry(&session)?;
    let (_, folder) = store_of(&shared)?;
    let path = backup_in(&folder, &name).map_err(|_| Problem::Missing)?;
    let opened = work(move |_| {
        // No way out of the folder by a link that somebody has put there.
        let is_file = fs::symlink_metadata(&path)?.is_file();
        let file = File::open(&path)?;
        let bytes = file.metadata()?.len();
        Ok::<_, io::Error>(is_file.then_some((file, bytes)))
    });
    let (file, bytes) = match opened.await? {
        Ok(Some(opened)) => opened,
        Ok(None) => return Err(Problem::Missing),
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Err(Problem::Missing),
        Err(error) => return Err(Problem::of_file(&error)),
    };
    // No more than it was when it was opened: as many bytes are told to come.
    let mut response = Body::from_stream(try_unfold(file.take(bytes), next_piece)).into_response();
    let head = response.headers_mut();
    head.insert(CONTENT_TYPE, HeaderValue::from_static("application/octet-stream"));
    head.insert(CONTENT_LENGTH, HeaderValue::from(bytes));
    let plain = |c: char| !(c.is_ascii_alphanumeric() || matches!(c, '.' | '-' | '_'));
    let names = format!("attachment; filename=\"{}\"", name.replace(plain, "_"));
    if let Ok(names) = HeaderValue::from_str(&names) {
        head.insert(CONTENT_DISPOSITION, names);
    }
    Ok(response)
}

/// Takes a backup into the folder, to be restored from there; for the browser whose socket is in command.
async fn upload(
    State(shared): State<Arc<Shared>>,
    Path(name): Path<String>,
    request: Request,
) -> Result<Json<Backup>, Problem> {
    let entry = request.extensions().get::<Arc<Entry>>().cloned().ok_or(Problem::Command)?;
    let peer = request.extensions().get::<Peer>().copied().ok_or(Problem::Command)?;
    if !shared.hub.commands(entry.number) {
        return Err(Problem::Command);
    }
    let session = entry.rights().ok_or(Problem::LogIn)?;
    may_carry(&session)?;
    let (store, folder) = store_of(&shared)?;
    let path = backup_in(&folder, &name)?;
    let _turn = TURN.try_acquire().map_err(|_| Problem::Busy)?;
    let part = folder.join(COMING);
    let come = read_into_file(request, LONGEST, &part).await;
    let author = Caller { name: panel_at(peer), seat: seat_of(peer), session }.author();
    let done = match come {
        Ok(()) => {
            let (hub, part, name) = (shared.hub.clone(), part.clone(), name.clone());
            let admit = move |_: &_| {
                // Command may have been given away while it came.
                if !hub.commands(entry.number) {
                    return Err(Problem::Command);
                }
                store.admit_backup(&part, &path, &author).map_err(|error| Problem::from(error.alarm()))?;
                let about = fs::metadata(&path).map_err(|error| Problem::of_file(&error))?;
                Ok(Backup { name, bytes: about.len(), changed: changed(&about) })
            };
            work(admit).await.and_then(|done| done)
        }
        Err(problem) => Err(problem),
    };
    if done.is_ok() {
        shared.hub.tell_event(&Event::Changed { item: BACKUPS.to_owned() });
    } else {
        // What is left of it is overwritten by the next.
        let _ = fs::remove_file(&part);
    }
    done.map(Json)
}

/// The next bytes of a file with what is left of it; none at its end.
async fn next_piece(mut file: io::Take<File>) -> io::Result<Option<(Bytes, io::Take<File>)>> {
    let read = move || {
        let mut piece = Vec::with_capacity(PIECE);
        (&mut file).take(PIECE as u64).read_to_end(&mut piece)?;
        Ok((!piece.is_empty()).then(|| (Bytes::from(piece), file)))
    };
    tokio::task::spawn_blocking(read).await.map_err(io::Error::other)?
}
