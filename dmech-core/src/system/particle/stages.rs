//! Eight stages of a particle, in registers.

use core::array::from_fn;
use core::hint::black_box;

use dmech_scalar::{CompensatedVector, DoubleDouble, Lanes, Mask, Real, Rows};

use super::{Particle, Stride};
use crate::law::{Field, Law};
use crate::system::stages::{self, Eight, Nearing, Part, Staged, Staging, Tableau, moves, times, weighed};
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
    /// ∇Φ − F at the times, positions and velocities of some of the stages.
    fn slopes(&self, mass: R, t: Part<R>, q: [Part<R>; D], v: [Part<R>; D]) -> [Part<R>; D];
}

#[diagnostic::do_not_recommend]
impl<const D: usize, L: Law<D> + Law<D, Lanes>> AtStages<D, f64> for L {
    #[inline(always)]
    fn slopes(&self, mass: f64, t: Lanes, q: [Lanes; D], v: [Lanes; D]) -> [Lanes; D] {
        Law::<D, Lanes>::field(self, Lanes::splat(mass), t).slope(q, v)
    }
}

macro_rules! one_by_one {
    ($($real:ty $(, $n:ident)?;)*) => {$(
        #[diagnostic::do_not_recommend]
        impl<const D: usize, L: Law<D, $real>, $(const $n: usize)?> AtStages<D, $real> for L {
            #[inline(always)]
            fn slopes(&self, mass: $real, t: $real, q: [$real; D], v: [$real; D]) -> [$real; D] {
                self.field(mass, t).slope(q, v)
            }
        }
    )*};
}

one_by_one! { f32; DoubleDouble; Lanes; Rows<N>, N; }

/// Whether pushes of several coordinates are kept in one place. Where eight numbers take several registers they do not stay in these, and
/// the compiler, which sees that nobody else knows of their memory, keeps them twice and copies them in each sweep. Steps of two to six
/// coordinates take 2 to 4 % less time with AVX2 and without; with AVX-512 it would be 1 to 7 % more, without AVX and with a force of the
/// velocity 15 %.
const fn in_one_place(forced: bool) -> bool {
    let [wide, middle] = [cfg!(target_feature = "avx512f"), cfg!(target_feature = "avx")];
    !wide && (middle || !forced)
}

/// What stays the same from sweep to sweep.
#[derive(Clone, Copy, Debug)]
pub struct Aim<const D: usize, R: Staging> {
    /// q + cᵢ h v.
    base: [R::Eight; D],
    /// v.
    speed: [R; D],
    /// Qᵢ and, where a force depends on it, Vᵢ, in this sweep.
    q: [R::Eight; D],
    v: [R::Eight; D],
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

    fn pushes(&self, stride: &Stride<R>, slope: &[R; D]) -> [R::Eight; D] {
        let weights = &crate::system::tableau::GAUSS.weights;
        from_fn(|k| times(weights, &R::Eight::splat(-stride.fall * slope[k])))
    }

    fn aims(&self) -> Aim<D, R> {
        let (zero, none) = (R::ZERO, R::Eight::splat(R::ZERO));
        let (numbers, eights) = ([zero; D], [none; D]);
        let nearing = Nearing::none();
        Aim { base: eights, speed: numbers, q: eights, v: eights, t: none, push: none, per_unit: numbers, nearing }
    }

    #[inline(always)]
    fn eights(pushes: &[R::Eight; D]) -> &[R::Eight] {
        pushes
    }

    #[inline(always)]
    fn coordinates(q: &[R; D]) -> &[R] {
        q
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
        let nodes = |part| R::Eight::row(&tableau.nodes, part);
        let alike = R::Eight::alike;
        let [mut drifts, mut reach] = [[R::ZERO; D]; 2];
        moves::<R>(stride.dt, [&q.hi, &v.hi, &v.lo], pushes, [&mut drifts, &mut aim.per_unit, &mut reach]);
        for k in 0..D {
            aim.base[k] = R::Eight::by_part(|part| nodes(part).mul_add(alike(drifts[k]), alike(q.hi[k])));
        }
        aim.speed = v.hi;
        aim.t = R::Eight::by_part(|part| nodes(part).mul_add(alike(stride.dt), alike(t)));
        aim.push = times(&tableau.weights, &R::Eight::splat(-stride.fall));
        aim.nearing = Nearing::begin(&mut aim.per_unit, &mut reach);
    }

    #[inline(always)]
    fn sweep(&self, tableau: &Tableau, stride: &Stride<R>, aim: &mut Aim<D, R>, pushes: &mut [R::Eight; D]) -> R::Mask {
        let Aim { base, speed, q, v, t, push: fall, per_unit, nearing } = aim;
        let alone = D > 1 && R::Eight::PARTS == 1 && in_one_place(L::Field::<'_>::FORCED);
        let pushes = if alone { black_box(pushes) } else { pushes };
        // All positions are those of the last pushes, also where these stand one after another.
        for part in 0..R::Eight::PARTS {
            for k in 0..D {
                q[k].set(part, weighed(&tableau.places, &pushes[k], part, base[k].part(part)));
            }
            if L::Field::<'_>::FORCED {
                let rate = R::Eight::alike(stride.dt.recip());
                for k in 0..D {
                    let gained = weighed(&tableau.speeds, &pushes[k], part, R::Eight::alike(R::ZERO));
                    v[k].set(part, gained.mul_add(rate, R::Eight::alike(speed[k])));
                }
            }
        }
        let mut nearer = R::Mask::of(false);
        for part in 0..R::Eight::PARTS {
            let at = from_fn(|k| q[k].part(part));
            let speed = from_fn(|k| if L::Field::<'_>::FORCED { v[k].part(part) } else { R::Eight::alike(speed[k]) });
            let slopes = self.law.slopes(self.mass, t.part(part), at, speed);
            let mut change = R::Eight::alike(R::ZERO);
            for k in 0..D {
                let push = fall.part(part) * slopes[k];
                let units = (push - pushes[k].part(part)) * R::Eight::alike(per_unit[k]);
                change = R::Eight::larger(change, units);
                pushes[k].set(part, push);
            }
            nearer = nearer.or(nearing.comes_nearer(part, change));
        }
        nearer
    }

    fn per_unit(aim: &Aim<D, R>) -> &[R] {
        &aim.per_unit
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
        stages::settle(tableau, stride.dt, pushes, [&mut q.hi, &mut q.lo, &mut v.hi, &mut v.lo]);
    }

    fn work_of_pushes(&self, tableau: &Tableau, dt: R, v: &[R; D], pushes: &[R::Eight; D]) -> R {
        let work = by_component!(|k| {
            let work = R::Eight::by_part(|part| {
                let gained = weighed(&tableau.working, &pushes[k], part, R::Eight::alike(R::ZERO));
                let speed = gained * R::Eight::alike(dt.recip()) + R::Eight::alike(v[k]);
                speed * pushes[k].part(part)
            });
            work.sum() / dt
        });
        self.mass * weighted(self.law.weights(), work, [R::ONE; D])
    }
}
