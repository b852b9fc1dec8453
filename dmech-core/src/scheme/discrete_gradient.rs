//! The energy-exact one-step scheme.

use dmech_scalar::{CompensatedVector, Real};

use super::guess::continued;
use super::{Effort, Method, Newton, Scheme, Stride, workless};
use crate::State;
use crate::invariant::{Invariant, Kept};
use crate::law::{Field, Law, Potential};
use crate::newton::{Equation, Increment, NotConverged};
use crate::vector::{difference, finite, scaled, sum, weighted};

/// The energy-exact step (LaBudde–Greenspan): mean velocity, and the force as a discrete gradient.
///
/// ```text
/// (v′ + v)/2 = (q′ − q)/h,   m (v′ − v)/h = −∇̄Φ(q, q′),   ∇̄Φ(a, b)·(b − a) = Φ(b) − Φ(a)
/// ```
///
/// | order | energy | angular momentum | symplectic | reversible | per step |
/// |---|---|---|---|---|---|
/// | 2 | exact, for any sequence of steps | exact (central laws) | no | yes | 1 nonlinear solve |
///
/// Beside a force the second equation is m (v′ − v)/h = −∇̄Φ + (F + F′)/2: the change of energy is the work of that force,
/// exactly. A force that does no work at any velocity, as v × B, is taken at the mean position and mean velocity
/// instead, where it does none in the step either.
///
/// Multiplying the second equation by Δq = q′ − q gives K′ − K = −(Φ′ − Φ). Position and velocity are compensated
/// sums: their rounding would otherwise be the largest error of the energy, and grow in proportion to the time.
///
/// `DiscreteGradient` is a value and a type; `DiscreteGradient.with(...)` sets options.
///
/// # Requires
/// Φ finite on both ends of each step; for a law that names the time the discrete gradient is that of the mid-time.
/// # Errors
/// [`NotConverged`] with iterations and residual.
/// # Reference
/// R. LaBudde and D. Greenspan, J. Comput. Phys. 15 (1974) 134; K. Kanatani, J. Comput. Phys. (1983–84), §3.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DiscreteGradient {
    pub(crate) newton: Newton,
}

/// [`DiscreteGradient`](struct@DiscreteGradient) with the default options.
#[expect(non_upper_case_globals)]
pub const DiscreteGradient: DiscreteGradient = DiscreteGradient { newton: Newton::DEFAULT };

impl DiscreteGradient {
    /// The same scheme with other options for the solution of its equation.
    pub const fn with(self, newton: Newton) -> Self {
        DiscreteGradient { newton }
    }
}

/// What [`DiscreteGradient`](struct@DiscreteGradient) carries.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiscreteGradientMemory<const D: usize, R = f64> {
    /// Position.
    pub q: CompensatedVector<D, R>,
    /// Velocity.
    pub v: CompensatedVector<D, R>,
    /// ∇̄Φ less the mean force of the last three steps, the newest first; ∇Φ − F before the first step.
    gradients: [[R; D]; 3],
}

#[cfg(feature = "serde")]
impl<const D: usize> crate::checkpoint::Carried for DiscreteGradientMemory<D> {
    fn carried(&mut self) -> Vec<&mut [f64]> {
        let [newest, second, third] = &mut self.gradients;
        vec![&mut self.q.hi, &mut self.q.lo, &mut self.v.hi, &mut self.v.lo, newest, second, third]
    }
}

impl<const D: usize, R: Real> DiscreteGradientMemory<D, R> {
    /// ∇̄Φ of the last step; ∇Φ before the first.
    pub fn gradient(&self) -> [R; D] {
        self.gradients[0]
    }
}

impl Method for DiscreteGradient {
    const NAME: &'static str = "DiscreteGradient";
    const ORDER: u32 = 2;
    const SYMMETRIC: bool = true;

    fn keeps(invariant: Invariant) -> Kept {
        match invariant {
            Invariant::DiscreteEnergy => Kept::No,
            _ => Kept::Exact,
        }
    }
}

