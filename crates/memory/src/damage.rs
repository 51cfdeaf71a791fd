//! Damage: what was found, which good states there are, and going back to one.

use crate::author::Author;
use crate::database::{Access, Database, Identity, Verdict};
use crate::error::{Error, Finding};
use crate::items::{LogEntry, Time, now};
use crate::mark::{self, Mark};
use crate::migrate::tables_of;
use crate::snapshot::{self, remove_if_there, sync_folder};
use crate::store::{self, DATABASE, MARK, NEW, OpenError, Reader, Settings, Store};
use std::fs::{self, File};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::time::UNIX_EPOCH;

/// Beginning of the names of folders that keep what was damaged.
const ASIDE: &str = "damaged-";

/// What looking at a memory found.
pub(crate) enum Whole {
    Good(Identity),
    Bad(Verdict),
}

impl Whole {
    /// Whether there never was a memory here.
    pub(crate) fn is_first_start(folder: &Path) -> bool {
        let is_there = |name: &str| folder.join(name).exists();
        !is_there(DATABASE)
            && !is_there(MARK)
            && snapshot::list(folder).is_empty()
            && match fs::read_dir(folder) {
                Ok(mut entries) => entries
                    .all(|entry| entry.is_ok_and(|e| !e.file_name().to_string_lossy().starts_with(ASIDE))),
                Err(error) => matches!(error.kind(), ErrorKind::NotFound | ErrorKind::NotADirectory),
            }
    }

    /// Looks at the memory of a folder.
    pub(crate) fn look(folder: &Path) -> Whole {
        let path = folder.join(DATABASE);
        if !path.exists() {
            return Whole::Bad(Verdict::Damaged(vec![Finding::Missing]));
        }
        match Database::verify(&path, Access::Read, tables_of) {
            Err(verdict) => Whole::Bad(verdict),
            Ok(identity) => match mark::read(&folder.join(MARK)) {
                Some(reported) if reported > identity.commits => {
                    let found = identity.commits;
                    Whole::Bad(Verdict::Damaged(vec![Finding::CommitsLost { found, reported }]))
                }
                // Power went off before the first mark was made; there was no snapshot then.
                None if identity.commits == 0 && snapshot::list(folder).is_empty() => Whole::Good(identity),
                None => Whole::Bad(Verdict::Damaged(vec![Finding::MarkLost])),
                Some(_) => Whole::Good(identity),
            },
        }
    }
}

/// Where a good state is.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Source {
    /// The database itself: it is whole, but lacks commits that were reported.
    Database,
    /// A snapshot.
    Snapshot(PathBuf),
}

/// A state that was found whole.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct GoodState {
    /// Where it is.
    pub source: Source,
    /// The control whose memory it is.
    pub control: String,
    /// Commits that it has.
    pub commits: u64,
    /// Commits that were reported and that it lacks; none where nobody knows.
    pub missing: Option<u64>,
    /// When it was last written.
    pub time: Time,
}

/// Looks at the memory of a folder, whether another process has it open or not, and changes nothing. Says the
/// number of its last commit.
pub fn check(folder: &Path) -> Result<u64, OpenError> {
    if Whole::is_first_start(folder) {
        return Err(OpenError::Missing);
    }
    let damaged = |findings, lock| OpenError::Damaged(Box::new(Damage::new(folder, findings, lock)));
    let Some(lock) = store::lock(folder)? else {
        return Reader::open(folder)?.check(folder).map_err(|findings| damaged(findings, None));
    };
    match Whole::look(folder) {
        Whole::Good(identity) => Ok(identity.commits),
        Whole::Bad(Verdict::Damaged(findings)) => Err(damaged(findings, Some(lock))),
        Whole::Bad(Verdict::Newer(version)) => Err(OpenError::Newer(version)),
        Whole::Bad(Verdict::Disk(reason)) => Err(OpenError::Disk(reason)),
    }
}

/// A damaged memory. Nothing of it was changed; it stays locked for others until a state is chosen or this is
/// dropped.
#[derive(Debug)]
pub struct Damage {
    folder: PathBuf,
    findings: Vec<Finding>,
    states: Vec<GoodState>,
    /// None where another process has the memory open.
    lock: Option<store::Lock>,
}

fn written(path: &Path) -> Time {
    let time = fs::metadata(path).and_then(|data| data.modified()).ok();
    let since = time.and_then(|time| time.duration_since(UNIX_EPOCH).ok()).unwrap_or_default();
    Time::try_from(since.as_millis()).unwrap_or(0)
}

