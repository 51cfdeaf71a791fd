//! The memory in one file, and back.
//!
//! A backup is text in UTF-8, a JSON value a line, so that any tool reads it and two of them can be compared:
//!
//! ```text
//! {"ferrocut-backup":1,"control":"gsk990mc","time":1760000000000,"commits":42,"items":["parameters","zeros"]}
//! ["parameter","P270",1.5]
//! ["work_zero","G54",10.0,10.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0]
//! {"lines":3,"blake2b":"…"}
//! ```
//!
//! The first line says what it is. Each row is the name of its table (`table.rs`) and its cells, in the order of the
//! items and of the keys; bytes are `{"text":"…"}` or `{"hex":"…"}`. The last line has the number of lines before
//! it and their BLAKE2b-256, line ends included. Passwords are never in it: a backup gives nobody a level.
//!
//! A file is read twice, line by line: first all of it is judged, then it is written in one commit. So a foreign
//! or damaged one changes nothing, and a hostile one costs no more memory than the longest line that can be meant.

use crate::apply::Applier;
use crate::author::Author;
use crate::database::Database;
use crate::error::Error;
use crate::items::{Item, LogEntry, Time, limits, now};
use crate::rights;
use crate::rows;
use crate::snapshot::sync_folder;
use crate::store::{Reader, Store};
use crate::table::{Cell, FileSum, Kind, Row, TABLES, Table};
use serde::de::{DeserializeSeed, Deserializer, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Serialize};
use std::cmp::Ordering;
use std::fmt;
use std::fs::{self, File};
use std::io::{self, BufRead, BufReader, BufWriter, Read, Seek, Write};
use std::path::{Path, PathBuf};

/// The version of the format.
pub const VERSION: u64 = 1;

/// Longest first and last line, bytes.
const FRAME: u64 = 4096;

/// Longest row, bytes: a program in hexadecimal digits, and what stands beside it.
const ROW: u64 = 2 * limits::PROGRAM as u64 + (64 << 10);

/// Most cells of a row: those of the widest table, and the name of the item.
const CELLS: usize = {
    let (mut most, mut k) = (0, 0);
    while k < TABLES.len() {
        if TABLES[k].columns.len() > most {
            most = TABLES[k].columns.len();
        }
        k += 1;
    }
    most + 1
};

/// First line.
#[derive(Serialize, Deserialize)]
struct Head {
    #[serde(rename = "ferrocut-backup")]
    version: u64,
    control: String,
    time: Time,
    commits: u64,
    items: Vec<String>,
}

/// Last line.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Tail {
    lines: u64,
    blake2b: String,
}

/// What a backup holds of an item.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct BackupEntry {
    /// The item.
    pub item: Item,
    /// Rows: programs, parameters that somebody has set, offsets …
    pub rows: u64,
}

/// A writer that sums what it writes.
struct Summed<W> {
    to: W,
    sum: FileSum,
    lines: u64,
}

impl<W: Write> Summed<W> {
    fn line(&mut self, line: &[u8]) -> Result<(), Error> {
        self.sum.add(line);
        self.sum.add(b"\n");
        self.to.write_all(line)?;
        self.to.write_all(b"\n")?;
        self.lines += 1;
        Ok(())
    }
}

fn json(value: &impl Serialize) -> Result<Vec<u8>, Error> {
    serde_json::to_vec(value).map_err(|error| Error::Disk(error.to_string()))
}

/// A row as its line holds it.
struct Line<'a>(&'a Table, &'a Row);

impl Serialize for Line<'_> {
    fn serialize<S: serde::Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        to.collect_seq(std::iter::once(Written::Name(self.0.name)).chain(self.1.iter().map(Written::Cell)))
    }
}

enum Written<'a> {
    Name(&'a str),
    Cell(&'a Cell),
}

impl Serialize for Written<'_> {
    fn serialize<S: serde::Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        match self {
            Written::Name(name) => to.serialize_str(name),
            Written::Cell(Cell::Whole(value)) => to.serialize_i64(*value),
            Written::Cell(Cell::Real(value)) => to.serialize_f64(*value),
            Written::Cell(Cell::Text(text)) => to.serialize_str(text),
            Written::Cell(Cell::Bytes(bytes)) => {
                // Control characters would take six bytes each.
                let plain = |c: char| !c.is_control() || matches!(c, '\n' | '\r' | '\t');
                match std::str::from_utf8(bytes).ok().filter(|text| text.chars().all(plain)) {
                    Some(text) => to.collect_map([("text", text)]),
                    None => to.collect_map([("hex", hex(bytes))]),
                }
            }
        }
    }
}

