//! The loop over all pairs on all cores, by hand, equal to the bit for any number of threads.
//!
//! The rows of the triangle i < j are cut into chunks of about as many pairs each. Their number depends on the number of
//! bodies only, and each has an array of its own for what its bodies feel; the arrays are added in the order of the chunks.

use std::ops::Range;

use rayon::prelude::*;
use wide::f64x8;

use super::bodies::{Registers, rows};

/// Waking the threads takes about 10 µs: at 256 bodies (34 µs) two cores lose, at 384 (74 µs) they gain.
const SMALLEST: usize = 384 / 8;
/// Enough to keep several cores evenly busy; 16 arrays to add cost 1 % at 1000 bodies.
const CHUNKS: usize = 16;

struct Chunk {
    rows: Range<usize>,
    /// For the bodies from the first row on.
    felt: [Vec<f64x8>; 3],
}

pub(super) struct Chunks(Vec<Chunk>);

impl Chunks {
    /// For so many blocks of eight bodies.
    pub(super) fn new(blocks: usize) -> Self {
        let count = if blocks < SMALLEST { 1 } else { CHUNKS };
        // Rows before r leave the part (1 − r)² of the triangle.
        let end = |c: usize| (blocks as f64 * (1.0 - (1.0 - c as f64 / count as f64).sqrt())).round() as usize;
        let zeros = |n: usize| [0; 3].map(|_| vec![f64x8::splat(0.0); n]);
        Self((0..count).map(|c| Chunk { rows: end(c)..end(c + 1), felt: zeros(blocks - end(c)) }).collect())
    }

    pub(super) fn accelerate(&mut self, bodies: &mut Registers) {
        let Registers { gm, q, a, .. } = bodies;
        if let [all] = &mut self.0[..] {
            return rows(gm, q, all.rows.clone(), a);
        }
        self.0.par_iter_mut().for_each(|chunk| rows(gm, q, chunk.rows.clone(), &mut chunk.felt));
        for (i, a) in a.iter_mut().enumerate() {
            a.copy_from_slice(&self.0[0].felt[i]);
            for chunk in &self.0[1..] {
                for (a, felt) in a[chunk.rows.start..].iter_mut().zip(&chunk.felt[i]) {
                    *a += *felt;
                }
            }
        }
    }
}
