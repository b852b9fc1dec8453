//! Rows of numbers that come back to the bit.

use rusqlite::types::ValueRef;
use rusqlite::{CachedStatement, Connection, ErrorCode, Row, ToSql};

use super::layout::Layout;
use crate::error::StoreError;

/// NaN is NULL in SQLite, and −0 may become 0.
fn is_lost(x: f64) -> bool {
    x.is_nan() || (x == 0.0 && x.is_sign_negative())
}

/// What was asked of a table, unless it, or a column, is not there: SQLite calls that a logic error.
pub(super) fn of_table<T>(table: &'static str, asked: rusqlite::Result<T>) -> Result<T, StoreError> {
    use rusqlite::Error::{SqlInputError, SqliteFailure};
    asked.map_err(|refused| match refused {
        SqlInputError { .. } => StoreError::Missing { table },
        SqliteFailure(cause, _) if cause.code == ErrorCode::Unknown => StoreError::Missing { table },
        refused => refused.into(),
    })
}

/// A row that is written from left to right.
pub(super) struct Writer<'a> {
    statement: CachedStatement<'a>,
    column: usize,
}

impl<'a> Writer<'a> {
    pub(super) fn new(database: &'a Connection, layout: &Layout, table: &'static str) -> Result<Self, StoreError> {
        Ok(Writer { statement: of_table(table, database.prepare_cached(&layout.insert(table)))?, column: 0 })
    }

    pub(super) fn put(&mut self, value: impl ToSql) -> Result<(), StoreError> {
        self.column += 1;
        Ok(self.statement.raw_bind_parameter(self.column, value)?)
    }

    /// Counts above 2⁶³ keep their bits.
    pub(super) fn count(&mut self, n: u64) -> Result<(), StoreError> {
        self.put(n.cast_signed())
    }

    pub(super) fn numbers(&mut self, numbers: &[f64]) -> Result<(), StoreError> {
        numbers.iter().try_for_each(|x| self.put(x))
    }

    /// The numbers once more, if SQLite would not give them back.
    pub(super) fn bits(&mut self, numbers: &[f64]) -> Result<(), StoreError> {
        let any = numbers.iter().any(|&x| is_lost(x));
        self.put(any.then(|| numbers.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<_>>()))
    }

    pub(super) fn end(&mut self) -> Result<(), StoreError> {
        self.column = 0;
        self.statement.raw_execute()?;
        Ok(())
    }
}

/// A row that is read from left to right.
pub(super) struct Reader<'a> {
    row: &'a Row<'a>,
    column: usize,
}

impl<'a> Reader<'a> {
    pub(super) fn new(row: &'a Row<'a>) -> Self {
        Reader { row, column: 0 }
    }

    fn next(&mut self) -> Option<ValueRef<'a>> {
        self.column += 1;
        self.row.get_ref(self.column - 1).ok()
    }

    /// A whole number; none where something else stands.
    pub(super) fn count(&mut self) -> Option<u64> {
        if let ValueRef::Integer(n) = self.next()? { Some(n.cast_unsigned()) } else { None }
    }

    /// A whole number that need not be there; none where something else stands.
    pub(super) fn count_if_any(&mut self) -> Option<Option<u64>> {
        match self.next()? {
            ValueRef::Null => Some(None),
            ValueRef::Integer(n) => Some(Some(n.cast_unsigned())),
            _ => None,
        }
    }

    /// Whether there is something.
    pub(super) fn is_some(&mut self) -> Option<bool> {
        Some(!matches!(self.next()?, ValueRef::Null))
    }

    /// Text; none where something else stands.
    pub(super) fn text(&mut self) -> Option<&'a str> {
        self.next()?.as_str().ok()
    }

    /// Numbers, as far as SQLite keeps them.
    pub(super) fn numbers(&mut self, numbers: &mut [f64]) -> Option<()> {
        for x in numbers {
            *x = match self.next()? {
                ValueRef::Real(x) => x,
                ValueRef::Null => f64::NAN,
                _ => return None,
            };
        }
        Some(())
    }

    /// The same numbers once more, if they were written so; none where they are others, but for what SQLite does not keep.
    pub(super) fn bits(&mut self, numbers: &mut [f64]) -> Option<()> {
        match self.next()? {
            ValueRef::Null => Some(()),
            ValueRef::Blob(bytes) if bytes.len() == 8 * numbers.len() => {
                let (eights, _) = bytes.as_chunks();
                numbers.iter_mut().zip(eights).try_for_each(|(x, &eight)| {
                    let kept = core::mem::replace(x, f64::from_le_bytes(eight));
                    (kept == *x || kept.is_nan() && x.is_nan()).then_some(())
                })
            }
            _ => None,
        }
    }
}
