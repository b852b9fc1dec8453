//! Vectors of many bodies, stored by component.

use crate::vector::largest;

/// One vector of D components for each of n bodies: D columns of n numbers, one after another.
///
/// Loops over bodies then read memory in order, and what treats all components alike runs over one slice.
pub struct Vectors<const D: usize> {
    bodies: usize,
    memory: Vec<f64>,
    offset: usize,
}

/// Numbers after each list of vectors. Lists of equal length one behind the other would lie a few numbers apart modulo 4 kB,
/// where a load seems to wait for every recent store: a tenth to a half of the time of a chain.
const APART: usize = 64;
/// Numbers in a line of the cache: registers that begin with one are loaded at once.
const LINE: usize = 8;
/// A line of numbers.
pub(super) type Line = [f64; LINE];

impl<const D: usize> Vectors<D> {
    /// n vectors of zeros.
    pub fn zeros(bodies: usize) -> Self {
        let memory = vec![0.0; D * bodies + LINE + APART];
        let offset = memory.as_ptr().align_offset(LINE * size_of::<f64>()).min(LINE);
        Vectors { bodies, memory, offset }
    }

    /// The vectors of a list.
    pub fn from_list(list: &[[f64; D]]) -> Self {
        let mut vectors = Vectors::zeros(list.len());
        for (i, &x) in list.iter().enumerate() {
            vectors.set(i, x);
        }
        vectors
    }

    /// The same, body by body.
    pub fn to_list(&self) -> Vec<[f64; D]> {
        (0..self.bodies).map(|i| self.get(i)).collect()
    }

    /// The number of bodies.
    #[inline]
    pub fn bodies(&self) -> usize {
        self.bodies
    }

    /// All components, column after column: component k of body i is at k n + i.
    #[inline]
    pub fn flat(&self) -> &[f64] {
        &self.memory[self.offset..self.offset + D * self.bodies]
    }

    /// The same, to be written to.
    #[inline]
    pub fn flat_mut(&mut self) -> &mut [f64] {
        &mut self.memory[self.offset..self.offset + D * self.bodies]
    }

    /// The same in blocks of a line; what fills up the last belongs to no body, and is not looked at. Loops over blocks have no
    /// remainder, which for few bodies is most of them.
    #[inline]
    pub(super) fn blocks(&self) -> &[Line] {
        self.memory[self.offset..].as_chunks().0.split_at((D * self.bodies).div_ceil(LINE)).0
    }

    /// The same, to be written to.
    #[inline]
    pub(super) fn blocks_mut(&mut self) -> &mut [Line] {
        self.memory[self.offset..].as_chunks_mut().0.split_at_mut((D * self.bodies).div_ceil(LINE)).0
    }

    /// The columns.
    #[inline]
    pub fn columns(&self) -> [&[f64]; D] {
        let flat = self.flat();
        core::array::from_fn(|k| &flat[k * self.bodies..(k + 1) * self.bodies])
    }

    /// The columns, to be written to.
    #[inline]
    pub fn columns_mut(&mut self) -> [&mut [f64]; D] {
        let bodies = self.bodies;
        let mut rest = self.flat_mut();
        core::array::from_fn(|_| rest.split_off_mut(..bodies).unwrap_or_default())
    }

    /// The vector of body i.
    #[inline(always)]
    pub fn get(&self, i: usize) -> [f64; D] {
        let flat = self.flat();
        let mut x = [0.0; D];
        for k in 0..D {
            x[k] = flat[k * self.bodies + i];
        }
        x
    }

    /// Replaces the vector of body i.
    #[inline(always)]
    pub fn set(&mut self, i: usize, x: [f64; D]) {
        let bodies = self.bodies;
        let flat = self.flat_mut();
        for k in 0..D {
            flat[k * bodies + i] = x[k];
        }
    }

    /// Adds to the vector of body i.
    #[inline(always)]
    pub fn add(&mut self, i: usize, x: [f64; D]) {
        let bodies = self.bodies;
        let flat = self.flat_mut();
        for k in 0..D {
            flat[k * bodies + i] += x[k];
        }
    }

    /// Sets every component to zero.
    #[inline]
    pub fn clear(&mut self) {
        self.flat_mut().fill(0.0);
    }

    /// Whether every component is finite.
    #[inline]
    pub fn is_finite(&self) -> bool {
        // 0·x is 0 for a finite x and NaN for any other; one sum over all needs no branch.
        let mut sums = [0.0; 8];
        let mut chunks = self.flat().chunks_exact(8);
        for chunk in &mut chunks {
            for (sum, x) in sums.iter_mut().zip(chunk) {
                *sum += 0.0 * x;
            }
        }
        let rest: f64 = chunks.remainder().iter().map(|x| 0.0 * x).sum();
        sums.iter().sum::<f64>() + rest == 0.0
    }

    /// The largest component in absolute value; NaN if one is.
    pub fn largest(&self) -> f64 {
        largest(self.flat())
    }
}

impl<const D: usize> Clone for Vectors<D> {
    fn clone(&self) -> Self {
        let mut copy = Vectors::zeros(self.bodies);
        copy.flat_mut().copy_from_slice(self.flat());
        copy
    }

    /// Without a new allocation where the number of bodies is the same.
    fn clone_from(&mut self, other: &Self) {
        if self.bodies == other.bodies {
            self.flat_mut().copy_from_slice(other.flat());
        } else {
            *self = other.clone();
        }
    }
}

impl<const D: usize> PartialEq for Vectors<D> {
    fn eq(&self, other: &Self) -> bool {
        self.bodies == other.bodies && self.flat() == other.flat()
    }
}

impl<const D: usize> core::fmt::Debug for Vectors<D> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_list().entries(self.to_list()).finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_hold_the_vectors_of_a_list() {
        let list = [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]];
        let mut vectors = Vectors::from_list(&list);
        assert_eq!(vectors.flat(), [1.0, 4.0, 2.0, 5.0, 3.0, 6.0]);
        vectors.columns_mut()[1][0] += 10.0;
        vectors.add(1, [0.5, 0.0, -6.0]);
        assert_eq!(vectors.to_list(), [[1.0, 12.0, 3.0], [4.5, 5.0, 0.0]]);
        assert_eq!((vectors.largest(), vectors.is_finite()), (12.0, true));
        for (i, bad) in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY].into_iter().enumerate() {
            let mut wrong = Vectors::<1>::zeros(11);
            wrong.flat_mut()[5 * i] = bad;
            assert!(!wrong.is_finite() && !wrong.largest().is_finite());
        }
    }
}
