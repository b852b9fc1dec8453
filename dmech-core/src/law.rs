//! What a scheme needs to know of a law.

use dmech_scalar::Real;

use crate::newton::{self, Equation, Increment, NotConverged};
use crate::system::vector::dot;
use crate::written::Written;

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
    /// The gradient, or its derivative, jumps somewhere: a contact, a cut-off, |x|. Implicit steps then trust no extrapolation of
    /// the force, which costs an evaluation in each.
    const PIECEWISE: bool = false;

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

    /// The method that a macro has made this of; a potential written by hand is its own.
    #[doc(hidden)]
    fn written(&self) -> Option<&dyn Written<D>> {
        None
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

/// The derivation of a law in readable mathematics, written by the macro.
pub trait Derivation {
    /// Potential, gradient, Hessian, discrete gradient, force, the structure that was found, and what the kernels cost.
    fn derivation(&self) -> &'static str;
}

/// Nothing but the potential acts: no `#[force]`, no time, no mass in the law.
///
/// A potential written by hand declares it with `impl Conservative for MyLaw {}` and is then a [`Law`].
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not known to be a conservative law",
    note = "a potential written by hand becomes a law with `impl Conservative for {Self} {{}}`"
)]
pub trait Conservative {}

/// The force does not depend on the velocity, so that positions and velocities may stand half a step apart
/// (Greenspan §3, last sentence).
#[diagnostic::on_unimplemented(
    message = "the force of `{Self}` depends on the velocity, and this scheme has no velocity where it needs the force",
    label = "this scheme cannot step a velocity-dependent force",
    note = "leap-frog, Kanatani's scheme, `Nystrom` and `ForceGradient` kick at a position, where they have no velocity of that time",
    note = "use `Implicit`, `DiscreteGradient` or `Explicit` for this law"
)]
pub trait VelocityIndependent {}

#[diagnostic::do_not_recommend]
impl<P: Conservative> VelocityIndependent for P {}

/// The law does not name the mass `m`, so that each coordinate may have a mass of its own
/// ([`Simulation::masses`](crate::Simulation::masses)).
#[diagnostic::on_unimplemented(
    message = "`{Self}` names the mass `m`, which is one number, and here each coordinate has its own",
    label = "this law has one mass",
    note = "give the masses that the law needs as fields of `{Self}`, or set one mass with `.mass(m)`"
)]
pub trait MassIndependent {}

#[diagnostic::do_not_recommend]
impl<P: Conservative> MassIndependent for P {}

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

    /// Solves Δ + g ∇̄Φ(a, q + Δ) = c with the potential alone.
    #[inline(always)]
    fn potential_increment(&self, equation: &Equation<D, R>) -> Result<Increment<D, R>, NotConverged> {
        self.discrete_increment(equation)
    }

    /// As [`Potential::discrete_increment`], and what the rounding of G has left out: called where the force does no work,
    /// when an error that is the same in each step would be the largest of the energy.
    #[inline(always)]
    fn workless_increment(&self, equation: &Equation<D, R>) -> Result<(Increment<D, R>, [R; D]), NotConverged> {
        Ok((self.discrete_increment(equation)?, [R::ZERO; D]))
    }
}

impl<const D: usize, R: Real, P: Potential<D, R> + Conservative> Field<D, R> for &P {}

/// A law that a simulation can run: at each moment, for each mass, it is a [`Field`].
///
/// Every [`Conservative`] potential is a law that is the same at all times and for all masses; a law with a force, or
/// one that names `t` or `m`, gives the field that acts then.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a law in {D} coordinates over `{R}`",
    note = "declare one with `#[dmech::law]` and a `#[potential]` or a `#[force]` of a position with {D} coordinates",
    note = "a potential written by hand (`impl Potential<{D}> for …`) also needs `impl Conservative for … {{}}`"
)]
pub trait Law<const D: usize, R: Real = f64> {
    /// What acts at one moment.
    type Field<'a>: Field<D, R>
    where
        Self: 'a;

    /// The law does not name the time.
    const AUTONOMOUS: bool = true;

    /// What acts on a particle of mass `mass` at time `t`.
    fn field(&self, mass: R, t: R) -> Self::Field<'_>;

    /// The mass of each coordinate over that of the particle: 1, except in [`Masses`](crate::Masses).
    #[inline(always)]
    fn mass_ratios(&self) -> [f64; D] {
        [1.0; D]
    }

    /// The methods that a macro has made this of; a law written by hand is its own.
    #[doc(hidden)]
    fn written(&self) -> Option<&dyn Written<D>> {
        None
    }
}

#[diagnostic::do_not_recommend]
impl<const D: usize, R: Real, P: Potential<D, R> + Conservative> Law<D, R> for P {
    type Field<'a>
        = &'a P
    where
        P: 'a;

    #[inline(always)]
    fn field(&self, _mass: R, _t: R) -> &P {
        self
    }

    fn written(&self) -> Option<&dyn Written<D>> {
        Potential::written(self)
    }
}

impl<const D: usize, R: Real, P: Potential<D, R>> Potential<D, R> for &P {
    const CENTRAL: bool = P::CENTRAL;
    const LINEAR: bool = P::LINEAR;
    const PIECEWISE: bool = P::PIECEWISE;

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
    fn gradient_kick(&self, c: R, e: R, q: [R; D], v: [R; D]) -> [R; D] {
        (**self).gradient_kick(c, e, q, v)
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
