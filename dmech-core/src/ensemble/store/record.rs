//! What became of a member, as a store has it.

use core::ops::Range;
use std::time::Duration;

use rusqlite::Connection;

use super::layout::Layout;
use super::table::{Reader, Seal, Writer};
use crate::ensemble::Outcome;
use crate::error::StoreError;
use crate::invariant::{Drift, Invariant, OwnDrifts};
use crate::run::{Crossing, Event, Interrupted, Restored, Work};
use crate::state::State;
use crate::words::{Word, word};

const KNOWN: usize = Invariant::ALL.len();

fn flat<const D: usize>(state: &State<D>) -> Vec<f64> {
    [state.t].iter().chain(&state.q).chain(&state.v).copied().collect()
}

fn state<const D: usize>(row: &mut Reader<'_>) -> Option<State<D>> {
    let mut state = State::new([0.0; D], [0.0; D]);
    row.numbers(core::slice::from_mut(&mut state.t))?;
    row.numbers(&mut state.q)?;
    row.numbers(&mut state.v)?;
    Some(state)
}

/// Replaces a state by its bits, if it was written so.
fn with_bits<const D: usize>(row: &mut Reader<'_>, state: State<D>) -> Option<State<D>> {
    let mut numbers = flat(&state);
    row.bits(&mut numbers)?;
    let [q, v] = [1, 1 + D].map(|from| core::array::from_fn(|i| numbers[from + i]));
    Some(State { t: numbers[0], q, v })
}

/// Those that there are, each with its number and its name: of all laws, then of this one and those that were watched.
fn drifts<X>(run: &Restored<X>) -> impl Iterator<Item = (usize, String, Drift)> + '_ {
    let all = Invariant::ALL.into_iter().map(|of| Some((of.to_string(), run.drifts[of as usize]?)));
    let own = run.own.iter().map(|(name, drift)| Some((name.to_owned(), drift)));
    all.chain(own).enumerate().filter_map(|(number, drift)| drift.map(|(name, drift)| (number, name, drift)))
}

fn rising<X>(event: &Event<X>) -> u64 {
    u64::from(event.crossing() == Crossing::Rising)
}

/// What says whether all that belongs to a member is as it was written.
fn seal<const D: usize>(k: usize, run: &Restored<State<D>>) -> i64 {
    let mut seal = Seal::default();
    seal.count(k as u64);
    seal.numbers(&flat(&run.last));
    let Work { steps, evaluations, iterations, rough, elapsed, range } = run.work;
    let counts = [run.stopped.into(), steps, evaluations, iterations, rough, elapsed.as_nanos() as u64];
    counts.into_iter().for_each(|n| seal.count(n));
    range.iter().for_each(|range| seal.numbers(range));
    for (number, name, drift) in drifts(run) {
        seal.count(number as u64);
        name.bytes().for_each(|byte| seal.count(byte.into()));
        seal.numbers(&drift.fields());
    }
    for event in &run.events {
        [event.which() as u64, rising(event)].into_iter().for_each(|n| seal.count(n));
        seal.numbers(&flat(event.state()));
    }
    run.states.iter().for_each(|state| seal.numbers(&flat(state)));
    seal.value()
}

/// The statements that write members.
pub(super) struct Members<'a> {
    last: Writer<'a>,
    drift: Writer<'a>,
    event: Writer<'a>,
    state: Writer<'a>,
}

impl<'a> Members<'a> {
    pub(super) fn new(database: &'a Connection, layout: &Layout) -> Result<Self, StoreError> {
        let writer = |table| Writer::new(database, &layout.insert(table));
        Ok(Members { last: writer("last")?, drift: writer("drift")?, event: writer("event")?, state: writer("state")? })
    }

    /// Writes a member.
    pub(super) fn write<const D: usize>(&mut self, k: usize, member: &Outcome<State<D>>) -> Result<(), StoreError> {
        let run = member.as_ref().unwrap_or_else(Interrupted::run).to_restore();
        let (k, row, last) = (k as u64, &mut self.last, flat(&run.last));
        row.count(k)?;
        row.put(member.as_ref().err().map(|failed| failed.cause().to_string()))?;
        row.numbers(&last)?;
        let Work { steps, evaluations, iterations, rough, elapsed, range } = run.work;
        let nanoseconds = elapsed.as_nanos() as u64;
        let counts = [run.stopped.into(), steps, evaluations, iterations, rough, nanoseconds];
        counts.into_iter().try_for_each(|n| row.count(n))?;
        row.put(range.map(|[shortest, _]| shortest))?;
        row.put(range.map(|[_, longest]| longest))?;
        row.bits(&last)?;
        row.put(seal(k as usize, &run))?;
        row.end()?;
        for (number, name, drift) in drifts(&run) {
            let (row, fields) = (&mut self.drift, drift.fields());
            row.count(k)?;
            row.count(number as u64)?;
            row.numbers(&fields)?;
            row.bits(&fields)?;
            row.numbers(&[drift.max_relative(), drift.slope()])?;
            row.put(name)?;
            row.end()?;
        }
        for (n, event) in run.events.iter().enumerate() {
            let (row, numbers) = (&mut self.event, flat(event.state()));
            [k, n as u64, event.which() as u64, rising(event)].into_iter().try_for_each(|n| row.count(n))?;
            row.numbers(&numbers)?;
            row.bits(&numbers)?;
            row.end()?;
        }
        for (n, state) in run.states.iter().enumerate() {
            let (row, numbers) = (&mut self.state, flat(state));
            row.count(k)?;
            row.count(n as u64)?;
            row.numbers(&numbers)?;
            row.bits(&numbers)?;
            row.end()?;
        }
        Ok(())
    }
}

