//! Links of test bodies: they feel the others and do not act on them.

use super::linked::LinkedReady;
use super::links::Links;
use super::separation::separations;
use super::sweep::{Kernel, Kernels, Kicked};
use crate::law::{LinkLaw, Reads};
use crate::scene::matrix::Matrix;
use crate::scene::matrix::block::Block;
use crate::scene::space::Space;
use crate::scene::vectors::Vectors;
use crate::vector::scaled;

impl<X: Reads<P>, T: Links, P, B> LinkedReady<X, T, P, B> {
    /// Visits the links of which one body acts at least.
    #[inline]
    pub(super) fn each<const D: usize, const S: usize>(&self, q: [&Vectors<D>; S], mut visit: impl FnMut(usize, usize))
    where
        B: Space<D>,
    {
        if self.acting.all() {
            return self.links.each(&self.space, q, visit);
        }
        // Unknown to this loop, so that the visit stands in one loop only, the one above.
        let visit: &mut dyn FnMut(usize, usize) = &mut visit;
        self.links.each_acting(&self.space, q, |i| self.acting.acts(i), visit);
    }

    /// Adds the gradient of every link to the bodies that feel it; if `SET`, in place of what is there.
    #[inline]
    pub(super) fn sweep<const SET: bool, K: Kernels<D, S, X::Numbers>, const D: usize, const S: usize>(
        &self,
        kernel: &K,
        q: [&Vectors<D>; S],
        out: &mut Vectors<D>,
    ) where
        X: LinkLaw<D, P>,
        B: Space<D>,
    {
        if self.acting.all() {
            return self.links.sweep::<SET, D, S, _>(&self.space, kernel, q, &self.numbers, out);
        }
        self.sweep_felt::<SET, K, D, S>(kernel, q, out);
    }

    /// Apart, so that a scene without test bodies has nothing of it in its loop.
    #[inline(never)]
    fn sweep_felt<const SET: bool, K: Kernels<D, S, X::Numbers>, const D: usize, const S: usize>(
        &self,
        kernel: &K,
        q: [&Vectors<D>; S],
        out: &mut Vectors<D>,
    ) where
        X: LinkLaw<D, P>,
        B: Space<D>,
    {
        if SET {
            out.clear();
        }
        if T::ONE_SIDED {
            return self.links.sweep_one_sided(kernel, q, &self.numbers, &self.acting, out);
        }
        self.felt(kernel, q, |i, gradient| out.add(i, gradient));
    }

    /// Adds the gradient along every link to those of its bodies on which the other acts.
    fn felt<K: Kernel<D, S, X::Numbers, f64>, const D: usize, const S: usize>(
        &self,
        kernel: &K,
        q: [&Vectors<D>; S],
        mut add: impl FnMut(usize, [f64; D]),
    ) where
        X: LinkLaw<D, P>,
        B: Space<D>,
    {
        let felt = |a, b| {
            let gradient: [f64; D] = kernel.gradient(self.numbers.at(a), self.numbers.at(b), separations(q, a, b));
            if self.acting.acts(b) {
                add(a, gradient);
            }
            if self.acting.acts(a) {
                add(b, scaled(-1.0, gradient));
            }
        };
        // A vector beside the positions does not tell who is near.
        match q.first() {
            Some(&q) if K::PLACES == 1 => self.each([q], felt),
            _ => self.each(q, felt),
        }
    }

    /// The kick of a pass that stores no gradient.
    #[inline(never)]
    pub(super) fn kick_felt<const D: usize>(
        &self,
        kernel: &impl Kernel<D, 1, X::Numbers, f64>,
        q: &Vectors<D>,
        kick: Kicked<'_, D>,
    ) where
        X: LinkLaw<D, P>,
        B: Space<D>,
    {
        let Kicked { b, kick, v, to } = kick;
        for k in 0..D {
            to[k].copy_from_slice(v[k]);
        }
        self.felt(kernel, [q], |i, gradient| {
            for k in 0..D {
                to[k][i] -= b * kick[k][i] * gradient[k];
            }
        });
    }

    /// Adds the block of a link to the rows of those of its bodies on which the other acts.
    #[inline(always)]
    pub(super) fn add_link<const D: usize>(&self, a: usize, b: usize, block: Block<D>, out: &mut Matrix<D>) {
        match [a, b].map(|i| self.acting.acts(i)) {
            [true, true] => out.add_link(a, b, block),
            [false, _] => add_felt(a, b, block, out),
            [_, false] => add_felt(b, a, block, out),
        }
    }
}

/// Adds the block of a link to the row of the body that feels it.
#[inline(never)]
fn add_felt<const D: usize>(felt: usize, by: usize, block: Block<D>, out: &mut Matrix<D>) {
    out.add_block(felt, felt, block);
    out.add_block(felt, by, block.map(|row| row.map(|x| -x)));
}
