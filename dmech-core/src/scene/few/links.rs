//! Which of few bodies are linked, in the lanes of any scalar.

use dmech_scalar::{Mask, Real};

use crate::law::Numbers;
use crate::scene::terms::{Bonds, KnownLinks, Links};

/// Links among N bodies as numbers, so that those of many members may stand side by side.
pub trait LinksOfFew: Links {
    /// What says which bodies are linked.
    type Numbers<const N: usize>: Numbers;
    /// In which lanes a link is there.
    type Presence<R: Real>: Presence<R>;

    /// What says which of N bodies are linked.
    fn numbers<const N: usize>(&self) -> Self::Numbers<N>;
    /// Visits every link (a, b) that is there in some lane, in a fixed order.
    fn visit<const N: usize, R: Real>(
        numbers: &<Self::Numbers<N> as Numbers>::Of<R>,
        visit: impl FnMut(usize, usize, Self::Presence<R>),
    );
}

/// In which lanes a link is there. Elsewhere sums stay as they are to the bit, whatever its law would give.
pub trait Presence<R: Real>: Copy {
    /// The one where the link is there, the other elsewhere.
    fn choose(self, linked: R, not: R) -> R;
    /// In those lanes alone that the mask has.
    fn within(self, mask: R::Mask) -> Here<R>;
    /// Where both are.
    fn and(self, other: Self) -> Self;
    /// Where one of both is.
    fn or(self, other: Self) -> Self;
    /// In some lane.
    fn anywhere(self) -> bool;
}

/// In all lanes, which costs nothing.
#[derive(Clone, Copy)]
pub struct Always;

impl<R: Real> Presence<R> for Always {
    #[inline(always)]
    fn choose(self, linked: R, _: R) -> R {
        linked
    }
    #[inline(always)]
    fn within(self, mask: R::Mask) -> Here<R> {
        Here(mask)
    }
    #[inline(always)]
    fn and(self, _: Self) -> Self {
        self
    }
    #[inline(always)]
    fn or(self, _: Self) -> Self {
        self
    }
    #[inline(always)]
    fn anywhere(self) -> bool {
        true
    }
}

/// In some lanes.
#[derive(Clone, Copy)]
pub struct Here<R: Real>(R::Mask);

impl<R: Real> Presence<R> for Here<R> {
    #[inline(always)]
    fn choose(self, linked: R, not: R) -> R {
        R::either(self.0, linked, not)
    }
    #[inline(always)]
    fn within(self, mask: R::Mask) -> Here<R> {
        Here(self.0.and(mask))
    }
    #[inline(always)]
    fn and(self, other: Self) -> Self {
        Here(self.0.and(other.0))
    }
    #[inline(always)]
    fn or(self, other: Self) -> Self {
        Here(self.0.or(other.0))
    }
    #[inline(always)]
    fn anywhere(self) -> bool {
        self.0.any()
    }
}

/// Links that follow from the number of bodies.
impl<T: KnownLinks> LinksOfFew for T {
    type Numbers<const N: usize> = [f64; 0];
    type Presence<R: Real> = Always;

    fn numbers<const N: usize>(&self) -> [f64; 0] {
        []
    }
    #[inline(always)]
    fn visit<const N: usize, R: Real>(_: &[R; 0], mut visit: impl FnMut(usize, usize, Always)) {
        T::visit(N, |a, b| visit(a, b, Always));
    }
}

/// Bodies at most: the bits of whole numbers that every scalar has, `f32` too.
const MOST: usize = 24;

/// A number for each body a, in which bit b says that (a, b) is listed. Bonds of members may differ; where they do not, only those that
/// are listed are looked at.
impl LinksOfFew for Bonds {
    type Numbers<const N: usize> = [f64; N];
    type Presence<R: Real> = Here<R>;

    fn numbers<const N: usize>(&self) -> [f64; N] {
        const { assert!(N <= MOST, "bonds in a law are between 24 bodies at most") };
        let mut rows = [0.0; N];
        for &(a, b) in self.listed() {
            rows[a] += f64::from(1_u32 << b);
        }
        rows
    }

    #[inline(always)]
    fn visit<const N: usize, R: Real>(rows: &[R; N], mut visit: impl FnMut(usize, usize, Here<R>)) {
        for (a, &row) in rows.iter().enumerate() {
            let first = row.to_f64();
            let alike = row.equal(R::from_f64(first)).all();
            let mut listed = if alike { first as u32 } else { (1 << N) - 1 };
            while listed != 0 {
                let b = listed.trailing_zeros() as usize;
                listed &= listed - 1;
                let here = if alike { Mask::of(true) } else { has_bit(row, b) };
                if here.any() {
                    visit(a, b, Here(here));
                }
            }
        }
    }
}

/// Where bit b of a whole number is 1.
#[inline(always)]
fn has_bit<R: Real>(number: R, b: usize) -> R::Mask {
    let halves = number * R::from_f64(1.0 / f64::from(2_u32 << b));
    R::from_f64(0.5).less_or_equal(halves - halves.floor())
}

#[cfg(test)]
mod tests {
    use dmech_scalar::{DoubleDouble, Lanes};

    use super::*;

    const LISTS: [&[(usize, usize)]; 4] = [&[], &[(0, 1), (2, 1)], &[(1, 0)], &[(23, 0), (0, 23), (22, 23), (0, 1)]];

    /// The bonds of each lane as they are visited.
    fn visited<R: Real>(rows: [R; 24], lane: impl Fn(R) -> f64) -> Vec<(usize, usize)> {
        let mut all = Vec::new();
        <Bonds as LinksOfFew>::visit::<24, R>(&rows, |a, b, here| {
            if lane(here.choose(R::ONE, R::ZERO)) == 1.0 {
                all.push((a, b));
            }
        });
        all
    }

    #[test]
    fn bonds_are_those_of_the_list_in_every_scalar_and_lane() {
        let rows = LISTS.map(|list| LinksOfFew::numbers::<24>(&Bonds::new(list.iter().copied())));
        for (k, list) in LISTS.iter().enumerate() {
            let mut list = list.to_vec();
            list.sort_unstable();
            assert_eq!(visited(rows[k], |x| x), list);
            assert_eq!(visited(rows[k].map(|x| x as f32), f64::from), list);
            assert_eq!(visited(rows[k].map(DoubleDouble::from), |x| x.to_f64()), list);
            assert_eq!(visited(rows[k].map(Lanes::splat), |x| x[5]), list);
            let unlike = core::array::from_fn(|a| Lanes::from_fn(|lane| rows[lane % 4][a]));
            assert_eq!(visited(unlike, |x| x[k]), list);
        }
        // A link that is in no lane is not looked at, and neither is one of a law that was refused.
        let mut seen = 0;
        let unlike = core::array::from_fn(|a| Lanes::from_fn(|lane| rows[lane % 2][a]));
        <Bonds as LinksOfFew>::visit::<24, Lanes>(&unlike, |_, _, _| seen += 1);
        assert_eq!((seen, visited([f64::NAN; 24], |x| x).len()), (2, 0));
    }
}
