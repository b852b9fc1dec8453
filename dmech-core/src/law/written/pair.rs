//! The methods of a law between two bodies.

use dmech_scalar::Real;

#[cfg(feature = "scene")]
use super::{OwnValues, Written};
use super::{Probe, Tracked, Values, named};
#[cfg(feature = "scene")]
use crate::drift::MAX_OWN;
use crate::law::Potential;
use crate::law::{Between as Acting, Numbers, PairFields, PairLaw};

/// What the macro says of the author's own methods: `q` of the place is d, `v` is v_a and v_b, `m` is m_a and m_b.
pub trait PairAuthor<const D: usize, P>: PairFields<D, P> + PairLaw<D, P, Tracked> {
    /// What the methods give for bodies with this data.
    fn own(&self, place: &Probe<D>, a: &P, b: &P) -> Values<D>;
}

/// A [`PairAuthor`], whatever the law.
pub trait WrittenPair<const D: usize, P> {
    /// What the author's methods give.
    fn own(&self, place: &Probe<D>, a: &P, b: &P) -> Values<D>;
    /// What was derived from their text.
    fn derived(&self, place: &Probe<D>, a: &P, b: &P) -> Values<D>;
    /// The same with what rounding may do to it.
    fn tracked(&self, place: &Probe<D>, a: &P, b: &P) -> Values<D, Tracked>;
    /// Every number that they read of the law, by its name.
    fn fields(&self, see: &mut dyn FnMut(&'static str, f64));
}

impl<L: PairAuthor<D, P>, const D: usize, P> WrittenPair<D, P> for L {
    fn own(&self, place: &Probe<D>, a: &P, b: &P) -> Values<D> {
        PairAuthor::own(self, place, a, b)
    }

    fn derived(&self, place: &Probe<D>, a: &P, b: &P) -> Values<D> {
        acting::<L, D, P, f64>(self, place, a, b)
    }

    fn tracked(&self, place: &Probe<D>, a: &P, b: &P) -> Values<D, Tracked> {
        acting::<L, D, P, Tracked>(self, place, a, b)
    }

    fn fields(&self, see: &mut dyn FnMut(&'static str, f64)) {
        named(L::names, &PairFields::fields(self), see);
    }
}

fn acting<L: PairLaw<D, P, R>, const D: usize, P, R: Real>(law: &L, place: &Probe<D>, a: &P, b: &P) -> Values<D, R> {
    let numbers = |mass: f64, data: &P| {
        let numbers = L::numbers(mass, data);
        <L::Numbers as Numbers>::gather(|k| R::from_f64(numbers.at(k)))
    };
    let [va, vb] = place.v.map(|v| v.map(R::from_f64));
    let d = place.q.map(R::from_f64);
    let between = law.between(numbers(place.m[0], a), numbers(place.m[1], b), R::from_f64(place.t));
    Values { potential: between.potential(d), force: between.force(d, va, vb) }
}

/// A law between two given bodies, as one of their separation.
#[cfg(feature = "scene")]
pub(crate) struct Between<'a, const D: usize, P> {
    pub(crate) law: &'a dyn WrittenPair<D, P>,
    pub(crate) a: &'a P,
    pub(crate) b: &'a P,
}

#[cfg(feature = "scene")]
impl<const D: usize, P> Written<D> for Between<'_, D, P> {
    fn own(&self, place: &Probe<D>) -> Values<D> {
        self.law.own(place, self.a, self.b)
    }

    fn derived(&self, place: &Probe<D>) -> (Values<D>, OwnValues) {
        (self.law.derived(place, self.a, self.b), [0.0; MAX_OWN])
    }

    fn tracked(&self, place: &Probe<D>) -> (Values<D, Tracked>, OwnValues<Tracked>) {
        (self.law.tracked(place, self.a, self.b), [Tracked::ZERO; MAX_OWN])
    }
}
