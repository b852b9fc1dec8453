//! The invariants of members side by side.

use dmech_scalar::{Compensated, Mask, Real, Rows, RowsMask};

use super::together::Together;
use crate::drift::{Drift, Drifts};
use crate::invariant::Invariant;
use crate::law::Fields;
use crate::run::Watch;
use crate::scheme::ByLane;
use crate::state::State;
use crate::system::System;

/// How the invariants of members side by side moved, whatever the scheme.
pub(super) struct Deviations<const D: usize, const W: usize> {
    first: State<D, Rows<W>>,
    /// From where energies are counted, and what is to be added to the deviations of momenta.
    energies: [Rows<W>; Invariant::ALL.len()],
    carried: [Rows<W>; 2],
    drifts: [Option<Drift<Rows<W>>>; Invariant::ALL.len()],
    /// The work of the steps of each, where it is summed.
    pub(super) work: Option<Compensated<Rows<W>>>,
}

/// Where members are.
pub(super) struct States<const D: usize, const W: usize> {
    pub(super) t: Rows<W>,
    pub(super) q: [Rows<W>; D],
    pub(super) v: [Rows<W>; D],
}

impl<const D: usize, const W: usize> Deviations<D, W> {
    /// What is seen of one is seen of all.
    pub(super) fn alike<L: Fields<D>>(system: &Together<L, D, W>, start: &State<D>, watched: Drifts) -> Self {
        let first = State::of(ByLane::alike(&start.q), ByLane::alike(&start.v));
        let mut drifts = [None; Invariant::ALL.len()];
        for (of, watched) in Invariant::ALL.into_iter().zip(watched) {
            // Where bodies of some members are pinned, others keep their momenta.
            let may = matches!(of, Invariant::LinearMomentum | Invariant::AngularMomentum) && system.conserves(of);
            drifts[of as usize] = watched.or(may.then(|| Drift::new(0.0, 0.0))).as_ref().map(ByLane::alike);
        }
        let work = drifts[Invariant::WorkEnergy as usize].map(|_| Compensated::new(Rows::ZERO));
        let (energies, carried) = ([Rows::ZERO; Invariant::ALL.len()], [Rows::ZERO; 2]);
        Deviations { first, energies, carried, drifts, work }
    }

    /// Takes up a member in its lane.
    pub(super) fn seat(&mut self, lane: usize, start: &State<D>, watch: &Watch<State<D>>) {
        self.first.q.set(lane, &start.q);
        self.first.v.set(lane, &start.v);
        self.energies.set(lane, &watch.energies);
        self.carried.set(lane, &watch.carried);
        if let Some(work) = &mut self.work {
            let Compensated { hi, lo } = watch.work;
            (work.hi[lane], work.lo[lane]) = (hi, lo);
        }
        self.take(lane, watch);
    }

    /// Takes what was seen of one by itself.
    pub(super) fn take(&mut self, lane: usize, watch: &Watch<State<D>>) {
        for (drift, watched) in self.drifts.iter_mut().zip(&watch.drifts) {
            if let (Some(drift), Some(watched)) = (drift, watched) {
                drift.set(lane, watched);
            }
        }
    }

    /// Gives one what was seen of it.
    pub(super) fn land(&self, lane: usize, watch: &mut Watch<State<D>>) {
        for (watched, all) in watch.drifts.iter_mut().zip(&self.drifts) {
            if let (Some(watched), Some(all)) = (watched, all) {
                *watched = all.lane(lane);
            }
        }
        if let Some(Compensated { hi, lo }) = self.work {
            watch.work = Compensated { hi: hi[lane], lo: lo[lane] };
        }
    }

    /// Looks at those that are due, where the scheme asks for energies of its own: its energy, and its kinetic energy.
    #[inline]
    pub(super) fn look<L: Fields<D>>(
        &mut self,
        system: &Together<L, D, W>,
        States { t, q, v }: &States<D, W>,
        due: RowsMask<W>,
        own: &dyn Fn(Invariant) -> Option<Rows<W>>,
    ) {
        let (state, others) = (State::of(*q, *v), due.not());
        for invariant in Invariant::ALL {
            let Some(drift) = &mut self.drifts[invariant as usize] else { continue };
            let moved = |energy| (energy, energy - self.energies[invariant as usize]);
            let seen = match invariant {
                Invariant::Energy => Some(moved(system.potential(*t, q) + system.kinetic_energy(v))),
                Invariant::DiscreteEnergy => own(invariant).map(moved),
                Invariant::WorkEnergy => self.work.and_then(|work| Some(moved((own(invariant)? - work.hi) - work.lo))),
                Invariant::LinearMomentum | Invariant::AngularMomentum => {
                    let (momentum, deviation) = system.momentum(invariant, &state, &self.first);
                    let carried = self.carried[usize::from(invariant == Invariant::AngularMomentum)];
                    Some((momentum, carried + deviation))
                }
            };
            if let Some((value, deviation)) = seen {
                let last = *drift;
                drift.observe(*t, value, deviation);
                if others.any() {
                    drift.put(others, &last);
                }
            }
        }
    }
}

impl<const D: usize, const W: usize> Default for States<D, W> {
    fn default() -> Self {
        States { t: Rows::ZERO, q: [Rows::ZERO; D], v: [Rows::ZERO; D] }
    }
}

impl<const D: usize, const W: usize> States<D, W> {
    pub(super) fn set(&mut self, lane: usize, State { t, q, v }: &State<D>) {
        self.t[lane] = *t;
        self.q.set(lane, q);
        self.v.set(lane, v);
    }

    #[inline(always)]
    pub(super) fn lane(&self, lane: usize) -> State<D> {
        State::of(self.q.lane(lane), self.v.lane(lane)).at_time(self.t[lane])
    }
}
