//! `Real` for `f64` and `f32`: each method is the function it is named for.

mod exact;
mod ulps;

use dashu_float::ops::CubicRoot;
use dmech_scalar::{Mask, Real};
use exact::{Big, big};
use ulps::error_in_ulps;

/// The method in both precisions, with 120 digits, and where it is defined.
struct Elementary {
    name: &'static str,
    double: fn(f64) -> f64,
    single: fn(f32) -> f32,
    exact: fn(&Big) -> Big,
    domain: (f64, f64),
}

macro_rules! elementary {
    ($name:ident, $low:expr, $high:expr, $exact:expr) => {
        Elementary {
            name: stringify!($name),
            double: <f64 as Real>::$name,
            single: <f32 as Real>::$name,
            exact: $exact,
            domain: ($low, $high),
        }
    };
}

const ELEMENTARY: [Elementary; 23] = [
    elementary!(recip, -7.0, 9.0, |x| big(1.0) / x),
    elementary!(abs, -7.0, 9.0, |x| if *x < big(0.0) { -x.clone() } else { x.clone() }),
    elementary!(sqrt, 0.0, 9.0, |x| x.sqrt()),
    elementary!(cbrt, -7.0, 9.0, |x| x.cbrt()),
    elementary!(exp, -7.0, 9.0, |x| x.exp()),
    elementary!(exp2, -7.0, 9.0, |x| (x * big(2.0).ln()).exp()),
    elementary!(exp_m1, -7.0, 9.0, |x| x.exp() - big(1.0)),
    elementary!(ln, 1e-3, 9.0, |x| x.ln()),
    elementary!(ln_1p, -0.999, 9.0, |x| (x + big(1.0)).ln()),
    elementary!(log2, 1e-3, 9.0, |x| x.ln() / big(2.0).ln()),
    elementary!(log10, 1e-3, 9.0, |x| x.ln() / big(10.0).ln()),
    elementary!(sin, -7.0, 9.0, |x| x.sin()),
    elementary!(cos, -7.0, 9.0, |x| x.cos()),
    elementary!(tan, -7.0, 9.0, |x| x.tan()),
    elementary!(asin, -1.0, 1.0, |x| x.asin()),
    elementary!(acos, -1.0, 1.0, |x| x.acos()),
    elementary!(atan, -7.0, 9.0, |x| x.atan()),
    elementary!(sinh, -7.0, 9.0, |x| x.sinh()),
    elementary!(cosh, -7.0, 9.0, |x| x.cosh()),
    elementary!(tanh, -7.0, 9.0, |x| x.tanh()),
    elementary!(asinh, -7.0, 9.0, |x| x.asinh()),
    elementary!(acosh, 1.0, 9.0, |x| x.acosh()),
    elementary!(atanh, -0.999, 0.999, |x| x.atanh()),
];

/// Two ulps in double precision; in single precision the standard library composes some of them in `f32`.
#[test]
fn each_method_is_its_function() {
    for f in &ELEMENTARY {
        let (low, high) = f.domain;
        let (mut worst, mut worst_single, mut inexact) = ((0.0, 0.0), 0.0_f64, 0);
        // Evenly over the domain, and towards either end.
        let inner = (0..400).map(|k| low + (high - low) * (f64::from(k) + 0.37) / 400.0);
        let ends = (1..50).flat_map(|k| [low, high].map(|end| end + (0.5 * (low + high) - end) * 0.7f64.powi(k)));
        for x in inner.chain(ends) {
            let value = (f.exact)(&big(x));
            let error = error_in_ulps((f.double)(x), &value, value.to_f64().value());
            inexact += u32::from(error > 0.0);
            if error > worst.0 {
                worst = (error, x);
            }
            let y = x as f32;
            if !(low..=high).contains(&y.into()) {
                continue;
            }
            let value = (f.exact)(&big(y.into())).to_f64().value() as f32;
            let last_place = value.abs().next_up() - value.abs();
            worst_single = worst_single.max(f64::from(((f.single)(y) - value).abs() / last_place));
        }
        println!("{:>6}: {:.2} ulp at {:e}, f32 {worst_single:.2}", f.name, worst.0, worst.1);
        assert!(worst.0 <= 2.0 && worst_single <= 4.0, "{}: {worst:?} {worst_single}", f.name);
        assert!(inexact > 300 || f.name == "abs", "{}: {inexact} values to judge by", f.name);
    }
}

/// The rest of the trait, for one type.
macro_rules! laws_of {
    ($real:ident) => {
        #[test]
        fn $real() {
            let (a, b): ($real, $real) = (1.3, -0.7);
            assert_eq!(($real::ZERO, $real::ONE, $real::EPSILON), (0.0, 1.0, $real::EPSILON));
            assert_eq!($real::ONE + $real::EPSILON, $real::ONE.next_up());
            assert_eq!((<$real as Real>::from_f64(0.1), a.to_f64()), (0.1, f64::from(a)));

            assert!(b.less(a) && !a.less(a) && !a.less(b));
            assert!(b.less_or_equal(a) && a.less_or_equal(a) && !a.less_or_equal(b));
            assert!(a.equal(a) && !a.equal(b) && !$real::NAN.equal($real::NAN));
            assert!(a.finite() && !$real::INFINITY.finite() && !$real::NAN.finite());

            assert_eq!(Real::signum(-0.0 as $real), -1.0);
            assert_eq!((Real::signum(0.0 as $real), Real::signum(a), Real::signum(b)), (1.0, 1.0, -1.0));
            assert_eq!(
                (Real::round(b), Real::floor(b), Real::trunc(b), Real::round(2.5 as $real)),
                (-1.0, -1.0, 0.0, 3.0)
            );
            assert_eq!((Real::min(a, b), Real::max(a, b)), (b, a));
            assert_eq!(Real::powi(b, 3), b * b * b);
            assert!((Real::powf(a, b) - (b * a.ln()).exp()).abs() < 2.0 * $real::EPSILON);
            assert!(
                (Real::atan2(a, b) - (std::f64::consts::PI as $real + (a / b).atan())).abs() < 4.0 * $real::EPSILON
            );

            // One branch only.
            assert_eq!(Real::select(true, || a, || unreachable!()), a);
            assert_eq!(Real::select(false, || unreachable!(), || b), b);

            // Fused, the product is not rounded: what is left is its rounding error, not 0.
            let rounding = Real::mul_add(a, a, -(a * a));
            let fused = cfg!(any(target_feature = "fma", target_arch = "aarch64"));
            assert_eq!(rounding != 0.0, fused, "{rounding:e}");
            assert_eq!(Real::mul_add(2.0 as $real, 3.0, 4.0), 10.0);
        }
    };
}

mod laws {
    use super::*;
    laws_of!(f64);
    laws_of!(f32);
}

#[test]
fn a_single_mask_is_a_bool() {
    for a in [false, true] {
        assert_eq!((a.all(), a.any(), Mask::not(a)), (a, a, !a));
        for b in [false, true] {
            assert_eq!((a.and(b), a.or(b)), (a && b, a || b));
        }
    }
}
