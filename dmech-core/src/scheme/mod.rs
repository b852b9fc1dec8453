//! The schemes, and what a simulation needs to know of one.

mod adaptive;
mod boris;
mod by_lane;
mod compensated_leapfrog;
mod composed;
mod discrete_gradient;
mod explicit;
mod force_gradient;
mod gauss;
mod implicit;
mod kanatani;
mod leapfrog;
mod memory;
mod missing;
mod nystrom;
mod one_solve;
mod relaxed;
mod runge_kutta_nystrom;
mod set;
mod splitting;

pub(crate) use adaptive::Pacing;
pub use adaptive::{Adaptable, Adaptive, AdaptiveMemory};
pub use boris::Boris;
pub use by_lane::ByLane;
pub use compensated_leapfrog::{CompensatedLeapfrog, CompensatedLeapfrogMemory};
pub use composed::{
    Coefficients, Composable, Composed, OneStep, StagesMemory, Steps, StepsMemory, StepsRoom, coefficients,
};
pub use discrete_gradient::DiscreteGradient;
pub use explicit::{Explicit, ExplicitMemory};
pub use force_gradient::ForceGradient;
pub use gauss::{Gauss, GaussMemory, LineIntegral};
pub use implicit::Implicit;
pub use kanatani::{Kanatani, KanataniMemory, Start};
pub use leapfrog::Leapfrog;
pub use missing::{NeverBegun, NoScheme, WithScheme};
pub use nystrom::Nystrom;
pub use one_solve::{Begun, OneSolveMemory, Stage};
pub use relaxed::{Relaxed, RelaxedMemory, RelaxedRoom};
pub use runge_kutta_nystrom::{RungeKuttaNystrom, RungeKuttaNystromMemory, RungeKuttaNystromStages};
pub use splitting::{First, SplittingMemory};

use crate::error::Error;
use crate::invariant::{Invariant, Kept};
pub use crate::method::Method;
use crate::newton::NotConverged;
use crate::system::{Beginning, ImplicitSteps, System};
pub use crate::system::{Effort, Guess, LinearVelocities, Newton, WithoutVelocities};

/// A scheme for systems of the type Y: one law, or the bodies of a scene. It is a program over the instructions of [`System`].
///
/// A scheme is a value without state; what it carries from step to step is its [`Memory`](Scheme::Memory).
#[diagnostic::on_unimplemented(
    message = "the scheme `{Self}` cannot step `{Y}`",
    note = "the number of coordinates of the law and of the state must agree",
    note = "stages of a composition are those that step the law: `Leapfrog` where no force depends on the velocity, `Boris` where it is linear in it, `DiscreteGradient` and `Implicit` always"
)]
pub trait Scheme<Y: System>: Method {
    /// The share of h²/m that the unknown force has in the equation of a step; 0 if there is none.
    const SHARE: f64 = 0.0;

    /// Whether something has to be done where steps change their length: [`stretch`](Scheme::stretch).
    const STRETCHES: bool = true;

    /// Whether [watched](Scheme::watch) steps are looked at for bends and jumps: [`rough`](Scheme::rough).
    const SEES_ROUGH: bool = false;

    /// Every step evaluates the force as often as any other, and solves no equation: what several cost is said by one of them.
    const ALIKE: bool = false;

    /// What is carried from step to step.
    type Memory: Clone + core::fmt::Debug;

    /// What a step works in and nothing carries on.
    type Workspace: Clone + core::fmt::Debug;

    /// Room to work in, for steps of a length.
    fn workspace(&self, system: &Y, stride: &Y::Stride) -> Self::Workspace;

    /// Prepares the workspace for steps of another length.
    #[inline(always)]
    fn pace(&self, _system: &Y, _stride: &Y::Stride, _workspace: &mut Self::Workspace) {}

    /// Whether somebody asks for the [work](Scheme::work) of the steps to come: a run does, steps in a row do not.
    #[inline(always)]
    fn watch(&self, _watched: bool, _workspace: &mut Self::Workspace) {}

    /// Prepares the first step from a given state.
    ///
    /// # Errors
    /// [`NotConverged`] where the start itself solves an equation.
    fn begin(
        &self,
        system: &Y,
        stride: &Y::Stride,
        start: &Beginning<'_, Y>,
        workspace: &mut Self::Workspace,
    ) -> Result<Self::Memory, NotConverged>;

    /// Advances from time t to t + dt.
    ///
    /// # Errors
    /// [`NotConverged`]; the memory is then of no use.
    fn step(
        &self,
        system: &Y,
        stride: &Y::Stride,
        t: Y::Scalar,
        memory: &mut Self::Memory,
        workspace: &mut Self::Workspace,
    ) -> Result<Effort<Y::Scalar>, NotConverged>;

    /// Whether the step that has led here was too long, and is to be made again by a [shorter](Scheme::shorten) one.
    fn too_long(&self, _memory: &Self::Memory) -> bool {
        false
    }

    /// Makes the next step a shorter one, if there is one: it is made in place of one that was too long, or had no solution.
    fn shorten(&self, _stride: &Y::Stride, _memory: &mut Self::Memory) -> bool {
        false
    }

