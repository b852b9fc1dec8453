//! The one equation that all implicit steps share.

use dmech_scalar::{Count, Mask, Real, two_sum};

use super::settle::length;
use crate::vector::{by_component, difference, either};

/// Find Δ with  Δ + g G(q + Δ) = drift − frozen,  where G(b) is ∇Φ(b) (trapezoid) or ∇̄Φ(a, b) (energy-exact steps).
///
/// | scheme | a | drift | frozen | g |
/// |---|---|---|---|---|
/// | `Implicit` | – | h v | g ∇Φ(q) | h²/4m |
/// | `DiscreteGradient` | q | h v | 0 | h²/2m |
/// | the same, where a force does no work | q | h v | − what rounding keeps from h v | h²/2m |
/// | `Kanatani` | q₋ | h z = q − q₋ | 0 | h²/m |
///
/// The parts are kept apart because they shrink differently with the step: for a step of θh the drift is θ times as
/// large, `frozen` and `g` θ² times, and a = q + θ (a − q). Where several roots exist the wanted one is that which is
/// continuous with θ → 0.
#[derive(Clone, Copy, Debug)]
pub struct Equation<const D: usize, R: Real> {
    /// The position that the increment is added to.
    pub q: [R; D],
    /// The fixed end of the discrete gradient.
    pub a: [R; D],
    /// The part of the right-hand side that grows with h.
    pub drift: [R; D],
    /// The part of the right-hand side that grows with h², subtracted.
    pub frozen: [R; D],
    /// The coefficient of the unknown force, growing with h².
    pub g: R,
    /// The velocity at the start of the step; forces may depend on that at its end, v + rate (Δ − drift). This and the
    /// next two are 0 where the law has no force: then a step does not pay for them.
    pub v: [R; D],
    /// 2/h.
    pub rate: R,
    /// The time at the end of the step.
    pub t_end: R,
    /// Where to start.
    pub guess: [R; D],
    /// How many iterations are allowed.
    pub max_iterations: u32,
    /// The force may bend or jump between two iterates: [`Potential::PIECEWISE`](crate::Potential::PIECEWISE).
    pub piecewise: bool,
    /// Only a root at which 1 + g J is [definite](Correction::definite) is one: not any that its determinant lets pass.
    pub definite: bool,
}

impl<const D: usize, R: Real> Equation<D, R> {
    /// Δ + g G(q + Δ) = drift, from the guess Δ = drift; other parts are set by `Equation { …, ..Equation::new(…) }`.
    pub fn new(q: [R; D], drift: [R; D], g: R) -> Self {
        let zero = [R::ZERO; D];
        Equation {
            q,
            a: q,
            drift,
            frozen: zero,
            g,
            v: zero,
            rate: R::ZERO,
            t_end: R::ZERO,
            guess: drift,
            max_iterations: 500,
            piecewise: false,
            definite: false,
        }
    }

    /// The known side, drift − frozen.
    #[inline]
    pub fn known(&self) -> [R; D] {
        by_component!(|i| self.drift[i] - self.frozen[i])
    }

    /// |drift| + 2 |frozen|: how far the known side may go.
    #[inline(always)]
    pub(super) fn reach(&self) -> R {
        length(&self.drift) + length(&self.frozen) + length(&self.frozen)
    }

    /// drift − frozen − g G: the increment that belongs to a force G.
    ///
    /// Formed this way, and not as a difference of positions, it has the relative precision of the force, and the
    /// velocity that is updated with the same G agrees with it.
    #[inline]
    pub fn increment(&self, gradient: [R; D]) -> [R; D] {
        by_component!(|i| (-self.g).mul_add(gradient[i], self.drift[i] - self.frozen[i]))
    }

