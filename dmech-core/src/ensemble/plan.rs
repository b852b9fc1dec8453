//! An ensemble as it moves.

use core::ops::Range;

use super::block::Outcome;
use super::in_order::{Aides, Arrival, Blocks, Hands};
use crate::error::Error;
use crate::run::{Follow, Run, Shown};

/// What is to be done with members, of whatever kind. Everything that follows is compiled once for each kind of state.
pub(super) trait Plan<X>: Sync {
    /// How many there are.
    fn members(&self) -> usize;

    /// In which blocks so many threads move them.
    fn blocks(&self, threads: usize) -> Blocks;

    /// Moves some in a row.
    fn go(&self, members: Range<usize>) -> Vec<Outcome<X>>;
}

/// Members in rows.
pub(super) type Ranges = Vec<Range<usize>>;

/// Members that were moved, each with its number, in order.
pub(super) type Moved<X> = Vec<(usize, Outcome<X>)>;

/// Sees members in their order.
pub(super) type See<'a, X> = &'a mut dyn FnMut(usize, Outcome<X>);

impl<X> dyn Plan<X> + '_ {
    /// Moves some in several rows.
    pub(super) fn go_all(&self, rows: Ranges) -> Moved<X> {
        rows.into_iter().flat_map(|row| row.clone().zip(self.go(row))).collect()
    }
}

/// How many members were moved, and steps made with those that did not fail: what a store had is not among them.
#[derive(Clone, Copy, Debug, Default)]
#[cfg_attr(not(feature = "ranks"), expect(unreachable_pub, reason = "ranks alone name it"))]
pub struct Tally {
    pub(super) members: usize,
    pub(super) steps: u64,
}

impl Tally {
    pub(super) fn add<X>(&mut self, moved: &Moved<X>) {
        self.members += moved.len();
        self.steps += moved.iter().flat_map(|(_, outcome)| outcome).map(Run::steps).sum::<u64>();
    }
}

/// Where members are kept before they are seen.
pub trait Keep<X> {
    /// Those that are not there.
    fn missing(&self, members: Range<usize>) -> Vec<Range<usize>>;

    /// Keeps those that were moved, and puts what was there between them.
    ///
    /// # Errors
    /// [`Error`] of the place.
    fn keep(&mut self, members: Range<usize>, moved: Moved<X>) -> Result<Vec<Outcome<X>>, Error>;

    /// All are there.
    ///
    /// # Errors
    /// Likewise.
    fn close(self: Box<Self>) -> Result<(), Error>;
}

/// They are kept nowhere.
#[derive(Clone, Copy, Debug)]
pub struct Nowhere;

impl<X> Keep<X> for Nowhere {
    fn missing(&self, members: Range<usize>) -> Ranges {
        vec![members]
    }

    fn keep(&mut self, _: Range<usize>, moved: Moved<X>) -> Result<Vec<Outcome<X>>, Error> {
        Ok(moved.into_iter().map(|(_, outcome)| outcome).collect())
    }

    fn close(self: Box<Self>) -> Result<(), Error> {
        Ok(())
    }
}

/// Where members are kept, if it can be opened.
pub(super) type Opened<'a, X> = Result<Box<dyn Keep<X> + 'a>, Error>;

/// Moves all members and hands them over in their order, as they arrive; those who help are told of the end.
pub(super) fn sweep<X: Send, A: Aides<X>>(
    plan: &dyn Plan<X>,
    (hands, shown): (Hands, Shown),
    keep: Opened<'_, X>,
    see: See<'_, X>,
    mut aides: A,
) -> Result<Tally, Error> {
    let follow = Follow::new(shown, plan.members() as u64);
    let outcome = match keep {
        Ok(keep) => Arrival { keep, see, follow, seen: 0, tally: Tally::default() }.all(plan, hands, &mut aides),
        Err(refused) => {
            follow.end(0, false);
            Err(refused)
        }
    };
    let ended = aides.end(outcome.is_err());
    outcome.and_then(|tally| ended.map(|()| tally))
}