impl Damage {
    pub(crate) fn new(folder: &Path, findings: Vec<Finding>, lock: Option<store::Lock>) -> Damage {
        let reported = mark::read(&folder.join(MARK));
        let state = |source, identity: Identity, time| GoodState {
            source,
            commits: identity.commits,
            missing: reported.map(|reported| reported.saturating_sub(identity.commits)),
            control: identity.control,
            time,
        };
        let mut states = Vec::new();
        let path = folder.join(DATABASE);
        if path.exists()
            && let Ok(identity) = Database::verify(&path, Access::Read, tables_of)
        {
            states.push(state(Source::Database, identity, written(&path)));
        }
        for (_, path) in snapshot::list(folder) {
            if let Ok(identity) = Database::verify(&path, Access::Untouched, tables_of) {
                let time = written(&path);
                states.push(state(Source::Snapshot(path), identity, time));
            }
        }
        // The sort is stable: of two that are alike the database comes first.
        states.sort_by_key(|state| std::cmp::Reverse(state.commits));
        Damage { folder: folder.to_owned(), findings, states, lock }
    }

    /// What was found.
    pub fn findings(&self) -> &[Finding] {
        &self.findings
    }

    /// The states that are whole, the newest first. None of them may be left: then a backup is restored into a
    /// new folder.
    pub fn states(&self) -> &[GoodState] {
        &self.states
    }

    /// Takes one of the states up, keeps the damaged files aside, and opens the memory. Says where they are.
    ///
    /// Power may go off at any moment: until the state is in place the damage is found again.
    pub fn recover(
        self,
        state: &GoodState,
        settings: Settings,
        author: &Author,
    ) -> Result<(Store, PathBuf), OpenError> {
        let folder = self.folder.clone();
        let lock = match self.lock {
            Some(lock) => lock,
            None => store::lock(&folder)?.ok_or(OpenError::Busy)?,
        };
        let new = folder.join(NEW);
        remove_if_there(&new)?;
        match &state.source {
            Source::Database => {
                let database = Database::open_unchanged(&folder.join(DATABASE))?;
                database.copy_to(&new)?;
            }
            Source::Snapshot(path) => drop(fs::copy(path, &new)?),
        }
        let whole = Database::verify(&new, Access::Untouched, tables_of);
        let identity = whole.map_err(|verdict| OpenError::Disk(format!("{verdict:?}")))?;
        File::open(&new)?.sync_all()?;
        let aside = set_aside(&folder)?;
        // Commits are counted on from here: a later number would soon be that of another state.
        for (_, path) in snapshot::list(&folder).into_iter().filter(|(n, _)| *n > identity.commits) {
            if let Some(name) = path.file_name() {
                fs::rename(&path, aside.join(name))?;
            }
        }
        // What is left of the damaged log must not be played into the good state.
        for name in ["memory.db-wal", "memory.db-shm"] {
            remove_if_there(&folder.join(name))?;
        }
        fs::rename(&new, folder.join(DATABASE))?;
        sync_folder(&folder)?;
        remove_if_there(&folder.join(MARK))?;
        drop(Mark::open(&folder.join(MARK), identity.commits)?);
        sync_folder(&folder)?;
        let from = self.findings.first().map(ToString::to_string).unwrap_or_default();
        drop(lock);
        let store = Store::open(&folder, settings)?;
        let entry = LogEntry {
            time: now(),
            level: author.level(),
            who: author.name().to_owned(),
            item: "memory".to_owned(),
            name: "recovered".to_owned(),
            from,
            to: identity.commits.to_string(),
        };
        store.within_commit(move |applier| applier.log(&entry))?;
        Ok((store, aside))
    }
}

/// Copies the files of a damaged memory into a folder of their own. What cannot be copied is moved.
fn set_aside(folder: &Path) -> Result<PathBuf, Error> {
    let mut aside = folder.join(format!("{ASIDE}{}", now()));
    while aside.exists() {
        aside.as_mut_os_string().push("-");
    }
    fs::create_dir(&aside)?;
    for name in [DATABASE, "memory.db-wal", MARK] {
        let (from, to) = (folder.join(name), aside.join(name));
        if from.exists() && fs::copy(&from, &to).and_then(|_| File::open(&to)?.sync_all()).is_err() {
            fs::rename(&from, &to)?;
        }
    }
    sync_folder(&aside)?;
    sync_folder(folder)?;
    Ok(aside)
}
