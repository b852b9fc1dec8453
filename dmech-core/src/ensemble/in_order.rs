//! Blocks of members, moved by whoever is free and taken in their order.

use core::num::NonZero;
use core::ops::Range;
use std::thread::available_parallelism;
use std::time::Duration;

use dmech_scalar::Lanes;

use super::rows::{LANES, rows};
use super::share::{Board, with_hands};
use crate::error::Error;

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

/// Says what is to be done of a block, and takes what has come of it.
pub(super) trait Direct {
    type Job: Send;
    type Result: Send;

    fn job(&mut self, members: Range<usize>) -> Self::Job;

    fn take(&mut self, members: Range<usize>, result: Self::Result) -> Result<(), Error>;
}

/// Who works beside the threads of this process.
pub(super) trait Aides<J, T> {
    /// How long what they send may wait; none if there is nobody.
    const PATIENCE: Option<Duration>;

    /// How many processes there are.
    fn processes(&self) -> usize;

    /// Threads that those have who have come.
    fn hands(&self) -> usize;

    /// Gives them jobs, and puts what came of others on the board.
    fn attend(&mut self, board: &Board<J, T>) -> Result<(), Error>;

    /// All is taken, or something has failed.
    fn end(&mut self, failed: bool) -> Result<(), Error>;
}

/// This process works alone.
pub(super) struct Nobody;

impl<J, T> Aides<J, T> for Nobody {
    const PATIENCE: Option<Duration> = None;

    fn processes(&self) -> usize {
        1
    }

    fn hands(&self) -> usize {
        0
    }

    fn attend(&mut self, _: &Board<J, T>) -> Result<(), Error> {
        Ok(())
    }

    fn end(&mut self, _: bool) -> Result<(), Error> {
        Ok(())
    }
}

/// Has every block worked on, and what comes of it taken in order.
pub(super) fn in_order<A: Aides<D::Job, D::Result>, D: Direct>(
    blocks: Blocks,
    threads: usize,
    work: impl Fn(D::Job) -> D::Result + Sync,
    director: &mut D,
    aides: &mut A,
) -> Result<(), Error> {
    let count = blocks.count();
    if A::PATIENCE.is_none() && (threads == 1 || count <= 1) && !blocks.large {
        return (0..count).try_for_each(|block| {
            let job = director.job(blocks.members(block));
            director.take(blocks.members(block), work(job))
        });
    }
    with_hands(threads.min(count), work, |board| direct(blocks, threads, board, director, aides))
}

fn direct<A: Aides<D::Job, D::Result>, D: Direct>(
    blocks: Blocks,
    threads: usize,
    board: &Board<D::Job, D::Result>,
    director: &mut D,
    aides: &mut A,
) -> Result<(), Error> {
    let (count, mut begun, mut taken) = (blocks.count(), 0, 0);
    while taken < count {
        while begun < count.min(taken + AHEAD * (threads + aides.hands())) {
            board.add(begun, director.job(blocks.members(begun)));
            begun += 1;
        }
        aides.attend(board)?;
        if let Some(result) = board.take(taken) {
            director.take(blocks.members(taken), result)?;
            taken += 1;
        } else if !board.wait(Some(taken), A::PATIENCE) {
            // Its panic goes on when the threads are joined.
            break;
        }
    }
    Ok(())
}
