//! A simulation whose scheme was not chosen.

use super::{Effort, Method, Scheme};
use crate::invariant::{Invariant, Kept};
use crate::newton::NotConverged;
use crate::system::{Beginning, System};

/// No scheme yet: such a simulation cannot run.
#[derive(Clone, Copy, Debug)]
pub struct NoScheme;

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

/// Of no system, as [`WithScheme`] never holds: so that the compiler says what is missing.
impl<Y: System + WithScheme> Scheme<Y> for NoScheme {
    type Memory = NeverBegun;
    type Workspace = ();

    fn workspace(&self, _: &Y, _: &Y::Stride) {}

    fn begin(&self, _: &Y, _: &Y::Stride, _: &Beginning<'_, Y>, (): &mut ()) -> Result<NeverBegun, NotConverged> {
        Err(NotConverged { iterations: 0, residual: f64::NAN })
    }

    fn step(
        &self,
        _: &Y,
        _: &Y::Stride,
        _: Y::Scalar,
        memory: &mut NeverBegun,
        (): &mut (),
    ) -> Result<Effort<Y::Scalar>, NotConverged> {
        match *memory {}
    }

    fn position<'m>(&self, memory: &'m NeverBegun) -> &'m Y::Vector {
        match *memory {}
    }

    fn velocity(&self, _: &Y, _: &Y::Stride, _: Y::Scalar, memory: &NeverBegun) -> Y::Vector {
        match *memory {}
    }

    fn finite(&self, memory: &NeverBegun) -> bool {
        match *memory {}
    }

    fn kinetic_energy(&self, _: &Y, memory: &NeverBegun) -> Y::Scalar {
        match *memory {}
    }

    fn work(&self, _: &Y, _: &Y::Stride, memory: &NeverBegun, _: &NeverBegun) -> Y::Scalar {
        match *memory {}
    }
}

#[cfg(feature = "serde")]
impl crate::checkpoint::Carried for NeverBegun {
    fn carried(&mut self) -> Vec<&mut [f64]> {
        match *self {}
    }
}
