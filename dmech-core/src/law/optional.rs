//! A law that may be there or not.

use dmech_scalar::Real;

use super::perhaps::Perhaps;
use super::written::{Written, WrittenPair};
use super::{
    Between, Field, Fields, Law, LinearInVelocity, MassIndependent, Numbers, PairFields, PairLaw, Potential, Reads,
    Symmetric, VelocityIndependent,
};
use crate::error::Error;
use crate::look::{Course, Frequency};
use crate::newton::{Equation, Increment, NotConverged, free};

/// `Option<MyLaw>` is a law: `None` is free motion. A wind that blows for a while, a hand that holds and lets go:
/// `stepper.law_mut()` changes it on the way. Of an [ensemble](crate::Ensemble) some members may have one and others none.
///
/// Without a law each coordinate has the mass of the simulation: the masses of the bodies of a `Scene::as_law` are with that law. A scene
/// with `.pairs(None::<MyLaw>)` has them.
#[diagnostic::do_not_recommend]
impl<L: Law<D, R>, const D: usize, R: Real> Law<D, R> for Option<L> {
    type Field<'a>
        = Option<L::Field<'a>>
    where
        L: 'a;

    const AUTONOMOUS: bool = L::AUTONOMOUS;
    const BODY: usize = L::BODY;
    const LINEAR_MOMENTUM: bool = L::LINEAR_MOMENTUM;
    const ANGULAR_MOMENTUM: bool = L::ANGULAR_MOMENTUM;
    const ALL_COUNT: bool = L::ALL_COUNT;
    const INVARIANTS: &'static [&'static str] = L::INVARIANTS;

    fn invariant(&self, k: usize, q: [R; D], v: [R; D], t: R) -> R {
        self.as_ref().map_or(R::ZERO, |law| law.invariant(k, q, v, t))
    }

    #[inline(always)]
    fn field(&self, mass: R, t: R) -> Self::Field<'_> {
        self.as_ref().map(|law| law.field(mass, t))
    }

    fn refused(&self) -> Option<Error> {
        self.as_ref()?.refused()
    }

    fn pinned(&self, i: usize) -> bool {
        self.as_ref().is_some_and(|law| law.pinned(i))
    }

    #[inline(always)]
    fn mass_ratios(&self) -> [f64; D] {
        self.as_ref().map_or([1.0; D], L::mass_ratios)
    }

    #[inline(always)]
    fn weights(&self) -> [R; D] {
        self.as_ref().map_or([R::ONE; D], L::weights)
    }

    fn written(&self) -> Option<&dyn Written<D>> {
        self.as_ref()?.written()
    }

    fn tell(&self, see: &mut dyn FnMut(&'static str, f64)) {
        self.iter().for_each(|law| law.tell(see));
    }
}

/// 1 and the numbers of the law; 0 and nothing where there is none.
fn numbers<N: Numbers>(law: Option<N>) -> ([f64; 1], N) {
    law.map_or_else(|| ([0.0], N::from_list(|_| 0.0)), |numbers| ([1.0], numbers))
}

#[diagnostic::do_not_recommend]
impl<L: Fields<D>, const D: usize> Fields<D> for Option<L> {
    type Numbers = ([f64; 1], L::Numbers);
    type Moment<R: Real> = Perhaps<L::Moment<R>, R>;

    fn numbers(&self) -> Self::Numbers {
        numbers(self.as_ref().map(L::numbers))
    }

    fn names(see: &mut dyn FnMut(&'static str)) {
        see("there");
        L::names(see);
    }

    #[inline(always)]
    fn moment<R: Real>(([here], numbers): ([R; 1], <L::Numbers as Numbers>::Of<R>), mass: R, t: R) -> Self::Moment<R> {
        Perhaps::new(L::moment(numbers, mass, t), here)
    }

    /// Of the first that has a law, so that functions of it are finite where they are thrown away.
    fn lend(all: &mut [Self::Numbers]) {
        if let Some((_, lent)) = all.iter().find(|([here], _)| *here == 1.0).copied() {
            all.iter_mut().filter(|([here], _)| *here == 0.0).for_each(|(_, numbers)| *numbers = lent);
        }
    }

    #[inline(always)]
    fn masses<R: Real>(([here], numbers): ([R; 1], <L::Numbers as Numbers>::Of<R>)) -> [R; D] {
        let here = here.equal(R::ONE);
        L::masses(numbers).map(|mass| R::either(here, mass, R::ONE))
    }
}

impl<L: VelocityIndependent> VelocityIndependent for Option<L> {}
impl<L: LinearInVelocity> LinearInVelocity for Option<L> {}
impl<L: MassIndependent> MassIndependent for Option<L> {}

/// Functions that are asked of the law, and what they are without one.
macro_rules! asked {
    ($($name:ident($($x:ident: $t:ty),*) -> $out:ty, else $without:expr;)*) => {$(
        #[inline(always)]
        fn $name(&self, $($x: $t),*) -> $out {
            self.as_ref().map_or($without, |law| law.$name($($x),*))
        }
    )*};
}

/// Nothing acts.
const fn nothing<const D: usize, R: Real>() -> [[R; D]; D] {
    [[R::ZERO; D]; D]
}

impl<F: Potential<D, R>, const D: usize, R: Real> Potential<D, R> for Option<F> {
    const CENTRAL: bool = F::CENTRAL;
    const LINEAR: bool = F::LINEAR;
    const PIECEWISE: bool = F::PIECEWISE;
    const DEGREE: Option<u32> = F::DEGREE;

