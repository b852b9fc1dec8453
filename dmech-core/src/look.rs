//! The local time scale of a motion, from what acts.

use dmech_scalar::{FUSED, Mask, Real, two_sum};

use crate::law::Field;
use crate::vector::{add_scaled, by_component, by_entry, difference, dot};

/// What the motion is like where it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look<R = f64> {
    /// (ω s)¹²: roots take longer than all the rest, and are hardly ever needed.
    pub(crate) power: R,
    /// The part of it that is of bodies that pass.
    pub(crate) passing: R,
    /// A length of time.
    pub(crate) s: R,
    /// d ln ω/dt along the motion, of what does not pass.
    pub growth: R,
}

impl<R: Real> Look<R> {
    /// ω, the angular frequency of the linearised motion.
    #[cold]
    pub fn rate(&self) -> R {
        twelfth_root(self.power) / self.s
    }

    /// ρ, or the end of the range `band` of ρ/ω where it lies outside; what passes now is not taken to be gone soon.
    #[inline(always)]
    pub fn within(&self, [least, most]: [f64; 2], density: R) -> R {
        let bound = |end: f64, power: R| R::from_f64(end.powi(12)) * power;
        let (least, most) = (bound(least, self.power).max(bound(STAYS, self.passing)), bound(most, self.power));
        // No density is negative.
        let ratio = (density * self.s).max(R::ZERO).powi(12);
        let (below, above) = (ratio.less(least), most.less(ratio));
        if !below.or(above).any() {
            return density;
        }
        let end = twelfth_root(R::either(below, least, most)) / self.s;
        R::either(below.or(above), end, density)
    }
}

#[cold]
fn twelfth_root<R: Real>(power: R) -> R {
    power.sqrt().sqrt().cbrt()
}

/// A particle, or two as one of reduced mass, where the motion has brought it.
#[derive(Clone, Copy, Debug)]
pub struct Course<const D: usize, R = f64> {
    /// Where it is.
    pub q: [R; D],
    /// How fast.
    pub v: [R; D],
    /// Its acceleration, by all that acts.
    pub fall: [R; D],
    /// 1/m.
    pub per_mass: R,
    /// The smallest ω that counts.
    pub least: R,
}

/// How fast accelerations change, times the mass: m ∂a/∂q and m ‖∂a/∂v‖².
#[derive(Clone, Copy, Debug)]
pub struct Stiffness<const D: usize, R = f64> {
    /// m ∂a/∂q, or its negative.
    pub by_position: [[R; D]; D],
    /// m ‖∂a/∂v‖².
    pub damping: R,
}

/// The angle ω s between the places where the law is looked at: differences are off by its square.
const ANGLE: f64 = 0.05;

/// What s² ‖K‖ may be at most, over ANGLE².
const EVEN: f64 = 4.0;

/// 1/4 of (EVEN ANGLE²)⁻², and a little more for rounding: (x + y + 2z)² is at most 4 (x² + y² + 2z²).
const SURE: f64 = 1.01 * 0.25 / (EVEN * EVEN * ANGLE * ANGLE * ANGLE * ANGLE);

/// How often s is shortened at most.
const MOST: u32 = 120;

/// Evaluations of ∂a/∂q in a look.
pub const EVALUATIONS: u32 = 5;

/// Shares of K̇ and K̈ in ω.
const SHARES: [f64; 2] = [0.25, 0.01];

/// The share of what passes, and that of ‖K‖ by which two bodies that turn around each other do not.
const PASSING: [f64; 2] = [1e12, 45.0];

/// What passes is of no account below this share of ω¹²: it makes steps shorter by a hundredth at most.
const COUNTS: f64 = 0.1;

/// ρ/ω, of what passes, at least.
const STAYS: f64 = 2.0 / 3.0;

/// ω¹² of one motion, or of several together, and how it grows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frequency<R = f64> {
    /// (ω s)¹².
    power: R,
    /// s d(ω s)¹²/dt.
    rise: R,
    /// What passes: it shortens steps, and they do not follow how it grows.
    passing: R,
    /// A length of time.
    s: R,
}

