//! The cycle editor: forms, what a form comes to as text and as a path, contours of drawings (`docs/cycles.md`).

use super::Shared;
use super::body::read;
use super::path;
use super::problem::Problem;
use super::query::{Spoken, desk};
use super::work::work;
use axum::body::Bytes;
use axum::extract::{Query, Request, State};
use axum::http::header::CONTENT_TYPE;
use axum::response::{IntoResponse, Response};
use axum::routing::{get, post};
use axum::{Json, Router};
use ferrocut_editor::request::Contour;
use ferrocut_editor::{Control, Finding, Form, forms, from_dxf, make, run, write};
use serde::Serialize;
use std::sync::Arc;

/// Bytes of a form: a profile of twenty thousand elements.
const LONGEST_FORM: usize = 4 << 20;

/// Bytes of a drawing whose contours are taken.
const LONGEST_DRAWING: usize = 16 << 20;

pub(super) fn routes() -> Router<Arc<Shared>> {
    Router::new()
        .route("/api/cycles", get(cycles))
        .route("/api/cycle", post(cycle))
        .route("/api/cycle/path", post(path_of))
        .route("/api/profile/dxf", post(drawing))
}

async fn cycles(Query(spoken): Query<Spoken>) -> Result<Json<Vec<Form>>, Problem> {
    Ok(Json(forms(spoken.catalogue()?.language())))
}

/// A form as it was filled in.
async fn form(request: Request) -> Result<ferrocut_editor::Request, Problem> {
    let body = read(request, LONGEST_FORM).await?;
    serde_json::from_slice(&body).map_err(|error| Problem::Unreadable(error.to_string()))
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(super) struct Written {
    text: String,
    expanded: bool,
    findings: Vec<Finding>,
}

async fn cycle(
    State(shared): State<Arc<Shared>>,
    Query(spoken): Query<Spoken>,
    request: Request,
) -> Result<Json<Written>, Problem> {
    let (language, dialect) = (spoken.catalogue()?.language(), spoken.dialect(&shared)?);
    let form = form(request).await?;
    let desk = desk(&shared).await?;
    let written = work(move |_| {
        let machine = Control { dialect: desk.dialect(), memory: desk.memory() };
        write(&form, dialect, Some(machine))
    });
    let written = written.await?;
    let findings = written.wrong.iter().map(|wrong| wrong.finding(language)).collect();
    Ok(Json(Written { text: written.text, expanded: written.is_expanded, findings }))
}

/// The path of the cycle alone, in coordinates of the program, from over its first point.
async fn path_of(State(shared): State<Arc<Shared>>, request: Request) -> Result<Response, Problem> {
    let form = form(request).await?;
    let desk = desk(&shared).await?;
    let bytes = work(move |_| {
        let machine = Control { dialect: desk.dialect(), memory: desk.memory() };
        let made = make(&form, Some(machine));
        let is_there = |at: [f64; 3]| [at[0], at[1]] != run::BESIDE;
        let mut places =
            made.steps.iter().enumerate().filter_map(|(n, step)| step.op.target().map(|to| (n, *to)));
        let first = places.find(|(_, to)| is_there(run::xyz(to)));
        let (steps, start) = match first {
            Some((n, to)) => (made.steps.get(n..).unwrap_or(&[]), to),
            None => (&[][..], made.start),
        };
        // A spindle that was started before the first move turns.
        let spindle = made.steps.iter().take(first.map_or(0, |(n, _)| n)).rev();
        let spindle = spindle.filter(|step| matches!(step.op, ferrocut_toolpath::Op::Spindle(_))).take(1);
        path::of_steps(spindle.chain(steps), start, desk.machine(), !made.is_whole)
    });
    Ok(([(CONTENT_TYPE, "application/octet-stream")], Bytes::from(bytes.await?)).into_response())
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(super) struct Drawn {
    #[serde(flatten)]
    contour: Contour,
    closed: bool,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(super) struct Drawing {
    contours: Vec<Drawn>,
    findings: Vec<Finding>,
}

async fn drawing(Query(spoken): Query<Spoken>, request: Request) -> Result<Json<Drawing>, Problem> {
    let language = spoken.catalogue()?.language();
    let bytes = read(request, LONGEST_DRAWING).await?;
    let from = work(move |_| from_dxf(&bytes)).await?;
    let contours = from.contours.into_iter().zip(from.closed);
    Ok(Json(Drawing {
        contours: contours.map(|(contour, closed)| Drawn { contour, closed }).collect(),
        findings: from.wrong.iter().map(|wrong| wrong.finding(language)).collect(),
    }))
}
