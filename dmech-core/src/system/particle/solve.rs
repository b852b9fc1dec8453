//! The implicit instructions of a particle: one equation of D unknowns, solved by code made for the law.

use dmech_scalar::{CompensatedVector, Real};

use super::equation::{ParticleFound, equation};
use super::{Particle, Stride, workless};
use crate::law::{Field, Law};
use crate::newton::{Equation, NotConverged};
use crate::system::Step;
use crate::vector::scaled;

/// The force beside the potential does no work: it is taken in the middle of the step.
const fn workless<L: Law<D, R>, const D: usize, R: Real>() -> bool {
    <L::Field<'_> as Field<D, R>>::FORCED && <L::Field<'_> as Field<D, R>>::CONSERVES_ENERGY
}

/// Δ + (h²/4m)(S(q + Δ) + S) = h v.
#[inline(always)]
pub(super) fn mean<L: Law<D, R>, const D: usize, R: Real>(
    particle: &Particle<L, D, R>,
    step: &Step<'_, Particle<L, D, R>>,
    known: [R; D],
) -> Result<ParticleFound<D, R>, NotConverged> {
    let Step { stride, v, .. } = *step;
    let g = R::from_f64(0.25) * stride.fall;
    let t_end = step.t + stride.dt;
    let mut equation = equation(step, stride.drift(v), g, scaled(g, known));
    if <L::Field<'_> as Field<D, R>>::FORCED {
        equation = Equation { v: v.hi, rate: stride.rate, t_end, ..equation };
    }
    Ok(particle.field(t_end).implicit_increment(&equation)?.into())
}

/// Δ + (h²/2m)(∇̄Φ(q, q + Δ) − (F + F′)/2) = h v, with ∇̄Φ of the mid-time.
#[inline(always)]
pub(super) fn exact<L: Law<D, R>, const D: usize, R: Real>(
    particle: &Particle<L, D, R>,
    step: &Step<'_, Particle<L, D, R>>,
) -> Result<ParticleFound<D, R>, NotConverged> {
    let Step { stride, t, q, v, .. } = *step;
    let half = R::from_f64(0.5);
    let field = particle.field(half.mul_add(stride.dt, t));
    if const { workless::<L, D, R>() } {
        return workless::solve(&field, step);
    }
    let g = half * stride.fall;
    let equation = equation(step, stride.drift(v), g, [R::ZERO; D]);
    if !<L::Field<'_> as Field<D, R>>::FORCED {
        return Ok(field.discrete_increment(&equation)?.into());
    }
    // The unknown side has the force at the end; that at the start is known.
    let half_force = particle.field(t).half_force(q.hi, v.hi);
    let (frozen, t_end) = (scaled(-g, half_force), t + stride.dt);
    let equation = Equation { frozen, v: v.hi, rate: stride.rate, t_end, ..equation };
    Ok(field.discrete_increment(&equation)?.less(half_force).into())
}

/// Δ + (h²/m)(∇̄Φ(q₋, q + Δ) − F) = h z, with the force F at the position now.
#[inline(always)]
pub(super) fn across<L: Law<D, R>, const D: usize, R: Real>(
    particle: &Particle<L, D, R>,
    step: &Step<'_, Particle<L, D, R>>,
    before: [R; D],
) -> Result<ParticleFound<D, R>, NotConverged> {
    let Step { stride, t, q, v: z, .. } = *step;
    let g = stride.fall;
    let equation = Equation { a: before, ..equation(step, stride.drift(z), g, [R::ZERO; D]) };
    let field = particle.field(t);
    if !<L::Field<'_> as Field<D, R>>::FORCED {
        return Ok(field.discrete_increment(&equation)?.into());
    }
    let force = scaled(R::from_f64(2.0), field.half_force(q.hi, z.hi));
    Ok(field.potential_increment(&Equation { frozen: scaled(-g, force), ..equation })?.less(force).into())
}

/// Moves q and v by what was found.
#[inline(always)]
pub(super) fn settle<L: Law<D, R>, const D: usize, R: Real>(
    stride: &Stride<R>,
    share: f64,
    found: &mut ParticleFound<D, R>,
    [q, v]: [&mut CompensatedVector<D, R>; 2],
) {
    if const { workless::<L, D, R>() } && share == 0.5 {
        return workless::settle(stride, found, q, v);
    }
    found.increment.delta = stride.kick_and_drift(R::from_f64(share), v, found.increment.parts);
    q.add(found.increment.delta);
}
