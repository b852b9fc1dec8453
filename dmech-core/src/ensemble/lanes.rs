//! Members side by side: each has a lane of every register.

use std::time::Duration;

use dmech_scalar::{Mask, Real, Rows};

use super::rides::{Block, Outcome};
use super::steps::{Cost, InLanes};
use crate::error::Error;
use crate::invariant::{Drift, Drifts, Invariant};
use crate::law::{Fields, Numbered, Numbers};
use crate::run::{Due, Interrupted, Log, Prepared};
use crate::scheme::{ByLane, Scheme};
use crate::state::State;
use crate::stepper::Stepper;
use crate::system::{Particle, System};

/// A number of each member that rides. Registers stand side by side so that none waits for the root and the quotient of another, as many
/// as the target has room for.
#[cfg(target_feature = "avx512f")]
pub type Ride = Rows<4>;
/// A number of each member that rides. Registers stand side by side so that none waits for the root and the quotient of another, as many
/// as the target has room for.
#[cfg(all(target_feature = "avx2", not(target_feature = "avx512f")))]
pub type Ride = Rows<2>;
/// A number of each member that rides. Registers stand side by side so that none waits for the root and the quotient of another, as many
/// as the target has room for.
#[cfg(not(any(target_feature = "avx2", target_feature = "avx512f")))]
pub type Ride = Rows<1>;

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
    let mut outcomes: Vec<Option<Outcome<State<D>>>> = block.members.clone().map(|_| None).collect();
    let mut waiting = block.members.clone();
    let mut seats: Vec<Member<L, S, D>> = Vec::with_capacity(Ride::COUNT);
    loop {
        while seats.len() < block.lanes
            && let Some(k) = waiting.next()
        {
            match Member::begin(block, k) {
                Ok(member) => seats.push(member),
                Err(refused) => outcomes[k - block.members.start] = Some(Err(refused)),
            }
        }
        if seats.is_empty() {
            return outcomes.into_iter().flatten().collect();
        }
        go_on(&mut seats);
        for member in seats.extract_if(.., |member| member.has_ended()) {
            let place = member.k - block.members.start;
            outcomes[place] = Some(member.end(block));
        }
    }
}

/// Until the first has ended, or has to be looked at by itself.
fn go_on<L: Fields<D>, S: InLanes<L, D>, const D: usize>(seats: &mut [Member<L, S, D>]) {
    let mut convoy = Convoy::of(seats);
    let by_time = seats.iter().any(|member| member.every.is_none());
    while !convoy.has_ended() && seats.iter().all(|member| member.failure.is_none()) {
        let is_due = by_time && {
            convoy.land(seats);
            seats.iter().any(Member::is_due)
        };
        let free = if by_time { seats.iter().map(Member::free).min() } else { None };
        let steps = convoy.row().min(free.unwrap_or(u64::MAX));
        if is_due {
            seats.iter_mut().for_each(Member::remember);
        }
        if !convoy.advance(steps) {
            convoy.land(seats);
            return seats.iter_mut().for_each(|member| member.advance(steps));
        }
        if is_due {
            convoy.land(seats);
            return seats.iter_mut().for_each(Member::look_into_the_step);
        }
        convoy.look(seats);
    }
    convoy.land(seats);
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
        stepper.scheme.watch(false, &mut stepper.workspace);
        let every = if let Due::Every(n) = due { Some(n) } else { None };
        let mut log = Log::new(&stepper, run, due, ());
        log.watch.forget_work();
        let failure = if every.is_none() { log.begin(&stepper).err() } else { None };
        Ok(Member { k, stepper, log, left, every, before: None, failure })
    }

    fn has_ended(&self) -> bool {
        self.left == 0 || self.failure.is_some()
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
    system: Together<L, D>,
    all: S::All,
    first: State<D, Ride>,
    drifts: [Option<Drift<Ride>>; Invariant::ALL.len()],
    /// Steps until each has ended.
    left: [u64; Ride::COUNT],
    /// Steps until its invariants are to be looked at, and how many there are from one look to the next.
    until_look: [u64; Ride::COUNT],
    every: [u64; Ride::COUNT],
    /// Steps that were made, and how many there were at the last look.
    made: u64,
    looked_at: [Option<u64>; Ride::COUNT],
    cost: Cost,
}

