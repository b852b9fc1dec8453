//! What schemes ask of what acts.

use dmech_scalar::Real;

use super::{Conservative, Potential};
use crate::newton::{self, Equation, Increment, NotConverged};
use crate::vector::dot;

/// What acts on a particle at one moment: a potential, and with it perhaps a force.
///
/// Written by the macro; a conservative potential is its own field.
pub trait Field<const D: usize, R: Real = f64>: Potential<D, R> {
    /// A force acts beside the potential.
    const FORCED: bool = false;
    /// The energy m v²/2 + Φ is kept: there is no force, or it does no work at any velocity, as v × B.
    const CONSERVES_ENERGY: bool = true;

    /// ∇Φ(q) − F(q, v): minus all that acts.
    #[inline(always)]
    fn slope(&self, q: [R; D], _v: [R; D]) -> [R; D] {
        self.gradient(q)
    }

    /// The share of the force at the start of a step in the mean that the energy-exact step takes: F(q, v)/2. Nothing
    /// where the force is taken in the middle of the step because it does no work.
    #[inline(always)]
    fn half_force(&self, _q: [R; D], _v: [R; D]) -> [R; D] {
        [R::ZERO; D]
    }

    /// F(q, v, t); zero where there is no force beside the potential. The time is that of the force, as the energy-exact
    /// step takes the potential and the force at different times.
    #[inline(always)]
    fn force(&self, _q: [R; D], _v: [R; D], _t: R) -> [R; D] {
        [R::ZERO; D]
    }

    /// ∂F/∂q.
    #[inline(always)]
    fn force_dq(&self, _q: [R; D], _v: [R; D], _t: R) -> [[R; D]; D] {
        [[R::ZERO; D]; D]
    }

    /// ∂F/∂v.
    #[inline(always)]
    fn force_dv(&self, _q: [R; D], _v: [R; D], _t: R) -> [[R; D]; D] {
        [[R::ZERO; D]; D]
    }

    /// v − c (∇Φ − F), with the one coefficient c = h/m folded into the force.
    fn kick(&self, c: R, q: [R; D], v: [R; D]) -> [R; D] {
        let slope = self.slope(q, v);
        core::array::from_fn(|i| v[i] - c * slope[i])
    }

    /// v − c ∇Φ(q) + e H ∇Φ(q), with H ∇Φ = ∇(|∇Φ|²)/2: the kick of force-gradient schemes, e in units of h³/m².
    ///
    /// Asked for only where the force does not depend on the velocity.
    fn gradient_kick(&self, c: R, e: R, q: [R; D], v: [R; D]) -> [R; D] {
        let (gradient, hessian) = (self.gradient(q), self.hessian(q));
        core::array::from_fn(|i| e.mul_add(dot(hessian[i], gradient), v[i] - c * gradient[i]))
    }

    /// Solves Δ + g ∇Φ(q + Δ) = c for the increment Δ: the trapezoidal step (Greenspan (2.1)–(2.5)).
    fn implicit_increment(&self, equation: &Equation<D, R>) -> Result<Increment<D, R>, NotConverged> {
        let force = |b| (self.gradient(b), self.hessian(b));
        if Self::LINEAR { newton::linear(equation, force) } else { newton::dense(equation, force) }
    }

    /// Solves Δ + g ∇̄Φ(a, q + Δ) = c for the increment Δ: the energy-exact steps.
    fn discrete_increment(&self, equation: &Equation<D, R>) -> Result<Increment<D, R>, NotConverged> {
        newton::dense_discrete(equation, |a, b| (self.discrete_gradient(a, b), self.discrete_gradient_jacobian(a, b)))
    }

    /// Solves Δ + g ∇̄Φ(a, q + Δ) = c with the potential alone.
    #[inline(always)]
    fn potential_increment(&self, equation: &Equation<D, R>) -> Result<Increment<D, R>, NotConverged> {
        self.discrete_increment(equation)
    }

    /// As [`discrete_increment`](Field::discrete_increment), and what the rounding of G has left out: called where the force does no work,
    /// when an error that is the same in each step would be the largest of the energy.
    #[inline(always)]
    fn workless_increment(&self, equation: &Equation<D, R>) -> Result<(Increment<D, R>, [R; D]), NotConverged> {
        Ok((self.discrete_increment(equation)?, [R::ZERO; D]))
    }
}

impl<const D: usize, R: Real, P: Potential<D, R> + Conservative> Field<D, R> for &P {}
