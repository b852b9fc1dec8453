//! Gauss's method of order 16 by hand: eight stages side by side in the eight lanes of one register.
//!
//! With Lⱼ = h² bⱼ a(Qⱼ) the stages of q″ = a(q) are Qᵢ = q + cᵢ h v + Σ νᵢⱼ Lⱼ, νᵢⱼ = (A²)ᵢⱼ/bⱼ, and a step is
//! q′ = q + h v + Σ (1 − cⱼ) Lⱼ, v′ = v + Σ Lⱼ/h. It is symplectic where νᵢⱼ − νⱼᵢ = cᵢ − cⱼ, which holds here to the bit:
//! the tables are multiples of 2⁻⁵³. The stages are found by sweeps, Lⱼ from all Qⱼ and these from all Lⱼ, each of which
//! gains a factor of about h² |∂a/∂q|/130; the first guess continues the polynomial of the last step's forces.
//!
//! M. Antoñana, E. Alberdi, J. Makazaga, A. Murua, arXiv 2511.03655; tables computed with 60 digits.

use dmech::prelude::State;
use wide::f64x8;

use crate::motion::Motion;

/// The nodes between 0 and 1/2; the others are 1 − c.
const HALF_C: [f64; 4] = [0.019855071751231912, 0.10166676129318664, 0.2372337950418355, 0.40828267875217505];

/// The weights of these and of their mirror images.
const HALF_B: [f64; 4] = [0.05061426814518813, 0.11119051722668724, 0.15685332293894363, 0.181341891689181];

/// νᵢⱼ for i ≤ j ≤ 7 − i, row by row. Below the diagonal νᵢⱼ = νⱼᵢ + cᵢ − cⱼ; beyond the other one νᵢⱼ = ν₇₋ⱼ,₇₋ᵢ.
const QUARTER_NU: [&[f64]; 4] = [
    &[
        0.006007708087483299,
        -0.0020809295798384086,
        0.0017019932573518748,
        -0.0015804089791490172,
        0.0014748295565338854,
        -0.00132365737330431,
        0.0010954699775890253,
        -0.0007426229367991644,
    ],
    &[
        0.012834197951873016,
        -0.0034213172495578537,
        0.0025652601660901553,
        -0.002251180763439442,
        0.0019767687307943316,
        -0.0016216304237847146,
    ],
    &[0.018025789769441358, -0.004302364922801227, 0.003005820943232318, -0.0024679950147463714],
    &[0.020815992475314515, -0.00461006256162777],
];

const C: [f64; 8] = mirrored(HALF_C, true);
const B: [f64; 8] = mirrored(HALF_B, false);

const fn mirrored(half: [f64; 4], from_one: bool) -> [f64; 8] {
    let (mut all, mut i) = ([0.0; 8], 0);
    while i < 4 {
        all[i] = half[i];
        all[7 - i] = if from_one { 1.0 - half[i] } else { half[i] };
        i += 1;
    }
    all
}

/// νᵢⱼ, column by column: `NU[j][i]`.
const NU: [[f64; 8]; 8] = {
    let mut nu = [[0.0; 8]; 8];
    let mut i = 0;
    while i < 8 {
        let mut j = i;
        while j < 8 {
            let above = if i + j < 8 { QUARTER_NU[i][j - i] } else { QUARTER_NU[7 - j][j - i] };
            nu[j][i] = above;
            if j > i {
                nu[i][j] = above + (C[j] - C[i]);
            }
            j += 1;
        }
        i += 1;
    }
    nu
};

/// 1/(bⱼ Π (cⱼ − cₖ)): the weights of Lagrange's polynomials, for L in place of a.
const LAGRANGE: [f64; 8] = {
    let (mut weights, mut j) = ([0.0; 8], 0);
    while j < 8 {
        let (mut product, mut k) = (B[j], 0);
        while k < 8 {
            if k != j {
                product *= C[j] - C[k];
            }
            k += 1;
        }
        weights[j] = 1.0 / product;
        j += 1;
    }
    weights
};

/// A step's sweeps end where the rest is foreseen to be less, as a part of the largest coordinate at the start: d²/d₀ after a
/// change by d, and by d₀ before that. With 3·10⁻¹⁹ a run takes a twentieth less time and is as good for 10⁻¹², but the rest has
/// a sign: over 10⁶ years of the outer planets in steps of half a year it adds up to 6·10⁻¹³ of the energy, against 7·10⁻¹⁴.
const REST: f64 = 1e-20;

/// No step takes more sweeps, whether it has settled or not: one that takes so many is too long.
const MOST: u32 = 60;

/// base + Σ columnⱼ lⱼ, in two sums side by side.
#[inline(always)]
fn product(columns: &[f64x8; 8], l: f64x8, base: f64x8) -> f64x8 {
    let l = l.to_array().map(f64x8::splat);
    let (mut low, mut high) = (base, columns[4] * l[4]);
    for j in 0..4 {
        low = columns[j].mul_add(l[j], low);
    }
    for j in 5..8 {
        high = columns[j].mul_add(l[j], high);
    }
    low + high
}

