//! What became of a member, as a store has it.

use core::ops::Range;
use std::time::Duration;

use rusqlite::Connection;

use super::layout::Layout;
use super::places::{BodyWriter, Head, Placed, What, rows};
use super::table::{Reader, Writer};
use crate::drift::{Drift, Drifts, OwnDrifts};
use crate::ensemble::{Checksum, Outcome};
use crate::error::StoreError;
use crate::flat::Flat;
use crate::invariant::Invariant;
use crate::run::{Cost, Crossing, Event, Interrupted, Restored};
use crate::words::{Word, word};

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
fn seal<X: Flat>(k: u64, failed: bool, run: &Restored<X>) -> i64 {
    let mut seal = Checksum::default();
    [k, failed.into()].into_iter().for_each(|n| seal.word(n));
    seal.list(&run.last.flat());
    let Cost { steps, evaluations, iterations, rough, elapsed, range } = run.work;
    let counts = [run.stopped.into(), steps, evaluations, iterations, rough, elapsed.as_nanos() as u64];
    counts.into_iter().for_each(|n| seal.word(n));
    range.iter().for_each(|range| seal.list(range));
    for (number, name, drift) in drifts(run) {
        seal.word(number as u64);
        seal.text(&name);
        seal.list(&drift.fields());
    }
    for event in &run.events {
        [event.which() as u64, rising(event)].into_iter().for_each(|n| seal.word(n));
        event.bodies().into_iter().flatten().for_each(|body| seal.word(body as u64));
        seal.list(&event.state().flat());
        event.after().iter().for_each(|after| seal.list(&after.flat()));
    }
    run.states.iter().for_each(|state| seal.list(&state.flat()));
    seal.value().cast_signed()
}

/// The statements that write members.
pub(super) struct Writers<'a> {
    last: Writer<'a>,
    drift: Writer<'a>,
    event: Writer<'a>,
    change: Writer<'a>,
    state: Writer<'a>,
    bodies: BodyWriter<'a>,
}

impl<'a> Writers<'a> {
    pub(super) fn new<X: Flat>(database: &'a Connection, layout: &Layout) -> Result<Self, StoreError> {
        let writer = |table| Writer::new(database, layout, table);
        let [last, drift, event] = [writer("last")?, writer("drift")?, writer("event")?];
        let [change, state] = [writer("change")?, writer("state")?];
        Ok(Writers { last, drift, event, change, state, bodies: BodyWriter::new::<X>(database, layout)? })
    }

    /// Writes a member.
    pub(super) fn write<X: Flat>(&mut self, k: usize, member: &Outcome<X>) -> Result<(), StoreError> {
        let run = member.as_ref().unwrap_or_else(Interrupted::run).to_restore();
        let (k, row, last) = (k as u64, &mut self.last, run.last.flat());
        let head = Head::of::<X>(&last);
        row.count(k)?;
        row.put(member.as_ref().err().map(|failed| failed.cause().to_string()))?;
        head.put::<X>(row)?;
        let Cost { steps, evaluations, iterations, rough, elapsed, range } = run.work;
        let nanoseconds = elapsed.as_nanos() as u64;
        let counts = [run.stopped.into(), steps, evaluations, iterations, rough, nanoseconds];
        counts.into_iter().try_for_each(|n| row.count(n))?;
        row.put(range.map(|[shortest, _]| shortest))?;
        row.put(range.map(|[_, longest]| longest))?;
        head.put_bits(row)?;
        row.put(seal(k, member.is_err(), &run))?;
        row.end()?;
        self.bodies.write::<X>(k, "last", 0, &last)?;
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
            let (row, numbers) = (&mut self.event, event.state().flat());
            let head = Head::of::<X>(&numbers);
            [k, n as u64, event.which() as u64, rising(event)].into_iter().try_for_each(|n| row.count(n))?;
            if X::LISTED {
                let body = |i: usize| event.bodies().map(|bodies| bodies[i] as i64);
                [0, 1].into_iter().try_for_each(|i| row.put(body(i)))?;
            }
            head.put::<X>(row)?;
            head.put_bits(row)?;
            row.end()?;
            self.bodies.write::<X>(k, "event", n as u64, &numbers)?;
            if let Some(after) = event.after() {
                write_state(&mut self.change, &mut self.bodies, ("change", k, n), after)?;
            }
        }
        for (n, state) in run.states.iter().enumerate() {
            write_state(&mut self.state, &mut self.bodies, ("state", k, n), state)?;
        }
        Ok(())
    }
}

/// Writes the n-th state of a kind.
fn write_state<X: Flat>(
    row: &mut Writer<'_>,
    bodies: &mut BodyWriter<'_>,
    (what, k, n): (What, u64, usize),
    state: &X,
) -> Result<(), StoreError> {
    let numbers = state.flat();
    let head = Head::of::<X>(&numbers);
    row.count(k)?;
    row.count(n as u64)?;
    head.put::<X>(row)?;
    head.put_bits(row)?;
    row.end()?;
    bodies.write::<X>(k, what, n as u64, &numbers)
}

