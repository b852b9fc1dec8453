//! Members side by side, one in each lane.

use core::cell::LazyCell;
use core::mem::{replace, take};
use core::ops::Range;

use dmech_scalar::{Compensated, Mask, Real, Rows};

use super::member::Member;
use super::rows::LANES;
use super::steps::InLanes;
use super::together::{Together, together};
use crate::invariant::{Drift, Invariant};
use crate::law::Fields;
use crate::run::Attend;
use crate::scheme::ByLane;
use crate::state::State;
use crate::system::{Effort, System};

/// After so many steps at the latest somebody looks whether all are still finite.
const ROW: u64 = 64;

/// Members side by side, one in each lane; in lanes without one the first is moved once more.
pub(super) struct Convoy<L: Fields<D>, S: InLanes<L, D, W>, const D: usize, const W: usize> {
    scheme: S,
    /// The numbers of each law, and each mass.
    numbers: Vec<(L::Numbers, f64)>,
    system: Together<L, D, W>,
    all: S::All,
    first: State<D, Rows<W>>,
    /// Where each is, as far as events ask for it.
    now: States<D, W>,
    drifts: [Option<Drift<Rows<W>>>; Invariant::ALL.len()],
    /// The work of the steps of each, where it is summed.
    work: Option<Compensated<Rows<W>>>,
    /// Steps until each has ended.
    pub(super) left: [u64; LANES],
    /// Steps until its invariants are to be looked at, and how many there are from one look to the next.
    until_look: [u64; LANES],
    every: [u64; LANES],
    /// Steps that were made since each was seated or landed, and how many there were at the last look.
    made: [u64; LANES],
    looked_at: [Option<u64>; LANES],
    cost: Effort<Rows<W>>,
}

impl<L: Fields<D>, S: InLanes<L, D, W>, const D: usize, const W: usize> Convoy<L, S, D, W> {
    pub(super) fn of<O: Attend<State<D>>>(seats: &[Member<L, S, O, D>]) -> Self {
        let numbers: Vec<_> = seats.iter().map(Member::numbers).collect();
        let system = together(&numbers);
        let Member { stepper, log, .. } = &seats[0];
        let scheme = stepper.scheme;
        let all = scheme.alike(&system, stepper);
        let first = State::of(ByLane::alike(&stepper.start.q), ByLane::alike(&stepper.start.v));
        let mut drifts = [None; Invariant::ALL.len()];
        for (of, watched) in Invariant::ALL.into_iter().zip(log.watch.drifts()) {
            // Where bodies of some members are pinned, others keep their momenta.
            let may = matches!(of, Invariant::LinearMomentum | Invariant::AngularMomentum) && system.conserves(of);
            drifts[of as usize] = watched.or(may.then(|| Drift::new(0.0, 0.0))).as_ref().map(ByLane::alike);
        }
        let work = drifts[Invariant::WorkEnergy as usize].map(|_| Compensated::new(Rows::ZERO));
        let now = States::default();
        let none = [u64::MAX; LANES];
        let (left, until_look, every) = (none, none, none);
        let (made, looked_at, cost) = ([0; LANES], [None; LANES], Effort::default());
        let mut convoy = Convoy {
            scheme,
            numbers,
            system,
            all,
            first,
            now,
            drifts,
            work,
            left,
            until_look,
            every,
            made,
            looked_at,
            cost,
        };
        for (lane, member) in seats.iter().enumerate() {
            convoy.place(lane, member);
            convoy.count(lane, member);
        }
        convoy.set_strides();
        convoy
    }

    /// How many steps a member has before it.
    fn count<O: Attend<State<D>>>(&mut self, lane: usize, member: &Member<L, S, O, D>) {
        self.left[lane] = member.left;
        self.until_look[lane] = if member.every.is_some() { member.log.until_record } else { u64::MAX };
        self.every[lane] = member.every.unwrap_or(u64::MAX);
        if O::EVENTS > 0 {
            self.now.set(lane, &member.stepper.state());
        }
    }

    /// Gives a lane to a member.
    pub(super) fn seat<O: Attend<State<D>>>(&mut self, lane: usize, member: &Member<L, S, O, D>) {
        self.numbers[lane] = member.numbers();
        self.system = together(&self.numbers);
        self.place(lane, member);
        self.count(lane, member);
        self.set_strides();
    }

    /// Leaves the last lane that a member has.
    pub(super) fn leave(&mut self, lane: usize) {
        self.numbers.truncate(lane);
        [self.left[lane], self.until_look[lane], self.every[lane]] = [u64::MAX; 3];
    }

