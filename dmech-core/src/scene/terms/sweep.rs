//! The loops over links that add up gradients.

use super::numbers::NumberColumns;
use crate::pair::Numbers;
use crate::scene::vectors::Vectors;

/// The gradient along a link at S moments: one for ∇Φ(d), two for ∇̄Φ(d, d′).
pub trait Kernel<const D: usize, const S: usize, N: Numbers>: Sync {
    /// With respect to d = q_a − q_b, for the numbers of a and b.
    fn gradient(&self, a: N::Of<f64>, b: N::Of<f64>, d: [[f64; D]; S]) -> [f64; D];
}

/// q_a − q_b at each moment.
#[inline(always)]
fn separation<const D: usize, const S: usize>(q: [&Vectors<D>; S], a: usize, b: usize) -> [[f64; D]; S] {
    q.map(|q| {
        let (a, b) = (q.get(a), q.get(b));
        core::array::from_fn(|k| a[k] - b[k])
    })
}

/// One link.
#[inline(always)]
pub(super) fn link<const D: usize, const S: usize, N: Numbers>(
    kernel: &impl Kernel<D, S, N>,
    q: [&Vectors<D>; S],
    numbers: &NumberColumns<N>,
    a: usize,
    b: usize,
    out: &mut Vectors<D>,
) {
    let gradient = kernel.gradient(numbers.at(a), numbers.at(b), separation(q, a, b));
    out.add(a, gradient);
    out.add(b, gradient.map(|x| -x));
}

/// Any two bodies.
pub(super) fn pairs<const D: usize, const S: usize, N: Numbers>(
    kernel: &impl Kernel<D, S, N>,
    q: [&Vectors<D>; S],
    numbers: &NumberColumns<N>,
    out: &mut Vectors<D>,
) {
    let bodies = out.bodies();
    for a in 0..bodies {
        for b in a + 1..bodies {
            link(kernel, q, numbers, a, b, out);
        }
    }
}

/// Consecutive bodies.
pub(super) fn chain<const D: usize, const S: usize, N: Numbers>(
    kernel: &impl Kernel<D, S, N>,
    q: [&Vectors<D>; S],
    numbers: &NumberColumns<N>,
    out: &mut Vectors<D>,
) {
    for b in 1..out.bodies() {
        link(kernel, q, numbers, b - 1, b, out);
    }
}
