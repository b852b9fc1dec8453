//! Blocks of members, moved by whoever is free and taken in their order.

use core::num::NonZero;
use core::ops::Range;
use std::thread::available_parallelism;
use std::time::Duration;

use dmech_scalar::Lanes;

use super::plan::{Keep, Moved, Plan, See, Tally};
use super::rows::{LANES, rows};
use super::share::{Board, with_hands};
use crate::error::Error;
use crate::run::Follow;

/// The most members in a block.
pub(super) const BLOCK: usize = 512;

/// The most in a block of such as move one by one.
const FEW: usize = 8;

/// More threads than any machine has use for: a system refuses them at some number, and a program would end.
const MOST: usize = 1024;

/// Blocks that are begun before the first that is not taken, for each who works: what is done and waits needs bounded room.
const AHEAD: usize = 4;

/// Bytes of one number of each coordinate above which members do not ride on the stack of the caller.
const LARGE: usize = 1 << 10;

/// Who does the work.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hands {
    pub(super) threads: Option<usize>,
    pub(super) lanes: usize,
}

impl Hands {
    pub(super) const ALL: Hands = Hands { threads: None, lanes: LANES };

    /// The threads of this process.
    pub(super) fn threads(self) -> usize {
        self.threads.unwrap_or_else(|| available_parallelism().map_or(1, NonZero::get)).clamp(1, MOST)
    }
}

/// Members in blocks of one size.
#[derive(Clone, Copy, Debug)]
pub(super) struct Blocks {
    members: usize,
    size: usize,
    /// A step takes room that the stack of the caller may not have.
    large: bool,
}

impl Blocks {
    /// A few for each thread, so that none waits long for the last; as large as may be where there is only one, as lanes stay free at
    /// the end of each.
    pub(super) fn of(members: usize, threads: usize) -> Self {
        let few = if threads == 1 { members } else { members / (8 * threads) };
        let size = few.next_multiple_of(LANES).clamp(LANES, BLOCK);
        Blocks { members, size, large: false }
    }

    /// The same of members that move one by one, each perhaps for long: what is on its way is a few.
    pub(super) fn one_by_one(members: usize, threads: usize) -> Self {
        Blocks { members, size: (members / (8 * threads)).clamp(1, FEW), large: false }
    }

    /// The same of members of so many coordinates.
    pub(super) fn of_coordinates(self, coordinates: usize) -> Self {
        Blocks { large: coordinates * rows(coordinates) * size_of::<Lanes>() > LARGE, ..self }
    }

    fn count(self) -> usize {
        self.members.div_ceil(self.size)
    }

    /// The members of one.
    pub(super) fn members(self, block: usize) -> Range<usize> {
        block * self.size..self.members.min((block + 1) * self.size)
    }
}

/// Who works beside the threads of this process.
pub(super) trait Aides<X> {
    /// How long what they send may wait; none if there is nobody.
    const PATIENCE: Option<Duration>;

    /// How many processes there are.
    fn processes(&self) -> usize;

    /// Threads that those have who have come.
    fn hands(&self) -> usize;

    /// Gives them jobs, and puts what came of others on the board.
    fn attend(&mut self, board: &Board<X>) -> Result<(), Error>;

    /// All is taken, or something has failed.
    fn end(&mut self, failed: bool) -> Result<(), Error>;
}

/// This process works alone.
pub(super) struct Nobody;

impl<X> Aides<X> for Nobody {
    const PATIENCE: Option<Duration> = None;

    fn processes(&self) -> usize {
        1
    }

    fn hands(&self) -> usize {
        0
    }

    fn attend(&mut self, _: &Board<X>) -> Result<(), Error> {
        Ok(())
    }

    fn end(&mut self, _: bool) -> Result<(), Error> {
        Ok(())
    }
}

/// The members on their way to where they are kept and seen.
pub(super) struct Arrival<'a, 'b, X> {
    pub(super) keep: Box<dyn Keep<X> + 'a>,
    pub(super) see: See<'b, X>,
    pub(super) follow: Follow,
    /// How many were seen.
    pub(super) seen: u64,
    pub(super) tally: Tally,
}

impl<X: Send> Arrival<'_, '_, X> {
    /// Has every block worked on, and takes what comes of it in order.
    pub(super) fn all<A: Aides<X>>(mut self, plan: &dyn Plan<X>, hands: Hands, aides: &mut A) -> Result<Tally, Error> {
        let threads = hands.threads();
        let blocks = plan.blocks(threads * aides.processes());
        let count = blocks.count();
        let outcome = if A::PATIENCE.is_none() && (threads == 1 || count <= 1) && !blocks.large {
            (0..count).try_for_each(|block| {
                let members = blocks.members(block);
                let moved = plan.go_all(self.keep.missing(members.clone()));
                self.take(members, moved)
            })
        } else {
            let work = |rows| plan.go_all(rows);
            with_hands(threads.min(count), work, |board| self.direct(blocks, threads, board, aides))
        };
        self.follow.end(self.seen, outcome.is_ok());
        outcome?;
        self.keep.close().map(|()| self.tally)
    }

    fn direct<A: Aides<X>>(
        &mut self,
        blocks: Blocks,
        threads: usize,
        board: &Board<X>,
        aides: &mut A,
    ) -> Result<(), Error> {
        let (count, mut begun, mut taken) = (blocks.count(), 0, 0);
        while taken < count {
            while begun < count.min(taken + AHEAD * (threads + aides.hands())) {
                board.add(begun, self.keep.missing(blocks.members(begun)));
                begun += 1;
            }
            aides.attend(board)?;
            if let Some(moved) = board.take(taken) {
                self.take(blocks.members(taken), moved)?;
                taken += 1;
            } else if !board.wait(Some(taken), A::PATIENCE) {
                // Its panic goes on when the threads are joined.
                break;
            }
        }
        Ok(())
    }

    fn take(&mut self, members: Range<usize>, moved: Moved<X>) -> Result<(), Error> {
        let any = !moved.is_empty();
        self.tally.add(&moved);
        for (k, outcome) in members.clone().zip(self.keep.keep(members.clone(), moved)?) {
            (self.see)(k, outcome);
        }
        self.seen = members.end as u64;
        if any {
            self.follow.look(self.seen);
        } else {
            self.follow.pass(self.seen);
        }
        Ok(())
    }
}
