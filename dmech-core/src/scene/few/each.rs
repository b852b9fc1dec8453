//! A law on each of few bodies.

use core::array::from_fn;

use dmech_scalar::Real;

use super::Of;
use super::among::{Among, AmongFew, Places};
use super::links::{Always, Presence};
use super::sides::{Sides, WhoActs};
use super::sums::{add, add_block, moving};
use crate::law::{Field, Fields, Numbers, Potential};
use crate::look::{Course, Frequency, Stiffness};
use crate::scene::terms::{EachReady, List, OfBodies, One};

/// Laws on each of N bodies as numbers, so that those of many members may stand side by side.
pub trait OfFewBodies<const D: usize, const N: usize>: OfBodies<Law: Fields<D>> {
    /// Of all of them.
    type Numbers: Numbers;

    /// What is read of the laws.
    fn numbers(&self) -> Self::Numbers;
    /// The names of these numbers, in their order.
    fn names(see: &mut dyn FnMut(&'static str));
    /// Those of the law on body i.
    fn on<R: Real>(numbers: &Of<Self::Numbers, R>, i: usize) -> Of<<Self::Law as Fields<D>>::Numbers, R>;
}

impl<const D: usize, const N: usize, X: Fields<D>> OfFewBodies<D, N> for One<X> {
    type Numbers = X::Numbers;

    fn numbers(&self) -> X::Numbers {
        self.0.numbers()
    }
    fn names(see: &mut dyn FnMut(&'static str)) {
        X::names(see);
    }
    #[inline(always)]
    fn on<R: Real>(numbers: &Of<X::Numbers, R>, _: usize) -> Of<X::Numbers, R> {
        *numbers
    }
}

impl<const D: usize, const N: usize, X: Fields<D>> OfFewBodies<D, N> for List<X> {
    type Numbers = [X::Numbers; N];

    fn numbers(&self) -> [X::Numbers; N] {
        from_fn(|i| self.of(i).numbers())
    }
    fn names(see: &mut dyn FnMut(&'static str)) {
        (0..N).for_each(|_| X::names(see));
    }
    #[inline(always)]
    fn on<R: Real>(numbers: &[Of<X::Numbers, R>; N], i: usize) -> Of<X::Numbers, R> {
        numbers[i]
    }
}

impl<const D: usize, const N: usize, S: Sides, L: OfFewBodies<D, N>> AmongFew<D, N, S> for EachReady<L> {
    type Numbers = (L::Numbers, [f64; N]);
    type Moment<R: Real> = OnEachOfFew<L, S::WhoActs<N, R>, D, N, R>;

    fn numbers(&self) -> Self::Numbers {
        (self.laws.numbers(), from_fn(|i| self.masses[i]))
    }
    fn names(see: &mut dyn FnMut(&'static str)) {
        L::names(see);
        (0..N).for_each(|_| see("masses"));
    }
    #[inline(always)]
    fn moment<R: Real>((laws, masses): (Of<L::Numbers, R>, [R; N]), acting: S::WhoActs<N, R>, t: R) -> Self::Moment<R> {
        OnEachOfFew { laws, masses, acting, t }
    }
}

/// A law on each body at one moment.
pub struct OnEachOfFew<L: OfFewBodies<D, N>, W, const D: usize, const N: usize, R: Real> {
    laws: Of<L::Numbers, R>,
    masses: [R; N],
    acting: W,
    t: R,
}

/// What acts on a body at one moment.
type OnOne<L, const D: usize, R> = <<L as OfBodies>::Law as Fields<D>>::Moment<R>;

impl<L: OfFewBodies<D, N>, W, const D: usize, const N: usize, R: Real> OnEachOfFew<L, W, D, N, R> {
    #[inline(always)]
    fn on(&self, i: usize) -> OnOne<L, D, R> {
        <L::Law as Fields<D>>::moment(L::on(&self.laws, i), self.masses[i], self.t)
    }
}

impl<L: OfFewBodies<D, N>, W: WhoActs<R>, const D: usize, const N: usize, R: Real> Among<D, N, R>
    for OnEachOfFew<L, W, D, N, R>
{
    #[inline(always)]
    fn potential(&self, q: &Places<D, N, R>) -> R {
        let counted = |i, sum| self.acting.acts(i, Always).choose(sum + self.on(i).potential(q[i]), sum);
        (0..N).fold(R::ZERO, |sum, i| counted(i, sum))
    }
    #[inline(always)]
    fn add_gradient(&self, q: &Places<D, N, R>, out: &mut Places<D, N, R>) {
        for i in 0..N {
            add(&mut out[i], self.on(i).gradient(q[i]), Always);
        }
    }
    #[inline(always)]
    fn add_hessian<const K: usize>(&self, q: &Places<D, N, R>, out: &mut [[R; K]; K]) {
        for i in 0..N {
            add_block(out, [i, i], &self.on(i).hessian(q[i]), Always);
        }
    }
    #[inline(always)]
    fn add_discrete_gradient(&self, a: &Places<D, N, R>, b: &Places<D, N, R>, out: &mut Places<D, N, R>) {
        for i in 0..N {
            add(&mut out[i], self.on(i).discrete_gradient(a[i], b[i]), Always);
        }
    }
    #[inline(always)]
    fn add_discrete_jacobian<const K: usize>(&self, a: &Places<D, N, R>, b: &Places<D, N, R>, out: &mut [[R; K]; K]) {
        for i in 0..N {
            add_block(out, [i, i], &self.on(i).discrete_gradient_jacobian(a[i], b[i]), Always);
        }
    }
    #[inline(always)]
    fn add_force(&self, q: &Places<D, N, R>, v: &Places<D, N, R>, t: R, out: &mut Places<D, N, R>) {
        if OnOne::<L, D, R>::FORCED {
            for i in 0..N {
                add(&mut out[i], self.on(i).force(q[i], v[i], t), Always);
            }
        }
    }
    #[inline(always)]
    fn add_force_jacobians<const K: usize>(
        &self,
        q: &Places<D, N, R>,
        v: &Places<D, N, R>,
        t: R,
        [by_q, by_v]: [&mut [[R; K]; K]; 2],
    ) {
        if OnOne::<L, D, R>::FORCED {
            for i in 0..N {
                add_block(by_q, [i, i], &self.on(i).force_dq(q[i], v[i], t), Always);
                add_block(by_v, [i, i], &self.on(i).force_dv(q[i], v[i], t), Always);
            }
        }
    }
    fn frequency(&self, from_now: &impl Fn(R) -> Option<Self>, t: R, bodies: &[Course<D, R>; N]) -> Frequency<R> {
        (0..N).fold(Frequency::none(bodies[0].least), |all, i| {
            let mass = bodies[i].per_mass.recip();
            let of = |s, q, v| from_now(s).map_or(Stiffness::NONE, |now| Stiffness::of(&now.on(i), mass, t + s, q, v));
            moving(bodies[i].per_mass, all, || Frequency::of(bodies[i], of))
        })
    }
}
