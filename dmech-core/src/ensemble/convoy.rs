//! Members side by side, one in each lane.

use core::cell::LazyCell;
use core::mem::{replace, take};
use core::ops::Range;

use dmech_scalar::{Real, Rows};

use super::counts::Counts;
use super::deviations::{Deviations, States};
use super::member::Member;
use super::steps::InLanes;
use super::together::{Together, together};
use crate::invariant::Invariant;
use crate::law::Fields;
use crate::run::Attend;
use crate::state::State;
use crate::system::{Effort, System};

/// Members side by side, one in each lane; in lanes without one the first is moved once more.
pub(super) struct Convoy<L: Fields<D>, S: InLanes<L, D, W>, const D: usize, const W: usize> {
    scheme: S,
    /// The numbers of each law, and each mass.
    numbers: Vec<(L::Numbers, f64)>,
    system: Together<L, D, W>,
    all: S::All,
    /// Where each is, as far as events ask for it.
    now: States<D, W>,
    /// Where those are whose motion was changed in the last step: where they were set, and not to rounding.
    changed: Vec<(usize, State<D>)>,
    seen: Deviations<D, W>,
    pub(super) counts: Counts,
    cost: Effort<Rows<W>>,
}

impl<L: Fields<D>, S: InLanes<L, D, W>, const D: usize, const W: usize> Convoy<L, S, D, W> {
    pub(super) fn of<O: Attend<State<D>>>(seats: &[Member<L, S, O, D>]) -> Self {
        let numbers: Vec<_> = seats.iter().map(Member::numbers).collect();
        let system = together(&numbers);
        let Member { stepper, log, .. } = &seats[0];
        let scheme = stepper.scheme;
        let all = scheme.alike(&system, stepper);
        let seen = Deviations::alike::<L>(&system, &stepper.start, log.watch.drifts());
        let (now, counts, cost) = (States::default(), Counts::default(), Effort::default());
        let mut convoy = Convoy { scheme, numbers, system, all, now, changed: Vec::new(), seen, counts, cost };
        for (lane, member) in seats.iter().enumerate() {
            convoy.place(lane, member);
            convoy.count(lane, member);
        }
        convoy.set_strides();
        convoy
    }

    /// How many steps a member has before it.
    fn count<O: Attend<State<D>>>(&mut self, lane: usize, member: &Member<L, S, O, D>) {
        self.counts.seat(lane, member.left, member.every.map(|every| [member.log.until_record, every]));
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
        self.counts.leave(lane);
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
        self.seen.seat(lane, &member.stepper.start, &member.log.watch);
    }

    /// Goes on from a step after which each was looked at by itself: all are where they were, and what was seen is theirs.
    pub(super) fn resume<O: Attend<State<D>>>(&mut self, seats: &[Member<L, S, O, D>]) {
        for (lane, member) in seats.iter().enumerate() {
            if O::CHANGES {
                self.place(lane, member);
            }
            self.seen.take(lane, &member.log.watch);
            self.count(lane, member);
        }
        if O::CHANGES {
            self.set_strides();
        }
        self.dismiss(seats);
    }

    /// Each moves with steps of its own length.
    fn set_strides(&mut self) {
        self.scheme.set_strides(&self.system, &mut self.all);
    }

    /// So many steps, or fewer if one arrives; false, and perhaps some of them, where they cannot be made together.
    pub(super) fn advance(&mut self, steps: u64) -> bool {
        let Convoy { scheme, system, all, cost, seen: Deviations { work, .. }, .. } = self;
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
        self.counts.have_made(made);
        if let Some(arrived) = self.scheme.at_the_end(&self.all) {
            for (lane, left) in self.counts.left.iter_mut().enumerate().take(self.numbers.len()) {
                *left *= u64::from(arrived[lane] == 0.0);
            }
        }
        // A lane without a member that had come to the end first would keep all others from moving.
        made > 0 || self.counts.has_ended()
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
        self.seen.land(lane, &mut log.watch);
        if member.every.is_some() {
            log.until_record = self.counts.until_look[lane];
        }
        member.left = self.counts.left[lane];
    }

    /// Gives one the number of its steps.
    fn land_steps<O: Attend<State<D>>>(&mut self, lane: usize, Member { stepper, log, .. }: &mut Member<L, S, O, D>) {
        let (made, looked_at) = self.counts.land(lane);
        if let Some(steps) = looked_at {
            log.looked_at = stepper.steps() + steps;
        }
        stepper.steps += made;
    }

    /// Everything that follows a step, or a row of steps into which nobody looks.
    pub(super) fn look_back<O: Attend<State<D>>>(&mut self, seats: &mut [Member<L, S, O, D>]) {
        if O::EVENTS > 0 || O::OBSERVES {
            for (lane, member) in seats.iter_mut().enumerate() {
                self.land_steps(lane, member);
            }
        }
        if O::EVENTS > 0 {
            self.changed.clear();
            let after = self.states();
            let before = replace(&mut self.now, after);
            for (lane, member) in seats.iter_mut().enumerate() {
                member.meet(before.t[lane], || before.lane(lane), &self.now.lane(lane));
            }
            if O::CHANGES {
                self.change(seats);
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

    /// Goes on with those whose motion an event has changed.
    fn change<O: Attend<State<D>>>(&mut self, seats: &mut [Member<L, S, O, D>]) {
        for (lane, member) in seats.iter_mut().enumerate().filter(|(_, member)| member.log.is_changed()) {
            self.land(lane, member);
            member.change();
            self.place(lane, member);
            self.count(lane, member);
            self.changed.push((lane, member.stepper.state()));
        }
        if !self.changed.is_empty() {
            self.set_strides();
        }
    }

    /// Those who were stopped, or have failed, make no more steps.
    fn dismiss<O: Attend<State<D>>>(&mut self, seats: &[Member<L, S, O, D>]) {
        for (lane, member) in seats.iter().enumerate() {
            if member.is_stopped() {
                self.counts.dismiss(lane);
            }
        }
    }

    fn states(&self) -> States<D, W> {
        let (t, [q, v]) = self.scheme.state(&self.system, &self.all);
        let mut states = States { t, q, v };
        for (lane, state) in &self.changed {
            states.set(*lane, state);
        }
        states
    }

    /// Looks at the invariants of those for whom it is time.
    fn look<O: Attend<State<D>>>(&mut self, seats: &mut [Member<L, S, O, D>]) {
        if !self.counts.is_due() {
            return;
        }
        let due = Rows::from_fn(|lane| self.counts.until_look[lane].min(1) as f64).equal(Rows::ZERO);
        let (now, Convoy { scheme, system, all, seen, counts, .. }) = (self.states(), self);
        seen.look::<L>(system, &now, due, &|energy| match energy {
            Invariant::DiscreteEnergy => scheme.own_energy(system, all),
            _ => Some(scheme.own_kinetic_energy(system, all)),
        });
        let beside = O::QUANTITIES > 0 || O::STREAMS || !seats[0].stepper.system.own_invariants().is_empty();
        for (lane, member) in seats.iter_mut().enumerate() {
            if counts.look(lane) && beside {
                member.look(now.lane(lane));
            }
        }
    }
}