/// Reads members that did not fail, and hands each over with its number, in order.
pub(super) fn read<const D: usize>(
    database: &Connection,
    layout: &Layout,
    members: Range<usize>,
    take: &mut dyn FnMut(usize, Restored<State<D>>),
) -> Result<(), StoreError> {
    let (from, to) = (members.start as i64, members.end as i64);
    let mut drifts = rows(database, &layout.select("drift"), [from, to], "drift", drift_of)?.into_iter().peekable();
    let mut events = rows(database, &layout.select("event"), [from, to], "event", happened)?.into_iter().peekable();
    let mut states = rows(database, &layout.select("state"), [from, to], "state", recorded)?.into_iter().peekable();
    for (k, (mut run, failed, sealed)) in rows(database, &layout.select("last"), [from, to], "last", end)? {
        let changed = StoreError::Changed { table: "last", member: k };
        while let Some((_, (number, name, drift))) = drifts.next_if(|&(of, _)| of == k) {
            match run.drifts.get_mut(number) {
                Some(place) => *place = Some(drift),
                None => run.own.add(name, drift),
            }
        }
        while let Some((_, event)) = events.next_if(|&(of, _)| of == k) {
            run.events.push(event);
        }
        while let Some((_, state)) = states.next_if(|&(of, _)| of == k) {
            run.states.push(state);
        }
        let number = usize::try_from(k).map_err(|_| changed)?;
        if sealed != seal(number, &run) {
            return Err(changed);
        }
        if !failed {
            take(number, run);
        }
    }
    // What belongs to nobody.
    let left = drifts.next().map(|(k, _)| ("drift", k));
    let left = left.or_else(|| events.next().map(|(k, _)| ("event", k)));
    let left = left.or_else(|| states.next().map(|(k, _)| ("state", k)));
    left.map_or(Ok(()), |(table, member)| Err(StoreError::Changed { table, member }))
}

/// The rows of members, each with the number of its member.
fn rows<T>(
    database: &Connection,
    select: &str,
    members: [i64; 2],
    table: &'static str,
    read: impl Fn(&mut Reader<'_>) -> Option<T>,
) -> Result<Vec<(u64, T)>, StoreError> {
    let mut statement = database.prepare_cached(select)?;
    let (mut rows, mut all) = (statement.query(members)?, Vec::new());
    while let Some(row) = rows.next()? {
        let mut row = Reader::new(row);
        let member = row.count().ok_or(StoreError::Changed { table, member: 0 })?;
        all.push((member, read(&mut row).ok_or(StoreError::Changed { table, member })?));
    }
    Ok(all)
}

/// The row of the end of a member, whether it failed, and its seal.
fn end<const D: usize>(row: &mut Reader<'_>) -> Option<(Restored<State<D>>, bool, i64)> {
    let failed = row.is_some()?;
    let last = state(row)?;
    let mut counts = [0; 6];
    for n in &mut counts {
        *n = row.count()?;
    }
    let mut range = [0.0; 2];
    row.numbers(&mut range)?;
    let last = with_bits(row, last)?;
    let sealed = row.count()?.cast_signed();
    let [stopped, steps, evaluations, iterations, rough, nanoseconds] = counts;
    let stopped = stopped != 0;
    let elapsed = Duration::from_nanos(nanoseconds);
    let range = (!range[0].is_nan()).then_some(range);
    let work = Work { steps, evaluations, iterations, rough, elapsed, range };
    let (states, events, drifts, own) = (Vec::new(), Vec::new(), [None; KNOWN], OwnDrifts::default());
    let run = Restored { last, states, events, stopped, drifts, own, work };
    Some((run, failed, sealed))
}

fn drift_of(row: &mut Reader<'_>) -> Option<(usize, Word, Drift)> {
    let number = usize::try_from(row.count()?).ok()?;
    let mut fields = [0.0; 8];
    row.numbers(&mut fields)?;
    row.bits(&mut fields)?;
    let (drift, mut shown) = (Drift::by_field(|i| fields[i]), [0.0; 2]);
    row.numbers(&mut shown)?;
    // What is there for people is not read, but must not tell them something else.
    let agree = |a: f64, b: f64| a == b || (a.is_nan() && b.is_nan());
    let agrees = agree(shown[0], drift.max_relative()) && agree(shown[1], drift.slope());
    let name = word(row.text()?);
    agrees.then_some((number, name, drift))
}

fn happened<const D: usize>(row: &mut Reader<'_>) -> Option<Event<State<D>>> {
    row.count()?;
    let (which, rising) = (usize::try_from(row.count()?).ok()?, row.count()? != 0);
    let state = state(row)?;
    let crossing = if rising { Crossing::Rising } else { Crossing::Falling };
    Some(Event::new(which, with_bits(row, state)?, crossing, None))
}

fn recorded<const D: usize>(row: &mut Reader<'_>) -> Option<State<D>> {
    row.count()?;
    let state = state(row)?;
    with_bits(row, state)
}
