//! Computed pockets beside the program (Fagor 4.15.1, 4.16.1): kept, rebuilt, never trusted.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{command, ferrocut, with_input, write};
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

const PROGRAM: &str = "#PROFILE A [XY]\nG0 X0 Y0\nG1 X60\nY40\nX0\nY0\nG0 X20 Y20\nG2 X20 Y20 I6\n#ENDPROFILE\n\
    #PROFILE S [XZ]\nG0 X0 Z0\nG1 X2 Z-6\n#ENDPROFILE\n\
    #CYCLE P2D [pocket=FLAT-1, profile=A, Z=0, ZS=5, P=6]\n#ROUGH [T=1, F=600, S=1000, I=3]\n\
    #CYCLE P3D [pocket=DEEP-1, profile=A, Z1=S, Z=0, ZS=5, P=6]\n#ROUGH [T=1, F=600, S=1000, I1=3]\nM30\n";

const SETUP: &str = "dialect = \"fagor8065\"\n[start]\nz = 50\n[tools.1]\nradius = 3\nentry_angle = 5\n";

struct Shop {
    folder: tempfile::TempDir,
    program: String,
    setup: String,
}

impl Shop {
    fn new(program: &str) -> Shop {
        let folder = tempfile::tempdir().unwrap();
        let (program, setup) = (write(&folder, "part.nc", program), write(&folder, "part.toml", SETUP));
        Shop { folder, program, setup }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn does(&self, what: &str) -> String {
        let answer = ferrocut(&[what, &self.program, "--setup", &self.setup]);
        assert_eq!(answer.code, 0, "{} {}", answer.out, answer.err);
        answer.out
    }

    /// The files beside the program and its set-up.
    fn files(&self) -> Vec<String> {
        let names = fs::read_dir(self.folder.path()).unwrap().map(|e| e.unwrap().file_name());
        let mut names: Vec<String> = names.map(|name| name.into_string().unwrap()).collect();
        names.retain(|name| !name.starts_with("part."));
        names.sort();
        names
    }
}

/// Long ago, to see whether a file is written again.
fn long_ago() -> SystemTime {
    SystemTime::UNIX_EPOCH + Duration::from_secs(1_000_000_000)
}

fn age(path: &Path) {
    File::options().write(true).open(path).unwrap().set_modified(long_ago()).unwrap();
}

fn is_kept(path: &Path) -> bool {
    fs::metadata(path).unwrap().modified().unwrap() == long_ago()
}

#[test]
fn kept_while_nothing_changes_and_rebuilt_when_anything_does() {
    let shop = Shop::new(PROGRAM);
    let computed = shop.does("trace");
    assert_eq!(shop.files(), [""; 0], "a trace only looks");
    shop.does("time");
    let names = ["DEEP-1.C3D", "FLAT-1.C2D"];
    assert_eq!(shop.files(), names);
    let paths = names.map(|name| shop.path(name));
    let first = paths.each_ref().map(|path| fs::read(path).unwrap());
    // The same again, of what was kept.
    paths.iter().for_each(|path| age(path));
    shop.does("run");
    assert!(paths.iter().all(|path| is_kept(path)));
    assert_eq!(shop.does("trace"), computed);
    // Another tool: both are computed anew, and the way is another.
    write(&shop.folder, "part.toml", SETUP.replace("radius = 3", "radius = 4"));
    let other = shop.does("trace");
    assert_ne!(other, computed);
    shop.does("time");
    for (path, first) in paths.iter().zip(&first) {
        assert!(!is_kept(path) && fs::read(path).unwrap() != *first, "{path:?}");
        age(path);
    }
    assert_eq!(shop.does("trace"), other);
    // Another depth profile: only the 3D pocket is another.
    write(&shop.folder, "part.nc", PROGRAM.replace("X2 Z-6", "X3 Z-6"));
    shop.does("time");
    assert!(!is_kept(&paths[0]) && is_kept(&paths[1]));
}

#[test]
fn damaged_files_are_found_and_written_anew() {
    let shop = Shop::new(PROGRAM);
    shop.does("time");
    let computed = shop.does("trace");
    let path = shop.path("FLAT-1.C2D");
    let whole = fs::read(&path).unwrap();
    let middle = whole.len() / 2;
    let mut flipped = whole.clone();
    flipped[middle] ^= 1;
    let longer = [whole.as_slice(), b"x"].concat();
    for damaged in [flipped.as_slice(), &whole[..middle], &longer, &whole[..20]] {
        fs::write(&path, damaged).unwrap();
        assert_eq!(shop.does("trace"), computed);
        shop.does("time");
        assert_eq!(fs::read(&path).unwrap(), whole);
    }
    assert_eq!(shop.files().len(), 2, "nothing else is left behind");
}

#[test]
fn files_of_others_are_left_alone() {
    let shop = Shop::new(PROGRAM);
    // One of the control itself, and a folder of that name.
    write(&shop.folder, "FLAT-1.C2D", "of another kind");
    fs::create_dir(shop.path("DEEP-1.C3D")).unwrap();
    shop.does("time");
    assert_eq!(fs::read(shop.path("FLAT-1.C2D")).unwrap(), b"of another kind");
    assert_eq!(shop.files().len(), 2);
}

/// A name that would lead out of the folder keeps nothing; the pocket is cut all the same.
#[test]
fn a_program_cannot_say_where() {
    for name in ["../OUT", "\"../OUT\"", "/tmp/OUT", "SUB/OUT", "..", ".hidden", "NUL"] {
        let shop = Shop::new(&PROGRAM.replace("pocket=FLAT-1", &format!("pocket={name}")));
        fs::create_dir(shop.path("part.SUB")).unwrap();
        let _ = ferrocut(&["time", &shop.program, "--setup", &shop.setup]);
        let files = shop.files();
        assert!(files.iter().all(|file| file == "DEEP-1.C3D"), "{name}: {files:?}");
    }
    assert!(!Path::new("/tmp/OUT.C2D").exists());
}

#[cfg(unix)]
#[test]
fn a_link_is_not_followed() {
    let elsewhere = tempfile::tempdir().unwrap();
    let shop = Shop::new(PROGRAM);
    let target = elsewhere.path().join("FLAT-1.C2D");
    std::os::unix::fs::symlink(&target, shop.path("FLAT-1.C2D")).unwrap();
    shop.does("time");
    assert!(!target.exists());
}

#[cfg(unix)]
#[test]
fn a_folder_that_may_not_be_written_costs_nothing() {
    use std::os::unix::fs::PermissionsExt;
    let shop = Shop::new(PROGRAM);
    let mode = |mode| fs::set_permissions(shop.folder.path(), fs::Permissions::from_mode(mode)).unwrap();
    mode(0o555);
    shop.does("time");
    mode(0o755);
}

#[test]
fn a_program_without_a_file_keeps_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let setup = write(&folder, "part.toml", SETUP);
    let answer = with_input(&["time", "-", "--setup", &setup], PROGRAM);
    assert_eq!(answer.code, 0, "{}", answer.err);
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    // Nor does a check.
    let program = write(&folder, "part.nc", PROGRAM);
    assert!(command(&["check", &program, "--setup", &setup]).output().unwrap().status.success());
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2);
}
