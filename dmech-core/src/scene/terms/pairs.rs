//! Any two bodies, on all cores where that pays, equal to the bit for any number of threads.

use std::sync::{Mutex, PoisonError};

use super::cores::each_on_its_core;
use super::links::{self, KnownLinks, Links};
use super::numbers::NumberColumns;
use super::sweep::{self, Kernels, Positions};
use crate::law::Numbers;
use crate::scene::acting::Acting;
use crate::scene::space::Space;
use crate::scene::topology::Topology;
use crate::scene::vectors::Vectors;

/// From so many bodies on the triangle of pairs is cut into chunks: with fewer, waking threads takes longer than they save
/// (two cores: slower at 256 bodies, 1.2 times as fast at 384, 1.4 at 512).
const CUT: usize = 512;

/// Any two bodies.
#[derive(Debug, Default)]
pub struct Pairs {
    /// What the bodies feel from each chunk, from its first row on: the later bodies are linked to no earlier one. Empty
    /// until it is needed.
    room: Mutex<Vec<Vec<f64>>>,
}

impl Clone for Pairs {
    fn clone(&self) -> Self {
        Pairs::default()
    }
}

/// How many chunks: it depends on the number of bodies only, so that sums are formed in the same order on any machine.
fn chunks(bodies: usize) -> usize {
    if bodies < CUT { 1 } else { (bodies / 64).clamp(8, 32) }
}

/// Where chunk c begins, in about equal numbers of pairs: rows before r leave the part (1 − r/n)² of the triangle.
fn begin(bodies: usize, chunks: usize, c: usize) -> usize {
    (bodies as f64 * (1.0 - (1.0 - c as f64 / chunks as f64).sqrt())).round() as usize
}

impl KnownLinks for Pairs {
    #[inline(always)]
    fn visit(bodies: usize, mut visit: impl FnMut(usize, usize)) {
        for a in 0..bodies {
            for b in a + 1..bodies {
                visit(a, b);
            }
        }
    }
}

impl Links for Pairs {
    const ONE_SIDED: bool = true;

    #[inline]
    fn each<const D: usize, const S: usize>(
        &self,
        _: &impl Space<D>,
        q: [&Vectors<D>; S],
        visit: impl FnMut(usize, usize),
    ) {
        Self::visit(links::bodies(q), visit);
    }

    /// Rows of those that act: many test bodies among few others take O(N).
    fn each_acting<const D: usize, const S: usize>(
        &self,
        _: &impl Space<D>,
        q: [&Vectors<D>; S],
        acts: impl Fn(usize) -> bool,
        mut visit: impl FnMut(usize, usize),
    ) {
        let bodies = links::bodies(q);
        for a in (0..bodies).filter(|&a| acts(a)) {
            for b in (0..bodies).filter(|&b| b > a || (b < a && !acts(b))) {
                visit(a, b);
            }
        }
    }

    fn sweep<const SET: bool, const D: usize, const S: usize, N: Numbers>(
        &self,
        _: &impl Space<D>,
        kernel: &impl Kernels<D, S, N>,
        q: [&Vectors<D>; S],
        numbers: &NumberColumns<N>,
        out: &mut Vectors<D>,
    ) {
        if SET {
            out.clear();
        }
        let bodies = out.bodies();
        let q = q.map(|q| q.columns());
        let count = chunks(bodies);
        if count == 1 {
            return sweep::triangle(kernel, &q, numbers, 0..bodies, out.columns_mut());
        }
        let mut room = self.room.lock().unwrap_or_else(PoisonError::into_inner);
        room.resize_with(count, Vec::new);
        each_on_its_core(&mut room, |c, felt| chunk(kernel, &q, numbers, c, count, felt));
        for (c, felt) in room.iter().enumerate() {
            let start = begin(bodies, count, c);
            for (out, felt) in out.columns_mut().into_iter().zip(felt.chunks_exact(bodies - start)) {
                for (out, felt) in out[start..].iter_mut().zip(felt) {
                    *out += felt;
                }
            }
        }
    }

    fn sweep_one_sided<const D: usize, const S: usize, N: Numbers>(
        &self,
        kernel: &impl Kernels<D, S, N>,
        q: [&Vectors<D>; S],
        numbers: &NumberColumns<N>,
        acting: &Acting,
        out: &mut Vectors<D>,
    ) {
        sweep::one_sided(kernel, &q.map(|q| q.columns()), numbers, acting.groups(), out.columns_mut());
    }

    fn topology(&self) -> Topology {
        Topology::Dense
    }
}

/// What the bodies feel from the pairs of chunk c.
fn chunk<const D: usize, const S: usize, N: Numbers>(
    kernel: &impl Kernels<D, S, N>,
    q: &Positions<'_, D, S>,
    numbers: &NumberColumns<N>,
    c: usize,
    count: usize,
    felt: &mut Vec<f64>,
) {
    let bodies = numbers.bodies();
    let rows = begin(bodies, count, c)..begin(bodies, count, c + 1);
    let length = bodies - rows.start;
    felt.resize(D * length, 0.0);
    felt.fill(0.0);
    let mut rest = felt.as_mut_slice();
    let columns: [&mut [f64]; D] = core::array::from_fn(|_| rest.split_off_mut(..length).unwrap_or_default());
    sweep::triangle(kernel, q, numbers, rows, columns);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every pair is in one chunk, and no chunk has more than a quarter above its share.
    #[test]
    fn chunks_cut_the_triangle_evenly() {
        for bodies in [512, 513, 1000, 4097, 100_000] {
            let count = chunks(bodies);
            assert!(count >= 8 && begin(bodies, count, 0) == 0 && begin(bodies, count, count) == bodies);
            let pairs = |c: usize| -> usize {
                (begin(bodies, count, c)..begin(bodies, count, c + 1)).map(|a| bodies - 1 - a).sum()
            };
            let all: usize = (0..count).map(pairs).sum();
            assert_eq!(all, bodies * (bodies - 1) / 2);
            assert!((0..count).all(|c| pairs(c) * count * 4 <= all * 5), "{bodies}");
        }
    }
}
