//! The one writer: a thread that owns the database and makes many changes durable with one wait for the disk.
//!
//! While the disk is waited for, the next changes gather; then all of them go into one commit. So a change that
//! comes alone costs one wait, and a thousand that come at once cost hardly more.

use crate::apply::Applier;
use crate::author::Author;
use crate::error::Error;
use crate::items::{Change, now};
use crate::mark::Mark;
use ferrocut_machine::Memory;
use std::sync::mpsc::{Receiver, SyncSender, TryRecvError, sync_channel};
use std::thread::JoinHandle;

/// Changes that wait for the writer; who brings more waits.
const QUEUE: usize = 1024;

/// Most batches of one commit: bounds how long the first of them waits.
const MOST_BATCHES: usize = 4096;

/// The answer to a batch: the number of the commit that has it.
pub type Answer = Result<u64, Error>;

/// Work that no batch of changes is: restoring, passwords. It has a commit of its own.
pub type Task = Box<dyn FnOnce(&mut Applier) -> Result<(), Error> + Send>;

/// What the writer is asked.
pub enum Job {
    /// Changes that are made together or not at all.
    Batch {
        /// Who makes them.
        author: Author,
        /// The changes.
        changes: Vec<Change>,
        /// Who wants to know.
        answer: Option<SyncSender<Answer>>,
    },
    /// Other work.
    Task {
        /// The work.
        task: Task,
        /// Who wants to know.
        answer: SyncSender<Answer>,
    },
    /// What nobody has set is as in this.
    Deliver(Box<Memory>),
    /// Answers when all before it is durable, with the first error that nobody waited for.
    Flush(SyncSender<Answer>),
    /// Ends the writer.
    Stop,
}

struct Batch {
    author: Author,
    changes: Vec<Change>,
    answer: Option<SyncSender<Answer>>,
}

/// Starts the writer. What is on no disk has no mark.
pub fn start(applier: Applier, mark: Option<Mark>) -> Result<(SyncSender<Job>, JoinHandle<()>), Error> {
    let (jobs, queue) = sync_channel(QUEUE);
    let writer = Writer { applier, mark, unheard: None };
    let thread = std::thread::Builder::new().name("memory".into()).spawn(move || writer.run(&queue))?;
    Ok((jobs, thread))
}

struct Writer {
    applier: Applier,
    mark: Option<Mark>,
    /// The first error of a change that nobody waits for.
    unheard: Option<Error>,
}

impl Writer {
    fn run(mut self, queue: &Receiver<Job>) {
        let mut next = queue.recv().ok();
        while let Some(job) = next.take() {
            match job {
                Job::Batch { author, changes, answer } => {
                    let mut batches = vec![Batch { author, changes, answer }];
                    while batches.len() < MOST_BATCHES {
                        match queue.try_recv() {
                            Ok(Job::Batch { author, changes, answer }) => {
                                batches.push(Batch { author, changes, answer });
                            }
                            Ok(other) => {
                                next = Some(other);
                                break;
                            }
                            Err(TryRecvError::Empty | TryRecvError::Disconnected) => break,
                        }
                    }
                    self.write(batches);
                }
                Job::Task { task, answer } => {
                    let done = self.within_commit(|applier| task(applier));
                    let _ = answer.send(done);
                }
                Job::Deliver(memory) => {
                    if let Err(error) = self.applier.deliver(*memory) {
                        self.unheard.get_or_insert(error);
                    }
                }
                Job::Flush(answer) => {
                    let done = self.unheard.take().map_or(Ok(self.applier.database.commits()), Err);
                    let _ = answer.send(done);
                }
                Job::Stop => break,
            }
            if next.is_none() {
                next = queue.recv().ok();
            }
        }
        // Both are tried; what fails now is found at the next start.
        let _ = self.mark.as_ref().map(Mark::sync);
        let _ = self.applier.database.close();
    }

    /// Makes batches durable with one commit. Where one of them fails half-way, each gets its own.
    fn write(&mut self, batches: Vec<Batch>) {
        let mut results: Vec<Result<(), Error>> = Vec::with_capacity(batches.len());
        let together = self.within_commit(|applier| {
            for batch in &batches {
                results.push(check(applier, batch));
                if matches!(results.last(), Some(Ok(()))) {
                    write_batch(applier, batch)?;
                }
            }
            // Where nothing was allowed there is nothing to commit; each batch has an answer of its own.
            match results.iter().any(Result::is_ok) {
                true => Ok(()),
                false => Err(Error::Closed),
            }
        });
        let nothing_written = results.len() == batches.len() && results.iter().all(Result::is_err);
        match together {
            Err(_) if nothing_written => {
                for (batch, result) in batches.into_iter().zip(results) {
                    self.answer(batch, result.map(|()| 0));
                }
            }
            Err(_) if batches.len() > 1 => {
                for batch in batches {
                    let done = self.within_commit(|applier| {
                        check(applier, &batch)?;
                        write_batch(applier, &batch)
                    });
                    self.answer(batch, done);
                }
            }
            together => {
                // Where not even the commit could begin, there is no result of its own.
                let results = results.into_iter().chain(std::iter::repeat(Ok(())));
                for (batch, result) in batches.into_iter().zip(results) {
                    self.answer(batch, result.and_then(|()| together.clone()));
                }
            }
        }
    }

    fn answer(&mut self, batch: Batch, result: Answer) {
        match (batch.answer, result) {
            // Who asked may have gone.
            (Some(answer), result) => drop(answer.send(result)),
            (None, Err(error)) => drop(self.unheard.get_or_insert(error)),
            (None, Ok(_)) => {}
        }
    }

    fn within_commit(&mut self, work: impl FnOnce(&mut Applier) -> Result<(), Error>) -> Answer {
        let done = self
            .applier
            .database
            .begin()
            .and_then(|()| work(&mut self.applier))
            .and_then(|()| self.applier.database.commit());
        match done {
            Ok(commit) => {
                // Before anyone is told. Where it fails the commit is durable all the same, and only a loss that
                // comes on top would not be seen.
                let _ = self.mark.as_mut().map(|mark| mark.set(commit));
                Ok(commit)
            }
            Err(error) => {
                self.applier.database.rollback();
                // They are what the database has again; where it cannot be read, the next commit says so.
                let _ = self.applier.read_parameters();
                Err(error)
            }
        }
    }
}

fn check(applier: &Applier, batch: &Batch) -> Result<(), Error> {
    batch.changes.iter().try_for_each(|change| applier.check(&batch.author, change))
}

fn write_batch(applier: &mut Applier, batch: &Batch) -> Result<(), Error> {
    let time = now();
    batch.changes.iter().try_for_each(|change| applier.write(&batch.author, change, time))
}
