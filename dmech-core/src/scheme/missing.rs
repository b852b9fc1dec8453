//! A simulation whose scheme was not chosen.

use dmech_scalar::Real;

use super::{Effort, Method, Scheme, Stride};
use crate::State;
use crate::invariant::{Invariant, Kept};
use crate::newton::NotConverged;
use crate::simulation::NoScheme;

/// A scheme was chosen for what acts. Nothing implements it: it has the words for [`NoScheme`], and stands on what acts
/// because the compiler would not say them of the scheme itself.
#[diagnostic::on_unimplemented(
    message = "`.scheme(...)` is missing: nothing says how this is to be stepped",
    label = "no scheme was chosen",
    note = "write `.scheme(DiscreteGradient)` to keep the energy exactly, `.scheme(Nystrom::order6())` for accurate positions, `.scheme(Leapfrog)` for a quick look"
)]
pub trait WithScheme {}

impl Method for NoScheme {
    const NAME: &'static str = "no scheme";
    const ORDER: u32 = 0;
    const SYMMETRIC: bool = false;

    fn keeps(_: Invariant) -> Kept {
        Kept::No
    }
}

/// What is carried from step to step where there is none.
#[derive(Clone, Copy, Debug)]
pub enum NeverBegun {}

impl NeverBegun {
    pub(crate) fn begin() -> Result<Self, NotConverged> {
        Err(NotConverged { iterations: 0, residual: f64::NAN })
    }
}

/// Of no law, as [`WithScheme`] never holds: so that the compiler says what is missing.
impl<L: WithScheme, const D: usize, R: Real> Scheme<L, D, R> for NoScheme {
    type Memory = NeverBegun;

    fn begin(&self, _: &L, _: &Stride<R>, _: &State<D, R>) -> Result<NeverBegun, NotConverged> {
        NeverBegun::begin()
    }

    fn step(&self, _: &L, _: &Stride<R>, _: R, memory: &mut NeverBegun) -> Result<Effort, NotConverged> {
        match *memory {}
    }

    fn position(&self, memory: &NeverBegun) -> [R; D] {
        match *memory {}
    }

    fn velocity(&self, _: &L, _: &Stride<R>, _: R, memory: &NeverBegun) -> [R; D] {
        match *memory {}
    }

    fn finite(&self, memory: &NeverBegun) -> bool {
        match *memory {}
    }

    fn kinetic_energy(&self, _: &L, _: &Stride<R>, memory: &NeverBegun) -> R {
        match *memory {}
    }

    fn work(&self, _: &L, _: &Stride<R>, memory: &NeverBegun, _: &NeverBegun) -> R {
        match *memory {}
    }
}

#[cfg(feature = "serde")]
impl crate::checkpoint::Carried for NeverBegun {
    fn carried(&mut self) -> Vec<&mut [f64]> {
        match *self {}
    }
}
