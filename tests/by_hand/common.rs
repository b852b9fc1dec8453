//! Laws written by hand, and the exact motion on Greenspan's orbit.
#![allow(dead_code, unreachable_pub)] // each test file uses its part

use dmech_core::newton::{Equation, Increment, NotConverged, central, dense, dense_discrete, once};
use dmech_core::prelude::*;
use dmech_core::{Field, Real, newton::Correction};

/// A law by hand whose implicit steps are its own too: its field is itself, always.
macro_rules! its_own_field {
    ([$($generics:tt)*] [$($of:tt)*] $law:ty, $d:tt, $r:ty) => {
        impl<$($of)*> VelocityIndependent for $law {}
        impl<$($of)*> MassIndependent for $law {}
        impl<$($generics)*> Law<$d, $r> for $law {
            type Field<'a> = &'a Self;

            fn field(&self, _: $r, _: $r) -> &Self {
                self
            }
        }
    };
}

/// Φ = −k/|q| in the plane, (3.23)–(3.25) of Kanatani. With `CENTRAL` the steps have one scalar unknown; without, two.
#[derive(Clone, Copy, Debug)]
pub struct Kepler<const ONE_UNKNOWN: bool> {
    pub k: f64,
}

pub const SUN: Kepler<true> = Kepler { k: 1.0 };
pub const SUN_BY_COMPONENTS: Kepler<false> = Kepler { k: 1.0 };

its_own_field!([const ONE_UNKNOWN: bool, R: Real] [const ONE_UNKNOWN: bool] Kepler<ONE_UNKNOWN>, 2, R);

impl<const ONE_UNKNOWN: bool, R: Real> Field<2, R> for &Kepler<ONE_UNKNOWN> {
    fn implicit_increment(&self, equation: &Equation<2, R>) -> Result<Increment<2, R>, NotConverged> {
        if !ONE_UNKNOWN {
            return dense(equation, |b| (self.gradient(b), self.hessian(b)));
        }
        let k = R::from_f64(self.k);
        central::implicit(equation, |s| {
            let c = k / (s * s.sqrt());
            let c1 = R::from_f64(-1.5) * c / s;
            [c, c1, R::from_f64(-2.5) * c1 / s]
        })
    }
    fn discrete_increment(&self, equation: &Equation<2, R>) -> Result<Increment<2, R>, NotConverged> {
        if !ONE_UNKNOWN {
            return dense_discrete(equation, |a, b| {
                (self.discrete_gradient(a, b), self.discrete_gradient_jacobian(a, b))
            });
        }
        let k = R::from_f64(self.k);
        central::discrete(equation, |sa, sb| {
            // C = k/(α β (α + β)) with α = |a|, β = |b|; d/ds = (1/2β) d/dβ.
            let (alpha, beta) = (sa.sqrt(), sb.sqrt());
            let (inv, inv_sum) = (beta.recip(), (alpha + beta).recip());
            let c = k / (alpha * beta * (alpha + beta));
            let log_slope = -(inv + inv_sum);
            let d = c * log_slope;
            let dd = c * (log_slope * log_slope + inv * inv + inv_sum * inv_sum);
            let half = R::from_f64(0.5);
            [c, half * inv * d, half * half * inv * inv * (dd - inv * d)]
        })
    }
}

impl<const ONE_UNKNOWN: bool, R: Real> Potential<2, R> for Kepler<ONE_UNKNOWN> {
    const CENTRAL: bool = true;

    fn potential(&self, q: [R; 2]) -> R {
        -R::from_f64(self.k) / radius(q)
    }

    fn gradient(&self, q: [R; 2]) -> [R; 2] {
        let s = q[0] * q[0] + q[1] * q[1];
        let c = R::from_f64(self.k) / (s * s.sqrt());
        q.map(|x| c * x)
    }

