//! Watching the invariants of a scene.

use dmech_scalar::Compensated;

use super::scheme::SceneScheme;
use super::setting::System;
use super::state::SceneState;
use super::terms::Acts;
use super::vectors::Vectors;
use crate::invariant::{Drift, Invariant};
use crate::watch::Drifts;

/// The invariants that this scene and this scheme have, and how they moved so far.
#[derive(Clone, Debug)]
pub(crate) struct SceneWatch<const D: usize> {
    masses: Vec<f64>,
    start: [Vec<f64>; 2],
    work: Compensated<f64>,
    drifts: Drifts,
}

impl<const D: usize> SceneWatch<D> {
    pub(super) fn begin<A: Acts<D>, S: SceneScheme<D, A>>(
        system: &System<D, A>,
        scheme: &S,
        memory: &S::Memory,
        state: &SceneState<D>,
    ) -> Self {
        let masses = system.setting.masses.clone();
        let start = [linear(&masses, state), angular(&masses, state)];
        let mut watch = SceneWatch { masses, start, work: Compensated::new(0.0), drifts: Drifts::default() };
        for invariant in Invariant::ALL {
            let value = watch.value(invariant, system, scheme, memory, state);
            watch.drifts[invariant as usize] = value.map(|(value, _)| Drift::new(state.t, value));
        }
        watch
    }

    pub(super) fn add_work(&mut self, work: f64) {
        self.work.add(work);
    }

    pub(super) fn observe<A: Acts<D>, S: SceneScheme<D, A>>(
        &mut self,
        system: &System<D, A>,
        scheme: &S,
        memory: &S::Memory,
        state: &SceneState<D>,
    ) {
        for invariant in Invariant::ALL {
            let Some((value, deviation)) = self.value(invariant, system, scheme, memory, state) else { continue };
            if let Some(drift) = &mut self.drifts[invariant as usize] {
                drift.observe(state.t, value, deviation.unwrap_or(value - drift.start()));
            }
        }
    }

    pub(super) fn drifts(&self) -> Drifts {
        self.drifts
    }

    /// The value, and for vectors the length of the difference from the start.
    fn value<A: Acts<D>, S: SceneScheme<D, A>>(
        &self,
        invariant: Invariant,
        system: &System<D, A>,
        scheme: &S,
        memory: &S::Memory,
        state: &SceneState<D>,
    ) -> Option<(f64, Option<f64>)> {
        let conservative = A::AUTONOMOUS && A::CONSERVES_ENERGY;
        let free = !system.setting.pinned;
        let scalar = match invariant {
            Invariant::Energy if conservative => {
                let (q, v) = (Vectors::from_list(&state.q), Vectors::from_list(&state.v));
                system.acts.potential(&q, state.t) + system.setting.kinetic_energy(&v)
            }
            Invariant::DiscreteEnergy if conservative => scheme.discrete_energy(system, state.t, memory)?,
            Invariant::WorkEnergy => (scheme.kinetic_energy(&system.setting, memory) - self.work.hi) - self.work.lo,
            Invariant::LinearMomentum if free && A::LINEAR_MOMENTUM => {
                return Some(moved(&linear(&self.masses, state), &self.start[0]));
            }
            Invariant::AngularMomentum if free && A::ANGULAR_MOMENTUM && D > 1 => {
                return Some(moved(&angular(&self.masses, state), &self.start[1]));
            }
            _ => return None,
        };
        Some((scalar, None))
    }
}

/// |x|, and |x − x₀|; with its sign if x is a number.
fn moved(x: &[f64], start: &[f64]) -> (f64, Option<f64>) {
    if let ([x], [start]) = (x, start) {
        return (*x, Some(x - start));
    }
    let norm = |squares: f64| squares.sqrt();
    let difference = x.iter().zip(start).map(|(x, y)| (x - y) * (x - y)).sum();
    (norm(x.iter().map(|x| x * x).sum()), Some(norm(difference)))
}

/// Σ m v.
fn linear<const D: usize>(masses: &[f64], state: &SceneState<D>) -> Vec<f64> {
    (0..D).map(|k| sum(masses.iter().zip(&state.v).map(|(m, v)| m * v[k]))).collect()
}

/// Σ m (q_k v_l − q_l v_k), k < l.
fn angular<const D: usize>(masses: &[f64], state: &SceneState<D>) -> Vec<f64> {
    let components = (0..D).flat_map(|k| (k + 1..D).map(move |l| (k, l)));
    let bodies = || masses.iter().zip(state.q.iter().zip(&state.v));
    components.map(|(k, l)| sum(bodies().map(|(m, (q, v))| m * (q[k] * v[l] - q[l] * v[k])))).collect()
}

/// A sum whose rounding does not grow with the number of bodies: it would show as a drift that is none.
fn sum(terms: impl Iterator<Item = f64>) -> f64 {
    let mut sum = Compensated::new(0.0);
    terms.for_each(|term| sum.add(term));
    sum.value()
}
