//! A control as sockets offer it: commands with answers, events, a status. [`Served`] puts it on the machine's thread.

use crate::hub::Hub;
use crate::runner::Owned;
use ferrocut_memory::password::Seat;
use ferrocut_memory::{Author, Session, SessionNote};
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

    /// Called once, in the thread that it is on, before the first period.
    fn begin(&mut self) {}

    /// Goes on by one servo period.
    fn tick(&mut self);

    /// Looks ahead, in the time that a period leaves.
    fn prepare(&mut self) {}

    /// Called once, behind the last period.
    fn end(&mut self) {}

    /// Does a command of a connection.
    fn command(&mut self, command: Self::Command, from: &Caller) -> Result<Self::Reply, Self::Refusal>;

    /// What happened since the last call.
    fn events(&mut self) -> Vec<Self::Event>;

    /// How it stands.
    fn status(&mut self) -> Self::Status;

    /// Who may give a command.
    fn need(command: &Self::Command) -> Need;

    /// The key that a command presses (`true`) or lets go.
    fn key(command: &Self::Command) -> Option<(&str, bool)>;

    /// Whether a command takes so long (more than some periods) that what the same connection sends behind it must not
    /// wait: it is done beside, and answered once it is done. Never one that moves or stops something.
    fn takes_long(_command: &Self::Command) -> bool {
        false
    }

    /// The command that lets a key go.
    fn release(key: &str) -> Self::Command;

    /// Somebody commands from now on, or no longer, or asked for it.
    fn commanded(&mut self, _from: &Caller, _note: SessionNote) {}

    /// What is done when whoever commands commands no longer, besides letting his keys go.
    fn abandoned() -> Option<Self::Command> {
        None
    }

    /// What is done when a connection has ended, besides letting its keys go.
    fn farewell() -> Option<Self::Command> {
        None
    }
}

/// Who gives a command.
#[derive(Clone, Debug)]
pub struct Caller {
    /// How the log names him.
    pub name: String,
    /// Where he gives passwords.
    pub seat: Seat,
    /// What he may.
    pub session: Session,
}

impl Caller {
    /// The same as an author of changes.
    pub fn author(&self) -> Author {
        Author::Person { session: self.session.clone(), name: self.name.clone() }
    }
}

/// What is done on a thread of whoever gives a command, since it takes longer than a period; none is the machine's.
pub type Aside<S> = Box<
    dyn Fn(
            &Hub<S>,
            &<S as Service>::Command,
            &Caller,
        ) -> Option<Result<<S as Service>::Reply, <S as Service>::Refusal>>
        + Send
        + Sync,
>;

/// What the machine's thread is asked for.
pub enum Request<S: Service> {
    /// A command.
    Command {
        /// What.
        command: S::Command,
        /// From whom.
        from: Caller,
        /// Where the answer goes; none where nobody waits for it.
        answer: Option<SyncSender<Result<S::Reply, S::Refusal>>>,
    },
    /// A look at the service itself.
    Look(Box<dyn FnOnce(&mut S) + Send>),
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

    fn begin(&mut self) {
        self.service.begin();
    }

    fn take(&mut self, request: Request<S>) {
        match request {
            Request::Command { command, from, answer } => {
                let done = self.service.command(command, &from);
                if let Some(answer) = answer {
                    let _ = answer.try_send(done);
                }
            }
            Request::Look(look) => look(&mut self.service),
        }
    }

    fn tick(&mut self) {
        self.service.tick();
        for event in self.service.events() {
            let _ = self.events.try_send(event);
            self.news = true;
        }
    }

    fn prepare(&mut self) {
        self.service.prepare();
    }

    fn end(&mut self) {
        self.service.end();
    }

    fn has_news(&self) -> bool {
        self.news
    }

    fn snapshot(&mut self, _: u64) -> S::Status {
        self.news = false;
        self.service.status()
    }
}