    fn hessian(&self, q: [R; 2]) -> [[R; 2]; 2] {
        let s = q[0] * q[0] + q[1] * q[1];
        let c = R::from_f64(self.k) / (s * s.sqrt());
        let d = R::from_f64(-3.0) * c / s;
        [[c + d * q[0] * q[0], d * q[0] * q[1]], [d * q[0] * q[1], c + d * q[1] * q[1]]]
    }

    fn discrete_gradient(&self, a: [R; 2], b: [R; 2]) -> [R; 2] {
        let (ra, rb) = (radius(a), radius(b));
        let c = R::from_f64(self.k) / (ra * rb * (ra + rb));
        [c * (a[0] + b[0]), c * (a[1] + b[1])]
    }

    fn discrete_gradient_jacobian(&self, a: [R; 2], b: [R; 2]) -> [[R; 2]; 2] {
        let (ra, rb) = (radius(a), radius(b));
        let c = R::from_f64(self.k) / (ra * rb * (ra + rb));
        let d = -c * (rb.recip() + (ra + rb).recip()) / rb;
        let sum = [a[0] + b[0], a[1] + b[1]];
        [[c + d * sum[0] * b[0], d * sum[0] * b[1]], [d * sum[1] * b[0], c + d * sum[1] * b[1]]]
    }
}

fn radius<R: Real>(q: [R; 2]) -> R {
    (q[0] * q[0] + q[1] * q[1]).sqrt()
}

/// Φ = k |q|²/2 in D coordinates: linear, so that a step is one correction. (3.16)–(3.21) of Kanatani.
#[derive(Clone, Copy, Debug)]
pub struct Spring {
    pub k: f64,
}

its_own_field!([const D: usize, R: Real] [] Spring, D, R);

impl<const D: usize, R: Real> Field<D, R> for &Spring {
    fn implicit_increment(&self, equation: &Equation<D, R>) -> Result<Increment<D, R>, NotConverged> {
        once(equation, |e, delta, b| linear(e, delta, self.gradient(b), R::from_f64(self.k)))
    }
    fn discrete_increment(&self, equation: &Equation<D, R>) -> Result<Increment<D, R>, NotConverged> {
        once(equation, |e, delta, b| linear(e, delta, self.discrete_gradient(e.a, b), R::from_f64(0.5 * self.k)))
    }
}

impl<const D: usize, R: Real> Potential<D, R> for Spring {
    const CENTRAL: bool = true;
    const LINEAR: bool = true;

    fn potential(&self, q: [R; D]) -> R {
        R::from_f64(0.5 * self.k) * q.iter().fold(R::ZERO, |s, &x| s + x * x)
    }
    fn gradient(&self, q: [R; D]) -> [R; D] {
        q.map(|x| R::from_f64(self.k) * x)
    }
    fn hessian(&self, _: [R; D]) -> [[R; D]; D] {
        diagonal(R::from_f64(self.k))
    }
    fn discrete_gradient(&self, a: [R; D], b: [R; D]) -> [R; D] {
        core::array::from_fn(|i| R::from_f64(0.5 * self.k) * (a[i] + b[i]))
    }
    fn discrete_gradient_jacobian(&self, _: [R; D], _: [R; D]) -> [[R; D]; D] {
        diagonal(R::from_f64(0.5 * self.k))
    }
}

/// The correction, and the pivot.
fn linear<const D: usize, R: Real>(
    e: &Equation<D, R>,
    delta: [R; D],
    gradient: [R; D],
    j: R,
) -> (Correction<D, R>, [R; 1]) {
    let (wanted, pivot) = (e.increment(gradient), R::ONE + e.g * j);
    let delta: [R; D] = core::array::from_fn(|i| (wanted[i] - delta[i]) / pivot);
    (Correction::in_parts(delta, gradient, delta.map(|x| j * x)), [pivot])
}

fn diagonal<const D: usize, R: Real>(x: R) -> [[R; D]; D] {
    core::array::from_fn(|i| core::array::from_fn(|j| if i == j { x } else { R::ZERO }))
}

