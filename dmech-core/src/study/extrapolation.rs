//! A motion to as many digits as the scalar has: leap-frog or the midpoint rule, extrapolated to steps of length zero.
//!
//! n substeps of a symmetric scheme lead over H to T(H/n) = y(H) + c₁ (H/n)² + c₂ (H/n)⁴ + …. K numbers of substeps
//! determine the polynomial of degree K − 1 in (H/n)² through them, and its value at 0 is of order 2K. All numbers in it are
//! rational: no table of coefficients limits its digits. It shares nothing with the schemes that a study compares.

use core::array::from_fn;

use dmech_scalar::Real;

use crate::error::Error;
use crate::law::{Field, Law};
use crate::state::State;
use crate::vector::{add_scaled, finite, sum};

/// K, the numbers of substeps.
const COLUMNS: usize = 14;

/// The order.
pub(super) const ORDER: u32 = 2 * COLUMNS as u32;

/// No step may be shorter than this part of the span.
const SHORTEST: f64 = 1e-24;

/// A motion that is followed to its end.
pub(super) struct Extrapolation<'a, L, const D: usize, R> {
    pub(super) law: &'a L,
    pub(super) mass: f64,
    pub(super) start: State<D, R>,
    pub(super) end: f64,
    /// The local error of a step, in parts of the largest |q| and |v| so far.
    pub(super) tolerance: f64,
    /// Evaluations of the force that are allowed.
    pub(super) budget: u64,
}

/// Position and velocity.
type Phase<const D: usize, R> = [[R; D]; 2];

/// Where a motion ended.
pub(super) struct End<const D: usize, R> {
    pub(super) q: [R; D],
    pub(super) v: [R; D],
    pub(super) steps: u64,
    pub(super) evaluations: u64,
}

