//! The energy-exact two-step scheme.

use dmech_scalar::Real;

use super::by_lane::by_lane;
use super::memory::memory;
use super::one_solve::Stage;
use super::{
    DiscreteGradient, Effort, Method, Newton, Reached, Scheme, WithoutVelocities, alike, remember, single_step,
};
use crate::invariant::{Invariant, Kept};
use crate::newton::NotConverged;
use crate::system::{Ahead, ImplicitSteps, Kick, Step, System};

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
/// ```
/// use dmech_core::prelude::*;
#[doc = include_str!("../examples/quartic.md")]
/// let quartic = Simulation::new(Quartic { k: 1.7 }, State::new([1.0], [0.3]));
/// let run = quartic.scheme(Kanatani).dt(0.1).run_until(1000.0)?;
/// assert!(run.drift(Invariant::DiscreteEnergy).unwrap().max_relative() < 1e-13);
/// assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 0.02);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// `Kanatani` is a value and a type; `Kanatani.with(...)` and `Kanatani.start(...)` set options.
///
/// # Requires
/// Forces that do not depend on the velocity.
/// # Errors
/// A run ends with [`Error::NotConverged`](crate::Error::NotConverged), which has the corrections made and the last of them, or, where
/// the law is not finite on the way, with [`Error::LawInStep`](crate::Error::LawInStep).
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
#[non_exhaustive]
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

memory! {
    /// What [`Kanatani`](struct@Kanatani) carries.
    pub struct KanataniMemory<Y> {
        q_before: Y::Vector,
        q: Y::Sum,
        z: Y::Sum,
    }
    lists {
        /// ∇̄Φ − F of the last three steps, the newest first; ∇Φ − F before the first.
        slopes: [Y::Vector; 3],
    }
    uncarried {}
}

by_lane! { KanataniMemory { q_before, q, z, slopes }; }

impl<Y: System> KanataniMemory<Y> {
    /// Starts from two positions a step apart, with ∇Φ − F at the second.
    pub fn from_positions(stride: &Y::Stride, q_before: Y::Vector, q: Y::Vector, slope: &Y::Vector) -> Self {
        let mut z = q.clone();
        Y::add_scaled(&mut z, -Y::Scalar::ONE, &q_before);
        Y::scale(&mut z, Y::dt(stride).recip());
        Self::new(q_before, &q, &z, slope)
    }

    fn new(q_before: Y::Vector, q: &Y::Vector, z: &Y::Vector, slope: &Y::Vector) -> Self {
        KanataniMemory { q_before, q: Y::sum(q), z: Y::sum(z), slopes: alike(slope) }
    }

    /// q₋, the position a step before.
    pub fn q_before(&self) -> Y::Vector {
        self.q_before.clone()
    }

    /// q, the position now.
    pub fn q(&self) -> Y::Vector {
        Y::value(&self.q).clone()
    }

