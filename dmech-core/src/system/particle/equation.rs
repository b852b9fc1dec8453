//! The equation of an implicit step of a particle, and its solution.

use crate::vector::by_component;
use dmech_scalar::Real;

use super::Particle;
use crate::law::{Law, Potential};
use crate::newton::{Equation, Increment};
use crate::system::{Ahead, Step};

/// The solution of an implicit step.
#[derive(Clone, Copy, Debug)]
pub struct ParticleFound<const D: usize, R: Real> {
    pub(super) increment: Increment<D, R>,
    /// Where the force does no work: what the rounding of the increment and of the slope left out.
    pub(super) left: [[R; D]; 2],
}

impl<const D: usize, R: Real> From<Increment<D, R>> for ParticleFound<D, R> {
    #[inline(always)]
    fn from(increment: Increment<D, R>) -> Self {
        ParticleFound { increment, left: [[R::ZERO; D]; 2] }
    }
}

/// The slope that is expected.
#[inline(always)]
fn expected<const D: usize, R: Real>(ahead: Ahead<'_, [R; D]>) -> [R; D] {
    match ahead {
        Ahead::Continued([last, before, earlier]) => {
            by_component!(|i| R::from_f64(3.0).mul_add(last[i] - before[i], earlier[i]))
        }
        Ahead::Expected(expected) => *expected,
    }
}

/// Δ + g (G + …) = drift − frozen from the position now, with the guess h v − frozen − g S that the expected slope S makes.
#[inline(always)]
pub(super) fn equation<L: Law<D, R>, const D: usize, R: Real>(
    step: &Step<'_, Particle<L, D, R>>,
    drift: [R; D],
    g: R,
    frozen: [R; D],
) -> Equation<D, R> {
    let Step { stride, q, v, newton, .. } = *step;
    Equation {
        frozen,
        guess: newton.guess((stride.dt, v.hi), frozen, g, expected(step.ahead)),
        max_iterations: newton.limit(),
        piecewise: <L::Field<'_> as Potential<D, R>>::PIECEWISE,
        ..Equation::new(q.hi, drift, g)
    }
}
