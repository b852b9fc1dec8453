//! The implicit instructions of a particle: one equation of D unknowns, solved by code made for the law.

use dmech_scalar::{CompensatedVector, Real};

use super::equation::{ParticleFound, equation};
use super::{Particle, Stride, workless};
use crate::law::{Field, Law};
use crate::newton::{Equation, NotConverged};
use crate::system::{Effort, ImplicitSteps, Step};
use crate::vector::{scaled, sum};

/// The force beside the potential does no work: it is taken in the middle of the step.
const fn workless<L: Law<D, R>, const D: usize, R: Real>() -> bool {
    <L::Field<'_> as Field<D, R>>::FORCED && <L::Field<'_> as Field<D, R>>::CONSERVES_ENERGY
}

impl<L: Law<D, R>, const D: usize, R: Real> ImplicitSteps for Particle<L, D, R> {
    type Solver = ();
    type Found = ParticleFound<D, R>;

    fn solver(&self) {}

    /// Δ + (h²/4m)(S(q + Δ) + S) = h v.
    #[inline(always)]
    fn solve_mean(&self, (): &mut (), step: &Step<'_, Self>, known: &[R; D]) -> Result<Self::Found, NotConverged> {
        let Step { stride, v, .. } = *step;
        let g = R::from_f64(0.25) * stride.fall;
        let t_end = step.t + stride.dt;
        let mut equation = equation(step, stride.drift(v), g, scaled(g, *known));
        if L::Field::<'_>::FORCED {
            equation = Equation { v: v.hi, rate: stride.rate, t_end, ..equation };
        }
        Ok(self.field(t_end).implicit_increment(&equation)?.into())
    }

    /// Δ + (h²/2m)(∇̄Φ(q, q + Δ) − (F + F′)/2) = h v, with ∇̄Φ of the mid-time.
    #[inline(always)]
    fn solve_exact(&self, (): &mut (), step: &Step<'_, Self>) -> Result<Self::Found, NotConverged> {
        let Step { stride, t, q, v, .. } = *step;
        let half = R::from_f64(0.5);
        let field = self.field(half.mul_add(stride.dt, t));
        if const { workless::<L, D, R>() } {
            return workless::solve(&field, step);
        }
        let g = half * stride.fall;
        let equation = equation(step, stride.drift(v), g, [R::ZERO; D]);
        if !L::Field::<'_>::FORCED {
            return Ok(field.discrete_increment(&equation)?.into());
        }
        // The unknown side has the force at the end; that at the start is known.
        let half_force = self.field(t).half_force(q.hi, v.hi);
        let (frozen, t_end) = (scaled(-g, half_force), t + stride.dt);
        let equation = Equation { frozen, v: v.hi, rate: stride.rate, t_end, ..equation };
        Ok(field.discrete_increment(&equation)?.less(half_force).into())
    }

    /// Δ + (h²/m)(∇̄Φ(q₋, q + Δ) − F) = h z, with the force F at the position now.
    #[inline(always)]
    fn solve_across(&self, (): &mut (), step: &Step<'_, Self>, before: &[R; D]) -> Result<Self::Found, NotConverged> {
        let Step { stride, t, q, v: z, .. } = *step;
        let g = stride.fall;
        let equation = Equation { a: *before, ..equation(step, stride.drift(z), g, [R::ZERO; D]) };
        let field = self.field(t);
        if !L::Field::<'_>::FORCED {
            return Ok(field.discrete_increment(&equation)?.into());
        }
        let force = scaled(R::from_f64(2.0), field.half_force(q.hi, z.hi));
        Ok(field.potential_increment(&Equation { frozen: scaled(-g, force), ..equation })?.less(force).into())
    }

    #[inline(always)]
    fn settle(
        &self,
        (): &mut (),
        stride: &Stride<R>,
        share: f64,
        found: &mut Self::Found,
        [q, v]: [&mut CompensatedVector<D, R>; 2],
    ) {
        if const { workless::<L, D, R>() } && share == 0.5 {
            return workless::settle(stride, found, q, v);
        }
        found.increment.delta = stride.kick_and_drift(R::from_f64(share), v, found.increment.parts);
        q.add(found.increment.delta);
    }

    #[inline(always)]
    fn settle_mean(
        &self,
        (): &mut (),
        stride: &Stride<R>,
        known: &[R; D],
        found: &mut Self::Found,
        [q, v]: [&mut CompensatedVector<D, R>; 2],
    ) {
        let half = R::from_f64(0.5);
        let change = scaled(-half * stride.kick, sum(*known, found.increment.gradient));
        for i in 0..D {
            found.increment.delta[i] = stride.dt * (v.hi[i] + half.mul_add(change[i], v.lo[i]));
        }
        v.add(change);
        q.add(found.increment.delta);
    }

    #[inline(always)]
    fn found<'a>((): &'a (), found: &'a Self::Found) -> &'a [R; D] {
        &found.increment.gradient
    }
    #[inline(always)]
    fn moved<'a>((): &'a (), found: &'a Self::Found) -> &'a [R; D] {
        &found.increment.delta
    }
    #[inline(always)]
    fn keep((): &mut (), found: &Self::Found, place: &mut [R; D]) {
        *place = found.increment.gradient;
    }
    #[inline(always)]
    fn effort(found: &Self::Found) -> Effort<R> {
        Effort { evaluations: found.increment.evaluations, iterations: found.increment.iterations }
    }
}
