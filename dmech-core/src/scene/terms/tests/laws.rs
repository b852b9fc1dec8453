//! Laws with a force of every kind, written by hand.

use core::array::from_fn;

use dmech_scalar::Real;

use crate::law::{Between, PairLaw, Reads, Symmetric, radial};
use crate::law::{Conservative, Field, Law, Potential, VelocityIndependent};

/// −G mₐ m_b/r between two bodies.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gravity {
    pub(super) g: f64,
}

/// −k/r.
#[derive(Clone, Copy, Debug)]
pub(super) struct Attraction<R>(pub(super) R);

impl Conservative for Attraction<f64> {}
impl Symmetric for Gravity {}
impl VelocityIndependent for Gravity {}

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

impl<const D: usize, R: Real> Between<D, R> for Attraction<R> {}

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

/// k d²/2 between two bodies.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spring {
    pub(super) k: f64,
}

impl<P> Reads<P> for Spring {
    type Numbers = [f64; 0];
    fn numbers(_: f64, _: &P) -> [f64; 0] {
        []
    }
}

impl<const D: usize, P, R: Real> PairLaw<D, P, R> for Spring {
    type Between<'a> = Spring;
    fn between(&self, _: [R; 0], _: [R; 0], _: R) -> Spring {
        *self
    }
}

impl<const D: usize, R: Real> Between<D, R> for Spring {}

impl<const D: usize, R: Real> Potential<D, R> for Spring {
    const LINEAR: bool = true;
    fn potential(&self, d: [R; D]) -> R {
        R::from_f64(0.5 * self.k) * radial::square(d)
    }
    fn gradient(&self, d: [R; D]) -> [R; D] {
        radial::gradient(R::from_f64(self.k), d)
    }
    fn hessian(&self, d: [R; D]) -> [[R; D]; D] {
        radial::hessian(R::from_f64(self.k), R::ZERO, d)
    }
    fn discrete_gradient(&self, a: [R; D], b: [R; D]) -> [R; D] {
        radial::discrete_gradient(R::from_f64(0.5 * self.k), a, b)
    }
    fn discrete_gradient_jacobian(&self, a: [R; D], b: [R; D]) -> [[R; D]; D] {
        radial::discrete_gradient_jacobian(R::from_f64(0.5 * self.k), R::ZERO, a, b)
    }
}

/// Nothing but a force acts.
macro_rules! without_potential {
    ($([$($generic:tt)*] $law:ty, $r:ty;)*) => {$(
        impl<$($generic)*> Potential<D, $r> for $law {
            fn potential(&self, _: [$r; D]) -> $r {
                <$r as Real>::ZERO
            }
            fn gradient(&self, _: [$r; D]) -> [$r; D] {
                [<$r as Real>::ZERO; D]
            }
            fn hessian(&self, _: [$r; D]) -> [[$r; D]; D] {
                [[<$r as Real>::ZERO; D]; D]
            }
            fn discrete_gradient(&self, _: [$r; D], _: [$r; D]) -> [$r; D] {
                [<$r as Real>::ZERO; D]
            }
            fn discrete_gradient_jacobian(&self, _: [$r; D], _: [$r; D]) -> [[$r; D]; D] {
                [[<$r as Real>::ZERO; D]; D]
            }
        }
    )*};
}

without_potential! {
    [const D: usize, R: Real, const RECIPROCAL: bool] Pulls<R, RECIPROCAL>, R;
    [const D: usize] Wind, f64;
}

/// The force −k d |d|² − γ (vₐ − β v_b) on a from b, times m_b; if `RECIPROCAL` it is opposite on b.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pull<const RECIPROCAL: bool> {
    pub(super) k: f64,
    pub(super) gamma: f64,
    pub(super) beta: f64,
}

/// [k, γ, β], with the masses in them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pulls<R, const RECIPROCAL: bool>(pub(super) [R; 3]);

impl<const RECIPROCAL: bool> Symmetric for Pull<RECIPROCAL> {}

