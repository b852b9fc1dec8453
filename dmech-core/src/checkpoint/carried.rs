//! What a scheme carries, number by number.

use super::{Difference, Numbers};

/// The numbers that a scheme carries from step to step: what a checkpoint saves of its memory.
pub trait Carried: Clone {
    /// All of them, always in the same order. What a step computes before it reads it need not be among them.
    fn carried(&mut self) -> Vec<&mut [f64]>;
}

/// A copy of what a scheme carries.
pub(crate) fn save(memory: &impl Carried) -> Vec<Numbers> {
    memory.clone().carried().into_iter().map(|numbers| Numbers(numbers.to_vec())).collect()
}

/// Replaces what a scheme carries.
pub(crate) fn load(memory: &mut impl Carried, saved: &[Numbers]) -> Result<(), Difference> {
    memory.carried().into_iter().zip(saved).try_for_each(|(place, numbers)| numbers.copy_to(place))
}
