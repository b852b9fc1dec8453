//! Where two bodies stand to each other.

use crate::scene::vectors::Vectors;
use crate::vector::difference;

/// q_a − q_b.
#[inline(always)]
pub(super) fn separation<const D: usize>(q: &Vectors<D>, a: usize, b: usize) -> [f64; D] {
    difference(q.get(a), q.get(b))
}

/// At each of S moments.
#[inline(always)]
pub(super) fn separations<const D: usize, const S: usize>(q: [&Vectors<D>; S], a: usize, b: usize) -> [[f64; D]; S] {
    let mut d = [[0.0; D]; S];
    for s in 0..S {
        d[s] = separation(q[s], a, b);
    }
    d
}
