//! What ranks tell one another.

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use crate::ensemble::plan::{Moved, Plan, Ranges};
use crate::ensemble::{Checksum, Outcome, Rides};
use crate::error::Error;
use crate::law::{Fields, Numbers};
use crate::run::{Attend, Interrupted, Restored};
use crate::span::Span;
use crate::state::State;

/// To the first rank.
#[derive(Debug, Serialize, Deserialize)]
#[serde(bound = "State<D>: Serialize + DeserializeOwned")]
pub(super) enum Report<const D: usize> {
    /// It is there, with so many threads, and has this ensemble.
    Here { set_up: SetUp, hands: usize },
    /// What came of a block.
    Moved { block: usize, members: Vec<(usize, Arrived<D>)> },
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
#[serde(bound = "State<D>: Serialize + DeserializeOwned")]
pub(super) enum Arrived<const D: usize> {
    Whole(Restored<State<D>>),
    Failed(Restored<State<D>>, Error),
    /// Refused, or in its first step: the first rank learns as soon by itself.
    Again,
}

impl<const D: usize> Arrived<D> {
    pub(super) fn of(outcome: &Outcome<State<D>>) -> Self {
        match outcome {
            Ok(run) => Arrived::Whole(run.to_restore()),
            Err(failed) if failed.run().steps() == 0 => Arrived::Again,
            // A cause that cannot be written is found again.
            Err(failed) if write(&failed.cause()).is_empty() => Arrived::Again,
            Err(failed) => Arrived::Failed(failed.run().to_restore(), failed.cause()),
        }
    }

    /// What became of the member with this number.
    pub(super) fn outcome<L, S, O>(self, k: usize, plan: &Plan<'_, L, S, O, D>) -> Result<Outcome<State<D>>, Error>
    where
        L: Fields<D>,
        S: Rides<L, D> + Sync,
        O: Attend<State<D>>,
    {
        Ok(match self {
            Arrived::Whole(run) => Ok((plan.bare)(k).restore(run)?),
            Arrived::Failed(run, cause) => Err(Interrupted::new((plan.bare)(k).restore(run)?, cause)),
            Arrived::Again => plan.alone(k),
        })
    }
}

/// Reads what came of some members.
pub(super) fn home<L, S, O, const D: usize>(
    members: Vec<(usize, Arrived<D>)>,
    plan: &Plan<'_, L, S, O, D>,
) -> Result<Moved<State<D>>, Error>
where
    L: Fields<D>,
    S: Rides<L, D> + Sync,
    O: Attend<State<D>>,
{
    members.into_iter().map(|(k, member)| Ok((k, member.outcome(k, plan)?))).collect()
}

/// What tells an ensemble from another: members, scheme, how far, what is recorded, and the numbers of the first and the last.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct SetUp(u64);

impl SetUp {
    pub(super) fn of<L, S, O, const D: usize>(plan: &Plan<'_, L, S, O, D>) -> Self
    where
        L: Fields<D>,
        S: Rides<L, D> + Sync,
        O: Attend<State<D>>,
    {
        let mut sum = Checksum::default();
        let words = format!("{} {:?} {:?} {}", S::NAME, plan.common.scheme, plan.common.due(), plan.company());
        words.bytes().for_each(|byte| sum.word(byte.into()));
        sum.word(plan.members as u64);
        sum.word(D as u64);
        let dt = plan.common.settings.dt.unwrap_or(f64::NAN).to_bits();
        let span = match plan.span {
            Span::Steps(steps) => [0, steps],
            Span::Until(end) => [1, end.to_bits()],
        };
        [dt, span[0], span[1]].into_iter().for_each(|word| sum.word(word));
        for k in [0, plan.members.wrapping_sub(1)].into_iter().filter(|&k| k < plan.members) {
            let simulation = (plan.bare)(k);
            let State { t, q, v } = simulation.start;
            let numbers = simulation.law.numbers().list();
            let all = numbers.iter().chain([&simulation.settings.mass, &t]).chain(&q).chain(&v);
            all.for_each(|x| sum.word(x.to_bits()));
        }
        SetUp(sum.value())
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
