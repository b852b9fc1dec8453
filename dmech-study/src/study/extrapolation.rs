//! A motion to as many digits as the scalar has: leap-frog or the midpoint rule, extrapolated to steps of length zero.
//!
//! n substeps of a symmetric scheme lead over H to T(H/n) = y(H) + c₁ (H/n)² + c₂ (H/n)⁴ + …. K numbers of substeps
//! determine the polynomial of degree K − 1 in (H/n)² through them, and its value at 0 is of order 2K. All numbers in it are
//! rational: no table of coefficients limits its digits. It shares nothing with the schemes that a study compares.

use core::array::from_fn;

use dmech_core::extend::{Field, Real};
use dmech_core::{Error, Law, State};

use dmech_core::extend::vector::{add_scaled, difference, finite, scaled, sum};

/// K, the numbers of substeps.
const COLUMNS: usize = 14;

/// The order.
pub(super) const ORDER: u32 = 2 * COLUMNS as u32;

/// No step may be shorter than this part of the span.
const SHORTEST: f64 = 1e-30;

/// A motion that is followed to its end.
pub(super) struct Extrapolation<'a, L, const D: usize, R> {
    pub(super) law: &'a L,
    pub(super) mass: f64,
    pub(super) start: State<D, R>,
    pub(super) end: f64,
    /// The local error of a step, in parts of the largest |q| and |v| so far.
    pub(super) tolerance: f64,
    /// What |q| and |v| count for at least.
    pub(super) least: [f64; 2],
    /// The longest step.
    pub(super) longest: f64,
    /// Evaluations of the force that are allowed.
    pub(super) budget: u64,
}

/// Position and velocity.
type Phase<const D: usize, R> = [[R; D]; 2];

