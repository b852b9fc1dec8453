//! The local time scale of a motion, from what acts.

use core::array::from_fn;

use crate::law::{Field, Law, Potential};
use crate::vector::{add_scaled, dot};

/// What the motion is like where it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    /// (ω s)¹²: roots take longer than all the rest, and are hardly ever needed.
    power: f64,
    /// A length of time.
    s: f64,
    /// d ln ω/dt along the motion.
    pub growth: f64,
}

impl Look {
    /// ω, the angular frequency of the linearised motion.
    #[cold]
    pub fn rate(&self) -> f64 {
        self.power.sqrt().sqrt().cbrt() / self.s
    }

    /// ρ, or the end of the range `band` of ρ/ω where it lies outside.
    #[inline]
    pub fn within(&self, [least, most]: [f64; 2], density: f64) -> f64 {
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

/// A particle, or two as one of reduced mass, where the motion has brought it.
#[derive(Clone, Copy, Debug)]
pub struct Course<const D: usize> {
    /// Where it is.
    pub q: [f64; D],
    /// How fast.
    pub v: [f64; D],
    /// Its acceleration, by all that acts.
    pub fall: [f64; D],
    /// 1/m.
    pub per_mass: f64,
    /// The smallest ω that counts.
    pub least: f64,
}

/// How fast accelerations change, times the mass: m ∂a/∂q and m ‖∂a/∂v‖².
#[derive(Clone, Copy, Debug)]
pub struct Stiffness<const D: usize> {
    /// m ∂a/∂q, or its negative.
    pub by_position: [[f64; D]; D],
    /// m ‖∂a/∂v‖².
    pub damping: f64,
}

/// The angle ω s between the places where the law is looked at: differences are off by its square.
const ANGLE: f64 = 0.05;

/// What s² ‖K‖ may be at most, over ANGLE².
const EVEN: f64 = 4.0;

/// How often s is shortened at most.
const MOST: u32 = 120;

/// Evaluations of ∂a/∂q in a look.
pub const EVALUATIONS: u32 = 5;

/// Shares of K̇ and K̈ in ω.
const SHARES: [f64; 2] = [0.25, 0.01];

/// ω¹² of one motion, or of several together, and how it grows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frequency {
    /// (ω s)¹².
    power: f64,
    /// s d(ω s)¹²/dt.
    rise: f64,
    /// A length of time.
    s: f64,
}

impl Frequency {
    /// ω along a course, with K = (∂a/∂q, ‖∂a/∂v‖²) and its derivatives along the motion,
    ///
    /// ```text
    /// ω¹² = ‖K‖⁶ + ‖K̇‖⁴/4 + ‖K̈‖³/100
    /// ```
    ///
    /// in Frobenius norms; K̇ and K̈ are differences between here and the places s before and after on the parabola
    /// q ± s v + s² a/2. Under v → −v ω is even and its growth odd, whatever s: that makes the steps reversible.
    ///
    /// `stiffness` is m K at the time s from now, at a position and a velocity.
    #[inline(always)]
    pub fn of<const D: usize>(
        course: Course<D>,
        stiffness: impl Fn(f64, [f64; D], [f64; D]) -> Stiffness<D>,
    ) -> Frequency {
        let Course { per_mass, least, .. } = course;
        // t − 0 is t to the bit, also where that is −0.
        let here = stiffness(-0.0, course.q, course.v);
        let size = per_mass * here.norm();
        let mut s = (ANGLE / size.sqrt()).min(ANGLE / least);
        let mut sides = course.sides(&stiffness, s);
        // Where K is small only here, the motion is not alike as far away as K tells.
        for _ in 0..MOST {
            let [before, after] = &sides;
            let sum = per_mass * (before.norm() + after.norm()) + 2.0 * size;
            let excess = s * s * sum * (0.25 / (ANGLE * ANGLE));
            if excess <= EVEN {
                break;
            }
            s = if excess.is_finite() { s * excess.powf(-0.25) } else { 1e-3 * s.min(1e150) };
            sides = course.sides(&stiffness, s);
        }
        // Derivatives by differences over s, in units of s so that no power overflows.
        let [before, after] = &sides;
        let [earlier, later] = &course.sides(&stiffness, 2.0 * s);
        let square = s * s * per_mass;
        let k = here.map(|x| square * x);
        let k1 = after.map2(before, |x, y| 0.5 * square * (x - y));
        let k2 = after.map2(before, |x, y| square * (x + y)).map2(&k, |x, y| x - 2.0 * y);
        let k3 = later.map2(earlier, |x, y| 0.5 * square * (x - y)).map2(&k1, |x, y| x - 2.0 * y);
        let [kk, k1k1, k2k2] = [k.dot(&k), k1.dot(&k1), k2.dot(&k2)];
        let root = k2k2.sqrt();
        let power = kk * kk * kk + SHARES[0] * k1k1 * k1k1 + SHARES[1] * k2k2 * root;
        let rise =
            6.0 * kk * kk * k.dot(&k1) + 4.0 * SHARES[0] * k1k1 * k1.dot(&k2) + 3.0 * SHARES[1] * root * k2.dot(&k3);
        Frequency { power, rise, s }
    }

