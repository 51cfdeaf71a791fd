//! The durable memory of a control, open.

use crate::apply::Applier;
use crate::author::Author;
use crate::damage::{Damage, Whole};
use crate::database::{Access, Database, Verdict};
use crate::error::{Error, Finding};
use crate::items::{AlarmEntry, Change, Contents, Item, LogEntry, Program, ProgramEntry};
use crate::mark::{self, Mark};
use crate::migrate::{migrate, tables_of};
use crate::password::Rights;
use crate::rows;
use crate::snapshot;
use crate::table::{PROGRAM, Row};
use crate::writer::{self, Answer, Job};
use ferrocut_machine::{Alarm, Fault, Memory};
use ferrocut_program::Span;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, SyncSender, TryRecvError, sync_channel};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;
use std::time::Duration;

/// The database in the folder of a memory.
pub const DATABASE: &str = "memory.db";
/// The mark.
pub const MARK: &str = "mark";
/// Held by the one process that writes.
const LOCK: &str = "lock";
/// A database that is being made.
pub(crate) const NEW: &str = "memory.db.new";

/// Bytes of a batch from which on its author waits for it: what waits in the queue stays small.
const LARGE: usize = 64 << 10;

/// How a memory is kept.
#[derive(Clone, Debug)]
pub struct Settings {
    /// The control whose memory it is, such as `gsk990mc`: sizes of tables, parameters as delivered.
    pub control: String,
    /// How often a state is copied as the last good one, where it changed.
    pub snapshot_every: Duration,
    /// How many of those copies are kept.
    pub snapshots: usize,
}

impl Settings {
    /// A control's memory with three good states, an hour apart.
    pub fn new(control: &str) -> Settings {
        Settings { control: control.to_owned(), snapshot_every: Duration::from_secs(3600), snapshots: 3 }
    }
}

/// Why a memory could not be opened.
#[derive(Debug)]
pub enum OpenError {
    /// There is none in the folder.
    Missing,
    /// Another process has it open.
    Busy,
    /// It was written by later software, with this version of the schema.
    Newer(u32),
    /// It is that of another control.
    OtherControl(String),
    /// The disk refuses, in its words.
    Disk(String),
    /// It is damaged; what is said of it, and the good states that there are.
    Damaged(Box<Damage>),
}

impl OpenError {
    /// The alarm that tells it.
    pub fn alarm(&self) -> Alarm {
        let alarm = |fault| Alarm::core(fault, Span::default());
        match self {
            OpenError::Missing => alarm(Fault::MemoryMissing),
            OpenError::Busy => alarm(Fault::MemoryBusy),
            OpenError::Newer(version) => alarm(Fault::MemoryNewer).with("detail", version.to_string()),
            OpenError::OtherControl(name) => alarm(Fault::MemoryOfOther).with("name", name.as_str()),
            OpenError::Disk(reason) => alarm(Fault::MemoryDisk).with("reason", reason.as_str()),
            OpenError::Damaged(damage) => {
                let alarm = alarm(Fault::MemoryDamaged);
                match damage.findings().first() {
                    Some(finding) => alarm.with("detail", finding.to_string()),
                    None => alarm,
                }
            }
        }
    }
}

impl From<Error> for OpenError {
    fn from(error: Error) -> OpenError {
        OpenError::Disk(error.to_string())
    }
}

impl From<std::io::Error> for OpenError {
    fn from(error: std::io::Error) -> OpenError {
        OpenError::Disk(error.to_string())
    }
}

/// The durable memory of a control, or one that goes with the process ([`Store::in_memory`]). One process has it open;
/// readers may look at it beside.
///
/// A commit that returned is on the disk. Dropping it waits until all is, and leaves a snapshot. No call belongs
/// into the real-time thread: all may wait for the disk.
pub struct Store {
    settings: Settings,
    jobs: SyncSender<Job>,
    reader: Reader,
    pub(crate) rights: Rights,
    threads: Vec<JoinHandle<()>>,
    /// Where it is kept; none where it goes with the process. Last, since its lock is held until all is closed.
    disk: Option<Disk>,
}

/// The folder of a memory that is kept.
struct Disk {
    folder: PathBuf,
    keeper: Arc<Keeper>,
    _lock: Lock,
}

/// Memories that are in no folder, made by this process.
static IN_MEMORY: AtomicU64 = AtomicU64::new(0);

/// A change that is on its way to the disk.
#[derive(Debug)]
pub struct Pending(Receiver<Answer>);

impl Pending {
    /// Which commit has it, or why none does; `None` while it is on its way.
    pub fn poll(&self) -> Option<Answer> {
        match self.0.try_recv() {
            Ok(answer) => Some(answer),
            Err(TryRecvError::Empty) => None,
            Err(TryRecvError::Disconnected) => Some(Err(Error::Closed)),
        }
    }