impl<L: Fields<D>, S: InLanes<L, D>, const D: usize> Convoy<L, S, D> {
    fn of(seats: &[Member<L, S, D>]) -> Self {
        let member = |lane: usize| seats.get(lane).unwrap_or(&seats[0]);
        let stepper = |lane: usize| &member(lane).stepper;
        let count =
            |f: &dyn Fn(&Member<L, S, D>) -> u64| core::array::from_fn(|lane| seats.get(lane).map_or(u64::MAX, f));
        let numbers: Vec<L::Numbers> = seats.iter().map(|member| member.stepper.law().numbers()).collect();
        let law = Numbered::new(|n| Ride::from_fn(|lane| numbers.get(lane).unwrap_or(&numbers[0]).as_slice()[n]));
        let system = Particle::with_mass(law, Ride::from_fn(|lane| stepper(lane).system.mass()));
        let scheme = seats[0].stepper.scheme;
        let all = scheme.gather(&system, &stepper);
        let first = State::new(ByLane::of(&|lane| &stepper(lane).start.q), ByLane::of(&|lane| &stepper(lane).start.v));
        let watched: Vec<Drifts> = seats.iter().map(|member| member.log.watch.drifts()).collect();
        let drifts = core::array::from_fn(|i| {
            let of_first = watched[0][i].as_ref()?;
            let of = |lane: usize| watched.get(lane).and_then(|drifts| drifts[i].as_ref()).unwrap_or(of_first);
            Some(ByLane::of(&of))
        });
        Convoy {
            scheme,
            system,
            all,
            first,
            drifts,
            left: count(&|member| member.left),
            until_look: count(&|member| if member.every.is_some() { member.log.until_record } else { u64::MAX }),
            every: count(&|member| member.every.unwrap_or(u64::MAX)),
            made: 0,
            looked_at: [None; Ride::COUNT],
            cost: Cost::NONE,
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
        self.made += made;
        for column in [&mut self.left, &mut self.until_look] {
            column.iter_mut().for_each(|left| *left -= made);
        }
        for (lane, left) in self.left.iter_mut().enumerate() {
            if self.scheme.has_arrived(&self.all, lane) {
                *left = 0;
            }
        }
        true
    }

    /// Gives each what is in its lane.
    fn land(&mut self, seats: &mut [Member<L, S, D>]) {
        for (lane, member) in seats.iter_mut().enumerate() {
            let Member { stepper, log, .. } = member;
            if let Some(steps) = self.looked_at[lane] {
                log.looked_at = stepper.steps() + steps;
            }
            stepper.steps += self.made;
            stepper.evaluations += self.cost.evaluations[lane];
            stepper.iterations += self.cost.iterations;
            stepper.memory = self.scheme.lane(&self.all, lane);
            log.watch.set_drifts(self.drifts.map(|drift| drift.map(|drift| drift.lane(lane))));
            if member.every.is_some() {
                log.until_record = self.until_look[lane];
            }
            member.left = self.left[lane];
        }
        (self.made, self.cost) = (0, Cost::NONE);
        self.looked_at = [None; Ride::COUNT];
    }

    /// Looks at the invariants of those for whom it is time.
    fn look(&mut self, seats: &mut [Member<L, S, D>]) {
        let due = Ride::from_fn(|lane| self.until_look[lane].min(1) as f64).equal(Ride::ZERO);
        if !due.any() {
            return;
        }
        let system = &self.system;
        let (t, [q, v], discrete) = self.scheme.state(system, &self.all);
        let state = State::new(q, v);
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
                let last = (!due.all()).then(|| drift.fields());
                drift.observe(t, value, deviation);
                if let Some(last) = last {
                    let next = drift.fields();
                    *drift = Drift::by_field(|field| Ride::either(due, next[field], last[field]));
                }
            }
        }
        let own = !seats[0].stepper.system.own_invariants().is_empty();
        for (lane, member) in seats.iter_mut().enumerate() {
            if self.until_look[lane] > 0 {
                continue;
            }
            self.until_look[lane] = self.every[lane];
            self.looked_at[lane] = Some(self.made);
            if own {
                let state = State::new(q.lane(lane), v.lane(lane)).at_time(t[lane]);
                member.log.watch.observe_own(&member.stepper, &state);
            }
        }
    }
}
