//! Sweeps of motions side by side: each keeps the pushes of its own last sweep.

use dmech_scalar::{Count, Mask, Real};

use crate::newton::Counts;
use crate::system::stages::either;
use crate::system::{Staged, System};

/// Which of those that stand side by side.
pub(super) type Which<Y> = <<Y as System>::Scalar as Real>::Mask;

/// The pushes of those whose sweeps have ended, while others go on.
///
/// One motion has no use for it, and none of it is left there.
pub(super) struct Ended<Y: Staged> {
    pushes: Option<Y::Pushes>,
    which: Which<Y>,
    /// The evaluations of each.
    pub(super) evaluations: Counts<Y::Scalar>,
}

impl<Y: Staged> Ended<Y> {
    /// Whether several stand side by side. What is rare, a step in parts, is then left to each alone.
    pub(super) const MANY: bool = Which::<Y>::LANES > 1;

    /// None.
    #[inline(always)]
    pub(super) fn none() -> Self {
        Ended { pushes: None, which: Mask::of(false), evaluations: Count::of(0) }
    }

    /// With those that have ended before.
    #[inline(always)]
    pub(super) fn or(&self, which: Which<Y>) -> Which<Y> {
        if Self::MANY { which.or(self.which) } else { which }
    }

    /// Adds those that end with this sweep, by its number. Whether all have ended: the pushes are then those of the last sweep of each.
    #[inline(always)]
    pub(super) fn add(&mut self, which: Which<Y>, pushes: &mut Y::Pushes, sweep: u32) -> bool {
        if !Self::MANY {
            return which.all();
        }
        if !which.any() {
            return false;
        }
        let kept = self.pushes.get_or_insert_with(|| pushes.clone());
        for (kept, push) in Y::eights_mut(kept).iter_mut().zip(Y::eights(pushes)) {
            *kept = either(which, push, kept);
        }
        self.evaluations = which.count(Count::of(8 * sweep), self.evaluations);
        self.which = self.which.or(which);
        let all = self.which.all();
        if all {
            pushes.clone_from(kept);
        }
        all
    }
}
