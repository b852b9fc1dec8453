//! Members of one law.

use super::Ensemble;
use super::rides::Rides;
use crate::law::Fields;
use crate::run::Simulation;
use crate::state::State;

/// An ensemble that has all that its members need: laws, starts, masses, and a scheme that moves them.
#[diagnostic::on_unimplemented(
    message = "this ensemble cannot be run yet",
    note = "it needs `.law(|k| …)`, `.start(|k| …)` and `.scheme(…)`; where its members are no laws with one start each, `Ensemble::each` takes simulations of any kind"
)]
pub trait Members<L: Fields<D>, const D: usize>: Sync {
    /// The scheme of all.
    type Scheme: Rides<L, D> + Sync;

    /// What all have in common.
    #[doc(hidden)]
    fn common(&self) -> &Simulation<(), (), Self::Scheme>;

    /// One of them.
    #[doc(hidden)]
    fn member(&self, k: usize) -> Simulation<L, State<D>, Self::Scheme>;
}

impl<F, X, S, M, L, const D: usize> Members<L, D> for Ensemble<F, X, S, M>
where
    F: Fn(usize) -> L + Sync,
    X: Fn(usize) -> State<D> + Sync,
    M: Fn(usize) -> f64 + Sync,
    L: Fields<D>,
    S: Rides<L, D> + Sync,
{
    type Scheme = S;

    fn common(&self) -> &Simulation<(), (), S> {
        &self.common
    }

    fn member(&self, k: usize) -> Simulation<L, State<D>, S> {
        self.common.clone().moving((self.law)(k), (self.start)(k)).mass((self.mass)(k))
    }
}