impl<L: Law<D, R>, const D: usize, R: Real> Extrapolation<'_, L, D, R> {
    /// Whether leap-frog serves: there is no force beside the potential, so none that depends on the velocity.
    pub(super) fn leapfrog() -> bool {
        !<L::Field<'_> as Field<D, R>>::FORCED
    }

    /// From the start to the end, with steps as long as the tolerance allows; the first is tried at `first`.
    pub(super) fn run(&self, first: f64) -> Result<End<D, R>, Error> {
        let State { t: t0, q, v } = self.start;
        let (start, end) = (R::from_f64(t0), R::from_f64(self.end));
        let span = self.end - t0;
        let (mut t, mut y, mut step) = (start, [q, v], first.min(span));
        let (mut steps, mut evaluations) = (0, 0);
        let mut sizes = y.map(|x| largest(&x));
        loop {
            let left = (end - t).to_f64();
            let whole = step >= left;
            let length = if whole { end - t } else { R::from_f64(step) };
            let (next, defect, cost) = self.step(t, y, length, sizes);
            evaluations += cost;
            if defect <= self.tolerance {
                (t, y, steps) = (t + length, next, steps + 1);
                for (size, x) in sizes.iter_mut().zip(&y) {
                    *size = size.max(largest(x));
                }
                if whole {
                    return Ok(End { q: y[0], v: y[1], steps, evaluations });
                }
            }
            // The defect is of order 2K − 1. Where the motion has a corner it is not, and steps shrink by tens until they are
            // so short that the corner does not matter.
            let factor = 0.8 * (self.tolerance / defect).powf(1.0 / f64::from(ORDER - 1));
            step = length.to_f64() * if factor.is_nan() { 0.1 } else { factor.clamp(0.1, 4.0) };
            if step < SHORTEST * span {
                return Err(Error::StepVanished { step: steps + 1, time: t.to_f64(), dt: step });
            }
            if evaluations > self.budget {
                return Err(Error::EndTime { end: self.end, dt: step });
            }
        }
    }

    /// The state after `length`, the last change of the extrapolation in parts of `sizes`, and the evaluations that it took.
    fn step(&self, t: R, y: Phase<D, R>, length: R, sizes: [f64; 2]) -> (Phase<D, R>, f64, u64) {
        let mut row: [Phase<D, R>; COLUMNS] = [y; COLUMNS];
        let (leapfrog, first) = (Self::leapfrog(), self.acceleration(y, t));
        let mut evaluations = 1;
        let mut defect = f64::NAN;
        for j in 0..COLUMNS {
            let n = substeps(j, leapfrog);
            let substep = if leapfrog { Self::leapfrog_steps } else { Self::midpoint_steps };
            let mut value = substep(self, t, y, first, length, n);
            evaluations += n;
            if !(finite(value[0]) && finite(value[1])) {
                return (y, f64::NAN, evaluations);
            }
            // Neville's scheme: the row of n over that of one number less.
            for k in 0..j {
                let m = substeps(j - 1 - k, leapfrog);
                let weight = R::from_f64((m * m) as f64) / R::from_f64((n * n - m * m) as f64);
                let change: Phase<D, R> = from_fn(|p| from_fn(|i| weight * (value[p][i] - row[k][p][i])));
                row[k] = value;
                value = from_fn(|p| sum(value[p], change[p]));
                let size = |p: usize| sizes[p].max(largest(&value[p]));
                defect = (0..2).map(|p| relative(largest(&change[p]), size(p))).fold(0.0, f64::max);
            }
            row[j] = value;
        }
        (row[COLUMNS - 1], defect, evaluations)
    }

    fn acceleration(&self, [q, v]: Phase<D, R>, t: R) -> [R; D] {
        let mass = R::from_f64(self.mass);
        self.law.field(mass, t).slope(q, v).map(|slope| -slope / mass)
    }

    /// n steps of leap-frog, in increments of the position (E. Hairer, S. P. Nørsett and G. Wanner, Solving Ordinary
    /// Differential Equations I, II.14).
    fn leapfrog_steps(&self, t: R, [q, v]: Phase<D, R>, first: [R; D], length: R, n: u64) -> Phase<D, R> {
        let h = length / R::from_f64(n as f64);
        let half = R::from_f64(0.5) * h;
        let mut v = add_scaled(v, half, first);
        let mut q = q;
        for k in 1..=n {
            q = add_scaled(q, h, v);
            let a = self.acceleration([q, v], t + R::from_f64(k as f64) * h);
            v = add_scaled(v, if k == n { half } else { h }, a);
        }
        [q, v]
    }

    /// n steps of the midpoint rule, n even, the first by Euler's (W. B. Gragg, SIAM J. Numer. Anal. 2 (1965) 384–403).
    fn midpoint_steps(&self, t: R, start: Phase<D, R>, first: [R; D], length: R, n: u64) -> Phase<D, R> {
        let h = length / R::from_f64(n as f64);
        let twice = R::from_f64(2.0) * h;
        let mut before = start;
        let mut y = [add_scaled(start[0], h, start[1]), add_scaled(start[1], h, first)];
        for k in 1..n {
            let a = self.acceleration(y, t + R::from_f64(k as f64) * h);
            let next = [add_scaled(before[0], twice, y[1]), add_scaled(before[1], twice, a)];
            (before, y) = (y, next);
        }
        y
    }
}

/// 1, 2, 3, … for leap-frog, whose error is even in h after any number of steps; 2, 4, 6, … for the midpoint rule.
const fn substeps(j: usize, leapfrog: bool) -> u64 {
    let n = j as u64 + 1;
    if leapfrog { n } else { 2 * n }
}

fn largest<const D: usize, R: Real>(x: &[R; D]) -> f64 {
    x.iter().map(|x| x.to_f64().abs()).fold(0.0, f64::max)
}

/// 0 of 0 is none.
fn relative(part: f64, whole: f64) -> f64 {
    if part == 0.0 { 0.0 } else { part / whole }
}
