//! `two_sum` is exact; compensated sums keep the bound that they state, where plain sums drift.

use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;
use dmech_scalar::{Compensated, CompensatedVector, DoubleDouble, Real, two_sum};
use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};
use std::cell::Cell;

type Big = FBig<HalfEven, 2>;

/// The very value of x; sums and products of such numbers are exact.
fn exact(x: f64) -> Big {
    Big::try_from(x).expect("a finite number").with_precision(0).value()
}

/// m·2ᵉ with e in a range narrow enough for the two numbers of a pair to overlap often.
fn overlapping() -> impl Strategy<Value = f64> + Clone {
    (-(1i64 << 53)..(1i64 << 53), -70..70).prop_map(|(m, e)| m as f64 * 2f64.powi(e))
}

fn anything() -> impl Strategy<Value = f64> + Clone {
    use proptest::num::f64::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
    POSITIVE | NEGATIVE | NORMAL | SUBNORMAL | ZERO
}

fn assert_exact_for(numbers: impl Strategy<Value = f64> + Clone, needed: u32) {
    let rounded = Cell::new(0);
    let mut runner = TestRunner::new(Config { failure_persistence: None, ..Config::with_cases(20_000) });
    runner
        .run(&(numbers.clone(), numbers), |(a, b)| {
            prop_assume!((a + b).is_finite());
            let (sum, error) = two_sum(a, b);
            prop_assert_eq!(sum, a + b);
            prop_assert!(exact(sum) + exact(error) == exact(a) + exact(b), "{:e} + {:e}", a, b);
            prop_assert_eq!(two_sum(b, a), (sum, error));
            rounded.set(rounded.get() + u32::from(error != 0.0 && error.abs() != a.abs().min(b.abs())));
            Ok(())
        })
        .expect("two_sum is exact");
    println!("{} sums were rounded in the middle of both", rounded.get());
    assert!(rounded.get() >= needed, "only {} sums had something to compensate", rounded.get());
}

#[test]
fn two_sum_is_exact_where_the_digits_overlap() {
    assert_exact_for(overlapping(), 5000);
}

#[test]
fn two_sum_is_exact_over_the_whole_range() {
    assert_exact_for(anything(), 100);
}

#[test]
fn two_sum_is_exact_in_single_precision() {
    let rounded = Cell::new(0);
    let mut runner = TestRunner::new(Config { failure_persistence: None, ..Config::with_cases(20_000) });
    runner
        .run(&(overlapping(), overlapping()), |(a, b)| {
            let (a, b) = ((a * 2f64.powi(-53)) as f32, (b * 2f64.powi(-53)) as f32);
            let (sum, error) = two_sum(a, b);
            prop_assert_eq!(sum, a + b);
            let (a, b) = (exact(a.into()), exact(b.into()));
            prop_assert!(exact(sum.into()) + exact(error.into()) == a + b);
            rounded.set(rounded.get() + u32::from(error != 0.0));
            Ok(())
        })
        .expect("two_sum is exact");
    assert!(rounded.get() > 5000);
}

/// a/b in two parts: what is left of a is at most 2⁻⁵² of it, as 1/b and the quotient are rounded, and is rounded three times: as it is
/// formed, for it may have 54 digits, by 1/b, and in the product.
fn quotient_in_two_parts(a: f64, b: f64) -> Result<(), TestCaseError> {
    let (quotient, rest) = a.quotient(b, b.recip());
    prop_assert!((quotient - a / b).abs() <= 2f64.powi(-52) * (a / b).abs());
    let missing = ((exact(quotient) + exact(rest)) * exact(b) - exact(a)).to_f64().value();
    prop_assert!(missing.abs() <= 3.0 * 2f64.powi(-105) * a.abs(), "{:e} / {:e}: {:e}", a, b, missing);
    Ok(())
}

/// Products with what they leave out are exact, quotients to the rounding of that.
#[test]
fn products_and_quotients_in_two_parts() {
    quotient_in_two_parts(-2690224769959939.0, 8872646385988035.0).unwrap();
    let (left, mut runner) =
        (Cell::new(0), TestRunner::new(Config { failure_persistence: None, ..Config::with_cases(20_000) }));
    runner
        .run(&(overlapping(), overlapping()), |(a, b)| {
            let (product, rest) = a.product(b);
            prop_assert_eq!(product, a * b);
            prop_assert!(exact(product) + exact(rest) == exact(a) * exact(b), "{:e} · {:e}", a, b);
            left.set(left.get() + u32::from(rest != 0.0));
            prop_assume!(b != 0.0);
            quotient_in_two_parts(a, b)
        })
        .expect("products and quotients in two parts");
    assert!(left.get() > 5000);
}

