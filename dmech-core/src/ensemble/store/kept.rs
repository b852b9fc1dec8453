//! A store that is open: what is read from it and written to it.

use core::ops::Range;
use std::path::Path;
use std::thread;
use std::time::{Duration, Instant};

use rusqlite::types::Value;
use rusqlite::{Connection, ErrorCode, OpenFlags, Transaction, TransactionBehavior};

use super::layout::{Layout, TABLES};
use super::record::{Writers, read};
use super::settings::set;
use super::table::of_table;
use crate::ensemble::plan::Moved;
use crate::ensemble::told::Told;
use crate::ensemble::{Checksum, Outcome};
use crate::error::{Error, StoreError};
use crate::flat::Flat;

/// How long somebody else who writes is waited for.
const PATIENCE: Duration = Duration::from_secs(10);

/// The smallest page of a database, in bytes.
const SMALLEST: u64 = 512;

/// Waits for somebody else where SQLite itself does not: while he makes the journal, or goes through what a killed one has left.
fn patiently<T>(mut ask: impl FnMut() -> rusqlite::Result<T>) -> rusqlite::Result<T> {
    let begun = Instant::now();
    loop {
        match ask() {
            Err(busy) if busy.sqlite_error_code() == Some(ErrorCode::DatabaseBusy) && begun.elapsed() < PATIENCE => {
                thread::sleep(Duration::from_millis(2));
            }
            answer => return answer,
        }
    }
}

fn tables_of(database: &Connection) -> Result<i64, StoreError> {
    Ok(database.query_row("SELECT COUNT(*) FROM sqlite_master", [], |row| row.get(0))?)
}

/// Writes the set-up into an empty database, whole or not at all; whether it was empty still when its turn came.
fn begin<X: Flat>(database: &Connection, layout: &Layout, ensemble: &dyn Told<X>) -> Result<bool, StoreError> {
    let transaction = Transaction::new_unchecked(database, TransactionBehavior::Immediate)?;
    let is_empty = tables_of(database)? == 0;
    if is_empty {
        ensemble.begin(database, layout)?;
    }
    transaction.commit()?;
    Ok(is_empty)
}

/// A store that is open.
pub(super) struct Store {
    pub(super) database: Connection,
    layout: Layout,
}

impl Store {
    /// Opens the store of an ensemble, or makes it.
    pub(super) fn open<X: Flat>(path: &Path, ensemble: &dyn Told<X>) -> Result<Self, StoreError> {
        if let Ok(file) = std::fs::metadata(path) {
            if file.is_dir() {
                return Err(StoreError::Folder);
            }
            // SQLite takes the beginning of a database for an empty one.
            if (1..SMALLEST).contains(&file.len()) {
                return Err(StoreError::NotADatabase);
            }
        }
        // What begins with a root is a path: SQLite takes other names for URIs, for memory, or for a file of nobody.
        let path = std::path::absolute(path).map_err(|_| StoreError::NoPath)?;
        if path.parent().is_some_and(|folder| !folder.is_dir()) {
            return Err(StoreError::NoFolder);
        }
        let flags = OpenFlags::SQLITE_OPEN_READ_WRITE | OpenFlags::SQLITE_OPEN_CREATE | OpenFlags::SQLITE_OPEN_NO_MUTEX;
        let database = Connection::open_with_flags(path, flags)?;
        database.busy_timeout(PATIENCE)?;
        let sound: String = database.query_row("PRAGMA quick_check(1)", [], |row| row.get(0))?;
        if sound != "ok" {
            return Err(StoreError::Damaged);
        }
        let tables = tables_of(&database)?;
        let known_by = "SELECT EXISTS (SELECT * FROM sqlite_master WHERE name = ?)";
        let known = TABLES.into_iter().try_fold(true, |known, name| {
            Ok::<_, StoreError>(known & database.query_row(known_by, [name], |row| row.get::<_, bool>(0))?)
        });
        if tables > 0 && !known? {
            return Err(StoreError::NotAnEnsemble);
        }
        // Others may read while this writes, and what is committed outlives the process. The loss of power may take the last blocks, not
        // the file: they are moved again. Where there is no WAL, as on a network, every block waits for the disk.
        let journal: String = patiently(|| database.query_row("PRAGMA journal_mode = WAL", [], |row| row.get(0)))?;
        let synchronous = if journal.eq_ignore_ascii_case("wal") { "NORMAL" } else { "FULL" };
        database.execute_batch(&format!("PRAGMA synchronous = {synchronous}"))?;
        let layout = Layout::of::<X>(ensemble.columns());
        if tables > 0 || !begin(&database, &layout, ensemble)? {
            ensemble.compare(&database, &layout)?;
        }
        Ok(Store { database, layout })
    }

    /// Which members are in it and did not fail.
    pub(super) fn done(&self, members: usize) -> Result<Vec<bool>, StoreError> {
        let mut done = vec![false; members];
        let mut statement = of_table("last", self.database.prepare("SELECT k FROM last WHERE failed IS NULL"))?;
        let mut rows = statement.query([])?;
        while let Some(row) = rows.next()? {
            let k: i64 = row.get(0)?;
            let place = usize::try_from(k).ok().and_then(|k| done.get_mut(k));
            *place.ok_or(StoreError::Changed { table: "last", member: k.cast_unsigned() })? = true;
        }
        Ok(done)
    }

    /// Writes what was moved, and puts what was done between it.
    pub(super) fn hand_over<X: Flat>(
        &self,
        plan: &dyn Told<X>,
        members: Range<usize>,
        moved: Moved<X>,
    ) -> Result<Vec<Outcome<X>>, Error> {
        let mut stored = Vec::new();
        if moved.len() < members.len() {
            read(&self.database, &self.layout, members.clone(), &mut |k, run| stored.push((k, run)))
                .map_err(Error::Store)?;
        }
        if !moved.is_empty() {
            self.write(members.clone(), &moved)?;
        }
        let mut moved = moved.into_iter().peekable();
        let mut stored = stored.into_iter().peekable();
        members
            .map(|k| match (moved.next_if(|&(of, _)| of == k), stored.next_if(|&(of, _)| of == k)) {
                (Some((_, outcome)), _) => Ok(outcome),
                (None, Some((_, run))) => Ok(Ok(plan.restore(k, run)?)),
                (None, None) => Err(Error::Store(StoreError::Changed { table: "last", member: k as u64 })),
            })
            .collect()
    }

    /// Writes members, all of them or none.
    fn write<X: Flat>(&self, members: Range<usize>, moved: &[(usize, Outcome<X>)]) -> Result<(), StoreError> {
        let transaction = self.database.unchecked_transaction()?;
        let range = [members.start, members.end].map(|k| (k as u64).cast_signed());
        for (table, forget) in self.layout.forget() {
            of_table(table, self.database.prepare_cached(&forget))?.execute(range)?;
        }
        let mut members = Writers::new::<X>(&self.database, &self.layout)?;
        moved.iter().try_for_each(|(k, member)| members.write(*k, member))?;
        drop(members);
        Ok(transaction.commit()?)
    }

    /// Adds the checksum of the results.
    pub(super) fn close(self, sum: Checksum) -> Result<(), StoreError> {
        set(&self.database, "checksum", &Value::Text(format!("{:016x}", sum.value())))?;
        self.database.close().map_err(|(_, error)| error.into())
    }
}
