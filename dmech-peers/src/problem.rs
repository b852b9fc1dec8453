//! The five motions: forces written by hand, as other solvers get them, starts, ends, and where they end.

use std::f64::consts::{FRAC_PI_4, PI};

use dmech::models::{Kepler, Pendulum};
use dmech::prelude::*;

use crate::laws::{chain, three_bodies};

/// q″ = a(q), by hand.
pub trait Motion<const D: usize>: Copy {
    /// a(q).
    fn acceleration(&self, q: &[f64; D], a: &mut [f64; D]);

    /// (∂a/∂q) dq, for solvers that want it.
    fn change(&self, q: &[f64; D], dq: &[f64; D], da: &mut [f64; D]);
}

/// A motion from a start at t = 0 to an end.
#[derive(Clone, Copy, Debug)]
pub struct Problem<M, const D: usize> {
    /// In names of files.
    pub name: &'static str,
    /// In tables and pictures.
    pub title: &'static str,
    /// The force.
    pub motion: M,
    /// The start.
    pub start: State<D>,
    /// The end.
    pub end: f64,
    /// The position at the end.
    pub truth: [f64; D],
    /// The longest step that is tried.
    pub coarse: f64,
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

/// −sin q.
#[derive(Clone, Copy, Debug)]
pub struct Swing;

impl Motion<1> for Swing {
    #[inline(always)]
    fn acceleration(&self, q: &[f64; 1], a: &mut [f64; 1]) {
        a[0] = -q[0].sin();
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

/// 64 masses between fixed ends, with springs of energy r²/2 + α r³/3.
#[derive(Clone, Copy, Debug)]
pub struct Fput {
    /// α.
    pub alpha: f64,
}

impl Motion<64> for Fput {
    #[inline(always)]
    fn acceleration(&self, q: &[f64; 64], a: &mut [f64; 64]) {
        let pull = |r: f64| r + self.alpha * r * r;
        // Each spring twice: without anything carried along, the loop is made of registers.
        a[0] = pull(q[1] - q[0]) - pull(q[0]);
        for i in 1..63 {
            a[i] = pull(q[i + 1] - q[i]) - pull(q[i] - q[i - 1]);
        }
        a[63] = pull(-q[63]) - pull(q[63] - q[62]);
    }

    fn change(&self, q: &[f64; 64], dq: &[f64; 64], da: &mut [f64; 64]) {
        let pull = |r: f64, dr: f64| dr + 2.0 * self.alpha * r * dr;
        let mut left = pull(q[0], dq[0]);
        for i in 0..64 {
            let next = if i < 63 { (q[i + 1], dq[i + 1]) } else { (0.0, 0.0) };
            let right = pull(next.0 - q[i], next.1 - dq[i]);
            da[i] = right - left;
            left = right;
        }
    }
}

/// Greenspan's planet, 87 revolutions on an ellipse of eccentricity 0.33.
pub fn orbit() -> Problem<Planet, 2> {
    let half_axis = 1.0 / (2.0 / 0.5 - 1.63 * 1.63);
    Problem {
        name: "orbit",
        title: "Greenspan's orbit to t = 350",
        motion: Planet,
        start: State::new([0.5, 0.0], [0.0, 1.63]),
        end: 350.0,
        truth: Kepler { gm: 1.0 }.exact(half_axis, 1.0 - 0.5 / half_axis, 350.0),
        coarse: 1.0,
    }
}

/// 100 periods of an ellipse of eccentricity 0.9 from its apocentre, which is where they end; major half-axis 1.
pub fn eccentric() -> Problem<Planet, 2> {
    Problem {
        name: "eccentric",
        title: "Kepler, e = 0.9, 100 periods from apocentre",
        motion: Planet,
        start: State::new([-1.9, 0.0], [0.0, -(0.1_f64 / 1.9).sqrt()]),
        end: 200.0 * PI,
        truth: [-1.9, 0.0],
        coarse: 1.0,
    }
}

/// The pendulum from π/4 at rest.
pub fn pendulum() -> Problem<Swing, 1> {
    Problem {
        name: "pendulum",
        title: "Pendulum from π/4 to t = 100",
        motion: Swing,
        start: State::new([FRAC_PI_4], [0.0]),
        end: 100.0,
        truth: [Pendulum { k: 1.0 }.exact(FRAC_PI_4, 100.0)],
        coarse: 4.0,
    }
}

/// Three bodies on a figure of eight, 15.8 times around.
///
/// A. Chenciner, R. Montgomery, Ann. Math. 152 (2000) 881–901, digits by C. Simó. The end is a reference by
/// `Composed::order8(DiscreteGradient)`.
///
/// # Errors
/// Those of the reference.
pub fn eight() -> Result<Problem<Eight, 6>, Error> {
    let (q, v) = ([0.97000436, -0.24308753], [-0.93240737, -0.86473146]);
    let half = [-0.5 * v[0], -0.5 * v[1]];
    let start = State::new([q[0], q[1], -q[0], -q[1], 0.0, 0.0], [half[0], half[1], half[0], half[1], v[0], v[1]]);
    let end = 100.0;
    let simulation = Simulation::new(three_bodies(), start).scheme(Composed::order8(DiscreteGradient));
    let mut stepper = simulation.dt(end / 4000.0).stepper()?;
    stepper.advance(4000)?;
    let title = "Figure-eight of three bodies to t = 100";
    Ok(Problem { name: "eight", title, motion: Eight, start, end, truth: stepper.q(), coarse: 1.0 })
}

/// The α chain of Fermi, Pasta, Ulam and Tsingou with 64 moving masses, α = 1/4, from rest in half a sine.
///
/// The end is a reference by `Composed::order8(DiscreteGradient)`.
///
/// # Errors
/// Those of the reference.
pub fn fput() -> Result<Problem<Fput, 64>, Error> {
    let start = State::new(core::array::from_fn(|j| (PI * (j + 1) as f64 / 65.0).sin()), [0.0; 64]);
    let (end, alpha) = (1000.0, 0.25);
    let simulation = Simulation::scene(chain(&start, alpha)).scheme(Composed::order8(DiscreteGradient));
    let mut stepper = simulation.dt(end / 4000.0).stepper()?;
    stepper.advance(4000)?;
    let truth = core::array::from_fn(|j| stepper.q().get(j + 1)[0]);
    let title = "FPUT chain of 64 masses, α = 1/4, to t = 1000";
    Ok(Problem { name: "fput", title, motion: Fput { alpha }, start, end, truth, coarse: 4.0 })
}

#[cfg(test)]
mod tests {
    use super::*;

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
        let motion = Fput { alpha: 0.25 };
        let q: [f64; 64] = core::array::from_fn(|i| (0.7 * i as f64).sin());
        let energy = |q: &[f64; 64]| {
            let at = |i: usize| if i == 0 || i == 65 { 0.0 } else { q[i - 1] };
            (0..65).map(|i| at(i + 1) - at(i)).map(|r| 0.5 * r * r + motion.alpha * r.powi(3) / 3.0).sum::<f64>()
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
            assert!((da[i] - (ahead[i] - behind[i]) / 2e-4).abs() < 1e-9, "{i}");
        }
    }
}
