//! The SQL: one file of SQLite, written and read row by row. No other file knows SQL.
//!
//! Write-ahead log, `synchronous=FULL`: a commit that returned is on the disk. Each commit counts up
//! `total.commits` and brings the totals of the tables that it changed.

use crate::error::{Error, Finding};
use crate::table::{ABOUT, Cell, Kind, Row, SUM, TABLES, TOTAL, Table};
use rusqlite::backup::{Backup, StepResult};
use rusqlite::config::DbConfig;
use rusqlite::types::{ToSql, ToSqlOutput, ValueRef};
use rusqlite::{CachedStatement, Connection, OpenFlags, params_from_iter};
use std::collections::BTreeMap;
use std::path::Path;

/// `application_id` of the file, for tools that tell files apart: "FCUT".
const APPLICATION: i32 = 0x4643_5554;

/// The version of today's schema.
pub const SCHEMA: u32 = 5;

/// Row of `total` that counts commits.
const COMMITS: &str = "commits";

/// Most faults of structure that are listed.
const MOST_FAULTS: usize = 20;

/// How long a reader waits for the lock that the last closer of a database holds for a moment.
const BUSY: std::time::Duration = std::time::Duration::from_secs(5);

impl ToSql for Cell {
    fn to_sql(&self) -> rusqlite::Result<ToSqlOutput<'_>> {
        Ok(ToSqlOutput::Borrowed(match self {
            Cell::Whole(value) => ValueRef::Integer(*value),
            Cell::Real(value) => ValueRef::Real(*value),
            Cell::Text(text) => ValueRef::Text(text.as_bytes()),
            Cell::Bytes(bytes) => ValueRef::Blob(bytes),
        }))
    }
}

/// How many rows a table has, and the sum of their sums.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
struct Total {
    count: i64,
    sum: i64,
}

/// What a database says of itself once it was found whole.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Identity {
    /// Version of its schema.
    pub schema: u32,
    /// Control whose memory it is, such as `gsk990mc`.
    pub control: String,
    /// Commits that it has seen.
    pub commits: u64,
}

/// An open database.
pub struct Database {
    connection: Connection,
    /// Of every table, as of the transaction under way.
    totals: BTreeMap<&'static str, Total>,
    /// Totals to be written with the commit under way, with what they were before.
    before: BTreeMap<&'static str, Total>,
    commits: u64,
}

/// The text by which SQLite keeps a table.
fn create(table: &Table) -> String {
    let kind = |kind: &Kind| match kind {
        Kind::Whole => "INTEGER",
        Kind::Real => "REAL",
        Kind::Text => "TEXT",
        Kind::Bytes => "BLOB",
    };
    let columns: Vec<String> =
        table.columns.iter().map(|(name, k)| format!("{name} {} NOT NULL", kind(k))).collect();
    let keys: Vec<&str> = table.columns.iter().take(table.keys).map(|(name, _)| *name).collect();
    format!(
        "CREATE TABLE {}({}, {SUM} INTEGER NOT NULL, PRIMARY KEY ({})) STRICT, WITHOUT ROWID",
        table.name,
        columns.join(", "),
        keys.join(", ")
    )
}

fn names(table: &Table) -> String {
    table.columns.iter().map(|(name, _)| *name).collect::<Vec<_>>().join(", ")
}

fn key_is(table: &Table) -> String {
    let keys = table.columns.iter().take(table.keys).zip(1..);
    keys.map(|((name, _), n)| format!("{name} = ?{n}")).collect::<Vec<_>>().join(" AND ")
}

fn cell(value: ValueRef<'_>, kind: Kind) -> Option<Cell> {
    Some(match (kind, value) {
        (Kind::Whole, ValueRef::Integer(value)) => Cell::Whole(value),
        (Kind::Real, ValueRef::Real(value)) => Cell::Real(value),
        (Kind::Text, ValueRef::Text(text)) => Cell::Text(std::str::from_utf8(text).ok()?.to_owned()),
        (Kind::Bytes, ValueRef::Blob(bytes)) => Cell::Bytes(bytes.to_vec()),
        _ => return None,
    })
}

