//! Laws of which some are there, side by side with free motions.

use dmech_scalar::{Mask, Real};

use super::{Between, Field, Potential};
use crate::look::{Course, Frequency};
use crate::newton::{self, Equation, Increment, NotConverged};
use crate::vector::{either, either_matrix};

/// Functions that are asked of what is within, and by what their values are passed on: `or(v) kick(…)` is
/// `self.or(v, self.law.kick(…))`.
macro_rules! passed_on {
    ($within:ident: $($by:ident $(($without:expr))? $name:ident($($x:ident: $t:ty),*) -> $out:ty;)*) => {$(
        #[inline(always)]
        fn $name(&self, $($x: $t),*) -> $out {
            self.$by($($without,)? self.$within.$name($($x),*))
        }
    )*};
}
pub(super) use passed_on;

/// What acts in the lanes in which a law is there; nothing in the others. To the bit what `Option` gives in each.
#[derive(Clone, Copy, Debug)]
pub struct Perhaps<F, R: Real> {
    law: F,
    here: R::Mask,
}

impl<F, R: Real> Perhaps<F, R> {
    /// Here where the number is 1, not where it is 0.
    #[inline(always)]
    pub(super) fn new(law: F, here: R) -> Self {
        Perhaps { law, here: here.equal(R::ONE) }
    }

    #[inline(always)]
    fn number(&self, x: R) -> R {
        R::either(self.here, x, R::ZERO)
    }

    #[inline(always)]
    fn vector<const D: usize>(&self, x: [R; D]) -> [R; D] {
        self.or([R::ZERO; D], x)
    }

    /// x where the law is here, else what there is without it.
    #[inline(always)]
    fn or<const D: usize>(&self, without: [R; D], x: [R; D]) -> [R; D] {
        either(self.here, x, without)
    }

    #[inline(always)]
    fn matrix<const D: usize>(&self, x: [[R; D]; D]) -> [[R; D]; D] {
        either_matrix(self.here, x, [[R::ZERO; D]; D])
    }

    /// The increment by the law, or of free motion. Where there is no law, the equation of the first that has one is solved once more:
    /// nobody waits for a root where there is none.
    fn increment<const D: usize>(
        &self,
        equation: &Equation<D, R>,
        by_law: impl FnOnce(&F, &Equation<D, R>) -> Result<Increment<D, R>, NotConverged>,
    ) -> Result<Increment<D, R>, NotConverged> {
        if self.here.all() {
            return by_law(&self.law, equation);
        }
        let free = newton::free(equation)?;
        if !self.here.any() {
            return Ok(free);
        }
        Ok(Increment::either(self.here, by_law(&self.law, &equation.lent(self.here))?, free))
    }
}

impl<F: Potential<D, R>, const D: usize, R: Real> Potential<D, R> for Perhaps<F, R> {
    const CENTRAL: bool = F::CENTRAL;
    const LINEAR: bool = F::LINEAR;
    const PIECEWISE: bool = F::PIECEWISE;
    const DEGREE: Option<u32> = F::DEGREE;

    passed_on! { law:
        number potential(q: [R; D]) -> R;
        vector gradient(q: [R; D]) -> [R; D];
        matrix hessian(q: [R; D]) -> [[R; D]; D];
        vector discrete_gradient(a: [R; D], b: [R; D]) -> [R; D];
        matrix discrete_gradient_jacobian(a: [R; D], b: [R; D]) -> [[R; D]; D];
    }
}

impl<F: Field<D, R>, const D: usize, R: Real> Field<D, R> for Perhaps<F, R> {
    const FORCED: bool = F::FORCED;
    const CONSERVES_ENERGY: bool = F::CONSERVES_ENERGY;

    passed_on! { law:
        vector slope(q: [R; D], v: [R; D]) -> [R; D];
        vector half_force(q: [R; D], v: [R; D]) -> [R; D];
        vector force(q: [R; D], v: [R; D], t: R) -> [R; D];
        matrix force_dq(q: [R; D], v: [R; D], t: R) -> [[R; D]; D];
        matrix force_dv(q: [R; D], v: [R; D], t: R) -> [[R; D]; D];
        number time() -> R;
        or(v) kick(c: R, q: [R; D], v: [R; D]) -> [R; D];
        or(v) gradient_kick(c: R, e: R, q: [R; D], v: [R; D]) -> [R; D];
        or(v) kick_by_mean(c: R, q: [R; D], v: [R; D]) -> [R; D];
    }
    fn implicit_increment(&self, equation: &Equation<D, R>) -> Result<Increment<D, R>, NotConverged> {
        self.increment(equation, F::implicit_increment)
    }
    fn discrete_increment(&self, equation: &Equation<D, R>) -> Result<Increment<D, R>, NotConverged> {
        self.increment(equation, F::discrete_increment)
    }
    fn potential_increment(&self, equation: &Equation<D, R>) -> Result<Increment<D, R>, NotConverged> {
        self.increment(equation, F::potential_increment)
    }
    fn workless_increment(&self, equation: &Equation<D, R>) -> Result<Increment<D, R>, NotConverged> {
        self.increment(equation, F::workless_increment)
    }
    fn frequency(from_now: impl Fn(R) -> Option<Self>, mass: R, t: R, course: Course<D, R>) -> Frequency<R> {
        let Some(Perhaps { here, .. }) = from_now(R::ZERO) else { return F::frequency(|_| None, mass, t, course) };
        let under = |course| F::frequency(|s| Some(from_now(s)?.law), mass, t, course);
        if here.all() {
            return under(course);
        }
        let free = F::frequency(|_| None, mass, t, course);
        if here.any() { free.where_alone(here.not(), under(course.lent(here))) } else { free }
    }
}

impl<B: Between<D, R>, const D: usize, R: Real> Between<D, R> for Perhaps<B, R> {
    const POTENTIAL: bool = B::POTENTIAL;
    const FORCED: bool = B::FORCED;
    const RECIPROCAL: bool = B::RECIPROCAL;

    #[inline(always)]
    fn reaches(&self, d: [R; D]) -> Option<R::Mask> {
        self.law.reaches(d)
    }
    #[inline(always)]
    fn force(&self, d: [R; D], va: [R; D], vb: [R; D]) -> [R; D] {
        self.vector(self.law.force(d, va, vb))
    }
    #[inline(always)]
    fn force_jacobians(&self, d: [R; D], va: [R; D], vb: [R; D]) -> [[[R; D]; D]; 3] {
        let [by_d, by_va, by_vb] = self.law.force_jacobians(d, va, vb);
        [self.matrix(by_d), self.matrix(by_va), self.matrix(by_vb)]
    }
}