    /// Waits until it is durable, and says which commit has it.
    pub fn wait(self) -> Answer {
        self.0.recv().unwrap_or(Err(Error::Closed))
    }
}

/// The lock of a memory: given back when it is dropped.
///
/// Closing the file would not be enough: a process being started at that moment by another thread has a copy
/// of it until its program is loaded, and the lock would be held for so long.
#[derive(Debug)]
pub(crate) struct Lock(File);

impl Drop for Lock {
    fn drop(&mut self) {
        // What cannot be unlocked is unlocked by closing it.
        let _ = self.0.unlock();
    }
}

/// Takes the lock of a memory; none where another process has it.
pub(crate) fn lock(folder: &Path) -> Result<Option<Lock>, std::io::Error> {
    let file = File::options().create(true).truncate(false).write(true).open(folder.join(LOCK))?;
    match file.try_lock() {
        Ok(()) => Ok(Some(Lock(file))),
        Err(fs::TryLockError::WouldBlock) => Ok(None),
        Err(fs::TryLockError::Error(error)) => Err(error),
    }
}

impl Store {
    /// Opens the memory in a folder, and makes an empty one where there never was any. All that it holds is
    /// looked at first: structure, every row, every total, and whether each reported commit is there.
    pub fn open(folder: &Path, settings: Settings) -> Result<Store, OpenError> {
        if folder.is_file() {
            return Err(OpenError::Missing);
        }
        fs::create_dir_all(folder)?;
        let lock = lock(folder)?.ok_or(OpenError::Busy)?;
        let path = folder.join(DATABASE);
        snapshot::remove_if_there(&folder.join(NEW))?;
        if Whole::is_first_start(folder) {
            create(folder, &settings.control)?;
        }
        let identity = match Whole::look(folder) {
            Whole::Good(identity) => identity,
            Whole::Bad(Verdict::Newer(version)) => return Err(OpenError::Newer(version)),
            Whole::Bad(Verdict::Disk(reason)) => return Err(OpenError::Disk(reason)),
            Whole::Bad(Verdict::Damaged(findings)) => {
                return Err(OpenError::Damaged(Box::new(Damage::new(folder, findings, Some(lock)))));
            }
        };
        if identity.control != settings.control {
            return Err(OpenError::OtherControl(identity.control));
        }
        migrate(folder, &path, identity.schema, settings.snapshots)?;
        let database = Database::open(&path, Access::Write)?;
        let mark = Mark::open(&folder.join(MARK), database.commits())?;
        let reader = Reader::connect(folder)?;
        let rights = Rights::read(&database)?;
        let applier = Applier::new(database, &settings.control)?;
        let (jobs, writer) = writer::start(applier, Some(mark))?;
        let keeper = Arc::new(Keeper::default());
        let keeping = keep(keeper.clone(), folder.to_owned(), settings.clone())?;
        let disk = Some(Disk { folder: folder.to_owned(), keeper, _lock: lock });
        let threads = vec![writer, keeping];
        Ok(Store { settings, jobs, reader, rights, threads, disk })
    }

    /// An empty memory that goes with the process, and is in no file: rights, locks and histories are those of one that is
    /// kept, and nothing is there at the next start.
    pub fn in_memory(control: &str) -> Result<Store, Error> {
        let name = format!("memory-{}", IN_MEMORY.fetch_add(1, Ordering::Relaxed));
        let database = Database::create_in_memory(&name, control)?;
        let reader = Reader { database: Mutex::new(Database::open_in_memory(&name)?) };
        let rights = Rights::read(&database)?;
        let (jobs, writer) = writer::start(Applier::new(database, control)?, None)?;
        let settings = Settings::new(control);
        Ok(Store { settings, jobs, reader, rights, threads: vec![writer], disk: None })
    }

    /// The folder; none where nothing is kept.
    pub fn folder(&self) -> Option<&Path> {
        self.disk.as_ref().map(|disk| &*disk.folder)
    }

    /// The control whose memory it is.
    pub fn control(&self) -> &str {
        &self.settings.control
    }

    /// Reads. What is read was committed.
    pub fn reader(&self) -> &Reader {
        &self.reader
    }

    /// Makes changes together or not at all, and waits until they are durable. Says which commit has them.
    pub fn commit(&self, author: &Author, changes: Vec<Change>) -> Answer {
        self.begin(author, changes)?.wait()
    }

    /// The same without waiting: the changes come with one of the next commits, in the order of the calls. Where
    /// the writer is far behind, or the changes are large, it waits for it.
    pub fn begin(&self, author: &Author, changes: Vec<Change>) -> Result<Pending, Error> {
        let (answer, wait) = sync_channel(1);
        let author = author.clone();
        self.send(Job::Batch { author, changes, answer: Some(answer) })?;
        Ok(Pending(wait))
    }

