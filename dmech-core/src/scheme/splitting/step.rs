//! A step of drifts and kicks.

use dmech_scalar::Real;

use super::{First, Splitting, digits};
use crate::State;
use crate::law::{Field, Law};
use crate::scheme::{Effort, Stride};
use crate::vector::{add_scaled, difference, finite, scaled, sum, weighted};

/// What a scheme of drifts and kicks carries.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SplittingMemory<const D: usize, R = f64> {
    /// Position.
    pub q: [R; D],
    /// Velocity before the kick that belongs half to the step that ends; the velocity now where a step ends with a drift.
    pub v_before: [R; D],
    /// Velocity after it.
    pub v_after: [R; D],
    /// Work of the last step.
    work: R,
}

#[cfg(feature = "serde")]
impl<const D: usize> crate::checkpoint::Carried for SplittingMemory<D> {
    fn carried(&mut self) -> Vec<&mut [f64]> {
        vec![&mut self.q, &mut self.v_before, &mut self.v_after]
    }
}

impl<const D: usize, R: Real> SplittingMemory<D, R> {
    /// From a state.
    pub(crate) fn new<S, L, const N: usize>(law: &L, stride: &Stride<R>, start: &State<D, R>) -> Self
    where
        S: Splitting<N>,
        L: Law<D, R>,
    {
        let State { t, q, v } = *start;
        if matches!(S::FIRST, First::Drift) {
            return SplittingMemory { q, v_before: v, v_after: v, work: R::ZERO };
        }
        let field = law.field(stride.mass, R::from_f64(t));
        let b = digits::<R>(S::KICKS[0], S::KICKS_LOW[0]);
        let kicked = |sign: f64| kick(&field, stride, R::from_f64(sign) * b, sign * S::GRADIENTS[0], q, v);
        SplittingMemory { q, v_before: kicked(-1.0), v_after: kicked(1.0), work: R::ZERO }
    }

    /// One step from time t.
    #[inline(always)]
    pub(crate) fn advance<S, L, const N: usize>(&mut self, law: &L, stride: &Stride<R>, t: R) -> Effort
    where
        S: Splitting<N>,
        L: Law<D, R>,
    {
        let SplittingMemory { mut q, mut v_before, mut v_after, .. } = *self;
        let mut work = R::ZERO;
        // A kick does the work F·(mean velocity) in its time.
        let of_kick = |before, after| weighted(law.mass_ratios(), difference(after, before), sum(after, before));
        for k in 0..N {
            // Of the kick before this drift; before the first drift of a step that begins with one both are the same.
            work += of_kick(v_before, v_after);
            q = add_scaled(q, digits::<R>(S::DRIFTS[k], S::DRIFTS_LOW[k]) * stride.dt, v_after);
            let now = R::from_f64(S::ENDS[k]).mul_add(stride.dt, t);
            v_before = v_after;
            let field = law.field(stride.mass, now);
            let b = digits(S::JOINED[k], S::JOINED_LOW[k]);
            v_after = kick(&field, stride, b, S::JOINED_GRADIENTS[k], q, v_before);
        }
        if matches!(S::FIRST, First::Drift) {
            work += of_kick(v_before, v_after);
            q = add_scaled(q, digits::<R>(S::DRIFTS[0], S::DRIFTS_LOW[0]) * stride.dt, v_after);
            v_before = v_after;
        }
        work *= R::from_f64(0.5) * stride.mass;
        *self = SplittingMemory { q, v_before, v_after, work };
        Effort { evaluations: N as u32, iterations: 0 }
    }

    /// Steps of another length from here on: of the kick that two steps share, the second half is theirs.
    #[inline(always)]
    pub(crate) fn stretch<S, L, const N: usize>(&mut self, law: &L, stride: &Stride<R>, t: R) -> u32
    where
        S: Splitting<N>,
        L: Law<D, R>,
    {
        if matches!(S::FIRST, First::Drift) {
            return 0;
        }
        let field = law.field(stride.mass, t);
        let b = digits(S::KICKS[0], S::KICKS_LOW[0]);
        self.v_after = kick(&field, stride, b, S::GRADIENTS[0], self.q, self.velocity());
        1
    }

    /// The mean of the velocities around the last kick: half of it belongs to the step that ends.
    #[inline]
    pub(crate) fn velocity(&self) -> [R; D] {
        // Halves first: the sum of two finite velocities need not be finite.
        let half = R::from_f64(0.5);
        sum(scaled(half, self.v_before), scaled(half, self.v_after))
    }

    #[inline]
    pub(crate) fn finite(&self) -> bool {
        finite(self.q) && finite(self.v_after)
    }

    pub(crate) fn work(&self) -> R {
        self.work
    }
}

/// v + b h a + e h³ a′a, at one position.
#[inline(always)]
fn kick<F: Field<D, R>, const D: usize, R: Real>(
    field: &F,
    stride: &Stride<R>,
    b: R,
    e: f64,
    q: [R; D],
    v: [R; D],
) -> [R; D] {
    let c = b * stride.kick;
    if e == 0.0 {
        return field.kick(c, q, v);
    }
    field.gradient_kick(c, R::from_f64(e) * stride.dt * stride.kick * stride.kick, q, v)
}
