//! What a pair law reads of the bodies, in columns.

use dmech_scalar::{Lanes, Real};

use super::packed::Packed;
use crate::law::Numbers;

/// K numbers of each of n bodies, by column.
#[derive(Clone, Debug)]
pub struct NumberColumns<N> {
    bodies: usize,
    flat: Vec<f64>,
    layout: core::marker::PhantomData<N>,
}

impl<N: Numbers> NumberColumns<N> {
    pub(super) fn new(list: impl ExactSizeIterator<Item = N>) -> Self {
        let bodies = list.len();
        let mut flat = vec![0.0; N::COUNT * bodies];
        for (i, numbers) in list.enumerate() {
            for k in 0..N::COUNT {
                flat[k * bodies + i] = numbers.at(k);
            }
        }
        NumberColumns { bodies, flat, layout: core::marker::PhantomData }
    }

    /// All of them, column by column.
    pub(super) fn flat(&self) -> &[f64] {
        &self.flat
    }

    /// Those of body i.
    pub(in crate::scene) fn of_body(&self, i: usize) -> N {
        N::from_list(|k| self.flat[k * self.bodies + i])
    }

    /// The number of bodies.
    pub(super) fn bodies(&self) -> usize {
        self.bodies
    }

    /// Those of body i, in each lane.
    #[inline(always)]
    pub(super) fn at<R: Real>(&self, i: usize) -> N::Of<R> {
        N::gather(|k| R::from_f64(self.flat[k * self.bodies + i]))
    }

    /// Those of eight bodies anywhere.
    #[inline(always)]
    pub(super) fn of(&self, body: impl Fn(usize) -> usize) -> N::Of<Lanes> {
        N::gather(|k| Lanes::from_fn(|lane| self.flat[k * self.bodies + body(lane)]))
    }

    /// Those of as many bodies as R has lanes, from body i on.
    #[inline(always)]
    pub(super) fn load<R: Packed>(&self, i: usize) -> N::Of<R> {
        N::gather(|k| R::load(&self.flat[k * self.bodies..(k + 1) * self.bodies], i))
    }
}
