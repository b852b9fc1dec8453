//! What schemes ask of what acts.

use dmech_scalar::Real;

use super::{Conservative, Potential, differences, rotation};
use crate::look::{Course, Frequency, Stiffness};
use crate::newton::{self, Equation, Increment, NotConverged};
use crate::vector::{by_component, by_entry, dot, scaled};

/// What acts on a particle at one moment: a potential, and with it perhaps a force.
///
/// Written by the macro; a conservative potential is its own field. By hand, beside a [`FORCED`](Field::FORCED) that is true,
/// [`force`](Field::force) is enough: all else is made of it, the Jacobians by differences.
pub trait Field<const D: usize, R: Real = f64>: Potential<D, R> {
    /// A force acts beside the potential.
    const FORCED: bool = false;
    /// The energy m v²/2 + Φ is kept: there is no force, or it does no work at any velocity, as v × B.
    const CONSERVES_ENERGY: bool = true;

    /// ∇Φ(q) − F(q, v): minus all that acts.
    #[inline(always)]
    fn slope(&self, q: [R; D], v: [R; D]) -> [R; D] {
        let slope = self.gradient(q);
        if !Self::FORCED {
            return slope;
        }
        let force = self.force(q, v, self.time());
        by_component!(|i| slope[i] - force[i])
    }

    /// The share of the force at the start of a step in the mean that the energy-exact step takes: F(q, v)/2. Nothing
    /// where the force is taken in the middle of the step because it does no work.
    #[inline(always)]
    fn half_force(&self, q: [R; D], v: [R; D]) -> [R; D] {
        if !Self::FORCED || Self::CONSERVES_ENERGY {
            return [R::ZERO; D];
        }
        scaled(R::from_f64(0.5), self.force(q, v, self.time()))
    }

    /// F(q, v, t); zero where there is no force beside the potential. The time is that of the force, as the energy-exact
    /// step takes the potential and the force at different times.
    #[inline(always)]
    fn force(&self, _q: [R; D], _v: [R; D], _t: R) -> [R; D] {
        [R::ZERO; D]
    }

    /// ∂F/∂q; by differences, which cost the digits of [`ForceGradient`](crate::ForceGradient), unless it is written.
    #[inline(always)]
    fn force_dq(&self, q: [R; D], v: [R; D], t: R) -> [[R; D]; D] {
        if !Self::FORCED {
            return [[R::ZERO; D]; D];
        }
        differences::jacobian(q, |q| self.force(q, v, t))
    }

    /// ∂F/∂v; by differences, which cost the digits of [`Boris`](crate::Boris), unless it is written.
    #[inline(always)]
    fn force_dv(&self, q: [R; D], v: [R; D], t: R) -> [[R; D]; D] {
        if !Self::FORCED {
            return [[R::ZERO; D]; D];
        }
        differences::jacobian(v, |v| self.force(q, v, t))
    }

    /// The time at which this acts: a field by hand whose force names it says so.
    #[inline(always)]
    fn time(&self) -> R {
        R::ZERO
    }

    /// v − c (∇Φ − F), with the one coefficient c = h/m folded into the force.
    fn kick(&self, c: R, q: [R; D], v: [R; D]) -> [R; D] {
        let slope = self.slope(q, v);
        by_component!(|i| v[i] - c * slope[i])
    }

    /// v′ = v − c (∇Φ − F(q, (v + v′)/2)), where the force is linear in the velocity: with f = F(q, 0) and S = ∂F/∂v
    ///
    /// ```text
    /// v′ = v + c (1 − c S/2)⁻¹(f − ∇Φ + S v)
    /// ```
    fn kick_by_mean(&self, c: R, q: [R; D], v: [R; D]) -> [R; D] {
        if !Self::FORCED {
            return self.kick(c, q, v);
        }
        let slope = self.slope(q, [R::ZERO; D]);
        rotation::kick_by_mean(c, by_component!(|i| -slope[i]), self.force_dv(q, v, self.time()), v)
    }

    /// v − c ∇Φ(q) + e H ∇Φ(q), with H ∇Φ = ∇(|∇Φ|²)/2: the kick of force-gradient schemes, e in units of h³/m².
    ///
    /// Asked for only where the force does not depend on the velocity.
    fn gradient_kick(&self, c: R, e: R, q: [R; D], v: [R; D]) -> [R; D] {
        let slope = self.slope(q, v);
        let mut jacobian = self.hessian(q);
        if Self::FORCED {
            let force = self.force_dq(q, v, self.time());
            jacobian = by_entry!(|i, j| jacobian[i][j] - force[i][j]);
        }
        by_component!(|i| e.mul_add(dot(jacobian[i], slope), v[i] - c * slope[i]))
    }

    /// Solves Δ + g ∇Φ(q + Δ) = c for the increment Δ: the trapezoidal step (Greenspan (2.1)–(2.5)).
    fn implicit_increment(&self, equation: &Equation<D, R>) -> Result<Increment<D, R>, NotConverged> {
        if Self::FORCED {
            return newton::dense_forced(equation, |equation, _, b, v| self.end_slope(b, v, equation.t_end));
        }
        let force = |b| (self.gradient(b), self.hessian(b));
        if Self::LINEAR { newton::linear(equation, force) } else { newton::dense(equation, force) }
    }

