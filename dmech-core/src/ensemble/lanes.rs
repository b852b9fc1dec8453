//! Members side by side: each has a lane of every register.

use core::mem::replace;
use core::ops::Range;

use dmech_scalar::Rows;

use super::block::{Block, Outcome};
use super::convoy::Convoy;
use super::member::Member;
use super::steps::InLanes;
use crate::law::Fields;
use crate::run::Attend;
use crate::scheme::Scheme;
use crate::state::State;
use crate::system::Particle;

/// Moves the members of a block, so many at a time; a lane that is free takes the next member, and the last few move alone.
pub(super) fn in_lanes<L, S, O, const D: usize, const W: usize>(
    block: &Block<'_, L, S, O, D>,
    few: usize,
) -> Vec<Outcome<State<D>>>
where
    L: Fields<D>,
    S: InLanes<L, D, W>,
    O: Attend<State<D>>,
{
    let mut queue = Queue { block, few, waiting: block.members.clone(), outcomes: Vec::new() };
    queue.outcomes.resize_with(block.members.len(), || None);
    let mut seats: Vec<Member<L, S, O, D>> = Vec::with_capacity(Rows::<W>::COUNT);
    loop {
        while seats.len() < block.lanes.min(Rows::<W>::COUNT)
            && let Some(member) = queue.next()
        {
            seats.push(member);
        }
        if seats.is_empty() {
            return queue.outcomes.into_iter().flatten().collect();
        }
        if seats.len() <= few {
            seats.drain(..).for_each(|member| queue.end(member.alone()));
            continue;
        }
        let mut convoy = Convoy::<L, S, D, W>::of(&seats);
        while go_on(&mut convoy, &mut seats) && relieve(&mut convoy, &mut seats, &mut queue) {}
        seats.extract_if(.., |member| member.has_ended()).for_each(|member| queue.end(member));
    }
}

/// The members of a block: those that wait, and what became of the others.
struct Queue<'a, 'b, L, S, O, const D: usize> {
    block: &'a Block<'b, L, S, O, D>,
    /// So many take less time one by one.
    few: usize,
    waiting: Range<usize>,
    outcomes: Vec<Option<Outcome<State<D>>>>,
}

impl<L: Fields<D>, S: Scheme<Particle<L, D>>, O: Attend<State<D>>, const D: usize> Queue<'_, '_, L, S, O, D> {
    /// The next that has a step to make.
    fn next(&mut self) -> Option<Member<L, S, O, D>> {
        while let Some(k) = self.waiting.next() {
            match Member::begin(self.block, k) {
                Ok(member) if member.has_ended() => self.end(member),
                Ok(member) => return Some(member),
                Err(refused) => self.outcomes[k - self.block.members.start] = Some(Err(refused)),
            }
        }
        None
    }

    fn end(&mut self, member: Member<L, S, O, D>) {
        let place = member.k - self.block.members.start;
        self.outcomes[place] = Some(member.end());
    }
}

/// Until somebody has ended. Not so, where somebody has to be looked at by itself: then all have their states.
fn go_on<L, S, O, const D: usize, const W: usize>(
    convoy: &mut Convoy<L, S, D, W>,
    seats: &mut [Member<L, S, O, D>],
) -> bool
where
    L: Fields<D>,
    S: InLanes<L, D, W>,
    O: Attend<State<D>>,
{
    let by_time = seats.iter().any(|member| member.every.is_none());
    // Steps between two looks into them.
    let row = if O::EVENTS > 0 || O::OBSERVES { 1 } else { u64::MAX };
    while !convoy.counts.has_ended() {
        let is_due = by_time && {
            convoy.land_all(seats);
            seats.iter().any(Member::is_due)
        };
        if is_due {
            seats.iter_mut().for_each(Member::remember);
            let together = convoy.advance(1);
            convoy.land_all(seats);
            seats.iter_mut().for_each(|member| if together { member.look_back() } else { member.advance(1) });
            if !together {
                return false;
            }
            convoy.resume(seats);
            continue;
        }
        let free = if by_time { seats.iter().map(Member::free).min() } else { None };
        let mut steps = convoy.counts.row().min(free.unwrap_or(u64::MAX));
        while steps > 0 && !convoy.counts.has_ended() {
            if !convoy.advance(steps.min(row)) {
                convoy.land_all(seats);
                seats.iter_mut().for_each(|member| member.advance(steps));
                return false;
            }
            steps -= steps.min(row);
            convoy.look_back(seats);
        }
    }
    true
}

/// Gives the lanes of those who have ended to the next, and where there is none to the last of those who are on their way.
/// Whether these go on together; if not, all have their states.
fn relieve<L, S, O, const D: usize, const W: usize>(
    convoy: &mut Convoy<L, S, D, W>,
    seats: &mut Vec<Member<L, S, O, D>>,
    queue: &mut Queue<'_, '_, L, S, O, D>,
) -> bool
where
    L: Fields<D>,
    S: InLanes<L, D, W>,
    O: Attend<State<D>>,
{
    let (taken, mut lane, mut first) = (seats.len(), 0, false);
    while lane < seats.len() {
        if convoy.counts.left[lane] > 0 {
            lane += 1;
            continue;
        }
        first |= lane == 0;
        convoy.land(lane, &mut seats[lane]);
        let ended = match queue.next() {
            Some(next) => replace(&mut seats[lane], next),
            None => {
                let last = seats.len() - 1;
                convoy.land(last, &mut seats[last]);
                convoy.leave(last);
                seats.swap_remove(lane)
            }
        };
        queue.end(ended);
        // The last may have ended too.
        if let Some(seat) = seats.get(lane) {
            convoy.seat(lane, seat);
        }
    }
    if seats.len() <= queue.few {
        convoy.land_all(seats);
        return false;
    }
    let seat = &seats[0];
    // Lanes without a member move as the first, and must not move past its end.
    convoy.vacate(seats.len()..if first { Rows::<W>::COUNT } else { taken }, seat);
    true
}
