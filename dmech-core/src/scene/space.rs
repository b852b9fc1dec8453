//! Where bodies are: in open space, or in a periodic box.

use dmech_scalar::{Mask, Real};

use crate::error::SceneError;
use crate::law::Numbers;

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

    #[inline(always)]
    fn image<R: Real>(&self, d: [R; D]) -> [R; D] {
        nearest_image(
            d,
            |k| R::from_f64(self.half[k]),
            |k| R::from_f64(self.lengths[k]),
            |k| R::from_f64(self.per_length[k]),
        )
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

/// d − n∘l by half of l, l and 1/l, of each coordinate. Odd in d to the bit, so that forces on two bodies are opposite.
#[inline(always)]
fn nearest_image<const D: usize, R: Real>(
    mut d: [R; D],
    half: impl Fn(usize) -> R,
    length: impl Fn(usize) -> R,
    per_length: impl Fn(usize) -> R,
) -> [R; D] {
    let mut inside = [R::Mask::of(true); D];
    let mut all = true;
    for k in 0..D {
        inside[k] = d[k].abs().less_or_equal(half(k));
        all &= inside[k].all();
    }
    // Most separations are the nearest image as they are.
    if all {
        return d;
    }
    for k in 0..D {
        let boxes = whole(d[k] * per_length(k));
        let image = d[k] - length(k) * boxes;
        d[k] = R::either(inside[k], d[k], image);
    }
    d
}

/// The whole number next to x. Of two it is, with the digits of `f64`, the even one.
#[inline(always)]
fn whole<R: Real>(x: R) -> R {
    if R::EPSILON.to_f64() != f64::EPSILON {
        return x.round();
    }
    // By the digits that a sum with 3·2⁵¹ has room for.
    let shift = R::from_f64(6_755_399_441_055_744.0);
    (x + shift) - shift
}

/// Separations in a scalar.
pub trait Images<const D: usize, R: Real>: Copy {
    /// The space repeats itself.
    const PERIODIC: bool;

    /// [`Space::image`].
    fn nearest(&self, d: [R; D]) -> [R; D];
    /// Half the length of the box along a coordinate, if there is one.
    fn half(&self, k: usize) -> R;
}

impl<const D: usize, R: Real, B: Space<D>> Images<D, R> for B {
    const PERIODIC: bool = <B as Space<D>>::PERIODIC;

    #[inline(always)]
    fn nearest(&self, d: [R; D]) -> [R; D] {
        self.image(d)
    }
    #[inline(always)]
    fn half(&self, k: usize) -> R {
        self.lengths().map_or(R::ZERO, |lengths| R::from_f64(0.5 * lengths[k]))
    }
}

/// A space as numbers, so that those of many members may stand side by side.
pub trait SpaceOfFew<const D: usize>: Space<D> {
    /// What is read of it.
    type Numbers: Numbers;
    /// The same space by numbers of any scalar.
    type In<R: Real>: Images<D, R>;

    /// What is read of it.
    fn numbers(&self) -> Self::Numbers;
    /// The names of these numbers, in their order.
    fn names(see: &mut dyn FnMut(&'static str));
    /// The space of these numbers.
    fn of<R: Real>(numbers: <Self::Numbers as Numbers>::Of<R>) -> Self::In<R>;
}

impl<const D: usize> SpaceOfFew<D> for Open {
    type Numbers = [f64; 0];
    type In<R: Real> = Open;

    fn numbers(&self) -> [f64; 0] {
        []
    }
    fn names(_: &mut dyn FnMut(&'static str)) {}
    #[inline(always)]
    fn of<R: Real>(_: [R; 0]) -> Open {
        Open
    }
}

impl<const D: usize> SpaceOfFew<D> for Periodic<D> {
    type Numbers = [[f64; D]; 3];
    type In<R: Real> = Boxes<D, R>;

    fn numbers(&self) -> [[f64; D]; 3] {
        [self.lengths, self.half, self.per_length]
    }
    fn names(see: &mut dyn FnMut(&'static str)) {
        ["box", "half_box", "per_box"].into_iter().for_each(|name| (0..D).for_each(|_| see(name)));
    }
    #[inline(always)]
    fn of<R: Real>([lengths, half, per_length]: [[R; D]; 3]) -> Boxes<D, R> {
        Boxes { half, lengths, per_length }
    }
}

/// A box that repeats itself on all sides, another one in each lane.
#[derive(Clone, Copy, Debug)]
pub struct Boxes<const D: usize, R> {
    half: [R; D],
    lengths: [R; D],
    per_length: [R; D],
}

impl<const D: usize, R: Real> Images<D, R> for Boxes<D, R> {
    const PERIODIC: bool = true;

    #[inline(always)]
    fn nearest(&self, d: [R; D]) -> [R; D] {
        nearest_image(d, |k| self.half[k], |k| self.lengths[k], |k| self.per_length[k])
    }
    #[inline(always)]
    fn half(&self, k: usize) -> R {
        self.half[k]
    }
}

#[cfg(test)]
mod tests {
    use dmech_scalar::{DoubleDouble, Lanes};

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

    /// In more digits than those of `f64`, in fewer, and in lanes with a box in each.
    #[test]
    fn the_image_in_every_scalar() {
        let space = Periodic::new([2.0, 10.0]);
        for d in [[0.25, -4.0], [1.0, 5.0], [1.25, -5.5], [-2.75, 14.5], [2e3 + 0.5, -1e4 - 3.0]] {
            let image = space.image::<f64>(d);
            let wide = <Periodic<2> as SpaceOfFew<2>>::of(space.numbers().map(|x| x.map(DoubleDouble::from)));
            assert_eq!(wide.nearest(d.map(DoubleDouble::from)).map(|x| x.to_f64()), image);
            assert_eq!(space.image(d.map(|x| x as f32)).map(f64::from), image);
            let boxes = [space, Periodic::new([3.0, 0.7])];
            let lanes = <[[f64; 2]; 3]>::gather(|k| Lanes::from_fn(|lane| boxes[lane % 2].numbers().at(k)));
            let all = <Periodic<2> as SpaceOfFew<2>>::of(lanes).nearest(d.map(Lanes::splat));
            for lane in 0..Lanes::COUNT {
                assert_eq!(all.map(|x| x[lane]), boxes[lane % 2].image::<f64>(d));
            }
        }
    }
}