    /// Nothing moves faster than `least`.
    pub fn none(least: f64) -> Frequency {
        Frequency { power: 0.0, rise: 0.0, s: (ANGLE / least).min(1e150) }
    }

    /// Both motions together: ω¹² = ω₁¹² + ω₂¹², which is smooth where the one becomes faster than the other, and
    /// d ln ω/dt = (ω₁¹² d ln ω₁/dt + ω₂¹² d ln ω₂/dt)/ω¹².
    pub fn and(self, other: Frequency) -> Frequency {
        if other.power == 0.0 {
            return self;
        }
        if self.power == 0.0 {
            return other;
        }
        // In the unit of the faster one nothing overflows.
        let there = self.over(other.s);
        let (fast, slow) = if there.power < other.power { (other, there) } else { (self, other.over(self.s)) };
        Frequency { power: fast.power + slow.power, rise: fast.rise + slow.rise, s: fast.s }
    }

    /// The same in another unit of time.
    fn over(self, s: f64) -> Frequency {
        let ratio = s / self.s;
        let fourth = ratio.powi(4);
        // Factor by factor: the twelfth power would leave the range of numbers where the product does not.
        let scaled = |x: f64| x * fourth * fourth * fourth;
        Frequency { power: scaled(self.power), rise: ratio * scaled(self.rise), s }
    }

    /// What the motion is like, if no ω below `least` counts: ω¹² + ω_least¹².
    #[inline]
    pub fn look(self, least: f64) -> Look {
        let Frequency { power, rise, s } = self;
        let power = power + (least * s).powi(12);
        let growth = rise / (12.0 * power * s);
        Look { power, s, growth: if growth.is_finite() { growth } else { 0.0 } }
    }
}

impl<const D: usize> Course<D> {
    /// m K before and after.
    fn sides(&self, stiffness: impl Fn(f64, [f64; D], [f64; D]) -> Stiffness<D>, s: f64) -> [Stiffness<D>; 2] {
        [-s, s].map(|s| {
            let v = add_scaled(self.v, s, self.fall);
            // q + s v + s² a/2
            let q = from_fn(|i| (0.5 * s).mul_add(self.v[i] + v[i], self.q[i]));
            stiffness(s, q, v)
        })
    }
}

impl<const D: usize> Stiffness<D> {
    /// Of a law of one body.
    pub fn of<L: Law<D>>(law: &L, mass: f64, t: f64, q: [f64; D], v: [f64; D]) -> Self {
        let field = law.field(mass, t);
        let mut by_position = field.hessian(q);
        let mut damping = 0.0;
        if <L::Field<'_> as Field<D>>::FORCED {
            let (by_q, by_v) = (field.force_dq(q, v, t), field.force_dv(q, v, t));
            by_position = from_fn(|i| from_fn(|j| by_position[i][j] - by_q[i][j]));
            damping = by_v.iter().map(|row| dot(*row, *row)).sum::<f64>() / mass;
        }
        Stiffness { by_position, damping }
    }

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
