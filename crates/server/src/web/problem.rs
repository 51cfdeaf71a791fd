//! Why a request was refused: a status, a code for programs, and where the control says so, its alarm.

use axum::Json;
use axum::http::{HeaderValue, StatusCode, header};
use axum::response::{IntoResponse, Response};
use ferrocut_controller::api::{AlarmInfo, Refusal};
use ferrocut_machine::{Alarm, Fault};
use ferrocut_program::Span;
use serde::Serialize;

/// Why a request was refused.
#[derive(Clone, PartialEq, Debug)]
pub(crate) enum Problem {
    /// It does not call this computer by its name.
    Host,
    /// It comes from a page of another server.
    Origin,
    /// Nobody is logged in.
    LogIn,
    /// Who asks is not in command.
    Command,
    /// Too many tries.
    TooOften,
    /// Too much is asked for at once.
    Busy,
    /// More bytes than are taken.
    TooLarge,
    /// It took too long to come.
    TooSlow,
    /// Something of it cannot be read: what.
    Unreadable(String),
    /// There is no such thing.
    Missing,
    /// The machine does not answer.
    NoMachine(&'static str),
    /// The control refused it.
    Refused(Box<AlarmInfo>),
}

/// Why a request was refused, as it is told.
#[derive(Serialize, Default)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(super) struct Trouble {
    /// A code, for programs.
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<String>,
    /// What of it, for programs.
    #[serde(skip_serializing_if = "Option::is_none")]
    detail: Option<String>,
    /// What the control refused it with.
    #[serde(skip_serializing_if = "Option::is_none")]
    refused: Option<Refusal>,
}

impl Problem {
    fn code(&self) -> (StatusCode, &'static str) {
        match self {
            Problem::Host => (StatusCode::MISDIRECTED_REQUEST, "unknown_host"),
            Problem::Origin => (StatusCode::FORBIDDEN, "other_origin"),
            Problem::LogIn => (StatusCode::UNAUTHORIZED, "log_in"),
            Problem::Command => (StatusCode::FORBIDDEN, "not_in_command"),
            Problem::TooOften => (StatusCode::TOO_MANY_REQUESTS, "too_often"),
            Problem::Busy => (StatusCode::SERVICE_UNAVAILABLE, "busy"),
            Problem::TooLarge => (StatusCode::PAYLOAD_TOO_LARGE, "too_large"),
            Problem::TooSlow => (StatusCode::REQUEST_TIMEOUT, "too_slow"),
            Problem::Unreadable(_) => (StatusCode::BAD_REQUEST, "unreadable"),
            Problem::Missing => (StatusCode::NOT_FOUND, "missing"),
            Problem::NoMachine(code) => (StatusCode::SERVICE_UNAVAILABLE, code),
            Problem::Refused(_) => (StatusCode::CONFLICT, "refused"),
        }
    }
}

impl IntoResponse for Problem {
    fn into_response(self) -> Response {
        let (status, code) = self.code();
        let error = Some(code.to_owned());
        let body = match &self {
            Problem::Refused(alarm) => {
                Trouble { refused: Some(Refusal { alarm: (**alarm).clone() }), ..Trouble::default() }
            }
            Problem::Unreadable(detail) => Trouble { error, detail: Some(detail.clone()), refused: None },
            _ => Trouble { error, ..Trouble::default() },
        };
        let mut response = (status, Json(body)).into_response();
        if matches!(self, Problem::TooOften | Problem::Busy) {
            response.headers_mut().insert(header::RETRY_AFTER, HeaderValue::from_static("2"));
        }
        response
    }
}

impl Problem {
    /// A file of this computer that cannot be read or written.
    pub(super) fn of_file(error: &std::io::Error) -> Problem {
        Problem::from(Alarm::core(Fault::FileUnreadable, Span::default()).with("reason", error.to_string()))
    }
}

impl From<Refusal> for Problem {
    fn from(refusal: Refusal) -> Problem {
        Problem::Refused(Box::new(refusal.alarm))
    }
}

impl From<Alarm> for Problem {
    fn from(alarm: Alarm) -> Problem {
        Problem::Refused(Box::new(AlarmInfo::of(&alarm)))
    }
}

impl From<Box<Alarm>> for Problem {
    fn from(alarm: Box<Alarm>) -> Problem {
        Problem::from(*alarm)
    }
}