/// One step of position and velocity from time t on; `expected` is the force that the guess is made with.
#[inline(always)]
pub(super) fn advance<L: Law<D, R>, const D: usize, R: Real>(
    law: &L,
    stride: &Stride<R>,
    t: R,
    q: &mut CompensatedVector<D, R>,
    v: &mut CompensatedVector<D, R>,
    expected: [R; D],
    newton: &Newton,
) -> Result<Increment<D, R>, NotConverged> {
    if <L::Field<'_> as Field<D, R>>::FORCED && <L::Field<'_> as Field<D, R>>::CONSERVES_ENERGY {
        return workless::step(law, stride, t, q, v, expected, newton);
    }
    let found = increment(law, stride, t, q.value(), v, expected, newton)?;
    let delta = stride.kick_and_drift(R::from_f64(0.5), v, found.parts);
    q.add(delta);
    Ok(Increment { delta, ..found })
}

/// Δq and the mean slope ∇̄Φ − (F + F′)/2 of one step from q with velocity v, from the slope that is expected.
#[inline(always)]
pub(super) fn increment<L: Law<D, R>, const D: usize, R: Real>(
    law: &L,
    stride: &Stride<R>,
    t: R,
    q: [R; D],
    v: &CompensatedVector<D, R>,
    expected: [R; D],
    newton: &Newton,
) -> Result<Increment<D, R>, NotConverged> {
    let half = R::from_f64(0.5);
    let g = half * stride.fall;
    let drift = stride.drift(v);
    let zero = [R::ZERO; D];
    let guess = newton.guess((stride.dt, v.hi), zero, g, expected);
    let field = law.field(stride.mass, half.mul_add(stride.dt, t));
    let piecewise = <L::Field<'_> as Potential<D, R>>::PIECEWISE;
    let equation = Equation { guess, max_iterations: newton.limit(), piecewise, ..Equation::new(q, drift, g) };
    if !<L::Field<'_> as Field<D, R>>::FORCED {
        return field.discrete_increment(&equation);
    }
    // The unknown side has the force at the end; that at the start is known.
    let half_force = law.field(stride.mass, t).half_force(q, v.hi);
    let (frozen, t_end) = (scaled(-g, half_force), t + stride.dt);
    let equation = Equation { frozen, v: v.hi, rate: stride.rate, t_end, ..equation };
    let found = field.discrete_increment(&equation)?;
    Ok(found.less(half_force))
}

impl<L: Law<D, R>, const D: usize, R: Real> Scheme<L, D, R> for DiscreteGradient {
    type Memory = DiscreteGradientMemory<D, R>;

    fn begin(&self, law: &L, stride: &Stride<R>, start: &State<D, R>) -> Result<Self::Memory, NotConverged> {
        let State { t, q, v } = *start;
        let gradient = law.field(stride.mass, R::from_f64(t)).slope(q, v);
        let (q, v) = (CompensatedVector::new(q), CompensatedVector::new(v));
        Ok(DiscreteGradientMemory { q, v, gradients: [gradient; 3] })
    }

    #[inline(always)]
    fn step(&self, law: &L, stride: &Stride<R>, t: R, memory: &mut Self::Memory) -> Result<Effort, NotConverged> {
        let DiscreteGradientMemory { mut q, mut v, gradients } = *memory;
        let found = advance(law, stride, t, &mut q, &mut v, continued(gradients), &self.newton)?;
        *memory = DiscreteGradientMemory { q, v, gradients: [found.gradient, gradients[0], gradients[1]] };
        Ok(Effort { evaluations: found.evaluations, iterations: found.iterations })
    }

    #[inline]
    fn position(&self, memory: &Self::Memory) -> [R; D] {
        memory.q.value()
    }

    #[inline]
    fn velocity(&self, _: &L, _: &Stride<R>, _: R, memory: &Self::Memory) -> [R; D] {
        memory.v.value()
    }

    #[inline]
    fn finite(&self, memory: &Self::Memory) -> bool {
        finite(memory.q.hi) && finite(memory.v.hi)
    }

    fn kinetic_energy(&self, law: &L, stride: &Stride<R>, memory: &Self::Memory) -> R {
        stride.kinetic_energy(law.mass_ratios(), memory.v.value())
    }

    /// (−∇̄Φ(q, q′) + (F + F′)/2)·Δq.
    fn work(&self, law: &L, _: &Stride<R>, before: &Self::Memory, after: &Self::Memory) -> R {
        let moved = sum(difference(after.q.hi, before.q.hi), difference(after.q.lo, before.q.lo));
        -weighted(law.mass_ratios(), after.gradients[0], moved)
    }
}
