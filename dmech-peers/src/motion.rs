//! The forces of the five motions, written by hand, as other solvers and the loops by hand get them.

use wide::f64x8;

use crate::sine::sine;

/// q″ = a(q), by hand.
pub trait Motion<const D: usize>: Copy {
    /// a(q).
    fn acceleration(&self, q: &[f64; D], a: &mut [f64; D]);

    /// The same at eight places side by side.
    fn in_lanes(&self, q: &[f64x8; D], a: &mut [f64x8; D]);

    /// (∂a/∂q) dq, for solvers that want it.
    fn change(&self, q: &[f64; D], dq: &[f64; D], da: &mut [f64; D]);
}

/// −q/|q|³.
#[derive(Clone, Copy, Debug)]
pub struct Planet;

impl Motion<2> for Planet {
    #[inline(always)]
    fn acceleration(&self, &[x, y]: &[f64; 2], a: &mut [f64; 2]) {
        let c = inverse_cube(x * x + y * y);
        *a = [-c * x, -c * y];
    }

    #[inline(always)]
    fn in_lanes(&self, &[x, y]: &[f64x8; 2], a: &mut [f64x8; 2]) {
        let c = inverse_cubes(x.mul_add(x, y * y));
        *a = [-c * x, -c * y];
    }

    fn change(&self, &[x, y]: &[f64; 2], &[dx, dy]: &[f64; 2], da: &mut [f64; 2]) {
        let s = x * x + y * y;
        let c = inverse_cube(s);
        let along = 3.0 * c * (x * dx + y * dy) / s;
        *da = [along * x - c * dx, along * y - c * dy];
    }
}

/// 1/r³, s = r²: the root and the division side by side.
#[inline(always)]
fn inverse_cube(s: f64) -> f64 {
    s.sqrt() * (1.0 / (s * s))
}

/// The same of eight.
#[inline(always)]
pub(crate) fn inverse_cubes(s: f64x8) -> f64x8 {
    s.sqrt() * (f64x8::ONE / (s * s))
}

/// −sin q.
#[derive(Clone, Copy, Debug)]
pub struct Swing;

impl Motion<1> for Swing {
    #[inline(always)]
    fn acceleration(&self, q: &[f64; 1], a: &mut [f64; 1]) {
        a[0] = -q[0].sin();
    }

    #[inline(always)]
    fn in_lanes(&self, q: &[f64x8; 1], a: &mut [f64x8; 1]) {
        a[0] = -sine(q[0]);
    }

    fn change(&self, q: &[f64; 1], dq: &[f64; 1], da: &mut [f64; 1]) {
        da[0] = -q[0].cos() * dq[0];
    }
}

/// Three bodies of mass 1 in the plane, G = 1.
#[derive(Clone, Copy, Debug)]
pub struct Eight;

impl Eight {
    const PAIRS: [(usize, usize); 3] = [(0, 2), (0, 4), (2, 4)];
}

impl Motion<6> for Eight {
    #[inline(always)]
    fn acceleration(&self, q: &[f64; 6], a: &mut [f64; 6]) {
        *a = [0.0; 6];
        for (i, j) in Self::PAIRS {
            let (x, y) = (q[j] - q[i], q[j + 1] - q[i + 1]);
            let c = inverse_cube(x * x + y * y);
            a[i] += c * x;
            a[i + 1] += c * y;
            a[j] -= c * x;
            a[j + 1] -= c * y;
        }
    }

    #[inline(always)]
    fn in_lanes(&self, q: &[f64x8; 6], a: &mut [f64x8; 6]) {
        *a = [f64x8::ZERO; 6];
        for (i, j) in Self::PAIRS {
            let (x, y) = (q[j] - q[i], q[j + 1] - q[i + 1]);
            let c = inverse_cubes(x.mul_add(x, y * y));
            a[i] = c.mul_add(x, a[i]);
            a[i + 1] = c.mul_add(y, a[i + 1]);
            a[j] = c.mul_neg_add(x, a[j]);
            a[j + 1] = c.mul_neg_add(y, a[j + 1]);
        }
    }

    fn change(&self, q: &[f64; 6], dq: &[f64; 6], da: &mut [f64; 6]) {
        *da = [0.0; 6];
        for (i, j) in Self::PAIRS {
            let mut pull = [0.0; 2];
            Planet.change(&[q[j] - q[i], q[j + 1] - q[i + 1]], &[dq[j] - dq[i], dq[j + 1] - dq[i + 1]], &mut pull);
            da[i] -= pull[0];
            da[i + 1] -= pull[1];
            da[j] += pull[0];
            da[j + 1] += pull[1];
        }
    }
}

/// 64 masses between fixed ends, with springs of energy r²/2 + β r⁴/4.
#[derive(Clone, Copy, Debug)]
pub struct Fput {
    /// β.
    pub beta: f64,
}

impl Motion<64> for Fput {
    #[inline(always)]
    fn acceleration(&self, q: &[f64; 64], a: &mut [f64; 64]) {
        let pull = |r: f64| r + self.beta * r * r * r;
        // Each spring twice: without anything carried along, the loop is made of registers.
        a[0] = pull(q[1] - q[0]) - pull(q[0]);
        for i in 1..63 {
            a[i] = pull(q[i + 1] - q[i]) - pull(q[i] - q[i - 1]);
        }
        a[63] = pull(-q[63]) - pull(q[63] - q[62]);
    }

