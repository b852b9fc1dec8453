//! The implicit formulas: the trapezoidal rule.

use dmech_scalar::Real;

use super::guess::continued;
use super::{Effort, Method, Newton, Scheme, Stride};
use crate::State;
use crate::invariant::{Invariant, Kept};
use crate::law::{Field, Law, Potential};
use crate::newton::{Equation, Increment, NotConverged};
use crate::vector::{add_scaled, finite, scaled, sum, weighted};

/// The implicit formulas (Greenspan (2.1)–(2.5)): mean velocity and mean acceleration.
///
/// ```text
/// (v′ + v)/2 = (q′ − q)/h,   (v′ − v)/h = (a(q′, v′, t′) + a(q, v, t))/2
/// ```
///
/// | order | energy | angular momentum | symplectic | reversible | per step |
/// |---|---|---|---|---|---|
/// | 2 | bounded, O(h²) | bounded | conjugate | yes | 1 nonlinear solve |
///
/// The velocity is eliminated, Newton acts on the increment Δ = q′ − q, and v′ = v + h (a + a′)/2: v′ = 2Δ/h − v would
/// amplify the round-off by 1/h. The work-energy balance holds with the mean force, W = Σ (F + F′)/2·Δq (2.7)–(2.9).
///
/// `Implicit` is a value and a type; `Implicit.with(...)` sets options.
///
/// # Errors
/// [`NotConverged`] with iterations and residual.
/// # Reference
/// D. Greenspan, Univ. of Wisconsin, Computer Sciences TR 122 (1971), §2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Implicit {
    pub(crate) newton: Newton,
}

/// [`Implicit`](struct@Implicit) with the default options.
#[expect(non_upper_case_globals)]
pub const Implicit: Implicit = Implicit { newton: Newton::DEFAULT };

impl Implicit {
    /// The same scheme with other options for the solution of its equation.
    pub const fn with(self, newton: Newton) -> Self {
        Implicit { newton }
    }
}

/// What [`Implicit`](struct@Implicit) carries.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ImplicitMemory<const D: usize, R = f64> {
    /// Position.
    pub q: [R; D],
    /// Velocity.
    pub v: [R; D],
    /// q − q₋, the increment of the last step as it was solved for: a difference of positions has fewer digits.
    moved: [R; D],
    /// ∇Φ − F in the last three states, the newest first.
    gradients: [[R; D]; 3],
}

#[cfg(feature = "serde")]
impl<const D: usize> crate::checkpoint::Carried for ImplicitMemory<D> {
    fn carried(&mut self) -> Vec<&mut [f64]> {
        let [newest, second, third] = &mut self.gradients;
        vec![&mut self.q, &mut self.v, &mut self.moved, newest, second, third]
    }
}

impl Method for Implicit {
    const NAME: &'static str = "Implicit";
    const ORDER: u32 = 2;
    const SYMMETRIC: bool = true;

    fn keeps(invariant: Invariant) -> Kept {
        match invariant {
            Invariant::Energy | Invariant::AngularMomentum => Kept::Bounded,
            Invariant::WorkEnergy | Invariant::LinearMomentum => Kept::Exact,
            Invariant::DiscreteEnergy => Kept::No,
        }
    }
}

/// One step from q and v, where ∇Φ − F is `gradient`, to the time `t_end`, from the ∇Φ − F that is expected there.
#[inline(always)]
pub(super) fn advance<L: Law<D, R>, const D: usize, R: Real>(
    law: &L,
    stride: &Stride<R>,
    t_end: R,
    (q, v): (&mut [R; D], &mut [R; D]),
    gradient: [R; D],
    expected: [R; D],
    newton: &Newton,
) -> Result<Increment<D, R>, NotConverged> {
    let g = R::from_f64(0.25) * stride.fall;
    let drift = scaled(stride.dt, *v);
    let frozen = scaled(g, gradient);
    let guess = newton.guess((stride.dt, *v), frozen, g, expected);
    let max_iterations = newton.limit();
    let piecewise = <L::Field<'_> as Potential<D, R>>::PIECEWISE;
    let mut equation = Equation { frozen, guess, max_iterations, piecewise, ..Equation::new(*q, drift, g) };
    if <L::Field<'_> as Field<D, R>>::FORCED {
        equation = Equation { v: *v, rate: stride.rate, t_end, ..equation };
    }
    let found = law.field(stride.mass, t_end).implicit_increment(&equation)?;
    *q = sum(*q, found.delta);
    *v = add_scaled(*v, R::from_f64(-0.5) * stride.kick, sum(gradient, found.gradient));
    Ok(found)
}

impl<L: Law<D, R>, const D: usize, R: Real> Scheme<L, D, R> for Implicit {
    type Memory = ImplicitMemory<D, R>;

    fn begin(&self, law: &L, stride: &Stride<R>, start: &State<D, R>) -> Result<Self::Memory, NotConverged> {
        let State { t, q, v } = *start;
        let gradient = law.field(stride.mass, R::from_f64(t)).slope(q, v);
        Ok(ImplicitMemory { q, v, moved: [R::ZERO; D], gradients: [gradient; 3] })
    }

    #[inline(always)]
    fn step(&self, law: &L, stride: &Stride<R>, t: R, memory: &mut Self::Memory) -> Result<Effort, NotConverged> {
        let ImplicitMemory { mut q, mut v, gradients, .. } = *memory;
        let [gradient, before, _] = gradients;
        let next = continued(gradients);
        let found = advance(law, stride, t + stride.dt, (&mut q, &mut v), gradient, next, &self.newton)?;
        *memory = ImplicitMemory { q, v, moved: found.delta, gradients: [found.gradient, gradient, before] };
        Ok(Effort { evaluations: found.evaluations, iterations: found.iterations })
    }

    #[inline]
    fn position(&self, memory: &Self::Memory) -> [R; D] {
        memory.q
    }

    #[inline]
    fn velocity(&self, _: &L, _: &Stride<R>, _: R, memory: &Self::Memory) -> [R; D] {
        memory.v
    }

    #[inline]
    fn finite(&self, memory: &Self::Memory) -> bool {
        finite(memory.q) && finite(memory.v)
    }

    fn kinetic_energy(&self, law: &L, stride: &Stride<R>, memory: &Self::Memory) -> R {
        stride.kinetic_energy(law.mass_ratios(), memory.v)
    }

    /// (F + F′)/2·Δq (2.7).
    fn work(&self, law: &L, _: &Stride<R>, before: &Self::Memory, after: &Self::Memory) -> R {
        R::from_f64(-0.5) * weighted(law.mass_ratios(), sum(before.gradients[0], after.gradients[0]), after.moved)
    }
}