    /// As [`Equation::increment`], rounded once, as fused multiply-adds do it, on targets without them too; and what that
    /// rounding leaves out.
    ///
    /// The product g G alone, rounded, is off by a hundredth of an ulp in the mean, always in the same sense for the same
    /// g, which is work in one sense at every step (10⁻¹² in 10⁶ steps of a tenth of a radian).
    #[inline(always)]
    pub(super) fn increment_and_rest(&self, gradient: [R; D]) -> ([R; D], [R; D]) {
        let (mut delta, mut left) = ([R::ZERO; D], [R::ZERO; D]);
        for i in 0..D {
            let (pull, rest) = self.g.product(gradient[i]);
            let (high, low) = two_sum(self.drift[i], -pull);
            (delta[i], left[i]) = two_sum(high, low - rest - self.frozen[i]);
        }
        (delta, left)
    }

    /// drift − frozen − g G − Δ, including what rounding keeps from Δ.
    #[inline(always)]
    pub fn residual(&self, delta: [R; D], gradient: [R; D]) -> [R; D] {
        let (wanted, left) = self.increment_and_rest(gradient);
        by_component!(|i| (wanted[i] - delta[i]) + left[i])
    }

    /// The same as it is rounded.
    #[inline]
    pub(super) fn rest(&self, delta: [R; D], gradient: [R; D]) -> [R; D] {
        difference(self.increment(gradient), delta)
    }

    /// q + Δ.
    #[inline]
    pub fn end(&self, delta: [R; D]) -> [R; D] {
        by_component!(|i| self.q[i] + delta[i])
    }

    /// Where the mask does not hold, that of the first lane where it does.
    pub(crate) fn lent(&self, by: R::Mask) -> Self {
        let lent = |x: R| x.lent(by);
        Equation {
            q: self.q.map(lent),
            a: self.a.map(lent),
            drift: self.drift.map(lent),
            frozen: self.frozen.map(lent),
            g: lent(self.g),
            v: self.v.map(lent),
            rate: lent(self.rate),
            t_end: lent(self.t_end),
            guess: self.guess.map(lent),
            ..*self
        }
    }

    /// The same equation for a step of θh.
    pub(super) fn shortened(&self, theta: R) -> Self {
        let theta2 = theta * theta;
        Equation {
            a: by_component!(|i| self.q[i] + theta * (self.a[i] - self.q[i])),
            drift: by_component!(|i| theta * self.drift[i]),
            frozen: by_component!(|i| theta2 * self.frozen[i]),
            g: theta2 * self.g,
            // With no step at all the velocity is that of the start.
            rate: R::select(theta.equal(R::ZERO), || R::ZERO, || self.rate / theta),
            ..*self
        }
    }
}

/// How often something happens: of several numbers side by side, to each its own.
pub type Counts<R> = <<R as Real>::Mask as Mask>::Count;

/// The solution: Δ and G(q + Δ), which the velocity needs.
#[derive(Clone, Copy, Debug)]
pub struct Increment<const D: usize, R: Real> {
    /// q′ − q.
    pub delta: [R; D],
    /// G at the solution.
    pub gradient: [R; D],
    /// The same as a sum that is not rounded: G where the last correction was made, and J δ, by which it changed G.
    ///
    /// The second is often less than half an ulp of the first. As corrections keep their sign from step to step, it would be
    /// lost in one sense at every step, and become a drift of the energy (1.2·10⁻¹³ in 10⁷ steps of Kepler in components).
    pub parts: [[R; D]; 2],
    /// Evaluations of the force that it took.
    pub evaluations: Counts<R>,
    /// Newton corrections that it took; 0 where the step is linear.
    pub iterations: Counts<R>,
}

impl<const D: usize, R: Real> Increment<D, R> {
    /// The one where the mask holds, the other elsewhere.
    #[inline(always)]
    pub(crate) fn either(which: R::Mask, one: Self, other: Self) -> Self {
        let Increment { delta, gradient, parts: [main, rest], evaluations, iterations } = other;
        Increment {
            delta: either(which, one.delta, delta),
            gradient: either(which, one.gradient, gradient),
            parts: [either(which, one.parts[0], main), either(which, one.parts[1], rest)],
            evaluations: which.count(one.evaluations, evaluations),
            iterations: which.count(one.iterations, iterations),
        }
    }

    /// With G − `force` for G.
    #[inline(always)]
    pub(crate) fn less(self, force: [R; D]) -> Self {
        let [slope, turned] = self.parts;
        Increment { gradient: difference(self.gradient, force), parts: [difference(slope, force), turned], ..self }
    }