    #[inline(always)]
    fn in_lanes(&self, q: &[f64x8; 64], a: &mut [f64x8; 64]) {
        let beta = f64x8::splat(self.beta);
        let pull = |r: f64x8| (beta * r * r).mul_add(r, r);
        let mut left = pull(q[0]);
        for i in 0..63 {
            let right = pull(q[i + 1] - q[i]);
            a[i] = right - left;
            left = right;
        }
        a[63] = pull(-q[63]) - left;
    }

    fn change(&self, q: &[f64; 64], dq: &[f64; 64], da: &mut [f64; 64]) {
        let pull = |r: f64, dr: f64| dr + 3.0 * self.beta * r * r * dr;
        let mut left = pull(q[0], dq[0]);
        for i in 0..64 {
            let next = if i < 63 { (q[i + 1], dq[i + 1]) } else { (0.0, 0.0) };
            let right = pull(next.0 - q[i], next.1 - dq[i]);
            da[i] = right - left;
            left = right;
        }
    }
}

#[cfg(test)]
mod tests {
    use dmech::models::{Kepler, Pendulum};
    use dmech::prelude::*;

    use super::*;
    use crate::laws::three_bodies;

    /// Acceleration and change are those of the laws, which dmech differentiates: at places off every symmetry.
    #[test]
    fn forces_by_hand_are_those_of_the_laws() {
        fn agree<M: Motion<D>, const D: usize>(motion: M, q: [f64; D], gradient: [f64; D], hessian: [[f64; D]; D]) {
            let dq: [f64; D] = core::array::from_fn(|i| 0.3 - 0.17 * i as f64);
            let (mut a, mut da) = ([0.0; D], [0.0; D]);
            motion.acceleration(&q, &mut a);
            motion.change(&q, &dq, &mut da);
            for i in 0..D {
                let change: f64 = (0..D).map(|j| -hessian[i][j] * dq[j]).sum();
                assert!((a[i] + gradient[i]).abs() < 1e-13, "a {i}: {} and {}", a[i], -gradient[i]);
                assert!((da[i] - change).abs() < 1e-12, "da {i}: {} and {change}", da[i]);
            }
        }
        let (q, law) = ([0.7, -0.4], Kepler { gm: 1.0 });
        agree(Planet, q, law.gradient(q), law.hessian(q));
        let (q, law) = ([1.3], Pendulum { k: 1.0 });
        agree(Swing, q, law.gradient(q), law.hessian(q));
        let (q, law) = ([0.9, -0.2, -1.1, 0.4, 0.1, 0.3], three_bodies());
        agree(Eight, q, law.gradient(q), law.hessian(q));
    }

    /// ∂a/∂q by differences of the force; the chain's force against its energy too.
    #[test]
    fn the_force_of_the_chain_is_that_of_its_energy() {
        let motion = Fput { beta: 0.3 };
        let q: [f64; 64] = core::array::from_fn(|i| (0.7 * i as f64).sin());
        let energy = |q: &[f64; 64]| {
            let at = |i: usize| if i == 0 || i == 65 { 0.0 } else { q[i - 1] };
            (0..65).map(|i| at(i + 1) - at(i)).map(|r| 0.5 * r * r + motion.beta * r.powi(4) / 4.0).sum::<f64>()
        };
        let (mut a, mut da) = ([0.0; 64], [0.0; 64]);
        motion.acceleration(&q, &mut a);
        for i in 0..64 {
            let moved = |h: f64| core::array::from_fn(|j| if i == j { q[j] + h } else { q[j] });
            let slope = (energy(&moved(1e-4)) - energy(&moved(-1e-4))) / 2e-4;
            assert!((a[i] + slope).abs() < 1e-7, "{i}: {} and {}", a[i], -slope);
        }
        let dq: [f64; 64] = core::array::from_fn(|i| (1.3 * i as f64).cos());
        motion.change(&q, &dq, &mut da);
        let moved = |h: f64| {
            let mut a = [0.0; 64];
            motion.acceleration(&core::array::from_fn(|j| q[j] + h * dq[j]), &mut a);
            a
        };
        let (ahead, behind) = (moved(1e-4), moved(-1e-4));
        for i in 0..64 {
            assert!((da[i] - (ahead[i] - behind[i]) / 2e-4).abs() < 1e-7, "{i}");
        }
    }
    /// Side by side as one by one, but for roundings.
    #[test]
    fn lanes_are_the_same_force() {
        fn agree<M: Motion<D>, const D: usize>(motion: M, place: impl Fn(usize, usize) -> f64) {
            let q: [f64x8; D] = core::array::from_fn(|k| f64x8::new(core::array::from_fn(|lane| place(k, lane))));
            let mut lanes = [f64x8::ZERO; D];
            motion.in_lanes(&q, &mut lanes);
            for lane in 0..8 {
                let mut a = [0.0; D];
                motion.acceleration(&core::array::from_fn(|k| q[k].to_array()[lane]), &mut a);
                for k in 0..D {
                    let found = lanes[k].to_array()[lane];
                    assert!((found - a[k]).abs() <= 1e-14 * (1.0 + a[k].abs()), "{k}, {lane}: {found} and {}", a[k]);
                }
            }
        }
        let place = |k: usize, lane: usize| (2.7 * k as f64 + 0.31).sin() + 0.05 * lane as f64;
        agree(Planet, place);
        agree(Swing, place);
        agree(Eight, place);
        agree(Fput { beta: 0.3 }, place);
    }
}
