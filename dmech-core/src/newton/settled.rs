//! Equations side by side: each keeps the solution of its own last correction.

use dmech_scalar::{Count, Mask, Real};

use super::Increment;

/// The solutions of the lanes that have settled.
///
/// One number has no use for it, and none of it is left there: it settles, and is returned.
pub(super) struct Settled<const D: usize, R: Real> {
    found: Increment<D, R>,
    which: R::Mask,
}

impl<const D: usize, R: Real> Settled<D, R> {
    /// Whether several equations are solved side by side. What is rare, a longer way to the root, is then left to each alone.
    pub(super) const MANY: bool = R::Mask::LANES > 1;

    /// No lane.
    #[inline(always)]
    pub(super) fn none() -> Self {
        let (zero, none) = ([R::ZERO; D], Count::of(0));
        let found = Increment { delta: zero, gradient: zero, parts: [zero; 2], evaluations: none, iterations: none };
        Settled { found, which: Mask::of(false) }
    }

    /// With those that have settled before.
    #[inline(always)]
    pub(super) fn or(&self, which: R::Mask) -> R::Mask {
        if Self::MANY { which.or(self.which) } else { which }
    }

    /// Adds those that settle at `next`; all of them, if they are.
    #[inline(always)]
    pub(super) fn add(&mut self, settled: R::Mask, next: Increment<D, R>) -> Option<Increment<D, R>> {
        if !Self::MANY {
            return settled.all().then_some(next);
        }
        self.found = Increment::either(self.which, self.found, next);
        self.which = self.which.or(settled);
        self.which.all().then_some(self.found)
    }
}
