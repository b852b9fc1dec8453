//! Moving what a store does not have.

use core::ops::Range;
use std::path::Path;

use super::kept::Store;
use crate::ensemble::plan::{Keep, Moved, Opened, Ranges};
use crate::ensemble::told::Told;
use crate::ensemble::{Checksum, Outcome};
use crate::error::Error;
use crate::flat::Flat;
use crate::run::Columns;

/// A store on its way: what it has, and the checksum of what was seen.
pub(in crate::ensemble) struct Stored<'a, X> {
    plan: &'a dyn Told<X>,
    store: Store,
    done: Vec<bool>,
    sum: Checksum,
}

impl<'a, X: Flat + Columns> Stored<'a, X> {
    /// Opens the store of an ensemble, or makes it.
    pub(in crate::ensemble) fn open(path: &Path, plan: &'a dyn Told<X>) -> Opened<'a, X> {
        let store = Store::open(path, plan)?;
        let done = store.done(plan.members())?;
        Ok(Box::new(Stored { plan, store, done, sum: Checksum::default() }))
    }
}

impl<X: Flat + Columns> Keep<X> for Stored<'_, X> {
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

    fn keep(&mut self, members: Range<usize>, moved: Moved<X>) -> Result<Vec<Outcome<X>>, Error> {
        let outcomes = self.store.hand_over(self.plan, members, moved)?;
        outcomes.iter().for_each(|outcome| self.sum.add(outcome.as_ref()));
        Ok(outcomes)
    }

    fn close(self: Box<Self>) -> Result<(), Error> {
        Ok(self.store.close(self.sum)?)
    }
}
