//! Passwords of the levels: hashed with argon2id, never stored otherwise, and never in a backup.
//!
//! # Why nobody has the upper levels at first
//!
//! A default password would be known to everyone who has the manual, and would work on every machine where nobody
//! changed it. So a new control has no password at all, and a level without one is locked: nobody logs in to it.
//! The first password is that of level 1, and it is set by who stands at the machine ([`Seat::Machine`]); over the
//! network it cannot be set. Every other password is set by who is logged in with that level or a higher one.
//! Should the passwords be lost, whoever has the files of the control in hand sets one with `ferrocut memory
//! password`.
//!
//! # Tries
//!
//! After three wrong passwords the next try must wait: 1 s, then twice as long each time, up to five minutes. The
//! tries are counted for each level, those at the machine apart from those over the network, so that nobody far
//! away keeps the person at the machine out. The count is stored before the password is looked at: neither a
//! restart nor many tries at once bring more of them.

use crate::author::{Author, Session};
use crate::database::Database;
use crate::error::Error;
use crate::items::{LogEntry, now};
use crate::rights::Level;
use crate::store::{Reader, Store};
use crate::table::{Cell, PASSWORD, TRIES};
use argon2::Argon2;
use argon2::password_hash::{PasswordHasher, PasswordVerifier};
use std::collections::BTreeMap;
use std::sync::{Mutex, TryLockError};
use std::time::{Duration, Instant};

/// Shortest password, characters.
pub const SHORTEST: usize = 8;

/// Longest password, bytes: bounds the work of a try.
pub const LONGEST: usize = 256;

/// Wrong passwords that are free.
const FREE_TRIES: u32 = 3;

/// Longest wait between two tries.
const LONGEST_WAIT: Duration = Duration::from_secs(300);

/// Where a password is given.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Seat {
    /// At the machine's own panel.
    Machine,
    /// From elsewhere.
    Network,
}

impl Seat {
    fn name(self) -> &'static str {
        match self {
            Seat::Machine => "machine",
            Seat::Network => "network",
        }
    }
}

/// How long the next try must wait after so many wrong ones.
fn wait_after(failed: u32) -> Duration {
    match failed.checked_sub(FREE_TRIES) {
        None => Duration::ZERO,
        Some(more) => Duration::from_secs(1u64.checked_shl(more).unwrap_or(u64::MAX)).min(LONGEST_WAIT),
    }
}

/// Wrong tries of a level.
#[derive(Clone, Copy)]
struct Tries {
    failed: u32,
    /// When the last one was, or when the memory was opened after it: no change of the clock shortens a wait.
    since: Instant,
}

/// Wrong tries, for each seat under a lock of its own: one try at a time.
pub(crate) struct Rights {
    machine: Mutex<BTreeMap<Level, Tries>>,
    network: Mutex<BTreeMap<Level, Tries>>,
}

impl Rights {
    pub(crate) fn read(database: &Database) -> Result<Rights, Error> {
        let (mut machine, mut network) = (BTreeMap::new(), BTreeMap::new());
        let since = Instant::now();
        database.rows(&TRIES, |row| {
            if let [Cell::Whole(level), Cell::Text(seat), Cell::Whole(failed)] = row.as_slice()
                && let Some(level) = Level::of(*level)
            {
                let failed = u32::try_from(*failed).unwrap_or(u32::MAX);
                let of_seat = if seat == Seat::Machine.name() { &mut machine } else { &mut network };
                of_seat.insert(level, Tries { failed, since });
            }
            Ok(())
        })?;
        Ok(Rights { machine: Mutex::new(machine), network: Mutex::new(network) })
    }

    fn of(&self, seat: Seat) -> &Mutex<BTreeMap<Level, Tries>> {
        match seat {
            Seat::Machine => &self.machine,
            Seat::Network => &self.network,
        }
    }
}

impl Reader {
    /// The levels that have a password.
    pub fn levels_with_password(&self) -> Result<Vec<Level>, Error> {
        let mut levels = Vec::new();
        self.at_once(|database| {
            database.rows(&PASSWORD, |row| {
                if let Some(Cell::Whole(level)) = row.first() {
                    levels.extend(Level::of(*level));
                }
                Ok(())
            })
        })?;
        Ok(levels)
    }
}

impl Store {
    fn hash_of(&self, level: Level) -> Result<Option<String>, Error> {
        let key = [Cell::from(level.number())];
        let row = self.reader().at_once(|database| database.get(&PASSWORD, &key))?;
        Ok(row.and_then(|row| match row.into_iter().nth(1) {
            Some(Cell::Text(hash)) => Some(hash),
            _ => None,
        }))
    }