    /// z = (q − q₋)/h, approximately the velocity half a step before.
    pub fn z(&self) -> Y::Vector {
        Y::value(&self.z).clone()
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

impl<Y: ImplicitSteps + WithoutVelocities> Scheme<Y> for Kanatani {
    const SHARE: f64 = 1.0;

    type Memory = KanataniMemory<Y>;
    type Workspace = Y::Solver;

    fn workspace(&self, system: &Y, _: &Y::Stride) -> Y::Solver {
        system.solver()
    }

    fn begin(
        &self,
        system: &Y,
        stride: &Y::Stride,
        start: &super::Beginning<'_, Y>,
        solver: &mut Y::Solver,
    ) -> Result<Self::Memory, NotConverged> {
        let (q, v, t, slope) = (start.q, start.v, start.t, start.slope);
        let h = Y::dt(stride);
        let mut q_before = q.clone();
        match self.start {
            Start::Formula => {
                let half = Kick { t, b: Y::Scalar::from_f64(0.5), e: 0.0 };
                let [z, _] = system.kick_both_ways(&mut system.room(), stride, half, start);
                Y::add_scaled(&mut q_before, -h, &z);
                Ok(KanataniMemory::new(q_before, q, &z, slope))
            }
            Start::BackwardStep => {
                let back = system.stage(stride, -Y::Scalar::ONE, <DiscreteGradient as Stage>::SHARE);
                let (q, v, ahead) = (Y::sum(q), Y::sum(v), Ahead::Continued([slope; 3]));
                let step = Step { stride: &back, t, q: &q, v: &v, ahead, newton: &self.newton };
                let found = system.solve_exact(solver, &step)?;
                let mut z = Y::moved(solver, &found).clone();
                Y::scale(&mut z, (-h).recip());
                Y::add_scaled(&mut q_before, -h, &z);
                Ok(KanataniMemory::new(q_before, start.q, &z, slope))
            }
        }
    }

    /// (q₊ − 2q + q₋)/h² = −∇̄Φ(q₋, q₊)/m; z = (q − q₋)/h.
    #[inline(always)]
    fn step(
        &self,
        system: &Y,
        stride: &Y::Stride,
        t: Y::Scalar,
        memory: &mut Self::Memory,
        solver: &mut Y::Solver,
    ) -> Result<Effort<Y::Scalar>, NotConverged> {
        let KanataniMemory { q_before, q, z, slopes } = memory;
        let ahead = Ahead::Continued(slopes.each_ref());
        let step = Step { stride, t, q, v: z, ahead, newton: &self.newton };
        let mut found = system.solve_across(solver, &step, q_before)?;
        q_before.clone_from(Y::value(q));
        system.settle(solver, stride, 1.0, &mut found, [q, z]);
        remember::<Y>(solver, &found, slopes);
        Ok(Y::effort(&found))
    }

    /// The velocity of a state is that of the formula, whatever the first one started with: so it goes on from there.
    fn within(&self, system: &Y, dt: Y::Scalar, from: &super::Beginning<'_, Y>) -> Result<Reached<Y>, NotConverged> {
        single_step(&self.start(Start::Formula), system, dt, from)
    }

    #[inline]
    fn position<'m>(&self, memory: &'m Self::Memory) -> &'m Y::Vector {
        Y::value(&memory.q)
    }

    /// z + (h/2) a(q).
    fn velocity(&self, system: &Y, stride: &Y::Stride, t: Y::Scalar, memory: &Self::Memory) -> Y::Vector {
        let half = Kick { t, b: Y::Scalar::from_f64(0.5), e: 0.0 };
        let mut v = system.zero();
        system.kick(&mut system.room(), stride, half, Y::value(&memory.q), Y::value(&memory.z), &mut v);
        v
    }

    #[inline]
    fn finite(&self, memory: &Self::Memory) -> bool {
        Y::is_finite(Y::value(&memory.q)) && Y::is_finite(Y::value(&memory.z))
    }

    /// Σ m z²/2 (3.2).
    fn kinetic_energy(&self, system: &Y, memory: &Self::Memory) -> Y::Scalar {
        system.kinetic_energy(Y::value(&memory.z))
    }

    /// F·(q₊ − q₋)/2 = F·h (z + z₊)/2 (3.3)–(3.6).
    fn work(&self, system: &Y, stride: &Y::Stride, before: &Self::Memory, after: &Self::Memory) -> Y::Scalar {
        let half = Y::Scalar::from_f64(0.5) * Y::dt(stride);
        system.work_at_speeds(&after.slopes[0], half, Y::value(&before.z), Y::value(&after.z))
    }

    /// Σ m z²/2 + (Φ(q) + Φ(q₋))/2 (3.9)–(3.10).
    fn discrete_energy(&self, system: &Y, t: Y::Scalar, memory: &Self::Memory) -> Option<Y::Scalar> {
        let potentials = system.potential(t, Y::value(&memory.q)) + system.potential(t, &memory.q_before);
        Some(Y::Scalar::from_f64(0.5).mul_add(potentials, system.kinetic_energy(Y::value(&memory.z))))
    }
}