fn hex(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(2 * bytes.len());
    for byte in bytes {
        for digit in [byte >> 4, byte & 0xF] {
            text.push(char::from_digit(digit.into(), 16).unwrap_or('0'));
        }
    }
    text
}

fn from_hex(text: &str) -> Option<Vec<u8>> {
    let digit = |byte: u8| char::from(byte).to_digit(16).and_then(|d| u8::try_from(d).ok());
    let pairs = text.as_bytes().chunks(2);
    pairs.map(|pair| Some(digit(*pair.first()?)? << 4 | digit(*pair.get(1)?)?)).collect()
}

impl Reader {
    /// Writes items, of one moment, into a file: whole or not at all. Says what is in it. A link stays a link: the
    /// backup goes to what it leads to.
    pub fn back_up(&self, path: &Path, items: &[Item]) -> Result<Vec<BackupEntry>, Error> {
        let path = &file_behind(path)?;
        let part = beside(path);
        let written = self.write_part(&part, items);
        if written.is_err() {
            // The error that counts is the one at hand.
            let _ = fs::remove_file(&part);
        }
        let entries = written?;
        fs::rename(&part, path)?;
        if let Some(folder) = path.parent().filter(|folder| !folder.as_os_str().is_empty()) {
            sync_folder(folder)?;
        }
        Ok(entries)
    }

    fn write_part(&self, part: &Path, items: &[Item]) -> Result<Vec<BackupEntry>, Error> {
        let mut to = BufWriter::new(File::create(part)?);
        let entries = self.back_up_to(&mut to, items)?;
        let file = to.into_inner().map_err(|error| Error::Disk(error.to_string()))?;
        file.sync_all()?;
        Ok(entries)
    }

    /// The same into what takes bytes, such as a pipe, whose end says whether it is whole.
    pub fn back_up_to(&self, to: impl Write, items: &[Item]) -> Result<Vec<BackupEntry>, Error> {
        let mut items = items.to_vec();
        items.sort_unstable();
        items.dedup();
        let mut to = Summed { to, sum: FileSum::default(), lines: 0 };
        let entries = self.at_once(|database| write(database, &items, &mut to))?;
        let tail = Tail { lines: to.lines, blake2b: to.sum.clone().finish() };
        to.line(&json(&tail)?)?;
        Ok(entries)
    }
}

/// The file that a name stands for. What is there and is no regular file is refused: a file put in the place of a
/// device or a pipe would take it away from whoever uses it.
fn file_behind(path: &Path) -> Result<PathBuf, Error> {
    match fs::symlink_metadata(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(path.to_owned()),
        _ => {
            let path = fs::canonicalize(path)?;
            match fs::metadata(&path)?.is_file() {
                true => Ok(path),
                false => Err(Error::Disk(format!("{} is no regular file", path.display()))),
            }
        }
    }
}

/// A name beside a file that is not there yet.
fn beside(path: &Path) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(".part");
    PathBuf::from(name)
}

fn write(
    database: &Database,
    items: &[Item],
    to: &mut Summed<impl Write>,
) -> Result<Vec<BackupEntry>, Error> {
    let head = Head {
        version: VERSION,
        control: database.control()?,
        time: now(),
        commits: database.commits_now()?,
        items: items.iter().map(|item| item.name().to_owned()).collect(),
    };
    to.line(&json(&head)?)?;
    let mut entries = Vec::new();
    for item in items {
        let table = rows::table(*item);
        let before = to.lines;
        database.rows(table, |row| to.line(&json(&Line(table, &row))?))?;
        entries.push(BackupEntry { item: *item, rows: to.lines - before });
    }
    Ok(entries)
}

/// A backup that was found whole.
#[derive(Debug)]
pub struct Backup {
    name: String,
    file: File,
    control: String,
    time: Time,
    commits: u64,
    entries: Vec<BackupEntry>,
    sum: String,
}

/// Writes what it reads to a file.
struct Copying<'a, R> {
    from: R,
    to: &'a File,
}

impl<R: Read> Read for Copying<'_, R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.from.read(buffer)?;
        self.to.write_all(&buffer[..count])?;
        Ok(count)
    }
}

/// Reads lines of a bounded length.
struct Lines<R> {
    from: R,
    sum: FileSum,
    /// Lines that were read.
    count: u64,
    line: Vec<u8>,
}

impl<R: BufRead> Lines<R> {
    fn new(from: R) -> Lines<R> {
        Lines { from, sum: FileSum::default(), count: 0, line: Vec::new() }
    }

    fn damaged(&self) -> Error {
        Error::BackupDamaged(self.count)
    }

