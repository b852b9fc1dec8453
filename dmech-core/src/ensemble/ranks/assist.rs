//! The other ranks: move what they are given.

use std::thread::sleep;

use serde::Serialize;
use serde::de::DeserializeOwned;

use super::message::{Arrived, Mark, Order, Report, read, write};
use super::{PATIENCE, Ranks};
use crate::ensemble::plan::Plan;
use crate::ensemble::share::{Board, with_hands};
use crate::error::Error;

/// Moves members for the first rank until that has all.
pub(super) fn assist<R: Ranks + ?Sized, X: Clone + Send + Serialize + DeserializeOwned>(
    ranks: &R,
    plan: &dyn Plan<X>,
    threads: usize,
    mark: Mark,
) -> Result<(), Error> {
    let tell = |report: &Report<X>| ranks.send(0, &write(report));
    tell(&Report::Here { mark, hands: threads });
    let all_is_well = with_hands(threads, |rows| plan.go_all(rows), |board| obey(ranks, board, &tell));
    tell(&Report::Bye);
    while ranks.receive().is_none_or(|(rank, bytes)| !matches!(read(rank, &bytes), Ok(Order::Leave))) {
        sleep(PATIENCE);
    }
    if all_is_well? { Ok(()) } else { Err(Error::FirstRank) }
}

/// Whether the first rank has all.
fn obey<R: Ranks + ?Sized, X: Clone>(ranks: &R, board: &Board<X>, tell: &impl Fn(&Report<X>)) -> Result<bool, Error> {
    loop {
        while let Some((block, moved)) = board.take_any() {
            let members = moved.iter().map(|(k, outcome)| (*k, Arrived::of(outcome))).collect();
            tell(&Report::Moved { block, members });
        }
        match ranks.receive() {
            Some((rank, bytes)) => match read(rank, &bytes)? {
                Order::Move { block, rows } => board.add(block, rows.rows()),
                Order::End { failed } => return Ok(!failed),
                Order::Leave => return Ok(false),
            },
            None if !board.wait(None, Some(PATIENCE)) => return Ok(false),
            None => {}
        }
    }
}
