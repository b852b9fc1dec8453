//! A law put through what the tests of this crate do.
//!
//! [`verify`] measures a law and every scheme that fits it: what was derived against the method as it is written, derivatives against differences, the identities of the
//! discrete gradient, the order of convergence, invariants, reversibility. The outcome is data, a table, and one line
//! in a test.

mod derivatives;
mod difference;
mod motion;
mod order;
mod points;
mod report;
mod secant;
mod text;
mod trial;

pub use report::{Check, Outcome, Verification};

use crate::law::{Law, VelocityIndependent};
use crate::scheme::{DiscreteGradient, Explicit, Implicit, Kanatani, Leapfrog, Scheme};
use crate::state::State;
use crate::system::Particle;
use crate::written::Written;

pub(crate) use points::Scales;
use trial::Trial;

/// Puts a law through its checks around a start, with [`Explicit`], [`Implicit`](struct@Implicit) and
/// [`DiscreteGradient`](struct@DiscreteGradient), which fit every law.
///
/// The two schemes with velocities at half steps fit only a law whose force does not depend on the velocity. The type
/// of the law says so, hence they have a call of their own: [`Verification::with_half_step_schemes`].
///
/// The particle has mass 1; [`Verify`] gives it another. Everything is deterministic; lengths and times are taken from the start, whose units are
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
    Verify::new(law, start).run()
}

/// [`verify`] with options.
///
/// A law that names the mass should be verified with one that is not 1, which hides a factor that is missing.
///
/// ```
/// use dmech_core::prelude::*;
/// use dmech_core::verify::Verify;
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
/// Verify::new(Quartic { k: 0.7 }, State::new([0.9], [0.3])).mass(2.5).run().assert();
/// ```
#[derive(Clone, Copy, Debug)]
#[must_use = "nothing is verified until it is run"]
pub struct Verify<L, const D: usize> {
    law: L,
    start: State<D>,
    mass: f64,
}

impl<L: Law<D>, const D: usize> Verify<L, D> {
    /// A particle of mass 1 under a law, around a start.
    pub fn new(law: L, start: State<D>) -> Self {
        Verify { law, start, mass: 1.0 }
    }

    /// The mass of the particle (default 1). One that is not positive and finite fails the checks of the schemes.
    pub fn mass(self, mass: f64) -> Self {
        Verify { mass, ..self }
    }

    /// The checks that fit every law, as [`verify`] makes them.
    pub fn run(self) -> Verification<L, D> {
        let Verify { law, start, mass } = self;
        let mut checks = Vec::new();
        let scales = Scales::new(&law, &start, mass);
        text::check(&law, &start, &scales, &mut checks);
        derivatives::check(&law, &start, &scales, &mut checks);
        secant::check(&law, &start, &scales, &mut checks);
        scheme(&law, Explicit, &start, &scales, &mut checks);
        scheme(&law, Implicit, &start, &scales, &mut checks);
        scheme(&law, DiscreteGradient, &start, &scales, &mut checks);
        Verification { law, start, mass, checks }
    }
}

impl<L: Law<D> + VelocityIndependent, const D: usize> Verification<L, D> {
    /// Adds [`Leapfrog`] and [`Kanatani`](struct@Kanatani), for a law whose force does not depend on the velocity.
    #[must_use = "the report is of no use unless it is looked at"]
    pub fn with_half_step_schemes(mut self) -> Self {
        let scales = Scales::new(&self.law, &self.start, self.mass);
        scheme(&self.law, Leapfrog, &self.start, &scales, &mut self.checks);
        scheme(&self.law, Kanatani, &self.start, &scales, &mut self.checks);
        self
    }
}

fn scheme<L, S, const D: usize>(law: &L, scheme: S, start: &State<D>, scales: &Scales, checks: &mut Vec<Check>)
where
    L: Law<D>,
    S: for<'a> Scheme<Particle<Borrowed<'a, L>, D>>,
{
    let trial = Trial { law, scheme, start, scales };
    checks.push(trial.order());
    trial.invariants(checks);
    checks.push(trial.reversibility());
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

    fn written(&self) -> Option<&dyn Written<D>> {
        self.0.written()
    }
}

impl<L: VelocityIndependent> VelocityIndependent for Borrowed<'_, L> {}
