//! What members carry side by side, one in each lane.

use dmech_scalar::{CompensatedVector, Rows};

use crate::invariant::Drift;

/// Values of a kind, one in each lane.
pub trait ByLane<T> {
    /// Of one by one.
    fn of<'a>(one: &impl Fn(usize) -> &'a T) -> Self
    where
        T: 'a;
    /// The one in a lane.
    fn lane(&self, lane: usize) -> T;
}

impl<const N: usize> ByLane<f64> for Rows<N> {
    #[inline(always)]
    fn of<'a>(one: &impl Fn(usize) -> &'a f64) -> Self {
        Rows::from_fn(|lane| *one(lane))
    }
    #[inline(always)]
    fn lane(&self, lane: usize) -> f64 {
        self[lane]
    }
}

impl<A: ByLane<T>, T, const N: usize> ByLane<[T; N]> for [A; N] {
    fn of<'a>(one: &impl Fn(usize) -> &'a [T; N]) -> Self
    where
        T: 'a,
    {
        core::array::from_fn(|i| A::of(&|lane| &one(lane)[i]))
    }
    fn lane(&self, lane: usize) -> [T; N] {
        core::array::from_fn(|i| self[i].lane(lane))
    }
}

impl<const D: usize, const N: usize> ByLane<CompensatedVector<D, f64>> for CompensatedVector<D, Rows<N>> {
    fn of<'a>(one: &impl Fn(usize) -> &'a CompensatedVector<D, f64>) -> Self {
        CompensatedVector { hi: ByLane::of(&|lane| &one(lane).hi), lo: ByLane::of(&|lane| &one(lane).lo) }
    }
    fn lane(&self, lane: usize) -> CompensatedVector<D, f64> {
        CompensatedVector { hi: self.hi.lane(lane), lo: self.lo.lane(lane) }
    }
}

impl<const N: usize> ByLane<Drift> for Drift<Rows<N>> {
    fn of<'a>(one: &impl Fn(usize) -> &'a Drift) -> Self {
        Drift::by_field(|field| Rows::from_fn(|lane| one(lane).fields()[field]))
    }
    fn lane(&self, lane: usize) -> Drift {
        Drift::by_field(|field| self.fields()[field][lane])
    }
}

/// Says how the fields of what a scheme carries stand in lanes: each of the named ones has a number for each.
macro_rules! by_lane {
    ($($name:ident $(<const $n:ident>)? { $($field:ident),* } $(all { $($same:ident),* })?;)*) => {$(
        impl<A, B, $(const $n: usize)?> crate::scheme::by_lane::ByLane<$name<B $(, $n)?>> for $name<A $(, $n)?>
        where
            A: crate::system::System<
                Scalar: crate::scheme::by_lane::ByLane<B::Scalar>,
                Vector: crate::scheme::by_lane::ByLane<B::Vector>,
                Sum: crate::scheme::by_lane::ByLane<B::Sum>,
                Work: crate::scheme::by_lane::ByLane<B::Work>,
            >,
            B: crate::system::System,
        {
            fn of<'a>(one: &impl Fn(usize) -> &'a $name<B $(, $n)?>) -> Self
            where
                $name<B $(, $n)?>: 'a,
            {
                $name {
                    $($field: crate::scheme::by_lane::ByLane::of(&|lane| &one(lane).$field),)*
                    $($($same: one(0).$same,)*)?
                }
            }
            fn lane(&self, lane: usize) -> $name<B $(, $n)?> {
                $name {
                    $($field: crate::scheme::by_lane::ByLane::lane(&self.$field, lane),)*
                    $($($same: self.$same,)*)?
                }
            }
        }
    )*};
}

pub(crate) use by_lane;
