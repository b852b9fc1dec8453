//! What a step begins with, and what it costs.

use core::ops::AddAssign;

use dmech_scalar::{Count, Real};

use super::{Newton, System};
use crate::newton::Counts;

/// A kick of a splitting: b h of the force and e h³ of its change along itself, at the time t.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kick<R> {
    /// The time.
    pub t: R,
    /// Its length in steps.
    pub b: R,
    /// The coefficient of the change of the force along itself.
    pub e: f64,
}

/// The state that a scheme starts from.
#[derive(Debug)]
pub struct Beginning<'a, Y: System> {
    /// Time.
    pub t: Y::Scalar,
    /// Position.
    pub q: &'a Y::Vector,
    /// Velocity.
    pub v: &'a Y::Vector,
    /// ∇Φ − F there.
    pub slope: &'a Y::Vector,
}

/// What an implicit step starts from.
#[derive(Debug)]
pub struct Step<'a, Y: System> {
    /// Its length.
    pub stride: &'a Y::Stride,
    /// The time now.
    pub t: Y::Scalar,
    /// The position now.
    pub q: &'a Y::Sum,
    /// The velocity now.
    pub v: &'a Y::Sum,
    /// Slopes from which that of this step is guessed.
    pub ahead: Ahead<'a, Y::Vector>,
    /// Options.
    pub newton: &'a Newton,
}

/// The slope that is expected in a step.
#[derive(Debug)]
pub enum Ahead<'a, V> {
    /// Those of the last three steps, the newest first, continued by a parabola: 3S − 3S₋ + S₋₋.
    Continued([&'a V; 3]),
    /// This one.
    Expected(&'a V),
}

impl<V> Clone for Ahead<'_, V> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<V> Copy for Ahead<'_, V> {}

/// What one step cost: of several motions side by side, each of them.
#[derive(Clone, Copy, Debug, Default)]
pub struct Effort<R: Real = f64> {
    /// Evaluations of the force.
    pub evaluations: Counts<R>,
    /// Newton corrections.
    pub iterations: Counts<R>,
}

impl<R: Real> Effort<R> {
    /// So many evaluations of the force, and no corrections.
    #[inline(always)]
    pub fn of(evaluations: u32) -> Self {
        Effort { evaluations: Count::of(evaluations), iterations: Count::of(0) }
    }
}

impl<R: Real> AddAssign for Effort<R> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        self.evaluations += other.evaluations;
        self.iterations += other.iterations;
    }
}
