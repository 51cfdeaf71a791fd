//! A control as sockets offer it: commands with answers, events, a status. [`Served`] puts it on the machine's thread.

use crate::runner::Owned;
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::sync::mpsc::SyncSender;

/// Who may give a command.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Need {
    /// Everybody who is connected: it reads, or stops the machine.
    Nothing,
    /// The one in command.
    Command,
}

/// A control that commands come to as JSON objects.
pub trait Service: Send + 'static {
    /// What it is told.
    type Command: DeserializeOwned + Send + 'static;
    /// What it answers.
    type Reply: Serialize + Send + 'static;
    /// Why it does not.
    type Refusal: Serialize + Send + 'static;
    /// What happens.
    type Event: Serialize + Send + 'static;
    /// How it stands.
    type Status: Serialize + Send + Sync + 'static;

    /// Version of its commands.
    const VERSION: u32;

    /// Goes on by one servo period.
    fn tick(&mut self);

    /// Does a command of a connection.
    fn command(&mut self, command: Self::Command, from: u64) -> Result<Self::Reply, Self::Refusal>;

    /// What happened since the last call.
    fn events(&mut self) -> Vec<Self::Event>;

    /// How it stands.
    fn status(&mut self) -> Self::Status;

    /// Who may give a command.
    fn need(command: &Self::Command) -> Need;

    /// The key that a command presses (`true`) or lets go.
    fn key(command: &Self::Command) -> Option<(&str, bool)>;

    /// The command that lets a key go.
    fn release(key: &str) -> Self::Command;

    /// What is done when a connection has ended, besides letting its keys go.
    fn farewell() -> Option<Self::Command> {
        None
    }
}

/// A command, from whom, and where its answer goes.
pub struct Request<S: Service> {
    /// What.
    pub command: S::Command,
    /// The number of the connection.
    pub from: u64,
    /// Where the answer goes; none where nobody waits for it.
    pub answer: Option<SyncSender<Result<S::Reply, S::Refusal>>>,
}

/// A control on the machine's thread.
pub struct Served<S: Service> {
    service: S,
    events: SyncSender<S::Event>,
    news: bool,
}

impl<S: Service> Served<S> {
    /// A control that tells its events over a queue. Events that find no room are lost; the status has what stands.
    pub fn new(service: S, events: SyncSender<S::Event>) -> Served<S> {
        Served { service, events, news: false }
    }
}

impl<S: Service> Owned for Served<S> {
    type Command = Request<S>;
    type Snapshot = S::Status;

    fn take(&mut self, request: Request<S>) {
        let done = self.service.command(request.command, request.from);
        if let Some(answer) = request.answer {
            let _ = answer.try_send(done);
        }
    }

    fn tick(&mut self) {
        self.service.tick();
        for event in self.service.events() {
            let _ = self.events.try_send(event);
            self.news = true;
        }
    }

    fn has_news(&self) -> bool {
        self.news
    }

    fn snapshot(&mut self, _: u64) -> S::Status {
        self.news = false;
        self.service.status()
    }
}
