//! The sets of stages against every order condition, and the predictor against motions that it must follow exactly.
//!
//! A symmetric scheme of order 2 is Φ_h = exp(h Y₁ + h³ Y₃ + h⁵ Y₅ + …), where Y₁ is the motion and the other Yᵢ, the
//! local errors, are any vector fields. Its composition has order p when Π exp(Σ γ_kⁱ hⁱ Yᵢ) = exp(h Y₁) up to h^p as
//! a series in letters Yᵢ that do not commute: for each word of weight ≤ p there is one condition.

use core::array::from_fn;

use dmech_scalar::{DoubleDouble, Real};

use super::coefficients::*;
use super::{Coefficients, digits};

/// A word of letters Yᵢ, i = 1, 3, 5, …; its weight is Σ i.
type Word = Vec<u32>;

/// Words up to a weight, shorter ones first.
fn words(weight: u32) -> Vec<Word> {
    let mut all = vec![Word::new()];
    let mut next = 0;
    while next < all.len() {
        let word = all[next].clone();
        let left = weight - word.iter().sum::<u32>();
        all.extend((1..=left).step_by(2).map(|i| [word.as_slice(), &[i]].concat()));
        next += 1;
    }
    all
}

fn factorial<R: Real>(n: usize) -> R {
    (1..=n).fold(R::ONE, |product, i| product * R::from_f64(i as f64))
}

/// The coefficients of Π exp(Σ γ_kⁱ Yᵢ), in the order of `words`.
fn product<R: Real>(gamma: &[R], words: &[Word]) -> Vec<R> {
    let index = |part: &[u32]| words.iter().position(|word| word == part).expect("parts of words are words");
    let splits: Vec<Vec<(usize, usize)>> =
        words.iter().map(|word| (0..=word.len()).map(|i| (index(&word[..i]), index(&word[i..]))).collect()).collect();
    let mut all: Vec<R> = words.iter().map(|word| if word.is_empty() { R::ONE } else { R::ZERO }).collect();
    for &x in gamma {
        let one: Vec<R> =
            words.iter().map(|word| x.powi(word.iter().sum::<u32>() as i32) / factorial(word.len())).collect();
        let sum = |split: &Vec<(usize, usize)>| split.iter().fold(R::ZERO, |sum, &(i, j)| sum + all[i] * one[j]);
        all = splits.iter().map(sum).collect();
    }
    all
}

/// The largest violation of a condition of weight up to the order, in units of what rounding leaves of the sums, and the
/// largest of the next weight.
fn violations<C: Coefficients<N>, R: Real, const N: usize>() -> (f64, f64) {
    let words = words(C::ORDER + 1);
    let gamma: [R; N] = from_fn(|k| digits(C::GAMMA[k], C::LOW[k]));
    let found = product(&gamma, &words);
    let sizes = product(&gamma.map(R::abs), &words);
    let (mut worst, mut beyond) = (0.0_f64, 0.0_f64);
    for ((word, found), size) in words.iter().zip(found).zip(sizes) {
        let motion = if word.iter().all(|&i| i == 1) { factorial::<R>(word.len()).recip() } else { R::ZERO };
        let violation = (found - motion).abs().to_f64();
        if word.iter().sum::<u32>() <= C::ORDER {
            worst = worst.max(violation / (R::EPSILON * size).to_f64());
        } else {
            beyond = beyond.max(violation);
        }
    }
    println!("{:<22} {N:>2} stages: {worst:.1} units of rounding, {beyond:.1e} beyond", C::NAME);
    (worst, beyond)
}

/// Runs a macro for every set.
macro_rules! for_each_set {
    ($run:ident) => {
        $run! { TripleJump4 Suzuki4 Suzuki4S7 McLachlan4 Yoshida6 McLachlan6 KahanLi6 SofroniouSpaletta6S11 SofroniouSpaletta6 Yoshida8
        SuzukiUmeno8 McLachlan8 KahanLi8 Morales8 SofroniouSpaletta8 }
    };
}

#[test]
fn every_set_satisfies_the_conditions_of_its_order_and_no_more() {
    assert_eq!(words(8).iter().filter(|word| word.iter().sum::<u32>() == 8).count(), 21);
    macro_rules! check {
        ($($set:ident)*) => { $({
            let (worst, beyond) = violations::<$set, f64, _>();
            // Half a unit for each of the digits that were rounded, as often as they are multiplied.
            assert!(worst < 4.0, "{}: {worst}", $set::NAME);
            assert!(beyond > 1e-5, "{}: {beyond:e}, so its order is higher", $set::NAME);
            assert!($set::GAMMA.iter().eq($set::GAMMA.iter().rev()), "{} is no palindrome", $set::NAME);
        })* };
    }
    for_each_set!(check);
}

/// The sets that are taken by default have 31 digits.
#[test]
fn the_default_sets_satisfy_the_conditions_to_all_digits() {
    let all = [
        violations::<Suzuki4, DoubleDouble, _>().0,
        violations::<Suzuki4S7, DoubleDouble, _>().0,
        violations::<SofroniouSpaletta6, DoubleDouble, _>().0,
        violations::<SofroniouSpaletta8, DoubleDouble, _>().0,
    ];
    assert!(all.iter().all(|&worst| worst < 8.0), "{all:?}");
    // Others have those of `f64`.
    assert!(violations::<KahanLi8, DoubleDouble, _>().0 > 1e12);
}

/// One wrong digit in the 12th place is seen.
#[test]
fn a_wrong_digit_is_noticed() {
    #[derive(Clone, Copy, Debug)]
    struct Slip;
    impl Coefficients<9> for Slip {
        const NAME: &'static str = "Slip";
        const ORDER: u32 = 6;
        const GAMMA: [f64; 9] = {
            let mut gamma = KahanLi6::GAMMA;
            gamma[3] += 1e-12;
            gamma[5] += 1e-12;
            gamma[4] -= 2e-12;
            gamma
        };
    }
    assert!(violations::<Slip, f64, _>().0 > 100.0);
}
