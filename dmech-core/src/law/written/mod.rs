//! What the author of a law wrote, beside what a macro made of it.
//!
//! A macro sees names as text and cannot ask what they stand for: a constant of one's own called like one of `std`, a
//! type called like one of nalgebra, two variables of a `macro_rules!` that are spelt alike. The author's own method,
//! which the compiler has resolved, is therefore called before a law is stepped, and has to give the same numbers.
//! Nothing here is for use by hand: a law written by hand is its own method.

mod compare;
mod pair;
mod tracked;

pub use compare::Probe;
pub use pair::{PairAuthor, WrittenPair};
pub use tracked::Tracked;

pub(crate) use compare::agree;
pub use compare::{Agreement, agreement};
#[cfg(feature = "scene")]
pub(crate) use pair::Between;

use dmech_scalar::Real;

use crate::drift::MAX_OWN;
use crate::law::{Field, Fields, Law, Numbers, Potential};

/// What generated code imports by the names of its variables: a pattern of one name is a new variable beside a function that is called
/// so, as it is not beside a constant.
pub const fn fresh() {}

/// What a law gives at one place.
#[derive(Clone, Copy, Debug)]
pub struct Values<const D: usize, R = f64> {
    /// Φ, or 0 where there is none.
    pub potential: R,
    /// F, or 0 where there is none.
    pub force: [R; D],
}

impl<const D: usize, R: Real> Values<D, R> {
    /// Nothing acts.
    pub const NOTHING: Self = Values { potential: R::ZERO, force: [R::ZERO; D] };
}

/// The invariants that a law declares itself, 0 beyond.
pub type OwnValues<R = f64> = [R; MAX_OWN];

/// What the macro says of the author's own methods.
pub trait Author<const D: usize>: Fields<D> + Law<D, Tracked> {
    /// What the methods give.
    fn own(&self, place: &Probe<D>) -> Values<D>;

    /// What the methods give that are marked `#[invariant]`.
    fn invariants(&self, _place: &Probe<D>) -> OwnValues {
        [0.0; MAX_OWN]
    }
}

/// An [`Author`], whatever the law: in `f64` and as it is stepped.
pub trait Written<const D: usize> {
    /// What the author's methods give.
    fn own(&self, place: &Probe<D>) -> Values<D>;
    /// The names of the law's own invariants.
    fn names(&self) -> &'static [&'static str] {
        &[]
    }
    /// What the author's methods give of them.
    fn own_invariants(&self, _place: &Probe<D>) -> OwnValues {
        [0.0; MAX_OWN]
    }
    /// What was derived from the text of all these methods.
    fn derived(&self, place: &Probe<D>) -> (Values<D>, OwnValues);
    /// The same with what rounding may do to it.
    fn tracked(&self, place: &Probe<D>) -> (Values<D, Tracked>, OwnValues<Tracked>);
    /// Every number that they read of the law, by its name.
    fn fields(&self, _see: &mut dyn FnMut(&'static str, f64)) {}
}

impl<L: Author<D>, const D: usize> Written<D> for L {
    fn own(&self, place: &Probe<D>) -> Values<D> {
        Author::own(self, place)
    }

    fn names(&self) -> &'static [&'static str] {
        <L as Law<D>>::INVARIANTS
    }

    fn own_invariants(&self, place: &Probe<D>) -> OwnValues {
        Author::invariants(self, place)
    }

    fn derived(&self, place: &Probe<D>) -> (Values<D>, OwnValues) {
        derived::<L, D, f64>(self, place)
    }

    fn tracked(&self, place: &Probe<D>) -> (Values<D, Tracked>, OwnValues<Tracked>) {
        derived::<L, D, Tracked>(self, place)
    }

    fn fields(&self, see: &mut dyn FnMut(&'static str, f64)) {
        named(<L as Fields<D>>::names, &self.numbers(), see);
    }
}

/// Numbers, each with its name.
pub(crate) fn named(
    names: fn(&mut dyn FnMut(&'static str)),
    numbers: &impl Numbers,
    see: &mut dyn FnMut(&'static str, f64),
) {
    let mut k = 0;
    names(&mut |name| {
        see(name, numbers.at(k));
        k += 1;
    });
}

fn derived<L: Law<D, R>, const D: usize, R: Real>(law: &L, place: &Probe<D>) -> (Values<D, R>, OwnValues<R>) {
    let (q, v, t) = (place.q.map(R::from_f64), place.v[0].map(R::from_f64), R::from_f64(place.t));
    let field = law.field(R::from_f64(place.m[0]), t);
    let kept = |k| if k < L::INVARIANTS.len() { law.invariant(k, q, v, t) } else { R::ZERO };
    (Values { potential: field.potential(q), force: field.force(q, v, t) }, core::array::from_fn(kept))
}

/// A position in the form in which the author's method takes it.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be made of the {D} coordinates of a position",
    note = "positions and velocities of a law are `f64`, `[f64; {D}]` or vectors of nalgebra",
    note = "a type of your own that is called like one of nalgebra is taken for it: give it another name, or take `[f64; {D}]`"
)]
pub trait Arranged<const D: usize>: Sized {
    /// Of the coordinates.
    fn arranged(coordinates: [f64; D]) -> Self;
}

#[diagnostic::do_not_recommend]
impl<V: From<[f64; D]>, const D: usize> Arranged<D> for V {
    fn arranged(coordinates: [f64; D]) -> Self {
        V::from(coordinates)
    }
}

/// A position as the author's method takes it.
pub fn arranged<V: Arranged<D>, const D: usize>(coordinates: [f64; D]) -> V {
    V::arranged(coordinates)
}

/// What the macro reads of a law, whose type it does not see.
#[diagnostic::on_unimplemented(
    message = "a law is made of numbers, and this is `{Self}`",
    label = "an `f64` is expected here",
    note = "a parameter of a law is an `f64`, and no reference to one; an integer is read with `as f64`"
)]
pub trait Number {
    /// Itself.
    fn number(self) -> f64;
}

#[diagnostic::do_not_recommend]
impl Number for f64 {
    #[inline(always)]
    fn number(self) -> f64 {
        self
    }
}
