//! How fast a motion is, by how its accelerations change along it.

use dmech_scalar::{Mask, Real};

use super::{Course, Look, Stiffness};

/// The angle ω s between the places where the law is looked at: differences are off by its square.
const ANGLE: f64 = 0.05;

/// What s² ‖K‖ may be at most, over ANGLE².
const EVEN: f64 = 4.0;

/// 1/4 of (EVEN ANGLE²)⁻², and a little more for rounding: (x + y + 2z)² is at most 4 (x² + y² + 2z²).
const SURE: f64 = 1.01 * 0.25 / (EVEN * EVEN * ANGLE * ANGLE * ANGLE * ANGLE);

/// How often s is shortened at most, and to what part of it at once.
const MOST: u32 = 120;
const LEAST_PART: f64 = 0.015625;

/// By what part of its square K may change within s unseen: for a Kepler orbit it is 0.1.
const CHANGES: f64 = 0.5;
/// Where between K is looked at, else: at s/16, s/256 and so on.
const PROBE: f64 = 0.0625;
const PROBES: i32 = 5;
/// How often that is looked for.
const PLACES: u32 = 8;

/// Evaluations of ∂a/∂q in a look.
pub const EVALUATIONS: u32 = 5;

/// Shares of K̇ and K̈ in ω.
const SHARES: [f64; 2] = [0.25, 0.01];

/// What passes is of no account below this share of ω¹²: it makes steps shorter by a hundredth at most.
const COUNTS: f64 = 0.1;

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

    /// A length of time in which K is as large as here or not much larger, s or less, and m K so long before and after.
    #[inline(always)]
    fn as_even<const D: usize>(
        course: &Course<D, R>,
        stiffness: &impl Fn(R, [R; D], [R; D]) -> Stiffness<D, R>,
        (mut s, size): (R, R),
    ) -> (R, [Stiffness<D, R>; 2]) {
        let (per_mass, two) = (course.per_mass, R::from_f64(2.0));
        let mut sides = course.sides(stiffness, s);
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
            // Far away K may be 10⁸⁰ times what it is near: by that alone s would be lost in the rounding of q.
            let shorter = || s * excess.powf(R::from_f64(-0.25)).max(R::from_f64(LEAST_PART));
            let shorter = R::select(excess.finite(), shorter, || R::from_f64(1e-3) * s.min(R::from_f64(1e150)));
            s = R::either(even, s, shorter);
            sides = course.sides(stiffness, s);
        }
        (s, sides)
    }

    /// A shorter s where K is alike there and here, and larger between: it passes through zero here, and what is there is another place.
    /// That is looked for where K is not nearly constant.
    #[inline(always)]
    fn nearer<const D: usize>(
        course: &Course<D, R>,
        stiffness: &impl Fn(R, [R; D], [R; D]) -> Stiffness<D, R>,
        (s, here, [before, after]): (R, &Stiffness<D, R>, &[Stiffness<D, R>; 2]),
    ) -> R {
        let squares = |side: &Stiffness<D, R>| {
            let change = side.map2(here, |x, y| x - y);
            change.dot(&change)
        };
        let changes = (R::from_f64(CHANGES) * here.dot(here)).less(squares(before) + squares(after));
        if !changes.any() {
            return s;
        }
        let most = R::from_f64(2.0) * here.norm().max(before.norm()).max(after.norm());
        let mut found = s;
        for k in (1..=PROBES).rev() {
            let part = s * R::from_f64(PROBE.powi(k));
            let [before, after] = course.sides(stiffness, part);
            let larger = changes.and(most.less(before.norm().max(after.norm())));
            found = R::either(larger, part, found);
        }
        found
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
        let longest = (angle / size.sqrt()).min(angle / least);
        let (mut s, mut sides) = Self::as_even(&course, &stiffness, (longest, size));
        for _ in 0..PLACES {
            let nearer = Self::nearer(&course, &stiffness, (s, &here, &sides));
            if !nearer.less(s).any() {
                break;
            }
            (s, sides) = Self::as_even(&course, &stiffness, (nearer, size));
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
