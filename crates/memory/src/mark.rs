//! A second witness of how many commits were reported as done.
//!
//! SQLite takes a write-ahead log that is damaged for one that ends there, and so goes back to an older state
//! without a word. The mark holds the number of the last commit that was reported; a database with fewer is
//! damaged. It is written after each commit and before anyone is told of it, without waiting for the disk: after
//! a kill it is exact, after a power cut it may be a few seconds older than the database, never newer.
//!
//! It is there twice, so that damage to one of them leaves the number exact: the other one alone would be older than
//! the last commit, and hide its loss.

use crate::error::Error;
use blake2::digest::consts::U8;
use blake2::{Blake2b, Digest};
use std::fs::{File, OpenOptions};
use std::io::{Read, Seek, SeekFrom, Write};
use std::path::Path;

/// Bytes of a slot: the number of the commit and its sum, little end first.
const SLOT: usize = 16;

/// The mark, open for writing.
pub struct Mark {
    file: File,
}

fn slot_bytes(commits: u64) -> [u8; SLOT] {
    let mut bytes = [0; SLOT];
    let mut hash = Blake2b::<U8>::new();
    hash.update(b"mark");
    hash.update(commits.to_le_bytes());
    let parts = commits.to_le_bytes().into_iter().chain(hash.finalize());
    for (to, from) in bytes.iter_mut().zip(parts) {
        *to = from;
    }
    bytes
}

fn slot_value(bytes: &[u8]) -> Option<u64> {
    let commits = u64::from_le_bytes(bytes.get(..8)?.try_into().ok()?);
    (slot_bytes(commits) == bytes).then_some(commits)
}

/// The number of the last commit that was reported; none where the mark is not there or cannot be read.
pub fn read(path: &Path) -> Option<u64> {
    let mut bytes = Vec::new();
    File::open(path).ok()?.take(2 * SLOT as u64).read_to_end(&mut bytes).ok()?;
    bytes.chunks(SLOT).filter_map(slot_value).max()
}

impl Mark {
    /// Opens the mark for writing, and makes it where it is not there.
    pub fn open(path: &Path, commits: u64) -> Result<Mark, Error> {
        let file = OpenOptions::new().write(true).create(true).truncate(false).open(path)?;
        let mut mark = Mark { file };
        mark.set(commits)?;
        mark.sync()?;
        Ok(mark)
    }

    /// Writes the number of a commit.
    pub fn set(&mut self, commits: u64) -> Result<(), Error> {
        self.file.seek(SeekFrom::Start(0))?;
        Ok(self.file.write_all(&[slot_bytes(commits); 2].concat())?)
    }

    /// Waits until the disk has it.
    pub fn sync(&self) -> Result<(), Error> {
        Ok(self.file.sync_all()?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_whole_slot_is_enough() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("mark");
        assert_eq!(read(&path), None);
        let mut mark = Mark::open(&path, 7).unwrap();
        assert_eq!(read(&path), Some(7));
        mark.set(8).unwrap();
        mark.set(9).unwrap();
        assert_eq!(read(&path), Some(9));
        let whole = std::fs::read(&path).unwrap();
        for byte in 0..whole.len() {
            let mut damaged = whole.clone();
            damaged[byte] ^= 0x10;
            std::fs::write(&path, &damaged).unwrap();
            assert_eq!(read(&path), Some(9), "{byte}");
        }
        std::fs::write(&path, &whole[..5]).unwrap();
        assert_eq!(read(&path), None);
    }
}