    /// The next line with its end; its end must be there.
    fn next(&mut self, most: u64) -> Result<&[u8], Error> {
        self.line.clear();
        self.count += 1;
        let damaged = self.damaged();
        (&mut self.from).take(most).read_until(b'\n', &mut self.line)?;
        match self.line.ends_with(b"\n") {
            true => Ok(&self.line),
            false => Err(damaged),
        }
    }

    fn take_sum(&mut self) {
        self.sum.add(&self.line);
    }
}

/// Reads a backup, and gives each row away. Says what it is and its sum.
fn read(
    from: impl Read,
    mut each: impl FnMut(Item, Row) -> Result<(), Error>,
) -> Result<(Head, Vec<BackupEntry>, String), Error> {
    let mut lines = Lines::new(BufReader::new(from));
    let head = head(&mut lines)?;
    let mut items = Vec::new();
    for name in &head.items {
        items
            .push(Item::named(name).filter(|item| items.last() < Some(item)).ok_or_else(|| lines.damaged())?);
    }
    let mut entries: Vec<BackupEntry> =
        items.iter().map(|item| BackupEntry { item: *item, rows: 0 }).collect();
    let mut at = 0;
    let mut last: Option<Vec<Cell>> = None;
    let mut program_bytes = 0u64;
    let (before, tail) = loop {
        let before = lines.count;
        let damaged = Error::BackupDamaged(before.saturating_add(1));
        let line = lines.next(ROW)?;
        if line.first() == Some(&b'{') {
            let tail =
                (line.len() as u64 <= FRAME).then(|| serde_json::from_slice::<Tail>(line).ok()).flatten();
            break (before, tail.ok_or(damaged)?);
        }
        let (item, row) = row_of(line).ok_or(damaged.clone())?;
        lines.take_sum();
        // Items come in the order of the first line, rows in that of their keys: none stands twice.
        while entries.get(at).is_some_and(|entry| entry.item != item) {
            at += 1;
            last = None;
        }
        let entry = entries.get_mut(at).ok_or(damaged.clone())?;
        entry.rows += 1;
        if let Some(Cell::Bytes(bytes)) = row.last() {
            program_bytes = program_bytes.saturating_add(bytes.len() as u64);
        }
        let key: Vec<Cell> = row.iter().take(rows::table(item).keys).cloned().collect();
        let rises = last.as_ref().is_none_or(|last| compare(last, &key) == Ordering::Less);
        let is_full = i64::try_from(entry.rows).unwrap_or(i64::MAX) > rows::most_rows(item);
        if !rises || is_full || program_bytes > limits::PROGRAM_BYTES || !rows::is_valid(item, &row) {
            return Err(damaged);
        }
        last = Some(key);
        each(item, row)?;
    };
    let sum = lines.sum.clone().finish();
    if tail.lines != before || tail.blake2b != sum {
        return Err(lines.damaged());
    }
    // Nothing stands behind the last line.
    match lines.from.fill_buf()?.is_empty() {
        true => Ok((head, entries, sum)),
        false => Err(Error::BackupDamaged(lines.count.saturating_add(1))),
    }
}

fn head(lines: &mut Lines<impl BufRead>) -> Result<Head, Error> {
    /// The key alone, which tells a later version from what is none of ours.
    #[derive(Deserialize)]
    struct Version {
        #[serde(rename = "ferrocut-backup")]
        version: u64,
    }
    let line = match lines.next(FRAME) {
        Err(Error::BackupDamaged(_)) => return Err(Error::NotABackup),
        line => line?,
    };
    let version = serde_json::from_slice::<Version>(line).map_err(|_| Error::NotABackup)?.version;
    if version != VERSION {
        return Err(Error::NewerBackup(version));
    }
    let head = serde_json::from_slice(line).map_err(|_| Error::BackupDamaged(1))?;
    lines.take_sum();
    Ok(head)
}

fn compare(a: &[Cell], b: &[Cell]) -> Ordering {
    let cells = a.iter().zip(b).map(|pair| match pair {
        (Cell::Whole(a), Cell::Whole(b)) => a.cmp(b),
        (Cell::Text(a), Cell::Text(b)) => a.cmp(b),
        _ => Ordering::Equal,
    });
    cells.fold(Ordering::Equal, Ordering::then)
}

