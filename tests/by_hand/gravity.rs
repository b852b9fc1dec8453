//! Newton's gravity between two bodies, written by hand.

use dmech_core::prelude::*;
use dmech_core::{Between, PairLaw, Reads, Real, Symmetric, radial};

/// Φ = −G ma mb/r.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Gravity {
    pub(crate) g: f64,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Attraction<R>(R);

impl<P> Reads<P> for Gravity {
    type Numbers = [f64; 1];
    fn numbers(mass: f64, _: &P) -> [f64; 1] {
        [mass]
    }
}

impl<const D: usize, P, R: Real> PairLaw<D, P, R> for Gravity {
    type Between<'a> = Attraction<R>;
    fn between(&self, [ma]: [R; 1], [mb]: [R; 1], _: R) -> Attraction<R> {
        Attraction(R::from_f64(self.g) * ma * mb)
    }
}

impl<const D: usize, R: Real> Potential<D, R> for Attraction<R> {
    const CENTRAL: bool = true;
    fn potential(&self, d: [R; D]) -> R {
        -self.0 / radial::square(d).sqrt()
    }
    fn gradient(&self, d: [R; D]) -> [R; D] {
        let s = radial::square(d);
        radial::gradient(self.0 / (s * s.sqrt()), d)
    }
    fn hessian(&self, d: [R; D]) -> [[R; D]; D] {
        let s = radial::square(d);
        let c = self.0 / (s * s.sqrt());
        radial::hessian(c, R::from_f64(-1.5) * c / s, d)
    }
    fn discrete_gradient(&self, a: [R; D], b: [R; D]) -> [R; D] {
        let (x, y) = (radial::square(a).sqrt(), radial::square(b).sqrt());
        radial::discrete_gradient(self.0 / (x * y * (x + y)), a, b)
    }
    fn discrete_gradient_jacobian(&self, a: [R; D], b: [R; D]) -> [[R; D]; D] {
        let (x, y) = (radial::square(a).sqrt(), radial::square(b).sqrt());
        let c = self.0 / (x * y * (x + y));
        radial::discrete_gradient_jacobian(c, -c * (x + y + y) / ((y + y) * y * (x + y)), a, b)
    }
}
impl<const D: usize, R: Real> Between<D, R> for Attraction<R> {}
impl Symmetric for Gravity {}
impl VelocityIndependent for Gravity {}