    /// Has the lanes without a member move as one does.
    pub(super) fn vacate<O: Attend<State<D>>>(&mut self, lanes: Range<usize>, member: &Member<L, S, O, D>) {
        if !lanes.is_empty() {
            self.system = together(&self.numbers);
            for lane in lanes {
                self.place(lane, member);
            }
            self.set_strides();
        }
    }

    /// Has a lane move as a member does.
    fn place<O: Attend<State<D>>>(&mut self, lane: usize, member: &Member<L, S, O, D>) {
        self.scheme.seat(&mut self.all, lane, &member.stepper);
        let State { q, v, .. } = &member.stepper.start;
        self.first.q.set(lane, q);
        self.first.v.set(lane, v);
        if let Some(work) = &mut self.work {
            let Compensated { hi, lo } = member.log.watch.work();
            (work.hi[lane], work.lo[lane]) = (hi, lo);
        }
        self.take_drifts(lane, member);
    }

    fn take_drifts<O: Attend<State<D>>>(&mut self, lane: usize, member: &Member<L, S, O, D>) {
        for (drift, watched) in self.drifts.iter_mut().zip(member.log.watch.drifts()) {
            if let (Some(drift), Some(watched)) = (drift, &watched) {
                drift.set(lane, watched);
            }
        }
    }

    /// Goes on from a step after which each was looked at by itself: all are where they were, and what was seen is theirs.
    pub(super) fn resume<O: Attend<State<D>>>(&mut self, seats: &[Member<L, S, O, D>]) {
        for (lane, member) in seats.iter().enumerate() {
            self.take_drifts(lane, member);
            self.count(lane, member);
        }
        self.dismiss(seats);
    }

    /// Each moves with steps of its own length.
    fn set_strides(&mut self) {
        self.scheme.set_strides(&self.system, &mut self.all);
    }

    pub(super) fn has_ended(&self) -> bool {
        self.left.contains(&0)
    }

    /// Steps until one ends, or is to be looked at.
    pub(super) fn row(&self) -> u64 {
        let mut row = ROW;
        for lane in 0..LANES {
            row = row.min(self.left[lane]).min(self.until_look[lane]);
        }
        row
    }

    /// So many steps, or fewer if one arrives; false, and perhaps some of them, where they cannot be made together.
    pub(super) fn advance(&mut self, steps: u64) -> bool {
        let Convoy { scheme, system, all, cost, work, .. } = self;
        // Work is that of each step by itself: rows have nothing of it where nobody asks.
        let row = if work.is_some() { 1 } else { steps };
        let (mut made, mut last) = (0, Some(row));
        while made < steps && last == Some(row) {
            last = scheme.advance(system, all, row, cost, work.as_mut());
            made += last.unwrap_or(0);
        }
        self.have_made(made) && last.is_some()
    }