impl<R: Real> Frequency<R> {
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
        course: Course<D, R>,
        stiffness: impl Fn(R, [R; D], [R; D]) -> Stiffness<D, R>,
    ) -> Frequency<R> {
        Self::with_size(course, stiffness).0
    }

    /// The same of two bodies at the separation q, and what they feel of each other in passing,
    ///
    /// ```text
    /// ω¹² + 10¹² ‖K‖ w⁵,   w = u³/(u² + 45² ‖K‖²),   u = v²/q²
    /// ```
    ///
    /// A body that passes another fast feels little of it until it is there, and by then a step on the time scale of all else has
    /// gone past. K⁽ⁿ⁾, of the order of ‖K‖ (v/q)ⁿ, tells of it from the farther away, the larger n is; here n = 10. Where nothing is
    /// singular as they meet, on a line or under a softened law, K changes more slowly: if that is of some account the law is looked
    /// at twice more, at the times ±τ = ±|q|/4v, and u is (‖K̇‖²/‖K‖² + ‖K̈‖/‖K‖)/2 by differences over τ if that is less. Where
    /// two bodies turn around each other, u ≤ 2 ‖K‖/√6, it is 2·10⁻⁶ of ‖K‖⁶ at most. It is not among what grows: of an ω that falls
    /// by half in each step as one body leaves the other behind, steps would follow the fall beyond its end.
    #[inline(always)]
    pub fn between<const D: usize>(
        course: Course<D, R>,
        stiffness: impl Fn(R, [R; D], [R; D]) -> Stiffness<D, R>,
    ) -> Frequency<R> {
        let (Frequency { power, rise, s, .. }, size) = Self::with_size(course, &stiffness);
        let u = course.nearing(s);
        let passing = course.passing(u, size);
        let passing = R::either(passing.finite(), passing, R::ZERO);
        let counts = (R::from_f64(COUNTS) * power).less(passing);
        if !counts.any() {
            return Frequency { power, rise, passing, s };
        }
        let least = course.passing(course.change(stiffness, u), size);
        let passing = R::either(counts.and(least.less(passing)), least, passing);
        Frequency { power, rise, passing, s }
    }

    /// ω¹², and ‖K‖ in units of s.
    #[inline(always)]
    fn with_size<const D: usize>(
        course: Course<D, R>,
        stiffness: impl Fn(R, [R; D], [R; D]) -> Stiffness<D, R>,
    ) -> (Frequency<R>, R) {
        let Course { per_mass, least, .. } = course;
        let (half, two, angle) = (R::from_f64(0.5), R::from_f64(2.0), R::from_f64(ANGLE));
        // t − 0 is t to the bit, also where that is −0.
        let here = stiffness(R::from_f64(-0.0), course.q, course.v);
        let size = per_mass * here.norm();
        let mut s = (angle / size.sqrt()).min(angle / least);
        let mut sides = course.sides(&stiffness, s);
        // Where K is small only here, the motion is not alike as far away as K tells.
        for _ in 0..MOST {
            let [before, after] = &sides;
            // Their mean is not above the root of the mean of their squares: mostly that says it without a root.
            let squares = per_mass * per_mass * (before.dot(before) + after.dot(after)) + two * size * size;
            let bound = R::from_f64(SURE) * (s * s) * (s * s) * squares;
            if R::from_f64(1e-200).less_or_equal(squares).and(bound.less_or_equal(R::ONE)).all() {
                break;
            }
            let sum = per_mass * (before.norm() + after.norm()) + two * size;
            let excess = s * s * sum * R::from_f64(0.25 / (ANGLE * ANGLE));
            let even = excess.less_or_equal(R::from_f64(EVEN));
            if even.all() {
                break;
            }
            let shorter = || s * excess.powf(R::from_f64(-0.25));
            let shorter = R::select(excess.finite(), shorter, || R::from_f64(1e-3) * s.min(R::from_f64(1e150)));
            s = R::either(even, s, shorter);
            sides = course.sides(&stiffness, s);
        }
        // Derivatives by differences over s, in units of s so that no power overflows.
        let [before, after] = &sides;
        let [earlier, later] = &course.sides(&stiffness, two * s);
        let square = s * s * per_mass;
        let k = here.map(|x| square * x);
        let k1 = after.map2(before, |x, y| half * square * (x - y));
        let k2 = after.map2(before, |x, y| square * (x + y)).map2(&k, |x, y| x - two * y);
        let k3 = later.map2(earlier, |x, y| half * square * (x - y)).map2(&k1, |x, y| x - two * y);
        let [kk, k1k1, k2k2] = [k.dot(&k), k1.dot(&k1), k2.dot(&k2)];
        let (root, first, second) = (k2k2.sqrt(), R::from_f64(SHARES[0]), R::from_f64(SHARES[1]));
        let (six, four, three) = (R::from_f64(6.0), R::from_f64(4.0), R::from_f64(3.0));
        let power = kk * kk * kk + first * k1k1 * k1k1 + second * k2k2 * root;
        let rise = six * kk * kk * k.dot(&k1) + four * first * k1k1 * k1.dot(&k2) + three * second * root * k2.dot(&k3);
        (Frequency { power, rise, passing: R::ZERO, s }, kk.sqrt())
    }

    /// What the motion is like, if no ω below `least` counts: ω¹² + ω_least¹².
    #[inline]
    pub fn look(self, least: R) -> Look<R> {
        let Frequency { power, rise, passing, s } = self;
        let power = power + (least * s).powi(12);
        let growth = rise / (R::from_f64(12.0) * power * s);
        Look { power: power + passing, passing, s, growth: R::either(growth.finite(), growth, R::ZERO) }
    }

    /// Nothing moves faster than `least`.
    pub fn none(least: R) -> Frequency<R> {
        let s = (R::from_f64(ANGLE) / least).min(R::from_f64(1e150));
        Frequency { power: R::ZERO, rise: R::ZERO, passing: R::ZERO, s }
    }

    /// Both motions together: ω¹² = ω₁¹² + ω₂¹², which is smooth where the one becomes faster than the other, and
    /// d ln ω/dt = (ω₁¹² d ln ω₁/dt + ω₂¹² d ln ω₂/dt)/ω¹².
    pub fn and(self, other: Frequency<R>) -> Frequency<R> {
        let [still, alone] = [self, other].map(|one| (one.power + one.passing).equal(R::ZERO));
        if alone.all() {
            return self;
        }
        // In the unit of the faster one nothing overflows.
        let there = self.over(other.s);
        let slower = there.power.less(other.power);
        let unlike = still.or(alone).any();
        let here = if slower.all() { other } else { other.over(self.s) };
        let sum = |mine: R, there: R, its: R, here: R| R::either(slower, its + there, mine + here);
        let both = Frequency {
            power: sum(self.power, there.power, other.power, here.power),
            rise: sum(self.rise, there.rise, other.rise, here.rise),
            passing: sum(self.passing, there.passing, other.passing, here.passing),
            s: R::either(slower, other.s, self.s),
        };
        if unlike { self.where_alone(alone, other.where_alone(still, both)) } else { both }
    }

    /// This where `alone` holds, `both` elsewhere.
    pub(crate) fn where_alone(self, alone: R::Mask, both: Frequency<R>) -> Frequency<R> {
        Frequency {
            power: R::either(alone, self.power, both.power),
            rise: R::either(alone, self.rise, both.rise),
            passing: R::either(alone, self.passing, both.passing),
            s: R::either(alone, self.s, both.s),
        }
    }

    /// The same in another unit of time.
    fn over(self, s: R) -> Frequency<R> {
        let ratio = s / self.s;
        let fourth = ratio.powi(4);
        // Factor by factor: the twelfth power would leave the range of numbers where the product does not.
        let scaled = |x: R| x * fourth * fourth * fourth;
        Frequency { power: scaled(self.power), rise: ratio * scaled(self.rise), passing: scaled(self.passing), s }
    }
}

