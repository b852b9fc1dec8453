//! How the members of an ensemble travel: in lanes, or each alone.

use dmech_scalar::Rows;

use super::block::{Block, Outcome};
use super::lanes::in_lanes;
use super::member::Member;
use super::rows::{WIDE, rows};
use super::steps::InLanes;
use crate::law::{Fields, LinearInVelocity, VelocityIndependent};
use crate::run::Attend;
use crate::scheme::coefficients::{ForceGradientCoefficients, NystromCoefficients};
use crate::scheme::{
    Adaptive, Boris, Coefficients, CompensatedLeapfrog, Composed, DiscreteGradient, Explicit, ForceGradient, Gauss,
    Implicit, Kanatani, Leapfrog, LineIntegral, Nystrom, Relaxed, RungeKuttaNystrom, Scheme,
};
use crate::state::State;
use crate::system::{AtStages, Particle};

impl<L: Fields<D>, S: Scheme<Particle<L, D>>, O: Attend<State<D>>, const D: usize> Block<'_, L, S, O, D> {
    /// One member by itself.
    pub(super) fn alone(&self, k: usize) -> Outcome<State<D>> {
        Member::begin(self, k).and_then(|member| member.alone().end())
    }

    /// All of them, one by one.
    pub(super) fn one_by_one(&self) -> Vec<Outcome<State<D>>> {
        self.members.clone().map(|k| self.alone(k)).collect()
    }
}

/// A scheme that moves the members of an ensemble.
///
/// A scheme of one's own moves each alone: `impl<L: Fields<D>, const D: usize> Rides<L, D> for MyScheme {}`, with
/// `L: Fields<D> + VelocityIndependent` where it is for `WithoutVelocities`, and `+ LinearInVelocity` for `LinearVelocities`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not move the members of an ensemble under `{L}`",
    note = "`NoScheme` means that none was given: call `.scheme(…)`",
    note = "a scheme of your own says that it moves each alone: `impl<L: Fields<D>, const D: usize> Rides<L, D> for {Self} {{}}`; \
            with `L: Fields<D> + VelocityIndependent` where it is one for `WithoutVelocities`"
)]
pub trait Rides<L: Fields<D>, const D: usize>: Scheme<Particle<L, D>> {
    /// Moves the members of a block.
    #[doc(hidden)]
    fn ride<O: Attend<State<D>>>(block: &Block<'_, L, Self, O, D>) -> Vec<Outcome<State<D>>> {
        block.one_by_one()
    }
}

/// Side by side in W rows of eight lanes, if a step of all has room on the stack of a thread for so many numbers of each. To the
/// same bits alone, if it has not.
fn side_by_side<L, S, O, const D: usize, const W: usize>(
    block: &Block<'_, L, S, O, D>,
    numbers: usize,
    few: usize,
) -> Vec<Outcome<State<D>>>
where
    L: Fields<D>,
    S: InLanes<L, D, W> + Rides<L, D>,
    O: Attend<State<D>>,
{
    const BYTES: usize = 1 << 17;
    if block.lanes == 1 || numbers * size_of::<Rows<W>>() > BYTES { block.one_by_one() } else { in_lanes(block, few) }
}

/// The last who are left move one by one, if they are so few: a step of eight lanes takes, with AVX2, 1.0 to 1.5 times as long as one of
/// an explicit scheme alone, 1.6 to 2.8 times where equations are solved, and seven times where stages stand side by side already.
const FEW: usize = 1;
const FEW_WITH_STAGES: usize = 6;

/// Schemes, what the forces must be like, and the parameters of the scheme.
macro_rules! ride {
    ($way:ident: $($scheme:ty, $forces:path, [$($generics:tt)*];)*) => {$(
        impl<L: Fields<D> + $forces, const D: usize, $($generics)*> Rides<L, D> for $scheme {
            ride!($way);
        }
    )*};
    (in_lanes) => {
        ride!(by_rows 8 * D);
    };
    (in_lanes_with_matrices) => {
        ride!(by_rows D * D);
    };
    // Eight stages stand side by side already.
    (in_lanes_with_stages) => {
        fn ride<O: Attend<State<D>>>(block: &Block<'_, L, Self, O, D>) -> Vec<Outcome<State<D>>> {
            side_by_side::<_, _, _, D, 1>(block, D * D, FEW_WITH_STAGES)
        }
    };
    (by_rows $numbers:expr) => {
        fn ride<O: Attend<State<D>>>(block: &Block<'_, L, Self, O, D>) -> Vec<Outcome<State<D>>> {
            if const { rows(D) == 1 } {
                side_by_side::<_, _, _, D, 1>(block, $numbers, FEW)
            } else {
                side_by_side::<_, _, _, D, WIDE>(block, $numbers, FEW)
            }
        }
    };
    (alone) => {};
}

ride! {
    in_lanes:
    Leapfrog, VelocityIndependent, [];
    CompensatedLeapfrog, VelocityIndependent, [];
    Composed<Leapfrog, C, N>, VelocityIndependent, [C: Coefficients<N>, const N: usize];
    Nystrom<C, N>, VelocityIndependent, [C: NystromCoefficients<N>, const N: usize];
    RungeKuttaNystrom, VelocityIndependent, [];
    Explicit, Sized, [];
}

ride! {
    in_lanes_with_stages:
    Gauss, AtStages<D, f64>, [];
    LineIntegral<N>, AtStages<D, f64>, [const N: usize];
    Adaptive<Gauss>, AtStages<D, f64>, [];
    Adaptive<LineIntegral<N>>, AtStages<D, f64>, [const N: usize];
}

ride! {
    in_lanes_with_matrices:
    ForceGradient<C, N>, VelocityIndependent, [C: ForceGradientCoefficients<N>, const N: usize];
    Kanatani, VelocityIndependent, [];
    Boris, LinearInVelocity, [];
    Composed<Boris, C, N>, LinearInVelocity, [C: Coefficients<N>, const N: usize];
    Implicit, Sized, [];
    Composed<Implicit, C, N>, Sized, [C: Coefficients<N>, const N: usize];
    DiscreteGradient, Sized, [];
    Composed<DiscreteGradient, C, N>, Sized, [C: Coefficients<N>, const N: usize];
    Adaptive<Composed<Leapfrog, C, N>>, VelocityIndependent, [C: Coefficients<N>, const N: usize];
    Adaptive<Nystrom<C, N>>, VelocityIndependent, [C: NystromCoefficients<N>, const N: usize];
    Adaptive<RungeKuttaNystrom>, VelocityIndependent, [];
    Adaptive<ForceGradient<C, N>>, VelocityIndependent, [C: ForceGradientCoefficients<N>, const N: usize];
    Adaptive<Boris>, LinearInVelocity, [];
    Adaptive<Composed<Boris, C, N>>, LinearInVelocity, [C: Coefficients<N>, const N: usize];
    Adaptive<Implicit>, Sized, [];
    Adaptive<Composed<Implicit, C, N>>, Sized, [C: Coefficients<N>, const N: usize];
    Adaptive<DiscreteGradient>, Sized, [];
    Adaptive<Composed<DiscreteGradient, C, N>>, Sized, [C: Coefficients<N>, const N: usize];
}

// The correction of the energy is one of each motion.
ride! {
    alone:
    Relaxed<C, N>, VelocityIndependent, [C: NystromCoefficients<N>, const N: usize];
}
