//! Versions of the schema, and how a database of an older one becomes today's.
//!
//! To change the schema: change the tables of `table.rs`, keep the old list here under its version, raise
//! `database::SCHEMA`, and add a [`Step`] that makes rows of the new tables of rows of the old ones. A database is
//! rewritten in one commit, after a snapshot of it was taken.

use crate::database::{Access, Database, SCHEMA};
use crate::error::Error;
use crate::rows::{interrupted_without_place, last_position_without_zero};
use crate::snapshot;
use crate::table::{
    ABOUT, ALARM, COUNTER, INTERRUPTED, Kind, LADDER, LAST_POSITION, LOG, PARAMETER, PASSWORD, PITCH,
    PROGRAM, REFERENCE_POINT, Row, SIGNAL, TABLES, TOOL_OFFSET, TOTAL, TRIES, Table, VARIABLE, WORK_ZERO,
    position_columns,
};
use std::path::Path;

/// One version to the next.
#[derive(Clone, Copy)]
pub struct Step {
    /// The version that it starts from.
    pub from: u32,
    /// The tables of that version.
    pub tables: &'static [Table],
    /// A row of the next version, with the name of its table, of a row of this one; none where it goes.
    pub row: fn(&str, Row) -> Option<(&'static str, Row)>,
}

/// The tables of version 1: it did not know where a run was broken off.
const FIRST: &[Table] = &[
    ABOUT,
    TOTAL,
    PROGRAM,
    PARAMETER,
    TOOL_OFFSET,
    WORK_ZERO,
    REFERENCE_POINT,
    VARIABLE,
    PITCH,
    SIGNAL,
    COUNTER,
    ALARM,
    LOG,
    FOURTH_LAST_POSITION,
    PASSWORD,
    TRIES,
];

/// The run that was broken off, in version 2: without the place where the axes stood.
const SECOND_INTERRUPTED: Table = Table {
    name: "interrupted",
    keys: 1,
    columns: &[
        ("number", Kind::Whole),
        ("time", Kind::Whole),
        ("program", Kind::Text),
        ("from_line", Kind::Whole),
        ("file", Kind::Text),
        ("line", Kind::Whole),
        ("block", Kind::Whole),
        ("text", Kind::Text),
    ],
};

/// The tables of version 2.
const SECOND: &[Table] = &[
    ABOUT,
    TOTAL,
    PROGRAM,
    PARAMETER,
    TOOL_OFFSET,
    WORK_ZERO,
    REFERENCE_POINT,
    VARIABLE,
    PITCH,
    SIGNAL,
    COUNTER,
    ALARM,
    LOG,
    FOURTH_LAST_POSITION,
    SECOND_INTERRUPTED,
    PASSWORD,
    TRIES,
];

/// The tables of version 3: no ladder was kept.
const THIRD: &[Table] = &[
    ABOUT,
    TOTAL,
    PROGRAM,
    PARAMETER,
    TOOL_OFFSET,
    WORK_ZERO,
    REFERENCE_POINT,
    VARIABLE,
    PITCH,
    SIGNAL,
    COUNTER,
    ALARM,
    LOG,
    FOURTH_LAST_POSITION,
    INTERRUPTED,
    PASSWORD,
    TRIES,
];

/// Where the axes stood, up to version 4: without the zero of G92.
const FOURTH_LAST_POSITION: Table = Table {
    name: "last_position",
    keys: 1,
    columns: position_columns![
        ("number", Kind::Whole),
        ("time", Kind::Whole),
        ("referenced", Kind::Whole),
        ("work_system", Kind::Text)
    ],
};

/// The tables of version 4.
const FOURTH: &[Table] = &[
    ABOUT,
    TOTAL,
    PROGRAM,
    PARAMETER,
    TOOL_OFFSET,
    WORK_ZERO,
    REFERENCE_POINT,
    VARIABLE,
    PITCH,
    SIGNAL,
    COUNTER,
    ALARM,
    LOG,
    FOURTH_LAST_POSITION,
    INTERRUPTED,
    LADDER,
    PASSWORD,
    TRIES,
];

/// A row of version 2 as one of version 3.
fn with_place(table: &str, row: Row) -> Option<(&'static str, Row)> {
    let row = if table == INTERRUPTED.name { interrupted_without_place(row) } else { row };
    as_it_is(table, row)
}

/// A row of version 4 as one of version 5.
fn with_zero(table: &str, row: Row) -> Option<(&'static str, Row)> {
    let row = if table == LAST_POSITION.name { last_position_without_zero(row) } else { row };
    as_it_is(table, row)
}

/// A row that stays as it is.
fn as_it_is(table: &str, row: Row) -> Option<(&'static str, Row)> {
    Table::named(table).map(|table| (table.name, row))
}

/// The steps, in order. Version 1 is the first.
const STEPS: &[Step] = &[
    Step { from: 1, tables: FIRST, row: as_it_is },
    Step { from: 2, tables: SECOND, row: with_place },
    Step { from: 3, tables: THIRD, row: as_it_is },
    Step { from: 4, tables: FOURTH, row: with_zero },
];

/// The tables of a version; none of one that is not known.
pub fn tables_of(version: u32) -> Option<&'static [Table]> {
    tables_among(STEPS, version)
}

