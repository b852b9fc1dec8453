//! A law put through what the tests of this crate do.
//!
//! [`verify`] measures a law and every scheme that fits it: derivatives against differences, the identities of the
//! discrete gradient, the order of convergence, invariants, reversibility. The outcome is data, a table, and one line
//! in a test.

mod derivatives;
mod difference;
mod motion;
mod order;
mod points;
mod report;
mod secant;

pub use report::{Check, Outcome, Verification};

use crate::law::{Law, VelocityIndependent};
use crate::scheme::{DiscreteGradient, Explicit, Implicit, Kanatani, Leapfrog, Scheme};
use crate::state::State;

use points::Scales;

/// Puts a law through its checks around a start, with [`Explicit`], [`Implicit`](struct@Implicit) and
/// [`DiscreteGradient`](struct@DiscreteGradient), which fit every law.
///
/// The two schemes with velocities at half steps fit only a law whose force does not depend on the velocity. The type
/// of the law says so, hence they have a call of their own: [`Verification::with_half_step_schemes`].
///
/// The particle has mass 1. Everything is deterministic; lengths and times are taken from the start, whose units are
/// therefore free. Nothing panics except [`Verification::assert`].
///
/// ```
/// use dmech_core::prelude::*;
/// # struct Quartic { k: f64 }
/// # impl Conservative for Quartic {}
/// # impl Potential<1> for Quartic {
/// #     fn potential(&self, [x]: [f64; 1]) -> f64 { self.k * x.powi(4) }
/// #     fn gradient(&self, [x]: [f64; 1]) -> [f64; 1] { [4.0 * self.k * x.powi(3)] }
/// #     fn hessian(&self, [x]: [f64; 1]) -> [[f64; 1]; 1] { [[12.0 * self.k * x * x]] }
/// #     fn discrete_gradient(&self, [a]: [f64; 1], [b]: [f64; 1]) -> [f64; 1] { [self.k * (a + b) * (a * a + b * b)] }
/// #     fn discrete_gradient_jacobian(&self, [a]: [f64; 1], [b]: [f64; 1]) -> [[f64; 1]; 1] {
/// #         [[self.k * (a * a + b * b + 2.0 * b * (a + b))]]
/// #     }
/// # }
/// let report = dmech_core::verify(Quartic { k: 0.7 }, State::new([0.9], [0.3])).with_half_step_schemes();
/// println!("{report}");
/// report.assert();
/// ```
pub fn verify<L: Law<D>, const D: usize>(law: L, start: State<D>) -> Verification<L, D> {
    let mut checks = Vec::new();
    let scales = Scales::new(&law, &start);
    derivatives::check(&law, &start, &scales, &mut checks);
    secant::check(&law, &start, &scales, &mut checks);
    scheme(&law, Explicit, &start, &scales, &mut checks);
    scheme(&law, Implicit, &start, &scales, &mut checks);
    scheme(&law, DiscreteGradient, &start, &scales, &mut checks);
    Verification { law, start, checks }
}

impl<L: Law<D> + VelocityIndependent, const D: usize> Verification<L, D> {
    /// Adds [`Leapfrog`] and [`Kanatani`](struct@Kanatani), for a law whose force does not depend on the velocity.
    #[must_use = "the report is of no use unless it is looked at"]
    pub fn with_half_step_schemes(mut self) -> Self {
        let scales = Scales::new(&self.law, &self.start);
        scheme(&self.law, Leapfrog, &self.start, &scales, &mut self.checks);
        scheme(&self.law, Kanatani, &self.start, &scales, &mut self.checks);
        self
    }
}

fn scheme<L, S, const D: usize>(law: &L, scheme: S, start: &State<D>, scales: &Scales, checks: &mut Vec<Check>)
where
    L: Law<D>,
    S: for<'a> Scheme<Borrowed<'a, L>, D>,
{
    order::check(law, scheme, start, scales, checks);
    motion::invariants(law, scheme, start, scales, checks);
    motion::reversibility(law, scheme, start, scales, checks);
}

/// A law that is lent to a simulation, so that no law need be `Clone`.
pub(crate) struct Borrowed<'l, L>(&'l L);

impl<L: Law<D>, const D: usize> Law<D> for Borrowed<'_, L> {
    type Field<'a>
        = L::Field<'a>
    where
        Self: 'a;

    const AUTONOMOUS: bool = L::AUTONOMOUS;

    #[inline(always)]
    fn field(&self, mass: f64, t: f64) -> L::Field<'_> {
        self.0.field(mass, t)
    }

    #[inline(always)]
    fn mass_ratios(&self) -> [f64; D] {
        self.0.mass_ratios()
    }
}

impl<L: VelocityIndependent> VelocityIndependent for Borrowed<'_, L> {}