    /// The same for changes that nobody waits for one by one, such as a loop of a macro program writes them.
    /// [`Store::flush`] waits for all of them, and has the error of any.
    pub fn put(&self, author: &Author, changes: Vec<Change>) -> Result<(), Error> {
        let bytes = |change: &Change| match change {
            Change::Program { text, .. } => text.len(),
            Change::Plc { bytes, .. } => bytes.len(),
            _ => 0,
        };
        if changes.iter().map(bytes).sum::<usize>() > LARGE {
            return self.commit(author, changes).map(drop);
        }
        self.send(Job::Batch { author: author.clone(), changes, answer: None })
    }

    /// Waits until all is durable that was given before, and says the number of the last commit, or the first
    /// error of a change that nobody waited for.
    pub fn flush(&self) -> Answer {
        let (answer, wait) = sync_channel(1);
        self.send(Job::Flush(answer))?;
        wait.recv().unwrap_or(Err(Error::Closed))
    }

    /// What nobody has set is as in `memory` from now on: parameters as the machine file has them beside those of the
    /// control's list, offsets and zeros as the set-up has them.
    pub fn deliver(&self, memory: &Memory) -> Result<(), Error> {
        self.send(Job::Deliver(Box::new(memory.clone())))
    }

    /// Does other work in a commit of its own.
    pub(crate) fn within_commit(
        &self,
        task: impl FnOnce(&mut Applier) -> Result<(), Error> + Send + 'static,
    ) -> Answer {
        let (answer, wait) = sync_channel(1);
        self.send(Job::Task { task: Box::new(task), answer })?;
        wait.recv().unwrap_or(Err(Error::Closed))
    }

    fn send(&self, job: Job) -> Result<(), Error> {
        self.jobs.send(job).map_err(|_| Error::Closed)
    }

    /// Copies the present state as the last good one, once it was found whole, and says its commit; the last commit alone
    /// where nothing is kept.
    pub fn snapshot(&self) -> Result<u64, Error> {
        match &self.disk {
            Some(disk) => disk.keeper.snapshot(&disk.folder, self.settings.snapshots),
            None => self.reader.commits(),
        }
    }

    /// What became of the last snapshot that was made by itself: an error of it, such as a full disk, or damage
    /// that came while the memory was open.
    pub fn trouble(&self) -> Option<Error> {
        self.disk.as_ref().and_then(|disk| held(&disk.keeper.trouble).clone())
    }
}

impl Drop for Store {
    fn drop(&mut self) {
        if let Some(disk) = &self.disk {
            disk.keeper.stop();
        }
        // The writer ends when all that is in the queue was done.
        let _ = self.jobs.send(Job::Stop);
        for thread in self.threads.drain(..) {
            let _ = thread.join();
        }
        // The hourly one comes again; this one saves its time at the next start.
        if let Some(disk) = &self.disk {
            let _ = disk.keeper.snapshot(&disk.folder, self.settings.snapshots);
        }
    }
}

/// Makes an empty memory. Until it has its name there is none, whenever power goes off.
fn create(folder: &Path, control: &str) -> Result<(), Error> {
    let new = folder.join(NEW);
    Database::create(&new, control)?;
    File::open(&new)?.sync_all()?;
    fs::rename(&new, folder.join(DATABASE))?;
    snapshot::sync_folder(folder)
}

/// The thread that takes snapshots.
#[derive(Default)]
struct Keeper {
    stopped: Mutex<bool>,
    changed: Condvar,
    /// One snapshot at a time.
    turn: Mutex<()>,
    trouble: Mutex<Option<Error>>,
}

fn held<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    // What it guards is whole between any two statements.
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

fn keep(keeper: Arc<Keeper>, folder: PathBuf, settings: Settings) -> Result<JoinHandle<()>, Error> {
    let run = move || {
        loop {
            let taken = keeper.snapshot(&folder, settings.snapshots);
            *held(&keeper.trouble) = taken.err();
            let stopped = held(&keeper.stopped);
            let waited =
                keeper.changed.wait_timeout_while(stopped, settings.snapshot_every, |stopped| !*stopped);
            if *waited.unwrap_or_else(PoisonError::into_inner).0 {
                break;
            }
        }
    };
    Ok(std::thread::Builder::new().name("snapshots".into()).spawn(run)?)
}

impl Keeper {
    fn snapshot(&self, folder: &Path, most: usize) -> Result<u64, Error> {
        let _turn = held(&self.turn);
        let database = Database::open(&folder.join(DATABASE), Access::Read)?;
        snapshot::take(folder, &database, most)
    }

    fn stop(&self) {
        *held(&self.stopped) = true;
        self.changed.notify_all();
    }
}

