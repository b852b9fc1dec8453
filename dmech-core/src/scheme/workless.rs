//! The energy-exact step where the force does no work.
//!
//! Nothing but rounding changes the energy then, and in a field that is the same everywhere the rounding of one step is
//! that of the next. What each operation on the way from the velocity to the next one leaves out is therefore carried on.

use dmech_scalar::{CompensatedVector, Real};

use super::{Newton, Stride, exact_product};
use crate::law::{Field, Law, Potential};
use crate::newton::{Equation, Increment, NotConverged};

/// Moves q and v by one step.
#[inline(always)]
pub(super) fn step<L: Law<D, R>, const D: usize, R: Real>(
    law: &L,
    stride: &Stride<R>,
    t: R,
    q: &mut CompensatedVector<D, R>,
    v: &mut CompensatedVector<D, R>,
    expected: [R; D],
    newton: &Newton,
) -> Result<Increment<D, R>, NotConverged> {
    let half = R::from_f64(0.5);
    let g = half * stride.fall;
    let start = q.value();
    let (drift, left) = stride.drift_and_rest(v);
    let equation = Equation {
        frozen: left.map(|x| -x),
        v: v.hi,
        rate: stride.rate,
        t_end: t + stride.dt,
        guess: newton.guess((stride.dt, v.hi), [R::ZERO; D], g, expected),
        max_iterations: newton.limit(),
        piecewise: <L::Field<'_> as Potential<D, R>>::PIECEWISE,
        ..Equation::new(start, drift, g)
    };
    let field = law.field(stride.mass, half.mul_add(stride.dt, t));
    let (found, rest) = field.workless_increment(&equation)?;
    let left = equation.residual(found.delta, found.gradient);
    q.add(found.delta);
    q.add(core::array::from_fn(|i| (-g).mul_add(rest[i], left[i])));
    stride.kick_compensated(v, found.gradient);
    for i in 0..D {
        let rounded = exact_product(stride.kick, found.gradient[i]).1;
        v.lo[i] -= stride.kick.mul_add(rest[i], rounded);
    }
    Ok(found)
}