fn tables_among(steps: &[Step], version: u32) -> Option<&'static [Table]> {
    match version {
        SCHEMA => Some(TABLES),
        version => steps.iter().find(|step| step.from == version).map(|step| step.tables),
    }
}

/// Brings a database from a version to today's.
pub fn migrate(folder: &Path, path: &Path, from: u32, snapshots: usize) -> Result<(), Error> {
    migrate_by(STEPS, folder, path, from, snapshots)
}

fn migrate_by(steps: &[Step], folder: &Path, path: &Path, from: u32, snapshots: usize) -> Result<(), Error> {
    if from == SCHEMA {
        return Ok(());
    }
    let database = Database::open(path, Access::Write)?;
    // Of any version that is known: a snapshot is judged by its own.
    snapshot::take(folder, &database, snapshots)?;
    database.close()?;
    for step in steps.iter().filter(|step| step.from >= from) {
        let next = step.from.saturating_add(1);
        let missing = || Error::Disk(format!("no tables of version {next}"));
        let tables = tables_among(steps, next).ok_or_else(missing)?;
        Database::rewrite(path, step.tables, tables, next, step.row)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::Cell;

    /// A version before the first, for the test alone: variables had no names but numbers.
    const OLD_VARIABLE: Table =
        Table { name: "macro", keys: 1, columns: &[("number", Kind::Whole), ("value", Kind::Real)] };
    const OLD: &[Table] = &[ABOUT, TOTAL, OLD_VARIABLE];

    fn step_row(table: &str, row: Row) -> Option<(&'static str, Row)> {
        match (table, row.as_slice()) {
            ("macro", [Cell::Whole(0), _]) => None,
            ("macro", [Cell::Whole(number), value]) => {
                Some((VARIABLE.name, vec![format!("#{number}").into(), value.clone()]))
            }
            (table, _) => Table::named(table).map(|table| (table.name, row)),
        }
    }

    #[test]
    fn an_older_database_is_rewritten_whole() {
        let steps = [Step { from: 0, tables: OLD, row: step_row }];
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("memory.db");
        Database::create_as(&path, "gsk990mc", 0, OLD).unwrap();
        {
            let mut database = Database::open(&path, Access::Write).unwrap();
            database.begin().unwrap();
            for number in [0i64, 500, 501] {
                let row: Row = vec![number.into(), (number as f64 / 2.0).into()];
                database.put(Box::leak(Box::new(OLD_VARIABLE)), &row).unwrap();
            }
            database.commit().unwrap();
        }
        let versions = |version| tables_among(&steps, version);
        let before = Database::verify(&path, Access::Read, versions).unwrap();
        assert_eq!((before.schema, before.commits), (0, 1));
        // A database that no step leads from is not touched.
        assert!(Database::verify(&path, Access::Read, tables_of).is_err());
        for step in &steps {
            Database::rewrite(&path, step.tables, FIRST, 1, step.row).unwrap();
        }
        migrate(folder.path(), &path, 1, 3).unwrap();
        let after = Database::verify(&path, Access::Read, tables_of).unwrap();
        assert_eq!((after.schema, after.control.as_str()), (SCHEMA, "gsk990mc"));
        let database = Database::open(&path, Access::Read).unwrap();
        assert_eq!(
            database.get(&VARIABLE, &["#501".into()]).unwrap(),
            Some(vec!["#501".into(), 250.5.into()])
        );
        assert_eq!(database.get(&VARIABLE, &["#0".into()]).unwrap(), None);
    }

    #[test]
    fn a_run_that_an_older_version_kept_has_no_place() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("memory.db");
        Database::create_as(&path, "gsk990mc", 2, SECOND).unwrap();
        let row: Row = vec![
            1i64.into(),
            9i64.into(),
            "O0001".into(),
            1i64.into(),
            "O0002".into(),
            3i64.into(),
            12i64.into(),
            "G81 X1 K5".into(),
        ];
        {
            let mut database = Database::open(&path, Access::Write).unwrap();
            database.begin().unwrap();
            database.put(&SECOND_INTERRUPTED, &row).unwrap();
            database.commit().unwrap();
        }
        migrate(folder.path(), &path, 2, 3).unwrap();
        assert_eq!(Database::verify(&path, Access::Read, tables_of).unwrap().schema, SCHEMA);
        let database = Database::open(&path, Access::Read).unwrap();
        let row = database.get(&INTERRUPTED, &[1i64.into()]).unwrap().unwrap();
        let run = crate::rows::interrupted(&row).unwrap();
        assert_eq!((run.block, run.text.as_str(), run.at), (12, "G81 X1 K5", None));
    }

    #[test]
    fn where_the_axes_stood_in_an_older_version_has_no_zero_of_g92() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("memory.db");
        Database::create_as(&path, "gsk990mc", 4, FOURTH).unwrap();
        let mut row: Row = vec![1i64.into(), 9i64.into(), 5i64.into(), "G55".into()];
        row.extend((1..=9).map(|k| Cell::from(f64::from(k))));
        {
            let mut database = Database::open(&path, Access::Write).unwrap();
            database.begin().unwrap();
            database.put(&FOURTH_LAST_POSITION, &row).unwrap();
            database.commit().unwrap();
        }
        migrate(folder.path(), &path, 4, 3).unwrap();
        assert_eq!(Database::verify(&path, Access::Read, tables_of).unwrap().schema, SCHEMA);
        let database = Database::open(&path, Access::Read).unwrap();
        let row = database.get(&LAST_POSITION, &[1i64.into()]).unwrap().unwrap();
        let last = crate::rows::last_position(&row).unwrap();
        assert_eq!(last.position.0, [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]);
        assert_eq!((last.work_system.map(|s| s.to_string()).as_deref(), last.own_zero), (Some("G55"), None));
    }

    #[test]
    fn a_memory_of_before_ladders_were_kept_opens_and_takes_one() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("memory.db");
        Database::create_as(&path, "gsk990mc", 3, THIRD).unwrap();
        {
            let mut database = Database::open(&path, Access::Write).unwrap();
            database.begin().unwrap();
            database.put(&VARIABLE, &["#500".into(), 2.5.into()]).unwrap();
            database.commit().unwrap();
        }
        migrate(folder.path(), &path, 3, 3).unwrap();
        assert_eq!(Database::verify(&path, Access::Read, tables_of).unwrap().schema, SCHEMA);
        let mut database = Database::open(&path, Access::Write).unwrap();
        assert!(database.get(&VARIABLE, &["#500".into()]).unwrap().is_some());
        let row = crate::rows::ladder_row("END1\nEND2\n");
        assert_eq!(database.get(&LADDER, &[1i64.into()]).unwrap(), None);
        database.begin().unwrap();
        database.put(&LADDER, &row).unwrap();
        database.commit().unwrap();
        assert_eq!(database.get(&LADDER, &[1i64.into()]).unwrap(), Some(row));
    }
}