/// A row of its line; none where it is no row of an item.
fn row_of(line: &[u8]) -> Option<(Item, Row)> {
    let mut from = serde_json::Deserializer::from_slice(line);
    let mut cells = Cells.deserialize(&mut from).ok()?.into_iter();
    from.end().ok()?;
    let Some(Cell::Text(name)) = cells.next() else { return None };
    let item = rows::item(&name)?;
    let table = rows::table(item);
    let row: Row = rows::of_today(item, cells.collect())
        .into_iter()
        .zip(table.columns)
        .map(|(cell, (_, kind))| match (cell, kind) {
            // A number that happens to be whole.
            (Cell::Whole(value), Kind::Real) => Cell::from(value as f64),
            (Cell::Real(value), _) => Cell::from(value),
            (cell, _) => cell,
        })
        .collect();
    Some((item, row))
}

/// Reads a list of cells of bounded length; what is nested deeper is refused where it begins.
struct Cells;

impl<'de> DeserializeSeed<'de> for Cells {
    type Value = Vec<Cell>;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<Vec<Cell>, D::Error> {
        from.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for Cells {
    type Value = Vec<Cell>;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a row")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut from: A) -> Result<Vec<Cell>, A::Error> {
        let mut cells = Vec::with_capacity(CELLS);
        while let Some(cell) = from.next_element_seed(OneCell)? {
            if cells.len() == CELLS {
                return Err(serde::de::Error::custom("too many cells"));
            }
            cells.push(cell);
        }
        Ok(cells)
    }
}

struct OneCell;

impl<'de> DeserializeSeed<'de> for OneCell {
    type Value = Cell;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<Cell, D::Error> {
        from.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for OneCell {
    type Value = Cell;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a cell")
    }

    fn visit_i64<E>(self, value: i64) -> Result<Cell, E> {
        Ok(Cell::Whole(value))
    }

    fn visit_u64<E: serde::de::Error>(self, value: u64) -> Result<Cell, E> {
        i64::try_from(value).map(Cell::Whole).map_err(E::custom)
    }

    fn visit_f64<E>(self, value: f64) -> Result<Cell, E> {
        Ok(Cell::Real(value))
    }

    fn visit_str<E>(self, text: &str) -> Result<Cell, E> {
        Ok(Cell::Text(text.to_owned()))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut from: A) -> Result<Cell, A::Error> {
        let wrong = || serde::de::Error::custom("bytes are text or hex");
        let bytes = match from.next_entry::<String, String>()? {
            Some((form, text)) if form == "text" => text.into_bytes(),
            Some((form, text)) if form == "hex" => from_hex(&text).ok_or_else(wrong)?,
            _ => return Err(wrong()),
        };
        match from.next_key::<String>()? {
            None => Ok(Cell::Bytes(bytes)),
            Some(_) => Err(wrong()),
        }
    }
}

impl Backup {
    /// Opens a backup and judges all of it.
    pub fn open(path: &Path) -> Result<Backup, Error> {
        Backup::of(File::open(path)?, &path.to_string_lossy())
    }

    /// Judges a file that is open. The log of what is restored calls it by `name`.
    pub fn of(mut file: File, name: &str) -> Result<Backup, Error> {
        file.rewind()?;
        let judged = read(&file, |_, _| Ok(()))?;
        Ok(Backup::judged(file, judged, name))
    }

    /// Judges what can be read once, and keeps it in `file`. No more is read than up to the first fault.
    pub fn copied(from: impl Read, file: File, name: &str) -> Result<Backup, Error> {
        let judged = read(Copying { from, to: &file }, |_, _| Ok(()))?;
        Ok(Backup::judged(file, judged, name))
    }

    fn judged(file: File, (head, entries, sum): (Head, Vec<BackupEntry>, String), name: &str) -> Backup {
        let Head { control, time, commits, .. } = head;
        Backup { name: name.to_owned(), file, control, time, commits, entries, sum }
    }

    /// The control that it is of.
    pub fn control(&self) -> &str {
        &self.control
    }

    /// When it was made.
    pub fn time(&self) -> Time {
        self.time
    }

    /// The number of the last commit that is in it.
    pub fn commits(&self) -> u64 {
        self.commits
    }

    /// What it holds.
    pub fn entries(&self) -> &[BackupEntry] {
        &self.entries
    }

    /// The items that are restored where none are named: all but the last position and the interrupted run, which
    /// are of another moment and perhaps of another machine.
    pub fn items(&self) -> Vec<Item> {
        let of_a_moment = |item: &Item| matches!(item, Item::LastPosition | Item::Interrupted);
        self.entries.iter().map(|entry| entry.item).filter(|item| !of_a_moment(item)).collect()
    }

