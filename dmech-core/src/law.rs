//! What a scheme needs to know of a law.

use dmech_scalar::Real;

use crate::newton::{self, Equation, Increment, NotConverged};

/// A potential energy Φ(q) in D coordinates, with everything that the schemes ask of it.
///
/// `#[dmech::law]` and `#[derive(dmech::Law)]` implement it for every scalar [`Real`]; by hand it is enough to
/// implement it for the scalar in use (`impl Potential<2> for MyLaw` is for `f64`), and only the required methods.
///
/// # Shapes and units
/// Positions are arrays `[R; D]` in any consistent unit; `jac[i][j]` = ∂(component i)/∂(coordinate j).
pub trait Potential<const D: usize, R: Real = f64> {
    /// The force is along q: Φ depends on |q| alone, and the angular momentum about the origin is kept.
    const CENTRAL: bool = false;
    /// The Hessian does not depend on q: the implicit steps are linear and need no iteration.
    const LINEAR: bool = false;

    /// Φ(q).
    fn potential(&self, q: [R; D]) -> R;
    /// ∇Φ(q).
    fn gradient(&self, q: [R; D]) -> [R; D];
    /// ∂²Φ/∂qᵢ∂qⱼ at q.
    fn hessian(&self, q: [R; D]) -> [[R; D]; D];
    /// ∇̄Φ(a, b), with ∇̄Φ(a, b)·(b − a) = Φ(b) − Φ(a), ∇̄Φ(a, b) = ∇̄Φ(b, a) and ∇̄Φ(a, a) = ∇Φ(a)
    /// (Kanatani (3.7); LaBudde–Greenspan).
    fn discrete_gradient(&self, a: [R; D], b: [R; D]) -> [R; D];
    /// ∂∇̄Φ(a, b)ᵢ/∂bⱼ. Not symmetric in i and j.
    fn discrete_gradient_jacobian(&self, a: [R; D], b: [R; D]) -> [[R; D]; D];

    /// v − c ∇Φ(q), with the one coefficient c = h/m folded into the force.
    fn kick(&self, c: R, q: [R; D], v: [R; D]) -> [R; D] {
        let gradient = self.gradient(q);
        core::array::from_fn(|i| v[i] - c * gradient[i])
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
}

/// A law that a simulation can run: at each moment, for each mass, it is a [`Potential`].
///
/// Every potential is a law that is the same at all times and for all masses; a law that names `t` or `m` gives
/// the potential that holds then.
pub trait Law<const D: usize, R: Real = f64> {
    /// The potential at one moment.
    type Field<'a>: Potential<D, R>
    where
        Self: 'a;

    /// The law does not name the time: the energy is kept.
    const AUTONOMOUS: bool = true;

    /// The potential for a particle of mass `mass` at time `t`.
    fn field(&self, mass: R, t: R) -> Self::Field<'_>;
}

impl<const D: usize, R: Real, P: Potential<D, R>> Law<D, R> for P {
    type Field<'a>
        = &'a P
    where
        P: 'a;

    #[inline(always)]
    fn field(&self, _mass: R, _t: R) -> &P {
        self
    }
}

impl<const D: usize, R: Real, P: Potential<D, R>> Potential<D, R> for &P {
    const CENTRAL: bool = P::CENTRAL;
    const LINEAR: bool = P::LINEAR;

    #[inline(always)]
    fn potential(&self, q: [R; D]) -> R {
        (**self).potential(q)
    }
    #[inline(always)]
    fn gradient(&self, q: [R; D]) -> [R; D] {
        (**self).gradient(q)
    }
    #[inline(always)]
    fn hessian(&self, q: [R; D]) -> [[R; D]; D] {
        (**self).hessian(q)
    }
    #[inline(always)]
    fn discrete_gradient(&self, a: [R; D], b: [R; D]) -> [R; D] {
        (**self).discrete_gradient(a, b)
    }
    #[inline(always)]
    fn discrete_gradient_jacobian(&self, a: [R; D], b: [R; D]) -> [[R; D]; D] {
        (**self).discrete_gradient_jacobian(a, b)
    }
    #[inline(always)]
    fn kick(&self, c: R, q: [R; D], v: [R; D]) -> [R; D] {
        (**self).kick(c, q, v)
    }
    #[inline(always)]
    fn implicit_increment(&self, equation: &Equation<D, R>) -> Result<Increment<D, R>, NotConverged> {
        (**self).implicit_increment(equation)
    }
    #[inline(always)]
    fn discrete_increment(&self, equation: &Equation<D, R>) -> Result<Increment<D, R>, NotConverged> {
        (**self).discrete_increment(equation)
    }
}