/// In `f32` what is left can be told in `f64`, where the product is exact.
#[test]
fn products_in_two_parts_of_other_scalars() {
    let mut inexact = 0;
    for k in 1..1000_u16 {
        let (x, y) = (0.37_f32 * f32::from(k), 1.3_f32 / f32::from(k) + 0.01);
        let (product, rest) = x.product(y);
        assert_eq!(f64::from(product) + f64::from(rest), f64::from(x) * f64::from(y));
        inexact += u32::from(rest != 0.0);
        let (quotient, rest) = x.quotient(y, y.recip());
        let missing = (f64::from(quotient) + f64::from(rest)) * f64::from(y) - f64::from(x);
        assert!(missing.abs() <= 2f64.powi(-46) * f64::from(x), "{x:e} / {y:e}: {missing:e}");
    }
    assert!(inexact > 900);
    let [x, y] = [[0.37, 3.0], [1.3, 7.0]].map(|x| x.map(DoubleDouble::from)).map(|[a, b]| a / b);
    let ((product, rest), (quotient, left)) = (x.product(y), x.quotient(y, y.recip()));
    assert!(
        product == x * y
            && (quotient - x / y).abs() <= DoubleDouble::from(2.0 * DoubleDouble::EPSILON.to_f64()) * quotient
            && left != DoubleDouble::ZERO
    );
    let ulp = DoubleDouble::EPSILON.to_f64();
    assert!(rest.to_f64().abs() < 2.0 * ulp * product.to_f64() && left.to_f64().abs() < 8.0 * ulp * quotient.to_f64());
}

/// The bound of the documentation, for increments of any sign and of sizes from 1e-9 to 1e3.
#[test]
fn a_compensated_sum_keeps_its_bound() {
    let increments = prop::collection::vec((-1.0..1.0, -9.0..3.0), 1..400);
    let (plain_was_worse, checked) = (Cell::new(0), Cell::new(0));
    let mut runner = TestRunner::new(Config { failure_persistence: None, ..Config::with_cases(500) });
    runner
        .run(&(-1e3..1e3, increments), |(start, increments)| {
            let (mut sum, mut plain, mut total) = (Compensated::new(start), start, exact(start));
            let (mut length, mut largest, n) = (0.0, f64::abs(start), increments.len() as f64);
            for (m, e) in increments {
                let dx = m * f64::powf(10.0, e);
                sum.add(dx);
                plain += dx;
                total += exact(dx);
                length += dx.abs();
                largest = largest.max(sum.value().abs());
            }
            let error = |s: Big| (s - &total).to_f64().value().abs();
            let bound = f64::EPSILON * (length / 2.0 + n * f64::EPSILON * largest / 4.0);
            prop_assert!(error(exact(sum.hi) + exact(sum.lo)) <= bound);
            prop_assert_eq!(sum.hi + sum.lo, sum.hi);
            checked.set(checked.get() + 1);
            plain_was_worse.set(plain_was_worse.get() + u32::from(error(exact(plain)) > bound));
            Ok(())
        })
        .expect("the bound holds");
    println!("plain addition exceeds the bound in {} of {}", plain_was_worse.get(), checked.get());
    assert_eq!(checked.get(), 500);
    assert!(plain_was_worse.get() > 100, "{}", plain_was_worse.get());
}

/// A million steps of a circle, component by component: no drift, where plain addition loses tens of ulps.
#[test]
fn a_million_small_steps_do_not_drift() {
    let n = 1_000_000;
    let start = [3.7, -1.9];
    let mut q = CompensatedVector::new(start);
    let mut single = [Compensated::new(start[0]), Compensated::new(start[1])];
    let mut plain = start;
    let mut total = start.map(exact);
    for k in 0..n {
        let angle = 0.0137 * k as f64;
        let dq = [1e-4 + 1e-3 * angle.cos(), -2e-4 + 1e-3 * angle.sin()];
        q.add(dq);
        for i in 0..2 {
            single[i].add(dq[i]);
            plain[i] += dq[i];
            total[i] += exact(dq[i]);
        }
    }
    for i in 0..2 {
        let ulps = |x: f64| (exact(x) - &total[i]).to_f64().value().abs() / (x.abs().next_up() - x.abs());
        println!("component {i}: compensated {:.2} ulp, plain {:.1} ulp", ulps(q.value()[i]), ulps(plain[i]));
        assert!(ulps(q.value()[i]) <= 1.0 && ulps(plain[i]) > 20.0);
        assert_eq!((q.hi[i], q.lo[i]), (single[i].hi, single[i].lo));
    }
}