/// From Lⱼ of a step to Lᵢ of the next, which is ρ times as long: ρ² bᵢ/bⱼ ℓⱼ(1 + ρ cᵢ), without a division.
#[inline(always)]
fn continued(ratio: f64) -> [f64x8; 8] {
    let x = f64x8::new(C).mul_add(f64x8::splat(ratio), f64x8::ONE);
    let away = C.map(|c| x - f64x8::splat(c));
    let mut beyond = away;
    for j in (0..7).rev() {
        beyond[j] = away[j] * beyond[j + 1];
    }
    let mut before = f64x8::new(B) * f64x8::splat(ratio * ratio);
    let mut columns = [f64x8::ZERO; 8];
    for j in 0..8 {
        let others = if j < 7 { before * beyond[j + 1] } else { before };
        columns[j] = others * f64x8::splat(LAGRANGE[j]);
        before *= away[j];
    }
    columns
}

/// Steps of the lengths that `next` gives for position and velocity, until it gives none: the state at the end, and
/// evaluations of the force.
#[inline(always)]
pub(crate) fn gauss16<M: Motion<D>, const D: usize>(
    motion: M,
    start: &State<D>,
    mut next: impl FnMut(&[f64; D], &[f64; D]) -> Option<f64>,
) -> (State<D>, u64) {
    let (mut q, mut v) = (start.q, start.v);
    let (mut lost_q, mut lost_v) = ([0.0; D], [0.0; D]);
    let nu = NU.map(f64x8::new);
    let size = q.iter().fold(0.0, |size: f64, q| size.max(q.abs()));
    let rest = f64x8::splat(REST * size);
    let (mut x, mut a, mut l) = ([f64x8::ZERO; D], [f64x8::ZERO; D], [f64x8::ZERO; D]);
    let (mut last, mut ratio, mut ahead) = (0.0, 1.0, continued(1.0));
    let mut sweeps = 0;
    while let Some(h) = next(&q, &v) {
        let weights = f64x8::new(B) * f64x8::splat(h * h);
        if last == 0.0 {
            motion.in_lanes(&q.map(f64x8::splat), &mut a);
            for k in 0..D {
                l[k] = a[k] * weights;
            }
        } else {
            if h != ratio * last {
                ratio = h / last;
                ahead = continued(ratio);
            }
            for k in 0..D {
                l[k] = product(&ahead, l[k], f64x8::ZERO);
            }
        }
        last = h;
        let (mut before, mut least) = (f64x8::splat(f64::INFINITY), f64x8::ZERO);
        for _ in 0..MOST {
            for k in 0..D {
                let free = f64x8::new(C).mul_add(f64x8::splat(h * v[k]), f64x8::splat(q[k]));
                x[k] = product(&nu, l[k], free);
            }
            motion.in_lanes(&x, &mut a);
            let mut change = f64x8::ZERO;
            for k in 0..D {
                let new = a[k] * weights;
                change = change.fast_max((new - l[k]).abs());
                l[k] = new;
            }
            sweeps += 1;
            // Lane by lane, so that nothing is added up or compared across them: is there one that has not settled and still
            // shrinks?
            if !((change * change).simd_ge(least) & change.simd_lt(before)).any() {
                break;
            }
            (before, least) = (change, change * rest);
        }
        for k in 0..D {
            let (kick, drift) = (l[k].reduce_add(), (f64x8::new(C.map(|c| 1.0 - c)) * l[k]).reduce_add());
            add(&mut q[k], &mut lost_q[k], h * v[k] + drift);
            add(&mut v[k], &mut lost_v[k], kick / h);
        }
    }
    (State::new(q, v), 8 * sweeps + 8)
}

/// x += dx, with what is lost carried along.
#[inline(always)]
pub(crate) fn add(x: &mut f64, lost: &mut f64, dx: f64) {
    let dx = dx + *lost;
    let sum = *x + dx;
    *lost = (*x - sum) + dx;
    *x = sum;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_are_symplectic_to_the_bit() {
        for i in 0..8 {
            for j in 0..8 {
                assert_eq!(NU[j][i] - NU[i][j], C[i] - C[j], "{i}, {j}");
                assert_eq!(NU[j][i], NU[7 - i][7 - j], "{i}, {j}");
            }
        }
    }

    /// ∫ cᵐ = 1/(m + 1) for m to 15, and twice integrated c^(m+2)/((m + 1)(m + 2)) for m to 6.
    #[test]
    fn tables_integrate_polynomials() {
        for m in 0..16 {
            let sum: f64 = (0..8).map(|j| B[j] * C[j].powi(m)).sum();
            assert!((sum - 1.0 / f64::from(m + 1)).abs() < 1e-15, "{m}: {sum}");
        }
        for m in 0..7 {
            for i in 0..8 {
                let sum: f64 = (0..8).map(|j| NU[j][i] * B[j] * C[j].powi(m)).sum();
                let exact = C[i].powi(m + 2) / f64::from((m + 1) * (m + 2));
                assert!((sum - exact).abs() < 3e-16, "{m}, {i}: {sum} and {exact}");
            }
        }
    }

    /// A polynomial of degree 7 goes on as itself.
    #[test]
    fn the_guess_continues_a_polynomial() {
        for ratio in [1.0, 0.7, 1.3] {
            let f = |x: f64| 1.0 + x * (0.5 - x * (0.25 + 0.1 * x.powi(5)));
            let l = f64x8::new(core::array::from_fn(|j| B[j] * f(C[j])));
            let found = product(&continued(ratio), l, f64x8::ZERO).to_array();
            for i in 0..8 {
                let exact = ratio * ratio * B[i] * f(1.0 + ratio * C[i]);
                assert!((found[i] - exact).abs() < 1e-10, "{ratio}, {i}: {} and {exact}", found[i]);
            }
        }
    }
}