/// Reads a memory, beside the process that writes it or without one.
pub struct Reader {
    database: Mutex<Database>,
}

impl Reader {
    /// Opens the memory in a folder for reading, beside whoever has it open. It is not looked at as a whole; what
    /// is read is whole. Nothing of it changes.
    pub fn open(folder: &Path) -> Result<Reader, OpenError> {
        if Whole::is_first_start(folder) {
            return Err(OpenError::Missing);
        }
        Ok(Reader { database: Mutex::new(Database::open_unchanged(&folder.join(DATABASE))?) })
    }

    fn connect(folder: &Path) -> Result<Reader, Error> {
        Ok(Reader { database: Mutex::new(Database::open(&folder.join(DATABASE), Access::Read)?) })
    }

    /// Reads with all that is read of one moment.
    pub(crate) fn at_once<T>(&self, read: impl FnOnce(&Database) -> Result<T, Error>) -> Result<T, Error> {
        let database = held(&self.database);
        database.begin_reading()?;
        let done = read(&database);
        let ended = database.end_reading();
        done.and_then(|value| ended.map(|()| value))
    }

    /// The number of the last commit.
    pub fn commits(&self) -> Result<u64, Error> {
        held(&self.database).commits_now()
    }

    /// The control whose memory it is.
    pub fn control(&self) -> Result<String, Error> {
        self.at_once(Database::control)
    }

    /// The list of the programs.
    pub fn programs(&self) -> Result<Vec<ProgramEntry>, Error> {
        let found = held(&self.database).sizes(&PROGRAM, "text")?;
        let damaged = || Error::damaged(Finding::Row { table: PROGRAM.name });
        found.into_iter().map(|(row, bytes)| rows::program_entry(row, bytes).ok_or_else(damaged)).collect()
    }

    /// Whether there is a program of this name.
    pub fn has_program(&self, name: &str) -> Result<bool, Error> {
        held(&self.database).has(&PROGRAM, &[name.into()])
    }

    /// A program; none where there is none of this name.
    pub fn program(&self, name: &str) -> Result<Option<Program>, Error> {
        let row = held(&self.database).get(&PROGRAM, &[name.into()])?;
        Ok(row.and_then(rows::program).map(|(_, program)| program))
    }

    /// Items, of one moment.
    pub fn contents(&self, items: &[Item]) -> Result<Contents, Error> {
        self.at_once(|database| contents(database, items))
    }

    /// The newest entries of the operation log, the newest first.
    pub fn log(&self, most: u32) -> Result<Vec<LogEntry>, Error> {
        let mut found = Contents::default();
        held(&self.database).last(rows::table(Item::Log), most, |row| take(&mut found, Item::Log, row))?;
        Ok(found.log)
    }

    /// The newest alarms, the newest first.
    pub fn alarms(&self, most: u32) -> Result<Vec<AlarmEntry>, Error> {
        let mut found = Contents::default();
        held(&self.database)
            .last(rows::table(Item::Alarms), most, |row| take(&mut found, Item::Alarms, row))?;
        Ok(found.alarms)
    }

    /// The rows of each item.
    pub fn counts(&self) -> Result<Vec<(Item, u64)>, Error> {
        self.at_once(|database| {
            let count = |item: Item| Ok((item, database.count_now(rows::table(item))?));
            Item::ALL.into_iter().map(count).collect()
        })
    }

    /// Looks at everything, as at the start, beside the writer; `folder` is that of the memory.
    pub fn check(&self, folder: &Path) -> Result<u64, Vec<Finding>> {
        // What was reported before it is looked at must be there.
        let reported = mark::read(&folder.join(MARK));
        match held(&self.database).verify_open(tables_of) {
            Ok(identity) => match reported {
                Some(reported) if reported > identity.commits => {
                    Err(vec![Finding::CommitsLost { found: identity.commits, reported }])
                }
                None if identity.commits > 0 => Err(vec![Finding::MarkLost]),
                _ => Ok(identity.commits),
            },
            Err(Verdict::Damaged(findings)) => Err(findings),
            Err(other) => Err(vec![Finding::Structure(format!("{other:?}"))]),
        }
    }
}

/// Items of a database.
pub(crate) fn contents(database: &Database, items: &[Item]) -> Result<Contents, Error> {
    let mut found = Contents::default();
    for item in items {
        database.rows(rows::table(*item), |row| take(&mut found, *item, row))?;
    }
    // Both count upwards; the newest comes first.
    found.alarms.reverse();
    found.log.reverse();
    Ok(found)
}

fn take(found: &mut Contents, item: Item, row: Row) -> Result<(), Error> {
    match found.take(item, row) {
        true => Ok(()),
        false => Err(Error::damaged(Finding::Row { table: rows::table(item).name })),
    }
}
