//! Backups: all and single items, what is refused, what a restore leaves alone.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::expect_used)]

mod common;

use common::{CONTROL, all, key, number, open, owner, parameter, program, something, variable};
use ferrocut_geometry::Position;
use ferrocut_machine::WorkOffset;
use ferrocut_memory::{
    Author, Backup, Change, Error, InterruptedRun, Item, LastPosition, Level, Session, Settings, Store,
};
use std::fs;
use tempfile::tempdir;

#[test]
fn all_goes_into_one_file_and_back() {
    let folder = tempdir().unwrap();
    let file = folder.path().join("mill.backup");
    let store = open(&folder.path().join("a"));
    store.commit(&owner(), something(9)).unwrap();
    let binary =
        Change::Program { name: "BIN".into(), text: vec![0, 255, 10, 34], comment: "\"\u{4e2d}".into() };
    let last = LastPosition {
        time: 1,
        position: Position::xyz(1.0, 2.0, 3.0),
        referenced: Default::default(),
        work_system: None,
        own_zero: Some(Position::xyz(0.5, -2.0, 1e-3)),
    };
    let run = InterruptedRun {
        time: 2,
        program: "O1".into(),
        from_line: 1,
        file: "O1".into(),
        line: 3,
        block: 4,
        text: "G1 X1".into(),
        at: Some(Position::xyz(4.0, 5.0, 6.0)),
    };
    let changes = vec![binary, Change::LastPosition(last), Change::Interrupted(Some(run))];
    store.commit(&owner(), changes).unwrap();
    store.set_password(&owner(), Level::Maker, "correct horse", ferrocut_memory::Seat::Machine).unwrap();
    let before = all(&store);
    let entries = store.reader().back_up(&file, &Item::ALL).unwrap();
    assert_eq!(entries.len(), Item::ALL.len());
    assert!(!fs::read_to_string(&file).unwrap().contains("argon2"), "no password leaves the control");
    let other = open(&folder.path().join("b"));
    let backup = Backup::open(&file).unwrap();
    assert_eq!((backup.control(), backup.entries()), (CONTROL, entries.as_slice()));
    backup.restore(&other, &owner(), &backup.items()).unwrap();
    let mut after = all(&other);
    // Where the axes stood is not taken over unless it is asked for.
    assert_eq!(after.last_position, None);
    let told = after.log.remove(0);
    assert_eq!((told.name.as_str(), told.from.as_str()), ("restored", file.to_str().unwrap()));
    after.last_position = before.last_position.clone();
    after.interrupted = before.interrupted.clone();
    assert!(after == before);
    assert_eq!(other.reader().levels_with_password().unwrap(), []);
    backup.restore(&other, &owner(), &[Item::LastPosition, Item::Interrupted]).unwrap();
    let restored = all(&other);
    assert_eq!(restored.last_position, before.last_position);
    assert_eq!(restored.interrupted, before.interrupted);
}

/// A link stays a link, and what is no regular file is left alone.
#[test]
#[cfg(unix)]
fn a_backup_goes_to_what_a_link_leads_to_and_replaces_no_device() {
    let folder = tempdir().unwrap();
    let store = open(&folder.path().join("a"));
    let path = |name: &str| folder.path().join(name);
    let entries = |path: &std::path::Path| Backup::open(path).unwrap().entries().len();
    fs::write(path("old.backup"), "old").unwrap();
    std::os::unix::fs::symlink("old.backup", path("last.backup")).unwrap();
    store.reader().back_up(&path("last.backup"), &Item::ALL).unwrap();
    assert!(fs::symlink_metadata(path("last.backup")).unwrap().is_symlink());
    assert_eq!(entries(&path("old.backup")), Item::ALL.len());
    let socket = std::os::unix::net::UnixListener::bind(path("socket")).unwrap();
    assert!(store.reader().back_up(&path("socket"), &Item::ALL).is_err());
    assert!(!fs::metadata(path("socket")).unwrap().is_file());
    drop(socket);
}