    /// Restores items, all or nothing. Programs are put beside those that there are, in place of those of the same
    /// name; the histories are merged; every other item becomes what the backup has of it.
    pub fn restore(&self, store: &Store, author: &Author, items: &[Item]) -> Result<u64, Error> {
        if self.control != store.control() {
            return Err(Error::OtherControl(self.control.as_str().into()));
        }
        for item in items {
            if !self.entries.iter().any(|entry| entry.item == *item) {
                return Err(Error::NotInBackup(*item));
            }
            let needed = rights::needed_to_restore(*item);
            match author {
                Author::Person { session, .. } if !session.level().covers(needed) => {
                    return Err(Error::Right { needed, level: session.level() });
                }
                Author::Program { .. } => return Err(Error::NotByThis),
                _ => {}
            }
        }
        let file = self.file.try_clone()?;
        let (sum, author, items) = (self.sum.clone(), author.clone(), items.to_vec());
        let names: Vec<&str> = items.iter().map(|item| item.name()).collect();
        let entry = LogEntry {
            time: now(),
            level: author.level(),
            who: author.name().to_owned(),
            item: "memory".to_owned(),
            name: "restored".to_owned(),
            from: self.name.clone(),
            to: names.join(" "),
        };
        store.within_commit(move |applier| {
            items.iter().try_for_each(|item| applier.check_restore(&author, *item))?;
            restore(applier, &file, &sum, &author, &items)?;
            applier.log(&entry)?;
            applier.read_parameters()
        })
    }
}

impl Store {
    /// Takes a backup that was brought: the file `part`, in the folder of the memory, gets the name `path` there, in
    /// place of the one that had it, once all of it was judged and is on the disk. The operation log has it.
    ///
    /// # Errors
    /// It is no backup of this control, or the author may not. Then what had the name stands.
    pub fn admit_backup(&self, part: &Path, path: &Path, author: &Author) -> Result<u64, Error> {
        let needed = rights::CARRIES_BACKUPS;
        match author {
            Author::Person { session, .. } if !session.level().covers(needed) => {
                return Err(Error::Right { needed, level: session.level() });
            }
            Author::Program { .. } => return Err(Error::NotByThis),
            _ => {}
        }
        let backup = Backup::open(part)?;
        if backup.control != self.control() {
            return Err(Error::OtherControl(backup.control.as_str().into()));
        }
        File::open(part)?.sync_all()?;
        let names: Vec<&str> = backup.entries.iter().map(|entry| entry.item.name()).collect();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let entry = LogEntry {
            time: now(),
            level: author.level(),
            who: author.name().to_owned(),
            item: "memory".to_owned(),
            name: "uploaded".to_owned(),
            from: names.join(" "),
            to: name.into_owned(),
        };
        let (part, path) = (part.to_owned(), path.to_owned());
        let folder = self.folder().map(Path::to_owned);
        self.within_commit(move |applier| {
            applier.log(&entry)?;
            fs::rename(&part, &path)?;
            folder.map_or(Ok(()), |folder| sync_folder(&folder))
        })
    }
}

fn restore(
    applier: &mut Applier,
    mut file: &File,
    sum: &str,
    author: &Author,
    items: &[Item],
) -> Result<(), Error> {
    for item in items {
        applier.clear_for_restore(*item)?;
    }
    let mut histories: Vec<(Item, Vec<Row>)> = Vec::new();
    file.rewind()?;
    let (_, _, now) = read(file, |item, row| {
        if !items.contains(&item) {
            return Ok(());
        }
        if !matches!(item, Item::Alarms | Item::Log) {
            applier.check_row(author, item, &row)?;
            return applier.restore_row(item, &row);
        }
        match histories.iter_mut().find(|(of, _)| *of == item) {
            Some((_, rows)) => rows.push(row),
            None => histories.push((item, vec![row])),
        }
        Ok(())
    })?;
    for (item, rows) in histories {
        applier.merge_history(item, rows)?;
    }
    // The file that was judged is the file that was written.
    match now == sum {
        true => Ok(()),
        false => Err(Error::BackupDamaged(0)),
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn rows_of_older_backups_are_taken() {
        let (item, row) = row_of(br#"["last_position",1,9,5,"G55",1,2,3,4,5,6,7,8,9.5]"#).unwrap();
        assert!(rows::is_valid(item, &row));
        let last = rows::last_position(&row).unwrap();
        assert_eq!((last.position.0[0], last.position.0[8], last.own_zero), (1.0, 9.5, None));
        let (item, row) = row_of(br#"["interrupted",1,9,"O1",1,"O2",3,12,"G1 X1"]"#).unwrap();
        assert!(rows::is_valid(item, &row));
        assert_eq!(rows::interrupted(&row).unwrap().at, None);
    }
}
