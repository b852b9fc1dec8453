//! Numbers as the `f64` that hold them.

use crate::{DoubleDouble, Real};
#[cfg(feature = "lanes")]
use crate::{Lanes, Rows};

/// A number that is held to the last bit by a few `f64`, its parts: itself, an `f32` in one, a [`DoubleDouble`] in two. So it is written to
/// a table whose columns are `f64`, and told from others.
///
/// ```
/// use dmech_scalar::{DoubleDouble, Exact, Real};
///
/// let third = DoubleDouble::ONE / DoubleDouble::from(3.0);
/// let mut parts = Vec::new();
/// third.parts(&mut |part| parts.push(part));
/// assert_eq!(parts, [third.hi(), third.lo()]);
/// let mut parts = parts.into_iter();
/// assert_eq!(DoubleDouble::of_parts(&mut || parts.next().unwrap()), third);
/// ```
#[diagnostic::on_unimplemented(
    message = "it is not known which `f64` hold a number of `{Self}`",
    label = "such numbers are neither written to tables nor told from others to the last bit",
    note = "`Exact` says it: implement it for `{Self}`"
)]
pub trait Exact: Real {
    /// How many parts a number has.
    const PARTS: usize;

    /// The name of these numbers.
    fn name() -> String;

    /// What the n-th part has behind the name of its number.
    fn part(n: usize) -> String;

    /// Shows the parts.
    fn parts(self, see: &mut dyn FnMut(f64));

    /// The number of these parts, which come in the same order.
    fn of_parts(next: &mut dyn FnMut() -> f64) -> Self;
}

/// Every `f32` is an `f64`.
macro_rules! is_its_part {
    ($($real:ident)*) => {$(
        impl Exact for $real {
            const PARTS: usize = 1;

            fn name() -> String {
                stringify!($real).to_owned()
            }

            fn part(_: usize) -> String {
                String::new()
            }

            #[inline]
            fn parts(self, see: &mut dyn FnMut(f64)) {
                see(self.into());
            }

            #[inline]
            fn of_parts(next: &mut dyn FnMut() -> f64) -> Self {
                next() as $real
            }
        }
    )*};
}

is_its_part! { f64 f32 }

/// hi as the number itself, lo behind it.
impl Exact for DoubleDouble {
    const PARTS: usize = 2;

    fn name() -> String {
        "DoubleDouble".to_owned()
    }

    fn part(n: usize) -> String {
        if n == 0 { String::new() } else { "_low".to_owned() }
    }

    fn parts(self, see: &mut dyn FnMut(f64)) {
        see(self.hi());
        see(self.lo());
    }

    fn of_parts(next: &mut dyn FnMut() -> f64) -> Self {
        let hi = next();
        // Not as a sum, which has no −0.
        DoubleDouble::pair(hi, next())
    }
}

#[cfg(feature = "lanes")]
impl Exact for Lanes {
    const PARTS: usize = Lanes::COUNT;

    fn name() -> String {
        "Lanes".to_owned()
    }

    fn part(n: usize) -> String {
        format!("_lane{n}")
    }

    fn parts(self, see: &mut dyn FnMut(f64)) {
        self.to_array().into_iter().for_each(see);
    }

    fn of_parts(next: &mut dyn FnMut() -> f64) -> Self {
        Lanes::from_fn(|_| next())
    }
}

#[cfg(feature = "lanes")]
impl<const N: usize> Exact for Rows<N> {
    const PARTS: usize = Rows::<N>::COUNT;

    fn name() -> String {
        format!("Rows<{N}>")
    }

    fn part(n: usize) -> String {
        Lanes::part(n)
    }

    fn parts(self, see: &mut dyn FnMut(f64)) {
        (0..Self::COUNT).for_each(|lane| see(self[lane]));
    }

    fn of_parts(next: &mut dyn FnMut() -> f64) -> Self {
        Rows::from_fn(|_| next())
    }
}
