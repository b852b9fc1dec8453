//! Solving without factors where the step resolves the motion well.

use crate::scene::vectors::Vectors;
use crate::vector::largest;

/// (1 + g J)⁻¹ x = Σ (−g J)ᵏ x, for a small g J.
///
/// A term costs one product with J: n² operations for a dense matrix against n³/3 to factorise, and for a sparse one the
/// number of its entries against that of its factors and their fill. Factors kept from an earlier step would save as much,
/// but the next step would then depend on when they were made, and could not be resumed from positions and forces.
#[derive(Clone, Debug)]
pub(super) struct Series {
    term: Vec<f64>,
    image: Vec<f64>,
}

/// Where each row of |g J| adds up to this at most, the series ends after 14 terms.
pub(super) const SMALL: f64 = 1.0 / 16.0;

impl Series {
    pub(super) fn new(n: usize) -> Self {
        Series { term: vec![0.0; n], image: vec![0.0; n] }
    }

    /// Whether Σ |g J| over a row is nowhere larger than `limit`; `add_rows` adds the sums over rows of |J|.
    pub(super) fn ends<const D: usize>(
        &mut self,
        g: &Vectors<D>,
        limit: f64,
        add_rows: impl FnOnce(&mut [f64]),
    ) -> bool {
        self.term.fill(0.0);
        add_rows(&mut self.term);
        self.term.iter_mut().zip(g.flat()).for_each(|(sum, g)| *sum *= g.abs());
        largest(&self.term) <= limit
    }

    /// x ← x + M x + M² x + …, until the terms are below rounding; `add_product(x, y)` is y += M x with M = −g J.
    pub(super) fn solve(&mut self, x: &mut [f64], add_product: impl Fn(&[f64], &mut [f64])) {
        self.term.copy_from_slice(x);
        loop {
            self.image.fill(0.0);
            add_product(&self.term, &mut self.image);
            core::mem::swap(&mut self.term, &mut self.image);
            x.iter_mut().zip(&self.term).for_each(|(x, term)| *x += term);
            let (size, term) = (largest(x), largest(&self.term));
            // What is not finite does not get smaller.
            let goes_on = term > 0.5 * f64::EPSILON * size && size.is_finite();
            if !goes_on {
                return;
            }
        }
    }
}
