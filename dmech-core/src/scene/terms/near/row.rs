//! One body and its neighbours, those within reach side by side.

use dmech_scalar::{Lanes, Mask, Real};

use crate::law::Numbers;
use crate::scene::space::Space;
use crate::scene::terms::numbers::NumberColumns;
use crate::scene::terms::sweep::Kernel;
use crate::vector::{difference, dot};

/// Those of the neighbours of one body that are within reach.
///
/// Who is in the lists but beyond reach is left out first: the law is not evaluated there, and lanes are filled the same
/// way whatever the lists.
#[derive(Debug, Default)]
pub(super) struct Row {
    cutoff: f64,
    bodies: Vec<u32>,
}

/// |d|² of the nearest image of a − b.
#[inline(always)]
pub(super) fn square<const D: usize, R: Real>(space: &impl Space<D>, a: [R; D], b: [R; D]) -> R {
    let d = space.image(difference(a, b));
    dot(d, d)
}

/// How many of the moments of a kernel are separations.
pub(super) fn places<K: Kernel<D, S, N, Lanes>, const D: usize, const S: usize, N: Numbers>(_: &K) -> usize {
    K::PLACES
}

/// q_a − q_b for eight b.
#[inline(always)]
fn separations<const D: usize, const S: usize>(
    here: &[[f64; D]; S],
    q: &[&[[f64; D]]; S],
    bodies: &[u32; Lanes::COUNT],
) -> [[Lanes; D]; S] {
    let mut d = [[Lanes::ZERO; D]; S];
    for moment in 0..S {
        for k in 0..D {
            let there = Lanes::from_fn(|lane| q[moment][bodies[lane] as usize][k]);
            d[moment][k] = Lanes::splat(here[moment][k]) - there;
        }
    }
    d
}

/// Where a body is at each moment.
#[inline(always)]
fn at<const D: usize, const S: usize>(q: &[&[[f64; D]]; S], a: usize) -> [[f64; D]; S] {
    let mut here = [[0.0; D]; S];
    for moment in 0..S {
        here[moment] = q[moment][a];
    }
    here
}

impl Row {
    /// Makes room for so many neighbours, and for what fills up the last register.
    pub(super) fn fit(&mut self, neighbours: usize, cutoff: f64) {
        self.cutoff = cutoff;
        self.bodies.resize(neighbours.next_multiple_of(Lanes::COUNT) + Lanes::COUNT, 0);
    }

    /// Collects the neighbours of body a that are within reach at one of the first `places` moments: how many.
    #[inline(always)]
    pub(super) fn gather<const D: usize, const S: usize>(
        &mut self,
        space: &impl Space<D>,
        places: usize,
        q: &[&[[f64; D]]; S],
        a: usize,
        neighbours: &[u32],
    ) -> usize {
        let (limit, here) = (Lanes::splat(self.cutoff * self.cutoff), at(q, a));
        let kept = self.bodies.as_mut_slice();
        let mut found = 0;
        for eight in neighbours.chunks(Lanes::COUNT) {
            // The register is filled up with the last of them.
            let last = eight.len() - 1;
            let eight: &[u32; Lanes::COUNT] = match eight.first_chunk() {
                Some(eight) => eight,
                None => &core::array::from_fn(|lane| eight[lane.min(last)]),
            };
            let d = separations(&here, q, eight);
            let mut within = <Lanes as Real>::Mask::of(false);
            for moment in 0..places {
                let image = space.image(d[moment]);
                within = within.or(dot(image, image).less(limit));
            }
            let within = within.to_array();
            // Each is written, and kept if it counts: no branch can be guessed here.
            for lane in 0..Lanes::COUNT {
                kept[found] = eight[lane];
                found += usize::from(within[lane] && lane <= last);
            }
        }
        found
    }

    /// Adds what acts between body a and those that were found: `felt` begins with body `start`.
    #[inline(always)]
    pub(super) fn add<const D: usize, const S: usize, N: Numbers>(
        &mut self,
        kernel: &impl Kernel<D, S, N, Lanes>,
        numbers: &NumberColumns<N>,
        q: &[&[[f64; D]]; S],
        [a, start]: [usize; 2],
        found: usize,
        felt: &mut [[f64; D]],
    ) {
        let (on_a, here) = (numbers.at(a), at(q, a));
        let mut sums = [Lanes::ZERO; D];
        self.bodies[found..found.next_multiple_of(Lanes::COUNT)].fill(a as u32);
        let (eights, _) = self.bodies.as_chunks::<{ Lanes::COUNT }>();
        for (i, eight) in eights[..found.div_ceil(Lanes::COUNT)].iter().enumerate() {
            let mut d = separations(&here, q, eight);
            let count = (found - i * Lanes::COUNT).min(Lanes::COUNT);
            // What fills up the last register is at the cut-off, where nothing acts.
            for moment in d.iter_mut() {
                for lane in count..Lanes::COUNT {
                    if let Some(first) = moment.first_mut() {
                        first[lane] = self.cutoff;
                    }
                }
            }
            let gradient = kernel.gradient(on_a, numbers.of(|lane| eight[lane] as usize), d);
            for k in 0..D {
                sums[k] += gradient[k];
            }
            for (lane, &b) in eight[..count].iter().enumerate() {
                let felt = &mut felt[b as usize - start];
                for k in 0..D {
                    felt[k] -= gradient[k][lane];
                }
            }
        }
        for k in 0..D {
            felt[a - start][k] += sums[k].sum();
        }
    }
}