/// Reads a row and its sum; a row whose cells do not make up its sum is damage.
fn read(row: &rusqlite::Row<'_>, table: &Table) -> Result<(Row, i64), Error> {
    let damaged = || Error::damaged(Finding::Row { table: table.name });
    let mut cells = Vec::with_capacity(table.columns.len());
    for (n, (_, kind)) in table.columns.iter().enumerate() {
        cells.push(cell(row.get_ref(n)?, *kind).ok_or_else(damaged)?);
    }
    let sum: i64 = row.get(table.columns.len())?;
    match sum == table.sum(&cells) {
        true => Ok((cells, sum)),
        false => Err(damaged()),
    }
}

/// How a database is opened.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Access {
    /// By the one writer.
    Write,
    /// Beside the writer.
    Read,
    /// A file that nobody has open, read without touching it.
    Untouched,
}

fn connect(path: &Path, access: Access) -> Result<Connection, Error> {
    let flags = OpenFlags::SQLITE_OPEN_NO_MUTEX
        | match access {
            // A reader beside the writer takes part in the locks of the write-ahead log.
            Access::Write | Access::Read => OpenFlags::SQLITE_OPEN_READ_WRITE,
            Access::Untouched => OpenFlags::SQLITE_OPEN_READ_ONLY,
        };
    prepared(Connection::open_with_flags(path, flags)?, access)
}

/// A database of this process alone, in its memory; every connection by the same name is to the same one, which goes with
/// the last of them.
fn connect_in_memory(name: &str, access: Access) -> Result<Connection, Error> {
    let flags = OpenFlags::SQLITE_OPEN_NO_MUTEX
        | OpenFlags::SQLITE_OPEN_URI
        | OpenFlags::SQLITE_OPEN_READ_WRITE
        | OpenFlags::SQLITE_OPEN_CREATE;
    prepared(Connection::open_with_flags(format!("file:/{name}?vfs=memdb"), flags)?, access)
}

fn prepared(connection: Connection, access: Access) -> Result<Connection, Error> {
    connection.busy_timeout(BUSY)?;
    connection.set_prepared_statement_cache_capacity(128);
    connection.set_db_config(DbConfig::SQLITE_DBCONFIG_DEFENSIVE, true)?;
    connection.set_db_config(DbConfig::SQLITE_DBCONFIG_TRUSTED_SCHEMA, false)?;
    connection.pragma_update(None, "cell_size_check", true)?;
    // A page that the disk cannot give is an error, never the end of the process.
    connection.pragma_update(None, "mmap_size", 0)?;
    match access {
        Access::Write => {
            connection.pragma_update_and_check(None, "journal_mode", "WAL", |row| row.get::<_, String>(0))?;
            connection.pragma_update(None, "synchronous", "FULL")?;
            // The log goes back to this size once it was long.
            connection.pragma_update_and_check(None, "journal_size_limit", 16 << 20, |_| Ok(()))?;
        }
        Access::Read | Access::Untouched => connection.pragma_update(None, "query_only", true)?,
    }
    Ok(connection)
}

impl Database {
    /// Makes a new file for a control, which must not exist.
    pub fn create(path: &Path, control: &str) -> Result<(), Error> {
        Database::create_as(path, control, SCHEMA, TABLES)
    }

    /// Makes a new file in any version of the schema.
    pub(crate) fn create_as(
        path: &Path,
        control: &str,
        version: u32,
        tables: &'static [Table],
    ) -> Result<(), Error> {
        let flags = OpenFlags::SQLITE_OPEN_READ_WRITE | OpenFlags::SQLITE_OPEN_CREATE;
        let connection = Connection::open_with_flags(path, flags)?;
        connection.pragma_update(None, "application_id", APPLICATION)?;
        connection.pragma_update(None, "synchronous", "FULL")?;
        let database = Database::filled(connection, control, version, tables)?;
        database.connection.close().map_err(|(_, error)| error.into())
    }

    /// Makes a new database for a control that is in no file, by a name that no other of this process has. It is there as
    /// long as somebody has it open.
    pub fn create_in_memory(name: &str, control: &str) -> Result<Database, Error> {
        Database::filled(connect_in_memory(name, Access::Write)?, control, SCHEMA, TABLES)
    }

    /// Opens one for reading that was made so.
    pub fn open_in_memory(name: &str) -> Result<Database, Error> {
        Database::of(connect_in_memory(name, Access::Read)?)
    }

