//! Double-double numbers where they are infinite, not a number, equal in their high parts or large.

use dmech_scalar::{Compensated, DoubleDouble, Real, two_sum};

/// Where `f64` gives an infinity, a NaN or an exact zero, so do double-double numbers, with nothing in their low part.
#[test]
fn what_is_not_finite_is_what_it_is_in_f64() {
    // f64::MAX itself is too much for the standard library's arsinh.
    let edges =
        [0.0, -0.0, 1.0, -1.0, 2.0, -2.0, 1e-310, 1e300, -1e300, 8e307, f64::INFINITY, -f64::INFINITY, f64::NAN];
    macro_rules! both {
        ($($name:ident)*) => { [$((stringify!($name), DoubleDouble::$name as fn(DoubleDouble) -> DoubleDouble, <f64 as Real>::$name as fn(f64) -> f64)),*] };
    }
    let functions = both!(
        recip abs signum round floor trunc sqrt cbrt exp exp2 exp_m1 ln ln_1p log2 log10 sin cos tan asin acos atan sinh cosh tanh asinh
        acosh atanh sinc sinc_slope sinhc sinhc_slope atanc atanc_slope atanhc atanhc_slope
    );
    let mut checked = 0;
    let mut agree = |name: &str, x: &[f64], double: DoubleDouble, plain: f64| {
        assert_eq!(double.hi().is_nan(), plain.is_nan(), "{name} {x:?}: {double:?}, {plain:e}");
        if plain.is_infinite() || double.hi().is_infinite() {
            assert_eq!(double.hi(), plain, "{name} {x:?}");
        }
        assert_eq!(double.finite(), plain.is_finite());
        if !double.finite() {
            assert_eq!(double.lo(), 0.0, "{name} {x:?}");
            checked += 1;
        }
        if plain == 0.0 {
            assert!(double.hi().abs() < 1e-300, "{name} {x:?}: {double:?}");
        }
        assert!(double.lo().abs() <= 0.5 * (double.hi().abs().next_up() - double.hi().abs()) || !double.finite());
    };
    for x in edges {
        for (name, double, plain) in functions {
            agree(name, &[x], double(x.into()), plain(x));
        }
        for y in edges {
            let (a, b) = (DoubleDouble::from(x), DoubleDouble::from(y));
            agree("+", &[x, y], a + b, x + y);
            agree("−", &[x, y], a - b, x - y);
            agree("×", &[x, y], a * b, x * y);
            agree("÷", &[x, y], a / b, x / y);
            agree("min", &[x, y], Real::min(a, b), Real::min(x, y));
            agree("max", &[x, y], Real::max(a, b), Real::max(x, y));
            agree("atan2", &[x, y], Real::atan2(a, b), Real::atan2(x, y));
            agree("powf", &[x, y], a.powf(b), x.powf(y));
            assert_eq!((a.less(b), a.less_or_equal(b), a.equal(b)), (x < y, x <= y, x == y));
        }
        agree("powi", &[x], DoubleDouble::from(x).powi(-3), x.powi(-3));
    }
    assert!(checked > 200);
}

#[test]
fn the_low_part_decides_where_the_high_parts_are_equal() {
    let (less, more) = (DoubleDouble::new(1.0, -1e-20), DoubleDouble::new(1.0, 1e-20));
    assert!(less.less(more) && less.less_or_equal(more) && !more.less(less) && !less.equal(more));
    assert_eq!((Real::min(less, more), Real::max(less, more)), (less, more));
    assert_eq!(less + more, DoubleDouble::from(2.0));
    assert_eq!(DoubleDouble::new(1e-20, 1.0), more);
    // ε is the smallest number that counts beside 1, but for what lo can hold besides.
    let one = DoubleDouble::ONE;
    assert_eq!(DoubleDouble::EPSILON.to_f64(), 2f64.powi(-104));
    assert!(one.less(one + DoubleDouble::EPSILON));
}

/// Angles beyond 2⁵⁰ have the digits of `f64`, and are never outside of ±1.
#[test]
fn large_angles_keep_the_accuracy_of_f64() {
    for x in [1.2e15, 1e22, 1e100, 1e300, f64::MAX] {
        for x in [x, -x] {
            let y = DoubleDouble::from(x);
            assert!((y.sin().hi() - x.sin()).abs() <= f64::EPSILON && (y.cos().hi() - x.cos()).abs() <= f64::EPSILON);
        }
    }
}

/// Compensated sums are made for scalars that round once. Of these the sum of two parts is what plain addition gives, and no
/// less accurate.
#[test]
fn compensated_sums_do_no_harm() {
    let tenth: DoubleDouble = "0.1".parse().unwrap();
    let (mut plain, mut sum) = (DoubleDouble::ZERO, Compensated::new(DoubleDouble::ZERO));
    for _ in 0..10_000 {
        plain += tenth;
        sum.add(tenth);
    }
    let errors = [plain, sum.value() + sum.lo].map(|x| (x.to_f64() - 1000.0 + x.lo()).abs());
    assert!(errors[1] <= errors[0] && errors[0] < 1e-27 && sum.lo.to_f64().abs() < 1e-27, "{errors:?}");
    let (high, low) = two_sum(DoubleDouble::from(1e300), tenth);
    assert!(high.to_f64() == 1e300 && (high + low - DoubleDouble::from(1e300)).to_f64().abs() <= 0.1);
}

/// Steps beside which the high part says nothing: the low part tells on which side a number is.
#[test]
fn steps_see_the_low_part() {
    let tiny = 2f64.powi(-70);
    for (hi, lo, round, floor, trunc) in [
        (0.5, -tiny, 0.0, 0.0, 0.0),
        (0.5, 0.0, 1.0, 0.0, 0.0),
        (-0.5, tiny, 0.0, -1.0, 0.0),
        (-0.5, 0.0, -1.0, -1.0, 0.0),
        (-2.5, 0.0, -3.0, -3.0, -2.0),
        (1.0, -tiny, 1.0, 0.0, 0.0),
        (-1.0, tiny, -1.0, -1.0, 0.0),
        (-1.0, -tiny, -1.0, -2.0, -1.0),
        (7.25, tiny, 7.0, 7.0, 7.0),
    ] {
        let x = DoubleDouble::new(hi, lo);
        assert_eq!([x.round(), x.floor(), x.trunc()], [round, floor, trunc].map(DoubleDouble::from), "{hi} + {lo:e}");
    }
    // Whole numbers beyond 2⁵³ with a part of their own below.
    let large = DoubleDouble::new(2f64.powi(60), 0.75);
    assert_eq!(large.floor(), DoubleDouble::new(2f64.powi(60), 0.0));
    assert_eq!(large.round(), DoubleDouble::new(2f64.powi(60), 1.0));
    assert_eq!((-large).floor(), DoubleDouble::new(-2f64.powi(60), -1.0));
}
