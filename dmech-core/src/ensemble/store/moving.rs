//! Moving what a store does not have.

use core::ops::Range;
use std::path::Path;

use super::kept::Store;
use crate::ensemble::plan::{Keep, Moved, Plan, Ranges};
use crate::ensemble::{Checksum, Outcome, Rides};
use crate::error::Error;
use crate::law::Fields;
use crate::run::Attend;
use crate::state::State;

/// A store on its way: what it has, and the checksum of what was seen.
pub(in crate::ensemble) struct Stored<'a, L, S, O, const D: usize> {
    plan: &'a Plan<'a, L, S, O, D>,
    store: Store,
    done: Vec<bool>,
    sum: Checksum,
}

impl<'a, L: Fields<D>, S: Rides<L, D> + Sync, O: Attend<State<D>>, const D: usize> Stored<'a, L, S, O, D> {
    /// Opens the store of an ensemble, or makes it.
    pub(in crate::ensemble) fn open(path: &Path, plan: &'a Plan<'a, L, S, O, D>) -> Result<Self, Error> {
        let store = Store::open(path, plan)?;
        let done = store.done(plan.members)?;
        Ok(Stored { plan, store, done, sum: Checksum::default() })
    }

    /// All members are in it.
    pub(in crate::ensemble) fn close(self) -> Result<(), Error> {
        Ok(self.store.close(self.sum)?)
    }
}

impl<L, S, O, const D: usize> Keep<State<D>> for Stored<'_, L, S, O, D>
where
    L: Fields<D>,
    S: Rides<L, D> + Sync,
    O: Attend<State<D>>,
{
    fn missing(&self, members: Range<usize>) -> Ranges {
        let mut rows = Ranges::new();
        for k in members.filter(|&k| !self.done[k]) {
            match rows.last_mut() {
                Some(row) if row.end == k => row.end = k + 1,
                _ => rows.push(k..k + 1),
            }
        }
        rows
    }

    fn keep(&mut self, members: Range<usize>, moved: Moved<State<D>>) -> Result<Vec<Outcome<State<D>>>, Error> {
        let outcomes = self.store.hand_over(self.plan, members, moved)?;
        outcomes.iter().for_each(|outcome| self.sum.add(outcome.as_ref()));
        Ok(outcomes)
    }
}
