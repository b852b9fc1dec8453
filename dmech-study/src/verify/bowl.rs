//! The law of the motions that a scheme is verified in: a bowl, of one body or between two.

#[cfg(feature = "scene")]
use dmech_core::extend::{Between, Numbers, PairLaw, Reads, Symmetric};
use dmech_core::extend::{Real, radial};
use dmech_core::{Conservative, Potential};

/// Φ = k s/2 + l s²/4 with s = |q|², or |d|² between two bodies: nonlinear, central, smooth.
#[derive(Clone, Copy, Debug)]
pub struct Bowl {
    pub(super) k: f64,
    pub(super) l: f64,
}

impl Conservative for Bowl {}

impl<const D: usize, R: Real> Potential<D, R> for Bowl {
    const CENTRAL: bool = true;

    fn potential(&self, q: [R; D]) -> R {
        let s = radial::square(q);
        let [k, l] = [0.5 * self.k, 0.25 * self.l].map(R::from_f64);
        (l * s + k) * s
    }
    fn gradient(&self, q: [R; D]) -> [R; D] {
        let [k, l] = [self.k, self.l].map(R::from_f64);
        radial::gradient(l * radial::square(q) + k, q)
    }
    fn hessian(&self, q: [R; D]) -> [[R; D]; D] {
        let [k, l] = [self.k, self.l].map(R::from_f64);
        radial::hessian(l * radial::square(q) + k, l, q)
    }
    fn discrete_gradient(&self, a: [R; D], b: [R; D]) -> [R; D] {
        let [k, l] = [0.5 * self.k, 0.25 * self.l].map(R::from_f64);
        radial::discrete_gradient(l * (radial::square(a) + radial::square(b)) + k, a, b)
    }
    fn discrete_gradient_jacobian(&self, a: [R; D], b: [R; D]) -> [[R; D]; D] {
        let [k, l] = [0.5 * self.k, 0.25 * self.l].map(R::from_f64);
        radial::discrete_gradient_jacobian(l * (radial::square(a) + radial::square(b)) + k, l, a, b)
    }
}

#[cfg(feature = "scene")]
#[diagnostic::do_not_recommend]
impl Symmetric for Bowl {}

#[cfg(feature = "scene")]
impl<P> Reads<P> for Bowl {
    type Numbers = [f64; 0];

    fn numbers(_: f64, _: &P) -> [f64; 0] {
        []
    }
}

#[cfg(feature = "scene")]
impl<const D: usize, R: Real> Between<D, R> for &Bowl {}

#[cfg(feature = "scene")]
impl<const D: usize, P, R: Real> PairLaw<D, P, R> for Bowl {
    type Between<'a> = &'a Bowl;

    fn between(&self, _: <[f64; 0] as Numbers>::Of<R>, _: <[f64; 0] as Numbers>::Of<R>, _: R) -> &Bowl {
        self
    }
}
