//! Who acts on whom among few bodies.

use core::fmt::Debug;

use dmech_scalar::{Mask, Real};

use super::links::{Here, Presence};

/// Who acts on whom among few bodies, [`Mutual`] or [`Restricted`]: by the type, so that steps without test bodies have nothing of them.
/// One branch for each force, never taken and by a number that is there anyway, took leap-frog of three bodies 45 % more instructions alone
/// and 32 % side by side.
pub trait Sides: Copy + Debug + Send + Sync + 'static {
    /// Every body acts on all others, and counts in all sums.
    const MUTUAL: bool;
    /// Which of N bodies act.
    type WhoActs<const N: usize, R: Real>: WhoActs<R>;

    /// Which of the bodies act: those that count by a mass, and not by 0.
    fn acting<const N: usize, R: Real>(weights: &[R; N]) -> Self::WhoActs<N, R>;
}

/// Every body acts on all others: what [`Scene::as_law`](crate::Scene::as_law) makes.
#[derive(Clone, Copy, Debug)]
pub enum Mutual {}

/// Some may be test bodies, as in the restricted problem of three bodies: what
/// [`Scene::as_restricted_law`](crate::Scene::as_restricted_law) makes.
#[derive(Clone, Copy, Debug)]
pub enum Restricted {}

/// Which of few bodies act on others, in the lanes of a scalar.
pub trait WhoActs<R: Real>: Copy {
    /// Where a link is there and one of its bodies acts.
    type Where<T: Presence<R>>: Presence<R>;

    /// Where the link is there and body i acts.
    fn acts<T: Presence<R>>(&self, i: usize, link: T) -> Self::Where<T>;
}

impl Sides for Mutual {
    const MUTUAL: bool = true;
    type WhoActs<const N: usize, R: Real> = All;

    #[inline(always)]
    fn acting<const N: usize, R: Real>(_: &[R; N]) -> All {
        All
    }
}

impl Sides for Restricted {
    const MUTUAL: bool = false;
    type WhoActs<const N: usize, R: Real> = Those<N, R>;

    #[inline(always)]
    fn acting<const N: usize, R: Real>(weights: &[R; N]) -> Those<N, R> {
        Those(weights.map(|weight| weight.equal(R::ZERO).not()))
    }
}

/// All of them, which costs nothing.
#[derive(Clone, Copy)]
pub struct All;

impl<R: Real> WhoActs<R> for All {
    type Where<T: Presence<R>> = T;

    #[inline(always)]
    fn acts<T: Presence<R>>(&self, _: usize, link: T) -> T {
        link
    }
}

/// Each in some lanes.
#[derive(Clone, Copy)]
pub struct Those<const N: usize, R: Real>([R::Mask; N]);

impl<const N: usize, R: Real> WhoActs<R> for Those<N, R> {
    type Where<T: Presence<R>> = Here<R>;

    #[inline(always)]
    fn acts<T: Presence<R>>(&self, i: usize, link: T) -> Here<R> {
        link.within(self.0[i])
    }
}
