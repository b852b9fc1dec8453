//! How the members of an ensemble travel: in lanes, or each alone.

use core::ops::Range;

use super::lanes::in_lanes;
use super::steps::InLanes;
use crate::error::Error;
use crate::law::Fields;
use crate::run::{Attend, Due, Interrupted, Run, Simulation};
use crate::scheme::coefficients::{ForceGradientCoefficients, NystromCoefficients};
use crate::scheme::{
    Adaptive, Boris, Coefficients, CompensatedLeapfrog, Composable, Composed, DiscreteGradient, Explicit,
    ForceGradient, Gauss, Implicit, Kanatani, Leapfrog, LineIntegral, Nystrom, Relaxed, Scheme,
};
use crate::span::Span;
use crate::state::State;
use crate::system::Particle;

/// What becomes of a member: its run, or what it had come to when it failed.
pub type Outcome<X> = Result<Run<X>, Interrupted<X>>;

/// Some members in a row.
pub struct Block<'a, L, S, const D: usize> {
    pub(super) members: Range<usize>,
    pub(super) member: &'a (dyn Fn(usize) -> Simulation<L, State<D>, S> + Sync),
    pub(super) span: Span,
    /// How many side by side.
    pub(super) lanes: usize,
}

impl<L, S, const D: usize> core::fmt::Debug for Block<'_, L, S, D> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Block").field("members", &self.members).field("lanes", &self.lanes).finish_non_exhaustive()
    }
}

impl<L: Fields<D>, S: Scheme<Particle<L, D>>, const D: usize> Block<'_, L, S, D> {
    /// One member by itself.
    pub(super) fn alone(&self, k: usize) -> Outcome<State<D>> {
        let simulation = (self.member)(k);
        let mut outcome = match simulation.due() {
            Due::Every(_) => simulation.attended(Forget).record(self.span),
            _ => simulation.record(self.span),
        };
        match &mut outcome {
            Ok(run) => run.forget_work(),
            Err(interrupted) => interrupted.run_mut().forget_work(),
        }
        outcome
    }

    /// All of them, one by one.
    pub(super) fn one_by_one(&self) -> Vec<Outcome<State<D>>> {
        self.members.clone().map(|k| self.alone(k)).collect()
    }
}

/// Looks at the states that are due, and keeps none.
#[derive(Clone, Copy, Debug)]
struct Forget;

impl<X> Attend<X> for Forget {
    const STREAMS: bool = true;

    fn take(&mut self, _: &X) -> Result<bool, Error> {
        Ok(true)
    }
}

/// A scheme that moves the members of an ensemble.
///
/// A scheme of one's own moves each alone: `impl<L: Fields<D>, const D: usize> Rides<L, D> for MyScheme {}`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not move the members of an ensemble under `{L}`",
    note = "a scheme of your own says that it moves each alone: `impl<L: Fields<D>, const D: usize> Rides<L, D> for {Self} {{}}`"
)]
pub trait Rides<L: Fields<D>, const D: usize>: Scheme<Particle<L, D>> {
    /// Moves the members of a block.
    #[doc(hidden)]
    fn ride(block: &Block<'_, L, Self, D>) -> Vec<Outcome<State<D>>> {
        block.one_by_one()
    }
}

macro_rules! ride {
    (in_lanes: $($scheme:ty, [$($generics:tt)*];)*) => {$(
        impl<L: Fields<D>, const D: usize, $($generics)*> Rides<L, D> for $scheme
        where
            Self: InLanes<L, D>,
        {
            fn ride(block: &Block<'_, L, Self, D>) -> Vec<Outcome<State<D>>> {
                if block.lanes > 1 { in_lanes(block) } else { block.one_by_one() }
            }
        }
    )*};
    (alone: $($scheme:ty, [$($generics:tt)*];)*) => {$(
        impl<L: Fields<D>, const D: usize, $($generics)*> Rides<L, D> for $scheme where Self: Scheme<Particle<L, D>> {}
    )*};
}

ride! {
    in_lanes:
    Leapfrog, [];
    Explicit, [];
    CompensatedLeapfrog, [];
    Boris, [];
    Composed<Leapfrog, C, N>, [C: Coefficients<N>, const N: usize];
    Composed<Boris, C, N>, [C: Coefficients<N>, const N: usize];
    Nystrom<C, N>, [C: NystromCoefficients<N>, const N: usize];
    ForceGradient<C, N>, [C: ForceGradientCoefficients<N>, const N: usize];
    Adaptive<DiscreteGradient>, [];
    Adaptive<Implicit>, [];
    Adaptive<Boris>, [];
    Adaptive<Composed<S, C, N>>, [S: Composable, C: Coefficients<N>, const N: usize];
    Adaptive<Nystrom<C, N>>, [C: NystromCoefficients<N>, const N: usize];
    Adaptive<ForceGradient<C, N>>, [C: ForceGradientCoefficients<N>, const N: usize];
    Composed<DiscreteGradient, C, N>, [C: Coefficients<N>, const N: usize];
    Composed<Implicit, C, N>, [C: Coefficients<N>, const N: usize];
    Kanatani, [];
    DiscreteGradient, [];
    Implicit, [];
}

// The stages of Gauss fill the lanes themselves.
ride! {
    alone:
    Gauss, [];
    LineIntegral<N>, [const N: usize];
    Relaxed<C, N>, [C: NystromCoefficients<N>, const N: usize];
    Adaptive<Gauss>, [];
    Adaptive<LineIntegral<N>>, [const N: usize];
}