/// Φ = k s/2 + λ s²/4 with s = |q|²: central, not linear, and smooth at the centre, which it passes through.
#[derive(Clone, Copy, Debug)]
pub struct Quartic {
    pub k: f64,
    pub lambda: f64,
}

its_own_field!([const D: usize] [] Quartic, D, f64);

impl<const D: usize> Field<D, f64> for &Quartic {
    fn implicit_increment(&self, equation: &Equation<D, f64>) -> Result<Increment<D, f64>, NotConverged> {
        central::implicit(equation, |s| [self.k + self.lambda * s, self.lambda, 0.0])
    }
    fn discrete_increment(&self, equation: &Equation<D, f64>) -> Result<Increment<D, f64>, NotConverged> {
        central::discrete(equation, |sa, sb| [0.5 * self.k + 0.25 * self.lambda * (sa + sb), 0.25 * self.lambda, 0.0])
    }
}

impl<const D: usize> Potential<D> for Quartic {
    const CENTRAL: bool = true;

    fn potential(&self, q: [f64; D]) -> f64 {
        let s = square(q);
        0.5 * self.k * s + 0.25 * self.lambda * s * s
    }
    fn gradient(&self, q: [f64; D]) -> [f64; D] {
        q.map(|x| (self.k + self.lambda * square(q)) * x)
    }
    fn hessian(&self, q: [f64; D]) -> [[f64; D]; D] {
        let c = self.k + self.lambda * square(q);
        core::array::from_fn(|i| {
            core::array::from_fn(|j| 2.0 * self.lambda * q[i] * q[j] + if i == j { c } else { 0.0 })
        })
    }
    fn discrete_gradient(&self, a: [f64; D], b: [f64; D]) -> [f64; D] {
        let c = 0.5 * self.k + 0.25 * self.lambda * (square(a) + square(b));
        core::array::from_fn(|i| c * (a[i] + b[i]))
    }
    fn discrete_gradient_jacobian(&self, a: [f64; D], b: [f64; D]) -> [[f64; D]; D] {
        let c = 0.5 * self.k + 0.25 * self.lambda * (square(a) + square(b));
        core::array::from_fn(|i| {
            core::array::from_fn(|j| 0.5 * self.lambda * (a[i] + b[i]) * b[j] + if i == j { c } else { 0.0 })
        })
    }
}

fn square<const D: usize>(q: [f64; D]) -> f64 {
    q.iter().map(|x| x * x).sum()
}

/// Φ = −k cos q.
#[derive(Clone, Copy, Debug)]
pub struct Pendulum {
    pub k: f64,
}

impl Conservative for Pendulum {}

impl<R: Real> Potential<1, R> for Pendulum {
    fn potential(&self, [q]: [R; 1]) -> R {
        -R::from_f64(self.k) * q.cos()
    }
    fn gradient(&self, [q]: [R; 1]) -> [R; 1] {
        [R::from_f64(self.k) * q.sin()]
    }
    fn hessian(&self, [q]: [R; 1]) -> [[R; 1]; 1] {
        [[R::from_f64(self.k) * q.cos()]]
    }
    fn discrete_gradient(&self, [a]: [R; 1], [b]: [R; 1]) -> [R; 1] {
        let half = R::from_f64(0.5);
        [R::from_f64(self.k) * (half * (a + b)).sin() * (half * (b - a)).sinc()]
    }
    fn discrete_gradient_jacobian(&self, [a]: [R; 1], [b]: [R; 1]) -> [[R; 1]; 1] {
        let half = R::from_f64(0.5);
        let (m, d) = (half * (a + b), half * (b - a));
        [[R::from_f64(0.5 * self.k) * (m.cos() * d.sinc() + m.sin() * d * d.sinc_slope())]]
    }
}

/// An anisotropic quartic in three coordinates, neither central nor linear: Φ = ½ Σ kᵢ qᵢ² + λ (q₀² q₁ + q₁² q₂)/2.
#[derive(Clone, Copy, Debug)]
pub struct Coupled {
    pub k: [f64; 3],
    pub lambda: f64,
}

impl Conservative for Coupled {}

