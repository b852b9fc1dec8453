//! Masses per coordinate.

use dmech_scalar::Real;

use super::field::Linearised;
use super::perhaps::passed_on;
use crate::law::written::Written;
use crate::law::{Field, Fields, Law, LinearInVelocity, MassIndependent, Numbers, Potential, VelocityIndependent};
use crate::vector::{by_component, by_entry};

/// A law whose coordinates have masses of their own, mᵢ = m μᵢ; made by [`Simulation::masses`](crate::Simulation::masses).
///
/// ```text
/// m μᵢ qᵢ″ = −∂Φ/∂qᵢ + Fᵢ,   K = Σ m μᵢ vᵢ²/2
/// ```
///
/// The schemes see a particle of the one mass m in the slope (∇Φ − F)ᵢ/μᵢ: row i of every gradient, force and Jacobian is
/// divided by μᵢ. The division is a true one. A product with a rounded 1/μᵢ would be wrong by the same relative amount
/// in each step, and feed energy in at a constant rate. Products of such vectors, the kinetic energy and the work, are
/// weighted by μᵢ again, so that Σ μᵢ (∇̄Φᵢ/μᵢ) Δqᵢ = Φ(b) − Φ(a) stays exact; Φ itself is not scaled.
///
/// A row that is divided has no closed form of its own: implicit steps use [`newton::dense`](crate::newton::dense) and its like, whatever
/// the structure of the law. The angular momentum is not claimed, also where the law is central: with two masses it is not kept.
#[derive(Clone, Copy, Debug)]
pub struct Masses<L, const D: usize> {
    law: L,
    ratios: [f64; D],
}

impl<L, const D: usize> Masses<L, D> {
    pub(crate) fn new(law: L, ratios: [f64; D]) -> Self {
        Masses { law, ratios }
    }

    /// The law itself.
    pub fn law(&self) -> &L {
        &self.law
    }

    /// The law, to be changed: `stepper.law_mut().law_mut().k = 4.0;`.
    pub fn law_mut(&mut self) -> &mut L {
        &mut self.law
    }
}

#[diagnostic::do_not_recommend]
impl<L: VelocityIndependent, const D: usize> VelocityIndependent for Masses<L, D> {}

#[diagnostic::do_not_recommend]
impl<L: LinearInVelocity, const D: usize> LinearInVelocity for Masses<L, D> {}

impl<L: Law<D, R> + MassIndependent, const D: usize, R: Real> Law<D, R> for Masses<L, D> {
    type Field<'a>
        = Divided<L::Field<'a>, D, R>
    where
        Self: 'a;

    const AUTONOMOUS: bool = L::AUTONOMOUS;
    const INVARIANTS: &'static [&'static str] = L::INVARIANTS;

    #[inline(always)]
    fn field(&self, mass: R, t: R) -> Self::Field<'_> {
        Divided { field: self.law.field(mass, t), ratios: self.ratios.map(R::from_f64), t }
    }

    fn invariant(&self, k: usize, q: [R; D], v: [R; D], t: R) -> R {
        self.law.invariant(k, q, v, t)
    }

    #[inline(always)]
    fn mass_ratios(&self) -> [f64; D] {
        self.ratios
    }

    fn written(&self) -> Option<&dyn Written<D>> {
        self.law.written()
    }
}

/// The numbers of the law, and the masses after them.
#[diagnostic::do_not_recommend]
impl<L: Fields<D> + MassIndependent, const D: usize> Fields<D> for Masses<L, D> {
    type Numbers = (L::Numbers, [f64; D]);
    type Moment<R: Real> = Divided<L::Moment<R>, D, R>;

    fn numbers(&self) -> Self::Numbers {
        (self.law.numbers(), self.ratios)
    }

    fn names(see: &mut dyn FnMut(&'static str)) {
        L::names(see);
        (0..D).for_each(|_| see("masses"));
    }

    #[inline(always)]
    fn moment<R: Real>((numbers, ratios): (<L::Numbers as Numbers>::Of<R>, [R; D]), mass: R, t: R) -> Self::Moment<R> {
        Divided { field: L::moment(numbers, mass, t), ratios, t }
    }

    #[inline(always)]
    fn masses<R: Real>((_, ratios): (<L::Numbers as Numbers>::Of<R>, [R; D])) -> [R; D] {
        ratios
    }
}

/// What acts at one moment, row i divided by μᵢ.
#[derive(Clone, Copy, Debug)]
pub struct Divided<F, const D: usize, R: Real> {
    field: F,
    ratios: [R; D],
    t: R,
}

impl<F, const D: usize, R: Real> Divided<F, D, R> {
    #[inline(always)]
    fn rows(&self, x: [R; D]) -> [R; D] {
        by_component!(|i| x[i] / self.ratios[i])
    }

    #[inline(always)]
    fn matrix(&self, x: [[R; D]; D]) -> [[R; D]; D] {
        by_entry!(|i, j| x[i][j] / self.ratios[i])
    }

    /// A vector and its two Jacobians, each row divided.
    #[inline(always)]
    fn all(&self, (x, by_q, by_v): Linearised<D, R>) -> Linearised<D, R> {
        (self.rows(x), self.matrix(by_q), self.matrix(by_v))
    }
}

impl<F: Field<D, R>, const D: usize, R: Real> Potential<D, R> for Divided<F, D, R> {
    const LINEAR: bool = F::LINEAR;
    const PIECEWISE: bool = F::PIECEWISE;
    const DEGREE: Option<u32> = F::DEGREE;

    #[inline(always)]
    fn potential(&self, q: [R; D]) -> R {
        self.field.potential(q)
    }
    passed_on! { field:
        rows gradient(q: [R; D]) -> [R; D];
        matrix hessian(q: [R; D]) -> [[R; D]; D];
        rows discrete_gradient(a: [R; D], b: [R; D]) -> [R; D];
        matrix discrete_gradient_jacobian(a: [R; D], b: [R; D]) -> [[R; D]; D];
    }
}

impl<F: Field<D, R>, const D: usize, R: Real> Field<D, R> for Divided<F, D, R> {
    const FORCED: bool = F::FORCED;
    const CONSERVES_ENERGY: bool = F::CONSERVES_ENERGY;

    passed_on! { field:
        rows slope(q: [R; D], v: [R; D]) -> [R; D];
        rows half_force(q: [R; D], v: [R; D]) -> [R; D];
        rows force(q: [R; D], v: [R; D], t: R) -> [R; D];
        matrix force_dq(q: [R; D], v: [R; D], t: R) -> [[R; D]; D];
        matrix force_dv(q: [R; D], v: [R; D], t: R) -> [[R; D]; D];
    }

    #[inline(always)]
    fn time(&self) -> R {
        self.t
    }

    fn end_slope(&self, b: [R; D], v: [R; D], t: R) -> Linearised<D, R> {
        self.all(self.field.end_slope(b, v, t))
    }
    fn secant_slope(&self, a: [R; D], b: [R; D], v: [R; D], t: R) -> Linearised<D, R> {
        self.all(self.field.secant_slope(a, b, v, t))
    }
    fn middle_slope(&self, ends: [[R; D]; 2], mean: [R; D], _: R) -> Linearised<D, R> {
        self.all(self.field.middle_slope(ends, mean, self.t))
    }
}
