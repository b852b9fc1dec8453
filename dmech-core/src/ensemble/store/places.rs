//! States as a store has them: in the row of whoever is in them, or, where bodies have rows of their own, beside it.

use core::iter::Peekable;
use core::ops::Range;

use rusqlite::{Connection, params_from_iter, types::Value};

use super::layout::Layout;
use super::table::{Reader, Writer, of_table};
use crate::error::StoreError;
use crate::flat::Flat;

/// What of a state stands in the row of its owner: all, or its time and how many bodies there are.
pub(super) struct Head {
    pub(super) numbers: Vec<f64>,
    bodies: u64,
}

impl Head {
    /// Of the numbers of a state.
    pub(super) fn of<X: Flat>(flat: &[f64]) -> Self {
        let own = if X::LISTED { 1 } else { flat.len() };
        Head { numbers: flat[..own].to_vec(), bodies: ((flat.len() - own) / X::BODY) as u64 }
    }

    pub(super) fn put<X: Flat>(&self, row: &mut Writer<'_>) -> Result<(), StoreError> {
        row.numbers(&self.numbers)?;
        if X::LISTED { row.count(self.bodies) } else { Ok(()) }
    }

    pub(super) fn put_bits(&self, row: &mut Writer<'_>) -> Result<(), StoreError> {
        row.bits(&self.numbers)
    }

    pub(super) fn read<X: Flat>(row: &mut Reader<'_>) -> Option<Self> {
        let mut numbers = vec![0.0; if X::LISTED { 1 } else { 1 + X::BODY }];
        row.numbers(&mut numbers)?;
        let bodies = if X::LISTED { row.count()? } else { 0 };
        Some(Head { numbers, bodies })
    }

    /// Replaces its numbers by their bits, if they were written so.
    pub(super) fn read_bits(mut self, row: &mut Reader<'_>) -> Option<Self> {
        row.bits(&mut self.numbers)?;
        Some(self)
    }
}

/// Whose state it is: the start of a member, its end, an event, what that changed it to, a state that was recorded.
pub(super) type What = &'static str;

/// Writes the bodies of states.
pub(super) struct BodyWriter<'a>(Option<Writer<'a>>);

impl<'a> BodyWriter<'a> {
    pub(super) fn new<X: Flat>(database: &'a Connection, layout: &Layout) -> Result<Self, StoreError> {
        Ok(BodyWriter(if X::LISTED { Some(Writer::new(database, layout, "body")?) } else { None }))
    }

    /// Writes those of the n-th state of a kind.
    pub(super) fn write<X: Flat>(&mut self, k: u64, what: What, n: u64, flat: &[f64]) -> Result<(), StoreError> {
        let Some(row) = &mut self.0 else { return Ok(()) };
        for (body, numbers) in flat[1..].chunks_exact(X::BODY).enumerate() {
            row.count(k)?;
            row.put(what)?;
            row.count(n)?;
            row.count(body as u64)?;
            row.numbers(numbers)?;
            row.bits(numbers)?;
            row.end()?;
        }
        Ok(())
    }
}

/// The bodies of states of one kind, in their order.
pub(super) struct Placed(Peekable<std::vec::IntoIter<(u64, Body)>>);

struct Body {
    n: u64,
    body: u64,
    numbers: Vec<f64>,
}

impl Placed {
    pub(super) fn read<X: Flat>(
        database: &Connection,
        layout: &Layout,
        what: What,
        members: &Range<usize>,
    ) -> Result<Self, StoreError> {
        let body = |row: &mut Reader<'_>| {
            row.text()?;
            let (n, body, mut numbers) = (row.count()?, row.count()?, vec![0.0; X::BODY]);
            row.numbers(&mut numbers)?;
            row.bits(&mut numbers)?;
            Some(Body { n, body, numbers })
        };
        let all = if X::LISTED { rows(database, layout, "body", Some(what), members, body)? } else { Vec::new() };
        Ok(Placed(all.into_iter().peekable()))
    }

    /// The numbers of the n-th state; or the member that has too few bodies, or too many.
    pub(super) fn flat(&mut self, k: u64, n: u64, head: Head) -> Result<Vec<f64>, u64> {
        let mut flat = head.numbers;
        for i in 0..head.bodies {
            match self.0.next_if(|(of, body)| (*of, body.n, body.body) == (k, n, i)) {
                Some((_, body)) => flat.extend(body.numbers),
                None => return Err(self.0.peek().map_or(k, |(of, _)| k.min(*of))),
            }
        }
        Ok(flat)
    }

    /// A member of which there is more than its states have.
    pub(super) fn left(&mut self) -> Option<u64> {
        self.0.next().map(|(k, _)| k)
    }
}

/// The rows of members, each with the number of its member.
pub(super) fn rows<T>(
    database: &Connection,
    layout: &Layout,
    table: &'static str,
    what: Option<What>,
    members: &Range<usize>,
    read: impl Fn(&mut Reader<'_>) -> Option<T>,
) -> Result<Vec<(u64, T)>, StoreError> {
    let mut statement = of_table(table, database.prepare_cached(&layout.select(table)))?;
    let numbers = [members.start, members.end].map(|k| Value::Integer(k as i64));
    let values = what.map(|what| Value::Text(what.to_owned())).into_iter().chain(numbers);
    let (mut rows, mut all) = (statement.query(params_from_iter(values))?, Vec::new());
    while let Some(row) = rows.next()? {
        let mut row = Reader::new(row);
        let member = row.count().ok_or(StoreError::Changed { table, member: 0 })?;
        all.push((member, read(&mut row).ok_or(StoreError::Changed { table, member })?));
    }
    Ok(all)
}
