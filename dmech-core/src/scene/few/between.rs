//! A law between few bodies.

use core::array::from_fn;
use core::marker::PhantomData;

use dmech_scalar::{Mask, Real};

use super::Of;
use super::among::{Among, AmongFew, Places};
use super::links::{LinksOfFew, Presence};
use super::sides::{Sides, WhoActs};
use super::sums::{add, add_block, add_link, add_opposite, moving};
use crate::law::{Between, Numbers, PairFields, Potential, Reads};
use crate::look::{Course, Frequency, Stiffness};
use crate::scene::space::{Images, SpaceOfFew};
use crate::scene::terms::{Acts, LinkedReady, Way, link_stiffness};
use crate::vector::{by_entry, difference};

impl<const D: usize, const N: usize, S: Sides, P, X: PairFields<D, P>, T: LinksOfFew, B: SpaceOfFew<D>>
    AmongFew<D, N, S> for LinkedReady<X, T, P, B>
where
    Self: Acts<D>,
{
    type Numbers = ((X::Fields, [<X as Reads<P>>::Numbers; N]), (T::Numbers<N>, B::Numbers));
    type Moment<R: Real> = BetweenFew<X, T, P, B, S::WhoActs<N, R>, D, N, R>;

    fn numbers(&self) -> Self::Numbers {
        ((self.law.fields(), from_fn(|i| self.numbers.of_body(i))), (self.links.numbers(), self.space.numbers()))
    }
    fn names(see: &mut dyn FnMut(&'static str)) {
        X::names(see);
        (0..<[<X as Reads<P>>::Numbers; N]>::COUNT).for_each(|_| see("bodies"));
        (0..T::Numbers::<N>::COUNT).for_each(|_| see("bonds"));
        B::names(see);
    }
    #[inline(always)]
    fn moment<R: Real>(
        ((law, bodies), (links, space)): Of<Self::Numbers, R>,
        acting: S::WhoActs<N, R>,
        t: R,
    ) -> Self::Moment<R> {
        BetweenFew { law, bodies, links, acting, space: B::of(space), t, data: PhantomData }
    }
}

/// A law along links at one moment.
pub struct BetweenFew<
    X: PairFields<D, P>,
    T: LinksOfFew,
    P,
    B: SpaceOfFew<D>,
    W,
    const D: usize,
    const N: usize,
    R: Real,
> {
    law: Of<X::Fields, R>,
    bodies: [Of<<X as Reads<P>>::Numbers, R>; N],
    links: Of<T::Numbers<N>, R>,
    acting: W,
    space: B::In<R>,
    t: R,
    data: PhantomData<fn() -> P>,
}

impl<X: PairFields<D, P>, T: LinksOfFew, P, B: SpaceOfFew<D>, W: WhoActs<R>, const D: usize, const N: usize, R: Real>
    BetweenFew<X, T, P, B, W, D, N, R>
{
    #[inline(always)]
    fn between(&self, a: usize, b: usize, t: R) -> X::Moment<R> {
        X::moment(self.law, self.bodies[a], self.bodies[b], t)
    }

    /// q_a − q_b as the space has it.
    #[inline(always)]
    fn apart(&self, q: &Places<D, N, R>, a: usize, b: usize) -> [R; D] {
        self.space.nearest(difference(q[a], q[b]))
    }

    /// Visits every link that somebody feels, with where each of its two bodies does.
    #[inline(always)]
    fn visit(&self, mut visit: impl FnMut(usize, usize, [W::Where<T::Presence<R>>; 2])) {
        T::visit::<N, R>(&self.links, |a, b, link| {
            let felt = [b, a].map(|by| self.acting.acts(by, link));
            if felt[0].or(felt[1]).anywhere() {
                visit(a, b, felt);
            }
        });
    }
}

impl<X: PairFields<D, P>, T: LinksOfFew, P, B: SpaceOfFew<D>, W: WhoActs<R>, const D: usize, const N: usize, R: Real>
    Among<D, N, R> for BetweenFew<X, T, P, B, W, D, N, R>
{
    #[inline(always)]
    fn potential(&self, q: &Places<D, N, R>) -> R {
        let mut sum = R::ZERO;
        self.visit(|a, b, [on_a, on_b]| {
            // The energy is that of the bodies that act.
            sum = on_a.and(on_b).choose(sum + self.between(a, b, self.t).potential(self.apart(q, a, b)), sum);
        });
        sum
    }
    #[inline(always)]
    fn add_gradient(&self, q: &Places<D, N, R>, out: &mut Places<D, N, R>) {
        if X::Moment::<R>::POTENTIAL {
            self.visit(|a, b, felt| {
                add_opposite(out, [a, b], self.between(a, b, self.t).gradient(self.apart(q, a, b)), felt);
            });
        }
    }
    #[inline(always)]
    fn add_hessian<const K: usize>(&self, q: &Places<D, N, R>, out: &mut [[R; K]; K]) {
        if X::Moment::<R>::POTENTIAL {
            self.visit(|a, b, felt| {
                add_link(out, [a, b], self.between(a, b, self.t).hessian(self.apart(q, a, b)), felt);
            });
        }
    }
    #[inline(always)]
    fn add_discrete_gradient(&self, from: &Places<D, N, R>, to: &Places<D, N, R>, out: &mut Places<D, N, R>) {
        if X::Moment::<R>::POTENTIAL {
            self.visit(|a, b, felt| {
                let (from, to) = (difference(from[a], from[b]), difference(to[a], to[b]));
                let way = Way::new(&self.space, from, to);
                add_opposite(out, [a, b], way.discrete_gradient(&self.between(a, b, self.t)), felt);
            });
        }
    }
    #[inline(always)]
    fn add_discrete_jacobian<const K: usize>(
        &self,
        from: &Places<D, N, R>,
        to: &Places<D, N, R>,
        out: &mut [[R; K]; K],
    ) {
        if X::Moment::<R>::POTENTIAL {
            self.visit(|a, b, felt| {
                let (from, to) = (difference(from[a], from[b]), difference(to[a], to[b]));
                let way = Way::new(&self.space, from, to);
                add_link(out, [a, b], way.discrete_gradient_jacobian(&self.between(a, b, self.t)), felt);
            });
        }
    }
    #[inline(always)]
    fn add_force(&self, q: &Places<D, N, R>, v: &Places<D, N, R>, t: R, out: &mut Places<D, N, R>) {
        if X::Moment::<R>::FORCED {
            self.visit(|a, b, felt| {
                let force = |a: usize, b: usize| self.between(a, b, t).force(self.apart(q, a, b), v[a], v[b]);
                let on_a = force(a, b);
                if X::Moment::<R>::RECIPROCAL {
                    add_opposite(out, [a, b], on_a, felt);
                } else {
                    add(&mut out[a], on_a, felt[0]);
                    add(&mut out[b], force(b, a), felt[1]);
                }
            });
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
        if X::Moment::<R>::FORCED {
            self.visit(|a, b, felt| {
                for ([a, b], here) in [[a, b], [b, a]].into_iter().zip(felt) {
                    let d = self.apart(q, a, b);
                    let [by_d, by_va, by_vb] = self.between(a, b, t).force_jacobians(d, v[a], v[b]);
                    add_block(by_q, [a, a], &by_d, here);
                    add_block(by_q, [a, b], &by_entry!(|i, j| -by_d[i][j]), here);
                    add_block(by_v, [a, a], &by_va, here);
                    add_block(by_v, [a, b], &by_vb, here);
                }
            });
        }
    }
    fn frequency(&self, from_now: &impl Fn(R) -> Option<Self>, t: R, bodies: &[Course<D, R>; N]) -> Frequency<R> {
        let mut all = Frequency::none(bodies[0].least);
        self.visit(|a, b, [felt_by_a, felt_by_b]| {
            // Who does not feel the other is not moved by it, as if it were pinned.
            let moved = |i: usize, felt: W::Where<T::Presence<R>>| Course {
                per_mass: felt.choose(bodies[i].per_mass, R::ZERO),
                ..bodies[i]
            };
            let (on_a, on_b) = (&moved(a, felt_by_a), &moved(b, felt_by_b));
            let stiffness = |s, d, _| {
                let Some(now) = from_now(s) else { return Stiffness::NONE };
                let between = [now.between(a, b, t + s), now.between(b, a, t + s)];
                link_stiffness(between, s, [on_a, on_b], self.space.nearest(d))
            };
            let link = on_a.relative_to(on_b);
            let link = Course { q: self.space.nearest(link.q), ..link };
            let both = moving(link.per_mass, all, || Frequency::between(link, stiffness));
            // Steps see what is within reach now, as in a scene.
            all = match self.between(a, b, t).reaches(link.q) {
                Some(near) => all.where_alone(near.not(), both),
                None => both,
            };
        });
        all
    }
}