    /// Counts the steps that all have made; whether there were some, or one has come to its end.
    fn have_made(&mut self, made: u64) -> bool {
        for lane in 0..LANES {
            self.made[lane] += made;
            self.left[lane] -= made;
            self.until_look[lane] -= made;
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
    pub(super) fn land_all<O: Attend<State<D>>>(&mut self, seats: &mut [Member<L, S, O, D>]) {
        for (lane, member) in seats.iter_mut().enumerate() {
            self.land(lane, member);
        }
        self.cost = Effort::default();
    }

    /// Gives one what is in its lane.
    pub(super) fn land<O: Attend<State<D>>>(&mut self, lane: usize, member: &mut Member<L, S, O, D>) {
        self.land_steps(lane, member);
        let Member { stepper, log, .. } = member;
        let Effort { evaluations, iterations } = &mut self.cost;
        stepper.evaluations += take(&mut evaluations[lane]) as u64;
        stepper.iterations += take(&mut iterations[lane]) as u64;
        stepper.memory = self.scheme.lane(&self.all, lane);
        let mut drifts = log.watch.drifts();
        for (watched, all) in drifts.iter_mut().zip(&self.drifts) {
            if let (Some(watched), Some(all)) = (watched, all) {
                *watched = all.lane(lane);
            }
        }
        log.watch.set_drifts(drifts);
        if let Some(Compensated { hi, lo }) = self.work {
            log.watch.set_work(Compensated { hi: hi[lane], lo: lo[lane] });
        }
        if member.every.is_some() {
            log.until_record = self.until_look[lane];
        }
        member.left = self.left[lane];
    }

    /// Gives one the number of its steps.
    fn land_steps<O: Attend<State<D>>>(&mut self, lane: usize, Member { stepper, log, .. }: &mut Member<L, S, O, D>) {
        if let Some(steps) = self.looked_at[lane].take() {
            log.looked_at = stepper.steps() + steps;
        }
        stepper.steps += take(&mut self.made[lane]);
    }

    /// Everything that follows a step, or a row of steps into which nobody looks.
    pub(super) fn look_back<O: Attend<State<D>>>(&mut self, seats: &mut [Member<L, S, O, D>]) {
        if O::EVENTS > 0 || O::OBSERVES {
            for (lane, member) in seats.iter_mut().enumerate() {
                self.land_steps(lane, member);
            }
        }
        if O::EVENTS > 0 {
            let after = self.states();
            let before = replace(&mut self.now, after);
            for (lane, member) in seats.iter_mut().enumerate() {
                member.meet(before.t[lane], || before.lane(lane), &self.now.lane(lane));
            }
            self.dismiss(seats);
        }
        self.look(seats);
        if O::OBSERVES {
            let now = LazyCell::new(|| self.states());
            for (lane, member) in seats.iter_mut().enumerate() {
                if !member.is_stopped() {
                    member.observe(|| now.lane(lane));
                }
            }
        }
        self.dismiss(seats);
    }

    /// Those who were stopped, or have failed, make no more steps.
    fn dismiss<O: Attend<State<D>>>(&mut self, seats: &[Member<L, S, O, D>]) {
        for (lane, member) in seats.iter().enumerate() {
            if member.is_stopped() {
                (self.left[lane], self.until_look[lane]) = (0, u64::MAX);
            }
        }
    }

    fn states(&self) -> States<D, W> {
        let (t, [q, v]) = self.scheme.state(&self.system, &self.all);
        States { t, q, v }
    }

    /// Looks at the invariants of those for whom it is time.
    fn look<O: Attend<State<D>>>(&mut self, seats: &mut [Member<L, S, O, D>]) {
        let due = Rows::from_fn(|lane| self.until_look[lane].min(1) as f64).equal(Rows::ZERO);
        if !due.any() {
            return;
        }
        let (now, system) = (self.states(), &self.system);
        let States { t, q, v } = now;
        let state = State::of(q, v);
        for invariant in Invariant::ALL {
            let Some(drift) = &mut self.drifts[invariant as usize] else { continue };
            let start = drift.fields()[0];
            let moved = |energy| (energy, energy - start);
            let seen = match invariant {
                Invariant::Energy => Some(moved(system.potential(t, &q) + system.kinetic_energy(&v))),
                Invariant::DiscreteEnergy => self.scheme.own_energy(system, &self.all).map(moved),
                Invariant::WorkEnergy => {
                    let kinetic = || self.scheme.own_kinetic_energy(system, &self.all);
                    self.work.map(|work| moved((kinetic() - work.hi) - work.lo))
                }
                Invariant::LinearMomentum | Invariant::AngularMomentum => {
                    Some(system.momentum(invariant, &state, &self.first))
                }
            };
            if let Some((value, deviation)) = seen {
                let last = *drift;
                drift.observe(t, value, deviation);
                drift.put(due.not(), &last);
            }
        }
        let beside = O::QUANTITIES > 0 || O::STREAMS || !seats[0].stepper.system.own_invariants().is_empty();
        for (lane, member) in seats.iter_mut().enumerate() {
            if self.until_look[lane] > 0 {
                continue;
            }
            self.until_look[lane] = self.every[lane];
            self.looked_at[lane] = Some(self.made[lane]);
            if beside {
                member.look(now.lane(lane));
            }
        }
    }
}

/// Where members are.
struct States<const D: usize, const W: usize> {
    t: Rows<W>,
    q: [Rows<W>; D],
    v: [Rows<W>; D],
}

impl<const D: usize, const W: usize> Default for States<D, W> {
    fn default() -> Self {
        States { t: Rows::ZERO, q: [Rows::ZERO; D], v: [Rows::ZERO; D] }
    }
}

impl<const D: usize, const W: usize> States<D, W> {
    fn set(&mut self, lane: usize, State { t, q, v }: &State<D>) {
        self.t[lane] = *t;
        self.q.set(lane, q);
        self.v.set(lane, v);
    }

    #[inline(always)]
    fn lane(&self, lane: usize) -> State<D> {
        State::of(self.q.lane(lane), self.v.lane(lane)).at_time(self.t[lane])
    }
}
