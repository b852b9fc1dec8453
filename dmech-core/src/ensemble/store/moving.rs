//! Moving what a store does not have.

use core::ops::Range;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use super::kept::Store;
use super::set_up::Plan;
use crate::ensemble::{Block, Checksum, Hands, Outcome, Rides};
use crate::error::Error;
use crate::law::Fields;
use crate::run::Follow;
use crate::state::State;

/// Hands the members over in order: those that the store has, and the others as they come and are written.
pub(in crate::ensemble) fn go<L, S, const D: usize>(
    path: &Path,
    plan: &Plan<'_, L, S, D>,
    hands: Hands,
    follow: &mut Follow,
    mut see: impl FnMut(usize, Outcome<State<D>>),
) -> Result<(), Error>
where
    L: Fields<D>,
    S: Rides<L, D> + Sync,
{
    let store = Store::open(path, plan)?;
    let done = store.done(plan.members)?;
    let (stop, mut failure, mut sum) = (AtomicBool::new(false), None, Checksum::default());
    let block = |members: Range<usize>| {
        let mut moved = Vec::new();
        for missing in missing(&done, members.clone()) {
            if !stop.load(Ordering::Relaxed) {
                let numbers = missing.clone();
                let block = Block { members: missing, member: plan.member, span: plan.span, lanes: hands.lanes };
                moved.extend(numbers.zip(S::ride(&block)));
            }
        }
        (members, moved)
    };
    hands.share(plan.members, block, |(members, moved)| {
        if failure.is_some() {
            return;
        }
        let (any, end) = (!moved.is_empty(), members.end as u64);
        match store.hand_over(plan, members.clone(), moved) {
            Ok(outcomes) => {
                for (k, outcome) in members.zip(outcomes) {
                    sum.add(outcome.as_ref());
                    see(k, outcome);
                }
                if any {
                    follow.look(end);
                } else {
                    follow.pass(end);
                }
            }
            Err(refused) => {
                stop.store(true, Ordering::Relaxed);
                failure = Some(refused);
            }
        }
    });
    match failure {
        Some(refused) => Err(refused),
        None => Ok(store.close(sum)?),
    }
}

/// The members of a block that are not done, in rows.
fn missing(done: &[bool], members: Range<usize>) -> Vec<Range<usize>> {
    let mut rows: Vec<Range<usize>> = Vec::new();
    for k in members.filter(|&k| !done[k]) {
        match rows.last_mut() {
            Some(row) if row.end == k => row.end = k + 1,
            _ => rows.push(k..k + 1),
        }
    }
    rows
}