    /// Solves Δ + g ∇̄Φ(a, q + Δ) = c for the increment Δ: the energy-exact steps.
    fn discrete_increment(&self, equation: &Equation<D, R>) -> Result<Increment<D, R>, NotConverged> {
        if !Self::FORCED {
            return self.potential_increment(equation);
        }
        if Self::CONSERVES_ENERGY {
            return self.workless_increment(equation);
        }
        newton::dense_forced(equation, |equation, _, b, v| self.secant_slope(equation.a, b, v, equation.t_end))
    }

    /// Solves Δ + g ∇̄Φ(a, q + Δ) = c with the potential alone.
    #[inline(always)]
    fn potential_increment(&self, equation: &Equation<D, R>) -> Result<Increment<D, R>, NotConverged> {
        let force = |a, b| secant(self, a, b);
        if Self::LINEAR { newton::linear_discrete(equation, force) } else { newton::dense_discrete(equation, force) }
    }

    /// As [`discrete_increment`](Field::discrete_increment), where the force does no work and an error that is the same in each step would be
    /// the largest of the energy: the increment is rounded once, and [its parts](Increment::parts) tell what the rounding of G leaves out.
    #[inline(always)]
    fn workless_increment(&self, equation: &Equation<D, R>) -> Result<Increment<D, R>, NotConverged> {
        if !Self::FORCED {
            let found = self.discrete_increment(equation)?;
            return Ok(Increment { parts: [found.gradient, [R::ZERO; D]], ..found });
        }
        newton::dense_middle(equation, |equation, delta, b| {
            // The mean velocity is along Δ: by way of v′ the rounding of 2/h would be a force that works.
            let mean = delta.map(|x| R::from_f64(0.5) * equation.rate * x);
            self.middle_slope([equation.a, b], mean, equation.t_end - equation.rate.recip())
        })
    }

    /// ω of the linearised motion along a course that begins at t, of what acts at times from then, if anything does, and how it
    /// grows.
    #[doc(hidden)]
    #[inline(always)]
    fn frequency(from_now: impl Fn(R) -> Option<Self>, mass: R, t: R, course: Course<D, R>) -> Frequency<R>
    where
        Self: Sized,
    {
        let of = |s, q, v| from_now(s).map_or(Stiffness::NONE, |field| Stiffness::of(&field, mass, t + s, q, v));
        Frequency::of(course, of)
    }

    /// ∇Φ − F at the end of a step.
    #[doc(hidden)]
    fn end_slope(&self, b: [R; D], v: [R; D], t: R) -> Linearised<D, R> {
        less((self.gradient(b), self.hessian(b)), R::ONE, force(self, b, v, t))
    }

    /// ∇̄Φ(a, b) − F/2, with the share of the end of a step in the mean force.
    #[doc(hidden)]
    fn secant_slope(&self, a: [R; D], b: [R; D], v: [R; D], t: R) -> Linearised<D, R> {
        less(secant(self, a, b), R::from_f64(0.5), force(self, b, v, t))
    }

    /// ∇̄Φ(a, b) − F in the middle, where a force that does no work does none in the step; half of each mean is the end.
    #[doc(hidden)]
    fn middle_slope(&self, [a, b]: [[R; D]; 2], mean: [R; D], t: R) -> Linearised<D, R> {
        let half = R::from_f64(0.5);
        let (f, f_dq, f_dv) = force(self, by_component!(|i| half * (a[i] + b[i])), mean, t);
        let halved = |x: [[R; D]; D]| by_entry!(|i, j| half * x[i][j]);
        less(secant(self, a, b), R::ONE, (f, halved(f_dq), halved(f_dv)))
    }
}

/// F and its two Jacobians.
#[inline(always)]
fn force<F: Field<D, R> + ?Sized, const D: usize, R: Real>(f: &F, q: [R; D], v: [R; D], t: R) -> Linearised<D, R> {
    (f.force(q, v, t), f.force_dq(q, v, t), f.force_dv(q, v, t))
}

/// ∇̄Φ(a, b) and its Jacobian.
#[inline(always)]
fn secant<F: Field<D, R> + ?Sized, const D: usize, R: Real>(f: &F, a: [R; D], b: [R; D]) -> ([R; D], [[R; D]; D]) {
    (f.discrete_gradient(a, b), f.discrete_gradient_jacobian(a, b))
}

/// A force and its Jacobians with respect to position and velocity.
pub(super) type Linearised<const D: usize, R> = ([R; D], [[R; D]; D], [[R; D]; D]);

/// G − c F and its Jacobians, with G and its Jacobian and F and its two.
#[inline(always)]
fn less<const D: usize, R: Real>(
    (g, g_dq): ([R; D], [[R; D]; D]),
    c: R,
    (f, f_dq, f_dv): Linearised<D, R>,
) -> Linearised<D, R> {
    let by_position = by_entry!(|i, j| (-c).mul_add(f_dq[i][j], g_dq[i][j]));
    (by_component!(|i| (-c).mul_add(f[i], g[i])), by_position, by_entry!(|i, j| -c * f_dv[i][j]))
}

impl<const D: usize, R: Real, P: Potential<D, R> + Conservative> Field<D, R> for &P {}
