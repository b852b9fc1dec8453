//! The schemes, and what a simulation needs to know of one.

mod adaptive;
mod compensated_leapfrog;
mod composed;
mod discrete_gradient;
mod explicit;
mod force_gradient;
mod guess;
mod implicit;
mod kanatani;
mod leapfrog;
mod missing;
mod name;
mod nystrom;
mod splitting;
mod stride;
mod workless;

pub use adaptive::{Adaptable, Adaptive, AdaptiveMemory};
pub use compensated_leapfrog::{CompensatedLeapfrog, CompensatedLeapfrogMemory};
pub use composed::{
    Coefficients, Composable, Composed, ComposedDiscreteGradientMemory, ComposedImplicitMemory, coefficients,
};
pub use discrete_gradient::{DiscreteGradient, DiscreteGradientMemory};
pub use explicit::{Explicit, ExplicitMemory};
pub use force_gradient::ForceGradient;
pub use guess::{Guess, Newton};
pub use implicit::{Implicit, ImplicitMemory};
pub use kanatani::{Kanatani, KanataniMemory, Start};
pub use leapfrog::{Leapfrog, LeapfrogMemory};
pub use missing::{NeverBegun, WithScheme};
pub use nystrom::Nystrom;
#[cfg(feature = "scene")]
pub(crate) use splitting::Splitting;
pub use splitting::{First, SplittingMemory};
pub use stride::Stride;
pub(crate) use stride::exact_product;

use dmech_scalar::Real;

use crate::State;
use crate::error::Error;
use crate::invariant::{Invariant, Kept};
use crate::newton::NotConverged;

/// What a scheme promises, whatever the law.
pub trait Method: Copy + core::fmt::Debug {
    /// The name in reports.
    const NAME: &'static str;
    /// The global error of the position is O(dt^ORDER).
    const ORDER: u32;
    /// A step back from the new state returns to the old one: the scheme can be composed to higher order.
    const SYMMETRIC: bool;

    /// How well the scheme keeps an invariant of the law.
    fn keeps(invariant: Invariant) -> Kept;

    /// The tolerance of an [`Adaptive`] scheme; `None` where all steps are equal.
    fn tolerance(&self) -> Option<f64> {
        None
    }

    /// The same scheme with its last step ending at the time `end`, where it chooses its steps.
    fn until(self, _end: f64) -> Self {
        self
    }
}

/// A scheme for laws of the type L in D coordinates.
///
/// A scheme is a value without state; what it carries from step to step is its [`Memory`](Scheme::Memory).
#[diagnostic::on_unimplemented(
    message = "the scheme `{Self}` cannot step the law `{L}` in {D} coordinates over `{R}`",
    note = "a scheme needs a `Law<{D}, {R}>`: write `#[dmech::law]` with a `#[potential]`, or implement `Potential<{D}>` by hand",
    note = "the number of coordinates of the law and of the state must agree"
)]
pub trait Scheme<L, const D: usize, R: Real = f64>: Method {
    /// What is carried from step to step.
    type Memory: Clone + core::fmt::Debug;

    /// Prepares the first step from a given state.
    ///
    /// # Errors
    /// [`NotConverged`] where the start itself solves an equation.
    fn begin(&self, law: &L, stride: &Stride<R>, start: &State<D, R>) -> Result<Self::Memory, NotConverged>;

    /// Advances from time t to t + dt.
    ///
    /// # Errors
    /// [`NotConverged`]; the memory is then unchanged.
    fn step(&self, law: &L, stride: &Stride<R>, t: R, memory: &mut Self::Memory) -> Result<Effort, NotConverged>;

    /// The position now.
    fn position(&self, memory: &Self::Memory) -> [R; D];

    /// The velocity now, at time t. Schemes whose velocity lives at half steps compute it when asked.
    fn velocity(&self, law: &L, stride: &Stride<R>, t: R, memory: &Self::Memory) -> [R; D];

    /// Whether everything in the memory is finite.
    fn finite(&self, memory: &Self::Memory) -> bool;

    /// The scheme's own kinetic energy, the one that its work changes.
    fn kinetic_energy(&self, law: &L, stride: &Stride<R>, memory: &Self::Memory) -> R;

    /// The work done in one step, by the scheme's own definition.
    fn work(&self, law: &L, stride: &Stride<R>, before: &Self::Memory, after: &Self::Memory) -> R;

    /// The scheme's own energy where it differs from m v²/2 + Φ(q).
    fn discrete_energy(&self, _law: &L, _stride: &Stride<R>, _t: R, _memory: &Self::Memory) -> Option<R> {
        None
    }

    /// Takes steps of another length from here on, `ratio` times those before; t is the time now. Returns the evaluations of
    /// the force that this takes.
    #[inline(always)]
    fn stretch(&self, _law: &L, _stride: &Stride<R>, _t: R, _ratio: R, _memory: &mut Self::Memory) -> u32 {
        0
    }

    /// Finds again what the memory does not carry because it follows from the length of the steps; the memory is that of a run
    /// that was saved.
    #[doc(hidden)]
    fn restore(&self, _stride: &Stride<R>, _memory: &mut Self::Memory) {}

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

    /// The shortest and the longest step so far, but for one that was shortened to land; `None` where all are equal.
    fn range(&self, _memory: &Self::Memory) -> Option<[f64; 2]> {
        None
    }
}

/// What one step cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Effort {
    /// Evaluations of the force.
    pub evaluations: u32,
    /// Newton corrections.
    pub iterations: u32,
}
