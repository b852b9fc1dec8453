//! What members carry side by side, one in each lane.

use dmech_scalar::{CompensatedVector, Lanes, Real, Rows, RowsMask};

use crate::drift::Drift;

/// Values of a kind, one in each lane of W rows.
pub trait ByLane<T, const W: usize> {
    /// One in every lane.
    fn alike(one: &T) -> Self;
    /// The one in a lane.
    fn lane(&self, lane: usize) -> T;
    /// Another in a lane.
    fn set(&mut self, lane: usize, one: &T);
    /// Those of another where the mask holds, from which a step begins: what it adds up itself is nothing yet.
    fn put(&mut self, which: RowsMask<W>, other: &Self);
}

impl<const W: usize> ByLane<f64, W> for Rows<W> {
    #[inline(always)]
    fn alike(one: &f64) -> Self {
        Rows::from_f64(*one)
    }
    #[inline(always)]
    fn lane(&self, lane: usize) -> f64 {
        self[lane]
    }
    #[inline(always)]
    fn set(&mut self, lane: usize, one: &f64) {
        self[lane] = *one;
    }
    #[inline(always)]
    fn put(&mut self, which: RowsMask<W>, other: &Self) {
        *self = Rows::either(which, *other, *self);
    }
}

/// The stages of one stand in lanes, those of several one after another.
impl<const W: usize> ByLane<Lanes, W> for [Rows<W>; Lanes::COUNT] {
    fn alike(one: &Lanes) -> Self {
        one.to_array().map(Rows::from_f64)
    }
    fn lane(&self, lane: usize) -> Lanes {
        Lanes::from_fn(|stage| self[stage][lane])
    }
    fn set(&mut self, lane: usize, one: &Lanes) {
        for (stage, own) in self.iter_mut().enumerate() {
            own[lane] = one[stage];
        }
    }
    fn put(&mut self, which: RowsMask<W>, other: &Self) {
        for (own, other) in self.iter_mut().zip(other) {
            ByLane::<f64, W>::put(own, which, other);
        }
    }
}

impl<A: ByLane<T, W>, T, const N: usize, const W: usize> ByLane<[T; N], W> for [A; N] {
    fn alike(one: &[T; N]) -> Self {
        core::array::from_fn(|i| A::alike(&one[i]))
    }
    fn lane(&self, lane: usize) -> [T; N] {
        core::array::from_fn(|i| self[i].lane(lane))
    }
    fn set(&mut self, lane: usize, one: &[T; N]) {
        for i in 0..N {
            self[i].set(lane, &one[i]);
        }
    }
    #[inline(always)]
    fn put(&mut self, which: RowsMask<W>, other: &Self) {
        for i in 0..N {
            self[i].put(which, &other[i]);
        }
    }
}

impl<const D: usize, const W: usize> ByLane<CompensatedVector<D, f64>, W> for CompensatedVector<D, Rows<W>> {
    fn alike(CompensatedVector { hi, lo }: &CompensatedVector<D, f64>) -> Self {
        CompensatedVector { hi: ByLane::alike(hi), lo: ByLane::alike(lo) }
    }
    fn lane(&self, lane: usize) -> CompensatedVector<D, f64> {
        CompensatedVector { hi: self.hi.lane(lane), lo: self.lo.lane(lane) }
    }
    fn set(&mut self, lane: usize, one: &CompensatedVector<D, f64>) {
        self.hi.set(lane, &one.hi);
        self.lo.set(lane, &one.lo);
    }
    #[inline(always)]
    fn put(&mut self, which: RowsMask<W>, other: &Self) {
        self.hi.put(which, &other.hi);
        self.lo.put(which, &other.lo);
    }
}

impl<const W: usize> ByLane<Drift, W> for Drift<Rows<W>> {
    fn alike(one: &Drift) -> Self {
        let fields = one.fields();
        Drift::by_field(|field| Rows::from_f64(fields[field]))
    }
    fn lane(&self, lane: usize) -> Drift {
        let all = self.each_field();
        Drift::by_field(|field| all[field][lane])
    }
    fn set(&mut self, lane: usize, one: &Drift) {
        for (all, own) in self.each_field_mut().into_iter().zip(one.fields()) {
            all[lane] = own;
        }
    }
    fn put(&mut self, which: RowsMask<W>, other: &Self) {
        let (own, other) = (self.fields(), other.fields());
        *self = Drift::by_field(|field| Rows::either(which, other[field], own[field]));
    }
}

/// Says how the fields of what a scheme carries stand in lanes: each of the named ones has a number for each. A memory of stages is one of
/// `Staged with Pushes`. A sum is what a step adds up.
macro_rules! by_lane {
    ($($name:ident $(<const $n:ident>)? $(of $system:ident with $more:ident)? { $($field:ident),* } $(sums { $($sum:ident),* })?
        $(all { $($same:ident),* })?
        $(afresh { $($new:ident),* })?;)*) => {$(
        impl<A, B, $(const $n: usize,)? const W: usize> crate::scheme::by_lane::ByLane<$name<B $(, $n)?>, W> for $name<A $(, $n)?>
        where
            A: crate::system::System<
                Scalar: crate::scheme::by_lane::ByLane<B::Scalar, W>,
                Vector: crate::scheme::by_lane::ByLane<B::Vector, W>,
                Sum: crate::scheme::by_lane::ByLane<B::Sum, W>,
                Work: crate::scheme::by_lane::ByLane<B::Work, W>,
            > $(+ crate::system::$system<$more: crate::scheme::by_lane::ByLane<B::$more, W>>)?,
            B: crate::system::System<Work: Default> $(+ crate::system::$system)?,
        {
            fn alike(one: &$name<B $(, $n)?>) -> Self {
                $name {
                    $($field: crate::scheme::by_lane::ByLane::alike(&one.$field),)*
                    $($($sum: crate::scheme::by_lane::ByLane::alike(&one.$sum),)*)?
                    $($($same: one.$same,)*)?
                    $($($new: Default::default(),)*)?
                }
            }
            fn lane(&self, lane: usize) -> $name<B $(, $n)?> {
                $name {
                    $($field: crate::scheme::by_lane::ByLane::lane(&self.$field, lane),)*
                    $($($sum: crate::scheme::by_lane::ByLane::lane(&self.$sum, lane),)*)?
                    $($($same: self.$same,)*)?
                    $($($new: Default::default(),)*)?
                }
            }
            fn set(&mut self, lane: usize, one: &$name<B $(, $n)?>) {
                $(crate::scheme::by_lane::ByLane::set(&mut self.$field, lane, &one.$field);)*
                $($(crate::scheme::by_lane::ByLane::set(&mut self.$sum, lane, &one.$sum);)*)?
            }
            #[inline(always)]
            fn put(&mut self, which: dmech_scalar::RowsMask<W>, other: &Self) {
                $(crate::scheme::by_lane::ByLane::put(&mut self.$field, which, &other.$field);)*
                $($({
                    let none = crate::scheme::by_lane::ByLane::alike(&B::Work::default());
                    crate::scheme::by_lane::ByLane::put(&mut self.$sum, which, &none);
                })*)?
            }
        }
    )*};
}

pub(crate) use by_lane;
