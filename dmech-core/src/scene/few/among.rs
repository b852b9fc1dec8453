//! What acts among few bodies, in any scalar.

use dmech_scalar::Real;

use super::Of;
use super::sides::{Mutual, Sides};
use crate::law::Numbers;
use crate::look::{Course, Frequency};
use crate::scene::both::{of_both, of_nothing};
use crate::scene::terms::Acts;

/// A vector of each of N bodies.
pub type Places<const D: usize, const N: usize, R> = [[R; D]; N];

/// Terms of a scene that can act among N bodies as one law; `S` says who acts on whom.
#[diagnostic::on_unimplemented(
    message = "this scene cannot be one law of {N} bodies",
    note = "that takes laws of `#[dmech::law]`, on each body or along links: `.field(law)`, `.pairs(law)`, `.chain(law)`, `.bonds(law, list)`"
)]
pub trait AmongFew<const D: usize, const N: usize, S: Sides = Mutual>: Acts<D> {
    /// What is read of the laws and of the bodies.
    type Numbers: Numbers;
    /// What acts at one moment, by numbers of any scalar.
    type Moment<R: Real>: Among<D, N, R>;

    /// What is read of the laws and of the bodies; there are N of these.
    fn numbers(&self) -> Self::Numbers;
    /// The names of these numbers, in their order.
    fn names(see: &mut dyn FnMut(&'static str));
    /// What acts at a time, by these numbers, on those on whom it acts.
    fn moment<R: Real>(numbers: Of<Self::Numbers, R>, acting: S::WhoActs<N, R>, t: R) -> Self::Moment<R>;
}

/// What acts among N bodies at one moment: the functions of [`Acts`], each of which adds to what it is given. Test bodies feel what acts
/// on them, and neither act nor count.
pub trait Among<const D: usize, const N: usize, R: Real> {
    /// Φ(q).
    fn potential(&self, q: &Places<D, N, R>) -> R;
    /// ∇Φ(q).
    fn add_gradient(&self, q: &Places<D, N, R>, out: &mut Places<D, N, R>);
    /// ∂²Φ/∂q∂q.
    fn add_hessian<const K: usize>(&self, q: &Places<D, N, R>, out: &mut [[R; K]; K]);
    /// ∇̄Φ(a, b).
    fn add_discrete_gradient(&self, a: &Places<D, N, R>, b: &Places<D, N, R>, out: &mut Places<D, N, R>);
    /// ∂∇̄Φ(a, b)/∂b.
    fn add_discrete_jacobian<const K: usize>(&self, a: &Places<D, N, R>, b: &Places<D, N, R>, out: &mut [[R; K]; K]);
    /// F(q, v), at a time of its own.
    fn add_force(&self, _q: &Places<D, N, R>, _v: &Places<D, N, R>, _t: R, _out: &mut Places<D, N, R>) {}
    /// ∂F/∂q and ∂F/∂v.
    fn add_force_jacobians<const K: usize>(
        &self,
        _q: &Places<D, N, R>,
        _v: &Places<D, N, R>,
        _t: R,
        _out: [&mut [[R; K]; K]; 2],
    ) {
    }
    /// [`Acts::frequency`], of what acts at times from now, if anything does; now is t, when this acts.
    fn frequency(&self, from_now: &impl Fn(R) -> Option<Self>, t: R, bodies: &[Course<D, R>; N]) -> Frequency<R>
    where
        Self: Sized;
}

/// Nothing acts.
impl<const D: usize, const N: usize, S: Sides> AmongFew<D, N, S> for () {
    type Numbers = [f64; 0];
    type Moment<R: Real> = ();

    fn numbers(&self) -> [f64; 0] {
        []
    }
    fn names(_: &mut dyn FnMut(&'static str)) {}
    fn moment<R: Real>(_: [R; 0], _: S::WhoActs<N, R>, _: R) {}
}

/// The functions that add to what they are given.
macro_rules! that_add {
    ($whose:ident) => {
        $whose! {
            #[inline(always)]
            add_gradient(q: &Places<D, N, R>, out: &mut Places<D, N, R>);
            #[inline(always)]
            add_hessian<const K: usize>(q: &Places<D, N, R>, out: &mut [[R; K]; K]);
            #[inline(always)]
            add_discrete_gradient(a: &Places<D, N, R>, b: &Places<D, N, R>, out: &mut Places<D, N, R>);
            #[inline(always)]
            add_discrete_jacobian<const K: usize>(a: &Places<D, N, R>, b: &Places<D, N, R>, out: &mut [[R; K]; K]);
            #[inline(always)]
            add_force(q: &Places<D, N, R>, v: &Places<D, N, R>, t: R, out: &mut Places<D, N, R>);
        }
    };
}

impl<const D: usize, const N: usize, R: Real> Among<D, N, R> for () {
    #[inline(always)]
    fn potential(&self, _: &Places<D, N, R>) -> R {
        R::ZERO
    }
    that_add!(of_nothing);
    fn frequency(&self, _: &impl Fn(R) -> Option<()>, _: R, bodies: &[Course<D, R>; N]) -> Frequency<R> {
        Frequency::none(bodies[0].least)
    }
}

/// Two terms, or a list of them and one more.
impl<const D: usize, const N: usize, S: Sides, A: AmongFew<D, N, S>, B: AmongFew<D, N, S>> AmongFew<D, N, S>
    for (A, B)
{
    type Numbers = (A::Numbers, B::Numbers);
    type Moment<R: Real> = (A::Moment<R>, B::Moment<R>);

    fn numbers(&self) -> Self::Numbers {
        (self.0.numbers(), self.1.numbers())
    }
    fn names(see: &mut dyn FnMut(&'static str)) {
        A::names(see);
        B::names(see);
    }
    #[inline(always)]
    fn moment<R: Real>((a, b): Of<Self::Numbers, R>, acting: S::WhoActs<N, R>, t: R) -> Self::Moment<R> {
        (A::moment(a, acting, t), B::moment(b, acting, t))
    }
}

impl<const D: usize, const N: usize, R: Real, A: Among<D, N, R>, B: Among<D, N, R>> Among<D, N, R> for (A, B) {
    #[inline(always)]
    fn potential(&self, q: &Places<D, N, R>) -> R {
        self.0.potential(q) + self.1.potential(q)
    }
    that_add!(of_both);
    #[inline(always)]
    fn add_force_jacobians<const K: usize>(
        &self,
        q: &Places<D, N, R>,
        v: &Places<D, N, R>,
        t: R,
        [by_q, by_v]: [&mut [[R; K]; K]; 2],
    ) {
        self.0.add_force_jacobians(q, v, t, [by_q, by_v]);
        self.1.add_force_jacobians(q, v, t, [by_q, by_v]);
    }
    fn frequency(&self, from_now: &impl Fn(R) -> Option<Self>, t: R, bodies: &[Course<D, R>; N]) -> Frequency<R> {
        let first = self.0.frequency(&|s| Some(from_now(s)?.0), t, bodies);
        first.and(self.1.frequency(&|s| Some(from_now(s)?.1), t, bodies))
    }
}
