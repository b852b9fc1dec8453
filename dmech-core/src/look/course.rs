//! Where a motion is, and a little before and after.

use dmech_scalar::{FUSED, Real, two_sum};

use super::Stiffness;
use crate::vector::{add_scaled, by_component, difference, dot};

/// The share of what passes, and that of ‖K‖ by which two bodies that turn around each other do not.
const PASSING: [f64; 2] = [1e12, 45.0];

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
    pub(super) fn nearing(&self, s: R) -> R {
        let reach = self.q.iter().fold(R::ZERO, |most, x| most.max(x.abs()));
        let (q, v): ([R; D], [R; D]) = (by_component!(|i| self.q[i] / reach), by_component!(|i| s * self.v[i] / reach));
        dot(v, v) / dot(q, q)
    }

    /// (‖K̇‖²/‖K‖² + ‖K̈‖/‖K‖)/2 in the units of u = v²/q²: where K is a power of the distance, 1.5 u or more.
    #[cold]
    pub(super) fn change(&self, stiffness: impl Fn(R, [R; D], [R; D]) -> Stiffness<D, R>, u: R) -> R {
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
    pub(super) fn passing(&self, u: R, size: R) -> R {
        let (share, slower) = (R::from_f64(PASSING[0]), R::from_f64(PASSING[1]));
        let turning = slower * size;
        let w = u * u * u / (u * u + turning * turning);
        share * w * w * w * w * w * size
    }

    /// m K before and after.
    #[inline(always)]
    pub(super) fn sides(&self, stiffness: impl Fn(R, [R; D], [R; D]) -> Stiffness<D, R>, s: R) -> [Stiffness<D, R>; 2] {
        let at = |s: R| {
            let v = add_scaled(self.v, s, self.fall);
            // q + s v + s² a/2
            let q = by_component!(|i| rounded_once(R::from_f64(0.5) * s, self.v[i] + v[i], self.q[i]));
            stiffness(s, q, v)
        };
        [at(-s), at(s)]
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