    /// Position and velocity after a single step of length dt from a state, and what it costs: what lies between two steps, at the
    /// order of the scheme.
    ///
    /// # Errors
    /// [`NotConverged`]
    fn within(&self, system: &Y, dt: Y::Scalar, from: &Beginning<'_, Y>) -> Result<Reached<Y>, NotConverged> {
        single_step(self, system, dt, from)
    }

    /// The position now.
    fn position<'m>(&self, memory: &'m Self::Memory) -> &'m Y::Vector;

    /// The velocity now, at time t. Schemes whose velocity lives at half steps compute it when asked.
    fn velocity(&self, system: &Y, stride: &Y::Stride, t: Y::Scalar, memory: &Self::Memory) -> Y::Vector;

    /// Whether everything in the memory is finite.
    fn finite(&self, memory: &Self::Memory) -> bool;

    /// The scheme's own kinetic energy, the one that its work changes.
    fn kinetic_energy(&self, system: &Y, memory: &Self::Memory) -> Y::Scalar;

    /// The work done in one step, by the scheme's own definition.
    fn work(&self, system: &Y, stride: &Y::Stride, before: &Self::Memory, after: &Self::Memory) -> Y::Scalar;

    /// The scheme's own energy where it differs from m v²/2 + Φ(q).
    fn discrete_energy(&self, _system: &Y, _t: Y::Scalar, _memory: &Self::Memory) -> Option<Y::Scalar> {
        None
    }

    /// Takes steps of another length from here on, `ratio` times those before; t is the time now. `stride` is that of the steps to
    /// come, for which [`pace`](Scheme::pace) was called before. Returns the evaluations of the force that this takes.
    #[inline(always)]
    fn stretch(
        &self,
        _system: &Y,
        _stride: &Y::Stride,
        _t: Y::Scalar,
        _ratio: Y::Scalar,
        _memory: &mut Self::Memory,
        _workspace: &mut Self::Workspace,
    ) -> u32 {
        0
    }

    /// The time after so many steps from `start`: t₀ + k h, unless the scheme chooses its steps.
    #[inline(always)]
    fn time(&self, start: f64, steps: u64, dt: f64, _memory: &Self::Memory) -> f64 {
        start + steps as f64 * dt
    }

    /// The length of the next step: dt, unless the scheme chooses its steps.
    #[inline(always)]
    fn next_dt(&self, dt: f64, _memory: &Self::Memory) -> f64 {
        dt
    }

    /// Whether the end of [`Method::until`] is reached.
    #[inline(always)]
    fn arrived(&self, _memory: &Self::Memory) -> bool {
        false
    }

    /// Whether there is a next step, `step` by number.
    ///
    /// # Errors
    /// [`Error::NoTimeScale`], [`Error::StepVanished`] where the scheme chooses its steps and cannot.
    #[inline(always)]
    fn ready(&self, _step: u64, _memory: &Self::Memory) -> Result<(), Error> {
        Ok(())
    }

    /// How well a system's invariant is kept: as [`Method::keeps`] has it, unless that depends on what acts.
    fn kept(_system: &Y, invariant: Invariant) -> Kept {
        Self::keeps(invariant)
    }

    /// Steps that were made in parts, or in which a force bent or jumped: [`Report::rough`](crate::Report::rough).
    fn rough(&self, _memory: &Self::Memory) -> u64 {
        0
    }

    /// The shortest and the longest step so far, but for one that was shortened to land; `None` where all are equal.
    fn range(&self, _memory: &Self::Memory) -> Option<[f64; 2]> {
        None
    }

    /// Takes over what [`rough`](Scheme::rough) and [`range`](Scheme::range) tell, where a motion begins anew that has come so far.
    fn tell_on(&self, _so_far: &Self::Memory, _memory: &mut Self::Memory) {}
}

/// Position and velocity, and what it has cost to come there.
pub type Reached<Y> = ([<Y as System>::Vector; 2], Effort<<Y as System>::Scalar>);

/// Position and velocity after one step from a state, with nothing that was carried to it.
fn single_step<Y: System, S: Scheme<Y>>(
    scheme: &S,
    system: &Y,
    dt: Y::Scalar,
    from: &Beginning<'_, Y>,
) -> Result<Reached<Y>, NotConverged> {
    let stride = system.stride(dt, S::SHARE);
    let mut workspace = scheme.workspace(system, &stride);
    let mut memory = scheme.begin(system, &stride, from, &mut workspace)?;
    match scheme.step(system, &stride, from.t, &mut memory, &mut workspace) {
        Ok(effort) => {
            let v = scheme.velocity(system, &stride, from.t + dt, &memory);
            Ok(([scheme.position(&memory).clone(), v], effort))
        }
        Err(cause) => Err(cause),
    }
}

/// The same slope so many times: what the first steps are guessed from.
fn alike<V: Clone, const N: usize>(slope: &V) -> [V; N] {
    core::array::from_fn(|_| slope.clone())
}

/// Makes the slope that was found the newest of three, and forgets the oldest.
#[inline(always)]
fn remember<Y: ImplicitSteps>(solver: &mut Y::Solver, found: &Y::Found, slopes: &mut [Y::Vector; 3]) {
    slopes.swap(1, 2);
    slopes.swap(0, 1);
    Y::keep(solver, found, &mut slopes[0]);
}
