//! Computed pockets beside the program that they are of: NAME.C2D and NAME.C3D (Fagor 4.15.1, 4.16.1).
//!
//! A program only says what a pocket is called. Whether anything is kept, and where, is decided here: in the
//! program's own folder, under a name of letters and digits, and never over a file that Ferrocut did not
//! write. Files are written whole or not at all; one that is damaged, or of other inputs, is written anew.

use ferrocut_interpreter::cycles::pocket::{KeptPockets, PocketKind, is_stored};
use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

/// Largest file, bytes: a pocket of as many moves as one may have takes less.
const LARGEST: u64 = 1 << 29;

/// Characters of a name.
const LONGEST_NAME: usize = 60;

/// Names that belong to devices on Windows, whatever the extension.
const DEVICES: &[&str] = &["con", "prn", "aux", "nul"];

/// The folder of a program.
pub struct BesideProgram {
    folder: PathBuf,
    writes: bool,
}

impl BesideProgram {
    /// The place beside a program; only looked at where `writes` is false. None for a program that is no file.
    pub fn of(program: &Path, writes: bool) -> Option<BesideProgram> {
        let folder = program.parent().map(|p| if p.as_os_str().is_empty() { Path::new(".") } else { p });
        let folder = folder.filter(|_| program.is_file())?.to_path_buf();
        Some(BesideProgram { folder, writes })
    }

    /// The file of a pocket; none for a name that is no file name everywhere.
    fn file(&self, name: &str, kind: PocketKind) -> Option<PathBuf> {
        let plain = |c: char| c.is_alphanumeric() || matches!(c, '-' | '_');
        let lower = name.to_lowercase();
        let port = |of: &str| lower.strip_prefix(of).is_some_and(|n| n.chars().count() == 1);
        let is_device = DEVICES.contains(&lower.as_str()) || port("com") || port("lpt");
        let is_name = !name.is_empty() && name.chars().count() <= LONGEST_NAME && name.chars().all(plain);
        let extension = match kind {
            PocketKind::Flat => ".C2D",
            PocketKind::Deep => ".C3D",
        };
        let mut file = OsString::from(name);
        file.push(extension);
        (is_name && !is_device).then(|| self.folder.join(file))
    }

    /// Writes a file under another name first, so that nobody ever meets half of it.
    fn write(&self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        let is_free = match fs::symlink_metadata(path) {
            Err(error) => error.kind() == io::ErrorKind::NotFound,
            Ok(there) if !there.is_file() => false,
            Ok(_) => {
                let mut start = Vec::new();
                File::open(path)?.take(64).read_to_end(&mut start)?;
                is_stored(&start)
            }
        };
        if !is_free {
            return Ok(());
        }
        let mut builder = tempfile::Builder::new();
        builder.prefix(".pocket").suffix(".tmp");
        // Whoever may read the program may read what was computed of it.
        #[cfg(unix)]
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
        let mut file = builder.tempfile_in(&self.folder)?;
        file.write_all(bytes)?;
        file.persist(path)?;
        Ok(())
    }
}

impl KeptPockets for BesideProgram {
    fn load(&self, name: &str, kind: PocketKind) -> Option<Vec<u8>> {
        let path = self.file(name, kind)?;
        let there = fs::symlink_metadata(&path).ok()?;
        if !there.is_file() || there.len() > LARGEST {
            return None;
        }
        let mut bytes = Vec::new();
        File::open(path).ok()?.take(LARGEST).read_to_end(&mut bytes).ok()?;
        Some(bytes)
    }

    fn keep(&self, name: &str, kind: PocketKind, bytes: &[u8]) {
        let Some(path) = self.file(name, kind).filter(|_| self.writes) else { return };
        if bytes.len() as u64 <= LARGEST {
            // A folder that cannot be written costs time at the next run, and nothing else.
            let _ = self.write(&path, bytes);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_stay_in_the_folder() {
        let beside = BesideProgram { folder: PathBuf::from("parts"), writes: true };
        let file = |name: &str| beside.file(name, PocketKind::Flat);
        assert_eq!(file("FAGOR-A"), Some(PathBuf::from("parts/FAGOR-A.C2D")));
        assert_eq!(beside.file("型腔_1", PocketKind::Deep), Some(PathBuf::from("parts/型腔_1.C3D")));
        let long = "A".repeat(61);
        for name in
            ["", ".", "..", "../P1", "/etc/P1", "a/b", "a\\b", "C:P1", "P1.nc", "a b", "NUL", "Com1", &long]
        {
            assert_eq!(file(name), None, "{name}");
        }
    }
}