    /// Logs a person in with a level. The log has it, and each wrong try.
    pub fn log_in(&self, level: Level, password: &str, seat: Seat, who: &str) -> Result<Session, Error> {
        if level == Level::Operator {
            return Ok(Session::OPERATOR);
        }
        let hash = self.hash_of(level)?.ok_or(Error::NoPassword(level))?;
        // Who comes while another try is under way comes again.
        let mut tries = match self.rights.of(seat).try_lock() {
            Ok(tries) => tries,
            Err(TryLockError::Poisoned(poisoned)) => poisoned.into_inner(),
            Err(TryLockError::WouldBlock) => return Err(Error::Wait(Duration::from_secs(1))),
        };
        let before = tries.get(&level).copied();
        let failed = before.map_or(0, |before| before.failed);
        if let Some(before) = before {
            let left = wait_after(before.failed).saturating_sub(before.since.elapsed());
            if !left.is_zero() {
                return Err(Error::Wait(left));
            }
        }
        let failed = failed.saturating_add(1);
        // Counted before it is looked at.
        self.count_try(level, seat, failed, None)?;
        tries.insert(level, Tries { failed, since: Instant::now() });
        let fits = password.len() <= LONGEST
            && Argon2::default().verify_password(password.as_bytes(), hash.as_str()).is_ok();
        let entry = LogEntry {
            time: now(),
            level: Some(level),
            who: who.to_owned(),
            item: "rights".to_owned(),
            name: format!("log in {}", level.number()),
            from: seat.name().to_owned(),
            to: if fits { "right" } else { "wrong" }.to_owned(),
        };
        if !fits {
            // The wait is counted from the end of the try.
            tries.insert(level, Tries { failed, since: Instant::now() });
            self.count_try(level, seat, failed, Some(entry))?;
            return Err(Error::WrongPassword);
        }
        self.count_try(level, seat, 0, Some(entry))?;
        tries.remove(&level);
        Ok(Session { level })
    }

    fn count_try(&self, level: Level, seat: Seat, failed: u32, entry: Option<LogEntry>) -> Result<(), Error> {
        self.within_commit(move |applier| {
            let key = [Cell::from(level.number()), seat.name().into()];
            match failed {
                0 => drop(applier.database.delete(&TRIES, &key)?),
                failed => {
                    let [level, seat] = key;
                    applier.database.put(&TRIES, &[level, seat, failed.into()])?;
                }
            }
            entry.map_or(Ok(()), |entry| applier.log(&entry))
        })
        .map(drop)
    }

    /// Sets the password of a level. The log has that it was set.
    ///
    /// Who is logged in with the level or a higher one may; whoever stands at the machine may set that of level 1
    /// while no level has any; the author of maintenance may.
    pub fn set_password(
        &self,
        author: &Author,
        level: Level,
        password: &str,
        seat: Seat,
    ) -> Result<(), Error> {
        let own = match author {
            Author::Maintenance { .. } => None,
            Author::Person { session, .. } => Some(session.level()),
            Author::Program { .. } | Author::Control => return Err(Error::NotByThis),
        };
        if level == Level::Operator {
            return Err(Error::NoPassword(level));
        }
        if password.chars().count() < SHORTEST || password.len() > LONGEST {
            return Err(Error::PasswordLength);
        }
        if let Some(own) = own
            && !own.covers(level)
        {
            let is_first = level == Level::Maker
                && seat == Seat::Machine
                && self.reader().levels_with_password()?.is_empty();
            if !is_first {
                return Err(Error::Right { needed: level, level: own });
            }
        }
        let hash = Argon2::default()
            .hash_password(password.as_bytes())
            .map_err(|error| Error::Disk(error.to_string()))?
            .to_string();
        let first_only = own.is_some_and(|own| !own.covers(level));
        let entry = LogEntry {
            time: now(),
            level: own,
            who: author.name().to_owned(),
            item: "rights".to_owned(),
            name: format!("password {}", level.number()),
            from: seat.name().to_owned(),
            to: "set".to_owned(),
        };
        self.within_commit(move |applier| {
            // Two who claim a new control at once: the second comes too late.
            if first_only && applier.database.count(&PASSWORD) > 0 {
                return Err(Error::Right { needed: level, level: Level::Operator });
            }
            applier.database.put(&PASSWORD, &[level.number().into(), hash.into()])?;
            for seat in [Seat::Machine, Seat::Network] {
                applier.database.delete(&TRIES, &[level.number().into(), seat.name().into()])?;
            }
            applier.log(&entry)
        })?;
        for seat in [Seat::Machine, Seat::Network] {
            if let Ok(mut tries) = self.rights.of(seat).lock() {
                tries.remove(&level);
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn waits_double_up_to_five_minutes() {
        let seconds: Vec<u64> = [0, 2, 3, 4, 5, 11, 12, 66, 67, 68, u32::MAX]
            .into_iter()
            .map(|failed| wait_after(failed).as_secs())
            .collect();
        assert_eq!(seconds, [0, 0, 1, 2, 4, 256, 300, 300, 300, 300, 300]);
    }
}
