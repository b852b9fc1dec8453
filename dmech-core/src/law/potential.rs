//! What is declared: a potential, a force.

use dmech_scalar::Real;

/// A potential energy Φ(q) in D coordinates: its values, its derivatives, and its secants.
///
/// `#[dmech::law]` and `#[derive(dmech::Law)]` implement it for every scalar [`Real`]; by hand it is enough to
/// implement it for the scalar in use (`impl Potential<2> for MyLaw` is for `f64`), and only the required methods.
///
/// # Shapes and units
/// Positions are arrays `[R; D]` in any consistent unit; `jac[i][j]` = ∂(component i)/∂(coordinate j).
pub trait Potential<const D: usize, R: Real = f64> {
    /// −∇Φ is along q: Φ depends on |q| alone, and the angular momentum about the origin is kept. (Of two bodies that is said of the
    /// potential; a force beside it may have any direction.)
    const CENTRAL: bool = false;
    /// The Hessian does not depend on q: the implicit steps are linear and need no iteration.
    const LINEAR: bool = false;
    /// The gradient, or its derivative, jumps somewhere: a contact, a cut-off, |x|. Implicit steps then trust no extrapolation of
    /// the force, which costs an evaluation in each.
    const PIECEWISE: bool = false;
    /// Φ is a polynomial of at most this degree in q, at any time: None if it is not one, if a force acts beside it, or if nobody
    /// has said so. The macro reads it from the formula, whatever the values of its parameters are.
    const DEGREE: Option<u32> = None;

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
}

impl<const D: usize, R: Real, P: Potential<D, R>> Potential<D, R> for &P {
    const CENTRAL: bool = P::CENTRAL;
    const LINEAR: bool = P::LINEAR;
    const PIECEWISE: bool = P::PIECEWISE;
    const DEGREE: Option<u32> = P::DEGREE;

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
}

/// A force in D coordinates, F(q, v, t): the whole of a law, or what acts beside its potential.
///
/// `#[dmech::law]` implements it for a law with a `#[force]` and every scalar. `jac[i][j]` = ∂Fᵢ/∂(coordinate j).
pub trait Force<const D: usize, R: Real = f64> {
    /// F(q, v, t).
    fn force(&self, q: [R; D], v: [R; D], t: R) -> [R; D];
    /// ∂F/∂q.
    fn force_dq(&self, q: [R; D], v: [R; D], t: R) -> [[R; D]; D];
    /// ∂F/∂v.
    fn force_dv(&self, q: [R; D], v: [R; D], t: R) -> [[R; D]; D];
}