/// Where a motion ended.
pub(super) struct End<const D: usize, R> {
    pub(super) q: [R; D],
    pub(super) v: [R; D],
    /// The largest |q| and |v|.
    pub(super) sizes: [f64; 2],
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
        let (mut t, mut y, mut step) = (start, [q, v], first.min(self.longest));
        let (mut steps, mut evaluations) = (0, 0);
        let mut sizes = self.least;
        y.iter().zip(&mut sizes).for_each(|(x, size)| *size = size.max(largest(x)));
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
                    return Ok(End { q: y[0], v: y[1], sizes, steps, evaluations });
                }
            }
            // The defect is of order 2K − 1. Where the motion has a corner it is not, and steps shrink by tens until they are
            // so short that the corner does not matter.
            let factor = 0.8 * (self.tolerance / defect).powf(1.0 / f64::from(ORDER - 1));
            step = self.longest.min(length.to_f64() * if factor.is_nan() { 0.1 } else { factor.clamp(0.1, 4.0) });
            if step < SHORTEST * span {
                return Err(Error::StepVanished { step: steps + 1, time: t.to_f64(), dt: step });
            }
            if evaluations > self.budget {
                return Err(Error::EndTime { end: self.end, dt: step });
            }
        }
    }

    /// The state after `length`, the defect in parts of `sizes`, and the evaluations that it took.
    ///
    /// The defect is the difference from what one number of substeps less gives. The last entry of the same row differs
    /// less by far, but where the motion has a corner it differs by less than the error, by a factor of thousands.
    fn step(&self, t: R, y: Phase<D, R>, length: R, sizes: [f64; 2]) -> (Phase<D, R>, f64, u64) {
        let zero = [[R::ZERO; D]; 2];
        let mut row = [zero; COLUMNS];
        let (leapfrog, first) = (Self::leapfrog(), self.acceleration(y, t));
        let substep = if leapfrog { Self::leapfrog_steps } else { Self::midpoint_steps };
        let mut evaluations = 1;
        let [mut last, mut before] = [zero; 2];
        for j in 0..COLUMNS {
            let n = substeps(j, leapfrog);
            let mut value = substep(self, t, y, first, length, n);
            evaluations += n;
            // Neville's scheme: the row of n over that of one number less.
            for k in 0..j {
                let m = substeps(j - 1 - k, leapfrog);
                let weight = R::from_f64((m * m) as f64) / R::from_f64((n * n - m * m) as f64);
                let change: Phase<D, R> = from_fn(|p| scaled(weight, difference(value[p], row[k][p])));
                row[k] = value;
                value = from_fn(|p| sum(value[p], change[p]));
            }
            row[j] = value;
            (before, last) = (last, value);
        }
        let end: Phase<D, R> = from_fn(|p| sum(y[p], last[p]));
        if !(finite(end[0]) && finite(end[1])) {
            return (y, f64::NAN, evaluations);
        }
        let defect = |p: usize| relative(largest(&difference(last[p], before[p])), sizes[p].max(largest(&end[p])));
        (end, defect(0).max(defect(1)), evaluations)
    }

    fn acceleration(&self, [q, v]: Phase<D, R>, t: R) -> [R; D] {
        let mass = R::from_f64(self.mass);
        self.law.field(mass, t).slope(q, v).map(|slope| -slope / mass)
    }

    /// What n steps of leap-frog add to position and velocity.
    ///
    /// Extrapolation magnifies the rounding of what it is made from ten thousand times. Sums that start from 0 keep that in
    /// proportion to the step (E. Hairer, S. P. Nørsett and G. Wanner, Solving Ordinary Differential Equations I, II.14).
    fn leapfrog_steps(&self, t: R, [q, v]: Phase<D, R>, first: [R; D], length: R, n: u64) -> Phase<D, R> {
        let h = length / R::from_f64(n as f64);
        let half = R::from_f64(0.5) * h;
        let (mut dq, mut dv) = ([R::ZERO; D], scaled(half, first));
        for k in 1..=n {
            dq = add_scaled(dq, h, sum(v, dv));
            let a = self.acceleration([sum(q, dq), v], t + R::from_f64(k as f64) * h);
            dv = add_scaled(dv, if k == n { half } else { h }, a);
        }
        [dq, dv]
    }

    /// What n steps of the midpoint rule add, n even, the first by Euler's (W. B. Gragg, SIAM J. Numer. Anal. 2 (1965)
    /// 384–403).
    fn midpoint_steps(&self, t: R, [q, v]: Phase<D, R>, first: [R; D], length: R, n: u64) -> Phase<D, R> {
        let h = length / R::from_f64(n as f64);
        let twice = R::from_f64(2.0) * h;
        let mut before = [[R::ZERO; D]; 2];
        let mut added = [scaled(h, v), scaled(h, first)];
        for k in 1..n {
            let y = [sum(q, added[0]), sum(v, added[1])];
            let a = self.acceleration(y, t + R::from_f64(k as f64) * h);
            let next = [add_scaled(before[0], twice, y[1]), add_scaled(before[1], twice, a)];
            (before, added) = (added, next);
        }
        added
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

/// 0 of 0 is nothing.
fn relative(part: f64, whole: f64) -> f64 {
    if part == 0.0 { 0.0 } else { part / whole }
}

#[cfg(test)]
mod tests {
    use dmech_core::extend::{DoubleDouble, Mask};

    use super::*;
    use dmech_core::{Conservative, Potential};

    type Wide = DoubleDouble;

    /// k x²/2 to the left of 0, g x to the right: a spring, and a fall on it.
    struct Trampoline {
        k: f64,
        g: f64,
    }

    impl Conservative for Trampoline {}
    impl<R: Real> Potential<1, R> for Trampoline {
        fn potential(&self, [x]: [R; 1]) -> R {
            let (k, g) = (R::from_f64(self.k), R::from_f64(self.g));
            R::select(x.less(R::ZERO), || R::from_f64(0.5) * k * x * x, || g * x)
        }
        fn gradient(&self, [x]: [R; 1]) -> [R; 1] {
            let (k, g) = (R::from_f64(self.k), R::from_f64(self.g));
            [R::select(x.less(R::ZERO), || k * x, || g)]
        }
        fn hessian(&self, _: [R; 1]) -> [[R; 1]; 1] {
            unreachable!("leap-frog")
        }
        fn discrete_gradient(&self, _: [R; 1], _: [R; 1]) -> [R; 1] {
            unreachable!("leap-frog")
        }
        fn discrete_gradient_jacobian(&self, _: [R; 1], _: [R; 1]) -> [[R; 1]; 1] {
            unreachable!("leap-frog")
        }
    }

    fn follow(law: &Trampoline, q: f64, v: f64, end: f64, tolerance: f64) -> Result<End<1, Wide>, Error> {
        let start = State::of([q.into()], [v.into()]).at_time(0.5);
        let motion =
            Extrapolation { law, mass: 2.0, start, end, tolerance, least: [0.0; 2], longest: end, budget: 1 << 20 };
        motion.run(0.3)
    }

    /// x₀ cos ω t + (v₀/ω) sin ω t while x < 0, to as many digits as are asked for.
    #[test]
    fn a_vibration_is_followed_to_all_digits() {
        let (law, x, v, end) = (Trampoline { k: 1.7, g: 1.0 }, -0.8, -0.3, 0.5 + 1.9);
        let [k, x0, v0, mass] = [law.k, x, v, 2.0].map(Wide::from);
        let (omega, t) = ((k / mass).sqrt(), Wide::from(end) - Wide::from(0.5));
        let exact = x0 * (omega * t).cos() + v0 / omega * (omega * t).sin();
        let mut steps = Vec::new();
        for tolerance in [1e-13, 1e-18, 1e-23, 1e-28] {
            let end = follow(&law, x, v, end, tolerance).unwrap();
            let error = (end.q[0] - exact).to_f64().abs();
            assert!(error <= tolerance.max(1e-27), "{tolerance:e}: {error:e}");
            steps.push(end.steps);
        }
        assert!(steps.is_sorted() && steps[3] > steps[0], "the tolerance does nothing: {steps:?}");
    }

    /// The force jumps by m g at 0: half a vibration, a flight, and half a vibration again.
    #[test]
    fn a_corner_of_the_law_is_passed() {
        let law = Trampoline { k: 1.7, g: 0.9 };
        let [k, g, mass, v] = [law.k, law.g, 2.0, 0.7].map(Wide::from);
        let two = Wide::from(2.0);
        let omega = (k / mass).sqrt();
        // From 0 to the left with speed v: back after π/ω, in the air for 2 v m/g; then t − t₁ into the next.
        let pi = Wide::ZERO.atan2(-Wide::ONE);
        let end = 0.5 + 7.0;
        let left = Wide::from(7.0) - pi / omega - two * v * mass / g;
        assert!(Wide::ZERO.less(left).and(left.less(pi / omega)));
        let exact = -(v / omega) * (omega * left).sin();
        for tolerance in [1e-16, 1e-19, 1e-22, 1e-25, 1e-28] {
            let found = follow(&law, 0.0, -0.7, end, tolerance).unwrap();
            let error = (found.q[0] - exact).to_f64().abs();
            assert!(error < 100.0 * tolerance, "{tolerance:e}: {error:e} after {} steps", found.steps);
            assert!(found.steps > 30, "the corners cost nothing: {} steps", found.steps);
        }
    }

    #[test]
    fn what_cannot_be_followed_ends_in_an_error() {
        // Fifty thousand bounces.
        let law = Trampoline { k: 1e12, g: 1e9 };
        assert!(matches!(follow(&law, -0.8, 0.0, 100.0, 1e-25), Err(Error::EndTime { .. })));
        let law = Trampoline { k: f64::INFINITY, g: 1.0 };
        assert!(matches!(follow(&law, 0.3, 0.0, 100.0, 1e-25), Err(Error::StepVanished { .. })));
    }
}
