//! Where bodies are: in open space, or in a periodic box.

use dmech_scalar::{Mask, Real};

use crate::error::SceneError;

/// Where bodies are, which decides what their separation is.
///
/// It is a type, so that a scene in open space has nothing of a box in its loops.
pub trait Space<const D: usize>: Copy + core::fmt::Debug + Send + Sync + 'static {
    /// The space repeats itself.
    const PERIODIC: bool;

    /// d, or the shortest of its images d − n∘l with whole numbers n.
    fn image<R: Real>(&self, d: [R; D]) -> [R; D];

    /// The lengths of the box, if there is one.
    fn lengths(&self) -> Option<[f64; D]>;

    /// Whether this is a space.
    ///
    /// # Errors
    /// [`SceneError::Length`].
    fn check(&self) -> Result<(), SceneError>;
}

/// All of space.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Open;

impl<const D: usize> Space<D> for Open {
    const PERIODIC: bool = false;

    #[inline(always)]
    fn image<R: Real>(&self, d: [R; D]) -> [R; D] {
        d
    }

    fn lengths(&self) -> Option<[f64; D]> {
        None
    }

    fn check(&self) -> Result<(), SceneError> {
        Ok(())
    }
}

/// A box that repeats itself on all sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Periodic<const D: usize> {
    lengths: [f64; D],
    half: [f64; D],
    /// 1/l: a product is faster than a quotient.
    per_length: [f64; D],
}

impl<const D: usize> Periodic<D> {
    pub(crate) fn new(lengths: [f64; D]) -> Self {
        Periodic { lengths, half: lengths.map(|l| 0.5 * l), per_length: lengths.map(f64::recip) }
    }
}

impl<const D: usize> Space<D> for Periodic<D> {
    const PERIODIC: bool = true;

    /// Odd in d to the bit, so that forces on two bodies are opposite.
    #[inline(always)]
    fn image<R: Real>(&self, mut d: [R; D]) -> [R; D] {
        let mut inside = [R::ZERO.equal(R::ZERO); D];
        let mut all = true;
        for k in 0..D {
            inside[k] = d[k].abs().less_or_equal(R::from_f64(self.half[k]));
            all &= inside[k].all();
        }
        // Most separations are the nearest image as they are.
        if all {
            return d;
        }
        for k in 0..D {
            let boxes = whole(d[k] * R::from_f64(self.per_length[k]));
            let image = d[k] - R::from_f64(self.lengths[k]) * boxes;
            d[k] = R::either(inside[k], d[k], image);
        }
        d
    }

    fn lengths(&self) -> Option<[f64; D]> {
        Some(self.lengths)
    }

    fn check(&self) -> Result<(), SceneError> {
        // 1/l of a length near the smallest number is not finite.
        let wrong =
            (0..D).find(|&k| !(self.lengths[k] > 0.0 && self.lengths[k].is_finite() && self.per_length[k].is_finite()));
        wrong.map_or(Ok(()), |component| Err(SceneError::Length { component, length: self.lengths[component] }))
    }
}

/// The whole number next to x, by the digits that a sum with 3·2⁵¹ has room for; of two, the even one.
#[inline(always)]
fn whole<R: Real>(x: R) -> R {
    let shift = R::from_f64(6_755_399_441_055_744.0);
    (x + shift) - shift
}

#[cfg(test)]
mod tests {
    use super::*;

    /// On the edge, half a box away, on either side of it, and many boxes away.
    #[test]
    fn the_image_is_the_nearest_one() {
        let space = Periodic::new([2.0, 10.0]);
        let image = |d| space.image::<f64>(d);
        assert_eq!(image([0.0, 0.0]), [0.0, 0.0]);
        assert_eq!(image([1.0, -5.0]), [1.0, -5.0]);
        assert_eq!(image([1.25, -5.5]), [-0.75, 4.5]);
        assert_eq!(image([2.0, 10.0]), [0.0, 0.0]);
        assert_eq!(image([2e6 + 0.5, -1e7 - 3.0]), [0.5, -3.0]);
        assert!(image([f64::NAN, f64::INFINITY]).iter().all(|x| x.is_nan()));
        for d in [0.3, 0.999, 1.0, 1.001, 2.7, 3.0, 5.0, 123.456] {
            assert_eq!(image([d, d]).map(|x| -x), image([-d, -d]));
            assert!(image([d, d])[0].abs() <= 1.0);
        }
    }
}
