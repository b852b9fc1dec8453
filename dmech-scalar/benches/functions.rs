//! Every function of [`Real`]: the standard library, this crate's for one number and for eight in lanes.
//!
//! `cargo bench -p dmech-scalar --features lanes --bench functions` prints nanoseconds: the best of many short runs. *Waiting*
//! is a call whose argument needs the result of the one before, *in a row* one of many independent calls. The last columns are
//! eight calls of the standard library over one call in lanes, and one call in lanes over one call for one number.

use std::hint::black_box;
use std::time::Instant;

use dmech_scalar::{Lanes, Real};

const COUNT: usize = 1024;
const RUNS: usize = 60;

/// The best of many runs, per call.
fn best(calls: usize, mut run: impl FnMut()) -> f64 {
    let mut best = f64::INFINITY;
    for _ in 0..RUNS {
        let start = Instant::now();
        run();
        best = best.min(start.elapsed().as_nanos() as f64);
    }
    best / calls as f64
}

/// Each call starts when the one before has ended; what that takes without a call is left out.
#[inline(always)]
fn waiting(x: &[f64], f: impl Fn(f64) -> f64) -> f64 {
    let chain = |f: &dyn Fn() -> f64| {
        best(COUNT, || {
            black_box(f());
        })
    };
    let zero = black_box(0.0);
    let with = chain(&|| x.iter().fold(0.0, |last, &x| f(x + zero * last)));
    let without = chain(&|| x.iter().fold(0.0, |last, &x| x + zero * last));
    with - without
}

/// Calls indeed: compilers put functions that have no branch in lanes by themselves, where they see a row of them.
fn in_a_row(x: &[f64], out: &mut [f64], f: fn(f64) -> f64) -> f64 {
    let f = black_box(f);
    best(COUNT, || {
        for (&x, out) in black_box(x).iter().zip(out.iter_mut()) {
            *out = f(x);
        }
        black_box(&out);
    })
}

#[inline(always)]
fn in_lanes(x: &[f64], out: &mut [f64], f: impl Fn(Lanes) -> Lanes) -> f64 {
    best(COUNT / 8, || {
        for (x, out) in black_box(x).chunks_exact(8).zip(out.chunks_exact_mut(8)) {
            f(Lanes::from_slice(x)).store(out);
        }
        black_box(&out);
    })
}

fn arguments(low: f64, high: f64) -> Vec<f64> {
    // An irrational rotation: evenly spread, in no order a branch could be foretold from.
    (0..COUNT)
        .map(|i| low + (high - low) * (i as f64 * 0.618_033_988_749_894_9 + (i * i) as f64 * 0.414_213_562).fract())
        .collect()
}

macro_rules! measure {
    ($only:ident: $($name:ident($low:expr, $high:expr $(, $p:expr)?) = $std:expr;)*) => {$(
        let title = format!("{} {}..{}", stringify!($name), $low, $high);
        if $only.as_ref().is_none_or(|only| title.starts_with(only.as_str())) {
            let x = arguments($low, $high);
            let mut out = vec![0.0; COUNT];
            let (std, own) = ($std, |x: f64| Real::$name(x $(, $p)?));
            let lanes = |x: Lanes| Real::$name(x $(, Lanes::splat($p))?);
            let (a, b) = (waiting(&x, std), waiting(&x, own));
            let (c, d) = (in_a_row(&x, &mut out, std), in_a_row(&x, &mut out, own));
            let e = in_lanes(&x, &mut out, lanes);
            println!(
                "{title:22} waiting {a:6.1} → {b:6.1} ({:4.2})   in a row {c:6.1} → {d:6.1}   lanes {e:6.1}   8 std/lanes {:5.1}   lanes/one {:4.2} (waiting) {:4.2} (in a row) {:4.2} (std in a row)",
                b / a, 8.0 * c / e, e / b, e / d, e / c
            );
        }
    )*};
}

fn main() {
    let only = std::env::args().skip(1).find(|a| !a.starts_with('-'));
    measure! { only:
        sin(-0.5, 0.5) = f64::sin;
        sin(0.0, 0.7) = f64::sin;
        sin(-3.0, 3.0) = f64::sin;
        sin(-100.0, 100.0) = f64::sin;
        cos(-0.5, 0.5) = f64::cos;
        cos(-3.0, 3.0) = f64::cos;
        cos(-100.0, 100.0) = f64::cos;
        tan(-3.0, 3.0) = f64::tan;
        exp(-10.0, 10.0) = f64::exp;
        exp2(-10.0, 10.0) = f64::exp2;
        exp_m1(-2.0, 2.0) = f64::exp_m1;
        ln(0.5, 2.0) = f64::ln;
        ln(0.01, 100.0) = f64::ln;
        ln_1p(-0.5, 2.0) = f64::ln_1p;
        log2(0.01, 100.0) = f64::log2;
        log10(0.01, 100.0) = f64::log10;
        powf(0.01, 100.0, 2.3) = |x| f64::powf(x, 2.3);
        cbrt(0.01, 100.0) = f64::cbrt;
        tanh(-2.0, 2.0) = f64::tanh;
        sinh(-2.0, 2.0) = f64::sinh;
        cosh(-2.0, 2.0) = f64::cosh;
        asin(-1.0, 1.0) = f64::asin;
        acos(-1.0, 1.0) = f64::acos;
        atan(-3.0, 3.0) = f64::atan;
        atan2(-3.0, 3.0, 0.7) = |y| f64::atan2(y, 0.7);
        asinh(-3.0, 3.0) = f64::asinh;
        acosh(1.0, 5.0) = f64::acosh;
        atanh(-0.9, 0.9) = f64::atanh;
        round(-9.0, 9.0) = f64::round;
        floor(-9.0, 9.0) = f64::floor;
        trunc(-9.0, 9.0) = f64::trunc;
        sinc(-3.0, 3.0) = |x| f64::sin(x) / x;
        sinc_slope(-3.0, 3.0) = |x| (f64::cos(x) - f64::sin(x) / x) / x / x;
        sinhc(-3.0, 3.0) = |x| f64::sinh(x) / x;
        sinhc_slope(-3.0, 3.0) = |x| (f64::cosh(x) - f64::sinh(x) / x) / x / x;
        atanc(-3.0, 3.0) = |x| f64::atan(x) / x;
        atanc_slope(-3.0, 3.0) = |x| (1.0 / (1.0 + x * x) - f64::atan(x) / x) / x / x;
        atanhc(-0.9, 0.9) = |x| f64::atanh(x) / x;
        atanhc_slope(-0.9, 0.9) = |x| (1.0 / (1.0 - x * x) - f64::atanh(x) / x) / x / x;
    }
}
