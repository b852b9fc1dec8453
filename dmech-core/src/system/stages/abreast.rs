//! Coordinates side by side: for what a step does once with each of them.

use core::ops::Range;

use dmech_scalar::{Lanes, Real};

use super::{Eight, Row, STAGES, Staging, times};

/// Coordinates that are computed at a time: one [singly](Singly), or eight [side by side](ByEight).
pub trait Abreast<R: Staging> {
    /// A number of each.
    type Number: Staging;
    /// How many there are.
    const WIDTH: usize;

    /// The same number for each.
    fn alike(x: R) -> Self::Number;
    /// Those from `at` on.
    fn gather(numbers: &[R], at: usize) -> Self::Number;
    /// Puts them back.
    fn scatter(x: Self::Number, numbers: &mut [R], at: usize);
    /// For each from `at` on, the sum of its eight numbers times coefficients, and that of the numbers.
    fn sums(coefficients: &Row, eights: &[R::Eight], at: usize) -> [Self::Number; 2];
    /// For each, the largest of the eight.
    fn largest(eights: &[R::Eight], at: usize) -> Self::Number;
    /// The largest of all that are computed at a time.
    fn largest_number(x: Self::Number) -> R;
}

/// One coordinate.
#[derive(Clone, Copy, Debug)]
pub struct Singly;

/// Eight coordinates in the lanes of a register, with zeros where there are fewer.
#[derive(Clone, Copy, Debug)]
pub struct ByEight;

/// So many coordinates are computed one by one: to fill a register with zeros for them takes longer.
const FEW: usize = 2;

/// Of n coordinates those that are computed together, and those that are left.
#[inline(always)]
pub(super) fn divided<R: Staging>(n: usize) -> [Range<usize>; 2] {
    let rest = if R::Coordinates::WIDTH == 1 { n } else { n % R::Coordinates::WIDTH };
    let together = if rest <= FEW { n - rest } else { n };
    [0..together, together..n]
}

/// `abreast!(R, n, f(x, y))` is `f::<R, R::Coordinates>(at, x, y)` for all of n coordinates that are computed together and
/// `f::<R, Singly>(at, x, y)` for the rest: two loops, so that the numbers of each are known.
macro_rules! abreast {
    ($real:ident, $n:expr, $each:ident($($argument:expr),*)) => {{
        let [together, rest] = $crate::system::stages::abreast::divided::<$real>($n);
        for at in together.step_by(<$real::Coordinates as $crate::system::stages::abreast::Abreast<$real>>::WIDTH) {
            $each::<$real, $real::Coordinates>(at, $($argument),*);
        }
        for at in rest {
            $each::<$real, $crate::system::stages::abreast::Singly>(at, $($argument),*);
        }
    }};
}
pub(super) use abreast;

/// The largest of numbers, 0 or more.
#[inline(always)]
pub(super) fn largest_number<R: Staging>(numbers: &[R]) -> R {
    let [together, rest] = divided::<R>(numbers.len());
    let mut of_each = R::Coordinates::alike(R::ZERO);
    for at in together.step_by(R::Coordinates::WIDTH) {
        of_each = of_each.larger_number(R::Coordinates::gather(numbers, at));
    }
    rest.fold(R::Coordinates::largest_number(of_each), |largest, at| largest.larger_number(numbers[at]))
}

impl<R: Staging> Abreast<R> for Singly {
    type Number = R;
    const WIDTH: usize = 1;

    #[inline(always)]
    fn alike(x: R) -> R {
        x
    }
    #[inline(always)]
    fn gather(numbers: &[R], at: usize) -> R {
        numbers[at]
    }
    #[inline(always)]
    fn scatter(x: R, numbers: &mut [R], at: usize) {
        numbers[at] = x;
    }
    #[inline(always)]
    fn sums(coefficients: &Row, eights: &[R::Eight], at: usize) -> [R; 2] {
        [times(coefficients, &eights[at]).sum(), eights[at].sum()]
    }
    #[inline(always)]
    fn largest(eights: &[R::Eight], at: usize) -> R {
        super::largest_of::<R>(&eights[at..=at])
    }
    #[inline(always)]
    fn largest_number(x: R) -> R {
        x
    }
}

/// Eight registers from `at` on, zeros where there are fewer.
#[inline(always)]
fn from(registers: &[Lanes], at: usize) -> [Lanes; STAGES] {
    if let Some((here, _)) = registers[at..].split_first_chunk() {
        return *here;
    }
    let mut here = [Lanes::ZERO; STAGES];
    for k in 0..STAGES {
        if at + k < registers.len() {
            here[k] = registers[at + k];
        }
    }
    here
}

impl Abreast<f64> for ByEight {
    type Number = Lanes;
    const WIDTH: usize = Lanes::COUNT;

    #[inline(always)]
    fn alike(x: f64) -> Lanes {
        Lanes::splat(x)
    }
    #[inline(always)]
    fn gather(numbers: &[f64], at: usize) -> Lanes {
        if at + STAGES <= numbers.len() {
            return Lanes::from_slice(&numbers[at..]);
        }
        let mut here = [0.0; STAGES];
        for k in 0..STAGES {
            if at + k < numbers.len() {
                here[k] = numbers[at + k];
            }
        }
        Lanes::from_array(here)
    }
    #[inline(always)]
    fn scatter(x: Lanes, numbers: &mut [f64], at: usize) {
        if at + STAGES <= numbers.len() {
            return x.store(&mut numbers[at..]);
        }
        let here = x.to_array();
        for k in 0..STAGES {
            if at + k < numbers.len() {
                numbers[at + k] = here[k];
            }
        }
    }
    #[inline(always)]
    fn sums(coefficients: &Row, eights: &[Lanes], at: usize) -> [Lanes; 2] {
        let here = from(eights, at);
        let mut weighed = here;
        for k in 0..STAGES {
            weighed[k] = times(coefficients, &here[k]);
        }
        [Lanes::sums(weighed), Lanes::sums(here)]
    }
    #[inline(always)]
    fn largest(eights: &[Lanes], at: usize) -> Lanes {
        let mut sizes = from(eights, at);
        for size in &mut sizes {
            *size = size.abs();
        }
        Lanes::largest_numbers(sizes)
    }
    #[inline(always)]
    fn largest_number(x: Lanes) -> f64 {
        x.largest_number()
    }
}
