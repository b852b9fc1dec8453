//! The local time scale of a motion, from the law.

use core::array::from_fn;

use crate::law::{Field, Law, Potential};
use crate::vector::{add_scaled, finite};

/// What the motion is like where it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Look {
    /// ω = 1/Q, the angular frequency of the linearised motion: the mean over the neighbourhood.
    pub(super) rate: f64,
    /// d ln ω/dt along the motion.
    pub(super) growth: f64,
}

/// A place of the motion, and how it is looked at.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place<const D: usize> {
    pub(super) t: f64,
    pub(super) q: [f64; D],
    pub(super) v: [f64; D],
    pub(super) mass: f64,
    /// The angle ω s of the neighbourhood, from −s to s.
    pub(super) angle: f64,
    /// The smallest ω that counts.
    pub(super) least: f64,
}

/// Stiffness that the neighbourhood may have over that of its middle before it is narrowed.
const EVEN: f64 = 4.0;

impl<const D: usize> Place<D> {
    /// Looks at the law here and s = angle/ω before and after, on the parabola q ± s v + s² a/2.
    ///
    /// Everything is even under v → −v but the growth, which is odd: that makes the step density reversible. The means
    /// over each side keep ω away from 0 where ∂a/∂q passes through 0 (a pendulum at a right angle).
    pub(super) fn look<L: Law<D>>(&self, law: &L) -> Look {
        let here = self.stiffness(law, self.t, self.q, self.v);
        let slope = law.field(self.mass, self.t).slope(self.q, self.v);
        let mut reach = self.angle / here.sqrt();
        let (mut after, mut before) = self.sides(law, slope, reach, here);
        // At an isolated zero of ∂a/∂q the reach is longer than the motion is alike.
        for _ in 0..MOST {
            let mean = 0.25 * (after + here + here + before);
            let excess = mean * (reach / self.angle).powi(2);
            if excess <= EVEN || !here.is_finite() {
                break;
            }
            reach = if excess.is_finite() { reach * excess.powf(-0.25) } else { reach.min(1e150) * 1e-3 };
            (after, before) = self.sides(law, slope, reach, here);
        }
        let rate = (0.25 * (after + here + here + before)).sqrt();
        let growth = 0.5 * ((here + after) / (here + before)).ln() / reach;
        Look { rate, growth: if growth.is_finite() { growth } else { 0.0 } }
    }

    /// ω² after and before.
    fn sides<L: Law<D>>(&self, law: &L, slope: [f64; D], reach: f64, here: f64) -> (f64, f64) {
        let side = |s: f64| {
            let fall = -0.5 * s * s / self.mass;
            let q = from_fn(|i| fall.mul_add(slope[i], s.mul_add(self.v[i], self.q[i])));
            let v = add_scaled(self.v, -s / self.mass, slope);
            // Where the law ends, its middle must do.
            if !finite(q) {
                return f64::INFINITY;
            }
            let side = self.stiffness(law, self.t + s, q, v);
            if side.is_nan() { here } else { side }
        };
        (side(reach), side(-reach))
    }

    /// ω² = √(‖∂a/∂q‖² + ‖∂a/∂v‖⁴ + ω_least⁴), with Frobenius norms.
    fn stiffness<L: Law<D>>(&self, law: &L, t: f64, q: [f64; D], v: [f64; D]) -> f64 {
        let field = law.field(self.mass, t);
        let mut by_position = field.hessian(q);
        let mut damping = 0.0;
        if <L::Field<'_> as Field<D>>::FORCED {
            let force = field.force_dq(q, v, t);
            by_position = from_fn(|i| from_fn(|j| by_position[i][j] - force[i][j]));
            damping = square(&field.force_dv(q, v, t)) / (self.mass * self.mass);
        }
        let least = self.least * self.least;
        let stiffness = square(&by_position) / (self.mass * self.mass);
        (stiffness + damping * damping + least * least).sqrt()
    }
}

/// How often a neighbourhood is narrowed at most.
const MOST: u32 = 100;

fn square<const D: usize>(matrix: &[[f64; D]; D]) -> f64 {
    matrix.iter().flatten().map(|x| x * x).sum()
}
