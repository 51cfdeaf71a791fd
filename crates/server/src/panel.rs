//! The whole control for sockets (`docs/api.md` has its commands).

use crate::service::{Need, Service};
use ferrocut_controller::api::{API_VERSION, Command, Event, Refusal, Reply, Status};
use ferrocut_controller::control::Control;
use ferrocut_memory::{Author, Session};

/// A control whose connections are operators until they log in.
pub struct Panel(Control);

impl Panel {
    /// Serves a control.
    pub fn new(control: Control) -> Panel {
        Panel(control)
    }
}

impl Service for Panel {
    type Command = Command;
    type Reply = Reply;
    type Refusal = Refusal;
    type Event = Event;
    type Status = Status;

    const VERSION: u32 = API_VERSION;

    fn tick(&mut self) {
        self.0.tick();
    }

    fn command(&mut self, command: Command, from: u64) -> Result<Reply, Refusal> {
        // Rights that were taken belong to the connection: its number comes but once.
        let author = Author::Person { session: Session::OPERATOR, name: format!("connection {from}") };
        self.0.command(command, &author)
    }

    fn events(&mut self) -> Vec<Event> {
        self.0.events()
    }

    fn status(&mut self) -> Status {
        self.0.status()
    }

    fn need(command: &Command) -> Need {
        match command {
            // Whoever sees danger stops the machine.
            Command::EmergencyStop { pressed: true } => Need::Nothing,
            Command::Programs
            | Command::Read { .. }
            | Command::Offsets { .. }
            | Command::Zeros
            | Command::Variables { .. }
            | Command::Parameters { .. }
            | Command::AlarmHistory { .. }
            | Command::OperationLog { .. }
            | Command::Signals { .. }
            | Command::Ladder
            | Command::LadderFlow
            | Command::Captured
            | Command::Status
            | Command::Version => Need::Nothing,
            _ => Need::Command,
        }
    }

    fn key(command: &Command) -> Option<(&str, bool)> {
        match command {
            Command::Key { key, down } => Some((key, *down)),
            _ => None,
        }
    }

    fn release(key: &str) -> Command {
        Command::Key { key: key.to_owned(), down: false }
    }

    fn farewell() -> Option<Command> {
        Some(Command::LogOut)
    }
}
