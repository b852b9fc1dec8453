//! What ranks tell one another.

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use crate::ensemble::plan::{Moved, Ranges};
use crate::ensemble::told::{Said, Told};
use crate::ensemble::{Checksum, Outcome};
use crate::error::Error;
use crate::run::{Interrupted, Restored};

/// To the first rank.
#[derive(Debug, Serialize, Deserialize)]
#[serde(bound = "X: Serialize + DeserializeOwned")]
pub(super) enum Report<X> {
    /// It is there, with so many threads, and has this ensemble.
    Here { mark: Mark, hands: usize },
    /// What came of a block.
    Moved { block: usize, members: Vec<(usize, Arrived<X>)> },
    /// It has heard of the end: no more comes from it.
    Bye,
}

/// From the first rank.
#[derive(Debug, Serialize, Deserialize)]
pub(super) enum Order {
    /// These members of a block are to be moved.
    Move { block: usize, rows: Lengths },
    /// All are moved, or something has failed.
    End { failed: bool },
    /// All ranks have heard of the end: what comes now belongs to another ensemble.
    Leave,
}

/// Rows of members by their lengths, with those of the gaps between: half a kilobyte at most.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct Lengths {
    first: usize,
    lengths: Vec<u16>,
}

impl Lengths {
    pub(super) fn of(rows: &Ranges) -> Self {
        let first = rows.first().map_or(0, |row| row.start);
        let ends = rows.iter().flat_map(|row| [row.start, row.end]).skip(1);
        // A block has 512 members at most.
        let lengths = ends.scan(first, |last, end| Some((end - core::mem::replace(last, end)) as u16)).collect();
        Lengths { first, lengths }
    }

    pub(super) fn rows(self) -> Ranges {
        let mut ends = self.lengths.iter().scan(self.first, |last, &length| {
            *last += usize::from(length);
            Some(*last)
        });
        let (mut rows, mut start) = (Ranges::new(), self.first);
        while let Some(end) = ends.next() {
            rows.push(start..end);
            start = ends.next().unwrap_or(end);
        }
        rows
    }
}

/// A member on its way home.
#[derive(Debug, Serialize, Deserialize)]
#[serde(bound = "X: Serialize + DeserializeOwned")]
pub(super) enum Arrived<X> {
    Whole(Restored<X>),
    Failed(Restored<X>, Error),
    /// Refused, or in its first step: the first rank learns as soon by itself.
    Again,
}

impl<X: Clone> Arrived<X> {
    pub(super) fn of(outcome: &Outcome<X>) -> Self {
        match outcome {
            Ok(run) => Arrived::Whole(run.to_restore()),
            Err(failed) if failed.run().steps() == 0 => Arrived::Again,
            // A cause that cannot be written is found again.
            Err(failed) if write(&failed.cause()).is_empty() => Arrived::Again,
            Err(failed) => Arrived::Failed(failed.run().to_restore(), failed.cause()),
        }
    }
}

/// Reads what came of some members.
pub(super) fn home<X>(members: Vec<(usize, Arrived<X>)>, plan: &dyn Told<X>) -> Result<Moved<X>, Error> {
    let mut moved = Moved::with_capacity(members.len());
    for (k, member) in members {
        match member {
            Arrived::Whole(run) => moved.push((k, Ok(plan.restore(k, run)?))),
            Arrived::Failed(run, cause) => moved.push((k, Err(Interrupted::new(plan.restore(k, run)?, cause)))),
            Arrived::Again => moved.extend((k..k + 1).zip(plan.go(k..k + 1))),
        }
    }
    Ok(moved)
}

/// What tells an ensemble from another: what is said of the whole, and the set-ups of the first and the last member.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Mark(u64);

impl Mark {
    pub(super) fn of<X>(plan: &dyn Told<X>) -> Self {
        let mut sum = Checksum::default();
        for (key, said) in plan.whole() {
            sum.text(key);
            match said {
                Said::Nothing => {}
                Said::Count(n) => sum.word(n),
                Said::Number(x) => sum.word(x.to_bits()),
                Said::Words(words) => sum.text(&words),
            }
        }
        let columns = plan.columns();
        columns.words.iter().for_each(|name| sum.text(name));
        columns.numbers.iter().for_each(|name| sum.text(name));
        let members = plan.members();
        [0, members.wrapping_sub(1)]
            .into_iter()
            .filter(|&k| k < members)
            .for_each(|k| sum.word(plan.set_up(k).seal(k)));
        Mark(sum.value())
    }
}

/// A message as bytes; empty, which none is, where it cannot be written.
pub(super) fn write(message: &impl Serialize) -> Vec<u8> {
    postcard::to_allocvec(message).unwrap_or_default()
}

/// What a rank has sent.
pub(super) fn read<M: DeserializeOwned>(rank: usize, bytes: &[u8]) -> Result<M, Error> {
    postcard::from_bytes(bytes).map_err(|_| Error::OtherEnsemble { rank })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ensemble::in_order::BLOCK;

    #[test]
    fn rows_travel_in_few_bytes() {
        let every_other = (0..BLOCK / 2).map(|i| 7_000_000 + 2 * i..7_000_001 + 2 * i).collect();
        let row = |row| vec![row];
        for rows in [vec![], row(0..BLOCK), row(3..4), vec![100..105, 106..107, 511..512], every_other] {
            let order = write(&Order::Move { block: 3, rows: Lengths::of(&rows) });
            assert!(order.len() < 600, "{}", order.len());
            let Ok(Order::Move { block: 3, rows: read }) = read(0, &order) else { panic!("another order") };
            assert_eq!(read.rows(), rows);
        }
    }
}
