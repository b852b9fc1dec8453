//! What acts among few bodies, added to those of them that feel it.

use dmech_scalar::{Mask, Real};

use super::among::Places;
use super::links::Presence;
use crate::look::Frequency;
use crate::vector::{by_entry, difference, sum};

/// Adds a block to the rows of body a and the columns of body b.
#[inline(always)]
pub(super) fn add_block<const D: usize, const K: usize, R: Real>(
    out: &mut [[R; K]; K],
    [a, b]: [usize; 2],
    block: &[[R; D]; D],
    here: impl Presence<R>,
) {
    for i in 0..D {
        for j in 0..D {
            let out = &mut out[D * a + i][D * b + j];
            *out = here.choose(*out + block[i][j], *out);
        }
    }
}

/// Adds to a body.
#[inline(always)]
pub(super) fn add<const D: usize, R: Real>(to: &mut [R; D], x: [R; D], here: impl Presence<R>) {
    let sum = sum(*to, x);
    for k in 0..D {
        to[k] = here.choose(sum[k], to[k]);
    }
}

/// Adds to body a, and its opposite to body b, where each feels it.
#[inline(always)]
pub(super) fn add_opposite<const D: usize, const N: usize, R: Real, T: Presence<R>>(
    out: &mut Places<D, N, R>,
    [a, b]: [usize; 2],
    x: [R; D],
    [on_a, on_b]: [T; 2],
) {
    add(&mut out[a], x, on_a);
    let rest = difference(out[b], x);
    for k in 0..D {
        out[b][k] = on_b.choose(rest[k], out[b][k]);
    }
}

/// The derivative of what is on a along d = q_a − q_b, and of its opposite on b: rows of those that feel it.
#[inline(always)]
pub(super) fn add_link<const D: usize, const K: usize, R: Real, T: Presence<R>>(
    out: &mut [[R; K]; K],
    [a, b]: [usize; 2],
    by_d: [[R; D]; D],
    [on_a, on_b]: [T; 2],
) {
    let back = by_entry!(|i, j| -by_d[i][j]);
    add_block(out, [a, a], &by_d, on_a);
    add_block(out, [b, b], &by_d, on_b);
    add_block(out, [a, b], &back, on_a);
    add_block(out, [b, a], &back, on_b);
}

/// With what moves beside it: not so what is pinned, and what is between two that are.
#[inline(always)]
pub(super) fn moving<R: Real>(per_mass: R, all: Frequency<R>, other: impl FnOnce() -> Frequency<R>) -> Frequency<R> {
    let still = per_mass.equal(R::ZERO);
    if still.all() {
        return all;
    }
    let both = all.and(other());
    if still.any() { all.where_alone(still, both) } else { both }
}
