//! Steps that follow the time scale of the motion, reversibly.

mod adaptable;
mod pacing;

#[cfg(test)]
mod tests;

pub use adaptable::Adaptable;
pub(crate) use pacing::Pacing;

use dmech_scalar::Compensated;

use super::{Effort, Method, Reached, Scheme};
use crate::error::Error;
use crate::invariant::{Invariant, Kept};
use crate::name::Name;
use crate::newton::NotConverged;
use crate::system::{Beginning, EVALUATIONS, TimeScale};
use pacing::MIDDLE;

/// Steps as long as the motion allows, short at a pericentre and long at an apocentre, by a rule that runs backward as it
/// runs forward; [`Simulation::adaptive`](crate::Simulation::adaptive) makes it.
///
/// ```text
/// ρ_{n+1/2} = ρ_{n−1/2} + ε (d ln ω/dt)(qₙ, vₙ),   h_{n+1/2} = ε/ρ_{n+1/2},   ρ_{1/2} = ω(q₀) + (ε/2)(d ln ω/dt)(q₀, v₀)
/// ```
///
/// Several steps in a row are equal where they are so short that ω hardly changes: n counts rows, of m steps and mε ≤ ⅛, and
/// mε takes the place of ε in the rule for ρ. Where there is a longest step, ω is looked at before so long a time has gone by within
/// a row, and if ρ has fallen below ⅔ of it the row ends there.
///
/// The density ρ of the steps follows the frequency ω of the linearised motion, so that a step turns that by the angle ε:
/// in the time τ that counts steps, dτ = ρ dt, ρ = ω has dρ/dτ = d ln ω/dt. The law gives ω. With K = ∂a/∂q, and K̇ and K̈
/// its derivatives along the motion,
///
/// ```text
/// ω¹² = ‖K‖⁶ + ‖K̇‖⁴/4 + ‖K̈‖³/100   (Frobenius norms; ‖∂a/∂v‖² beside the elements of K where there is damping)
/// ```
///
/// A harmonic oscillator has equal steps, a Kepler orbit steps in proportion to r^(3/2); K̇ and K̈ stand in where K passes
/// through zero, as for a pendulum at a right angle. As ω is even under v → −v, the sequence of steps is that of the
/// motion backward, and a reversible scheme stays reversible: what it keeps does not begin to drift because steps differ.
///
/// Of two bodies of a scene at a separation d with a relative velocity v, 10¹² ‖K‖ w⁵ is added, with w = u³/(u² + 45² ‖K‖²)
/// and u = v²/d²: one that passes another fast is seen before it is there. This term does not enter the growth rate
/// d ln ω/dt, and ρ is kept at ⅔ of its frequency or above.
///
/// An explicit reversible rule cannot pull ρ back to ω, or it would push it away on the way back. On smooth motions they
/// stay together to O(ε²). Where they come apart by more than [2/3, 3/2], in a collision with a wall or in steps too long
/// to see ω change, ρ is set to the end of that range: there the rule is not reversible, and what is put right again and again would let
/// the energy drift. So if ω itself, not the term of what passes, has outgrown ρ, the step is made again with half the ε, which holds for
/// the rest of the run, and is 0.3 at least: such steps see ω change on smooth motions. Where ε is that already, ρ becomes ω. A step is
/// also made again if ω has fallen to a quarter of ρ, as of one that was thrown to where nothing acts, and if its equation has no solution.
///
/// # Reference
/// E. Hairer and G. Söderlind, SIAM J. Sci. Comput. 26 (2005) 1838–1851: the rule for ρ. E. Hairer, C. Lubich and
/// G. Wanner, Geometric Numerical Integration (2nd ed., 2006), VIII.3.2. The choice of ω is this project's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Adaptive<S> {
    /// The scheme that makes the steps.
    pub(crate) scheme: S,
    tolerance: f64,
    /// ε.
    angle: f64,
    /// Steps of equal length in a row.
    row: f64,
    /// Where the last step lands.
    end: f64,
}

/// What [`Adaptive`] carries.
#[derive(Copy, Debug)]
pub struct AdaptiveMemory<M> {
    /// What the scheme itself carries.
    pub inner: M,
    /// Where its steps are.
    pub(crate) pacing: Pacing,
    /// The last has not seen the motion change.
    pub(crate) too_long: bool,
}

impl<M: Clone> Clone for AdaptiveMemory<M> {
    #[inline(always)]
    fn clone(&self) -> Self {
        AdaptiveMemory { inner: self.inner.clone(), ..*self }
    }

    /// Without a new allocation.
    fn clone_from(&mut self, other: &Self) {
        self.inner.clone_from(&other.inner);
        (self.pacing, self.too_long) = (other.pacing, other.too_long);
    }
}

