//! Watching the invariants of a run.

use dmech_scalar::{Compensated, Real};

use crate::invariant::{Drift, Invariant};
use crate::law::{Field, Law, Potential};
use crate::scheme::{Scheme, Stride};
use crate::state::State;
use crate::vector::dot;

/// The drift of each invariant, by `Invariant as usize`.
pub(crate) type Drifts = [Option<Drift>; Invariant::ALL.len()];

/// The invariants that this law and this scheme have, and how they moved so far.
#[derive(Clone, Debug)]
pub(crate) struct Watch<const D: usize, R: Real> {
    start: State<D, R>,
    /// The invariants at the start, by `Invariant as usize`; 0 where there is none.
    values: [R; Invariant::ALL.len()],
    work: Compensated<R>,
    drifts: Drifts,
}

impl<const D: usize, R: Real> Watch<D, R> {
    /// Starts from the first state. A particle in a field has no linear momentum to keep.
    pub(crate) fn begin<L: Law<D, R>, S: Scheme<L, D, R>>(
        (law, scheme, stride): (&L, &S, &Stride<R>),
        start: State<D, R>,
        memory: &S::Memory,
    ) -> Self {
        let (values, drifts) = ([R::ZERO; Invariant::ALL.len()], [None; Invariant::ALL.len()]);
        let mut watch = Watch { start, values, work: Compensated::new(R::ZERO), drifts };
        for invariant in Invariant::ALL {
            if let Some(value) = watch.value(invariant, (law, scheme, stride), &start, memory) {
                watch.values[invariant as usize] = value;
                watch.drifts[invariant as usize] = Some(Drift::new(start.t, value.to_f64()));
            }
        }
        watch
    }

    /// Adds the work of one step.
    #[inline]
    pub(crate) fn add_work<L, S: Scheme<L, D, R>>(
        &mut self,
        (law, scheme, stride): (&L, &S, &Stride<R>),
        before: &S::Memory,
        after: &S::Memory,
    ) {
        self.work.add(scheme.work(law, stride, before, after));
    }

    /// Looks at a recorded state.
    pub(crate) fn observe<L: Law<D, R>, S: Scheme<L, D, R>>(
        &mut self,
        (law, scheme, stride): (&L, &S, &Stride<R>),
        state: &State<D, R>,
        memory: &S::Memory,
    ) {
        for invariant in Invariant::ALL {
            let Some(value) = self.value(invariant, (law, scheme, stride), state, memory) else { continue };
            let deviation = match invariant {
                Invariant::AngularMomentum if D > 2 => self.turned(stride.mass, state),
                // Before it is rounded to `f64`, which may have fewer digits.
                _ => (value - self.values[invariant as usize]).to_f64(),
            };
            if let Some(drift) = &mut self.drifts[invariant as usize] {
                drift.observe(state.t, value.to_f64(), deviation);
            }
        }
    }

    /// How they moved.
    pub(crate) fn drifts(&self) -> Drifts {
        self.drifts
    }

    fn value<L: Law<D, R>, S: Scheme<L, D, R>>(
        &self,
        invariant: Invariant,
        (law, scheme, stride): (&L, &S, &Stride<R>),
        state: &State<D, R>,
        memory: &S::Memory,
    ) -> Option<R> {
        let t = R::from_f64(state.t);
        let value = match invariant {
            Invariant::Energy if L::AUTONOMOUS && L::Field::<'_>::CONSERVES_ENERGY => {
                law.field(stride.mass, t).potential(state.q) + stride.kinetic_energy(law.mass_ratios(), state.v)
            }
            Invariant::DiscreteEnergy if L::AUTONOMOUS && L::Field::<'_>::CONSERVES_ENERGY => {
                scheme.discrete_energy(law, stride, t, memory)?
            }
            Invariant::WorkEnergy => (scheme.kinetic_energy(law, stride, memory) - self.work.hi) - self.work.lo,
            Invariant::AngularMomentum if L::Field::<'_>::CENTRAL && D == 2 => {
                angular_momentum(stride.mass, state, 0, 1)
            }
            Invariant::AngularMomentum if L::Field::<'_>::CENTRAL && D > 2 => {
                let mut squares = R::ZERO;
                for (i, j) in pairs::<D>() {
                    let l = angular_momentum(stride.mass, state, i, j);
                    squares += l * l;
                }
                squares.sqrt()
            }
            _ => return None,
        };
        Some(value)
    }

    /// |L − L₀|.
    fn turned(&self, mass: R, state: &State<D, R>) -> f64 {
        let mut squares = R::ZERO;
        for (i, j) in pairs::<D>() {
            let l = angular_momentum(mass, state, i, j) - angular_momentum(mass, &self.start, i, j);
            squares += l * l;
        }
        squares.sqrt().to_f64()
    }
}

/// m (qᵢ vⱼ − qⱼ vᵢ).
fn angular_momentum<const D: usize, R: Real>(mass: R, state: &State<D, R>, i: usize, j: usize) -> R {
    mass * dot([state.q[i], -state.q[j]], [state.v[j], state.v[i]])
}

fn pairs<const D: usize>() -> impl Iterator<Item = (usize, usize)> {
    (0..D).flat_map(|i| (i + 1..D).map(move |j| (i, j)))
}