    /// The empty memory of a control.
    fn filled(
        connection: Connection,
        control: &str,
        version: u32,
        tables: &'static [Table],
    ) -> Result<Database, Error> {
        let mut database =
            Database { connection, totals: BTreeMap::new(), before: BTreeMap::new(), commits: 0 };
        database.begin()?;
        for table in tables {
            database.connection.execute_batch(&create(table))?;
            if table.name != TOTAL.name {
                database.change_total(table.name, Total::default());
            }
        }
        database.put(&ABOUT, &["control".into(), control.into()])?;
        database.put(&ABOUT, &["schema".into(), version.to_string().into()])?;
        // Commit 0 is the empty memory.
        database.write_totals(0)?;
        database.connection.execute_batch("COMMIT")?;
        database.before.clear();
        Ok(database)
    }

    /// Opens a file that was found whole.
    pub fn open(path: &Path, access: Access) -> Result<Database, Error> {
        Database::of(connect(path, access)?)
    }

    fn of(connection: Connection) -> Result<Database, Error> {
        let mut database =
            Database { connection, totals: BTreeMap::new(), before: BTreeMap::new(), commits: 0 };
        database.read_totals()?;
        Ok(database)
    }

    /// Opens a file for reading so that nothing of it changes, not even by closing it.
    pub fn open_unchanged(path: &Path) -> Result<Database, Error> {
        let database = Database::open(path, Access::Read)?;
        database.connection.set_db_config(DbConfig::SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, true)?;
        Ok(database)
    }

    /// The control whose memory it is.
    pub fn control(&self) -> Result<String, Error> {
        match self.get(&ABOUT, &["control".into()])?.as_deref() {
            Some([_, Cell::Text(control)]) => Ok(control.clone()),
            _ => Err(Error::damaged(Finding::Row { table: ABOUT.name })),
        }
    }

    fn read_totals(&mut self) -> Result<(), Error> {
        let mut totals = BTreeMap::new();
        let mut commits = None;
        self.rows(&TOTAL, |row| {
            let [Cell::Text(name), Cell::Whole(count), Cell::Whole(sum)] = row.as_slice() else {
                return Ok(());
            };
            match Table::named(name) {
                Some(table) => drop(totals.insert(table.name, Total { count: *count, sum: *sum })),
                None if name == COMMITS => commits = u64::try_from(*count).ok(),
                None => {}
            }
            Ok(())
        })?;
        self.totals = totals;
        self.commits = commits.ok_or_else(|| Error::damaged(Finding::Row { table: TOTAL.name }))?;
        Ok(())
    }

    /// The commits that are in it, as of when it was opened or last written by this connection.
    pub fn commits(&self) -> u64 {
        self.commits
    }

    /// The commits that are in it now.
    pub fn commits_now(&self) -> Result<u64, Error> {
        let row = self.get(&TOTAL, &[COMMITS.into()])?;
        match row.as_deref() {
            Some([_, Cell::Whole(count), _]) => Ok(u64::try_from(*count).unwrap_or(0)),
            _ => Err(Error::damaged(Finding::Row { table: TOTAL.name })),
        }
    }

    /// Rows of a table, as of the transaction under way.
    pub fn count(&self, table: &Table) -> i64 {
        self.totals.get(table.name).map_or(0, |total| total.count)
    }

    /// Rows of a table, as of now.
    pub fn count_now(&self, table: &Table) -> Result<u64, Error> {
        match self.get(&TOTAL, &[table.name.into()])?.as_deref() {
            Some([_, Cell::Whole(count), _]) => Ok(u64::try_from(*count).unwrap_or(0)),
            _ => Err(Error::damaged(Finding::Row { table: TOTAL.name })),
        }
    }

