//! The energy-exact step where the force does no work.
//!
//! Nothing but rounding changes the energy then, and in a field that is the same everywhere the rounding of one step is
//! that of the next. What each operation on the way from the velocity to the next one leaves out is therefore carried on.

use dmech_scalar::{CompensatedVector, Real, two_sum};

use super::equation::{ParticleFound, equation};
use super::{Particle, Stride};
use crate::law::{Field, Law};
use crate::newton::{Equation, NotConverged};
use crate::system::Step;
use crate::vector::by_component;

/// The increment of one step, with the field of the mid-time.
#[inline(always)]
pub(super) fn solve<L: Law<D, R>, const D: usize, R: Real>(
    field: &L::Field<'_>,
    step: &Step<'_, Particle<L, D, R>>,
) -> Result<ParticleFound<D, R>, NotConverged> {
    let Step { stride, t, v, .. } = *step;
    let g = R::from_f64(0.5) * stride.fall;
    let (drift, left) = stride.drift_and_rest(v);
    let equation = Equation {
        frozen: left.map(|x| -x),
        v: v.hi,
        rate: stride.rate,
        t_end: t + stride.dt,
        ..equation(step, drift, g, [R::ZERO; D])
    };
    let increment = field.workless_increment(&equation)?;
    let [slope, turned] = increment.parts;
    let rest = by_component!(|i| two_sum(slope[i], turned[i]).1);
    let left = equation.residual(increment.delta, increment.gradient);
    Ok(ParticleFound { increment, left: [by_component!(|i| (-g).mul_add(rest[i], left[i])), rest] })
}

/// Moves q and v, with all that was left out.
#[inline(always)]
pub(super) fn settle<const D: usize, R: Real>(
    stride: &Stride<R>,
    found: &ParticleFound<D, R>,
    q: &mut CompensatedVector<D, R>,
    v: &mut CompensatedVector<D, R>,
) {
    let ParticleFound { increment, left: [left, rest] } = found;
    q.add(increment.delta);
    q.add(*left);
    stride.kick_compensated(v, increment.gradient);
    for i in 0..D {
        let rounded = stride.kick.product(increment.gradient[i]).1;
        v.lo[i] -= stride.kick.mul_add(rest[i], rounded);
    }
}