/// x y + z as a fused instruction rounds it, on targets without one too: differences of what lies beside tell how steps change.
#[inline(always)]
fn rounded_once<R: Real>(x: R, y: R, z: R) -> R {
    if FUSED {
        return x.mul_add(y, z);
    }
    let (product, rest) = x.product(y);
    let (sum, left) = two_sum(product, z);
    let exact = sum + (left + rest);
    R::either(exact.finite(), exact, x * y + z)
}

impl<const D: usize, R: Real> Course<D, R> {
    /// Two bodies as one of reduced mass, at q_a − q_b; 1/μ = 1/m_a + 1/m_b.
    #[inline(always)]
    pub fn relative_to(&self, other: &Self) -> Self {
        Course {
            q: difference(self.q, other.q),
            v: difference(self.v, other.v),
            fall: difference(self.fall, other.fall),
            per_mass: self.per_mass + other.per_mass,
            least: self.least,
        }
    }

    /// Where the mask does not hold, that of the first lane where it does.
    pub(crate) fn lent(&self, by: R::Mask) -> Self {
        let lent = |x: R| x.lent(by);
        Course {
            q: self.q.map(lent),
            v: self.v.map(lent),
            fall: self.fall.map(lent),
            per_mass: lent(self.per_mass),
            least: lent(self.least),
        }
    }