    asked! {
        potential(q: [R; D]) -> R, else R::ZERO;
        gradient(q: [R; D]) -> [R; D], else [R::ZERO; D];
        hessian(q: [R; D]) -> [[R; D]; D], else nothing();
        discrete_gradient(a: [R; D], b: [R; D]) -> [R; D], else [R::ZERO; D];
        discrete_gradient_jacobian(a: [R; D], b: [R; D]) -> [[R; D]; D], else nothing();
    }
}

/// What a scheme asks is asked of the law, so that it is stepped as it would be alone.
impl<F: Field<D, R>, const D: usize, R: Real> Field<D, R> for Option<F> {
    const FORCED: bool = F::FORCED;
    const CONSERVES_ENERGY: bool = F::CONSERVES_ENERGY;

    asked! {
        slope(q: [R; D], v: [R; D]) -> [R; D], else [R::ZERO; D];
        half_force(q: [R; D], v: [R; D]) -> [R; D], else [R::ZERO; D];
        force(q: [R; D], v: [R; D], t: R) -> [R; D], else [R::ZERO; D];
        force_dq(q: [R; D], v: [R; D], t: R) -> [[R; D]; D], else nothing();
        force_dv(q: [R; D], v: [R; D], t: R) -> [[R; D]; D], else nothing();
        time() -> R, else R::ZERO;
        kick(c: R, q: [R; D], v: [R; D]) -> [R; D], else v;
        gradient_kick(c: R, e: R, q: [R; D], v: [R; D]) -> [R; D], else v;
        kick_by_mean(c: R, q: [R; D], v: [R; D]) -> [R; D], else v;
    }
    fn implicit_increment(&self, equation: &Equation<D, R>) -> Result<Increment<D, R>, NotConverged> {
        self.as_ref().map_or_else(|| free(equation), |field| field.implicit_increment(equation))
    }
    fn discrete_increment(&self, equation: &Equation<D, R>) -> Result<Increment<D, R>, NotConverged> {
        self.as_ref().map_or_else(|| free(equation), |field| field.discrete_increment(equation))
    }
    fn potential_increment(&self, equation: &Equation<D, R>) -> Result<Increment<D, R>, NotConverged> {
        self.as_ref().map_or_else(|| free(equation), |field| field.potential_increment(equation))
    }
    fn workless_increment(&self, equation: &Equation<D, R>) -> Result<Increment<D, R>, NotConverged> {
        self.as_ref().map_or_else(|| free(equation), |field| field.workless_increment(equation))
    }
    fn frequency(from_now: impl Fn(R) -> Option<Self>, mass: R, t: R, course: Course<D, R>) -> Frequency<R> {
        F::frequency(|s| from_now(s).flatten(), mass, t, course)
    }
}

#[diagnostic::do_not_recommend]
impl<P, X: Reads<P>> Reads<P> for Option<X> {
    type Numbers = X::Numbers;

    fn numbers(mass: f64, data: &P) -> X::Numbers {
        X::numbers(mass, data)
    }
}

#[diagnostic::do_not_recommend]
impl<X: Symmetric> Symmetric for Option<X> {}

/// A law between two bodies that may be there or not: a bond that breaks, a charge that is switched off.
#[diagnostic::do_not_recommend]
impl<const D: usize, P, R: Real, X: PairLaw<D, P, R>> PairLaw<D, P, R> for Option<X> {
    type Between<'a>
        = Option<X::Between<'a>>
    where
        Self: 'a;

    const AUTONOMOUS: bool = X::AUTONOMOUS;

    #[inline(always)]
    fn between(&self, a: <X::Numbers as Numbers>::Of<R>, b: <X::Numbers as Numbers>::Of<R>, t: R) -> Self::Between<'_> {
        self.as_ref().map(|law| law.between(a, b, t))
    }

    fn written(&self) -> Option<&dyn WrittenPair<D, P>> {
        self.as_ref()?.written()
    }
}

#[diagnostic::do_not_recommend]
impl<const D: usize, P, X: PairFields<D, P>> PairFields<D, P> for Option<X> {
    type Fields = ([f64; 1], X::Fields);
    type Moment<R: Real> = Perhaps<X::Moment<R>, R>;

    fn fields(&self) -> Self::Fields {
        numbers(self.as_ref().map(X::fields))
    }

    fn names(see: &mut dyn FnMut(&'static str)) {
        see("there");
        X::names(see);
    }

    #[inline(always)]
    fn moment<R: Real>(
        ([here], fields): ([R; 1], <X::Fields as Numbers>::Of<R>),
        a: <X::Numbers as Numbers>::Of<R>,
        b: <X::Numbers as Numbers>::Of<R>,
        t: R,
    ) -> Self::Moment<R> {
        Perhaps::new(X::moment(fields, a, b, t), here)
    }
}

impl<B: Between<D, R>, const D: usize, R: Real> Between<D, R> for Option<B> {
    const POTENTIAL: bool = B::POTENTIAL;
    const FORCED: bool = B::FORCED;
    const RECIPROCAL: bool = B::RECIPROCAL;

    asked! {
        force(d: [R; D], va: [R; D], vb: [R; D]) -> [R; D], else [R::ZERO; D];
        force_jacobians(d: [R; D], va: [R; D], vb: [R; D]) -> [[[R; D]; D]; 3], else [nothing(); 3];
    }
}