#[test]
fn single_items_leave_the_others_alone() {
    let folder = tempdir().unwrap();
    let file = folder.path().join("some.backup");
    let store = open(&folder.path().join("a"));
    store
        .commit(&owner(), vec![parameter("P270", 1.5), variable(500, Some(1.0)), program("O1", "M30")])
        .unwrap();
    store.reader().back_up(&file, &[Item::Variables, Item::Parameters, Item::Variables]).unwrap();
    let backup = Backup::open(&file).unwrap();
    assert_eq!(backup.items(), [Item::Parameters, Item::Variables]);
    let changed =
        vec![parameter("P270", 5.0), variable(500, None), variable(501, Some(2.0)), program("O2", "M99")];
    store.commit(&owner(), changed).unwrap();
    backup.restore(&store, &owner(), &[Item::Variables]).unwrap();
    let found = all(&store);
    // An item becomes what it was: #501 is empty again.
    assert_eq!(found.variables.into_iter().collect::<Vec<_>>(), [(number(500), 1.0)]);
    assert_eq!(found.parameters[&key("P270")], 5.0);
    assert_eq!(backup.restore(&store, &owner(), &[Item::Offsets]), Err(Error::NotInBackup(Item::Offsets)));
    // Programs are put beside those that there are.
    store.reader().back_up(&file, &[Item::Programs]).unwrap();
    let gone = vec![Change::DeleteProgram { name: "O1".into() }, program("O2", "M30"), program("O3", "M30")];
    store.commit(&owner(), gone).unwrap();
    Backup::open(&file).unwrap().restore(&store, &owner(), &[Item::Programs]).unwrap();
    let programs = all(&store).programs;
    let texts: Vec<_> = programs.iter().map(|(name, p)| (name.as_str(), p.text.as_slice())).collect();
    assert_eq!(texts, [("O1", b"M30".as_slice()), ("O2", b"M99"), ("O3", b"M30")]);
}

#[test]
fn a_restore_keeps_what_the_log_says() {
    let folder = tempdir().unwrap();
    let file = folder.path().join("log.backup");
    let store = open(&folder.path().join("a"));
    store.commit(&owner(), vec![parameter("P270", 1.5)]).unwrap();
    store.reader().back_up(&file, &[Item::Log]).unwrap();
    store.commit(&owner(), vec![parameter("P270", 9.0)]).unwrap();
    let backup = Backup::open(&file).unwrap();
    backup.restore(&store, &owner(), &[Item::Log]).unwrap();
    backup.restore(&store, &owner(), &[Item::Log]).unwrap();
    let told: Vec<String> = all(&store).log.into_iter().map(|e| format!("{} {}", e.name, e.to)).collect();
    assert_eq!(told, ["restored log", "restored log", "P270 9", "P270 1.5"]);
}

#[test]
fn a_level_restores_what_it_may_change() {
    let folder = tempdir().unwrap();
    let file = folder.path().join("all.backup");
    let store = open(&folder.path().join("a"));
    store
        .commit(&owner(), vec![parameter("P88", 6000.0), variable(500, Some(1.0)), program("O90001", "M99")])
        .unwrap();
    store.reader().back_up(&file, &Item::ALL).unwrap();
    let backup = Backup::open(&file).unwrap();
    let operator = Author::Person { session: Session::OPERATOR, name: "Li".into() };
    backup.restore(&store, &operator, &[Item::Variables]).unwrap();
    let refused = Error::Right { needed: Level::Commissioning, level: Level::Operator };
    assert_eq!(backup.restore(&store, &operator, &[Item::Variables, Item::Parameters]), Err(refused));
    // GSK990MC operation 3.4.4, table 3-4-4-2: macro programs need their parameter changed first.
    store
        .set_password(&owner(), Level::Commissioning, "correct horse", ferrocut_memory::Seat::Machine)
        .unwrap();
    let session =
        store.log_in(Level::Commissioning, "correct horse", ferrocut_memory::Seat::Machine, "Li").unwrap();
    let author = Author::Person { session, name: "Li".into() };
    let done = backup.restore(&store, &author, &[Item::Programs]);
    assert_eq!(done, Err(Error::Protected("NO27.4".into())));
    store.commit(&author, vec![parameter("NO27.4", 0.0)]).unwrap();
    backup.restore(&store, &author, &[Item::Programs]).unwrap();
}