impl Potential<3> for Coupled {
    fn potential(&self, q: [f64; 3]) -> f64 {
        let quadratic: f64 = (0..3).map(|i| 0.5 * self.k[i] * q[i] * q[i]).sum();
        quadratic + 0.5 * self.lambda * (q[0] * q[0] * q[1] + q[1] * q[1] * q[2])
    }
    fn gradient(&self, q: [f64; 3]) -> [f64; 3] {
        self.discrete_gradient(q, q)
    }
    fn hessian(&self, q: [f64; 3]) -> [[f64; 3]; 3] {
        let l = self.lambda;
        [[self.k[0] + l * q[1], l * q[0], 0.0], [l * q[0], self.k[1] + l * q[2], l * q[1]], [0.0, l * q[1], self.k[2]]]
    }
    /// u² w goes to (a_u + b_u) mean(w) along u and mean(u²) along w.
    fn discrete_gradient(&self, a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
        let m: [f64; 3] = core::array::from_fn(|i| 0.5 * (a[i] + b[i]));
        let squares: [f64; 3] = core::array::from_fn(|i| 0.5 * (a[i] * a[i] + b[i] * b[i]));
        let l = self.lambda;
        [
            self.k[0] * m[0] + l * m[0] * m[1],
            self.k[1] * m[1] + 0.5 * l * squares[0] + l * m[1] * m[2],
            self.k[2] * m[2] + 0.5 * l * squares[1],
        ]
    }
    fn discrete_gradient_jacobian(&self, a: [f64; 3], b: [f64; 3]) -> [[f64; 3]; 3] {
        let m: [f64; 3] = core::array::from_fn(|i| 0.5 * (a[i] + b[i]));
        let l = self.lambda;
        let half = |x: f64| 0.5 * x;
        [
            [half(self.k[0] + l * m[1]), half(l * m[0]), 0.0],
            [half(l * b[0]), half(self.k[1] + l * m[2]), half(l * m[1])],
            [0.0, half(l * b[1]), half(self.k[2])],
        ]
    }
}

/// A spring whose stiffness is driven: Φ = ½ k (1 + ε cos ωt) q², for a particle of any mass. A law that names the time.
#[derive(Clone, Copy, Debug)]
pub struct DrivenSpring {
    pub k: f64,
    pub epsilon: f64,
    pub omega: f64,
}

impl VelocityIndependent for DrivenSpring {}

impl<const D: usize> dmech_core::Field<D> for Spring {}

impl Law<1> for DrivenSpring {
    type Field<'a> = Spring;
    const AUTONOMOUS: bool = false;

    fn field(&self, _mass: f64, t: f64) -> Spring {
        Spring { k: self.k * (1.0 + self.epsilon * (self.omega * t).cos()) }
    }
}

/// Greenspan §5: from the pericentre, k = 1.
pub fn greenspan_orbit() -> State<2> {
    State::new([0.5, 0.0], [0.0, 1.63])
}

/// Where the planet of [`greenspan_orbit`] is at time t: q = a (cos E − e, √(1−e²) sin E), E − e sin E = n t.
pub fn kepler_position(t: f64) -> [f64; 2] {
    let a: f64 = 1.0 / (2.0 / 0.5 - 1.63 * 1.63);
    let e = 1.0 - 0.5 / a;
    let mean_anomaly = t / (a * a.sqrt());
    let mut anomaly = mean_anomaly;
    for _ in 0..50 {
        anomaly -= (anomaly - e * anomaly.sin() - mean_anomaly) / (1.0 - e * anomaly.cos());
    }
    [a * (anomaly.cos() - e), a * (1.0 - e * e).sqrt() * anomaly.sin()]
}

/// An orbit about a centre of strength 1 with semi-major axis 1, from its apocentre; its period is 2π.
pub fn from_apocentre(eccentricity: f64) -> State<2> {
    let r = 1.0 + eccentricity;
    State::new([r, 0.0], [0.0, ((1.0 - eccentricity) / r).sqrt()])
}