#[cfg(feature = "serde")]
impl<M: crate::checkpoint::Carried> crate::checkpoint::Carried for AdaptiveMemory<M> {
    fn carried(&mut self) -> Vec<&mut [f64]> {
        let mut all = self.inner.carried();
        let Pacing { density, angle, last, dt, left, time: Compensated { hi, lo }, range, .. } = &mut self.pacing;
        all.extend([density, angle, last, dt, left].map(core::slice::from_mut));
        all.extend([core::slice::from_mut(hi), core::slice::from_mut(lo), range]);
        all
    }
}

/// Rows after which the longest step tells how long the steps of a motion are: one more than doubles it at most.
const MANY: f64 = 4096.0;

/// The angle that a row of equal steps turns at most, unless it is a single step.
const ROW: f64 = 0.125;

impl<S: Adaptable> Adaptive<S> {
    const TITLE: Name = Name::of(&["Adaptive(", S::NAME, ")"]);

    /// Steps of a scheme to a tolerance; [`Method::until`] says where they end.
    pub fn new(scheme: S, tolerance: f64) -> Self {
        let angle = scheme.angle(tolerance);
        Adaptive { scheme, tolerance, angle, row: (ROW / angle).floor().max(1.0), end: f64::INFINITY }
    }

    /// Prepares the scheme for steps of another length.
    fn set_pace<Y: TimeScale>(&self, system: &Y, dt: f64, workspace: &mut <Self as Scheme<Y>>::Workspace)
    where
        S: Scheme<Y>,
    {
        system.set_stride(&mut workspace.stride, dt, S::SHARE);
        self.scheme.pace(system, &workspace.stride, &mut workspace.inner);
    }
}

impl<S: Adaptable> Method for Adaptive<S> {
    const NAME: &'static str = Self::TITLE.text();
    const ORDER: u32 = S::ORDER;
    const SYMMETRIC: bool = S::SYMMETRIC;

    fn keeps(invariant: Invariant) -> Kept {
        S::keeps(invariant)
    }

    fn tolerance(&self) -> Option<f64> {
        Some(self.tolerance)
    }

    fn check(&self) -> Result<(), Error> {
        let Adaptive { tolerance, angle, .. } = *self;
        if !(tolerance > 0.0 && tolerance.is_finite()) {
            return Err(Error::Tolerance { tolerance });
        }
        // Shorter steps move nothing but the last digits, and no count of steps reaches a turn.
        if angle >= f64::EPSILON { Ok(()) } else { Err(Error::TurnVanished { tolerance, angle }) }
    }

    fn until(self, end: f64) -> Self {
        Adaptive { end, ..self }
    }
}

/// Where adaptive steps are made: the step that the scheme is prepared for.
#[derive(Clone, Debug)]
pub struct Pace<T, R, W> {
    stride: T,
    room: R,
    inner: W,
}

impl<Y: TimeScale, S: Adaptable + Scheme<Y>> Scheme<Y> for Adaptive<S> {
    const SHARE: f64 = S::SHARE;
    const SEES_ROUGH: bool = S::SEES_ROUGH;

    type Memory = AdaptiveMemory<S::Memory>;
    type Workspace = Pace<Y::Stride, Y::Room, S::Workspace>;

    fn workspace(&self, system: &Y, stride: &Y::Stride) -> Self::Workspace {
        Pace { stride: stride.clone(), room: system.room(), inner: self.scheme.workspace(system, stride) }
    }

    #[inline(always)]
    fn watch(&self, watched: bool, workspace: &mut Self::Workspace) {
        self.scheme.watch(watched, &mut workspace.inner);
    }

    /// `stride` has the longest step, which may be infinite.
    fn begin(
        &self,
        system: &Y,
        stride: &Y::Stride,
        start: &Beginning<'_, Y>,
        workspace: &mut Self::Workspace,
    ) -> Result<Self::Memory, NotConverged> {
        let longest = Y::dt(stride);
        let look = system.look(&mut workspace.room, start.t, start.q, start.v, self.angle / longest);
        let density = look.within(MIDDLE, look.rate() + 0.5 * self.row * self.angle * look.growth);
        // What the motion meets later no look at the start can tell.
        let density = if system.names_the_time() && longest.is_infinite() { 0.0 } else { density };
        let first = (self.angle / density).min(longest);
        self.set_pace(system, first, workspace);
        let inner = self.scheme.begin(system, &workspace.stride, start, &mut workspace.inner)?;
        let (time, range) = (Compensated::new(start.t), [f64::MAX, 0.0]);
        let (angle, last, dt, left, landing) = (self.angle, first, first, self.row, false);
        let mut pacing = Pacing { density, angle, last, dt, left, landing, time, range };
        self.plan(longest, &mut pacing);
        Ok(AdaptiveMemory { inner, pacing, too_long: false })
    }

