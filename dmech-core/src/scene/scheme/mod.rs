//! The schemes on scenes: the same formulas as for one body, over all bodies at once.

/// `Clone` whose `clone_from` copies into what is there: the derived one allocates anew, and a stepper keeps the memory
/// before each step.
macro_rules! cloned_in_place {
    ($name:ident { $($field:ident),* }) => {
        impl<const D: usize> Clone for $name<D> {
            fn clone(&self) -> Self {
                $name { $($field: self.$field.clone()),* }
            }

            fn clone_from(&mut self, other: &Self) {
                $(self.$field.clone_from(&other.$field);)*
            }
        }
    };
}

mod composed;
mod discrete_gradient;
mod explicit;
mod implicit;
mod kanatani;
mod leapfrog;
mod missing;
mod splitting;

use super::newton::Solver;
use super::setting::{Setting, System};
use super::terms::Acts;
use super::vectors::Vectors;
use crate::newton::NotConverged;
use crate::scheme::{Effort, Method};

/// The state that a scheme starts from.
#[derive(Clone, Copy, Debug)]
pub struct Start<'a, const D: usize> {
    /// Time.
    pub t: f64,
    /// Positions.
    pub q: &'a Vectors<D>,
    /// Velocities.
    pub v: &'a Vectors<D>,
    /// ∇Φ − F there.
    pub slope: &'a Vectors<D>,
}

/// A scheme for scenes in which the terms `A` act.
#[diagnostic::on_unimplemented(
    message = "scenes do not have the scheme `{Self}` yet",
    label = "not for scenes yet",
    note = "scenes have `Explicit`, `Leapfrog`, `Implicit`, `DiscreteGradient`, `Kanatani`, `Nystrom` and compositions of `Leapfrog` and `DiscreteGradient`, all in equal steps, `.dt(h)`",
    note = "in place of `CompensatedLeapfrog` use `Leapfrog`; of a `ForceGradient` a `Nystrom` of its order; of a composition of `Implicit` one of `DiscreteGradient`; of `.adaptive(tolerance)` a step that is short enough for the closest encounter"
)]
pub trait SceneScheme<const D: usize, A: Acts<D>>: Method {
    /// What is carried from step to step.
    type Memory: Clone + core::fmt::Debug;

    /// What a step works in and nothing carries on: the [`Solver`] of an implicit scheme, nothing of an explicit one.
    type Workspace: Workspace<D>;

    /// Prepares the first step.
    ///
    /// # Errors
    /// [`NotConverged`] where the start itself solves an equation.
    fn begin(
        &self,
        system: &System<D, A>,
        start: Start<'_, D>,
        workspace: &mut Self::Workspace,
    ) -> Result<Self::Memory, NotConverged>;

    /// Advances from time t to t + dt.
    ///
    /// # Errors
    /// [`NotConverged`]; the memory is then of no use.
    fn step(
        &self,
        system: &System<D, A>,
        t: f64,
        memory: &mut Self::Memory,
        workspace: &mut Self::Workspace,
    ) -> Result<Effort, NotConverged>;

    /// The positions now.
    fn position<'m>(&self, memory: &'m Self::Memory) -> &'m Vectors<D>;

    /// The velocities now, at time t.
    fn velocity(&self, system: &System<D, A>, t: f64, memory: &Self::Memory) -> Vectors<D>;

    /// Whether everything in the memory is finite.
    fn finite(&self, memory: &Self::Memory) -> bool;

    /// The scheme's own kinetic energy, the one that its work changes.
    fn kinetic_energy(&self, setting: &Setting<D>, memory: &Self::Memory) -> f64;

    /// The work done in one step, by the scheme's own definition.
    fn work(&self, setting: &Setting<D>, before: &Self::Memory, after: &Self::Memory) -> f64;

    /// The scheme's own energy where it differs from Σ m v²/2 + Φ(q).
    fn discrete_energy(&self, _system: &System<D, A>, _t: f64, _memory: &Self::Memory) -> Option<f64> {
        None
    }
}

/// Where a scheme works, allocated once: the Newton matrix, of N² numbers where any two bodies are linked, comes with it.
pub trait Workspace<const D: usize>: Clone + core::fmt::Debug {
    /// For a number of bodies and what acts on them.
    fn new<A: Acts<D>>(bodies: usize, acts: &A) -> Self;
}

/// An explicit scheme takes what it needs from its memory.
impl<const D: usize> Workspace<D> for () {
    fn new<A: Acts<D>>(_: usize, _: &A) {}
}

impl<const D: usize> Workspace<D> for Solver<D> {
    fn new<A: Acts<D>>(bodies: usize, acts: &A) -> Self {
        Solver::for_links(bodies, &acts.links(bodies))
    }
}

/// Makes `newest` the first of three, and forgets the last.
fn shift<const D: usize>(gradients: &mut [Vectors<D>; 3], newest: &mut Vectors<D>) {
    gradients.rotate_right(1);
    core::mem::swap(&mut gradients[0], newest);
}