impl<P, const RECIPROCAL: bool> Reads<P> for Pull<RECIPROCAL> {
    type Numbers = [f64; 1];
    fn numbers(mass: f64, _: &P) -> [f64; 1] {
        [mass]
    }
}

impl<const D: usize, P, R: Real, const RECIPROCAL: bool> PairLaw<D, P, R> for Pull<RECIPROCAL> {
    type Between<'a> = Pulls<R, RECIPROCAL>;
    fn between(&self, [ma]: [R; 1], [mb]: [R; 1], _: R) -> Self::Between<'_> {
        let mass = if RECIPROCAL { ma * mb } else { mb };
        Pulls([R::from_f64(self.k) * mass, R::from_f64(self.gamma) * mass, R::from_f64(self.beta)])
    }
}

impl<const D: usize, R: Real, const RECIPROCAL: bool> Between<D, R> for Pulls<R, RECIPROCAL> {
    const POTENTIAL: bool = false;
    const FORCED: bool = true;
    const RECIPROCAL: bool = RECIPROCAL;
    fn force(&self, d: [R; D], va: [R; D], vb: [R; D]) -> [R; D] {
        let [k, gamma, beta] = self.0;
        let s = radial::square(d);
        from_fn(|i| -(k * s * d[i] + gamma * (va[i] - beta * vb[i])))
    }
    fn force_jacobians(&self, d: [R; D], _: [R; D], _: [R; D]) -> [[[R; D]; D]; 3] {
        let [k, gamma, beta] = self.0;
        let unit = |x: R| from_fn(|i| from_fn(|j| if i == j { x } else { R::ZERO }));
        let by_d = radial::hessian(k * radial::square(d), k, d).map(|row| row.map(|x| -x));
        [by_d, unit(-gamma), unit(gamma * beta)]
    }
}

/// The same as a law of one body, the other at rest in the origin.
impl<const D: usize> Law<D> for Pulls<f64, true> {
    type Field<'a> = Self;
    fn field(&self, _: f64, _: f64) -> Self {
        *self
    }
}

impl<const D: usize> Field<D> for Pulls<f64, true> {
    const FORCED: bool = true;
    const CONSERVES_ENERGY: bool = false;
    fn slope(&self, q: [f64; D], v: [f64; D]) -> [f64; D] {
        Between::force(self, q, v, [0.0; D]).map(|f| -f)
    }
    fn force(&self, q: [f64; D], v: [f64; D], _: f64) -> [f64; D] {
        Between::force(self, q, v, [0.0; D])
    }
    fn force_dq(&self, q: [f64; D], v: [f64; D], _: f64) -> [[f64; D]; D] {
        self.force_jacobians(q, v, [0.0; D])[0]
    }
    fn force_dv(&self, q: [f64; D], v: [f64; D], _: f64) -> [[f64; D]; D] {
        self.force_jacobians(q, v, [0.0; D])[1]
    }
}

/// The force m c q² on each component, and no potential.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wind {
    pub(super) c: f64,
}

impl VelocityIndependent for Wind {}

impl<const D: usize> Law<D> for Wind {
    type Field<'a> = Wind;
    fn field(&self, mass: f64, _: f64) -> Wind {
        Wind { c: mass * self.c }
    }
}

impl<const D: usize> Field<D> for Wind {
    const FORCED: bool = true;
    const CONSERVES_ENERGY: bool = false;
    fn slope(&self, q: [f64; D], v: [f64; D]) -> [f64; D] {
        self.force(q, v, 0.0).map(|f| -f)
    }
    fn force(&self, q: [f64; D], _: [f64; D], _: f64) -> [f64; D] {
        q.map(|x| self.c * x * x)
    }
    fn force_dq(&self, q: [f64; D], _: [f64; D], _: f64) -> [[f64; D]; D] {
        from_fn(|i| from_fn(|j| if i == j { 2.0 * self.c * q[i] } else { 0.0 }))
    }
}
