//! The local time scale of a motion, from the law.

use core::array::from_fn;

use crate::law::{Field, Law, Potential};
use crate::system::vector::{add_scaled, dot};

/// What the motion is like where it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    /// (ω s)¹²: roots take longer than all the rest, and are hardly ever needed.
    power: f64,
    /// A length of time.
    s: f64,
    /// d ln ω/dt along the motion.
    pub(crate) growth: f64,
}

impl Look {
    /// ω, the angular frequency of the linearised motion.
    #[cold]
    pub(crate) fn rate(&self) -> f64 {
        self.power.sqrt().sqrt().cbrt() / self.s
    }

    /// ρ, or the end of the range `band` of ρ/ω where it lies outside.
    #[inline]
    pub(crate) fn within(&self, [least, most]: [f64; 2], density: f64) -> f64 {
        // No density is negative.
        let ratio = (density * self.s).max(0.0).powi(12);
        if ratio < least.powi(12) * self.power {
            least * self.rate()
        } else if ratio > most.powi(12) * self.power {
            most * self.rate()
        } else {
            density
        }
    }
}

/// A place of the motion.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place<const D: usize> {
    pub(crate) t: f64,
    pub(crate) q: [f64; D],
    pub(crate) v: [f64; D],
    pub(crate) mass: f64,
    /// The smallest ω that counts.
    pub(crate) least: f64,
}

/// How fast accelerations change, times the mass: m ∂a/∂q and m ‖∂a/∂v‖².
#[derive(Clone, Copy, Debug)]
struct Stiffness<const D: usize> {
    by_position: [[f64; D]; D],
    damping: f64,
}

/// The angle ω s between the places where the law is looked at: differences are off by its square.
const ANGLE: f64 = 0.05;

/// What s² ‖K‖ may be at most, over ANGLE².
const EVEN: f64 = 4.0;

/// How often s is shortened at most.
const MOST: u32 = 120;

/// Evaluations of ∂a/∂q in a look.
pub(super) const EVALUATIONS: u32 = 5;

/// Shares of K̇ and K̈ in ω.
const SHARES: [f64; 2] = [0.25, 0.01];

impl<const D: usize> Place<D> {
    /// ω here, with K = (∂a/∂q, ‖∂a/∂v‖²) and its derivatives along the motion,
    ///
    /// ```text
    /// ω¹² = ‖K‖⁶ + ‖K̇‖⁴/4 + ‖K̈‖³/100 + ω_least¹²
    /// ```
    ///
    /// in Frobenius norms; K̇ and K̈ are differences between here and the places s before and after on the parabola
    /// q ± s v + s² a/2. Under v → −v ω is even and its growth odd, whatever s: that makes the steps reversible.
    pub(crate) fn look<L: Law<D>>(&self, law: &L) -> Look {
        let here = self.stiffness(law, self.t, self.q, self.v);
        let slope = law.field(self.mass, self.t).slope(self.q, self.v);
        let per_mass = self.mass.recip();
        let size = per_mass * here.norm();
        let mut s = (ANGLE / size.sqrt()).min(ANGLE / self.least);
        let fall = slope.map(|x| -per_mass * x);
        let mut sides = self.sides(law, fall, s);
        // Where K is small only here, the motion is not alike as far away as K tells.
        for _ in 0..MOST {
            let [before, after] = &sides;
            let sum = per_mass * (before.norm() + after.norm()) + 2.0 * size;
            let excess = s * s * sum * (0.25 / (ANGLE * ANGLE));
            if excess <= EVEN {
                break;
            }
            s = if excess.is_finite() { s * excess.powf(-0.25) } else { 1e-3 * s.min(1e150) };
            sides = self.sides(law, fall, s);
        }
        // Derivatives by differences over s, in units of s so that no power overflows.
        let [before, after] = &sides;
        let [earlier, later] = &self.sides(law, fall, 2.0 * s);
        let square = s * s * per_mass;
        let k = here.map(|x| square * x);
        let k1 = after.map2(before, |x, y| 0.5 * square * (x - y));
        let k2 = after.map2(before, |x, y| square * (x + y)).map2(&k, |x, y| x - 2.0 * y);
        let k3 = later.map2(earlier, |x, y| 0.5 * square * (x - y)).map2(&k1, |x, y| x - 2.0 * y);
        let [kk, k1k1, k2k2] = [k.dot(&k), k1.dot(&k1), k2.dot(&k2)];
        let root = k2k2.sqrt();
        let power = kk * kk * kk + SHARES[0] * k1k1 * k1k1 + SHARES[1] * k2k2 * root + (self.least * s).powi(12);
        let rise =
            6.0 * kk * kk * k.dot(&k1) + 4.0 * SHARES[0] * k1k1 * k1.dot(&k2) + 3.0 * SHARES[1] * root * k2.dot(&k3);
        let growth = rise / (12.0 * power * s);
        Look { power, s, growth: if growth.is_finite() { growth } else { 0.0 } }
    }

    /// m K before and after; `fall` is the acceleration here.
    fn sides<L: Law<D>>(&self, law: &L, fall: [f64; D], s: f64) -> [Stiffness<D>; 2] {
        [-s, s].map(|s| {
            let v = add_scaled(self.v, s, fall);
            // q + s v + s² a/2
            let q = from_fn(|i| (0.5 * s).mul_add(self.v[i] + v[i], self.q[i]));
            self.stiffness(law, self.t + s, q, v)
        })
    }

    fn stiffness<L: Law<D>>(&self, law: &L, t: f64, q: [f64; D], v: [f64; D]) -> Stiffness<D> {
        let field = law.field(self.mass, t);
        let mut by_position = field.hessian(q);
        let mut damping = 0.0;
        if <L::Field<'_> as Field<D>>::FORCED {
            let (by_q, by_v) = (field.force_dq(q, v, t), field.force_dv(q, v, t));
            by_position = from_fn(|i| from_fn(|j| by_position[i][j] - by_q[i][j]));
            damping = by_v.iter().map(|row| dot(*row, *row)).sum::<f64>() / self.mass;
        }
        Stiffness { by_position, damping }
    }
}

impl<const D: usize> Stiffness<D> {
    fn map(&self, f: impl Fn(f64) -> f64) -> Self {
        Stiffness { by_position: self.by_position.map(|row| row.map(&f)), damping: f(self.damping) }
    }

    fn map2(&self, other: &Self, f: impl Fn(f64, f64) -> f64) -> Self {
        let by_position = from_fn(|i| from_fn(|j| f(self.by_position[i][j], other.by_position[i][j])));
        Stiffness { by_position, damping: f(self.damping, other.damping) }
    }

    fn norm(&self) -> f64 {
        let square = self.dot(self);
        if (1e-200..1e200).contains(&square) {
            return square.sqrt();
        }
        // Squares may have left the range of numbers.
        let largest = self.by_position.iter().flatten().fold(self.damping, |most, x| most.max(x.abs()));
        if largest == 0.0 || !square.is_finite() && !largest.is_finite() {
            return square;
        }
        let unit = self.map(|x| x / largest);
        largest * unit.dot(&unit).sqrt()
    }

    fn dot(&self, other: &Self) -> f64 {
        let rows = self.by_position.iter().zip(&other.by_position);
        rows.map(|(x, y)| dot(*x, *y)).sum::<f64>() + self.damping * other.damping
    }
}
