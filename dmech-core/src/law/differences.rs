//! The Jacobians of a force by hand that has none of its own.

use dmech_scalar::Real;

use crate::vector::by_entry;

/// ∂f/∂x by central differences of fourth order over ε^{1/5}: four fifths of the digits.
///
/// The width is relative to the largest component, and to 1 where all are 0.
#[cold]
pub(super) fn jacobian<const D: usize, R: Real>(x: [R; D], f: impl Fn([R; D]) -> [R; D]) -> [[R; D]; D] {
    let largest = x.iter().fold(R::ZERO, |size, x| size.max(x.abs()));
    let width = R::from_f64(R::EPSILON.to_f64().powf(0.2)) * R::either(largest.equal(R::ZERO), R::ONE, largest);
    let columns: [[R; D]; D] = core::array::from_fn(|j| {
        let rise = |width: R| {
            let [mut up, mut down] = [x; 2];
            (up[j], down[j]) = (x[j] + width, x[j] - width);
            let (apart, [above, below]) = (up[j] - down[j], [up, down].map(&f));
            above.into_iter().zip(below).map(move |(above, below)| (above - below) / apart)
        };
        let mut rises = rise(width).zip(rise(width + width));
        let third = R::from_f64(3.0).recip();
        core::array::from_fn(|_| rises.next().map_or(R::ZERO, |(near, far)| near + (near - far) * third))
    });
    by_entry!(|i, j| columns[j][i])
}
