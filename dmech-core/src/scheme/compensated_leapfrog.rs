//! Leap-frog whose sums lose nothing.

use dmech_scalar::{CompensatedVector, Real};

use super::{Effort, Method, Scheme, Stride};
use crate::State;
use crate::invariant::{Invariant, Kept};
use crate::law::{Field, Law, VelocityIndependent};
use crate::newton::NotConverged;
use crate::vector::{difference, finite, scaled, sum, weighted};

/// [`Leapfrog`](crate::Leapfrog) with compensated sums: for runs so long, or steps so short, that rounding matters more
/// than the step.
///
/// ```text
/// q′ = q + h v½,   v½′ = v½ + h a(q′),   each sum with what its roundings left out so far
/// ```
///
/// | order | energy | angular momentum | symplectic | reversible | per step |
/// |---|---|---|---|---|---|
/// | 2 | bounded, O(h²) | exact | yes | yes, to fewer roundings | 1 force |
///
/// A plain sum rounds at each step to an ulp of the position, and N roundings move the planet by √N ulp or, as its period
/// follows its energy, by N^1.5 ulp along the orbit. Here a step rounds the increments h v½ and h a, which are smaller than
/// the position by a factor of the order of h. The scheme is otherwise the same, and costs some additions more.
///
/// ```
/// use dmech_core::prelude::*;
/// # #[derive(Clone, Copy)]
/// # struct Spring { k: f64 }
/// # impl Conservative for Spring {}
/// # impl Potential<1> for Spring {
/// #     fn potential(&self, [x]: [f64; 1]) -> f64 { 0.5 * self.k * x * x }
/// #     fn gradient(&self, [x]: [f64; 1]) -> [f64; 1] { [self.k * x] }
/// #     fn hessian(&self, _: [f64; 1]) -> [[f64; 1]; 1] { [[self.k]] }
/// #     fn discrete_gradient(&self, [a]: [f64; 1], [b]: [f64; 1]) -> [f64; 1] { [0.5 * self.k * (a + b)] }
/// #     fn discrete_gradient_jacobian(&self, _: [f64; 1], _: [f64; 1]) -> [[f64; 1]; 1] { [[0.5 * self.k]] }
/// # }
/// // There and back in a hundred thousand short steps each.
/// let there = Simulation::new(Spring { k: 1.7 }, State::new([1.0], [0.3])).dt(1e-3);
/// let off = |run: Run<State<1>>| (run.last().q[0] - 1.0).abs();
/// let plain = there.clone().scheme(Leapfrog).run(100_000)?.last().reversed();
/// let compensated = there.scheme(CompensatedLeapfrog).run(100_000)?.last().reversed();
/// let back = |start| Simulation::new(Spring { k: 1.7 }, start).dt(1e-3);
/// let plain = off(back(plain).scheme(Leapfrog).run(100_000)?);
/// let compensated = off(back(compensated).scheme(CompensatedLeapfrog).run(100_000)?);
/// assert!(compensated < 3e-16 || compensated < plain);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Requires
/// Forces that do not depend on the velocity.
/// # Reference
/// E. Hairer, C. Lubich and G. Wanner, Geometric Numerical Integration (2nd ed., 2006), VIII.5; W. Kahan, Comm. ACM 8 (1965) 40.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CompensatedLeapfrog;

/// What [`CompensatedLeapfrog`] carries.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CompensatedLeapfrogMemory<const D: usize, R = f64> {
    /// Position.
    pub q: CompensatedVector<D, R>,
    /// Velocity half a step after.
    pub v_after: CompensatedVector<D, R>,
    /// What the last kick added to the velocity.
    pub change: [R; D],
}

#[cfg(feature = "serde")]
impl<const D: usize> crate::checkpoint::Carried for CompensatedLeapfrogMemory<D> {
    fn carried(&mut self) -> Vec<&mut [f64]> {
        let CompensatedLeapfrogMemory { q, v_after: v, change } = self;
        vec![&mut q.hi, &mut q.lo, &mut v.hi, &mut v.lo, change]
    }
}

impl Method for CompensatedLeapfrog {
    const NAME: &'static str = "CompensatedLeapfrog";
    const ORDER: u32 = 2;
    const SYMMETRIC: bool = true;

    fn keeps(invariant: Invariant) -> Kept {
        super::Leapfrog::keeps(invariant)
    }
}

impl<const D: usize, R: Real> CompensatedLeapfrogMemory<D, R> {
    /// Velocity half a step before.
    fn v_before(&self) -> [R; D] {
        difference(self.v_after.hi, self.change)
    }
}

impl<L: Law<D, R> + VelocityIndependent, const D: usize, R: Real> Scheme<L, D, R> for CompensatedLeapfrog {
    type Memory = CompensatedLeapfrogMemory<D, R>;

    fn begin(&self, law: &L, stride: &Stride<R>, start: &State<D, R>) -> Result<Self::Memory, NotConverged> {
        let State { t, q, v } = *start;
        let change = scaled(-stride.kick, law.field(stride.mass, R::from_f64(t)).slope(q, v));
        let mut v_after = CompensatedVector::new(v);
        v_after.add(scaled(R::from_f64(0.5), change));
        Ok(CompensatedLeapfrogMemory { q: CompensatedVector::new(q), v_after, change })
    }

    #[inline(always)]
    fn step(&self, law: &L, stride: &Stride<R>, t: R, memory: &mut Self::Memory) -> Result<Effort, NotConverged> {
        let CompensatedLeapfrogMemory { mut q, mut v_after, .. } = *memory;
        q.add(core::array::from_fn(|i| stride.dt.mul_add(v_after.hi[i], stride.dt * v_after.lo[i])));
        // The force is independent of the velocity.
        let slope = law.field(stride.mass, t + stride.dt).slope(q.hi, v_after.hi);
        let change = scaled(-stride.kick, slope);
        v_after.add(change);
        *memory = CompensatedLeapfrogMemory { q, v_after, change };
        Ok(Effort { evaluations: 1, iterations: 0 })
    }

    #[inline]
    fn position(&self, memory: &Self::Memory) -> [R; D] {
        memory.q.hi
    }

    #[inline]
    fn velocity(&self, _: &L, _: &Stride<R>, _: R, memory: &Self::Memory) -> [R; D] {
        core::array::from_fn(|i| R::from_f64(-0.5).mul_add(memory.change[i], memory.v_after.hi[i]))
    }

    #[inline]
    fn finite(&self, memory: &Self::Memory) -> bool {
        finite(memory.q.hi) && finite(memory.v_after.hi)
    }

    /// m v²/2 at the half step before.
    fn kinetic_energy(&self, law: &L, stride: &Stride<R>, memory: &Self::Memory) -> R {
        stride.kinetic_energy(law.mass_ratios(), memory.v_before())
    }

    /// F_k·(q_{k+1} − q_{k−1})/2, with F_k as the kick applied it.
    fn work(&self, law: &L, stride: &Stride<R>, before: &Self::Memory, _: &Self::Memory) -> R {
        let force = scaled(stride.kick.recip(), before.change);
        let two_steps = scaled(stride.dt, sum(before.v_before(), before.v_after.hi));
        R::from_f64(0.5) * weighted(law.mass_ratios(), force, two_steps)
    }
}
