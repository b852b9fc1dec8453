//! Members of one law.

use super::Ensemble;
use super::company::Companies;
use super::plan::Plan;
use super::rides::Rides;
use crate::law::Fields;
use crate::run::{Attend, Simulation};
use crate::state::State;

/// A member of an ensemble before it moves.
pub(super) type Moving<E, L, const D: usize> =
    Simulation<L, State<D>, <E as Members<L, D>>::Scheme, <E as Members<L, D>>::Attend>;

/// The same without what accompanies it.
pub(super) type Bare<E, L, const D: usize> = Simulation<L, State<D>, <E as Members<L, D>>::Scheme>;

/// What is to be done with all of them.
pub(super) type PlanOf<'a, E, L, const D: usize> =
    Plan<'a, L, <E as Members<L, D>>::Scheme, <E as Members<L, D>>::Attend, D>;

/// An ensemble that has all that its members need: laws, starts, masses, and a scheme that moves them.
#[diagnostic::on_unimplemented(
    message = "this ensemble cannot be run yet",
    note = "it needs `.law(|k| …)`, `.start(|k| …)` and `.scheme(…)`; where its members are no laws with one start each, `Ensemble::each` takes simulations of any kind"
)]
pub trait Members<L: Fields<D>, const D: usize>: Sync {
    /// The scheme of all.
    type Scheme: Rides<L, D> + Sync;
    /// What accompanies each.
    type Attend: Attend<State<D>>;

    /// What all have in common.
    #[doc(hidden)]
    fn common(&self) -> &Simulation<(), (), Self::Scheme>;

    /// One of them, without what accompanies it.
    #[doc(hidden)]
    fn bare(&self, k: usize) -> Simulation<L, State<D>, Self::Scheme>;

    /// One of them.
    #[doc(hidden)]
    fn member(&self, k: usize) -> Simulation<L, State<D>, Self::Scheme, Self::Attend>;
}

impl<F, X, S, M, C, L, const D: usize> Members<L, D> for Ensemble<F, X, S, M, C>
where
    F: Fn(usize) -> L + Sync,
    X: Fn(usize) -> State<D> + Sync,
    M: Fn(usize) -> f64 + Sync,
    L: Fields<D>,
    S: Rides<L, D> + Sync,
    C: Companies<State<D>>,
{
    type Scheme = S;
    type Attend = C::Attend;

    fn common(&self) -> &Simulation<(), (), S> {
        &self.common
    }

    fn bare(&self, k: usize) -> Simulation<L, State<D>, S> {
        self.common.clone().moving((self.law)(k), (self.start)(k)).mass((self.mass)(k))
    }

    fn member(&self, k: usize) -> Simulation<L, State<D>, S, C::Attend> {
        self.bare(k).accompanied(self.company.of(k))
    }
}
