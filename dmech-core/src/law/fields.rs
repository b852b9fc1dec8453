//! Laws side by side.

use dmech_scalar::Real;

use super::{Between, Field, Law, LinearInVelocity, Numbers, PairLaw, Reads, VelocityIndependent};

/// A law that can be taken apart into the numbers that it reads of itself, so that those of many may stand side by side in the
/// lanes of a register, or be numbers of more digits.
///
/// `#[dmech::law]` and `#[derive(dmech::Law)]` write it.
#[diagnostic::on_unimplemented(
    message = "the numbers of `{Self}` cannot stand side by side with those of other members",
    label = "not a law of {D} coordinates that `#[dmech::law]` has written",
    note = "members that are laws written by hand or scenes of many bodies ride alone: `Ensemble::each(n, |k| Simulation::new(…)…)`",
    note = "a scene of few bodies is a law by `.as_law::<N, K>()`"
)]
pub trait Fields<const D: usize>: Law<D> {
    /// `[f64; N]`.
    type Numbers: Numbers;
    /// What acts at one moment, by numbers of any scalar.
    type Moment<R: Real>: Field<D, R>;

    /// What is read of the law.
    fn numbers(&self) -> Self::Numbers;

    /// The names of these numbers, in their order; several that follow one another may have the same.
    #[doc(hidden)]
    fn names(_see: &mut dyn FnMut(&'static str)) {}

    /// What acts on a particle of a mass at a time, by these numbers.
    fn moment<R: Real>(numbers: <Self::Numbers as Numbers>::Of<R>, mass: R, t: R) -> Self::Moment<R>;

    /// Gives to those who have no law, where there are such, the numbers of one that has: what nobody asks for is then worked out for
    /// something that can be.
    #[doc(hidden)]
    fn lend(_: &mut [Self::Numbers]) {}

    /// The mass of each coordinate over that of the particle, by these numbers; 0 for test bodies.
    #[doc(hidden)]
    #[inline(always)]
    fn masses<R: Real>(_: <Self::Numbers as Numbers>::Of<R>) -> [R; D] {
        [R::ONE; D]
    }
}

/// A law between two bodies that can be taken apart in the same way.
///
/// `#[dmech::law]` writes it.
#[diagnostic::on_unimplemented(
    message = "a scene under `{Self}` cannot be one law",
    label = "not a law between bodies in {D} dimensions that `#[dmech::law]` has written",
    note = "laws by hand remain with the scene: `Simulation::scene(…)`, and for many scenes `Ensemble::each(n, |k| …)`"
)]
pub trait PairFields<const D: usize, P>: PairLaw<D, P> {
    /// `[f64; N]`.
    type Fields: Numbers;
    /// What acts between two bodies at one moment, by numbers of any scalar.
    type Moment<R: Real>: Between<D, R>;

    /// What is read of the law.
    fn fields(&self) -> Self::Fields;

    /// The names of these numbers, in their order.
    #[doc(hidden)]
    fn names(_see: &mut dyn FnMut(&'static str)) {}

    /// What acts between two bodies at a time, by the numbers of the law and of both.
    fn moment<R: Real>(
        law: <Self::Fields as Numbers>::Of<R>,
        a: <<Self as Reads<P>>::Numbers as Numbers>::Of<R>,
        b: <<Self as Reads<P>>::Numbers as Numbers>::Of<R>,
        t: R,
    ) -> Self::Moment<R>;
}

/// Laws side by side, one in each lane; or one, in another scalar.
#[derive(Clone, Copy)]
pub struct Numbered<L: Fields<D>, const D: usize, R: Real> {
    numbers: <L::Numbers as Numbers>::Of<R>,
}

impl<L: Fields<D>, const D: usize, R: Real> Numbered<L, D, R> {
    /// Of the numbers by index.
    pub(crate) fn new(number: impl FnMut(usize) -> R) -> Self {
        Numbered { numbers: L::Numbers::gather(number) }
    }
}

impl<L: Fields<D>, const D: usize, R: Real> core::fmt::Debug for Numbered<L, D, R> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Numbered").finish_non_exhaustive()
    }
}

#[diagnostic::do_not_recommend]
impl<L: Fields<D>, const D: usize, R: Real> Law<D, R> for Numbered<L, D, R> {
    type Field<'a>
        = L::Moment<R>
    where
        Self: 'a;

    const AUTONOMOUS: bool = <L as Law<D>>::AUTONOMOUS;
    const BODY: usize = <L as Law<D>>::BODY;
    const LINEAR_MOMENTUM: bool = <L as Law<D>>::LINEAR_MOMENTUM;
    const ANGULAR_MOMENTUM: bool = <L as Law<D>>::ANGULAR_MOMENTUM;
    const ALL_COUNT: bool = <L as Law<D>>::ALL_COUNT;

    #[inline(always)]
    fn field(&self, mass: R, t: R) -> L::Moment<R> {
        L::moment(self.numbers, mass, t)
    }

    #[inline(always)]
    fn weights(&self) -> [R; D] {
        L::masses(self.numbers)
    }
}

#[diagnostic::do_not_recommend]
impl<L: Fields<D> + VelocityIndependent, const D: usize, R: Real> VelocityIndependent for Numbered<L, D, R> {}

#[diagnostic::do_not_recommend]
impl<L: Fields<D> + LinearInVelocity, const D: usize, R: Real> LinearInVelocity for Numbered<L, D, R> {}