    /// The same after so many evaluations, with a correction for each.
    pub(super) fn after(self, evaluations: u32) -> Self {
        let made = Count::of(evaluations);
        Increment { evaluations: made, iterations: made, ..self }
    }

    /// The result of a rare path, part by part: that of the usual path, which it is merged with, then stays in registers.
    #[inline(always)]
    pub(super) fn apart(found: Result<Self, NotConverged>) -> Result<Self, NotConverged> {
        let Increment { delta, gradient, parts, evaluations, iterations } = found?;
        Ok(Increment { delta, gradient, parts, evaluations, iterations })
    }
}

/// One Newton correction, as generated code computes it in a straight line.
#[derive(Clone, Copy, Debug)]
pub struct Correction<const D: usize, R: Real> {
    /// δ, the solution of (1 + g J) δ = drift − frozen − g G − Δ, where G and J are taken at q + Δ.
    pub delta: [R; D],
    /// G + J δ.
    pub gradient: [R; D],
    /// G and J δ; of [`rounded`](Correction::rounded) G and 0.
    pub parts: [[R; D]; 2],
    /// Whether a root there may continue that of a shorter step, as far as 1 + g J tells: from the unit matrix it grows with the
    /// step, and on the way is not singular.
    pub continued: R::Mask,
    /// The same without a doubt: no pivot of 1 + g J is negative, of a J that is not symmetric neither.
    pub definite: R::Mask,
}

impl<const D: usize, R: Real> Correction<D, R> {
    /// The correction δ = `change` with G and G + J δ, for steps to which the rounding of that sum does not matter: of its parts there is G
    /// alone, as a difference for the other would be formed in every step (4 of 182 instructions).
    #[inline(always)]
    pub fn rounded(change: [R; D], slope: [R; D], gradient: [R; D]) -> Self {
        Correction { gradient, ..Correction::in_parts(change, slope, [R::ZERO; D]) }
    }

    /// The same, with numbers that are all positive where 1 + g J has never been singular: pivots or leading minors of a
    /// symmetric J, the determinant of another.
    #[inline(always)]
    #[must_use]
    pub fn if_positive<const N: usize>(self, numbers: [R; N]) -> Self {
        let continued = numbers.iter().fold(self.continued, |all, &x| all.and(R::ZERO.less(x)));
        Correction { continued, definite: continued, ..self }
    }

    /// The same of a J that is not symmetric: the determinant, which is to be positive, and pivots, of which an even number may
    /// be negative; but then there is doubt.
    #[inline(always)]
    #[must_use]
    pub fn if_oriented<const N: usize>(self, determinant_and_pivots: [R; N]) -> Self {
        let continued = self.continued.and(R::ZERO.less(determinant_and_pivots[0]));
        Correction { continued, ..self.if_positive(determinant_and_pivots) }
    }

    /// The correction δ = `change` with G and J δ, for steps that conserve the energy.
    #[inline(always)]
    pub fn in_parts(change: [R; D], slope: [R; D], turned: [R; D]) -> Self {
        let (gradient, yes) = (by_component!(|i| slope[i] + turned[i]), R::Mask::of(true));
        Correction { delta: change, gradient, parts: [slope, turned], continued: yes, definite: yes }
    }
}

/// The iteration did not settle: Newton's method, the sweeps of [`Gauss`](crate::Gauss) and [`LineIntegral`](crate::LineIntegral), or the
/// corrections of [`Relaxed`](crate::Relaxed).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NotConverged {
    /// Newton corrections, sweeps, or corrections of λ that were made. As wide as a number of the increment, whose place in a result it
    /// shares: narrower, it would have every increment taken apart into halves (3 of the 38 ns of a step).
    pub iterations: u64,
    /// The last Newton correction, a length; or the largest change of a push in the last sweep, in units of rounding; or the last |λ|.
    pub residual: f64,
}

impl NotConverged {
    /// What root there is does not continue that of a shorter step. Of a linear equation no iteration changes that.
    pub const NOT_CONTINUED: Self = NotConverged { iterations: 0, residual: f64::INFINITY };
}
