//! What an ensemble is set up from, and whether a store has the same.

use core::ops::Range;

use rusqlite::Connection;
use rusqlite::types::Value;

use super::layout::Layout;
use super::places::{BodyWriter, Head, Placed, rows};
use super::settings::{beside, get, set};
use super::table::{Reader, Writer};
use crate::ensemble::Checksum;
use crate::ensemble::told::{Named, SetUp, Told};
use crate::error::StoreError;
use crate::flat::Flat;
use crate::name::Name;
use crate::words::word;

/// Members whose rows are read at once.
const MANY: usize = 256;

/// The row of a member, but for its bodies and the list of its numbers.
struct Row {
    words: Vec<String>,
    numbers: Vec<f64>,
    start: Head,
    acts: u64,
    seal: u64,
}

fn row<X: Flat>(row: &mut Reader<'_>, columns: &Named) -> Option<Row> {
    let words = columns.words.iter().map(|_| Some(row.text()?.to_owned())).collect::<Option<_>>()?;
    let mut numbers = vec![0.0; columns.numbers.len()];
    row.numbers(&mut numbers)?;
    let (mut start, acts) = (Head::read::<X>(row)?, row.count()?);
    let own = numbers.len();
    numbers.append(&mut start.numbers);
    row.bits(&mut numbers)?;
    start.numbers = numbers.split_off(own);
    Some(Row { words, numbers, start, acts, seal: row.count()? })
}

fn number(row: &mut Reader<'_>) -> Option<(&'static str, f64)> {
    row.count()?;
    let (name, mut value) = (word(row.text()?), [0.0]);
    row.numbers(&mut value)?;
    row.bits(&mut value)?;
    Some((name, value[0]))
}

impl<X: Flat> dyn Told<X> + '_ {
    /// Writes the set-up of all members into an empty database.
    pub(super) fn begin(&self, database: &Connection, layout: &Layout) -> Result<(), StoreError> {
        database.execute_batch(&layout.create())?;
        for (key, value) in self.settings() {
            set(database, key, &value)?;
        }
        let mut all = Checksum::default();
        let mut row = Writer::new(database, layout, "member")?;
        let mut list = if layout.has_lists() { Some(Writer::new(database, layout, "number")?) } else { None };
        let mut bodies = BodyWriter::new::<X>(database, layout)?;
        for k in 0..self.members() {
            let member = self.set_up(k);
            let (seal, head, k) = (member.seal(k), Head::of::<X>(&member.start), k as u64);
            row.count(k)?;
            member.words.iter().try_for_each(|word| row.put(word))?;
            row.numbers(&member.numbers)?;
            head.put::<X>(&mut row)?;
            row.count(member.acts)?;
            row.bits(&[member.numbers, head.numbers].concat())?;
            row.count(seal)?;
            row.end()?;
            bodies.write::<X>(k, "start", 0, &member.start)?;
            for (n, &(name, value)) in member.list.iter().enumerate() {
                let Some(row) = &mut list else { break };
                row.count(k)?;
                row.count(n as u64)?;
                row.put(name)?;
                row.numbers(&[value])?;
                row.bits(&[value])?;
                row.end()?;
            }
            all.word(seal);
        }
        drop((row, list, bodies));
        set(database, "set_up", &Value::Text(format!("{:016x}", all.value())))
    }

    /// Refuses a store of another ensemble, with what differs.
    pub(super) fn compare(&self, database: &Connection, layout: &Layout) -> Result<(), StoreError> {
        self.compare_settings(database)?;
        let mut all = Checksum::default();
        for from in (0..self.members()).step_by(MANY) {
            let members = from..self.members().min(from + MANY);
            self.compare_some(database, layout, members, &mut all)?;
        }
        let whole = Value::Text(format!("{:016x}", all.value()));
        let more = rows(database, layout, "member", None, &(self.members()..i64::MAX as usize), |_| Some(()))?;
        if !more.is_empty() || get(database, "set_up")? != Some(whole) {
            return Err(StoreError::Setting { key: "set_up" });
        }
        Ok(())
    }

    fn compare_some(
        &self,
        database: &Connection,
        layout: &Layout,
        members: Range<usize>,
        all: &mut Checksum,
    ) -> Result<(), StoreError> {
        let columns = &layout.columns;
        let mut stored = rows(database, layout, "member", None, &members, |it| row::<X>(it, columns))?.into_iter();
        let lists = if layout.has_lists() { rows(database, layout, "number", None, &members, number)? } else { vec![] };
        let (mut lists, mut starts) =
            (lists.into_iter().peekable(), Placed::read::<X>(database, layout, "start", &members)?);
        for k in members {
            let changed = StoreError::Changed { table: "member", member: k as u64 };
            let (number, Row { words, numbers, start, acts, seal }) = stored.next().ok_or(changed)?;
            let start = starts.flat(number, 0, start);
            let start = start.map_err(|member| StoreError::Changed { table: "member", member })?;
            let list = core::iter::from_fn(|| lists.next_if(|&(of, _)| of == number)).map(|(_, it)| it).collect();
            let store = SetUp { words, numbers, start, list, acts };
            if number != k as u64 || seal != store.seal(k) {
                return Err(changed);
            }
            if let Some(difference) = difference(k as u64, layout, &store, &self.set_up(k)) {
                return Err(difference);
            }
            all.word(seal);
        }
        starts.left().map_or(Ok(()), |member| Err(StoreError::Changed { table: "member", member }))
    }
}

/// What differs first between the set-up of a member in the store and the one here.
fn difference(member: u64, layout: &Layout, store: &SetUp, here: &SetUp) -> Option<StoreError> {
    let mut words = layout.columns.words.iter().zip(store.words.iter().zip(&here.words));
    if let Some((&column, (store, here))) = words.find(|(_, (store, here))| store != here) {
        let (store, here) = beside(store, here);
        return Some(StoreError::Words { member, column, store: word(store.text()), here });
    }
    let of = |column, store, here| StoreError::Member { member, column, store, here };
    let apart = |store: &[f64], here: &[f64]| store.iter().zip(here).position(|(a, b)| a.to_bits() != b.to_bits());
    if let Some(i) = apart(&store.numbers, &here.numbers) {
        return Some(of(Name::of(&[&layout.columns.numbers[i]]), store.numbers[i], here.numbers[i]));
    }
    if store.start.len() != here.start.len() {
        return Some(StoreError::Numbers { member, name: "bodies" });
    }
    if let Some(i) = apart(&store.start, &here.start) {
        return Some(of(layout.number(i), store.start[i], here.start[i]));
    }
    if let Some(difference) = difference_of_lists(member, &store.list, &here.list) {
        return Some(difference);
    }
    (store.acts != here.acts).then_some(StoreError::Acts { member })
}

/// What differs first between two lists of numbers with their names.
fn difference_of_lists(member: u64, store: &[(&'static str, f64)], here: &[(&'static str, f64)]) -> Option<StoreError> {
    let alike = store.iter().zip(here).take_while(|((a, x), (b, y))| a == b && x.to_bits() == y.to_bits()).count();
    let name = match (store.get(alike), here.get(alike)) {
        (None, None) => return None,
        (Some(&(name, store)), Some(&(other, here))) if name == other => {
            return Some(StoreError::Member { member, column: Name::of(&[name]), store, here });
        }
        // The numbers of one name go on where in the other list those of the next have begun.
        (Some(&(name, _)), Some(&(other, _))) if store[alike..].iter().any(|&(later, _)| later == other) => name,
        (_, Some(&(name, _))) | (Some(&(name, _)), None) => name,
    };
    Some(StoreError::Numbers { member, name })
}
