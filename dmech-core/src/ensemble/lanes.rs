//! Members side by side: each has a lane of every register.

use core::mem::replace;
use core::ops::Range;
use std::time::Duration;

use dmech_scalar::{Mask, Real};

use super::rides::{Block, Outcome};
use super::steps::{Cost, InLanes};
use crate::error::Error;
use crate::invariant::{Drift, Drifts, Invariant};
use crate::law::{Fields, Numbered, Numbers};
use crate::ride::Ride;
use crate::run::{Due, Interrupted, Log, Prepared};
use crate::scheme::{ByLane, Scheme};
use crate::state::State;
use crate::stepper::Stepper;
use crate::system::{Particle, System};

/// Particles side by side, under laws of one kind.
pub type Together<L, const D: usize> = Particle<Numbered<L, D, Ride>, D, Ride>;

/// After so many steps at the latest somebody looks whether all are still finite.
const ROW: u64 = 64;

/// Moves the members of a block, so many at a time; a lane that is free takes the next member.
pub(super) fn in_lanes<L, S, const D: usize>(block: &Block<'_, L, S, D>) -> Vec<Outcome<State<D>>>
where
    L: Fields<D>,
    S: InLanes<L, D>,
{
    let mut queue = Queue { block, waiting: block.members.clone(), outcomes: Vec::new() };
    queue.outcomes.resize_with(block.members.len(), || None);
    let mut seats: Vec<Member<L, S, D>> = Vec::with_capacity(Ride::COUNT);
    loop {
        while seats.len() < block.lanes
            && let Some(member) = queue.next()
        {
            seats.push(member);
        }
        if seats.is_empty() {
            return queue.outcomes.into_iter().flatten().collect();
        }
        let mut convoy = Convoy::of(&seats);
        while go_on(&mut convoy, &mut seats) && relieve(&mut convoy, &mut seats, &mut queue) {}
        seats.extract_if(.., |member| member.has_ended()).for_each(|member| queue.end(member));
    }
}

/// The members of a block: those that wait, and what became of the others.
struct Queue<'a, 'b, L, S, const D: usize> {
    block: &'a Block<'b, L, S, D>,
    waiting: Range<usize>,
    outcomes: Vec<Option<Outcome<State<D>>>>,
}

impl<L: Fields<D>, S: Scheme<Particle<L, D>>, const D: usize> Queue<'_, '_, L, S, D> {
    /// The next that has a step to make.
    fn next(&mut self) -> Option<Member<L, S, D>> {
        while let Some(k) = self.waiting.next() {
            match Member::begin(self.block, k) {
                Ok(member) if member.has_ended() => self.end(member),
                Ok(member) => return Some(member),
                Err(refused) => self.outcomes[k - self.block.members.start] = Some(Err(refused)),
            }
        }
        None
    }

    fn end(&mut self, member: Member<L, S, D>) {
        let place = member.k - self.block.members.start;
        self.outcomes[place] = Some(member.end(self.block));
    }
}

/// Until somebody has ended. Not so, where somebody has to be looked at by itself: then all have their states.
fn go_on<L, S, const D: usize>(convoy: &mut Convoy<L, S, D>, seats: &mut [Member<L, S, D>]) -> bool
where
    L: Fields<D>,
    S: InLanes<L, D>,
{
    let by_time = seats.iter().any(|member| member.every.is_none());
    while !convoy.has_ended() {
        let is_due = by_time && {
            convoy.land_all(seats);
            seats.iter().any(Member::is_due)
        };
        let free = if by_time { seats.iter().map(Member::free).min() } else { None };
        let steps = convoy.row().min(free.unwrap_or(u64::MAX));
        if is_due {
            seats.iter_mut().for_each(Member::remember);
        }
        let together = convoy.advance(steps);
        if is_due || !together {
            convoy.land_all(seats);
            let alone = |member: &mut Member<L, S, D>| {
                if together { member.look_into_the_step() } else { member.advance(steps) }
            };
            seats.iter_mut().for_each(alone);
            return false;
        }
        convoy.look(seats);
    }
    true
}

/// Gives the lanes of those who have ended to the next, and where there is none to the last of those who are on their way.
/// Whether somebody is.
fn relieve<L, S, const D: usize>(
    convoy: &mut Convoy<L, S, D>,
    seats: &mut Vec<Member<L, S, D>>,
    queue: &mut Queue<'_, '_, L, S, D>,
) -> bool
where
    L: Fields<D>,
    S: InLanes<L, D>,
{
    let (taken, mut lane, mut first) = (seats.len(), 0, false);
    while lane < seats.len() {
        if convoy.left[lane] > 0 {
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
    let Some(seat) = seats.first() else { return false };
    // Lanes without a member move as the first, and must not move past its end.
    let vacant = seats.len()..if first { Ride::COUNT } else { taken };
    if !vacant.is_empty() {
        convoy.system = together(&convoy.numbers);
        vacant.for_each(|lane| convoy.place(lane, seat));
    }
    true
}

/// A member on its way.
struct Member<L: Fields<D>, S: Scheme<Particle<L, D>>, const D: usize> {
    k: usize,
    stepper: Stepper<Particle<L, D>, S>,
    log: Log<Particle<L, D>, ()>,
    /// Steps that are left to make.
    left: u64,
    /// Steps from one look at the invariants to the next; none where states are recorded by time.
    every: Option<u64>,
    /// The state before a step in which one is due.
    before: Option<State<D>>,
    failure: Option<Error>,
}

impl<L: Fields<D>, S: Scheme<Particle<L, D>>, const D: usize> Member<L, S, D> {
    fn begin(block: &Block<'_, L, S, D>, k: usize) -> Result<Self, Interrupted<State<D>>> {
        let simulation = (block.member)(k);
        let due = simulation.due().clone();
        let Prepared { mut stepper, run, steps: left, .. } = simulation.prepare(block.span)?;
        stepper.scheme.watch(S::SEES_ROUGH, &mut stepper.workspace);
        let every = if let Due::Every(n) = due { Some(n) } else { None };
        let mut log = Log::new(&stepper, run, due, ());
        log.watch.forget_work();
        let failure = if every.is_none() { log.begin(&stepper).err() } else { None };
        Ok(Member { k, stepper, log, left, every, before: None, failure })
    }

    fn has_ended(&self) -> bool {
        self.left == 0 || self.failure.is_some()
    }

    /// The numbers of its law, and its mass.
    fn numbers(&self) -> (L::Numbers, f64) {
        (self.stepper.law().numbers(), self.stepper.system.mass())
    }

    /// Whether the next step may reach a time at which a state is due.
    fn is_due(&self) -> bool {
        self.log.is_due_before(&self.stepper)
    }

    /// Steps that do not reach such a time, but one at least.
    fn free(&self) -> u64 {
        let Some(next) = self.log.next else { return u64::MAX };
        (((next - self.stepper.t()) / self.stepper.dt() - 1.01) as u64).max(1)
    }

    fn remember(&mut self) {
        self.before = self.is_due().then(|| self.stepper.state());
    }

    /// So many steps alone, where together they could not be made.
    fn advance(&mut self, steps: u64) {
        let mut made = 0;
        while made < steps && !self.stepper.arrived() {
            if let Err(cause) = self.stepper.step() {
                self.failure = Some(cause);
                return;
            }
            made += 1;
        }
        self.left = if self.stepper.arrived() { 0 } else { self.left - made };
        if self.before.is_some() {
            self.look_into_the_step();
        }
        if let Some(every) = self.every {
            self.log.until_record -= made;
            if self.log.until_record == 0 {
                self.log.until_record = every;
                self.log.look_at(&self.stepper, &self.stepper.state());
            }
        }
    }

    fn look_into_the_step(&mut self) {
        if let Some(before) = self.before.take() {
            self.failure = self.log.look_into_the_step(&self.stepper, &before).err();
        }
    }

    fn end(mut self, block: &Block<'_, L, S, D>) -> Outcome<State<D>> {
        if self.failure.is_some() {
            // What it was up to there.
            return block.alone(self.k);
        }
        let recorded = if self.every.is_none() { self.log.record_at_the_end(&self.stepper) } else { Ok(()) };
        self.log.close(&self.stepper, recorded.map(|()| None), Duration::ZERO)
    }
}

/// Members side by side, one in each lane; in lanes without one the first is moved once more.
struct Convoy<L: Fields<D>, S: InLanes<L, D>, const D: usize> {
    scheme: S,
    /// The numbers of each law, and each mass.
    numbers: Vec<(L::Numbers, f64)>,
    system: Together<L, D>,
    all: S::All,
    first: State<D, Ride>,
    drifts: [Option<Drift<Ride>>; Invariant::ALL.len()],
    /// Steps until each has ended.
    left: [u64; Ride::COUNT],
    /// Steps until its invariants are to be looked at, and how many there are from one look to the next.
    until_look: [u64; Ride::COUNT],
    every: [u64; Ride::COUNT],
    /// Steps that were made since each was seated or landed, and how many there were at the last look.
    made: [u64; Ride::COUNT],
    looked_at: [Option<u64>; Ride::COUNT],
    cost: Cost,
    /// Corrections that others had made when each was seated or landed.
    iterations: [u64; Ride::COUNT],
}

/// What acts on each, by lanes.
fn together<L: Fields<D>, const D: usize>(numbers: &[(L::Numbers, f64)]) -> Together<L, D> {
    let of = |lane: usize| numbers.get(lane).unwrap_or(&numbers[0]);
    let law = Numbered::new(|n| Ride::from_fn(|lane| of(lane).0.as_slice()[n]));
    Particle::with_mass(law, Ride::from_fn(|lane| of(lane).1))
}

impl<L: Fields<D>, S: InLanes<L, D>, const D: usize> Convoy<L, S, D> {
    fn of(seats: &[Member<L, S, D>]) -> Self {
        let stepper = |lane: usize| &seats.get(lane).unwrap_or(&seats[0]).stepper;
        let numbers: Vec<_> = seats.iter().map(Member::numbers).collect();
        let system = together(&numbers);
        let scheme = seats[0].stepper.scheme;
        let all = scheme.gather(&system, &stepper);
        let first = State::of(ByLane::of(&|lane| &stepper(lane).start.q), ByLane::of(&|lane| &stepper(lane).start.v));
        let watched: Vec<Drifts> = seats.iter().map(|member| member.log.watch.drifts()).collect();
        let drifts = core::array::from_fn(|i| {
            let of_first = watched[0][i].as_ref()?;
            let of = |lane: usize| watched.get(lane).and_then(|drifts| drifts[i].as_ref()).unwrap_or(of_first);
            Some(ByLane::of(&of))
        });
        let none = [u64::MAX; Ride::COUNT];
        let (left, until_look, every) = (none, none, none);
        let (made, looked_at, iterations, cost) = ([0; Ride::COUNT], [None; Ride::COUNT], [0; Ride::COUNT], Cost::NONE);
        let mut convoy = Convoy {
            scheme,
            numbers,
            system,
            all,
            first,
            drifts,
            left,
            until_look,
            every,
            made,
            looked_at,
            cost,
            iterations,
        };
        seats.iter().enumerate().for_each(|(lane, member)| convoy.count(lane, member));
        convoy
    }

    /// How many steps a member has before it.
    fn count(&mut self, lane: usize, member: &Member<L, S, D>) {
        self.left[lane] = member.left;
        self.until_look[lane] = if member.every.is_some() { member.log.until_record } else { u64::MAX };
        self.every[lane] = member.every.unwrap_or(u64::MAX);
    }

    /// Gives a lane to a member.
    fn seat(&mut self, lane: usize, member: &Member<L, S, D>) {
        self.numbers[lane] = member.numbers();
        self.system = together(&self.numbers);
        self.place(lane, member);
        self.count(lane, member);
    }

    /// Leaves the last lane that a member has.
    fn leave(&mut self, lane: usize) {
        self.numbers.truncate(lane);
        [self.left[lane], self.until_look[lane], self.every[lane]] = [u64::MAX; 3];
    }

    /// Has a lane move as a member does.
    fn place(&mut self, lane: usize, member: &Member<L, S, D>) {
        self.scheme.seat(&self.system, &mut self.all, lane, &member.stepper);
        let State { q, v, .. } = &member.stepper.start;
        self.first.q.set(lane, q);
        self.first.v.set(lane, v);
        for (drift, watched) in self.drifts.iter_mut().zip(member.log.watch.drifts()) {
            if let (Some(drift), Some(watched)) = (drift, &watched) {
                drift.set(lane, watched);
            }
        }
    }

    fn has_ended(&self) -> bool {
        self.left.contains(&0)
    }

    /// Steps until one ends, or is to be looked at.
    fn row(&self) -> u64 {
        self.left.iter().chain(&self.until_look).fold(ROW, |least, &steps| least.min(steps))
    }

    /// So many steps, or fewer if one arrives; none, and false, where they cannot be made together.
    fn advance(&mut self, steps: u64) -> bool {
        let Some(made) = self.scheme.advance(&self.system, &mut self.all, steps, &mut self.cost) else { return false };
        self.made.iter_mut().for_each(|all| *all += made);
        for column in [&mut self.left, &mut self.until_look] {
            column.iter_mut().for_each(|left| *left -= made);
        }
        if let Some(arrived) = self.scheme.at_the_end(&self.all) {
            for (lane, left) in self.left.iter_mut().enumerate().take(self.numbers.len()) {
                *left *= u64::from(arrived[lane] == 0.0);
            }
        }
        // A lane without a member that had come to the end first would keep all others from moving.
        made > 0 || self.has_ended()
    }

    /// Gives each what is in its lane.
    fn land_all(&mut self, seats: &mut [Member<L, S, D>]) {
        seats.iter_mut().enumerate().for_each(|(lane, member)| self.land(lane, member));
        self.cost.evaluations = Ride::ZERO;
    }

    /// Gives one what is in its lane.
    fn land(&mut self, lane: usize, member: &mut Member<L, S, D>) {
        let Member { stepper, log, .. } = member;
        if let Some(steps) = self.looked_at[lane].take() {
            log.looked_at = stepper.steps() + steps;
        }
        stepper.steps += core::mem::take(&mut self.made[lane]);
        stepper.evaluations += self.cost.take_evaluations(lane);
        stepper.iterations += self.cost.iterations - replace(&mut self.iterations[lane], self.cost.iterations);
        stepper.memory = self.scheme.lane(&self.all, lane);
        log.watch.set_drifts(self.drifts.each_ref().map(|drift| Some(drift.as_ref()?.lane(lane))));
        if member.every.is_some() {
            log.until_record = self.until_look[lane];
        }
        member.left = self.left[lane];
    }

    /// Looks at the invariants of those for whom it is time.
    fn look(&mut self, seats: &mut [Member<L, S, D>]) {
        let due = Ride::from_fn(|lane| self.until_look[lane].min(1) as f64).equal(Ride::ZERO);
        if !due.any() {
            return;
        }
        let system = &self.system;
        let (t, [q, v], discrete) = self.scheme.state(system, &self.all);
        let state = State::of(q, v);
        for invariant in Invariant::ALL {
            let Some(drift) = &mut self.drifts[invariant as usize] else { continue };
            let start = drift.fields()[0];
            let seen = match invariant {
                Invariant::Energy => Some(system.potential(t, &q) + system.kinetic_energy(&v)),
                Invariant::DiscreteEnergy => discrete,
                _ => None,
            };
            let seen = match invariant {
                Invariant::AngularMomentum => Some(system.momentum(invariant, &state, &self.first)),
                _ => seen.map(|energy| (energy, energy - start)),
            };
            if let Some((value, deviation)) = seen {
                let last = *drift;
                drift.observe(t, value, deviation);
                drift.put(due.not(), &last);
            }
        }
        let own = !seats[0].stepper.system.own_invariants().is_empty();
        for (lane, member) in seats.iter_mut().enumerate() {
            if self.until_look[lane] > 0 {
                continue;
            }
            self.until_look[lane] = self.every[lane];
            self.looked_at[lane] = Some(self.made[lane]);
            if own {
                let state = State::of(q.lane(lane), v.lane(lane)).at_time(t[lane]);
                member.log.watch.observe_own(&member.stepper, &state);
            }
        }
    }
}
