//! The Cayley map of an antisymmetric matrix in two and three coordinates: a rotation, by two cross products.
//!
//! ```text
//! (1 − A)⁻¹(1 + A) v = v + 2 A (v + A v)/(1 + |a|²)
//! ```
//!
//! where |a|² is the sum of the squares above the diagonal of A (J. P. Boris, 1970). The length of v is kept to rounding, and
//! roundings have no mean: the factor 1/(1 + |a|²), which in a uniform field is that of every step, is taken as
//! 1 − |a|²/(1 + |a|²), so that its own rounding counts for |a|² of it. With the plain factor the energy grows or falls by
//! 2·10⁻¹¹ of itself in 10⁶ steps of half a radian.

use core::array::from_fn;

use dmech_scalar::{Mask, Real};

use crate::vector::{dot, either, sum};

/// By A with the one entry a above its diagonal.
#[inline(always)]
pub fn plane<R: Real>(a: R, v: [R; 2]) -> [R; 2] {
    turn(a * a, v, |[x, y]| [a * y, -a * x])
}

/// By A with the entries a₁₂, a₁₃, a₂₃ above its diagonal.
#[inline(always)]
pub fn space<R: Real>([xy, xz, yz]: [R; 3], v: [R; 3]) -> [R; 3] {
    turn(dot([xy, xz, yz], [xy, xz, yz]), v, |[x, y, z]| {
        [xy.mul_add(y, xz * z), yz.mul_add(z, -xy * x), -xz.mul_add(x, yz * y)]
    })
}

/// One half of a push before a rotation, the other after it.
#[inline(always)]
pub fn amid<const D: usize, R: Real>(half: [R; D], v: [R; D], turn: impl FnOnce([R; D]) -> [R; D]) -> [R; D] {
    sum(turn(sum(v, half)), half)
}

#[inline(always)]
fn turn<const D: usize, R: Real>(squared: R, v: [R; D], a: impl Fn([R; D]) -> [R; D]) -> [R; D] {
    let turned = a(sum(v, a(v)));
    let share = (R::ONE + squared).recip();
    let rest = squared * share;
    // Beyond a right angle 1 − rest would cancel.
    let small = squared.less(R::ONE);
    let two = R::from_f64(2.0);
    from_fn(|i| {
        let change = R::either(small, (-rest).mul_add(turned[i], turned[i]), share * turned[i]);
        two.mul_add(change, v[i])
    })
}

/// v′ = v + c p + (c/2) S (v + v′), the kick by a push p beside S v: a rotation where S is antisymmetric.
#[inline(always)]
pub(crate) fn kick_by_mean<const D: usize, R: Real>(c: R, push: [R; D], s: [[R; D]; D], v: [R; D]) -> [R; D] {
    let half = R::from_f64(0.5) * c;
    let a = s.map(|row| row.map(|x| half * x));
    // Lanes do not ask one another: which way one goes is its own.
    let opposite = |i: usize, j: usize| (s[i][j] + s[j][i]).equal(R::ZERO);
    let mut turns = opposite(0, 0);
    for i in 0..D {
        for j in 0..=i {
            turns = turns.and(opposite(i, j));
        }
    }
    let rotates = D == 2 || D == 3;
    if rotates && turns.all() {
        return amid(push.map(|p| half * p), v, |v| rotated(a, v));
    }
    let matrix = from_fn(|i| from_fn(|j| if i == j { R::ONE - a[i][j] } else { -a[i][j] }));
    let change = from_fn(|i| c.mul_add(push[i], R::from_f64(2.0) * dot(a[i], v)));
    let solved = sum(v, crate::newton::elimination::solve(matrix, change));
    if rotates && turns.any() {
        let turned = amid(push.map(|p| half * p), v, |v| rotated(a, v));
        return either(turns, turned, solved);
    }
    solved
}

/// The rotation by a whole matrix in two or three coordinates.
#[inline(always)]
fn rotated<const D: usize, R: Real>(a: [[R; D]; D], v: [R; D]) -> [R; D] {
    let mut squared = R::ZERO;
    for i in 0..D {
        for j in i + 1..D {
            squared = a[i][j].mul_add(a[i][j], squared);
        }
    }
    turn(squared, v, |v| from_fn(|i| dot(a[i], v)))
}

#[cfg(test)]
mod tests {
    use super::*;

    const V: [f64; 3] = [0.7, -1.1, 0.4];

    /// Angles from nothing to many turns of which only the rest remains: the length stays, A v′ − A v is (v′ − v) turned.
    #[test]
    fn lengths_and_the_equation_of_the_map_are_kept_at_any_angle() {
        for scale in [0.0, 1e-9, 0.1, 0.9, 1.1, 40.0, 1e9, 1e60] {
            let entries @ [xy, xz, yz] = [0.6, -0.3, 0.8].map(|x| scale * x);
            let a = [[0.0, xy, xz], [-xy, 0.0, yz], [-xz, -yz, 0.0]];
            let next = space(entries, V);
            assert!((dot(next, next) / dot(V, V) - 1.0).abs() < 2e-15, "{scale}");
            // v′ − v = A (v + v′).
            let mean = sum(V, next);
            for i in 0..3 {
                let residual = next[i] - V[i] - dot(a[i], mean);
                assert!(residual.abs() < 1e-15 * (1.0 + scale), "{scale}: {residual:e}");
            }
            let [x, y] = plane(xy, [0.7, -1.1]);
            assert!((x.hypot(y) / 0.7_f64.hypot(1.1) - 1.0).abs() < 1e-15, "{scale}");
        }
        assert_eq!(space([0.0; 3], V), V);
        // Half a turn at infinity.
        assert!(sum(plane(1e100, [0.7, -1.1]), [0.7, -1.1]).iter().all(|x| x.abs() < 1e-15));
    }

    #[cfg(feature = "scene")]
    #[test]
    fn whole_matrices_do_the_same_and_lanes_do_not_mix() {
        use dmech_scalar::Lanes;

        let c = 0.8;
        let s = [[0.0, 0.5, -1.4], [-0.5, 0.0, 0.9], [1.4, -0.9, 0.0]];
        let half = 0.5 * c;
        let turned = space([half * 0.5, half * -1.4, half * 0.9], V);
        let whole = kick_by_mean(c, [0.0; 3], s, V);
        assert!(turned.iter().zip(whole).all(|(x, y)| (x - y).abs() < 1e-15));
        // One lane turns by much, one by little, one is braked as well.
        let mut braked = s;
        braked[1][1] = -0.7;
        let each = [s, s.map(|row| row.map(|x| 30.0 * x)), braked];
        let lane = |k: usize| each[k.min(2)];
        let lanes = from_fn(|i| from_fn(|j| Lanes::from(from_fn::<_, 8, _>(|k| lane(k)[i][j]))));
        let next = kick_by_mean(Lanes::splat(c), [Lanes::splat(0.1); 3], lanes, V.map(Lanes::splat));
        for k in 0..3 {
            let alone = kick_by_mean(c, [0.1; 3], lane(k), V);
            for i in 0..3 {
                let found: [f64; 8] = next[i].into();
                assert_eq!(found[k].to_bits(), alone[i].to_bits(), "lane {k}: {} {}", found[k], alone[i]);
            }
        }
    }
}
