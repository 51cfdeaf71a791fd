//! The mill on a thread of its own, as the protocol sees it.

use crate::grbl::checker::Checker;
use crate::grbl::{Event, Machine, Overrides, Status};
use crate::mill::{Command, Mill};
use crate::runner::{Latest, Owned, Runner};
use ferrocut_geometry::Position;
use ferrocut_machine::{Fault, Machine as MachineFile};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};

/// Events that wait at most. Whoever takes them is behind by more than any sender has blocks under way.
const MOST_EVENTS: usize = 1024;

/// A mill that tells its events over a queue.
pub struct Driven {
    mill: Mill,
    events: SyncSender<Event>,
    lines_done: u32,
    news: bool,
}

/// The mill after some commands.
#[derive(Debug)]
pub struct Stand {
    status: Status,
    taken: u64,
}

impl Owned for Driven {
    type Command = Command;
    type Snapshot = Stand;

    fn take(&mut self, command: Command) {
        self.mill.take(command);
    }

    fn tick(&mut self) {
        self.mill.tick();
        while let Some(event) = self.mill.event() {
            // Told before the snapshot that has it in.
            let _ = self.events.try_send(event);
            self.news = true;
        }
        let lines_done = self.mill.cnc().lines_done();
        self.news |= lines_done != self.lines_done;
        self.lines_done = lines_done;
    }

    fn prepare(&mut self) {
        self.mill.prepare();
    }

    fn has_news(&self) -> bool {
        self.news
    }

    fn snapshot(&mut self, taken: u64) -> Stand {
        self.news = false;
        Stand { status: self.mill.now(), taken }
    }
}

/// A mill on a thread, for one that gives it commands.
pub struct Remote {
    file: MachineFile,
    commands: SyncSender<Command>,
    latest: Arc<Latest<Stand>>,
    events: Receiver<Event>,
    given: u64,
    status: Status,
    checker: Option<Checker>,
}

impl Remote {
    /// Puts a mill on a thread.
    pub fn start(
        file: &MachineFile,
        mill: Mill,
        priority: Option<u8>,
    ) -> std::io::Result<(Runner<Driven>, Remote)> {
        let (events, told) = sync_channel(MOST_EVENTS);
        let period = std::time::Duration::from_secs_f64(file.servo_period_ms / 1000.0);
        let runner = Runner::start(Driven { mill, events, lines_done: 0, news: false }, period, priority)?;
        let remote = Remote {
            file: file.clone(),
            commands: runner.commands(),
            latest: runner.latest(),
            events: told,
            given: 0,
            status: Status::default(),
            checker: None,
        };
        Ok((runner, remote))
    }

    fn tell(&mut self, command: Command) {
        // It waits where too many wait; without a machine nothing is current any more.
        self.given += 1;
        let _ = self.commands.send(command);
    }
}

impl Machine for Remote {
    fn status(&mut self) -> &Status {
        let latest = self.latest.get();
        self.status.clone_from(&latest.status);
        self.status.is_current = latest.taken == self.given;
        &self.status
    }

    fn event(&mut self) -> Option<Event> {
        self.events.try_recv().ok()
    }

    fn append(&mut self, block: &str) {
        self.tell(Command::Append(block.to_owned()));
    }

    fn check(&mut self, block: &str) -> Option<Fault> {
        let status = self.latest.get();
        let checker = self.checker.get_or_insert_with(|| Checker::new(&self.file, &status.status));
        checker.check(block)
    }

    fn end_check(&mut self) {
        self.checker = None;
    }

    fn hold(&mut self) {
        self.tell(Command::Hold);
    }

    fn start(&mut self) {
        self.tell(Command::Start);
    }

    fn reset(&mut self) {
        self.tell(Command::Reset);
    }

    fn jog(&mut self, to: Position, feed: f64) {
        self.tell(Command::Jog(to, feed));
    }

    fn cancel_jog(&mut self) {
        self.tell(Command::CancelJog);
    }

    fn home(&mut self) {
        self.tell(Command::Home);
    }

    fn set_overrides(&mut self, overrides: Overrides) {
        self.tell(Command::Overrides(overrides));
    }

    fn stop_spindle(&mut self, stops: bool) {
        self.tell(Command::StopSpindle(stops));
    }
}