    fn statement(&self, sql: &str) -> Result<CachedStatement<'_>, Error> {
        Ok(self.connection.prepare_cached(sql)?)
    }

    /// Begins to write.
    pub fn begin(&mut self) -> Result<(), Error> {
        Ok(self.connection.execute_batch("BEGIN IMMEDIATE")?)
    }

    /// Begins to read: all that is read until [`Database::end_reading`] is of one moment.
    pub fn begin_reading(&self) -> Result<(), Error> {
        Ok(self.connection.execute_batch("BEGIN")?)
    }

    /// Ends reading.
    pub fn end_reading(&self) -> Result<(), Error> {
        Ok(self.connection.execute_batch("COMMIT")?)
    }

    /// Makes all that was written since `begin` durable, and says which commit it is.
    pub fn commit(&mut self) -> Result<u64, Error> {
        let number = self.commits.saturating_add(1);
        self.write_totals(number)?;
        self.statement("COMMIT")?.execute([])?;
        self.before.clear();
        self.commits = number;
        Ok(number)
    }

    /// Takes all back that was written since `begin`.
    pub fn rollback(&mut self) {
        for (name, total) in std::mem::take(&mut self.before) {
            self.totals.insert(name, total);
        }
        // Where the fault ended the transaction by itself there is none.
        if !self.connection.is_autocommit() {
            let _ = self.connection.execute_batch("ROLLBACK");
        }
    }

    fn change_total(&mut self, name: &'static str, to: Total) {
        let old = self.totals.insert(name, to).unwrap_or_default();
        self.before.entry(name).or_insert(old);
    }

    fn write_totals(&mut self, commits: u64) -> Result<(), Error> {
        let changed: Vec<&'static str> = self.before.keys().copied().collect();
        for name in changed {
            let Total { count, sum } = self.totals.get(name).copied().unwrap_or_default();
            self.write(&TOTAL, &[name.into(), count.into(), sum.into()])?;
        }
        let count = i64::try_from(commits).unwrap_or(i64::MAX);
        self.write(&TOTAL, &[COMMITS.into(), count.into(), Cell::Whole(0)])?;
        Ok(())
    }

    /// Writes a row without its total, and says its sum.
    fn write(&self, table: &Table, row: &[Cell]) -> Result<i64, Error> {
        if !table.fits(row) {
            return Err(Error::Disk(format!("a row that is not of {}", table.name)));
        }
        let sum = table.sum(row);
        let places: Vec<String> = (1..=table.columns.len() + 1).map(|n| format!("?{n}")).collect();
        let sql = format!("INSERT OR REPLACE INTO {} VALUES ({})", table.name, places.join(", "));
        let sum_cell = Cell::Whole(sum);
        self.statement(&sql)?.execute(params_from_iter(row.iter().chain([&sum_cell])))?;
        Ok(sum)
    }

    fn sum_of(&self, table: &Table, key: &[Cell]) -> Result<Option<i64>, Error> {
        let sql = format!("SELECT {SUM} FROM {} WHERE {}", table.name, key_is(table));
        let mut statement = self.statement(&sql)?;
        let mut rows = statement.query(params_from_iter(key))?;
        Ok(rows.next()?.map(|row| row.get(0)).transpose()?)
    }

    /// Writes a row in place of the one of the same key.
    pub fn put(&mut self, table: &'static Table, row: &[Cell]) -> Result<(), Error> {
        let key = row.get(..table.keys).unwrap_or(row);
        let old = self.sum_of(table, key)?;
        let new = self.write(table, row)?;
        let mut total = self.totals.get(table.name).copied().unwrap_or_default();
        total.count += i64::from(old.is_none());
        total.sum = total.sum.wrapping_sub(old.unwrap_or(0)).wrapping_add(new);
        self.change_total(table.name, total);
        Ok(())
    }

    /// Takes a row out, and says whether there was one.
    pub fn delete(&mut self, table: &'static Table, key: &[Cell]) -> Result<bool, Error> {
        let Some(old) = self.sum_of(table, key)? else { return Ok(false) };
        let sql = format!("DELETE FROM {} WHERE {}", table.name, key_is(table));
        self.statement(&sql)?.execute(params_from_iter(key))?;
        let mut total = self.totals.get(table.name).copied().unwrap_or_default();
        total.count -= 1;
        total.sum = total.sum.wrapping_sub(old);
        self.change_total(table.name, total);
        Ok(true)
    }

    /// Takes all rows out.
    pub fn clear(&mut self, table: &'static Table) -> Result<(), Error> {
        self.statement(&format!("DELETE FROM {}", table.name))?.execute([])?;
        self.change_total(table.name, Total::default());
        Ok(())
    }

    /// The row of a key.
    pub fn get(&self, table: &Table, key: &[Cell]) -> Result<Option<Row>, Error> {
        let sql = format!("SELECT {}, {SUM} FROM {} WHERE {}", names(table), table.name, key_is(table));
        let mut statement = self.statement(&sql)?;
        let mut rows = statement.query(params_from_iter(key))?;
        rows.next()?.map(|row| Ok(read(row, table)?.0)).transpose()
    }

    /// Whether there is a row with a key.
    pub fn has(&self, table: &Table, key: &[Cell]) -> Result<bool, Error> {
        let sql = format!("SELECT 1 FROM {} WHERE {}", table.name, key_is(table));
        Ok(self.statement(&sql)?.exists(params_from_iter(key))?)
    }

    /// All rows, in the order of their keys.
    pub fn rows(&self, table: &Table, mut each: impl FnMut(Row) -> Result<(), Error>) -> Result<(), Error> {
        self.rows_with_sums(table, |row, _| each(row))
    }

    fn rows_with_sums(
        &self,
        table: &Table,
        mut each: impl FnMut(Row, i64) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let keys: Vec<&str> = table.columns.iter().take(table.keys).map(|(name, _)| *name).collect();
        let order = keys.join(", ");
        let sql = format!("SELECT {}, {SUM} FROM {} ORDER BY {order}", names(table), table.name);
        let mut statement = self.statement(&sql)?;
        let mut rows = statement.query([])?;
        while let Some(row) = rows.next()? {
            let (row, sum) = read(row, table)?;
            each(row, sum)?;
        }
        Ok(())
    }

    /// All rows without one column, of which only the length is given: for a list of what is too large to be read
    /// for a list. Their sums are not looked at.
    pub fn sizes(&self, table: &Table, column: &str) -> Result<Vec<(Row, u64)>, Error> {
        let shown: Vec<(&str, Kind)> =
            table.columns.iter().filter(|(name, _)| *name != column).copied().collect();
        let list = shown.iter().map(|(name, _)| *name).collect::<Vec<_>>().join(", ");
        let order = table.columns.first().map_or("1", |(name, _)| *name);
        let sql = format!("SELECT {list}, length({column}) FROM {} ORDER BY {order}", table.name);
        let mut statement = self.statement(&sql)?;
        let mut rows = statement.query([])?;
        let mut found = Vec::new();
        while let Some(row) = rows.next()? {
            let mut cells = Vec::with_capacity(shown.len());
            for (n, (_, kind)) in shown.iter().enumerate() {
                let damaged = || Error::damaged(Finding::Row { table: table.name });
                cells.push(cell(row.get_ref(n)?, *kind).ok_or_else(damaged)?);
            }
            let length: i64 = row.get(shown.len())?;
            found.push((cells, u64::try_from(length).unwrap_or(0)));
        }
        Ok(found)
    }

    /// The rows with the highest keys of a table that counts, the highest first.
    pub fn last(
        &self,
        table: &Table,
        most: u32,
        mut each: impl FnMut(Row) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let order = table.columns.first().map_or("1", |(name, _)| *name);
        let sql =
            format!("SELECT {}, {SUM} FROM {} ORDER BY {order} DESC LIMIT {most}", names(table), table.name);
        let mut statement = self.statement(&sql)?;
        let mut rows = statement.query([])?;
        while let Some(row) = rows.next()? {
            each(read(row, table)?.0)?;
        }
        Ok(())
    }

    /// The key of the first row; none of an empty table.
    pub fn first_key(&self, table: &Table) -> Result<Option<i64>, Error> {
        let order = table.columns.first().map_or("1", |(name, _)| *name);
        let sql = format!("SELECT {order} FROM {} ORDER BY {order} LIMIT 1", table.name);
        let mut statement = self.statement(&sql)?;
        let mut rows = statement.query([])?;
        Ok(rows.next()?.map(|row| row.get(0)).transpose()?)
    }

    /// The highest key of a table that counts; 0 of an empty one.
    pub fn highest(&self, table: &Table) -> Result<i64, Error> {
        let order = table.columns.first().map_or("1", |(name, _)| *name);
        let sql = format!("SELECT {order} FROM {} ORDER BY {order} DESC LIMIT 1", table.name);
        let mut statement = self.statement(&sql)?;
        let mut rows = statement.query([])?;
        Ok(rows.next()?.map(|row| row.get(0)).transpose()?.unwrap_or(0))
    }

    /// Copies it as it is at this moment into a new file that stands alone.
    pub fn copy_to(&self, path: &Path) -> Result<(), Error> {
        let mut to = Connection::open(path)?;
        {
            let backup = Backup::new(&self.connection, &mut to)?;
            // All pages in one step: the copy is of one moment, and the writer goes on meanwhile.
            for _ in 0..1000 {
                match backup.step(-1)? {
                    StepResult::Done => break,
                    _ => std::thread::sleep(std::time::Duration::from_millis(5)),
                }
            }
            if backup.progress().remaining != 0 {
                return Err(Error::Disk("the copy does not come to its end".into()));
            }
        }
        to.pragma_update_and_check(None, "journal_mode", "DELETE", |row| row.get::<_, String>(0))?;
        to.close().map_err(|(_, error)| error.into())
    }

    /// Closes it. The last one that closes empties the write-ahead log.
    pub fn close(self) -> Result<(), Error> {
        self.connection.close().map_err(|(_, error)| error.into())
    }

    /// Looks at everything: structure, schema, every row, every total.
    ///
    /// `tables_of` gives the tables of a version of the schema; none of one that is not known.
    pub fn verify(
        path: &Path,
        access: Access,
        tables_of: impl Fn(u32) -> Option<&'static [Table]>,
    ) -> Result<Identity, Verdict> {
        let connection = connect(path, access).map_err(Verdict::of)?;
        // Looking changes nothing of what is looked at.
        connection
            .set_db_config(DbConfig::SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, true)
            .map_err(|error| Verdict::of(error.into()))?;
        let database = Database { connection, totals: BTreeMap::new(), before: BTreeMap::new(), commits: 0 };
        database.verify_open(tables_of)
    }

    /// The same of an open database, at one moment.
    pub fn verify_open(
        &self,
        tables_of: impl Fn(u32) -> Option<&'static [Table]>,
    ) -> Result<Identity, Verdict> {
        self.begin_reading().map_err(Verdict::of)?;
        let found = self.verify_within(tables_of);
        let _ = self.end_reading();
        found
    }

    fn verify_within(
        &self,
        tables_of: impl Fn(u32) -> Option<&'static [Table]>,
    ) -> Result<Identity, Verdict> {
        let about = |name: &str| match self.get(&ABOUT, &[name.into()]).map_err(Verdict::of)?.as_deref() {
            Some([_, Cell::Text(value)]) => Ok(value.clone()),
            _ => Err(Verdict::Damaged(vec![Finding::Row { table: ABOUT.name }])),
        };
        let control = about("control")?;
        let schema = about("schema")?;
        let schema: u32 = schema.parse().map_err(|_| Verdict::Damaged(vec![Finding::Schema]))?;
        let tables = tables_of(schema).ok_or(Verdict::Newer(schema))?;
        let mut findings = self.structure().map_err(Verdict::of)?;
        if !self.has_schema(tables).map_err(Verdict::of)? {
            findings.push(Finding::Schema);
        }
        if !findings.is_empty() {
            return Err(Verdict::Damaged(findings));
        }
        let mut totals: BTreeMap<String, Total> = BTreeMap::new();
        self.rows(&TOTAL, |row| {
            if let [Cell::Text(name), Cell::Whole(count), Cell::Whole(sum)] = row.as_slice() {
                totals.insert(name.clone(), Total { count: *count, sum: *sum });
            }
            Ok(())
        })
        .map_err(Verdict::of)?;
        let commits = totals.remove(COMMITS).and_then(|total| u64::try_from(total.count).ok());
        for table in tables.iter().filter(|table| table.name != TOTAL.name) {
            let mut found = Total::default();
            let read = self.rows_with_sums(table, |_, sum| {
                found = Total { count: found.count + 1, sum: found.sum.wrapping_add(sum) };
                Ok(())
            });
            match read {
                Err(Error::Damaged(finding)) => findings.push(*finding),
                Err(error) => return Err(Verdict::of(error)),
                Ok(()) if totals.remove(table.name) != Some(found) => {
                    findings.push(Finding::Total { table: table.name });
                }
                Ok(()) => {}
            }
        }
        match commits {
            Some(commits) if findings.is_empty() && totals.is_empty() => {
                Ok(Identity { schema, control, commits })
            }
            _ if findings.is_empty() => Err(Verdict::Damaged(vec![Finding::Total { table: TOTAL.name }])),
            _ => Err(Verdict::Damaged(findings)),
        }
    }

    fn structure(&self) -> Result<Vec<Finding>, Error> {
        let mut statement = self.connection.prepare(&format!("PRAGMA integrity_check({MOST_FAULTS})"))?;
        let mut rows = statement.query([])?;
        let mut findings = Vec::new();
        while let Some(row) = rows.next()? {
            let said: String = row.get(0)?;
            if said != "ok" {
                findings.push(Finding::Structure(said));
            }
        }
        Ok(findings)
    }

    fn has_schema(&self, tables: &[Table]) -> Result<bool, Error> {
        let mut statement = self.connection.prepare("SELECT sql FROM sqlite_schema ORDER BY name")?;
        let mut rows = statement.query([])?;
        let mut found = Vec::new();
        while let Some(row) = rows.next()? {
            let sql: Option<String> = row.get(0)?;
            found.push(sql.unwrap_or_default());
        }
        let mut tables: Vec<&Table> = tables.iter().collect();
        tables.sort_by_key(|table| table.name);
        Ok(tables.iter().map(|table| create(table)).eq(found))
    }

    /// Rewrites everything in another version of the schema, all or nothing. `row` makes a row of the new schema
    /// of one of the old; none where it is left out.
    pub fn rewrite(
        path: &Path,
        old: &'static [Table],
        new: &'static [Table],
        version: u32,
        row: fn(&str, Row) -> Option<(&'static str, Row)>,
    ) -> Result<(), Error> {
        let mut database = Database::open(path, Access::Write)?;
        database.begin()?;
        let done = database.rewrite_within(old, new, version, row).and_then(|()| database.commit());
        if done.is_err() {
            database.rollback();
        }
        done.map(drop)
    }

    fn rewrite_within(
        &mut self,
        old: &'static [Table],
        new: &'static [Table],
        version: u32,
        row: fn(&str, Row) -> Option<(&'static str, Row)>,
    ) -> Result<(), Error> {
        for table in old {
            self.connection.execute_batch(&format!("ALTER TABLE {0} RENAME TO old_{0}", table.name))?;
        }
        for table in new {
            self.connection.execute_batch(&create(table))?;
        }
        self.totals.clear();
        self.before.clear();
        for table in new.iter().filter(|table| table.name != TOTAL.name) {
            self.change_total(table.name, Total::default());
        }
        for table in old.iter().filter(|table| table.name != TOTAL.name) {
            // Row by row, with no more than one of them in memory.
            let sql = format!("SELECT {}, {SUM} FROM old_{}", names(table), table.name);
            let mut taken: Vec<(&'static Table, i64)> = Vec::new();
            {
                let mut statement = self.connection.prepare(&sql)?;
                let mut rows = statement.query([])?;
                while let Some(found) = rows.next()? {
                    let (cells, _) = read(found, table)?;
                    let Some((name, cells)) = row(table.name, cells) else { continue };
                    let to = new.iter().find(|t| t.name == name);
                    let to = to.ok_or_else(|| Error::Disk(format!("no table {name}")))?;
                    taken.push((to, self.write(to, &cells)?));
                }
            }
            for (to, sum) in taken {
                let Total { count, sum: all } = self.totals.get(to.name).copied().unwrap_or_default();
                self.change_total(to.name, Total { count: count + 1, sum: all.wrapping_add(sum) });
            }
        }
        for table in old {
            self.connection.execute_batch(&format!("DROP TABLE old_{}", table.name))?;
        }
        let about = new.iter().find(|table| table.name == ABOUT.name);
        let about = about.ok_or_else(|| Error::Disk("no table about".into()))?;
        self.put(about, &["schema".into(), version.to_string().into()])
    }
}

/// Why a file was not found whole.
#[derive(Clone, PartialEq, Debug)]
pub enum Verdict {
    /// It is damaged.
    Damaged(Vec<Finding>),
    /// Its schema is newer than this software.
    Newer(u32),
    /// The disk does not give it.
    Disk(String),
}

impl Verdict {
    fn of(error: Error) -> Verdict {
        match error {
            Error::Damaged(finding) => Verdict::Damaged(vec![*finding]),
            Error::Disk(reason) => Verdict::Disk(reason),
            other => Verdict::Damaged(vec![Finding::Structure(other.to_string())]),
        }
    }
}