    #[inline(always)]
    fn step(
        &self,
        system: &Y,
        stride: &Y::Stride,
        t: f64,
        memory: &mut Self::Memory,
        workspace: &mut Self::Workspace,
    ) -> Result<Effort, NotConverged> {
        let AdaptiveMemory { inner: memory, pacing, too_long } = memory;
        if Y::dt(&workspace.stride) != pacing.dt {
            self.set_pace(system, pacing.dt, workspace);
        }
        let Pace { stride: now, room, inner } = workspace;
        let ratio = pacing.ratio();
        let stretched = if ratio == 1.0 { 0 } else { self.scheme.stretch(system, now, t, ratio, memory, inner) };
        let mut effort = self.scheme.step(system, now, t, memory, inner)?;
        effort.evaluations += stretched;
        let longest = Y::dt(stride);
        if self.made(longest, pacing) {
            let end = pacing.time.value();
            let q = self.scheme.position(memory);
            let v = self.scheme.velocity(system, now, end, memory);
            let look = system.look(room, end, q, &v, pacing.least(longest));
            effort.evaluations += EVALUATIONS;
            *too_long = self.is_too_long(&look, pacing);
            self.looked(&look, true, pacing);
        }
        self.plan(longest, pacing);
        Ok(effort)
    }

    #[inline(always)]
    fn too_long(&self, memory: &Self::Memory) -> bool {
        memory.too_long
    }

    fn shorten(&self, stride: &Y::Stride, memory: &mut Self::Memory) -> bool {
        let AdaptiveMemory { pacing, .. } = memory;
        let may = pacing.may_shorten();
        if may {
            pacing.shorten();
            self.plan(Y::dt(stride), pacing);
        }
        may
    }

    fn within(&self, system: &Y, dt: f64, from: &Beginning<'_, Y>) -> Result<Reached<Y>, NotConverged> {
        self.scheme.within(system, dt, from)
    }

    #[inline]
    fn position<'m>(&self, memory: &'m Self::Memory) -> &'m Y::Vector {
        self.scheme.position(&memory.inner)
    }

    #[inline]
    fn velocity(&self, system: &Y, stride: &Y::Stride, t: f64, memory: &Self::Memory) -> Y::Vector {
        self.scheme.velocity(system, stride, t, &memory.inner)
    }

    #[inline]
    fn finite(&self, memory: &Self::Memory) -> bool {
        self.scheme.finite(&memory.inner)
    }

    fn kinetic_energy(&self, system: &Y, memory: &Self::Memory) -> f64 {
        self.scheme.kinetic_energy(system, &memory.inner)
    }

    fn work(&self, system: &Y, stride: &Y::Stride, before: &Self::Memory, after: &Self::Memory) -> f64 {
        self.scheme.work(system, stride, &before.inner, &after.inner)
    }

    #[inline]
    fn time(&self, _: f64, _: u64, _: f64, memory: &Self::Memory) -> f64 {
        memory.pacing.time.value()
    }

    #[inline]
    fn next_dt(&self, _: f64, memory: &Self::Memory) -> f64 {
        memory.pacing.dt
    }

    #[inline]
    fn arrived(&self, memory: &Self::Memory) -> bool {
        self.has_arrived(&memory.pacing)
    }

    #[inline]
    fn ready(&self, step: u64, AdaptiveMemory { pacing, .. }: &Self::Memory) -> Result<(), Error> {
        if pacing.moves_on() && (self.is_in_reach(pacing) || step as f64 <= MANY * self.row) || self.has_arrived(pacing)
        {
            return Ok(());
        }
        let (time, dt) = (pacing.time.value(), pacing.dt);
        Err(if dt.is_infinite() { Error::NoTimeScale { step, time } } else { Error::StepVanished { step, time, dt } })
    }

    fn kept(system: &Y, invariant: Invariant) -> Kept {
        S::kept(system, invariant)
    }

    fn rough(&self, memory: &Self::Memory) -> u64 {
        self.scheme.rough(&memory.inner)
    }

    fn range(&self, memory: &Self::Memory) -> Option<[f64; 2]> {
        Some(memory.pacing.range)
    }

    fn tell_on(&self, so_far: &Self::Memory, memory: &mut Self::Memory) {
        self.scheme.tell_on(&so_far.inner, &mut memory.inner);
        memory.pacing.range = so_far.pacing.range;
    }
}
