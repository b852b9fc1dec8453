//! The energy-exact two-step scheme.

use dmech_scalar::{CompensatedVector, Real};

use super::guess::continued;
use super::{Effort, Method, Newton, Scheme, Stride, discrete_gradient};
use crate::State;
use crate::invariant::{Invariant, Kept};
use crate::law::{Field, Law, Potential, VelocityIndependent};
use crate::newton::{Equation, NotConverged};
use crate::vector::{add_scaled, difference, finite, scaled, weighted};

/// The energy-exact central difference (Kanatani (2.11)–(2.12) with the force of (3.7)).
///
/// ```text
/// m (q₊ − 2q + q₋)/h² = −∇̄Φ(q₋, q₊),   z = (q − q₋)/h:
/// z′ = z − (h/m) ∇̄Φ(q₋, q₊),   q₊ = q + h z′
/// ```
///
/// | order | energy | angular momentum | symplectic | reversible | per step |
/// |---|---|---|---|---|---|
/// | 2 | m z²/2 + (Φ(q) + Φ(q₋))/2 exact; m v²/2 + Φ(q) bounded | exact (central laws) | no | yes | 1 nonlinear solve |
///
/// z approximates the velocity half a step before ([`KanataniMemory::z`]). The velocity of a state is
/// z + (h/2) a(q): by Taylor v(t) = v(t − h/2) + (h/2) a(t) + O(h²), so it is of second order like the position; for a
/// central force it leaves q × v = q × z unchanged.
///
/// The start is q₋₁ = q₀ − h v₀ + (h²/2) a₀, that is z₀ = v₀ − (h/2) a₀ (the paper's text prints + where (3.1) gives −; with +
/// the order falls to 1). From a pericentre with a large step that start is itself wrong: [`Start::BackwardStep`].
///
/// `Kanatani` is a value and a type; `Kanatani.with(...)` and `Kanatani.start(...)` set options.
///
/// # Requires
/// Forces that do not depend on the velocity.
/// # Errors
/// [`NotConverged`] with iterations and residual.
/// # Reference
/// K. Kanatani, "The Accuracy and the Preservation Property of the Discrete Mechanics", J. Comput. Phys. (1983–84).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Kanatani {
    pub(crate) newton: Newton,
    pub(crate) start: Start,
}

/// [`Kanatani`](struct@Kanatani) with the default options.
#[expect(non_upper_case_globals)]
pub const Kanatani: Kanatani = Kanatani { newton: Newton::DEFAULT, start: Start::Formula };

/// Where the position before the first comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Start {
    /// q₋₁ = q₀ − h v₀ + (h²/2) a₀.
    #[default]
    Formula,
    /// One step of [`DiscreteGradient`](struct@super::DiscreteGradient) backward in time.
    BackwardStep,
}

impl Kanatani {
    /// The same scheme with other options for the solution of its equation.
    pub const fn with(self, newton: Newton) -> Self {
        Kanatani { newton, ..self }
    }

    /// The same scheme with another start.
    pub const fn start(self, start: Start) -> Self {
        Kanatani { start, ..self }
    }
}

/// What [`Kanatani`](struct@Kanatani) carries.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KanataniMemory<const D: usize, R = f64> {
    q_before: [R; D],
    q: CompensatedVector<D, R>,
    z: CompensatedVector<D, R>,
    gradients: [[R; D]; 3],
}

#[cfg(feature = "serde")]
impl<const D: usize> crate::checkpoint::Carried for KanataniMemory<D> {
    fn carried(&mut self) -> Vec<&mut [f64]> {
        let [newest, second, third] = &mut self.gradients;
        vec![&mut self.q_before, &mut self.q.hi, &mut self.q.lo, &mut self.z.hi, &mut self.z.lo, newest, second, third]
    }
}

impl<const D: usize, R: Real> KanataniMemory<D, R> {
    /// Starts from two positions a step apart.
    pub fn from_positions(stride: &Stride<R>, q_before: [R; D], q: [R; D], gradient: [R; D]) -> Self {
        let z = scaled(stride.dt.recip(), difference(q, q_before));
        KanataniMemory {
            q_before,
            q: CompensatedVector::new(q),
            z: CompensatedVector::new(z),
            gradients: [gradient; 3],
        }
    }

    /// q₋, the position a step before.
    pub fn q_before(&self) -> [R; D] {
        self.q_before
    }

    /// q, the position now.
    pub fn q(&self) -> [R; D] {
        self.q.value()
    }

    /// z = (q − q₋)/h, approximately the velocity half a step before.
    pub fn z(&self) -> [R; D] {
        self.z.value()
    }
}

