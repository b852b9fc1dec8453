//! The equation of an implicit step, and the force in it.

use core::ops::Range;

use dmech_scalar::{Lanes, Real};

use crate::scene::matrix::Matrix;
use crate::scene::terms::stencil::{Stencil, load};
use crate::scene::vectors::Vectors;
use crate::system::stages::drift;
use crate::system::{Guess, Newton};

/// Find Δ with  Δ + g (G(q + Δ) + known) = drift,  as for one body, with one g for each coordinate.
///
/// Parts shrink with the step as they do there: for a step of θh the drift is θ times as large and g θ² times.
pub(in crate::scene) struct Equations<'a, const D: usize> {
    pub(in crate::scene) q: &'a Vectors<D>,
    /// The low part of the position.
    pub(in crate::scene) q_low: &'a Vectors<D>,
    /// h: the drift is h (v + its low part).
    pub(in crate::scene) h: f64,
    /// The part of the force that is known, if there is one.
    pub(in crate::scene) known: Option<&'a Vectors<D>>,
    pub(in crate::scene) g: &'a Vectors<D>,
    /// The velocity at the start and its low part, and 2/h: that at the end is v + rate (Δ − drift).
    pub(in crate::scene) v: &'a Vectors<D>,
    pub(in crate::scene) v_low: &'a Vectors<D>,
    pub(in crate::scene) rate: f64,
    /// The forces of the last three steps, the newest first, which the guess continues by a parabola.
    pub(in crate::scene) last: [&'a Vectors<D>; 3],
    /// The known part is among them.
    pub(in crate::scene) last_are_whole: bool,
    pub(in crate::scene) newton: &'a Newton,
}

impl<const D: usize> Equations<'_, D> {
    /// h v with the low part of v, component i.
    #[inline(always)]
    pub(super) fn drift(&self, i: usize) -> f64 {
        drift(self.h, (self.v.flat()[i], self.v_low.flat()[i]))
    }

    /// The same for some components, eight at most.
    #[inline(always)]
    pub(super) fn drifts(&self, range: Range<usize>) -> Lanes {
        let (v, v_low) = (load(self.v.flat(), range.clone()), load(self.v_low.flat(), range));
        drift(Lanes::splat(self.h), (v, v_low))
    }

    /// The first Δ: h v − g (known + 3G − 3G₋ + G₋₋), for some components, eight at most.
    ///
    /// Of a force that is [known at once](Unknown::AT_ONCE), 0: what rounds of a guess far off would be as large as the guess in steps of
    /// many radians, where h v is many amplitudes.
    #[inline(always)]
    pub(super) fn guess<U: Unknown<D>>(&self, range: Range<usize>) -> Lanes {
        if U::AT_ONCE || self.newton.start() == Guess::Previous {
            return Lanes::ZERO;
        }
        let of = |x: &Vectors<D>| load(x.flat(), range.clone());
        let [last, before, earlier] = self.last.map(of);
        let mut force = Lanes::splat(3.0) * (last - before) + earlier;
        if let Some(known) = self.known.filter(|_| !self.last_are_whole) {
            force += of(known);
        }
        self.drifts(range.clone()) - of(self.g) * force
    }
}

/// The unknown force G and its Jacobian.
pub(in crate::scene) trait Unknown<const D: usize> {
    /// G is linear in b, with a symmetric Jacobian, and does not depend on v.
    const LINEAR: bool;
    /// G may bend or jump between two iterates.
    const PIECEWISE: bool;
    /// No others than consecutive bodies are linked.
    const CHAIN: bool;
    /// G has a force that depends on the velocity.
    const FORCED: bool;
    /// It is taken at the mean position and the mean velocity Δ/h of the step; at their ends if not.
    const MIDDLE: bool = false;
    /// The step conserves the energy: what rounding keeps from G, always of one sign where corrections are, is asked for.
    const EXACT: bool;
    /// The first correction, from Δ = 0, is the solution.
    const AT_ONCE: bool = Self::LINEAR && !Self::EXACT;

    /// out ← G(b, x, v), for a part θ of the step; x and v are those of the force.
    fn gradient(&self, theta: f64, b: &Vectors<D>, force_at: [&Vectors<D>; 2], out: &mut Vectors<D>);
    /// out += ∂G/∂b + rate ∂G/∂v.
    fn jacobian(&self, theta: f64, b: &Vectors<D>, force_at: [&Vectors<D>; 2], rate: f64, out: &mut Matrix<D>);
    /// Both for the bodies of a chain from `first` on, for the whole step and a G that does not depend on the velocity.
    fn stencil(&self, b: &Vectors<D>, first: usize, out: &mut Stencil<D>);
}

/// A part of a step, as long as θh: its equation, and the unknown force in it. The whole step has θ = 1.
pub(super) struct Part<'a, U, const D: usize> {
    pub(super) equation: &'a Equations<'a, D>,
    pub(super) unknown: &'a U,
    pub(super) theta: f64,
}

impl<U, const D: usize> Clone for Part<'_, U, D> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<U, const D: usize> Copy for Part<'_, U, D> {}

impl<'a, U, const D: usize> Part<'a, U, D> {
    pub(super) fn whole(equation: &'a Equations<'a, D>, unknown: &'a U) -> Self {
        Part { equation, unknown, theta: 1.0 }
    }

    pub(super) fn of(self, theta: f64) -> Self {
        Part { theta, ..self }
    }
}
