//! What connections are told and tell besides the commands, answers and events of the service itself.
//!
//! The browser's types of it are written from these (`web/types.rs`).

use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

/// The first line of a connection.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Hello {
    /// `ferrocut`.
    pub hello: &'static str,
    /// Version of the service's commands.
    pub api: u32,
    /// The connection's number.
    pub connection: u64,
    /// Bytes of a line that is taken.
    pub longest_line: usize,
    /// How long a connection that holds a key may be silent, ms.
    pub dead_man_ms: u64,
    /// Of a browser's connection alone.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub panel: Option<PanelInfo>,
    /// Of a browser's connection alone.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub session: Option<SessionInfo>,
}

/// What the panel must know of the machine before it draws.
#[derive(Clone, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PanelInfo {
    /// Whether a ladder runs.
    pub ladder: bool,
    /// Languages of texts, by their tags.
    pub languages: Vec<&'static str>,
}

/// The session as it is told.
#[derive(Clone, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct SessionInfo {
    /// 1 to 4; 0 for the operator, and before a log-in where that is needed.
    pub level: u8,
    /// Whether nothing is told before somebody logs in.
    pub needs_log_in: bool,
}

/// Events of connections, told to those who watch events.
#[derive(Serialize)]
#[serde(tag = "event", rename_all = "snake_case")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum ConnectionEvent {
    /// Who is in command: told at once, and whenever that changes.
    Command {
        /// The number of a connection.
        holder: Option<u64>,
        /// Whether it is the one that is told.
        you: bool,
        /// Those who ask for command, first come first.
        asking: Vec<Asking>,
    },
    /// What this connection asked for was declined.
    Declined {
        /// The connection in command.
        by: u64,
    },
}

/// Who asks for command.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Asking {
    /// The number of his connection.
    pub connection: u64,
    /// Where from, an address; empty on the machine's own sockets.
    pub from: String,
    /// The level of his session, 1 to 5, of which 5 is the operator.
    pub level: u8,
}

/// Commands of the connection itself.
#[derive(Deserialize)]
#[serde(tag = "do", rename_all = "snake_case")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum ConnectionCommand {
    /// From now on this connection may move things.
    TakeCommand,
    /// No longer.
    GiveCommand,
    /// Asks the one in command for it.
    AskForCommand,
    /// Asks for it no longer.
    WithdrawRequest,
    /// The one in command gives it to one who asks.
    HandOver {
        /// The number of his connection.
        to: u64,
    },
    /// The one in command does not.
    Decline {
        /// The number of his connection.
        to: u64,
    },
    /// What it is told.
    Watch {
        /// Events.
        #[serde(default)]
        events: bool,
        /// The status, every 20 ms.
        #[serde(default)]
        status: bool,
    },
    /// Nothing but a sign of life.
    Alive,
}

impl ConnectionCommand {
    /// The names of all, as `do` has them.
    const NAMES: [&str; 8] = [
        "take_command",
        "give_command",
        "ask_for_command",
        "withdraw_request",
        "hand_over",
        "decline",
        "watch",
        "alive",
    ];

    /// What a line tells the connection; none where it is for the service.
    pub fn of(line: &Map<String, Value>) -> Option<Result<ConnectionCommand, serde_json::Error>> {
        let name = line.get("do")?.as_str()?;
        ConnectionCommand::NAMES.contains(&name).then(|| ConnectionCommand::deserialize(line))
    }
}
