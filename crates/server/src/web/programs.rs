//! Programs in and out of the control's memory. Names are those of the memory: none leads to a file.

use super::Shared;
use super::body::read;
use super::check::LONGEST_PROGRAM;
use super::listen::Peer;
use super::problem::Problem;
use super::session::{Entry, panel_at, seat_of};
use super::work::work;
use crate::service::Caller;
use axum::body::Bytes;
use axum::extract::{Path, Request, State};
use axum::http::HeaderValue;
use axum::http::header::{CONTENT_DISPOSITION, CONTENT_TYPE};
use axum::response::{IntoResponse, Response};
use axum::routing::get;
use axum::{Json, Router};
use ferrocut_controller::api::Command;
use ferrocut_memory::is_program_name;
use serde_json::{Value, json};
use std::sync::Arc;

pub(super) fn routes() -> Router<Arc<Shared>> {
    Router::new().route("/api/programs/{name}", get(download).put(upload))
}

async fn download(State(shared): State<Arc<Shared>>, Path(name): Path<String>) -> Result<Response, Problem> {
    if !is_program_name(&name) {
        return Err(Problem::Missing);
    }
    let library = shared.library.clone();
    let found = work(move |_| library.typed(&name)).await?;
    let (name, text) = found.ok_or(Problem::Missing)?;
    let mut response = Bytes::from(text).into_response();
    let head = response.headers_mut();
    head.insert(CONTENT_TYPE, HeaderValue::from_static("application/octet-stream"));
    let names =
        format!("attachment; filename=\"{}.nc\"", name.replace(|c: char| !c.is_ascii_alphanumeric(), "_"));
    if let Ok(names) = HeaderValue::from_str(&names) {
        head.insert(CONTENT_DISPOSITION, names);
    }
    Ok(response)
}

/// Stores a program, by the rights and rules of the command `store`; for the browser whose socket is in command.
async fn upload(
    State(shared): State<Arc<Shared>>,
    Path(program): Path<String>,
    request: Request,
) -> Result<Json<Value>, Problem> {
    if !is_program_name(&program) {
        return Err(Problem::Missing);
    }
    let entry = request.extensions().get::<Arc<Entry>>().cloned().ok_or(Problem::Command)?;
    let peer = request.extensions().get::<Peer>().copied().ok_or(Problem::Command)?;
    if !shared.hub.commands(entry.number) {
        return Err(Problem::Command);
    }
    let bytes = read(request, LONGEST_PROGRAM).await?;
    let session = entry.rights().ok_or(Problem::LogIn)?;
    let from = Caller { name: panel_at(peer), seat: seat_of(peer), session };
    let text = ferrocut_program::Text::from_bytes(bytes.to_vec());
    let encoding =
        text.map(|text| text.encoding()).map_err(|_| Problem::Unreadable("not_text".to_owned()))?;
    let text = encoding.decode(&bytes).into_owned();
    let hub = shared.hub.clone();
    let ask = move || {
        // Command may have been given away while the program came.
        hub.commands(entry.number).then(|| hub.ask(Command::Store { program, text }, from))
    };
    let done = tokio::task::spawn_blocking(ask).await.map_err(|_| Problem::Busy)?;
    let reply = done.ok_or(Problem::Command)?.map_err(Problem::NoMachine)??;
    Ok(Json(json!(reply)))
}
