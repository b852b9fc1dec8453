//! Arithmetic of arrays, for schemes and for laws by hand.

use dmech_scalar::{Mask, Real};

/// An array of `R` by its D components, `by_component!(|i| x[i] + y[i])`: a loop in place of `from_fn`, whose closures are not
/// inlined where a crate is compiled in parts or with few optimisations, and take as long to compile as what they compute.
macro_rules! by_component {
    (|$i:ident| $x:expr) => {{
        let mut all = [R::ZERO; D];
        for $i in 0..D {
            all[$i] = $x;
        }
        all
    }};
}
pub(crate) use by_component;

/// A matrix likewise, `by_entry!(|i, j| x[i] * y[j])`.
macro_rules! by_entry {
    (|$i:ident, $j:ident| $x:expr) => {{
        let mut all = [[R::ZERO; D]; D];
        for $i in 0..D {
            for $j in 0..D {
                all[$i][$j] = $x;
            }
        }
        all
    }};
}
pub(crate) use by_entry;

/// x + c y.
#[inline(always)]
pub fn add_scaled<const D: usize, R: Real>(x: [R; D], c: R, y: [R; D]) -> [R; D] {
    by_component!(|i| c.mul_add(y[i], x[i]))
}

/// c x.
#[inline(always)]
pub fn scaled<const D: usize, R: Real>(c: R, x: [R; D]) -> [R; D] {
    by_component!(|i| c * x[i])
}

/// x + y.
#[inline(always)]
pub fn sum<const D: usize, R: Real>(x: [R; D], y: [R; D]) -> [R; D] {
    by_component!(|i| x[i] + y[i])
}

/// x − y.
#[inline(always)]
pub fn difference<const D: usize, R: Real>(x: [R; D], y: [R; D]) -> [R; D] {
    by_component!(|i| x[i] - y[i])
}

/// One where the mask holds, the other elsewhere.
#[inline(always)]
pub(crate) fn either<const D: usize, R: Real>(mask: R::Mask, one: [R; D], other: [R; D]) -> [R; D] {
    by_component!(|i| R::either(mask, one[i], other[i]))
}

/// Of matrices.
#[inline(always)]
pub(crate) fn either_matrix<const D: usize, R: Real>(
    mask: R::Mask,
    one: [[R; D]; D],
    other: [[R; D]; D],
) -> [[R; D]; D] {
    by_entry!(|i, j| R::either(mask, one[i][j], other[i][j]))
}

/// x·y.
#[inline(always)]
pub fn dot<const D: usize, R: Real>(x: [R; D], y: [R; D]) -> R {
    if D == 0 {
        return R::ZERO;
    }
    let mut sum = x[0] * y[0];
    for i in 1..D {
        sum = x[i].mul_add(y[i], sum);
    }
    sum
}

/// Σ wᵢ xᵢ yᵢ; [`dot`] to the bit where the weights are 1.
#[inline(always)]
pub fn weighted<const D: usize, R: Real>(weights: [R; D], x: [R; D], y: [R; D]) -> R {
    dot(by_component!(|i| weights[i] * x[i]), y)
}

/// max |xᵢ| (of several lanes the first); NaN if one is.
pub(crate) fn largest<R: Real>(x: &[R]) -> f64 {
    // In this order nothing is asked of a single number: else steps of one coordinate take 5 % more instructions.
    x.iter().map(|x| x.to_f64().abs()).fold(0.0, |max, x| if max.is_nan() || max > x { max } else { x })
}

/// Every component is finite in every lane.
#[inline(always)]
pub fn finite<const D: usize, R: Real>(x: [R; D]) -> bool {
    x.iter().all(|x| x.finite().all())
}
