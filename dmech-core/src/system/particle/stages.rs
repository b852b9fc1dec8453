//! Eight stages of a particle, in registers.

use core::array::from_fn;

use dmech_scalar::{CompensatedVector, DoubleDouble, Lanes, Real};

use super::{Particle, Stride};
use crate::law::{Field, Law, Potential};
use crate::system::stages::{Eight, Nearing, Staged, Staging, Tableau, of_path, weighed};
use crate::vector::{by_component, weighted};

/// A law that can be asked for eight slopes at once: every law over `f64` that is one over eight lanes too, as those are that a
/// macro writes.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be asked for eight positions at once",
    label = "`Gauss` and `LineIntegral` ask a law for eight stages of a step side by side",
    note = "a law written by hand must hold for every scalar: `impl<R: Real> Potential<{D}, R> for {Self}` in place of `impl Potential<{D}> for {Self}`",
    note = "`Nystrom::order8()` and `Composed::order8(DiscreteGradient)` take a law over `f64` alone"
)]
pub trait AtStages<const D: usize, R: Staging>: Law<D, R> {
    /// ∇Φ − F at eight times, positions and velocities.
    fn slopes(&self, mass: R, t: R::Eight, q: [R::Eight; D], v: [R::Eight; D]) -> [R::Eight; D];
}

#[diagnostic::do_not_recommend]
impl<const D: usize, L: Law<D> + Law<D, Lanes>> AtStages<D, f64> for L {
    #[inline(always)]
    fn slopes(&self, mass: f64, t: Lanes, q: [Lanes; D], v: [Lanes; D]) -> [Lanes; D] {
        Law::<D, Lanes>::field(self, Lanes::splat(mass), t).slope(q, v)
    }
}

macro_rules! one_by_one {
    ($($real:ty)*) => {$(
        #[diagnostic::do_not_recommend]
        impl<const D: usize, L: Law<D, $real>> AtStages<D, $real> for L {
            fn slopes(&self, mass: $real, t: [$real; 8], q: [[$real; 8]; D], v: [[$real; 8]; D]) -> [[$real; 8]; D] {
                let mut slopes = [[<$real>::ZERO; 8]; D];
                for i in 0..8 {
                    let slope = self.field(mass, t[i]).slope(q.map(|q| q[i]), v.map(|v| v[i]));
                    for k in 0..D {
                        slopes[k][i] = slope[k];
                    }
                }
                slopes
            }
        }
    )*};
}

one_by_one! { f32 DoubleDouble Lanes }

/// What stays the same from sweep to sweep.
#[derive(Clone, Copy, Debug)]
pub struct Aim<const D: usize, R: Staging> {
    /// q + cᵢ h v.
    base: [R::Eight; D],
    /// v.
    v: [R; D],
    /// t + cᵢ h.
    t: R::Eight,
    /// −(h²/m) bᵢ.
    push: R::Eight,
    /// 1 over the change of a push that counts, of each coordinate.
    per_unit: [R; D],
    /// How near the sweeps are.
    nearing: Nearing<R>,
}

impl<L: AtStages<D, R>, const D: usize, R: Staging> Staged for Particle<L, D, R> {
    type Pushes = [R::Eight; D];
    type Aim = Aim<D, R>;

    const PIECEWISE: bool = L::Field::<'_>::PIECEWISE;

    fn pushes(&self, stride: &Stride<R>, slope: &[R; D]) -> [R::Eight; D] {
        let weights = R::Eight::row(&crate::scheme::tableau::GAUSS.weights);
        from_fn(|k| weights.times(R::Eight::splat(-stride.fall * slope[k])))
    }

    fn aims(&self) -> Aim<D, R> {
        let (zero, none) = (R::ZERO, R::Eight::splat(R::ZERO));
        Aim { base: [none; D], v: [zero; D], t: none, push: none, per_unit: [zero; D], nearing: Nearing::none() }
    }

    #[inline(always)]
    fn eights(pushes: &[R::Eight; D]) -> &[R::Eight] {
        pushes
    }