    /// v²/q², in units of s.
    #[inline(always)]
    fn nearing(&self, s: R) -> R {
        let reach = self.q.iter().fold(R::ZERO, |most, x| most.max(x.abs()));
        let (q, v): ([R; D], [R; D]) = (by_component!(|i| self.q[i] / reach), by_component!(|i| s * self.v[i] / reach));
        dot(v, v) / dot(q, q)
    }

    /// (‖K̇‖²/‖K‖² + ‖K̈‖/‖K‖)/2 in the units of u = v²/q²: where K is a power of the distance, 1.5 u or more.
    #[cold]
    fn change(&self, stiffness: impl Fn(R, [R; D], [R; D]) -> Stiffness<D, R>, u: R) -> R {
        let part = R::from_f64(0.25);
        let here = stiffness(R::from_f64(-0.0), self.q, self.v);
        let [before, after] = &self.sides(stiffness, part / self.nearing(R::ONE).sqrt());
        let (size, half) = (here.norm(), R::from_f64(0.5));
        let first = after.map2(before, |x, y| half * (x - y)).norm() / (part * size);
        let second = after.map2(before, |x, y| x + y).map2(&here, |x, y| x - (y + y)).norm() / (part * part * size);
        half * (first * first + second) * u
    }

    /// 10¹² ‖K‖ w⁵, in units of s.
    #[inline(always)]
    fn passing(&self, u: R, size: R) -> R {
        let (share, slower) = (R::from_f64(PASSING[0]), R::from_f64(PASSING[1]));
        let turning = slower * size;
        let w = u * u * u / (u * u + turning * turning);
        share * w * w * w * w * w * size
    }

    /// m K before and after.
    #[inline(always)]
    fn sides(&self, stiffness: impl Fn(R, [R; D], [R; D]) -> Stiffness<D, R>, s: R) -> [Stiffness<D, R>; 2] {
        let at = |s: R| {
            let v = add_scaled(self.v, s, self.fall);
            // q + s v + s² a/2
            let q = by_component!(|i| rounded_once(R::from_f64(0.5) * s, self.v[i] + v[i], self.q[i]));
            stiffness(s, q, v)
        };
        [at(-s), at(s)]
    }
}

impl<const D: usize, R: Real> Stiffness<D, R> {
    /// Nothing acts.
    pub const NONE: Self = Stiffness { by_position: [[R::ZERO; D]; D], damping: R::ZERO };

    /// Of what acts on one body at a time.
    #[inline(always)]
    pub fn of<F: Field<D, R>>(field: &F, mass: R, t: R, q: [R; D], v: [R; D]) -> Self {
        let mut by_position = field.hessian(q);
        let mut damping = R::ZERO;
        if F::FORCED {
            let (by_q, by_v) = (field.force_dq(q, v, t), field.force_dv(q, v, t));
            by_position = by_entry!(|i, j| by_position[i][j] - by_q[i][j]);
            damping = by_v.iter().fold(R::ZERO, |sum, row| sum + dot(*row, *row)) / mass;
        }
        Stiffness { by_position, damping }
    }

    #[inline(always)]
    pub(crate) fn map(&self, f: impl Fn(R) -> R) -> Self {
        Stiffness { by_position: by_entry!(|i, j| f(self.by_position[i][j])), damping: f(self.damping) }
    }

    #[inline(always)]
    fn map2(&self, other: &Self, f: impl Fn(R, R) -> R) -> Self {
        let by_position = by_entry!(|i, j| f(self.by_position[i][j], other.by_position[i][j]));
        Stiffness { by_position, damping: f(self.damping, other.damping) }
    }

    #[inline(always)]
    fn norm(&self) -> R {
        let square = self.dot(self);
        let in_range = R::from_f64(1e-200).less_or_equal(square).and(square.less(R::from_f64(1e200)));
        if in_range.all() {
            return square.sqrt();
        }
        // Squares may have left the range of numbers.
        let largest = self.by_position.iter().flatten().fold(self.damping, |most, x| most.max(x.abs()));
        let lost = largest.equal(R::ZERO).or(square.finite().or(largest.finite()).not());
        let unit = self.map(|x| x / largest);
        let careful = R::either(lost, square, largest * unit.dot(&unit).sqrt());
        R::either(in_range, square.sqrt(), careful)
    }

    #[inline(always)]
    fn dot(&self, other: &Self) -> R {
        let rows = self.by_position.iter().zip(&other.by_position);
        rows.fold(R::ZERO, |sum, (x, y)| sum + dot(*x, *y)) + self.damping * other.damping
    }
}
