//! Quantities of the state that a run watches.

use super::attend::Attend;
use super::simulation::{Attended, Simulation};
use crate::drift::Drift;
use crate::setup::Setup;

impl<L, X: Setup<L>, S, O> Simulation<L, X, S, O> {
    /// Watches a quantity of the state beside the invariants: how it moves over the recorded states is
    /// [`Run::drift_of(name)`](crate::Run::drift_of) and a line of the report; of states [at given times](Simulation::record_at), over the
    /// ends of the steps in which they lie. A law may declare such quantities of its motion
    /// itself (`#[invariant]`); this one is for those of a scene, and for a single run.
    ///
    /// ```
    /// # #[cfg(feature = "scene")] {
    /// use dmech_core::prelude::*;
    ///
    /// let scene = Scene::<1>::new().body(1.0, [0.0], [0.5]).body(3.0, [2.0], [-0.5]);
    /// let centre = |state: &SceneState<1>| (state.q[0][0] + 3.0 * state.q[1][0] + state.t) / 4.0;
    /// let run = Simulation::scene(scene).scheme(Leapfrog).dt(0.25).watch("centre of mass", centre).run(400)?;
    /// assert!(run.drift_of("centre of mass").unwrap().max_abs() < 1e-12);
    /// # }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// At most eight, each with a name of its own, which no invariant of the motion has: "energy" is free where the energy is not watched.
    ///
    /// # Errors
    /// When run: [`Error::WatchedTwice`](crate::Error::WatchedTwice).
    pub fn watch<F: FnMut(&X::State) -> f64>(
        self,
        name: &'static str,
        function: F,
    ) -> Attended<L, X, S, O, Quantity<F>> {
        self.attended(Quantity::new(name, function))
    }
}

/// A quantity that is watched.
#[derive(Clone)]
pub struct Quantity<F> {
    name: &'static str,
    function: F,
    drift: Option<Drift>,
}

impl<F> Quantity<F> {
    pub(crate) fn new(name: &'static str, function: F) -> Self {
        Quantity { name, function, drift: None }
    }
}

impl<F> core::fmt::Debug for Quantity<F> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Quantity").field("name", &self.name).field("drift", &self.drift).finish_non_exhaustive()
    }
}

impl<X, F: FnMut(&X) -> f64> Attend<X> for Quantity<F> {
    const QUANTITIES: usize = 1;

    fn look(&mut self, t: f64, state: &X, see: &mut dyn FnMut(f64)) {
        let value = (self.function)(state);
        let deviation = value - self.drift.map_or(value, |drift| drift.start());
        see(deviation);
        match &mut self.drift {
            Some(drift) => drift.observe(t, value, deviation),
            None => self.drift = Some(Drift::new(t, value)),
        }
    }

    fn drifts(&self, see: &mut dyn FnMut(&'static str, Drift)) {
        if let Some(drift) = self.drift {
            see(self.name, drift);
        }
    }
}
