//! The first rank: hands out, and takes what comes.

use std::collections::VecDeque;
use std::thread::sleep;

use serde::Serialize;
use serde::de::DeserializeOwned;

use super::message::{Lengths, Mark, Order, Report, home, read, write};
use super::{PATIENCE, Ranks};
use crate::ensemble::in_order::Aides;
use crate::ensemble::share::Board;
use crate::ensemble::told::Told;
use crate::error::Error;

/// The other ranks, as the first sees them.
pub(super) struct Relay<'a, R: ?Sized, X> {
    ranks: &'a R,
    plan: &'a dyn Told<X>,
    mark: Mark,
    /// Ranks that are there, and threads that they have.
    here: usize,
    hands: usize,
    /// Ranks that ask for a block, each as often as it asks.
    asking: VecDeque<usize>,
    /// Ranks that are gone.
    gone: usize,
}

impl<'a, R: Ranks + ?Sized, X: Serialize + DeserializeOwned> Relay<'a, R, X> {
    pub(super) fn new(ranks: &'a R, plan: &'a dyn Told<X>, mark: Mark) -> Self {
        Relay { ranks, plan, mark, here: 1, hands: 0, asking: VecDeque::new(), gone: 0 }
    }

    fn next(&self) -> Result<Option<(usize, Report<X>)>, Error> {
        let Some((rank, bytes)) = self.ranks.receive() else { return Ok(None) };
        Ok(Some((rank, read(rank, &bytes)?)))
    }

    fn greet(&mut self, rank: usize, mark: Mark, hands: usize) -> Result<(), Error> {
        self.here += 1;
        if mark != self.mark {
            return Err(Error::OtherEnsemble { rank });
        }
        self.hands += hands;
        // One more than there are threads, so that none waits for a message.
        self.asking.extend([rank].into_iter().cycle().take(hands + 1));
        Ok(())
    }
}

impl<R: Ranks + ?Sized, X: Serialize + DeserializeOwned> Aides<X> for Relay<'_, R, X> {
    const PATIENCE: Option<core::time::Duration> = Some(PATIENCE);

    fn processes(&self) -> usize {
        self.ranks.count()
    }

    fn hands(&self) -> usize {
        self.hands
    }

    fn attend(&mut self, board: &Board<X>) -> Result<(), Error> {
        while let Some((rank, report)) = self.next()? {
            match report {
                Report::Here { mark, hands } => self.greet(rank, mark, hands)?,
                Report::Moved { block, members } => {
                    board.put(block, home(members, self.plan)?);
                    self.asking.push_back(rank);
                }
                Report::Bye => self.gone += 1,
            }
        }
        while !self.asking.is_empty()
            && let Some((block, rows)) = board.give()
            && let Some(rank) = self.asking.pop_front()
        {
            self.ranks.send(rank, &write(&Order::Move { block, rows: Lengths::of(&rows) }));
        }
        Ok(())
    }

    /// Tells all, and waits until all have heard it: nothing is left on its way.
    fn end(&mut self, failed: bool) -> Result<(), Error> {
        let mut outcome = Ok(());
        let others = self.ranks.count() - 1;
        let ranks = self.ranks;
        let tell = |order: &Order| (1..=others).for_each(|rank| ranks.send(rank, &write(order)));
        let mut told = false;
        while self.gone < others {
            if !told && self.here == self.ranks.count() {
                told = true;
                let failed = failed || outcome.is_err();
                tell(&Order::End { failed });
            }
            match self.next() {
                Ok(Some((rank, Report::Here { mark, hands }))) => outcome = outcome.and(self.greet(rank, mark, hands)),
                Ok(Some((_, Report::Bye))) => self.gone += 1,
                Ok(Some((_, Report::Moved { .. }))) => {}
                Ok(None) => sleep(PATIENCE),
                Err(_) => {}
            }
        }
        tell(&Order::Leave);
        outcome
    }
}
