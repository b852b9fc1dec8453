//! Laws between two bodies.

use core::any::{Any, TypeId};

use dmech_scalar::Real;

use super::{Numbers, Potential};
use crate::law::written::WrittenPair;

/// What a pair law reads of a body with data `P`: its mass, its charge, … as numbers.
///
/// Written by the macro from the arguments `ma`, `mb`, `a`, `b`; a law that names none reads no numbers of any `P`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not read bodies that carry a `{P}`",
    label = "the bodies of this scene carry a `{P}`",
    note = "the arguments `a: &P` and `b: &P` of the law name the data that its bodies carry: `.body_with(m, q, v, data)`"
)]
pub trait Reads<P> {
    /// `[f64; K]`.
    type Numbers: Numbers;

    /// The numbers of a body. They do not depend on the law, which may be changed while a scene runs.
    fn numbers(mass: f64, data: &P) -> Self::Numbers;

    /// The law in this one that has a type, as in one that is cut off.
    #[doc(hidden)]
    fn inner(&mut self, _of: TypeId) -> Option<&mut dyn Any> {
        None
    }
}

/// A law between two bodies: for the numbers of a and b it is what acts along the separation d = q_a − q_b.
///
/// Written by the macro for a block with `#[pair]` or `#[pair_force]`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a law between bodies in {D} dimensions",
    note = "declare one with `#[dmech::law]` and a `#[pair]` of the distance `r` or the separation `d: [f64; {D}]`, or a `#[pair_force]`"
)]
pub trait PairLaw<const D: usize, P, R: Real = f64>: Reads<P> + Sync {
    /// What acts between two bodies at one moment.
    type Between<'a>: Between<D, R>
    where
        Self: 'a;

    /// The law does not name the time.
    const AUTONOMOUS: bool = true;

    /// What acts between a body with numbers `a` and one with numbers `b` at time `t`.
    fn between(
        &self,
        a: <Self::Numbers as Numbers>::Of<R>,
        b: <Self::Numbers as Numbers>::Of<R>,
        t: R,
    ) -> Self::Between<'_>;

    /// The methods that a macro has made this of; a law written by hand is its own.
    #[doc(hidden)]
    fn written(&self) -> Option<&dyn WrittenPair<D, P>> {
        None
    }
}

/// What acts between two bodies a and b: a potential of d = q_a − q_b, and with it perhaps a force on a.
///
/// Of the [`Potential`] the force on a is −∇Φ(d) and that on b is +∇Φ(d). The force on b from a is the law's with a and b
/// exchanged: `law.between(b, a, t).force(−d, vb, va)`.
pub trait Between<const D: usize, R: Real = f64>: Potential<D, R> {
    /// A potential acts; if not, its functions are zero and need not be called.
    const POTENTIAL: bool = true;
    /// A force acts beside the potential.
    const FORCED: bool = false;
    /// The force on b from a is opposite to that on a from b.
    const RECIPROCAL: bool = true;

    /// Where it acts at all, if it ends at some distance.
    #[doc(hidden)]
    #[inline(always)]
    fn reaches(&self, _d: [R; D]) -> Option<R::Mask> {
        None
    }

    /// The force on a from b.
    #[inline(always)]
    fn force(&self, _d: [R; D], _va: [R; D], _vb: [R; D]) -> [R; D] {
        [R::ZERO; D]
    }
    /// Its derivatives with respect to d, v_a and v_b.
    #[inline(always)]
    fn force_jacobians(&self, _d: [R; D], _va: [R; D], _vb: [R; D]) -> [[[R; D]; D]; 3] {
        [[[R::ZERO; D]; D]; 3]
    }
}

/// A [`PairLaw`] for one pair of bodies at a time and for eight: what scenes run.
///
/// A law written by hand is one if it is implemented for every scalar: `impl<R: Real> PairLaw<3, P, R> for MyLaw`.
#[cfg(feature = "scene")]
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not act between the bodies of this scene",
    label = "the bodies move in {D} dimensions and carry `{P}`",
    note = "a law between bodies is a `#[pair]` or a `#[pair_force]` of the distance `r: f64` or the separation `d: [f64; {D}]`",
    note = "one with `a: &P` and `b: &P` needs bodies that carry a `P`: `.body_with(m, q, v, data)`; those of `.body(m, q, v)` carry `()`",
    note = "a law of one body acts on each: `.field(law)`"
)]
pub trait LinkLaw<const D: usize, P>: PairLaw<D, P, f64> + PairLaw<D, P, dmech_scalar::Lanes> {}

#[cfg(feature = "scene")]
#[diagnostic::do_not_recommend]
impl<const D: usize, P, X: PairLaw<D, P, f64> + PairLaw<D, P, dmech_scalar::Lanes>> LinkLaw<D, P> for X {}

/// The energy of two bodies does not depend on which is called a: E(a, b) = E(b, a), and E(d) = E(−d).
///
/// Found by the engine from the expression. A law without this property has a meaning where the bodies are ordered, as
/// on a chain; on all pairs it has none.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no law that acts alike on both bodies of every pair",
    label = "not symmetric in a and b",
    note = "a law of one body acts on each: `.field(law)`",
    note = "on all pairs there is no first body: E(a, b) must be E(b, a), and an energy of the separation must be even in `d`",
    note = "on a chain or on bonds the order is known: use `.chain(law)` or `.bonds(law, list)`"
)]
pub trait Symmetric {}