#[test]
fn foreign_and_hostile_files_are_refused() {
    let folder = tempdir().unwrap();
    let file = folder.path().join("x.backup");
    let store = open(&folder.path().join("a"));
    store.commit(&owner(), vec![parameter("P270", 1.5)]).unwrap();
    let refused = |bytes: &[u8]| {
        fs::write(&file, bytes).unwrap();
        Backup::open(&file).unwrap_err()
    };
    let sqlite = fs::read(folder.path().join("a/memory.db")).unwrap();
    let pages: Vec<&[u8]> =
        vec![b"", b"\n", b"{}\n", b"G0 X0\nM30\n", b"{\"ferrocut-backup\":true}\n", &sqlite];
    for bytes in pages {
        assert_eq!(refused(bytes), Error::NotABackup);
    }
    assert_eq!(refused(b"{\"ferrocut-backup\":2,\"anything\":[]}\n"), Error::NewerBackup(2));
    let head = r#"{"ferrocut-backup":1,"control":"gsk990mc","time":0,"commits":0,"items":["programs","parameters","variables"]}"#;
    let sealed = |rows: &str| {
        let mut text = format!("{head}\n{rows}");
        let mut sum = blake(text.as_bytes());
        sum = format!("{{\"lines\":{},\"blake2b\":\"{sum}\"}}\n", text.lines().count());
        text.push_str(&sum);
        text
    };
    // The seal alone does not make a row good.
    fs::write(&file, sealed("[\"parameter\",\"P270\",1.5]\n")).unwrap();
    assert_eq!(Backup::open(&file).unwrap().entries()[1].rows, 1);
    for rows in [
        "[\"parameter\",\"P0270\",1.5]\n",
        "[\"parameter\",\"P270\",\"1.5\"]\n",
        "[\"parameter\",\"P270\"]\n",
        "[\"parameter\",\"P270\",1.5]\n[\"parameter\",\"P270\",1.5]\n",
        "[\"parameter\",\"P9\",1]\n[\"parameter\",\"P8\",1]\n",
        "[\"variable\",\"#500\",1]\n[\"parameter\",\"P8\",1]\n",
        "[\"password\",1,\"$argon2id$\"]\n",
        "[\"tool_offset\",1,1,1,1,1,1,1,1]\n",
        "[\"variable\",\"#0\",1]\n",
        "[\"variable\",\"#500\",1e999]\n",
        "[\"program\",\"O1\",\"\",0,0,9,{\"text\":\"M30\"}]\n",
        "[\"program\",\"O1\",\"\",0,0,0,{\"hex\":\"4d3\"}]\n",
        "[\"program\",\"O1\",\"\",0,0,0,{\"text\":\"M30\",\"hex\":\"\"}]\n",
        "\n",
        "[]\n",
        "7\n",
    ] {
        assert_eq!(
            refused(sealed(rows).as_bytes()),
            Error::BackupDamaged(2 + u64::from(rows.lines().count() == 2)),
            "{rows}"
        );
    }
    // Depth, width and length of a line.
    for row in
        [format!("{}\n", "[".repeat(1 << 20)), format!("[{}1]\n", "1,".repeat(1 << 20)), "9".repeat(40 << 20)]
    {
        assert!(matches!(refused(sealed(&row).as_bytes()), Error::BackupDamaged(_)));
    }
    assert_eq!(refused(format!("{}\n", " ".repeat(1 << 20)).as_bytes()), Error::NotABackup);
    // Values that the control does not take change nothing, nor does the memory of another control.
    for row in
        ["[\"parameter\",\"P270\",-7.0]\n", "[\"parameter\",\"P3\",7.0]\n", "[\"parameter\",\"P15\",7.0]\n"]
    {
        fs::write(&file, sealed(row)).unwrap();
        let done = Backup::open(&file).unwrap().restore(&store, &owner(), &[Item::Parameters]);
        assert!(matches!(done, Err(Error::Parameter(_) | Error::Value(_))), "{row}: {done:?}");
        assert_eq!(all(&store).parameters[&key("P270")], 1.5);
    }
    let other = Store::open(&folder.path().join("w"), Settings::new("weihong")).unwrap();
    fs::write(&file, sealed("")).unwrap();
    let done = Backup::open(&file).unwrap().restore(&other, &owner(), &[Item::Parameters]);
    assert_eq!(done, Err(Error::OtherControl(CONTROL.into())));
    let zero = Change::WorkZero { name: WorkOffset::Additional(51), zero: Position::ZERO };
    assert!(matches!(store.commit(&owner(), vec![zero]), Err(Error::Value(_))));
}

/// BLAKE2b-256 in hexadecimal digits.
fn blake(bytes: &[u8]) -> String {
    use blake2::digest::consts::U32;
    use blake2::{Blake2b, Digest};
    Blake2b::<U32>::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}
