//! Texts of programs, read by a thread of their own where periods must be short: a program has megabytes at times, and to
//! read it from the durable memory takes longer than a period. Choosing a program begins to read it; cycle start waits the
//! periods that are still left of it.

use super::callable::{Callable, Prepared};
use super::{Control, alarm};
use crate::signals::Mode;
use ferrocut_machine::{Alarm, Fault};
use ferrocut_program::{ProgramMemory, Text};
use std::sync::mpsc::{Receiver, SyncSender, TryRecvError, sync_channel};
use std::thread;
use std::time::Duration;

/// What the thread is to do, most at once.
const JOBS: usize = 16;

/// How long the thread sleeps before it looks for work again. It is not woken, since that takes the system longer than all
/// else in a period; whoever chose a program presses the next key later than that.
const NAP: Duration = Duration::from_millis(5);

enum Job {
    /// The text of a program, for the request of this number.
    Read(u64, String),
    /// Programs that nobody needs any more: to free megabytes takes its time too.
    Free(Box<ProgramMemory>),
}

/// A program, or why there is none.
type Found = Result<Box<Prepared>, Fault>;

struct Worker {
    jobs: SyncSender<Job>,
    found: Receiver<(u64, Found)>,
}

impl Worker {
    fn start(callable: Callable) -> std::io::Result<Worker> {
        let (jobs, asked) = sync_channel(JOBS);
        let (give, found) = sync_channel(JOBS);
        thread::Builder::new().name("programs".to_owned()).spawn(move || {
            loop {
                match asked.try_recv() {
                    Ok(Job::Read(number, name)) => {
                        if give.send((number, read(&callable, &name))).is_err() {
                            return;
                        }
                    }
                    Ok(Job::Free(programs)) => drop(programs),
                    Err(TryRecvError::Empty) => thread::sleep(NAP),
                    Err(TryRecvError::Disconnected) => return,
                }
            }
        })?;
        Ok(Worker { jobs, found })
    }
}

/// A program of the memory.
fn read(callable: &Callable, name: &str) -> Found {
    let bytes = callable.library().text(name).ok_or(Fault::NoSuchName)?;
    let text = Text::from_bytes(bytes).map_err(|_| Fault::FileNotText)?;
    Ok(Box::new(callable.prepare(name, text)))
}

/// What is read, or was.
#[derive(Default)]
pub(super) struct Reading {
    worker: Option<Worker>,
    /// Requests until now.
    number: u64,
    /// The program of the last request, and its text once that is here.
    wanted: Option<(String, Option<Found>)>,
    /// Cycle start waits for it.
    starts: bool,
}

impl Reading {
    /// What was read of a program is not its text any more. Any other may run that of the tool change.
    pub fn forget(&mut self, program: &str, changes_tools: bool) {
        if changes_tools || self.wanted.as_ref().is_some_and(|(name, _)| name == program) {
            self.wanted = None;
        }
    }

    /// The same of all programs.
    pub fn forget_all(&mut self) {
        self.wanted = None;
    }

    /// Cycle start waits no longer.
    pub fn cancel_start(&mut self) {
        self.starts = false;
    }

    /// Frees programs, beside where something is done there.
    pub fn free(&mut self, programs: ProgramMemory) {
        if let Some(worker) = &self.worker {
            // Where the thread is gone, or has enough to do, they are freed here.
            let _ = worker.jobs.try_send(Job::Free(Box::new(programs)));
        }
    }

    fn take(&mut self, program: &str) -> Option<Found> {
        self.look();
        let (_, found) = self.wanted.as_mut().filter(|(name, _)| name == program)?;
        let found = found.take()?;
        self.wanted = None;
        Some(found)
    }

    fn is_here(&mut self) -> bool {
        self.look();
        matches!(self.wanted, Some((_, Some(_))))
    }

    /// Takes what has come, if it is still wanted.
    fn look(&mut self) {
        let Some(worker) = &self.worker else { return };
        for (number, found) in worker.found.try_iter() {
            if let Some((_, place)) = self.wanted.as_mut().filter(|_| number == self.number) {
                *place = Some(found);
            }
        }
    }
}

impl Control {
    /// Starts the thread: threads take the system longer than a period.
    pub(super) fn read_programs_beside(&mut self) {
        if self.reading.worker.is_none() {
            self.reading.worker = Worker::start(self.callable.clone()).ok();
        }
    }

    /// Begins to read the text of a program, where periods must be short. Whether its text comes later.
    pub(super) fn read_ahead(&mut self, name: &str) -> bool {
        if !self.cnc.works_beside() || self.has_loaded(name) {
            return false;
        }
        if self.reading.wanted.as_ref().is_some_and(|(wanted, _)| wanted == name) {
            return !self.reading.is_here();
        }
        self.read_programs_beside();
        let reading = &mut self.reading;
        let Some(worker) = &reading.worker else { return false };
        reading.number += 1;
        // Where the thread is gone it is read in the period.
        let is_asked = worker.jobs.try_send(Job::Read(reading.number, name.to_owned())).is_ok();
        reading.wanted = is_asked.then(|| (name.to_owned(), None));
        is_asked
    }

    /// Cycle start waits for the text of the program.
    pub(super) fn start_when_read(&mut self) {
        self.reading.starts = true;
    }

    /// A program to be loaded: what was read ahead, else it is read now.
    pub(super) fn program_to_load(&mut self, name: &str) -> Result<Box<Prepared>, Box<Alarm>> {
        let found = self.reading.take(name).unwrap_or_else(|| read(&self.callable, name));
        found.map_err(|fault| {
            let about = if fault == Fault::FileNotText { "file" } else { "name" };
            Box::new(alarm(fault).with(about, name))
        })
    }

    /// Once a period: the program starts whose text has come.
    pub(super) fn follow_reading(&mut self) {
        if !self.reading.starts {
            return;
        }
        let is_lost = self.reading.wanted.is_none();
        if !is_lost && !self.reading.is_here() {
            return;
        }
        self.reading.starts = false;
        if self.mode == Mode::Auto
            && let Err(why) = self.cycle_start()
        {
            self.refuse(&why);
        }
    }
}
