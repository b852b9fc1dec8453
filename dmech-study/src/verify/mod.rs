//! A law, or a scheme, put through what the tests of this project do.
//!
//! [`verify`] measures a law and every scheme that fits it: what was derived against the method as it is written, derivatives
//! against differences, that no potential jumps, the identities of the discrete gradient, the order of convergence, invariants,
//! reversibility.
//! [`verify_scheme`] measures a scheme on motions of its own. The outcome is data, a table, and one line in a test.

mod bowl;
mod continuity;
mod derivatives;
mod difference;
mod keeps;
mod order;
mod points;
mod report;
mod reversibility;
mod scheme;
mod secant;
mod text;
mod trial;

pub use report::{Check, Outcome, Verification};
pub use scheme::{Tested, verify_scheme};

use core::array::from_fn;

use dmech_core::extend::{Field, Particle, Scheme};
use dmech_core::written::Written;
use dmech_core::{
    DiscreteGradient, Explicit, Implicit, Kanatani, Law, Leapfrog, Simulation, State, VelocityIndependent,
};

use crate::motion::{Scales, largest};
use trial::Trial;

/// Puts a law through its checks around a start, with [`Explicit`], [`Implicit`](struct@Implicit) and
/// [`DiscreteGradient`](struct@DiscreteGradient), which fit every law.
///
/// The two schemes with velocities at half steps fit only a law whose force does not depend on the velocity. The type
/// of the law says so, hence they have a call of their own: [`Verification::with_half_step_schemes`].
///
/// The particle has mass 1, and numbers that are `f64`; [`Verify`] gives it another mass. Everything is deterministic; lengths and times
/// are taken from the start, whose units are therefore free. Nothing panics except [`Verification::assert`].
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
/// let report = dmech_study::verify(Quartic { k: 0.7 }, State::new([0.9], [0.3])).with_half_step_schemes();
/// println!("{report}");
/// report.assert();
/// ```
pub fn verify<L: Law<D>, const D: usize>(law: L, start: State<D>) -> Verification<Subject<L, D>> {
    Verify::new(law, start).run()
}

/// [`verify`] with options.
///
/// A law that names the mass should be verified with one that is not 1, which hides a factor that is missing.
///
/// ```
/// use dmech_core::prelude::*;
/// use dmech_study::verify::Verify;
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

/// A law and the motion around which it is verified.
#[derive(Clone, Copy, Debug)]
pub struct Subject<L, const D: usize> {
    law: L,
    start: State<D>,
    mass: f64,
    scales: Scales,
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
    pub fn run(self) -> Verification<Subject<L, D>> {
        let Verify { law, start, mass } = self;
        let scales = Scales::of(&Particle::new(Borrowed(&law), mass), &start);
        let of = Subject { law, start, mass, scales };
        if let Some(why) = of.law.refused() {
            return Verification { of, checks: vec![Check::failed("law", why.to_string())] };
        }
        let mut checks = Vec::new();
        text::check(&of, &mut checks);
        continuity::check(&of, &mut checks);
        derivatives::check(&of, &mut checks);
        secant::check(&of, &mut checks);
        of.scheme(Explicit, &mut checks);
        of.scheme(Implicit, &mut checks);
        of.scheme(DiscreteGradient, &mut checks);
        Verification { of, checks }
    }
}

impl<L: Law<D>, const D: usize> Verification<Subject<L, D>> {
    /// Adds [`Leapfrog`] and [`Kanatani`](struct@Kanatani), for a law whose force does not depend on the velocity.
    #[must_use = "the report is of no use unless it is looked at"]
    pub fn with_half_step_schemes(mut self) -> Self
    // Not on the block: a law that does not fit is then told in words.
    where
        L: VelocityIndependent,
    {
        self.of.scheme(Leapfrog, &mut self.checks);
        self.of.scheme(Kanatani, &mut self.checks);
        self
    }
}

impl<L: Law<D>, const D: usize> Subject<L, D> {
    /// Coordinates that may move: those of bodies that are pinned do not.
    fn moves(&self) -> [bool; D] {
        from_fn(|i| !self.law.pinned(i))
    }

    /// How far a force that is zero at a place, as parts of it cancel there, varies as they do.
    fn reach(&self, q: &[f64; D]) -> f64 {
        largest(q).max(self.scales.length)
    }

    /// The start and points around it where the potential is finite.
    fn points(&self) -> Vec<[f64; D]> {
        let Subject { law, start: State { t, q, .. }, mass, scales } = self;
        points::around(&law.field(*mass, *t), *q, self.moves(), scales.length)
    }

    /// What acts, as it is before it is divided by the masses of the coordinates; nothing on test bodies, whose energy is not counted.
    fn weighted(&self, x: [f64; D]) -> [f64; D] {
        let weights = self.law.weights();
        from_fn(|i| weights[i] * x[i])
    }

    fn scheme<'l, S: Scheme<Particle<Borrowed<'l, L>, D>>>(&'l self, scheme: S, checks: &mut Vec<Check>) {
        let Subject { law, start, mass, scales } = self;
        let one_way = match (L::AUTONOMOUS, <L::Field<'_> as Field<D>>::FORCED) {
            (false, _) => Some("the law names the time"),
            (_, true) => Some("a force acts beside the potential"),
            _ => None,
        };
        let motion = Simulation::new(Borrowed(law), *start).mass(*mass);
        Trial { motion, scheme, scales: *scales, one_way }.check(S::NAME, checks);
    }
}

/// A law that is lent to a simulation, so that no law need be `Clone`.
struct Borrowed<'l, L>(&'l L);

impl<L> Clone for Borrowed<'_, L> {
    fn clone(&self) -> Self {
        Borrowed(self.0)
    }
}

impl<L: Law<D>, const D: usize> Law<D> for Borrowed<'_, L> {
    type Field<'a>
        = L::Field<'a>
    where
        Self: 'a;

    const AUTONOMOUS: bool = L::AUTONOMOUS;
    const BODY: usize = L::BODY;
    const LINEAR_MOMENTUM: bool = L::LINEAR_MOMENTUM;
    const ANGULAR_MOMENTUM: bool = L::ANGULAR_MOMENTUM;
    const ALL_COUNT: bool = L::ALL_COUNT;

    #[inline(always)]
    fn field(&self, mass: f64, t: f64) -> L::Field<'_> {
        self.0.field(mass, t)
    }

    fn pinned(&self, i: usize) -> bool {
        self.0.pinned(i)
    }

    #[inline(always)]
    fn mass_ratios(&self) -> [f64; D] {
        self.0.mass_ratios()
    }

    #[inline(always)]
    fn weights(&self) -> [f64; D] {
        self.0.weights()
    }

    fn written(&self) -> Option<&dyn Written<D>> {
        self.0.written()
    }
}

impl<L: VelocityIndependent> VelocityIndependent for Borrowed<'_, L> {}
