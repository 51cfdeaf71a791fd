//! `POST /api/check`: every finding of a program, as `ferrocut check` has them, for an editor.

use super::Shared;
use super::body::read;
use super::problem::Problem;
use super::query::{Spoken, desk};
use super::work::{LOOK_STEPS, Wanted, work};
use axum::extract::{Query, Request, State};
use axum::routing::post;
use axum::{Json, Router};
use ferrocut_controller::control::Desk;
use ferrocut_desk::finding::{AllFound, Finding, Found};
use ferrocut_machine::{Alarm, Catalogue, Fault};
use ferrocut_program::{FileId, ProgramMemory, Span, Text};
use serde::Serialize;
use std::sync::Arc;

/// Bytes of a program that is checked or drawn.
pub(super) const LONGEST_PROGRAM: usize = 32 << 20;

/// Findings of one program.
const MOST_FINDINGS: usize = 1000;

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct Findings {
    findings: Vec<Finding>,
}

pub(super) fn routes() -> Router<Arc<Shared>> {
    Router::new().route("/api/check", post(check))
}

async fn check(
    State(shared): State<Arc<Shared>>,
    Query(spoken): Query<Spoken>,
    request: Request,
) -> Result<Json<Findings>, Problem> {
    let (catalogue, dialect) = (spoken.catalogue()?, spoken.dialect(&shared)?);
    let text = read(request, LONGEST_PROGRAM).await?;
    let desk = desk(&shared).await?.speaking(dialect);
    let findings = work(move |wanted| findings(&desk, text.to_vec(), catalogue, wanted)).await?;
    Ok(Json(Findings { findings }))
}

/// What is wrong with a program. One that takes too long, or has too many faults, has a last finding that says so.
pub(crate) fn findings(desk: &Desk, text: Vec<u8>, catalogue: Catalogue, wanted: &Wanted) -> Vec<Finding> {
    // An editor's empty page is no fault.
    if text.iter().all(u8::is_ascii_whitespace) {
        return Vec::new();
    }
    let mut interpreter = match desk.interpreter(NAME, text, true) {
        Ok(interpreter) => interpreter,
        Err(alarm) => return vec![without_place(&alarm, desk, catalogue)],
    };
    let mut supervisor = desk.supervisor();
    let (mut all, mut pending, mut steps) = (AllFound::new(MOST_FINDINGS), Vec::new(), 0u64);
    let mut is_cut = false;
    while !is_cut && supervisor.follow(&mut interpreter, &mut pending) {
        for alarm in pending.drain(..) {
            all.add(alarm, &interpreter);
        }
        steps += 1;
        is_cut = all.is_full() || steps.is_multiple_of(LOOK_STEPS) && !wanted.is();
    }
    let of =
        |found: &Found| Finding::of(&found.alarm, interpreter.programs(), interpreter.main_file(), catalogue);
    let mut findings: Vec<Finding> = all.found.iter().map(of).collect();
    if is_cut {
        let line = findings.last().map_or(0, |last| last.line);
        let ended =
            Alarm::core(Fault::CheckEnded, Span::default()).with("line", f64::from(line)).as_warning();
        findings.push(without_place(&ended, desk, catalogue));
    }
    findings
}

/// What an editor's text is called.
pub(super) const NAME: &str = "panel";

fn without_place(alarm: &Alarm, desk: &Desk, catalogue: Catalogue) -> Finding {
    let empty = Text::from_bytes(b"%".to_vec());
    let programs = empty.map(|text| ProgramMemory::new(NAME, text, desk.dialect().syntax));
    match programs {
        Ok(programs) => Finding::of(alarm, &programs, FileId(0), catalogue),
        Err(_) => Finding {
            id: alarm.id.to_string(),
            severity: alarm.severity.name(),
            program: None,
            line: 0,
            column: 1,
            end_line: 0,
            end_column: 1,
            text: catalogue.message(alarm),
            help: catalogue.help(alarm),
        },
    }
}