/// Reads members that did not fail, and hands each over with its number, in order.
pub(super) fn read<X: Flat>(
    database: &Connection,
    layout: &Layout,
    members: Range<usize>,
    take: &mut dyn FnMut(usize, Restored<X>),
) -> Result<(), StoreError> {
    let placed = |what| Placed::read::<X>(database, layout, what, &members);
    let (mut ends, mut passed) = (placed("last")?, placed("event")?);
    let (mut gone_on, mut seen) = (placed("change")?, placed("state")?);
    let mut drifts = rows(database, layout, "drift", None, &members, drift_of)?.into_iter().peekable();
    let mut events = rows(database, layout, "event", None, &members, happened::<X>)?.into_iter().peekable();
    let mut changes = rows(database, layout, "change", None, &members, recorded::<X>)?.into_iter().peekable();
    let mut states = rows(database, layout, "state", None, &members, recorded::<X>)?.into_iter().peekable();
    for (k, end) in rows(database, layout, "last", None, &members, end::<X>)? {
        let changed = StoreError::Changed { table: "last", member: k };
        let place = |placed: &mut Placed, n, head| {
            let flat = placed.flat(k, n, head).map_err(|member| StoreError::Changed { table: "body", member })?;
            let state = X::of_flat(&flat);
            // A number that is none of the scalar, which would become the one beside it.
            let same =
                state.flat().iter().zip(&flat).all(|(a, b)| a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan());
            if same { Ok(state) } else { Err(changed) }
        };
        let End { last, failed, stopped, work, seal: sealed } = end;
        let last = place(&mut ends, 0, last)?;
        let (mut all, mut own): (Drifts, _) = (Default::default(), OwnDrifts::default());
        let (mut happened, mut recorded) = (Vec::new(), Vec::new());
        while let Some((_, (number, name, drift))) = drifts.next_if(|&(of, _)| of == k) {
            match all.get_mut(number) {
                Some(place) => *place = Some(drift),
                None => own.add(name, drift),
            }
        }
        while let Some((_, Happened { n, which, crossing, bodies, head })) = events.next_if(|&(of, _)| of == k) {
            let state = place(&mut passed, n, head)?;
            let event = Event::new(which, state, crossing, bodies);
            let change = changes.next_if(|&(of, (at, _))| (of, at) == (k, n));
            happened.push(match change {
                Some((_, (n, head))) => event.changed_to(place(&mut gone_on, n, head)?),
                None => event,
            });
        }
        while let Some((_, (n, head))) = states.next_if(|&(of, _)| of == k) {
            recorded.push(place(&mut seen, n, head)?);
        }
        let run = Restored { last, states: recorded, events: happened, stopped, drifts: all, own, work };
        if sealed != seal(k, failed, &run) {
            return Err(changed);
        }
        if !failed {
            take(usize::try_from(k).map_err(|_| changed)?, run);
        }
    }
    // What belongs to nobody.
    let left = drifts.next().map(|(k, _)| ("drift", k));
    let left = left.or_else(|| events.next().map(|(k, _)| ("event", k)));
    let left = left.or_else(|| changes.next().map(|(k, _)| ("change", k)));
    let left = left.or_else(|| states.next().map(|(k, _)| ("state", k)));
    let left =
        left.or_else(|| [ends, passed, gone_on, seen].iter_mut().find_map(|placed| Some(("body", placed.left()?))));
    left.map_or(Ok(()), |(table, member)| Err(StoreError::Changed { table, member }))
}

/// The row of the end of a member.
struct End {
    last: Head,
    failed: bool,
    stopped: bool,
    work: Cost,
    seal: i64,
}

fn end<X: Flat>(row: &mut Reader<'_>) -> Option<End> {
    let failed = row.is_some()?;
    let last = Head::read::<X>(row)?;
    let mut counts = [0; 6];
    for n in &mut counts {
        *n = row.count()?;
    }
    let mut range = [0.0; 2];
    row.numbers(&mut range)?;
    let last = last.read_bits(row)?;
    let seal = row.count()?.cast_signed();
    let [stopped, steps, evaluations, iterations, rough, nanoseconds] = counts;
    let stopped = stopped != 0;
    let elapsed = Duration::from_nanos(nanoseconds);
    let range = (!range[0].is_nan()).then_some(range);
    let work = Cost { steps, evaluations, iterations, rough, elapsed, range };
    Some(End { last, failed, stopped, work, seal })
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

/// The row of an event.
struct Happened {
    n: u64,
    which: usize,
    crossing: Crossing,
    bodies: Option<[usize; 2]>,
    head: Head,
}

fn happened<X: Flat>(row: &mut Reader<'_>) -> Option<Happened> {
    let n = row.count()?;
    let (which, rising) = (usize::try_from(row.count()?).ok()?, row.count()? != 0);
    let crossing = if rising { Crossing::Rising } else { Crossing::Falling };
    let met = if X::LISTED { [row.count_if_any()?, row.count_if_any()?] } else { [None; 2] };
    let bodies = if let [Some(a), Some(b)] = met { Some([a as usize, b as usize]) } else { None };
    let head = Head::read::<X>(row)?.read_bits(row)?;
    Some(Happened { n, which, crossing, bodies, head })
}

fn recorded<X: Flat>(row: &mut Reader<'_>) -> Option<(u64, Head)> {
    let n = row.count()?;
    Some((n, Head::read::<X>(row)?.read_bits(row)?))
}