    #[inline(always)]
    fn eights_mut(pushes: &mut [R::Eight; D]) -> &mut [R::Eight] {
        pushes
    }

    #[inline(always)]
    fn aim(
        &self,
        tableau: &Tableau,
        stride: &Stride<R>,
        t: R,
        q: &CompensatedVector<D, R>,
        v: &CompensatedVector<D, R>,
        pushes: &[R::Eight; D],
        aim: &mut Aim<D, R>,
    ) {
        let nodes = R::Eight::row(&tableau.nodes);
        let (mut counts, mut reach, mut largest) = ([R::ZERO; D], [R::ZERO; D], R::ZERO);
        for k in 0..D {
            let drift = stride.dt * v.hi[k];
            aim.base[k] = nodes.fused(R::Eight::splat(drift), R::Eight::splat(q.hi[k]));
            let path = R::Eight::splat(of_path(drift));
            counts[k] = path.or_larger(pushes[k]).largest();
            reach[k] = q.hi[k].abs().max(drift.abs());
            largest = largest.max(counts[k]);
        }
        aim.v = v.hi;
        aim.t = nodes.fused(R::Eight::splat(stride.dt), R::Eight::splat(t));
        aim.push = R::Eight::row(&tableau.weights).times(R::Eight::splat(-stride.fall));
        aim.nearing = Nearing::begin(largest);
        for k in 0..D {
            aim.per_unit[k] = aim.nearing.per_unit(counts[k], reach[k]);
        }
    }

    #[inline(always)]
    fn sweep(&self, tableau: &Tableau, stride: &Stride<R>, aim: &mut Aim<D, R>, pushes: &mut [R::Eight; D]) -> bool {
        let (mut q, mut v) = (aim.base, aim.v.map(R::Eight::splat));
        for k in 0..D {
            q[k] = weighed(&tableau.places, pushes[k], q[k]);
        }
        if L::Field::<'_>::FORCED {
            let rate = R::Eight::splat(stride.dt.recip());
            for k in 0..D {
                let gained = weighed(&tableau.speeds, pushes[k], R::Eight::splat(R::ZERO));
                v[k] = gained.fused(rate, v[k]);
            }
        }
        let slopes = self.law.slopes(self.mass, aim.t, q, v);
        let mut change = R::Eight::splat(R::ZERO);
        for k in 0..D {
            let push = aim.push.times(slopes[k]);
            change = change.or_larger(push.minus(pushes[k]).times(R::Eight::splat(aim.per_unit[k])));
            pushes[k] = push;
        }
        aim.nearing.comes_nearer(change)
    }

    #[inline(always)]
    fn nearing(aim: &Aim<D, R>) -> &Nearing<R> {
        &aim.nearing
    }

    #[inline(always)]
    fn settle_pushes(
        tableau: &Tableau,
        stride: &Stride<R>,
        pushes: &[R::Eight; D],
        [q, v]: [&mut CompensatedVector<D, R>; 2],
    ) {
        let rests = R::Eight::row(&tableau.rests);
        let moved = by_component!(|k| {
            let pushed = rests.times(pushes[k]).sum();
            stride.dt.mul_add(v.hi[k], stride.dt.mul_add(v.lo[k], pushed))
        });
        q.add(moved);
        // A true quotient: a product with a rounded 1/h would be wrong by the same relative amount in each step.
        v.add(by_component!(|k| pushes[k].sum() / stride.dt));
    }

    fn work_of_pushes(&self, tableau: &Tableau, dt: R, v: &[R; D], pushes: &[R::Eight; D]) -> R {
        let work = by_component!(|k| {
            let gained = weighed(&tableau.working, pushes[k], R::Eight::splat(R::ZERO));
            let speed = gained.times(R::Eight::splat(dt.recip())).plus(R::Eight::splat(v[k]));
            speed.times(pushes[k]).sum() / dt
        });
        self.mass * weighted(self.law.mass_ratios(), work, [R::ONE; D])
    }
}