impl Method for Kanatani {
    const NAME: &'static str = "Kanatani";
    const ORDER: u32 = 2;
    const SYMMETRIC: bool = true;

    fn keeps(invariant: Invariant) -> Kept {
        match invariant {
            Invariant::Energy => Kept::Bounded,
            _ => Kept::Exact,
        }
    }
}

impl<L: Law<D, R> + VelocityIndependent, const D: usize, R: Real> Scheme<L, D, R> for Kanatani {
    type Memory = KanataniMemory<D, R>;

    fn begin(&self, law: &L, stride: &Stride<R>, start: &State<D, R>) -> Result<Self::Memory, NotConverged> {
        let State { t, q, v } = *start;
        let t = R::from_f64(t);
        let field = law.field(stride.mass, t);
        let gradient = field.slope(q, v);
        let z = match self.start {
            Start::Formula => field.kick(R::from_f64(-0.5) * stride.kick, q, v),
            Start::BackwardStep => {
                let back = stride.times(-R::ONE);
                let found = discrete_gradient::increment(
                    law,
                    &back,
                    t,
                    q,
                    &CompensatedVector::new(v),
                    continued([gradient; 3]),
                    &self.newton,
                )?;
                scaled(back.dt.recip(), found.delta)
            }
        };
        Ok(KanataniMemory {
            q_before: add_scaled(q, -stride.dt, z),
            q: CompensatedVector::new(q),
            z: CompensatedVector::new(z),
            gradients: [gradient; 3],
        })
    }

    #[inline(always)]
    fn step(&self, law: &L, stride: &Stride<R>, t: R, memory: &mut Self::Memory) -> Result<Effort, NotConverged> {
        let KanataniMemory { q_before, q, z, gradients } = *memory;
        let g = stride.fall;
        let drift = stride.drift(&z);
        let zero = [R::ZERO; D];
        let guess = self.newton.guess((stride.dt, z.value()), zero, g, continued(gradients));
        let equation = Equation {
            a: q_before,
            guess,
            max_iterations: self.newton.limit(),
            piecewise: <L::Field<'_> as Potential<D, R>>::PIECEWISE,
            ..Equation::new(q.value(), drift, g)
        };
        let field = law.field(stride.mass, t);
        let found = if <L::Field<'_> as Field<D, R>>::FORCED {
            // A force beside the potential is that at the position now.
            let force = scaled(R::from_f64(2.0), field.half_force(q.value(), z.value()));
            field.potential_increment(&Equation { frozen: scaled(-g, force), ..equation })?.less(force)
        } else {
            field.discrete_increment(&equation)?
        };
        let (mut q_next, mut z_next) = (q, z);
        q_next.add(stride.kick_and_drift(R::ONE, &mut z_next, found.parts));
        *memory = KanataniMemory {
            q_before: q.value(),
            q: q_next,
            z: z_next,
            gradients: [found.gradient, gradients[0], gradients[1]],
        };
        Ok(Effort { evaluations: found.evaluations, iterations: found.iterations })
    }

    #[inline]
    fn position(&self, memory: &Self::Memory) -> [R; D] {
        memory.q.value()
    }

    /// z + (h/2) a(q).
    fn velocity(&self, law: &L, stride: &Stride<R>, t: R, memory: &Self::Memory) -> [R; D] {
        law.field(stride.mass, t).kick(R::from_f64(0.5) * stride.kick, memory.q.value(), memory.z.value())
    }

    #[inline]
    fn finite(&self, memory: &Self::Memory) -> bool {
        finite(memory.q.hi) && finite(memory.z.hi)
    }

    /// m z²/2 (3.2).
    fn kinetic_energy(&self, law: &L, stride: &Stride<R>, memory: &Self::Memory) -> R {
        stride.kinetic_energy(law.mass_ratios(), memory.z.value())
    }

    /// F·(q₊ − q₋)/2 (3.3)–(3.6).
    fn work(&self, law: &L, _: &Stride<R>, before: &Self::Memory, after: &Self::Memory) -> R {
        R::from_f64(-0.5)
            * weighted(law.mass_ratios(), after.gradients[0], difference(after.q.value(), before.q_before))
    }

    /// m z²/2 + (Φ(q) + Φ(q₋))/2 (3.9)–(3.10).
    fn discrete_energy(&self, law: &L, stride: &Stride<R>, t: R, memory: &Self::Memory) -> Option<R> {
        let field = law.field(stride.mass, t);
        let potentials = field.potential(memory.q.value()) + field.potential(memory.q_before);
        Some(R::from_f64(0.5).mul_add(potentials, stride.kinetic_energy(law.mass_ratios(), memory.z.value())))
    }
}
